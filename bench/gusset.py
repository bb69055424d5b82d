"""gusset through its C interface: the only file here that knows it. Results own their handles and copy nothing."""

import ctypes
from ctypes import POINTER, Structure, byref, c_double, c_int64, c_size_t, c_uint32, c_uint64, c_void_p
from pathlib import Path

import numpy as np

F32, F64, BOUNDARY_ONLY = 1, 2, 1
MERIDIANS = {
    "continuation": 0, "index": 1, "arc-length": 2, "greedy": 3, "min-diagonal": 4, "smooth": 5, "quad": 6, "area": 7}
ROWS_MEAN_EDGE, ROWS_COUNT = 1, 2
START_GIVEN = 2
FAIRING_THIN_PLATE = 1
FINISH_BLEND = 1
REFINE_RIM_DENSITY, KEEP_LONGEST, INTERSECTIONS_IGNORE = 1, 1, 1
SEARCH_EXACT = 1
# Nets: gluing of the sides.
SIDES = {"sheet": 0, "torus": 3, "two-poles": 13}
OPERATION_MATRIX, DIRECTION_DOWN = 7, 1
# Outlines: curve, method, lock.
OUTLINES = {
    "composite": (0, 0, 0), "composite-median": (0, 1, 0), "self": (0, 0, 1), "cubic": (4, 0, 0), "blend": (2, 0, 0),
    "blend-c2": (3, 0, 0)}


class View(Structure):
    _fields_ = [(name, kind) for name, kind in [
        ("struct_size", c_size_t), ("positions", c_void_p), ("position_stride", c_size_t), ("vertex_count", c_size_t),
        ("face_offsets", c_void_p), ("face_corners", c_void_p), ("face_count", c_size_t), ("scalar", c_uint32),
        ("index", c_uint32), ("face_size", c_uint32), ("reserved", c_uint32)]]


class Indices(Structure):
    _fields_ = [("data", c_void_p), ("count", c_size_t)]


class BoundaryOptions(Structure):
    _fields_ = [("struct_size", c_size_t), ("non_manifold", c_uint32), ("survey", c_uint32)]


class BoundaryParts(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("loop_count", c_size_t), ("walk_count", c_size_t), ("defects", c_void_p), ("defect_count", c_size_t)]


class CuttingPlanes(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("kind", c_uint32), ("closed", c_uint32), ("point", c_double * 3), ("direction", c_double * 3),
        ("reference", c_double * 3), ("values", c_void_p), ("value_count", c_size_t), ("points", c_void_p), ("normals", c_void_p),
        ("point_count", c_size_t)]


class SectionsView(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("plane_count", c_size_t), ("path_count", c_size_t), ("point_count", c_size_t), ("paths", c_void_p),
        ("starts", Indices), ("points", c_void_p), ("edges", c_void_p), ("parameters", c_void_p), ("faces", Indices)]


class StitchOptions(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("meridians", c_uint32), ("orientation", c_uint32), ("twist", c_int64),
        ("extent", c_uint32), ("run", c_uint32), ("rows", c_uint32), ("row_count", c_uint32), ("cells", c_uint32),
        ("tolerance_mode", c_uint32), ("tolerance", c_double), ("arc_a", c_uint32 * 2), ("arc_b", c_uint32 * 2),
        ("search", c_uint32), ("start", c_uint32), ("fairing", c_uint32), ("intersections", c_uint32),
        ("centres", c_uint32), ("outward", c_uint32), ("finish", c_uint32), ("reserved", c_uint32)]


class StripOptions(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("meridians", c_uint32), ("search", c_uint32), ("start", c_uint32), ("closed", c_uint32),
        ("rows", c_uint32), ("row_count", c_uint32), ("cells", c_uint32), ("reserved", c_uint32)]


class Parts(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("vertex_map", Indices * 2), ("face_map", Indices * 2), ("rim", Indices * 2),
        ("meridians", Indices), ("matrix", Indices), ("parents", Indices), ("weights", c_void_p),
        ("strip_face_first", c_size_t), ("strip_face_count", c_size_t), ("row_count", c_uint32), ("closed", c_uint32),
        ("turned", c_uint32), ("intersections_known", c_uint32), ("intersections", Indices), ("back_off_count", c_uint32),
        ("finish", c_uint32), ("turned_outwards", Indices)]


