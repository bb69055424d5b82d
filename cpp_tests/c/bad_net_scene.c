/* Calls functions of scenes with invalid and valid arguments, and checks errors and results. */
#include "check.h"
#include <math.h>

static gusset_context *context;

static gusset_net *square(void) {
    static float x[4] = {0, 1, 0, 1}, y[4] = {0, 0, 1, 1}, z[4];
    const gusset_net_view arrays = {sizeof arrays, 2, 2, x, y, z, 0, 0, GUSSET_F32, 0};
    gusset_net *net = NULL;
    EXPECT(GUSSET_OK, gusset_net_create(context, &arrays, NULL, GUSSET_NET_MEMORY_COPY, &net));
    return net;
}

static void editing(void) {
    gusset_scene *scene = (gusset_scene *)misaligned();
    gusset_net *net = square(), *shared = NULL;
    gusset_transform move = {{1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0}}, bad = move;
    const gusset_transform identity = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
    gusset_scene_changes changes;
    gusset_scene_entry_report entry;
    gusset_scene_report counts;
    gusset_scene_instance instances[4];
    uint32_t a = 7, group = 7, other = 7, spare = 7, children[2] = {9, 9};
    size_t written = 7;

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_create(context, NULL));
    EXPECT(GUSSET_OK, gusset_scene_create(context, &scene));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_add(context, NULL, net, &a));
    CHECK(a == UINT32_MAX);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_add(context, scene, net, NULL));
    EXPECT(GUSSET_OK, gusset_scene_add(context, scene, net, &a));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_add(context, NULL, NULL, &group));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_add(context, scene, NULL, NULL));
    EXPECT(GUSSET_OK, gusset_scene_add(context, scene, NULL, &group));
    EXPECT(GUSSET_OK, gusset_scene_add(context, scene, NULL, &other));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_add_child(context, NULL, group, a));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_scene_add_child(context, scene, a, group));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_scene_add_child(context, scene, group, 17));
    EXPECT(GUSSET_ERROR_SCENE_CYCLE, gusset_scene_add_child(context, scene, group, group));
    EXPECT(GUSSET_OK, gusset_scene_add_child(context, scene, group, a));
    EXPECT(GUSSET_OK, gusset_scene_add_child(context, scene, group, a));
    EXPECT(GUSSET_OK, gusset_scene_add_child(context, scene, other, group));
    EXPECT(GUSSET_ERROR_SCENE_CYCLE, gusset_scene_add_child(context, scene, group, other));

    memset(&changes, 0, sizeof changes);
    changes.struct_size = sizeof changes, changes.transform = &move;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_set_entry(context, NULL, a, &changes));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_set_entry(context, scene, a, NULL));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_scene_set_entry(context, scene, 3, &changes));
    EXPECT(GUSSET_OK, gusset_scene_set_entry(context, scene, group, &changes));
    /* Changes are atomic: an entry stays visible if the transform in the call that hides it is refused. */
    bad.rows[6] = INFINITY;
    changes.transform = &bad, changes.visibility = GUSSET_VISIBILITY_HIDE;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_scene_set_entry(context, scene, group, &changes));
    changes.transform = (const gusset_transform *)misaligned();
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_scene_set_entry(context, scene, a, &changes));
    changes.transform = NULL, changes.visibility = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_scene_set_entry(context, scene, a, &changes));
    changes.visibility = GUSSET_VISIBILITY_HIDE;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_scene_set_entry(context, scene, UINT32_MAX, &changes));
    EXPECT(GUSSET_OK, gusset_scene_set_entry(context, scene, a, &changes));
    changes.visibility = GUSSET_VISIBILITY_SHOW, changes.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_scene_set_entry(context, scene, a, &changes));
    entry.struct_size = sizeof entry;
    EXPECT(GUSSET_OK, gusset_scene_get_entry(scene, a, &entry));
    CHECK(entry.kind == GUSSET_SCENE_NET && entry.visible == 0);
    changes.reserved = 0;
    EXPECT(GUSSET_OK, gusset_scene_set_entry(context, scene, a, &changes));
    changes.visibility = GUSSET_VISIBILITY_KEEP;
    EXPECT(GUSSET_OK, gusset_scene_set_entry(context, scene, a, &changes));
    EXPECT(GUSSET_OK, gusset_scene_get_entry(scene, a, &entry));
    CHECK(entry.visible == 1);
    changes.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_scene_set_entry(context, scene, a, &changes));
    changes.struct_size = sizeof changes;

    entry.struct_size = sizeof entry;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_get_entry(NULL, group, &entry));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_get_entry(scene, group, NULL));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_scene_get_entry(scene, 3, &entry));
    EXPECT(GUSSET_OK, gusset_scene_get_entry(scene, group, &entry));
    CHECK(entry.kind == GUSSET_SCENE_GROUP && entry.child_count == 2 && entry.visible == 1);
    CHECK(memcmp(&entry.transform, &move, sizeof move) == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_net_create(context, NULL, a, &shared));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_scene_net_create(context, scene, group, &shared));
    CHECK(shared == NULL);
    EXPECT(GUSSET_OK, gusset_scene_net_create(context, scene, a, &shared));
    changes.net = shared;
    EXPECT(GUSSET_OK, gusset_scene_set_entry(context, scene, a, &changes));
    changes.visibility = GUSSET_VISIBILITY_HIDE, changes.transform = &identity;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_scene_set_entry(context, scene, group, &changes));
    EXPECT(GUSSET_OK, gusset_scene_get_entry(scene, group, &entry));
    CHECK(entry.visible == 1 && memcmp(&entry.transform, &move, sizeof move) == 0);
    changes.net = (const gusset_net *)scene;
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_scene_set_entry(context, scene, a, &changes));
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_scene_add(context, scene, changes.net, &spare));
    CHECK(spare == UINT32_MAX);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_get_children(context, NULL, group, children, 2, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_get_children(context, scene, group, children, 2, NULL));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_scene_get_children(context, scene, a, children, 2, &written));
    CHECK(written == 0);
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_scene_get_children(context, scene, group, children, 1, &written));
    CHECK(written == 2 && children[0] == 9);
    EXPECT(GUSSET_OK, gusset_scene_get_children(context, scene, group, NULL, 0, &written));
    EXPECT(GUSSET_OK, gusset_scene_get_children(context, scene, group, children, 2, &written));
    CHECK(written == 2 && children[0] == a && children[1] == a);

    counts.struct_size = sizeof counts;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_get_report(NULL, &counts));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_get_report(scene, NULL));
    EXPECT(GUSSET_OK, gusset_scene_get_report(scene, &counts));
    CHECK(counts.instances == 4 && counts.net_instances == 2 && counts.nets == 1 && counts.groups == 2);
    CHECK(counts.levels == 3);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_world_transforms(context, NULL, instances, 4, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_world_transforms(context, scene, instances, 4, NULL));
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_scene_world_transforms(context, scene, instances, 3, &written));
    EXPECT(GUSSET_OK, gusset_scene_world_transforms(context, scene, instances, 4, &written));
    CHECK(written == 4 && instances[0].entry == other && instances[0].parent == UINT32_MAX);
    CHECK(instances[3].entry == a && instances[3].parent == 1 && instances[3].world.rows[3] == 5);

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_remove_child(context, NULL, group, a));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_scene_remove_child(context, scene, other, a));
    EXPECT(GUSSET_OK, gusset_scene_remove_child(context, scene, group, a));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_remove(context, NULL, other));
    EXPECT(GUSSET_OK, gusset_scene_remove(context, scene, other));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_scene_remove(context, scene, other));
    EXPECT(GUSSET_OK, gusset_scene_get_report(scene, &counts));
    CHECK(counts.instances == 2 && counts.levels == 2);
    /* The order of destruction is free. */
    gusset_net_destroy(net);
    gusset_scene_destroy(scene);
    gusset_net_destroy(shared);
    gusset_scene_destroy(NULL);
}

