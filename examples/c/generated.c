/* Needs nothing but the library: makes two open shells with wavy rims, stitches them, and writes left.obj,
 * right.obj and after.obj. */
#include <gusset.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { RINGS = 24 };

/* Part of a sphere from its pole down to a wavy rim near the equator; `sides` vertices on each ring. */
typedef struct {
    double points[1 + RINGS * 100][3];
    uint32_t corners[6 * RINGS * 100];
    gusset_mesh_view view;
} shell;

static void make_shell(shell *s, uint32_t sides, double up) {
    const double turn = 6.283185307179586;
    uint32_t ring, i, *corner = s->corners;
    size_t k = 1;
    s->points[0][0] = s->points[0][1] = 0.0;
    s->points[0][2] = up;
    for (ring = 1; ring <= RINGS; ++ring) {
        for (i = 0; i < sides; ++i, ++k) {
            const double longitude = up * turn * i / sides;
            const double rim = 1.45 + 0.06 * sin(5.0 * longitude) + 0.01 * (i % 3);
            const double polar = rim * ring / RINGS;
            s->points[k][0] = sin(polar) * cos(longitude);
            s->points[k][1] = sin(polar) * sin(longitude);
            s->points[k][2] = up * cos(polar);
        }
    }
    for (i = 0; i < sides; ++i) {
        *corner++ = 0, *corner++ = 1 + i, *corner++ = 1 + (i + 1) % sides;
    }
    for (ring = 0; ring + 1 < RINGS; ++ring) {
        for (i = 0; i < sides; ++i) {
            const uint32_t a = 1 + ring * sides + i, b = 1 + ring * sides + (i + 1) % sides;
            *corner++ = a, *corner++ = a + sides, *corner++ = b + sides;
            *corner++ = a, *corner++ = b + sides, *corner++ = b;
        }
    }
    s->view = gusset_triangles_f64(s->points[0], k, s->corners, (size_t)(corner - s->corners) / 3);
}

/* Writes a mesh of double positions as an OBJ file. */
static void write_mesh(const char *path, const gusset_mesh_view *mesh) {
    FILE *file = fopen(path, "w");
    const double *p = mesh->positions;
    const uint32_t *offsets = mesh->face_offsets, *corners = mesh->face_corners;
    size_t f, v;
    if (!file) {
        perror(path);
        exit(1);
    }
    for (v = 0; v < mesh->vertex_count; ++v, p += 3) {
        fprintf(file, "v %.17g %.17g %.17g\n", p[0], p[1], p[2]);
    }
    for (f = 0; f < mesh->face_count; ++f) {
        size_t h = offsets ? offsets[f] : f * mesh->face_size;
        const size_t end = offsets ? offsets[f + 1] : h + mesh->face_size;
        fprintf(file, "f");
        for (; h < end; ++h) {
            fprintf(file, " %lu", (unsigned long)corners[h] + 1);
        }
        fprintf(file, "\n");
    }
    if (fclose(file) != 0) {
        perror(path);
        exit(1);
    }
}

static void check(gusset_status status, const gusset_context *context) {
    if (status != GUSSET_OK) {
        fprintf(stderr, "%s: %s\n", gusset_status_text(status), gusset_context_get_message(context));
        exit(1);
    }
}

int main(void) {
    static shell north, south;
    gusset_context *context = NULL;
    gusset_result *stitch = NULL;
    gusset_mesh_view whole = {0};
    gusset_quality_report quality = {0};
    make_shell(&north, 100, 1.0);
    make_shell(&south, 73, -1.0);
    write_mesh("left.obj", &north.view);
    write_mesh("right.obj", &south.view);

    check(gusset_context_create(&context), NULL);
    check(gusset_stitch(context, &north.view, NULL, &south.view, NULL, NULL, &stitch), context);
    whole.struct_size = sizeof whole;
    quality.struct_size = sizeof quality;
    check(gusset_result_get_mesh(stitch, &whole), NULL);
    check(gusset_result_get_quality(stitch, &quality), NULL);
    write_mesh("after.obj", &whole);
    printf("two shells of %lu and %lu faces, stitched: %lu faces, %u boundary loops left, area of the strip %g\n",
           (unsigned long)north.view.face_count, (unsigned long)south.view.face_count, (unsigned long)whole.face_count,
           (unsigned)quality.loops_left, quality.area);

    gusset_result_destroy(stitch);
    gusset_context_destroy(context);
    return quality.loops_left != 0 || quality.orientation_conflicts != 0;
}
