"""Compares two loops: facing vertices, strips between them; finds vertices that are one at seams."""

from __future__ import annotations

from typing import Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import indices_of, pointer
from ._call import Progress, call
from ._exchange import index, numbers
from ._handles import Reported, Result, create, result
from ._keywords import options as structs
from ._library import ffi, lib
from ._options import FacingOptions, StripOptions, Unpack
from ._reports import FacingView, StripReport
from .errors import error
from .mesh import MeshLike, as_mesh, view_of

__all__ = ["Facing", "Strip", "facing", "find_merge", "meridians_index", "strip"]


class Strip(Result[StripReport]):
    """The faces between two polylines. The mesh has the points of A, of B, then new ones."""

    REPORT = StripReport


def strip(
    points_a: ArrayLike, points_b: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[StripOptions]
) -> Strip:
    """Builds a strip of faces between two polylines, as :func:`stitch` does between rims.

    Args:
        points_a: (n, 3) in order; a closed polyline does not repeat its first point.
        points_b: as points_a, for the other one.
        options: see :class:`~gusset_mesh.StripOptions`.

    >>> strip([[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0]]).mesh.face_count
    2
    """
    first, second = numbers(points_a, (-1, 3), "points_a"), numbers(points_b, (-1, 3), "points_b")
    return Strip(result("strip", ffi.cast("double *", pointer(first)), len(first), ffi.cast("double *", pointer(second)), len(second),
                        structs("strip_options", options), threads=threads, progress=progress))


class Facing(Reported[FacingView]):
    """The vertices of two loops that face each other. ``report.taken`` has ``arc_a`` and ``arc_b`` of :func:`stitch`."""

    REPORT = FacingView


def facing(
    points_a: ArrayLike, points_b: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[FacingOptions]
) -> Facing:
    """Finds the vertices of two loops that face each other.

    Args:
        points_a: (n, 3), the vertices of a loop in order.
        points_b: as points_a, for the other one.
        options: see :class:`~gusset_mesh.FacingOptions`.

    >>> square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    >>> facing(square, [[x + 3, y, z] for x, y, z in square]).report.taken.tolist()
    [[1, 2], [3, 2]]
    """
    first, second = numbers(points_a, (-1, 3), "points_a"), numbers(points_b, (-1, 3), "points_b")
    made = create("facing", ffi.cast("double *", pointer(first)), len(first), ffi.cast("double *", pointer(second)), len(second),
                  structs("facing_options", options), threads=threads, progress=progress)
    return Facing(made)


def meridians_index(n: int, m: int) -> NDArray[np.uint32]:
    """Computes meridians by index. For each i = 0 .. n, the j of 0 .. m makes ``|m i - n j|`` least; m is at most n.

    >>> meridians_index(4, 2).tolist()
    [0, 1, 1, 2, 2]
    """
    longer, shorter, written = index(n, "n"), index(m, "m"), ffi.new("size_t *")
    status = lib.gusset_meridians_index(longer, shorter, ffi.NULL, 0, written)
    if status == 0:
        out = np.zeros(written[0], np.uint32)
        status = lib.gusset_meridians_index(longer, shorter, ffi.cast("uint32_t *", pointer(out)), out.size, written)
    if status != 0:
        raise error(status, "")
    return out


def find_merge(
    mesh: MeshLike, keys: Optional[ArrayLike] = None, *, threads: int = 0, progress: Optional[Progress] = None
) -> NDArray[np.uint32]:
    """Finds which vertices of a mesh are one: for each the smallest such vertex. ``merge`` of :class:`Mesh` takes the answer.

    Args:
        keys: a whole number for each vertex: vertices with equal keys are one. None: vertices at equal positions are one.

    >>> find_merge(([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 0]], [[0, 1, 2], [3, 1, 2]])).tolist()
    [0, 1, 2, 0]
    """
    given = as_mesh(mesh)
    numbers_ = None if keys is None else indices_of(keys, "keys").reshape(-1)
    if numbers_ is not None and len(numbers_) != given.vertex_count:
        raise ValueError(f"{len(numbers_)} keys for {given.vertex_count} vertices: pass one for each")
    out = np.zeros(given.vertex_count, np.uint32)
    at = ffi.NULL if numbers_ is None else ffi.cast("uint32_t *", pointer(numbers_))
    call(lib.gusset_mesh_find_merge, view_of(given), at, ffi.cast("uint32_t *", pointer(out)), threads=threads, progress=progress)
    return out
