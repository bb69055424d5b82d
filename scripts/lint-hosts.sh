#!/usr/bin/env bash
# make lint-hosts: compiles each header by gcc and by clang, and each example in C++ by itself. Tests compile many examples as one file,
# where one may depend on an include of another. $1: an installation of the headers.
set -euo pipefail
cd "$(dirname "$0")/.."
prefix=$PWD/$1
scripts/headers.sh "$prefix" gcc g++ parts
scripts/headers.sh "$prefix" clang clang++

one() { # An example, then the folders of headers.
  g++ -std=c++17 -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror "-I$2" -isystem "$3" "$1" ||
    { echo "FAILED: $1 by itself" >&2; return 1; }
}
export -f one
reader=$(find /usr/include /usr/local/include -path '*libfccp/csv.h' -printf '%h\n' -quit 2>/dev/null || true)
examples=$(ls examples/{cpp,workshop,pictures,figures,demo}/*.cpp)
xargs -P "$(nproc)" -I% bash -c 'one "$@"' one % "$prefix/include" "${reader:-/usr/include}" <<<"$examples"
echo "$(wc -l <<<"$examples") examples, each by itself"
