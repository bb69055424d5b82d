/* Nets of quads: coordinates, gluing, space, measures. */
#include "example.h"

/* A sphere of radius 1 with two poles. */
static gusset_net *sphere(void) {
    const gusset_net_primitive shape = {.struct_size = sizeof shape,
                                        .shape = GUSSET_NET_SPHERE,
                                        .scalar = GUSSET_F64,
                                        .rows = 33,
                                        .columns = 65,
                                        .radius = 1.0};
    gusset_net *net = NULL;
    MUST(gusset_net_primitive_create(NULL, &shape, &net));
    return net;
}

/* A flat sheet of rows x columns nodes, one unit apart. */
static gusset_net *flat(size_t rows, size_t columns) {
    const gusset_net_primitive shape = {.struct_size = sizeof shape,
                                        .shape = GUSSET_NET_PLANE,
                                        .scalar = GUSSET_F64,
                                        .rows = rows,
                                        .columns = columns,
                                        .size = {(double)columns - 1.0, (double)rows - 1.0, 0.0}};
    gusset_net *net = NULL;
    MUST(gusset_net_primitive_create(NULL, &shape, &net));
    return net;
}

//! [net_primitive]
static void a_shape(void) {
    const gusset_net_primitive shape = {.struct_size = sizeof shape,
                                        .shape = GUSSET_NET_TORUS,
                                        .scalar = GUSSET_F32,
                                        .radius = 2.0,
                                        .minor_radius = 0.5};
    gusset_net_view arrays = {.struct_size = sizeof arrays};
    gusset_net *net = NULL;

    MUST(gusset_net_primitive_create(NULL, &shape, &net));
    MUST(gusset_net_get_view(net, &arrays));
    HOLDS(arrays.rows == 33 && arrays.columns == 65 && arrays.scalar == GUSSET_F32); /* the default size */
    gusset_net_destroy(net);
}
//! [net_primitive]

//! [net]
static void whose_memory(void) {
    /* A tent of 2 x 3 nodes as three matrices of the host's. */
    float x[6] = {0, 1, 2, 0, 1, 2}, y[6] = {0, 0, 0, 1, 1, 1}, z[6] = {0, 1, 0, 0, 1, 0};
    double copy[6][3];
    const gusset_net_view mine = {
        .struct_size = sizeof mine, .rows = 2, .columns = 3, .x = x, .y = y, .z = z, .scalar = GUSSET_F32};
    const gusset_net_view points = {.struct_size = sizeof points,
                                      .rows = 2,
                                      .columns = 3,
                                      .x = &copy[0][0],
                                      .y = &copy[0][1],
                                      .z = &copy[0][2],
                                      .column_stride = sizeof copy[0],
                                      .scalar = GUSSET_F64};
    gusset_net_view lent = {.struct_size = sizeof lent};
    const gusset_net_copy_options to_doubles = {.struct_size = sizeof to_doubles, .scalar = GUSSET_F64};
    gusset_net *copied = NULL, *borrowed = NULL, *clone = NULL, *doubles = NULL;

    MUST(gusset_net_create(NULL, &mine, NULL, GUSSET_NET_MEMORY_COPY, &copied));     /* a copy of the coordinates */
    MUST(gusset_net_create(NULL, &mine, NULL, GUSSET_NET_MEMORY_BORROW, &borrowed)); /* the host's own memory */
    MUST(gusset_net_copy_create(NULL, copied, NULL, &clone)); /* shares memory until one of the two is changed */
    MUST(gusset_net_edit(NULL, borrowed, &lent));
    HOLDS(lent.z == z);
    ((float *)lent.z)[1] = 2.0F;
    MUST(gusset_net_edit(NULL, clone, &lent));
    ((float *)lent.z)[1] = 3.0F;
    HOLDS(z[1] == 2.0F);
    MUST(gusset_net_get_view(copied, &lent));
    HOLDS(((const float *)lent.z)[1] == 1.0F);

    /* To doubles, and out to the host's points. */
    MUST(gusset_net_copy_create(NULL, clone, &to_doubles, &doubles));
    MUST(gusset_net_read(NULL, doubles, &points));
    HOLDS(copy[1][0] == 1.0 && copy[1][2] == 3.0 && copy[5][1] == 1.0);
    gusset_net_destroy(doubles);
    gusset_net_destroy(clone);
    gusset_net_destroy(borrowed);
    gusset_net_destroy(copied);
}
//! [net]

