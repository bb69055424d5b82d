"""Joints between the ends of a bent tube, beside the torus that was there: `make bench ONLY=elbow`. A row has one angle and several
bend radii. A row's ratio is the geometric mean of the peer's distance from the torus over ours."""

import numpy as np

import gusset

from meshes import Mesh
from slabs import Slab
from truth import Truth, nearer

ANGLES = 60, 75, 90, 120
BEND_RADII = 1.5, 2.0, 2.5, 3.0, 4.0  # in radii of the tube
SEGMENTS = 48, 40
LENGTH, RINGS = 4.0, 16
PEERS = {"meshlib": ("gusset", "meshlib"), "meshlib-nicely": ("gusset-best", "meshlib-nicely")}
SECTIONS = 15


def wanted(only):
    return any(only in f"elbow/{angle}/{peer}" for angle in ANGLES for peer in PEERS)


def run(library, report, tools, folder, only):
    best = library.options(finish=gusset.FINISH_BLEND)
    for angle in ANGLES:
        rows = {peer: pair for peer, pair in PEERS.items() if only in f"elbow/{angle}/{peer}"}
        if not rows:
            continue
        cases = list(Elbows(library, tools, folder, best, angle).run(only={name for pair in rows.values() for name in pair}).values())
        for peer, (ours, theirs) in rows.items():
            quality = {"cases": len(cases), **summary(cases, ours), "peer": summary(cases, theirs)}
            report.add(f"elbow/{angle}", peer, 1.0, nearer(cases, ours, theirs), quality, unit="distance")


def summary(cases, who):
    """The worst bend and neck, and all cuts."""
    made = [case[who] for case in cases if "bend" in case[who]]
    return {
        "closed": sum(case[who]["closed"] for case in cases), "cuts": sum(m["intersections"] for m in made),
        "bend": max((m["bend"] for m in made), default=None), "neck": min((m["neck"] for m in made), default=None)}


class Elbows(Truth):
    def __init__(self, library, tools, folder, best, angle):
        super().__init__(library, tools, folder, best)
        self.angle = angle

    def cases(self, _seeds):
        for radius in BEND_RADII:
            yield elbow(self.angle, radius)

    def measured(self, contender, case, truth):
        shape = {}

        def work(case):
            points, faces, first, spent, said = contender(case)
            shape.update(bend=largest_bend(points, faces, first), neck=neck(points, faces[first:], case.name))
            return points, faces, first, spent, said

        return super().measured(work, case, truth) | shape


def sweep(frames, count):
    """A tube of radius 1 around a line: for each frame the middle, the direction away from the bend's centre."""
    t = np.linspace(0, 2 * np.pi, count, endpoint=False)
    x = np.array([1.0, 0.0, 0.0])
    points = np.concatenate([middle + np.outer(np.cos(t), x) + np.outer(np.sin(t), side) for middle, side in frames])
    row, i = (index.ravel() for index in np.meshgrid(np.arange(len(frames) - 1), np.arange(count), indexing="ij"))
    a, b = row * count + i, row * count + (i + 1) % count
    c, d = b + count, a + count
    return Mesh(points, np.concatenate([np.stack([a, c, b], 1), np.stack([a, d, c], 1)]).astype(np.uint32))


def frame(angle, radius, beyond=0.0):
    side = np.array([0.0, np.cos(angle), -np.sin(angle)])
    forward = np.array([0.0, -np.sin(angle), -np.cos(angle)])
    return radius * side + beyond * forward, side


def elbow(degrees, radius):
    """The axis bends around the x axis."""
    angle = np.radians(degrees)
    steps = np.linspace(0, LENGTH, RINGS + 1)
    first = sweep([frame(0.0, radius, -s) for s in steps[::-1]], SEGMENTS[0])
    second = sweep([frame(angle, radius, s) for s in steps], SEGMENTS[1])
    truth = sweep([frame(t, radius) for t in np.linspace(0, angle, 121)], 240)
    pairs = ((np.arange(len(first.points) - SEGMENTS[0], len(first.points)), np.arange(SEGMENTS[1])),)
    return Slab(f"{degrees}-{radius}", (first, second), pairs, truth)


def largest_bend(points, faces, first):
    """The largest angle in degrees between neighbours, one of them new."""
    corners = points[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    ends = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).astype(np.int64), axis=1)
    face = np.tile(np.arange(len(faces)), 3)
    order = np.lexsort((ends[:, 1], ends[:, 0]))
    ends, face = ends[order], face[order]
    same = (ends[1:] == ends[:-1]).all(axis=1)
    p, q = face[:-1][same], face[1:][same]
    new = np.maximum(p, q) >= first
    cosines = (normals[p[new]] * normals[q[new]]).sum(axis=1)
    return float(np.degrees(np.arccos(np.clip(cosines.min(), -1, 1))))


def neck(points, faces, name):
    """The least distance of a section's outline from its own centre, over sections through the axis of the bend."""
    degrees, _ = map(float, name.split("-"))
    least = np.inf
    for t in np.radians(degrees) * np.arange(1, SECTIONS + 1) / (SECTIONS + 1):
        _, side = frame(t, 1.0)
        heights = points @ np.array([0.0, -np.sin(t), -np.cos(t)])
        above = heights[faces] >= 0
        cut = faces[(above.any(axis=1)) & (~above.all(axis=1)) & ((points @ side)[faces].min(axis=1) > -1)]
        middles = []
        for u, v in ((0, 1), (1, 2), (2, 0)):
            p, q = cut[:, u], cut[:, v]
            crossed = (heights[p] >= 0) != (heights[q] >= 0)
            p, q = p[crossed], q[crossed]
            share = (heights[p] / (heights[p] - heights[q]))[:, None]
            middles.append(points[p] + share * (points[q] - points[p]))
        outline = np.concatenate(middles)
        if len(outline):
            flat = np.stack([outline[:, 0], outline @ side], axis=1)
            # The middle of the extent does not depend on where the outline has many points.
            centre = (flat.min(axis=0) + flat.max(axis=0)) / 2
            least = min(least, float(np.linalg.norm(flat - centre, axis=1).min()))
    return least
