#!/bin/sh
# Installs the Debian packages that are missing. With "test", those of the tests too; with "fuzz", a compiler that
# feeds readers with bytes; with "readers", programs that read what is written, for benchmark/quality/compare_readers.py;
# with "plots", what draws the plots of doc.
set -e
packages="g++ cmake ninja-build libcgal-dev libeigen3-dev libboost-dev libspectra-dev libsuitesparse-dev libopenblas0-serial libcli11-dev
  nlohmann-json3-dev libpugixml-dev zlib1g-dev libpng-dev libjs-three"
[ "$1" != test ] || packages="$packages libboost-test-dev libbenchmark-dev clang-format clang-tidy pkg-config chromium doxygen texlive-binaries assimp-utils libopenmesh-dev"
[ "$1" != fuzz ] || packages="$packages clang llvm libclang-rt-dev"
[ "$1" != readers ] || packages="$packages assimp-utils blender python3-vtk9"
[ "$1" != plots ] || packages="$packages gnuplot-nox"
missing=
for p in $packages; do
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$p" 2>/dev/null)" = installed ] || missing="$missing $p"
done
[ -n "$missing" ] || exit 0
echo "installing:$missing"
as_root=
[ "$(id -u)" = 0 ] || as_root=sudo
$as_root apt-get update -qq
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
