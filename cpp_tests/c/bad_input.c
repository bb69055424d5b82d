/* Everything that a host can get wrong: each mistake has its own status, clears the outputs, and leaves the context fit
 * for the next call. Run under valgrind too, which sees every byte read that is not ours. */
#include "check.h"
#include <math.h>
#include <stdlib.h>

static gusset_context *context;

/* The mesh is refused with this status by all functions that take one; the report names the element. */
static void refused(gusset_mesh_view mesh, gusset_status status, gusset_element element, uint64_t index, int line) {
    const gusset_mesh_view good = pyramid(pyramid_down);
    gusset_boundary *boundary = (gusset_boundary *)misaligned();
    gusset_result *stitch = (gusset_result *)misaligned();
    gusset_winged *winged = (gusset_winged *)misaligned();
    gusset_check *check = (gusset_check *)misaligned();
    gusset_result *weld = (gusset_result *)misaligned();
    gusset_result *orient = (gusset_result *)misaligned();
    gusset_error_report report = {sizeof report, 0, 0, 0, 0.0, 0, 0};
    const int before = failures;

    EXPECT(status, gusset_winged_create(context, &mesh, NULL, &winged));
    EXPECT(status, gusset_check_create(context, &mesh, &check));
    CHECK(winged == NULL && check == NULL);
    EXPECT(status, gusset_weld(context, &mesh, NULL, &weld));
    EXPECT(status, gusset_orient(context, &mesh, NULL, &orient));
    CHECK(weld == NULL && orient == NULL);
    EXPECT(status, gusset_boundary_create(context, &mesh, NULL, &boundary));
    CHECK(boundary == NULL);
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.status == status && report.element == element && report.index == index && report.input == 0);
    CHECK(strlen(gusset_context_get_message(context)) > 10);
    EXPECT(status, gusset_stitch(context, &mesh, NULL, &good, NULL, NULL, &stitch));
    CHECK(stitch == NULL);
    stitch = (gusset_result *)misaligned();
    EXPECT(status, gusset_stitch(context, &good, NULL, &mesh, NULL, NULL, &stitch));
    CHECK(stitch == NULL);
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.status == status && report.element == element && report.index == index && report.input == 1);
    /* Without a context too. */
    EXPECT(status, gusset_boundary_create(NULL, &mesh, NULL, &boundary));
    fit_for_more(context);
    if (failures != before) {
        printf("  in the case of line %d: element %u index %llu\n", line, (unsigned)report.element,
               (unsigned long long)report.index);
    }
}

#define REFUSED(change, status, element, index)                                                                        \
    do {                                                                                                               \
        gusset_mesh_view m = pyramid(pyramid_up);                                                                      \
        change;                                                                                                        \
        refused(m, status, element, index, __LINE__);                                                                  \
    } while (0)

