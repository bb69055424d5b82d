/* Calls functions of outlines with invalid and valid arguments, and checks errors and results. */
#include "check.h"
#include <math.h>

static gusset_context *context;
static const double square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

static gusset_outlines given(const void *points, size_t count) {
    gusset_outlines outlines;
    memset(&outlines, 0, sizeof outlines);
    outlines.struct_size = sizeof outlines;
    outlines.points = points;
    outlines.point_count = count;
    outlines.dimension = 2;
    outlines.closed = 1;
    return outlines;
}

static gusset_status fit(const gusset_outlines *outlines, const gusset_outline_options *options) {
    gusset_outline *outline = (gusset_outline *)misaligned();
    const gusset_status status = gusset_outline_create(context, outlines, options, &outline);
    CHECK((outline == NULL) == (status != GUSSET_OK));
    gusset_outline_destroy(outline);
    return status;
}

/* The measures of a copy of curve `index`; all 0 if the curve does not exist. */
static gusset_curve_measures measures_of(const gusset_outline *outline, size_t index) {
    gusset_curve_measures measures;
    gusset_curve *curve = NULL;
    memset(&measures, 0, sizeof measures);
    measures.struct_size = sizeof measures;
    if (outline != NULL) {
        EXPECT(GUSSET_OK, gusset_outline_curve_create(context, outline, index, &curve));
        EXPECT(GUSSET_OK, gusset_curve_measure(context, curve, 0, &measures));
        gusset_curve_destroy(curve);
    }
    return measures;
}

static void arguments(void) {
    gusset_outlines outlines = given(square, 4), bad;
    gusset_outline *outline = NULL;
    gusset_error_report report;

    report.struct_size = sizeof report;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_outline_create(context, NULL, NULL, &outline));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_outline_create(context, &outlines, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_outline_create(misaligned(), &outlines, NULL, &outline));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_outline_create(context, misaligned(), NULL, &outline));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_outline_create(context, &outlines, misaligned(), &outline));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_outline_create(context, &outlines, NULL, misaligned()));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_outlines_find_sections(context, NULL, NULL, NULL, NULL, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_outlines_find_sections(context, &outlines, NULL, misaligned(), NULL, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_outlines_find_sections(context, &outlines, NULL, NULL, misaligned(), NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_outlines_find_sections(context, &outlines, NULL, NULL, NULL, NULL, misaligned()));
    EXPECT(GUSSET_OK, gusset_outlines_find_sections(context, &outlines, NULL, NULL, NULL, NULL, NULL));

    bad = outlines, bad.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, fit(&bad, NULL));
    bad = outlines, bad.points = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, fit(&bad, NULL));
    bad = outlines, bad.dimension = 4;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, fit(&bad, NULL));
    bad = outlines, bad.dimension = 0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, fit(&bad, NULL));
    bad = outlines, bad.closed = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, fit(&bad, NULL));
    bad = outlines, bad.point_stride = 8;
    EXPECT(GUSSET_ERROR_BAD_STRIDE, fit(&bad, NULL));
    bad = outlines, bad.point_count = SIZE_MAX;
    EXPECT(GUSSET_ERROR_TOO_LARGE, fit(&bad, NULL));
    bad = outlines, bad.point_stride = SIZE_MAX / 2;
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, fit(&bad, NULL));
    bad = outlines, bad.outline_count = SIZE_MAX;
    EXPECT(GUSSET_ERROR_TOO_LARGE, fit(&bad, NULL));
    bad = outlines, bad.outline_count = 1;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, fit(&bad, NULL));
    bad = outlines, bad.constraint_count = 1;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, fit(&bad, NULL));
    bad = outlines, bad.constraint_count = SIZE_MAX;
    EXPECT(GUSSET_ERROR_TOO_LARGE, fit(&bad, NULL));
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, fit(&outlines, NULL));
    gusset_context_reset(context);
    EXPECT(GUSSET_OK, fit(&outlines, NULL));
    gusset_outline_destroy(NULL);
}

