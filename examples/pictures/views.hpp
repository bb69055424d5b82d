// Range images of a body from several sides, each in a slightly displaced frame.
#pragma once

#include "shapes.hpp"

namespace pictures {
/// How far the body's surface is from its middle in a direction.
inline double radius_of(const Point3 &d) {
    return 1 + 0.16 * std::sin(2.6 * d[0] + 0.4) * std::cos(2.2 * d[1]) + 0.14 * std::sin(3.1 * d[2] - 1.2 * d[0] + 0.7) + 0.1 * d[0] * d[1];
}

/// Where a ray against `from` meets the body first; NaN if it passes by.
inline Point3 seen(const Point3 &start, const Point3 &from) {
    const auto outside = [&](double t) {
        const Point3 p{start[0] - t * from[0], start[1] - t * from[1], start[2] - t * from[2]};
        return std::sqrt(dot(p, p)) - radius_of(unit(p));
    };
    double before = 0, step = 0.01;
    while (before < 4 && outside(before + step) > 0) {
        before += step;
    }
    if (before >= 4) {
        return {NAN, NAN, NAN};
    }
    double low = before, high = before + step;
    for (int halved = 0; halved < 40; ++halved) {
        const double middle = (low + high) / 2;
        (outside(middle) > 0 ? low : high) = middle;
    }
    return {start[0] - low * from[0], start[1] - low * from[1], start[2] - low * from[2]};
}

/// The range image from a direction, n x n pixels, as a net whose missing nodes are those where nothing was seen.
inline gusset::Net range_image(const Point3 &from, std::size_t n) {
    const Point3 towards = unit(from), right = unit(cross(std::abs(towards[2]) < 0.9 ? Point3{0, 0, 1} : Point3{1, 0, 0}, towards)),
                 up = cross(towards, right);
    std::vector<Point3> points;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const double x = 3.0 * static_cast<double>(j) / static_cast<double>(n - 1) - 1.5, y = 3.0 * static_cast<double>(i) / static_cast<double>(n - 1) - 1.5;
            points.push_back(seen({2 * towards[0] + x * right[0] + y * up[0], 2 * towards[1] + x * right[1] + y * up[1],
                                   2 * towards[2] + x * right[2] + y * up[2]}, towards));
        }
    }
    return gusset::Net::from_points(n, n, points);
}

/// The small rotation about a slanted axis, and the shift, of view k.
inline gusset::Transform misplaced(std::size_t k) {
    const double angle = k == 0 ? 0 : 0.07, phase = 1.3 * static_cast<double>(k);
    const Point3 axis = unit({std::sin(phase), std::cos(2 * phase), std::cos(phase)});
    const double s = std::sin(angle), c = std::cos(angle), shift = k == 0 ? 0 : 0.08;
    gusset::Transform made{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const double across = i == j ? 0 : ((j + 3 - i) % 3 == 1 ? -1 : 1) * axis[3 - i - j];
            made.rows[4 * i + j] = (i == j ? c : 0) + s * across + (1 - c) * axis[i] * axis[j];
        }
        made.rows[4 * i + 3] = shift * axis[(i + 1) % 3];
    }
    return made;
}

inline void move(std::vector<Point3> &points, const gusset::Transform &by) {
    for (Point3 &p : points) {
        const Point3 was = p;
        for (std::size_t k = 0; k < 3; ++k) {
            const double *row = by.rows + 4 * k;
            p[k] = row[0] * was[0] + row[1] * was[1] + row[2] * was[2] + row[3];
        }
    }
}

/// Five views of the body, all displaced except the first.
inline std::vector<Mesh> misplaced_views() {
    gusset::NetMeshOptions triangles;
    triangles.faces = gusset::NetFaces::triangles_shorter;
    triangles.fill_corners = true;
    triangles.max_edge_ratio = 4;
    std::vector<Mesh> views;
    for (const Point3 &from : {Point3{0.9, -1, 0.4}, Point3{-0.8, -0.7, 0.5}, Point3{0.2, 1, 0.6}, Point3{0.5, 0.2, -1}, Point3{-0.7, 0.1, -0.7}}) {
        const gusset::NetMesh made(range_image(from, 37), triangles);
        Mesh view;
        for (std::size_t v = 0; v < made.mesh().vertex_count(); ++v) {
            view.points.push_back(made.mesh().position(v));
        }
        for (std::size_t f = 0; f < made.mesh().face_count(); ++f) {
            for (const uint32_t v : made.mesh().face(f)) {
                view.corners.push_back(v);
            }
        }
        move(view.points, misplaced(views.size()));
        views.push_back(std::move(view));
    }
    return views;
}
} // namespace pictures
