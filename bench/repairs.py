"""Repairs of meshes with seeded defects: `make bench ONLY=repair/`. Each kind of defect has 30 cases. The original is known; CGAL
judges. `repair/KIND/PEER` compares the distances from the original: the geometric mean of the peer's over ours, over the cases that
both make valid. The quality says for both: valid results, parts lost, the share of far faces kept bit for bit, the time, and
for ours whether a second repair changes nothing."""

import json
import math
import statistics
import sys
import zlib
from pathlib import Path

import numpy as np

import broken
import broken_parts
import meshes
from broken import Work, single
from meshes import Mesh
from repair_bases import generated, demo_meshes
from repair_peers import PEERS, Worker

CASES = 30
KINDS = (*broken.LOCAL, "touching", "crossing", "walls", "shells", "mixed")
CONTENDERS = ("cgal", *PEERS)
#: A part is lost if less than this share of it has the result near.
LEAST_SHARE = 0.5
#: Distances below this share of the diagonal count as this: rounding to single precision.
LEAST_DISTANCE = 1e-7
PATIENCE = 30.0


def wanted(only):
    return any(only in f"repair/{kind}/{peer}" for kind in KINDS for peer in CONTENDERS)


class Judge:
    """CGAL, which also repairs."""

    def __init__(self, tools, folder, patience=120.0):
        self.worker, self.folder = Worker([str(tools / "repair_judge")], patience), folder

    def ask(self, **job):
        said = self.worker.ask(json.dumps(job, default=str))
        if "failed" in said:
            raise RuntimeError(said["failed"])
        return said

    def _written(self, points, faces):
        path = self.folder / "asked.mesh"
        meshes.write(Mesh(points, np.asarray(faces)), path)
        return path

    def pairs(self, points, faces):
        return np.array(self.ask(pairs=self._written(points, faces))["pairs"], dtype=np.int64).reshape(-1, 2)

    def covered(self, points, faces):
        marks = np.zeros(len(faces), dtype=bool)
        marks[self.ask(covered=self._written(points, faces))["covered"]] = True
        return marks

    def is_valid(self, mesh):
        path = self._written(mesh.points, mesh.faces)
        return self.ask(judge=path, truth=path, united=False)["valid"]


def bases(judge):
    """The closed meshes that CGAL finds valid."""
    found = []
    for name, mesh in [*demo_meshes(), *generated()]:
        mesh = Mesh(single(mesh.points), mesh.faces.astype(np.int64))
        if judge.is_valid(mesh):
            found.append((name, mesh))
    return found


def make_case(kind, number, held, judge):
    """Case `number` of a kind. Another base is taken where a kind does not find a place."""
    rng = np.random.default_rng([zlib.crc32(kind.encode()), number])
    for trial in range(len(held)):
        name, base = held[(number + trial * 7) % len(held)]
        other = held[rng.integers(len(held))][1]
        if kind in broken.LOCAL:
            work = Work(base, judge, rng)
            broken.LOCAL[kind](work)
        elif kind in ("walls", "shells"):
            work = getattr(broken_parts, kind)(base, judge, rng)
        else:
            work = getattr(broken_parts, kind)(base, other, judge, rng)
        if work is not None:
            return work.finish(f"{kind}-{number}-{name}")
    raise RuntimeError(f"no base has a place for {kind} {number}")


def rows_of(corners):
    """Each triangle as bytes, from its least corner on."""
    corners = np.ascontiguousarray(corners, dtype=np.float64).reshape(-1, 3, 3) + 0.0  # No negative zeros.
    keys = corners.view(np.dtype((np.void, 24))).reshape(-1, 3)
    found = []
    for a, b, c in keys:
        a, b, c = a.tobytes(), b.tobytes(), c.tobytes()
        k = min(range(3), key=(a, b, c).__getitem__)
        found.append((a + b + c, b + c + a, c + a + b)[k])
    return found


def kept(case, points, faces):
    """The share of far faces that the result has bit for bit."""
    if not len(case.far):
        return 1.0
    made = set(rows_of(points[faces]))
    return sum(row in made for row in rows_of(case.far)) / len(case.far)


class Repairs:
    def __init__(self, prefix, tools, folder, contenders=("gusset", *CONTENDERS)):
        self.folder, self.judge = folder, Judge(tools, folder)
        self.held = None  # The bases, as soon as they are needed.
        self.workers = {}
        for name in contenders:
            command = [str(tools / "repair_judge")] if name == "cgal" else [
                sys.executable, str(Path(__file__).with_name("repair_peers.py")), name, str(prefix)]
            self.workers[name] = Worker(command, PATIENCE)

    def repaired(self, name, given, out):
        line = json.dumps({"repair": str(given), "out": str(out)}) if name == "cgal" else f"{given}\t{out}"
        return self.workers[name].ask(line)

    def measured(self, name, case, given, truth):
        out = self.folder / f"repaired-{name}.mesh"
        said = self.repaired(name, given, out)
        if "failed" in said:
            return {"valid": False, **said}
        try:
            made = meshes.read(out)
            said |= self.judge.ask(judge=out, truth=truth, united=case.united)
        except RuntimeError as error:
            return {"valid": False, "failed": f"judge: {error}"}
        parts = np.array(said["parts"])
        said |= {"lost": int((parts < LEAST_SHARE).sum()), "kept": kept(case, made.points, made.faces)}
        if name == "gusset":
            again = self.folder / "repaired-again.mesh"
            said["idempotent"] = "failed" not in self.repaired(name, out, again) and again.read_bytes() == out.read_bytes()
        return said

    def run(self, kind, names, numbers=range(CASES)):
        """The contenders' measures of each case of a kind."""
        self.held = self.held or bases(self.judge)
        given, truth = self.folder / "given.mesh", self.folder / "original.mesh"
        cases = []
        for number in numbers:
            case = make_case(kind, number, self.held, self.judge)
            meshes.write(Mesh(case.points, case.faces), given)
            meshes.write(case.truth, truth)
            cases.append({name: self.measured(name, case, given, truth) for name in names})
        return cases

    def close(self):
        for worker in (self.judge.worker, *self.workers.values()):
            worker.close()


def summary(cases, who):
    made = [case[who] for case in cases]
    done = [m for m in made if "failed" not in m]
    said = {"valid": sum(m["valid"] for m in made), "lost": sum(m["lost"] for m in done),
            "kept": statistics.fmean(m["kept"] for m in done) if done else None,
            "ms": statistics.median(m["ms"] for m in done) if done else None}
    if who == "gusset":
        said["idempotent"] = sum(m.get("idempotent", False) for m in made)
    return said


def nearer(cases, peer):
    """The geometric mean of the peer's distance over ours."""
    ratios = [max(case[peer]["rms"], LEAST_DISTANCE) / max(case["gusset"]["rms"], LEAST_DISTANCE)
              for case in cases if case[peer]["valid"] and case["gusset"]["valid"]]
    return math.exp(statistics.fmean(map(math.log, ratios))) if ratios else None


def run(prefix, report, tools, folder, only):
    repairs = Repairs(prefix, tools, folder)
    for kind in KINDS:
        peers = [peer for peer in CONTENDERS if only in f"repair/{kind}/{peer}"]
        if not peers:
            continue
        cases = repairs.run(kind, ("gusset", *peers))
        for peer in peers:
            quality = {"cases": len(cases), **summary(cases, "gusset"), "peer": summary(cases, peer)}
            report.add(f"repair/{kind}", peer, 1.0, nearer(cases, peer), quality, unit="distance")
    repairs.close()
