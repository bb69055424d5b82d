/* Handles and arrays that threads share, each thread with a context of its own: each answer has the bytes that it has alone. */
#include "example.h"
#include "process_state.h"

#include <pthread.h>

enum { ROWS = 17, COLUMNS = 25, THREADS = 6, ROUNDS = 3, NODES = 33 * 65 };

/* The shared objects: made once before the threads, which only read them. */
static struct {
    double points[ROWS * COLUMNS][3];
    uint32_t quads[(ROWS - 1) * (COLUMNS - 1)][4];
    gusset_mesh_view mesh;
    gusset_net *net;
    gusset_sheet *sheet;
    gusset_surface *surface, *other;
    gusset_curve *curve, *crossing;
    gusset_outline *outline;
    gusset_boundary *boundary;
} shared;

static uint64_t of_mesh(const gusset_mesh_view *mesh) {
    const uint64_t hash = hashed(14695981039346656037u, mesh->positions, mesh->vertex_count * 3 * sizeof(double));
    return hashed(hash, mesh->face_corners, mesh->face_count * (mesh->face_size ? mesh->face_size : 3) * sizeof(uint32_t));
}

static uint64_t of_paths(const gusset_surface_paths *paths) {
    gusset_surface_paths_view view = {.struct_size = sizeof view};
    MUST(gusset_surface_paths_get_view(paths, &view));
    return hashed(view.path_count, view.points, view.point_count * 3 * sizeof(double));
}

static uint64_t boundary(const gusset_context *context) {
    gusset_boundary_view loops = {.struct_size = sizeof loops};
    gusset_loop_view loop = {.struct_size = sizeof loop};
    gusset_boundary *own = NULL;
    uint64_t hash = 0;
    MUST(gusset_boundary_create(context, &shared.mesh, NULL, &own));
    MUST(gusset_boundary_get_view(own, &loops));
    for (size_t i = 0; i < loops.loop_count; ++i) {
        MUST(gusset_boundary_get_loop(own, i, &loop));
        hash = hashed(hash, loop.vertices.data, loop.vertices.count * sizeof(uint32_t));
        MUST(gusset_boundary_get_loop(shared.boundary, i, &loop));
        hash = hashed(hash, loop.vertices.data, loop.vertices.count * sizeof(uint32_t));
    }
    gusset_boundary_destroy(own);
    return hash;
}

static uint64_t fill(const gusset_context *context) {
    gusset_mesh_view view = {.struct_size = sizeof view};
    gusset_result *fill = NULL;
    MUST(gusset_fill(context, &shared.mesh, NULL, 0, NULL, &fill));
    MUST(gusset_result_get_mesh(fill, &view));
    const uint64_t hash = of_mesh(&view);
    gusset_result_destroy(fill);
    return hash;
}

static uint64_t normals(const gusset_context *context) {
    double *const found = calloc(3 * NODES, sizeof *found);
    uint64_t missing = 0;
    MUST(gusset_net_normals(context, shared.net, found, found + NODES, found + 2 * NODES, NODES, &missing));
    const uint64_t hash = hashed(missing, found, 3 * NODES * sizeof *found);
    free(found);
    return hash;
}

static uint64_t stream(const gusset_context *context) {
    gusset_stream *stream = NULL;
    gusset_stream_view view = {.struct_size = sizeof view};
    MUST(gusset_net_encode_create(context, shared.net, NULL, &stream));
    MUST(gusset_stream_get_view(stream, &view));
    const uint64_t hash = hashed(view.size, view.data, view.size);
    gusset_stream_destroy(stream);
    return hash;
}

static uint64_t nearest(const gusset_context *context) {
    enum { QUERIES = 200 };
    double queries[QUERIES][3];
    gusset_surface_nearest_point found[QUERIES];
    uint64_t hash = 0;
    for (int i = 0; i < QUERIES; ++i)
        queries[i][0] = 3.0 * sin(i), queries[i][1] = 2.0 * cos(1.7 * i), queries[i][2] = 0.02 * i;
    MUST(gusset_surface_nearest(context, shared.surface, queries[0], QUERIES, NULL, found));
    for (int i = 0; i < QUERIES; ++i) hash = hashed(hash, found[i].point, sizeof found[i].point);
    return hash;
}

