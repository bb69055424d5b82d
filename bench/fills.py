"""Filled holes beside the surface that was there: `make bench ONLY=fill/truth`. Each contender fills every disc. The judge measures
the distance of the new faces from the removed surface, and checks closedness and self-intersections. A row's ratio is the geometric
mean of
the peer's distance over ours, over the discs that both closed."""

import json
import statistics
import subprocess
import time

import numpy as np

import gusset
import meshes
import meshlib_peer
import truth
from discs import discs
from meshes import Mesh

ROWS = {
    "fill/truth-plain/meshlib": ("gusset", "meshlib"),
    "fill/truth-plain/cgal": ("gusset", "cgal"),
    "fill/truth-fair/cgal": ("gusset-fair", "cgal-fair"),
    "fill/truth-fair/meshlib-nicely": ("gusset-fair", "meshlib-nicely"),
}


SPEEDS = "fill/rim-7657", "fill/rim-1e5", "fill/holes-81-in-8M"
RUNS = 3
# In mean edges of the removed surface.
LEAST = 0.01
# Seconds that a peer gets.
PATIENCE = 60


def wanted(only):
    return any(only in row for row in (*ROWS, *SPEEDS))


def run(library, report, tools, folder, only):
    if any(only in row for row in SPEEDS):
        speeds(library, report, tools, folder, only)
    if not any(only in row for row in ROWS):
        return
    cases = list(Fills(library, tools, folder).run().values())
    for case in cases:
        for measures in case.values():
            # Some patches equal the removed surface: their ratio means nothing.
            if "rms" in measures:
                measures["rms"] = max(measures["rms"], LEAST * measures["edge"])
    for row, (ours, peer) in ROWS.items():
        if only in row:
            case, name = row.rsplit("/", 1)
            # Ours is 1, because all cases share no unit of distance.
            report.add(case, name, 1.0, truth.nearer(cases, ours, peer), summary(cases, ours, peer), unit="distance")


def wavy(count):
    """A ring of triangles whose inner rim is a wavy line in space."""
    t = 2 * np.pi * np.arange(count) / count
    rim = np.stack([np.cos(t) * (1 + 0.1 * np.sin(7 * t)), np.sin(t) * (1 + 0.1 * np.cos(5 * t)), 0.2 * np.sin(3 * t)], axis=1)
    outer = 1.02 * rim - [0, 0, 0.01]
    i = np.arange(count)
    j = (i + 1) % count
    faces = np.concatenate([np.stack([i, i + count, j + count], axis=1), np.stack([i, j + count, j], axis=1)])
    return Mesh(np.concatenate([rim, outer]), np.ascontiguousarray(faces.astype(np.uint32)))


def holed():
    """Two bunnies side by side, 8.9 million triangles, with 81 holes."""
    bunny = meshes.bunny()
    while len(bunny.faces) < 4e6:
        bunny = meshes.subdivided(bunny)
    beside = bunny.points + 1.5 * np.ptp(bunny.points, axis=0) * [1, 0, 0]
    faces = np.concatenate([bunny.faces, bunny.faces + np.uint32(len(bunny.points))])
    mesh = Mesh(np.concatenate([bunny.points, beside]), faces)
    random = np.random.default_rng(3)
    reach = 0.003 * np.ptp(bunny.points, axis=0).max()
    middles = mesh.points[mesh.faces].mean(axis=1)
    kept = np.ones(len(mesh.faces), dtype=bool)
    for centre in mesh.points[random.integers(len(mesh.points), size=81)]:
        kept &= np.linalg.norm(middles - centre, axis=1) > reach
    return mesh.part(kept)


def speeds(library, report, tools, folder, only):
    """Our times from arrays to arrays; CGAL's without reading and writing, the hole along the ring's inner rim alone."""
    def ours(mesh, **options):
        times = []
        for _ in range(RUNS):
            start = time.perf_counter()
            made = library.fill(mesh, library.fill_options(keep=gusset.KEEP_LONGEST, **options))
            times.append(1000 * (time.perf_counter() - start))
            del made
        return statistics.median(times)

    for case, count in (("fill/rim-7657", 7657), ("fill/rim-1e5", 100_000)):
        if only not in case:
            continue
        mesh = wavy(count)
        path, out = folder / "rim.mesh", folder / "filled.mesh"
        meshes.write(mesh, path)
        job = json.dumps({"fill": str(path), "out": str(out), "fair": False, "shortest": True})
        try:
            done = subprocess.run([tools / "truth"], input=job, capture_output=True, text=True, timeout=PATIENCE)
            said = json.loads(done.stdout)
        except (subprocess.TimeoutExpired, json.JSONDecodeError):
            said = {"failed": f"nothing within {PATIENCE} s"}
        report.add(case, "cgal", ours(mesh), said.get("ms"), said if "failed" in said else {})
        unchecked = ours(mesh, intersections=gusset.INTERSECTIONS_IGNORE)
        report.add(case, "gusset-unchecked", ours(mesh), unchecked)
    if only in "fill/holes-81-in-8M":
        mesh = holed()
        start = time.perf_counter()
        built = meshlib_peer.build(mesh)
        meshlib_peer.fill(built)
        meshlib_peer.arrays(built)
        peer = 1000 * (time.perf_counter() - start)
        report.add("fill/holes-81-in-8M", "meshlib", ours(mesh), peer)


def mean_edge(mesh):
    corners = mesh.points[mesh.faces]
    return float(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).mean())


class Fills(truth.Judged):
    """Contenders give points, faces, the first new one, and milliseconds."""

    def ours(self, disc, **options):
        start = time.perf_counter()
        made = self.library.fill(disc.rest, self.library.fill_options(**options))
        spent = 1000 * (time.perf_counter() - start)
        points, faces = self.library.filled(made)
        return points.copy(), faces.copy(), len(disc.rest.faces), spent, {}

    def meshlib(self, disc, nicely=False):
        edge = mean_edge(disc.rest)
        start = time.perf_counter()
        built = meshlib_peer.build(disc.rest)
        new = meshlib_peer.fill(built, edge if nicely else None)
        spent = 1000 * (time.perf_counter() - start)
        return *meshlib_peer.mesh((built, new)), spent, {}

    def cgal(self, disc, fair=False):
        path, out = self.folder / "open.mesh", self.folder / "cgal.mesh"
        meshes.write(disc.rest, path)
        return self.by_cgal(out, fill=path, fair=fair)

    def contenders(self):
        yield "gusset", self.ours
        yield "gusset-fair", lambda disc: self.ours(disc, refine=gusset.REFINE_RIM_DENSITY, fairing=gusset.FAIRING_THIN_PLATE)
        yield "meshlib", self.meshlib
        yield "meshlib-nicely", lambda disc: self.meshlib(disc, nicely=True)
        yield "cgal", self.cgal
        yield "cgal-fair", lambda disc: self.cgal(disc, fair=True)

    def measured(self, contender, case, truth):
        return super().measured(contender, case, truth) | {"edge": mean_edge(case.truth)}

    def cases(self, seeds):
        return discs(*([seeds] if seeds else []))


def summary(cases, ours, peer):
    cuts = lambda who: sum(case[who].get("intersections", 0) for case in cases)
    quality = {
        "cases": len(cases), "closed": truth.share(cases, ours, lambda m: m["closed"]),
        "clean": truth.share(cases, ours, truth.clean), "cuts": cuts(ours), "peer_cuts": cuts(peer),
        "peer_clean": truth.share(cases, peer, truth.clean)}
    quality["min_angle_median"] = statistics.median(case[ours]["min_angle"] for case in cases if "min_angle" in case[ours])
    return quality
