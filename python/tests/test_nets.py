"""Gluing, parts, resolutions and bridges of nets, against counts and formulas of numpy."""

import numpy as np
import pytest
import shapes

import gusset_mesh as gm
from gusset_mesh import LocalGluing, seam

NODES = shapes.grid(5, 7, lambda u, v: np.sin(3 * u) * np.cos(2 * v), span=(2.0, 3.0))
NET = gm.Net(NODES)


def euler_of(mesh):
    """Vertices - edges + faces, counted by numpy."""
    faces = [list(face) for face in mesh.faces]
    edges = {frozenset((face[k - 1], face[k])) for face in faces for k in range(len(face))}
    return len({vertex for face in faces for vertex in face}) - len(edges) + len(faces)


def points_by_position(nodes):
    """For each node the first one at its position."""
    rows, columns = nodes.shape[:2]
    _, first, inverse = np.unique(nodes.reshape(-1, 3), axis=0, return_index=True, return_inverse=True)
    return first[inverse.reshape(-1)].reshape(rows, columns)


@pytest.mark.parametrize("euler, closed, orientable, options", [
    (1, False, True, {"shape": "plane", "size": (1, 2, 0)}), (2, True, True, {"shape": "sphere", "radius": 2}), (2, True, True, {"shape": "one_pole_sphere", "radius": 2}),
    (0, False, True, {"shape": "tube", "radius": 1, "height": 2}), (2, True, True, {"shape": "cylinder", "radius": 1, "height": 2}),
    (2, True, True, {"shape": "prism", "radius": 1, "height": 2, "sides": 5}), (2, True, True, {"shape": "cone", "radius": 1, "height": 2}),
    (0, True, True, {"shape": "torus", "radius": 3, "minor_radius": 1}), (2, True, True, {"shape": "box", "size": (1, 2, 3), "cells": (2, 3, 4), "box_kind": "cross"}),
    (2, True, True, {"shape": "lathe", "profile": [[0, 0], [1, 0], [1, 2], [0, 2]]}), (0, False, False, {"shape": "moebius", "radius": 2, "size": (1, 0, 0)}),
    (0, True, False, {"shape": "klein", "radius": 2, "minor_radius": 0.5}), (1, True, False, {"shape": "projective_plane", "radius": 1}),
    (2, True, True, {"shape": "pillow", "size": (1, 1, 0), "height": 0.2}),
])
def test_standard_shapes(euler, closed, orientable, options):
    net = gm.Net.primitive(**options)
    found = net.complex()
    assert (found.report.euler, found.is_closed, found.is_orientable) == (euler, closed, orientable)
    assert euler_of(net.mesh().mesh) == euler
    assert net.validation().is_valid
    assert gm.Net.primitive(**{**options, "scalar": "f32"}).dtype == np.float32


def test_measures_of_shapes():
    box = gm.Net.primitive(shape="box", size=(1, 2, 3), cells=(1, 1, 1)).translate([5, 0, 0])
    body = box.measure(["extent", "body"])
    assert body.volume == pytest.approx(6) and body.body_volume == pytest.approx(6) and np.allclose(body.centroid, [5, 0, 0])
    assert np.allclose(np.reshape(body.inertia, (3, 3)), np.diag([4 + 9, 1 + 9, 1 + 4]) * 6 / 12)
    fine = gm.Net.primitive(shape="torus", radius=3, minor_radius=1, rows=129, columns=257)
    assert fine.measure().volume == pytest.approx(2 * np.pi**2 * 3, rel=1e-3) and fine.measure().area == pytest.approx(4 * np.pi**2 * 3, rel=1e-3)


def test_classes_are_points():
    for options in ({"shape": "sphere", "radius": 1}, {"shape": "klein", "radius": 2, "minor_radius": 0.5}, {"shape": "box", "size": (1, 2, 3), "cells": (2, 3, 4)}):
        net = gm.Net.primitive(rows=9, columns=17, **options)
        if options["shape"] != "klein":  # a figure of eight passes points twice that are not glued
            assert np.array_equal(net.classes(), points_by_position(net.nodes))
        counts = np.bincount(net.classes().reshape(-1), minlength=net.nodes[..., 0].size)
        groups = net.groups()
        assert [len(group) for group in groups] == counts[counts > 1].tolist()
        assert all((net.classes().reshape(-1)[group] == group[0]).all() for group in groups)
        # The same gluing by its matrix and seams.
        gluing = net.gluing
        again = gm.Net(net.nodes).set_gluing(matrix=gluing.matrix, seams=gluing.seams, reversed=gluing.reversed)
        assert np.array_equal(again.classes(), net.classes())


