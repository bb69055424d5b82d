"""Keywords of structs of options, with what the C headers say of them. Written by generate.py; do not edit."""

# fmt: off
from __future__ import annotations

import sys
from collections.abc import Collection, Sequence
from typing import Literal, NamedTuple, Optional, Union

from numpy.typing import ArrayLike

from . import choices

if sys.version_info >= (3, 12):
    from typing import TypedDict, Unpack
else:
    from typing_extensions import TypedDict, Unpack

__all__ = ["FIELDS", "Keyword", "Unpack"]


class Keyword(NamedTuple):
    """How a keyword becomes a field."""

    kind: str
    #: The numbers of its words.
    words: dict[str, int] = {}
    #: The field and the word or number that it is read for.
    needs: Optional[tuple[str, str]] = None
    #: The sizes of an array: see `@shape` in the headers.
    shape: tuple[str, ...] = ()


class OutlineOptions(TypedDict, total=False):
    """Fields of ``gusset_outline_options``; what is not given is as by default."""

    #: Kind of an outline's curve.
    curve: choices.CurveKind
    #: Guide of a section's control point.
    method: choices.SectionMethod
    #: For composite and single curves.
    lock: choices.ParameterLock
    #: For composite curves and chains.
    joint: choices.JointParameter
    #: Method of solution.
    solver: choices.OutlineSolver
    #: For open outlines and parts between corners, without constraints.
    ends: choices.OutlineEnds
    #: 0 to 1.
    alpha: float
    #: Composite parameters are clamped to this and 1 - this: at least 0.001, below 1/2; 0: 0.01, or 1/12 with
    #: GUSSET_JOINT_PARAMETER_G2.
    parameter_limit: float
    #: Largest distance of merged neighbours, below 1; 0: 1e-12. 1e-300 merges equal points only.
    repeat_tolerance: float
    #: Points where the polygon turns by more are corners; at least 0; 0, or pi and more: none.
    corner_angle: float
    #: Iterations end when moves are within it; below 1; 0: 1e-12.
    tolerance: float
    #: Most sweeps or iterations between corners; 0: 200. If they do not converge, their replacement iterates further.
    max_sweeps: int
    #: Most steps at a point in a sweep; 0: 20,000.
    max_steps: int
    #: 1: keeps the cycles for gusset_outline_get_history.
    history: bool


class OffsetOptions(TypedDict, total=False):
    """Fields of ``gusset_offset_options``; what is not given is as by default."""

    #: Wanted deviation, above 0.
    tolerance: float
    #: Halving stops at this many segments; 0: 65536.
    max_segments: int
    #: Degree of segments, 2 or 3; 0: 3.
    degree: int


class StitchOptions(TypedDict, total=False):
    """Fields of ``gusset_stitch_options``; what is not given is as by default."""

    #: Rule for the meridians.
    meridians: choices.Meridians
    #: Treatment of opposite orientations.
    orientation: choices.Orientation
    #: Vertices to shift the first meridian along rim B, in the direction of rim A, modulo rim B. The shift begins at
    #: the closest pair that no edge joins. If not 0, no other start is tried. 0 for arcs (OUT_OF_RANGE).
    twist: int
    #: Part of the loops to join.
    extent: choices.StitchExtent
    #: Choice among runs of facing vertices.
    run: choices.FacingRun
    #: Number of interior rows.
    rows: choices.RowRule
    #: Interior rows.
    row_count: int
    #: Faces of the strip.
    cells: choices.StripCells
    #: Source of the tolerance.
    tolerance_mode: choices.ToleranceMode
    #: Facing vertices are farther than this from their loop's plane.
    tolerance: float
    #: First index on loop A as given, and number of vertices, 1 to the loop's length; may pass its end.
    arc_a: Sequence[int]
    #: As arc_a, for loop B.
    arc_b: Sequence[int]
    #: Search effort.
    search: choices.StripSearch
    #: First meridian of a closed strip; open ones start at their first points.
    start: choices.StripStart
    #: Positions of new vertices; ignored without rows.
    fairing: choices.Fairing
    #: Treatment of intersecting faces.
    intersections: choices.Intersections
    #: Centre of a loop.
    centres: choices.Centres
    #: Side that closed components face.
    outward: choices.Outward
    #: Surface between the rims, or in a hole.
    finish: choices.Finish


