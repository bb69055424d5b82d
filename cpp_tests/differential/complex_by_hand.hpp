// The cell complex of glued nets by union-find and by counting cells.
#pragma once

#include <gusset.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace campaign::of_gluings {
using Edge = std::pair<uint32_t, uint32_t>;

/// Classes of glued nodes, and the gluings that made them.
struct Classes {
    uint32_t rows, columns;
    std::vector<uint32_t> parent;

    Classes(std::size_t h, std::size_t w) : rows(static_cast<uint32_t>(h)), columns(static_cast<uint32_t>(w)), parent(h * w) {
        std::iota(parent.begin(), parent.end(), 0u);
    }
    uint32_t node(std::size_t i, std::size_t j) const { return static_cast<uint32_t>(i * columns + j); }
    uint32_t find(uint32_t v) const {
        for (; parent[v] != v; v = parent[v]) {
        }
        return v;
    }
    void unite(uint32_t a, uint32_t b) {
        a = find(a), b = find(b);
        parent[std::max(a, b)] = std::min(a, b);
    }
    void link(uint32_t number) {
        const uint32_t v = number / 2, i = v / columns, j = v % columns;
        unite(v, number % 2 == 0 ? node(i, (j + 1) % columns) : node((i + 1) % rows, j));
    }
    void sides(uint32_t bits) {
        for (uint32_t i = 0; i < rows; ++i) {
            bits & GUSSET_SIDES_ROWS_CLOSED ? unite(node(i, 0), node(i, columns - 1)) : void();
            bits & GUSSET_SIDES_POLE_LEFT ? unite(node(0, 0), node(i, 0)) : void();
            bits & GUSSET_SIDES_POLE_RIGHT ? unite(node(0, columns - 1), node(i, columns - 1)) : void();
        }
        for (uint32_t j = 0; j < columns; ++j) {
            bits & GUSSET_SIDES_COLUMNS_CLOSED ? unite(node(0, j), node(rows - 1, j)) : void();
            bits & GUSSET_SIDES_POLE_TOP ? unite(node(0, 0), node(0, j)) : void();
            bits & GUSSET_SIDES_POLE_BOTTOM ? unite(node(rows - 1, 0), node(rows - 1, j)) : void();
        }
    }
    /// The nodes of place k of both runs.
    void seam(const gusset::Seam &seam, std::size_t k) {
        const auto at = [&](uint32_t row, uint32_t column, int32_t i, int32_t j) {
            return node(static_cast<uint32_t>(static_cast<int64_t>(row) + static_cast<int64_t>(k) * i), static_cast<uint32_t>(static_cast<int64_t>(column) + static_cast<int64_t>(k) * j));
        };
        unite(at(seam.row_a, seam.column_a, seam.row_step_a, seam.column_step_a), at(seam.row_b, seam.column_b, seam.row_step_b, seam.column_step_b));
    }
    void seam(const gusset::Seam &one) {
        for (std::size_t k = 0; k < one.count; ++k) {
            seam(one, k);
        }
    }
    std::vector<uint32_t> list() const {
        std::vector<uint32_t> found(parent.size());
        for (uint32_t v = 0; v < found.size(); ++v) {
            found[v] = find(v);
        }
        return found;
    }
    std::array<uint32_t, 4> corners(uint32_t i, uint32_t j) const {
        return {find(node(i, j)), find(node(i, j + 1)), find(node(i + 1, j + 1)), find(node(i + 1, j))};
    }
    /// Both pairs of opposite corners of a cell are one each, and no surface.
    bool has_crossing() const {
        for (uint32_t i = 0; i + 1 < rows; ++i) {
            for (uint32_t j = 0; j + 1 < columns; ++j) {
                const auto c = corners(i, j);
                if (c[0] == c[2] && c[1] == c[3] && c[0] != c[1]) {
                    return true;
                }
            }
        }
        return false;
    }
};

/// The complex by hand.
struct ByHand {
    std::size_t vertices = 0, edges = 0, quads = 0, triangles = 0, digons = 0, points = 0, folds = 0, boundary = 0;
    std::vector<Edge> wires, branches, conflicts, rim;
    std::vector<uint32_t> pinches;
    bool orientable = true;

