"""Random meshes of the kinds of faults that people report, each with the value that is right. See kinds.py."""

import numpy as np

import gusset_mesh as gm
from gusset_mesh import filters
from kind_judge import Case, Place, area_of, close, solid_volume


def tube(segments, base, top, radius=1.0):
    angles = 2 * np.pi * np.arange(segments) / segments
    ring = np.stack([radius * np.cos(angles), radius * np.sin(angles)], axis=1)
    points = np.concatenate([np.column_stack([ring, np.full(segments, z)]) for z in (base, top)])
    k = np.arange(segments)
    return points, np.stack([k, (k + 1) % segments, (k + 1) % segments + segments, k + segments], axis=1)


def sheet(xs, ys, height=None):
    x, y = np.meshgrid(xs, ys, indexing="ij")
    z = np.zeros_like(x) if height is None else height(x, y)
    i, j = np.meshgrid(np.arange(len(xs) - 1), np.arange(len(ys) - 1), indexing="ij")
    a = (i * len(ys) + j).ravel()
    return np.stack([x, y, z], axis=-1).reshape(-1, 3), np.stack([a, a + len(ys), a + len(ys) + 1, a + 1], axis=1)


def box(low, high):
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]) * (np.subtract(high, low)) + low
    return corners, np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])


def ball(random, radius=1.0):
    """A closed ball of triangles."""
    import trimesh
    made = trimesh.creation.icosphere(int(random.integers(1, 4)), radius)
    return np.array(made.vertices), np.array(made.faces)


def torus(random):
    import trimesh
    made = trimesh.creation.torus(1, 0.2 + 0.3 * random.random(), int(random.integers(8, 24)), int(random.integers(6, 16)))
    return np.array(made.vertices), np.array(made.faces)


def solid(random):
    return (lambda: ball(random), lambda: torus(random),
            lambda: cut(box([0, 0, 0], 0.4 + random.random(3))))[random.integers(3)]()


def cut(mesh):
    return mesh[0], gm.Mesh(*mesh).triangles().astype(np.int64)


def united(*meshes):
    starts = np.cumsum([0, *(len(points) for points, _ in meshes[:-1])])
    return np.concatenate([p for p, _ in meshes]), np.concatenate([f + s for (_, f), s in zip(meshes, starts)])


def soup(points, faces):
    return points[faces.ravel()], np.arange(faces.size).reshape(faces.shape)


def tubes(random):
    """Tubes of different numbers of segments whose rims share points but not edges.

    Rims of 2 k and 3 k segments, or of 3 k and 4 k, cross: both are chords of one circle, and between two common points no
    vertex of one is a vertex of the other, so that their vertices alternate. Such tubes intersect where the rims do."""
    common, (first, second) = int(random.integers(3, 7)), random.choice([1, 2, 3, 4], 2, replace=False)
    m, n = common * int(first), common * int(second)
    place = Place(random)
    length = 0.7 + 2 * random.random()
    pieces = [place(tube(m, 0, length)), place(tube(n, length, 2 * length))]

    def right(look):
        shared = common * np.gcd(first, second)
        return look.loops == sorted([m, n]) and look.euler == 0 and look.flat == 0 and look.consistent and look.vertices == 2 * (m + n) - shared
    return Case(lambda: filters.join(*pieces), right, given=tuple(pieces))


def strips(random):
    """Strips of a plane whose common side has more vertices in one than in the other."""
    fine, coarse = int(random.integers(2, 12)), int(random.integers(1, 6))
    place = Place(random)
    a = sheet(np.linspace(0, 1, fine + 1), [0, 0.2 + random.random()])
    b = sheet(np.linspace(0, 1, coarse + 1), [-0.2 - random.random(), 0])
    pieces = [place(a), place(b)]
    whole = area_of(a) + area_of(b)

    def right(look):
        return len(look.loops) == 1 and look.euler == 1 and look.flat == 0 and look.consistent and close(look.area / place.size**2, whole)
    return Case(lambda: filters.join(*pieces), right)


def sheets(random):
    """Tiles of a terrain whose common side is finer in one than in the other, so that slits lie between them."""
    coarse, times = int(random.integers(2, 6)), int(random.integers(2, 5))
    place, waves = Place(random), 1 + 2 * random.random(2)

    def height(x, y):
        return 0.05 * np.sin(waves[0] * 3 * x) * np.cos(waves[1] * 3 * y)
    ys = np.linspace(0, 1, coarse + 1)
    fine = sheet(np.linspace(-1, 0, times * coarse + 1), np.linspace(0, 1, times * coarse + 1), height)
    pieces = [place(fine), place(sheet(np.linspace(0, 1, coarse + 1), ys, height))]
    outline = 3 * times * coarse + 3 * coarse

    def right(look):
        return look.loops == [outline] and look.euler == 1 and look.flat == 0 and look.consistent
    return Case(lambda: filters.join(*pieces), right)


