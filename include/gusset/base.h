/* Generated from src/capi; do not edit. See gusset.h. */

#ifndef GUSSET_BASE_H
#define GUSSET_BASE_H

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

/// Version of this header; compare with gusset_version() of the library loaded.
#define GUSSET_VERSION_MAJOR 0
#define GUSSET_VERSION_MINOR 1
#define GUSSET_VERSION_PATCH 0
#define GUSSET_VERSION_STRING "0.1.0"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------------------------ */
/* Statuses: Numbers that functions return. 1 to 999 are mistakes of the caller, 1000 to 1999 lie in the data, 2000 */
/* to 2999 come from the environment. A number never changes its meaning. The first sentence of each comment is the */
/* text of its status too: see `status_text.rs`. Each error of the core becomes a code with an element in one place, */
/* `From<Error>`. */

/// What a function returns; `GUSSET_OK` is 0.
enum gusset_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /// Success.
    GUSSET_OK = 0,
    /// A pointer that must not be NULL is NULL.
    GUSSET_ERROR_NULL_ARGUMENT = 1,
    /// A pointer to a struct, a handle or an output is not aligned for it. (Element arrays may have any alignment.)
    GUSSET_ERROR_MISALIGNED_ARGUMENT = 2,
    /// struct_size is smaller than the first version of the struct.
    GUSSET_ERROR_BAD_STRUCT_SIZE = 3,
    /// An enumerator, a reserved field or a field unknown to this version has an unknown value.
    GUSSET_ERROR_UNKNOWN_VALUE = 4,
    /// An option is outside its range.
    GUSSET_ERROR_OUT_OF_RANGE = 5,
    /// The caller's buffer is too small; nothing was written but the size needed.
    GUSSET_ERROR_BUFFER_TOO_SMALL = 6,
    /// The context is in use by another call: on another thread, or further up this one's stack.
    GUSSET_ERROR_CONTEXT_BUSY = 7,
    /// There is no element of this index.
    GUSSET_ERROR_NO_SUCH_ELEMENT = 8,
    /// A stride is smaller than what lies at each step of it.
    GUSSET_ERROR_BAD_STRIDE = 9,
    /// Exactly one of face_offsets and face_size must be given.
    GUSSET_ERROR_BAD_FACE_LAYOUT = 10,
    /// Arrays that the library would write to overlap.
    GUSSET_ERROR_OVERLAP = 11,
    /// A handle is of another kind than the function takes, or was destroyed. (That is seen where the memory has not
    /// been used again; a pointer to anything else cannot be told.)
    GUSSET_ERROR_WRONG_HANDLE = 12,
    /// Values are given for another number of inputs, or of elements of one, than there are.
    GUSSET_ERROR_COUNT_DIFFERS = 13,
    /// More vertices, faces or half-edges than this version takes.
    GUSSET_ERROR_TOO_LARGE = 1000,
    /// The bytes of an array exceed the address space.
    GUSSET_ERROR_SIZE_OVERFLOW = 1001,
    /// A mesh without vertices or without faces, or no mesh at all.
    GUSSET_ERROR_EMPTY_MESH = 1002,
    /// Offsets, of faces, outlines or segments, do not start at 0, decrease, or end elsewhere than their elements.
    GUSSET_ERROR_BAD_OFFSETS = 1003,
    /// A face of fewer than three corners.
    GUSSET_ERROR_FACE_TOO_SMALL = 1004,
    /// A face names a vertex that does not exist.
    GUSSET_ERROR_INDEX_OUT_OF_RANGE = 1005,
    /// A number is NaN or infinite: a coordinate of a vertex that a face uses, of a point, a tangent, a query or a
    /// node, or a value of a channel.
    GUSSET_ERROR_NOT_FINITE = 1006,
    /// The second mesh, or a later piece, has f64 positions and the first f32.
    GUSSET_ERROR_MIXED_SCALARS = 1007,
    /// A record of a winged-edge table fits no mesh.
    GUSSET_ERROR_BAD_WINGS = 1008,
    /// A merge map leads to a vertex that does not exist, or to one that is not one with itself.
    GUSSET_ERROR_BAD_MERGE = 1009,
    /// A face passes a vertex twice, where each face needs a shape.
    GUSSET_ERROR_REPEATED_CORNER = 1010,
    /// There is no boundary loop that can be stitched, or of one mesh there are no two.
    GUSSET_ERROR_NO_LOOP = 1100,
    /// A loop of fewer than three vertices.
    GUSSET_ERROR_LOOP_TOO_SHORT = 1101,
    /// A loop passes a vertex twice.
    GUSSET_ERROR_LOOP_REPEATS_VERTEX = 1102,
    /// Consecutive vertices of a loop are not joined by an edge with exactly one face.
    GUSSET_ERROR_LOOP_EDGE_NOT_FREE = 1103,
    /// Both loops pass the same vertex of the same mesh.
    GUSSET_ERROR_LOOPS_SHARE_VERTEX = 1104,
    /// The faces along a loop disagree in orientation.
    GUSSET_ERROR_LOOP_NOT_ORIENTED = 1105,
    /// The second piece is oriented against the first, and the options refuse to turn it over.
    GUSSET_ERROR_ORIENTATION_CONFLICT = 1106,
    /// Every strip through the first meridian would repeat an edge that the mesh already has.
    GUSSET_ERROR_NO_STRIP = 1107,
    /// The planes through the loops' centres cannot tell which vertices face each other: such loops are joined whole.
    GUSSET_ERROR_PLANES_UNDECIDED = 1108,
    /// Vertices that follow one another in a cut are not connected by edges.
    GUSSET_ERROR_CUT_NOT_CONNECTED = 1109,
    /// A closed curve does not end where it begins.
    GUSSET_ERROR_CURVE_NOT_CLOSED = 1200,
    /// A control point of what must be a plane curve has z other than 0.
    GUSSET_ERROR_CURVE_NOT_PLANE = 1201,
    /// A curve without segments, or without points, where one is needed.
    GUSSET_ERROR_EMPTY_CURVE = 1202,
    /// A section of a frame has another number of points than the first one.
    GUSSET_ERROR_SECTIONS_DIFFER = 1210,
    /// A section of a frame, or a plane, does not meet a column.
    GUSSET_ERROR_NO_NODE = 1211,
    /// A net of fewer than two rows or columns.
    GUSSET_ERROR_NET_TOO_SMALL = 1300,
    /// A gluing makes both pairs of opposite corners of a cell one each, which no surface allows.
    GUSSET_ERROR_CROSSING_CELL = 1301,
    /// A seam is empty, leaves the net, or repeats one pair of nodes.
    GUSSET_ERROR_BAD_SEAM = 1302,
    /// Sides of nets to be joined have different numbers of nodes, or do not lie on each other.
    GUSSET_ERROR_SIDES_DIFFER = 1303,
    /// Faces of a mesh are no rectangular grid of quads, or triangles no such grid with diagonals.
    GUSSET_ERROR_NO_GRID = 1304,
    /// A stream is damaged, cut off, or none of ours.
    GUSSET_ERROR_BAD_STREAM = 1305,
    /// A group of a scene would contain itself.
    GUSSET_ERROR_SCENE_CYCLE = 1306,
    /// A scene without nets.
    GUSSET_ERROR_EMPTY_SCENE = 1307,
    /// A field of deformation is not defined at a node.
    GUSSET_ERROR_FIELD_UNDEFINED = 1320,
    /// A net is glued elsewhere than along whole sides, or has bridges.
    GUSSET_ERROR_GLUED_INSIDE = 1321,
    /// Two nets are glued differently.
    GUSSET_ERROR_GLUINGS_DIFFER = 1322,
    /// Knots of a spline: their number does not fit, or one is out of order or repeated too often.
    GUSSET_ERROR_BAD_KNOTS = 1410,
    /// Curves of a net do not meet, or not in the order given.
    GUSSET_ERROR_CURVES_APART = 1411,
    /// Memory could not be had.
    GUSSET_ERROR_OUT_OF_MEMORY = 2000,
    /// The host cancelled.
    GUSSET_ERROR_CANCELLED = 2001,
    /// A defect of the library; the context and all handles remain usable.
    GUSSET_ERROR_PANIC = 9999,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum gusset_status gusset_status;
