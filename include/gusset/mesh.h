/* Generated from src/capi; do not edit. See gusset.h. */

#ifndef GUSSET_MESH_H
#define GUSSET_MESH_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------------------------ */
/* Meshes: Views of polygon meshes in memory of the caller or of a result. */

/// The type of coordinates.
typedef uint32_t gusset_scalar;
/// Coordinates are 32-bit floats.
#define GUSSET_F32 1
/// Coordinates are 64-bit floats.
#define GUSSET_F64 2

/// The type of indices.
typedef uint32_t gusset_index;
/// Indices and face offsets are 32-bit unsigned integers.
#define GUSSET_U32 0
/// Reserved: this version refuses it (GUSSET_ERROR_UNKNOWN_VALUE).
#define GUSSET_U64 1

/// Indices that a result lends, or that the caller gives.
typedef struct gusset_indices {
    /// The first one; may be NULL if count is 0.
    const uint32_t *data;
    /// How many.
    size_t count;
} gusset_indices;

/// A polygon mesh in memory: the caller's own arrays as input, or the arrays of a result. Nothing is copied on the way
/// in. As input: at least one vertex and one face (EMPTY_MESH); at most 2^32 - 2 vertices and as many corners
/// (TOO_LARGE); at least three corners a face (FACE_TOO_SMALL); indices below vertex_count (INDEX_OUT_OF_RANGE); finite
/// coordinates at all vertices that faces use (NOT_FINITE), while unused ones may hold anything. The arrays may have
/// any alignment. They must be as long as the counts say, which the library cannot see, and must not change during a
/// call. Also NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE, UNKNOWN_VALUE, BAD_STRIDE, BAD_FACE_LAYOUT,
/// BAD_OFFSETS BAD_MERGE and SIZE_OVERFLOW; counts are held against the limits before any element is read. As output:
/// packed positions, face_offsets given, face_size 0.
typedef struct gusset_mesh_view {
    size_t struct_size;
    /// x, y, z at the start of every stride, of the type that scalar names.
    const void *positions;
    /// Bytes from one position to the next; 0 if they are packed.
    size_t position_stride;
    /// The number of vertices.
    size_t vertex_count;
    /// face_count + 1 entries: face f has the corners face_offsets[f] to face_offsets[f + 1] - 1. NULL if face_size is
    /// given.
    const void *face_offsets;
    /// The vertex at each corner, face after face. Corner h is also the name of the half-edge that starts there.
    const void *face_corners;
    /// The number of faces.
    size_t face_count;
    /// GUSSET_F32 or GUSSET_F64. Zero is no valid value: it must be said.
    gusset_scalar scalar;
    /// GUSSET_U32.
    gusset_index index;
    /// The number of corners of every face, or 0 if face_offsets is given.
    uint32_t face_size;
    uint32_t reserved;
    /// For each vertex the vertex that it is one with, of the type that index names: itself, or one that is one with
    /// itself; NULL if none is one with another. So can vertices be kept apart that carry different values, as at seams
    /// of texture coordinates, and the surface has no border there: see gusset_mesh_find_merge. Positions are those of
    /// the vertices that others are one with. Results name these in lists of vertices; their faces have the vertices
    /// that were given.
    const void *merge;
} gusset_mesh_view;

/* ------------------------------------------------------------------------------------------------------------------ */
/* Alignment: Finds the rigid poses at which overlapping pieces fit. */

/// The poses in which pieces begin.
typedef uint32_t gusset_alignment_start;
/// The pieces begin where their positions say, or where poses move them if these are given.
#define GUSSET_ALIGN_AS_GIVEN 0
/// Each piece begins with its principal axes on those of the first one, in the one of the four ways to do so after
/// which most of it lies on the first. For pieces that show the same object whole.
#define GUSSET_ALIGN_PRINCIPAL_AXES 1
/// The pieces are put together by rims that run alike, and it is their rims that hold them then: for pieces of one
/// surface that was cut or broken and do not overlap.
#define GUSSET_ALIGN_RIMS 2

/// Whether the pose of a piece can be trusted, and if not why.
typedef uint32_t gusset_aligned_reason;
/// It can be trusted to lie right: it fits pieces that can be trusted, up to the first one. What fits is judged by mean
/// edges: a smooth surface that lies within one of another, as a slightly scaled one or its mirror image may, passes
/// for it. The rms of its overlaps, and converged, say more. Pieces that hold each other fast, but could slide together
/// along the rest, pass, too.
#define GUSSET_ALIGNED_TRUSTED 0
/// It has no faces with an area, or too little of it lies on other pieces.
#define GUSSET_ALIGNED_NO_OVERLAP 1
/// Where it is near others, too much of it lies off them.
#define GUSSET_ALIGNED_POOR_FIT 2
/// The overlaps leave it free to slide or to turn, as planes, spheres or cylinders do.
#define GUSSET_ALIGNED_UNDETERMINED 3
/// Most of what lies on other pieces faces the other way: it is inside out, or mirrored.
#define GUSSET_ALIGNED_FACES_OTHER_WAY 4
/// It lies on no other piece, and is more than fifty times as large or small as the first one: its unit of length is
/// another, most likely.
#define GUSSET_ALIGNED_OTHER_SIZE 5
/// It fits pieces that cannot be trusted only.
#define GUSSET_ALIGNED_TRUSTED_BY_NONE 6

/// How pieces are aligned; all zero is the default.
typedef struct gusset_alignment_options {
    size_t struct_size;
    /// Where the pieces begin.
    gusset_alignment_start start;
    /// So many points of each piece are looked for on the others; 0: 2,000.
    uint32_t samples;
    /// Read for GUSSET_ALIGN_AS_GIVEN: motions of the pieces, rotations and translations, or NULL.
    const struct gusset_transform *poses;
    /// Their number: that of the pieces, or 0.
    size_t pose_count;
    /// Points that are farther than this from another piece are no pair with it, in the unit of the positions, finite
    /// and at least 0; 0: a tenth of the diagonal of the largest piece's box. Pieces may begin that far from where they
    /// belong, or a little less.
    double max_distance;
    /// Rounds at the most, in each of two stages; 0: 100.
    uint32_t max_rounds;
    uint32_t reserved;
} gusset_alignment_options;

/// One piece, aligned.
typedef struct gusset_aligned_piece {
    /// Takes the piece's positions to their new places: a rotation and a translation.
    struct gusset_transform pose;
    /// How well the overlaps hold it, from 0 to 1: by how much the motion of length 1 that changes the distances of
    /// pairs least changes them, as a root of a mean square; turns count in radii of the piece. Of the first piece 1.
    double hold;
    gusset_aligned_reason reason;
    uint32_t reserved;
} gusset_aligned_piece;

/// What two pieces have in common where they lie in the end.
typedef struct gusset_overlap {
    /// The pieces, the smaller number first.
    uint32_t pieces[2];
    /// The shares of their points that lie on the other, within a mean edge of it; 0 to 1.
    double shares[2];
    /// The mean distance of these from the other's surface, in the unit of the positions.
    double mean;
    /// The root of the mean square.
    double rms;
    /// The share of the points within eight mean edges of the other piece that lie on it, 0 to 1.
    double fit;
    /// Of how many points this is known.
    uint32_t count;
    /// 1: they fit, as at least 30 points lie on each other and fit is at least two thirds. 0 or 1.
    uint32_t trusted;
} gusset_overlap;

/// Where pieces lie. Pointers are valid until it is destroyed.
typedef struct gusset_alignment_view {
    size_t struct_size;
    /// The pieces, in their order.
    const struct gusset_aligned_piece *pieces;
    /// How many.
    size_t piece_count;
    /// The pairs with anything in common.
    const struct gusset_overlap *overlaps;
    /// How many.
    size_t overlap_count;
    /// Rounds that were done.
    uint32_t rounds;
    /// 1: nothing moved any more in the end; 0: the rounds were not enough.
    uint32_t converged;
} gusset_alignment_view;

/// Where pieces that overlap belong. Opaque and immutable; it keeps nothing of them.
typedef struct gusset_alignment gusset_alignment;

/// Finds where pieces that overlap belong: rigid motions after which they fit, all at once, so that no error adds up
/// round a ring of them. The first piece stays. Points of each piece look for the nearest ones on the others, those
/// beyond a border of the other apart and those whose normals differ by more than 45 degrees; the motions that bring
/// pairs onto the planes of their normals, with less weight for those far off, are found in one system of equations;
/// and so on until nothing moves. Pieces have to begin within max_distance of where they belong, see start. A piece
/// that lies on no other stays where it begins; where overlaps leave it free it may slide. What is not known is no
/// failure, but said for each piece: a piece is trusted if it fits others, overlaps hold it in all six directions by
/// more than the noise of normals, and pieces lead from it to the first one by pairs that fit.
/// @param pieces piece_count mesh views one after another, each as large as the first one's struct_size says, at least
///     one.
/// @param piece_count see pieces.
/// @errors as gusset_mesh_view (the report's input is the piece), EMPTY_MESH (without pieces), OUT_OF_RANGE
///     (max_distance; or a pose that is no rotation and translation, whose number is the report's index), COUNT_DIFFERS
///     (fewer poses than pieces), TOO_LARGE
/// @complexity O(V log V) for V vertices of a piece, and O(samples log V) for each piece and each one near it in each
///     round, of which 10 to 30 are common; with GUSSET_ALIGN_RIMS 512^2 for each two pieces. Linear extra memory.
/// @source P. Besl and N. McKay (1992); Y. Chen and G. Medioni (1992); G. Turk and M. Levoy (1994); P. Neugebauer
///     (1997); S. Rusinkiewicz, A symmetric objective function for ICP (2019).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_alignment_create(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_alignment_options *options,
    struct gusset_alignment **alignment);

/// Destroys an alignment; NULL is allowed.
GUSSET_API void gusset_alignment_destroy(struct gusset_alignment *alignment);

/// Lends the poses and what is known of them.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_alignment_get_view(const struct gusset_alignment *alignment,
    struct gusset_alignment_view *view);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Origins: Names the elements of the inputs from which each vertex, corner and face of a result comes. */

/// Elements of meshes, and of what meshes are made from.
typedef uint32_t gusset_domain;
/// Vertices; the points of polylines, the nodes of a net or a sheet.
#define GUSSET_DOMAIN_VERTICES 0
/// Corners of faces, in the order of face_corners; the nodes of a net or a sheet.
#define GUSSET_DOMAIN_CORNERS 1
/// Faces; the cells of a net or a sheet.
#define GUSSET_DOMAIN_FACES 2

/// For each vertex, corner and face of a result, the elements of the inputs that it has its values from. Opaque and
/// immutable; it keeps nothing of the result. An element that was there before has itself, and a vertex that several
/// became all of them in equal parts. A new vertex has the vertices of the rims round it, by where it would be on plain
/// triangles between them without fairing, and one that was put on an edge the ends of the edge. A new face has the
/// face across the nearest edge of the rims (the first one of those as near), and at its corners what old faces have
/// there: those on its own side where it has an edge in common with them.
typedef struct gusset_origins gusset_origins;

/// The origins of the elements of one kind. Pointers are valid until the origins are destroyed.
typedef struct gusset_origins_view {
    size_t struct_size;
    /// One more than there are elements: element k has the entries offsets[k] to offsets[k + 1] - 1 of sources and
    /// weights; none if it comes from nothing.
    struct gusset_indices offsets;
    /// The sources, numbered through all inputs.
    struct gusset_indices sources;
    /// How much each source counts: more than 0, with the sum 1 for each element; as many as sources; NULL without any.
    const double *weights;
    /// One more than there are inputs: the elements of input i are the sources starts[i] to starts[i + 1] - 1. The
    /// inputs are the meshes, pieces or polylines in their order, the one mesh, net or sheet.
    struct gusset_indices starts;
} gusset_origins_view;

/// Destroys origins; NULL is allowed.
GUSSET_API void gusset_origins_destroy(struct gusset_origins *origins);

/// Lends the origins of the result's vertices, corners or faces, valid until they are destroyed.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_origins_get_view(const struct gusset_origins *origins,
    gusset_domain domain, struct gusset_origins_view *view);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Attributes: Carries colours, normals, texture coordinates, skin weights, materials and numbers to results. */

/// The type of values.
typedef uint32_t gusset_value_type;
/// 32-bit floats.
#define GUSSET_VALUE_F32 1
/// 64-bit floats.
#define GUSSET_VALUE_F64 2
/// 8-bit unsigned integers.
#define GUSSET_VALUE_U8 3
/// 16-bit unsigned integers.
#define GUSSET_VALUE_U16 4
/// 32-bit unsigned integers.
#define GUSSET_VALUE_U32 5

