/* Smooth surfaces: sheets, surfaces, and queries. */
#include "example.h"

enum { ROWS = 9, COLUMNS = 13 };

/* Nodes of a tube of radius 1 about the z axis, closed round, from z = 0 to 4. */
static gusset_sheet *tube(void) {
    double points[ROWS][COLUMNS][3];
    gusset_nodes nodes = {.struct_size = sizeof nodes,
                          .nodes = points,
                          .rows = ROWS,
                          .columns = COLUMNS,
                          .scalar = GUSSET_F64,
                          .scheme = GUSSET_SCHEME_SIX_TAP,
                          .closed_v = 1};
    gusset_sheet *sheet = NULL;
    int i, j;
    for (i = 0; i < ROWS; ++i) {
        for (j = 0; j < COLUMNS; ++j) {
            const double angle = 2.0 * pi * (j % (COLUMNS - 1)) / (COLUMNS - 1);
            points[i][j][0] = cos(angle), points[i][j][1] = sin(angle), points[i][j][2] = 0.5 * i;
        }
    }
    MUST(gusset_sheet_create(NULL, &nodes, NULL, 0, &sheet));
    return sheet;
}

/* The flat surface z = height from -2 to 2, as one Bezier patch. */
static gusset_sheet *table(double height) {
    const double points[4][3] = {{-2, -2, height}, {-2, 2, height}, {2, -2, height}, {2, 2, height}};
    gusset_sheet *sheet = NULL;
    MUST(gusset_sheet_from_patches_create(NULL, points[0], 1, 1, 1, 1, &sheet));
    return sheet;
}

//! [surface]
static gusset_surface *indexed(const gusset_sheet *sheet) {
    const gusset_surface_options options = {.struct_size = sizeof options, .tolerance = 1e-9};
    gusset_surface *surface = NULL;

    MUST(gusset_surface_create(NULL, &sheet, 1, &options, &surface));
    return surface; /* it keeps what it needs: the sheet may be destroyed */
}

/* Results stay valid when their surface is destroyed. */
static void found_and_kept(const gusset_sheet *sheet) {
    const double query[3] = {2, 0, 1};
    gusset_surface *surface = indexed(sheet);
    gusset_surface_cells *region = NULL;
    gusset_surface_paths *paths = NULL;
    gusset_surface_cells_view cells = {.struct_size = sizeof cells};
    const gusset_contour_function height = {.struct_size = sizeof height, .direction = {0, 0, 1}};
    const double level = 1.1;

    MUST(gusset_surface_region_create(NULL, surface, query, 1.1, &region));
    MUST(gusset_surface_contours_create(NULL, surface, &height, &level, 1, NULL, &paths));
    gusset_surface_destroy(surface);
    MUST(gusset_surface_cells_get_view(region, &cells));
    HOLDS(cells.cell_count > 0 && cells.others == NULL);
    gusset_surface_paths_destroy(paths);
    gusset_surface_cells_destroy(region);
}
//! [surface]

//! [sheet]
static void through_nodes(void) {
    /* In the host's memory, which must not change. */
    double points[4][4][3];
    const gusset_nodes nodes = {
        .struct_size = sizeof nodes, .nodes = points, .rows = 4, .columns = 4, .scalar = GUSSET_F64};
    gusset_sheet *copied = NULL, *borrowed = NULL;
    int i, j;

    for (i = 0; i < 4; ++i) {
        for (j = 0; j < 4; ++j) {
            points[i][j][0] = i, points[i][j][1] = j, points[i][j][2] = 0.1 * i * j;
        }
    }
    MUST(gusset_sheet_create(NULL, &nodes, NULL, 0, &copied));
    MUST(gusset_sheet_create(NULL, &nodes, NULL, 1, &borrowed));
    gusset_sheet_destroy(borrowed);
    gusset_sheet_destroy(copied);
}
//! [sheet]