class FillOptions(TypedDict, total=False):
    """Fields of ``gusset_fill_options``; what is not given is as by default."""

    #: Weight that the triangulation of a hole minimises.
    weight: choices.FillWeight
    #: New vertices of patches.
    refine: choices.FillRefinement
    #: Positions of new vertices; ignored without them.
    fairing: choices.Fairing
    #: Loops that are not holes, if all loops are selected.
    keep: choices.FillKeep
    #: Patch faces that intersect each other or old faces: AUTO avoids, REPORT reports, IGNORE ignores them.
    intersections: choices.Intersections
    #: 1: only reports which loops would be filled, by which weight and finish, without predicting failed
    #: triangulations and shared patches.
    plan_only: bool
    #: Approximate limit on a patch's new vertices, kept by larger triangles, within a factor of 2. 0: 50,000, or 4 a
    #: rim vertex if more; twice that for sharp angles.
    max_new_vertices: int
    #: Most edges of a loop to fill; 0: any.
    max_edges: int
    #: Largest length of a loop to fill, at least 0; 0: any.
    max_length: float
    #: As max_length, for diameter of gusset_hole.
    max_diameter: float
    #: As max_length, for area of gusset_hole.
    max_area: float
    #: Side that closed components face.
    outward: choices.Outward
    #: Loops that share a patch.
    together: choices.FillTogether
    #: Group of each given loop; the group's loops share a patch of genus 0, except loops left open for their own
    #: reasons. NULL: together decides.
    groups: ArrayLike
    #: Smoothness between faired patches and the old surface.
    continuity: choices.FillContinuity
    #: 1: creases of the old surface end at the rim.
    ignore_creases: bool
    #: Surface between the rims, or in a hole.
    finish: choices.Finish


class StripOptions(TypedDict, total=False):
    """Fields of ``gusset_strip_options``; what is not given is as by default."""

    #: Rule for the meridians.
    meridians: choices.Meridians
    #: Search effort.
    search: choices.StripSearch
    #: First meridian of a closed strip; open ones start at their first points.
    start: choices.StripStart
    #: 1 if the polylines are closed.
    closed: bool
    #: Number of interior rows.
    rows: choices.RowRule
    #: Interior rows.
    row_count: int
    #: Faces of the strip.
    cells: choices.StripCells


class WeldOptions(TypedDict, total=False):
    """Fields of ``gusset_weld_options``; what is not given is as by default."""

    #: Vertices that are welded.
    vertices: choices.WeldVertices
    #: Distance at which vertices coincide. - GUSSET_TOLERANCE_EXACT: 0; -0 equals 0. - GUSSET_TOLERANCE_AUTO: at most
    #: 2^-19 (32-bit) or 2^-48 (64-bit) of the largest coordinate, or, if more, twice the last decimal place that
    #: positions show. At each vertex at most a quarter of the shortest edge; GUSSET_COLLAPSE_ALLOW skips edges within
    #: the first limit. - Last decimal place: let D be the largest power of ten up to the longest side of the
    #: vertices' box. The place is the largest of 1e-5 D, 1e-6 D, ... that divides a third of at least eight numbers.
    #: They are coordinates of the largest order of magnitude, or differences of consecutive vertices, except
    #: multiples of 1e-4 D.
    tolerance_mode: choices.ToleranceMode
    #: Largest distance of coincident vertices.
    tolerance: float
    #: Treatment of coincident corners of one face.
    collapse: choices.Collapse
    #: Treatment of vertices that no face uses.
    unused: choices.Unused


class OrientOptions(TypedDict, total=False):
    """Fields of ``gusset_orient_options``; what is not given is as by default."""

    #: Side that closed components face.
    outward: choices.Outward


class AlignmentOptions(TypedDict, total=False):
    """Fields of ``gusset_alignment_options``; what is not given is as by default."""

    #: Initial poses.
    start: choices.AlignmentStart
    #: Points of a piece to match; 0: 2,000.
    samples: int
    #: Rigid motions of the pieces, or NULL.
    poses: ArrayLike
    #: Largest distance of matched points, and about how far a piece may move. 0: a tenth of the largest piece's box
    #: diagonal.
    max_distance: float
    #: Most rounds in each of two stages; 0: 100.
    max_rounds: int


class TrimOptions(TypedDict, total=False):
    """Fields of ``gusset_trim_options``; what is not given is as by default."""

    #: Largest distance of surfaces that count as one. 0: 4 mean edges of the coarser piece.
    max_distance: float
    #: Largest angle between their normals, at least 0, below pi / 2; 0: 60 degrees.
    max_angle: float
    #: A point for each piece, or NULL. Parts seen at flat angles weigh less.
    viewpoints: ArrayLike
    #: Islands of fewer faces are removed; 0: 30. The limit is 20 times that for islands that other pieces also show.
    #: Smaller holes are not made.
    min_faces: int


class BoundaryOptions(TypedDict, total=False):
    """Fields of ``gusset_boundary_options``; what is not given is as by default."""

    #: Treatment of non-manifold edges.
    non_manifold: choices.NonManifold
    #: Part of the mesh that is checked.
    survey: choices.Survey


