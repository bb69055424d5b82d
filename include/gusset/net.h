/* Generated from src/capi; do not edit. See gusset.h. */

#ifndef GUSSET_NET_H
#define GUSSET_NET_H

#include "base.h"
#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------------------------ */
/* Nets: Regular nets of quads: the handle and its coordinates. */

/// Coordinate matrices: number (i, j) of X is at x + i * row_stride + j * column_stride bytes, and so for Y and Z.
/// Points that lie as x, y, z one after the other are matrices whose column_stride is three numbers; matrices kept by
/// columns have a row_stride of one number and a column_stride of a column. Normals are those of columns and then rows:
/// opposite to those of a sheet of the same nodes.
typedef struct gusset_net_view {
    size_t struct_size;
    /// The number of rows of nodes, H; at least 2.
    size_t rows;
    /// The number of columns, W; at least 2. rows * columns is at most 2^31 - 1.
    size_t columns;
    /// X.
    void *x;
    /// Y.
    void *y;
    /// Z.
    void *z;
    /// Bytes from row to row; 0 for rows without gaps.
    size_t row_stride;
    /// Bytes from number to number in a row; 0 for numbers without gaps.
    size_t column_stride;
    gusset_scalar scalar;
    uint32_t reserved;
} gusset_net_view;

/// Where the coordinates of a net are.
typedef uint32_t gusset_net_memory;
/// In memory of the library's: the caller's are copied.
#define GUSSET_NET_MEMORY_COPY 0
/// In the caller's memory.
#define GUSSET_NET_MEMORY_BORROW 1

struct gusset_net;

struct gusset_net_gluing;

/// Makes a net of the caller's coordinates: of a copy of them, or in the caller's own memory. A net in the caller's
/// memory changes the caller's coordinates with its own.
/// @param view the coordinates, rows x columns numbers each; any numbers: a node with one that is NaN or infinite is
///     missing. For GUSSET_NET_MEMORY_COPY they have any alignment. For GUSSET_NET_MEMORY_BORROW they are aligned to
///     their scalar type, without gaps in rows, row_stride a multiple of the scalar's size; the three must not overlap,
///     and must stay valid and unmoved until the net is destroyed.
/// @param gluing NULL for a sheet.
/// @param memory GUSSET_NET_MEMORY_COPY or GUSSET_NET_MEMORY_BORROW.
/// @errors NET_TOO_SMALL, TOO_LARGE, BAD_STRIDE, OVERLAP, OUT_OF_RANGE (a byte of the matrix), BAD_SEAM (with the
///     seam), CROSSING_CELL (with the cell)
/// @complexity O(nodes + pairs of seams); 12 or 24 bytes a node for a copy, and 1/4 where sides do not say it all. In
///     the caller's memory O(1) without a matrix and seams.
/// @source Deryagin, "Model of the tetragonal regular network".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_create(const struct gusset_context *context,
    const struct gusset_net_view *view, const struct gusset_net_gluing *gluing, gusset_net_memory memory,
    struct gusset_net **net);

/// Destroys a net; NULL is allowed.
GUSSET_API void gusset_net_destroy(struct gusset_net *net);

/// Lends size and coordinates to be read only, as copies may share them, valid until the net is changed or destroyed.
/// @param view its struct_size set.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_get_view(const struct gusset_net *net,
    struct gusset_net_view *view);

/// Lends the coordinates to be written, valid until the next call with this net. Nodes that are glued must be kept
/// equal: see `snap` of gusset_glue_options. Memory shared with a copy or a scene is copied first.
/// @errors as gusset_net_get_view
/// @complexity O(1), or O(nodes) if memory is copied.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_edit(const struct gusset_context *context, struct gusset_net *net,
    struct gusset_net_view *view);

/// Copies the coordinates of a net to the caller's matrices. Bytes between the numbers stay as they are.
/// @param view where they go, of the net's rows and columns, in any layout and of either scalar type: double to float
///     is rounded.
/// @errors SIDES_DIFFER (other rows or columns), BAD_STRIDE
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_read(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_net_view *view);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Effects of a deformation: What a deformation glues, tears, folds and stretches. */

/// What a deformation does to a net. Immutable; may be read from many threads.
typedef struct gusset_net_analysis gusset_net_analysis;

/// An analysis, lent: valid until gusset_net_analysis_destroy.
typedef struct gusset_net_analysis_view {
    size_t struct_size;
    /// Of each link (node * 2, and 1 if it is vertical; those that lead back to the first column and row included), its
    /// new length divided by its old one; NaN if it had none, or an end is missing.
    const double *links;
    /// 2 * rows * columns.
    size_t link_count;
    /// Of each cell, its new area divided by its old one; negative where the surface is folded over or, if fields are
    /// analysed, space is mirrored; NaN if it had none, or is not there.
    const double *cells;
    /// Of each cell, the determinant of the fields' Jacobian at its centre; NULL if nets are compared.
    const double *determinants;
    /// (rows - 1) * (columns - 1).
    size_t cell_count;
    /// The links that have become a point and are not glued: see `links` of gusset_glue_options.
    const uint32_t *contracted;
    /// Of each of them, what the star of its first node has become with all of them contracted: the number of the local
    /// gluing, 0 to 17.
    const uint32_t *stars;
    /// How many.
    size_t contracted_count;
    /// The glued links whose ends have come apart.
    const uint32_t *torn;
    /// How many.
    size_t torn_count;
    /// The cells that are turned the other way than most.
    const uint32_t *folded;
    /// How many.
    size_t folded_count;
    /// 1 if nothing is newly glued, torn or folded: the paper's soft deformation; else it is hard.
    uint32_t soft;
    uint32_t reserved;
} gusset_net_analysis_view;

struct gusset_field;

/// The deformation that is analysed. All zeros: none.
typedef struct gusset_net_analysis_options {
    size_t struct_size;
    /// The net after the deformation, of the same size; NULL: what the fields make of the net.
    const struct gusset_net *after;
    /// The fields, as for gusset_net_deform; none beside `after`.
    const struct gusset_field *fields;
    /// The number of fields.
    size_t field_count;
    /// The time, as for gusset_net_deform.
    double time;
    /// Lengths up to it, at least 0 and finite, are none.
    double tolerance;
} gusset_net_analysis_options;

/// Compares a net after a deformation with what it was before: what is newly glued, torn, folded over, stretched. The
/// net stays as it is. The deformation is another net, or what fields would do: then the analysis has the determinants
/// of their Jacobian too.
/// @param net the net before the deformation; its gluing counts.
/// @param options the deformation; NULL for none.
/// @errors UNKNOWN_VALUE (fields beside `after`), OUT_OF_RANGE, SIDES_DIFFER (other sizes), CROSSING_CELL (with the
///     cell (what is newly glued is no surface)), as gusset_net_deform
/// @complexity O(nodes), 24 bytes a node. For fields O(nodes x fields), and 8 bytes a cell and a copy of the net
///     besides.
/// @source Deryagin, soft and hard deformations; links are measured, as a zero of the Jacobian neither follows from
///     gluing nor implies it.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_analysis_create(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_net_analysis_options *options,
    struct gusset_net_analysis **analysis);

/// Lends an analysis.
/// @param view its struct_size set.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_analysis_get_view(const struct gusset_net_analysis *analysis,
    struct gusset_net_analysis_view *view);

/// Destroys an analysis; NULL is allowed.
GUSSET_API void gusset_net_analysis_destroy(struct gusset_net_analysis *analysis);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Rows and columns: Parts, symmetries and other layouts of nets. */

/// A direction within a net.
typedef uint32_t gusset_direction;
/// Along rows, from column to column.
#define GUSSET_DIRECTION_RIGHT 0
/// Along columns, from row to row.
#define GUSSET_DIRECTION_DOWN 1

/// Which rows, or columns, are replicated.
typedef uint32_t gusset_replication;
/// All of them, as equally as it goes.
#define GUSSET_REPLICATE_UNIFORM 0
/// The first one.
#define GUSSET_REPLICATE_FIRST 1
/// The last one.
#define GUSSET_REPLICATE_LAST 2
/// The one whose index is given.
#define GUSSET_REPLICATE_AT 3
/// The first and the last one, if they are a point each, in equal shares; if one of them is, that one; else as UNIFORM.
#define GUSSET_REPLICATE_AT_POLES 4
/// None: sizes that differ are refused. For gusset_concatenate_options only.
#define GUSSET_REPLICATE_REFUSE 5

/// A symmetry of the rectangle of nodes. Nodes stay where they are in space, and so do normals.
typedef uint32_t gusset_net_turn;
/// Rows and columns stay.
#define GUSSET_NET_TURN_NONE 0
/// A quarter of a turn: the last column becomes the first row.
#define GUSSET_NET_TURN_QUARTER 1
/// Half a turn: the last row and the last column come first.
#define GUSSET_NET_TURN_HALF 2
/// Three quarters of a turn: the first column becomes the last row.
#define GUSSET_NET_TURN_THREE_QUARTERS 3
/// The last column comes first.
#define GUSSET_NET_TURN_FLIP_COLUMNS 4
/// The last row comes first.
#define GUSSET_NET_TURN_FLIP_ROWS 5
/// Rows and columns are exchanged.
#define GUSSET_NET_TURN_TRANSPOSE 6
/// Rows and columns are exchanged, both backwards.
#define GUSSET_NET_TURN_ANTITRANSPOSE 7