def tiles(random):
    """Four tiles of a terrain with a gap of one cell between them."""
    m, n = (int(k) for k in random.integers(4, 12, 2))
    place, waves = Place(random), 1 + random.random(2)

    def height(x, y):
        return 0.3 * np.sin(waves[0] * x * 0.3) * np.cos(waves[1] * y * 0.3)
    pieces = [place(sheet(np.arange(m) + x, np.arange(n) + y, height)) for x in (0, m) for y in (0, n)]
    outline = 2 * (2 * m - 1) + 2 * (2 * n - 1)

    def right(look):
        return look.loops == [outline] and look.euler == 1 and look.flat == 0 and look.consistent
    return Case(lambda: filters.join(*pieces, holes="fill"), right)


def wide_tolerance(random):
    """A seam whose gap is wider than its edges, sewn with a tolerance wider than both."""
    edges, gap = int(random.integers(20, 80)), 1.2 + random.random()
    place = Place(random)
    xs = np.arange(edges + 1.0)
    pieces = [place(sheet(xs, [0.0, 2])), place(sheet(xs, [-2.0 - gap, -gap]))]
    outline = 2 * (edges + 2)

    def right(look):
        return look.flat == 0 and look.consistent and look.euler == 1 and len(look.loops) == 1 and look.loops[0] in (outline, outline + 2)
    return Case(lambda: filters.join(*pieces, tolerance=place.size * (gap + 0.3 * random.random())), right)


def near_borders(random):
    """Borders a little beyond the tolerance: the report has the tolerance that sews them."""
    place, (points, faces) = Place(random), ball(random)
    upper = points[faces].mean(axis=1)[:, 2] > 0
    edge = np.linalg.norm(points[faces[0, 0]] - points[faces[0, 1]])
    above, below = soup_free(points, faces[upper]), soup_free(points, faces[~upper])
    moved = below[0] + [0, 0, -edge * 10 ** random.uniform(-4, -1.5)]
    whole = place(united(above, (moved, below[1])))

    def run():
        made, text = filters.sew(whole)
        hint = text.values["near_tolerance"]
        return filters.sew(whole, tolerance=hint) if hint else (made, text)
    return Case(run, lambda look: look.closed and look.euler == 2 and look.flat == 0)


def soup_free(points, faces):
    """The faces with only the points they use."""
    used, named = np.unique(faces, return_inverse=True)
    return points[used], named.reshape(faces.shape)


def debris(random):
    """A solid with a hole, and loose faces beside it: the hole is filled, and the loose faces stay."""
    points, faces = ball(random)
    start = faces[random.integers(len(faces)), 0]
    kept = faces[~(faces == start).any(axis=1)]
    place, loose = Place(random), int(random.integers(1, 4))
    scraps = []
    for _ in range(loose):
        corner = points[random.integers(len(points))] * (1.3 + random.random())
        # One face, or two that share an edge.
        count = int(random.integers(1, 3))
        scraps.append((corner + 0.1 * random.standard_normal((2 + count, 3)), np.array([[0, 1, 2], [2, 1, 3]])[:count]))
    whole = place(united((points, kept), *scraps))
    rims = sorted(len(p) for p, _ in scraps)
    return Case(lambda: filters.fill(whole), lambda look: look.loops == rims and look.flat == 0 and look.bodies == 1 + loose, given=(whole,))


def unsewn(random):
    """A solid whose faces are not connected: filling sews it first."""
    place, mesh = Place(random), solid(random)
    volume, given = solid_volume(*mesh), place(soup(*mesh))
    return Case(lambda: filters.fill(given), lambda look: look.closed and look.flat == 0 and close(look.volume / place.size**3, volume))


def cracked(random):
    """A solid that was cut into two parts whose rims coincide, one with a vertex more on an edge."""
    place, (points, faces) = Place(random), solid(random)
    volume = solid_volume(points, faces)
    chosen = points[faces].mean(axis=1) @ random.standard_normal(3)
    first = chosen > np.median(chosen)
    a, b = soup_free(points, faces[first]), soup_free(points, faces[~first])
    rim = boundary_edges(a[1])
    if len(rim):
        u, v = rim[random.integers(len(rim))]
        row = next(k for k, f in enumerate(a[1]) if u in f and v in f)
        w = next(c for c in a[1][row] if c not in (u, v))
        middle = len(a[0])
        a = (np.vstack([a[0], (a[0][u] + a[0][v]) / 2]), np.vstack([np.delete(a[1], row, 0), [[u, middle, w], [middle, v, w]]]))
    given = place(united(a, b))
    return Case(lambda: filters.fill(given), lambda look: look.closed and look.flat == 0 and close(look.volume / place.size**3, volume, 1e-5))


def boundary_edges(faces):
    """The directed edges without a partner."""
    edges = {(int(a), int(b)) for f in faces for a, b in zip(f, np.roll(f, -1))}
    return [(a, b) for a, b in sorted(edges) if (b, a) not in edges]