/// How the values of several sources become one. An element with one source has its value, bit for bit.
typedef uint32_t gusset_rule;
/// The weighted mean, as of colours; of integers rounded.
#define GUSSET_RULE_LINEAR 0
/// Directions of three components, floats: the weighted mean on the sphere, of length 1. Those of faces that the
/// operation turned over are turned, too.
#define GUSSET_RULE_NORMAL 1
/// Weights of bones, at least 0: the weighted mean, of which the max_influences largest are kept, the first of equal
/// ones, and made to have the sum 1, or of integers the largest number of the type.
#define GUSSET_RULE_SKIN_WEIGHTS 2
/// The value of the source that counts most, the first of equal ones, as of materials and numbers.
#define GUSSET_RULE_NEAREST 3
/// Texture coordinates. At the corners of new faces they are the weighted mean where both sides are on one chart: on
/// each rim as long as the old faces have the same values at its vertices, and across a gap where for most of the new
/// faces the values beyond are nearer to where their own side's chart would go on than half of the way there and of
/// their base. Elsewhere each new face goes on with the chart of the old face that it comes from, unfolded, and the
/// charts meet in a seam in the middle. Beyond the cut of a chart that goes round, values count by the jump at the cut,
/// or, where that is no repeat of the texture, as where the base's chart goes on: no face runs back over the chart. Of
/// vertices and faces it is the weighted mean.
#define GUSSET_RULE_TEXTURE 4

/// What the values of elements are, and how they are mixed.
typedef struct gusset_channel {
    size_t struct_size;
    /// The elements that have values.
    gusset_domain domain;
    /// Zero is no valid value.
    gusset_value_type value_type;
    /// How many values an element has, 1 to 4096.
    uint32_t components;
    gusset_rule rule;
    /// With GUSSET_RULE_SKIN_WEIGHTS, how many are kept of elements with several sources; 0: all.
    uint32_t max_influences;
    uint32_t reserved;
} gusset_channel;

/// The values of one input's elements.
typedef struct gusset_channel_values {
    /// The components of each element at the start of every stride, at any alignment; NULL with count 0 if the input
    /// has no such values: its elements have 0 then, and new ones the values of the other sources.
    const void *values;
    /// The number of elements: of the input's vertices, corners or faces, all.
    size_t count;
    /// Bytes from one element to the next; 0 if they are packed.
    size_t stride;
} gusset_channel_values;

/// Carries values of the inputs' elements over to the elements of a result. Elements of one source have its bits; the
/// rule says what becomes of several. An element without sources, or whose sources all lack the channel, has 0.
/// @param channel what the values are.
/// @param inputs the values of each input of the origins, in their order; at any alignment.
/// @param input_count their number.
/// @param values receives the components of each element at the start of every stride, at any alignment; the bytes
///     between are left alone. From its first byte to its last it must not overlap the inputs' values.
/// @param count the number of elements that it has room for, at least those of the result.
/// @param stride bytes from one element to the next; 0 for packed ones.
/// @errors OUT_OF_RANGE (components, or value_type and components that the rule does not take; a negative skin weight,
///     with the element and the input), NOT_FINITE (with the element and the input, but for GUSSET_RULE_NEAREST),
///     COUNT_DIFFERS (another number of inputs than there are, or of values, with the input), BAD_STRIDE,
///     BUFFER_TOO_SMALL, OVERLAP
/// @complexity O(sources and elements); no memory, but for GUSSET_RULE_TEXTURE, linear in the corners of new faces; on
///     the context's threads.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_attributes_apply(const struct gusset_context *context,
    const struct gusset_origins *origins, const struct gusset_channel *channel,
    const struct gusset_channel_values *inputs, size_t input_count, void *values, size_t count, size_t stride);

/// Finds which vertices of a mesh are one: those with equal keys, as of the vertices that were split at seams of
/// texture coordinates or normals, or those at equal positions, where -0 equals 0. For each vertex it gives the
/// smallest of those that it is one with, as the field merge of gusset_mesh_view takes it. Without keys, a vertex whose
/// position is not finite is one with itself alone.
/// @param keys one for each vertex, at any alignment; NULL: positions.
/// @param merge room for as many numbers as the mesh has vertices; at any alignment.
/// @errors as gusset_mesh_view
/// @complexity O(V log V) for V vertices; 8 bytes for each, 12 with keys.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_mesh_find_merge(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const uint32_t *keys, uint32_t *merge);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Boundary loops: Finds the free boundary loops of a mesh, in a stated direction, and reports everything unusual in */
/* them. */

/// The treatment of edges with three or more faces.
typedef uint32_t gusset_non_manifold;
/// At an edge with three or more faces each face has a border of its own; loops run along it and are always closed.
#define GUSSET_NON_MANIFOLD_CUT 0
/// Only edges with exactly one face belong to loops; one that meets an edge with more ends there, as an open chain.
#define GUSSET_NON_MANIFOLD_STOP 1

/// The part of the mesh that is checked.
typedef uint32_t gusset_survey;
/// Every edge is looked at: all that is wrong or unusual in the mesh is reported, and flagged on the loops.
#define GUSSET_SURVEY_WHOLE_MESH 0
/// As little is looked at as will give the loops, which is many times faster. Where the boundary itself is odd (open,
/// touching itself, badly oriented, with three faces on an edge) the whole mesh is looked at after all. But what is
/// away from the boundary is not reported, nor an edge with as many faces one way as the other, two or more each; loops
/// are not cut there. The answer rests on sums of hashes: an ordinary mesh errs with a chance of less than 2^-64, but
/// one that was made to deceive may hide a boundary. For meshes from hostile hands take GUSSET_SURVEY_WHOLE_MESH.
#define GUSSET_SURVEY_BOUNDARY_ONLY 1

/// Bits that describe a loop.
/// @bits
typedef uint32_t gusset_loop_flags;
/// The chain does not close: it has one vertex more than it has edges.
#define GUSSET_LOOP_OPEN 1
/// The loop passes a vertex where the surface touches itself.
#define GUSSET_LOOP_BOW_TIE 2
/// It was cut from a longer walk at a vertex that the walk passed twice.
#define GUSSET_LOOP_SPLIT 4
/// It runs along, or ends at, an edge with three or more faces.
#define GUSSET_LOOP_NON_MANIFOLD 8
/// The faces along it disagree in orientation.
#define GUSSET_LOOP_NOT_ORIENTED 16
/// It has an edge of length 0.
#define GUSSET_LOOP_ZERO_LENGTH 32

/// The loop runs this edge against its face.
#define GUSSET_EDGE_REVERSED 1
/// The edge has three or more faces.
#define GUSSET_EDGE_NON_MANIFOLD 2
/// The edge has length 0.
#define GUSSET_EDGE_ZERO_LENGTH 4

/// The kind of a defect.
typedef uint32_t gusset_defect_kind;
/// A face (index) that repeats a vertex (other).
#define GUSSET_DEFECT_DEGENERATE_FACE 1
/// An edge whose two faces run it in the same direction: half-edges index and other.
#define GUSSET_DEFECT_ORIENTATION_CONFLICT 2
/// An edge with three or more half-edges (count; a face that runs it twice counts twice): its first half-edge is index.
#define GUSSET_DEFECT_NON_MANIFOLD_EDGE 3
/// A vertex (index) where the surface touches itself: its faces form more than one fan. Fans end at edges with three or
/// more faces, whose own ends are therefore listed too where a loop passes them.
#define GUSSET_DEFECT_BOW_TIE 4

/// The free boundary loops of a mesh. Opaque and immutable; it keeps nothing of the mesh.
typedef struct gusset_boundary gusset_boundary;

/// How loops are found; all zero is the default.
typedef struct gusset_boundary_options {
    size_t struct_size;
    gusset_non_manifold non_manifold;
    gusset_survey survey;
} gusset_boundary_options;

/// One loop or open chain. Edge i runs from vertices[i] to vertices[i + 1], the last one of a closed loop back to
/// vertices[0]. Pointers are valid until the boundary is destroyed.
typedef struct gusset_loop_view {
    size_t struct_size;
    /// The vertices in order, each once; a closed loop starts at its smallest half-edge.
    struct gusset_indices vertices;
    /// The half-edge (position in face_corners) that each edge is.
    struct gusset_indices half_edges;
    /// The face that each edge borders.
    struct gusset_indices faces;
    /// GUSSET_EDGE_... of each edge: as many as half_edges.
    const uint8_t *edge_flags;
    /// The sum of the edges' lengths, in the unit of the positions.
    double length;
    /// Bits; 0 for an ordinary closed loop.
    gusset_loop_flags flags;
    /// The number of the walk that the loop was cut from.
    uint32_t walk;
} gusset_loop_view;

/// Something wrong or unusual in a mesh.
typedef struct gusset_defect {
    gusset_defect_kind kind;
    /// The face, half-edge or vertex.
    uint32_t index;
    /// The second element of the kinds that have one, else UINT32_MAX.
    uint32_t other;
    /// How many half-edges meet there, for GUSSET_DEFECT_NON_MANIFOLD_EDGE, else 0.
    uint32_t count;
} gusset_defect;

/// The loops of a boundary as a whole. Pointers are valid until the boundary is destroyed.
typedef struct gusset_boundary_view {
    size_t struct_size;
    /// The number of loops and open chains; 0 if the mesh is closed. gusset_boundary_get_loop lends each.
    size_t loop_count;
    /// The number of walks that the loops were cut from. Loops that touch at vertices count as one walk where the walk
    /// round the boundary passes from one loop to the next.
    size_t walk_count;
    /// Degenerate faces, orientation conflicts and non-manifold edges of the whole mesh, and the bow-tie vertices on
    /// its boundary. NULL if there are none.
    const struct gusset_defect *defects;
    /// The number of defects.
    size_t defect_count;
} gusset_boundary_view;

/// Finds every free boundary loop of a mesh: the chains of edges that have a face on one side only. Direction: a loop
/// runs as the faces along it run their own edges. With faces counter-clockwise from outside, the surface is on the
/// left and the hole on the right of someone who walks along the loop on the outside. Every loop passes each of its
/// vertices once: where the boundary touches itself it is cut into several loops. Loops come in the order of their
/// smallest half-edges. Walks along edges with three or more faces alone are left out; a loop that is cut out of
/// another walk may have no edge with exactly one face. A face of fewer than three sides of different ends has no
/// border; its neighbours are taken to touch each other. A loop may have two vertices. Odd places are no errors: see
/// the flags of each loop, and the defects.
/// @errors as gusset_mesh_view
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex, or O(H + B log B) for
///     GUSSET_SURVEY_BOUNDARY_ONLY and B boundary edges; linear extra memory.
/// @source Nesterenko, algorithm 1, as corrected: every loop, a stated direction, fan by fan round each vertex.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_boundary_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_boundary_options *options,
    struct gusset_boundary **boundary);

/// Destroys a boundary; NULL is allowed.
GUSSET_API void gusset_boundary_destroy(struct gusset_boundary *boundary);

/// Lends the number of loops and all defects, valid until the boundary is destroyed.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_boundary_get_view(const struct gusset_boundary *boundary,
    struct gusset_boundary_view *view);

/// Lends loop number `index`, below loop_count of gusset_boundary_view.
/// @param index its number, from 0.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_boundary_get_loop(const struct gusset_boundary *boundary, size_t index,
    struct gusset_loop_view *view);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Checks: Reports everything wrong or unusual in a mesh. */

/// Bits that describe a mesh.
/// @bits
typedef uint32_t gusset_mesh_flags;
/// There are edges, and every one has exactly two faces; degenerate faces have none.
#define GUSSET_MESH_CLOSED 1
/// No non-manifold edge and no non-manifold vertex.
#define GUSSET_MESH_MANIFOLD 2
/// No edge whose two faces run it in the same direction.
#define GUSSET_MESH_ORIENTED 4
/// Faces can be turned over so that it becomes oriented.
#define GUSSET_MESH_ORIENTABLE 8

/// What a check found. Opaque and immutable; it keeps nothing of the mesh.
typedef struct gusset_check gusset_check;