def test_gluing_by_sides_and_seams():
    assert NET.gluing.sides == set() and not NET.gluing.matrix.any() and len(NET.gluing.seams) == 0
    torus = NET.set_gluing("torus")
    assert torus.gluing.sides == {"rows_closed", "columns_closed"} and torus.complex().report.euler == 0
    matrix = torus.gluing.matrix
    assert matrix.shape == (10, 7) and matrix[0:10:2, -1].all() and matrix[-1].all() and matrix.sum() == 5 + 7
    assert np.array_equal(NET.set_gluing(matrix=matrix).classes(), torus.classes())
    band = NET.set_gluing(seams=[seam((0, 0), (1, 0), (4, 6), (-1, 0), 5)])
    found = band.complex()
    assert not found.is_orientable and found.report.euler == 0 and len(found.report.boundary_offsets) == 2
    assert len(band.gluing.seams) == 1 and sorted(map(list, band.groups())) == sorted(sorted([7 * k, 34 - 7 * k]) for k in range(5))


def test_orientable_although_not_oriented():
    """Two sheets side by side, glued along sides that are not next to each other: one of them must be turned over."""
    pair = gm.Net.concatenate([NET, NET.translate([0, 9, 0])], mode="hide").glue(LocalGluing.along(seam((0, 0), (1, 0), (0, 7), (1, 0), 5)))
    found = pair.complex("present")
    assert found.is_orientable and not found.is_oriented and found.report.component_count == 1
    # The hidden cells between them are a third face at the glued edges.
    assert len(found.report.branches) == 0 and len(pair.complex("all").report.branches) == 4


def test_gluing_of_nodes():
    glued = NET.glue(LocalGluing.star(8, "east", "south"), LocalGluing.link(2 * 24), LocalGluing.diagonal(20, "falling"))
    assert sorted(map(list, glued.groups())) == [[8, 9, 15], [23, 31], [24, 25]]
    assert glued.classify("node", 8) == "east_south" and glued.classify("node", 0) == "none" and glued.classify("cell", 20) == "falling"
    assert glued.classify("node", 24) == "horizontal"
    found = glued.gluing_occurrences()
    nodes, cells = glued.histogram()
    assert sum(nodes.values()) == (found.place == "node").sum() and sum(cells.values()) == (found.place == "cell").sum()
    assert nodes["east_south"] == 1 and cells["falling"] == 1
    assert glued.unglue(LocalGluing.star(8, "east", "south")).classes()[1, 2] == 9
    snapped = glued.glue(snap=True)
    moved = np.linalg.norm(snapped.unglue(LocalGluing.link(2 * 24), separation=0.1).nodes - snapped.nodes, axis=2).reshape(-1)
    assert np.flatnonzero(moved).tolist() == [24, 25] and np.allclose(moved[[24, 25]], 0.05)
    assert np.array_equal(NET.glue(LocalGluing.of_type("point", 3)).classes(), NET.glue(LocalGluing.cell(3, "top", "right", "bottom", "left")).classes())
    assert np.array_equal(NET.glue(LocalGluing.along(seam((0, 0), (0, 1), (4, 0), (0, 1), 7))).classes(), NET.set_gluing("columns_closed").classes())


def test_gluing_that_coordinates_imply():
    ball = gm.Net.primitive(shape="sphere", radius=1)
    found = gm.Net(ball.nodes).glue(detect=1e-9)
    assert np.array_equal(found.classes(), ball.classes()) and found.complex().is_closed
    rough = np.array(ball.nodes)
    rough[:, -1] += 1e-6
    snapped = gm.Net(rough).glue(detect=1e-5, snap=True)
    assert np.array_equal(snapped.nodes[:, -1], snapped.nodes[:, 0])
    wrong = gm.Net(rough).set_gluing("tube").validation()
    assert not wrong.is_valid and wrong.report.findings.distance.max() == pytest.approx(3**0.5 * 1e-6, rel=1e-3)
    assert gm.Net(rough).set_gluing("tube").validation(1e-5).is_valid


def test_parts_and_symmetries():
    assert np.array_equal(NET[1:4, 2:].nodes, NODES[1:4, 2:]) and np.array_equal(NET[-2:].nodes, NODES[-2:])
    for quarters in range(-1, 5):
        assert np.array_equal(NET.turn(quarters).nodes, np.rot90(NODES, quarters))
    assert np.array_equal(NET.flip("down").nodes, NODES[::-1])
    assert NET.astype(np.float32).dtype == np.float32 and np.array_equal(NET.astype("f4").nodes, NODES.astype("f4"))
    wide = NET.enlarge(columns=10, replication="last")
    assert np.array_equal(wide.nodes[:, 6:], np.repeat(NODES[:, 6:], 4, axis=1)) and np.array_equal(wide.compact().nodes, NODES)
    marked = NODES.copy()
    marked[2, 3, 2] = -9999
    cleared = gm.Net(marked).clear_no_data(-9999)
    assert np.flatnonzero(np.isnan(cleared.nodes).any(axis=2)).tolist() == [2 * 7 + 3] and cleared.mesh().mesh.face_count == 24 - 4


