/* Calls functions of shapes, gluings, complexes and checks of nets with invalid and valid arguments, and checks
   errors and results. */
#include "check.h"
#include <math.h>

static gusset_context *context;

/* Rows and columns are the usual ones. */
static gusset_net_primitive shape(gusset_net_shape kind) {
    gusset_net_primitive primitive = {0};
    primitive.struct_size = sizeof primitive;
    primitive.shape = kind;
    primitive.scalar = GUSSET_F64;
    primitive.radius = 2, primitive.minor_radius = 0.5, primitive.height = 1;
    primitive.size[0] = primitive.size[1] = primitive.size[2] = 1;
    primitive.sides = 5;
    primitive.cells[0] = primitive.cells[1] = primitive.cells[2] = 3;
    return primitive;
}

static gusset_net *net_of(const gusset_net_primitive *primitive) {
    gusset_net *net = NULL;
    EXPECT(GUSSET_OK, gusset_net_primitive_create(context, primitive, &net));
    return net;
}

static gusset_status glue(gusset_net *net, const gusset_gluing *gluings, size_t count) {
    const gusset_glue_options options = {.struct_size = sizeof options, .gluings = gluings, .gluing_count = count};
    return gusset_net_glue(context, net, &options, NULL);
}

static gusset_status detect(gusset_net *net, double tolerance) {
    const gusset_glue_options options = {.struct_size = sizeof options, .detect = 1, .tolerance = tolerance};
    return gusset_net_glue(context, net, &options, NULL);
}

static gusset_status saturate(gusset_net *net) {
    const gusset_glue_options options = {.struct_size = sizeof options, .saturate = 1};
    return gusset_net_glue(context, net, &options, NULL);
}

static gusset_net_complex_view surface(const gusset_net *net, gusset_net_complex **complex) {
    gusset_net_complex_view report;
    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_net_complex_create(context, net, GUSSET_NET_CELLS_PRESENT, complex));
    EXPECT(GUSSET_OK, gusset_net_complex_get_view(*complex, &report));
    return report;
}

static size_t violations(const gusset_net *net, double tolerance) {
    gusset_net_validation *validation = NULL;
    gusset_net_validation_view report;
    size_t count;
    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_net_validation_create(context, net, tolerance, &validation));
    EXPECT(GUSSET_OK, gusset_net_validation_get_view(validation, &report));
    CHECK(report.violation_count <= report.count);
    CHECK(report.count == 0 || report.findings[0].nodes[0] != report.findings[0].nodes[1]);
    count = report.violation_count;
    gusset_net_validation_destroy(validation);
    return count;
}

static void shapes(void) {
    static const double vase[6] = {0, 0, 1, 0, 1, 1};
    /* Euler's characteristic and the number of boundary loops of each. */
    static const int expected[15][2] = {{1, 1}, {2, 0}, {2, 0}, {0, 2}, {2, 0}, {2, 0}, {2, 0}, {2, 0},
                                        {1, 1}, {0, 0}, {2, 0}, {0, 1}, {0, 0}, {1, 0}, {2, 0}};
    for (uint32_t kind = 0; kind < 15; kind++) {
        gusset_net_primitive primitive = shape(kind);
        gusset_net_complex *complex = NULL;
        gusset_net_complex_view report;
        gusset_net *net;
        primitive.profile = vase, primitive.profile_count = 3;
        net = net_of(&primitive);
        report = surface(net, &complex);
        CHECK(report.euler == expected[kind][0]);
        CHECK((int)report.boundary_offsets.count - 1 == expected[kind][1]);
        CHECK(report.boundary_open.count + 1 == report.boundary_offsets.count);
        CHECK(report.properties & GUSSET_NET_MANIFOLD);
        CHECK(!!(report.properties & GUSSET_NET_CLOSED) == (expected[kind][1] == 0));
        CHECK(!!(report.properties & GUSSET_NET_ORIENTABLE) == !(kind >= GUSSET_NET_MOEBIUS && kind < GUSSET_NET_PILLOW));
        CHECK(violations(net, 0) == 0);
        EXPECT(GUSSET_OK, detect(net, 0));
        CHECK(violations(net, 0) == 0);
        gusset_net_complex_destroy(complex);
        gusset_net_destroy(net);
    }
}

