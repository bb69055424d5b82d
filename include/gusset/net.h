/* Generated from src/capi; see gusset.h. */

#ifndef GUSSET_NET_H
#define GUSSET_NET_H
#include "base.h"
#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/*** Nets */

/// Coordinate matrices, possibly interleaved or column-major: number (i, j) begins i * row_stride + j * column_stride
/// bytes after the first.
/// Normals point along increasing column x increasing row.
typedef struct gusset_net_view {
    size_t struct_size;
    /// At least 2.
    size_t rows;
    /// At least 2; rows * columns at most INT32_MAX.
    size_t columns;
    /// First coordinates.
    void *x;
    /// Second coordinates.
    void *y;
    /// Third coordinates.
    void *z;
    size_t row_stride;
    /// Stride of numbers in a row.
    size_t column_stride;
    gusset_scalar scalar;
    uint32_t reserved;
} gusset_net_view;

typedef uint32_t gusset_net_memory;
/// A copy.
#define GUSSET_NET_MEMORY_COPY 0
/// The caller's memory, which changes with the net.
#define GUSSET_NET_MEMORY_BORROW 1

struct gusset_net;

struct gusset_net_gluing;

/// Makes a net from coordinates.
/// Borrowed matrices are aligned, apart from each other, and without gaps in rows; row_stride is a multiple of the
/// scalar's size. They stay valid until the net is destroyed.
/// @param gluing NULL: nothing is glued.
/// @errors NET_TOO_SMALL, BAD_STRIDE, OVERLAP, OUT_OF_RANGE (a byte of the matrix), BAD_SEAM, CROSSING_CELL
/// @complexity O(nodes + pairs of seams); 12 or 24 bytes a node, and 1/4 byte unless sides give the gluing. Borrowed
///     without matrix and seams: O(1).
/// @source Deryagin, "Model of the tetragonal regular network".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_create(const struct gusset_context *context,
    const struct gusset_net_view *view, const struct gusset_net_gluing *gluing, gusset_net_memory memory,
    struct gusset_net **net);

GUSSET_API void gusset_net_destroy(struct gusset_net *net);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_get_view(const struct gusset_net *net,
    struct gusset_net_view *view);

/// Lends the coordinates for writing, until the next call with this net.
/// The caller keeps glued nodes equal (see snap of gusset_glue_options). Shared memory is copied first.
/// @complexity O(1), with a copy O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_edit(const struct gusset_context *context, struct gusset_net *net,
    struct gusset_net_view *view);

/// Copies the coordinates to the caller's matrices.
/// @param view matrices of the net's size, of any layout and scalar type (float rounds). Gaps stay.
/// @errors SIDES_DIFFER (another size), BAD_STRIDE
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_read(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_net_view *view);

/*** The handle of a net */

/// A matrix of nodes with coordinates, and its gluing.
/// - Node (i, j) has index i * columns + j; cell (i, j) has i * (columns - 1) + j.
/// - Link 2 * node leads to the row's next node, 2 * node + 1 to the column's; the last links to the first.
/// - A node with a NaN or infinite coordinate is missing. A cell with a missing corner or of a hidden bridge is absent.
typedef struct gusset_net gusset_net;

/*** Gluing of sides */

/// Glues node k of run A, (row_a + k * row_step_a, column_a + k * column_step_a), to node k of run B.
typedef struct gusset_seam {
    /// First row of A.
    uint32_t row_a;
    /// First column of A.
    uint32_t column_a;
    /// Rows a step.
    int32_t row_step_a;
    /// Columns a step.
    int32_t column_step_a;
    /// As for A.
    uint32_t row_b;
    /// As for A.
    uint32_t column_b;
    /// As for A.
    int32_t row_step_b;
    /// As for A.
    int32_t column_step_b;
    /// Nodes, at least 1; exactly 1 if all steps are 0.
    uint32_t count;
    uint32_t reserved;
} gusset_seam;

/// Gluing of sides.
/// @bits
typedef uint32_t gusset_sides;
/// Rows are closed: the last node is the first.
#define GUSSET_SIDES_ROWS_CLOSED 1
/// Columns are closed.
#define GUSSET_SIDES_COLUMNS_CLOSED 2
/// The first row is one point.
#define GUSSET_SIDES_POLE_TOP 4
/// The last row is one point.
#define GUSSET_SIDES_POLE_BOTTOM 8
/// The first column is one point.
#define GUSSET_SIDES_POLE_LEFT 16
/// The last column is one point.
#define GUSSET_SIDES_POLE_RIGHT 32
/// All sides are open.
#define GUSSET_SIDES_SHEET 0
/// Rows are closed.
#define GUSSET_SIDES_TUBE 1
/// Closed rows, the first and last poles.
#define GUSSET_SIDES_TWO_POLES 13
/// All four sides are one point.
#define GUSSET_SIDES_ONE_POLE 60
/// Rows and columns are closed.
#define GUSSET_SIDES_TORUS 3

/// Gluing. Default: none.
typedef struct gusset_net_gluing {
    size_t struct_size;
    /// Characteristic matrix: 2 * rows rows of columns bytes, 1 for a contracted link, else 0. Row 2i has row i's
    /// horizontal links, row 2i + 1 the vertical ones. NULL: sides.
    const uint8_t *matrix;
    /// Additional seams.
    const struct gusset_seam *seams;
    size_t seam_count;
    /// 0 with a matrix.
    gusset_sides sides;
    /// 1: opposite orientation of faces.
    uint32_t reversed;
} gusset_net_gluing;

/// Replaces the gluing; positions stay.
/// @param gluing NULL: nothing is glued.
/// @errors as gusset_net_create
/// @complexity O(nodes + pairs of seams).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_set_gluing(const struct gusset_context *context,
    struct gusset_net *net, const struct gusset_net_gluing *gluing);

/// Gluing in normal form: sides replace links, and links seams, where possible.
typedef struct gusset_net_gluing_report {
    size_t struct_size;
    /// Bytes of the matrix: 2 * rows * columns.
    size_t matrix_size;
    size_t seam_count;
    size_t bridge_count;
    /// UINT32_MAX unless sides describe all links.
    gusset_sides sides;
    /// 1: opposite orientation of faces.
    uint32_t reversed;
} gusset_net_gluing_report;

/// Writes the gluing of a net.
/// @param matrix characteristic matrix.
/// @param matrix_capacity at least matrix_size.
/// @param seam_capacity at least seam_count.
/// @complexity O(seams) for seams, O(nodes) for the matrix.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_get_gluing(const struct gusset_net *net, uint8_t *matrix,
    size_t matrix_capacity, struct gusset_seam *seams, size_t seam_capacity, struct gusset_net_gluing_report *report);

/*** Gluing of nodes */

/// Kind of a gluing. See gusset_net for indices.
typedef uint32_t gusset_gluing_kind;
/// The ends of link element.
#define GUSSET_GLUING_LINK 0
/// Node element and its neighbours in the mask: east 1, south 2, west 4, north 8. Links at sides lead to the opposite
/// ones.
#define GUSSET_GLUING_STAR 1
/// The ends of each link of cell element in the mask: top 1, right 2, bottom 4, left 8.
#define GUSSET_GLUING_CELL 2
/// Opposite corners of cell element: mask 1 for the first and third, 2 for the second and fourth.
#define GUSSET_GLUING_DIAGONAL 3
/// The runs of a seam.
#define GUSSET_GLUING_SEAM 4
/// The local gluing of type mask (GUSSET_TYPE_...) at node element, or cell element from GUSSET_TYPE_TOP_BOTTOM on.
#define GUSSET_GLUING_TYPE 5

