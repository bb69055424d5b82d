"""Cases of several parts: parts that touch, that intersect, that share walls, double shells with pinholes, and mixed defects."""

import numpy as np

import broken
from broken import Work, single
from meshes import Mesh

#: Trials of a random place before another base is taken.
TRIALS = 20


def concatenated(parts):
    shifts = np.cumsum([0] + [len(part.points) for part in parts[:-1]])
    return Mesh(np.concatenate([part.points for part in parts]),
                np.concatenate([part.faces.astype(np.int64) + shift for part, shift in zip(parts, shifts)]))


def turned(rng):
    """A random rotation."""
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q *= np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def placed(part, rotation, size):
    """The part about the origin, with a diagonal of `size`."""
    points = (part.points - part.points.mean(axis=0)) @ rotation.T
    return Mesh(points * size / np.linalg.norm(np.ptp(points, axis=0)), part.faces)


def diagonal(mesh):
    return np.linalg.norm(np.ptp(mesh.points, axis=0))


def touching(base, other, judge, rng):
    """A part at an extreme vertex, and tetrahedra at edges of the convex hull."""
    from scipy.spatial import ConvexHull

    direction = rng.normal(size=3)
    direction /= np.linalg.norm(direction)
    top = int((base.points @ direction).argmax())
    small = placed(other, turned(rng), diagonal(base) * rng.uniform(0.2, 0.5))
    foot = int((small.points @ direction).argmin())
    small = Mesh(single(small.points - small.points[foot] + base.points[top]), small.faces)
    small.points[foot] = base.points[top]
    parts, joints = [base, small], [[(foot, top)]]
    hull = ConvexHull(base.points)
    edges = set(map(tuple, np.sort(np.concatenate([base.faces[:, [0, 1]], base.faces[:, [1, 2]], base.faces[:, [2, 0]]]), axis=1).tolist()))
    sides = {}
    for simplex, equation in zip(hull.simplices, hull.equations):
        for a, b in ((0, 1), (1, 2), (2, 0)):
            sides.setdefault(tuple(sorted((int(simplex[a]), int(simplex[b])))), []).append(equation[:3])
    hull_edges = sorted(edge for edge in sides if edge in edges and top not in edge)
    for k in rng.permutation(len(hull_edges))[:2]:
        a, b = hull_edges[k]
        outwards = np.mean(sides[a, b], axis=0)
        along = base.points[b] - base.points[a]
        length = np.linalg.norm(along)
        outwards *= length / max(np.linalg.norm(outwards), 1e-300)
        across = np.cross(along, outwards) / length
        middle = (base.points[a] + base.points[b]) / 2
        tips = single([middle + outwards + 0.3 * across, middle + outwards - 0.3 * across])
        points = np.concatenate([base.points[[a, b]], tips])
        faces = np.array([[0, 1, 2], [1, 0, 3], [0, 2, 3], [2, 1, 3]])
        if np.linalg.det(points[1:] - points[0]) < 0:
            faces = faces[:, ::-1]
        parts.append(Mesh(points, faces))
        joints.append([(0, a), (1, b)])
    work = Work(concatenated(parts), judge, rng)
    if len(judge.pairs(work.points, work.faces)):
        return None
    shifts = np.cumsum([len(part.points) for part in parts])
    for shift, joint in zip(shifts, joints):
        for own, host in joint:
            work.touch([shift + own, host])
            work.faces[work.faces == shift + own] = host
    return work


def crossing(base, other, judge, rng, count=2):
    """Parts that intersect each other."""
    parts = [base]
    for _ in range(count - 1):
        part = placed(other, turned(rng), diagonal(base) * rng.uniform(0.4, 0.8))
        place = base.points[rng.integers(len(base.points))]
        parts.append(Mesh(single(part.points + place + 0.05 * diagonal(base) * rng.normal(size=3)), part.faces))
    work = Work(concatenated(parts), judge, rng, united=True)
    if not len(work.touch_pairs()):
        return None
    work.hidden = judge.covered(work.points, work.faces)
    return work


