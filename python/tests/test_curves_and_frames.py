"""Curves, frames, strips and winged edges against formulas of numpy."""

import numpy as np
import pytest
import shapes

import gusset_mesh as gm

RANDOM = np.random.default_rng(11)
CONTROLS = RANDOM.normal(size=(7, 3))
CURVE = gm.Curve.from_controls(CONTROLS, [0, 3, 6])
PLANE = gm.Curve.from_controls([[0, 0], [1, 2], [3, 2], [4, 0]])


def bezier(controls, t):
    """De Casteljau."""
    points = np.array(controls, float)
    while len(points) > 1:
        points = (1 - t) * points[:-1] + t * points[1:]
    return points[0]


def test_evaluation():
    found = CURVE.evaluate([0.25, 1.5, 1.0], order=2)
    for k, (part, t) in enumerate(((CONTROLS[:4], 0.25), (CONTROLS[3:], 0.5), (CONTROLS[3:], 0.0))):
        first, second = 3 * np.diff(part, axis=0), 6 * np.diff(part, 2, axis=0)
        assert np.allclose(found.derivatives[k], [bezier(part, t), bezier(first, t), bezier(second, t)])
        tangent, bend = bezier(first, t), bezier(second, t)
        assert np.allclose(found.tangents[k], tangent / np.linalg.norm(tangent))
        assert found.curvatures[k] == pytest.approx(np.linalg.norm(np.cross(tangent, bend)) / np.linalg.norm(tangent) ** 3)


def test_lengths_and_places():
    steps = np.linspace(0, 2, 20001)
    lengths = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(CURVE.evaluate(np.minimum(steps, 2 - 1e-12)).derivatives[:, 0], axis=0), axis=1))])
    assert np.allclose(CURVE.lengths_at([0.5, 1.0, 1.75]), np.interp([0.5, 1, 1.75], steps, lengths), rtol=1e-6)
    places = CURVE.places_at(CURVE.lengths_at([0.3, 1.2]))
    assert np.allclose(places.segment + places.t, [0.3, 1.2])
    assert np.allclose(CURVE.evaluate(places).derivatives, CURVE.evaluate([0.3, 1.2]).derivatives)


def test_parts_and_degrees():
    part = CURVE.part(0.5, 1.5)
    ends = part.evaluate([0, 1.999999999]).derivatives[:, 0]
    assert np.allclose(ends, CURVE.evaluate([0.5, 1.5]).derivatives[:, 0], atol=1e-6)
    assert part.length == pytest.approx(np.diff(CURVE.lengths_at([0.5, 1.5]))[0], rel=1e-9)
    assert CURVE.part(0, 2).length == pytest.approx(CURVE.length) and np.array_equal(CURVE.reverse().controls, CONTROLS[::-1])
    raised, _ = CURVE.change_degree(lowest=5)
    assert np.allclose(raised.evaluate([0.3, 1.7]).derivatives, CURVE.evaluate([0.3, 1.7]).derivatives) and np.diff(raised.ends).tolist() == [5, 5]
    lowered, deviations = raised.change_degree(highest=3, tolerance=1e-9)
    assert np.allclose(lowered.controls, CONTROLS) and deviations.max() < 1e-9


def test_where_curves_are_met():
    met = PLANE.intersect_plane([0, 1, 0], [0, 1, 0])
    assert len(met) == 2 and np.allclose(met.points[:, 1], 1)
    line = PLANE.intersect_line([0, 1, 0], [2, 0, 0])
    assert np.allclose(line.points, met.points) and np.allclose(2 * line.report.others.t, met.points[:, 0])
    assert len(PLANE.intersect_line([0, 1, 0], [2, 0, 0], start=0, end=0.75)) == 1
    level = PLANE.tangent_angle([1, 0, 0], 0)
    assert len(level) == 1 and np.allclose(level.points, [[2, 1.5, 0]])
    loop = gm.Curve.from_controls([[0, 0], [3, 2], [-2, 2], [1, 0]])
    crossing = loop.intersect()
    assert len(crossing) == 1 and crossing.report.others.t[0] > crossing.report.places.t[0] + 0.1
    first, second = (loop.evaluate(one).derivatives[0, 0] for one in (crossing.report.places, crossing.report.others))
    assert np.allclose(first, second)


