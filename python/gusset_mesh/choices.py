"""Words for the choices of the interface, and their numbers. Written by generate.py; do not edit."""

# fmt: off
from typing import Literal

#: Demand on a curve at a point.
ConstraintKind = Literal['tangent', 'corner', 'tangent_angle']

#: Kind of an outline's curve.
CurveKind = Literal['composite', 'single', 'blend_c1', 'blend_c2', 'cubic_c2', 'chain']

#: Guide of a section's control point.
SectionMethod = Literal['bisector', 'median', 'normal', 'symmedian', 'alpha']

#: Rule for the parameters of points.
ParameterLock = Literal['parameter', 'self_consistent', 'data_guide']

#: Positions of joints of composite curves.
JointParameter = Literal['half', 'knot', 'g2']

#: Method of solution.
OutlineSolver = Literal['fast', 'step']

#: End directions of open outlines.
OutlineEnds = Literal['free', 'perpendicular', 'level', 'upright', 'level_or_upright']

#: Outcome at a point of an outline.
PointStatus = Literal['ok', 'clamped_parameter', 'merged', 'repeated', 'collinear', 'normal_outside',
    'right_angle', 'no_crossing', 'tangent_separates', 'tangent_backward', 'tangent_beyond', 'out_of_plane',
    'no_tangent', 'fell_back', 'not_converged', 'missed', 'joint_fell_back', 'composite_instead', 'cusp', 'looped',
    'crowded']

#: Outcome of an outline.
FitStatus = Literal['ok', 'partial', 'not_converged', 'diverged', 'ill_conditioned', 'too_few_points',
    'degree_too_high']

#: Measures of a curve. Several words may be combined.
CurveMeasureFlags = Literal['length', 'bounds', 'centre', 'area', 'moments']

#: Spacing of samples.
SampleRule = Literal['count', 'step', 'chord']

#: Export format of a curve.
CurveFormat = Literal['svg', 'contour', 'spline']

#: Correspondence of points between sections.
CorrespondenceRule = Literal['given', 'arc_length', 'angle', 'landmarks']

#: Direction in which nodes move.
OffsetDirection = Literal['normal', 'in_section']

#: Type of coordinates.
Scalar = Literal['f32', 'f64']

#: Type of indices.
Index = Literal['u32', 'u64']

#: Treatment of coincident borders.
Welding = Literal['sew', 'none', 'edge_to_edge']

#: Widest gap to close.
Gap = Literal['auto', 'given']

#: Parts of loops that are joined.
JoinExtent = Literal['loops_and_parts', 'whole_loops', 'parts']

#: Treatment of overlapping pieces.
Overlaps = Literal['keep', 'trim']

#: Outcome of a joint.
JointOutcome = Literal['joined', 'orientation_conflict', 'share_vertex', 'no_strip', 'would_cut']

#: Reason for the lack of a strip.
LeftReason = Literal['alone', 'not_simple', 'too_short', 'not_joined', 'too_far', 'same_component', 'looks_away',
    'taken', 'excluded']

#: Rule for the meridians.
Meridians = Literal['continuation', 'index', 'arc_length', 'greedy', 'min_diagonal', 'smooth', 'quad', 'min_area']

#: Search effort.
StripSearch = Literal['auto', 'exact']

#: First meridian of a closed strip; open ones start at their first points.
StripStart = Literal['auto', 'closest', 'given']

#: Positions of new vertices.
Fairing = Literal['none', 'thin_plate']

#: Treatment of intersecting faces.
Intersections = Literal['auto', 'ignore', 'report']

#: Treatment of opposite orientations.
Orientation = Literal['fix', 'refuse', 'keep']

#: Part of the loops to join.
StitchExtent = Literal['whole_loops', 'open_arcs', 'auto', 'arcs']

#: Choice among runs of facing vertices.
FacingRun = Literal['closest', 'longest']

#: Centre of a loop.
Centres = Literal['vertices', 'length']

