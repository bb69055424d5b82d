"""Frames: curves across and along a body, through a common grid of nodes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import pointer, reals_of
from ._call import Progress
from ._exchange import index, vector
from ._handles import Reported, create
from ._keywords import options as structs
from ._library import ffi, number_of
from ._options import FrameOptions, Unpack
from ._outlines import sections_of
from ._reports import FrameView
from .choices import OffsetDirection
from .outline import Curve, Outline

__all__ = ["Frame"]


class Frame(Reported[FrameView]):
    """A grid of nodes on a body, with a curve across through each row and a curve along through each column.

    Args:
        sections: consecutive outlines of the body, each (n, 2) or (n, 3).
        closed: whether each section returns to its first point.
        options: see :class:`~gusset_mesh.FrameOptions`, such as ``correspondence="arc_length", columns=32``.

    >>> import numpy as np
    >>> angle = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    >>> rings = [np.stack([np.cos(angle), np.sin(angle), 0 * angle + z], axis=1) for z in (0, 1, 2)]
    >>> frame = Frame(rings, closed=True)
    >>> frame.nodes.shape, round(frame.curve_along(0).length, 6)
    ((3, 12, 3), 2.0)
    """

    REPORT = FrameView

    def __init__(
        self, sections: Sequence[ArrayLike], closed: bool = False, *, threads: int = 0, progress: Optional[Progress] = None,
        **options: Unpack[FrameOptions],
    ):
        super().__init__(create("frame", sections_of(sections, closed), structs("frame_options", options), threads=threads, progress=progress))

    @property
    def nodes(self) -> NDArray[np.float64]:
        """(rows, columns, 3): a row for each section."""
        return self.report.nodes

    def curve_across(self, row: int) -> Curve:
        """Returns the curve through the nodes of a section."""
        return Curve(create("curve", self.report._struct.curves_across, index(row, "row", 64), name="outline_curve"))

    def curve_along(self, column: int) -> Curve:
        """Returns the curve along the body through the nodes of a column."""
        return Curve(create("curve", self.report._struct.curves_along, index(column, "column", 64), name="outline_curve"))

    def offset(
        self, distances: ArrayLike, direction: OffsetDirection = "normal", *, threads: int = 0, progress: Optional[Progress] = None
    ) -> Frame:
        """Makes the offset of the frame. Distances: one for all nodes, one for each section, or (rows, columns).

        >>> import numpy as np
        >>> angle = np.linspace(0, 2 * np.pi, 12, endpoint=False)
        >>> rings = [np.stack([np.cos(angle), np.sin(angle), 0 * angle + z], axis=1) for z in (0, 1, 2)]
        >>> bool(np.allclose(np.hypot(*Frame(rings, closed=True).offset(0.5).nodes[..., :2].T), 1.5))
        True
        """
        given = np.ascontiguousarray(reals_of(distances)).reshape(-1)
        made = Frame.__new__(Frame)
        which = number_of("gusset_offset_direction", "direction", direction)
        Reported.__init__(made, create("frame", self._handle, ffi.cast("double *", pointer(given)), len(given), which, name="frame_offset",
                                       threads=threads, progress=progress))
        return made

    def slice(self, point: ArrayLike, normal: ArrayLike) -> Outline:
        """Makes a new section through the points where a plane cuts the curves along."""
        made = Outline.__new__(Outline)
        Reported.__init__(made, create("outline", self._handle, vector(point, "point"), vector(normal, "normal"), name="frame_slice"))
        return made