static void meshes(void) {
    double points[5][3];
    float floats[5][3] = {{0, 0, 2}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
    uint32_t corners[12];
    uint32_t offsets[5] = {0, 3, 6, 9, 12};
    const size_t most = (size_t)UINT32_MAX - 1;

    /* Fields. */
    REFUSED(m.scalar = 0, GUSSET_ERROR_UNKNOWN_VALUE, GUSSET_ELEMENT_NONE, 0);
    REFUSED(m.scalar = 3, GUSSET_ERROR_UNKNOWN_VALUE, GUSSET_ELEMENT_NONE, 0);
    REFUSED(m.index = GUSSET_U64, GUSSET_ERROR_UNKNOWN_VALUE, GUSSET_ELEMENT_NONE, 0);
    REFUSED(m.reserved = 1, GUSSET_ERROR_UNKNOWN_VALUE, GUSSET_ELEMENT_NONE, 0);
    REFUSED(m.struct_size = 0, GUSSET_ERROR_BAD_STRUCT_SIZE, GUSSET_ELEMENT_NONE, 0);
    REFUSED(m.struct_size = 71, GUSSET_ERROR_BAD_STRUCT_SIZE, GUSSET_ELEMENT_NONE, 0);
    /* A size that ends within a pointer, of which it would keep the low bytes. */
    for (size_t size = offsetof(gusset_mesh_view, merge) + 1; size < sizeof(gusset_mesh_view); ++size) {
        REFUSED((m.merge = offsets, m.struct_size = size), GUSSET_ERROR_BAD_STRUCT_SIZE, GUSSET_ELEMENT_NONE, 0);
    }
    REFUSED(m.struct_size = SIZE_MAX, GUSSET_ERROR_BAD_STRUCT_SIZE, GUSSET_ELEMENT_NONE, 0);

    /* Arrays that are not there. */
    REFUSED(m.positions = NULL, GUSSET_ERROR_NULL_ARGUMENT, GUSSET_ELEMENT_NONE, 0);
    REFUSED(m.face_corners = NULL, GUSSET_ERROR_NULL_ARGUMENT, GUSSET_ELEMENT_NONE, 0);
    REFUSED(m.face_size = 0, GUSSET_ERROR_BAD_FACE_LAYOUT, GUSSET_ELEMENT_NONE, 0);
    REFUSED(m.face_offsets = offsets, GUSSET_ERROR_BAD_FACE_LAYOUT, GUSSET_ELEMENT_NONE, 0);

    /* Empty. */
    REFUSED(m.vertex_count = 0, GUSSET_ERROR_EMPTY_MESH, GUSSET_ELEMENT_NONE, 0);
    REFUSED(m.face_count = 0, GUSSET_ERROR_EMPTY_MESH, GUSSET_ELEMENT_NONE, 0);
    REFUSED((m.face_count = 0, m.face_size = 0, m.face_corners = NULL), GUSSET_ERROR_EMPTY_MESH, GUSSET_ELEMENT_NONE, 0);

    /* Counts: above the limits, and whose bytes overflow. Nothing of the arrays is read then. */
    REFUSED(m.vertex_count = SIZE_MAX, GUSSET_ERROR_TOO_LARGE, GUSSET_ELEMENT_COUNT, SIZE_MAX);
    REFUSED(m.vertex_count = most + 1, GUSSET_ERROR_TOO_LARGE, GUSSET_ELEMENT_COUNT, most + 1);
    REFUSED(m.face_count = SIZE_MAX, GUSSET_ERROR_TOO_LARGE, GUSSET_ELEMENT_COUNT, SIZE_MAX);
    REFUSED(m.face_count = SIZE_MAX / 3, GUSSET_ERROR_TOO_LARGE, GUSSET_ELEMENT_COUNT, SIZE_MAX / 3);
    REFUSED(m.face_count = most / 3 + 1, GUSSET_ERROR_TOO_LARGE, GUSSET_ELEMENT_COUNT, 3 * (uint64_t)(most / 3 + 1));
    REFUSED(m.face_size = UINT32_MAX, GUSSET_ERROR_TOO_LARGE, GUSSET_ELEMENT_COUNT, 4 * (uint64_t)UINT32_MAX);
    REFUSED((m.face_size = 0, m.face_offsets = offsets, m.face_count = SIZE_MAX), GUSSET_ERROR_TOO_LARGE,
            GUSSET_ELEMENT_COUNT, SIZE_MAX);
    REFUSED(m.position_stride = SIZE_MAX, GUSSET_ERROR_SIZE_OVERFLOW, GUSSET_ELEMENT_COUNT, 5);
    REFUSED((m.vertex_count = most, m.position_stride = SIZE_MAX / most), GUSSET_ERROR_SIZE_OVERFLOW,
            GUSSET_ELEMENT_COUNT, most);
    REFUSED(m.position_stride = 23, GUSSET_ERROR_BAD_STRIDE, GUSSET_ELEMENT_COUNT, 23);
    REFUSED((m.positions = floats, m.scalar = GUSSET_F32, m.position_stride = 11), GUSSET_ERROR_BAD_STRIDE,
            GUSSET_ELEMENT_COUNT, 11);

    /* Faces. */
    REFUSED(m.face_size = 2, GUSSET_ERROR_FACE_TOO_SMALL, GUSSET_ELEMENT_FACE, 0);
    REFUSED(m.vertex_count = 4, GUSSET_ERROR_INDEX_OUT_OF_RANGE, GUSSET_ELEMENT_HALF_EDGE, 8);
    memcpy(corners, pyramid_faces, sizeof corners);
    corners[7] = UINT32_MAX;
    REFUSED(m.face_corners = corners, GUSSET_ERROR_INDEX_OUT_OF_RANGE, GUSSET_ELEMENT_HALF_EDGE, 7);
    offsets[0] = 1;
    REFUSED((m.face_size = 0, m.face_offsets = offsets), GUSSET_ERROR_BAD_OFFSETS, GUSSET_ELEMENT_OFFSET, 0);
    offsets[0] = 0, offsets[2] = 2;
    REFUSED((m.face_size = 0, m.face_offsets = offsets), GUSSET_ERROR_BAD_OFFSETS, GUSSET_ELEMENT_OFFSET, 2);
    offsets[2] = 6, offsets[3] = UINT32_MAX;
    REFUSED((m.face_size = 0, m.face_offsets = offsets), GUSSET_ERROR_BAD_OFFSETS, GUSSET_ELEMENT_OFFSET, 4);
    offsets[3] = 10;
    REFUSED((m.face_size = 0, m.face_offsets = offsets), GUSSET_ERROR_FACE_TOO_SMALL, GUSSET_ELEMENT_FACE, 3);
    offsets[3] = 9, offsets[4] = UINT32_MAX;
    REFUSED((m.face_size = 0, m.face_offsets = offsets), GUSSET_ERROR_TOO_LARGE, GUSSET_ELEMENT_COUNT, UINT32_MAX);

    /* Coordinates. */
    memcpy(points, pyramid_up, sizeof points);
    points[3][1] = NAN;
    REFUSED(m.positions = points, GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_VERTEX, 3);
    points[3][1] = -INFINITY;
    REFUSED(m.positions = points, GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_VERTEX, 3);
    floats[2][2] = NAN;
    REFUSED((m.positions = floats, m.scalar = GUSSET_F32), GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_VERTEX, 2);
}

/* Pointers of gusset_boundary_create and its readers: NULL, then misaligned. */
static void boundary_pointers(void) {
    const gusset_mesh_view mesh = pyramid(pyramid_up);
    gusset_boundary_options options = {sizeof options, 0, 0};
    gusset_boundary *boundary = (gusset_boundary *)misaligned();
    gusset_loop_view loop;
    gusset_boundary_view loops;

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_boundary_create(context, NULL, NULL, &boundary));
    CHECK(boundary == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_boundary_create(context, &mesh, NULL, NULL));
    boundary = (gusset_boundary *)misaligned();
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_boundary_create(context, misaligned(), NULL, &boundary));
    CHECK(boundary == NULL);
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_boundary_create(context, &mesh, misaligned(), &boundary));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_boundary_create(context, &mesh, NULL, misaligned()));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_boundary_create(misaligned(), &mesh, NULL, &boundary));
    options.non_manifold = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_boundary_create(context, &mesh, &options, &boundary));
    options.non_manifold = 0, options.survey = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_boundary_create(context, &mesh, &options, &boundary));
    options.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_boundary_create(context, &mesh, &options, &boundary));

    EXPECT(GUSSET_OK, gusset_boundary_create(context, &mesh, NULL, &boundary));
    memset(&loop, 0xff, sizeof loop);
    loop.struct_size = sizeof loop;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_boundary_get_loop(NULL, 0, &loop));
    CHECK(loop.vertices.data == NULL && loop.vertices.count == 0 && loop.flags == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_boundary_get_loop(boundary, 0, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_boundary_get_loop(misaligned(), 0, &loop));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_boundary_get_loop(boundary, 0, misaligned()));
    loop.struct_size = 16;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_boundary_get_loop(boundary, 0, &loop));
    loop.struct_size = sizeof loop;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_boundary_get_loop(boundary, SIZE_MAX, &loop));

    memset(&loops, 0xff, sizeof loops);
    loops.struct_size = sizeof loops;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_boundary_get_view(NULL, &loops));
    CHECK(loops.defects == NULL && loops.defect_count == 0 && loops.loop_count == 0 && loops.walk_count == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_boundary_get_view(boundary, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_boundary_get_view(misaligned(), &loops));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_boundary_get_view(boundary, misaligned()));
    loops.struct_size = sizeof loops - 1;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_boundary_get_view(boundary, &loops));
    gusset_boundary_destroy(boundary);
    gusset_boundary_destroy(NULL);
}

