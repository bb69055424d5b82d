"""The ten views of the bunny: `make bench ONLY=align` and `ONLY=trim`. Range images become meshes by the library. Alignment: all
poses except the first are disturbed by 3 degrees and 3 % of the size. A seed counts as recovered if every view returns to its
published pose within 0.5 degrees and 0.5 % of the size. Free alignment: all views are rotated and moved at random, and no start
is given. Joining: views at the published poses are trimmed, joined and filled. The
peer is MeshLib's fusion by voxels with as many faces. The judge measures distances from the reference model, and counts
intersections."""

import os
import statistics
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import meshes
import meshlib_peer
import open3d_peer
import trueform_peer
import truth
from meshes import Mesh

DATA = Path(os.environ.get("GUSSET_DATA", "../shared/data"))
ROWS = "align/bunny/meshlib", "align/bunny/trueform", "trim/bunny/meshlib", "align/free-bunny/open3d"
SEEDS = 20
FREE_SEEDS = 100
DEGREES, PART = 3.0, 0.03
NEAR_DEGREES, NEAR_PART = 0.5, 0.005
# Longer edges, in medians, are steps from one surface to another behind it.
MAX_EDGE_RATIO = 4.0
RUNS = 3
# In metres. The model is open at its base, where nothing was seen: larger holes are left, as the peer leaves them. `closed` fills all.
LARGEST_HOLE = 0.02


@dataclass
class View:
    points: np.ndarray
    faces: np.ndarray
    normals: np.ndarray


def wanted(only):
    return any(only in row for row in ROWS)


def run(library, report, tools, folder, only):
    if not (DATA / "scans/bun.conf").exists():
        print("SKIPPED: align, trim: there are no scans in GUSSET_DATA")
        return
    views, poses = bunny(library)
    if any(only in row for row in ROWS[:2]):
        align(library, report, views, poses, only)
    if only in ROWS[3]:
        align_freely(library, report, views, poses)
    if only in ROWS[2]:
        trim(library, report, views, poses, tools, folder)


def bunny(library):
    """The views as meshes, and their poses as matrices."""
    views, poses = [], []
    for line in (DATA / "scans/bun.conf").read_text().splitlines():
        words = line.split()
        if words[:1] != ["bmesh"]:
            continue
        x, y, z, *turned = map(float, words[2:])
        i, j, k, w = np.array(turned) / np.linalg.norm(turned)
        turn = np.array([
            [1 - 2 * (j * j + k * k), 2 * (i * j - k * w), 2 * (i * k + j * w)],
            [2 * (i * j + k * w), 1 - 2 * (i * i + k * k), 2 * (j * k - i * w)],
            [2 * (i * k - j * w), 2 * (j * k + i * w), 1 - 2 * (i * i + j * j)]])
        pose = np.eye(4)
        # The file gives the rotation of the axes.
        pose[:3, :3], pose[:3, 3] = turn.T, (x, y, z)
        poses.append(pose)
        points, faces = library.net_triangles(range_image(DATA / "scans" / words[1]), MAX_EDGE_RATIO)
        views.append(View(points, faces, normals(points, faces)))
    return views, poses


def range_image(path):
    """A grid of rows and columns, NaN where nothing was seen."""
    lines = iter(path.read_text().splitlines())
    size = {}
    for line in lines:
        words = line.split()
        if words[:1] == ["end_header"]:
            break
        if words[0] in ("element", "obj_info"):
            size[words[1]] = words[2]
    points = np.array([next(lines).split()[:3] for _ in range(int(size["vertex"]))], dtype=np.float32)
    grid = np.full((int(size["num_rows"]), int(size["num_cols"]), 3), np.nan, dtype=np.float32)
    for place, line in zip(grid.reshape(-1, 3), lines):
        words = line.split()
        if words[0] != "0":
            place[:] = points[int(words[1])]
    return grid


def normals(points, faces):
    corners = points[faces]
    of_faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sums = np.zeros_like(points)
    for k in range(3):
        np.add.at(sums, faces[:, k], of_faces)
    return sums / np.maximum(np.linalg.norm(sums, axis=1, keepdims=True), 1e-300)


