#include "mesh.hpp"

#include "../cpp/soup.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

Triangles read_triangles(const std::string &path) {
    const Soup soup = read_soup(path);
    if (soup.corners.size() != 3 * soup.face_count()) {
        throw std::runtime_error(path + " has faces that are no triangles");
    }
    return {soup.points, soup.corners};
}

Triangles without_slab(const Triangles &mesh, double low, double high) {
    double bottom = std::numeric_limits<double>::max(), top = std::numeric_limits<double>::lowest();
    for (const auto &p : mesh.points) {
        bottom = std::min(bottom, p[1]);
        top = std::max(top, p[1]);
    }
    Triangles open{mesh.points, {}};
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const uint32_t *c = &mesh.corners[3 * f];
        const double y = (mesh.points[c[0]][1] + mesh.points[c[1]][1] + mesh.points[c[2]][1]) / 3.0;
        const double part = (y - bottom) / (top - bottom);
        if (part <= low || part >= high) {
            open.corners.insert(open.corners.end(), c, c + 3);
        }
    }
    return open;
}

Triangles subdivided(Triangles mesh, int times) {
    for (; times > 0; --times) {
        // Edges by sorting: (smaller end, larger end) and the corner opposite which the edge lies.
        struct Side {
            uint64_t ends;
            uint32_t corner;
        };
        std::vector<Side> sides(mesh.corners.size());
        for (std::size_t c = 0; c < sides.size(); ++c) {
            const std::size_t f = c / 3 * 3;
            const uint64_t u = mesh.corners[f + (c + 1 - f) % 3], v = mesh.corners[f + (c + 2 - f) % 3];
            sides[c] = {std::min(u, v) << 32 | std::max(u, v), static_cast<uint32_t>(c)};
        }
        std::vector<uint32_t> order(sides.size());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
            return sides[a].ends != sides[b].ends ? sides[a].ends < sides[b].ends : a < b;
        });
        // The middle of each edge is numbered when the first face that has it comes, which keeps neighbours together.
        std::vector<uint32_t> first(sides.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            const bool same = i > 0 && sides[order[i]].ends == sides[order[i - 1]].ends;
            first[order[i]] = same ? first[order[i - 1]] : order[i];
        }
        std::vector<uint32_t> middle(sides.size());
        Triangles finer{std::move(mesh.points), {}};
        finer.corners.reserve(4 * mesh.corners.size());
        for (std::size_t c = 0; c < sides.size(); ++c) {
            if (first[c] != c) {
                middle[c] = middle[first[c]];
                continue;
            }
            middle[c] = static_cast<uint32_t>(finer.points.size());
            const auto &p = finer.points[sides[c].ends >> 32], &q = finer.points[sides[c].ends & UINT32_MAX];
            finer.points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
        }
        for (std::size_t f = 0; f < mesh.corners.size(); f += 3) {
            const uint32_t *v = &mesh.corners[f], *m = &middle[f];
            finer.corners.insert(finer.corners.end(),
                                 {v[0], m[2], m[1], m[2], v[1], m[0], m[1], m[0], v[2], m[0], m[1], m[2]});
        }
        mesh = std::move(finer);
    }
    return mesh;
}

Triangles shuffled(const Triangles &mesh) {
    std::mt19937 random(12345);
    std::vector<uint32_t> vertex(mesh.points.size()), face(mesh.face_count());
    std::iota(vertex.begin(), vertex.end(), 0u);
    std::iota(face.begin(), face.end(), 0u);
    std::shuffle(vertex.begin(), vertex.end(), random);
    std::shuffle(face.begin(), face.end(), random);
    Triangles mixed{std::vector<std::array<double, 3>>(mesh.points.size()), {}};
    for (std::size_t v = 0; v < vertex.size(); ++v) {
        mixed.points[vertex[v]] = mesh.points[v];
    }
    mixed.corners.reserve(mesh.corners.size());
    for (uint32_t f : face) {
        for (std::size_t k = 0; k < 3; ++k) {
            mixed.corners.push_back(vertex[mesh.corners[3 * f + k]]);
        }
    }
    return mixed;
}