static void wrong_shapes(void) {
    gusset_net *net = (gusset_net *)misaligned();
    gusset_net_primitive bad = shape(GUSSET_NET_SPHERE);

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_primitive_create(context, NULL, &net));
    CHECK(net == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_primitive_create(context, &bad, NULL));
    bad.struct_size = 100;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_primitive_create(context, &bad, &net));
    bad = shape(15);
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_primitive_create(context, &bad, &net));
    bad = shape(GUSSET_NET_SPHERE), bad.scalar = 0;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_primitive_create(context, &bad, &net));
    bad = shape(GUSSET_NET_SPHERE), bad.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_primitive_create(context, &bad, &net));
    bad = shape(GUSSET_NET_SPHERE), bad.radius = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_primitive_create(context, &bad, &net));
    bad = shape(GUSSET_NET_SPHERE), bad.rows = 2;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_primitive_create(context, &bad, &net));
    bad = shape(GUSSET_NET_PLANE), bad.rows = SIZE_MAX;
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_net_primitive_create(context, &bad, &net));
    bad = shape(GUSSET_NET_BOX), bad.box_kind = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_primitive_create(context, &bad, &net));
    bad = shape(GUSSET_NET_BOX), bad.cells[1] = 0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_primitive_create(context, &bad, &net));
    bad = shape(GUSSET_NET_LATHE), bad.profile_count = 2;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_primitive_create(context, &bad, &net));
    bad.profile_count = SIZE_MAX;
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_net_primitive_create(context, &bad, &net));
    bad.profile_count = 0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_primitive_create(context, &bad, &net));
    CHECK(net == NULL);
}

/* A sheet of 6 x 6 nodes. */
static gusset_net *sheet(void) {
    gusset_net_primitive primitive = shape(GUSSET_NET_PLANE);
    primitive.rows = primitive.columns = 6;
    return net_of(&primitive);
}

