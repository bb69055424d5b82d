"""Readers and writers of files: `io/{read,write}/{stl,obj,ply,glb}/{assimp,trimesh,meshlib}`. `io/write/*/write` writes the finished bytes:
no writer takes less time. `io/read-10M/{stl,stl-unmerged}/read` reads 10^7 triangles beside a plain read of the file. All contenders start
from the same file, or write the same triangles."""

import ctypes
import os
from functools import cache
from pathlib import Path

import numpy as np

from peers import Peer
from timing import Contender, by_turns

FORMATS = ("stl", "obj", "ply", "glb")
PEERS = {"read": ("assimp", "trimesh", "meshlib"), "write": ("assimp", "trimesh", "meshlib", "write")}
LARGE = {"io/read-10M/stl/read": 0, "io/read-10M/stl-unmerged/read": 2}
#: Quads of a side of the wavy square: two triangles each.
SIDE, LARGE_SIDE = 707, 2236

trimesh = Peer("trimesh")
mm = Peer("meshlib.mrmeshpy")
mn = Peer("meshlib.mrmeshnumpy", after="meshlib.mrmeshpy")


def wanted(only):
    rows = [f"io/{kind}/{extension}/{peer}" for kind, peers in PEERS.items() for extension in FORMATS for peer in peers]
    return any(only in row for row in [*rows, *LARGE])


def wavy_square(side):
    """Points and triangles."""
    row = np.linspace(0, 1, side + 1)
    x, y = np.meshgrid(row, row, indexing="ij")
    points = np.stack([x, y, 0.1 * np.sin(9 * x) * np.cos(7 * y)], -1).reshape(-1, 3).astype(np.float32)
    corner = np.arange((side + 1) ** 2, dtype=np.uint32).reshape(side + 1, side + 1)
    a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
    return points, np.stack([np.stack([a, b, c], -1), np.stack([a, c, d], -1)], 2).reshape(-1, 3)


class Gusset:
    """The table of gusset-files, without numpy views of the result."""

    def __init__(self, library):
        text, size = ctypes.c_char_p, ctypes.c_size_t
        pointer = ctypes.c_void_p

        class Table(ctypes.Structure):
            _fields_ = [("struct_size", size),
                        ("read", ctypes.CFUNCTYPE(ctypes.c_int32, text, pointer, size, pointer, ctypes.c_uint32, ctypes.POINTER(pointer))),
                        ("write", ctypes.CFUNCTYPE(ctypes.c_int32, text, pointer, pointer, size, pointer, ctypes.c_uint32, ctypes.POINTER(pointer))),
                        ("part_count", ctypes.CFUNCTYPE(ctypes.c_uint32, pointer)),
                        ("part_name", ctypes.CFUNCTYPE(text, pointer, ctypes.c_uint32)),
                        ("part_bytes", ctypes.CFUNCTYPE(pointer, pointer, ctypes.c_uint32, ctypes.POINTER(size))),
                        ("message", ctypes.CFUNCTYPE(text, pointer)),
                        ("free", ctypes.CFUNCTYPE(None, pointer))]

        loaded = ctypes.CDLL(str(library))
        loaded.gusset_files_entry.restype = ctypes.POINTER(Table)
        self.table = loaded.gusset_files_entry(1).contents

    def _result(self, status, made):
        if status != 0:
            raise RuntimeError(self.table.message(made).decode())
        return made

    def _part(self, made, which):
        size = ctypes.c_size_t()
        data = self.table.part_bytes(made, which, ctypes.byref(size))
        return ctypes.string_at(data, size.value)

    def read(self, path, flags=0):
        with open(path, "rb") as file:
            data = file.read()
        made = ctypes.c_void_p()
        self._result(self.table.read(path.name.encode(), data, len(data), None, 1 | flags, ctypes.byref(made)), made)
        self.table.free(made)

    def document(self, path):
        """The document of a file as text and arrays, for `write`."""
        data, made = path.read_bytes(), ctypes.c_void_p()
        self._result(self.table.read(path.name.encode(), data, len(data), None, 1, ctypes.byref(made)), made)
        parts = self._part(made, 0), self._part(made, 1)
        self.table.free(made)
        return parts

    def write(self, document, path):
        described, arrays = document
        made = ctypes.c_void_p()
        self._result(self.table.write(path.name.encode(), described, arrays, len(arrays), None, 2, ctypes.byref(made)), made)
        size = ctypes.c_size_t()
        data = self.table.part_bytes(made, 1, ctypes.byref(size))
        with open(path, "wb") as file:
            file.write((ctypes.c_char * size.value).from_address(data))
        self.table.free(made)


