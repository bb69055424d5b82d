// Surfaces that tests share: nodes by formula, some in closed form.
#pragma once

#include <gusset.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace shapes {
using gusset::Point3;

constexpr double pi = 3.14159265358979323846;

inline double dot(const Point3 &a, const Point3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point3 minus(const Point3 &a, const Point3 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double distance(const Point3 &a, const Point3 &b) { return std::sqrt(dot(minus(a, b), minus(a, b))); }
/// Copies arrays of C structs.
inline Point3 of(const double (&p)[3]) { return {p[0], p[1], p[2]}; }

/// The torus with radii 1 and 0.4 about z; u is the angle around the tube. Normals point outwards.
inline Point3 torus(double u, double v) {
    const double ring = 1 + 0.4 * std::cos(2 * pi * u);
    return {ring * std::cos(2 * pi * v), -ring * std::sin(2 * pi * v), 0.4 * std::sin(2 * pi * u)};
}
/// How far a point is outside the torus.
inline double outside_torus(const Point3 &p) { return std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) - 0.4; }

/// The unit sphere from pole to pole.
inline Point3 sphere(double u, double v) {
    const double across = std::sin(pi * u);
    return {across * std::cos(2 * pi * v), across * std::sin(2 * pi * v), std::cos(pi * u)};
}

/// (rows + 1) x (columns + 1) nodes of a surface over the unit square; closed directions repeat
/// their first line to the bit.
template <class Function>
std::vector<Point3> nodes(std::size_t rows, std::size_t columns, bool closed_u, bool closed_v, Function &&surface) {
    std::vector<Point3> found;
    for (std::size_t i = 0; i <= rows; ++i) {
        for (std::size_t j = 0; j <= columns; ++j) {
            const std::size_t row = closed_u ? i % rows : i, column = closed_v ? j % columns : j;
            found.push_back(surface(double(row) / double(rows), double(column) / double(columns)));
        }
    }
    return found;
}

inline gusset::NodesOptions closed(bool u, bool v, gusset::Scheme scheme = gusset::Scheme::six_tap) {
    gusset::NodesOptions options;
    options.closed_u = u;
    options.closed_v = v;
    options.scheme = scheme;
    return options;
}
inline gusset::Sheet torus_sheet(std::size_t rows = 24, std::size_t columns = 40) {
    return gusset::Sheet::from_nodes(rows + 1, columns + 1, nodes(rows, columns, true, true, torus), closed(true, true));
}
inline gusset::Sheet sphere_sheet(std::size_t rows = 24, std::size_t columns = 40) {
    // Poles to the bit.
    const auto exact = [](double u, double v) { return u == 0 || u == 1 ? Point3{0, 0, u == 0 ? 1.0 : -1.0} : sphere(u, v); };
    return gusset::Sheet::from_nodes(rows + 1, columns + 1, nodes(rows, columns, false, true, exact), closed(false, true));
}
inline Point3 wave(double u, double v) { return {2 * u - 1, 2 * v - 1, 0.2 * std::sin(9 * u) * std::cos(7 * v + 1)}; }
inline gusset::Sheet wavy_sheet() { return gusset::Sheet::from_nodes(31, 37, nodes(30, 36, false, false, wave)); }

/// Points at random in a cube about the origin.
inline std::vector<Point3> random_points(std::size_t count, double half, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Point3> found(count);
    for (Point3 &p : found) {
        for (double &x : p) {
            x = half * (2 * (double(random()) / 4294967296.0) - 1);
        }
    }
    return found;
}

/// The length of a path.
inline double length(const gusset::SurfacePath &path) {
    double sum = 0;
    for (std::size_t k = 1; k < path.size(); ++k) {
        sum += distance(path.points[k - 1], path.points[k]);
    }
    return path.closed && path.size() > 1 ? sum + distance(path.points[path.size() - 1], path.points[0]) : sum;
}
} // namespace shapes