static void gluing(void) {
    gusset_net *net = sheet();
    gusset_gluing gluing = {0}, two[2] = {{0}, {0}};
    gusset_gluing_type found = 99;
    uint64_t nodes[18], cells[18];
    uint32_t classes[36];
    size_t count = 9;

    /* Each of the 18 types is found again where it was made. */
    gluing.kind = GUSSET_GLUING_TYPE;
    for (uint32_t type = 0; type < 18; type++) {
        gluing.mask = type;
        gluing.element = type < GUSSET_TYPE_TOP_BOTTOM ? 14 : 12;
        EXPECT(GUSSET_OK, glue(net, &gluing, 1));
        if (type < GUSSET_TYPE_TOP_BOTTOM) {
            EXPECT(GUSSET_OK, gusset_net_classify(context, net, GUSSET_GLUING_PLACE_NODE, 14, 0, &found));
        } else {
            EXPECT(GUSSET_OK, gusset_net_classify(context, net, GUSSET_GLUING_PLACE_CELL, 12, 0, &found));
        }
        CHECK(found == type);
        EXPECT(GUSSET_OK, gusset_net_histogram(context, net, nodes, cells));
        CHECK((type < GUSSET_TYPE_TOP_BOTTOM ? nodes : cells)[type] >= 1);
        EXPECT(GUSSET_OK, gusset_net_unglue(context, net, &gluing, 1, 0, NULL));
        EXPECT(GUSSET_OK, gusset_net_classify(context, net, GUSSET_GLUING_PLACE_CELL, 12, 0, &found));
        CHECK(found == GUSSET_TYPE_NONE);
    }
    /* The nineteenth is refused, and the first half of the batch with it. */
    for (uint32_t k = 0; k < 2; k++) {
        two[k].kind = GUSSET_GLUING_DIAGONAL, two[k].element = 12, two[k].mask = k + 1;
    }
    EXPECT(GUSSET_ERROR_CROSSING_CELL, glue(net, two, 2));
    EXPECT(GUSSET_OK, gusset_net_classify(context, net, GUSSET_GLUING_PLACE_CELL, 12, 0, &found));
    CHECK(found == GUSSET_TYPE_NONE);

    gluing.mask = 18;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, glue(net, &gluing, 1));
    gluing.kind = 6;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, glue(net, &gluing, 1));
    gluing.kind = GUSSET_GLUING_LINK;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, glue(net, &gluing, 1));
    gluing.mask = 0, gluing.element = 72;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, glue(net, &gluing, 1));
    gluing.element = 0, gluing.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, glue(net, &gluing, 1));
    gluing.reserved = 0, gluing.kind = GUSSET_GLUING_STAR, gluing.mask = 16;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, glue(net, &gluing, 1));
    gluing.mask = 256;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, glue(net, &gluing, 1));
    gluing.mask = 1, gluing.element = 36;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, glue(net, &gluing, 1));
    gluing.kind = GUSSET_GLUING_CELL, gluing.element = 25;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, glue(net, &gluing, 1));
    gluing.kind = GUSSET_GLUING_DIAGONAL, gluing.element = 0, gluing.mask = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, glue(net, &gluing, 1));
    gluing.kind = GUSSET_GLUING_SEAM, gluing.mask = 0;
    EXPECT(GUSSET_ERROR_BAD_SEAM, glue(net, &gluing, 1));
    gluing.seam.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, glue(net, &gluing, 1));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, glue(net, NULL, 1));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, glue(NULL, &gluing, 0));
    EXPECT(GUSSET_ERROR_TOO_LARGE, glue(net, &gluing, SIZE_MAX));
    EXPECT(GUSSET_OK, glue(net, NULL, 0));
    {
        gusset_glue_options bad = {.struct_size = sizeof bad, .detect = 2};
        EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_glue(context, net, &bad, NULL));
        bad.detect = 0, bad.saturate = 2;
        EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_glue(context, net, &bad, NULL));
        bad.saturate = 0, bad.reserved = 1;
        EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_glue(context, net, &bad, NULL));
        bad.struct_size = 8;
        EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_glue(context, net, &bad, NULL));
        EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_glue(context, net, NULL, NULL));
        /* If a gluing is refused, the call neither detects nor snaps. */
        gusset_glue_options all = {.struct_size = sizeof all, .gluings = two, .gluing_count = 2, .detect = 1, .snap = 1};
        uint64_t moved = 9;
        EXPECT(GUSSET_ERROR_CROSSING_CELL, gusset_net_glue(context, net, &all, &moved));
        CHECK(moved == 0);
        EXPECT(GUSSET_OK, gusset_net_classify(context, net, GUSSET_GLUING_PLACE_CELL, 12, 0, &found));
        CHECK(found == GUSSET_TYPE_NONE);
    }

    /* Three sides of a cell, and so the fourth. */
    memset(&gluing, 0, sizeof gluing);
    gluing.kind = GUSSET_GLUING_CELL, gluing.element = 0, gluing.mask = 7;
    EXPECT(GUSSET_OK, glue(net, &gluing, 1));
    EXPECT(GUSSET_OK, saturate(net));
    {
        uint8_t matrix[72];
        gusset_net_gluing_report report = {.struct_size = sizeof report};
        EXPECT(GUSSET_OK, gusset_net_get_gluing(net, matrix, 72, NULL, 0, &report));
        CHECK(matrix[6] == 1);
    }
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, saturate(NULL));
    EXPECT(GUSSET_OK, gusset_net_classes(context, net, NULL, 0, &count));
    CHECK(count == 36);
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_net_classes(context, net, classes, 35, &count));
    EXPECT(GUSSET_OK, gusset_net_classes(context, net, classes, 36, &count));
    CHECK(classes[7] == 0 && classes[6] == 0 && classes[8] == 8);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_classes(context, NULL, classes, 36, &count));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_classes(context, net, classes, 36, NULL));
    gusset_net_destroy(net);
}

