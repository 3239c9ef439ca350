#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what is missing, builds everything with warnings as errors, and runs all tests.
#
#   packaging/test.sh                 all tests
#   packaging/test.sh -R Photometry   arguments are passed on to ctest
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
jobs="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"

bash packaging/install_dependencies.sh

echo "== Building with warnings as errors in build/release"
if ! grep -qs '^SOFFIT_WERROR:[A-Z]*=ON' build/release/CMakeCache.txt; then
  cmake --preset ci
fi
cmake --build --preset ci --parallel "$jobs"

echo "== Running the tests"
exec ctest --preset ci --parallel "$jobs" --output-on-failure "$@"
