"""Shapes by formula."""

import numpy as np


def grid(rows, columns, height=lambda u, v: 0 * u, span=(1.0, 1.0)):
    """Points (rows, columns, 3) over a rectangle."""
    u, v = np.meshgrid(np.linspace(0, span[0], rows), np.linspace(0, span[1], columns), indexing="ij")
    return np.stack([u, v, height(u, v)], axis=2)


def quads(rows, columns, closed=False):
    """Faces of a grid of nodes; closed: from the last column to the first."""
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns if closed else columns - 1), indexing="ij")
    right = (j + 1) % columns
    return np.stack([i * columns + j, (i + 1) * columns + j, (i + 1) * columns + right, i * columns + right], axis=-1).reshape(-1, 4)


def tube(rows=8, columns=24, z=0.0, radius=1.0):
    """A tube along z: open at both ends."""
    angle = np.linspace(0, 2 * np.pi, columns, endpoint=False)
    points = [[radius * np.cos(a), radius * np.sin(a), z + k / (rows - 1)] for k in range(rows) for a in angle]
    return np.array(points), quads(rows, columns, closed=True)


def cap(sign=1.0, rows=6, columns=24, end=np.pi / 2 - 0.2):
    """A spherical cap about the z axis, with a pole; its rim is open, its normals outwards."""
    polar = np.linspace(0, end, rows + 1)[1:]
    angle = np.linspace(0, 2 * np.pi, columns, endpoint=False)
    points = [[0, 0, sign]] + [[np.sin(p) * np.cos(a), np.sin(p) * np.sin(a), sign * np.cos(p)] for p in polar for a in angle]
    faces = [[0, 1 + k, 1 + (k + 1) % columns] for k in range(columns)]
    for i in range(rows - 1):
        for j in range(columns):
            a, b = 1 + i * columns + j, 1 + i * columns + (j + 1) % columns
            faces += [[a, a + columns, b + columns], [a, b + columns, b]]
    faces = np.array(faces)
    return np.array(points), faces if sign > 0 else faces[:, ::-1]
