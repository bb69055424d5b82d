/* Inputs for any filter, made by formulas: what each one must be is read from the plugin's table. */
#ifndef SHAPES_H
#define SHAPES_H

#include <gusset_plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { MOST_INPUTS = 4, TRIES = 6 };

/* Inputs, and the memory that they show. Not to be copied: they point into themselves. */
typedef struct shapes {
    gusset_input inputs[MOST_INPUTS];
    uint32_t count;
    union {
        gusset_plugin_mesh mesh;
        gusset_plugin_curves curves;
    } views[MOST_INPUTS];
    void *memory[MOST_INPUTS][3];
} shapes;

/* Inputs that the filter takes by their kinds and number, of about size x size faces or points each. The filter may
 * need more than that, so there are TRIES of them, by number. Meshes, all of quads in rows and columns: an open sheet,
 * a tube, a sphere, again the sheet and the tube, alone where a filter takes one or two, and a sphere with boxes around
 * it where a filter takes more. Curves: closed rings one above the other, the same cut open, two rings side by side in
 * the plane z = 0; then there one, cut open, and the rings cut open again, alone as well. */
void shapes_make(shapes *made, const gusset_filter *filter, uint32_t number, uint32_t size);
void shapes_free(shapes *made);

#ifdef __cplusplus
}
#endif

#endif
