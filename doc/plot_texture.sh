#!/bin/sh
# Draws the plots of doc/texture.md again. Needs gnuplot (src/install-packages.sh plots).
#   plot_texture.sh TABLE.tsv   from a table that measure_unwraps has written
set -e
figures=$(dirname "$(readlink -f "$0")")/figures
table=${1:?a table of measure_unwraps}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# One line a mesh, by its faces: the name, the faces, and a column of the table by itself and with --charts auto.
by_mesh() # column
{
  awk -F '\t' -v column="$1" '
    NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
    $1 == "mesh" { next }
    {
      if (!($1 in known)) { known[$1] = 1; meshes[++n] = $1 }
      value[$1, $2] = $at[column]
      if ($2 == "-") faces[$1] = $at["faces"]
    }
    END {
      for (k = 1; k <= n; ++k) {
        m = meshes[k]
        name = m
        sub(/\..*/, "", name)
        v = value[m, "-"]
        w = value[m, "--charts auto"]
        if (v != "" && w != "") print faces[m] "\t" name "\t" v "\t" w
      }
    }' "$table" | sort -g
}
by_mesh "worst L2" >"$work/stretch"
by_mesh filled >"$work/filled"
by_mesh "CPU s" >"$work/cpu"

cat >"$work/head.gp" <<'END'
set terminal svg size 1100,520 noenhanced background "white" font "sans,13"
set datafile separator "\t"
set xtics rotate by -50 scale 0
set grid ytics xtics lc rgb "#dddddd"
set key outside top center horizontal
set offsets 0.7, 0.7, 0, 0
set bmargin at screen 0.32
END
cd "$work"
gnuplot head.gp - <<END
set output "$figures/texture-stretch.svg"
set ylabel "L2 stretch, worst component"
set yrange [1:1.3]
plot "stretch" using 0:(\$3 > 1.3 ? 1.3 : \$3):xtic(2) with points pt 7 ps 0.7 lc rgb "#c05020" title "one chart", \\
  "" using 0:(\$4 > 1.3 ? 1.3 : \$4) with points pt 5 ps 0.6 lc rgb "#2060a0" title "--charts auto", \\
  1.1 with lines lc rgb "#c05020" dt 2 title "1.1", 1.02 with lines lc rgb "#2060a0" dt 2 title "1.02"
set output "$figures/texture-filled.svg"
set ylabel "part of the square that is filled"
set yrange [0:1]
plot "filled" using 0:3:xtic(2) with points pt 7 ps 0.7 lc rgb "#c05020" title "one chart", \\
  "" using 0:4 with points pt 5 ps 0.6 lc rgb "#2060a0" title "--charts auto"
set output "$figures/texture-cost.svg"
set bmargin
unset offsets
set xtics norotate scale 1 autofreq
set logscale xy
set autoscale y
set xlabel "faces"
set ylabel "CPU seconds of the whole process"
plot "cpu" using 1:3 with points pt 7 ps 0.7 lc rgb "#c05020" title "one chart", \\
  "" using 1:4 with points pt 5 ps 0.6 lc rgb "#2060a0" title "--charts auto"
END
