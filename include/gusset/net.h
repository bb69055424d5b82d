/* Generated from src/capi; do not edit. See gusset.h. */

#ifndef GUSSET_NET_H
#define GUSSET_NET_H
#include "base.h"
#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Nets: Regular nets of quads with coordinates. */

/// Coordinate matrices, possibly interleaved or column-major. Number (i, j) of each begins i * row_stride + j *
/// column_stride bytes after the first.
/// Normals follow the cross product of increasing column and increasing row.
typedef struct gusset_net_view {
    size_t struct_size;
    /// At least 2.
    size_t rows;
    /// At least 2; rows * columns is at most 2^31 - 1.
    size_t columns;
    /// First coordinates.
    void *x;
    /// Second coordinates.
    void *y;
    /// Third coordinates.
    void *z;
    /// Bytes from row to row; 0: no gaps.
    size_t row_stride;
    /// Bytes from number to number in a row; 0: no gaps.
    size_t column_stride;
    gusset_scalar scalar;
    uint32_t reserved;
} gusset_net_view;

/// Memory of a net's coordinates.
typedef uint32_t gusset_net_memory;
/// Copied to the library's memory.
#define GUSSET_NET_MEMORY_COPY 0
/// The caller's memory; changes with the net.
#define GUSSET_NET_MEMORY_BORROW 1

struct gusset_net;

struct gusset_net_gluing;

/// Makes a net from coordinates.
/// Borrowed matrices are aligned, without gaps in rows; row_stride is a multiple of the scalar's size. They do not
/// overlap, and stay valid until the net is destroyed.
/// @param gluing NULL: nothing is glued.
/// @errors NET_TOO_SMALL, TOO_LARGE, BAD_STRIDE, OVERLAP, OUT_OF_RANGE (a byte of the matrix), BAD_SEAM, CROSSING_CELL
/// @complexity O(nodes + pairs of seams); 12 or 24 bytes a node, and 1/4 byte if sides do not give the gluing. Borrowed
///     without matrix and seams: O(1).
/// @source Deryagin, "Model of the tetragonal regular network".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_create(const struct gusset_context *context,
    const struct gusset_net_view *view, const struct gusset_net_gluing *gluing, gusset_net_memory memory,
    struct gusset_net **net);

/// Destroys a net.
GUSSET_API void gusset_net_destroy(struct gusset_net *net);

/// Lends the coordinates for reading.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_get_view(const struct gusset_net *net,
    struct gusset_net_view *view);

/// Lends the coordinates for writing, until the next call with this net.
/// The caller keeps glued nodes equal; see snap of gusset_glue_options. Shared memory is copied first.
/// @complexity O(1), or O(nodes) if memory is copied.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_edit(const struct gusset_context *context, struct gusset_net *net,
    struct gusset_net_view *view);

/// Copies the coordinates to the caller's matrices.
/// @param view matrices of the net's size, in any layout and scalar type. Conversion to float rounds. Bytes in gaps
///     stay.
/// @errors SIDES_DIFFER (another size), BAD_STRIDE
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_read(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_net_view *view);

/* ---- The handle of a net: Indices of nodes, cells and links. */

/// Net: a matrix of nodes with coordinates, and its gluing.
/// - Node (i, j) has index i * columns + j; cell (i, j) has i * (columns - 1) + j.
/// - Link 2 * node leads to the next node of the row, 2 * node + 1 of the column; the last node links to the first.
/// - A node with a NaN or infinite coordinate is missing. A cell with a missing corner, or of a hidden bridge, is
///   absent.
typedef struct gusset_net gusset_net;

/* ---- Gluing of sides: Sides, the characteristic matrix, seams. */

/// Seam: glues node k of run A, (row_a + k * row_step_a, column_a + k * column_step_a), to node k of run B.
typedef struct gusset_seam {
    /// Row of the first node of A.
    uint32_t row_a;
    /// Column of the first node of A.
    uint32_t column_a;
    /// Rows from node to node.
    int32_t row_step_a;
    /// Columns from node to node.
    int32_t column_step_a;
    /// As for A.
    uint32_t row_b;
    /// As for A.
    uint32_t column_b;
    /// As for A.
    int32_t row_step_b;
    /// As for A.
    int32_t column_step_b;
    /// Nodes, at least 1; 1 if all steps are 0.
    uint32_t count;
    uint32_t reserved;
} gusset_seam;

/// Gluing of sides.
/// @bits
typedef uint32_t gusset_sides;
/// Each row is closed: its last node is its first.
#define GUSSET_SIDES_ROWS_CLOSED 1
/// Each column is closed.
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
/// Rows are closed, the first and last are poles.
#define GUSSET_SIDES_TWO_POLES 13
/// All four sides are one point.
#define GUSSET_SIDES_ONE_POLE 60
/// Rows and columns are closed.
#define GUSSET_SIDES_TORUS 3

/// Gluing of a net. Default: nothing is glued.
typedef struct gusset_net_gluing {
    size_t struct_size;
    /// Characteristic matrix: 2 * rows rows of columns bytes, 1 for a contracted link, else 0. Row 2i has the
    /// horizontal links of row i, row 2i + 1 the vertical ones. NULL: sides.
    const uint8_t *matrix;
    /// Additional seams.
    const struct gusset_seam *seams;
    size_t seam_count;
    /// Sides; 0 with a matrix.
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

/// Gluing of a net in normal form: sides replace links, and links replace seams, where possible.
typedef struct gusset_net_gluing_report {
    size_t struct_size;
    /// Bytes of the characteristic matrix: 2 * rows * columns.
    size_t matrix_size;
    size_t seam_count;
    size_t bridge_count;
    /// Sides, if they describe all links; else UINT32_MAX.
    gusset_sides sides;
    /// 1: opposite orientation of faces. @flag
    uint32_t reversed;
} gusset_net_gluing_report;

/// Writes the gluing of a net. NULL with capacity 0 skips an array.
/// @param matrix receives the characteristic matrix.
/// @param matrix_capacity at least matrix_size of the report.
/// @param seam_capacity at least seam_count of the report.
/// @errors BUFFER_TOO_SMALL
/// @complexity O(seams) for seams, O(nodes) for the matrix, else O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_get_gluing(const struct gusset_net *net, uint8_t *matrix,
    size_t matrix_capacity, struct gusset_seam *seams, size_t seam_capacity, struct gusset_net_gluing_report *report);

/* ---- Gluing of nodes: Glues and unglues nodes; the 18 local gluings. */

