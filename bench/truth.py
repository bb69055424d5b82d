"""Joins beside the surface that was there: `make bench ONLY=truth`. Each contender joins every slab. The judge measures the
distance of the new faces from the removed surface, and checks closedness and self-intersections. A row's ratio is the geometric
mean of the
peer's distance over ours, over the slabs that both closed."""

import json
import statistics
import subprocess
import time

import numpy as np

import gusset
import meshes
import meshlib_peer
import slab_plot
from meshes import Mesh
from peers import Peer
from slabs import slabs

ROWS = {
    "truth/default/meshlib": ("gusset", "meshlib"),
    "truth/best/cgal": ("gusset-best", "cgal"),
    "truth/best/meshlib-nicely": ("gusset-best", "meshlib-nicely"),
}


# Contenders in the picture.
DRAWN = ("gusset", "gusset-best", "meshlib-nicely", "cgal")


def wanted(only):
    return any(only in row for row in ROWS)


def run(library, report, tools, folder, only, docs):
    """The rows that are wanted; with `docs` also the picture there."""
    best = library.options(finish=gusset.FINISH_BLEND)
    truth = Truth(library, tools, folder, best)
    named = truth.run()
    cases = list(named.values())
    for row, (ours, peer) in ROWS.items():
        if only in row:
            case, name = row.rsplit("/", 1)
            ratio = nearer(cases, ours, peer)
            # Ours is 1, because all cases share no unit of distance.
            report.add(case, name, 1.0, ratio, summary(cases, ours, peer), unit="distance")
    if docs:
        truth.draw(named, docs / "truth.jpg")


def is_closed(faces):
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).astype(np.int64)
    ahead, back = ends[:, 0] << 32 | ends[:, 1], ends[:, 1] << 32 | ends[:, 0]
    return len(np.unique(ahead)) == len(ahead) and bool(np.isin(ahead, back).all())


def whole(slab):
    """Both pieces as one mesh, and the pairs of loops as vertices of it."""
    first, second = slab.pieces
    shift = np.uint32(len(first.points))
    mesh = Mesh(np.concatenate([first.points, second.points]), np.concatenate([first.faces, second.faces + shift]))
    return mesh, [(a, b + int(shift)) for a, b in slab.pairs]


