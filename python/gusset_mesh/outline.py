"""Smooth curves through given points, by the methods of the bisector, median, normal, tangent and more."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any, Literal, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import indices_of, pointer
from ._call import Progress, call
from ._handles import Handle, create
from ._keywords import options as structs
from ._library import constants, ffi, holding, lib, one_of
from ._options import OffsetOptions, OutlineOptions, Unpack
from ._records import Record, dtype_of, filled

__all__ = ["Curve", "Outline", "Places"]

_RULES = constants("GUSSET_SAMPLE_")
_PLACE = dtype_of(ffi.typeof("struct gusset_place"))
_NEAREST = dtype_of(ffi.typeof("struct gusset_curve_nearest_point"))


def _in_space(points: ArrayLike) -> NDArray[np.float64]:
    """Points (n, 3); of (n, 2) z is 0."""
    array = np.asarray(points, np.float64)
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        raise ValueError(f"points have the shape {array.shape}, not (n, 2) or (n, 3)")
    return np.ascontiguousarray(array if array.shape[1] == 3 else np.pad(array, ((0, 0), (0, 1))))


class Places(Handle):
    """Places on a curve; ``points`` is (n, 3)."""

    KIND = "places"

    @property
    def points(self) -> NDArray[np.float64]:
        found: NDArray[np.float64] = self.account.points
        return found

    def __len__(self) -> int:
        return int(self.account.count)


class Curve(Handle):
    """A curve of Bezier segments in the plane or in space."""

    KIND = "curve"

    @classmethod
    def through(cls, points: ArrayLike, *, closed: bool = False) -> Curve:
        """The curve that a surface would have through nodes: (n, 3)."""
        nodes = _in_space(points)
        at = holding(ffi.cast("double *", pointer(nodes)), nodes)
        return cls(create("curve", at, len(nodes), int(closed), 0, name="curve_through"))

    @property
    def controls(self) -> NDArray[np.float64]:
        """(n, 3): the control points, segment after segment."""
        found: NDArray[np.float64] = self.account.controls
        return found

    @property
    def ends(self) -> NDArray[np.uint32]:
        """Segment k has the control points ``ends[k]`` to ``ends[k + 1]``."""
        found: NDArray[np.uint32] = self.account.ends
        return found

    @property
    def is_closed(self) -> bool:
        return bool(self.account.closed)

    def measure(self, flags: int = 0) -> Record:
        """Its length, box, centre, area, and in the plane moments; ``flags`` asks for some of them, 0 for all."""
        made = ffi.new("struct gusset_curve_measures *")
        made.struct_size = ffi.sizeof("struct gusset_curve_measures")
        call(lib.gusset_curve_measure, self._handle, flags, made)
        return Record(made[0], made)

    @cached_property
    def length(self) -> float:
        return float(self.measure(lib.GUSSET_CURVE_MEASURE_LENGTH).length)

    @cached_property
    def area_vector(self) -> NDArray[np.float64]:
        """Half the integral of p x dp: a plane closed curve has its area along the normal."""
        found: NDArray[np.float64] = self.measure(lib.GUSSET_CURVE_MEASURE_AREA).area_vector
        return found

    def sample(self, amount: float, rule: Literal["count", "step", "chord"] = "count") -> Places:
        """Points: so many at equal arc lengths, one every so much of it, or so that chords are nowhere farther off."""
        return Places(create("places", self._handle, one_of(_RULES, "rule", rule), float(amount), name="curve_sample"))

    def nearest(self, points: ArrayLike) -> NDArray[Any]:
        """Of each of (n, 3) points the nearest one of the curve: records of ``place``, ``point`` and ``distance``."""
        queries = _in_space(points)
        out = np.zeros(len(queries), _NEAREST)
        call(lib.gusset_curve_nearest, self._handle, ffi.cast("double *", pointer(queries)), len(queries),
             ffi.cast("struct gusset_curve_nearest_point *", pointer(out)))
        return out

    def intersect(self, other: Curve, within: float = 0.0) -> Places:
        """The places where two curves meet, or come as near to each other as ``within``."""
        return Places(create("places", self._handle, other._handle, float(within), name="curve_intersect"))

    def offset(self, distance: float, **options: Unpack[OffsetOptions]) -> Curve:
        """The curve at a distance to the left."""
        given: dict[str, Any] = {"tolerance": 1e-6 * float(np.ptp(self.controls, axis=0).max() or 1), **options}
        return Curve(create("curve", self._handle, float(distance), structs("offset_options", given), ffi.NULL, name="curve_offset"))

    def svg(self) -> str:
        """The path of SVG that it is."""
        form = create("curve_form", self._handle, lib.GUSSET_CURVE_FORMAT_SVG, 0.0, name="curve_export")
        return str(filled(lib.gusset_curve_form_get_view, "gusset_curve_form_view", form).text)


class Outline(Handle):
    """A smooth curve through points.

    Args:
        points: (n, 2) or (n, 3).
        closed: whether the curve goes on from the last point to the first.
        tangents: directions that it has to pass points in, by their numbers.
        corners: numbers of points at which it may turn sharply.
        options: see :class:`~gusset_mesh.OutlineOptions`, as ``method="median"``.

    >>> import numpy as np
    >>> angle = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    >>> circle = Outline(np.stack([np.cos(angle), np.sin(angle)], axis=1), closed=True)
    >>> round(circle.curve.length, 3)
    6.283
    """

    KIND = "outline"

    def __init__(
        self, points: ArrayLike, closed: bool = False, *, tangents: Optional[Mapping[int, ArrayLike]] = None,
        corners: ArrayLike = (), threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[OutlineOptions],
    ):
        array = np.asarray(points, np.float64)
        if array.ndim != 2 or array.shape[1] not in (2, 3):
            raise ValueError(f"points have the shape {array.shape}, not (n, 2) or (n, 3)")
        if array.size and (array.strides[1] != 8 or array.strides[0] < 8 * array.shape[1]):
            array = np.ascontiguousarray(array)
        demands: dict[int, list[float]] = {int(k): [] for k in indices_of(np.asarray(corners, np.int64) if np.size(corners) == 0 else corners, "corners")}
        for k, tangent in (tangents or {}).items():
            direction = np.asarray(tangent, np.float64)
            if direction.shape not in ((2,), (3,)):
                raise ValueError(f"a tangent has the shape {direction.shape}, not (2,) or (3,)")
            if k in demands:
                raise ValueError(f"point {k} is a corner and has a tangent")
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
        super().__init__(create("outline", outlines, structs("outline_options", options), threads=threads, progress=progress))

    @cached_property
    def curve(self) -> Curve:
        """The curve."""
        return Curve(create("curve", self._handle, 0, name="outline_curve"))

    @property
    def statuses(self) -> NDArray[np.uint8]:
        """Of each point what became of it: ``GUSSET_POINT_...``, 0 as asked."""
        found: NDArray[np.uint8] = self.account.statuses
        return found
