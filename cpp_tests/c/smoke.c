/* The whole way in pure C99: two open pyramids become a closed octahedron-like solid. */
#include "check.h"
#include <math.h>

static void layouts(void) {
    CHECK(sizeof(gusset_status) == 4);
    CHECK(strcmp(gusset_version(), GUSSET_VERSION_STRING) == 0);
    CHECK(gusset_abi() == 1);
    if (sizeof(void *) == 8) {
        CHECK(sizeof(gusset_indices) == 16);
        CHECK(sizeof(gusset_mesh_view) == 80 && offsetof(gusset_mesh_view, merge) == 72);
        CHECK(sizeof(gusset_boundary_options) == 16 && sizeof(gusset_boundary_view) == 40);
        CHECK(sizeof(gusset_loop_view) == 80 && offsetof(gusset_loop_view, length) == 64);
        CHECK(sizeof(gusset_defect) == 16);
        CHECK(sizeof(gusset_error_report) == 40 && offsetof(gusset_error_report, value) == 24);
        CHECK(sizeof(gusset_stitch_options) == 104 && offsetof(gusset_stitch_options, search) == 72);
        CHECK(sizeof(gusset_stitch_report) == 232 && offsetof(gusset_stitch_report, turned) == 184);
        CHECK(offsetof(gusset_stitch_options, tolerance) == 48 && offsetof(gusset_stitch_options, arc_b) == 64);
        CHECK(sizeof(gusset_facing_options) == 32 && offsetof(gusset_facing_options, tolerance) == 16);
        CHECK(sizeof(gusset_facing_view) == 184 && offsetof(gusset_facing_view, taken) == 152);
        CHECK(sizeof(gusset_winged_options) == 16 && sizeof(gusset_winged_faces_view) == 56);
        CHECK(sizeof(gusset_strip_options) == 40 && sizeof(gusset_strip_report) == 80);
        CHECK(sizeof(gusset_join_options) == 112 && offsetof(gusset_join_options, max_gap) == 32);
        CHECK(sizeof(gusset_join_report) == 256 && offsetof(gusset_join_report, loops_left) == 144);
        CHECK(sizeof(gusset_joint) == 104 && offsetof(gusset_joint, outcome) == 92);
        CHECK(sizeof(gusset_left_loop) == 40 && sizeof(gusset_piece_map) == 32 && sizeof(gusset_loop_pair) == 16);
        CHECK(sizeof(gusset_alignment_options) == 48 && offsetof(gusset_alignment_options, max_distance) == 32);
        CHECK(sizeof(gusset_alignment_view) == 48 && sizeof(gusset_aligned_piece) == 112 && sizeof(gusset_overlap) == 56);
        CHECK(sizeof(gusset_trim_options) == 48 && offsetof(gusset_trim_options, viewpoints) == 24);
        CHECK(sizeof(gusset_trim_view) == 32 && sizeof(gusset_trimmed_piece) == 24);
        CHECK(sizeof(gusset_winged_edge) == 36 && offsetof(gusset_winged_edge, marks) == 32);
        CHECK(sizeof(gusset_winged_view) == 120 && offsetof(gusset_winged_view, loop_offsets) == 104);
        CHECK(sizeof(gusset_check_view) == 192 && offsetof(gusset_check_view, unused_vertices) == 176);
        CHECK(sizeof(gusset_cutting_planes) == 128 && offsetof(gusset_cutting_planes, values) == 88);
        CHECK(sizeof(gusset_mesh_section_options) == 24 && sizeof(gusset_section_path) == 32);
        CHECK(sizeof(gusset_mesh_sections_view) == 96 && offsetof(gusset_mesh_sections_view, faces) == 80);
        CHECK(sizeof(gusset_quality_report) == 56 && offsetof(gusset_quality_report, loops_left) == 44);
    }
}

