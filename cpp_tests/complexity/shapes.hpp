// Families of hostile inputs, each of any size.
#ifndef COMPLEXITY_SHAPES_HPP
#define COMPLEXITY_SHAPES_HPP

#include <gusset.hpp>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace complexity {

using gusset::Point3;
constexpr double turn = 6.283185307179586;

/// Triangles in memory of their own.
struct Mesh {
    std::vector<Point3> points;
    std::vector<uint32_t> corners;

    gusset::MeshView view() const { return gusset::MeshView::triangles(points, corners); }
    void triangle(uint32_t a, uint32_t b, uint32_t c) { corners.insert(corners.end(), {a, b, c}); }
    /// Another mesh beside this one, at a place.
    void add(const Mesh &other, const Point3 &at = {});
};

/// n faces around one vertex, with a rim of n or n + 1.
Mesh fan(std::size_t n, bool closed);
/// Triangles that have one vertex in common, and no edge: n loops at one vertex.
Mesh bundle(std::size_t n);
/// n triangles without anything in common: n loops; or n whose corners all lie in one point.
Mesh scattered(std::size_t n, bool in_one_point);
/// n thin closed plates of 12 triangles, one above the other.
Mesh plates(std::size_t n);
/// n times the same triangle, on vertices of its own each time.
Mesh copies(std::size_t n);
/// A square of about n faces, flat or with heights by chance.
Mesh square(std::size_t n, double roughness);
/// About n faces round a tube, or a torus, its vertices numbered ring after ring: 126 rings, a number that many others divide.
Mesh rings(std::size_t n, bool closed);
/// A ring of 2 n faces between the rim and what lies behind it.
Mesh shell(const std::vector<Point3> &rim, const Point3 &behind, double scale = 1.0);
/// Rims of n points: a circle, a line traced in both directions, a spiral traced in both directions, one point, and a
/// star with further stars in its bays.
std::vector<Point3> circle(std::size_t n, double radius, double height);
std::vector<Point3> collinear(std::size_t n);
std::vector<Point3> spiral(std::size_t n, double height);
std::vector<Point3> point(std::size_t n, const Point3 &at);
std::vector<Point3> nested_star(std::size_t n, double height);

/// The controls of curves of a degree; a spline through nodes has degree 5.
gusset::Curve curve_of(const std::vector<Point3> &points, uint32_t degree, bool closed = false);

/// Nodes of grids with about n cells: flat, by chance, on a sphere round the origin, all in one point.
struct Grid {
    std::size_t rows, columns;
    std::vector<Point3> points;
};
Grid plane_grid(std::size_t n, double height = 0);
Grid random_grid(std::size_t n, uint32_t seed, double roughness);
Grid sphere_grid(std::size_t n);
Grid point_grid(std::size_t n);
gusset::Sheet sheet_of(const Grid &grid);

} // namespace complexity

#endif // COMPLEXITY_SHAPES_HPP
