"""Files of meshes, curves and points: OBJ, PLY, STL, OFF, glTF, GLB, 3MF, XYZ, CSV, SVG and DXF."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._library import ffi, lib, text
from ._plugin import Curves
from ._records import lent
from .errors import error
from .mesh import Mesh, MeshLike, as_mesh

__all__ = ["Document", "FileMesh", "Points", "read", "save"]

Array = NDArray[Any]
_TYPES = {"u8": np.dtype("u1"), "u32": np.dtype("<u4"), "f32": np.dtype("<f4"), "f64": np.dtype("<f8")}
_TEXT, _LOSSY, _JOINED = 1, 2, 1


@dataclass(eq=False)
class FileMesh:
    """A mesh of a file, with its attributes as arrays or None.

    Attributes:
        mesh: points and faces.
        normals: (n, 3) at vertices or corners, as ``normals_at`` says. A missing row is NaN.
        texcoords: (n, 2) at vertices or corners, as ``texcoords_at`` says.
        vertex_colours: (n, 4), sRGB and opacity, 0 to 1.
        face_colours: (m, 4), sRGB and opacity, 0 to 1.
        face_materials: (m,), indices into the materials of the document; 0xFFFFFFFF: none.
        properties: further numbers by ``(name, "vertices" or "faces")``.
    """

    mesh: Mesh
    name: str = ""
    normals: Optional[Array] = None
    normals_at: str = "vertices"
    texcoords: Optional[Array] = None
    texcoords_at: str = "vertices"
    vertex_colours: Optional[Array] = None
    face_colours: Optional[Array] = None
    face_materials: Optional[Array] = None
    properties: dict[tuple[str, str], Array] = field(default_factory=dict)
    #: Types of properties in a PLY file, such as ``"u8"``; ``"f64"`` by default.
    property_kinds: dict[tuple[str, str], str] = field(default_factory=dict)


@dataclass(eq=False)
class Points:
    """Points without faces."""

    points: Array
    normals: Optional[Array] = None
    colours: Optional[Array] = None


@dataclass(eq=False)
class Document:
    """The content of a file.

    Attributes:
        meshes: the meshes, each in its own coordinates.
        placements: for each mesh of the scene ``(name, index into meshes, 3 x 4 matrix)``; None: each mesh once, unmoved.
        curves: all polylines.
        points: all points without faces.
        materials: ``name``, ``colour``, ``image`` (an index or None), and ``native``, all that the format says.
        images: ``name``, ``media_type``, and ``file`` or ``bytes``.
        metres_per_unit: metres for each unit of length, or None.
        notes: deviations from the format that the reader accepted, and content that it left out.
    """

    meshes: list[FileMesh] = field(default_factory=list)
    placements: Optional[list[tuple[str, int, Array]]] = None
    curves: Optional[Curves] = None
    points: Optional[Points] = None
    materials: list[dict[str, Any]] = field(default_factory=list)
    images: list[dict[str, Any]] = field(default_factory=list)
    metres_per_unit: Optional[float] = None
    notes: list[str] = field(default_factory=list)

    @property
    def mesh(self) -> Mesh:
        """The mesh, if there is exactly one."""
        if len(self.meshes) != 1:
            raise ValueError(f"the document has {len(self.meshes)} meshes")
        return self.meshes[0].mesh


def read(path: Union[str, "os.PathLike[str]"], *, scene: bool = False) -> Document:
    """Reads a file, in the format of its extension.

    The document has one mesh, to which all meshes of a scene are joined. With ``scene``, it has each mesh and where it is placed.
    Files that it refers to are read from its folder only. Files that break the rules of their format are read if the meaning is clear;
    ``notes`` of the document say so.

    Raises:
        InputError: the file is not of its format, with the line or byte.
        OSError: the file cannot be read.
    """
    path = Path(path)
    if not path.is_file():
        raise OSError(f"{path} is not a regular file" if path.exists() else f"{path} does not exist")
    data = path.read_bytes()
    with _folder(path.parent) as folder:
        made = _Result(lambda out: _table().read(path.name.encode(), ffi.from_buffer("uint8_t[]", data), len(data), folder, 0 if scene else _JOINED, out), path)
    return _document(made)


def save(path: Union[str, "os.PathLike[str]"], content: Union[Document, FileMesh, Curves, MeshLike], *, text: bool = False, lossy: bool = False) -> list[str]:
    """Writes a mesh, curves or a document to a file, in the format of its extension. Returns what the format could not hold.

    The old file stays until the new one is complete.

    Args:
        text: writes PLY and STL files as text.
        lossy: permits single precision that moves points by more than a thousandth of the mean edge.

    Raises:
        InputError: the content breaks a rule, or the format cannot hold it.
        OSError: the file cannot be written.
    """
    path = Path(path)
    writer = _Writer()
    described = json.dumps(writer.document(_as_document(content))).encode()
    flags = (_TEXT if text else 0) | (_LOSSY if lossy else 0)
    arrays = bytes(writer.arrays)
    with _folder(path.parent) as folder:
        made = _Result(lambda out: _table().write(path.name.encode(), described, ffi.from_buffer("uint8_t[]", arrays), len(arrays), folder, flags, out), path)
    # Files that the main one refers to come first.
    for which in [*range(2, made.count), 1]:
        _replace(path if which == 1 else path.parent / made.name(which), bytes(made.bytes(which)))
    return [str(loss) for loss in json.loads(bytes(made.bytes(0)))]


def _table() -> Any:
    plugin = lib.gusset_plugin_entry(lib.GUSSET_PLUGIN_ABI)
    table = plugin.extension(b"files/1")
    if not table:
        raise NotImplementedError("this build of the library reads no files")
    return ffi.cast("struct gusset_plugin_files *", table)


class _Result:
    """Parts of a file that was read or written."""

    def __init__(self, call: Any, path: Path):
        out = ffi.new("struct gusset_files **")
        status = call(out)
        self.handle = ffi.gc(out[0], _table().free)
        if status != 0:
            raise error(status, f"{path}: {text(_table().message(self.handle))}")
        self.count = int(_table().part_count(self.handle))

    def name(self, which: int) -> str:
        return text(_table().part_name(self.handle, which))

    def bytes(self, which: int) -> Array:
        size = ffi.new("size_t *")
        data = _table().part_bytes(self.handle, which, size)
        return lent(data, (size[0],), np.uint8, self.handle)


@contextmanager
def _folder(folder: Path) -> Iterator[Any]:
    """Serves files of a folder, and of its folders, to a reader or writer."""
    kept: list[bytes] = []

    @ffi.callback("int32_t(void *, const char *, const uint8_t **, size_t *)", error=1)  # type: ignore[untyped-decorator]
    def load(user: Any, name: Any, data: Any, size: Any) -> int:
        path = (folder / text(name).replace("\\", "/")).resolve()
        if not path.is_relative_to(folder.resolve()) or not path.is_file():
            return 1
        kept[:] = [path.read_bytes()]
        data[0], size[0] = ffi.from_buffer("uint8_t[]", kept[0]), len(kept[0])
        return 0

    struct = ffi.new("struct gusset_plugin_folder *")
    struct.struct_size, struct.load = ffi.sizeof("struct gusset_plugin_folder"), load
    yield struct


def _replace(path: Path, data: bytes) -> None:
    """Gives a file new bytes, which are complete before the old ones go."""
    handle, name = tempfile.mkstemp(prefix=".gusset-", dir=path.parent)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(name, path.stat().st_mode if path.exists() else 0o666 & ~mask)
        os.replace(name, path.resolve())
    except BaseException:
        with suppress(OSError):
            os.unlink(name)
        raise


def _document(made: _Result) -> Document:
    described = json.loads(bytes(made.bytes(0)))
    memory = made.bytes(1)

    def array(one: Optional[dict[str, Any]]) -> Optional[Array]:
        if one is None:
            return None
        dtype = _TYPES[one["type"]]
        flat = memory[one["at"]:one["at"] + one["count"] * one["width"] * dtype.itemsize].view(dtype)
        return flat if one["width"] == 1 else flat.reshape(-1, one["width"])

    def required(one: dict[str, Any]) -> Array:
        found = array(one)
        assert found is not None
        return found

    def attribute(one: Optional[dict[str, Any]]) -> tuple[Optional[Array], str]:
        return (None, "vertices") if one is None else (array(one["values"]), "corners" if one["at_corners"] else "vertices")

    def mesh(one: dict[str, Any]) -> FileMesh:
        (normals, normals_at), (texcoords, texcoords_at) = attribute(one["normals"]), attribute(one["texcoords"])
        keys = [(each["name"], "faces" if each["at_faces"] else "vertices") for each in one["properties"]]
        return FileMesh(
            Mesh.from_polygons(required(one["positions"]), required(one["face_offsets"]), required(one["corners"]), merge=array(one["merge"])),
            one["name"], normals, normals_at, texcoords, texcoords_at, array(one["vertex_colours"]), array(one["face_colours"]),
            array(one["face_materials"]), {key: required(each["values"]) for key, each in zip(keys, one["properties"])},
            {key: each["kind"] for key, each in zip(keys, one["properties"])},
        )

    curves, points, transforms = described["curves"], described["points"], required(described["transforms"])
    images = [{**one, "bytes": bytes(required(one["bytes"]))} if "bytes" in one else one for one in described["images"]]
    return Document(
        meshes=[mesh(one) for one in described["meshes"]],
        placements=[(one["name"], one["mesh"], transforms[k].reshape(3, 4)) for k, one in enumerate(described["placements"])],
        curves=Curves(required(curves["positions"]), required(curves["offsets"]), required(curves["closed"])) if curves["closed"]["count"] else None,
        points=Points(required(points["positions"]), array(points["normals"]), array(points["colours"])) if points["positions"]["count"] else None,
        materials=described["materials"],
        images=images,
        metres_per_unit=described["metres_per_unit"],
        notes=[one["text"] for one in described["notes"]],
    )


def _as_document(content: Any) -> Document:
    if isinstance(content, Document):
        return content
    if isinstance(content, Curves):
        return Document(curves=content)
    if isinstance(content, Points):
        return Document(points=content)
    return Document(meshes=[content if isinstance(content, FileMesh) else FileMesh(as_mesh(content))])


class _Writer:
    """Describes a document, and gathers its arrays."""

    def __init__(self) -> None:
        self.arrays = bytearray()

    def array(self, given: Optional[ArrayLike], kind: str, width: int = 1) -> Optional[dict[str, Any]]:
        if given is None:
            return None
        values = np.ascontiguousarray(given, _TYPES[kind])
        if width > 1 and (values.ndim != 2 or values.shape[1] != width):
            raise ValueError(f"an array has the shape {values.shape}, not (n, {width})")
        self.arrays += bytes(-len(self.arrays) % 8)
        at = len(self.arrays)
        self.arrays += values.tobytes()
        return {"at": at, "count": len(values) if width > 1 else values.size, "type": kind, "width": width}

    def points_array(self, points: Array) -> Optional[dict[str, Any]]:
        return self.array(points, "f32" if np.asarray(points).dtype == np.float32 else "f64", 3)

    def attribute(self, values: Optional[Array], at: str, width: int) -> Optional[dict[str, Any]]:
        return None if values is None else {"at_corners": at == "corners", "values": self.array(values, "f64", width)}

    def mesh(self, one: FileMesh) -> dict[str, Any]:
        mesh = one.mesh
        offsets = mesh.offsets if mesh.offsets is not None else np.arange(mesh.face_count + 1, dtype=np.uint32) * mesh.face_size
        return {
            "name": one.name,
            "positions": self.points_array(mesh.points),
            "face_offsets": self.array(offsets, "u32"),
            "corners": self.array(mesh.corners, "u32"),
            "merge": self.array(mesh.merge, "u32"),
            "normals": self.attribute(one.normals, one.normals_at, 3),
            "texcoords": self.attribute(one.texcoords, one.texcoords_at, 2),
            "vertex_colours": self.array(one.vertex_colours, "f32", 4),
            "face_colours": self.array(one.face_colours, "f32", 4),
            "face_materials": self.array(one.face_materials, "u32"),
            "properties": [
                {"name": name, "at_faces": at == "faces", "kind": one.property_kinds.get((name, at), "f64"), "values": self.array(values, "f64")}
                for (name, at), values in one.properties.items()
            ],
        }

    def document(self, document: Document) -> dict[str, Any]:
        made: dict[str, Any] = {
            "meshes": [self.mesh(one) for one in document.meshes],
            "materials": document.materials,
            "images": [{**one, "bytes": self.array(np.frombuffer(one["bytes"], np.uint8), "u8")} if "bytes" in one else one for one in document.images],
            "metres_per_unit": document.metres_per_unit,
        }
        if document.placements is not None:
            made["placements"] = [{"name": name, "mesh": int(mesh)} for name, mesh, _ in document.placements]
            made["transforms"] = self.array(np.array([matrix for _, _, matrix in document.placements], np.float64).reshape(-1, 12), "f64", 12)
        if document.curves is not None:
            curves = document.curves
            made["curves"] = {"positions": self.points_array(curves.points), "offsets": self.array(curves.offsets, "u32"), "closed": self.array(curves.closed, "u8")}
        if document.points is not None:
            points = document.points
            made["points"] = {
                "positions": self.points_array(points.points), "normals": self.array(points.normals, "f64", 3), "colours": self.array(points.colours, "f32", 4),
            }
        return made
