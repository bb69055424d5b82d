"""Deformations of nets against formulas of numpy."""

import numpy as np
import pytest

import gusset_mesh as gm
from gusset_mesh import fields

RANDOM = np.random.default_rng(7)
CLOUD = RANDOM.uniform(-1, 1, (6, 9, 3))
NET = gm.Net(CLOUD)
X, Y, Z = CLOUD.T  # transposed: (columns, rows)


def of(net):
    """x, y, z as they are in X, Y, Z."""
    return net.nodes.T


def test_twist_and_taper_and_shear():
    x, y, z = of(NET.deform(fields.twist("z", 0.7, start=0.2)))
    angle = 0.7 * (Z - 0.2)
    assert np.allclose([x, y, z], [X * np.cos(angle) - Y * np.sin(angle), X * np.sin(angle) + Y * np.cos(angle), Z])
    x, y, z = of(NET.deform(fields.taper("x", -0.4, start=1)))
    assert np.allclose([x, y, z], [X, Y * (1 - 0.4 * (X - 1)), Z * (1 - 0.4 * (X - 1))])
    x, y, z = of(NET.deform(fields.shear("y", "x", 0.3)))
    assert np.allclose([x, y, z], [X, Y + 0.3 * X, Z])


def test_affine_and_projective_maps():
    matrix = RANDOM.normal(size=(3, 4))
    assert np.allclose(NET.deform(fields.affine(matrix)).nodes, CLOUD @ matrix[:, :3].T + matrix[:, 3])
    whole = np.array([[2, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0], [0.1, 0.2, 0, 3.0]])
    homogeneous = np.concatenate([CLOUD, np.ones((6, 9, 1))], axis=2) @ whole.T
    assert np.allclose(NET.deform(fields.projection(whole)).nodes, homogeneous[..., :3] / homogeneous[..., 3:])
    point, normal, eye = np.array([0, 0, -2.0]), np.array([0.2, 0.1, 1]), np.array([0.5, 0, 4])
    for field, along in ((fields.parallel(point, normal, [1, 2, 3]), np.broadcast_to([1, 2, 3.0], CLOUD.shape)), (fields.perspective(eye, point, normal), CLOUD - eye)):
        moved = NET.deform(field).nodes
        assert np.allclose((moved - point) @ normal, 0, atol=1e-12) and np.allclose(np.cross(moved - CLOUD, along), 0, atol=1e-9)


def test_bend_follows_an_arc():
    line = gm.Net(np.stack([np.zeros((2, 50)), np.broadcast_to(np.array([[0.0], [1.0]]), (2, 50)), np.broadcast_to(np.linspace(-1, 3, 50), (2, 50))], axis=2))
    bent = line.deform(fields.bend("z", 0.5, start=0, end=2)).nodes[0]
    z = np.linspace(-1, 3, 50)
    inside = (z >= 0) & (z <= 2)
    # A circle of radius 2 about x = 2, z = 0; beyond it the axis is straight, so that steps keep their lengths.
    assert np.allclose(np.hypot(bent[inside, 0] - 2, bent[inside, 2]), 2)
    assert np.array_equal(bent[z < 0], line.nodes[0][z < 0])
    ahead = np.diff(bent[z > 2], axis=0)
    assert np.allclose(ahead / np.linalg.norm(ahead[0]), [np.sin(1), 0, np.cos(1)])


def test_wraps_reach_their_surfaces():
    def sheet(u, v):
        """A plane with axes u and v of the wrap about z, at w = 0, or with v and w swapped."""
        a, b = np.meshgrid(np.linspace(*u, 41), np.linspace(*v, 41), indexing="ij")
        return a, b, 0 * a

    u, v, w = sheet((0, 6), (-1, 1))
    x, y, z = np.moveaxis(gm.Net(np.stack([u, w, v], axis=2)).deform(fields.wrap_cylinder("z", 2)).nodes, 2, 0)
    assert np.allclose(np.hypot(x, y), 2) and np.allclose(z, v)
    x, y, z = np.moveaxis(gm.Net(np.stack([u, v, w], axis=2)).deform(fields.wrap_torus("z", 3, 1)).nodes, 2, 0)
    assert np.allclose((np.hypot(x, y) - 3) ** 2 + z**2, 1)
    x, y, z = np.moveaxis(gm.Net(np.stack([u, v, w], axis=2)).deform(fields.wrap_sphere("z", 2)).nodes, 2, 0)
    assert np.allclose(np.hypot(np.hypot(x, y), z), 2) and np.allclose(z, 2 * np.sin(v / 2))
    x, y, z = np.moveaxis(gm.Net(np.stack([u, w, v], axis=2)).deform(fields.wrap_cone("z", 2, 0.3)).nodes, 2, 0)
    assert np.allclose(np.hypot(x, y), 2 - v * np.sin(0.3)) and np.allclose(z, v * np.cos(0.3))
    ball = NET.deform(fields.spherify([0.1, 0.2, 3], 0.5)).nodes - [0.1, 0.2, 3]
    assert np.allclose(np.linalg.norm(ball, axis=2), 0.5) and np.allclose(np.cross(ball, CLOUD - [0.1, 0.2, 3]), 0, atol=1e-12)


