#!/usr/bin/env bash
# Writes the site of the C and C++ interface into build/docs/html. Warnings of doxygen and broken links are errors.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build/docs
rm -rf build/docs/html
# The classes that pages may name: scripts/reference_pages.py reads them.
{ cat docs/Doxyfile; printf '%s\n' 'INPUT = include' 'FILE_PATTERNS = *.hpp' 'GENERATE_HTML = NO' 'WARN_AS_ERROR = NO' \
  'GENERATE_TAGFILE = build/docs/classes.xml'; } | doxygen - 2>/dev/null # it warns below
{ cat docs/Doxyfile; echo EXCLUDE = include/gusset_files.h include/gusset_plugin.h include/gusset/choices.hpp $(ls include/gusset/*.h | grep -v views.h); } | doxygen -
python3 -B scripts/links.py build/docs/html README.md CHANGELOG.md CONTRIBUTING.md ARCHITECTURE.md docs/*.md docs/decisions/*.md docs/guides/*.md
echo "build/docs/html/index.html"
