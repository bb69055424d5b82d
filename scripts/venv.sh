#!/usr/bin/env bash
# Makes the virtual environment $1 with the Python packages of the list $2, unless it has them already; their versions are in the list.
set -euo pipefail
venv=$1 list=$2
cmp -s "$list" "$venv/list.txt" && exit 0
echo "gusset: about to install from PyPI into $venv: $(sed -n 's/^\([A-Za-z0-9_-]*\)[=<>].*/\1/p' "$list" | paste -sd' ')"
rm -rf "$venv"
python3 -m venv "$venv"
"$venv/bin/pip" install -q --disable-pip-version-check --only-binary :all: -r "$list" >"$venv/log" 2>&1 || { tail -n 5 "$venv/log" >&2; exit 1; }
cp "$list" "$venv/list.txt"
