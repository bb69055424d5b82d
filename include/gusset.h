/** @file
 * gusset joins surfaces that come in pieces. This header includes the whole C interface:
 *
 *   gusset/base.h      statuses, versions, contexts
 *   gusset/mesh.h      meshes: joining, holes, repair, boundaries, checks
 *   gusset/curve.h     curves through given points, outlines, frames of a body
 *   gusset/net.h       regular nets of quads, gluing, fields, measures
 *   gusset/scene.h     nets in nested groups
 *   gusset/stream.h    nets as bytes
 *   gusset/surface.h   smooth surfaces: nearest points, sections, intersections
 *   gusset/papers.h    tables and searches as the papers print them
 *   gusset/views.h     views of the caller's arrays in one line
 *
 * The main job, from two meshes to one:
 *
 *   gusset_mesh_view pieces[2] = {gusset_triangles_f32(points_a, point_count_a, corners_a, triangle_count_a),
 *                                 gusset_triangles_f32(points_b, point_count_b, corners_b, triangle_count_b)};
 *   gusset_result *result = NULL;
 *   gusset_status status = gusset_join(NULL, pieces, 2, NULL, &result);
 *   gusset_mesh_view joined = {.struct_size = sizeof joined};
 *   if (status == GUSSET_OK) status = gusset_result_get_mesh(result, &joined);
 *   gusset_result_destroy(result);   (after the last use of joined)
 *
 * Other common calls: gusset_fill, gusset_surface_nearest, gusset_outline_create, gusset_net_to_mesh.
 *
 * Rules for every function:
 *
 * Arguments. A function takes a context, handles, inputs, options and outputs, in this order. The context gives
 * threads, progress, cancellation and the report of an error. Non-const pointers to numbers and structs receive
 * results. A NULL context or NULL options, also in a field, select the defaults. Input arrays may have any alignment.
 *
 * Units. Counts are in elements, strides in bytes (0: packed), angles in radians, lengths in the unit of the positions.
 * Indices begin at 0. Coordinates are 32-bit or 64-bit floats, as `scalar` says. Points and vectors are x, y, z. Part k
 * of an array has the elements offsets[k] to offsets[k + 1] - 1; there is one offset more than parts.
 *
 * Ranges. Unless stated otherwise, given numbers are finite, tolerances and largest distances at least 0, and
 * directions and normals not 0.
 *
 * Structs. Set struct_size to sizeof the struct, and all other fields to 0 for the defaults:
 * `gusset_fill_options options = {.struct_size = sizeof options};`. Fields called reserved must be 0.
 *
 * Ownership. The library reads the caller's arrays during a call, without copying positions first. A handle copies the
 * data that it needs, unless its comment says that it borrows. Destroy each handle once; _destroy functions take NULL.
 * _get_ functions lend memory of their handle, valid until it is destroyed or changed. A lent array without elements is
 * NULL.
 *
 * Buffers. `written` receives the number of elements. NULL with capacity 0 skips the array.
 *
 * Errors. A function returns GUSSET_OK or a gusset_status; gusset_context_get_message explains it, and
 * gusset_context_get_report names the element, its index and its value. After an error, output handles are NULL, output
 * structs and numbers are cleared, the content of an output array is unspecified, and nothing else has changed. One
 * exception: BUFFER_TOO_SMALL reports the size needed. An outcome in a report, such as a defect or an open hole, is not
 * an error; gusset_choice_text says what its value means.
 *
 * Comments. @errors lists the statuses of a function without GUSSET_ERROR_; "as f" adds the errors of f. Every function
 * may also return NULL_ARGUMENT, MISALIGNED_ARGUMENT, WRONG_HANDLE, BAD_STRUCT_SIZE, UNKNOWN_VALUE, TOO_LARGE,
 * SIZE_OVERFLOW, OUT_OF_MEMORY, with a context CONTEXT_BUSY and CANCELLED, with a capacity BUFFER_TOO_SMALL, with a
 * mesh the errors of gusset_mesh_view. H counts half-edges, d the most edges at a vertex. Functions without @complexity
 * take O(1), except _destroy and in views.h. "1: ...": a flag, 0 or 1. @bits: a sum of constants. "@when f X": read
 * only if the field f is X. @values: no others. @source: the README lists the papers.
 *
 * Threads. Every function is reentrant. Handles are immutable, except nets, scenes and decoders: do not use one while
 * another thread changes it. A context serves one call at a time. Results do not depend on the number of threads.
 *
 * C99 or later, C++11 or later. Everything is available since version 0.1. */

#ifndef GUSSET_H
#define GUSSET_H

#include "gusset/base.h"
#include "gusset/mesh.h"
#include "gusset/curve.h"
#include "gusset/net.h"
#include "gusset/scene.h"
#include "gusset/stream.h"
#include "gusset/surface.h"
#include "gusset/papers.h"
#include "gusset/views.h"

#endif /* GUSSET_H */
