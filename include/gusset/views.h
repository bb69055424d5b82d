/* Views of the caller's arrays in one line, and short forms of common calls: inline functions. See gusset.h. */

#ifndef GUSSET_VIEWS_H
#define GUSSET_VIEWS_H

#include "curve.h"
#include "mesh.h"
#include "net.h"
#include "surface.h"

/// A view of all its fields; see gusset_triangles_f32.
static inline gusset_mesh_view gusset_mesh_view_of(gusset_scalar scalar, const void *points, size_t point_count,
                                                   const uint32_t *offsets, const uint32_t *corners, size_t face_count,
                                                   uint32_t face_size) {
    gusset_mesh_view view;
    view.struct_size = sizeof view;
    view.positions = points;
    view.position_stride = 0;
    view.vertex_count = point_count;
    view.face_offsets = offsets;
    view.face_corners = corners;
    view.face_count = face_count;
    view.scalar = scalar;
    view.index = GUSSET_U32;
    view.face_size = face_size;
    view.reserved = 0;
    view.merge = NULL;
    return view;
}

/// A view of triangles: point_count packed points x, y, z, and three vertices for each triangle.
static inline gusset_mesh_view gusset_triangles_f32(const float *points, size_t point_count, const uint32_t *corners,
                                                    size_t triangle_count) {
    return gusset_mesh_view_of(GUSSET_F32, points, point_count, NULL, corners, triangle_count, 3);
}

/// In double precision.
static inline gusset_mesh_view gusset_triangles_f64(const double *points, size_t point_count, const uint32_t *corners,
                                                    size_t triangle_count) {
    return gusset_mesh_view_of(GUSSET_F64, points, point_count, NULL, corners, triangle_count, 3);
}

/// As gusset_triangles_f32, with four vertices for each quad.
static inline gusset_mesh_view gusset_quads_f32(const float *points, size_t point_count, const uint32_t *corners,
                                                size_t quad_count) {
    return gusset_mesh_view_of(GUSSET_F32, points, point_count, NULL, corners, quad_count, 4);
}

/// In double precision.
static inline gusset_mesh_view gusset_quads_f64(const double *points, size_t point_count, const uint32_t *corners,
                                                size_t quad_count) {
    return gusset_mesh_view_of(GUSSET_F64, points, point_count, NULL, corners, quad_count, 4);
}

/// As gusset_triangles_f32, with offsets into corners, by face.
static inline gusset_mesh_view gusset_polygons_f32(const float *points, size_t point_count, const uint32_t *offsets,
                                                   const uint32_t *corners, size_t face_count) {
    return gusset_mesh_view_of(GUSSET_F32, points, point_count, offsets, corners, face_count, 0);
}

/// In double precision.
static inline gusset_mesh_view gusset_polygons_f64(const double *points, size_t point_count, const uint32_t *offsets,
                                                   const uint32_t *corners, size_t face_count) {
    return gusset_mesh_view_of(GUSSET_F64, points, point_count, offsets, corners, face_count, 0);
}

/// Lends the mesh of a result, without vertices if it is NULL.
static inline gusset_mesh_view gusset_result_mesh(const gusset_result *result) {
    gusset_mesh_view view;
    view.struct_size = sizeof view;
    if (gusset_result_get_mesh(result, &view) != GUSSET_OK) {
        return gusset_mesh_view_of(GUSSET_F64, NULL, 0, NULL, NULL, 0, 3);
    }
    return view;
}

/// One outline of point_count packed points; closed: 0 or 1.
static inline gusset_outlines gusset_points_f64(const double *points, size_t point_count, uint32_t dimension,
                                                uint32_t closed) {
    gusset_outlines outlines;
    outlines.struct_size = sizeof outlines;
    outlines.points = points;
    outlines.point_stride = 0;
    outlines.point_count = point_count;
    outlines.offsets = NULL;
    outlines.outline_count = 0;
    outlines.constraints = NULL;
    outlines.constraint_count = 0;
    outlines.dimension = dimension;
    outlines.closed = closed;
    return outlines;
}

