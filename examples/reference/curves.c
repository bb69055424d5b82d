/* Curves: outlines, sections, frames, and queries and operations of curves of Bezier segments. */
#include "example.h"

/* Points of a circle of radius 1 about (0, 0, height). */
static void circle(double (*points)[3], size_t count, double height) {
    size_t i;
    for (i = 0; i < count; ++i) {
        const double angle = 2.0 * pi * (double)i / (double)count;
        points[i][0] = cos(angle), points[i][1] = sin(angle), points[i][2] = height;
    }
}

//! [outline]
static gusset_curve *a_curve_through_points(void) {
    double points[12][3];
    gusset_outlines outlines = {.struct_size = sizeof outlines,
                                .points = points,
                                .point_stride = sizeof points[0],
                                .point_count = 12,
                                .dimension = 2,
                                .closed = 1};
    gusset_outline *outline = NULL;
    gusset_outline_view parts = {.struct_size = sizeof parts};
    gusset_outline_report report = {.struct_size = sizeof report};
    gusset_curve_measures measures = {.struct_size = sizeof measures};
    gusset_curve *curve = NULL;

    circle(points, 12, 0.0);
    MUST(gusset_outline_create(NULL, &outlines, NULL, &outline));
    MUST(gusset_outline_get_view(outline, &parts));
    HOLDS(parts.outline_count == 1 && parts.statuses[0] == GUSSET_POINT_OK);
    MUST(gusset_outline_get_report(outline, 0, &report));
    HOLDS(report.fit == GUSSET_FIT_OK && report.max_residual < 1e-12 && about(report.size, 2.0));
    /* A copy that outlives the outline. */
    MUST(gusset_outline_curve_create(NULL, outline, 0, &curve));
    gusset_outline_destroy(outline);
    MUST(gusset_curve_measure(NULL, curve, GUSSET_CURVE_MEASURE_LENGTH | GUSSET_CURVE_MEASURE_AREA, &measures));
    HOLDS(fabs(measures.length - 2.0 * pi) < 0.05 && fabs(measures.area - pi) < 0.05);
    return curve;
}
//! [outline]

//! [history]
static void the_cycles_of_the_paper(void) {
    const double points[4][2] = {{0, 0}, {0, 4}, {3, 5}, {5, 1}};
    const gusset_outlines outlines = {.struct_size = sizeof outlines, .points = points, .point_count = 4, .dimension = 2};
    const gusset_outline_options options = {.struct_size = sizeof options,
                                            .curve = GUSSET_CURVE_KIND_SINGLE,
                                            .lock = GUSSET_LOCK_DATA_GUIDE,
                                            .solver = GUSSET_SOLVER_STEP,
                                            .max_sweeps = 3,
                                            .history = 1};
    gusset_outline *outline = NULL;
    gusset_outline_history history = {.struct_size = sizeof history};

    MUST(gusset_outline_create(NULL, &outlines, &options, &outline));
    MUST(gusset_outline_get_history(outline, 0, &history));
    /* After each of three cycles, the four control points of a cubic. */
    HOLDS(history.cycle_count == 3 && history.control_count == 12 && history.cycles[0].control_end == 4);
    HOLDS(history.cycles[2].moved < history.cycles[1].moved);
    gusset_outline_destroy(outline);
}
//! [history]

//! [sections]
static void one_section_a_point(void) {
    const double points[3][2] = {{0, 0}, {1, 1}, {2, 0}};
    gusset_outlines outlines = {
        .struct_size = sizeof outlines, .points = points, .point_count = 3, .dimension = 2, .closed = 0};
    double controls[3][3], parameters[3];
    uint8_t statuses[3];

    MUST(gusset_outlines_find_sections(NULL, &outlines, NULL, controls[0], parameters, statuses, NULL));
    /* The quadratic (0, 0), (1, 2), (2, 0) passes (1, 1) half way. */
    HOLDS(statuses[1] == GUSSET_POINT_OK && about(controls[1][0], 1.0) && about(controls[1][1], 2.0));
    HOLDS(about(parameters[1], 0.5));
}
//! [sections]