static void loop_of_a_pyramid(void) {
    const gusset_mesh_view mesh = pyramid(pyramid_up);
    gusset_boundary *boundary = NULL;
    gusset_loop_view loop = {sizeof loop, {NULL, 0}, {NULL, 0}, {NULL, 0}, NULL, 0.0, 0, 0};
    size_t i;

    EXPECT(GUSSET_OK, gusset_boundary_create(NULL, &mesh, NULL, &boundary));
    CHECK(loops_of(boundary).loop_count == 1 && loops_of(boundary).walk_count == 1);
    EXPECT(GUSSET_OK, gusset_boundary_get_loop(boundary, 0, &loop));
    CHECK(loop.struct_size == sizeof loop && loop.flags == 0 && loop.vertices.count == 4 && loop.half_edges.count == 4);
    for (i = 0; i < 4 && i < loop.vertices.count; ++i) {
        const uint32_t h = loop.half_edges.data[i];
        CHECK(loop.faces.data[i] == h / 3 && loop.edge_flags[i] == 0);
        /* The loop runs as the face does: the surface is on its left. */
        CHECK(pyramid_faces[h] == loop.vertices.data[i]);
        CHECK(loop.vertices.data[(i + 1) % 4] == loop.vertices.data[i] % 4 + 1);
    }
    CHECK(loop.length > 5.656854 && loop.length < 5.656855);
    CHECK(loops_of(boundary).defects == NULL && loops_of(boundary).defect_count == 0);
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_boundary_get_loop(boundary, 1, &loop));
    CHECK(loop.vertices.data == NULL && loop.struct_size == sizeof loop);
    gusset_boundary_destroy(boundary);
}

static void stitch_two_pyramids(gusset_context *context) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    const uint32_t rim[4] = {3, 2, 1, 4};
    const gusset_indices loop = {rim, 4};
    gusset_stitch_options options = {0};
    gusset_mesh_view whole = {sizeof whole, NULL, 0, 0, NULL, NULL, 0, 0, 0, 0, 0, NULL}, strip = whole;
    gusset_stitch_report parts;
    gusset_quality_report quality;
    gusset_result *stitch = NULL;
    int round;

    options.struct_size = sizeof options;
    options.meridians = GUSSET_MERIDIANS_INDEX;
    options.orientation = GUSSET_ORIENTATION_REFUSE;
    for (round = 0; round < 2; ++round) {
        if (round == 0) {
            EXPECT(GUSSET_OK, gusset_stitch(context, &up, NULL, &down, NULL, NULL, &stitch));
        } else {
            EXPECT(GUSSET_OK, gusset_stitch(context, &up, &loop, &down, &loop, &options, &stitch));
        }
        EXPECT(GUSSET_OK, gusset_result_get_mesh(stitch, &whole));
        CHECK(whole.vertex_count == 10 && whole.face_count == 16 && whole.scalar == GUSSET_F64);
        CHECK(memcmp(whole.positions, pyramid_up, sizeof pyramid_up) == 0);
        EXPECT(GUSSET_OK, gusset_result_get_strip_mesh(stitch, &strip));
        CHECK(strip.vertex_count == 8 && strip.face_count == 8);

        memset(&parts, 0, sizeof parts);
        parts.struct_size = sizeof parts;
        EXPECT(GUSSET_OK, gusset_result_get_stitch(stitch, &parts));
        CHECK(parts.vertex_map[0].count == 5 && parts.vertex_map[1].count == 5 && parts.vertex_map[1].data[0] == 5);
        CHECK(parts.face_map[0].count == 4 && parts.face_map[1].data[3] == 7);
        CHECK(parts.rim[0].count == 4 && parts.rim[1].count == 4 && parts.turned == 0);
        CHECK(parts.strip_face_first == 8 && parts.strip_face_count == 8);
        CHECK(parts.meridians.count >= 10 && parts.meridians.data[0] == 0 && parts.meridians.data[1] == 0);
        CHECK(parts.meridians.data[parts.meridians.count - 1] == 4);

        memset(&quality, 0, sizeof quality);
        quality.struct_size = sizeof quality;
        EXPECT(GUSSET_OK, gusset_result_get_quality(stitch, &quality));
        CHECK(quality.loops_left == 0 && quality.non_manifold_edges == 0 && quality.orientation_conflicts == 0);
        /* A square tube of side sqrt(2) and height 2. */
        CHECK(quality.area > 11.3137 && quality.area < 11.3138 && quality.degenerate_faces == 0);
        /* Its triangles have the sides sqrt(2), 2 and sqrt(6). */
        CHECK(fabs(quality.max_edge - sqrt(6.0)) < 1e-12);
        CHECK(fabs(quality.min_angle - atan(sqrt(0.5))) < 1e-12);
        CHECK(fabs(quality.max_aspect - (1.0 + sqrt(3.0) + sqrt(2.0)) / (2.0 * sqrt(2.0))) < 1e-12);
        gusset_result_destroy(stitch);
    }
}

