/* Nets in space: what a host can get wrong when it moves, deforms and measures them, and what it gets if
   it does not. */
#include "check.h"
#include <math.h>

enum { ROWS = 5, COLUMNS = 9, NODES = ROWS * COLUMNS, CELLS = (ROWS - 1) * (COLUMNS - 1) };

static gusset_context *context;
static double x[NODES], y[NODES], z[NODES];

/* x = column, y = row, z = 0. */
static gusset_net *sheet(void) {
    gusset_net_view arrays = {sizeof arrays, ROWS, COLUMNS, x, y, z, 0, 0, GUSSET_F64, 0};
    gusset_net *net = NULL;
    for (int k = 0; k < NODES; k++) {
        x[k] = k % COLUMNS, y[k] = k / COLUMNS, z[k] = 0;
    }
    EXPECT(GUSSET_OK, gusset_net_create(context, &arrays, NULL, GUSSET_NET_MEMORY_COPY, &net));
    return net;
}

/* A square prism, 2 x 2 x 2, with its caps drawn together in their middles. */
static gusset_net *prism(void) {
    static const double corners[5][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}};
    double px[20], py[20], pz[20];
    gusset_net_view arrays = {sizeof arrays, 4, 5, px, py, pz, 0, 0, GUSSET_F64, 0};
    gusset_net_gluing gluing;
    gusset_net *net = NULL;
    memset(&gluing, 0, sizeof gluing);
    gluing.struct_size = sizeof gluing;
    gluing.sides = GUSSET_SIDES_TWO_POLES;
    for (int k = 0; k < 20; k++) {
        const int row = k / 5, pole = row == 0 || row == 3;
        px[k] = pole ? 0 : corners[k % 5][0];
        py[k] = pole ? 0 : corners[k % 5][1];
        pz[k] = row < 2 ? -1 : 1;
    }
    EXPECT(GUSSET_OK, gusset_net_create(context, &arrays, &gluing, GUSSET_NET_MEMORY_COPY, &net));
    return net;
}

static gusset_net_view view(const gusset_net *net) {
    gusset_net_view arrays;
    memset(&arrays, 0, sizeof arrays);
    arrays.struct_size = sizeof arrays;
    EXPECT(GUSSET_OK, gusset_net_get_view(net, &arrays));
    return arrays;
}

static gusset_net_gluing_report gluing_of(const gusset_net *net) {
    gusset_net_gluing_report report;
    memset(&report, 0, sizeof report);
    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_net_get_gluing(net, NULL, 0, NULL, 0, &report));
    return report;
}

static double x_of(const gusset_net *net, int node) { return ((const double *)view(net).x)[node]; }
static double y_of(const gusset_net *net, int node) { return ((const double *)view(net).y)[node]; }

static gusset_operation operation(uint32_t kind, double a, double b, double c, double d) {
    gusset_operation made;
    memset(&made, 0, sizeof made);
    made.kind = kind;
    made.values[0] = a, made.values[1] = b, made.values[2] = c, made.values[3] = d;
    return made;
}

static void transforms(void) {
    const double quarter = acos(0.0);
    gusset_net *net = sheet();
    gusset_operation chain[7], bad;
    unsigned char odd[sizeof chain + 1];

    chain[0] = operation(GUSSET_OPERATION_TRANSLATE, 1, 0, 0, 0);
    chain[1] = operation(GUSSET_OPERATION_ROTATE, 0, 0, 5, quarter);
    chain[2] = operation(GUSSET_OPERATION_ROTATE_AS_PRINTED, 0, 0, 5, quarter);
    chain[3] = operation(GUSSET_OPERATION_SCALE, 2, 0, 0, 0);
    chain[4] = operation(GUSSET_OPERATION_COMPRESS, 0.5, 0, 0, 0);
    chain[4].axis = GUSSET_AXIS_Y;
    chain[5] = operation(GUSSET_OPERATION_STRETCH, 1, 1, -1, 0);
    chain[6] = operation(GUSSET_OPERATION_MATRIX, 1, 0, 0, 10);
    chain[6].values[5] = 1, chain[6].values[10] = 1;
    memcpy(odd + 1, chain, sizeof chain);
    EXPECT(GUSSET_OK, gusset_net_transform(context, net, (const gusset_operation *)(const void *)(odd + 1), 7));
    /* (3, 2) -> (4, 2), there and back, x2, x / 2, + 10 */
    CHECK(fabs(x_of(net, 2 * COLUMNS + 3) - 14) < 1e-14 && fabs(y_of(net, 2 * COLUMNS + 3) - 4) < 1e-14);
    CHECK(gluing_of(net).reversed == 1);
    EXPECT(GUSSET_OK, gusset_net_transform(context, net, NULL, 0));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_transform(context, net, NULL, 1));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_transform(context, NULL, chain, 1));
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_net_transform(context, net, chain, SIZE_MAX));
    bad = chain[0], bad.kind = 0;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_transform(context, net, &bad, 1));
    bad = chain[0], bad.axis = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_transform(context, net, &bad, 1));
    bad = chain[4], bad.axis = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_transform(context, net, &bad, 1));
    bad = operation(GUSSET_OPERATION_ROTATE, 0, 0, 0, 1);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_transform(context, net, &bad, 1));
    bad = operation(GUSSET_OPERATION_SCALE, NAN, 0, 0, 0);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_transform(context, net, &bad, 1));
    gusset_net_destroy(net);
}

