#!/usr/bin/env bash
# make cli: puts the program $1, its manual and its completions into the folder $3, with a link to the library in $2.
set -euo pipefail
cd "$(dirname "$0")/.."
built=$1 library=$2 folder=$3
mkdir -p "$folder"
install -C -m 755 "$built" "$folder/gusset"
for file in "$library"/libgusset.so.*; do
  ln -sfr "$file" "$folder/$(basename "$file")"
done
for page in man:gusset.1 bash:gusset.bash zsh:_gusset fish:gusset.fish; do
  "$folder/gusset" generate "${page%%:*}" >"$folder/${page#*:}"
done