/* Facing arcs of two squares in a plane, two rows of quads between them. */
static void stitch_arcs(void) {
    static const double left[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    static const double right[4][3] = {{4, 0, 0}, {5, 0, 0}, {5, 1, 0}, {4, 1, 0}};
    const uint32_t face[4] = {0, 1, 2, 3};
    gusset_mesh_view a = pyramid(pyramid_up), b = a;
    gusset_stitch_options options = {0};
    gusset_stitch_report parts = {0};
    gusset_result *stitch = NULL;

    a.positions = left, b.positions = right;
    a.face_corners = b.face_corners = face;
    a.vertex_count = b.vertex_count = 4, a.face_count = b.face_count = 1, a.face_size = b.face_size = 4;
    options.struct_size = sizeof options;
    options.extent = GUSSET_EXTENT_OPEN_ARCS;
    options.rows = GUSSET_ROWS_MEAN_EDGE;
    options.cells = GUSSET_CELLS_QUADS;
    options.meridians = GUSSET_MERIDIANS_INDEX;
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_stitch(NULL, &a, NULL, &b, NULL, &options, &stitch));
    EXPECT(GUSSET_OK, gusset_result_get_stitch(stitch, &parts));
    CHECK(parts.closed == 0 && parts.row_count == 2 && parts.strip_face_count == 3);
    CHECK(parts.rim[0].count == 2 && parts.rim[1].count == 2 && parts.meridians.count == 4 && parts.matrix.count == 8);
    CHECK(parts.parents.count == 12 && parts.weights != NULL && fabs(parts.weights[1] - 1.0 / 3.0) < 1e-15);
    CHECK(parts.parents.data[0] == parts.rim[0].data[0] && parts.parents.data[1] == parts.rim[1].data[0]);
    CHECK(parts.matrix.data[2] == 8 && parts.matrix.data[5] == 11);
    gusset_result_destroy(stitch);
}

static void tables_and_check(void) {
    const gusset_mesh_view mesh = pyramid(pyramid_up);
    gusset_winged *winged = NULL;
    gusset_winged_view tables = {0};
    gusset_check *check = NULL;
    gusset_check_view report = {0};
    size_t i;

    EXPECT(GUSSET_OK, gusset_winged_create(NULL, &mesh, NULL, &winged));
    tables.struct_size = sizeof tables;
    EXPECT(GUSSET_OK, gusset_winged_get_view(winged, &tables));
    CHECK(tables.edge_count == 8 && tables.edge_of_half_edge.count == 12 && tables.edge_of_face.count == 4);
    CHECK(tables.loop_offsets.count == 2 && tables.loop_vertices.count == 4 && tables.loop_edges.count == 4);
    for (i = 0; i < tables.loop_edges.count; ++i) {
        const gusset_winged_edge *edge = &tables.edges[tables.loop_edges.data[i]];
        /* Stored counter-clockwise: the face that runs the edge is on its left. */
        CHECK(edge->m == tables.loop_vertices.data[i] && edge->left != UINT32_MAX && edge->right == UINT32_MAX);
    }
    gusset_winged_destroy(winged);

    EXPECT(GUSSET_OK, gusset_check_create(NULL, &mesh, &check));
    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_check_get_view(check, &report));
    CHECK(report.vertex_count == 5 && report.edge_count == 8 && report.face_count == 4 && report.euler == 1);
    CHECK(report.properties == (GUSSET_MESH_MANIFOLD | GUSSET_MESH_ORIENTED | GUSSET_MESH_ORIENTABLE));
    CHECK(report.component_count == 1 && report.boundary_walk_count == 1 && report.genus == 0);
    CHECK(report.boundary_edges.count == 4 && report.bow_ties.count == 0);
    gusset_check_destroy(check);
}

static int count_steps(void *user, double fraction, const char *stage) {
    ++*(int *)user;
    return fraction < 0.0 || fraction > 1.0 || stage == NULL;
}

static int stop_at_once(void *user, double fraction, const char *stage) {
    (void)user, (void)fraction, (void)stage;
    return 1;
}

static int stop_at_one(void *user, double fraction, const char *stage) {
    (void)user, (void)stage;
    return fraction == 1;
}

static void ignore(void *user, const char *message) {
    (void)user, (void)message;
}

