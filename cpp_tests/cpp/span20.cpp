// std::span of C++20 wherever the wrapper takes or lends a range.
#include <gusset.hpp>

#include <span>

int main() {
    const double numbers[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const int indices[] = {0, 1, 2};
    const std::array<double, 3> rows[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::span<const double> flat(numbers);
    const std::span<const int> corners(indices);
    const std::span<const std::array<double, 3>> points(rows);
    const gusset::MeshView a = gusset::MeshView::triangles(flat, corners), b = gusset::MeshView::triangles(points, corners);
    const std::span<const gusset::Point3> lent(b.positions());
    const std::span<const uint32_t> vertices(b.corners());
    const bool same = a.position(2) == b.position(2) && lent[1][0] == 1 && vertices[2] == 2;
    return same && gusset::Boundary(a)[0].vertices.size() == 3 ? 0 : 1;
}