//! [net_gluing]
static void what_is_glued(void) {
    const gusset_net_gluing tube = {.struct_size = sizeof tube, .sides = GUSSET_SIDES_TUBE};
    gusset_net *net = flat(4, 6);
    gusset_net_gluing_report report = {.struct_size = sizeof report};
    uint8_t matrix[2 * 4 * 6];
    gusset_seam seams[1];

    MUST(gusset_net_set_gluing(NULL, net, &tube));
    MUST(gusset_net_get_gluing(net, NULL, 0, NULL, 0, &report)); /* without the arrays */
    HOLDS(report.sides == GUSSET_SIDES_TUBE && report.reversed == 0 && report.bridge_count == 0);
    /* The characteristic matrix: the horizontal links of row 0, then the vertical ones; the last one leads back. */
    MUST(gusset_net_get_gluing(net, matrix, sizeof matrix, seams, 1, &report));
    HOLDS(report.matrix_size == sizeof matrix && matrix[5] == 1 && matrix[4] == 0 && matrix[6] == 0);
    HOLDS(report.seam_count == 0);
    gusset_net_destroy(net);
}
//! [net_gluing]

//! [net_glue]
static void glued(void) {
    gusset_net *net = flat(4, 5), *ball = sphere();
    const gusset_gluing link = {.kind = GUSSET_GLUING_LINK, .element = 2 * 6}; /* node 6 and the next one */
    const gusset_glue_options by_hand = {
        .struct_size = sizeof by_hand, .gluings = &link, .gluing_count = 1, .saturate = 1, .snap = 1};
    const gusset_glue_options by_place = {.struct_size = sizeof by_place, .detect = 1, .tolerance = 1e-9};
    const gusset_net_gluing none = {.struct_size = sizeof none};
    gusset_net_gluing_report report = {.struct_size = sizeof report};
    uint64_t moved = 0;

    MUST(gusset_net_glue(NULL, net, &by_hand, &moved)); /* node 7 moves to node 6 */
    HOLDS(moved == 1);
    /* Apart again, by a tenth of a unit. */
    MUST(gusset_net_unglue(NULL, net, &link, 1, 0.1, &moved));
    HOLDS(moved == 2);
    gusset_net_destroy(net);

    /* Removes the gluing, and detects it again from the coordinates. */
    MUST(gusset_net_set_gluing(NULL, ball, &none));
    MUST(gusset_net_glue(NULL, ball, &by_place, NULL));
    MUST(gusset_net_get_gluing(ball, NULL, 0, NULL, 0, &report));
    HOLDS(report.sides == GUSSET_SIDES_TWO_POLES);
    gusset_net_destroy(ball);
}
//! [net_glue]

//! [net_classify]
static void what_is_one_point(void) {
    gusset_net *net = flat(4, 5);
    const uint32_t link = 2 * 6;
    const gusset_glue_options options = {.struct_size = sizeof options, .links = &link, .link_count = 1};
    uint32_t classes[20];
    size_t written = 0;
    uint64_t nodes[18], cells[18];
    gusset_gluing_type found = 0;
    gusset_gluing_occurrence all[8];
    gusset_net_groups *groups = NULL;
    gusset_net_groups_view view = {.struct_size = sizeof view};

    MUST(gusset_net_glue(NULL, net, &options, NULL));
    MUST(gusset_net_classes(NULL, net, classes, 20, &written));
    HOLDS(written == 20 && classes[7] == 6 && classes[8] == 8);
    MUST(gusset_net_groups_create(NULL, net, &groups));
    MUST(gusset_net_groups_get_view(groups, &view));
    HOLDS(view.offsets.count == 2 && view.members.count == 2 && view.members.data[0] == 6);
    gusset_net_groups_destroy(groups);

    /* Which of the 18 local gluings it is, for the node and for the cell above it, which has become a triangle. */
    MUST(gusset_net_classify(NULL, net, GUSSET_GLUING_PLACE_NODE, 6, 0, &found));
    HOLDS(found == GUSSET_TYPE_HORIZONTAL);
    MUST(gusset_net_classify(NULL, net, GUSSET_GLUING_PLACE_CELL, 1, 0, &found));
    HOLDS(found == GUSSET_TYPE_HORIZONTAL);
    MUST(gusset_net_histogram(NULL, net, nodes, cells));
    HOLDS(nodes[GUSSET_TYPE_HORIZONTAL] == 2 && cells[GUSSET_TYPE_HORIZONTAL] == 2);
    /* All of them as data: at both ends of the link n(1), of the two cells beside it c(1). */
    MUST(gusset_net_gluing_occurrences(NULL, net, 0, all, 8, &written));
    HOLDS(written == 4 && all[0].element == 6 && all[0].a == 1 && all[0].node_order == 2);
    HOLDS(all[2].place == GUSSET_GLUING_PLACE_CELL);
    gusset_net_destroy(net);
}
//! [net_classify]

