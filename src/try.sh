#!/bin/sh
# Installs what is missing, builds the program, cuts a real mesh and gives it texture coordinates: elephant.off, genus 3, from Debian's libcgal-demo.
set -e
cd "$(dirname "$0")/.."
src/install-packages.sh
cmake --preset release -DMERIDIAN_DEVELOPER=OFF -B build/try >/dev/null
cmake --build build/try -j "$(nproc)"
out=build/try/elephant
mkdir -p "$out"
if [ ! -s "$out/elephant.off" ]; then # the mesh is taken out of the package: slim systems leave /usr/share/doc out
  as_root=
  [ "$(id -u)" = 0 ] || as_root=sudo
  (cd "$out" && { apt-get download -qq libcgal-demo 2>/dev/null || { $as_root apt-get update -qq && apt-get download -qq libcgal-demo; }; })
  dpkg-deb --fsys-tarfile "$out"/libcgal-demo*.deb | tar xO ./usr/share/doc/libcgal-dev/data.tar.gz \
    | tar xzO data/meshes/elephant.off >"$out/elephant.part"
  mv "$out/elephant.part" "$out/elephant.off"
  rm -f "$out"/libcgal-demo*.deb
fi
build/try/meridian cut "$out/elephant.off" -o "$out/disc.obj" --report "$out/report.json" --view "$out/view.html"
build/try/meridian unwrap "$out/elephant.off" -o "$out/textured.obj" --png "$out/checkerboard.png" --svg "$out/layout.svg" --view "$out/texture.html"
echo "the opened mesh: $PWD/$out/disc.obj"
echo "the report:      $PWD/$out/report.json"
echo "the 3D page:     $PWD/$out/view.html (open it in a browser)"
echo "with texture:    $PWD/$out/textured.obj, and $PWD/$out/texture.html"