def test_resolutions():
    u, v = np.meshgrid(np.linspace(0, 1, 9), np.linspace(0, 1, 13), indexing="ij")
    made = gm.Net(np.stack([u, v, u * v], axis=2)).resample(5, 7, "bilinear").nodes
    assert np.allclose(made[..., 2], made[..., 0] * made[..., 1])
    levels = gm.Net(shapes.grid(17, 33, lambda u, v: u * v)).pyramid()
    assert levels[0].shape == (17, 33) and levels[-1].shape == (2, 2)
    for fine, coarse in zip(levels, levels[1:]):
        rows, columns = (2 if count > 2 else 1 for count in fine.shape)
        assert np.array_equal(coarse.nodes, fine.nodes[::rows, ::columns])


def test_decimation():
    u = np.linspace(0, 4, 41)
    bent = np.stack([*np.meshgrid(u, np.linspace(0, 1, 5), indexing="ij")] + [np.broadcast_to(np.abs(u - 1)[:, None], (41, 5))], axis=2)
    made = gm.Net(bent).decimate(1e-9)
    assert made.rows.tolist() == [0, 10, 40] and made.columns.tolist() == [0, 4] and made.deviation <= 1e-9
    assert np.array_equal(made.net.nodes, bent[np.ix_(made.rows, made.columns)])
    wavy = gm.Net(shapes.grid(60, 4, lambda u, v: 0.1 * np.sin(9 * u))).decimate(0.01)
    rows = wavy.rows
    between = np.interp(np.arange(60), rows, 0.1 * np.sin(9 * rows / 59))
    assert 2 < len(rows) < 40 and np.abs(between - 0.1 * np.sin(9 * np.arange(60) / 59)).max() <= 0.0101


@pytest.mark.parametrize("cells", ["quads", "triangles"])
def test_grids_in_meshes(cells):
    faces = "quads" if cells == "quads" else "triangles_fixed"
    mesh = NET.mesh(faces=faces).mesh
    shuffled = np.random.default_rng(1).permutation(mesh.face_count)
    net, grid = gm.Net.find_grid((mesh.points, np.asarray(mesh.faces)[shuffled]), cells=cells)
    assert sorted(net.shape) == [5, 7]
    assert np.array_equal(net.nodes.reshape(-1, 3), mesh.points[grid.report.vertex_of_node])
    assert len(set(grid.report.face_of_cell.tolist())) == 24
    with pytest.raises(gm.InputError):
        gm.Net.find_grid(shapes.cap())


def test_bridges():
    other = NET.translate([0, 4, 0])
    joined = gm.Net.concatenate([NET, other], rows=2)
    assert joined.shape == (5, 16) and len(joined.bridges()) == 1 and joined.gluing.bridge_count == 1
    bridge = joined.bridges()[0]
    assert (bridge.at, bridge.rows, bridge.start, bridge.end) == (9, 2, 0, 5)
    first, second = joined.split(0)
    assert np.array_equal(first.nodes, NODES) and np.array_equal(second.nodes, other.nodes)
    hidden = joined.set_bridge(0, "hide", tension=2.5)
    assert hidden.mesh().mesh.face_count == joined.mesh().mesh.face_count - 4 * 3
    assert (hidden.bridges()[0].properties.tension, joined.bridges()[0].properties.tension) == (2.5, 0)
    # Only what is given changes.
    assert hidden.set_bridge(0, stiffness=1).bridges()[0].properties.tension == 2.5


def test_a_film_between_rings_is_a_catenoid():
    ring = gm.Net.primitive(shape="tube", radius=1, height=0.01, rows=2, columns=65)
    film = gm.Net.concatenate([ring.translate([0, 0, -0.5]), ring.translate([0, 0, 0.5])], direction="down", rows=31)
    made, report = film.set_bridge(0, tension=1).settle()
    assert report.converged and report.settled == 1
    height = 0.5 - 0.005
    a = 0.85
    for _ in range(50):  # a cosh(height / a) = 1
        a -= (a * np.cosh(height / a) - 1) / (np.cosh(height / a) - height / a * np.sinh(height / a))
    x, y, z = np.moveaxis(made.nodes, 2, 0)
    assert np.abs(np.hypot(x, y) - a * np.cosh(z / a))[1:-1].max() < 2e-3 < 1 - a
    held, _ = film.set_bridge(0, elasticity=1).settle(reference=film, free=[False, True])
    assert held.shape == film.shape


