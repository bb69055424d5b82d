"""Documents as a JSON text and one array of bytes, which is how the library reads and writes them: see docs/guides/files.md."""

from __future__ import annotations

import json
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import real_array, reals_of
from ._plugin import Curves
from .documents import Array, At, Document, FileMesh, Image, Material, Placement, Points
from .mesh import Mesh

_TYPES: dict[str, np.dtype[Any]] = {"u8": np.dtype("u1"), "u32": np.dtype("<u4"), "f32": np.dtype("<f4"), "f64": np.dtype("<f8")}
#: Types of numbers in PLY files.
_KINDS: dict[str, np.dtype[Any]] = {**_TYPES, "i8": np.dtype("i1"), "i16": np.dtype("<i2"), "u16": np.dtype("<u2"), "i32": np.dtype("<i4")}
_ALIGNMENT = 8


def unpacked(description: Array, memory: Array) -> Document:
    """The document that a text describes. Its arrays are views of ``memory``."""
    return _Reader(memory).document(json.loads(description.tobytes()))


def packed(document: Document) -> tuple[bytes, Array]:
    """The text of a document, and the array that the text describes."""
    writer = _Writer()
    described = json.dumps(writer.document(document), ensure_ascii=False, allow_nan=False)
    # Names of files that are not Unicode have surrogates, which JSON lacks.
    return described.encode("utf-8", "replace"), writer.memory()


class _Reader:
    def __init__(self, memory: Array):
        self.memory = memory

    def array(self, one: dict[str, Any]) -> Array:
        dtype, width = _TYPES[one["type"]], one["width"]
        flat = self.memory[one["at"]:one["at"] + one["count"] * width * dtype.itemsize].view(dtype)
        return flat if width == 1 else flat.reshape(-1, width)

    def optional(self, one: Optional[dict[str, Any]]) -> Optional[Array]:
        return None if one is None else self.array(one)

    def attribute(self, one: Optional[dict[str, Any]]) -> tuple[Optional[Array], At]:
        return (None, "vertices") if one is None else (self.array(one["values"]), "corners" if one["at_corners"] else "vertices")

    def polygons(self, one: dict[str, Any]) -> Mesh:
        points, offsets, corners = (self.array(one[name]) for name in ("positions", "face_offsets", "corners"))
        merge = self.optional(one["merge"])
        size = int(offsets[1]) if len(offsets) > 1 else 0
        if size and size * (len(offsets) - 1) == len(corners) and (np.diff(offsets) == size).all():
            return Mesh(points, corners.reshape(-1, size), merge=merge)
        return Mesh.from_polygons(points, offsets, corners, merge=merge)

    def mesh(self, one: dict[str, Any]) -> FileMesh:
        made = FileMesh(self.polygons(one), one["name"])
        made.normals, made.normals_at = self.attribute(one["normals"])
        made.texcoords, made.texcoords_at = self.attribute(one["texcoords"])
        made.vertex_colours, made.face_colours = self.optional(one["vertex_colours"]), self.optional(one["face_colours"])
        made.face_materials = self.optional(one["face_materials"])
        for each in one["properties"]:
            values, types = (made.face_properties, made.face_types) if each["at_faces"] else (made.vertex_properties, made.vertex_types)
            values[each["name"]], types[each["name"]] = self.array(each["values"]), _KINDS[each["kind"]]
        return made

    def image(self, one: dict[str, Any]) -> Image:
        return Image(one["name"], one["media_type"], one["file"] if "file" in one else self.array(one["bytes"]).tobytes())

    def document(self, given: dict[str, Any]) -> Document:
        curves, points = given["curves"], given["points"]
        transforms = self.array(given["transforms"]).reshape(-1, 3, 4)
        return Document(
            meshes=[self.mesh(one) for one in given["meshes"]],
            placements=[Placement(one["name"], one["mesh"], transform) for one, transform in zip(given["placements"], transforms)],
            curves=Curves(*(self.array(curves[name]) for name in ("positions", "offsets", "closed"))) if curves["closed"]["count"] else None,
            points=self.points(points) if points["positions"]["count"] else None,
            materials=[Material(one["name"], tuple(one["colour"]), one["image"], one["native"]) for one in given["materials"]],
            images=[self.image(one) for one in given["images"]],
            metres_per_unit=given["metres_per_unit"],
            notes=[_note(one) for one in given["notes"]],
        )

    def points(self, one: dict[str, Any]) -> Points:
        return Points(self.array(one["positions"]), self.optional(one["normals"]), self.optional(one["colours"]))


def _note(one: dict[str, Any]) -> str:
    place = next((f"{word} {one[word]}: " for word in ("line", "byte") if word in one), "")
    return place + str(one["text"])


