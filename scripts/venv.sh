#!/usr/bin/env bash
# Makes the virtual environment $1 with the packages of the following lists, which have the versions, unless it has
# them already.
set -euo pipefail
venv=$1
shift
cmp -s <(cat "$@") "$venv/list.txt" && exit 0
echo "gusset: about to install from PyPI into $venv: $(sed -n 's/^\([A-Za-z0-9_-]*\)[=<>].*/\1/p' <(cat "$@") | paste -sd' ')"
rm -rf "$venv"
python3 -m venv "$venv"
"$venv/bin/pip" install -q --disable-pip-version-check --only-binary :all: "${@/#/--requirement=}" >"$venv/log" 2>&1 || { tail -n 5 "$venv/log" >&2; exit 1; }
cat "$@" >"$venv/list.txt"