#: Number of interior rows.
RowRule = Literal['none', 'mean_edge', 'count']

#: Faces of the strip.
StripCells = Literal['triangles', 'quads']

#: Surface between the rims, or in a hole.
Finish = Literal['strip', 'blend']

#: Source of the tolerance.
ToleranceMode = Literal['auto', 'given', 'exact']

#: Side that closed components face.
Outward = Literal['auto', 'keep', 'closed']

#: Loops that are not holes, if all loops are selected.
FillKeep = Literal['auto', 'none', 'longest', 'borders']

#: Loops that share a patch.
FillTogether = Literal['apart', 'one', 'cheapest']

#: New vertices of patches.
FillRefinement = Literal['none', 'rim_density']

#: Smoothness between faired patches and the old surface.
FillContinuity = Literal['c1', 'c2']

#: Weight that the triangulation of a hole minimises.
FillWeight = Literal['continuation', 'area_and_bend', 'bend_then_area', 'area']

#: Vertices of a patch.
PatchFinish = Literal['plain', 'refined', 'faired']

#: Outcome for one loop.
HoleStatus = Literal['filled', 'kept', 'too_large', 'open', 'non_manifold', 'not_oriented', 'not_simple',
    'not_free', 'no_triangulation', 'loose', 'unsewn']

#: Vertices that are welded.
WeldVertices = Literal['boundary', 'all']

#: Treatment of coincident corners of one face.
Collapse = Literal['never', 'allow']

#: Treatment of vertices that no face uses.
Unused = Literal['keep', 'remove']

#: Reason why a face was dropped.
DropReason = Literal['degenerate', 'zero_area', 'duplicate', 'inside', 'fin', 'overlap']

#: Initial poses.
AlignmentStart = Literal['as_given', 'principal_axes', 'rims', 'features']

#: Verdict on the pose of a piece.
AlignedReason = Literal['trusted', 'no_overlap', 'poor_fit', 'undetermined', 'faces_other_way', 'other_size',
    'trusted_by_none']

#: Treatment of non-manifold edges.
NonManifold = Literal['cut', 'stop']

#: Part of the mesh that is checked.
Survey = Literal['whole_mesh', 'boundary_only']

#: Properties of a loop. Several words may be combined.
LoopFlags = Literal['open', 'bow_tie', 'split', 'non_manifold', 'not_oriented', 'zero_length']

#: Properties of an edge of a loop. Several words may be combined.
EdgeFlags = Literal['reversed', 'non_manifold', 'zero_length']

#: Kind of a defect.
DefectKind = Literal['degenerate_face', 'orientation_conflict', 'non_manifold_edge', 'bow_tie']

#: Properties of a mesh. Several words may be combined.
MeshFlags = Literal['closed', 'manifold', 'oriented', 'orientable']

#: Distortion that a development minimises.
Distortion = Literal['symmetric', 'rigid', 'conformal']

#: Outcome of the layout of a chart.
ChartFinish = Literal['exact', 'converged', 'iteration_limit', 'conformal', 'not_conformal', 'folded', 'stalled']

#: Reason for a cut.
CutKind = Literal['given', 'opening', 'dart']

#: Side of vertices in a plane.
InPlane = Literal['above', 'below']

#: Kind of cutting planes.
CuttingKind = Literal['stack', 'planes', 'axis', 'curve']

#: Kind of element.
Domain = Literal['vertices', 'corners', 'faces']

#: Type of values.
ValueType = Literal['f32', 'f64', 'u8', 'u16', 'u32']

#: Rule that combines the values of several sources.
Rule = Literal['linear', 'normal', 'skin_weights', 'nearest', 'texture']

#: Memory of a net's coordinates.
NetMemory = Literal['copy', 'borrow']

#: Gluing of sides. Several words may be combined.
Sides = Literal['rows_closed', 'columns_closed', 'pole_top', 'pole_bottom', 'pole_left', 'pole_right', 'sheet',
    'tube', 'two_poles', 'one_pole', 'torus']

