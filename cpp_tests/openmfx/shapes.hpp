// Meshes made here, and what their faces make up.
#pragma once

#include "host.hpp"

#include <algorithm>
#include <cmath>

namespace mfx {

/// Points that faces use - edges + faces, and free edges.
struct Census {
    int euler, free_edges;
};

inline Census census(const MeshData &mesh) {
    std::map<std::pair<int, int>, int> edges;
    std::set<int> used;
    std::size_t start = 0;
    for (const int size : mesh.sizes) {
        for (int k = 0; k < size; ++k) {
            const int a = mesh.corners[start + static_cast<std::size_t>(k)],
                      b = mesh.corners[start + static_cast<std::size_t>((k + 1) % size)];
            used.insert(a);
            ++edges[std::minmax(a, b)];
        }
        start += static_cast<std::size_t>(size);
    }
    const auto free = std::count_if(edges.begin(), edges.end(), [](const auto &edge) { return edge.second == 1; });
    return {static_cast<int>(used.size()) - static_cast<int>(edges.size()) + static_cast<int>(mesh.sizes.size()),
            static_cast<int>(free)};
}

/// A tube of quads round the z axis, open at both ends.
inline MeshData tube(int sides, float low, float high) {
    MeshData mesh;
    for (const float z : {low, high}) {
        for (int side = 0; side < sides; ++side) {
            const double turn = 2 * 3.14159265358979 * side / sides;
            mesh.points.insert(mesh.points.end(),
                               {static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn)), z});
        }
    }
    for (int side = 0; side < sides; ++side) {
        const int next = (side + 1) % sides;
        mesh.corners.insert(mesh.corners.end(), {side, next, sides + next, sides + side});
        mesh.sizes.push_back(4);
    }
    return mesh;
}

/// A circle round the z axis, of edges.
inline MeshData ring(int sides) {
    MeshData mesh;
    for (int k = 0; k < sides; ++k) {
        const double turn = 2 * 3.14159265358979 * k / sides;
        mesh.points.insert(mesh.points.end(),
                           {static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn)), 0});
        mesh.corners.insert(mesh.corners.end(), {k, (k + 1) % sides});
    }
    mesh.sizes.assign(static_cast<std::size_t>(sides), 2);
    return mesh;
}

/// A cube whose faces have four points of their own each.
inline MeshData loose_cube() {
    MeshData mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            for (int k = 0; k < 4; ++k) {
                std::array<float, 3> point{};
                // Counter-clockwise from outside on both sides.
                const float u = (k == 1 || k == 2) ? 1.0f : -1.0f, v = k >= 2 ? 1.0f : -1.0f;
                point[static_cast<std::size_t>(axis)] = side;
                point[static_cast<std::size_t>((axis + 1) % 3)] = side > 0 ? u : v;
                point[static_cast<std::size_t>((axis + 2) % 3)] = side > 0 ? v : u;
                mesh.corners.push_back(mesh.point_count());
                mesh.points.insert(mesh.points.end(), point.begin(), point.end());
            }
            mesh.sizes.push_back(4);
        }
    }
    return mesh;
}

} // namespace mfx