//! [frame]
static void a_body_and_a_new_section(void) {
    double points[3 * 8][3];
    const uint32_t offsets[4] = {0, 8, 16, 24};
    const double middle[3] = {0, 0, 0.5}, upwards[3] = {0, 0, 1};
    gusset_outlines sections = {.struct_size = sizeof sections,
                                .points = points,
                                .point_count = 24,
                                .offsets = offsets,
                                .outline_count = 3,
                                .dimension = 3,
                                .closed = 1};
    gusset_frame *frame = NULL;
    gusset_frame_view parts = {.struct_size = sizeof parts};
    gusset_outline_view columns = {.struct_size = sizeof columns};
    gusset_outline *slice = NULL;
    gusset_curve *section = NULL;
    gusset_curve_measures measures = {.struct_size = sizeof measures};
    gusset_frame_options options = {.struct_size = sizeof options};
    const uint32_t lost = 8 + 3;
    int k;

    for (k = 0; k < 3; ++k) {
        circle(points + 8 * k, 8, k);
    }
    MUST(gusset_frame_create(NULL, &sections, NULL, &frame));
    MUST(gusset_frame_get_view(frame, &parts));
    HOLDS(parts.rows == 3 && parts.columns == 8);
    MUST(gusset_outline_get_view(parts.curves_along, &columns));
    HOLDS(columns.outline_count == 8);
    MUST(gusset_frame_slice_create(NULL, frame, middle, upwards, &slice));
    MUST(gusset_outline_curve_create(NULL, slice, 0, &section));
    MUST(gusset_curve_measure(NULL, section, 0, &measures));
    HOLDS(about(measures.centre[2], 0.5) && fabs(measures.length - 2.0 * pi) < 0.1);
    gusset_curve_destroy(section);
    gusset_outline_destroy(slice);
    gusset_frame_destroy(frame);

    /* A point that was not measured: it is filled along the body, half-way up as its section. */
    points[8 + 3][0] = points[8 + 3][1] = points[8 + 3][2] = NAN;
    options.missing = (gusset_indices){&lost, 1};
    MUST(gusset_frame_create(NULL, &sections, &options, &frame));
    MUST(gusset_frame_get_view(frame, &parts));
    HOLDS(parts.filled.count == 1 && parts.filled.data[0] == lost && about(parts.nodes[3 * lost + 2], 1.0));
    gusset_frame_destroy(frame);
}
//! [frame]

//! [frame_offset]
static void room_for_comfort(void) {
    double points[3 * 8][3];
    const uint32_t offsets[4] = {0, 8, 16, 24};
    /* Nothing at the first section, more at the others. */
    const double room[3] = {0.0, 0.25, 0.5};
    const gusset_outlines sections = {.struct_size = sizeof sections,
                                      .points = points,
                                      .point_count = 24,
                                      .offsets = offsets,
                                      .outline_count = 3,
                                      .dimension = 3,
                                      .closed = 1};
    gusset_frame *tube = NULL, *wider = NULL;
    gusset_frame_view parts = {.struct_size = sizeof parts};
    size_t k;

    for (k = 0; k < 3; ++k) {
        circle(points + 8 * k, 8, (int)k);
    }
    MUST(gusset_frame_create(NULL, &sections, NULL, &tube));
    MUST(gusset_frame_offset_create(NULL, tube, room, 3, GUSSET_OFFSET_IN_SECTION, &wider));
    MUST(gusset_frame_get_view(wider, &parts));
    for (k = 0; k < parts.rows * parts.columns; ++k) {
        const double *p = parts.nodes + 3 * k;
        HOLDS(about(hypot(p[0], p[1]), 1.0 + room[k / parts.columns]) && about(p[2], (double)(k / parts.columns)));
    }
    gusset_frame_destroy(wider);
    gusset_frame_destroy(tube);
}
//! [frame_offset]

//! [curve]
static gusset_curve *an_arch(void) {
    /* Two quadratic segments: control points 0 to 2, and 2 to 4. */
    const double points[5][2] = {{0, 0}, {0, 1}, {1, 1}, {2, 1}, {2, 0}};
    const uint32_t ends[3] = {0, 2, 4};
    gusset_curve *curve = NULL;
    gusset_curve_view parts = {.struct_size = sizeof parts};

    MUST(gusset_curve_create(NULL, points[0], 5, 2, ends, 3, 0, &curve));
    MUST(gusset_curve_get_view(curve, &parts));
    HOLDS(parts.control_count == 5 && parts.ends.count == 3 && parts.controls[5] == 0.0);
    return curve;
}
//! [curve]

