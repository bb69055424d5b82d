"""Random polygons, curves and sections of the kinds of faults that people report. See kinds.py."""

import math

import numpy as np

import gusset_mesh as gm
from gusset_mesh import filters
from kind_judge import Case, Look, Place, close


def polygon_area(points):
    x, y = np.asarray(points, dtype=float)[:, :2].T
    return float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2


def spikes(random):
    """A simple polygon around the origin with concave corners."""
    count = int(random.integers(4, 30))
    angles = 2 * np.pi * (np.arange(count) + 0.6 * random.random(count)) / count
    radii = 0.3 + random.random(count)
    return np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=1)


def comb(random):
    """A comb: teeth of a common height, with collinear corners."""
    teeth, height = int(random.integers(1, 9)), 0.5 + 3 * random.random()
    top = [p for k in range(teeth, 0, -1) for p in ((2 * k + 1, height), (2 * k, height), (2 * k, 1), (2 * k - 1, 1))]
    return np.array([(0, 0), (2 * teeth + 1, 0), *top, (1, height), (0, height)], dtype=float)


def keyhole(random):
    """A wall with a window, cut open between both: two vertices are there twice."""
    w, h = 2 + 4 * random.random(2)
    x, y, dx, dy = *(0.2 + 0.4 * random.random(2)) * [w, h], 0.3 * w, 0.3 * h
    return np.array([(0, 0), (w, 0), (w, h), (0, h), (0, 0), (x, y), (x, y + dy), (x + dx, y + dy), (x + dx, y), (x, y)])


def concave_polygons(random):
    """Concave polygons are split into triangles of the same area."""
    flat, place = (spikes, comb, keyhole)[random.integers(3)](random), Place(random)
    area = polygon_area(flat)
    given = gm.Mesh(place.points(np.column_stack([flat, np.zeros(len(flat))])), np.arange(len(flat), dtype=np.uint32)[None])
    return Case(lambda: (gm.triangulate(given).mesh, ""), lambda look: close(look.area / place.size**2, area, 1e-9))


def keyholes(random):
    """Walls with windows, whose sides are cut open between the outline and each window: closed solids."""
    windows, thick, place = int(random.integers(1, 5)), 0.1 + random.random(), Place(random)
    w, h = windows * (1 + random.random()), 1 + 2 * random.random()
    # Each window has a share of the width. All sills are at one height, so that no cut crosses a window.
    sill, part = random.uniform(0.2, 0.4) * h, w / windows
    rings = [np.array([(0, 0), (w, 0), (w, h), (0, h)])]
    for k in range(windows):
        x, dx, dy = k * part + random.uniform(0.1, 0.3) * part, random.uniform(0.2, 0.6) * part, random.uniform(0.2, 0.5) * h
        rings.append(np.array([(x, sill), (x, sill + dy), (x + dx, sill + dy), (x + dx, sill)]))
    flat, count = np.concatenate(rings), 4 * (windows + 1)
    outline = [0, 1, 2, 3]
    for k in range(1, windows + 1):
        outline += [0, *range(4 * k, 4 * k + 4), 4 * k]
    corners = np.arange(count)
    after = corners - corners % 4 + (corners + 1) % 4
    points = np.concatenate([np.column_stack([flat, np.full(count, z)]) for z in (0, thick)])
    faces = [np.array(outline)[::-1], np.array(outline) + count, *np.stack([corners, after, after + count, corners + count], axis=1)]
    given = gm.Mesh(place.points(points), [face.astype(np.uint32) for face in faces])
    volume = sum(polygon_area(ring) for ring in rings) * thick
    return Case(lambda: (gm.triangulate(given).mesh, ""),
                lambda look: look.closed and look.euler == 2 - 2 * windows and close(look.volume / place.size**3, volume, 1e-9))


