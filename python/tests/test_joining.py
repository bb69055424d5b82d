"""The main jobs, judged by trimesh and by formulas."""

import numpy as np
import pytest
import shapes
import trimesh

import gusset_mesh as gm
from gusset_mesh.trimesh import to_trimesh


def test_loops_of_a_tube():
    loops = gm.boundary_loops(shapes.tube(columns=24))
    assert len(loops) == 2
    for loop in loops:
        assert len(loop.vertices) == len(loop.half_edges) == 24
        assert loop.length == pytest.approx(48 * np.sin(np.pi / 24))
    assert loops[-1].vertices.tolist() == loops[1].vertices.tolist()
    with pytest.raises(IndexError):
        loops[2]


@pytest.mark.parametrize("finish", ["strip", "blend"])
def test_stitched_caps_are_a_ball(finish):
    made = gm.stitch(shapes.cap(), shapes.cap(-1), finish=finish, outward="closed")
    ball = to_trimesh(made.mesh)
    assert ball.is_watertight and ball.is_winding_consistent and ball.euler_number == 2
    assert 0.93 * 4 / 3 * np.pi < ball.volume < 4 / 3 * np.pi
    assert made.report.strip_face_count == made.strip.face_count > 0
    radius = np.linalg.norm(made.mesh.points, axis=1)
    assert radius.max() < 1.001 and radius.min() > 0.97
    assert made.quality.min_angle > 0


def test_chosen_loops_and_one_mesh():
    a, b = shapes.tube(z=0), shapes.tube(z=1.5)
    loops = [list(gm.boundary_loops(one)) for one in (a, b)]
    top = max(loops[0], key=lambda loop: a[0][loop.vertices, 2].mean())
    bottom = min(loops[1], key=lambda loop: b[0][loop.vertices, 2].mean())
    made = gm.stitch(a, b, loop_a=top.vertices, loop_b=bottom.vertices)
    assert gm.check(made.mesh).report.euler == 0
    assert len(gm.boundary_loops(made.mesh)) == 2
    torus = gm.stitch(made.mesh)
    assert gm.check(torus.mesh).is_closed


def test_mixed_precision_is_the_wider_one():
    a, b = shapes.cap(), shapes.cap(-1)
    made = gm.stitch((a[0].astype(np.float32), a[1]), b)
    assert made.mesh.points.dtype == np.float64
    assert gm.join([a, (b[0].astype(np.float32), b[1])]).mesh.points.dtype == np.float64


def test_assembly_of_many_pieces():
    points, faces = shapes.cap(rows=12, columns=40, end=np.pi - 0.3)
    turn = np.arctan2(*points[faces].mean(axis=1)[:, 1::-1].T)
    pieces = [trimesh.Trimesh(points, faces[(turn >= a) & (turn < a + np.pi / 2)], process=True) for a in np.arange(-2, 2) * np.pi / 2]
    made = gm.join(pieces, fill=True)
    whole = to_trimesh(made.mesh)
    assert whole.is_watertight and whole.euler_number == 2
    assert whole.volume == pytest.approx(4 / 3 * np.pi, rel=0.05)
    assert sum(len(piece.vertices) for piece in made.report.pieces) == sum(len(piece.vertices) for piece in pieces)


def test_filling_and_the_report_of_holes():
    made = gm.fill(shapes.tube())
    assert gm.check(made.mesh).is_closed and len(made.holes) == 2
    assert made.holes.rim_count.tolist() == [24, 24] and (made.holes.status == "filled").all()
    only = gm.fill(shapes.tube(), [gm.boundary_loops(shapes.tube())[0].vertices])
    assert len(gm.boundary_loops(only.mesh)) == 1
    none = gm.fill(shapes.tube(), max_edges=20)
    assert len(gm.boundary_loops(none.mesh)) == 2 and [hole.status for hole in none.holes] == ["too_large"] * 2


def test_orientation_and_welding():
    points, faces = shapes.cap()
    mixed = faces.copy()
    mixed[::3] = mixed[::3, ::-1]
    made = gm.orient((points, mixed))
    assert gm.check(made.mesh).is_oriented and not gm.check((points, mixed)).is_oriented
    assert made.report.turned_faces in (len(faces[::3]), len(faces) - len(faces[::3]))
    soup = points[faces.reshape(-1)], np.arange(faces.size).reshape(-1, 3)
    assert gm.weld(soup, vertices="all", unused="remove").mesh.vertex_count == len(points)