static gusset_field field(uint32_t kind, uint32_t axis, double a, double b, double c, double d) {
    gusset_field made;
    memset(&made, 0, sizeof made);
    made.struct_size = sizeof made;
    made.kind = kind;
    made.axis = axis;
    made.strength = 1;
    made.values[0] = a, made.values[1] = b, made.values[2] = c, made.values[3] = d;
    return made;
}

static void kinds_of_fields(void) {
    static const double offsets[24] = {0, 0, 0, 0, 0, 0, 0, 0, 1};
    gusset_field fields[14];
    fields[0] = field(GUSSET_FIELD_AFFINE, 0, 1, 0, 0, 3);
    fields[0].values[5] = 1, fields[0].values[10] = 1;
    fields[1] = field(GUSSET_FIELD_TWIST, GUSSET_AXIS_X, 0.1, 0, 0, 0);
    fields[2] = field(GUSSET_FIELD_TAPER, GUSSET_AXIS_X, 0.1, 0, 0, 0);
    fields[3] = field(GUSSET_FIELD_BEND, GUSSET_AXIS_X, 0.1, 0, INFINITY, 0);
    fields[4] = field(GUSSET_FIELD_SHEAR, GUSSET_AXIS_X, 0.5, 0, 0, 0);
    fields[4].other_axis = GUSSET_AXIS_Y;
    fields[5] = field(GUSSET_FIELD_SPHERIFY, 0, 0, 0, -9, 2);
    fields[6] = field(GUSSET_FIELD_CYLINDER_WRAP, GUSSET_AXIS_Y, 2, 0, 0, 0);
    fields[7] = field(GUSSET_FIELD_TORUS_WRAP, GUSSET_AXIS_Z, 3, 1, 0, 0);
    fields[8] = field(GUSSET_FIELD_LATTICE, 0, -50, -50, -50, 50);
    fields[8].values[4] = 50, fields[8].values[5] = 50;
    fields[8].offsets = offsets;
    fields[8].counts[0] = fields[8].counts[1] = fields[8].counts[2] = 2;
    fields[9] = field(GUSSET_FIELD_PROJECTION, 0, 1, 0, 0, 0);
    fields[9].values[5] = 1, fields[9].values[10] = 1, fields[9].values[15] = 2;
    fields[10] = field(GUSSET_FIELD_PARALLEL, 0, 0, 0, 0, 0);
    fields[10].values[5] = 1, fields[10].values[7] = 1, fields[10].values[8] = 1;
    fields[11] = field(GUSSET_FIELD_PERSPECTIVE, 0, 0, 0, 9, 0);
    fields[11].values[8] = 1;
    fields[12] = field(GUSSET_FIELD_CONE_WRAP, GUSSET_AXIS_X, 3, 0.5, 0, 0);
    fields[13] = field(GUSSET_FIELD_SPHERE_WRAP, GUSSET_AXIS_Y, 3, 0, 0, 0);
    for (int k = 0; k < 14; k++) {
        gusset_net *net = sheet();
        EXPECT(GUSSET_OK, gusset_net_deform(context, net, &fields[k], 1, 0));
        fields[k].strength = 0.5;
        EXPECT(GUSSET_OK, gusset_net_deform(context, net, &fields[k], 1, 0));
        gusset_net_destroy(net);
    }
    {
        gusset_net *net = sheet();
        EXPECT(GUSSET_OK, gusset_net_deform(context, net, fields, 14, 0));
        gusset_net_destroy(net);
    }
}

