/* Welds, sews and orients with invalid and valid arguments, and checks errors and results. */
#include "check.h"
#include <math.h>

static gusset_context *context;

/* Two triangles with a side in common and vertices of their own, one seen from below. */
static double points[6][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, -0.0}, {1, 1, 0}};
static const uint32_t corners[6] = {0, 1, 2, 3, 4, 5};

static gusset_mesh_view triangles(void) {
    gusset_mesh_view view = pyramid(pyramid_up);
    view.positions = points;
    view.vertex_count = 6;
    view.face_corners = corners;
    view.face_count = 2;
    return view;
}

static void weld(void) {
    const gusset_mesh_view mesh = triangles();
    gusset_mesh_view view, bad = mesh;
    gusset_weld_options options = {0};
    gusset_weld_report parts;
    gusset_error_report report = {sizeof report, 0, 0, 0, 0.0, 0, 0};
    gusset_result *weld = (gusset_result *)misaligned();

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_weld(context, NULL, NULL, &weld));
    CHECK(weld == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_weld(context, &mesh, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_weld(misaligned(), &mesh, NULL, &weld));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_weld(context, misaligned(), NULL, &weld));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_weld(context, &mesh, misaligned(), &weld));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_weld(context, &mesh, NULL, misaligned()));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_weld(context, &mesh, &options, &weld));
    options.struct_size = sizeof options, options.vertices = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_weld(context, &mesh, &options, &weld));
    options.vertices = 1, options.tolerance_mode = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_weld(context, &mesh, &options, &weld));
    options.tolerance_mode = 0, options.collapse = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_weld(context, &mesh, &options, &weld));
    options.collapse = 0, options.unused = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_weld(context, &mesh, &options, &weld));
    options.unused = 0, options.tolerance_mode = 1, options.tolerance = -1e-300;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_weld(context, &mesh, &options, &weld));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.value == -1e-300);
    options.tolerance = INFINITY;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_weld(context, &mesh, &options, &weld));
    options.tolerance = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_weld(context, &mesh, &options, &weld));
    CHECK(weld == NULL);
    points[4][1] = NAN;
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_weld(context, &mesh, NULL, &weld));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_VERTEX && report.index == 4 && weld == NULL);
    points[4][1] = 1.0;
    bad.vertex_count = 5;
    EXPECT(GUSSET_ERROR_INDEX_OUT_OF_RANGE, gusset_weld(context, &bad, NULL, &weld));
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_weld(context, &mesh, NULL, &weld));
    gusset_context_reset(context);

    /* A tolerance that is not read may be anything. */
    options.tolerance_mode = GUSSET_TOLERANCE_EXACT;
    EXPECT(GUSSET_OK, gusset_weld(context, &mesh, &options, &weld));
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_result_get_weld(weld, &parts));
    CHECK(parts.tolerance == 0.0 && parts.sewn_edges == 1);
    gusset_result_destroy(weld);
    options.tolerance_mode = GUSSET_TOLERANCE_AUTO;
    EXPECT(GUSSET_OK, gusset_weld(context, &mesh, &options, &weld));
    memset(&parts, 0xff, sizeof parts), parts.struct_size = sizeof parts;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_weld(NULL, &parts));
    CHECK(parts.vertex_map.data == NULL && parts.sewn_edges == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_weld(weld, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_weld(misaligned(), &parts));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_weld(weld, misaligned()));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(weld, NULL));
    memset(&view, 0xff, sizeof view), view.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_mesh(weld, &view));
    view.struct_size = sizeof view;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(NULL, &view));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(weld, &view));
    EXPECT(GUSSET_OK, gusset_result_get_weld(weld, &parts));
    CHECK(view.vertex_count == 4 && view.face_count == 2 && view.scalar == GUSSET_F64);
    CHECK(parts.vertex_map.count == 6 && parts.vertex_map.data[4] == 2 && parts.vertex_map.data[5] == 3);
    CHECK(parts.tolerance > 0.0 && parts.tolerance < 1e-9);
    CHECK(parts.face_map.count == 2 && parts.welded_vertices == 2 && parts.sewn_edges == 1);
    CHECK(parts.left_edges.data == NULL && parts.left_vertices.count == 0 && parts.dropped_faces == 0);
    gusset_result_destroy(weld);
    gusset_result_destroy(NULL);
    /* Everything in one point: no face is left. */
    options.tolerance_mode = 1, options.tolerance = 10.0, options.collapse = 1, options.unused = 1;
    EXPECT(GUSSET_OK, gusset_weld(NULL, &mesh, &options, &weld));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(weld, &view));
    EXPECT(GUSSET_OK, gusset_result_get_weld(weld, &parts));
    CHECK(view.vertex_count == 0 && view.face_count == 0 && parts.dropped_faces == 2);
    CHECK(parts.vertex_map.data[0] == UINT32_MAX && parts.face_map.data[1] == UINT32_MAX);
    gusset_result_destroy(weld);
}

