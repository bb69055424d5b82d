"""Keywords of structs of options, with what gusset.h says of them. Written by generate.py; do not edit."""

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

    #: Which vertices: one of the words
    vertices: Literal['boundary', 'all']
    #: GUSSET_TOLERANCE_AUTO: vertices lie together if they are no farther apart than rounding can have put copies of
    #: one vertex: 2^-19 of the largest coordinate for 32-bit positions, 2^-48 for 64-bit ones, or twice the last
    #: decimal place that positions show, as those from text files do, if that is more. Let D be the largest power of
    #: ten that does not exceed the longest side of the box round the vertices in question. The last place is the
    #: largest of 1e-5 D, 1e-6 D, ... of which at least a third of the coordinates (those of the largest order of
    #: magnitude), or of their differences from one vertex to the next, are multiples. Multiples of 1e-4 D do not
    #: count, as a coarse grid is no sign of rounding; of the rest there must be eight. At each vertex it is at most a
    #: quarter of the shortest edge that ends there, so that no edge collapses. See tolerance of the result's view for
    #: what it was. GUSSET_TOLERANCE_GIVEN: if they are not farther apart than the tolerance. GUSSET_TOLERANCE_EXACT:
    #: if their positions are equal, where -0 equals 0.
    tolerance_mode: Literal['auto', 'given', 'exact']
    #: In the unit of the positions, finite, at least 0; read for GUSSET_TOLERANCE_GIVEN.
    tolerance: float
    #: one of the words
    collapse: Literal['never', 'allow']
    #: one of the words
    unused: Literal['keep', 'remove']


class OrientOptions(TypedDict, total=False):
    """Fields of ``gusset_orient_options``; what is not given is as by default."""

    #: one of the words
    outward: Literal['default', 'keep', 'closed']


class BoundaryOptions(TypedDict, total=False):
    """Fields of ``gusset_boundary_options``; what is not given is as by default."""

    #: one of the words
    non_manifold: Literal['cut', 'stop']
    #: one of the words
    survey: Literal['whole_mesh', 'boundary_only']


class StitchOptions(TypedDict, total=False):
    """Fields of ``gusset_stitch_options``; what is not given is as by default."""

    #: one of the words
    meridians: Literal['continuation', 'index', 'arc_length', 'greedy', 'min_diagonal', 'smooth', 'quad', 'min_area']
    #: one of the words
    orientation: Literal['fix', 'refuse', 'keep']
    #: The first meridian joins the closest pair that is not joined by an edge already; with a twist, the vertex of
    #: rim B so many places later, counted in the direction in which rim A runs (negative: earlier), and no other
    #: start is tried. Any value; taken modulo the length of rim B. Must be 0 if arcs are joined (OUT_OF_RANGE), and
    #: with GUSSET_EXTENT_OPEN_ARCS also if there are none to join.
    twist: int
    #: one of the words
    extent: Literal['whole_loops', 'open_arcs', 'auto', 'arcs']
    #: one of the words
    run: Literal['closest', 'longest']
    #: one of the words
    rows: Literal['none', 'mean_edge', 'count']
    #: Interior rows, read for GUSSET_ROWS_COUNT.
    row_count: int
    #: one of the words
    cells: Literal['triangles', 'quads']
    #: one of the words
    tolerance_mode: Literal['auto', 'given', 'exact']
    #: How far a vertex must be from its loop's plane to face the other loop, in the unit of the positions, at least
    #: 0; read for GUSSET_TOLERANCE_GIVEN.
    tolerance: float
    #: Read for GUSSET_EXTENT_ARCS: the first place on loop A, below its length, and the number of vertices, 1 to its
    #: length. The arc runs along the loop as it was given, and may pass its end.
    arc_a: Sequence[float]
    #: The same on loop B.
    arc_b: Sequence[float]
    #: one of the words
    search: Literal['auto', 'exact']
    #: one of the words
    start: Literal['auto', 'closest', 'given']
    #: one of the words, read if interior rows are asked for; otherwise the log says that it is not.
    fairing: Literal['none', 'thin_plate']
    #: one of the words
    intersections: Literal['auto', 'ignore', 'report']
    #: one of the words
    centres: Literal['vertices', 'length']
    #: one of the words: what becomes of closed components of the result, the strip and all.
    outward: Literal['default', 'keep', 'closed']
    #: one of the words: what lies between the rims in the end.
    finish: Literal['strip', 'blend']