static void context_of_a_call(void) {
    const gusset_mesh_view mesh = pyramid(pyramid_up);
    gusset_context *context = NULL;
    gusset_boundary *boundary = NULL;
    gusset_error_report report = {sizeof report, 0, 0, 0, 0.0, 0, 0};
    int steps = 0;

    EXPECT(GUSSET_OK, gusset_context_create(&context));
    EXPECT(GUSSET_OK, gusset_context_set_threads(context, 1));
    EXPECT(GUSSET_OK, gusset_context_set_log(context, ignore, NULL));
    EXPECT(GUSSET_OK, gusset_context_set_progress(context, count_steps, &steps));
    EXPECT(GUSSET_OK, gusset_boundary_create(context, &mesh, NULL, &boundary));
    CHECK(steps > 0 && gusset_context_get_progress(context) == 1.0);
    gusset_boundary_destroy(boundary);
    stitch_two_pyramids(context);

    /* The callback's no is for one call. */
    EXPECT(GUSSET_OK, gusset_context_set_progress(context, stop_at_once, NULL));
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_boundary_create(context, &mesh, NULL, &boundary));
    CHECK(boundary == NULL);
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.status == GUSSET_ERROR_CANCELLED && strlen(gusset_context_get_message(context)) > 0);
    EXPECT(GUSSET_OK, gusset_context_set_progress(context, NULL, NULL));
    EXPECT(GUSSET_OK, gusset_boundary_create(context, &mesh, NULL, &boundary));
    CHECK(strlen(gusset_context_get_message(context)) == 0);
    gusset_boundary_destroy(boundary);

    /* The host's cancel stays until it is taken back. */
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_boundary_create(context, &mesh, NULL, &boundary));
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_boundary_create(context, &mesh, NULL, &boundary));
    gusset_context_reset(context);
    EXPECT(GUSSET_OK, gusset_boundary_create(context, &mesh, NULL, &boundary));
    gusset_boundary_destroy(boundary);
    gusset_context_destroy(context);
}

/* Keeps the last fraction; stops if they decrease. */
static int keep_fraction(void *user, double fraction, const char *stage) {
    double *const last = user;
    const int falls = fraction < *last || fraction > 1 || strlen(stage) == 0;
    *last = fraction;
    return falls;
}

/* If a call succeeds, its last report is 1: for new handles, for arrays of the caller, and for changes in place. */
static void progress_ends_at_one(void) {
    const gusset_mesh_view pieces[2] = {pyramid(pyramid_up), pyramid(pyramid_down)};
    double nodes[4][3] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};
    const double above[3] = {0.5, 0.25, 2};
    const gusset_nodes grid = gusset_nodes_f64(&nodes[0][0], 2, 2);
    const gusset_net_view view = gusset_net_points_f64(&nodes[0][0], 2, 2);
    const gusset_field twist = {.struct_size = sizeof twist, .kind = GUSSET_FIELD_TWIST, .axis = GUSSET_AXIS_Z, .strength = 1};
    gusset_context *context = NULL;
    gusset_result *result = NULL;
    gusset_surface *surface = NULL;
    gusset_surface_nearest_point nearest;
    gusset_net *net = NULL;
    gusset_net_view lent = {.struct_size = sizeof lent};
    double last = 0;

    EXPECT(GUSSET_OK, gusset_context_create(&context));
    EXPECT(GUSSET_OK, gusset_surface_from_nodes_create(NULL, &grid, &surface));
    EXPECT(GUSSET_OK, gusset_net_create(context, &view, NULL, GUSSET_NET_MEMORY_COPY, &net));
    CHECK(gusset_context_get_progress(context) == 1);
    EXPECT(GUSSET_OK, gusset_context_set_progress(context, keep_fraction, &last));
    EXPECT(GUSSET_OK, gusset_join(context, pieces, 2, NULL, &result));
    CHECK(last == 1);
    last = 0;
    EXPECT(GUSSET_OK, gusset_surface_nearest(context, surface, above, 1, NULL, &nearest));
    CHECK(last == 1 && fabs(nearest.distance - 2) < 1e-9);
    last = 0;
    EXPECT(GUSSET_OK, gusset_net_deform(context, net, &twist, 1, 0));
    CHECK(last == 1);
    /* Too late to stop; what reports nothing stays silent. */
    EXPECT(GUSSET_OK, gusset_context_set_progress(context, stop_at_one, NULL));
    EXPECT(GUSSET_OK, gusset_net_deform(context, net, &twist, 1, 0));
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_surface_nearest(context, surface, above, 1, NULL, &nearest));
    CHECK(strcmp(gusset_context_get_message(context), "the caller cancelled the call") == 0);
    EXPECT(GUSSET_OK, gusset_context_set_progress(context, stop_at_once, NULL));
    EXPECT(GUSSET_OK, gusset_net_edit(context, net, &lent));
    gusset_result_destroy(result);
    gusset_surface_destroy(surface);
    gusset_net_destroy(net);
    gusset_context_destroy(context);
}

