/* Intersects lines and curves with surfaces by invalid and valid arguments, and checks errors and results. */
#include "check.h"
#include <math.h>

static gusset_context *context;

/* z = x y over -1..1, 5 x 5 nodes: the cells are bilinear, the surface is exact. */
static gusset_sheet *sheet(void) {
    static double nodes[5][5][3];
    gusset_nodes given;
    gusset_sheet *made = NULL;
    int i, j;
    for (i = 0; i < 5; ++i)
        for (j = 0; j < 5; ++j) {
            nodes[i][j][0] = 0.5 * i - 1.0;
            nodes[i][j][1] = 0.5 * j - 1.0;
            nodes[i][j][2] = nodes[i][j][0] * nodes[i][j][1];
        }
    memset(&given, 0, sizeof given);
    given.struct_size = sizeof given;
    given.nodes = nodes;
    given.rows = given.columns = 5;
    given.scalar = GUSSET_F64;
    EXPECT(GUSSET_OK, gusset_sheet_create(context, &given, NULL, 0, &made));
    return made;
}

static gusset_surface *saddle(void) {
    gusset_sheet *only = sheet();
    gusset_surface *made = NULL;
    const gusset_sheet *sheets[1];
    sheets[0] = only;
    EXPECT(GUSSET_OK, gusset_surface_create(context, sheets, 1, NULL, &made));
    gusset_sheet_destroy(only);
    return made;
}

static int near(double a, double b) {
    return fabs(a - b) < 1e-9;
}

static const gusset_line down = {{0.3, 0.4, 2.0}, {0, 0, -1}, -INFINITY, INFINITY};
static const gusset_line past = {{3.0, 0.4, 2.0}, {0, 0, -1}, -INFINITY, INFINITY};
static const gusset_line inside = {{0.0, 0.25, 0.0}, {2, 0, 0.5}, -INFINITY, INFINITY};
static const gusset_line up = {{0.3, 0.4, 0.5}, {0, 0, 1}, 0, INFINITY};

static void many_lines(void) {
    gusset_surface *surface = saddle();
    gusset_line lines[4];
    gusset_surface_hits *hits = (gusset_surface_hits *)misaligned();
    gusset_surface_hits_view parts;
    gusset_error_report report;
    memset(&parts, 0, sizeof parts);
    parts.struct_size = sizeof parts;
    lines[0] = down;
    lines[1] = past;
    lines[2] = inside;
    lines[3] = up;
    lines[0].origin[0] = -1e300;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_hits_create(context, surface, lines, 4, NULL, GUSSET_HITS_ALL, &hits));
    CHECK(strstr(gusset_context_get_message(context), ": -1e300") != NULL);
    lines[0] = down;

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_hits_create(context, NULL, lines, 4, NULL, GUSSET_HITS_ALL, &hits));
    CHECK(hits == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_hits_create(context, surface, NULL, 4, NULL, GUSSET_HITS_ALL, &hits));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_hits_create(context, surface, lines, 4, NULL, GUSSET_HITS_ALL, NULL));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_hits_create(context, surface, lines, 4, NULL, 3, &hits));
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_surface_hits_create(context, surface, lines, SIZE_MAX, NULL, GUSSET_HITS_ALL, &hits));
    lines[2].direction[0] = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_hits_create(context, surface, lines, 4, NULL, GUSSET_HITS_ALL, &hits));
    memset(&report, 0, sizeof report);
    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_ITEM && report.index == 2);
    lines[2] = inside;
    memset(lines[1].direction, 0, sizeof lines[1].direction);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_hits_create(context, surface, lines, 4, NULL, GUSSET_HITS_ALL, &hits));
    lines[1] = past;
    lines[0].from = 1;
    lines[0].to = 0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_hits_create(context, surface, lines, 4, NULL, GUSSET_HITS_ALL, &hits));
    CHECK(hits == NULL);
    lines[0] = down;

    EXPECT(GUSSET_OK, gusset_surface_hits_create(context, surface, lines, 4, NULL, GUSSET_HITS_ALL, &hits));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_hits_get_view(NULL, &parts));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_hits_get_view(hits, NULL));
    parts.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_hits_get_view(hits, &parts));
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_surface_hits_get_view(hits, &parts));
    CHECK(parts.query_count == 4 && parts.hit_count == 2 && parts.on_curve == NULL && parts.on_curve_count == 0);
    CHECK(parts.ends[0] == 0 && parts.ends[1] == 1 && parts.ends[2] == 1 && parts.ends[3] == 2 && parts.ends[4] == 2);
    if (parts.hit_count == 2) {
        const gusset_surface_hit *hit = parts.hits;
        CHECK(hit->kind == GUSSET_HIT_CROSSING && near(hit->t, 2.0 - 0.12) && near(hit->point[2], 0.12));
        CHECK(near(hit->span[0], hit->t) && near(hit->span[1], hit->t) && hit->reserved == 0);
        CHECK(near(hit->normal[0] * hit->normal[0] + hit->normal[1] * hit->normal[1] + hit->normal[2] * hit->normal[2], 1));
        CHECK(hit->place.sheet == 0 && hit->place.row == 2 && hit->place.column == 2);
        CHECK(near(hit->place.row + hit->place.u, 2.6) && near(hit->place.column + hit->place.v, 2.8));
        ++hit;
        CHECK(hit->kind == GUSSET_HIT_INSIDE && fabs(hit->span[0] + 0.5) < 0.05 && fabs(hit->span[1] - 0.5) < 0.05);
    }
    gusset_surface_hits_destroy(hits);
    EXPECT(GUSSET_OK, gusset_surface_hits_create(NULL, surface, lines, 4, NULL, GUSSET_HITS_ANY, &hits));
    gusset_surface_hits_destroy(hits);
    EXPECT(GUSSET_OK, gusset_surface_hits_create(context, surface, NULL, 0, NULL, GUSSET_HITS_ALL, &hits));
    EXPECT(GUSSET_OK, gusset_surface_hits_get_view(hits, &parts));
    CHECK(parts.query_count == 0 && parts.hit_count == 0 && parts.ends[0] == 0);
    gusset_surface_hits_destroy(hits);
    gusset_surface_hits_destroy(NULL);
    gusset_surface_destroy(surface);
}

