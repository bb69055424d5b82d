"""Outlines, nets and surfaces against formulas."""

import numpy as np
import pytest
import shapes

import gusset_mesh as gm

angle = np.linspace(0, 2 * np.pi, 32, endpoint=False)
CIRCLE = np.stack([np.cos(angle), np.sin(angle)], axis=1)


@pytest.mark.parametrize("method", ["bisector", "median", "normal", "symmedian"])
def test_outline_through_a_circle(method):
    outline = gm.Outline(CIRCLE, closed=True, method=method)
    curve = outline.curve
    assert (outline.statuses == "ok").all() and curve.is_closed
    assert curve.length == pytest.approx(2 * np.pi, rel=1e-3)
    assert np.linalg.norm(curve.area_vector) == pytest.approx(np.pi, rel=1e-3)
    assert np.allclose(curve.nearest(np.c_[CIRCLE, np.zeros(32)]).distance, 0, atol=1e-12)
    found = curve.nearest([[3, 0, 0], [0, 0.5, 0]])
    assert np.allclose(found.distance, [2, 0.5], atol=1e-3)
    assert len(curve.sample(10)) == 10
    assert np.allclose(np.linalg.norm(curve.sample(0.01, "step").points, axis=1), 1, atol=1e-3)
    assert curve.svg().startswith("M")
    assert curve.offset(-0.5).length == pytest.approx(3 * np.pi, rel=1e-3) or curve.offset(-0.5).length == pytest.approx(np.pi, rel=1e-3)


def test_measures_of_a_curve():
    round_, bent = gm.Outline(CIRCLE, closed=True).curve, gm.Curve.through([[0, 0, 0], [1, 0, 0], [1, 1, 1]])
    found = round_.measure()
    assert found.length == round_.length and np.array_equal(found.area_vector, round_.area_vector)
    assert found.area == pytest.approx(np.pi, rel=1e-3) and np.allclose(found.high, [1, 1, 0], atol=1e-3)
    assert np.allclose(found.centroid, 0, atol=1e-9) and np.allclose(found.centre, 0, atol=1e-9)
    # A curve in space has no moments.
    assert bent.measure().defined < found.defined
    assert len(round_.intersect(gm.Curve.through([[-2, 0, 0.1], [0, 0, 0.1], [2, 0, 0.1]]), 0.2)) == 2


def test_outline_with_demands():
    points = [[0, 0], [1, 1], [2, 0], [3, 1]]
    outline = gm.Outline(points, tangents={0: [1, 0]}, corners=[2])
    controls = outline.curve.controls
    assert abs(controls[1, 1] - controls[0, 1]) < 1e-9
    with pytest.raises(gm.InputError):
        gm.Outline([[0, 0], [np.inf, 1]])
    with pytest.raises(ValueError):
        gm.Outline(np.zeros((4, 4)))


def test_curves_meet():
    line = gm.Curve.through([[-2, 0.1, 0], [-1, 0.1, 0], [1, 0.1, 0], [2, 0.1, 0]])
    circle = gm.Outline(CIRCLE, closed=True).curve
    met = circle.intersect(line)
    assert len(met) == 2 and np.allclose(np.abs(met.points[:, 0]), np.sqrt(0.99), atol=1e-3)


def test_net_of_a_torus():
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 120, endpoint=False), np.linspace(0, 2 * np.pi, 60, endpoint=False), indexing="ij")
    nodes = np.stack([(2 + 0.5 * np.cos(v)) * np.cos(u), (2 + 0.5 * np.cos(v)) * np.sin(u), 0.5 * np.sin(v)], axis=2)
    net = gm.Net(np.concatenate([np.concatenate([nodes, nodes[:1]]), np.concatenate([nodes, nodes[:1]])[:, :1]], axis=1), "torus")
    assert net.shape == (121, 61)
    assert abs(net.measure().volume) == pytest.approx(np.pi**2, rel=0.01)
    assert net.measure().area == pytest.approx(4 * np.pi**2, rel=0.01)
    made = net.mesh()
    assert gm.check(made.mesh).is_closed and gm.check(made.mesh).report.euler == 0