/* Tables of edges that belong to no mesh. */
static void bad_faces_of_tables(const gusset_winged_view *tables, size_t vertices) {
    enum { MOST = 64 };
    gusset_winged_edge edges[MOST];
    gusset_winged_options options = {0};
    gusset_winged_faces *faces = (gusset_winged_faces *)misaligned();
    gusset_winged_faces_view view = {0};
    gusset_indices first = tables->edge_of_face;
    gusset_error_report report = {.struct_size = sizeof report};
    const size_t count = tables->edge_count;
    CHECK(count <= MOST);
    memcpy(edges, tables->edges, count * sizeof *edges);

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_winged_faces_create(context, NULL, count, vertices, NULL, NULL, &faces));
    CHECK(faces == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_winged_faces_create(context, edges, count, vertices, NULL, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_winged_faces_create(misaligned(), edges, count, vertices, NULL, NULL, &faces));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_winged_faces_create(context, edges, count, vertices, misaligned(), NULL, &faces));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_winged_faces_create(context, edges, count, vertices, NULL, misaligned(), &faces));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_winged_faces_create(context, edges, count, vertices, NULL, NULL, misaligned()));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE,
           gusset_winged_faces_create(context, edges, count, vertices, NULL, &options, &faces));
    options.struct_size = sizeof options, options.winding = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE,
           gusset_winged_faces_create(context, edges, count, vertices, NULL, &options, &faces));
    EXPECT(GUSSET_ERROR_TOO_LARGE,
           gusset_winged_faces_create(context, edges, SIZE_MAX, vertices, NULL, NULL, &faces));
    first.count = 1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE,
           gusset_winged_faces_create(context, edges, count, vertices, &first, NULL, &faces));
    first = (gusset_indices){NULL, 2};
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT,
           gusset_winged_faces_create(context, edges, count, vertices, &first, NULL, &faces));

    /* Each number that a record can have, one too large. */
    for (size_t edge = 0; edge < count; ++edge) {
        uint32_t *fields[] = {&edges[edge].m, &edges[edge].n, &edges[edge].left, &edges[edge].right, &edges[edge].b, &edges[edge].c};
        for (size_t k = 0; k < sizeof fields / sizeof *fields; ++k) {
            const uint32_t was = *fields[k];
            *fields[k] = UINT32_MAX - 1;
            EXPECT(GUSSET_ERROR_BAD_WINGS,
                   gusset_winged_faces_create(context, edges, count, vertices, NULL, NULL, &faces));
            EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
            CHECK(report.element == GUSSET_ELEMENT_EDGE && report.index == edge);
            *fields[k] = was;
        }
    }
    EXPECT(GUSSET_ERROR_BAD_WINGS, gusset_winged_faces_create(context, edges, count, 1, NULL, NULL, &faces));
    CHECK(faces == NULL);
    EXPECT(GUSSET_OK, gusset_winged_faces_create(context, NULL, 0, 0, NULL, NULL, &faces));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_winged_faces_get_view(faces, &view));
    view.struct_size = sizeof view;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_winged_faces_get_view(NULL, &view));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_winged_faces_get_view(faces, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_winged_faces_get_view(misaligned(), &view));
    EXPECT(GUSSET_OK, gusset_winged_faces_get_view(faces, &view));
    CHECK(view.face_offsets.count == 1 && view.face_corners.count == 0);
    gusset_winged_faces_destroy(faces);
    gusset_winged_faces_destroy(NULL);
}

