#!/usr/bin/env bash
# CMakeLists.txt of the sources, configured, built and installed by itself, installs what `make install` does.
#   install_by_cmake.sh ROOT PREFIX TARGET    the sources; an installation by make; where cargo has built it
set -euo pipefail
root=$1 prefix=$2 target=$3
rm -rf build installed
cmake -S "$root" -B build "-DGUSSET_CARGO_TARGET_DIR=$target" >/dev/null
env -u MAKELEVEL -u MAKEFLAGS cmake --build build
cmake --install build --prefix "$PWD/installed" >/dev/null
diff -r "$prefix" installed || { echo "FAILED: other files than in $prefix" >&2; exit 1; }
# Nothing has changed: nothing is staged anew.
before=$(stat -c %y build/stage/lib/libgusset.a)
env -u MAKELEVEL -u MAKEFLAGS cmake --build build
after=$(stat -c %y build/stage/lib/libgusset.a)
[ "$before" = "$after" ] || { echo "FAILED: staged again, at $after after $before" >&2; exit 1; }
echo 'the same files'
