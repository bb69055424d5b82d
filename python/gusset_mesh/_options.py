"""Keywords of structs of options, with what the C headers say of them. Written by generate.py; do not edit."""

# fmt: off
from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import Any, Literal, Optional

from numpy.typing import ArrayLike

if sys.version_info >= (3, 12):
    from typing import TypedDict, Unpack
else:
    from typing_extensions import TypedDict, Unpack

__all__ = ["FIELDS", "Unpack", "WeldOptions", "OrientOptions", "BoundaryOptions", "StitchOptions", "FillOptions", "TrimOptions", "JoinOptions", "AlignOptions", "OutlineOptions", "OffsetOptions", "NetMeshOptions", "ConcatenateOptions", "SurfaceOptions", "NearestOptions", "ContourOptions", "IntersectionOptions", "SheetMeshOptions", "DevelopOptions"]


class WeldOptions(TypedDict, total=False):
    """Fields of ``gusset_weld_options``; what is not given is as by default."""

    #: Vertices that are welded.
    vertices: Literal['boundary', 'all']
    #: Distance at which vertices coincide. - GUSSET_TOLERANCE_GIVEN: at most tolerance. - GUSSET_TOLERANCE_EXACT: 0;
    #: -0 equals 0. - GUSSET_TOLERANCE_AUTO: at most 2^-19 of the largest coordinate for 32-bit positions, 2^-48 for
    #: 64-bit ones, or, if more, twice the last decimal place that positions show. At each vertex it is at most a
    #: quarter of the shortest edge, so that no edge collapses. - Last decimal place: let D be the largest power of
    #: ten up to the longest side of the box of the vertices. The place is the largest of 1e-5 D, 1e-6 D, ... of which
    #: a third of the coordinates of the largest order of magnitude, or of the differences between consecutive
    #: vertices, are multiples. Multiples of 1e-4 D are left out; at least eight other numbers are needed.
    tolerance_mode: Literal['auto', 'given', 'exact']
    #: Largest distance of coincident vertices, finite, at least 0.
    tolerance: float
    #: Treatment of coincident corners of one face.
    collapse: Literal['never', 'allow']
    #: Treatment of vertices that no face uses.
    unused: Literal['keep', 'remove']


class OrientOptions(TypedDict, total=False):
    """Fields of ``gusset_orient_options``; what is not given is as by default."""

    #: Orientation of closed components.
    outward: Literal['auto', 'keep', 'closed']


class BoundaryOptions(TypedDict, total=False):
    """Fields of ``gusset_boundary_options``; what is not given is as by default."""

    #: Treatment of edges with three or more faces.
    non_manifold: Literal['cut', 'stop']
    #: Part of the mesh that is checked.
    survey: Literal['whole_mesh', 'boundary_only']


class StitchOptions(TypedDict, total=False):
    """Fields of ``gusset_stitch_options``; what is not given is as by default."""

    #: Rule for the meridians.
    meridians: Literal['continuation', 'index', 'arc_length', 'greedy', 'min_diagonal', 'smooth', 'quad', 'min_area']
    #: Treatment of opposite orientations.
    orientation: Literal['fix', 'refuse', 'keep']
    #: Shift of the first meridian along rim B, in vertices, from the closest pair that no edge joins. Counted in the
    #: direction of rim A, modulo the length of rim B. If not 0, no other start is tried. Must be 0 if arcs are joined
    #: (OUT_OF_RANGE).
    twist: int
    #: Part of the loops to join.
    extent: Literal['whole_loops', 'open_arcs', 'auto', 'arcs']
    #: Choice among runs of facing vertices.
    run: Literal['closest', 'longest']
    #: Number of interior rows.
    rows: Literal['none', 'mean_edge', 'count']
    #: Interior rows.
    row_count: int
    #: Faces of the strip.
    cells: Literal['triangles', 'quads']
    #: Source of the tolerance.
    tolerance_mode: Literal['auto', 'given', 'exact']
    #: Facing vertices are farther than this from the plane of their loop. In the unit of the positions; finite, at
    #: least 0.
    tolerance: float
    #: First index on loop A, and number of vertices, 1 to the loop's length. The arc follows the loop as given, and
    #: may pass its end.
    arc_a: Sequence[float]
    #: As arc_a, for loop B.
    arc_b: Sequence[float]
    #: Search effort.
    search: Literal['auto', 'exact']
    #: First meridian of a closed strip.
    start: Literal['auto', 'closest', 'given']
    #: Positions of interior rows; ignored without rows, with a log message if set.
    fairing: Literal['none', 'thin_plate']
    #: The treatment of faces that intersect each other.
    intersections: Literal['auto', 'ignore', 'report']
    #: Centre of a loop.
    centres: Literal['vertices', 'length']
    #: The side that closed components of a result face.
    outward: Literal['auto', 'keep', 'closed']
    #: Surface between the rims.
    finish: Literal['strip', 'blend']


