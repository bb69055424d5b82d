#!/usr/bin/env bash
# make demo: installs the library in $1, builds the demo against it and runs it on the meshes $2 and $3. If these are
# empty, the demo cuts a band out of a real closed mesh. The remaining arguments are the Debian packages it needs;
# packages after -- serve only the pictures. Without apt, the demo stitches generated shapes.
set -euo pipefail
cd "$(dirname "$0")/.."
stage=$1 left=$2 right=$3
shift 3
packages=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
  packages+=("$1")
  shift
done
[ $# -eq 0 ] || shift
out=$PWD/build/demo
rm -rf "$out"
mkdir -p "$out"

status=0
scripts/install-packages.sh "${packages[@]}" || status=$?
staged() { # A target of the Makefile
  env -u MAKELEVEL -u MAKEFLAGS make --no-print-directory -s "$1" PREFIX="$stage" DESTDIR= cli=
}
rm -rf "$stage"
staged install-data
if [ "$status" -eq 3 ]; then
  [ -z "$left$right" ] || { echo "gusset: your own files need those packages" >&2; exit 1; }
  echo "gusset: so the demo stitches two shells that it generates, judged by the library alone, without pictures"
  staged install-library
  cc -std=c99 -O2 -I"$stage/include" examples/c/generated.c "$stage/lib/libgusset.a" \
    -lgcc_s -lutil -lrt -lpthread -lm -ldl -lc -o "$out/generated"
  (cd "$out" && ./generated)
  echo "the meshes are $out/left.obj, $out/right.obj and $out/after.obj"
  exit
fi
[ "$status" -eq 0 ] || exit "$status"

compiled() { # A target of the examples
  cmake -S examples -B build/examples -DGUSSET_PREFIX="$stage" >build/examples.log 2>&1 &&
    env -u MAKELEVEL -u MAKEFLAGS cmake --build build/examples --target "$1" --parallel 2 >>build/examples.log 2>&1 ||
    { tail -n 40 build/examples.log; return 1; }
}
# Compiles the demo while cargo builds the library, which seldom keeps all cores busy.
compiled demo_objects &
staged install-library || { wait; exit 1; }
wait $!
compiled demo

title="Two open meshes, joined"
if [ -n "$left" ] || [ -n "$right" ]; then
  build/examples/demo --left "$left" --right "$right" --out "$out" --title "$title"
else
  # A real mesh under CC0, from CGAL's own collection.
  mesh=diplodocus.off title="A closed mesh, cut and joined"
  band=(--point 0.02 0.1 0 --normal 1 0 0 --width 0.07 --eye 0.1 0.12 1 --near-eye 0.1 0.25 1)
  archive=$(dpkg -L libcgal-demo libcgal-dev | grep '/data\.tar\.gz$' | head -n 1)
  tar -xzf "$archive" -C "$out" --strip-components=2 "data/meshes/$mesh"
  echo "$mesh, from the Debian package libcgal-demo"
  build/examples/demo --mesh "$out/$mesh" "${band[@]}" --out "$out" --title "$title"
fi
python3 -B scripts/page.py "$title" "$out/joined.html" "$out/showcase"
echo "to turn in your hands, in any browser: $out/joined.html"

status=0
scripts/install-packages.sh "$@" || { echo "gusset: so there are no pictures, only that page"; exit 0; }
pictures=(before "slider=1" after "slider=0" joint "slider=0&look=near&wire=1")
if [ -z "$left$right" ]; then
  pictures=(before "slider=1" after "slider=0" joint "slider=0&look=near&wire=1" beside "pair=1&side=1&look=near&distance=1&named=1")
fi
arguments=()
for ((k = 0; k < ${#pictures[@]}; k += 2)); do
  arguments+=("$out/${pictures[k]}.png" "plain=1&theme=light&${pictures[k + 1]}")
done
echo "pictures:"
/usr/bin/python3 -B scripts/photograph.py "$out/joined.html" 1200 900 "${arguments[@]}" || status=$?
[ "$status" -eq 0 ] || [ "$status" -eq 3 ] || exit "$status"