static void data(void) {
    double points[4][2];
    uint32_t offsets[3] = {0, 2, 4};
    gusset_constraint constraints[2] = {{1, GUSSET_CONSTRAINT_CORNER, {0, 0, 0}}, {3, GUSSET_CONSTRAINT_TANGENT, {1, 0, 0}}};
    gusset_outlines outlines = given(points, 4);
    gusset_error_report report;

    memset(&report, 0, sizeof report);
    report.struct_size = sizeof report;
    memcpy(points, square, sizeof points);
    outlines.offsets = offsets, outlines.outline_count = 2;
    outlines.constraints = constraints, outlines.constraint_count = 2;
    EXPECT(GUSSET_OK, fit(&outlines, NULL));
    offsets[0] = 1;
    EXPECT(GUSSET_ERROR_BAD_OFFSETS, fit(&outlines, NULL));
    offsets[0] = 0, offsets[1] = 5;
    EXPECT(GUSSET_ERROR_BAD_OFFSETS, fit(&outlines, NULL));
    offsets[1] = 4, offsets[2] = 3;
    EXPECT(GUSSET_ERROR_BAD_OFFSETS, fit(&outlines, NULL));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_OFFSET && report.index == 2);
    CHECK(strstr(gusset_context_get_message(context), "must not decrease") != NULL);
    offsets[1] = 2, offsets[2] = 4;
    constraints[0].kind = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, fit(&outlines, NULL));
    constraints[0].kind = GUSSET_CONSTRAINT_CORNER, constraints[1].point = 4;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, fit(&outlines, NULL));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_CONSTRAINT && report.index == 1);
    constraints[1].point = 1;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, fit(&outlines, NULL));
    constraints[1].point = 3, constraints[1].tangent[2] = NAN;
    EXPECT(GUSSET_ERROR_NOT_FINITE, fit(&outlines, NULL));
    constraints[1].tangent[2] = 0.0, constraints[1].kind = GUSSET_CONSTRAINT_TANGENT_ANGLE;
    constraints[1].tangent[0] = INFINITY;
    EXPECT(GUSSET_ERROR_NOT_FINITE, fit(&outlines, NULL));
    constraints[1].tangent[0] = 0.5, points[2][1] = INFINITY;
    EXPECT(GUSSET_ERROR_NOT_FINITE, fit(&outlines, NULL));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_POINT && report.index == 2 && report.value == INFINITY);
}

static void options(void) {
    const gusset_outlines outlines = given(square, 4);
    gusset_outline_options options;
    uint32_t *choices[] = {&options.curve, &options.method, &options.lock, &options.joint, &options.solver, &options.ends};
    double *numbers[] = {&options.parameter_limit, &options.repeat_tolerance, &options.corner_angle, &options.tolerance};
    size_t i;

    memset(&options, 0, sizeof options);
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, fit(&outlines, &options));
    options.struct_size = sizeof options;
    EXPECT(GUSSET_OK, fit(&outlines, &options));
    for (i = 0; i < sizeof choices / sizeof *choices; ++i) {
        *choices[i] = 77;
        EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, fit(&outlines, &options));
        *choices[i] = 0;
    }
    for (i = 0; i < sizeof numbers / sizeof *numbers; ++i) {
        *numbers[i] = -1.0;
        EXPECT(GUSSET_ERROR_OUT_OF_RANGE, fit(&outlines, &options));
        *numbers[i] = NAN;
        EXPECT(GUSSET_ERROR_OUT_OF_RANGE, fit(&outlines, &options));
        *numbers[i] = 0.0;
    }
    options.method = GUSSET_METHOD_ALPHA, options.alpha = 2.0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, fit(&outlines, &options));
    options.method = GUSSET_METHOD_BISECTOR;
    EXPECT(GUSSET_OK, fit(&outlines, &options));
    options.repeat_tolerance = 1.0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, fit(&outlines, &options));
    options.repeat_tolerance = 1e-300;
    EXPECT(GUSSET_OK, fit(&outlines, &options));
    options.history = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, fit(&outlines, &options));
    options.history = 1, options.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, fit(&outlines, &options));
}

