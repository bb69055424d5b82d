/* Calls gusset_fill with invalid and valid arguments, and checks errors and results. */
#include "check.h"
#include <math.h>

static gusset_context *context;

static void options_and_arguments(void) {
    const gusset_mesh_view mesh = pyramid(pyramid_up);
    gusset_mesh_view bad = mesh;
    gusset_fill_options options = {0};
    gusset_result *fill = (gusset_result *)misaligned();
    const uint32_t rim[4] = {1, 2, 3, 4};
    const gusset_indices loop = {rim, 4};

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_fill(context, NULL, NULL, 0, NULL, &fill));
    CHECK(fill == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_fill(context, &mesh, NULL, 0, NULL, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_fill(context, &mesh, NULL, 1, NULL, &fill));
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_fill(context, &mesh, &loop, SIZE_MAX, NULL, &fill));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_fill(misaligned(), &mesh, NULL, 0, NULL, &fill));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_fill(context, misaligned(), NULL, 0, NULL, &fill));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_fill(context, &mesh, misaligned(), 1, NULL, &fill));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_fill(context, &mesh, NULL, 0, misaligned(), &fill));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_fill(context, &mesh, NULL, 0, NULL, misaligned()));
    bad.scalar = 0;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_fill(context, &bad, NULL, 0, NULL, &fill));

    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.struct_size = sizeof options, options.weight = 4;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.weight = GUSSET_WEIGHT_AREA, options.refine = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.refine = GUSSET_REFINE_RIM_DENSITY, options.fairing = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.fairing = GUSSET_FAIRING_THIN_PLATE, options.keep = 4;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.keep = GUSSET_KEEP_LONGEST, options.intersections = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.intersections = GUSSET_INTERSECTIONS_REPORT, options.plan_only = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.plan_only = 0, options.outward = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.outward = GUSSET_OUTWARD_CLOSED, options.together = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.together = GUSSET_TOGETHER_CHEAPEST, options.groups = rim;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    CHECK(strstr(gusset_context_get_message(context), "loops is NULL beside groups; ") != NULL);
    options.groups = NULL, options.continuity = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.continuity = GUSSET_CONTINUITY_C2, options.ignore_creases = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.ignore_creases = 1, options.max_length = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.max_length = 0.0, options.max_diameter = -1.0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    options.max_diameter = 0.0, options.max_area = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
    CHECK(fill == NULL);
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_fill(context, &mesh, NULL, 0, NULL, &fill));
    gusset_context_reset(context);
    gusset_result_destroy(NULL);
}

