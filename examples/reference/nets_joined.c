/* Nets of quads: rows and columns, resolutions, bridges, meshes, heights, scenes, streams. */
#include "example.h"

/* A tube of radius 1 about the z axis. */
static gusset_net *tube(void) {
    const gusset_net_primitive shape = {.struct_size = sizeof shape,
                                        .shape = GUSSET_NET_TUBE,
                                        .scalar = GUSSET_F64,
                                        .rows = 5,
                                        .columns = 9,
                                        .radius = 1.0,
                                        .height = 4.0};
    gusset_net *net = NULL;
    MUST(gusset_net_primitive_create(NULL, &shape, &net));
    return net;
}

static gusset_net_view size_of(const gusset_net *net) {
    gusset_net_view arrays = {.struct_size = sizeof arrays};
    MUST(gusset_net_get_view(net, &arrays));
    return arrays;
}

//! [net_arrange]
static void rows_and_columns(void) {
    const gusset_net_copy_options part = {.struct_size = sizeof part, .row_first = 1, .row_count = 3};
    const gusset_net_copy_options turned = {
        .struct_size = sizeof turned, .turn = GUSSET_NET_TURN_TRANSPOSE, .scalar = GUSSET_F32};
    const gusset_net_copy_options larger = {.struct_size = sizeof larger, .rows = 8};
    const gusset_net_copy_options smaller = {.struct_size = sizeof smaller, .compact = 1};
    gusset_net *net = tube(), *made = NULL, *back = NULL;

    MUST(gusset_net_copy_create(NULL, net, &part, &made)); /* three rows from row 1 on, all columns */
    HOLDS(size_of(made).rows == 3 && size_of(made).columns == 9);
    gusset_net_destroy(made);
    MUST(gusset_net_copy_create(NULL, net, &turned, &made)); /* rows and columns exchanged, and in single precision */
    HOLDS(size_of(made).rows == 9 && size_of(made).columns == 5 && size_of(made).scalar == GUSSET_F32);
    gusset_net_destroy(made);

    /* More rows that are the same surface, and without them again. */
    MUST(gusset_net_copy_create(NULL, net, &larger, &made));
    HOLDS(size_of(made).rows == 8);
    MUST(gusset_net_copy_create(NULL, made, &smaller, &back));
    HOLDS(size_of(back).rows == 5);
    MUST(gusset_net_clear_no_data(NULL, back, -9999.0)); /* what a scanner did not see */
    gusset_net_destroy(back);
    gusset_net_destroy(made);
    gusset_net_destroy(net);
}
//! [net_arrange]

//! [net_resample]
static void resolutions(void) {
    gusset_net *net = tube(), *made = NULL, *levels[GUSSET_PYRAMID_LEVELS];
    uint32_t rows[5], columns[9];
    double deviation = 9.0;
    size_t count = 0, k;

    MUST(gusset_net_resample_create(NULL, net, 17, 33, GUSSET_INTERPOLATION_BICUBIC, &made));
    HOLDS(size_of(made).rows == 17 && size_of(made).columns == 33);
    gusset_net_destroy(made);
    /* A straight tube needs its two rims only. */
    MUST(gusset_net_decimate_create(NULL, net, 1e-9, rows, columns, &deviation, &made));
    HOLDS(size_of(made).rows == 2 && rows[0] == 0 && rows[1] == 4 && deviation <= 1e-9);
    gusset_net_destroy(made);
    MUST(gusset_net_pyramid_create(NULL, net, GUSSET_INTERPOLATION_BILINEAR, levels, GUSSET_PYRAMID_LEVELS, &count));
    for (k = 0; k < count; ++k) {
        gusset_net_destroy(levels[k]);
    }
    HOLDS(count > 1);
    gusset_net_destroy(net);
}
//! [net_resample]

