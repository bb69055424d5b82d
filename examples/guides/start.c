/* The programs of docs/guides/c.md in one: two open shells become one closed mesh. */
#include <gusset.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//! [view]
/* Your own arrays, as they are: here interleaved positions and normals in single precision, and triangles. */
typedef struct {
    float position[3];
    float normal[3];
} vertex;

static gusset_mesh_view view_of(const vertex *vertices, size_t vertex_count, const uint32_t *corners, size_t face_count) {
    gusset_mesh_view view = gusset_triangles_f32(vertices->position, vertex_count, corners, face_count);
    view.position_stride = sizeof *vertices;
    return view;
}
//! [view]

//! [error]
/* Stops the program if a call failed, and prints the reason that the context holds. */
static void must(gusset_status status, const gusset_context *context) {
    gusset_error_report report = {0};
    if (status == GUSSET_OK) {
        return;
    }
    fprintf(stderr, "%s: %s\n", gusset_status_text(status), gusset_context_get_message(context));
    report.struct_size = sizeof report;
    if (context != NULL && gusset_context_get_report(context, &report) == GUSSET_OK && report.element != GUSSET_ELEMENT_NONE) {
        fprintf(stderr, "element %lu, value %g\n", (unsigned long)report.index, report.value);
    }
    exit(1);
}
//! [error]

//! [progress]
/* The library calls it on the calling thread; a nonzero return cancels the call. */
static int on_progress(void *user, double fraction, const char *stage) {
    FILE *log = user;
    fprintf(log, "%3.0f %% %s\n", 100.0 * fraction, stage);
    return 0;
}
//! [progress]

//! [loops]
static void print_loops(const gusset_context *context, const gusset_mesh_view *mesh) {
    gusset_boundary *boundary = NULL;
    gusset_boundary_view loops = {0};
    gusset_loop_view loop = {0};
    size_t i;
    must(gusset_boundary_create(context, mesh, NULL, &boundary), context);
    loops.struct_size = sizeof loops;
    loop.struct_size = sizeof loop;
    must(gusset_boundary_get_view(boundary, &loops), NULL);
    for (i = 0; i < loops.loop_count; ++i) {
        must(gusset_boundary_get_loop(boundary, i, &loop), NULL);
        printf("a loop of %lu vertices, %g long%s\n", (unsigned long)loop.vertices.count, loop.length,
               loop.flags == 0 ? "" : ", and odd: see its flags");
    }
    gusset_boundary_destroy(boundary);
}
//! [loops]

//! [attributes]
/* Carries normals over: each vertex of the result has sources in the inputs. */
static void carry_normals(const gusset_result *stitch, const vertex *const old[2], vertex *result, size_t count) {
    gusset_channel normals = {0};
    const gusset_channel_values given[2] = {{old[0][0].normal, 5, sizeof(vertex)}, {old[1][0].normal, 5, sizeof(vertex)}};
    gusset_origins *origins = NULL;
    normals.struct_size = sizeof normals;
    normals.domain = GUSSET_DOMAIN_VERTICES;
    normals.value_type = GUSSET_VALUE_F32;
    normals.components = 3;
    normals.rule = GUSSET_RULE_NORMAL;
    must(gusset_result_origins_create(NULL, stitch, &origins), NULL);
    must(gusset_attributes_apply(NULL, origins, &normals, given, 2, result[0].normal, count, sizeof(vertex)), NULL);
    gusset_origins_destroy(origins);
}
//! [attributes]

int main(void) {
    static const vertex up[5] = {
        {{0, 0, 2}, {0, 0, 1}}, {{1, 0, 1}, {1, 0, 0}}, {{0, 1, 1}, {0, 1, 0}}, {{-1, 0, 1}, {-1, 0, 0}}, {{0, -1, 1}, {0, -1, 0}}};
    static const vertex down[5] = {
        {{0, 0, -2}, {0, 0, -1}}, {{1, 0, -1}, {1, 0, 0}}, {{0, -1, -1}, {0, -1, 0}}, {{-1, 0, -1}, {-1, 0, 0}}, {{0, 1, -1}, {0, 1, 0}}};
    static const uint32_t faces[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
    const vertex *const old[2] = {up, down};
    const gusset_mesh_view a = view_of(up, 5, faces, 4), b = view_of(down, 5, faces, 4);
    gusset_stitch_options options = {0};
    gusset_mesh_view whole = {0};
    gusset_stitch_report parts = {0};
    gusset_quality_report quality = {0};
    gusset_context *context = NULL;
    gusset_result *stitch = NULL;
    vertex *result;
    size_t v;

    if (gusset_abi() != 1) {
        fprintf(stderr, "this program was built for another gusset than %s\n", gusset_version());
        return 1;
    }
    must(gusset_context_create(&context), NULL);
    must(gusset_context_set_progress(context, on_progress, stderr), NULL);
    print_loops(context, &a);

    //! [stitch]
    options.struct_size = sizeof options; /* other fields 0: the defaults */
    options.finish = GUSSET_FINISH_BLEND; /* new vertices on a smooth surface; the default is a strip */
    must(gusset_stitch(context, &a, NULL, &b, NULL, &options, &stitch), context);
    //! [stitch]

    //! [result]
    whole.struct_size = sizeof whole;
    parts.struct_size = sizeof parts;
    quality.struct_size = sizeof quality;
    must(gusset_result_get_mesh(stitch, &whole), NULL);
    must(gusset_result_get_stitch(stitch, &parts), NULL);
    must(gusset_result_get_quality(stitch, &quality), NULL);
    printf("%lu vertices, %lu faces, %lu of them new; %lu loops left\n", (unsigned long)whole.vertex_count,
           (unsigned long)whole.face_count, (unsigned long)parts.strip_face_count, (unsigned long)quality.loops_left);
    //! [result]

    result = calloc(whole.vertex_count, sizeof *result);
    if (result == NULL) {
        return 1;
    }
    for (v = 0; v < whole.vertex_count; ++v) {
        memcpy(result[v].position, (const float *)whole.positions + 3 * v, sizeof result[v].position);
    }
    carry_normals(stitch, old, result, whole.vertex_count);
    printf("the first new vertex has the normal %g %g %g\n", result[10].normal[0], result[10].normal[1], result[10].normal[2]);

    free(result);
    gusset_result_destroy(stitch);
    gusset_context_destroy(context);
    return quality.loops_left != 0;
}
