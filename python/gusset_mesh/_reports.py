"""Structs that the library fills, as classes with a property for each field. Written by generate.py; do not edit."""

# mypy: disable-error-code="no-any-return"
# fmt: off
from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from . import choices
from ._library import text
from ._records import FlagArray, Record, RecordArray, flags, word, words


class Place(Record):
    """A place on a curve."""

    __slots__ = ()
    _NAME = 'gusset_place'

    @property
    def segment(self) -> int:
        """Index of the segment."""
        return self._struct.segment

    @property
    def t(self) -> float:
        """Parameter, from 0 at the segment's start to 1 at its end."""
        return self._struct.t


class PlaceArray(RecordArray[Place]):
    """A place on a curve."""

    __slots__ = ()
    RECORD = Place

    @property
    def segment(self) -> NDArray[np.uint32]:
        """Index of the segment."""
        return self.array['segment']

    @property
    def t(self) -> NDArray[np.float64]:
        """Parameter, from 0 at the segment's start to 1 at its end."""
        return self.array['t']


class CurveView(Record):
    """Lent arrays of a curve."""

    __slots__ = ()
    _NAME = 'gusset_curve_view'
    _GETTER = 'gusset_curve_get_view'

    @property
    def controls(self) -> NDArray[np.float64]:
        """Control points; z is 0 for a plane curve."""
        return self._array('controls', self._struct.control_count, 3)

    @property
    def ends(self) -> NDArray[np.uint32]:
        """Segment k has the controls ends[k] to ends[k + 1]."""
        return self._array('ends')

    @property
    def closed(self) -> bool:
        """1 if closed."""
        return bool(self._struct.closed)


class OutlineView(Record):
    """Lent curves. Curve k has the controls starts[2k] to starts[2k + 2] - 1, and the ends starts[2k + 1] to
    starts[2k + 3] - 1. Its segment s has controls ends[s] to ends[s + 1], counted from the curve's first. A closed
    curve repeats its first control at the end.
    """

    __slots__ = ()
    _NAME = 'gusset_outline_view'
    _GETTER = 'gusset_outline_get_view'

    @property
    def outline_count(self) -> int:
        """Number of outlines."""
        return self._struct.outline_count

    @property
    def controls(self) -> NDArray[np.float64]:
        """Control points; z = 0 for plane outlines."""
        return self._array('controls', self._struct.control_count, 3)

    @property
    def ends(self) -> NDArray[np.uint32]:
        """Ends of segments."""
        return self._array('ends')

    @property
    def starts(self) -> NDArray[np.uintp]:
        """Two offsets a curve, and two more."""
        return self._array('starts', self._struct.outline_count + 1, 2)

    @property
    def segments(self) -> NDArray[np.uint32]:
        """Segment of each point."""
        return self._array('segments')

    @property
    def parameters(self) -> NDArray[np.float64]:
        """Parameter of each point, 0 to 1."""
        return self._array('parameters', self._struct.point_count)

    @property
    def statuses(self) -> NDArray[np.str_]:
        """gusset_point_status of each point."""
        return words(self._array('statuses', self._struct.point_count), 'gusset_point_status')


class OutlineReport(Record):
    """Outcome and accuracy of an outline. Lengths except `size` are relative to `size`."""

    __slots__ = ()
    _NAME = 'gusset_outline_report'
    _GETTER = 'gusset_outline_get_report'

    @property
    def fit(self) -> choices.FitStatus:
        """Outcome of an outline."""
        return word(self._struct.fit, 'gusset_fit_status')

    @property
    def iterations(self) -> int:
        """Most sweeps or iterations between corners, at most max_sweeps. A replacement of a solver that fails does
        not count.
        """
        return self._struct.iterations

    @property
    def steps(self) -> int:
        """Steps of GUSSET_SOLVER_STEP."""
        return self._struct.steps

    @property
    def size(self) -> float:
        """Longest side of the outline's box."""
        return self._struct.size

    @property
    def max_residual(self) -> float:
        """Largest distance of a point from the curve at its parameter; merged points count as their originals."""
        return self._struct.max_residual

    @property
    def max_joint_sine(self) -> float:
        """Largest sine of the angle between tangents at a smooth joint."""
        return self._struct.max_joint_sine

    @property
    def max_curvature_gap(self) -> float:
        """GUSSET_JOINT_PARAMETER_G2: largest difference of curvatures at a joint, relative to the larger, at least to
        1 / size. Else 0.
        """
        return self._struct.max_curvature_gap

    @property
    def last_move(self) -> float:
        """Largest move of a control point in the last iteration."""
        return self._struct.last_move

    @property
    def not_ok_count(self) -> int:
        """Points that are not GUSSET_POINT_OK."""
        return self._struct.not_ok_count


class OutlineCycle(Record):
    """A cycle of an iteration: a sweep over the points, or an iteration of Newton's method."""

    __slots__ = ()
    _NAME = 'gusset_outline_cycle'

    @property
    def moved(self) -> float:
        """Largest move of a control point, relative to the size of the outline."""
        return self._struct.moved

    @property
    def steps(self) -> int:
        """Steps of GUSSET_SOLVER_STEP up to the end of this cycle."""
        return self._struct.steps

    @property
    def control_end(self) -> int:
        """Number of control points of this cycle and all earlier ones."""
        return self._struct.control_end


class OutlineCycleArray(RecordArray[OutlineCycle]):
    """A cycle of an iteration: a sweep over the points, or an iteration of Newton's method."""

    __slots__ = ()
    RECORD = OutlineCycle

    @property
    def moved(self) -> NDArray[np.float64]:
        """Largest move of a control point, relative to the size of the outline."""
        return self.array['moved']

    @property
    def steps(self) -> NDArray[np.uint64]:
        """Steps of GUSSET_SOLVER_STEP up to the end of this cycle."""
        return self.array['steps']

    @property
    def control_end(self) -> NDArray[np.uint64]:
        """Number of control points of this cycle and all earlier ones."""
        return self.array['control_end']


class OutlineHistory(Record):
    """Lent cycles of an outline, in order, from corner to corner. Cycles of a start or a replacement of the solver
    are left out.
    """

    __slots__ = ()
    _NAME = 'gusset_outline_history'
    _GETTER = 'gusset_outline_get_history'

    @property
    def cycles(self) -> OutlineCycleArray:
        """The cycles."""
        return OutlineCycleArray(self._array('cycles', self._struct.cycle_count))

    @property
    def controls(self) -> NDArray[np.float64]:
        """Control points after each cycle. A single curve has all its own, also if a composite curve replaces it. A
        composite curve has one for each distinct point; at open ends, the point or the control point on the end's
        tangent.
        """
        return self._array('controls', self._struct.control_count, 3)


class CurveNearestPoint(Record):
    """Nearest point of a curve."""

    __slots__ = ()
    _NAME = 'gusset_curve_nearest_point'

    @property
    def place(self) -> Place:
        """Place on the curve."""
        return Place(self._struct.place, self._owner)

    @property
    def point(self) -> NDArray[np.float64]:
        """x, y, z."""
        return self._array('point')

    @property
    def distance(self) -> float:
        """Distance; infinite if it overflows."""
        return self._struct.distance


class CurveNearestPointArray(RecordArray[CurveNearestPoint]):
    """Nearest point of a curve."""

    __slots__ = ()
    RECORD = CurveNearestPoint

    @property
    def place(self) -> PlaceArray:
        """Place on the curve."""
        return PlaceArray(self.array['place'])

    @property
    def point(self) -> NDArray[np.float64]:
        """x, y, z."""
        return self.array['point']

    @property
    def distance(self) -> NDArray[np.float64]:
        """Distance; infinite if it overflows."""
        return self.array['distance']


class CurveMeasures(Record):
    """Measures of a curve. A chord closes open curves."""

    __slots__ = ()
    _NAME = 'gusset_curve_measures'

    @property
    def defined(self) -> frozenset[choices.CurveMeasureFlags]:
        """Present measures; all else is 0."""
        return flags(self._struct.defined, 'gusset_curve_measure_flags')

    @property
    def length(self) -> float:
        """Arc length without the chord."""
        return self._struct.length

    @property
    def low(self) -> NDArray[np.float64]:
        """Low corner of the bounding box."""
        return self._array('low')

    @property
    def high(self) -> NDArray[np.float64]:
        """High corner."""
        return self._array('high')

    @property
    def centre(self) -> NDArray[np.float64]:
        """Mean of the points by arc length."""
        return self._array('centre')

    @property
    def area_vector(self) -> NDArray[np.float64]:
        """Half the integral of r x dr; in the plane z = 0, (0, 0, signed area), negative if clockwise."""
        return self._array('area_vector')

    @property
    def area(self) -> float:
        """Length of area_vector: area of the largest shadow."""
        return self._struct.area

    @property
    def centroid(self) -> NDArray[np.float64]:
        """Centroid of the region, or the start if the area is 0."""
        return self._array('centroid')

    @property
    def second(self) -> NDArray[np.float64]:
        """Integrals of x x, x y and y y about it, with the area's sign."""
        return self._array('second')


class PlacesView(Record):
    """Lent places."""

    __slots__ = ()
    _NAME = 'gusset_places_view'
    _GETTER = 'gusset_places_get_view'

    @property
    def places(self) -> PlaceArray:
        """Places, ordered along the first curve."""
        return PlaceArray(self._array('places', self._struct.count))

    @property
    def points(self) -> NDArray[np.float64]:
        """Points at the places."""
        return self._array('points', self._struct.count, 3)

    @property
    def others(self) -> PlaceArray:
        """Intersections: places on the second curve, or later on the same. Else NULL."""
        return PlaceArray(self._array('others', self._struct.count))

    @property
    def overlaps(self) -> PlaceArray:
        """Common parts, four places each: start and end on the first curve, then on the second (tangent angles: the
        first).
        """
        return PlaceArray(self._array('overlaps', self._struct.overlap_count, 4))

    @property
    def inside(self) -> NDArray[np.uint32]:
        """Segments in the plane or line."""
        return self._array('inside')

    @property
    def undecided(self) -> bool:
        """1: segments that agree within rounding over long parts were not resolved."""
        return bool(self._struct.undecided)


class OffsetReport(Record):
    """Accuracy of an offset."""

    __slots__ = ()
    _NAME = 'gusset_offset_report'

    @property
    def deviation(self) -> float:
        """Largest distance from the true offset, at 16 places a segment."""
        return self._struct.deviation

    @property
    def corners(self) -> int:
        """Corners of the original, bridged straight."""
        return self._struct.corners

    @property
    def reached(self) -> bool:
        """1: the deviation is within the tolerance."""
        return bool(self._struct.reached)

    @property
    def tight(self) -> bool:
        """1: a radius of curvature is at most the distance: the offset has cusps or runs backwards."""
        return bool(self._struct.tight)


class CurveFormView(Record):
    """Lent parts of an exported curve; other formats' are empty."""

    __slots__ = ()
    _NAME = 'gusset_curve_form_view'
    _GETTER = 'gusset_curve_form_get_view'

    @property
    def text(self) -> str:
        """SVG path, zero-terminated."""
        return text(self._struct.text)

    @property
    def text_length(self) -> int:
        """Length without the final 0."""
        return self._struct.text_length

    @property
    def points(self) -> NDArray[np.float64]:
        """Points of a contour, controls of a spline."""
        return self._array('points', self._struct.point_count, 3)

    @property
    def on_curve(self) -> NDArray[np.bool_]:
        """Contour: 1 for a point on the curve."""
        return self._array('on_curve', self._struct.point_count) != 0

    @property
    def knots(self) -> NDArray[np.float64]:
        """Spline: point_count + degree + 1 knots."""
        return self._array('knots', self._struct.knot_count)

    @property
    def degree(self) -> int:
        """Spline: degree."""
        return self._struct.degree


class FrameView(Record):
    """Lent nodes, row by row, and curves."""

    __slots__ = ()
    _NAME = 'gusset_frame_view'
    _GETTER = 'gusset_frame_get_view'

    @property
    def rows(self) -> int:
        """Sections."""
        return self._struct.rows

    @property
    def columns(self) -> int:
        """Nodes in a section."""
        return self._struct.columns

    @property
    def nodes(self) -> NDArray[np.float64]:
        """Nodes."""
        return self._array('nodes', self._struct.rows, self._struct.columns, 3)

    @property
    def across(self) -> NDArray[np.float64]:
        """Unit tangents of the curves across; 0 if undefined."""
        return self._array('across', self._struct.rows, self._struct.columns, 3)

    @property
    def along(self) -> NDArray[np.float64]:
        """Unit tangents of the curves along."""
        return self._array('along', self._struct.rows, self._struct.columns, 3)

    @property
    def turned(self) -> NDArray[np.bool_]:
        """By section: 1 if it was reversed."""
        return self._array('turned', self._struct.rows) != 0

    @property
    def ambiguous(self) -> NDArray[np.uint32]:
        """Nodes whose half-plane meets the section several times."""
        return self._array('ambiguous')

    @property
    def corners(self) -> NDArray[np.uint32]:
        """Nodes that are corners of the curve across, ascending."""
        return self._array('corners')

    @property
    def max_twist(self) -> float:
        """Largest rotation of a closed section's nodes from the previous section; 0 for open ones."""
        return self._struct.max_twist

    @property
    def max_gap(self) -> float:
        """Largest distance between two curves at a node, relative to the nodes' box."""
        return self._struct.max_gap

    @property
    def min_sine(self) -> float:
        """Smallest sine of the angle between two curves at a node."""
        return self._struct.min_sine

    @property
    def filled(self) -> NDArray[np.uint32]:
        """Interpolated missing nodes, ascending."""
        return self._array('filled')


class QualityReport(Record):
    """Quality of new faces and the result."""

    __slots__ = ()
    _NAME = 'gusset_quality_report'
    _GETTER = 'gusset_result_get_quality'

    @property
    def min_angle(self) -> float:
        """Smallest angle of new triangles; 0 if one is degenerate."""
        return self._struct.min_angle

    @property
    def max_aspect(self) -> float:
        """Largest aspect ratio of new triangles, longest side / (2 sqrt(3) inradius): 1 if equilateral, infinite if
        degenerate.
        """
        return self._struct.max_aspect

    @property
    def max_edge(self) -> float:
        """Longest edge of new faces."""
        return self._struct.max_edge

    @property
    def area(self) -> float:
        """Area of new faces. Infinite if it overflows."""
        return self._struct.area

    @property
    def degenerate_faces(self) -> int:
        """New triangles of area 0."""
        return self._struct.degenerate_faces

    @property
    def loops_left(self) -> int:
        """Boundary loops of the result."""
        return self._struct.loops_left

    @property
    def non_manifold_edges(self) -> int:
        """Non-manifold edges of the result."""
        return self._struct.non_manifold_edges

    @property
    def orientation_conflicts(self) -> int:
        """Edges whose two faces disagree in orientation."""
        return self._struct.orientation_conflicts


class PieceMap(Record):
    """Indices of a piece's elements in the result, UINT32_MAX if removed."""

    __slots__ = ()
    _NAME = 'gusset_piece_map'

    @property
    def vertices(self) -> NDArray[np.uint32]:
        """Index of each vertex; several may share one."""
        return self._array('vertices')

    @property
    def faces(self) -> NDArray[np.uint32]:
        """Index of each face; a split triangle's first part, which the others follow."""
        return self._array('faces')


