#!/bin/sh
# The commands of the README, where stitch.c is.
set -eu

#! [commands]
cc stitch.c -I$HOME/gusset/include -L$HOME/gusset/lib -lgusset -Wl,-rpath,$HOME/gusset/lib -o stitch
./stitch
#! [commands]