static void results(void) {
    const uint32_t offsets[4] = {0, 4, 4, 5};
    const double points[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {9, 9}};
    char unaligned[1 + sizeof points];
    gusset_outlines outlines;
    gusset_outline_view parts;
    gusset_outline_report report;
    gusset_outline_history history = {0};
    double controls[4][3], section_parameters[4];
    uint8_t statuses[4];
    uint64_t steps = 9;
    gusset_outline *outline = NULL;
    gusset_curve *curve = NULL;
    gusset_curve_measures measures = measures_of(NULL, 0);
    size_t i;

    memcpy(unaligned + 1, points, sizeof points);
    outlines = given(unaligned + 1, 5);
    memset(&parts, 0, sizeof parts);
    memset(&report, 0, sizeof report);
    outlines.offsets = offsets, outlines.outline_count = 3;
    EXPECT(GUSSET_OK, gusset_outline_create(context, &outlines, NULL, &outline));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_outline_get_view(outline, &parts));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_outline_get_view(outline, NULL));
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_outline_get_view(NULL, &parts));
    EXPECT(GUSSET_OK, gusset_outline_get_view(outline, &parts));
    CHECK(parts.outline_count == 3 && parts.point_count == 5);
    CHECK(parts.starts[0] == 0 && parts.starts[1] == 0);
    /* A square: four quadratics, 9 control points, 5 ends. */
    CHECK(parts.starts[2] == 9 && parts.starts[3] == 5);
    for (i = 0; i < 5; ++i) {
        CHECK(parts.ends.data[i] == 2 * i);
    }
    for (i = 0; i < 4; ++i) {
        /* The middle of each section is its point, and the control point is beyond it. */
        const double *c = parts.controls + 6 * i;
        int k;
        CHECK(parts.statuses[i] == GUSSET_POINT_OK && parts.segments.data[i] == i);
        CHECK(fabs(parts.parameters[i] - 0.5) < 1e-15);
        for (k = 0; k < 2; ++k) {
            CHECK(fabs(0.25 * c[k] + 0.5 * c[3 + k] + 0.25 * c[6 + k] - square[i][k]) < 1e-15);
        }
        CHECK(c[2] == 0.0);
    }
    CHECK(parts.statuses[4] == GUSSET_POINT_MISSED);
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_outline_get_report(outline, 0, &report));
    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_outline_get_report(outline, 0, &report));
    CHECK(report.fit == GUSSET_FIT_OK && report.size == 1.0 && report.max_residual < 1e-15 && report.not_ok_count == 0);
    EXPECT(GUSSET_OK, gusset_outline_get_report(outline, 1, &report));
    CHECK(report.fit == GUSSET_FIT_TOO_FEW_POINTS && report.size == 0.0);
    EXPECT(GUSSET_OK, gusset_outline_get_report(outline, 2, &report));
    CHECK(report.fit == GUSSET_FIT_TOO_FEW_POINTS && report.not_ok_count == 1);
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_outline_get_report(outline, 3, &report));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_outline_get_report(NULL, 0, &report));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_outline_get_report(outline, 0, NULL));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_outline_get_history(outline, 0, &history));
    history.struct_size = sizeof history;
    EXPECT(GUSSET_OK, gusset_outline_get_history(outline, 0, &history));
    CHECK(history.cycle_count == 0 && history.control_count == 0);
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_outline_get_history(outline, 3, &history));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_outline_get_history(NULL, 0, &history));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_outline_get_history(outline, 0, NULL));
    EXPECT(GUSSET_OK, gusset_outline_curve_create(context, outline, 0, &curve));
    EXPECT(GUSSET_OK, gusset_curve_measure(context, curve, GUSSET_CURVE_MEASURE_LENGTH, &measures));
    CHECK(measures.length > 2.8 && measures.length < 4.5);
    gusset_curve_destroy(curve);
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_outline_curve_create(context, outline, 3, &curve));
    CHECK(curve == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_outline_curve_create(context, NULL, 0, &curve));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_outline_curve_create(context, outline, 0, NULL));
    gusset_outline_destroy(outline);

    outlines.point_count = 0, outlines.offsets = NULL, outlines.outline_count = 0, outlines.points = NULL;
    EXPECT(GUSSET_OK, gusset_outline_create(NULL, &outlines, NULL, &outline));
    EXPECT(GUSSET_OK, gusset_outline_get_view(outline, &parts));
    CHECK(parts.outline_count == 1 && parts.control_count == 0);
    gusset_outline_destroy(outline);

    outlines = given(square, 4);
    /* Options that no curve may have, sections may not have either. */
    for (int k = 0; k < 6; ++k) {
        gusset_outline_options wrong = {0};
        gusset_outline *none = NULL;
        wrong.struct_size = sizeof wrong;
        if (k == 0) wrong.parameter_limit = 0.6;
        if (k == 1) wrong.parameter_limit = NAN;
        if (k == 2) wrong.corner_angle = -1;
        if (k == 3) wrong.tolerance = -1;
        if (k == 4) wrong.tolerance = 1;
        if (k == 5) wrong.repeat_tolerance = 2;
        EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_outline_create(context, &outlines, &wrong, &none));
        steps = 9;
        EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_outlines_find_sections(context, &outlines, &wrong, NULL, NULL, NULL, &steps));
        CHECK(steps == 0);
    }
    EXPECT(GUSSET_OK, gusset_outlines_find_sections(context, &outlines, NULL, controls[0], section_parameters, statuses, &steps));
    CHECK(steps == 0);
    for (i = 0; i < 4; ++i) {
        /* P is half-way between the middle of the chord, which is the centre, and B. */
        CHECK(fabs(controls[i][0] - (2 * square[i][0] - 0.5)) < 1e-15);
        CHECK(fabs(controls[i][1] - (2 * square[i][1] - 0.5)) < 1e-15);
        CHECK(section_parameters[i] == 0.5 && statuses[i] == GUSSET_POINT_OK);
    }
}