//! [curve_ask]
static void what_curves_are(const gusset_curve *arch) {
    const gusset_place top = {.segment = 1, .t = 0.0};
    const double queries[2][3] = {{1, 3, 0}, {-1, 0, 0}};
    double derivatives[6], tangent[3], curvature, at, half;
    gusset_curve_nearest_point nearest[2];
    gusset_curve_measures measures = {.struct_size = sizeof measures};
    gusset_place place;

    /* The point (1, 1), and the first derivative there; direction and curvature. NULL for outputs that are not
       needed. */
    MUST(gusset_curve_evaluate(NULL, arch, &top, 1, 1, derivatives, tangent, &curvature));
    HOLDS(derivatives[0] == 1.0 && derivatives[1] == 1.0 && derivatives[3] == 2.0 && derivatives[4] == 0.0);
    HOLDS(about(tangent[0], 1.0) && about(curvature, -0.5)); /* it turns to the right */
    MUST(gusset_curve_nearest(NULL, arch, queries[0], 2, nearest));
    HOLDS(about(nearest[0].distance, 2.0) && about(nearest[1].distance, 1.0));
    MUST(gusset_curve_measure(NULL, arch, 0, &measures));
    HOLDS(about(measures.low[0], 0.0) && about(measures.high[0], 2.0) && about(measures.high[1], 1.0));
    HOLDS((measures.defined & GUSSET_CURVE_MEASURE_MOMENTS) != 0); /* it is plane */
    /* Run through clockwise, so that the area is negative: two parts of 5/6. */
    HOLDS(about(measures.area_vector[2], -5.0 / 3.0) && about(measures.centroid[0], 1.0));
    MUST(gusset_curve_lengths_at(NULL, arch, &top, 1, &at));
    half = 0.5 * measures.length;
    MUST(gusset_curve_places_at(NULL, arch, &half, 1, &place));
    HOLDS(about(at, half) && about(place.segment + place.t, 1.0));
}
//! [curve_ask]

//! [curve_find]
static void places_on_curves(const gusset_curve *arch, const gusset_curve *round) {
    const double origin[3] = {1, 0, 0}, east[3] = {1, 0, 0}, start[3] = {0, 0.5, 0}, north[3] = {0, 1, 0};
    gusset_places *places = NULL;
    gusset_places_view view = {.struct_size = sizeof view};

    MUST(gusset_curve_intersect_plane_create(NULL, arch, origin, east, &places));
    MUST(gusset_places_get_view(places, &view));
    HOLDS(view.count == 1 && about(view.points[1], 1.0));
    gusset_places_destroy(places);

    /* The line y = 0.5 of the plane is in the plane across y. */
    MUST(gusset_curve_intersect_plane_create(NULL, arch, start, north, &places));
    MUST(gusset_places_get_view(places, &view));
    HOLDS(view.count == 2 && about(view.points[0] + view.points[3], 2.0));
    gusset_places_destroy(places);

    MUST(gusset_curve_intersect_create(NULL, arch, round, 0.0, &places));
    MUST(gusset_places_get_view(places, &view));
    HOLDS(view.count == 1 && view.others != NULL && view.undecided == 0);
    gusset_places_destroy(places);

    /* Where it rises or falls at half a right angle. */
    MUST(gusset_curve_tangent_angle_create(NULL, arch, east, 0.25 * pi, &places));
    MUST(gusset_places_get_view(places, &view));
    HOLDS(view.count == 2 && about(view.places[0].t, 0.5) && about(view.points[3], 1.75));
    gusset_places_destroy(places);

    MUST(gusset_curve_sample_create(NULL, arch, GUSSET_SAMPLE_COUNT, 9.0, &places));
    MUST(gusset_places_get_view(places, &view));
    HOLDS(view.count == 9 && about(view.points[3 * 4], 1.0));
    gusset_places_destroy(places);
}
//! [curve_find]

