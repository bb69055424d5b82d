/* Handles in the place of others: a status, and nothing is read or freed as what it is not. */
#include "check.h"

static gusset_context *context;

/* Handles of other kinds, which compilers of C only warn of, and which bindings of other languages may mix up. */
static void wrong_handles(void) {
    const gusset_mesh_view mesh = pyramid(pyramid_up);
    gusset_check_view check = {0};
    gusset_boundary *boundary = NULL;
    gusset_net *copy = NULL;
    check.struct_size = sizeof check;
    EXPECT(GUSSET_OK, gusset_boundary_create(context, &mesh, NULL, &boundary));
    void *const wrong = boundary;
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_check_get_view(wrong, &check));
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_context_set_threads(wrong, 1));
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_boundary_create(wrong, &mesh, NULL, (gusset_boundary **)&copy));
    CHECK(copy == NULL);
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_net_clone_create(context, wrong, &copy));
    CHECK(copy == NULL && strcmp(gusset_context_get_message(context), "net is no live gusset_net") == 0);
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_net_displace(context, wrong, 1.0));
    CHECK(gusset_boundary_loop_count((void *)context) == 0);
    /* They are not destroyed as what they are not. */
    gusset_net_destroy(wrong);
    gusset_context_destroy(wrong);
    gusset_context_cancel(wrong);
    CHECK(gusset_boundary_loop_count(boundary) == 1);
    gusset_boundary_destroy(boundary);
}

int main(void) {
    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    wrong_handles();
    gusset_context_destroy(context);
    return failures != 0;
}