/// Kind of a gluing. See gusset_net for indices.
typedef uint32_t gusset_gluing_kind;
/// The two ends of link element.
#define GUSSET_GLUING_LINK 0
/// Node element and its neighbours in the mask: east 1, south 2, west 4, north 8. Links at sides lead to the opposite
/// side.
#define GUSSET_GLUING_STAR 1
/// The two ends of each link of cell element in the mask: top 1, right 2, bottom 4, left 8.
#define GUSSET_GLUING_CELL 2
/// Opposite corners of cell element: mask 1 for the first and third, 2 for the second and fourth.
#define GUSSET_GLUING_DIAGONAL 3
/// The two runs of a seam.
#define GUSSET_GLUING_SEAM 4
/// The local gluing of type mask (GUSSET_TYPE_...) at node element; from GUSSET_TYPE_TOP_BOTTOM on, at cell element.
#define GUSSET_GLUING_TYPE 5

/// Names one place to glue or to unglue: a link, a node, a cell or a seam.
typedef struct gusset_gluing {
    gusset_gluing_kind kind;
    /// Link, node or cell; 0 for a seam.
    uint32_t element;
    /// As the kind says; 0 for links and seams.
    uint32_t mask;
    uint32_t reserved;
    /// For GUSSET_GLUING_SEAM only.
    struct gusset_seam seam;
} gusset_gluing;

/// Local gluing of Deryagin's figure 4. His type n(...) counts contracted links of a node, c(...) of a cell.
typedef uint32_t gusset_gluing_type;
/// Nothing is glued.
#define GUSSET_TYPE_NONE 4294967295
/// n(1): one horizontal link.
#define GUSSET_TYPE_HORIZONTAL 0
/// n(1): one vertical link.
#define GUSSET_TYPE_VERTICAL 1
/// n(2,1): east and south links of a node.
#define GUSSET_TYPE_EAST_SOUTH 2
/// n(2,1): south and west links of a node.
#define GUSSET_TYPE_SOUTH_WEST 3
/// n(2,1): west and north links of a node.
#define GUSSET_TYPE_WEST_NORTH 4
/// n(2,1): north and east links of a node.
#define GUSSET_TYPE_NORTH_EAST 5
/// n(2,2): east and west links of a node.
#define GUSSET_TYPE_EAST_WEST 6
/// n(2,2): north and south links of a node.
#define GUSSET_TYPE_NORTH_SOUTH 7
/// n(3): east, south and west links of a node.
#define GUSSET_TYPE_BUT_NORTH 8
/// n(3): south, west and north links of a node.
#define GUSSET_TYPE_BUT_EAST 9
/// n(3): west, north and east links of a node.
#define GUSSET_TYPE_BUT_SOUTH 10
/// n(3): north, east and south links of a node.
#define GUSSET_TYPE_BUT_WEST 11
/// n(4): all four links of a node.
#define GUSSET_TYPE_ALL 12
/// c(2,1): top and bottom of a cell.
#define GUSSET_TYPE_TOP_BOTTOM 13
/// c(2,1): right and left of a cell.
#define GUSSET_TYPE_RIGHT_LEFT 14
/// c(3): three links of a cell, and so the fourth: all its corners become one point.
#define GUSSET_TYPE_POINT 15
/// c(1,2): first and third corner of a cell.
#define GUSSET_TYPE_FALLING 16
/// c(1,2): second and fourth corner of a cell.
#define GUSSET_TYPE_RISING 17

/// Options of gusset_net_glue. Steps follow the order detect, gluings, links, saturate, snap.
typedef struct gusset_glue_options {
    size_t struct_size;
    /// For detect: largest distance of coincident nodes; at least 0, finite.
    double tolerance;
    /// Gluings to add.
    const struct gusset_gluing *gluings;
    size_t gluing_count;
    /// Links to contract; see contracted of gusset_net_analysis_view.
    const uint32_t *links;
    size_t link_count;
    /// 1: replaces the gluing by the one that coordinates imply: of coincident neighbours, and of coincident runs of
    /// two or more side nodes in either direction. The orientation stays. @flag
    uint32_t detect;
    /// 1: canonical form. Links with ends in one point are contracted, and redundant seams dropped. Nets that glue
    /// equal neighbours then have equal matrices. detect implies it. @flag
    uint32_t saturate;
    /// 1: moves the nodes of a point to its first node, bit for bit. @flag
    uint32_t snap;
    uint32_t reserved;
} gusset_glue_options;

/// Glues nodes, and optionally moves glued nodes together.
/// @param moved receives the count of changed nodes, or NULL.
/// @errors OUT_OF_RANGE (tolerance, a mask above 15), NO_SUCH_ELEMENT (a link, node or cell), BAD_SEAM (by index of the
///     gluing), CROSSING_CELL, TOO_LARGE
/// @complexity O(nodes + glued pairs); detect sorts the side nodes. snap alone: O(rows + columns) if only sides are
///     glued, else O(nodes).
/// @source Deryagin, "Local gluings of nodes".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_glue(const struct gusset_context *context, struct gusset_net *net,
    const struct gusset_glue_options *options, uint64_t *moved);

/// Unglues pairs of nodes: frees their links and cuts their seams.
/// Nodes that other gluings connect stay one point. Pairs not glued are ignored.
/// @param separation gap between the pieces of a point, or 0. Each piece moves by half of it towards the mean of its
///     neighbours, preferably unsplit ones. A piece without neighbours, or at their mean, stays.
/// @param moved receives the count of moved pieces, or NULL.
/// @errors as gusset_net_glue, OUT_OF_RANGE (separation negative or not finite)
/// @complexity O(nodes), plus a sort of pairs.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_unglue(const struct gusset_context *context, struct gusset_net *net,
    const struct gusset_gluing *gluings, size_t count, double separation, uint64_t *moved);

/* ---- Local gluings: How nodes and cells are glued. */

/// Writes for each node the first node of its point.
/// @param classes receives rows * columns numbers.
/// @param written receives the count.
/// @errors BUFFER_TOO_SMALL
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
    /// Group k is members[offsets[k]] to members[offsets[k + 1] - 1].
    struct gusset_indices offsets;
    /// Nodes of all groups, in order within each.
    struct gusset_indices members;
} gusset_net_groups_view;

/// Lends the groups.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_groups_get_view(const struct gusset_net_groups *groups,
    struct gusset_net_groups_view *view);

/// Destroys groups.
GUSSET_API void gusset_net_groups_destroy(struct gusset_net_groups *groups);

/// Element that has a local gluing.
typedef uint32_t gusset_gluing_place;
/// Node with glued links.
#define GUSSET_GLUING_PLACE_NODE 0
/// Cell with glued corners.
#define GUSSET_GLUING_PLACE_CELL 1

/// Finds the local gluing at a node or cell.
/// @param element node or cell.
/// @param cyclic 1: links back to the first row or column count; else 0.
/// @param found receives the type, for a node at most GUSSET_TYPE_ALL; GUSSET_TYPE_NONE for a node without glued links
///     and for a quad.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1) if only sides are glued, else O(nodes).
/// @source Deryagin, Fig. 4.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_classify(const struct gusset_context *context,
    const struct gusset_net *net, gusset_gluing_place place, uint32_t element, uint32_t cyclic,
    gusset_gluing_type *found);