def test_other_forms():
    spline = CURVE.spline()
    assert len(spline.knots) == len(spline.points) + spline.degree + 1 and spline.degree == 3
    square = gm.Curve.from_controls([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]], [0, 1, 2, 3, 4], closed=True)
    points, on_curve = square.contour()
    assert np.allclose(points[:, :2], [[0, 0], [1, 0], [1, 1], [0, 1]]) and on_curve.all()
    assert PLANE.svg().startswith("M") and "C" in PLANE.svg()


ANGLE = np.linspace(0, 2 * np.pi, 24, endpoint=False)
RINGS = [np.stack([(1 + 0.2 * z) * np.cos(ANGLE), (1 + 0.2 * z) * np.sin(ANGLE), 0 * ANGLE + z], axis=1) for z in range(4)]


def test_frames():
    frame = gm.Frame(RINGS, closed=True)
    assert np.array_equal(frame.nodes, RINGS)
    assert np.allclose(frame.report.along[:, 0], np.array([0.2, 0, 1]) / np.hypot(0.2, 1))
    assert np.allclose(np.sum(frame.report.across * frame.nodes * [1, 1, 0], axis=2), 0, atol=1e-2)
    assert frame.curve_across(2).length == pytest.approx(2 * np.pi * 1.4, rel=1e-3) and frame.curve_along(7).length == pytest.approx(3 * np.hypot(0.2, 1))
    section = frame.slice([0, 0, 1.5], [0, 0, 1]).curve
    assert section.length == pytest.approx(2 * np.pi * 1.3, rel=1e-3) and np.allclose(section.controls[:, 2], 1.5)
    even = gm.Frame(RINGS, closed=True, correspondence="arc_length", columns=10)
    other = np.linspace(0, 2 * np.pi, 30, endpoint=False)
    uneven = gm.Frame([*RINGS[:3], np.stack([1.6 * np.cos(other), 1.6 * np.sin(other), 3 + 0 * other], axis=1)], closed=True, correspondence="arc_length", columns=10)
    assert np.allclose(uneven.nodes, even.nodes, atol=2e-3)
    assert even.nodes.shape == (4, 10, 3) and np.allclose(np.hypot(even.nodes[1, :, 0], even.nodes[1, :, 1]), 1.2, atol=1e-3)
    tube = gm.Frame([ring * [1 / (1 + 0.2 * k), 1 / (1 + 0.2 * k), 1] for k, ring in enumerate(RINGS)], closed=True)
    moved = tube.offset([0.1, 0.2, 0.3, 0.4])
    assert np.allclose(np.hypot(moved.nodes[..., 0], moved.nodes[..., 1]), 1 + np.array([[0.1], [0.2], [0.3], [0.4]]))
    missing = [ring.copy() for ring in RINGS]
    missing[1][3] = np.nan
    filled = gm.Frame(missing, closed=True, missing=[24 + 3])
    assert np.allclose(filled.nodes, RINGS, atol=1e-9) and filled.report.filled.tolist() == [27]


def test_what_an_outline_says():
    outline = gm.Outline(RINGS[0], closed=True)
    assert outline.fit.fit == "ok" and outline.fit.max_residual < 1e-12 and outline.fit.size == pytest.approx(2, rel=0.01)
    controls, parameters, statuses = gm.find_sections(RINGS[0], True)
    assert (statuses == "ok").all() and np.allclose(parameters, 0.5)
    # The parabola with control point B passes its point at 1/2: P = A/4 + B/2 + C/4.
    assert np.allclose(np.roll(RINGS[0], 1, axis=0) / 4 + controls / 2 + np.roll(RINGS[0], -1, axis=0) / 4, RINGS[0])