//! [sheet_ask]
static void what_a_sheet_is(const gusset_sheet *sheet) {
    enum { CELLS = (ROWS - 1) * (COLUMNS - 1) };
    double errors[CELLS], bilinear[CELLS];
    const gusset_cell_arrays cells = {
        .struct_size = sizeof cells, .capacity = CELLS, .errors = errors, .bilinear = bilinear};
    gusset_sheet_measures measures = {.struct_size = sizeof measures};
    gusset_sheet_report report = {.struct_size = sizeof report};

    MUST(gusset_sheet_get_report(sheet, &report));
    HOLDS(report.rows == ROWS - 1 && report.columns == COLUMNS - 1 && report.closed_v == 1 && report.closed_u == 0);
    MUST(gusset_sheet_measure(NULL, sheet, GUSSET_SHEET_MEASURE_CREASE, &cells, &measures));
    /* Twelve nodes round: the sagitta is 1 - cos(15 degrees), the surface is a hundred times nearer to the circle. */
    HOLDS(bilinear[0] > 0.03 && errors[0] < 1e-3);
    /* The tube is smooth; the diameters were not asked for. */
    HOLDS(measures.crease < 1e-9 && measures.diameter == 0.0);
}
//! [sheet_ask]

//! [sheet_make]
static void other_kinds(void) {
    const double flat[2][2][3] = {{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}};
    const double u[2][2][3] = {{{1, 0, 1}, {1, 0, 1}}, {{1, 0, -1}, {1, 0, -1}}};
    const double v[2][2][3] = {{{0, 1, 0}, {0, 1, 0}}, {{0, 1, 0}, {0, 1, 0}}};
    const double controls[2][3][3] = {{{0, 0, 0}, {0, 1, 1}, {0, 2, 0}}, {{1, 0, 0}, {1, 1, 1}, {1, 2, 0}}};
    const double knots_u[4] = {0, 0, 1, 1}, knots_v[6] = {0, 0, 0, 1, 1, 1};
    const gusset_nodes nodes = {
        .struct_size = sizeof nodes, .nodes = flat, .rows = 2, .columns = 2, .scalar = GUSSET_F64};
    const gusset_tangents tangents = {
        .struct_size = sizeof tangents, .u = u[0][0], .v = v[0][0], .twist = GUSSET_TWISTS_ZERO};
    const gusset_spline spline = {.struct_size = sizeof spline,
                                  .points = controls[0][0],
                                  .count_u = 2,
                                  .count_v = 3,
                                  .knots_u = knots_u,
                                  .knot_count_u = 4,
                                  .knots_v = knots_v,
                                  .knot_count_v = 6,
                                  .degree_u = 1,
                                  .degree_v = 2};
    gusset_sheet *sheet = NULL;

    MUST(gusset_sheet_create(NULL, &nodes, &tangents, 0, &sheet));
    gusset_sheet_destroy(sheet);
    /* One patch, linear in u and quadratic in v, and the same as a B-spline. */
    MUST(gusset_sheet_from_patches_create(NULL, controls[0][0], 1, 2, 1, 1, &sheet));
    gusset_sheet_destroy(sheet);
    MUST(gusset_sheet_from_spline_create(NULL, &spline, &sheet));
    gusset_sheet_destroy(sheet);
}