class LoopPair(Structure):
    _fields_ = [("piece", c_uint32 * 2), ("vertex", c_uint32 * 2)]


class JoinOptions(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("weld", c_uint32), ("orientation", c_uint32), ("gap", c_uint32),
        ("extent", c_uint32), ("within_components", c_uint32), ("fill", c_uint32), ("max_gap", c_double),
        ("pairs", POINTER(LoopPair)), ("pair_count", c_size_t), ("excluded", c_void_p), ("excluded_count", c_size_t),
        ("weld_options", c_void_p), ("strip_options", POINTER(StitchOptions)), ("fill_options", c_void_p),
        ("outward", c_uint32), ("overlaps", c_uint32), ("trim_options", c_void_p)]


class Transform(Structure):
    _fields_ = [("rows", c_double * 12)]


ALIGN_FEATURES = 3


class AlignmentOptions(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("start", c_uint32), ("samples", c_uint32), ("poses", POINTER(Transform)),
        ("pose_count", c_size_t), ("max_distance", c_double), ("max_rounds", c_uint32), ("reserved", c_uint32)]


class AlignedPiece(Structure):
    _fields_ = [("pose", Transform), ("hold", c_double), ("reason", c_uint32), ("reserved", c_uint32)]


class AlignmentParts(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("pieces", POINTER(AlignedPiece)), ("piece_count", c_size_t), ("overlaps", c_void_p),
        ("overlap_count", c_size_t), ("rounds", c_uint32), ("converged", c_uint32)]


class NetMeshOptions(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("faces", c_uint32), ("no_weld", c_uint32), ("keep_unused", c_uint32),
        ("fill_corners", c_uint32), ("texture", c_uint32), ("reserved", c_uint32), ("max_edge_ratio", c_double)]


class Joint(Structure):
    _fields_ = [
        ("sides", Indices * 2), ("gap", c_double), ("vertex_first", c_size_t), ("vertex_count", c_size_t),
        ("face_first", c_size_t), ("face_count", c_size_t), ("intersections", Indices), ("intersections_known", c_uint32),
        ("outcome", c_uint32), ("whole", c_uint32), ("finish", c_uint32)]


class PieceMap(Structure):
    _fields_ = [("vertices", Indices), ("faces", Indices)]


class RepairReport(Structure):
    _fields_ = [("struct_size", c_size_t), ("valid", c_uint32), ("rest", c_uint32 * 37)]


class JoinReport(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("pieces", POINTER(PieceMap)), ("piece_count", c_size_t), ("joints", POINTER(Joint)),
        ("joint_count", c_size_t), ("left", c_void_p), ("left_count", c_size_t), ("holes", c_void_p), ("hole_count", c_size_t),
        ("hole_rims", Indices), ("turned", Indices), ("one_sided", Indices), ("zero_volume", Indices), ("welded_vertices", c_uint32),
        ("sewn_edges", c_uint32), ("loops_left", c_uint32), ("non_manifold_edges", c_uint32),
        ("splits", c_uint32), ("near_loops_left", c_uint32), ("trimmed_faces", c_uint32), ("reserved", c_uint32)]


class FillOptions(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("weight", c_uint32), ("refine", c_uint32), ("fairing", c_uint32), ("keep", c_uint32),
        ("intersections", c_uint32), ("plan_only", c_uint32), ("max_new_vertices", c_uint32), ("max_edges", c_uint32),
        ("max_length", c_double), ("max_diameter", c_double), ("max_area", c_double), ("outward", c_uint32),
        ("reserved", c_uint32)]


class OutlinesGiven(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("points", c_void_p), ("point_stride", c_size_t), ("point_count", c_size_t),
        ("offsets", c_void_p), ("outline_count", c_size_t), ("constraints", c_void_p), ("constraint_count", c_size_t),
        ("dimension", c_uint32), ("closed", c_uint32)]


class OutlineOptions(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("curve", c_uint32), ("method", c_uint32), ("lock", c_uint32), ("joint", c_uint32),
        ("solver", c_uint32), ("ends", c_uint32), ("alpha", c_double), ("parameter_limit", c_double),
        ("repeat_tolerance", c_double), ("corner_angle", c_double), ("tolerance", c_double), ("max_sweeps", c_uint32),
        ("max_steps", c_uint32)]


class OutlineParts(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("outline_count", c_size_t), ("point_count", c_size_t), ("controls", c_void_p),
        ("control_count", c_size_t), ("ends", Indices), ("starts", c_void_p), ("segments", Indices),
        ("parameters", c_void_p), ("statuses", c_void_p)]


