#!/usr/bin/env bash
# The site of the C and C++ interface, into build/docs/html; any warning of doxygen's is an error.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build
doxygen docs/Doxyfile
echo "build/docs/html/index.html"