/// How a copy of a net differs from it. All zeros: not at all. A part is taken first; then it is made compact,
/// enlarged, turned and converted.
typedef struct gusset_net_copy_options {
    size_t struct_size;
    /// The first row of the part that is copied.
    size_t row_first;
    /// The number of rows of the part, at least 2; 0: all from row_first on.
    size_t row_count;
    /// The first column of the part.
    size_t column_first;
    /// The number of columns of the part, at least 2; 0: all from column_first on.
    size_t column_count;
    /// The number of rows of nodes after replication, no fewer than there are; 0: as many as there are. Links between
    /// copies of a row are contracted, and the surface stays.
    size_t rows;
    /// The number of columns of nodes, likewise.
    size_t columns;
    /// 1: rows and columns that repeat the one before them are left out. The links between the two are all contracted,
    /// and coordinates and links along them are equal. Two rows and two columns stay, and so do those on which a bridge
    /// ends. 0 or 1.
    /// @flag
    uint32_t compact;
    /// For rows.
    gusset_replication row_replication;
    /// For columns.
    gusset_replication column_replication;
    /// Read for GUSSET_REPLICATE_AT: the row.
    /// @when row_replication GUSSET_REPLICATE_AT
    uint32_t row_index;
    /// Read for GUSSET_REPLICATE_AT: the column.
    /// @when row_replication GUSSET_REPLICATE_AT
    uint32_t column_index;
    /// The symmetry that rows and columns undergo.
    gusset_net_turn turn;
    /// GUSSET_F32 or GUSSET_F64: the type of the coordinates. From double to float they are rounded, and nodes whose
    /// coordinates are too large become missing. 0: the type of the net.
    gusset_scalar scalar;
    uint32_t reserved;
} gusset_net_copy_options;

/// Makes a copy of a net, with its gluing and its bridges: of all of it or of a part, with more or fewer rows and
/// columns, turned, or with coordinates of another type. A copy that differs in nothing shares the memory of the net
/// until one of the two is changed. A part keeps the links, runs of seams and bridges within it. It keeps links that
/// lead back if it has all rows, or all columns. A part, a compact, a turned or a larger net keeps the bits of its
/// coordinates.
/// @param options NULL for a copy that differs in nothing.
/// @errors NET_TOO_SMALL (a part of one row or column), OUT_OF_RANGE (a part beyond the net, fewer rows or columns than
///     there are, an index beyond the net), CROSSING_CELL (only what is outside the part made opposite corners one),
///     TOO_LARGE
/// @complexity O(nodes) for each step; O(1) for a copy that differs in nothing, unless the net is in the caller's
///     memory.
/// @source Deryagin, "Reformatting".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_copy_create(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_net_copy_options *options, struct gusset_net **copy);

/// Makes missing every node of which a coordinate is `value`, the number that stands for what a scanner did not see.
/// @param value the marker of missing data, compared exactly.
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_clear_no_data(const struct gusset_context *context,
    struct gusset_net *net, double value);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Gluing of sides: Sides, the characteristic matrix, seams. */

/// Node k of one run of nodes is node k of another: node (row_a + k * row_step_a, column_a + k * column_step_a) and
/// node (row_b + k * row_step_b, column_b + k * column_step_b), for k from 0 to count - 1.
typedef struct gusset_seam {
    /// Row of the first node of run A.
    uint32_t row_a;
    /// Its column.
    uint32_t column_a;
    /// Rows from each node to the next.
    int32_t row_step_a;
    /// Columns from each node to the next.
    int32_t column_step_a;
    /// The same for run B.
    uint32_t row_b;
    /// The same for run B.
    uint32_t column_b;
    /// The same for run B.
    int32_t row_step_b;
    /// The same for run B.
    int32_t column_step_b;
    /// The number of nodes of each; at least 1, and 1 if all steps are 0.
    uint32_t count;
    uint32_t reserved;
} gusset_seam;

/// What becomes of the sides of a net: a sum of these.
/// @bits
typedef uint32_t gusset_sides;
/// Every row is closed: its last node is its first one again.
#define GUSSET_SIDES_ROWS_CLOSED 1
/// Every column is closed.
#define GUSSET_SIDES_COLUMNS_CLOSED 2
/// The first row is one point.
#define GUSSET_SIDES_POLE_TOP 4
/// The last row is one point.
#define GUSSET_SIDES_POLE_BOTTOM 8
/// The first column is one point.
#define GUSSET_SIDES_POLE_LEFT 16
/// The last column is one point.
#define GUSSET_SIDES_POLE_RIGHT 32
/// Open on all sides.
#define GUSSET_SIDES_SHEET 0
/// Rows closed; the first and the last row are rims.
#define GUSSET_SIDES_TUBE 1
/// Rows closed, the first and the last a point each: spheres, and cylinders, prisms, cones and pyramids with their
/// caps.
#define GUSSET_SIDES_TWO_POLES 13
/// All four sides are one point: a disc whose rim is drawn together.
#define GUSSET_SIDES_ONE_POLE 60
/// Rows and columns closed.
#define GUSSET_SIDES_TORUS 3

/// What is glued to what. All zeros: nothing.
typedef struct gusset_net_gluing {
    size_t struct_size;
    /// The characteristic matrix: 2 * rows rows of columns bytes, 1 for a contracted link and 0 for others. Row 2i has
    /// the horizontal links of the nodes of row i, each to the next node and the last one to the first; row 2i + 1 the
    /// vertical ones, those of the last row to the first row. NULL: sides says it all.
    const uint8_t *matrix;
    /// Runs of nodes glued to runs of nodes, besides.
    const struct gusset_seam *seams;
    /// How many.
    size_t seam_count;
    /// What becomes of the sides; 0 with a matrix.
    gusset_sides sides;
    /// 1: faces are to be taken the other way round.
    uint32_t reversed;
} gusset_net_gluing;

/// Glues a net otherwise; positions stay what they are. On failure the net is as it was.
/// @param gluing NULL for a sheet; it replaces what was glued.
/// @errors as gusset_net_create
/// @complexity O(nodes + pairs of seams).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_set_gluing(const struct gusset_context *context,
    struct gusset_net *net, const struct gusset_net_gluing *gluing);

/// How a net is glued, in its one form, and how many parts that has.
typedef struct gusset_net_gluing_report {
    size_t struct_size;
    /// The bytes of the characteristic matrix: 2 * rows * columns.
    size_t matrix_size;
    /// The number of seams.
    size_t seam_count;
    /// The number of bridges.
    size_t bridge_count;
    /// The sides if they say all about the links of the net, else UINT32_MAX: then the matrix does.
    gusset_sides sides;
    /// 1 if faces are taken the other way round.
    uint32_t reversed;
} gusset_net_gluing_report;

/// Tells how a net is glued, and writes its characteristic matrix and its seams. A buffer that is NULL, with capacity
/// 0, is not wanted; the report has the sizes that both need. On failure the report is cleared, and the buffers may be
/// written in part.
/// @param matrix room for matrix_capacity bytes, of which report->matrix_size are written as gusset_net_gluing has
///     them.
/// @param matrix_capacity see matrix.
/// @param seams room for seam_capacity seams, of which report->seam_count are written.
/// @param seam_capacity see seams.
/// @param report its struct_size set.
/// @errors BUFFER_TOO_SMALL
/// @complexity O(seams) for seams, O(nodes) for the matrix, else O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_get_gluing(const struct gusset_net *net, uint8_t *matrix,
    size_t matrix_capacity, struct gusset_seam *seams, size_t seam_capacity, struct gusset_net_gluing_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Gluing of nodes: Glues and unglues nodes, and classifies the 18 local gluings. */

/// What a gusset_gluing glues.
typedef uint32_t gusset_gluing_kind;
/// The two ends of link `element`. Links are numbered by nodes: 2 * node is that to the next node of the row (of the
/// last one to the first), 2 * node + 1 that to the next of the column; node (i, j) is i * columns + j.
#define GUSSET_GLUING_LINK 0
/// Node `element` and its neighbours in the directions of the mask: east 1, south 2, west 4, north 8, round the sides
/// of the net.
#define GUSSET_GLUING_STAR 1
/// The ends of the links of cell `element` that are in the mask: top 1, right 2, bottom 4, left 8. Cell (i, j) is i *
/// (columns - 1) + j.
#define GUSSET_GLUING_CELL 2
/// Opposite corners of cell `element`: mask 1 for the first and the third, 2 for the second and the fourth.
#define GUSSET_GLUING_DIAGONAL 3
/// The two runs of nodes of the seam.
#define GUSSET_GLUING_SEAM 4
/// The local gluing of type `mask`, one of GUSSET_TYPE_..., at node `element`; at cell `element` from
/// GUSSET_TYPE_TOP_BOTTOM on.
#define GUSSET_GLUING_TYPE 5

/// Nodes to be glued, or no longer to be.
typedef struct gusset_gluing {
    gusset_gluing_kind kind;
    /// The link, node or cell; 0 for a seam.
    uint32_t element;
    /// See the kinds; 0 where none is said to have one.
    uint32_t mask;
    uint32_t reserved;
    /// Read for GUSSET_GLUING_SEAM only.
    struct gusset_seam seam;
} gusset_gluing;

/// One of the 18 local gluings (the paper's Fig. 4), or GUSSET_TYPE_NONE.
typedef uint32_t gusset_gluing_type;
/// Nothing is glued here.
#define GUSSET_TYPE_NONE 4294967295
/// n(1): one horizontal link.
#define GUSSET_TYPE_HORIZONTAL 0
/// n(1): one vertical link.
#define GUSSET_TYPE_VERTICAL 1
/// n(2,1): the links of a node to the east and the south.
#define GUSSET_TYPE_EAST_SOUTH 2
/// n(2,1): south and west.
#define GUSSET_TYPE_SOUTH_WEST 3
/// n(2,1): west and north.
#define GUSSET_TYPE_WEST_NORTH 4
/// n(2,1): north and east.
#define GUSSET_TYPE_NORTH_EAST 5
/// n(2,2): east and west.
#define GUSSET_TYPE_EAST_WEST 6
/// n(2,2): north and south.
#define GUSSET_TYPE_NORTH_SOUTH 7
/// n(3): all but north.
#define GUSSET_TYPE_BUT_NORTH 8
/// n(3): all but east.
#define GUSSET_TYPE_BUT_EAST 9
/// n(3): all but south.
#define GUSSET_TYPE_BUT_SOUTH 10
/// n(3): all but west.
#define GUSSET_TYPE_BUT_WEST 11
/// n(4): all four links of a node.
#define GUSSET_TYPE_ALL 12
/// c(2,1): top and bottom of a cell.
#define GUSSET_TYPE_TOP_BOTTOM 13
/// c(2,1): right and left of a cell.
#define GUSSET_TYPE_RIGHT_LEFT 14
/// c(3): a cell is one point.
#define GUSSET_TYPE_POINT 15
/// c(1,2): the first and the third corner of a cell.
#define GUSSET_TYPE_FALLING 16
/// c(1,2): the second and the fourth corner of a cell.
#define GUSSET_TYPE_RISING 17

