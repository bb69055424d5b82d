/* Generated from src/capi; see gusset.h. */

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

/// Version of this header; compare gusset_version().
#define GUSSET_VERSION_MAJOR 0
#define GUSSET_VERSION_MINOR 1
#define GUSSET_VERSION_PATCH 0
#define GUSSET_VERSION_STRING "0.1.0"

#ifdef __cplusplus
extern "C" {
#endif

/*** Statuses. 1 to 999 are mistakes of the caller, 1000 to 1999 faults of the data, 2000 to 2999 failures of the */
/*** environment. Numbers never change their meaning. */

/// Status that a function returns.
enum gusset_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif
 {
    /// Success.
    GUSSET_OK = 0,
    /// A pointer that must not be NULL is NULL.
    GUSSET_ERROR_NULL_ARGUMENT = 1,
    /// A pointer to a struct, a handle or an output is misaligned.
    GUSSET_ERROR_MISALIGNED_ARGUMENT = 2,
    /// struct_size is not the size of the struct in any version.
    GUSSET_ERROR_BAD_STRUCT_SIZE = 3,
    /// A choice, a reserved field or a field unknown to this version has an unknown value.
    GUSSET_ERROR_UNKNOWN_VALUE = 4,
    /// An option is outside its range.
    GUSSET_ERROR_OUT_OF_RANGE = 5,
    /// The caller's buffer is too small; only the required size was written.
    GUSSET_ERROR_BUFFER_TOO_SMALL = 6,
    /// Another call uses the context, on another thread or further up the stack.
    GUSSET_ERROR_CONTEXT_BUSY = 7,
    /// The element with this index does not exist.
    GUSSET_ERROR_NO_SUCH_ELEMENT = 8,
    /// A stride is smaller than one element.
    GUSSET_ERROR_BAD_STRIDE = 9,
    /// Exactly one of face_offsets and face_size must be given.
    GUSSET_ERROR_BAD_FACE_LAYOUT = 10,
    /// An output array overlaps another array.
    GUSSET_ERROR_OVERLAP = 11,
    /// A handle is of the wrong kind or was destroyed. Reused memory and other invalid pointers stay undetected.
    GUSSET_ERROR_WRONG_HANDLE = 12,
    /// The number of inputs, or of elements of an array, is wrong.
    GUSSET_ERROR_COUNT_DIFFERS = 13,
    /// A count exceeds the limit of this version.
    GUSSET_ERROR_TOO_LARGE = 1000,
    /// An array exceeds the address space.
    GUSSET_ERROR_SIZE_OVERFLOW = 1001,
    /// A mesh lacks vertices or faces, or no mesh was given.
    GUSSET_ERROR_EMPTY_MESH = 1002,
    /// Offsets do not start at 0, decrease, or do not end at the number of elements.
    GUSSET_ERROR_BAD_OFFSETS = 1003,
    /// A face has fewer than three corners.
    GUSSET_ERROR_FACE_TOO_SMALL = 1004,
    /// A vertex index is out of range.
    GUSSET_ERROR_INDEX_OUT_OF_RANGE = 1005,
    /// A number is NaN or infinite. It belongs to a used vertex, point, tangent, query, node or channel.
    GUSSET_ERROR_NOT_FINITE = 1006,
    /// A later mesh or piece has 64-bit positions and the first has 32-bit positions.
    GUSSET_ERROR_MIXED_SCALARS = 1007,
    /// A record of a winged-edge table is inconsistent.
    GUSSET_ERROR_BAD_WINGS = 1008,
    /// A merge map names a vertex that does not exist or is merged into another.
    GUSSET_ERROR_BAD_MERGE = 1009,
    /// A face passes a vertex twice, which the operation does not allow.
    GUSSET_ERROR_REPEATED_CORNER = 1010,
    /// A mesh is not closed, or its faces are not oriented alike.
    GUSSET_ERROR_MESH_NOT_CLOSED = 1011,
    /// No boundary loop, or no pair of loops of one mesh, can be stitched.
    GUSSET_ERROR_NO_LOOP = 1100,
    /// A loop has fewer than three vertices.
    GUSSET_ERROR_LOOP_TOO_SHORT = 1101,
    /// A loop passes a vertex twice.
    GUSSET_ERROR_LOOP_REPEATS_VERTEX = 1102,
    /// Consecutive vertices of a loop are not joined by an edge with exactly one face.
    GUSSET_ERROR_LOOP_EDGE_NOT_FREE = 1103,
    /// Both loops pass the same vertex of one mesh.
    GUSSET_ERROR_LOOPS_SHARE_VERTEX = 1104,
    /// The faces along a loop disagree in orientation.
    GUSSET_ERROR_LOOP_NOT_ORIENTED = 1105,
    /// The second piece is oriented against the first, and the options forbid turning it over.
    GUSSET_ERROR_ORIENTATION_CONFLICT = 1106,
    /// Every strip through the first meridian would repeat an edge of the mesh.
    GUSSET_ERROR_NO_STRIP = 1107,
    /// The planes through the loops' centres do not show which vertices face each other. Join whole loops.
    GUSSET_ERROR_PLANES_UNDECIDED = 1108,
    /// Consecutive vertices of a cut are not connected by edges.
    GUSSET_ERROR_CUT_NOT_CONNECTED = 1109,
    /// A closed curve does not end where it begins.
    GUSSET_ERROR_CURVE_NOT_CLOSED = 1200,
    /// A control point of a plane curve has z other than 0.
    GUSSET_ERROR_CURVE_NOT_PLANE = 1201,
    /// A curve lacks segments or points.
    GUSSET_ERROR_EMPTY_CURVE = 1202,
    /// A section of a frame has a different number of points than the first.
    GUSSET_ERROR_SECTIONS_DIFFER = 1210,
    /// A section of a frame, or a plane, does not meet a column.
    GUSSET_ERROR_NO_NODE = 1211,
    /// A net has fewer than two rows or columns.
    GUSSET_ERROR_NET_TOO_SMALL = 1300,
    /// A gluing merges both pairs of opposite corners of a cell.
    GUSSET_ERROR_CROSSING_CELL = 1301,
    /// A seam is empty, leaves the net, or repeats one pair of nodes.
    GUSSET_ERROR_BAD_SEAM = 1302,
    /// Sides of nets to be joined have different numbers of nodes or do not coincide.
    GUSSET_ERROR_SIDES_DIFFER = 1303,
    /// Faces do not form a rectangular grid of quads, whole or split along diagonals.
    GUSSET_ERROR_NO_GRID = 1304,
    /// A stream is damaged, truncated or in another format.
    GUSSET_ERROR_BAD_STREAM = 1305,
    /// A group of a scene would contain itself.
    GUSSET_ERROR_SCENE_CYCLE = 1306,
    /// A scene has no nets.
    GUSSET_ERROR_EMPTY_SCENE = 1307,
    /// A deformation field is not defined at a node.
    GUSSET_ERROR_FIELD_UNDEFINED = 1320,
    /// A net is glued elsewhere than along whole sides, or has bridges.
    GUSSET_ERROR_GLUED_INSIDE = 1321,
    /// Two nets are glued differently.
    GUSSET_ERROR_GLUINGS_DIFFER = 1322,
    /// Knots of a spline have a wrong number, order or multiplicity.
    GUSSET_ERROR_BAD_KNOTS = 1410,
    /// Curves of a net do not meet, or meet out of order.
    GUSSET_ERROR_CURVES_APART = 1411,
    /// Memory could not be allocated.
    GUSSET_ERROR_OUT_OF_MEMORY = 2000,
    /// The caller cancelled the call.
    GUSSET_ERROR_CANCELLED = 2001,
    /// Internal error of the library; the context and all handles remain usable.
    GUSSET_ERROR_PANIC = 9999,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum gusset_status gusset_status;
#else
typedef int32_t gusset_status;
#endif
#endif

/// Element that a report's index counts.
typedef uint32_t gusset_element;
/// The index means nothing.
#define GUSSET_ELEMENT_NONE 0
/// Vertex of the input mesh.
#define GUSSET_ELEMENT_VERTEX 1
/// Face of the input mesh.
#define GUSSET_ELEMENT_FACE 2
/// Half-edge: a position in face_corners.
#define GUSSET_ELEMENT_HALF_EDGE 3
/// Entry of an array of offsets.
#define GUSSET_ELEMENT_OFFSET 4
/// Position in a given loop. Its number is the report's input.
#define GUSSET_ELEMENT_LOOP_PLACE 5
/// Number of elements or bytes.
#define GUSSET_ELEMENT_COUNT 6
/// Point of an outline or a curve, over all outlines.
#define GUSSET_ELEMENT_POINT 7
/// Constraint on an outline: its place or tangent.
#define GUSSET_ELEMENT_CONSTRAINT 8
/// Given place on a curve or a surface.
#define GUSSET_ELEMENT_PLACE 9
/// Section of a frame, or plane. The value is the column or the number of points.
#define GUSSET_ELEMENT_SECTION 12
/// Node of a net, row after row.
#define GUSSET_ELEMENT_NODE 13
/// Link of a net: twice its first node, plus 1 if vertical.
#define GUSSET_ELEMENT_LINK 14
/// Cell of a net, row after row.
#define GUSSET_ELEMENT_CELL 15
/// Given seam.
#define GUSSET_ELEMENT_SEAM 16
/// Bridge of a net.
#define GUSSET_ELEMENT_BRIDGE 17
/// Entry of a scene.
#define GUSSET_ELEMENT_ENTRY 18
/// Byte of a stream.
#define GUSSET_ELEMENT_BYTE 19
/// Given operation, field, gluing, line, loop, pair, piece, sheet or curve.
#define GUSSET_ELEMENT_ITEM 21
/// Place along the side of a net; the value is a distance.
#define GUSSET_ELEMENT_SIDE_PLACE 20
/// Knot of a spline; the message names u or v.
#define GUSSET_ELEMENT_KNOT 30
/// Row of a net of curves. The message has the column; the value is their distance.
#define GUSSET_ELEMENT_ROW 31
/// Edge of a winged-edge table.
#define GUSSET_ELEMENT_EDGE 32

/// Describes a status in English.
/// @param status an unknown one gives "unknown status".
/// @return a static string, never NULL.
GUSSET_API const char *gusset_status_text(int32_t status);

/// Describes a value of a choice in an English sentence.
/// @param choice name of the type, such as "gusset_hole_status".
/// @param value its constant.
/// @return a static UTF-8 string, never NULL: the comment's first sentence, or "unknown value".
/// @complexity O(number of choices).
GUSSET_API const char *gusset_choice_text(const char *choice, uint32_t value);

/*** Contexts */

/// Threads, progress, cancellation, log, and the outcome of the last call. One thread uses it at a time, except for
/// cancel, reset and get_progress.
typedef struct gusset_context gusset_context;

/// Receives the progress of long work, on the calling thread. A nonzero return cancels this call only. The callback
/// must not throw, longjmp, or use the context except by cancel and get_progress.
/// - fraction: the part done, 0 to 1, nondecreasing; 1 after success.
/// - stage: the current work; valid during the callback.
typedef int (*gusset_progress_fn)(void *user, double fraction, const char *stage);

/// Receives remarks that are not errors, under the rules of gusset_progress_fn. Sentences may change; programs read
/// results. Stitching, filling and joining report
/// - a second piece or component turned over to agree with the first;
/// - a closed component turned over that faced the wrong side;
/// - fairing without new vertices;
/// - rows, cells or fairing with a blend;
/// - a strip instead of a blend;
/// - near_loops_left above 0 or zero_volume not empty in gusset_join_report.
typedef void (*gusset_log_fn)(void *user, const char *message);

/// Report of the last error.
typedef struct gusset_error_report {
    size_t struct_size;
    /// Status that the call returned.
    int32_t status;
    gusset_element element;
    /// First offending element.
    uint64_t index;
    /// Its value, such as a coordinate, vertex index or limit.
    double value;
    /// Mesh, piece, input or loop of the element.
    uint32_t input;
    uint32_t reserved;
} gusset_error_report;

/// Creates a context with automatic threads and without callbacks.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_context_create(struct gusset_context **context);

/// Destroys a context. No call may be using it.
GUSSET_API void gusset_context_destroy(struct gusset_context *context);

/// Sets the number of threads.
/// @param threads 0: a thread for each processor that the calling thread may use; 1: the calling thread.
GUSSET_API gusset_status gusset_context_set_threads(struct gusset_context *context, uint32_t threads);

/// Sets the progress callback.
/// @param progress NULL: none.
GUSSET_API gusset_status gusset_context_set_progress(struct gusset_context *context, gusset_progress_fn progress,
    void *user);

/// Sets the log callback.
/// @param log NULL: none.
GUSSET_API gusset_status gusset_context_set_log(struct gusset_context *context, gusset_log_fn log, void *user);

/// Cancels running and later calls until gusset_context_reset.
/// @threads Any; NULL is allowed.
GUSSET_API void gusset_context_cancel(const struct gusset_context *context);

/// Withdraws a cancellation.
/// @threads Any; NULL is allowed.
GUSSET_API void gusset_context_reset(const struct gusset_context *context);

/// Returns the done part of the running or last call.
/// @return 0 to 1; 0 for NULL.
GUSSET_API double gusset_context_get_progress(const struct gusset_context *context);

/// Explains the last call's error in an English sentence.
/// @return UTF-8, never NULL, valid until the next call with the context; empty after a success, during a call, and for
///     NULL.
GUSSET_API const char *gusset_context_get_message(const struct gusset_context *context);

/// Copies the report of the last call, cleared after a success.
GUSSET_API gusset_status gusset_context_get_report(const struct gusset_context *context,
    struct gusset_error_report *report);

/*** Affine maps */

/// Affine map of points.
typedef struct gusset_transform {
    /// x' = rows[0] x + rows[1] y + rows[2] z + rows[3]; then y', then z'.
    double rows[12];
} gusset_transform;

/*** Versions */

/// Returns the version of the library, "major.minor.patch".
/// @return a static string, never NULL.
GUSSET_API const char *gusset_version(void);

/// Returns the number of the binary interface.
/// It changes when older programs could break: before 1.0, with each minor version.
/// @return the number.
GUSSET_API uint32_t gusset_abi(void);

#ifdef __cplusplus
}
#endif
#endif
