/* Calls functions of curves with invalid and valid arguments, and checks errors and results. */
#include "check.h"
#include <math.h>

static gusset_context *context;
/* y = x^2 from 0 to 1, then a line down. */
static const double points[8] = {0, 0, 0.5, 0, 1, 1, 1, 0};
static const uint32_t ends[3] = {0, 2, 3};

static gusset_curve *curve(void) {
    gusset_curve *made = NULL;
    EXPECT(GUSSET_OK, gusset_curve_create(context, points, 4, 2, ends, 3, 0, &made));
    return made;
}

static void creation(void) {
    gusset_curve *made = (gusset_curve *)misaligned();
    const uint32_t wrong[3] = {0, 2, 4};
    const double nan[4] = {0, 0, NAN, 0};
    const uint32_t one[2] = {0, 1};
    gusset_curve_view parts = {sizeof parts, NULL, 0, {NULL, 0}, 0, 0};

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_create(context, NULL, 4, 2, ends, 3, 0, &made));
    CHECK(made == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_create(context, points, 4, 2, NULL, 3, 0, &made));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_create(context, points, 4, 2, ends, 3, 0, NULL));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_create(context, points, 4, 4, ends, 3, 0, &made));
    EXPECT(GUSSET_ERROR_BAD_OFFSETS, gusset_curve_create(context, points, 4, 2, wrong, 3, 0, &made));
    EXPECT(GUSSET_ERROR_BAD_OFFSETS, gusset_curve_create(context, points, 4, 2, ends, 0, 0, &made));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_curve_create(context, points, 4, 2, ends, 3, 2, &made));
    EXPECT(GUSSET_ERROR_CURVE_NOT_CLOSED, gusset_curve_create(context, points, 4, 2, ends, 3, 1, &made));
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_curve_create(context, nan, 2, 2, one, 2, 0, &made));
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_curve_create(context, points, SIZE_MAX, 2, ends, 3, 0, &made));
    /* More ends than points: none is read. */
    EXPECT(GUSSET_ERROR_BAD_OFFSETS, gusset_curve_create(context, points, 4, 2, NULL, SIZE_MAX, 0, &made));
    CHECK(made == NULL);
    gusset_curve_destroy(NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_get_view(NULL, &parts));
    made = curve();
    EXPECT(GUSSET_OK, gusset_curve_get_view(made, &parts));
    CHECK(parts.control_count == 4 && parts.ends.count == 3 && parts.closed == 0 && parts.controls[6] == 1.0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_get_view(made, NULL));
    parts.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_curve_get_view(made, &parts));
    gusset_curve_destroy(made);
}

static void questions(void) {
    gusset_curve *given = curve();
    gusset_place places[2] = {{0, 0, 0.5}, {1, 0, 1.0}};
    gusset_place found[1];
    double out[18], length[1] = {0.5};
    const double queries[3] = {0.5, 0.25, 0};
    gusset_curve_nearest_point nearest;

    EXPECT(GUSSET_OK, gusset_curve_evaluate(context, given, places, 2, 2, out, NULL, NULL));
    CHECK(out[0] == 0.5 && out[1] == 0.25 && out[3] == 1.0 && out[7] == 2.0 && out[9] == 1.0 && out[16] == 0.0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_evaluate(context, NULL, places, 2, 2, out, NULL, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_evaluate(context, given, NULL, 2, 2, out, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_curve_evaluate(context, given, places, 2, 2, misaligned(), NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_curve_evaluate(context, given, places, 2, 2, NULL, misaligned(), NULL));
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_curve_evaluate(context, given, places, SIZE_MAX, 2, out, NULL, NULL));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_evaluate(context, given, places, 2, 65, out, NULL, NULL));
    EXPECT(GUSSET_OK, gusset_curve_evaluate(context, given, NULL, 0, 2, NULL, NULL, NULL));
    /* Nothing is written if anything fails, and nothing is computed that is not wanted. */
    out[0] = 9;
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_curve_evaluate(context, given, places, 2, 2, out, NULL, misaligned()));
    CHECK(out[0] == 9);
    EXPECT(GUSSET_OK, gusset_curve_evaluate(context, given, places, 2, 65, NULL, NULL, NULL));
    EXPECT(GUSSET_OK, gusset_curve_evaluate(context, given, places, 2, 0, NULL, out, out + 6));
    CHECK(fabs(out[0] - sqrt(0.5)) < 1e-15 && out[4] == -1.0);
    CHECK(fabs(out[6] - 2.0 / pow(2.0, 1.5)) < 1e-14 && out[7] == 0.0);
    EXPECT(GUSSET_OK, gusset_curve_lengths_at(context, given, places, 2, out));
    places[1].segment = 2;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_curve_evaluate(context, given, places, 2, 0, NULL, out, NULL));
    places[1].segment = 1, places[1].t = NAN;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_curve_evaluate(context, given, places, 2, 0, NULL, NULL, out));
    places[1].t = 0.0, places[1].reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_curve_lengths_at(context, given, places, 2, out));
    EXPECT(GUSSET_OK, gusset_curve_nearest(context, given, queries, 1, &nearest));
    CHECK(fabs(nearest.place.t - 0.5) < 1e-15 && nearest.distance < 1e-15);
    length[0] = NAN;
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_curve_nearest(context, given, (out[0] = out[1] = out[2] = NAN, out), 1, &nearest));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_places_at(context, given, length, 1, found));
    length[0] = 1e9;
    EXPECT(GUSSET_OK, gusset_curve_places_at(context, given, length, 1, found));
    CHECK(found[0].segment == 1 && found[0].t == 1.0);
    gusset_curve_destroy(given);
}

