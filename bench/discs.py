"""Discs cut out of closed meshes: the mesh that is left, its one loop, and the surface that was there.

The meshes come from slabs.py. A disc consists of the faces within a ball around a vertex; the ball's diameter is 1, 2, 5, 10 or 20
% of the mesh's size. Discs count that are discs: one component, one simple loop.
"""

from dataclasses import dataclass

import numpy as np

import slabs
from meshes import Mesh

WIDTHS = 1, 2, 5, 10, 20  # per cent of the size
SEEDS = 2
TRIALS = 40
FEWEST_EDGES = 8


@dataclass(frozen=True)
class Disc:
    name: str
    rest: Mesh
    loop: np.ndarray  # vertices of the rest, with the surface on the left
    truth: Mesh


def is_disc(part):
    edges = np.concatenate([part.faces[:, [0, 1]], part.faces[:, [1, 2]], part.faces[:, [2, 0]]])
    edges = np.unique(np.sort(edges, axis=1), axis=0)
    return len(part.points) - len(edges) + len(part.faces) == 1


def disc(name, mesh, width, random):
    """One that counts, or None where no trial gives one."""
    radius = np.ptp(mesh.points, axis=0).max() * width / 200
    middles = mesh.points[mesh.faces].mean(axis=1)
    for _ in range(TRIALS):
        centre = mesh.points[random.integers(len(mesh.points))]
        inside = np.linalg.norm(middles - centre, axis=1) < radius
        if not inside.any():
            continue
        near = mesh.part(inside)
        label = slabs.components(near)
        # The sheet that the centre is on.
        own = label[near.faces[:, 0]] == label[slabs.nearest(near.points, centre)]
        inside[np.flatnonzero(inside)[~own]] = False
        truth, rest = mesh.part(inside), mesh.part(~inside)
        loops = slabs.simple_loops(rest)
        if loops is None or len(loops) != 1 or len(loops[0]) < FEWEST_EDGES or not is_disc(truth):
            continue
        if slabs.simple_loops(truth) is None or len(np.unique(slabs.components(rest))) != 1:
            continue
        return Disc(name, rest, loops[0], truth)
    return None


def discs(seeds=range(SEEDS)):
    for name, mesh in slabs.closed().items():
        for width in WIDTHS:
            for seed in seeds:
                random = np.random.default_rng([seed, width, len(mesh.faces)])
                found = disc(f"{name}-{width}-{seed}", mesh, width, random)
                if found is not None:
                    yield found
