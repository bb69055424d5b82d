/* A plugin of somebody else's that holds the static library. */
#include <gusset.h>

__attribute__((visibility("default"))) int plugin_run(void);

int plugin_run(void) {
    /* More vertices than one thread takes, so that the call starts threads of its own. */
    static double nodes[200000][3];
    const uint32_t triangle[3] = {0, 1, 2};
    const gusset_mesh_view mesh = gusset_triangles_f64(nodes[0], 200000, triangle, 1);
    gusset_boundary *boundary = NULL;
    gusset_boundary_view loops = {sizeof loops, 0, 0, NULL, 0};
    nodes[1][0] = nodes[2][1] = 1;
    if (gusset_boundary_create(NULL, &mesh, NULL, &boundary) != GUSSET_OK) {
        return -1;
    }
    const gusset_status status = gusset_boundary_get_view(boundary, &loops);
    gusset_boundary_destroy(boundary);
    return status == GUSSET_OK ? (int)loops.loop_count : -1;
}