/* Certificates: invalid handles and structs, and the piece or the result at fault. */
static void certificate_arguments(const gusset_mesh_view *mesh) {
    gusset_certificate *made = NULL;
    gusset_certificate_view view = {.struct_size = sizeof view};
    gusset_mesh_view pieces[2];

    pieces[0] = *mesh, pieces[1] = *mesh;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_certificate_create(context, NULL, 2, mesh, &made));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_certificate_create(context, pieces, 2, NULL, &made));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_certificate_create(context, pieces, 2, mesh, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_certificate_create(misaligned(), pieces, 2, mesh, &made));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_certificate_create(context, misaligned(), 2, mesh, &made));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_certificate_create(context, pieces, 2, misaligned(), &made));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_certificate_create(context, pieces, 2, mesh, misaligned()));
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_certificate_create(context, pieces, SIZE_MAX, mesh, &made));
    pieces[1].face_count = 0;
    EXPECT(GUSSET_ERROR_EMPTY_MESH, gusset_certificate_create(context, pieces, 2, mesh, &made));
    EXPECT(GUSSET_ERROR_EMPTY_MESH, gusset_certificate_create(context, pieces, 1, &pieces[1], &made));
    CHECK(made == NULL);
    EXPECT(GUSSET_OK, gusset_certificate_create(context, NULL, 0, mesh, &made));
    memset(&view, 0xff, sizeof view), view.struct_size = sizeof view;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_certificate_get_view(NULL, &view));
    CHECK(view.edge_count == 0 && view.lost_faces.data == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_certificate_get_view(made, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_certificate_get_view(misaligned(), &view));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_certificate_get_view(made, misaligned()));
    view.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_certificate_get_view(made, &view));
    EXPECT(GUSSET_OK, gusset_certificate_get_view(made, (view.struct_size = sizeof view, &view)));
    CHECK(view.kept_faces == 0 && view.new_faces == mesh->face_count);
    gusset_certificate_destroy(made);
    gusset_certificate_destroy(NULL);
}

