"""Smooth surfaces through nodes: nearest points, sections, intersections, with proven bounds."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, Literal, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import pointer
from ._call import Progress, call
from ._handles import Handle, MeshResult, create, result
from ._keywords import options as structs
from ._library import ffi, holding, lib, one_of
from ._options import ContourOptions, IntersectionOptions, NearestOptions, SheetMeshOptions, SurfaceOptions, Unpack
from ._records import Record, dtype_of, filled

__all__ = ["Hits", "Paths", "Sheet", "SheetMesh", "Surface"]

_PLACE = dtype_of(ffi.typeof("struct gusset_surface_place"))
_NEAREST = dtype_of(ffi.typeof("struct gusset_surface_nearest_point"))
_POINT = dtype_of(ffi.typeof("struct gusset_surface_point"))
_LINE = dtype_of(ffi.typeof("struct gusset_line"))
_SCHEMES = {"six_tap": 0, "four_point": 1}


def _vector(values: ArrayLike) -> list[float]:
    array = np.asarray(values, np.float64).reshape(-1)
    if array.shape != (3,):
        raise ValueError(f"x, y and z are wanted, not {array.size} numbers")
    numbers: list[float] = array.tolist()
    return numbers


class SheetMesh(MeshResult):
    """Faces on a sheet; ``account.deviation`` bounds how far they are from it."""

    KIND = "sheet_mesh"


class Sheet(Handle):
    """One smooth surface through a grid of nodes.

    Args:
        nodes: (rows, columns, 3), 32- or 64-bit floats.
        closed_u: closed from the last row to the first, which is repeated at the end.
        closed_v: the same of columns.
        scheme: how it is drawn through the nodes.
    """

    KIND = "sheet"

    def __init__(self, nodes: ArrayLike, *, closed_u: bool = False, closed_v: bool = False, scheme: Literal["six_tap", "four_point"] = "six_tap"):
        array = np.asarray(nodes)
        if array.dtype not in (np.float32, np.float64):
            array = array.astype(np.float64)
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
        given.scheme, given.closed_u, given.closed_v = one_of(_SCHEMES, "scheme", scheme), int(closed_u), int(closed_v)
        super().__init__(create("sheet", given, ffi.NULL, 0))

    @property
    def account(self) -> Record:
        """Its cells, what is closed, poles."""
        return filled(lib.gusset_sheet_get_report, "gusset_sheet_report", self._handle)

    def mesh(self, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[SheetMeshOptions]) -> SheetMesh:
        """Faces on it: within ``tolerance``, or in so many parts of each cell."""
        return SheetMesh(result("sheet_to_mesh", self._handle, structs("sheet_mesh_options", options), threads=threads, progress=progress))


class Paths(Handle, Sequence[NDArray[np.float64]]):
    """Curves on surfaces: each is (n, 3); ``account`` has normals, places and what is unresolved."""

    KIND = "surface_paths"

    def __len__(self) -> int:
        return int(self.account.path_count)

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[k] for k in range(*index.indices(len(self)))]
        if not -len(self) <= index < len(self):
            raise IndexError(index)
        ends, k = self.account.ends, index % len(self)
        return self.account.points[ends[k]:ends[k + 1]]

    @property
    def closed(self) -> NDArray[np.bool_]:
        """Of each whether it goes on to its first point."""
        found: NDArray[np.bool_] = self.account.closed != 0
        return found

    @property
    def levels(self) -> NDArray[np.uint32]:
        """Of each the number of its plane."""
        found: NDArray[np.uint32] = self.account.levels
        return found


class Hits(Handle):
    """Where lines meet a surface: those of line k are ``hits[ends[k]:ends[k + 1]]``."""

    KIND = "surface_hits"

    @property
    def hits(self) -> NDArray[Any]:
        found: NDArray[Any] = self.account.hits
        return found

    @property
    def ends(self) -> NDArray[np.uint64]:
        found: NDArray[np.uint64] = self.account.ends
        return found


class Surface(Handle):
    """One or several sheets, ready for questions.

    Args:
        sheets: a :class:`Sheet`, several, or nodes (rows, columns, 3) of one.
        options: see :class:`~gusset_mesh.SurfaceOptions`.

    >>> import numpy as np
    >>> u, v = np.meshgrid(np.linspace(0, 3, 16), np.linspace(0, 3, 16), indexing="ij")
    >>> waves = Surface(np.stack([u, v, np.sin(u) * np.cos(v)], axis=2))
    >>> found = waves.nearest([[1, 1, 5]])
    >>> bool(found["bound"][0] <= found["distance"][0])
    True
    >>> curves = waves.section([0, 0, 0.2], [0, 0, 1])
    >>> bool(np.allclose(curves[0][:, 2], 0.2))
    True
    """

    KIND = "surface"

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

    @cached_property
    def account(self) -> Record:
        """How many cells it has, and the box round it."""
        return filled(lib.gusset_surface_get_report, "gusset_surface_report", self._handle)

    def nearest(
        self, points: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[NearestOptions]
    ) -> NDArray[Any]:
        """Of each of (n, 3) points the nearest one of the surface.

        Returns:
            records of ``place``, ``point``, ``normal``, ``distance``, ``bound`` (no point is nearer than this) and ``flags``.
        """
        queries = np.ascontiguousarray(points, np.float64)
        if queries.ndim != 2 or queries.shape[1] != 3:
            raise ValueError(f"points have the shape {queries.shape}, not (n, 3)")
        out = np.zeros(len(queries), _NEAREST)
        call(lib.gusset_surface_nearest, self._handle, ffi.cast("double *", pointer(queries)), len(queries),
             structs("nearest_options", options), ffi.cast("struct gusset_surface_nearest_point *", pointer(out)), threads=threads, progress=progress)
        return out

    def section(
        self, point: ArrayLike, normal: ArrayLike, offsets: ArrayLike = (0.0,), *, threads: int = 0, progress: Optional[Progress] = None,
        **options: Unpack[ContourOptions]
    ) -> Paths:
        """The curves in which planes cut it: through a point, and at rising distances from it along the normal."""
        height = {"kind": lib.GUSSET_CONTOUR_HEIGHT, "point": _vector(point), "direction": _vector(normal)}
        return self._contours(height, offsets, options, threads, progress)

    def contours(
        self, values: ArrayLike, levels: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None,
        **options: Unpack[ContourOptions]
    ) -> Paths:
        """Where a function takes rising levels: its values are given at the corners of all cells, sheet after sheet, row after row."""
        given = np.ascontiguousarray(values, np.float64).reshape(-1)
        numbers = holding(ffi.cast("double *", pointer(given)), given)
        function = {"kind": lib.GUSSET_CONTOUR_VALUES, "values": numbers, "value_count": given.size}
        return self._contours(function, levels, options, threads, progress)

    def isophotes(
        self, direction: ArrayLike, angles: ArrayLike = (np.pi / 2,), *, unsigned_normals: bool = False, threads: int = 0,
        progress: Optional[Progress] = None, **options: Unpack[ContourOptions]
    ) -> Paths:
        """Where normals make angles with a direction; at a right angle the silhouette."""
        angle = {"kind": lib.GUSSET_CONTOUR_ANGLE, "direction": _vector(direction), "unsigned_normals": int(unsigned_normals)}
        return self._contours(angle, angles, options, threads, progress)

    def _contours(
        self, function: dict[str, Any], levels: ArrayLike, options: ContourOptions, threads: int, progress: Optional[Progress]
    ) -> Paths:
        struct = ffi.new("struct gusset_contour_function *", {"struct_size": ffi.sizeof("struct gusset_contour_function"), **function})
        rising = np.ascontiguousarray(levels, np.float64).reshape(-1)
        at = holding(ffi.cast("double *", pointer(rising)), rising)
        return Paths(create("surface_paths", self._handle, struct, at, len(rising), structs("contour_options", options),
                            name="surface_contours", threads=threads, progress=progress))

    def intersect(
        self, other: Surface, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[IntersectionOptions]
    ) -> Paths:
        """The curves in which two surfaces meet."""
        return Paths(create("surface_paths", self._handle, other._handle, structs("intersection_options", options),
                            name="surface_intersection", threads=threads, progress=progress))

    def hits(
        self, origins: ArrayLike, directions: ArrayLike, *, start: float = 0.0, end: float = np.inf,
        select: Literal["all", "first", "any"] = "all", threads: int = 0, progress: Optional[Progress] = None,
    ) -> Hits:
        """Where rays meet it: from origins (n, 3) along directions (n, 3), of which ``t`` counts lengths from ``start`` to ``end``."""
        starts, along = (np.atleast_2d(np.asarray(one, np.float64)) for one in (origins, directions))
        if starts.shape[-1] != 3 or along.shape[-1] != 3:
            raise ValueError("origins and directions are (n, 3)")
        starts, along = np.broadcast_arrays(starts, along)
        lines = np.zeros(len(starts), _LINE)
        lines["origin"], lines["direction"], lines["from"], lines["to"] = starts, along, start, end
        return Hits(create("surface_hits", self._handle, ffi.cast("struct gusset_line *", pointer(lines)), len(lines), ffi.NULL,
                           one_of({"all": 0, "first": 1, "any": 2}, "select", select), threads=threads, progress=progress))

    def evaluate(self, parameters: ArrayLike, sheet: int = 0) -> NDArray[Any]:
        """Points, derivatives, normals and curvatures at (n, 2) parameters u, v of a sheet: node (i, j) has u = i, v = j."""
        given = np.ascontiguousarray(parameters, np.float64)
        if given.ndim != 2 or given.shape[1] != 2:
            raise ValueError(f"parameters have the shape {given.shape}, not (n, 2)")
        places, out = np.zeros(len(given), _PLACE), np.zeros(len(given), _POINT)
        at = ffi.cast("struct gusset_surface_place *", pointer(places))
        call(lib.gusset_surface_locate, self._handle, sheet, ffi.cast("double *", pointer(given)), len(given), at)
        call(lib.gusset_surface_evaluate, self._handle, at, len(given), ffi.cast("struct gusset_surface_point *", pointer(out)))
        return out
