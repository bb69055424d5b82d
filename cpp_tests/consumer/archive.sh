#!/usr/bin/env bash
# The archive of `make dist`: one folder that belongs to nobody, has what an installation has, and tells nothing of where it was made.
#   archive.sh ARCHIVE PREFIX ROOT    PREFIX: an installation of the same build; ROOT: the sources
set -euo pipefail
archive=$1 prefix=$2 root=$(realpath "$3")
fail() { echo "FAILED: $*" >&2; exit 1; }
(cd "$(dirname "$archive")" && sha256sum --check --quiet "$(basename "$archive").sha256")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

name=$(basename "$archive" .tar.gz)
list=$(tar -tzf "$archive" --numeric-owner -v)
foreign=$(awk -v name="$name/" '$2 != "0/0" || index($6, name) != 1' <<<"$list")
[ -z "$foreign" ] || fail "not of root's, or outside $name: $foreign"
tar -xzf "$archive" -C "$work"
[ -f "$work/$name/CMakeLists.txt" ] || fail 'no CMakeLists.txt'
for folder in include lib share/doc/gusset share/gusset; do
  diff -r "$prefix/$folder" "$work/$name/$folder" || fail "other files than in $prefix/$folder"
done
for place in "$root" "$HOME" "${CARGO_HOME:-$HOME/.cargo}" "$(hostname)"; do
  # A word that short would be found anywhere.
  [ "${#place}" -gt 5 ] || continue
  told=$(grep -rlF -- "$place" "$work/$name" || true)
  [ -z "$told" ] || fail "$place is told by $told"
done
echo "$name: $(wc -l <<<"$list") entries, $(stat -c %s "$archive") bytes"
