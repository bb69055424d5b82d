"""Analyses nets: normals, planarity, topology, defects, and the effects of a deformation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

from ._arrays import pointer, real
from ._call import Progress, call
from ._exchange import handle_of, sized
from ._handles import Reported, create
from ._library import ffi, lib, number_of
from ._net_handle import NetHandle
from ._reports import NetAnalysisView, NetComplexView, NetPlanarityReport, NetValidationView
from .choices import NetCells
from .fields import Field, fields_of

__all__ = ["NetAnalysis", "NetComplex", "NetValidation"]


class NetAnalysis(Reported[NetAnalysisView]):
    """The effects of a deformation: ratios of lengths and areas; contracted, torn and folded elements."""

    REPORT = NetAnalysisView

    @property
    def is_soft(self) -> bool:
        """Whether nothing is newly glued, torn or folded."""
        return self.report.soft


class NetComplex(Reported[NetComplexView]):
    """The surface of a net with glued nodes merged: counts, Euler characteristic, genus, boundary, defects."""

    REPORT = NetComplexView

    @property
    def is_closed(self) -> bool:
        """Whether it lacks boundary edges."""
        return "closed" in self.report.properties

    @property
    def is_manifold(self) -> bool:
        """Whether it lacks wires, branches and pinches. It may have a boundary."""
        return "manifold" in self.report.properties

    @property
    def is_oriented(self) -> bool:
        """Whether its faces are oriented consistently."""
        return "oriented" in self.report.properties

    @property
    def is_orientable(self) -> bool:
        """Whether its faces are consistent after reversal of some."""
        return "orientable" in self.report.properties


class NetValidation(Reported[NetValidationView]):
    """The findings of a validation: violations, then warnings."""

    REPORT = NetValidationView

    @property
    def is_valid(self) -> bool:
        """Whether all glued nodes coincide."""
        return not self.report.violation_count


class NetAnalysing(NetHandle):
    """The part of :class:`Net` that analyses it."""

    def normals(self, *, threads: int = 0, progress: Optional[Progress] = None) -> NDArray[Any]:
        """Computes the unit normals (rows, columns, 3) of all nodes. Glued nodes have one normal; a node without a normal gets zeros.

        >>> import numpy as np, gusset_mesh as gm
        >>> ball = gm.Net.primitive(shape="sphere", radius=2, rows=65, columns=129)
        >>> bool(np.allclose(ball.normals(), ball.nodes / 2, atol=0.01))
        True
        """
        rows, columns = self.shape
        out = np.zeros((3, rows, columns), self.dtype)
        call(lib.gusset_net_normals, self._handle, *(pointer(one) for one in out), rows * columns, ffi.NULL, threads=threads, progress=progress)
        return np.moveaxis(out, 0, 2)

    def planarity(
        self, tolerance: float = 0.0, *, threads: int = 0, progress: Optional[Progress] = None
    ) -> tuple[NDArray[np.float64], NetPlanarityReport]:
        """Measures the planarity of all cells: distance of the corners from their mean plane, divided by the longer diagonal.

        Args:
            tolerance: the report counts the cells above it.

        Returns:
            (rows - 1, columns - 1) deviations, NaN for absent cells, and a report.
        """
        rows, columns = self.shape
        cells, written, report = np.zeros((rows - 1, columns - 1)), ffi.new("size_t *"), NetPlanarityReport.new()
        call(lib.gusset_net_planarity, self._handle, real(tolerance), ffi.cast("double *", pointer(cells)), cells.size, written, report._struct,
             threads=threads, progress=progress)
        return cells, report

    def complex(self, cells: NetCells = "all", *, threads: int = 0, progress: Optional[Progress] = None) -> NetComplex:
        """Determines the surface with glued nodes merged, of all cells or of those that are present.

        >>> import gusset_mesh as gm
        >>> bottle = gm.Net.primitive(shape="klein", radius=2, minor_radius=0.7).complex()
        >>> bottle.is_closed, bottle.is_orientable, bottle.report.euler
        (True, False, 0)
        """
        return NetComplex(create("net_complex", self._handle, number_of("gusset_net_cells", "cells", cells), threads=threads, progress=progress))

    def validation(self, tolerance: float = 0.0, *, threads: int = 0, progress: Optional[Progress] = None) -> NetValidation:
        """Checks that glued nodes coincide within a tolerance, and warns of suspicious gluing."""
        return NetValidation(create("net_validation", self._handle, real(tolerance), threads=threads, progress=progress))

    def analysis(
        self, after: Optional[NetHandle] = None, *, fields: Sequence[Field] = (), time: float = 0.0, tolerance: float = 0.0, threads: int = 0,
        progress: Optional[Progress] = None,
    ) -> NetAnalysis:
        """Finds what a deformation glues, tears, folds and stretches.

        Args:
            after: deformed net of equal size; None: ``fields`` deform this net.
            fields, time: as for :meth:`Net.deform`.
            tolerance: lengths up to this count as 0.
        """
        chain, count = fields_of(fields)
        given = sized("gusset_net_analysis_options", fields=chain, field_count=count, time=real(time), tolerance=real(tolerance))
        if after is not None:
            given.after = handle_of("net", after)
        return NetAnalysis(create("net_analysis", self._handle, given, threads=threads, progress=progress))