/// How a net is glued. The steps are taken in the order of the fields; all zeros: none.
typedef struct gusset_glue_options {
    size_t struct_size;
    /// Read if `detect` is 1: the largest distance of nodes that lie together, at least 0 and finite, in the unit of
    /// the coordinates.
    double tolerance;
    /// Pairs of nodes that are glued, at any alignment.
    const struct gusset_gluing *gluings;
    /// The number of gluings.
    size_t gluing_count;
    /// Links that are contracted, such as those of gusset_net_analysis_view; numbered as for GUSSET_GLUING_LINK, at any
    /// alignment.
    const uint32_t *links;
    /// The number of links.
    size_t link_count;
    /// 1: what coordinates tell replaces what was glued, before anything else. Neighbours that lie together are glued,
    /// and runs of two and more nodes of the sides that do, forwards or backwards. The orientation of faces stays. 0 or
    /// 1.
    /// @flag
    uint32_t detect;
    /// 1: every link whose ends are one point already, by way of others, is contracted, and seams that links then say
    /// are dropped. Nets that glue the same neighbours have the same matrix in this canonical form, which `detect`
    /// gives too. 0 or 1.
    /// @flag
    uint32_t saturate;
    /// 1: all nodes that are glued to each other get the position of the first of them, bit for bit. 0: positions stay.
    /// @flag
    uint32_t snap;
    uint32_t reserved;
} gusset_glue_options;

/// Glues nodes of a net, and gives glued nodes one position. The options are done as a whole or not at all: on failure
/// the net is as it was.
/// @param options what is glued.
/// @param moved receives the number of nodes that got other bits; NULL if it is not wanted.
/// @errors UNKNOWN_VALUE (kind, mask, reserved, a flag), OUT_OF_RANGE (tolerance, a mask above 15), NO_SUCH_ELEMENT
///     (the link, node or cell), BAD_SEAM (its place among the gluings), CROSSING_CELL (with the cell (both pairs of
///     opposite corners would be glued: the nineteenth local gluing, which no surface allows)), TOO_LARGE
/// @complexity O(nodes + glued pairs), and a sort of the nodes of the sides for `detect`. For `snap` alone O(rows +
///     columns) if the net is glued along its sides alone, else O(nodes).
/// @source Deryagin, "Local gluings of nodes".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_glue(const struct gusset_context *context, struct gusset_net *net,
    const struct gusset_glue_options *options, uint64_t *moved);

/// Unglues pairs of nodes: their links are free, and seams that have them are cut there. Nodes that are still glued by
/// way of others stay one point; pairs that are not glued are left alone. On failure the net is as it was.
/// @param gluings count of them, done as a whole or not at all; at any alignment.
/// @param count see gluings.
/// @param separation 0, or how far apart what becomes separate is moved, in the unit of the coordinates: each piece of
///     a point that falls apart moves by half of it towards the mean of its neighbours (of those that do not fall apart
///     themselves, if there are any); one without neighbours, or in the middle of them, stays.
/// @param moved receives the number of pieces that moved; NULL if it is not wanted.
/// @errors as gusset_net_glue, OUT_OF_RANGE (a separation that is no finite number from 0 on)
/// @complexity O(nodes), and a sort of the pairs.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_unglue(const struct gusset_context *context, struct gusset_net *net,
    const struct gusset_gluing *gluings, size_t count, double separation, uint64_t *moved);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Local gluings: How nodes and cells are glued at a place. */

/// Writes for each node the smallest node that is the same point.
/// @param classes room for capacity numbers, of which rows * columns are written.
/// @param capacity see classes.
/// @param written receives that number. NULL and 0 ask for it.
/// @errors BUFFER_TOO_SMALL (nothing is written but the number)
/// @complexity O(nodes); 4 bytes a node.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_classes(const struct gusset_context *context,
    const struct gusset_net *net, uint32_t *classes, size_t capacity, size_t *written);

/// The points that are several nodes. Opaque and immutable; it keeps nothing of the net.
typedef struct gusset_net_groups gusset_net_groups;

/// Finds the points that are several nodes.
/// @complexity O(rows + columns) for a net that its sides describe, else O(nodes); and a sort of the glued nodes.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_groups_create(const struct gusset_context *context,
    const struct gusset_net *net, struct gusset_net_groups **groups);

/// The groups of a net, lent: valid until gusset_net_groups_destroy.
typedef struct gusset_net_groups_view {
    size_t struct_size;
    /// One more than the number of groups: group k is members[offsets[k]] up to members[offsets[k + 1]], without the
    /// latter. Groups are in the order of their first nodes.
    struct gusset_indices offsets;
    /// The nodes of all groups, each group's in order.
    struct gusset_indices members;
} gusset_net_groups_view;

/// Lends the groups.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_groups_get_view(const struct gusset_net_groups *groups,
    struct gusset_net_groups_view *view);

/// Destroys groups; NULL is allowed.
GUSSET_API void gusset_net_groups_destroy(struct gusset_net_groups *groups);

/// The element that has a local gluing.
typedef uint32_t gusset_gluing_place;
/// A node; the gluing says which of its links are glued.
#define GUSSET_GLUING_PLACE_NODE 0
/// A cell; the gluing says which of its corners are one point.
#define GUSSET_GLUING_PLACE_CELL 1

/// Finds the local gluing at a node or of a cell.
/// @param place GUSSET_GLUING_PLACE_NODE or GUSSET_GLUING_PLACE_CELL.
/// @param element the node, row * columns + column, or the cell, row * (columns - 1) + column.
/// @param cyclic 0, or 1 to count links of a node that lead back to the first row or column too.
/// @param found receives one of GUSSET_TYPE_..., at most GUSSET_TYPE_ALL for a node; GUSSET_TYPE_NONE for a node
///     without glued links and for a quad.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1) for a net that its sides describe, else O(nodes): see gusset_net_histogram for all.
/// @source Deryagin, Fig. 4.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_classify(const struct gusset_context *context,
    const struct gusset_net *net, gusset_gluing_place place, uint32_t element, uint32_t cyclic,
    gusset_gluing_type *found);

/// Counts the local gluings of a net by type.
/// @param nodes receive 18 numbers each, how many nodes (without links that lead back) and how many cells have each
///     type; NULL for what is not wanted.
/// @param cells see nodes.
/// @errors NULL_ARGUMENT (net)
/// @complexity O(nodes); 4 bytes a node.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_histogram(const struct gusset_context *context,
    const struct gusset_net *net, uint64_t *nodes, uint64_t *cells);

/// A local gluing of a net: where it is, and what it is in the letters of the paper's Fig. 4.
typedef struct gusset_gluing_occurrence {
    /// GUSSET_GLUING_PLACE_NODE: at the node `element`, a type n(a, b); GUSSET_GLUING_PLACE_CELL: of the cell
    /// `element`, a type c(a, b).
    gusset_gluing_place place;
    /// The node, row * columns + column, or the cell, row * (columns - 1) + column.
    uint32_t element;
    gusset_gluing_type kind;
    /// Of a node, how many nodes are glued to it; of a cell, how many of its links are glued, three for all; 1 for a
    /// diagonal.
    uint32_t a;
    /// Of a node with two glued links, 1 if they are adjacent and 2 if they are opposite; of a cell with two, how many
    /// of the other links lie between them, 0 or 1; 2 for a diagonal; UINT32_MAX for types that have one letter.
    uint32_t b;
    /// How many nodes the gluing makes one.
    uint32_t node_order;
    /// How many links it makes one; 1 if none.
    uint32_t link_order;
    /// How many nodes of the net are one point there: more than node_order where gluings meet, as at a pole.
    uint32_t class_size;
} gusset_gluing_occurrence;

/// Writes all local gluings of a net with their types and orders: those at its nodes, in order, then those of its
/// cells.
/// @param cyclic 0, or 1 to count links that lead back to the first row or column too.
/// @param found room for capacity of them.
/// @param capacity see found.
/// @param written receives their number. NULL and 0 ask for it.
/// @errors UNKNOWN_VALUE (cyclic), BUFFER_TOO_SMALL (nothing is written but the number)
/// @complexity O(nodes); 4 bytes a node, and as much as is written.
/// @source Deryagin, Fig. 4.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_gluing_occurrences(const struct gusset_context *context,
    const struct gusset_net *net, uint32_t cyclic, struct gusset_gluing_occurrence *found, size_t capacity,
    size_t *written);

/* ------------------------------------------------------------------------------------------------------------------ */
/* The quotient surface: The surface that a net becomes when glued nodes are one. */

/// Which cells count.
typedef uint32_t gusset_net_cells;
/// All.
#define GUSSET_NET_CELLS_ALL 0
/// Those whose four nodes have finite coordinates and that no hidden bridge has.
#define GUSSET_NET_CELLS_PRESENT 1

/// Bits that describe the surface of a net.
/// @bits
typedef uint32_t gusset_net_flags;
/// No edge has one face only.
#define GUSSET_NET_CLOSED 1
/// A surface, with or without boundary: no wires, branches and pinches.
#define GUSSET_NET_MANIFOLD 2
/// No edge that two faces run along the same way.
#define GUSSET_NET_ORIENTED 4
/// Faces can be turned over so that there is none.
#define GUSSET_NET_ORIENTABLE 8

/// The quotient complex of a net: what surface it is. Opaque and immutable; it keeps nothing of the net.
typedef struct gusset_net_complex gusset_net_complex;