/* A quarter of a cylinder, whose circle is a rational curve of degree 2. */
static void a_rational_spline(void) {
    const double controls[2][3][3] = {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{1, 0, 2}, {1, 1, 2}, {0, 1, 2}}};
    const double weights[2][3] = {{1, sqrt(0.5), 1}, {1, sqrt(0.5), 1}};
    const double knots_u[4] = {0, 0, 1, 1}, knots_v[6] = {0, 0, 0, 1, 1, 1};
    const gusset_spline spline = {.struct_size = sizeof spline,
                                  .points = controls[0][0],
                                  .count_u = 2,
                                  .count_v = 3,
                                  .knots_u = knots_u,
                                  .knot_count_u = 4,
                                  .knots_v = knots_v,
                                  .knot_count_v = 6,
                                  .degree_u = 1,
                                  .degree_v = 2,
                                  .weights = weights[0],
                                  .tolerance = 1e-9};
    gusset_sheet_report report = {.struct_size = sizeof report};
    gusset_sheet *sheet = NULL;

    MUST(gusset_sheet_from_spline_create(NULL, &spline, &sheet));
    MUST(gusset_sheet_get_report(sheet, &report));
    /* Nowhere farther from the cylinder than this; its columns begin at these parameters. */
    HOLDS(report.deviation <= 1e-9 && report.rows == 1 && report.columns > 1);
    HOLDS(report.knots_v[0] == 0.0 && report.knots_v[report.columns] == 1.0);
    gusset_sheet_destroy(sheet);
}

/* The skin of three arcs, one behind another. */
static void skin(void) {
    const uint32_t ends[2] = {0, 2};
    gusset_curve *rows[3];
    const gusset_curve *lent[3];
    gusset_curve_net net = {.struct_size = sizeof net, .rows = lent, .row_count = 3};
    gusset_sheet *sheet = NULL;
    int k;

    for (k = 0; k < 3; ++k) {
        const double arc[3][3] = {{k, 0, 0}, {k, 1, 1}, {k, 2, 0}};
        MUST(gusset_curve_create(NULL, arc[0], 3, 3, ends, 2, 0, &rows[k]));
        lent[k] = rows[k];
    }
    MUST(gusset_sheet_from_curves_create(NULL, &net, &sheet));
    gusset_sheet_destroy(sheet);
    for (k = 0; k < 3; ++k) {
        gusset_curve_destroy(rows[k]);
    }
}

/* The body that a frame of three squares draws. */
static void body(void) {
    const double points[12][3] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 1}, {0, 1, 1},
                                  {-1, 0, 1}, {0, -1, 1}, {1, 0, 2}, {0, 1, 2}, {-1, 0, 2}, {0, -1, 2}};
    const uint32_t offsets[4] = {0, 4, 8, 12};
    const gusset_outlines sections = {.struct_size = sizeof sections,
                                      .points = points,
                                      .point_count = 12,
                                      .offsets = offsets,
                                      .outline_count = 3,
                                      .dimension = 3,
                                      .closed = 1};
    gusset_frame *frame = NULL;
    gusset_sheet *sheet = NULL;

    MUST(gusset_frame_create(NULL, &sections, NULL, &frame));
    MUST(gusset_sheet_from_frame_create(NULL, frame, GUSSET_FRAME_NODES, &sheet));
    gusset_frame_destroy(frame);
    gusset_sheet_destroy(sheet);
}

/* A plane, and the one that is 2 above it. */
static void beside(void) {
    const double points[9][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                 {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}};
    const gusset_nodes nodes = {
        .struct_size = sizeof nodes, .nodes = points, .scalar = GUSSET_F64, .rows = 3, .columns = 3};
    const double up = -2.0; /* u runs along y and v along x: the normal points down. */
    double deviation = 1.0;
    gusset_sheet *sheet = NULL, *offset = NULL;

    MUST(gusset_sheet_create(NULL, &nodes, NULL, 0, &sheet));
    MUST(gusset_sheet_offset_create(NULL, sheet, &up, 1, &deviation, &offset));
    HOLDS(deviation < 1e-12);
    gusset_sheet_destroy(offset);
    gusset_sheet_destroy(sheet);
}
//! [sheet_make]

//! [sheet_mesh]
static void a_mesh_of_it(const gusset_sheet *sheet) {
    const gusset_sheet_mesh_options options = {.struct_size = sizeof options, .tolerance = 1e-3, .triangles = 1};
    gusset_result *mesh = NULL;
    gusset_mesh_view view = {.struct_size = sizeof view};
    gusset_sheet_mesh_report parts = {.struct_size = sizeof parts};

    MUST(gusset_sheet_to_mesh(NULL, sheet, &options, &mesh));
    MUST(gusset_result_get_mesh(mesh, &view));
    MUST(gusset_result_get_sheet_mesh(mesh, &parts));
    HOLDS(parts.vertex_count == view.vertex_count && parts.deviation <= 1e-3);
    gusset_result_destroy(mesh);
}
//! [sheet_mesh]