#else
typedef int32_t gusset_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// What the index in a report counts.
typedef uint32_t gusset_element;
/// The report's index means nothing.
#define GUSSET_ELEMENT_NONE 0
/// A vertex of the input mesh.
#define GUSSET_ELEMENT_VERTEX 1
/// A face of the input mesh.
#define GUSSET_ELEMENT_FACE 2
/// A half-edge: a position in face_corners.
#define GUSSET_ELEMENT_HALF_EDGE 3
/// An entry of face_offsets.
#define GUSSET_ELEMENT_OFFSET 4
/// A place in the loop given; the report's input is the number of the loop.
#define GUSSET_ELEMENT_LOOP_PLACE 5
/// A count of elements or bytes.
#define GUSSET_ELEMENT_COUNT 6
/// A point of an outline or a curve, counted over all outlines.
#define GUSSET_ELEMENT_POINT 7
/// A constraint on an outline: its place, or its tangent.
#define GUSSET_ELEMENT_CONSTRAINT 8
/// One of the places on a curve or a surface that were given.
#define GUSSET_ELEMENT_PLACE 9
/// A section of a frame, or a plane, counted from 0; the value is the column or the number of points.
#define GUSSET_ELEMENT_SECTION 12
/// A node of a net, row after row.
#define GUSSET_ELEMENT_NODE 13
/// A link of a net: twice its first node, and 1 if it is vertical.
#define GUSSET_ELEMENT_LINK 14
/// A cell of a net, row after row.
#define GUSSET_ELEMENT_CELL 15
/// One of the seams given.
#define GUSSET_ELEMENT_SEAM 16
/// A bridge of a net.
#define GUSSET_ELEMENT_BRIDGE 17
/// An entry of a scene.
#define GUSSET_ELEMENT_ENTRY 18
/// A byte of a stream.
#define GUSSET_ELEMENT_BYTE 19
/// One of the operations, fields, gluings, lines, loops, pairs, pieces, sheets or curves that were given.
#define GUSSET_ELEMENT_ITEM 21
/// A place along the side of a net; the value is a distance.
#define GUSSET_ELEMENT_SIDE_PLACE 20
/// A knot of a spline, in u or in v as the message says.
#define GUSSET_ELEMENT_KNOT 30
/// A row of a net of curves; the message has the column, the value is how far they are apart.
#define GUSSET_ELEMENT_ROW 31
/// An edge of a winged-edge table.
#define GUSSET_ELEMENT_EDGE 32