#: Kind of a gluing.
GluingKind = Literal['link', 'star', 'cell', 'diagonal', 'seam', 'type']

#: Local gluing of Deryagin's figure 4. n(...) counts contracted links of a node, c(...) of a cell.
GluingType = Literal['none', 'horizontal', 'vertical', 'east_south', 'south_west', 'west_north', 'north_east',
    'east_west', 'north_south', 'but_north', 'but_east', 'but_south', 'but_west', 'all', 'top_bottom', 'right_left',
    'point', 'falling', 'rising']

#: Element that has a local gluing.
GluingPlace = Literal['node', 'cell']

#: Standard shape, its measures, the least rows x columns.
NetShape = Literal['plane', 'sphere', 'one_pole_sphere', 'tube', 'cylinder', 'prism', 'cone', 'pyramid', 'lathe',
    'torus', 'box', 'moebius', 'klein', 'projective_plane', 'pillow']

#: Layout of the caps of a box.
BoxKind = Literal['slit', 'cross', 'concentric']

#: Coordinate axis.
Axis = Literal['x', 'y', 'z']

#: Kind of an affine map.
OperationKind = Literal['translate', 'rotate', 'rotate_as_printed', 'scale', 'compress', 'stretch', 'matrix']

#: Kind of a deformation field.
FieldKind = Literal['affine', 'twist', 'taper', 'bend', 'shear', 'spherify', 'cylinder_wrap', 'torus_wrap',
    'lattice', 'projection', 'parallel', 'perspective', 'cone_wrap', 'sphere_wrap']

#: Interpolation of strengths between two keys.
Easing = Literal['linear', 'smooth', 'hold']

#: Measures to compute. Several words may be combined.
NetMeasures = Literal['extent', 'bilinear', 'body']

#: Faces of a net's mesh.
NetFaces = Literal['quads', 'triangles_shorter', 'triangles_fixed']

#: Faces of a cell of the given grid.
GridCells = Literal['quads', 'triangles']

#: Direction within a net.
Direction = Literal['right', 'down']

#: Chooses the rows or columns to replicate.
Replication = Literal['uniform', 'first', 'last', 'at', 'at_poles', 'refuse']

#: Symmetry of the rectangle of nodes.
NetTurn = Literal['none', 'quarter', 'half', 'three_quarters', 'flip_columns', 'flip_rows', 'transpose',
    'antitranspose']

#: Interpolation of positions between nodes.
Interpolation = Literal['bicubic', 'bilinear']

#: Treatment of the cells of a bridge.
BridgeMode = Literal['keep', 'hide', 'weld']

#: Form of a bridge.
BridgeKind = Literal['ribbon', 'tube', 'thread']

#: Cells that count.
NetCells = Literal['all', 'present']

#: Properties of the surface of a net. Several words may be combined.
NetFlags = Literal['closed', 'manifold', 'oriented', 'orientable']

#: Path of nodes from one net to another.
MorphPath = Literal['linear', 'rigid']

#: Kind of a finding.
NetFindingKind = Literal['link_apart', 'seam_apart', 'loop', 'zero_length', 'few_nodes']

#: Object of a search.
ReferenceObject = Literal['point', 'plane', 'line', 'segment', 'angle', 'curve', 'surface', 'ray']

#: Orientation of faces in a mesh.
Winding = Literal['counter_clockwise', 'clockwise']

#: Marks of an edge. Several words may be combined.
WingedFlags = Literal['non_manifold', 'not_oriented', 'degenerate']

#: Kind of a scene entry.
SceneEntryKind = Literal['net', 'group']

#: Change of visibility.
Visibility = Literal['keep', 'show', 'hide']

#: Element that a report's index counts.
Element = Literal['none', 'vertex', 'face', 'half_edge', 'offset', 'loop_place', 'count', 'point', 'constraint',
    'place', 'section', 'node', 'link', 'cell', 'seam', 'bridge', 'entry', 'byte', 'item', 'side_place', 'knot',
    'row', 'edge']

