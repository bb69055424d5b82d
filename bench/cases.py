"""The cases: who does what on which mesh."""

import json
import subprocess
from functools import cache

import numpy as np

import blender_peer
import gusset
import meshes
import meshlib_peer
import outlines
import scipy_peer
import vtk_peer
from net_cases import NetCases
from timing import Contender, Outcome, PeakMemory, apart, bound, by_turns, once

BOUNDARIES = {
    "coherent-66k": lambda: meshes.jagged().whole,
    "coherent-263k": lambda: meshes.jagged(1).whole,
    "coherent-1M": lambda: meshes.jagged(2).whole,
    "shuffled-1M": lambda: meshes.shuffled(meshes.jagged(2).whole),
    "coherent-4M": lambda: meshes.jagged(3).whole,
}
JOINS = {
    "jagged-486x426": meshes.jagged,
    "planar-713x707": meshes.planar,
    "1000x800": lambda: meshes.collars(1000),
    "4000x3200": lambda: meshes.collars(4000),
    "3888x3408": lambda: meshes.jagged(3),
    "10000x8000": lambda: meshes.collars(10_000),
    "100000x80000": lambda: meshes.collars(100_000),
}
# Here a peer may take hours or all memory, so that everybody works in a process with bounds.
APART = "join/100000x80000", "join-strip/100000x80000"
SECONDS, GIBIBYTES = 45, 4
OUTLINES = "composite", "composite-median", "self", "cubic", "blend"
# Sides of the polygon that approximates a curve, for each given point.
FINE = 100
# A strip that meets itself everywhere has more intersections than are worth counting.
JUDGE_SECONDS = 20
SLOW = {
    ("10000x8000", "meshlib-edge-length"): "skipped, as it takes half a minute a run: SLOW=1 runs it",
    ("100000x80000", "blender"): "skipped, as it takes minutes: SLOW=1 tries it",
    ("3888x3408", "blender"): "skipped, as 4.2 million faces take it gigabytes: SLOW=1 runs it",
}


