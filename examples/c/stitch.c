#include <gusset.h>
#include <stdio.h>

int main(void) {
    /* Two open pyramids, point up and point down, with a gap between their square rims. */
    const float up[5][3] = {{0, 0, 2}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
    const float down[5][3] = {{0, 0, -2}, {1, 0, -1}, {0, -1, -1}, {-1, 0, -1}, {0, 1, -1}};
    const uint32_t faces[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
    gusset_mesh_view a = {sizeof a, up, 0, 5, NULL, faces, 4, GUSSET_F32, GUSSET_U32, 3, 0, NULL};
    gusset_mesh_view b = a, joined = {sizeof joined, NULL, 0, 0, NULL, NULL, 0, 0, 0, 0, 0, NULL};
    gusset_stitch *stitch = NULL;
    b.positions = down;
    gusset_status status = gusset_stitch_create(NULL, &a, NULL, &b, NULL, NULL, &stitch);
    if (status != GUSSET_OK || (status = gusset_stitch_get_mesh(stitch, &joined)) != GUSSET_OK) {
        printf("%s\n", gusset_status_text(status));
        return 1;
    }
    printf("%zu vertices, %zu faces\n", joined.vertex_count, joined.face_count);
    gusset_stitch_destroy(stitch);
    return 0;
}