def test_alignment_brings_pieces_back():
    field = lambda u, v: np.sin(3 * u) * np.cos(2 * v) + 0.3 * u * v  # noqa: E731
    nodes = shapes.grid(60, 60, field, (3.0, 3.0))
    left = nodes[:40].reshape(-1, 3), shapes.quads(40, 60)
    turn = trimesh.transformations.rotation_matrix(0.05, [1, 2, 3]) @ trimesh.transformations.translation_matrix([0.02, -0.03, 0.04])
    right = nodes[20:].reshape(-1, 3) @ turn[:3, :3].T + turn[:3, 3], shapes.quads(40, 60)
    found = gm.align([left, right])
    assert np.allclose(found.poses[1] @ turn, np.eye(4), atol=2e-3)
    assert np.abs(found.moved([left, right])[1].points - nodes[20:].reshape(-1, 3)).max() < 5e-3


def test_development_of_a_cylinder_keeps_lengths():
    points, faces = shapes.tube()
    made = gm.develop((points, faces))
    assert np.allclose(made.report.stretches, 1, atol=1e-9)
    edges = np.linalg.norm(made.points[made.mesh.faces[:, 0]] - made.points[made.mesh.faces[:, 1]], axis=1)
    old = points[made.report.vertex_map]
    assert np.allclose(edges, np.linalg.norm(old[made.mesh.faces[:, 0]] - old[made.mesh.faces[:, 1]], axis=1), atol=1e-9)


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.uint8, np.int64, bool])
def test_values_are_carried(dtype):
    a, b = shapes.cap(), shapes.cap(-1)
    made = gm.stitch(a, b)
    values = [np.arange(len(one[0])).astype(dtype) for one in (a, b)]
    got = made.carry(values)
    assert got.dtype == dtype and len(got) == made.mesh.vertex_count
    maps = made.report.vertex_map
    for value, place in zip(values, maps):
        assert np.array_equal(got[place], value)
    on_faces = made.carry([np.ones((len(one[1]), 3), dtype) for one in (a, b)], "faces", "nearest")
    assert on_faces.shape == (made.mesh.face_count, 3) and on_faces.all()


def test_a_linear_field_is_carried_exactly():
    points, faces = shapes.cap()
    made = gm.fill((points, faces), refine="rim_density")
    assert np.allclose(made.carry(points @ [1.0, 2.0, 3.0]), made.mesh.points @ [1.0, 2.0, 3.0], atol=1e-9)


def test_origins():
    made = gm.fill(shapes.tube())
    origins = made.origins.view("vertices")
    assert origins.offsets[-1] == len(origins.sources) == len(origins.weights)
    assert origins.starts.tolist() == [0, len(shapes.tube()[0])]
    with pytest.raises(ValueError):
        made.carry([None])
    with pytest.raises(gm.InputError):
        made.carry(np.zeros(3))


def _prism(outline, polygon, height):
    """A closed prism; edges that the polygon passes both ways have no side."""
    n = len(outline)
    points = [[x, y, z] for z in (0.0, height) for x, y in outline]
    edges = list(zip(polygon, polygon[1:] + polygon[:1]))
    sides = [[u, v, v + n, u + n] for u, v in edges if (v, u) not in edges]
    return points, [polygon[::-1], [v + n for v in polygon], *sides]


@pytest.mark.parametrize("outline, polygon, height, area, volume", [
    # A U; a wall with a window, which a bridge reaches from corner 0.
    ([(0, 0), (5, 0), (5, 4), (4, 4), (4, 1), (1, 1), (1, 4), (0, 4)], list(range(8)), 1.0, 46.0, 11.0),
    ([(0, 0), (6, 0), (6, 4), (0, 4), (1, 1), (1, 2), (3, 2), (3, 1)], [0, 1, 2, 3, 0, 4, 5, 6, 7, 4], 0.5, 57.0, 11.0),
])
def test_concave_polygons_keep_area_and_volume(outline, polygon, height, area, volume):
    mesh = gm.as_mesh(_prism(outline, polygon, height))
    solid = to_trimesh(mesh)
    assert solid.is_watertight and solid.is_winding_consistent
    assert solid.area == pytest.approx(area) and solid.volume == pytest.approx(volume)
    split = gm.triangulate(mesh)
    assert np.array_equal(split.mesh.corners.reshape(-1, 3), mesh.triangles())
    # Each triangle has the corners of its face.
    for face, triangle in zip(split.carry(np.arange(mesh.face_count), "faces"), mesh.triangles()):
        assert set(triangle) <= set(mesh.faces[face])