/// Counts, properties and lists of what is wrong or unusual. Lists are ascending; pointers are valid until the check is
/// destroyed.
typedef struct gusset_check_view {
    size_t struct_size;
    /// Vertices, unused ones too.
    uint32_t vertex_count;
    /// Distinct edges: pairs of different vertices that are consecutive in some face that is not degenerate. Degenerate
    /// faces have no edges.
    uint32_t edge_count;
    /// Faces.
    uint32_t face_count;
    /// Pieces: faces that share an edge are in one.
    uint32_t component_count;
    /// Walks round the boundary, fan by fan.
    uint32_t boundary_walk_count;
    /// Bits.
    gusset_mesh_flags properties;
    /// Used vertices - edges + faces, degenerate ones too: Euler's characteristic if there are none.
    int64_t euler;
    /// The number of handles of all components together; -1 if the mesh is not manifold or not orientable, or has a
    /// degenerate face.
    int64_t genus;
    /// The half-edges of the edges with exactly one face.
    struct gusset_indices boundary_edges;
    /// The first half-edge of each edge with three or more faces.
    struct gusset_indices non_manifold_edges;
    /// The ends of those edges, and the bow-ties.
    struct gusset_indices non_manifold_vertices;
    /// Vertices whose faces form more than one fan. Fans end at edges with three or more faces, whose own ends are
    /// therefore among them, as a rule.
    struct gusset_indices bow_ties;
    /// The first half-edge of each edge whose two faces run it in the same direction.
    struct gusset_indices orientation_conflicts;
    /// Faces with the same cycle of vertices, in either direction, as a face before them; degenerate ones apart.
    struct gusset_indices duplicate_faces;
    /// Faces that repeat a vertex.
    struct gusset_indices degenerate_faces;
    /// Faces without area that repeat none: their vector area is 0 up to rounding.
    struct gusset_indices zero_area_faces;
    /// Vertices that no face uses.
    struct gusset_indices unused_vertices;
} gusset_check_view;

/// Checks a mesh. What it finds is no error.
/// @errors as gusset_mesh_view
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex; linear extra memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_check_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, struct gusset_check **check);

/// Destroys a check; NULL is allowed.
GUSSET_API void gusset_check_destroy(struct gusset_check *check);

/// Lends what the check found.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_check_get_view(const struct gusset_check *check,
    struct gusset_check_view *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Developments: Cuts surfaces open and lays them out in the plane with little distortion. */

/// The distortion that a development minimises.
typedef uint32_t gusset_distortion;
/// Lengths and areas: stretch and compression count alike, by the symmetric Dirichlet energy.
#define GUSSET_DISTORTION_SYMMETRIC 0
/// Lengths: as rigid as possible.
#define GUSSET_DISTORTION_RIGID 1
/// Angles: a least squares conformal map, which may stretch areas.
#define GUSSET_DISTORTION_CONFORMAL 2

/// How a surface is developed; all zero is the default.
typedef struct gusset_develop_options {
    size_t struct_size;
    /// Which distortion is least.
    gusset_distortion distortion;
    /// Darts at the most: cuts from the border of a chart to where its curvature is.
    uint32_t max_darts;
    /// Vertices of the mesh, path after path, along which it is cut. Vertices that follow one another are connected by
    /// the shortest path along edges; a path of one vertex cuts nothing.
    struct gusset_indices cuts;
    /// Where each path begins among them, and the end of the last; empty for one path of all.
    struct gusset_indices cut_offsets;
    /// No more darts are made once no length changes by a larger factor; above 1, or 0: all darts are made.
    double max_stretch;
    /// Steps of each descent at the most; 0: 200. A chart whose border would meet itself takes more than one, and so
    /// does one as rigid as possible.
    uint32_t max_iterations;
    uint32_t reserved;
} gusset_develop_options;

struct gusset_result;

/// Lays a surface out in the plane with the least distortion: the pattern to cut it from. The surface is cut along the
/// paths given. What is no disc then, as a tube, a closed surface, one with holes or handles, is opened along short
/// paths. Each connected component of the rest is a chart. One that can be unfolded about its edges, as cylinders,
/// cones and tangent developables in plane strips can, keeps the length of every edge to 1e-10 of it (of 1e-3 mean
/// edges, if it is shorter), before rounding: charts lie beside one another, and far from the origin places are rounded
/// more. It may overlap itself; triangles without area may then be turned over by rounding. Any other chart descends to
/// the least distortion; no triangle is turned over, and the border does not meet itself, so that the map is one to
/// one. Where that ends the descent early, its finish is STALLED. Darts are made as long as they lower the distortion:
/// each is a cut from the border to the vertex whose scale in a conformal map would be the worst. The result is a flat
/// mesh in the scalar type of the surface, with z = 0. It has the faces of the mesh in their order, each from its own
/// first corner and all counterclockwise in the plane. Charts are turned so that the mean square of their borders'
/// distances from the middle is greatest along x. A vertex on a cut becomes several; of merged vertices the smallest is
/// meant. Edges of three or more faces, and those whose two faces disagree in orientation, are borders, and no cuts.
/// Polygons are measured by triangles they are cut into; a triangle flatter than 1e-7 of its longest side, or smaller
/// than 1e-7 of the mean edge, counts as that large. Conformal maps have the area of the surface. Nets and sheets are
/// developed by their meshes; see gusset_net_to_mesh and gusset_sheet_to_mesh.
/// @errors as gusset_mesh_view, OUT_OF_RANGE (max_stretch), BAD_OFFSETS (cut_offsets), INDEX_OUT_OF_RANGE (a vertex of
///     a cut; the report's input is the cut, the index the place in it), CUT_NOT_CONNECTED (the same), REPEATED_CORNER
///     (a face)
/// @complexity O(H log H) for H half-edges if charts unfold; else, for each step of the descent and each dart, O(n^1.5)
///     for n vertices of the chart. Memory O(n log n).
/// @source M. Rabinovich et al., Scalable locally injective mappings (2017), for the descent; B. Levy et al., Least
///     squares conformal maps (2002); J. Erickson, K. Whittlesey, Greedy optimal homotopy and homology generators
///     (2005), for the cuts that open; M. Ben-Chen et al., Conformal flattening by curvature prescription and metric
///     scaling (2008), for darts.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_develop(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_develop_options *options, struct gusset_result **result);

struct gusset_develop_report;

/// Lends the places in the plane, the places they come from, and the report on each chart, for results of
/// gusset_develop.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_develop(const struct gusset_result *result,
    struct gusset_develop_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Developments: reports: Charts, cuts and distortion of a development. */

/// How a chart was laid out.
typedef uint32_t gusset_chart_finish;
/// By unfolding about edges: every edge has its length.
#define GUSSET_CHART_EXACT 0
/// By descent until nothing was gained.
#define GUSSET_CHART_CONVERGED 1
/// By descent, ended by the number of steps.
#define GUSSET_CHART_ITERATION_LIMIT 2
/// The conformal map that was asked for.
#define GUSSET_CHART_CONFORMAL 3
/// The conformal map folds or overlaps: the chart has the least symmetric distortion instead.
#define GUSSET_CHART_NOT_CONFORMAL 4
/// No map without folds was found: some triangles are turned over.
#define GUSSET_CHART_FOLDED 5
/// By descent until no step was possible that gains: the border would meet itself, or rounding hides it. Cuts or darts
/// may help.
#define GUSSET_CHART_STALLED 6

/// The reason for a cut.
typedef uint32_t gusset_cut_kind;
/// On a path that was given.
#define GUSSET_CUT_GIVEN 0
/// To make a disc of a chart.
#define GUSSET_CUT_OPENING 1
/// For a dart.
#define GUSSET_CUT_DART 2

/// A chart: a connected component of the development.
typedef struct gusset_chart {
    /// Its first vertex among those of the result.
    uint32_t first_vertex;
    /// How many follow one another.
    uint32_t vertex_count;
    /// The number of its faces; see face_charts.
    uint32_t face_count;
    /// How it came about.
    gusset_chart_finish finish;
    /// Steps of all its descents.
    uint32_t iterations;
    /// Pairs of edges of its border that meet in the plane, neighbours apart; of EXACT charts those that cross by more
    /// than 1e-8 of the root of the area. Only EXACT and FOLDED charts can have some.
    uint32_t overlaps;
    /// Triangles that are turned over; 0 but for FOLDED.
    uint32_t folds;
    uint32_t reserved;
    /// The symmetric Dirichlet energy: the mean over the area of the sum of s^2 + 1 / s^2 over both singular values s
    /// of the map to the plane; 4 for an isometry, which has the least.
    double energy;
    /// The largest factor by which a length grows.
    double max_stretch;
    /// The least.
    double min_stretch;
    /// The area of the surface, in the squared unit of the positions.
    double area;
    /// The area in the plane.
    double flat_area;
} gusset_chart;

/// Where a surface lies in the plane. Pointers are valid until the result is destroyed.
typedef struct gusset_develop_report {
    size_t struct_size;
    /// x, y of each vertex in the plane, in the unit of the positions, in double precision whatever their type.
    const double *points;
    /// Of each vertex, that of the surface that it is; vertices on cuts are several.
    struct gusset_indices vertex_map;
    /// Of each face its chart.
    struct gusset_indices face_charts;
    /// Of each face two numbers: the largest factor by which lengths in it grow, and the least.
    const double *stretches;
    /// Charts, in the order of their first faces. They lie beside one another along x.
    const struct gusset_chart *charts;
    /// How many.
    size_t chart_count;
    /// Edges of the surface that were cut, two vertices an edge; first those given, then those that open, then darts.
    struct gusset_indices cut_edges;
    /// Of each of them GUSSET_CUT_...
    struct gusset_indices cut_kinds;
    /// The number of darts.
    uint32_t darts;
    uint32_t reserved;
} gusset_develop_report;

/* ------------------------------------------------------------------------------------------------------------------ */
/* Options of stitching: How a strip is chosen, subdivided and smoothed. */

/// The rule that chooses meridians.
typedef uint32_t gusset_meridians;
/// The strip of triangles that best continues both surfaces, near the strip of least area: little turn between
/// neighbours, along the rims above all, and meridians that lie on the surface which the faces beside the rims suggest.
/// Between lines without faces (gusset_strip) the strip of least area.
#define GUSSET_MERIDIANS_CONTINUATION 0
/// The paper's rule by index, O(N + M): good for evenly spaced rims.
#define GUSSET_MERIDIANS_INDEX 1
/// Both rims walked at the same pace, by arc length, O(N + M).
#define GUSSET_MERIDIANS_ARC_LENGTH 2
/// Always on to the shorter of the two next meridians, O(N + M).
#define GUSSET_MERIDIANS_GREEDY 3
/// The strip of triangles whose meridians have the least total length.
#define GUSSET_MERIDIANS_MIN_DIAGONAL 4
/// The strip of triangles with the least bends: the sum over its edges, rims included, of length times (1 - cos of the
/// angle between the normals).
#define GUSSET_MERIDIANS_SMOOTH 5
/// The least sum of the meridians' squared lengths where steps on both rims at once are allowed (dynamic time warping):
/// quads where both sides advance, triangles elsewhere. Meant for strips with interior rows.
#define GUSSET_MERIDIANS_QUAD 6
/// The strip of triangles of least area through the first meridian.
#define GUSSET_MERIDIANS_MIN_AREA 7

/// The effort of the search for the best strip.
typedef uint32_t gusset_strip_search;
/// The best meridians are found exactly for up to 2^21 pairs of vertices, beyond that coarse to fine: nearly linear
/// time, linear memory, and a result within a few hundredths of a per cent of the best on all rims that were measured.
#define GUSSET_SEARCH_AUTO 0
/// Exactly: O(N M) time, and memory for each pair of vertices; see gusset_stitch.
#define GUSSET_SEARCH_EXACT 1

/// The first meridian of a closed strip.
typedef uint32_t gusset_strip_start;
/// The first meridian of a closed band joins the closest pair of vertices, or the closest pair after rim B has been
/// turned along rim A to where it fits best; the better strip of the two is kept.
#define GUSSET_START_AUTO 0
/// The closest pair.
#define GUSSET_START_CLOSEST 1
/// gusset_strip only: the first points.
#define GUSSET_START_GIVEN 2

/// The positions of new vertices.
typedef uint32_t gusset_fairing;
/// New vertices stay where they were first put: those of a strip divide their meridians evenly, as the paper has it,
/// those of a patch lie on the triangles of its first triangulation.
#define GUSSET_FAIRING_NONE 0
/// New vertices are moved so that the new surface bends as a thin plate does and meets the old one smoothly: the sum of
/// the squared Laplacians over them and the rims is least. The rims, and the ends of an open strip, stay where they
/// are.
#define GUSSET_FAIRING_THIN_PLATE 1