def test_nets_do_not_change():
    """Each call makes another net; what was lent stays."""
    ball, first = gm.Net.primitive(shape="sphere", radius=1), gm.Net.primitive(shape="sphere", radius=1).nodes
    lent = ball.coordinates
    ball.mesh()
    for changed in (ball.translate([1, 0, 0]), ball.displace(1), ball.set_gluing("sheet"), ball.glue(detect=0.0), ball.planarise(max_iterations=1)[0],
                    ball.deform(gm.fields.twist("z", 3)), ball.clear_no_data(1.0)):
        assert changed is not ball
    assert np.array_equal(np.stack(lent, axis=2), first) and not lent[0].flags.writeable
    assert np.array_equal(ball.nodes, first) and ball.gluing.sides == gm.Net.primitive(shape="sphere", radius=1).gluing.sides


@pytest.mark.parametrize("bad", [
    lambda: gm.Net.primitive(shape="cube"), lambda: gm.Net.primitive(shape="sphere", radius=-1), lambda: gm.Net.primitive(shape="sphere", radius=np.nan),
    lambda: gm.Net.primitive(shape="sphere", radius=1, rows=2**40, columns=2**40), lambda: gm.Net.primitive(shape="sphere", radius=1, rows=-1),
    lambda: gm.Net.primitive(shape="sphere", radius=1, corners=3), lambda: gm.Net.primitive(shape="lathe", profile=[1, 2, 3]), lambda: gm.Net.primitive(shape="lathe"),
    lambda: gm.Net.primitive(shape="box", size=(1, 1, 1), cells=(0, 1, 1)), lambda: gm.Net.primitive(shape="plane", size=(1, 1, 1, 1)),
    lambda: NET[1:1], lambda: NET[::2], lambda: NET[3], lambda: NET[1:3, 1:3, 1:3], lambda: NET[1:2], lambda: NET.astype(np.int32), lambda: NET.enlarge(rows=2),
    lambda: NET.enlarge(rows=2**63), lambda: NET.resample(1, 5), lambda: NET.resample(2**62, 2**62), lambda: NET.resample(3, 3, "cubic"), lambda: NET.decimate(np.nan),
    lambda: NET.decimate(-1), lambda: NET.set_gluing("knot"), lambda: NET.set_gluing(matrix=np.zeros((5, 7))), lambda: NET.set_gluing("torus", matrix=np.zeros((10, 7))),
    lambda: NET.set_gluing(matrix=np.full((10, 7), 9)), lambda: NET.set_gluing(seams=[seam((0, 0), (1, 0), (9, 9), (1, 0), 5)]), lambda: NET.set_gluing(seams=[1]),
    lambda: NET.set_gluing(seams=[seam((-1, 0), (1, 0), (0, 1), (1, 0), 5)]), lambda: NET.glue(LocalGluing.link(10**6)), lambda: NET.glue("link"),
    lambda: NET.glue(LocalGluing("link", -1)), lambda: NET.glue(LocalGluing("loop")), lambda: NET.glue(links=[10**6]), lambda: NET.glue(links=[-1]),
    lambda: NET.glue(links=[0.5]), lambda: NET.glue(detect=np.nan), lambda: NET.glue(LocalGluing.diagonal(0, "falling"), LocalGluing.diagonal(0, "rising")),
    lambda: NET.unglue(LocalGluing.link(0), separation=-1), lambda: NET.classify("node", 35), lambda: NET.classify("edge", 0), lambda: NET.classify("node", 2**40),
    lambda: NET.split(0), lambda: NET.set_bridge(0), lambda: NET.set_bridge(0, tension=1), lambda: NET.set_bridge(-1), lambda: NET.settle(reference=3),
    lambda: NET.settle(reference=NET[:3]), lambda: NET.settle(tolerance=np.nan), lambda: NET.validation(-1), lambda: NET.complex("some"), lambda: NET.clear_no_data("x"),
    lambda: NET.turn(0.5), lambda: NET.flip("left"), lambda: gm.Net.find_grid(([[0, 0, 0]], [[0, 0, 9]])), lambda: gm.Net.find_grid(NET.mesh().mesh, face=-1),
])
def test_what_nets_refuse(bad):
    with pytest.raises((ValueError, TypeError, IndexError)):
        bad()
