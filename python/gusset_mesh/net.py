"""Regular nets of quads: rows and columns of nodes, with sides that may be glued."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import floats_of, pointer
from ._call import Progress, call
from ._handles import Result, create, result
from ._keywords import options as structs
from ._library import bits_of, ffi, lib
from ._options import ConcatenateOptions, NetMeshOptions, Unpack
from ._reports import NetMeasureReport, NetMeshReport
from .analysing import NetAnalysing
from .bridges import NetBridges
from .choices import NUMBERS, NetMeasures, Sides
from .deforming import NetDeforming
from .encoding import NetEncoding
from .gluing import NetGluing
from .mesh import MeshLike, as_mesh, view_of
from .reshaping import NetReshaping

__all__ = ["Net", "NetMesh"]


class NetMesh(Result[NetMeshReport]):
    """The mesh of a net."""

    REPORT = NetMeshReport


class Net(NetReshaping, NetDeforming, NetGluing, NetBridges, NetAnalysing, NetEncoding):
    """A regular net.

    Args:
        nodes: (rows, columns, 3), 32- or 64-bit floats; NaN where a node is missing.
        sides: the sides that are glued, such as ``"torus"`` or ``["rows_closed", "pole_top"]``.

    >>> import numpy as np
    >>> u, v = np.meshgrid(np.linspace(0, 1, 5), np.linspace(0, 2, 9), indexing="ij")
    >>> plane = Net(np.stack([u, v, 0 * u], axis=2))
    >>> plane.measure().area, plane.mesh().mesh.face_count
    (2.0, 32)
    """

    def __init__(self, nodes: ArrayLike, sides: Union[Sides, Sequence[Sides]] = "sheet"):
        array = floats_of(nodes)
        if array.ndim != 3 or array.shape[2] != 3:
            raise ValueError(f"nodes have the shape {array.shape}, not (rows, columns, 3)")
        # Nodes that share memory or run backwards are copied.
        spans = sum((n - 1) * stride for n, stride in zip(array.shape, array.strides)) + array.itemsize
        if array.size and (min(array.strides) <= 0 or spans < array.nbytes):
            array = np.ascontiguousarray(array)
        view = ffi.new("struct gusset_net_view *")
        view.struct_size = ffi.sizeof("struct gusset_net_view")
        view.rows, view.columns = array.shape[:2]
        if array.size:
            start = array.ctypes.data
            view.x, view.y, view.z = (ffi.cast("void *", start + k * array.strides[2]) for k in range(3))
            view.row_stride, view.column_stride = array.strides[:2]
        view.scalar = lib.GUSSET_F32 if array.dtype == np.float32 else lib.GUSSET_F64
        glued = ffi.new("struct gusset_net_gluing *")
        glued.struct_size = ffi.sizeof("struct gusset_net_gluing")
        glued.sides = bits_of(NUMBERS["gusset_sides"], "sides", sides)
        super().__init__(create("net", view, glued, lib.GUSSET_NET_MEMORY_COPY))

    @classmethod
    def from_heights(
        cls, heights: ArrayLike, spacing: Sequence[float] = (1.0, 1.0), origin: Sequence[float] = (0.0, 0.0, 0.0),
        no_data: Optional[float] = None
    ) -> Net:
        """Makes a net of a grid of heights (rows, columns). NaN and ``no_data`` mark missing nodes."""
        array = floats_of(heights)
        if array.ndim != 2:
            raise ValueError(f"heights have the shape {array.shape}, not (rows, columns)")
        if array.size and (array.strides[1] != array.itemsize or array.strides[0] < array.shape[1] * array.itemsize):
            array = np.ascontiguousarray(array)
        given = ffi.new("struct gusset_heights *")
        given.struct_size = ffi.sizeof("struct gusset_heights")
        given.rows, given.columns = array.shape
        given.values, given.row_stride = pointer(array), array.strides[0] if array.size else 0
        given.spacing, given.origin = list(spacing), list(origin)
        if no_data is not None:
            given.no_data, given.has_no_data = no_data, 1
        given.scalar = lib.GUSSET_F32 if array.dtype == np.float32 else lib.GUSSET_F64
        return cls._of(create("net", given, name="net_from_heights"))

    @classmethod
    def from_mesh(cls, mesh: MeshLike, face: int = 0) -> Net:
        """Makes a net of the quads of a mesh, starting from a face."""
        given = ffi.new("struct gusset_net_grid_options *")
        given.struct_size = ffi.sizeof("struct gusset_net_grid_options")
        given.has_face, given.face = 1, face
        return cls._of(create("net", view_of(as_mesh(mesh)), given, ffi.NULL, name="net_from_mesh"))

    def measure(self, measures: Union[NetMeasures, Iterable[NetMeasures]] = "extent") -> NetMeasureReport:
        """Measures area, volume, area vector and bounding box; with other words bilinear patches, or the body that a closed net encloses."""
        made = NetMeasureReport.new()
        call(lib.gusset_net_measure, self._handle, bits_of(NUMBERS["gusset_net_measures"], "measures", measures), made._struct)
        return made

    def mesh(self, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[NetMeshOptions]) -> NetMesh:
        """Makes a mesh of quads or triangles. Glued nodes become one vertex."""
        return NetMesh(result("net_to_mesh", self._handle, structs("net_mesh_options", options), threads=threads, progress=progress))

    @classmethod
    def concatenate(cls, nets: Sequence[Net], **options: Unpack[ConcatenateOptions]) -> Net:
        """Places nets beside each other, with bridges between them."""
        handles = ffi.new("struct gusset_net *[]", [net._handle for net in nets])
        return cls._of(create("net", handles, len(nets), structs("concatenate_options", options), name="net_concatenate"))

    def __repr__(self) -> str:
        return f"<Net of {self.shape[0]} x {self.shape[1]} nodes>"