/// The treatment of faces that intersect each other.
typedef uint32_t gusset_intersections;
/// Faces of the strip that cut others are looked for, and what can be done about them is done:
/// - a strip of triangles without rows by GUSSET_MERIDIANS_CONTINUATION goes another way where it cuts, and of the
///   strips tried the one that cuts least is kept;
/// - faired rows are taken back in places, up to 12 times, until nothing cuts or nothing is left to take back; if the
///   straight rows cut less in the end, they are kept;
/// - blends are taken back likewise, and made with less fairing where they still cut; the one that cuts least is kept,
///   or the strip if that cuts less than every blend. All other strips stay as they are: rows that are not faired,
///   quads, and other meridians.
#define GUSSET_INTERSECTIONS_AUTO 0
/// They are not looked for: rows are faired in full, and the first blend is kept.
#define GUSSET_INTERSECTIONS_IGNORE 1
/// They are looked for. Faired rows and blends are taken back as with GUSSET_INTERSECTIONS_AUTO, and no strip goes
/// another way, nor does the strip that a blend follows.
#define GUSSET_INTERSECTIONS_REPORT 2

/// The treatment of pieces that are oriented against each other.
typedef uint32_t gusset_orientation;
/// A second piece that is oriented against the first is turned over: the component that rim B is on. Which of the two
/// is inside out is not asked: see GUSSET_OUTWARD_CLOSED for what is closed in the end. Two loops of one connected
/// piece are taken as they are. Whole rims are compared as curves, and by where their surfaces lie if both lead off
/// them to the same side, as at the ends of a U-bend; where nothing is clear, nothing is turned.
#define GUSSET_ORIENTATION_FIX 0
/// Such a piece is GUSSET_ERROR_ORIENTATION_CONFLICT.
#define GUSSET_ORIENTATION_REFUSE 1
/// The rims are not compared: the faces are taken to be right as they are.
#define GUSSET_ORIENTATION_KEEP 2

/// The part of the loops that is joined.
typedef uint32_t gusset_stitch_extent;
/// All of both loops, by a closed band.
#define GUSSET_EXTENT_WHOLE_LOOPS 0
/// The runs of vertices that face the other loop, as the paper has it: GUSSET_ERROR_PLANES_UNDECIDED where it cannot
/// tell.
#define GUSSET_EXTENT_OPEN_ARCS 1
/// Whole loops if their normals make less than 60 degrees, in the mean of cosines, with the line of their centres, or
/// if the planes cannot tell; else open arcs.
#define GUSSET_EXTENT_AUTO 2
/// The arcs given in arc_a and arc_b. Of a loop that is not given, place 0 is where gusset_boundary_get_loop has it.
#define GUSSET_EXTENT_ARCS 3

/// Which of several runs of facing vertices is joined.
typedef uint32_t gusset_facing_run;
/// Of several runs of facing vertices, on each loop the one with the closest pair.
#define GUSSET_RUN_CLOSEST 0
/// On each loop the one of the most vertices.
#define GUSSET_RUN_LONGEST 1

/// The definition of the centre of a loop.
typedef uint32_t gusset_centres;
/// The centre of a loop is the mean of its vertices, as the paper has it.
#define GUSSET_CENTRES_VERTICES 0
/// The mean of its points: vertices that lie close together do not draw it to them.
#define GUSSET_CENTRES_LENGTH 1

/// The number of interior rows.
typedef uint32_t gusset_row_rule;
/// No interior rows: every meridian is one edge.
#define GUSSET_ROWS_NONE 0
/// max(0, round(mean meridian / mean side of the faces of both meshes) - 1), as the paper suggests.
#define GUSSET_ROWS_MEAN_EDGE 1
/// As many as row_count says.
#define GUSSET_ROWS_COUNT 2

/// The faces of strips.
typedef uint32_t gusset_strip_cells;
/// Triangles throughout; quads are split by their shorter diagonals.
#define GUSSET_CELLS_TRIANGLES 0
/// Quads where four different neighbours meet, and triangles where a rim repeats a vertex.
#define GUSSET_CELLS_QUADS 1

/// The surface between the rims.
typedef uint32_t gusset_finish;
/// The strip of meridians, with its rows.
#define GUSSET_FINISH_STRIP 0
/// The best-looking joint: triangles about as fine as those round the rims, graded between them, without sharp angles
/// where the rims allow it, on a surface that leaves both pieces along their tangents. The strip, without rows, says
/// which way it goes: meridians and matrix are its own, and no edges of the result; rows, cells and fairing are not
/// read (the log says so if they are set). Where every blend would cut more faces than the strip does, the strip stays;
/// the log says so. The surface bends as the strip does as a whole, without its ridges: a gap in a tube is bridged by a
/// tube, to within some per cent of its radius across a few radii. Time and memory grow with the number of new
/// triangles. Where sides as short as those round the rims would take more than about 50,000 new vertices, or 16 for
/// each of the rims', the sides are up to twice as long; where that is not enough, the strip stays, and the log says
/// so.
#define GUSSET_FINISH_BLEND 1

/// The source of a tolerance.
typedef uint32_t gusset_tolerance_mode;
/// No tolerance is given, and what rounding can do to the coordinates is taken. For vertices that face another loop
/// that is at most 2^-16 of the loops' largest coordinate for 32-bit positions, 2^-45 for 64-bit ones; for vertices
/// that are welded see gusset_weld_options.
#define GUSSET_TOLERANCE_AUTO 0
/// The tolerance is the one given.
#define GUSSET_TOLERANCE_GIVEN 1
/// The tolerance is 0: of vertices that are welded, the positions are equal.
#define GUSSET_TOLERANCE_EXACT 2

/// The side that closed components of a result face.
typedef uint32_t gusset_outward;
/// As the operation does by default: gusset_join as GUSSET_OUTWARD_CLOSED, all others as GUSSET_OUTWARD_KEEP.
#define GUSSET_OUTWARD_AUTO 0
/// Closed components stay as they are; gusset_orient turns each to the side that most of its faces had.
#define GUSSET_OUTWARD_KEEP 1
/// Closed components face outwards, each by its own volume. A shell within another one encloses its own inside, and the
/// wall of a cavity is turned over too. A component whose volume is 0 up to rounding is as with GUSSET_OUTWARD_KEEP.
/// Except in gusset_orient, only components that are closed (every edge has two faces), consistently oriented and
/// inside out are turned over, each as a whole; all others stay as they are.
#define GUSSET_OUTWARD_CLOSED 2

/// How to stitch; all zero is the default.
typedef struct gusset_stitch_options {
    size_t struct_size;
    gusset_meridians meridians;
    gusset_orientation orientation;
    /// The first meridian joins the closest pair that is not joined by an edge already; with a twist, the vertex of rim
    /// B so many places later, counted in the direction in which rim A runs (negative: earlier), and no other start is
    /// tried. Any value; taken modulo the length of rim B. Must be 0 if arcs are joined (OUT_OF_RANGE), and with
    /// GUSSET_EXTENT_OPEN_ARCS also if there are none to join.
    int64_t twist;
    gusset_stitch_extent extent;
    gusset_facing_run run;
    gusset_row_rule rows;
    /// Interior rows, read for GUSSET_ROWS_COUNT.
    /// @when rows GUSSET_ROWS_COUNT
    uint32_t row_count;
    gusset_strip_cells cells;
    gusset_tolerance_mode tolerance_mode;
    /// How far a vertex must be from its loop's plane to face the other loop, in the unit of the positions, at least 0;
    /// read for GUSSET_TOLERANCE_GIVEN.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    double tolerance;
    /// Read for GUSSET_EXTENT_ARCS: the first place on loop A, below its length, and the number of vertices, 1 to its
    /// length. The arc runs along the loop as it was given, and may pass its end.
    uint32_t arc_a[2];
    /// The same on loop B.
    uint32_t arc_b[2];
    gusset_strip_search search;
    gusset_strip_start start;
    /// Read if interior rows are asked for; otherwise the log says that it is not.
    gusset_fairing fairing;
    gusset_intersections intersections;
    gusset_centres centres;
    /// What becomes of closed components of the result, the strip and all.
    gusset_outward outward;
    /// What lies between the rims in the end.
    gusset_finish finish;
    uint32_t reserved;
} gusset_stitch_options;

/* ------------------------------------------------------------------------------------------------------------------ */
/* Facing arcs: Finds which vertices of two loops face each other. */

/// Which vertices of two loops face each other. Opaque and immutable; it keeps nothing of the points.
typedef struct gusset_facing gusset_facing;

/// How facing vertices are found; all zero is the default.
typedef struct gusset_facing_options {
    size_t struct_size;
    gusset_facing_run run;
    gusset_tolerance_mode tolerance_mode;
    /// How far a vertex must be from its loop's plane, in the unit of the points, at least 0; read for
    /// GUSSET_TOLERANCE_GIVEN.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    double tolerance;
    gusset_centres centres;
    uint32_t reserved;
} gusset_facing_options;

/// What algorithm 2 found. Index 0 is loop A, 1 is loop B. Pointers are valid until the handle is destroyed.
typedef struct gusset_facing_view {
    size_t struct_size;
    /// The centres C_1 and C_2 (5): x, y, z of each.
    double centre[2][3];
    /// The vectors C_2 - C_1 and C_1 - C_2 (6), the normals of the planes (7).
    double normal[2][3];
    /// The distance of each vertex from its loop's plane, positive on the side of the other loop; as many as the loop
    /// has.
    const double *distances[2];
    /// All runs of facing vertices: first place and number of vertices, by turns; a run may pass the loop's end.
    struct gusset_indices runs[2];
    /// The run taken: first place and number of vertices, as gusset_stitch_options takes them in arc_a and arc_b.
    uint32_t taken[2][2];
} gusset_facing_view;

/// Finds which vertices of two loops face each other.
/// @param points_a x, y, z of the vertices of each loop in order, packed, count_a and count_b of them, at least 1 each.
/// @param count_a see points_a.
/// @param points_b see points_a.
/// @param count_b see points_a.
/// @errors LOOP_TOO_SHORT, TOO_LARGE, NOT_FINITE, OUT_OF_RANGE, PLANES_UNDECIDED (no vertex of a loop is beyond the
///     tolerance, as with coaxial rims, or the centres coincide)
/// @complexity O((N + M) log M); linear extra memory.
/// @source Nesterenko, algorithm 2, equations 5-7, with a tolerance, and runs instead of subsets.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_facing_create(const struct gusset_context *context,
    const double *points_a, size_t count_a, const double *points_b, size_t count_b,
    const struct gusset_facing_options *options, struct gusset_facing **facing);

/// Destroys what gusset_facing_create made; NULL is allowed.
GUSSET_API void gusset_facing_destroy(struct gusset_facing *facing);

/// Lends what was found.
/// @param facing what was found.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_facing_get_view(const struct gusset_facing *facing,
    struct gusset_facing_view *view);

/// The paper's rule for meridians: for each i = 0 .. n the j = 0 .. m that makes |m i - n j| least, of two equal ones
/// the later.
/// @param n segments of the longer and of the other polyline, m <= n (OUT_OF_RANGE): an open one of N vertices has N -
///     1, a closed one N.
/// @param m see n.
/// @param j receives n + 1 numbers; NULL with capacity 0 asks for how many.
/// @param capacity of j.
/// @param written receives their number; may not be NULL.
/// @errors OUT_OF_RANGE, BUFFER_TOO_SMALL (nothing but the number is written)
/// @complexity O(n).
/// @source Nesterenko, the intermediate mesh: j = floor((2 m i + n) / (2 n)), without the products.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_meridians_index(uint32_t n, uint32_t m, uint32_t *j, size_t capacity,
    size_t *written);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Holes: reports: What filling did to each hole. */

/// The weight that the triangulation of a rim minimises.
typedef uint32_t gusset_fill_weight;
/// The best continuation of the surface round the hole: the least sum of 2 sin(t / 2) over all edges, the rim's
/// included, t being the angle between the normals on both sides, and over the triangles of the mean square of how far
/// the surface that was there is likely to have been from them, as its tangent planes at the rim say, in units of 1 /
/// 140 of its length. By area alone if it is planar.
#define GUSSET_WEIGHT_CONTINUATION 0
/// The least sum of areas and, for each edge, the rim's included, squared length times 1 - cosine of the angle between
/// its faces.
#define GUSSET_WEIGHT_AREA_AND_BEND 1
/// The least largest angle between neighbouring faces, those beyond the rim included, and then the least area, as Liepa
/// has it.
#define GUSSET_WEIGHT_BEND_THEN_AREA 2
/// The least area, exactly.
#define GUSSET_WEIGHT_AREA 3