/// Counts the local gluings by type.
/// @param nodes receives 18 counts, as for cyclic 0, or NULL.
/// @param cells receives 18 counts, or NULL.
/// @complexity O(nodes); 4 bytes a node.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_histogram(const struct gusset_context *context,
    const struct gusset_net *net, uint64_t *nodes, uint64_t *cells);

/// Local gluing: n(a,b) at a node or c(a,b) at a cell, as in Deryagin's Fig. 4.
typedef struct gusset_gluing_occurrence {
    gusset_gluing_place place;
    /// Node or cell.
    uint32_t element;
    gusset_gluing_type kind;
    /// At a node: nodes glued to it. At a cell: glued links, at most 3; 1 for a diagonal.
    uint32_t a;
    /// At a node with two glued links: 1 if adjacent, 2 if opposite. At a cell with two: other links between them, 0 or
    /// 1. For a diagonal: 2. Else UINT32_MAX.
    uint32_t b;
    /// United nodes.
    uint32_t node_order;
    /// United links; 1 if none.
    uint32_t link_order;
    /// Nodes of the point; exceeds node_order where gluings meet.
    uint32_t class_size;
} gusset_gluing_occurrence;

/// Writes all local gluings: of nodes in order, then of cells.
/// @param cyclic as for gusset_net_classify.
/// @param found receives the gluings.
/// @param written receives the count.
/// @errors BUFFER_TOO_SMALL
/// @complexity O(nodes); 4 bytes a node, and the result.
/// @source Deryagin, Fig. 4.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_gluing_occurrences(const struct gusset_context *context,
    const struct gusset_net *net, uint32_t cyclic, struct gusset_gluing_occurrence *found, size_t capacity,
    size_t *written);

/* ---- Shapes: Spheres, cylinders, boxes, tori, one-sided surfaces and others. */

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
/// Regular prism: sides, radius (circumscribed), height. At least 4 rows and sides + 1 columns.
#define GUSSET_NET_PRISM 5
/// Cone with base: radius, height. From 3 x 4 nodes.
#define GUSSET_NET_CONE 6
/// Regular pyramid: sides, radius (circumscribed), height. At least 3 rows and sides + 1 columns.
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
/// Each cap closes along a slit. Unit quads; no seams.
#define GUSSET_NET_BOX_SLIT 0
/// Crosswise unwrapping. Unit quads; two seams.
#define GUSSET_NET_BOX_CROSS 1
/// Concentric rings, with the fewest nodes; triangles along the diagonals.
#define GUSSET_NET_BOX_CONCENTRIC 2

/// Standard shape and its measures.
typedef struct gusset_net_primitive {
    size_t struct_size;
    gusset_net_shape shape;
    gusset_scalar scalar;
    /// 0: 33. Boxes and lathes ignore it.
    size_t rows;
    /// 0: 65. Boxes ignore it.
    size_t columns;
    /// Above 0.
    double radius;
    /// Above 0.
    double minor_radius;
    /// Height along z, above 0.
    double height;
    /// Sizes along x, y and z, above 0.
    double size[3];
    /// Distance from the axis, at least 0, and height of each point, upwards. Points on the axis are poles. A closed
    /// profile makes a ring.
    const double *profile;
    /// At least 2.
    size_t profile_count;
    /// Lateral faces of a prism or pyramid, at least 3.
    uint32_t sides;
    gusset_box_kind box_kind;
    /// Cells of a box along x, y and z, at least 1 each.
    uint32_t cells[3];
    uint32_t reserved;
} gusset_net_primitive;

/// Makes a standard shape, centred at the origin, with axis z.
/// Glued nodes have equal bits. Closed surfaces have outward normals.
/// @errors OUT_OF_RANGE (a measure, too few elements), TOO_LARGE
/// @complexity O(nodes); 12 or 24 bytes a node, and 1/4 byte for boxes.
/// @source Deryagin, "Closures of nets".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_primitive_create(const struct gusset_context *context,
    const struct gusset_net_primitive *primitive, struct gusset_net **net);

/* ---- Affine maps: Moves, rotates and scales nets. */

/// Coordinate axis.
typedef uint32_t gusset_axis;
/// x.
#define GUSSET_AXIS_X 0
/// y.
#define GUSSET_AXIS_Y 1
/// z.
#define GUSSET_AXIS_Z 2

/// Kind of an affine map. It gives the meaning of values.
typedef uint32_t gusset_operation_kind;
/// Translation by values[0..2].
#define GUSSET_OPERATION_TRANSLATE 1
/// Right-handed rotation by values[3] about the axis through values[4..6] with direction values[0..2], not 0.
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
    /// Axis of GUSSET_OPERATION_COMPRESS; else 0.
    gusset_axis axis;
    /// Numbers, as the kind says; the rest is not read.
    double values[12];
} gusset_operation;

/// Moves a net by a chain of affine maps, composed in the given order into one matrix.
/// - Computation uses the net's scalar type.
/// - Equal bits of glued nodes stay equal. Missing nodes stay missing; their finite coordinates may change.
/// - A mirroring chain changes the net's reversed flag, so faces still look outwards.
/// @param count may be 0.
/// @errors OUT_OF_RANGE (a number not finite, an axis of length 0, overflow of the product), FIELD_UNDEFINED (first
///     node to overflow)
/// @complexity O(nodes); no memory.
/// @source Deryagin, T, R, S, C.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_transform(const struct gusset_context *context,
    struct gusset_net *net, const struct gusset_operation *operations, size_t count);

/* ---- Fields: Deforms and projects nets by chains of fields. */