static void frames(void) {
    /* Two squares, one above the other. */
    const double points[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const uint32_t offsets[3] = {0, 4, 8}, uneven[3] = {0, 3, 8}, landmarks[4] = {0, 2, 1, 3};
    const double middle[3] = {0, 0, 0.5}, up[3] = {0, 0, 2}, nothing[3] = {0, 0, 0}, nan[3] = {0, NAN, 0};
    const double axis[6] = {0.5, 0.5, 0, 0.5, 0.5, 1};
    gusset_outlines sections = given(points, 8);
    gusset_frame_options options;
    uint32_t missing = 99;
    gusset_outline_options curves;
    gusset_frame_view parts;
    gusset_curve_measures measures;
    gusset_frame *frame = (gusset_frame *)misaligned();
    gusset_outline *section = NULL;
    gusset_curve *curve = NULL;
    gusset_error_report report;

    memset(&report, 0, sizeof report);
    memset(&options, 0, sizeof options);
    memset(&curves, 0, sizeof curves);
    memset(&parts, 0, sizeof parts);
    report.struct_size = sizeof report;
    sections.dimension = 3, sections.offsets = offsets, sections.outline_count = 2;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_create(context, NULL, NULL, &frame));
    CHECK(frame == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_create(context, &sections, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_frame_create(context, &sections, misaligned(), &frame));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_frame_create(context, &sections, &options, &frame));
    options.struct_size = sizeof options, options.correspondence = 9;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_frame_create(context, &sections, &options, &frame));
    options.correspondence = GUSSET_CORRESPONDENCE_GIVEN, options.ring = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_frame_create(context, &sections, &options, &frame));
    options.ring = 1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_frame_create(context, &sections, &options, &frame));
    options.ring = 0, options.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_frame_create(context, &sections, &options, &frame));
    options.reserved = 0, options.given_starts = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_frame_create(context, &sections, &options, &frame));
    options.given_starts = 0, options.smooth_corners = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_frame_create(context, &sections, &options, &frame));
    options.smooth_corners = 0, options.across = &curves;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_frame_create(context, &sections, &options, &frame));
    curves.struct_size = sizeof curves, curves.curve = GUSSET_CURVE_KIND_CUBIC_C2;
    options.correspondence = GUSSET_CORRESPONDENCE_ARC_LENGTH, options.columns = UINT32_MAX;
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_frame_create(context, &sections, &options, &frame));
    options.columns = 0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_frame_create(context, &sections, &options, &frame));
    options.correspondence = GUSSET_CORRESPONDENCE_ANGLE, options.columns = 4;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_frame_create(context, &sections, &options, &frame));
    options.axis_direction[2] = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_frame_create(context, &sections, &options, &frame));
    options.axis_direction[2] = 1.0, options.reference[0] = 1.0, options.axis_point[0] = 9.0;
    EXPECT(GUSSET_ERROR_NO_NODE, gusset_frame_create(context, &sections, &options, &frame));
    options.axis_point[0] = NAN;
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_frame_create(context, &sections, &options, &frame));
    options.axis_points = axis, options.axis_point_count = 1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_frame_create(context, &sections, &options, &frame));
    options.axis_point_count = SIZE_MAX;
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_frame_create(context, &sections, &options, &frame));
    options.axis_points = NULL, options.axis_point_count = 2;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_create(context, &sections, &options, &frame));
    options.axis_points = axis;
    EXPECT(GUSSET_OK, gusset_frame_create(context, &sections, &options, &frame));
    gusset_frame_destroy(frame);
    options.axis_points = NULL, options.axis_point_count = 0;
    options.correspondence = GUSSET_CORRESPONDENCE_LANDMARKS, options.columns = 2;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_frame_create(context, &sections, &options, &frame));
    options.landmarks.count = 4;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_create(context, &sections, &options, &frame));
    options.landmarks.data = landmarks;
    EXPECT(GUSSET_OK, gusset_frame_create(context, &sections, &options, &frame));
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_frame_get_view(frame, &parts));
    CHECK(parts.rows == 2 && parts.columns == 4 && parts.max_gap < 1e-15);
    gusset_frame_destroy(frame);
    /* Points that are missing: of landmarks; that do not exist; in an end section. */
    options.missing.count = 1;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_create(context, &sections, &options, &frame));
    options.missing.data = &missing;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_frame_create(context, &sections, &options, &frame));
    options.correspondence = GUSSET_CORRESPONDENCE_GIVEN;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_frame_create(context, &sections, &options, &frame));
    missing = 6;
    EXPECT(GUSSET_ERROR_NO_NODE, gusset_frame_create(context, &sections, &options, &frame));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_SECTION && report.index == 1 && report.value == 2);
    sections.offsets = uneven;
    EXPECT(GUSSET_ERROR_SECTIONS_DIFFER, gusset_frame_create(context, &sections, NULL, &frame));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_SECTION && report.index == 1 && report.value == 5);
    sections.offsets = offsets;

    EXPECT(GUSSET_OK, gusset_frame_create(NULL, &sections, NULL, &frame));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_get_view(NULL, &parts));
    parts.struct_size = 4;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_frame_get_view(frame, &parts));
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_frame_get_view(frame, &parts));
    CHECK(parts.rows == 2 && parts.columns == 4 && memcmp(parts.nodes, points, sizeof points) == 0);
    CHECK(parts.along[2] == 1.0 && parts.turned[1] == 0 && parts.ambiguous.count == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_get_view(frame, NULL));
    /* The curves are the frame's, and stay with it. */
    gusset_outline_destroy((gusset_outline *)(size_t)parts.curves_across);
    gusset_outline_destroy((gusset_outline *)(size_t)parts.curves_along);
    measures = measures_of(parts.curves_across, 1);
    /* The square itself: four points are corners. */
    CHECK(measures.centre[2] == 1.0 && fabs(measures.area - 1.0) < 1e-15);
    measures = measures_of(parts.curves_along, 3);
    CHECK(measures.length == 1.0 && measures.area == 0.0);
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_outline_curve_create(context, parts.curves_along, 4, &curve));
    CHECK(curve == NULL);

    {
        const double by[8] = {1, 1, 1, 1, 1, NAN, 1, 1}, one = 0.25;
        gusset_frame *wider = (gusset_frame *)misaligned();
        EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_offset_create(context, NULL, &one, 1, 0, &wider));
        CHECK(wider == NULL);
        EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_offset_create(context, frame, NULL, 1, 0, &wider));
        EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_offset_create(context, frame, &one, 1, 0, NULL));
        EXPECT(GUSSET_ERROR_COUNT_DIFFERS, gusset_frame_offset_create(context, frame, NULL, 0, 0, &wider));
        EXPECT(GUSSET_ERROR_COUNT_DIFFERS, gusset_frame_offset_create(context, frame, by, 3, 0, &wider));
        EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_frame_offset_create(context, frame, &one, 1, 2, &wider));
        EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_frame_offset_create(context, frame, by, 8, 0, &wider));
        EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
        CHECK(report.element == GUSSET_ELEMENT_NODE && report.index == 5);
        EXPECT(GUSSET_OK, gusset_frame_offset_create(context, frame, &one, 1, GUSSET_OFFSET_NORMAL, &wider));
        gusset_frame_destroy(wider);
    }
    EXPECT(GUSSET_OK, gusset_frame_slice_create(context, frame, middle, up, &section));
    measures = measures_of(section, 0);
    CHECK(fabs(measures.centre[2] - 0.5) < 1e-15);
    gusset_outline_destroy(section);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_frame_slice_create(context, frame, middle, nothing, &section));
    CHECK(section == NULL);
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_frame_slice_create(context, frame, nan, up, &section));
    EXPECT(GUSSET_ERROR_NO_NODE, gusset_frame_slice_create(context, frame, up, up, &section));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_slice_create(context, NULL, middle, up, &section));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_slice_create(context, frame, NULL, up, &section));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_slice_create(context, frame, middle, NULL, &section));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_frame_slice_create(context, frame, middle, up, NULL));
    gusset_frame_destroy(frame);
    gusset_frame_destroy(NULL);
}

int main(void) {
    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    arguments();
    data();
    options();
    results();
    frames();
    gusset_context_destroy(context);
    return failures != 0;
}