def test_strips():
    made = gm.strip(RINGS[0], RINGS[3], closed=True, rows=None)
    faces, check = made.mesh.faces, gm.check(made.mesh)
    assert len(faces) == 48 and check.is_manifold and check.is_oriented and check.report.euler == 0
    assert np.array_equal(made.mesh.points, np.concatenate([RINGS[0], RINGS[3]]))
    uneven = gm.strip(RINGS[0], RINGS[3][::2], closed=True).mesh
    assert np.array_equal(uneven.points, np.concatenate([RINGS[0], RINGS[3][::2]])) and uneven.face_count == 36
    fine = gm.strip(RINGS[0], RINGS[3], closed=True, rows="count", row_count=2, cells="quads", meridians="index")
    assert fine.mesh.face_count == 72 and fine.report.matrix.shape == (4, 25) and fine.report.row_count == 2
    heights = fine.carry([RINGS[0][:, 2], RINGS[3][:, 2]])
    assert np.allclose(heights, fine.mesh.points[:, 2])


def test_facing_vertices():
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])
    found = gm.facing(square, square + [3, 0, 0])
    assert found.report.taken.tolist() == [[1, 2], [3, 2]]
    assert np.allclose(found.report.centre, [[0.5, 0.5, 0], [3.5, 0.5, 0]])
    few = gm.facing(square, square[:3] + [3, 0, 0])
    assert [len(one) for one in few.report.distances] == [4, 3] and np.allclose(few.report.centre[1], square[:3].mean(axis=0) + [3, 0, 0])
    for k in (0, 1):
        normal = found.report.normal[k] / np.linalg.norm(found.report.normal[k])
        assert np.allclose(found.report.distances[k], (square + [3 * k, 0, 0] - found.report.centre[k]) @ normal)
        assert found.report.runs[k].tolist() == [found.report.taken[k].tolist()]
    # By definition: |m i - n j| is least, of ties the later.
    for n, m in ((7, 3), (9, 9), (12, 5)):
        best = [max(range(m + 1), key=lambda j, i=i: (-abs(m * i - n * j), j)) for i in range(n + 1)]
        assert gm.meridians_index(n, m).tolist() == best


def test_merged_vertices():
    points, faces = shapes.tube()
    apart = points[np.asarray(faces).reshape(-1)]
    merge = gm.find_merge((apart, np.arange(len(apart)).reshape(-1, 4)))
    _, first, inverse = np.unique(apart, axis=0, return_index=True, return_inverse=True)
    assert np.array_equal(merge, first[inverse.reshape(-1)])
    assert gm.find_merge((apart[:4], [[0, 1, 2, 3]]), keys=[5, 5, 2, 2]).tolist() == [0, 0, 2, 2]


def test_winged_edges():
    points, faces = shapes.cap()
    tables = gm.winged((points, faces))
    edges = {frozenset((int(face[k - 1]), int(face[k]))) for face in faces for k in range(3)}
    assert {frozenset((one.m, one.n)) for one in tables.edges} == edges and len(tables.edges) == len(edges)
    border = [set(loop.vertices.tolist()) for loop in gm.boundary_loops((points, faces))]
    assert [set(loop.tolist()) for loop in tables.loops] == border
    none = 2**32 - 1
    assert ((tables.edges.left == none) != (tables.edges.right == none)).sum() == len(tables.loops[0])
    again = gm.winged_faces(tables.edges, len(points), tables.report.edge_of_face).mesh(points)
    assert np.array_equal(np.asarray(again.faces), faces)
    wrong = gm.WingedEdgeArray(np.array(tables.edges.array))
    wrong.array["b"][4] = 10**6
    with pytest.raises(gm.InputError) as caught:
        gm.winged_faces(wrong, len(points))
    assert caught.value.name == "bad_wings"


