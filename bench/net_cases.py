"""The cases of nets whose peers are in Python: VTK, PyVista, Draco. Half-edge meshes are in the program in C++."""

import numpy as np

import draco_peer
import nets
import vtk_grid_peer
from timing import Contender, Outcome, by_turns

SIDES = {"1e6": 1000, "1e7": 3162}
MOTION = [0.8, -0.6, 0, 0.1, 0.48, 0.64, -0.6, 0.2, 0.36, 0.48, 0.8, -0.3]
BITS = 14
# The cases that the program in C++ has.
CPP = "affine-1e6", "affine-1e7", "normals-1e6", "normals-1e7", "concat-1e6", "classes-1e6", "memory"


class NetCases:
    """Part of Cases."""

    def nets(self):
        for size, side in SIDES.items():
            if self.wants(f"net/affine-{size}"):
                self.affine(f"net/affine-{size}", side)
            if self.wants(f"net/normals-{size}"):
                self.normals(f"net/normals-{size}", side)
        for case, work in {"concat-1e6": self.concat, "classes-1e6": self.classes, "memory": self.net_memory}.items():
            if self.wants(f"net/{case}"):
                work(f"net/{case}")
        surfaces = {"": lambda: nets.torus(1000, 1e-3), "-smooth": lambda: nets.torus(1000)}
        surfaces |= {f"-{name}": lambda points=points: points for name, points in nets.real().items()}
        for name, points in surfaces.items():
            if self.wants(f"net/stream-{BITS}bit{name}"):
                self.stream(f"net/stream-{BITS}bit{name}", points())

    def enter(self, case, outcomes, quality=None, unit="ms", **judged):
        """The first outcome is ours; `judged` has the remarks on peers."""
        ours, *peers = outcomes
        for peer in peers:
            said = {**(quality or {}), **({"peer": judged[peer]} if peer in judged else {})}
            self.report.add(case, peer, outcomes[ours], outcomes[peer], said, unit)

    def affine(self, case, side):
        points = nets.torus(side)
        net = self.library.net(points, "torus")
        grid = []

        def ready():
            if not grid:
                grid.append(vtk_grid_peer.grid(points))
            return grid[0]

        self.enter(case, by_turns([
            Contender("gusset", lambda _: self.library.net_move(net, MOTION)),
            Contender("vtk", lambda data: vtk_grid_peer.moved(data, MOTION), ready),
            Contender("pyvista", lambda data: vtk_grid_peer.pyvista.wrap(data).transform(
                np.array([*MOTION, 0, 0, 0, 1]).reshape(4, 4), inplace=False), ready),
            Contender("numpy", lambda _: points @ MATRIX + OFFSET),
        ]))

    def normals(self, case, side):
        points = nets.torus(side)
        net = self.library.net(points, "torus")
        room = np.empty((3, side, side), dtype=np.float32)
        polygons = []

        def ready():
            if not polygons:
                polygons.append(vtk_grid_peer.surface(vtk_grid_peer.grid(points)))
            return polygons[0]

        outcomes = by_turns([
            Contender("gusset", lambda _: self.library.net_normals(net, room)),
            Contender("vtk", vtk_grid_peer.normals, ready),
        ])
        ball = nets.sphere(33, 65)
        found = self.library.net_normals(self.library.net(ball, "two-poles"), np.empty((3, 33, 65), dtype=np.float32))
        quality, theirs = {"max_error_degrees": nets.off_by(np.moveaxis(found, 0, -1), ball)}, {}
        if not outcomes["vtk"].failed:
            result = vtk_grid_peer.normals(vtk_grid_peer.surface(vtk_grid_peer.grid(ball)))
            off = nets.off_by(vtk_grid_peer.normals_of(result), vtk_grid_peer.points_of(result))
            # Cells may have either orientation: inward normals are not an error.
            theirs = {"max_error_degrees": min(off, nets.off_by(-vtk_grid_peer.normals_of(result), vtk_grid_peer.points_of(result)))}
        self.enter(case, outcomes, quality, vtk=theirs)

    def concat(self, case):
        halves = vtk_grid_peer.halves(nets.torus(1000))
        ours = [self.library.net(half, "sheet") for half in halves]
        grids = []

        def ready():
            if not grids:
                grids.append(tuple(vtk_grid_peer.structured(half) for half in halves))
            return grids[0]

        self.enter(case, by_turns([
            Contender("gusset", lambda _: self.library.net_join(*ours)),
            Contender("pyvista", lambda both: both[0].concatenate(both[1], axis=1), ready),
            Contender("vtk-append-merge", lambda both: vtk_grid_peer.appended(*both), ready),
        ]))

    def classes(self, case):
        """Classes of coincident nodes: ours come from the gluing, VTK's from positions."""
        points = nets.torus(1000)
        net = self.library.net(points, "torus", as_matrix=True)
        room = np.empty(points.shape[:2], dtype=np.uint32)
        polygons = []

        def ready():
            if not polygons:
                polygons.append(vtk_grid_peer.surface(vtk_grid_peer.grid(points)))
            return polygons[0]

        self.enter(case, by_turns([
            Contender("gusset", lambda _: self.library.net_classes(net, room)),
            Contender("vtk-clean", vtk_grid_peer.cleaned, ready),
        ]))

    def net_memory(self, case):
        """Bytes for each node."""
        points = nets.torus(1000)
        count = points[..., 0].size
        # The coordinates; that there is nothing else is measured by the program in C++.
        ours = 12.0
        held = {"vtk-structured": vtk_grid_peer.grid, "vtk-polygons": lambda points: vtk_grid_peer.surface(vtk_grid_peer.grid(points))}
        for who, make in held.items():
            try:
                theirs = 1024 * vtk_grid_peer.kibibytes(make(points)) / count
            except Exception as error:  # A peer that is absent.
                theirs = Outcome(failed=str(error))
            self.report.add(case, who, ours, theirs, unit="B")

    def stream(self, case, points):
        """Bits for each node that is there, and times. Draco takes the triangles of the cells, at the level that is smaller."""
        count = int(np.isfinite(points).all(axis=-1).sum())
        kind = "torus" if case.endswith(("bit", "smooth")) else "sheet"
        net, mesh = self.library.net(points, kind), nets.triangles(points)
        stream = self.library.net_encode(net, BITS)
        ours = 8 * len(self.library.stream_bytes(stream)) / count
        levels = {}
        for level in draco_peer.LEVELS:
            try:
                levels[level] = draco_peer.encode(mesh, BITS, level)
            except Exception as error:  # A peer that is absent.
                self.report.add(case, "draco", ours, Outcome(failed=str(error)), unit="bit")
                return
        level = min(levels, key=lambda level: len(levels[level]))
        self.report.add(case, "draco", ours, 8 * len(levels[level]) / count, {"level": level}, "bit")
        data = self.library.stream_bytes(stream)
        encoding = by_turns([
            Contender("gusset", lambda _: self.library.net_encode(net, BITS)),
            Contender("draco", lambda _: draco_peer.encode(mesh, BITS, level)),
            Contender("gusset-automatic", lambda _: self.library.net_encode(net, BITS, automatic=True)),
        ])
        decoding = by_turns([
            Contender("gusset", lambda _: self.library.net_decode(data)),
            Contender("draco", lambda _: draco_peer.decode(levels[level])),
            Contender("gusset-automatic", lambda _: self.library.net_decode(data, automatic=True)),
        ])
        what, rest = case.split("bit")
        self.enter(f"{what}bit-encode{rest}", encoding)
        self.enter(f"{what}bit-decode{rest}", decoding)


MATRIX = np.array(MOTION, dtype=np.float32).reshape(3, 4)[:, :3].T.copy()
OFFSET = np.array(MOTION, dtype=np.float32).reshape(3, 4)[:, 3].copy()
