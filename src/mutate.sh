#!/bin/sh
# Plants faults, one at a time, and prints which of them no fast test catches: src/mutate.sh [FIRST [LAST]]. They stand in
# test/mutation/faults.tsv; all are compiled into one copy of the project, build/mutate, and an environment variable says
# which one there is. Tests of the fault's own folder run first.
set -e
cd "$(dirname "$0")/.."
src/install-packages.sh test
first=${1:-1}
last=${2:-$(grep -cv '^#' test/mutation/faults.tsv)}
copy=build/mutate/source
rm -rf "$copy"
mkdir -p "$copy"
cp -rp CMakeLists.txt CMakePresets.json LICENSE include src test doc "$copy"
perl test/mutation/plant.pl test/mutation/faults.tsv "$copy"
cmake -S "$copy" -B build/mutate/build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_DISABLE_FIND_PACKAGE_benchmark=ON \
  -DCMAKE_CXX_FLAGS="-include $PWD/test/mutation/planted.h" >/dev/null
cmake --build build/mutate/build -j "$(nproc)" >build/mutate/log || { tail -30 build/mutate/log; exit 1; }

run_tests() {
  MERIDIAN_FAULT=$number ctest --test-dir build/mutate/build -L fast -j "$(nproc)" --stop-on-failure --timeout 120 "$@" \
    >build/mutate/tests 2>&1
}
tests_of() {
  case $1 in
  src/proof/*) echo verification generator_verification alterations faults packing ;;
  src/files/*) echo formats texture_files images layout faults ;;
  src/surface/*) echo surface examination faults ;;
  src/curves/*) echo gaps sleeve generators cut ;;
  src/field/*) echo order fields solvers ;;
  src/handles/*) echo generators figures ;;
  src/map/*) echo parameterization packing levels slits pins unfolding faults ;;
  src/unwrap/*) echo charts symmetry geometry_image extension faults ;;
  *) echo faults program unwrap_program generator_verification ;;
  esac | sed 's/ /|/g; s/.*/^(&)$/'
}
number=0
run_tests || { echo "tests fail although there is no fault:"; grep 'Failed\|Timeout' build/mutate/tests; exit 1; }
tried=0
caught=0
while IFS='	' read -r number file old new; do
  case $number in \#*) continue ;; esac
  [ "$number" -ge "$first" ] && [ "$number" -le "$last" ] || continue
  tried=$((tried + 1))
  own=$(tests_of "$file")
  if run_tests -R "$own" && run_tests -E "$own"; then
    echo "not caught: $number, $file: '$old' became '$new'"
  else
    caught=$((caught + 1))
  fi
done <test/mutation/faults.tsv
echo "$caught of $tried faults are caught"