/// The vertices of a patch.
typedef uint32_t gusset_patch_finish;
/// Triangles between the vertices of the rims.
#define GUSSET_PATCH_PLAIN 0
/// With new vertices, where the plain triangles are, but for those beside creases that go on.
#define GUSSET_PATCH_REFINED 1
/// With new vertices, faired.
#define GUSSET_PATCH_FAIRED 2

/// The outcome for one loop.
typedef uint32_t gusset_hole_status;
/// Filled; with plan_only, to be filled.
#define GUSSET_HOLE_FILLED 0
/// Left: it is no hole, as keep has it.
#define GUSSET_HOLE_KEPT 1
/// Left: it exceeds max_edges, max_length, max_diameter or max_area.
#define GUSSET_HOLE_TOO_LARGE 2
/// Left: an open chain.
#define GUSSET_HOLE_OPEN 3
/// Left: it runs along an edge with three or more faces.
#define GUSSET_HOLE_NON_MANIFOLD 4
/// Left: the faces along it disagree in orientation.
#define GUSSET_HOLE_NOT_ORIENTED 5
/// Left: a given loop of fewer than three vertices, or one that passes a vertex twice.
#define GUSSET_HOLE_NOT_SIMPLE 6
/// Left: an edge of a given loop does not have exactly one face, or is one of a loop before it.
#define GUSSET_HOLE_NOT_FREE 7
/// Left: every triangulation would have an edge between two vertices of one old face, which is an edge of the mesh or
/// becomes one once its polygons are cut into triangles; or none was found that closes all loops together which are to
/// get one patch, as where two of them share a vertex.
#define GUSSET_HOLE_NO_TRIANGULATION 8

/// The account of one loop.
typedef struct gusset_hole {
    /// Its vertices are rims.data[rim_first] and on: with the surface on the left as it was before closed components
    /// were turned outwards, or, of a given loop that is not simple, free or oriented, as given.
    size_t rim_first;
    /// How many they are.
    size_t rim_count;
    /// Its patch's first face in the result: the faces and the new vertices of a patch of several loops are in the
    /// accounts of all of them.
    size_t face_first;
    /// How many faces the patch has.
    size_t face_count;
    /// The patch's first new vertex in the result.
    size_t vertex_first;
    /// How many new vertices the patch has.
    size_t vertex_count;
    /// The sum of its edges' lengths, in the unit of the positions.
    double length;
    /// The diagonal of the box round it, along the axes.
    double diameter;
    /// The area of the cone of triangles from its edges to their common centre: that of the hole if it is planar and
    /// convex, more otherwise.
    double area;
    gusset_hole_status status;
    /// The weight that the patch's triangulation is best by: the one asked for, or one that cuts less.
    gusset_fill_weight weight;
    /// What the patch is made of: what was asked for, or less, which cuts less.
    gusset_patch_finish finish;
    /// The number of the patch, from 0 on in the order of the faces; loops with the same number have one patch.
    /// UINT32_MAX if it has none, as all have in a plan.
    uint32_t patch;
} gusset_hole;

/// The accounts of all loops. Pointers are valid until the result is destroyed.
typedef struct gusset_fill_report {
    size_t struct_size;
    /// One for each loop: those given, in their order, or all that the mesh has, as gusset_boundary_get_loop numbers
    /// them. NULL if there are none.
    const struct gusset_hole *holes;
    /// How many.
    size_t hole_count;
    /// The vertices of all rims.
    struct gusset_indices rims;
    /// Of each new vertex, in their order, three vertices of its patch's rims.
    struct gusset_indices parents;
    /// How much it has of each of them, three numbers a vertex, at least 0 with sum 1; NULL without new vertices. They
    /// place it at the nearest point of the plain triangulation of the rims, which it is itself if its patch was
    /// neither faired nor creased, or if the hole is flat.
    const double *weights;
    /// Pairs of faces of the result that cut each other, two numbers a pair, the larger one first, which is a new
    /// face's; ascending. What they share, a vertex or an edge, is no cut, nor are vertices and edges at the same
    /// place; any other touch is. Exact.
    struct gusset_indices intersections;
    /// Faces of the result, old and new ones, that GUSSET_OUTWARD_CLOSED turned over, ascending. Each keeps its first
    /// corner and has the others in reverse order.
    struct gusset_indices turned_outwards;
    /// 1 if intersections were looked for, 0 if not.
    uint32_t intersections_known;
    uint32_t reserved;
} gusset_fill_report;

/* ------------------------------------------------------------------------------------------------------------------ */
/* Holes: Closes holes by new triangles. */

/// The loops that are not holes.
typedef uint32_t gusset_fill_keep;
/// All loops are holes.
#define GUSSET_KEEP_NONE 0
/// The longest loop is none: the outline of an open sheet.
#define GUSSET_KEEP_LONGEST 1
/// Loops are none that go round a sheet rather than a hole in it, so that a patch would lie on the sheet: whose area
/// vector points as that of their component, and is at least half as long as its area.
#define GUSSET_KEEP_BORDERS 2

/// The loops that get one patch.
typedef uint32_t gusset_fill_together;
/// Each loop gets a patch of its own.
#define GUSSET_TOGETHER_APART 0
/// All loops that are filled get one patch: a surface of genus 0 between them. If they are not in one plane, up to some
/// 160 loops.
#define GUSSET_TOGETHER_ONE 1
/// Loops get one patch where that costs less, by the weight asked for, than patches of their own. Loops whose boxes,
/// each larger on all sides by half its diagonal, meet are tried, the pair that gains most first: about 8 pairs for
/// each loop and 256 in all, as the log says, and at most 16 loops for a patch. By area alone the ends of a short tube
/// cost less together, along the tube itself.
#define GUSSET_TOGETHER_CHEAPEST 2

/// The new vertices of patches.
typedef uint32_t gusset_fill_refinement;
/// No new vertices.
#define GUSSET_REFINE_NONE 0
/// New vertices as dense as those round the hole.
#define GUSSET_REFINE_RIM_DENSITY 1

/// How smoothly faired patches continue the old surface.
typedef uint32_t gusset_fill_continuity;
/// Faired patches leave the old surface along its tangent planes: the plate's squared Laplacian is least.
#define GUSSET_CONTINUITY_C1 0
/// They go on with its curvature, too: the squared gradient of the Laplacian is least. Two rings of old faces round
/// each rim have a say, and with them their noise.
#define GUSSET_CONTINUITY_C2 1

/// How holes are filled; all zero is the default: triangles without new vertices, in every hole.
typedef struct gusset_fill_options {
    size_t struct_size;
    gusset_fill_weight weight;
    gusset_fill_refinement refine;
    /// Read if new vertices are asked for; otherwise the log says that it is not.
    gusset_fairing fairing;
    /// Which loops are no holes; read if all loops are asked for.
    gusset_fill_keep keep;
    /// Whether faces of patches that cut each other or old faces are looked for, and avoided by less fairing, other
    /// weights and no new vertices (AUTO), only reported (REPORT), or neither (IGNORE).
    gusset_intersections intersections;
    /// 1: nothing is filled or turned over; the accounts say which loops would be tried, and with which weight and
    /// finish. Loops that turn out to have no triangulation are not foreseen, nor which of them together says get one
    /// patch. 0 or 1.
    /// @flag
    uint32_t plan_only;
    /// About how many new vertices a patch gets, at most about twice as many; where more would be needed the triangles
    /// are larger. 0: 50,000, or four for each vertex of its rims if that is more, and as many again for sharp angles
    /// there.
    uint32_t max_new_vertices;
    /// Loops of more edges are left alone. 0 is no limit.
    uint32_t max_edges;
    /// Longer loops are left alone, in the unit of the positions, at least 0. 0 is no limit.
    double max_length;
    /// Loops in a box along the axes with a longer diagonal are left alone. 0 is no limit.
    double max_diameter;
    /// Loops with a larger area, as gusset_hole has it, are left alone. 0 is no limit.
    double max_area;
    /// What becomes of closed components of the result, patches and all.
    gusset_outward outward;
    /// Which loops get one patch; read without groups.
    gusset_fill_together together;
    /// A number for each of the loops given, loop_count in all: those with the same number get one patch, a surface of
    /// genus 0 between them, but for loops that are left for reasons of their own. NULL: as together says. Needs loops.
    const uint32_t *groups;
    /// How smoothly faired vertices go on the surface round the hole.
    gusset_fill_continuity continuity;
    /// 1: creases of the old surface that end at a rim end there, and no patch goes on with them. 0 or 1.
    /// @flag
    uint32_t ignore_creases;
} gusset_fill_options;

/// Fills holes of a mesh: closes boundary loops by new triangles, oriented as the surface round them. Loops that cannot
/// be filled are left, which is no error: the account of each says why. The result has the old vertices with their bits
/// and indices, then the new ones; the old faces, which are turned over only if outward says so, then the new
/// triangles, hole by hole. No new edge joins two vertices of one old face, so that a result that is closed stays so
/// when its polygons are cut into triangles. A planar hole gets no overlaps by the default weight and by area, however
/// concave it is, also one round islands, if its rims do not cross. Creases of the old surface that end at a rim go on
/// across the patch, by plain triangles where they are straight: joined in pairs, or three and more in a new vertex
/// where they meet. A crease without a counterpart ends at the rim. Patches of several loops have none, and with
/// ignore_creases none has. Several loops get one patch where options.groups or options.together says so: a surface of
/// genus 0 between them. If none is found, by a search that is not complete, or two of the loops share a vertex, all of
/// them are left; GUSSET_TOGETHER_CHEAPEST leaves such loops apart. Faces of a patch that cut each other or old faces
/// are looked for, exactly. Where there are any, less fairing, the other weights and no new vertices are tried, and
/// what cuts least is taken; the view has the pairs that are left. No faired vertex leaves the box round its rims,
/// larger on all sides by half its diagonal.
/// @param loops the vertices of each loop in order, in either direction, each consecutive pair (and the last with the
///     first) an edge with exactly one face; loop_count of them. NULL with 0: all loops that the mesh has.
/// @param loop_count see loops.
/// @errors as gusset_mesh_view, INDEX_OUT_OF_RANGE (with the place in the loop, whose number is the report's input),
///     NULL_ARGUMENT (groups without loops), OUT_OF_RANGE, TOO_LARGE
/// @complexity Loops of n <= 128 vertices: O(n^3) time and 30 n^2 bytes, the best triangulation (of least area:
///     exactly); longer ones: from coarse to fine, O(n), or, if they are planar, ear by ear, O(n log n); linear memory.
///     Several loops of n vertices in all: O(n log n) if they are few, O(n^3) if they are many. Besides O(H log d) for
///     H half-edges and at most d edges at a vertex, and O(m^1.5) for m new vertices of a hole. The search for cuts:
///     O(n log n) for n faces near the holes, and the pairs whose boxes overlap, in the worst case O(n^2). Loops that
///     touch at one vertex look at each other's edges there.
/// @source Barequet and Sharir 1995; Liepa, Filling holes in meshes, 2003.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_fill(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_indices *loops, size_t loop_count,
    const struct gusset_fill_options *options, struct gusset_result **result);

/// Lends the reports of the loops, for results of gusset_fill.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_fill(const struct gusset_result *result,
    struct gusset_fill_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Joining: Joins many open pieces to one mesh. */

struct gusset_join_options;

/// Joins open pieces into one mesh: coincident borders are sewn, components oriented alike, loops that face each other
/// across a gap stitched, holes filled, and closed components turned outwards, as the options say. That two loops
/// cannot be joined is no failure: each joint has its outcome. Loops of different components face each other as wholes
/// if nearly all vertices of each (9/10) are nearest to the other loop, and from similar distances (the ninth decile is
/// at most four times the first, or the spacing of the vertices) or so that the nearest vertices go round the other
/// loop once; else runs of neighbouring vertices that are nearest to each other face each other, and are joined by open
/// strips. What faces nothing is left alone. Pieces that overlap are not cut unless overlaps says so: where two lie on
/// each other, their borders face each other and enclose what is between. Vertices of the result: those of the pieces
/// in order, then those of the strips, then those of the patches; faces in the same way. Positions are of the scalar
/// type of the first piece, and old ones keep their bits.
/// @param pieces piece_count mesh views one after another, each as large as the first one's struct_size says, at least
///     one; each may have several components.
/// @param piece_count see pieces.
/// @errors as gusset_mesh_view (the report's input is the piece), EMPTY_MESH (without pieces), MIXED_SCALARS (a piece
///     has f64 positions and the first one f32), OUT_OF_RANGE (a tolerance, max_gap, or one of pairs or of excluded:
///     the report's index is its number, its input is 0 or 1 for the first or the second loop, its value the piece that
///     does not exist, else the vertex, and the message says what is wrong: there is no such piece, or no such vertex
///     of it; of pairs also: no vertex is named, no loop that can be joined passes it or several do, it is on the
///     pair's other loop, or its loop is in a pair before), TOO_LARGE
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex, O(V log V) for V vertices on loops, the
///     time of each strip as for gusset_stitch, and of each hole as for gusset_fill; a pass over all faces for each
///     strip that is faired or tested for intersections. Extra memory is linear in the pieces and the result.
/// @source Nesterenko for a single gap; the rest is our own.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_join(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_join_options *options,
    struct gusset_result **result);