static void wrong_fields(void) {
    static const double keys[4] = {0, 0, 2, 1};
    gusset_net *net = sheet();
    gusset_field good = field(GUSSET_FIELD_SHEAR, GUSSET_AXIS_X, 1, 0, 0, 0), bad;
    good.other_axis = GUSSET_AXIS_Y;
    good.keys = keys, good.key_count = 2;
    /* Half of the shear at time 1. */
    EXPECT(GUSSET_OK, gusset_net_deform(context, net, &good, 1, 1.0));
    CHECK(x_of(net, COLUMNS) == 0.5 && x_of(net, 2 * COLUMNS + 1) == 2.0);
    EXPECT(GUSSET_OK, gusset_net_deform(context, net, &good, 1, -7.0));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_deform(context, net, &good, 1, NAN));
    EXPECT(GUSSET_OK, gusset_net_deform(context, net, NULL, 0, 0));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_deform(context, net, NULL, 1, 0));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_deform(context, NULL, &good, 1, 0));
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_net_deform(context, net, &good, SIZE_MAX, 0));
    bad = good, bad.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_deform(context, net, &bad, 1, 0));
    bad = good, bad.kind = 15;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_deform(context, net, &bad, 1, 0));
    bad = good, bad.axis = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_deform(context, net, &bad, 1, 0));
    bad = good, bad.other_axis = GUSSET_AXIS_X;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_deform(context, net, &bad, 1, 0));
    bad = good, bad.easing = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_deform(context, net, &bad, 1, 0));
    bad = good, bad.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_deform(context, net, &bad, 1, 0));
    bad = good, bad.keys = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_deform(context, net, &bad, 1, 0));
    bad = good, bad.strength = INFINITY;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_deform(context, net, &bad, 1, 0.5));
    /* What is wrong with the second of two is said of it, that it is of another version too. */
    {
        gusset_field two[2];
        gusset_error_report report = {sizeof report, 0, 0, 0, 0, 0, 0};
        for (int k = 0; k < 3; ++k) {
            two[0] = two[1] = good;
            if (k == 0) two[1].struct_size += 8;
            if (k == 1) two[1].keys = NULL, two[1].key_count = 0, two[1].strength = NAN;
            if (k == 2) two[1].reserved = 1;
            EXPECT(k == 0   ? GUSSET_ERROR_BAD_STRUCT_SIZE
                   : k == 1 ? GUSSET_ERROR_OUT_OF_RANGE
                            : GUSSET_ERROR_UNKNOWN_VALUE,
                   gusset_net_deform(context, net, two, 2, 0));
            EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
            CHECK(report.element == GUSSET_ELEMENT_ITEM && report.index == 1);
        }
    }
    bad = field(GUSSET_FIELD_LATTICE, 0, 0, 0, 0, 1);
    bad.values[4] = bad.values[5] = 1;
    bad.counts[0] = 33, bad.counts[1] = bad.counts[2] = 2;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_deform(context, net, &bad, 1, 0));
    bad.counts[0] = 2;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_deform(context, net, &bad, 1, 0));
    bad = field(GUSSET_FIELD_CONE_WRAP, GUSSET_AXIS_X, 3, 1.6, 0, 0);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_deform(context, net, &bad, 1, 0));
    bad = field(GUSSET_FIELD_SPHERE_WRAP, GUSSET_AXIS_X, -3, 0, 0, 0);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_deform(context, net, &bad, 1, 0));
    bad = field(GUSSET_FIELD_SPHERE_WRAP, 7, 3, 0, 0, 0);
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_deform(context, net, &bad, 1, 0));
    /* The centre of the sphere is a node. */
    bad = field(GUSSET_FIELD_SPHERIFY, 0, 0, 0, 0, 1);
    EXPECT(GUSSET_ERROR_FIELD_UNDEFINED, gusset_net_deform(context, net, &bad, 1, 0));
    CHECK(x_of(net, COLUMNS) == 0.5);
    gusset_net_destroy(net);
}

