"""Checked by mypy, never run: what the types of the package promise."""

from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

import gusset_mesh as gm

points: NDArray[np.float64] = np.zeros((3, 3))
mesh = gm.Mesh(points, [[0, 1, 2]])
loops = gm.boundary_loops(mesh, survey="boundary_only")
made = gm.stitch((points, [[0, 1, 2]]), mesh, finish="blend", rows="count", row_count=2, threads=1)
joined: gm.Mesh = made.mesh
values: NDArray[Any] = made.carry([points, points], "vertices", "normal")
whole: gm.Mesh = gm.join([mesh, joined], fill=True, weld_options={"tolerance": 0.1}).mesh
curve: gm.Curve = gm.Outline([[0, 0], [1, 1]], method="median").curve
surface = gm.Surface(gm.Sheet(np.zeros((4, 4, 3))))
paths: gm.Paths = surface.section([0, 0, 0], [0, 0, 1], spacing="chord", chord=0.1)
net: Optional[gm.Net] = gm.Net(np.zeros((2, 2, 3)), sides=["rows_closed", "pole_top"])
report = gm.filters.all_filters["check"](mesh)
