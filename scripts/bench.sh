#!/usr/bin/env bash
# make bench: builds the benchmarks against the installation in $1 and runs those whose names contain $2. The remaining
# arguments are the Debian packages it needs.
set -euo pipefail
cd "$(dirname "$0")/.."
stage=$1 only=$2
shift 2
scripts/install-packages.sh "$@"
cmake -S cpp_tests/bench -B build/bench -DGUSSET_PREFIX="$stage" >build/bench.log 2>&1 &&
  env -u MAKELEVEL -u MAKEFLAGS cmake --build build/bench --parallel 2 >>build/bench.log 2>&1 ||
  { tail -n 40 build/bench.log; exit 1; }
mkdir -p target/bench
# A real mesh under CC0, from CGAL's own collection.
archive=$(dpkg -L libcgal-demo libcgal-dev | grep '/data\.tar\.gz$' | head -n 1)
tar -xzf "$archive" -C target/bench --strip-components=2 data/meshes/elephant.off
build/bench/bench --mesh target/bench/elephant.off --only "$only" --out target/bench/report.json
echo "the report is $PWD/target/bench/report.json"
