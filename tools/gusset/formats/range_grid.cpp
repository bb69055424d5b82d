#include "range_grid.hpp"

#include <algorithm>
#include <cmath>

namespace {
constexpr double max_edge_ratio = 4;

using Triangle = std::array<uint32_t, 3>;

double length(const Mesh &mesh, uint32_t u, uint32_t v) {
    const Point &p = mesh.points[u], &q = mesh.points[v];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// Scanners also say by NaN that nothing was seen.
bool is_finite(const Point &p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

double longest(const Mesh &mesh, const Triangle &t) {
    return std::max({length(mesh, t[0], t[1]), length(mesh, t[1], t[2]), length(mesh, t[2], t[0])});
}
} // namespace

void add_range_faces(Mesh &mesh, const std::vector<uint32_t> &grid, std::size_t columns) {
    std::vector<Triangle> triangles;
    for (std::size_t below = columns; below < grid.size(); below += columns) {
        for (std::size_t j = 1; j < columns; ++j) {
            const std::size_t above = below - columns;
            std::vector<uint32_t> seen;
            for (const std::size_t place : {above + j - 1, above + j, below + j, below + j - 1}) {
                if (grid[place] != unseen && is_finite(mesh.points[grid[place]])) {
                    seen.push_back(grid[place]);
                }
            }
            if (seen.size() == 4 && length(mesh, seen[0], seen[2]) <= length(mesh, seen[1], seen[3])) {
                triangles.push_back({seen[0], seen[1], seen[2]});
                triangles.push_back({seen[0], seen[2], seen[3]});
            } else if (seen.size() == 4) {
                triangles.push_back({seen[0], seen[1], seen[3]});
                triangles.push_back({seen[1], seen[2], seen[3]});
            } else if (seen.size() == 3) {
                triangles.push_back({seen[0], seen[1], seen[2]});
            }
        }
    }
    if (triangles.empty()) {
        return;
    }
    std::vector<double> lengths;
    for (const Triangle &t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double side = length(mesh, t[k], t[(k + 1) % 3]);
            if (side > 0) {
                lengths.push_back(side);
            }
        }
    }
    if (lengths.empty()) {
        return;
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    for (const Triangle &t : triangles) {
        if (longest(mesh, t) <= max_edge_ratio * *middle) {
            mesh.add_face({t[0], t[1], t[2]});
        }
    }
}