def test_nets_keep_their_nodes():
    nodes = shapes.grid(5, 7, lambda u, v: u * v)
    for array in (nodes, nodes.astype(np.float32), np.asfortranarray(nodes), nodes[:, ::-1], nodes.transpose(1, 0, 2)):
        net = gm.Net(array)
        assert np.array_equal(net.nodes, array) and net.nodes.dtype == array.dtype
        assert np.array_equal(net.transpose().nodes, array.transpose(1, 0, 2))
    assert np.array_equal(gm.Net(nodes).flip("right").nodes, nodes[:, ::-1])
    assert gm.Net(nodes).resample(9, 13).shape == (9, 13)
    assert gm.Net.concatenate([gm.Net(nodes), gm.Net(nodes + [0, 1.5, 0])]).shape == (5, 14)
    assert np.allclose(np.abs(gm.Net(shapes.grid(4, 4)).displace(0.25).nodes[..., 2]), 0.25)
    again = gm.Net.from_mesh(gm.Net(nodes).mesh().mesh)
    assert sorted(again.shape) == [5, 7]
    heights = gm.Net.from_heights(np.array([[1.0, 2], [3, np.nan]]), spacing=(2, 3))
    assert np.array_equal(heights.nodes[..., 2], [[1, 2], [3, np.nan]], equal_nan=True)
    with pytest.raises(ValueError):
        gm.Net(nodes, "knot")
    with pytest.raises(gm.InputError):
        gm.Net(nodes[:1])


def sphere():
    u, v = np.meshgrid(np.linspace(0, np.pi, 33), np.linspace(0, 2 * np.pi, 65), indexing="ij")
    nodes = np.stack([np.sin(u) * np.cos(v), np.sin(u) * np.sin(v), np.cos(u)], axis=2)
    nodes[0], nodes[-1], nodes[:, -1] = [0, 0, 1], [0, 0, -1], nodes[:, 0]
    return gm.Surface(gm.Sheet(nodes, closed_v=True))


def test_surface_of_a_sphere():
    ball = sphere()
    queries = np.random.default_rng(3).normal(size=(200, 3)) * 2
    found = ball.nearest(queries)
    assert np.allclose(found.distance, np.abs(np.linalg.norm(queries, axis=1) - 1), atol=1e-4)
    assert (found.bound <= found.distance + 1e-12).all() and found.flags["proven"].all()
    curves = ball.section([0, 0, 0], [0, 0, 1], [-0.5, 0, 0.5])
    assert len(curves) == 3 and curves.closed.all() and curves.levels.tolist() == [0, 1, 2]
    for curve, height in zip(curves, (-0.5, 0, 0.5)):
        assert np.allclose(curve[:, 2], height, atol=1e-9)
        assert np.allclose(np.linalg.norm(curve[:, :2], axis=1), np.sqrt(1 - height**2), atol=1e-4)
    hits = ball.hits([[0.1, 0.2, 5], [3, 3, 3]], [0, 0, -1])
    assert hits.ends.tolist() == [0, 2, 2]
    assert np.allclose(hits.hits.t, [5 - np.sqrt(0.95), 5 + np.sqrt(0.95)], atol=1e-4)
    wall = gm.Surface(shapes.grid(8, 8, span=(4.0, 4.0)) - [2, 2, -0.25])
    met = ball.intersect(wall)
    assert len(met) == 1 and np.allclose(met[0][:, 2], 0.25, atol=1e-9)
    assert np.allclose(ball.evaluate([[8, 3.5], [16, 20]]).gaussian, 1, atol=0.02)
    assert len(ball.isophotes([0, 0, 1])) == 1
    assert len(ball.isophotes([0, 0, 1], [0.5])) == 1 and len(ball.isophotes([0, 0, 1], [0.5], unsigned_normals=True)) == 2
    heights = np.broadcast_to(np.cos(np.linspace(0, np.pi, 33))[:, None], (33, 65))
    assert np.allclose(ball.contours(heights, [0.25])[0][:, 2], 0.25, atol=1e-4)
    made = ball.sheets[0].mesh(tolerance=1e-3)
    assert made.report.deviation <= 1e-3 and gm.check(made.mesh).is_closed


def test_queries_that_cannot_be_used():
    ball = sphere()
    with pytest.raises(gm.InputError) as caught:
        ball.nearest([[0, 0, 0], [np.nan, 0, 0]])
    assert caught.value.index == 1
    with pytest.raises(ValueError):
        ball.section([0, 0], [0, 0, 1])
    with pytest.raises(gm.InputError):
        ball.section([0, 0, 0], [0, 0, 0])
    assert len(ball.nearest(np.empty((0, 3)))) == 0
    with pytest.raises(ValueError):
        gm.Sheet(np.zeros((3, 3)))