/* Pointers of winged-edge tables and of the check. */
static void table_pointers(void) {
    const gusset_mesh_view mesh = pyramid(pyramid_up);
    gusset_winged_options options = {0};
    gusset_winged *winged = (gusset_winged *)misaligned();
    gusset_winged_view tables;
    gusset_check *check = (gusset_check *)misaligned();
    gusset_check_view report;

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_winged_create(context, NULL, NULL, &winged));
    CHECK(winged == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_winged_create(context, &mesh, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_winged_create(misaligned(), &mesh, NULL, &winged));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_winged_create(context, misaligned(), NULL, &winged));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_winged_create(context, &mesh, misaligned(), &winged));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_winged_create(context, &mesh, NULL, misaligned()));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_winged_create(context, &mesh, &options, &winged));
    options.struct_size = sizeof options, options.winding = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_winged_create(context, &mesh, &options, &winged));
    options.winding = 1, options.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_winged_create(context, &mesh, &options, &winged));
    options.reserved = 0;
    EXPECT(GUSSET_OK, gusset_winged_create(context, &mesh, &options, &winged));
    memset(&tables, 0xff, sizeof tables), tables.struct_size = sizeof tables;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_winged_get_view(NULL, &tables));
    CHECK(tables.edges == NULL && tables.edge_count == 0 && tables.loop_offsets.data == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_winged_get_view(winged, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_winged_get_view(misaligned(), &tables));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_winged_get_view(winged, misaligned()));
    tables.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_winged_get_view(winged, &tables));
    EXPECT(GUSSET_OK, gusset_winged_get_view(winged, (tables.struct_size = sizeof tables, &tables)));
    bad_faces_of_tables(&tables, mesh.vertex_count);
    gusset_winged_destroy(winged);
    gusset_winged_destroy(NULL);

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_check_create(context, NULL, &check));
    CHECK(check == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_check_create(context, &mesh, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_check_create(misaligned(), &mesh, &check));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_check_create(context, misaligned(), &check));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_check_create(context, &mesh, misaligned()));
    EXPECT(GUSSET_OK, gusset_check_create(context, &mesh, &check));
    memset(&report, 0xff, sizeof report), report.struct_size = sizeof report;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_check_get_view(NULL, &report));
    CHECK(report.edge_count == 0 && report.genus == 0 && report.unused_vertices.data == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_check_get_view(check, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_check_get_view(misaligned(), &report));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_check_get_view(check, misaligned()));
    report.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_check_get_view(check, &report));
    gusset_check_destroy(check);
    gusset_check_destroy(NULL);
    certificate_arguments(&mesh);
}