static void functions_of_the_host(void) {
    gusset_net *net = prism();
    gusset_net_view lent = view(net);
    gusset_glue_options snap = {.struct_size = sizeof snap, .snap = 1};
    uint64_t moved = 7;
    EXPECT(GUSSET_OK, gusset_net_edit(context, net, &lent));
    for (size_t k = 0; k < 20; k++) {
        ((double *)lent.z)[k] = (double)k;
    }
    EXPECT(GUSSET_OK, gusset_net_glue(context, net, &snap, &moved));
    /* The last row is one point, its first: of four nodes, and so of the first row; two rows are closed. */
    CHECK(moved == 10 && ((const double *)view(net).z)[19] == 15.0);
    EXPECT(GUSSET_OK, gusset_net_glue(context, net, &snap, &moved));
    CHECK(moved == 0);
    EXPECT(GUSSET_OK, gusset_net_glue(context, net, &snap, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_glue(context, NULL, &snap, &moved));
    snap.snap = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_glue(context, net, &snap, &moved));
    EXPECT(GUSSET_OK, gusset_net_displace(context, net, 0.25));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_displace(context, net, NAN));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_displace(context, NULL, 1));
    gusset_net_destroy(net);
}

static void analyses(void) {
    const double radius = (COLUMNS - 1) / (4 * acos(0.0));
    gusset_net *net = sheet(), *after = sheet();
    gusset_net_analysis *analysis = (gusset_net_analysis *)misaligned();
    gusset_net_analysis_options options, bad;
    gusset_net_analysis_view parts;
    gusset_field wrap = field(GUSSET_FIELD_CYLINDER_WRAP, GUSSET_AXIS_Y, radius, 0, 0, 0);
    gusset_field stand = field(GUSSET_FIELD_AFFINE, 0, 0, 0, 1, 0), both[2];
    const uint32_t bad_link = 2 * NODES;
    gusset_glue_options glue = {.struct_size = sizeof glue, .snap = 1};
    uint64_t moved = 0;

    /* About y the arc is z and the height x: exchange them first. */
    stand.values[5] = 1, stand.values[8] = -1;
    both[0] = stand, both[1] = wrap;
    memset(&parts, 0, sizeof parts);
    parts.struct_size = sizeof parts;
    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    options.fields = both, options.field_count = 2, options.tolerance = 1e-9;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_analysis_create(context, NULL, &options, &analysis));
    CHECK(analysis == NULL);
    bad = options, bad.tolerance = -1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_analysis_create(context, net, &bad, &analysis));
    bad = options, bad.after = after;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_analysis_create(context, net, &bad, &analysis));
    bad = options, bad.fields = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_analysis_create(context, net, &bad, &analysis));
    bad = options, bad.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_analysis_create(context, net, &bad, &analysis));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_analysis_create(context, net, &options, NULL));
    CHECK(analysis == NULL);
    EXPECT(GUSSET_OK, gusset_net_analysis_create(context, net, &options, &analysis));
    EXPECT(GUSSET_OK, gusset_net_analysis_get_view(analysis, &parts));
    CHECK(parts.link_count == 2 * NODES && parts.cell_count == CELLS && parts.determinants != NULL && parts.soft == 0);
    CHECK(parts.contracted_count == ROWS && parts.contracted[0] == 2 * (COLUMNS - 1) && parts.stars[0] == 0);
    CHECK(parts.torn_count == 0 && parts.torn == NULL && parts.folded_count == 0);
    CHECK(fabs(parts.determinants[0] - 1) < 1e-7);
    EXPECT(GUSSET_OK, gusset_net_deform(context, net, both, 2, 0));
    glue.links = parts.contracted, glue.link_count = parts.contracted_count;
    EXPECT(GUSSET_OK, gusset_net_glue(context, net, &glue, &moved));
    CHECK(moved == ROWS && gluing_of(net).sides == GUSSET_SIDES_TUBE);
    glue.links = &bad_link, glue.link_count = 1;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_net_glue(context, net, &glue, NULL));
    glue.links = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_glue(context, net, &glue, NULL));
    glue.links = &bad_link, glue.link_count = SIZE_MAX;
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_net_glue(context, net, &glue, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_analysis_get_view(NULL, &parts));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_analysis_get_view(analysis, NULL));
    parts.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_analysis_get_view(analysis, &parts));
    gusset_net_analysis_destroy(analysis);

    parts.struct_size = sizeof parts;
    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options, options.after = after;
    EXPECT(GUSSET_OK, gusset_net_analysis_create(context, after, &options, &analysis));
    EXPECT(GUSSET_OK, gusset_net_analysis_get_view(analysis, &parts));
    CHECK(parts.soft == 1 && parts.determinants == NULL && parts.links[0] == 1.0 && parts.cells[CELLS - 1] == 1.0);
    gusset_net_analysis_destroy(analysis);
    gusset_net_analysis_destroy(NULL);
    /* No deformation. */
    EXPECT(GUSSET_OK, gusset_net_analysis_create(context, after, NULL, &analysis));
    EXPECT(GUSSET_OK, gusset_net_analysis_get_view(analysis, &parts));
    CHECK(parts.soft == 1 && parts.links[0] == 1.0 && fabs(parts.determinants[0] - 1) < 1e-7);
    gusset_net_analysis_destroy(analysis);
    gusset_net_destroy(net);
    net = prism();
    EXPECT(GUSSET_ERROR_SIDES_DIFFER, gusset_net_analysis_create(context, net, &options, &analysis));
    options.after = net, options.tolerance = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_analysis_create(context, net, &options, &analysis));
    CHECK(analysis == NULL);
    gusset_net_destroy(net);
    gusset_net_destroy(after);
}