class DevelopOptions(TypedDict, total=False):
    """Fields of ``gusset_develop_options``; what is not given is as by default."""

    #: Distortion that a development minimises.
    distortion: choices.Distortion
    #: Most darts: cuts from a chart's border to where it is curved.
    max_darts: int
    #: Vertices of paths to cut along, path after path, connected by shortest edge paths. A path of one vertex cuts
    #: nothing.
    cuts: ArrayLike
    #: Start of each path in cuts, and the end of the last. Empty: one path.
    cut_offsets: ArrayLike
    #: Darts stop once no length changes by a larger factor; above 1, finite; 0: none.
    max_stretch: float
    #: Most steps of a descent; 0: 200. Charts whose border would meet itself, and GUSSET_DISTORTION_RIGID, need
    #: several descents.
    max_iterations: int


class FacingOptions(TypedDict, total=False):
    """Fields of ``gusset_facing_options``; what is not given is as by default."""

    #: Choice among runs of facing vertices.
    run: choices.FacingRun
    #: Source of the tolerance.
    tolerance_mode: choices.ToleranceMode
    #: As in gusset_stitch_options.
    tolerance: float
    #: Centre of a loop.
    centres: choices.Centres


class MeshSectionOptions(TypedDict, total=False):
    """Fields of ``gusset_mesh_section_options``; what is not given is as by default."""

    #: Leaves out points up to this far from the polyline; 0: keeps all points. Polylines with points left out may
    #: cross each other or themselves.
    tolerance: float
    #: Side of vertices in a plane.
    in_plane: choices.InPlane


class GlueOptions(TypedDict, total=False):
    """Fields of ``gusset_glue_options``; what is not given is as by default."""

    #: For detect: largest distance of coincident nodes.
    tolerance: float
    #: Gluings to add.
    gluings: ArrayLike
    #: Links to contract, as in gusset_net_analysis_view.
    links: ArrayLike
    #: 1: replaces the gluing by the one that coordinates imply: coincident neighbours, and coincident runs of two or
    #: more side nodes in either direction. The orientation stays.
    detect: bool
    #: 1: contracts links with ends in one point, and drops redundant seams; detect implies it. Nets that glue equal
    #: neighbours then have equal matrices.
    saturate: bool
    #: 1: moves a point's nodes to its first, bit for bit.
    snap: bool


class NetPrimitive(TypedDict, total=False):
    """Fields of ``gusset_net_primitive``; what is not given is as by default."""

    #: Standard shape, its measures, the least rows x columns.
    shape: choices.NetShape
    #: Type of coordinates.
    scalar: choices.Scalar
    #: 0: 33. Not for boxes and lathes.
    rows: int
    #: 0: 65. Not for boxes.
    columns: int
    #: Above 0.
    radius: float
    #: Above 0.
    minor_radius: float
    #: Height along z, above 0.
    height: float
    #: Sizes along x, y and z, above 0.
    size: Sequence[float]
    #: Distance from the axis (at least 0) and height of each point, upwards. Points on the axis are poles; closed
    #: profiles make rings.
    profile: ArrayLike
    #: Lateral faces of prisms and pyramids, at least 3.
    sides: int
    #: Layout of the caps of a box.
    box_kind: choices.BoxKind
    #: Cells of boxes along x, y and z, at least 1.
    cells: Sequence[int]


class NetMeshOptions(TypedDict, total=False):
    """Fields of ``gusset_net_mesh_options``; what is not given is as by default."""

    #: Faces of a net's mesh.
    faces: choices.NetFaces
    #: 1: a vertex for each node; 0: glued nodes are one.
    no_weld: bool
    #: 1: keeps finite vertices without faces and wires.
    keep_unused: bool
    #: 1: a cell with exactly one missing corner becomes a triangle.
    fill_corners: bool
    #: 1: computes texture coordinates.
    texture: bool
    #: Omits faces with edges above this multiple of the median edge; 0: no limit. 4 removes depth jumps from range
    #: images.
    max_edge_ratio: float


class NetGridOptions(TypedDict, total=False):
    """Fields of ``gusset_net_grid_options``; what is not given is as by default."""

    #: Faces of a cell of the given grid.
    cells: choices.GridCells
    #: 1: only the component of face must be a grid; 0: all.
    has_face: bool
    #: Face of the component.
    face: int


class NetCopyOptions(TypedDict, total=False):
    """Fields of ``gusset_net_copy_options``; what is not given is as by default."""

    #: First row of the part.
    row_first: int
    #: Rows of the part, at least 2; 0: the rest.
    row_count: int
    #: First column of the part.
    column_first: int
    #: Columns of the part, at least 2; 0: the rest.
    column_count: int
    #: Rows after replication, at least the present; 0: none. Links between copies are contracted.
    rows: int
    #: Columns after replication, likewise.
    columns: int
    #: 1: removes rows and columns that repeat the previous: equal coordinates and links, contracted links between.
    #: Two of each and ends of bridges stay.
    compact: bool
    #: For rows.
    row_replication: choices.Replication
    #: For columns.
    column_replication: choices.Replication
    #: Row to replicate.
    row_index: int
    #: Column to replicate.
    column_index: int
    #: Symmetry.
    turn: choices.NetTurn
    #: 0: unchanged. Conversion to float rounds; overflowing nodes become missing.
    scalar: choices.Scalar


