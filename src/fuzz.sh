#!/bin/sh
# Feeds everything that reads files with bytes made by libFuzzer, under sanitizers: src/fuzz.sh [MINUTES [READER...]].
# So many minutes a reader, one at first (0.1 are six seconds), as many readers at once as there are processors. What is found lies in
# build/fuzz/found; inputs that reach new code are kept in build/fuzz/corpus, and the next run goes on from them.
set -e
cd "$(dirname "$0")/.."
minutes=${1:-1}
[ $# -eq 0 ] || shift
readers=${*:-off obj stl ply vtp gzip png json cbor lists result}
src/install-packages.sh fuzz
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)" --target meridian_program
cmake --preset fuzz >/dev/null
cmake --build --preset fuzz -j "$(nproc)"
test/fuzz/make_seeds.sh "$PWD/build/release/meridian" build/fuzz/seeds
mkdir -p build/fuzz/found build/fuzz/log
run_one() {
  mkdir -p "build/fuzz/corpus/$1"
  dictionary=test/fuzz/dictionaries/$1.dict
  [ -e "$dictionary" ] || dictionary=
  "build/fuzz/test/fuzz/fuzz_$1" "build/fuzz/corpus/$1" "build/fuzz/seeds/$1" -max_total_time="$2" -max_len=20000 \
    -timeout=5 -rss_limit_mb=2000 -artifact_prefix="build/fuzz/found/$1-" ${dictionary:+-dict="$dictionary"} \
    >"build/fuzz/log/$1" 2>&1 && ended= || ended=", FOUND SOMETHING"
  echo "$1: $(awk '/stat::number_of_executed_units/ { n = $2 } /^#[0-9]+/ { sub("#", "", $1); m = $1 } END { print n ? n : m }' "build/fuzz/log/$1") inputs$ended"
}
running=0
for reader in $readers; do
  run_one "$reader" "$(awk "BEGIN { print int(60 * $minutes) }")" &
  running=$((running + 1))
  [ $((running % $(nproc))) -ne 0 ] || wait
done
wait
[ -z "$(ls build/fuzz/found)" ] || { echo "inputs that end a reader lie in build/fuzz/found"; exit 1; }
