#!/bin/sh
# Two revisions on the same meshes, by turns: the median of each stage of a cut, and the least and the most of it.
# usage: bench.sh BASE HEAD [MESH ...]
# HEAD may be "." for what is in this folder. Without meshes, some of MERIDIAN_CORPUS. ROUNDS=5, and OPTIONS for `cut`.
set -e
cd "$(dirname "$0")/.."
[ $# -ge 2 ] || { sed -n '2,4s/^# //p' src/bench.sh >&2; exit 64; }
base=$1 head=$2
shift 2
if [ $# = 0 ]; then
  : "${MERIDIAN_CORPUS:?name meshes, or a folder of them}"
  set -- "$MERIDIAN_CORPUS"/kitten.* "$MERIDIAN_CORPUS"/botijo.* "$MERIDIAN_CORPUS"/soccerball.* "$MERIDIAN_CORPUS"/cheese.* "$MERIDIAN_CORPUS"/BCC.*
fi
work=$(mktemp -d)
trap 'git worktree remove --force "$work/base" 2>/dev/null; git worktree remove --force "$work/head" 2>/dev/null; rm -rf "$work"' EXIT

build() # name, revision
{
  folder=$work/$1
  if [ "$2" = . ]; then folder=$PWD; else git worktree add --detach -f "$folder" "$2" >/dev/null 2>&1; fi
  (cd "$folder" && cmake --preset release >/dev/null && cmake --build --preset release -j "$(nproc)" --target meridian_program >/dev/null)
  cp "$folder/build/release/meridian" "$work/meridian.$1"
}
build base "$base"
build head "$head"

# "mesh stage program seconds" for each stage that the report names, the sum of all components, and the whole process.
run() # program, mesh
{
  begin=$(date +%s%N)
  # shellcheck disable=SC2086 # options are words
  "$work/meridian.$1" cut "$2" -o "$work/out.off" --report "$work/report.json" --quiet $OPTIONS
  end=$(date +%s%N)
  awk -v mesh="$(basename "$2")" -v name="$1" -v whole=$((end - begin)) '
    index($0, "\"seconds\":") { inside = 1; next }
    inside && index($0, "}") { inside = 0 }
    inside { gsub(/[",:]/, " "); sum[$1] += $2 }
    END { for (s in sum) print mesh, s, name, sum[s]; print mesh, "whole", name, whole / 1e9 }' "$work/report.json"
}
for round in $(seq "${ROUNDS:-5}"); do
  for mesh in "$@"; do
    for program in $([ $((round % 2)) = 0 ] && echo head base || echo base head); do run $program "$mesh"; done
  done
done >"$work/times"

echo "| mesh | stage | $base, s | $head, s | ratio |"
echo "|---|---|---|---|---|"
sort -k1,1 -k2,2 -k3,3 -k4,4g "$work/times" | awk '
  function flush_stage(   m) {
    if (key == "") return
    split(key, k, " ")
    if (middle["base"] >= 0.002 || middle["head"] >= 0.002)
      printf "| %s | %s | %s | %s | %.2f |\n", k[1], k[2], text["base"], text["head"], (middle["base"] > 0 ? middle["head"] / middle["base"] : 0)
    delete middle; delete text
  }
  function flush_program() {
    if (n == 0) return
    middle[program] = value[int((n + 1) / 2)]
    text[program] = sprintf("%.3f (%.3f to %.3f)", middle[program], value[1], value[n])
    n = 0
  }
  { if ($1 " " $2 != key || $3 != program) flush_program()
    if ($1 " " $2 != key) { flush_stage(); key = $1 " " $2 }
    program = $3; value[++n] = $4 }
  END { flush_program(); flush_stage() }'