static uint64_t section(const gusset_context *context) {
    const gusset_contour_function height = {.struct_size = sizeof height, .direction = {0, 0.1, 1}};
    const double levels[2] = {1.1, 2.2};
    gusset_surface_paths *paths = NULL;
    MUST(gusset_surface_contours_create(context, shared.surface, &height, levels, 2, NULL, &paths));
    const uint64_t hash = of_paths(paths);
    gusset_surface_paths_destroy(paths);
    return hash;
}

static uint64_t intersection(const gusset_context *context) {
    gusset_surface_paths *paths = NULL;
    MUST(gusset_surface_intersection_create(context, shared.surface, shared.other, NULL, &paths));
    const uint64_t hash = of_paths(paths);
    gusset_surface_paths_destroy(paths);
    return hash;
}

static uint64_t tessellated(const gusset_context *context) {
    gusset_mesh_view view = {.struct_size = sizeof view};
    gusset_result *mesh = NULL;
    MUST(gusset_sheet_to_mesh(context, shared.sheet, NULL, &mesh));
    MUST(gusset_result_get_mesh(mesh, &view));
    const uint64_t hash = hashed(view.face_count, view.positions, view.vertex_count * 3 * sizeof(double));
    gusset_result_destroy(mesh);
    return hash;
}

static uint64_t crossings(const gusset_context *context) {
    gusset_places_view view = {.struct_size = sizeof view};
    gusset_places *places = NULL;
    MUST(gusset_curve_intersect_create(context, shared.curve, shared.crossing, 0.0, &places));
    MUST(gusset_places_get_view(places, &view));
    const uint64_t hash = hashed(view.count, view.points, view.count * 2 * sizeof(double));
    gusset_places_destroy(places);
    return hash;
}

static uint64_t copied(const gusset_context *context) {
    gusset_curve_view view = {.struct_size = sizeof view};
    gusset_curve *curve = NULL;
    MUST(gusset_outline_curve_create(context, shared.outline, 0, &curve));
    MUST(gusset_curve_get_view(curve, &view));
    const uint64_t hash = hashed(view.control_count, view.controls, view.control_count * 2 * sizeof(double));
    gusset_curve_destroy(curve);
    return hash;
}

static uint64_t (*const jobs[])(const gusset_context *) = {boundary, fill,         normals,     stream,    nearest,
                                                           section,  intersection, tessellated, crossings, copied};
enum { JOBS = sizeof jobs / sizeof *jobs };

static uint64_t alone[JOBS];

static void *run(void *number) {
    const int first = *(const int *)number;
    gusset_context *context = NULL;
    intptr_t wrong = 0;
    MUST(gusset_context_create(&context));
    for (int k = 0; k < ROUNDS * JOBS; ++k) {
        const int job = (first * 3 + k) % JOBS;
        MUST(gusset_context_set_threads(context, (uint32_t)(k % 3)));
        wrong += jobs[job](context) != alone[job];
    }
    gusset_context_destroy(context);
    return (void *)wrong;
}