/// Kind of a deformation field. It gives the meaning of values.
/// - t is the strength: 0 changes nothing, 1 applies the whole map.
/// - w is the coordinate on axis; u and v are the next two in the cycle x, y, z.
/// - "Linear in t": each point moves by t times its displacement.
typedef uint32_t gusset_field_kind;
/// Affine map, linear in t: three rows of four numbers. The net's reversed flag stays.
#define GUSSET_FIELD_AFFINE 1
/// Right-handed rotation about axis by the angle t values[0] (w - values[1]).
#define GUSSET_FIELD_TWIST 2
/// Scaling of u and v by 1 + t values[0] (w - values[1]).
#define GUSSET_FIELD_TAPER 3
/// Bends axis from w = values[1] to values[2] into an arc of curvature t values[0] towards u. Straight beyond;
/// values[2] may be infinite.
#define GUSSET_FIELD_BEND 4
/// Adds t values[0] times the coordinate on other_axis to w.
#define GUSSET_FIELD_SHEAR 5
/// Central projection onto a sphere of centre values[0..2], radius values[3] > 0; linear in t. Undefined at the centre.
#define GUSSET_FIELD_SPHERIFY 6
/// Rolls space around a cylinder of radius r = values[0] > 0. Then u and v become (r + v) sin(u / r) and (r + v) cos(u
/// / r). For t < 1, the curvature is t / r. Lengths in the sheet v = 0 stay.
#define GUSSET_FIELD_CYLINDER_WRAP 7
/// Rolls space into a torus about axis: radius R = values[0] > 0, tube radius r = values[1] > 0. Coordinates u, v, w
/// become the arc around axis, the arc around the tube, and the height above the torus.
/// - t up to 1/2: a sheet rolls into a straight tube of curvature 2 t / r; lengths stay.
/// - t above 1/2: the tube bends to curvature (2 t - 1) / R; its circles keep their lengths.
#define GUSSET_FIELD_TORUS_WRAP 8
/// Free-form deformation of the box from values[0..2] to values[3..5] by tensor-product Bernstein polynomials, linear
/// in t. Points outside the box stay. The box has a uniform grid of control points, 2 to 32 along each axis, displaced
/// by offsets; x varies fastest, then y.
#define GUSSET_FIELD_LATTICE 9
/// Projective map by a 4 x 4 matrix, row by row; linear in t. Undefined where the fourth homogeneous coordinate is 0.
#define GUSSET_FIELD_PROJECTION 10
/// Parallel projection onto the plane through values[0..2] with normal values[3..5], along values[6..8]; linear in t.
#define GUSSET_FIELD_PARALLEL 11
/// Central projection from the eye values[0..2] onto the plane through values[3..5] with normal values[6..8]; linear in
/// t. Undefined in the parallel plane through the eye.
#define GUSSET_FIELD_PERSPECTIVE 12
/// Rolls space into a cone about axis. The circle w = 0 has radius r = values[0] > 0. Coordinates u, v, w become the
/// arc of this circle, the height above the cone, and the length along generators. They lean towards axis by a =
/// values[1], -pi/2 to pi/2; the apex is at w = r / sin(a).
/// For t < 1, generators lean by t a, and the curvature is t / r. Generators keep their lengths; the circle at w
/// becomes 1 - (t / r) w sin(t a) times as long.
#define GUSSET_FIELD_CONE_WRAP 13
/// Rolls space into a sphere about axis, of radius r = values[0] > 0. Coordinates u, v, w become the arc of the
/// equator, the arc of the meridian, and the height above the sphere. The ranges 0 <= u <= 2 pi r and |v| <= pi r / 2
/// cover the sphere.
/// - t up to 1/2: a sheet rolls into a tube of curvature 2 t / r; lengths stay.
/// - t above 1/2: meridians bend to curvature q / r, q = 2 t - 1, and keep their lengths. The parallel at v becomes 1 -
///   (1 - cos(q v / r)) / q times as long.
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
    /// For GUSSET_FIELD_SHEAR, not equal to axis; else 0.
    gusset_axis other_axis;
    gusset_easing easing;
    /// Strength t, times the keys'.
    double strength;
    /// Finite numbers, as the kind says; the rest is not read.
    double values[16];
    /// Finite pairs of time and strength, by increasing time. Strength is constant before the first key and after the
    /// last. NULL: constant.
    const double *keys;
    size_t key_count;
    /// Three numbers for each control point of GUSSET_FIELD_LATTICE; else NULL.
    const double *offsets;
    /// Control points of GUSSET_FIELD_LATTICE along x, y and z; else 0.
    uint32_t counts[3];
    uint32_t reserved;
} gusset_field;

/// Moves a net by a chain of fields, in the given order.
/// - For maps of your own, see gusset_net_edit, then snap of gusset_glue_options.
/// - Computation is in double precision; coordinates are rounded once.
/// - Fields of strength 0 change no bit.
/// - Equal bits of glued nodes stay equal. Missing nodes stay missing.
/// - If every field is defined everywhere, a node that overflows becomes missing.
/// @param time time of keys. For animation, deform a copy of the net at rest.
/// @errors OUT_OF_RANGE (a value, strength or time), FIELD_UNDEFINED (node where a partly undefined chain is undefined
///     or overflows)
/// @complexity O(nodes x fields); twice that if a field is partly undefined.
/// @source Deryagin, "Spatial operations"; Barr 1984; Sederberg and Parry 1986.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_deform(const struct gusset_context *context, struct gusset_net *net,
    const struct gusset_field *fields, size_t count, double time);

/// Moves every node along its normal. Glued nodes stay together; nodes without a normal stay.
/// @param distance finite, of either sign.
/// @errors OUT_OF_RANGE (distance), FIELD_UNDEFINED (first node to overflow)
/// @complexity O(nodes); memory of the size of the coordinates.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_displace(const struct gusset_context *context,
    struct gusset_net *net, double distance);

/* ---- Measures of nets: Area, volume, moments, planarity. */

/// Measures to compute.
/// @bits
typedef uint32_t gusset_net_measures;
/// Computes area, volume, area_vector, low and high.
#define GUSSET_NET_MEASURES_EXTENT 1
/// Computes bilinear_area and bilinear_error, at about ten times the cost.
#define GUSSET_NET_MEASURES_BILINEAR 2
/// Computes body_volume, centroid and inertia, at about ten times the cost.
#define GUSSET_NET_MEASURES_BODY 4

/// Measures of a net; 0 unless requested.
typedef struct gusset_net_measure_report {
    size_t struct_size;
    /// Sum of |(c - a) x (d - b)| / 2 for cells a, b, c, d; exact if planar.
    double area;
    /// Enclosed volume of a closed two-sided net, positive if normals point outwards; else volume of the cone to the
    /// first node.
    double volume;
    /// Sum of the cells' area vectors; 0 for closed nets.
    double area_vector[3];
    /// Smallest coordinates of the present nodes; infinite if all are missing.
    double low[3];
    /// Largest coordinates, likewise.
    double high[3];
    /// Area of the cells' bilinear patches, up to rounding; exceeds area unless cells are planar. All layers of a
    /// folded patch count.
    double bilinear_area;
    /// Bound of the error of bilinear_area.
    double bilinear_error;
    /// Volume of the body in a closed net; negative if normals point inwards.
    double body_volume;
    /// Centroid of the body; NaN if its volume is 0.
    double centroid[3];
    /// Inertia tensor of the body about its centroid, density 1. Diagonal: integrals of y^2 + z^2 etc.; else of -x y
    /// etc.
    double inertia[9];
} gusset_net_measure_report;

/// Planarity of cells.
typedef struct gusset_net_planarity_report {
    size_t struct_size;
    /// Largest deviation of a cell; 0 without cells.
    double worst;
    /// Its cell; 2^64 - 1 without cells.
    uint64_t worst_cell;
    /// Mean deviation; NaN without cells.
    double mean;
    /// Cells above the tolerance.
    uint64_t above;
} gusset_net_planarity_report;

