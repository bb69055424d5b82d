"""Meshes that come in pieces: their borders, and what joins, mends and checks them."""

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
from ._options import (AlignmentOptions, BoundaryOptions, DevelopOptions, FillOptions, JoinOptions, OrientOptions, StitchOptions, TrimOptions,
                       Unpack, WeldOptions)
from ._records import indices_struct
from ._reports import (AlignmentView, BoundaryView, CheckView, DevelopReport, FillReport, HoleArray, JoinReport, Joint, LoopView, OrientReport,
                       QualityReport, SewReport, StitchReport, TrimView, WeldReport)
from .mesh import Mesh, MeshLike, as_mesh, of_one_precision, view_of, views_of

__all__ = ["Alignment", "Boundary", "Check", "Development", "Fill", "Join", "Orient", "Sew", "Stitch", "Trim", "Weld",
           "align", "boundary_loops", "check", "develop", "fill", "join", "orient", "sew", "stitch", "trim", "weld"]


def _create(kind: str, meshes: Sequence[Mesh], *arguments: Any, threads: int = 0, progress: Optional[Progress] = None) -> Any:
    """What is made of meshes, by a call of which they are the first arguments."""
    return create(kind, views_of(meshes), *arguments, threads=threads, progress=progress, is_short=kind in _QUICK and _are_small(meshes))


def _result(function: str, meshes: Sequence[Mesh], *arguments: Any, threads: int = 0, progress: Optional[Progress] = None) -> Any:
    """The same, of a mesh that is made of meshes."""
    return result(function, views_of(meshes), *arguments, threads=threads, progress=progress, is_short=function in _QUICK and _are_small(meshes))


#: What takes time in proportion to the mesh: of a small one it ends before anybody could want to stop it.
_QUICK = {"boundary", "check", "weld", "sew", "orient"}


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
    """The loops of edges that have one face each, with the surface on their left.

    Args:
        mesh: a :class:`Mesh`, points and faces, or a mesh of another library.
        threads: 0 for as many as there are cores; results do not depend on it.
        progress: called with the part done and what is being done; what it raises cancels, as Ctrl-C does.
        options: see :class:`~gusset_mesh.BoundaryOptions`.

    Raises:
        InputError: the mesh cannot be used; ``element`` and ``index`` say what is wrong.

    >>> square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]]
    >>> [loop.vertices.tolist() for loop in boundary_loops(square)]
    [[0, 1, 2, 3]]
    """
    return Boundary(_create("boundary", [as_mesh(mesh)], structs("boundary_options", options), threads=threads, progress=progress))


class Check(Reported[CheckView]):
    """What a mesh is; ``report`` has the elements at fault."""

    REPORT = CheckView

    @property
    def is_manifold(self) -> bool:
        """No edge has three faces or more, and no vertex several fans."""
        return "manifold" in self.report.properties

    @property
    def is_oriented(self) -> bool:
        """Neighbouring faces run the same way."""
        return "oriented" in self.report.properties

    @property
    def is_closed(self) -> bool:
        """Every edge has two faces."""
        return "closed" in self.report.properties

    def __repr__(self) -> str:
        said = [word for word, holds in (("manifold", self.is_manifold), ("oriented", self.is_oriented), ("closed", self.is_closed)) if holds]
        return f"<Check: {', '.join(said) or 'none of manifold, oriented, closed'}>"


def check(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None) -> Check:
    """Whether a mesh is manifold, oriented and closed, and where it is not.

    >>> check(([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    <Check: manifold, oriented>
    """
    return Check(_create("check", [as_mesh(mesh)], threads=threads, progress=progress))


class Weld(Result[WeldReport]):
    """A mesh whose vertices that lay together are one."""

    REPORT = WeldReport


def weld(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[WeldOptions]) -> Weld:
    """Makes vertices that lie together one; ``tolerance=0.1`` says how near, else no farther than rounding can have put them.

    >>> apart = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [3, 4, 5]]
    >>> weld(apart, unused="remove").mesh.vertex_count
    4
    """
    return Weld(_result("weld", [as_mesh(mesh)], structs("weld_options", options), threads=threads, progress=progress))


class Sew(Result[SewReport]):
    """A mesh whose borders that lay together are joined, edges split where they had to be."""

    REPORT = SewReport


def sew(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[WeldOptions]) -> Sew:
    """Joins borders that lie together although their vertices do not match: edges are split.

    >>> long = [[0, 0, 0], [2, 0, 0], [1, 1, 0]], [[0, 1, 2]]
    >>> short = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [1, -1, 0]], [[1, 0, 3], [2, 1, 3]]
    >>> both = long[0] + short[0], long[1] + [[v + 3 for v in face] for face in short[1]]
    >>> sew(both, unused="remove").report.splits
    1
    """
    return Sew(_result("sew", [as_mesh(mesh)], structs("weld_options", options), threads=threads, progress=progress))


class Orient(Result[OrientReport]):
    """A mesh whose faces run the same way within each component."""

    REPORT = OrientReport


def orient(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[OrientOptions]) -> Orient:
    """Turns over faces so that neighbours run the same way; ``outward="closed"``: closed components face outwards.

    >>> orient(([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 3, 2]])).report.turned_faces
    1
    """
    return Orient(_result("orient", [as_mesh(mesh)], structs("orient_options", options), threads=threads, progress=progress))


def _loops(loops: Iterable[Any]) -> Any:
    """Loops by their vertices, or as :func:`boundary_loops` gives them."""
    given = [loop.vertices if isinstance(loop, LoopView) else loop for loop in loops]
    if any(np.ndim(loop) != 1 or np.size(loop) == 0 for loop in given):
        raise ValueError("a loop is a list of vertices")
    arrays = [indices_of(loop, "a loop's vertices") for loop in given]
    # NULL would be all loops that there are.
    return holding(ffi.new("struct gusset_indices[]", [indices_struct(array) for array in arrays] or 1), arrays)