#: Storage of coordinates in a stream.
StreamMode = Literal['quantised', 'lossless', 'raw']

#: Choice of the levels that coordinates are rounded to.
StreamLevels = Literal['auto', 'given']

#: How two surfaces touch.
ContactKind = Literal['point', 'crossing']

#: Interpolation through nodes.
Scheme = Literal['six_tap', 'four_point']

#: Source of the twists S_uv at nodes.
Twists = Literal['differences', 'adini', 'zero', 'given']

#: Properties of a nearest point. Several words may be combined.
NearestFlags = Literal['found', 'proven', 'ambiguous']

#: Kind of a normal.
NormalKind = Literal['none', 'regular', 'limit']

#: The hits to return.
HitSelection = Literal['all', 'first', 'any']

#: Kind of a hit.
HitKind = Literal['none', 'crossing', 'touch', 'inside']

#: Curve points between crossings with cell sides.
SpacingRule = Literal['auto', 'chord', 'cell_edges', 'leus']

#: The function whose contours are drawn.
ContourKind = Literal['height', 'values', 'angle']

#: Kind of a target.
TargetKind = Literal['line', 'plane', 'curve', 'surface']

#: Properties of a distance. Several words may be combined.
DistanceFlags = Literal['proven', 'meets']

#: How a surface is made from a frame.
FrameSurface = Literal['sections', 'nodes', 'curves']

#: Fields of gusset_sheet_measures to compute. Several words may be combined.
SheetMeasureFlags = Literal['diameters', 'curvature', 'crease']

#: Direction of a coordinate curve of a sheet.
SheetDirection = Literal['rows', 'columns']

