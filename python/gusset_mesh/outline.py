"""Smooth curves through given points, and operations on curves."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import indices_of, pointer
from ._call import Progress, call
from ._handles import Reported, create
from ._keywords import options as structs
from ._library import bits_of, ffi, holding, lib, number_of
from ._options import OffsetOptions, OutlineOptions, Unpack
from ._reports import CurveFormView, CurveMeasures, CurveNearestPointArray, CurveView, OutlineView, PlacesView
from .choices import NUMBERS, CurveMeasureFlags, SampleRule

__all__ = ["Curve", "Outline", "Places"]


def _in_space(points: ArrayLike) -> NDArray[np.float64]:
    """Points as (n, 3); points (n, 2) get z = 0."""
    array = np.asarray(points, np.float64)
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        raise ValueError(f"points have the shape {array.shape}, not (n, 2) or (n, 3)")
    return np.ascontiguousarray(array if array.shape[1] == 3 else np.pad(array, ((0, 0), (0, 1))))


class Places(Reported[PlacesView]):
    """Places on a curve."""

    REPORT = PlacesView

    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 3): the points at the places."""
        return self.report.points

    def __len__(self) -> int:
        return len(self.report.places)


class Curve(Reported[CurveView]):
    """A curve of Bezier segments in the plane or in space."""

    REPORT = CurveView

    @classmethod
    def through(cls, points: ArrayLike, *, closed: bool = False) -> Curve:
        """Makes the curve that a surface has through these nodes (n, 3)."""
        nodes = _in_space(points)
        at = holding(ffi.cast("double *", pointer(nodes)), nodes)
        return cls(create("curve", at, len(nodes), int(closed), 0, name="curve_through"))

    @property
    def controls(self) -> NDArray[np.float64]:
        """(n, 3): control points, segment by segment."""
        return self.report.controls

    @property
    def ends(self) -> NDArray[np.uint32]:
        """Segment k has the control points ``ends[k]`` to ``ends[k + 1]``."""
        return self.report.ends

    @property
    def is_closed(self) -> bool:
        return self.report.closed

    def measure(self, flags: Union[CurveMeasureFlags, Iterable[CurveMeasureFlags]] = ()) -> CurveMeasures:
        """Measures length, bounding box, centre, area, and in the plane moments; ``flags`` selects some of them."""
        made = CurveMeasures.new()
        call(lib.gusset_curve_measure, self._handle, bits_of(NUMBERS["gusset_curve_measure_flags"], "flags", flags), made._struct)
        return made

    @cached_property
    def length(self) -> float:
        return self.measure("length").length

    @cached_property
    def area_vector(self) -> NDArray[np.float64]:
        """Half the integral of p x dp: for a closed plane curve its area times the normal."""
        return self.measure("area").area_vector

    def sample(self, amount: float, rule: SampleRule = "count") -> Places:
        """Samples points: ``amount`` points at equal arc lengths, steps of this length, or chords within this distance."""
        return Places(create("places", self._handle, number_of("gusset_sample_rule", "rule", rule), float(amount), name="curve_sample"))

    def nearest(self, points: ArrayLike) -> CurveNearestPointArray:
        """Finds the nearest point of the curve for each of (n, 3) points."""
        queries = _in_space(points)
        out = CurveNearestPointArray.zeros(len(queries))
        call(lib.gusset_curve_nearest, self._handle, ffi.cast("double *", pointer(queries)), len(queries), out.pointer())
        return out

    def intersect(self, other: Curve, within: float = 0.0) -> Places:
        """Finds the places where two curves meet, or are within a distance of each other."""
        return Places(create("places", self._handle, other._handle, float(within), name="curve_intersect"))

    def offset(self, distance: float, **options: Unpack[OffsetOptions]) -> Curve:
        """Makes the curve at a distance to the left."""
        given: dict[str, Any] = {"tolerance": 1e-6 * float(np.ptp(self.controls, axis=0).max() or 1), **options}
        return Curve(create("curve", self._handle, float(distance), structs("offset_options", given), ffi.NULL, name="curve_offset"))

    def svg(self) -> str:
        """The curve as the data of an SVG path."""
        form = create("curve_form", self._handle, lib.GUSSET_CURVE_FORMAT_SVG, 0.0, name="curve_export")
        return CurveFormView.read(form).text


class Outline(Reported[OutlineView]):
    """A smooth curve through points.

    Args:
        points: (n, 2) or (n, 3).
        closed: whether the curve continues from the last point to the first.
        tangents: directions of the curve at points, by index.
        corners: indices of points where the curve may have a corner.
        options: see :class:`~gusset_mesh.OutlineOptions`; for example ``method="median"``.

    >>> import numpy as np
    >>> angle = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    >>> circle = Outline(np.stack([np.cos(angle), np.sin(angle)], axis=1), closed=True)
    >>> round(circle.curve.length, 3)
    6.283
    """

    REPORT = OutlineView

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
    def statuses(self) -> NDArray[np.str_]:
        """The outcome at each point: ``"ok"``, or the reason why the curve differs from the request."""
        return self.report.statuses