//! [net_complex]
static void what_surface_it_is(void) {
    gusset_net *net = sphere();
    gusset_net_complex *complex = NULL;
    gusset_net_complex_view report = {.struct_size = sizeof report};

    MUST(gusset_net_complex_create(NULL, net, GUSSET_NET_CELLS_ALL, &complex));
    MUST(gusset_net_complex_get_view(complex, &report));
    HOLDS(report.euler == 2 && report.genus == 0 && (report.properties & GUSSET_NET_CLOSED));
    gusset_net_complex_destroy(complex);
    gusset_net_destroy(net);
}
//! [net_complex]

//! [net_validate]
static void whether_it_is_right(void) {
    gusset_net *net = sphere();
    gusset_net_validation *validation = NULL;
    gusset_net_validation_view view = {.struct_size = sizeof view};

    MUST(gusset_net_validation_create(NULL, net, 0.0, &validation));
    MUST(gusset_net_validation_get_view(validation, &view));
    HOLDS(view.violation_count == 0);
    gusset_net_validation_destroy(validation);
    gusset_net_destroy(net);
}
//! [net_validate]

//! [net_transform]
static void moved(void) {
    const gusset_operation operations[2] = {{.kind = GUSSET_OPERATION_SCALE, .values = {2}},
                                            {.kind = GUSSET_OPERATION_TRANSLATE, .values = {0, 0, 5}}};
    gusset_net *net = sphere();
    gusset_net_measure_report measures = {.struct_size = sizeof measures};

    MUST(gusset_net_transform(NULL, net, operations, 2));
    MUST(gusset_net_measure(NULL, net, GUSSET_NET_MEASURES_EXTENT, &measures));
    HOLDS(about(measures.low[2], 3.0) && about(measures.high[2], 7.0));
    gusset_net_destroy(net);
}
//! [net_transform]

//! [net_field]
static void deformed(void) {
    const gusset_field twist = {.struct_size = sizeof twist,
                                .kind = GUSSET_FIELD_TWIST,
                                .axis = GUSSET_AXIS_Z,
                                .strength = 1.0,
                                .values = {0.5}};
    const gusset_glue_options together = {.struct_size = sizeof together, .snap = 1};
    gusset_net *net = sphere();
    gusset_net_view lent = {.struct_size = sizeof lent};
    gusset_net_measure_report measures = {.struct_size = sizeof measures};
    uint64_t moved = 9;
    size_t k;

    MUST(gusset_net_deform(NULL, net, &twist, 1, 0.0));
    MUST(gusset_net_edit(NULL, net, &lent)); /* any map of the host's, node by node */
    for (k = 0; k < lent.rows * lent.columns; ++k) {
        ((double *)lent.z)[k] *= 0.5;
    }
    MUST(gusset_net_glue(NULL, net, &together, &moved)); /* glued nodes have equal bits already */
    HOLDS(moved == 0);
    MUST(gusset_net_measure(NULL, net, GUSSET_NET_MEASURES_EXTENT, &measures));
    HOLDS(about(measures.high[2], 0.5));
    MUST(gusset_net_displace(NULL, net, 0.1)); /* outwards along the normals */
    MUST(gusset_net_measure(NULL, net, GUSSET_NET_MEASURES_EXTENT, &measures));
    HOLDS(about(measures.high[2], 0.6));
    gusset_net_destroy(net);
}