static void flattening(void) {
    gusset_scene *scene = NULL, *back = (gusset_scene *)misaligned();
    gusset_net *net = square(), *flat = (gusset_net *)misaligned();
    const gusset_transform move = {{1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0}};
    gusset_scene_changes changes = {.struct_size = sizeof changes};
    gusset_concatenate_options options;
    gusset_net_view view;
    gusset_scene_report counts;
    gusset_bridge bridge;
    uint32_t entries[2], groups[64];

    EXPECT(GUSSET_OK, gusset_scene_create(context, &scene));
    EXPECT(GUSSET_ERROR_EMPTY_SCENE, gusset_scene_flatten_create(context, scene, NULL, &flat));
    CHECK(flat == NULL);
    for (int k = 0; k < 2; k++) {
        EXPECT(GUSSET_OK, gusset_scene_add(context, scene, net, &entries[k]));
    }
    changes.transform = &move;
    EXPECT(GUSSET_OK, gusset_scene_set_entry(context, scene, entries[1], &changes));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_flatten_create(context, NULL, NULL, &flat));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_flatten_create(context, scene, NULL, NULL));
    memset(&options, 0, sizeof options);
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_scene_flatten_create(context, scene, &options, &flat));
    options.struct_size = sizeof options;
    options.mode = 9;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_scene_flatten_create(context, scene, &options, &flat));
    EXPECT(GUSSET_OK, gusset_scene_flatten_create(context, scene, NULL, &flat));
    view.struct_size = sizeof view, bridge.struct_size = sizeof bridge;
    EXPECT(GUSSET_OK, gusset_net_get_view(flat, &view));
    CHECK(view.rows == 4 && view.columns == 2 && ((const float *)view.x)[4] == 5);
    EXPECT(GUSSET_OK, gusset_net_get_bridge(flat, 0, &bridge));
    CHECK(bridge.mode == GUSSET_BRIDGE_HIDE && bridge.at == 2);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_unflatten_create(context, NULL, GUSSET_DIRECTION_DOWN, &back));
    CHECK(back == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_unflatten_create(context, flat, GUSSET_DIRECTION_DOWN, NULL));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_scene_unflatten_create(context, flat, 2, &back));
    EXPECT(GUSSET_OK, gusset_scene_unflatten_create(context, flat, GUSSET_DIRECTION_DOWN, &back));
    counts.struct_size = sizeof counts;
    EXPECT(GUSSET_OK, gusset_scene_get_report(back, &counts));
    CHECK(counts.nets == 2 && counts.groups == 1 && counts.levels == 2);
    gusset_scene_destroy(back);
    gusset_net_destroy(flat);

    /* Each group has the one before twice: 2^65 instances and more. */
    for (int k = 0; k < 64; k++) {
        EXPECT(GUSSET_OK, gusset_scene_add(context, scene, NULL, &groups[k]));
        const uint32_t below = k == 0 ? entries[0] : groups[k - 1];
        EXPECT(GUSSET_OK, gusset_scene_add_child(context, scene, groups[k], below));
        EXPECT(GUSSET_OK, gusset_scene_add_child(context, scene, groups[k], below));
    }
    EXPECT(GUSSET_OK, gusset_scene_get_report(scene, &counts));
    CHECK(counts.instances == UINT64_MAX);
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_scene_flatten_create(context, scene, NULL, &flat));
    size_t written = 0;
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_scene_world_transforms(context, scene, NULL, 0, &written));
    gusset_scene_destroy(scene);
    gusset_net_destroy(net);
}