/// Numbers of a complex, and whatever keeps it from being a closed oriented surface. Vertices are given by their
/// smallest nodes, edges as pairs of them, one pair after the other, in order. Pointers are valid until the complex is
/// destroyed.
typedef struct gusset_net_complex_view {
    size_t struct_size;
    /// Vertices.
    uint64_t vertex_count;
    /// Edges: pairs of vertices that links join.
    uint64_t edge_count;
    /// Faces of four corners.
    uint64_t quad_count;
    /// Faces of three.
    uint64_t triangle_count;
    /// Cells that have become an edge.
    uint64_t digon_count;
    /// Cells that have become a point.
    uint64_t point_count;
    /// Cells that are folded along a diagonal to two edges.
    uint64_t fold_count;
    /// Edges of one face.
    uint64_t boundary_edge_count;
    /// Pieces that do not hang together.
    uint64_t component_count;
    /// Vertices - edges + faces.
    int64_t euler;
    /// Handles if it is orientable, else crosscaps, of all pieces together; -1 if it is no surface.
    int64_t genus;
    /// GUSSET_NET_CLOSED, ..._MANIFOLD, ..._ORIENTED, ..._ORIENTABLE.
    gusset_net_flags properties;
    uint32_t reserved;
    /// 0, then the end of each chain of boundary edges in boundary_nodes: one more than there are chains.
    struct gusset_indices boundary_offsets;
    /// The vertices of all chains, with the faces on the left; the last of a chain is followed by its first.
    struct gusset_indices boundary_nodes;
    /// For each chain 0, or 1 if it is no loop: it ends at edges of three faces and more, and its last vertex is
    /// followed by none.
    struct gusset_indices boundary_open;
    /// Edges of no face.
    struct gusset_indices wires;
    /// Edges of three faces and more.
    struct gusset_indices branches;
    /// Vertices whose faces are several fans that meet nowhere else.
    struct gusset_indices pinches;
    /// Edges that two faces run along the same way.
    struct gusset_indices conflicts;
} gusset_net_complex_view;

/// Finds out what surface a net is once glued nodes are one. What it finds is no error.
/// @errors TOO_LARGE (2^31 edges of one face)
/// @complexity O(nodes), and a sort of what belongs to each glued node; linear extra memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_complex_create(const struct gusset_context *context,
    const struct gusset_net *net, gusset_net_cells cells, struct gusset_net_complex **quotient);

/// Lends what is known of a complex.
/// @param view receives it; struct_size is set by the caller.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_complex_get_view(const struct gusset_net_complex *quotient,
    struct gusset_net_complex_view *view);

/// Destroys a complex; NULL is allowed.
GUSSET_API void gusset_net_complex_destroy(struct gusset_net_complex *quotient);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Affine maps: Moves, rotates and scales nets. */

/// An axis of coordinates: 0 is x, 1 is y, 2 is z.
typedef uint32_t gusset_axis;
/// The abscissa.
#define GUSSET_AXIS_X 0
/// The ordinate.
#define GUSSET_AXIS_Y 1
/// The applicate.
#define GUSSET_AXIS_Z 2

/// What an operation does.
typedef uint32_t gusset_operation_kind;
/// Moves by the vector values[0] to values[2].
#define GUSSET_OPERATION_TRANSLATE 1
/// Turns about the axis with the direction values[0] to values[2], of any length but 0, by values[3] radians, by the
/// right hand; the axis passes through the point values[4] to values[6].
#define GUSSET_OPERATION_ROTATE 2
/// The same by the left hand, as Deryagin's formula is printed.
#define GUSSET_OPERATION_ROTATE_AS_PRINTED 3
/// Scales about the origin: values[0] is the ratio of new distance to old.
#define GUSSET_OPERATION_SCALE 4
/// Scales about the axis of coordinates `axis`, which stays: values[0] is the ratio of new distance to old.
#define GUSSET_OPERATION_COMPRESS 5
/// Scales x, y and z by values[0], values[1] and values[2].
#define GUSSET_OPERATION_STRETCH 6
/// Any affine map: three rows of four numbers, the fourth of each the displacement.
#define GUSSET_OPERATION_MATRIX 7

/// A spatial operation.
typedef struct gusset_operation {
    gusset_operation_kind kind;
    /// For GUSSET_OPERATION_COMPRESS; else 0.
    gusset_axis axis;
    /// What the kind says; the rest is not read.
    double values[12];
} gusset_operation;

/// Moves all nodes of a net by operations, the first one first, composed to one matrix and applied in one pass, in
/// place. The arithmetic is that of the net's scalar type; nodes that are glued and have equal bits keep them equal;
/// missing nodes stay missing (and may lose coordinates that were finite). If the operations together mirror (odd
/// numbers of reflections) the surface would be turned inside out: the net's flag `reversed` changes then, so that
/// faces look outwards as before. A cancel is heard before the first node is moved; whatever the error, none is moved.
/// @param operations `count` of them, at any alignment; 0 for none.
/// @param count see operations.
/// @errors UNKNOWN_VALUE (kind, axis), OUT_OF_RANGE (a number that is not finite, an axis of length 0, a product that
///     overflows), FIELD_UNDEFINED (with the first node that would overflow), OUT_OF_MEMORY (a net that shares its
///     memory)
/// @complexity O(nodes), no memory.
/// @threads The same bits for any number of threads.
/// @source Deryagin, T, R, S, C.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_transform(const struct gusset_context *context,
    struct gusset_net *net, const struct gusset_operation *operations, size_t count);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Fields: Deforms and projects nets by chains of fields, fixed or in time. */

/// What a field does, and what its values are. An axis and those that follow it: y and z after x, z and x after y, x
/// and y after z.
typedef uint32_t gusset_field_kind;
/// An affine map: values[0] to values[11], three rows of four. In part: that part of the straight way. Unlike
/// gusset_net_transform it leaves the net's flag `reversed` alone where it mirrors.
#define GUSSET_FIELD_AFFINE 1
/// Turns about `axis`, by the right hand, by values[0] radians for each unit along it from the coordinate values[1] on.
/// In part: by that part of the angle.
#define GUSSET_FIELD_TWIST 2
/// Distances from `axis` grow by values[0] times themselves for each unit along it from the coordinate values[1] on. In
/// part: at that part of the rate.
#define GUSSET_FIELD_TAPER 3
/// Bends `axis` from its coordinate values[1] to values[2] (only the latter may be infinite) to an arc of the curvature
/// values[0], towards the axis that follows; what lies beyond goes on straight. In part: with that part of the
/// curvature.
#define GUSSET_FIELD_BEND 4
/// The coordinate on `axis` grows by values[0] times that on `other_axis`. In part: at that part of the rate.
#define GUSSET_FIELD_SHEAR 5
/// Moves points onto the sphere with the centre values[0] to values[2] and the radius values[3] > 0, straight from its
/// centre, where it is not defined. In part: that part of the way.
#define GUSSET_FIELD_SPHERIFY 6
/// Rolls space up about `axis`: of the two axes that follow, the first becomes the arc and the second the height above
/// a cylinder of the radius r = values[0] > 0: with the first u and the second v they become (r + v) sin(u / r) and (r
/// + v) cos(u / r). In part, t: rolled to the curvature t / r, so that a sheet of height 0 keeps all its lengths.
#define GUSSET_FIELD_CYLINDER_WRAP 7
/// Rolls space up to a torus about `axis` with the radii values[0] > 0 (to the middle of the tube) and values[1] > 0
/// (of the tube): of the two axes that follow, the first goes round the axis and the second round the tube; the axis
/// itself becomes the height above the torus. In part, t: up to 1/2 the sheet rolls to a straight tube, to the
/// curvature 2 t / values[1], and keeps all its lengths; then the tube bends to the curvature (2 t - 1) / values[0] of
/// its middle, and the circles round it keep their lengths.
#define GUSSET_FIELD_TORUS_WRAP 8
/// Free-form deformation: the box from values[0..2] to values[3..5] has counts[0] x counts[1] x counts[2] control
/// points, 2 to 32 each way; offsets: how far each is moved, x, y, z, from its place in the even grid, x running first,
/// then y. Outside the box nothing moves. In part: that part of the way.
#define GUSSET_FIELD_LATTICE 9
/// A map of homogeneous coordinates: four rows of four. Not defined where the fourth coordinate becomes 0. In part:
/// that part of the straight way, as for the other projections.
#define GUSSET_FIELD_PROJECTION 10
/// Onto the plane through values[0..2] with the normal values[3..5], along the direction values[6..8].
#define GUSSET_FIELD_PARALLEL 11
/// Onto the plane through values[3..5] with the normal values[6..8], along the lines through the eye values[0..2]. Not
/// defined level with the eye.
#define GUSSET_FIELD_PERSPECTIVE 12
/// Rolls space up to a cone about `axis`: of the two axes that follow, the first becomes the arc of the circle of the
/// radius r = values[0] > 0 and the second the height above the cone; the axis itself, w, becomes the length along the
/// generators, which lean towards the axis by values[1], from -pi / 2 to pi / 2: the apex is at w = r / sin(values[1]).
/// In part, t: leaning by t values[1] and rolled to the curvature t / r; generators keep their lengths, and the circle
/// at w becomes 1 - (t / r) w sin(t values[1]) times as long.
#define GUSSET_FIELD_CONE_WRAP 13
/// Rolls space up to a sphere about `axis` of the radius r = values[0] > 0: of the two axes that follow, the first,
/// from 0 to 2 pi r, goes round the equator, and the second, from -pi / 2 r to pi / 2 r, along the meridians; the axis
/// itself becomes the height above the sphere. In part, t: up to 1/2 the sheet rolls to a tube, to the curvature 2 t /
/// r, and keeps all its lengths; then the meridians bend to the curvature q / r, q = 2 t - 1, and keep their lengths,
/// and the parallel at v becomes 1 - (1 - cos(q v / r)) / q times as long.
#define GUSSET_FIELD_SPHERE_WRAP 14

