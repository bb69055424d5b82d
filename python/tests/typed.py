"""Checked by mypy, never run: what the types of the package promise."""

from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray
from typing_extensions import assert_type

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
paths: gm.SurfacePaths = surface.section([0, 0, 0], [0, 0, 1], spacing="chord", chord=0.1)
net: Optional[gm.Net] = gm.Net(np.zeros((2, 2, 3)), sides=["rows_closed", "pole_top"])
report = gm.filters.all_filters["check"](mesh)


def cuts() -> None:
    """Sections have their types."""
    cut: gm.MeshSections = gm.sections(mesh, [0, 0, 0], [0, 0, 1], [0.5, 1.0], in_plane="below", tolerance=0.1)
    outline: NDArray[np.float64] = cut[0]
    around = gm.sections_about_axis(mesh, [0, 0, 0], [0, 0, 1], [1, 0, 0], [0.5], threads=1)
    across: gm.MeshSections = gm.sections_across(mesh, points, [0.5], closed=True)
    areas: NDArray[np.float64] = gm.sections_by_planes(mesh, [gm.Plane([0, 0, 1], [0, 0, 1])]).paths.area


def documents() -> None:
    """Files have their types."""
    document: gm.Document = gm.read("a.ply", scene=True)
    assert_type(document.meshes[0].mesh, gm.Mesh)
    assert_type(document.meshes[0].vertex_colours, Optional[NDArray[Any]])
    assert_type(document.points, Optional[gm.files.Points])
    losses: list[str] = gm.save("b.ply", gm.FileMesh(document.mesh, normals=points, normals_at="corners"), text=True)
    losses += gm.save("c.glb", gm.join([document, gm.read("d.ply")]), lossy=True) + gm.save("e.obj", gm.Curves(points))
    gm.FileMesh(mesh, normals_at="faces")  # type: ignore[arg-type]


def reports() -> None:
    """The fields of reports have their types."""
    filled = gm.fill(mesh)
    assert_type(filled.report, gm.FillReport)
    assert_type(filled.report.weights, NDArray[np.float64])
    assert_type(filled.report.intersections_known, bool)
    assert_type(filled.report.holes, gm.HoleArray)
    assert_type(filled.holes.status, NDArray[np.str_])
    assert_type(filled.holes[0], gm.Hole)
    assert_type(filled.holes[0].status, gm.choices.HoleStatus)
    assert_type(filled.holes[filled.holes.length > 1].length, NDArray[np.float64])
    assert_type(made.report.vertex_map, tuple[NDArray[np.uint32], NDArray[np.uint32]])
    assert_type(gm.join([mesh]).joints[0].side[1], NDArray[np.uint32])
    assert_type([loop.edge_flags["reversed"] for loop in loops], list[NDArray[np.bool_]])
    assert_type(surface.nearest(points).place.u, NDArray[np.float64])
    assert_type("closed" in gm.check(mesh).report.properties, bool)
    # Unknown names are errors, and unknown words of a choice, too.
    filled.report.wholes  # type: ignore[attr-defined]
    surface.nearest(points).flags["certain"]  # type: ignore[index]
    filled.holes[0].status == "full"  # type: ignore[comparison-overlap]
ring: gm.Net = gm.Net.primitive(shape="torus", radius=2, minor_radius=0.5).deform(gm.fields.twist("z", 0.1).with_keys([0, 1], [0, 1], "smooth"), time=0.5)
planar, planarity = ring.glue(gm.LocalGluing.star(3, "east"))[1:4, :].planarise(keep_boundary=True)
deviation: float = planarity.deviation_after
kinds: NDArray[np.str_] = planar.gluing_occurrences().kind
decimated: gm.Net = ring.decimate(0.1).net
rest: bool = gm.Net.concatenate([ring, ring]).set_bridge(0, "hide", tension=1.0).settle(free=[True, False])[1].converged
euler: int = ring.complex(cells="present").report.euler
scene_entries: NDArray[np.uint32] = gm.Scene().world_transforms().entry
again: gm.Net = gm.Net.decode(ring.encode(mode="quantised", bits=12))
frame = gm.Frame([np.eye(3), np.eye(3) + 1], closed=True, correspondence="arc_length", columns=8)
girth: float = frame.slice([0.8, 0.8, 0.8], [1, 1, 1]).curve.length
skin: gm.Sheet = gm.Sheet.from_curves([frame.curve_across(0), frame.curve_across(1)])
moved: gm.Sheet = skin.offset(0.1)[0]
bound: float = surface.distance(gm.Plane([0, 0, 1], [0, 0, 1])).bound
hit_points: NDArray[np.float64] = surface.first_hits(points, np.eye(3)).point
crossings: NDArray[np.float64] = frame.curve_across(0).part(0.5, 1.5).intersect_line([0, 0, 0], [1, 0, 0]).points
loops_of_edges: list[NDArray[np.uint32]] = gm.winged(mesh, winding="clockwise").loops
