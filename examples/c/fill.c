/* A mesh with a hole becomes closed. */
#include <gusset.h>
#include <stdio.h>

int main(void) {
    const float points[15] = {0, 0, 2, 1, 0, 1, 0, 1, 1, -1, 0, 1, 0, -1, 1};
    const uint32_t corners[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
    const gusset_mesh_view mesh = gusset_triangles_f32(points, 5, corners, 4);
    gusset_result *result = NULL;
    if (gusset_fill(NULL, &mesh, NULL, 0, NULL, &result) != GUSSET_OK) {
        return 1;
    }
    printf("%zu faces\n", gusset_result_mesh(result).face_count);
    gusset_result_destroy(result);
}
