#!/bin/sh
# Prints the picture of the stages on the main page of the reference (doc/groups.dox), coloured by layer, as SVG:
#   doc/draw_stages.sh >doc/figures/stages.svg
# Input of the program below, one thing a line, with tabs between:
#   layer   name, colour
#   stage   column, row (halves are allowed), layer, name, what makes it, what comes of it
#   way     style, then points as column,row,dx,dy: the middle of a place in the grid, moved by half boxes
set -e
draw()
{
  awk -F '\t' '
    function x(column) { return 40 + (column - 0.5) * 216 }
    function y(row) { return 20 + (row - 0.5) * 104 }
    BEGIN {
      wide = 172; high = 62
      print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 920 600\" width=\"920\" height=\"600\" font-family=\"sans-serif\">"
      print "<title>The stages of Meridian, from a mesh to a recounted result</title>"
      print "<defs><marker id=\"end\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"8\" markerHeight=\"8\" orient=\"auto\">" \
            "<path d=\"M0 0L8 4L0 8z\" fill=\"#444\"/></marker></defs>"
      print "<rect width=\"920\" height=\"600\" fill=\"white\"/>"
    }
    $1 == "layer" { colour[$2] = $3; layers[++count] = $2 }
    $1 == "way" {
      line = ""
      for (i = 3; i <= NF; ++i) {
        split($i, p, ",")
        line = line (i > 3 ? " " : "") x(p[1]) + p[3] * wide / 2 "," y(p[2]) + p[4] * high / 2
      }
      printf "<polyline points=\"%s\" fill=\"none\" stroke=\"#444\" stroke-width=\"1.5\"%s marker-end=\"url(#end)\"/>\n", line,
             $2 == "dashed" ? " stroke-dasharray=\"5 4\"" : ""
    }
    $1 == "stage" {
      printf "<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" rx=\"6\" fill=\"%s\" stroke=\"#444\"/>\n",
             x($2) - wide / 2, y($3) - high / 2, wide, high, colour[$4]
      printf "<text x=\"%g\" y=\"%g\" text-anchor=\"middle\" font-size=\"15\" font-weight=\"bold\">%s</text>\n", x($2), y($3) - 11, $5
      for (i = 6; i <= 7; ++i)
        printf "<text x=\"%g\" y=\"%g\" text-anchor=\"middle\" font-size=\"11\"%s>%s</text>\n", x($2), y($3) + 7 + (i - 6) * 15,
               i == 6 ? "" : " font-style=\"italic\"", $i
    }
    END {
      for (i = 1; i <= count; ++i) {
        printf "<rect x=\"%g\" y=\"560\" width=\"14\" height=\"14\" fill=\"%s\" stroke=\"#444\"/>\n", 62 + (i - 1) * 92, colour[layers[i]]
        printf "<text x=\"%g\" y=\"572\" font-size=\"13\">%s</text>\n", 82 + (i - 1) * 92, layers[i]
      }
      print "</svg>"
    }'
}
# Written with "|" for tabs.
tr '|' '\t' <<'END' | draw
layer|files|#eeeeee
layer|surface|#cfe3f5
layer|field|#d4efcf
layer|curves|#fdf0c0
layer|handles|#fbd5c8
layer|cut|#ecd3ee
layer|map|#cdeeee
layer|result|#e4dccb
layer|proof|#ffffff
way|solid|1,1,1,0|2,1,-1,0
way|solid|2,1,1,0|3,1,-1,0
way|solid|3,1,1,0|4,1,-1,0
way|solid|4,1,0,1|4,1.5,0,0|1,1.5,-1.14,0|1,2,-1.14,0|1,2,-1,0
way|solid|1,2,-1.14,0|1,3,-1.14,0|1,3,-1,0
way|solid|1,2,1,0|2,2,-1,0
way|solid|1,3,1,0|2,3,-1,0
way|solid|2,2,0,1|2,3,0,-1
way|solid|2,2,1,0|3,2,0,0|3,2.5,0,-1
way|solid|2,3,1,0|3,3,0,0|3,2.5,0,1
way|solid|3,2.5,1,0|4,2.5,-1,0
way|solid|4,2.5,0,1|4,3.5,0,0|1,3.5,-1.14,0|1,4,-1.14,0|1,4,-1,0
way|solid|1,4,1,0|2,4,-1,0
way|solid|2,4,1,0|3,4,-1,0
way|solid|3,4,1,0|4,4,-1,0
way|solid|2,4,0,1|2,5,0,-1
way|solid|4,4,0,1|4,5,0,0|2,5,1,0
way|solid|4,2.5,1,0|4,2.5,1.14,0|4,5.1,1.14,0|2,5.1,1,0
way|solid|2,5,-1,0|1,5,1,0
way|dashed|1,1,-1,0|1,1,-1.3,0|1,5,-1.3,0|1,5,-1,0
stage|1|1|files|input|files/read_mesh|Polygon_soup
stage|2|1|surface|examine|examine_surface|Triangle_surface
stage|3|1|field|field|solve_harmonic_field|Scalar_field
stage|4|1|field|order|order_surface|Ordered_surface
stage|1|2|curves|contours|trace_saddle_loops|Contour
stage|2|2|handles|meridians|find_meridians|Meridian_choice
stage|1|3|curves|flow|make_morse_complex|Morse_complex
stage|2|3|handles|longitudes|find_generators|Normal_curves
stage|3|2.5|curves|tighten|tighten_curves|Normal_curves
stage|4|2.5|surface|insert|insert_curves|Refined_surface
stage|1|4|cut|links|link_boundaries|Cut
stage|2|4|surface|open|open_along|Opened_surface
stage|3|4|map|map|parameterize_disc|Parameterization
stage|4|4|map|pack|pack_charts|Chart
stage|2|5|result|result|assemble_result|Result_mesh
stage|1|5|proof|recount|verify_cut, ...|Verification
END