def prisms(random):
    """Prisms over concave polygons: closed, with the volume of base times height."""
    flat, place, height = (spikes, comb)[random.integers(2)](random), Place(random), 0.5 + random.random()
    n, volume = len(flat), polygon_area(flat) * height
    k = np.arange(n)
    points = np.concatenate([np.column_stack([flat, np.full(n, z)]) for z in (0, height)])
    faces = [k[::-1], k + n, *np.stack([k, (k + 1) % n, (k + 1) % n + n, k + n], axis=1)]
    given = gm.Mesh(place.points(points), [face.astype(np.uint32) for face in faces])
    return Case(lambda: (gm.triangulate(given).mesh, ""), lambda look: look.closed and close(look.volume / place.size**3, volume, 1e-9))


def local(mesh, place):
    return (np.asarray(mesh.points, dtype=float) - place.origin) @ place.turn / place.size


def rectangles(random):
    """A loft through rectangles has exactly these at its ends."""
    from scipy.spatial import ConvexHull
    sides, place = 0.5 + 4 * random.random((int(random.integers(2, 5)), 2)), Place(random)
    sections = [place.points([(-w, -h, z), (w, -h, z), (w, h, z), (-w, h, z)]) for z, (w, h) in enumerate(sides)]

    def run():
        mesh, text = filters.loft(gm.Curves(sections, closed=True))
        points, worst = local(mesh, place), 0.0
        for z in (0, len(sides) - 1):
            ring = points[abs(points[:, 2] - z) < 1e-6, :2]
            w, h = sides[z]
            worst = max(worst, abs(ConvexHull(ring).volume / (4 * w * h) - 1), *(abs(ring).max(axis=0) / [w, h] - 1))
        return worst, text
    return Case(run, lambda worst: worst < 1e-9, raw=True)


def circle(segments, radius, z):
    angles = 2 * np.pi * np.arange(segments) / segments
    return np.column_stack([radius * np.cos(angles), radius * np.sin(angles), np.full(segments, z)])


def equal_sections(random):
    """Between two equal sections a loft is their cylinder, whatever comes before and after."""
    segments, place = int(random.integers(16, 60)), Place(random)
    radii = 0.3 + 2 * random.random(int(random.integers(3, 6)))
    step = int(random.integers(len(radii) - 1))
    radii[step + 1] = radii[step]
    sections = [place.points(circle(segments, radius, z)) for z, radius in enumerate(radii)]

    def run():
        mesh, text = filters.loft(gm.Curves(sections, closed=True))
        points = local(mesh, place)
        between = points[(points[:, 2] > step - 1e-9) & (points[:, 2] < step + 1 + 1e-9)]
        return np.abs(np.hypot(*between[:, :2].T) / radii[step] - 1).max(), text
    return Case(run, lambda off: off < 0.01, raw=True)


def mixed_sections(random):
    """Sections of which some have corners: these are polygons at both ends of the loft, and the others are round."""
    place, count = Place(random), int(random.integers(2, 5))
    kinds = [("round", "polygon")[k] for k in random.integers(0, 2, count)]
    kinds[0], kinds[-1] = (("round", "polygon"), ("polygon", "round"), ("polygon", "polygon"))[random.integers(3)]
    radii, sides, turns = 0.5 + 2 * random.random(count), random.integers(3, 7, count), 2 * np.pi * random.random(count)
    sections = []
    for z, (kind, radius, n, turn) in enumerate(zip(kinds, radii, sides, turns)):
        flat = circle(int(n) if kind == "polygon" else int(random.integers(24, 80)), radius, z)
        rotation = np.array([[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1]])
        sections.append(flat @ rotation.T)

    def run():
        mesh, text = filters.loft(gm.Curves([place.points(section) for section in sections], closed=True))
        points, worst = local(mesh, place), 0.0
        for z in (0, count - 1):
            ring = points[abs(points[:, 2] - z) < 1e-6, :2]
            if kinds[z] == "round":
                worst = max(worst, np.abs(np.hypot(*ring.T) / radii[z] - 1).max() / 0.01)
            else:
                apart = np.linalg.norm(sections[z][:, None, :2] - ring, axis=2).min(axis=1).max()
                worst = max(worst, apart / 1e-9, distance_from_sides(ring, sections[z][:, :2]) / 1e-9)
        return worst, text
    return Case(run, lambda worst: worst < 1, raw=True)