/// Place to glue or unglue.
typedef struct gusset_gluing {
    gusset_gluing_kind kind;
    /// Link, node or cell; seams: 0.
    uint32_t element;
    /// As the kind says; links and seams: 0.
    uint32_t mask;
    uint32_t reserved;
    /// For GUSSET_GLUING_SEAM only.
    struct gusset_seam seam;
} gusset_gluing;

/// Local gluing of Deryagin's figure 4. n(...) counts contracted links of a node, c(...) of a cell.
typedef uint32_t gusset_gluing_type;
/// Nothing is glued.
#define GUSSET_TYPE_NONE 4294967295
/// n(1): one horizontal link.
#define GUSSET_TYPE_HORIZONTAL 0
/// n(1): one vertical link.
#define GUSSET_TYPE_VERTICAL 1
/// n(2,1): east and south links.
#define GUSSET_TYPE_EAST_SOUTH 2
/// n(2,1): south and west links.
#define GUSSET_TYPE_SOUTH_WEST 3
/// n(2,1): west and north links.
#define GUSSET_TYPE_WEST_NORTH 4
/// n(2,1): north and east links.
#define GUSSET_TYPE_NORTH_EAST 5
/// n(2,2): east and west links.
#define GUSSET_TYPE_EAST_WEST 6
/// n(2,2): north and south links.
#define GUSSET_TYPE_NORTH_SOUTH 7
/// n(3): east, south and west links.
#define GUSSET_TYPE_BUT_NORTH 8
/// n(3): south, west and north links.
#define GUSSET_TYPE_BUT_EAST 9
/// n(3): west, north and east links.
#define GUSSET_TYPE_BUT_SOUTH 10
/// n(3): north, east and south links.
#define GUSSET_TYPE_BUT_WEST 11
/// n(4): all four links.
#define GUSSET_TYPE_ALL 12
/// c(2,1): top and bottom.
#define GUSSET_TYPE_TOP_BOTTOM 13
/// c(2,1): right and left.
#define GUSSET_TYPE_RIGHT_LEFT 14
/// c(3): three links, and so the fourth: all corners are one point.
#define GUSSET_TYPE_POINT 15
/// c(1,2): first and third corner.
#define GUSSET_TYPE_FALLING 16
/// c(1,2): second and fourth corner.
#define GUSSET_TYPE_RISING 17

/// Options of gusset_net_glue. Steps: detect, gluings, links, saturate, snap.
typedef struct gusset_glue_options {
    size_t struct_size;
    /// For detect: largest distance of coincident nodes.
    double tolerance;
    /// Gluings to add.
    const struct gusset_gluing *gluings;
    size_t gluing_count;
    /// Links to contract, as in gusset_net_analysis_view.
    const uint32_t *links;
    size_t link_count;
    /// 1: replaces the gluing by the one that coordinates imply: coincident neighbours, and coincident runs of two or
    /// more side nodes in either direction. The orientation stays.
    uint32_t detect;
    /// 1: contracts links with ends in one point, and drops redundant seams; detect implies it. Nets that glue equal
    /// neighbours then have equal matrices.
    uint32_t saturate;
    /// 1: moves a point's nodes to its first, bit for bit.
    uint32_t snap;
    uint32_t reserved;
} gusset_glue_options;

/// Glues nodes.
/// @param moved number of moved nodes, or NULL.
/// @errors OUT_OF_RANGE (tolerance, mask above 15), NO_SUCH_ELEMENT (link, node, cell), BAD_SEAM (gluing),
///     CROSSING_CELL
/// @complexity O(nodes + glued pairs); detect sorts side nodes. snap alone: O(rows + columns) if only sides are glued.
/// @source Deryagin, "Local gluings of nodes".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_glue(const struct gusset_context *context, struct gusset_net *net,
    const struct gusset_glue_options *options, uint64_t *moved);

/// Unglues nodes: frees their links and cuts their seams.
/// Nodes that other gluings connect stay one point. Pairs not glued are ignored.
/// @param separation gap between the pieces of a point, at least 0. Each moves by half of it towards the mean of its
///     neighbours, preferably unsplit ones. Without neighbours, or at their mean, it stays.
/// @param moved count of moved pieces, or NULL.
/// @errors as gusset_net_glue, OUT_OF_RANGE (separation)
/// @complexity O(nodes), plus a sort of pairs.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_unglue(const struct gusset_context *context, struct gusset_net *net,
    const struct gusset_gluing *gluings, size_t count, double separation, uint64_t *moved);

/*** Local gluings */

/// Writes for each node the first node of its point.
/// @param classes rows * columns nodes.
/// @complexity O(nodes); 4 bytes a node.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_classes(const struct gusset_context *context,
    const struct gusset_net *net, uint32_t *classes, size_t capacity, size_t *written);

/// Points of several glued nodes.
typedef struct gusset_net_groups gusset_net_groups;

/// Finds the points of several glued nodes.
/// @complexity O(rows + columns) if only sides are glued, else O(nodes), plus a sort of glued nodes.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_groups_create(const struct gusset_context *context,
    const struct gusset_net *net, struct gusset_net_groups **groups);

/// Groups of glued nodes, in the order of their first nodes.
typedef struct gusset_net_groups_view {
    size_t struct_size;
    /// Offsets into members, by group.
    struct gusset_indices offsets;
    /// Nodes of all groups, in order within each.
    struct gusset_indices members;
} gusset_net_groups_view;

GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_groups_get_view(const struct gusset_net_groups *groups,
    struct gusset_net_groups_view *view);

GUSSET_API void gusset_net_groups_destroy(struct gusset_net_groups *groups);

/// Element that has a local gluing.
typedef uint32_t gusset_gluing_place;
/// Node with glued links.
#define GUSSET_GLUING_PLACE_NODE 0
/// Cell with glued corners.
#define GUSSET_GLUING_PLACE_CELL 1

/// Finds the local gluing at a node or cell.
/// @param element node or cell.
/// @param cyclic 1: links back to the first row or column count.
/// @param found type; GUSSET_TYPE_NONE for a node without glued links, or a quad.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1) if only sides are glued, else O(nodes).
/// @source Deryagin, Fig. 4.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_classify(const struct gusset_context *context,
    const struct gusset_net *net, gusset_gluing_place place, uint32_t element, uint32_t cyclic,
    gusset_gluing_type *found);

/// Counts the local gluings by type.
/// @param nodes 18 counts, as for cyclic 0, or NULL.
/// @param cells 18 counts, or NULL.
/// @complexity O(nodes); 4 bytes a node.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_histogram(const struct gusset_context *context,
    const struct gusset_net *net, uint64_t *nodes, uint64_t *cells);

/// Local gluing: n(a,b) at a node or c(a,b) at a cell.
typedef struct gusset_gluing_occurrence {
    gusset_gluing_place place;
    /// Node or cell.
    uint32_t element;
    /// Local gluing of Deryagin's figure 4.
    gusset_gluing_type kind;
    /// Node: nodes glued to it. Cell: glued links, at most 3; 1 for a diagonal.
    uint32_t a;
    /// Node with two glued links: 1 if adjacent, 2 if opposite. Cell with two: other links between them, 0 or 1.
    /// Diagonal: 2. Else UINT32_MAX.
    uint32_t b;
    /// United nodes.
    uint32_t node_order;
    /// United links; 1 if none.
    uint32_t link_order;
    /// Nodes of the point, above node_order where gluings meet.
    uint32_t class_size;
} gusset_gluing_occurrence;

/// Writes all local gluings: of nodes, then of cells.
/// @param cyclic as for gusset_net_classify.
/// @complexity O(nodes); 4 bytes a node, and the result.
/// @source Deryagin, Fig. 4.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_gluing_occurrences(const struct gusset_context *context,
    const struct gusset_net *net, uint32_t cyclic, struct gusset_gluing_occurrence *found, size_t capacity,
    size_t *written);

