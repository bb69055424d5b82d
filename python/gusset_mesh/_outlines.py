"""Makes the structs of outlines: points, and constraints on the curves through them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import indices_of, pointer, reals_of
from ._library import ffi, holding, lib


def in_space(points: ArrayLike) -> NDArray[np.float64]:
    """Returns points (n, 3); points (n, 2) get z = 0."""
    array = reals_of(points)
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        raise ValueError(f"points have the shape {array.shape}, not (n, 2) or (n, 3)")
    return np.ascontiguousarray(array if array.shape[1] == 3 else np.pad(array, ((0, 0), (0, 1))))


def outlines_of(
    points: ArrayLike, closed: bool, tangents: Optional[Mapping[int, ArrayLike]] = None, corners: ArrayLike = (),
    offsets: Optional[NDArray[np.uint32]] = None,
) -> Any:
    """Makes a gusset_outlines from points (n, 2) or (n, 3): one outline, or several that begin at offsets."""
    array = reals_of(points)
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        raise ValueError(f"points have the shape {array.shape}, not (n, 2) or (n, 3)")
    if array.size and (array.strides[1] != 8 or array.strides[0] < 8 * array.shape[1]):
        array = np.ascontiguousarray(array)
    demands: dict[int, list[float]] = {int(k): [] for k in indices_of(np.asarray(corners, np.int64) if np.size(corners) == 0 else corners, "corners")}
    for k, tangent in (tangents or {}).items():
        direction = reals_of(tangent)
        if direction.shape not in ((2,), (3,)):
            raise ValueError(f"the tangent of point {k} has the shape {direction.shape}, not (2,) or (3,)")
        if k in demands:
            raise ValueError(f"point {k} is a corner and has a tangent: give one of both")
        demands[int(k)] = [*direction.tolist(), 0.0][:3]
    given = ffi.new("struct gusset_constraint[]", max(len(demands), 1))
    for place, (k, direction_) in enumerate(sorted(demands.items())):
        given[place].point = k
        given[place].kind = lib.GUSSET_CONSTRAINT_TANGENT if direction_ else lib.GUSSET_CONSTRAINT_CORNER
        given[place].tangent = direction_
    outlines = ffi.new("struct gusset_outlines *")
    outlines.struct_size = ffi.sizeof("struct gusset_outlines")
    outlines.points, outlines.point_stride, outlines.point_count = pointer(array), array.strides[0] if array.size else 0, len(array)
    outlines.dimension, outlines.closed = array.shape[1], int(closed)
    if demands:
        outlines.constraints, outlines.constraint_count = given, len(demands)
    if offsets is not None:
        outlines.offsets, outlines.outline_count = ffi.cast("uint32_t *", pointer(offsets)), len(offsets) - 1
    return holding(outlines, array, given, offsets)


def sections_of(sections: Sequence[ArrayLike], closed: bool) -> Any:
    """Makes a gusset_outlines from consecutive sections of a body, each (n, 2) or (n, 3)."""
    parts = [reals_of(one) for one in sections]
    if not parts or any(one.ndim != 2 or one.shape[1] != parts[0].shape[-1] for one in parts):
        raise ValueError(f"sections have the shapes {', '.join(str(one.shape) for one in parts) or 'of no array'}, not all (n, 3) or all (n, 2)")
    offsets = np.cumsum([0, *map(len, parts)], dtype=np.uint32)
    return outlines_of(np.concatenate(parts), closed, offsets=offsets)
