"""Boundary loops, joining, filling, repair and checks of polygon meshes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import Any, Optional, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import indices_of
from ._call import Progress
from ._handles import Reported, Result, create, result
from ._keywords import options as structs
from ._library import ffi, holding, lib
from ._options import (AlignmentOptions, BoundaryOptions, DevelopOptions, FillOptions, JoinOptions, OrientOptions, RepairOptions, StitchOptions,
                       TrimOptions, Unpack, WeldOptions)
from ._records import indices_struct
from ._reports import (AlignmentView, BoundaryView, CheckView, DevelopReport, FillReport, HoleArray, JoinReport, Joint, LoopView, OrientReport,
                       QualityReport, RepairReport, SewReport, StitchReport, TrimView, WeldReport)
from .mesh import Mesh, MeshLike, as_mesh, of_one_precision, view_of, views_of

__all__ = ["Alignment", "Boundary", "Check", "Development", "Fill", "Join", "Orient", "Repair", "Sew", "Stitch", "Triangulation", "Trim", "Unite", "Weld",
           "align", "boundary_loops", "check", "develop", "fill", "join", "orient", "repair", "sew", "stitch", "triangulate", "trim", "unite", "weld"]


def _create(kind: str, meshes: Sequence[Mesh], *arguments: Any, threads: int = 0, progress: Optional[Progress] = None) -> Any:
    """Creates a handle by a function whose first arguments are meshes."""
    return create(kind, views_of(meshes), *arguments, threads=threads, progress=progress, is_short=kind in _QUICK and _are_small(meshes))


def _result(function: str, meshes: Sequence[Mesh], *arguments: Any, threads: int = 0, progress: Optional[Progress] = None) -> Any:
    """Calls a function that makes a mesh from meshes, its first arguments."""
    return result(function, views_of(meshes), *arguments, threads=threads, progress=progress, is_short=function in _QUICK and _are_small(meshes))


#: Functions of linear time. On a small mesh they end before a signal could stop them.
_QUICK = {"boundary", "check", "weld", "sew", "orient", "triangulate"}


def _are_small(meshes: Sequence[Mesh]) -> bool:
    return sum(len(mesh.corners) for mesh in meshes) < 3000


class Boundary(Reported[BoundaryView], Sequence[LoopView]):
    """The boundary loops of a mesh; ``report`` has its defects."""

    REPORT = BoundaryView

    def __len__(self) -> int:
        return self.report.loop_count

    @overload
    def __getitem__(self, index: int) -> LoopView: ...

    @overload
    def __getitem__(self, index: slice) -> list[LoopView]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[LoopView, list[LoopView]]:
        places = range(len(self))[index]
        return [self[k] for k in places] if isinstance(places, range) else LoopView.read(self._handle, places)

    def __iter__(self) -> Iterator[LoopView]:
        return (self[k] for k in range(len(self)))


def boundary_loops(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[BoundaryOptions]) -> Boundary:
    """Finds the boundary loops of a mesh: chains of edges with one face each. The surface is on their left.

    Args:
        mesh: a :class:`Mesh`, points and faces, or a mesh of another library.
        threads: number of threads; 0: one for each core. Results do not depend on it.
        progress: receives the fraction done and the stage. An exception in it cancels the call.
        options: see :class:`~gusset_mesh.BoundaryOptions`.

    Raises:
        InputError: the mesh is bad; ``element`` and ``index`` name the element at fault.

    >>> square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]]
    >>> [loop.vertices.tolist() for loop in boundary_loops(square)]
    [[0, 1, 2, 3]]
    """
    return Boundary(_create("boundary", [as_mesh(mesh)], structs("boundary_options", options), threads=threads, progress=progress))


class Check(Reported[CheckView]):
    """Properties of a mesh; ``report`` has the elements at fault."""

    REPORT = CheckView

    @property
    def is_manifold(self) -> bool:
        """Every edge has at most two faces, and every vertex one fan."""
        return "manifold" in self.report.properties

    @property
    def is_oriented(self) -> bool:
        """Neighbouring faces agree in orientation."""
        return "oriented" in self.report.properties

    @property
    def is_closed(self) -> bool:
        """Every edge has two faces."""
        return "closed" in self.report.properties

    def __repr__(self) -> str:
        said = [word for word, holds in (("manifold", self.is_manifold), ("oriented", self.is_oriented), ("closed", self.is_closed)) if holds]
        return f"<Check: {', '.join(said) or 'none of manifold, oriented, closed'}>"


def check(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None) -> Check:
    """Checks whether a mesh is manifold, oriented and closed, and finds its defects.

    >>> check(([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    <Check: manifold, oriented>
    """
    return Check(_create("check", [as_mesh(mesh)], threads=threads, progress=progress))


class Weld(Result[WeldReport]):
    """A mesh with coincident vertices merged."""

    REPORT = WeldReport


def weld(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[WeldOptions]) -> Weld:
    """Merges coincident vertices: within ``tolerance``, by default within the rounding of the positions.

    >>> apart = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [3, 4, 5]]
    >>> weld(apart, unused="remove").mesh.vertex_count
    4
    """
    return Weld(_result("weld", [as_mesh(mesh)], structs("weld_options", options), threads=threads, progress=progress))


class Sew(Result[SewReport]):
    """A mesh with coincident borders sewn; edges are split where vertices do not match."""

    REPORT = SewReport


def sew(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[WeldOptions]) -> Sew:
    """Sews coincident borders. Edges are split where vertices do not match.

    >>> long = [[0, 0, 0], [2, 0, 0], [1, 1, 0]], [[0, 1, 2]]
    >>> short = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [1, -1, 0]], [[1, 0, 3], [2, 1, 3]]
    >>> both = long[0] + short[0], long[1] + [[v + 3 for v in face] for face in short[1]]
    >>> sew(both, unused="remove").report.splits
    1
    """
    return Sew(_result("sew", [as_mesh(mesh)], structs("weld_options", options), threads=threads, progress=progress))


class Repair(Result[RepairReport]):
    """A mesh without its defects; ``report`` lists the changes and the remaining defects."""

    REPORT = RepairReport


def repair(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[RepairOptions]) -> Repair:
    """Removes the defects of a mesh, to get a valid solid where possible. Changes only faces at defects.

    >>> points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> done = repair((points, [[0, 2, 1], [0, 1, 3], [0, 1, 3], [0, 3, 2]]))
    >>> done.report.valid, done.report.filled_holes, done.report.dropped_faces.tolist()
    (True, 1, [2])
    """
    return Repair(_result("repair", [as_mesh(mesh)], structs("repair_options", options), threads=threads, progress=progress))


class Unite(Result[RepairReport]):
    """The union of closed meshes. ``report`` numbers their vertices and faces mesh after mesh."""

    REPORT = RepairReport


def unite(pieces: Sequence[MeshLike], *, threads: int = 0, progress: Optional[Progress] = None) -> Unite:
    """Replaces closed meshes by their union, without intersecting faces.

    >>> faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    >>> small = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> large = [[2 * x - 0.2, 2 * y - 0.2, 2 * z - 0.2] for x, y, z in small]
    >>> done = unite([(small, faces), (large, faces)])
    >>> done.report.valid, done.report.dropped_faces.tolist()
    (True, [0, 1, 2, 3])
    """
    given = of_one_precision(pieces)
    return Unite(_result("unite", given, len(given), threads=threads, progress=progress))


class Orient(Result[OrientReport]):
    """A mesh whose faces agree in orientation within each component."""

    REPORT = OrientReport


def orient(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[OrientOptions]) -> Orient:
    """Reverses faces until neighbours agree in orientation. With ``outward="closed"`` closed components face outwards.

    >>> orient(([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 3, 2]])).report.turned_faces
    1
    """
    return Orient(_result("orient", [as_mesh(mesh)], structs("orient_options", options), threads=threads, progress=progress))


class Triangulation(Result[Any]):
    """A mesh whose faces were split into triangles. It has no report."""


def triangulate(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None) -> Triangulation:
    """Splits faces into triangles of their own corners. Concave faces keep their area.

    >>> dart = [[0, 0, 0], [2, -1, 0], [1, 0, 0], [2, 1, 0]]
    >>> triangulate((dart, [[1, 2, 3, 0]])).mesh.face_count
    2
    """
    return Triangulation(_result("triangulate", [as_mesh(mesh)], threads=threads, progress=progress))


def _loops(loops: Iterable[Any]) -> Any:
    """Converts loops: each is a list of vertices, or from :func:`boundary_loops`."""
    given = [loop.vertices if isinstance(loop, LoopView) else loop for loop in loops]
    for place, loop in enumerate(given):
        if np.ndim(loop) != 1 or np.size(loop) == 0:
            raise ValueError(f"loop {place} has the shape {np.shape(loop)}, not (n,): a loop is a list of vertices")
    arrays = [indices_of(loop, "a loop's vertices") for loop in given]
    # The array is never NULL, which would select all loops.
    return holding(ffi.new("struct gusset_indices[]", [indices_struct(array) for array in arrays] or 1), arrays)


class Stitch(Result[StitchReport]):
    """A mesh of two rims and the strip between them."""

    REPORT = StitchReport

    @cached_property
    def strip(self) -> Mesh:
        """The strip without the pieces."""
        return self._lent_mesh(lib.gusset_result_get_strip_mesh)

    @cached_property
    def quality(self) -> QualityReport:
        """Quality of the strip and of the result."""
        return QualityReport.read(self._handle)


def stitch(
    a: MeshLike, b: Optional[MeshLike] = None, *, loop_a: Optional[ArrayLike] = None, loop_b: Optional[ArrayLike] = None, threads: int = 0,
    progress: Optional[Progress] = None, **options: Unpack[StitchOptions]
) -> Stitch:
    """Joins two boundary loops by a strip of faces, or by a blend that continues both surfaces smoothly (``finish="blend"``).

    Args:
        a: the first mesh.
        b: the second mesh, or None to join two loops of the first.
        loop_a: vertices of the first loop; None: the only loop of ``a``, or the nearest pair.
        loop_b: vertices of the second loop; None: as for ``loop_a``.
        threads, progress: as for :func:`boundary_loops`.
        options: see :class:`~gusset_mesh.StitchOptions`.

    >>> square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [.5, .5, -1]], [[0, 4, 1], [1, 4, 2], [2, 4, 3], [3, 4, 0]]
    >>> above = [[x, y, 2 - z] for x, y, z in square[0]], [face[::-1] for face in square[1]]
    >>> joined = stitch(square, above, outward="closed")
    >>> joined.mesh.face_count, check(joined.mesh).is_closed
    (16, True)
    """
    of = [ffi.NULL if loop is None else _loops([loop]) for loop in (loop_a, loop_b)]
    meshes = of_one_precision([a] if b is None else [a, b])
    views = [view_of(mesh) for mesh in meshes]
    return Stitch(result("stitch", views[0], of[0], views[1] if b is not None else ffi.NULL, of[1], structs("stitch_options", options),
                           threads=threads, progress=progress))


class Fill(Result[FillReport]):
    """A mesh with filled holes."""

    REPORT = FillReport

    @property
    def holes(self) -> HoleArray:
        """The outcome for each loop."""
        return self.report.holes

    @cached_property
    def quality(self) -> QualityReport:
        """Quality of the new faces and of the result."""
        return QualityReport.read(self._handle)


def fill(
    mesh: MeshLike, loops: Optional[Iterable[Any]] = None, *, threads: int = 0, progress: Optional[Progress] = None,
    **options: Unpack[FillOptions]
) -> Fill:
    """Fills holes: all loops, or the given ones.

    ``refine="rim_density", fairing="thin_plate"`` makes patches as fine as their rims, which continue the surface around them.

    >>> cone = [[0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]]
    >>> check(fill(cone).mesh).is_closed
    True
    """
    listed = None if loops is None else list(loops)
    given = _loops(listed) if listed is not None else ffi.NULL
    return Fill(_result("fill", [as_mesh(mesh)], given, len(listed or ()), structs("fill_options", options, {"loop_count": len(listed or ())}),
                         threads=threads, progress=progress))


class Join(Result[JoinReport]):
    """One mesh of several pieces."""

    REPORT = JoinReport

    @property
    def joints(self) -> list[Joint]:
        """Pairs of loops that face each other, with the outcome for each."""
        return self.report.joints


def join(
    pieces: Sequence[MeshLike], *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[JoinOptions]
) -> Join:
    """Makes one mesh of pieces: sews coincident borders, and joins borders that face each other by strips.

    ``fill=True`` fills the remaining holes. ``overlaps="trim"`` keeps one surface where pieces overlap, as scans do.

    Args:
        pieces: meshes: each a :class:`Mesh`, points and faces, or a mesh of another library.
        threads, progress: as for :func:`boundary_loops`.
        options: see :class:`~gusset_mesh.JoinOptions`.

    >>> left = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]], [[0, 1, 4, 3], [1, 2, 5, 4]]
    >>> right = [[x + 2, y, z] for x, y, z in left[0]], left[1]
    >>> join([left, right]).report.welded_vertices
    2
    """
    given = of_one_precision(pieces)
    return Join(_result("join", given, len(given), structs("join_options", options), threads=threads, progress=progress))


class Alignment(Reported[AlignmentView]):
    """Rigid motions after which pieces fit together."""

    REPORT = AlignmentView

    @cached_property
    def poses(self) -> NDArray[np.float64]:
        """(pieces, 4, 4): the motion of each piece, as a matrix that multiplies points from the left."""
        made = np.zeros((len(self.report.pieces), 4, 4))
        made[:, :3], made[:, 3, 3] = self.report.pieces.pose.rows, 1
        return made

    def moved(self, pieces: Sequence[MeshLike]) -> list[Mesh]:
        """Moves the pieces to their poses."""
        out = []
        if len(pieces) != len(self.poses):
            raise ValueError(f"{len(pieces)} pieces for {len(self.poses)} poses: pass the aligned pieces")
        for pose, mesh in zip(self.poses, map(as_mesh, pieces)):
            out.append(mesh.with_points(mesh.points @ pose[:3, :3].T + pose[:3, 3]))
        return out


def align(pieces: Sequence[MeshLike], *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[AlignmentOptions]) -> Alignment:
    """Finds the rigid motions after which the overlaps of pieces fit. The first piece stays."""
    given = of_one_precision(pieces)
    return Alignment(_create("alignment", given, len(given), structs("alignment_options", options), threads=threads, progress=progress))


class Trim(Reported[TrimView]):
    """The faces of overlapping pieces that stay; see ``report``."""

    REPORT = TrimView


def trim(pieces: Sequence[MeshLike], *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[TrimOptions]) -> Trim:
    """Keeps one surface where pieces overlap. ``report`` has the faces of each piece that stay."""
    given = of_one_precision(pieces)
    return Trim(_create("trim", given, len(given), structs("trim_options", options), threads=threads, progress=progress))


class Development(Result[DevelopReport]):
    """A surface laid out in the plane."""

    REPORT = DevelopReport

    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 2): positions of the vertices in the plane."""
        return self.report.points


def develop(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[DevelopOptions]) -> Development:
    """Lays a surface out in the plane, cut along ``cuts``: exactly where it unfolds, else with the least distortion.

    >>> roof = [[0, 0, 0], [0, 2, 0], [1, 0, 1], [1, 2, 1], [2, 0, 0], [2, 2, 0]], [[0, 2, 3, 1], [2, 4, 5, 3]]
    >>> float(develop(roof).report.stretches.max().round(9))
    1.0
    """
    return Development(_result("develop", [as_mesh(mesh)], structs("develop_options", options), threads=threads, progress=progress))