@cache
def assimp():
    """The C interface of assimp."""
    library = ctypes.CDLL("libassimp.so.5")
    library.aiImportFile.restype, library.aiImportFile.argtypes = ctypes.c_void_p, [ctypes.c_char_p, ctypes.c_uint]
    library.aiReleaseImport.argtypes = [ctypes.c_void_p]
    library.aiExportScene.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_uint]
    return library


def assimp_read(path):
    join_identical_vertices = 0x2 if path.suffix == ".stl" else 0
    scene = assimp().aiImportFile(os.fsencode(path), join_identical_vertices)
    if not scene:
        raise RuntimeError("assimp does not read it")
    return scene


def assimp_write(scene, path):
    kinds = {"stl": b"stlb", "obj": b"obj", "ply": b"plyb", "glb": b"glb2"}
    if assimp().aiExportScene(scene, kinds[path.suffix[1:]], os.fsencode(path), 0) != 0:
        raise RuntimeError("assimp does not write it")


def readers(ours, path):
    """Each reads the file to a mesh whose equal points are one."""
    return [Contender("gusset", lambda _: ours.read(path)),
            Contender("assimp", lambda _: assimp().aiReleaseImport(assimp_read(path))),
            Contender("trimesh", lambda _: trimesh.load(str(path), force="mesh")),
            Contender("meshlib", lambda _: mm.loadMesh(str(path)))]


def writers(ours, path, source, finished, points, faces):
    """Each writes the same triangles from its own arrays; the last one the bytes of the finished file."""
    document, scene = ours.document(source), cache(lambda: assimp_read(source))
    mesh, built = cache(lambda: trimesh.Trimesh(points, faces, process=False)), cache(lambda: mn.meshFromFacesVerts(faces.astype(np.int32), points))
    return [Contender("gusset", lambda _: ours.write(document, path)),
            Contender("assimp", lambda made: assimp_write(made, path), scene),
            Contender("trimesh", lambda made: made.export(str(path)), mesh),
            Contender("meshlib", lambda made: mm.saveMesh(made, str(path)), built),
            Contender("write", path.write_bytes, cache(lambda: finished.read_bytes()))]


def run(library, report, folder, only):
    ours = Gusset(library)
    points, faces = wavy_square(SIDE)
    source = folder / "square.ply"
    write_ply(source, points, faces)
    document = ours.document(source)
    for extension in FORMATS:
        file, out = folder / f"square.{extension}", folder / f"written.{extension}"
        ours.write(document, file)
        for kind, contenders in (("read", lambda: readers(ours, file)), ("write", lambda: writers(ours, out, source, file, points, faces))):
            if any(only in f"io/{kind}/{extension}/{peer}" for peer in PEERS[kind]):
                outcomes = by_turns(contenders(), patience=30.0)
                for peer in PEERS[kind]:
                    report.add(f"io/{kind}/{extension}", peer, outcomes["gusset"], outcomes[peer])
    chosen = {row: flags for row, flags in LARGE.items() if only in row}
    large = folder / "large.stl"
    if chosen:
        write_stl(large, *wavy_square(LARGE_SIDE))
    for row, flags in chosen.items():
        contenders = [Contender("gusset", lambda _, flags=flags: ours.read(large, flags)), Contender("read", lambda _: large.read_bytes())]
        outcomes = by_turns(contenders, patience=30.0)
        report.add(row.removesuffix("/read"), "read", outcomes["gusset"], outcomes["read"])
    large.unlink(missing_ok=True)


def write_ply(path, points, faces):
    head = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
    head += f"element face {len(faces)}\nproperty list uchar uint vertex_indices\nend_header\n"
    rows = np.empty(len(faces), np.dtype([("count", "u1"), ("corners", "<u4", 3)]))
    rows["count"], rows["corners"] = 3, faces
    Path(path).write_bytes(head.encode() + points.tobytes() + rows.tobytes())


def write_stl(path, points, faces):
    rows = np.zeros(len(faces), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]))
    rows["corners"] = points[faces]
    Path(path).write_bytes(bytes(80) + np.uint32(len(faces)).tobytes() + rows.tobytes())
