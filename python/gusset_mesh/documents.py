"""The content of files: meshes with attributes, where they are, curves, points, materials."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import NDArray

from ._plugin import Curves
from .mesh import Mesh

__all__ = ["Document", "FileMesh", "Image", "Material", "NO_MATERIAL", "Placement", "Points"]

Array = NDArray[Any]
#: Elements that carry normals or texture coordinates.
At = Literal["vertices", "corners"]
#: The entry of ``face_materials`` for a face without a material.
NO_MATERIAL = 0xFFFFFFFF


def _counted(count: int, noun: str) -> str:
    plural = {"mesh": "meshes", "vertex": "vertices"}.get(noun, noun + "s")
    return f"{count} {noun if count == 1 else plural}"


@dataclass(eq=False, repr=False)
class FileMesh:
    """A mesh with the attributes that files hold. Absent attributes are None.

    ``join``, ``check`` and all other functions take it as a mesh.

    Attributes:
        mesh: points and faces.
        name: name of the object; may be empty.
        normals: (n, 3), at vertices or corners as ``normals_at`` says. A missing normal is NaN.
        texcoords: (n, 2), at vertices or corners as ``texcoords_at`` says, from the lower left of the image. Missing ones are NaN.
        vertex_colours: (vertices, 4), sRGB and opacity, 0 to 1.
        face_colours: (faces, 4), sRGB and opacity, 0 to 1.
        face_materials: (faces,), indices into the materials of the document, or ``NO_MATERIAL``.
        vertex_properties: further numbers of vertices by their names, such as ``"quality"``.
        face_properties: further numbers of faces by their names.
        vertex_types: numpy types that PLY files store properties of vertices in. A property that is not listed is stored in the type of
            its array.
        face_types: these types for properties of faces.
    """

    mesh: Mesh
    name: str = ""
    normals: Optional[Array] = None
    normals_at: At = "vertices"
    texcoords: Optional[Array] = None
    texcoords_at: At = "vertices"
    vertex_colours: Optional[Array] = None
    face_colours: Optional[Array] = None
    face_materials: Optional[Array] = None
    vertex_properties: dict[str, Array] = field(default_factory=dict)
    face_properties: dict[str, Array] = field(default_factory=dict)
    vertex_types: dict[str, np.dtype[Any]] = field(default_factory=dict)
    face_types: dict[str, np.dtype[Any]] = field(default_factory=dict)

    def _parts(self) -> Iterator[str]:
        """Words for the mesh and each attribute that it has."""
        yield f"{_counted(self.mesh.vertex_count, 'vertex')}, {_counted(self.mesh.face_count, 'face')}"
        for name in ("normals", "texcoords"):
            if getattr(self, name) is not None:
                yield f"{name} at {getattr(self, name + '_at')}"
        yield from (name for name in ("vertex_colours", "face_colours", "face_materials") if getattr(self, name) is not None)
        for name in ("vertex_properties", "face_properties"):
            if getattr(self, name):
                yield f"{name} {', '.join(getattr(self, name))}"

    def __repr__(self) -> str:
        return f"<FileMesh {self.name!r}: {'; '.join(self._parts())}>" if self.name else f"<FileMesh: {'; '.join(self._parts())}>"


@dataclass(eq=False, repr=False)
class Points:
    """Points without faces.

    Attributes:
        points: (n, 3).
        normals: (n, 3), or None.
        colours: (n, 4), sRGB and opacity, 0 to 1, or None.
    """

    points: Array
    normals: Optional[Array] = None
    colours: Optional[Array] = None

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return f"<Points: {len(self)}>"


class Placement(NamedTuple):
    """A mesh in the scene."""

    #: Name of the node; may be empty.
    name: str
    #: Index into the meshes of the document.
    mesh: int
    #: (3, 4): takes points of the mesh into the scene.
    transform: Array


@dataclass
class Material:
    """A material.

    Attributes:
        name: name; may be empty.
        colour: base colour, sRGB and opacity, 0 to 1.
        image: image of the base colour, an index into the images of the document, or None.
        native: all that the format says, as the page ``docs/guides/files.md`` describes it. A file of this format gets it back.
    """

    name: str = ""
    colour: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)
    image: Optional[int] = None
    native: Optional[dict[str, Any]] = None


@dataclass
class Image:
    """An image that materials refer to.

    Attributes:
        name: name; may be empty.
        media_type: ``"image/png"``, ``"image/jpeg"``, or empty if unknown.
        data: the bytes of the image; or the name of its file, relative to the folder of the document.
    """

    name: str = ""
    media_type: str = ""
    data: Union[bytes, str] = field(default=b"", repr=False)


@dataclass(eq=False, repr=False)
class Document:
    """The content of a file. ``join``, ``check`` and all other functions take a document of one mesh as a mesh.

    Attributes:
        meshes: meshes in their own coordinates.
        placements: the scene; None: each mesh once, unmoved.
        curves: all polylines, or None.
        points: all points without faces, or None.
        materials: materials of faces.
        images: images of materials.
        metres_per_unit: metres for each unit of length, or None.
        notes: deviations from the format that the reader accepted, and content that it left out.
        folder: folder of the file that was read, in which ``save`` finds its images; None: the folder of the file that is written.
    """

    meshes: list[FileMesh] = field(default_factory=list)
    placements: Optional[list[Placement]] = None
    curves: Optional[Curves] = None
    points: Optional[Points] = None
    materials: list[Material] = field(default_factory=list)
    images: list[Image] = field(default_factory=list)
    metres_per_unit: Optional[float] = None
    notes: list[str] = field(default_factory=list)
    folder: Optional[Path] = None

    @property
    def mesh(self) -> Mesh:
        """The mesh, if there is exactly one.

        Raises:
            ValueError: the document has several meshes or none.
        """
        if len(self.meshes) != 1:
            raise ValueError(f"{self!r} does not have exactly one mesh: choose one of meshes" if self.meshes else f"{self!r} has no mesh")
        return self.meshes[0].mesh

    def __repr__(self) -> str:
        parts = [repr(self.meshes[0])[1:-1].removeprefix("File")] if len(self.meshes) == 1 else []
        parts += [_counted(len(self.meshes), "mesh")] if len(self.meshes) > 1 else []
        parts += [_counted(len(self.curves), "curve")] if self.curves is not None else []
        parts += [_counted(len(self.points), "point")] if self.points is not None else []
        parts += [_counted(len(self.materials), "material")] if self.materials else []
        parts += [_counted(len(self.notes), "note")] if self.notes else []
        return f"<Document: {'; '.join(parts) or 'empty'}>"
