#include "shapes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double turn = 6.283185307179586;

static void *room(size_t count, size_t size) {
    void *memory = calloc(count, size);
    if (memory == NULL) {
        fputs("no memory for the shapes\n", stderr);
        exit(2);
    }
    return memory;
}

/* Where u and v, from 0 to 1, are on shape number `form`; the one below another is seen from its other side. */
static void place(uint32_t form, double u, double v, double below, double *at) {
    if (form == 1) {
        const double radius = 1 + 0.1 * sin(3 * turn * v);
        at[0] = radius * cos(turn * u);
        at[1] = radius * sin(turn * u);
        at[2] = 3 * v - 3.5 * below;
    } else if (form == 2) {
        const double radius = sin(0.5 * turn * v) * (1 + 0.3 * below);
        at[0] = radius * cos(turn * u);
        at[1] = radius * sin(turn * u);
        at[2] = -cos(0.5 * turn * v) * (1 + 0.3 * below);
    } else {
        at[0] = 2 * u - 1;
        at[1] = (below > 0 ? -1 : 1) * (2 * v - 1);
        at[2] = 0.3 * sin(turn * u) * cos(turn * v) + 0.2 * u * v - 0.5 * below;
    }
}

static void keep_mesh(shapes *made, uint32_t k, double *points, size_t vertices, uint32_t *offsets, uint32_t *corners,
                      size_t faces) {
    gusset_plugin_mesh *mesh = &made->views[k].mesh;
    memset(mesh, 0, sizeof *mesh);
    mesh->struct_size = sizeof *mesh;
    mesh->positions = points;
    mesh->vertex_count = vertices;
    mesh->face_offsets = offsets;
    mesh->face_corners = corners;
    mesh->face_count = faces;
    mesh->scalar = GUSSET_PLUGIN_F64;
    made->memory[k][0] = points;
    made->memory[k][1] = offsets;
    made->memory[k][2] = corners;
    made->inputs[k].view = mesh;
}

/* A sheet of n x n quads; a tube, whose columns are closed; a sphere, whose first and last rows are fans of triangles.
 */
static void make_mesh(shapes *made, uint32_t k, uint32_t form, uint32_t n) {
    const int round = form != 0, poles = form == 2;
    const uint32_t columns = round ? n : n + 1, rows = n + 1;
    const size_t faces = (size_t)n * n;
    const size_t vertices = poles ? (size_t)(rows - 2) * columns + 2 : (size_t)rows * columns;
    double *points = room(3 * vertices, sizeof *points);
    uint32_t *offsets = room(faces + 1, sizeof *offsets), *corners = room(4 * faces, sizeof *corners);
    size_t count = 0, face = 0, corner = 0;
    for (uint32_t i = 0; i < rows; ++i) {
        const int pole = poles && (i == 0 || i + 1 == rows);
        for (uint32_t j = 0; j < (pole ? 1 : columns); ++j) {
            place(form, (double)j / n, (double)i / n, k, points + 3 * count++);
        }
    }
    for (uint32_t i = 0; i < n; ++i) {
        for (uint32_t j = 0; j < n; ++j) {
            const uint32_t next = (j + 1) % columns;
            if (poles) {
                const uint32_t low = i == 0 ? 0 : 1 + (i - 1) * columns, high = 1 + i * columns;
                corners[corner++] = i == 0 ? 0 : low + j;
                if (i > 0) {
                    corners[corner++] = low + next;
                }
                corners[corner++] = i + 1 == n ? high : high + next;
                if (i + 1 < n) {
                    corners[corner++] = high + j;
                }
            } else {
                corners[corner++] = i * columns + j;
                corners[corner++] = i * columns + next;
                corners[corner++] = (i + 1) * columns + next;
                corners[corner++] = (i + 1) * columns + j;
            }
            offsets[++face] = (uint32_t)corner;
        }
    }
    keep_mesh(made, k, points, vertices, offsets, corners, faces);
}

/* A box around the other shapes, one corner of which moves with k: a lattice at rest, and one that is moved. */
static void make_box(shapes *made, uint32_t k) {
    static const uint32_t quads[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    double *points = room(24, sizeof *points);
    uint32_t *offsets = room(7, sizeof *offsets), *corners = room(24, sizeof *corners);
    for (uint32_t p = 0; p < 24; ++p) {
        points[p] = (p / 3 >> p % 3 & 1) != 0 ? 2 : -2;
        corners[p] = quads[p];
    }
    for (uint32_t f = 0; f < 6; ++f) {
        offsets[f + 1] = 4 * (f + 1);
    }
    points[23] += 0.5 * (k - 1);
    keep_mesh(made, k, points, 8, offsets, corners, 6);
}

/* Rings with three waves, of about n x n points in all. */
static void make_curves(shapes *made, uint32_t k, uint32_t number, uint32_t n) {
    const int flat = number == 2 || number == 3, closed = number == 0 || number == 2;
    const uint32_t count = number == 3 ? 1 : flat ? 2 : n, each = n * n / count;
    double *points = room(3 * (size_t)count * each, sizeof *points);
    uint32_t *offsets = room((size_t)count + 1, sizeof *offsets);
    uint8_t *flags = room(count, 1);
    for (uint32_t c = 0; c < count; ++c) {
        for (uint32_t p = 0; p < each; ++p) {
            double *at = points + 3 * ((size_t)c * each + p);
            const double angle = turn * p / each, radius = 1 + 0.1 * sin(3 * angle);
            at[0] = radius * cos(angle) + (flat ? 3.0 * c : 0);
            at[1] = radius * sin(angle);
            at[2] = flat ? 0 : 0.25 * c + 3.0 * k;
        }
        offsets[c + 1] = (c + 1) * each;
        flags[c] = (uint8_t)closed;
    }
    gusset_plugin_curves *curves = &made->views[k].curves;
    memset(curves, 0, sizeof *curves);
    curves->struct_size = sizeof *curves;
    curves->points = points;
    curves->point_count = (size_t)count * each;
    curves->offsets = offsets;
    curves->closed = flags;
    curves->curve_count = count;
    curves->scalar = GUSSET_PLUGIN_F64;
    made->memory[k][0] = points;
    made->memory[k][1] = offsets;
    made->memory[k][2] = flags;
    made->inputs[k].view = curves;
}

void shapes_make(shapes *made, const gusset_filter *filter, uint32_t number, uint32_t size) {
    memset(made, 0, sizeof *made);
    const uint32_t wanted = number < 3 ? 2 : 1;
    made->count = filter->max_inputs < wanted ? filter->max_inputs : wanted;
    if (made->count < filter->min_inputs) {
        made->count = filter->min_inputs;
    }
    if (made->count > MOST_INPUTS) {
        fprintf(stderr, "%s wants %u inputs, and here are at most %d\n", filter->id, filter->min_inputs, MOST_INPUTS);
        exit(2);
    }
    for (uint32_t k = 0; k < made->count; ++k) {
        const uint32_t last = filter->input_kind_count - 1;
        made->inputs[k].struct_size = sizeof made->inputs[k];
        made->inputs[k].kind = filter->input_kinds[k < last ? k : last];
        if (made->inputs[k].kind == GUSSET_KIND_CURVES) {
            make_curves(made, k, number, size);
        } else if (number == 5 && k > 0) {
            make_box(made, k);
        } else {
            make_mesh(made, k, number % 3, size);
        }
    }
}

void shapes_free(shapes *made) {
    for (uint32_t k = 0; k < made->count; ++k) {
        for (int m = 0; m < 3; ++m) {
            free(made->memory[k][m]);
        }
    }
    made->count = 0;
}