static void transfer(void) {
    gusset_net *net = square(), *none = NULL;
    gusset_scene *scene = NULL, *back = NULL;
    gusset_stream *stream = NULL;
    gusset_stream_options options;
    gusset_stream_view bytes = {.struct_size = sizeof bytes};
    gusset_scene_report counts = {.struct_size = sizeof counts};
    uint32_t entry, group;

    EXPECT(GUSSET_OK, gusset_scene_create(context, &scene));
    EXPECT(GUSSET_OK, gusset_scene_add(context, scene, net, &entry));
    EXPECT(GUSSET_OK, gusset_scene_add(context, scene, NULL, &group));
    EXPECT(GUSSET_OK, gusset_scene_add_child(context, scene, group, entry));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_encode_create(context, NULL, NULL, &stream));
    CHECK(stream == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_encode_create(context, scene, NULL, NULL));
    memset(&options, 0, sizeof options);
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_scene_encode_create(context, scene, &options, &stream));
    options.struct_size = sizeof options, options.mode = 9;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_scene_encode_create(context, scene, &options, &stream));
    options.mode = GUSSET_STREAM_LOSSLESS;
    EXPECT(GUSSET_OK, gusset_scene_encode_create(context, scene, &options, &stream));
    EXPECT(GUSSET_OK, gusset_stream_get_view(stream, &bytes));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_decode_create(context, NULL, bytes.size, 0, &back));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_scene_decode_create(context, bytes.data, bytes.size, 0, NULL));
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_scene_decode_create(context, bytes.data, bytes.size, 3, &back));
    for (size_t k = 0; k < bytes.size; k++) {
        EXPECT(GUSSET_ERROR_BAD_STREAM, gusset_scene_decode_create(context, bytes.data, k, 0, &back));
        CHECK(back == NULL);
    }
    /* The magic of a net differs from the magic of a scene. */
    EXPECT(GUSSET_ERROR_BAD_STREAM, gusset_net_decode_create(context, bytes.data, bytes.size, 0, &none));
    CHECK(none == NULL);
    EXPECT(GUSSET_OK, gusset_scene_decode_create(context, bytes.data, bytes.size, 4, &back));
    EXPECT(GUSSET_OK, gusset_scene_get_report(back, &counts));
    CHECK(counts.nets == 1 && counts.groups == 1 && counts.levels == 2);
    gusset_scene_destroy(back);
    gusset_stream_destroy(stream);
    gusset_scene_destroy(scene);
    gusset_net_destroy(net);
}

int main(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    if (gusset_context_create(&context) != GUSSET_OK || up.face_count != down.face_count) {
        return 1;
    }
    editing();
    flattening();
    transfer();
    gusset_context_destroy(context);
    return failures != 0;
}
