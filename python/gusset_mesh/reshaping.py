"""Makes nets with other rows and columns: shapes, parts, symmetries, resolutions, and nets found in meshes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, Optional, TypeVar

import numpy as np
from numpy.typing import DTypeLike, NDArray

from ._arrays import SCALARS, pointer, real
from ._call import Progress, call
from ._exchange import index, sized
from ._handles import Reported, create
from ._keywords import options as structs
from ._library import ffi, lib, number_of, one_of
from ._net_handle import NetHandle
from ._options import NetPrimitive, Unpack
from ._reports import NetGridView
from .choices import Direction, GridCells, Interpolation, Replication
from .mesh import MeshLike, as_mesh, view_of

if TYPE_CHECKING:
    from typing_extensions import Self

__all__ = ["DecimatedNet", "NetGrid"]

_TURNS = (lib.GUSSET_NET_TURN_NONE, lib.GUSSET_NET_TURN_QUARTER, lib.GUSSET_NET_TURN_HALF, lib.GUSSET_NET_TURN_THREE_QUARTERS)
_Net = TypeVar("_Net")


@dataclass(frozen=True, eq=False)
class DecimatedNet(Generic[_Net]):
    """A net without the rows and columns that a tolerance makes redundant."""

    net: _Net
    #: The rows and the columns that were kept.
    rows: NDArray[np.uint32]
    columns: NDArray[np.uint32]
    #: The largest deviation.
    deviation: float


class NetGrid(Reported[NetGridView]):
    """The correspondence between a net and the mesh it was found in."""

    REPORT = NetGridView


def _range(given: Any, count: int, name: str) -> tuple[int, int]:
    """Returns the start and the length of a slice without a step."""
    if not isinstance(given, slice):
        raise TypeError(f"{name} of a part are a slice, not {given!r}")
    first, last, step = given.indices(count)
    if step != 1:
        raise ValueError(f"{name} of a part are consecutive: the step is {step}")
    return first, max(last - first, 0)


class NetReshaping(NetHandle):
    """The part of :class:`Net` that makes nets of other rows and columns."""

    @classmethod
    def primitive(cls, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[NetPrimitive]) -> Self:
        """Makes a standard shape centred at the origin, with axis z: ``shape="sphere", radius=1``.

        >>> import gusset_mesh as gm
        >>> gm.Net.primitive(shape="torus", radius=2, minor_radius=0.5, rows=33, columns=65).complex().report.euler
        0
        """
        given = structs("net_primitive", {"scalar": "f64", **options})
        return cls._of(create("net", given, name="net_primitive", threads=threads, progress=progress))

    def __getitem__(self, part: Any) -> Self:
        """Returns a part, such as ``net[2:5, :]``. It keeps the gluing and bridges inside it."""
        pair = part if isinstance(part, tuple) else (part, slice(None))
        if len(pair) != 2:
            raise IndexError(f"a net has rows and columns, not {len(pair)} axes")
        rows, columns = (_range(one, count, name) for one, count, name in zip(pair, self.shape, ("rows", "columns")))
        if 0 in (rows[1], columns[1]):
            raise ValueError(f"the part has {rows[1]} rows and {columns[1]} columns: it needs at least 2 of each")
        return self._copied(row_first=rows[0], row_count=rows[1], column_first=columns[0], column_count=columns[1])

    def astype(self, dtype: DTypeLike) -> Self:
        """Converts the coordinates to 32- or 64-bit floats. Nodes that overflow become missing."""
        wanted = np.dtype(dtype)
        if wanted not in SCALARS:
            raise ValueError(f"coordinates are float32 or float64, not {wanted}")
        return self._copied(scalar=SCALARS[wanted])

    def compact(self) -> Self:
        """Removes rows and columns that repeat the previous one."""
        return self._copied(compact=1)

    def enlarge(self, rows: Optional[int] = None, columns: Optional[int] = None, replication: Replication = "uniform", place: int = 0) -> Self:
        """Enlarges the net by copies of rows and columns. Links between copies are contracted.

        Args:
            place: row or column to replicate with ``replication="at"``.

        >>> import gusset_mesh as gm
        >>> gm.Net.primitive(shape="plane", size=(1, 1, 1), rows=3, columns=4).enlarge(rows=5).compact().shape
        (3, 4)
        """
        which = number_of("gusset_replication", "replication", replication)
        at = index(place, "place")
        return self._copied(rows=index(rows or 0, "rows", 64), columns=index(columns or 0, "columns", 64), row_replication=which,
                            column_replication=which, row_index=at, column_index=at)

    def turn(self, quarters: int = 1) -> Self:
        """Turns the net by quarters. A quarter makes the last column the first row."""
        return self._copied(turn=_TURNS[quarters % 4])

    def transpose(self) -> Self:
        """Exchanges rows and columns."""
        return self._copied(turn=lib.GUSSET_NET_TURN_TRANSPOSE)

    def flip(self, direction: Direction = "right") -> Self:
        """Reverses the order of columns (``"right"``) or rows."""
        flips = {"right": lib.GUSSET_NET_TURN_FLIP_COLUMNS, "down": lib.GUSSET_NET_TURN_FLIP_ROWS}
        return self._copied(turn=one_of(flips, "direction", direction))

    def clear_no_data(self, value: float) -> Self:
        """Makes nodes missing that have a coordinate equal to a value."""
        return self._changed(lib.gusset_net_clear_no_data, real(value))

    def resample(
        self, rows: int, columns: int, interpolation: Interpolation = "bicubic", *, threads: int = 0, progress: Optional[Progress] = None
    ) -> Self:
        """Interpolates the net with other numbers of rows and columns, spread evenly."""
        between = number_of("gusset_interpolation", "interpolation", interpolation)
        return self._of(create("net", self._handle, index(rows, "rows", 64), index(columns, "columns", 64), between, name="net_resample",
                               threads=threads, progress=progress))

    def decimate(self, tolerance: float, *, threads: int = 0, progress: Optional[Progress] = None) -> DecimatedNet[Self]:
        """Removes rows and columns within a tolerance, each time the one that causes the least deviation.

        >>> import gusset_mesh as gm
        >>> made = gm.Net.primitive(shape="tube", radius=1, height=3, rows=20, columns=65).decimate(1e-6)
        >>> made.net.shape, made.rows.tolist()
        ((2, 65), [0, 19])
        """
        rows, columns = (np.zeros(count, np.uint32) for count in self.shape)
        deviation = ffi.new("double *")
        at = (ffi.cast("uint32_t *", pointer(one)) for one in (rows, columns))
        net = self._of(create("net", self._handle, real(tolerance), *at, deviation, name="net_decimate", threads=threads, progress=progress))
        return DecimatedNet(net, rows[:net.shape[0]], columns[:net.shape[1]], float(deviation[0]))

    def pyramid(
        self, interpolation: Interpolation = "bicubic", *, threads: int = 0, progress: Optional[Progress] = None
    ) -> list[Self]:
        """Makes levels of detail: nets of 2^k + 1 rows and columns, finest first."""
        made = ffi.new("struct gusset_net *[]", lib.GUSSET_PYRAMID_LEVELS)
        count = ffi.new("size_t *")
        call(lib.gusset_net_pyramid_create, self._handle, number_of("gusset_interpolation", "interpolation", interpolation), made, len(made), count,
             threads=threads, progress=progress)
        return [self._of(ffi.gc(made[k], lib.gusset_net_destroy)) for k in range(count[0])]

    @classmethod
    def find_grid(
        cls, mesh: MeshLike, *, cells: GridCells = "quads", face: Optional[int] = None, threads: int = 0,
        progress: Optional[Progress] = None,
    ) -> tuple[Self, NetGrid]:
        """Finds rows and columns in a mesh. Returns the net of its vertices, and the correspondence.

        Args:
            cells: cells of the grid in the mesh: quads, or two triangles each.
            face: a face of the only component that must be a grid; None: the whole mesh must be a grid.

        Raises:
            InputError: the mesh is not a grid; ``index`` is a face that violates the grid.
        """
        given = sized("gusset_net_grid_options", cells=number_of("gusset_grid_cells", "cells", cells))
        if face is not None:
            given.has_face, given.face = 1, index(face, "face")
        grid = ffi.new("struct gusset_net_grid **")
        net = cls._of(create("net", view_of(as_mesh(mesh)), given, grid, name="net_from_mesh", threads=threads, progress=progress))
        return net, NetGrid(ffi.gc(grid[0], lib.gusset_net_grid_destroy))
