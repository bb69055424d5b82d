/* A net of 3 x 4 points becomes a mesh. */
#include <gusset.h>
#include <stdio.h>

int main(void) {
    double points[12 * 3];
    for (int i = 0; i < 12; ++i) {
        points[3 * i] = i / 4, points[3 * i + 1] = i % 4, points[3 * i + 2] = 0;
    }
    const gusset_net_view view = gusset_net_points_f64(points, 3, 4);
    gusset_net *net = NULL;
    gusset_result *result = NULL;
    if (gusset_net_create(NULL, &view, NULL, GUSSET_NET_MEMORY_COPY, &net) != GUSSET_OK ||
        gusset_net_to_mesh(NULL, net, NULL, &result) != GUSSET_OK) {
        return 1;
    }
    printf("%zu faces\n", gusset_result_mesh(result).face_count);
    gusset_result_destroy(result);
    gusset_net_destroy(net);
}