class FillOptions(TypedDict, total=False):
    """Fields of ``gusset_fill_options``; what is not given is as by default."""

    #: one of the words
    weight: Literal['continuation', 'area_and_bend', 'bend_then_area', 'area']
    #: one of the words
    refine: Literal['none', 'rim_density']
    #: one of the words, read if new vertices are asked for; otherwise the log says that it is not.
    fairing: Literal['none', 'thin_plate']
    #: one of the words: which loops are no holes; read if all loops are asked for.
    keep: Literal['none', 'longest', 'borders']
    #: one of the words: whether faces of patches that cut each other or old faces are looked for, and avoided by less
    #: fairing, other weights and no new vertices (AUTO), only reported (REPORT), or neither (IGNORE).
    intersections: Literal['auto', 'ignore', 'report']
    #: 1: nothing is filled or turned over; the accounts say which loops would be tried, and with which weight and
    #: finish. Loops that turn out to have no triangulation are not foreseen, nor which of them together says get one
    #: patch. 0 or 1.
    plan_only: bool
    #: About how many new vertices a patch gets, at most about twice as many; where more would be needed the triangles
    #: are larger. 0: 50,000, or four for each vertex of its rims if that is more, and as many again for sharp angles
    #: there.
    max_new_vertices: int
    #: Loops of more edges are left alone. 0 is no limit.
    max_edges: int
    #: Longer loops are left alone, in the unit of the positions, at least 0. 0 is no limit.
    max_length: float
    #: Loops in a box along the axes with a longer diagonal are left alone. 0 is no limit.
    max_diameter: float
    #: Loops with a larger area, as gusset_hole has it, are left alone. 0 is no limit.
    max_area: float
    #: one of the words: what becomes of closed components of the result, patches and all.
    outward: Literal['default', 'keep', 'closed']
    #: one of the words: which loops get one patch; read without groups.
    together: Literal['apart', 'one', 'cheapest']
    #: A number for each of the loops given, loop_count in all: those with the same number get one patch, a surface of
    #: genus 0 between them, but for loops that are left for reasons of their own. NULL: as together says. Needs
    #: loops.
    groups: ArrayLike
    #: one of the words: how smoothly faired vertices go on the surface round the hole.
    continuity: Literal['c1', 'c2']
    #: 1: creases of the old surface that end at a rim end there, and no patch goes on with them. 0 or 1.
    ignore_creases: bool


class TrimOptions(TypedDict, total=False):
    """Fields of ``gusset_trim_options``; what is not given is as by default."""

    #: Surfaces that are no farther apart than this are one, in the unit of the positions, finite and at least 0; 0:
    #: four mean edges of the coarser of two pieces.
    max_distance: float
    #: Surfaces whose normals differ by more are two, in radians, from 0 and below pi / 2; 0: 60 degrees.
    max_angle: float
    #: x, y, z of the place that each piece was seen from, in the unit of the positions, or NULL: what was seen under
    #: a flat angle counts for less.
    viewpoints: ArrayLike
    #: What has fewer faces is no surface; 0: 30. Parts of twenty times as many go where others show the same, and as
    #: small holes do not come about.
    min_faces: int