class Judged:
    """Contenders that each work on every case, and the judge of their results. Each case has a name and a `truth`; a contender gives
    points, faces, the first new one, milliseconds, and what else is to be said."""

    def __init__(self, library, tools, folder):
        self.library, self.folder = library, folder
        self.judge = subprocess.Popen([tools / "truth"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, **job):
        self.judge.stdin.write(json.dumps(job, default=str) + "\n")
        self.judge.stdin.flush()
        return json.loads(self.judge.stdout.readline())

    def by_cgal(self, out, **job):
        said = self.ask(out=out, **job)
        if "failed" in said:
            raise RuntimeError(said["failed"])
        made = meshes.read(out)
        return made.points, made.faces, said["first"], said["ms"], {}

    def measured(self, contender, case, truth):
        try:
            points, faces, first, spent, said = contender(case)
            if len(faces) <= first:
                return {"failed": "nothing was made", "closed": False, **said}
            path = self.folder / "judged.mesh"
            meshes.write(Mesh(np.ascontiguousarray(points), np.ascontiguousarray(faces)), path)
            found = self.ask(judge=path, first=first, truth=truth)
            return found | said | {"closed": is_closed(np.asarray(faces)), "ms": spent}
        except Exception as error:  # Whatever a peer throws is its result.
            return {"failed": f"{type(error).__name__}: {error}", "closed": False}

    def run(self, only=None, seeds=None):
        """Everybody's measures of every case, by name."""
        found = {}
        for case in self.cases(seeds):
            truth = self.folder / "truth.mesh"
            meshes.write(case.truth, truth)
            found[case.name] = {
                name: self.measured(work, case, truth) for name, work in self.contenders() if not only or name in only}
        return found


class Truth(Judged):
    def __init__(self, library, tools, folder, best):
        super().__init__(library, tools, folder)
        self.best = best

    def ours(self, slab, strip=None, tuned=True):
        pairs = [((0, int(a[0])), (1, int(b[0]))) for a, b in slab.pairs] if tuned else ()
        start = time.perf_counter()
        made = self.library.assembly(slab.pieces, pairs, strip)
        spent = 1000 * (time.perf_counter() - start)
        points, faces, maps, joined = self.library.assembled(made)
        points, faces = points.copy(), faces.copy()  # The handle frees its own.
        first = sum(len(piece.faces) for piece in slab.pieces)
        right = {frozenset((frozenset(maps[0][a].tolist()), frozenset(maps[1][b].tolist()))) for a, b in slab.pairs}
        wrong = 0
        for sides in joined:
            a, b = (set(side.tolist()) for side in sides)
            wrong += not any((a <= p and b <= q) or (a <= q and b <= p) for p, q in map(tuple, right))
        return points, faces, first, spent, {"wrong_bridges": wrong}

    def meshlib(self, slab, nicely=False):
        mesh, pairs = whole(slab)
        corners = mesh.points[mesh.faces]
        edge = float(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).mean())
        start = time.perf_counter()
        built = meshlib_peer.build(mesh)
        new = np.zeros(0, dtype=bool)
        for pair in pairs:
            ends = meshlib_peer.holes_at(built, len(mesh.points), pair)
            made = (meshlib_peer.nicely(built, ends, edge) if nicely else meshlib_peer.stitch(built, ends, "complex"))[1]
            bits = meshlib_peer.mn.getNumpyBitSet(made)
            marks = np.zeros(max(len(bits), len(new)), dtype=bool)
            marks[:len(new)] = new
            marks[:len(bits)] |= bits
            new = marks
        spent = 1000 * (time.perf_counter() - start)
        points, faces = meshlib_peer.arrays(built)
        marks = np.zeros(len(faces), dtype=bool)
        marks[:len(new)] = new[:len(faces)]
        return points, np.concatenate([faces[~marks], faces[marks]]), int((~marks).sum()), spent, {}

    def cgal(self, slab):
        mesh, pairs = whole(slab)
        path, out = self.folder / "joined.mesh", self.folder / "cgal.mesh"
        meshes.write(mesh, path)
        return self.by_cgal(out, join=path, rims=[[a.tolist(), b.tolist()] for a, b in pairs])

    def contenders(self):
        yield "gusset-untuned", lambda slab: self.ours(slab, tuned=False)
        yield "gusset", self.ours
        yield "gusset-best", lambda slab: self.ours(slab, self.best)
        yield "meshlib", self.meshlib
        yield "meshlib-nicely", lambda slab: self.meshlib(slab, nicely=True)
        yield "cgal", self.cgal

    def cases(self, seeds):
        return slabs(*([seeds] if seeds else []))

    def draw(self, cases, path):
        """The median and the worst of our best joints beside the others."""
        sizes = {slab.name: float(np.linalg.norm(np.ptp(slab.truth.points, axis=0))) for slab in slabs()}
        chosen = slab_plot.chosen(cases, sizes, "gusset-best")
        rows = {}
        for slab in slabs():
            for title in (title for title, name in chosen.items() if name == slab.name):
                joints = {"what was there": self.there(slab)}
                # Contenders that joined nothing are omitted.
                joints |= {
                    who: work(slab)[:3] for who, work in self.contenders()
                    if who in DRAWN and "failed" not in cases[slab.name][who]}
                rows[title] = (f"{title}, {slab.name}", slab.truth, joints)
        slab_plot.write([rows[title] for title in chosen], path)

    def there(self, slab):
        mesh, _ = whole(slab)
        faces = np.concatenate([mesh.faces, slab.truth.faces + np.uint32(len(mesh.points))])
        return np.concatenate([mesh.points, slab.truth.points]), faces, len(mesh.faces)


def clean(measures):
    return measures["closed"] and measures.get("intersections") == 0


def share(cases, who, what):
    return sum(bool(what(case[who])) for case in cases) / len(cases)


def nearer(cases, ours, peer):
    """The peer's distance from the truth divided by ours: the geometric mean over the cases that both closed."""
    logs = [np.log(case[peer]["rms"] / case[ours]["rms"]) for case in cases if case[ours]["closed"] and case[peer]["closed"]]
    return float(np.exp(np.mean(logs))) if logs else None


def summary(cases, ours, peer):
    closed = lambda measures: measures["closed"]
    middle = lambda who, key: statistics.median(case[who][key] for case in cases if key in case[who])
    quality = {"cases": len(cases), "closed": share(cases, ours, closed), "clean": share(cases, ours, clean)}
    if ours == "gusset":
        quality |= {
            "untuned_closed": share(cases, "gusset-untuned", closed), "untuned_clean": share(cases, "gusset-untuned", clean),
            "wrong_bridges": sum(case["gusset-untuned"].get("wrong_bridges", 0) for case in cases)}
    else:
        new = [case[ours] for case in cases if "faces" in case[ours]]
        quality |= {
            "min_angle_median": middle(ours, "min_angle"), "dihedral_p95_median": middle(ours, "dihedral_p95"),
            "under_15_share": sum(m["under_15"] * m["faces"] for m in new) / sum(m["faces"] for m in new)}
    quality["peer"] = {
        "closed": share(cases, peer, closed), "clean": share(cases, peer, clean), "min_angle_median": middle(peer, "min_angle"),
        "dihedral_p95_median": middle(peer, "dihedral_p95")}
    return quality