/// Measures a net.
/// Absent cells do not count. Volumes, centroid and inertia are exact for bilinear cells, up to rounding. If squares or
/// cubes of coordinates overflow (about 1e77), results are infinite or NaN.
/// @complexity O(nodes); no memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_measure(const struct gusset_context *context,
    const struct gusset_net *net, gusset_net_measures measures, struct gusset_net_measure_report *report);

/// Measures the planarity of cells.
/// A cell's deviation is the distance of its corners from their mean plane, divided by the longer diagonal; 0 for
/// triangles and less, NaN for absent cells.
/// @param tolerance for above in the report, at least 0.
/// @param cells receives each cell's deviation.
/// @param written receives the number of cells.
/// @errors BUFFER_TOO_SMALL, OUT_OF_RANGE (tolerance)
/// @complexity O(nodes); 8 bytes a cell.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_planarity(const struct gusset_context *context,
    const struct gusset_net *net, double tolerance, double *cells, size_t capacity, size_t *written,
    struct gusset_net_planarity_report *report);

/* ---- Meshes and heights: Converts nets to meshes and back, and heights to nets. */

/// Faces of a net's mesh.
typedef uint32_t gusset_net_faces;
/// Quads, and triangles where one side of a cell is a point.
#define GUSSET_NET_QUADS 0
/// Triangles, cut by the shorter diagonal, or the other if that edge exists.
#define GUSSET_NET_TRIANGLES_SHORTER 1
/// Triangles, cut from (i, j) to (i + 1, j + 1), with the same exception.
#define GUSSET_NET_TRIANGLES_FIXED 2

/// Options of gusset_net_to_mesh.
typedef struct gusset_net_mesh_options {
    size_t struct_size;
    gusset_net_faces faces;
    /// 1: one vertex for each node; 0: glued nodes are one vertex. @flag
    uint32_t no_weld;
    /// 1: keeps finite vertices without faces and wires. @flag
    uint32_t keep_unused;
    /// 1: a cell with exactly one missing corner becomes a triangle. @flag
    uint32_t fill_corners;
    /// 1: computes texture coordinates. @flag
    uint32_t texture;
    uint32_t reserved;
    /// Omits faces with edges longer than this multiple of the median edge; 0: no limit. 4 removes depth jumps from
    /// range images.
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
    /// Edges without faces, two vertices each: cells whose opposite sides are glued.
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
    /// Heights of type scalar, contiguous in rows. NaN and infinity mark missing nodes.
    const void *values;
    /// Bytes from row to row; 0: no gaps.
    size_t row_stride;
    /// x from column to column, y from row to row; finite, not 0, of either sign.
    double spacing[2];
    /// Position of node (0, 0) at height 0.
    double origin[3];
    /// Height of missing nodes, if has_no_data is 1.
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

/// Options of gusset_net_from_mesh_create.
typedef struct gusset_net_grid_options {
    size_t struct_size;
    gusset_grid_cells cells;
    /// 1: only the component of face must be a grid; 0: the whole mesh. @flag
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
    /// Face of each cell; for GUSSET_GRID_TRIANGLES, the first of its two.
    struct gusset_indices face_of_cell;
} gusset_net_grid_view;

/// Correspondence between a net and its mesh.
typedef struct gusset_net_grid gusset_net_grid;

/// Makes the mesh of a net.
/// Glued nodes become one vertex: a closed net becomes a closed mesh. Absent cells are omitted; the mesh may lack
/// faces. Faces have the net's orientation.
/// @errors OUT_OF_RANGE (max_edge_ratio), TOO_LARGE (2^32 - 1 corners or more)
/// @complexity O(nodes), and O(w log w) for w cells with opposite sides glued.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_to_mesh(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_net_mesh_options *options, struct gusset_result **result);

/// Lends the maps.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_net_mesh(const struct gusset_result *result,
    struct gusset_net_mesh_report *report);

/// Makes a net from heights over a grid: node (i, j) is at origin + (j spacing[0], i spacing[1], height).
/// Faces are counter-clockwise from above, for any sign of spacing.
/// @errors NET_TOO_SMALL, TOO_LARGE, BAD_STRIDE, OUT_OF_RANGE (spacing, origin)
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_from_heights_create(const struct gusset_context *context,
    const struct gusset_heights *heights, struct gusset_net **net);

/// Finds rows and columns in a mesh, and makes their net, bit for bit.
/// The quads, at least one row, form a rectangle, possibly closed in either direction. Fans of triangles around poles
/// may adjoin its first and last row. Rows follow the only closed direction, else the first edge of the first quad.
/// With GUSSET_GRID_TRIANGLES, one diagonal of either direction cuts each quad.
/// - If several pairings of triangles form a grid, the choice is deterministic; a torus may close with a shift, unlike
///   the original rows and columns.
/// - Tubes and tori with irregular diagonals, and poles of open sheets with fewer than six triangles, may be refused.
/// @param grid receives the correspondence, or NULL.
/// @errors NO_GRID (a face that violates the grid)
/// @complexity O(H log d). Closed triangle meshes without distinct poles take several attempts.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_from_mesh_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_net_grid_options *options, struct gusset_net_grid **grid,
    struct gusset_net **net);

/// Destroys a grid.
GUSSET_API void gusset_net_grid_destroy(struct gusset_net_grid *grid);

/// Lends a grid.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_grid_get_view(const struct gusset_net_grid *grid,
    struct gusset_net_grid_view *view);

/* ---- Rows and columns: Parts, symmetries and conversions of nets. */

/// Direction within a net.
typedef uint32_t gusset_direction;
/// Along the rows, from each column to the next.
#define GUSSET_DIRECTION_RIGHT 0
/// Along the columns, from each row to the next.
#define GUSSET_DIRECTION_DOWN 1

/// Replicated rows or columns.
typedef uint32_t gusset_replication;
/// All, as equally as possible.
#define GUSSET_REPLICATE_UNIFORM 0
/// The first.
#define GUSSET_REPLICATE_FIRST 1
/// The last.
#define GUSSET_REPLICATE_LAST 2
/// The one at the given index.
#define GUSSET_REPLICATE_AT 3
/// The first and last equally if both are poles; the pole if one is; else as UNIFORM.
#define GUSSET_REPLICATE_AT_POLES 4
/// Different sizes are an error; for gusset_concatenate_options only.
#define GUSSET_REPLICATE_REFUSE 5

/// Symmetry of the rectangle of nodes. Positions and normals of nodes stay.
typedef uint32_t gusset_net_turn;
/// No change.
#define GUSSET_NET_TURN_NONE 0
/// Quarter turn: the last column becomes the first row.
#define GUSSET_NET_TURN_QUARTER 1
/// Half turn: rows and columns are reversed.
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

