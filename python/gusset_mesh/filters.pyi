"""Types of the filters. Written by generate.py; do not edit."""

# fmt: off
from collections.abc import Sequence
from typing import Any, Literal, Optional, Union

from ._call import Progress
from ._plugin import Curves as Curves, Filter as Filter, Outputs as Outputs, Report as Report
from .mesh import Mesh, MeshLike

CurvesLike = Union[Curves, Any]
all_filters: dict[str, Filter]


def boundary_loops(
    input_0: MeshLike, /, *, non_manifold: Union[int, Literal['cut', 'stop']] = ..., threads: int = ..., progress:
    Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Finds every boundary loop of a mesh as a polyline: a chain of edges with a face on one side only. The surface lies to the left of a loop. Where the boundary touches itself, it is divided into simple loops."""


def stitch(
    input_0: MeshLike, *inputs: MeshLike, loop_a: int = ..., loop_b: int = ..., meridians: Union[int, Literal['continuation',
    'least_area', 'by_index', 'by_arc_length', 'greedy', 'shortest_meridians', 'least_bend', 'quads']] = ..., orientation:
    Union[int, Literal['reverse_it', 'refuse', 'ignore']] = ..., twist: int = ..., extent: Union[int, Literal['whole_loops',
    'facing_arcs', 'automatic']] = ..., run: Union[int, Literal['closest', 'longest']] = ..., tolerance: float = ..., rows:
    Union[int, Literal['none', 'by_mean_edge', 'given_number']] = ..., row_count: int = ..., cells: Union[int, Literal['triangles',
    'quads']] = ..., fairing: Union[int, Literal['straight', 'fair']] = ..., finish: Union[int, Literal['strip', 'blend']] = ...,
    intersections: Union[int, Literal['automatic', 'ignore', 'report']] = ..., outward: bool = ..., threads: int = ..., progress:
    Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Joins two boundary loops, of two meshes or of one, by a closed band of new faces. On request a strip joins only the arcs that face each other. All vertices keep their positions, and all faces stay."""


def weld(
    input_0: MeshLike, /, *, vertices: Union[int, Literal['borders', 'all_vertices']] = ..., tolerance: float = ..., collapse:
    Union[int, Literal['keep', 'collapse']] = ..., unused: Union[int, Literal['keep', 'remove']] = ..., threads: int = ...,
    progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Merges coincident vertices. Either coincident borders are welded edge to edge, whatever the orientation of their faces, or all coincident vertices are merged, as a triangle soup requires."""


def orient(
    input_0: MeshLike, /, *, outward: Union[int, Literal['majority', 'outwards']] = ..., threads: int = ..., progress:
    Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Reverses the fewest faces of each component that make neighbours consistently oriented. One-sided components, such as a Moebius strip, stay as they are."""


def fill(
    input_0: MeshLike, /, *, finish: Union[int, Literal['rim_only', 'refined', 'blend']] = ..., weight: Union[int,
    Literal['best_continuation', 'area_and_bend', 'largest_bend', 'area']] = ..., max_edges: int = ..., max_length: float = ...,
    keep: Union[int, Literal['automatic', 'none', 'the_longest', 'borders']] = ..., together: Union[int, Literal['each_by_itself',
    'all_by_one_patch', 'where_it_costs_less']] = ..., max_diameter: float = ..., max_area: float = ..., intersections: Union[int,
    Literal['automatic', 'ignore', 'report']] = ..., plan_only: bool = ..., continuity: Union[int, Literal['tangents', 'curvature']]
    = ..., ignore_creases: bool = ..., outward: bool = ..., sew: Union[int, Literal['sew', 'leave']] = ..., threads: int = ...,
    progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Closes boundary loops of a mesh by new triangles: the triangulation of least weight, on request refined to the density of the surrounding mesh and faired. All vertices keep their positions, and all faces stay. Before that, borders that coincide with others are sewn, as the filter join does."""


def join(
    input_0: MeshLike, *inputs: MeshLike, weld: Union[int, Literal['sew', 'keep', 'edge_to_edge']] = ..., tolerance: float = ...,
    max_gap: float = ..., extent: Union[int, Literal['loops_and_parts_of_them', 'whole_loops', 'parts']] = ..., meridians:
    Union[int, Literal['continuation', 'least_area', 'by_index', 'by_arc_length', 'greedy', 'shortest_meridians', 'least_bend',
    'quads']] = ..., rows: Union[int, Literal['none', 'by_mean_edge']] = ..., fairing: Union[int, Literal['straight', 'fair']] =
    ..., finish: Union[int, Literal['strip', 'blend']] = ..., holes: Union[int, Literal['leave', 'fill', 'fill_refined_and_fair']] =
    ..., outward: bool = ..., overlaps: Union[int, Literal['keep', 'trim']] = ..., align: bool = ..., keep: Union[int,
    Literal['automatic', 'none', 'the_longest', 'borders']] = ..., max_edges: int = ..., max_length: float = ..., max_diameter:
    float = ..., max_area: float = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Joins many open pieces into one mesh. Overlaps are trimmed on request. Coincident borders are sewn, orientations are made consistent, and loops that face each other across a gap are stitched. Holes are filled on request, and closed results are turned outwards. Loops that face no other loop stay as they are."""


def outline(
    input_0: CurvesLike, /, *, curve: Union[int, Literal['composite', 'cubic_spline', 'blend', 'smooth_blend', 'single', 'chain']] =
    ..., method: Union[int, Literal['bisector', 'median', 'normal', 'symmedian']] = ..., lock: Union[int, Literal['parameter',
    'own_triangle', 'guide']] = ..., joint: Union[int, Literal['halves', 'knots', 'curvature']] = ..., ends: Union[int,
    Literal['free', 'perpendicular', 'level', 'upright', 'level_or_upright']] = ..., corner_angle: float = ..., merge: float = ...,
    chord_error: float = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Draws smooth Bezier curves through all points of polylines, and returns them as finer polylines. By default the curve consists of quadratic sections, one for each point. The bisector, the median or the normal at the point determines the point's parameter on its section; the control point lies near this line. With the constraint Guide it lies on the line, where this is possible."""


def net_shape(
    *, shape: Union[int, Literal['sphere', 'one_pole_sphere', 'plane', 'tube', 'cylinder', 'cone', 'torus', 'cube', 'moebius_strip',
    'klein_bottle', 'prism', 'pyramid', 'projective_plane', 'pillow']] = ..., rows: int = ..., columns: int = ..., radius: float =
    ..., minor_radius: float = ..., height: float = ..., triangles: bool = ..., sides: int = ..., threads: int = ..., progress:
    Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Makes a standard shape as a quad grid. Rows and columns of faces continue across its seams, and a side contracted to a pole is one vertex."""


def deform(
    input_0: MeshLike, /, *, field: Union[int, Literal['twist', 'taper', 'bend', 'shear', 'spherify', 'cylinder_wrap', 'cone_wrap',
    'torus_wrap', 'sphere_wrap']] = ..., axis: Union[int, Literal['z', 'x', 'y']] = ..., amount: float = ..., strength: float = ...,
    radius: float = ..., minor_radius: float = ..., lean: float = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> Mesh:
    """Moves the vertices of a mesh by a deformation field: twist, taper, bend or shear about an axis, projection towards a sphere, or a wrap, which rolls a sheet onto a cylinder, a cone, a torus or a sphere. Faces do not change, and coincident vertices stay coincident."""


def smooth_surface(
    input_0: MeshLike, /, *, scheme: Union[int, Literal['smooth', 'four_points']] = ..., deviation: float = ..., parts: int = ...,
    triangles: bool = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Draws a smooth surface through the vertices of a quad grid, and returns it as a finer mesh. Its vertices lie on the surface, and its faces deviate from it at most as requested."""


def smooth_sections(
    input_0: MeshLike, /, *, scheme: Union[int, Literal['smooth', 'four_points']] = ..., direction: Sequence[float] = ...,
    placement: Union[int, Literal['even', 'given']] = ..., number: int = ..., offset: float = ..., distance: float = ...,
    chord_error: float = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Cuts the smooth surface through the vertices of a quad grid by parallel planes, and returns the curves in order. No curve is missed. Points lie on the surface, not on the quads."""


def smooth_silhouette(
    input_0: MeshLike, /, *, scheme: Union[int, Literal['smooth', 'four_points']] = ..., direction: Sequence[float] = ..., angle:
    float = ..., chord_error: float = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Finds where the normals of the smooth surface through the vertices of a quad grid make a given angle with a direction. The angle pi / 2 gives the silhouettes seen along the direction; other angles give lines of equal slope."""


def smooth_distance(
    input_0: MeshLike, input_1: MeshLike, /, *, scheme: Union[int, Literal['smooth', 'four_points']] = ..., strength: float = ...,
    threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Measures the distances of the vertices of a mesh from a smooth surface, and moves them towards their nearest points on it. The surface passes through the vertices of a quad grid, the second mesh."""


def check(
    input_0: MeshLike, /, *, listed: int = ..., intersections: bool = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> Report:
    """Reports every defect of a mesh with the numbers of the elements: boundary edges, edges of three or more faces, non-manifold vertices, inconsistently oriented, duplicate, degenerate and zero-area faces, unused vertices; and the number of components, the Euler characteristic and the genus. On request it reports faces that intersect each other."""


def facing_arcs(
    input_0: CurvesLike, /, *, curve_a: int = ..., curve_b: int = ..., run: Union[int, Literal['closest', 'longest']] = ...,
    centres: Union[int, Literal['mean_of_the_points', 'mean_of_the_curve']] = ..., tolerance: float = ..., threads: int = ...,
    progress: Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Finds the points of two loops that face each other. A point faces the other loop if it lies on that side of the plane through the centre of its own loop. The arcs that stitching would join come first, then the other arcs."""


def strip(
    input_0: CurvesLike, /, *, meridians: Union[int, Literal['continuation', 'least_area', 'by_index', 'by_arc_length', 'greedy',
    'shortest_meridians', 'least_bend', 'quads']] = ..., start: Union[int, Literal['automatic', 'closest_pair', 'first_points']] =
    ..., reversed: bool = ..., rows: Union[int, Literal['none', 'by_mean_edge', 'given_number']] = ..., row_count: int = ..., cells:
    Union[int, Literal['triangles', 'quads']] = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Spans a strip of faces between two polylines, both closed or both open, that run side by side in the same direction."""


def net_resample(
    input_0: MeshLike, /, *, rows: int = ..., columns: int = ..., interpolation: Union[int, Literal['cubic', 'bilinear']] = ...,
    triangles: bool = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Resamples a quad grid to other numbers of rows and columns, evenly spaced over the old ones. Closed sides and poles are kept."""


def net_decimate(
    input_0: MeshLike, /, *, tolerance: float = ..., triangles: bool = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Removes rows and columns of a quad grid, always the one with the least deviation, up to a tolerance. The remaining vertices keep their positions."""


def net_join(
    input_0: MeshLike, input_1: MeshLike, *inputs: MeshLike, direction: Union[int, Literal['below', 'right']] = ..., bridge:
    Union[int, Literal['quads', 'nothing', 'weld']] = ..., tolerance: float = ..., sizes: Union[int, Literal['repeat_evenly',
    'repeat_the_first', 'repeat_the_last', 'refuse']] = ..., twist: int = ..., turn: bool = ..., triangles: bool = ..., threads: int
    = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Joins quad grids side by side into one. The rows or columns of each grid follow the grid before it, after a row of new quads or welded. Rows of smaller grids are replicated to fit."""


def net_measures(
    input_0: MeshLike, /, *, planarity: float = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> Report:
    """Measures a quad grid as a surface of bilinear patches: area, bounding box, planarity of the quads and topology. A closed grid also has volume, centroid and inertia tensor."""


def net_analyse(
    input_0: MeshLike, input_1: MeshLike, /, *, tolerance: float = ..., listed: int = ..., threads: int = ..., progress:
    Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Compares a quad grid before a deformation with the same mesh after it. It returns the edges that were contracted or torn, as segments of the original grid, and lists the quads that were folded. A deformation without any of these is soft."""


def net_lathe(
    input_0: CurvesLike, /, *, point: Sequence[float] = ..., direction: Sequence[float] = ..., columns: int = ..., rows: int = ...,
    between: Union[int, Literal['straight', 'smooth', 'cubic_spline']] = ..., triangles: bool = ..., threads: int = ..., progress:
    Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Revolves a curve about an axis. The result is a quad grid whose rows are circles, with a pole where the curve meets the axis. Only the height of each point along the axis and its distance from the axis count."""


def displace(
    input_0: MeshLike, /, *, distance: float = ..., triangles: bool = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> Mesh:
    """Moves every vertex of a quad grid along the surface normal. Poles and seams stay closed."""


def project(
    input_0: MeshLike, /, *, plane: Sequence[float] = ..., along: Union[int, Literal['normal', 'direction',
    'lines_through_a_point']] = ..., direction: Sequence[float] = ..., eye: Sequence[float] = ..., strength: float = ..., threads:
    int = ..., progress: Optional[Progress] = ...,
) -> Mesh:
    """Projects the vertices of a mesh onto a plane, along a direction or through a point, or moves them a fraction of the way. Faces do not change."""


def curve_measures(
    input_0: CurvesLike, /, *, between: Union[int, Literal['straight', 'smooth', 'cubic_spline']] = ..., threads: int = ...,
    progress: Optional[Progress] = ...,
) -> Report:
    """Measures curves: length, bounding box and enclosed area. A curve that is not plane has the area of its largest projection. An open curve is closed by its chord."""


def curve_resample(
    input_0: CurvesLike, /, *, between: Union[int, Literal['straight', 'smooth', 'cubic_spline']] = ..., spacing: Union[int,
    Literal['number', 'step', 'chord_error']] = ..., number: int = ..., step: float = ..., chord_error: float = ..., threads: int =
    ..., progress: Optional[Progress] = ...,
) -> Curves:
    """Resamples curves: a given number of points, points at a given spacing, or the fewest points that keep the polyline within the chord error of the curve."""


def curve_offset(
    input_0: CurvesLike, /, *, between: Union[int, Literal['straight', 'smooth', 'cubic_spline']] = ..., plane: Sequence[float] =
    ..., distance: float = ..., chord_error: float = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Draws the offset curves of plane curves, on their left as seen against the normal of the plane. Straight segments join the corners. An offset intersects itself where the distance exceeds the radius of curvature."""


def curve_meet(
    input_0: CurvesLike, /, *, between: Union[int, Literal['straight', 'smooth', 'cubic_spline']] = ..., within: float = ...,
    threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Finds where curves intersect, or pass each other within a distance. Each place is a curve of one point, midway between the two curves. Self-intersections are found for curves in the plane z = 0."""


def curve_nearest(
    input_0: CurvesLike, input_1: CurvesLike, /, *, between: Union[int, Literal['straight', 'smooth', 'cubic_spline']] = ...,
    threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Finds the nearest point on any curve of the second input for each point of the first. It draws the segments between them and reports their lengths."""


def curve_svg(
    input_0: CurvesLike, /, *, between: Union[int, Literal['straight', 'smooth', 'cubic_spline']] = ..., plane: Sequence[float] =
    ..., downwards: bool = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> Report:
    """Writes plane curves as the data of SVG paths, one line for each curve. Numbers keep every bit. Smooth curves become Bezier curves."""


def loft(
    input_0: CurvesLike, /, *, nodes: Union[int, Literal['by_arc_length', 'by_number', 'by_angle']] = ..., columns: int = ...,
    corner_angle: float = ..., through: Union[int, Literal['sections', 'nodes', 'curves']] = ..., ring: bool = ..., point:
    Sequence[float] = ..., direction: Sequence[float] = ..., deviation: float = ..., parts: int = ..., triangles: bool = ...,
    threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Draws a smooth surface through consecutive sections of a body, all closed or all open. A section of one point is a tip. Corners of sections stay sharp. Between two equal sections, the surface is their cylinder. Sections that repeat the previous one are left out, and the report names them."""


def smooth_net(
    input_0: CurvesLike, *inputs: CurvesLike, between: Union[int, Literal['straight', 'smooth', 'cubic_spline']] = ..., ring: bool =
    ..., tolerance: float = ..., deviation: float = ..., parts: int = ..., triangles: bool = ..., threads: int = ..., progress:
    Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Draws the smooth surface that contains all curves of a network, as a mesh. The first input has the curves across, and a second input may have curves along. Each curve along meets all curves across. The curves may be listed in any order. Curves across alone are skinned in the given order."""


def smooth_isophotes(
    input_0: MeshLike, /, *, scheme: Union[int, Literal['smooth', 'four_points']] = ..., direction: Sequence[float] = ..., number:
    int = ..., sides: Union[int, Literal['both', 'alike']] = ..., chord_error: float = ..., threads: int = ..., progress:
    Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Draws isophotes of the smooth surface through the vertices of a quad grid: curves on which the normals make one of several equally spaced angles with a direction. Where isophotes are not smooth, the surface is not fair."""


def smooth_intersect(
    input_0: MeshLike, input_1: MeshLike, /, *, scheme: Union[int, Literal['smooth', 'four_points']] = ..., chord_error: float =
    ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Finds the intersection curves of the smooth surfaces through the vertices of two quad grids. No branch is missed. Points where the surfaces touch or branches cross are resolved. Cells where the surfaces touch along a curve or coincide count as unresolved."""


def smooth_line(
    input_0: MeshLike, /, *, scheme: Union[int, Literal['smooth', 'four_points']] = ..., point: Sequence[float] = ..., direction:
    Sequence[float] = ..., which: Union[int, Literal['all_of_the_line', 'all_of_the_ray', 'first_of_the_ray']] = ..., threads: int =
    ..., progress: Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Finds where a line or a ray intersects the smooth surface through the vertices of a quad grid. Each intersection is a curve of one point; the report has its distance from the given point and the normal. No intersection is missed."""


def smooth_curve(
    input_0: MeshLike, input_1: CurvesLike, /, *, scheme: Union[int, Literal['smooth', 'four_points']] = ..., between: Union[int,
    Literal['straight', 'smooth', 'cubic_spline']] = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Finds where curves intersect the smooth surface through the vertices of a quad grid. Each intersection is a curve of one point. No intersection is missed."""


def smooth_nearest(
    input_0: MeshLike, input_1: CurvesLike, /, *, scheme: Union[int, Literal['smooth', 'four_points']] = ..., threads: int = ...,
    progress: Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Finds the nearest point on the smooth surface through the vertices of a quad grid for each point of some curves. It draws the segments between them and reports their lengths, and how many nearest points are not proven."""


def sew(
    input_0: MeshLike, /, *, tolerance: float = ..., unused: Union[int, Literal['keep', 'remove']] = ..., threads: int = ...,
    progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Welds coincident borders, even if their vertices do not match. An edge is split where a vertex of another border lies on it, if the parts then coincide in pairs. Triangles with split edges are cut into triangles; larger faces gain corners."""


def align(
    input_0: MeshLike, *inputs: MeshLike, start: Union[int, Literal['as_they_lie', 'principal_axes', 'rims', 'features']] = ...,
    max_distance: float = ..., samples: int = ..., max_rounds: int = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Moves all pieces rigidly to where they fit: pieces that overlap, or parts of one broken surface. The first piece stays. The result is one mesh of all pieces, not joined. The report says whether the place of each piece, counted from 0, can be trusted. It gives the motion of the piece as three rows of four numbers: a rotation and a translation. Normals that vertices carry keep their directions."""


def trim(
    input_0: MeshLike, *inputs: MeshLike, max_distance: float = ..., max_angle: float = ..., min_faces: int = ..., threads: int =
    ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Keeps one piece of each overlap, and leaves a narrow gap to the other pieces. The pieces must be in their final places. The result is one mesh of all kept faces, not joined. No vertex moves, and no face is cut. The report counts pieces from 0."""


def develop(
    input_0: MeshLike, /, *, distortion: Union[int, Literal['lengths_and_areas', 'as_rigid_as_possible', 'angles']] = ..., darts:
    int = ..., stretch: float = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Lays a surface out in the plane, as a pattern to cut it from. A surface that is not a disc is opened along short paths. A developable surface keeps every length. Any other surface gets the least distortion, without folds or overlaps. Darts reduce the distortion further."""


def net_planarise(
    input_0: MeshLike, /, *, tolerance: float = ..., keep_boundary: bool = ..., max_steps: int = ..., threads: int = ..., progress:
    Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Moves the vertices of a quad grid as little as possible until all faces are planar, as panels of glass or sheet metal are. Failure to converge is not an error; the report tells it."""


def net_settle(
    input_0: MeshLike, input_1: MeshLike, *inputs: MeshLike, direction: Union[int, Literal['below', 'right']] = ..., rows: int =
    ..., tension: float = ..., elasticity: float = ..., stiffness: float = ..., rest_ratio: float = ..., sizes: Union[int,
    Literal['repeat_evenly', 'repeat_the_first', 'repeat_the_last', 'refuse']] = ..., twist: int = ..., turn: bool = ..., max_steps:
    int = ..., triangles: bool = ..., threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Joins quad grids side by side into one by bridges of several rows, and moves the rows of the bridges to the equilibrium of their tension, elasticity and stiffness. The given grids keep their positions. A bridge between closed sides is a tube, whose tension acts like a soap film. Failure to converge is not an error; the report tells it."""


def morph(
    input_0: MeshLike, input_1: MeshLike, /, *, ratio: float = ..., path: Union[int, Literal['straight', 'with_rotation']] = ...,
    threads: int = ..., progress: Optional[Progress] = ...,
) -> Mesh:
    """Interpolates between two meshes with the same faces, such as a mesh and a deformed copy of it. Vertices correspond by their numbers. Faces and attributes come from the first mesh."""


def lattice(
    input_0: MeshLike, input_1: MeshLike, input_2: MeshLike, /, *, strength: float = ..., threads: int = ..., progress:
    Optional[Progress] = ...,
) -> Mesh:
    """Deforms a mesh by a lattice around it. The second mesh is the lattice at rest: its vertices lie on a uniform grid along the coordinate axes, like the vertices of a box or of a subdivided cube. The third mesh is the lattice with its vertices moved. Vertices of the first mesh inside the lattice follow; vertices outside stay. Grid points without a vertex follow the vertices around them."""


def repair(
    input_0: MeshLike, /, *, tolerance: float = ..., keep: Union[int, Literal['automatic', 'none', 'the_longest', 'borders']] = ...,
    leave_borders: bool = ..., leave_flat_faces: bool = ..., leave_duplicates: bool = ..., leave_holes: bool = ...,
    leave_non_manifold: bool = ..., leave_fins: bool = ..., leave_intersections: bool = ..., leave_orientation: bool = ..., threads:
    int = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Removes the defects of a mesh, to get a valid solid where possible. Changes only faces at defects. Sews borders, drops faces without area and duplicate faces, fills holes, separates sheets that share edges or vertices, drops walls within the solid, and turns closed components outwards. Replaces closed components that intersect by their union. Lists what was dropped."""


def unite(
    input_0: MeshLike, *inputs: MeshLike, threads: int = ..., progress: Optional[Progress] = ...,
) -> tuple[Mesh, Report]:
    """Replaces closed meshes by their union, without intersecting faces. Meshes may intersect, touch, coincide or lie within each other. Faces that no other meets stay as they are. Lists how many faces were dropped."""


def section(
    input_0: MeshLike, /, *, cut: Union[int, Literal['automatic', 'faces', 'smooth_surface']] = ..., placement: Union[int,
    Literal['even', 'given', 'about_an_axis']] = ..., direction: Sequence[float] = ..., number: int = ..., offset: float = ...,
    distance: float = ..., point: Sequence[float] = ..., tolerance: float = ..., in_plane: Union[int, Literal['above', 'below']] =
    ..., scheme: Union[int, Literal['smooth', 'four_points']] = ..., chord_error: float = ..., threads: int = ..., progress:
    Optional[Progress] = ...,
) -> tuple[Curves, Report]:
    """Cuts a mesh by parallel planes or by planes about an axis, and returns the curves in order. A closed mesh gives closed curves only: each vertex is on a side of each plane exactly. Around a solid, outer curves run counter-clockwise seen against the normal, curves around holes clockwise. A grid of quads is cut as the smooth surface through its vertices, unless its faces are chosen."""