class FillOptions(TypedDict, total=False):
    """Fields of ``gusset_fill_options``; what is not given is as by default."""

    #: Weight that the triangulation of a hole minimises.
    weight: Literal['continuation', 'area_and_bend', 'bend_then_area', 'area']
    #: New vertices of patches.
    refine: Literal['none', 'rim_density']
    #: Fairing of new vertices. Without new vertices it is ignored, and the log says so.
    fairing: Literal['none', 'thin_plate']
    #: Loops that stay open. Read only if all loops are selected.
    keep: Literal['none', 'longest', 'borders']
    #: Treatment of patch faces that intersect each other or old faces: GUSSET_INTERSECTIONS_AUTO avoids them, REPORT
    #: reports them, IGNORE does not look for them.
    intersections: Literal['auto', 'ignore', 'report']
    #: If 1, fills and turns over nothing. The report says which loops would be filled, by which weight and finish. It
    #: does not predict failed triangulations or shared patches.
    plan_only: bool
    #: Approximate limit on the new vertices of a patch, kept by larger triangles, exceeded at most twofold. 0:
    #: 50,000, or 4 for each rim vertex if more, and as many again for sharp angles there.
    max_new_vertices: int
    #: Most edges of a loop to fill. 0: no limit.
    max_edges: int
    #: Largest length of a loop to fill, at least 0. 0: no limit.
    max_length: float
    #: Largest diagonal of the axis-aligned box of a loop to fill, at least 0. 0: no limit.
    max_diameter: float
    #: Largest area, as in gusset_hole, of a loop to fill, at least 0. 0: no limit.
    max_area: float
    #: Orientation of closed components of the result, patches included.
    outward: Literal['auto', 'keep', 'closed']
    #: Choice of loops that share a patch. Read only without groups.
    together: Literal['apart', 'one', 'cheapest']
    #: Group number of each given loop, loop_count in all. Loops with equal numbers share a patch of genus 0, without
    #: loops left open for their own reasons. NULL: see together.
    groups: ArrayLike
    #: Smoothness between faired patches and the old surface.
    continuity: Literal['c1', 'c2']
    #: If 1, creases of the old surface end at the rim.
    ignore_creases: bool


class TrimOptions(TypedDict, total=False):
    """Fields of ``gusset_trim_options``; what is not given is as by default."""

    #: Largest distance of surfaces that count as one, in the unit of the positions, finite, at least 0. 0: 4 mean
    #: edges of the coarser piece.
    max_distance: float
    #: Largest angle between their normals, in radians, at least 0, below pi / 2; 0: 60 degrees.
    max_angle: float
    #: x, y, z for each piece, in the unit of the positions, or NULL. Parts seen at flat angles weigh less.
    viewpoints: ArrayLike
    #: Islands of fewer faces are removed; 0: 30. The limit is 20 times as large for islands that other pieces also
    #: show. Holes below that limit are not made.
    min_faces: int


class AlignOptions(TypedDict, total=False):
    """Fields of ``gusset_alignment_options``; what is not given is as by default."""

    #: Initial poses.
    start: Literal['as_given', 'principal_axes', 'rims']
    #: Points of each piece to match; 0: 2,000.
    samples: int
    #: Rigid motions of the pieces, or NULL.
    poses: ArrayLike
    #: Largest distance of matched points, in the unit of the positions, finite, at least 0. 0: a tenth of the largest
    #: piece's box diagonal. Pieces may start about this far from their final poses.
    max_distance: float
    #: Rounds in each of two stages, at most; 0: 100.
    max_rounds: int