/* A sheet rolls up to a tube and the tube to a sphere, at the time t of the paper's Fig. 3. */
static gusset_net *rolled_sheet(double t) {
    const gusset_field fields[2] = {
        {.struct_size = sizeof *fields, .kind = GUSSET_FIELD_AFFINE, .strength = 1.0,
         .values = {pi / 8, 0, 0, 0, 0, pi / 8, 0, -pi / 2, 0, 0, 1, 0}},
        {.struct_size = sizeof *fields, .kind = GUSSET_FIELD_SPHERE_WRAP, .axis = GUSSET_AXIS_Z, .strength = t,
         .values = {1.0}}};
    double x[9 * 17], y[9 * 17], z[9 * 17] = {0};
    const gusset_net_view nodes = {.struct_size = sizeof nodes, .rows = 9, .columns = 17, .x = x, .y = y, .z = z,
                                   .scalar = GUSSET_F64};
    gusset_net *net = NULL;
    size_t k;
    for (k = 0; k < 9 * 17; ++k) {
        x[k] = (double)(k % 17);
        y[k] = (double)(k / 17);
    }
    MUST(gusset_net_create(NULL, &nodes, NULL, GUSSET_NET_MEMORY_COPY, &net));
    MUST(gusset_net_deform(NULL, net, fields, 2, 0.0));
    return net;
}

static void rolled(void) {
    gusset_net *tube = rolled_sheet(0.5), *ball = rolled_sheet(1.0);
    gusset_net_measure_report measures = {.struct_size = sizeof measures};

    MUST(gusset_net_measure(NULL, tube, GUSSET_NET_MEASURES_EXTENT, &measures)); /* at one half as long as a meridian, pi */
    HOLDS(measures.area > 0.98 * 2 * acos(-1.0) * acos(-1.0));
    MUST(gusset_net_measure(NULL, ball, GUSSET_NET_MEASURES_EXTENT, &measures)); /* at 1 closed: the poles are 2 apart */
    HOLDS(about(measures.high[2] - measures.low[2], 2.0) && fabs(measures.area_vector[2]) < 1e-15);
    gusset_net_destroy(ball);
    gusset_net_destroy(tube);
}
//! [net_field]

//! [net_analyse]
static void what_a_deformation_does(void) {
    /* Flattened to a disc, the sphere is folded over. */
    const gusset_field flat_z = {.struct_size = sizeof flat_z,
                                 .kind = GUSSET_FIELD_PARALLEL,
                                 .strength = 1.0,
                                 .values = {0, 0, 0, 0, 0, 1, 0, 0, 1}};
    gusset_net *before = sphere(), *after = NULL;
    gusset_net_analysis_options two_nets = {.struct_size = sizeof two_nets, .tolerance = 1e-12};
    const gusset_net_analysis_options of_fields = {
        .struct_size = sizeof of_fields, .tolerance = 1e-12, .fields = &flat_z, .field_count = 1};
    gusset_glue_options absorbing = {.struct_size = sizeof absorbing, .snap = 1};
    gusset_net_analysis *analysis = NULL;
    gusset_net_analysis_view view = {.struct_size = sizeof view};

    MUST(gusset_net_copy_create(NULL, before, NULL, &after));
    MUST(gusset_net_deform(NULL, after, &flat_z, 1, 0.0));
    two_nets.after = after;
    MUST(gusset_net_analysis_create(NULL, before, &two_nets, &analysis));
    MUST(gusset_net_analysis_get_view(analysis, &view));
    HOLDS(view.soft == 0 && view.folded_count > 0 && view.torn_count == 0 && view.determinants == NULL);
    /* Links that have become a point may be made part of the gluing. */
    absorbing.links = view.contracted, absorbing.link_count = view.contracted_count;
    MUST(gusset_net_glue(NULL, after, &absorbing, NULL));
    gusset_net_analysis_destroy(analysis);

    /* The same without a deformed net, and with the determinants of the field. */
    MUST(gusset_net_analysis_create(NULL, before, &of_fields, &analysis));
    MUST(gusset_net_analysis_get_view(analysis, &view));
    HOLDS(view.determinants != NULL && fabs(view.determinants[0]) < 1e-6);
    gusset_net_analysis_destroy(analysis);
    gusset_net_destroy(after);
    gusset_net_destroy(before);
}
//! [net_analyse]

