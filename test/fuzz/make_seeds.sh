#!/bin/sh
# Writes small files of every kind that is read: make_seeds.sh MERIDIAN FOLDER
set -e
meridian=$1
mkdir -p "$2"
cd "$2"
for reader in off obj stl ply vtp gzip png json cbor lists result; do mkdir -p $reader; done

# A torus of n times m vertices.
torus() {
  awk -v n="$1" -v m="$2" 'BEGIN {
    print "OFF\n" n * m, 2 * n * m, 0
    for (i = 0; i < n; ++i) for (j = 0; j < m; ++j) {
      a = 6.2831853 * i / n; b = 6.2831853 * j / m
      printf "%g %g %g\n", (3 + cos(b)) * cos(a), (3 + cos(b)) * sin(a), sin(b)
    }
    for (i = 0; i < n; ++i) for (j = 0; j < m; ++j) {
      k = (i + 1) % n; l = (j + 1) % m
      print 3, i * m + j, k * m + j, k * m + l "\n" 3, i * m + j, k * m + l, i * m + l
    }
  }'
}
torus 4 3 >off/torus.off
printf 'COFF # with colours\n4 2 5\n0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0 9 9 9\n4 0 1 2 3 0.5 0.5 0.5\n3 0 1 2\n' >off/colours.off
gzip -c off/torus.off >gzip/torus.gz
printf 'v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\ng a\nusemtl m\ns 1\nf 1/1/1 2/1/1 3//1\nf -1 -2 -3\nl 1 2\n' >obj/parts.obj
printf 'solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n' >stl/text.stl
{ head -c 80 /dev/zero; printf '\001\000\000\000'; head -c 50 /dev/zero; } >stl/binary.stl
printf 'ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty double y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0 1 2 3\n1 0 0 1 2 3\n1 1 0 1 2 3\n0 1 0 1 2 3\n5 0 1 2 -1 3\n' >ply/strips.ply
printf 'ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty char x\nproperty short y\nproperty int z\nelement face 1\nproperty list uchar ushort vertex_index\nend_header\n\001\000\002\000\000\000\003\003\000\000\000\000\000\000' >ply/big.ply
printf '<VTKFile type="PolyData"><PolyData><Piece NumberOfPoints="4" NumberOfStrips="1"><Points><DataArray type="Float64" format="ascii">0 0 0 1 0 0 1 1 0 0 1 0</DataArray></Points><Strips><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3</DataArray><DataArray type="Int32" Name="offsets" format="ascii">4</DataArray></Strips></Piece></PolyData></VTKFile>' >vtp/text.vtp
printf 'p0 1 2\n3 4 # a path\n' >lists/paths
printf 'n0 0.5 0.5\n7 0 1\n' >lists/pins
{ printf v; awk 'BEGIN { for (i = 0; i < 100; ++i) print i / 7 }'; } >lists/values

for ending in obj ply vtp; do "$meridian" cut off/torus.off -o $ending/torus.$ending --quiet; done
"$meridian" cut off/torus.off -o cut.obj --map cbor --quiet
mv cut.map.cbor cbor/cut.cbor
"$meridian" unwrap off/torus.off -o unwrap.obj --png image.png --resolution 16 --quiet
mv image.png png/
"$meridian" cut off/torus.off -o cut.obj --quiet
"$meridian" generators off/torus.off -o generators.obj --quiet
for result in cut unwrap generators; do
  cp $result.map.json json/$result.json
  { cat off/torus.off; echo %%; cat $result.obj; echo %%; cat $result.map.json; } >result/$result
done
rm -f ./*.* obj/*.map.* ply/*.map.* vtp/*.map.*