/// How a strength goes from one key to the next.
typedef uint32_t gusset_easing;
/// Evenly.
#define GUSSET_EASING_LINEAR 0
/// Starting and ending at rest.
#define GUSSET_EASING_SMOOTH 1
/// Stays until it jumps.
#define GUSSET_EASING_HOLD 2

/// A field of deformation: a map of space, of which a part is done.
typedef struct gusset_field {
    size_t struct_size;
    gusset_field_kind kind;
    /// For kinds that have one; else 0.
    gusset_axis axis;
    /// For GUSSET_FIELD_SHEAR; else 0.
    gusset_axis other_axis;
    /// Between keys; one of GUSSET_EASING_...
    gusset_easing easing;
    /// How much of the map is done: 0 nothing at all, 1 all of it. With keys, it multiplies what they say.
    double strength;
    /// What the kind says; the rest is not read.
    double values[16];
    /// Pairs of time and strength, times increasing; before the first and after the last time the strength is that
    /// there. NULL: the strength does not depend on the time.
    const double *keys;
    /// The number of pairs.
    size_t key_count;
    /// For GUSSET_FIELD_LATTICE, three numbers for each control point; else NULL.
    const double *offsets;
    /// For GUSSET_FIELD_LATTICE; else 0.
    uint32_t counts[3];
    uint32_t reserved;
} gusset_field;

/// Moves all nodes of a net by fields, the first one first, in one pass over the memory: shaping, animation and
/// projection. The fields work in double; the result is rounded once. Fields of strength 0 do nothing at all, to the
/// bit. Nodes that are glued and have equal bits keep them equal; missing nodes stay missing. Fields that are defined
/// everywhere are not watched for overflow: a node that they make too large for its type is infinite then, and missing.
/// Whatever the error, no node is moved.
/// @param fields `count` of them.
/// @param count see fields.
/// @param time for fields with keys; a net is deformed from what it is now, so that animations deform a copy of the net
///     at rest.
/// @errors UNKNOWN_VALUE (kind, axis, easing), OUT_OF_RANGE (a value, strength or time), FIELD_UNDEFINED (with the
///     node)
/// @complexity O(nodes x fields), twice that if a field is not defined everywhere.
/// @threads The same bits for any number of threads.
/// @source Deryagin, "Spatial operations"; Barr 1984; Sederberg and Parry 1986.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_deform(const struct gusset_context *context, struct gusset_net *net,
    const struct gusset_field *fields, size_t count, double time);

/// Moves every node of a net along its normal by `distance`, which may be negative; glued nodes stay together, nodes
/// without a normal stay.
/// @param distance a length of either sign, finite.
/// @errors OUT_OF_RANGE (distance)
/// @complexity O(nodes), and as much memory as the coordinates take.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_displace(const struct gusset_context *context,
    struct gusset_net *net, double distance);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Bridges: Joins nets to one, and takes them apart again. */

/// What is done with the cells between two nets that were joined.
typedef uint32_t gusset_bridge_mode;
/// They are cells like others.
#define GUSSET_BRIDGE_KEEP 0
/// They are not there.
#define GUSSET_BRIDGE_HIDE 1
/// The two sides coincide, to a tolerance, and are one: the links between them are contracted. Nodes stay where they
/// are; where they coincide not quite, `snap` of gusset_glue_options makes them equal.
#define GUSSET_BRIDGE_WELD 2

/// What a bridge looks like.
typedef uint32_t gusset_bridge_kind;
/// A band between open sides.
#define GUSSET_BRIDGE_RIBBON 0
/// A band between closed sides, which is closed itself.
#define GUSSET_BRIDGE_TUBE 1
/// One edge between sides that are a point each.
#define GUSSET_BRIDGE_THREAD 2

/// The physical properties of a bridge, under which gusset_net_settle finds its equilibrium. Units: of length that of
/// the coordinates, of force any one that all have.
typedef struct gusset_bridge_properties {
    /// At least 0: the force in each line of links across a thread or a ribbon, and the force per length in the film of
    /// a tube.
    double tension;
    /// At least 0: the force that doubles the length of a line of links across.
    double elasticity;
    /// At least 0, against bending: force times squared length, for each line of links across; infinity: rigid.
    double stiffness;
    /// The host's own.
    uint64_t user;
} gusset_bridge_properties;

/// How nets are joined. All zeros: each right of the one before, the smaller ones enlarged uniformly, bridges kept.
typedef struct gusset_concatenate_options {
    size_t struct_size;
    /// How far nodes that are welded may be apart, at least 0, in the unit of the coordinates.
    double tolerance;
    /// Given to every new bridge.
    struct gusset_bridge_properties properties;
    /// Where each net lies from the one before.
    gusset_direction direction;
    /// GUSSET_BRIDGE_KEEP, GUSSET_BRIDGE_HIDE or GUSSET_BRIDGE_WELD.
    gusset_bridge_mode mode;
    /// How nets with fewer nodes along the side are enlarged.
    gusset_replication equalise;
    /// Read for GUSSET_REPLICATE_AT: the row or column.
    /// @when equalise GUSSET_REPLICATE_AT
    uint32_t equalise_index;
    /// Each net but the first is turned by so many places along its side, which is closed then.
    uint32_t twist;
    /// 1: nets whose faces are taken the other way round than those of the first are flipped along the side; 0:
    /// refused.
    /// @flag
    uint32_t turn;
    /// How many rows or columns of nodes of its own each new bridge has, evenly on straight lines between the two
    /// sides; 0 for GUSSET_BRIDGE_WELD.
    uint32_t rows;
    uint32_t reserved;
} gusset_concatenate_options;

/// A bridge of a net.
typedef struct gusset_bridge {
    size_t struct_size;
    /// What the host gave it.
    struct gusset_bridge_properties properties;
    /// Where the second net lies.
    gusset_direction direction;
    /// The first column (RIGHT) or row (DOWN) of the second net.
    uint32_t at;
    /// The first node along the side: a row (RIGHT) or column (DOWN).
    uint32_t start;
    /// One past the last one.
    uint32_t end;
    /// GUSSET_BRIDGE_RIBBON, GUSSET_BRIDGE_TUBE or GUSSET_BRIDGE_THREAD.
    gusset_bridge_kind kind;
    /// GUSSET_BRIDGE_KEEP, GUSSET_BRIDGE_HIDE or GUSSET_BRIDGE_WELD.
    gusset_bridge_mode mode;
    /// The rows (DOWN) or columns of its own, which lie before `at`: the side of the first net is at - rows - 1.
    uint32_t rows;
    uint32_t reserved;
} gusset_bridge;

/// Joins nets side by side to one, in one pass. Each net keeps what it is glued to: links that led back across the
/// direction become seams. Its bridges are kept; each net but the first gets a new one, between it and the one before,
/// behind its own. All can be undone: see gusset_net_split_create.
/// @param nets net_count handles, at least one, of one scalar type; the same one may come several times.
/// @param net_count see nets.
/// @errors EMPTY_SCENE (no nets), MIXED_SCALARS, ORIENTATION_CONFLICT (see turn), SIDES_DIFFER (sizes that are not to
///     be equalised; or sides to be welded that are apart: the report has the place and the distance), OUT_OF_RANGE
///     (tolerance; a twist of an open side; rows of bridges that are to be welded), CROSSING_CELL, TOO_LARGE
/// @complexity O(nodes of the result); memory for it, and once more for nets that are enlarged, turned or flipped.
/// @source Deryagin, "Concatenation".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_concatenate_create(const struct gusset_context *context,
    const struct gusset_net *const *nets, size_t net_count, const struct gusset_concatenate_options *options,
    struct gusset_net **joined);

/// Takes a net apart at a bridge that runs from side to side: the two nets come back bit for bit as they were joined,
/// unless they were changed since; copies that were made to equalise sizes, and the rows of the bridge, are removed. Of
/// a net that was joined of joined ones, the last bridge is such a one; take nets apart in the reverse order of
/// joining. What is glued across the bridge is cut.
/// @param bridge its number, counted from 0.
/// @param second receives the other, likewise.
/// @errors OVERLAP (first and second are the same place), NO_SUCH_ELEMENT (no such bridge, or it is within a part of
///     the net only), CROSSING_CELL
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_split_create(const struct gusset_context *context,
    const struct gusset_net *net, size_t bridge, struct gusset_net **first, struct gusset_net **second);

/// A bridge of a net.
/// @param index its number, below bridge_count of gusset_net_gluing_report.
/// @param bridge its struct_size set.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_get_bridge(const struct gusset_net *net, size_t index,
    struct gusset_bridge *bridge);

/// Does something else with the cells of a bridge, and gives it other properties. A bridge that has rows of its own
/// cannot be welded: OUT_OF_RANGE.
/// @param index of the bridge, below bridge_count of gusset_net_gluing_report.
/// @param mode GUSSET_BRIDGE_KEEP, GUSSET_BRIDGE_HIDE or GUSSET_BRIDGE_WELD.
/// @param tolerance how far nodes that are welded may be apart, at least 0.
/// @param properties NULL leaves them.
/// @errors NO_SUCH_ELEMENT, OUT_OF_RANGE, SIDES_DIFFER (with the place and the distance), CROSSING_CELL (the net is
///     then as it was)
/// @complexity O(nodes) if welding begins or ends, or if the net is shared with a copy or a scene; else O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_set_bridge(const struct gusset_context *context,
    struct gusset_net *net, size_t index, gusset_bridge_mode mode, double tolerance,
    const struct gusset_bridge_properties *properties);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Measures of nets: Area, volume, moments, planarity. */

/// The parts of gusset_net_measure_report that are computed: a sum of these.
/// @bits
typedef uint32_t gusset_net_measures;
/// area, volume, area_vector, low and high.
#define GUSSET_NET_MEASURES_EXTENT 1
/// bilinear_area and bilinear_error; about ten times the work.
#define GUSSET_NET_MEASURES_BILINEAR 2
/// body_volume, centroid and inertia; about ten times the work.
#define GUSSET_NET_MEASURES_BODY 4

