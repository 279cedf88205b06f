#!/bin/bash
# Hashes of everything that the program writes for twenty meshes and a dozen options each; timings are left out.
# usage: hash_outputs.sh PROGRAM CORPUS [JOBS] >HASHES
# Two programs that give the same results print the same lines.
set -u
program=$(realpath "$1") corpus=$(realpath "$2") jobs=${3:-2}
small="eight.off anchor.off cones14.off casting.off.gz 5Torus.obj.gz double-torus-3-holes.off torus_with_holes.obj couplingdown.off pig.off featuretype.STL"
large="turbine.off.gz knot2.off.gz shrec07_105.off.gz fertility_input.off.gz elephant-with-holes.off multiComp.obj.gz b9_mesh.off.gz plane_holes.obj.gz aneurism_small.obj.gz lattice.stl.gz cheese.off.gz"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

run() { # mesh, number, command and options
  dir=$work/$1.$2
  mkdir "$dir" && cd "$dir" || exit 1
  ln -s "$corpus/$1" "$1"
  command=$3
  shift 3
  "$program" $command "$@" >stdout 2>stderr
  echo "status $?" >>stdout
  perl -0pi -e 's/"seconds": *\{[^}]*\},?//g' $(ls *.json 2>/dev/null | grep -v map) /dev/null 2>/dev/null
  for f in $(ls | grep -vxF "$(basename "$dir" | sed 's/\.[0-9]*$//')"); do
    echo "$(sha256sum <"$f" | cut -c1-32) $(basename "$dir") $f"
  done
  cd "$work" && rm -rf "$dir"
}
export -f run
export work corpus program

list() {
  for m in $small $large; do
    cat <<END
$m 01 cut $m -o out.obj --report r.json --curves c.obj --view v.html
$m 02 cut $m -o out.ply --method generators --join complex --report r.json --curves c.obj
$m 03 cut $m -o out.vtp --method morse --report r.json
$m 04 cut $m -o out.off --method geodesic --levels tight --prefer length --report r.json
$m 05 cut $m -o out.obj --method tree-cotree --bases 4 --report r.json
$m 06 cut $m -o out.obj --on-edges --refine-where-needed --report r.json
$m 07 cut $m -o out.obj --links plane --weights mean-value --tighten no --report r.json
$m 08 cut $m -o out.obj --bifurcations --weights cotangent --field eigenfunction --report r.json
$m 09 cut $m -o out.obj --weights intrinsic-delaunay --extrema curved --prefer hidden --direction 1 2 3 --report r.json
$m 10 generators $m -o out.obj --report r.json --curves c.obj --complex --view v.html
$m 11 generators $m -o out.obj --mode open --longitudes arc --no-tighten --report r.json
$m 12 info $m --report r.json
END
  done
  for m in $small turbine.off.gz fertility_input.off.gz elephant-with-holes.off multiComp.obj.gz; do
    cat <<END
$m 20 unwrap $m -o out.obj --report r.json --view v.html --svg l.svg --png p.png --distortion d.ply
$m 21 unwrap $m -o out.obj --report r.json --parameterization stretch --border square
$m 22 unwrap $m -o out.obj --report r.json --parameterization conformal
$m 23 compare $m --cut 0 --cut 1 --report r.json
END
  done
  for m in $small; do
    cat <<END
$m 30 cut $m -o out.obj --tighten graph --report r.json --curves c.obj
$m 31 cut $m -o out.obj --method geometry-image --on-edges --tighten graph --report r.json
$m 32 cut $m -o out.obj --family 6 --report r.json
$m 33 generators $m -o out.obj --basis shortest --report r.json
$m 34 unwrap $m -o out.obj --report r.json --parameterization conformal --on-edges
$m 35 unwrap $m -o out.obj --report r.json --parameterization mean-value --family 3 --stretch-weight 0.5
$m 36 unwrap $m -o out.obj --report r.json --parameterization conformal --max-stretch 1.2
$m 37 unwrap $m -o out.obj --report r.json --parameterization authalic
$m 38 unwrap $m -o out.obj --report r.json --geometry-image 65
$m 39 compare $m --cut 1 --cut 2 --weights cotangent --report r.json
$m 50 cut $m -o out.obj --links plane --source 11 --report r.json
$m 51 cut $m -o out.obj --links plane --bifurcations --report r.json
$m 52 cut $m -o out.obj --source 11 --report r.json
$m 53 cut $m -o out.obj --method geodesic --from 5 --on-edges --report r.json
$m 40 cut $m -o out.obj --method generators --join saddles --field distance --prefer mean-curvature --report r.json
END
  done
}
list | xargs -P "$jobs" -L 1 bash -c 'run "$@"' _ | sort -k 2,3
