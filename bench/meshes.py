"""The meshes of the benchmarks, made at run time from the bunny of the Debian package glmark2-data.

jagged        the bunny without the faces whose middle lies in a slab: 65,644 faces, ragged rims of 486 and 426 vertices
jagged-s2/s3  the same, every triangle cut into four two and three times: 1,050,304 and 4,201,216 faces
planar        the bunny without the slab itself, cut exactly: rims of 713 and 707 vertices
collar-K      the two planar rims resampled to K and 0.8 K vertices, each with one ring of faces
"""

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

BUNNY = Path("/usr/share/glmark2/models/bunny.obj")
LOW, HIGH = -0.30, -0.20


@dataclass(frozen=True)
class Mesh:
    """Packed triangles: what every library in the comparison starts from."""

    points: np.ndarray  # n x 3 float64
    faces: np.ndarray  # m x 3 uint32

    def part(self, kept):
        """The faces that `kept` marks, and the vertices that they use in their old order."""
        used, faces = np.unique(self.faces[kept], return_inverse=True)
        return Mesh(np.ascontiguousarray(self.points[used]), faces.reshape(-1, 3).astype(np.uint32))


@dataclass(frozen=True)
class Gap:
    """Two pieces and the rims that are to be joined, as vertices of the whole, each side by side with its faces."""

    whole: Mesh
    pieces: tuple  # two meshes: the whole's vertices and faces in order
    rims: tuple


def read_obj(path):
    points, faces = [], []
    with open(path) as lines:
        for line in lines:
            kind, *words = line.split() or [""]
            if kind == "v":
                points.append([float(word) for word in words[:3]])
            elif kind == "f":
                faces.append([int(word.split("/")[0]) - 1 for word in words])
    return Mesh(np.array(points), np.array(faces, dtype=np.uint32))


def loops(faces):
    """The boundary loops, the longest first. The code is plain and slow, because it checks the inputs of the contenders."""
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).astype(np.int64)
    ahead, back = ends[:, 0] << 32 | ends[:, 1], ends[:, 1] << 32 | ends[:, 0]
    free = ends[~np.isin(ahead, back)]
    after = dict(zip(free[:, 0].tolist(), free[:, 1].tolist()))
    found = []
    while after:
        start, vertex = after.popitem()
        loop = [start]
        while vertex != start:
            loop.append(vertex)
            vertex = after.pop(vertex)
        found.append(np.array(loop))
    return sorted(found, key=len, reverse=True)


def subdivided(mesh):
    """Every triangle cut into four. Edges are numbered as they come first, which keeps neighbours together in memory."""
    corners = mesh.faces.astype(np.int64)
    ends = np.stack([corners[:, [1, 2]], corners[:, [2, 0]], corners[:, [0, 1]]], axis=1).reshape(-1, 2)
    keys = ends.min(axis=1) << 32 | ends.max(axis=1)
    _, first, edge = np.unique(keys, return_index=True, return_inverse=True)
    place = np.empty(len(first), dtype=np.int64)
    place[np.argsort(first)] = np.arange(len(first))
    middle = (place[edge.ravel()] + len(mesh.points)).reshape(-1, 3)
    on_edges = np.sort(first)
    points = np.concatenate([mesh.points, (mesh.points[ends[on_edges, 0]] + mesh.points[ends[on_edges, 1]]) / 2])
    (a, b, c), (x, y, z) = corners.T, middle.T
    faces = np.stack([a, z, y, z, b, x, y, x, c, x, y, z], axis=1)
    return Mesh(points, faces.reshape(-1, 3).astype(np.uint32))


def shuffled(mesh):
    """Vertices and faces in random order."""
    random = np.random.default_rng(12345)
    vertex, face = random.permutation(len(mesh.points)), random.permutation(len(mesh.faces))
    points = np.empty_like(mesh.points)
    points[vertex] = mesh.points
    return Mesh(points, np.ascontiguousarray(vertex[mesh.faces[face]].astype(np.uint32)))


