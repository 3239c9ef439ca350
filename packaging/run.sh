#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what is missing, builds the release, and runs Soffit.
#
#   packaging/run.sh                          opens the application; without a display or before
#                                             it is built: pictures and lux tables of the sample office
#   packaging/run.sh measure projects/flat    anything else is passed on to `soffit`
set -euo pipefail
here="$PWD"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root="$PWD"
soffit="$root/build/release/bin/soffit"
pictures="$root/build/pictures"

bash packaging/install_dependencies.sh

echo "== Building the release in build/release" >&2
# A folder that test.sh has configured (warnings are errors there) serves as well.
[[ -f build/release/build.ninja ]] || cmake --preset release >&2
targets=(soffit)
[[ ! -f ui/CMakeLists.txt ]] || targets+=(soffit-gui)
cmake --build build/release --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}" \
  --target "${targets[@]}" >&2

if (($# > 0)); then
  cd "$here"
  exec "$soffit" "$@"
fi
if [[ -x build/release/bin/soffit-gui && -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]]; then
  exec "$soffit"
fi

layouts() {
  python3 -c 'import json, sys
for layout in json.load(open(sys.argv[1], encoding="utf-8"))["layouts"]: print(layout["name"])' "$1"
}

echo "== Sample project projects/office: one picture and one table of illuminance per layout"
mkdir -p "$pictures"
while read -r layout; do
  slug="$(tr 'A-Z ' 'a-z-' <<<"$layout")"
  picture="$pictures/office-$slug.png"
  echo
  echo "== Layout '$layout'"
  "$soffit" render projects/office --layout "$layout" --size 1280x800 --samples 4 -o "$picture" </dev/null
  "$soffit" measure projects/office --layout "$layout" </dev/null
  echo "   picture: $picture"
done < <(layouts projects/office/office.soffit)
echo
echo "== The pictures are in $pictures"
