/* Calls functions of origins and attributes with invalid and valid arguments, and checks errors and results. */
#include "check.h"
#include <math.h>
#include <stddef.h>

static gusset_context *context;

static gusset_result *two_pyramids(void) {
    const gusset_mesh_view a = pyramid(pyramid_up), b = pyramid(pyramid_down);
    gusset_result *stitch = NULL;
    EXPECT(GUSSET_OK, gusset_stitch(context, &a, NULL, &b, NULL, NULL, &stitch));
    return stitch;
}

static void origins_of_results(void) {
    gusset_result *stitch = two_pyramids();
    gusset_origins *origins = (gusset_origins *)misaligned();
    gusset_origins_view view = {0};
    uint32_t domain;

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_origins_create(context, NULL, &origins));
    CHECK(origins == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_origins_create(context, stitch, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_origins_create(context, stitch, misaligned()));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_origins_create(context, misaligned(), &origins));
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_result_origins_create(context, (const gusset_result *)(const void *)context, &origins));
    CHECK(origins == NULL);

    EXPECT(GUSSET_OK, gusset_result_origins_create(context, stitch, &origins));
    gusset_result_destroy(stitch);
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_origins_get_view(origins, GUSSET_DOMAIN_VERTICES, &view));
    view.struct_size = sizeof view;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_origins_get_view(NULL, GUSSET_DOMAIN_VERTICES, &view));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_origins_get_view(origins, GUSSET_DOMAIN_VERTICES, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_origins_get_view(origins, GUSSET_DOMAIN_VERTICES, misaligned()));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_origins_get_view(origins, 3, &view));
    CHECK(view.offsets.data == NULL && view.weights == NULL && view.starts.count == 0);
    for (domain = 0; domain < 3; ++domain) {
        const size_t elements[3] = {10, 48, 16}, of_first[3] = {5, 12, 4};
        EXPECT(GUSSET_OK, gusset_origins_get_view(origins, domain, &view));
        CHECK(view.offsets.count == elements[domain] + 1 && view.sources.count >= elements[domain]);
        CHECK(view.starts.count == 3 && view.starts.data[1] == of_first[domain] && view.starts.data[2] == 2 * of_first[domain]);
    }
    gusset_origins_destroy(origins);
    gusset_origins_destroy(NULL);
}

