#!/bin/sh
# Installs what is missing, builds everything and runs the tests. With MERIDIAN_CORPUS set to a folder of real meshes and
# their MANIFEST.csv, those are cut too.
set -e
cd "$(dirname "$0")/.."
src/install-packages.sh test
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)"
ctest --preset release -j "$(nproc)"