def test_lattice_repeats_affine_maps():
    """Bernstein polynomials give linear functions of the control points back: each axis has its own count, so that none can be swapped."""
    matrix, shift = RANDOM.normal(size=(3, 3)), RANDOM.normal(size=3)
    grid = np.stack(np.meshgrid(np.linspace(-1, 1, 2), np.linspace(-1, 1, 3), np.linspace(-1, 1, 4), indexing="ij"), axis=3)
    moved = NET.deform(fields.lattice([-1, -1, -1], [1, 1, 1], grid @ matrix.T + shift))
    assert np.allclose(moved.nodes - CLOUD, CLOUD @ matrix.T + shift)
    # Points outside the box stay, bit for bit.
    assert np.array_equal(NET.deform(fields.lattice([5, 5, 5], [6, 6, 6], grid)).nodes, CLOUD)


def test_chains_strengths_and_times():
    twist, shear = fields.twist("z", 1.0), fields.shear("x", "y", 0.5)
    assert np.allclose(NET.deform(twist, shear).nodes, NET.deform(twist).deform(shear).nodes)
    assert not np.allclose(NET.deform(twist, shear).nodes, NET.deform(shear, twist).nodes)
    assert np.array_equal(NET.deform(twist.with_strength(0)).nodes, CLOUD)
    assert np.allclose(NET.deform(twist.with_strength(0.25)).nodes, NET.deform(fields.twist("z", 0.25)).nodes)
    keyed = twist.with_keys([1, 3], [0, 1])
    for time, rate in ((0, 0), (1, 0), (1.5, 0.25), (3, 1), (9, 1)):
        assert np.allclose(NET.deform(keyed, time=time).nodes, NET.deform(fields.twist("z", rate)).nodes)
    held, smooth = (NET.deform(twist.with_keys([1, 3], [0, 1], word), time=1.5).nodes for word in ("hold", "smooth"))
    assert np.array_equal(held, CLOUD) and np.allclose(smooth, NET.deform(fields.twist("z", 3 / 16 - 2 / 64)).nodes)
    assert np.array_equal(NET.deform().nodes, CLOUD)
    # The field that another was made from has not changed, nor has the net.
    assert twist.strength == 1 and twist.keys is None and np.array_equal(NET.nodes, CLOUD)


def test_affine_operations():
    turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
    assert np.allclose(NET.rotate([0, 0, 2], np.pi / 2, [1, 1, 0]).nodes, (CLOUD - [1, 1, 0]) @ turn.T + [1, 1, 0])
    assert np.allclose(NET.translate([1, 2, 3]).nodes, CLOUD + [1, 2, 3])
    assert np.allclose(NET.scale(3).nodes, 3 * CLOUD) and np.allclose(NET.scale([1, 2, 3]).nodes, CLOUD * [1, 2, 3])
    assert np.allclose(NET.compress("y", 0.5).nodes, CLOUD * [0.5, 1, 0.5])
    first, second = RANDOM.normal(size=(2, 3, 4))
    both = np.vstack([second, [0, 0, 0, 1]]) @ np.vstack([first, [0, 0, 0, 1]])
    assert np.allclose(NET.transform(first, second).nodes, NET.transform(both).nodes)
    # A mirrored net keeps its outside: the volume keeps its sign.
    ball = gm.Net.primitive(shape="sphere", radius=1)
    assert ball.scale([1, 1, -1]).measure().volume == pytest.approx(ball.measure().volume) and ball.measure().volume > 4


def test_morphs():
    other = NET.rotate([1, 2, 3], 1.2).translate([5, 0, 0])
    assert np.array_equal(NET.morph(other, 0).nodes, CLOUD) and np.array_equal(NET.morph(other, 1).nodes, other.nodes)
    assert np.allclose(NET.morph(other, 0.25).nodes, 0.75 * CLOUD + 0.25 * other.nodes)
    between = NET.morph(other, 0.5, "rigid").nodes.reshape(-1, 3)
    distances = [np.linalg.norm(one[:, None] - one[None], axis=2) for one in (between, CLOUD.reshape(-1, 3))]
    assert np.allclose(*distances)
    with pytest.raises(gm.InputError) as caught:
        NET.morph(gm.Net(CLOUD[:4]), 0.5)
    assert caught.value.name == "sides_differ"


def flatness(nodes):
    """The largest distance of the corners of a cell from their mean plane."""
    corners = np.stack([nodes[:-1, :-1], nodes[:-1, 1:], nodes[1:, 1:], nodes[1:, :-1]], axis=2).reshape(-1, 4, 3)
    centred = corners - corners.mean(axis=1, keepdims=True)
    normal = np.linalg.svd(centred)[2][:, 2]
    return np.abs(np.einsum("nij,nj->ni", centred, normal)).max()


