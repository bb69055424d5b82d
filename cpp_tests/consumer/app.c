/* A program of somebody else's: joins two pyramids, and knows the library by its header alone. */
#include <gusset.h>
#include <stdio.h>
#include <string.h>

int main(void) {
    const double up[5][3] = {{0, 0, 2}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
    const double down[5][3] = {{0, 0, -2}, {1, 0, -1}, {0, -1, -1}, {-1, 0, -1}, {0, 1, -1}};
    const uint32_t faces[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
    gusset_mesh_view a = {sizeof a, up, 0, 5, NULL, faces, 4, GUSSET_F64, GUSSET_U32, 3, 0, NULL};
    gusset_mesh_view b = a, joined = {sizeof joined, NULL, 0, 0, NULL, NULL, 0, 0, 0, 0, 0, NULL};
    gusset_result *stitch = NULL;
    size_t vertices, faces_joined;
    b.positions = down;
    if (strcmp(gusset_version(), GUSSET_VERSION_STRING) != 0) {
        printf("the header is of %s, the library of %s\n", GUSSET_VERSION_STRING, gusset_version());
        return 1;
    }
    if (gusset_stitch(NULL, &a, NULL, &b, NULL, NULL, &stitch) != GUSSET_OK ||
        gusset_result_get_mesh(stitch, &joined) != GUSSET_OK) {
        return 1;
    }
    vertices = joined.vertex_count;
    faces_joined = joined.face_count;
    gusset_result_destroy(stitch);
    printf("%zu vertices, %zu faces\n", vertices, faces_joined);
    return vertices == 10 && faces_joined == 16 ? 0 : 1;
}
