#!/bin/sh
# The commands of docs/guides/c.md and cpp.md for a project with CMake, where gusset is in $HOME/gusset; the project goes where this is run.
set -eu
guides=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
cp "$guides/start.c" "$guides/start.cpp" .
sed -n '/! \[project\]/,/! \[project\]/p' "$guides/CMakeLists.txt" > CMakeLists.txt

#! [configure]
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=$HOME/gusset
cmake --build build
#! [configure]
build/start_c
