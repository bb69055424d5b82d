"""Evaluates, intersects, cuts and exports curves."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import indices_of, pointer, real, reals_of
from ._call import Progress, call
from ._exchange import CurvePlaces, curve_places, index, lines_of, numbers, vector
from ._handles import Reported, create
from ._library import ffi, lib
from ._reports import CurveFormView, CurveView, PlaceArray, PlacesView

if TYPE_CHECKING:
    from typing_extensions import Self

__all__ = ["CurvePoints", "CurveSpline", "Places"]


class Places(Reported[PlacesView]):
    """Places on a curve."""

    REPORT = PlacesView

    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 3): the points at the places."""
        return self.report.points

    def __len__(self) -> int:
        return len(self.report.places)


class CurvePoints(NamedTuple):
    """Derivatives, tangents and curvatures at n places."""

    #: (n, order + 1, 3): points, then derivatives by the parameter of the segment.
    derivatives: NDArray[np.float64]
    #: (n, 3): unit tangents.
    tangents: NDArray[np.float64]
    #: (n,): 1 / radius; in the plane positive if it turns from x to y.
    curvatures: NDArray[np.float64]


class CurveSpline(NamedTuple):
    """A clamped B-spline: ``len(points) + degree + 1`` knots."""

    points: NDArray[np.float64]
    knots: NDArray[np.float64]
    degree: int


