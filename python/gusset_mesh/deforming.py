"""Moves the nodes of nets: fields, affine maps, morphs, planar cells."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import real
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
        """Deforms the net by fields, in the given order.

        Args:
            fields: of :mod:`gusset_mesh.fields`.
            time: time of fields with keys. For animation, deform the net at rest each time.

        Raises:
            InputError: a field is not defined at a node, which ``index`` names.

        >>> import numpy as np, gusset_mesh as gm
        >>> strip = gm.Net.primitive(shape="plane", size=(1, 2 * np.pi, 1), rows=65, columns=2)
        >>> ring = strip.deform(gm.fields.wrap_cylinder("x", 1.0))
        >>> bool(np.allclose(np.hypot(ring.nodes[..., 1], ring.nodes[..., 2]), 1))
        True
        """
        chain, count = fields_of(fields)
        return self._changed(lib.gusset_net_deform, chain, count, real(time), threads=threads, progress=progress)

    def transform(self, *matrices: ArrayLike) -> Self:
        """Applies affine maps, in the given order. The faces of a mirrored net keep looking outwards.

        Args:
            matrices: (3, 4), or (4, 4) with the last row 0, 0, 0, 1.
        """
        return self._operated(*({"kind": lib.GUSSET_OPERATION_MATRIX, "values": affine_rows(one)} for one in matrices))

    def translate(self, by: ArrayLike) -> Self:
        """Translates the net by a vector."""
        return self._operated({"kind": lib.GUSSET_OPERATION_TRANSLATE, "values": vector(by)})

    def rotate(self, direction: ArrayLike, angle: float, point: ArrayLike = (0.0, 0.0, 0.0)) -> Self:
        """Rotates the net, right-handed, about the axis through a point along a direction."""
        values = [*vector(direction, "direction"), real(angle), *vector(point, "point")]
        return self._operated({"kind": lib.GUSSET_OPERATION_ROTATE, "values": values})

    def scale(self, ratio: ArrayLike) -> Self:
        """Scales the net about the origin, by one number, or by three for x, y and z."""
        if np.ndim(ratio) == 0:
            return self._operated({"kind": lib.GUSSET_OPERATION_SCALE, "values": [real(ratio)]})
        return self._operated({"kind": lib.GUSSET_OPERATION_STRETCH, "values": vector(ratio, "ratio")})

    def compress(self, axis: Axis, ratio: float) -> Self:
        """Scales distances from an axis."""
        return self._operated({"kind": lib.GUSSET_OPERATION_COMPRESS, "axis": number_of("gusset_axis", "axis", axis), "values": [real(ratio)]})

    def _operated(self, *operations: dict[str, Any]) -> Self:
        return self._changed(lib.gusset_net_transform, ffi.new("struct gusset_operation[]", list(operations) or 1), len(operations))

    def displace(self, distance: float) -> Self:
        """Moves every node along its normal. Nodes without a normal stay.

        >>> import numpy as np, gusset_mesh as gm
        >>> ball = gm.Net.primitive(shape="sphere", radius=1).displace(0.5)
        >>> bool(np.allclose(np.linalg.norm(ball.nodes, axis=2), 1.5, atol=1e-3))
        True
        """
        return self._changed(lib.gusset_net_displace, real(distance))

    def morph(
        self, other: Self, t: float, path: MorphPath = "linear", *, threads: int = 0, progress: Optional[Progress] = None
    ) -> Self:
        """Interpolates between this net (t = 0) and another one (t = 1).

        Args:
            other: a net of the same size and gluing.
            path: ``"rigid"`` rotates the net as a whole: a rigidly moved net keeps its shape.
        """
        kind = number_of("gusset_morph_path", "path", path)
        return self._of(create("net", self._handle, handle_of("net", other), real(t), kind, name="net_morph", threads=threads,
                               progress=progress))

    def planarise(
        self, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[PlanariseOptions]
    ) -> tuple[Self, PlanariseReport]:
        """Moves nodes until all cells are planar, with locally least squared displacement.

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