/// The measures of a net; 0 for those that are not asked for.
typedef struct gusset_net_measure_report {
    size_t struct_size;
    /// The area of all cells: of each, |(c - a) x (d - b)| / 2, which is exact for plane ones; for others see
    /// bilinear_area.
    double area;
    /// What the net encloses, if it is closed and has two sides; positive if the normals look outwards. For open ones:
    /// of the cone to the first node.
    double volume;
    /// The sum of the cells' area vectors; 0 for closed nets.
    double area_vector[3];
    /// The smallest coordinates of the nodes that are there; infinite if there are none.
    double low[3];
    /// The largest.
    double high[3];
    /// The area of the bilinear patches of all cells, to rounding: on cells that are not plane more than `area`. A
    /// patch that is folded over itself counts with all its sheets.
    double bilinear_area;
    /// A bound of the error of bilinear_area.
    double bilinear_error;
    /// The volume of the body, of density 1, that a closed net encloses; negative if the normals look inwards.
    double body_volume;
    /// The centre of mass of the body; NaN if its volume is 0.
    double centroid[3];
    /// The tensor of inertia of the body about its centroid, row after row: on the diagonal the integrals of y^2 + z^2
    /// and so on, beside it those of -x y and so on.
    double inertia[9];
} gusset_net_measure_report;

/// How plane the cells of a net are.
typedef struct gusset_net_planarity_report {
    size_t struct_size;
    /// The largest distance of corners from the plane between them, as a part of the longer diagonal; 0 if there are no
    /// cells.
    double worst;
    /// Its cell; 2^64 - 1 if there are no cells.
    uint64_t worst_cell;
    /// The mean; NaN if there are no cells.
    double mean;
    /// How many cells are above the tolerance.
    uint64_t above;
} gusset_net_planarity_report;

/// Measures a net: areas, volumes, box, centroid, inertia. Cells that touch a missing node or belong to a hidden bridge
/// are not there. Volumes, centroid and inertia are exact but for rounding for the bilinear patches of the cells
/// (divergence theorem). Where squares or cubes of coordinates overflow, beyond about 1e77, results are infinite or
/// NaN.
/// @param measures only these are computed.
/// @param report its struct_size set.
/// @errors UNKNOWN_VALUE (measures)
/// @complexity O(nodes), no memory.
/// @threads From any thread; the same bits for any number of threads.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_measure(const struct gusset_context *context,
    const struct gusset_net *net, gusset_net_measures measures, struct gusset_net_measure_report *report);

/// Tells how plane the cells of a net are: whether it can be clad with plane quads.
/// @param tolerance at least 0, for the count in the report.
/// @param cells a buffer for (rows - 1) * (columns - 1) numbers: of each cell, how far its corners are from the plane
///     that lies evenly between them, as a part of its longer diagonal; 0 for triangles and less, NaN for cells that
///     are not there.
/// @param capacity its size; NULL and 0 if it is not wanted.
/// @param written receives the number of cells.
/// @param report its struct_size set.
/// @errors BUFFER_TOO_SMALL, OUT_OF_RANGE (tolerance)
/// @complexity O(nodes), 8 bytes a cell.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_planarity(const struct gusset_context *context,
    const struct gusset_net *net, double tolerance, double *cells, size_t capacity, size_t *written,
    struct gusset_net_planarity_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Meshes and heights: Nets to meshes and back, and nets of height fields. */

/// What the faces of the mesh of a net are.
typedef uint32_t gusset_net_faces;
/// Quads, and triangles where a side of a cell is one point.
#define GUSSET_NET_QUADS 0
/// Triangles: quads are cut along the shorter diagonal, or where that would be an edge that there is already, the other
/// one.
#define GUSSET_NET_TRIANGLES_SHORTER 1
/// Triangles: quads are cut from (i, j) to (i + 1, j + 1), with the same exception.
#define GUSSET_NET_TRIANGLES_FIXED 2

/// How a net becomes a mesh. All zeros: quads, one vertex for each class of glued nodes, only vertices that something
/// uses.
typedef struct gusset_net_mesh_options {
    size_t struct_size;
    /// GUSSET_NET_QUADS, GUSSET_NET_TRIANGLES_SHORTER or GUSSET_NET_TRIANGLES_FIXED.
    gusset_net_faces faces;
    /// 1: a vertex for each node, and nothing is glued. 0 or 1.
    /// @flag
    uint32_t no_weld;
    /// 1: finite vertices that nothing uses are kept. 0 or 1.
    /// @flag
    uint32_t keep_unused;
    /// 1: a cell of which just one corner is missing becomes a triangle. 0 or 1.
    /// @flag
    uint32_t fill_corners;
    /// 1: texture coordinates are wanted. 0 or 1.
    /// @flag
    uint32_t texture;
    uint32_t reserved;
    /// Faces with an edge of more than so many times the median length of edges are left out: in a range image those
    /// that lead from one surface to another behind it, for which 4 is a good value. Above 0; 0 for no limit.
    double max_edge_ratio;
} gusset_net_mesh_options;

/// What became what when a net became a mesh. Pointers are valid until the result is destroyed.
typedef struct gusset_net_mesh_report {
    size_t struct_size;
    /// For each node its vertex, or UINT32_MAX.
    struct gusset_indices vertex_of_node;
    /// For each vertex the first of its nodes.
    struct gusset_indices node_of_vertex;
    /// For each face its cell: cell (i, j) is i * (columns - 1) + j.
    struct gusset_indices cell_of_face;
    /// Edges without faces, two vertices each: threads, and whatever else is left of cells whose opposite sides are
    /// glued.
    struct gusset_indices wires;
    /// For each corner of the mesh its pair of texture coordinates; empty unless they were asked for.
    struct gusset_indices texture_corners;
    /// Pairs u, v from 0 to 1: column and row. A vertex on a seam has one on each side of it.
    const double *texture_coordinates;
    /// The number of pairs.
    size_t texture_count;
} gusset_net_mesh_report;

/// Heights over a grid, at any alignment.
typedef struct gusset_heights {
    size_t struct_size;
    /// The number of rows, at least 2.
    size_t rows;
    /// The number of columns, at least 2.
    size_t columns;
    /// Number (i, j) is at values + i * row_stride + j times the scalar's size. Any numbers: NaN and infinities are
    /// missing.
    const void *values;
    /// Bytes from row to row; 0 for rows without gaps.
    size_t row_stride;
    /// x from column to column and y from row to row; finite and not 0, negative where rows run against y.
    double spacing[2];
    /// Where the first node is if its height is 0.
    double origin[3];
    /// Read if has_no_data is 1: the number that stands for a missing height.
    double no_data;
    /// 0 or 1.
    uint32_t has_no_data;
    /// GUSSET_F32 or GUSSET_F64: of the values, and of the net.
    gusset_scalar scalar;
} gusset_heights;

/// The cells of a net that is sought in a mesh.
typedef uint32_t gusset_grid_cells;
/// Quads, with triangles at poles.
#define GUSSET_GRID_QUADS 0
/// Triangles only, two for each cell.
#define GUSSET_GRID_TRIANGLES 1

/// How a net is found in a mesh; all zero is the default.
typedef struct gusset_net_grid_options {
    size_t struct_size;
    gusset_grid_cells cells;
    /// 1: only the component of one face is a grid; 0: the mesh must be one grid. Read for GUSSET_GRID_QUADS.
    /// @when cells GUSSET_GRID_QUADS
    /// @flag
    uint32_t has_face;
    /// Read if has_face is 1: a face of the component.
    /// @when has_face 1
    /// @flag
    uint32_t face;
    uint32_t reserved;
} gusset_net_grid_options;

/// Where a net was found in a mesh. Pointers are valid until the grid is destroyed.
typedef struct gusset_net_grid_view {
    size_t struct_size;
    /// For each node its vertex.
    struct gusset_indices vertex_of_node;
    /// For each cell its face.
    struct gusset_indices face_of_cell;
} gusset_net_grid_view;

/// The places of a net in the mesh that it was found in. Opaque and immutable; it keeps nothing of the mesh.
typedef struct gusset_net_grid gusset_net_grid;

/// Makes the mesh of a net. Cells with a missing corner and those of hidden bridges are left out; glued corners are
/// one, so that closed nets become closed meshes; faces are counter-clockwise as the net's are. A mesh without faces is
/// no failure. The grid of a range image becomes the mesh of what was seen by triangles, fill_corners and
/// max_edge_ratio.
/// @errors OUT_OF_RANGE, TOO_LARGE (2^32 - 1 corners and more)
/// @complexity O(nodes), and O(w log w) for w cells whose opposite sides are glued.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_to_mesh(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_net_mesh_options *options, struct gusset_result **result);

/// Lends the maps between the net and its mesh, for results of gusset_net_to_mesh.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_net_mesh(const struct gusset_result *result,
    struct gusset_net_mesh_report *report);

/// Makes the net of heights over a grid: x = origin + j spacing, y = origin + i spacing, z = origin + height. Missing
/// heights become missing nodes; faces are counter-clockwise from above, whichever way rows and columns run.
/// @param heights the heights.
/// @errors NET_TOO_SMALL, TOO_LARGE, BAD_STRIDE, OUT_OF_RANGE (spacing, origin)
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_from_heights_create(const struct gusset_context *context,
    const struct gusset_heights *heights, struct gusset_net **net);

/// Finds rows and columns in a mesh, and makes the net of its vertices. Quads form a rectangle, which may be closed
/// round, with fans of triangles round a pole at its first and last row, or either. Rows run as the first quad says,
/// and round if only one direction is closed. With GUSSET_GRID_TRIANGLES each quad is cut in two along either diagonal.
/// Vertices and their bits are kept. For each cell the grid lends the first of its two triangles. Where several
/// pairings of the triangles make a grid, as if all diagonals run one way, the same mesh always gives the same one. On
/// a torus that pairing may close with a shift, so that rows and columns differ from those it was made from. Tubes and
/// tori whose diagonals run without any rule may be refused, and so are fans of fewer than six triangles at the pole of
/// an open sheet; at least one row of quads is needed.
/// @param mesh see gusset_mesh_view.
/// @param options NULL for the defaults: quads, and the whole mesh is one grid.
/// @param grid receives where the net was found, for gusset_net_grid_destroy; NULL on failure. May be NULL.
/// @errors NO_GRID (with a face that shows it)
/// @complexity O(H log d) for H half-edges and vertices of degree d; for closed nets of triangles whose poles do not
///     show by their degrees some attempts of that.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_from_mesh_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_net_grid_options *options, struct gusset_net_grid **grid,
    struct gusset_net **net);

