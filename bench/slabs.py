"""Slabs cut out of closed meshes: two pieces, the loops that belong together, and the surface that was there.

The meshes are CGAL's collection (Debian's libcgal-demo), the bunny, and two that are made here. A slab has a random direction
and place; it is 1, 2, 4 or 8 % of the mesh's size wide and cut exactly or along the mesh's own edges. A slab counts if it leaves
one to three bands, each with one simple loop on either side, so that the pairs of loops are known.
"""

import tarfile
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

import meshes
from meshes import Mesh

COLLECTIONS = [Path(f"/usr/share/doc/{package}/data.tar.gz") for package in ("libcgal-demo", "libcgal-dev")]
FROM_CGAL = "elephant", "camel", "armadillo", "cow", "bull", "homer"
WIDTHS = 1, 2, 4, 8  # per cent of the size
SEEDS = 3
TRIALS = 40


@dataclass(frozen=True)
class Slab:
    name: str
    pieces: tuple  # two meshes
    pairs: tuple  # of loops of the first piece and of the second, each as an array of the piece's vertices
    truth: Mesh


def read_off(file):
    words = b" ".join(line.split(b"#")[0] for line in file).split()
    vertex_count, face_count = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * vertex_count], dtype=np.float64).reshape(-1, 3)
    faces = np.array(words[4 + 3 * vertex_count:][:4 * face_count], dtype=np.int64).reshape(-1, 4)
    return Mesh(points, np.ascontiguousarray(faces[:, 1:].astype(np.uint32)))


def bumpy():
    """A ball with bumps and dents: a smooth surface in even triangles."""
    points = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=np.float64)
    faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
    mesh = Mesh(points, np.array(faces, dtype=np.uint32))
    for _ in range(5):
        mesh = meshes.subdivided(mesh)
        mesh = Mesh(mesh.points / np.linalg.norm(mesh.points, axis=1)[:, None], mesh.faces)
    x, y, z = mesh.points.T
    radius = 1 + 0.15 * np.sin(5 * x + 1) * np.cos(4 * y) + 0.1 * np.sin(7 * z) * y
    return Mesh(mesh.points * radius[:, None], mesh.faces)


def knot():
    """A tube along a trefoil, in long triangles."""
    rows, columns = 240, 40
    t = np.linspace(0, 2 * np.pi, rows, endpoint=False)
    line = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], axis=1)
    along = np.stack([np.cos(t) + 4 * np.cos(2 * t), -np.sin(t) + 4 * np.sin(2 * t), -3 * np.cos(3 * t)], axis=1)
    side = np.cross(along, [0, 0, 1])
    side /= np.linalg.norm(side, axis=1)[:, None]
    up = np.cross(side, along)
    up /= np.linalg.norm(up, axis=1)[:, None]
    s = np.linspace(0, 2 * np.pi, columns, endpoint=False)[None, :, None]
    points = line[:, None] + 0.35 * (np.cos(s) * side[:, None] + np.sin(s) * up[:, None])
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    at = lambda i, j: (i % rows) * columns + j % columns
    quads = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
    a, b, c, d = (corner.ravel() for corner in quads)
    return Mesh(points.reshape(-1, 3), np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]).astype(np.uint32))


@cache
def closed():
    """Name and mesh."""
    found = {}
    for path in COLLECTIONS:
        if path.exists() and not found:
            with tarfile.open(path) as archive:
                members = {Path(member.name).name: member for member in archive.getmembers()}
                found = {name: read_off(archive.extractfile(members[f"{name}.off"])) for name in FROM_CGAL}
    return found | {"bunny": meshes.bunny(), "bumpy": bumpy(), "knot": knot()}


def components(mesh):
    """For each vertex, the least vertex of its component."""
    label = np.arange(len(mesh.points))
    while True:
        least = label[mesh.faces].min(axis=1)
        new = label.copy()
        np.minimum.at(new, mesh.faces.ravel(), np.repeat(least, 3))
        new = new[new]
        if (new == label).all():
            return label
        label = new


def simple_loops(mesh):
    """The boundary loops, or None where a vertex is passed twice."""
    ends = np.concatenate([mesh.faces[:, [0, 1]], mesh.faces[:, [1, 2]], mesh.faces[:, [2, 0]]]).astype(np.int64)
    free = ends[~np.isin(ends[:, 0] << 32 | ends[:, 1], ends[:, 1] << 32 | ends[:, 0])]
    if len(np.unique(free[:, 0])) < len(free) or len(np.unique(free[:, 1])) < len(free):
        return None
    return meshes.loops(mesh.faces)


def nearest(points, wanted):
    return int(np.argmin(((points - wanted) ** 2).sum(axis=1)))


def paired(pieces, truth):
    """The pairs of loops, or None."""
    loops = [simple_loops(piece) for piece in pieces]
    if None in loops or simple_loops(truth) is None:
        return None
    label = components(truth)
    bands = {}
    for side, (piece, found) in enumerate(zip(pieces, loops)):
        for loop in found:
            band = label[nearest(truth.points, piece.points[loop[0]])]
            bands.setdefault(band, ([], []))[side].append(loop)
    for band, (first, second) in bands.items():
        faces = truth.faces[label[truth.faces[:, 0]] == band]
        edges = np.unique(np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1), axis=0)
        if len(first) != 1 or len(second) != 1 or (label == band).sum() - len(edges) + len(faces) != 0:
            return None
    if not 1 <= len(bands) <= 3 or len(bands) != len(np.unique(label)):
        return None
    return tuple((first[0], second[0]) for first, second in bands.values())


def slab(name, mesh, width, jagged, random):
    """One that counts, or None where no trial gives one."""
    size = np.ptp(mesh.points, axis=0).max() * width / 100
    for _ in range(TRIALS):
        direction = random.normal(size=3)
        direction /= np.linalg.norm(direction)
        heights = mesh.points @ direction
        low = random.uniform(heights.min(), heights.max() - size)
        if jagged:
            middle = heights[mesh.faces].mean(axis=1)
            parts = middle < low, middle > low + size, (middle >= low) & (middle <= low + size)
            if not all(part.any() for part in parts):
                continue
            below, above, truth = (mesh.part(part) for part in parts)
            if np.isin(mesh.faces[parts[0]], mesh.faces[parts[1]]).any():
                continue
        else:
            below = meshes.cut(mesh, low, False, direction)
            above = meshes.cut(mesh, low + size, True, direction)
            truth = meshes.cut(meshes.cut(mesh, low, True, direction), low + size, False, direction)
        pairs = paired((below, above), truth)
        if pairs:
            kind = "jagged" if jagged else "cut"
            return Slab(f"{name}-{width}-{kind}", (below, above), pairs, truth)
    return None


def slabs(seeds=SEEDS):
    for number, (name, mesh) in enumerate(closed().items()):
        for width in WIDTHS:
            for jagged in False, True:
                for seed in range(seeds):
                    made = slab(name, mesh, width, jagged, np.random.default_rng([number, width, jagged, seed]))
                    if made:
                        yield Slab(f"{made.name}-{seed}", made.pieces, made.pairs, made.truth)
