//! Choices of gusset/mesh.h.
//!
//! Written by `gusset-interface headers`; do not edit.

use std::ffi::CStr;

/// The name of each choice, and its constants with their texts.
#[rustfmt::skip]
pub(super) const CHOICES: &[(&str, &[(u32, &CStr)])] = &[
    ("gusset_scalar", &[
        (1, c"32-bit floats."),
        (2, c"64-bit floats."),
    ]),
    ("gusset_index", &[
        (0, c"32-bit unsigned integers."),
        (1, c"Reserved: GUSSET_ERROR_UNKNOWN_VALUE."),
    ]),
    ("gusset_welding", &[
        (0, c"Sewn as by gusset_sew, with weld_options; edges are split where vertices do not match."),
        (1, c"Nothing is welded."),
        (2, c"Sewn where vertices match, as by gusset_weld."),
    ]),
    ("gusset_gap", &[
        (0, c"A gap's width is the larger mean distance from either loop to the other's nearest points."),
        (1, c"max_gap."),
    ]),
    ("gusset_join_extent", &[
        (0, c"Whole loops, and parts of the other loops."),
        (1, c"Whole loops only."),
        (2, c"Runs of loops and slits only: two sheets side by side never become a closed pocket."),
    ]),
    ("gusset_overlaps", &[
        (0, c"Overlapping pieces stay unchanged."),
        (1, c"One piece of each overlap is kept, as by gusset_trim_create, and gaps are closed."),
    ]),
    ("gusset_joint_outcome", &[
        (0, c"A strip joins the two sides."),
        (1, c"Left open: the surface would become one-sided."),
        (2, c"Left open: the sides share a vertex."),
        (3, c"Left open: every strip would repeat an edge of the mesh."),
        (4, c"Left to hole filling: between trimmed pieces, the strip would intersect other faces."),
    ]),
    ("gusset_left_reason", &[
        (0, c"It is the only loop."),
        (1, c"The loop is open, non-manifold or not consistently oriented."),
        (2, c"The loop has fewer than 3 vertices."),
        (3, c"The loop faces another, but lacks a strip; see joints."),
        (4, c"The nearest loop, or the other side of a slit, is farther than allowed_gap."),
        (5, c"All other loops are on its component, and within_components is 0."),
        (6, c"The nearest loop is close enough, but they face each other too little."),
        (7, c"The nearest loop is joined with another."),
        (8, c"The pair with the nearest loop is excluded."),
    ]),
    ("gusset_meridians", &[
        (0, c"Triangle strip that best continues both surfaces."),
        (1, c"Vertices paired in proportion to their indices; suits evenly spaced rims."),
        (2, c"Vertices paired in proportion to arc length."),
        (3, c"Always the shorter of the two next meridians."),
        (4, c"Triangle strip of least total meridian length."),
        (5, c"Triangle strip of least bend: the sum, over its edges and rims, of length * (1 - cos(angle between normals))."),
        (6, c"Least sum of squared meridian lengths (dynamic time warping): quads where both rims advance, else triangles."),
        (7, c"Triangle strip of least area through the first meridian."),
    ]),
    ("gusset_strip_search", &[
        (0, c"Exact up to 2^21 vertex pairs."),
        (1, c"Exact, in O(N M) time; gusset_stitch states the memory."),
    ]),
    ("gusset_strip_start", &[
        (0, c"The better strip from the closest pair of vertices, before or after rotating rim B along rim A to the best fit."),
        (1, c"The closest pair of vertices."),
        (2, c"The first points; gusset_strip only."),
    ]),
    ("gusset_fairing", &[
        (0, c"New vertices divide the meridians of a strip evenly, or lie on the first triangulation of a patch."),
        (1, c"A thin plate that meets the old surface smoothly: least sum of squared Laplacians over new vertices and rims."),
    ]),
    ("gusset_intersections", &[
        (0, c"Finds intersections of the strip, and reduces them:"),
        (1, c"No search: rows are faired in full, and the first blend is kept."),
        (2, c"As GUSSET_INTERSECTIONS_AUTO, but no strip is rerouted."),
    ]),
    ("gusset_orientation", &[
        (0, c"Reverses the component of rim B if it is oriented against rim A, whichever is inside out; nothing within one component."),
        (1, c"Opposite orientations return GUSSET_ERROR_ORIENTATION_CONFLICT."),
        (2, c"Orientations are not compared."),
    ]),
    ("gusset_stitch_extent", &[
        (0, c"Whole loops, by a closed band."),
        (1, c"Runs of facing vertices, as in gusset_facing_create; may return GUSSET_ERROR_PLANES_UNDECIDED."),
        (2, c"Whole loops if their normals make less than 60 degrees with the line of centres (mean of cosines), or the planes are undecided."),
        (3, c"The arcs arc_a and arc_b."),
    ]),
    ("gusset_facing_run", &[
        (0, c"On each loop the run with the closest pair."),
        (1, c"On each loop the run with the most vertices; of equal runs the first."),
    ]),
    ("gusset_centres", &[
        (0, c"Mean of the vertices."),
        (1, c"Mean along the curve, independent of vertex spacing."),
    ]),
    ("gusset_row_rule", &[
        (0, c"0: each meridian is one edge."),
        (1, c"max(0, round(mean meridian length / mean edge length of both sides) - 1)."),
        (2, c"row_count."),
    ]),
    ("gusset_strip_cells", &[
        (0, c"Triangles; quads are split by their shorter diagonals."),
        (1, c"Quads, and triangles where a rim repeats a vertex."),
    ]),
    ("gusset_finish", &[
        (0, c"Strip of meridians, with interior rows."),
        (1, c"Smooth joint, tangent to both pieces, which looks best."),
    ]),
    ("gusset_tolerance_mode", &[
        (0, c"Uses the rounding error of the coordinates."),
        (1, c"Uses the given tolerance."),
        (2, c"Uses tolerance 0; welding then requires equal positions."),
    ]),
    ("gusset_outward", &[
        (0, c"GUSSET_OUTWARD_CLOSED in gusset_join, else GUSSET_OUTWARD_KEEP."),
        (1, c"Closed components stay unchanged; gusset_orient chooses the original side of most faces."),
        (2, c"Closed components face outwards, and walls of cavities into the cavities."),
    ]),
    ("gusset_fill_keep", &[
        (0, c"Outer borders of sheets, and borders of loose faces."),
        (1, c"All loops are holes."),
        (2, c"The longest loop (the first of equals)."),
        (3, c"Outer borders of sheets and shallow bowls: loops whose area vector has a positive dot product with the component's."),
    ]),
    ("gusset_fill_together", &[
        (0, c"Each loop gets its own patch."),
        (1, c"All filled loops share one patch of genus 0."),
        (2, c"Loops share a patch where it weighs less than separate patches."),
    ]),
    ("gusset_fill_refinement", &[
        (0, c"No new vertices."),
        (1, c"New vertices as dense as those around the hole."),
    ]),
    ("gusset_fill_continuity", &[
        (0, c"Tangent continuity: fairing minimises the squared Laplacian."),
        (1, c"Curvature continuity: fairing minimises the squared gradient of the Laplacian."),
    ]),
    ("gusset_fill_weight", &[
        (0, c"Best continuation: the area if the rim is planar, else the sum of"),
        (1, c"Sum of the areas and, over all edges, the rim included, of squared length * (1 - cos(angle between normals))."),
        (2, c"Largest angle between neighbouring faces, old faces at the rim included; then the area."),
        (3, c"Area, minimised exactly for a single loop of at most 128 vertices."),
    ]),
    ("gusset_patch_finish", &[
        (0, c"Rim vertices only."),
        (1, c"New vertices on the plain triangles, except beside creases that continue."),
        (2, c"New vertices, faired."),
    ]),
    ("gusset_hole_status", &[
        (0, c"Filled; with plan_only, to be filled."),
        (1, c"Left open: the outer border of a sheet, or the longest loop; see keep."),
        (2, c"Left open: it exceeds max_edges, max_length, max_diameter or max_area."),
        (3, c"Left open: an open chain."),
        (4, c"Left open: it runs along a non-manifold edge."),
        (5, c"Left open: the faces along it disagree in orientation."),
        (6, c"Left open: a given loop has fewer than three vertices, or passes a vertex twice."),
        (7, c"Left open: an edge of a given loop is not a boundary edge, or belongs to an earlier loop."),
        (8, c"Left open: every triangulation joins two vertices of one old face, or no shared patch was found."),
        (9, c"Left open: loose faces; the loop passes all vertices of its component."),
        (10, c"Left open: an edge coincides with another boundary edge up to rounding, so that a patch would have no area there, or lie on another."),
    ]),
    ("gusset_weld_vertices", &[
        (0, c"Ends of boundary edges: sews coincident borders edge to edge."),
        (1, c"All used vertices, for triangle soups."),
    ]),
    ("gusset_collapse", &[
        (0, c"Corners of one face stay apart."),
        (1, c"Corners of one face may be merged."),
    ]),
    ("gusset_unused", &[
        (0, c"Unused vertices stay."),
        (1, c"Vertices that no face of the result uses are removed."),
    ]),
    ("gusset_drop_reason", &[
        (0, c"Fewer than three different vertices remain."),
        (1, c"The area is 0 up to rounding."),
        (2, c"An earlier face has the same vertices."),
        (3, c"The solid lies on both sides."),
        (4, c"Part of an open sheet attached to a closed component."),
        (5, c"The face is in an overlapping or inverted part."),
    ]),
    ("gusset_alignment_start", &[
        (0, c"As given, moved by poses if any."),
        (1, c"Principal axes on the first piece's, in the best of four ways."),
        (2, c"Rims of like shape put together, which then hold the pieces."),
        (3, c"Like features of the surfaces put together, for overlapping pieces in any poses."),
    ]),
    ("gusset_aligned_reason", &[
        (0, c"Trusted: the piece fits trusted pieces, up to the first."),
        (1, c"The piece lacks faces with area, or overlaps others too little."),
        (2, c"Too much of the piece near others is off their surfaces."),
        (3, c"Up to the noise of normals, the piece is free to slide or turn."),
        (4, c"Most of the overlap has opposite normals: the piece is inside out or mirrored."),
        (5, c"The piece overlaps nothing, and is over 50 times larger or smaller than the first: probably in another unit."),
        (6, c"The piece fits untrusted pieces only."),
    ]),
    ("gusset_non_manifold", &[
        (0, c"Each face has its own border there; loops along it are closed."),
        (1, c"Loops have boundary edges only, and end at non-manifold ones as open chains."),
    ]),
    ("gusset_survey", &[
        (0, c"Every edge: all defects are reported, and flagged on loops."),
        (1, c"The boundary only, many times faster."),
    ]),
    ("gusset_loop_flags", &[
        (1, c"An open chain, with one vertex more than edges."),
        (2, c"Passes a vertex where the surface touches itself."),
        (4, c"Cut from a longer walk that passes a vertex twice."),
        (8, c"Runs along, or ends at, a non-manifold edge."),
        (16, c"Faces along the loop disagree in orientation."),
        (32, c"Has an edge of length 0."),
    ]),
    ("gusset_edge_flags", &[
        (1, c"The loop runs this edge against its face."),
        (2, c"The edge is non-manifold."),
        (4, c"The edge has length 0."),
    ]),
    ("gusset_defect_kind", &[
        (1, c"A face (index) repeats a vertex (other)."),
        (2, c"The two faces of an edge run it in one direction: half-edges index and other."),
        (3, c"An edge has three or more half-edges: index is the first, count their number."),
        (4, c"The faces at a vertex (index) form several fans."),
    ]),
    ("gusset_mesh_flags", &[
        (1, c"The mesh has edges, each with exactly two faces."),
        (2, c"No edge or vertex is non-manifold."),
        (4, c"The two faces of each edge run it in opposite directions."),
        (8, c"The mesh is oriented, or would be after turning faces over."),
    ]),
    ("gusset_distortion", &[
        (0, c"Lengths and areas, stretch and compression alike: the symmetric Dirichlet energy."),
        (1, c"Lengths: as rigid as possible."),
        (2, c"Angles: the least-squares conformal map, which may stretch areas."),
    ]),
    ("gusset_chart_finish", &[
        (0, c"Unfolded about edges: all edges keep their lengths."),
        (1, c"Descended until nothing was gained."),
        (2, c"Descended until max_iterations."),
        (3, c"The requested conformal map."),
        (4, c"The map with the least symmetric distortion: the conformal map folds or overlaps."),
        (5, c"Some triangles are turned over: no map without folds was found."),
        (6, c"Descended until no step gained: the border would meet itself, or rounding hides the gain."),
    ]),
    ("gusset_cut_kind", &[
        (0, c"On a given path."),
        (1, c"To open a component to a disc."),
        (2, c"For a dart."),
    ]),
    ("gusset_in_plane", &[
        (0, c"They count as above: the section is the limit from just below the plane."),
        (1, c"They count as below: the section is the limit from just above the plane."),
    ]),
    ("gusset_cutting_kind", &[
        (0, c"Parallel planes with the normal `direction`, at rising distances `values` from `point`."),
        (1, c"Planes through `points`, each with its normal in `normals`."),
        (2, c"Planes through the axis at `point` along `direction`, turned from `reference` by the angles `values`."),
        (3, c"Planes across the polyline `points`, at the distances `values` from its first point along it."),
    ]),
    ("gusset_domain", &[
        (0, c"Vertices, points of polylines, nodes of nets and sheets."),
        (1, c"Corners of faces, in the order of face_corners; nodes of nets and sheets."),
        (2, c"Faces, cells of nets and sheets."),
    ]),
    ("gusset_value_type", &[
        (1, c"32-bit floats."),
        (2, c"64-bit floats."),
        (3, c"8-bit unsigned integers."),
        (4, c"16-bit unsigned integers."),
        (5, c"32-bit unsigned integers."),
    ]),
    ("gusset_rule", &[
        (0, c"Weighted mean; integers are rounded."),
        (1, c"Directions of three floats: weighted mean on the sphere, of length 1."),
        (2, c"Bone weights, at least 0: weighted mean."),
        (3, c"Value of the source with the largest weight (the first of equals)."),
        (4, c"Texture coordinates."),
    ]),
];
