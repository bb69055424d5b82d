"""Smooth curves through given points, and operations on curves."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import pointer, real
from ._call import Progress, call
from ._exchange import handle_of
from ._handles import Reported, create
from ._keywords import options as structs
from ._library import bits_of, ffi, holding, lib, number_of
from ._options import OffsetOptions, OutlineOptions, Unpack
from ._outlines import in_space, outlines_of
from ._records import words
from ._reports import CurveMeasures, CurveNearestPointArray, OutlineHistory, OutlineReport, OutlineView
from .choices import NUMBERS, CurveMeasureFlags, SampleRule
from .curves import CurveQueries, Places

__all__ = ["Curve", "Outline", "Places", "find_sections"]


class Curve(CurveQueries):
    """A curve of Bezier segments in the plane or in space."""

    @classmethod
    def through(cls, points: ArrayLike, *, closed: bool = False) -> Curve:
        """Makes the curve that a surface has through these nodes (n, 3)."""
        nodes = in_space(points)
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
        return Places(create("places", self._handle, number_of("gusset_sample_rule", "rule", rule), real(amount), name="curve_sample"))

    def nearest(self, points: ArrayLike) -> CurveNearestPointArray:
        """Finds the nearest point of the curve for each of (n, 3) points."""
        queries = in_space(points)
        out = CurveNearestPointArray.zeros(len(queries))
        call(lib.gusset_curve_nearest, self._handle, ffi.cast("double *", pointer(queries)), len(queries), out.pointer())
        return out

    def intersect(self, other: Optional[Curve] = None, within: float = 0.0) -> Places:
        """Finds the places where two curves meet, or are within a distance of each other. Without another curve: where a plane curve meets itself."""
        second = ffi.NULL if other is None else handle_of("curve", other)
        return Places(create("places", self._handle, second, real(within), name="curve_intersect"))

    def offset(self, distance: float, **options: Unpack[OffsetOptions]) -> Curve:
        """Makes the curve at a distance to the left."""
        given: dict[str, Any] = {"tolerance": 1e-6 * float(np.ptp(self.controls, axis=0).max() or 1), **options}
        return Curve(create("curve", self._handle, real(distance), structs("offset_options", given), ffi.NULL, name="curve_offset"))


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
        outlines = outlines_of(points, closed, tangents, corners)
        super().__init__(create("outline", outlines, structs("outline_options", options), threads=threads, progress=progress))

    @cached_property
    def curve(self) -> Curve:
        """The curve."""
        return Curve(create("curve", self._handle, 0, name="outline_curve"))

    @property
    def statuses(self) -> NDArray[np.str_]:
        """The outcome at each point: ``"ok"``, or the reason why the curve differs from the request."""
        return self.report.statuses

    @cached_property
    def fit(self) -> OutlineReport:
        """How well the curve fits: its outcome, residuals, and the angles at its joints."""
        return OutlineReport.read(self._handle, 0)

    @cached_property
    def history(self) -> list[tuple[float, NDArray[np.float64]]]:
        """The cycles of the iteration, with ``history=True``: the largest move of each, and the control points (n, 3) after it.

        >>> half = np.linspace(0, np.pi, 6)
        >>> points = np.stack([np.cos(half), np.sin(half)], axis=1)
        >>> literal = Outline(points, curve="single", lock="data_guide", solver="step", max_sweeps=3, history=True)
        >>> [controls.shape for _, controls in literal.history]
        [(6, 3), (6, 3), (6, 3)]
        """
        found = OutlineHistory.read(self._handle, 0)
        ends = found.cycles.control_end.astype(np.intp)
        return list(zip(found.cycles.moved.tolist(), np.split(found.controls, ends[:-1])))


def find_sections(
    points: ArrayLike, closed: bool = False, *, tangents: Optional[Mapping[int, ArrayLike]] = None, **options: Unpack[OutlineOptions]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.str_]]:
    """Finds the section of each point: the quadratic through it and its two neighbours, with its control point on the method's guide.

    Returns:
        (n, 3) control points, (n,) parameters of the points on their sections, and (n,) outcomes, ``"ok"`` or the reason.

    >>> find_sections([[0, 0], [1, 1], [2, 0]], method="median")[0][1].tolist()
    [1.0, 2.0, 0.0]
    """
    given = outlines_of(points, closed, tangents)
    controls, parameters, statuses = np.zeros((given.point_count, 3)), np.zeros(given.point_count), np.zeros(given.point_count, np.uint8)
    call(lib.gusset_outlines_find_sections, given, structs("outline_options", options), ffi.cast("double *", pointer(controls)),
         ffi.cast("double *", pointer(parameters)), ffi.cast("uint8_t *", pointer(statuses)), ffi.NULL)
    return controls, parameters, words(statuses, "gusset_point_status")
