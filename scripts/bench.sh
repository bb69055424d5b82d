#!/usr/bin/env bash
# make bench: builds the benchmarks against the installation in $1 and runs those whose names contain $2; if $3 is not
# empty, also the slow cases. $4: the library of files. The remaining arguments are the Debian packages it needs. Python peers go into a virtual
# environment; a peer that cannot be installed is reported as absent. A full run also writes docs/benchmarks.md and
# docs/benchmarks.svg.
set -euo pipefail
cd "$(dirname "$0")/.."
stage=$1 only=$2 slow=$3 files=$4
shift 4
scripts/install-packages.sh "$@"
CARGO_TARGET_DIR=build/parry cargo build -q --release --locked --manifest-path bench/parry/Cargo.toml
cmake -S cpp_tests/bench -B build/bench -DGUSSET_PREFIX="$stage" >build/bench.log 2>&1 &&
  env -u MAKELEVEL -u MAKEFLAGS cmake --build build/bench --parallel 2 >>build/bench.log 2>&1 ||
  { tail -n 40 build/bench.log; exit 1; }

venv=build/bench-peers
if ! cmp -s bench/pins.txt "$venv/pins.txt"; then
  echo "gusset: about to install from PyPI into $venv, with their pinned versions: numpy matplotlib fonttools scipy trimesh meshlib trueform open3d-cpu vtk pyvista DracoPy pymeshfix pymeshlab manifold3d bpy"
  rm -rf "$venv"
  python3 -m venv "$venv"
  peers() { "$venv/bin/pip" install -q --disable-pip-version-check --only-binary :all: -c bench/pins.txt "$@" >>"$venv/log" 2>&1; }
  peers numpy matplotlib fonttools || { tail -n 5 "$venv/log"; exit 1; }
  for peer in scipy trimesh meshlib trueform open3d-cpu vtk pyvista DracoPy pymeshfix pymeshlab manifold3d bpy; do
    peers "$peer" || echo "gusset: $peer cannot be installed for $(python3 --version), and will be reported as absent: $venv/log"
  done
  cp bench/pins.txt "$venv/pins.txt"
fi
# Open CASCADE for Python is a gigabyte: installed only on request.
ocp() {
  local venv=build/bench-$1
  cmp -s bench/pins.txt "$venv/pins.txt" && return
  echo "gusset: about to install from PyPI into $venv: $2"
  rm -rf "$venv"
  python3 -m venv "$venv"
  "$venv/bin/pip" install -q --disable-pip-version-check --only-binary :all: "$2" >"$venv/log" 2>&1 ||
    { rm "$venv/bin/python"; echo "gusset: $2 cannot be installed for $(python3 --version), and will be reported as absent: $venv/log"; }
  cp bench/pins.txt "$venv/pins.txt"
}
case $only in
  '' | *carcass* | *spline* | *ssi*)
    ocp ocp-7.8.1 "$(grep ^cadquery-ocp bench/pins.txt)"
    ocp ocp-newest cadquery-ocp
    ;;
esac

mkdir -p target/bench
options=(--only "$only")
[ -z "$slow" ] || options+=(--slow)
[ -n "$only" ] || options+=(--docs docs)
# SciPy solves small systems, which its threads only slow down.
OPENBLAS_NUM_THREADS=1 "$venv/bin/python" bench/run.py --prefix "$stage" --files "$files" --tools build/bench --out target/bench/report.json "${options[@]}"
