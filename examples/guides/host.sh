#!/bin/sh
# The commands of docs/guides/plugin.md, where left.obj and right.obj are and gusset-host is on the path; the result goes where it is run.
set -eu

#! [commands]
gusset-host list
gusset-host describe stitch left.obj right.obj
gusset-host run stitch left.obj right.obj -p rows="By mean edge" -p fairing=Fair -o joined.obj
gusset-host run boundary_loops left.obj -o rim.obj
#! [commands]
grep -q '^f ' joined.obj
grep -q '^l ' rim.obj
