#!/usr/bin/env bash
# make check-dist: checks that a clone of this checkout in another folder makes the archive $1 with equal bytes.
# Builds the library again.
set -euo pipefail
cd "$(dirname "$0")/.."
archive=$1
[ -z "$(git status --porcelain)" ] || { echo 'gusset: a clone has what is committed only: commit first' >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git clone -q . "$work/a-folder-of-another-name"
cd "$work/a-folder-of-another-name"
env -u CARGO_TARGET_DIR -u MAKELEVEL -u MAKEFLAGS make --no-print-directory -s dist
sha256sum "$archive" "build/dist/${archive##*/}"
cmp "$archive" "build/dist/${archive##*/}" || { echo 'FAILED: the bytes differ' >&2; exit 1; }
echo 'the same bytes'