static void values_that_do_not_fit(void) {
    gusset_result *stitch = two_pyramids();
    gusset_origins *origins = NULL;
    float first[5] = {0, 1, 2, 3, 4}, second[5] = {5, 6, 7, 8, 9}, made[10];
    gusset_channel channel = {0};
    gusset_channel_values given[2] = {{first, 5, 0}, {second, 5, 0}};
    gusset_error_report report = {0};
    size_t k;
    const gusset_channel good = {sizeof good, GUSSET_DOMAIN_VERTICES, GUSSET_VALUE_F32, 1, GUSSET_RULE_LINEAR, 0, 0};

    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_result_origins_create(context, stitch, &origins));
    gusset_result_destroy(stitch);
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    channel = good;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_attributes_apply(context, NULL, &channel, given, 2, made, 10, 0));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_attributes_apply(context, origins, NULL, given, 2, made, 10, 0));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_attributes_apply(context, origins, &channel, NULL, 2, made, 10, 0));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_attributes_apply(context, origins, &channel, given, 2, NULL, 10, 0));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_attributes_apply(context, origins, misaligned(), given, 2, made, 10, 0));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_attributes_apply(context, origins, &channel, misaligned(), 2, made, 10, 0));
    EXPECT(GUSSET_ERROR_COUNT_DIFFERS, gusset_attributes_apply(context, origins, &channel, given, 1, made, 10, 0));
    EXPECT(GUSSET_ERROR_COUNT_DIFFERS, gusset_attributes_apply(context, origins, &channel, given, SIZE_MAX, made, 10, 0));
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_attributes_apply(context, origins, &channel, given, 2, made, 9, 0));
    EXPECT(GUSSET_ERROR_BAD_STRIDE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 3));
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_attributes_apply(context, origins, &channel, given, 2, made, SIZE_MAX, 0));
    EXPECT(GUSSET_ERROR_OVERLAP, gusset_attributes_apply(context, origins, &channel, given, 2, second, 10, 0));
    given[1].count = 4;
    EXPECT(GUSSET_ERROR_COUNT_DIFFERS, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_COUNT && report.index == 4 && report.value == 5 && report.input == 1);
    given[1].count = 5, given[1].stride = 2;
    EXPECT(GUSSET_ERROR_BAD_STRIDE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    given[1].stride = 0, given[1].values = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    given[1].count = 0;
    EXPECT(GUSSET_OK, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    CHECK(made[4] == 4 && made[5] == 0 && made[9] == 0);
    given[1].values = second, given[1].count = 5;

    channel.domain = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    channel = good, channel.value_type = 0;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    channel = good, channel.rule = 5;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    channel = good, channel.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    channel = good, channel.components = 0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    channel.components = 4097;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    channel = good, channel.rule = GUSSET_RULE_NORMAL;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    channel.components = 3, channel.value_type = GUSSET_VALUE_U8;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));

    channel = good;
    second[3] = NAN;
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_VERTEX && report.index == 3 && isnan(report.value) && report.input == 1);
    channel.rule = GUSSET_RULE_NEAREST;
    EXPECT(GUSSET_OK, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    CHECK(isnan(made[8]));
    second[3] = -0.5F;
    channel.rule = GUSSET_RULE_SKIN_WEIGHTS;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_VERTEX && report.index == 3 && report.value == -0.5 && report.input == 1);
    channel.rule = GUSSET_RULE_TEXTURE;
    EXPECT(GUSSET_OK, gusset_attributes_apply(context, origins, &channel, given, 2, made, 10, 0));
    for (k = 0; k < 10; ++k) {
        CHECK(made[k] == (k < 5 ? first[k] : second[k - 5]));
    }
    gusset_origins_destroy(origins);
}

static void merge_maps(void) {
    gusset_mesh_view mesh = pyramid(pyramid_up);
    uint32_t merge[5] = {0, 0, 0, 0, 0}, keys[5] = {7, 7, 9, 9, 7};
    gusset_check *check = NULL;
    gusset_error_report report = {0};

    report.struct_size = sizeof report;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_mesh_find_merge(context, NULL, NULL, merge));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_mesh_find_merge(context, &mesh, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_mesh_find_merge(context, misaligned(), NULL, merge));
    EXPECT(GUSSET_OK, gusset_mesh_find_merge(context, &mesh, NULL, merge));
    CHECK(merge[0] == 0 && merge[1] == 1 && merge[4] == 4);
    EXPECT(GUSSET_OK, gusset_mesh_find_merge(context, &mesh, keys, merge));
    CHECK(merge[0] == 0 && merge[1] == 0 && merge[2] == 2 && merge[3] == 2 && merge[4] == 0);
    mesh.merge = merge;
    merge[3] = 5;
    EXPECT(GUSSET_ERROR_BAD_MERGE, gusset_check_create(context, &mesh, &check));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_VERTEX && report.index == 3 && report.value == 5);
    /* A chain is not a valid map. */
    merge[1] = 1, merge[2] = 1, merge[3] = 2, merge[4] = 4;
    EXPECT(GUSSET_ERROR_BAD_MERGE, gusset_check_create(context, &mesh, &check));
    merge[3] = 1;
    EXPECT(GUSSET_OK, gusset_check_create(context, &mesh, &check));
    gusset_check_destroy(check);
    /* A caller of an earlier version has none. */
    mesh.struct_size = offsetof(gusset_mesh_view, merge), merge[3] = 77;
    EXPECT(GUSSET_OK, gusset_check_create(context, &mesh, &check));
    gusset_check_destroy(check);
}

int main(void) {
    EXPECT(GUSSET_OK, gusset_context_create(&context));
    origins_of_results();
    values_that_do_not_fit();
    merge_maps();
    gusset_context_destroy(context);
    return failures != 0;
}