//! [net_join]
static void joined_and_taken_apart(void) {
    const gusset_concatenate_options options = {.struct_size = sizeof options, .direction = GUSSET_DIRECTION_DOWN};
    const gusset_bridge_properties soft = {.elasticity = 0.5};
    gusset_net *first = tube(), *second = NULL, *joined = NULL, *parts[2];
    const gusset_net *nets[2];
    gusset_bridge bridge = {.struct_size = sizeof bridge};

    MUST(gusset_net_copy_create(NULL, first, NULL, &second));
    nets[0] = first, nets[1] = second;
    MUST(gusset_net_concatenate_create(NULL, nets, 2, &options, &joined));
    HOLDS(size_of(joined).rows == 10);
    MUST(gusset_net_get_bridge(joined, 0, &bridge));
    HOLDS(bridge.at == 5 && bridge.kind == GUSSET_BRIDGE_TUBE);
    /* The band between the two is not to be there. */
    MUST(gusset_net_set_bridge(NULL, joined, 0, GUSSET_BRIDGE_HIDE, 0.0, &soft));
    MUST(gusset_net_split_create(NULL, joined, 0, &parts[0], &parts[1]));
    HOLDS(size_of(parts[0]).rows == 5 && size_of(parts[1]).rows == 5);
    gusset_net_destroy(parts[1]);
    gusset_net_destroy(parts[0]);
    gusset_net_destroy(joined);
    gusset_net_destroy(second);
    gusset_net_destroy(first);
}
//! [net_join]

//! [net_settle]
static void at_rest(void) {
    /* A film between two tubes, in four rows of its own. */
    const gusset_concatenate_options options = {.struct_size = sizeof options, .direction = GUSSET_DIRECTION_DOWN, .rows = 4,
                                         .properties = {.tension = 0.1}};
    const gusset_field shift = {.struct_size = sizeof shift, .kind = GUSSET_FIELD_TWIST, .axis = GUSSET_AXIS_X,
                                .strength = 1.0, .values = {0.0}};
    const uint8_t free_parts[2] = {0, 0};
    gusset_settle_options settling = {.struct_size = sizeof settling, .tolerance = 1e-6};
    gusset_settle_report report = {.struct_size = sizeof report};
    gusset_net *first = tube(), *second = NULL, *joined = NULL, *before = NULL;
    const gusset_net *nets[2];

    MUST(gusset_net_copy_create(NULL, first, NULL, &second));
    nets[0] = first, nets[1] = second;
    MUST(gusset_net_concatenate_create(NULL, nets, 2, &options, &joined));
    MUST(gusset_net_copy_create(NULL, joined, NULL, &before));
    MUST(gusset_net_deform(NULL, joined, &shift, 1, 0.0));
    settling.reference = before, settling.free = free_parts, settling.free_count = 2;
    MUST(gusset_net_settle(NULL, joined, &settling, &report));
    HOLDS(report.settled == 1 && report.tension_energy <= report.energy_before);
    gusset_net_destroy(before);
    gusset_net_destroy(joined);
    gusset_net_destroy(second);
    gusset_net_destroy(first);
}
//! [net_settle]