//! [surface_info]
static void what_a_surface_is(const gusset_surface *surface) {
    gusset_surface_report report = {.struct_size = sizeof report};

    MUST(gusset_surface_get_report(surface, &report));
    HOLDS(report.sheet_count == 1 && report.cell_count == report.sheets[0].rows * report.sheets[0].columns);
    HOLDS(report.sheets[0].closed_v == 1 && report.low[2] <= 0.0);
}
//! [surface_info]

//! [surface_closest]
static void nearest_points(const gusset_surface *surface) {
    const double queries[2][3] = {{3, 0, 2}, {0, 0.5, 1}};
    const gusset_nearest_options options = {.struct_size = sizeof options, .max_count = 2};
    gusset_surface_nearest_point found[2];
    gusset_surface_points *points = NULL;
    gusset_surface_points_view all = {.struct_size = sizeof all};
    gusset_surface_cells *region = NULL;
    gusset_surface_cells_view cells = {.struct_size = sizeof cells};

    MUST(gusset_surface_nearest(NULL, surface, queries[0], 2, NULL, found));
    HOLDS(about(found[0].distance, 2.0) && (found[0].flags & GUSSET_NEAREST_PROVEN));
    HOLDS(about(found[1].point[1], 1.0) && found[1].bound <= found[1].distance);
    /* From within there are two: before and behind. */
    MUST(gusset_surface_minima_create(NULL, surface, queries[1], &options, &points));
    MUST(gusset_surface_points_get_view(points, &all));
    HOLDS(all.count >= 1 && about(all.points[0].distance, 0.5));
    gusset_surface_points_destroy(points);
    /* The cells within a radius. */
    MUST(gusset_surface_region_create(NULL, surface, queries[0], 2.1, &region));
    MUST(gusset_surface_cells_get_view(region, &cells));
    HOLDS(cells.cell_count > 0 && cells.cell_count < (ROWS - 1) * (COLUMNS - 1));
    gusset_surface_cells_destroy(region);
}
//! [surface_closest]

//! [surface_distance]
static void distances(const gusset_surface *tube, const gusset_surface *table) {
    const double bow[3][3] = {{3, -1, 1}, {2, 0, 2}, {3, 1, 1}};
    const uint32_t ends[2] = {0, 2};
    gusset_target line = {.struct_size = sizeof line,
                          .kind = GUSSET_TARGET_LINE,
                          .line = {.origin = {3, -5, 1}, .direction = {0, 1, 0}, .from = -INFINITY, .to = INFINITY}};
    gusset_target plane = {
        .struct_size = sizeof plane, .kind = GUSSET_TARGET_PLANE, .point = {0, -4, 0}, .normal = {0, -1, 0}};
    gusset_target along = {.struct_size = sizeof along, .kind = GUSSET_TARGET_CURVE};
    gusset_target other = {.struct_size = sizeof other, .kind = GUSSET_TARGET_SURFACE, .surface = table};
    gusset_distance_report found = {.struct_size = sizeof found};
    gusset_curve *curve = NULL;

    /* The tube is of radius 1 about the z axis; a line beside it, and where on the line. */
    MUST(gusset_surface_distance(NULL, tube, &line, 0.0, &found));
    HOLDS(about(found.distance, 2.0) && about(found.parameter, 5.0) && (found.flags & GUSSET_DISTANCE_PROVEN));
    /* The plane y = -4, its upper side to the south: the tube is 3 below it. */
    MUST(gusset_surface_distance(NULL, tube, &plane, 1e-6, &found));
    HOLDS(about(found.parameter, -3.0) && about(found.other_point[1], -4.0) && found.bound <= found.distance);
    MUST(gusset_curve_create(NULL, bow[0], 3, 3, ends, 2, 0, &curve));
    along.curve = curve;
    MUST(gusset_surface_distance(NULL, tube, &along, 0.0, &found));
    HOLDS(about(found.distance, 1.5) && about(found.curve_place.t, 0.5));
    gusset_curve_destroy(curve);
    /* The tube intersects the table: the distance is 0. */
    MUST(gusset_surface_distance(NULL, tube, &other, 0.0, &found));
    HOLDS(found.distance == 0.0 && (found.flags & GUSSET_DISTANCE_MEETS) && about(found.point[2], 1.7));
}
//! [surface_distance]

