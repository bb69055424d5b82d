// The common part of the surface benchmarks: surfaces by formula with their nodes, triangles and splines, the
// queries, and the contenders.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace surface {
using Point = std::array<double, 3>;
using Points = std::vector<Point>;

inline Point operator+(const Point &a, const Point &b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator-(const Point &a, const Point &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point operator*(double s, const Point &a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point &a, const Point &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Point &a);

/// A surface by formula, over the unit square; closed both ways or open.
struct Surface {
    bool closed = false;
    Point low{}, high{};
    std::function<Point(double, double)> at;
    /// How far a point that is near the surface is from it.
    std::function<double(const Point &)> off;
    /// The least distance from a query; a foot that somebody found may be a start.
    std::function<double(const Point &query, const Point &foot)> distance;
    /// A function that vanishes on it, and its gradient; how fast the function grows at most, and its slope near the surface.
    std::function<std::pair<double, Point>(const Point &)> implicit;
    double growth = 1, bend = 1;

    double size() const { return length(high - low); }
};

/// Around the axis z, of radii 1 and 0.4, moved.
Surface torus(const Point &centre = {});
/// z = 0.2 sin 5x cos 4y over a square of side 2.
Surface waves();

/// Nodes row by row. On a closed surface, the last row and column repeat the first.
struct Nodes {
    std::size_t rows = 0, columns = 0;
    bool closed = false;
    Points points;
};

Nodes nodes(const Surface &surface, std::size_t rows, std::size_t columns);

/// Every cell as two triangles; each point is there once.
struct Triangles {
    Points points;
    std::vector<uint32_t> corners;
};

Triangles triangles(const Nodes &nodes);

/// A bicubic tensor spline with simple inner knots, clamped: C2. Every kernel of CAD takes it.
struct Spline {
    std::size_t rows = 0, columns = 0;
    std::vector<double> u_knots, v_knots;
    Points controls;
};

/// Through the nodes of a closed surface, C2 across its seams too.
Spline spline(const Nodes &nodes);

// Questions.

struct Line {
    /// Before the surface: a line is the ray from here, too.
    Point origin;
    Point direction;
};

struct Plane {
    Point origin;
    Point normal;
};

/// Within 0.02 of the surface, or rather in cubes of that half side about its points.
Points near_queries(const Surface &surface, std::size_t count);
/// In the box of the surface, doubled.
Points far_queries(const Surface &surface, std::size_t count);
/// Through two points in the box of the surface.
std::vector<Line> lines(const Surface &surface, std::size_t count);
/// The same in Morton's order.
Points sorted(const Points &queries);

/// How often a line really crosses the surface.
std::size_t crossings(const Surface &surface, const Line &line);

// Answers.

/// The answers of query k are points[ends[k - 1]] up to points[ends[k]].
struct Hits {
    std::vector<std::size_t> ends;
    Points points;

    void clear();
};

/// Curves: as above, the ends of each, and whether it is closed.
struct Polylines {
    std::vector<std::size_t> ends;
    std::vector<bool> closed;
    Points points;
    /// Segments in no order are not, however many there are.
    bool ordered = true;
    /// Curves of another kind, looked at here and there: chords between these points are nobody's.
    bool sampled = false;
    /// How many places it could not resolve, if it says such things.
    std::optional<std::size_t> unresolved;

    void clear();
};

/// Someone who can be asked. Not everybody can everything.
class Solver {
public:
    Solver() = default;
    Solver(const Solver &) = delete;
    Solver &operator=(const Solver &) = delete;
    virtual ~Solver() = default;

    /// The surface in the form that is natural to take, which is not timed.
    virtual void prepare() {}
    /// From there to where questions can be asked.
    virtual void build() = 0;
    /// The bytes of the index, from one who allocates past malloc.
    virtual std::size_t bytes() const { return 0; }
    virtual void closest(const Points &queries, Points &feet);
    /// Number of nearest points in the last answer that are not reported as proven, if the contender reports proofs.
    virtual std::optional<std::vector<std::size_t>> unproven() const { return {}; }
    /// All intersections.
    virtual void lines(const std::vector<Line> &lines, Hits &hits);
    /// The first of each ray.
    virtual void rays(const std::vector<Line> &rays, Hits &hits);
    /// The data needed once for planes, and a section.
    virtual void prepare_planes() {}
    virtual void plane(const Plane &plane, Polylines &curves);
    /// With another surface of the same solver.
    virtual void meet(Solver &other, Polylines &curves);
};

std::unique_ptr<Solver> cgal(const Triangles &triangles, bool with_points = true);
/// Plane sections as segments without order, from the tree of triangles.
std::unique_ptr<Solver> cgal_segments(const Triangles &triangles);
std::unique_ptr<Solver> embree(const Triangles &triangles, unsigned threads);
std::unique_ptr<Solver> parry(const Triangles &triangles);
std::unique_ptr<Solver> occt(const Spline &spline);
/// The torus itself, not through nodes.
std::unique_ptr<Solver> occt_torus(const Point &centre);
std::unique_ptr<Solver> sisl(const Spline &spline);
/// 0 threads: as many as the machine has. Curves keep to the surface within `chord`; 0: points are where they cross sides of cells.
std::unique_ptr<Solver> gusset(const Nodes &nodes, unsigned threads, double chord = 0);
std::unique_ptr<Solver> gusset(const Spline &spline, unsigned threads, double chord = 0);
} // namespace surface
