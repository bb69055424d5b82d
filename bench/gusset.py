"""gusset through its C interface: the only file here that knows it. Results own their handles and copy nothing."""

import ctypes
from ctypes import POINTER, Structure, byref, c_double, c_int64, c_size_t, c_uint32, c_void_p
from pathlib import Path

import numpy as np

F64, BOUNDARY_ONLY = 2, 1
MERIDIANS = {"area": 0, "index": 1, "arc-length": 2, "greedy": 3, "min-diagonal": 4, "smooth": 5, "quad": 6}
ROWS_MEAN_EDGE, ROWS_COUNT = 1, 2
START_GIVEN = 2
FAIRING_THIN_PLATE = 1
SEARCH_EXACT = 1


class View(Structure):
    _fields_ = [(name, kind) for name, kind in [
        ("struct_size", c_size_t), ("positions", c_void_p), ("position_stride", c_size_t), ("vertex_count", c_size_t),
        ("face_offsets", c_void_p), ("face_corners", c_void_p), ("face_count", c_size_t), ("scalar", c_uint32),
        ("index", c_uint32), ("face_size", c_uint32), ("reserved", c_uint32)]]


class Indices(Structure):
    _fields_ = [("data", c_void_p), ("count", c_size_t)]


class BoundaryOptions(Structure):
    _fields_ = [("struct_size", c_size_t), ("non_manifold", c_uint32), ("survey", c_uint32)]


class StitchOptions(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("meridians", c_uint32), ("orientation", c_uint32), ("twist", c_int64),
        ("extent", c_uint32), ("run", c_uint32), ("rows", c_uint32), ("row_count", c_uint32), ("cells", c_uint32),
        ("tolerance_mode", c_uint32), ("tolerance", c_double), ("arc_a", c_uint32 * 2), ("arc_b", c_uint32 * 2),
        ("search", c_uint32), ("start", c_uint32), ("fairing", c_uint32), ("intersections", c_uint32),
        ("centres", c_uint32), ("reserved", c_uint32)]


class StripOptions(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("meridians", c_uint32), ("search", c_uint32), ("start", c_uint32), ("closed", c_uint32)]


class StripParts(Structure):
    _fields_ = [("struct_size", c_size_t), ("start", c_uint32 * 2), ("meridians", Indices), ("triangles", Indices)]


class Parts(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("vertex_map", Indices * 2), ("face_map", Indices * 2), ("rim", Indices * 2),
        ("meridians", Indices), ("matrix", Indices), ("parents", Indices), ("weights", c_void_p),
        ("strip_face_first", c_size_t), ("strip_face_count", c_size_t), ("row_count", c_uint32), ("closed", c_uint32),
        ("turned", c_uint32), ("intersections_known", c_uint32), ("intersections", Indices), ("back_off_count", c_uint32),
        ("reserved", c_uint32)]


def sized(kind):
    made = kind()
    made.struct_size = ctypes.sizeof(kind)
    return made


def array(data, count, kind):
    """The library's own memory as an array, valid until its handle is destroyed."""
    if count == 0:
        return np.empty(0, dtype=kind)
    return np.frombuffer((ctypes.c_char * (count * np.dtype(kind).itemsize)).from_address(data), dtype=kind)


class Handle:
    def __init__(self, library, destroy, address):
        self.library, self.destroy, self.address = library, destroy, address

    def __del__(self):
        getattr(self.library, self.destroy)(self.address)


class Library:
    def __init__(self, prefix):
        self.c = ctypes.CDLL(str(Path(prefix) / "lib" / "libgusset.so"))
        self.c.gusset_version.restype = self.c.gusset_status_text.restype = ctypes.c_char_p
        self.c.gusset_boundary_loop_count.restype = c_size_t
        for name in ("boundary", "stitch", "strip"):
            getattr(self.c, f"gusset_{name}_destroy").argtypes = [c_void_p]
        self.version = self.c.gusset_version().decode()

    def _check(self, status):
        if status:
            raise RuntimeError(self.c.gusset_status_text(status).decode())

    @staticmethod
    def _view(mesh):
        view = sized(View)
        view.positions, view.vertex_count = mesh.points.ctypes.data, len(mesh.points)
        view.face_corners, view.face_count = mesh.faces.ctypes.data, len(mesh.faces)
        view.scalar, view.face_size = F64, 3
        return view

    @staticmethod
    def options(meridians="area", rows=0, row_count=0, fairing=0):
        options = sized(StitchOptions)
        options.meridians, options.rows, options.row_count = MERIDIANS[meridians], rows, row_count
        options.fairing = fairing
        return options

    def boundary(self, mesh, survey=BOUNDARY_ONLY):
        options, address = sized(BoundaryOptions), c_void_p()
        options.survey = survey
        self._check(self.c.gusset_boundary_create(None, byref(self._view(mesh)), byref(options), byref(address)))
        return Handle(self.c, "gusset_boundary_destroy", address)

    def loop_count(self, boundary):
        return self.c.gusset_boundary_loop_count(boundary.address)

    def stitch(self, pieces, options):
        """Two meshes joined, from arrays to arrays: loops found, chosen and stitched."""
        a, b, address = self._view(pieces[0]), self._view(pieces[1]), c_void_p()
        self._check(self.c.gusset_stitch_create(None, byref(a), None, byref(b), None, byref(options), byref(address)))
        return Handle(self.c, "gusset_stitch_destroy", address)

    def strip(self, rim_a, rim_b, meridians="area", search=0):
        """The faces between two closed lines side by side, through the meridian between their first points."""
        options, address = sized(StripOptions), c_void_p()
        options.meridians, options.search, options.start, options.closed = MERIDIANS[meridians], search, START_GIVEN, 1
        self._check(self.c.gusset_strip_create(
            None, c_void_p(rim_a.ctypes.data), c_size_t(len(rim_a)), c_void_p(rim_b.ctypes.data), c_size_t(len(rim_b)),
            byref(options), byref(address)))
        return Handle(self.c, "gusset_strip_destroy", address)

    def strip_area(self, strip, rim_a, rim_b):
        """What the choice of least area makes least."""
        parts = sized(StripParts)
        self._check(self.c.gusset_strip_view(strip.address, byref(parts)))
        corners = np.concatenate([rim_a, rim_b])[array(parts.triangles.data, parts.triangles.count, np.uint32).reshape(-1, 3)]
        sides = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        return float(np.linalg.norm(np.cross(*sides), axis=1).sum() / 2)

    def mesh(self, stitch):
        """Points, triangles, and the first new one."""
        view, parts = sized(View), sized(Parts)
        self._check(self.c.gusset_stitch_mesh(stitch.address, byref(view)))
        self._check(self.c.gusset_stitch_view(stitch.address, byref(parts)))
        points = array(view.positions, 3 * view.vertex_count, np.float64).reshape(-1, 3)
        return points, array(view.face_corners, 3 * view.face_count, np.uint32).reshape(-1, 3), parts.strip_face_first

    def rims(self, stitch):
        """The points of both rims, side by side from the first meridian on."""
        parts = sized(Parts)
        self._check(self.c.gusset_stitch_view(stitch.address, byref(parts)))
        points = self.mesh(stitch)[0]
        return [np.ascontiguousarray(points[array(rim.data, rim.count, np.uint32)]) for rim in parts.rim]