struct gusset_join_report;

/// Lends the report on pieces, joints, loops and holes, for results of gusset_join.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_join(const struct gusset_result *result,
    struct gusset_join_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Options of joining: Which borders are joined, and how. */

/// The treatment of coincident borders of pieces.
typedef uint32_t gusset_welding;
/// Coincident borders are sewn, by default up to what rounding can have done; see gusset_weld_options. Where their
/// vertices do not match, edges are split; see gusset_sew.
#define GUSSET_WELDING_SEW 0
/// Nothing is welded.
#define GUSSET_WELDING_NONE 1
/// Coincident borders are sewn where they match vertex by vertex; see gusset_weld.
#define GUSSET_WELDING_EDGE_TO_EDGE 2

/// The widest gap that is closed.
typedef uint32_t gusset_gap;
/// Whole loops are joined if the mean width of the gap is at most a fifth of the larger component's size along an axis,
/// or the mean radius of the smaller loop (the mean distance of its vertices from their centre) if that is more; two
/// loops that are the only ones, of two pieces, whatever it is. Runs of loops are joined where the gap is at most half
/// that radius wide, and four edges of the loop with the longer ones. The width is the mean distance from each loop to
/// the nearest points of the other, the larger of the two. Loops must look at each other, or lie round each other: of
/// all that do, the best one-to-one choice is joined. What sewing left of two borders is joined with itself if it is at
/// most one of its mean edges wide, and half its radius; wider it may be a hole that the seam crosses. Between pieces
/// whose overlaps are trimmed, the gap is at most two and a half mean edges of the coarsest wide, or four where a part
/// would be left alone.
#define GUSSET_GAP_AUTO 0
/// Gaps are closed up to max_gap.
#define GUSSET_GAP_GIVEN 1

/// The treatment of pieces that overlap.
typedef uint32_t gusset_overlaps;
/// Pieces that overlap stay as they are.
#define GUSSET_OVERLAPS_KEEP 0
/// Of each overlap one piece is kept, as gusset_trim_create chooses, and the gaps that this leaves are closed as others
/// are. Strips that would cut other faces are left to the holes.
#define GUSSET_OVERLAPS_TRIM 1

/// Two loops of the input.
typedef struct gusset_loop_pair {
    /// The piece of each.
    uint32_t piece[2];
    /// A vertex of each piece that the loop passes; UINT32_MAX for all loops of the piece, in exclusions only.
    uint32_t vertex[2];
} gusset_loop_pair;

struct gusset_trim_options;

struct gusset_weld_options;

/// How pieces are joined; all zero is the default.
typedef struct gusset_join_options {
    size_t struct_size;
    gusset_welding weld;
    /// GUSSET_ORIENTATION_FIX: within each component the minority of faces is turned over, and components that face
    /// each other are made to agree. GUSSET_ORIENTATION_KEEP: nothing is turned, nor in the end.
    gusset_orientation orientation;
    gusset_gap gap;
    /// 1: only whole loops are joined, no parts of them, nor what sewing left of two borders. 0 or 1.
    /// @flag
    uint32_t whole_loops_only;
    /// 1: loops of one component may be joined without being asked for. 0 or 1.
    /// @flag
    uint32_t within_components;
    /// 1: holes that are left in the end are filled. 0 or 1.
    /// @flag
    uint32_t fill;
    /// Read for GUSSET_GAP_GIVEN: the widest gap that is closed, in the unit of the positions, finite and at least 0; 0
    /// leaves all open.
    /// @when gap GUSSET_GAP_GIVEN
    double max_gap;
    /// Pairs of loops to be joined however wide the gap is, as wholes, or NULL. Each names two different loops, or the
    /// same one twice if sewing left it of two borders (see gusset_joint), and none is named in two pairs. Errors name
    /// a pair by its number from 0, and say what is wrong with it.
    const struct gusset_loop_pair *pairs;
    /// How many.
    size_t pair_count;
    /// Pairs that are not to be joined, or NULL. A pair that is given above is joined all the same, and a vertex that
    /// no loop passes, as it was welded, excludes nothing.
    const struct gusset_loop_pair *excluded;
    /// How many.
    size_t excluded_count;
    /// How to weld; NULL for the defaults.
    const struct gusset_weld_options *weld_options;
    /// The strips, NULL for the defaults: meridians, search, start, rows, row_count, cells, fairing, intersections and
    /// finish are read; the other fields must be valid too.
    const struct gusset_stitch_options *strip_options;
    /// How to fill, NULL for the defaults. groups, outward and plan_only are not read, but the last two must be valid
    /// too; intersections REPORT is as IGNORE.
    const struct gusset_fill_options *fill_options;
    /// The side that closed components of the result face; outwards by default. The wall of a cavity within another
    /// component is turned too. A result that is not turned is mostly as the first piece has it.
    gusset_outward outward;
    /// GUSSET_OVERLAPS_KEEP or GUSSET_OVERLAPS_TRIM.
    gusset_overlaps overlaps;
    /// Read for GUSSET_OVERLAPS_TRIM: how to trim; NULL for the defaults.
    /// @when overlaps GUSSET_OVERLAPS_TRIM
    const struct gusset_trim_options *trim_options;
} gusset_join_options;

/* ------------------------------------------------------------------------------------------------------------------ */
/* Joining: reports: What became of each joint and each loop. */

/// The outcome for two loops that face each other.
typedef uint32_t gusset_joint_outcome;
/// A strip joins them.
#define GUSSET_JOINT_JOINED 0
/// Left: joining them would make a one-sided surface with what is joined already.
#define GUSSET_JOINT_ORIENTATION_CONFLICT 1
/// Left: they pass the same vertex.
#define GUSSET_JOINT_SHARE_VERTEX 2
/// Left: every strip would repeat an edge that the mesh already has.
#define GUSSET_JOINT_NO_STRIP 3
/// Left: between pieces whose overlaps were trimmed, as every strip would cut other faces. It is a part of a hole then.
#define GUSSET_JOINT_WOULD_CUT 4

/// The reason why a loop has no strip.
typedef uint32_t gusset_left_reason;
/// There is no other loop.
#define GUSSET_LEFT_ALONE 0
/// It is open, or the faces along it disagree in orientation or are not manifold there.
#define GUSSET_LEFT_NOT_SIMPLE 1
/// It has fewer than three vertices.
#define GUSSET_LEFT_TOO_SHORT 2
/// It faces another loop, but no strip could be made: see the joints.
#define GUSSET_LEFT_NOT_JOINED 3
/// The nearest loop is farther away than is allowed; or the loop is what sewing left of two borders, and its two sides
/// are. See gap and allowed_gap.
#define GUSSET_LEFT_TOO_FAR 4
/// All other loops are of its own component, and within_components is not set.
#define GUSSET_LEFT_SAME_COMPONENT 5
/// The nearest loop is near enough, but they do not look at each other along enough of both.
#define GUSSET_LEFT_LOOKS_AWAY 6
/// The nearest loop is joined with another.
#define GUSSET_LEFT_TAKEN 7
/// It is not to be joined with the nearest loop.
#define GUSSET_LEFT_EXCLUDED 8

/// Where a piece went.
typedef struct gusset_piece_map {
    /// Per vertex of the piece, its index in the result; several may have the same. UINT32_MAX if it was left out.
    struct gusset_indices vertices;
    /// Per face, its index in the result, or UINT32_MAX; of a triangle that was cut, that of the first part, which the
    /// others follow.
    struct gusset_indices faces;
} gusset_piece_map;

/// Two loops, or runs of loops, that face each other across a gap. Of two borders that coincide along a part only,
/// sewing leaves loops that run along the rest of one and back along the other; they turn at two vertices that sewing
/// made of several. Such a loop may be joined with itself: both sides are on it, one of them with both ends, whole is
/// 0, and the strip has no interior rows whatever the options say.
typedef struct gusset_joint {
    /// The vertices of each side in the result, in order; if joined, side by side from the first meridian on. The order
    /// is that of before closed components were turned outwards.
    struct gusset_indices side[2];
    /// The mean width of the gap; of a loop that is joined with itself the mean distance of its sides.
    double gap;
    /// The strip's first new vertex in the result.
    size_t vertex_first;
    /// How many new vertices it has.
    size_t vertex_count;
    /// The strip's first face in the result.
    size_t face_first;
    /// How many faces it has.
    size_t face_count;
    /// Pairs of faces that cut each other, as in gusset_stitch_report.
    struct gusset_indices intersections;
    /// 1 if they were looked for.
    uint32_t intersections_known;
    gusset_joint_outcome outcome;
    /// 1 if both sides are whole loops.
    uint32_t whole;
    /// What the strip is. A blend that was asked for may have had to give way to the strip.
    gusset_finish finish;
} gusset_joint;

/// A boundary loop of the sewn pieces that no strip hangs on. It is listed even if it was filled afterwards: holes says
/// what became of it then.
typedef struct gusset_left_loop {
    /// Its vertices in the result, in order.
    struct gusset_indices vertices;
    /// The mean distance from its vertices to the nearest of the loop that is nearest to most of them, of another
    /// component where there is one; infinite if there is none, or if this loop cannot carry a strip. Of what sewing
    /// left of two borders, whose sides are too far from each other, the mean distance of these.
    double gap;
    /// How far that loop, or that side, may be to be joined; 0 if there is none.
    double allowed_gap;
    gusset_left_reason reason;
    uint32_t reserved;
} gusset_left_loop;

/// The report of a join. Pointers are valid until the result is destroyed.
typedef struct gusset_join_report {
    size_t struct_size;
    /// One for each piece.
    const struct gusset_piece_map *pieces;
    /// How many.
    size_t piece_count;
    /// The pairs that face each other: those that were given, in their order, then the others, nearest first.
    const struct gusset_joint *joints;
    /// How many.
    size_t joint_count;
    /// The loops that no strip hangs on, by their smallest vertices; those that were filled in the end are among them.
    /// loops_left counts what is open now.
    const struct gusset_left_loop *left;
    /// How many.
    size_t left_count;
    /// The holes that were looked at in the end.
    const struct gusset_hole *holes;
    /// How many.
    size_t hole_count;
    /// The vertices of their rims, in the order of before closed components were turned outwards.
    struct gusset_indices hole_rims;
    /// Faces of the pieces that run the other way than they did in their pieces, by their indices in the result: turned
    /// to agree with others, or with their component to face outwards, but not both. Faces of strips and patches were
    /// nothing before, and are not listed: they run as the faces of pieces beside them do.
    struct gusset_indices turned;
    /// A face of each component that cannot be oriented.
    struct gusset_indices one_sided;
    /// A face of each closed component of the result that encloses no volume up to rounding, as a piece does that is
    /// given twice. Empty with GUSSET_ORIENTATION_KEEP or GUSSET_OUTWARD_KEEP.
    struct gusset_indices zero_volume;
    /// Vertices that became one with another.
    uint32_t welded_vertices;
    /// Edges that were two free edges.
    uint32_t sewn_edges;
    /// Boundary loops of the result.
    uint32_t loops_left;
    /// Edges of the result with three or more faces.
    uint32_t non_manifold_edges;
    /// Points at which free edges were split for borders to match.
    uint32_t splits;
    /// Entries of left that have another loop within the gap that is allowed: those that look away, whose partner is
    /// taken, or that no strip could join.
    uint32_t near_loops_left;
    /// Faces that were trimmed from overlaps.
    uint32_t trimmed_faces;
    uint32_t reserved;
} gusset_join_report;

/* ------------------------------------------------------------------------------------------------------------------ */
/* Orientation: Turns faces over until neighbours agree. */

/// How to orient; all zero is the default.
typedef struct gusset_orient_options {
    size_t struct_size;
    gusset_outward outward;
    uint32_t reserved;
} gusset_orient_options;

