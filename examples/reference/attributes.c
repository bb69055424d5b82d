/* Attributes: where the elements of results come from, and values carried over by that. */
#include "example.h"

/* Two open pyramids, point up and point down, with a gap between their square rims. */
static const double up[5][3] = {{0, 0, 2}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
static const double down[5][3] = {{0, 0, -2}, {1, 0, -1}, {0, -1, -1}, {-1, 0, -1}, {0, 1, -1}};
static const uint32_t faces[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};

static gusset_mesh_view pyramid(const double points[5][3]) {
    return gusset_triangles_f64(points[0], 5, faces, 4);
}

//! [stitch]
static void colours_across_a_strip(void) {
    const gusset_mesh_view a = pyramid(up), b = pyramid(down);
    const gusset_stitch_options rows = {.struct_size = sizeof rows, .rows = GUSSET_ROWS_COUNT, .row_count = 1};
    const uint8_t red[5][3] = {{255, 0, 0}, {255, 0, 0}, {255, 0, 0}, {255, 0, 0}, {255, 0, 0}};
    const uint8_t blue[5][3] = {{0, 0, 255}, {0, 0, 255}, {0, 0, 255}, {0, 0, 255}, {0, 0, 255}};
    const gusset_channel colours = {
        .struct_size = sizeof colours, .domain = GUSSET_DOMAIN_VERTICES, .value_type = GUSSET_VALUE_U8, .components = 3};
    const gusset_channel_values given[2] = {{.values = red, .count = 5}, {.values = blue, .count = 5}};
    uint8_t made[32][3];
    gusset_result *stitch = NULL;
    gusset_origins *origins = NULL;
    gusset_origins_view vertices = {.struct_size = sizeof vertices};

    MUST(gusset_stitch(NULL, &a, NULL, &b, NULL, &rows, &stitch));
    MUST(gusset_result_origins_create(NULL, stitch, &origins));
    gusset_result_destroy(stitch);
    MUST(gusset_origins_get_view(origins, GUSSET_DOMAIN_VERTICES, &vertices));
    /* Old vertices have one source, themselves. Vertices of the row have two, one on each rim. */
    HOLDS(vertices.starts.count == 3 && vertices.starts.data[1] == 5 && vertices.starts.data[2] == 10);
    HOLDS(vertices.sources.data[7] == 7 && vertices.weights[7] == 1.0);
    HOLDS(vertices.offsets.data[11] - vertices.offsets.data[10] == 2 && vertices.weights[10] == 0.5);
    HOLDS(vertices.offsets.count - 1 <= 32);

    MUST(gusset_attributes_apply(NULL, origins, &colours, given, 2, made, 32, 0));
    HOLDS(made[4][0] == 255 && made[5][2] == 255 && made[10][0] == 128 && made[10][2] == 128);
    gusset_origins_destroy(origins);
}
//! [stitch]

//! [fill]
static void texture_coordinates_in_a_hole(void) {
    const gusset_mesh_view mesh = pyramid(up);
    /* At corners, so that a vertex may have different values in other faces. */
    double given[12][2];
    const gusset_channel channel = {.struct_size = sizeof channel,
                                    .domain = GUSSET_DOMAIN_CORNERS,
                                    .value_type = GUSSET_VALUE_F64,
                                    .components = 2,
                                    .rule = GUSSET_RULE_TEXTURE};
    const gusset_channel_values values = {.values = given, .count = 12};
    double made[18][2];
    gusset_result *fill = NULL;
    gusset_origins *origins = NULL;
    gusset_mesh_view filled = {.struct_size = sizeof filled};
    size_t corner;

    for (corner = 0; corner < 12; ++corner) {
        given[corner][0] = 0.5 * (1.0 + up[faces[corner]][0]), given[corner][1] = 0.5 * (1.0 + up[faces[corner]][1]);
    }
    MUST(gusset_fill(NULL, &mesh, NULL, 0, NULL, &fill));
    MUST(gusset_result_get_mesh(fill, &filled));
    MUST(gusset_result_origins_create(NULL, fill, &origins));
    MUST(gusset_attributes_apply(NULL, origins, &channel, &values, 1, made, 18, 0));
    for (corner = 12; corner < 18; ++corner) {
        const uint32_t v = ((const uint32_t *)filled.face_corners)[corner];
        HOLDS(made[corner][0] == 0.5 * (1.0 + up[v][0]) && made[corner][1] == 0.5 * (1.0 + up[v][1]));
    }
    gusset_origins_destroy(origins);
    gusset_result_destroy(fill);
}
//! [fill]

//! [assembly]
static void materials_of_pieces(void) {
    const gusset_mesh_view pieces[2] = {pyramid(up), pyramid(down)};
    const uint16_t wood[4] = {3, 3, 3, 3}, stone[4] = {8, 8, 8, 8};
    const gusset_channel materials = {.struct_size = sizeof materials,
                                      .domain = GUSSET_DOMAIN_FACES,
                                      .value_type = GUSSET_VALUE_U16,
                                      .components = 1,
                                      .rule = GUSSET_RULE_NEAREST};
    const gusset_channel_values given[2] = {{.values = wood, .count = 4}, {.values = stone, .count = 4}};
    uint16_t made[16];
    gusset_result *assembly = NULL;
    gusset_origins *origins = NULL;
    size_t f, of_wood = 0;

    MUST(gusset_join(NULL, pieces, 2, NULL, &assembly));
    MUST(gusset_result_origins_create(NULL, assembly, &origins));
    MUST(gusset_attributes_apply(NULL, origins, &materials, given, 2, made, 16, 0));
    /* The strip's faces have the material of the piece beside them. */
    for (f = 0; f < 16; ++f) {
        of_wood += made[f] == 3;
    }
    HOLDS(of_wood == 8);
    gusset_origins_destroy(origins);
    gusset_result_destroy(assembly);
}
//! [assembly]

//! [strip]
static void values_along_polylines(void) {
    const double a[3][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const double b[2][3] = {{0, 1, 0}, {2, 1, 0}};
    const gusset_strip_options rows = {.struct_size = sizeof rows, .rows = GUSSET_ROWS_COUNT, .row_count = 1};
    gusset_result *strip = NULL;
    gusset_origins *origins = NULL;
    gusset_origins_view points = {.struct_size = sizeof points};

    MUST(gusset_strip(NULL, a[0], 3, b[0], 2, &rows, &strip));
    MUST(gusset_result_origins_create(NULL, strip, &origins));
    MUST(gusset_origins_get_view(origins, GUSSET_DOMAIN_VERTICES, &points));
    HOLDS(points.starts.data[1] == 3 && points.starts.data[2] == 5);
    gusset_origins_destroy(origins);
    gusset_result_destroy(strip);
}
//! [strip]

//! [repair]
static void normals_of_what_is_repaired(void) {
    /* Two triangles with an edge in common, by vertices of their own; the second is inside out. */
    const float points[6][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    const uint32_t corners[6] = {0, 1, 2, 3, 4, 5};
    const float normals[6][3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}, {0, 0, -1}, {0, 0, -1}};
    const gusset_mesh_view mesh = gusset_triangles_f32(points[0], 6, corners, 2);
    const gusset_channel channel = {.struct_size = sizeof channel,
                                    .domain = GUSSET_DOMAIN_CORNERS,
                                    .value_type = GUSSET_VALUE_F32,
                                    .components = 3,
                                    .rule = GUSSET_RULE_NORMAL};
    const gusset_channel_values given = {.values = normals, .count = 6};
    float turned[6][3], sewn[6][3];
    gusset_result *weld = NULL;
    gusset_result *sew = NULL;
    gusset_result *orient = NULL;
    gusset_origins *of_weld = NULL, *of_sew = NULL, *of_orient = NULL;
    gusset_origins_view vertices = {.struct_size = sizeof vertices};
    gusset_mesh_view welded = {.struct_size = sizeof welded};
    size_t k, up_count = 0;

    MUST(gusset_weld(NULL, &mesh, NULL, &weld));
    MUST(gusset_result_get_mesh(weld, &welded));
    MUST(gusset_result_origins_create(NULL, weld, &of_weld));
    MUST(gusset_origins_get_view(of_weld, GUSSET_DOMAIN_VERTICES, &vertices));
    /* Four vertices of six; two have two sources in equal parts. */
    HOLDS(vertices.offsets.count == 5 && vertices.sources.count == 6);

    MUST(gusset_orient(NULL, &welded, NULL, &orient));
    MUST(gusset_result_origins_create(NULL, orient, &of_orient));
    /* The one face that was turned over has its normals turned, too. */
    MUST(gusset_attributes_apply(NULL, of_orient, &channel, &given, 1, turned, 6, 0));
    for (k = 0; k < 6; ++k) {
        up_count += turned[k][2] > 0.0F;
    }
    HOLDS(up_count == 0 || up_count == 6);

    MUST(gusset_sew(NULL, &mesh, NULL, &sew));
    MUST(gusset_result_origins_create(NULL, sew, &of_sew));
    MUST(gusset_attributes_apply(NULL, of_sew, &channel, &given, 1, sewn, 6, 0));
    HOLDS(memcmp(sewn, normals, sizeof sewn) == 0);
    gusset_origins_destroy(of_weld), gusset_origins_destroy(of_sew), gusset_origins_destroy(of_orient);
    gusset_result_destroy(orient), gusset_result_destroy(sew), gusset_result_destroy(weld);
}
//! [repair]

//! [net]
static void heights_on_the_mesh_of_a_net(void) {
    const gusset_net_primitive tube = {.struct_size = sizeof tube,
                                       .shape = GUSSET_NET_TUBE,
                                       .scalar = GUSSET_F64,
                                       .rows = 3,
                                       .columns = 9,
                                       .radius = 1,
                                       .height = 2};
    const gusset_channel column = {.struct_size = sizeof column,
                                   .domain = GUSSET_DOMAIN_CORNERS,
                                   .value_type = GUSSET_VALUE_F32,
                                   .components = 1};
    float given[27], made[64];
    const gusset_channel_values values = {.values = given, .count = 27};
    gusset_net *net = NULL;
    gusset_result *mesh = NULL;
    gusset_origins *origins = NULL;
    size_t k, last = 0;

    for (k = 0; k < 27; ++k) {
        given[k] = (float)(k % 9);
    }
    MUST(gusset_net_primitive_create(NULL, &tube, &net));
    MUST(gusset_net_to_mesh(NULL, net, NULL, &mesh));
    MUST(gusset_result_origins_create(NULL, mesh, &origins));
    /* Each corner has the node of its own cell: the last column of nodes is not the first one again. */
    MUST(gusset_attributes_apply(NULL, origins, &column, &values, 1, made, 64, 0));
    for (k = 0; k < 64; ++k) {
        last += made[k] == 8.0F;
    }
    HOLDS(last == 4);
    gusset_origins_destroy(origins);
    gusset_result_destroy(mesh);
    gusset_net_destroy(net);
}
//! [net]

//! [sheet]
static void values_on_the_mesh_of_a_sheet(void) {
    double points[9][3];
    const gusset_nodes nodes = {.struct_size = sizeof nodes, .nodes = points, .rows = 3, .columns = 3, .scalar = GUSSET_F64};
    const gusset_sheet_mesh_options finer = {.struct_size = sizeof finer, .min_u = 2, .min_v = 2};
    double given[9], made[25];
    const gusset_channel channel = {.struct_size = sizeof channel, .value_type = GUSSET_VALUE_F64, .components = 1};
    const gusset_channel_values values = {.values = given, .count = 9};
    gusset_sheet *sheet = NULL;
    gusset_result *mesh = NULL;
    gusset_origins *origins = NULL;
    size_t k;

    for (k = 0; k < 9; ++k) {
        points[k][0] = (double)(k / 3), points[k][1] = (double)(k % 3), points[k][2] = 0.0;
        given[k] = points[k][0] + 10.0 * points[k][1];
    }
    MUST(gusset_sheet_create(NULL, &nodes, NULL, 0, &sheet));
    MUST(gusset_sheet_to_mesh(NULL, sheet, &finer, &mesh));
    MUST(gusset_result_origins_create(NULL, mesh, &origins));
    MUST(gusset_attributes_apply(NULL, origins, &channel, &values, 1, made, 25, 0));
    /* Between nodes by the parameters of the cell: the second vertex is half-way along the first row. */
    HOLDS(made[0] == 0.0 && made[1] == 5.0 && made[24] == 22.0);
    gusset_origins_destroy(origins);
    gusset_result_destroy(mesh);
    gusset_sheet_destroy(sheet);
}
//! [sheet]

//! [merge]
static void split_vertices_are_no_border(void) {
    /* Two triangles with an edge in common, whose vertices are split there as a seam of texture coordinates has them. */
    const float points[6][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const uint32_t corners[6] = {0, 1, 2, 3, 4, 5};
    uint32_t merge[6];
    gusset_mesh_view mesh = gusset_triangles_f32(points[0], 6, corners, 2);
    gusset_mesh_view whole = {.struct_size = sizeof whole};
    gusset_boundary_view loops = {.struct_size = sizeof loops};
    gusset_boundary *boundary = NULL;
    gusset_result *fill = NULL;

    MUST(gusset_boundary_create(NULL, &mesh, NULL, &boundary));
    MUST(gusset_boundary_get_view(boundary, &loops));
    HOLDS(loops.loop_count == 2);
    gusset_boundary_destroy(boundary);

    MUST(gusset_mesh_find_merge(NULL, &mesh, NULL, merge));
    HOLDS(merge[3] == 1 && merge[5] == 2 && merge[4] == 4);
    mesh.merge = merge;
    MUST(gusset_boundary_create(NULL, &mesh, NULL, &boundary));
    MUST(gusset_boundary_get_view(boundary, &loops));
    HOLDS(loops.loop_count == 1);
    gusset_boundary_destroy(boundary);

    /* Old faces keep their vertices, and the result has a merge map, too. By default, loose faces stay open. */
    const gusset_fill_options every = {.struct_size = sizeof every, .keep = GUSSET_KEEP_NONE};
    MUST(gusset_fill(NULL, &mesh, NULL, 0, &every, &fill));
    MUST(gusset_result_get_mesh(fill, &whole));
    HOLDS(whole.face_count == 4 && memcmp(whole.face_corners, corners, sizeof corners) == 0);
    HOLDS(((const uint32_t *)whole.merge)[5] == 2);
    gusset_result_destroy(fill);
}
//! [merge]

int main(void) {
    split_vertices_are_no_border();
    colours_across_a_strip();
    texture_coordinates_in_a_hole();
    materials_of_pieces();
    values_along_polylines();
    normals_of_what_is_repaired();
    heights_on_the_mesh_of_a_net();
    values_on_the_mesh_of_a_sheet();
    return 0;
}