class Joint(Record):
    """Two loops, or runs of loops, that face each other. Indices are in the result. If borders coincide in part,
    sewing leaves a slit: a loop along the rest of both. In a slit joined with itself, both sides are on it, one with
    both ends; whole is 0, without rows.
    """

    __slots__ = ()
    _NAME = 'gusset_joint'

    @property
    def side(self) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """Vertices of each side in order, before turning components outwards. If joined, both run from the first
        meridian on.
        """
        return self._array('side', part=0), self._array('side', part=1)

    @property
    def gap(self) -> float:
        """Mean width of the gap."""
        return self._struct.gap

    @property
    def vertex_first(self) -> int:
        """First new vertex."""
        return self._struct.vertex_first

    @property
    def vertex_count(self) -> int:
        """Number of new vertices."""
        return self._struct.vertex_count

    @property
    def face_first(self) -> int:
        """First face of the strip."""
        return self._struct.face_first

    @property
    def face_count(self) -> int:
        """Number of faces."""
        return self._struct.face_count

    @property
    def intersections(self) -> NDArray[np.uint32]:
        """As in gusset_stitch_report."""
        return self._array('intersections', -1, 2)

    @property
    def intersections_known(self) -> bool:
        """1 if searched for."""
        return bool(self._struct.intersections_known)

    @property
    def outcome(self) -> choices.JointOutcome:
        """Outcome of a joint."""
        return word(self._struct.outcome, 'gusset_joint_outcome')

    @property
    def whole(self) -> bool:
        """1 if both sides are whole loops."""
        return bool(self._struct.whole)

    @property
    def finish(self) -> choices.Finish:
        """Surface between the rims, or in a hole."""
        return word(self._struct.finish, 'gusset_finish')


class LeftLoop(Record):
    """Boundary loop of the sewn pieces without a strip, even if filled."""

    __slots__ = ()
    _NAME = 'gusset_left_loop'

    @property
    def vertices(self) -> NDArray[np.uint32]:
        """Vertices in the result, in order."""
        return self._array('vertices')

    @property
    def gap(self) -> float:
        """Mean distance to the loop nearest to most vertices, on another component if any; infinite without one, or
        if this loop cannot carry a strip. Too wide slit: mean distance of sides.
        """
        return self._struct.gap

    @property
    def allowed_gap(self) -> float:
        """Largest gap that could be joined; 0 without another loop."""
        return self._struct.allowed_gap

    @property
    def reason(self) -> choices.LeftReason:
        """Reason for the lack of a strip."""
        return word(self._struct.reason, 'gusset_left_reason')

    @property
    def filled(self) -> bool:
        """1 if hole filling closed the loop."""
        return bool(self._struct.filled)


class JoinReport(Record):
    """Report of a join."""

    __slots__ = ()
    _NAME = 'gusset_join_report'
    _GETTER = 'gusset_result_get_join'

    @property
    def pieces(self) -> list[PieceMap]:
        """Indices of each piece in the result."""
        return self._list(PieceMap, 'pieces', self._struct.piece_count)

    @property
    def joints(self) -> list[Joint]:
        """Joints: given pairs in their order, then the others, nearest first."""
        return self._list(Joint, 'joints', self._struct.joint_count)

    @property
    def left(self) -> list[LeftLoop]:
        """Loops without a strip, by smallest vertex."""
        return self._list(LeftLoop, 'left', self._struct.left_count)

    @property
    def holes(self) -> HoleArray:
        """Holes considered for filling."""
        return HoleArray(self._array('holes', self._struct.hole_count))

    @property
    def hole_rims(self) -> NDArray[np.uint32]:
        """Rim vertices of holes, in order, before turning components outwards."""
        return self._array('hole_rims')

    @property
    def turned(self) -> NDArray[np.uint32]:
        """Old faces reversed against their pieces, by index in the result. New faces agree with the faces beside
        them.
        """
        return self._array('turned')

    @property
    def one_sided(self) -> NDArray[np.uint32]:
        """A face of each non-orientable component."""
        return self._array('one_sided')

    @property
    def zero_volume(self) -> NDArray[np.uint32]:
        """A face of each closed component of volume 0 up to rounding; none with GUSSET_ORIENTATION_KEEP or
        GUSSET_OUTWARD_KEEP.
        """
        return self._array('zero_volume')

    @property
    def welded_vertices(self) -> int:
        """Vertices merged into another."""
        return self._struct.welded_vertices

    @property
    def sewn_edges(self) -> int:
        """Edges made from two boundary edges."""
        return self._struct.sewn_edges

    @property
    def loops_left(self) -> int:
        """Boundary loops of the result."""
        return self._struct.loops_left

    @property
    def non_manifold_edges(self) -> int:
        """Non-manifold edges of the result."""
        return self._struct.non_manifold_edges

    @property
    def splits(self) -> int:
        """Points at which boundary edges were split."""
        return self._struct.splits

    @property
    def near_loops_left(self) -> int:
        """Loops left open by GUSSET_LEFT_LOOKS_AWAY, GUSSET_LEFT_TAKEN or GUSSET_LEFT_NOT_JOINED."""
        return self._struct.near_loops_left

    @property
    def trimmed_faces(self) -> int:
        """Faces removed from overlaps."""
        return self._struct.trimmed_faces

    @property
    def near_edge_pairs(self) -> int:
        """As in gusset_weld_report."""
        return self._struct.near_edge_pairs

    @property
    def near_tolerance(self) -> float:
        """As in gusset_weld_report."""
        return self._struct.near_tolerance

    @property
    def lost_faces(self) -> NDArray[np.uint32]:
        """Trimmed faces, as (piece, face), ascending, without a kept face within max_distance of the trimming that
        faces the same way.
        """
        return self._array('lost_faces', -1, 2)

    @property
    def left_origins(self) -> NDArray[np.uint32]:
        """Piece and vertex for each loop in left: the first that a piece has, else UINT32_MAX twice."""
        return self._array('left_origins', -1, 2)

    @property
    def hole_intersections(self) -> NDArray[np.uint32]:
        """As intersections of gusset_fill_report."""
        return self._array('hole_intersections', -1, 2)

    @property
    def joint_cut_lengths(self) -> NDArray[np.float64]:
        """Length along which each joint's strip intersects faces."""
        return self._array('joint_cut_lengths', self._struct.joint_count)

    @property
    def hole_cut_lengths(self) -> NDArray[np.float64]:
        """Length along which each hole's patch intersects faces."""
        return self._array('hole_cut_lengths', self._struct.hole_count)

    @property
    def blend_avoids_cuts(self) -> NDArray[np.uint32]:
        """For each joint, 1 if its strip intersects faces and a blend would not, else 0. Tried with
        GUSSET_INTERSECTIONS_AUTO on untrimmed pieces.
        """
        return self._array('blend_avoids_cuts', self._struct.joint_count)

    @property
    def hole_intersections_known(self) -> bool:
        """1 if intersections of patches were searched for."""
        return bool(self._struct.hole_intersections_known)

    @property
    def cutting_joints(self) -> int:
        """Joints whose strips intersect faces."""
        return self._struct.cutting_joints


class StitchReport(Record):
    """Parts of a stitch, by index in the result. Entry 0 is the first mesh's, 1 the second's."""

    __slots__ = ()
    _NAME = 'gusset_stitch_report'
    _GETTER = 'gusset_result_get_stitch'

    @property
    def vertex_map(self) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """Index of each old vertex. Entry 1 is empty without a second mesh."""
        return self._array('vertex_map', part=0), self._array('vertex_map', part=1)

    @property
    def face_map(self) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """Index of each old face."""
        return self._array('face_map', part=0), self._array('face_map', part=1)

    @property
    def rim(self) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """Vertices of each rim from the first meridian on. Before turning components outwards, the surface is left of
        rim 0 and right of rim 1.
        """
        return self._array('rim', part=0), self._array('rim', part=1)

    @property
    def meridians(self) -> NDArray[np.uint32]:
        """Pairs (i, j) of rim indices, the matrix H. Whole rims of N and M vertices: from (0, 0) to (N, M), where
        index N is 0 again. Arcs: to (N - 1, M - 1). A step advances i or j by 1; with GUSSET_MERIDIANS_INDEX and
        GUSSET_MERIDIANS_QUAD, and between common points, also both.
        """
        return self._array('meridians', -1, 2)

    @property
    def matrix(self) -> NDArray[np.uint32]:
        """The matrix P: vertices row by row from rim 0 to rim 1, a column for each meridian."""
        return self._array('matrix', self._struct.row_count + 2, -1)

    @property
    def parents(self) -> NDArray[np.uint32]:
        """Three rim vertices for each new vertex. In a row: the meridian's ends, rim 1's twice. In a blend: the
        corners of the strip triangle around the unfaired vertex.
        """
        return self._array('parents', -1, 3)

    @property
    def weights(self) -> NDArray[np.float64]:
        """Weights of the parents, at least 0, sum 1. In row k of r: 1 - k / (r + 1), k / (r + 1), 0."""
        return self._array('weights', len(self.parents), 3)

    @property
    def strip_face_first(self) -> int:
        """First face of the strip."""
        return self._struct.strip_face_first

    @property
    def strip_face_count(self) -> int:
        """N + M triangles for whole rims without rows and common points, except in a blend."""
        return self._struct.strip_face_count

    @property
    def row_count(self) -> int:
        """Interior rows, two less than in the matrix; 0 for a blend."""
        return self._struct.row_count

    @property
    def closed(self) -> bool:
        """1 for a closed band, 0 between arcs."""
        return bool(self._struct.closed)

    @property
    def turned(self) -> bool:
        """1 if rim 1's component was reversed."""
        return bool(self._struct.turned)

    @property
    def intersections_known(self) -> bool:
        """1 if searched for."""
        return bool(self._struct.intersections_known)

    @property
    def intersections(self) -> NDArray[np.uint32]:
        """Pairs of intersecting faces: first a strip face, the larger one if both are. Any contact counts, by an
        exact test, except at shared or coincident vertices and edges. Faces are split as by gusset_triangulate. A
        self-intersecting polygon is paired with itself.
        """
        return self._array('intersections', -1, 2)

    @property
    def back_off_count(self) -> int:
        """Times that faired rows, or the kept blend, moved back."""
        return self._struct.back_off_count

    @property
    def finish(self) -> choices.Finish:
        """Surface between the rims, or in a hole."""
        return word(self._struct.finish, 'gusset_finish')

    @property
    def turned_outwards(self) -> NDArray[np.uint32]:
        """Faces that GUSSET_OUTWARD_CLOSED reversed, ascending."""
        return self._array('turned_outwards')


class Hole(Record):
    """Report on one loop."""

    __slots__ = ()
    _NAME = 'gusset_hole'

    @property
    def rim_first(self) -> int:
        """First vertex of the loop in rims, surface on the left before turning components outwards; as given if not
        simple, free or oriented.
        """
        return self._struct.rim_first

    @property
    def rim_count(self) -> int:
        """Number of its vertices."""
        return self._struct.rim_count

    @property
    def face_first(self) -> int:
        """First face of the patch in the result, equal for loops that share it."""
        return self._struct.face_first

    @property
    def face_count(self) -> int:
        """Number of its faces."""
        return self._struct.face_count

    @property
    def vertex_first(self) -> int:
        """First new vertex of the patch."""
        return self._struct.vertex_first

    @property
    def vertex_count(self) -> int:
        """Number of these."""
        return self._struct.vertex_count

    @property
    def length(self) -> float:
        """Length of the loop."""
        return self._struct.length

    @property
    def diameter(self) -> float:
        """Diagonal of the loop's axis-aligned box."""
        return self._struct.diameter

    @property
    def area(self) -> float:
        """Area of triangles from the loop's edges to the mean of its vertices: exact for a planar convex hole, else
        more. Infinite if it overflows.
        """
        return self._struct.area

    @property
    def status(self) -> choices.HoleStatus:
        """Outcome for one loop."""
        return word(self._struct.status, 'gusset_hole_status')

    @property
    def weight(self) -> choices.FillWeight:
        """Weight that the triangulation of a hole minimises."""
        return word(self._struct.weight, 'gusset_fill_weight')

    @property
    def finish(self) -> choices.PatchFinish:
        """Vertices of a patch."""
        return word(self._struct.finish, 'gusset_patch_finish')

    @property
    def patch(self) -> int:
        """Patch number, in the order of faces, equal for loops that share it; UINT32_MAX without a patch, always with
        plan_only.
        """
        return self._struct.patch


class HoleArray(RecordArray[Hole]):
    """Report on one loop."""

    __slots__ = ()
    RECORD = Hole

    @property
    def rim_first(self) -> NDArray[np.uintp]:
        """First vertex of the loop in rims, surface on the left before turning components outwards; as given if not
        simple, free or oriented.
        """
        return self.array['rim_first']

    @property
    def rim_count(self) -> NDArray[np.uintp]:
        """Number of its vertices."""
        return self.array['rim_count']

    @property
    def face_first(self) -> NDArray[np.uintp]:
        """First face of the patch in the result, equal for loops that share it."""
        return self.array['face_first']

    @property
    def face_count(self) -> NDArray[np.uintp]:
        """Number of its faces."""
        return self.array['face_count']

    @property
    def vertex_first(self) -> NDArray[np.uintp]:
        """First new vertex of the patch."""
        return self.array['vertex_first']

    @property
    def vertex_count(self) -> NDArray[np.uintp]:
        """Number of these."""
        return self.array['vertex_count']

    @property
    def length(self) -> NDArray[np.float64]:
        """Length of the loop."""
        return self.array['length']

    @property
    def diameter(self) -> NDArray[np.float64]:
        """Diagonal of the loop's axis-aligned box."""
        return self.array['diameter']

    @property
    def area(self) -> NDArray[np.float64]:
        """Area of triangles from the loop's edges to the mean of its vertices: exact for a planar convex hole, else
        more. Infinite if it overflows.
        """
        return self.array['area']

    @property
    def status(self) -> NDArray[np.str_]:
        """Outcome for one loop."""
        return words(self.array['status'], 'gusset_hole_status')

    @property
    def weight(self) -> NDArray[np.str_]:
        """Weight that the triangulation of a hole minimises."""
        return words(self.array['weight'], 'gusset_fill_weight')

    @property
    def finish(self) -> NDArray[np.str_]:
        """Vertices of a patch."""
        return words(self.array['finish'], 'gusset_patch_finish')

    @property
    def patch(self) -> NDArray[np.uint32]:
        """Patch number, in the order of faces, equal for loops that share it; UINT32_MAX without a patch, always with
        plan_only.
        """
        return self.array['patch']