/// Options of gusset_net_copy_create. Steps: take a part, compact, enlarge, turn, convert. Default: none.
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
    /// Rows after replication, at least the present number; 0: none. Links between copies are contracted.
    size_t rows;
    /// Columns after replication, likewise.
    size_t columns;
    /// 1: removes rows and columns that repeat the previous one: equal coordinates and links, contracted links between
    /// both. Two rows, two columns and the ends of bridges stay. @flag
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
    /// Type of coordinates; 0: unchanged. Conversion to float rounds; overflowing nodes become missing.
    gusset_scalar scalar;
    uint32_t reserved;
} gusset_net_copy_options;

/// Copies a net, or a part, with gluing and bridges: compacted, enlarged, turned or converted.
/// - An unchanged copy shares memory until a net changes.
/// - A part keeps links, runs of seams and bridges inside it; links back to the first row or column if it has all rows
///   or columns.
/// - Without conversion, coordinates keep their bits.
/// @errors NET_TOO_SMALL, OUT_OF_RANGE (a part or index beyond the net, or fewer rows or columns than present),
///     CROSSING_CELL (once gluing outside the part is lost), TOO_LARGE
/// @complexity O(nodes) for each step; O(1) for an unchanged copy, except in the caller's memory.
/// @source Deryagin, "Reformatting".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_copy_create(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_net_copy_options *options, struct gusset_net **copy);

/// Makes nodes with a coordinate equal to value missing.
/// @param value marks missing data.
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_clear_no_data(const struct gusset_context *context,
    struct gusset_net *net, double value);

/* ---- Resolutions: Resamples and decimates nets; levels of detail. */

/// Interpolation of positions between nodes.
typedef uint32_t gusset_interpolation;
/// Catmull-Rom splines: continuous tangents, also across seams.
#define GUSSET_INTERPOLATION_BICUBIC 0
/// Bilinear patches of the cells.
#define GUSSET_INTERPOLATION_BILINEAR 1

/// Most levels of a pyramid.
#define GUSSET_PYRAMID_LEVELS 32

/// Makes a net of rows x columns nodes, spread evenly over net.
/// First and last rows and columns stay. A new node on an old one has its bits. The gluing stays; glued nodes have
/// equal bits.
/// @param rows at least 2.
/// @param columns at least 2.
/// @errors NET_TOO_SMALL, TOO_LARGE, GLUED_INSIDE
/// @complexity O(nodes of both nets).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_resample_create(const struct gusset_context *context,
    const struct gusset_net *net, size_t rows, size_t columns, gusset_interpolation interpolation,
    struct gusset_net **resampled);

/// Removes rows, then columns, within a tolerance, each time with the least deviation.
/// @param tolerance at least 0, may be infinite. Nodes are within half of it of the segments that replace their
///     columns; likewise for rows.
/// @param rows receives the kept rows, with room for all rows of net; may be NULL.
/// @param columns likewise for columns.
/// @param deviation receives the largest deviation, or NULL.
/// @errors OUT_OF_RANGE, GLUED_INSIDE
/// @complexity About O(nodes x log rows).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_decimate_create(const struct gusset_context *context,
    const struct gusset_net *net, double tolerance, uint32_t *rows, uint32_t *columns, double *deviation,
    struct gusset_net **decimated);

/// Makes levels of detail: nets of 2^k + 1 rows and columns, finest first.
/// The first level is a copy if the net has such a size, else resampled to the next larger one. Each further level has
/// every second row and column, bit for bit.
/// @param levels receives the handles.
/// @param capacity GUSSET_PYRAMID_LEVELS always suffices.
/// @param count receives the count; capacity 0 gives BUFFER_TOO_SMALL.
/// @errors BUFFER_TOO_SMALL, TOO_LARGE, GLUED_INSIDE
/// @complexity O(nodes); memory for 4/3 of the first level.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_pyramid_create(const struct gusset_context *context,
    const struct gusset_net *net, gusset_interpolation interpolation, struct gusset_net **levels, size_t capacity,
    size_t *count);

/* ---- Bridges: Joins nets into one, and splits them again. */

/// Treatment of the cells of a bridge.
typedef uint32_t gusset_bridge_mode;
/// Ordinary cells.
#define GUSSET_BRIDGE_KEEP 0
/// Absent cells.
#define GUSSET_BRIDGE_HIDE 1
/// The two sides, coincident within a tolerance, become one. Positions stay; see snap of gusset_glue_options.
#define GUSSET_BRIDGE_WELD 2

/// Form of a bridge.
typedef uint32_t gusset_bridge_kind;
/// Band between open sides.
#define GUSSET_BRIDGE_RIBBON 0
/// Closed band between closed sides.
#define GUSSET_BRIDGE_TUBE 1
/// Edge between sides that are a point each.
#define GUSSET_BRIDGE_THREAD 2

/// Physical properties of a bridge, for gusset_net_settle, in any unit of force. Lines run across the bridge along
/// links.
typedef struct gusset_bridge_properties {
    /// Force in each line of a thread or ribbon, or per length in a tube's film; at least 0.
    double tension;
    /// Force that doubles the length of a line; at least 0.
    double elasticity;
    /// Bending stiffness of each line, force times squared length; at least 0. Infinity: rigid.
    double stiffness;
    /// For the caller's use.
    uint64_t user;
} gusset_bridge_properties;

/// Options of gusset_net_concatenate_create. Default: nets from left to right, enlarged uniformly, bridges kept.
typedef struct gusset_concatenate_options {
    size_t struct_size;
    /// For welding: largest distance of coincident nodes, at least 0.
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
    /// Rotation in nodes of each later net along its closed side.
    uint32_t twist;
    /// 1: flips nets along the side if oriented unlike the first; 0: refuses them. @flag
    uint32_t turn;
    /// Inner rows or columns of each new bridge, evenly on lines; 0 for GUSSET_BRIDGE_WELD.
    uint32_t rows;
    uint32_t reserved;
} gusset_concatenate_options;

/// Bridge: the cells between two joined nets.
typedef struct gusset_bridge {
    size_t struct_size;
    /// Properties given.
    struct gusset_bridge_properties properties;
    /// Direction from the first net to the second.
    gusset_direction direction;
    /// First column (RIGHT) or row (DOWN) of the second net.
    uint32_t at;
    /// First node along the side: a row (RIGHT) or column (DOWN).
    uint32_t start;
    /// One past the last node along the side.
    uint32_t end;
    gusset_bridge_kind kind;
    gusset_bridge_mode mode;
    /// Counts the rows (DOWN) or columns (RIGHT) between the two nets. The last of these is at - 1, and the first net
    /// ends at at - rows - 1.
    uint32_t rows;
    uint32_t reserved;
} gusset_bridge;

