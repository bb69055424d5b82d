"""Sheets made of other things, and questions to surfaces, against formulas of numpy."""

import numpy as np
import pytest
import shapes

import gusset_mesh as gm

RANDOM = np.random.default_rng(13)


def ball(rows=33, columns=65):
    u, v = np.meshgrid(np.linspace(0, np.pi, rows), np.linspace(0, 2 * np.pi, columns), indexing="ij")
    nodes = np.stack([np.sin(u) * np.cos(v), np.sin(u) * np.sin(v), np.cos(u)], axis=2)
    nodes[0], nodes[-1], nodes[:, -1] = [0, 0, 1], [0, 0, -1], nodes[:, 0]
    return gm.Sheet(nodes, closed_v=True)


BALL = gm.Surface(ball())
FLAT = gm.Surface(shapes.grid(8, 8, span=(4.0, 4.0)) - [2, 2, 0])


def test_patches_are_their_bernstein_polynomials():
    points = RANDOM.normal(size=(2, 3, 3, 4, 3))
    surface = gm.Surface(gm.Sheet.from_patches(points))
    u, v = 0.3, 0.8
    row = np.array([(1 - u) ** 2, 2 * u * (1 - u), u**2])
    column = np.array([(1 - v) ** 3, 3 * v * (1 - v) ** 2, 3 * v**2 * (1 - v), v**3])
    for i in range(2):
        for j in range(3):
            assert np.allclose(surface.evaluate([[i + u, j + v]]).point[0], np.einsum("i,j,ijk", row, column, points[i, j]))


