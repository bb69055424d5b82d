/* A plane outline through four points, as the path of an SVG file. */
#include <gusset.h>
#include <stdio.h>

int main(void) {
    const double points[8] = {0, 0, 2, 0, 2, 1, 0, 1};
    const gusset_outlines given = gusset_points_f64(points, 4, 2, 1);
    gusset_curve *curve = NULL;
    gusset_curve_form *form = NULL;
    if (gusset_curve_from_points_create(NULL, &given, NULL, &curve) != GUSSET_OK ||
        gusset_curve_export_create(NULL, curve, GUSSET_CURVE_FORMAT_SVG, 0, &form) != GUSSET_OK) {
        return 1;
    }
    printf("<path d=\"%s\"/>\n", gusset_curve_form_lend(form).text);
    gusset_curve_form_destroy(form);
    gusset_curve_destroy(curve);
}