class AlignOptions(TypedDict, total=False):
    """Fields of ``gusset_alignment_options``; what is not given is as by default."""

    #: Where the pieces begin: one of the words
    start: Literal['as_given', 'principal_axes', 'rims']
    #: So many points of each piece are looked for on the others; 0: 2,000.
    samples: int
    #: Read for GUSSET_ALIGN_AS_GIVEN: motions of the pieces, rotations and translations, or NULL.
    poses: ArrayLike
    #: Points that are farther than this from another piece are no pair with it, in the unit of the positions, finite
    #: and at least 0; 0: a tenth of the diagonal of the largest piece's box. Pieces may begin that far from where
    #: they belong, or a little less.
    max_distance: float
    #: Rounds at the most, in each of two stages; 0: 100.
    max_rounds: int


class OutlineOptions(TypedDict, total=False):
    """Fields of ``gusset_outline_options``; what is not given is as by default."""

    #: one of the words
    curve: Literal['composite', 'single', 'blend_c1', 'blend_c2', 'cubic_c2', 'chain']
    #: one of the words
    method: Literal['bisector', 'median', 'normal', 'symmedian', 'alpha']
    #: one of the words, for composite and single curves; a chain has its own.
    lock: Literal['parameter', 'self_consistent', 'data_guide']
    #: one of the words, for composite curves and chains.
    joint: Literal['half', 'knot', 'g2']
    #: one of the words
    solver: Literal['fast', 'step']
    #: one of the words, for open outlines, and parts of them that end at corners; a tangent demanded there comes
    #: first.
    ends: Literal['free', 'perpendicular', 'level', 'upright', 'level_or_upright']
    #: Read for GUSSET_METHOD_ALPHA; 0 to 1.
    alpha: float
    #: Parameters of composite curves are kept within this and 1 less this: 0.001 to 1/2, or 0 for 1/6.
    parameter_limit: float
    #: Neighbours at most so far apart are one point; below 1. 0 for 1e-12. 1e-300 merges equal points only.
    repeat_tolerance: float
    #: Points where the polygon turns by more than this angle, in radians, are corners; at least 0, and 0, pi or more,
    #: also INFINITY, for none.
    corner_angle: float
    #: Iterations end when nothing moves farther, below 1; 0 for 1e-12.
    tolerance: float
    #: The most sweeps or iterations between two corners; 0 for 200.
    max_sweeps: int
    #: The most steps at a point in a sweep; 0 for 20,000.
    max_steps: int


class OffsetOptions(TypedDict, total=False):
    """Fields of ``gusset_offset_options``; what is not given is as by default."""

    #: The deviation aimed at, above 0, in the unit of the points.
    tolerance: float
    #: No segment is halved once there are so many; 0 for 65536.
    max_segments: int
    #: The degree of the segments, 2 or 3; 0 for 3.
    degree: int


class NetMeshOptions(TypedDict, total=False):
    """Fields of ``gusset_net_mesh_options``; what is not given is as by default."""

    #: GUSSET_NET_QUADS, GUSSET_NET_TRIANGLES_SHORTER or GUSSET_NET_TRIANGLES_FIXED.
    faces: Literal['quads', 'triangles_shorter', 'triangles_fixed']
    #: 1: a vertex for each node, and nothing is glued. 0 or 1.
    no_weld: bool
    #: 1: finite vertices that nothing uses are kept. 0 or 1.
    keep_unused: bool
    #: 1: a cell of which just one corner is missing becomes a triangle. 0 or 1.
    fill_corners: bool
    #: 1: texture coordinates are wanted. 0 or 1.
    texture: bool
    #: Faces with an edge of more than so many times the median length of edges are left out: in a range image those
    #: that lead from one surface to another behind it, for which 4 is a good value. Above 0; 0 for no limit.
    max_edge_ratio: float