static void first_hits(void) {
    gusset_surface *surface = saddle();
    gusset_line lines[3];
    gusset_surface_hit hits[3];
    memset(hits, 255, sizeof hits);
    lines[0] = down;
    lines[1] = past;
    lines[2] = up;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_first_hits(context, NULL, lines, 3, hits));
    CHECK(hits[0].kind == GUSSET_HIT_NONE && hits[2].t == 0.0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_first_hits(context, surface, NULL, 3, hits));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_first_hits(context, surface, lines, 3, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_surface_first_hits(context, surface, lines, 3, (gusset_surface_hit *)misaligned()));
    EXPECT(GUSSET_OK, gusset_surface_first_hits(context, surface, lines, 3, hits));
    CHECK(hits[0].kind == GUSSET_HIT_CROSSING && near(hits[0].t, 1.88));
    CHECK(hits[1].kind == GUSSET_HIT_NONE && hits[2].kind == GUSSET_HIT_NONE);
    lines[1].origin[2] = INFINITY;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_first_hits(context, surface, lines, 3, hits));
    CHECK(hits[0].kind == GUSSET_HIT_NONE && hits[0].t == 0.0);
    EXPECT(GUSSET_OK, gusset_surface_first_hits(context, surface, NULL, 0, NULL));
    gusset_surface_destroy(surface);
}

