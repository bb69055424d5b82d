"""Files of meshes, curves and points: OBJ, PLY, STL, OFF, glTF, GLB, 3MF, XYZ, CSV, SVG and DXF.

``read`` makes a document of a file, and ``save`` makes a file of a mesh or document::

    losses = gm.save("joined.ply", gm.join([gm.read("a.ply"), gm.read("b.ply")]))
"""

from __future__ import annotations

import errno
import json
import os
import re
import stat
from functools import cache
from pathlib import Path
from typing import Any, Optional, Union

import numpy as np

from . import _library
from ._library import ffi, lib, text
from ._packed import packed, unpacked
from ._plugin import Curves
from ._records import lent
from ._replacing import replace_files
from .documents import NO_MATERIAL, Array, Document, FileMesh, Image, Material, Placement, Points
from .errors import Error, error
from .mesh import MeshLike, as_mesh

__all__ = ["Document", "FileMesh", "Image", "Material", "NO_MATERIAL", "Placement", "Points", "read", "save"]

StrPath = Union[str, "os.PathLike[str]"]
Content = Union[Document, FileMesh, Points, Curves, MeshLike]


def read(path: StrPath, *, scene: bool = False, merge: bool = True) -> Document:
    """Reads a file, in the format of its extension. Other threads run meanwhile.

    The document has one mesh, to which all meshes of the file are joined. With ``scene``, it has each mesh, and where each is placed. Arrays
    are read-only views of one buffer. Files that the file names, such as material libraries, are read only if they are in its folder. If a file
    breaks a rule of its format and the meaning is clear, ``notes`` of the document say so.

    Args:
        path: the file.
        scene: keeps the meshes of a scene and their placements.
        merge: merges vertices of STL, DXF and glTF files at equal points. Without it, large STL files are read in less time.

    Raises:
        InputError: the format is unknown, or the file is not of its format. The message has the line or byte.
        OutOfMemory: the file needs more memory than there is.
        OSError: the file does not exist, is not a regular file, or cannot be read.
    """
    path = Path(os.fsdecode(path))
    data = _loaded(path)
    folder = _Folder(path.parent)
    flags = (0 if scene else lib.GUSSET_FILES_JOINED) | (0 if merge else lib.GUSSET_FILES_UNMERGED)
    made = _Parts(path, folder, lambda out: _table().read(_name(path), ffi.from_buffer("uint8_t[]", data), len(data), folder.struct, flags, out))
    document = unpacked(made.bytes(0), made.bytes(1))
    document.folder = path.parent
    return document


def save(path: StrPath, content: Content, *, text: bool = False, lossy: bool = False) -> list[str]:
    """Writes a mesh, curves, points or a document to a file, in the format of its extension. Other threads run meanwhile.

    Returns phrases for what the format does not hold: ``["materials, which PLY files do not hold"]``. The old file stays as it was until the new
    one is complete. The format may need files beside it, such as a material library; they are complete before it.

    Args:
        path: the file. Its folder must exist.
        content: a :class:`Document`, :class:`FileMesh` or :class:`Points`, a :class:`gusset_mesh.Curves`, or a mesh as all functions take it.
        text: writes PLY and STL files as text.
        lossy: permits single precision that moves points by more than a thousandth of the mean edge.

    Raises:
        InputError: the format is unknown or cannot hold the content, or the content breaks a rule, such as a corner without a vertex.
        ValueError: an array has a wrong shape.
        OutOfMemory: the file needs more memory than there is.
        OSError: the file cannot be written.
    """
    path = Path(os.fsdecode(path))
    document = _as_document(content)
    described, arrays = packed(document)
    source = document.folder if document.folder is not None else path.parent
    folder = _Folder(source, path.parent)
    flags = (lib.GUSSET_FILES_TEXT if text else 0) | (lib.GUSSET_FILES_LOSSY if lossy else 0)
    data = ffi.from_buffer("uint8_t[]", arrays)
    made = _Parts(path, folder, lambda out: _table().write(_name(path), described, data, len(arrays), folder.struct, flags, out))
    # Files that the main one refers to come first.
    beside = {path.parent / _beside(path, made.name(k)): made.bytes(k) for k in range(2, made.count)}
    replace_files({**beside, path: made.bytes(1)})
    losses = [str(loss) for loss in json.loads(made.bytes(0).tobytes())]
    return losses + _lost_images(document, source, beside.values())


@cache
def _table() -> Any:
    """The functions of gusset_files.h."""
    for library in (lib, _library.files):
        try:
            table = library.gusset_files_entry(lib.GUSSET_FILES_ABI)
        except (AttributeError, ffi.error):  # the library is absent, or was built without them
            continue
        if table:
            return table
    raise NotImplementedError("this build of the library reads no files: build it with the feature `files`")


def _name(path: Path) -> bytes:
    """The name of a file as Unicode, from which the library takes the format, and names for the files beside it."""
    return os.fsencode(path.name).decode("utf-8", "replace").encode("utf-8")


