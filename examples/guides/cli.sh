#!/bin/sh
# The commands of docs/guides/cli.md, sections.md and plugin.md, where left.obj and right.obj are and gusset is on the path; the results go where it is run.
set -eu

#! [first]
gusset check left.obj
gusset stitch left.obj right.obj -o joined.ply
gusset fill joined.ply --smooth -o whole.glb
#! [first]

#! [smooth]
gusset stitch left.obj right.obj --smooth -o smooth.obj
#! [smooth]

#! [run]
gusset filters
gusset filters stitch left.obj right.obj
gusset run boundary_loops left.obj -o rim.obj
gusset run stitch left.obj right.obj -p finish=blend -o joined.obj
#! [run]

#! [repair]
gusset repair joined.obj -o repaired.obj
#! [repair]

#! [unite]
gusset unite repaired.obj whole.glb -o solid.obj
#! [unite]

#! [certificate]
gusset fill left.obj -o full.obj --certificate full.json
gusset certify left.obj right.obj joined.obj -o joined.json
#! [certificate]

#! [scans]
gusset join left.obj right.obj --align --overlaps trim --holes fill -o model.ply
#! [scans]

#! [section]
gusset section left.obj --direction 0,0,1 --number 5 -o outlines.obj
#! [section]

#! [json]
gusset check joined.obj --json
#! [json]
grep -q '^f ' joined.obj
grep -q '^f ' smooth.obj
grep -q '^l ' rim.obj
grep -q '^l ' outlines.obj
test -s whole.glb
grep -q '"kept_faces"' full.json joined.json