class _Writer:
    """Describes a document, and gathers its arrays."""

    def __init__(self) -> None:
        self._arrays: list[tuple[int, Array]] = []
        self._size = 0

    def memory(self) -> Array:
        made = np.zeros(self._size, np.uint8)
        for at, values in self._arrays:
            made[at:at + values.nbytes] = values.reshape(-1).view(np.uint8)
        return made

    def array(self, name: str, given: ArrayLike, kind: str, width: int = 1) -> dict[str, Any]:
        values = np.ascontiguousarray(real_array(given), _TYPES[kind])
        if values.ndim != (1 if width == 1 else 2) or (width > 1 and values.shape[1] != width):
            raise ValueError(f"{name}: the shape is {values.shape}, not {'(n,)' if width == 1 else f'(n, {width})'}")
        at = self._size
        self._arrays.append((at, values))
        self._size += -(-values.nbytes // _ALIGNMENT) * _ALIGNMENT
        return {"at": at, "count": len(values), "type": kind, "width": width}

    def optional(self, name: str, given: Optional[ArrayLike], kind: str, width: int = 1) -> Optional[dict[str, Any]]:
        return None if given is None else self.array(name, given, kind, width)

    def positions(self, points: ArrayLike) -> dict[str, Any]:
        return self.array("points", points, "f32" if np.asarray(points).dtype == np.float32 else "f64", 3)

    def indices(self, name: str, given: ArrayLike) -> dict[str, Any]:
        values = np.asarray(given)
        if values.size and (values.dtype.kind not in "iu" or values.min() < 0 or values.max() > 0xFFFFFFFF):
            raise ValueError(f"{name}: the entries are not whole numbers from 0 to 2^32 - 1")
        return self.array(name, values, "u32")

    def attribute(self, name: str, values: Optional[Array], at: At, width: int) -> Optional[dict[str, Any]]:
        if at not in ("vertices", "corners"):
            raise ValueError(f"{name}_at is {at!r}: there are 'vertices', 'corners'")
        return None if values is None else {"at_corners": at == "corners", "values": self.array(name, values, "f64", width)}

    def mesh(self, one: FileMesh) -> dict[str, Any]:
        mesh = one.mesh
        offsets = mesh.offsets if mesh.offsets is not None else np.arange(mesh.face_count + 1, dtype=np.uint32) * np.uint32(mesh.face_size)
        properties = [
            {"name": name, "at_faces": at_faces, "kind": _kind(values, types.get(name)), "values": self.array(f"property {name}", values, "f64")}
            for at_faces, all_values, types in ((False, one.vertex_properties, one.vertex_types), (True, one.face_properties, one.face_types))
            for name, values in all_values.items()
        ]
        return {
            "name": one.name,
            "positions": self.positions(mesh.points),
            "face_offsets": self.indices("offsets", offsets),
            "corners": self.indices("corners", mesh.corners),
            "merge": None if mesh.merge is None else self.indices("merge", mesh.merge),
            "normals": self.attribute("normals", one.normals, one.normals_at, 3),
            "texcoords": self.attribute("texcoords", one.texcoords, one.texcoords_at, 2),
            "vertex_colours": self.optional("vertex_colours", one.vertex_colours, "f32", 4),
            "face_colours": self.optional("face_colours", one.face_colours, "f32", 4),
            "face_materials": None if one.face_materials is None else self.indices("face_materials", one.face_materials),
            "properties": properties,
        }

    def image(self, one: Image) -> dict[str, Any]:
        data = {"file": one.data} if isinstance(one.data, str) else {"bytes": self.array("image", np.frombuffer(one.data, np.uint8), "u8")}
        return {"name": one.name, "media_type": one.media_type, **data}

    def document(self, given: Document) -> dict[str, Any]:
        made: dict[str, Any] = {
            "meshes": [self.mesh(one) for one in given.meshes],
            "materials": [
                {"name": one.name, "colour": [float(part) for part in one.colour], "image": one.image, "native": one.native} for one in given.materials
            ],
            "images": [self.image(one) for one in given.images],
            "metres_per_unit": given.metres_per_unit,
        }
        if given.placements is not None:
            made["placements"] = [{"name": one.name, "mesh": int(one.mesh)} for one in given.placements]
            matrices = [reals_of(one.transform) for one in given.placements]
            if any(matrix.shape != (3, 4) for matrix in matrices):
                bad = next(k for k, matrix in enumerate(matrices) if matrix.shape != (3, 4))
                raise ValueError(f"the transform of placement {bad} has the shape {matrices[bad].shape}, not (3, 4)")
            made["transforms"] = self.array("placements", np.reshape(matrices, (-1, 12)), "f64", 12)
        if given.curves is not None:
            curves = given.curves
            curves.require()
            made["curves"] = {
                "positions": self.positions(curves.points),
                "offsets": self.indices("offsets", curves.offsets),
                "closed": self.array("closed", curves.closed, "u8"),
            }
        if given.points is not None:
            points = given.points
            made["points"] = {
                "positions": self.positions(points.points),
                "normals": self.optional("normals of points", points.normals, "f64", 3),
                "colours": self.optional("colours of points", points.colours, "f32", 4),
            }
        return made


def _kind(values: ArrayLike, dtype: Optional[np.dtype[Any]]) -> str:
    """The type of a property in a PLY file: the given one, or the type of its array if PLY files have it."""
    wanted = np.dtype(dtype) if dtype is not None else np.asarray(values).dtype
    if wanted.kind == "b":
        return "u8"
    kind = next((name for name, one in _KINDS.items() if one == wanted.newbyteorder("<")), None)
    if kind is not None:
        return kind
    array = np.asarray(values)
    is_small = wanted.kind in "iu" and array.size > 0 and array.min() >= -(2**31) and array.max() < 2**31
    return "i32" if is_small else "f64"
