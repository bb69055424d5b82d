// The same as app.c by the C++ wrapper, and an error that comes as an exception.
#include <gusset.hpp>

#include <array>
#include <cstdint>
#include <iostream>
#include <vector>

int main() {
    using Points = std::vector<std::array<double, 3>>;
    const Points up{{0, 0, 2}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
    const Points down{{0, 0, -2}, {1, 0, -1}, {0, -1, -1}, {-1, 0, -1}, {0, 1, -1}};
    const std::vector<std::uint32_t> faces{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1}, missing{0, 1, 5};
    const auto a = gusset::MeshView::triangles(up, faces), b = gusset::MeshView::triangles(down, faces);
    const gusset::Stitch stitch = gusset::stitch(a, b);
    const gusset::MeshView joined = stitch.mesh();
    std::cout << joined.vertex_count() << " vertices, " << joined.face_count() << " faces\n";
    try {
        gusset::stitch(a, gusset::MeshView::triangles(down, missing));
    } catch (const gusset::Error &error) {
        return error.status() != GUSSET_OK && joined.vertex_count() == 10 && joined.face_count() == 16 ? 0 : 1;
    }
    return 1;
}