/// Joins nets side by side into one.
/// Nets keep their gluing and bridges; links that close them along the direction become seams. A new bridge joins
/// consecutive nets; its index follows the second net's bridges. gusset_net_split_create is the inverse.
/// @param nets at least one, of one scalar type; may repeat.
/// @errors EMPTY_SCENE (no nets), MIXED_SCALARS, ORIENTATION_CONFLICT (see turn), SIDES_DIFFER (sizes with
///     GUSSET_REPLICATE_REFUSE; welded sides apart, by place and distance), OUT_OF_RANGE (tolerance, twist of an open
///     side, rows of a welded bridge), CROSSING_CELL, TOO_LARGE
/// @complexity O(nodes of the result); memory also for copies of enlarged, rotated or flipped nets.
/// @source Deryagin, "Concatenation".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_concatenate_create(const struct gusset_context *context,
    const struct gusset_net *const *nets, size_t net_count, const struct gusset_concatenate_options *options,
    struct gusset_net **joined);

/// Splits a net at a bridge from side to side, and removes it.
/// Unless changed since, both nets are as before joining, bit for bit; copies that equalised sizes are removed. Split
/// the last bridge first. Gluing across the bridge is lost.
/// @param bridge its index.
/// @errors OVERLAP (first and second are one pointer), NO_SUCH_ELEMENT (also for a bridge not from side to side),
///     CROSSING_CELL
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_split_create(const struct gusset_context *context,
    const struct gusset_net *net, size_t bridge, struct gusset_net **first, struct gusset_net **second);

/// Describes a bridge.
/// @param index below bridge_count of gusset_net_gluing_report.
/// @errors NO_SUCH_ELEMENT
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_get_bridge(const struct gusset_net *net, size_t index,
    struct gusset_bridge *bridge);

/// Changes the mode and properties of a bridge.
/// @param index as for gusset_net_get_bridge.
/// @param tolerance for welding, as in gusset_concatenate_options.
/// @param properties NULL: the old ones.
/// @errors NO_SUCH_ELEMENT, OUT_OF_RANGE (tolerance, or welding a bridge with inner rows), SIDES_DIFFER (by place and
///     distance), CROSSING_CELL
/// @complexity O(nodes) if welding begins or ends, or the net shares memory; else O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_set_bridge(const struct gusset_context *context,
    struct gusset_net *net, size_t index, gusset_bridge_mode mode, double tolerance,
    const struct gusset_bridge_properties *properties);

/* ---- Effects of a deformation: New gluing, tears, folds and stretching. */

/// Effects of a deformation on a net.
typedef struct gusset_net_analysis gusset_net_analysis;

/// Effects of a deformation.
typedef struct gusset_net_analysis_view {
    size_t struct_size;
    /// New / old length of each link; NaN if the old length is 0 or an end is missing.
    const double *links;
    /// 2 * rows * columns.
    size_t link_count;
    /// New / old area of each cell; NaN if the old area is 0 or the cell is absent. Negative for folds or, with fields,
    /// negative determinants.
    const double *cells;
    /// The fields' Jacobian determinant at each cell's centre; NULL if nets are compared.
    const double *determinants;
    /// (rows - 1) * (columns - 1).
    size_t cell_count;
    /// Newly contracted links, whose ends the net does not glue; to glue them, use links of gusset_glue_options.
    const uint32_t *contracted;
    /// For each contracted link, the local gluing of its first node once all are contracted: 0 to 17.
    const uint32_t *stars;
    size_t contracted_count;
    /// Glued links whose ends separated.
    const uint32_t *torn;
    size_t torn_count;
    /// Cells oriented against the majority.
    const uint32_t *folded;
    size_t folded_count;
    /// 1: a soft deformation, nothing newly glued, torn or folded; 0: hard. @flag
    uint32_t soft;
    uint32_t reserved;
} gusset_net_analysis_view;

/// Deformation to analyse; default: none.
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
    /// Lengths up to this count as 0; at least 0, finite.
    double tolerance;
} gusset_net_analysis_options;

/// Finds what a deformation glues, tears, folds and stretches, without deforming the net.
/// @errors OUT_OF_RANGE, SIDES_DIFFER (another size), CROSSING_CELL (new gluing), as gusset_net_deform
/// @complexity O(nodes), 24 bytes a node. Fields: O(nodes x fields), a copy of the net and 8 bytes a cell.
/// @source Deryagin, soft and hard deformations, by links: a zero of the Jacobian does not imply gluing or follow from
///     it.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_analysis_create(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_net_analysis_options *options,
    struct gusset_net_analysis **analysis);

/// Lends an analysis.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_analysis_get_view(const struct gusset_net_analysis *analysis,
    struct gusset_net_analysis_view *view);

/// Destroys an analysis.
GUSSET_API void gusset_net_analysis_destroy(struct gusset_net_analysis *analysis);

/* ---- The quotient surface: The surface of a net with glued nodes merged. */

/// Cells that count.
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

/// Counts and defects of a complex, in sorted lists. A vertex is its smallest node, an edge a pair.
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
    /// Cells folded along a diagonal to two edges.
    uint64_t fold_count;
    uint64_t boundary_edge_count;
    uint64_t component_count;
    /// Vertices - edges + faces.
    int64_t euler;
    /// Handles, or crosscaps if not orientable, of all components together; -1 if not manifold.
    int64_t genus;
    gusset_net_flags properties;
    uint32_t reserved;
    /// Chain k of boundary edges is boundary_nodes[offsets[k]] to boundary_nodes[offsets[k + 1] - 1].
    struct gusset_indices boundary_offsets;
    /// Vertices of all chains, with faces on the left.
    struct gusset_indices boundary_nodes;
    /// For each chain: 1 if it ends at branches, 0 for a loop. @flag
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

/// Determines the surface of a net.
/// @errors TOO_LARGE (more than 2^31 boundary edges)
/// @complexity O(nodes), plus a sort of the elements at glued nodes; linear memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_complex_create(const struct gusset_context *context,
    const struct gusset_net *net, gusset_net_cells cells, struct gusset_net_complex **quotient);

/// Lends the counts and defects.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_complex_get_view(const struct gusset_net_complex *quotient,
    struct gusset_net_complex_view *view);

/// Destroys a complex.
GUSSET_API void gusset_net_complex_destroy(struct gusset_net_complex *quotient);

/* ---- Morphs: Interpolates between two nets. */

/// Path of nodes from one net to another.
typedef uint32_t gusset_morph_path;
/// Straight.
#define GUSSET_MORPH_LINEAR 0
/// Uniform best-fitting rotation, straight in the rotating frame. A rigidly moved net keeps its shape.
#define GUSSET_MORPH_RIGID 1

/// Interpolates between two nets with equal rows, columns, scalar type and gluing.
/// Nodes with equal bits in both nets keep equal bits. Bridges are as in first. A node missing in either net is
/// missing.
/// @param t time, from 0 (the bits of first) to 1 (the bits of second).
/// @errors OUT_OF_RANGE (t), SIDES_DIFFER (another size; see gusset_net_copy_options), MIXED_SCALARS, GLUINGS_DIFFER
///     (node), ORIENTATION_CONFLICT (one net is reversed)
/// @complexity O(nodes).
/// @source Horn 1987, for the rotation.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_morph_create(const struct gusset_context *context,
    const struct gusset_net *first, const struct gusset_net *second, double t, gusset_morph_path path,
    struct gusset_net **between);

