"""Random pieces of the kinds that people join: bent tubes, islands, borders that face each other in part. See kinds.py."""

import numpy as np

from gusset_mesh import filters
from kind_judge import Case, Place, area_of
from kind_meshes import sheet, tube, united


def elbows(random):
    """Two tubes of different numbers of segments whose axes meet at an angle."""
    m, n = (int(k) for k in random.integers(8, 40, 2))
    place, angle, radius = Place(random), np.radians(random.uniform(15, 90)), random.uniform(1.5, 4)
    length = 1 + 2 * random.random()
    # The axis bends around the y axis, at this distance from the origin.
    away = np.array([radius, 0, 0])
    turn = np.array([[np.cos(angle), 0, -np.sin(angle)], [0, 1, 0], [np.sin(angle), 0, np.cos(angle)]])
    first, second = tube(m, -length, 0), tube(n, 0, length)
    pieces = [place((first[0] + away, first[1])), place(((second[0] + away) @ turn.T, second[1]))]

    def right(look):
        return look.bodies == 1 and look.loops == sorted([m, n]) and look.euler == 0 and look.flat == 0 and look.consistent
    return Case(lambda: filters.stitch(*pieces), right)


def islands(random):
    """A sheet with a hole in which a patch floats: the patch is joined all around."""
    inner, ring, border = (int(random.integers(1, high)) for high in (8, 2, 5))
    side = inner + 2 * (ring + border)
    place, waves = Place(random), 1 + 2 * random.random(2)

    def height(x, y):
        return 0.05 * side * np.sin(waves[0] * x / side) * np.cos(waves[1] * y / side)
    points, faces = sheet(np.arange(side + 1), np.arange(side + 1), height)
    depth = np.abs(points[faces].mean(axis=1)[:, :2] - side / 2).max(axis=1)
    given = place((points, faces[(depth < inner / 2) | (depth > inner / 2 + ring)]))

    def right(look):
        return look.bodies == 1 and look.loops == [4 * side] and look.euler == 1 and look.flat == 0 and look.consistent
    return Case(lambda: filters.join(given), right)


def partial_rims(random):
    """Two sheets whose borders face each other along a part of the longer one, at most half an edge apart."""
    long, short = int(random.integers(8, 24)), int(random.integers(3, 7))
    place, gap, scale = Place(random), random.uniform(0.1, 0.5), random.uniform(0.6, 1.4)
    start = random.uniform(1, long - 1 - short * scale) if long - 2 > short * scale else 1.0
    a = sheet(np.arange(long + 1), [0, 1, 2])
    b = sheet(start + scale * np.arange(short + 1), [-gap - 2, -gap - 1, -gap])
    pieces, whole, between = [place(a), place(b)], area_of(a) + area_of(b), gap * short * scale

    def right(look):
        strip = look.area / place.size**2 - whole
        return look.bodies == 1 and len(look.loops or []) == 1 and look.euler == 1 and look.flat == 0 and look.consistent \
            and 0.5 * between < strip < 2 * between + gap
    return Case(lambda: filters.join(*pieces), right)


def partial_coincidence(random):
    """Tubes whose rims coincide along an arc, and are apart elsewhere."""
    segments, same = int(random.integers(12, 48)), random.uniform(0.15, 0.6)
    place, wide, length = Place(random), random.uniform(0.1, 0.5), 1.5 + random.random()
    first, second = tube(segments, -length, 0), tube(segments, 0, length)
    # The second tube's lower rim rises beyond the arc.
    along = np.arange(segments) / segments
    rise = np.where(along <= same, 0, wide * np.sin(np.pi * (along - same) / (1 - same)))
    second[0][:segments, 2] += np.maximum(rise, 0)
    pieces = [place(first), place(second)]

    def right(look):
        return look.bodies == 1 and look.loops == [segments] * 2 and look.euler == 0 and look.flat == 0 and look.consistent
    return Case(lambda: filters.join(*pieces), right)


def two_meshes_in_one(random):
    """The pieces of any of these kinds as one mesh without names: the result is the same."""
    m, n = (int(k) for k in random.integers(6, 30, 2))
    place, gap = Place(random), random.uniform(0.05, 0.5)
    given = place(united(tube(m, -2, 0), tube(n, gap, 2 + gap)))

    def right(look):
        return look.bodies == 1 and look.loops == sorted([m, n]) and look.euler == 0 and look.flat == 0 and look.consistent
    return Case(lambda: filters.join(given), right)


def smooth_finish(random):
    """A sphere that lacks a band or a cap: one word gives a smooth surface, from stitching, joining and filling alike.

    The new surface is at most half as far from the sphere as a plain one, whose distance is the height of the arc over the gap."""
    job, place = ("stitch", "join", "fill", "join_fill")[random.integers(4)], Place(random)
    segments, half = int(random.integers(24, 60)), random.uniform(0.12, 0.45)
    capped = job in ("fill", "join_fill")

    def cap(end, sign):
        rings = max(3, int(end * segments / (2 * np.pi)))
        polar, around = np.meshgrid(np.linspace(end, 0, rings + 1)[:-1], 2 * np.pi * (random.random() + np.arange(segments) / segments), indexing="ij")
        points = np.stack([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), sign * np.cos(polar)], axis=-1).reshape(-1, 3)
        quads = np.array([[r * segments + k, r * segments + (k + 1) % segments, (r + 1) * segments + (k + 1) % segments, (r + 1) * segments + k]
                          for r in range(rings - 1) for k in range(segments)])
        last = (rings - 1) * segments
        tip = np.array([[last + k, last + (k + 1) % segments, rings * segments] for k in range(segments)])
        faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]], tip])
        return np.vstack([points, [0, 0, sign]]), faces if sign > 0 else faces[:, ::-1]
    if capped:
        given = [place(cap(np.pi - half, 1.0))]
        run = {"fill": filters.fill, "join_fill": lambda mesh, finish: filters.join(mesh, finish=finish, holes="fill")}[job]
    else:
        given = [place(cap(np.pi / 2 - half, sign)) for sign in (1.0, -1.0)]
        run = filters.stitch if job == "stitch" else filters.join
    rise = 1 - np.cos(half)

    def right(look):
        points = (look.mesh[0] - place.origin) @ place.turn / place.size
        off = np.abs(np.linalg.norm(points, axis=1) - 1)
        return look.closed and look.euler == 2 and look.flat == 0 and off.max() < 0.5 * rise
    return Case(lambda: run(*given, finish="blend"), right)


JOINTS = smooth_finish, elbows, islands, partial_rims, partial_coincidence, two_meshes_in_one