/// What was turned, and what could not be oriented. Pointers are valid until the result is destroyed.
typedef struct gusset_orient_report {
    size_t struct_size;
    /// Per face, 1 if it was turned over, else 0.
    const uint8_t *turned;
    /// The number of faces.
    size_t face_count;
    /// The smallest face of each component that cannot be oriented, ascending. Such components stay as they are.
    struct gusset_indices one_sided_faces;
    /// For each of them, a half-edge of it at which two faces disagree when others agree.
    struct gusset_indices one_sided_half_edges;
    /// The number of faces turned over.
    uint32_t turned_faces;
    /// Components: faces that hang together across edges of two faces. A degenerate face is one of its own.
    uint32_t component_count;
    /// Closed components that face outwards now and, without GUSSET_OUTWARD_CLOSED, would not.
    uint32_t inverted_components;
    uint32_t reserved;
} gusset_orient_report;

/// Turns faces over until faces that share an edge of two faces run it in opposite directions. In each component as few
/// faces as possible are turned; where both sides are as many, its smallest face stays. Edges of three or more faces
/// connect nothing. A component that cannot be oriented, such as a Moebius strip, stays as it is and is listed. A
/// turned face keeps its first corner and has the others in reverse order; all else is as it was: vertices, positions,
/// order of faces.
/// @errors as gusset_mesh_view
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex; linear extra memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_orient(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_orient_options *options, struct gusset_result **result);

/// Lends the flags, lists and counts, for results of gusset_orient.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_orient(const struct gusset_result *result,
    struct gusset_orient_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Results: The mesh that an operation makes, with the report of the operation. */

/// A mesh that an operation made, with the report of that operation. Opaque and immutable; it keeps nothing of the
/// inputs. gusset_join, gusset_stitch, gusset_strip, gusset_fill, gusset_weld, gusset_sew, gusset_orient,
/// gusset_develop, gusset_net_to_mesh and gusset_sheet_to_mesh make results. Each operation has a report of its own:
/// gusset_result_get_join and so on.
typedef struct gusset_result gusset_result;

/// Measures of the new faces of a stitch or of filled holes, and of the connectivity of the whole result.
typedef struct gusset_quality_report {
    size_t struct_size;
    /// The smallest angle of the new triangles, in radians; 0 if one is degenerate.
    double min_angle;
    /// The largest aspect ratio of the new triangles: longest side / (2 sqrt(3) inscribed radius), 1 for an equilateral
    /// triangle, infinite for a degenerate one.
    double max_aspect;
    /// The longest edge of the new faces, in the unit of the positions.
    double max_edge;
    /// Their area, in the square of that unit.
    double area;
    /// New triangles without area.
    uint32_t degenerate_faces;
    /// Boundary loops of the result; 0 if no edge has exactly one face.
    uint32_t loops_left;
    /// Edges of the result with three or more faces.
    uint32_t non_manifold_edges;
    /// Edges of the result whose two faces disagree in orientation.
    uint32_t orientation_conflicts;
} gusset_quality_report;

/// Destroys a result; NULL is allowed.
GUSSET_API void gusset_result_destroy(struct gusset_result *result);

/// Lends the mesh, valid until the result is destroyed.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_mesh(const struct gusset_result *result,
    struct gusset_mesh_view *view);

/// Gives measures of the new faces and of the result, for results of gusset_stitch and gusset_fill.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_quality(const struct gusset_result *result,
    struct gusset_quality_report *quality);

/// Finds where the vertices, corners and faces of a result come from. The inputs are the meshes or pieces of the
/// operation in their order, or its one mesh, net or sheet:
/// - a strip has two polylines, which have neither corners nor faces; nor have its corners and faces any sources;
/// - a corner that gusset_sew added on an edge has the corners of its face at both ends of that edge;
/// - each vertex of a development comes from one vertex, and its corners and faces are those of the surface;
/// - a vertex of the mesh of a net has the first of its nodes, and a face its cell. A corner has the node of the cell
///   of its own face, which differs on either side of a seam: an image need not run back there;
/// - the nodes of a sheet are those between its cells, (rows + 1) * (columns + 1) of them, row after row. A vertex and
///   a corner have the nodes of their cell, by its parameters, and faces have their cells. On a line that closes the
///   sheet each corner has the nodes on the side of its own face.
/// @errors TOO_LARGE
/// @complexity O(H log n) for H corners, n of them of new faces; 16 bytes for each vertex, corner and face (of a sheet
///     52 for each vertex and corner), and linear in n.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_origins_create(const struct gusset_context *context,
    const struct gusset_result *result, struct gusset_origins **origins);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Sewing: Joins coincident borders, also where their vertices do not match. */

/// What became of the old mesh. Lists are ascending; pointers are valid until the result is destroyed.
typedef struct gusset_sew_report {
    size_t struct_size;
    /// Per old vertex, its index in the result; UINT32_MAX if it was left out as unused.
    struct gusset_indices vertex_map;
    /// Per old face, the index in the result of the first face that it became; UINT32_MAX if it was dropped.
    struct gusset_indices face_map;
    /// Per face of the result, the old face that it is, or is a part of; ascending.
    struct gusset_indices face_origin;
    /// Old vertices that lie together with another, or inside a free edge, and are not sewn to it.
    struct gusset_indices left_vertices;
    /// Vertices that became one with a smaller one.
    uint32_t welded_vertices;
    /// Edges of two faces that were free edges, or parts of such.
    uint32_t sewn_edges;
    /// Points at which free edges were split.
    uint32_t splits;
    /// Old faces that were cut or gained corners.
    uint32_t split_faces;
    /// Old faces that were dropped.
    uint32_t dropped_faces;
    uint32_t reserved;
    /// How far apart what lies together was allowed to be, short edges apart; 0 for equal positions.
    double tolerance;
} gusset_sew_report;

/// Sews borders that lie on one another, also where their vertices do not match. Vertices are welded first, as by
/// gusset_weld. Where a vertex of one border then lies inside a free edge of another (a T-junction), the edge is split
/// there, if that makes pieces of which exactly two lie on one another; triangles with split edges are cut into
/// triangles, none of them turned over, and larger faces gain corners. Then borders are welded again. So the result has
/// no edge of three or more faces and no degenerate face that welding alone would not have made. Vertices that lie
/// inside an edge which is not split there are listed as left, as are those that welding leaves. A vertex lies inside
/// an edge that is longer than twice the tolerance if it is within the tolerance of it and beyond that from both its
/// ends. By default it is that of welding: see gusset_weld_options. The result has the old faces in their order, and
/// the parts of one in place of it, one after the other. Of vertices made one the smallest is left, and its position
/// keeps its bits; new vertices have the position of an old one.
/// @param options how to weld, NULL for the defaults. With GUSSET_WELD_ALL all vertices are welded before edges are
///     split, and borders after it.
/// @errors as gusset_weld, TOO_LARGE (the result has too many elements)
/// @complexity O(H log H) for H half-edges, if no vertex has very many and few vertices lie inside each edge; linear
///     extra memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sew(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_weld_options *options, struct gusset_result **result);

/// Lends the maps, lists and counts, for results of gusset_sew.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_sew(const struct gusset_result *result,
    struct gusset_sew_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Stitching: Joins two loops by a strip of new faces. */

/// The parts of a stitch. Pointers are valid until the result is destroyed. Index 0 is the first mesh, 1 the second.
typedef struct gusset_stitch_report {
    size_t struct_size;
    /// Per old vertex of each mesh, its index in the result; empty for the second if there was only one mesh.
    struct gusset_indices vertex_map[2];
    /// Per old face, its index in the result.
    struct gusset_indices face_map[2];
    /// The vertices of each rim, by their indices in the result, from the first meridian on, side by side: rim 0 has
    /// its surface on the left, rim 1 on the right, as they were before closed components were turned outwards. They
    /// are also the strip's own first vertices in order: rim 0, then rim 1.
    struct gusset_indices rim[2];
    /// The meridians as places on the rims, i and j by turns, the paper's matrix H: meridian k is (data[2 k], data[2 k
    /// + 1]). They go from (0, 0) to (N, M) for whole rims of N and M vertices, where place N is place 0 again, and to
    /// (N - 1, M - 1) for arcs; count is twice the number of meridians. From one to the next i advances by 1, or j, or
    /// both: by the rule by index and with GUSSET_MERIDIANS_QUAD.
    struct gusset_indices meridians;
    /// The paper's matrix P, row by row from rim 0 to rim 1, one column for each meridian: vertices of the result.
    struct gusset_indices matrix;
    /// Of each new vertex (they are the last ones of the result), three vertices of the rims that it lies between: in a
    /// row the ends of its meridian, that on rim 1 twice; of a blend the corners of the triangle of the strip that it
    /// would be on without fairing.
    struct gusset_indices parents;
    /// How much it has of each of them, three numbers a vertex, at least 0 with sum 1; in row k of r rows 1 - k / (r +
    /// 1), k / (r + 1) and 0. NULL without new vertices.
    const double *weights;
    /// The first of the strip's faces in the result; they are the last ones.
    size_t strip_face_first;
    /// How many there are; N + M triangles for whole rims without interior rows. A blend has as many as it needs, and
    /// meridians and matrix are those of the strip that it follows.
    size_t strip_face_count;
    /// Interior rows; the matrix has two rows more. 0 of a blend.
    uint32_t row_count;
    /// 1 if the strip is a closed band between whole loops, 0 if it joins arcs.
    uint32_t closed;
    /// 1 if the component that rim 1 is on was turned over to agree with the other, else 0: its faces run the other
    /// way, each from its own first corner. Other components stay as they are.
    uint32_t turned;
    /// 1 if faces that cut each other were looked for, else 0.
    uint32_t intersections_known;
    /// Pairs of faces of the result that cut each other, by turns: first one of the strip, the larger one if both are.
    /// What they share, a vertex or an edge, is no cut, nor are vertices and edges at the same place; any other touch
    /// is. Exact. Polygons are taken as triangles: quads split by their shorter diagonals, others as fans from their
    /// first corners; a polygon that cuts itself is paired with itself.
    struct gusset_indices intersections;
    /// How often the fairing, of rows or of the blend that was kept, had to be taken back in places.
    uint32_t back_off_count;
    /// What the strip is. A blend that was asked for may have had to give way to the strip.
    gusset_finish finish;
    /// Faces of the result, those of the strip too, that GUSSET_OUTWARD_CLOSED turned over in the end, ascending. Each
    /// keeps its first corner and has the others in reverse order.
    struct gusset_indices turned_outwards;
} gusset_stitch_report;

/// Joins two boundary loops, of two meshes or of one, by a strip of new faces: a closed band between whole loops, or a
/// strip between the arcs that face each other. The result has the vertices of A, then of B, then new ones in the
/// interior rows; the faces of A, then of B, then the strip. Positions are of the scalar type of A, old ones keep their
/// bits, and every old face is kept. An arc of one vertex gets a fan, which touches its piece at that vertex only; two
/// arcs of one vertex each get one meridian and no face.
/// @param loop_a the vertices of each loop in order, in either direction, each consecutive pair (and the last with the
///     first) an edge with exactly one face. If both are NULL, the loops that lie nearest to each other are taken; if
///     one is, the loop of its mesh that is nearest to the one given. Those to choose from are not open, have three
///     vertices or more, and the faces along them agree in orientation and are manifold there; two of one mesh share no
///     vertex.
/// @param mesh_b NULL if both loops are of mesh_a.
/// @param loop_b see loop_a.
/// @errors as gusset_mesh_view, OUT_OF_RANGE, PLANES_UNDECIDED, NO_LOOP (of one mesh: it has no two that share no
///     vertex), LOOP_TOO_SHORT, LOOP_REPEATS_VERTEX, LOOP_EDGE_NOT_FREE, LOOP_NOT_ORIENTED, LOOPS_SHARE_VERTEX,
///     ORIENTATION_CONFLICT, NO_STRIP, MIXED_SCALARS (A has f32 and B f64 positions), TOO_LARGE
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex; plus for the meridians O(N M) up to 2^21
///     pairs of vertices, beyond that and for the simple rules O((N + M) log M); plus the size of the strip, and
///     fairing and intersection tests where asked for (O(n log n) and a test for each pair of triangles whose boxes
///     overlap, which is all pairs in the worst case); plus, for a blend of n new vertices, O(n log n) and the solution
///     of up to five plates, O(n^1.5) each, nearly linear where the gap is narrow; plus a box test for each pair of
///     loops where the choice is left open. Extra memory is linear in the meshes and the strip; GUSSET_SEARCH_EXACT
///     takes one byte for each of up to 2^26 pairs of vertices and 8 M bytes for each 2^26 pairs begun, with
///     GUSSET_MERIDIANS_CONTINUATION or _SMOOTH 2 bytes for each pair, where the best strip would use an edge twice 8;
///     twice that with more than one thread and two starts.
/// @source Nesterenko, algorithm 2 and the intermediate mesh (H, P). Whole loops repeat their start: N + 1 and M + 1
///     points.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stitch(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh_a, const struct gusset_indices *loop_a, const struct gusset_mesh_view *mesh_b,
    const struct gusset_indices *loop_b, const struct gusset_stitch_options *options, struct gusset_result **result);

