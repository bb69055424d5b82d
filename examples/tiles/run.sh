#!/bin/sh
# The commands of docs/guides/tiles.md, where tiles, tiles_gather and mpirun are on the path; the results go where it is run.
# MPI=... stands for mpirun with options of its own.
set -eu
mpirun() { command ${MPI:-mpirun} "$@"; }

#! [first]
tiles --tiles 4 4 --cells 60 --gap --out apart
tiles_gather apart
#! [first]

#! [ranks]
mpirun -n 4 tiles --tiles 4 4 --cells 60 --gap
#! [ranks]

#! [disk]
mpirun -n 2 tiles --tiles 4 4 --cells 60 --gap --in-memory 1 --scratch blocks
#! [disk]

#! [files]
tiles --tiles 4 4 --cells 60 --gap --save-input scans
mpirun -n 2 tiles --tiles 4 4 --cells 60 --gap --input scans --in-memory 1 --scratch blocks
#! [files]
