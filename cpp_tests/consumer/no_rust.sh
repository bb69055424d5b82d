#!/bin/sh
# Stands in for cargo and rustc where nobody may call them.
echo "FAILED: $(basename "$0") was called, which this must do without" >&2
exit 1
