/* Sections: meshes cut by planes into outlines. */
#include "example.h"

#define ROUND 48
#define ACROSS 24

/* A tyre around the z axis: radius 2, and 1 across the tube. */
typedef struct tyre {
    double points[ROUND * ACROSS][3];
    uint32_t corners[ROUND * ACROSS][4];
} tyre;

static gusset_mesh_view shape(tyre *made) {
    uint32_t i, j;

    for (i = 0; i < ROUND; ++i) {
        for (j = 0; j < ACROSS; ++j) {
            const double s = 2.0 * pi * i / ROUND, t = 2.0 * pi * j / ACROSS, radius = 2.0 + cos(t);
            const uint32_t a = (i + 1) % ROUND, b = (j + 1) % ACROSS;
            double *p = made->points[ACROSS * i + j];
            uint32_t *face = made->corners[ACROSS * i + j];
            p[0] = radius * cos(s), p[1] = radius * sin(s), p[2] = sin(t);
            face[0] = ACROSS * i + j, face[1] = ACROSS * a + j, face[2] = ACROSS * a + b, face[3] = ACROSS * i + b;
        }
    }
    return gusset_quads_f64(made->points[0], ROUND * ACROSS, made->corners[0], ROUND * ACROSS);
}

//! [sections]
static void outlines_of_a_tyre(void) {
    tyre rubber;
    gusset_mesh_view mesh = shape(&rubber);
    const double heights[3] = {-0.3, 0.1, 0.6};
    const gusset_cutting_planes planes = {.struct_size = sizeof planes,
                                          .kind = GUSSET_CUTTING_STACK,
                                          .direction = {0, 0, 1},
                                          .values = heights,
                                          .value_count = 3};
    gusset_mesh_section_options options = {.struct_size = sizeof options};
    gusset_mesh_sections *sections = NULL;
    gusset_mesh_sections_view found = {.struct_size = sizeof found};
    gusset_origins *origins = NULL;
    gusset_origins_view from = {.struct_size = sizeof from};
    size_t k, i, all_points;

    MUST(gusset_mesh_sections_create(NULL, &mesh, &planes, &options, &sections));
    MUST(gusset_mesh_sections_get_view(sections, &found));
    HOLDS(found.plane_count == 3 && found.path_count == 6 && found.starts.count == 7);
    for (k = 0; k < found.path_count; ++k) {
        /* The outer outline is counter-clockwise, the outline of the hole clockwise and inside it. */
        const gusset_section_path *path = &found.paths[k];
        HOLDS(path->plane == k / 2 && path->closed && path->length > 6.0);
        HOLDS(path->depth == 0 ? path->area > 0.0 && path->parent == UINT32_MAX
                               : path->area < 0.0 && found.paths[path->parent].plane == path->plane);
    }
    for (k = 0; k < found.point_count; ++k) {
        /* Each point is on an edge, at its parameter. */
        const double *p = rubber.points[found.edges[2 * k]], *q = rubber.points[found.edges[2 * k + 1]];
        for (i = 0; i < 3; ++i) {
            HOLDS(about(found.points[3 * k + i], p[i] + found.parameters[k] * (q[i] - p[i])));
        }
        HOLDS(found.faces.data[k] < mesh.face_count);
    }

    /* Values of the vertices are carried over to the points, values of the faces to the segments. */
    MUST(gusset_mesh_sections_origins_create(NULL, sections, &origins));
    MUST(gusset_origins_get_view(origins, GUSSET_DOMAIN_VERTICES, &from));
    HOLDS(from.offsets.count == found.point_count + 1 && from.sources.data[0] == found.edges[0]);
    gusset_origins_destroy(origins);
    all_points = found.point_count;
    gusset_mesh_sections_destroy(sections);

    /* As few points as a tolerance permits, for an outline through them. */
    options.tolerance = 0.1;
    MUST(gusset_mesh_sections_create(NULL, &mesh, &planes, &options, &sections));
    MUST(gusset_mesh_sections_get_view(sections, &found));
    HOLDS(found.path_count == 6 && 2 * found.point_count < all_points);
    gusset_mesh_sections_destroy(sections);
}
//! [sections]

//! [planes]
static size_t count_outlines(const gusset_mesh_view *mesh, const gusset_cutting_planes *planes, double *area) {
    gusset_mesh_sections *sections = NULL;
    gusset_mesh_sections_view found = {.struct_size = sizeof found};
    size_t k, count;

    MUST(gusset_mesh_sections_create(NULL, mesh, planes, NULL, &sections));
    MUST(gusset_mesh_sections_get_view(sections, &found));
    for (*area = 0.0, k = 0; k < found.path_count; ++k) {
        *area += found.paths[k].area;
    }
    count = found.path_count;
    gusset_mesh_sections_destroy(sections);
    return count;
}

static void planes_of_each_kind(void) {
    tyre rubber;
    const gusset_mesh_view mesh = shape(&rubber);
    /* The polygon of the tube. */
    const double tube = ACROSS / 2.0 * sin(2.0 * pi / ACROSS);
    /* About the axis: each plane meets the tube on both sides of the axis. */
    const double angles[2] = {0.0, pi / 2.0};
    const gusset_cutting_planes about_axis = {.struct_size = sizeof about_axis,
                                              .kind = GUSSET_CUTTING_AXIS,
                                              .direction = {0, 0, 1},
                                              .reference = {1, 0, 0},
                                              .values = angles,
                                              .value_count = 2};
    /* Across a curve: here a half circle along the middle of the tube, and planes across both of its ends. */
    double curve[ROUND / 2 + 1][3];
    double ends[2] = {0.0, 0.0};
    gusset_cutting_planes across = {.struct_size = sizeof across,
                                    .kind = GUSSET_CUTTING_CURVE,
                                    .values = ends,
                                    .value_count = 2,
                                    .points = curve[0],
                                    .point_count = ROUND / 2 + 1};
    /* In any position: one beside the tyre, and one through it. */
    const double points[2][3] = {{9, 0, 0}, {0, 0, 0}}, normals[2][3] = {{1, 0, 0}, {0, 1, 0}};
    const gusset_cutting_planes each = {.struct_size = sizeof each,
                                        .kind = GUSSET_CUTTING_PLANES,
                                        .points = points[0],
                                        .normals = normals[0],
                                        .point_count = 2};
    double area;
    uint32_t k;

    HOLDS(count_outlines(&mesh, &about_axis, &area) == 4 && about(area, 4.0 * tube));
    for (k = 0; k <= ROUND / 2; ++k) {
        curve[k][0] = 2.0 * cos(2.0 * pi * k / ROUND), curve[k][1] = 2.0 * sin(2.0 * pi * k / ROUND), curve[k][2] = 0.0;
        ends[1] += k > 0 ? 4.0 * sin(pi / ROUND) : 0.0;
    }
    ends[1] *= 1.0 - 1e-12;
    HOLDS(count_outlines(&mesh, &across, &area) == 4);
    HOLDS(count_outlines(&mesh, &each, &area) == 2 && about(area, 2.0 * tube));
}
//! [planes]

int main(void) {
    outlines_of_a_tyre();
    planes_of_each_kind();
    return 0;
}
