"""Smooth surfaces through nodes: nearest points, sections and intersections, with proven bounds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Optional, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import floats_of, pointer, reals_of
from ._call import Progress, call
from ._exchange import LINE, handle_of, lines_of, vector
from ._handles import Reported, Result, create, result
from ._keywords import options as structs
from ._library import ffi, holding, lib, number_of
from ._options import ContourOptions, IntersectionOptions, NearestOptions, SheetMeshOptions, SurfaceOptions, Unpack
from ._reports import (SheetMeshReport, SurfaceHitArray, SurfaceHitsView, SurfaceNearestPointArray, SurfacePathsView, SurfacePlaceArray,
                       SurfacePointArray)
from .choices import HitSelection, Scheme
from .outline import Curve
from .querying import SurfaceQueries
from .sheets import GivenTwists, SheetMaking, tangents_of

__all__ = ["Sheet", "SheetMesh", "Surface", "SurfaceHits", "SurfacePaths"]


class SheetMesh(Result[SheetMeshReport]):
    """The mesh of a sheet; ``report.deviation`` bounds its distance from the sheet."""

    REPORT = SheetMeshReport


class Sheet(SheetMaking):
    """A smooth surface through a grid of nodes.

    Args:
        nodes: (rows, columns, 3), 32- or 64-bit floats.
        tangents: tangents at the nodes, two arrays like the nodes: towards the next row, and towards the next column. Without them the scheme
            applies.
        twists: rule for the mixed derivatives of a surface with tangents, or an array of them like the nodes.
        closed_u: whether the surface is closed from the last row to the first. The last row repeats the first.
        closed_v: the same for columns.
        scheme: interpolation between the nodes.
    """

    def __init__(
        self, nodes: ArrayLike, tangents: Optional[tuple[ArrayLike, ArrayLike]] = None, *, twists: GivenTwists = "differences",
        closed_u: bool = False, closed_v: bool = False, scheme: Scheme = "six_tap",
    ):
        array = floats_of(nodes)
        if array.ndim != 3 or array.shape[2] != 3:
            raise ValueError(f"nodes have the shape {array.shape}, not (rows, columns, 3)")
        across = 3 * array.itemsize
        if array.size and (array.strides[2] != array.itemsize or array.strides[1] < across or array.strides[0] < array.shape[1] * array.strides[1]):
            array = np.ascontiguousarray(array)
        given = ffi.new("struct gusset_nodes *")
        given.struct_size = ffi.sizeof("struct gusset_nodes")
        given.nodes, given.rows, given.columns = pointer(array), array.shape[0], array.shape[1]
        if array.size:
            given.row_stride, given.column_stride = array.strides[:2]
        given.scalar = lib.GUSSET_F32 if array.dtype == np.float32 else lib.GUSSET_F64
        given.scheme, given.closed_u, given.closed_v = number_of("gusset_scheme", "scheme", scheme), int(closed_u), int(closed_v)
        super().__init__(create("sheet", given, tangents_of(tangents, twists, array.shape), 0))

    def mesh(self, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[SheetMeshOptions]) -> SheetMesh:
        """Makes a mesh within ``tolerance``, with at least ``min_u`` times ``min_v`` parts of each cell."""
        return SheetMesh(result("sheet_to_mesh", self._handle, structs("sheet_mesh_options", options), threads=threads, progress=progress))


class SurfacePaths(Reported[SurfacePathsView], Sequence[NDArray[np.float64]]):
    """Curves on a surface: each is (n, 3); ``report`` has normals, places and unresolved cells."""

    REPORT = SurfacePathsView

    def __len__(self) -> int:
        return len(self.report.levels)

    @overload
    def __getitem__(self, index: int) -> NDArray[np.float64]: ...

    @overload
    def __getitem__(self, index: slice) -> list[NDArray[np.float64]]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[NDArray[np.float64], list[NDArray[np.float64]]]:
        places = range(len(self))[index]
        if isinstance(places, range):
            return [self[k] for k in places]
        start, end = self.report.ends[places:places + 2]
        return self.report.points[start:end]

    @property
    def closed(self) -> NDArray[np.bool_]:
        """Whether each curve continues to its first point."""
        return self.report.closed

    @property
    def levels(self) -> NDArray[np.uint32]:
        """The number of the plane of each curve."""
        return self.report.levels


class SurfaceHits(Reported[SurfaceHitsView]):
    """Where lines meet a surface: line k has ``hits[ends[k]:ends[k + 1]]``."""

    REPORT = SurfaceHitsView

    @property
    def hits(self) -> SurfaceHitArray:
        """The hits of all lines."""
        return self.report.hits

    @property
    def ends(self) -> NDArray[np.uint64]:
        """Where the hits of each line begin, and the end of the last."""
        return self.report.ends


class Surface(SurfaceQueries):
    """One or several sheets, with an index for queries.

    Args:
        sheets: a :class:`Sheet`, several sheets, or the nodes (rows, columns, 3) of one.
        options: see :class:`~gusset_mesh.SurfaceOptions`.

    >>> import numpy as np
    >>> u, v = np.meshgrid(np.linspace(0, 3, 16), np.linspace(0, 3, 16), indexing="ij")
    >>> waves = Surface(np.stack([u, v, np.sin(u) * np.cos(v)], axis=2))
    >>> found = waves.nearest([[1, 1, 5]])
    >>> bool(found.bound[0] <= found.distance[0])
    True
    >>> curves = waves.section([0, 0, 0.2], [0, 0, 1])
    >>> bool(np.allclose(curves[0][:, 2], 0.2))
    True
    """

    def __init__(
        self, sheets: Union[Sheet, Sequence[Sheet], ArrayLike], *, threads: int = 0, progress: Optional[Progress] = None,
        **options: Unpack[SurfaceOptions]
    ):
        if isinstance(sheets, Sheet):
            sheets = [sheets]
        elif not (isinstance(sheets, (list, tuple)) and all(isinstance(one, Sheet) for one in sheets)):
            sheets = [Sheet(sheets)]  # type: ignore[arg-type]
        self.sheets: list[Sheet] = list(sheets)
        handles = ffi.new("struct gusset_sheet *[]", [one._handle for one in self.sheets])
        super().__init__(create("surface", handles, len(self.sheets), structs("surface_options", options), threads=threads, progress=progress))

    def nearest(
        self, points: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[NearestOptions]
    ) -> SurfaceNearestPointArray:
        """Finds the nearest point of the surface for each of (n, 3) points. No point of the surface is nearer than ``bound``."""
        queries = np.ascontiguousarray(reals_of(points))
        if queries.ndim != 2 or queries.shape[1] != 3:
            raise ValueError(f"points have the shape {queries.shape}, not (n, 3)")
        out = SurfaceNearestPointArray.zeros(len(queries))
        call(lib.gusset_surface_nearest, self._handle, ffi.cast("double *", pointer(queries)), len(queries),
             structs("nearest_options", options), out.pointer(), threads=threads, progress=progress)
        return out

    def section(
        self, point: ArrayLike, normal: ArrayLike, offsets: ArrayLike = (0.0,), *, threads: int = 0, progress: Optional[Progress] = None,
        **options: Unpack[ContourOptions]
    ) -> SurfacePaths:
        """Intersects the surface with parallel planes: through ``point``, at increasing ``offsets`` along ``normal``."""
        height = {"kind": lib.GUSSET_CONTOUR_HEIGHT, "point": vector(point), "direction": vector(normal)}
        return self._contours(height, offsets, options, threads, progress)

    def contours(
        self, values: ArrayLike, levels: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None,
        **options: Unpack[ContourOptions]
    ) -> SurfacePaths:
        """Draws the curves where a function has increasing levels.

        Args:
            values: the function at the corners of all cells, sheet by sheet, row by row.
        """
        given = np.ascontiguousarray(reals_of(values)).reshape(-1)
        numbers = holding(ffi.cast("double *", pointer(given)), given)
        function = {"kind": lib.GUSSET_CONTOUR_VALUES, "values": numbers, "value_count": given.size}
        return self._contours(function, levels, options, threads, progress)

    def isophotes(
        self, direction: ArrayLike, angles: ArrayLike = (np.pi / 2,), *, unsigned_normals: bool = False, threads: int = 0,
        progress: Optional[Progress] = None, **options: Unpack[ContourOptions]
    ) -> SurfacePaths:
        """Draws the curves where normals make angles with a direction. A right angle gives the silhouette."""
        angle = {"kind": lib.GUSSET_CONTOUR_ANGLE, "direction": vector(direction), "unsigned_normals": int(unsigned_normals)}
        return self._contours(angle, angles, options, threads, progress)

    def _contours(
        self, function: dict[str, Any], levels: ArrayLike, options: ContourOptions, threads: int, progress: Optional[Progress]
    ) -> SurfacePaths:
        struct = ffi.new("struct gusset_contour_function *", {"struct_size": ffi.sizeof("struct gusset_contour_function"), **function})
        rising = np.ascontiguousarray(reals_of(levels)).reshape(-1)
        at = holding(ffi.cast("double *", pointer(rising)), rising)
        return SurfacePaths(create("surface_paths", self._handle, struct, at, len(rising), structs("contour_options", options),
                                   name="surface_contours", threads=threads, progress=progress))

    def intersect(
        self, other: Optional[Surface] = None, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[IntersectionOptions]
    ) -> SurfacePaths:
        """Intersects two surfaces. Without another surface: finds where this one meets itself."""
        second = ffi.NULL if other is None else handle_of("surface", other)
        return SurfacePaths(create("surface_paths", self._handle, second, structs("intersection_options", options),
                                   name="surface_intersection", threads=threads, progress=progress))

    def hits(
        self, origins: ArrayLike = (), directions: ArrayLike = (), *, curve: Optional[Curve] = None, start: float = 0.0, end: float = np.inf,
        selection: HitSelection = "all", threads: int = 0, progress: Optional[Progress] = None,
    ) -> SurfaceHits:
        """Intersects the surface with the points ``origins + t * directions``, for t from ``start`` to ``end``, and with a curve.

        The hits of the curve come last; ``report.on_curve`` has their places on it.
        """
        lines = lines_of(origins, directions, start, end) if np.size(origins) or np.size(directions) else np.zeros(0, LINE)
        along = ffi.NULL if curve is None else handle_of("curve", curve)
        return SurfaceHits(create("surface_hits", self._handle, ffi.cast("struct gusset_line *", pointer(lines)), len(lines), along,
                                  number_of("gusset_hit_selection", "selection", selection), threads=threads, progress=progress))

    def evaluate(self, parameters: ArrayLike, sheet: int = 0) -> SurfacePointArray:
        """Computes points, derivatives, normals and curvatures at (n, 2) parameters u, v of a sheet. Node (i, j) has u = i, v = j."""
        given = np.ascontiguousarray(reals_of(parameters))
        if given.ndim != 2 or given.shape[1] != 2:
            raise ValueError(f"parameters have the shape {given.shape}, not (n, 2)")
        places, out = SurfacePlaceArray.zeros(len(given)), SurfacePointArray.zeros(len(given))
        call(lib.gusset_surface_locate, self._handle, sheet, ffi.cast("double *", pointer(given)), len(given), places.pointer())
        call(lib.gusset_surface_evaluate, self._handle, places.pointer(), len(given), out.pointer())
        return out