static void sew(void) {
    const gusset_mesh_view mesh = triangles();
    gusset_mesh_view view, bad = mesh;
    gusset_weld_options options = {0};
    gusset_sew_report parts;
    gusset_result *sew = (gusset_result *)misaligned();

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sew(context, NULL, NULL, &sew));
    CHECK(sew == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sew(context, &mesh, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_sew(misaligned(), &mesh, NULL, &sew));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_sew(context, misaligned(), NULL, &sew));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_sew(context, &mesh, misaligned(), &sew));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_sew(context, &mesh, NULL, misaligned()));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_sew(context, &mesh, &options, &sew));
    options.struct_size = sizeof options, options.tolerance_mode = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sew(context, &mesh, &options, &sew));
    options.tolerance_mode = GUSSET_TOLERANCE_GIVEN, options.tolerance = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sew(context, &mesh, &options, &sew));
    points[4][1] = NAN;
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_sew(context, &mesh, NULL, &sew));
    points[4][1] = 1.0;
    bad.vertex_count = 5;
    EXPECT(GUSSET_ERROR_INDEX_OUT_OF_RANGE, gusset_sew(context, &bad, NULL, &sew));
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_sew(context, &mesh, NULL, &sew));
    gusset_context_reset(context);
    CHECK(sew == NULL);

    EXPECT(GUSSET_OK, gusset_sew(context, &mesh, NULL, &sew));
    memset(&parts, 0xff, sizeof parts), parts.struct_size = sizeof parts;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_sew(NULL, &parts));
    CHECK(parts.vertex_map.data == NULL && parts.sewn_edges == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_sew(sew, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_sew(misaligned(), &parts));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_sew(sew, misaligned()));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(sew, NULL));
    memset(&view, 0xff, sizeof view), view.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_mesh(sew, &view));
    view.struct_size = sizeof view;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(NULL, &view));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(sew, &view));
    EXPECT(GUSSET_OK, gusset_result_get_sew(sew, &parts));
    CHECK(view.vertex_count == 4 && view.face_count == 2 && parts.sewn_edges == 1 && parts.splits == 0);
    CHECK(parts.face_origin.count == 2 && parts.face_map.data[1] == 1 && parts.dropped_faces == 0);
    gusset_result_destroy(sew);
    gusset_result_destroy(NULL);
}