class ConcatenateOptions(TypedDict, total=False):
    """Fields of ``gusset_concatenate_options``; what is not given is as by default."""

    #: How far nodes that are welded may be apart, at least 0, in the unit of the coordinates.
    tolerance: float
    #: one of the words: where each net lies from the one before.
    direction: Literal['right', 'down']
    #: GUSSET_BRIDGE_KEEP, GUSSET_BRIDGE_HIDE or GUSSET_BRIDGE_WELD.
    mode: Literal['keep', 'hide', 'weld']
    #: one of the words: how nets with fewer nodes along the side are enlarged.
    equalise: Literal['uniform', 'first', 'last', 'at', 'at_poles', 'refuse']
    #: Read for GUSSET_REPLICATE_AT: the row or column.
    equalise_index: int
    #: Each net but the first is turned by so many places along its side, which is closed then.
    twist: int
    #: 1: nets whose faces are taken the other way round than those of the first are flipped along the side; 0:
    #: refused.
    turn: bool
    #: How many rows or columns of nodes of its own each new bridge has, evenly on straight lines between the two
    #: sides; 0 for GUSSET_BRIDGE_WELD.
    rows: int


class SurfaceOptions(TypedDict, total=False):
    """Fields of ``gusset_surface_options``; what is not given is as by default."""

    #: A length, to which answers are proved, finite; 0: 1e-9 of the diagonal of the surface's box.
    tolerance: float
    #: 1: with the cones of normals that isophotes (GUSSET_CONTOUR_ANGLE) and gusset_surface_nearest_angle descend,
    #: about 0.7 bytes a node; 0: the first such question builds them.
    cones: bool


class NearestOptions(TypedDict, total=False):
    """Fields of ``gusset_nearest_options``; what is not given is as by default."""

    #: No point farther than this is looked for; a length, at least 0; 0 or INFINITY: no limit.
    limit: float
    #: For minima: the number of the nearest that are wanted; 0: all.
    max_count: int


class ContourOptions(TypedDict, total=False):
    """Fields of ``gusset_contour_options``; what is not given is as by default."""

    #: With GUSSET_POINT_SPACING_CHORD: a length above 0 and finite; no smaller one counts than the tolerance of the
    #: surface. Otherwise not read.
    chord: float
    #: one of the words
    spacing: Literal['auto', 'chord', 'cell_edges', 'leus']
    #: With GUSSET_POINT_SPACING_LEUS: how many, at most 1000. Otherwise not read.
    points: int


class IntersectionOptions(TypedDict, total=False):
    """Fields of ``gusset_intersection_options``; what is not given is as by default."""

    #: With GUSSET_POINT_SPACING_CHORD: a length above 0 and finite, the greatest distance of the curve from the
    #: chords between its points, as their tangents and middles show it. (1.14 times as much was seen at one chord in
    #: 10,000.) A chord that is smaller than `tolerance` and than the surfaces' own tolerances counts as the smaller
    #: one of these. Otherwise not read.
    chord: float
    #: A length, finite: surfaces that are apart, or overlap, by no more than that all over touch there. 0: the
    #: smaller one of the tolerances of the two surfaces. Branches are found and told apart by that one, or by
    #: `tolerance` if it is smaller: shorter ones may be lost. A surface's intersections with itself take a greater
    #: one for the surface's own.
    tolerance: float
    #: one of the words: all but GUSSET_POINT_SPACING_LEUS; for GUSSET_POINT_SPACING_AUTO the smaller surface's box
    #: counts.
    spacing: Literal['auto', 'chord', 'cell_edges', 'leus']


class SheetMeshOptions(TypedDict, total=False):
    """Fields of ``gusset_sheet_mesh_options``; what is not given is as by default."""

    #: How far triangles may be from the surface, a length more than 0; 0, or INFINITY: no demand.
    tolerance: float
    #: The fewest parts of each cell in u; 0 stands for 1.
    min_u: int
    #: The fewest parts of each cell in v; 0 stands for 1.
    min_v: int
    #: 1: triangles only; 0: quads, and triangles at poles.
    triangles: bool


