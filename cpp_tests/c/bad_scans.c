/* Aligns and trims with invalid arguments, and with pieces that cannot be aligned, and checks errors and reports. */
#include "check.h"
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#define SIDE 16
#define FACES (2 * (SIDE - 1) * (SIDE - 1))

static gusset_context *context;

static double reported_value(void) {
    gusset_error_report report = {sizeof report, 0, 0, 0, 0.0, 0, 0};
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    return report.value;
}

/* A piece of a height field, or of a plane. */
typedef struct piece {
    double points[SIDE * SIDE][3];
    uint32_t corners[FACES][3];
} piece;

static piece room[3];

/* The part from x = first on, with hills of this height, made larger and then moved along the x axis. */
static gusset_mesh_view part(piece *made, double first, double height, double scale, double shift) {
    gusset_mesh_view view = {.struct_size = sizeof view, .scalar = GUSSET_F64, .face_size = 3};
    uint32_t i, j;

    for (i = 0; i < SIDE; ++i) {
        for (j = 0; j < SIDE; ++j) {
            const double x = first + 0.65 * j / (SIDE - 1), y = 1.0 * i / (SIDE - 1);
            double *p = made->points[SIDE * i + j];
            p[0] = scale * x + shift, p[1] = scale * y;
            p[2] = scale * height * (sin(7.0 * x) + cos(7.0 * y) + 0.5 * x * y);
        }
    }
    for (i = 0; i < SIDE - 1; ++i) {
        for (j = 0; j < SIDE - 1; ++j) {
            const uint32_t v = SIDE * i + j;
            const uint32_t two[6] = {v, v + 1, v + SIDE + 1, v, v + SIDE + 1, v + SIDE};
            memcpy(made->corners[2 * ((SIDE - 1) * i + j)], two, sizeof two);
        }
    }
    view.positions = made->points, view.vertex_count = SIDE * SIDE;
    view.face_corners = made->corners, view.face_count = FACES;
    return view;
}

/* Two that overlap, where they belong. */
static void two_hills(gusset_mesh_view *pieces) {
    pieces[0] = part(&room[0], 0.0, 0.1, 1.0, 0.0);
    pieces[1] = part(&room[1], 0.35, 0.1, 1.0, 0.0);
}

static gusset_status align(const gusset_mesh_view *pieces, size_t count, const gusset_alignment_options *options,
                           gusset_alignment **alignment) {
    return gusset_alignment_create(context, pieces, count, options, alignment);
}

static gusset_status trim(const gusset_mesh_view *pieces, size_t count, const gusset_trim_options *options,
                          gusset_trim **done) {
    return gusset_trim_create(context, pieces, count, options, done);
}