static void repair(void) {
    /* A tetrahedron without a face, and with another one twice. */
    static const double corner[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 1, 0, 3, 2};
    gusset_mesh_view mesh = {.struct_size = sizeof mesh, .positions = corner, .vertex_count = 4, .scalar = GUSSET_F64,
                             .face_corners = faces, .face_count = 4, .face_size = 3},
                     view = {.struct_size = sizeof view};
    gusset_fill_options fill = {.struct_size = sizeof fill, .max_length = -1};
    gusset_repair_options options = {0};
    gusset_repair_report report = {.struct_size = sizeof report};
    gusset_result *repaired = (gusset_result *)misaligned();

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_repair(context, NULL, NULL, &repaired));
    CHECK(repaired == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_repair(context, &mesh, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_repair(misaligned(), &mesh, NULL, &repaired));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_repair(context, misaligned(), NULL, &repaired));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_repair(context, &mesh, misaligned(), &repaired));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_repair(context, &mesh, NULL, misaligned()));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_repair(context, &mesh, &options, &repaired));
    options.struct_size = sizeof options, options.tolerance_mode = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_repair(context, &mesh, &options, &repaired));
    options.tolerance_mode = GUSSET_TOLERANCE_GIVEN, options.tolerance = -1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_repair(context, &mesh, &options, &repaired));
    options.tolerance_mode = GUSSET_TOLERANCE_AUTO, options.leave_fins = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_repair(context, &mesh, &options, &repaired));
    options.leave_fins = 0, options.fill_options = &fill;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_repair(context, &mesh, &options, &repaired));
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_repair(context, &mesh, NULL, &repaired));
    gusset_context_reset(context);
    CHECK(repaired == NULL);

    EXPECT(GUSSET_OK, gusset_repair(context, &mesh, NULL, &repaired));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_repair(NULL, &report));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_repair(repaired, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_repair(repaired, misaligned()));
    EXPECT(GUSSET_OK, gusset_result_get_repair(repaired, &report));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(repaired, &view));
    CHECK(view.vertex_count == 4 && view.face_count == 4 && report.valid == 1 && report.filled_holes == 1);
    CHECK(report.dropped_count == 1 && report.dropped_faces.data[0] == 2 && report.drop_reasons[0] == GUSSET_DROP_DUPLICATE);
    CHECK(report.face_origin.count == 4 && report.face_origin.data[3] == UINT32_MAX && report.vertex_origin.count == 4);
    CHECK(report.face_count == 4 && report.intersecting_pairs.count == 0 && report.boundary_edges_left == 0);
    gusset_result_destroy(repaired);

    options.fill_options = NULL, options.leave_holes = 1;
    EXPECT(GUSSET_OK, gusset_repair(context, &mesh, &options, &repaired));
    EXPECT(GUSSET_OK, gusset_result_get_repair(repaired, &report));
    CHECK(report.valid == 0 && report.filled_holes == 0 && report.boundary_edges_left == 3);
    gusset_result_destroy(repaired);
}

static void unite(void) {
    static const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    static const double four[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const double apart[4][3] = {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}};
    gusset_mesh_view pieces[2] = {{.struct_size = sizeof *pieces, .positions = four, .vertex_count = 4, .scalar = GUSSET_F64,
                                   .face_corners = faces, .face_count = 4, .face_size = 3}};
    gusset_error_report error = {sizeof error, 0, 0, 0, 0.0, 0, 0};
    gusset_repair_report report = {.struct_size = sizeof report};
    gusset_result *united = (gusset_result *)misaligned();

    pieces[1] = pieces[0];
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_unite(context, NULL, 2, &united));
    CHECK(united == NULL);
    EXPECT(GUSSET_ERROR_EMPTY_MESH, gusset_unite(context, NULL, 0, &united));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_unite(context, pieces, 2, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_unite(misaligned(), pieces, 2, &united));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_unite(context, misaligned(), 2, &united));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_unite(context, pieces, 2, misaligned()));
    pieces[1].positions = apart;
    pieces[1].face_count = 3;
    EXPECT(GUSSET_ERROR_MESH_NOT_CLOSED, gusset_unite(context, pieces, 2, &united));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &error));
    CHECK(error.element == GUSSET_ELEMENT_FACE && error.input == 1 && error.index < 3);
    pieces[1].positions = four;
    pieces[1].face_count = 4;
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_unite(context, pieces, 2, &united));
    gusset_context_reset(context);
    CHECK(united == NULL);

    EXPECT(GUSSET_OK, gusset_unite(context, pieces, 2, &united));
    EXPECT(GUSSET_OK, gusset_result_get_repair(united, &report));
    CHECK(report.valid == 1 && report.dropped_count == 4 && report.dropped_faces.data[0] == 4 && report.face_origin.count == 4);
    CHECK(report.drop_reasons[0] == GUSSET_DROP_OVERLAP);
    gusset_result_destroy(united);
}