static void results(void) {
    const gusset_mesh_view mesh = pyramid(pyramid_up);
    const uint32_t rim[4] = {4, 3, 2, 1}, wrong[3] = {0, 1, 2}, twice[4] = {1, 2, 1, 3};
    gusset_indices loops[5];
    gusset_fill_report parts = {0};
    parts.struct_size = sizeof parts;
    gusset_mesh_view out = {sizeof out, NULL, 0, 0, NULL, NULL, 0, 0, 0, 0, 0, NULL};
    gusset_quality_report quality = {sizeof quality, 0, 0, 0, 0, 0, 0, 0, 0};
    gusset_result *fill = NULL;
    char bytes[1 + sizeof rim];

    memcpy(bytes + 1, rim, sizeof rim);
    loops[0].data = wrong, loops[0].count = 3;
    loops[1].data = twice, loops[1].count = 4;
    loops[2].data = NULL, loops[2].count = 0;
    loops[3].data = (const uint32_t *)(const void *)(bytes + 1), loops[3].count = 4;
    loops[4].data = rim, loops[4].count = 4;
    EXPECT(GUSSET_OK, gusset_fill(context, &mesh, loops, 5, NULL, &fill));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_fill(NULL, &parts));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_fill(fill, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_fill(misaligned(), &parts));
    EXPECT(GUSSET_OK, gusset_result_get_fill(fill, &parts));
    CHECK(parts.hole_count == 5 && parts.rims.count == 15);
    CHECK(parts.intersections_known == 1 && parts.intersections.count == 0);
    CHECK(parts.parents.count == 0 && parts.weights == NULL);
    CHECK(parts.holes[3].finish == GUSSET_PATCH_PLAIN && parts.holes[3].weight == GUSSET_WEIGHT_CONTINUATION &&
          fabs(parts.holes[3].area - 2.0) < 1e-12);
    CHECK(parts.holes[0].status == GUSSET_HOLE_NOT_FREE && parts.holes[0].face_count == 0);
    CHECK(parts.holes[1].status == GUSSET_HOLE_NOT_SIMPLE && parts.rims.data[parts.holes[1].rim_first] == 1);
    CHECK(parts.holes[2].status == GUSSET_HOLE_NOT_SIMPLE && parts.holes[2].rim_count == 0);
    CHECK(parts.holes[3].status == GUSSET_HOLE_FILLED && parts.holes[3].face_first == 4 &&
          parts.holes[3].face_count == 2 && parts.holes[3].vertex_count == 0);
    CHECK(parts.holes[4].status == GUSSET_HOLE_NOT_FREE);
    CHECK(parts.holes[3].patch == 0 && parts.holes[4].patch == UINT32_MAX);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(NULL, &out));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(fill, NULL));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(fill, &out));
    CHECK(out.vertex_count == 5 && out.face_count == 6);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_quality(NULL, &quality));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_quality(fill, NULL));
    EXPECT(GUSSET_OK, gusset_result_get_quality(fill, &quality));
    CHECK(quality.loops_left == 0 && fabs(quality.area - 2.0) < 1e-12);
    parts.struct_size = 8, out.struct_size = 8, quality.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_fill(fill, &parts));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_mesh(fill, &out));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_quality(fill, &quality));
    gusset_result_destroy(fill);

    /* Inside out, it stays so, or is turned over as a whole, patch and all, if asked to be. */
    {
        static const uint32_t inside_out[12] = {0, 2, 1, 0, 3, 2, 0, 4, 3, 0, 1, 4};
        gusset_mesh_view turned = mesh;
        gusset_fill_options options = {0};
        options.struct_size = sizeof options;
        turned.face_corners = inside_out;
        parts.struct_size = sizeof parts, out.struct_size = sizeof out;
        for (options.outward = GUSSET_OUTWARD_AUTO; options.outward <= GUSSET_OUTWARD_CLOSED; ++options.outward) {
            const int turns = options.outward == GUSSET_OUTWARD_CLOSED;
            const uint32_t *faces = turns ? pyramid_faces : inside_out;
            EXPECT(GUSSET_OK, gusset_fill(context, &turned, NULL, 0, &options, &fill));
            EXPECT(GUSSET_OK, gusset_result_get_fill(fill, &parts));
            EXPECT(GUSSET_OK, gusset_result_get_mesh(fill, &out));
            CHECK(parts.turned_outwards.count == (turns ? 6 : 0) && out.face_count == 6);
            for (uint32_t k = 0; k < parts.turned_outwards.count; ++k) {
                CHECK(parts.turned_outwards.data[k] == k);
            }
            /* A turned face keeps its first corner. */
            CHECK(memcmp(out.face_corners, faces, sizeof inside_out) == 0);
            gusset_result_destroy(fill);
        }
    }

    /* Continues the curvature, and ignores creases. A caller of an earlier version, whose struct lacks both fields,
       selects neither. */
    {
        gusset_fill_options options = {0};
        options.struct_size = sizeof options, options.refine = GUSSET_REFINE_RIM_DENSITY;
        options.fairing = GUSSET_FAIRING_THIN_PLATE, options.ignore_creases = 1;
        parts.struct_size = sizeof parts, quality.struct_size = sizeof quality;
        for (uint32_t continuity = GUSSET_CONTINUITY_C1; continuity <= GUSSET_CONTINUITY_C2; ++continuity) {
            options.continuity = continuity;
            EXPECT(GUSSET_OK, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
            EXPECT(GUSSET_OK, gusset_result_get_fill(fill, &parts));
            EXPECT(GUSSET_OK, gusset_result_get_quality(fill, &quality));
            CHECK(parts.holes[0].status == GUSSET_HOLE_FILLED && quality.loops_left == 0);
            gusset_result_destroy(fill);
        }
        options.struct_size = offsetof(gusset_fill_options, continuity), options.continuity = 77;
        EXPECT(GUSSET_OK, gusset_fill(context, &mesh, NULL, 0, &options, &fill));
        gusset_result_destroy(fill);
    }

    /* Two pyramids that look at each other, closed together. */
    {
        double points[10][3];
        uint32_t faces[24], groups[2] = {9, 9};
        const uint32_t upper[4] = {1, 2, 3, 4}, lower[4] = {6, 7, 8, 9};
        gusset_mesh_view both = mesh;
        gusset_fill_options options = {0};
        options.struct_size = sizeof options, options.groups = groups;
        memcpy(points, pyramid_up, sizeof pyramid_up);
        memcpy(points + 5, pyramid_down, sizeof pyramid_down);
        for (int k = 0; k < 12; ++k) {
            faces[k] = pyramid_faces[k], faces[12 + k] = pyramid_faces[k] + 5;
        }
        both.positions = points, both.vertex_count = 10;
        both.face_corners = faces, both.face_count = 8;
        loops[0].data = upper, loops[1].data = lower;
        loops[0].count = loops[1].count = 4;
        parts.struct_size = sizeof parts, quality.struct_size = sizeof quality;
        EXPECT(GUSSET_OK, gusset_fill(context, &both, loops, 2, &options, &fill));
        EXPECT(GUSSET_OK, gusset_result_get_fill(fill, &parts));
        EXPECT(GUSSET_OK, gusset_result_get_quality(fill, &quality));
        CHECK(parts.holes[0].patch == 0 && parts.holes[1].patch == 0);
        for (int k = 0; k < 2; ++k) {
            CHECK(parts.holes[k].face_first == 8 && parts.holes[k].face_count == 8);
        }
        CHECK(fabs(quality.area - 8 * sqrt(2.0)) < 1e-12 && quality.loops_left == 0);
        gusset_result_destroy(fill);
        groups[1] = 1;
        EXPECT(GUSSET_OK, gusset_fill(context, &both, loops, 2, &options, &fill));
        EXPECT(GUSSET_OK, gusset_result_get_fill(fill, &parts));
        CHECK(parts.holes[0].patch == 0 && parts.holes[1].patch == 1 && parts.holes[1].face_first == 10);
        gusset_result_destroy(fill);
    }

    /* A vertex that the mesh does not have. */
    {
        const uint32_t missing[3] = {1, 2, 99};
        gusset_error_report report = {sizeof report, 0, 0, 0, 0, 0, 0};
        loops[0].data = rim, loops[0].count = 4;
        loops[1].data = NULL, loops[1].count = 3;
        EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_fill(context, &mesh, loops, 2, NULL, &fill));
        EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
        CHECK(report.element == GUSSET_ELEMENT_ITEM && report.index == 1);
        CHECK(strcmp(gusset_context_get_message(context), "loops[1]: data is NULL; it must not be") == 0);
        loops[1].data = missing, loops[1].count = 3;
        EXPECT(GUSSET_ERROR_INDEX_OUT_OF_RANGE, gusset_fill(context, &mesh, loops, 2, NULL, &fill));
        EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
        CHECK(fill == NULL && report.element == GUSSET_ELEMENT_LOOP_PLACE && report.index == 2 && report.value == 99 &&
              report.input == 1);
    }
}

int main(void) {
    const gusset_mesh_view other = pyramid(pyramid_down);
    if (gusset_context_create(&context) != GUSSET_OK || other.face_count != 4) {
        return 1;
    }
    options_and_arguments();
    results();
    gusset_context_destroy(context);
    return failures != 0;
}