//! [net_mesh]
static void to_meshes_and_back(void) {
    const gusset_net_mesh_options options = {.struct_size = sizeof options, .texture = 1};
    const gusset_net_grid_options triangles = {.struct_size = sizeof triangles, .cells = GUSSET_GRID_TRIANGLES};
    const gusset_net_mesh_options in_two = {.struct_size = sizeof in_two, .faces = GUSSET_NET_TRIANGLES_SHORTER};
    const float values[6] = {0, 1, 0, 0, 1, 0};
    const gusset_heights heights = {.struct_size = sizeof heights,
                                    .rows = 2,
                                    .columns = 3,
                                    .values = values,
                                    .spacing = {1, 1},
                                    .scalar = GUSSET_F32};
    gusset_net *net = tube(), *found = NULL, *tent = NULL;
    gusset_result *mesh = NULL;
    gusset_net_grid *grid = NULL;
    gusset_mesh_view view = {.struct_size = sizeof view};
    gusset_net_mesh_report maps = {.struct_size = sizeof maps};
    gusset_net_grid_view parts = {.struct_size = sizeof parts};

    MUST(gusset_net_to_mesh(NULL, net, &options, &mesh));
    MUST(gusset_result_get_mesh(mesh, &view));
    MUST(gusset_result_get_net_mesh(mesh, &maps));
    HOLDS(view.vertex_count == 5 * 8 && view.face_count == 4 * 8 && maps.texture_count > 0); /* closed round */

    /* Rows and columns found in a mesh of quads. */
    MUST(gusset_net_from_mesh_create(NULL, &view, NULL, &grid, &found));
    MUST(gusset_net_grid_get_view(grid, &parts));
    HOLDS(parts.face_of_cell.count == 32 && size_of(found).rows * size_of(found).columns == 5 * 9);
    gusset_net_destroy(found);
    gusset_net_grid_destroy(grid);
    gusset_result_destroy(mesh);

    /* And in one of triangles, two for each cell. */
    MUST(gusset_net_to_mesh(NULL, net, &in_two, &mesh));
    MUST(gusset_result_get_mesh(mesh, &view));
    MUST(gusset_net_from_mesh_create(NULL, &view, &triangles, &grid, &found));
    MUST(gusset_net_grid_get_view(grid, &parts));
    HOLDS(view.face_count == 64 && parts.face_of_cell.count == 32);
    gusset_net_destroy(found);
    gusset_net_grid_destroy(grid);
    gusset_result_destroy(mesh);
    gusset_net_destroy(net);

    MUST(gusset_net_from_heights_create(NULL, &heights, &tent));
    HOLDS(((const float *)size_of(tent).z)[1] == 1.0F);
    gusset_net_destroy(tent);
}
//! [net_mesh]

//! [net_scene]
static void a_scene(void) {
    const gusset_transform right = {.rows = {1, 0, 0, 3, 0, 1, 0, 0, 0, 0, 1, 0}};
    const gusset_scene_changes moved = {.struct_size = sizeof moved, .transform = &right};
    const gusset_scene_changes hidden = {.struct_size = sizeof hidden, .visibility = GUSSET_VISIBILITY_HIDE};
    gusset_net *net = tube(), *flat = NULL, *again = NULL;
    gusset_scene *scene = NULL, *apart = NULL;
    gusset_stream *stream = NULL;
    gusset_stream_view bytes = {.struct_size = sizeof bytes};
    gusset_scene_entry_report entry = {.struct_size = sizeof entry};
    gusset_scene_report counts = {.struct_size = sizeof counts};
    gusset_scene_instance instances[8];
    uint32_t wheel = 9, axle = 9, spare = 9, children[4];
    size_t written = 0;

    MUST(gusset_scene_create(NULL, &scene));
    MUST(gusset_scene_add(NULL, scene, net, &wheel));
    MUST(gusset_scene_add(NULL, scene, NULL, &axle)); /* a group */
    MUST(gusset_scene_add_child(NULL, scene, axle, wheel));
    MUST(gusset_scene_add_child(NULL, scene, axle, wheel)); /* the same net twice */
    MUST(gusset_scene_set_entry(NULL, scene, axle, &moved));
    MUST(gusset_scene_get_children(NULL, scene, axle, children, 4, &written));
    HOLDS(written == 2 && children[0] == wheel && children[1] == wheel);
    MUST(gusset_scene_get_entry(scene, axle, &entry));
    HOLDS(entry.kind == GUSSET_SCENE_GROUP && entry.child_count == 2 && entry.visible == 1);
    MUST(gusset_scene_get_report(scene, &counts));
    HOLDS(counts.instances == 3 && counts.net_instances == 2 && counts.levels == 2);
    MUST(gusset_scene_world_transforms(NULL, scene, instances, 8, &written));
    HOLDS(written == 3 && instances[1].world.rows[3] == 3.0);

    /* All visible nets in one, and a scene of them again. */
    MUST(gusset_scene_flatten_create(NULL, scene, NULL, &flat));
    MUST(gusset_scene_unflatten_create(NULL, flat, GUSSET_DIRECTION_DOWN, &apart));
    MUST(gusset_scene_get_report(apart, &counts));
    HOLDS(counts.nets == 2);
    gusset_scene_destroy(apart);
    gusset_net_destroy(flat);

    /* The scene as bytes; the net that the axle has twice is stored once. */
    MUST(gusset_scene_encode_create(NULL, scene, NULL, &stream));
    MUST(gusset_stream_get_view(stream, &bytes));
    MUST(gusset_scene_decode_create(NULL, bytes.data, bytes.size, 0, &apart));
    MUST(gusset_scene_get_report(apart, &counts));
    HOLDS(counts.nets == 1 && counts.net_instances == 2);
    gusset_scene_destroy(apart);
    gusset_stream_destroy(stream);

    MUST(gusset_scene_add(NULL, scene, net, &spare));
    MUST(gusset_scene_set_entry(NULL, scene, spare, &hidden));
    MUST(gusset_scene_net_create(NULL, scene, spare, &again));
    gusset_net_destroy(again);
    MUST(gusset_scene_remove(NULL, scene, spare));
    MUST(gusset_scene_remove_child(NULL, scene, axle, wheel));
    MUST(gusset_scene_get_report(scene, &counts));
    HOLDS(counts.net_instances == 1);
    gusset_scene_destroy(scene);
    gusset_net_destroy(net);
}
//! [net_scene]