static void alignment_arguments(void) {
    static const gusset_transform same = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
    gusset_mesh_view pieces[2];
    gusset_alignment_options options = {0};
    gusset_alignment_view view = {0};
    gusset_alignment *done = NULL;
    gusset_transform poses[3];
    gusset_trim_view other = {.struct_size = sizeof other};

    two_hills(pieces);
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, done, align(NULL, 2, NULL, &done));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, align(pieces, 2, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, align(pieces, 2, NULL, misaligned()));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, align(misaligned(), 2, NULL, &done));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, align(pieces, 2, misaligned(), &done));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, gusset_alignment_create(misaligned(), pieces, 2, NULL, &done));
    FAILS(GUSSET_ERROR_EMPTY_MESH, done, align(pieces, 0, NULL, &done));
    FAILS(GUSSET_ERROR_EMPTY_MESH, done, align(NULL, 0, NULL, &done));
    FAILS(GUSSET_ERROR_TOO_LARGE, done, align(pieces, SIZE_MAX, NULL, &done));
    pieces[1].struct_size = 8;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, align(pieces, 2, NULL, &done));
    REPORT(context, GUSSET_ERROR_BAD_STRUCT_SIZE, GUSSET_ELEMENT_ITEM, 1, 1);

    /* An error of a mesh names the index of its piece. */
    two_hills(pieces);
    room[1].points[5][2] = NAN;
    FAILS(GUSSET_ERROR_NOT_FINITE, done, align(pieces, 2, NULL, &done));
    REPORT(context, GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_VERTEX, 5, 1);
    room[1].points[5][2] = INFINITY;
    FAILS(GUSSET_ERROR_NOT_FINITE, done, align(pieces, 2, NULL, &done));
    two_hills(pieces);
    pieces[1].vertex_count = SIDE;
    FAILS(GUSSET_ERROR_INDEX_OUT_OF_RANGE, done, align(pieces, 2, NULL, &done));
    two_hills(pieces);

    /* Every field of the options. */
    for (options.struct_size = 0; options.struct_size < sizeof options; ++options.struct_size) {
        FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, align(pieces, 2, &options, &done));
    }
    options.start = 4;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, align(pieces, 2, &options, &done));
    CHECK(reported_value() == 4.0);
    options.start = UINT32_MAX;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, align(pieces, 2, &options, &done));
    options.start = 0, options.reserved = 1;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, align(pieces, 2, &options, &done));
    options.reserved = 0, options.max_distance = -1e-300;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, align(pieces, 2, &options, &done));
    CHECK(reported_value() == -1e-300);
    options.max_distance = INFINITY;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, align(pieces, 2, &options, &done));
    options.max_distance = NAN;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, align(pieces, 2, &options, &done));
    CHECK(isnan(reported_value()));
    options.max_distance = 0.0;

    /* Poses that are missing, too few, or not rigid motions. */
    options.pose_count = 2;
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, done, align(pieces, 2, &options, &done));
    options.poses = poses, options.pose_count = SIZE_MAX;
    FAILS(GUSSET_ERROR_SIZE_OVERFLOW, done, align(pieces, 2, &options, &done));
    poses[0] = poses[1] = poses[2] = same, options.pose_count = 1;
    FAILS(GUSSET_ERROR_COUNT_DIFFERS, done, align(pieces, 2, &options, &done));
    REPORT(context, GUSSET_ERROR_COUNT_DIFFERS, GUSSET_ELEMENT_COUNT, 1, 0);
    CHECK(reported_value() == 2.0);
    options.pose_count = 2;
    for (size_t k = 0; k < 2; ++k) {
        for (int place = 0; place < 12; ++place) {
            poses[k].rows[place] = place % 2 ? NAN : INFINITY;
            FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, align(pieces, 2, &options, &done));
            REPORT(context, GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, k, 0);
            poses[k].rows[place] = place % 2 ? -INFINITY : NAN;
            FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, align(pieces, 2, &options, &done));
            REPORT(context, GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, k, 0);
            poses[k] = same;
        }
        /* A mirror, a change of size, a shear, and nothing at all. */
        poses[k].rows[5] = -1.0;
        FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, align(pieces, 2, &options, &done));
        REPORT(context, GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, k, 0);
        poses[k].rows[0] = poses[k].rows[5] = poses[k].rows[10] = 1.001;
        FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, align(pieces, 2, &options, &done));
        REPORT(context, GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, k, 0);
        poses[k] = same, poses[k].rows[1] = 0.01;
        FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, align(pieces, 2, &options, &done));
        REPORT(context, GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, k, 0);
        memset(&poses[k], 0, sizeof poses[k]);
        FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, align(pieces, 2, &options, &done));
        REPORT(context, GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, k, 0);
        poses[k] = same;
    }
    gusset_context_cancel(context);
    FAILS(GUSSET_ERROR_CANCELLED, done, align(pieces, 2, &options, &done));
    gusset_context_reset(context);

    /* The views. */
    EXPECT(GUSSET_OK, align(pieces, 2, &options, &done));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_alignment_get_view(done, &view));
    view.struct_size = sizeof view, view.piece_count = 7;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_alignment_get_view(NULL, &view));
    CHECK(view.piece_count == 0 && view.struct_size == sizeof view);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_alignment_get_view(done, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_alignment_get_view(misaligned(), &view));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_alignment_get_view(done, misaligned()));
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_trim_get_view((const gusset_trim *)(const void *)done, &other));
    EXPECT(GUSSET_OK, gusset_alignment_get_view(done, &view));
    CHECK(view.piece_count == 2 && view.overlap_count == 1 && view.rounds > 0 && view.converged == 1);
    CHECK(view.pieces[0].hold == 1.0 && view.pieces[1].hold > 0.0 && view.pieces[1].hold <= 1.0);
    CHECK(view.overlaps[0].pieces[0] == 0 && view.overlaps[0].pieces[1] == 1 && view.overlaps[0].count >= 30);
    gusset_alignment_destroy(done);
    gusset_alignment_destroy(NULL);
}