def turn(axis, angle):
    """Rodrigues' rotation."""
    x, y, z = axis
    across = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * across + (1 - np.cos(angle)) * across @ across


def direction(random):
    found = random.normal(size=3)
    return found / np.linalg.norm(found)


def disturbed(views, poses, size, seed):
    random = np.random.default_rng(seed)
    found = [poses[0]]
    for view, pose in zip(views[1:], poses[1:]):
        middle = view.points.mean(axis=0) @ pose[:3, :3].T + pose[:3, 3]
        by = np.eye(4)
        by[:3, :3] = turn(direction(random), np.radians(DEGREES))
        by[:3, 3] = middle + PART * size * direction(random) - by[:3, :3] @ middle
        found.append(by @ pose)
    return found


def is_recovered(views, poses, found, size):
    for view, pose, own in zip(views, poses, found):
        between = own[:3, :3] @ pose[:3, :3].T
        angle = np.degrees(np.arccos(np.clip((np.trace(between) - 1) / 2, -1, 1)))
        middle = view.points.mean(axis=0)
        shift = np.linalg.norm((own - pose)[:3, :3] @ middle + (own - pose)[:3, 3])
        if not (angle <= NEAR_DEGREES and shift <= NEAR_PART * size):
            return False
    return True


def size_of(views, poses):
    placed = np.concatenate([v.points @ p[:3, :3].T + p[:3, 3] for v, p in zip(views, poses)])
    return float(np.linalg.norm(np.ptp(placed, axis=0)))


def align(library, report, views, poses, only):
    size = size_of(views, poses)
    contenders = {
        "gusset": lambda start: library.aligned(views, start),
        "meshlib": lambda start: meshlib_peer.aligned(views, start),
        "trueform": lambda start: trueform_peer.aligned(views, start),
    }
    wanted = ["gusset", *(name for name in ("meshlib", "trueform") if only in f"align/bunny/{name}")]
    times, right, failed = ({name: [] for name in wanted} for _ in range(3))
    for seed in range(SEEDS):
        start = disturbed(views, poses, size, seed)
        for name in wanted:
            began = time.perf_counter()
            try:
                found = contenders[name](start)
            except Exception as error:  # Whatever a peer throws is its result.
                failed[name].append(f"{type(error).__name__}: {error}")
                continue
            times[name].append(1000 * (time.perf_counter() - began))
            right[name].append(is_recovered(views, poses, found, size))
    for name in wanted[1:]:
        quality = {"recovered": sum(right["gusset"]) / SEEDS, "peer_recovered": sum(right[name]) / SEEDS, "seeds": SEEDS}
        if failed[name]:
            quality["peer_failed"] = failed[name][0]
        theirs = statistics.median(times[name]) if times[name] else None
        report.add("align/bunny", name, statistics.median(times["gusset"]), theirs, quality)


def scattered(views, poses, size, seed):
    """The views, each rotated and moved at random, and the poses that take them to the places of the first."""
    random = np.random.default_rng(seed)
    moved, back = [], []
    for view, pose in zip(views, poses):
        by = np.eye(4)
        by[:3, :3] = turn(direction(random), np.pi * random.random()) @ turn(direction(random), np.pi * random.random())
        by[:3, 3] = size * random.normal(size=3)
        moved.append(View(view.points @ by[:3, :3].T + by[:3, 3], view.faces, view.normals @ by[:3, :3].T))
        back.append(pose @ np.linalg.inv(by))
    return moved, [np.linalg.inv(back[0]) @ pose for pose in back]