static void measures_of_curves(void) {
    const double knee[9] = {0, 0, 0, 1, 0, 0, 1, 0, 1};
    const uint32_t legs[3] = {0, 1, 2}, none[1] = {0};
    const uint32_t every = GUSSET_CURVE_MEASURE_LENGTH | GUSSET_CURVE_MEASURE_BOUNDS | GUSSET_CURVE_MEASURE_CENTRE |
                           GUSSET_CURVE_MEASURE_AREA | GUSSET_CURVE_MEASURE_MOMENTS;
    gusset_curve *given = curve(), *bent = NULL, *empty = NULL;
    gusset_curve_measures measures;

    memset(&measures, 0, sizeof measures);
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_curve_measure(context, given, 0, &measures));
    measures.struct_size = sizeof measures;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_measure(context, NULL, 0, &measures));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_measure(context, given, 0, NULL));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_curve_measure(context, given, every + 1, &measures));
    EXPECT(GUSSET_OK, gusset_curve_measure(context, given, 0, &measures));
    CHECK(measures.defined == every);
    CHECK(fabs(measures.length - (0.5 * sqrt(5.0) + 0.25 * asinh(2.0) + 1.0)) < 1e-14);
    CHECK(measures.low[0] == 0.0 && measures.high[0] == 1.0 && measures.high[1] == 1.0);
    CHECK(fabs(measures.area_vector[2] + 1.0 / 3.0) < 1e-15 && measures.area == -measures.area_vector[2]);
    CHECK(fabs(measures.centroid[0] - 0.75) < 1e-15 && measures.second[0] < 0.0);
    /* Measures that were not requested are 0. */
    EXPECT(GUSSET_OK, gusset_curve_measure(context, given, GUSSET_CURVE_MEASURE_BOUNDS, &measures));
    CHECK(measures.defined == GUSSET_CURVE_MEASURE_BOUNDS && measures.high[1] == 1.0 && measures.length == 0.0);
    /* A measure that the curve lacks is not an error. */
    EXPECT(GUSSET_OK, gusset_curve_create(context, knee, 3, 3, legs, 3, 0, &bent));
    EXPECT(GUSSET_OK, gusset_curve_measure(context, bent, 0, &measures));
    CHECK(measures.defined == every - GUSSET_CURVE_MEASURE_MOMENTS && measures.centroid[0] == 0.0);
    CHECK(measures.length == 2.0 && measures.area == 0.5 && measures.area_vector[1] == -0.5);
    CHECK(fabs(measures.centre[0] - 0.75) < 1e-15 && fabs(measures.centre[2] - 0.25) < 1e-15);
    EXPECT(GUSSET_OK, gusset_curve_measure(context, bent, GUSSET_CURVE_MEASURE_MOMENTS, &measures));
    CHECK(measures.defined == 0);
    EXPECT(GUSSET_OK, gusset_curve_create(context, NULL, 0, 2, none, 1, 0, &empty));
    EXPECT(GUSSET_OK, gusset_curve_measure(context, empty, 0, &measures));
    CHECK(measures.defined == (GUSSET_CURVE_MEASURE_LENGTH | GUSSET_CURVE_MEASURE_AREA) && measures.length == 0.0);
    /* It is cleared whatever fails. */
    measures.length = measures.second[2] = 9;
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_curve_measure(context, given, 0, &measures));
    gusset_context_reset(context);
    CHECK(measures.defined == 0 && measures.length == 0.0 && measures.second[2] == 0.0);
    gusset_curve_destroy(given);
    gusset_curve_destroy(bent);
    gusset_curve_destroy(empty);
}