def cut(mesh, height, above, direction=(0.0, 1.0, 0.0)):
    """The part of a mesh on one side of the plane at `height` in a direction of length 1. No vertex may lie on the plane."""
    heights = mesh.points @ np.asarray(direction)
    side = (heights > height) == above
    count = side[mesh.faces].sum(axis=1)
    points, faces, new = list(mesh.points), [mesh.faces[count == 3].astype(np.int64)], {}

    def crossing(inner, outer):
        if (inner, outer) not in new:
            p, q = mesh.points[inner], mesh.points[outer]
            point = p + (q - p) * ((height - heights[inner]) / (heights[outer] - heights[inner]))
            point += (height - point @ direction) * np.asarray(direction)
            new[inner, outer] = len(points)
            points.append(point)
        return new[inner, outer]

    for kept in (1, 2):
        for face in mesh.faces[count == kept].tolist():
            # Turned so that the corner on a side of its own comes first.
            a, b, c = next(face[k:] + face[:k] for k in range(3) if bool(side[face[k]]) == (kept == 1))
            if kept == 1:
                faces.append(np.array([[a, crossing(a, b), crossing(a, c)]]))
            else:
                x, y = crossing(b, a), crossing(c, a)
                faces.append(np.array([[x, b, c], [x, c, y]]))
    return Mesh(np.array(points), np.concatenate(faces).astype(np.uint32)).part(slice(None))


def gap(first, second, rims=None):
    """The gap between two pieces; the rims are their longest loops unless given."""
    shift = len(first.points)
    rims = rims or (loops(first.faces)[0], loops(second.faces)[0])
    whole = Mesh(np.concatenate([first.points, second.points]), np.concatenate([first.faces, second.faces + np.uint32(shift)]))
    return Gap(whole, (first, second), (rims[0], rims[1] + shift))


@cache
def bunny():
    return read_obj(BUNNY)


@cache
def jagged(times=0):
    """Upper and lower part, with ragged rims, subdivided."""
    if times:
        first, second = (subdivided(piece) for piece in jagged(times - 1).pieces)
        return gap(first, second)
    middle = bunny().points[bunny().faces].mean(axis=1)[:, 1]
    return gap(bunny().part(middle < LOW), bunny().part(middle > HIGH))


@cache
def planar():
    return gap(cut(bunny(), LOW, above=False), cut(bunny(), HIGH, above=True))


def resampled(line, count):
    """A closed polyline with `count` vertices, evenly spaced along it."""
    closed = np.concatenate([line, line[:1]])
    along = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    at = np.arange(count) * (along[-1] / count)
    return np.stack([np.interp(at, along, closed[:, axis]) for axis in range(3)], axis=1), along[-1] / count


def collar(line, count, direction):
    """One ring of about square faces on a rim; the rim has the vertices 0 to count - 1."""
    rim, spacing = resampled(line, count)
    points = np.concatenate([rim, rim + np.array([0, direction * spacing, 0])])
    i = np.arange(count)
    j = (i + 1) % count
    faces = np.concatenate([np.stack([i, j, j + count], axis=1), np.stack([i, j + count, i + count], axis=1)])
    return Mesh(points, faces.astype(np.uint32)), i


@cache
def collars(count):
    """Two collars between the planar rims, of count and 0.8 count vertices."""
    whole, rims = planar().whole, planar().rims
    (low, low_rim), (high, high_rim) = (
        collar(whole.points[rims[0]], count, -1),
        collar(whole.points[rims[1]], count * 4 // 5, 1),
    )
    return gap(low, high, (low_rim, high_rim))


def write(mesh, path):
    """For the programs in C++: two counts, the points, the faces."""
    with open(path, "wb") as out:
        np.array([len(mesh.points), len(mesh.faces)], dtype=np.uint64).tofile(out)
        mesh.points.astype(np.float64).tofile(out)
        mesh.faces.astype(np.uint32).tofile(out)


def read(path):
    """Reads the format of `write`, as the C++ programs write it."""
    with open(path, "rb") as file:
        counts = np.fromfile(file, dtype=np.uint64, count=2).astype(int)
        points = np.fromfile(file, dtype=np.float64, count=3 * counts[0]).reshape(-1, 3)
        return Mesh(points, np.fromfile(file, dtype=np.uint32, count=3 * counts[1]).reshape(-1, 3))