//! [surface_line]
static void lines_and_curves(const gusset_surface *surface) {
    const gusset_line line = {.origin = {-5, 0, 1}, .direction = {1, 0, 0}, .from = -INFINITY, .to = INFINITY};
    const double bow[3][3] = {{-3, 0, 1}, {0, 0, 3}, {3, 0, 1}};
    const uint32_t ends[2] = {0, 2};
    gusset_surface_hits *hits = NULL;
    gusset_surface_hits_view view = {.struct_size = sizeof view};
    gusset_surface_hit first;
    gusset_curve *curve = NULL;

    MUST(gusset_surface_hits_create(NULL, surface, &line, 1, NULL, GUSSET_HITS_ALL, &hits));
    MUST(gusset_surface_hits_get_view(hits, &view));
    HOLDS(view.hit_count == 2 && about(view.hits[0].t, 4.0) && about(view.hits[1].t, 6.0));
    gusset_surface_hits_destroy(hits);
    MUST(gusset_surface_first_hits(NULL, surface, &line, 1, &first));
    HOLDS(first.kind == GUSSET_HIT_CROSSING && about(first.t, 4.0) && about(fabs(first.normal[0]), 1.0));

    MUST(gusset_curve_create(NULL, bow[0], 3, 3, ends, 2, 0, &curve));
    MUST(gusset_surface_hits_create(NULL, surface, NULL, 0, curve, GUSSET_HITS_ALL, &hits));
    MUST(gusset_surface_hits_get_view(hits, &view));
    HOLDS(view.hit_count == 2 && view.on_curve_count == 6 && about(view.hits[0].point[0], -1.0));
    gusset_surface_hits_destroy(hits);
    gusset_curve_destroy(curve);
}
//! [surface_line]

//! [surface_level]
static void contours(const gusset_surface *surface) {
    double heights[ROWS * COLUMNS];
    const gusset_contour_function height = {
        .struct_size = sizeof height, .kind = GUSSET_CONTOUR_HEIGHT, .point = {0, 0, 0}, .direction = {0, 0, 1}};
    const gusset_contour_function values = {.struct_size = sizeof values,
                                            .kind = GUSSET_CONTOUR_VALUES,
                                            .values = heights,
                                            .value_count = ROWS * COLUMNS};
    const gusset_contour_function angle = {
        .struct_size = sizeof angle, .kind = GUSSET_CONTOUR_ANGLE, .direction = {1, 0, 0}};
    const double levels[2] = {1.1, 2.2}, across = 0.5 * pi, upwards[3] = {0, 0, 1};
    gusset_surface_paths *paths = NULL;
    gusset_surface_paths_view view = {.struct_size = sizeof view};
    gusset_nearest_angle_report nearest = {.struct_size = sizeof nearest};
    int k;

    /* Sections by two planes. */
    MUST(gusset_surface_contours_create(NULL, surface, &height, levels, 2, NULL, &paths));
    MUST(gusset_surface_paths_get_view(paths, &view));
    HOLDS(view.path_count == 2 && view.closed[0] == 1 && about(view.points[2], 1.1) && view.unresolved_count == 0);
    gusset_surface_paths_destroy(paths);

    /* Any function given at the corners of cells: here the height, so that the curves are the same. */
    for (k = 0; k < ROWS * COLUMNS; ++k) {
        heights[k] = 0.5 * (k / COLUMNS);
    }
    MUST(gusset_surface_contours_create(NULL, surface, &values, levels, 2, NULL, &paths));
    MUST(gusset_surface_paths_get_view(paths, &view));
    HOLDS(view.path_count == 2 && about(view.points[2], 1.1));
    gusset_surface_paths_destroy(paths);

    /* The silhouette seen from the east: two lines along the tube. */
    MUST(gusset_surface_contours_create(NULL, surface, &angle, &across, 1, NULL, &paths));
    MUST(gusset_surface_paths_get_view(paths, &view));
    HOLDS(view.path_count == 2 && view.closed[0] == 0);
    gusset_surface_paths_destroy(paths);
    /* No normal of the tube looks up: the nearest are level. */
    MUST(gusset_surface_nearest_angle(NULL, surface, upwards, 0.0, 0, &nearest));
    HOLDS(about(nearest.angle, 0.5 * pi) && about(nearest.deviation, 0.5 * pi));
}
//! [surface_level]