static void triangulate(void) {
    /* A dart: the diagonal from its first corner lies outside. */
    static const double dart[4][3] = {{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}};
    static const uint32_t corners[4] = {1, 2, 3, 0};
    gusset_mesh_view mesh = {.struct_size = sizeof mesh, .positions = dart, .vertex_count = 4, .scalar = GUSSET_F64,
                             .face_corners = corners, .face_count = 1, .face_size = 4},
                     view = {.struct_size = sizeof view};
    gusset_result *triangles = (gusset_result *)misaligned();

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_triangulate(context, NULL, &triangles));
    CHECK(triangles == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_triangulate(context, &mesh, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_triangulate(misaligned(), &mesh, &triangles));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_triangulate(context, misaligned(), &triangles));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_triangulate(context, &mesh, misaligned()));
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_triangulate(context, &mesh, &triangles));
    gusset_context_reset(context);
    CHECK(triangles == NULL);

    EXPECT(GUSSET_OK, gusset_triangulate(context, &mesh, &triangles));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(triangles, &view));
    /* Both triangles have the corner inside, vertex 2, and the tip, vertex 0. */
    CHECK(view.vertex_count == 4 && view.face_count == 2);
    for (int f = 0; f < 2; ++f) {
        const uint32_t *face = (const uint32_t *)view.face_corners + 3 * f;
        CHECK((face[0] == 2) + (face[1] == 2) + (face[2] == 2) == 1 && (face[0] == 0) + (face[1] == 0) + (face[2] == 0) == 1);
    }
    gusset_result_destroy(triangles);
}

static void orient(void) {
    /* Both triangles on the same vertices, run the same way along the common side. */
    static const uint32_t shared[6] = {0, 1, 2, 1, 2, 5};
    gusset_mesh_view mesh = triangles(), view;
    gusset_orient_options options = {0};
    gusset_orient_report parts;
    gusset_result *orient = (gusset_result *)misaligned();

    mesh.face_corners = shared;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_orient(context, NULL, NULL, &orient));
    CHECK(orient == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_orient(context, &mesh, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_orient(misaligned(), &mesh, NULL, &orient));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_orient(context, misaligned(), NULL, &orient));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_orient(context, &mesh, misaligned(), &orient));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_orient(context, &mesh, NULL, misaligned()));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_orient(context, &mesh, &options, &orient));
    options.struct_size = sizeof options, options.outward = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_orient(context, &mesh, &options, &orient));
    options.outward = GUSSET_OUTWARD_CLOSED, options.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_orient(context, &mesh, &options, &orient));
    options.reserved = 0;
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_orient(context, &mesh, &options, &orient));
    gusset_context_reset(context);
    CHECK(orient == NULL);

    EXPECT(GUSSET_OK, gusset_orient(context, &mesh, &options, &orient));
    memset(&parts, 0xff, sizeof parts), parts.struct_size = sizeof parts;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_orient(NULL, &parts));
    CHECK(parts.turned == NULL && parts.face_count == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_orient(orient, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_orient(misaligned(), &parts));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_orient(orient, misaligned()));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(orient, NULL));
    memset(&view, 0xff, sizeof view), view.struct_size = sizeof view;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(NULL, &view));
    CHECK(view.positions == NULL);
    EXPECT(GUSSET_OK, gusset_result_get_mesh(orient, &view));
    EXPECT(GUSSET_OK, gusset_result_get_orient(orient, &parts));
    /* The second face is turned: as many on either side, and the first one stays. It keeps its first corner. */
    CHECK(parts.face_count == 2 && parts.turned[0] == 0 && parts.turned[1] == 1 && parts.turned_faces == 1);
    CHECK(((const uint32_t *)view.face_corners)[3] == 1 && ((const uint32_t *)view.face_corners)[4] == 5);
    CHECK(parts.component_count == 1 && parts.inverted_components == 0);
    CHECK(parts.one_sided_faces.count == 0 && parts.one_sided_half_edges.data == NULL);
    gusset_result_destroy(orient);
    gusset_result_destroy(NULL);
}

int main(void) {
    const gusset_mesh_view other = pyramid(pyramid_down);
    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    CHECK(other.vertex_count == 5);
    weld();
    sew();
    repair();
    unite();
    triangulate();
    orient();
    gusset_context_destroy(context);
    return failures != 0;
}
