"""Closed meshes without defects, from libcgal-demo and generated."""

import tarfile
from pathlib import Path

import numpy as np

from meshes import Mesh

ARCHIVE = Path("/usr/share/doc/libcgal-dev/data.tar.gz")
NAMES = ("anchor", "anchor_dense", "bear_bis", "blobby", "bones", "bull", "cactus", "camel", "couplingdown", "cow", "cube-meshed", "dino",
         "elephant", "elk", "fandisk", "femur", "hand", "handle", "helmet", "homer", "knot1", "knot2", "pinion", "retinal", "rotor",
         "sphere966", "spool", "triceratops", "turbine")


def read_off(lines):
    """Triangles, with or without normals or colours of vertices."""
    rows = [row.split() for row in (line.split(b"#")[0] for line in lines) if row.strip()]
    head = rows.pop(0)
    counts = head[1:] or rows.pop(0)
    count, faces = int(counts[0]), int(counts[1])
    points = np.array([row[:3] for row in rows[:count]], dtype=np.float64)
    return Mesh(points, np.array([row[1:4] for row in rows[count:count + faces] if row[0] == b"3"], dtype=np.int64))


def demo_meshes():
    with tarfile.open(ARCHIVE) as archive:
        for name in NAMES:
            yield name, read_off(archive.extractfile(f"data/meshes/{name}.off").read().splitlines())


def grid_faces(rows, columns):
    """The triangles of a grid that closes in both directions."""
    i, j = (index.ravel() for index in np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij"))
    a, b = i * columns + j, i * columns + (j + 1) % columns
    d, c = (i + 1) % rows * columns + j, (i + 1) % rows * columns + (j + 1) % columns
    return np.concatenate([np.stack([a, d, c], 1), np.stack([a, c, b], 1)])


def torus(rows, columns, radius, tube, wave=0.0):
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, rows, endpoint=False), np.linspace(0, 2 * np.pi, columns, endpoint=False), indexing="ij")
    thick = tube * (1 + wave * np.sin(5 * u) * np.cos(3 * v))
    ring = radius + thick * np.cos(v)
    return Mesh(np.stack([ring * np.cos(u), ring * np.sin(u), thick * np.sin(v)], -1).reshape(-1, 3), grid_faces(rows, columns))


def sphere(rows, columns, wave=0.0, power=1.0):
    """A sphere of rings with two poles; with `power` below 1 nearly a box."""
    theta = np.linspace(0, np.pi, rows + 2)[1:-1]
    u, v = np.meshgrid(theta, np.linspace(0, 2 * np.pi, columns, endpoint=False), indexing="ij")
    radius = 1 + wave * np.sin(4 * u) * np.cos(5 * v)
    bent = lambda x: np.sign(x) * np.abs(x) ** power
    points = np.stack([bent(np.sin(u)) * bent(np.cos(v)), bent(np.sin(u)) * bent(np.sin(v)), bent(np.cos(u))], -1) * radius[..., None]
    points = np.concatenate([points.reshape(-1, 3), [[0, 0, 1], [0, 0, -1]]])
    grid = grid_faces(rows, columns)
    inner = grid[:2 * rows * columns][np.ptp(grid // columns, axis=1) <= 1]
    j = np.arange(columns)
    after, last, north, south = (j + 1) % columns, (rows - 1) * columns, rows * columns, rows * columns + 1
    caps = [np.stack([np.full(columns, north), j, after], 1), np.stack([np.full(columns, south), last + after, last + j], 1)]
    return Mesh(points, np.concatenate([inner, *caps]))


def generated():
    yield "torus", torus(80, 30, 2.0, 0.7)
    yield "wavy-torus", torus(150, 50, 2.0, 0.6, 0.3)
    yield "sphere", sphere(40, 60)
    yield "wavy-sphere", sphere(60, 90, 0.2)
    yield "rounded-box", sphere(30, 48, 0.0, 0.6)