class Stitch(Result[StitchReport]):
    """Two rims and what joins them."""

    REPORT = StitchReport

    @cached_property
    def strip(self) -> Mesh:
        """The strip alone."""
        return self._lent_mesh(lib.gusset_result_get_strip_mesh)

    @cached_property
    def quality(self) -> QualityReport:
        """Measures of the strip and of the result."""
        return QualityReport.read(self._handle)


def stitch(
    a: MeshLike, b: Optional[MeshLike] = None, *, loop_a: Optional[ArrayLike] = None, loop_b: Optional[ArrayLike] = None, threads: int = 0,
    progress: Optional[Progress] = None, **options: Unpack[StitchOptions]
) -> Stitch:
    """Joins two boundary loops by a strip of faces, or by a blend that goes on both surfaces smoothly (``finish="blend"``).

    Args:
        a: the first mesh.
        b: the second one, or None for two loops of the first.
        loop_a: the vertices of the first loop; None: the only loop of ``a``, or the nearest ones.
        loop_b: those of the second.
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
    """A mesh whose holes are filled."""

    REPORT = FillReport

    @property
    def holes(self) -> HoleArray:
        """What became of each loop."""
        return self.report.holes

    @cached_property
    def quality(self) -> QualityReport:
        """Measures of the new faces and of the result."""
        return QualityReport.read(self._handle)


def fill(
    mesh: MeshLike, loops: Optional[Iterable[Any]] = None, *, threads: int = 0, progress: Optional[Progress] = None,
    **options: Unpack[FillOptions]
) -> Fill:
    """Fills holes: all loops, or those given by their vertices.

    ``refine="rim_density", fairing="thin_plate"`` makes patches as fine as their rims that go on the surface round them.

    >>> cone = [[0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]]
    >>> check(fill(cone).mesh).is_closed
    True
    """
    listed = None if loops is None else list(loops)
    given = _loops(listed) if listed is not None else ffi.NULL
    return Fill(_result("fill", [as_mesh(mesh)], given, len(listed or ()), structs("fill_options", options, {"loop_count": len(listed or ())}),
                         threads=threads, progress=progress))


class Join(Result[JoinReport]):
    """Many pieces in one mesh."""

    REPORT = JoinReport

    @property
    def joints(self) -> list[Joint]:
        """The pairs of loops that face each other, and what became of them."""
        return self.report.joints


def join(
    pieces: Sequence[MeshLike], *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[JoinOptions]
) -> Join:
    """Joins many pieces: borders that lie together are welded, those that face each other joined by strips.

    ``fill=True`` fills what holes are left; ``overlaps="trim"`` keeps one of surfaces that lie on one another, as scans do.

    >>> left = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]], [[0, 1, 4, 3], [1, 2, 5, 4]]
    >>> right = [[x + 2, y, z] for x, y, z in left[0]], left[1]
    >>> join([left, right]).report.welded_vertices
    2
    """
    given = of_one_precision(pieces)
    return Join(_result("join", given, len(given), structs("join_options", options), threads=threads, progress=progress))


class Alignment(Reported[AlignmentView]):
    """Motions that bring pieces onto one another."""

    REPORT = AlignmentView

    @cached_property
    def poses(self) -> NDArray[np.float64]:
        """(pieces, 4, 4): what moves each piece, as a matrix that points are multiplied by from the left."""
        made = np.zeros((len(self.report.pieces), 4, 4))
        made[:, :3], made[:, 3, 3] = self.report.pieces.pose.rows, 1
        return made

    def moved(self, pieces: Sequence[MeshLike]) -> list[Mesh]:
        """The pieces where they belong."""
        out = []
        if len(pieces) != len(self.poses):
            raise ValueError(f"{len(pieces)} pieces for {len(self.poses)} poses")
        for pose, mesh in zip(self.poses, map(as_mesh, pieces)):
            out.append(mesh.with_points(mesh.points @ pose[:3, :3].T + pose[:3, 3]))
        return out


def align(pieces: Sequence[MeshLike], *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[AlignmentOptions]) -> Alignment:
    """Turns and shifts pieces so that their overlaps fit; the first one stays."""
    given = of_one_precision(pieces)
    return Alignment(_create("alignment", given, len(given), structs("alignment_options", options), threads=threads, progress=progress))


class Trim(Reported[TrimView]):
    """Which faces of overlapping pieces stay."""

    REPORT = TrimView


def trim(pieces: Sequence[MeshLike], *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[TrimOptions]) -> Trim:
    """Of surfaces that lie on one another one stays: which faces of each piece do is in ``report``."""
    given = of_one_precision(pieces)
    return Trim(_create("trim", given, len(given), structs("trim_options", options), threads=threads, progress=progress))


class Development(Result[DevelopReport]):
    """A surface laid out flat."""

    REPORT = DevelopReport

    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 2): the vertices in the plane."""
        return self.report.points


def develop(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[DevelopOptions]) -> Development:
    """Lays a surface out flat: cut along ``cuts``, unfolded where it can be, else with the least distortion.

    >>> roof = [[0, 0, 0], [0, 2, 0], [1, 0, 1], [1, 2, 1], [2, 0, 0], [2, 2, 0]], [[0, 2, 3, 1], [2, 4, 5, 3]]
    >>> float(develop(roof).report.stretches.max().round(9))
    1.0
    """
    return Development(_result("develop", [as_mesh(mesh)], structs("develop_options", options), threads=threads, progress=progress))
