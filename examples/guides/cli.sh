#!/bin/sh
# The commands of docs/guides/cli.md and plugin.md, where left.obj and right.obj are and gusset is on the path; the results go where it is run.
set -eu

#! [first]
gusset check left.obj
gusset stitch left.obj right.obj -o joined.ply
gusset fill joined.ply --inside refined-and-fair -o whole.glb
#! [first]

#! [smooth]
gusset stitch left.obj right.obj --finish blend -o smooth.obj
#! [smooth]

#! [run]
gusset filters
gusset filters stitch left.obj right.obj
gusset run boundary_loops left.obj -o rim.obj
gusset run stitch left.obj right.obj -p finish=Blend -o joined.obj
#! [run]

#! [scans]
gusset assemble left.obj right.obj --align --overlaps trim --holes fill -o model.ply
#! [scans]

#! [json]
gusset check joined.obj --json
#! [json]
grep -q '^f ' joined.obj
grep -q '^f ' smooth.obj
grep -q '^l ' rim.obj
test -s whole.glb