/// The nodes of a sheet: rows x columns packed points x, y, z, open in both directions.
static inline gusset_nodes gusset_nodes_of(gusset_scalar scalar, const void *points, size_t rows, size_t columns) {
    gusset_nodes nodes;
    nodes.struct_size = sizeof nodes;
    nodes.nodes = points;
    nodes.rows = rows;
    nodes.columns = columns;
    nodes.row_stride = 0;
    nodes.column_stride = 0;
    nodes.scalar = scalar;
    nodes.scheme = 0;
    nodes.closed_u = 0;
    nodes.closed_v = 0;
    return nodes;
}

/// In single precision.
static inline gusset_nodes gusset_nodes_f32(const float *points, size_t rows, size_t columns) {
    return gusset_nodes_of(GUSSET_F32, points, rows, columns);
}

/// In double precision.
static inline gusset_nodes gusset_nodes_f64(const double *points, size_t rows, size_t columns) {
    return gusset_nodes_of(GUSSET_F64, points, rows, columns);
}

/// The coordinates of a net: rows x columns packed points, which begin at x; numbers have number_size bytes.
static inline gusset_net_view gusset_net_points_of(gusset_scalar scalar, void *x, void *y, void *z, size_t number_size,
                                                   size_t rows, size_t columns) {
    gusset_net_view view;
    view.struct_size = sizeof view;
    view.rows = rows;
    view.columns = columns;
    view.x = x;
    view.y = y;
    view.z = z;
    view.row_stride = 3 * number_size * columns;
    view.column_stride = 3 * number_size;
    view.scalar = scalar;
    view.reserved = 0;
    return view;
}

/// In single precision.
static inline gusset_net_view gusset_net_points_f32(float *points, size_t rows, size_t columns) {
    return gusset_net_points_of(GUSSET_F32, points, points + 1, points + 2, sizeof *points, rows, columns);
}

/// In double precision.
static inline gusset_net_view gusset_net_points_f64(double *points, size_t rows, size_t columns) {
    return gusset_net_points_of(GUSSET_F64, points, points + 1, points + 2, sizeof *points, rows, columns);
}

/// Makes a surface of one sheet through nodes.
/// @errors as gusset_sheet_create, as gusset_surface_create
static inline GUSSET_MUST_USE gusset_status gusset_surface_from_nodes_create(const gusset_context *context,
                                                                             const gusset_nodes *nodes,
                                                                             gusset_surface **surface) {
    gusset_sheet *sheet = NULL;
    const gusset_sheet *sheets[1];
    gusset_status status = gusset_sheet_create(context, nodes, NULL, 0, &sheet);
    sheets[0] = sheet;
    if (surface != NULL) {
        *surface = NULL;
    }
    if (status == GUSSET_OK) {
        status = gusset_surface_create(context, sheets, 1, NULL, surface);
    }
    gusset_sheet_destroy(sheet);
    return status;
}

/// Passes a curve through one outline. The statuses of points are lost.
/// @errors as gusset_outline_create, as gusset_outline_curve_create
static inline GUSSET_MUST_USE gusset_status gusset_curve_from_points_create(const gusset_context *context,
                                                                            const gusset_outlines *points,
                                                                            const gusset_outline_options *options,
                                                                            gusset_curve **curve) {
    gusset_outline *outline = NULL;
    gusset_status status = gusset_outline_create(context, points, options, &outline);
    if (curve != NULL) {
        *curve = NULL;
    }
    if (status == GUSSET_OK) {
        status = gusset_outline_curve_create(context, outline, 0, curve);
    }
    gusset_outline_destroy(outline);
    return status;
}

/// Lends the exported form of a curve, empty if it is NULL.
static inline gusset_curve_form_view gusset_curve_form_lend(const gusset_curve_form *form) {
    gusset_curve_form_view view;
    view.struct_size = sizeof view;
    /* After an error all fields are 0. */
    if (gusset_curve_form_get_view(form, &view) != GUSSET_OK) {
        view.text = "";
    }
    return view;
}

#endif /* GUSSET_VIEWS_H */