/* Arrays at odd addresses with odd strides, ending at the last byte of their block, give what aligned ones give. */
static void odd_addresses(void) {
    enum { STRIDE = 29 };
    const size_t size = 1 + 4 * STRIDE + 24;
    char *points = malloc(size), *faces = malloc(1 + sizeof pyramid_faces);
    gusset_mesh_view mesh = pyramid(pyramid_up);
    const gusset_mesh_view down = pyramid(pyramid_down);
    gusset_mesh_view out = {sizeof out, NULL, 0, 0, NULL, NULL, 0, 0, 0, 0, 0, NULL};
    gusset_result *stitch = NULL;
    int i;
    CHECK(points != NULL && faces != NULL);
    if (points == NULL || faces == NULL) {
        return;
    }
    for (i = 0; i < 5; ++i) {
        memcpy(points + 1 + i * STRIDE, pyramid_up[i], 24);
    }
    memcpy(faces + 1, pyramid_faces, sizeof pyramid_faces);
    mesh.positions = points + 1, mesh.position_stride = STRIDE, mesh.face_corners = faces + 1;
    EXPECT(GUSSET_OK, gusset_stitch(context, &mesh, NULL, &down, NULL, NULL, &stitch));
    free(points);
    free(faces);
    EXPECT(GUSSET_OK, gusset_result_get_mesh(stitch, &out));
    CHECK(out.vertex_count == 10 && memcmp(out.positions, pyramid_up, sizeof pyramid_up) == 0);
    gusset_result_destroy(stitch);
}

/* A struct of a later version: accepted if what this one does not know is zero. */
static void later_versions(void) {
    struct {
        gusset_mesh_view view;
        uint64_t more[4];
    } later;
    gusset_boundary *boundary = NULL;
    memset(&later, 0, sizeof later);
    later.view = pyramid(pyramid_up);
    later.view.struct_size = sizeof later;
    EXPECT(GUSSET_OK, gusset_boundary_create(context, &later.view, NULL, &boundary));
    gusset_boundary_destroy(boundary);
    later.more[3] = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_boundary_create(context, &later.view, NULL, &boundary));
    CHECK(boundary == NULL);
}

static gusset_status status_inside;