class OutlineOptions(TypedDict, total=False):
    """Fields of ``gusset_outline_options``; what is not given is as by default."""

    #: Kind of an outline's curve.
    curve: Literal['composite', 'single', 'blend_c1', 'blend_c2', 'cubic_c2', 'chain']
    #: Guide of a section's control point.
    method: Literal['bisector', 'median', 'normal', 'symmedian', 'alpha']
    #: For composite and single curves.
    lock: Literal['parameter', 'self_consistent', 'data_guide']
    #: For composite curves and chains.
    joint: Literal['half', 'knot', 'g2']
    #: Method of solution.
    solver: Literal['fast', 'step']
    #: For open outlines and parts between corners. A constraint on the end tangent takes precedence.
    ends: Literal['free', 'perpendicular', 'level', 'upright', 'level_or_upright']
    #: 0 to 1.
    alpha: float
    #: Composite parameters are clamped to this and 1 minus this: 0.001 to 1/2; 0: 1/6.
    parameter_limit: float
    #: Largest distance of neighbours that are merged, below 1; 0: 1e-12. 1e-300 merges equal points only.
    repeat_tolerance: float
    #: Points where the polygon turns by more are corners. At least 0; 0, or pi and more: none.
    corner_angle: float
    #: Iterations end when no move exceeds it; below 1; 0: 1e-12.
    tolerance: float
    #: Maximum sweeps or iterations between two corners; 0: 200.
    max_sweeps: int
    #: Maximum steps at a point in a sweep; 0: 20,000.
    max_steps: int


class OffsetOptions(TypedDict, total=False):
    """Fields of ``gusset_offset_options``; what is not given is as by default."""

    #: Wanted deviation, above 0.
    tolerance: float
    #: No segment is halved at this number of segments; 0: 65536.
    max_segments: int
    #: Degree of segments, 2 or 3; 0: 3.
    degree: int


class NetMeshOptions(TypedDict, total=False):
    """Fields of ``gusset_net_mesh_options``; what is not given is as by default."""

    #: Faces of a net's mesh.
    faces: Literal['quads', 'triangles_shorter', 'triangles_fixed']
    #: 1: one vertex for each node, nothing glued; 0: glued nodes are one vertex.
    no_weld: bool
    #: 1: keeps finite vertices without faces and wires.
    keep_unused: bool
    #: 1: a cell with exactly one missing corner becomes a triangle.
    fill_corners: bool
    #: 1: computes texture coordinates.
    texture: bool
    #: Omits faces with edges longer than this multiple of the median edge; 0: no limit. For range images, 4 removes
    #: faces across depth jumps.
    max_edge_ratio: float


class ConcatenateOptions(TypedDict, total=False):
    """Fields of ``gusset_concatenate_options``; what is not given is as by default."""

    #: For welding: largest distance of coincident nodes, at least 0.
    tolerance: float
    #: Direction from each net to the next.
    direction: Literal['right', 'down']
    #: Treatment of the cells of a bridge.
    mode: Literal['keep', 'hide', 'weld']
    #: Enlargement of nets with fewer nodes along the side.
    equalise: Literal['uniform', 'first', 'last', 'at', 'at_poles', 'refuse']
    #: Row or column to replicate.
    equalise_index: int
    #: Rotation of each net except the first along its closed side, in nodes.
    twist: int
    #: 1: flips nets along the side if their orientation differs from the first; 0: refuses them.
    turn: bool
    #: Inner rows or columns of each new bridge, evenly on straight lines; 0 for GUSSET_BRIDGE_WELD.
    rows: int


class SurfaceOptions(TypedDict, total=False):
    """Fields of ``gusset_surface_options``; what is not given is as by default."""

    #: Length to which answers are proved, finite; 0: 1e-9 of the surface's box diagonal.
    tolerance: float
    #: 1: builds the cones of normals for GUSSET_CONTOUR_ANGLE and gusset_surface_nearest_angle, about 0.7 bytes a
    #: node; 0: the first such query builds them.
    cones: bool


class NearestOptions(TypedDict, total=False):
    """Fields of ``gusset_nearest_options``; what is not given is as by default."""

    #: Largest distance of a point, at least 0; 0 or INFINITY: no limit.
    limit: float
    #: For minima: maximum number, the nearest first; 0: all.
    max_count: int


class ContourOptions(TypedDict, total=False):
    """Fields of ``gusset_contour_options``; what is not given is as by default."""

    #: A length above 0, finite. Values below the surface's tolerance act as the tolerance.
    chord: float
    #: Curve points between crossings with cell sides.
    spacing: Literal['auto', 'chord', 'cell_edges', 'leus']
    #: Points between two crossings, at most 1000.
    points: int


