// Helpers of the tests of nets.
#pragma once

#include <gusset.hpp>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

using gusset::Net;
using gusset::Point3;
using gusset::Primitive;

inline const double pi = 3.14159265358979323846;

/// The status and the element of the error that a call throws; GUSSET_OK if it throws none.
struct Refusal {
    int32_t status = GUSSET_OK;
    gusset_element element = GUSSET_ELEMENT_NONE;
    uint64_t index = 0;
    bool has_sentence = false;
};
template <class Function>
Refusal refusal(Function &&function) {
    try {
        function();
    } catch (const gusset::Error &error) {
        return {error.status(), error.report().element, error.report().index, std::string(error.what()).size() > 10};
    }
    return {};
}

/// The same size, coordinates bit for bit, and gluing.
inline bool identical(const Net &a, const Net &b) {
    const auto same_seam = [](const gusset::Seam &p, const gusset::Seam &q) { return std::memcmp(&p, &q, sizeof p) == 0; };
    if (a.rows() != b.rows() || a.columns() != b.columns() || a.is_double() != b.is_double()) {
        return false;
    }
    const std::vector<Point3> p = a.points(), q = b.points();
    const auto s = a.seams(), t = b.seams();
    return std::memcmp(p.data(), q.data(), p.size() * sizeof p[0]) == 0 && a.matrix() == b.matrix() &&
           a.is_reversed() == b.is_reversed() && std::equal(s.begin(), s.end(), t.begin(), t.end(), same_seam);
}

inline Point3 operator-(const Point3 &a, const Point3 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double dot(const Point3 &a, const Point3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point3 cross(const Point3 &a, const Point3 &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point3 &a) { return std::sqrt(dot(a, a)); }
/// Between two directions, in degrees.
inline double angle(const Point3 &a, const Point3 &b) { return std::atan2(length(cross(a, b)), dot(a, b)) * 180.0 / pi; }

/// How far the nodes of two nets of one size are apart, at most.
inline double distance(const Net &a, const Net &b) {
    const auto p = a.points(), q = b.points();
    double worst = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        worst = std::max(worst, length(p[i] - q[i]));
    }
    return p.size() == q.size() ? worst : INFINITY;
}

/// A sheet of rows x columns nodes in the plane z = 0, one unit apart.
inline Net sheet(std::size_t rows, std::size_t columns, const gusset::Gluing &gluing = {}) {
    std::vector<Point3> points;
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            points.push_back({static_cast<double>(j), static_cast<double>(i), 0.0});
        }
    }
    return Net::from_points(rows, columns, points, gluing);
}

struct Named {
    std::string name;
    Primitive shape;
    long euler;
};
/// Every closed orientable shape.
inline std::vector<Named> closed_shapes() {
    using gusset::BoxKind;
    return {{"sphere", Primitive::sphere(1.5).with(17, 33), 2},
            {"sphere of one pole", Primitive::one_pole_sphere(1.5).with(17, 21), 2},
            {"cylinder", Primitive::cylinder(1.0, 3.0).with(9, 25), 2},
            {"prism", Primitive::prism(5, 1.0, 2.0).with(6, 6), 2},
            {"cone", Primitive::cone(1.0, 2.0).with(7, 25), 2},
            {"pyramid", Primitive::pyramid(4, 1.0, 2.0).with(5, 5), 2},
            {"lathe", Primitive::lathe({{0.0, -1.0}, {1.0, -0.8}, {0.5, 0.0}, {0.9, 0.6}, {0.0, 1.0}}).with(0, 17), 2},
            {"ring", Primitive::lathe({{1.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 0.0}}).with(0, 17), 0},
            {"torus", Primitive::torus(2.0, 0.5).with(17, 33), 0},
            {"box with slits", Primitive::box({1.0, 2.0, 3.0}, {3, 4, 5}), 2},
            {"box unwrapped crosswise", Primitive::box({1.0, 2.0, 3.0}, {3, 4, 5}, BoxKind::cross), 2},
            {"box of rings", Primitive::box({1.0, 2.0, 3.0}, {4, 4, 4}, BoxKind::concentric), 2},
            {"pillow", Primitive::pillow(2.0, 1.0, 0.5).with(9, 17), 2}};
}