/* Outputs are cleared even where the context is to blame. */
static void cleared_whatever(const gusset_context *refusing, gusset_status status) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    gusset_boundary *boundary = (gusset_boundary *)misaligned();
    gusset_result *stitch = (gusset_result *)misaligned();
    gusset_winged *winged = (gusset_winged *)misaligned();
    gusset_check *check = (gusset_check *)misaligned();
    gusset_facing *facing = (gusset_facing *)misaligned();
    EXPECT(status, gusset_boundary_create(refusing, &up, NULL, &boundary));
    EXPECT(status, gusset_stitch(refusing, &up, NULL, &down, NULL, NULL, &stitch));
    EXPECT(status, gusset_winged_create(refusing, &up, NULL, &winged));
    EXPECT(status, gusset_check_create(refusing, &up, &check));
    EXPECT(status, gusset_facing_create(refusing, pyramid_up[0], 5, pyramid_down[0], 5, NULL, &facing));
    CHECK(boundary == NULL && stitch == NULL && winged == NULL && check == NULL && facing == NULL);
}

static int call_again(void *user, double fraction, const char *stage) {
    const gusset_mesh_view mesh = pyramid(pyramid_up);
    gusset_boundary *boundary = NULL;
    (void)user, (void)fraction, (void)stage;
    status_inside = gusset_boundary_create(context, &mesh, NULL, &boundary);
    cleared_whatever(context, GUSSET_ERROR_CONTEXT_BUSY);
    return 0;
}

static void contexts(void) {
    gusset_context *other = (gusset_context *)misaligned();
    gusset_error_report report;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_context_create(NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_context_create(misaligned()));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_context_set_threads(NULL, 1));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_context_set_threads(misaligned(), 1));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_context_set_progress(NULL, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_context_set_progress(misaligned(), NULL, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_context_set_log(NULL, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_context_set_log(misaligned(), NULL, NULL));
    memset(&report, 0xff, sizeof report), report.struct_size = sizeof report;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_context_get_report(NULL, &report));
    CHECK(report.status == 0 && report.index == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_context_get_report(context, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_context_get_report(misaligned(), &report));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_context_get_report(context, misaligned()));
    report.struct_size = 4;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_context_get_report(context, &report));
    CHECK(strcmp(gusset_context_get_message(NULL), "") == 0 && strcmp(gusset_context_get_message(misaligned()), "") == 0);
    CHECK(gusset_context_get_progress(NULL) == 0.0 && gusset_context_get_progress(misaligned()) == 0.0);
    gusset_context_cancel(NULL);
    gusset_context_reset(NULL);
    gusset_context_cancel(misaligned());
    gusset_context_reset(misaligned());
    gusset_context_destroy(NULL);
    CHECK(strcmp(gusset_status_text(123456), "unknown status") == 0);
    CHECK(strcmp(gusset_choice_text("gusset_hole_status", 123456), "unknown value") == 0);
    CHECK(strcmp(gusset_choice_text("gusset_hole", GUSSET_HOLE_FILLED), "unknown value") == 0);
    CHECK(strcmp(gusset_choice_text("\xff", 0), "unknown value") == 0);
    CHECK(strcmp(gusset_choice_text(NULL, 0), "unknown value") == 0);

    EXPECT(GUSSET_OK, gusset_context_create(&other));
    cleared_whatever(misaligned(), GUSSET_ERROR_MISALIGNED_ARGUMENT);
    gusset_context_cancel(other);
    cleared_whatever(other, GUSSET_ERROR_CANCELLED);
    gusset_context_destroy(other);
    /* A call from within a call. */
    EXPECT(GUSSET_OK, gusset_context_set_progress(context, call_again, NULL));
    fit_for_more(context);
    CHECK(status_inside == GUSSET_ERROR_CONTEXT_BUSY);
    EXPECT(GUSSET_OK, gusset_context_set_progress(context, NULL, NULL));
}

int main(void) {
    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    meshes();
    boundary_pointers();
    table_pointers();
    odd_addresses();
    later_versions();
    contexts();
    fit_for_more(context);
    gusset_context_destroy(context);
    return failures != 0;
}
