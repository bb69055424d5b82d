"""Inputs that once broke the package."""

import copy
import pickle
import subprocess
import sys

import numpy as np
import pytest
import shapes
import trimesh

import gusset_mesh as gm

TUBE = shapes.tube()
LOOPS = [loop.vertices for loop in gm.boundary_loops(TUBE)]


@pytest.mark.parametrize("groups", [[0], [], [1, 2, 3, 4]])
def test_arrays_of_options_have_their_lengths(groups):
    with pytest.raises(ValueError, match="groups"):
        gm.fill(TUBE, LOOPS, groups=groups)
    assert gm.fill(TUBE, LOOPS, groups=[0, 1]).mesh.face_count > 0


@pytest.mark.parametrize("viewpoints", [np.zeros((2, 1)), np.zeros(2), np.zeros(6)])
def test_viewpoints_have_three_coordinates(viewpoints):
    with pytest.raises(ValueError, match="viewpoints"):
        gm.trim([TUBE, TUBE], viewpoints=viewpoints)
    with pytest.raises(ValueError, match="viewpoints"):
        gm.join([TUBE, TUBE], trim_options={"viewpoints": viewpoints})


def test_meshes_are_looked_at_again():
    points, faces = shapes.cap()
    mesh = gm.Mesh(points, faces, merge=np.arange(len(points)))
    with pytest.raises(ValueError):
        mesh.with_points(np.concatenate([points] * 4))
    mesh.merge = np.arange(3, dtype=np.uint32)
    with pytest.raises(ValueError, match="merge"):
        gm.check(mesh)
    for name, value in (("points", points.tolist()), ("points", points[:, ::-1]), ("corners", faces.astype(np.int64).reshape(-1)), ("offsets", np.array([0, 10**6], np.uint32))):
        mesh = gm.Mesh(points, faces)
        setattr(mesh, name, value)
        with pytest.raises(ValueError):
            gm.check(mesh)
    offsets = np.arange(len(faces) + 1, dtype=np.uint32) * 3
    mesh = gm.Mesh.from_polygons(points, offsets, faces.reshape(-1))
    offsets[-1] += 3
    assert gm.check(mesh).report.face_count == len(faces)
    with pytest.raises(ValueError):
        gm.Mesh.from_polygons(points, [0, 3], [0, 1, 2, 3])
    curves = gm.Curves(points, [0, 3, 6])
    curves.closed = np.zeros(1, np.uint8)
    with pytest.raises(ValueError):
        gm.filters.outline(curves)


def test_loops_as_they_come():
    given = gm.boundary_loops(TUBE)
    assert gm.check(gm.fill(TUBE, given).mesh).is_closed
    assert gm.check(gm.fill(TUBE, (loop for loop in given)).mesh).is_closed
    assert gm.fill(TUBE, []).mesh.face_count == len(TUBE[1])
    for flat in (LOOPS[0], [0, 1, 2], [[]]):
        with pytest.raises(ValueError, match="loop"):
            gm.fill(TUBE, flat)


def test_a_thread_that_is_not_waited_for_ends_quietly():
    code = """
import threading, time, sys
sys.path.insert(0, {tests!r})
import gusset_mesh as gm
from test_calls import big
mesh = big(400)
for job in (lambda: gm.fill(mesh, refine="rim_density"), lambda: gm.filters.fill(mesh, finish="refined")):
    threading.Thread(target=job, daemon=True).start()
time.sleep(0.4)
"""
    made = subprocess.run([sys.executable, "-c", code.format(tests=shapes.__file__.rpartition("/")[0])], capture_output=True, text=True)
    assert made.returncode == 0, made.stderr


def test_filters_travel_and_results_say_that_they_do_not():
    assert pickle.loads(pickle.dumps(gm.filters.fill)) is gm.filters.fill
    for one in (gm.weld(TUBE), gm.weld(TUBE).report):
        with pytest.raises(TypeError, match="stays in its process"):
            copy.deepcopy(one)


def test_points_of_the_plane():
    angle = np.linspace(0, 3, 12)
    plane = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    assert np.allclose(gm.Outline(plane).curve.nearest(plane).distance, 0, atol=1e-12)
    with pytest.raises(ValueError):
        gm.Outline(plane).curve.nearest(angle)
    with pytest.raises(ValueError):
        gm.Outline(plane, corners=[1.7])


@pytest.mark.parametrize("value", [2**60 + 1, 2**63 - 1])
def test_wide_numbers_are_carried_bit_for_bit(value):
    made = gm.fill(TUBE)
    for dtype in (np.int64, np.uint64):
        assert (made.carry(np.full(len(TUBE[1]), value, dtype), "faces", "nearest")[:len(TUBE[1])] == value).all()
        with pytest.raises(ValueError, match="2\\^53"):
            made.carry(np.full(len(TUBE[1]), value, dtype), "faces", "linear")
    with pytest.raises(ValueError, match="there are"):
        made.carry(np.zeros(3), "edges")


def test_a_mode_comes_with_its_number():
    surface = gm.Surface(shapes.grid(16, 16, lambda u, v: np.sin(3 * u) * np.cos(2 * v), (3.0, 3.0)))
    counts = [len(surface.section([0, 0, 0.2], [0, 0, 1], **how).report.points) for how in ({}, {"chord": 1e-7})]
    assert counts[1] > 5 * counts[0]


@pytest.mark.parametrize("option", [{"plan_only": "no"}, {"max_edges": "7"}, {"max_edges": -1}, {"max_edges": 1.5}, {"weight": ["area"]}])
def test_options_of_other_types(option):
    with pytest.raises((TypeError, ValueError), match=next(iter(option))):
        gm.fill(TUBE, **option)


