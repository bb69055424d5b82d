#!/bin/sh
# The commands of the README, where stitch.c is.
set -eu

#! [commands]
export PKG_CONFIG_PATH=$HOME/gusset/lib/pkgconfig
cc stitch.c $(pkg-config --cflags --libs gusset) -Wl,-rpath,$HOME/gusset/lib -o stitch
./stitch
#! [commands]