static void separation(void) {
    gusset_net_primitive primitive = shape(GUSSET_NET_TUBE);
    gusset_gluing links[3];
    gusset_net_gluing_report report = {.struct_size = sizeof report};
    gusset_net *net;
    uint64_t moved = 9;

    primitive.rows = 3, primitive.columns = 9;
    net = net_of(&primitive);
    memset(links, 0, sizeof links);
    for (uint32_t i = 0; i < 3; i++) {
        links[i].element = 2 * (9 * i + 8);
    }
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_unglue(context, net, links, 3, -1, &moved));
    CHECK(moved == 0);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_unglue(context, net, links, 3, NAN, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_unglue(context, NULL, links, 3, 0, NULL));
    EXPECT(GUSSET_OK, gusset_net_unglue(context, net, links, 3, 0.25, &moved));
    CHECK(moved == 6);
    EXPECT(GUSSET_OK, gusset_net_get_gluing(net, NULL, 0, NULL, 0, &report));
    CHECK(report.sides == GUSSET_SIDES_SHEET);
    gusset_net_destroy(net);
}

static void groups_and_types(void) {
    gusset_net_primitive primitive = shape(GUSSET_NET_SPHERE);
    gusset_net *net = net_of(&primitive);
    gusset_net_groups *groups = NULL;
    gusset_net_groups_view view = {.struct_size = sizeof view};
    gusset_gluing_type found = 99;
    uint64_t counts[18];

    EXPECT(GUSSET_OK, gusset_net_groups_create(context, net, &groups));
    EXPECT(GUSSET_OK, gusset_net_groups_get_view(groups, &view));
    /* Two poles and 31 nodes of the seam. */
    CHECK(view.offsets.count == 34 && view.offsets.data[1] == 65 && view.members.count == 2 * 65 + 31 * 2);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_groups_get_view(NULL, &view));
    CHECK(view.offsets.count == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_groups_get_view(groups, NULL));
    view.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_groups_get_view(groups, &view));
    gusset_net_groups_destroy(groups);
    gusset_net_groups_destroy(NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_groups_create(context, NULL, &groups));
    CHECK(groups == NULL);

    /* A node of the seam: its link to the first column counts if asked for. */
    EXPECT(GUSSET_OK, gusset_net_classify(context, net, GUSSET_GLUING_PLACE_NODE, 2 * 65 - 1, 1, &found));
    CHECK(found == GUSSET_TYPE_HORIZONTAL);
    EXPECT(GUSSET_OK, gusset_net_classify(context, net, GUSSET_GLUING_PLACE_NODE, 2 * 65 - 1, 0, &found));
    CHECK(found == GUSSET_TYPE_NONE);
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_classify(context, net, GUSSET_GLUING_PLACE_NODE, 0, 2, &found));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_net_classify(context, net, GUSSET_GLUING_PLACE_NODE, 33 * 65, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_classify(context, NULL, GUSSET_GLUING_PLACE_NODE, 0, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_classify(context, net, GUSSET_GLUING_PLACE_NODE, 0, 0, NULL));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_net_classify(context, net, GUSSET_GLUING_PLACE_CELL, 32 * 64, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_classify(context, net, GUSSET_GLUING_PLACE_CELL, 0, 0, NULL));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_classify(context, net, 2, 0, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_classify(context, NULL, GUSSET_GLUING_PLACE_CELL, 0, 0, &found));
    EXPECT(GUSSET_OK, gusset_net_histogram(context, net, NULL, counts));
    CHECK(counts[GUSSET_TYPE_HORIZONTAL] == 2 * 64);
    EXPECT(GUSSET_OK, gusset_net_histogram(context, net, counts, NULL));
    CHECK(counts[GUSSET_TYPE_EAST_WEST] == 2 * 63);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_histogram(context, NULL, counts, NULL));
    CHECK(counts[GUSSET_TYPE_EAST_WEST] == 0);
    {
        gusset_gluing_occurrence some[1];
        size_t all = 1;
        EXPECT(GUSSET_OK, gusset_net_gluing_occurrences(context, net, 0, NULL, 0, &all));
        CHECK(all == 2 * 65 + 2 * 64);
        EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_net_gluing_occurrences(context, net, 1, some, 1, &all));
        EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_gluing_occurrences(context, net, 0, NULL, 1000, &all));
        EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_gluing_occurrences(context, net, 2, NULL, 0, &all));
        EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_gluing_occurrences(context, net, 0, some, 1, NULL));
        EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_gluing_occurrences(context, NULL, 0, some, 1, &all));
        CHECK(all == 0);
    }
    gusset_net_destroy(net);
}