static void make_shared(void) {
    for (int i = 0; i < ROWS; ++i)
        for (int j = 0; j < COLUMNS; ++j) {
            const double angle = 2.0 * pi * (j % (COLUMNS - 1)) / (COLUMNS - 1);
            double *const point = shared.points[i * COLUMNS + j];
            point[0] = cos(angle), point[1] = sin(angle), point[2] = 0.25 * i;
        }
    for (int i = 0; i + 1 < ROWS; ++i)
        for (int j = 0; j + 1 < COLUMNS; ++j) {
            uint32_t *const quad = shared.quads[i * (COLUMNS - 1) + j];
            const uint32_t row = (uint32_t)(i * COLUMNS), next = (uint32_t)((j + 1) % (COLUMNS - 1));
            quad[0] = row + (uint32_t)j, quad[1] = row + next, quad[2] = row + COLUMNS + next, quad[3] = row + COLUMNS + (uint32_t)j;
        }
    const gusset_nodes tube = {.struct_size = sizeof tube,
                               .nodes = shared.points,
                               .rows = ROWS,
                               .columns = COLUMNS,
                               .scalar = GUSSET_F64,
                               .scheme = GUSSET_SCHEME_SIX_TAP,
                               .closed_v = 1};
    const gusset_net_primitive ball = {.struct_size = sizeof ball, .shape = GUSSET_NET_SPHERE, .scalar = GUSSET_F64, .rows = 33, .columns = 65, .radius = 1.0};
    const double table[4][3] = {{-2, -2, 1.5}, {-2, 2, 2}, {2, -2, 2.5}, {2, 2, 1.75}};
    const double wave[7][2] = {{-2, 0}, {-1, 2}, {0, -3}, {1, 1}, {1.5, 3}, {2, -3}, {2.5, 0.5}}, line[2][2] = {{-2, 0.1}, {3, 0.2}};
    const uint32_t wave_ends[3] = {0, 3, 6}, line_ends[2] = {0, 1};
    const gusset_outlines outlines = {.struct_size = sizeof outlines, .points = wave, .point_count = 7, .dimension = 2};
    gusset_sheet *flat = NULL;
    const gusset_sheet *lent = NULL;
    shared.mesh = gusset_quads_f64(shared.points[0], ROWS * COLUMNS, shared.quads[0], (ROWS - 1) * (COLUMNS - 1));
    MUST(gusset_boundary_create(NULL, &shared.mesh, NULL, &shared.boundary));
    MUST(gusset_net_primitive_create(NULL, &ball, &shared.net));
    MUST(gusset_sheet_create(NULL, &tube, NULL, 1, &shared.sheet));
    lent = shared.sheet;
    MUST(gusset_surface_create(NULL, &lent, 1, NULL, &shared.surface));
    MUST(gusset_sheet_from_patches_create(NULL, table[0], 1, 1, 1, 1, &flat));
    lent = flat;
    MUST(gusset_surface_create(NULL, &lent, 1, NULL, &shared.other));
    gusset_sheet_destroy(flat);
    MUST(gusset_curve_create(NULL, wave[0], 7, 2, wave_ends, 3, 0, &shared.curve));
    MUST(gusset_curve_create(NULL, line[0], 2, 2, line_ends, 2, 0, &shared.crossing));
    MUST(gusset_outline_create(NULL, &outlines, NULL, &shared.outline));
}

int main(void) {
    pthread_t threads[THREADS];
    int numbers[THREADS] = {0};
    long wrong = 0;
    make_shared();
    for (int job = 0; job < JOBS; ++job) alone[job] = jobs[job](NULL);
    if (pthread_create(&threads[0], NULL, run, &numbers[0]) != 0 || pthread_join(threads[0], NULL) != 0) return 2;
    const process_state before = process_state_now();
    for (int i = 0; i < THREADS; ++i) {
        numbers[i] = i;
        if (pthread_create(&threads[i], NULL, run, &numbers[i]) != 0) return 2;
    }
    for (int i = 0; i < THREADS; ++i) {
        void *found = NULL;
        pthread_join(threads[i], &found);
        wrong += (long)(intptr_t)found;
    }
    const process_state after = process_state_now();
    if (wrong) printf("%ld answers are not those of one thread alone\n", wrong);
    wrong += process_state_changed(&before, &after);
    gusset_boundary_destroy(shared.boundary);
    gusset_net_destroy(shared.net);
    gusset_sheet_destroy(shared.sheet);
    gusset_surface_destroy(shared.surface);
    gusset_surface_destroy(shared.other);
    gusset_curve_destroy(shared.curve);
    gusset_curve_destroy(shared.crossing);
    gusset_outline_destroy(shared.outline);
    return wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
