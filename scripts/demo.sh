#!/usr/bin/env bash
# make demo: builds the demo against the installation in $1 and runs it on the meshes $2 and $3, or, where these are empty, on
# a real closed mesh that it cuts in two. The remaining arguments are the Debian packages it needs. Where there is no apt to
# install them it stitches shapes that it generates.
set -euo pipefail
cd "$(dirname "$0")/.."
stage=$1 left=$2 right=$3
shift 3
out=$PWD/build/demo
rm -rf "$out"
mkdir -p "$out"

status=0
scripts/install-packages.sh "$@" || status=$?
if [ "$status" -eq 3 ]; then
  [ -z "$left$right" ] || { echo "gusset: your own files need those packages" >&2; exit 1; }
  echo "gusset: so the demo stitches two shells that it generates, judged by the library alone, without pictures"
  cc -std=c99 -O2 -I"$stage/include" examples/c/generated.c "$stage/lib/libgusset.a" \
    -lgcc_s -lutil -lrt -lpthread -lm -ldl -lc -o "$out/generated"
  (cd "$out" && ./generated)
  echo "the meshes are $out/left.obj, $out/right.obj and $out/after.obj"
  exit
fi
[ "$status" -eq 0 ] || exit "$status"

cmake -S examples -B build/examples -DGUSSET_PREFIX="$stage" >build/examples.log 2>&1 &&
  env -u MAKELEVEL -u MAKEFLAGS cmake --build build/examples --parallel 2 >>build/examples.log 2>&1 || { tail -n 40 build/examples.log; exit 1; }

if [ -n "$left" ] || [ -n "$right" ]; then
  build/examples/demo --left "$left" --right "$right" --out "$out"
else
  # Real meshes under CC0, from CGAL's own collection.
  archive=$(dpkg -L libcgal-demo libcgal-dev | grep '/data\.tar\.gz$' | head -n 1)
  tar -xzf "$archive" -C "$out" --strip-components=2 data/meshes/armadillo.off
  echo "armadillo.off, from the Debian package libcgal-demo"
  build/examples/demo --mesh "$out/armadillo.off" --out "$out"
fi

# OpenMesh calls the file of materials .mat; viewers look for .mtl.
for name in before after; do
  mv "$out/$name.mat" "$out/$name.mtl"
  sed -i "s/^mtllib $name.mat/mtllib $name.mtl/" "$out/$name.obj"
done

# Line 1: the camera that sees the whole; line 2: the one that sees the strip.
mapfile -t cameras <"$out/cameras.txt"
picture() {
  # shellcheck disable=SC2086 # the camera is several options
  timeout 120 xvfb-run -a f3d "$out/$1.obj" --output="$out/$2.png" --dry-run --quiet --resolution=1200,900 \
    --bg-color=1,1,1 $3 >"$out/$2.log" 2>&1 && [ -s "$out/$2.png" ] && rm "$out/$2.log" &&
    echo "  $out/$2.png" || { echo "gusset: no picture: see $out/$2.log" >&2; exit 1; }
}
echo "pictures:"
picture before before "${cameras[0]}"
picture after after "${cameras[0]}"
picture before gap "${cameras[1]} --edges"
picture after strip "${cameras[1]} --edges"
