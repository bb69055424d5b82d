#!/usr/bin/env bash
# make check-wheel: installs the wheel into a new environment without Rust, and runs the README's lines and the tests.
set -euo pipefail
cd "$(dirname "$0")/.."
venv=$(mktemp -d)
trap 'rm -rf "$venv"' EXIT
python3 -m venv "$venv/env"
pip() { "$venv/env/bin/pip" install -q --disable-pip-version-check --only-binary :all: "$@"; }
PATH=/usr/bin:/bin pip target/wheels/*.whl
PATH=/usr/bin:/bin "$venv/env/bin/python" -B examples/python/first.py
pip -c python/requirements.txt -c python/requirements-hosts.txt pytest trimesh pyvista vtk
# PyVista finds the accessor by itself.
"$venv/env/bin/python" -B examples/python/pieces.py
cp -r python/tests "$venv/tests"
cd "$venv" && env/bin/python -B -m pytest -q -p no:cacheprovider tests --deselect tests/test_filters.py::test_generated_files_are_up_to_date --deselect tests/test_filters.py::test_types
