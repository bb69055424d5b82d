#include <gusset.h>
#include <stdio.h>

int main(void) {
    /* Two open pyramids, point up and point down, with a gap between their square rims. */
    const float up[5][3] = {{0, 0, 2}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
    const float down[5][3] = {{0, 0, -2}, {1, 0, -1}, {0, -1, -1}, {-1, 0, -1}, {0, 1, -1}};
    const uint32_t faces[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};

    const gusset_mesh_view pieces[2] = {gusset_triangles_f32(up[0], 5, faces, 4),
                                        gusset_triangles_f32(down[0], 5, faces, 4)};
    gusset_mesh_view joined = {.struct_size = sizeof joined};
    gusset_result *result = NULL;
    if (gusset_join(NULL, pieces, 2, NULL, &result) == GUSSET_OK && gusset_result_get_mesh(result, &joined) == GUSSET_OK) {
        printf("%zu vertices, %zu faces\n", joined.vertex_count, joined.face_count);
    }
    gusset_result_destroy(result);
    return joined.face_count == 0;
}
