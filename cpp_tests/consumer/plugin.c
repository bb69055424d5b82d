/* A plugin of somebody else's that holds the static library. */
#include <gusset.h>

__attribute__((visibility("default"))) int plugin_run(void);

int plugin_run(void) {
    /* More vertices than one thread takes, so that the call starts threads of its own. */
    static double nodes[200000][3];
    const uint32_t triangle[3] = {0, 1, 2};
    gusset_mesh_view mesh = {sizeof mesh, nodes, 0, 200000, NULL, triangle, 1, GUSSET_F64, GUSSET_U32, 3, 0, NULL};
    gusset_boundary *boundary = NULL;
    size_t loops;
    nodes[1][0] = nodes[2][1] = 1;
    if (gusset_boundary_create(NULL, &mesh, NULL, &boundary) != GUSSET_OK) {
        return -1;
    }
    loops = gusset_boundary_loop_count(boundary);
    gusset_boundary_destroy(boundary);
    return (int)loops;
}
