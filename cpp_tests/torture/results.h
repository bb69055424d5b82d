/* Properties of the results of a call, and their hashes, by which two calls are compared. Included by torture.h at
   its end. */
#ifndef TORTURE_RESULTS_H
#define TORTURE_RESULTS_H

#include <math.h>

static inline uint64_t torture_hash(uint64_t hash, const void *data, size_t size) {
    for (size_t i = 0; data && i < size; ++i) hash = (hash ^ ((const unsigned char *)data)[i]) * 0x100000001B3u;
    return hash;
}

/* The state of a net: the content of its stream. */
static inline uint64_t torture_hash_net(uint64_t hash, const gusset_net *net) {
    const gusset_stream_options raw = {.struct_size = sizeof raw, .mode = GUSSET_STREAM_RAW};
    gusset_stream *stream = NULL;
    gusset_stream_view view = {.struct_size = sizeof view};
    if ((gusset_net_encode_create)(NULL, net, &raw, &stream) != GUSSET_OK) return hash;
    if ((gusset_stream_get_view)(stream, &view) == GUSSET_OK) hash = torture_hash(hash, view.data, view.size);
    (gusset_stream_destroy)(stream);
    return hash;
}

/* The state of a scene: the transforms of its entries, and its counts. */
static inline uint64_t torture_hash_scene(uint64_t hash, const gusset_scene *scene) {
    static gusset_scene_instance instances[4096];
    gusset_scene_report report = {.struct_size = sizeof report};
    size_t written = 0;
    if ((gusset_scene_get_report)(scene, &report) == GUSSET_OK) hash = torture_hash(hash, &report, sizeof report);
    if ((gusset_scene_world_transforms)(NULL, scene, instances, 4096, &written) == GUSSET_OK)
        hash = torture_hash(hash, instances, written * sizeof *instances);
    return hash;
}

/* The state of a decoder: its rows. */
static inline uint64_t torture_hash_decoder(uint64_t hash, const gusset_stream_decoder *decoder) {
    gusset_net *net = NULL;
    if ((gusset_stream_decoder_preview_create)(NULL, decoder, &net) != GUSSET_OK) return hash;
    hash = torture_hash_net(hash, net);
    (gusset_net_destroy)(net);
    return hash;
}

/* After a call, with what it gave and what it changed: the same as of the call as it is, or as before. */
static inline void torture_results(gusset_status status, uint64_t changed, uint64_t result) {
    struct torture_shared *const told = torture_told;
    if (told->phase < TORTURE_ONE_ALLOCATION) return;
    if (told->value == 0 && told->phase == TORTURE_ONE_ALLOCATION) {
        told->result = changed * 31 + result;
    } else if (status == told->plain ? changed * 31 + result != told->result : changed != torture_before) {
        torture_fails(status == told->plain ? "another result than before" : "half a change");
    }
}

/* An output before a call: nothing that it may hold after a failure. */
static inline void torture_soil(void *output, size_t from, size_t to) {
    if (from < to) memset((char *)output + from, 0x5A, to - from);
}

/* An output after the call: 0 if the call failed, or all ones, which is neither a type, nor an index. */
static inline void torture_cleared(gusset_status status, const void *output, size_t from, size_t to, const char *name) {
    const unsigned char *const bytes = output;
    for (size_t i = from; status != GUSSET_OK && i < to; ++i)
        if (bytes[i] != 0 && bytes[i] != 0xFF) {
            printf("%s: %s is not cleared\n", torture_told->now, name);
            ++torture_told->failures;
            return;
        }
}

/* A result: there if the call succeeded, NULL if not. */
static inline void torture_made(gusset_status status, const void *made) {
    if (status == GUSSET_OK && (made == NULL || (uintptr_t)made == TORTURE_UNTOUCHED)) torture_fails("no result");
    if (status != GUSSET_OK && made != NULL) torture_fails((uintptr_t)made == TORTURE_UNTOUCHED ? "the output is not cleared" : "half a result");
}

/* Coordinates that a result lends, hashed. */
static inline uint64_t torture_finite(uint64_t hash, const void *list, size_t count, int real, const char *name) {
    for (size_t i = 0; list && i < 2 * count; ++i)
        if (!isfinite(real ? ((const double *)list)[i] : (double)((const float *)list)[i])) {
            torture_fails(name);
            break;
        }
    if (torture_told->phase < TORTURE_ONE_ALLOCATION) return hash;
    return torture_hash(hash, list, 2 * count * (real ? sizeof(double) : sizeof(float)));
}

/* The same of a mesh that a result lends: a vertex without faces may be anything, as it was given. */
static inline uint64_t torture_finite_mesh(uint64_t hash, const gusset_mesh_view *mesh) {
    const int real = mesh->scalar == GUSSET_F64;
    const uint32_t *const offsets = mesh->face_offsets, *const corners = mesh->face_corners;
    const size_t count = mesh->face_count == 0 ? 0 : mesh->face_size ? mesh->face_size * mesh->face_count : offsets[mesh->face_count];
    for (size_t k = 0; k < 3 * count; ++k) {
        const size_t at = 3 * (size_t)corners[k / 3] + k % 3;
        if (!isfinite(real ? ((const double *)mesh->positions)[at] : (double)((const float *)mesh->positions)[at])) {
            torture_fails("positions");
            break;
        }
    }
    if (torture_told->phase < TORTURE_ONE_ALLOCATION) return hash;
    return torture_hash(hash, mesh->positions, 3 * mesh->vertex_count * (real ? sizeof(double) : sizeof(float)));
}

#endif