/* The short forms of views.h are the long ones, and a NULL handle gives an empty view that can be used. */
static void short_forms(void) {
    const double square[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    const gusset_outlines points = gusset_points_f64(square, 4, 2, 1), none = gusset_points_f64(square, 4, 4, 1);
    gusset_curve *curve = NULL;
    gusset_curve_form *form = NULL;
    EXPECT(GUSSET_OK, gusset_curve_from_points_create(NULL, &points, NULL, &curve));
    EXPECT(GUSSET_OK, gusset_curve_export_create(NULL, curve, GUSSET_CURVE_FORMAT_SVG, 0, &form));
    const gusset_curve_form_view path = gusset_curve_form_lend(form), no_path = gusset_curve_form_lend(NULL);
    CHECK(path.text[0] == 'M' && strlen(path.text) == path.text_length);
    CHECK(no_path.text[0] == 0 && no_path.text_length == 0 && no_path.points == NULL);
    gusset_curve_form_destroy(form);
    gusset_curve_destroy(curve);
    curve = misaligned();
    CHECK(gusset_curve_from_points_create(NULL, &none, NULL, &curve) != GUSSET_OK && curve == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_from_points_create(NULL, &points, NULL, NULL));

    double grid[16 * 3];
    float single[16 * 3];
    for (size_t k = 0; k < 16; ++k) {
        grid[3 * k] = (double)(k / 4), grid[3 * k + 1] = (double)(k % 4), grid[3 * k + 2] = 0;
    }
    for (size_t k = 0; k < 48; ++k) {
        single[k] = (float)grid[k];
    }
    const gusset_nodes nodes[2] = {gusset_nodes_f64(grid, 4, 4), gusset_nodes_f32(single, 4, 4)};
    const gusset_net_view views[2] = {gusset_net_points_f64(grid, 4, 4), gusset_net_points_f32(single, 4, 4)};
    for (int k = 0; k < 2; ++k) {
        const double above[3] = {1.25, 1.5, 2};
        gusset_surface *surface = NULL;
        gusset_surface_nearest_point nearest;
        EXPECT(GUSSET_OK, gusset_surface_from_nodes_create(NULL, &nodes[k], &surface));
        EXPECT(GUSSET_OK, gusset_surface_nearest(NULL, surface, above, 1, NULL, &nearest));
        CHECK(fabs(nearest.distance - 2) < 1e-9);
        gusset_surface_destroy(surface);
        EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_from_nodes_create(NULL, &nodes[k], NULL));
        surface = misaligned();
        EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_from_nodes_create(NULL, NULL, &surface));
        CHECK(surface == NULL);
        gusset_net *net = NULL;
        gusset_result *result = NULL;
        EXPECT(GUSSET_OK, gusset_net_create(NULL, &views[k], NULL, GUSSET_NET_MEMORY_COPY, &net));
        EXPECT(GUSSET_OK, gusset_net_to_mesh(NULL, net, NULL, &result));
        CHECK(gusset_result_mesh(result).vertex_count == 16 && gusset_result_mesh(result).face_count > 0);
        gusset_result_destroy(result);
        gusset_net_destroy(net);
    }
    const gusset_mesh_view empty = gusset_result_mesh(NULL);
    gusset_boundary *boundary = NULL;
    CHECK(empty.vertex_count == 0 && empty.face_count == 0);
    EXPECT(GUSSET_ERROR_EMPTY_MESH, gusset_boundary_create(NULL, &empty, NULL, &boundary));
}

int main(void) {
    short_forms();
    layouts();
    loop_of_a_pyramid();
    stitch_two_pyramids(NULL);
    stitch_arcs();
    tables_and_check();
    context_of_a_call();
    progress_ends_at_one();
    return failures != 0;
}