class FillReport(Record):
    """Reports on all loops."""

    __slots__ = ()
    _NAME = 'gusset_fill_report'
    _GETTER = 'gusset_result_get_fill'

    @property
    def holes(self) -> HoleArray:
        """Given loops, or all in the order of gusset_boundary_get_loop."""
        return HoleArray(self._array('holes', self._struct.hole_count))

    @property
    def rims(self) -> NDArray[np.uint32]:
        """Vertices of all loops."""
        return self._array('rims')

    @property
    def parents(self) -> NDArray[np.uint32]:
        """Three rim vertices for each new vertex."""
        return self._array('parents', -1, 3)

    @property
    def weights(self) -> NDArray[np.float64]:
        """Weights of the parents, at least 0, sum 1. They give the nearest point on the rims' plain triangulation:
        the vertex itself in a flat patch, or without fairing and creases.
        """
        return self._array('weights', len(self.parents), 3)

    @property
    def intersections(self) -> NDArray[np.uint32]:
        """As in gusset_stitch_report, ascending: first the larger index, a new face."""
        return self._array('intersections', -1, 2)

    @property
    def turned_outwards(self) -> NDArray[np.uint32]:
        """Faces that GUSSET_OUTWARD_CLOSED reversed, ascending."""
        return self._array('turned_outwards')

    @property
    def intersections_known(self) -> bool:
        """1 if searched for."""
        return bool(self._struct.intersections_known)

    @property
    def coincident_edges(self) -> int:
        """Boundary edges of the input that coincide with another; 0, without a search, for given loops."""
        return self._struct.coincident_edges


class StripReport(Record):
    """Parts of a strip."""

    __slots__ = ()
    _NAME = 'gusset_strip_report'
    _GETTER = 'gusset_result_get_strip'

    @property
    def start(self) -> NDArray[np.uint32]:
        """Points of A and B that the first meridian joins."""
        return self._array('start')

    @property
    def meridians(self) -> NDArray[np.uint32]:
        """As in gusset_stitch_report, from start on: to (N, M) if closed, else to (N - 1, M - 1)."""
        return self._array('meridians', -1, 2)

    @property
    def matrix(self) -> NDArray[np.uint32]:
        """The matrix P, as in gusset_stitch_report."""
        return self._array('matrix', self._struct.row_count + 2, -1)

    @property
    def parents(self) -> NDArray[np.uint32]:
        """Ends on A and B of each new vertex's meridian."""
        return self._array('parents', -1, 2)

    @property
    def weights(self) -> NDArray[np.float64]:
        """Weight of each second parent, 0 to 1: k / (r + 1) in row k of r."""
        return self._array('weights', len(self.parents))

    @property
    def row_count(self) -> int:
        """As in gusset_stitch_report; 0 without a face."""
        return self._struct.row_count


class WeldReport(Record):
    """Effects of welding. Indices are of the old mesh, and lists ascending."""

    __slots__ = ()
    _NAME = 'gusset_weld_report'
    _GETTER = 'gusset_result_get_weld'

    @property
    def vertex_map(self) -> NDArray[np.uint32]:
        """Index of each vertex in the result; UINT32_MAX if removed."""
        return self._array('vertex_map')

    @property
    def face_map(self) -> NDArray[np.uint32]:
        """Index of each face in the result; UINT32_MAX if dropped."""
        return self._array('face_map')

    @property
    def left_edges(self) -> NDArray[np.uint32]:
        """Half-edges of boundary edges that coincide with another edge but stay apart."""
        return self._array('left_edges')

    @property
    def left_vertices(self) -> NDArray[np.uint32]:
        """Vertices that coincide with another but are not merged."""
        return self._array('left_vertices')

    @property
    def welded_vertices(self) -> int:
        """Vertices merged into a smaller one."""
        return self._struct.welded_vertices

    @property
    def sewn_edges(self) -> int:
        """Edges made from two boundary edges."""
        return self._struct.sewn_edges

    @property
    def dropped_faces(self) -> int:
        """Dropped faces."""
        return self._struct.dropped_faces

    @property
    def near_edge_pairs(self) -> int:
        """Pairs of boundary edges that coincide only within near_tolerance, not sewn."""
        return self._struct.near_edge_pairs

    @property
    def tolerance(self) -> float:
        """Largest distance at which vertices coincide, except at short edges; 0 for equal positions."""
        return self._struct.tolerance

    @property
    def near_tolerance(self) -> float:
        """Tolerance that sews near_edge_pairs, at most a tenth of the edges there; 0 without any."""
        return self._struct.near_tolerance


class SewReport(Record):
    """Effects of sewing. Lists are ascending."""

    __slots__ = ()
    _NAME = 'gusset_sew_report'
    _GETTER = 'gusset_result_get_sew'

    @property
    def vertex_map(self) -> NDArray[np.uint32]:
        """As in gusset_weld_report."""
        return self._array('vertex_map')

    @property
    def face_map(self) -> NDArray[np.uint32]:
        """Index of each old face's first part; UINT32_MAX if dropped."""
        return self._array('face_map')

    @property
    def face_origin(self) -> NDArray[np.uint32]:
        """Old face of each face of the result."""
        return self._array('face_origin')

    @property
    def left_vertices(self) -> NDArray[np.uint32]:
        """Old vertices that coincide with another, or lie inside a boundary edge, but are not sewn."""
        return self._array('left_vertices')

    @property
    def welded_vertices(self) -> int:
        """Vertices merged into a smaller one."""
        return self._struct.welded_vertices

    @property
    def sewn_edges(self) -> int:
        """Edges made from boundary edges or their parts."""
        return self._struct.sewn_edges

    @property
    def splits(self) -> int:
        """Points at which boundary edges were split."""
        return self._struct.splits

    @property
    def split_faces(self) -> int:
        """Old faces that were cut or gained corners."""
        return self._struct.split_faces

    @property
    def dropped_faces(self) -> int:
        """Dropped old faces."""
        return self._struct.dropped_faces

    @property
    def near_edge_pairs(self) -> int:
        """As in gusset_weld_report."""
        return self._struct.near_edge_pairs

    @property
    def tolerance(self) -> float:
        """As in gusset_weld_report."""
        return self._struct.tolerance

    @property
    def near_tolerance(self) -> float:
        """As in gusset_weld_report."""
        return self._struct.near_tolerance


class OrientReport(Record):
    """Faces turned over, and components that cannot be oriented."""

    __slots__ = ()
    _NAME = 'gusset_orient_report'
    _GETTER = 'gusset_result_get_orient'

    @property
    def turned(self) -> NDArray[np.bool_]:
        """For each face, 1 if it was turned over."""
        return self._array('turned', self._struct.face_count) != 0

    @property
    def one_sided_faces(self) -> NDArray[np.uint32]:
        """Smallest face of each non-orientable component, ascending."""
        return self._array('one_sided_faces')

    @property
    def one_sided_half_edges(self) -> NDArray[np.uint32]:
        """For each of them, a half-edge where faces cannot agree."""
        return self._array('one_sided_half_edges')

    @property
    def turned_faces(self) -> int:
        """Faces turned over."""
        return self._struct.turned_faces

    @property
    def component_count(self) -> int:
        """Components: faces connected by edges with two faces. A degenerate face is one."""
        return self._struct.component_count

    @property
    def inverted_components(self) -> int:
        """Closed components that face outwards only by GUSSET_OUTWARD_CLOSED."""
        return self._struct.inverted_components


class RepairReport(Record):
    """Changes, and defects that the result still has (_left)."""

    __slots__ = ()
    _NAME = 'gusset_repair_report'
    _GETTER = 'gusset_result_get_repair'

    @property
    def valid(self) -> bool:
        """1 if the result bounds a solid: closed, manifold, oriented, without degenerate, duplicate, intersecting or
        zero-area faces.
        """
        return bool(self._struct.valid)

    @property
    def welded_vertices(self) -> int:
        """Vertices merged into others."""
        return self._struct.welded_vertices

    @property
    def sewn_edges(self) -> int:
        """Edges made from boundary edges or their parts."""
        return self._struct.sewn_edges

    @property
    def split_faces(self) -> int:
        """Old faces that sewing split or gave corners."""
        return self._struct.split_faces

    @property
    def split_vertices(self) -> int:
        """Copies of vertices that separate sheets."""
        return self._struct.split_vertices

    @property
    def filled_holes(self) -> int:
        """Holes that were filled."""
        return self._struct.filled_holes

    @property
    def boundary_edges_left(self) -> int:
        """Boundary edges."""
        return self._struct.boundary_edges_left

    @property
    def non_manifold_edges_left(self) -> int:
        """Non-manifold edges."""
        return self._struct.non_manifold_edges_left

    @property
    def non_manifold_vertices_left(self) -> int:
        """Non-manifold vertices."""
        return self._struct.non_manifold_vertices_left

    @property
    def orientation_conflicts_left(self) -> int:
        """Edges whose two faces disagree in orientation."""
        return self._struct.orientation_conflicts_left

    @property
    def bad_faces_left(self) -> int:
        """Degenerate, duplicate and zero-area faces."""
        return self._struct.bad_faces_left

    @property
    def tolerance(self) -> float:
        """Largest move of a remaining vertex onto another; 0 without any."""
        return self._struct.tolerance

    @property
    def face_origin(self) -> NDArray[np.uint32]:
        """Old face that each face is or is part of; UINT32_MAX for patches, which come last."""
        return self._array('face_origin')

    @property
    def vertex_origin(self) -> NDArray[np.uint32]:
        """Smallest old vertex that each vertex is; UINT32_MAX for new ones, which come last."""
        return self._array('vertex_origin')

    @property
    def turned(self) -> NDArray[np.bool_]:
        """For each face, 1 if it was turned over."""
        return self._array('turned', self._struct.face_count) != 0

    @property
    def dropped_faces(self) -> NDArray[np.uint32]:
        """Old faces without a remaining part, ascending."""
        return self._array('dropped_faces')

    @property
    def drop_reasons(self) -> NDArray[np.str_]:
        """Reason why a face was dropped."""
        return words(self._array('drop_reasons', self._struct.dropped_count), 'gusset_drop_reason')

    @property
    def intersecting_pairs(self) -> NDArray[np.uint32]:
        """Intersecting pairs in the result, ascending, smaller face first."""
        return self._array('intersecting_pairs', -1, 2)


class AlignedPiece(Record):
    """Pose of one piece."""

    __slots__ = ()
    _NAME = 'gusset_aligned_piece'

    @property
    def pose(self) -> Transform:
        """Rigid motion from the given positions."""
        return Transform(self._struct.pose, self._owner)

    @property
    def hold(self) -> float:
        """How firmly overlaps hold the piece, 0 to 1; 1 for the first. RMS change of matched distances under the unit
        motion that changes them least, turns in radii of the piece.
        """
        return self._struct.hold

    @property
    def reason(self) -> choices.AlignedReason:
        """Verdict on the pose of a piece."""
        return word(self._struct.reason, 'gusset_aligned_reason')


class AlignedPieceArray(RecordArray[AlignedPiece]):
    """Pose of one piece."""

    __slots__ = ()
    RECORD = AlignedPiece

    @property
    def pose(self) -> TransformArray:
        """Rigid motion from the given positions."""
        return TransformArray(self.array['pose'])

    @property
    def hold(self) -> NDArray[np.float64]:
        """How firmly overlaps hold the piece, 0 to 1; 1 for the first. RMS change of matched distances under the unit
        motion that changes them least, turns in radii of the piece.
        """
        return self.array['hold']

    @property
    def reason(self) -> NDArray[np.str_]:
        """Verdict on the pose of a piece."""
        return words(self.array['reason'], 'gusset_aligned_reason')


class Overlap(Record):
    """Overlap of two pieces in their final poses."""

    __slots__ = ()
    _NAME = 'gusset_overlap'

    @property
    def pieces(self) -> NDArray[np.uint32]:
        """The pieces, ascending."""
        return self._array('pieces')

    @property
    def shares(self) -> NDArray[np.float64]:
        """Fraction of each piece's points on the other, within a mean edge; 0 to 1."""
        return self._array('shares')

    @property
    def mean(self) -> float:
        """Mean distance of these points from the other surface."""
        return self._struct.mean

    @property
    def rms(self) -> float:
        """RMS distance of these points."""
        return self._struct.rms

    @property
    def fit(self) -> float:
        """Fraction on the other piece of points within 8 mean edges of it, 0 to 1."""
        return self._struct.fit

    @property
    def count(self) -> int:
        """Number of overlapping points."""
        return self._struct.count

    @property
    def trusted(self) -> bool:
        """1 if count is at least 30 and fit at least 2/3."""
        return bool(self._struct.trusted)


class OverlapArray(RecordArray[Overlap]):
    """Overlap of two pieces in their final poses."""

    __slots__ = ()
    RECORD = Overlap

    @property
    def pieces(self) -> NDArray[np.uint32]:
        """The pieces, ascending."""
        return self.array['pieces']

    @property
    def shares(self) -> NDArray[np.float64]:
        """Fraction of each piece's points on the other, within a mean edge; 0 to 1."""
        return self.array['shares']

    @property
    def mean(self) -> NDArray[np.float64]:
        """Mean distance of these points from the other surface."""
        return self.array['mean']

    @property
    def rms(self) -> NDArray[np.float64]:
        """RMS distance of these points."""
        return self.array['rms']

    @property
    def fit(self) -> NDArray[np.float64]:
        """Fraction on the other piece of points within 8 mean edges of it, 0 to 1."""
        return self.array['fit']

    @property
    def count(self) -> NDArray[np.uint32]:
        """Number of overlapping points."""
        return self.array['count']

    @property
    def trusted(self) -> NDArray[np.bool_]:
        """1 if count is at least 30 and fit at least 2/3."""
        return self.array['trusted'] != 0


class AlignmentView(Record):
    """Poses and overlaps."""

    __slots__ = ()
    _NAME = 'gusset_alignment_view'
    _GETTER = 'gusset_alignment_get_view'

    @property
    def pieces(self) -> AlignedPieceArray:
        """Pieces in order."""
        return AlignedPieceArray(self._array('pieces', self._struct.piece_count))

    @property
    def overlaps(self) -> OverlapArray:
        """Pairs of overlapping pieces."""
        return OverlapArray(self._array('overlaps', self._struct.overlap_count))

    @property
    def rounds(self) -> int:
        """Rounds done."""
        return self._struct.rounds

    @property
    def converged(self) -> bool:
        """1 if pieces stopped before the rounds ran out."""
        return bool(self._struct.converged)


class TrimmedPiece(Record):
    """Kept faces of a piece."""

    __slots__ = ()
    _NAME = 'gusset_trimmed_piece'

    @property
    def kept(self) -> NDArray[np.uint32]:
        """Indices of the faces, ascending."""
        return self._array('kept')

    @property
    def covered_vertices(self) -> int:
        """Vertices that lie on another piece."""
        return self._struct.covered_vertices


class TrimView(Record):
    """Result of trimming."""

    __slots__ = ()
    _NAME = 'gusset_trim_view'
    _GETTER = 'gusset_trim_get_view'

    @property
    def pieces(self) -> list[TrimmedPiece]:
        """Kept faces of each piece."""
        return self._list(TrimmedPiece, 'pieces', self._struct.piece_count)

    @property
    def crossings(self) -> int:
        """Faces removed, with neighbours, for intersecting an earlier piece."""
        return self._struct.crossings


class LoopView(Record):
    """Boundary loop or open chain. Edge i runs from vertices[i] to vertices[i + 1], cyclically in a loop."""

    __slots__ = ()
    _NAME = 'gusset_loop_view'
    _GETTER = 'gusset_boundary_get_loop'

    @property
    def vertices(self) -> NDArray[np.uint32]:
        """Vertices, each once. Closed loops start at their smallest half-edge."""
        return self._array('vertices')

    @property
    def half_edges(self) -> NDArray[np.uint32]:
        """Half-edge of each edge."""
        return self._array('half_edges')

    @property
    def faces(self) -> NDArray[np.uint32]:
        """Face beside each edge."""
        return self._array('faces')

    @property
    def edge_flags(self) -> FlagArray[choices.EdgeFlags]:
        """Properties of each edge."""
        return FlagArray(self._array('edge_flags', len(self.half_edges)), 'gusset_edge_flags')

    @property
    def length(self) -> float:
        """Sum of the edge lengths."""
        return self._struct.length

    @property
    def flags(self) -> frozenset[choices.LoopFlags]:
        """Properties of a loop."""
        return flags(self._struct.flags, 'gusset_loop_flags')

    @property
    def walk(self) -> int:
        """Walk that the loop was cut from."""
        return self._struct.walk