/*** Shapes */

/// Standard shape, its measures, the least rows x columns.
typedef uint32_t gusset_net_shape;
/// Rectangle at z = 0: size[0], size[1].
#define GUSSET_NET_PLANE 0
/// Sphere with two poles: radius. From 3 x 4 nodes.
#define GUSSET_NET_SPHERE 1
/// Sphere from a disc, its rim one point: radius. From 3 x 3 nodes.
#define GUSSET_NET_ONE_POLE_SPHERE 2
/// Open cylinder: radius, height. At least 4 columns.
#define GUSSET_NET_TUBE 3
/// Closed cylinder: radius, height. From 4 x 4 nodes.
#define GUSSET_NET_CYLINDER 4
/// Regular prism: sides, radius (circumscribed), height. From 4 x (sides + 1) nodes.
#define GUSSET_NET_PRISM 5
/// Cone with base: radius, height. From 3 x 4 nodes.
#define GUSSET_NET_CONE 6
/// Regular pyramid: sides, radius (circumscribed), height. From 3 x (sides + 1) nodes.
#define GUSSET_NET_PYRAMID 7
/// Profile revolved about z: profile, profile_count. At least 4 columns; each point makes a row.
#define GUSSET_NET_LATHE 8
/// Torus: radius, minor_radius (of the tube, smaller). From 4 x 4 nodes.
#define GUSSET_NET_TORUS 9
/// Box: size, cells (which give rows and columns), box_kind.
#define GUSSET_NET_BOX 10
/// Moebius strip: radius (of the middle line), size[0] (width). At least 4 columns.
#define GUSSET_NET_MOEBIUS 11
/// Klein bottle with figure-eight section: radius, minor_radius. From 4 x 4 nodes.
#define GUSSET_NET_KLEIN 12
/// Projective plane as Boy's surface: radius (scale). From 4 x 4 nodes.
#define GUSSET_NET_PROJECTIVE_PLANE 13
/// Two sheets joined along their rim: size[0], size[1], height (thickness). At least 3 rows; 5, 7, ... columns.
#define GUSSET_NET_PILLOW 14

/// Layout of the caps of a box.
typedef uint32_t gusset_box_kind;
/// Caps close along slits. Unit quads; no seams.
#define GUSSET_NET_BOX_SLIT 0
/// Crosswise unwrapping. Unit quads; two seams.
#define GUSSET_NET_BOX_CROSS 1
/// Concentric rings: fewest nodes; triangles along the diagonals.
#define GUSSET_NET_BOX_CONCENTRIC 2

/// Standard shape and its measures.
typedef struct gusset_net_primitive {
    size_t struct_size;
    gusset_net_shape shape;
    gusset_scalar scalar;
    /// 0: 33. Not for boxes and lathes.
    size_t rows;
    /// 0: 65. Not for boxes.
    size_t columns;
    /// Above 0.
    double radius;
    /// Above 0.
    double minor_radius;
    /// Height along z, above 0.
    double height;
    /// Sizes along x, y and z, above 0.
    double size[3];
    /// Distance from the axis (at least 0) and height of each point, upwards. Points on the axis are poles; closed
    /// profiles make rings.
    const double *profile;
    /// At least 2.
    size_t profile_count;
    /// Lateral faces of prisms and pyramids, at least 3.
    uint32_t sides;
    gusset_box_kind box_kind;
    /// Cells of boxes along x, y and z, at least 1.
    uint32_t cells[3];
    uint32_t reserved;
} gusset_net_primitive;

/// Makes a standard shape at the origin, with axis z.
/// Glued nodes have equal bits. Closed surfaces have outward normals.
/// @errors OUT_OF_RANGE (measure, too few elements)
/// @complexity O(nodes); 12 or 24 bytes a node, and 1/4 byte for boxes.
/// @source Deryagin, "Closures of nets".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_primitive_create(const struct gusset_context *context,
    const struct gusset_net_primitive *primitive, struct gusset_net **net);

/*** Affine maps */

typedef uint32_t gusset_axis;
/// x.
#define GUSSET_AXIS_X 0
/// y.
#define GUSSET_AXIS_Y 1
/// z.
#define GUSSET_AXIS_Z 2

/// Kind of an affine map. It tells the values.
typedef uint32_t gusset_operation_kind;
/// Translation by values[0..2].
#define GUSSET_OPERATION_TRANSLATE 1
/// Right-handed rotation by values[3] about the axis through values[4..6] along values[0..2], not 0.
#define GUSSET_OPERATION_ROTATE 2
/// Left-handed rotation, as Deryagin's formula is printed.
#define GUSSET_OPERATION_ROTATE_AS_PRINTED 3
/// Scaling about the origin by the factor values[0].
#define GUSSET_OPERATION_SCALE 4
/// Scaling of distances from axis by the factor values[0].
#define GUSSET_OPERATION_COMPRESS 5
/// Scaling of x, y and z by values[0], values[1] and values[2].
#define GUSSET_OPERATION_STRETCH 6
/// Affine map: three rows of four numbers, the last the displacement.
#define GUSSET_OPERATION_MATRIX 7

/// Affine map.
typedef struct gusset_operation {
    gusset_operation_kind kind;
    /// For GUSSET_OPERATION_COMPRESS; else 0.
    gusset_axis axis;
    /// As the kind says; the rest is not read.
    double values[12];
} gusset_operation;

/// Moves a net by affine maps, composed in the given order.
/// - It computes in the net's scalar type.
/// - Equal bits of glued nodes stay equal, and missing nodes missing; other coordinates of theirs may change.
/// - Mirroring changes the reversed flag, so that faces still look outwards.
/// @param count may be 0.
/// @errors OUT_OF_RANGE (not finite, axis of length 0, overflow of the product), FIELD_UNDEFINED (first node to
///     overflow)
/// @complexity O(nodes); no memory.
/// @source Deryagin, T, R, S, C.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_transform(const struct gusset_context *context,
    struct gusset_net *net, const struct gusset_operation *operations, size_t count);

/*** Fields */

