"""The base of all parts of the class Net."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from numpy.typing import NDArray

from ._call import Progress, call
from ._exchange import sized
from ._handles import Handle, create
from ._library import lib
from ._records import lent
from .errors import error

if TYPE_CHECKING:
    from typing_extensions import Self


class NetHandle(Handle):
    """Owns a net, which never changes: a function of C that changes a net is applied to a copy. Many threads may use one net."""

    @classmethod
    def _of(cls, handle: Any) -> Self:
        made = cls.__new__(cls)
        Handle.__init__(made, handle)
        return made

    def _copied(self, **fields: int) -> Self:
        """Makes a copy, changed by the fields of gusset_net_copy_options."""
        return self._of(create("net", self._handle, sized("gusset_net_copy_options", **fields), name="net_copy"))

    def _changed(self, function: Any, *arguments: Any, threads: int = 0, progress: Optional[Progress] = None) -> Self:
        """Makes a copy, and applies a function of C to it."""
        copy = self._copied()
        call(function, copy._handle, *arguments, threads=threads, progress=progress)
        return copy

    @cached_property
    def _view(self) -> Any:
        view = sized("gusset_net_view")
        status = lib.gusset_net_get_view(self._handle, view)
        if status != 0:
            raise error(status, "")
        return view

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of nodes."""
        return int(self._view.rows), int(self._view.columns)

    @property
    def dtype(self) -> np.dtype[Any]:
        """The type of coordinates."""
        return np.dtype(np.float32 if self._view.scalar == lib.GUSSET_F32 else np.float64)

    @property
    def coordinates(self) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """The x, y and z of all nodes, (rows, columns) each: the arrays of the net, without a copy."""
        view, (rows, columns), dtype = self._view, self.shape, self.dtype
        across = view.column_stride or dtype.itemsize
        down = view.row_stride or columns * across
        span = ((rows - 1) * down + (columns - 1) * across) // dtype.itemsize + 1
        flat = (lent(start, (span,), dtype, self._handle) for start in (view.x, view.y, view.z))
        x, y, z = (np.lib.stride_tricks.as_strided(one, (rows, columns), (down, across), writeable=False) for one in flat)
        return x, y, z

    @property
    def nodes(self) -> NDArray[Any]:
        """(rows, columns, 3): a copy of the nodes."""
        return np.stack(self.coordinates, axis=2)