class NetArrays(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("rows", c_size_t), ("columns", c_size_t), ("x", c_void_p), ("y", c_void_p), ("z", c_void_p),
        ("row_stride", c_size_t), ("column_stride", c_size_t), ("scalar", c_uint32), ("reserved", c_uint32)]


class NetGluing(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("matrix", c_void_p), ("seams", c_void_p), ("seam_count", c_size_t), ("sides", c_uint32),
        ("reversed", c_uint32)]


class NetOperation(Structure):
    _fields_ = [("kind", c_uint32), ("axis", c_uint32), ("values", c_double * 12)]


class ConcatenateOptions(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("tolerance", c_double), ("tension", c_double), ("elasticity", c_double),
        ("stiffness", c_double), ("user", c_uint64), ("direction", c_uint32), ("mode", c_uint32), ("equalise", c_uint32),
        ("equalise_index", c_uint32), ("twist", c_uint32), ("turn", c_uint32)]


class StreamView(Structure):
    _fields_ = [("struct_size", c_size_t), ("data", c_void_p), ("size", c_size_t)]


class StreamOptions(Structure):
    _fields_ = [
        ("struct_size", c_size_t), ("rows_per_block", c_size_t), ("mode", c_uint32), ("bits", c_uint32), ("per_axis", c_uint32),
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
        for name in ("alignment", "boundary", "mesh_sections", "result", "outline", "context", "net", "stream"):
            getattr(self.c, f"gusset_{name}_destroy").argtypes = [c_void_p]
        self.one_thread, self.automatic = self._context(1), self._context(0)
        self.version = self.c.gusset_version().decode()

    def _check(self, status):
        if status:
            raise RuntimeError(self.c.gusset_status_text(status).decode())

    def _context(self, threads):
        address = c_void_p()
        self._check(self.c.gusset_context_create(byref(address)))
        self._check(self.c.gusset_context_set_threads(address, c_uint32(threads)))
        return Handle(self.c, "gusset_context_destroy", address)

    @staticmethod
    def _view(mesh):
        view = sized(View)
        view.positions, view.vertex_count = mesh.points.ctypes.data, len(mesh.points)
        view.face_corners, view.face_count = mesh.faces.ctypes.data, len(mesh.faces)
        view.scalar, view.face_size = F64, 3
        return view

    @staticmethod
    def options(meridians="continuation", rows=0, row_count=0, fairing=0, finish=0):
        options = sized(StitchOptions)
        options.meridians, options.rows, options.row_count = MERIDIANS[meridians], rows, row_count
        options.fairing, options.finish = fairing, finish
        return options

    @staticmethod
    def fill_options(**given):
        options = sized(FillOptions)
        for name, value in given.items():
            setattr(options, name, value)
        return options

    def boundary(self, mesh, survey=BOUNDARY_ONLY):
        options, address = sized(BoundaryOptions), c_void_p()
        options.survey = survey
        self._check(self.c.gusset_boundary_create(None, byref(self._view(mesh)), byref(options), byref(address)))
        return Handle(self.c, "gusset_boundary_destroy", address)

    def loop_count(self, boundary):
        parts = sized(BoundaryParts)
        self._check(self.c.gusset_boundary_get_view(boundary.address, byref(parts)))
        return parts.loop_count

    def sections(self, mesh, heights):
        """Polylines in planes across z."""
        planes, address = sized(CuttingPlanes), c_void_p()
        planes.direction[2], planes.values, planes.value_count = 1.0, heights.ctypes.data, len(heights)
        self._check(self.c.gusset_mesh_sections_create(None, byref(self._view(mesh)), byref(planes), None, byref(address)))
        return Handle(self.c, "gusset_mesh_sections_destroy", address)

    def section_counts(self, sections):
        """The numbers of polylines and of points."""
        view = sized(SectionsView)
        self._check(self.c.gusset_mesh_sections_get_view(sections.address, byref(view)))
        return view.path_count, view.point_count

    def stitch(self, pieces, options):
        """Two meshes joined, from arrays to arrays: loops found, chosen and stitched."""
        a, b, address = self._view(pieces[0]), self._view(pieces[1]), c_void_p()
        self._check(self.c.gusset_stitch(None, byref(a), None, byref(b), None, byref(options), byref(address)))
        return Handle(self.c, "gusset_result_destroy", address)

    def strip(self, rim_a, rim_b, meridians="area", search=0):
        """The faces between two closed lines side by side, through the meridian between their first points."""
        options, address = sized(StripOptions), c_void_p()
        options.meridians, options.search, options.start, options.closed = MERIDIANS[meridians], search, START_GIVEN, 1
        self._check(self.c.gusset_strip(
            None, c_void_p(rim_a.ctypes.data), c_size_t(len(rim_a)), c_void_p(rim_b.ctypes.data), c_size_t(len(rim_b)),
            byref(options), byref(address)))
        return Handle(self.c, "gusset_result_destroy", address)

    def strip_area(self, strip, rim_a, rim_b):
        """The area that the choice of least area minimises."""
        view = sized(View)
        self._check(self.c.gusset_result_get_mesh(strip.address, byref(view)))
        corners = np.concatenate([rim_a, rim_b])[array(view.face_corners, 3 * view.face_count, np.uint32).reshape(-1, 3)]
        sides = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        return float(np.linalg.norm(np.cross(*sides), axis=1).sum() / 2)

    def mesh(self, stitch):
        """Points, triangles, and the first new one."""
        view, parts = sized(View), sized(Parts)
        self._check(self.c.gusset_result_get_mesh(stitch.address, byref(view)))
        self._check(self.c.gusset_result_get_stitch(stitch.address, byref(parts)))
        points = array(view.positions, 3 * view.vertex_count, np.float64).reshape(-1, 3)
        return points, array(view.face_corners, 3 * view.face_count, np.uint32).reshape(-1, 3), parts.strip_face_first

    def rims(self, stitch):
        """The points of both rims, side by side from the first meridian on."""
        parts = sized(Parts)
        self._check(self.c.gusset_result_get_stitch(stitch.address, byref(parts)))
        points = self.mesh(stitch)[0]
        return [np.ascontiguousarray(points[array(rim.data, rim.count, np.uint32)]) for rim in parts.rim]

    def assembly(self, pieces, pairs=(), strip=None):
        """Many meshes joined; `pairs` of loops, each named by a piece and a vertex of it."""
        views = (View * len(pieces))(*(self._view(piece) for piece in pieces))
        options, address = sized(JoinOptions), c_void_p()
        given = (LoopPair * len(pairs))(*(LoopPair((a[0], b[0]), (a[1], b[1])) for a, b in pairs))
        options.pairs, options.pair_count = given, len(pairs)
        if strip is not None:
            options.strip_options = ctypes.pointer(strip)
        self._check(self.c.gusset_join(None, views, c_size_t(len(pieces)), byref(options), byref(address)))
        return Handle(self.c, "gusset_result_destroy", address)

    def trimmed_and_joined(self, pieces, max_diameter=0.0):
        """Trims overlaps, joins the pieces and fills holes, up to a diameter if one is given. Returns points, triangles, and for
        each piece its vertices in the result."""
        views = (View * len(pieces))(*(self._view(piece) for piece in pieces))
        options, address = sized(JoinOptions), c_void_p()
        options.overlaps = options.fill = 1
        fill = self.fill_options(max_diameter=max_diameter)
        options.fill_options = ctypes.cast(ctypes.pointer(fill), c_void_p)
        self._check(self.c.gusset_join(None, views, c_size_t(len(pieces)), byref(options), byref(address)))
        made = Handle(self.c, "gusset_result_destroy", address)
        points, faces, maps, _ = self.assembled(made)
        return points.copy(), faces.copy(), [of.copy() for of in maps]

    def aligned(self, pieces, poses):
        """The poses that pieces belong in, from poses near them; matrices 4 x 4."""
        options = sized(AlignmentOptions)
        given = (Transform * len(poses))(*(Transform((c_double * 12)(*pose[:3].ravel())) for pose in poses))
        options.poses, options.pose_count = given, len(poses)
        return self._aligned(pieces, options)[0]

    def aligned_freely(self, pieces):
        """The poses of pieces that lie anywhere, and which of them are trusted."""
        options = sized(AlignmentOptions)
        options.start = ALIGN_FEATURES
        return self._aligned(pieces, options)

    def _aligned(self, pieces, options):
        views = (View * len(pieces))(*(self._view(piece) for piece in pieces))
        address, parts = c_void_p(), sized(AlignmentParts)
        self._check(self.c.gusset_alignment_create(None, views, c_size_t(len(pieces)), byref(options), byref(address)))
        made = Handle(self.c, "gusset_alignment_destroy", address)
        self._check(self.c.gusset_alignment_get_view(made.address, byref(parts)))
        rows = [np.array(parts.pieces[k].pose.rows[:]).reshape(3, 4) for k in range(parts.piece_count)]
        is_trusted = [parts.pieces[k].reason == 0 for k in range(parts.piece_count)]
        return [np.vstack([own, [0, 0, 0, 1]]) for own in rows], is_trusted

    def net_triangles(self, grid, max_edge_ratio):
        """The triangles of a range image H x W x 3, NaN where nothing was seen, without steps: points and faces."""
        net, options, address, view = self.net(grid, "sheet"), sized(NetMeshOptions), c_void_p(), sized(View)
        options.faces, options.fill_corners, options.max_edge_ratio = 1, 1, max_edge_ratio
        self._check(self.c.gusset_net_to_mesh(None, net.address, byref(options), byref(address)))
        made = Handle(self.c, "gusset_result_destroy", address)
        self._check(self.c.gusset_result_get_mesh(made.address, byref(view)))
        points = array(view.positions, 3 * view.vertex_count, np.float32).reshape(-1, 3)
        faces = array(view.face_corners, 3 * view.face_count, np.uint32).reshape(-1, 3)
        return points.astype(np.float64), faces.copy()

    def assembled(self, assembly):
        """Points, triangles, for each piece its vertices in the result, and the two sides of each joint that was made."""
        view, parts = sized(View), sized(JoinReport)
        self._check(self.c.gusset_result_get_mesh(assembly.address, byref(view)))
        self._check(self.c.gusset_result_get_join(assembly.address, byref(parts)))
        points = array(view.positions, 3 * view.vertex_count, np.float64).reshape(-1, 3)
        faces = array(view.face_corners, 3 * view.face_count, np.uint32).reshape(-1, 3)
        pieces = [parts.pieces[k].vertices for k in range(parts.piece_count)]
        maps = [array(piece.data, piece.count, np.uint32) for piece in pieces]
        joints = [parts.joints[k] for k in range(parts.joint_count)]
        joined = [[array(side.data, side.count, np.uint32) for side in joint.sides] for joint in joints if joint.outcome == 0]
        return points, faces, maps, joined

    def fill(self, mesh, options=None):
        """All holes filled, from arrays to arrays."""
        address = c_void_p()
        given = byref(options) if options is not None else None
        self._check(self.c.gusset_fill(None, byref(self._view(mesh)), None, c_size_t(0), given, byref(address)))
        return Handle(self.c, "gusset_result_destroy", address)

    def filled(self, fill):
        """Points and triangles."""
        view = sized(View)
        self._check(self.c.gusset_result_get_mesh(fill.address, byref(view)))
        points = array(view.positions, 3 * view.vertex_count, np.float64).reshape(-1, 3)
        return points, array(view.face_corners, 3 * view.face_count, np.uint32).reshape(-1, 3)

    def repair(self, mesh):
        address = c_void_p()
        self._check(self.c.gusset_repair(None, byref(self._view(mesh)), None, byref(address)))
        return Handle(self.c, "gusset_result_destroy", address)

    def repaired(self, repair):
        """Points and triangles. A repair may leave larger faces only if it is given some."""
        return self.filled(repair)

    def unite(self, meshes):
        views, address = (View * len(meshes))(*map(self._view, meshes)), c_void_p()
        self._check(self.c.gusset_unite(None, views, c_size_t(len(meshes)), byref(address)))
        return Handle(self.c, "gusset_result_destroy", address)

    def is_valid(self, union):
        report = sized(RepairReport)
        self._check(self.c.gusset_result_get_repair(union.address, byref(report)))
        return report.valid == 1

    def outline(self, outlines, kind):
        """The curves through the points of closed outlines, by one thread."""
        given, options, address = sized(OutlinesGiven), sized(OutlineOptions), c_void_p()
        given.points, given.point_count = outlines.points.ctypes.data, len(outlines.points)
        given.offsets, given.outline_count = outlines.offsets.ctypes.data, len(outlines.offsets) - 1
        given.dimension, given.closed = 2, 1
        options.curve, options.method, options.lock = OUTLINES[kind]
        self._check(self.c.gusset_outline_create(self.one_thread.address, byref(given), byref(options), byref(address)))
        return Handle(self.c, "gusset_outline_destroy", address)

    def outline_sampled(self, outline, fine):
        """Each curve as a polygon with `fine` sides for each segment."""
        parts = sized(OutlineParts)
        self._check(self.c.gusset_outline_get_view(outline.address, byref(parts)))
        controls = array(parts.controls, 3 * parts.control_count, np.float64).reshape(-1, 3)[:, :2]
        ends = array(parts.ends.data, parts.ends.count, np.uint32).astype(np.int64)
        starts = array(parts.starts, 2 * (parts.outline_count + 1), np.uint64).astype(np.int64).reshape(-1, 2)
        t = (np.arange(fine) / fine)[:, None]
        found = []
        for (point, end), (_, next_end) in zip(starts[:-1], starts[1:]):
            polygon = []
            for a, b in zip(ends[end:next_end - 1], ends[end + 1:next_end]):
                rungs = [controls[point + k] for k in range(a, b + 1)]
                while len(rungs) > 1:
                    rungs = [p * (1 - t) + q * t for p, q in zip(rungs, rungs[1:])]
                polygon.append(rungs[0])
            found.append(np.concatenate(polygon))
        return found

    def net(self, points, sides, as_matrix=False):
        """A net of a copy of an array H x W x 3 in single precision; its gluing as sides, or as a matrix that no sides say."""
        arrays, gluing, address = sized(NetArrays), sized(NetGluing), c_void_p()
        height, width = points.shape[:2]
        arrays.rows, arrays.columns, arrays.scalar, arrays.column_stride = height, width, F32, 12
        arrays.x, arrays.y, arrays.z = (points.ctypes.data + 4 * axis for axis in range(3))
        if as_matrix:
            matrix = np.zeros((height, 2, width), dtype=np.uint8)
            matrix[:, 0, -1] = matrix[-1, 1, :] = matrix[height // 2, 0, ::7] = 1
            gluing.matrix = matrix.ctypes.data
        else:
            gluing.sides = SIDES[sides]
        self._check(self.c.gusset_net_create(self.one_thread.address, byref(arrays), byref(gluing), 0, byref(address)))
        return Handle(self.c, "gusset_net_destroy", address)

    def net_move(self, net, motion):
        operation = NetOperation(OPERATION_MATRIX, 0, (c_double * 12)(*motion))
        self._check(self.c.gusset_net_transform(self.one_thread.address, net.address, byref(operation), c_size_t(1)))

    def net_normals(self, net, room):
        """Into an array 3 x H x W."""
        x, y, z = (c_void_p(plane.ctypes.data) for plane in room)
        self._check(self.c.gusset_net_normals(self.one_thread.address, net.address, x, y, z, c_size_t(room[0].size), None))
        return room

    def net_join(self, a, b):
        """The second net below the first."""
        options, address = sized(ConcatenateOptions), c_void_p()
        options.direction = DIRECTION_DOWN
        both = (c_void_p * 2)(a.address, b.address)
        self._check(self.c.gusset_net_concatenate_create(
            self.one_thread.address, both, c_size_t(2), byref(options), byref(address)))
        return Handle(self.c, "gusset_net_destroy", address)

    def net_classes(self, net, room):
        written = c_size_t()
        self._check(self.c.gusset_net_classes(
            self.one_thread.address, net.address, c_void_p(room.ctypes.data), c_size_t(room.size), byref(written)))
        return room

    def net_encode(self, net, bits, automatic=False):
        options, address = sized(StreamOptions), c_void_p()
        options.bits = bits
        context = self.automatic if automatic else self.one_thread
        self._check(self.c.gusset_net_encode_create(context.address, net.address, byref(options), byref(address)))
        return Handle(self.c, "gusset_stream_destroy", address)

    def stream_bytes(self, stream):
        view = sized(StreamView)
        self._check(self.c.gusset_stream_get_view(stream.address, byref(view)))
        return array(view.data, view.size, np.uint8).copy()

    def net_decode(self, data, automatic=False):
        context, address = self.automatic if automatic else self.one_thread, c_void_p()
        self._check(self.c.gusset_net_decode_create(
            context.address, c_void_p(data.ctypes.data), c_size_t(data.size), c_uint64(0), byref(address)))
        return Handle(self.c, "gusset_net_destroy", address)