static void curve(void) {
    gusset_surface *surface = saddle();
    /* A polyline through the surface and back, and a curve of too high a degree. */
    const double points[9] = {0.3, 0.4, 2, 0.3, 0.4, -2, -0.3, 0.4, 2};
    const uint32_t ends[3] = {0, 1, 2};
    double many[27];
    const uint32_t one[2] = {0, 8};
    gusset_curve *given = NULL, *high = NULL, *empty = NULL;
    gusset_surface_hits *hits = (gusset_surface_hits *)misaligned();
    gusset_surface_hits_view parts;
    int k;
    memset(&parts, 0, sizeof parts);
    parts.struct_size = sizeof parts;
    for (k = 0; k < 27; ++k)
        many[k] = k * k;
    EXPECT(GUSSET_OK, gusset_curve_create(context, points, 3, 3, ends, 3, 0, &given));
    EXPECT(GUSSET_OK, gusset_curve_create(context, many, 9, 3, one, 2, 0, &high));
    EXPECT(GUSSET_OK, gusset_curve_create(context, points, 1, 3, ends, 1, 0, &empty));

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_hits_create(context, NULL, NULL, 0, given, GUSSET_HITS_ALL, &hits));
    CHECK(hits == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_hits_create(context, surface, NULL, 0, given, GUSSET_HITS_ALL, NULL));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_hits_create(context, surface, NULL, 0, given, 9, &hits));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_hits_create(context, surface, NULL, 0, high, GUSSET_HITS_ALL, &hits));
    EXPECT(GUSSET_ERROR_EMPTY_CURVE, gusset_surface_hits_create(context, surface, NULL, 0, empty, GUSSET_HITS_ALL, &hits));
    EXPECT(GUSSET_OK, gusset_surface_hits_create(context, surface, NULL, 0, given, GUSSET_HITS_ALL, &hits));
    EXPECT(GUSSET_OK, gusset_surface_hits_get_view(hits, &parts));
    CHECK(parts.query_count == 1 && parts.hit_count == 2 && parts.ends[1] == 2 && parts.on_curve_count == 6);
    if (parts.hit_count == 2) {
        CHECK(near(parts.hits[0].t, 0.47) && parts.hits[1].t > 1.0 && parts.hits[1].t < 2.0);
        CHECK(parts.on_curve[0].segment == 0 && near(parts.on_curve[0].t, 0.47) && parts.on_curve[3].segment == 1);
        CHECK(parts.hits[0].kind == GUSSET_HIT_CROSSING && near(parts.hits[0].point[2], 0.12));
    }
    gusset_surface_hits_destroy(hits);
    /* The curve comes after the lines. */
    EXPECT(GUSSET_OK, gusset_surface_hits_create(context, surface, &down, 1, given, GUSSET_HITS_ALL, &hits));
    EXPECT(GUSSET_OK, gusset_surface_hits_get_view(hits, &parts));
    CHECK(parts.query_count == 2 && parts.ends[1] == 1 && parts.ends[2] == 3 && parts.on_curve_count == 6);
    if (parts.hit_count == 3)
        CHECK(near(parts.hits[0].t, 1.88) && near(parts.hits[1].t, 0.47) && near(parts.on_curve[0].t, 0.47));
    gusset_surface_hits_destroy(hits);
    gusset_curve_destroy(given);
    gusset_curve_destroy(high);
    gusset_curve_destroy(empty);
    gusset_surface_destroy(surface);
}

static void made_curves(void) {
    gusset_sheet *given = sheet();
    gusset_curve *made = (gusset_curve *)misaligned();
    double nodes[15] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5, 0, 0, 0};
    gusset_curve_view parts;
    memset(&parts, 0, sizeof parts);
    parts.struct_size = sizeof parts;

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_through_create(context, NULL, 5, 0, GUSSET_SCHEME_SIX_TAP, &made));
    CHECK(made == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_through_create(context, nodes, 5, 0, GUSSET_SCHEME_SIX_TAP, NULL));
    EXPECT(GUSSET_ERROR_NET_TOO_SMALL, gusset_curve_through_create(context, nodes, 1, 0, GUSSET_SCHEME_SIX_TAP, &made));
    EXPECT(GUSSET_ERROR_NET_TOO_SMALL, gusset_curve_through_create(context, nodes, 3, 1, GUSSET_SCHEME_SIX_TAP, &made));
    EXPECT(GUSSET_ERROR_CURVE_NOT_CLOSED, gusset_curve_through_create(context, nodes, 4, 1, GUSSET_SCHEME_SIX_TAP, &made));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_curve_through_create(context, nodes, 5, 1, 2, &made));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_curve_through_create(context, nodes, 5, 2, GUSSET_SCHEME_SIX_TAP, &made));
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_curve_through_create(context, nodes, SIZE_MAX / 8, 0, 0, &made));
    nodes[7] = NAN;
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_curve_through_create(context, nodes, 5, 1, GUSSET_SCHEME_SIX_TAP, &made));
    nodes[7] = 1;
    CHECK(made == NULL);
    EXPECT(GUSSET_OK, gusset_curve_through_create(context, nodes, 5, 1, GUSSET_SCHEME_FOUR_POINT, &made));
    EXPECT(GUSSET_OK, gusset_curve_get_view(made, &parts));
    CHECK(parts.control_count == 13 && parts.ends.count == 5 && parts.closed == 1 && parts.controls[9] == 1.0);
    gusset_curve_destroy(made);

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_curve_create(context, NULL, GUSSET_ALONG_ROWS, 1.0, &made));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_curve_create(context, given, GUSSET_ALONG_ROWS, 1.0, NULL));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_curve_create(context, given, 2, 1.0, &made));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_curve_create(context, given, GUSSET_ALONG_ROWS, 4.5, &made));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_curve_create(context, given, GUSSET_ALONG_COLUMNS, NAN, &made));
    CHECK(made == NULL);
    EXPECT(GUSSET_OK, gusset_sheet_curve_create(context, given, GUSSET_ALONG_ROWS, 1.0, &made));
    EXPECT(GUSSET_OK, gusset_curve_get_view(made, &parts));
    CHECK(parts.ends.count == 5 && near(parts.controls[0], -0.5) && near(parts.controls[1], -1) && near(parts.controls[2], 0.5));
    gusset_curve_destroy(made);
    EXPECT(GUSSET_OK, gusset_sheet_curve_create(context, given, GUSSET_ALONG_COLUMNS, 2.5, &made));
    EXPECT(GUSSET_OK, gusset_curve_get_view(made, &parts));
    CHECK(near(parts.controls[0], -1) && near(parts.controls[1], 0.25));
    gusset_curve_destroy(made);
    gusset_sheet_destroy(given);
}