/// Kind of a deformation field. It tells the values.
/// - t is the strength: from 0, no change, to 1, the whole map.
/// - w is the coordinate on axis; u and v follow in the cycle x, y, z.
/// - Linear in t: points move by t times their displacement.
typedef uint32_t gusset_field_kind;
/// Affine map, linear in t: three rows of four numbers. The net's reversed flag stays.
#define GUSSET_FIELD_AFFINE 1
/// Right-handed rotation about axis by the angle t values[0] (w - values[1]).
#define GUSSET_FIELD_TWIST 2
/// Scaling of u and v by 1 + t values[0] (w - values[1]).
#define GUSSET_FIELD_TAPER 3
/// Bends axis from w = values[1] to values[2] (maybe infinite) into an arc of curvature t values[0] towards u. Straight
/// beyond.
#define GUSSET_FIELD_BEND 4
/// Adds t values[0] times the coordinate on other_axis to w.
#define GUSSET_FIELD_SHEAR 5
/// Central projection onto the sphere of centre values[0..2], radius values[3] > 0; linear in t. Undefined at the
/// centre.
#define GUSSET_FIELD_SPHERIFY 6
/// Rolls space around a cylinder of radius r = values[0] > 0: u and v become (r + v) sin(u/r) and (r + v) cos(u/r). For
/// t < 1, the curvature is t/r. Lengths in the sheet v = 0 stay.
#define GUSSET_FIELD_CYLINDER_WRAP 7
/// Rolls space into a torus about axis: radius R = values[0] > 0, tube radius r = values[1] > 0. Then u, v, w are the
/// arcs around axis and tube, and the height above the torus.
/// - t <= 1/2: a sheet rolls into a straight tube of curvature 2t/r; lengths stay.
/// - t > 1/2: the tube bends to curvature (2t - 1) / R; its circles keep their lengths.
#define GUSSET_FIELD_TORUS_WRAP 8
/// Free-form deformation of the box from values[0..2] to values[3..5] by tensor-product Bernstein polynomials, linear
/// in t. Points outside stay. Offsets displace a uniform grid of 2 to 32 control points along each axis, x fastest,
/// then y.
#define GUSSET_FIELD_LATTICE 9
/// Projective map by a 4 x 4 matrix, row by row; linear in t. Undefined where the fourth homogeneous coordinate is 0.
#define GUSSET_FIELD_PROJECTION 10
/// Parallel projection onto the plane through values[0..2] with normal values[3..5], along values[6..8]; linear in t.
#define GUSSET_FIELD_PARALLEL 11
/// Central projection from the eye values[0..2] onto the plane through values[3..5] with normal values[6..8]; linear in
/// t. Undefined in the parallel plane through the eye.
#define GUSSET_FIELD_PERSPECTIVE 12
/// Rolls space into a cone about axis, whose circle w = 0 has radius r = values[0] > 0. Then u, v, w are the arc of
/// this circle, the height above the cone, and the length along generators. These lean towards axis by a = values[1],
/// -pi/2 to pi/2; the apex is at w = r / sin(a).
/// For t < 1, generators lean by t a; the curvature is t/r. Generators keep their lengths; the circle at w becomes 1 -
/// (t/r) w sin(t a) times as long.
#define GUSSET_FIELD_CONE_WRAP 13
/// Rolls space into a sphere about axis, of radius r = values[0] > 0. Then u, v, w are the arcs of equator and
/// meridian, and the height above the sphere, which 0 <= u <= 2 pi r and |v| <= pi r / 2 cover.
/// - t <= 1/2: a sheet rolls into a tube of curvature 2t/r; lengths stay.
/// - t > 1/2: meridians bend to curvature q/r, q = 2t - 1, and keep their lengths. The parallel at v becomes 1 - (1 -
///   cos(q v/r)) / q times as long.
#define GUSSET_FIELD_SPHERE_WRAP 14

/// Interpolation of strengths between two keys.
typedef uint32_t gusset_easing;
/// Linear in time.
#define GUSSET_EASING_LINEAR 0
/// Smoothstep, at rest at both keys.
#define GUSSET_EASING_SMOOTH 1
/// Constant until the next key.
#define GUSSET_EASING_HOLD 2

/// Deformation field.
typedef struct gusset_field {
    size_t struct_size;
    gusset_field_kind kind;
    /// For kinds that name it; else 0.
    gusset_axis axis;
    /// GUSSET_FIELD_SHEAR: another axis. Else 0.
    gusset_axis other_axis;
    gusset_easing easing;
    /// Strength t, times the keys'.
    double strength;
    /// As the kind says; the rest is not read.
    double values[16];
    /// Pairs of time and strength, by increasing time; constant before the first and after the last. NULL: constant.
    const double *keys;
    size_t key_count;
    /// GUSSET_FIELD_LATTICE: three numbers a control point. Else NULL.
    const double *offsets;
    /// GUSSET_FIELD_LATTICE: control points along x, y and z. Else 0.
    uint32_t counts[3];
    uint32_t reserved;
} gusset_field;

/// Moves a net by fields, in the given order.
/// - For other maps, use gusset_net_edit, then snap of gusset_glue_options.
/// - Computation is in doubles, rounded once.
/// - Strength 0 changes no bit.
/// - Equal bits of glued nodes stay equal, and missing nodes missing.
/// - A node that overflows becomes missing if all fields are defined everywhere.
/// @param time time of keys. To animate, deform copies of the net at rest.
/// @errors OUT_OF_RANGE (value, strength, time), FIELD_UNDEFINED (node where a partly undefined chain is undefined or
///     overflows)
/// @complexity O(nodes x fields), twice if a field is partly undefined.
/// @source Deryagin, "Spatial operations"; Barr 1984; Sederberg, Parry 1986.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_deform(const struct gusset_context *context, struct gusset_net *net,
    const struct gusset_field *fields, size_t count, double time);

/// Moves nodes along their normals. Glued nodes stay together; nodes without a normal stay.
/// @param distance of either sign.
/// @errors OUT_OF_RANGE (distance), FIELD_UNDEFINED (first node to overflow)
/// @complexity O(nodes); memory as the coordinates.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_displace(const struct gusset_context *context,
    struct gusset_net *net, double distance);

/*** Measures of nets */

/// Measures to compute.
/// @bits
typedef uint32_t gusset_net_measures;
/// area, volume, area_vector, low, high.
#define GUSSET_NET_MEASURES_EXTENT 1
/// bilinear_area, bilinear_error; about ten times the cost.
#define GUSSET_NET_MEASURES_BILINEAR 2
/// body_volume, centroid, inertia; about ten times the cost.
#define GUSSET_NET_MEASURES_BODY 4

/// Measures of a net; 0 unless requested.
typedef struct gusset_net_measure_report {
    size_t struct_size;
    /// Sum of |(c - a) x (d - b)| / 2 for cells a, b, c, d; exact if planar.
    double area;
    /// Enclosed volume of a closed two-sided net, positive if normals point outwards; else of the cone to the first
    /// node.
    double volume;
    /// Sum of the cells' area vectors; 0 for closed nets.
    double area_vector[3];
    /// Smallest coordinates; infinite if all nodes are missing.
    double low[3];
    /// Largest coordinates, likewise.
    double high[3];
    /// Area of the cells' bilinear patches, up to rounding; above area unless cells are planar. All layers of folds
    /// count.
    double bilinear_area;
    /// Bound of bilinear_area's error.
    double bilinear_error;
    /// Volume of the body in a closed net, negative if normals point inwards.
    double body_volume;
    /// Centroid of the body; NaN if its volume is 0.
    double centroid[3];
    /// Inertia tensor about the centroid, density 1. Diagonal: integrals of y^2 + z^2 etc.; else of -x y etc.
    double inertia[9];
} gusset_net_measure_report;

/// Planarity of cells.
typedef struct gusset_net_planarity_report {
    size_t struct_size;
    /// Largest deviation of a cell; 0 without cells.
    double worst;
    /// Its cell; UINT64_MAX without cells.
    uint64_t worst_cell;
    /// Mean deviation; NaN without cells.
    double mean;
    /// Cells above the tolerance.
    uint64_t above;
} gusset_net_planarity_report;

/// Measures a net.
/// Absent cells do not count. Volumes, centroid and inertia are exact for bilinear cells, up to rounding. If powers of
/// coordinates overflow (about 1e77), results are infinite or NaN.
/// @complexity O(nodes); no memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_measure(const struct gusset_context *context,
    const struct gusset_net *net, gusset_net_measures measures, struct gusset_net_measure_report *report);

/// Measures the planarity of cells.
/// A cell's deviation is its corners' distance from their mean plane divided by the longer diagonal; 0 for triangles
/// and less, NaN if absent.
/// @param tolerance for above.
/// @param cells each cell's deviation.
/// @errors OUT_OF_RANGE (tolerance)
/// @complexity O(nodes); 8 bytes a cell.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_planarity(const struct gusset_context *context,
    const struct gusset_net *net, double tolerance, double *cells, size_t capacity, size_t *written,
    struct gusset_net_planarity_report *report);

/*** Meshes and heights */