class IntersectionOptions(TypedDict, total=False):
    """Fields of ``gusset_intersection_options``; what is not given is as by default."""

    #: Largest distance of the curve from its chords, above 0 and finite. Estimated: rare chords exceed it by about 15
    #: %. At least the smallest of `tolerance` and the surfaces' tolerances applies.
    chord: float
    #: Two surfaces touch where their gap or overlap stays within this length. Finite; 0: the smaller tolerance of the
    #: surfaces. Self-intersections use at most the surface's tolerance. Branches shorter than it and the surfaces'
    #: tolerances may be lost.
    tolerance: float
    #: Not GUSSET_POINT_SPACING_LEUS. GUSSET_POINT_SPACING_AUTO refers to the smaller surface.
    spacing: Literal['auto', 'chord', 'cell_edges', 'leus']


class SheetMeshOptions(TypedDict, total=False):
    """Fields of ``gusset_sheet_mesh_options``; what is not given is as by default."""

    #: Largest distance of triangles from the surface, above 0; 0 or INFINITY: unlimited.
    tolerance: float
    #: Minimum parts of each cell in u; 0: 1.
    min_u: int
    #: Minimum parts of each cell in v; 0: 1.
    min_v: int
    #: 1: triangles only; 0: quads, with triangles at poles.
    triangles: bool


class DevelopOptions(TypedDict, total=False):
    """Fields of ``gusset_develop_options``; what is not given is as by default."""

    #: Distortion that a development minimises.
    distortion: Literal['symmetric', 'rigid', 'conformal']
    #: Largest number of darts: cuts from the border of a chart to where it is curved.
    max_darts: int
    #: Vertices of the paths to cut along, path after path. Consecutive vertices are connected by the shortest path
    #: along edges. A path of one vertex cuts nothing.
    cuts: ArrayLike
    #: Start of each path in cuts, and the end of the last. Empty: one path.
    cut_offsets: ArrayLike
    #: Darts stop once no length changes by a larger factor, finite and above 1. 0: no limit.
    max_stretch: float
    #: Largest number of steps of a descent. Charts whose border would meet itself, and GUSSET_DISTORTION_RIGID, need
    #: several descents. 0: 200.
    max_iterations: int


class JoinOptions(TypedDict, total=False):
    """Fields of ``gusset_join_options``; what is not given is as by default."""

    #: Treatment of coincident borders.
    weld: Literal['sew', 'none', 'edge_to_edge']
    #: GUSSET_ORIENTATION_FIX reverses the minority of faces in each component, then components against the ones that
    #: they face. GUSSET_ORIENTATION_KEEP reverses nothing, and ignores outward.
    orientation: Literal['fix', 'keep']
    #: Widest gap to close.
    gap: Literal['auto', 'given']
    #: 1 joins whole loops only, not runs and slits.
    whole_loops_only: bool
    #: 1 also joins loops of one component that pairs does not name.
    within_components: bool
    #: 1 fills the remaining holes.
    fill: bool
    #: Widest gap to close, in the unit of the positions, finite, at least 0; 0 closes none.
    max_gap: float
    #: Pairs of whole loops to join at any distance, or NULL. A pair names two loops, or a slit twice (see
    #: gusset_joint). No loop is in two pairs.
    pairs: ArrayLike
    #: Pairs not to join, or NULL; pairs takes precedence. A vertex that is on no loop after welding excludes nothing.
    excluded: ArrayLike
    #: Options of welding; NULL for the defaults.
    weld_options: WeldOptions
    #: Options of strips; NULL for the defaults. Only meridians, search, start, rows, row_count, cells, fairing,
    #: intersections and finish are used; all must be valid.
    strip_options: StitchOptions
    #: Options of filling; NULL for the defaults. groups, outward and plan_only are ignored, but outward and plan_only
    #: must be valid. GUSSET_INTERSECTIONS_REPORT acts as GUSSET_INTERSECTIONS_IGNORE.
    fill_options: FillOptions
    #: Side that closed components face, by default outwards, walls of cavities included. Other components mostly keep
    #: the orientation of the first piece.
    outward: Literal['auto', 'keep', 'closed']
    #: Treatment of overlapping pieces.
    overlaps: Literal['keep', 'trim']
    #: Options of trimming; NULL for the defaults.
    trim_options: TrimOptions