/// Destroys a grid; NULL is allowed.
GUSSET_API void gusset_net_grid_destroy(struct gusset_net_grid *grid);

/// Lends where the net was found.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_grid_get_view(const struct gusset_net_grid *grid,
    struct gusset_net_grid_view *view);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Morphs: Nets between two nets. */

/// The way of nodes from one net to another.
typedef uint32_t gusset_morph_path;
/// Straight.
#define GUSSET_MORPH_LINEAR 0
/// The rotation that fits best is done evenly; the rest goes straight in the frame that turns, so that a net moved
/// rigidly keeps its shape on the way.
#define GUSSET_MORPH_RIGID 1

/// Makes the net at a time on the way from one net to another of the same rows, columns, type and gluing. Two nodes
/// that have the same bits as each other in both nets, as glued ones have, have the same bits as each other in it. It
/// is glued as the first, and has its bridges; a node missing in one of them is missing between.
/// @param t the time, from 0 for the bits of the first to 1 for those of the second.
/// @errors UNKNOWN_VALUE (path), OUT_OF_RANGE (t), SIDES_DIFFER (other rows or columns: see gusset_net_copy_options),
///     MIXED_SCALARS, GLUINGS_DIFFER (with the node), ORIENTATION_CONFLICT (one is reversed)
/// @complexity O(nodes).
/// @source Horn 1987, for the rotation.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_morph_create(const struct gusset_context *context,
    const struct gusset_net *first, const struct gusset_net *second, double t, gusset_morph_path path,
    struct gusset_net **between);

/* ------------------------------------------------------------------------------------------------------------------ */
/* The handle of a net: Opaque; nets are the handles that functions change. */

/// A net: H x W nodes in three coordinate matrices, and what is glued to what. Functions that take it as const may run
/// at the same time in many threads; those that change it need it for themselves.
typedef struct gusset_net gusset_net;

/* ------------------------------------------------------------------------------------------------------------------ */
/* Normals: Unit normals, exact at poles and seams. */

/// Computes the unit normal of every node of a net. Columns go with the fingers of the right hand towards rows, and the
/// normal with the thumb; the other way for nets that are reversed. Nodes that are glued get the same bits, poles and
/// seams their true normals; at rims, beside missing nodes and beside hidden bridges the cells that are there decide.
/// @param x receives the first coordinates of the normals, float or double as the net's are, rows x columns numbers,
///     row after row without gaps, aligned; the three buffers are apart from each other and from the net's own.
/// @param y receives the second ones.
/// @param z receives the third ones.
/// @param capacity the numbers that each has room for.
/// @param missing_count receives the number of nodes that have no normal and get zeros: missing ones, and those whose
///     cells have no area or cancel out; may be NULL.
/// @errors BUFFER_TOO_SMALL, OVERLAP, CANCELLED (the buffers are filled in part)
/// @complexity O(nodes); a bit a node, and memory for the glued nodes.
/// @threads From any thread; the same bits for any number of threads.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_normals(const struct gusset_context *context,
    const struct gusset_net *net, void *x, void *y, void *z, size_t capacity, uint64_t *missing_count);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Planar cells: Moves nodes as little as possible until cells are planar. */

/// How gusset_net_planarise works. All zeros: the defaults.
typedef struct gusset_planarise_options {
    size_t struct_size;
    /// The distance of corners from their plane that is plane enough, as a part of the diagonal of the net's box; 0:
    /// 1e-10, or 4e-7 for coordinates of float.
    double tolerance;
    /// A byte for each node, 1 for one that stays with those glued to it and 0 for others; NULL: all may move.
    const uint8_t *fixed;
    /// The number of bytes: rows * columns; 0 with NULL.
    size_t fixed_count;
    /// The largest number of steps; 0: 100.
    uint32_t max_iterations;
    /// 1: vertices on the boundary of the surface stay.
    /// @flag
    uint32_t keep_boundary;
} gusset_planarise_options;

/// What gusset_net_planarise has done.
typedef struct gusset_planarise_report {
    size_t struct_size;
    /// The diagonal of the net's box, before.
    double size;
    /// The distance that is plane enough: the tolerance times the size.
    double tolerance;
    /// The largest distance of the corners of a cell from the plane that lies evenly between them, before.
    double deviation_before;
    /// The same of the net as it is now.
    double deviation_after;
    /// The largest displacement of a point.
    double max_displacement;
    /// The root of the mean square of the displacements of all points of cells of four corners.
    double rms_displacement;
    /// The cell of deviation_after; 2^64 - 1 without cells of four corners.
    uint64_t worst_cell;
    /// The steps that were taken; 0 if all cells were plane, and then no bit has changed.
    uint32_t iterations;
    /// 1 if deviation_after is within the tolerance; else 0, and the net is as near as the steps came.
    uint32_t converged;
} gusset_planarise_report;

/// Moves the nodes of a net as little as possible, in the sum of squares, so that all cells are plane: facing by plane
/// tiles. Glued nodes stay one point. Cells of three corners and less, hidden ones and those with missing nodes do not
/// count. The result is a local least: no plane net near it is nearer to the given one, but for the accuracy of the
/// steps.
/// @param report receives what was done, its struct_size set; that the steps did not converge is no error.
/// @errors OUT_OF_RANGE (tolerance), UNKNOWN_VALUE (keep_boundary, a byte of fixed), SIZE_OVERFLOW (fixed_count is too
///     small, the net is then unchanged)
/// @complexity For each step O(n^1.5) operations and O(n log n) memory for n cells.
/// @threads One thread; the same bits always.
/// @source Deryagin, "Closures"; Liu et al. 2006.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_planarise(const struct gusset_context *context,
    struct gusset_net *net, const struct gusset_planarise_options *options, struct gusset_planarise_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Shapes: Spheres, cylinders, boxes, tori, one-sided surfaces and others. */

/// A shape.
typedef uint32_t gusset_net_shape;
/// A rectangle in the plane z = 0: size[0], size[1].
#define GUSSET_NET_PLANE 0
/// A sphere with two poles: radius. At least 3 rows and 4 columns.
#define GUSSET_NET_SPHERE 1
/// A sphere that is a disc whose rim is drawn together: radius. At least 3 rows and columns.
#define GUSSET_NET_ONE_POLE_SPHERE 2
/// A cylinder without caps: radius, height. At least 4 columns.
#define GUSSET_NET_TUBE 3
/// A cylinder with caps: radius, height. At least 4 rows and columns.
#define GUSSET_NET_CYLINDER 4
/// A prism over a regular polygon: sides, radius (of the circle through its corners), height. At least 4 rows, and a
/// column more than sides.
#define GUSSET_NET_PRISM 5
/// A cone with its base: radius, height. At least 3 rows and 4 columns.
#define GUSSET_NET_CONE 6
/// A pyramid over a regular polygon: sides, radius, height. At least 3 rows, and a column more than sides.
#define GUSSET_NET_PYRAMID 7
/// A profile turned round the z axis: profile, profile_count. At least 4 columns; each point is a row.
#define GUSSET_NET_LATHE 8
/// A torus: radius, minor_radius (of the tube, the smaller). At least 4 rows and columns.
#define GUSSET_NET_TORUS 9
/// A box: size, cells, box_kind. Rows and columns are as the cells say.
#define GUSSET_NET_BOX 10
/// A Moebius strip: radius (of its middle line), size[0] (its width). At least 4 columns.
#define GUSSET_NET_MOEBIUS 11
/// A Klein bottle, a tube with a figure-eight section that makes half a turn: radius, minor_radius. At least 4 rows and
/// columns.
#define GUSSET_NET_KLEIN 12
/// A projective plane, Boy's surface: radius (a scale). At least 4 rows and columns.
#define GUSSET_NET_PROJECTIVE_PLANE 13
/// Two sheets joined along their rim: size[0], size[1], height (their distance in the middle). At least 3 rows, and 5,
/// 7, ... columns.
#define GUSSET_NET_PILLOW 14

/// How the two caps of a box are covered.
typedef uint32_t gusset_box_kind;
/// Two rims of the cap sweep over it to a slit, which is zipped up. All faces are unit quads, and no seams are needed.
#define GUSSET_NET_BOX_SLIT 0
/// The paper's crosswise unwrapping. All faces are unit quads; two seams.
#define GUSSET_NET_BOX_CROSS 1
/// Concentric rings: fewest nodes, and triangles along the diagonals of the caps.
#define GUSSET_NET_BOX_CONCENTRIC 2

/// A net that is wanted. Measures that the shape does not name are not read.
typedef struct gusset_net_primitive {
    size_t struct_size;
    /// One of GUSSET_NET_PLANE to GUSSET_NET_PILLOW.
    gusset_net_shape shape;
    gusset_scalar scalar;
    /// Rows of nodes; 0 for 33. Not read for boxes and lathes.
    size_t rows;
    /// Columns of nodes; 0 for 65. Not read for boxes.
    size_t columns;
    /// See the shapes; above 0, in the unit of the coordinates.
    double radius;
    /// See the shapes; above 0.
    double minor_radius;
    /// See the shapes; above 0, along z.
    double height;
    /// See the shapes; above 0, along x, y and z.
    double size[3];
    /// Distance from the axis, at least 0, and height of each point, from below to above, at any alignment. A row on
    /// the axis is a pole; a profile that ends where it begins makes a ring.
    const double *profile;
    /// The number of points, twice as many numbers; at least 2.
    size_t profile_count;
    /// Lateral faces of a prism or pyramid, at least 3.
    uint32_t sides;
    gusset_box_kind box_kind;
    /// Cells of a box along x, y and z, at least 1 each.
    uint32_t cells[3];
    uint32_t reserved;
} gusset_net_primitive;