def distance_from_sides(points, polygon):
    """The largest distance of a point from the sides of a polygon."""
    start, side = polygon, np.roll(polygon, -1, axis=0) - polygon
    offset = points[:, None] - start
    t = np.clip((offset * side).sum(axis=2) / (side * side).sum(axis=1), 0, 1)
    return float(np.linalg.norm(offset - t[..., None] * side, axis=2).min(axis=1).max())


def tips(random):
    """A section of one point closes the loft: one border is left, of a disc; with two tips none, of a sphere."""
    segments, place, both = int(random.integers(8, 40)), Place(random), random.random() < 0.5
    points = [circle(segments, 0.3 + random.random(), z) for z in range(1, int(random.integers(2, 4)))]
    points.append(np.array([[0, 0, len(points) + 1.0]]))
    if both:
        points.insert(0, np.zeros((1, 3)))
    closed = [len(p) > 1 for p in points]
    curves = gm.Curves([place.points(p) for p in points], closed=closed)
    return Case(lambda: filters.loft(curves), lambda look: look.consistent and (look.closed and look.euler == 2 if both else
                                                                                  look.loops is not None and len(look.loops) == 1 and look.euler == 1))


def networks(random):
    """A net of curves gives the same surface in any order and direction of its curves."""
    rows, columns = (int(k) for k in random.integers(2, 6, 2))
    place, waves, size = Place(random), 1 + 2 * random.random(2), 1 + random.random(2)
    u, v = (np.sort(np.concatenate([[0, 1], 0.1 + 0.8 * (np.arange(n - 2) + 0.2 + 0.6 * random.random(n - 2)) / max(n - 2, 1)])) for n in (rows, columns))

    def at(x, y):
        return place.points(np.stack([size[0] * x, size[1] * y, 0.3 * np.sin(waves[0] * x) * np.cos(waves[1] * y)], axis=-1))
    # Each curve has a point where it crosses another.
    x, y = (np.union1d(np.linspace(0, 1, 20), t) for t in (v, u))
    across = [at(x, np.full(len(x), t)) for t in u]
    along = [at(np.full(len(y), t), y) for t in v]

    def mixed(curves):
        return [curves[k][::random.choice([1, -1])] for k in random.permutation(len(curves))]
    orders = gm.Curves(mixed(across)), gm.Curves(mixed(along))

    def run():
        made, text = filters.smooth_net(*orders)
        plain, _ = filters.smooth_net(gm.Curves(across), gm.Curves(along))
        ours, other = Look(made), Look(plain)
        bounds = [np.r_[local(m, place).min(0), local(m, place).max(0)] for m in (made, plain)]
        return max(abs(ours.area / other.area - 1), np.abs(bounds[0] - bounds[1]).max()), text
    return Case(run, lambda off: off < 2e-3, raw=True)


def crosses(points, closed=True):
    """Whether a polyline crosses itself, by the signs of areas."""
    a, b = points, np.roll(points, -1, axis=0)
    n = len(a)

    def side(p, q, r):
        return np.sign((q[..., 0] - p[..., 0]) * (r[..., 1] - p[..., 1]) - (q[..., 1] - p[..., 1]) * (r[..., 0] - p[..., 0]))
    p, q = a[:, None], b[:, None]
    found = (side(p, q, a[None]) * side(p, q, b[None]) < 0) & (side(a[None], b[None], p) * side(a[None], b[None], q) < 0)
    i, j = np.indices((n, n))
    apart = (i - j) % n
    found &= (apart > 1) & (apart < n - 1)
    return bool((found if closed else found[:-1, :-1]).any())


KINDS_OF_CURVES = {}, {"method": "median"}, {"curve": "cubic_c2"}, {"curve": "blend_c2"}


def oval(random, widest):
    """Points of an ellipse, some of them crowded: their distances are up to 10 ** widest and a hundredth of that."""
    angles = 2 * np.pi * (np.arange(12) + 0.5 * random.random(12)) / 12
    crowd = angles[random.integers(12)] + np.cumsum(10.0 ** random.uniform(widest - 2, widest, int(random.integers(1, 6))))
    angles = np.sort(np.concatenate([angles, crowd]))
    return np.stack([2 * np.cos(angles), (0.8 + random.random()) * np.sin(angles)], axis=1) * 10 ** random.uniform(-3, 3)