class DevelopOptions(TypedDict, total=False):
    """Fields of ``gusset_develop_options``; what is not given is as by default."""

    #: Which distortion is least: one of the words
    distortion: Literal['symmetric', 'rigid', 'conformal']
    #: Darts at the most: cuts from the border of a chart to where its curvature is.
    max_darts: int
    #: Vertices of the mesh, path after path, along which it is cut. Vertices that follow one another are connected by
    #: the shortest path along edges; a path of one vertex cuts nothing.
    cuts: ArrayLike
    #: Where each path begins among them, and the end of the last; empty for one path of all.
    cut_offsets: ArrayLike
    #: No more darts are made once no length changes by a larger factor; above 1, or 0: all darts are made.
    max_stretch: float
    #: Steps of each descent at the most; 0: 200. A chart whose border would meet itself takes more than one, and so
    #: does one as rigid as possible.
    max_iterations: int


class JoinOptions(TypedDict, total=False):
    """Fields of ``gusset_join_options``; what is not given is as by default."""

    #: one of the words
    weld: Literal['sew', 'none', 'edge_to_edge']
    #: GUSSET_ORIENTATION_FIX: within each component the minority of faces is turned over, and components that face
    #: each other are made to agree. GUSSET_ORIENTATION_KEEP: nothing is turned, nor in the end.
    orientation: Literal['fix', 'keep']
    #: one of the words
    gap: Literal['auto', 'given']
    #: 1: only whole loops are joined, no parts of them, nor what sewing left of two borders. 0 or 1.
    whole_loops_only: bool
    #: 1: loops of one component may be joined without being asked for. 0 or 1.
    within_components: bool
    #: 1: holes that are left in the end are filled. 0 or 1.
    fill: bool
    #: Read for GUSSET_GAP_GIVEN: the widest gap that is closed, in the unit of the positions, finite and at least 0;
    #: 0 leaves all open.
    max_gap: float
    #: Pairs of loops to be joined however wide the gap is, as wholes, or NULL. Each names two different loops, or the
    #: same one twice if sewing left it of two borders (see gusset_joint), and none is named in two pairs. Errors name
    #: a pair by its number from 0, and say what is wrong with it.
    pairs: ArrayLike
    #: Pairs that are not to be joined, or NULL. A pair that is given above is joined all the same, and a vertex that
    #: no loop passes, as it was welded, excludes nothing.
    excluded: ArrayLike
    #: How to weld; NULL for the defaults.
    weld_options: WeldOptions
    #: The strips, NULL for the defaults: meridians, search, start, rows, row_count, cells, fairing, intersections and
    #: finish are read; the other fields must be valid too.
    strip_options: StitchOptions
    #: How to fill, NULL for the defaults. groups, outward and plan_only are not read, but the last two must be valid
    #: too; intersections REPORT is as IGNORE.
    fill_options: FillOptions
    #: one of the words: the side that closed components of the result face; outwards by default. The wall of a cavity
    #: within another component is turned too. A result that is not turned is mostly as the first piece has it.
    outward: Literal['default', 'keep', 'closed']
    #: GUSSET_OVERLAPS_KEEP or GUSSET_OVERLAPS_TRIM.
    overlaps: Literal['keep', 'trim']
    #: Read for GUSSET_OVERLAPS_TRIM: how to trim; NULL for the defaults.
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
        "outward": ('choice', {'default': 0, 'keep': 1, 'closed': 2}, None),
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
        "outward": ('choice', {'default': 0, 'keep': 1, 'closed': 2}, None),
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
        "outward": ('choice', {'default': 0, 'keep': 1, 'closed': 2}, None),
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
        "outward": ('choice', {'default': 0, 'keep': 1, 'closed': 2}, None),
        "overlaps": ('choice', {'keep': 0, 'trim': 1}, None),
        "trim_options": ('options:TrimOptions', {}, ('overlaps', 'trim')),
    },
}