    explicit ByHand(const Classes &classes) {
        const std::vector<uint32_t> list = classes.list();
        vertices = std::set<uint32_t>(list.begin(), list.end()).size();
        std::map<Edge, std::vector<std::pair<uint32_t, bool>>> sides;
        for (uint32_t i = 0; i < classes.rows; ++i) {
            for (uint32_t j = 0; j < classes.columns; ++j) {
                const uint32_t v = list[classes.node(i, j)];
                for (uint32_t w : {j + 1 < classes.columns ? list[classes.node(i, j + 1)] : v, i + 1 < classes.rows ? list[classes.node(i + 1, j)] : v}) {
                    if (v != w) {
                        sides[std::minmax(v, w)];
                    }
                }
            }
        }
        std::map<uint32_t, std::vector<Edge>> links;
        uint32_t faces = 0;
        for (uint32_t i = 0; i + 1 < classes.rows; ++i) {
            for (uint32_t j = 0; j + 1 < classes.columns; ++j) {
                std::vector<uint32_t> face;
                for (uint32_t v : classes.corners(i, j)) {
                    if (face.empty() || face.back() != v) {
                        face.push_back(v);
                    }
                }
                while (face.size() > 1 && face.back() == face.front()) {
                    face.pop_back();
                }
                const std::size_t n = face.size(), different = std::set<uint32_t>(face.begin(), face.end()).size();
                (n != different ? folds : n == 4 ? quads : n == 3 ? triangles : n == 2 ? digons : points) += 1;
                if (n != different || n < 3) {
                    continue;
                }
                for (std::size_t k = 0; k < n; ++k) {
                    const uint32_t before = face[(k + n - 1) % n], v = face[k], after = face[(k + 1) % n];
                    sides[std::minmax(v, after)].emplace_back(faces, v < after);
                    links[v].emplace_back(before, after);
                }
                ++faces;
            }
        }
        edges = sides.size();
        count_edges(sides, faces);
        for (const auto &[v, arcs] : links) {
            if (fans(arcs) > 1) {
                pinches.push_back(v);
            }
        }
    }
    long euler() const { return static_cast<long>(vertices + quads + triangles) - static_cast<long>(edges); }
    bool is_manifold() const { return wires.empty() && branches.empty() && pinches.empty(); }

private:
    void count_edges(const std::map<Edge, std::vector<std::pair<uint32_t, bool>>> &sides, uint32_t faces) {
        std::vector<std::vector<std::pair<uint32_t, bool>>> beside(faces);
        for (const auto &[edge, both] : sides) {
            switch (both.size()) {
            case 0: wires.push_back(edge); break;
            case 1: rim.push_back(both[0].second ? edge : Edge{edge.second, edge.first}); break;
            case 2:
                if (both[0].second == both[1].second) {
                    conflicts.push_back(edge);
                }
                beside[both[0].first].emplace_back(both[1].first, both[0].second == both[1].second);
                beside[both[1].first].emplace_back(both[0].first, both[0].second == both[1].second);
                break;
            default: branches.push_back(edge);
            }
        }
        boundary = rim.size();
        // Sides by a search from face to face.
        std::vector<int> side(faces, -1);
        for (uint32_t start = 0; start < faces; ++start) {
            if (side[start] != -1) {
                continue;
            }
            side[start] = 0;
            std::vector<uint32_t> open{start};
            while (!open.empty()) {
                const uint32_t f = open.back();
                open.pop_back();
                for (const auto &[other, against] : beside[f]) {
                    const int wanted = against ? 1 - side[f] : side[f];
                    if (side[other] == -1) {
                        side[other] = wanted;
                        open.push_back(other);
                    }
                    orientable = orientable && side[other] == wanted;
                }
            }
        }
    }
    static std::size_t fans(const std::vector<Edge> &arcs) {
        std::map<uint32_t, uint32_t> parent;
        const auto root = [&](uint32_t v) {
            for (parent.emplace(v, v); parent[v] != v;) {
                v = parent[v];
            }
            return v;
        };
        for (const auto &[a, b] : arcs) {
            const uint32_t from = root(a), to = root(b);
            parent[from] = to;
        }
        return static_cast<std::size_t>(std::count_if(parent.begin(), parent.end(), [](const auto &entry) { return entry.first == entry.second; }));
    }
};
} // namespace campaign::of_gluings