def hollow(random):
    """Shells within shells, each turned at random: cavities stay cavities."""
    depth, place = int(random.integers(2, 5)), Place(random)
    shells, volume, radius = [], 0.0, 1.0
    for level in range(depth):
        points, faces = ball(random, radius)
        volume += (-1) ** level * solid_volume(points, faces)
        shells.append((points, faces[:, ::-1] if random.random() < 0.5 else faces))
        radius *= 0.4 + 0.3 * random.random()
    given = place(united(*shells))
    run = (lambda: filters.join(given), lambda: filters.orient(given, outward="outwards"), lambda: filters.fill(given, outward=True))
    return Case(run[random.integers(3)], lambda look: look.closed and close(look.volume / place.size**3, volume))


def repeated_faces(random):
    """A solid with faces twice, turned over or without area."""
    place, (points, faces) = Place(random), solid(random)
    volume, extra = solid_volume(points, faces), faces[random.choice(len(faces), min(3, len(faces)), replace=False)]
    kind = random.integers(3)
    if kind == 2:
        # A triangle without area between two faces, its tip on their common edge.
        a, b = (int(c) for c in faces[0][:2])
        middle = len(points)
        points = np.vstack([points, points[a] + 0.5 * (points[b] - points[a])])
        whole = (points, np.vstack([[[a, middle, faces[0][2]], [middle, b, faces[0][2]], [a, b, middle]], faces[1:]]))
    else:
        whole = (points, np.vstack([faces, extra[:, ::-1] if kind else extra]))
    given = place(whole)
    return Case(lambda: filters.repair(given), lambda look: look.closed and look.flat == 0 and close(look.volume / place.size**3, volume, 1e-5))


def split_ridge(random):
    """A house of separate walls whose ridge is split in one roof face only."""
    w, d, h, r = 1 + 4 * random.random(4)
    place, t = Place(random), 0.2 + 0.6 * random.random()
    p = np.array([[0, 0, 0], [w, 0, 0], [w, d, 0], [0, d, 0], [0, 0, h], [w, 0, h], [w, d, h], [0, d, h], [w / 2, 0, h + r], [w / 2, d, h + r],
                  [w / 2, t * d, h + r]])
    faces = [[3, 2, 1, 0], [0, 1, 5, 8, 4], [2, 3, 7, 9, 6], [1, 2, 6, 5], [3, 0, 4, 7], [5, 6, 9, 10, 8], [7, 4, 8, 9]]
    named = [c for f in faces for c in f]
    starts = np.cumsum([0, *map(len, faces)]).astype(np.uint32)
    given = gm.Mesh.from_polygons(place.points(p)[named], starts, np.arange(len(named), dtype=np.uint32))
    volume = w * d * (h + r / 2)
    return Case(lambda: filters.join(given), lambda look: look.closed and close(look.volume / place.size**3, volume))


def far_origin(random):
    """Stitching, filling, joining and repair far from the origin, in single precision: the same faces, and points moved by the origin.

    The numbers hold both places exactly."""
    n, job = int(random.integers(2, 6)), ("stitch", "fill", "join", "repair")[random.integers(4)]
    origin = np.round(random.uniform(-1, 1, 3) * 2.0 ** random.integers(8, 15))
    points, faces = tube(4 * n, 0, n)
    points = np.round(points * 64) / 64
    upper = points + [0, 0, n + (job in ("stitch", "join")) * random.integers(1, n)]

    def at(origin):
        pieces = [((p + origin).astype(np.float32), faces) for p in (points, upper)]
        if job == "stitch":
            return filters.stitch(*pieces)
        if job == "join":
            return filters.join(*pieces, holes="fill")
        whole = united(*pieces)
        return filters.fill(whole) if job == "fill" else filters.repair(whole)

    def run():
        (near, _), (far, text) = at(np.zeros(3)), at(origin)
        same = np.array_equal(far.points.astype(float) - origin, near.points) and np.array_equal(far.corners, near.corners)
        return same and far.points.dtype == np.float32, text
    return Case(run, lambda same: same, raw=True)


def poles(random):
    """A sphere as a grid of latitude and longitude, each node of its own."""
    m, n, place = int(random.integers(3, 24)), int(random.integers(4, 48)), Place(random)
    start = random.random()
    lat, lon = np.linspace(-np.pi / 2, np.pi / 2, m + 1), 2 * np.pi * (start + np.arange(n + 1) / n)
    la, lo = np.meshgrid(lat, lon, indexing="ij")
    points = np.stack([np.cos(la) * np.cos(lo), np.cos(la) * np.sin(lo), np.sin(la)], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(m), np.arange(n), indexing="ij")
    a = (i * (n + 1) + j).ravel()
    given = place((points, np.stack([a, a + 1, a + n + 2, a + n + 1], axis=1)))
    vertices = (m - 1) * n + 2
    return Case(lambda: filters.weld(given, vertices="all_vertices", collapse="collapse", unused="remove"),
                lambda look: look.vertices == vertices and look.closed and look.euler == 2)


MESHES = (tubes, strips, sheets, tiles, wide_tolerance, near_borders, debris, unsewn, cracked, hollow, repeated_faces, split_ridge, far_origin, poles)