static void made_of_curves(void) {
    gusset_curve *given = curve(), *made = NULL;
    const gusset_place from = {0, 0, 0.5}, to = {1, 0, 0.5}, end = {1, 0, 1}, wrong = {0, 7, 0.5};
    gusset_curve_view parts = {sizeof parts, NULL, 0, {NULL, 0}, 0, 0};
    double deviations[2];
    gusset_offset_options options = {sizeof options, 1e-6, 0, 0, 0};
    gusset_offset_report report = {sizeof report, 0, 0, 0, 0};

    EXPECT(GUSSET_OK, gusset_curve_part_create(context, given, from, to, &made));
    gusset_curve_destroy(made);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_part_create(context, given, to, from, &made));
    CHECK(made == NULL);
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_curve_part_create(context, given, wrong, to, &made));
    EXPECT(GUSSET_OK, gusset_curve_part_create(context, given, from, end, &made));
    EXPECT(GUSSET_OK, gusset_curve_get_view(made, &parts));
    CHECK(parts.ends.count == 3 && parts.controls[0] == 0.5 && parts.controls[1] == 0.25 && parts.controls[9] == 1.0);
    gusset_curve_destroy(made);
    EXPECT(GUSSET_OK, gusset_curve_reverse_create(context, given, &made));
    gusset_curve_destroy(made);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_change_degree_create(context, given, 65, 65, 0, NULL, &made));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_change_degree_create(context, given, 0, 64, 0, NULL, &made));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_change_degree_create(context, given, 3, 2, 0, NULL, &made));
    CHECK(made == NULL);
    EXPECT(GUSSET_OK, gusset_curve_change_degree_create(context, given, 3, 64, 0, NULL, &made));
    EXPECT(GUSSET_OK, gusset_curve_get_view(made, &parts));
    CHECK(parts.ends.data[1] == 3 && parts.ends.data[2] == 6);
    gusset_curve_destroy(made);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_change_degree_create(context, given, 1, 0, 1.0, NULL, &made));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_change_degree_create(context, given, 1, 1, NAN, NULL, &made));
    EXPECT(GUSSET_OK, gusset_curve_change_degree_create(context, given, 1, 1, 1.0, deviations, &made));
    CHECK(fabs(deviations[0] - 0.5) < 1e-14 && deviations[1] == 0.0);
    gusset_curve_destroy(made);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_offset_create(context, given, 0.1, NULL, NULL, &made));
    /* Outputs of a fixed size are cleared by every failure. */
    report.corners = 9;
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_curve_offset_create(context, given, 0.1, &options, &report, &made));
    gusset_context_reset(context);
    CHECK(made == NULL && report.corners == 0);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_offset_create(context, given, NAN, &options, NULL, &made));
    EXPECT(GUSSET_OK, gusset_curve_offset_create(context, given, 0.1, &options, &report, &made));
    CHECK(report.deviation <= 1e-6 && report.reached == 1 && report.tight == 0 && report.corners == 1);
    gusset_curve_destroy(made);
    options.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_curve_offset_create(context, given, 0.1, &options, NULL, &made));
    options.reserved = 0, options.degree = 4;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_offset_create(context, given, 0.1, &options, NULL, &made));
    options.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_curve_offset_create(context, given, 0.1, &options, NULL, &made));
    CHECK(made == NULL);
    gusset_curve_destroy(given);
}