//! [surface_meet]
static void intersections(const gusset_surface *a, const gusset_surface *b) {
    gusset_surface_paths *paths = NULL;
    gusset_surface_paths_view view = {.struct_size = sizeof view};
    gusset_surface_cells *pairs = NULL;
    gusset_surface_cells_view near = {.struct_size = sizeof near};

    MUST(gusset_surface_intersection_create(NULL, a, b, NULL, &paths));
    MUST(gusset_surface_paths_get_view(paths, &view));
    HOLDS(view.path_count == 1 && view.closed[0] == 1 && view.others != NULL && about(view.points[2], 1.7));
    /* They touch nowhere, and all is resolved. */
    HOLDS(view.contact_count == 0 && view.unresolved_count == 0);
    gusset_surface_paths_destroy(paths);
    /* The one does not meet itself, which is proved as nothing is unresolved. */
    MUST(gusset_surface_intersection_create(NULL, a, NULL, NULL, &paths));
    MUST(gusset_surface_paths_get_view(paths, &view));
    HOLDS(view.path_count == 0 && view.unresolved_count == 0);
    gusset_surface_paths_destroy(paths);
    /* Cells that may meet, for a search of the host's own. */
    MUST(gusset_surface_cell_pairs_create(NULL, a, b, 0.0, &pairs));
    MUST(gusset_surface_cells_get_view(pairs, &near));
    HOLDS(near.cell_count >= COLUMNS - 1 && near.others != NULL);
    gusset_surface_cells_destroy(pairs);
}
//! [surface_meet]

//! [surface_evaluate]
static void points(const gusset_surface *surface) {
    const double middle[2] = {4.0, 0.0};
    gusset_surface_place place;
    gusset_surface_point point;

    MUST(gusset_surface_locate(NULL, surface, 0, middle, 1, &place));
    MUST(gusset_surface_evaluate(NULL, surface, &place, 1, &point));
    HOLDS(about(point.point[0], 1.0) && about(point.point[2], 2.0) && point.normal_kind == GUSSET_NORMAL_REGULAR);
    /* A cylinder of radius 1 bends one way only. */
    HOLDS(point.is_curved == 1 && fabs(fabs(point.principal[0] + point.principal[1]) - 1.0) < 0.1 && fabs(point.gaussian) < 1e-9);
}
//! [surface_evaluate]

//! [sheet_curve]
static void a_line_of_nodes(const gusset_sheet *sheet) {
    gusset_curve *curve = NULL;
    gusset_curve_measures measures = {.struct_size = sizeof measures};

    MUST(gusset_sheet_curve_create(NULL, sheet, GUSSET_ALONG_ROWS, 2.0, &curve));
    MUST(gusset_curve_measure(NULL, curve, GUSSET_CURVE_MEASURE_LENGTH, &measures));
    HOLDS(fabs(measures.length - 2.0 * pi) < 1e-2); /* once round */
    gusset_curve_destroy(curve);
}
//! [sheet_curve]

