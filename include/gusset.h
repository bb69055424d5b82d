/* gusset: joins surfaces that come in pieces. Generated from src/capi by cbindgen; do not edit.
 *
 * Every function is reentrant, and takes NULL for a context: then there is no account of an error, no
 * progress, and no cancelling. Those that set something of a context or get its report need one. Pointers are to the caller's own arrays unless said otherwise; counts are in elements,
 * strides in bytes, angles in radians, lengths in the unit of the positions, indices from 0.
 * Structs that begin with struct_size: set it to sizeof the struct, all other fields to 0 for the defaults:
 *     gusset_stitch_options options = {0};
 *     options.struct_size = sizeof options;
 *
 * Errors are listed without their prefix GUSSET_ERROR_. Every function that takes a context may also return CONTEXT_BUSY, and
 * CANCELLED before it looks at its other arguments; every one that takes a handle, WRONG_HANDLE. Whatever fails, handles, arrays of handles, structs and outputs of a fixed
 * size are cleared; what an array of numbers holds, for which the caller gives the room, is unspecified after a failure. An
 * array that the library lends is NULL if it has no elements. C99 or later, C++11 or later.
 */

#ifndef GUSSET_H
#define GUSSET_H

#include <stddef.h>
#include <stdint.h>
#if defined(_WIN32) && defined(GUSSET_SHARED)
#define GUSSET_API __declspec(dllimport)
#elif defined(__GNUC__)
#define GUSSET_API __attribute__((visibility("default")))
#else
#define GUSSET_API
#endif

#if defined(__GNUC__)
#define GUSSET_MUST_USE __attribute__((warn_unused_result))
#else
#define GUSSET_MUST_USE
#endif

/** Version of this header; compare with gusset_version() of the library loaded. */
#define GUSSET_VERSION_MAJOR 0
#define GUSSET_VERSION_MINOR 1
#define GUSSET_VERSION_PATCH 0
#define GUSSET_VERSION_STRING "0.1.0"


/**
 * The points of the sections by their places: all sections have equally many.
 */
#define GUSSET_CORRESPONDENCE_GIVEN 0

/**
 * Equal parts of the arc length of each section, or of the lengths between corners that all sections
 * have. Closed sections start where they are turned least against each other, wherever their first
 * points are; one that runs the other way round than the first one is taken backwards. Open sections
 * go from their first points to their last.
 */
#define GUSSET_CORRESPONDENCE_ARC_LENGTH 1

/**
 * Where half-planes at equal angles round the axis, straight or bent, meet each section; the
 * farthest place where there are several.
 */
#define GUSSET_CORRESPONDENCE_ANGLE 2

/**
 * Landmarks of each section, and equal parts of the arc length between them.
 */
#define GUSSET_CORRESPONDENCE_LANDMARKS 3

/**
 * Nodes move along the normals of the body.
 */
#define GUSSET_OFFSET_NORMAL 0

/**
 * Nodes move within the planes of their sections.
 */
#define GUSSET_OFFSET_IN_SECTION 1

/**
 * gusset_curve_sample_create: as many points as amount says, at equal arc lengths.
 */
#define GUSSET_SAMPLE_COUNT 0

/**
 * gusset_curve_sample_create: a point every `amount` of arc length; an open curve's end is always
 * the last.
 */
#define GUSSET_SAMPLE_STEP 1

/**
 * gusset_curve_sample_create: the curve is nowhere farther than `amount` from the chords between
 * the points; each segment is halved at most 20 times, which leaves 1e-12 of its size.
 */
#define GUSSET_SAMPLE_CHORD 2

/**
 * The curve passes the point in the direction of the tangent, of any length but 0.
 */
#define GUSSET_CONSTRAINT_TANGENT 0

/**
 * The curve may turn sharply at the point.
 */
#define GUSSET_CONSTRAINT_CORNER 1

/**
 * The curve passes the point at the angle tangent[0], in radians counter-clockwise from the
 * x-axis, in the plane of x and y.
 */
#define GUSSET_CONSTRAINT_TANGENT_ANGLE 2

/**
 * Quadratic segments, one control point for each point; smooth (G1) everywhere.
 */
#define GUSSET_CURVE_COMPOSITE 0

/**
 * One Bezier curve through all points: of degree n through n + 1 points, 1 more for each end
 * tangent, and n + 2 through n points of a closed outline, whose seam is smooth. Above degree 64 a
 * composite curve takes its place. Good for up to some 20 points.
 */
#define GUSSET_CURVE_SINGLE 1

/**
 * Neighbouring sections blended linearly: cubic segments from point to point, C1 in the knots of
 * the method's exponent (G1 with the normal). With the bisector the centripetal Catmull-Rom
 * spline.
 */
#define GUSSET_CURVE_BLEND_C1 2

/**
 * Neighbouring sections blended smoothly: quintic segments from point to point, C2 (G2 with the
 * normal), but at inner points whose tangent is given: C1 (G1) there.
 */
#define GUSSET_CURVE_BLEND_C2 3

/**
 * The cubic spline: cubic segments from point to point, C2 in the knots of the method's exponent,
 * but at inner points whose tangent is given: C1 there.
 */
#define GUSSET_CURVE_CUBIC_C2 4

/**
 * The paper's chain: GUSSET_CURVE_COMPOSITE with GUSSET_LOCK_DATA_GUIDE, whatever lock says. Each
 * control point lies on the guide of its point, the bisector, median or normal that the method
 * names.
 */
#define GUSSET_CURVE_CHAIN 5

/**
 * The bisector of the angle at the point. For all points. Sections by themselves and
 * GUSSET_LOCK_DATA_GUIDE have their control points on the line that the method names; the other
 * locks take from it the parameter of the point, and control points are near the line.
 */
#define GUSSET_METHOD_BISECTOR 0

/**
 * The median. For all points.
 */
#define GUSSET_METHOD_MEDIAN 1

/**
 * The normal of the chord; where its foot is outside the chord the bisector takes its place, but
 * for GUSSET_LOCK_SELF_CONSISTENT, where the foot counts as the nearer end of the chord.
 */
#define GUSSET_METHOD_NORMAL 2

/**
 * The symmedian. For all points.
 */
#define GUSSET_METHOD_SYMMEDIAN 3

/**
 * The parameter of the point is a^alpha / (a^alpha + b^alpha), a and b being the distances from
 * its neighbours: the median at alpha = 0, the bisector at 1/2, the symmedian at 1.
 */
#define GUSSET_METHOD_ALPHA 4

/**
 * The parameter of a point is that of the method on the triangle of the data. Always solvable. The
 * control point is near the guide of that triangle but not on it.
 */
#define GUSSET_LOCK_PARAMETER 0

/**
 * The parameter is that of the method on the section's own triangle. With the normal there may be
 * several solutions; which one is found depends on the solver.
 */
#define GUSSET_LOCK_SELF_CONSISTENT 1

/**
 * The control point lies on the guide of the data's triangle, as the paper draws it, where that is
 * possible. Outlines must lie in a plane, any plane; points of others get
 * GUSSET_POINT_OUT_OF_PLANE and the lock by parameter.
 */
#define GUSSET_LOCK_DATA_GUIDE 2

/**
 * Sections join in the middle between their control points.
 */
#define GUSSET_JOINT_PARAMETER_HALF 0

/**
 * By the chords to the power of the method's exponent: the quadratic B-spline in those knots, C1.
 */
#define GUSSET_JOINT_PARAMETER_KNOT 1

/**
 * So that the curvature is continuous (G2): cubic segments in the triangles of the quadratics. 0
 * where the control polygon turns the other way. Outlines in a plane; in space curvatures agree in
 * magnitude, and points get GUSSET_POINT_OUT_OF_PLANE.
 */
#define GUSSET_JOINT_PARAMETER_G2 2

/**
 * Closed forms and Newton's method.
 */
#define GUSSET_SOLVER_FAST 0

/**
 * The paper's: steps along the guide, refined where the deviation changes its sign.
 */
#define GUSSET_SOLVER_STEP 1

/**
 * Open outlines begin and end as their first and last sections have it.
 */
#define GUSSET_ENDS_FREE 0

/**
 * Perpendicular to the first chord, from the first point to the third, and to the last one.
 */
#define GUSSET_ENDS_PERPENDICULAR 1

/**
 * Along the x-axis, in the sense of the first and the last leg.
 */
#define GUSSET_ENDS_LEVEL 2

/**
 * Along the y-axis, in the sense of the first and the last leg.
 */
#define GUSSET_ENDS_UPRIGHT 3

/**
 * Level or upright, whichever is nearer the perpendicular of the first or the last chord.
 */
#define GUSSET_ENDS_LEVEL_OR_UPRIGHT 4

/**
 * Repeats are neighbours nearer than 1e-12 times the size of the outline.
 */
#define GUSSET_REPEATS_AUTO 0

/**
 * repeat_tolerance is read.
 */
#define GUSSET_REPEATS_GIVEN 1

/**
 * As asked.
 */
#define GUSSET_POINT_OK 0

/**
 * Its parameter was brought within the limits.
 */
#define GUSSET_POINT_CLAMPED_PARAMETER 1

/**
 * It repeats a point before it (or the first one, at the end of a closed outline), and was left
 * out: the curve passes that one, which is within the tolerance for repeats.
 */
#define GUSSET_POINT_MERGED 2

/**
 * It is so near the first or last point of its section that this has no control point by the
 * method; the median took its place.
 */
#define GUSSET_POINT_REPEATED 3

/**
 * Its triangle is flat: it has no guide, or no perpendicular.
 */
#define GUSSET_POINT_COLLINEAR 4

/**
 * The foot of the normal is outside the chord; the bisector took its place.
 */
#define GUSSET_POINT_NORMAL_OUTSIDE 5

/**
 * The foot of the normal is an end of the chord; the bisector took its place.
 */
#define GUSSET_POINT_RIGHT_ANGLE 6

/**
 * The curve does not cross the guide.
 */
#define GUSSET_POINT_NO_CROSSING 7

/**
 * The tangent runs between points that should be on one side of it.
 */
#define GUSSET_POINT_TANGENT_SEPARATES 8

/**
 * The curve would have to run backwards along the tangent.
 */
#define GUSSET_POINT_TANGENT_BACKWARD 9

/**
 * The tangent cannot be reached by a quadratic: the point is farther from it than the section's
 * end.
 */
#define GUSSET_POINT_TANGENT_BEYOND 10

/**
 * The tangent is not in the plane of the section; or GUSSET_LOCK_DATA_GUIDE or
 * GUSSET_JOINT_PARAMETER_G2 is asked of an outline that is not plane.
 */
#define GUSSET_POINT_OUT_OF_PLANE 11

/**
 * The tangent has no direction, and was left out.
 */
#define GUSSET_POINT_NO_TANGENT 12

/**
 * The lock could not be kept: its parameter is that of GUSSET_LOCK_PARAMETER.
 */
#define GUSSET_POINT_FELL_BACK 13

/**
 * The iteration ended before it was still.
 */
#define GUSSET_POINT_NOT_CONVERGED 14

/**
 * The curve misses it: the outline has too few different points, or its equations have no
 * solution.
 */
#define GUSSET_POINT_MISSED 15

/**
 * A joint beside it could not be where the option asks for it: it is in the middle between its
 * control points, or, for GUSSET_JOINT_PARAMETER_G2, the curvature there is 0.
 */
#define GUSSET_POINT_JOINT_FELL_BACK 16

/**
 * It is on a composite curve, as the single one failed.
 */
#define GUSSET_POINT_COMPOSITE_INSTEAD 17

/**
 * A blended curve turns back at it: it stands still there, or leaves the way it came.
 */
#define GUSSET_POINT_CUSP 18

/**
 * As asked.
 */
#define GUSSET_FIT_OK 0

/**
 * Some points are not as asked, in other ways than merged or clamped: see their status.
 */
#define GUSSET_FIT_PARTIAL 1

/**
 * The iteration ended before it was still.
 */
#define GUSSET_FIT_NOT_CONVERGED 2

/**
 * The iteration ran away, or control points are beyond the largest number.
 */
#define GUSSET_FIT_DIVERGED 3

/**
 * The equations are so nearly singular that control points lie far outside the outline.
 */
#define GUSSET_FIT_ILL_CONDITIONED 4

/**
 * Fewer than two different points, or three of a closed outline: there is no curve, or what two
 * points give.
 */
#define GUSSET_FIT_TOO_FEW_POINTS 5

/**
 * A single curve would have a degree above 64; a composite one took its place.
 */
#define GUSSET_FIT_DEGREE_TOO_HIGH 6

/**
 * Coordinates are 32-bit floats.
 */
#define GUSSET_F32 1

/**
 * Coordinates are 64-bit floats.
 */
#define GUSSET_F64 2

/**
 * Indices and face offsets are 32-bit unsigned integers.
 */
#define GUSSET_U32 0

/**
 * Reserved: this version refuses it (GUSSET_ERROR_UNKNOWN_VALUE).
 */
#define GUSSET_U64 1

/**
 * The pieces begin where their positions say, or where poses move them if these are given.
 */
#define GUSSET_ALIGN_AS_GIVEN 0

/**
 * Each piece begins with its principal axes on those of the first one, in the one of the four ways
 * to do so after which most of it lies on the first. For pieces that show the same object whole.
 */
#define GUSSET_ALIGN_PRINCIPAL_AXES 1

/**
 * The pieces are put together by rims that run alike, and it is their rims that hold them then:
 * for pieces of one surface that was cut or broken and do not overlap.
 */
#define GUSSET_ALIGN_RIMS 2

/**
 * It can be trusted to lie right: it fits pieces that can be trusted, up to the first one. What
 * fits is judged by mean edges: a smooth surface that lies within one of another, as a slightly
 * scaled one or its mirror image may, passes for it. The rms of its overlaps, and converged, say
 * more.
 * Pieces that hold each other fast, but could slide together along the rest, pass, too.
 */
#define GUSSET_ALIGNED_TRUSTED 0

/**
 * It has no faces with an area, or too little of it lies on other pieces.
 */
#define GUSSET_ALIGNED_NO_OVERLAP 1

/**
 * Where it is near others, too much of it lies off them.
 */
#define GUSSET_ALIGNED_POOR_FIT 2

/**
 * The overlaps leave it free to slide or to turn, as planes, spheres or cylinders do.
 */
#define GUSSET_ALIGNED_UNDETERMINED 3

/**
 * Most of what lies on other pieces faces the other way: it is inside out, or mirrored.
 */
#define GUSSET_ALIGNED_FACES_OTHER_WAY 4

/**
 * It lies on no other piece, and is more than fifty times as large or small as the first one: its
 * unit of length is another, most likely.
 */
#define GUSSET_ALIGNED_OTHER_SIZE 5

/**
 * It fits pieces that cannot be trusted only.
 */
#define GUSSET_ALIGNED_TRUSTED_BY_NONE 6

/**
 * A strip joins them.
 */
#define GUSSET_JOINT_JOINED 0

/**
 * Left: joining them would make a one-sided surface with what is joined already.
 */
#define GUSSET_JOINT_ORIENTATION_CONFLICT 1

/**
 * Left: they pass the same vertex.
 */
#define GUSSET_JOINT_SHARE_VERTEX 2

/**
 * Left: every strip would repeat an edge that the mesh already has.
 */
#define GUSSET_JOINT_NO_STRIP 3

/**
 * Left: between pieces whose overlaps were trimmed, as every strip would cut other faces. It is a
 * part of a hole then.
 */
#define GUSSET_JOINT_WOULD_CUT 4

/**
 * There is no other loop.
 */
#define GUSSET_LEFT_ALONE 0

/**
 * It is open, or the faces along it disagree in orientation or are not manifold there.
 */
#define GUSSET_LEFT_NOT_SIMPLE 1

/**
 * It has fewer than three vertices.
 */
#define GUSSET_LEFT_TOO_SHORT 2

/**
 * It faces another loop, but no strip could be made: see the joints.
 */
#define GUSSET_LEFT_NOT_JOINED 3

/**
 * The nearest loop is farther away than is allowed; or the loop is what sewing left of two
 * borders, and its two sides are. See gap and allowed_gap.
 */
#define GUSSET_LEFT_TOO_FAR 4

/**
 * All other loops are of its own component, and within_components is not set.
 */
#define GUSSET_LEFT_SAME_COMPONENT 5

/**
 * The nearest loop is near enough, but they do not look at each other along enough of both.
 */
#define GUSSET_LEFT_LOOKS_AWAY 6

/**
 * The nearest loop is joined with another.
 */
#define GUSSET_LEFT_TAKEN 7

/**
 * It is not to be joined with the nearest loop.
 */
#define GUSSET_LEFT_EXCLUDED 8

/**
 * Coincident borders are sewn, by default up to what rounding can have done; see
 * gusset_weld_options. Where their vertices do not match, edges are split; see gusset_sew_create.
 */
#define GUSSET_ASSEMBLY_WELD 0

/**
 * Nothing is welded.
 */
#define GUSSET_ASSEMBLY_NO_WELD 1

/**
 * Coincident borders are sewn where they match vertex by vertex; see gusset_weld_create.
 */
#define GUSSET_ASSEMBLY_WELD_EDGE_TO_EDGE 2

/**
 * Whole loops are joined if the mean width of the gap is at most a fifth of the larger component's
 * size along an axis, or the mean radius of the smaller loop (the mean distance of its vertices
 * from their centre) if that is more; two loops that are the only ones, of two pieces, whatever it
 * is. Runs of loops are joined where the gap is at most half that radius wide, and four edges of
 * the loop with the longer ones. The width is the mean distance from each loop to the nearest
 * points of the other, the larger of the two. Loops must look at each other, or lie round each
 * other: of all that do, the best one-to-one choice is joined. What sewing left of two borders is
 * joined with itself if it is at most one of its mean edges wide, and half its radius; wider it
 * may be a hole that the seam crosses.
 * Between pieces whose overlaps are trimmed, the gap is at most two and a half mean edges of the
 * coarsest wide, or four where a part would be left alone.
 */
#define GUSSET_GAP_AUTO 0

/**
 * Gaps are closed up to max_gap.
 */
#define GUSSET_GAP_GIVEN 1

/**
 * Pieces that overlap stay as they are.
 */
#define GUSSET_OVERLAPS_KEEP 0

/**
 * Of each overlap one piece is kept, as gusset_trim_create chooses, and the gaps that this leaves
 * are closed as others are. Strips that would cut other faces are left to the holes.
 */
#define GUSSET_OVERLAPS_TRIM 1

/**
 * At an edge with three or more faces each face has a border of its own; loops run along it and
 * are always closed.
 */
#define GUSSET_NON_MANIFOLD_CUT 0

/**
 * Only edges with exactly one face belong to loops; one that meets an edge with more ends there,
 * as an open chain.
 */
#define GUSSET_NON_MANIFOLD_STOP 1

/**
 * Every edge is looked at: all that is wrong or unusual in the mesh is reported, and flagged on
 * the loops.
 */
#define GUSSET_SURVEY_WHOLE_MESH 0

/**
 * As little is looked at as will give the loops, which is many times faster. Where the boundary
 * itself is odd (open, touching itself, badly oriented, with three faces on an edge) the whole
 * mesh is looked at after all. But what is away from the boundary is not reported, nor an edge
 * with as many faces one way as the other, two or more each; loops are not cut there. The answer
 * rests on sums of hashes: an ordinary mesh errs with a chance of less than 2^-64, but one that
 * was made to deceive may hide a boundary. For meshes from hostile hands take
 * GUSSET_SURVEY_WHOLE_MESH.
 */
#define GUSSET_SURVEY_BOUNDARY_ONLY 1

/**
 * The chain does not close: it has one vertex more than it has edges.
 */
#define GUSSET_LOOP_OPEN 1

/**
 * The loop passes a vertex where the surface touches itself.
 */
#define GUSSET_LOOP_BOW_TIE 2

/**
 * It was cut from a longer walk at a vertex that the walk passed twice.
 */
#define GUSSET_LOOP_SPLIT 4

/**
 * It runs along, or ends at, an edge with three or more faces.
 */
#define GUSSET_LOOP_NON_MANIFOLD 8

/**
 * The faces along it disagree in orientation.
 */
#define GUSSET_LOOP_NOT_ORIENTED 16

/**
 * It has an edge of length 0.
 */
#define GUSSET_LOOP_ZERO_LENGTH 32

/**
 * The loop runs this edge against its face.
 */
#define GUSSET_EDGE_REVERSED 1

/**
 * The edge has three or more faces.
 */
#define GUSSET_EDGE_NON_MANIFOLD 2

/**
 * The edge has length 0.
 */
#define GUSSET_EDGE_ZERO_LENGTH 4

/**
 * A face (index) that repeats a vertex (other).
 */
#define GUSSET_DEFECT_DEGENERATE_FACE 1

/**
 * An edge whose two faces run it in the same direction: half-edges index and other.
 */
#define GUSSET_DEFECT_ORIENTATION_CONFLICT 2

/**
 * An edge with three or more half-edges (count; a face that runs it twice counts twice): its first
 * half-edge is index.
 */
#define GUSSET_DEFECT_NON_MANIFOLD_EDGE 3

/**
 * A vertex (index) where the surface touches itself: its faces form more than one fan. Fans end at
 * edges with three or more faces, whose own ends are therefore listed too where a loop passes them.
 */
#define GUSSET_DEFECT_BOW_TIE 4

/**
 * There are edges, and every one has exactly two faces; degenerate faces have none.
 */
#define GUSSET_MESH_CLOSED 1

/**
 * No non-manifold edge and no non-manifold vertex.
 */
#define GUSSET_MESH_MANIFOLD 2

/**
 * No edge whose two faces run it in the same direction.
 */
#define GUSSET_MESH_ORIENTED 4

/**
 * Faces can be turned over so that it becomes oriented.
 */
#define GUSSET_MESH_ORIENTABLE 8

/**
 * Lengths and areas: stretch and compression count alike, by the symmetric Dirichlet energy.
 */
#define GUSSET_DISTORTION_SYMMETRIC 0

/**
 * Lengths: as rigid as possible.
 */
#define GUSSET_DISTORTION_RIGID 1

/**
 * Angles: a least squares conformal map, which may stretch areas.
 */
#define GUSSET_DISTORTION_CONFORMAL 2

/**
 * By unfolding about edges: every edge has its length.
 */
#define GUSSET_CHART_EXACT 0

/**
 * By descent until nothing was gained.
 */
#define GUSSET_CHART_CONVERGED 1

/**
 * By descent, ended by the number of steps.
 */
#define GUSSET_CHART_ITERATION_LIMIT 2

/**
 * The conformal map that was asked for.
 */
#define GUSSET_CHART_CONFORMAL 3

/**
 * The conformal map folds or overlaps: the chart has the least symmetric distortion instead.
 */
#define GUSSET_CHART_NOT_CONFORMAL 4

/**
 * No map without folds was found: some triangles are turned over.
 */
#define GUSSET_CHART_FOLDED 5

/**
 * By descent until no step was possible that gains: the border would meet itself, or rounding hides
 * it. Cuts or darts may help.
 */
#define GUSSET_CHART_STALLED 6

/**
 * On a path that was given.
 */
#define GUSSET_CUT_GIVEN 0

/**
 * To make a disc of a chart.
 */
#define GUSSET_CUT_OPENING 1

/**
 * For a dart.
 */
#define GUSSET_CUT_DART 2

/**
 * The best continuation of the surface round the hole: the least sum of 2 sin(t / 2) over all edges,
 * the rim's included, t being the angle between the normals on both sides, and over the triangles of
 * the mean square of how far the surface that was there is likely to have been from them, as its
 * tangent planes at the rim say, in units of 1 / 140 of its length. By area alone if it is planar.
 */
#define GUSSET_WEIGHT_CONTINUATION 0

/**
 * The least sum of areas and, for each edge, the rim's included, squared length times 1 - cosine
 * of the angle between its faces.
 */
#define GUSSET_WEIGHT_AREA_AND_BEND 1

/**
 * The least largest angle between neighbouring faces, those beyond the rim included, and then the
 * least area, as Liepa has it.
 */
#define GUSSET_WEIGHT_BEND_THEN_AREA 2

/**
 * The least area, exactly.
 */
#define GUSSET_WEIGHT_AREA 3

/**
 * All loops are holes.
 */
#define GUSSET_KEEP_NONE 0

/**
 * The longest loop is none: the outline of an open sheet.
 */
#define GUSSET_KEEP_LONGEST 1

/**
 * Loops are none that go round a sheet rather than a hole in it, so that a patch would lie on the
 * sheet: whose area vector points as that of their component, and is at least half as long as its
 * area.
 */
#define GUSSET_KEEP_BORDERS 2

/**
 * Each loop gets a patch of its own.
 */
#define GUSSET_TOGETHER_APART 0

/**
 * All loops that are filled get one patch: a surface of genus 0 between them. If they are not in one
 * plane, up to some 160 loops.
 */
#define GUSSET_TOGETHER_ONE 1

/**
 * Loops get one patch where that costs less, by the weight asked for, than patches of their own.
 * Loops whose boxes, each larger on all sides by half its diagonal, meet are tried, the pair that
 * gains most first: about 8 pairs for each loop and 256 in all, as the log says, and at most 16
 * loops for a patch. By area alone the ends of a short tube cost less together, along the tube
 * itself.
 */
#define GUSSET_TOGETHER_CHEAPEST 2

/**
 * Triangles between the vertices of the rims.
 */
#define GUSSET_PATCH_PLAIN 0

/**
 * With new vertices, where the plain triangles are, but for those beside creases that go on.
 */
#define GUSSET_PATCH_REFINED 1

/**
 * With new vertices, faired.
 */
#define GUSSET_PATCH_FAIRED 2

/**
 * No new vertices.
 */
#define GUSSET_REFINE_NONE 0

/**
 * New vertices as dense as those round the hole.
 */
#define GUSSET_REFINE_RIM_DENSITY 1

/**
 * Faired patches leave the old surface along its tangent planes: the plate's squared Laplacian is
 * least.
 */
#define GUSSET_CONTINUITY_C1 0

/**
 * They go on with its curvature, too: the squared gradient of the Laplacian is least. Two rings of old
 * faces round each rim have a say, and with them their noise.
 */
#define GUSSET_CONTINUITY_C2 1

/**
 * Filled; with plan_only, to be filled.
 */
#define GUSSET_HOLE_FILLED 0

/**
 * Left: it is no hole, as keep has it.
 */
#define GUSSET_HOLE_KEPT 1

/**
 * Left: it exceeds max_edges, max_length, max_diameter or max_area.
 */
#define GUSSET_HOLE_TOO_LARGE 2

/**
 * Left: an open chain.
 */
#define GUSSET_HOLE_OPEN 3

/**
 * Left: it runs along an edge with three or more faces.
 */
#define GUSSET_HOLE_NON_MANIFOLD 4

/**
 * Left: the faces along it disagree in orientation.
 */
#define GUSSET_HOLE_NOT_ORIENTED 5

/**
 * Left: a given loop of fewer than three vertices, or one that passes a vertex twice.
 */
#define GUSSET_HOLE_NOT_SIMPLE 6

/**
 * Left: an edge of a given loop does not have exactly one face, or is one of a loop before it.
 */
#define GUSSET_HOLE_NOT_FREE 7

/**
 * Left: every triangulation would have an edge between two vertices of one old face, which is an
 * edge of the mesh or becomes one once its polygons are cut into triangles; or none was found that
 * closes all loops together which are to get one patch, as where two of them share a vertex.
 */
#define GUSSET_HOLE_NO_TRIANGULATION 8

/**
 * Closed components face as most of their faces did; those of a stitch or of a filled mesh stay as
 * they are.
 */
#define GUSSET_OUTWARD_KEEP 0

/**
 * Closed components face outwards, each by its own volume: of shells inside one another each one
 * encloses what is within it, and the wall of a cavity is turned over too. One whose volume is 0 up
 * to rounding is as with GUSSET_OUTWARD_KEEP. Of a stitch or of a filled mesh, components that are
 * closed (every edge has two faces), consistently oriented and inside out are turned over, each as
 * a whole; all others stay as they are.
 */
#define GUSSET_OUTWARD_CLOSED 1

/**
 * The strip of triangles that best continues both surfaces, near the strip of least area: little
 * turn between neighbours, along the rims above all, and meridians that lie on the surface which
 * the faces beside the rims suggest. Between lines without faces (gusset_strip_create) the strip
 * of least area.
 */
#define GUSSET_MERIDIANS_CONTINUATION 0

/**
 * The paper's rule by index, O(N + M): good for evenly spaced rims.
 */
#define GUSSET_MERIDIANS_INDEX 1

/**
 * Both rims walked at the same pace, by arc length, O(N + M).
 */
#define GUSSET_MERIDIANS_ARC_LENGTH 2

/**
 * Always on to the shorter of the two next meridians, O(N + M).
 */
#define GUSSET_MERIDIANS_GREEDY 3

/**
 * The strip of triangles whose meridians have the least total length.
 */
#define GUSSET_MERIDIANS_MIN_DIAGONAL 4

/**
 * The strip of triangles with the least bends: the sum over its edges, rims included, of length
 * times (1 - cos of the angle between the normals).
 */
#define GUSSET_MERIDIANS_SMOOTH 5

/**
 * The least sum of the meridians' squared lengths where steps on both rims at once are allowed
 * (dynamic time warping): quads where both sides advance, triangles elsewhere. Meant for strips
 * with interior rows.
 */
#define GUSSET_MERIDIANS_QUAD 6

/**
 * The strip of triangles of least area through the first meridian.
 */
#define GUSSET_MERIDIANS_MIN_AREA 7

/**
 * The best meridians are found exactly for up to 2^21 pairs of vertices, beyond that coarse to
 * fine: nearly linear time, linear memory, and a result within a few hundredths of a per cent of
 * the best on all rims that were measured.
 */
#define GUSSET_SEARCH_AUTO 0

/**
 * Exactly: O(N M) time, and memory for each pair of vertices; see gusset_stitch_create.
 */
#define GUSSET_SEARCH_EXACT 1

/**
 * The first meridian of a closed band joins the closest pair of vertices, or the closest pair
 * after rim B has been turned along rim A to where it fits best; the better strip of the two is
 * kept.
 */
#define GUSSET_START_AUTO 0

/**
 * The closest pair.
 */
#define GUSSET_START_CLOSEST 1

/**
 * gusset_strip_create only: the first points.
 */
#define GUSSET_START_GIVEN 2

/**
 * New vertices stay where they were first put: those of a strip divide their meridians evenly, as
 * the paper has it, those of a patch lie on the triangles of its first triangulation.
 */
#define GUSSET_FAIRING_NONE 0

/**
 * New vertices are moved so that the new surface bends as a thin plate does and meets the old one
 * smoothly: the sum of the squared Laplacians over them and the rims is least. The rims, and the
 * ends of an open strip, stay where they are.
 */
#define GUSSET_FAIRING_THIN_PLATE 1

/**
 * Faces of the strip that cut others are looked for, and what can be done about them is done:
 * - a strip of triangles without rows by GUSSET_MERIDIANS_CONTINUATION goes another way where it
 *   cuts, and of the strips tried the one that cuts least is kept;
 * - faired rows are taken back in places, up to 12 times, until nothing cuts or nothing is left to
 *   take back; if the straight rows cut less in the end, they are kept;
 * - blends are taken back likewise, and made with less fairing where they still cut; the one that
 *   cuts least is kept, or the strip if that cuts less than every blend.
 *
 * All other strips stay as they are: rows that are not faired, quads, and other meridians.
 */
#define GUSSET_INTERSECTIONS_AUTO 0

/**
 * They are not looked for: rows are faired in full, and the first blend is kept.
 */
#define GUSSET_INTERSECTIONS_IGNORE 1

/**
 * They are looked for. Faired rows and blends are taken back as with GUSSET_INTERSECTIONS_AUTO,
 * and no strip goes another way, nor does the strip that a blend follows.
 */
#define GUSSET_INTERSECTIONS_REPORT 2

/**
 * A second piece that is oriented against the first is turned over: the component that rim B is
 * on. Which of the two is inside out is not asked: see GUSSET_OUTWARD_CLOSED for what is closed in
 * the end. Two loops of one connected piece are taken as they are. Whole rims are compared as
 * curves, and by where their surfaces lie if both lead off them to the same side, as at the ends
 * of a U-bend; where nothing is clear, nothing is turned.
 */
#define GUSSET_ORIENTATION_FIX 0

/**
 * Such a piece is GUSSET_ERROR_ORIENTATION_CONFLICT.
 */
#define GUSSET_ORIENTATION_REFUSE 1

/**
 * The rims are not compared: the faces are taken to be right as they are.
 */
#define GUSSET_ORIENTATION_KEEP 2

/**
 * All of both loops, by a closed band.
 */
#define GUSSET_EXTENT_WHOLE_LOOPS 0

/**
 * The runs of vertices that face the other loop, as the paper has it:
 * GUSSET_ERROR_PLANES_UNDECIDED where it cannot tell.
 */
#define GUSSET_EXTENT_OPEN_ARCS 1

/**
 * Whole loops if their normals make less than 60 degrees, in the mean of cosines, with the line of
 * their centres, or if the planes cannot tell; else open arcs.
 */
#define GUSSET_EXTENT_AUTO 2

/**
 * The arcs given in arc_a and arc_b. Of a loop that is not given, place 0 is where
 * gusset_boundary_get_loop has it.
 */
#define GUSSET_EXTENT_ARCS 3

/**
 * Of several runs of facing vertices, on each loop the one with the closest pair.
 */
#define GUSSET_RUN_CLOSEST 0

/**
 * On each loop the one of the most vertices.
 */
#define GUSSET_RUN_LONGEST 1

/**
 * The centre of a loop is the mean of its vertices, as the paper has it.
 */
#define GUSSET_CENTRES_VERTICES 0

/**
 * The mean of its points: vertices that lie close together do not draw it to them.
 */
#define GUSSET_CENTRES_LENGTH 1

/**
 * No interior rows: every meridian is one edge.
 */
#define GUSSET_ROWS_NONE 0

/**
 * max(0, round(mean meridian / mean side of the faces of both meshes) - 1), as the paper suggests.
 */
#define GUSSET_ROWS_MEAN_EDGE 1

/**
 * As many as row_count says.
 */
#define GUSSET_ROWS_COUNT 2

/**
 * Triangles throughout; quads are split by their shorter diagonals.
 */
#define GUSSET_CELLS_TRIANGLES 0

/**
 * Quads where four different neighbours meet, and triangles where a rim repeats a vertex.
 */
#define GUSSET_CELLS_QUADS 1

/**
 * The strip of meridians, with its rows.
 */
#define GUSSET_FINISH_STRIP 0

/**
 * The best-looking joint: triangles about as fine as those round the rims, graded between them,
 * without sharp angles where the rims allow it, on a surface that leaves both pieces along their
 * tangents. The strip, without rows, says which way it goes: meridians and matrix are its own, and
 * no edges of the result; rows, cells and fairing are not read (the log says so if they are set).
 * Where every blend would cut more faces than the strip does, the strip stays; the log says so.
 * The surface bends as the strip does as a whole, without its ridges: a gap in a tube is bridged
 * by a tube, to within some per cent of its radius across a few radii. Time and memory grow with
 * the number of new triangles. Where sides as short as those round the rims would take more than
 * about 50,000 new vertices, or 16 for each of the rims', the sides are up to twice as long; where
 * that is not enough, the strip stays, and the log says so.
 */
#define GUSSET_FINISH_BLEND 1

/**
 * No tolerance is given, and what rounding can do to the coordinates is taken. For vertices that
 * face another loop that is at most 2^-16 of the loops' largest coordinate for 32-bit positions,
 * 2^-45 for 64-bit ones; for vertices that are welded see gusset_weld_options.
 */
#define GUSSET_TOLERANCE_AUTO 0

/**
 * The tolerance is the one given.
 */
#define GUSSET_TOLERANCE_GIVEN 1

/**
 * The tolerance is 0: of vertices that are welded, the positions are equal.
 */
#define GUSSET_TOLERANCE_EXACT 2

/**
 * The ends of free edges are welded: borders that lie on one another are sewn, edge to edge.
 */
#define GUSSET_WELD_BOUNDARY 0

/**
 * All vertices that faces use are welded, as triangle soups need it.
 */
#define GUSSET_WELD_ALL 1

/**
 * Corners of one face stay apart.
 */
#define GUSSET_COLLAPSE_NEVER 0

/**
 * Corners of one face may become one; a face that keeps fewer than three different vertices is
 * dropped.
 */
#define GUSSET_COLLAPSE_ALLOW 1

/**
 * Vertices that no face uses stay.
 */
#define GUSSET_UNUSED_KEEP 0

/**
 * Vertices that no face of the result uses are left out.
 */
#define GUSSET_UNUSED_REMOVE 1

/**
 * Faces are stored counter-clockwise seen from outside, as modern libraries have it; the tables
 * take them backwards.
 */
#define GUSSET_FACES_COUNTER_CLOCKWISE 0

/**
 * Faces are stored clockwise seen from outside, as Baumgart has it.
 */
#define GUSSET_FACES_CLOCKWISE 1

/**
 * One of several records of an edge with three or more faces; each has one face.
 */
#define GUSSET_WINGED_NON_MANIFOLD 1

/**
 * One of two records of an edge whose faces run it in the same direction; each has one face.
 */
#define GUSSET_WINGED_NOT_ORIENTED 2

/**
 * M = N, or the edge belongs to a face of fewer than three proper edges.
 */
#define GUSSET_WINGED_DEGENERATE 4

/**
 * No edge has one face only.
 */
#define GUSSET_NET_CLOSED 1

/**
 * A surface, with or without boundary: no wires, branches and pinches.
 */
#define GUSSET_NET_MANIFOLD 2

/**
 * No edge that two faces run along the same way.
 */
#define GUSSET_NET_ORIENTED 4

/**
 * Faces can be turned over so that there is none.
 */
#define GUSSET_NET_ORIENTABLE 8

/**
 * No pyramid has more levels.
 */
#define GUSSET_PYRAMID_LEVELS 32

/**
 * What a function returns; `GUSSET_OK` is 0.
 */
enum gusset_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * Success.
     */
    GUSSET_OK = 0,
    /**
     * A pointer that must not be NULL is NULL.
     */
    GUSSET_ERROR_NULL_ARGUMENT = 1,
    /**
     * A pointer to a struct, a handle or an output is not aligned for it. (Element arrays may have
     * any alignment.)
     */
    GUSSET_ERROR_MISALIGNED_ARGUMENT = 2,
    /**
     * struct_size is smaller than the first version of the struct.
     */
    GUSSET_ERROR_BAD_STRUCT_SIZE = 3,
    /**
     * An enumerator, a reserved field or a field unknown to this version has an unknown value.
     */
    GUSSET_ERROR_UNKNOWN_VALUE = 4,
    /**
     * An option is outside its range.
     */
    GUSSET_ERROR_OUT_OF_RANGE = 5,
    /**
     * The caller's buffer is too small; nothing was written but the size needed.
     */
    GUSSET_ERROR_BUFFER_TOO_SMALL = 6,
    /**
     * The context is in use by another call: on another thread, or further up this one's stack.
     */
    GUSSET_ERROR_CONTEXT_BUSY = 7,
    /**
     * There is no element of this index.
     */
    GUSSET_ERROR_NO_SUCH_ELEMENT = 8,
    /**
     * A stride is smaller than what lies at each step of it.
     */
    GUSSET_ERROR_BAD_STRIDE = 9,
    /**
     * Exactly one of face_offsets and face_size must be given.
     */
    GUSSET_ERROR_BAD_FACE_LAYOUT = 10,
    /**
     * Arrays that the library would write to overlap.
     */
    GUSSET_ERROR_OVERLAP = 11,
    /**
     * A handle is of another kind than the function takes, or was destroyed. (That is seen where the
     * memory has not been used again; a pointer to anything else cannot be told.)
     */
    GUSSET_ERROR_WRONG_HANDLE = 12,
    /**
     * Values are given for another number of inputs, or of elements of one, than there are.
     */
    GUSSET_ERROR_COUNT_DIFFERS = 13,
    /**
     * More vertices, faces or half-edges than this version takes.
     */
    GUSSET_ERROR_TOO_LARGE = 1000,
    /**
     * The bytes of an array exceed the address space.
     */
    GUSSET_ERROR_SIZE_OVERFLOW = 1001,
    /**
     * A mesh without vertices or without faces, or no mesh at all.
     */
    GUSSET_ERROR_EMPTY_MESH = 1002,
    /**
     * Offsets, of faces, outlines or segments, do not start at 0, decrease, or end elsewhere than
     * their elements.
     */
    GUSSET_ERROR_BAD_OFFSETS = 1003,
    /**
     * A face of fewer than three corners.
     */
    GUSSET_ERROR_FACE_TOO_SMALL = 1004,
    /**
     * A face names a vertex that does not exist.
     */
    GUSSET_ERROR_INDEX_OUT_OF_RANGE = 1005,
    /**
     * A number is NaN or infinite: a coordinate of a vertex that a face uses, of a point, a tangent,
     * a query or a node, or a value of a channel.
     */
    GUSSET_ERROR_NOT_FINITE = 1006,
    /**
     * The second mesh, or a later piece, has f64 positions and the first f32.
     */
    GUSSET_ERROR_MIXED_SCALARS = 1007,
    /**
     * A record of a winged-edge table fits no mesh.
     */
    GUSSET_ERROR_BAD_WINGS = 1008,
    /**
     * A merge map leads to a vertex that does not exist, or to one that is not one with itself.
     */
    GUSSET_ERROR_BAD_MERGE = 1009,
    /**
     * A face passes a vertex twice, where each face needs a shape.
     */
    GUSSET_ERROR_REPEATED_CORNER = 1010,
    /**
     * There is no boundary loop that can be stitched, or of one mesh there are no two.
     */
    GUSSET_ERROR_NO_LOOP = 1100,
    /**
     * A loop of fewer than three vertices.
     */
    GUSSET_ERROR_LOOP_TOO_SHORT = 1101,
    /**
     * A loop passes a vertex twice.
     */
    GUSSET_ERROR_LOOP_REPEATS_VERTEX = 1102,
    /**
     * Consecutive vertices of a loop are not joined by an edge with exactly one face.
     */
    GUSSET_ERROR_LOOP_EDGE_NOT_FREE = 1103,
    /**
     * Both loops pass the same vertex of the same mesh.
     */
    GUSSET_ERROR_LOOPS_SHARE_VERTEX = 1104,
    /**
     * The faces along a loop disagree in orientation.
     */
    GUSSET_ERROR_LOOP_NOT_ORIENTED = 1105,
    /**
     * The second piece is oriented against the first, and the options refuse to turn it over.
     */
    GUSSET_ERROR_ORIENTATION_CONFLICT = 1106,
    /**
     * Every strip through the first meridian would repeat an edge that the mesh already has.
     */
    GUSSET_ERROR_NO_STRIP = 1107,
    /**
     * The planes through the loops' centres cannot tell which vertices face each other: such loops
     * are joined whole.
     */
    GUSSET_ERROR_PLANES_UNDECIDED = 1108,
    /**
     * Vertices that follow one another in a cut are not connected by edges.
     */
    GUSSET_ERROR_CUT_NOT_CONNECTED = 1109,
    /**
     * A closed curve does not end where it begins.
     */
    GUSSET_ERROR_CURVE_NOT_CLOSED = 1200,
    /**
     * A control point of what must be a plane curve has z other than 0.
     */
    GUSSET_ERROR_CURVE_NOT_PLANE = 1201,
    /**
     * A curve without segments, or without points, where one is needed.
     */
    GUSSET_ERROR_EMPTY_CURVE = 1202,
    /**
     * A section of a frame has another number of points than the first one.
     */
    GUSSET_ERROR_SECTIONS_DIFFER = 1210,
    /**
     * A section of a frame, or a plane, does not meet a column.
     */
    GUSSET_ERROR_NO_NODE = 1211,
    /**
     * A net of fewer than two rows or columns.
     */
    GUSSET_ERROR_NET_TOO_SMALL = 1300,
    /**
     * A gluing makes both pairs of opposite corners of a cell one each, which no surface allows.
     */
    GUSSET_ERROR_CROSSING_CELL = 1301,
    /**
     * A seam is empty, leaves the net, or repeats one pair of nodes.
     */
    GUSSET_ERROR_BAD_SEAM = 1302,
    /**
     * Sides of nets to be joined have different numbers of nodes, or do not lie on each other.
     */
    GUSSET_ERROR_SIDES_DIFFER = 1303,
    /**
     * Faces of a mesh are no rectangular grid of quads, or triangles no such grid with diagonals.
     */
    GUSSET_ERROR_NO_GRID = 1304,
    /**
     * A stream is damaged, cut off, or none of ours.
     */
    GUSSET_ERROR_BAD_STREAM = 1305,
    /**
     * A group of a scene would contain itself.
     */
    GUSSET_ERROR_SCENE_CYCLE = 1306,
    /**
     * A scene without nets.
     */
    GUSSET_ERROR_EMPTY_SCENE = 1307,
    /**
     * A field of deformation is not defined at a node.
     */
    GUSSET_ERROR_FIELD_UNDEFINED = 1320,
    /**
     * A net is glued elsewhere than along whole sides, or has bridges.
     */
    GUSSET_ERROR_GLUED_INSIDE = 1321,
    /**
     * Two nets are glued differently.
     */
    GUSSET_ERROR_GLUINGS_DIFFER = 1322,
    /**
     * Knots of a spline: their number does not fit, or one is out of order or repeated too often.
     */
    GUSSET_ERROR_BAD_KNOTS = 1410,
    /**
     * Curves of a net do not meet, or not in the order given.
     */
    GUSSET_ERROR_CURVES_APART = 1411,
    /**
     * Memory could not be had.
     */
    GUSSET_ERROR_OUT_OF_MEMORY = 2000,
    /**
     * The host cancelled.
     */
    GUSSET_ERROR_CANCELLED = 2001,
    /**
     * A defect of the library; the context and all handles remain usable.
     */
    GUSSET_ERROR_PANIC = 9999,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum gusset_status gusset_status;
#else
typedef int32_t gusset_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * Where pieces that overlap belong. Opaque and immutable; it keeps nothing of them.
 */
typedef struct gusset_alignment gusset_alignment;

/**
 * An assembled mesh and its account. Opaque and immutable; it keeps nothing of the pieces.
 */
typedef struct gusset_assembly gusset_assembly;

/**
 * The free boundary loops of a mesh. Opaque and immutable; it keeps nothing of the mesh.
 */
typedef struct gusset_boundary gusset_boundary;

/**
 * What a check found. Opaque and immutable; it keeps nothing of the mesh.
 */
typedef struct gusset_check gusset_check;

/**
 * Threads, progress, cancel, log, and the outcome of the last call. Opaque; one thread uses it at
 * a time, but gusset_context_cancel and gusset_context_get_progress may be called from any.
 */
typedef struct gusset_context gusset_context;

/**
 * A curve of Bézier segments. Opaque and immutable; it owns its control points, and may be used
 * from many threads.
 */
typedef struct gusset_curve gusset_curve;

/**
 * A curve in another form. Opaque and immutable; it keeps nothing of the curve.
 */
typedef struct gusset_curve_form gusset_curve_form;

/**
 * A surface in the plane. Opaque and immutable; it keeps nothing of the mesh it was made from.
 */
typedef struct gusset_development gusset_development;

/**
 * Which vertices of two loops face each other. Opaque and immutable; it keeps nothing of the
 * points.
 */
typedef struct gusset_facing gusset_facing;

/**
 * A mesh with holes filled. Opaque and immutable; it keeps nothing of the mesh it was made from.
 */
typedef struct gusset_fill gusset_fill;

/**
 * Nodes, and curves across and along a body through them. Opaque and immutable; it keeps nothing
 * of the points.
 */
typedef struct gusset_frame gusset_frame;

/**
 * A net: H x W nodes in three coordinate matrices, and what is glued to what. Functions that take
 * it as const may run at the same time in many threads; those that change it need it for
 * themselves.
 */
typedef struct gusset_net gusset_net;

/**
 * What a deformation does to a net. Immutable; may be read from many threads.
 */
typedef struct gusset_net_analysis gusset_net_analysis;

/**
 * The quotient complex of a net: what surface it is. Opaque and immutable; it keeps nothing of the
 * net.
 */
typedef struct gusset_net_complex gusset_net_complex;

/**
 * A net that was found in a mesh. Opaque and immutable; it keeps nothing of the mesh.
 */
typedef struct gusset_net_grid gusset_net_grid;

/**
 * The points that are several nodes. Opaque and immutable; it keeps nothing of the net.
 */
typedef struct gusset_net_groups gusset_net_groups;

/**
 * The mesh of a net. Opaque and immutable; it keeps nothing of the net.
 */
typedef struct gusset_net_mesh gusset_net_mesh;

/**
 * What a validation found. Opaque and immutable; it keeps nothing of the net.
 */
typedef struct gusset_net_validation gusset_net_validation;

/**
 * An oriented mesh. Opaque and immutable; it keeps nothing of the mesh it was made from.
 */
typedef struct gusset_orient gusset_orient;

/**
 * For each vertex, corner and face of a result, the elements of the inputs that it has its values
 * from. Opaque and immutable; it keeps nothing of the result.
 *
 * An element that was there before has itself, and a vertex that several became all of them in
 * equal parts. A new vertex has the vertices of the rims round it, by where it would be on plain
 * triangles between them without fairing, and one that was put on an edge the ends of the edge. A
 * new face has the face across the nearest edge of the rims (the first one of those as near), and at
 * its corners what old faces have there: those on its own side where it has an edge in common with
 * them.
 */
typedef struct gusset_origins gusset_origins;

/**
 * The curves of outlines. Opaque and immutable; it keeps nothing of the points.
 */
typedef struct gusset_outline gusset_outline;

/**
 * Crossings, intersections or samples. Opaque and immutable; it keeps nothing of the curves.
 */
typedef struct gusset_places gusset_places;

/**
 * Nets in groups in groups, at any depth; an entry may be in several groups. Entries are known by
 * indices, which are never given twice. Functions that take it as const may run at the same time
 * in many threads; those that change it need it for themselves.
 */
typedef struct gusset_scene gusset_scene;

/**
 * The sections of outlines. Opaque and immutable.
 */
typedef struct gusset_sections gusset_sections;

/**
 * A sewn mesh. Opaque and immutable; it keeps nothing of the mesh it was made from.
 */
typedef struct gusset_sew gusset_sew;

/**
 * A piece of surface: rows and columns of cells, each a Bézier patch. Opaque and immutable: all
 * functions may use it from any thread, and many at the same time, each with a context of its own;
 * it is destroyed when none uses it any more.
 */
typedef struct gusset_sheet gusset_sheet;

/**
 * The mesh of a sheet. Opaque and immutable; it keeps nothing of the sheet.
 */
typedef struct gusset_sheet_mesh gusset_sheet_mesh;

/**
 * A finished stitch. Opaque and immutable; it keeps nothing of the meshes it was made from.
 */
typedef struct gusset_stitch gusset_stitch;

/**
 * The bytes of a stream. Opaque and immutable; may be used from many threads.
 */
typedef struct gusset_stream gusset_stream;

/**
 * A stream that is decoded while it arrives. Opaque; used by one thread at a time.
 */
typedef struct gusset_stream_decoder gusset_stream_decoder;

/**
 * A strip between two polylines. Opaque and immutable; it keeps nothing of the points.
 */
typedef struct gusset_strip gusset_strip;

/**
 * A smooth surface of one or more sheets with an index, which answers. Opaque and immutable: all
 * functions may use it from any thread, and many at the same time, each with a context of its own;
 * it is destroyed when none uses it any more. It keeps what it needs of its sheets.
 */
typedef struct gusset_surface gusset_surface;

/**
 * Cells of a surface, or pairs of cells of two surfaces. Opaque and immutable; it keeps nothing of
 * the surfaces.
 */
typedef struct gusset_surface_cells gusset_surface_cells;

/**
 * Where lines and a curve meet a surface. Opaque and immutable; it keeps nothing of the surface.
 */
typedef struct gusset_surface_hits gusset_surface_hits;

/**
 * Curves on a surface: what sections, contours and intersections give. Opaque and immutable; it
 * keeps nothing of the surface.
 */
typedef struct gusset_surface_paths gusset_surface_paths;

/**
 * Points of a surface. Opaque and immutable; it keeps nothing of the surface.
 */
typedef struct gusset_surface_points gusset_surface_points;

/**
 * What is left of pieces that overlap. Opaque and immutable; it keeps nothing of them.
 */
typedef struct gusset_trim gusset_trim;

/**
 * A welded mesh. Opaque and immutable; it keeps nothing of the mesh it was made from.
 */
typedef struct gusset_weld gusset_weld;

/**
 * The winged-edge tables of a mesh. Opaque and immutable; it keeps nothing of the mesh.
 */
typedef struct gusset_winged gusset_winged;

/**
 * The faces of a winged-edge table. Opaque and immutable; it keeps nothing of the table.
 */
typedef struct gusset_winged_faces gusset_winged_faces;

/**
 * Called now and then during long work, on the thread that made the call. fraction: part done, 0
 * to 1. stage: what is being done, valid during the callback only. Return nonzero to cancel the
 * call. It must not use the context, except for gusset_context_cancel and
 * gusset_context_get_progress, and must not throw or longjmp.
 */
typedef int (*gusset_progress_fn)(void *user, double fraction, const char *stage);

/**
 * Called with remarks that are no failures, on the thread that made the call; message is valid
 * during the callback only. The same rules as for progress. Stitching, filling and assembling remark
 * that
 * - the pieces of a stitch, or the components of its two loops, disagree in orientation, and the
 *   second was turned over;
 * - what is closed was inside out, and was turned over;
 * - fairing was asked for, and no new vertices were;
 * - rows, cells or fairing were asked for with a blend, which does not read them;
 * - a strip stays in the place of a blend, which would need too many vertices or cut more faces;
 * - loops are left although others are near: near_loops_left of an assembly is not 0;
 * - a closed component encloses no volume: zero_volume of an assembly is not empty.
 *
 * Programs read the same from the results; the sentences may change.
 */
typedef void (*gusset_log_fn)(void *user, const char *message);

/**
 * What the index in a report counts.
 */
typedef uint32_t gusset_element;

/**
 * What went wrong in the last call, for programs.
 */
typedef struct gusset_error_report {
    /**
     * sizeof(gusset_error_report), set by the caller.
     */
    size_t struct_size;
    /**
     * The status that the call returned.
     */
    int32_t status;
    /**
     * What index counts: one of GUSSET_ELEMENT_...
     */
    gusset_element element;
    /**
     * The first offending element.
     */
    uint64_t index;
    /**
     * Its value where it has one: the coordinate, the vertex index, the limit exceeded.
     */
    double value;
    /**
     * The mesh or loop that it belongs to: 0 the first, 1 the second.
     */
    uint32_t input;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_error_report;

/**
 * Indices that a result lends, or that the caller gives.
 */
typedef struct gusset_indices {
    /**
     * The first one; may be NULL if count is 0.
     */
    const uint32_t *data;
    /**
     * How many.
     */
    size_t count;
} gusset_indices;

/**
 * The parts of a curve. Pointers are valid until it is destroyed.
 */
typedef struct gusset_curve_view {
    /**
     * sizeof(gusset_curve_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The control points: x, y, z of each; z is 0 for a plane curve.
     */
    const double *points;
    /**
     * How many.
     */
    size_t point_count;
    /**
     * 0, then the place of the last control point of each segment among the points: segment k has
     * the points ends[k] to ends[k + 1].
     */
    struct gusset_indices ends;
    /**
     * 1: the curve ends where it begins and goes on there.
     */
    uint32_t closed;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_curve_view;

/**
 * A place on a curve.
 */
typedef struct gusset_place {
    /**
     * Counted from 0.
     */
    uint32_t segment;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * The parameter: 0 at the segment's first control point, 1 at its last.
     */
    double t;
} gusset_place;

/**
 * How an offset is fitted.
 */
typedef struct gusset_offset_options {
    /**
     * sizeof(gusset_offset_options), set by the caller.
     */
    size_t struct_size;
    /**
     * The deviation aimed at, above 0, in the unit of the points.
     */
    double tolerance;
    /**
     * No segment is halved once there are so many; 0 for 65536.
     */
    size_t max_segments;
    /**
     * The degree of the segments, 2 or 3; 0 for 3.
     */
    uint32_t degree;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_offset_options;

/**
 * What is said about an offset.
 */
typedef struct gusset_offset_report {
    /**
     * sizeof(gusset_offset_report), set by the caller.
     */
    size_t struct_size;
    /**
     * How far the curve is from the true offset, as measured at 16 places inside each segment.
     */
    double deviation;
    /**
     * The number of corners of the original, bridged by straight segments.
     */
    size_t corners;
    /**
     * 1 if the deviation is within the tolerance.
     */
    uint32_t reached;
    /**
     * 1 if somewhere the radius of curvature is at most the distance: the offset has cusps or runs
     * backwards there.
     */
    uint32_t tight;
} gusset_offset_report;

/**
 * The parts of a form; those that it does not have are empty. Pointers are valid until it is
 * destroyed.
 */
typedef struct gusset_curve_form_view {
    /**
     * sizeof(gusset_curve_form_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The text of an SVG path, ended by a 0; empty for other forms.
     */
    const char *text;
    /**
     * Its length without the 0.
     */
    size_t text_length;
    /**
     * The points of a contour or the control points of a spline: x, y, z of each.
     */
    const double *points;
    /**
     * How many.
     */
    size_t point_count;
    /**
     * Of a contour, for each point: 1 on the curve, 0 off it.
     */
    const uint8_t *on_curve;
    /**
     * Of a spline: the knots, point_count + degree + 1 of them.
     */
    const double *knots;
    /**
     * How many.
     */
    size_t knot_count;
    /**
     * Of a spline: its degree.
     */
    size_t degree;
} gusset_curve_form_view;

/**
 * What is demanded of a curve at a point.
 */
typedef struct gusset_constraint {
    /**
     * The point, counted over all outlines.
     */
    uint32_t point;
    /**
     * GUSSET_CONSTRAINT_...
     */
    uint32_t demand;
    /**
     * x, y, z, for GUSSET_CONSTRAINT_TANGENT; z is 0 for plane outlines. For
     * GUSSET_CONSTRAINT_TANGENT_ANGLE the angle and twice 0.
     */
    double tangent[3];
} gusset_constraint;

/**
 * Outlines in the caller's memory: all points one after another. Nothing is copied on the way in.
 * The arrays may have any alignment, must be as long as the counts say, and must not change during
 * a call.
 */
typedef struct gusset_outlines {
    /**
     * sizeof(gusset_outlines), set by the caller.
     */
    size_t struct_size;
    /**
     * The coordinates, doubles: x, y or x, y, z at the start of every point_stride bytes; finite.
     */
    const void *points;
    /**
     * In bytes; 0 for points without gaps.
     */
    size_t point_stride;
    /**
     * The number of points of all outlines, at most 2^30.
     */
    size_t point_count;
    /**
     * Where each outline begins, and where the last one ends: outline_count + 1 places, 0 first,
     * never decreasing. NULL with outline_count 0 for a single outline of all points.
     */
    const uint32_t *offsets;
    /**
     * The number of outlines, or 0.
     */
    size_t outline_count;
    /**
     * In ascending order of their points, at most one for each; or NULL. Of points that are merged
     * the first one's holds.
     */
    const struct gusset_constraint *constraints;
    /**
     * How many.
     */
    size_t constraint_count;
    /**
     * 2 or 3.
     */
    uint32_t dimension;
    /**
     * 1: from the last point of each outline back to its first one; a last point that repeats the
     * first does no harm. 0: open.
     */
    uint32_t closed;
} gusset_outlines;

/**
 * How outlines are identified; all zero is the default. Lengths are relative to the size of the
 * outline, the longest side of its box.
 */
typedef struct gusset_outline_options {
    /**
     * sizeof(gusset_outline_options), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_CURVE_...
     */
    uint32_t curve;
    /**
     * GUSSET_METHOD_...
     */
    uint32_t method;
    /**
     * GUSSET_LOCK_..., for composite and single curves; a chain has its own.
     */
    uint32_t lock;
    /**
     * GUSSET_JOINT_PARAMETER_..., for composite curves and chains.
     */
    uint32_t joint;
    /**
     * GUSSET_SOLVER_...
     */
    uint32_t solver;
    /**
     * GUSSET_ENDS_..., for open outlines, and parts of them that end at corners; a tangent
     * demanded there comes first.
     */
    uint32_t ends;
    /**
     * Read for GUSSET_METHOD_ALPHA; 0 to 1.
     */
    double alpha;
    /**
     * Parameters of composite curves are kept within this and 1 less this: 0.001 to 1/2, or 0 for
     * 1/6.
     */
    double parameter_limit;
    /**
     * Read for GUSSET_REPEATS_GIVEN: neighbours at most so far apart are one point; at least 0,
     * below 1.
     */
    double repeat_tolerance;
    /**
     * Points where the polygon turns by more than this angle, in radians, are corners; at least 0,
     * and 0, pi or more, also INFINITY, for none.
     */
    double corner_angle;
    /**
     * Iterations end when nothing moves farther, below 1; 0 for 1e-12.
     */
    double tolerance;
    /**
     * The first step of GUSSET_SOLVER_STEP, at most 1; 0 for 0.1.
     */
    double first_step;
    /**
     * What a step is divided by where the deviation changes its sign, above 1; 0 for 10.
     */
    double step_divisor;
    /**
     * The most sweeps or iterations between two corners; 0 for 200.
     */
    uint32_t max_sweeps;
    /**
     * The most steps at a point in a sweep; 0 for 20,000.
     */
    uint32_t max_steps;
    /**
     * GUSSET_REPEATS_...
     */
    uint32_t repeats;
    /**
     * 1: the moves of each cycle are kept, for gusset_outline_get_history. 0: they are not.
     */
    uint32_t history;
} gusset_outline_options;

/**
 * How a frame is made; all zero is the default: the points themselves are the nodes.
 */
typedef struct gusset_frame_options {
    /**
     * sizeof(gusset_frame_options), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_CORRESPONDENCE_...
     */
    uint32_t correspondence;
    /**
     * The number of nodes in a section, for ARC_LENGTH and ANGLE; for LANDMARKS the number of
     * parts from each landmark to the next.
     */
    uint32_t columns;
    /**
     * 1: the last section is followed by the first one. 0 or 1.
     */
    uint32_t ring;
    /**
     * 1: closed sections start at their first points, or at the corner after the first section's; read
     * with ARC_LENGTH. 0 or 1.
     */
    uint32_t given_starts;
    /**
     * 1: corners that only the points' polygon has are drawn smooth. 0: a point is a corner where that
     * turns by 40 degrees and far more than usual, or by the `corner_angle` of the curves across if
     * that is less than pi; there they turn sharply. 0 or 1.
     */
    uint32_t smooth_corners;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * For ANGLE: a point of the axis.
     */
    double axis_point[3];
    /**
     * For ANGLE: its direction; seen against it angles grow counter-clockwise.
     */
    double axis_direction[3];
    /**
     * For ANGLE: towards the nodes of column 0; any vector not along the axis, at its first point if
     * it is bent.
     */
    double reference[3];
    /**
     * For ANGLE about a bent axis: a point of it for each section, x, y, z; axis_point and
     * axis_direction are not read then. The axis passes them along the circles through three of them
     * at a time, and the reference goes along without turning about it. NULL: the axis is straight.
     */
    const double *axis_points;
    /**
     * The number of these points: that of the sections.
     */
    size_t axis_point_count;
    /**
     * For LANDMARKS: for each section its landmarks in order, places among its own points; as many
     * for each.
     */
    struct gusset_indices landmarks;
    /**
     * How the curves across are made; NULL for the defaults.
     */
    const struct gusset_outline_options *across;
    /**
     * How the curves along are made; NULL for the defaults.
     */
    const struct gusset_outline_options *along;
    /**
     * For GIVEN: points that are missing, counted over all sections, in any order. What stands in
     * their places is not read, and may be NaN. Each is filled along the body: on the curve of
     * Catmull and Rom through the nodes of its column before and behind it, two of each if there
     * are as many, by the centripetal parameters of the columns next to it.
     */
    struct gusset_indices missing;
} gusset_frame_options;

/**
 * The nodes of a frame, row by row. Pointers are valid until the frame is destroyed.
 */
typedef struct gusset_frame_view {
    /**
     * sizeof(gusset_frame_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The number of sections.
     */
    size_t rows;
    /**
     * The number of nodes in a section.
     */
    size_t columns;
    /**
     * x, y, z of each node.
     */
    const double *nodes;
    /**
     * The direction of the curve across at each node: x, y, z, of length 1, or 0 where there is
     * none.
     */
    const double *across;
    /**
     * The direction of the curve along.
     */
    const double *along;
    /**
     * For each section 1 if it was taken backwards.
     */
    const uint8_t *turned;
    /**
     * Nodes that could have been elsewhere, as a half-plane meets their section more than once.
     */
    struct gusset_indices ambiguous;
    /**
     * Nodes at which the curve across turns sharply, ascending.
     */
    struct gusset_indices corners;
    /**
     * The largest angle, in radians, by which the nodes of a closed section are turned against those
     * of the section before it: a body that is not meant to be wrung has a small one. 0 of open ones.
     */
    double max_twist;
    /**
     * The largest distance between the two curves at a node, relative to the size of the nodes'
     * box.
     */
    double max_gap;
    /**
     * The smallest sine of the angle at which two curves cross at a node.
     */
    double min_sine;
    /**
     * Nodes that were missing and are filled, ascending.
     */
    struct gusset_indices filled;
} gusset_frame_view;

/**
 * What a section measures.
 */
typedef struct gusset_section_report {
    /**
     * Its length: of a closed section all round.
     */
    double girth;
    /**
     * The area within, never negative; that of an open section is closed by its chord.
     */
    double area;
    /**
     * The mean of its points by arc length.
     */
    double centre[3];
} gusset_section_report;

/**
 * What was found. Pointers are valid until the handle is destroyed.
 */
typedef struct gusset_places_view {
    /**
     * sizeof(gusset_places_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The places, in the order of the (first) curve.
     */
    const struct gusset_place *places;
    /**
     * How many.
     */
    size_t count;
    /**
     * The points there: x, y, z of each.
     */
    const double *points;
    /**
     * Of intersections: the places on the second curve, or the later ones on the same; else NULL.
     */
    const struct gusset_place *others;
    /**
     * Parts that two segments have in common: start and end on the first, the same start and end
     * on the second; four places each. Of tangent angles: start and end of a part, twice.
     */
    const struct gusset_place *overlaps;
    /**
     * How many, each of four places.
     */
    size_t overlap_count;
    /**
     * Of crossings: the segments that lie in the line or plane altogether.
     */
    struct gusset_indices inside;
    /**
     * 1 if some pair of segments was given up: they run beside each other within rounding for a
     * long way.
     */
    uint32_t undecided;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_places_view;

/**
 * The nearest point of a curve.
 */
typedef struct gusset_curve_nearest_point {
    /**
     * Where on the curve.
     */
    struct gusset_place place;
    /**
     * x, y, z.
     */
    double point[3];
    /**
     * The distance.
     */
    double distance;
} gusset_curve_nearest_point;

/**
 * The moments of the region that a plane curve encloses; an open curve is closed by its chord.
 * Regions that it runs round clockwise count negative.
 */
typedef struct gusset_curve_moment_report {
    /**
     * sizeof(gusset_curve_moment_report), set by the caller.
     */
    size_t struct_size;
    /**
     * The signed area.
     */
    double area;
    /**
     * The centre of gravity; the curve's start if the area is 0.
     */
    double centroid[2];
    /**
     * The integrals of x x, x y and y y about the centroid, with the sign of the area.
     */
    double second[3];
} gusset_curve_moment_report;

/**
 * All curves in one. Pointers are valid until the outline is destroyed.
 *
 * Curve k has the control points starts[2 k] to starts[2 k + 2] - 1, x, y, z each (z = 0 for plane
 * outlines), and the ends starts[2 k + 1] to starts[2 k + 3] - 1: segment s of it is the Bezier
 * curve of its control points ends[s] to ends[s + 1], both included, counted from the curve's
 * first one. A closed curve repeats its first control point at its end.
 */
typedef struct gusset_outline_view {
    /**
     * sizeof(gusset_outline_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The number of outlines.
     */
    size_t outline_count;
    /**
     * The number of points of all outlines.
     */
    size_t point_count;
    /**
     * x, y, z of each control point.
     */
    const double *controls;
    /**
     * The number of control points.
     */
    size_t control_count;
    /**
     * The ends of the segments.
     */
    struct gusset_indices ends;
    /**
     * Two places for each curve, and two behind the last.
     */
    const size_t *starts;
    /**
     * For each point the segment of its curve that it lies on.
     */
    struct gusset_indices segments;
    /**
     * For each point its parameter there, 0 to 1.
     */
    const double *parameters;
    /**
     * For each point what became of it: GUSSET_POINT_...
     */
    const uint8_t *statuses;
} gusset_outline_view;

/**
 * What became of an outline. Lengths but size are relative to size.
 */
typedef struct gusset_outline_report {
    /**
     * sizeof(gusset_outline_report), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_FIT_...
     */
    uint32_t fit;
    /**
     * Sweeps or iterations, the most of any part between corners; 0 for what needs none. At most
     * max_sweeps of the options.
     */
    uint32_t iterations;
    /**
     * Steps of GUSSET_SOLVER_STEP.
     */
    uint64_t steps;
    /**
     * The longest side of the outline's box, in the unit of the points.
     */
    double size;
    /**
     * The largest distance of a point from its place on the curve; merged points count as the one
     * that they repeat.
     */
    double max_residual;
    /**
     * The largest sine of the angle by which the curve turns at a joint that is to be smooth.
     */
    double max_joint_sine;
    /**
     * The largest difference of the curvatures on both sides of a joint by
     * GUSSET_JOINT_PARAMETER_G2, relative to the larger one, or to 1 / size where both are less; 0
     * for other joints.
     */
    double max_curvature_gap;
    /**
     * The farthest move of a control point in the last iteration.
     */
    double last_move;
    /**
     * How many points have another status than GUSSET_POINT_OK.
     */
    uint32_t not_ok_count;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_outline_report;

/**
 * One cycle of an iteration: a sweep over the points, or an iteration of Newton's method.
 */
typedef struct gusset_cycle {
    /**
     * The farthest move of a control point, relative to the size of the outline.
     */
    double moved;
    /**
     * The steps of GUSSET_SOLVER_STEP up to its end, of all cycles of the outline so far.
     */
    uint64_t steps;
} gusset_cycle;

/**
 * The cycles of an outline. Pointers are valid until the outline is destroyed.
 */
typedef struct gusset_outline_history_view {
    /**
     * sizeof(gusset_outline_history_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The cycles in their order, those of one part between corners after those of another; NULL
     * for none.
     */
    const struct gusset_cycle *cycles;
    /**
     * How many.
     */
    size_t cycle_count;
} gusset_outline_history_view;

/**
 * One section for each point: the quadratic from the point before over the control point to the
 * point after. Pointers are valid until the sections are destroyed.
 */
typedef struct gusset_sections_view {
    /**
     * sizeof(gusset_sections_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The number of points.
     */
    size_t count;
    /**
     * x, y, z of the control points; the ends of open outlines, which have no section, have
     * themselves.
     */
    const double *controls;
    /**
     * The parameter of each point on its section; 0 and 1 at the ends of open outlines.
     */
    const double *parameters;
    /**
     * GUSSET_POINT_...
     */
    const uint8_t *statuses;
    /**
     * The steps of GUSSET_SOLVER_STEP, of all sections.
     */
    uint64_t steps;
} gusset_sections_view;

/**
 * A polygon mesh in memory: the caller's own arrays as input, or the arrays of a result. Nothing
 * is copied on the way in.
 *
 * As input: at least one vertex and one face (EMPTY_MESH); at most 2^32 - 2 vertices and as many
 * corners (TOO_LARGE); at least three corners a face (FACE_TOO_SMALL); indices below vertex_count
 * (INDEX_OUT_OF_RANGE); finite coordinates at all vertices that faces use (NOT_FINITE), while
 * unused ones may hold anything. The arrays may have any alignment. They must be as long as the
 * counts say, which the library cannot see, and must not change during a call. Also NULL_ARGUMENT,
 * MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE, UNKNOWN_VALUE, BAD_STRIDE, BAD_FACE_LAYOUT, BAD_OFFSETS
 * BAD_MERGE and SIZE_OVERFLOW; counts are held against the limits before any element is read.
 *
 * As output: packed positions, face_offsets given, face_size 0.
 */
typedef struct gusset_mesh_view {
    /**
     * sizeof(gusset_mesh_view), set by the caller.
     */
    size_t struct_size;
    /**
     * x, y, z at the start of every stride, of the type that scalar names.
     */
    const void *positions;
    /**
     * Bytes from one position to the next; 0 if they are packed.
     */
    size_t position_stride;
    /**
     * The number of vertices.
     */
    size_t vertex_count;
    /**
     * face_count + 1 entries: face f has the corners face_offsets[f] to face_offsets[f + 1] - 1.
     * NULL if face_size is given.
     */
    const void *face_offsets;
    /**
     * The vertex at each corner, face after face. Corner h is also the name of the half-edge that
     * starts there.
     */
    const void *face_corners;
    /**
     * The number of faces.
     */
    size_t face_count;
    /**
     * GUSSET_F32 or GUSSET_F64. Zero is no valid value: it must be said.
     */
    uint32_t scalar;
    /**
     * GUSSET_U32.
     */
    uint32_t index;
    /**
     * The number of corners of every face, or 0 if face_offsets is given.
     */
    uint32_t face_size;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * For each vertex the vertex that it is one with, of the type that index names: itself, or one
     * that is one with itself; NULL if none is one with another. So can vertices be kept apart that
     * carry different values, as at seams of texture coordinates, and the surface has no border
     * there: see gusset_mesh_find_merge. Positions are those of the vertices that others are one
     * with. Results name these in lists of vertices; their faces have the vertices that were given.
     */
    const void *merge;
} gusset_mesh_view;

/**
 * An affine map: a row of four numbers for each of x, y, z; the last of each is what is added.
 */
typedef struct gusset_transform {
    /**
     * x' = rows[0] x + rows[1] y + rows[2] z + rows[3]; then y', then z'.
     */
    double rows[12];
} gusset_transform;

/**
 * How pieces are aligned; all zero is the default.
 */
typedef struct gusset_alignment_options {
    /**
     * sizeof(gusset_alignment_options), set by the caller.
     */
    size_t struct_size;
    /**
     * Where the pieces begin: GUSSET_ALIGN_...
     */
    uint32_t start;
    /**
     * So many points of each piece are looked for on the others; 0: 2,000.
     */
    uint32_t samples;
    /**
     * Read for GUSSET_ALIGN_AS_GIVEN: motions of the pieces, rotations and translations, or NULL.
     */
    const struct gusset_transform *poses;
    /**
     * Their number: that of the pieces, or 0.
     */
    size_t pose_count;
    /**
     * Points that are farther than this from another piece are no pair with it, in the unit of the
     * positions, finite and at least 0; 0: a tenth of the diagonal of the largest piece's box.
     * Pieces may begin that far from where they belong, or a little less.
     */
    double max_distance;
    /**
     * Rounds at the most, in each of two stages; 0: 100.
     */
    uint32_t max_rounds;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_alignment_options;

/**
 * One piece, aligned.
 */
typedef struct gusset_aligned_piece {
    /**
     * Takes the piece's positions to their new places: a rotation and a translation.
     */
    struct gusset_transform pose;
    /**
     * How well the overlaps hold it, from 0 to 1: by how much the motion of length 1 that changes
     * the distances of pairs least changes them, as a root of a mean square; turns count in radii
     * of the piece. Of the first piece 1.
     */
    double hold;
    /**
     * GUSSET_ALIGNED_...
     */
    uint32_t reason;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_aligned_piece;

/**
 * What two pieces have in common where they lie in the end.
 */
typedef struct gusset_overlap {
    /**
     * The pieces, the smaller number first.
     */
    uint32_t pieces[2];
    /**
     * The shares of their points that lie on the other, within a mean edge of it; 0 to 1.
     */
    double shares[2];
    /**
     * The mean distance of these from the other's surface, in the unit of the positions.
     */
    double mean;
    /**
     * The root of the mean square.
     */
    double rms;
    /**
     * The share of the points within eight mean edges of the other piece that lie on it, 0 to 1.
     */
    double fit;
    /**
     * Of how many points this is known.
     */
    uint32_t count;
    /**
     * 1: they fit, as at least 30 points lie on each other and fit is at least two thirds. 0 or 1.
     */
    uint32_t trusted;
} gusset_overlap;

/**
 * Where pieces lie. Pointers are valid until it is destroyed.
 */
typedef struct gusset_alignment_view {
    /**
     * sizeof(gusset_alignment_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The pieces, in their order.
     */
    const struct gusset_aligned_piece *pieces;
    /**
     * How many.
     */
    size_t piece_count;
    /**
     * The pairs with anything in common.
     */
    const struct gusset_overlap *overlaps;
    /**
     * How many.
     */
    size_t overlap_count;
    /**
     * Rounds that were done.
     */
    uint32_t rounds;
    /**
     * 1: nothing moved any more in the end; 0: the rounds were not enough.
     */
    uint32_t converged;
} gusset_alignment_view;

/**
 * Two loops of the input.
 */
typedef struct gusset_loop_pair {
    /**
     * The piece of each.
     */
    uint32_t piece[2];
    /**
     * A vertex of each piece that the loop passes; UINT32_MAX for all loops of the piece, in
     * exclusions only.
     */
    uint32_t vertex[2];
} gusset_loop_pair;

/**
 * How to weld; all zero is the default.
 */
typedef struct gusset_weld_options {
    /**
     * sizeof(gusset_weld_options), set by the caller.
     */
    size_t struct_size;
    /**
     * Which vertices: GUSSET_WELD_...
     */
    uint32_t vertices;
    /**
     * GUSSET_TOLERANCE_AUTO: vertices lie together if they are no farther apart than rounding can
     * have put copies of one vertex: 2^-19 of the largest coordinate for 32-bit positions, 2^-48
     * for 64-bit ones, or twice the last decimal place that positions show, as those from text
     * files do, if that is more. Let D be the largest power of ten that does not exceed the
     * longest side of the box round the vertices in question. The last place is the largest of
     * 1e-5 D, 1e-6 D, ... of which at least a third of the coordinates (those of the largest order
     * of magnitude), or of their differences from one vertex to the next, are multiples. Multiples
     * of 1e-4 D do not count, as a coarse grid is no sign of rounding; of the rest there must be
     * eight. At each vertex it is at most a quarter of the shortest edge that ends there, so that
     * no edge collapses. See tolerance of the result's view for what it was.
     * GUSSET_TOLERANCE_GIVEN: if they are not farther apart than the tolerance.
     * GUSSET_TOLERANCE_EXACT: if their positions are equal, where -0 equals 0.
     */
    uint32_t tolerance_mode;
    /**
     * In the unit of the positions, finite, at least 0; read for GUSSET_TOLERANCE_GIVEN.
     */
    double tolerance;
    /**
     * GUSSET_COLLAPSE_...
     */
    uint32_t collapse;
    /**
     * GUSSET_UNUSED_...
     */
    uint32_t unused;
} gusset_weld_options;

/**
 * How to stitch; all zero is the default.
 */
typedef struct gusset_stitch_options {
    /**
     * sizeof(gusset_stitch_options), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_MERIDIANS_...
     */
    uint32_t meridians;
    /**
     * GUSSET_ORIENTATION_...
     */
    uint32_t orientation;
    /**
     * The first meridian joins the closest pair that is not joined by an edge already; with a
     * twist, the vertex of rim B so many places later, counted in the direction in which rim A
     * runs (negative: earlier), and no other start is tried. Any value; taken modulo the length of
     * rim B. Must be 0 if arcs are joined (OUT_OF_RANGE), and with GUSSET_EXTENT_OPEN_ARCS also if
     * there are none to join.
     */
    int64_t twist;
    /**
     * GUSSET_EXTENT_...
     */
    uint32_t extent;
    /**
     * GUSSET_RUN_...
     */
    uint32_t run;
    /**
     * GUSSET_ROWS_...
     */
    uint32_t rows;
    /**
     * Interior rows, read for GUSSET_ROWS_COUNT.
     */
    uint32_t row_count;
    /**
     * GUSSET_CELLS_...
     */
    uint32_t cells;
    /**
     * GUSSET_TOLERANCE_...
     */
    uint32_t tolerance_mode;
    /**
     * How far a vertex must be from its loop's plane to face the other loop, in the unit of the
     * positions, at least 0; read for GUSSET_TOLERANCE_GIVEN.
     */
    double tolerance;
    /**
     * Read for GUSSET_EXTENT_ARCS: the first place on loop A, below its length, and the number of
     * vertices, 1 to its length. The arc runs along the loop as it was given, and may pass its
     * end.
     */
    uint32_t arc_a[2];
    /**
     * The same on loop B.
     */
    uint32_t arc_b[2];
    /**
     * GUSSET_SEARCH_...
     */
    uint32_t search;
    /**
     * GUSSET_START_...
     */
    uint32_t start;
    /**
     * GUSSET_FAIRING_..., read if interior rows are asked for; otherwise the log says that it is
     * not.
     */
    uint32_t fairing;
    /**
     * GUSSET_INTERSECTIONS_...
     */
    uint32_t intersections;
    /**
     * GUSSET_CENTRES_...
     */
    uint32_t centres;
    /**
     * GUSSET_OUTWARD_...: what becomes of closed components of the result, the strip and all.
     */
    uint32_t outward;
    /**
     * GUSSET_FINISH_...: what lies between the rims in the end.
     */
    uint32_t finish;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_stitch_options;

/**
 * How holes are filled; all zero is the default: triangles without new vertices, in every hole.
 */
typedef struct gusset_fill_options {
    /**
     * sizeof(gusset_fill_options), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_WEIGHT_...
     */
    uint32_t weight;
    /**
     * GUSSET_REFINE_...
     */
    uint32_t refine;
    /**
     * GUSSET_FAIRING_..., read if new vertices are asked for; otherwise the log says that it is not.
     */
    uint32_t fairing;
    /**
     * GUSSET_KEEP_...: which loops are no holes; read if all loops are asked for.
     */
    uint32_t keep;
    /**
     * GUSSET_INTERSECTIONS_...: whether faces of patches that cut each other or old faces are looked
     * for, and avoided by less fairing, other weights and no new vertices (AUTO), only reported
     * (REPORT), or neither (IGNORE).
     */
    uint32_t intersections;
    /**
     * 1: nothing is filled or turned over; the accounts say which loops would be tried, and with
     * which weight and finish. Loops that turn out to have no triangulation are not foreseen, nor
     * which of them together says get one patch. 0 or 1.
     */
    uint32_t plan_only;
    /**
     * About how many new vertices a patch gets, at most about twice as many; where more would be
     * needed the triangles are larger. 0: 50,000, or four for each vertex of its rims if that is
     * more, and as many again for sharp angles there.
     */
    uint32_t max_new_vertices;
    /**
     * Loops of more edges are left alone. 0 is no limit.
     */
    uint32_t max_edges;
    /**
     * Longer loops are left alone, in the unit of the positions, at least 0. 0 is no limit.
     */
    double max_length;
    /**
     * Loops in a box along the axes with a longer diagonal are left alone. 0 is no limit.
     */
    double max_diameter;
    /**
     * Loops with a larger area, as gusset_hole has it, are left alone. 0 is no limit.
     */
    double max_area;
    /**
     * GUSSET_OUTWARD_...: what becomes of closed components of the result, patches and all.
     */
    uint32_t outward;
    /**
     * GUSSET_TOGETHER_...: which loops get one patch; read without groups.
     */
    uint32_t together;
    /**
     * A number for each of the loops given, loop_count in all: those with the same number get one
     * patch, a surface of genus 0 between them, but for loops that are left for reasons of their
     * own. NULL: as together says. Needs loops.
     */
    const uint32_t *groups;
    /**
     * GUSSET_CONTINUITY_...: how smoothly faired vertices go on the surface round the hole.
     */
    uint32_t continuity;
    /**
     * 1: creases of the old surface that end at a rim end there, and no patch goes on with them. 0 or
     * 1.
     */
    uint32_t ignore_creases;
} gusset_fill_options;

/**
 * How pieces that overlap are trimmed; all zero is the default.
 */
typedef struct gusset_trim_options {
    /**
     * sizeof(gusset_trim_options), set by the caller.
     */
    size_t struct_size;
    /**
     * Surfaces that are no farther apart than this are one, in the unit of the positions, finite
     * and at least 0; 0: four mean edges of the coarser of two pieces.
     */
    double max_distance;
    /**
     * Surfaces whose normals differ by more are two, in radians, from 0 and below pi / 2; 0: 60
     * degrees.
     */
    double max_angle;
    /**
     * x, y, z of the place that each piece was seen from, in the unit of the positions, or NULL:
     * what was seen under a flat angle counts for less.
     */
    const double *viewpoints;
    /**
     * Their number: that of the pieces, or 0.
     */
    size_t viewpoint_count;
    /**
     * What has fewer faces is no surface; 0: 30. Parts of twenty times as many go where others
     * show the same, and as small holes do not come about.
     */
    uint32_t min_faces;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_trim_options;

/**
 * How pieces are assembled; all zero is the default.
 */
typedef struct gusset_assembly_options {
    /**
     * sizeof(gusset_assembly_options), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_ASSEMBLY_WELD, GUSSET_ASSEMBLY_NO_WELD or GUSSET_ASSEMBLY_WELD_EDGE_TO_EDGE.
     */
    uint32_t weld;
    /**
     * GUSSET_ORIENTATION_FIX: within each component the minority of faces is turned over, and
     * components that face each other are made to agree. GUSSET_ORIENTATION_KEEP: nothing is
     * turned, nor in the end.
     */
    uint32_t orientation;
    /**
     * GUSSET_GAP_...
     */
    uint32_t gap;
    /**
     * 1: only whole loops are joined, no parts of them, nor what sewing left of two borders. 0 or
     * 1.
     */
    uint32_t whole_loops_only;
    /**
     * 1: loops of one component may be joined without being asked for. 0 or 1.
     */
    uint32_t within_components;
    /**
     * 1: holes that are left in the end are filled. 0 or 1.
     */
    uint32_t fill;
    /**
     * Read for GUSSET_GAP_GIVEN: the widest gap that is closed, in the unit of the positions,
     * finite and at least 0; 0 leaves all open.
     */
    double max_gap;
    /**
     * Pairs of loops to be joined however wide the gap is, as wholes, or NULL. Each names two
     * different loops, or the same one twice if sewing left it of two borders (see gusset_joint),
     * and none is named in two pairs. Errors name a pair by its number from 0, and say what is
     * wrong with it.
     */
    const struct gusset_loop_pair *pairs;
    /**
     * How many.
     */
    size_t pair_count;
    /**
     * Pairs that are not to be joined, or NULL. A pair that is given above is joined all the same,
     * and a vertex that no loop passes, as it was welded, excludes nothing.
     */
    const struct gusset_loop_pair *excluded;
    /**
     * How many.
     */
    size_t excluded_count;
    /**
     * How to weld; NULL for the defaults.
     */
    const struct gusset_weld_options *weld_options;
    /**
     * The strips, NULL for the defaults: meridians, search, start, rows, row_count, cells,
     * fairing, intersections and finish are read; the other fields must be valid too.
     */
    const struct gusset_stitch_options *strip_options;
    /**
     * How to fill, NULL for the defaults. groups, outward and plan_only are not read, but the last
     * two must be valid too; intersections REPORT is as IGNORE.
     */
    const struct gusset_fill_options *fill_options;
    /**
     * 0: components of the result that are closed (every edge has two faces), consistently
     * oriented and inside out are turned over in the end, each as a whole and by its own volume:
     * the wall of a cavity within another component is turned too. 1: they stay as they are, which
     * is mostly as the first piece has it. All other components stay as they are in both cases. 0
     * or 1. Its sense is opposite to that of outward in the options of stitching and filling, so
     * that 0 can be the default in each.
     */
    uint32_t keep_inside_out;
    /**
     * GUSSET_OVERLAPS_KEEP or GUSSET_OVERLAPS_TRIM.
     */
    uint32_t overlaps;
    /**
     * Read for GUSSET_OVERLAPS_TRIM: how to trim; NULL for the defaults.
     */
    const struct gusset_trim_options *trim_options;
} gusset_assembly_options;

/**
 * Where a piece went.
 */
typedef struct gusset_piece_map {
    /**
     * Per vertex of the piece, its index in the result; several may have the same. UINT32_MAX if
     * it was left out.
     */
    struct gusset_indices vertices;
    /**
     * Per face, its index in the result, or UINT32_MAX; of a triangle that was cut, that of the
     * first part, which the others follow.
     */
    struct gusset_indices faces;
} gusset_piece_map;

/**
 * Two loops, or runs of loops, that face each other across a gap.
 *
 * Of two borders that coincide along a part only, sewing leaves loops that run along the rest of
 * one and back along the other; they turn at two vertices that sewing made of several. Such a loop
 * may be joined with itself: both sides are on it, one of them with both ends, whole is 0, and the
 * strip has no interior rows whatever the options say.
 */
typedef struct gusset_joint {
    /**
     * The vertices of each side in the result, in order; if joined, side by side from the first
     * meridian on. The order is that of before closed components were turned outwards.
     */
    struct gusset_indices side[2];
    /**
     * The mean width of the gap; of a loop that is joined with itself the mean distance of its
     * sides.
     */
    double gap;
    /**
     * The strip's first new vertex in the result.
     */
    size_t vertex_first;
    /**
     * How many new vertices it has.
     */
    size_t vertex_count;
    /**
     * The strip's first face in the result.
     */
    size_t face_first;
    /**
     * How many faces it has.
     */
    size_t face_count;
    /**
     * Pairs of faces that cut each other, as in gusset_stitch_view.
     */
    struct gusset_indices intersections;
    /**
     * 1 if they were looked for.
     */
    uint32_t intersections_known;
    /**
     * GUSSET_JOINT_...
     */
    uint32_t outcome;
    /**
     * 1 if both sides are whole loops.
     */
    uint32_t whole;
    /**
     * GUSSET_FINISH_...: what the strip is. A blend that was asked for may have had to give way to
     * the strip.
     */
    uint32_t finish;
} gusset_joint;

/**
 * A boundary loop of the sewn pieces that no strip hangs on. It is listed even if it was filled
 * afterwards: holes says what became of it then.
 */
typedef struct gusset_left_loop {
    /**
     * Its vertices in the result, in order.
     */
    struct gusset_indices vertices;
    /**
     * The mean distance from its vertices to the nearest of the loop that is nearest to most of
     * them, of another component where there is one; infinite if there is none, or if this loop
     * cannot carry a strip. Of what sewing left of two borders, whose sides are too far from each
     * other, the mean distance of these.
     */
    double gap;
    /**
     * How far that loop, or that side, may be to be joined; 0 if there is none.
     */
    double allowed_gap;
    /**
     * GUSSET_LEFT_...
     */
    uint32_t reason;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_left_loop;

/**
 * The account of one loop.
 */
typedef struct gusset_hole {
    /**
     * Its vertices are rims.data[rim_first] and on: with the surface on the left as it was before
     * closed components were turned outwards, or, of a given loop that is not simple, free or
     * oriented, as given.
     */
    size_t rim_first;
    /**
     * How many they are.
     */
    size_t rim_count;
    /**
     * Its patch's first face in the result: the faces and the new vertices of a patch of several
     * loops are in the accounts of all of them.
     */
    size_t face_first;
    /**
     * How many faces the patch has.
     */
    size_t face_count;
    /**
     * The patch's first new vertex in the result.
     */
    size_t vertex_first;
    /**
     * How many new vertices the patch has.
     */
    size_t vertex_count;
    /**
     * The sum of its edges' lengths, in the unit of the positions.
     */
    double length;
    /**
     * The diagonal of the box round it, along the axes.
     */
    double diameter;
    /**
     * The area of the cone of triangles from its edges to their common centre: that of the hole if
     * it is planar and convex, more otherwise.
     */
    double area;
    /**
     * GUSSET_HOLE_...
     */
    uint32_t status;
    /**
     * GUSSET_WEIGHT_...: the weight that the patch's triangulation is best by: the one asked for, or
     * one that cuts less.
     */
    uint32_t weight;
    /**
     * GUSSET_PATCH_...: what the patch is made of: what was asked for, or less, which cuts less.
     */
    uint32_t finish;
    /**
     * The number of the patch, from 0 on in the order of the faces; loops with the same number have
     * one patch. UINT32_MAX if it has none, as all have in a plan.
     */
    uint32_t patch;
} gusset_hole;

/**
 * The account of an assembly. Pointers are valid until it is destroyed.
 */
typedef struct gusset_assembly_view {
    /**
     * sizeof(gusset_assembly_view), set by the caller.
     */
    size_t struct_size;
    /**
     * One for each piece.
     */
    const struct gusset_piece_map *pieces;
    /**
     * How many.
     */
    size_t piece_count;
    /**
     * The pairs that face each other: those that were given, in their order, then the others,
     * nearest first.
     */
    const struct gusset_joint *joints;
    /**
     * How many.
     */
    size_t joint_count;
    /**
     * The loops that no strip hangs on, by their smallest vertices; those that were filled in the
     * end are among them. loops_left counts what is open now.
     */
    const struct gusset_left_loop *left;
    /**
     * How many.
     */
    size_t left_count;
    /**
     * The holes that were looked at in the end.
     */
    const struct gusset_hole *holes;
    /**
     * How many.
     */
    size_t hole_count;
    /**
     * The vertices of their rims, in the order of before closed components were turned outwards.
     */
    struct gusset_indices hole_rims;
    /**
     * Faces of the pieces that run the other way than they did in their pieces, by their indices
     * in the result: turned to agree with others, or with their component to face outwards, but
     * not both. Faces of strips and patches were nothing before, and are not listed: they run as
     * the faces of pieces beside them do.
     */
    struct gusset_indices turned;
    /**
     * A face of each component that cannot be oriented.
     */
    struct gusset_indices one_sided;
    /**
     * A face of each closed component of the result that encloses no volume up to rounding, as a
     * piece does that is given twice. Empty with GUSSET_ORIENTATION_KEEP or keep_inside_out.
     */
    struct gusset_indices zero_volume;
    /**
     * Vertices that became one with another.
     */
    uint32_t welded_vertices;
    /**
     * Edges that were two free edges.
     */
    uint32_t sewn_edges;
    /**
     * Boundary loops of the result.
     */
    uint32_t loops_left;
    /**
     * Edges of the result with three or more faces.
     */
    uint32_t non_manifold_edges;
    /**
     * Points at which free edges were split for borders to match.
     */
    uint32_t splits;
    /**
     * Entries of left that have another loop within the gap that is allowed: those that look away,
     * whose partner is taken, or that no strip could join.
     */
    uint32_t near_loops_left;
    /**
     * Faces that were trimmed from overlaps.
     */
    uint32_t trimmed_faces;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_assembly_view;

/**
 * Elements of meshes, and of what meshes are made from.
 */
typedef uint32_t gusset_domain;

/**
 * The type of values.
 */
typedef uint32_t gusset_value_type;

/**
 * How the values of several sources become one. An element with one source has its value, bit for
 * bit.
 */
typedef uint32_t gusset_channel_rule;

/**
 * What the values of elements are, and how they are mixed.
 */
typedef struct gusset_channel {
    /**
     * sizeof(gusset_channel), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_DOMAIN_...: the elements that have values.
     */
    gusset_domain domain;
    /**
     * GUSSET_VALUE_...; zero is no valid value.
     */
    gusset_value_type value_type;
    /**
     * How many values an element has, 1 to 4096.
     */
    uint32_t components;
    /**
     * GUSSET_RULE_...
     */
    gusset_channel_rule rule;
    /**
     * With GUSSET_RULE_SKIN_WEIGHTS, how many are kept of elements with several sources; 0: all.
     */
    uint32_t max_influences;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_channel;

/**
 * The values of one input's elements.
 */
typedef struct gusset_channel_values {
    /**
     * The components of each element at the start of every stride, at any alignment; NULL with count
     * 0 if the input has no such values: its elements have 0 then, and new ones the values of the
     * other sources.
     */
    const void *values;
    /**
     * The number of elements: of the input's vertices, corners or faces, all.
     */
    size_t count;
    /**
     * Bytes from one element to the next; 0 if they are packed.
     */
    size_t stride;
} gusset_channel_values;

/**
 * How loops are found; all zero is the default.
 */
typedef struct gusset_boundary_options {
    /**
     * sizeof(gusset_boundary_options), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_NON_MANIFOLD_...
     */
    uint32_t non_manifold;
    /**
     * GUSSET_SURVEY_...
     */
    uint32_t survey;
} gusset_boundary_options;

/**
 * One loop or open chain. Edge i runs from vertices[i] to vertices[i + 1], the last one of a
 * closed loop back to vertices[0]. Pointers are valid until the boundary is destroyed.
 */
typedef struct gusset_loop_view {
    /**
     * sizeof(gusset_loop_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The vertices in order, each once; a closed loop starts at its smallest half-edge.
     */
    struct gusset_indices vertices;
    /**
     * The half-edge (position in face_corners) that each edge is.
     */
    struct gusset_indices half_edges;
    /**
     * The face that each edge borders.
     */
    struct gusset_indices faces;
    /**
     * GUSSET_EDGE_... of each edge: as many as half_edges.
     */
    const uint8_t *edge_flags;
    /**
     * The sum of the edges' lengths, in the unit of the positions.
     */
    double length;
    /**
     * GUSSET_LOOP_... bits; 0 for an ordinary closed loop.
     */
    uint32_t flags;
    /**
     * The number of the walk that the loop was cut from.
     */
    uint32_t walk;
} gusset_loop_view;

/**
 * Something wrong or unusual in a mesh.
 */
typedef struct gusset_defect {
    /**
     * GUSSET_DEFECT_...
     */
    uint32_t kind;
    /**
     * The face, half-edge or vertex.
     */
    uint32_t index;
    /**
     * The second element of the kinds that have one, else UINT32_MAX.
     */
    uint32_t other;
    /**
     * How many half-edges meet there, for GUSSET_DEFECT_NON_MANIFOLD_EDGE, else 0.
     */
    uint32_t count;
} gusset_defect;

/**
 * Counts, properties and lists of what is wrong or unusual. Lists are ascending; pointers are
 * valid until the check is destroyed.
 */
typedef struct gusset_check_view {
    /**
     * sizeof(gusset_check_view), set by the caller.
     */
    size_t struct_size;
    /**
     * Vertices, unused ones too.
     */
    uint32_t vertex_count;
    /**
     * Distinct edges: pairs of different vertices that are consecutive in some face that is not
     * degenerate. Degenerate faces have no edges.
     */
    uint32_t edge_count;
    /**
     * Faces.
     */
    uint32_t face_count;
    /**
     * Pieces: faces that share an edge are in one.
     */
    uint32_t component_count;
    /**
     * Walks round the boundary, fan by fan.
     */
    uint32_t boundary_walk_count;
    /**
     * GUSSET_MESH_... bits.
     */
    uint32_t properties;
    /**
     * Used vertices - edges + faces, degenerate ones too: Euler's characteristic if there are none.
     */
    int64_t euler;
    /**
     * The number of handles of all components together; -1 if the mesh is not manifold or not
     * orientable, or has a degenerate face.
     */
    int64_t genus;
    /**
     * The half-edges of the edges with exactly one face.
     */
    struct gusset_indices boundary_edges;
    /**
     * The first half-edge of each edge with three or more faces.
     */
    struct gusset_indices non_manifold_edges;
    /**
     * The ends of those edges, and the bow-ties.
     */
    struct gusset_indices non_manifold_vertices;
    /**
     * Vertices whose faces form more than one fan. Fans end at edges with three or more faces, whose
     * own ends are therefore among them, as a rule.
     */
    struct gusset_indices bow_ties;
    /**
     * The first half-edge of each edge whose two faces run it in the same direction.
     */
    struct gusset_indices orientation_conflicts;
    /**
     * Faces with the same cycle of vertices, in either direction, as a face before them;
     * degenerate ones apart.
     */
    struct gusset_indices duplicate_faces;
    /**
     * Faces that repeat a vertex.
     */
    struct gusset_indices degenerate_faces;
    /**
     * Faces without area that repeat none: their vector area is 0 up to rounding.
     */
    struct gusset_indices zero_area_faces;
    /**
     * Vertices that no face uses.
     */
    struct gusset_indices unused_vertices;
} gusset_check_view;

/**
 * How a surface is developed; all zero is the default.
 */
typedef struct gusset_development_options {
    /**
     * sizeof(gusset_development_options), set by the caller.
     */
    size_t struct_size;
    /**
     * Which distortion is least: GUSSET_DISTORTION_...
     */
    uint32_t distortion;
    /**
     * Darts at the most: cuts from the border of a chart to where its curvature is.
     */
    uint32_t max_darts;
    /**
     * Vertices of the mesh, path after path, along which it is cut. Vertices that follow one
     * another are connected by the shortest path along edges; a path of one vertex cuts nothing.
     */
    struct gusset_indices cuts;
    /**
     * Where each path begins among them, and the end of the last; empty for one path of all.
     */
    struct gusset_indices cut_offsets;
    /**
     * No more darts are made once no length changes by a larger factor; above 1, or 0: all darts
     * are made.
     */
    double max_stretch;
    /**
     * Steps of each descent at the most; 0: 200. A chart whose border would meet itself takes more
     * than one, and so does one as rigid as possible.
     */
    uint32_t max_iterations;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_development_options;

/**
 * A chart: a connected component of the development.
 */
typedef struct gusset_chart {
    /**
     * Its first vertex among those of the result.
     */
    uint32_t first_vertex;
    /**
     * How many follow one another.
     */
    uint32_t vertex_count;
    /**
     * The number of its faces; see face_charts.
     */
    uint32_t face_count;
    /**
     * How it came about: GUSSET_CHART_...
     */
    uint32_t finish;
    /**
     * Steps of all its descents.
     */
    uint32_t iterations;
    /**
     * Pairs of edges of its border that meet in the plane, neighbours apart; of EXACT charts those
     * that cross by more than 1e-8 of the root of the area. Only EXACT and FOLDED charts can have
     * some.
     */
    uint32_t overlaps;
    /**
     * Triangles that are turned over; 0 but for FOLDED.
     */
    uint32_t folds;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * The symmetric Dirichlet energy: the mean over the area of the sum of s^2 + 1 / s^2 over both
     * singular values s of the map to the plane; 4 for an isometry, which has the least.
     */
    double energy;
    /**
     * The largest factor by which a length grows.
     */
    double max_stretch;
    /**
     * The least.
     */
    double min_stretch;
    /**
     * The area of the surface, in the squared unit of the positions.
     */
    double area;
    /**
     * The area in the plane.
     */
    double flat_area;
} gusset_chart;

/**
 * A development. Pointers are valid until it is destroyed.
 */
typedef struct gusset_development_view {
    /**
     * sizeof(gusset_development_view), set by the caller.
     */
    size_t struct_size;
    /**
     * x, y of each vertex in the plane, in the unit of the positions, in double precision whatever
     * their type.
     */
    const double *points;
    /**
     * Of each vertex, that of the surface that it is; vertices on cuts are several.
     */
    struct gusset_indices vertex_map;
    /**
     * Of each face its chart.
     */
    struct gusset_indices face_charts;
    /**
     * Of each face two numbers: the largest factor by which lengths in it grow, and the least.
     */
    const double *stretches;
    /**
     * Charts, in the order of their first faces. They lie beside one another along x.
     */
    const struct gusset_chart *charts;
    /**
     * How many.
     */
    size_t chart_count;
    /**
     * Edges of the surface that were cut, two vertices an edge; first those given, then those that
     * open, then darts.
     */
    struct gusset_indices cut_edges;
    /**
     * Of each of them GUSSET_CUT_...
     */
    struct gusset_indices cut_kinds;
    /**
     * The number of darts.
     */
    uint32_t darts;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_development_view;

/**
 * How facing vertices are found; all zero is the default.
 */
typedef struct gusset_facing_options {
    /**
     * sizeof(gusset_facing_options), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_RUN_...
     */
    uint32_t run;
    /**
     * GUSSET_TOLERANCE_...
     */
    uint32_t tolerance_mode;
    /**
     * How far a vertex must be from its loop's plane, in the unit of the points, at least 0; read
     * for GUSSET_TOLERANCE_GIVEN.
     */
    double tolerance;
    /**
     * GUSSET_CENTRES_...
     */
    uint32_t centres;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_facing_options;

/**
 * What algorithm 2 found. Index 0 is loop A, 1 is loop B. Pointers are valid until the handle is
 * destroyed.
 */
typedef struct gusset_facing_view {
    /**
     * sizeof(gusset_facing_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The centres C_1 and C_2 (5): x, y, z of each.
     */
    double centre[2][3];
    /**
     * The vectors C_2 - C_1 and C_1 - C_2 (6), the normals of the planes (7).
     */
    double normal[2][3];
    /**
     * The distance of each vertex from its loop's plane, positive on the side of the other loop;
     * as many as the loop has.
     */
    const double *distances[2];
    /**
     * All runs of facing vertices: first place and number of vertices, by turns; a run may pass
     * the loop's end.
     */
    struct gusset_indices runs[2];
    /**
     * The run taken: first place and number of vertices, as gusset_stitch_options takes them in
     * arc_a and arc_b.
     */
    uint32_t taken[2][2];
} gusset_facing_view;

/**
 * The accounts of all loops. Pointers are valid until the fill is destroyed.
 */
typedef struct gusset_fill_view {
    /**
     * sizeof(gusset_fill_view), set by the caller.
     */
    size_t struct_size;
    /**
     * One for each loop: those given, in their order, or all that the mesh has, as
     * gusset_boundary_get_loop numbers them. NULL if there are none.
     */
    const struct gusset_hole *holes;
    /**
     * How many.
     */
    size_t hole_count;
    /**
     * The vertices of all rims.
     */
    struct gusset_indices rims;
    /**
     * Of each new vertex, in their order, three vertices of its patch's rims.
     */
    struct gusset_indices parents;
    /**
     * How much it has of each of them, three numbers a vertex, at least 0 with sum 1; NULL without
     * new vertices. They place it at the nearest point of the plain triangulation of the rims,
     * which it is itself if its patch was neither faired nor creased, or if the hole is flat.
     */
    const double *weights;
    /**
     * Pairs of faces of the result that cut each other, two numbers a pair, the larger one first,
     * which is a new face's; ascending. What they share, a vertex or an edge, is no cut, nor are
     * vertices and edges at the same place; any other touch is. Exact.
     */
    struct gusset_indices intersections;
    /**
     * Faces of the result, old and new ones, that GUSSET_OUTWARD_CLOSED turned over, ascending.
     * Each keeps its first corner and has the others in reverse order.
     */
    struct gusset_indices turned_outwards;
    /**
     * 1 if intersections were looked for, 0 if not.
     */
    uint32_t intersections_known;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_fill_view;

/**
 * Measures of a strip, or of filled holes, and of the whole result's connectivity.
 */
typedef struct gusset_quality_report {
    /**
     * sizeof(gusset_quality_report), set by the caller.
     */
    size_t struct_size;
    /**
     * The smallest angle of the new triangles, in radians; 0 if one is degenerate.
     */
    double min_angle;
    /**
     * The largest aspect ratio of the new triangles: longest side / (2 sqrt(3) inscribed radius),
     * 1 for an equilateral triangle, infinite for a degenerate one.
     */
    double max_aspect;
    /**
     * The longest edge of the new faces, in the unit of the positions.
     */
    double max_edge;
    /**
     * Their area, in the square of that unit.
     */
    double area;
    /**
     * New triangles without area.
     */
    uint32_t degenerate_faces;
    /**
     * Boundary loops of the result; 0 if no edge has exactly one face.
     */
    uint32_t loops_left;
    /**
     * Edges of the result with three or more faces.
     */
    uint32_t non_manifold_edges;
    /**
     * Edges of the result whose two faces disagree in orientation.
     */
    uint32_t orientation_conflicts;
} gusset_quality_report;

/**
 * How to orient; all zero is the default.
 */
typedef struct gusset_orient_options {
    /**
     * sizeof(gusset_orient_options), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_OUTWARD_...
     */
    uint32_t outward;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_orient_options;

/**
 * What was turned, and what could not be oriented. Pointers are valid until the handle is
 * destroyed.
 */
typedef struct gusset_orient_view {
    /**
     * sizeof(gusset_orient_view), set by the caller.
     */
    size_t struct_size;
    /**
     * Per face, 1 if it was turned over, else 0.
     */
    const uint8_t *turned;
    /**
     * The number of faces.
     */
    size_t face_count;
    /**
     * The smallest face of each component that cannot be oriented, ascending. Such components stay
     * as they are.
     */
    struct gusset_indices one_sided_faces;
    /**
     * For each of them, a half-edge of it at which two faces disagree when others agree.
     */
    struct gusset_indices one_sided_half_edges;
    /**
     * The number of faces turned over.
     */
    uint32_t turned_faces;
    /**
     * Components: faces that hang together across edges of two faces. A degenerate face is one of
     * its own.
     */
    uint32_t component_count;
    /**
     * Closed components that face outwards now and, with GUSSET_OUTWARD_KEEP, would not.
     */
    uint32_t inverted_components;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_orient_view;

/**
 * The origins of the elements of one kind. Pointers are valid until the origins are destroyed.
 */
typedef struct gusset_origins_view {
    /**
     * sizeof(gusset_origins_view), set by the caller.
     */
    size_t struct_size;
    /**
     * One more than there are elements: element k has the entries offsets[k] to
     * offsets[k + 1] - 1 of sources and weights; none if it comes from nothing.
     */
    struct gusset_indices offsets;
    /**
     * The sources, numbered through all inputs.
     */
    struct gusset_indices sources;
    /**
     * How much each source counts: more than 0, with the sum 1 for each element; as many as sources;
     * NULL without any.
     */
    const double *weights;
    /**
     * One more than there are inputs: the elements of input i are the sources starts[i] to
     * starts[i + 1] - 1. The inputs are the meshes, pieces or polylines in their order, the one mesh,
     * net or sheet.
     */
    struct gusset_indices starts;
} gusset_origins_view;

/**
 * What became of the old mesh. Lists are ascending; pointers are valid until the sewn mesh is
 * destroyed.
 */
typedef struct gusset_sew_view {
    /**
     * sizeof(gusset_sew_view), set by the caller.
     */
    size_t struct_size;
    /**
     * Per old vertex, its index in the result; UINT32_MAX if it was left out as unused.
     */
    struct gusset_indices vertex_map;
    /**
     * Per old face, the index in the result of the first face that it became; UINT32_MAX if it
     * was dropped.
     */
    struct gusset_indices face_map;
    /**
     * Per face of the result, the old face that it is, or is a part of; ascending.
     */
    struct gusset_indices face_origin;
    /**
     * Old vertices that lie together with another, or inside a free edge, and are not sewn to it.
     */
    struct gusset_indices left_vertices;
    /**
     * Vertices that became one with a smaller one.
     */
    uint32_t welded_vertices;
    /**
     * Edges of two faces that were free edges, or parts of such.
     */
    uint32_t sewn_edges;
    /**
     * Points at which free edges were split.
     */
    uint32_t splits;
    /**
     * Old faces that were cut or gained corners.
     */
    uint32_t split_faces;
    /**
     * Old faces that were dropped.
     */
    uint32_t dropped_faces;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * How far apart what lies together was allowed to be, short edges apart; 0 for equal
     * positions.
     */
    double tolerance;
} gusset_sew_view;

/**
 * The parts of a stitch. Pointers are valid until it is destroyed. Index 0 is the first mesh, 1
 * the second.
 */
typedef struct gusset_stitch_view {
    /**
     * sizeof(gusset_stitch_view), set by the caller.
     */
    size_t struct_size;
    /**
     * Per old vertex of each mesh, its index in the result; empty for the second if there was only
     * one mesh.
     */
    struct gusset_indices vertex_map[2];
    /**
     * Per old face, its index in the result.
     */
    struct gusset_indices face_map[2];
    /**
     * The vertices of each rim, by their indices in the result, from the first meridian on, side
     * by side: rim 0 has its surface on the left, rim 1 on the right, as they were before closed
     * components were turned outwards. They are also the strip's own first vertices in order: rim
     * 0, then rim 1.
     */
    struct gusset_indices rim[2];
    /**
     * The meridians as places on the rims, i and j by turns, the paper's matrix H: meridian k is
     * (data[2 k], data[2 k + 1]). They go from (0, 0) to (N, M) for whole rims of N and M
     * vertices, where place N is place 0 again, and to (N - 1, M - 1) for arcs; count is twice the
     * number of meridians. From one to the next i advances by 1, or j, or both: by the rule
     * by index and with GUSSET_MERIDIANS_QUAD.
     */
    struct gusset_indices meridians;
    /**
     * The paper's matrix P, row by row from rim 0 to rim 1, one column for each meridian: vertices
     * of the result.
     */
    struct gusset_indices matrix;
    /**
     * Of each new vertex (they are the last ones of the result), three vertices of the rims that it
     * lies between: in a row the ends of its meridian, that on rim 1 twice; of a blend the corners
     * of the triangle of the strip that it would be on without fairing.
     */
    struct gusset_indices parents;
    /**
     * How much it has of each of them, three numbers a vertex, at least 0 with sum 1; in row k of r
     * rows 1 - k / (r + 1), k / (r + 1) and 0. NULL without new vertices.
     */
    const double *weights;
    /**
     * The first of the strip's faces in the result; they are the last ones.
     */
    size_t strip_face_first;
    /**
     * How many there are; N + M triangles for whole rims without interior rows. A blend has as
     * many as it needs, and meridians and matrix are those of the strip that it follows.
     */
    size_t strip_face_count;
    /**
     * Interior rows; the matrix has two rows more. 0 of a blend.
     */
    uint32_t row_count;
    /**
     * 1 if the strip is a closed band between whole loops, 0 if it joins arcs.
     */
    uint32_t closed;
    /**
     * 1 if the component that rim 1 is on was turned over to agree with the other, else 0: its
     * faces run the other way, each from its own first corner. Other components stay as they are.
     */
    uint32_t turned;
    /**
     * 1 if faces that cut each other were looked for, else 0.
     */
    uint32_t intersections_known;
    /**
     * Pairs of faces of the result that cut each other, by turns: first one of the strip, the
     * larger one if both are. What they share, a vertex or an edge, is no cut, nor are vertices and
     * edges at the same place; any other touch is. Exact. Polygons are taken as triangles: quads split by their shorter diagonals, others
     * as fans from their first corners; a polygon that cuts itself is paired with itself.
     */
    struct gusset_indices intersections;
    /**
     * How often the fairing, of rows or of the blend that was kept, had to be taken back in
     * places.
     */
    uint32_t back_off_count;
    /**
     * GUSSET_FINISH_...: what the strip is. A blend that was asked for may have had to give way to
     * the strip.
     */
    uint32_t finish;
    /**
     * Faces of the result, those of the strip too, that GUSSET_OUTWARD_CLOSED turned over in the
     * end, ascending. Each keeps its first corner and has the others in reverse order.
     */
    struct gusset_indices turned_outwards;
} gusset_stitch_view;

/**
 * How a strip is made; all zero is the default.
 */
typedef struct gusset_strip_options {
    /**
     * sizeof(gusset_strip_options), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_MERIDIANS_...
     */
    uint32_t meridians;
    /**
     * GUSSET_SEARCH_...
     */
    uint32_t search;
    /**
     * GUSSET_START_..., for closed polylines; open ones begin at their first points.
     */
    uint32_t start;
    /**
     * 1: the polylines are closed; 0: they are open.
     */
    uint32_t closed;
    /**
     * GUSSET_ROWS_...; the mean edge is the mean segment of both polylines.
     */
    uint32_t rows;
    /**
     * Interior rows, read for GUSSET_ROWS_COUNT.
     */
    uint32_t row_count;
    /**
     * GUSSET_CELLS_...
     */
    uint32_t cells;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_strip_options;

/**
 * The parts of a strip. Pointers are valid until it is destroyed.
 */
typedef struct gusset_strip_view {
    /**
     * sizeof(gusset_strip_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The points of A and of B that the first meridian joins.
     */
    uint32_t start[2];
    /**
     * The meridians as places counted from there, i and j by turns: from (0, 0) to (N, M) for
     * closed polylines of N and M points, where place N is place 0 again, and to (N - 1, M - 1)
     * for open ones; count is twice the number of meridians.
     */
    struct gusset_indices meridians;
    /**
     * The paper's matrix P, row by row from A to B, one column for each meridian: vertices of the
     * mesh.
     */
    struct gusset_indices matrix;
    /**
     * Of each new vertex (they are the last ones of the mesh), the two that it lies between, on A
     * and on B, by turns: the ends of its meridian.
     */
    struct gusset_indices parents;
    /**
     * Of each new vertex, the weight of its second parent, 0 to 1: in row k of r rows k / (r + 1).
     */
    const double *weights;
    /**
     * Interior rows; the matrix has two rows more. 0 where there is one meridian alone, and no
     * face.
     */
    uint32_t row_count;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_strip_view;

/**
 * The faces of a piece that are kept.
 */
typedef struct gusset_trimmed_piece {
    /**
     * Ascending.
     */
    struct gusset_indices kept;
    /**
     * How many of the piece's vertices lie on another piece.
     */
    size_t covered_vertices;
} gusset_trimmed_piece;

/**
 * What is left of pieces. Pointers are valid until it is destroyed.
 */
typedef struct gusset_trim_view {
    /**
     * sizeof(gusset_trim_view), set by the caller.
     */
    size_t struct_size;
    /**
     * One for each piece.
     */
    const struct gusset_trimmed_piece *pieces;
    /**
     * How many.
     */
    size_t piece_count;
    /**
     * Faces that cut some of an earlier piece after all else; they went, with those round them.
     */
    uint32_t crossings;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_trim_view;

/**
 * What became of the old mesh. Indices are the old mesh's; lists are ascending; pointers are valid
 * until the weld is destroyed.
 */
typedef struct gusset_weld_view {
    /**
     * sizeof(gusset_weld_view), set by the caller.
     */
    size_t struct_size;
    /**
     * Per old vertex, its index in the result; UINT32_MAX if it was left out as unused.
     */
    struct gusset_indices vertex_map;
    /**
     * Per old face, its index in the result; UINT32_MAX if it was dropped.
     */
    struct gusset_indices face_map;
    /**
     * Half-edges of free edges that lie on another edge and did not become one edge of two faces
     * with it: three or more lie together there, or sewing would have collapsed a face or made an
     * edge of three or more faces.
     */
    struct gusset_indices left_edges;
    /**
     * Vertices that lie together with another and are not one with it.
     */
    struct gusset_indices left_vertices;
    /**
     * Vertices that became one with a smaller one.
     */
    uint32_t welded_vertices;
    /**
     * Edges of two faces that were two free edges.
     */
    uint32_t sewn_edges;
    /**
     * Faces that were dropped.
     */
    uint32_t dropped_faces;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * How far apart vertices that lie together were allowed to be, short edges apart; 0 for equal
     * positions.
     */
    double tolerance;
} gusset_weld_view;

/**
 * How tables are made, and read; all zero is the default.
 */
typedef struct gusset_winged_options {
    /**
     * sizeof(gusset_winged_options), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_FACES_...
     */
    uint32_t winding;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_winged_options;

/**
 * One edge: Baumgart's M, N, b, c, d, e, L, R, where UINT32_MAX is NULL. Faces run clockwise seen
 * from outside.
 */
typedef struct gusset_winged_edge {
    /**
     * The vertex M, where it starts.
     */
    uint32_t m;
    /**
     * The vertex N, where it ends.
     */
    uint32_t n;
    /**
     * In R, the edge after this one; it leaves N.
     */
    uint32_t b;
    /**
     * In L, the edge before this one; it arrives at N.
     */
    uint32_t c;
    /**
     * In R, the edge before this one; it arrives at M.
     */
    uint32_t d;
    /**
     * In L, the edge after this one; it leaves M.
     */
    uint32_t e;
    /**
     * The face L: it runs N to M.
     */
    uint32_t left;
    /**
     * The face R: it runs M to N.
     */
    uint32_t right;
    /**
     * GUSSET_WINGED_... bits; 0 for an ordinary edge.
     */
    uint32_t marks;
} gusset_winged_edge;

/**
 * The tables. Pointers are valid until the handle is destroyed.
 */
typedef struct gusset_winged_view {
    /**
     * sizeof(gusset_winged_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The edges in the order of their first half-edges; M is the vertex where that half-edge
     * starts.
     */
    const struct gusset_winged_edge *edges;
    /**
     * How many.
     */
    size_t edge_count;
    /**
     * Per half-edge (position in face_corners), its edge.
     */
    struct gusset_indices edge_of_half_edge;
    /**
     * Per face, its first edge.
     */
    struct gusset_indices edge_of_face;
    /**
     * Per vertex, an edge at it, or UINT32_MAX.
     */
    struct gusset_indices edge_of_vertex;
    /**
     * The vertices of all loops of free edges (exactly one of L, R is NULL), loop after loop,
     * surface on the left.
     */
    struct gusset_indices loop_vertices;
    /**
     * The edges along them; edge i starts at vertex i.
     */
    struct gusset_indices loop_edges;
    /**
     * Where each loop starts in both; one entry more than there are loops.
     */
    struct gusset_indices loop_offsets;
} gusset_winged_view;

/**
 * The faces of a table. Pointers are valid until the handle is destroyed.
 */
typedef struct gusset_winged_faces_view {
    /**
     * sizeof(gusset_winged_faces_view), set by the caller.
     */
    size_t struct_size;
    /**
     * For face_offsets of a gusset_mesh_view: one entry more than there are faces.
     */
    struct gusset_indices face_offsets;
    /**
     * For face_corners: the vertices of each face in order.
     */
    struct gusset_indices face_corners;
    /**
     * Per corner, the edge that leaves it.
     */
    struct gusset_indices edge_of_half_edge;
} gusset_winged_faces_view;

/**
 * Coordinate matrices: number (i, j) of X is at x + i * row_stride + j * column_stride bytes, and
 * so for Y and Z. Points that lie as x, y, z one after the other are matrices whose column_stride
 * is three numbers; matrices kept by columns have a row_stride of one number and a column_stride
 * of a column. Normals are those of columns and then rows: opposite to those of a sheet of the
 * same nodes.
 */
typedef struct gusset_net_view {
    /**
     * sizeof(gusset_net_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The number of rows of nodes, H; at least 2.
     */
    size_t rows;
    /**
     * The number of columns, W; at least 2. rows * columns is at most 2^31 - 1.
     */
    size_t columns;
    /**
     * X.
     */
    void *x;
    /**
     * Y.
     */
    void *y;
    /**
     * Z.
     */
    void *z;
    /**
     * Bytes from row to row; 0 for rows without gaps.
     */
    size_t row_stride;
    /**
     * Bytes from number to number in a row; 0 for numbers without gaps.
     */
    size_t column_stride;
    /**
     * GUSSET_F32 or GUSSET_F64.
     */
    uint32_t scalar;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_net_view;

/**
 * Node k of one run of nodes is node k of another: node (row_a + k * row_step_a, column_a + k *
 * column_step_a) and node (row_b + k * row_step_b, column_b + k * column_step_b), for k from 0 to
 * count - 1.
 */
typedef struct gusset_seam {
    /**
     * Row of the first node of run A.
     */
    uint32_t row_a;
    /**
     * Its column.
     */
    uint32_t column_a;
    /**
     * Rows from each node to the next.
     */
    int32_t row_step_a;
    /**
     * Columns from each node to the next.
     */
    int32_t column_step_a;
    /**
     * The same for run B.
     */
    uint32_t row_b;
    /**
     * The same for run B.
     */
    uint32_t column_b;
    /**
     * The same for run B.
     */
    int32_t row_step_b;
    /**
     * The same for run B.
     */
    int32_t column_step_b;
    /**
     * The number of nodes of each; at least 1, and 1 if all steps are 0.
     */
    uint32_t count;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_seam;

/**
 * What becomes of the sides of a net: a sum of these.
 */
typedef uint32_t gusset_sides;

/**
 * What is glued to what. All zeros: nothing.
 */
typedef struct gusset_net_gluing {
    /**
     * sizeof(gusset_net_gluing), set by the caller.
     */
    size_t struct_size;
    /**
     * The characteristic matrix: 2 * rows rows of columns bytes, 1 for a contracted link and 0 for
     * others. Row 2i has the horizontal links of the nodes of row i, each to the next node and the
     * last one to the first; row 2i + 1 the vertical ones, those of the last row to the first row.
     * NULL: sides says it all.
     */
    const uint8_t *matrix;
    /**
     * Runs of nodes glued to runs of nodes, besides.
     */
    const struct gusset_seam *seams;
    /**
     * How many.
     */
    size_t seam_count;
    /**
     * What becomes of the sides; 0 with a matrix.
     */
    gusset_sides sides;
    /**
     * 1: faces are to be taken the other way round.
     */
    uint32_t reversed;
} gusset_net_gluing;

/**
 * Where the coordinates of a net are.
 */
typedef uint32_t gusset_net_memory;

/**
 * What a field does, and what its values are. An axis and those that follow it: y and z after x, z
 * and x after y, x and y after z.
 */
typedef uint32_t gusset_field_kind;

/**
 * An axis of coordinates: 0 is x, 1 is y, 2 is z.
 */
typedef uint32_t gusset_axis;

/**
 * How a strength goes from one key to the next.
 */
typedef uint32_t gusset_easing;

/**
 * A field of deformation: a map of space, of which a part is done.
 */
typedef struct gusset_field {
    /**
     * sizeof(gusset_field), set by the caller; in an array the same for all.
     */
    size_t struct_size;
    /**
     * One of GUSSET_FIELD_...
     */
    gusset_field_kind kind;
    /**
     * For kinds that have one; else 0.
     */
    gusset_axis axis;
    /**
     * For GUSSET_FIELD_SHEAR; else 0.
     */
    gusset_axis other_axis;
    /**
     * Between keys; one of GUSSET_EASING_...
     */
    gusset_easing easing;
    /**
     * How much of the map is done: 0 nothing at all, 1 all of it. With keys, it multiplies what
     * they say.
     */
    double strength;
    /**
     * What the kind says; the rest is not read.
     */
    double values[16];
    /**
     * Pairs of time and strength, times increasing; before the first and after the last time the
     * strength is that there. NULL: the strength does not depend on the time.
     */
    const double *keys;
    /**
     * The number of pairs.
     */
    size_t key_count;
    /**
     * For GUSSET_FIELD_LATTICE, three numbers for each control point; else NULL.
     */
    const double *offsets;
    /**
     * For GUSSET_FIELD_LATTICE; else 0.
     */
    uint32_t counts[3];
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_field;

/**
 * What a net is compared with. All zeros: with itself.
 */
typedef struct gusset_net_analysis_options {
    /**
     * sizeof(gusset_net_analysis_options), set by the caller.
     */
    size_t struct_size;
    /**
     * The net after the deformation, of the same size; NULL: what the fields make of the net.
     */
    const struct gusset_net *after;
    /**
     * The fields, as for gusset_net_deform; none beside `after`.
     */
    const struct gusset_field *fields;
    /**
     * The number of fields.
     */
    size_t field_count;
    /**
     * The time, as for gusset_net_deform.
     */
    double time;
    /**
     * Lengths up to it, at least 0 and finite, are none.
     */
    double tolerance;
} gusset_net_analysis_options;

/**
 * An analysis, lent: valid until gusset_net_analysis_destroy.
 */
typedef struct gusset_net_analysis_view {
    /**
     * sizeof(gusset_net_analysis_view), set by the caller.
     */
    size_t struct_size;
    /**
     * Of each link (node * 2, and 1 if it is vertical; those that lead back to the first column
     * and row included), its new length divided by its old one; NaN if it had none, or an end is
     * missing.
     */
    const double *links;
    /**
     * 2 * rows * columns.
     */
    size_t link_count;
    /**
     * Of each cell, its new area divided by its old one; negative where the surface is folded over
     * or, if fields are analysed, space is mirrored; NaN if it had none, or is not there.
     */
    const double *cells;
    /**
     * Of each cell, the determinant of the fields' Jacobian at its centre; NULL if nets are
     * compared.
     */
    const double *determinants;
    /**
     * (rows - 1) * (columns - 1).
     */
    size_t cell_count;
    /**
     * The links that have become a point and are not glued: see `links` of
     * gusset_glue_options.
     */
    const uint32_t *contracted;
    /**
     * Of each of them, what the star of its first node has become with all of them contracted: the
     * number of the local gluing, 0 to 17.
     */
    const uint32_t *stars;
    /**
     * How many.
     */
    size_t contracted_count;
    /**
     * The glued links whose ends have come apart.
     */
    const uint32_t *torn;
    /**
     * How many.
     */
    size_t torn_count;
    /**
     * The cells that are turned the other way than most.
     */
    const uint32_t *folded;
    /**
     * How many.
     */
    size_t folded_count;
    /**
     * 1 if nothing is newly glued, torn or folded: the paper's soft deformation; else it is hard.
     */
    uint32_t soft;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_net_analysis_view;

/**
 * Which rows, or columns, are replicated.
 */
typedef uint32_t gusset_replication;

/**
 * A symmetry of the rectangle of nodes. Nodes stay where they are in space, and so do normals.
 */
typedef uint32_t gusset_net_turn;

/**
 * How a copy of a net differs from it. All zeros: not at all. A part is taken first; then it is
 * made compact, enlarged, turned and converted.
 */
typedef struct gusset_net_copy_options {
    /**
     * sizeof(gusset_net_copy_options), set by the caller.
     */
    size_t struct_size;
    /**
     * The first row of the part that is copied.
     */
    size_t row_first;
    /**
     * The number of rows of the part, at least 2; 0: all from row_first on.
     */
    size_t row_count;
    /**
     * The first column of the part.
     */
    size_t column_first;
    /**
     * The number of columns of the part, at least 2; 0: all from column_first on.
     */
    size_t column_count;
    /**
     * The number of rows of nodes after replication, no fewer than there are; 0: as many as there
     * are. Links between copies of a row are contracted, and the surface stays.
     */
    size_t rows;
    /**
     * The number of columns of nodes, likewise.
     */
    size_t columns;
    /**
     * 1: rows and columns that repeat the one before them are left out. The links between the two
     * are all contracted, and coordinates and links along them are equal. Two rows and two columns
     * stay, and so do those on which a bridge ends. 0 or 1.
     */
    uint32_t compact;
    /**
     * GUSSET_REPLICATE_... for rows.
     */
    gusset_replication row_replication;
    /**
     * GUSSET_REPLICATE_... for columns.
     */
    gusset_replication column_replication;
    /**
     * Read for GUSSET_REPLICATE_AT: the row.
     */
    uint32_t row_index;
    /**
     * Read for GUSSET_REPLICATE_AT: the column.
     */
    uint32_t column_index;
    /**
     * The symmetry that rows and columns undergo: GUSSET_NET_TURN_...
     */
    gusset_net_turn turn;
    /**
     * GUSSET_F32 or GUSSET_F64: the type of the coordinates. From double to float they are rounded,
     * and nodes whose coordinates are too large become missing. 0: the type of the net.
     */
    uint32_t scalar;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_net_copy_options;

/**
 * The groups of a net, lent: valid until gusset_net_groups_destroy.
 */
typedef struct gusset_net_groups_view {
    /**
     * sizeof(gusset_net_groups_view), set by the caller.
     */
    size_t struct_size;
    /**
     * One more than the number of groups: group k is members[offsets[k]] up to
     * members[offsets[k + 1]], without the latter. Groups are in the order of their first nodes.
     */
    struct gusset_indices offsets;
    /**
     * The nodes of all groups, each group's in order.
     */
    struct gusset_indices members;
} gusset_net_groups_view;

/**
 * What a local gluing is of.
 */
typedef uint32_t gusset_gluing_place;

/**
 * One of the 18 local gluings (the paper's Fig. 4), or GUSSET_TYPE_NONE.
 */
typedef uint32_t gusset_gluing_type;

/**
 * A local gluing of a net: where it is, and what it is in the letters of the paper's Fig. 4.
 */
typedef struct gusset_gluing_occurrence {
    /**
     * GUSSET_GLUING_PLACE_NODE: at the node `element`, a type n(a, b); GUSSET_GLUING_PLACE_CELL: of
     * the cell `element`, a type c(a, b).
     */
    gusset_gluing_place place;
    /**
     * The node, row * columns + column, or the cell, row * (columns - 1) + column.
     */
    uint32_t element;
    /**
     * One of GUSSET_TYPE_...
     */
    gusset_gluing_type kind;
    /**
     * Of a node, how many nodes are glued to it; of a cell, how many of its links are glued, three
     * for all; 1 for a diagonal.
     */
    uint32_t a;
    /**
     * Of a node with two glued links, 1 if they are adjacent and 2 if they are opposite; of a cell
     * with two, how many of the other links lie between them, 0 or 1; 2 for a diagonal; UINT32_MAX
     * for types that have one letter.
     */
    uint32_t b;
    /**
     * How many nodes the gluing makes one.
     */
    uint32_t node_order;
    /**
     * How many links it makes one; 1 if none.
     */
    uint32_t link_order;
    /**
     * How many nodes of the net are one point there: more than node_order where gluings meet, as
     * at a pole.
     */
    uint32_t class_size;
} gusset_gluing_occurrence;

/**
 * Which cells count.
 */
typedef uint32_t gusset_net_cells;

/**
 * Numbers of a complex, and whatever keeps it from being a closed oriented surface. Vertices are
 * given by their smallest nodes, edges as pairs of them, one pair after the other, in order.
 * Pointers are valid until the complex is destroyed.
 */
typedef struct gusset_net_complex_view {
    /**
     * sizeof(gusset_net_complex_view), set by the caller.
     */
    size_t struct_size;
    /**
     * Vertices.
     */
    uint64_t vertex_count;
    /**
     * Edges: pairs of vertices that links join.
     */
    uint64_t edge_count;
    /**
     * Faces of four corners.
     */
    uint64_t quad_count;
    /**
     * Faces of three.
     */
    uint64_t triangle_count;
    /**
     * Cells that have become an edge.
     */
    uint64_t digon_count;
    /**
     * Cells that have become a point.
     */
    uint64_t point_count;
    /**
     * Cells that are folded along a diagonal to two edges.
     */
    uint64_t fold_count;
    /**
     * Edges of one face.
     */
    uint64_t boundary_edge_count;
    /**
     * Pieces that do not hang together.
     */
    uint64_t component_count;
    /**
     * Vertices - edges + faces.
     */
    int64_t euler;
    /**
     * Handles if it is orientable, else crosscaps, of all pieces together; -1 if it is no surface.
     */
    int64_t genus;
    /**
     * GUSSET_NET_CLOSED, ..._MANIFOLD, ..._ORIENTED, ..._ORIENTABLE.
     */
    uint32_t properties;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * 0, then the end of each chain of boundary edges in boundary_nodes: one more than there are
     * chains.
     */
    struct gusset_indices boundary_offsets;
    /**
     * The vertices of all chains, with the faces on the left; the last of a chain is followed by
     * its first.
     */
    struct gusset_indices boundary_nodes;
    /**
     * For each chain 0, or 1 if it is no loop: it ends at edges of three faces and more, and its
     * last vertex is followed by none.
     */
    struct gusset_indices boundary_open;
    /**
     * Edges of no face.
     */
    struct gusset_indices wires;
    /**
     * Edges of three faces and more.
     */
    struct gusset_indices branches;
    /**
     * Vertices whose faces are several fans that meet nowhere else.
     */
    struct gusset_indices pinches;
    /**
     * Edges that two faces run along the same way.
     */
    struct gusset_indices conflicts;
} gusset_net_complex_view;

/**
 * What a gusset_gluing glues.
 */
typedef uint32_t gusset_gluing_kind;

/**
 * Nodes to be glued, or no longer to be.
 */
typedef struct gusset_gluing {
    /**
     * One of GUSSET_GLUING_...
     */
    gusset_gluing_kind kind;
    /**
     * The link, node or cell; 0 for a seam.
     */
    uint32_t element;
    /**
     * See the kinds; 0 where none is said to have one.
     */
    uint32_t mask;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * Read for GUSSET_GLUING_SEAM only.
     */
    struct gusset_seam seam;
} gusset_gluing;

/**
 * How a net is glued. The steps are taken in the order of the fields; all zeros: none.
 */
typedef struct gusset_glue_options {
    /**
     * sizeof(gusset_glue_options), set by the caller.
     */
    size_t struct_size;
    /**
     * Read if `detect` is 1: the largest distance of nodes that lie together, at least 0 and finite,
     * in the unit of the coordinates.
     */
    double tolerance;
    /**
     * Pairs of nodes that are glued, at any alignment.
     */
    const struct gusset_gluing *gluings;
    /**
     * The number of gluings.
     */
    size_t gluing_count;
    /**
     * Links that are contracted, such as those of gusset_net_analysis_view; numbered as for
     * GUSSET_GLUING_LINK, at any alignment.
     */
    const uint32_t *links;
    /**
     * The number of links.
     */
    size_t link_count;
    /**
     * 1: what coordinates tell replaces what was glued, before anything else. Neighbours that lie
     * together are glued, and runs of two and more nodes of the sides that do, forwards or
     * backwards. The orientation of faces stays. 0 or 1.
     */
    uint32_t detect;
    /**
     * 1: every link whose ends are one point already, by way of others, is contracted, and seams
     * that links then say are dropped. Nets that glue the same neighbours have the same matrix in
     * this canonical form, which `detect` gives too. 0 or 1.
     */
    uint32_t saturate;
    /**
     * 1: all nodes that are glued to each other get the position of the first of them, bit for bit.
     * 0: positions stay.
     */
    uint32_t snap;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_glue_options;

/**
 * How a net is glued, in its one form, and how many parts that has.
 */
typedef struct gusset_net_gluing_report {
    /**
     * sizeof(gusset_net_gluing_report), set by the caller.
     */
    size_t struct_size;
    /**
     * The bytes of the characteristic matrix: 2 * rows * columns.
     */
    size_t matrix_size;
    /**
     * The number of seams.
     */
    size_t seam_count;
    /**
     * The number of bridges.
     */
    size_t bridge_count;
    /**
     * The sides if they say all about the links of the net, else UINT32_MAX: then the matrix does.
     */
    gusset_sides sides;
    /**
     * 1 if faces are taken the other way round.
     */
    uint32_t reversed;
} gusset_net_gluing_report;

/**
 * The physical properties of a bridge, under which gusset_net_settle finds its equilibrium. Units:
 * of length that of the coordinates, of force any one that all have.
 */
typedef struct gusset_bridge_properties {
    /**
     * At least 0: the force in each line of links across a thread or a ribbon, and the force per
     * length in the film of a tube.
     */
    double tension;
    /**
     * At least 0: the force that doubles the length of a line of links across.
     */
    double elasticity;
    /**
     * At least 0, against bending: force times squared length, for each line of links across;
     * infinity: rigid.
     */
    double stiffness;
    /**
     * The host's own.
     */
    uint64_t user;
} gusset_bridge_properties;

/**
 * A direction within a net.
 */
typedef uint32_t gusset_direction;

/**
 * What is done with the cells between two nets that were joined.
 */
typedef uint32_t gusset_bridge_mode;

/**
 * How nets are joined. All zeros: each right of the one before, the smaller ones enlarged
 * uniformly, bridges kept.
 */
typedef struct gusset_join_options {
    /**
     * sizeof(gusset_join_options), set by the caller.
     */
    size_t struct_size;
    /**
     * How far nodes that are welded may be apart, at least 0, in the unit of the coordinates.
     */
    double tolerance;
    /**
     * Given to every new bridge.
     */
    struct gusset_bridge_properties properties;
    /**
     * GUSSET_DIRECTION_...: where each net lies from the one before.
     */
    gusset_direction direction;
    /**
     * GUSSET_BRIDGE_KEEP, GUSSET_BRIDGE_HIDE or GUSSET_BRIDGE_WELD.
     */
    gusset_bridge_mode mode;
    /**
     * GUSSET_REPLICATE_...: how nets with fewer nodes along the side are enlarged.
     */
    gusset_replication equalise;
    /**
     * Read for GUSSET_REPLICATE_AT: the row or column.
     */
    uint32_t equalise_index;
    /**
     * Each net but the first is turned by so many places along its side, which is closed then.
     */
    uint32_t twist;
    /**
     * 1: nets whose faces are taken the other way round than those of the first are flipped along
     * the side; 0: refused.
     */
    uint32_t turn;
    /**
     * How many rows or columns of nodes of its own each new bridge has, evenly on straight lines
     * between the two sides; 0 for GUSSET_BRIDGE_WELD.
     */
    uint32_t rows;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_join_options;

/**
 * What a bridge looks like.
 */
typedef uint32_t gusset_bridge_kind;

/**
 * A bridge of a net.
 */
typedef struct gusset_bridge {
    /**
     * sizeof(gusset_bridge), set by the caller.
     */
    size_t struct_size;
    /**
     * What the host gave it.
     */
    struct gusset_bridge_properties properties;
    /**
     * GUSSET_DIRECTION_...: where the second net lies.
     */
    gusset_direction direction;
    /**
     * The first column (RIGHT) or row (DOWN) of the second net.
     */
    uint32_t at;
    /**
     * The first node along the side: a row (RIGHT) or column (DOWN).
     */
    uint32_t start;
    /**
     * One past the last one.
     */
    uint32_t end;
    /**
     * GUSSET_BRIDGE_RIBBON, GUSSET_BRIDGE_TUBE or GUSSET_BRIDGE_THREAD.
     */
    gusset_bridge_kind kind;
    /**
     * GUSSET_BRIDGE_KEEP, GUSSET_BRIDGE_HIDE or GUSSET_BRIDGE_WELD.
     */
    gusset_bridge_mode mode;
    /**
     * The rows (DOWN) or columns of its own, which lie before `at`: the side of the first net is
     * at - rows - 1.
     */
    uint32_t rows;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_bridge;

/**
 * What gusset_net_measure computes: a sum of these.
 */
typedef uint32_t gusset_net_measures;

/**
 * What gusset_net_measure finds; 0 for what is not asked for.
 */
typedef struct gusset_net_measure_report {
    /**
     * sizeof(gusset_net_measure_report), set by the caller.
     */
    size_t struct_size;
    /**
     * The area of all cells: of each, |(c - a) x (d - b)| / 2, which is exact for plane ones; for
     * others see bilinear_area.
     */
    double area;
    /**
     * What the net encloses, if it is closed and has two sides; positive if the normals look
     * outwards. For open ones: of the cone to the first node.
     */
    double volume;
    /**
     * The sum of the cells' area vectors; 0 for closed nets.
     */
    double area_vector[3];
    /**
     * The smallest coordinates of the nodes that are there; infinite if there are none.
     */
    double low[3];
    /**
     * The largest.
     */
    double high[3];
    /**
     * The area of the bilinear patches of all cells, to rounding: on cells that are not plane more
     * than `area`. A patch that is folded over itself counts with all its sheets.
     */
    double bilinear_area;
    /**
     * A bound of the error of bilinear_area.
     */
    double bilinear_error;
    /**
     * The volume of the body, of density 1, that a closed net encloses; negative if the normals look
     * inwards.
     */
    double body_volume;
    /**
     * The centre of mass of the body; NaN if its volume is 0.
     */
    double centroid[3];
    /**
     * The tensor of inertia of the body about its centroid, row after row: on the diagonal the
     * integrals of y^2 + z^2 and so on, beside it those of -x y and so on.
     */
    double inertia[9];
} gusset_net_measure_report;

/**
 * How plane the cells of a net are.
 */
typedef struct gusset_net_planarity_report {
    /**
     * sizeof(gusset_net_planarity_report), set by the caller.
     */
    size_t struct_size;
    /**
     * The largest distance of corners from the plane between them, as a part of the longer
     * diagonal; 0 if there are no cells.
     */
    double worst;
    /**
     * Its cell; 2^64 - 1 if there are no cells.
     */
    uint64_t worst_cell;
    /**
     * The mean; NaN if there are no cells.
     */
    double mean;
    /**
     * How many cells are above the tolerance.
     */
    uint64_t above;
} gusset_net_planarity_report;

/**
 * What the faces of the mesh of a net are.
 */
typedef uint32_t gusset_net_faces;

/**
 * How a net becomes a mesh. All zeros: quads, one vertex for each class of glued nodes, only
 * vertices that something uses.
 */
typedef struct gusset_net_mesh_options {
    /**
     * sizeof(gusset_net_mesh_options), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_NET_QUADS, GUSSET_NET_TRIANGLES_SHORTER or GUSSET_NET_TRIANGLES_FIXED.
     */
    gusset_net_faces faces;
    /**
     * 1: a vertex for each node, and nothing is glued. 0 or 1.
     */
    uint32_t no_weld;
    /**
     * 1: finite vertices that nothing uses are kept. 0 or 1.
     */
    uint32_t keep_unused;
    /**
     * 1: a cell of which just one corner is missing becomes a triangle. 0 or 1.
     */
    uint32_t fill_corners;
    /**
     * 1: texture coordinates are wanted. 0 or 1.
     */
    uint32_t texture;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * Faces with an edge of more than so many times the median length of edges are left out: in a
     * range image those that lead from one surface to another behind it, for which 4 is a good
     * value. Above 0; 0 for no limit.
     */
    double max_edge_ratio;
} gusset_net_mesh_options;

/**
 * What became what when a net became a mesh. Pointers are valid until the mesh is destroyed.
 */
typedef struct gusset_net_mesh_view {
    /**
     * sizeof(gusset_net_mesh_view), set by the caller.
     */
    size_t struct_size;
    /**
     * For each node its vertex, or UINT32_MAX.
     */
    struct gusset_indices vertex_of_node;
    /**
     * For each vertex the first of its nodes.
     */
    struct gusset_indices node_of_vertex;
    /**
     * For each face its cell: cell (i, j) is i * (columns - 1) + j.
     */
    struct gusset_indices cell_of_face;
    /**
     * Edges without faces, two vertices each: threads, and whatever else is left of cells whose
     * opposite sides are glued.
     */
    struct gusset_indices wires;
    /**
     * For each corner of the mesh its pair of texture coordinates; empty unless they were asked
     * for.
     */
    struct gusset_indices texture_corners;
    /**
     * Pairs u, v from 0 to 1: column and row. A vertex on a seam has one on each side of it.
     */
    const double *texture_coordinates;
    /**
     * The number of pairs.
     */
    size_t texture_count;
} gusset_net_mesh_view;

/**
 * Heights over a grid, at any alignment.
 */
typedef struct gusset_heights {
    /**
     * sizeof(gusset_heights), set by the caller.
     */
    size_t struct_size;
    /**
     * The number of rows, at least 2.
     */
    size_t rows;
    /**
     * The number of columns, at least 2.
     */
    size_t columns;
    /**
     * Number (i, j) is at values + i * row_stride + j times the scalar's size. Any numbers: NaN
     * and infinities are missing.
     */
    const void *values;
    /**
     * Bytes from row to row; 0 for rows without gaps.
     */
    size_t row_stride;
    /**
     * x from column to column and y from row to row; finite and not 0, negative where rows run
     * against y.
     */
    double spacing[2];
    /**
     * Where the first node is if its height is 0.
     */
    double origin[3];
    /**
     * Read if has_no_data is 1: the number that stands for a missing height.
     */
    double no_data;
    /**
     * 0 or 1.
     */
    uint32_t has_no_data;
    /**
     * GUSSET_F32 or GUSSET_F64: of the values, and of the net.
     */
    uint32_t scalar;
} gusset_heights;

/**
 * What the cells of a grid are in a mesh.
 */
typedef uint32_t gusset_grid_cells;

/**
 * Where a net was found in a mesh. Pointers are valid until the grid is destroyed.
 */
typedef struct gusset_net_grid_view {
    /**
     * sizeof(gusset_net_grid_view), set by the caller.
     */
    size_t struct_size;
    /**
     * For each node its vertex.
     */
    struct gusset_indices vertex_of_node;
    /**
     * For each cell its face.
     */
    struct gusset_indices face_of_cell;
} gusset_net_grid_view;

/**
 * The way of nodes from one net to another.
 */
typedef uint32_t gusset_morph_path;

/**
 * How gusset_net_planarise works. All zeros: the defaults.
 */
typedef struct gusset_planarise_options {
    /**
     * sizeof(gusset_planarise_options), set by the caller.
     */
    size_t struct_size;
    /**
     * The distance of corners from their plane that is plane enough, as a part of the diagonal of
     * the net's box; 0: 1e-10, or 4e-7 for coordinates of float.
     */
    double tolerance;
    /**
     * A byte for each node, 1 for one that stays with those glued to it and 0 for others; NULL:
     * all may move.
     */
    const uint8_t *fixed;
    /**
     * The number of bytes: rows * columns; 0 with NULL.
     */
    size_t fixed_count;
    /**
     * The largest number of steps; 0: 100.
     */
    uint32_t max_iterations;
    /**
     * 1: vertices on the boundary of the surface stay.
     */
    uint32_t keep_boundary;
} gusset_planarise_options;

/**
 * What gusset_net_planarise has done.
 */
typedef struct gusset_planarise_report {
    /**
     * sizeof(gusset_planarise_report), set by the caller.
     */
    size_t struct_size;
    /**
     * The diagonal of the net's box, before.
     */
    double size;
    /**
     * The distance that is plane enough: the tolerance times the size.
     */
    double tolerance;
    /**
     * The largest distance of the corners of a cell from the plane that lies evenly between them,
     * before.
     */
    double deviation_before;
    /**
     * The same of the net as it is now.
     */
    double deviation_after;
    /**
     * The largest displacement of a point.
     */
    double max_displacement;
    /**
     * The root of the mean square of the displacements of all points of cells of four corners.
     */
    double rms_displacement;
    /**
     * The cell of deviation_after; 2^64 - 1 without cells of four corners.
     */
    uint64_t worst_cell;
    /**
     * The steps that were taken; 0 if all cells were plane, and then no bit has changed.
     */
    uint32_t iterations;
    /**
     * 1 if deviation_after is within the tolerance; else 0, and the net is as near as the steps
     * came.
     */
    uint32_t converged;
} gusset_planarise_report;

/**
 * A shape.
 */
typedef uint32_t gusset_net_shape;

/**
 * How the two caps of a box are covered.
 */
typedef uint32_t gusset_net_box;

/**
 * A net that is wanted. Measures that the shape does not name are not read.
 */
typedef struct gusset_net_primitive {
    /**
     * sizeof(gusset_net_primitive), set by the caller.
     */
    size_t struct_size;
    /**
     * One of GUSSET_NET_PLANE to GUSSET_NET_PILLOW.
     */
    gusset_net_shape shape;
    /**
     * GUSSET_F32 or GUSSET_F64.
     */
    uint32_t scalar;
    /**
     * Rows of nodes; 0 for 33. Not read for boxes and lathes.
     */
    size_t rows;
    /**
     * Columns of nodes; 0 for 65. Not read for boxes.
     */
    size_t columns;
    /**
     * See the shapes; above 0, in the unit of the coordinates.
     */
    double radius;
    /**
     * See the shapes; above 0.
     */
    double minor_radius;
    /**
     * See the shapes; above 0, along z.
     */
    double height;
    /**
     * See the shapes; above 0, along x, y and z.
     */
    double size[3];
    /**
     * Distance from the axis, at least 0, and height of each point, from below to above, at any
     * alignment. A row on the axis is a pole; a profile that ends where it begins makes a ring.
     */
    const double *profile;
    /**
     * The number of points, twice as many numbers; at least 2.
     */
    size_t profile_count;
    /**
     * Lateral faces of a prism or pyramid, at least 3.
     */
    uint32_t sides;
    /**
     * GUSSET_NET_BOX_...
     */
    gusset_net_box box_kind;
    /**
     * Cells of a box along x, y and z, at least 1 each.
     */
    uint32_t cells[3];
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_net_primitive;

/**
 * How positions between nodes are found.
 */
typedef uint32_t gusset_interpolation;

/**
 * What is done to the visibility of an entry.
 */
typedef uint32_t gusset_visibility;

/**
 * The changes of an entry of a scene. All zeros: none.
 */
typedef struct gusset_scene_changes {
    /**
     * sizeof(gusset_scene_changes), set by the caller.
     */
    size_t struct_size;
    /**
     * The net that replaces the one of the entry, as it is now; NULL: it stays. The entry keeps its
     * index, its groups and its transform.
     */
    const struct gusset_net *net;
    /**
     * The place of the entry in the space of the groups that it is in, twelve finite numbers; NULL:
     * it stays.
     */
    const struct gusset_transform *transform;
    /**
     * GUSSET_VISIBILITY_...
     */
    gusset_visibility visibility;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_scene_changes;

/**
 * What an entry of a scene is.
 */
typedef uint32_t gusset_scene_kind;

/**
 * An entry of a scene.
 */
typedef struct gusset_scene_entry_report {
    /**
     * sizeof(gusset_scene_entry_report), set by the caller.
     */
    size_t struct_size;
    /**
     * Into the space of the groups that it is in.
     */
    struct gusset_transform transform;
    /**
     * The number of entries in a group; 0 for a net.
     */
    size_t child_count;
    /**
     * GUSSET_SCENE_NET or GUSSET_SCENE_GROUP.
     */
    gusset_scene_kind kind;
    /**
     * 1 if it is shown; a group that it is in may hide it all the same.
     */
    uint32_t visible;
} gusset_scene_entry_report;

/**
 * How much is in a scene.
 */
typedef struct gusset_scene_report {
    /**
     * sizeof(gusset_scene_report), set by the caller.
     */
    size_t struct_size;
    /**
     * Instances of nets and groups: ways from entries in no group; UINT64_MAX if there are more.
     */
    uint64_t instances;
    /**
     * Instances of nets alone.
     */
    uint64_t net_instances;
    /**
     * Entries that are nets.
     */
    uint32_t nets;
    /**
     * Entries that are groups.
     */
    uint32_t groups;
    /**
     * The longest way from an entry in no group: 1 if no group has entries, 0 for an empty scene.
     */
    uint32_t levels;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_scene_report;

/**
 * One way to an entry from an entry in no group.
 */
typedef struct gusset_scene_instance {
    /**
     * Into the space of the scene.
     */
    struct gusset_transform world;
    /**
     * The entry.
     */
    uint32_t entry;
    /**
     * The instance of the group that it is in, by its place in the list; UINT32_MAX if it is in
     * none.
     */
    uint32_t parent;
    /**
     * 1 unless it or a group on the way is hidden.
     */
    uint32_t visible;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_scene_instance;

/**
 * How gusset_net_settle works. All zeros: the defaults.
 */
typedef struct gusset_settle_options {
    /**
     * sizeof(gusset_settle_options), set by the caller.
     */
    size_t struct_size;
    /**
     * The displacement below which a step is the last, as a part of the diagonal of the net's box;
     * 0: 1e-12.
     */
    double tolerance;
    /**
     * Rest lengths as a multiple of those in the reference, above 0; 0: 1.
     */
    double rest_ratio;
    /**
     * The net at rest, of the same size, which gives rest lengths and the shape of rigid bridges;
     * NULL: the net as it is given.
     */
    const struct gusset_net *reference;
    /**
     * A byte for each part, the nets between the bridges that run from side to side, in their
     * order: 1 for one that moves, as a rigid body, and 0 for one that is held; NULL: all are
     * held.
     */
    const uint8_t *free;
    /**
     * The number of bytes: bridges + 1 at least; 0 with NULL.
     */
    size_t free_count;
    /**
     * The largest number of steps; 0: 1000.
     */
    uint32_t max_iterations;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_settle_options;

/**
 * What gusset_net_settle has done. Energies are force times length, in the units of the properties
 * and the coordinates.
 */
typedef struct gusset_settle_report {
    /**
     * sizeof(gusset_settle_report), set by the caller.
     */
    size_t struct_size;
    /**
     * The energy before, rigid bridges in their shape.
     */
    double energy_before;
    /**
     * The energy of tension now.
     */
    double tension_energy;
    /**
     * The energy of springs now.
     */
    double elastic_energy;
    /**
     * The energy of bending now.
     */
    double bending_energy;
    /**
     * The largest force on an inner point or a free body now.
     */
    double residual_force;
    /**
     * The largest displacement of a point.
     */
    double max_displacement;
    /**
     * The steps that were taken.
     */
    uint32_t iterations;
    /**
     * The bridges from side to side that have a force.
     */
    uint32_t settled;
    /**
     * Those without: hidden or welded ones, and those whose properties are all 0; their nodes
     * stay.
     */
    uint32_t idle;
    /**
     * The films that have collapsed: to less than a millionth of their area in places.
     */
    uint32_t collapsed;
    /**
     * 1 if the last step was within the tolerance, or too small to lower the energy, and no film
     * has collapsed; else 0, and the net is as near as the steps came.
     */
    uint32_t converged;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_settle_report;

/**
 * How a stream stores coordinates.
 */
typedef uint32_t gusset_stream_mode;

/**
 * How a net is to be stored.
 */
typedef struct gusset_stream_options {
    /**
     * sizeof(gusset_stream_options), set by the caller.
     */
    size_t struct_size;
    /**
     * Rows in a block, which is coded without knowledge of other blocks; 0 for about 2^17 nodes in
     * each, and for one block of all rows if the mode is RAW.
     */
    size_t rows_per_block;
    /**
     * How coordinates are stored.
     */
    gusset_stream_mode mode;
    /**
     * For QUANTISED, the bits of a coordinate, 8 to 24; 0 for 14. Else 0.
     */
    uint32_t bits;
    /**
     * For QUANTISED: 1 if the step of each axis follows from its own extent, 0 if that of all
     * follows from the longest. Else 0.
     */
    uint32_t per_axis;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_stream_options;

/**
 * The bytes of a stream, lent: valid until gusset_stream_destroy.
 */
typedef struct gusset_stream_view {
    /**
     * sizeof(gusset_stream_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The first byte.
     */
    const void *data;
    /**
     * The number of bytes.
     */
    size_t size;
} gusset_stream_view;

/**
 * What the first bytes of a stream say.
 */
typedef struct gusset_stream_report {
    /**
     * sizeof(gusset_stream_report), set by the caller.
     */
    size_t struct_size;
    /**
     * The rows of nodes.
     */
    size_t rows;
    /**
     * The columns of nodes.
     */
    size_t columns;
    /**
     * Rows in each block; the last one may have fewer.
     */
    size_t rows_per_block;
    /**
     * The bytes before the first block.
     */
    uint64_t prelude_size;
    /**
     * QUANTISED: the coordinates of level 0; a coordinate of level k is origin + k * step. Else 0.
     */
    double origin[3];
    /**
     * QUANTISED: the distance of levels. No coordinate is off by more than half of it and, as it
     * is rounded to its type, half a unit in its last place. Else 0.
     */
    double step[3];
    /**
     * GUSSET_F32 or GUSSET_F64.
     */
    uint32_t scalar;
    /**
     * How coordinates are stored.
     */
    gusset_stream_mode mode;
    /**
     * QUANTISED: the bits of a coordinate. Else 0.
     */
    uint32_t bits;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_stream_report;

/**
 * What an operation does.
 */
typedef uint32_t gusset_operation_kind;

/**
 * A spatial operation.
 */
typedef struct gusset_operation {
    /**
     * One of GUSSET_OPERATION_...
     */
    gusset_operation_kind kind;
    /**
     * For GUSSET_OPERATION_COMPRESS; else 0.
     */
    gusset_axis axis;
    /**
     * What the kind says; the rest is not read.
     */
    double values[12];
} gusset_operation;

/**
 * What is found.
 */
typedef uint32_t gusset_net_finding_kind;

/**
 * One finding.
 */
typedef struct gusset_net_finding {
    /**
     * One of GUSSET_NET_FINDING_...
     */
    gusset_net_finding_kind kind;
    /**
     * The link, or the number of the seam.
     */
    uint32_t element;
    /**
     * The two nodes.
     */
    uint32_t nodes[2];
    /**
     * How far they are apart; NaN if one is missing.
     */
    double distance;
} gusset_net_finding;

/**
 * All findings: violations first, then warnings, each kind in the order of its elements.
 */
typedef struct gusset_net_validation_view {
    /**
     * sizeof(gusset_net_validation_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The findings, valid until the validation is destroyed; NULL if there are none.
     */
    const struct gusset_net_finding *findings;
    /**
     * How many.
     */
    size_t count;
    /**
     * How many of them are violations; they come first.
     */
    size_t violation_count;
} gusset_net_validation_view;

/**
 * How a surface is built.
 */
typedef struct gusset_surface_options {
    /**
     * sizeof(gusset_surface_options), set by the caller.
     */
    size_t struct_size;
    /**
     * A length, to which answers are proved, finite; 0: 1e-9 of the diagonal of the surface's box.
     */
    double tolerance;
    /**
     * 1: with the cones of normals that isophotes (GUSSET_CONTOUR_ANGLE) and
     * gusset_surface_nearest_angle descend, about 0.7 bytes a node; 0: the first such question
     * builds them.
     */
    uint32_t cones;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_surface_options;

/**
 * A place on a surface.
 */
typedef struct gusset_surface_place {
    /**
     * The sheet, counted from 0 as they were given.
     */
    uint32_t sheet;
    /**
     * The row of the cell: between node rows row and row + 1.
     */
    uint32_t row;
    /**
     * Its column.
     */
    uint32_t column;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * The parameter within the cell, 0 to 1, from row to row; that of the sheet is row + u.
     */
    double u;
    /**
     * The same from column to column.
     */
    double v;
} gusset_surface_place;

/**
 * How two surfaces touch.
 */
typedef uint32_t gusset_contact_kind;

/**
 * A point where two surfaces touch, to the tolerance: their normals there are parallel.
 */
typedef struct gusset_surface_contact {
    /**
     * Where it is on the first surface.
     */
    struct gusset_surface_place place;
    /**
     * Where it is on the second one.
     */
    struct gusset_surface_place other;
    /**
     * A length: how far the first surface is above the second one, along the normal of the first.
     */
    double gap;
    /**
     * A length: near the contact, points of the one surface that are within the tolerance of the
     * other one are within this distance of it, but for those on branches that cross there.
     */
    double radius;
    /**
     * GUSSET_CONTACT_...
     */
    gusset_contact_kind kind;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_surface_contact;

/**
 * The curves. Pointers are valid until the handle is destroyed.
 */
typedef struct gusset_surface_paths_view {
    /**
     * sizeof(gusset_surface_paths_view), set by the caller.
     */
    size_t struct_size;
    /**
     * How many curves.
     */
    size_t path_count;
    /**
     * How many points there are in all.
     */
    size_t point_count;
    /**
     * 0, then the end of each curve among the points: curve k has the points ends[k] to ends[k +
     * 1] - 1.
     */
    struct gusset_indices ends;
    /**
     * By curve: 1 if it returns to its first point, which is not repeated. (Closed nodes and
     * gusset_curve_through_create have it again at the end.)
     */
    const uint32_t *closed;
    /**
     * By curve: the number of the plane, level or angle that it belongs to; 0 if there was one.
     */
    const uint32_t *levels;
    /**
     * x, y, z of each point, on the surface.
     */
    const double *points;
    /**
     * The unit normals there, x, y, z of each; 0 where there is none.
     */
    const double *normals;
    /**
     * Where the points are on the surface.
     */
    const struct gusset_surface_place *places;
    /**
     * For intersections: where they are on the second; else NULL.
     */
    const struct gusset_surface_place *others;
    /**
     * Cells in which something may be that could not be resolved: tangency, coincidence, or pieces
     * smaller than the tolerance.
     */
    const struct gusset_surface_place *unresolved;
    /**
     * How many.
     */
    size_t unresolved_count;
    /**
     * For intersections: points where they touch.
     */
    const struct gusset_surface_contact *contacts;
    /**
     * How many.
     */
    size_t contact_count;
} gusset_surface_paths_view;

/**
 * A cell of a surface.
 */
typedef struct gusset_surface_cell {
    /**
     * The sheet.
     */
    uint32_t sheet;
    /**
     * The row of the cell.
     */
    uint32_t row;
    /**
     * Its column.
     */
    uint32_t column;
} gusset_surface_cell;

/**
 * The cells. Pointers are valid until the handle is destroyed.
 */
typedef struct gusset_surface_cells_view {
    /**
     * sizeof(gusset_surface_cells_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The cells, rising by sheet, row, column. For pairs: the cell of the first surface, by the
     * sheets of both, then rising by row, column.
     */
    const struct gusset_surface_cell *cells;
    /**
     * How many cells or pairs.
     */
    size_t cell_count;
    /**
     * For pairs: the cell of the second surface; else NULL.
     */
    const struct gusset_surface_cell *others;
    /**
     * For a region, by cell: 1 if all of the cell is within the radius; else NULL.
     */
    const uint32_t *whole;
    /**
     * For a region: a bit for each cell of all sheets, 1 for those of the region; else NULL. The bit
     * of cell (i, j) of sheet k, which has c columns, is b = first[k] + i * c + j: mask[b / 64] >>
     * (b % 64) & 1.
     */
    const uint64_t *mask;
    /**
     * The number of words of the mask.
     */
    size_t word_count;
    /**
     * For a region, by sheet: its first bit; then the number of bits. Else NULL.
     */
    const uint64_t *first;
    /**
     * For a region: the number of sheets; else 0.
     */
    size_t sheet_count;
} gusset_surface_cells_view;

/**
 * The function on a surface whose contours are drawn.
 */
typedef uint32_t gusset_contour_kind;

/**
 * A function on a surface. Only the fields of its kind are read.
 */
typedef struct gusset_contour_function {
    /**
     * sizeof(gusset_contour_function), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_CONTOUR_...
     */
    gusset_contour_kind kind;
    /**
     * For GUSSET_CONTOUR_ANGLE. 1: a normal and its opposite are the same.
     */
    uint32_t unsigned_normals;
    /**
     * For GUSSET_CONTOUR_HEIGHT: x, y, z of a point where the height is 0.
     */
    double point[3];
    /**
     * For GUSSET_CONTOUR_HEIGHT and GUSSET_CONTOUR_ANGLE: x, y, z, of any length but 0.
     */
    double direction[3];
    /**
     * For GUSSET_CONTOUR_VALUES: finite numbers, at any alignment. Sheet follows sheet and row
     * follows row; each sheet has one more row and one more column than cells. The last line of a
     * closed direction repeats the first and is not read.
     */
    const double *values;
    /**
     * The number of values.
     */
    size_t value_count;
} gusset_contour_function;

/**
 * The points of a curve between those where it crosses the lines of the surface.
 */
typedef uint32_t gusset_point_spacing;

/**
 * How curves of a surface are given.
 */
typedef struct gusset_contour_options {
    /**
     * sizeof(gusset_contour_options), set by the caller.
     */
    size_t struct_size;
    /**
     * With GUSSET_POINT_SPACING_CHORD: a length above 0 and finite; no smaller one counts than the
     * tolerance of the surface. Otherwise not read.
     */
    double chord;
    /**
     * GUSSET_POINT_SPACING_...
     */
    gusset_point_spacing spacing;
    /**
     * With GUSSET_POINT_SPACING_LEUS: how many, at most 1000. Otherwise not read.
     */
    uint32_t points;
} gusset_contour_options;

/**
 * Where the angle of a normal is nearest to the one asked for.
 */
typedef struct gusset_nearest_angle_report {
    /**
     * sizeof(gusset_nearest_angle_report), set by the caller.
     */
    size_t struct_size;
    /**
     * Where it is.
     */
    struct gusset_surface_place place;
    /**
     * x, y, z.
     */
    double point[3];
    /**
     * The unit normal.
     */
    double normal[3];
    /**
     * Its angle with the direction, in radians.
     */
    double angle;
    /**
     * How far this is from the angle asked for; infinite if the surface has no normal anywhere,
     * and all else is 0 then.
     */
    double deviation;
    /**
     * No normal's angle is nearer than this: at most 1e-9 less than deviation, or more where that
     * could not be proved.
     */
    double bound;
} gusset_nearest_angle_report;

/**
 * How the surface is drawn through nodes.
 */
typedef uint32_t gusset_scheme;

/**
 * The way in which a coordinate curve of a sheet runs.
 */
typedef uint32_t gusset_sheet_direction;

/**
 * A line, ray or segment: the points origin + t * direction for t from `from` to `to`.
 */
typedef struct gusset_line {
    /**
     * x, y, z of the point where t is 0; from -1e150 to 1e150.
     */
    double origin[3];
    /**
     * x, y, z of the direction; of a length whose square neither vanishes nor overflows, such as
     * any from 1e-150 to 1e150. t counts lengths of it.
     */
    double direction[3];
    /**
     * The least t: -INFINITY for lines, 0 for rays and segments; not INFINITY.
     */
    double from;
    /**
     * The greatest t: INFINITY for lines and rays; not below `from`, and not -INFINITY.
     */
    double to;
} gusset_line;

/**
 * The object from which a distance is measured.
 */
typedef uint32_t gusset_target_kind;

/**
 * An object in space. The function reads only the fields of its kind.
 */
typedef struct gusset_target {
    /**
     * sizeof(gusset_target), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_TARGET_...
     */
    gusset_target_kind kind;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * For GUSSET_TARGET_LINE.
     */
    struct gusset_line line;
    /**
     * For GUSSET_TARGET_PLANE: x, y, z of a point of the plane, from -1e150 to 1e150.
     */
    double point[3];
    /**
     * For GUSSET_TARGET_PLANE: x, y, z across the plane, of any length but 0.
     */
    double normal[3];
    /**
     * For GUSSET_TARGET_CURVE: a curve of any degrees; coordinates from -1e150 to 1e150.
     */
    const struct gusset_curve *curve;
    /**
     * For GUSSET_TARGET_SURFACE.
     */
    const struct gusset_surface *surface;
} gusset_target;

/**
 * Bits of gusset_distance_report.
 */
typedef uint32_t gusset_distance_flags;

/**
 * The nearest points of a surface and a target.
 */
typedef struct gusset_distance_report {
    /**
     * sizeof(gusset_distance_report), set by the caller.
     */
    size_t struct_size;
    /**
     * Where the nearest point of the surface is.
     */
    struct gusset_surface_place place;
    /**
     * x, y, z of it.
     */
    double point[3];
    /**
     * The unit normal there, or its limit at a pole; 0 where there is none.
     */
    double normal[3];
    /**
     * x, y, z of the nearest point of the target.
     */
    double other_point[3];
    /**
     * Their distance.
     */
    double distance;
    /**
     * No points of the two are nearer to each other than this.
     */
    double bound;
    /**
     * For a surface: where its nearest point is; else 0.
     */
    struct gusset_surface_place other_place;
    /**
     * For a curve: where its nearest point is; else 0.
     */
    struct gusset_place curve_place;
    /**
     * For a line: its parameter at the nearest point. For a plane: the distance, negative if the
     * surface's point is not on the side that the normal points to. Else 0.
     */
    double parameter;
    /**
     * GUSSET_DISTANCE_...
     */
    gusset_distance_flags flags;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_distance_report;

/**
 * The kind of a normal.
 */
typedef uint32_t gusset_normal_kind;

/**
 * A point of a surface, with derivatives, normal and curvatures. Derivatives are by the parameters within the
 * cell.
 */
typedef struct gusset_surface_point {
    /**
     * The point.
     */
    double point[3];
    /**
     * S_u.
     */
    double u[3];
    /**
     * S_v.
     */
    double v[3];
    /**
     * S_uu.
     */
    double uu[3];
    /**
     * S_uv.
     */
    double uv[3];
    /**
     * S_vv.
     */
    double vv[3];
    /**
     * The unit normal, to the side of S_u x S_v; 0 if there is none.
     */
    double normal[3];
    /**
     * For limits: the largest angle, in radians, to limits along other lines to the same point.
     * Small at the pole of a smooth surface, large at the tip of a cone, which has no normal.
     */
    double spread;
    /**
     * The principal curvatures, the greater first: positive where the surface bends towards the
     * normal.
     */
    double principal[2];
    /**
     * Their directions: two unit tangents, x, y, z each.
     */
    double directions[6];
    /**
     * The mean curvature.
     */
    double mean;
    /**
     * The Gaussian curvature.
     */
    double gaussian;
    /**
     * GUSSET_NORMAL_...
     */
    gusset_normal_kind normal_kind;
    /**
     * 1: there are curvatures; 0: they are 0, as the surface is not regular there.
     */
    uint32_t is_curved;
} gusset_surface_point;

/**
 * Which hits are wanted.
 */
typedef uint32_t gusset_hit_selection;

/**
 * The kind of a hit.
 */
typedef uint32_t gusset_hit_kind;

/**
 * A point that a line or a curve and a surface have in common.
 */
typedef struct gusset_surface_hit {
    /**
     * Where on the line; of a curve the number of the segment and the parameter on it, added.
     */
    double t;
    /**
     * From where to where it cannot be told from the surface, within the tolerance; t twice at
     * crossings.
     */
    double span[2];
    /**
     * Where on the surface.
     */
    struct gusset_surface_place place;
    /**
     * x, y, z of the point of the surface.
     */
    double point[3];
    /**
     * x, y, z of the unit normal there, its limit at a pole, or 0 if there is none.
     */
    double normal[3];
    /**
     * GUSSET_HIT_...
     */
    gusset_hit_kind kind;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_surface_hit;

/**
 * The hits. Pointers are valid until the handle is destroyed.
 */
typedef struct gusset_surface_hits_view {
    /**
     * sizeof(gusset_surface_hits_view), set by the caller.
     */
    size_t struct_size;
    /**
     * How many were asked about: the lines, and after them the curve, if there is one.
     */
    size_t query_count;
    /**
     * How many hits there are in all.
     */
    size_t hit_count;
    /**
     * 0, then the end of each query's hits among all: query k has the hits from ends[k] until
     * ends[k + 1]. query_count + 1 numbers.
     */
    const uint64_t *ends;
    /**
     * The hits, those of a query by rising t.
     */
    const struct gusset_surface_hit *hits;
    /**
     * For each hit of the curve three places on the curve: the hit, and where its span begins and
     * ends. NULL without a curve.
     */
    const struct gusset_place *on_curve;
    /**
     * The number of places on the curve.
     */
    size_t on_curve_count;
} gusset_surface_hits_view;

/**
 * Measures of a region of cells.
 */
typedef struct gusset_mask_report {
    /**
     * sizeof(gusset_mask_report), set by the caller.
     */
    size_t struct_size;
    /**
     * How many cells it has.
     */
    uint64_t cells;
    /**
     * The number of cells of the longest of the shortest chains between two of its cells; 0 for no
     * cells, 2^64 - 1 if the region is in several parts.
     */
    uint64_t integer_diameter;
    /**
     * Vertices less edges plus cells: 1 for a region in one part without holes.
     */
    int64_t euler;
    /**
     * No two points of the region are farther apart: the integer diameter times the greatest
     * Euclidean diameter of its cells; infinite if the region is in several parts.
     */
    double diameter;
} gusset_mask_report;

/**
 * The points that are looked for.
 */
typedef struct gusset_nearest_options {
    /**
     * sizeof(gusset_nearest_options), set by the caller.
     */
    size_t struct_size;
    /**
     * No point farther than this is looked for; a length, at least 0; 0 or INFINITY: no limit.
     */
    double limit;
    /**
     * For minima: the number of the nearest that are wanted; 0: all.
     */
    size_t max_count;
} gusset_nearest_options;

/**
 * Bits of gusset_surface_nearest_point.
 */
typedef uint32_t gusset_nearest_flags;

/**
 * A point of a surface that was found for a query.
 */
typedef struct gusset_surface_nearest_point {
    /**
     * Where it is on the surface.
     */
    struct gusset_surface_place place;
    /**
     * x, y, z.
     */
    double point[3];
    /**
     * The unit normal there, or its limit at a pole; 0 where there is none. The query is on its
     * side if (query - point) . normal > 0.
     */
    double normal[3];
    /**
     * The distance from the query.
     */
    double distance;
    /**
     * No point of the surface is nearer than this; of minima: none of the piece of surface round
     * the point.
     */
    double bound;
    /**
     * GUSSET_NEAREST_...
     */
    gusset_nearest_flags flags;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_surface_nearest_point;

/**
 * The points that were found. Pointers are valid until the handle is destroyed.
 */
typedef struct gusset_surface_points_view {
    /**
     * sizeof(gusset_surface_points_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The points, the nearest first.
     */
    const struct gusset_surface_nearest_point *points;
    /**
     * How many.
     */
    size_t count;
    /**
     * None is missing that is nearer than this.
     */
    double bound;
    /**
     * 1, or 0 if the search gave up at that distance, as it may where the distance is the same all
     * over the surface.
     */
    uint32_t complete;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_surface_points_view;

/**
 * The object from which distances or angles are measured.
 */
typedef uint32_t gusset_reference_object;

/**
 * The task of the paper's search, and its method.
 */
typedef struct gusset_reference_task {
    /**
     * sizeof(gusset_reference_task), set by the caller.
     */
    size_t struct_size;
    /**
     * GUSSET_REFERENCE_...
     */
    gusset_reference_object object;
    /**
     * 0: cells that may have something within `within`. 1: cells that may have the nearest.
     */
    uint32_t find_nearest;
    /**
     * A point of the object; not read for angles.
     */
    double point[3];
    /**
     * Its direction, of any length but 0; not read for points.
     */
    double direction[3];
    /**
     * A distance, 0 or more, in the unit of the nodes, for angles in radians; INFINITY: all cells;
     * not read for the nearest.
     */
    double within;
    /**
     * For GUSSET_REFERENCE_ANGLE: the angle, 0 to pi.
     */
    double angle;
    /**
     * For GUSSET_REFERENCE_ANGLE: a bound of both principal curvatures all over the sheet, for the
     * paper's K d, see gusset_sheet_measure; 0: cones of normals instead, which are
     * tighter.
     */
    double curvature;
    /**
     * For GUSSET_REFERENCE_ANGLE: 1 if normals of the other side will do as well.
     */
    uint32_t unsigned_normals;
    /**
     * 1: blocks are bounded by sums of the greatest bound of each ring of cells, instead of J d.
     */
    uint32_t by_rings;
    /**
     * 1: nodes in the order of rows, as in the paper; 0: a few far apart first.
     */
    uint32_t by_rows;
    /**
     * 1: lines of nodes that a block covers from side to side are not left out at once.
     */
    uint32_t keep_lines;
    /**
     * For GUSSET_REFERENCE_CURVE: the curve; else not read.
     */
    const struct gusset_curve *curve;
    /**
     * For GUSSET_REFERENCE_SURFACE: the surface; else not read.
     */
    const struct gusset_surface *surface;
} gusset_reference_task;

/**
 * A report on the search.
 */
typedef struct gusset_reference_report {
    /**
     * sizeof(gusset_reference_report), set by the caller.
     */
    size_t struct_size;
    /**
     * How many cells are left.
     */
    uint64_t cells;
    /**
     * How many nodes were looked at.
     */
    uint64_t evaluations;
    /**
     * How many blocks of cells were excluded.
     */
    uint64_t blocks;
    /**
     * How many lines of cells were left out at once.
     */
    uint64_t dropped;
    /**
     * The least distance of the nodes that were looked at; of the nearest task: of all nodes.
     */
    double min_distance;
    /**
     * The row of that node.
     */
    uint32_t row;
    /**
     * Its column.
     */
    uint32_t column;
} gusset_reference_report;

/**
 * A sheet of a surface.
 */
typedef struct gusset_surface_sheet {
    /**
     * Cells in u: u runs from 0 to this. There is one more row of corners.
     */
    size_t rows;
    /**
     * Cells in v.
     */
    size_t columns;
    /**
     * The number of its cell (0, 0) among the cells of all sheets, one sheet after the other, each
     * row after row. Cell (i, j) has the number first_cell + i * columns + j, which is its bit in
     * masks of gusset_surface_cells_view.
     */
    uint64_t first_cell;
    /**
     * The number of its corner (0, 0) among the corners of all sheets, rows + 1 by columns + 1
     * each: where its values begin for GUSSET_CONTOUR_VALUES.
     */
    uint64_t first_node;
    /**
     * 1: closed in u.
     */
    uint32_t closed_u;
    /**
     * 1: closed in v.
     */
    uint32_t closed_v;
} gusset_surface_sheet;

/**
 * Facts about a surface.
 */
typedef struct gusset_surface_report {
    /**
     * sizeof(gusset_surface_report), set by the caller.
     */
    size_t struct_size;
    /**
     * How many sheets.
     */
    size_t sheet_count;
    /**
     * How many cells, of all sheets.
     */
    size_t cell_count;
    /**
     * How many corners of cells: of sheets from nodes, the nodes.
     */
    size_t node_count;
    /**
     * Bytes of the index without the cones of normals; the nodes are not counted.
     */
    size_t index_bytes;
    /**
     * The length to which answers are proved.
     */
    double tolerance;
    /**
     * A corner of a box round the surface and the control nets of its cells, which may be larger
     * than the surface: the least x, y, z.
     */
    double low[3];
    /**
     * The greatest.
     */
    double high[3];
    /**
     * Bytes of the cones of normals; 0 as long as there are none: see gusset_surface_options.
     */
    size_t cone_bytes;
    /**
     * The sheets, sheet_count of them, valid as long as the surface.
     */
    const struct gusset_surface_sheet *sheets;
} gusset_surface_report;

/**
 * Nodes of a surface: x, y, z of node (i, j) are at nodes + i * row_stride + j * column_stride
 * bytes, one after the other. Normals are those of u (from row to row) and then v: opposite to
 * those of a net of the same nodes.
 */
typedef struct gusset_nodes {
    /**
     * sizeof(gusset_nodes), set by the caller.
     */
    size_t struct_size;
    /**
     * The first node.
     */
    const void *nodes;
    /**
     * The number of rows, at least 2; of a surface closed in u at least 4, of which the last
     * repeats the first.
     */
    size_t rows;
    /**
     * The number of columns, the same for v. rows * columns is at most 2^31 - 1.
     */
    size_t columns;
    /**
     * Bytes from row to row; 0 for rows without gaps.
     */
    size_t row_stride;
    /**
     * Bytes from node to node in a row; 0 for nodes without gaps.
     */
    size_t column_stride;
    /**
     * GUSSET_F32 or GUSSET_F64.
     */
    uint32_t scalar;
    /**
     * GUSSET_SCHEME_...
     */
    gusset_scheme scheme;
    /**
     * 1: closed in u, along columns: the last row is the first one again.
     */
    uint32_t closed_u;
    /**
     * 1: closed in v, along rows.
     */
    uint32_t closed_v;
} gusset_nodes;

/**
 * How the mixed derivatives S_uv at nodes are found, which tangents leave open.
 */
typedef uint32_t gusset_twists;

/**
 * Tangents at the nodes of a surface, row after row, packed; the parameters are those of nodes:
 * S_u is as long as the step from row to row.
 */
typedef struct gusset_tangents {
    /**
     * sizeof(gusset_tangents), set by the caller.
     */
    size_t struct_size;
    /**
     * S_u at each node: x, y, z; towards the next row.
     */
    const double *u;
    /**
     * S_v at each node: towards the next column.
     */
    const double *v;
    /**
     * For GUSSET_TWISTS_GIVEN: S_uv at each node; else not read.
     */
    const double *twists;
    /**
     * GUSSET_TWISTS_...
     */
    gusset_twists twist;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_tangents;

/**
 * A tensor-product B-spline, rational (NURBS) if it has weights that differ.
 *
 * Knots of an open direction: as many as control points and the degree and 1, not decreasing,
 * finite, clamped or not; the surface is defined between knot degree and knot count. Of a closed
 * one: one more than control points, one period; the control points are not repeated, and span k,
 * from knot k to the next, is made by the control points k - degree to k, counted round. Inner
 * knots may be repeated degree times.
 *
 * The control points of a rational spline are points of space (Euclidean), not multiplied by their
 * weights. A Bézier patch is the spline whose knots are 0 and 1, degree + 1 times each; patches
 * that share sides and their weights are one spline with inner knots repeated degree times.
 */
typedef struct gusset_spline {
    /**
     * sizeof(gusset_spline), set by the caller.
     */
    size_t struct_size;
    /**
     * x, y, z of the control points, row after row, packed: rows follow each other in u.
     */
    const double *points;
    /**
     * The number of rows of control points, more than degree_u.
     */
    size_t count_u;
    /**
     * The number of control points in a row, more than degree_v.
     */
    size_t count_v;
    /**
     * The knots of u.
     */
    const double *knots_u;
    /**
     * How many.
     */
    size_t knot_count_u;
    /**
     * The knots of v.
     */
    const double *knots_v;
    /**
     * How many.
     */
    size_t knot_count_v;
    /**
     * The degree in u, 1 to 7.
     */
    uint32_t degree_u;
    /**
     * The degree in v, 1 to 7.
     */
    uint32_t degree_v;
    /**
     * 1: closed in u.
     */
    uint32_t closed_u;
    /**
     * 1: closed in v.
     */
    uint32_t closed_v;
    /**
     * The weights of the control points, in their order, finite and above 0, none less than 2^-900
     * of the greatest; a factor common to all changes nothing. NULL: all are 1.
     */
    const double *weights;
    /**
     * How far the sheet may be from a rational spline at equal parameters, a length; no less than
     * rounding allows, some 1e-13 of the size. 0: 1e-12 of the diagonal of the control points' box,
     * or more where rounding asks for it, far from the origin.
     */
    double tolerance;
    /**
     * The most cells that a rational spline may take; 0: 2^20.
     */
    size_t max_cells;
} gusset_spline;

/**
 * A net of curves: each row meets each column, in the order in which they are given; curves may
 * run either way.
 */
typedef struct gusset_curve_net {
    /**
     * sizeof(gusset_curve_net), set by the caller.
     */
    size_t struct_size;
    /**
     * Curves in v, which follow each other in u. Segments of degree 7 at most; a curve that is one
     * point is a pole.
     */
    const struct gusset_curve *const *rows;
    /**
     * How many: 0, or at least 2, or 3 if closed_u.
     */
    size_t row_count;
    /**
     * Curves in u, which follow each other in v.
     */
    const struct gusset_curve *const *columns;
    /**
     * How many: 0, or at least 2, or 3 if closed_v. Without columns, or without rows, the surface
     * is the skin of the others.
     */
    size_t column_count;
    /**
     * How far apart curves may be where they meet, a length, finite; both are moved to the middle.
     * 0: 1e-6 of the diagonal of their box.
     */
    double tolerance;
    /**
     * 1: the columns are closed curves, and the last row is followed by the first.
     */
    uint32_t closed_u;
    /**
     * 1: the rows are closed curves, and the last column is followed by the first.
     */
    uint32_t closed_v;
} gusset_curve_net;

/**
 * The surface that is made of a frame.
 */
typedef uint32_t gusset_frame_surface;

/**
 * How a sheet becomes a mesh. All zeros: quads, one a cell.
 */
typedef struct gusset_sheet_mesh_options {
    /**
     * sizeof(gusset_sheet_mesh_options), set by the caller.
     */
    size_t struct_size;
    /**
     * How far triangles may be from the surface, a length more than 0; 0, or INFINITY: no demand.
     */
    double tolerance;
    /**
     * The fewest parts of each cell in u; 0 stands for 1.
     */
    uint32_t min_u;
    /**
     * The fewest parts of each cell in v; 0 stands for 1.
     */
    uint32_t min_v;
    /**
     * 1: triangles only; 0: quads, and triangles at poles.
     */
    uint32_t triangles;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_sheet_mesh_options;

/**
 * What belongs to the mesh of a sheet. Pointers are valid until it is destroyed.
 */
typedef struct gusset_sheet_mesh_view {
    /**
     * sizeof(gusset_sheet_mesh_view), set by the caller.
     */
    size_t struct_size;
    /**
     * The number of vertices.
     */
    size_t vertex_count;
    /**
     * For each vertex its place; the sheet is 0.
     */
    const struct gusset_surface_place *places;
    /**
     * For each vertex the unit normal: x, y, z; 0 where there is none.
     */
    const double *normals;
    /**
     * A bound of the distance between the surface and the triangles, or either pair of triangles
     * of quads.
     */
    double deviation;
} gusset_sheet_mesh_view;

/**
 * Facts about a sheet.
 */
typedef struct gusset_sheet_report {
    /**
     * sizeof(gusset_sheet_report), set by the caller.
     */
    size_t struct_size;
    /**
     * Cells in u: u runs from 0 to this.
     */
    size_t rows;
    /**
     * Cells in v.
     */
    size_t columns;
    /**
     * The degree of the patches in both directions as they are kept: 3 or 7.
     */
    uint32_t degree;
    /**
     * 1: the nodes are kept and patches are made when they are needed; 0: the patches are kept.
     */
    uint32_t is_grid;
    /**
     * 1: closed in u.
     */
    uint32_t closed_u;
    /**
     * 1: closed in v.
     */
    uint32_t closed_v;
    /**
     * 1: the side u = 0 is one point, a pole.
     */
    uint32_t pole_u0;
    /**
     * 1: the side u = rows is.
     */
    uint32_t pole_u1;
    /**
     * 1: the side v = 0 is.
     */
    uint32_t pole_v0;
    /**
     * 1: the side v = columns is.
     */
    uint32_t pole_v1;
    /**
     * For a rational spline, a bound of how far the sheet is from it at equal parameters, rounding
     * included; 0 of any other sheet.
     */
    double deviation;
    /**
     * For a spline, the knots of rows: rows + 1 parameters that rise, between which the spline's
     * parameter runs evenly; NULL of any other sheet. Valid as long as the sheet.
     */
    const double *knots_u;
    /**
     * The knots of columns: columns + 1.
     */
    const double *knots_v;
} gusset_sheet_report;

/**
 * The numbers of a whole sheet that are wanted.
 */
typedef uint32_t gusset_sheet_measure_flags;

/**
 * Arrays that receive a number for each cell, row after row: number i * columns + j is that of cell
 * (i, j). NULL: the number is not computed.
 */
typedef struct gusset_cell_arrays {
    /**
     * sizeof(gusset_cell_arrays), set by the caller.
     */
    size_t struct_size;
    /**
     * How many numbers each array has room for, at least the cells of the sheet.
     */
    size_t capacity;
    /**
     * Bounds of the distance between any two points of the cell, from its control net.
     */
    double *diameters;
    /**
     * Bounds of the length of the shortest curve within the cell between any two of its points.
     */
    double *intrinsic_diameters;
    /**
     * Estimates of how far a surface through nodes is from the smooth one that they were taken
     * from, at equal parameters: C h^4 times the fourth derivatives, from differences of nodes. No
     * bound; infinite for fewer than 5 nodes in a direction; 0 if the patches were given.
     */
    double *errors;
    /**
     * Bounds of how far the surface is from the bilinear patch through the cell's corners.
     */
    double *bilinear;
    /**
     * Bounds of how far the surface is from the two triangles that either diagonal makes.
     */
    double *triangles;
} gusset_cell_arrays;

/**
 * Numbers of a whole sheet; 0 if they were not asked for.
 */
typedef struct gusset_sheet_measures {
    /**
     * sizeof(gusset_sheet_measures), set by the caller.
     */
    size_t struct_size;
    /**
     * The greatest of the diameters of cells, the paper's d: a bound of the distance between any two
     * points of a cell.
     */
    double diameter;
    /**
     * The greatest of the intrinsic diameters of cells.
     */
    double intrinsic_diameter;
    /**
     * A bound of the principal curvatures in absolute terms, from control nets: the paper's K.
     * Infinite where the surface is not regular, as at poles.
     */
    double curvature_bound;
    /**
     * The largest angle between the normals on both sides of borders between cells, in radians: 0,
     * or rounding, where the surface is smooth.
     */
    double crease;
} gusset_sheet_measures;

/**
 * How intersections are wanted.
 */
typedef struct gusset_intersection_options {
    /**
     * sizeof(gusset_intersection_options), set by the caller.
     */
    size_t struct_size;
    /**
     * With GUSSET_POINT_SPACING_CHORD: a length above 0 and finite, the greatest distance of the
     * curve from the chords between its points, as their tangents and middles show it. (1.14 times
     * as much was seen at one chord in 10,000.) A chord that is smaller than `tolerance` and than
     * the surfaces' own tolerances counts as the smaller one of these. Otherwise not read.
     */
    double chord;
    /**
     * A length, finite: surfaces that are apart, or overlap, by no more than that all over touch
     * there. 0: the smaller one of the tolerances of the two surfaces. Branches are found and told
     * apart by that one, or by `tolerance` if it is smaller: shorter ones may be lost. A surface's
     * intersections with itself take a greater one for the surface's own.
     */
    double tolerance;
    /**
     * GUSSET_POINT_SPACING_...: all but GUSSET_POINT_SPACING_LEUS; for
     * GUSSET_POINT_SPACING_AUTO the smaller surface's box counts.
     */
    gusset_point_spacing spacing;
    /**
     * 0.
     */
    uint32_t reserved;
} gusset_intersection_options;

/**
 * 32-bit floats.
 */
#define GUSSET_VALUE_F32 1

/**
 * 64-bit floats.
 */
#define GUSSET_VALUE_F64 2

/**
 * 8-bit unsigned integers.
 */
#define GUSSET_VALUE_U8 3

/**
 * 16-bit unsigned integers.
 */
#define GUSSET_VALUE_U16 4

/**
 * 32-bit unsigned integers.
 */
#define GUSSET_VALUE_U32 5

/**
 * The weighted mean, as of colours; of integers rounded.
 */
#define GUSSET_RULE_LINEAR 0

/**
 * Directions of three components, floats: the weighted mean on the sphere, of length 1. Those of
 * faces that the operation turned over are turned, too.
 */
#define GUSSET_RULE_NORMAL 1

/**
 * Weights of bones, at least 0: the weighted mean, of which the max_influences largest are kept,
 * the first of equal ones, and made to have the sum 1, or of integers the largest number of the
 * type.
 */
#define GUSSET_RULE_SKIN_WEIGHTS 2

/**
 * The value of the source that counts most, the first of equal ones, as of materials and numbers.
 */
#define GUSSET_RULE_NEAREST 3

/**
 * Texture coordinates. At the corners of new faces they are the weighted mean where both sides are
 * on one chart: on each rim as long as the old faces have the same values at its vertices, and
 * across a gap where for most of the new faces the values beyond are nearer to where their own
 * side's chart would go on than half of the way there and of their base. Elsewhere each new face
 * goes on with the chart of the old face that it comes from, unfolded, and the charts meet in a
 * seam in the middle. Beyond the cut of a chart that goes round, values count by the jump at the
 * cut, or, where that is no repeat of the texture, as where the base's chart goes on: no face runs
 * back over the chart. Of vertices and faces it is the weighted mean.
 */
#define GUSSET_RULE_TEXTURE 4

/**
 * Vertices; the points of polylines, the nodes of a net or a sheet.
 */
#define GUSSET_DOMAIN_VERTICES 0

/**
 * Corners of faces, in the order of face_corners; the nodes of a net or a sheet.
 */
#define GUSSET_DOMAIN_CORNERS 1

/**
 * Faces; the cells of a net or a sheet.
 */
#define GUSSET_DOMAIN_FACES 2

/**
 * In memory of the library's: the caller's are copied.
 */
#define GUSSET_NET_MEMORY_COPY 0

/**
 * In the caller's memory.
 */
#define GUSSET_NET_MEMORY_BORROW 1

/**
 * Along rows, from column to column.
 */
#define GUSSET_DIRECTION_RIGHT 0

/**
 * Along columns, from row to row.
 */
#define GUSSET_DIRECTION_DOWN 1

/**
 * All of them, as equally as it goes.
 */
#define GUSSET_REPLICATE_UNIFORM 0

/**
 * The first one.
 */
#define GUSSET_REPLICATE_FIRST 1

/**
 * The last one.
 */
#define GUSSET_REPLICATE_LAST 2

/**
 * The one whose index is given.
 */
#define GUSSET_REPLICATE_AT 3

/**
 * The first and the last one, if they are a point each, in equal shares; if one of them is, that
 * one; else as UNIFORM.
 */
#define GUSSET_REPLICATE_AT_POLES 4

/**
 * None: sizes that differ are refused. For gusset_join_options only.
 */
#define GUSSET_REPLICATE_REFUSE 5

/**
 * Rows and columns stay.
 */
#define GUSSET_NET_TURN_NONE 0

/**
 * A quarter of a turn: the last column becomes the first row.
 */
#define GUSSET_NET_TURN_QUARTER 1

/**
 * Half a turn: the last row and the last column come first.
 */
#define GUSSET_NET_TURN_HALF 2

/**
 * Three quarters of a turn: the first column becomes the last row.
 */
#define GUSSET_NET_TURN_THREE_QUARTERS 3

/**
 * The last column comes first.
 */
#define GUSSET_NET_TURN_FLIP_COLUMNS 4

/**
 * The last row comes first.
 */
#define GUSSET_NET_TURN_FLIP_ROWS 5

/**
 * Rows and columns are exchanged.
 */
#define GUSSET_NET_TURN_TRANSPOSE 6

/**
 * Rows and columns are exchanged, both backwards.
 */
#define GUSSET_NET_TURN_ANTITRANSPOSE 7

/**
 * Of a node: which of its links have become a point.
 */
#define GUSSET_GLUING_PLACE_NODE 0

/**
 * Of a cell: what it has become.
 */
#define GUSSET_GLUING_PLACE_CELL 1

/**
 * All.
 */
#define GUSSET_NET_CELLS_ALL 0

/**
 * Those whose four nodes have finite coordinates and that no hidden bridge has.
 */
#define GUSSET_NET_CELLS_PRESENT 1

/**
 * An affine map: values[0] to values[11], three rows of four. In part: that part of the straight
 * way. Unlike gusset_net_transform it leaves the net's flag `reversed` alone where it mirrors.
 */
#define GUSSET_FIELD_AFFINE 1

/**
 * Turns about `axis`, by the right hand, by values[0] radians for each unit along it from the
 * coordinate values[1] on. In part: by that part of the angle.
 */
#define GUSSET_FIELD_TWIST 2

/**
 * Distances from `axis` grow by values[0] times themselves for each unit along it from the
 * coordinate values[1] on. In part: at that part of the rate.
 */
#define GUSSET_FIELD_TAPER 3

/**
 * Bends `axis` from its coordinate values[1] to values[2] (only the latter may be infinite) to an
 * arc of the curvature values[0], towards the axis that follows; what lies beyond goes on
 * straight. In part: with that part of the curvature.
 */
#define GUSSET_FIELD_BEND 4

/**
 * The coordinate on `axis` grows by values[0] times that on `other_axis`. In part: at that part of
 * the rate.
 */
#define GUSSET_FIELD_SHEAR 5

/**
 * Moves points onto the sphere with the centre values[0] to values[2] and the radius values[3] >
 * 0, straight from its centre, where it is not defined. In part: that part of the way.
 */
#define GUSSET_FIELD_SPHERIFY 6

/**
 * Rolls space up about `axis`: of the two axes that follow, the first becomes the arc and the
 * second the height above a cylinder of the radius r = values[0] > 0: with the first u and the
 * second v they become (r + v) sin(u / r) and (r + v) cos(u / r). In part, t: rolled to the
 * curvature t / r, so that a sheet of height 0 keeps all its lengths.
 */
#define GUSSET_FIELD_CYLINDER_WRAP 7

/**
 * Rolls space up to a torus about `axis` with the radii values[0] > 0 (to the middle of the tube)
 * and values[1] > 0 (of the tube): of the two axes that follow, the first goes round the axis and
 * the second round the tube; the axis itself becomes the height above the torus. In part, t: up to
 * 1/2 the sheet rolls to a straight tube, to the curvature 2 t / values[1], and keeps all its
 * lengths; then the tube bends to the curvature (2 t - 1) / values[0] of its middle, and the circles
 * round it keep their lengths.
 */
#define GUSSET_FIELD_TORUS_WRAP 8

/**
 * Free-form deformation: the box from values[0..2] to values[3..5] has counts[0] x counts[1] x
 * counts[2] control points, 2 to 32 each way; offsets: how far each is moved, x, y, z, from its
 * place in the even grid, x running first, then y. Outside the box nothing moves. In part: that
 * part of the way.
 */
#define GUSSET_FIELD_LATTICE 9

/**
 * A map of homogeneous coordinates: four rows of four. Not defined where the fourth coordinate
 * becomes 0. In part: that part of the straight way, as for the other projections.
 */
#define GUSSET_FIELD_PROJECTION 10

/**
 * Onto the plane through values[0..2] with the normal values[3..5], along the direction
 * values[6..8].
 */
#define GUSSET_FIELD_PARALLEL 11

/**
 * Onto the plane through values[3..5] with the normal values[6..8], along the lines through the
 * eye values[0..2]. Not defined level with the eye.
 */
#define GUSSET_FIELD_PERSPECTIVE 12

/**
 * Rolls space up to a cone about `axis`: of the two axes that follow, the first becomes the arc of
 * the circle of the radius r = values[0] > 0 and the second the height above the cone; the axis
 * itself, w, becomes the length along the generators, which lean towards the axis by values[1],
 * from -pi / 2 to pi / 2: the apex is at w = r / sin(values[1]). In part, t: leaning by t values[1]
 * and rolled to the curvature t / r; generators keep their lengths, and the circle at w becomes
 * 1 - (t / r) w sin(t values[1]) times as long.
 */
#define GUSSET_FIELD_CONE_WRAP 13

/**
 * Rolls space up to a sphere about `axis` of the radius r = values[0] > 0: of the two axes that
 * follow, the first, from 0 to 2 pi r, goes round the equator, and the second, from -pi / 2 r to
 * pi / 2 r, along the meridians; the axis itself becomes the height above the sphere. In part, t: up
 * to 1/2 the sheet rolls to a tube, to the curvature 2 t / r, and keeps all its lengths; then the
 * meridians bend to the curvature q / r, q = 2 t - 1, and keep their lengths, and the parallel at v
 * becomes 1 - (1 - cos(q v / r)) / q times as long.
 */
#define GUSSET_FIELD_SPHERE_WRAP 14

/**
 * Evenly.
 */
#define GUSSET_EASING_LINEAR 0

/**
 * Starting and ending at rest.
 */
#define GUSSET_EASING_SMOOTH 1

/**
 * Stays until it jumps.
 */
#define GUSSET_EASING_HOLD 2

/**
 * The two ends of link `element`. Links are numbered by nodes: 2 * node is that to the next node
 * of the row (of the last one to the first), 2 * node + 1 that to the next of the column; node (i,
 * j) is i * columns + j.
 */
#define GUSSET_GLUING_LINK 0

/**
 * Node `element` and its neighbours in the directions of the mask: east 1, south 2, west 4, north
 * 8, round the sides of the net.
 */
#define GUSSET_GLUING_STAR 1

/**
 * The ends of the links of cell `element` that are in the mask: top 1, right 2, bottom 4, left 8.
 * Cell (i, j) is i * (columns - 1) + j.
 */
#define GUSSET_GLUING_CELL 2

/**
 * Opposite corners of cell `element`: mask 1 for the first and the third, 2 for the second and the
 * fourth.
 */
#define GUSSET_GLUING_DIAGONAL 3

/**
 * The two runs of nodes of the seam.
 */
#define GUSSET_GLUING_SEAM 4

/**
 * The local gluing of type `mask`, one of GUSSET_TYPE_..., at node `element`; at cell `element`
 * from GUSSET_TYPE_TOP_BOTTOM on.
 */
#define GUSSET_GLUING_TYPE 5

/**
 * Nothing is glued here.
 */
#define GUSSET_TYPE_NONE 4294967295

/**
 * n(1): one horizontal link.
 */
#define GUSSET_TYPE_HORIZONTAL 0

/**
 * n(1): one vertical link.
 */
#define GUSSET_TYPE_VERTICAL 1

/**
 * n(2,1): the links of a node to the east and the south.
 */
#define GUSSET_TYPE_EAST_SOUTH 2

/**
 * n(2,1): south and west.
 */
#define GUSSET_TYPE_SOUTH_WEST 3

/**
 * n(2,1): west and north.
 */
#define GUSSET_TYPE_WEST_NORTH 4

/**
 * n(2,1): north and east.
 */
#define GUSSET_TYPE_NORTH_EAST 5

/**
 * n(2,2): east and west.
 */
#define GUSSET_TYPE_EAST_WEST 6

/**
 * n(2,2): north and south.
 */
#define GUSSET_TYPE_NORTH_SOUTH 7

/**
 * n(3): all but north.
 */
#define GUSSET_TYPE_BUT_NORTH 8

/**
 * n(3): all but east.
 */
#define GUSSET_TYPE_BUT_EAST 9

/**
 * n(3): all but south.
 */
#define GUSSET_TYPE_BUT_SOUTH 10

/**
 * n(3): all but west.
 */
#define GUSSET_TYPE_BUT_WEST 11

/**
 * n(4): all four links of a node.
 */
#define GUSSET_TYPE_ALL 12

/**
 * c(2,1): top and bottom of a cell.
 */
#define GUSSET_TYPE_TOP_BOTTOM 13

/**
 * c(2,1): right and left of a cell.
 */
#define GUSSET_TYPE_RIGHT_LEFT 14

/**
 * c(3): a cell is one point.
 */
#define GUSSET_TYPE_POINT 15

/**
 * c(1,2): the first and the third corner of a cell.
 */
#define GUSSET_TYPE_FALLING 16

/**
 * c(1,2): the second and the fourth corner of a cell.
 */
#define GUSSET_TYPE_RISING 17

/**
 * Every row is closed: its last node is its first one again.
 */
#define GUSSET_SIDES_ROWS_CLOSED 1

/**
 * Every column is closed.
 */
#define GUSSET_SIDES_COLUMNS_CLOSED 2

/**
 * The first row is one point.
 */
#define GUSSET_SIDES_POLE_TOP 4

/**
 * The last row is one point.
 */
#define GUSSET_SIDES_POLE_BOTTOM 8

/**
 * The first column is one point.
 */
#define GUSSET_SIDES_POLE_LEFT 16

/**
 * The last column is one point.
 */
#define GUSSET_SIDES_POLE_RIGHT 32

/**
 * Open on all sides.
 */
#define GUSSET_SIDES_SHEET 0

/**
 * Rows closed; the first and the last row are rims.
 */
#define GUSSET_SIDES_TUBE 1

/**
 * Rows closed, the first and the last a point each: spheres, and cylinders, prisms, cones and
 * pyramids with their caps.
 */
#define GUSSET_SIDES_TWO_POLES 13

/**
 * All four sides are one point: a disc whose rim is drawn together.
 */
#define GUSSET_SIDES_ONE_POLE 60

/**
 * Rows and columns closed.
 */
#define GUSSET_SIDES_TORUS 3

/**
 * They are cells like others.
 */
#define GUSSET_BRIDGE_KEEP 0

/**
 * They are not there.
 */
#define GUSSET_BRIDGE_HIDE 1

/**
 * The two sides coincide, to a tolerance, and are one: the links between them are contracted.
 * Nodes stay where they are; where they coincide not quite, `snap` of gusset_glue_options makes
 * them equal.
 */
#define GUSSET_BRIDGE_WELD 2

/**
 * A band between open sides.
 */
#define GUSSET_BRIDGE_RIBBON 0

/**
 * A band between closed sides, which is closed itself.
 */
#define GUSSET_BRIDGE_TUBE 1

/**
 * One edge between sides that are a point each.
 */
#define GUSSET_BRIDGE_THREAD 2

/**
 * area, volume, area_vector, low and high.
 */
#define GUSSET_NET_MEASURES_EXTENT 1

/**
 * bilinear_area and bilinear_error; about ten times the work.
 */
#define GUSSET_NET_MEASURES_BILINEAR 2

/**
 * body_volume, centroid and inertia; about ten times the work.
 */
#define GUSSET_NET_MEASURES_BODY 4

/**
 * Quads, and triangles where a side of a cell is one point.
 */
#define GUSSET_NET_QUADS 0

/**
 * Triangles: quads are cut along the shorter diagonal, or where that would be an edge that there
 * is already, the other one.
 */
#define GUSSET_NET_TRIANGLES_SHORTER 1

/**
 * Triangles: quads are cut from (i, j) to (i + 1, j + 1), with the same exception.
 */
#define GUSSET_NET_TRIANGLES_FIXED 2

/**
 * Each is a quad, or a triangle of a fan round a pole.
 */
#define GUSSET_GRID_CELLS_QUADS 0

/**
 * Each is two triangles, a quad cut along either diagonal, or a triangle of a fan round a pole.
 */
#define GUSSET_GRID_CELLS_TRIANGLES 1

/**
 * Straight.
 */
#define GUSSET_MORPH_LINEAR 0

/**
 * The rotation that fits best is done evenly; the rest goes straight in the frame that turns, so
 * that a net moved rigidly keeps its shape on the way.
 */
#define GUSSET_MORPH_RIGID 1

/**
 * A rectangle in the plane z = 0: size[0], size[1].
 */
#define GUSSET_NET_PLANE 0

/**
 * A sphere with two poles: radius. At least 3 rows and 4 columns.
 */
#define GUSSET_NET_SPHERE 1

/**
 * A sphere that is a disc whose rim is drawn together: radius. At least 3 rows and columns.
 */
#define GUSSET_NET_ONE_POLE_SPHERE 2

/**
 * A cylinder without caps: radius, height. At least 4 columns.
 */
#define GUSSET_NET_TUBE 3

/**
 * A cylinder with caps: radius, height. At least 4 rows and columns.
 */
#define GUSSET_NET_CYLINDER 4

/**
 * A prism over a regular polygon: sides, radius (of the circle through its corners), height. At
 * least 4 rows, and a column more than sides.
 */
#define GUSSET_NET_PRISM 5

/**
 * A cone with its base: radius, height. At least 3 rows and 4 columns.
 */
#define GUSSET_NET_CONE 6

/**
 * A pyramid over a regular polygon: sides, radius, height. At least 3 rows, and a column more than
 * sides.
 */
#define GUSSET_NET_PYRAMID 7

/**
 * A profile turned round the z axis: profile, profile_count. At least 4 columns; each point is a
 * row.
 */
#define GUSSET_NET_LATHE 8

/**
 * A torus: radius, minor_radius (of the tube, the smaller). At least 4 rows and columns.
 */
#define GUSSET_NET_TORUS 9

/**
 * A box: size, cells, box_kind. Rows and columns are as the cells say.
 */
#define GUSSET_NET_BOX 10

/**
 * A Moebius strip: radius (of its middle line), size[0] (its width). At least 4 columns.
 */
#define GUSSET_NET_MOEBIUS 11

/**
 * A Klein bottle, a tube with a figure-eight section that makes half a turn: radius, minor_radius.
 * At least 4 rows and columns.
 */
#define GUSSET_NET_KLEIN 12

/**
 * A projective plane, Boy's surface: radius (a scale). At least 4 rows and columns.
 */
#define GUSSET_NET_PROJECTIVE_PLANE 13

/**
 * Two sheets joined along their rim: size[0], size[1], height (their distance in the middle). At
 * least 3 rows, and 5, 7, ... columns.
 */
#define GUSSET_NET_PILLOW 14

/**
 * Two rims of the cap sweep over it to a slit, which is zipped up. All faces are unit quads, and
 * no seams are needed.
 */
#define GUSSET_NET_BOX_SLIT 0

/**
 * The paper's crosswise unwrapping. All faces are unit quads; two seams.
 */
#define GUSSET_NET_BOX_CROSS 1

/**
 * Concentric rings: fewest nodes, and triangles along the diagonals of the caps.
 */
#define GUSSET_NET_BOX_CONCENTRIC 2

/**
 * On cubic splines after Catmull and Rom, which pass through all nodes with one tangent, across
 * seams too.
 */
#define GUSSET_INTERPOLATION_BICUBIC 0

/**
 * On the bilinear patches of the cells.
 */
#define GUSSET_INTERPOLATION_BILINEAR 1

/**
 * A net.
 */
#define GUSSET_SCENE_NET 0

/**
 * A group of entries.
 */
#define GUSSET_SCENE_GROUP 1

/**
 * It stays as it is.
 */
#define GUSSET_VISIBILITY_KEEP 0

/**
 * The entry is shown.
 */
#define GUSSET_VISIBILITY_SHOW 1

/**
 * The entry is hidden, with all that is in it.
 */
#define GUSSET_VISIBILITY_HIDE 2

/**
 * Rounded to some number of bits, and compressed.
 */
#define GUSSET_STREAM_QUANTISED 0

/**
 * Compressed, bit for bit, NaN too.
 */
#define GUSSET_STREAM_LOSSLESS 1

/**
 * As they are: little-endian matrices that begin at multiples of 64 bytes, for files that are
 * mapped into memory.
 */
#define GUSSET_STREAM_RAW 2

/**
 * The abscissa.
 */
#define GUSSET_AXIS_X 0

/**
 * The ordinate.
 */
#define GUSSET_AXIS_Y 1

/**
 * The applicate.
 */
#define GUSSET_AXIS_Z 2

/**
 * Moves by the vector values[0] to values[2].
 */
#define GUSSET_OPERATION_TRANSLATE 1

/**
 * Turns about the axis with the direction values[0] to values[2], of any length but 0, by
 * values[3] radians, by the right hand; the axis passes through the point values[4] to values[6].
 */
#define GUSSET_OPERATION_ROTATE 2

/**
 * The same by the left hand, as Deryagin's formula is printed.
 */
#define GUSSET_OPERATION_ROTATE_AS_PRINTED 3

/**
 * Scales about the origin: values[0] is the ratio of new distance to old.
 */
#define GUSSET_OPERATION_SCALE 4

/**
 * Scales about the axis of coordinates `axis`, which stays: values[0] is the ratio of new distance
 * to old.
 */
#define GUSSET_OPERATION_COMPRESS 5

/**
 * Scales x, y and z by values[0], values[1] and values[2].
 */
#define GUSSET_OPERATION_STRETCH 6

/**
 * Any affine map: three rows of four numbers, the fourth of each the displacement.
 */
#define GUSSET_OPERATION_MATRIX 7

/**
 * A violation: the ends of contracted link `element` are apart, or one of them is missing.
 */
#define GUSSET_NET_FINDING_LINK_APART 0

/**
 * A violation: two nodes that seam `element` glues are apart, or one of them is missing.
 */
#define GUSSET_NET_FINDING_SEAM_APART 1

/**
 * A warning: the ends of link `element`, between neighbours, are one point by way of others, and
 * it is not contracted itself: see `saturate` of gusset_glue_options.
 */
#define GUSSET_NET_FINDING_LOOP 2

/**
 * A warning: the ends of link `element` lie on each other and are not glued.
 */
#define GUSSET_NET_FINDING_ZERO_LENGTH 3

/**
 * A warning: link `element` closes a row or column of fewer than four nodes, which has no inside
 * then.
 */
#define GUSSET_NET_FINDING_FEW_NODES 4

/**
 * The report's index means nothing.
 */
#define GUSSET_ELEMENT_NONE 0

/**
 * A vertex of the input mesh.
 */
#define GUSSET_ELEMENT_VERTEX 1

/**
 * A face of the input mesh.
 */
#define GUSSET_ELEMENT_FACE 2

/**
 * A half-edge: a position in face_corners.
 */
#define GUSSET_ELEMENT_HALF_EDGE 3

/**
 * An entry of face_offsets.
 */
#define GUSSET_ELEMENT_OFFSET 4

/**
 * A place in the loop given; the report's input is the number of the loop.
 */
#define GUSSET_ELEMENT_LOOP_PLACE 5

/**
 * A count of elements or bytes.
 */
#define GUSSET_ELEMENT_COUNT 6

/**
 * A point of an outline or a curve, counted over all outlines.
 */
#define GUSSET_ELEMENT_POINT 7

/**
 * A constraint on an outline: its place, or its tangent.
 */
#define GUSSET_ELEMENT_CONSTRAINT 8

/**
 * One of the places on a curve or a surface that were given.
 */
#define GUSSET_ELEMENT_PLACE 9

/**
 * A section of a frame, or a plane, counted from 0; the value is the column or the number of
 * points.
 */
#define GUSSET_ELEMENT_SECTION 12

/**
 * A node of a net, row after row.
 */
#define GUSSET_ELEMENT_NODE 13

/**
 * A link of a net: twice its first node, and 1 if it is vertical.
 */
#define GUSSET_ELEMENT_LINK 14

/**
 * A cell of a net, row after row.
 */
#define GUSSET_ELEMENT_CELL 15

/**
 * One of the seams given.
 */
#define GUSSET_ELEMENT_SEAM 16

/**
 * A bridge of a net.
 */
#define GUSSET_ELEMENT_BRIDGE 17

/**
 * An entry of a scene.
 */
#define GUSSET_ELEMENT_ENTRY 18

/**
 * A byte of a stream.
 */
#define GUSSET_ELEMENT_BYTE 19

/**
 * One of the operations, fields, gluings, lines, loops, pairs, pieces, sheets or curves that were
 * given.
 */
#define GUSSET_ELEMENT_ITEM 21

/**
 * A place along the side of a net; the value is a distance.
 */
#define GUSSET_ELEMENT_SIDE_PLACE 20

/**
 * A knot of a spline, in u or in v as the message says.
 */
#define GUSSET_ELEMENT_KNOT 30

/**
 * A row of a net of curves; the message has the column, the value is how far they are apart.
 */
#define GUSSET_ELEMENT_ROW 31

/**
 * An edge of a winged-edge table.
 */
#define GUSSET_ELEMENT_EDGE 32

/**
 * Two surfaces touch in a point: all round it they are apart, or overlap by no more than the
 * tolerance.
 */
#define GUSSET_CONTACT_POINT 1

/**
 * Two branches of an intersection cross in a point, or pass it within the tolerance.
 */
#define GUSSET_CONTACT_CROSSING 2

/**
 * As many points of the surface as keep the chords within 1e-4 of the diagonal of the surface's
 * box.
 */
#define GUSSET_POINT_SPACING_AUTO 0

/**
 * As many points of the surface as keep the chords within `chord`, as the middle and the quarters of
 * the curve beside each show; where nodes are far apart for that length, it may be more elsewhere.
 */
#define GUSSET_POINT_SPACING_CHORD 1

/**
 * Nothing.
 */
#define GUSSET_POINT_SPACING_CELL_EDGES 2

/**
 * `points` points of the paper's approximation: on the cubic through four crossings. They are near
 * the surface, not on it, and have the place of the crossing before them. Order four where
 * crossings are evenly spaced.
 */
#define GUSSET_POINT_SPACING_LEUS 3

/**
 * The distance from the plane through `point` across `direction`, negative below it. Its contours
 * are sections of the surface by parallel planes.
 */
#define GUSSET_CONTOUR_HEIGHT 0

/**
 * The values at the corners of the cells, interpolated as the surface is.
 */
#define GUSSET_CONTOUR_VALUES 1

/**
 * The angle between the normal and `direction`, in radians. Its contours are isophotes; at pi / 2
 * they are the silhouettes of the surface seen along the direction.
 */
#define GUSSET_CONTOUR_ANGLE 2

/**
 * Along rows: u stays and v runs.
 */
#define GUSSET_ALONG_ROWS 0

/**
 * Along columns: v stays and u runs.
 */
#define GUSSET_ALONG_COLUMNS 1

/**
 * The line, ray or segment `line`.
 */
#define GUSSET_TARGET_LINE 0

/**
 * The plane through `point` across `normal`.
 */
#define GUSSET_TARGET_PLANE 1

/**
 * The curve in space `curve`.
 */
#define GUSSET_TARGET_CURVE 2

/**
 * The surface `surface`.
 */
#define GUSSET_TARGET_SURFACE 3

/**
 * The distance is proved: bound is within the tolerance of it, or within 2^-45 of the greatest
 * coordinate. Not set: the proof would take too long, as where much of the surface is equally near.
 * `bound` is right nevertheless.
 */
#define GUSSET_DISTANCE_PROVEN 1

/**
 * The two meet at the points, except for rounding, and the distance is 0.
 */
#define GUSSET_DISTANCE_MEETS 2

/**
 * There is no normal: the tangents are 0, or parallel all along the lines to the point.
 */
#define GUSSET_NORMAL_NONE 0

/**
 * The normal of the plane that the tangents span.
 */
#define GUSSET_NORMAL_REGULAR 1

/**
 * The limit along the coordinate line, where the tangents do not span a plane: at poles.
 */
#define GUSSET_NORMAL_LIMIT 2

/**
 * All, in the order of the line.
 */
#define GUSSET_HITS_ALL 0

/**
 * The first one.
 */
#define GUSSET_HITS_FIRST 1

/**
 * Any one: whether there is one.
 */
#define GUSSET_HITS_ANY 2

/**
 * None.
 */
#define GUSSET_HIT_NONE 0

/**
 * It passes through the surface: proved, but for poles, where the surface is not regular.
 */
#define GUSSET_HIT_CROSSING 1

/**
 * It touches the surface within the tolerance: one point, two close to each other, or none.
 */
#define GUSSET_HIT_TOUCH 2

/**
 * It runs in the surface, within the tolerance, all over the span.
 */
#define GUSSET_HIT_INSIDE 3

/**
 * There is a point; else nothing is within the limit, all numbers are 0 and the distance is
 * infinite.
 */
#define GUSSET_NEAREST_FOUND 1

/**
 * The distance is proved: bound is within the tolerance of it, or within the rounding of
 * coordinates. Not set: the proof would take too long, as it may next to a centre of curvature.
 * `bound` is right nevertheless.
 */
#define GUSSET_NEAREST_PROVEN 2

/**
 * Another point, farther from this one than a hundredth of the distance, is as near within the
 * tolerance.
 */
#define GUSSET_NEAREST_AMBIGUOUS 4

/**
 * The point.
 */
#define GUSSET_REFERENCE_POINT 0

/**
 * The plane through the point, across the direction.
 */
#define GUSSET_REFERENCE_PLANE 1

/**
 * The line through the point, along the direction.
 */
#define GUSSET_REFERENCE_LINE 2

/**
 * The segment from the point to the point and the direction.
 */
#define GUSSET_REFERENCE_SEGMENT 3

/**
 * Normals at an angle to the direction; distances are deviations from the angle, in radians.
 */
#define GUSSET_REFERENCE_ANGLE 4

/**
 * The curve.
 */
#define GUSSET_REFERENCE_CURVE 5

/**
 * The surface.
 */
#define GUSSET_REFERENCE_SURFACE 6

/**
 * The ray from the point along the direction.
 */
#define GUSSET_REFERENCE_RAY 7

/**
 * Bicubic with continuous tangents, from the 6 x 6 nodes round a cell: fourth order, with the
 * constant 1/384.
 */
#define GUSSET_SCHEME_SIX_TAP 0

/**
 * The paper's: the bicubic through the 4 x 4 nodes round a cell; fourth order with the constant
 * 3/128, tangents jump at nodes.
 */
#define GUSSET_SCHEME_FOUR_POINT 1

/**
 * From differences of the tangents over five nodes: fourth order.
 */
#define GUSSET_TWISTS_DIFFERENCES 0

/**
 * Adini's: from the nodes next to each.
 */
#define GUSSET_TWISTS_ADINI 1

/**
 * None: flat spots at nodes.
 */
#define GUSSET_TWISTS_ZERO 2

/**
 * They are given.
 */
#define GUSSET_TWISTS_GIVEN 3

/**
 * The surface through the nodes of a frame; the surface of its curves if some of them have corners,
 * which would be rounded.
 */
#define GUSSET_FRAME_NODES 0

/**
 * Gordon's surface of the curves of a frame, which contains them.
 */
#define GUSSET_FRAME_CURVES 1

/**
 * `diameter` and `intrinsic_diameter`.
 */
#define GUSSET_SHEET_MEASURE_DIAMETERS 1

/**
 * `curvature_bound`.
 */
#define GUSSET_SHEET_MEASURE_CURVATURE 2

/**
 * `crease`.
 */
#define GUSSET_SHEET_MEASURE_CREASE 4

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * Creates a context with automatic threads and no callbacks.
 *
 * @param[out] context receives it, for gusset_context_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API GUSSET_MUST_USE gusset_status gusset_context_create(struct gusset_context **context);

/**
 * Destroys a context; NULL is allowed.
 *
 * No call may be using it.
 *
 * @param[in,out] context the context.
 * @since 0.1
 */
GUSSET_API void gusset_context_destroy(struct gusset_context *context);

/**
 * Sets the number of threads, on which results do not depend.
 *
 * @param[in,out] context the context.
 * @param threads 0 as many as the machine has, 1 the calling thread only.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, CONTEXT_BUSY.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API gusset_status gusset_context_set_threads(struct gusset_context *context, uint32_t threads);

/**
 * Sets the progress callback.
 *
 * @param[in,out] context the context.
 * @param progress NULL for none.
 * @param user handed to it, and not looked at.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, CONTEXT_BUSY.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
gusset_status gusset_context_set_progress(struct gusset_context *context,
                                          gusset_progress_fn progress,
                                          void *user);

/**
 * Sets the log callback.
 *
 * @param[in,out] context the context.
 * @param log NULL for none.
 * @param user handed to it, and not looked at.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, CONTEXT_BUSY.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API gusset_status gusset_context_set_log(struct gusset_context *context, gusset_log_fn log, void *user);

/**
 * Cancels the running call, and every later one until gusset_context_reset.
 *
 * @param context the context.
 * @complexity O(1).
 * @threads From any thread; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_context_cancel(const struct gusset_context *context);

/**
 * Takes a cancel back.
 *
 * NULL is allowed.
 *
 * @param context the context.
 * @complexity O(1).
 * @threads From any thread.
 * @since 0.1
 */
GUSSET_API void gusset_context_reset(const struct gusset_context *context);

/**
 * How much of the running (or last) call is done, 0 to 1; 0 for NULL.
 *
 * @param context the context.
 * @return 0 to 1; 0 for NULL.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API double gusset_context_get_progress(const struct gusset_context *context);

/**
 * What went wrong in the last call with this context, as an English sentence; empty after a
 * success.
 *
 * Never NULL. Valid until the next call with the context. Empty too for NULL, and while a call is
 * running.
 *
 * @param context the context.
 * @return a NUL-terminated UTF-8 string, never NULL.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API const char *gusset_context_get_message(const struct gusset_context *context);

/**
 * What went wrong in the last call with this context, as numbers.
 *
 * @param context the context.
 * @param[out] report receives the report; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     CONTEXT_BUSY.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
gusset_status gusset_context_get_report(const struct gusset_context *context,
                                        struct gusset_error_report *report);

/**
 * Makes a curve from its control points.
 *
 * Degrees are 1 to 64; coordinates any finite numbers.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param points x, y of each control point, or x, y, z, packed.
 * @param point_count at most 2^30; 0 for a curve without segments, whose ends are 0 alone.
 * @param dimension 2 or 3.
 * @param ends 0, then the place of the last control point of each segment, rising; the last is
 *     point_count - 1.
 * @param end_count the number of segments and 1.
 * @param closed 1 if the last control point is the first one again, else 0.
 * @param[out] curve receives the copy, for gusset_curve_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: MISALIGNED_ARGUMENT, NULL_ARGUMENT, BAD_OFFSETS, OUT_OF_RANGE
 *     (dimension, degree), NOT_FINITE, CURVE_NOT_CLOSED, UNKNOWN_VALUE, TOO_LARGE, SIZE_OVERFLOW,
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity O(points).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_create(const struct gusset_context *context,
                                  const double *points,
                                  size_t point_count,
                                  uint32_t dimension,
                                  const uint32_t *ends,
                                  size_t end_count,
                                  uint32_t closed,
                                  struct gusset_curve **curve);

/**
 * Destroys a curve; NULL is allowed.
 *
 * @param[in,out] curve the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_curve_destroy(struct gusset_curve *curve);

/**
 * Lends the control points, valid until the curve is destroyed.
 *
 * @param curve the curve.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_get_view(const struct gusset_curve *curve,
                                    struct gusset_curve_view *parts);

/**
 * The part of a curve from one place to another, open.
 *
 * On a closed curve it may run over the start, and from a place to itself it goes round once.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param from where it begins.
 * @param to where it ends.
 * @param[out] part receives the result, for gusset_curve_destroy, as for all functions of this
 *     group; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NO_SUCH_ELEMENT (place 0 is
 *     from, 1 is to), OUT_OF_RANGE (an open curve, and to before from), UNKNOWN_VALUE, TOO_LARGE,
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity O(points).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_part_create(const struct gusset_context *context,
                                       const struct gusset_curve *curve,
                                       struct gusset_place from,
                                       struct gusset_place to,
                                       struct gusset_curve **part);

/**
 * The part of a curve before a place, or the part after it; both are open.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param at the place.
 * @param after 0 for the part before it, 1 for the part after it.
 * @param[out] part receives the result, for gusset_curve_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_curve_part_create.
 * @complexity O(points).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_split_create(const struct gusset_context *context,
                                        const struct gusset_curve *curve,
                                        struct gusset_place at,
                                        uint32_t after,
                                        struct gusset_curve **part);

/**
 * The same curve run through from its end to its start.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param[out] reversed receives the result, for gusset_curve_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(points).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_reverse_create(const struct gusset_context *context,
                                          const struct gusset_curve *curve,
                                          struct gusset_curve **reversed);

/**
 * The same curve with higher degrees: every segment's raised by `by`, or if `by` is 0 those below
 * `to` raised to it.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param by how much each segment is raised, or 0.
 * @param to if `by` is 0: the degree, 1 to 64.
 * @param[out] elevated receives the result, for gusset_curve_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_RANGE (a degree above
 *     64, or to is 0), TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(degree) for each new control point.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_elevate_create(const struct gusset_context *context,
                                          const struct gusset_curve *curve,
                                          uint32_t by,
                                          uint32_t to,
                                          struct gusset_curve **elevated);

/**
 * The curve with segments of a lower degree, by least squares with fixed ends.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param degree of each at most, 1 to 64.
 * @param tolerance segments that would deviate by more are kept; at least 0, in the unit of the
 *     points; infinity is allowed.
 * @param[out] deviations receives a bound on the deviation of each segment from the original, of a
 *     kept one what it would have been; NULL if it is not wanted.
 * @param[out] reduced receives the result, for gusset_curve_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_RANGE (degree,
 *     tolerance), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(degree^3) a segment.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_reduce_create(const struct gusset_context *context,
                                         const struct gusset_curve *curve,
                                         uint32_t degree,
                                         double tolerance,
                                         double *deviations,
                                         struct gusset_curve **reduced);

/**
 * The curve beside a plane curve, re-fitted by segments with common tangents.
 *
 * Places where it crosses itself are not removed.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param distance how far to the left of it, to the right if negative; in the unit of the points,
 *     finite.
 * @param options its tolerance must be given.
 * @param[out] report what became of it; NULL if it is not wanted.
 * @param[out] offset receives the result, for gusset_curve_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE, CURVE_NOT_PLANE, EMPTY_CURVE, OUT_OF_RANGE (distance, tolerance, degree),
 *     TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(degree) for each of the places measured.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_offset_create(const struct gusset_context *context,
                                         const struct gusset_curve *curve,
                                         double distance,
                                         const struct gusset_offset_options *options,
                                         struct gusset_offset_report *report,
                                         struct gusset_curve **offset);

/**
 * The data of an SVG path, of M, L, Q, C and Z; numbers read back as the same bits, and y is not
 * turned over.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param[out] form receives the result, for gusset_curve_form_destroy, as for all functions of
 *     this group; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, CURVE_NOT_PLANE,
 *     OUT_OF_RANGE (a degree above 3: see gusset_curve_reduce_create), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(points).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_svg_create(const struct gusset_context *context,
                                      const struct gusset_curve *curve,
                                      struct gusset_curve_form **form);

/**
 * The contour of a TrueType font: control points, and those joints that are not in the middle
 * between two of them.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param tolerance how far from the middle still counts as there, at least 0, in the unit of the
 *     points; rounding always does.
 * @param[out] form receives the result, for gusset_curve_form_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, CURVE_NOT_PLANE,
 *     CURVE_NOT_CLOSED, EMPTY_CURVE, OUT_OF_RANGE (a degree above 2, tolerance), OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(points).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_contour_create(const struct gusset_context *context,
                                          const struct gusset_curve *curve,
                                          double tolerance,
                                          struct gusset_curve_form **form);

/**
 * The curve as a clamped B-spline, if all segments have one degree n.
 *
 * Joints with one tangent become knots of multiplicity n - 1 and are no control points.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param[out] form receives the result, for gusset_curve_form_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, EMPTY_CURVE, OUT_OF_RANGE
 *     (other degrees), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(points).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_spline_create(const struct gusset_context *context,
                                         const struct gusset_curve *curve,
                                         struct gusset_curve_form **form);

/**
 * Destroys a form; NULL is allowed.
 *
 * @param[in,out] form the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_curve_form_destroy(struct gusset_curve_form *form);

/**
 * Lends the parts.
 *
 * @param form the form.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_form_get_view(const struct gusset_curve_form *form,
                                         struct gusset_curve_form_view *parts);

/**
 * Makes the frame of some sections, closed or open, one behind another: a grid of nodes, a curve
 * across through each row of it, and a curve along through each column.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param sections at least 2, 3 of a ring.
 * @param options NULL for the defaults.
 * @param[out] frame receives the result, for gusset_frame_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_outline_create, OUT_OF_RANGE (too few sections
 *     or columns; landmarks that are not as many for each section, or not in order; an axis
 *     without direction, or points of it that are not as many as sections; missing points of
 *     another correspondence than GIVEN), NO_SUCH_ELEMENT (a missing point), SECTIONS_DIFFER,
 *     NO_NODE (a section that a half-plane does not meet, or that is no curve; with the section
 *     and the column, a missing node with none before it, or none behind, in its column).
 * @complexity O(points), with ANGLE O(columns x points); with corners O(n^3) a section for n <= 128
 *     of them, none are shared by sections with more.
 * @source Nadopta, introduction; the correspondences are ours.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_frame_create(const struct gusset_context *context,
                                  const struct gusset_outlines *sections,
                                  const struct gusset_frame_options *options,
                                  struct gusset_frame **frame);

/**
 * Makes the frame beside a frame: room for comfort round a body, more in some places than in
 * others.
 *
 * Each node moves by its distance: outwards, if sections are closed, inwards if it is negative; of
 * open sections along the derivative from section to section crossed with that along them, or,
 * within sections, away from the chord between their ends. Directions come from circles through
 * neighbouring nodes, so that planes, round cylinders with sections square to their axes, and
 * spheres become such, exactly. Curves are drawn through the new nodes as through the old ones. Nodes where
 * nothing tells a direction stay.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param frame may be destroyed afterwards.
 * @param distances in the unit of the points, finite.
 * @param distance_count 1: all nodes move by the same; the number of rows: each section by its own;
 *     rows x columns: each node by its own, row by row.
 * @param direction GUSSET_OFFSET_NORMAL or GUSSET_OFFSET_IN_SECTION.
 * @param[out] offset receives the result, for gusset_frame_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE,
 *     COUNT_DIFFERS (distances), NOT_FINITE (the index is the distance's), those of
 *     gusset_frame_create for the new nodes.
 * @complexity O(nodes), and that of the curves.
 * @source Nadopta, introduction, for the aim; the directions are ours.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_frame_offset_create(const struct gusset_context *context,
                                         const struct gusset_frame *frame,
                                         const double *distances,
                                         size_t distance_count,
                                         uint32_t direction,
                                         struct gusset_frame **offset);

/**
 * Destroys what gusset_frame_create or gusset_frame_offset_create made; NULL is allowed.
 *
 * @param[in,out] frame the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_frame_destroy(struct gusset_frame *frame);

/**
 * Lends the nodes, valid until the frame is destroyed.
 *
 * @param frame the frame.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_frame_get_view(const struct gusset_frame *frame,
                                    struct gusset_frame_view *parts);

/**
 * Lends the curves: across (one for each section; node i of row k is point k W + i) and along (one
 * for each column; node i of row k is point i H + k), for H rows of W columns.
 *
 * Not to be destroyed: valid until the frame is. Either may be NULL.
 *
 * @param frame the frame.
 * @param[out] across receives the curves across; NULL on failure.
 * @param[out] along receives the curves along; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_frame_get_curves(const struct gusset_frame *frame,
                                      const struct gusset_outline **across,
                                      const struct gusset_outline **along);

/**
 * Cuts the curves along by the plane through a point across a normal, and draws a curve through
 * the crossings as the curves across were made: a new section.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param frame the frame.
 * @param point x, y, z.
 * @param normal x, y, z, of any length but 0.
 * @param[out] section receives one outline, for gusset_outline_destroy; NULL on failure; point i
 *     of it is on the curve along column i, at its first crossing.
 * @return GUSSET_OK, or an error: those of gusset_outline_create, OUT_OF_RANGE (the normal),
 *     NOT_FINITE, NO_NODE (the value in the report is the column that the plane does not cross).
 * @complexity O(segments).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_frame_slice_create(const struct gusset_context *context,
                                        const struct gusset_frame *frame,
                                        const double *point,
                                        const double *normal,
                                        struct gusset_outline **section);

/**
 * Measures curve `index` of an outline: girth, area and centre.
 *
 * @param outline the outline.
 * @param index its number, from 0.
 * @param[out] measure receives them.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NO_SUCH_ELEMENT,
 *     OUT_OF_MEMORY.
 * @complexity O(segments).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_outline_measure(const struct gusset_outline *outline,
                                     size_t index,
                                     struct gusset_section_report *measure);

/**
 * Where a curve crosses or touches a plane.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param point x, y, z of a point of the plane.
 * @param normal x, y, z across it, of any length but 0.
 * @param[out] places receives the result, for gusset_places_destroy, as for all functions of this
 *     group; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_RANGE (normal),
 *     NOT_FINITE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(points), and O(degree^2) a crossing.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_intersect_plane_create(const struct gusset_context *context,
                                                  const struct gusset_curve *curve,
                                                  const double *point,
                                                  const double *normal,
                                                  struct gusset_places **places);

/**
 * Where a plane curve crosses or touches a line.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param point x, y of a point of the line.
 * @param direction x, y along it, not 0.
 * @param[out] places receives the result, for gusset_places_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: CURVE_NOT_PLANE, and those of
 *     gusset_curve_intersect_plane_create.
 * @complexity O(points), and O(degree^2) a crossing.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_intersect_line_create(const struct gusset_context *context,
                                                 const struct gusset_curve *curve,
                                                 const double *point,
                                                 const double *direction,
                                                 struct gusset_places **places);

/**
 * The common points and parts of two plane curves, or, if other is NULL, of one with itself: then
 * joints of neighbours do not count.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param other the other curve.
 * @param[out] places receives the result, for gusset_places_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, CURVE_NOT_PLANE,
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity Bounded work for each pair of segments whose boxes meet.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_intersect_create(const struct gusset_context *context,
                                            const struct gusset_curve *curve,
                                            const struct gusset_curve *other,
                                            struct gusset_places **places);

/**
 * The points of a curve whose tangents make a given angle with a direction: all of them, each
 * once.
 *
 * At a cusp, where the derivative is 0, the tangents before and after it count, to 1e-6; at a joint
 * those of both segments, but not those between. Angles within 1e-7 of 0, pi / 2 and pi are taken
 * for these; tangents count as along the direction, or against it, to 1e-9.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve, of any dimension and degree.
 * @param direction x, y, z, of any length but 0, packed.
 * @param angle 0 to pi.
 * @param[out] places receives the places; overlaps are parts all of whose tangents make the angle,
 *     as those of straight segments: where each begins and ends, twice. NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_RANGE (direction,
 *     angle), NOT_FINITE (direction), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(points), and O(degree^2) for each place.
 * @source Leus, "Carcasses on smooth surfaces", task b, for curves.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_tangent_angle_create(const struct gusset_context *context,
                                                const struct gusset_curve *curve,
                                                const double *direction,
                                                double angle,
                                                struct gusset_places **places);

/**
 * Points along a curve, in its order; of a closed curve the start is not repeated at the end.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param rule GUSSET_SAMPLE_...
 * @param amount a whole number (at least 1, for an open curve 2), or a length above 0.
 * @param[out] places receives the result, for gusset_places_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE, EMPTY_CURVE,
 *     OUT_OF_RANGE (amount), TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(points, and samples).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_sample_create(const struct gusset_context *context,
                                         const struct gusset_curve *curve,
                                         uint32_t rule,
                                         double amount,
                                         struct gusset_places **places);

/**
 * Destroys what was found; NULL is allowed.
 *
 * @param[in,out] places the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_places_destroy(struct gusset_places *places);

/**
 * Lends what was found.
 *
 * @param places the places.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_places_get_view(const struct gusset_places *places,
                                     struct gusset_places_view *view);

/**
 * Points and derivatives at many places.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param places count of them, at least 0.
 * @param count see places.
 * @param order 0 for the points alone, at most 64.
 * @param[out] out receives 3 (order + 1) count numbers: for each place x, y, z of the point, then
 *     of the first derivative by t, and so on; 0 beyond the degree.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NO_SUCH_ELEMENT (a place),
 *     OUT_OF_RANGE (order), UNKNOWN_VALUE, SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(degree^2) a place.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_derivatives(const struct gusset_context *context,
                                       const struct gusset_curve *curve,
                                       const struct gusset_place *places,
                                       size_t count,
                                       uint32_t order,
                                       double *out);

/**
 * The directions at many places, of length 1; 0 on a segment without extent.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param places count of them, at any alignment.
 * @param count see places.
 * @param[out] out receives 3 count numbers.
 * @return GUSSET_OK, or an error: those of gusset_curve_derivatives.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_tangents(const struct gusset_context *context,
                                    const struct gusset_curve *curve,
                                    const struct gusset_place *places,
                                    size_t count,
                                    double *out);

/**
 * The curvatures at many places, 1 over the radius: on a plane segment positive where it turns
 * from x to y; infinite where the first derivative is 0.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param places count of them, at any alignment.
 * @param count see places.
 * @param[out] out receives count numbers.
 * @return GUSSET_OK, or an error: those of gusset_curve_derivatives.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_curvatures(const struct gusset_context *context,
                                      const struct gusset_curve *curve,
                                      const struct gusset_place *places,
                                      size_t count,
                                      double *out);

/**
 * The nearest points of a curve to many points.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param points x, y, z of each, packed, count of them; any finite numbers. A distance above the
 *     largest number is infinite.
 * @param count see points.
 * @param[out] out receives count results.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, EMPTY_CURVE, NOT_FINITE,
 *     TOO_LARGE, SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
 * @complexity About O(log segments + degree^2) a point, on the context's threads.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_nearest(const struct gusset_context *context,
                                   const struct gusset_curve *curve,
                                   const double *points,
                                   size_t count,
                                   struct gusset_curve_nearest_point *out);

/**
 * The arc length of a curve.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param[out] length receives it.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(points); to 1e-13, in closed form up to degree 2.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_length(const struct gusset_context *context,
                                  const struct gusset_curve *curve,
                                  double *length);

/**
 * The arc lengths from the start to many places.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param places count of them, at any alignment.
 * @param count see places.
 * @param[out] out receives count numbers.
 * @return GUSSET_OK, or an error: those of gusset_curve_derivatives.
 * @complexity O(points) in all.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_lengths_at(const struct gusset_context *context,
                                      const struct gusset_curve *curve,
                                      const struct gusset_place *places,
                                      size_t count,
                                      double *out);

/**
 * The places at many arc lengths from the start; beyond the ends, the ends.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param lengths count numbers.
 * @param count see lengths.
 * @param[out] out receives count places.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, EMPTY_CURVE, OUT_OF_RANGE
 *     (NaN), SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(points + count log segments).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_places_at(const struct gusset_context *context,
                                     const struct gusset_curve *curve,
                                     const double *lengths,
                                     size_t count,
                                     struct gusset_place *out);

/**
 * The smallest box with sides along the axes.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param[out] bounds receives the least x, y, z and the greatest x, y, z.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, EMPTY_CURVE, CANCELLED.
 * @complexity O(points); exact but for rounding.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_bounds(const struct gusset_context *context,
                                  const struct gusset_curve *curve,
                                  double *bounds);

/**
 * The area vector, half the integral of r x dr: for a plane curve (0, 0, signed area).
 *
 * An open curve is closed by the chord from its end to its start.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param[out] area receives x, y, z.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, CANCELLED.
 * @complexity O(sum of degree^2); exact but for rounding.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_area_vector(const struct gusset_context *context,
                                       const struct gusset_curve *curve,
                                       double *area);

/**
 * Area, centroid and second moments of what a plane curve encloses.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param[out] moments receives the moments; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     CURVE_NOT_PLANE, EMPTY_CURVE, CANCELLED.
 * @complexity O(sum of degree^2); exact but for rounding.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_get_moments(const struct gusset_context *context,
                                       const struct gusset_curve *curve,
                                       struct gusset_curve_moment_report *moments);

/**
 * Finds the curves through the points of outlines: control points are sought such that each curve
 * passes the points of its outline.
 *
 * A point that cannot be treated as asked is no failure: its status says so, and the curve passes
 * it all the same if that is possible at all.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param outlines any number of them.
 * @param options NULL for the defaults: smooth quadratic segments by the bisector, one control
 *     point for each point.
 * @param[out] outline receives the result, for gusset_outline_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE, OUT_OF_RANGE (an option, or the dimension), BAD_STRIDE, BAD_OFFSETS,
 *     SIZE_OVERFLOW, TOO_LARGE, NOT_FINITE (the report has the point), NO_SUCH_ELEMENT (a
 *     constraint whose point does not exist or is not behind the one before; the report has the
 *     constraint), OUT_OF_MEMORY, CANCELLED.
 * @complexity Composite, blended and cubic curves take linear time; linear memory, none for each
 *     outline but for its result, and about 1,500 bytes a point of the largest outline with
 *     GUSSET_JOINT_PARAMETER_G2.
 * @source Nadopta; the composite and blended readings are ours.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_outline_create(const struct gusset_context *context,
                                    const struct gusset_outlines *outlines,
                                    const struct gusset_outline_options *options,
                                    struct gusset_outline **outline);

/**
 * Destroys what gusset_outline_create made; NULL is allowed.
 *
 * @param[in,out] outline the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_outline_destroy(struct gusset_outline *outline);

/**
 * Lends the curves, valid until the outline is destroyed.
 *
 * @param outline the outline.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_outline_get_view(const struct gusset_outline *outline,
                                      struct gusset_outline_view *parts);

/**
 * The account of outline `index`.
 *
 * @param outline the outline.
 * @param index its number, from 0.
 * @param[out] report receives the report; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     NO_SUCH_ELEMENT.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_outline_get_report(const struct gusset_outline *outline,
                                        size_t index,
                                        struct gusset_outline_report *report);

/**
 * Lends the history of outline `index`: how far each cycle moved the control points, if the
 * options asked for it.
 *
 * @param outline the outline.
 * @param index its number, from 0.
 * @param[out] history receives it; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     NO_SUCH_ELEMENT.
 * @complexity O(1).
 * @source Nadopta, the second and following approximations.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_outline_get_history(const struct gusset_outline *outline,
                                         size_t index,
                                         struct gusset_outline_history_view *history);

/**
 * Copies the curve of outline `index`, for what the gusset_curve functions do.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param outline the outline.
 * @param index its number, from 0.
 * @param[out] curve receives it, for gusset_curve_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NO_SUCH_ELEMENT,
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity O(segments).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_outline_curve_create(const struct gusset_context *context,
                                          const struct gusset_outline *outline,
                                          size_t index,
                                          struct gusset_curve **curve);

/**
 * Finds the section of each point with its two neighbours: the quadratic through the three whose
 * control point lies on the guide of the method.
 *
 * A tangent demanded at a point makes its section pass in that direction; one at the first or last
 * point of an open outline is that of the neighbour's section there. Where it cannot be had, or
 * the normal, the method (the bisector) takes its place, and the status says so.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param outlines the outlines.
 * @param options NULL for the defaults; method, alpha and solver are read, and by
 *     GUSSET_SOLVER_STEP tolerance, first_step, step_divisor and max_steps; all must be valid.
 * @param[out] sections receives the result, for gusset_sections_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_outline_create.
 * @complexity O(n).
 * @source Nadopta, the methods of the normal, tangent, bisector and median; closed forms: B = P +
 *     (P - S) / (2 sqrt(s (1 - s))) for the foot S = A + s (C - A) of the guide.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sections_create(const struct gusset_context *context,
                                     const struct gusset_outlines *outlines,
                                     const struct gusset_outline_options *options,
                                     struct gusset_sections **sections);

/**
 * Destroys what gusset_sections_create made; NULL is allowed.
 *
 * @param[in,out] sections the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_sections_destroy(struct gusset_sections *sections);

/**
 * Lends the sections, valid until they are destroyed.
 *
 * @param sections the sections.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sections_get_view(const struct gusset_sections *sections,
                                       struct gusset_sections_view *parts);

/**
 * Finds where pieces that overlap belong: rigid motions after which they fit, all at once, so that
 * no error adds up round a ring of them. The first piece stays.
 *
 * Points of each piece look for the nearest ones on the others, those beyond a border of the other
 * apart and those whose normals differ by more than 45 degrees; the motions that bring pairs onto
 * the planes of their normals, with less weight for those far off, are found in one system of
 * equations; and so on until nothing moves. Pieces have to begin within max_distance of where they
 * belong, see start. A piece that lies on no other stays where it begins; where
 * overlaps leave it free it may slide.
 *
 * What is not known is no failure, but said for each piece: a piece is trusted if it fits others,
 * overlaps hold it in all six directions by more than the noise of normals, and pieces lead from
 * it to the first one by pairs that fit.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param pieces piece_count mesh views one after another, each as large as the first one's
 *     struct_size says, at least one.
 * @param piece_count see pieces.
 * @param options NULL for the defaults.
 * @param[out] alignment receives the result, for gusset_alignment_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_mesh_view (the report's input is the piece),
 *     EMPTY_MESH without pieces, UNKNOWN_VALUE, OUT_OF_RANGE (max_distance; or a pose that is no
 *     rotation and translation, whose number is the report's index), COUNT_DIFFERS (fewer poses
 *     than pieces), TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(V log V) for V vertices of a piece, and O(samples log V) for each piece and each
 *     one near it in each round, of which 10 to 30 are common; with GUSSET_ALIGN_RIMS 512^2 for
 *     each two pieces. Linear extra memory.
 * @source P. Besl and N. McKay (1992); Y. Chen and G. Medioni (1992); G. Turk and M. Levoy (1994);
 *     P. Neugebauer (1997); S. Rusinkiewicz, A symmetric objective function for ICP (2019).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_alignment_create(const struct gusset_context *context,
                                      const struct gusset_mesh_view *pieces,
                                      size_t piece_count,
                                      const struct gusset_alignment_options *options,
                                      struct gusset_alignment **alignment);

/**
 * Destroys an alignment; NULL is allowed.
 *
 * @param[in,out] alignment the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_alignment_destroy(struct gusset_alignment *alignment);

/**
 * Lends the poses and what is known of them.
 *
 * @param alignment the alignment.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_alignment_get_view(const struct gusset_alignment *alignment,
                                        struct gusset_alignment_view *view);

/**
 * Assembles open pieces into one mesh: coincident borders are sewn, components oriented alike,
 * loops that face each other across a gap stitched, holes filled, and closed components turned
 * outwards, as the options say.
 *
 * That two loops cannot be joined is no failure: each joint has its outcome.
 *
 * Loops of different components face each other as wholes if nearly all vertices of each (9/10)
 * are nearest to the other loop, and from similar distances (the ninth decile is at most four
 * times the first, or the spacing of the vertices) or so that the nearest vertices go round the
 * other loop once; else runs of neighbouring vertices that are nearest to each other face each
 * other, and are joined by open strips. What faces nothing is left alone. Pieces that overlap are
 * not cut unless overlaps says so: where two lie on each other, their borders face each other and
 * enclose what is between.
 * Vertices of the result: those of the pieces in order, then those of the strips, then those of
 * the patches; faces in the same way. Positions are of the scalar type of the first piece, and old
 * ones keep their bits.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param pieces piece_count mesh views one after another, each as large as the first one's
 *     struct_size says, at least one; each may have several components.
 * @param piece_count see pieces.
 * @param options NULL for the defaults.
 * @param[out] assembly receives the result, for gusset_assembly_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_mesh_view (the report's input is the piece),
 *     EMPTY_MESH without pieces, MIXED_SCALARS (a piece has f64 positions and the first one f32),
 *     UNKNOWN_VALUE, OUT_OF_RANGE (a tolerance, max_gap, or one of pairs or of excluded: the
 *     report's index is its number, its input is 0 or 1 for the first or the second loop, its
 *     value the piece that does not exist, else the vertex, and the message says what is wrong:
 *     there is no such piece, or no such vertex of it; of pairs also: no vertex is named, no loop
 *     that can be joined passes it or several do, it is on the pair's other loop, or its loop is
 *     in a pair before), TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(H log d) for H half-edges and at most d edges at a vertex, O(V log V) for V
 *     vertices on loops, the time of each strip as for gusset_stitch_create, and of each hole as
 *     for gusset_fill_create; a pass over all faces for each strip that is faired or tested for
 *     intersections. Extra memory is linear in the pieces and the result.
 * @source Nesterenko for a single gap; the rest is our own.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_assembly_create(const struct gusset_context *context,
                                     const struct gusset_mesh_view *pieces,
                                     size_t piece_count,
                                     const struct gusset_assembly_options *options,
                                     struct gusset_assembly **assembly);

/**
 * Destroys an assembly; NULL is allowed.
 *
 * @param[in,out] assembly the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_assembly_destroy(struct gusset_assembly *assembly);

/**
 * Lends the whole result, valid until the assembly is destroyed.
 *
 * @param assembly the assembly.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_assembly_get_mesh(const struct gusset_assembly *assembly,
                                       struct gusset_mesh_view *view);

/**
 * Lends the account.
 *
 * @param assembly the assembly.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: those of gusset_assembly_get_mesh.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_assembly_get_view(const struct gusset_assembly *assembly,
                                       struct gusset_assembly_view *parts);

/**
 * Carries values of the inputs' elements over to the elements of a result.
 *
 * Elements of one source have its bits; the rule says what becomes of several. An element without
 * sources, or whose sources all lack the channel, has 0.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param origins the origins of the result's elements.
 * @param channel what the values are.
 * @param inputs the values of each input of the origins, in their order; at any alignment.
 * @param input_count their number.
 * @param[out] values receives the components of each element at the start of every stride, at any
 *     alignment; the bytes between are left alone. From its first byte to its last it must not
 *     overlap the inputs' values.
 * @param count the number of elements that it has room for, at least those of the result.
 * @param stride bytes from one element to the next; 0 for packed ones.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE, OUT_OF_RANGE (components, or value_type and components that the rule does
 *     not take; a negative skin weight, with the element and the input), NOT_FINITE with the
 *     element and the input, but for GUSSET_RULE_NEAREST; COUNT_DIFFERS (another number of
 *     inputs than there are, or of values, with the input), BAD_STRIDE, SIZE_OVERFLOW,
 *     BUFFER_TOO_SMALL, OVERLAP, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(sources and elements); no memory, but for GUSSET_RULE_TEXTURE, linear in the corners of
 *     new faces; on the context's threads.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_attributes_apply(const struct gusset_context *context,
                                      const struct gusset_origins *origins,
                                      const struct gusset_channel *channel,
                                      const struct gusset_channel_values *inputs,
                                      size_t input_count,
                                      void *values,
                                      size_t count,
                                      size_t stride);

/**
 * Finds which vertices of a mesh are one: those with equal keys, as of the vertices that were split
 * at seams of texture coordinates or normals, or those at equal positions, where -0 equals 0.
 *
 * For each vertex it gives the smallest of those that it is one with, as the field merge of
 * gusset_mesh_view takes it. Without keys, a vertex whose position is not finite is one with itself
 * alone.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh the mesh.
 * @param keys one for each vertex, at any alignment; NULL: positions.
 * @param[out] merge room for as many numbers as the mesh has vertices; at any alignment.
 * @return GUSSET_OK, or an error: those of gusset_mesh_view, SIZE_OVERFLOW, OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(V log V) for V vertices; 8 bytes for each, 12 with keys.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_mesh_find_merge(const struct gusset_context *context,
                                     const struct gusset_mesh_view *mesh,
                                     const uint32_t *keys,
                                     uint32_t *merge);

/**
 * Finds every free boundary loop of a mesh: the chains of edges that have a face on one side only.
 *
 * Direction: a loop runs as the faces along it run their own edges. With faces counter-clockwise
 * from outside, the surface is on the left and the hole on the right of someone who walks along
 * the loop on the outside. Every loop passes each of its vertices once: where the boundary touches
 * itself it is cut into several loops. Loops come in the order of their smallest half-edges. Walks
 * along edges with three or more faces alone are left out; a loop that is cut out of another walk
 * may have no edge with exactly one face. A face of fewer than three sides of different ends has no
 * border; its neighbours are taken to touch each other. A loop may have two vertices. Odd places
 * are no errors: see the flags of each loop, and gusset_boundary_get_defects.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh the mesh.
 * @param options NULL for the defaults.
 * @param[out] boundary receives the result, for gusset_boundary_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_mesh_view, UNKNOWN_VALUE, OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(H log d) for H half-edges and at most d edges at a vertex, or O(H + B log B) for
 *     GUSSET_SURVEY_BOUNDARY_ONLY and B boundary edges; linear extra memory.
 * @source Nesterenko, algorithm 1, as corrected: every loop, a stated direction, fan by fan round
 *     each vertex.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_boundary_create(const struct gusset_context *context,
                                     const struct gusset_mesh_view *mesh,
                                     const struct gusset_boundary_options *options,
                                     struct gusset_boundary **boundary);

/**
 * Destroys a boundary; NULL is allowed.
 *
 * @param[in,out] boundary the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_boundary_destroy(struct gusset_boundary *boundary);

/**
 * The number of loops and open chains: 0 if the mesh is closed, or for NULL.
 *
 * @param boundary the boundary.
 * @return their number; 0 for NULL.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API size_t gusset_boundary_loop_count(const struct gusset_boundary *boundary);

/**
 * The number of walks that the loops were cut from: loops that touch at vertices, counted as one
 * where the walk round the boundary passes from one to the next.
 *
 * 0 for NULL.
 *
 * @param boundary the boundary.
 * @return their number; 0 for NULL.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API size_t gusset_boundary_walk_count(const struct gusset_boundary *boundary);

/**
 * Lends loop number `index`, below gusset_boundary_loop_count.
 *
 * @param boundary the boundary.
 * @param index its number, from 0.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     NO_SUCH_ELEMENT.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_boundary_get_loop(const struct gusset_boundary *boundary,
                                       size_t index,
                                       struct gusset_loop_view *view);

/**
 * Lends what is wrong or unusual: degenerate faces, orientation conflicts and non-manifold edges
 * of the whole mesh, and the bow-tie vertices on its boundary.
 *
 * They are valid until the boundary is destroyed; NULL and 0 if there is nothing.
 *
 * @param boundary the boundary.
 * @param[out] defects receives the first one.
 * @param[out] count receives how many.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_boundary_get_defects(const struct gusset_boundary *boundary,
                                          const struct gusset_defect **defects,
                                          size_t *count);

/**
 * Checks a mesh.
 *
 * What it finds is no error.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh the mesh.
 * @param[out] check receives the result, for gusset_check_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_mesh_view, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(H log d) for H half-edges and at most d edges at a vertex; linear extra memory.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_check_create(const struct gusset_context *context,
                                  const struct gusset_mesh_view *mesh,
                                  struct gusset_check **check);

/**
 * Destroys a check; NULL is allowed.
 *
 * @param[in,out] check the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_check_destroy(struct gusset_check *check);

/**
 * Lends what the check found.
 *
 * @param check the check.
 * @param[out] report receives the report; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_check_get_view(const struct gusset_check *check,
                                    struct gusset_check_view *report);

/**
 * Lays a surface out in the plane with the least distortion: the pattern to cut it from.
 *
 * The surface is cut along the paths given. What is no disc then, as a tube, a closed surface, one
 * with holes or handles, is opened along short paths. Each connected component of the rest is a
 * chart. One that can be unfolded about its edges, as cylinders, cones and tangent developables in
 * plane strips can, keeps the length of every edge to 1e-10 of it (of 1e-3 mean edges, if it is
 * shorter), before rounding: charts lie beside
 * one another, and far from the origin places are rounded more. It may overlap itself; triangles
 * without area may then be turned over by rounding. Any other chart descends to the least
 * distortion; no triangle is turned over, and the border does not meet itself, so that the map is
 * one to one. Where that ends the descent early, its finish is STALLED. Darts are made as long as
 * they lower the distortion: each is a cut from the border to the vertex whose scale in a conformal
 * map would be the worst.
 *
 * The result has the faces of the mesh in their order, each from its own first corner and all
 * counterclockwise in the plane. Charts are turned so that the mean square of their borders'
 * distances from the middle is greatest along x. A vertex on a cut becomes several; of merged
 * vertices the smallest is meant. Edges of three or more faces, and those whose two faces disagree in
 * orientation, are borders, and no cuts. Polygons are measured by triangles they are cut into; a
 * triangle flatter than 1e-7 of its longest side, or smaller than 1e-7 of the mean edge, counts as
 * that large. Conformal maps have the area of the surface.
 *
 * Nets and sheets are developed by their meshes; see gusset_net_mesh_create and
 * gusset_sheet_mesh_create.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh the surface.
 * @param options NULL for the defaults.
 * @param[out] development receives the result, for gusset_development_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_mesh_view, UNKNOWN_VALUE, OUT_OF_RANGE
 *     (max_stretch), BAD_OFFSETS (cut_offsets), INDEX_OUT_OF_RANGE (a vertex of a cut; the
 *     report's input is the cut, the index the place in it), CUT_NOT_CONNECTED (the same),
 *     REPEATED_CORNER (a face), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(H log H) for H half-edges if charts unfold; else, for each step of the descent and
 *     each dart, O(n^1.5) for n vertices of the chart. Memory O(n log n).
 * @source M. Rabinovich et al., Scalable locally injective mappings (2017), for the descent; B.
 *     Levy et al., Least squares conformal maps (2002); J. Erickson, K. Whittlesey, Greedy optimal
 *     homotopy and homology generators (2005), for the cuts that open; M. Ben-Chen et al.,
 *     Conformal flattening by curvature prescription and metric scaling (2008), for darts.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_development_create(const struct gusset_context *context,
                                        const struct gusset_mesh_view *mesh,
                                        const struct gusset_development_options *options,
                                        struct gusset_development **development);

/**
 * Destroys a development; NULL is allowed.
 *
 * @param[in,out] development the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_development_destroy(struct gusset_development *development);

/**
 * Lends the flat mesh, in the scalar type of the surface, with z = 0, valid until the development
 * is destroyed.
 *
 * @param development the development.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_development_get_mesh(const struct gusset_development *development,
                                          struct gusset_mesh_view *view);

/**
 * Lends the places in the plane, where they come from, and the account of each chart.
 *
 * @param development the development.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: those of gusset_development_get_mesh.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_development_get_view(const struct gusset_development *development,
                                          struct gusset_development_view *view);

/**
 * Finds which vertices of two loops face each other.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param points_a x, y, z of the vertices of each loop in order, packed, count_a and count_b of
 *     them, at least 1 each.
 * @param count_a see points_a.
 * @param points_b see points_a.
 * @param count_b see points_a.
 * @param options NULL for the defaults.
 * @param[out] facing receives the result, for gusset_facing_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: LOOP_TOO_SHORT, TOO_LARGE, SIZE_OVERFLOW, NOT_FINITE,
 *     UNKNOWN_VALUE, OUT_OF_RANGE, PLANES_UNDECIDED (no vertex of a loop is beyond the tolerance,
 *     as with coaxial rims, or the centres coincide), OUT_OF_MEMORY, CANCELLED.
 * @complexity O((N + M) log M); linear extra memory.
 * @source Nesterenko, algorithm 2, equations 5-7, with a tolerance, and runs instead of subsets.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_facing_create(const struct gusset_context *context,
                                   const double *points_a,
                                   size_t count_a,
                                   const double *points_b,
                                   size_t count_b,
                                   const struct gusset_facing_options *options,
                                   struct gusset_facing **facing);

/**
 * Destroys what gusset_facing_create made; NULL is allowed.
 *
 * @param[in,out] facing the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_facing_destroy(struct gusset_facing *facing);

/**
 * Lends what was found.
 *
 * @param facing what was found.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_facing_get_view(const struct gusset_facing *facing,
                                     struct gusset_facing_view *view);

/**
 * The paper's rule for meridians: for each i = 0 .. n the j = 0 .. m that makes |m i - n j| least,
 * of two equal ones the later.
 *
 * @param n segments of the longer and of the other polyline, m <= n (OUT_OF_RANGE): an open one of
 *     N vertices has N - 1, a closed one N.
 * @param m see n.
 * @param[out] j receives n + 1 numbers; NULL with capacity 0 asks for how many.
 * @param capacity of j.
 * @param[out] written receives their number; may not be NULL.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_RANGE,
 *     BUFFER_TOO_SMALL (nothing but the number is written).
 * @complexity O(n).
 * @source Nesterenko, the intermediate mesh: j = floor((2 m i + n) / (2 n)), without the products.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_meridians_index(uint32_t n,
                                     uint32_t m,
                                     uint32_t *j,
                                     size_t capacity,
                                     size_t *written);

/**
 * Fills holes of a mesh: closes boundary loops by new triangles, oriented as the surface round
 * them.
 *
 * Loops that cannot be filled are left, which is no error: the account of each says why.
 *
 * The result has the old vertices with their bits and indices, then the new ones; the old faces,
 * which are turned over only if outward says so, then the new triangles, hole by hole. No new edge
 * joins two vertices of one old face, so that a result that is closed stays so when its polygons are
 * cut into triangles. A planar hole gets no overlaps by the default weight and by area, however
 * concave it is, also one round islands, if its rims do not cross.
 *
 * Creases of the old surface that end at a rim go on across the patch, by plain triangles where they
 * are straight: joined in pairs, or three and more in a new vertex where they meet. A crease without
 * a counterpart ends at the rim. Patches of several loops have none, and with ignore_creases none
 * has.
 *
 * Several loops get one patch where options.groups or options.together says so: a surface of genus 0
 * between them. If none is found, by a search that is not complete, or two of the loops share a
 * vertex, all of them are left; GUSSET_TOGETHER_CHEAPEST leaves such loops apart.
 *
 * Faces of a patch that cut each other or old faces are looked for, exactly. Where there are any,
 * less fairing, the other weights and no new vertices are tried, and what cuts least is taken; the
 * view has the pairs that are left. No faired vertex leaves the box round its rims, larger on all
 * sides by half its diagonal.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh the mesh.
 * @param loops the vertices of each loop in order, in either direction, each consecutive pair (and
 *     the last with the first) an edge with exactly one face; loop_count of them. NULL with 0: all
 *     loops that the mesh has.
 * @param loop_count see loops.
 * @param options NULL for the defaults.
 * @param[out] fill receives the result, for gusset_fill_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_mesh_view, INDEX_OUT_OF_RANGE (with the place in
 *     the loop, whose number is the report's input), NULL_ARGUMENT (groups without loops),
 *     UNKNOWN_VALUE, OUT_OF_RANGE, TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
 * @complexity Loops of n <= 128 vertices: O(n^3) time and 30 n^2 bytes, the best triangulation (of
 *     least area: exactly); longer ones: from coarse to fine, O(n), or, if they are planar, ear by
 *     ear, O(n log n); linear memory. Several loops of n vertices in all: O(n log n) if they are
 *     few, O(n^3) if they are many. Besides O(H log d) for H half-edges and at most d edges at a
 *     vertex, and O(m^1.5) for m new vertices of a hole. The search for cuts: O(n log n) for n faces
 *     near the holes, and the pairs whose boxes overlap, in the worst case O(n^2). Loops that touch
 *     at one vertex look at each other's edges there.
 * @source Barequet and Sharir 1995; Liepa, Filling holes in meshes, 2003.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_fill_create(const struct gusset_context *context,
                                 const struct gusset_mesh_view *mesh,
                                 const struct gusset_indices *loops,
                                 size_t loop_count,
                                 const struct gusset_fill_options *options,
                                 struct gusset_fill **fill);

/**
 * Destroys a fill; NULL is allowed.
 *
 * @param[in,out] fill the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_fill_destroy(struct gusset_fill *fill);

/**
 * Lends the result, valid until the fill is destroyed.
 *
 * @param fill the filled mesh.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_fill_get_mesh(const struct gusset_fill *fill,
                                   struct gusset_mesh_view *view);

/**
 * Lends the accounts of the loops.
 *
 * @param fill the filled mesh.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: those of gusset_fill_get_mesh.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_fill_get_view(const struct gusset_fill *fill,
                                   struct gusset_fill_view *parts);

/**
 * Measures of the new faces and of the result.
 *
 * @param fill the filled mesh.
 * @param[out] quality receives the measures; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_fill_get_quality(const struct gusset_fill *fill,
                                      struct gusset_quality_report *quality);

/**
 * Turns faces over until faces that share an edge of two faces run it in opposite directions.
 *
 * In each component as few faces as possible are turned; where both sides are as many, its
 * smallest face stays. Edges of three or more faces connect nothing. A component that cannot be
 * oriented, such as a Moebius strip, stays as it is and is listed. A turned face keeps its first
 * corner and has the others in reverse order; all else is as it was: vertices, positions, order of
 * faces.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh the mesh.
 * @param options NULL for the defaults.
 * @param[out] orient receives the result, for gusset_orient_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_mesh_view, UNKNOWN_VALUE, OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(H log d) for H half-edges and at most d edges at a vertex; linear extra memory.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_orient_create(const struct gusset_context *context,
                                   const struct gusset_mesh_view *mesh,
                                   const struct gusset_orient_options *options,
                                   struct gusset_orient **orient);

/**
 * Destroys what gusset_orient_create made; NULL is allowed.
 *
 * @param[in,out] orient the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_orient_destroy(struct gusset_orient *orient);

/**
 * Lends the oriented mesh, valid until the handle is destroyed.
 *
 * @param orient the oriented mesh.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_orient_get_mesh(const struct gusset_orient *orient,
                                     struct gusset_mesh_view *view);

/**
 * Lends the flags, lists and counts.
 *
 * @param orient the oriented mesh.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: those of gusset_orient_get_mesh.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_orient_get_view(const struct gusset_orient *orient,
                                     struct gusset_orient_view *parts);

/**
 * The origins of a stitched mesh, whose inputs are its one or two meshes.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param stitch the stitched mesh.
 * @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(H log n) for H corners, n of them of new faces; 16 bytes for each vertex, corner and
 *     face, and linear in n.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_stitch_origins_create(const struct gusset_context *context,
                                           const struct gusset_stitch *stitch,
                                           struct gusset_origins **origins);

/**
 * The origins of a strip, whose inputs are its two polylines; they have no corners and faces, and
 * nor have its own any sources.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param strip the strip.
 * @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
 * @complexity As gusset_stitch_origins_create.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_strip_origins_create(const struct gusset_context *context,
                                          const struct gusset_strip *strip,
                                          struct gusset_origins **origins);

/**
 * The origins of a mesh with holes filled.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param fill the mesh.
 * @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
 * @complexity As gusset_stitch_origins_create.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_fill_origins_create(const struct gusset_context *context,
                                         const struct gusset_fill *fill,
                                         struct gusset_origins **origins);

/**
 * The origins of an assembly, whose inputs are its pieces.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param assembly the assembly.
 * @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
 * @complexity As gusset_stitch_origins_create.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_assembly_origins_create(const struct gusset_context *context,
                                             const struct gusset_assembly *assembly,
                                             struct gusset_origins **origins);

/**
 * The origins of a welded mesh.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param weld the welded mesh.
 * @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
 * @complexity O(size); 16 bytes for each vertex, corner and face.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_weld_origins_create(const struct gusset_context *context,
                                         const struct gusset_weld *weld,
                                         struct gusset_origins **origins);

/**
 * The origins of a sewn mesh. A corner that a face gained on an edge has the face's corners at both
 * ends of the edge.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param sew the sewn mesh.
 * @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
 * @complexity As gusset_weld_origins_create.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sew_origins_create(const struct gusset_context *context,
                                        const struct gusset_sew *sew,
                                        struct gusset_origins **origins);

/**
 * The origins of an oriented mesh.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param orient the oriented mesh.
 * @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
 * @complexity As gusset_weld_origins_create.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_orient_origins_create(const struct gusset_context *context,
                                           const struct gusset_orient *orient,
                                           struct gusset_origins **origins);

/**
 * The origins of a development: each vertex comes from one, corners and faces are those of the
 * surface.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param development the development.
 * @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
 * @complexity As gusset_weld_origins_create.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_development_origins_create(const struct gusset_context *context,
                                                const struct gusset_development *development,
                                                struct gusset_origins **origins);

/**
 * Destroys origins; NULL is allowed.
 *
 * @param[in,out] origins the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_origins_destroy(struct gusset_origins *origins);

/**
 * Lends the origins of the result's vertices, corners or faces, valid until they are destroyed.
 *
 * @param origins the origins.
 * @param domain GUSSET_DOMAIN_...
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_origins_get_view(const struct gusset_origins *origins,
                                      gusset_domain domain,
                                      struct gusset_origins_view *view);

/**
 * Sews borders that lie on one another, also where their vertices do not match.
 *
 * Vertices are welded first, as by gusset_weld_create. Where a vertex of one border then lies
 * inside a free edge of another (a T-junction), the edge is split there, if that makes pieces of
 * which exactly two lie on one another; triangles with split edges are cut into triangles, none of
 * them turned over, and larger faces gain corners. Then borders are welded again. So the result
 * has no edge of three or more faces and no degenerate face that welding alone would not have
 * made. Vertices that lie inside an edge which is not split there are listed as left, as are those
 * that welding leaves.
 *
 * A vertex lies inside an edge that is longer than twice the tolerance if it is within the
 * tolerance of it and beyond that from both its ends. By default it is that of welding: see
 * gusset_weld_options.
 *
 * The result has the old faces in their order, and the parts of one in place of it, one after the
 * other. Of vertices made one the smallest is left, and its position keeps its bits; new vertices
 * have the position of an old one.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh the mesh.
 * @param options how to weld, NULL for the defaults. With GUSSET_WELD_ALL all vertices are welded
 *     before edges are split, and borders after it.
 * @param[out] sew receives the result, for gusset_sew_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_weld_create, TOO_LARGE (the result has too many
 *     elements).
 * @complexity O(H log H) for H half-edges, if no vertex has very many and few vertices lie inside
 *     each edge; linear extra memory.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sew_create(const struct gusset_context *context,
                                const struct gusset_mesh_view *mesh,
                                const struct gusset_weld_options *options,
                                struct gusset_sew **sew);

/**
 * Destroys a sewn mesh; NULL is allowed.
 *
 * @param[in,out] sew the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_sew_destroy(struct gusset_sew *sew);

/**
 * Lends the sewn mesh, valid until its handle is destroyed.
 *
 * @param sew the sewn mesh.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sew_get_mesh(const struct gusset_sew *sew,
                                  struct gusset_mesh_view *view);

/**
 * Lends the maps, lists and counts.
 *
 * @param sew the sewn mesh.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: those of gusset_sew_get_mesh.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sew_get_view(const struct gusset_sew *sew,
                                  struct gusset_sew_view *parts);

/**
 * Joins two boundary loops, of two meshes or of one, by a strip of new faces: a closed band
 * between whole loops, or a strip between the arcs that face each other.
 *
 * The result has the vertices of A, then of B, then new ones in the interior rows; the faces of A,
 * then of B, then the strip. Positions are of the scalar type of A, old ones keep their bits, and
 * every old face is kept. An arc of one vertex gets a fan, which touches its piece at that vertex
 * only; two arcs of one vertex each get one meridian and no face.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh_a the first mesh.
 * @param loop_a the vertices of each loop in order, in either direction, each consecutive pair
 *     (and the last with the first) an edge with exactly one face. If both are NULL, the loops
 *     that lie nearest to each other are taken; if one is, the loop of its mesh that is nearest to
 *     the one given. Those to choose from are not open, have three vertices or more, and the faces
 *     along them agree in orientation and are manifold there; two of one mesh share no vertex.
 * @param mesh_b NULL if both loops are of mesh_a.
 * @param loop_b see loop_a.
 * @param options NULL for the defaults.
 * @param[out] stitch receives the result, for gusset_stitch_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_mesh_view, UNKNOWN_VALUE, OUT_OF_RANGE,
 *     PLANES_UNDECIDED, NO_LOOP (of one mesh: it has no two that share no vertex), LOOP_TOO_SHORT,
 *     LOOP_REPEATS_VERTEX, LOOP_EDGE_NOT_FREE, LOOP_NOT_ORIENTED, LOOPS_SHARE_VERTEX,
 *     ORIENTATION_CONFLICT, NO_STRIP, MIXED_SCALARS (A has f32 and B f64 positions), TOO_LARGE,
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity O(H log d) for H half-edges and at most d edges at a vertex; plus for the meridians
 *     O(N M) up to 2^21 pairs of vertices, beyond that and for the simple rules O((N + M) log M);
 *     plus the size of the strip, and fairing and intersection tests where asked for (O(n log n)
 *     and a test for each pair of triangles whose boxes overlap, which is all pairs in the worst
 *     case); plus, for a blend of n new vertices, O(n log n) and the solution of up to five
 *     plates, O(n^1.5) each, nearly linear where the gap is narrow; plus a box test for each pair
 *     of loops where the choice is left open. Extra memory is linear in the meshes and the strip;
 *     GUSSET_SEARCH_EXACT takes one byte for each of up to 2^26 pairs of vertices and 8 M bytes
 *     for each 2^26 pairs begun, with GUSSET_MERIDIANS_CONTINUATION or _SMOOTH 2 bytes for each
 *     pair, where the best strip would use an edge twice 8; twice that with more than one thread
 *     and two starts.
 * @source Nesterenko, algorithm 2 and the intermediate mesh (H, P). Whole loops repeat their
 *     start: N + 1 and M + 1 points.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_stitch_create(const struct gusset_context *context,
                                   const struct gusset_mesh_view *mesh_a,
                                   const struct gusset_indices *loop_a,
                                   const struct gusset_mesh_view *mesh_b,
                                   const struct gusset_indices *loop_b,
                                   const struct gusset_stitch_options *options,
                                   struct gusset_stitch **stitch);

/**
 * Destroys a stitch; NULL is allowed.
 *
 * @param[in,out] stitch the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_stitch_destroy(struct gusset_stitch *stitch);

/**
 * Lends the whole result, valid until the stitch is destroyed.
 *
 * @param stitch the stitch.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_stitch_get_mesh(const struct gusset_stitch *stitch,
                                     struct gusset_mesh_view *view);

/**
 * Lends the strip alone: the vertices of the two rims, the new ones, and the faces between them.
 *
 * @param stitch the stitch.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: those of gusset_stitch_get_mesh.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_stitch_get_strip(const struct gusset_stitch *stitch,
                                      struct gusset_mesh_view *view);

/**
 * Lends the maps, rims and meridians.
 *
 * @param stitch the stitch.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: those of gusset_stitch_get_mesh.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_stitch_get_view(const struct gusset_stitch *stitch,
                                     struct gusset_stitch_view *parts);

/**
 * Measures of the strip and of the result.
 *
 * @param stitch the stitch.
 * @param[out] quality receives the measures; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_stitch_get_quality(const struct gusset_stitch *stitch,
                                        struct gusset_quality_report *quality);

/**
 * Makes a strip of faces between two polylines that run side by side, as gusset_stitch_create does
 * between two rims: the third, intermediate mesh alone.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param points_a x, y, z of the points in order, packed, count_a and count_b of them: at least 1
 *     each, closed ones at least 3, and the last point is not the first again.
 * @param count_a see points_a.
 * @param points_b see points_a.
 * @param count_b see points_a.
 * @param options NULL for the defaults (open polylines).
 * @param[out] strip receives the result, for gusset_strip_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, LOOP_TOO_SHORT, TOO_LARGE,
 *     SIZE_OVERFLOW, NOT_FINITE, UNKNOWN_VALUE, NO_STRIP, OUT_OF_MEMORY, CANCELLED.
 * @complexity Time and memory of the meridians of gusset_stitch_create, and linear in the mesh.
 * @source Nesterenko, the intermediate mesh (H, P); Fuchs, Kedem and Uselton (1977) for the best
 *     strips.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_strip_create(const struct gusset_context *context,
                                  const double *points_a,
                                  size_t count_a,
                                  const double *points_b,
                                  size_t count_b,
                                  const struct gusset_strip_options *options,
                                  struct gusset_strip **strip);

/**
 * Destroys a strip; NULL is allowed.
 *
 * @param[in,out] strip the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_strip_destroy(struct gusset_strip *strip);

/**
 * Lends the mesh, valid until the strip is destroyed: the points of A, 0 to N - 1, those of B, then
 * the new ones row by row. Faces run A_i+1, A_i, B_j: against polyline A, and along B. Where both
 * sides advance at once triangles split a quad by its shorter diagonal.
 *
 * @param strip the strip.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_strip_get_mesh(const struct gusset_strip *strip,
                                    struct gusset_mesh_view *view);

/**
 * Lends the meridians and the matrix, valid until the strip is destroyed.
 *
 * @param strip the strip.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_strip_get_view(const struct gusset_strip *strip,
                                    struct gusset_strip_view *parts);

/**
 * Chooses what is kept of pieces that overlap: of each overlap one piece, with a narrow gap to the
 * others, which gusset_assembly_create closes; see GUSSET_OVERLAPS_TRIM there for both at once.
 *
 * The pieces are cut along lines on which both are equally good. A vertex is the better the
 * farther it is from the borders of its piece, in mean edges of it, so that the finer of two
 * pieces counts for more, and the less flat the angle it was seen under, if viewpoints are given;
 * loops of fewer than 32 vertices are small holes and no borders in that sense. A vertex lies on
 * another piece if the nearest place there is near, faces the same way, and is on no border. Where
 * two are equally good but for noise, the earlier one is kept. No vertex moves, and no face is
 * cut. What would be thinner than two faces goes, so do small islands, faces that hang on others
 * by one vertex, and faces that cut those of an earlier piece.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param pieces piece_count mesh views one after another, each as large as the first one's
 *     struct_size says, at least one, all in one coordinate system; see gusset_alignment_create.
 * @param piece_count see pieces.
 * @param options NULL for the defaults.
 * @param[out] trim receives the result, for gusset_trim_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_mesh_view (the report's input is the piece),
 *     EMPTY_MESH without pieces, OUT_OF_RANGE (max_distance, max_angle), NOT_FINITE (a viewpoint),
 *     COUNT_DIFFERS (fewer viewpoints than pieces), TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(V log F) for V vertices of a piece and F faces of each piece near it, and up to
 *     the square of the number of faces that lie in one place; linear extra memory.
 * @source The idea is that of G. Turk and M. Levoy, Zippered polygon meshes from range images
 *     (1994), who clip one mesh at the other's border.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_trim_create(const struct gusset_context *context,
                                 const struct gusset_mesh_view *pieces,
                                 size_t piece_count,
                                 const struct gusset_trim_options *options,
                                 struct gusset_trim **trim);

/**
 * Destroys what is left of pieces; NULL is allowed.
 *
 * @param[in,out] trim the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_trim_destroy(struct gusset_trim *trim);

/**
 * Lends which faces are kept.
 *
 * @param trim the trimmed pieces.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_trim_get_view(const struct gusset_trim *trim,
                                   struct gusset_trim_view *view);

/**
 * Makes one vertex of vertices that lie together.
 *
 * By default borders are sewn: where exactly two free edges lie on one another, whatever their
 * directions, they become one edge, and so do their ends. Where three or more lie together none is
 * preferred, and a pair is left where sewing it would collapse a face or make an edge of three or
 * more faces: a manifold stays one. What is left is listed. Vertices that lie together without an
 * edge to sew stay apart, as where two holes touch. With GUSSET_WELD_ALL, vertices that lie
 * together become one whatever comes of the edges.
 *
 * Which lie together within a tolerance: in ascending order, each vertex that is still unclaimed
 * claims the unclaimed ones within the tolerance of it, nearest first, so that nothing chains.
 *
 * The result has the old faces in their order, each from its own first corner. Of vertices made
 * one the smallest is left, and its position keeps its bits; the vertices left are in their old
 * order. If every face is dropped, the result has none and is no valid input.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh the mesh.
 * @param options NULL for the defaults.
 * @param[out] weld receives the result, for gusset_weld_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_mesh_view, UNKNOWN_VALUE, OUT_OF_RANGE (the
 *     tolerance), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(H log H) for H half-edges, if no vertex has very many and few corners of one face
 *     lie together; linear extra memory.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_weld_create(const struct gusset_context *context,
                                 const struct gusset_mesh_view *mesh,
                                 const struct gusset_weld_options *options,
                                 struct gusset_weld **weld);

/**
 * Destroys a weld; NULL is allowed.
 *
 * @param[in,out] weld the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_weld_destroy(struct gusset_weld *weld);

/**
 * Lends the welded mesh, valid until the weld is destroyed.
 *
 * @param weld the welded mesh.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_weld_get_mesh(const struct gusset_weld *weld,
                                   struct gusset_mesh_view *view);

/**
 * Lends the maps, lists and counts.
 *
 * @param weld the welded mesh.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: those of gusset_weld_get_mesh.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_weld_get_view(const struct gusset_weld *weld,
                                   struct gusset_weld_view *parts);

/**
 * Fills the winged-edge tables of a mesh, and runs the paper's algorithm 1 on them.
 *
 * An edge with three or more faces, or with two that run it in the same direction, becomes several
 * marked records of one face each. The mesh of a stitch keeps the edge numbers of its first mesh:
 * only NULL sides along the rim are filled.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh the mesh.
 * @param options NULL for the defaults.
 * @param[out] winged receives the result, for gusset_winged_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_mesh_view, UNKNOWN_VALUE, OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(H log d) for H half-edges and at most d edges at a vertex; linear extra memory.
 * @source Nesterenko, equations 1-3 and algorithm 1. Criterion 3 is taken as "exactly one of L, R
 *     is NULL", as the text has it; the loops are those of gusset_boundary_create, except that an
 *     edge whose faces disagree has a border on both sides.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_winged_create(const struct gusset_context *context,
                                   const struct gusset_mesh_view *mesh,
                                   const struct gusset_winged_options *options,
                                   struct gusset_winged **winged);

/**
 * Destroys tables; NULL is allowed.
 *
 * @param[in,out] winged the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_winged_destroy(struct gusset_winged *winged);

/**
 * Lends the tables.
 *
 * @param winged the tables.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_winged_get_view(const struct gusset_winged *winged,
                                     struct gusset_winged_view *view);

/**
 * Reads the faces off a winged-edge table: the way back from gusset_winged_create to a polygon
 * mesh, whose positions the caller has.
 *
 * The records are held against each other and nothing is put right: each face must be one cycle of
 * three sides or more from wing to wing, wings and faces exist, and a side without a face has no
 * wings. The marks are not read. From the edges and edge_of_face of gusset_winged_create come the
 * faces that it was given, corner for corner.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param edges the records, edge_count of them, packed.
 * @param edge_count see edges; 0 is a table without faces.
 * @param vertex_count how many vertices there are; those of edges are below it.
 * @param first_edges per face the edge at which it begins, of two such places the one where it runs
 *     M to N; NULL: the one of the smallest number.
 * @param options the winding of the faces to be made; NULL for the defaults.
 * @param[out] faces receives the result, for gusset_winged_faces_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE, BAD_WINGS with the edge, FACE_TOO_SMALL (a number below the largest that no
 *     side has, too), OUT_OF_RANGE (not one first edge for each face), TOO_LARGE, SIZE_OVERFLOW,
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity Linear time and memory.
 * @source Nesterenko, equation 2, read backwards.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_winged_faces_create(const struct gusset_context *context,
                                         const struct gusset_winged_edge *edges,
                                         size_t edge_count,
                                         size_t vertex_count,
                                         const struct gusset_indices *first_edges,
                                         const struct gusset_winged_options *options,
                                         struct gusset_winged_faces **faces);

/**
 * Destroys faces; NULL is allowed.
 *
 * @param[in,out] faces the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_winged_faces_destroy(struct gusset_winged_faces *faces);

/**
 * Lends the faces.
 *
 * @param faces the faces.
 * @param[out] view receives the view; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_winged_faces_get_view(const struct gusset_winged_faces *faces,
                                           struct gusset_winged_faces_view *view);

/**
 * Makes a net of the caller's coordinates: of a copy of them, or in the caller's own memory.
 *
 * A net in the caller's memory changes the caller's coordinates with its own.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param view the coordinates, rows x columns numbers each; any numbers: a node with one that is
 *     NaN or infinite is missing. For GUSSET_NET_MEMORY_COPY they have any alignment. For
 *     GUSSET_NET_MEMORY_BORROW they are aligned to their scalar type, without gaps in rows,
 *     row_stride a multiple of the scalar's size; the three must not overlap, and must stay valid
 *     and unmoved until the net is destroyed.
 * @param gluing NULL for a sheet.
 * @param memory GUSSET_NET_MEMORY_COPY or GUSSET_NET_MEMORY_BORROW.
 * @param[out] net receives the net, for gusset_net_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NET_TOO_SMALL, TOO_LARGE,
 *     UNKNOWN_VALUE, BAD_STRIDE, SIZE_OVERFLOW, OVERLAP, OUT_OF_RANGE (a byte of the matrix),
 *     BAD_SEAM with the seam, CROSSING_CELL with the cell, OUT_OF_MEMORY.
 * @complexity O(nodes + pairs of seams); 12 or 24 bytes a node for a copy, and 1/4 where sides do
 *     not say it all. In the caller's memory O(1) without a matrix and seams.
 * @source Deryagin, "Model of the tetragonal regular network".
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_create(const struct gusset_context *context,
                                const struct gusset_net_view *view,
                                const struct gusset_net_gluing *gluing,
                                gusset_net_memory memory,
                                struct gusset_net **net);

/**
 * Destroys a net; NULL is allowed.
 *
 * @param[in,out] net the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_net_destroy(struct gusset_net *net);

/**
 * Lends size and coordinates to be read only, as copies may share them, valid until the net is
 * changed or destroyed.
 *
 * @param net the net.
 * @param[out] view its struct_size set.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_get_view(const struct gusset_net *net,
                                  struct gusset_net_view *view);

/**
 * Lends the coordinates to be written, valid until the next call with this net.
 *
 * Nodes that are glued must be kept equal: see `snap` of gusset_glue_options. Memory shared with a
 * copy or a scene is copied first.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] net the net.
 * @param[out] view receives the arrays; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: those of gusset_net_get_view, OUT_OF_MEMORY.
 * @complexity O(1), or O(nodes) if memory is copied.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_edit(const struct gusset_context *context,
                              struct gusset_net *net,
                              struct gusset_net_view *view);

/**
 * Copies the coordinates of a net to the caller's matrices.
 *
 * Bytes between the numbers stay as they are.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param view where they go, of the net's rows and columns, in any layout and of either scalar
 *     type: double to float is rounded.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, SIDES_DIFFER (other rows or
 *     columns), UNKNOWN_VALUE, BAD_STRIDE, SIZE_OVERFLOW, CANCELLED.
 * @complexity O(nodes).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_read(const struct gusset_context *context,
                              const struct gusset_net *net,
                              const struct gusset_net_view *view);

/**
 * Compares a net after a deformation with what it was before: what is newly glued, torn, folded
 * over, stretched.
 *
 * The net stays as it is. The deformation is another net, or what fields would do: then the analysis
 * has the determinants of their Jacobian too.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net before the deformation; its gluing counts.
 * @param options the deformation; NULL for none.
 * @param[out] analysis receives the result, for gusset_net_analysis_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, BAD_STRUCT_SIZE, UNKNOWN_VALUE (fields beside
 *     `after`), OUT_OF_RANGE, SIDES_DIFFER (other sizes), CROSSING_CELL with the cell (what is newly
 *     glued is no surface), OUT_OF_MEMORY, CANCELLED, and those of gusset_net_deform.
 * @complexity O(nodes), 24 bytes a node. For fields O(nodes x fields), and 8 bytes a cell and a copy
 *     of the net besides.
 * @source Deryagin, soft and hard deformations; links are measured, as a zero of the Jacobian
 *     neither follows from gluing nor implies it.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_analysis_create(const struct gusset_context *context,
                                         const struct gusset_net *net,
                                         const struct gusset_net_analysis_options *options,
                                         struct gusset_net_analysis **analysis);

/**
 * Lends an analysis.
 *
 * @param analysis the analysis.
 * @param[out] view its struct_size set.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_analysis_get_view(const struct gusset_net_analysis *analysis,
                                           struct gusset_net_analysis_view *view);

/**
 * Destroys an analysis; NULL is allowed.
 *
 * @param[in,out] analysis the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_net_analysis_destroy(struct gusset_net_analysis *analysis);

/**
 * Makes a copy of a net, with its gluing and its bridges: of all of it or of a part, with more or
 * fewer rows and columns, turned, or with coordinates of another type.
 *
 * A copy that differs in nothing shares the memory of the net until one of the two is changed. A
 * part keeps the links, runs of seams and bridges within it. It keeps links that lead back if it
 * has all rows, or all columns. A part, a compact, a turned or a larger net keeps the bits of its
 * coordinates.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net unchanged.
 * @param options NULL for a copy that differs in nothing.
 * @param[out] copy receives it, for gusset_net_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE, NET_TOO_SMALL (a part of one row or column), OUT_OF_RANGE (a part beyond the
 *     net, fewer rows or columns than there are, an index beyond the net), CROSSING_CELL (only what
 *     is outside the part made opposite corners one), TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes) for each step; O(1) for a copy that differs in nothing, unless the net is in
 *     the caller's memory.
 * @source Deryagin, "Reformatting".
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_copy_create(const struct gusset_context *context,
                                     const struct gusset_net *net,
                                     const struct gusset_net_copy_options *options,
                                     struct gusset_net **copy);

/**
 * Makes missing every node of which a coordinate is `value`, the number that stands for what a
 * scanner did not see.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] net the net.
 * @param value the marker of missing data, compared exactly.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY.
 * @complexity O(nodes).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_clear_no_data(const struct gusset_context *context,
                                       struct gusset_net *net,
                                       double value);

/**
 * Writes for each node the smallest node that is the same point.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param[out] classes room for capacity numbers, of which rows * columns are written.
 * @param capacity see classes.
 * @param[out] written receives that number. NULL and 0 ask for it.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BUFFER_TOO_SMALL (nothing is
 *     written but the number), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes); 4 bytes a node.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_classes(const struct gusset_context *context,
                                 const struct gusset_net *net,
                                 uint32_t *classes,
                                 size_t capacity,
                                 size_t *written);

/**
 * Finds the points that are several nodes.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param[out] groups receives the result, for gusset_net_groups_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(rows + columns) for a net that its sides describe, else O(nodes); and a sort of
 *     the glued nodes.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_groups_create(const struct gusset_context *context,
                                       const struct gusset_net *net,
                                       struct gusset_net_groups **groups);

/**
 * Lends the groups.
 *
 * @param groups the groups.
 * @param[out] view receives the groups; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_groups_get_view(const struct gusset_net_groups *groups,
                                         struct gusset_net_groups_view *view);

/**
 * Destroys groups; NULL is allowed.
 *
 * @param[in,out] groups the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_net_groups_destroy(struct gusset_net_groups *groups);

/**
 * Finds the local gluing at a node or of a cell.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param place GUSSET_GLUING_PLACE_NODE or GUSSET_GLUING_PLACE_CELL.
 * @param element the node, row * columns + column, or the cell, row * (columns - 1) + column.
 * @param cyclic 0, or 1 to count links of a node that lead back to the first row or column too.
 * @param[out] found receives one of GUSSET_TYPE_..., at most GUSSET_TYPE_ALL for a node;
 *     GUSSET_TYPE_NONE for a node without glued links and for a quad.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE,
 *     NO_SUCH_ELEMENT, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(1) for a net that its sides describe, else O(nodes): see gusset_net_histogram for
 *     all.
 * @source Deryagin, Fig. 4.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_classify(const struct gusset_context *context,
                                  const struct gusset_net *net,
                                  gusset_gluing_place place,
                                  uint32_t element,
                                  uint32_t cyclic,
                                  gusset_gluing_type *found);

/**
 * Counts the local gluings of a net by type.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param[out] nodes receive 18 numbers each, how many nodes (without links that lead back) and how
 *     many cells have each type; NULL for what is not wanted.
 * @param[out] cells see nodes.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT (net), MISALIGNED_ARGUMENT, OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(nodes); 4 bytes a node.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_histogram(const struct gusset_context *context,
                                   const struct gusset_net *net,
                                   uint64_t *nodes,
                                   uint64_t *cells);

/**
 * Writes all local gluings of a net with their types and orders: those at its nodes, in order, then
 * those of its cells.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param cyclic 0, or 1 to count links that lead back to the first row or column too.
 * @param[out] found room for capacity of them.
 * @param capacity see found.
 * @param[out] written receives their number. NULL and 0 ask for it.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE (cyclic),
 *     BUFFER_TOO_SMALL (nothing is written but the number), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes); 4 bytes a node, and as much as is written.
 * @source Deryagin, Fig. 4.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_gluing_occurrences(const struct gusset_context *context,
                                            const struct gusset_net *net,
                                            uint32_t cyclic,
                                            struct gusset_gluing_occurrence *found,
                                            size_t capacity,
                                            size_t *written);

/**
 * Finds out what surface a net is once glued nodes are one.
 *
 * What it finds is no error.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param cells GUSSET_NET_CELLS_...
 * @param[out] quotient receives the result, for gusset_net_complex_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE, TOO_LARGE
 *     (2^31 edges of one face), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes), and a sort of what belongs to each glued node; linear extra memory.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_complex_create(const struct gusset_context *context,
                                        const struct gusset_net *net,
                                        gusset_net_cells cells,
                                        struct gusset_net_complex **quotient);

/**
 * Lends what is known of a complex.
 *
 * @param quotient the complex.
 * @param[out] view receives it; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_complex_get_view(const struct gusset_net_complex *quotient,
                                          struct gusset_net_complex_view *view);

/**
 * Destroys a complex; NULL is allowed.
 *
 * @param[in,out] quotient the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_net_complex_destroy(struct gusset_net_complex *quotient);

/**
 * Moves all nodes of a net by fields, the first one first, in one pass over the memory: shaping,
 * animation and projection.
 *
 * The fields work in double; the result is rounded once. Fields of strength 0 do nothing at all,
 * to the bit. Nodes that are glued and have equal bits keep them equal; missing nodes stay
 * missing. Fields that are defined everywhere are not watched for overflow: a node that they make
 * too large for its type is infinite then, and missing. Whatever the error, no node is moved.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] net the net.
 * @param fields `count` of them.
 * @param count see fields.
 * @param time for fields with keys; a net is deformed from what it is now, so that animations
 *     deform a copy of the net at rest.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, BAD_STRUCT_SIZE, UNKNOWN_VALUE (kind, axis,
 *     easing), OUT_OF_RANGE (a value, strength or time), FIELD_UNDEFINED with the node,
 *     SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes x fields), twice that if a field is not defined everywhere.
 * @threads The same bits for any number of threads.
 * @source Deryagin, "Spatial operations"; Barr 1984; Sederberg and Parry 1986.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_deform(const struct gusset_context *context,
                                struct gusset_net *net,
                                const struct gusset_field *fields,
                                size_t count,
                                double time);

/**
 * Moves every node of a net along its normal by `distance`, which may be negative; glued nodes
 * stay together, nodes without a normal stay.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] net the net.
 * @param distance a length of either sign, finite.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, OUT_OF_RANGE (distance), OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(nodes), and as much memory as the coordinates take.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_displace(const struct gusset_context *context,
                                  struct gusset_net *net,
                                  double distance);

/**
 * Glues nodes of a net, and gives glued nodes one position.
 *
 * The options are done as a whole or not at all: on failure the net is as it was.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] net the net.
 * @param options what is glued.
 * @param[out] moved receives the number of nodes that got other bits; NULL if it is not wanted.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE, UNKNOWN_VALUE
 *     (kind, mask, reserved, a flag), OUT_OF_RANGE (tolerance, a mask above 15), NO_SUCH_ELEMENT
 *     (the link, node or cell), BAD_SEAM (its place among the gluings), CROSSING_CELL with the cell
 *     (both pairs of opposite corners would be glued: the nineteenth local gluing, which no surface
 *     allows), TOO_LARGE, SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes + glued pairs), and a sort of the nodes of the sides for `detect`. For `snap`
 *     alone O(rows + columns) if the net is glued along its sides alone, else O(nodes).
 * @source Deryagin, "Local gluings of nodes".
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_glue(const struct gusset_context *context,
                              struct gusset_net *net,
                              const struct gusset_glue_options *options,
                              uint64_t *moved);

/**
 * Unglues pairs of nodes: their links are free, and seams that have them are cut there.
 *
 * Nodes that are still glued by way of others stay one point; pairs that are not glued are left
 * alone.
 *
 * On failure the net is as it was.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] net the net.
 * @param gluings count of them, done as a whole or not at all; at any alignment.
 * @param count see gluings.
 * @param separation 0, or how far apart what becomes separate is moved, in the unit of the
 *     coordinates: each piece of a point that falls apart moves by half of it towards the mean of
 *     its neighbours (of those that do not fall apart themselves, if there are any); one without
 *     neighbours, or in the middle of them, stays.
 * @param[out] moved receives the number of pieces that moved; NULL if it is not wanted.
 * @return GUSSET_OK, or an error: as gusset_net_glue, OUT_OF_RANGE (a separation that is no finite
 *     number from 0 on).
 * @complexity O(nodes), and a sort of the pairs.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_unglue(const struct gusset_context *context,
                                struct gusset_net *net,
                                const struct gusset_gluing *gluings,
                                size_t count,
                                double separation,
                                uint64_t *moved);

/**
 * Glues a net otherwise; positions stay what they are.
 *
 * On failure the net is as it was.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] net the net.
 * @param gluing NULL for a sheet; it replaces what was glued.
 * @return GUSSET_OK, or an error: as gusset_net_create.
 * @complexity O(nodes + pairs of seams).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_set_gluing(const struct gusset_context *context,
                                    struct gusset_net *net,
                                    const struct gusset_net_gluing *gluing);

/**
 * Tells how a net is glued, and writes its characteristic matrix and its seams.
 *
 * A buffer that is NULL, with capacity 0, is not wanted; the report has the sizes that both need. On
 * failure the report is cleared, and the buffers may be written in part.
 *
 * @param net the net.
 * @param[out] matrix room for matrix_capacity bytes, of which report->matrix_size are written as
 *     gusset_net_gluing has them.
 * @param matrix_capacity see matrix.
 * @param[out] seams room for seam_capacity seams, of which report->seam_count are written.
 * @param seam_capacity see seams.
 * @param[out] report its struct_size set.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     BUFFER_TOO_SMALL, OUT_OF_MEMORY.
 * @complexity O(seams) for seams, O(nodes) for the matrix, else O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_get_gluing(const struct gusset_net *net,
                                    uint8_t *matrix,
                                    size_t matrix_capacity,
                                    struct gusset_seam *seams,
                                    size_t seam_capacity,
                                    struct gusset_net_gluing_report *report);

/**
 * Joins nets side by side to one, in one pass.
 *
 * Each net keeps what it is glued to: links that led back across the direction become seams. Its
 * bridges are kept; each net but the first gets a new one, between it and the one before, behind
 * its own. All can be undone: see gusset_net_split_create.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param nets net_count handles, at least one, of one scalar type; the same one may come
 *     several times.
 * @param net_count see nets.
 * @param options NULL for the defaults.
 * @param[out] joined receives the result, for gusset_net_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, EMPTY_SCENE (no nets),
 *     BAD_STRUCT_SIZE, UNKNOWN_VALUE, MIXED_SCALARS, ORIENTATION_CONFLICT (see turn), SIDES_DIFFER
 *     (sizes that are not to be equalised; or sides to be welded that are apart: the report has
 *     the place and the distance), OUT_OF_RANGE (tolerance; a twist of an open side; rows of
 *     bridges that are to be welded),
 *     CROSSING_CELL, TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes of the result); memory for it, and once more for nets that are enlarged,
 *     turned or flipped.
 * @source Deryagin, "Concatenation".
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_concatenate_create(const struct gusset_context *context,
                                            const struct gusset_net *const *nets,
                                            size_t net_count,
                                            const struct gusset_join_options *options,
                                            struct gusset_net **joined);

/**
 * Takes a net apart at a bridge that runs from side to side: the two nets come back bit for bit as
 * they were joined, unless they were changed since; copies that were made to equalise sizes, and
 * the rows of the bridge, are removed.
 *
 * Of a net that was joined of joined ones, the last bridge is such a one; take nets apart in the
 * reverse order of joining. What is glued across the bridge is cut.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param bridge its number, counted from 0.
 * @param[out] first receives the one, for gusset_net_destroy; NULL on failure.
 * @param[out] second receives the other, likewise.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OVERLAP (first and second
 *     are the same place), NO_SUCH_ELEMENT (no such bridge, or it is within a part of the net
 *     only), CROSSING_CELL, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_split_create(const struct gusset_context *context,
                                      const struct gusset_net *net,
                                      size_t bridge,
                                      struct gusset_net **first,
                                      struct gusset_net **second);

/**
 * A bridge of a net.
 *
 * @param net the net.
 * @param index its number, below bridge_count of gusset_net_gluing_report.
 * @param[out] bridge its struct_size set.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     NO_SUCH_ELEMENT.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_get_bridge(const struct gusset_net *net,
                                    size_t index,
                                    struct gusset_bridge *bridge);

/**
 * Does something else with the cells of a bridge, and gives it other properties. A bridge that has
 * rows of its own cannot be welded: OUT_OF_RANGE.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] net the net.
 * @param index of the bridge, below bridge_count of gusset_net_gluing_report.
 * @param mode GUSSET_BRIDGE_KEEP, GUSSET_BRIDGE_HIDE or GUSSET_BRIDGE_WELD.
 * @param tolerance how far nodes that are welded may be apart, at least 0.
 * @param properties NULL leaves them.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NO_SUCH_ELEMENT,
 *     UNKNOWN_VALUE, OUT_OF_RANGE, SIDES_DIFFER with the place and the distance, CROSSING_CELL,
 *     OUT_OF_MEMORY; the net is then as it was.
 * @complexity O(nodes) if welding begins or ends, or if the net is shared with a copy or a scene;
 *     else O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_set_bridge(const struct gusset_context *context,
                                    struct gusset_net *net,
                                    size_t index,
                                    gusset_bridge_mode mode,
                                    double tolerance,
                                    const struct gusset_bridge_properties *properties);

/**
 * Measures a net: areas, volumes, box, centroid, inertia.
 *
 * Cells that touch a missing node or belong to a hidden bridge are not there. Volumes, centroid and
 * inertia are exact but for rounding for the bilinear patches of the cells (divergence theorem).
 * Where squares or cubes of coordinates overflow, beyond about 1e77, results are infinite or NaN.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param measures a sum of GUSSET_NET_MEASURES_...: only these are computed.
 * @param[out] report its struct_size set.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE (measures), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes), no memory.
 * @threads From any thread; the same bits for any number of threads.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_measure(const struct gusset_context *context,
                                 const struct gusset_net *net,
                                 gusset_net_measures measures,
                                 struct gusset_net_measure_report *report);

/**
 * Tells how plane the cells of a net are: whether it can be clad with plane quads.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param tolerance at least 0, for the count in the report.
 * @param[out] cells a buffer for (rows - 1) * (columns - 1) numbers: of each cell, how far its
 *     corners are from the plane that lies evenly between them, as a part of its longer diagonal;
 *     0 for triangles and less, NaN for cells that are not there.
 * @param capacity its size; NULL and 0 if it is not wanted.
 * @param[out] written receives the number of cells.
 * @param[out] report its struct_size set.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     BUFFER_TOO_SMALL, OUT_OF_RANGE (tolerance), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes), 8 bytes a cell.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_planarity(const struct gusset_context *context,
                                   const struct gusset_net *net,
                                   double tolerance,
                                   double *cells,
                                   size_t capacity,
                                   size_t *written,
                                   struct gusset_net_planarity_report *report);

/**
 * Makes the mesh of a net.
 *
 * Cells with a missing corner and those of hidden bridges are left out; glued corners are one, so
 * that closed nets become closed meshes; faces are counter-clockwise as the net's are. A mesh
 * without faces is no failure. The grid of a range image becomes the mesh of what was seen by
 * triangles, fill_corners and max_edge_ratio.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param options NULL for the defaults.
 * @param[out] mesh receives the result, for gusset_net_mesh_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE, OUT_OF_RANGE, TOO_LARGE (2^32 - 1 corners and more), OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(nodes), and O(w log w) for w cells whose opposite sides are glued.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_mesh_create(const struct gusset_context *context,
                                     const struct gusset_net *net,
                                     const struct gusset_net_mesh_options *options,
                                     struct gusset_net_mesh **mesh);

/**
 * The origins of the mesh of a net: its one input is the net.
 *
 * A vertex has the first of its nodes, a corner the node of its own face's cell, which on either side
 * of a seam is another, so that an image need not run back there, and a face its cell.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh the mesh.
 * @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(corners); 16 bytes for each vertex, corner and face.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_mesh_origins_create(const struct gusset_context *context,
                                             const struct gusset_net_mesh *mesh,
                                             struct gusset_origins **origins);

/**
 * Destroys the mesh of a net; NULL is allowed.
 *
 * @param[in,out] mesh the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_net_mesh_destroy(struct gusset_net_mesh *mesh);

/**
 * Lends the mesh, valid until it is destroyed.
 *
 * @param mesh the mesh.
 * @param[out] view its struct_size set.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_mesh_get_mesh(const struct gusset_net_mesh *mesh,
                                       struct gusset_mesh_view *view);

/**
 * Lends what became what.
 *
 * @param mesh the mesh.
 * @param[out] maps receives the maps; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: those of gusset_net_mesh_get_mesh.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_mesh_get_view(const struct gusset_net_mesh *mesh,
                                       struct gusset_net_mesh_view *maps);

/**
 * Makes the net of heights over a grid: x = origin + j spacing, y = origin + i spacing, z = origin
 * + height.
 *
 * Missing heights become missing nodes; faces are counter-clockwise from above, whichever way rows
 * and columns run.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param heights the heights.
 * @param[out] net receives it, for gusset_net_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     NET_TOO_SMALL, TOO_LARGE, UNKNOWN_VALUE, BAD_STRIDE, SIZE_OVERFLOW, OUT_OF_RANGE (spacing,
 *     origin), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_from_heights_create(const struct gusset_context *context,
                                             const struct gusset_heights *heights,
                                             struct gusset_net **net);

/**
 * Finds rows and columns in a mesh: cells in a rectangle, which may be closed round, with fans of
 * triangles round a pole at its first and last row, or either.
 *
 * Vertices and their bits are kept. Rows of quads run as the first quad says, and round if only one
 * direction is closed. If cells are two triangles, the grid lends the first of the two. Where
 * several pairings of triangles make a grid, as if all diagonals run one way, one is taken, always
 * the same for the same mesh. For a torus it may be one that closes with a shift, with other rows
 * and columns than the torus was made from. Tubes and tori whose diagonals run without any rule may
 * be refused, and so are fans of fewer than six triangles at the pole of an open sheet; at least one
 * row of quads is needed.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh see gusset_mesh_view.
 * @param cells GUSSET_GRID_CELLS_QUADS or GUSSET_GRID_CELLS_TRIANGLES.
 * @param face a face of the component that is meant, for quads; UINT32_MAX: the mesh must be one
 *     grid.
 * @param[out] grid receives the result, for gusset_net_grid_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of the view, UNKNOWN_VALUE (cells, or a face beside
 *     triangles), NO_GRID with a face that shows it, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(H log d) for H half-edges and vertices of degree d; for closed nets of triangles
 *     whose poles do not show by their degrees some attempts of that.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_grid_create(const struct gusset_context *context,
                                     const struct gusset_mesh_view *mesh,
                                     gusset_grid_cells cells,
                                     uint32_t face,
                                     struct gusset_net_grid **grid);

/**
 * Destroys a grid; NULL is allowed.
 *
 * @param[in,out] grid the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_net_grid_destroy(struct gusset_net_grid *grid);

/**
 * The net that was found.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param grid the grid.
 * @param[out] net receives it, for gusset_net_destroy; it outlives the grid. NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_grid_net_create(const struct gusset_context *context,
                                         const struct gusset_net_grid *grid,
                                         struct gusset_net **net);

/**
 * Lends where the net was found.
 *
 * @param grid the grid.
 * @param[out] view receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_grid_get_view(const struct gusset_net_grid *grid,
                                       struct gusset_net_grid_view *view);

/**
 * Makes the net at a time on the way from one net to another of the same rows, columns, type and
 * gluing.
 *
 * Two nodes that have the same bits as each other in both nets, as glued ones have, have the same
 * bits as each other in it. It is glued as the first, and has its bridges; a node missing in one
 * of them is missing between.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param first the net at 0.
 * @param second the net at 1.
 * @param t the time, from 0 for the bits of the first to 1 for those of the second.
 * @param path one of GUSSET_MORPH_...
 * @param[out] between receives the net, for gusset_net_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE (path),
 *     OUT_OF_RANGE (t), SIDES_DIFFER (other rows or columns: see gusset_net_copy_options),
 *     MIXED_SCALARS, GLUINGS_DIFFER with the node, ORIENTATION_CONFLICT (one is reversed),
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes).
 * @source Horn 1987, for the rotation.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_morph_create(const struct gusset_context *context,
                                      const struct gusset_net *first,
                                      const struct gusset_net *second,
                                      double t,
                                      gusset_morph_path path,
                                      struct gusset_net **between);

/**
 * Computes the unit normal of every node of a net.
 *
 * Columns go with the fingers of the right hand towards rows, and the normal with the thumb; the
 * other way for nets that are reversed. Nodes that are glued get the same bits, poles and seams
 * their true normals; at rims, beside missing nodes and beside hidden bridges the cells that are
 * there decide.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param[out] x receives the first coordinates of the normals, float or double as the net's are,
 *     rows x columns numbers, row after row without gaps, aligned; the three buffers are apart
 *     from each other and from the net's own.
 * @param[out] y receives the second ones.
 * @param[out] z receives the third ones.
 * @param capacity the numbers that each has room for.
 * @param[out] missing_count receives the number of nodes that have no normal and get zeros:
 *     missing ones, and those whose cells have no area or cancel out; may be NULL.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BUFFER_TOO_SMALL, OVERLAP,
 *     OUT_OF_MEMORY, CANCELLED (the buffers are filled in part).
 * @complexity O(nodes); a bit a node, and memory for the glued nodes.
 * @threads From any thread; the same bits for any number of threads.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_normals(const struct gusset_context *context,
                                 const struct gusset_net *net,
                                 void *x,
                                 void *y,
                                 void *z,
                                 size_t capacity,
                                 uint64_t *missing_count);

/**
 * Moves the nodes of a net as little as possible, in the sum of squares, so that all cells are
 * plane: facing by plane tiles.
 *
 * Glued nodes stay one point. Cells of three corners and less, hidden ones and those with missing
 * nodes do not count. The result is a local least: no plane net near it is nearer to the given
 * one, but for the accuracy of the steps.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] net the net.
 * @param options NULL for the defaults.
 * @param[out] report receives what was done, its struct_size set; that the steps did not converge
 *     is no error.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     OUT_OF_RANGE (tolerance), UNKNOWN_VALUE (keep_boundary, a byte of fixed), SIZE_OVERFLOW
 *     (fixed_count is too small), OUT_OF_MEMORY, CANCELLED; the net is then unchanged.
 * @complexity For each step O(n^1.5) operations and O(n log n) memory for n cells.
 * @threads One thread; the same bits always.
 * @source Deryagin, "Closures"; Liu et al. 2006.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_planarise(const struct gusset_context *context,
                                   struct gusset_net *net,
                                   const struct gusset_planarise_options *options,
                                   struct gusset_planarise_report *report);

/**
 * Makes a net of a standard shape, centred at the origin, its axis along z.
 *
 * Nodes that are one point have the same bits; closed surfaces have their faces counter-clockwise
 * seen from outside.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param primitive what is wanted.
 * @param[out] net receives it, for gusset_net_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE, OUT_OF_RANGE (a measure that is not positive or beyond the scalar type, too
 *     few rows, columns, sides or cells), TOO_LARGE, SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes); 12 or 24 bytes a node, and 1/4 for boxes.
 * @source Deryagin, "Closures of nets".
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_primitive_create(const struct gusset_context *context,
                                          const struct gusset_net_primitive *primitive,
                                          struct gusset_net **net);

/**
 * Makes a net of `rows` x `columns` nodes that are spread evenly over the rows and columns of
 * another; first and last ones stay, and new nodes that fall on old ones have their bits.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net glued along whole sides only, without bridges; the new one is glued in the same way,
 *     glued nodes have equal bits.
 * @param rows of the result, at least 2.
 * @param columns of the result, at least 2.
 * @param interpolation one of GUSSET_INTERPOLATION_...
 * @param[out] resampled receives the net, for gusset_net_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, UNKNOWN_VALUE, NET_TOO_SMALL, TOO_LARGE,
 *     GLUED_INSIDE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes of both).
 * @threads From any thread; the same bits for any number of threads.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_resample_create(const struct gusset_context *context,
                                         const struct gusset_net *net,
                                         size_t rows,
                                         size_t columns,
                                         gusset_interpolation interpolation,
                                         struct gusset_net **resampled);

/**
 * Makes a net of the rows and columns of another that matter most: rows, and then columns, are
 * left out, always the one whose loss costs least, as long as the tolerance allows.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net glued along whole sides only, without bridges.
 * @param tolerance at least 0, may be infinite; nodes are at most half of it away from the
 *     segments that replace their columns, and as much from those that replace their rows.
 * @param[out] rows receive the indices of what was kept, as many as the new net has; each has room
 *     for as many as the old net has; NULL if not wanted.
 * @param[out] columns see rows.
 * @param[out] deviation receives what was reached; may be NULL.
 * @param[out] decimated receives the net; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_RANGE, GLUED_INSIDE,
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity About O(nodes x log rows).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_decimate_create(const struct gusset_context *context,
                                         const struct gusset_net *net,
                                         double tolerance,
                                         uint32_t *rows,
                                         uint32_t *columns,
                                         double *deviation,
                                         struct gusset_net **decimated);

/**
 * Makes nets of 2^k + 1 rows and columns, for levels of detail: the finest first, each of the
 * others every second row and column of the one before, bit for bit.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net glued along whole sides only, without bridges; if its sizes are 2^k + 1 already, the
 *     first level is a copy, else it is resampled to the next sizes.
 * @param interpolation as for gusset_net_resample_create.
 * @param[out] levels receives the nets, each for gusset_net_destroy; all NULL on failure.
 * @param capacity how many it has room for; GUSSET_PYRAMID_LEVELS is always enough.
 * @param[out] count receives how many there are, also with BUFFER_TOO_SMALL, which capacity 0
 *     gives too.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE,
 *     BUFFER_TOO_SMALL, TOO_LARGE, GLUED_INSIDE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes), memory for 4/3 of the first.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_pyramid_create(const struct gusset_context *context,
                                        const struct gusset_net *net,
                                        gusset_interpolation interpolation,
                                        struct gusset_net **levels,
                                        size_t capacity,
                                        size_t *count);

/**
 * Makes an empty scene.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[out] scene receives it, for gusset_scene_destroy.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_create(const struct gusset_context *context,
                                  struct gusset_scene **scene);

/**
 * Destroys a scene; NULL is allowed.
 *
 * @param[in,out] scene the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_scene_destroy(struct gusset_scene *scene);

/**
 * Adds a net as it is now, or an empty group, in no group yet.
 *
 * What is done to the handle of the net later does not change the scene.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] scene the scene.
 * @param net the net; NULL for a group.
 * @param[out] entry receives its index.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY.
 * @complexity O(1), and O(nodes) for a net in the caller's memory.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_add(const struct gusset_context *context,
                               struct gusset_scene *scene,
                               const struct gusset_net *net,
                               uint32_t *entry);

/**
 * Puts an entry into a group, behind what is in it; again, if it is in it already.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] scene the scene.
 * @param group the index of the group.
 * @param child the index of the entry.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NO_SUCH_ELEMENT (no such
 *     entry, or group is a net), SCENE_CYCLE, OUT_OF_MEMORY.
 * @complexity O(1) for an entry without children or a group in no group; at most O(entries below
 *     the one or above the other, whichever are fewer).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_add_child(const struct gusset_context *context,
                                     struct gusset_scene *scene,
                                     uint32_t group,
                                     uint32_t child);

/**
 * Takes an entry out of a group: the first one, if it is in it several times.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] scene the scene.
 * @param group the index of the group.
 * @param child the index of the entry.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NO_SUCH_ELEMENT, also if it
 *     is not in the group.
 * @complexity O(children of the group + groups of the child).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_remove_child(const struct gusset_context *context,
                                        struct gusset_scene *scene,
                                        uint32_t group,
                                        uint32_t child);

/**
 * Removes an entry from the scene and from all groups; what was in a group stays.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] scene the scene.
 * @param entry its index.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NO_SUCH_ELEMENT.
 * @complexity O(children of its groups + groups of its children).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_remove(const struct gusset_context *context,
                                  struct gusset_scene *scene,
                                  uint32_t entry);

/**
 * Changes an entry: its net, its transform, its visibility.
 *
 * On failure the entry is as it was.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] scene the scene.
 * @param entry its index.
 * @param changes what changes.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE (visibility), NO_SUCH_ELEMENT with the entry (also for a net in place of a
 *     group), OUT_OF_RANGE (the transform), OUT_OF_MEMORY.
 * @complexity O(1), and O(nodes) for a net in the caller's memory.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_set_entry(const struct gusset_context *context,
                                     struct gusset_scene *scene,
                                     uint32_t entry,
                                     const struct gusset_scene_changes *changes);

/**
 * What an entry is.
 *
 * @param scene the scene.
 * @param entry its index.
 * @param[out] report its struct_size set.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     NO_SUCH_ELEMENT.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_get_entry(const struct gusset_scene *scene,
                                     uint32_t entry,
                                     struct gusset_scene_entry_report *report);

/**
 * The net of an entry, as a handle that shares its memory until it is changed.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param scene the scene.
 * @param entry its index.
 * @param[out] net receives it, for gusset_net_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NO_SUCH_ELEMENT, also for a
 *     group, OUT_OF_MEMORY.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_net_create(const struct gusset_context *context,
                                      const struct gusset_scene *scene,
                                      uint32_t entry,
                                      struct gusset_net **net);

/**
 * The entries in a group, in order.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param scene the scene.
 * @param group its index.
 * @param[out] children room for capacity indices, or NULL with capacity 0 to ask for their number.
 * @param capacity see children.
 * @param[out] written receives it.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NO_SUCH_ELEMENT, also for a
 *     net, BUFFER_TOO_SMALL.
 * @complexity O(children).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_get_children(const struct gusset_context *context,
                                        const struct gusset_scene *scene,
                                        uint32_t group,
                                        uint32_t *children,
                                        size_t capacity,
                                        size_t *written);

/**
 * How much is in a scene.
 *
 * @param scene the scene.
 * @param[out] report its struct_size set.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     OUT_OF_MEMORY.
 * @complexity O(entries + children), however many instances there are.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_get_report(const struct gusset_scene *scene,
                                      struct gusset_scene_report *report);

/**
 * All instances and where they are: each behind the group that it is in, children in order.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param scene the scene.
 * @param[out] instances room for capacity of them, or NULL with capacity 0 to ask for their
 *     number.
 * @param capacity see instances.
 * @param[out] written receives it.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BUFFER_TOO_SMALL, TOO_LARGE
 *     (more than 2^24, as sharing can make of few entries: refused before any is looked at),
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity O(entries + instances).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_world_transforms(const struct gusset_context *context,
                                            const struct gusset_scene *scene,
                                            struct gusset_scene_instance *instances,
                                            size_t capacity,
                                            size_t *written);

/**
 * Joins the nets of all visible instances, where they are in the space of the scene, to one.
 *
 * Nets under transforms that mirror are flipped where the others would be opposed to them, as if
 * options said turn. gusset_scene_unflatten_create is the inverse.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param scene the scene.
 * @param options NULL for each net below the one before, with hidden bridges.
 * @param[out] net receives the result, for gusset_net_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: EMPTY_SCENE (no visible net), TOO_LARGE (more than 2^24
 *     instances, or nodes), and those of gusset_net_concatenate_create.
 * @complexity O(entries + instances + nodes).
 * @source Deryagin, scenes as "a single whole".
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_flatten_create(const struct gusset_context *context,
                                          const struct gusset_scene *scene,
                                          const struct gusset_join_options *options,
                                          struct gusset_net **net);

/**
 * A scene of the nets between the bridges of a direction that run from side to side and were made
 * last, all at once: the inverse of gusset_scene_flatten_create, in one group (entry 0).
 *
 * Nets come back as they are in the space of the flat one, bit for bit; copies that were made to
 * equalise sizes are removed.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param direction GUSSET_DIRECTION_..., that of the bridges.
 * @param[out] scene receives it, for gusset_scene_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE,
 *     CROSSING_CELL, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_scene_unflatten_create(const struct gusset_context *context,
                                            const struct gusset_net *net,
                                            gusset_direction direction,
                                            struct gusset_scene **scene);

/**
 * Moves the nodes of bridges that are their own, and parts that are free, to the equilibrium of
 * the bridges' properties.
 *
 * The sum of these energies becomes least, for each line of links across a bridge: tension times
 * its length, its nodes becoming evenly spaced, or in a tube times the area of the film;
 * elasticity / 2 (l - r)^2 / r for each link of length l and rest length r; stiffness / 2 h^3
 * times the squared second differences, h being the mean rest length, lines leaving parts in the
 * direction of these. A bridge of infinite stiffness and both its sides are one body. Bridges
 * within a part do not count, nor do those across the direction of the last. If of parts that
 * bridges join none is held, the first is. What is found is a local minimum, and the energy never
 * grows on the way.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] net the net.
 * @param options NULL for the defaults.
 * @param[out] report receives what was done, its struct_size set; that the steps did not converge
 *     is no error.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE (a byte of free), SIZE_OVERFLOW (free_count is too small), SIDES_DIFFER (the
 *     reference has another size), OUT_OF_RANGE (tolerance, rest_ratio; a property that is
 *     negative, NaN or infinite, with the bridge), NO_SUCH_ELEMENT (a bridge lies within another),
 *     OUT_OF_MEMORY, CANCELLED; the net is then unchanged.
 * @complexity For each step O(n^1.5) operations and O(n log n) memory for n inner nodes, and
 *     O(nodes).
 * @threads One thread; the same bits always.
 * @source Deryagin, "Concatenation"; Schek 1974; Pinkall and Polthier 1993.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_settle(const struct gusset_context *context,
                                struct gusset_net *net,
                                const struct gusset_settle_options *options,
                                struct gusset_settle_report *report);

/**
 * Makes a stream of a net: its coordinates, what is glued to what, its bridges.
 *
 * QUANTISED and LOSSLESS do not store nodes that are glued to others; decoding gives them the same
 * bits (LOSSLESS stores all if the net's differ). QUANTISED gives nodes with a coordinate that is
 * NaN or infinite three NaN. Method: linear prediction with weights fitted to each block, and a
 * range coder with adaptive models.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param options NULL for 14 bits a coordinate.
 * @param[out] stream receives the bytes, for gusset_stream_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE, OUT_OF_RANGE
 *     (bits; QUANTISED: a coordinate above a quarter of the largest double), OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(nodes), with blocks coded by the context's threads; the same bytes for any number
 *     of them.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_encode_create(const struct gusset_context *context,
                                       const struct gusset_net *net,
                                       const struct gusset_stream_options *options,
                                       struct gusset_stream **stream);

/**
 * Lends the bytes of a stream.
 *
 * @param stream the stream.
 * @param[out] view receives the bytes; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_stream_get_view(const struct gusset_stream *stream,
                                     struct gusset_stream_view *view);

/**
 * Destroys a stream; NULL is allowed.
 *
 * @param[in,out] stream the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_stream_destroy(struct gusset_stream *stream);

/**
 * Reads the header of a stream.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param data its first 128 bytes, or more.
 * @param size how many there are.
 * @param[out] report its struct_size set.
 * @return GUSSET_OK, or an error: BAD_STREAM with the byte, NULL_ARGUMENT, MISALIGNED_ARGUMENT,
 *     BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_stream_inspect(const struct gusset_context *context,
                                    const void *data,
                                    size_t size,
                                    struct gusset_stream_report *report);

/**
 * Makes the net of a stream.
 *
 * A stream that is damaged, cut off or forged does no harm; memory is asked for only as far as one
 * of its size can need it: 4096 nodes a byte at most. That is little of a file of one's own, and may
 * be much of a stranger's: 96 KiB a byte.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param data all its bytes, at any alignment.
 * @param size how many.
 * @param node_limit a net of more nodes is refused before memory is asked for; 0 for no other limit
 *     than that by the size.
 * @param[out] net receives the net, for gusset_net_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STREAM with the byte,
 *     TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes), with blocks decoded by the context's threads.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_decode_create(const struct gusset_context *context,
                                       const void *data,
                                       size_t size,
                                       uint64_t node_limit,
                                       struct gusset_net **net);

/**
 * Begins to decode a stream that arrives in pieces.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param node_limit a net of more nodes is refused, as its memory is taken before all of the
 *     stream is there; 0 for no limit but the library's, 2^31 - 1.
 * @param[out] decoder receives the decoder, for gusset_stream_decoder_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_stream_decoder_create(const struct gusset_context *context,
                                           uint64_t node_limit,
                                           struct gusset_stream_decoder **decoder);

/**
 * Gives a decoder the next bytes of its stream, any number of them.
 *
 * After a failure every call fails alike, but OUT_OF_MEMORY leaves the decoder as it was.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] decoder the decoder.
 * @param data the bytes, at any alignment.
 * @param size how many.
 * @param[out] rows_done receives how many rows are complete, those of all blocks so far; NULL if
 *     it is not wanted.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STREAM with the byte,
 *     TOO_LARGE, OUT_OF_MEMORY.
 * @complexity O(bytes + nodes of the blocks that they complete).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_stream_decoder_push(const struct gusset_context *context,
                                         struct gusset_stream_decoder *decoder,
                                         const void *data,
                                         size_t size,
                                         size_t *rows_done);

/**
 * Makes the net of the rows that a decoder has so far, at least two: open on all sides, without
 * gluing and bridges, for a preview.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param decoder the decoder.
 * @param[out] net receives it.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NET_TOO_SMALL if there are
 *     fewer rows, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_stream_decoder_preview_create(const struct gusset_context *context,
                                                   const struct gusset_stream_decoder *decoder,
                                                   struct gusset_net **net);

/**
 * Makes the net of a decoder whose stream is complete, and leaves the decoder empty, as if nothing
 * had been pushed.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] decoder the decoder.
 * @param[out] net receives it.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STREAM if the stream is
 *     not complete, or what pushing failed with.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_stream_decoder_finish_create(const struct gusset_context *context,
                                                  struct gusset_stream_decoder *decoder,
                                                  struct gusset_net **net);

/**
 * Destroys a decoder; NULL is allowed.
 *
 * @param[in,out] decoder the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_stream_decoder_destroy(struct gusset_stream_decoder *decoder);

/**
 * Moves all nodes of a net by operations, the first one first, composed to one matrix and applied
 * in one pass, in place.
 *
 * The arithmetic is that of the net's scalar type; nodes that are glued and have equal bits keep
 * them equal; missing nodes stay missing (and may lose coordinates that were finite). If the
 * operations together mirror (odd numbers of reflections) the surface would be turned inside out:
 * the net's flag `reversed` changes then, so that faces look outwards as before. A cancel is heard
 * before the first node is moved; whatever the error, none is moved.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param[in,out] net the net.
 * @param operations `count` of them, at any alignment; 0 for none.
 * @param count see operations.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, UNKNOWN_VALUE (kind, axis), OUT_OF_RANGE (a
 *     number that is not finite, an axis of length 0, a product that overflows), FIELD_UNDEFINED
 *     with the first node that would overflow, SIZE_OVERFLOW, OUT_OF_MEMORY (a net that shares its
 *     memory), CANCELLED.
 * @complexity O(nodes), no memory.
 * @threads The same bits for any number of threads.
 * @source Deryagin, T, R, S, C.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_transform(const struct gusset_context *context,
                                   struct gusset_net *net,
                                   const struct gusset_operation *operations,
                                   size_t count);

/**
 * Checks that glued nodes lie together, and looks for what is suspicious.
 *
 * What it finds is no error.
 *
 * Two missing nodes are no violation.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the net.
 * @param tolerance how far two nodes may be apart, at least 0; for 0 their coordinates must be
 *     equal (0 and -0 are).
 * @param[out] validation receives the result, for gusset_net_validation_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_RANGE (tolerance),
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes), and a sort of the findings.
 * @source Deryagin, "Non-spatial operations".
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_validation_create(const struct gusset_context *context,
                                           const struct gusset_net *net,
                                           double tolerance,
                                           struct gusset_net_validation **validation);

/**
 * Lends the findings.
 *
 * @param validation the validation.
 * @param[out] view receives the findings; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(log findings).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_net_validation_get_view(const struct gusset_net_validation *validation,
                                             struct gusset_net_validation_view *view);

/**
 * Destroys a validation; NULL is allowed.
 *
 * @param[in,out] validation the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_net_validation_destroy(struct gusset_net_validation *validation);

/**
 * What a status means, in a few English words.
 *
 * Never NULL; static.
 *
 * @param status any number; for one that is no status, "unknown status".
 * @return a static string, never NULL.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API const char *gusset_status_text(int32_t status);

/**
 * Builds the index of one sheet or several, which together are one surface.
 *
 * The greatest absolute coordinate of each is from 1e-30 to 1e37, or 0, control points included:
 * boxes are in single precision.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param sheets count handles, none NULL, the array at any alignment; they may be destroyed
 *     afterwards.
 * @param count see sheets.
 * @param options NULL for the defaults.
 * @param[out] surface receives the result, for gusset_surface_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT (of a handle with its number, as
 *     GUSSET_ELEMENT_ITEM), MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE, UNKNOWN_VALUE, EMPTY_MESH
 *     without sheets, OUT_OF_RANGE with the sheet (as GUSSET_ELEMENT_ITEM) whose coordinates are
 *     too large or too small, or for the tolerance; SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes), about 7 bytes a node, and 0.7 with cones; threads.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_create(const struct gusset_context *context,
                                    const struct gusset_sheet *const *sheets,
                                    size_t count,
                                    const struct gusset_surface_options *options,
                                    struct gusset_surface **surface);

/**
 * Frees a surface; NULL is allowed.
 *
 * Results that were found with it stay.
 *
 * @param[in,out] surface the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_surface_destroy(struct gusset_surface *surface);

/**
 * The curves, lent until they are destroyed.
 *
 * @param paths the paths.
 * @param[out] view struct_size set by the caller; all else is overwritten.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_paths_get_view(const struct gusset_surface_paths *paths,
                                            struct gusset_surface_paths_view *view);

/**
 * Frees curves; NULL is allowed.
 *
 * @param[in,out] paths the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_surface_paths_destroy(struct gusset_surface_paths *paths);

/**
 * Finds the cells that have a point within a radius of a query: the paper's region, with its
 * logical scale.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param surface the surface.
 * @param query x, y, z, up to 1e150, at any alignment.
 * @param radius at least 0; INFINITY: all cells.
 * @param[out] cells receives all cells that have such a point, and no others but such as come
 *     within the tolerance of the radius or could not be decided in bounded work; for
 *     gusset_surface_cells_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NOT_FINITE, OUT_OF_RANGE
 *     (radius; a coordinate beyond 1e150), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(cells found, and one bit a cell).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_region_create(const struct gusset_context *context,
                                           const struct gusset_surface *surface,
                                           const double *query,
                                           double radius,
                                           struct gusset_surface_cells **cells);

/**
 * Finds the pairs of cells of two surfaces that may be as near to each other as `within`: all that
 * are, and few others.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param surface the surface.
 * @param other the other surface.
 * @param within a length, finite; 0: cells that may meet.
 * @param[out] cells receives the pairs, for gusset_surface_cells_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_RANGE (within),
 *     TOO_LARGE above 2^26 pairs, OUT_OF_MEMORY, CANCELLED.
 * @complexity In proportion to the pairs, and some for each level of the indices; 24 bytes a pair.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_cell_pairs_create(const struct gusset_context *context,
                                               const struct gusset_surface *surface,
                                               const struct gusset_surface *other,
                                               double within,
                                               struct gusset_surface_cells **cells);

/**
 * Lends the cells until they are destroyed.
 *
 * @param cells the cells.
 * @param[out] view struct_size set by the caller; all else is overwritten.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_cells_get_view(const struct gusset_surface_cells *cells,
                                            struct gusset_surface_cells_view *view);

/**
 * Frees cells; NULL is allowed.
 *
 * @param[in,out] cells the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_surface_cells_destroy(struct gusset_surface_cells *cells);

/**
 * Draws the contours of a function on a surface: sections by planes, contours of values at nodes,
 * or isophotes. The curves come in the order of the levels and of their lowest cells.
 *
 * The function increases to the left of a curve, seen from where the normals point to; angles
 * decrease to the left. A section runs along the cross product of the direction and the normal.
 *
 * Every curve is found, also one within a cell. On a closed surface all curves are closed. Curves
 * no larger than the tolerance are listed as unresolved.
 *
 * Sections: a corner on a plane counts as above it. So a plane that touches the surface in corners
 * of cells from below, by its direction, gives no curve there and nothing unresolved. A plane that
 * touches the surface from above gives closed curves round the contact, however narrow: along a row
 * of corners, a curve there and back. If a plane touches or contains the surface elsewhere, so that
 * curves cannot be told within rounding, the cells are listed as unresolved.
 *
 * Isophotes: at the angles 0 and pi there are points in place of curves, each a path of one point.
 * Where normals jump between cells (patches, GUSSET_SCHEME_FOUR_POINT), curves run along the side
 * between them. Poles that may have the angle are listed as unresolved. Angles are of order three,
 * as normals are; contours of the cosines at the nodes are of order four.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param surface the surface.
 * @param function the function; struct_size set by the caller.
 * @param levels count of them, rising, at any alignment: the values of the function on the curves.
 *     Angles are from 0 to pi, or to pi / 2 if normals are unsigned.
 * @param count see levels.
 * @param options NULL for the defaults.
 * @param[out] paths receives the curves, for gusset_surface_paths_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE, OUT_OF_RANGE (numbers that are not finite, a direction of 0, levels that do
 *     not rise, angles, chord, points), SIZE_OVERFLOW, also if there are too few values, TOO_LARGE,
 *     also if there are too many, NOT_FINITE with the number of the value, OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity About O(count + cells that are crossed); O(values) for values, and O(cells) once for
 *     angles, for the cones of normals; threads.
 * @source Leus, "Carcasses on smooth surfaces", tasks b and d.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_contours_create(const struct gusset_context *context,
                                             const struct gusset_surface *surface,
                                             const struct gusset_contour_function *function,
                                             const double *levels,
                                             size_t count,
                                             const struct gusset_contour_options *options,
                                             struct gusset_surface_paths **paths);

/**
 * Finds the place whose normal makes the angle with a direction that is nearest to a given one,
 * proved to 1e-9.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param surface the surface.
 * @param direction x, y, z, not 0, at any alignment.
 * @param angle in radians, 0 to pi, or to pi / 2 if normals are unsigned.
 * @param unsigned_normals 1: a normal and its opposite are the same; else 0.
 * @param[out] report struct_size set by the caller; all else is overwritten.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE, OUT_OF_RANGE, OUT_OF_MEMORY, CANCELLED.
 * @complexity About O(cells that come near to the angle), and O(cells) once, for the cones of
 *     normals; threads.
 * @source Leus, task b.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_nearest_angle(const struct gusset_context *context,
                                           const struct gusset_surface *surface,
                                           const double *direction,
                                           double angle,
                                           uint32_t unsigned_normals,
                                           struct gusset_nearest_angle_report *report);

/**
 * Draws a curve through points as surfaces are drawn through their nodes: a cubic from each to the
 * next, of fourth order.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param nodes x, y, z of count points, at any alignment, finite; at least 2, or if closed 4, of
 *     which the last is the first one again: closed paths of a surface do not repeat it, and need
 *     it added.
 * @param count see nodes.
 * @param closed 0 or 1.
 * @param scheme GUSSET_SCHEME_...
 * @param[out] curve receives the result, for gusset_curve_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT (curve), NET_TOO_SMALL with
 *     too few points, UNKNOWN_VALUE, NOT_FINITE with the node, CURVE_NOT_CLOSED, TOO_LARGE,
 *     SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(count).
 * @source Leus, "Carcasses on smooth surfaces": points are the surface of a curve.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_through_create(const struct gusset_context *context,
                                          const double *nodes,
                                          size_t count,
                                          uint32_t closed,
                                          gusset_scheme scheme,
                                          struct gusset_curve **curve);

/**
 * A coordinate curve of a sheet, exactly: a segment for each cell.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param sheet the sheet.
 * @param along GUSSET_ALONG_...; along rows u is the parameter, along columns v is.
 * @param parameter 0 to the number of cells that way; whole numbers are lines of nodes.
 * @param[out] curve receives the result, for gusset_curve_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE, OUT_OF_RANGE
 *     (parameter), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(cells along the curve).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_curve_create(const struct gusset_context *context,
                                        const struct gusset_sheet *sheet,
                                        gusset_sheet_direction along,
                                        double parameter,
                                        struct gusset_curve **curve);

/**
 * Where two curves in space come as near to each other as `within`: each place where their
 * distance is least, once.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param other the other curve.
 * @param within a length, 0 or more and finite; below 1e-12 of the curves' size that is taken.
 * @param[out] places receives the places on the first curve, those on the other, and the points of
 *     the first; overlaps are parts where the curves stay as near, or cannot be told apart;
 *     undecided is 1 if something was given up that may be near enough. For gusset_places_destroy;
 *     NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, EMPTY_CURVE, OUT_OF_RANGE
 *     (within), OUT_OF_MEMORY, CANCELLED.
 * @complexity Bounded work for each pair of segments whose boxes are near.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_near_misses_create(const struct gusset_context *context,
                                              const struct gusset_curve *curve,
                                              const struct gusset_curve *other,
                                              double within,
                                              struct gusset_places **places);

/**
 * Where a curve in space comes as near to a line, ray or segment as `within`.
 *
 * The others among the places have segment 0, and the line's own parameter as t.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param line one, at any alignment.
 * @param within a distance, at least 0.
 * @param[out] places receives the result, for gusset_places_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: those of gusset_curve_near_misses_create; also OUT_OF_RANGE for
 *     a line that is not finite or has no direction.
 * @complexity Bounded work for each segment whose box meets the line.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_line_near_misses_create(const struct gusset_context *context,
                                                   const struct gusset_curve *curve,
                                                   const struct gusset_line *line,
                                                   double within,
                                                   struct gusset_places **places);

/**
 * Finds the nearest points of a surface and a line, a plane, a curve or another surface.
 *
 * If several pairs of points are equally near, the result is always the same pair. Where much of
 * the surface is equally near, as a tube is to its axis, the search ends without a proof and says
 * so. Where a plane meets the surface, the result is a point of the section.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param surface the surface.
 * @param target the object; struct_size set by the caller.
 * @param tolerance a length, to which the distance is proved, finite; 0: the tolerance of the
 *     surface, or the greater one of two surfaces.
 * @param[out] report struct_size set by the caller; all else is overwritten.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE (kind, reserved), OUT_OF_RANGE for a line that is not finite, has no direction
 *     or ends before it begins, for a plane that is not finite, too large or without a direction,
 *     for a curve that is too large, and for the tolerance; EMPTY_CURVE, OUT_OF_MEMORY, CANCELLED.
 * @complexity About O(log cells), and at most 50,000 pairs of pieces.
 * @source Ours; Leus, "Carcasses on smooth surfaces", tasks c to e, where there is no intersection.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_distance(const struct gusset_context *context,
                                      const struct gusset_surface *surface,
                                      const struct gusset_target *target,
                                      double tolerance,
                                      struct gusset_distance_report *report);

/**
 * Points, derivatives, normals and curvatures at places.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param surface the surface.
 * @param places count of them, at any alignment.
 * @param count see places.
 * @param[out] results room for count; all 0 on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, SIZE_OVERFLOW, UNKNOWN_VALUE
 *     (reserved), NO_SUCH_ELEMENT with the first place that the surface does not have: no such
 *     sheet or cell, parameters that are not 0 to 1; OUT_OF_MEMORY, CANCELLED.
 * @complexity O(1) a place, at a pole O(cells round it); threads.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_evaluate(const struct gusset_context *context,
                                      const struct gusset_surface *surface,
                                      const struct gusset_surface_place *places,
                                      size_t count,
                                      struct gusset_surface_point *results);

/**
 * The places of parameters of a whole sheet: node (i, j) has u = i and v = j.
 *
 * Closed directions are counted round; what is beyond an open side is on it. The other way the
 * parameters of a place are row + u and column + v.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param surface the surface.
 * @param sheet its number, counted from 0.
 * @param parameters u, v of each, packed, at any alignment.
 * @param count see places.
 * @param[out] places room for count; all 0 on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, SIZE_OVERFLOW,
 *     NO_SUCH_ELEMENT with the first pair that is not finite, or if there is no such sheet;
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity O(1) each.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_locate(const struct gusset_context *context,
                                    const struct gusset_surface *surface,
                                    uint32_t sheet,
                                    const double *parameters,
                                    size_t count,
                                    struct gusset_surface_place *places);

/**
 * Finds where lines, rays, segments and a curve in space meet a surface; for each line what a call
 * with it alone gives.
 *
 * A point on a side between cells, on one that sheets share, at a joint of the curve's segments, or
 * at a pole is found once, and none is missed: where a line or the curve touches the surface or runs
 * in it, a hit says from where to where.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param surface the surface.
 * @param lines count of them, at any alignment; NULL for none.
 * @param count see lines.
 * @param curve of degree 7 at most; NULL for none. Its hits come after those of the lines, in the
 *     order of the curve.
 * @param selection GUSSET_HITS_...
 * @param[out] hits receives the result, for gusset_surface_hits_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE, OUT_OF_RANGE
 *     with the line that is not finite, has no direction, or ends before it begins, or for a degree;
 *     EMPTY_CURVE, SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
 * @complexity About O(log cells) a line and O(1) a hit; bounded in each cell that a line runs in.
 *     About O(log cells) for each cell that the curve comes near to; bounded for each segment and
 *     cell that run in each other. Threads.
 * @source Leus, "Carcasses on smooth surfaces", task c.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_hits_create(const struct gusset_context *context,
                                         const struct gusset_surface *surface,
                                         const struct gusset_line *lines,
                                         size_t count,
                                         const struct gusset_curve *curve,
                                         gusset_hit_selection selection,
                                         struct gusset_surface_hits **hits);

/**
 * Finds the first hit of each of many lines, rays or segments: the hit of least t, which
 * gusset_surface_hits_create gives first.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param surface the surface.
 * @param lines count of them, at any alignment.
 * @param count see lines.
 * @param[out] hits receives count results, one a line; kind is GUSSET_HIT_NONE, and all else 0,
 *     where there is none, and everywhere on failure.
 * @return GUSSET_OK, or an error: those of gusset_surface_hits_create, MISALIGNED_ARGUMENT (hits).
 * @complexity About O(log cells) a line; threads.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_first_hits(const struct gusset_context *context,
                                        const struct gusset_surface *surface,
                                        const struct gusset_line *lines,
                                        size_t count,
                                        struct gusset_surface_hit *hits);

/**
 * The hits, lent until they are destroyed.
 *
 * @param hits the hits.
 * @param[out] view struct_size set by the caller; all else is overwritten.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_hits_get_view(const struct gusset_surface_hits *hits,
                                           struct gusset_surface_hits_view *view);

/**
 * Frees hits; NULL is allowed.
 *
 * @param[in,out] hits the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_surface_hits_destroy(struct gusset_surface_hits *hits);

/**
 * A shortest chain of cells of a region from one cell to another: consecutive ones have a node in
 * common, across corners too.
 *
 * The sum of their diameters bounds the distance between points of from and of to.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param sheet the sheet.
 * @param words the region, at any alignment, a bit for each cell: that of cell (i, j) is bit k %
 *     64 of word k / 64, k = i * columns + j, columns of cells; NULL with count 0 for all cells.
 * @param count the words, at least as many as the cells need.
 * @param from row and column of a cell of the region, two numbers, at any alignment.
 * @param to the same of the other cell.
 * @param[out] cells receives row and column of each cell of the chain, from and to included, two
 *     numbers each; NULL with capacity 0 to ask for the size.
 * @param capacity how many cells it has room for.
 * @param[out] written receives the number of cells, the integer length; 0 if there is no chain.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, SIZE_OVERFLOW (too few
 *     words), NO_SUCH_ELEMENT with the cell, BUFFER_TOO_SMALL, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(cells).
 * @source Leus, eq. (3).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_mask_chain(const struct gusset_context *context,
                                      const struct gusset_sheet *sheet,
                                      const uint64_t *words,
                                      size_t count,
                                      const uint32_t *from,
                                      const uint32_t *to,
                                      uint32_t *cells,
                                      size_t capacity,
                                      size_t *written);

/**
 * Measures a region of cells: its integer diameter and with it a bound of its diameter, and its
 * Euler characteristic.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param sheet the sheet.
 * @param words the region, as for gusset_sheet_mask_chain.
 * @param count the region, as for gusset_sheet_mask_chain.
 * @param[out] report struct_size set by the caller; all else is overwritten.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(cells) for compact regions; for the worst O(cells^2), which can be cancelled.
 * @source Leus, eqs. (4) to (6).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_mask_measure(const struct gusset_context *context,
                                        const struct gusset_sheet *sheet,
                                        const uint64_t *words,
                                        size_t count,
                                        struct gusset_mask_report *report);

/**
 * Lists the cells or the nodes of a mask, row after row. Its nodes are the corners of its cells, each
 * once; lines that close the sheet count as the first ones.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param sheet the sheet.
 * @param words the mask, as for gusset_sheet_mask_chain.
 * @param count the mask, as for gusset_sheet_mask_chain.
 * @param domain GUSSET_DOMAIN_...: faces are the cells, vertices and corners the nodes.
 * @param[out] elements receives row and column of each, two numbers each; NULL with capacity 0 to
 *     ask for the size.
 * @param capacity how many elements it has room for.
 * @param[out] written receives the number of elements.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, SIZE_OVERFLOW (too few
 *     words), UNKNOWN_VALUE, BUFFER_TOO_SMALL, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(cells / 64), and the cells of the mask; O(nodes) for nodes.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_mask_elements(const struct gusset_context *context,
                                         const struct gusset_sheet *sheet,
                                         const uint64_t *words,
                                         size_t count,
                                         gusset_domain domain,
                                         uint32_t *elements,
                                         size_t capacity,
                                         size_t *written);

/**
 * The nearest points of a surface to queries, one or many.
 *
 * Each answer is the same to the bit whether it is asked for alone or among others, in any order,
 * on any number of threads; of several nearest points it is that of the first sheet, row and
 * column. Proofs are relative to the surface as declared: no point of it is nearer than
 * bound.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param surface the surface.
 * @param queries x, y, z of each, packed, at any alignment.
 * @param count see queries.
 * @param options NULL for the defaults: no limit.
 * @param[out] points room for count answers, in the order of the queries; none is found on
 *     failure: no flags, and infinite distances.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     SIZE_OVERFLOW, TOO_LARGE, NOT_FINITE with the query, OUT_OF_RANGE (limit; a query with a
 *     coordinate beyond 1e150), UNKNOWN_VALUE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(log nodes) a query but for queries near centres of curvature, which take bounded
 *     work; threads.
 * @source Leus, "Carcasses on smooth surfaces", task a, by branch and bound.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_nearest(const struct gusset_context *context,
                                     const struct gusset_surface *surface,
                                     const double *queries,
                                     size_t count,
                                     const struct gusset_nearest_options *options,
                                     struct gusset_surface_nearest_point *points);

/**
 * The places where the distance from a query is locally least: all, those within a limit, or the
 * nearest ones.
 *
 * None is missed: where it cannot be proved whether there is one (the distance is the same all
 * round, as at a focus), one point is given for all cells that touch, without
 * GUSSET_NEAREST_PROVEN and with GUSSET_NEAREST_AMBIGUOUS. On open borders and creases, places
 * count from which no way on the surface leads nearer.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param surface the surface.
 * @param query x, y, z, up to 1e150, at any alignment.
 * @param options NULL for the defaults: all.
 * @param[out] points receives the result, the nearest first, for gusset_surface_points_destroy;
 *     NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE, NOT_FINITE,
 *     OUT_OF_RANGE (limit; a coordinate beyond 1e150), UNKNOWN_VALUE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(cells within the limit); with max_count, those no farther than the last.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_minima_create(const struct gusset_context *context,
                                           const struct gusset_surface *surface,
                                           const double *query,
                                           const struct gusset_nearest_options *options,
                                           struct gusset_surface_points **points);

/**
 * The points, lent until they are destroyed.
 *
 * @param points the points.
 * @param[out] view struct_size set by the caller; all else is overwritten.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_points_get_view(const struct gusset_surface_points *points,
                                             struct gusset_surface_points_view *view);

/**
 * Frees points; NULL is allowed.
 *
 * @param[in,out] points the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_surface_points_destroy(struct gusset_surface_points *points);

/**
 * The paper's search with its logical scale, corrected: which cells of a sheet may have a point
 * within a distance of an object, or the nearest one, or a normal at an angle.
 *
 * None that has is missing. It is the documented reference and looks at many nodes; a surface
 * (gusset_surface_create) answers the same and more from its index, much faster.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param sheet the sheet.
 * @param task what is looked for.
 * @param[out] words receives a bit for each cell, laid out as for gusset_sheet_mask_chain; NULL
 *     with capacity 0 for the size and the report alone; all words are 0 on failure.
 * @param capacity how many words it has room for.
 * @param[out] written receives the number of words.
 * @param[out] report what was done; its struct_size set by the caller; may be NULL.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE (object, flags), OUT_OF_RANGE (what is not finite, no direction, a negative
 *     distance, an angle outside 0 to pi), BUFFER_TOO_SMALL, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(cells) for the bounds of cells, with threads; O(cells / 64) and the nodes looked
 *     at for the search.
 * @source Leus; docs/errata.md lists its errata.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_reference_mask(const struct gusset_context *context,
                                          const struct gusset_sheet *sheet,
                                          const struct gusset_reference_task *task,
                                          uint64_t *words,
                                          size_t capacity,
                                          size_t *written,
                                          struct gusset_reference_report *report);

/**
 * The same search over a curve's own points, with the lengths of its arcs for diameters: which
 * arcs may have a point within a distance of an object, or the nearest one, or a tangent at an
 * angle.
 *
 * Each segment is divided into as many arcs of equal length in the parameter; the cells of the mask
 * are the arcs in the order of the curve, its nodes their ends. No arc that has what is looked for
 * is missing.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param curve the curve.
 * @param parts arcs of each segment, at least 1; 2^30 of all at most.
 * @param task what is looked for; angles are those of tangents, for which curvature and lines are
 *     not read, and unsigned_normals counts tangents of either direction.
 * @param[out] words receives a bit for each arc: that of arc k is bit k % 64 of word k / 64; NULL
 *     with capacity 0 for the size and the report alone; all words are 0 on failure.
 * @param capacity how many words it has room for.
 * @param[out] written receives the number of words.
 * @param[out] report what was done: columns are points of the curve, rows 0; its struct_size set by
 *     the caller; may be NULL.
 * @return GUSSET_OK, or an error: those of gusset_sheet_reference_mask; EMPTY_CURVE, OUT_OF_RANGE
 *     (parts), TOO_LARGE.
 * @complexity O(arcs degree^2) for the lengths; O(arcs / 64) and the nodes looked at for the
 *     search.
 * @source Leus, the last paragraph.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_curve_reference_mask(const struct gusset_context *context,
                                          const struct gusset_curve *curve,
                                          size_t parts,
                                          const struct gusset_reference_task *task,
                                          uint64_t *words,
                                          size_t capacity,
                                          size_t *written,
                                          struct gusset_reference_report *report);

/**
 * The paper's approximate normals: at each place two orthogonal planes, parallel to the mean of
 * the normals at the cell's corners, cut the lines of the net; cubics through four crossings each
 * have tangents that span the tangent plane.
 *
 * They are of third order in the size of cells; the exact normals of the surface are had from a surface.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param sheet the sheet.
 * @param places count places of the sheet, whose own number is not read, at any alignment; u and v
 *     0 to 1.
 * @param count see places.
 * @param[out] normals receives x, y, z of each; 0 where there is none, and everywhere on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, SIZE_OVERFLOW, UNKNOWN_VALUE
 *     (reserved), NO_SUCH_ELEMENT with the first place that the sheet does not have: no such cell,
 *     parameters that are not 0 to 1; OUT_OF_MEMORY, CANCELLED.
 * @complexity Bounded work for each.
 * @source Leus, fig. 1.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_normals_by_sections(const struct gusset_context *context,
                                               const struct gusset_sheet *sheet,
                                               const struct gusset_surface_place *places,
                                               size_t count,
                                               double *normals);

/**
 * Reports on a surface and its sheets.
 *
 * @param surface the surface.
 * @param[out] report struct_size set by the caller; all else is overwritten.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(sheets).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_get_report(const struct gusset_surface *surface,
                                        struct gusset_surface_report *report);

/**
 * Makes a surface through nodes: through a copy of them, through the caller's own memory, or the
 * bicubic Hermite surface with given tangents, which is C1.
 *
 * Borrowed nodes must stay valid and unchanged until the sheet and everything made of it are
 * destroyed. They are f64, aligned to 8 bytes, and their strides are multiples of 8.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param nodes at any alignment, unless borrowed; finite. Repeated nodes and rows that are one point
 *     (poles) are allowed. For a surface the greatest coordinate in absolute terms is from
 *     1e-30 to 1e37, or 0; so it is for every kind of sheet.
 * @param tangents NULL: the scheme of the nodes draws the surface. Else rows x columns vectors each,
 *     at any alignment, and the scheme is not read. The vectors of the repeated line of a closed
 *     direction are not read as tangents, but must be there.
 * @param borrow 1: the sheet reads the caller's memory; 0: it copies the nodes. With tangents the
 *     sheet keeps patches in place of nodes, either way.
 * @param[out] sheet receives the surface, for gusset_sheet_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT (the structs, sheet, borrowed
 *     nodes), BAD_STRUCT_SIZE, NET_TOO_SMALL, TOO_LARGE, BAD_STRIDE, also for borrowed nodes that
 *     are f32 or have strides that are not multiples of 8, SIZE_OVERFLOW, UNKNOWN_VALUE (also twist,
 *     reserved, borrow), NOT_FINITE with the node, of a node, a tangent or a twist, SIDES_DIFFER if a
 *     closed direction does not end where it begins, with the place of the largest gap,
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes); 24 bytes a node, none if they are borrowed, and with tangents 384 bytes a
 *     cell.
 * @source Leus, "Carcasses on smooth surfaces"; the scheme of six taps is ours.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_create(const struct gusset_context *context,
                                  const struct gusset_nodes *nodes,
                                  const struct gusset_tangents *tangents,
                                  uint32_t borrow,
                                  struct gusset_sheet **sheet);

/**
 * Frees a sheet; NULL is allowed.
 *
 * Results that were made of it keep what they need.
 *
 * @param[in,out] sheet the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_sheet_destroy(struct gusset_sheet *sheet);

/**
 * Makes a surface of Bézier patches in rows and columns, neighbours of which should share their
 * sides.
 *
 * Repeated points and sides that are one point are allowed.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param points x, y, z of the control points, packed, at any alignment: patch after patch, row
 *     after row of patches; in each patch degree_v + 1 points follow each other in v, degree_u + 1
 *     times.
 * @param degree_u 1 to 7.
 * @param degree_v 1 to 7.
 * @param rows of patches, at least 1.
 * @param columns of patches, at least 1.
 * @param[out] sheet receives the surface, for gusset_sheet_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT (sheet), OUT_OF_RANGE
 *     (degree), EMPTY_MESH without patches, TOO_LARGE, SIZE_OVERFLOW, NOT_FINITE with the control
 *     point (as a node), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(points); 384 bytes a patch up to degree 3, else 1536.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_from_patches_create(const struct gusset_context *context,
                                               const double *points,
                                               uint32_t degree_u,
                                               uint32_t degree_v,
                                               size_t rows,
                                               size_t columns,
                                               struct gusset_sheet **sheet);

/**
 * Makes the surface of a B-spline, cut into its Bézier patches, which is exact but for rounding:
 * cells are its spans that are not empty, so that knots become the whole numbers of rows and
 * columns.
 *
 * If weights differ, spans are cut further, whole rows and columns at a time, and the patch of each
 * cell is the polynomial of degree 7 with the values and the first derivatives of the rational
 * surface at corners, and its values at points between. It is proven, not sampled, that the sheet
 * is within the tolerance of the rational surface at equal parameters: gusset_sheet_get_report has
 * the bound, rounding included, and the knots of rows and columns, between which parameters run
 * evenly. Tangents go on over sides where those of the rational surface do. Sides that are one
 * point, as the poles of spheres, stay so to the bit.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param spline its arrays are at any alignment.
 * @param[out] sheet receives the surface, for gusset_sheet_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE, OUT_OF_RANGE (degree; tolerance; a weight, with its control point as a node),
 *     NET_TOO_SMALL (too few control points), BAD_KNOTS with the first knot that is not finite, out
 *     of order or repeated too often, or that begins a span too short to be cut where that is
 *     needed, TOO_LARGE (control points, cells), SIZE_OVERFLOW, NOT_FINITE with the control point
 *     (as a node), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(spans x degree^3); 384 bytes a span up to degree 3, else 1536. Of rational splines
 *     O(cells x degree^2), threads; 1536 bytes a cell, three times that while it is made.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_from_spline_create(const struct gusset_context *context,
                                              const struct gusset_spline *spline,
                                              struct gusset_sheet **sheet);

/**
 * Makes Gordon's surface of a net of curves, which contains all of them; with two rows and two
 * columns it is Coons's patch.
 *
 * Nodes are where each row and each column are nearest.
 *
 * Between two nodes rows of equally many segments are matched segment by segment; else all of them
 * are cut where any one has a joint: there may be more cells than meshes of the net. The surface
 * is C1 where the curves are C1 in common knots and have no joints between nodes, else nearly
 * (gusset_sheet_measure tells). Polylines, segments of degree 1, are kept with their creases; for a
 * smooth surface draw curves through their points first, with gusset_outline_create.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param net the curves may be destroyed afterwards; the arrays of handles are at any alignment.
 * @param[out] sheet receives the surface, for gusset_sheet_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT (with the item), MISALIGNED_ARGUMENT,
 *     BAD_STRUCT_SIZE, UNKNOWN_VALUE, NET_TOO_SMALL, EMPTY_CURVE, OUT_OF_RANGE (degree,
 *     tolerance), CURVE_NOT_CLOSED, CURVES_APART with the row and the distance (the message has
 *     the column too), or if they meet out of order, TOO_LARGE, SIZE_OVERFLOW, OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(rows x columns x log segments) to find nodes, then O(cells); 384 bytes a cell up
 *     to degree 3, else 1536.
 * @source Gordon (1969).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_from_curves_create(const struct gusset_context *context,
                                              const struct gusset_curve_net *net,
                                              struct gusset_sheet **sheet);

/**
 * Makes the surface beside a sheet: through the corners of its cells, each moved along the normal,
 * the derivative in u crossed with that in v.
 *
 * Normals at the nodes of a grid are those of circles through neighbouring nodes, exact on planes,
 * spheres, and round cylinders whose rulings and sections are lines of the grid; those of patches
 * are their own.
 * Places without a normal stay. The result is a grid, smooth between its nodes where a sheet of
 * patches had creases.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param sheet may be destroyed afterwards.
 * @param distances in the unit of the nodes, finite, of either sign.
 * @param distance_count 1: all corners move by the same; the number of lines of corners along v,
 *     rows + 1 for rows of cells: each line by its own; (rows + 1) x (columns + 1): each corner by
 *     its own, row by row. A line that closes the sheet counts, and moves with the first one.
 * @param[out] deviation receives how far the result is, at most in the middles of the cells, from
 *     the place of this sheet there, moved along its normal by the mean distance of the corners;
 *     NULL if it is not wanted.
 * @param[out] offset receives the surface, for gusset_sheet_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, COUNT_DIFFERS (distances),
 *     NOT_FINITE (the index is the distance's or the corner's), OUT_OF_MEMORY, CANCELLED.
 * @complexity O(cells).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_offset_create(const struct gusset_context *context,
                                         const struct gusset_sheet *sheet,
                                         const double *distances,
                                         size_t distance_count,
                                         double *deviation,
                                         struct gusset_sheet **offset);

/**
 * Makes the surface of a frame: u runs along the body, v round it, closed as the frame is.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param frame may be destroyed afterwards.
 * @param kind GUSSET_FRAME_...
 * @param[out] sheet receives the surface, for gusset_sheet_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE,
 *     NET_TOO_SMALL; of curves OUT_OF_RANGE (a degree above 7), CURVES_APART if nodes repeat or
 *     are out of order along a curve; NOT_FINITE, OUT_OF_MEMORY, CANCELLED.
 * @complexity O(nodes).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_from_frame_create(const struct gusset_context *context,
                                             const struct gusset_frame *frame,
                                             gusset_frame_surface kind,
                                             struct gusset_sheet **sheet);

/**
 * Makes a mesh of points of a sheet.
 *
 * Cells of a row have equally many parts in u, those of a column in v, so that neighbours fit;
 * seams of closed directions and poles are closed. Faces are counter-clockwise seen from where S_u
 * x S_v points to. A mesh without faces is no failure.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param sheet the sheet.
 * @param options NULL for the defaults.
 * @param[out] mesh receives the result, for gusset_sheet_mesh_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE, OUT_OF_RANGE (tolerance), TOO_LARGE (2^32 - 1 corners and more),
 *     OUT_OF_MEMORY, CANCELLED.
 * @complexity O(cells + vertices).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_mesh_create(const struct gusset_context *context,
                                       const struct gusset_sheet *sheet,
                                       const struct gusset_sheet_mesh_options *options,
                                       struct gusset_sheet_mesh **mesh);

/**
 * Destroys the mesh of a sheet; NULL is allowed.
 *
 * @param[in,out] mesh the handle; NULL is allowed.
 * @since 0.1
 */
GUSSET_API void gusset_sheet_mesh_destroy(struct gusset_sheet_mesh *mesh);

/**
 * Lends the mesh, valid until it is destroyed.
 *
 * @param mesh the mesh.
 * @param[out] view its struct_size set.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_mesh_get_mesh(const struct gusset_sheet_mesh *mesh,
                                         struct gusset_mesh_view *view);

/**
 * Lends places and normals of the vertices.
 *
 * @param mesh the mesh.
 * @param[out] parts receives the parts; struct_size is set by the caller.
 * @return GUSSET_OK, or an error: those of gusset_sheet_mesh_get_mesh.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_mesh_get_view(const struct gusset_sheet_mesh *mesh,
                                         struct gusset_sheet_mesh_view *parts);

/**
 * The origins of the mesh of a sheet: its one input is the sheet, whose nodes are those between its
 * cells, (rows + 1) * (columns + 1) of them, row after row.
 *
 * A vertex and a corner have the nodes of their cell, by its parameters; on a line that closes the
 * sheet each corner has those of its own face's side, so that an image need not run back there.
 * Faces have their cells.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param mesh the mesh.
 * @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(corners); 52 bytes for each vertex and corner.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_mesh_origins_create(const struct gusset_context *context,
                                               const struct gusset_sheet_mesh *mesh,
                                               struct gusset_origins **origins);

/**
 * Reports what a sheet is.
 *
 * @param sheet the sheet.
 * @param[out] report struct_size set by the caller; all else is overwritten.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
 * @complexity O(cells at the sides).
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_get_report(const struct gusset_sheet *sheet,
                                      struct gusset_sheet_report *report);

/**
 * Measures a sheet and its cells: diameters, estimates and bounds of their error, curvature, creases.
 * Computes only what is asked for.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param sheet the sheet.
 * @param parts GUSSET_SHEET_MEASURE_..., added: what measures receives; 0: everything.
 * @param cells arrays of the caller that receive numbers by cell; NULL for none. Nothing is written
 *     to them on failure.
 * @param[out] measures struct_size set by the caller; all else is overwritten; NULL if only cells
 *     are wanted.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE (parts), BUFFER_TOO_SMALL (the value is the number of cells), OUT_OF_MEMORY,
 *     CANCELLED.
 * @complexity O(cells), 16 bytes a cell for each of diameters, errors and distances; threads; the
 *     same bits for any number of them.
 * @source Leus, eqs. (1) and (7); the bounds are ours.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_sheet_measure(const struct gusset_context *context,
                                   const struct gusset_sheet *sheet,
                                   gusset_sheet_measure_flags parts,
                                   const struct gusset_cell_arrays *cells,
                                   struct gusset_sheet_measures *measures);

/**
 * Finds the curves in which two surfaces meet, or in which a surface meets itself, with the places
 * of their points on both.
 *
 * Curves run along N x N', where N is the normal at `places` and N' the normal at `others`. Closed
 * ones are marked so. Points and normals are those of the first surface; the points at `others` are
 * the same but for rounding, and at crossings to the tolerance. Each curve is given once.
 *
 * Two surfaces: every branch is found, relative to the surfaces as declared, that is longer than
 * the tolerance, or the surfaces' own if that is smaller, or, next to a pole, than four times that;
 * farther than four times that from others; and not part of a contact or of a cell that is listed
 * as unresolved. A path that is not closed ends at the border of a sheet, or in such a cell.
 *
 * A point where the surfaces touch, or where two branches cross, is a contact if it is proved to
 * be alone: near it both are graphs over a plane, and the second derivatives of their difference
 * are a definite form (GUSSET_CONTACT_POINT) or an indefinite one (GUSSET_CONTACT_CROSSING), and
 * the gap is within the tolerance; if it is larger, there is a loop, or nothing, or two branches
 * that pass each other. All within a contact's radius, at most some four times the root of
 * twice the tolerance over the least curvature of that difference, is left out: loops, and how
 * branches run that come nearer to each other than that; a path goes straight to the contact's
 * point from where it comes to it. A path that comes to a crossing turns there, as N x N' points to
 * it and away from it in turn, and goes back the way that closes it if there is one: a figure of
 * eight is two closed paths that have one point in common.
 *
 * Cells of the first surface where the surfaces touch in another way (along a curve, at a pole, at
 * a border, to a higher order) or coincide are listed as unresolved, and curves may end there, or
 * be in parts or missing within such cells. So are cells that take more work than the limit, as
 * where two branches run beside each other at 1e-4 of a cell and not along its sides, or one runs
 * nearly along the sides of cells of both surfaces, as where coaxial surfaces of revolution meet.
 * Curves are joined across such a place where a chord is as near to both surfaces as elsewhere.
 *
 * A surface with itself: along a closed curve the two pieces may change places, as on a Klein
 * bottle. The curve then ends where it begins in space, with `places` and `others` exchanged. Where
 * a sheet is turned over at a seam, as a Möbius band is, the direction turns too.
 *
 * Cells of a sheet with a side or a corner in common, across a seam too, opposite borders of a sheet
 * whose control points are the same to 64 units of rounding of the largest coordinate, in either
 * order, and cells round a pole are joined: what they have in common so is no intersection, and
 * that they have nothing else is proved, or they are divided. Every branch longer than the
 * tolerance is found, but for cells that are listed as unresolved: where tangents are dependent, as
 * where a curve ends in a pinch (Whitney's umbrella), at creases and singular poles, and where
 * pieces touch or coincide. A curve that ends in a pinch ends where its pieces are as near to each
 * other as the tolerance, some tens of tolerances from the pinch where the surface is rough; the
 * unresolved place is there. A curve that runs along sides of cells all its way may come in many
 * parts. No contacts are looked for. A common part of borders of different sheets is an
 * intersection.
 *
 * @param context threads, progress, cancellation and error report; NULL for the defaults.
 * @param surface the surface.
 * @param other the other surface; NULL: the surface with itself. For the handle of the surface
 *     everything is reported as coincident.
 * @param options NULL for the defaults. For one surface they are those of two with it twice.
 * @param[out] paths receives the curves, for gusset_surface_paths_destroy; NULL on failure.
 * @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
 *     UNKNOWN_VALUE (spacing, reserved), OUT_OF_RANGE (chord, tolerance), TOO_LARGE above 2^26
 *     pairs of cells, OUT_OF_MEMORY, CANCELLED.
 * @complexity In proportion to the pairs of cells that may be within the tolerance of each other,
 *     with a limit for each, and to the points, as 1 / sqrt(chord); more where cells are within
 *     the tolerance of hundreds of others. For one surface also in proportion to its cells; of n
 *     cells round a pole n^2 / 2 pairs are looked at, and held only where the sheet is not proved
 *     to be regular there. Threads; the same bits for any number of them. With the surfaces
 *     exchanged bits may differ, and which contacts are proved.
 * @source Leus, "Carcasses on smooth surfaces", task e; the proofs are ours.
 * @since 0.1
 */
GUSSET_API
GUSSET_MUST_USE
gusset_status gusset_surface_intersection_create(const struct gusset_context *context,
                                                 const struct gusset_surface *surface,
                                                 const struct gusset_surface *other,
                                                 const struct gusset_intersection_options *options,
                                                 struct gusset_surface_paths **paths);

/**
 * The library's version, "major.minor.patch".
 *
 * Never NULL; static.
 *
 * @return a static string, never NULL.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API const char *gusset_version(void);

/**
 * The number of the binary interface.
 *
 * It changes whenever a program built against an older header could break; until 1.0 that is when
 * the minor version changes.
 *
 * @return the number.
 * @complexity O(1).
 * @since 0.1
 */
GUSSET_API uint32_t gusset_abi(void);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* GUSSET_H */