typedef uint32_t gusset_net_faces;
/// Quads, and triangles where a side of a cell is a point.
#define GUSSET_NET_QUADS 0
/// Triangles, cut by the shorter diagonal, or the other if that edge exists.
#define GUSSET_NET_TRIANGLES_SHORTER 1
/// Triangles, cut from (i, j) to (i + 1, j + 1), with the same exception.
#define GUSSET_NET_TRIANGLES_FIXED 2

typedef struct gusset_net_mesh_options {
    size_t struct_size;
    gusset_net_faces faces;
    /// 1: a vertex for each node; 0: glued nodes are one.
    uint32_t no_weld;
    /// 1: keeps finite vertices without faces and wires.
    uint32_t keep_unused;
    /// 1: a cell with exactly one missing corner becomes a triangle.
    uint32_t fill_corners;
    /// 1: computes texture coordinates.
    uint32_t texture;
    uint32_t reserved;
    /// Omits faces with edges above this multiple of the median edge; 0: no limit. 4 removes depth jumps from range
    /// images.
    double max_edge_ratio;
} gusset_net_mesh_options;

/// Maps between a net and its mesh.
typedef struct gusset_net_mesh_report {
    size_t struct_size;
    /// Vertex of each node, or UINT32_MAX.
    struct gusset_indices vertex_of_node;
    /// First node of each vertex.
    struct gusset_indices node_of_vertex;
    /// Cell of each face.
    struct gusset_indices cell_of_face;
    /// Edges without faces, two vertices each: cells with opposite sides glued.
    struct gusset_indices wires;
    /// For each corner, its pair in texture_coordinates; empty unless requested.
    struct gusset_indices texture_corners;
    /// Pairs (column, row), 0 to 1. A vertex on a seam has a pair on each side.
    const double *texture_coordinates;
    size_t texture_count;
} gusset_net_mesh_report;

/// Heights over a regular grid.
typedef struct gusset_heights {
    size_t struct_size;
    /// At least 2.
    size_t rows;
    /// At least 2.
    size_t columns;
    /// Heights, contiguous in rows. NaN and infinity mark missing nodes.
    const void *values;
    size_t row_stride;
    /// x from column to column, y from row to row; not 0.
    double spacing[2];
    /// Position of node (0, 0) at height 0.
    double origin[3];
    /// Height of missing nodes, if has_no_data.
    double no_data;
    /// 0 or 1.
    uint32_t has_no_data;
    /// Type of heights and net.
    gusset_scalar scalar;
} gusset_heights;

/// Faces of a cell of the given grid.
typedef uint32_t gusset_grid_cells;
/// One quad for each cell; a triangle beside a pole.
#define GUSSET_GRID_QUADS 0
/// Two triangles for each cell.
#define GUSSET_GRID_TRIANGLES 1

typedef struct gusset_net_grid_options {
    size_t struct_size;
    gusset_grid_cells cells;
    /// 1: only the component of face must be a grid; 0: all.
    /// @when cells GUSSET_GRID_QUADS
    uint32_t has_face;
    /// Face of the component.
    /// @when has_face 1
    uint32_t face;
    uint32_t reserved;
} gusset_net_grid_options;

/// Correspondence between a net and its mesh.
typedef struct gusset_net_grid_view {
    size_t struct_size;
    /// Vertex of each node.
    struct gusset_indices vertex_of_node;
    /// Face of each cell, the first of two for GUSSET_GRID_TRIANGLES.
    struct gusset_indices face_of_cell;
} gusset_net_grid_view;

/// Correspondence between a net and its mesh.
typedef struct gusset_net_grid gusset_net_grid;

/// Makes the mesh of a net.
/// Glued nodes become one vertex, closed nets closed meshes. Absent cells are omitted; the mesh may lack faces. Faces
/// have the net's orientation.
/// @errors OUT_OF_RANGE (max_edge_ratio), TOO_LARGE (UINT32_MAX corners or more)
/// @complexity O(nodes), and O(w log w) for w cells with opposite sides glued.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_to_mesh(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_net_mesh_options *options, struct gusset_result **result);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_net_mesh(const struct gusset_result *result,
    struct gusset_net_mesh_report *report);

/// Makes a net from heights: node (i, j) is at origin + (j spacing[0], i spacing[1], height).
/// Faces are counter-clockwise from above, for any sign of spacing.
/// @errors NET_TOO_SMALL, BAD_STRIDE, OUT_OF_RANGE (spacing, origin)
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_from_heights_create(const struct gusset_context *context,
    const struct gusset_heights *heights, struct gusset_net **net);

/// Finds rows and columns in a mesh, and makes their net, bit for bit.
/// The quads form a rectangle of at least one row, possibly closed in either direction. Fans of triangles around poles
/// may adjoin its first and last row. Rows follow the only closed direction, else the first edge of the first quad.
/// GUSSET_GRID_TRIANGLES: either diagonal cuts each quad.
/// - Among several grids, the choice is deterministic; a torus may close with a shift, unlike the original.
/// - It may refuse tubes and tori with irregular diagonals, and poles of open sheets with under six triangles.
/// @param grid correspondence, or NULL.
/// @errors NO_GRID (face that violates the grid)
/// @complexity O(H log d). Closed triangle meshes without distinct poles take several attempts.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_from_mesh_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_net_grid_options *options, struct gusset_net_grid **grid,
    struct gusset_net **net);

GUSSET_API void gusset_net_grid_destroy(struct gusset_net_grid *grid);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_grid_get_view(const struct gusset_net_grid *grid,
    struct gusset_net_grid_view *view);

/*** Rows and columns */

typedef uint32_t gusset_direction;
/// Along rows, from column to column.
#define GUSSET_DIRECTION_RIGHT 0
/// Along columns, from row to row.
#define GUSSET_DIRECTION_DOWN 1

/// Chooses the rows or columns to replicate.
typedef uint32_t gusset_replication;
/// All, as equally as possible.
#define GUSSET_REPLICATE_UNIFORM 0
/// The first.
#define GUSSET_REPLICATE_FIRST 1
/// The last.
#define GUSSET_REPLICATE_LAST 2
/// The one at the given index.
#define GUSSET_REPLICATE_AT 3
/// The poles among first and last, equally; else as UNIFORM.
#define GUSSET_REPLICATE_AT_POLES 4
/// Different sizes are an error; in gusset_concatenate_options only.
#define GUSSET_REPLICATE_REFUSE 5

/// Symmetry of the rectangle of nodes. Positions and normals of nodes stay.
typedef uint32_t gusset_net_turn;
/// No change.
#define GUSSET_NET_TURN_NONE 0
/// Quarter turn: the last column becomes the first row.
#define GUSSET_NET_TURN_QUARTER 1
/// Half turn: reverses rows and columns.
#define GUSSET_NET_TURN_HALF 2
/// Three quarters of a turn: the first column becomes the last row.
#define GUSSET_NET_TURN_THREE_QUARTERS 3
/// Reverses the order of columns.
#define GUSSET_NET_TURN_FLIP_COLUMNS 4
/// Reverses the order of rows.
#define GUSSET_NET_TURN_FLIP_ROWS 5
/// Exchanges rows and columns.
#define GUSSET_NET_TURN_TRANSPOSE 6
/// Exchanges rows and columns, and reverses both.
#define GUSSET_NET_TURN_ANTITRANSPOSE 7