class CurveQueries(Reported[CurveView]):
    """The part of :class:`Curve` that evaluates, intersects, cuts and exports curves.

    Places are a :class:`PlaceArray` or numbers ``segment + t``: 2.5 is t = 0.5 on the third segment.
    """

    REPORT = CurveView

    @classmethod
    def from_controls(cls, controls: ArrayLike, ends: Optional[ArrayLike] = None, *, closed: bool = False) -> Self:
        """Makes a curve of Bezier segments from control points.

        Args:
            controls: (n, 2) or (n, 3); the last control point of a segment is the first of the next.
            ends: 0, then the number of the last control point of each segment; None: one segment.
            closed: the last control point repeats the first.

        >>> import gusset_mesh as gm
        >>> gm.Curve.from_controls([[0, 0], [1, 2], [2, 0]]).evaluate([0.5]).derivatives[0, 0].tolist()
        [1.0, 1.0, 0.0]
        """
        array = np.ascontiguousarray(reals_of(controls))
        if array.ndim != 2 or array.shape[1] not in (2, 3):
            raise ValueError(f"control points have the shape {array.shape}, not (n, 2) or (n, 3)")
        last = indices_of([0, len(array) - 1] if ends is None and len(array) else [0] if ends is None else ends, "ends").reshape(-1)
        return cls(create("curve", ffi.cast("double *", pointer(array)), len(array), array.shape[1], ffi.cast("uint32_t *", pointer(last)), len(last),
                          int(bool(closed))))

    def evaluate(self, places: CurvePlaces, order: int = 0, *, threads: int = 0, progress: Optional[Progress] = None) -> CurvePoints:
        """Computes points, derivatives up to an order, unit tangents and curvatures at places."""
        at, order = curve_places(places), index(order, "order")
        derivatives = np.zeros((len(at), min(order, 64) + 1, 3))
        tangents, curvatures = np.zeros((len(at), 3)), np.zeros(len(at))
        out = (ffi.cast("double *", pointer(one)) for one in (derivatives, tangents, curvatures))
        call(lib.gusset_curve_evaluate, self._handle, at.pointer(), len(at), order, *out, threads=threads, progress=progress)
        return CurvePoints(derivatives, tangents, curvatures)

    def lengths_at(self, places: CurvePlaces) -> NDArray[np.float64]:
        """Computes the arc lengths from the start to places."""
        at = curve_places(places)
        out = np.zeros(len(at))
        call(lib.gusset_curve_lengths_at, self._handle, at.pointer(), len(at), ffi.cast("double *", pointer(out)))
        return out

    def places_at(self, lengths: ArrayLike) -> PlaceArray:
        """Finds the places at arc lengths from the start, clamped to the ends.

        >>> import gusset_mesh as gm
        >>> line = gm.Curve.from_controls([[0, 0], [4, 0]])
        >>> line.places_at([1, 9]).t.tolist()
        [0.25, 1.0]
        """
        given = numbers(lengths, (-1,), "lengths")
        out = PlaceArray.zeros(len(given))
        call(lib.gusset_curve_places_at, self._handle, ffi.cast("double *", pointer(given)), len(given), out.pointer())
        return out

    def intersect_plane(self, point: ArrayLike, normal: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None) -> Places:
        """Finds the places where the curve crosses or touches a plane."""
        return Places(create("places", self._handle, vector(point, "point"), vector(normal, "normal"), name="curve_intersect_plane",
                             threads=threads, progress=progress))

    def intersect_line(
        self, origin: ArrayLike, direction: ArrayLike, within: float = 0.0, *, start: float = -np.inf, end: float = np.inf,
        threads: int = 0, progress: Optional[Progress] = None,
    ) -> Places:
        """Finds the places where the curve meets a line, or is within a distance of it. ``report.others.t`` has the line's parameters."""
        line = lines_of([vector(origin, "origin")], [vector(direction, "direction")], start, end)
        return Places(create("places", self._handle, ffi.cast("struct gusset_line *", pointer(line)), real(within), name="curve_intersect_line",
                             threads=threads, progress=progress))

    def tangent_angle(self, direction: ArrayLike, angle: float, *, threads: int = 0, progress: Optional[Progress] = None) -> Places:
        """Finds the places where the tangent makes an angle, 0 to pi, with a direction."""
        return Places(create("places", self._handle, vector(direction, "direction"), real(angle), name="curve_tangent_angle", threads=threads,
                             progress=progress))

    def part(self, start: CurvePlaces, end: CurvePlaces) -> Self:
        """Cuts out the part between two places. On a closed curve it may pass the start.

        >>> import gusset_mesh as gm
        >>> gm.Curve.from_controls([[0, 0], [4, 0]]).part(0.25, 0.75).length
        2.0
        """
        return type(self)(create("curve", self._handle, self._place(start), self._place(end), name="curve_part"))

    def _place(self, given: CurvePlaces) -> Any:
        """Returns one place. A curve of n segments ends at segment n - 1, t = 1."""
        at = curve_places(given)
        if len(at) != 1:
            raise ValueError(f"one place is wanted, not {len(at)}")
        segments = len(self.report.ends) - 1
        if at.segment[0] == segments > 0 and at.t[0] == 0:
            at.array["segment"], at.array["t"] = segments - 1, 1
        return ffi.new("struct gusset_place *", {"segment": int(at.segment[0]), "t": float(at.t[0])})[0]

    def reverse(self) -> Self:
        """Reverses the curve."""
        return type(self)(create("curve", self._handle, name="curve_reverse"))

    def change_degree(
        self, lowest: int = 1, highest: int = 64, tolerance: float = np.inf, *, threads: int = 0, progress: Optional[Progress] = None
    ) -> tuple[Self, NDArray[np.float64]]:
        """Raises and lowers the degrees of segments. Raising is exact; lowering keeps the tolerance.

        Returns:
            the curve, and a bound of each segment's deviation.
        """
        out = np.zeros(max(len(self.report.ends) - 1, 0))
        made = create("curve", self._handle, index(lowest, "lowest"), index(highest, "highest"), real(tolerance),
                      ffi.cast("double *", pointer(out)), name="curve_change_degree", threads=threads, progress=progress)
        return type(self)(made), out

    def _exported(self, form: int, tolerance: float = 0.0) -> CurveFormView:
        made = create("curve_form", self._handle, form, real(tolerance), name="curve_export")
        return CurveFormView.read(made)

    def svg(self) -> str:
        """Exports a plane curve up to degree 3 as the data of an SVG path."""
        return self._exported(lib.GUSSET_CURVE_FORMAT_SVG).text

    def contour(self, tolerance: float = 0.0) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
        """Exports a closed plane curve up to degree 2 as a TrueType contour: (n, 3) points, and whether each is on the curve.

        Args:
            tolerance: distance from the middle of its neighbours within which a joint is omitted.
        """
        form = self._exported(lib.GUSSET_CURVE_FORMAT_CONTOUR, tolerance)
        return form.points, form.on_curve

    def spline(self) -> CurveSpline:
        """Exports a curve of one degree as a clamped B-spline."""
        form = self._exported(lib.GUSSET_CURVE_FORMAT_SPLINE)
        return CurveSpline(form.points, form.knots, form.degree)
