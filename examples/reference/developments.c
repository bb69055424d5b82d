/* Developments: surfaces laid out in the plane. */
#include "example.h"

#define ROUND 16
#define ROWS 5

/* A tube of plane strips, with this radius at height z. */
typedef struct tube {
    double points[ROWS * ROUND][3];
    uint32_t corners[(ROWS - 1) * ROUND][4];
} tube;

static gusset_mesh_view shape(tube *made, double low, double high, double bulge) {
    uint32_t i, j;

    for (i = 0; i < ROWS; ++i) {
        const double z = 1.0 * i / (ROWS - 1), radius = low + (high - low) * z + bulge * z * (1.0 - z);
        for (j = 0; j < ROUND; ++j) {
            double *p = made->points[ROUND * i + j];
            p[0] = radius * cos(2.0 * pi * j / ROUND), p[1] = radius * sin(2.0 * pi * j / ROUND), p[2] = 2.0 * z;
        }
    }
    for (i = 0; i + 1 < ROWS; ++i) {
        for (j = 0; j < ROUND; ++j) {
            const uint32_t next = (j + 1) % ROUND;
            uint32_t *face = made->corners[ROUND * i + j];
            face[0] = ROUND * i + j, face[1] = ROUND * i + next;
            face[2] = ROUND * (i + 1) + next, face[3] = ROUND * (i + 1) + j;
        }
    }
    return gusset_quads_f64(made->points[0], ROWS * ROUND, made->corners[0], (ROWS - 1) * ROUND);
}

//! [develop]
static void a_lampshade_from_paper(void) {
    tube cone;
    gusset_mesh_view mesh = shape(&cone, 1.0, 0.4, 0.0), flat = {.struct_size = sizeof flat};
    gusset_develop_report laid = {.struct_size = sizeof laid};
    gusset_result *development = NULL;
    gusset_origins *origins = NULL;
    gusset_origins_view from = {.struct_size = sizeof from};
    size_t f;

    MUST(gusset_develop(NULL, &mesh, NULL, &development));
    MUST(gusset_result_get_develop(development, &laid));
    /* One piece, opened along the shortest path from rim to rim; every edge has its length. */
    HOLDS(laid.chart_count == 1 && laid.charts[0].finish == GUSSET_CHART_EXACT && laid.charts[0].overlaps == 0);
    HOLDS(laid.cut_edges.count == 2 * (ROWS - 1) && laid.cut_kinds.data[0] == GUSSET_CUT_OPENING);
    HOLDS(about(laid.charts[0].area, laid.charts[0].flat_area) && about(laid.charts[0].energy, 4.0));
    HOLDS(laid.vertex_map.count == mesh.vertex_count + ROWS);
    for (f = 0; f < mesh.face_count; ++f) {
        HOLDS(about(laid.stretches[2 * f], 1.0) && about(laid.stretches[2 * f + 1], 1.0));
    }

    /* The same as a mesh, for whatever takes one. */
    MUST(gusset_result_get_mesh(development, &flat));
    HOLDS(flat.vertex_count == laid.vertex_map.count && flat.face_count == mesh.face_count);

    /* Values of the surface are carried over by where its parts went. */
    MUST(gusset_result_origins_create(NULL, development, &origins));
    MUST(gusset_origins_get_view(origins, GUSSET_DOMAIN_VERTICES, &from));
    HOLDS(from.offsets.count == flat.vertex_count + 1 && from.sources.data[0] == laid.vertex_map.data[0]);
    gusset_origins_destroy(origins);
    gusset_result_destroy(development);
}
//! [develop]

//! [darts]
static void a_barrel_with_darts(void) {
    tube barrel;
    gusset_mesh_view mesh = shape(&barrel, 1.0, 1.0, 1.6);
    /* Cut where the maker wants the seam: the ends of a path are enough. */
    const uint32_t seam[2] = {0, (ROWS - 1) * ROUND}, ends[2] = {0, 2};
    gusset_develop_options options = {
        .struct_size = sizeof options, .cuts = {seam, 2}, .cut_offsets = {ends, 2}, .max_stretch = 1.05};
    gusset_develop_report laid = {.struct_size = sizeof laid};
    gusset_result *development = NULL;
    double before;

    MUST(gusset_develop(NULL, &mesh, &options, &development));
    MUST(gusset_result_get_develop(development, &laid));
    HOLDS(laid.charts[0].finish == GUSSET_CHART_CONVERGED && laid.charts[0].folds == 0 && laid.darts == 0);
    HOLDS(laid.cut_kinds.data[0] == GUSSET_CUT_GIVEN && laid.charts[0].max_stretch > 1.05);
    before = laid.charts[0].energy;
    gusset_result_destroy(development);

    /* Each dart lets some of the curvature go. */
    options.max_darts = 4;
    MUST(gusset_develop(NULL, &mesh, &options, &development));
    MUST(gusset_result_get_develop(development, &laid));
    HOLDS(laid.darts > 0 && laid.charts[0].energy < before && laid.charts[0].folds == 0);
    gusset_result_destroy(development);
}
//! [darts]

int main(void) {
    a_lampshade_from_paper();
    a_barrel_with_darts();
    return 0;
}
