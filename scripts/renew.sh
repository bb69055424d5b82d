#!/usr/bin/env bash
# Replaces the folder $2 by the folder $1, which is removed. Unchanged files keep their time.
set -euo pipefail
from=$1 to=$2
mkdir -p "$to"
list() { (cd "$1" && find . "${@:2}" | LC_ALL=C sort); }
same() {
  if [ -L "$1" ] || [ -L "$2" ]; then
    [ "$(readlink "$1")" = "$(readlink "$2")" ]
  else
    [ "$(stat -c %a "$1")" = "$(stat -c %a "$2" 2>/dev/null)" ] && cmp -s "$1" "$2"
  fi
}
LC_ALL=C comm -13 <(list "$from") <(list "$to") | while IFS= read -r gone; do rm -rf "${to:?}/$gone"; done
list "$from" -type d | while IFS= read -r folder; do mkdir -p "$to/$folder"; done
list "$from" ! -type d | while IFS= read -r file; do
  same "$from/$file" "$to/$file" || { rm -rf "${to:?}/$file" && mv "$from/$file" "$to/$file"; }
done
rm -rf "$from"