/* ---- Normals: Unit normals, exact at poles and seams. */

/// Computes the unit normal of every node.
/// Normals follow gusset_net_view; reversed nets have opposite ones. All cells at a glued point give its nodes one
/// normal, equal in bits. Absent cells do not count.
/// @param x receives x: rows x columns aligned numbers of the net's scalar type. Buffers must not overlap each other or
///     the net.
/// @param y receives y.
/// @param z receives z.
/// @param capacity size of each buffer, in numbers.
/// @param missing_count receives the number of nodes without a normal, which get zeros: they are missing, or their
///     cells' areas vanish or cancel. May be NULL.
/// @errors BUFFER_TOO_SMALL, OVERLAP
/// @complexity O(nodes); a bit a node, and memory for glued nodes.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_normals(const struct gusset_context *context,
    const struct gusset_net *net, void *x, void *y, void *z, size_t capacity, uint64_t *missing_count);

/* ---- Planar cells: Moves nodes until all cells are planar. */

/// Options of gusset_net_planarise.
typedef struct gusset_planarise_options {
    size_t struct_size;
    /// Distance of corners from their mean plane, relative to the diagonal of the bounding box; 0: 1e-10, or 4e-7 for
    /// float.
    double tolerance;
    /// For each node, 1: it stays with all nodes glued to it. NULL: all may move. @flag
    const uint8_t *fixed;
    /// rows * columns; 0 with NULL.
    size_t fixed_count;
    /// Most steps; 0: 100.
    uint32_t max_iterations;
    /// 1: boundary vertices of the surface stay. @flag
    uint32_t keep_boundary;
} gusset_planarise_options;

/// Result of gusset_net_planarise.
typedef struct gusset_planarise_report {
    size_t struct_size;
    /// Initial diagonal of the bounding box.
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
    /// Cell with deviation_after; 2^64 - 1 without quads.
    uint64_t worst_cell;
    /// Steps; 0 if all cells were planar and no bit changed.
    uint32_t iterations;
    /// 1: deviation_after is within the tolerance. @flag
    uint32_t converged;
} gusset_planarise_report;

/// Makes all cells planar, with locally least squared displacement.
/// Glued nodes stay one point. Absent cells and cells of fewer than four corners do not count.
/// @errors OUT_OF_RANGE (tolerance), COUNT_DIFFERS (fixed_count too small)
/// @complexity For each step O(n^1.5) time and O(n log n) memory for n cells.
/// @threads Uses one thread.
/// @source Deryagin, "Closures"; Liu et al. 2006.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_planarise(const struct gusset_context *context,
    struct gusset_net *net, const struct gusset_planarise_options *options, struct gusset_planarise_report *report);

/* ---- Bridges at rest: Settles bridges under tension, elasticity and stiffness. */

/// Options of gusset_net_settle.
typedef struct gusset_settle_options {
    size_t struct_size;
    /// Largest displacement in the last step, relative to the bounding box's diagonal; 0: 1e-12.
    double tolerance;
    /// Ratio of rest lengths to lengths in the reference, above 0; 0: 1.
    double rest_ratio;
    /// Net of equal size for rest lengths and shapes of rigid bridges; NULL: the net itself.
    const struct gusset_net *reference;
    /// For each part between bridges, in order: 1 moves it as a rigid body, 0 holds it. NULL holds all. @flag
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
    /// Films with a cell below a millionth of the initial mean cell area.
    uint32_t collapsed;
    /// 1: no film collapsed, and the last step met the tolerance or was too small to lower the energy. @flag
    uint32_t converged;
    uint32_t reserved;
} gusset_settle_report;

/// Moves inner nodes of bridges, and free parts, to the equilibrium of the bridges' properties.
/// Only bridges from side to side count, in the direction of the last of them. A bridge of infinite stiffness and its
/// two sides are a rigid body. If connected parts lack a held one, the first is held.
/// The result is a local minimum of the sum of energies; no step increases it. Energies of a line across a bridge:
/// - tension times its length, with evenly spaced nodes. In a tube: tension times the film's area.
/// - elasticity / 2 (l - r)^2 / r for each link of length l and rest length r.
/// - stiffness / 2 h^3 times squared second differences, h the mean rest length. Lines leave parts in their direction.
/// @errors COUNT_DIFFERS (free_count too small), SIDES_DIFFER (reference of another size), OUT_OF_RANGE (tolerance,
///     rest_ratio; a negative, NaN or infinite property, by bridge), NO_SUCH_ELEMENT (overlapping bridges)
/// @complexity O(nodes), and for each step O(n^1.5) time and O(n log n) memory for n inner nodes.
/// @threads It uses one thread.
/// @source Deryagin, "Concatenation"; Schek 1974; Pinkall and Polthier 1993.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_settle(const struct gusset_context *context, struct gusset_net *net,
    const struct gusset_settle_options *options, struct gusset_settle_report *report);

/* ---- Validation: Checks coordinates against the gluing. */

/// Kind of a finding.
typedef uint32_t gusset_net_finding_kind;
/// Violation: the ends of contracted link element are apart, or one is missing.
#define GUSSET_NET_FINDING_LINK_APART 0
/// Violation: two nodes glued by seam element are apart, or one is missing.
#define GUSSET_NET_FINDING_SEAM_APART 1
/// Warning: the ends of link element are one point, but it is not contracted; see saturate of gusset_glue_options.
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

/// Findings: violations, then warnings, sorted by kind and element.
typedef struct gusset_net_validation_view {
    size_t struct_size;
    /// The findings.
    const struct gusset_net_finding *findings;
    size_t count;
    size_t violation_count;
} gusset_net_validation_view;

/// Checks that glued nodes coincide, and warns of suspicious gluing. Two missing nodes coincide.
/// @param tolerance largest distance of coincident nodes, at least 0; 0: equal coordinates (0 equals -0).
/// @errors OUT_OF_RANGE (tolerance)
/// @complexity O(nodes), plus a sort of the findings.
/// @source Deryagin, "Non-spatial operations".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_validation_create(const struct gusset_context *context,
    const struct gusset_net *net, double tolerance, struct gusset_net_validation **validation);

/// Lends the findings.
/// @complexity O(log findings).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_validation_get_view(const struct gusset_net_validation *validation,
    struct gusset_net_validation_view *view);

/// Destroys a validation.
GUSSET_API void gusset_net_validation_destroy(struct gusset_net_validation *validation);

#ifdef __cplusplus
}
#endif
#endif /* GUSSET_NET_H */
