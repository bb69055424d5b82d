#!/usr/bin/env bash
# make figures: builds the program that draws the figures of the papers against the installation in $1, and redraws
# docs/figures with equal bytes. The remaining arguments are the Debian packages it needs.
set -euo pipefail
cd "$(dirname "$0")/.."
stage=$1
shift
scripts/install-packages.sh "$@"
cmake -S examples/figures -B build/figures -DGUSSET_PREFIX="$stage" >build/figures.log 2>&1 &&
  env -u MAKELEVEL -u MAKEFLAGS cmake --build build/figures --parallel 2 >>build/figures.log 2>&1 || { tail -n 40 build/figures.log; exit 1; }
mkdir -p docs/figures
build/figures/figures docs/figures