static void found_on_curves(void) {
    gusset_curve *given = curve();
    gusset_places *places = NULL;
    gusset_places_view view;
    const double point[3] = {0.5, 0.5, 0}, along[3] = {1, 0, 0}, up[3] = {0, 1, 0}, zero[3] = {0, 0, 0};

    memset(&view, 0, sizeof view);
    view.struct_size = sizeof view;
    EXPECT(GUSSET_OK, gusset_curve_intersect_plane_create(context, given, point, up, &places));
    EXPECT(GUSSET_OK, gusset_places_get_view(places, &view));
    CHECK(view.count == 2 && view.others == NULL && view.inside.count == 0);
    CHECK(fabs(view.places[0].t - sqrt(0.5)) < 1e-15 && view.places[1].segment == 1 && view.points[3] == 1.0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_places_get_view(NULL, &view));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_places_get_view(places, NULL));
    gusset_places_destroy(places);
    gusset_places_destroy(NULL);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_intersect_plane_create(context, given, point, zero, &places));
    CHECK(places == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_intersect_plane_create(context, given, NULL, along, &places));
    EXPECT(GUSSET_OK, gusset_curve_intersect_plane_create(context, given, point, along, &places));
    gusset_places_destroy(places);
    EXPECT(GUSSET_OK, gusset_curve_intersect_create(context, given, given, 0.0, &places));
    EXPECT(GUSSET_OK, gusset_places_get_view(places, &view));
    CHECK(view.overlap_count == 2 && view.undecided == 0);
    gusset_places_destroy(places);
    EXPECT(GUSSET_OK, gusset_curve_intersect_create(context, given, NULL, 0.0, &places));
    EXPECT(GUSSET_OK, gusset_places_get_view(places, &view));
    CHECK(view.count == 0 && view.overlap_count == 0);
    gusset_places_destroy(places);
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_curve_sample_create(context, given, 3, 5, &places));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_sample_create(context, given, GUSSET_SAMPLE_COUNT, 2.5, &places));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_sample_create(context, given, GUSSET_SAMPLE_STEP, -1, &places));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_sample_create(context, given, GUSSET_SAMPLE_CHORD, NAN, &places));
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_curve_sample_create(context, given, GUSSET_SAMPLE_COUNT, 1e18, &places));
    EXPECT(GUSSET_OK, gusset_curve_sample_create(context, given, GUSSET_SAMPLE_COUNT, 5, &places));
    EXPECT(GUSSET_OK, gusset_places_get_view(places, &view));
    CHECK(view.count == 5 && view.places[4].t == 1.0);
    view.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_places_get_view(places, &view));
    gusset_places_destroy(places);
    gusset_curve_destroy(given);
}

static void forms(void) {
    gusset_curve *given = curve();
    gusset_curve_form *form = NULL;
    gusset_curve_form_view parts;

    memset(&parts, 0, sizeof parts);
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_curve_export_create(context, given, GUSSET_CURVE_FORMAT_SVG, NAN, &form));
    EXPECT(GUSSET_OK, gusset_curve_form_get_view(form, &parts));
    CHECK(strcmp(parts.text, "M 0 0 Q 0.5 0 1 1 L 1 0") == 0 && parts.text_length == 23 && parts.point_count == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_form_get_view(NULL, &parts));
    gusset_curve_form_destroy(form);
    EXPECT(GUSSET_ERROR_CURVE_NOT_CLOSED, gusset_curve_export_create(context, given, GUSSET_CURVE_FORMAT_CONTOUR, 0.0, &form));
    CHECK(form == NULL);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_export_create(context, given, GUSSET_CURVE_FORMAT_CONTOUR, NAN, &form));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_export_create(context, given, GUSSET_CURVE_FORMAT_SPLINE, 0.0, &form));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_curve_export_create(context, given, 3, 0.0, &form));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_export_create(context, NULL, GUSSET_CURVE_FORMAT_SVG, 0.0, &form));
    CHECK(form == NULL);
    gusset_curve_form_destroy(NULL);
    gusset_curve_destroy(given);
}

int main(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    if (gusset_context_create(&context) != GUSSET_OK || up.face_count != down.face_count) {
        return 1;
    }
    creation();
    questions();
    measures_of_curves();
    made_of_curves();
    found_on_curves();
    forms();
    gusset_context_destroy(context);
    return failures != 0;
}
