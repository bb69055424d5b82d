"""Lofts, nets of curves, crowded points and spheres of nodes at random: sizes, rotations, units. Judged by formulas and dense samples.

``GUSSET_CASES=200`` tries more cases of each kind.
"""

import os

import numpy as np
import pytest

import gusset_mesh as gm

CASES = range(int(os.environ.get("GUSSET_CASES", "12")))


def rotation(random):
    """A random rotation, by the factorisation of a random matrix."""
    q, r = np.linalg.qr(random.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else q[:, ::-1]


class Placement:
    """A random unit, rotation and shift, and the way back."""

    def __init__(self, random):
        self.unit, self.rotation, self.shift = 10.0 ** random.uniform(-4, 4), rotation(random), random.uniform(-10, 10, 3)

    def __call__(self, points):
        return self.unit * (np.asarray(points, float) @ self.rotation.T + self.shift)

    def back(self, points):
        return (points / self.unit - self.shift) @ self.rotation


def circle(radius, z, count, start):
    angle = start + np.linspace(0, 2 * np.pi, count, endpoint=False)
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), 0 * angle + z], axis=1)


def loft(sections, placement, columns=32):
    """The sheet through sections, and a mesh of it in the coordinates before the placement."""
    frame = gm.Frame([placement(one) for one in sections], closed=True, correspondence="arc_length", columns=columns)
    sheet = gm.Sheet.from_frame(frame)
    return sheet, placement.back(sheet.mesh(min_u=8, min_v=8).mesh.points)


def area(points):
    """The area of a polygon in space."""
    return 0.5 * np.linalg.norm(np.cross(points, np.roll(points, -1, axis=0)).sum(axis=0))


@pytest.mark.parametrize("case", CASES)
def test_steps_are_calm(case):
    """Two equal circles, a step, two equal circles: cylinders to 1 % between the equal ones."""
    random = np.random.default_rng([1, case])
    wide, narrow = random.uniform(1, 2), random.uniform(0.2, 0.9)
    heights = np.cumsum(random.uniform(0.2, 2, 4))
    sections = [circle(r, z, random.integers(12, 48), random.uniform(0, 7)) for r, z in zip((wide, wide, narrow, narrow), heights)]
    points = loft(sections, Placement(random))[1]
    radius = np.hypot(points[:, 0], points[:, 1])
    below, above = points[:, 2] < heights[1] - 1e-6, points[:, 2] > heights[2] + 1e-6
    assert below.sum() > 50 and above.sum() > 50
    assert np.abs(radius[below] / wide - 1).max() < 0.01 and np.abs(radius[above] / narrow - 1).max() < 0.01
    assert radius.max() < 1.01 * wide and radius.min() > 0.99 * narrow


@pytest.mark.parametrize("case", CASES)
def test_polygons_keep_their_corners(case):
    """Rectangles, and regular polygons of 3 to 6 sides: exact areas, from the corners alone."""
    random = np.random.default_rng([2, case])
    sides = random.integers(3, 7)
    sections = []
    for k in range(random.integers(2, 5)):
        size = random.uniform(0.5, 2, 2) if sides == 4 else np.full(2, random.uniform(0.5, 2))
        section = circle(1, 2.0 * k, sides, np.pi / 4 if sides == 4 else 0.3) * [*size, 1]
        sections.append(np.roll(section, random.integers(sides), axis=0))
    placement = Placement(random)
    sheet, _ = loft(sections, placement)
    for k, section in enumerate(sections):
        row = placement.back(sheet.curve("rows", float(k)).sample(4000).points)
        corners = np.array([row[np.linalg.norm(row - corner, axis=1).argmin()] for corner in section])
        # The samples are 1/4000 of the girth apart.
        assert np.linalg.norm(corners - section, axis=1).max() < 5e-3
        assert abs(area(row - row.mean(axis=0)) / area(section - section.mean(axis=0)) - 1) < 2e-3


@pytest.mark.parametrize("case", CASES)
def test_cones_end_in_tips(case):
    """A cone from circles and a point: its surface, with a pole."""
    random = np.random.default_rng([3, case])
    height = random.uniform(0.5, 3)
    heights = np.sort(random.uniform(0, 0.8 * height, random.integers(1, 5)))
    heights = heights[np.concatenate([[True], np.diff(heights) > 0.05 * height])]
    sections = [circle(1 - z / height, z, random.integers(16, 40), random.uniform(0, 7)) for z in heights]
    sections.append(np.array([[0, 0, height]]))
    sheet, points = loft(sections[:: random.choice([1, -1])], Placement(random))
    assert np.abs(np.hypot(points[:, 0], points[:, 1]) - (1 - points[:, 2] / height)).max() < 3e-3
    assert np.isclose(points[:, 2].max(), height, atol=1e-9)


