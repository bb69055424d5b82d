"""Polygon meshes as numpy arrays, which the library reads in place."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import SCALARS, indices_of, pointer, points_of
from ._call import call
from ._library import F32, ffi, holding, lib
from ._polydata import polygons_of, surface_of
from ._records import lent

__all__ = ["Mesh", "MeshLike", "as_mesh"]


class Mesh:
    """A polygon mesh: points and faces.

    Args:
        points: (n, 3). Arrays of 32- or 64-bit floats with packed rows are not copied.
        faces: (m, k) for m faces of k corners, or a sequence of faces of any number of corners; vertices count from 0.
            Arrays of 32-bit integers are not copied.
        merge: the representative of each vertex, for vertices that are separate at seams; or None.

    >>> quad = Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]])
    >>> quad.vertex_count, quad.face_count
    (4, 1)
    """

    __slots__ = ("points", "corners", "offsets", "face_size", "merge", "__weakref__")

    #: (n, 3).
    points: NDArray[Any]
    #: Vertex of each corner, face by face.
    corners: NDArray[np.uint32]
    #: First corner of each face, and the end of the last; None if every face has ``face_size`` corners.
    offsets: Optional[NDArray[np.uint32]]
    #: Number of corners of every face; 0 with ``offsets``.
    face_size: int
    merge: Optional[NDArray[np.uint32]]

    def __init__(self, points: ArrayLike, faces: Union[ArrayLike, Iterable[Sequence[int]]], *, merge: Optional[ArrayLike] = None):
        self.points = points_of(points)
        self.offsets = None
        self.face_size = 0
        try:
            array = np.asarray(faces)
        except ValueError:  # faces of different sizes
            array = np.empty(0, object)
        if array.ndim == 2 and array.dtype != object:
            self.corners = indices_of(array, "faces").reshape(-1)
            self.face_size = array.shape[1]
        elif array.dtype == object or array.size == 0:
            lists = [indices_of(face, "faces").reshape(-1) for face in faces]  # type: ignore[union-attr]
            self.offsets = np.zeros(len(lists) + 1, np.uint32)
            np.cumsum([len(face) for face in lists], out=self.offsets[1:])
            self.corners = np.concatenate(lists) if lists else np.empty(0, np.uint32)
        else:
            raise ValueError(f"faces have the shape {array.shape}, not (m, k)")
        self._merged(merge)

    @classmethod
    def from_polygons(cls, points: ArrayLike, offsets: ArrayLike, corners: ArrayLike, *, merge: Optional[ArrayLike] = None) -> Mesh:
        """Makes a mesh of faces in one array: face f has the corners ``offsets[f]`` to ``offsets[f + 1] - 1``."""
        made = cls.__new__(cls)
        made.points = points_of(points)
        # The copy protects the last offset: the library reads that number of corners.
        made.offsets = indices_of(offsets, "offsets").reshape(-1).copy()
        made.corners = indices_of(corners, "corners").reshape(-1)
        made.face_size = 0
        if made.offsets.size == 0 or made.offsets[-1] != made.corners.size:
            last = made.offsets[-1] if made.offsets.size else "missing"
            raise ValueError(f"the last offset is {last}, not {made.corners.size}, the number of corners")
        made._merged(merge)
        return made

    def _merged(self, merge: Optional[ArrayLike]) -> None:
        self.merge = None if merge is None else indices_of(merge, "merge")
        if self.merge is not None and self.merge.shape != (len(self.points),):
            raise ValueError(f"merge has the shape {self.merge.shape}, not ({len(self.points)},)")

    @property
    def vertex_count(self) -> int:
        return len(self.points)

    @property
    def face_count(self) -> int:
        if self.offsets is not None:
            return len(self.offsets) - 1
        return len(self.corners) // self.face_size if self.face_size else 0

    @property
    def faces(self) -> Union[NDArray[np.uint32], list[NDArray[np.uint32]]]:
        """(m, k) if all faces have k corners, else a list of arrays."""
        if self.offsets is None:
            return self.corners.reshape(-1, self.face_size) if self.face_size else self.corners.reshape(-1, 3)
        sizes = np.diff(self.offsets)
        if sizes.size and (sizes == sizes[0]).all():
            return self.corners.reshape(-1, int(sizes[0]))
        return np.split(self.corners, self.offsets[1:-1]) if sizes.size else []

    def triangles(self) -> NDArray[np.uint32]:
        """(m, 3): the faces, with polygons split into triangles of their own corners. Concave polygons keep their area."""
        if self.offsets is None and self.face_size == 3:
            return self.corners.reshape(-1, 3)
        if self.face_count == 0:
            return np.empty((0, 3), np.uint32)
        made = ffi.new("struct gusset_result **")
        call(lib.gusset_triangulate, view_of(self), made)
        result = ffi.gc(made[0], lib.gusset_result_destroy)
        view = ffi.new("struct gusset_mesh_view *")
        view.struct_size = ffi.sizeof("struct gusset_mesh_view")
        status = lib.gusset_result_get_mesh(result, view)
        assert status == 0
        return lent_mesh(view, result).corners.reshape(-1, 3).copy()

    def with_points(self, points: ArrayLike) -> Mesh:
        """A mesh with the same faces and other points."""
        made = Mesh.__new__(Mesh)
        made.points = points_of(points)
        if len(made.points) != len(self.points):
            raise ValueError(f"{len(made.points)} points for {len(self.points)} vertices: pass one for each")
        made.corners, made.offsets, made.face_size, made.merge = self.corners, self.offsets, self.face_size, self.merge
        return made

    def __repr__(self) -> str:
        return f"<Mesh of {self.vertex_count} vertices and {self.face_count} faces>"


def from_polydata(polydata: Any) -> Mesh:
    """Makes a mesh of the polygons of a vtkPolyData, or of PyVista's PolyData. Points are not copied.

    Raises:
        ValueError: the data have triangle strips; ``triangulate()`` makes triangles of them.
    """
    points, offsets, corners = polygons_of(polydata)
    sizes = np.diff(offsets)
    if sizes.size and (sizes == sizes[0]).all():
        return Mesh(points, corners.reshape(-1, int(sizes[0])))
    return Mesh.from_polygons(points, offsets if offsets.size else np.zeros(1, np.uint32), corners)


#: A :class:`Mesh`, points and faces, an object with a mesh (a result, a document of a file), or a mesh of trimesh, PyVista, meshio, Open3D or
#: OpenMesh.
MeshLike = Union[Mesh, tuple[Any, Any], Any]


def as_mesh(given: MeshLike) -> Mesh:
    """Converts a mesh of another library, or points and faces. Takes the mesh of a result or document. Arrays are copied only if they must be.

    >>> as_mesh(([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    <Mesh of 3 vertices and 1 faces>
    """
    if isinstance(given, Mesh):
        return given
    if isinstance(given, (tuple, list)) and len(given) == 2:
        return Mesh(*given)
    if hasattr(given, "GetPolys"):  # vtkPolyData, and so PyVista's
        return from_polydata(given)
    if hasattr(given, "extract_surface"):  # PyVista's other datasets
        return as_mesh(surface_of(given))
    if callable(getattr(given, "face_vertex_indices", None)):  # OpenMesh
        faces = given.face_vertex_indices()
        return Mesh(given.points(), faces if (faces >= 0).all() else [face[face >= 0] for face in faces])
    for points, faces in (("vertices", "faces"), ("vertices", "triangles")):  # trimesh; Open3D
        if hasattr(given, points) and hasattr(given, faces):
            return Mesh(np.asarray(getattr(given, points)), np.asarray(getattr(given, faces)))
    within = getattr(given, "mesh", None)
    if isinstance(within, Mesh):  # results; documents and meshes of files
        return within
    if hasattr(given, "points") and hasattr(given, "cells"):  # meshio
        kept = [block.data for block in given.cells if block.type in ("triangle", "quad", "polygon")]
        return Mesh(given.points, kept[0] if len(kept) == 1 else [face for block in kept for face in block])
    raise TypeError(f"{type(given).__name__} is not a mesh: pass points and faces, or a mesh of trimesh, PyVista, meshio, Open3D or OpenMesh")


def _require(mesh: Mesh) -> None:
    """Checks the attributes again, which may have been replaced since the construction."""
    points, lists = mesh.points, [one for one in (mesh.corners, mesh.offsets, mesh.merge) if one is not None]
    if not isinstance(points, np.ndarray) or points.dtype not in SCALARS or points.ndim != 2 or points.shape[1] != 3:
        raise ValueError("points must be an array of floats of the shape (n, 3)")
    if points.size and (points.strides[1] != points.itemsize or points.strides[0] < 3 * points.itemsize):
        raise ValueError("x, y and z of a point must be adjacent in memory: use numpy.ascontiguousarray")
    if any(not isinstance(one, np.ndarray) or one.dtype != np.uint32 or one.ndim != 1 or not one.flags.c_contiguous for one in lists):
        raise ValueError("corners, offsets and merge must be packed arrays of unsigned 32-bit integers")
    if mesh.offsets is not None and (mesh.offsets.size == 0 or mesh.offsets[-1] > mesh.corners.size):
        last = mesh.offsets[-1] if mesh.offsets.size else "missing"
        raise ValueError(f"the last offset is {last}; it must be at most {mesh.corners.size}, the number of corners")
    if mesh.merge is not None and len(mesh.merge) != len(points):
        raise ValueError(f"merge has {len(mesh.merge)} numbers for {len(points)} vertices: give one for each")


def fill_view(view: Any, mesh: Mesh) -> None:
    """Fills a gusset_mesh_view, or a gusset_plugin_mesh, from a mesh, which must stay alive."""
    _require(mesh)
    # Empty arrays have addresses too, because NULL would say that the array is missing.
    view.struct_size = ffi.sizeof(ffi.typeof(view).item if ffi.typeof(view).kind == "pointer" else ffi.typeof(view))
    view.positions = pointer(mesh.points)
    view.position_stride = mesh.points.strides[0] if mesh.points.size else 0
    view.vertex_count = len(mesh.points)
    view.face_offsets = pointer(mesh.offsets)
    view.face_corners = pointer(mesh.corners)
    view.face_count = mesh.face_count
    view.scalar = SCALARS[mesh.points.dtype]
    view.face_size = mesh.face_size if mesh.offsets is None else 0
    view.merge = pointer(mesh.merge)


def view_of(mesh: Mesh) -> Any:
    """A gusset_mesh_view that keeps its mesh alive."""
    view = ffi.new("struct gusset_mesh_view *")
    fill_view(view, mesh)
    return holding(view, mesh)


def of_one_precision(given: Iterable[MeshLike]) -> list[Mesh]:
    """Converts meshes; if some have 64-bit points, all get 64-bit points."""
    meshes = [as_mesh(one) for one in given]
    wide = np.dtype(np.float64)
    if len({mesh.points.dtype for mesh in meshes}) > 1:
        meshes = [mesh if mesh.points.dtype == wide else mesh.with_points(mesh.points.astype(wide)) for mesh in meshes]
    return meshes


def views_of(meshes: Sequence[Mesh]) -> Any:
    """An array of gusset_mesh_view that keeps the meshes alive."""
    views = ffi.new("struct gusset_mesh_view[]", len(meshes))
    for k, mesh in enumerate(meshes):
        fill_view(ffi.addressof(views, k), mesh)
    return holding(views, meshes)


def lent_mesh(view: Any, owner: object) -> Mesh:
    """A mesh of the arrays that the library lends in a view; they keep their owner alive."""
    made = Mesh.__new__(Mesh)
    dtype = np.float32 if view.scalar == F32 else np.float64
    made.points = lent(view.positions, (view.vertex_count, 3), dtype, owner)
    made.face_size = 0
    made.merge = lent(view.merge, (view.vertex_count,), np.uint32, owner) if view.merge else None
    if view.face_offsets:
        made.offsets = lent(view.face_offsets, (view.face_count + 1,), np.uint32, owner)
        count = int(made.offsets[-1])
    else:
        made.offsets, made.face_size = None, view.face_size
        count = view.face_count * view.face_size
    made.corners = lent(view.face_corners, (count,), np.uint32, owner)
    return made
