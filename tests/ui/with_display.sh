#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# with_display.sh WIDTHxHEIGHT COMMAND [ARGUMENT..]: runs a command on an X server of its own.
#
# xvfb-run does nearly the same, but waits for a signal that a quick server sends before the
# waiting starts (it then waits for ever), and looks for a free number before it takes it, which
# fails when several start at once. The server itself takes a free number and writes it to a pipe.
set -euo pipefail
size=$1
shift

folder=$(mktemp -d)
server=
clean_up() {
  [[ -z $server ]] || kill "$server" 2>/dev/null || true
  rm -rf "$folder"
}
trap clean_up EXIT

mkfifo "$folder/number"
Xvfb -displayfd 3 -screen 0 "${size}x24" -nolisten tcp 3>"$folder/number" 2>"$folder/log" &
server=$!
number=
read -r -t 120 number <"$folder/number" || true
if [[ -z $number ]]; then
  echo "with_display.sh: Xvfb did not start:" >&2
  cat "$folder/log" >&2
  exit 1
fi

status=0
DISPLAY=:$number "$@" || status=$?
exit "$status"