#: By choice the numbers of its words.
NUMBERS: dict[str, dict[str, int]] = {
    'gusset_constraint_kind': {'tangent': 0, 'corner': 1, 'tangent_angle': 2},
    'gusset_curve_kind': {'composite': 0, 'single': 1, 'blend_c1': 2, 'blend_c2': 3, 'cubic_c2': 4, 'chain': 5},
    'gusset_section_method': {'bisector': 0, 'median': 1, 'normal': 2, 'symmedian': 3, 'alpha': 4},
    'gusset_parameter_lock': {'parameter': 0, 'self_consistent': 1, 'data_guide': 2},
    'gusset_joint_parameter': {'half': 0, 'knot': 1, 'g2': 2},
    'gusset_outline_solver': {'fast': 0, 'step': 1},
    'gusset_outline_ends': {'free': 0, 'perpendicular': 1, 'level': 2, 'upright': 3, 'level_or_upright': 4},
    'gusset_point_status': {'ok': 0, 'clamped_parameter': 1, 'merged': 2, 'repeated': 3, 'collinear': 4,
    'normal_outside': 5, 'right_angle': 6, 'no_crossing': 7, 'tangent_separates': 8, 'tangent_backward': 9,
    'tangent_beyond': 10, 'out_of_plane': 11, 'no_tangent': 12, 'fell_back': 13, 'not_converged': 14, 'missed': 15,
    'joint_fell_back': 16, 'composite_instead': 17, 'cusp': 18, 'looped': 19, 'crowded': 20},
    'gusset_fit_status': {'ok': 0, 'partial': 1, 'not_converged': 2, 'diverged': 3, 'ill_conditioned': 4,
    'too_few_points': 5, 'degree_too_high': 6},
    'gusset_curve_measure_flags': {'length': 1, 'bounds': 2, 'centre': 4, 'area': 8, 'moments': 16},
    'gusset_sample_rule': {'count': 0, 'step': 1, 'chord': 2},
    'gusset_curve_format': {'svg': 0, 'contour': 1, 'spline': 2},
    'gusset_correspondence_rule': {'given': 0, 'arc_length': 1, 'angle': 2, 'landmarks': 3},
    'gusset_offset_direction': {'normal': 0, 'in_section': 1},
    'gusset_scalar': {'f32': 1, 'f64': 2},
    'gusset_index': {'u32': 0, 'u64': 1},
    'gusset_welding': {'sew': 0, 'none': 1, 'edge_to_edge': 2},
    'gusset_gap': {'auto': 0, 'given': 1},
    'gusset_join_extent': {'loops_and_parts': 0, 'whole_loops': 1, 'parts': 2},
    'gusset_overlaps': {'keep': 0, 'trim': 1},
    'gusset_joint_outcome': {'joined': 0, 'orientation_conflict': 1, 'share_vertex': 2, 'no_strip': 3, 'would_cut':
    4},
    'gusset_left_reason': {'alone': 0, 'not_simple': 1, 'too_short': 2, 'not_joined': 3, 'too_far': 4,
    'same_component': 5, 'looks_away': 6, 'taken': 7, 'excluded': 8},
    'gusset_meridians': {'continuation': 0, 'index': 1, 'arc_length': 2, 'greedy': 3, 'min_diagonal': 4, 'smooth': 5,
    'quad': 6, 'min_area': 7},
    'gusset_strip_search': {'auto': 0, 'exact': 1},
    'gusset_strip_start': {'auto': 0, 'closest': 1, 'given': 2},
    'gusset_fairing': {'none': 0, 'thin_plate': 1},
    'gusset_intersections': {'auto': 0, 'ignore': 1, 'report': 2},
    'gusset_orientation': {'fix': 0, 'refuse': 1, 'keep': 2},
    'gusset_stitch_extent': {'whole_loops': 0, 'open_arcs': 1, 'auto': 2, 'arcs': 3},
    'gusset_facing_run': {'closest': 0, 'longest': 1},
    'gusset_centres': {'vertices': 0, 'length': 1},
    'gusset_row_rule': {'none': 0, 'mean_edge': 1, 'count': 2},
    'gusset_strip_cells': {'triangles': 0, 'quads': 1},
    'gusset_finish': {'strip': 0, 'blend': 1},
    'gusset_tolerance_mode': {'auto': 0, 'given': 1, 'exact': 2},
    'gusset_outward': {'auto': 0, 'keep': 1, 'closed': 2},
    'gusset_fill_keep': {'auto': 0, 'none': 1, 'longest': 2, 'borders': 3},
    'gusset_fill_together': {'apart': 0, 'one': 1, 'cheapest': 2},
    'gusset_fill_refinement': {'none': 0, 'rim_density': 1},
    'gusset_fill_continuity': {'c1': 0, 'c2': 1},
    'gusset_fill_weight': {'continuation': 0, 'area_and_bend': 1, 'bend_then_area': 2, 'area': 3},
    'gusset_patch_finish': {'plain': 0, 'refined': 1, 'faired': 2},
    'gusset_hole_status': {'filled': 0, 'kept': 1, 'too_large': 2, 'open': 3, 'non_manifold': 4, 'not_oriented': 5,
    'not_simple': 6, 'not_free': 7, 'no_triangulation': 8, 'loose': 9, 'unsewn': 10},
    'gusset_weld_vertices': {'boundary': 0, 'all': 1},
    'gusset_collapse': {'never': 0, 'allow': 1},
    'gusset_unused': {'keep': 0, 'remove': 1},
    'gusset_drop_reason': {'degenerate': 0, 'zero_area': 1, 'duplicate': 2, 'inside': 3, 'fin': 4, 'overlap': 5},
    'gusset_alignment_start': {'as_given': 0, 'principal_axes': 1, 'rims': 2, 'features': 3},
    'gusset_aligned_reason': {'trusted': 0, 'no_overlap': 1, 'poor_fit': 2, 'undetermined': 3, 'faces_other_way': 4,
    'other_size': 5, 'trusted_by_none': 6},
    'gusset_non_manifold': {'cut': 0, 'stop': 1},
    'gusset_survey': {'whole_mesh': 0, 'boundary_only': 1},
    'gusset_loop_flags': {'open': 1, 'bow_tie': 2, 'split': 4, 'non_manifold': 8, 'not_oriented': 16, 'zero_length':
    32},
    'gusset_edge_flags': {'reversed': 1, 'non_manifold': 2, 'zero_length': 4},
    'gusset_defect_kind': {'degenerate_face': 1, 'orientation_conflict': 2, 'non_manifold_edge': 3, 'bow_tie': 4},
    'gusset_mesh_flags': {'closed': 1, 'manifold': 2, 'oriented': 4, 'orientable': 8},
    'gusset_distortion': {'symmetric': 0, 'rigid': 1, 'conformal': 2},
    'gusset_chart_finish': {'exact': 0, 'converged': 1, 'iteration_limit': 2, 'conformal': 3, 'not_conformal': 4,
    'folded': 5, 'stalled': 6},
    'gusset_cut_kind': {'given': 0, 'opening': 1, 'dart': 2},
    'gusset_in_plane': {'above': 0, 'below': 1},
    'gusset_cutting_kind': {'stack': 0, 'planes': 1, 'axis': 2, 'curve': 3},
    'gusset_domain': {'vertices': 0, 'corners': 1, 'faces': 2},
    'gusset_value_type': {'f32': 1, 'f64': 2, 'u8': 3, 'u16': 4, 'u32': 5},
    'gusset_rule': {'linear': 0, 'normal': 1, 'skin_weights': 2, 'nearest': 3, 'texture': 4},
    'gusset_net_memory': {'copy': 0, 'borrow': 1},
    'gusset_sides': {'rows_closed': 1, 'columns_closed': 2, 'pole_top': 4, 'pole_bottom': 8, 'pole_left': 16,
    'pole_right': 32, 'sheet': 0, 'tube': 1, 'two_poles': 13, 'one_pole': 60, 'torus': 3},
    'gusset_gluing_kind': {'link': 0, 'star': 1, 'cell': 2, 'diagonal': 3, 'seam': 4, 'type': 5},
    'gusset_gluing_type': {'none': 4294967295, 'horizontal': 0, 'vertical': 1, 'east_south': 2, 'south_west': 3,
    'west_north': 4, 'north_east': 5, 'east_west': 6, 'north_south': 7, 'but_north': 8, 'but_east': 9, 'but_south':
    10, 'but_west': 11, 'all': 12, 'top_bottom': 13, 'right_left': 14, 'point': 15, 'falling': 16, 'rising': 17},
    'gusset_gluing_place': {'node': 0, 'cell': 1},
    'gusset_net_shape': {'plane': 0, 'sphere': 1, 'one_pole_sphere': 2, 'tube': 3, 'cylinder': 4, 'prism': 5, 'cone':
    6, 'pyramid': 7, 'lathe': 8, 'torus': 9, 'box': 10, 'moebius': 11, 'klein': 12, 'projective_plane': 13, 'pillow':
    14},
    'gusset_box_kind': {'slit': 0, 'cross': 1, 'concentric': 2},
    'gusset_axis': {'x': 0, 'y': 1, 'z': 2},
    'gusset_operation_kind': {'translate': 1, 'rotate': 2, 'rotate_as_printed': 3, 'scale': 4, 'compress': 5,
    'stretch': 6, 'matrix': 7},
    'gusset_field_kind': {'affine': 1, 'twist': 2, 'taper': 3, 'bend': 4, 'shear': 5, 'spherify': 6, 'cylinder_wrap':
    7, 'torus_wrap': 8, 'lattice': 9, 'projection': 10, 'parallel': 11, 'perspective': 12, 'cone_wrap': 13,
    'sphere_wrap': 14},
    'gusset_easing': {'linear': 0, 'smooth': 1, 'hold': 2},
    'gusset_net_measures': {'extent': 1, 'bilinear': 2, 'body': 4},
    'gusset_net_faces': {'quads': 0, 'triangles_shorter': 1, 'triangles_fixed': 2},
    'gusset_grid_cells': {'quads': 0, 'triangles': 1},
    'gusset_direction': {'right': 0, 'down': 1},
    'gusset_replication': {'uniform': 0, 'first': 1, 'last': 2, 'at': 3, 'at_poles': 4, 'refuse': 5},
    'gusset_net_turn': {'none': 0, 'quarter': 1, 'half': 2, 'three_quarters': 3, 'flip_columns': 4, 'flip_rows': 5,
    'transpose': 6, 'antitranspose': 7},
    'gusset_interpolation': {'bicubic': 0, 'bilinear': 1},
    'gusset_bridge_mode': {'keep': 0, 'hide': 1, 'weld': 2},
    'gusset_bridge_kind': {'ribbon': 0, 'tube': 1, 'thread': 2},
    'gusset_net_cells': {'all': 0, 'present': 1},
    'gusset_net_flags': {'closed': 1, 'manifold': 2, 'oriented': 4, 'orientable': 8},
    'gusset_morph_path': {'linear': 0, 'rigid': 1},
    'gusset_net_finding_kind': {'link_apart': 0, 'seam_apart': 1, 'loop': 2, 'zero_length': 3, 'few_nodes': 4},
    'gusset_reference_object': {'point': 0, 'plane': 1, 'line': 2, 'segment': 3, 'angle': 4, 'curve': 5, 'surface': 6,
    'ray': 7},
    'gusset_winding': {'counter_clockwise': 0, 'clockwise': 1},
    'gusset_winged_flags': {'non_manifold': 1, 'not_oriented': 2, 'degenerate': 4},
    'gusset_scene_entry_kind': {'net': 0, 'group': 1},
    'gusset_visibility': {'keep': 0, 'show': 1, 'hide': 2},
    'gusset_element': {'none': 0, 'vertex': 1, 'face': 2, 'half_edge': 3, 'offset': 4, 'loop_place': 5, 'count': 6,
    'point': 7, 'constraint': 8, 'place': 9, 'section': 12, 'node': 13, 'link': 14, 'cell': 15, 'seam': 16, 'bridge':
    17, 'entry': 18, 'byte': 19, 'item': 21, 'side_place': 20, 'knot': 30, 'row': 31, 'edge': 32},
    'gusset_stream_mode': {'quantised': 0, 'lossless': 1, 'raw': 2},
    'gusset_stream_levels': {'auto': 0, 'given': 1},
    'gusset_contact_kind': {'point': 1, 'crossing': 2},
    'gusset_scheme': {'six_tap': 0, 'four_point': 1},
    'gusset_twists': {'differences': 0, 'adini': 1, 'zero': 2, 'given': 3},
    'gusset_nearest_flags': {'found': 1, 'proven': 2, 'ambiguous': 4},
    'gusset_normal_kind': {'none': 0, 'regular': 1, 'limit': 2},
    'gusset_hit_selection': {'all': 0, 'first': 1, 'any': 2},
    'gusset_hit_kind': {'none': 0, 'crossing': 1, 'touch': 2, 'inside': 3},
    'gusset_spacing_rule': {'auto': 0, 'chord': 1, 'cell_edges': 2, 'leus': 3},
    'gusset_contour_kind': {'height': 0, 'values': 1, 'angle': 2},
    'gusset_target_kind': {'line': 0, 'plane': 1, 'curve': 2, 'surface': 3},
    'gusset_distance_flags': {'proven': 1, 'meets': 2},
    'gusset_frame_surface': {'sections': 0, 'nodes': 1, 'curves': 2},
    'gusset_sheet_measure_flags': {'diameters': 1, 'curvature': 2, 'crease': 4},
    'gusset_sheet_direction': {'rows': 0, 'columns': 1},
}
