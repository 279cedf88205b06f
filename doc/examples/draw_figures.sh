#!/bin/sh
# Draws the figures of doc/figures.md again: draw_figures.sh BUILD_FOLDER. Needs chromium.
set -e
here=$(dirname "$(readlink -f "$0")")
build=$(readlink -f "${1:?the build folder}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$build/test/write_figure_surfaces" "$work"
cd "$work"
draw() # picture, page
{
  chromium --headless --no-sandbox --disable-gpu --use-gl=swiftshader --enable-unsafe-swiftshader --ignore-gpu-blocklist --no-first-run \
    --disable-background-networking --disable-component-update --disable-sync --user-data-dir="$work/profile" --window-size=560,420 \
    --screenshot="$here/../figures/$1.png" "file://$work/$2" >/dev/null 2>&1
}
for name in torus irregular-torus bitorus-coarse bitorus bitorus-fine tiny-handle pot three-rings; do
  "$build/meridian" generators $name.obj -o out.obj --view page.html
  draw $name page.html
done
for name in torus bitorus tiny-handle three-rings; do
  "$build/meridian" generators $name.obj -o out.obj --view page.html --complex --no-tighten
  draw $name-complex page.html
done
for join in surface complex saddles; do
  "$build/meridian" cut bitorus.obj -o out.off --method generators --join $join --view page.html
  draw bitorus-cut-$join page.html
done
"$build/meridian" cut bitorus.obj -o out.off --tighten curves --view page.html
draw bitorus-cut page.html
"$build/meridian" cut three-rings.obj -o out.off --method morse --view page.html
draw three-rings-cut-morse page.html
