"""Files by hand, and documents for tests of files."""

import numpy as np
import pytest
import shapes

import gusset_mesh as gm
from gusset_mesh import files

TEXT_PLY = """ply
format ascii 1.0
comment by hand
element vertex 5
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 1 0
0 1 0
0.5 0.5 1
4 0 1 2 3
3 0 1 4
"""

#: An image of one pixel.
PNG = bytes.fromhex(
    "89504e470d0a1a0a0000000d49484452000000010000000108060000001f15c4890000000d49444154789c6360f8cfc0000003010100c9fe92ef0000000049454e44ae426082"
)

_NAMES = {"<f8": "double", "<f4": "float", "u1": "uchar", "<i2": "short", "<i4": "int"}


def ply(order, vertex_count, face_count):
    """A binary PLY file of random triangles in a byte order, with its vertices and faces as arrays of structs."""
    random = np.random.default_rng(vertex_count)
    vertex = [(name, "<f8") for name in ("x", "y", "z", "nx", "ny", "nz")] + [(name, "u1") for name in ("red", "green", "blue", "alpha")]
    vertices = np.zeros(vertex_count, [*vertex, ("quality", "<f4")])
    for name in vertices.dtype.names:
        vertices[name] = random.integers(0, 256, vertex_count) if vertices.dtype[name] == np.uint8 else random.normal(size=vertex_count)
    faces = np.zeros(face_count, [("count", "u1"), ("vertex", "<i4", 3), ("label", "<i2")])
    faces["count"], faces["label"] = 3, random.integers(-5000, 5000, face_count)
    faces["vertex"] = np.argsort(random.random((face_count, vertex_count)) if vertex_count < 100 else random.random((face_count, 3)), axis=1)[:, :3]
    lines = ["ply", f"format binary_{'little' if order == '<' else 'big'}_endian 1.0", f"element vertex {vertex_count}"]
    lines += [f"property {_NAMES[kind]} {name}" for name, kind in [*vertex, ("quality", "<f4")]]
    lines += [f"element face {face_count}", "property list uchar int vertex_indices", "property short label", "end_header", ""]
    stored = [array.astype(array.dtype.newbyteorder(order)).tobytes() for array in (vertices, faces)]
    return "\n".join(lines).encode() + b"".join(stored), vertices, faces


def document(colour="red"):
    """A closed mesh with most attributes, and two materials."""
    points, faces = shapes.cap()
    mesh = gm.fill((points.astype(np.float32), faces)).mesh
    count, normals = mesh.vertex_count, mesh.points.astype(np.float64)
    colours = np.round(np.random.default_rng(3).random((count, 4)) * 255) / 255
    colours[:, 3] = 1
    one = gm.FileMesh(
        mesh, "ball", normals=normals / np.linalg.norm(normals, axis=1)[:, None], vertex_colours=colours,
        face_materials=np.arange(mesh.face_count) % 2,
        vertex_properties={"quality": np.arange(count)}, face_properties={"big": np.arange(mesh.face_count) + 2.0**40},
    )
    materials = [files.Material(colour, (1, 0, 0, 1)), files.Material("blue", (0, 0, 1, 1))]
    return gm.Document(meshes=[one], materials=materials)


def has_files():
    """Whether the library reads files."""
    try:
        files._table()
    except NotImplementedError:
        return False
    return True


def is_there(extension, folder):
    """Whether files with this extension are written and read already."""
    path = folder / f"probe.{extension}"
    try:
        gm.save(path, ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
        gm.read(path)
    except gm.InputError as failure:
        if "not yet" in str(failure):
            return False
        raise
    finally:
        path.unlink(missing_ok=True)
    return True


def require(extension, folder):
    """Skips a test unless files with this extension are written and read."""
    if not is_there(extension, folder):
        pytest.skip(f"the library does not read {extension} files yet")