class Cases(NetCases):
    def __init__(self, library, report, tools, folder, only, slow):
        self.library, self.report, self.tools, self.folder = library, report, tools, folder
        self.only, self.slow = only, slow

    def wants(self, case):
        return self.only in case

    def run(self):
        for module in self.boundaries, self.joins, self.exactness, self.memory, self.rows, self.outlines, self.accuracy, self.nets:
            module()

    # Boundary loops.

    def boundaries(self):
        for name, mesh in BOUNDARIES.items():
            if self.wants(f"boundary/{name}"):
                self.boundary(f"boundary/{name}", mesh())

    def boundary(self, case, mesh):
        built = []

        def ready():
            if not built:
                built.append(meshlib_peer.build(mesh))
            return built[0]

        ours = Contender("gusset", lambda _: self.library.boundary(mesh))
        peers = {
            "meshlib": (lambda _: meshlib_peer.loops(mesh), ready, lambda result: len(result[1])),
            "meshlib-prebuilt": (lambda b: meshlib_peer.mm.findRightBoundary(b.topology), ready, len),
            "vtk": (lambda _: vtk_peer.loops(mesh), lambda: vtk_peer.build(mesh), lambda result: result.GetNumberOfLines()),
        }
        outcomes = by_turns([ours, *(Contender(name, work, prepare) for name, (work, prepare, _) in peers.items())])
        mine = outcomes["gusset"]
        for name, (_, _, loops) in peers.items():
            theirs = outcomes[name]
            found = None if mine.failed or theirs.failed else loops(theirs.result)
            same = found is not None and found == self.library.loop_count(mine.result)
            self.report.add(case, name, mine, theirs, {"same_result": same})

    # Joins.

    def joins(self):
        for name in JOINS:
            for case, contenders in (f"join/{name}", self.wholes), (f"join-strip/{name}", self.steps):
                if self.wants(case):
                    self.compare(case, contenders(name))

    def wholes(self, name):
        """From arrays to arrays."""
        gap = JOINS[name]()
        # Everybody is judged, which takes long where the mesh is large; the small one of its kind shows the same.
        kinds = [] if name == "3888x3408" else [kind for kind in gusset.MERIDIANS if kind != "continuation"]
        return [
            self.stitch(gap, "gusset", self.library.options()),
            meshlib_peer.whole_contender(gap, "complex"),
            blender_peer.whole_contender(gap),
            *(self.stitch(gap, f"gusset-{kind}", self.library.options(kind)) for kind in kinds),
        ]

    def steps(self, name):
        """The strip alone, where everything else is known: for ours two rims from a given start, for the peers a mesh with its
        holes."""
        gap = JOINS[name]()
        rims = []

        def ready():
            if not rims:
                rims.extend(self.library.rims(self.library.stitch(gap.pieces, self.library.options("index"))))
            return rims

        return [
            Contender("gusset", lambda rims: self.library.strip(*rims), ready),
            meshlib_peer.step_contender(gap, "complex"),
            meshlib_peer.step_contender(gap, "edge-length"),
            vtk_peer.step_contender(gap, False),
            vtk_peer.step_contender(gap, True),
            blender_peer.step_contender(gap),
        ]

    def stitch(self, gap, name, options):
        return Contender(name, lambda _: self.library.stitch(gap.pieces, options), mesh=self.library.mesh)

    def exactness(self):
        """The strip of least area found coarse to fine, beside the exact one: time, and what its area is more."""
        for name in "3888x3408", "10000x8000":
            if not self.wants(f"join-exact/{name}"):
                continue
            rims = self.library.rims(self.library.stitch(JOINS[name]().pieces, self.library.options("index")))
            kinds = {"gusset": 0, "gusset-exact": gusset.SEARCH_EXACT}
            outcomes = by_turns([
                Contender(who, lambda _, search=search: self.library.strip(*rims, search=search)) for who, search in kinds.items()])
            near, exact = (self.library.strip_area(outcomes[who].result, *rims) for who in kinds)
            self.report.add(f"join-exact/{name}", "gusset-exact", *outcomes.values(), {"area_above_exact": near / exact - 1})

    def memory(self):
        """How far memory rises above what is held before, in a process of its own."""
        for name in "10000x8000", "100000x80000":
            if self.wants(f"join-memory/{name}"):
                peaks = []
                for who in "gusset", "meshlib-complex":
                    outcome, said = self.alone(f"join/{name}", who)
                    peaks.append(Outcome([said.get("memory")], failed=outcome.failed))
                self.report.add(f"join-memory/{name}", "meshlib-complex", *peaks, unit="MiB")

    # Rows of new vertices.

    def rows(self):
        for name, make in ("jagged", meshes.jagged), ("planar", meshes.planar):
            for variant, options in self.rows_variants().items():
                if self.wants(f"rows/{name}{variant}"):
                    self.compare(f"rows/{name}{variant}", self.in_rows(make(), options))

    @staticmethod
    def rows_variants():
        """The first contender is the library at its best; the others show the effect of each part."""
        fair = dict(meridians="quad", fairing=gusset.FAIRING_THIN_PLATE)
        return {
            "": dict(finish=gusset.FINISH_BLEND),
            "-5": dict(rows=gusset.ROWS_COUNT, row_count=5, **fair),
            "-mean-edge": dict(rows=gusset.ROWS_MEAN_EDGE, **fair),
            "-unfair": dict(meridians="quad", rows=gusset.ROWS_COUNT, row_count=5),
            "-area-mean-edge": dict(meridians="area", rows=gusset.ROWS_MEAN_EDGE),
            "-area-5": dict(meridians="area", rows=gusset.ROWS_COUNT, row_count=5),
        }

    def in_rows(self, gap, options):
        corners = gap.whole.points[gap.whole.faces]
        edge = float(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).mean())
        return [
            self.stitch(gap, "gusset", self.library.options(**options)),
            meshlib_peer.rows_contender(gap, edge),
        ]

    # Outlines. SISL and Open CASCADE are in the program in C++.

    def outlines(self):
        wanted = [kind for kind in OUTLINES if self.wants(f"outline/{kind}")]
        if not wanted:
            return
        given = outlines.everything()
        ours = [Contender(kind, lambda _, kind=kind: self.library.outline(given, kind)) for kind in wanted]
        scipy = Contender("scipy", scipy_peer.splines, lambda: scipy_peer.build(given))
        outcomes = by_turns([*ours, scipy])
        for outcome in outcomes.values():
            outcome.result, outcome.times = None, [1e6 * time / len(given.points) for time in outcome.times]
        for kind in wanted:
            self.report.add(f"outline/{kind}", "scipy", outcomes[kind], outcomes["scipy"], unit="ns")

    def accuracy(self):
        """How far curves through few points of smooth outlines are from the outlines; in thousandths of their size."""
        for name, feet in ("formula", outlines.feet), ("data", outlines.feet_of_data):
            case = f"outline-accuracy/{name}"
            if self.wants(case) and feet():
                given, truth = feet()
                farthest = {}
                for who, polygons in self.polygons(given):
                    found = [outlines.deviation(dense, polygon) for dense, polygon in zip(truth, polygons)]
                    farthest[who] = 1000 * float(np.median(found))
                for who, value in farthest.items():
                    if who != "composite":
                        ours = who in gusset.OUTLINES
                        self.report.add(case, f"gusset-{who}" if ours else who, farthest["composite"], value, unit="permille")

    def polygons(self, given):
        """The curves of everybody as fine polygons."""
        for kind in gusset.OUTLINES:
            try:
                yield kind, self.library.outline_sampled(self.library.outline(given, kind), FINE)
            except RuntimeError as error:
                print(f"gusset-{kind}: {error}")
        built = scipy_peer.build(given)
        yield "scipy", scipy_peer.sampled(built, scipy_peer.splines(built), FINE)
        path, samples = self.folder / "feet.outlines", self.folder / "feet.samples"
        outlines.write(given, path)
        subprocess.run([self.tools / "outlines", "--outlines", path, "--samples", samples, "--fine", str(FINE)], check=True)
        lengths = [FINE * len(points) + 1 for points in given]
        points = np.fromfile(samples).reshape(2, sum(lengths), 2)
        for who, theirs in zip(("sisl", "occt"), points):
            yield who, np.split(theirs, np.cumsum(lengths)[:-1])

    # Contenders that are compared by their meshes.

    def compare(self, case, contenders):
        name = case.split("/")[1]
        skipped = {} if self.slow else {who: why for (what, who), why in SLOW.items() if what == name}
        outcomes = {who: Outcome(failed=why) for who, why in skipped.items()}
        judged = {}
        if case in APART:
            for contender in contenders:
                if contender.name not in skipped:
                    outcomes[contender.name], said = self.alone(case, contender.name)
                    judged[contender.name] = said.get("quality", {})
        else:
            outcomes |= by_turns([c for c in contenders if c.name not in skipped])
            judged = {c.name: self.quality(c, outcomes[c.name]) for c in contenders}
        ours, *peers = contenders
        for peer in peers:
            quality = {**judged.get(ours.name, {}), **({"peer": judged[peer.name]} if judged.get(peer.name) else {})}
            self.report.add(case, peer.name, outcomes[ours.name], outcomes[peer.name], quality)
        for outcome in outcomes.values():
            outcome.result = None

    @cache
    def alone(self, case, who):
        return apart(case, who, SECONDS + JUDGE_SECONDS)

    def quality(self, contender, outcome):
        """The judgement of the last result."""
        if outcome.failed or contender.mesh is None:
            return {}
        points, faces, first = contender.mesh(outcome.result)
        path = self.folder / "judged.mesh"
        meshes.write(meshes.Mesh(points, faces), path)
        try:
            judge = [self.tools / "quality", path, str(first)]
            done = subprocess.run(judge, capture_output=True, text=True, timeout=JUDGE_SECONDS)
        except subprocess.TimeoutExpired:
            return {"faces": len(faces) - first, "judge": f"not done in {JUDGE_SECONDS} s"}
        return json.loads(done.stdout) if done.returncode == 0 else {"judge": done.stderr.strip()}

    def apart(self, wanted):
        """In the process with bounds: one contender of one case, up to three times. The last line printed is the Outcome."""
        bound(GIBIBYTES * 2**30)
        case, name, who = wanted.split("/")
        contender = next(c for c in (self.wholes if case == "join" else self.steps)(name) if c.name == who)
        outcome = Outcome()
        try:
            contender.prepare()
        except Exception:  # It will fail again, and be recorded, when it is run.
            pass
        with PeakMemory() as peak:
            once(contender, outcome)
        while not outcome.failed and len(outcome.times) < 3 and sum(outcome.times) < 5000:
            once(contender, outcome)
        if outcome.failed and outcome.failed.startswith("MemoryError"):
            outcome.failed += f" ({GIBIBYTES} GiB were allowed)"
        said = {"times": outcome.times, "failed": outcome.failed, "memory": peak.mebibytes}
        print(json.dumps({**said, "quality": self.quality(contender, outcome)}))
