/* Stitching: facing vertices, meridians, strips, stitches, holes, joined pieces. */
#include "example.h"

/* Two open pyramids, point up and point down, with a gap between their square rims. */
static const double up[5][3] = {{0, 0, 2}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
static const double down[5][3] = {{0, 0, -2}, {1, 0, -1}, {0, -1, -1}, {-1, 0, -1}, {0, 1, -1}};
static const uint32_t faces[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};

static gusset_mesh_view pyramid(const double points[5][3]) {
    return gusset_triangles_f64(points[0], 5, faces, 4);
}

//! [facing]
static void which_vertices_face_each_other(void) {
    /* Two squares side by side: the right side of the one faces the left side of the other. */
    const double left[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const double right[4][3] = {{4, 0, 0}, {5, 0, 0}, {5, 1, 0}, {4, 1, 0}};
    gusset_facing *facing = NULL;
    gusset_facing_view view = {.struct_size = sizeof view};

    MUST(gusset_facing_create(NULL, left[0], 4, right[0], 4, NULL, &facing));
    MUST(gusset_facing_get_view(facing, &view));
    HOLDS(view.taken[0][0] == 1 && view.taken[0][1] == 2); /* two vertices from place 1 on */
    HOLDS(view.taken[1][0] == 3 && view.taken[1][1] == 2); /* two from place 3 on, past the end of the loop */
    gusset_facing_destroy(facing);
}
//! [facing]

//! [meridians]
static void meridians_by_index(void) {
    uint32_t j[7];
    size_t count = 0;

    MUST(gusset_meridians_index(6, 3, NULL, 0, &count));
    HOLDS(count == 7);
    MUST(gusset_meridians_index(6, 3, j, 7, &count));
    HOLDS(j[0] == 0 && j[2] == 1 && j[4] == 2 && j[6] == 3);
}
//! [meridians]

//! [stitch]
static void two_loops_joined(void) {
    const gusset_mesh_view a = pyramid(up), b = pyramid(down);
    gusset_stitch_options options = {.struct_size = sizeof options, .rows = GUSSET_ROWS_COUNT, .row_count = 1};
    gusset_mesh_view whole = {.struct_size = sizeof whole}, strip = {.struct_size = sizeof strip};
    gusset_stitch_report parts = {.struct_size = sizeof parts};
    gusset_quality_report quality = {.struct_size = sizeof quality};
    gusset_result *stitch = NULL;

    /* NULL for both loops: those that lie nearest to each other. */
    MUST(gusset_stitch(NULL, &a, NULL, &b, NULL, &options, &stitch));
    MUST(gusset_result_get_mesh(stitch, &whole));
    MUST(gusset_result_get_strip_mesh(stitch, &strip));
    MUST(gusset_result_get_stitch(stitch, &parts));
    MUST(gusset_result_get_quality(stitch, &quality));
    HOLDS(quality.loops_left == 0 && quality.orientation_conflicts == 0);
    /* The faces of A, those of B, then the strip; old vertices keep their bits. */
    HOLDS(parts.strip_face_first == 8 && whole.face_count == 8 + strip.face_count);
    HOLDS(memcmp(whole.positions, up, sizeof up) == 0);
    /* Each new vertex has parents on the rims: in a row the ends of its meridian, the second one twice. */
    HOLDS(parts.parents.count == 3 * (whole.vertex_count - 10) && parts.weights[0] == 0.5 && parts.weights[2] == 0.0);
    gusset_result_destroy(stitch);
}
//! [stitch]

//! [strip]
static void a_strip_of_no_mesh(void) {
    const double a[3][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const double b[2][3] = {{0, 1, 0}, {2, 1, 0}};
    gusset_result *strip = NULL;
    gusset_strip_report parts = {.struct_size = sizeof parts};
    gusset_mesh_view mesh = {.struct_size = sizeof mesh};
    const gusset_strip_options rows = {
        .struct_size = sizeof rows, .rows = GUSSET_ROWS_COUNT, .row_count = 2, .cells = GUSSET_CELLS_QUADS};

    MUST(gusset_strip(NULL, a[0], 3, b[0], 2, NULL, &strip));
    MUST(gusset_result_get_strip(strip, &parts));
    MUST(gusset_result_get_mesh(strip, &mesh));
    HOLDS(mesh.vertex_count == 5 && mesh.face_count == 3 && parts.meridians.count == 2 * 4);
    gusset_result_destroy(strip);

    /* The paper's intermediate mesh: P has a row for each polyline and two between them. */
    MUST(gusset_strip(NULL, a[0], 3, b[0], 2, &rows, &strip));
    MUST(gusset_result_get_strip(strip, &parts));
    MUST(gusset_result_get_mesh(strip, &mesh));
    const size_t columns = parts.meridians.count / 2;
    HOLDS(parts.row_count == 2 && parts.matrix.count == 4 * columns && mesh.vertex_count == 5 + 2 * columns);
    gusset_result_destroy(strip);
}
//! [strip]

//! [fill]
static void a_hole_filled(void) {
    const gusset_mesh_view mesh = pyramid(up);
    gusset_mesh_view filled = {.struct_size = sizeof filled};
    gusset_fill_report parts = {.struct_size = sizeof parts};
    gusset_quality_report quality = {.struct_size = sizeof quality};
    gusset_result *fill = NULL;

    /* No loops named: all that the mesh has. */
    MUST(gusset_fill(NULL, &mesh, NULL, 0, NULL, &fill));
    MUST(gusset_result_get_mesh(fill, &filled));
    MUST(gusset_result_get_fill(fill, &parts));
    MUST(gusset_result_get_quality(fill, &quality));
    HOLDS(parts.hole_count == 1 && parts.holes[0].status == GUSSET_HOLE_FILLED);
    HOLDS(filled.face_count == 6 && about(quality.area, 2.0) && quality.loops_left == 0);
    gusset_result_destroy(fill);

    /* A limit leaves the hole open; a text says why. */
    const gusset_fill_options small = {.struct_size = sizeof small, .max_edges = 3};
    MUST(gusset_fill(NULL, &mesh, NULL, 0, &small, &fill));
    MUST(gusset_result_get_fill(fill, &parts));
    HOLDS(strncmp(gusset_choice_text("gusset_hole_status", parts.holes[0].status), "Left open: it exceeds", 21) == 0);
    gusset_result_destroy(fill);
}
//! [fill]

//! [join]
static void many_pieces(void) {
    const gusset_mesh_view pieces[2] = {pyramid(up), pyramid(down)};
    gusset_join_options options = {.struct_size = sizeof options, .gap = GUSSET_GAP_GIVEN, .max_gap = 2.5, .fill = 1};
    gusset_mesh_view whole = {.struct_size = sizeof whole};
    gusset_join_report parts = {.struct_size = sizeof parts};
    gusset_result *joined = NULL;

    /* The whole job: NULL options sew, orient and stitch by default. */
    MUST(gusset_join(NULL, pieces, 2, NULL, &joined));
    MUST(gusset_result_get_mesh(joined, &whole));
    HOLDS(whole.vertex_count == 10 && whole.face_count == 16);
    gusset_result_destroy(joined);

    MUST(gusset_join(NULL, pieces, 2, &options, &joined));
    MUST(gusset_result_get_mesh(joined, &whole));
    MUST(gusset_result_get_join(joined, &parts));
    HOLDS(parts.joint_count == 1 && parts.joints[0].outcome == GUSSET_JOINT_JOINED && parts.loops_left == 0);
    HOLDS(whole.face_count == 16 && parts.pieces[1].faces.data[0] == 4);
    gusset_result_destroy(joined);
}
//! [join]

int main(void) {
    which_vertices_face_each_other();
    meridians_by_index();
    two_loops_joined();
    a_strip_of_no_mesh();
    a_hole_filled();
    many_pieces();
    return 0;
}