@pytest.mark.parametrize("case", CASES)
def test_networks_in_any_order(case):
    """A net on a paraboloid, its curves shuffled and turned: all curves are on the surface."""
    random = np.random.default_rng([4, case])
    rows, columns = random.integers(3, 7, 2)
    at = Placement(random)

    def through(u, v, turn=False):
        points = at(np.stack([u, v, 0.2 * (u * u + v * v) - 0.1 * u * v], axis=1))
        return gm.Outline(points[::-1] if turn else points, curve="cubic_c2").curve

    us, vs = np.sort(random.uniform(0, 0.4, rows) + np.arange(rows)), np.sort(random.uniform(0, 0.4, columns) + np.arange(columns))
    # Joints where the curves meet, and two points between them.
    fine = [np.interp(np.arange(3 * len(x) - 2) / 3, np.arange(len(x)), x) for x in (us, vs)]
    turn = random.random(rows) < 0.4
    across = [through(0 * fine[1] + u, fine[1], t) for u, t in zip(us, turn)]
    along = [through(fine[0], 0 * fine[0] + v) for v in vs]
    random.shuffle(across), random.shuffle(along)
    surface = gm.Surface(gm.Sheet.from_curves(across, along, tolerance=1e-6 * at.unit))
    queries = np.concatenate([curve.sample(20).points for curve in across + along])
    assert max(np.linalg.norm(surface.nearest(queries).point - queries, axis=1)) < 1e-6 * at.unit


@pytest.mark.parametrize("case", CASES)
def test_near_repeats_are_told(case):
    """A circle with a point that almost repeats another: within 1e-3, or a status at the point. Merged on request."""
    random = np.random.default_rng([5, case])
    count, unit, gap = random.integers(10, 40), 10.0 ** random.uniform(-3, 3), 10.0 ** random.uniform(-10, -3)
    points = circle(1, 0, count, random.uniform(0, 7))[:, :2]
    where = random.integers(count)
    twin = points[where] + gap * random.normal(size=2)
    points = unit * np.insert(points, where + 1, twin, axis=0)
    for options in ({}, {"curve": "cubic_c2"}, {"curve": "blend_c2"}, {"method": "median"}):
        outline = gm.Outline(points, closed=True, **options)
        off = np.abs(np.linalg.norm(outline.curve.sample(2000).points[:, :2], axis=1) / unit - 1).max()
        assert off < 1e-3 or set(outline.statuses[where : where + 2]) != {"ok"}
        merged = gm.Outline(points, closed=True, repeat_tolerance=0.02, **options)
        assert merged.statuses[where + 1] == "merged"
        assert np.abs(np.linalg.norm(merged.curve.sample(2000).points[:, :2], axis=1) / unit - 1).max() < 3e-2


@pytest.mark.parametrize("case", CASES)
def test_loops_have_a_status(case):
    """Crowded points in ascending order of x: a curve that crosses itself has a status."""
    random = np.random.default_rng([6, case])
    count = random.integers(4, 12)
    steps = np.where(random.random(count) < 0.5, random.uniform(0.03, 0.15, count), random.uniform(1, 2, count))
    points = np.stack([np.cumsum(steps), random.uniform(0, 1.5, count)], axis=1) * 10.0 ** random.uniform(-3, 3)
    for options in ({}, {"method": "median"}, {"curve": "cubic_c2"}, {"curve": "cubic_c2", "method": "median"}):
        outline = gm.Outline(points, **options)
        meets = outline.curve.intersect()
        if len(meets) > 0:
            assert "looped" in outline.statuses or (np.asarray(outline.statuses) != "ok").any()


@pytest.mark.parametrize("case", CASES)
def test_spheres_of_latitudes_close(case):
    """Nodes of longitudes and latitudes, each of its own: one call closes the seam and both poles."""
    random = np.random.default_rng([7, case])
    rows, columns = random.integers(5, 30, 2)
    longitude = np.radians(np.linspace(0, 360, columns + 1) + random.uniform(-180, 180))
    latitude = np.radians(np.linspace(-90, 90, rows + 1))
    u, v = np.meshgrid(latitude, longitude, indexing="ij")
    nodes = 10.0 ** random.uniform(-3, 4) * np.stack([np.cos(u) * np.cos(v), np.cos(u) * np.sin(v), np.sin(u)], axis=2)
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    a = (i * (columns + 1) + j).ravel()
    faces = np.stack([a, a + 1, a + columns + 2, a + columns + 1], axis=1)
    expected = (rows - 1) * columns + 2
    welded = gm.weld((nodes.reshape(-1, 3), faces), vertices="all", collapse="allow", unused="remove").mesh
    net = gm.Net(nodes, "two_poles").mesh().mesh
    for mesh in (welded, net):
        check = gm.check(mesh)
        assert len(mesh.points) == expected and check.is_closed and check.report.euler == 2