class ConcatenateOptions(TypedDict, total=False):
    """Fields of ``gusset_concatenate_options``; what is not given is as by default."""

    #: For welding: largest distance of coincident nodes.
    tolerance: float
    #: Direction from each net to the next.
    direction: choices.Direction
    #: Treatment of the cells of a bridge.
    mode: choices.BridgeMode
    #: For nets with fewer nodes along the side.
    equalise: choices.Replication
    #: Row or column to replicate.
    equalise_index: int
    #: Rotation of each later net along its closed side, in nodes.
    twist: int
    #: 1: flips nets along the side if oriented unlike the first; 0: refuses them.
    turn: bool
    #: Inner rows or columns of new bridges, even on lines; 0 for GUSSET_BRIDGE_WELD.
    rows: int


class NetAnalysisOptions(TypedDict, total=False):
    """Fields of ``gusset_net_analysis_options``; what is not given is as by default."""

    #: As for gusset_net_deform.
    fields: ArrayLike
    #: As for gusset_net_deform.
    time: float
    #: Lengths up to it count as 0.
    tolerance: float


class PlanariseOptions(TypedDict, total=False):
    """Fields of ``gusset_planarise_options``; what is not given is as by default."""

    #: Distance of corners from their mean plane, relative to the box diagonal; 0: 1e-10, float: 4e-7.
    tolerance: float
    #: For each node, 1: it stays with all nodes glued to it. NULL: all may move.
    fixed: ArrayLike
    #: Most steps; 0: 100.
    max_iterations: int
    #: 1: boundary vertices of the surface stay.
    keep_boundary: bool


class SettleOptions(TypedDict, total=False):
    """Fields of ``gusset_settle_options``; what is not given is as by default."""

    #: Largest displacement in the last step, relative to the box diagonal; 0: 1e-12.
    tolerance: float
    #: Ratio of rest lengths to lengths in the reference, above 0; 0: 1.
    rest_ratio: float
    #: For each part between bridges: 1 moves it as a rigid body, 0 holds it. NULL holds all.
    free: ArrayLike
    #: Most steps; 0: 1000.
    max_iterations: int


class WingedOptions(TypedDict, total=False):
    """Fields of ``gusset_winged_options``; what is not given is as by default."""

    #: Orientation of faces in a mesh.
    winding: choices.Winding


class StreamOptions(TypedDict, total=False):
    """Fields of ``gusset_stream_options``; what is not given is as by default."""

    #: Rows of each independent block; 0: about 2^17 nodes, or all for RAW.
    rows_per_block: int
    #: Storage of coordinates in a stream.
    mode: choices.StreamMode
    #: QUANTISED: bits of a coordinate, 8 to 24; 0: 14. Else 0.
    bits: int
    #: QUANTISED. 1: each axis has its own step; 0: the longest extent's. Else 0.
    per_axis: bool
    #: QUANTISED: choice of the levels. Else 0.
    levels: choices.StreamLevels
    #: Smallest coordinates of all tiles: level 0.
    low: Sequence[float]
    #: Largest coordinates of all tiles, at least low.
    high: Sequence[float]
    #: Distance of levels on all axes, above 0; bits must be 0 and becomes the least number that spans the box. 0:
    #: follows from bits.
    step: float


class SurfaceOptions(TypedDict, total=False):
    """Fields of ``gusset_surface_options``; what is not given is as by default."""

    #: Guaranteed accuracy of distances and positions. 0: 1e-9 of the surface's box diagonal.
    tolerance: float
    #: 1: builds cones of normals for GUSSET_CONTOUR_ANGLE and gusset_surface_nearest_angle; 0: the first such query
    #: does.
    cones: bool


class NearestOptions(TypedDict, total=False):
    """Fields of ``gusset_nearest_options``; what is not given is as by default."""

    #: Largest distance; 0 or INFINITY: no limit.
    limit: float
    #: Minima: most, nearest first; 0: all.
    max_count: int


class ContourOptions(TypedDict, total=False):
    """Fields of ``gusset_contour_options``; what is not given is as by default."""

    #: Above 0; at least the surface's tolerance applies.
    chord: float
    #: Curve points between crossings with cell sides.
    spacing: choices.SpacingRule
    #: Points between two crossings, at most 1000.
    points: int


class IntersectionOptions(TypedDict, total=False):
    """Fields of ``gusset_intersection_options``; what is not given is as by default."""

    #: Largest distance of the curve from its chords, above 0; rare chords exceed it by about 15 %. At least the
    #: smallest of `tolerance` and the surfaces' applies.
    chord: float
    #: Surfaces touch where their gap or overlap stays within it; 0: the surfaces' smaller tolerance.
    #: Self-intersections use at most the surface's. Branches shorter than all three may be lost.
    tolerance: float
    #: Not GUSSET_POINT_SPACING_LEUS; GUSSET_POINT_SPACING_AUTO refers to the smaller surface.
    spacing: choices.SpacingRule