#: By struct: of each keyword its kind, the numbers of its words, and the field and word that it is read for.
FIELDS: dict[str, dict[str, tuple[str, dict[str, int], Optional[tuple[str, str]]]]] = {
    "gusset_weld_options": {
        "vertices": ('choice', {'boundary': 0, 'all': 1}, None),
        "tolerance_mode": ('choice', {'auto': 0, 'given': 1, 'exact': 2}, None),
        "tolerance": ('float', {}, ('tolerance_mode', 'given')),
        "collapse": ('choice', {'never': 0, 'allow': 1}, None),
        "unused": ('choice', {'keep': 0, 'remove': 1}, None),
    },
    "gusset_orient_options": {
        "outward": ('choice', {'auto': 0, 'keep': 1, 'closed': 2}, None),
    },
    "gusset_boundary_options": {
        "non_manifold": ('choice', {'cut': 0, 'stop': 1}, None),
        "survey": ('choice', {'whole_mesh': 0, 'boundary_only': 1}, None),
    },
    "gusset_stitch_options": {
        "meridians": ('choice', {'continuation': 0, 'index': 1, 'arc_length': 2, 'greedy': 3, 'min_diagonal': 4, 'smooth': 5, 'quad': 6, 'min_area': 7}, None),
        "orientation": ('choice', {'fix': 0, 'refuse': 1, 'keep': 2}, None),
        "twist": ('int', {}, None),
        "extent": ('choice', {'whole_loops': 0, 'open_arcs': 1, 'auto': 2, 'arcs': 3}, None),
        "run": ('choice', {'closest': 0, 'longest': 1}, None),
        "rows": ('choice', {'none': 0, 'mean_edge': 1, 'count': 2}, None),
        "row_count": ('int', {}, ('rows', 'count')),
        "cells": ('choice', {'triangles': 0, 'quads': 1}, None),
        "tolerance_mode": ('choice', {'auto': 0, 'given': 1, 'exact': 2}, None),
        "tolerance": ('float', {}, ('tolerance_mode', 'given')),
        "arc_a": ('row', {}, ('extent', 'arcs')),
        "arc_b": ('row', {}, ('extent', 'arcs')),
        "search": ('choice', {'auto': 0, 'exact': 1}, None),
        "start": ('choice', {'auto': 0, 'closest': 1, 'given': 2}, None),
        "fairing": ('choice', {'none': 0, 'thin_plate': 1}, None),
        "intersections": ('choice', {'auto': 0, 'ignore': 1, 'report': 2}, None),
        "centres": ('choice', {'vertices': 0, 'length': 1}, None),
        "outward": ('choice', {'auto': 0, 'keep': 1, 'closed': 2}, None),
        "finish": ('choice', {'strip': 0, 'blend': 1}, None),
    },
    "gusset_fill_options": {
        "weight": ('choice', {'continuation': 0, 'area_and_bend': 1, 'bend_then_area': 2, 'area': 3}, None),
        "refine": ('choice', {'none': 0, 'rim_density': 1}, None),
        "fairing": ('choice', {'none': 0, 'thin_plate': 1}, None),
        "keep": ('choice', {'none': 0, 'longest': 1, 'borders': 2}, None),
        "intersections": ('choice', {'auto': 0, 'ignore': 1, 'report': 2}, None),
        "plan_only": ('flag', {}, None),
        "max_new_vertices": ('int', {}, None),
        "max_edges": ('int', {}, None),
        "max_length": ('float', {}, None),
        "max_diameter": ('float', {}, None),
        "max_area": ('float', {}, None),
        "outward": ('choice', {'auto': 0, 'keep': 1, 'closed': 2}, None),
        "together": ('choice', {'apart': 0, 'one': 1, 'cheapest': 2}, None),
        "groups": ('array', {}, None),
        "continuity": ('choice', {'c1': 0, 'c2': 1}, None),
        "ignore_creases": ('flag', {}, None),
    },
    "gusset_trim_options": {
        "max_distance": ('float', {}, None),
        "max_angle": ('float', {}, None),
        "viewpoints": ('array', {}, None),
        "min_faces": ('int', {}, None),
    },
    "gusset_alignment_options": {
        "start": ('choice', {'as_given': 0, 'principal_axes': 1, 'rims': 2}, None),
        "samples": ('int', {}, None),
        "poses": ('array', {}, ('start', 'as_given')),
        "max_distance": ('float', {}, None),
        "max_rounds": ('int', {}, None),
    },
    "gusset_outline_options": {
        "curve": ('choice', {'composite': 0, 'single': 1, 'blend_c1': 2, 'blend_c2': 3, 'cubic_c2': 4, 'chain': 5}, None),
        "method": ('choice', {'bisector': 0, 'median': 1, 'normal': 2, 'symmedian': 3, 'alpha': 4}, None),
        "lock": ('choice', {'parameter': 0, 'self_consistent': 1, 'data_guide': 2}, None),
        "joint": ('choice', {'half': 0, 'knot': 1, 'g2': 2}, None),
        "solver": ('choice', {'fast': 0, 'step': 1}, None),
        "ends": ('choice', {'free': 0, 'perpendicular': 1, 'level': 2, 'upright': 3, 'level_or_upright': 4}, None),
        "alpha": ('float', {}, ('method', 'alpha')),
        "parameter_limit": ('float', {}, None),
        "repeat_tolerance": ('float', {}, None),
        "corner_angle": ('float', {}, None),
        "tolerance": ('float', {}, None),
        "max_sweeps": ('int', {}, None),
        "max_steps": ('int', {}, None),
    },
    "gusset_offset_options": {
        "tolerance": ('float', {}, None),
        "max_segments": ('int', {}, None),
        "degree": ('int', {}, None),
    },
    "gusset_net_mesh_options": {
        "faces": ('choice', {'quads': 0, 'triangles_shorter': 1, 'triangles_fixed': 2}, None),
        "no_weld": ('flag', {}, None),
        "keep_unused": ('flag', {}, None),
        "fill_corners": ('flag', {}, None),
        "texture": ('flag', {}, None),
        "max_edge_ratio": ('float', {}, None),
    },
    "gusset_concatenate_options": {
        "tolerance": ('float', {}, None),
        "direction": ('choice', {'right': 0, 'down': 1}, None),
        "mode": ('choice', {'keep': 0, 'hide': 1, 'weld': 2}, None),
        "equalise": ('choice', {'uniform': 0, 'first': 1, 'last': 2, 'at': 3, 'at_poles': 4, 'refuse': 5}, None),
        "equalise_index": ('int', {}, ('equalise', 'at')),
        "twist": ('int', {}, None),
        "turn": ('flag', {}, None),
        "rows": ('int', {}, None),
    },
    "gusset_surface_options": {
        "tolerance": ('float', {}, None),
        "cones": ('flag', {}, None),
    },
    "gusset_nearest_options": {
        "limit": ('float', {}, None),
        "max_count": ('int', {}, None),
    },
    "gusset_contour_options": {
        "chord": ('float', {}, ('spacing', 'chord')),
        "spacing": ('choice', {'auto': 0, 'chord': 1, 'cell_edges': 2, 'leus': 3}, None),
        "points": ('int', {}, ('spacing', 'leus')),
    },
    "gusset_intersection_options": {
        "chord": ('float', {}, ('spacing', 'chord')),
        "tolerance": ('float', {}, None),
        "spacing": ('choice', {'auto': 0, 'chord': 1, 'cell_edges': 2, 'leus': 3}, None),
    },
    "gusset_sheet_mesh_options": {
        "tolerance": ('float', {}, None),
        "min_u": ('int', {}, None),
        "min_v": ('int', {}, None),
        "triangles": ('flag', {}, None),
    },
    "gusset_develop_options": {
        "distortion": ('choice', {'symmetric': 0, 'rigid': 1, 'conformal': 2}, None),
        "max_darts": ('int', {}, None),
        "cuts": ('array', {}, None),
        "cut_offsets": ('array', {}, None),
        "max_stretch": ('float', {}, None),
        "max_iterations": ('int', {}, None),
    },
    "gusset_join_options": {
        "weld": ('choice', {'sew': 0, 'none': 1, 'edge_to_edge': 2}, None),
        "orientation": ('choice', {'fix': 0, 'keep': 2}, None),
        "gap": ('choice', {'auto': 0, 'given': 1}, None),
        "whole_loops_only": ('flag', {}, None),
        "within_components": ('flag', {}, None),
        "fill": ('flag', {}, None),
        "max_gap": ('float', {}, ('gap', 'given')),
        "pairs": ('array', {}, None),
        "excluded": ('array', {}, None),
        "weld_options": ('options:WeldOptions', {}, None),
        "strip_options": ('options:StitchOptions', {}, None),
        "fill_options": ('options:FillOptions', {}, None),
        "outward": ('choice', {'auto': 0, 'keep': 1, 'closed': 2}, None),
        "overlaps": ('choice', {'keep': 0, 'trim': 1}, None),
        "trim_options": ('options:TrimOptions', {}, ('overlaps', 'trim')),
    },
}
