"""Makes sheets from patches, splines, curves and frames; measures and offsets sheets."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import pointer, real, reals_of
from ._call import Progress, call
from ._exchange import answer, handle_of, handles_of, index, numbers, sized
from ._handles import Reported, create
from ._library import ffi, holding, lib, number_of, one_of
from ._reports import SheetMeasures, SheetReport
from .choices import FrameSurface, NUMBERS
from .frame import Frame
from .outline import Curve

if TYPE_CHECKING:
    from typing_extensions import Self

GivenTwists = Union[Literal["differences", "adini", "zero"], ArrayLike]

_ALONG = {"rows": 0, "columns": 1}
_CELL_ARRAYS = ("diameters", "intrinsic_diameters", "errors", "bilinear", "triangles")


def tangents_of(tangents: Optional[tuple[ArrayLike, ArrayLike]], twists: GivenTwists, shape: tuple[int, ...]) -> Any:
    """Makes a gusset_tangents from arrays like the nodes, towards the next row and the next column; NULL for None."""
    if tangents is None:
        return ffi.NULL
    arrays = [numbers(one, shape, "tangents") for one in tangents]
    if len(arrays) != 2:
        raise ValueError(f"tangents are two arrays, not {len(arrays)}")
    given = sized("gusset_tangents", u=ffi.cast("double *", pointer(arrays[0])), v=ffi.cast("double *", pointer(arrays[1])))
    if isinstance(twists, str):
        given.twist = one_of({word: number for word, number in NUMBERS["gusset_twists"].items() if word != "given"}, "twists", twists)
    else:
        arrays.append(numbers(twists, shape, "twists"))
        given.twist, given.twists = lib.GUSSET_TWISTS_GIVEN, ffi.cast("double *", pointer(arrays[2]))
    return holding(given, arrays)


class SheetMaking(Reported[SheetReport]):
    """The part of :class:`Sheet` that makes sheets from other shapes, and measures them."""

    REPORT = SheetReport

    @classmethod
    def _of(cls, handle: Any) -> Self:
        made = cls.__new__(cls)
        Reported.__init__(made, handle)
        return made

    @classmethod
    def from_patches(cls, points: ArrayLike) -> Self:
        """Makes a sheet of Bezier patches in rows and columns.

        Args:
            points: (rows, columns, degree_u + 1, degree_v + 1, 3) control points, degrees 1 to 7.
        """
        array = numbers(points, (-1, -1, -1, -1, 3), "points")
        rows, columns, count_u, count_v = array.shape[:4]
        return cls._of(create("sheet", ffi.cast("double *", pointer(array)), max(count_u - 1, 0), max(count_v - 1, 0), rows, columns,
                              name="sheet_from_patches"))

    @classmethod
    def from_spline(
        cls, points: ArrayLike, knots_u: ArrayLike, knots_v: ArrayLike, *, degree_u: int = 3, degree_v: int = 3, weights: Optional[ArrayLike] = None,
        closed_u: bool = False, closed_v: bool = False, tolerance: float = 0.0, max_cells: int = 0, threads: int = 0,
        progress: Optional[Progress] = None,
    ) -> Self:
        """Makes a sheet of a tensor-product B-spline, rational (NURBS) if it has weights.

        Args:
            points: (count_u, count_v, 3) control points, not multiplied by weights.
            knots_u, knots_v: control points + degree + 1 knots; in a closed direction control points + 1, one period.
            degree_u, degree_v: 1 to 7.
            weights: (count_u, count_v), above 0.
            tolerance: largest distance of patches from a rational spline; 0: 1e-12 of its size.
            max_cells: largest number of cells of a rational spline; 0: 2^20.

        >>> import numpy as np, gusset_mesh as gm
        >>> arc, w = np.array([[1, 0, 0], [1, 1, 0], [0, 1, 0]]), np.array([1, 0.5**0.5, 1])
        >>> quarter = gm.Sheet.from_spline(np.stack([arc, arc + [0, 0, 1]]), [0, 0, 1, 1], [0, 0, 0, 1, 1, 1], degree_u=1, degree_v=2,
        ...                                weights=np.stack([w, w]))
        >>> points = quarter.mesh(min_v=8).mesh.points
        >>> bool(np.allclose(np.hypot(points[:, 0], points[:, 1]), 1))
        True
        """
        array = numbers(points, (-1, -1, 3), "points")
        knots = [numbers(knots_u, (-1,), "knots_u"), numbers(knots_v, (-1,), "knots_v")]
        factors = None if weights is None else numbers(weights, array.shape[:2], "weights")
        at = [ffi.NULL if one is None else ffi.cast("double *", pointer(one)) for one in (array, *knots, factors)]
        given = sized(
            "gusset_spline", points=at[0], count_u=array.shape[0], count_v=array.shape[1], knots_u=at[1], knot_count_u=len(knots[0]), knots_v=at[2],
            knot_count_v=len(knots[1]), degree_u=index(degree_u, "degree_u"), degree_v=index(degree_v, "degree_v"), closed_u=int(bool(closed_u)),
            closed_v=int(bool(closed_v)), weights=at[3], tolerance=real(tolerance), max_cells=index(max_cells, "max_cells", 64),
        )
        return cls._of(create("sheet", given, name="sheet_from_spline", threads=threads, progress=progress))

    @classmethod
    def from_curves(
        cls, rows: Sequence[Curve] = (), columns: Sequence[Curve] = (), *, tolerance: float = 0.0, closed_u: bool = False, closed_v: bool = False,
        threads: int = 0, progress: Optional[Progress] = None,
    ) -> Self:
        """Makes Gordon's surface of a net of curves, which contains all of them. Two rows and two columns give Coons's patch.

        Args:
            rows: curves in v, ordered by u. Each meets each column. Without rows: the skin of the columns.
            columns: curves in u, ordered by v. Without columns: the skin of the rows.
            tolerance: largest distance of two curves where they meet; 0: 1e-6 of their size.
            closed_u: the columns are closed, and the first row follows the last.
            closed_v: the rows are closed, and the first column follows the last.
        """
        lists = handles_of("curve", rows), handles_of("curve", columns)
        given = sized("gusset_curve_net", rows=lists[0], row_count=len(rows), columns=lists[1], column_count=len(columns), tolerance=real(tolerance),
                      closed_u=int(bool(closed_u)), closed_v=int(bool(closed_v)))
        return cls._of(create("sheet", given, name="sheet_from_curves", threads=threads, progress=progress))

    @classmethod
    def from_frame(
        cls, frame: Frame, kind: FrameSurface = "sections", *, threads: int = 0, progress: Optional[Progress] = None
    ) -> Self:
        """Makes the surface of a frame, through its nodes or its curves. u runs along the body, v round it."""
        which = number_of("gusset_frame_surface", "kind", kind)
        return cls._of(create("sheet", handle_of("frame", frame), which, name="sheet_from_frame", threads=threads, progress=progress))

    def offset(self, distances: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None) -> tuple[Self, float]:
        """Makes a grid through the corners of cells, each moved along its normal.

        Args:
            distances: one for all corners, one for each of the rows + 1 lines of corners, or (rows + 1, columns + 1).

        Returns:
            the sheet, and its largest deviation from the true offset at middles of cells.

        >>> import numpy as np, gusset_mesh as gm
        >>> u, v = np.meshgrid(np.linspace(0, 1, 8), np.linspace(0, 1, 8), indexing="ij")
        >>> moved, deviation = gm.Sheet(np.stack([u, v, 0 * u], axis=2)).offset(0.25)
        >>> bool(np.allclose(moved.mesh().mesh.points[:, 2], 0.25)), deviation < 1e-12
        (True, True)
        """
        given = np.ascontiguousarray(reals_of(distances)).reshape(-1)
        deviation = ffi.new("double *")
        made = create("sheet", self._handle, ffi.cast("double *", pointer(given)), len(given), deviation, name="sheet_offset", threads=threads,
                      progress=progress)
        return self._of(made), float(deviation[0])

    def curve(self, along: Literal["rows", "columns"], parameter: float) -> Curve:
        """Makes the coordinate curve along rows (u is constant) or along columns (v is constant)."""
        return Curve(create("curve", self._handle, one_of(_ALONG, "along", along), real(parameter), name="sheet_curve"))

    def measure(self, *, threads: int = 0, progress: Optional[Progress] = None) -> SheetMeasures:
        """Measures the sheet: diameters, a bound of curvatures, the largest crease."""
        return answer(SheetMeasures, lib.gusset_sheet_measure, self._handle, 0, ffi.NULL, threads=threads, progress=progress)

    def measure_cells(
        self, *names: Literal["diameters", "intrinsic_diameters", "errors", "bilinear", "triangles"], threads: int = 0,
        progress: Optional[Progress] = None,
    ) -> dict[str, NDArray[np.float64]]:
        """Measures cells: bounds of diameters, estimated errors, bounds of the distance from bilinear patches or triangles.

        Returns:
            an array (rows, columns) for each name.
        """
        rows, columns = self.report.rows, self.report.columns
        out: dict[str, NDArray[np.float64]] = {one: np.zeros((rows, columns)) for one in names}
        given = sized("gusset_cell_arrays", capacity=rows * columns)
        for name, array in out.items():
            one_of(dict.fromkeys(_CELL_ARRAYS, 0), "name", name)
            setattr(given, name, ffi.cast("double *", pointer(array)))
        call(lib.gusset_sheet_measure, self._handle, 0, given, ffi.NULL, threads=threads, progress=progress)
        return out
