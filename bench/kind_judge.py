"""Shared by the random cases of kinds.py: random places, and measures by trimesh, which knows nothing of the library."""

from collections import Counter
from dataclasses import dataclass
from typing import Callable

import numpy as np
import trimesh


@dataclass
class Case:
    """Run gives the result and the report; right judges what trimesh sees in the result, or if raw the result itself.

    Given are the meshes it is made of, if these may intersect each other."""

    run: Callable
    right: Callable
    raw: bool = False
    given: tuple = ()


class Place:
    """A random size in units from a micrometre to a kilometre, a rotation, and an origin within three sizes."""

    def __init__(self, random):
        self.size = 10.0 ** random.uniform(-6, 3)
        self.turn = trimesh.transformations.random_rotation_matrix(random.random(3))[:3, :3]
        self.origin = self.size * random.uniform(-3, 3, 3)

    def points(self, points):
        return self.size * (np.asarray(points, dtype=float) @ self.turn.T) + self.origin

    def __call__(self, mesh):
        return self.points(mesh[0]), mesh[1].astype(np.uint32)


class Look:
    """A mesh as trimesh sees it. A face counts as flat if its height is below a millionth of its longest edge."""

    def __init__(self, mesh):
        used, triangles = np.unique(mesh.triangles(), return_inverse=True)
        points, triangles = np.asarray(mesh.points, dtype=float)[used], triangles.reshape(-1, 3)
        self.mesh = points, triangles
        seen = trimesh.Trimesh(points, triangles, process=False)
        self.area, self.consistent = float(seen.area), bool(seen.is_winding_consistent)
        self.closed = bool(seen.is_watertight and seen.is_winding_consistent)
        self.volume = float(seen.volume) if self.closed else 0.0
        self.vertices, self.bodies = len(points), int(seen.body_count)
        self.euler = int(seen.euler_number)
        longest = np.linalg.norm(points[triangles] - points[np.roll(triangles, 1, axis=1)], axis=2).max(axis=1)
        self.flat = int((2 * seen.area_faces <= 1e-6 * longest**2).sum())
        self.loops = loops(triangles)


def loops(triangles):
    """The lengths of the boundary loops; a vertex with two ways on makes them unknown."""
    counts = Counter((int(a), int(b)) for f in triangles for a, b in zip(f, np.roll(f, -1)))
    free = [(a, b) for (a, b), count in counts.items() if count == 1 and (b, a) not in counts]
    following = dict(free)
    if len(following) != len(free):
        return None
    lengths = []
    while following:
        start, at = following.popitem()
        length = 1
        while at != start and at in following:
            at, length = following.pop(at), length + 1
        lengths.append(length)
    return sorted(lengths)


def area_of(mesh):
    import gusset_mesh as gm
    return float(trimesh.Trimesh(mesh[0], gm.Mesh(*mesh).triangles(), process=False).area)


def solid_volume(points, faces):
    a, b, c = (np.asarray(points)[faces[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def close(value, expected, share=1e-6):
    return abs(value - expected) <= share * abs(expected)
