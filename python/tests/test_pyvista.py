"""PyVista's accessor, and what it carries along."""

import numpy as np
import pytest
import shapes

pv = pytest.importorskip("pyvista")

import gusset_mesh as gm  # noqa: E402
import gusset_mesh.pyvista as ours  # noqa: E402
from gusset_mesh._vtk import from_polydata, surface_of  # noqa: E402


def halves():
    ball = pv.Sphere(theta_resolution=24, phi_resolution=25)
    upper = surface_of(ball.extract_cells(ball.cell_centers().points[:, 2] > 0.06))
    lower = surface_of(ball.extract_cells(ball.cell_centers().points[:, 2] < -0.06))
    for side, half in enumerate((upper, lower)):
        half.point_data["height"] = half.points[:, 2].astype(float)
        half.point_data["colour"] = (127.5 + 255 * half.points).astype(np.uint8)
        half.cell_data["material"] = np.full(half.n_cells, side + 1)
    return upper, lower


def test_conversion_there_and_back():
    for mesh in (pv.Sphere(), pv.Plane(), pv.Icosahedron(), surface_of(pv.Plane().merge(pv.Sphere()))):
        back = ours.to_polydata(from_polydata(mesh))
        assert np.array_equal(back.points, mesh.points) and np.array_equal(back.faces, mesh.faces)
    ball = pv.Sphere()
    assert np.shares_memory(from_polydata(ball).points, ball.points)
    assert gm.check(ball).is_closed
    with pytest.raises(ValueError, match="strips"):
        gm.check(ball.strip())
    with pytest.raises(gm.InputError):
        gm.check(pv.PolyData())


def test_stitch_carries_arrays():
    upper, lower = halves()
    whole = upper.gusset.stitch(lower, outward="closed")
    assert whole.is_manifold and whole.volume == pytest.approx(4 / 3 * np.pi / 8, rel=0.05)
    assert np.allclose(whole.point_data["height"], whole.points[:, 2], atol=1e-6)
    assert whole.point_data["colour"].dtype == np.uint8 and whole.point_data["colour"].shape == (whole.n_points, 3)
    assert np.array_equal(np.bincount(whole.cell_data["material"])[1:] >= [upper.n_cells, lower.n_cells], [True, True])
    # Each old face has its own material.
    side = np.where(whole.cell_centers().points[:, 2] > 0, 1, 2)
    old = np.abs(whole.cell_centers().points[:, 2]) > 0.06
    assert np.array_equal(whole.cell_data["material"][old], side[old])


def test_truth_values_stay_such():
    upper, lower = halves()
    for half in (upper, lower):
        half.cell_data["is_kept"] = np.arange(half.n_cells) % 2 == 0
        half.point_data["is_high"] = half.points[:, 2] > 0.2
    whole = upper.gusset.stitch(lower)
    assert whole.cell_data["is_kept"].dtype == bool and whole.point_data["is_high"].dtype == bool
    assert np.array_equal(whole.cell_data["is_kept"][:upper.n_cells], upper.cell_data["is_kept"])
    assert np.array_equal(whole.point_data["is_high"], whole.points[:, 2] > 0.2)


def test_blend_and_normals():
    upper, lower = (half.compute_normals(cell_normals=False, auto_orient_normals=False, consistent_normals=False) for half in halves())
    whole = upper.gusset.stitch(lower, finish="blend")
    normals = whole.point_data["Normals"]
    assert np.allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)
    assert (np.einsum("ij,ij->i", normals, whole.points) > 0).all()


def test_the_other_jobs():
    upper, lower = halves()
    assert upper.gusset.join(lower, fill=True).is_manifold
    filled = upper.gusset.fill(refine="rim_density", fairing="thin_plate")
    assert filled.is_manifold and np.allclose(filled.point_data["height"][:upper.n_points], upper.points[:, 2], atol=1e-6)
    assert upper.gusset.boundary_loops().n_cells == 1
    assert upper.gusset.check().is_manifold
    soup = upper.triangulate()
    soup = pv.PolyData(soup.points[soup.regular_faces.reshape(-1)], faces=np.insert(np.arange(3 * soup.n_cells).reshape(-1, 3), 0, 3, axis=1))
    assert soup.gusset.weld(vertices="all", unused="remove").n_points == upper.n_points
    turned = upper.copy()
    assert turned.gusset.orient().n_cells == upper.n_cells
    assert upper.gusset.sew().n_cells == upper.n_cells


def test_filters_by_name():
    upper, lower = halves()
    made, report = upper.gusset.develop()
    assert made.n_cells and "height" in made.point_data and report.values
    loops, report = upper.gusset.__getattr__("boundary_loops")()
    assert loops.n_lines == 1
    with pytest.raises(AttributeError, match="develop"):
        upper.gusset.nothing_of_the_kind
    assert "join" in dir(upper.gusset) and "develop" in dir(upper.gusset)


def test_cells_that_are_no_polygons_are_left_out():
    upper, _ = halves()
    mixed = surface_of(upper.merge(pv.Line((5, 0, 0), (6, 0, 0))))
    assert mixed.n_lines == 1
    mixed.cell_data["number"] = np.arange(mixed.n_cells)
    closed = mixed.gusset.fill()
    assert closed.n_cells >= upper.n_cells
    assert np.array_equal(closed.cell_data["number"][:upper.n_cells], np.arange(1, upper.n_cells + 1))