/* The reason reported for the last piece. */
static uint32_t reason(const gusset_mesh_view *pieces, size_t count) {
    gusset_alignment_view view = {.struct_size = sizeof view};
    gusset_alignment *done = NULL;
    uint32_t found = UINT32_MAX;

    EXPECT(GUSSET_OK, align(pieces, count, NULL, &done));
    EXPECT(GUSSET_OK, gusset_alignment_get_view(done, &view));
    CHECK(view.piece_count == count);
    if (view.piece_count == count) {
        CHECK(view.pieces[0].reason == GUSSET_ALIGNED_TRUSTED);
        found = view.pieces[count - 1].reason;
    }
    gusset_alignment_destroy(done);
    return found;
}

/* No failures, but pieces that cannot be trusted to lie right. */
static void what_is_said(void) {
    gusset_mesh_view pieces[3];
    double points[SIDE * SIDE][3];
    size_t f;

    two_hills(pieces);
    CHECK(reason(pieces, 1) == GUSSET_ALIGNED_TRUSTED);
    CHECK(reason(pieces, 2) == GUSSET_ALIGNED_TRUSTED);

    /* Far apart; and a third piece that lies on the second, which lies on nothing. */
    pieces[1] = part(&room[1], 0.35, 0.1, 1.0, 9.0);
    CHECK(reason(pieces, 2) == GUSSET_ALIGNED_NO_OVERLAP);
    pieces[2] = part(&room[2], 0.0, 0.1, 1.0, 9.0);
    CHECK(reason(pieces, 3) == GUSSET_ALIGNED_TRUSTED_BY_NONE);

    /* In other units, larger and smaller. */
    pieces[1] = part(&room[1], 0.35, 0.1, 1000.0, 1e5);
    CHECK(reason(pieces, 2) == GUSSET_ALIGNED_OTHER_SIZE);
    pieces[1] = part(&room[1], 0.35, 0.1, 0.001, 1e5);
    CHECK(reason(pieces, 2) == GUSSET_ALIGNED_OTHER_SIZE);

    /* Planes slide on each other. */
    pieces[0] = part(&room[0], 0.0, 0.0, 1.0, 0.0);
    pieces[1] = part(&room[1], 0.35, 0.0, 1.0, 0.0);
    CHECK(reason(pieces, 2) == GUSSET_ALIGNED_UNDETERMINED);

    /* Inside out. */
    two_hills(pieces);
    for (f = 0; f < FACES; ++f) {
        const uint32_t v = room[1].corners[f][1];
        room[1].corners[f][1] = room[1].corners[f][2], room[1].corners[f][2] = v;
    }
    CHECK(reason(pieces, 2) == GUSSET_ALIGNED_FACES_OTHER_WAY);

    /* Without a face that has an area. */
    two_hills(pieces);
    memset(points, 0, sizeof points);
    pieces[1].positions = points;
    CHECK(reason(pieces, 2) == GUSSET_ALIGNED_NO_OVERLAP);
}

