"""Cuts meshes by planes into ordered polylines."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, Optional, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import pointer
from ._call import Progress
from ._exchange import numbers, vector
from ._handles import Origins, Reported, create
from ._keywords import options as structs
from ._library import ffi, holding, lib
from ._options import MeshSectionOptions, Unpack
from ._reports import MeshSectionsView, SectionPathArray
from .mesh import MeshLike, as_mesh, view_of
from .querying import Plane

__all__ = ["MeshSections", "sections", "sections_about_axis", "sections_across", "sections_by_planes"]


class MeshSections(Reported[MeshSectionsView], Sequence[NDArray[np.float64]]):
    """The polylines in which planes meet a mesh: each is (n, 3). A closed one does not repeat its first point.

    ``report`` has the edge, the parameter and the face of each point.
    """

    REPORT = MeshSectionsView

    def __len__(self) -> int:
        return len(self.report.paths)

    @overload
    def __getitem__(self, index: int) -> NDArray[np.float64]: ...

    @overload
    def __getitem__(self, index: slice) -> list[NDArray[np.float64]]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[NDArray[np.float64], list[NDArray[np.float64]]]:
        places = range(len(self))[index]
        if isinstance(places, range):
            return [self[k] for k in places]
        start, end = self.report.starts[places:places + 2]
        return self.report.points[start:end]

    @property
    def paths(self) -> SectionPathArray:
        """The plane, the nesting, the length and the area of each polyline."""
        return self.report.paths

    @property
    def closed(self) -> NDArray[np.bool_]:
        """Whether each polyline returns to its first point."""
        return self.report.paths.closed

    @property
    def planes(self) -> NDArray[np.uint32]:
        """The number of the plane of each polyline."""
        return self.report.paths.plane

    @cached_property
    def origins(self) -> Origins:
        """The vertices that each point comes from, and the face of each segment."""
        return Origins(create("origins", self._handle, name="mesh_sections_origins"))

    def carry(self, values: ArrayLike) -> NDArray[Any]:
        """Carries values of the mesh's vertices over to the points."""
        return self.origins.carry([values])


def _cut(
    mesh: MeshLike, kind: int, fields: dict[str, Any], options: MeshSectionOptions, threads: int, progress: Optional[Progress]
) -> MeshSections:
    planes = ffi.new("struct gusset_cutting_planes *", {"struct_size": ffi.sizeof("struct gusset_cutting_planes"), "kind": kind})
    for name, value in fields.items():
        if isinstance(value, np.ndarray):
            setattr(planes, name, ffi.cast("double *", pointer(value)))
        else:
            setattr(planes, name, value)
    given = holding(planes, fields)
    return MeshSections(create("mesh_sections", view_of(as_mesh(mesh)), given, structs("mesh_section_options", options),
                               threads=threads, progress=progress))


def sections(
    mesh: MeshLike, point: ArrayLike, normal: ArrayLike, offsets: ArrayLike = (0.0,), *, threads: int = 0,
    progress: Optional[Progress] = None, **options: Unpack[MeshSectionOptions]
) -> MeshSections:
    """Cuts a mesh by parallel planes: through ``point``, at increasing ``offsets`` along ``normal``.

    Args:
        options: see :class:`~gusset_mesh.MeshSectionOptions`.

    >>> corners = [[0, 0, 0], [2, 0, 0], [0, 3, 0], [0, 0, 4]]
    >>> found = sections((corners, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]), [0, 0, 0], [0, 0, 1], [1, 2])
    >>> found.paths.area.tolist()
    [1.6875, 0.75]
    >>> found.carry([0.0, 0.0, 0.0, 1.0]).tolist()
    [0.25, 0.25, 0.25, 0.5, 0.5, 0.5]
    """
    values = numbers(offsets, (-1,), "offsets")
    fields = {"point": vector(point), "direction": vector(normal), "values": values, "value_count": len(values)}
    return _cut(mesh, lib.GUSSET_CUTTING_STACK, fields, options, threads, progress)


def sections_by_planes(
    mesh: MeshLike, planes: Sequence[Plane], *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[MeshSectionOptions]
) -> MeshSections:
    """Cuts a mesh by planes in any positions: each is a :class:`~gusset_mesh.Plane` or a point and a normal.

    Args:
        options: see :class:`~gusset_mesh.MeshSectionOptions`.
    """
    points = numbers([vector(point) for point, _ in planes] or np.zeros((0, 3)), (-1, 3), "points")
    normals = numbers([vector(normal) for _, normal in planes] or np.zeros((0, 3)), (-1, 3), "normals")
    fields = {"points": points, "normals": normals, "point_count": len(points)}
    return _cut(mesh, lib.GUSSET_CUTTING_PLANES, fields, options, threads, progress)


def sections_about_axis(
    mesh: MeshLike, point: ArrayLike, axis: ArrayLike, reference: ArrayLike, angles: ArrayLike, *, threads: int = 0,
    progress: Optional[Progress] = None, **options: Unpack[MeshSectionOptions]
) -> MeshSections:
    """Cuts a mesh by planes that contain the axis through ``point``, turned from ``reference`` by ``angles`` in radians.

    Args:
        options: see :class:`~gusset_mesh.MeshSectionOptions`.
    """
    values = numbers(angles, (-1,), "angles")
    fields = {"point": vector(point), "direction": vector(axis), "reference": vector(reference), "values": values, "value_count": len(values)}
    return _cut(mesh, lib.GUSSET_CUTTING_AXIS, fields, options, threads, progress)


def sections_across(
    mesh: MeshLike, polyline: ArrayLike, distances: ArrayLike, *, closed: bool = False, threads: int = 0,
    progress: Optional[Progress] = None, **options: Unpack[MeshSectionOptions]
) -> MeshSections:
    """Cuts a mesh by planes across a polyline, at distances from its first point along it.

    Args:
        polyline: (n, 3) in order.
        closed: whether the polyline returns to its first point.
        options: see :class:`~gusset_mesh.MeshSectionOptions`.
    """
    points, values = numbers(polyline, (-1, 3), "polyline"), numbers(distances, (-1,), "distances")
    fields = {"points": points, "point_count": len(points), "values": values, "value_count": len(values), "closed": int(closed)}
    return _cut(mesh, lib.GUSSET_CUTTING_CURVE, fields, options, threads, progress)
