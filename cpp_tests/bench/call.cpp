// How long a call with little to do takes: one triangle is checked. Prints microseconds, the median of several runs.
#include <gusset.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

int main() {
    const std::array<double, 9> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::array<uint32_t, 3> corners{0, 1, 2};
    gusset_mesh_view mesh{};
    mesh.struct_size = sizeof mesh;
    mesh.positions = positions.data();
    mesh.vertex_count = 3;
    mesh.face_corners = corners.data();
    mesh.face_count = 1;
    mesh.scalar = GUSSET_F64;
    mesh.face_size = 3;
    gusset_context *context = nullptr;
    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    constexpr int calls = 20000;
    std::array<double, 9> times{};
    for (double &time : times) {
        const auto start = std::chrono::steady_clock::now();
        for (int k = 0; k < calls; ++k) {
            gusset_check *check = nullptr;
            if (gusset_check_create(context, &mesh, &check) != GUSSET_OK) {
                return 1;
            }
            gusset_check_destroy(check);
        }
        time = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count() / calls;
    }
    std::sort(times.begin(), times.end());
    std::printf("%.4f\n", times[times.size() / 2]);
    gusset_context_destroy(context);
    return 0;
}
