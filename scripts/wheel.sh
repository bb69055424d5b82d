#!/usr/bin/env bash
# make wheel: builds the wheel of the Python package into target/wheels. Arguments: passed to maturin, which passes
# them to cargo.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/venv.sh build/python python/requirements.txt
export PATH="$PWD/build/python/bin:$PATH"
(cd python && python -B -c 'import build_backend; build_backend.prepare()')
rm -rf target/wheels
(cd python && maturin build --release --strip --out ../target/wheels --interpreter "$PWD/../build/python/bin/python" "$@")