static void approaches(void) {
    /* Two lines that pass at a distance of 0.1, and their middle points. */
    const double a[6] = {-1, 0, 0, 1, 0, 0}, b[6] = {0, -1, 0.1, 0, 1, 0.1};
    const uint32_t ends[2] = {0, 1};
    gusset_curve *one = NULL, *two = NULL;
    gusset_places *places = (gusset_places *)misaligned();
    gusset_places_view view;
    gusset_line line = {{0, -3, 0.1}, {0, 2, 0}, -INFINITY, INFINITY};
    memset(&view, 0, sizeof view);
    view.struct_size = sizeof view;
    EXPECT(GUSSET_OK, gusset_curve_create(context, a, 2, 3, ends, 2, 0, &one));
    EXPECT(GUSSET_OK, gusset_curve_create(context, b, 2, 3, ends, 2, 0, &two));

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_intersect_create(context, NULL, two, 0.2, &places));
    CHECK(places == NULL);
    /* A curve with itself: in the plane alone, and without a distance. */
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_intersect_create(context, one, NULL, 0.2, &places));
    EXPECT(GUSSET_ERROR_CURVE_NOT_PLANE, gusset_curve_intersect_create(context, two, NULL, 0.0, &places));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_intersect_create(context, one, two, NAN, &places));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_intersect_create(context, one, two, 0.2, NULL));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_intersect_create(context, one, two, -0.2, &places));
    EXPECT(GUSSET_OK, gusset_curve_intersect_create(context, one, two, 0.2, &places));
    EXPECT(GUSSET_OK, gusset_places_get_view(places, &view));
    CHECK(view.count == 1 && view.overlap_count == 0 && view.undecided == 0);
    if (view.count == 1)
        CHECK(near(view.places[0].t, 0.5) && near(view.others[0].t, 0.5) && near(view.points[0], 0));
    gusset_places_destroy(places);
    EXPECT(GUSSET_OK, gusset_curve_intersect_create(context, one, two, 0.05, &places));
    EXPECT(GUSSET_OK, gusset_places_get_view(places, &view));
    CHECK(view.count == 0);
    gusset_places_destroy(places);
    /* Curves in space, without a distance: they pass each other. */
    EXPECT(GUSSET_OK, gusset_curve_intersect_create(context, one, two, 0.0, &places));
    EXPECT(GUSSET_OK, gusset_places_get_view(places, &view));
    CHECK(view.count == 0);
    gusset_places_destroy(places);

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_intersect_line_create(context, NULL, &line, 0.2, &places));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_intersect_line_create(context, one, NULL, 0.2, &places));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_intersect_line_create(context, one, &line, 0.2, NULL));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_intersect_line_create(context, one, &line, NAN, &places));
    EXPECT(GUSSET_OK, gusset_curve_intersect_line_create(context, one, &line, 0.2, &places));
    EXPECT(GUSSET_OK, gusset_places_get_view(places, &view));
    CHECK(view.count == 1);
    if (view.count == 1)
        CHECK(near(view.places[0].t, 0.5) && near(view.others[0].t, 1.5));
    gusset_places_destroy(places);
    EXPECT(GUSSET_OK, gusset_curve_intersect_line_create(context, two, &line, 0.0, &places));
    EXPECT(GUSSET_OK, gusset_places_get_view(places, &view));
    CHECK(view.overlap_count == 1);
    gusset_places_destroy(places);
    line.origin[2] = 0;
    EXPECT(GUSSET_OK, gusset_curve_intersect_line_create(context, one, &line, 0.0, &places));
    EXPECT(GUSSET_OK, gusset_places_get_view(places, &view));
    CHECK(view.count == 1);
    if (view.count == 1)
        CHECK(near(view.places[0].t, 0.5) && near(view.others[0].t, 1.5));
    gusset_places_destroy(places);
    line.direction[1] = 0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_intersect_line_create(context, one, &line, 0.2, &places));
    CHECK(places == NULL);
    gusset_curve_destroy(one);
    gusset_curve_destroy(two);
}

int main(void) {
    EXPECT(GUSSET_OK, gusset_context_create(&context));
    many_lines();
    first_hits();
    curve();
    made_curves();
    approaches();
    gusset_context_destroy(context);
    return failures != 0;
}