def test_splines():
    """A cubic of uniform knots, summed from its basis by hand; and a sphere as a NURBS surface."""
    points = RANDOM.normal(size=(4, 4, 3))
    knots = np.arange(8.0)
    surface = gm.Surface(gm.Sheet.from_spline(points, knots, knots))
    t = 0.4
    basis = np.array([(1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3]) / 6
    assert np.allclose(surface.evaluate([[t, t]]).point[0], np.einsum("i,j,ijk", basis, basis, points))
    half = 0.5**0.5
    arc = np.array([[0, -1], [1, -1], [1, 0], [1, 1], [0, 1.0]])
    circle = np.array([[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0.0]])
    nodes = np.stack([np.stack([r * circle[:, 0], r * circle[:, 1], 0 * circle[:, 0] + z], axis=1) for r, z in arc])
    weights = np.outer([1, half, 1, half, 1], [1, half] * 4 + [1])
    sheet = gm.Sheet.from_spline(nodes, [0, 0, 0, 1, 1, 2, 2, 2], [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], degree_u=2, degree_v=2, weights=weights)
    round_ = gm.Surface(sheet).evaluate(RANDOM.uniform(0, 1, (50, 2)) * [sheet.report.rows, sheet.report.columns])
    assert np.allclose(np.linalg.norm(round_.point, axis=1), 1, atol=1e-9) and sheet.report.deviation < 1e-9


def test_tangents_are_followed():
    """Hermite data of a bicubic polynomial give it back."""
    i, j = np.meshgrid(np.arange(3.0), np.arange(4.0), indexing="ij")

    def polynomial(u, v):
        return np.stack([u, v, u**3 - 2 * u * v**2 + v], axis=-1)

    along_u = np.stack([1 + 0 * i, 0 * i, 3 * i**2 - 2 * j**2], axis=2)
    along_v = np.stack([0 * i, 1 + 0 * i, -4 * i * j + 1], axis=2)
    twists = np.stack([0 * i, 0 * i, -4 * j], axis=2)
    surface = gm.Surface(gm.Sheet(polynomial(i, j), (along_u, along_v), twists=twists))
    places = RANDOM.uniform(0, 1, (20, 2)) * [2, 3]
    assert np.allclose(surface.evaluate(places).point, polynomial(*places.T))
    zero = gm.Surface(gm.Sheet(polynomial(i, j), (along_u, along_v), twists="zero"))
    assert not np.allclose(zero.evaluate(places).point, polynomial(*places.T))
    assert np.allclose(zero.evaluate([[0.5, 0.0]]).point, polynomial(0.5, 0.0))


def test_nets_of_curves():
    """Coons's patch of four curves has them as its borders."""
    corners = {(0, 0): [0, 0, 0], (0, 1): [0, 1, 0.5], (1, 0): [1, 0, 0.2], (1, 1): [1, 1, 0]}

    def bow(a, b, height):
        a, b = np.array(corners[a], float), np.array(corners[b], float)
        return gm.Curve.from_controls([a, a + (b - a) / 3 + [0, 0, height], a + 2 * (b - a) / 3 + [0, 0, height], b])

    rows = [bow((0, 0), (0, 1), 0.3), bow((1, 0), (1, 1), -0.2)]
    columns = [bow((0, 0), (1, 0), 0.1), bow((0, 1), (1, 1), 0.4)]
    sheet = gm.Sheet.from_curves(rows, columns)
    t = np.linspace(0, 0.999, 7)
    for border, curve in ((sheet.curve("rows", 0), rows[0]), (sheet.curve("rows", sheet.report.rows), rows[1]), (sheet.curve("columns", 0), columns[0])):
        assert np.allclose(border.evaluate(t).derivatives[:, 0], curve.evaluate(t).derivatives[:, 0], atol=1e-12)
    skin = gm.Sheet.from_curves(rows)
    assert np.allclose(gm.Surface(skin).evaluate([[0.5 * skin.report.rows, 0]]).point, [[0.5, 0, 0.1]])


def test_sheets_of_frames_and_offsets():
    angle = np.linspace(0, 2 * np.pi, 32, endpoint=False)
    rings = [np.stack([np.cos(angle), np.sin(angle), 0 * angle + z], axis=1) for z in np.linspace(0, 2, 6)]
    frame = gm.Frame(rings, closed=True)
    sheet = gm.Sheet.from_frame(frame)
    assert sheet.report.closed_v and not sheet.report.closed_u
    points = sheet.mesh(min_u=3, min_v=3).mesh.points
    assert np.allclose(np.hypot(points[:, 0], points[:, 1]), 1, atol=1e-4)
    curves = gm.Sheet.from_frame(frame, "curves")
    assert np.allclose(curves.curve("rows", 0).length, frame.curve_across(0).length, rtol=1e-9)
    for distance in (0.25, -0.25):
        moved, deviation = ball().offset(distance)
        radius = np.linalg.norm(moved.mesh().mesh.points, axis=1)
        assert np.allclose(np.abs(radius - 1), 0.25) and deviation < 1e-3
    heights, _ = gm.Sheet(shapes.grid(4, 5)).offset(np.arange(20.0).reshape(4, 5))
    # A mesh of a sheet has its corners row after row.
    assert np.allclose(np.abs(heights.mesh().mesh.points[:, 2]), np.arange(20.0))


def test_measures_of_sheets():
    flat = gm.Sheet(shapes.grid(7, 9, span=(3.0, 8.0)))
    cells = flat.measure_cells("diameters", "bilinear", "errors")
    assert cells["diameters"].shape == (6, 8) and (cells["diameters"] >= np.hypot(0.5, 1) - 1e-12).all() and np.allclose(cells["diameters"], np.hypot(0.5, 1), rtol=0.5)
    assert np.abs(cells["bilinear"]).max() < 1e-9 and np.abs(cells["errors"]).max() < 1e-9
    assert flat.measure().curvature_bound < 1e-9 and flat.measure().crease < 1e-9
    # A roof: the crease is the angle of its sides.
    roof = gm.Sheet.from_patches(np.array([[[[[0, 0, 0], [0, 1, 0]], [[1, 0, 1], [1, 1, 1]]]], [[[[1, 0, 1], [1, 1, 1]], [[2, 0, 0], [2, 1, 0]]]]], float))
    assert roof.measure().crease == pytest.approx(np.pi / 2)


def test_distances():
    assert BALL.distance(gm.Plane([0, 0, 3], [0, 0, -2])).distance == pytest.approx(2, abs=1e-3)
    found = BALL.distance(gm.Line([3, 0, 0], [0, 1, 0]))
    assert found.distance == pytest.approx(2, abs=1e-4) and found.bound <= found.distance and np.allclose(found.other_point, [3, 0, 0], atol=1e-2)
    # Of a segment the end is nearest.
    assert BALL.distance(gm.Line([3, 0, 0], [0, 1, 0], start=4, end=5)).distance == pytest.approx(4, abs=1e-3)
    assert BALL.distance(gm.Curve.from_controls([[0, 5, 0], [0, 3, 0]])).distance == pytest.approx(2, abs=1e-3)
    far = gm.Surface(gm.Sheet(shapes.grid(5, 5) - [0.5, 0.5, 4]))
    assert BALL.distance(far).distance == pytest.approx(3, abs=1e-3)
    assert "meets" in BALL.distance(FLAT).flags and BALL.distance(FLAT).distance == 0
    angle = BALL.nearest_angle([0, 0, 1], 0.5)
    assert angle.deviation < 1e-8 and np.arccos(angle.normal[2]) == pytest.approx(0.5, abs=1e-6)


def test_local_minima():
    waves = gm.Surface(shapes.grid(61, 9, lambda u, v: np.cos(2 * np.pi * u), span=(3.0, 1.0)))
    # Above, the crests at u = 0, 1, 2, 3 are the minima; the nearest come first.
    found = waves.minima([1.4, 0.5, 5])
    assert sorted(np.round(found.points.point[:, 0], 1)) == [0, 1, 2, 3]
    assert (np.diff(found.points.distance) >= 0).all() and found.report.complete
    assert len(waves.minima([1.4, 0.5, 5], max_count=2)) == 2 and len(waves.minima([1.4, 0.5, 5], limit=4.1)) == 2


def test_cells():
    found = FLAT.region([0, 0, 0.5], 1.0)
    corners = -2 + np.stack([found.cells.row, found.cells.column], axis=1) * (4 / 7)
    near = np.clip(0, corners, corners + 4 / 7)
    i, j = np.meshgrid(np.arange(7), np.arange(7), indexing="ij")
    low = -2 + np.stack([i, j], axis=2) * (4 / 7)
    expected = np.linalg.norm(np.clip(0, low, low + 4 / 7), axis=2) <= np.sqrt(0.75)
    assert np.linalg.norm(near, axis=1).max() <= np.sqrt(0.75) + 1e-9 and len(found) == expected.sum()
    far = np.linalg.norm(np.maximum(np.abs(low), np.abs(low + 4 / 7)), axis=2) <= np.sqrt(0.75)
    assert found.report.whole.sum() == far.sum()
    pairs = FLAT.cell_pairs(BALL)
    met = {(a.row, a.column) for a in pairs.cells}
    assert 0 < len(met) < 49 and len(pairs.report.others) == len(pairs)
    # The circle where they meet passes only through cells of pairs.
    for place in BALL.intersect(FLAT).report.others:
        assert (place.row, place.column) in met
    assert len(FLAT.cell_pairs(gm.Surface(gm.Sheet(shapes.grid(4, 4) + [0, 0, 9])))) == 0


def test_hits_of_curves_and_first_hits():
    curve = gm.Curve.from_controls([[0, 0, -3], [0, 0, 3]])
    hits = BALL.hits([[0.1, 0.2, 5]], [[0, 0, -1]], curve=curve)
    assert hits.ends.tolist() == [0, 2, 4] and np.allclose(hits.hits.point[2:, 2], [-1, 1], atol=1e-4)
    assert hits.report.on_curve.t.shape == (2, 3) and np.allclose(hits.report.on_curve.t[:, 0], [1 / 3, 2 / 3], atol=1e-4)
    assert len(BALL.hits(curve=curve).hits) == 2
    starts = RANDOM.normal(size=(50, 3)) * 3
    first = BALL.first_hits(starts, -starts)
    assert np.allclose(np.linalg.norm(first.point, axis=1), 1, atol=1e-4) and (first.kind == "crossing").all()
    whole = BALL.hits(starts, -starts)
    assert np.array_equal(first.t, whole.hits.t[whole.ends[:-1].astype(int)])
    assert (BALL.first_hits(starts * 9, starts).kind[np.linalg.norm(starts, axis=1) > 1] == "none").all()


def test_self_intersections():
    """A plane curve with a loop, swept: it meets itself along the line above the crossing point."""
    loop = gm.Curve.from_controls([[0, 0, 0], [3, 2, 0], [-2, 2, 0], [1, 0, 0]])
    crossing = gm.Curve.from_controls([[0, 0], [3, 2], [-2, 2], [1, 0]]).intersect().points[0]
    top = gm.Curve.from_controls(loop.controls + [0, 0, 1])
    sheet = gm.Sheet.from_curves([loop, top])
    met = gm.Surface(sheet).intersect()
    assert len(met) == 1 and np.allclose(met[0][:, :2], crossing[:2], atol=1e-6) and np.ptp(met[0][:, 2]) == pytest.approx(1, abs=1e-6)
    assert len(FLAT.intersect()) == 0


@pytest.mark.parametrize("bad", [
    lambda: gm.Sheet.from_patches(np.zeros((2, 2, 3))), lambda: gm.Sheet.from_patches(np.zeros((0, 1, 2, 2, 3))), lambda: gm.Sheet.from_patches(np.zeros((1, 1, 1, 2, 3))),
    lambda: gm.Sheet.from_patches(np.zeros((1, 1, 99, 2, 3))), lambda: gm.Sheet.from_patches(np.full((1, 1, 2, 2, 3), np.nan)),
    lambda: gm.Sheet.from_spline(np.zeros((4, 4, 3)), np.arange(7), np.arange(8)), lambda: gm.Sheet.from_spline(np.zeros((4, 4, 3)), np.arange(8)[::-1], np.arange(8)),
    lambda: gm.Sheet.from_spline(np.zeros((4, 4, 3)), np.arange(8), np.arange(8), degree_u=-1), lambda: gm.Sheet.from_spline(np.zeros((4, 4, 3)), [], []),
    lambda: gm.Sheet.from_spline(np.zeros((4, 4, 3)), np.arange(8), np.arange(8), weights=np.ones(4)), lambda: gm.Sheet.from_spline(np.zeros((4, 4)), [], []),
    lambda: gm.Sheet.from_spline(np.zeros((4, 4, 3)), np.arange(8), np.arange(8), weights=np.zeros((4, 4))), lambda: gm.Sheet.from_curves(), lambda: gm.Sheet.from_curves([1, 2]),
    lambda: gm.Sheet.from_curves([gm.Curve.from_controls([[0, 0], [1, 0]])]), lambda: gm.Sheet.from_frame(3), lambda: gm.Sheet.from_frame(None, "nodes"),
    lambda: gm.Sheet(shapes.grid(4, 4), (shapes.grid(4, 4),)), lambda: gm.Sheet(shapes.grid(4, 4), (shapes.grid(4, 4), shapes.grid(4, 5))),
    lambda: gm.Sheet(shapes.grid(4, 4), (shapes.grid(4, 4), shapes.grid(4, 4)), twists="none"),
    lambda: gm.Sheet(shapes.grid(4, 4), (shapes.grid(4, 4), np.full((4, 4, 3), np.nan))),
    lambda: ball().offset([1, 2]), lambda: ball().offset(np.nan), lambda: ball().curve("across", 0), lambda: ball().curve("rows", 99), lambda: ball().curve("rows", np.nan),
    lambda: ball().measure_cells("areas"), lambda: BALL.distance([0, 0, 0]), lambda: BALL.distance(gm.Plane([0, 0, 0], [0, 0, 0])),
    lambda: BALL.distance(gm.Line([0, 0, 0], [0, 0, 1], 2, 1)), lambda: BALL.distance(gm.Line([0, 0], [0, 0, 1])), lambda: BALL.distance(FLAT, -1),
    lambda: BALL.distance(gm.Curve.through([[0, 0, np.nan], [1, 0, 0]])), lambda: BALL.minima([0, 0, np.nan]), lambda: BALL.minima([[0, 0, 0]]),
    lambda: BALL.minima([0, 0, 0], limit=-1), lambda: BALL.minima([0, 0, 0], max_count=-1), lambda: BALL.region([0, 0, 0], -1), lambda: BALL.region([0, 0, 0], np.nan),
    lambda: BALL.cell_pairs(None), lambda: BALL.cell_pairs(FLAT, np.inf), lambda: BALL.first_hits([[0, 0]], [[0, 0, 1]]), lambda: BALL.first_hits([[0, 0, 0]], [[0, 0, 0]]),
    lambda: BALL.first_hits(np.zeros((2, 3)), np.ones((3, 3))), lambda: BALL.hits([[0, 0, 0]], [[0, 0, 1]], curve="line"), lambda: BALL.nearest_angle([0, 0, 0], 1),
    lambda: BALL.nearest_angle([0, 0, 1], 4), lambda: BALL.intersect("other"), lambda: BALL.intersect(chord=-1),
])
def test_what_surfaces_refuse(bad):
    with pytest.raises((ValueError, TypeError)):
        bad()
