#!/bin/sh
# Installs what is missing, builds everything and runs the tests. With MERIDIAN_CORPUS set to a folder of real meshes and
# their MANIFEST.csv, those are cut too. `src/test.sh sanitize` runs the fast tests with AddressSanitizer and
# UndefinedBehaviorSanitizer instead, `src/test.sh threads` those of what is parallel with ThreadSanitizer.
set -e
cd "$(dirname "$0")/.."
preset=${1:-release}
src/install-packages.sh test
cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" -j "$(nproc)"
ctest --preset "$preset" -j "$(nproc)"