class Defect(Record):
    """Defect of a mesh."""

    __slots__ = ()
    _NAME = 'gusset_defect'

    @property
    def kind(self) -> choices.DefectKind:
        """Kind of a defect."""
        return word(self._struct.kind, 'gusset_defect_kind')

    @property
    def index(self) -> int:
        """Face, half-edge or vertex."""
        return self._struct.index

    @property
    def other(self) -> int:
        """Second element, or UINT32_MAX."""
        return self._struct.other

    @property
    def count(self) -> int:
        """Half-edges of a non-manifold edge; else 0."""
        return self._struct.count


class DefectArray(RecordArray[Defect]):
    """Defect of a mesh."""

    __slots__ = ()
    RECORD = Defect

    @property
    def kind(self) -> NDArray[np.str_]:
        """Kind of a defect."""
        return words(self.array['kind'], 'gusset_defect_kind')

    @property
    def index(self) -> NDArray[np.uint32]:
        """Face, half-edge or vertex."""
        return self.array['index']

    @property
    def other(self) -> NDArray[np.uint32]:
        """Second element, or UINT32_MAX."""
        return self.array['other']

    @property
    def count(self) -> NDArray[np.uint32]:
        """Half-edges of a non-manifold edge; else 0."""
        return self.array['count']


class BoundaryView(Record):
    """Loop count and defects of a boundary."""

    __slots__ = ()
    _NAME = 'gusset_boundary_view'
    _GETTER = 'gusset_boundary_get_view'

    @property
    def loop_count(self) -> int:
        """Loops and open chains; 0 if the mesh is closed."""
        return self._struct.loop_count

    @property
    def walk_count(self) -> int:
        """Walks that loops were cut from. Touching loops share a walk that passes from one to the other."""
        return self._struct.walk_count

    @property
    def defects(self) -> DefectArray:
        """Degenerate faces, orientation conflicts, non-manifold edges, and bow-ties on the boundary."""
        return DefectArray(self._array('defects', self._struct.defect_count))


class CheckView(Record):
    """Counts, properties and defects of a mesh. Lists are ascending. Degenerate faces lack edges."""

    __slots__ = ()
    _NAME = 'gusset_check_view'
    _GETTER = 'gusset_check_get_view'

    @property
    def vertex_count(self) -> int:
        """Vertices, also unused ones."""
        return self._struct.vertex_count

    @property
    def edge_count(self) -> int:
        """Distinct edges, between different vertices."""
        return self._struct.edge_count

    @property
    def face_count(self) -> int:
        """Faces."""
        return self._struct.face_count

    @property
    def component_count(self) -> int:
        """Components: faces connected by shared edges."""
        return self._struct.component_count

    @property
    def boundary_walk_count(self) -> int:
        """Number of boundary walks."""
        return self._struct.boundary_walk_count

    @property
    def properties(self) -> frozenset[choices.MeshFlags]:
        """Properties of a mesh."""
        return flags(self._struct.properties, 'gusset_mesh_flags')

    @property
    def euler(self) -> int:
        """Used vertices - edges + faces: the Euler characteristic without degenerate faces."""
        return self._struct.euler

    @property
    def genus(self) -> int:
        """Handles of all components together; -1 if not manifold or orientable, or with a degenerate face."""
        return self._struct.genus

    @property
    def boundary_edges(self) -> NDArray[np.uint32]:
        """Half-edges of boundary edges."""
        return self._array('boundary_edges')

    @property
    def non_manifold_edges(self) -> NDArray[np.uint32]:
        """First half-edge of each non-manifold edge."""
        return self._array('non_manifold_edges')

    @property
    def non_manifold_vertices(self) -> NDArray[np.uint32]:
        """Ends of non-manifold edges, and bow-ties."""
        return self._array('non_manifold_vertices')

    @property
    def bow_ties(self) -> NDArray[np.uint32]:
        """Vertices whose faces form several fans; usually also ends of non-manifold edges."""
        return self._array('bow_ties')

    @property
    def orientation_conflicts(self) -> NDArray[np.uint32]:
        """First half-edge of each edge whose two faces run it in one direction."""
        return self._array('orientation_conflicts')

    @property
    def duplicate_faces(self) -> NDArray[np.uint32]:
        """Faces with the cycle of vertices of an earlier face, in either direction; none degenerate."""
        return self._array('duplicate_faces')

    @property
    def degenerate_faces(self) -> NDArray[np.uint32]:
        """Faces that repeat a vertex."""
        return self._array('degenerate_faces')

    @property
    def zero_area_faces(self) -> NDArray[np.uint32]:
        """Other faces whose vector area is 0 up to rounding."""
        return self._array('zero_area_faces')

    @property
    def unused_vertices(self) -> NDArray[np.uint32]:
        """Vertices that no face uses."""
        return self._array('unused_vertices')


class CertificateView(Record):
    """Facts about a result. Faces match by the positions of their corners, from any corner; -0 equals 0. Each result
    face matches at most one face of the pieces. Edges connect different vertices; a face with fewer than three has
    none. Shared edges connect components.
    """

    __slots__ = ()
    _NAME = 'gusset_certificate_view'
    _GETTER = 'gusset_certificate_get_view'

    @property
    def vertex_count(self) -> int:
        """Vertices that faces use."""
        return self._struct.vertex_count

    @property
    def edge_count(self) -> int:
        """Number of edges."""
        return self._struct.edge_count

    @property
    def face_count(self) -> int:
        """Faces."""
        return self._struct.face_count

    @property
    def component_count(self) -> int:
        """Number of components."""
        return self._struct.component_count

    @property
    def closed(self) -> bool:
        """1 if there are edges, and each has exactly two faces."""
        return bool(self._struct.closed)

    @property
    def outward(self) -> bool:
        """1 if closed and oriented without intersecting pairs, and facing outwards. A component that an odd number of
        others encloses has a negative volume, any other a positive one.
        """
        return bool(self._struct.outward)

    @property
    def boundary_edges(self) -> int:
        """Edges with one face."""
        return self._struct.boundary_edges

    @property
    def non_manifold_edges(self) -> int:
        """Edges with three or more faces."""
        return self._struct.non_manifold_edges

    @property
    def non_manifold_vertices(self) -> int:
        """Ends of non-manifold edges, and vertices with several fans."""
        return self._struct.non_manifold_vertices

    @property
    def orientation_conflicts(self) -> int:
        """Edges whose two faces run them in one direction."""
        return self._struct.orientation_conflicts

    @property
    def degenerate_faces(self) -> int:
        """Faces that repeat a vertex."""
        return self._struct.degenerate_faces

    @property
    def duplicate_faces(self) -> int:
        """As in gusset_check_view."""
        return self._struct.duplicate_faces

    @property
    def collinear_triangles(self) -> int:
        """Triangles, also of polygons, with three different vertices on one line."""
        return self._struct.collinear_triangles

    @property
    def new_faces(self) -> int:
        """Faces that match no face of the pieces."""
        return self._struct.new_faces

    @property
    def intersecting_pairs(self) -> int:
        """Pairs of faces with common points beyond common vertices and edges."""
        return self._struct.intersecting_pairs

    @property
    def kept_faces(self) -> int:
        """Faces of the pieces that the result has."""
        return self._struct.kept_faces

    @property
    def turned_faces(self) -> NDArray[np.uint32]:
        """Faces that the result has only reversed, as (piece, face), ascending."""
        return self._array('turned_faces', -1, 2)

    @property
    def lost_faces(self) -> NDArray[np.uint32]:
        """Faces that the result lacks, as (piece, face), ascending."""
        return self._array('lost_faces', -1, 2)

    @property
    def farthest_distance(self) -> float:
        """Largest distance of a used vertex of the pieces from the result's nearest used vertex; 0 if all remain."""
        return self._struct.farthest_distance

    @property
    def farthest_piece(self) -> int:
        """Piece of the farthest vertex; UINT32_MAX without one."""
        return self._struct.farthest_piece

    @property
    def farthest_vertex(self) -> int:
        """The farthest vertex; UINT32_MAX without one."""
        return self._struct.farthest_vertex

    @property
    def nearest_vertex(self) -> int:
        """Vertex of the result nearest to it; UINT32_MAX without one."""
        return self._struct.nearest_vertex

    @property
    def polygon_triangles(self) -> NDArray[np.uint32]:
        """Triangles of faces with more than three corners, as half-edges, face by face."""
        return self._array('polygon_triangles', -1, 3)


class Chart(Record):
    """Connected component of a development."""

    __slots__ = ()
    _NAME = 'gusset_chart'

    @property
    def first_vertex(self) -> int:
        """First vertex in the result; the chart's vertices are consecutive."""
        return self._struct.first_vertex

    @property
    def vertex_count(self) -> int:
        """Number of vertices."""
        return self._struct.vertex_count

    @property
    def face_count(self) -> int:
        """Number of faces."""
        return self._struct.face_count

    @property
    def finish(self) -> choices.ChartFinish:
        """Outcome of the layout of a chart."""
        return word(self._struct.finish, 'gusset_chart_finish')

    @property
    def iterations(self) -> int:
        """Steps of all descents."""
        return self._struct.iterations

    @property
    def overlaps(self) -> int:
        """Pairs of border edges that meet in the plane, except neighbours. GUSSET_CHART_EXACT: crossings by over 1e-8
        of the area's root. GUSSET_CHART_FOLDED: all. Else 0.
        """
        return self._struct.overlaps

    @property
    def folds(self) -> int:
        """Triangles turned over, by GUSSET_CHART_FOLDED only."""
        return self._struct.folds

    @property
    def energy(self) -> float:
        """Symmetric Dirichlet energy: the area's mean of the sum of s^2 + 1 / s^2 over both singular values s of the
        map; 4 for an isometry, else more; infinite if a triangle is turned over or flat, up to rounding.
        """
        return self._struct.energy

    @property
    def max_stretch(self) -> float:
        """Largest factor by which a length grows."""
        return self._struct.max_stretch

    @property
    def min_stretch(self) -> float:
        """Smallest factor by which a length grows."""
        return self._struct.min_stretch

    @property
    def area(self) -> float:
        """Area of the surface."""
        return self._struct.area

    @property
    def flat_area(self) -> float:
        """Area in the plane."""
        return self._struct.flat_area


class ChartArray(RecordArray[Chart]):
    """Connected component of a development."""

    __slots__ = ()
    RECORD = Chart

    @property
    def first_vertex(self) -> NDArray[np.uint32]:
        """First vertex in the result; the chart's vertices are consecutive."""
        return self.array['first_vertex']

    @property
    def vertex_count(self) -> NDArray[np.uint32]:
        """Number of vertices."""
        return self.array['vertex_count']

    @property
    def face_count(self) -> NDArray[np.uint32]:
        """Number of faces."""
        return self.array['face_count']

    @property
    def finish(self) -> NDArray[np.str_]:
        """Outcome of the layout of a chart."""
        return words(self.array['finish'], 'gusset_chart_finish')

    @property
    def iterations(self) -> NDArray[np.uint32]:
        """Steps of all descents."""
        return self.array['iterations']

    @property
    def overlaps(self) -> NDArray[np.uint32]:
        """Pairs of border edges that meet in the plane, except neighbours. GUSSET_CHART_EXACT: crossings by over 1e-8
        of the area's root. GUSSET_CHART_FOLDED: all. Else 0.
        """
        return self.array['overlaps']

    @property
    def folds(self) -> NDArray[np.uint32]:
        """Triangles turned over, by GUSSET_CHART_FOLDED only."""
        return self.array['folds']

    @property
    def energy(self) -> NDArray[np.float64]:
        """Symmetric Dirichlet energy: the area's mean of the sum of s^2 + 1 / s^2 over both singular values s of the
        map; 4 for an isometry, else more; infinite if a triangle is turned over or flat, up to rounding.
        """
        return self.array['energy']

    @property
    def max_stretch(self) -> NDArray[np.float64]:
        """Largest factor by which a length grows."""
        return self.array['max_stretch']

    @property
    def min_stretch(self) -> NDArray[np.float64]:
        """Smallest factor by which a length grows."""
        return self.array['min_stretch']

    @property
    def area(self) -> NDArray[np.float64]:
        """Area of the surface."""
        return self.array['area']

    @property
    def flat_area(self) -> NDArray[np.float64]:
        """Area in the plane."""
        return self.array['flat_area']


class DevelopReport(Record):
    """Points, charts and cuts of a development."""

    __slots__ = ()
    _NAME = 'gusset_develop_report'
    _GETTER = 'gusset_result_get_develop'

    @property
    def points(self) -> NDArray[np.float64]:
        """x, y of each vertex in the plane."""
        return self._array('points', len(self.vertex_map), 2)

    @property
    def vertex_map(self) -> NDArray[np.uint32]:
        """Vertex of the surface for each vertex; repeats on cuts."""
        return self._array('vertex_map')

    @property
    def face_charts(self) -> NDArray[np.uint32]:
        """Chart of each face."""
        return self._array('face_charts')

    @property
    def stretches(self) -> NDArray[np.float64]:
        """Largest and smallest factor by which each face's lengths grow."""
        return self._array('stretches', len(self.face_charts), 2)

    @property
    def charts(self) -> ChartArray:
        """Charts in the order of their first faces, side by side along x."""
        return ChartArray(self._array('charts', self._struct.chart_count))

    @property
    def cut_edges(self) -> NDArray[np.uint32]:
        """Cut edges of the surface, two vertices each: given, opening, then dart cuts."""
        return self._array('cut_edges', -1, 2)

    @property
    def cut_kinds(self) -> NDArray[np.str_]:
        """GUSSET_CUT_... of each cut edge."""
        return words(self._array('cut_kinds'), 'gusset_cut_kind')

    @property
    def darts(self) -> int:
        """Darts."""
        return self._struct.darts


