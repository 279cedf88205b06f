#!/bin/sh
# Draws doc/figures/cost.svg from tables that bench_targets has written, and prints how seconds and memory grow.
# usage: plot_cost.sh TABLE...
# Of others, as measured once beside an earlier version on a machine with two cores: CPU seconds at four sizes.
set -e
figures=$(dirname "$(readlink -f "$0")")/figures
grep -h '^| plate, ' "${@:?tables of bench_targets}" | awk -F ' *[|] *' -v svg="$figures/cost.svg" '
  # what, faces, CPU s, MB; reading and writing is what the ratio of a cut is taken of
  { split($2, size, " "); n = size[2]; what = $3
    note(what, n, $4)
    if (what == "cut, curves tightened") { note("CGAL reads and writes", n, $4 / $8); note_memory(n, $6) } }
  function note(what, n, s) { if (!(what in count)) names[++kinds] = what; i = ++count[what]; x[what, i] = n; y[what, i] = s }
  function note_memory(n, mb) { i = ++count["memory"]; x["memory", i] = n; y["memory", i] = mb }
  # the slope of the logarithms, from 100,000 faces on
  function exponent(what,   i, m, a, b, sa, sb, saa, sab) {
    for (i = 1; i <= count[what]; ++i) {
      if (x[what, i] < 100000) continue
      a = log(x[what, i]); b = log(y[what, i]); ++m; sa += a; sb += b; saa += a * a; sab += a * b
    }
    return m < 2 ? 0 : (m * sab - sa * sb) / (m * saa - sa * sa)
  }
  function px(n) { return 80 + 560 * (log(n) / log(10) - 4) / 3.1 }
  function py(s) { return 440 - 400 * (log(s) / log(10) + 2) / 4 }
  function draw(what, color, dash,   i, p) {
    for (i = 1; i <= count[what]; ++i) p = p sprintf(" %.1f,%.1f", px(x[what, i]), py(y[what, i]))
    printf "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"2\"%s points=\"%s\"/>\n", color, dash ? " stroke-dasharray=\"6 4\"" : "", p >svg
    for (i = 1; i <= count[what]; ++i)
      printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"/>\n", px(x[what, i]), py(y[what, i]), color >svg
    row += 20
    printf "<text x=\"660\" y=\"%d\" fill=\"%s\">%s%s</text>\n", 40 + row, color, what, dash ? "" : sprintf(", n^%.2f", exponent(what)) >svg
    if (!dash) printf "%s: n^%.2f\n", what, exponent(what)
  }
  function peer(what, times,   t, k) {
    split(times, t, " ")
    for (k = 1; k <= 4; ++k) note(what, k == 1 ? 10224 : k == 2 ? 163584 : k == 3 ? 654336 : 2617344, t[k])
  }
  END {
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" height=\"490\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"900\" height=\"490\" fill=\"white\"/>\n" >svg
    for (e = 4; e <= 7; ++e) {
      printf "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"40\" y2=\"440\" stroke=\"#ddd\"/><text x=\"%.1f\" y=\"460\" text-anchor=\"middle\">10^%d</text>\n", px(10^e), px(10^e), px(10^e), e >svg
    }
    for (e = -2; e <= 2; ++e) {
      printf "<line x1=\"80\" x2=\"640\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#ddd\"/><text x=\"72\" y=\"%.1f\" text-anchor=\"end\">%g</text>\n", py(10^e), py(10^e), py(10^e) + 4, 10^e >svg
    }
    print "<text x=\"360\" y=\"482\" text-anchor=\"middle\">faces</text><text x=\"80\" y=\"26\">CPU seconds of a whole process</text>" >svg
    peer("libigl, cut_to_disk", "0.03 0.78 4.4 27.6")
    peer("Euclid, tree-cotree", "0.01 0.16 0.72 5.1")
    draw("unwrap", "#cc79a7"); draw("generators", "#009e73"); draw("cut, curves tightened", "#e69f00"); draw("cut", "#d55e00")
    draw("cut, tree-cotree", "#0072b2"); draw("CGAL reads and writes", "#777777")
    draw("libigl, cut_to_disk", "#999999", 1); draw("Euclid, tree-cotree", "#56b4e9", 1)
    print "</svg>" >svg
    printf "memory of a cut: n^%.2f\n", exponent("memory")
  }'