/// What a status means, in a few English words. Never NULL; static.
/// @param status any number; for one that is no status, "unknown status".
/// @return a static string, never NULL.
/// @complexity O(1).
GUSSET_API const char *gusset_status_text(int32_t status);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Contexts: Threads, progress, cancellation, log, and the report of the last error. */

/// Threads, progress, cancel, log, and the outcome of the last call. Opaque; one thread uses it at a time, but
/// gusset_context_cancel and gusset_context_get_progress may be called from any.
typedef struct gusset_context gusset_context;

/// Called now and then during long work, on the thread that made the call. fraction: part done, 0 to 1. stage: what is
/// being done, valid during the callback only. Return nonzero to cancel the call. It must not use the context, except
/// for gusset_context_cancel and gusset_context_get_progress, and must not throw or longjmp.
typedef int (*gusset_progress_fn)(void *user, double fraction, const char *stage);

/// Called with remarks that are no failures, on the thread that made the call; message is valid during the callback
/// only. The same rules as for progress. Stitching, filling and joining remark that
/// - the pieces of a stitch, or the components of its two loops, disagree in orientation, and the second was turned
///   over;
/// - what is closed was inside out, and was turned over;
/// - fairing was asked for, and no new vertices were;
/// - rows, cells or fairing were asked for with a blend, which does not read them;
/// - a strip stays in the place of a blend, which would need too many vertices or cut more faces;
/// - loops are left although others are near: near_loops_left of gusset_join_report is not 0;
/// - a closed component encloses no volume: zero_volume of gusset_join_report is not empty. Programs read the same from
///   the results; the sentences may change.
typedef void (*gusset_log_fn)(void *user, const char *message);