def test_small_meshes_can_be_interrupted():
    class Enough(Exception):
        pass

    def stop(part, what):
        raise Enough

    with pytest.raises(Enough):
        gm.fill(TUBE, refine="rim_density", progress=stop)


def test_grids_with_any_strides():
    nodes = shapes.grid(6, 9, lambda u, v: u * v)
    for array in (nodes.transpose(1, 0, 2), nodes[::-1], np.broadcast_to(nodes[:1], (4, 9, 3)) + np.arange(4)[:, None, None]):
        assert gm.Net(array).shape == array.shape[:2]
        gm.Sheet(array)
    assert np.array_equal(gm.Net(np.broadcast_to(nodes[:1], (4, 9, 3))).nodes, np.broadcast_to(nodes[:1], (4, 9, 3)))


def test_every_report_can_be_read():
    net = gm.Net(shapes.grid(6, 9))
    made = [gm.stitch(shapes.cap(), shapes.cap(-1)), gm.fill(TUBE), gm.weld(TUBE), gm.sew(TUBE), gm.orient(TUBE), gm.check(TUBE),
            gm.join([TUBE]), gm.develop(TUBE), gm.align([TUBE, TUBE]), gm.trim([TUBE, TUBE]), net.mesh(texture=True), gm.Sheet(net.nodes),
            gm.Surface(net.nodes), gm.Sheet(net.nodes).mesh(), gm.Surface(net.nodes).section([0, 0, 0], [1, 0, 0.1]),
            gm.Outline([[0, 0], [1, 1], [2, 0]]), gm.Outline([[0, 0], [1, 1], [2, 0]]).curve]
    for one in made:
        assert repr(one.report).startswith(f"{type(one).REPORT.__name__}(")
    assert net.mesh(texture=True).report.texture_coordinates.shape[1] == 2


def test_pyvista_datasets():
    pv = pytest.importorskip("pyvista")
    import gusset_mesh.pyvista  # noqa: F401

    assert gm.check(pv.Sphere().cast_to_unstructured_grid()).is_closed
    half = pv.Sphere().clip("z")
    half.point_data["gappy"] = np.where(np.arange(half.n_points) % 7, 1.0, np.nan)
    filled = half.gusset.fill()
    assert np.isnan(filled.point_data["gappy"]).any()
    curves, report = pv.Line(resolution=5).gusset.outline()
    assert curves.n_lines == 1
    assert half.gusset.join(trimesh.creation.icosphere()).n_cells > half.n_cells


SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
NODES = np.stack([*np.meshgrid(np.arange(5.0), np.arange(4.0), indexing="ij"), np.zeros((5, 4))], axis=2)
BAR = gm.Curve.through(SQUARE)
RINGS = [SQUARE + [0, 0, z] for z in (0, 1, 2)]
TAKES_NUMBERS = {
    "points of meshes": lambda numbers: gm.check((numbers(SQUARE), [[0, 1, 2, 3]])),
    "points of polygons": lambda numbers: gm.Mesh.from_polygons(numbers(SQUARE), [0, 4], [0, 1, 2, 3]),
    "points of curves": lambda numbers: gm.Curve.through(numbers(SQUARE)),
    "controls": lambda numbers: gm.Curve.from_controls(numbers(SQUARE), [0, 3]),
    "outlines": lambda numbers: gm.Outline(numbers(SQUARE)),
    "sections of frames": lambda numbers: gm.Frame([numbers(ring) for ring in RINGS], closed=True),
    "distances of frames": lambda numbers: gm.Frame(RINGS, closed=True).offset(numbers([0.5, 0.5, 0.5])),
    "queries of curves": lambda numbers: BAR.nearest(numbers(SQUARE)),
    "lengths": lambda numbers: BAR.places_at(numbers([0.1, 0.2])),
    "vectors": lambda numbers: BAR.intersect_plane(numbers([0.5, 0, 0]), [1, 0, 0]),
    "nodes of nets": lambda numbers: gm.Net(numbers(NODES)),
    "heights": lambda numbers: gm.Net.from_heights(numbers(NODES[..., 0])),
    "nodes of sheets": lambda numbers: gm.Sheet(numbers(NODES)),
    "offsets of sheets": lambda numbers: gm.Sheet(NODES).offset(numbers([0.5])),
    "queries of surfaces": lambda numbers: gm.Surface(gm.Sheet(NODES)).nearest(numbers(SQUARE)),
    "parameters": lambda numbers: gm.Surface(gm.Sheet(NODES)).evaluate(numbers([[0.5, 0.5]])),
    "lines": lambda numbers: gm.Surface(gm.Sheet(NODES)).hits(numbers([0.5, 0.5, -1]), [0, 0, 1]),
    "offsets of planes": lambda numbers: gm.sections(TUBE, [0, 0, 0.1], [0, 0, 1], numbers([0.0])),
    "ratios": lambda numbers: gm.Net(NODES).scale(numbers(2.0)[()]),
    "tolerances": lambda numbers: gm.Net(NODES).decimate(numbers(0.1)[()]),
    "viewpoints": lambda numbers: gm.trim([TUBE, TUBE], viewpoints=numbers(np.zeros((2, 3)))),
}


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", TAKES_NUMBERS)
def test_complex_numbers_are_refused(name):
    TAKES_NUMBERS[name](np.asarray)
    with pytest.raises((TypeError, ValueError), match="complex"):
        TAKES_NUMBERS[name](lambda numbers: np.asarray(numbers) + 1j)
