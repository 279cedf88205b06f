#!/bin/sh
# Draws the plots of doc/quality.md again. Needs gnuplot (Debian: gnuplot-nox).
#   plot_quality.sh METHODS.tsv STABILITY.tsv   from tables that measure_cuts has written
#   plot_quality.sh BUILD_FOLDER MESH...        measures first, which takes long, and leaves the tables in the present folder
set -e
figures=$(dirname "$(readlink -f "$0")")/figures
if [ -d "${1:?two tables, or the build folder and meshes}" ]; then
  measure=$1/benchmark/measure_cuts
  shift
  "$measure" methods "$@" >methods.tsv
  "$measure" stability >stability.tsv
  set -- methods.tsv stability.tsv
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# One line a mesh, the shortest cut first: the name, then a column of the table for six ways to cut.
by_mesh() # table, column
{
  awk -F '\t' -v column="$2" '
    NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
    $1 == "mesh" { next }
    {
      way = $5 ", " $6
      if (!($1 in known)) { known[$1] = 1; meshes[++n] = $1 }
      value[$1, way] = $at[column]
      if ($at["length"] != "-" && (!($1 in least) || $at["length"] < least[$1])) least[$1] = $at["length"]
    }
    END {
      count = split("contours, curves;contours, graph;geodesic, curves;tree-cotree, no;tree-cotree, graph;geometry-image, no", ways, ";")
      for (k = 1; k <= n; ++k) {
        if (!(meshes[k] in least)) continue
        name = meshes[k]
        sub(/\..*/, "", name)
        line = least[meshes[k]] "\t" name
        for (j = 1; j <= count; ++j) { v = value[meshes[k], ways[j]]; line = line "\t" (v == "" ? "-" : v) }
        print line
      }
    }' "$1" | sort -g | cut -f 2-
}
by_mesh "$1" length >"$work/length"
by_mesh "$1" turning >"$work/turning"
# One line a method, for each change: its name, then median, least and greatest of both measures.
for change in rotated renumbered subdivided noise "tiny handle"; do
  awk -F '\t' -v change="$change" '
    $1 == "all" && $3 == change && $9 != "-" {
      name = $4 (($4 ~ /contours|geodesic/) ? ($5 == "no" ? ", loose" : $5 == "graph" ? ", graph" : "") : ($5 == "no" ? "" : ", graph"))
      print name "\t" $9 "\t" $10 "\t" $11 "\t" $12 "\t" $13 "\t" $14
    }' "$2" >"$work/$change"
done

cat >"$work/meshes.gp" <<'END'
set terminal svg size 1100,600 noenhanced background "white" font "sans,13"
set datafile separator "\t"
set datafile missing "-"
set xtics rotate by -50 scale 0
set grid ytics xtics lc rgb "#dddddd"
set key outside top center horizontal
set offsets 0.7, 0.7, 0, 0
set bmargin at screen 0.28
set rmargin at screen 0.95
array title[6] = ["contours", "contours, graph tightened", "geodesic", "tree-cotree", "tree-cotree, graph tightened", "geometry-image"]
array color[6] = ["#d55e00", "#d55e00", "#009e73", "#0072b2", "#0072b2", "#777777"]
array shape[6] = [7, 6, 9, 5, 4, 11]
set output figures."/quality-length.svg"
set logscale y
set yrange [0.4:*]
set ylabel "length / square root of the area"
plot for [i=1:6] work."/length" using 0:(column(i + 1)):xtic(1) with points pt shape[i] ps 0.8 lw 1.5 lc rgb color[i] title title[i]
set output figures."/quality-turning.svg"
unset logscale y
set yrange [0:*]
set ylabel "mean turning angle, degrees"
plot for [i=1:6] work."/turning" using 0:(column(i + 1)):xtic(1) with points pt shape[i] ps 0.8 lw 1.5 lc rgb color[i] title title[i]
END

cat >"$work/stability.gp" <<'END'
set terminal svg size 1100,640 noenhanced background "white" font "sans,12"
set output figures."/quality-stability.svg"
set datafile separator "\t"
array change[5] = ["rotated", "renumbered", "subdivided", "noise", "tiny handle"]
set grid xtics lc rgb "#dddddd"
unset key
set xtics nomirror scale 0.5
set ytics scale 0
step(span) = span > 120 ? 50 : span > 50 ? 20 : span > 24 ? 10 : span > 12 ? 5 : span > 5 ? 2 : span > 2 ? 1 : 0.5
set multiplot
do for [row=1:2] {
  c = row == 1 ? 2 : 5
  set bmargin at screen 0.57 - 0.47 * (row - 1)
  set tmargin at screen 0.94 - 0.47 * (row - 1)
  set label 1 (row == 1 ? "change of length, percent" : "distance of the cuts, percent of the square root of the area") at screen 0.595, 0.505 - 0.47 * (row - 1) center
  do for [i=1:5] {
    set lmargin at screen 0.205 + 0.158 * (i - 1)
    set rmargin at screen 0.205 + 0.158 * (i - 1) + 0.143
    file = work."/".change[i]
    set xrange [*:*]
    set yrange [*:*]
    stats file using (column(c + 1)) name "L" nooutput
    stats file using (column(c + 2)) name "H" nooutput
    span = H_max - (row == 1 ? L_min : 0)
    if (span < 1) { span = 1 }
    set xtics step(span)
    set xrange [(row == 1 ? L_min : 0) - 0.06 * span : H_max + 0.06 * span]
    set yrange [8.6:-0.6]
    set title (row == 1 ? change[i] : "") offset 0,-0.5
    if (i == 1) {
      plot file using c:0:c+1:c+2:ytic(1) with xerrorbars pt 7 ps 0.6 lc rgb "#0072b2"
    } else {
      plot file using c:0:c+1:c+2:ytic("") with xerrorbars pt 7 ps 0.6 lc rgb "#0072b2"
    }
    unset label 1
  }
}
END
for plot in meshes stability; do gnuplot -e "work='$work'; figures='$figures'" "$work/$plot.gp"; done
