"""Sections of meshes against volumes, trimesh's polylines and each other."""

import numpy as np
import pytest

import gusset_mesh as gm


def torus(n=24, m=12):
    u, v = np.meshgrid(np.arange(n) * 2 * np.pi / n, np.arange(m) * 2 * np.pi / m, indexing="ij")
    radius = 2 + 0.7 * np.cos(v)
    points = np.stack([radius * np.cos(u), radius * np.sin(u), 0.7 * np.sin(v)], axis=-1).reshape(-1, 3)
    i, j = (index.ravel() for index in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    a, b, c, d = i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m
    return points, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def test_sections_are_in_their_planes_and_carry_positions():
    points, faces = torus()
    offsets = [-0.4, 0.1, 0.5]
    found = gm.sections((points, faces), [0, 0, 0], [0, 0, 1], offsets)
    assert found.closed.all() and found.planes.tolist() == [0, 0, 1, 1, 2, 2]
    for polyline, plane in zip(found, found.planes):
        assert np.allclose(polyline[:, 2], offsets[plane], atol=1e-14)
    assert np.allclose(found.carry(points), found.report.points, atol=1e-14)
    for k, path in enumerate(found.paths):
        assert (path.parent == 2**32 - 1) == (path.depth == 0) == (path.area > 0), k


def test_every_kind_of_plane_gives_one_section():
    mesh = torus()
    stack = gm.sections(mesh, [0, 0, 0.1], [0, 1, 0])
    others = [
        gm.sections_by_planes(mesh, [gm.Plane([0, 0, 0.1], [0, 1, 0])]),
        gm.sections_about_axis(mesh, [0, 0, 0], [0, 0, 1], [1, 0, 0], [0.0]),
        gm.sections_across(mesh, [[0, -1, 0], [0, 1, 0]], [1.0]),
    ]
    for other in others:
        assert len(other) == len(stack) == 2
        assert np.allclose(other.report.points, stack.report.points, atol=1e-12)


def test_simplified_sections_keep_points():
    mesh = torus(200, 100)
    full, few = (gm.sections(mesh, [0, 0, 0.1], [0, 0, 1], tolerance=tolerance) for tolerance in (0.0, 0.01))
    for all_points, kept in zip(full, few):
        assert len(kept) < len(all_points) / 4
        assert {tuple(p) for p in kept} <= {tuple(p) for p in all_points}


def test_mistakes_are_named():
    with pytest.raises(gm.InputError, match="normal"):
        gm.sections(torus(), [0, 0, 0], [0, 0, 0])
    with pytest.raises(gm.InputError, match="offsets"):
        gm.sections(torus(), [0, 0, 0], [0, 0, 1], [1.0, 0.0])