def align_freely(library, report, views, poses):
    """`wrong`: the seeds in which a view is trusted that is not at its place. The peer says nothing about trust."""
    size = size_of(views, poses)
    contenders = {"gusset": library.aligned_freely, "open3d": lambda moved: (open3d_peer.aligned_freely(moved), None)}
    times, right, failed = ({name: [] for name in contenders} for _ in range(3))
    wrong = 0
    for seed in range(FREE_SEEDS):
        moved, truth_poses = scattered(views, poses, size, seed)
        for name, contender in contenders.items():
            began = time.perf_counter()
            try:
                found, is_trusted = contender(moved)
            except Exception as error:  # Whatever a peer throws is its result.
                failed[name].append(f"{type(error).__name__}: {error}")
                continue
            times[name].append(1000 * (time.perf_counter() - began))
            is_right = [is_recovered([v], [p], [f], size) for v, p, f in zip(moved, truth_poses, found)]
            right[name].append(all(is_right))
            wrong += is_trusted is not None and any(t and not r for t, r in zip(is_trusted, is_right))
    quality = {"recovered": sum(right["gusset"]) / FREE_SEEDS, "peer_recovered": sum(right["open3d"]) / FREE_SEEDS,
               "wrong": wrong / FREE_SEEDS, "seeds": FREE_SEEDS}
    if failed["open3d"]:
        quality["peer_failed"] = failed["open3d"][0]
    theirs = statistics.median(times["open3d"]) if times["open3d"] else None
    report.add("align/free-bunny", "open3d", statistics.median(times["gusset"]), theirs, quality)


def trim(library, report, views, poses, tools, folder):
    pieces = [Mesh(np.ascontiguousarray(v.points @ p[:3, :3].T + p[:3, 3]), v.faces) for v, p in zip(views, poses)]
    reference = truth_of(DATA / "meshes/bunny_stanford.ply")
    ours, spent = [], []
    for _ in range(RUNS):
        start = time.perf_counter()
        ours = library.trimmed_and_joined(pieces, LARGEST_HOLE)
        spent.append(1000 * (time.perf_counter() - start))
    points, faces, maps = ours
    kept = sum(int((of != 0xFFFFFFFF).sum()) for of in maps) / len(points)
    start = time.perf_counter()
    theirs = meshlib_peer.fused(pieces, len(faces))
    peer_spent = 1000 * (time.perf_counter() - start)
    judge = truth.Judged(library, tools, folder)
    closed = library.trimmed_and_joined(pieces)[:2]
    found = [judged(judge, folder, reference, *mesh) for mesh in ((points, faces), theirs, closed)]
    quality = {"kept": kept, **found[0], "ms": statistics.median(spent), "peer": {**found[1], "ms": peer_spent}, "closed": found[2]}
    report.add("trim/bunny", "meshlib", found[0]["rms"], found[1]["rms"], quality, unit="distance")


def truth_of(path):
    lines = iter(path.read_text().splitlines())
    counts = {}
    for line in lines:
        words = line.split()
        if words[0] == "end_header":
            break
        if words[0] == "element":
            counts[words[1]] = int(words[2])
    points = np.array([next(lines).split()[:3] for _ in range(counts["vertex"])], dtype=np.float64)
    faces = np.array([next(lines).split()[1:4] for _ in range(counts["face"])], dtype=np.uint32)
    return Mesh(points, faces)


def judged(judge, folder, reference, points, faces):
    """The distances between the reference's vertices and the mesh, and the defects of the mesh."""
    made, there = folder / "judged.mesh", folder / "truth.mesh"
    meshes.write(Mesh(points, faces), made)
    meshes.write(reference, there)
    found = judge.ask(judge=made, first=0, truth=there)
    if "failed" in found:
        return {"failed": found["failed"], "rms": None, "faces": len(faces)}
    sides = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).astype(np.int64)
    ahead, back = sides[:, 0] << 32 | sides[:, 1], sides[:, 1] << 32 | sides[:, 0]
    free = sides[~np.isin(ahead, back)]
    return {
        "rms": found["rms"], "faces": len(faces), "components": parts(len(points), sides), "intersections": found["intersections"],
        "loops": parts(len(points), free)}


def parts(count, edges):
    """How many parts the ends of edges hang together in."""
    parent = np.arange(count)
    while True:
        least = parent.copy()
        np.minimum.at(least, edges[:, 0], parent[edges[:, 1]])
        np.minimum.at(least, edges[:, 1], parent[edges[:, 0]])
        least = least[least]
        if (least == parent).all():
            return len(np.unique(parent[np.unique(edges)]))
        parent = least