static void normals_and_measures(void) {
    gusset_net *net = prism();
    double nx[20], ny[20], nz[20], cells[12];
    uint64_t without = 9;
    size_t written = 7;
    gusset_net_measure_report measures;
    gusset_net_planarity_report summary;
    gusset_net_view own = view(net);

    EXPECT(GUSSET_OK, gusset_net_normals(context, net, nx, ny, nz, 20, &without));
    CHECK(without == 0 && nz[0] == -1 && nz[19] == 1 && nx[5] == nx[9] && fabs(nx[5] - ny[5]) < 1e-15);
    EXPECT(GUSSET_OK, gusset_net_normals(context, net, nx, ny, nz, 20, NULL));
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_net_normals(context, net, nx, ny, nz, 19, &without));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_normals(context, net, nx, NULL, nz, 20, &without));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_normals(context, NULL, nx, ny, nz, 20, &without));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_net_normals(context, net, misaligned(), ny, nz, 20, &without));
    EXPECT(GUSSET_ERROR_OVERLAP, gusset_net_normals(context, net, nx, nx, nz, 20, &without));
    EXPECT(GUSSET_ERROR_OVERLAP, gusset_net_normals(context, net, nx, ny, own.y, 20, &without));

    measures.struct_size = sizeof measures;
    summary.struct_size = sizeof summary;
    EXPECT(GUSSET_OK, gusset_net_measure(context, net, GUSSET_NET_MEASURES_EXTENT, &measures));
    CHECK(measures.volume == 8 && measures.area == 24 && measures.low[0] == -1 && measures.high[2] == 1);
    CHECK(measures.area_vector[0] == 0 && measures.area_vector[1] == 0 && measures.area_vector[2] == 0);
    CHECK(measures.bilinear_area == 0 && measures.body_volume == 0 && measures.inertia[0] == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_measure(context, NULL, GUSSET_NET_MEASURES_EXTENT, &measures));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_measure(context, net, GUSSET_NET_MEASURES_EXTENT, NULL));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_measure(context, net, 8, &measures));
    EXPECT(GUSSET_OK, gusset_net_measure(context, net, GUSSET_NET_MEASURES_BODY, &measures));
    CHECK(fabs(measures.body_volume - 8) < 1e-13 && fabs(measures.centroid[2]) < 1e-15 && measures.volume == 0);
    CHECK(fabs(measures.inertia[0] - 16.0 / 3) < 1e-13 && fabs(measures.inertia[1]) < 1e-13);
    EXPECT(GUSSET_OK, gusset_net_measure(context, net, 0, &measures));
    CHECK(measures.area == 0 && measures.body_volume == 0);
    measures.struct_size = 0;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_measure(context, net, GUSSET_NET_MEASURES_EXTENT, &measures));
    EXPECT(GUSSET_OK, gusset_net_planarity(context, net, 0, NULL, 0, &written, &summary));
    CHECK(written == 12 && summary.worst == 0 && summary.above == 0);
    EXPECT(GUSSET_OK, gusset_net_planarity(context, net, 0, cells, 12, &written, &summary));
    CHECK(cells[11] == 0);
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_net_planarity(context, net, 0, cells, 11, &written, &summary));
    CHECK(written == 12);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_planarity(context, net, NAN, cells, 12, &written, &summary));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_planarity(context, net, 0, cells, 12, NULL, &summary));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_planarity(context, net, 0, cells, 12, &written, NULL));
    gusset_net_destroy(net);
}