//! [net_normals]
static void normals(void) {
    double x[33 * 65], y[33 * 65], z[33 * 65];
    gusset_net *net = sphere();
    uint64_t without = 9;

    MUST(gusset_net_normals(NULL, net, x, y, z, 33 * 65, &without));
    HOLDS(without == 0 && about(fabs(z[0]), 1.0)); /* poles have theirs too */
    gusset_net_destroy(net);
}
//! [net_normals]

//! [net_measure]
static void measured(void) {
    gusset_net *net = sphere();
    const gusset_net_measures all = GUSSET_NET_MEASURES_EXTENT | GUSSET_NET_MEASURES_BILINEAR | GUSSET_NET_MEASURES_BODY;
    gusset_net_measure_report measures = {.struct_size = sizeof measures};
    gusset_net_planarity_report planarity = {.struct_size = sizeof planarity};
    size_t cells = 0;

    MUST(gusset_net_measure(NULL, net, all, &measures));
    HOLDS(fabs(measures.area - 4.0 * pi) < 0.1 && fabs(measures.volume - 4.0 / 3.0 * pi) < 0.05);
    HOLDS(about(measures.body_volume, measures.volume) && fabs(measures.centroid[2]) < 1e-9);
    /* Trapezia between parallels are plane. */
    MUST(gusset_net_planarity(NULL, net, 1e-9, NULL, 0, &cells, &planarity));
    HOLDS(cells == 32 * 64 && planarity.above == 0);
    /* So their bilinear patches have the same area. */
    HOLDS(fabs(measures.bilinear_area - measures.area) < 1e-12 && measures.bilinear_error < 1e-12);
    gusset_net_destroy(net);
}
//! [net_measure]

//! [net_planarise]
static void clad(void) {
    const gusset_field bend = {.struct_size = sizeof bend, .kind = GUSSET_FIELD_TWIST, .axis = GUSSET_AXIS_X,
                               .strength = 1.0, .values = {0.1}};
    const gusset_planarise_options options = {.struct_size = sizeof options, .keep_boundary = 0};
    gusset_planarise_report report = {.struct_size = sizeof report};
    gusset_net *net = flat(4, 5);

    MUST(gusset_net_deform(NULL, net, &bend, 1, 0.0)); /* a twisted sheet: no cell is plane */
    MUST(gusset_net_planarise(NULL, net, &options, &report));
    HOLDS(report.converged == 1 && report.deviation_before > 1e-3);
    HOLDS(report.deviation_after <= 1e-10 * report.size && report.rms_displacement <= report.max_displacement);
    gusset_net_destroy(net);
}
//! [net_planarise]

//! [net_morph]
static void between(void) {
    const gusset_operation quarter = {.kind = GUSSET_OPERATION_ROTATE, .values = {0, 0, 1, 1.5707963267948966}};
    gusset_net *first = flat(4, 5), *second = flat(4, 5), *half = NULL;
    gusset_net_measure_report straight = {.struct_size = sizeof straight}, rigid = {.struct_size = sizeof rigid};

    MUST(gusset_net_transform(NULL, second, &quarter, 1));
    MUST(gusset_net_morph_create(NULL, first, second, 0.5, GUSSET_MORPH_LINEAR, &half));
    MUST(gusset_net_measure(NULL, half, GUSSET_NET_MEASURES_EXTENT, &straight)); /* half of the area, on the straight way */
    gusset_net_destroy(half);
    MUST(gusset_net_morph_create(NULL, first, second, 0.5, GUSSET_MORPH_RIGID, &half));
    MUST(gusset_net_measure(NULL, half, GUSSET_NET_MEASURES_EXTENT, &rigid)); /* all of it, if the net turns */
    HOLDS(about(straight.area, 6.0) && about(rigid.area, 12.0));
    gusset_net_destroy(half);
    gusset_net_destroy(second);
    gusset_net_destroy(first);
}
//! [net_morph]

int main(void) {
    a_shape();
    whose_memory();
    what_is_glued();
    glued();
    what_is_one_point();
    what_surface_it_is();
    whether_it_is_right();
    moved();
    deformed();
    rolled();
    what_a_deformation_does();
    normals();
    measured();
    clad();
    between();
    return 0;
}
