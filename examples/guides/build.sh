#!/bin/sh
# The commands of docs/guides/c.md; pkg-config must know gusset. Programs go where this is run.
set -eu
guides=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
cp "$guides/start.c" .

#! [shared]
cc -std=c99 start.c $(pkg-config --cflags --libs gusset) "-Wl,-rpath,$(pkg-config --variable=libdir gusset)" -o start
./start
#! [shared]

#! [static]
cc -std=c99 start.c $(pkg-config --cflags gusset) "$(pkg-config --variable=libdir gusset)/libgusset.a" \
  -Wl,--gc-sections -lgcc_s -lutil -lrt -lpthread -lm -ldl -lc -o start-static
#! [static]

./start-static
