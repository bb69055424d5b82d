// A mesh as CGAL's functions for polygon soups take it.
#pragma once

#include <gusset.hpp>

#include <cstddef>
#include <vector>

template <class Point>
struct CgalSoup {
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> faces;

    explicit CgalSoup(const gusset::MeshView &view) {
        for (std::size_t v = 0; v < view.vertex_count(); ++v) {
            const auto p = view.position(v);
            points.emplace_back(p[0], p[1], p[2]);
        }
        for (std::size_t f = 0; f < view.face_count(); ++f) {
            faces.emplace_back(view.face(f).begin(), view.face(f).end());
        }
    }
};