def _shown(path: Path) -> str:
    """A path for messages, which can be printed although the path is not Unicode."""
    return str(path).encode("utf-8", "backslashreplace").decode("utf-8")


def _loaded(path: Path) -> bytes:
    """The bytes of a regular file. Pipes and devices are not opened, because reading them may never end."""
    status = os.stat(path)
    if not stat.S_ISREG(status.st_mode) and not stat.S_ISDIR(status.st_mode):
        raise OSError(errno.EINVAL, "Not a regular file", os.fspath(path))
    return path.read_bytes()


def _beside(path: Path, name: str) -> str:
    """The name of a file in the folder of another, if it is a name without folders."""
    if Path(name).name != name:
        raise error(-lib.GUSSET_FILES_BAD_FILE, f"{_shown(path)}: the file beside it would be {name!r}, which is not a name in its folder")
    return name


class _Parts:
    """Parts of a file that was read or written."""

    def __init__(self, path: Path, folder: _Folder, call: Any):
        out = ffi.new("struct gusset_file **")
        try:
            status = call(out)
        finally:
            folder.close()
        self._handle = ffi.gc(out[0], _table().free) if out[0] else ffi.NULL
        if folder.raised is not None:
            raise folder.raised
        if status != lib.GUSSET_FILES_DONE:
            raise _failure(status, path, text(_table().message(self._handle)))
        self.count = int(_table().part_count(self._handle))

    def name(self, which: int) -> str:
        return text(_table().part_name(self._handle, which))

    def bytes(self, which: int) -> Array:
        """The bytes of a part, which live as long as the array or a view of it."""
        size = ffi.new("size_t *")
        data = _table().part_bytes(self._handle, which, size)
        return lent(data, (size[0],), np.uint8, self._handle)


def _failure(status: int, path: Path, message: str) -> Error:
    # A number at the beginning is a line.
    said = re.sub("^([0-9]+): ", r"line \1: ", message)
    known = {lib.GUSSET_FILES_OUT_OF_MEMORY: lib.GUSSET_ERROR_OUT_OF_MEMORY, lib.GUSSET_FILES_INTERNAL: lib.GUSSET_ERROR_PANIC}
    return error(known.get(status, -status), f"{_shown(path)}: {said}")


class _Folder:
    """Gives a reader or writer the files of a folder and of its folders. Names that lead out of the folder, also by a link, do not exist.

    A file that is written to ``target`` names the files as seen from there.
    """

    def __init__(self, folder: Path, target: Optional[Path] = None):
        self._folder = folder
        self._kept = b""
        #: An exception that is not about one file, such as KeyboardInterrupt.
        self.raised: Optional[BaseException] = None
        self._load: Any = ffi.callback("int32_t(void *, const char *, const uint8_t **, size_t *)", self.load, error=1, onerror=self.failed)
        self.struct: Any = ffi.new("struct gusset_files_folder *")
        self.struct.struct_size, self.struct.load = ffi.sizeof("struct gusset_files_folder"), self._load
        self._seen_as: Any = _seen_as(folder, target)
        self.struct.seen_as = self._seen_as

    def close(self) -> None:
        """Frees the bytes of the last file, and breaks the circle through the callback."""
        self._kept, self._load, self.struct = b"", None, None

    def load(self, user: Any, name: Any, data: Any, size: Any) -> int:
        try:
            folder = self._folder.resolve()
            path = (folder / text(name).replace("\\", "/")).resolve()
            if not path.is_relative_to(folder):
                return 1
            self._kept = _loaded(path)
        except (OSError, RuntimeError, ValueError):  # RuntimeError: a circle of links
            return 1
        data[0], size[0] = ffi.from_buffer("uint8_t[]", self._kept), len(self._kept)
        return 0

    def failed(self, kind: Any, exception: BaseException, traceback: Any) -> int:
        self.raised = exception
        return 1


def _as_document(content: Content) -> Document:
    if isinstance(content, Document):
        return content
    if isinstance(content, Curves):
        return Document(curves=content)
    if isinstance(content, Points):
        return Document(points=content)
    return Document(meshes=[content if isinstance(content, FileMesh) else FileMesh(as_mesh(content))])


def _seen_as(folder: Path, target: Optional[Path]) -> Any:
    """The path from a target to a folder as a C string; NULL if it is the same, or if no path leads from one to the other."""
    if target is None:
        return ffi.NULL
    try:
        path = os.path.relpath(folder.resolve(), target.resolve()).replace(os.sep, "/").encode("utf-8")
    except ValueError:  # another drive, or a path that is not Unicode
        return ffi.NULL
    return ffi.NULL if path == b"." else ffi.new("char[]", path)


def _lost_images(document: Document, source: Path, beside: Any) -> list[str]:
    """Phrases for images that the written files name, but that do not exist."""
    named = {image.data for image in document.images if isinstance(image.data, str) and image.data}
    texts = [part.tobytes() for part in beside] if named else []
    missing = sorted(name for name in named if any(name.encode("utf-8", "replace") in one for one in texts) and not (source / name).exists())
    return [f"the image {name}, which does not exist" for name in missing]