/// Makes a net of a standard shape, centred at the origin, its axis along z. Nodes that are one point have the same
/// bits; closed surfaces have their faces counter-clockwise seen from outside.
/// @param primitive what is wanted.
/// @errors OUT_OF_RANGE (a measure that is not positive or beyond the scalar type, too few rows, columns, sides or
///     cells), TOO_LARGE
/// @complexity O(nodes); 12 or 24 bytes a node, and 1/4 for boxes.
/// @source Deryagin, "Closures of nets".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_primitive_create(const struct gusset_context *context,
    const struct gusset_net_primitive *primitive, struct gusset_net **net);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Resolutions: Resampled and decimated nets, and levels of detail. */

/// How positions between nodes are found.
typedef uint32_t gusset_interpolation;
/// On cubic splines after Catmull and Rom, which pass through all nodes with one tangent, across seams too.
#define GUSSET_INTERPOLATION_BICUBIC 0
/// On the bilinear patches of the cells.
#define GUSSET_INTERPOLATION_BILINEAR 1

/// No pyramid has more levels.
#define GUSSET_PYRAMID_LEVELS 32

/// Makes a net of `rows` x `columns` nodes that are spread evenly over the rows and columns of another; first and last
/// ones stay, and new nodes that fall on old ones have their bits.
/// @param net glued along whole sides only, without bridges; the new one is glued in the same way, glued nodes have
///     equal bits.
/// @param rows of the result, at least 2.
/// @param columns of the result, at least 2.
/// @errors NET_TOO_SMALL, TOO_LARGE, GLUED_INSIDE
/// @complexity O(nodes of both).
/// @threads From any thread; the same bits for any number of threads.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_resample_create(const struct gusset_context *context,
    const struct gusset_net *net, size_t rows, size_t columns, gusset_interpolation interpolation,
    struct gusset_net **resampled);

/// Makes a net of the rows and columns of another that matter most: rows, and then columns, are left out, always the
/// one whose loss costs least, as long as the tolerance allows.
/// @param net glued along whole sides only, without bridges.
/// @param tolerance at least 0, may be infinite; nodes are at most half of it away from the segments that replace their
///     columns, and as much from those that replace their rows.
/// @param rows receive the indices of what was kept, as many as the new net has; each has room for as many as the old
///     net has; NULL if not wanted.
/// @param columns see rows.
/// @param deviation receives what was reached; may be NULL.
/// @errors OUT_OF_RANGE, GLUED_INSIDE
/// @complexity About O(nodes x log rows).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_decimate_create(const struct gusset_context *context,
    const struct gusset_net *net, double tolerance, uint32_t *rows, uint32_t *columns, double *deviation,
    struct gusset_net **decimated);

/// Makes nets of 2^k + 1 rows and columns, for levels of detail: the finest first, each of the others every second row
/// and column of the one before, bit for bit.
/// @param net glued along whole sides only, without bridges; if its sizes are 2^k + 1 already, the first level is a
///     copy, else it is resampled to the next sizes.
/// @param interpolation as for gusset_net_resample_create.
/// @param levels receives the nets, each for gusset_net_destroy; all NULL on failure.
/// @param capacity how many it has room for; GUSSET_PYRAMID_LEVELS is always enough.
/// @param count receives how many there are, also with BUFFER_TOO_SMALL, which capacity 0 gives too.
/// @errors BUFFER_TOO_SMALL, TOO_LARGE, GLUED_INSIDE
/// @complexity O(nodes), memory for 4/3 of the first.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_pyramid_create(const struct gusset_context *context,
    const struct gusset_net *net, gusset_interpolation interpolation, struct gusset_net **levels, size_t capacity,
    size_t *count);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Bridges at rest: Settles bridges under tension, elasticity and stiffness. */

/// How gusset_net_settle works. All zeros: the defaults.
typedef struct gusset_settle_options {
    size_t struct_size;
    /// The displacement below which a step is the last, as a part of the diagonal of the net's box; 0: 1e-12.
    double tolerance;
    /// Rest lengths as a multiple of those in the reference, above 0; 0: 1.
    double rest_ratio;
    /// The net at rest, of the same size, which gives rest lengths and the shape of rigid bridges; NULL: the net as it
    /// is given.
    const struct gusset_net *reference;
    /// A byte for each part, the nets between the bridges that run from side to side, in their order: 1 for one that
    /// moves, as a rigid body, and 0 for one that is held; NULL: all are held.
    const uint8_t *free;
    /// The number of bytes: bridges + 1 at least; 0 with NULL.
    size_t free_count;
    /// The largest number of steps; 0: 1000.
    uint32_t max_iterations;
    uint32_t reserved;
} gusset_settle_options;

/// What gusset_net_settle has done. Energies are force times length, in the units of the properties and the
/// coordinates.
typedef struct gusset_settle_report {
    size_t struct_size;
    /// The energy before, rigid bridges in their shape.
    double energy_before;
    /// The energy of tension now.
    double tension_energy;
    /// The energy of springs now.
    double elastic_energy;
    /// The energy of bending now.
    double bending_energy;
    /// The largest force on an inner point or a free body now.
    double residual_force;
    /// The largest displacement of a point.
    double max_displacement;
    /// The steps that were taken.
    uint32_t iterations;
    /// The bridges from side to side that have a force.
    uint32_t settled;
    /// Those without: hidden or welded ones, and those whose properties are all 0; their nodes stay.
    uint32_t idle;
    /// The films that have collapsed: to less than a millionth of their area in places.
    uint32_t collapsed;
    /// 1 if the last step was within the tolerance, or too small to lower the energy, and no film has collapsed; else
    /// 0, and the net is as near as the steps came.
    uint32_t converged;
    uint32_t reserved;
} gusset_settle_report;

/// Moves the nodes of bridges that are their own, and parts that are free, to the equilibrium of the bridges'
/// properties. The sum of these energies becomes least, for each line of links across a bridge: tension times its
/// length, its nodes becoming evenly spaced, or in a tube times the area of the film; elasticity / 2 (l - r)^2 / r for
/// each link of length l and rest length r; stiffness / 2 h^3 times the squared second differences, h being the mean
/// rest length, lines leaving parts in the direction of these. A bridge of infinite stiffness and both its sides are
/// one body. Bridges within a part do not count, nor do those across the direction of the last. If of parts that
/// bridges join none is held, the first is. What is found is a local minimum, and the energy never grows on the way.
/// @param report receives what was done, its struct_size set; that the steps did not converge is no error.
/// @errors UNKNOWN_VALUE (a byte of free), SIZE_OVERFLOW (free_count is too small), SIDES_DIFFER (the reference has
///     another size), OUT_OF_RANGE (tolerance, rest_ratio; a property that is negative, NaN or infinite, with the
///     bridge), NO_SUCH_ELEMENT (a bridge lies within another, the net is then unchanged)
/// @complexity For each step O(n^1.5) operations and O(n log n) memory for n inner nodes, and O(nodes).
/// @threads One thread; the same bits always.
/// @source Deryagin, "Concatenation"; Schek 1974; Pinkall and Polthier 1993.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_settle(const struct gusset_context *context, struct gusset_net *net,
    const struct gusset_settle_options *options, struct gusset_settle_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Validation: Whether coordinates agree with the gluing. */

/// What is found.
typedef uint32_t gusset_net_finding_kind;
/// A violation: the ends of contracted link `element` are apart, or one of them is missing.
#define GUSSET_NET_FINDING_LINK_APART 0
/// A violation: two nodes that seam `element` glues are apart, or one of them is missing.
#define GUSSET_NET_FINDING_SEAM_APART 1
/// A warning: the ends of link `element`, between neighbours, are one point by way of others, and it is not contracted
/// itself: see `saturate` of gusset_glue_options.
#define GUSSET_NET_FINDING_LOOP 2
/// A warning: the ends of link `element` lie on each other and are not glued.
#define GUSSET_NET_FINDING_ZERO_LENGTH 3
/// A warning: link `element` closes a row or column of fewer than four nodes, which has no inside then.
#define GUSSET_NET_FINDING_FEW_NODES 4

/// One finding.
typedef struct gusset_net_finding {
    gusset_net_finding_kind kind;
    /// The link, or the number of the seam.
    uint32_t element;
    /// The two nodes.
    uint32_t nodes[2];
    /// How far they are apart; NaN if one is missing.
    double distance;
} gusset_net_finding;

/// What a validation found. Opaque and immutable; it keeps nothing of the net.
typedef struct gusset_net_validation gusset_net_validation;

/// All findings: violations first, then warnings, each kind in the order of its elements.
typedef struct gusset_net_validation_view {
    size_t struct_size;
    /// The findings, valid until the validation is destroyed; NULL if there are none.
    const struct gusset_net_finding *findings;
    /// How many.
    size_t count;
    /// How many of them are violations; they come first.
    size_t violation_count;
} gusset_net_validation_view;

/// Checks that glued nodes lie together, and looks for what is suspicious. What it finds is no error. Two missing nodes
/// are no violation.
/// @param tolerance how far two nodes may be apart, at least 0; for 0 their coordinates must be equal (0 and -0 are).
/// @errors OUT_OF_RANGE (tolerance)
/// @complexity O(nodes), and a sort of the findings.
/// @source Deryagin, "Non-spatial operations".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_validation_create(const struct gusset_context *context,
    const struct gusset_net *net, double tolerance, struct gusset_net_validation **validation);

/// Lends the findings.
/// @complexity O(log findings).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_validation_get_view(const struct gusset_net_validation *validation,
    struct gusset_net_validation_view *view);

/// Destroys a validation; NULL is allowed.
GUSSET_API void gusset_net_validation_destroy(struct gusset_net_validation *validation);

#ifdef __cplusplus
}
#endif

#endif /* GUSSET_NET_H */