@pytest.mark.parametrize("bad", [
    lambda: gm.Curve.from_controls([1, 2, 3]), lambda: gm.Curve.from_controls([[0, 0], [1, np.nan]]), lambda: gm.Curve.from_controls(CONTROLS, [0, 9]),
    lambda: gm.Curve.from_controls(CONTROLS, [0, 3, 2, 6]), lambda: gm.Curve.from_controls(CONTROLS, closed=True), lambda: gm.Curve.from_controls(np.zeros((99, 3))),
    lambda: CURVE.evaluate([2.5]), lambda: CURVE.evaluate([-1]), lambda: CURVE.evaluate([np.nan]), lambda: CURVE.evaluate([1e30]), lambda: CURVE.evaluate([0], order=65),
    lambda: CURVE.evaluate([0], order=-1), lambda: CURVE.evaluate([0], order=2**31), lambda: CURVE.lengths_at([9]), lambda: CURVE.places_at([np.nan]),
    lambda: CURVE.places_at([[1]]), lambda: CURVE.part(1, 0.5), lambda: CURVE.part([0, 1], 1), lambda: CURVE.part(0, 7), lambda: CURVE.change_degree(0),
    lambda: CURVE.change_degree(9, 3), lambda: CURVE.change_degree(tolerance=-1), lambda: CURVE.contour(), lambda: CURVE.svg(), lambda: CURVE.intersect(),
    lambda: CURVE.intersect("curve"), lambda: CURVE.intersect_plane([0, 0, 0], [0, 0, 0]), lambda: CURVE.intersect_plane([0, 0], [0, 0, 1]),
    lambda: CURVE.intersect_line([0, 0, 0], [0, 0, 0]), lambda: CURVE.intersect_line([0, 0, 0], [1, 0, 0], np.nan), lambda: CURVE.tangent_angle([1, 0, 0], 4),
    lambda: gm.Frame([]), lambda: gm.Frame([RINGS[0]]), lambda: gm.Frame([RINGS[0], RINGS[1][:5]]), lambda: gm.Frame([RINGS[0], [[0, 0]]]), lambda: gm.Frame(3),
    lambda: gm.Frame(RINGS, correspondence="angle", columns=4), lambda: gm.Frame(RINGS, missing=[10**6]), lambda: gm.Frame(RINGS, columns=-1),
    lambda: gm.Frame(RINGS, True).offset([1, 2]), lambda: gm.Frame(RINGS, True).offset(np.nan), lambda: gm.Frame(RINGS, True).slice([0, 0, 99], [0, 0, 1]),
    lambda: gm.Frame(RINGS, True).curve_across(4), lambda: gm.Frame(RINGS, True).curve_along(-1), lambda: gm.find_sections([[0, 0], [np.nan, 1]]),
    lambda: gm.strip([[0, 0]], [[1, 1]]), lambda: gm.strip(np.full((4, 3), np.nan), RINGS[0]), lambda: gm.strip(RINGS[0], RINGS[1], rows="many"),
    lambda: gm.strip(RINGS[0], RINGS[1], row_count=2**31), lambda: gm.strip(np.zeros((0, 3)), RINGS[0]), lambda: gm.facing(RINGS[0], RINGS[0]),
    lambda: gm.facing(RINGS[0], np.zeros((4, 2))), lambda: gm.facing(RINGS[0], RINGS[1] + [9, 0, 0], tolerance=-1), lambda: gm.meridians_index(2, 3),
    lambda: gm.meridians_index(-1, 0), lambda: gm.find_merge((np.eye(3), [[0, 1, 2]]), keys=[1]), lambda: gm.winged((np.eye(3), [[0, 1, 9]])),
    lambda: gm.winged((np.eye(3), [[0, 1, 2]]), winding="left"), lambda: gm.winged_faces([(1, 2)], 3), lambda: gm.winged_faces(gm.winged((np.eye(3), [[0, 1, 2]])).edges, 1),
    lambda: gm.winged_faces(gm.winged((np.eye(3), [[0, 1, 2]])).edges, 3, [9, 9]),
])
def test_what_is_refused(bad):
    with pytest.raises((ValueError, TypeError, IndexError)):
        bad()
