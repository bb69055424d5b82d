/* The distance of a point from the smooth surface through a grid of points. */
#include <gusset.h>
#include <stdio.h>

int main(void) {
    double points[16 * 3];
    for (int i = 0; i < 16; ++i) {
        points[3 * i] = i / 4, points[3 * i + 1] = i % 4, points[3 * i + 2] = 0.1 * (i / 4) * (i % 4);
    }
    const gusset_nodes nodes = gusset_nodes_f64(points, 4, 4);
    const double query[3] = {1.2, 1.7, 5};
    gusset_surface *surface = NULL;
    gusset_surface_nearest_point nearest;
    if (gusset_surface_from_nodes_create(NULL, &nodes, &surface) != GUSSET_OK ||
        gusset_surface_nearest(NULL, surface, query, 1, NULL, &nearest) != GUSSET_OK) {
        return 1;
    }
    printf("distance %g\n", nearest.distance);
    gusset_surface_destroy(surface);
}