static void areas_and_plane_cells(void) {
    gusset_net *net = sheet();
    gusset_net_measure_report measures;
    uint8_t fixed[NODES] = {0};
    gusset_planarise_options options;
    gusset_planarise_report report;

    measures.struct_size = sizeof measures;
    EXPECT(GUSSET_OK, gusset_net_measure(context, net, GUSSET_NET_MEASURES_BILINEAR, &measures));
    CHECK(fabs(measures.bilinear_area - CELLS) < 1e-12 && measures.bilinear_error < 1e-12 && measures.area == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_measure(context, NULL, GUSSET_NET_MEASURES_BILINEAR, &measures));
    CHECK(measures.bilinear_area == 0);

    memset(&options, 0, sizeof options);
    memset(&report, 0, sizeof report);
    options.struct_size = sizeof options, report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_net_planarise(context, net, NULL, &report));
    CHECK(report.converged == 1 && report.iterations == 0 && report.max_displacement == 0);
    EXPECT(GUSSET_OK, gusset_net_planarise(context, net, &options, &report));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_planarise(context, net, &options, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_planarise(context, NULL, &options, &report));
    options.tolerance = -1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_planarise(context, net, &options, &report));
    options.tolerance = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_planarise(context, net, &options, &report));
    options.tolerance = 0, options.keep_boundary = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_planarise(context, net, &options, &report));
    options.keep_boundary = 1, options.fixed = fixed, options.fixed_count = NODES;
    EXPECT(GUSSET_OK, gusset_net_planarise(context, net, &options, &report));
    options.fixed_count = NODES - 1;
    EXPECT(GUSSET_ERROR_COUNT_DIFFERS, gusset_net_planarise(context, net, &options, &report));
    options.fixed_count = 0;
    EXPECT(GUSSET_ERROR_COUNT_DIFFERS, gusset_net_planarise(context, net, &options, &report));
    options.fixed_count = NODES, options.fixed = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_planarise(context, net, &options, &report));
    options.fixed = fixed, fixed[3] = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_planarise(context, net, &options, &report));
    options.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_planarise(context, net, &options, &report));
    report.struct_size = 0;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_planarise(context, net, NULL, &report));
    gusset_net_destroy(net);
}

static void morphs(void) {
    gusset_net *net = sheet(), *closed = prism(), *between = (gusset_net *)misaligned(), *single = NULL;
    const gusset_net_gluing tube = {.struct_size = sizeof tube, .sides = GUSSET_SIDES_TUBE};
    const gusset_net_copy_options floats = {.struct_size = sizeof floats, .scalar = GUSSET_F32};

    EXPECT(GUSSET_OK, gusset_net_morph_create(context, net, net, 0.5, GUSSET_MORPH_RIGID, &between));
    CHECK(fabs(x_of(between, 1) - 1) < 1e-12);
    gusset_net_destroy(between);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_morph_create(context, net, net, 1.5, 0, &between));
    CHECK(between == NULL);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_morph_create(context, net, net, NAN, 0, &between));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_morph_create(context, net, net, 0.5, 2, &between));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_morph_create(context, NULL, net, 0.5, 0, &between));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_morph_create(context, net, NULL, 0.5, 0, &between));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_morph_create(context, net, net, 0.5, 0, NULL));
    EXPECT(GUSSET_ERROR_SIDES_DIFFER, gusset_net_morph_create(context, net, closed, 0.5, 0, &between));
    EXPECT(GUSSET_OK, gusset_net_copy_create(context, net, &floats, &single));
    EXPECT(GUSSET_ERROR_MIXED_SCALARS, gusset_net_morph_create(context, net, single, 0.5, 0, &between));
    gusset_net_destroy(single);
    EXPECT(GUSSET_OK, gusset_net_copy_create(context, net, NULL, &single));
    EXPECT(GUSSET_OK, gusset_net_set_gluing(context, single, &tube));
    EXPECT(GUSSET_ERROR_GLUINGS_DIFFER, gusset_net_morph_create(context, net, single, 0.5, 0, &between));
    gusset_net_destroy(single);
    gusset_net_destroy(closed);
    gusset_net_destroy(net);
}

int main(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    if (gusset_context_create(&context) != GUSSET_OK || up.face_count != down.face_count) {
        return 1;
    }
    transforms();
    kinds_of_fields();
    wrong_fields();
    functions_of_the_host();
    analyses();
    normals_and_measures();
    areas_and_plane_cells();
    morphs();
    gusset_context_destroy(context);
    return failures != 0;
}
