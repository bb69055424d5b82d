#!/bin/sh
# No build system: the compiler is told where the static library lies, and the system libraries that docs/guides/linking.md names.
#   build.sh PREFIX
set -eux
sources=$(dirname "$0")/..
system='-Wl,--gc-sections -lgcc_s -lutil -lrt -lpthread -lm -ldl -lc'
# Word by word.
# shellcheck disable=SC2086
cc -std=c99 -I"$1/include" "$sources/app.c" "$1/lib/libgusset.a" $system -o app_c
c++ -std=c++17 -I"$1/include" "$sources/app.cpp" "$1/lib/libgusset.a" $system -o app_cpp
cc -std=c99 -I"$1/include" -fPIC -shared -fvisibility=hidden "$sources/plugin.c" "$1/lib/libgusset.a" $system \
  -Wl,-z,nodelete -Wl,--exclude-libs,libgusset.a -o plugin.so
cc -std=c99 "$sources/host.c" -lpthread -ldl -o host
./app_c | grep -x '10 vertices, 16 faces'
./app_cpp | grep -x '10 vertices, 16 faces'
./host ./plugin.so