/// What went wrong in the last call, for programs.
typedef struct gusset_error_report {
    size_t struct_size;
    /// The status that the call returned.
    int32_t status;
    /// What index counts: one of GUSSET_ELEMENT_...
    gusset_element element;
    /// The first offending element.
    uint64_t index;
    /// Its value where it has one: the coordinate, the vertex index, the limit exceeded.
    double value;
    /// The mesh or loop that it belongs to: 0 the first, 1 the second.
    uint32_t input;
    uint32_t reserved;
} gusset_error_report;

/// Creates a context with automatic threads and no callbacks.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_context_create(struct gusset_context **context);

/// Destroys a context; NULL is allowed. No call may be using it.
GUSSET_API void gusset_context_destroy(struct gusset_context *context);

/// Sets the number of threads, on which results do not depend.
/// @param threads 0 as many as the machine has, 1 the calling thread only.
/// @complexity O(1).
GUSSET_API gusset_status gusset_context_set_threads(struct gusset_context *context, uint32_t threads);

/// Sets the progress callback.
/// @param progress NULL for none.
/// @param user handed to it, and not looked at.
/// @complexity O(1).
GUSSET_API gusset_status gusset_context_set_progress(struct gusset_context *context, gusset_progress_fn progress,
    void *user);

/// Sets the log callback.
/// @param log NULL for none.
/// @param user handed to it, and not looked at.
/// @complexity O(1).
GUSSET_API gusset_status gusset_context_set_log(struct gusset_context *context, gusset_log_fn log, void *user);

/// Cancels the running call, and every later one until gusset_context_reset.
/// @complexity O(1).
/// @threads From any thread; NULL is allowed.
GUSSET_API void gusset_context_cancel(const struct gusset_context *context);

/// Takes a cancel back. NULL is allowed.
/// @complexity O(1).
/// @threads From any thread.
GUSSET_API void gusset_context_reset(const struct gusset_context *context);

/// How much of the running (or last) call is done, 0 to 1; 0 for NULL.
/// @return 0 to 1; 0 for NULL.
/// @complexity O(1).
GUSSET_API double gusset_context_get_progress(const struct gusset_context *context);

/// What went wrong in the last call with this context, as an English sentence; empty after a success. Never NULL. Valid
/// until the next call with the context. Empty too for NULL, and while a call is running.
/// @return a NUL-terminated UTF-8 string, never NULL.
/// @complexity O(1).
GUSSET_API const char *gusset_context_get_message(const struct gusset_context *context);

/// What went wrong in the last call with this context, as numbers.
/// @complexity O(1).
GUSSET_API gusset_status gusset_context_get_report(const struct gusset_context *context,
    struct gusset_error_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Affine maps: Three rows of four numbers; they map points to points. */

/// An affine map: a row of four numbers for each of x, y, z; the last of each is what is added.
typedef struct gusset_transform {
    /// x' = rows[0] x + rows[1] y + rows[2] z + rows[3]; then y', then z'.
    double rows[12];
} gusset_transform;

/* ------------------------------------------------------------------------------------------------------------------ */
/* Versions: The version of the library and of its binary interface. */

/// The library's version, "major.minor.patch". Never NULL; static.
/// @return a static string, never NULL.
/// @complexity O(1).
GUSSET_API const char *gusset_version(void);

/// The number of the binary interface. It changes whenever a program built against an older header could break; until
/// 1.0 that is when the minor version changes.
/// @return the number.
/// @complexity O(1).
GUSSET_API uint32_t gusset_abi(void);

#ifdef __cplusplus
}
#endif

#endif /* GUSSET_BASE_H */