//! [surface_leus]
static void the_papers_search(const gusset_sheet *sheet) {
    const gusset_reference_task task = {
        .struct_size = sizeof task, .object = GUSSET_REFERENCE_POINT, .point = {3, 0, 2}, .within = 2.1};
    const uint32_t from[2] = {0, 0}, to[2] = {7, 6};
    const gusset_surface_place place = {.row = 3, .column = 3, .u = 0.5, .v = 0.5};
    uint64_t words[2];
    uint32_t chain[2 * 96];
    double normal[3];
    size_t written = 0;
    gusset_reference_report report = {.struct_size = sizeof report};
    gusset_sheet_measures measures = {.struct_size = sizeof measures};
    gusset_mask_report region = {.struct_size = sizeof region};
    gusset_curve *curve = NULL;

    MUST(gusset_sheet_measure(NULL, sheet, GUSSET_SHEET_MEASURE_DIAMETERS + GUSSET_SHEET_MEASURE_CURVATURE, NULL, &measures));
    HOLDS(measures.diameter <= measures.intrinsic_diameter && measures.curvature_bound >= 1.0 - 0.1);
    /* The cells that may have a point within the distance: a bit for each. */
    MUST(gusset_sheet_reference_mask(NULL, sheet, &task, words, 2, &written, &report));
    HOLDS(written == 2 && report.cells > 0 && report.cells < 96);
    MUST(gusset_sheet_mask_measure(NULL, sheet, words, 2, &region));
    HOLDS(region.cells == report.cells);
    /* The same as lists of cells, and of the nodes round them. */
    MUST(gusset_sheet_mask_elements(NULL, sheet, words, 2, GUSSET_DOMAIN_FACES, chain, 96, &written));
    HOLDS(written == report.cells);
    MUST(gusset_sheet_mask_elements(NULL, sheet, words, 2, GUSSET_DOMAIN_VERTICES, NULL, 0, &written));
    HOLDS(written > report.cells);
    /* Over the points of a curve: the arcs of a line of nodes that may come as near. */
    MUST(gusset_sheet_curve_create(NULL, sheet, GUSSET_ALONG_ROWS, 4.0, &curve));
    MUST(gusset_curve_reference_mask(NULL, curve, 1, &task, words, 2, &written, &report));
    HOLDS(written == 1 && report.cells > 0 && report.cells < 12);
    gusset_curve_destroy(curve);
    /* A shortest chain of cells, over all of them: the moves of a king, and the tube is closed. */
    MUST(gusset_sheet_mask_chain(NULL, sheet, NULL, 0, from, to, chain, 96, &written));
    HOLDS(written == 8 && chain[0] == 0 && chain[2 * 7] == 7 && chain[2 * 7 + 1] == 6);
    MUST(gusset_sheet_normals_by_sections(NULL, sheet, &place, 1, normal));
    HOLDS(fabs(normal[2]) < 1e-6);
}
//! [surface_leus]

int main(void) {
    gusset_sheet *round = tube(), *flat = table(1.7);
    gusset_surface *a = indexed(round), *b = indexed(flat);
    through_nodes();
    found_and_kept(round);
    what_a_sheet_is(round);
    other_kinds();
    a_rational_spline();
    skin();
    body();
    beside();
    a_mesh_of_it(round);
    what_a_surface_is(a);
    nearest_points(a);
    distances(a, b);
    lines_and_curves(a);
    contours(a);
    intersections(a, b);
    points(a);
    a_line_of_nodes(round);
    the_papers_search(round);
    gusset_surface_destroy(b);
    gusset_surface_destroy(a);
    gusset_sheet_destroy(flat);
    gusset_sheet_destroy(round);
    return 0;
}
