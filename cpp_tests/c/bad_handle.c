/* Passes handles of one kind to functions of another, which must refuse them without reading or freeing them. */
#include "check.h"

static gusset_context *context;

/* Handles of other kinds, which compilers of C only warn of, and which bindings of other languages may mix up. */
static void wrong_handles(void) {
    const gusset_mesh_view mesh = pyramid(pyramid_up);
    gusset_check_view check = {0};
    gusset_boundary *boundary = NULL;
    gusset_net *copy = NULL;
    check.struct_size = sizeof check;
    EXPECT(GUSSET_OK, gusset_boundary_create(context, &mesh, NULL, &boundary));
    void *const wrong = boundary;
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_check_get_view(wrong, &check));
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_context_set_threads(wrong, 1));
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_boundary_create(wrong, &mesh, NULL, (gusset_boundary **)&copy));
    CHECK(copy == NULL);
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_net_copy_create(context, wrong, NULL, &copy));
    CHECK(copy == NULL && strstr(gusset_context_get_message(context), "net is not a live gusset_net; ") != NULL);
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_net_displace(context, wrong, 1.0));
    gusset_boundary_view loops = {sizeof loops, 1, 1, NULL, 1};
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_boundary_get_view((void *)context, &loops));
    CHECK(loops.loop_count == 0 && loops.walk_count == 0 && loops.defect_count == 0);
    /* A _destroy function of another kind does not destroy them. */
    gusset_net_destroy(wrong);
    gusset_context_destroy(wrong);
    gusset_context_cancel(wrong);
    CHECK(loops_of(boundary).loop_count == 1);
    gusset_boundary_destroy(boundary);
}

/* Passes results of one operation to report functions of another. Each result has a mesh, origins, and only the
   report of its own operation. */
static void wrong_operations(void) {
    static const double a[2][3] = {{0, 0, 0}, {1, 0, 0}}, b[2][3] = {{0, 1, 0}, {1, 1, 0}};
    static const double nodes[2][2][3] = {{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}};
    const double heights[4] = {0, 0, 0, 0};
    enum { OPERATIONS = 12, REPORTS = 11 };
    const gusset_mesh_view mesh = pyramid(pyramid_up), pieces[2] = {mesh, pyramid(pyramid_down)};
    const gusset_nodes given = {.struct_size = sizeof given, .nodes = nodes, .rows = 2, .columns = 2, .scalar = GUSSET_F64};
    const gusset_heights flat = {
        .struct_size = sizeof flat, .rows = 2, .columns = 2, .values = heights, .spacing = {1, 1}, .scalar = GUSSET_F64};
    gusset_result *results[OPERATIONS] = {NULL};
    gusset_net *net = NULL;
    gusset_sheet *sheet = NULL;
    EXPECT(GUSSET_OK, gusset_net_from_heights_create(context, &flat, &net));
    EXPECT(GUSSET_OK, gusset_sheet_create(context, &given, NULL, 0, &sheet));
    EXPECT(GUSSET_OK, gusset_join(context, pieces, 2, NULL, &results[0]));
    EXPECT(GUSSET_OK, gusset_stitch(context, &pieces[0], NULL, &pieces[1], NULL, NULL, &results[1]));
    EXPECT(GUSSET_OK, gusset_strip(context, a[0], 2, b[0], 2, NULL, &results[2]));
    EXPECT(GUSSET_OK, gusset_fill(context, &mesh, NULL, 0, NULL, &results[3]));
    EXPECT(GUSSET_OK, gusset_weld(context, &mesh, NULL, &results[4]));
    EXPECT(GUSSET_OK, gusset_sew(context, &mesh, NULL, &results[5]));
    EXPECT(GUSSET_OK, gusset_orient(context, &mesh, NULL, &results[6]));
    EXPECT(GUSSET_OK, gusset_develop(context, &mesh, NULL, &results[7]));
    EXPECT(GUSSET_OK, gusset_net_to_mesh(context, net, NULL, &results[8]));
    EXPECT(GUSSET_OK, gusset_sheet_to_mesh(context, sheet, NULL, &results[9]));
    EXPECT(GUSSET_OK, gusset_repair(context, &mesh, NULL, &results[10]));
    /* It has no report. */
    EXPECT(GUSSET_OK, gusset_triangulate(context, &mesh, &results[11]));
    gusset_net_destroy(net);
    gusset_sheet_destroy(sheet);
    for (int made = 0; made < OPERATIONS; ++made) {
        gusset_join_report join = {.struct_size = sizeof join};
        gusset_stitch_report stitch = {.struct_size = sizeof stitch};
        gusset_strip_report strip = {.struct_size = sizeof strip};
        gusset_fill_report fill = {.struct_size = sizeof fill};
        gusset_weld_report weld = {.struct_size = sizeof weld};
        gusset_sew_report sew = {.struct_size = sizeof sew};
        gusset_orient_report orient = {.struct_size = sizeof orient};
        gusset_develop_report develop = {.struct_size = sizeof develop};
        gusset_net_mesh_report net_mesh = {.struct_size = sizeof net_mesh};
        gusset_sheet_mesh_report sheet_mesh = {.struct_size = sizeof sheet_mesh};
        gusset_repair_report repair = {.struct_size = sizeof repair};
        gusset_quality_report quality = {.struct_size = sizeof quality, .loops_left = 7};
        gusset_mesh_view view = {.struct_size = sizeof view}, alone = view;
        gusset_origins *origins = NULL;
        const gusset_result *const result = results[made];
        const gusset_status found[REPORTS] = {
            gusset_result_get_join(result, &join), gusset_result_get_stitch(result, &stitch),
            gusset_result_get_strip(result, &strip), gusset_result_get_fill(result, &fill),
            gusset_result_get_weld(result, &weld), gusset_result_get_sew(result, &sew),
            gusset_result_get_orient(result, &orient), gusset_result_get_develop(result, &develop),
            gusset_result_get_net_mesh(result, &net_mesh), gusset_result_get_sheet_mesh(result, &sheet_mesh),
            gusset_result_get_repair(result, &repair)};
        const gusset_status none = GUSSET_ERROR_WRONG_HANDLE;
        for (int asked = 0; asked < REPORTS; ++asked) {
            CHECK(found[asked] == (asked == made ? GUSSET_OK : none));
        }
        CHECK(gusset_result_get_quality(result, &quality) == (made == 1 || made == 3 ? GUSSET_OK : none));
        CHECK(quality.loops_left == 0);
        CHECK(gusset_result_get_strip_mesh(result, &alone) == (made == 1 ? GUSSET_OK : none));
        CHECK((alone.positions != NULL) == (made == 1));
        EXPECT(GUSSET_OK, gusset_result_get_mesh(result, &view));
        CHECK(view.face_count > 0);
        EXPECT(GUSSET_OK, gusset_result_origins_create(context, result, &origins));
        gusset_origins_destroy(origins);
        gusset_result_destroy(results[made]);
    }
}

int main(void) {
    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    wrong_handles();
    wrong_operations();
    gusset_context_destroy(context);
    return failures != 0;
}