def test_planar_cells():
    u, v = np.meshgrid(np.linspace(0, 2, 9), np.linspace(0, 2, 8), indexing="ij")
    saddle = gm.Net(np.stack([u, v, 0.3 * u * v + 0.1 * np.sin(3 * u)], axis=2))
    flat, report = saddle.planarise()
    assert flatness(saddle.nodes) > 1e-3 and flatness(flat.nodes) < 1e-9 and report.converged
    moved = np.linalg.norm(flat.nodes - saddle.nodes, axis=2)
    assert moved.max() == pytest.approx(report.max_displacement)
    fixed = np.zeros((9, 8), bool)
    fixed[:2, :2] = True
    held = saddle.planarise(fixed=fixed, max_iterations=20)[0]
    assert np.array_equal(held.nodes[:2, :2], saddle.nodes[:2, :2]) and not np.array_equal(held.nodes, saddle.nodes)
    deviations, report = saddle.planarity(1e-3)
    assert deviations.shape == (8, 7) and deviations.max() == report.worst and report.above == (deviations > 1e-3).sum()


def test_what_a_deformation_does():
    analysis = NET.analysis(fields=[fields.affine([[2, 0, 0, 0], [0, 3, 0, 0], [0, 0, 1, 0]])])
    assert np.allclose(analysis.report.determinants, 6) and analysis.is_soft
    lengths = [np.linalg.norm(np.diff(one, axis=1), axis=2) for one in (CLOUD, CLOUD * [2, 3, 1])]
    assert np.allclose(analysis.report.links[::2].reshape(6, 9)[:, :-1], lengths[1] / lengths[0])
    flat = gm.Net(CLOUD * [1, 1, 0])
    squeezed = np.array(flat.nodes)
    squeezed[2, 3] = squeezed[2, 4]
    hard = flat.analysis(gm.Net(squeezed))
    assert not hard.is_soft and hard.report.contracted.tolist() == [2 * (2 * 9 + 3)]
    glued = gm.Net(squeezed).glue(links=hard.report.contracted)
    assert glued.classes()[2, 4] == 2 * 9 + 3


@pytest.mark.parametrize("bad", [
    lambda: fields.twist("w", 1), lambda: fields.twist("z", "much"), lambda: fields.affine(np.eye(5)), lambda: fields.lattice([0] * 3, [1] * 3, np.zeros((1, 2, 2, 3))),
    lambda: fields.lattice([0] * 3, [1] * 3, np.zeros((2, 2, 2))), lambda: fields.lattice([0] * 3, [1] * 3, np.zeros((33, 2, 2, 3))),
    lambda: fields.spherify([0, 0], 1), lambda: fields.twist("z", 1).with_keys([0, 1], [1]), lambda: fields.twist("z", 1).with_keys([0], [1], "later"),
    lambda: NET.deform(fields.twist("z", np.nan)), lambda: NET.deform(fields.twist("z", 1).with_keys([0, 1], [0, 1]), time=np.nan), lambda: NET.deform("twist"),
    lambda: NET.deform(fields.twist("z", 1).with_keys([1, 0], [0, 1])), lambda: NET.deform(fields.wrap_cylinder("z", -1)),
    lambda: NET.deform(gm.Field("nothing", ())), lambda: NET.deform(gm.Field("twist", (1.0,) * 99, "z")), lambda: NET.deform(gm.Field("lattice", (0.0,) * 6)),
    lambda: NET.transform(np.full((3, 4), np.inf)), lambda: NET.transform(np.eye(3)), lambda: NET.rotate([0, 0, 0], 1), lambda: NET.scale([1, 2]),
    lambda: NET.displace(np.inf), lambda: NET.compress("y", np.nan), lambda: NET.morph(NET, 2), lambda: NET.morph(NET, 0.5, "curved"), lambda: NET.morph(None, 0.5),
    lambda: NET.planarise(tolerance=-1), lambda: NET.planarise(fixed=[True]), lambda: NET.planarise(fixed=np.zeros(10**6, bool), steps=1), lambda: NET.planarity(-1),
    lambda: NET.analysis(gm.Net(CLOUD[:3])), lambda: NET.analysis(tolerance=np.nan), lambda: NET.analysis(NET, fields=[fields.twist("x", 1)]),
])
def test_deformations_that_cannot_be(bad):
    with pytest.raises((ValueError, TypeError, IndexError)):
        bad()


def test_where_a_field_is_not_defined():
    nodes = CLOUD.copy()
    nodes[3, 4] = 0
    with pytest.raises(gm.InputError) as caught:
        gm.Net(nodes).deform(fields.spherify([0, 0, 0], 1))
    assert (caught.value.element, caught.value.index) == ("node", 3 * 9 + 4)


def test_long_deformations_can_be_stopped():
    class Enough(Exception):
        pass

    def stop(part, what):
        raise Enough

    u, v = np.meshgrid(np.linspace(0, 1, 600), np.linspace(0, 1, 600), indexing="ij")
    big = gm.Net(np.stack([u, v, np.sin(9 * u * v)], axis=2))
    with pytest.raises(Enough):
        big.planarise(progress=stop)
    with pytest.raises(Enough):
        big.deform(*[fields.twist("z", 1)] * 50, progress=stop)
    assert np.array_equal(big.nodes[..., 0], u)