static void surfaces_and_checks(void) {
    gusset_net *net = sheet();
    gusset_net_complex *complex = NULL;
    gusset_net_complex_view report;
    gusset_net_validation *validation = NULL;
    gusset_net_validation_view findings;
    gusset_net_view arrays;

    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_complex_create(context, net, 2, &complex));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_complex_create(context, NULL, 0, &complex));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_complex_create(context, net, 0, NULL));
    CHECK(complex == NULL);
    report.struct_size = sizeof report;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_complex_get_view(NULL, &report));
    /* A hole. */
    arrays.struct_size = sizeof arrays;
    EXPECT(GUSSET_OK, gusset_net_edit(context, net, &arrays));
    ((double *)arrays.x)[14] = NAN;
    report = surface(net, &complex);
    CHECK(report.euler == 0 && report.boundary_offsets.count == 3 && report.quad_count == 21 && report.genus == 0);
    CHECK(report.boundary_nodes.count == 28 && report.boundary_edge_count == 28);
    CHECK(report.wires.count == 0 && report.branches.count == 0 && report.pinches.count == 0);
    report.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_complex_get_view(complex, &report));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_complex_get_view(complex, NULL));
    gusset_net_complex_destroy(complex);
    gusset_net_complex_destroy(NULL);

    {
        gusset_gluing link = {0};
        EXPECT(GUSSET_OK, glue(net, &link, 1));
    }
    CHECK(violations(net, 0.01) == 1 && violations(net, 1) == 0);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_validation_create(context, net, -1, &validation));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_validation_create(context, NULL, 0, &validation));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_validation_create(context, net, 0, NULL));
    CHECK(validation == NULL);
    findings.struct_size = sizeof findings;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_validation_get_view(NULL, &findings));
    EXPECT(GUSSET_OK, gusset_net_validation_create(context, net, 0, &validation));
    EXPECT(GUSSET_OK, gusset_net_validation_get_view(validation, &findings));
    CHECK(findings.count == 1 && findings.findings[0].kind == GUSSET_NET_FINDING_LINK_APART);
    CHECK(findings.findings[0].nodes[1] == 1 && fabs(findings.findings[0].distance - 0.2) < 1e-12);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_validation_get_view(validation, NULL));
    gusset_net_validation_destroy(validation);
    gusset_net_validation_destroy(NULL);

    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, detect(net, NAN));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, detect(NULL, 0));
    EXPECT(GUSSET_OK, detect(net, 0));
    CHECK(violations(net, 0) == 0);
    gusset_net_destroy(net);
}

int main(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    if (gusset_context_create(&context) != GUSSET_OK || up.face_count != down.face_count) {
        return 1;
    }
    shapes();
    wrong_shapes();
    gluing();
    separation();
    groups_and_types();
    surfaces_and_checks();
    gusset_context_destroy(context);
    return failures != 0;
}