/// Lends the strip of a stitch alone: the vertices of the two rims, the new ones, and the faces between them.
/// @errors as gusset_result_get_stitch
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_strip_mesh(const struct gusset_result *result,
    struct gusset_mesh_view *view);

/// Lends the maps, rims and meridians, for results of gusset_stitch.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_stitch(const struct gusset_result *result,
    struct gusset_stitch_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Strips: Builds a strip of triangles between two polylines that belong to no mesh. */

/// How a strip is made; all zero is the default.
typedef struct gusset_strip_options {
    size_t struct_size;
    gusset_meridians meridians;
    gusset_strip_search search;
    /// For closed polylines; open ones begin at their first points.
    gusset_strip_start start;
    /// 1: the polylines are closed; 0: they are open.
    /// @flag
    uint32_t closed;
    /// The mean edge is the mean segment of both polylines.
    gusset_row_rule rows;
    /// Interior rows, read for GUSSET_ROWS_COUNT.
    /// @when rows GUSSET_ROWS_COUNT
    uint32_t row_count;
    gusset_strip_cells cells;
    uint32_t reserved;
} gusset_strip_options;

/// The parts of a strip. Pointers are valid until the result is destroyed.
typedef struct gusset_strip_report {
    size_t struct_size;
    /// The points of A and of B that the first meridian joins.
    uint32_t start[2];
    /// The meridians as places counted from there, i and j by turns: from (0, 0) to (N, M) for closed polylines of N
    /// and M points, where place N is place 0 again, and to (N - 1, M - 1) for open ones; count is twice the number of
    /// meridians.
    struct gusset_indices meridians;
    /// The paper's matrix P, row by row from A to B, one column for each meridian: vertices of the mesh.
    struct gusset_indices matrix;
    /// Of each new vertex (they are the last ones of the mesh), the two that it lies between, on A and on B, by turns:
    /// the ends of its meridian.
    struct gusset_indices parents;
    /// Of each new vertex, the weight of its second parent, 0 to 1: in row k of r rows k / (r + 1).
    const double *weights;
    /// Interior rows; the matrix has two rows more. 0 where there is one meridian alone, and no face.
    uint32_t row_count;
    uint32_t reserved;
} gusset_strip_report;

/// Makes a strip of faces between two polylines that run side by side, as gusset_stitch does between two rims: the
/// third, intermediate mesh alone. The mesh has the points of A, 0 to N - 1, then those of B, then the new ones row by
/// row. Faces run A_i+1, A_i, B_j: against polyline A, and along B. Where both sides advance at once triangles split a
/// quad by its shorter diagonal.
/// @param points_a x, y, z of the points in order, packed, count_a and count_b of them: at least 1 each, closed ones at
///     least 3, and the last point is not the first again.
/// @param count_a see points_a.
/// @param points_b see points_a.
/// @param count_b see points_a.
/// @param options NULL for the defaults (open polylines).
/// @errors LOOP_TOO_SHORT, TOO_LARGE, NOT_FINITE, NO_STRIP
/// @complexity Time and memory of the meridians of gusset_stitch, and linear in the mesh.
/// @source Nesterenko, the intermediate mesh (H, P); Fuchs, Kedem and Uselton (1977) for the best strips.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_strip(const struct gusset_context *context, const double *points_a,
    size_t count_a, const double *points_b, size_t count_b, const struct gusset_strip_options *options,
    struct gusset_result **result);

/// Lends the meridians and the matrix, for results of gusset_strip.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_strip(const struct gusset_result *result,
    struct gusset_strip_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Trimming: Keeps one piece of each overlap. */

/// How pieces that overlap are trimmed; all zero is the default.
typedef struct gusset_trim_options {
    size_t struct_size;
    /// Surfaces that are no farther apart than this are one, in the unit of the positions, finite and at least 0; 0:
    /// four mean edges of the coarser of two pieces.
    double max_distance;
    /// Surfaces whose normals differ by more are two, in radians, from 0 and below pi / 2; 0: 60 degrees.
    double max_angle;
    /// x, y, z of the place that each piece was seen from, in the unit of the positions, or NULL: what was seen under a
    /// flat angle counts for less.
    const double *viewpoints;
    /// Their number: that of the pieces, or 0.
    size_t viewpoint_count;
    /// What has fewer faces is no surface; 0: 30. Parts of twenty times as many go where others show the same, and as
    /// small holes do not come about.
    uint32_t min_faces;
    uint32_t reserved;
} gusset_trim_options;

/// The faces of a piece that are kept.
typedef struct gusset_trimmed_piece {
    /// Ascending.
    struct gusset_indices kept;
    /// How many of the piece's vertices lie on another piece.
    size_t covered_vertices;
} gusset_trimmed_piece;

/// What is left of pieces. Pointers are valid until it is destroyed.
typedef struct gusset_trim_view {
    size_t struct_size;
    /// One for each piece.
    const struct gusset_trimmed_piece *pieces;
    /// How many.
    size_t piece_count;
    /// Faces that cut some of an earlier piece after all else; they went, with those round them.
    uint32_t crossings;
    uint32_t reserved;
} gusset_trim_view;

/// What is left of pieces that overlap. Opaque and immutable; it keeps nothing of them.
typedef struct gusset_trim gusset_trim;

/// Chooses what is kept of pieces that overlap: of each overlap one piece, with a narrow gap to the others, which
/// gusset_join closes; see GUSSET_OVERLAPS_TRIM there for both at once. The pieces are cut along lines on which both
/// are equally good. A vertex is the better the farther it is from the borders of its piece, in mean edges of it, so
/// that the finer of two pieces counts for more, and the less flat the angle it was seen under, if viewpoints are
/// given; loops of fewer than 32 vertices are small holes and no borders in that sense. A vertex lies on another piece
/// if the nearest place there is near, faces the same way, and is on no border. Where two are equally good but for
/// noise, the earlier one is kept. No vertex moves, and no face is cut. What would be thinner than two faces goes, so
/// do small islands, faces that hang on others by one vertex, and faces that cut those of an earlier piece.
/// @param pieces piece_count mesh views one after another, each as large as the first one's struct_size says, at least
///     one, all in one coordinate system; see gusset_alignment_create.
/// @param piece_count see pieces.
/// @errors as gusset_mesh_view (the report's input is the piece), EMPTY_MESH (without pieces), OUT_OF_RANGE
///     (max_distance, max_angle), NOT_FINITE (a viewpoint), COUNT_DIFFERS (fewer viewpoints than pieces), TOO_LARGE
/// @complexity O(V log F) for V vertices of a piece and F faces of each piece near it, and up to the square of the
///     number of faces that lie in one place; linear extra memory.
/// @source The idea is that of G. Turk and M. Levoy, Zippered polygon meshes from range images (1994), who clip one
///     mesh at the other's border.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_trim_create(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_trim_options *options,
    struct gusset_trim **trim);

/// Destroys what is left of pieces; NULL is allowed.
GUSSET_API void gusset_trim_destroy(struct gusset_trim *trim);

/// Lends which faces are kept.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_trim_get_view(const struct gusset_trim *trim,
    struct gusset_trim_view *view);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Welding: Merges coincident vertices. */

/// The vertices that are welded.
typedef uint32_t gusset_weld_vertices;
/// The ends of free edges are welded: borders that lie on one another are sewn, edge to edge.
#define GUSSET_WELD_BOUNDARY 0
/// All vertices that faces use are welded, as triangle soups need it.
#define GUSSET_WELD_ALL 1

/// Whether corners of one face may become one.
typedef uint32_t gusset_collapse;
/// Corners of one face stay apart.
#define GUSSET_COLLAPSE_NEVER 0
/// Corners of one face may become one; a face that keeps fewer than three different vertices is dropped.
#define GUSSET_COLLAPSE_ALLOW 1

/// The treatment of vertices that no face uses.
typedef uint32_t gusset_unused;
/// Vertices that no face uses stay.
#define GUSSET_UNUSED_KEEP 0
/// Vertices that no face of the result uses are left out.
#define GUSSET_UNUSED_REMOVE 1

/// How to weld; all zero is the default.
typedef struct gusset_weld_options {
    size_t struct_size;
    /// Which vertices.
    gusset_weld_vertices vertices;
    /// GUSSET_TOLERANCE_AUTO: vertices lie together if they are no farther apart than rounding can have put copies of
    /// one vertex: 2^-19 of the largest coordinate for 32-bit positions, 2^-48 for 64-bit ones, or twice the last
    /// decimal place that positions show, as those from text files do, if that is more. Let D be the largest power of
    /// ten that does not exceed the longest side of the box round the vertices in question. The last place is the
    /// largest of 1e-5 D, 1e-6 D, ... of which at least a third of the coordinates (those of the largest order of
    /// magnitude), or of their differences from one vertex to the next, are multiples. Multiples of 1e-4 D do not
    /// count, as a coarse grid is no sign of rounding; of the rest there must be eight. At each vertex it is at most a
    /// quarter of the shortest edge that ends there, so that no edge collapses. See tolerance of the result's view for
    /// what it was. GUSSET_TOLERANCE_GIVEN: if they are not farther apart than the tolerance. GUSSET_TOLERANCE_EXACT:
    /// if their positions are equal, where -0 equals 0.
    gusset_tolerance_mode tolerance_mode;
    /// In the unit of the positions, finite, at least 0; read for GUSSET_TOLERANCE_GIVEN.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    double tolerance;
    gusset_collapse collapse;
    gusset_unused unused;
} gusset_weld_options;

/// What became of the old mesh. Indices are the old mesh's; lists are ascending; pointers are valid until the result is
/// destroyed.
typedef struct gusset_weld_report {
    size_t struct_size;
    /// Per old vertex, its index in the result; UINT32_MAX if it was left out as unused.
    struct gusset_indices vertex_map;
    /// Per old face, its index in the result; UINT32_MAX if it was dropped.
    struct gusset_indices face_map;
    /// Half-edges of free edges that lie on another edge and did not become one edge of two faces with it: three or
    /// more lie together there, or sewing would have collapsed a face or made an edge of three or more faces.
    struct gusset_indices left_edges;
    /// Vertices that lie together with another and are not one with it.
    struct gusset_indices left_vertices;
    /// Vertices that became one with a smaller one.
    uint32_t welded_vertices;
    /// Edges of two faces that were two free edges.
    uint32_t sewn_edges;
    /// Faces that were dropped.
    uint32_t dropped_faces;
    uint32_t reserved;
    /// How far apart vertices that lie together were allowed to be, short edges apart; 0 for equal positions.
    double tolerance;
} gusset_weld_report;

/// Makes one vertex of vertices that lie together. By default borders are sewn: where exactly two free edges lie on one
/// another, whatever their directions, they become one edge, and so do their ends. Where three or more lie together
/// none is preferred, and a pair is left where sewing it would collapse a face or make an edge of three or more faces:
/// a manifold stays one. What is left is listed. Vertices that lie together without an edge to sew stay apart, as where
/// two holes touch. With GUSSET_WELD_ALL, vertices that lie together become one whatever comes of the edges. Which lie
/// together within a tolerance: in ascending order, each vertex that is still unclaimed claims the unclaimed ones
/// within the tolerance of it, nearest first, so that nothing chains. The result has the old faces in their order, each
/// from its own first corner. Of vertices made one the smallest is left, and its position keeps its bits; the vertices
/// left are in their old order. If every face is dropped, the result has none and is no valid input.
/// @errors as gusset_mesh_view, OUT_OF_RANGE (the tolerance)
/// @complexity O(H log H) for H half-edges, if no vertex has very many and few corners of one face lie together; linear
///     extra memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_weld(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_weld_options *options, struct gusset_result **result);

/// Lends the maps, lists and counts, for results of gusset_weld.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_weld(const struct gusset_result *result,
    struct gusset_weld_report *report);

#ifdef __cplusplus
}
#endif

#endif /* GUSSET_MESH_H */
