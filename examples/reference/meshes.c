/* Meshes: the version, contexts, loops, tables, checks, welding, sewing, orientation. */
#include "example.h"

/* An open pyramid: apex 0, rim 1 2 3 4, faces counter-clockwise from outside. */
static const double points[5][3] = {{0, 0, 2}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
static const uint32_t corners[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
static const gusset_mesh_view pyramid = {.struct_size = sizeof(gusset_mesh_view),
                                         .positions = points,
                                         .vertex_count = 5,
                                         .face_corners = corners,
                                         .face_count = 4,
                                         .scalar = GUSSET_F64,
                                         .face_size = 3};

//! [version]
static void what_is_loaded(void) {
    /* A library of another interface than the header's would be misunderstood. */
    HOLDS(gusset_abi() == 1);
    HOLDS(strcmp(gusset_version(), GUSSET_VERSION_STRING) == 0);
    HOLDS(strlen(gusset_status_text(GUSSET_ERROR_NO_LOOP)) > 0);
    HOLDS(strcmp(gusset_status_text(-1), "unknown status") == 0);
}
//! [version]

//! [context]
static int progress(void *user, double fraction, const char *stage) {
    (void)fraction, (void)stage;
    ++*(int *)user;
    return 0; /* anything else cancels the call */
}

static void log_to(void *user, const char *message) {
    fprintf(user, "gusset: %s\n", message);
}

static void a_context(void) {
    gusset_context *context = NULL;
    gusset_boundary *boundary = NULL;
    gusset_error_report report = {.struct_size = sizeof report};
    gusset_mesh_view wrong = pyramid;
    const uint32_t beyond[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 9};
    int steps = 0;

    MUST(gusset_context_create(&context));
    MUST(gusset_context_set_threads(context, 2));
    MUST(gusset_context_set_progress(context, progress, &steps));
    MUST(gusset_context_set_log(context, log_to, stderr));
    MUST(gusset_boundary_create(context, &pyramid, NULL, &boundary));
    gusset_boundary_destroy(boundary);
    HOLDS(steps > 0 && gusset_context_get_progress(context) == 1.0);

    /* The error, for people and for programs. */
    wrong.face_corners = beyond;
    HOLDS(gusset_boundary_create(context, &wrong, NULL, &boundary) == GUSSET_ERROR_INDEX_OUT_OF_RANGE);
    HOLDS(strlen(gusset_context_get_message(context)) > 0);
    MUST(gusset_context_get_report(context, &report));
    HOLDS(report.element == GUSSET_ELEMENT_HALF_EDGE && report.index == 11 && report.value == 9.0);

    /* A cancel, which may come from another thread, holds until it is taken back. */
    gusset_context_cancel(context);
    HOLDS(gusset_boundary_create(context, &pyramid, NULL, &boundary) == GUSSET_ERROR_CANCELLED && boundary == NULL);
    gusset_context_reset(context);
    MUST(gusset_boundary_create(context, &pyramid, NULL, &boundary));
    gusset_boundary_destroy(boundary);
    gusset_context_destroy(context);
}
//! [context]

//! [view]
static void views_of_arrays(void) {
    /* Triangles, quads and polygons, in single and in double precision: a square in each way. */
    const float narrow[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const double wide[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const uint32_t triangles[6] = {0, 1, 2, 0, 2, 3}, quad[4] = {0, 1, 2, 3}, offsets[2] = {0, 4};
    const gusset_mesh_view views[6] = {
        gusset_triangles_f32(narrow[0], 4, triangles, 2),    gusset_triangles_f64(wide[0], 4, triangles, 2),
        gusset_quads_f32(narrow[0], 4, quad, 1),             gusset_quads_f64(wide[0], 4, quad, 1),
        gusset_polygons_f32(narrow[0], 4, offsets, quad, 1), gusset_polygons_f64(wide[0], 4, offsets, quad, 1)};
    size_t k;

    for (k = 0; k < 6; ++k) {
        gusset_check_view found = {.struct_size = sizeof found};
        gusset_check *check = NULL;
        MUST(gusset_check_create(NULL, &views[k], &check));
        MUST(gusset_check_get_view(check, &found));
        HOLDS(found.face_count == (k < 2 ? 2 : 1) && found.boundary_edges.count == 4);
        gusset_check_destroy(check);
    }
}
//! [view]

//! [boundary]
static void loops(void) {
    gusset_boundary *boundary = NULL;
    gusset_boundary_view all = {.struct_size = sizeof all};
    gusset_loop_view loop = {.struct_size = sizeof loop};
    size_t i;

    MUST(gusset_boundary_create(NULL, &pyramid, NULL, &boundary));
    MUST(gusset_boundary_get_view(boundary, &all));
    HOLDS(all.loop_count == 1 && all.walk_count == 1);
    for (i = 0; i < all.loop_count; ++i) {
        MUST(gusset_boundary_get_loop(boundary, i, &loop));
        HOLDS(loop.flags == 0 && loop.vertices.count == 4 && about(loop.length, 4.0 * sqrt(2.0)));
    }
    /* The mesh lacks defects. */
    HOLDS(all.defect_count == 0);
    gusset_boundary_destroy(boundary);
}
//! [boundary]

//! [winged]
static void tables(void) {
    gusset_winged *winged = NULL;
    gusset_winged_view view = {.struct_size = sizeof view};
    gusset_winged_faces *faces = NULL;
    gusset_winged_faces_view read = {.struct_size = sizeof read};
    size_t i;

    MUST(gusset_winged_create(NULL, &pyramid, NULL, &winged));
    MUST(gusset_winged_get_view(winged, &view));
    HOLDS(view.edge_count == 8 && view.loop_edges.count == 4);
    for (i = 0; i < view.loop_edges.count; ++i) {
        const gusset_winged_edge *edge = &view.edges[view.loop_edges.data[i]];
        HOLDS((edge->left == UINT32_MAX) != (edge->right == UINT32_MAX));
    }
    /* And back: what a mesh view needs beside its positions. */
    MUST(gusset_winged_faces_create(NULL, view.edges, view.edge_count, pyramid.vertex_count, &view.edge_of_face, NULL,
                                    &faces));
    MUST(gusset_winged_faces_get_view(faces, &read));
    HOLDS(read.face_offsets.count == pyramid.face_count + 1);
    HOLDS(memcmp(read.face_corners.data, pyramid.face_corners, read.face_corners.count * sizeof(uint32_t)) == 0);
    gusset_winged_faces_destroy(faces);
    gusset_winged_destroy(winged);
}
//! [winged]

//! [check]
static void what_is_wrong(void) {
    gusset_check *check = NULL;
    gusset_check_view report = {.struct_size = sizeof report};

    MUST(gusset_check_create(NULL, &pyramid, &check));
    MUST(gusset_check_get_view(check, &report));
    HOLDS(report.euler == 1 && report.boundary_edges.count == 4 && report.degenerate_faces.count == 0);
    HOLDS((report.properties & GUSSET_MESH_MANIFOLD) && !(report.properties & GUSSET_MESH_CLOSED));
    gusset_check_destroy(check);
}
//! [check]

//! [certificate]
static void what_was_kept(void) {
    /* The pyramid filled: its four faces are kept, and two close its rim. */
    gusset_mesh_view filled = {.struct_size = sizeof filled};
    gusset_certificate_view facts = {.struct_size = sizeof facts};
    gusset_result *fill = NULL;
    gusset_certificate *certificate = NULL;

    MUST(gusset_fill(NULL, &pyramid, NULL, 0, NULL, &fill));
    MUST(gusset_result_get_mesh(fill, &filled));
    MUST(gusset_certificate_create(NULL, &pyramid, 1, &filled, &certificate));
    MUST(gusset_certificate_get_view(certificate, &facts));
    HOLDS(facts.closed && facts.outward && facts.non_manifold_vertices == 0 && facts.intersecting_pairs == 0);
    HOLDS(facts.kept_faces == 4 && facts.new_faces == 2 && facts.lost_faces.count == 0);
    HOLDS(facts.farthest_distance == 0.0 && facts.farthest_vertex == UINT32_MAX);
    gusset_certificate_destroy(certificate);
    gusset_result_destroy(fill);
}
//! [certificate]

//! [weld]
static void a_soup_of_triangles(void) {
    /* Each face with corners of its own, as STL files have them. */
    double soup[12][3];
    uint32_t own[12];
    gusset_mesh_view mesh = pyramid, welded = {.struct_size = sizeof welded};
    gusset_weld_report parts = {.struct_size = sizeof parts};
    gusset_result *weld = NULL;
    uint32_t h;

    for (h = 0; h < 12; ++h) {
        memcpy(soup[h], points[corners[h]], sizeof soup[h]);
        own[h] = h;
    }
    mesh.positions = soup, mesh.vertex_count = 12, mesh.face_corners = own;
    MUST(gusset_weld(NULL, &mesh, NULL, &weld));
    MUST(gusset_result_get_mesh(weld, &welded));
    MUST(gusset_result_get_weld(weld, &parts));
    HOLDS(welded.vertex_count == 5 && welded.face_count == 4);
    HOLDS(parts.welded_vertices == 7 && parts.sewn_edges == 4 && parts.vertex_map.data[11] == parts.vertex_map.data[1]);
    gusset_result_destroy(weld);
}
//! [weld]

//! [sew]
static void borders_that_do_not_match(void) {
    /* One triangle on the upper side of an edge, two on its lower side: vertex 3 lies inside the edge 0 1. */
    static const double places[7][2] = {{0, 0}, {4, 0}, {2, 3}, {1, 0}, {0, 0}, {4, 0}, {2, -3}};
    static const uint32_t faces[9] = {0, 1, 2, 4, 6, 3, 3, 6, 5};
    double flat[7][3] = {{0}};
    gusset_mesh_view mesh = pyramid, sewn = {.struct_size = sizeof sewn};
    gusset_sew_report parts = {.struct_size = sizeof parts};
    gusset_result *sew = NULL;
    uint32_t v;

    for (v = 0; v < 7; ++v) {
        memcpy(flat[v], places[v], sizeof places[v]);
    }
    mesh.positions = flat, mesh.vertex_count = 7, mesh.face_corners = faces, mesh.face_count = 3;
    MUST(gusset_sew(NULL, &mesh, NULL, &sew));
    MUST(gusset_result_get_mesh(sew, &sewn));
    MUST(gusset_result_get_sew(sew, &parts));
    HOLDS(sewn.vertex_count == 5 && sewn.face_count == 4);
    HOLDS(parts.splits == 1 && parts.sewn_edges == 2 && parts.left_vertices.count == 0);
    /* The first old face is the first two now. */
    HOLDS(parts.face_origin.data[1] == 0 && parts.face_map.data[1] == 2);
    gusset_result_destroy(sew);
}
//! [sew]

//! [solid]
static void a_tetrahedron_with_a_copy_and_a_hole(void) {
    const double four[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 1, 0, 3, 2};
    const gusset_mesh_view mesh = {.struct_size = sizeof mesh, .positions = four, .vertex_count = 4, .scalar = GUSSET_F64,
                                   .face_corners = faces, .face_count = 4, .face_size = 3};
    gusset_repair_report report = {.struct_size = sizeof report};
    gusset_result *repaired = NULL;

    MUST(gusset_repair(NULL, &mesh, NULL, &repaired));
    MUST(gusset_result_get_repair(repaired, &report));
    /* Face 2 has the vertices of face 1. The fourth side was open. */
    HOLDS(report.valid == 1 && report.filled_holes == 1 && report.face_origin.count == 4);
    HOLDS(report.dropped_count == 1 && report.dropped_faces.data[0] == 2 && report.drop_reasons[0] == GUSSET_DROP_DUPLICATE);
    gusset_result_destroy(repaired);
}
//! [solid]

//! [union]
static void one_solid_of_two(void) {
    const double four[4][3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
    const double higher[4][3] = {{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}, {0.5, 1.5, 0.5}, {0.5, 0.5, 4.5}};
    const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    gusset_mesh_view pieces[2] = {{.struct_size = sizeof *pieces, .positions = four, .vertex_count = 4, .scalar = GUSSET_F64,
                                   .face_corners = faces, .face_count = 4, .face_size = 3}};
    gusset_repair_report report = {.struct_size = sizeof report};
    gusset_result *united = NULL;

    pieces[1] = pieces[0];
    pieces[1].positions = higher;
    MUST(gusset_unite(NULL, pieces, 2, &united));
    MUST(gusset_result_get_repair(united, &report));
    /* The first face of the second piece lies inside the first piece. */
    HOLDS(report.valid == 1 && report.dropped_count == 1 && report.dropped_faces.data[0] == 4);
    gusset_result_destroy(united);
}
//! [union]

//! [orient]
static void a_face_turned_over(void) {
    const uint32_t mixed[12] = {0, 1, 2, 0, 2, 3, 0, 4, 3, 0, 4, 1};
    gusset_mesh_view mesh = pyramid, oriented = {.struct_size = sizeof oriented};
    gusset_orient_report parts = {.struct_size = sizeof parts};
    gusset_result *orient = NULL;

    mesh.face_corners = mixed;
    MUST(gusset_orient(NULL, &mesh, NULL, &orient));
    MUST(gusset_result_get_mesh(orient, &oriented));
    MUST(gusset_result_get_orient(orient, &parts));
    HOLDS(parts.turned_faces == 1 && parts.turned[2] == 1 && parts.one_sided_faces.count == 0);
    HOLDS(memcmp(oriented.face_corners, corners, sizeof corners) == 0);
    gusset_result_destroy(orient);
}
//! [orient]

//! [triangulate]
static void a_u_in_triangles(void) {
    const double outline[8][3] = {{0, 0, 0}, {5, 0, 0}, {5, 4, 0}, {4, 4, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}};
    const uint32_t face[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    const gusset_mesh_view u = {.struct_size = sizeof u, .positions = outline, .vertex_count = 8, .scalar = GUSSET_F64,
                                .face_corners = face, .face_count = 1, .face_size = 8};
    gusset_mesh_view view = {.struct_size = sizeof view};
    gusset_result *triangles = NULL;
    double area = 0;

    MUST(gusset_triangulate(NULL, &u, &triangles));
    MUST(gusset_result_get_mesh(triangles, &view));
    for (size_t f = 0; f < view.face_count; ++f) {
        const uint32_t *of = (const uint32_t *)view.face_corners + 3 * f;
        const double *a = outline[of[0]], *b = outline[of[1]], *c = outline[of[2]];
        area += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
    HOLDS(view.face_count == 6 && area == 11);
    gusset_result_destroy(triangles);
}
//! [triangulate]

int main(void) {
    what_is_loaded();
    a_context();
    views_of_arrays();
    loops();
    tables();
    what_is_wrong();
    what_was_kept();
    a_soup_of_triangles();
    borders_that_do_not_match();
    a_tetrahedron_with_a_copy_and_a_hole();
    one_solid_of_two();
    a_face_turned_over();
    a_u_in_triangles();
    return 0;
}