class FacingView(Record):
    """Facing vertices; index 0 is loop A, 1 is loop B."""

    __slots__ = ()
    _NAME = 'gusset_facing_view'
    _GETTER = 'gusset_facing_get_view'

    @property
    def centre(self) -> NDArray[np.float64]:
        """Centres C_1 and C_2, equation 5."""
        return self._array('centre')

    @property
    def normal(self) -> NDArray[np.float64]:
        """Normals C_2 - C_1 and C_1 - C_2 of the planes, equations 6 and 7."""
        return self._array('normal')

    @property
    def distances(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Signed distance of each vertex from its plane, positive towards the other loop."""
        return self._array('distances', self._struct.counts[0], part=0), self._array('distances', self._struct.counts[1], part=1)

    @property
    def runs(self) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """First index and length of each run of facing vertices, alternating; runs may pass the loop's end."""
        return self._array('runs', -1, 2, part=0), self._array('runs', -1, 2, part=1)

    @property
    def taken(self) -> NDArray[np.uint32]:
        """The chosen run, as arc_a and arc_b of gusset_stitch_options."""
        return self._array('taken')


class SectionPath(Record):
    """A polyline of a section."""

    __slots__ = ()
    _NAME = 'gusset_section_path'

    @property
    def plane(self) -> int:
        """Index of the plane."""
        return self._struct.plane

    @property
    def closed(self) -> bool:
        """1: returns to its first point, not repeated."""
        return bool(self._struct.closed)

    @property
    def parent(self) -> int:
        """Smallest closed path of the plane around a closed path, or UINT32_MAX."""
        return self._struct.parent

    @property
    def depth(self) -> int:
        """Number of closed paths around a closed path; else 0."""
        return self._struct.depth

    @property
    def length(self) -> float:
        """Length, with all points."""
        return self._struct.length

    @property
    def area(self) -> float:
        """Area inside a closed path, with all points, positive if counter-clockwise seen against the plane's normal;
        else 0.
        """
        return self._struct.area


class SectionPathArray(RecordArray[SectionPath]):
    """A polyline of a section."""

    __slots__ = ()
    RECORD = SectionPath

    @property
    def plane(self) -> NDArray[np.uint32]:
        """Index of the plane."""
        return self.array['plane']

    @property
    def closed(self) -> NDArray[np.bool_]:
        """1: returns to its first point, not repeated."""
        return self.array['closed'] != 0

    @property
    def parent(self) -> NDArray[np.uint32]:
        """Smallest closed path of the plane around a closed path, or UINT32_MAX."""
        return self.array['parent']

    @property
    def depth(self) -> NDArray[np.uint32]:
        """Number of closed paths around a closed path; else 0."""
        return self.array['depth']

    @property
    def length(self) -> NDArray[np.float64]:
        """Length, with all points."""
        return self.array['length']

    @property
    def area(self) -> NDArray[np.float64]:
        """Area inside a closed path, with all points, positive if counter-clockwise seen against the plane's normal;
        else 0.
        """
        return self.array['area']


class MeshSectionsView(Record):
    """Lent polylines, by plane, then by lowest face."""

    __slots__ = ()
    _NAME = 'gusset_mesh_sections_view'
    _GETTER = 'gusset_mesh_sections_get_view'

    @property
    def plane_count(self) -> int:
        """Number of planes."""
        return self._struct.plane_count

    @property
    def paths(self) -> SectionPathArray:
        """The polylines."""
        return SectionPathArray(self._array('paths', self._struct.path_count))

    @property
    def starts(self) -> NDArray[np.uint32]:
        """Polyline k has the points starts[k] to starts[k + 1] - 1."""
        return self._array('starts')

    @property
    def points(self) -> NDArray[np.float64]:
        """The points."""
        return self._array('points', self._struct.point_count, 3)

    @property
    def edges(self) -> NDArray[np.uint32]:
        """Ends of the edge of each point; equal at a vertex in the plane."""
        return self._array('edges', self._struct.point_count, 2)

    @property
    def parameters(self) -> NDArray[np.float64]:
        """Parameter of each point on its edge, 0 to 1."""
        return self._array('parameters', self._struct.point_count)

    @property
    def faces(self) -> NDArray[np.uint32]:
        """Face of the segment after each point, the first if points were left out; UINT32_MAX at an open path's end."""
        return self._array('faces')


class OriginsView(Record):
    """Origins of the elements of one domain."""

    __slots__ = ()
    _NAME = 'gusset_origins_view'
    _GETTER = 'gusset_origins_get_view'

    @property
    def offsets(self) -> NDArray[np.uint32]:
        """Element k has the sources and weights offsets[k] to offsets[k + 1] - 1, if any."""
        return self._array('offsets')

    @property
    def sources(self) -> NDArray[np.uint32]:
        """Sources, numbered through all inputs."""
        return self._array('sources')

    @property
    def weights(self) -> NDArray[np.float64]:
        """Weight of each source, above 0, sum 1."""
        return self._array('weights', len(self.sources))

    @property
    def starts(self) -> NDArray[np.uint32]:
        """Input i has the sources starts[i] to starts[i + 1] - 1. Inputs are the meshes, pieces, polylines, net or
        sheet in order.
        """
        return self._array('starts')


class Seam(Record):
    """Glues node k of run A, (row_a + k * row_step_a, column_a + k * column_step_a), to node k of run B."""

    __slots__ = ()
    _NAME = 'gusset_seam'

    @property
    def row_a(self) -> int:
        """First row of A."""
        return self._struct.row_a

    @property
    def column_a(self) -> int:
        """First column of A."""
        return self._struct.column_a

    @property
    def row_step_a(self) -> int:
        """Rows a step."""
        return self._struct.row_step_a

    @property
    def column_step_a(self) -> int:
        """Columns a step."""
        return self._struct.column_step_a

    @property
    def row_b(self) -> int:
        """As for A."""
        return self._struct.row_b

    @property
    def column_b(self) -> int:
        """As for A."""
        return self._struct.column_b

    @property
    def row_step_b(self) -> int:
        """As for A."""
        return self._struct.row_step_b

    @property
    def column_step_b(self) -> int:
        """As for A."""
        return self._struct.column_step_b

    @property
    def count(self) -> int:
        """Nodes, at least 1; exactly 1 if all steps are 0."""
        return self._struct.count


class SeamArray(RecordArray[Seam]):
    """Glues node k of run A, (row_a + k * row_step_a, column_a + k * column_step_a), to node k of run B."""

    __slots__ = ()
    RECORD = Seam

    @property
    def row_a(self) -> NDArray[np.uint32]:
        """First row of A."""
        return self.array['row_a']

    @property
    def column_a(self) -> NDArray[np.uint32]:
        """First column of A."""
        return self.array['column_a']

    @property
    def row_step_a(self) -> NDArray[np.int32]:
        """Rows a step."""
        return self.array['row_step_a']

    @property
    def column_step_a(self) -> NDArray[np.int32]:
        """Columns a step."""
        return self.array['column_step_a']

    @property
    def row_b(self) -> NDArray[np.uint32]:
        """As for A."""
        return self.array['row_b']

    @property
    def column_b(self) -> NDArray[np.uint32]:
        """As for A."""
        return self.array['column_b']

    @property
    def row_step_b(self) -> NDArray[np.int32]:
        """As for A."""
        return self.array['row_step_b']

    @property
    def column_step_b(self) -> NDArray[np.int32]:
        """As for A."""
        return self.array['column_step_b']

    @property
    def count(self) -> NDArray[np.uint32]:
        """Nodes, at least 1; exactly 1 if all steps are 0."""
        return self.array['count']


class NetGluingReport(Record):
    """Gluing in normal form: sides replace links, and links seams, where possible."""

    __slots__ = ()
    _NAME = 'gusset_net_gluing_report'
    _GETTER = 'gusset_net_get_gluing'

    @property
    def matrix_size(self) -> int:
        """Bytes of the matrix: 2 * rows * columns."""
        return self._struct.matrix_size

    @property
    def seam_count(self) -> int:
        """Number of seams."""
        return self._struct.seam_count

    @property
    def bridge_count(self) -> int:
        """Number of bridges."""
        return self._struct.bridge_count

    @property
    def sides(self) -> frozenset[choices.Sides]:
        """UINT32_MAX unless sides describe all links."""
        return flags(self._struct.sides, 'gusset_sides')

    @property
    def reversed(self) -> bool:
        """1: opposite orientation of faces."""
        return bool(self._struct.reversed)


class NetGroupsView(Record):
    """Groups of glued nodes, in the order of their first nodes."""

    __slots__ = ()
    _NAME = 'gusset_net_groups_view'
    _GETTER = 'gusset_net_groups_get_view'

    @property
    def offsets(self) -> NDArray[np.uint32]:
        """Offsets into members, by group."""
        return self._array('offsets')

    @property
    def members(self) -> NDArray[np.uint32]:
        """Nodes of all groups, in order within each."""
        return self._array('members')


class GluingOccurrence(Record):
    """Local gluing: n(a,b) at a node or c(a,b) at a cell."""

    __slots__ = ()
    _NAME = 'gusset_gluing_occurrence'

    @property
    def place(self) -> choices.GluingPlace:
        """Element that has a local gluing."""
        return word(self._struct.place, 'gusset_gluing_place')

    @property
    def element(self) -> int:
        """Node or cell."""
        return self._struct.element

    @property
    def kind(self) -> choices.GluingType:
        """Local gluing of Deryagin's figure 4."""
        return word(self._struct.kind, 'gusset_gluing_type')

    @property
    def a(self) -> int:
        """Node: nodes glued to it. Cell: glued links, at most 3; 1 for a diagonal."""
        return self._struct.a

    @property
    def b(self) -> int:
        """Node with two glued links: 1 if adjacent, 2 if opposite. Cell with two: other links between them, 0 or 1.
        Diagonal: 2. Else UINT32_MAX.
        """
        return self._struct.b

    @property
    def node_order(self) -> int:
        """United nodes."""
        return self._struct.node_order

    @property
    def link_order(self) -> int:
        """United links; 1 if none."""
        return self._struct.link_order

    @property
    def class_size(self) -> int:
        """Nodes of the point, above node_order where gluings meet."""
        return self._struct.class_size


class GluingOccurrenceArray(RecordArray[GluingOccurrence]):
    """Local gluing: n(a,b) at a node or c(a,b) at a cell."""

    __slots__ = ()
    RECORD = GluingOccurrence

    @property
    def place(self) -> NDArray[np.str_]:
        """Element that has a local gluing."""
        return words(self.array['place'], 'gusset_gluing_place')

    @property
    def element(self) -> NDArray[np.uint32]:
        """Node or cell."""
        return self.array['element']

    @property
    def kind(self) -> NDArray[np.str_]:
        """Local gluing of Deryagin's figure 4."""
        return words(self.array['kind'], 'gusset_gluing_type')

    @property
    def a(self) -> NDArray[np.uint32]:
        """Node: nodes glued to it. Cell: glued links, at most 3; 1 for a diagonal."""
        return self.array['a']

    @property
    def b(self) -> NDArray[np.uint32]:
        """Node with two glued links: 1 if adjacent, 2 if opposite. Cell with two: other links between them, 0 or 1.
        Diagonal: 2. Else UINT32_MAX.
        """
        return self.array['b']

    @property
    def node_order(self) -> NDArray[np.uint32]:
        """United nodes."""
        return self.array['node_order']

    @property
    def link_order(self) -> NDArray[np.uint32]:
        """United links; 1 if none."""
        return self.array['link_order']

    @property
    def class_size(self) -> NDArray[np.uint32]:
        """Nodes of the point, above node_order where gluings meet."""
        return self.array['class_size']


class NetMeasureReport(Record):
    """Measures of a net; 0 unless requested."""

    __slots__ = ()
    _NAME = 'gusset_net_measure_report'

    @property
    def area(self) -> float:
        """Sum of |(c - a) x (d - b)| / 2 for cells a, b, c, d; exact if planar."""
        return self._struct.area

    @property
    def volume(self) -> float:
        """Enclosed volume of a closed two-sided net, positive if normals point outwards; else of the cone to the
        first node.
        """
        return self._struct.volume

    @property
    def area_vector(self) -> NDArray[np.float64]:
        """Sum of the cells' area vectors; 0 for closed nets."""
        return self._array('area_vector')

    @property
    def low(self) -> NDArray[np.float64]:
        """Smallest coordinates; infinite if all nodes are missing."""
        return self._array('low')

    @property
    def high(self) -> NDArray[np.float64]:
        """Largest coordinates, likewise."""
        return self._array('high')

    @property
    def bilinear_area(self) -> float:
        """Area of the cells' bilinear patches, up to rounding; above area unless cells are planar. All layers of
        folds count.
        """
        return self._struct.bilinear_area

    @property
    def bilinear_error(self) -> float:
        """Bound of bilinear_area's error."""
        return self._struct.bilinear_error

    @property
    def body_volume(self) -> float:
        """Volume of the body in a closed net, negative if normals point inwards."""
        return self._struct.body_volume

    @property
    def centroid(self) -> NDArray[np.float64]:
        """Centroid of the body; NaN if its volume is 0."""
        return self._array('centroid')

    @property
    def inertia(self) -> NDArray[np.float64]:
        """Inertia tensor about the centroid, density 1. Diagonal: integrals of y^2 + z^2 etc.; else of -x y etc."""
        return self._array('inertia', 3, 3)


class NetPlanarityReport(Record):
    """Planarity of cells."""

    __slots__ = ()
    _NAME = 'gusset_net_planarity_report'

    @property
    def worst(self) -> float:
        """Largest deviation of a cell; 0 without cells."""
        return self._struct.worst

    @property
    def worst_cell(self) -> int:
        """Its cell; UINT64_MAX without cells."""
        return self._struct.worst_cell

    @property
    def mean(self) -> float:
        """Mean deviation; NaN without cells."""
        return self._struct.mean

    @property
    def above(self) -> int:
        """Cells above the tolerance."""
        return self._struct.above


class NetMeshReport(Record):
    """Maps between a net and its mesh."""

    __slots__ = ()
    _NAME = 'gusset_net_mesh_report'
    _GETTER = 'gusset_result_get_net_mesh'

    @property
    def vertex_of_node(self) -> NDArray[np.uint32]:
        """Vertex of each node, or UINT32_MAX."""
        return self._array('vertex_of_node')

    @property
    def node_of_vertex(self) -> NDArray[np.uint32]:
        """First node of each vertex."""
        return self._array('node_of_vertex')

    @property
    def cell_of_face(self) -> NDArray[np.uint32]:
        """Cell of each face."""
        return self._array('cell_of_face')

    @property
    def wires(self) -> NDArray[np.uint32]:
        """Edges without faces, two vertices each: cells with opposite sides glued."""
        return self._array('wires', -1, 2)

    @property
    def texture_corners(self) -> NDArray[np.uint32]:
        """For each corner, its pair in texture_coordinates; empty unless requested."""
        return self._array('texture_corners')

    @property
    def texture_coordinates(self) -> NDArray[np.float64]:
        """Pairs (column, row), 0 to 1. A vertex on a seam has a pair on each side."""
        return self._array('texture_coordinates', self._struct.texture_count, 2)


class NetGridView(Record):
    """Correspondence between a net and its mesh."""

    __slots__ = ()
    _NAME = 'gusset_net_grid_view'
    _GETTER = 'gusset_net_grid_get_view'

    @property
    def vertex_of_node(self) -> NDArray[np.uint32]:
        """Vertex of each node."""
        return self._array('vertex_of_node')

    @property
    def face_of_cell(self) -> NDArray[np.uint32]:
        """Face of each cell, the first of two for GUSSET_GRID_TRIANGLES."""
        return self._array('face_of_cell')


class BridgeProperties(Record):
    """Properties of a bridge for gusset_net_settle, in any unit of force. Lines run across it along links."""

    __slots__ = ()
    _NAME = 'gusset_bridge_properties'

    @property
    def tension(self) -> float:
        """Force in each line of a thread or ribbon, or per length in a tube's film; at least 0."""
        return self._struct.tension

    @property
    def elasticity(self) -> float:
        """Force that doubles a line's length; at least 0."""
        return self._struct.elasticity

    @property
    def stiffness(self) -> float:
        """Bending stiffness of each line, force x length^2; at least 0. Infinity: rigid."""
        return self._struct.stiffness

    @property
    def user(self) -> int:
        """For the caller's use."""
        return self._struct.user


class BridgePropertiesArray(RecordArray[BridgeProperties]):
    """Properties of a bridge for gusset_net_settle, in any unit of force. Lines run across it along links."""

    __slots__ = ()
    RECORD = BridgeProperties

    @property
    def tension(self) -> NDArray[np.float64]:
        """Force in each line of a thread or ribbon, or per length in a tube's film; at least 0."""
        return self.array['tension']

    @property
    def elasticity(self) -> NDArray[np.float64]:
        """Force that doubles a line's length; at least 0."""
        return self.array['elasticity']

    @property
    def stiffness(self) -> NDArray[np.float64]:
        """Bending stiffness of each line, force x length^2; at least 0. Infinity: rigid."""
        return self.array['stiffness']

    @property
    def user(self) -> NDArray[np.uint64]:
        """For the caller's use."""
        return self.array['user']


class Bridge(Record):
    """The cells between two joined nets."""

    __slots__ = ()
    _NAME = 'gusset_bridge'
    _GETTER = 'gusset_net_get_bridge'

    @property
    def properties(self) -> BridgeProperties:
        """Properties given."""
        return BridgeProperties(self._struct.properties, self._owner)

    @property
    def direction(self) -> choices.Direction:
        """Direction from first to second net."""
        return word(self._struct.direction, 'gusset_direction')

    @property
    def at(self) -> int:
        """First column (RIGHT) or row (DOWN) of the second net."""
        return self._struct.at

    @property
    def start(self) -> int:
        """First node along the side: row (RIGHT) or column (DOWN)."""
        return self._struct.start

    @property
    def end(self) -> int:
        """One past the last node."""
        return self._struct.end

    @property
    def kind(self) -> choices.BridgeKind:
        """Form of a bridge."""
        return word(self._struct.kind, 'gusset_bridge_kind')

    @property
    def mode(self) -> choices.BridgeMode:
        """Treatment of the cells of a bridge."""
        return word(self._struct.mode, 'gusset_bridge_mode')

    @property
    def rows(self) -> int:
        """Rows (DOWN) or columns (RIGHT) between the nets, to at - 1. The first net ends at at - rows - 1."""
        return self._struct.rows


class NetAnalysisView(Record):
    """Effects of a deformation."""

    __slots__ = ()
    _NAME = 'gusset_net_analysis_view'
    _GETTER = 'gusset_net_analysis_get_view'

    @property
    def links(self) -> NDArray[np.float64]:
        """New / old length of each link; NaN if the old is 0 or an end missing."""
        return self._array('links', self._struct.link_count)

    @property
    def cells(self) -> NDArray[np.float64]:
        """New / old area of each cell; NaN if the old is 0 or the cell absent. Negative for folds, with fields for
        negative determinants.
        """
        return self._array('cells', self._struct.cell_count)

    @property
    def determinants(self) -> NDArray[np.float64]:
        """The fields' Jacobian determinant at each cell's centre; NULL if nets are compared."""
        return self._array('determinants', self._struct.cell_count)

    @property
    def contracted(self) -> NDArray[np.uint32]:
        """Newly contracted links, whose ends are not glued; links of gusset_glue_options glues them."""
        return self._array('contracted', self._struct.contracted_count)

    @property
    def stars(self) -> NDArray[np.str_]:
        """For each, the local gluing of its first node once all are contracted: 0 to 17."""
        return words(self._array('stars', self._struct.contracted_count), 'gusset_gluing_type')

    @property
    def torn(self) -> NDArray[np.uint32]:
        """Glued links whose ends separated."""
        return self._array('torn', self._struct.torn_count)

    @property
    def folded(self) -> NDArray[np.uint32]:
        """Cells oriented against the majority."""
        return self._array('folded', self._struct.folded_count)

    @property
    def soft(self) -> bool:
        """1: soft, nothing newly glued, torn or folded; 0: hard."""
        return bool(self._struct.soft)


class NetComplexView(Record):
    """Counts, and sorted lists of defects. A vertex is its smallest node, an edge a pair."""

    __slots__ = ()
    _NAME = 'gusset_net_complex_view'
    _GETTER = 'gusset_net_complex_get_view'

    @property
    def vertex_count(self) -> int:
        """Number of vertices."""
        return self._struct.vertex_count

    @property
    def edge_count(self) -> int:
        """Edges; links with equal ends are one."""
        return self._struct.edge_count

    @property
    def quad_count(self) -> int:
        """Number of quads."""
        return self._struct.quad_count

    @property
    def triangle_count(self) -> int:
        """Number of triangles."""
        return self._struct.triangle_count

    @property
    def digon_count(self) -> int:
        """Cells reduced to an edge."""
        return self._struct.digon_count

    @property
    def point_count(self) -> int:
        """Cells reduced to a point."""
        return self._struct.point_count

    @property
    def fold_count(self) -> int:
        """Cells folded along a diagonal."""
        return self._struct.fold_count

    @property
    def boundary_edge_count(self) -> int:
        """Number of boundary edges."""
        return self._struct.boundary_edge_count

    @property
    def component_count(self) -> int:
        """Number of connected components."""
        return self._struct.component_count

    @property
    def euler(self) -> int:
        """Vertices - edges + faces."""
        return self._struct.euler

    @property
    def genus(self) -> int:
        """Handles, or crosscaps if not orientable, of all components; -1 if not manifold."""
        return self._struct.genus

    @property
    def properties(self) -> frozenset[choices.NetFlags]:
        """Properties of the surface of a net."""
        return flags(self._struct.properties, 'gusset_net_flags')

    @property
    def boundary_offsets(self) -> NDArray[np.uint32]:
        """Offsets into boundary_nodes, by chain."""
        return self._array('boundary_offsets')

    @property
    def boundary_nodes(self) -> NDArray[np.uint32]:
        """Vertices of chains of boundary edges, faces on the left."""
        return self._array('boundary_nodes')

    @property
    def boundary_open(self) -> NDArray[np.bool_]:
        """For each chain: 1 if it ends at branches, 0 for a loop."""
        return self._array('boundary_open') != 0

    @property
    def wires(self) -> NDArray[np.uint32]:
        """Edges without faces."""
        return self._array('wires', -1, 2)

    @property
    def branches(self) -> NDArray[np.uint32]:
        """Non-manifold edges."""
        return self._array('branches', -1, 2)

    @property
    def pinches(self) -> NDArray[np.uint32]:
        """Vertices whose faces form several fans."""
        return self._array('pinches')

    @property
    def conflicts(self) -> NDArray[np.uint32]:
        """Edges that two faces traverse in one direction."""
        return self._array('conflicts', -1, 2)


class PlanariseReport(Record):
    """Result of gusset_net_planarise."""

    __slots__ = ()
    _NAME = 'gusset_planarise_report'

    @property
    def size(self) -> float:
        """Initial box diagonal."""
        return self._struct.size

    @property
    def tolerance(self) -> float:
        """Tolerance times size."""
        return self._struct.tolerance

    @property
    def deviation_before(self) -> float:
        """Largest initial distance of corners from their mean plane."""
        return self._struct.deviation_before

    @property
    def deviation_after(self) -> float:
        """Largest final distance."""
        return self._struct.deviation_after

    @property
    def max_displacement(self) -> float:
        """Largest displacement of a point."""
        return self._struct.max_displacement

    @property
    def rms_displacement(self) -> float:
        """Root mean square displacement of all points of quads."""
        return self._struct.rms_displacement

    @property
    def worst_cell(self) -> int:
        """Cell with deviation_after; UINT64_MAX without quads."""
        return self._struct.worst_cell

    @property
    def iterations(self) -> int:
        """Steps; 0 if all cells were planar and no bit changed."""
        return self._struct.iterations

    @property
    def converged(self) -> bool:
        """1: deviation_after is within the tolerance."""
        return bool(self._struct.converged)


class SettleReport(Record):
    """Result of gusset_net_settle. Energies are forces times lengths."""

    __slots__ = ()
    _NAME = 'gusset_settle_report'

    @property
    def energy_before(self) -> float:
        """Initial energy, rigid bridges in shape."""
        return self._struct.energy_before

    @property
    def tension_energy(self) -> float:
        """Final energy of tension."""
        return self._struct.tension_energy

    @property
    def elastic_energy(self) -> float:
        """Final energy of elasticity."""
        return self._struct.elastic_energy

    @property
    def bending_energy(self) -> float:
        """Final energy of bending."""
        return self._struct.bending_energy

    @property
    def residual_force(self) -> float:
        """Largest final force on an inner point or free body."""
        return self._struct.residual_force

    @property
    def max_displacement(self) -> float:
        """Largest displacement of a point."""
        return self._struct.max_displacement

    @property
    def iterations(self) -> int:
        """Steps."""
        return self._struct.iterations

    @property
    def settled(self) -> int:
        """Counted bridges with forces."""
        return self._struct.settled

    @property
    def idle(self) -> int:
        """Counted bridges without forces, whose nodes stay: hidden, welded, or with properties 0."""
        return self._struct.idle

    @property
    def collapsed(self) -> int:
        """Films with a cell below 1e-6 of the initial mean cell area."""
        return self._struct.collapsed

    @property
    def converged(self) -> bool:
        """1: no film collapsed, and the last step met the tolerance or was too small to lower the energy."""
        return bool(self._struct.converged)


class NetFinding(Record):
    """Finding of a validation."""

    __slots__ = ()
    _NAME = 'gusset_net_finding'

    @property
    def kind(self) -> choices.NetFindingKind:
        """Kind of a finding."""
        return word(self._struct.kind, 'gusset_net_finding_kind')

    @property
    def element(self) -> int:
        """Link, or index of the seam."""
        return self._struct.element

    @property
    def nodes(self) -> NDArray[np.uint32]:
        """The two nodes."""
        return self._array('nodes')

    @property
    def distance(self) -> float:
        """Distance of the nodes; NaN if one is missing."""
        return self._struct.distance


class NetFindingArray(RecordArray[NetFinding]):
    """Finding of a validation."""

    __slots__ = ()
    RECORD = NetFinding

    @property
    def kind(self) -> NDArray[np.str_]:
        """Kind of a finding."""
        return words(self.array['kind'], 'gusset_net_finding_kind')

    @property
    def element(self) -> NDArray[np.uint32]:
        """Link, or index of the seam."""
        return self.array['element']

    @property
    def nodes(self) -> NDArray[np.uint32]:
        """The two nodes."""
        return self.array['nodes']

    @property
    def distance(self) -> NDArray[np.float64]:
        """Distance of the nodes; NaN if one is missing."""
        return self.array['distance']


class NetValidationView(Record):
    """Violations, then warnings, sorted by kind and element."""

    __slots__ = ()
    _NAME = 'gusset_net_validation_view'
    _GETTER = 'gusset_net_validation_get_view'

    @property
    def findings(self) -> NetFindingArray:
        """The findings."""
        return NetFindingArray(self._array('findings', self._struct.count))

    @property
    def violation_count(self) -> int:
        """Number of violations."""
        return self._struct.violation_count


class WingedEdge(Record):
    """An edge in Baumgart's notation, UINT32_MAX for NULL. Faces are clockwise seen from outside."""

    __slots__ = ()
    _NAME = 'gusset_winged_edge'

    @property
    def m(self) -> int:
        """Start vertex M."""
        return self._struct.m

    @property
    def n(self) -> int:
        """End vertex N."""
        return self._struct.n

    @property
    def b(self) -> int:
        """Next edge in R, at N."""
        return self._struct.b

    @property
    def c(self) -> int:
        """Previous edge in L, at N."""
        return self._struct.c

    @property
    def d(self) -> int:
        """Previous edge in R, at M."""
        return self._struct.d

    @property
    def e(self) -> int:
        """Next edge in L, at M."""
        return self._struct.e

    @property
    def left(self) -> int:
        """Face L, which traverses the edge from N to M."""
        return self._struct.left

    @property
    def right(self) -> int:
        """Face R, which traverses the edge from M to N."""
        return self._struct.right

    @property
    def marks(self) -> frozenset[choices.WingedFlags]:
        """Marks of an edge."""
        return flags(self._struct.marks, 'gusset_winged_flags')


class WingedEdgeArray(RecordArray[WingedEdge]):
    """An edge in Baumgart's notation, UINT32_MAX for NULL. Faces are clockwise seen from outside."""

    __slots__ = ()
    RECORD = WingedEdge

    @property
    def m(self) -> NDArray[np.uint32]:
        """Start vertex M."""
        return self.array['m']

    @property
    def n(self) -> NDArray[np.uint32]:
        """End vertex N."""
        return self.array['n']

    @property
    def b(self) -> NDArray[np.uint32]:
        """Next edge in R, at N."""
        return self.array['b']

    @property
    def c(self) -> NDArray[np.uint32]:
        """Previous edge in L, at N."""
        return self.array['c']

    @property
    def d(self) -> NDArray[np.uint32]:
        """Previous edge in R, at M."""
        return self.array['d']

    @property
    def e(self) -> NDArray[np.uint32]:
        """Next edge in L, at M."""
        return self.array['e']

    @property
    def left(self) -> NDArray[np.uint32]:
        """Face L, which traverses the edge from N to M."""
        return self.array['left']

    @property
    def right(self) -> NDArray[np.uint32]:
        """Face R, which traverses the edge from M to N."""
        return self.array['right']

    @property
    def marks(self) -> FlagArray[choices.WingedFlags]:
        """Marks of an edge."""
        return FlagArray(self.array['marks'], 'gusset_winged_flags')


class WingedView(Record):
    """Lent tables."""

    __slots__ = ()
    _NAME = 'gusset_winged_view'
    _GETTER = 'gusset_winged_get_view'

    @property
    def edges(self) -> WingedEdgeArray:
        """Edges, ordered by their first half-edges, which start at M."""
        return WingedEdgeArray(self._array('edges', self._struct.edge_count))

    @property
    def edge_of_half_edge(self) -> NDArray[np.uint32]:
        """Edge of each half-edge (position in face_corners)."""
        return self._array('edge_of_half_edge')

    @property
    def edge_of_face(self) -> NDArray[np.uint32]:
        """First edge of each face."""
        return self._array('edge_of_face')

    @property
    def edge_of_vertex(self) -> NDArray[np.uint32]:
        """An edge at each vertex, or UINT32_MAX."""
        return self._array('edge_of_vertex')

    @property
    def loop_vertices(self) -> NDArray[np.uint32]:
        """Vertices of all boundary loops, surface on the left. Exactly one of L and R of a boundary edge is NULL."""
        return self._array('loop_vertices')

    @property
    def loop_edges(self) -> NDArray[np.uint32]:
        """Edges of the loops; edge i starts at vertex i."""
        return self._array('loop_edges')

    @property
    def loop_offsets(self) -> NDArray[np.uint32]:
        """Offsets into loop_vertices and loop_edges, by loop."""
        return self._array('loop_offsets')


class WingedFacesView(Record):
    """Lent faces."""

    __slots__ = ()
    _NAME = 'gusset_winged_faces_view'
    _GETTER = 'gusset_winged_faces_get_view'

    @property
    def face_offsets(self) -> NDArray[np.uint32]:
        """As in gusset_mesh_view."""
        return self._array('face_offsets')

    @property
    def face_corners(self) -> NDArray[np.uint32]:
        """As in gusset_mesh_view."""
        return self._array('face_corners')

    @property
    def edge_of_half_edge(self) -> NDArray[np.uint32]:
        """Edge that leaves each corner."""
        return self._array('edge_of_half_edge')


class SceneEntryReport(Record):
    """Entry of a scene."""

    __slots__ = ()
    _NAME = 'gusset_scene_entry_report'
    _GETTER = 'gusset_scene_get_entry'

    @property
    def transform(self) -> Transform:
        """Map into its groups' space."""
        return Transform(self._struct.transform, self._owner)

    @property
    def child_count(self) -> int:
        """Entries in a group; 0 for a net."""
        return self._struct.child_count

    @property
    def kind(self) -> choices.SceneEntryKind:
        """Kind of a scene entry."""
        return word(self._struct.kind, 'gusset_scene_entry_kind')

    @property
    def visible(self) -> bool:
        """1: shown, unless an enclosing group is hidden."""
        return bool(self._struct.visible)


class SceneReport(Record):
    """Size of a scene. Top-level entries are outside all groups."""

    __slots__ = ()
    _NAME = 'gusset_scene_report'
    _GETTER = 'gusset_scene_get_report'

    @property
    def instances(self) -> int:
        """Paths from top-level entries; at most UINT64_MAX."""
        return self._struct.instances

    @property
    def net_instances(self) -> int:
        """Instances of nets."""
        return self._struct.net_instances

    @property
    def nets(self) -> int:
        """Entries that are nets."""
        return self._struct.nets

    @property
    def groups(self) -> int:
        """Entries that are groups."""
        return self._struct.groups

    @property
    def levels(self) -> int:
        """Entries of the longest path; 0 if empty."""
        return self._struct.levels


class SceneInstance(Record):
    """Path from top level to an entry."""

    __slots__ = ()
    _NAME = 'gusset_scene_instance'

    @property
    def world(self) -> Transform:
        """Map into the scene's space."""
        return Transform(self._struct.world, self._owner)

    @property
    def entry(self) -> int:
        """The entry."""
        return self._struct.entry

    @property
    def parent(self) -> int:
        """Instance of the enclosing group, or UINT32_MAX."""
        return self._struct.parent

    @property
    def visible(self) -> bool:
        """1 unless the entry or an enclosing group is hidden."""
        return bool(self._struct.visible)


class SceneInstanceArray(RecordArray[SceneInstance]):
    """Path from top level to an entry."""

    __slots__ = ()
    RECORD = SceneInstance

    @property
    def world(self) -> TransformArray:
        """Map into the scene's space."""
        return TransformArray(self.array['world'])

    @property
    def entry(self) -> NDArray[np.uint32]:
        """The entry."""
        return self.array['entry']

    @property
    def parent(self) -> NDArray[np.uint32]:
        """Instance of the enclosing group, or UINT32_MAX."""
        return self.array['parent']

    @property
    def visible(self) -> NDArray[np.bool_]:
        """1 unless the entry or an enclosing group is hidden."""
        return self.array['visible'] != 0


class StreamReport(Record):
    """Header of a stream."""

    __slots__ = ()
    _NAME = 'gusset_stream_report'

    @property
    def rows(self) -> int:
        """Node rows."""
        return self._struct.rows

    @property
    def columns(self) -> int:
        """Node columns."""
        return self._struct.columns

    @property
    def rows_per_block(self) -> int:
        """Rows of a block; the last may have fewer."""
        return self._struct.rows_per_block

    @property
    def prelude_size(self) -> int:
        """Bytes before the first block."""
        return self._struct.prelude_size

    @property
    def origin(self) -> NDArray[np.float64]:
        """QUANTISED: level 0; level k is at origin + k * step. Else 0."""
        return self._array('origin')

    @property
    def step(self) -> NDArray[np.float64]:
        """QUANTISED: distance of levels; errors are at most step / 2 and half a unit in the last place. Else 0."""
        return self._array('step')

    @property
    def scalar(self) -> choices.Scalar:
        """Type of coordinates."""
        return word(self._struct.scalar, 'gusset_scalar')

    @property
    def mode(self) -> choices.StreamMode:
        """Storage of coordinates in a stream."""
        return word(self._struct.mode, 'gusset_stream_mode')

    @property
    def bits(self) -> int:
        """QUANTISED: bits of a coordinate. Else 0."""
        return self._struct.bits


class SurfaceSheet(Record):
    """Size and numbering of a sheet."""

    __slots__ = ()
    _NAME = 'gusset_surface_sheet'

    @property
    def rows(self) -> int:
        """Rows of cells: u runs from 0 to rows."""
        return self._struct.rows

    @property
    def columns(self) -> int:
        """Columns of cells, in v."""
        return self._struct.columns

    @property
    def first_cell(self) -> int:
        """Number of cell (0, 0) among all sheets' cells; cell (i, j) is first_cell + i * columns + j, its bit in
        region masks.
        """
        return self._struct.first_cell

    @property
    def first_node(self) -> int:
        """Number of corner (0, 0) among all sheets' corners, (rows + 1) x (columns + 1) each: offset of values for
        GUSSET_CONTOUR_VALUES.
        """
        return self._struct.first_node

    @property
    def closed_u(self) -> bool:
        """1: closed in u."""
        return bool(self._struct.closed_u)

    @property
    def closed_v(self) -> bool:
        """1: closed in v."""
        return bool(self._struct.closed_v)


class SurfaceSheetArray(RecordArray[SurfaceSheet]):
    """Size and numbering of a sheet."""

    __slots__ = ()
    RECORD = SurfaceSheet

    @property
    def rows(self) -> NDArray[np.uintp]:
        """Rows of cells: u runs from 0 to rows."""
        return self.array['rows']

    @property
    def columns(self) -> NDArray[np.uintp]:
        """Columns of cells, in v."""
        return self.array['columns']

    @property
    def first_cell(self) -> NDArray[np.uint64]:
        """Number of cell (0, 0) among all sheets' cells; cell (i, j) is first_cell + i * columns + j, its bit in
        region masks.
        """
        return self.array['first_cell']

    @property
    def first_node(self) -> NDArray[np.uint64]:
        """Number of corner (0, 0) among all sheets' corners, (rows + 1) x (columns + 1) each: offset of values for
        GUSSET_CONTOUR_VALUES.
        """
        return self.array['first_node']

    @property
    def closed_u(self) -> NDArray[np.bool_]:
        """1: closed in u."""
        return self.array['closed_u'] != 0

    @property
    def closed_v(self) -> NDArray[np.bool_]:
        """1: closed in v."""
        return self.array['closed_v'] != 0


class SurfacePlace(Record):
    """A place on a surface."""

    __slots__ = ()
    _NAME = 'gusset_surface_place'

    @property
    def sheet(self) -> int:
        """Index of the sheet."""
        return self._struct.sheet

    @property
    def row(self) -> int:
        """Row of the cell."""
        return self._struct.row

    @property
    def column(self) -> int:
        """Column of the cell."""
        return self._struct.column

    @property
    def u(self) -> float:
        """Parameter in the cell, 0 to 1; the sheet's is row + u."""
        return self._struct.u

    @property
    def v(self) -> float:
        """Parameter in the cell, 0 to 1; the sheet's is column + v."""
        return self._struct.v


class SurfacePlaceArray(RecordArray[SurfacePlace]):
    """A place on a surface."""

    __slots__ = ()
    RECORD = SurfacePlace

    @property
    def sheet(self) -> NDArray[np.uint32]:
        """Index of the sheet."""
        return self.array['sheet']

    @property
    def row(self) -> NDArray[np.uint32]:
        """Row of the cell."""
        return self.array['row']

    @property
    def column(self) -> NDArray[np.uint32]:
        """Column of the cell."""
        return self.array['column']

    @property
    def u(self) -> NDArray[np.float64]:
        """Parameter in the cell, 0 to 1; the sheet's is row + u."""
        return self.array['u']

    @property
    def v(self) -> NDArray[np.float64]:
        """Parameter in the cell, 0 to 1; the sheet's is column + v."""
        return self.array['v']


class SurfaceContact(Record):
    """A point where surfaces touch within the tolerance, with parallel normals."""

    __slots__ = ()
    _NAME = 'gusset_surface_contact'

    @property
    def place(self) -> SurfacePlace:
        """Place on the first surface."""
        return SurfacePlace(self._struct.place, self._owner)

    @property
    def other(self) -> SurfacePlace:
        """Place on the second surface."""
        return SurfacePlace(self._struct.other, self._owner)

    @property
    def gap(self) -> float:
        """Height of the first above the second, along the first's normal."""
        return self._struct.gap

    @property
    def radius(self) -> float:
        """Near it, points within the tolerance of the other surface lie this near, except on crossing branches."""
        return self._struct.radius

    @property
    def kind(self) -> choices.ContactKind:
        """How two surfaces touch."""
        return word(self._struct.kind, 'gusset_contact_kind')


class SurfaceContactArray(RecordArray[SurfaceContact]):
    """A point where surfaces touch within the tolerance, with parallel normals."""

    __slots__ = ()
    RECORD = SurfaceContact

    @property
    def place(self) -> SurfacePlaceArray:
        """Place on the first surface."""
        return SurfacePlaceArray(self.array['place'])

    @property
    def other(self) -> SurfacePlaceArray:
        """Place on the second surface."""
        return SurfacePlaceArray(self.array['other'])

    @property
    def gap(self) -> NDArray[np.float64]:
        """Height of the first above the second, along the first's normal."""
        return self.array['gap']

    @property
    def radius(self) -> NDArray[np.float64]:
        """Near it, points within the tolerance of the other surface lie this near, except on crossing branches."""
        return self.array['radius']

    @property
    def kind(self) -> NDArray[np.str_]:
        """How two surfaces touch."""
        return words(self.array['kind'], 'gusset_contact_kind')


class SurfacePathsView(Record):
    """Lent curves."""

    __slots__ = ()
    _NAME = 'gusset_surface_paths_view'
    _GETTER = 'gusset_surface_paths_get_view'

    @property
    def ends(self) -> NDArray[np.uint32]:
        """Offsets into points, by curve."""
        return self._array('ends')

    @property
    def closed(self) -> NDArray[np.bool_]:
        """By curve: 1 if closed; append the first point for gusset_curve_through_create."""
        return self._array('closed', self._struct.path_count) != 0

    @property
    def levels(self) -> NDArray[np.uint32]:
        """By curve: index of its plane, level or angle, or 0."""
        return self._array('levels', self._struct.path_count)

    @property
    def points(self) -> NDArray[np.float64]:
        """On the surface."""
        return self._array('points', self._struct.point_count, 3)

    @property
    def normals(self) -> NDArray[np.float64]:
        """Unit normals; 0 where undefined."""
        return self._array('normals', self._struct.point_count, 3)

    @property
    def places(self) -> SurfacePlaceArray:
        """Places of the points."""
        return SurfacePlaceArray(self._array('places', self._struct.point_count))

    @property
    def others(self) -> SurfacePlaceArray:
        """Intersections: places on the second surface."""
        return SurfacePlaceArray(self._array('others', self._struct.point_count))

    @property
    def unresolved(self) -> SurfacePlaceArray:
        """Cells that may hold tangencies, coincidences, or pieces below the tolerance."""
        return SurfacePlaceArray(self._array('unresolved', self._struct.unresolved_count))

    @property
    def contacts(self) -> SurfaceContactArray:
        """Intersections: points where surfaces touch."""
        return SurfaceContactArray(self._array('contacts', self._struct.contact_count))


class SurfaceNearestPoint(Record):
    """A surface point near a query."""

    __slots__ = ()
    _NAME = 'gusset_surface_nearest_point'

    @property
    def place(self) -> SurfacePlace:
        """Place on the surface."""
        return SurfacePlace(self._struct.place, self._owner)

    @property
    def point(self) -> NDArray[np.float64]:
        """x, y, z."""
        return self._array('point')

    @property
    def normal(self) -> NDArray[np.float64]:
        """Unit normal; at a pole its limit; 0 if undefined. The query is on its side if (query - point) . normal > 0."""
        return self._array('normal')

    @property
    def distance(self) -> float:
        """Distance from the query."""
        return self._struct.distance

    @property
    def bound(self) -> float:
        """Lower bound of the distance from the surface (minima: from the piece round the point)."""
        return self._struct.bound

    @property
    def flags(self) -> frozenset[choices.NearestFlags]:
        """Properties of a nearest point."""
        return flags(self._struct.flags, 'gusset_nearest_flags')


class SurfaceNearestPointArray(RecordArray[SurfaceNearestPoint]):
    """A surface point near a query."""

    __slots__ = ()
    RECORD = SurfaceNearestPoint

    @property
    def place(self) -> SurfacePlaceArray:
        """Place on the surface."""
        return SurfacePlaceArray(self.array['place'])

    @property
    def point(self) -> NDArray[np.float64]:
        """x, y, z."""
        return self.array['point']

    @property
    def normal(self) -> NDArray[np.float64]:
        """Unit normal; at a pole its limit; 0 if undefined. The query is on its side if (query - point) . normal > 0."""
        return self.array['normal']

    @property
    def distance(self) -> NDArray[np.float64]:
        """Distance from the query."""
        return self.array['distance']

    @property
    def bound(self) -> NDArray[np.float64]:
        """Lower bound of the distance from the surface (minima: from the piece round the point)."""
        return self.array['bound']

    @property
    def flags(self) -> FlagArray[choices.NearestFlags]:
        """Properties of a nearest point."""
        return FlagArray(self.array['flags'], 'gusset_nearest_flags')


class SurfacePointsView(Record):
    """Lent points."""

    __slots__ = ()
    _NAME = 'gusset_surface_points_view'
    _GETTER = 'gusset_surface_points_get_view'

    @property
    def points(self) -> SurfaceNearestPointArray:
        """The points, nearest first."""
        return SurfaceNearestPointArray(self._array('points', self._struct.count))

    @property
    def bound(self) -> float:
        """No minimum below this distance is missing."""
        return self._struct.bound

    @property
    def complete(self) -> bool:
        """0 if the search stopped at `bound`."""
        return bool(self._struct.complete)


class SurfacePoint(Record):
    """Point, derivatives by the cell's parameters, normal and curvatures."""

    __slots__ = ()
    _NAME = 'gusset_surface_point'

    @property
    def point(self) -> NDArray[np.float64]:
        """The point."""
        return self._array('point')

    @property
    def u(self) -> NDArray[np.float64]:
        """S_u."""
        return self._array('u')

    @property
    def v(self) -> NDArray[np.float64]:
        """S_v."""
        return self._array('v')

    @property
    def uu(self) -> NDArray[np.float64]:
        """S_uu."""
        return self._array('uu')

    @property
    def uv(self) -> NDArray[np.float64]:
        """S_uv."""
        return self._array('uv')

    @property
    def vv(self) -> NDArray[np.float64]:
        """S_vv."""
        return self._array('vv')

    @property
    def normal(self) -> NDArray[np.float64]:
        """Unit normal along S_u x S_v; 0 if undefined."""
        return self._array('normal')

    @property
    def spread(self) -> float:
        """GUSSET_NORMAL_LIMIT: largest angle to limits along other lines."""
        return self._struct.spread

    @property
    def principal(self) -> NDArray[np.float64]:
        """Principal curvatures, greater first; positive if bent towards the normal."""
        return self._array('principal')

    @property
    def directions(self) -> NDArray[np.float64]:
        """Principal directions: two unit tangents."""
        return self._array('directions', 2, 3)

    @property
    def mean(self) -> float:
        """Mean curvature."""
        return self._struct.mean

    @property
    def gaussian(self) -> float:
        """Gaussian curvature."""
        return self._struct.gaussian

    @property
    def normal_kind(self) -> choices.NormalKind:
        """Kind of a normal."""
        return word(self._struct.normal_kind, 'gusset_normal_kind')

    @property
    def is_curved(self) -> bool:
        """0: not regular; curvatures are 0."""
        return bool(self._struct.is_curved)


class SurfacePointArray(RecordArray[SurfacePoint]):
    """Point, derivatives by the cell's parameters, normal and curvatures."""

    __slots__ = ()
    RECORD = SurfacePoint

    @property
    def point(self) -> NDArray[np.float64]:
        """The point."""
        return self.array['point']

    @property
    def u(self) -> NDArray[np.float64]:
        """S_u."""
        return self.array['u']

    @property
    def v(self) -> NDArray[np.float64]:
        """S_v."""
        return self.array['v']

    @property
    def uu(self) -> NDArray[np.float64]:
        """S_uu."""
        return self.array['uu']

    @property
    def uv(self) -> NDArray[np.float64]:
        """S_uv."""
        return self.array['uv']

    @property
    def vv(self) -> NDArray[np.float64]:
        """S_vv."""
        return self.array['vv']

    @property
    def normal(self) -> NDArray[np.float64]:
        """Unit normal along S_u x S_v; 0 if undefined."""
        return self.array['normal']

    @property
    def spread(self) -> NDArray[np.float64]:
        """GUSSET_NORMAL_LIMIT: largest angle to limits along other lines."""
        return self.array['spread']

    @property
    def principal(self) -> NDArray[np.float64]:
        """Principal curvatures, greater first; positive if bent towards the normal."""
        return self.array['principal']

    @property
    def directions(self) -> NDArray[np.float64]:
        """Principal directions: two unit tangents."""
        return self.array['directions'].reshape(*self.array.shape, 2, 3)

    @property
    def mean(self) -> NDArray[np.float64]:
        """Mean curvature."""
        return self.array['mean']

    @property
    def gaussian(self) -> NDArray[np.float64]:
        """Gaussian curvature."""
        return self.array['gaussian']

    @property
    def normal_kind(self) -> NDArray[np.str_]:
        """Kind of a normal."""
        return words(self.array['normal_kind'], 'gusset_normal_kind')

    @property
    def is_curved(self) -> NDArray[np.bool_]:
        """0: not regular; curvatures are 0."""
        return self.array['is_curved'] != 0


class SurfaceHit(Record):
    """A common point of a surface and a line or curve."""

    __slots__ = ()
    _NAME = 'gusset_surface_hit'

    @property
    def t(self) -> float:
        """Parameter on the line; on a curve, segment + its parameter."""
        return self._struct.t

    @property
    def span(self) -> NDArray[np.float64]:
        """Parameters between which both agree within the tolerance; crossings: t twice."""
        return self._array('span')

    @property
    def place(self) -> SurfacePlace:
        """Place on the surface."""
        return SurfacePlace(self._struct.place, self._owner)

    @property
    def point(self) -> NDArray[np.float64]:
        """Point on the surface."""
        return self._array('point')

    @property
    def normal(self) -> NDArray[np.float64]:
        """Unit normal; at a pole its limit; 0 if undefined."""
        return self._array('normal')

    @property
    def kind(self) -> choices.HitKind:
        """Kind of a hit."""
        return word(self._struct.kind, 'gusset_hit_kind')


class SurfaceHitArray(RecordArray[SurfaceHit]):
    """A common point of a surface and a line or curve."""

    __slots__ = ()
    RECORD = SurfaceHit

    @property
    def t(self) -> NDArray[np.float64]:
        """Parameter on the line; on a curve, segment + its parameter."""
        return self.array['t']

    @property
    def span(self) -> NDArray[np.float64]:
        """Parameters between which both agree within the tolerance; crossings: t twice."""
        return self.array['span']

    @property
    def place(self) -> SurfacePlaceArray:
        """Place on the surface."""
        return SurfacePlaceArray(self.array['place'])

    @property
    def point(self) -> NDArray[np.float64]:
        """Point on the surface."""
        return self.array['point']

    @property
    def normal(self) -> NDArray[np.float64]:
        """Unit normal; at a pole its limit; 0 if undefined."""
        return self.array['normal']

    @property
    def kind(self) -> NDArray[np.str_]:
        """Kind of a hit."""
        return words(self.array['kind'], 'gusset_hit_kind')


class SurfaceHitsView(Record):
    """Lent hits."""

    __slots__ = ()
    _NAME = 'gusset_surface_hits_view'
    _GETTER = 'gusset_surface_hits_get_view'

    @property
    def query_count(self) -> int:
        """Lines, and the curve if given."""
        return self._struct.query_count

    @property
    def ends(self) -> NDArray[np.uint64]:
        """Offsets into hits, by query."""
        return self._array('ends', self._struct.query_count + 1)

    @property
    def hits(self) -> SurfaceHitArray:
        """The hits, by rising t in each query."""
        return SurfaceHitArray(self._array('hits', self._struct.hit_count))

    @property
    def on_curve(self) -> PlaceArray:
        """Curve: for each hit, places of hit, start and end of span."""
        return PlaceArray(self._array('on_curve', self._struct.on_curve_count // 3, 3))

    @property
    def on_curve_count(self) -> int:
        """Number of places on the curve."""
        return self._struct.on_curve_count


class NearestAngleReport(Record):
    """The normal nearest to a given angle."""

    __slots__ = ()
    _NAME = 'gusset_nearest_angle_report'

    @property
    def place(self) -> SurfacePlace:
        """Place of the normal."""
        return SurfacePlace(self._struct.place, self._owner)

    @property
    def point(self) -> NDArray[np.float64]:
        """Point at the place."""
        return self._array('point')

    @property
    def normal(self) -> NDArray[np.float64]:
        """The unit normal."""
        return self._array('normal')

    @property
    def angle(self) -> float:
        """Angle between normal and direction."""
        return self._struct.angle

    @property
    def deviation(self) -> float:
        """Difference from the given angle; infinite, all else 0, if the surface lacks normals."""
        return self._struct.deviation

    @property
    def bound(self) -> float:
        """Lower bound of all deviations, within 1e-9 of it unless the proof fails."""
        return self._struct.bound


class DistanceReport(Record):
    """Nearest points of a surface and a target."""

    __slots__ = ()
    _NAME = 'gusset_distance_report'

    @property
    def place(self) -> SurfacePlace:
        """Place of the surface's point."""
        return SurfacePlace(self._struct.place, self._owner)

    @property
    def point(self) -> NDArray[np.float64]:
        """The surface's point."""
        return self._array('point')

    @property
    def normal(self) -> NDArray[np.float64]:
        """Unit normal; at a pole its limit; 0 if undefined."""
        return self._array('normal')

    @property
    def other_point(self) -> NDArray[np.float64]:
        """The target's point."""
        return self._array('other_point')

    @property
    def distance(self) -> float:
        """Their distance."""
        return self._struct.distance

    @property
    def bound(self) -> float:
        """Proved lower bound of the distance."""
        return self._struct.bound

    @property
    def other_place(self) -> SurfacePlace:
        """SURFACE: its place; else 0."""
        return SurfacePlace(self._struct.other_place, self._owner)

    @property
    def curve_place(self) -> Place:
        """CURVE: its place; else 0."""
        return Place(self._struct.curve_place, self._owner)

    @property
    def parameter(self) -> float:
        """LINE: its parameter. PLANE: signed distance, negative opposite to the normal. Else 0."""
        return self._struct.parameter

    @property
    def flags(self) -> frozenset[choices.DistanceFlags]:
        """Properties of a distance."""
        return flags(self._struct.flags, 'gusset_distance_flags')


class SurfaceReport(Record):
    """Facts about a surface."""

    __slots__ = ()
    _NAME = 'gusset_surface_report'
    _GETTER = 'gusset_surface_get_report'

    @property
    def cell_count(self) -> int:
        """Cells of all sheets."""
        return self._struct.cell_count

    @property
    def node_count(self) -> int:
        """Corners of cells; nodes of sheets from nodes."""
        return self._struct.node_count

    @property
    def index_bytes(self) -> int:
        """Bytes of the index, without nodes and cones."""
        return self._struct.index_bytes

    @property
    def tolerance(self) -> float:
        """Guaranteed accuracy, as in gusset_surface_options."""
        return self._struct.tolerance

    @property
    def low(self) -> NDArray[np.float64]:
        """Low corner of a box round surface and controls."""
        return self._array('low')

    @property
    def high(self) -> NDArray[np.float64]:
        """High corner."""
        return self._array('high')

    @property
    def cone_bytes(self) -> int:
        """Bytes of the cones of normals; 0 if not built."""
        return self._struct.cone_bytes

    @property
    def sheets(self) -> SurfaceSheetArray:
        """The sheets."""
        return SurfaceSheetArray(self._array('sheets', self._struct.sheet_count))


class SheetReport(Record):
    """Facts about a sheet."""

    __slots__ = ()
    _NAME = 'gusset_sheet_report'
    _GETTER = 'gusset_sheet_get_report'

    @property
    def rows(self) -> int:
        """Cells in u, which runs from 0 to rows."""
        return self._struct.rows

    @property
    def columns(self) -> int:
        """Cells in v, likewise."""
        return self._struct.columns

    @property
    def degree(self) -> int:
        """Degree of patches: 3 or 7."""
        return self._struct.degree

    @property
    def is_grid(self) -> bool:
        """1: stores nodes; 0: patches."""
        return bool(self._struct.is_grid)

    @property
    def closed_u(self) -> bool:
        """1: closed in u."""
        return bool(self._struct.closed_u)

    @property
    def closed_v(self) -> bool:
        """1: closed in v."""
        return bool(self._struct.closed_v)

    @property
    def pole_u0(self) -> bool:
        """1: u = 0 is a pole, one point."""
        return bool(self._struct.pole_u0)

    @property
    def pole_u1(self) -> bool:
        """1: u = rows is a pole."""
        return bool(self._struct.pole_u1)

    @property
    def pole_v0(self) -> bool:
        """1: v = 0 is a pole."""
        return bool(self._struct.pole_v0)

    @property
    def pole_v1(self) -> bool:
        """1: v = columns is a pole."""
        return bool(self._struct.pole_v1)

    @property
    def deviation(self) -> float:
        """Bound of the distance from a rational spline at equal parameters, with rounding; else 0."""
        return self._struct.deviation

    @property
    def knots_u(self) -> NDArray[np.float64]:
        """Spline: its rows + 1 rising parameters at u = 0, 1, ..., linear between."""
        return self._array('knots_u', self._struct.rows + 1)

    @property
    def knots_v(self) -> NDArray[np.float64]:
        """Spline: its columns + 1 parameters, likewise."""
        return self._array('knots_v', self._struct.columns + 1)


class SheetMeasures(Record):
    """Measures of a sheet (see gusset_cell_arrays); 0 unless requested."""

    __slots__ = ()
    _NAME = 'gusset_sheet_measures'

    @property
    def diameter(self) -> float:
        """Greatest of `diameters`."""
        return self._struct.diameter

    @property
    def intrinsic_diameter(self) -> float:
        """Greatest of `intrinsic_diameters`."""
        return self._struct.intrinsic_diameter

    @property
    def curvature_bound(self) -> float:
        """Bound of absolute principal curvatures; infinite if not regular, as at poles."""
        return self._struct.curvature_bound

    @property
    def crease(self) -> float:
        """Largest angle between normals across cell sides; if smooth, 0 or rounding."""
        return self._struct.crease


class SheetMeshReport(Record):
    """Places and normals of a sheet's mesh."""

    __slots__ = ()
    _NAME = 'gusset_sheet_mesh_report'
    _GETTER = 'gusset_result_get_sheet_mesh'

    @property
    def places(self) -> SurfacePlaceArray:
        """Place of each vertex, with sheet 0."""
        return SurfacePlaceArray(self._array('places', self._struct.vertex_count))

    @property
    def normals(self) -> NDArray[np.float64]:
        """Unit normal of each vertex; 0 if undefined."""
        return self._array('normals', self._struct.vertex_count, 3)

    @property
    def deviation(self) -> float:
        """Bound of the distance between surface and triangles, for either diagonal of quads."""
        return self._struct.deviation


class SurfaceCell(Record):
    """A cell of a surface."""

    __slots__ = ()
    _NAME = 'gusset_surface_cell'

    @property
    def sheet(self) -> int:
        """Index of the sheet."""
        return self._struct.sheet

    @property
    def row(self) -> int:
        """Its row."""
        return self._struct.row

    @property
    def column(self) -> int:
        """Its column."""
        return self._struct.column


class SurfaceCellArray(RecordArray[SurfaceCell]):
    """A cell of a surface."""

    __slots__ = ()
    RECORD = SurfaceCell

    @property
    def sheet(self) -> NDArray[np.uint32]:
        """Index of the sheet."""
        return self.array['sheet']

    @property
    def row(self) -> NDArray[np.uint32]:
        """Its row."""
        return self.array['row']

    @property
    def column(self) -> NDArray[np.uint32]:
        """Its column."""
        return self.array['column']


class SurfaceCellsView(Record):
    """Lent cells. Regions lack `others`; pairs lack the fields below it."""

    __slots__ = ()
    _NAME = 'gusset_surface_cells_view'
    _GETTER = 'gusset_surface_cells_get_view'

    @property
    def cells(self) -> SurfaceCellArray:
        """Cells by sheet, row, column. Pairs: cells of the first surface by both sheets, row, column."""
        return SurfaceCellArray(self._array('cells', self._struct.cell_count))

    @property
    def others(self) -> SurfaceCellArray:
        """Cells of the second surface."""
        return SurfaceCellArray(self._array('others', self._struct.cell_count))

    @property
    def whole(self) -> NDArray[np.bool_]:
        """By cell: 1 if all of it is within the radius."""
        return self._array('whole', self._struct.cell_count) != 0

    @property
    def mask(self) -> NDArray[np.uint64]:
        """A bit a cell, 1 in the region. Cell (i, j) of sheet k with c columns has bit b = first[k] + i * c + j:
        mask[b / 64] >> (b % 64) & 1.
        """
        return self._array('mask', self._struct.word_count)

    @property
    def first(self) -> NDArray[np.uint64]:
        """First bit of each sheet, then the number of bits."""
        return self._array('first', self._struct.sheet_count + 1)

    @property
    def sheet_count(self) -> int:
        """Number of sheets."""
        return self._struct.sheet_count


class Transform(Record):
    """Affine map of points."""

    __slots__ = ()
    _NAME = 'gusset_transform'

    @property
    def rows(self) -> NDArray[np.float64]:
        """x' = rows[0] x + rows[1] y + rows[2] z + rows[3]; then y', then z'."""
        return self._array('rows', 3, 4)


class TransformArray(RecordArray[Transform]):
    """Affine map of points."""

    __slots__ = ()
    RECORD = Transform

    @property
    def rows(self) -> NDArray[np.float64]:
        """x' = rows[0] x + rows[1] y + rows[2] z + rows[3]; then y', then z'."""
        return self.array['rows'].reshape(*self.array.shape, 3, 4)