static void trim_arguments(void) {
    gusset_mesh_view pieces[2];
    gusset_trim_options options = {0};
    gusset_trim_view view = {0};
    gusset_trim *done = NULL;
    double viewpoints[2][3] = {{0.3, 0.5, 9.0}, {0.7, 0.5, 9.0}};
    gusset_alignment_view other = {.struct_size = sizeof other};

    two_hills(pieces);
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, done, trim(NULL, 2, NULL, &done));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, trim(pieces, 2, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, trim(pieces, 2, NULL, misaligned()));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, trim(misaligned(), 2, NULL, &done));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, trim(pieces, 2, misaligned(), &done));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, gusset_trim_create(misaligned(), pieces, 2, NULL, &done));
    FAILS(GUSSET_ERROR_EMPTY_MESH, done, trim(pieces, 0, NULL, &done));
    FAILS(GUSSET_ERROR_EMPTY_MESH, done, trim(NULL, 0, NULL, &done));
    FAILS(GUSSET_ERROR_TOO_LARGE, done, trim(pieces, SIZE_MAX, NULL, &done));
    pieces[1].struct_size = 8;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, trim(pieces, 2, NULL, &done));
    REPORT(context, GUSSET_ERROR_BAD_STRUCT_SIZE, GUSSET_ELEMENT_ITEM, 1, 1);
    two_hills(pieces);
    room[0].points[7][0] = NAN;
    FAILS(GUSSET_ERROR_NOT_FINITE, done, trim(pieces, 2, NULL, &done));
    REPORT(context, GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_VERTEX, 7, 0);
    two_hills(pieces);

    for (options.struct_size = 0; options.struct_size < sizeof options; ++options.struct_size) {
        FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, trim(pieces, 2, &options, &done));
    }
    options.reserved = 1;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, trim(pieces, 2, &options, &done));
    options.reserved = 0;
    for (int wrong = 0; wrong < 3; ++wrong) {
        static const double distances[3] = {-1e-300, INFINITY, NAN}, angles[3] = {-0.1, 1.571, NAN};
        options.max_distance = distances[wrong];
        FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, trim(pieces, 2, &options, &done));
        CHECK(wrong == 2 ? isnan(reported_value()) : reported_value() == distances[wrong]);
        options.max_distance = 0.0, options.max_angle = angles[wrong];
        FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, trim(pieces, 2, &options, &done));
        CHECK(wrong == 2 ? isnan(reported_value()) : reported_value() == angles[wrong]);
        options.max_angle = 0.0;
    }

    /* Eyes that there are not, are too few, or are nowhere. */
    options.viewpoint_count = 2;
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, done, trim(pieces, 2, &options, &done));
    options.viewpoints = viewpoints[0], options.viewpoint_count = SIZE_MAX;
    FAILS(GUSSET_ERROR_SIZE_OVERFLOW, done, trim(pieces, 2, &options, &done));
    options.viewpoint_count = 1;
    FAILS(GUSSET_ERROR_COUNT_DIFFERS, done, trim(pieces, 2, &options, &done));
    REPORT(context, GUSSET_ERROR_COUNT_DIFFERS, GUSSET_ELEMENT_COUNT, 1, 0);
    CHECK(reported_value() == 2.0);
    options.viewpoint_count = 2;
    for (int place = 0; place < 6; ++place) {
        const double good = viewpoints[place / 3][place % 3];
        viewpoints[place / 3][place % 3] = place % 2 ? -INFINITY : NAN;
        FAILS(GUSSET_ERROR_NOT_FINITE, done, trim(pieces, 2, &options, &done));
        REPORT(context, GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_POINT, (uint64_t)(place / 3), 0);
        CHECK(place % 2 ? reported_value() == -INFINITY : isnan(reported_value()));
        viewpoints[place / 3][place % 3] = good;
    }
    gusset_context_cancel(context);
    FAILS(GUSSET_ERROR_CANCELLED, done, trim(pieces, 2, &options, &done));
    gusset_context_reset(context);

    /* The views. */
    EXPECT(GUSSET_OK, trim(pieces, 2, &options, &done));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_trim_get_view(done, &view));
    view.struct_size = sizeof view, view.piece_count = 7;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_trim_get_view(NULL, &view));
    CHECK(view.piece_count == 0 && view.struct_size == sizeof view);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_trim_get_view(done, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_trim_get_view(misaligned(), &view));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_trim_get_view(done, misaligned()));
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_alignment_get_view((const gusset_alignment *)(const void *)done, &other));
    EXPECT(GUSSET_OK, gusset_trim_get_view(done, &view));
    CHECK(view.piece_count == 2 && view.pieces[0].covered_vertices > 0 && view.pieces[1].covered_vertices > 0);
    CHECK(view.pieces[0].kept.count + view.pieces[1].kept.count < 2 * FACES);
    gusset_trim_destroy(done);
    gusset_trim_destroy(NULL);

    /* A single piece overlaps no other; two pieces that are far apart do not overlap. */
    EXPECT(GUSSET_OK, trim(pieces, 1, NULL, &done));
    EXPECT(GUSSET_OK, gusset_trim_get_view(done, &view));
    CHECK(view.piece_count == 1 && view.pieces[0].kept.count == FACES && view.pieces[0].covered_vertices == 0);
    gusset_trim_destroy(done);
    pieces[1] = part(&room[1], 0.35, 0.1, 1.0, 9.0);
    EXPECT(GUSSET_OK, trim(pieces, 2, NULL, &done));
    EXPECT(GUSSET_OK, gusset_trim_get_view(done, &view));
    CHECK(view.pieces[0].kept.count == FACES && view.pieces[1].kept.count == FACES && view.crossings == 0);
    gusset_trim_destroy(done);
}