/// Options of gusset_net_copy_create. Steps: part, compact, enlarge, turn, convert. Default: none.
typedef struct gusset_net_copy_options {
    size_t struct_size;
    /// First row of the part.
    size_t row_first;
    /// Rows of the part, at least 2; 0: the rest.
    size_t row_count;
    /// First column of the part.
    size_t column_first;
    /// Columns of the part, at least 2; 0: the rest.
    size_t column_count;
    /// Rows after replication, at least the present; 0: none. Links between copies are contracted.
    size_t rows;
    /// Columns after replication, likewise.
    size_t columns;
    /// 1: removes rows and columns that repeat the previous: equal coordinates and links, contracted links between. Two
    /// of each and ends of bridges stay.
    uint32_t compact;
    /// For rows.
    gusset_replication row_replication;
    /// For columns.
    gusset_replication column_replication;
    /// Row to replicate.
    /// @when row_replication GUSSET_REPLICATE_AT
    uint32_t row_index;
    /// Column to replicate.
    /// @when column_replication GUSSET_REPLICATE_AT
    uint32_t column_index;
    /// Symmetry.
    gusset_net_turn turn;
    /// 0: unchanged. Conversion to float rounds; overflowing nodes become missing.
    gusset_scalar scalar;
    uint32_t reserved;
} gusset_net_copy_options;

/// Copies a net or a part with gluing and bridges: compacted, enlarged, turned, converted.
/// - Unchanged copies share memory until a net changes.
/// - A part keeps links, runs of seams and bridges inside it; with all rows or columns, also links back to the first.
/// - Without conversion, coordinates keep their bits.
/// @errors NET_TOO_SMALL, OUT_OF_RANGE (a part or index beyond the net, fewer rows or columns than present),
///     CROSSING_CELL (without the gluing outside the part)
/// @complexity O(nodes) a step; O(1) unchanged, except in the caller's memory.
/// @source Deryagin, "Reformatting".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_copy_create(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_net_copy_options *options, struct gusset_net **copy);

/// Makes nodes with a coordinate equal to value missing.
/// @param value marks missing data.
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_clear_no_data(const struct gusset_context *context,
    struct gusset_net *net, double value);

/*** Resolutions */

typedef uint32_t gusset_interpolation;
/// Catmull-Rom splines: continuous tangents, also across seams.
#define GUSSET_INTERPOLATION_BICUBIC 0
/// Bilinear patches of the cells.
#define GUSSET_INTERPOLATION_BILINEAR 1

/// Most levels of a pyramid.
#define GUSSET_PYRAMID_LEVELS 32

/// Makes a net of rows x columns nodes, spread evenly over net.
/// First and last rows and columns and the gluing stay. A new node on an old one has its bits; glued nodes have equal
/// bits.
/// @param rows at least 2.
/// @param columns at least 2.
/// @errors NET_TOO_SMALL, GLUED_INSIDE
/// @complexity O(nodes of both nets).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_resample_create(const struct gusset_context *context,
    const struct gusset_net *net, size_t rows, size_t columns, gusset_interpolation interpolation,
    struct gusset_net **resampled);

/// Removes rows, then columns, within a tolerance, each time with the least deviation.
/// @param tolerance may be INFINITY. Nodes are within half of it of the segments that replace their columns; likewise
///     rows.
/// @param rows kept rows, with room for all; may be NULL.
/// @param columns likewise.
/// @param deviation largest deviation, or NULL.
/// @errors OUT_OF_RANGE, GLUED_INSIDE
/// @complexity About O(nodes x log rows).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_decimate_create(const struct gusset_context *context,
    const struct gusset_net *net, double tolerance, uint32_t *rows, uint32_t *columns, double *deviation,
    struct gusset_net **decimated);

/// Makes levels of detail: nets of 2^k + 1 rows and columns, finest first.
/// The first is a copy if the net has such a size, else resampled to the next larger. Each other has every second row
/// and column, bit for bit.
/// @param capacity GUSSET_PYRAMID_LEVELS always suffices.
/// @param count count; capacity must exceed 0.
/// @errors GLUED_INSIDE
/// @complexity O(nodes); memory for 4/3 of the first level.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_pyramid_create(const struct gusset_context *context,
    const struct gusset_net *net, gusset_interpolation interpolation, struct gusset_net **levels, size_t capacity,
    size_t *count);

/*** Bridges */

/// Treatment of the cells of a bridge.
typedef uint32_t gusset_bridge_mode;
/// Ordinary cells.
#define GUSSET_BRIDGE_KEEP 0
/// Absent cells.
#define GUSSET_BRIDGE_HIDE 1
/// The sides, coincident within a tolerance, become one. Positions stay; see snap of gusset_glue_options.
#define GUSSET_BRIDGE_WELD 2

typedef uint32_t gusset_bridge_kind;
/// Band between open sides.
#define GUSSET_BRIDGE_RIBBON 0
/// Closed band between closed sides.
#define GUSSET_BRIDGE_TUBE 1
/// Edge between sides that are a point each.
#define GUSSET_BRIDGE_THREAD 2

/// Properties of a bridge for gusset_net_settle, in any unit of force. Lines run across it along links.
typedef struct gusset_bridge_properties {
    /// Force in each line of a thread or ribbon, or per length in a tube's film; at least 0.
    double tension;
    /// Force that doubles a line's length; at least 0.
    double elasticity;
    /// Bending stiffness of each line, force x length^2; at least 0. Infinity: rigid.
    double stiffness;
    /// For the caller's use.
    uint64_t user;
} gusset_bridge_properties;

/// Options of gusset_net_concatenate_create. Default: nets from left to right, enlarged uniformly, bridges kept.
typedef struct gusset_concatenate_options {
    size_t struct_size;
    /// For welding: largest distance of coincident nodes.
    double tolerance;
    /// Properties of every new bridge.
    struct gusset_bridge_properties properties;
    /// Direction from each net to the next.
    gusset_direction direction;
    gusset_bridge_mode mode;
    /// For nets with fewer nodes along the side.
    gusset_replication equalise;
    /// Row or column to replicate.
    /// @when equalise GUSSET_REPLICATE_AT
    uint32_t equalise_index;
    /// Rotation of each later net along its closed side, in nodes.
    uint32_t twist;
    /// 1: flips nets along the side if oriented unlike the first; 0: refuses them.
    uint32_t turn;
    /// Inner rows or columns of new bridges, even on lines; 0 for GUSSET_BRIDGE_WELD.
    uint32_t rows;
    uint32_t reserved;
} gusset_concatenate_options;

/// The cells between two joined nets.
typedef struct gusset_bridge {
    size_t struct_size;
    /// Properties given.
    struct gusset_bridge_properties properties;
    /// Direction from first to second net.
    gusset_direction direction;
    /// First column (RIGHT) or row (DOWN) of the second net.
    uint32_t at;
    /// First node along the side: row (RIGHT) or column (DOWN).
    uint32_t start;
    /// One past the last node.
    uint32_t end;
    gusset_bridge_kind kind;
    gusset_bridge_mode mode;
    /// Rows (DOWN) or columns (RIGHT) between the nets, to at - 1. The first net ends at at - rows
    /// - 1.
    uint32_t rows;
    uint32_t reserved;
} gusset_bridge;

/// Joins nets side by side into one.
/// Nets keep gluing and bridges; links that close them along the direction become seams. Bridges join consecutive nets,
/// numbered after the second net's. gusset_net_split_create is the inverse.
/// @param nets at least one, of one scalar type; may repeat.
/// @errors EMPTY_SCENE (no nets), MIXED_SCALARS, ORIENTATION_CONFLICT (see turn), SIDES_DIFFER (sizes with
///     GUSSET_REPLICATE_REFUSE; welded sides apart: place, distance), OUT_OF_RANGE (tolerance, twist of open sides,
///     rows of welded bridges), CROSSING_CELL
/// @complexity O(nodes of the result); also memory for enlarged, rotated or flipped nets.
/// @source Deryagin, "Concatenation".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_concatenate_create(const struct gusset_context *context,
    const struct gusset_net *const *nets, size_t net_count, const struct gusset_concatenate_options *options,
    struct gusset_net **joined);

