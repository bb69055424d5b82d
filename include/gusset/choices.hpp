/// @file
/// The choices of gusset.h as enums. Generated from src/capi; do not edit. Include gusset.hpp, not this.
#ifndef GUSSET_CHOICES_HPP
#define GUSSET_CHOICES_HPP

#include <gusset.h>

namespace gusset {

/// Demand on a curve at a point. See ::gusset_constraint_kind.
enum class ConstraintKind : uint32_t {
    tangent = GUSSET_CONSTRAINT_TANGENT,
    corner = GUSSET_CONSTRAINT_CORNER,
    tangent_angle = GUSSET_CONSTRAINT_TANGENT_ANGLE
};

/// Kind of an outline's curve. See ::gusset_curve_kind.
enum class CurveKind : uint32_t {
    composite = GUSSET_CURVE_KIND_COMPOSITE,
    single = GUSSET_CURVE_KIND_SINGLE,
    blend_c1 = GUSSET_CURVE_KIND_BLEND_C1,
    blend_c2 = GUSSET_CURVE_KIND_BLEND_C2,
    cubic_c2 = GUSSET_CURVE_KIND_CUBIC_C2,
    chain = GUSSET_CURVE_KIND_CHAIN
};

/// Guide of a section's control point. See ::gusset_section_method.
enum class SectionMethod : uint32_t {
    bisector = GUSSET_METHOD_BISECTOR,
    median = GUSSET_METHOD_MEDIAN,
    normal = GUSSET_METHOD_NORMAL,
    symmedian = GUSSET_METHOD_SYMMEDIAN,
    alpha = GUSSET_METHOD_ALPHA
};

/// Rule for the parameters of points. See ::gusset_parameter_lock.
enum class ParameterLock : uint32_t {
    parameter = GUSSET_LOCK_PARAMETER,
    self_consistent = GUSSET_LOCK_SELF_CONSISTENT,
    data_guide = GUSSET_LOCK_DATA_GUIDE
};

/// Positions of joints of composite curves. See ::gusset_joint_parameter.
enum class JointParameter : uint32_t {
    half = GUSSET_JOINT_PARAMETER_HALF,
    knot = GUSSET_JOINT_PARAMETER_KNOT,
    g2 = GUSSET_JOINT_PARAMETER_G2
};

/// Method of solution. See ::gusset_outline_solver.
enum class OutlineSolver : uint32_t { fast = GUSSET_SOLVER_FAST, step = GUSSET_SOLVER_STEP };

/// End directions of open outlines. See ::gusset_outline_ends.
enum class OutlineEnds : uint32_t {
    free = GUSSET_ENDS_FREE,
    perpendicular = GUSSET_ENDS_PERPENDICULAR,
    level = GUSSET_ENDS_LEVEL,
    upright = GUSSET_ENDS_UPRIGHT,
    level_or_upright = GUSSET_ENDS_LEVEL_OR_UPRIGHT
};

/// Outcome at a point of an outline. See ::gusset_point_status.
enum class PointStatus : uint32_t {
    ok = GUSSET_POINT_OK,
    clamped_parameter = GUSSET_POINT_CLAMPED_PARAMETER,
    merged = GUSSET_POINT_MERGED,
    repeated = GUSSET_POINT_REPEATED,
    collinear = GUSSET_POINT_COLLINEAR,
    normal_outside = GUSSET_POINT_NORMAL_OUTSIDE,
    right_angle = GUSSET_POINT_RIGHT_ANGLE,
    no_crossing = GUSSET_POINT_NO_CROSSING,
    tangent_separates = GUSSET_POINT_TANGENT_SEPARATES,
    tangent_backward = GUSSET_POINT_TANGENT_BACKWARD,
    tangent_beyond = GUSSET_POINT_TANGENT_BEYOND,
    out_of_plane = GUSSET_POINT_OUT_OF_PLANE,
    no_tangent = GUSSET_POINT_NO_TANGENT,
    fell_back = GUSSET_POINT_FELL_BACK,
    not_converged = GUSSET_POINT_NOT_CONVERGED,
    missed = GUSSET_POINT_MISSED,
    joint_fell_back = GUSSET_POINT_JOINT_FELL_BACK,
    composite_instead = GUSSET_POINT_COMPOSITE_INSTEAD,
    cusp = GUSSET_POINT_CUSP,
    looped = GUSSET_POINT_LOOPED,
    crowded = GUSSET_POINT_CROWDED
};

/// Outcome of an outline. See ::gusset_fit_status.
enum class FitStatus : uint32_t {
    ok = GUSSET_FIT_OK,
    partial = GUSSET_FIT_PARTIAL,
    not_converged = GUSSET_FIT_NOT_CONVERGED,
    diverged = GUSSET_FIT_DIVERGED,
    ill_conditioned = GUSSET_FIT_ILL_CONDITIONED,
    too_few_points = GUSSET_FIT_TOO_FEW_POINTS,
    degree_too_high = GUSSET_FIT_DEGREE_TOO_HIGH
};

/// Spacing of samples. See ::gusset_sample_rule.
enum class SampleRule : uint32_t {
    count = GUSSET_SAMPLE_COUNT,
    step = GUSSET_SAMPLE_STEP,
    chord = GUSSET_SAMPLE_CHORD
};

/// Export format of a curve. See ::gusset_curve_format.
enum class CurveFormat : uint32_t {
    svg = GUSSET_CURVE_FORMAT_SVG,
    contour = GUSSET_CURVE_FORMAT_CONTOUR,
    spline = GUSSET_CURVE_FORMAT_SPLINE
};

/// Correspondence of points between sections. See ::gusset_correspondence_rule.
enum class CorrespondenceRule : uint32_t {
    given = GUSSET_CORRESPONDENCE_GIVEN,
    arc_length = GUSSET_CORRESPONDENCE_ARC_LENGTH,
    angle = GUSSET_CORRESPONDENCE_ANGLE,
    landmarks = GUSSET_CORRESPONDENCE_LANDMARKS
};

/// Direction in which nodes move. See ::gusset_offset_direction.
enum class OffsetDirection : uint32_t { normal = GUSSET_OFFSET_NORMAL, in_section = GUSSET_OFFSET_IN_SECTION };

/// Type of coordinates. See ::gusset_scalar.
enum class Scalar : uint32_t { f32 = GUSSET_F32, f64 = GUSSET_F64 };

/// Type of indices. See ::gusset_index.
enum class Index : uint32_t { u32 = GUSSET_U32, u64 = GUSSET_U64 };

/// Treatment of coincident borders. See ::gusset_welding.
enum class Welding : uint32_t {
    sew = GUSSET_WELDING_SEW,
    none = GUSSET_WELDING_NONE,
    edge_to_edge = GUSSET_WELDING_EDGE_TO_EDGE
};

/// Widest gap to close. See ::gusset_gap.
enum class Gap : uint32_t { automatic = GUSSET_GAP_AUTO, given = GUSSET_GAP_GIVEN };

/// Parts of loops that are joined. See ::gusset_join_extent.
enum class JoinExtent : uint32_t {
    loops_and_parts = GUSSET_JOIN_LOOPS_AND_PARTS,
    whole_loops = GUSSET_JOIN_WHOLE_LOOPS,
    parts = GUSSET_JOIN_PARTS
};

/// Treatment of overlapping pieces. See ::gusset_overlaps.
enum class Overlaps : uint32_t { keep = GUSSET_OVERLAPS_KEEP, trim = GUSSET_OVERLAPS_TRIM };

/// Outcome of a joint. See ::gusset_joint_outcome.
enum class JointOutcome : uint32_t {
    joined = GUSSET_JOINT_JOINED,
    orientation_conflict = GUSSET_JOINT_ORIENTATION_CONFLICT,
    share_vertex = GUSSET_JOINT_SHARE_VERTEX,
    no_strip = GUSSET_JOINT_NO_STRIP,
    would_cut = GUSSET_JOINT_WOULD_CUT
};

/// Reason for the lack of a strip. See ::gusset_left_reason.
enum class LeftReason : uint32_t {
    alone = GUSSET_LEFT_ALONE,
    not_simple = GUSSET_LEFT_NOT_SIMPLE,
    too_short = GUSSET_LEFT_TOO_SHORT,
    not_joined = GUSSET_LEFT_NOT_JOINED,
    too_far = GUSSET_LEFT_TOO_FAR,
    same_component = GUSSET_LEFT_SAME_COMPONENT,
    looks_away = GUSSET_LEFT_LOOKS_AWAY,
    taken = GUSSET_LEFT_TAKEN,
    excluded = GUSSET_LEFT_EXCLUDED
};

/// Rule for the meridians. See ::gusset_meridians.
enum class Meridians : uint32_t {
    continuation = GUSSET_MERIDIANS_CONTINUATION,
    index = GUSSET_MERIDIANS_INDEX,
    arc_length = GUSSET_MERIDIANS_ARC_LENGTH,
    greedy = GUSSET_MERIDIANS_GREEDY,
    min_diagonal = GUSSET_MERIDIANS_MIN_DIAGONAL,
    smooth = GUSSET_MERIDIANS_SMOOTH,
    quad = GUSSET_MERIDIANS_QUAD,
    min_area = GUSSET_MERIDIANS_MIN_AREA
};

/// Search effort. See ::gusset_strip_search.
enum class StripSearch : uint32_t { automatic = GUSSET_SEARCH_AUTO, exact = GUSSET_SEARCH_EXACT };

/// First meridian of a closed strip; open ones start at their first points. See ::gusset_strip_start.
enum class StripStart : uint32_t {
    automatic = GUSSET_START_AUTO,
    closest = GUSSET_START_CLOSEST,
    given = GUSSET_START_GIVEN
};

/// Positions of new vertices. See ::gusset_fairing.
enum class Fairing : uint32_t { none = GUSSET_FAIRING_NONE, thin_plate = GUSSET_FAIRING_THIN_PLATE };

/// Treatment of intersecting faces. See ::gusset_intersections.
enum class Intersections : uint32_t {
    automatic = GUSSET_INTERSECTIONS_AUTO,
    ignore = GUSSET_INTERSECTIONS_IGNORE,
    report = GUSSET_INTERSECTIONS_REPORT
};

/// Treatment of opposite orientations. See ::gusset_orientation.
enum class Orientation : uint32_t {
    fix = GUSSET_ORIENTATION_FIX,
    refuse = GUSSET_ORIENTATION_REFUSE,
    keep = GUSSET_ORIENTATION_KEEP
};

/// Part of the loops to join. See ::gusset_stitch_extent.
enum class StitchExtent : uint32_t {
    whole_loops = GUSSET_EXTENT_WHOLE_LOOPS,
    open_arcs = GUSSET_EXTENT_OPEN_ARCS,
    automatic = GUSSET_EXTENT_AUTO,
    arcs = GUSSET_EXTENT_ARCS
};

/// Choice among runs of facing vertices. See ::gusset_facing_run.
enum class FacingRun : uint32_t { closest = GUSSET_RUN_CLOSEST, longest = GUSSET_RUN_LONGEST };

/// Centre of a loop. See ::gusset_centres.
enum class Centres : uint32_t { vertices = GUSSET_CENTRES_VERTICES, length = GUSSET_CENTRES_LENGTH };

/// Number of interior rows. See ::gusset_row_rule.
enum class RowRule : uint32_t { none = GUSSET_ROWS_NONE, mean_edge = GUSSET_ROWS_MEAN_EDGE, count = GUSSET_ROWS_COUNT };

/// Faces of the strip. See ::gusset_strip_cells.
enum class StripCells : uint32_t { triangles = GUSSET_CELLS_TRIANGLES, quads = GUSSET_CELLS_QUADS };

/// Surface between the rims, or in a hole. See ::gusset_finish.
enum class Finish : uint32_t { strip = GUSSET_FINISH_STRIP, blend = GUSSET_FINISH_BLEND };

/// Source of the tolerance. See ::gusset_tolerance_mode.
enum class ToleranceMode : uint32_t {
    automatic = GUSSET_TOLERANCE_AUTO,
    given = GUSSET_TOLERANCE_GIVEN,
    exact = GUSSET_TOLERANCE_EXACT
};

/// Side that closed components face. See ::gusset_outward.
enum class Outward : uint32_t {
    automatic = GUSSET_OUTWARD_AUTO,
    keep = GUSSET_OUTWARD_KEEP,
    closed = GUSSET_OUTWARD_CLOSED
};

/// Loops that are not holes, if all loops are selected. See ::gusset_fill_keep.
enum class FillKeep : uint32_t {
    automatic = GUSSET_KEEP_AUTO,
    none = GUSSET_KEEP_NONE,
    longest = GUSSET_KEEP_LONGEST,
    borders = GUSSET_KEEP_BORDERS
};

/// Loops that share a patch. See ::gusset_fill_together.
enum class FillTogether : uint32_t {
    apart = GUSSET_TOGETHER_APART,
    one = GUSSET_TOGETHER_ONE,
    cheapest = GUSSET_TOGETHER_CHEAPEST
};

/// New vertices of patches. See ::gusset_fill_refinement.
enum class FillRefinement : uint32_t { none = GUSSET_REFINE_NONE, rim_density = GUSSET_REFINE_RIM_DENSITY };

/// Smoothness between faired patches and the old surface. See ::gusset_fill_continuity.
enum class FillContinuity : uint32_t { c1 = GUSSET_CONTINUITY_C1, c2 = GUSSET_CONTINUITY_C2 };

/// Weight that the triangulation of a hole minimises. See ::gusset_fill_weight.
enum class FillWeight : uint32_t {
    continuation = GUSSET_WEIGHT_CONTINUATION,
    area_and_bend = GUSSET_WEIGHT_AREA_AND_BEND,
    bend_then_area = GUSSET_WEIGHT_BEND_THEN_AREA,
    area = GUSSET_WEIGHT_AREA
};

/// Vertices of a patch. See ::gusset_patch_finish.
enum class PatchFinish : uint32_t {
    plain = GUSSET_PATCH_PLAIN,
    refined = GUSSET_PATCH_REFINED,
    faired = GUSSET_PATCH_FAIRED
};

/// Outcome for one loop. See ::gusset_hole_status.
enum class HoleStatus : uint32_t {
    filled = GUSSET_HOLE_FILLED,
    kept = GUSSET_HOLE_KEPT,
    too_large = GUSSET_HOLE_TOO_LARGE,
    open = GUSSET_HOLE_OPEN,
    non_manifold = GUSSET_HOLE_NON_MANIFOLD,
    not_oriented = GUSSET_HOLE_NOT_ORIENTED,
    not_simple = GUSSET_HOLE_NOT_SIMPLE,
    not_free = GUSSET_HOLE_NOT_FREE,
    no_triangulation = GUSSET_HOLE_NO_TRIANGULATION,
    loose = GUSSET_HOLE_LOOSE,
    unsewn = GUSSET_HOLE_UNSEWN
};

/// Vertices that are welded. See ::gusset_weld_vertices.
enum class WeldVertices : uint32_t { boundary = GUSSET_WELD_BOUNDARY, all = GUSSET_WELD_ALL };

/// Treatment of coincident corners of one face. See ::gusset_collapse.
enum class Collapse : uint32_t { never = GUSSET_COLLAPSE_NEVER, allow = GUSSET_COLLAPSE_ALLOW };

/// Treatment of vertices that no face uses. See ::gusset_unused.
enum class Unused : uint32_t { keep = GUSSET_UNUSED_KEEP, remove = GUSSET_UNUSED_REMOVE };

/// Reason why a face was dropped. See ::gusset_drop_reason.
enum class DropReason : uint32_t {
    degenerate = GUSSET_DROP_DEGENERATE,
    zero_area = GUSSET_DROP_ZERO_AREA,
    duplicate = GUSSET_DROP_DUPLICATE,
    inside = GUSSET_DROP_INSIDE,
    fin = GUSSET_DROP_FIN,
    overlap = GUSSET_DROP_OVERLAP
};

/// Initial poses. See ::gusset_alignment_start.
enum class AlignmentStart : uint32_t {
    as_given = GUSSET_ALIGN_AS_GIVEN,
    principal_axes = GUSSET_ALIGN_PRINCIPAL_AXES,
    rims = GUSSET_ALIGN_RIMS,
    features = GUSSET_ALIGN_FEATURES
};

/// Verdict on the pose of a piece. See ::gusset_aligned_reason.
enum class AlignedReason : uint32_t {
    trusted = GUSSET_ALIGNED_TRUSTED,
    no_overlap = GUSSET_ALIGNED_NO_OVERLAP,
    poor_fit = GUSSET_ALIGNED_POOR_FIT,
    undetermined = GUSSET_ALIGNED_UNDETERMINED,
    faces_other_way = GUSSET_ALIGNED_FACES_OTHER_WAY,
    other_size = GUSSET_ALIGNED_OTHER_SIZE,
    trusted_by_none = GUSSET_ALIGNED_TRUSTED_BY_NONE
};

/// Treatment of non-manifold edges. See ::gusset_non_manifold.
enum class NonManifold : uint32_t { cut = GUSSET_NON_MANIFOLD_CUT, stop = GUSSET_NON_MANIFOLD_STOP };

/// Part of the mesh that is checked. See ::gusset_survey.
enum class Survey : uint32_t { whole_mesh = GUSSET_SURVEY_WHOLE_MESH, boundary_only = GUSSET_SURVEY_BOUNDARY_ONLY };

/// Kind of a defect. See ::gusset_defect_kind.
enum class DefectKind : uint32_t {
    degenerate_face = GUSSET_DEFECT_DEGENERATE_FACE,
    orientation_conflict = GUSSET_DEFECT_ORIENTATION_CONFLICT,
    non_manifold_edge = GUSSET_DEFECT_NON_MANIFOLD_EDGE,
    bow_tie = GUSSET_DEFECT_BOW_TIE
};

/// Distortion that a development minimises. See ::gusset_distortion.
enum class Distortion : uint32_t {
    symmetric = GUSSET_DISTORTION_SYMMETRIC,
    rigid = GUSSET_DISTORTION_RIGID,
    conformal = GUSSET_DISTORTION_CONFORMAL
};

/// Outcome of the layout of a chart. See ::gusset_chart_finish.
enum class ChartFinish : uint32_t {
    exact = GUSSET_CHART_EXACT,
    converged = GUSSET_CHART_CONVERGED,
    iteration_limit = GUSSET_CHART_ITERATION_LIMIT,
    conformal = GUSSET_CHART_CONFORMAL,
    not_conformal = GUSSET_CHART_NOT_CONFORMAL,
    folded = GUSSET_CHART_FOLDED,
    stalled = GUSSET_CHART_STALLED
};

/// Reason for a cut. See ::gusset_cut_kind.
enum class CutKind : uint32_t { given = GUSSET_CUT_GIVEN, opening = GUSSET_CUT_OPENING, dart = GUSSET_CUT_DART };

/// Side of vertices in a plane. See ::gusset_in_plane.
enum class InPlane : uint32_t { above = GUSSET_IN_PLANE_ABOVE, below = GUSSET_IN_PLANE_BELOW };

/// Kind of cutting planes. See ::gusset_cutting_kind.
enum class CuttingKind : uint32_t {
    stack = GUSSET_CUTTING_STACK,
    planes = GUSSET_CUTTING_PLANES,
    axis = GUSSET_CUTTING_AXIS,
    curve = GUSSET_CUTTING_CURVE
};

/// Kind of element. See ::gusset_domain.
enum class Domain : uint32_t {
    vertices = GUSSET_DOMAIN_VERTICES,
    corners = GUSSET_DOMAIN_CORNERS,
    faces = GUSSET_DOMAIN_FACES
};

/// Type of values. See ::gusset_value_type.
enum class ValueType : uint32_t {
    f32 = GUSSET_VALUE_F32,
    f64 = GUSSET_VALUE_F64,
    u8 = GUSSET_VALUE_U8,
    u16 = GUSSET_VALUE_U16,
    u32 = GUSSET_VALUE_U32
};

/// Rule that combines the values of several sources. See ::gusset_rule.
enum class Rule : uint32_t {
    linear = GUSSET_RULE_LINEAR,
    normal = GUSSET_RULE_NORMAL,
    skin_weights = GUSSET_RULE_SKIN_WEIGHTS,
    nearest = GUSSET_RULE_NEAREST,
    texture = GUSSET_RULE_TEXTURE
};

/// Memory of a net's coordinates. See ::gusset_net_memory.
enum class NetMemory : uint32_t { copy = GUSSET_NET_MEMORY_COPY, borrow = GUSSET_NET_MEMORY_BORROW };

/// Kind of a gluing. See ::gusset_gluing_kind.
enum class GluingKind : uint32_t {
    link = GUSSET_GLUING_LINK,
    star = GUSSET_GLUING_STAR,
    cell = GUSSET_GLUING_CELL,
    diagonal = GUSSET_GLUING_DIAGONAL,
    seam = GUSSET_GLUING_SEAM,
    type = GUSSET_GLUING_TYPE
};

/// Local gluing of Deryagin's figure 4. n(...) counts contracted links of a node, c(...) of a cell. See ::gusset_gluing_type.
enum class GluingType : uint32_t {
    none = GUSSET_TYPE_NONE,
    horizontal = GUSSET_TYPE_HORIZONTAL,
    vertical = GUSSET_TYPE_VERTICAL,
    east_south = GUSSET_TYPE_EAST_SOUTH,
    south_west = GUSSET_TYPE_SOUTH_WEST,
    west_north = GUSSET_TYPE_WEST_NORTH,
    north_east = GUSSET_TYPE_NORTH_EAST,
    east_west = GUSSET_TYPE_EAST_WEST,
    north_south = GUSSET_TYPE_NORTH_SOUTH,
    but_north = GUSSET_TYPE_BUT_NORTH,
    but_east = GUSSET_TYPE_BUT_EAST,
    but_south = GUSSET_TYPE_BUT_SOUTH,
    but_west = GUSSET_TYPE_BUT_WEST,
    all = GUSSET_TYPE_ALL,
    top_bottom = GUSSET_TYPE_TOP_BOTTOM,
    right_left = GUSSET_TYPE_RIGHT_LEFT,
    point = GUSSET_TYPE_POINT,
    falling = GUSSET_TYPE_FALLING,
    rising = GUSSET_TYPE_RISING
};

/// Element that has a local gluing. See ::gusset_gluing_place.
enum class GluingPlace : uint32_t { node = GUSSET_GLUING_PLACE_NODE, cell = GUSSET_GLUING_PLACE_CELL };

/// Standard shape, its measures, the least rows x columns. See ::gusset_net_shape.
enum class NetShape : uint32_t {
    plane = GUSSET_NET_PLANE,
    sphere = GUSSET_NET_SPHERE,
    one_pole_sphere = GUSSET_NET_ONE_POLE_SPHERE,
    tube = GUSSET_NET_TUBE,
    cylinder = GUSSET_NET_CYLINDER,
    prism = GUSSET_NET_PRISM,
    cone = GUSSET_NET_CONE,
    pyramid = GUSSET_NET_PYRAMID,
    lathe = GUSSET_NET_LATHE,
    torus = GUSSET_NET_TORUS,
    box = GUSSET_NET_BOX,
    moebius = GUSSET_NET_MOEBIUS,
    klein = GUSSET_NET_KLEIN,
    projective_plane = GUSSET_NET_PROJECTIVE_PLANE,
    pillow = GUSSET_NET_PILLOW
};

/// Layout of the caps of a box. See ::gusset_box_kind.
enum class BoxKind : uint32_t {
    slit = GUSSET_NET_BOX_SLIT,
    cross = GUSSET_NET_BOX_CROSS,
    concentric = GUSSET_NET_BOX_CONCENTRIC
};

/// Coordinate axis. See ::gusset_axis.
enum class Axis : uint32_t { x = GUSSET_AXIS_X, y = GUSSET_AXIS_Y, z = GUSSET_AXIS_Z };

/// Kind of an affine map. See ::gusset_operation_kind.
enum class OperationKind : uint32_t {
    translate = GUSSET_OPERATION_TRANSLATE,
    rotate = GUSSET_OPERATION_ROTATE,
    rotate_as_printed = GUSSET_OPERATION_ROTATE_AS_PRINTED,
    scale = GUSSET_OPERATION_SCALE,
    compress = GUSSET_OPERATION_COMPRESS,
    stretch = GUSSET_OPERATION_STRETCH,
    matrix = GUSSET_OPERATION_MATRIX
};

/// Kind of a deformation field. See ::gusset_field_kind.
enum class FieldKind : uint32_t {
    affine = GUSSET_FIELD_AFFINE,
    twist = GUSSET_FIELD_TWIST,
    taper = GUSSET_FIELD_TAPER,
    bend = GUSSET_FIELD_BEND,
    shear = GUSSET_FIELD_SHEAR,
    spherify = GUSSET_FIELD_SPHERIFY,
    cylinder_wrap = GUSSET_FIELD_CYLINDER_WRAP,
    torus_wrap = GUSSET_FIELD_TORUS_WRAP,
    lattice = GUSSET_FIELD_LATTICE,
    projection = GUSSET_FIELD_PROJECTION,
    parallel = GUSSET_FIELD_PARALLEL,
    perspective = GUSSET_FIELD_PERSPECTIVE,
    cone_wrap = GUSSET_FIELD_CONE_WRAP,
    sphere_wrap = GUSSET_FIELD_SPHERE_WRAP
};

/// Interpolation of strengths between two keys. See ::gusset_easing.
enum class Easing : uint32_t {
    linear = GUSSET_EASING_LINEAR,
    smooth = GUSSET_EASING_SMOOTH,
    hold = GUSSET_EASING_HOLD
};

/// Faces of a net's mesh. See ::gusset_net_faces.
enum class NetFaces : uint32_t {
    quads = GUSSET_NET_QUADS,
    triangles_shorter = GUSSET_NET_TRIANGLES_SHORTER,
    triangles_fixed = GUSSET_NET_TRIANGLES_FIXED
};

/// Faces of a cell of the given grid. See ::gusset_grid_cells.
enum class GridCells : uint32_t { quads = GUSSET_GRID_QUADS, triangles = GUSSET_GRID_TRIANGLES };

/// Direction within a net. See ::gusset_direction.
enum class Direction : uint32_t { right = GUSSET_DIRECTION_RIGHT, down = GUSSET_DIRECTION_DOWN };

/// Chooses the rows or columns to replicate. See ::gusset_replication.
enum class Replication : uint32_t {
    uniform = GUSSET_REPLICATE_UNIFORM,
    first = GUSSET_REPLICATE_FIRST,
    last = GUSSET_REPLICATE_LAST,
    at = GUSSET_REPLICATE_AT,
    at_poles = GUSSET_REPLICATE_AT_POLES,
    refuse = GUSSET_REPLICATE_REFUSE
};

/// Symmetry of the rectangle of nodes. See ::gusset_net_turn.
enum class NetTurn : uint32_t {
    none = GUSSET_NET_TURN_NONE,
    quarter = GUSSET_NET_TURN_QUARTER,
    half = GUSSET_NET_TURN_HALF,
    three_quarters = GUSSET_NET_TURN_THREE_QUARTERS,
    flip_columns = GUSSET_NET_TURN_FLIP_COLUMNS,
    flip_rows = GUSSET_NET_TURN_FLIP_ROWS,
    transpose = GUSSET_NET_TURN_TRANSPOSE,
    antitranspose = GUSSET_NET_TURN_ANTITRANSPOSE
};

/// Interpolation of positions between nodes. See ::gusset_interpolation.
enum class Interpolation : uint32_t {
    bicubic = GUSSET_INTERPOLATION_BICUBIC,
    bilinear = GUSSET_INTERPOLATION_BILINEAR
};

/// Treatment of the cells of a bridge. See ::gusset_bridge_mode.
enum class BridgeMode : uint32_t { keep = GUSSET_BRIDGE_KEEP, hide = GUSSET_BRIDGE_HIDE, weld = GUSSET_BRIDGE_WELD };

/// Form of a bridge. See ::gusset_bridge_kind.
enum class BridgeKind : uint32_t {
    ribbon = GUSSET_BRIDGE_RIBBON,
    tube = GUSSET_BRIDGE_TUBE,
    thread = GUSSET_BRIDGE_THREAD
};

/// Cells that count. See ::gusset_net_cells.
enum class NetCells : uint32_t { all = GUSSET_NET_CELLS_ALL, present = GUSSET_NET_CELLS_PRESENT };

/// Path of nodes from one net to another. See ::gusset_morph_path.
enum class MorphPath : uint32_t { linear = GUSSET_MORPH_LINEAR, rigid = GUSSET_MORPH_RIGID };

/// Kind of a finding. See ::gusset_net_finding_kind.
enum class NetFindingKind : uint32_t {
    link_apart = GUSSET_NET_FINDING_LINK_APART,
    seam_apart = GUSSET_NET_FINDING_SEAM_APART,
    loop = GUSSET_NET_FINDING_LOOP,
    zero_length = GUSSET_NET_FINDING_ZERO_LENGTH,
    few_nodes = GUSSET_NET_FINDING_FEW_NODES
};

/// Object of a search. See ::gusset_reference_object.
enum class ReferenceObject : uint32_t {
    point = GUSSET_REFERENCE_POINT,
    plane = GUSSET_REFERENCE_PLANE,
    line = GUSSET_REFERENCE_LINE,
    segment = GUSSET_REFERENCE_SEGMENT,
    angle = GUSSET_REFERENCE_ANGLE,
    curve = GUSSET_REFERENCE_CURVE,
    surface = GUSSET_REFERENCE_SURFACE,
    ray = GUSSET_REFERENCE_RAY
};

/// Orientation of faces in a mesh. See ::gusset_winding.
enum class Winding : uint32_t {
    counter_clockwise = GUSSET_FACES_COUNTER_CLOCKWISE,
    clockwise = GUSSET_FACES_CLOCKWISE
};

/// Kind of a scene entry. See ::gusset_scene_entry_kind.
enum class SceneEntryKind : uint32_t { net = GUSSET_SCENE_NET, group = GUSSET_SCENE_GROUP };

/// Change of visibility. See ::gusset_visibility.
enum class Visibility : uint32_t {
    keep = GUSSET_VISIBILITY_KEEP,
    show = GUSSET_VISIBILITY_SHOW,
    hide = GUSSET_VISIBILITY_HIDE
};

/// Element that a report's index counts. See ::gusset_element.
enum class Element : uint32_t {
    none = GUSSET_ELEMENT_NONE,
    vertex = GUSSET_ELEMENT_VERTEX,
    face = GUSSET_ELEMENT_FACE,
    half_edge = GUSSET_ELEMENT_HALF_EDGE,
    offset = GUSSET_ELEMENT_OFFSET,
    loop_place = GUSSET_ELEMENT_LOOP_PLACE,
    count = GUSSET_ELEMENT_COUNT,
    point = GUSSET_ELEMENT_POINT,
    constraint = GUSSET_ELEMENT_CONSTRAINT,
    place = GUSSET_ELEMENT_PLACE,
    section = GUSSET_ELEMENT_SECTION,
    node = GUSSET_ELEMENT_NODE,
    link = GUSSET_ELEMENT_LINK,
    cell = GUSSET_ELEMENT_CELL,
    seam = GUSSET_ELEMENT_SEAM,
    bridge = GUSSET_ELEMENT_BRIDGE,
    entry = GUSSET_ELEMENT_ENTRY,
    byte = GUSSET_ELEMENT_BYTE,
    item = GUSSET_ELEMENT_ITEM,
    side_place = GUSSET_ELEMENT_SIDE_PLACE,
    knot = GUSSET_ELEMENT_KNOT,
    row = GUSSET_ELEMENT_ROW,
    edge = GUSSET_ELEMENT_EDGE
};

/// Storage of coordinates in a stream. See ::gusset_stream_mode.
enum class StreamMode : uint32_t {
    quantised = GUSSET_STREAM_QUANTISED,
    lossless = GUSSET_STREAM_LOSSLESS,
    raw = GUSSET_STREAM_RAW
};

/// Choice of the levels that coordinates are rounded to. See ::gusset_stream_levels.
enum class StreamLevels : uint32_t { automatic = GUSSET_LEVELS_AUTO, given = GUSSET_LEVELS_GIVEN };

/// How two surfaces touch. See ::gusset_contact_kind.
enum class ContactKind : uint32_t { point = GUSSET_CONTACT_POINT, crossing = GUSSET_CONTACT_CROSSING };

/// Interpolation through nodes. See ::gusset_scheme.
enum class Scheme : uint32_t { six_tap = GUSSET_SCHEME_SIX_TAP, four_point = GUSSET_SCHEME_FOUR_POINT };

/// Source of the twists S_uv at nodes. See ::gusset_twists.
enum class Twists : uint32_t {
    differences = GUSSET_TWISTS_DIFFERENCES,
    adini = GUSSET_TWISTS_ADINI,
    zero = GUSSET_TWISTS_ZERO,
    given = GUSSET_TWISTS_GIVEN
};

/// Kind of a normal. See ::gusset_normal_kind.
enum class NormalKind : uint32_t {
    none = GUSSET_NORMAL_NONE,
    regular = GUSSET_NORMAL_REGULAR,
    limit = GUSSET_NORMAL_LIMIT
};

/// The hits to return. See ::gusset_hit_selection.
enum class HitSelection : uint32_t { all = GUSSET_HITS_ALL, first = GUSSET_HITS_FIRST, any = GUSSET_HITS_ANY };

/// Kind of a hit. See ::gusset_hit_kind.
enum class HitKind : uint32_t {
    none = GUSSET_HIT_NONE,
    crossing = GUSSET_HIT_CROSSING,
    touch = GUSSET_HIT_TOUCH,
    inside = GUSSET_HIT_INSIDE
};

/// Curve points between crossings with cell sides. See ::gusset_spacing_rule.
enum class SpacingRule : uint32_t {
    automatic = GUSSET_POINT_SPACING_AUTO,
    chord = GUSSET_POINT_SPACING_CHORD,
    cell_edges = GUSSET_POINT_SPACING_CELL_EDGES,
    leus = GUSSET_POINT_SPACING_LEUS
};

/// The function whose contours are drawn. See ::gusset_contour_kind.
enum class ContourKind : uint32_t {
    height = GUSSET_CONTOUR_HEIGHT,
    values = GUSSET_CONTOUR_VALUES,
    angle = GUSSET_CONTOUR_ANGLE
};

/// Kind of a target. See ::gusset_target_kind.
enum class TargetKind : uint32_t {
    line = GUSSET_TARGET_LINE,
    plane = GUSSET_TARGET_PLANE,
    curve = GUSSET_TARGET_CURVE,
    surface = GUSSET_TARGET_SURFACE
};

/// How a surface is made from a frame. See ::gusset_frame_surface.
enum class FrameSurface : uint32_t {
    sections = GUSSET_FRAME_SECTIONS,
    nodes = GUSSET_FRAME_NODES,
    curves = GUSSET_FRAME_CURVES
};

/// Direction of a coordinate curve of a sheet. See ::gusset_sheet_direction.
enum class SheetDirection : uint32_t { rows = GUSSET_ALONG_ROWS, columns = GUSSET_ALONG_COLUMNS };

/// @cond
constexpr const char *choice_name(ConstraintKind) { return "gusset_constraint_kind"; }
constexpr const char *choice_name(CurveKind) { return "gusset_curve_kind"; }
constexpr const char *choice_name(SectionMethod) { return "gusset_section_method"; }
constexpr const char *choice_name(ParameterLock) { return "gusset_parameter_lock"; }
constexpr const char *choice_name(JointParameter) { return "gusset_joint_parameter"; }
constexpr const char *choice_name(OutlineSolver) { return "gusset_outline_solver"; }
constexpr const char *choice_name(OutlineEnds) { return "gusset_outline_ends"; }
constexpr const char *choice_name(PointStatus) { return "gusset_point_status"; }
constexpr const char *choice_name(FitStatus) { return "gusset_fit_status"; }
constexpr const char *choice_name(SampleRule) { return "gusset_sample_rule"; }
constexpr const char *choice_name(CurveFormat) { return "gusset_curve_format"; }
constexpr const char *choice_name(CorrespondenceRule) { return "gusset_correspondence_rule"; }
constexpr const char *choice_name(OffsetDirection) { return "gusset_offset_direction"; }
constexpr const char *choice_name(Scalar) { return "gusset_scalar"; }
constexpr const char *choice_name(Index) { return "gusset_index"; }
constexpr const char *choice_name(Welding) { return "gusset_welding"; }
constexpr const char *choice_name(Gap) { return "gusset_gap"; }
constexpr const char *choice_name(JoinExtent) { return "gusset_join_extent"; }
constexpr const char *choice_name(Overlaps) { return "gusset_overlaps"; }
constexpr const char *choice_name(JointOutcome) { return "gusset_joint_outcome"; }
constexpr const char *choice_name(LeftReason) { return "gusset_left_reason"; }
constexpr const char *choice_name(Meridians) { return "gusset_meridians"; }
constexpr const char *choice_name(StripSearch) { return "gusset_strip_search"; }
constexpr const char *choice_name(StripStart) { return "gusset_strip_start"; }
constexpr const char *choice_name(Fairing) { return "gusset_fairing"; }
constexpr const char *choice_name(Intersections) { return "gusset_intersections"; }
constexpr const char *choice_name(Orientation) { return "gusset_orientation"; }
constexpr const char *choice_name(StitchExtent) { return "gusset_stitch_extent"; }
constexpr const char *choice_name(FacingRun) { return "gusset_facing_run"; }
constexpr const char *choice_name(Centres) { return "gusset_centres"; }
constexpr const char *choice_name(RowRule) { return "gusset_row_rule"; }
constexpr const char *choice_name(StripCells) { return "gusset_strip_cells"; }
constexpr const char *choice_name(Finish) { return "gusset_finish"; }
constexpr const char *choice_name(ToleranceMode) { return "gusset_tolerance_mode"; }
constexpr const char *choice_name(Outward) { return "gusset_outward"; }
constexpr const char *choice_name(FillKeep) { return "gusset_fill_keep"; }
constexpr const char *choice_name(FillTogether) { return "gusset_fill_together"; }
constexpr const char *choice_name(FillRefinement) { return "gusset_fill_refinement"; }
constexpr const char *choice_name(FillContinuity) { return "gusset_fill_continuity"; }
constexpr const char *choice_name(FillWeight) { return "gusset_fill_weight"; }
constexpr const char *choice_name(PatchFinish) { return "gusset_patch_finish"; }
constexpr const char *choice_name(HoleStatus) { return "gusset_hole_status"; }
constexpr const char *choice_name(WeldVertices) { return "gusset_weld_vertices"; }
constexpr const char *choice_name(Collapse) { return "gusset_collapse"; }
constexpr const char *choice_name(Unused) { return "gusset_unused"; }
constexpr const char *choice_name(DropReason) { return "gusset_drop_reason"; }
constexpr const char *choice_name(AlignmentStart) { return "gusset_alignment_start"; }
constexpr const char *choice_name(AlignedReason) { return "gusset_aligned_reason"; }
constexpr const char *choice_name(NonManifold) { return "gusset_non_manifold"; }
constexpr const char *choice_name(Survey) { return "gusset_survey"; }
constexpr const char *choice_name(DefectKind) { return "gusset_defect_kind"; }
constexpr const char *choice_name(Distortion) { return "gusset_distortion"; }
constexpr const char *choice_name(ChartFinish) { return "gusset_chart_finish"; }
constexpr const char *choice_name(CutKind) { return "gusset_cut_kind"; }
constexpr const char *choice_name(InPlane) { return "gusset_in_plane"; }
constexpr const char *choice_name(CuttingKind) { return "gusset_cutting_kind"; }
constexpr const char *choice_name(Domain) { return "gusset_domain"; }
constexpr const char *choice_name(ValueType) { return "gusset_value_type"; }
constexpr const char *choice_name(Rule) { return "gusset_rule"; }
constexpr const char *choice_name(NetMemory) { return "gusset_net_memory"; }
constexpr const char *choice_name(GluingKind) { return "gusset_gluing_kind"; }
constexpr const char *choice_name(GluingType) { return "gusset_gluing_type"; }
constexpr const char *choice_name(GluingPlace) { return "gusset_gluing_place"; }
constexpr const char *choice_name(NetShape) { return "gusset_net_shape"; }
constexpr const char *choice_name(BoxKind) { return "gusset_box_kind"; }
constexpr const char *choice_name(Axis) { return "gusset_axis"; }
constexpr const char *choice_name(OperationKind) { return "gusset_operation_kind"; }
constexpr const char *choice_name(FieldKind) { return "gusset_field_kind"; }
constexpr const char *choice_name(Easing) { return "gusset_easing"; }
constexpr const char *choice_name(NetFaces) { return "gusset_net_faces"; }
constexpr const char *choice_name(GridCells) { return "gusset_grid_cells"; }
constexpr const char *choice_name(Direction) { return "gusset_direction"; }
constexpr const char *choice_name(Replication) { return "gusset_replication"; }
constexpr const char *choice_name(NetTurn) { return "gusset_net_turn"; }
constexpr const char *choice_name(Interpolation) { return "gusset_interpolation"; }
constexpr const char *choice_name(BridgeMode) { return "gusset_bridge_mode"; }
constexpr const char *choice_name(BridgeKind) { return "gusset_bridge_kind"; }
constexpr const char *choice_name(NetCells) { return "gusset_net_cells"; }
constexpr const char *choice_name(MorphPath) { return "gusset_morph_path"; }
constexpr const char *choice_name(NetFindingKind) { return "gusset_net_finding_kind"; }
constexpr const char *choice_name(ReferenceObject) { return "gusset_reference_object"; }
constexpr const char *choice_name(Winding) { return "gusset_winding"; }
constexpr const char *choice_name(SceneEntryKind) { return "gusset_scene_entry_kind"; }
constexpr const char *choice_name(Visibility) { return "gusset_visibility"; }
constexpr const char *choice_name(Element) { return "gusset_element"; }
constexpr const char *choice_name(StreamMode) { return "gusset_stream_mode"; }
constexpr const char *choice_name(StreamLevels) { return "gusset_stream_levels"; }
constexpr const char *choice_name(ContactKind) { return "gusset_contact_kind"; }
constexpr const char *choice_name(Scheme) { return "gusset_scheme"; }
constexpr const char *choice_name(Twists) { return "gusset_twists"; }
constexpr const char *choice_name(NormalKind) { return "gusset_normal_kind"; }
constexpr const char *choice_name(HitSelection) { return "gusset_hit_selection"; }
constexpr const char *choice_name(HitKind) { return "gusset_hit_kind"; }
constexpr const char *choice_name(SpacingRule) { return "gusset_spacing_rule"; }
constexpr const char *choice_name(ContourKind) { return "gusset_contour_kind"; }
constexpr const char *choice_name(TargetKind) { return "gusset_target_kind"; }
constexpr const char *choice_name(FrameSurface) { return "gusset_frame_surface"; }
constexpr const char *choice_name(SheetDirection) { return "gusset_sheet_direction"; }
/// @endcond

/// Describes a value of a choice in a sentence. See ::gusset_choice_text.
template <class Choice>
auto text(Choice value) -> decltype(choice_name(value)) {
    return gusset_choice_text(choice_name(value), static_cast<uint32_t>(value));
}

} // namespace gusset

#endif