//! [curve_make]
static void curves_of_curves(const gusset_curve *arch) {
    const gusset_place from = {.segment = 0, .t = 0.5}, to = {.segment = 1, .t = 0.5};
    gusset_offset_options options = {.struct_size = sizeof options, .tolerance = 1e-6};
    gusset_offset_report report = {.struct_size = sizeof report};
    gusset_curve_view parts = {.struct_size = sizeof parts};
    gusset_curve *made = NULL;
    double deviations[2];

    MUST(gusset_curve_part_create(NULL, arch, from, to, &made));
    MUST(gusset_curve_get_view(made, &parts));
    HOLDS(about(parts.controls[0], 0.25) && about(parts.controls[3 * (parts.control_count - 1)], 1.75));
    gusset_curve_destroy(made);
    MUST(gusset_curve_reverse_create(NULL, arch, &made));
    MUST(gusset_curve_get_view(made, &parts));
    HOLDS(parts.controls[0] == 2.0);
    gusset_curve_destroy(made);

    MUST(gusset_curve_change_degree_create(NULL, arch, 3, 64, 0.0, NULL, &made));
    MUST(gusset_curve_get_view(made, &parts));
    HOLDS(parts.control_count == 7); /* cubics */
    gusset_curve_destroy(made);
    MUST(gusset_curve_change_degree_create(NULL, arch, 1, 1, INFINITY, deviations, &made));
    MUST(gusset_curve_get_view(made, &parts));
    HOLDS(parts.control_count == 3 && deviations[0] > 0.1); /* straight */
    gusset_curve_destroy(made);

    MUST(gusset_curve_offset_create(NULL, arch, 0.25, &options, &report, &made));
    HOLDS(report.reached == 1 && report.deviation <= 1e-6 && report.tight == 0);
    gusset_curve_destroy(made);
}
//! [curve_make]

//! [curve_export]
static void other_forms(const gusset_curve *arch, const gusset_curve *round) {
    gusset_curve_form *form = NULL;
    gusset_curve_form_view view = {.struct_size = sizeof view};

    MUST(gusset_curve_export_create(NULL, arch, GUSSET_CURVE_FORMAT_SVG, 0.0, &form));
    MUST(gusset_curve_form_get_view(form, &view));
    HOLDS(view.text[0] == 'M' && strlen(view.text) == view.text_length);
    gusset_curve_form_destroy(form);

    MUST(gusset_curve_export_create(NULL, round, GUSSET_CURVE_FORMAT_CONTOUR, 0.0, &form));
    MUST(gusset_curve_form_get_view(form, &view));
    HOLDS(view.point_count > 0 && view.on_curve != NULL);
    gusset_curve_form_destroy(form);

    MUST(gusset_curve_export_create(NULL, arch, GUSSET_CURVE_FORMAT_SPLINE, 0.0, &form));
    MUST(gusset_curve_form_get_view(form, &view));
    HOLDS(view.degree == 2 && view.knot_count == view.point_count + 3);
    gusset_curve_form_destroy(form);
}
//! [curve_export]

//! [surface_curve]
static void curves_in_space(void) {
    const double bow[5][3] = {{0, 0, 0}, {1, 1, 0}, {2, 1.3, 0}, {3, 1, 0}, {4, 0, 0}};
    const double bar[5][3] = {{2, -1, 1}, {2, 0, 1}, {2, 1, 1}, {2, 2, 1}, {2, 3, 1}};
    const gusset_line line = {.origin = {2, 0, 1}, .direction = {0, 1, 0}, .from = -INFINITY, .to = INFINITY};
    gusset_curve *one = NULL, *other = NULL;
    gusset_places *places = NULL;
    gusset_places_view view = {.struct_size = sizeof view};

    MUST(gusset_curve_through_create(NULL, bow[0], 5, 0, GUSSET_SCHEME_SIX_TAP, &one));
    MUST(gusset_curve_through_create(NULL, bar[0], 5, 0, GUSSET_SCHEME_SIX_TAP, &other));
    MUST(gusset_curve_intersect_create(NULL, one, other, 1.001, &places));
    MUST(gusset_places_get_view(places, &view));
    HOLDS(view.count == 1 && about(view.points[0], 2.0)); /* one above the other */
    gusset_places_destroy(places);
    MUST(gusset_curve_intersect_line_create(NULL, one, &line, 1.001, &places));
    MUST(gusset_places_get_view(places, &view));
    HOLDS(view.count == 1 && about(view.others[0].t, view.points[1]));
    gusset_places_destroy(places);
    gusset_curve_destroy(other);
    gusset_curve_destroy(one);
}
//! [surface_curve]

int main(void) {
    gusset_curve *round = a_curve_through_points(), *arch = an_arch();
    the_cycles_of_the_paper();
    one_section_a_point();
    a_body_and_a_new_section();
    room_for_comfort();
    what_curves_are(arch);
    places_on_curves(arch, round);
    curves_of_curves(arch);
    other_forms(arch, round);
    curves_in_space();
    gusset_curve_destroy(arch);
    gusset_curve_destroy(round);
    return 0;
}
