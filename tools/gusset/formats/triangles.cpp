#include "triangles.hpp"

namespace {
Point minus(const Point &a, const Point &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point &a, const Point &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Point &a, const Point &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
} // namespace

std::size_t fan_corner(const Mesh &mesh, std::size_t face, std::optional<uint32_t> avoid) {
    const std::size_t degree = mesh.degree(face);
    const uint32_t *vertices = mesh.corners.data() + mesh.offsets[face];
    const auto point = [&](std::size_t k) -> const Point & { return mesh.points[vertices[k % degree]]; };
    const auto area = [&](std::size_t a, std::size_t b, std::size_t c) {
        return cross(minus(point(b), point(a)), minus(point(c), point(a)));
    };
    Point whole{};
    for (std::size_t k = 1; k + 1 < degree; ++k) {
        const Point part = area(0, k, k + 1);
        for (std::size_t i = 0; i < 3; ++i) {
            whole[i] += part[i];
        }
    }
    std::optional<std::size_t> allowed;
    for (std::size_t start = 0; start < degree; ++start) {
        if (avoid && vertices[start] == *avoid) {
            continue;
        }
        allowed = allowed ? allowed : start;
        bool covers = true;
        for (std::size_t k = 1; covers && k + 1 < degree; ++k) {
            covers = dot(area(start, start + k, start + k + 1), whole) >= 0;
        }
        if (covers) {
            return start;
        }
    }
    return allowed.value_or(0);
}
