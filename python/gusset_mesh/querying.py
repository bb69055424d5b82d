"""Queries of smooth surfaces: distances, local minima, first hits, cells near a point or another surface."""

from __future__ import annotations

from typing import NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import pointer, real
from ._call import Progress, call
from ._exchange import answer, handle_of, lines_of, sized, vector
from ._handles import Reported, create
from ._keywords import options as structs
from ._library import ffi, lib
from ._options import NearestOptions, Unpack
from ._reports import (DistanceReport, NearestAngleReport, SurfaceCellArray, SurfaceCellsView, SurfaceHitArray, SurfaceNearestPointArray,
                       SurfacePointsView, SurfaceReport)
from .outline import Curve

__all__ = ["Line", "Plane", "SurfaceCells", "SurfacePoints"]


class Line(NamedTuple):
    """The points ``origin + t * direction`` for t from ``start`` to ``end``: a line, ray or segment."""

    origin: ArrayLike
    direction: ArrayLike
    start: float = -np.inf
    end: float = np.inf


class Plane(NamedTuple):
    """The plane through a point with a normal."""

    point: ArrayLike
    normal: ArrayLike


class SurfacePoints(Reported[SurfacePointsView]):
    """Points of a surface, nearest first."""

    REPORT = SurfacePointsView

    @property
    def points(self) -> SurfaceNearestPointArray:
        """The points."""
        return self.report.points

    def __len__(self) -> int:
        return len(self.report.points)


class SurfaceCells(Reported[SurfaceCellsView]):
    """Cells of a surface, or pairs of cells of two: ``report.others`` has the second cells."""

    REPORT = SurfaceCellsView

    @property
    def cells(self) -> SurfaceCellArray:
        """The cells, sorted."""
        return self.report.cells

    def __len__(self) -> int:
        return len(self.report.cells)


class SurfaceQueries(Reported[SurfaceReport]):
    """The part of :class:`Surface` that measures distances and finds cells."""

    REPORT = SurfaceReport

    def distance(
        self, target: Union[Line, Plane, Curve, SurfaceQueries], tolerance: float = 0.0, *, threads: int = 0, progress: Optional[Progress] = None
    ) -> DistanceReport:
        """Finds the nearest points of the surface and a line, a plane, a curve or another surface.

        Args:
            target: a :class:`~gusset_mesh.Line`, :class:`~gusset_mesh.Plane`, :class:`~gusset_mesh.Curve` or :class:`~gusset_mesh.Surface`.
            tolerance: length to which the distance is proved; 0: the tolerance of the surface.

        Returns:
            a report: ``point``, ``other_point``, ``distance``, ``bound`` and more.

        >>> import numpy as np, gusset_mesh as gm
        >>> u, v = np.meshgrid(np.linspace(0, 1, 8), np.linspace(0, 1, 8), indexing="ij")
        >>> gm.Surface(np.stack([u, v, 0 * u], axis=2)).distance(gm.Plane([0, 0, 3], [0, 0, 1])).distance
        3.0
        """
        given = sized("gusset_target")
        if isinstance(target, Line):
            given.kind = lib.GUSSET_TARGET_LINE
            given.line.origin, given.line.direction = vector(target.origin, "origin"), vector(target.direction, "direction")
            setattr(given.line, "from", real(target.start))
            given.line.to = real(target.end)
        elif isinstance(target, Plane):
            given.kind, given.point, given.normal = lib.GUSSET_TARGET_PLANE, vector(target.point, "point"), vector(target.normal, "normal")
        elif isinstance(target, Curve):
            given.kind, given.curve = lib.GUSSET_TARGET_CURVE, target._handle
        elif isinstance(target, SurfaceQueries):
            given.kind, given.surface = lib.GUSSET_TARGET_SURFACE, target._handle
        else:
            raise TypeError(f"distances are measured to a Line, Plane, Curve or Surface, not to a {type(target).__name__}")
        return answer(DistanceReport, lib.gusset_surface_distance, self._handle, given, real(tolerance), threads=threads, progress=progress)

    def minima(
        self, query: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[NearestOptions]
    ) -> SurfacePoints:
        """Finds the local minima of the distance from a query, nearest first. No minimum is missed.

        >>> import numpy as np, gusset_mesh as gm
        >>> u, v = np.meshgrid(np.linspace(0, 6, 41), np.linspace(0, 1, 8), indexing="ij")
        >>> len(gm.Surface(np.stack([u, v, np.cos(2 * np.pi * u / 3)], axis=2)).minima([3, 0.5, -9]))
        2
        """
        given = structs("nearest_options", options)
        return SurfacePoints(create("surface_points", self._handle, vector(query, "query"), given, name="surface_minima", threads=threads,
                                    progress=progress))

    def first_hits(
        self, origins: ArrayLike, directions: ArrayLike, *, start: float = 0.0, end: float = np.inf, threads: int = 0,
        progress: Optional[Progress] = None,
    ) -> SurfaceHitArray:
        """Finds the first hit of each ray. Without a hit, ``kind`` is ``"none"``.

        >>> import numpy as np, gusset_mesh as gm
        >>> u, v = np.meshgrid(np.linspace(0, 1, 8), np.linspace(0, 1, 8), indexing="ij")
        >>> hits = gm.Surface(np.stack([u, v, 0 * u], axis=2)).first_hits([[0.5, 0.5, 2], [5, 5, 2]], [0, 0, -1])
        >>> hits.t.tolist(), hits.kind.tolist()
        ([2.0, 0.0], ['crossing', 'none'])
        """
        lines = lines_of(origins, directions, start, end)
        out = SurfaceHitArray.zeros(len(lines))
        call(lib.gusset_surface_first_hits, self._handle, ffi.cast("struct gusset_line *", pointer(lines)), len(lines),
             out.pointer(), threads=threads, progress=progress)
        return out

    def nearest_angle(
        self, direction: ArrayLike, angle: float, *, unsigned_normals: bool = False, threads: int = 0, progress: Optional[Progress] = None
    ) -> NearestAngleReport:
        """Finds the normal whose angle with a direction is nearest to a given angle."""
        return answer(NearestAngleReport, lib.gusset_surface_nearest_angle, self._handle, vector(direction, "direction"), real(angle),
                      int(bool(unsigned_normals)), threads=threads, progress=progress)

    def region(self, query: ArrayLike, radius: float, *, threads: int = 0, progress: Optional[Progress] = None) -> SurfaceCells:
        """Finds the cells that have a point within a radius of a query. No cell is missed."""
        return SurfaceCells(create("surface_cells", self._handle, vector(query, "query"), real(radius), name="surface_region", threads=threads,
                                   progress=progress))

    def cell_pairs(
        self, other: SurfaceQueries, within: float = 0.0, *, threads: int = 0, progress: Optional[Progress] = None
    ) -> SurfaceCells:
        """Finds the pairs of cells of two surfaces that may be within a distance of each other. No pair is missed."""
        return SurfaceCells(create("surface_cells", self._handle, handle_of("surface", other), real(within), name="surface_cell_pairs",
                                   threads=threads, progress=progress))
