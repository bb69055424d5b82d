#!/usr/bin/env bash
# Writes the site of the C and C++ interface into build/docs/html. Warnings of doxygen and broken links are errors.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build
rm -rf build/docs/html
{ cat docs/Doxyfile; echo EXCLUDE = include/gusset_plugin.h $(ls include/gusset/*.h | grep -v views.h); } | doxygen -
python3 -B scripts/links.py build/docs/html README.md CHANGELOG.md CONTRIBUTING.md ARCHITECTURE.md docs/*.md docs/decisions/*.md docs/guides/*.md
echo "build/docs/html/index.html"