/// Splits a net at a bridge from side to side, and removes it.
/// Unless changed since, both are as before joining, bit for bit, without copies that equalised sizes. Split the last
/// bridge first. Gluing across it is lost.
/// @param bridge its index.
/// @errors OVERLAP (first is second), NO_SUCH_ELEMENT (also a bridge not from side to side), CROSSING_CELL
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_split_create(const struct gusset_context *context,
    const struct gusset_net *net, size_t bridge, struct gusset_net **first, struct gusset_net **second);

/// Describes a bridge.
/// @param index below bridge_count.
/// @errors NO_SUCH_ELEMENT
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_get_bridge(const struct gusset_net *net, size_t index,
    struct gusset_bridge *bridge);

/// Changes the mode and properties of a bridge.
/// @param index as for gusset_net_get_bridge.
/// @param tolerance as in gusset_concatenate_options.
/// @param properties NULL: the old ones.
/// @errors NO_SUCH_ELEMENT, OUT_OF_RANGE (tolerance; welding with inner rows), SIDES_DIFFER (place, distance),
///     CROSSING_CELL
/// @complexity O(nodes) if welding begins or ends or memory is shared, else O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_set_bridge(const struct gusset_context *context,
    struct gusset_net *net, size_t index, gusset_bridge_mode mode, double tolerance,
    const struct gusset_bridge_properties *properties);

/*** Effects of a deformation */

/// Effects of a deformation.
typedef struct gusset_net_analysis gusset_net_analysis;

/// Effects of a deformation.
typedef struct gusset_net_analysis_view {
    size_t struct_size;
    /// New / old length of each link; NaN if the old is 0 or an end missing.
    const double *links;
    /// 2 * rows * columns.
    size_t link_count;
    /// New / old area of each cell; NaN if the old is 0 or the cell absent. Negative for folds, with fields for
    /// negative determinants.
    const double *cells;
    /// The fields' Jacobian determinant at each cell's centre; NULL if nets are compared.
    const double *determinants;
    /// (rows - 1) * (columns - 1).
    size_t cell_count;
    /// Newly contracted links, whose ends are not glued; links of gusset_glue_options glues them.
    const uint32_t *contracted;
    /// For each, the local gluing of its first node once all are contracted: 0 to 17.
    const uint32_t *stars;
    size_t contracted_count;
    /// Glued links whose ends separated.
    const uint32_t *torn;
    size_t torn_count;
    /// Cells oriented against the majority.
    const uint32_t *folded;
    size_t folded_count;
    /// 1: soft, nothing newly glued, torn or folded; 0: hard.
    uint32_t soft;
    uint32_t reserved;
} gusset_net_analysis_view;

/// Deformation; default: none.
typedef struct gusset_net_analysis_options {
    size_t struct_size;
    /// Deformed net of equal size; NULL: see fields.
    const struct gusset_net *after;
    /// As for gusset_net_deform.
    const struct gusset_field *fields;
    /// 0 beside after.
    size_t field_count;
    /// As for gusset_net_deform.
    double time;
    /// Lengths up to it count as 0.
    double tolerance;
} gusset_net_analysis_options;

/// Finds what a deformation glues, tears, folds and stretches. The net stays.
/// @errors OUT_OF_RANGE, SIDES_DIFFER (another size), CROSSING_CELL (new gluing), as gusset_net_deform
/// @complexity O(nodes); 24 bytes a node. Fields: O(nodes x fields); a copy of the net and 8 bytes a cell.
/// @source Deryagin, soft and hard deformations, by links: zeros of the Jacobian neither imply gluing nor follow from
///     it.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_analysis_create(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_net_analysis_options *options,
    struct gusset_net_analysis **analysis);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_analysis_get_view(const struct gusset_net_analysis *analysis,
    struct gusset_net_analysis_view *view);

GUSSET_API void gusset_net_analysis_destroy(struct gusset_net_analysis *analysis);

/*** The quotient surface */

typedef uint32_t gusset_net_cells;
/// All cells.
#define GUSSET_NET_CELLS_ALL 0
/// Cells that are not absent; see gusset_net.
#define GUSSET_NET_CELLS_PRESENT 1

/// Properties of the surface of a net.
/// @bits
typedef uint32_t gusset_net_flags;
/// No boundary edges.
#define GUSSET_NET_CLOSED 1
/// Manifold, with or without boundary: no wires, branches, pinches.
#define GUSSET_NET_MANIFOLD 2
/// Consistent orientation of faces.
#define GUSSET_NET_ORIENTED 4
/// Consistent after reversal of some faces.
#define GUSSET_NET_ORIENTABLE 8

/// Quotient complex: the surface of a net.
typedef struct gusset_net_complex gusset_net_complex;

/// Counts, and sorted lists of defects. A vertex is its smallest node, an edge a pair.
typedef struct gusset_net_complex_view {
    size_t struct_size;
    uint64_t vertex_count;
    /// Edges; links with equal ends are one.
    uint64_t edge_count;
    uint64_t quad_count;
    uint64_t triangle_count;
    /// Cells reduced to an edge.
    uint64_t digon_count;
    /// Cells reduced to a point.
    uint64_t point_count;
    /// Cells folded along a diagonal.
    uint64_t fold_count;
    uint64_t boundary_edge_count;
    uint64_t component_count;
    /// Vertices - edges + faces.
    int64_t euler;
    /// Handles, or crosscaps if not orientable, of all components; -1 if not manifold.
    int64_t genus;
    gusset_net_flags properties;
    uint32_t reserved;
    /// Offsets into boundary_nodes, by chain.
    struct gusset_indices boundary_offsets;
    /// Vertices of chains of boundary edges, faces on the left.
    struct gusset_indices boundary_nodes;
    /// For each chain: 1 if it ends at branches, 0 for a loop.
    struct gusset_indices boundary_open;
    /// Edges without faces.
    struct gusset_indices wires;
    /// Non-manifold edges.
    struct gusset_indices branches;
    /// Vertices whose faces form several fans.
    struct gusset_indices pinches;
    /// Edges that two faces traverse in one direction.
    struct gusset_indices conflicts;
} gusset_net_complex_view;

/// Determines a net's surface.
/// @errors TOO_LARGE (more than 2^31 boundary edges)
/// @complexity O(nodes), plus a sort of elements at glued nodes; linear memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_complex_create(const struct gusset_context *context,
    const struct gusset_net *net, gusset_net_cells cells, struct gusset_net_complex **quotient);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_complex_get_view(const struct gusset_net_complex *quotient,
    struct gusset_net_complex_view *view);

GUSSET_API void gusset_net_complex_destroy(struct gusset_net_complex *quotient);

/*** Morphs */

/// Path of nodes from one net to another.
typedef uint32_t gusset_morph_path;
/// Straight.
#define GUSSET_MORPH_LINEAR 0
/// Uniform best-fitting rotation, straight in the rotating frame. Rigidly moved nets keep their shape.
#define GUSSET_MORPH_RIGID 1

/// Interpolates between nets of equal rows, columns, scalar type and gluing.
/// Nodes with equal bits in both keep them. Bridges are as in first. A node missing in either is missing.
/// @param t time, from 0 (bits of first) to 1 (bits of second).
/// @errors OUT_OF_RANGE (t), SIDES_DIFFER (another size; see gusset_net_copy_options), MIXED_SCALARS, GLUINGS_DIFFER
///     (node), ORIENTATION_CONFLICT (one net is reversed)
/// @complexity O(nodes).
/// @source Horn 1987, for the rotation.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_morph_create(const struct gusset_context *context,
    const struct gusset_net *first, const struct gusset_net *second, double t, gusset_morph_path path,
    struct gusset_net **between);

/*** Normals */