def loops_of(points, **options):
    """Whether the curve crosses itself, and the statuses of points that are not as was asked for."""
    made = gm.Outline(points, closed=True, **options)
    return crosses(made.curve.sample(1200).points[:, :2]), sorted({str(word) for word in made.statuses} - {"ok", "merged"})


def crowded_points(random):
    """Points a tenth to a thousandth of the others' distance apart: the default curve has no loops."""
    points = oval(random, -1)

    def run():
        crossed, said = loops_of(points)
        return crossed, f"remain: {said}" if said else ""
    return Case(run, lambda crossed: not crossed, raw=True)


def tight_points(random):
    """Points still closer, through curves of all kinds: no loops, or statuses that say so, and none when these points are merged."""
    points, options = oval(random, -2), KINDS_OF_CURVES[random.integers(4)]

    def run():
        crossed, said = loops_of(points, **options)
        if crossed and said:
            crossed, said = loops_of(points, repeat_tolerance=0.02, **options)
        return crossed, f"remain: {said}" if said else ""
    return Case(run, lambda crossed: not crossed, raw=True)


def almost_repeated(random):
    """A ring whose last point almost repeats the first: a status says so, and merged it is as good a circle as without that point."""
    count, size = int(random.integers(8, 40)), 10 ** random.uniform(-3, 3)
    angles = 2 * np.pi * (random.random() + np.arange(count) / count)
    ring = size * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    off = size * 2 * np.pi / count * 10 ** random.uniform(-8, -5.5)
    given, options = np.vstack([ring, ring[0] + off * random.standard_normal(2)]), KINDS_OF_CURVES[random.integers(4)]

    def error(points, **more):
        made = gm.Outline(points, closed=True, **options, **more)
        return np.abs(np.linalg.norm(made.curve.sample(800).points[:, :2], axis=1) / size - 1).max(), set(made.statuses)

    def run():
        more, statuses = error(given)
        if statuses & {"crowded", "looped"}:
            more, _ = error(given, repeat_tolerance=1e-4)
        return more - error(ring)[0], ""
    return Case(run, lambda more: more < 1e-3, raw=True)


def stars(random):
    """The star polygon {n/k} has n (k - 1) crossings."""
    n = 2 * int(random.integers(2, 20)) + 1
    k = int(random.choice([k for k in range(2, (n + 1) // 2) if math.gcd(n, k) == 1]))
    angles = 2 * np.pi * (random.random() + k * np.arange(n) / n)
    star = 10 ** random.uniform(-3, 3) * np.column_stack([np.cos(angles), np.sin(angles), np.zeros(n)])

    def run():
        places, text = filters.curve_meet(gm.Curves([star], closed=True), between="straight")
        return len(places), text
    return Case(run, lambda count: count == n * (k - 1), raw=True)


def nested_polygons(random):
    """The strip between two nested convex polygons covers what lies between them."""
    m, n = (int(k) for k in random.integers(3, 12, 2))
    inner, place = circle(n, 0.9 * math.cos(math.pi / m) * random.uniform(0.3, 0.9), 0.0), Place(random)
    turn = random.random() * 2 * np.pi
    inner = inner @ np.array([[math.cos(turn), math.sin(turn), 0], [-math.sin(turn), math.cos(turn), 0], [0, 0, 1]])
    outer = circle(m, 1.0, 0.0)
    area = polygon_area(outer) - polygon_area(inner)
    curves = gm.Curves([place.points(outer), place.points(inner)], closed=True)
    return Case(lambda: filters.strip(curves), lambda look: look.flat == 0 and close(look.area / place.size**2, area))


CURVES = (concave_polygons, keyholes, prisms, rectangles, equal_sections, mixed_sections, tips, networks, crowded_points, tight_points, almost_repeated, stars, nested_polygons)
