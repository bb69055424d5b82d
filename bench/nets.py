"""The nets of the benchmarks: arrays H x W x 3.

torus, sphere     by formula, closed: their last rows and columns are the first ones again
rough             a torus with a rough surface, as scans have
real              grids of scanners, from the folder of data; missing nodes are NaN
"""

import os
from functools import cache
from pathlib import Path

import numpy as np

DATA = Path(os.environ.get("GUSSET_DATA", "../shared/data"))


def angles(count):
    """Once round; the last is the first."""
    return 2 * np.pi * (np.arange(count) % (count - 1)) / (count - 1)


def torus(side, roughness=0.0):
    u, v = angles(side)[:, None], angles(side)[None, :]
    radius = 1 + 0.05 * np.sin(7 * u) * np.cos(5 * v)
    if roughness:
        noise = np.random.default_rng(1).standard_normal((side - 1, side - 1)) * roughness
        radius = radius + np.pad(noise, ((0, 1), (0, 1)), mode="wrap")
    ring = 3 + radius * np.cos(u)
    return np.stack([ring * np.cos(v), ring * np.sin(v), radius * np.sin(u)], axis=-1).astype(np.float32)


def sphere(rows, columns):
    """From the south pole to the north pole; columns counter-clockwise seen from above."""
    latitude = np.pi * (np.arange(rows) / (rows - 1) - 0.5)
    across = np.cos(latitude)
    across[[0, -1]] = 0
    longitude = angles(columns)
    points = np.stack([across[:, None] * np.cos(longitude), across[:, None] * np.sin(longitude),
                       np.repeat(np.sin(latitude)[:, None], columns, axis=1)], axis=-1)
    return points.astype(np.float32)


@cache
def real():
    """The grids with three coordinates, in single precision, by the first word of their names; empty without data."""
    paths = sorted((DATA / "grids").glob("*.npz"))
    loaded = {path.stem: np.load(path) for path in paths}
    return {name.split("_range")[0].split("_table")[0]: arrays["xyz"].astype(np.float32)
            for name, arrays in loaded.items() if "xyz" in arrays}


def triangles(points):
    """The points that are there and have a cell, and the triangles of the cells: what a codec of meshes takes."""
    height, width = points.shape[:2]
    there = np.isfinite(points).all(axis=-1)
    cell = there[:-1, :-1] & there[:-1, 1:] & there[1:, :-1] & there[1:, 1:]
    index = np.arange(height * width).reshape(height, width)
    a, b, c, d = (index[rows, columns][cell] for rows, columns in [
        (slice(None, -1), slice(None, -1)), (slice(None, -1), slice(1, None)), (slice(1, None), slice(1, None)),
        (slice(1, None), slice(None, -1))])
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    used, faces = np.unique(faces, return_inverse=True)
    return np.ascontiguousarray(points.reshape(-1, 3)[used]), faces.reshape(-1, 3).astype(np.uint32)


def off_by(normals, points):
    """The largest angle between normals and the true ones of a sphere about the origin, in degrees."""
    true = points.reshape(-1, 3).astype(np.float64)
    found = normals.reshape(-1, 3).astype(np.float64)
    sine = np.linalg.norm(np.cross(found, true), axis=1)
    return float(np.degrees(np.arctan2(sine, (found * true).sum(axis=1))).max())