static gusset_status assemble(const gusset_mesh_view *pieces, const gusset_join_options *options,
                              gusset_result **assembly) {
    return gusset_join(context, pieces, 2, options, assembly);
}

static void assembly_overlaps(void) {
    gusset_mesh_view pieces[2];
    gusset_join_options options = {.struct_size = sizeof options, .overlaps = 2};
    gusset_join_report parts = {.struct_size = sizeof parts};
    gusset_trim_options how = {0};
    gusset_result *done = NULL;
    double viewpoint[3] = {0.0, 0.0, 9.0};
    size_t k, f, gone = 0;

    two_hills(pieces);
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, assemble(pieces, &options, &done));
    CHECK(reported_value() == 2.0);
    CHECK(strcmp(gusset_context_get_message(context),
                 "overlaps is 2; it must be GUSSET_OVERLAPS_KEEP or GUSSET_OVERLAPS_TRIM") == 0);
    options.overlaps = UINT32_MAX;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, assemble(pieces, &options, &done));
    options.overlaps = GUSSET_OVERLAPS_TRIM, options.trim_options = misaligned();
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, assemble(pieces, &options, &done));
    options.trim_options = &how;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, assemble(pieces, &options, &done));
    how.struct_size = sizeof how, how.max_distance = -1.0;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, &options, &done));
    how.max_distance = NAN;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, &options, &done));
    how.max_distance = 0.0, how.max_angle = 1.6;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, &options, &done));
    how.max_angle = 0.0, how.viewpoint_count = 1;
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, done, assemble(pieces, &options, &done));
    how.viewpoints = viewpoint;
    FAILS(GUSSET_ERROR_COUNT_DIFFERS, done, assemble(pieces, &options, &done));
    how.viewpoints = NULL, how.viewpoint_count = 0, how.reserved = 1;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, assemble(pieces, &options, &done));
    how.reserved = 0;

    EXPECT(GUSSET_OK, assemble(pieces, &options, &done));
    EXPECT(GUSSET_OK, gusset_result_get_join(done, &parts));
    CHECK(parts.piece_count == 2 && parts.trimmed_faces > 0);
    for (k = 0; k < parts.piece_count; ++k) {
        CHECK(parts.pieces[k].faces.count == FACES && parts.pieces[k].vertices.count == SIDE * SIDE);
        for (f = 0; f < parts.pieces[k].faces.count; ++f) {
            gone += parts.pieces[k].faces.data[f] == UINT32_MAX;
        }
    }
    CHECK(gone == parts.trimmed_faces);
    gusset_result_destroy(done);

    /* A struct of the first version ends before trim_options: memory behind it is not read. */
    options.struct_size = offsetof(gusset_join_options, trim_options), options.trim_options = misaligned();
    EXPECT(GUSSET_OK, assemble(pieces, &options, &done));
    EXPECT(GUSSET_OK, gusset_result_get_join(done, &parts));
    CHECK(parts.trimmed_faces > 0);
    gusset_result_destroy(done);
    options.overlaps = GUSSET_OVERLAPS_KEEP;
    EXPECT(GUSSET_OK, assemble(pieces, &options, &done));
    EXPECT(GUSSET_OK, gusset_result_get_join(done, &parts));
    CHECK(parts.trimmed_faces == 0);
    gusset_result_destroy(done);
}

int main(void) {
    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    alignment_arguments();
    what_is_said();
    trim_arguments();
    assembly_overlaps();
    gusset_context_destroy(context);
    return failures != 0;
}
