/* Shared by the C tests: a check that counts failures, and a mesh by hand. */
#ifndef CHECK_H
#define CHECK_H

#include <gusset.h>
#include <stdio.h>
#include <string.h>

static int failures;

#define CHECK(condition)                                                                                               \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            printf("%s:%d: %s\n", __FILE__, __LINE__, #condition);                                                     \
            ++failures;                                                                                                \
        }                                                                                                              \
    } while (0)

/* The call returns this status. */
#define EXPECT(expected, call)                                                                                         \
    do {                                                                                                               \
        const gusset_status got_ = (call);                                                                             \
        if (got_ != (expected)) {                                                                                      \
            printf("%s:%d: %s\n  gives %d (%s), not %s\n", __FILE__, __LINE__, #call, (int)got_,                       \
                   gusset_status_text(got_), #expected);                                                               \
            ++failures;                                                                                                \
        }                                                                                                              \
    } while (0)

/* An address that no struct of ours may have. */
static inline void *misaligned(void) {
    static double room[64];
    return (char *)room + 1;
}

/* Compares the report of the last call of a context with the expected one. */
static inline void expect_report(int line, const char *file, const gusset_context *context, int32_t status,
                                 gusset_element element, uint64_t index, uint32_t input) {
    gusset_error_report report = {sizeof report, 0, 0, 0, 0.0, 0, 0};
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    if (report.status != status || report.element != element || report.index != index || report.input != input) {
        printf("%s:%d: report says %d %u %lu %u\n", file, line, (int)report.status, (unsigned)report.element,
               (unsigned long)report.index, (unsigned)report.input);
        ++failures;
    }
}

#define REPORT(context, status, element, index, input)                                                                 \
    expect_report(__LINE__, __FILE__, context, status, element, index, input)

/* A call that must fail, and leave NULL where its result would have gone. */
#define FAILS(expected, out, call)                                                                                     \
    do {                                                                                                               \
        (out) = misaligned();                                                                                          \
        EXPECT(expected, call);                                                                                        \
        CHECK((out) == NULL);                                                                                          \
    } while (0)

/* An open pyramid: apex 0, rim 1 2 3 4, faces counter-clockwise from above. */
static const double pyramid_up[5][3] = {{0, 0, 2}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
/* The same seen in a mirror below: apex 0, rim 1 2 3 4, faces counter-clockwise from outside too. */
static const double pyramid_down[5][3] = {{0, 0, -2}, {1, 0, -1}, {0, -1, -1}, {-1, 0, -1}, {0, 1, -1}};
static const uint32_t pyramid_faces[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};

static inline gusset_mesh_view pyramid(const double points[5][3]) {
    return gusset_triangles_f64(points[0], 5, pyramid_faces, 4);
}

static inline gusset_boundary_view loops_of(const gusset_boundary *boundary) {
    gusset_boundary_view view = {sizeof view, 0, 0, NULL, 0};
    EXPECT(GUSSET_OK, gusset_boundary_get_view(boundary, &view));
    return view;
}

/* The context still works, and its report tells of the last call. */
static inline void fit_for_more(const gusset_context *context) {
    const gusset_mesh_view mesh = pyramid(pyramid_up);
    gusset_boundary *boundary = NULL;
    EXPECT(GUSSET_OK, gusset_boundary_create(context, &mesh, NULL, &boundary));
    CHECK(loops_of(boundary).loop_count == 1);
    gusset_boundary_destroy(boundary);
}

#endif
