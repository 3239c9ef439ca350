#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the Debian packages that Soffit is built with, by name, and only those that are missing.
#
#   packaging/install_dependencies.sh         what run.sh and test.sh need
#   packaging/install_dependencies.sh dev     and what the presets `tidy` and `dev` add
#
# Works on Debian 12 and 13, as root or through sudo. With nothing missing it only asks dpkg.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=(cmake ninja-build ccache pkg-config g++)
core=(libtbb-dev libglm-dev libfmt-dev libeigen3-dev libhwy-dev libxxhash-dev nlohmann-json3-dev libassimp-dev
      libembree-dev libopencolorio-dev libopenimageio-dev
      openimageio-tools)  # not run by us: the export file of libopenimageio-dev insists on it
program=(libcli11-dev gnuplot-nox)  # gnuplot draws the plot of `soffit bench`
tests=(libgtest-dev libgmock-dev python3)
window=(qt6-base-dev libvtk9-dev libgl1-mesa-dri xvfb
        qt6-tools-dev qt6-l10n-tools  # CMake's part and the programs of Qt's linguist tools
        qt6-translations-l10n)        # what Qt's own dialogs say in other languages
if grep -qs '^VERSION_ID="12"' /etc/os-release; then
  window+=(libqt6opengl6-dev)  # from Debian 13 on a part of qt6-base-dev
fi
development=(clang clang-tidy clang-format libbenchmark-dev)

wanted=("${build[@]}" "${core[@]}" "${program[@]}" "${tests[@]}")
[[ ! -f ui/CMakeLists.txt ]] || wanted+=("${window[@]}")
[[ "${1:-}" != dev ]] || wanted+=("${development[@]}")

if ! command -v apt-get >/dev/null; then
  echo "install_dependencies.sh: apt-get is not there. This script knows Debian 12 and 13;" \
       "elsewhere install these by hand: ${wanted[*]}" >&2
  exit 1
fi

declare -A installed=()
while read -r name status; do
  [[ "$status" != installed ]] || installed["$name"]=1
done < <(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true)
missing=()
for name in "${wanted[@]}"; do
  [[ -n "${installed[$name]:-}" ]] || missing+=("$name")
done
if ((${#missing[@]} == 0)); then
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "install_dependencies.sh: missing packages: ${missing[*]}. Run this as root, or install sudo." >&2
    exit 1
  fi
  as_root=(sudo)
fi

mkdir -p build
log="$PWD/build/apt.log"
: >"$log"

apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -qq -y -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@" </dev/null >>"$log" 2>&1
}
install() { apt "$@" install --no-install-recommends "${missing[@]}"; }

echo "== Installing ${#missing[@]} Debian packages and what they need (a few minutes): ${missing[*]}"
if ! install --simulate || ! install; then  # package lists that are absent, or too old
  echo "== Reading the package lists (apt-get update)"
  if ! { apt update && install; }; then
    tail -n 20 "$log" >&2
    echo "install_dependencies.sh: apt-get failed, see above and $log." \
         "Check the network and /etc/apt/sources.list, then call this again." >&2
    exit 1
  fi
fi