class SheetMeshOptions(TypedDict, total=False):
    """Fields of ``gusset_sheet_mesh_options``; what is not given is as by default."""

    #: Largest distance of triangles from the surface, above 0; 0 or INFINITY: unlimited.
    tolerance: float
    #: Least parts of a cell in u; 0: 1.
    min_u: int
    #: Least parts of a cell in v; 0: 1.
    min_v: int
    #: 1: triangles only; 0: quads, with triangles at poles.
    triangles: bool


class FrameOptions(TypedDict, total=False):
    """Fields of ``gusset_frame_options``; what is not given is as by default."""

    #: Correspondence of points between sections.
    correspondence: choices.CorrespondenceRule
    #: ANGLE: nodes in each section. ARC_LENGTH: likewise, more if sections have more corners. LANDMARKS: parts
    #: between two landmarks.
    columns: int
    #: 1: the first section follows the last.
    ring: bool
    #: ARC_LENGTH. 1: closed sections start at their first points, or the corner after the first section's.
    given_starts: bool
    #: 1: only constraints make corners. 0: sections also have corners where they turn by more than `corner_angle` of
    #: `across`. If this is pi (not with ANGLE), corners are all points of polygons, and points that turn by 40
    #: degrees and far more than usual. Polygons are closed sections of at most 6 points, and sections that turn by
    #: more than 54 or less than 6 degrees at points.
    smooth_corners: bool
    #: ANGLE: a point of the axis.
    axis_point: Sequence[float]
    #: ANGLE: direction of the axis; angles are right-handed about it.
    axis_direction: Sequence[float]
    #: ANGLE: direction of column 0, not parallel to the axis (at its first point if bent).
    reference: Sequence[float]
    #: ANGLE: a point of a bent axis for each section, in place of axis_point and axis_direction. The axis follows
    #: circles through three points each; the reference does not rotate about it. NULL: straight.
    axis_points: ArrayLike
    #: LANDMARKS: for each section the same number of indices of its points, in order.
    landmarks: ArrayLike
    #: Options of the curves across.
    across: OutlineOptions
    #: Options of the curves along.
    along: OutlineOptions
    #: GIVEN: indices of missing points over all sections, in any order; their coordinates are not read. A Catmull-Rom
    #: curve through up to two nodes before and after in the column fills each, with centripetal parameters from
    #: adjacent columns.
    missing: ArrayLike


class JoinOptions(TypedDict, total=False):
    """Fields of ``gusset_join_options``; what is not given is as by default."""

    #: Treatment of coincident borders.
    weld: choices.Welding
    #: GUSSET_ORIENTATION_FIX reverses the minority of faces in each component, then components against those that
    #: they face. GUSSET_ORIENTATION_KEEP ignores outward and reverses nothing.
    orientation: Literal['fix', 'keep']
    #: Widest gap to close.
    gap: choices.Gap
    #: Parts of loops that are joined.
    extent: choices.JoinExtent
    #: 1 also joins loops of one component that pairs does not name.
    within_components: bool
    #: 1 fills the remaining holes.
    fill: bool
    #: Widest gap to close; 0 closes none.
    max_gap: float
    #: Pairs of whole loops to join at any distance, or NULL: two loops, or a slit twice (see gusset_joint). No loop
    #: is in two pairs.
    pairs: ArrayLike
    #: Pairs not to join, or NULL; pairs takes precedence. Vertices on no loop after welding exclude nothing.
    excluded: ArrayLike
    #: Options of welding.
    weld_options: WeldOptions
    #: Uses meridians, search, start, rows, row_count, cells, fairing, intersections and finish; all options must be
    #: valid.
    strip_options: StitchOptions
    #: Ignores groups, and outward and plan_only, which must be valid. With GUSSET_OVERLAPS_TRIM, GUSSET_KEEP_AUTO
    #: acts as GUSSET_KEEP_BORDERS.
    fill_options: FillOptions
    #: Open components mostly keep the first piece's orientation.
    outward: choices.Outward
    #: Treatment of overlapping pieces.
    overlaps: choices.Overlaps
    #: Options of trimming.
    trim_options: TrimOptions


class RepairOptions(TypedDict, total=False):
    """Fields of ``gusset_repair_options``; what is not given is as by default."""

    #: Source of the tolerance.
    tolerance_mode: choices.ToleranceMode
    #: 1: borders are not sewn.
    leave_borders: bool
    #: Largest distance of coincident borders.
    tolerance: float
    #: 1: faces without area stay.
    leave_flat_faces: bool
    #: 1: duplicate faces stay.
    leave_duplicates: bool
    #: 1: non-manifold edges and vertices stay, and faces within the solid.
    leave_non_manifold: bool
    #: 1: holes stay open.
    leave_holes: bool
    #: 1: open sheets that were attached to closed components stay.
    leave_fins: bool
    #: 1: no component is oriented.
    leave_orientation: bool
    #: 1: intersecting faces stay.
    leave_intersections: bool
    #: Ignores groups, and outward and plan_only, which must be valid.
    fill_options: FillOptions