def walls(base, judge, rng):
    """A wall across the solid, welded to its surface."""
    import manifold3d

    for _ in range(TRIALS):
        axis = int(rng.integers(3))
        level = np.float32(np.quantile(base.points[:, axis], rng.uniform(0.2, 0.8))).astype(np.float64)
        heights = base.points[:, axis] - level
        if np.abs(heights).min() < 1e-5 * diagonal(base):
            continue
        clean, loops = cut(base, heights, axis, level)
        if loops is None or len(judge.pairs(clean.points, clean.faces)) or not judge.is_valid(clean):
            continue
        plane = [k for k in range(3) if k != axis]
        flat = [clean.points[loop][:, plane] for loop in loops]
        # The triangulation expects outlines that run counter-clockwise.
        area = sum((p[:, 0] * np.roll(p[:, 1], -1) - p[:, 1] * np.roll(p[:, 0], -1)).sum() for p in flat)
        if area < 0:
            loops, flat = [loop[::-1] for loop in loops], [p[::-1] for p in flat]
        wall = np.concatenate(loops)[np.asarray(manifold3d.triangulate(flat), dtype=np.int64)]
        work = Work(clean, judge, rng)
        work.touch(wall)
        work.add_faces(wall if rng.integers(2) else wall[:, ::-1])
        return work
    return None


def cut(base, heights, axis, level):
    """The mesh with its faces split by a plane, and the outlines of the section."""
    points, names, faces, ahead = list(base.points), {}, [], {}

    def crossed(a, b):
        key = (min(a, b), max(a, b))
        if key not in names:
            a, b = key
            share = heights[a] / (heights[a] - heights[b])
            p = single(base.points[a] + share * (base.points[b] - base.points[a]))
            p[axis] = level
            names[key] = len(points)
            points.append(p)
        return names[key]

    for a, b, c in base.faces.tolist():
        above = [heights[v] > 0 for v in (a, b, c)]
        if all(above) or not any(above):
            faces.append([a, b, c])
            continue
        while above.count(above[0]) == 2:  # The corner that is alone comes first.
            a, b, c = b, c, a
            above = above[1:] + above[:1]
        p, q = crossed(a, b), crossed(c, a)
        faces += [[a, p, q], [p, b, c], [p, c, q]]
        start, end = (p, q) if above[0] else (q, p)
        ahead[start] = end
    loops = []
    while ahead:
        start, v = ahead.popitem()
        loop = [start]
        while v != start:
            if v not in ahead:
                return None, None
            loop.append(v)
            v = ahead.pop(v)
        loops.append(np.array(loop))
    return Mesh(np.array(points), np.array(faces)), loops


def shells(base, judge, rng):
    """A thin wall: the mesh and its inward offset. Pinholes lead through both, with and without a tunnel."""
    corners = base.points[base.faces]
    normals = np.zeros_like(base.points)
    for k in range(3):
        np.add.at(normals, base.faces[:, k], np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    edge = np.median(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2))
    for share in (0.5, 0.3, 0.1, 0.05):
        inner = Mesh(single(base.points - share * edge * normals), base.faces[:, ::-1])
        work = Work(concatenated([base, inner]), judge, rng)
        if len(judge.pairs(work.points, work.faces)):
            continue
        count, shift = len(base.faces), len(base.points)
        rows = [row for row in work.some_rows(12) if row < count][:6]
        has_tunnels = bool(rng.integers(2))
        for row in rows:
            a, b, c = work.faces[row]
            work.touch([a, b, c, a + shift, b + shift, c + shift])
            if has_tunnels:
                for p, q in ((a, b), (b, c), (c, a)):
                    work.add_faces([[p, q, q + shift], [p, q + shift, p + shift]])
        work.remove(np.concatenate([rows, np.array(rows) + count]).astype(np.int64))
        return work
    return None


def mixed(base, other, judge, rng):
    """Parts that intersect, and defects of every local kind that does not move the whole mesh."""
    work = crossing(base, other, judge, rng)
    if work is None:
        return None
    for kind in ("folds", "holes", "flips", "fins", "junctions", "needles"):
        if rng.integers(4):
            broken.LOCAL[kind](work)
    if rng.integers(2):
        broken.seams(work)
    return work
