#!/usr/bin/env bash
# What an installation weighs, and the README's program with the static library.
#   sizes.sh PREFIX STITCH_C
set -euo pipefail
prefix=$1 source=$2
program=$(mktemp)
trap 'rm -f "$program"' EXIT
cc -O2 "-I$prefix/include" "$source" "$prefix/lib/libgusset.a" -Wl,--gc-sections -lgcc_s -lutil -lrt -lpthread -lm -ldl -lc -o "$program"
"$program"
at_most() { # bytes file
  local size
  size=$(stat -L -c %s "$2")
  echo "$(basename "$2"): $size bytes of $1"
  [ "$size" -le "$1" ] || { echo "FAILED: too large" >&2; exit 1; }
}
at_most 11600000 "$prefix/lib/libgusset.so"
at_most 40000000 "$prefix/lib/libgusset.a"
at_most 2100000 "$program"
