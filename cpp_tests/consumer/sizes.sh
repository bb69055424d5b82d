#!/usr/bin/env bash
# Sizes of an installation, of the README's program with the static library, and of a program that only stitches.
#   sizes.sh PREFIX STITCH_C
set -euo pipefail
prefix=$1 source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
program() { # Compiles and runs a source.
  cc -O2 "-I$prefix/include" "$1" "$prefix/lib/libgusset.a" -Wl,--gc-sections -lgcc_s -lutil -lrt -lpthread -lm -ldl -lc -o "$2"
  "$2"
}
sed 's/gusset_join(NULL, pieces, 2, NULL, &result)/gusset_stitch(NULL, pieces, NULL, pieces + 1, NULL, NULL, \&result)/' "$source" >"$folder/stitch.c"
cmp -s "$source" "$folder/stitch.c" && { echo "FAILED: $source does not join" >&2; exit 1; }
program "$source" "$folder/join"
program "$folder/stitch.c" "$folder/stitch"
at_most() { # bytes file
  local size
  size=$(stat -L -c %s "$2")
  echo "$(basename "$2"): $size bytes of $1"
  [ "$size" -le "$1" ] || { echo "FAILED: too large" >&2; exit 1; }
}
at_most 12250000 "$prefix/lib/libgusset.so"
at_most 40000000 "$prefix/lib/libgusset.a"
# Joining includes filling and all that follows it.
at_most 3700000 "$folder/join"
at_most 2140000 "$folder/stitch"