#: By struct.
FIELDS: dict[str, dict[str, Keyword]] = {
    "gusset_outline_options": {
        "curve": Keyword('choice', choices.NUMBERS['gusset_curve_kind']),
        "method": Keyword('choice', choices.NUMBERS['gusset_section_method']),
        "lock": Keyword('choice', choices.NUMBERS['gusset_parameter_lock']),
        "joint": Keyword('choice', choices.NUMBERS['gusset_joint_parameter']),
        "solver": Keyword('choice', choices.NUMBERS['gusset_outline_solver']),
        "ends": Keyword('choice', choices.NUMBERS['gusset_outline_ends']),
        "alpha": Keyword('float', needs=('method', 'alpha')),
        "parameter_limit": Keyword('float'),
        "repeat_tolerance": Keyword('float'),
        "corner_angle": Keyword('float'),
        "tolerance": Keyword('float'),
        "max_sweeps": Keyword('int'),
        "max_steps": Keyword('int'),
        "history": Keyword('flag'),
    },
    "gusset_offset_options": {
        "tolerance": Keyword('float'),
        "max_segments": Keyword('int'),
        "degree": Keyword('int'),
    },
    "gusset_stitch_options": {
        "meridians": Keyword('choice', choices.NUMBERS['gusset_meridians']),
        "orientation": Keyword('choice', choices.NUMBERS['gusset_orientation']),
        "twist": Keyword('int'),
        "extent": Keyword('choice', choices.NUMBERS['gusset_stitch_extent']),
        "run": Keyword('choice', choices.NUMBERS['gusset_facing_run']),
        "rows": Keyword('choice', choices.NUMBERS['gusset_row_rule']),
        "row_count": Keyword('int', needs=('rows', 'count')),
        "cells": Keyword('choice', choices.NUMBERS['gusset_strip_cells']),
        "tolerance_mode": Keyword('choice', choices.NUMBERS['gusset_tolerance_mode']),
        "tolerance": Keyword('float', needs=('tolerance_mode', 'given')),
        "arc_a": Keyword('row', needs=('extent', 'arcs')),
        "arc_b": Keyword('row', needs=('extent', 'arcs')),
        "search": Keyword('choice', choices.NUMBERS['gusset_strip_search']),
        "start": Keyword('choice', choices.NUMBERS['gusset_strip_start']),
        "fairing": Keyword('choice', choices.NUMBERS['gusset_fairing']),
        "intersections": Keyword('choice', choices.NUMBERS['gusset_intersections']),
        "centres": Keyword('choice', choices.NUMBERS['gusset_centres']),
        "outward": Keyword('choice', choices.NUMBERS['gusset_outward']),
        "finish": Keyword('choice', choices.NUMBERS['gusset_finish']),
    },
    "gusset_fill_options": {
        "weight": Keyword('choice', choices.NUMBERS['gusset_fill_weight']),
        "refine": Keyword('choice', choices.NUMBERS['gusset_fill_refinement']),
        "fairing": Keyword('choice', choices.NUMBERS['gusset_fairing']),
        "keep": Keyword('choice', choices.NUMBERS['gusset_fill_keep']),
        "intersections": Keyword('choice', choices.NUMBERS['gusset_intersections']),
        "plan_only": Keyword('flag'),
        "max_new_vertices": Keyword('int'),
        "max_edges": Keyword('int'),
        "max_length": Keyword('float'),
        "max_diameter": Keyword('float'),
        "max_area": Keyword('float'),
        "outward": Keyword('choice', choices.NUMBERS['gusset_outward']),
        "together": Keyword('choice', choices.NUMBERS['gusset_fill_together']),
        "groups": Keyword('array', shape=('loop_count',)),
        "continuity": Keyword('choice', choices.NUMBERS['gusset_fill_continuity']),
        "ignore_creases": Keyword('flag'),
        "finish": Keyword('choice', choices.NUMBERS['gusset_finish']),
    },
    "gusset_strip_options": {
        "meridians": Keyword('choice', choices.NUMBERS['gusset_meridians']),
        "search": Keyword('choice', choices.NUMBERS['gusset_strip_search']),
        "start": Keyword('choice', choices.NUMBERS['gusset_strip_start']),
        "closed": Keyword('flag'),
        "rows": Keyword('choice', choices.NUMBERS['gusset_row_rule']),
        "row_count": Keyword('int', needs=('rows', 'count')),
        "cells": Keyword('choice', choices.NUMBERS['gusset_strip_cells']),
    },
    "gusset_weld_options": {
        "vertices": Keyword('choice', choices.NUMBERS['gusset_weld_vertices']),
        "tolerance_mode": Keyword('choice', choices.NUMBERS['gusset_tolerance_mode']),
        "tolerance": Keyword('float', needs=('tolerance_mode', 'given')),
        "collapse": Keyword('choice', choices.NUMBERS['gusset_collapse']),
        "unused": Keyword('choice', choices.NUMBERS['gusset_unused']),
    },
    "gusset_orient_options": {
        "outward": Keyword('choice', choices.NUMBERS['gusset_outward']),
    },
    "gusset_alignment_options": {
        "start": Keyword('choice', choices.NUMBERS['gusset_alignment_start']),
        "samples": Keyword('int'),
        "poses": Keyword('array', shape=('pose_count',), needs=('start', 'as_given')),
        "max_distance": Keyword('float'),
        "max_rounds": Keyword('int'),
    },
    "gusset_trim_options": {
        "max_distance": Keyword('float'),
        "max_angle": Keyword('float'),
        "viewpoints": Keyword('array', shape=('viewpoint_count', '3')),
        "min_faces": Keyword('int'),
    },
    "gusset_boundary_options": {
        "non_manifold": Keyword('choice', choices.NUMBERS['gusset_non_manifold']),
        "survey": Keyword('choice', choices.NUMBERS['gusset_survey']),
    },
    "gusset_develop_options": {
        "distortion": Keyword('choice', choices.NUMBERS['gusset_distortion']),
        "max_darts": Keyword('int'),
        "cuts": Keyword('array'),
        "cut_offsets": Keyword('array'),
        "max_stretch": Keyword('float'),
        "max_iterations": Keyword('int'),
    },
    "gusset_facing_options": {
        "run": Keyword('choice', choices.NUMBERS['gusset_facing_run']),
        "tolerance_mode": Keyword('choice', choices.NUMBERS['gusset_tolerance_mode']),
        "tolerance": Keyword('float', needs=('tolerance_mode', 'given')),
        "centres": Keyword('choice', choices.NUMBERS['gusset_centres']),
    },
    "gusset_mesh_section_options": {
        "tolerance": Keyword('float'),
        "in_plane": Keyword('choice', choices.NUMBERS['gusset_in_plane']),
    },
    "gusset_glue_options": {
        "tolerance": Keyword('float'),
        "gluings": Keyword('array', shape=('gluing_count',)),
        "links": Keyword('array', shape=('link_count',)),
        "detect": Keyword('flag'),
        "saturate": Keyword('flag'),
        "snap": Keyword('flag'),
    },
    "gusset_net_primitive": {
        "shape": Keyword('choice', choices.NUMBERS['gusset_net_shape']),
        "scalar": Keyword('choice', choices.NUMBERS['gusset_scalar']),
        "rows": Keyword('int'),
        "columns": Keyword('int'),
        "radius": Keyword('float'),
        "minor_radius": Keyword('float'),
        "height": Keyword('float'),
        "size": Keyword('row'),
        "profile": Keyword('array', shape=('profile_count', '2')),
        "sides": Keyword('int'),
        "box_kind": Keyword('choice', choices.NUMBERS['gusset_box_kind']),
        "cells": Keyword('row'),
    },
    "gusset_net_mesh_options": {
        "faces": Keyword('choice', choices.NUMBERS['gusset_net_faces']),
        "no_weld": Keyword('flag'),
        "keep_unused": Keyword('flag'),
        "fill_corners": Keyword('flag'),
        "texture": Keyword('flag'),
        "max_edge_ratio": Keyword('float'),
    },
    "gusset_net_grid_options": {
        "cells": Keyword('choice', choices.NUMBERS['gusset_grid_cells']),
        "has_face": Keyword('flag', needs=('cells', 'quads')),
        "face": Keyword('int', needs=('has_face', '1')),
    },
    "gusset_net_copy_options": {
        "row_first": Keyword('int'),
        "row_count": Keyword('int'),
        "column_first": Keyword('int'),
        "column_count": Keyword('int'),
        "rows": Keyword('int'),
        "columns": Keyword('int'),
        "compact": Keyword('flag'),
        "row_replication": Keyword('choice', choices.NUMBERS['gusset_replication']),
        "column_replication": Keyword('choice', choices.NUMBERS['gusset_replication']),
        "row_index": Keyword('int', needs=('row_replication', 'at')),
        "column_index": Keyword('int', needs=('column_replication', 'at')),
        "turn": Keyword('choice', choices.NUMBERS['gusset_net_turn']),
        "scalar": Keyword('choice', choices.NUMBERS['gusset_scalar']),
    },
    "gusset_concatenate_options": {
        "tolerance": Keyword('float'),
        "direction": Keyword('choice', choices.NUMBERS['gusset_direction']),
        "mode": Keyword('choice', choices.NUMBERS['gusset_bridge_mode']),
        "equalise": Keyword('choice', choices.NUMBERS['gusset_replication']),
        "equalise_index": Keyword('int', needs=('equalise', 'at')),
        "twist": Keyword('int'),
        "turn": Keyword('flag'),
        "rows": Keyword('int'),
    },
    "gusset_net_analysis_options": {
        "fields": Keyword('array', shape=('field_count',)),
        "time": Keyword('float'),
        "tolerance": Keyword('float'),
    },
    "gusset_planarise_options": {
        "tolerance": Keyword('float'),
        "fixed": Keyword('array', shape=('fixed_count',)),
        "max_iterations": Keyword('int'),
        "keep_boundary": Keyword('flag'),
    },
    "gusset_settle_options": {
        "tolerance": Keyword('float'),
        "rest_ratio": Keyword('float'),
        "free": Keyword('array', shape=('free_count',)),
        "max_iterations": Keyword('int'),
    },
    "gusset_winged_options": {
        "winding": Keyword('choice', choices.NUMBERS['gusset_winding']),
    },
    "gusset_stream_options": {
        "rows_per_block": Keyword('int'),
        "mode": Keyword('choice', choices.NUMBERS['gusset_stream_mode']),
        "bits": Keyword('int'),
        "per_axis": Keyword('flag'),
        "levels": Keyword('choice', choices.NUMBERS['gusset_stream_levels']),
        "low": Keyword('row', needs=('levels', 'given')),
        "high": Keyword('row', needs=('levels', 'given')),
        "step": Keyword('float', needs=('levels', 'given')),
    },
    "gusset_surface_options": {
        "tolerance": Keyword('float'),
        "cones": Keyword('flag'),
    },
    "gusset_nearest_options": {
        "limit": Keyword('float'),
        "max_count": Keyword('int'),
    },
    "gusset_contour_options": {
        "chord": Keyword('float', needs=('spacing', 'chord')),
        "spacing": Keyword('choice', choices.NUMBERS['gusset_spacing_rule']),
        "points": Keyword('int', needs=('spacing', 'leus')),
    },
    "gusset_intersection_options": {
        "chord": Keyword('float', needs=('spacing', 'chord')),
        "tolerance": Keyword('float'),
        "spacing": Keyword('choice', choices.NUMBERS['gusset_spacing_rule']),
    },
    "gusset_sheet_mesh_options": {
        "tolerance": Keyword('float'),
        "min_u": Keyword('int'),
        "min_v": Keyword('int'),
        "triangles": Keyword('flag'),
    },
    "gusset_frame_options": {
        "correspondence": Keyword('choice', choices.NUMBERS['gusset_correspondence_rule']),
        "columns": Keyword('int'),
        "ring": Keyword('flag'),
        "given_starts": Keyword('flag'),
        "smooth_corners": Keyword('flag'),
        "axis_point": Keyword('row'),
        "axis_direction": Keyword('row'),
        "reference": Keyword('row'),
        "axis_points": Keyword('array', shape=('axis_point_count', '3')),
        "landmarks": Keyword('array'),
        "across": Keyword('options'),
        "along": Keyword('options'),
        "missing": Keyword('array'),
    },
    "gusset_join_options": {
        "weld": Keyword('choice', choices.NUMBERS['gusset_welding']),
        "orientation": Keyword('choice', {'fix': 0, 'keep': 2}),
        "gap": Keyword('choice', choices.NUMBERS['gusset_gap']),
        "extent": Keyword('choice', choices.NUMBERS['gusset_join_extent']),
        "within_components": Keyword('flag'),
        "fill": Keyword('flag'),
        "max_gap": Keyword('float', needs=('gap', 'given')),
        "pairs": Keyword('array', shape=('pair_count',)),
        "excluded": Keyword('array', shape=('excluded_count',)),
        "weld_options": Keyword('options'),
        "strip_options": Keyword('options'),
        "fill_options": Keyword('options'),
        "outward": Keyword('choice', choices.NUMBERS['gusset_outward']),
        "overlaps": Keyword('choice', choices.NUMBERS['gusset_overlaps']),
        "trim_options": Keyword('options', needs=('overlaps', 'trim')),
    },
    "gusset_repair_options": {
        "tolerance_mode": Keyword('choice', choices.NUMBERS['gusset_tolerance_mode']),
        "leave_borders": Keyword('flag'),
        "tolerance": Keyword('float', needs=('tolerance_mode', 'given')),
        "leave_flat_faces": Keyword('flag'),
        "leave_duplicates": Keyword('flag'),
        "leave_non_manifold": Keyword('flag'),
        "leave_holes": Keyword('flag'),
        "leave_fins": Keyword('flag'),
        "leave_orientation": Keyword('flag'),
        "leave_intersections": Keyword('flag'),
        "fill_options": Keyword('options'),
    },
}
