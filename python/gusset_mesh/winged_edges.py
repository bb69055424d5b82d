"""Makes winged-edge tables of meshes, in Baumgart's notation, and meshes from such tables.

The package omits the other functions of ``gusset/papers.h``, the searches of the papers: :class:`Surface` answers the same queries faster.
"""

from __future__ import annotations

from typing import Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import indices_of
from ._call import Progress
from ._exchange import index
from ._handles import Reported, create
from ._keywords import options as structs
from ._library import ffi
from ._options import Unpack, WingedOptions
from ._records import indices_struct
from ._reports import WingedEdgeArray, WingedFacesView, WingedView
from .mesh import Mesh, MeshLike, as_mesh, view_of

__all__ = ["Winged", "WingedFaces", "winged", "winged_faces"]


class Winged(Reported[WingedView]):
    """The winged-edge tables of a mesh, and its boundary loops."""

    REPORT = WingedView

    @property
    def edges(self) -> WingedEdgeArray:
        """The edges in Baumgart's notation; 2^32 - 1 is NULL."""
        return self.report.edges

    @property
    def loops(self) -> list[NDArray[np.uint32]]:
        """The vertices of the boundary loops, with the surface on the left."""
        offsets, vertices = self.report.loop_offsets, self.report.loop_vertices
        return [vertices[offsets[k]:offsets[k + 1]] for k in range(len(offsets) - 1)]


def winged(mesh: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[WingedOptions]) -> Winged:
    """Makes the winged-edge tables of a mesh, and finds its boundary loops.

    >>> len(winged(([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])).edges)
    5
    """
    return Winged(create("winged", view_of(as_mesh(mesh)), structs("winged_options", options), threads=threads, progress=progress))


class WingedFaces(Reported[WingedFacesView]):
    """The faces of a winged-edge table."""

    REPORT = WingedFacesView

    def mesh(self, points: ArrayLike) -> Mesh:
        """Makes the mesh of these faces through points (n, 3)."""
        return Mesh.from_polygons(points, self.report.face_offsets, self.report.face_corners)


def winged_faces(
    edges: WingedEdgeArray, vertex_count: int, first_edges: Optional[ArrayLike] = None, *, threads: int = 0, progress: Optional[Progress] = None,
    **options: Unpack[WingedOptions],
) -> WingedFaces:
    """Reads the faces of a winged-edge table, and checks the records against each other.

    Args:
        edges: as :attr:`Winged.edges`.
        vertex_count: exceeds every vertex of an edge.
        first_edges: for each face, the edge where it begins; None: the lowest edge.

    Raises:
        InputError: a record contradicts another; ``index`` is the edge.
    """
    if not isinstance(edges, WingedEdgeArray):
        raise TypeError(f"edges are a WingedEdgeArray, not a {type(edges).__name__}")
    packed = WingedEdgeArray(np.ascontiguousarray(edges.array).reshape(-1))
    first, given = ffi.NULL, None
    if first_edges is not None:
        given = indices_of(first_edges, "first_edges").reshape(-1)
        first = ffi.new("struct gusset_indices *", indices_struct(given))
    return WingedFaces(create("winged_faces", packed.pointer(), len(packed), index(vertex_count, "vertex_count", 64),
                              first, structs("winged_options", options), threads=threads, progress=progress))