//! [net_stream]
static void as_bytes(void) {
    const gusset_stream_options options = {.struct_size = sizeof options, .mode = GUSSET_STREAM_LOSSLESS};
    gusset_net *net = tube(), *back = NULL, *rows = NULL;
    gusset_stream *stream = NULL;
    gusset_stream_report info = {.struct_size = sizeof info};
    gusset_stream_decoder *decoder = NULL;
    gusset_stream_view view = {.struct_size = sizeof view};
    size_t done = 0;

    MUST(gusset_net_encode_create(NULL, net, &options, &stream));
    MUST(gusset_stream_get_view(stream, &view));
    MUST(gusset_stream_inspect(NULL, view.data, view.size, &info));
    HOLDS(info.rows == 5 && info.columns == 9 && info.scalar == GUSSET_F64);
    MUST(gusset_net_decode_create(NULL, view.data, view.size, 0, &back));
    HOLDS(memcmp(size_of(back).x, size_of(net).x, 5 * 9 * sizeof(double)) == 0);
    gusset_net_destroy(back);

    /* While it arrives. */
    MUST(gusset_stream_decoder_create(NULL, 0, &decoder));
    MUST(gusset_stream_decoder_push(NULL, decoder, view.data, view.size / 2, &done));
    HOLDS(done <= 5);
    MUST(gusset_stream_decoder_push(NULL, decoder, (const char *)view.data + view.size / 2, view.size - view.size / 2, &done));
    MUST(gusset_stream_decoder_preview_create(NULL, decoder, &rows));
    HOLDS(done == 5 && size_of(rows).rows == 5);
    gusset_net_destroy(rows);
    MUST(gusset_stream_decoder_finish_create(NULL, decoder, &back));
    gusset_net_destroy(back);
    gusset_stream_decoder_destroy(decoder);
    gusset_stream_destroy(stream);
    gusset_net_destroy(net);
}
//! [net_stream]

int main(void) {
    rows_and_columns();
    resolutions();
    joined_and_taken_apart();
    at_rest();
    to_meshes_and_back();
    a_scene();
    as_bytes();
    return 0;
}