/// Computes the unit normal of every node.
/// Directions are as in gusset_net_view, opposite if reversed. All cells at a glued point give its nodes one normal,
/// equal in bits. Absent cells do not count.
/// @param x x: rows x columns aligned numbers of the net's scalar type. Buffers must not overlap each other or the net.
/// @param capacity numbers in each.
/// @param missing_count number of nodes without a normal, which get 0: missing, or their cells' areas vanish or cancel.
///     May be NULL.
/// @errors OVERLAP
/// @complexity O(nodes); a bit a node, and memory for glued nodes.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_normals(const struct gusset_context *context,
    const struct gusset_net *net, void *x, void *y, void *z, size_t capacity, uint64_t *missing_count);

/*** Planar cells */

typedef struct gusset_planarise_options {
    size_t struct_size;
    /// Distance of corners from their mean plane, relative to the box diagonal; 0: 1e-10, float: 4e-7.
    double tolerance;
    /// For each node, 1: it stays with all nodes glued to it. NULL: all may move.
    const uint8_t *fixed;
    /// rows * columns; 0 with NULL.
    size_t fixed_count;
    /// Most steps; 0: 100.
    uint32_t max_iterations;
    /// 1: boundary vertices of the surface stay.
    uint32_t keep_boundary;
} gusset_planarise_options;

/// Result of gusset_net_planarise.
typedef struct gusset_planarise_report {
    size_t struct_size;
    /// Initial box diagonal.
    double size;
    /// Tolerance times size.
    double tolerance;
    /// Largest initial distance of corners from their mean plane.
    double deviation_before;
    /// Largest final distance.
    double deviation_after;
    /// Largest displacement of a point.
    double max_displacement;
    /// Root mean square displacement of all points of quads.
    double rms_displacement;
    /// Cell with deviation_after; UINT64_MAX without quads.
    uint64_t worst_cell;
    /// Steps; 0 if all cells were planar and no bit changed.
    uint32_t iterations;
    /// 1: deviation_after is within the tolerance.
    uint32_t converged;
} gusset_planarise_report;

/// Makes all cells planar, with locally least squared displacement.
/// Glued nodes stay one point. Absent cells, and those below four corners, do not count.
/// @errors OUT_OF_RANGE (tolerance), COUNT_DIFFERS (fixed_count too small)
/// @complexity O(n^1.5) time a step and O(n log n) memory for n cells.
/// @threads Uses one thread.
/// @source Deryagin, "Closures"; Liu et al. 2006.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_planarise(const struct gusset_context *context,
    struct gusset_net *net, const struct gusset_planarise_options *options, struct gusset_planarise_report *report);

/*** Bridges at rest */

typedef struct gusset_settle_options {
    size_t struct_size;
    /// Largest displacement in the last step, relative to the box diagonal; 0: 1e-12.
    double tolerance;
    /// Ratio of rest lengths to lengths in the reference, above 0; 0: 1.
    double rest_ratio;
    /// Net of equal size for rest lengths and shapes of rigid bridges; NULL: itself.
    const struct gusset_net *reference;
    /// For each part between bridges: 1 moves it as a rigid body, 0 holds it. NULL holds all.
    const uint8_t *free;
    /// At least the number of parts; 0 with NULL.
    size_t free_count;
    /// Most steps; 0: 1000.
    uint32_t max_iterations;
    uint32_t reserved;
} gusset_settle_options;

/// Result of gusset_net_settle. Energies are forces times lengths.
typedef struct gusset_settle_report {
    size_t struct_size;
    /// Initial energy, rigid bridges in shape.
    double energy_before;
    /// Final energy of tension.
    double tension_energy;
    /// Final energy of elasticity.
    double elastic_energy;
    /// Final energy of bending.
    double bending_energy;
    /// Largest final force on an inner point or free body.
    double residual_force;
    /// Largest displacement of a point.
    double max_displacement;
    /// Steps.
    uint32_t iterations;
    /// Counted bridges with forces.
    uint32_t settled;
    /// Counted bridges without forces, whose nodes stay: hidden, welded, or with properties 0.
    uint32_t idle;
    /// Films with a cell below 1e-6 of the initial mean cell area.
    uint32_t collapsed;
    /// 1: no film collapsed, and the last step met the tolerance or was too small to lower the energy.
    uint32_t converged;
    uint32_t reserved;
} gusset_settle_report;

/// Moves inner nodes of bridges, and free parts, to equilibrium.
/// Only bridges from side to side count, in the direction of the last. A bridge of infinite stiffness and its sides are
/// a rigid body. If connected parts lack a held one, the first is held.
/// The result is a local minimum of the sum of energies; no step increases it. Energies of a line across a bridge:
/// - tension times its length, with evenly spaced nodes; in a tube, times the film's area.
/// - elasticity / 2 (l - r)^2 / r a link of length l and rest length r.
/// - stiffness / 2 h^3 times squared second differences, h the mean rest length. Lines leave parts in their direction.
/// @errors COUNT_DIFFERS (free_count too small), SIDES_DIFFER (reference's size), OUT_OF_RANGE (tolerance, rest_ratio;
///     property negative, NaN or infinite, by bridge), NO_SUCH_ELEMENT (overlapping bridges)
/// @complexity O(nodes), and O(n^1.5) time a step and O(n log n) memory for n inner nodes.
/// @threads Uses one thread.
/// @source Deryagin, "Concatenation"; Schek 1974; Pinkall and Polthier 1993.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_settle(const struct gusset_context *context, struct gusset_net *net,
    const struct gusset_settle_options *options, struct gusset_settle_report *report);

/*** Validation */

typedef uint32_t gusset_net_finding_kind;
/// Violation: ends of contracted link element are apart, or one is missing.
#define GUSSET_NET_FINDING_LINK_APART 0
/// Violation: two nodes glued by seam element are apart, or one is missing.
#define GUSSET_NET_FINDING_SEAM_APART 1
/// Warning: ends of link element are one point, but it is not contracted; see saturate of gusset_glue_options.
#define GUSSET_NET_FINDING_LOOP 2
/// Warning: the ends of link element coincide without being glued.
#define GUSSET_NET_FINDING_ZERO_LENGTH 3
/// Warning: link element closes a row or column of fewer than four nodes.
#define GUSSET_NET_FINDING_FEW_NODES 4

/// Finding of a validation.
typedef struct gusset_net_finding {
    gusset_net_finding_kind kind;
    /// Link, or index of the seam.
    uint32_t element;
    /// The two nodes.
    uint32_t nodes[2];
    /// Distance of the nodes; NaN if one is missing.
    double distance;
} gusset_net_finding;

/// Findings of a validation.
typedef struct gusset_net_validation gusset_net_validation;

/// Violations, then warnings, sorted by kind and element.
typedef struct gusset_net_validation_view {
    size_t struct_size;
    /// The findings.
    const struct gusset_net_finding *findings;
    size_t count;
    size_t violation_count;
} gusset_net_validation_view;

/// Checks that glued nodes coincide (as do missing ones), and warns of suspicious gluing.
/// @param tolerance largest distance of coincident nodes; 0: equal coordinates (0 equals -0).
/// @errors OUT_OF_RANGE (tolerance)
/// @complexity O(nodes), plus a sort of the findings.
/// @source Deryagin, "Non-spatial operations".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_validation_create(const struct gusset_context *context,
    const struct gusset_net *net, double tolerance, struct gusset_net_validation **validation);

/// Lends the findings.
/// @complexity O(log findings).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_validation_get_view(const struct gusset_net_validation *validation,
    struct gusset_net_validation_view *view);

GUSSET_API void gusset_net_validation_destroy(struct gusset_net_validation *validation);

#ifdef __cplusplus
}
#endif
#endif
