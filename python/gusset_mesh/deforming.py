"""Nets in other shapes: fields, affine maps, morphs, planar cells."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._call import Progress
from ._exchange import answer, handle_of, vector
from ._handles import create
from ._keywords import options as structs
from ._library import ffi, lib, number_of
from ._net_handle import NetHandle
from ._options import PlanariseOptions, Unpack
from ._reports import PlanariseReport
from .choices import Axis, MorphPath
from .fields import Field, affine_rows, fields_of

if TYPE_CHECKING:
    from typing_extensions import Self


class NetDeforming(NetHandle):
    """The part of :class:`Net` that moves nodes. Every method returns another net."""

    def deform(self, *fields: Field, time: float = 0.0, threads: int = 0, progress: Optional[Progress] = None) -> Self:
        """Moves all nodes by fields, one after the other.

        Args:
            fields: of :mod:`gusset_mesh.fields`.
            time: for fields with keys. To animate, deform the net at rest again.

        Raises:
            InputError: a field is not defined at a node, which ``index`` names.

        >>> import numpy as np, gusset_mesh as gm
        >>> strip = gm.Net.primitive(shape="plane", size=(1, 2 * np.pi, 1), rows=65, columns=2)
        >>> ring = strip.deform(gm.fields.wrap_cylinder("x", 1.0))
        >>> bool(np.allclose(np.hypot(ring.nodes[..., 1], ring.nodes[..., 2]), 1))
        True
        """
        chain, count = fields_of(fields)
        return self._changed(lib.gusset_net_deform, chain, count, float(time), threads=threads, progress=progress)

    def transform(self, *matrices: ArrayLike) -> Self:
        """Moves all nodes by affine maps, one after the other; a mirrored net keeps its faces outwards.

        Args:
            matrices: (3, 4), or (4, 4) with the last row 0, 0, 0, 1.
        """
        return self._operated(*({"kind": lib.GUSSET_OPERATION_MATRIX, "values": affine_rows(one)} for one in matrices))

    def translate(self, by: ArrayLike) -> Self:
        """Moves all nodes by a vector."""
        return self._operated({"kind": lib.GUSSET_OPERATION_TRANSLATE, "values": vector(by)})

    def rotate(self, direction: ArrayLike, angle: float, point: ArrayLike = (0.0, 0.0, 0.0)) -> Self:
        """Turns the net by the right hand about the axis through a point along a direction."""
        return self._operated({"kind": lib.GUSSET_OPERATION_ROTATE, "values": [*vector(direction, "direction"), float(angle), *vector(point, "point")]})

    def scale(self, ratio: ArrayLike) -> Self:
        """Scales about the origin: by one number, or by three for x, y and z."""
        if np.ndim(ratio) == 0:
            return self._operated({"kind": lib.GUSSET_OPERATION_SCALE, "values": [float(np.asarray(ratio))]})
        return self._operated({"kind": lib.GUSSET_OPERATION_STRETCH, "values": vector(ratio, "ratio")})

    def compress(self, axis: Axis, ratio: float) -> Self:
        """Scales distances from an axis."""
        return self._operated({"kind": lib.GUSSET_OPERATION_COMPRESS, "axis": number_of("gusset_axis", "axis", axis), "values": [float(ratio)]})

    def _operated(self, *operations: dict[str, Any]) -> Self:
        return self._changed(lib.gusset_net_transform, ffi.new("struct gusset_operation[]", list(operations) or 1), len(operations))

    def displace(self, distance: float) -> Self:
        """Moves every node along its normal; nodes without a normal stay.

        >>> import numpy as np, gusset_mesh as gm
        >>> ball = gm.Net.primitive(shape="sphere", radius=1).displace(0.5)
        >>> bool(np.allclose(np.linalg.norm(ball.nodes, axis=2), 1.5, atol=1e-3))
        True
        """
        return self._changed(lib.gusset_net_displace, float(distance))

    def morph(self, other: Self, t: float, path: MorphPath = "linear") -> Self:
        """The net between two: this one at t = 0, the other one at 1.

        Args:
            other: a net of the same size and gluing.
            path: ``"rigid"`` turns the net as a whole, so that a net that only moved keeps its shape.
        """
        return self._of(create("net", self._handle, handle_of("net", other), float(t), number_of("gusset_morph_path", "path", path), name="net_morph"))

    def planarise(
        self, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[PlanariseOptions]
    ) -> tuple[Self, PlanariseReport]:
        """Moves nodes as little as possible until all cells are planar.

        Args:
            options: ``fixed`` may be (rows, columns) truth values.

        Returns:
            the net, and a report: ``converged``, ``deviation_after``, ``max_displacement`` and more.

        >>> import numpy as np, gusset_mesh as gm
        >>> u, v = np.meshgrid(np.linspace(0, 1, 6), np.linspace(0, 1, 6), indexing="ij")
        >>> flat, report = gm.Net(np.stack([u, v, u * v], axis=2)).planarise()
        >>> bool(flat.planarity()[1].worst < 1e-9)
        True
        """
        if options.get("fixed") is not None:
            fixed = np.asarray(options["fixed"]).reshape(-1)
            options = {**options, "fixed": fixed.astype(bool)}
        copy = self._copied()
        return copy, answer(PlanariseReport, lib.gusset_net_planarise, copy._handle, structs("planarise_options", options),
                            threads=threads, progress=progress)
