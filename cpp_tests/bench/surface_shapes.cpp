// Surfaces by formula, their nodes, triangles and splines, and the questions about them.
#include "surface.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace surface {
namespace {
constexpr double TURN = 6.283185307179586477;

double wave(double x, double y) { return 0.2 * std::sin(5 * x) * std::cos(4 * y); }
double wave_x(double x, double y) { return std::cos(5 * x) * std::cos(4 * y); }
double wave_y(double x, double y) { return -0.8 * std::sin(5 * x) * std::sin(4 * y); }

/// The distance from the waves: descent from the foot by Newton's method over the square, with steps halved until they help.
double distance_of_waves(const Point &q, const Point &foot) {
    const auto within = [](double x) { return std::clamp(x, -1.0, 1.0); };
    const auto square = [&](double x, double y) { return dot(Point{x, y, wave(x, y)} - q, Point{x, y, wave(x, y)} - q); };
    double x = within(foot[0]), y = within(foot[1]), best = square(x, y);
    for (int step = 0; step < 30; ++step) {
        const double z = wave(x, y), fx = wave_x(x, y), fy = wave_y(x, y), h = z - q[2];
        const double gx = x - q[0] + h * fx, gy = y - q[1] + h * fy;
        double a = 1 + fx * fx - 25 * h * z, c = 1 + fy * fy - 16 * h * z, b = fx * fy - 4 * h * std::cos(5 * x) * std::sin(4 * y);
        if (a <= 0 || a * c <= b * b) {
            a = c = 1 + std::abs(h) * 25;
            b = 0;
        }
        // At a side of the square only along it.
        const bool fixed_x = std::abs(x) == 1 && gx * x < 0, fixed_y = std::abs(y) == 1 && gy * y < 0;
        double dx = 0, dy = 0;
        if (!fixed_x && !fixed_y) {
            dx = -(c * gx - b * gy) / (a * c - b * b);
            dy = -(a * gy - b * gx) / (a * c - b * b);
        } else {
            dx = fixed_x ? 0 : -gx / a;
            dy = fixed_y ? 0 : -gy / c;
        }
        double part = 1;
        while (part > 1e-6 && square(within(x + part * dx), within(y + part * dy)) > best) {
            part /= 2;
        }
        x = within(x + part * dx);
        y = within(y + part * dy);
        best = std::min(best, square(x, y));
    }
    return std::sqrt(best);
}

/// Roots of a function along a line, by its bounds, within `half` of the middle.
struct Roots {
    const Surface &surface;
    const Line &line;

    std::pair<double, double> at(double t) const {
        const auto [value, gradient] = surface.implicit(line.origin + t * line.direction);
        return {value, dot(gradient, line.direction)};
    }
    std::size_t count(double middle, double half) const {
        const auto [value, slope] = at(middle);
        if (std::abs(value) > surface.growth * half || half < 1e-10) {
            return 0;
        }
        if (half < 0.02 && std::abs(slope) > surface.bend * half) {
            return (at(middle - half).first < 0) != (at(middle + half).first < 0) ? 1 : 0;
        }
        return count(middle - half / 2, half / 2) + count(middle + half / 2, half / 2);
    }
};

class Random {
public:
    explicit Random(uint64_t seed) : engine_(seed) {}
    double between(double low, double high) { return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53; }
    Point in_box(const Point &low, const Point &high) {
        return {between(low[0], high[0]), between(low[1], high[1]), between(low[2], high[2])};
    }

private:
    std::mt19937_64 engine_;
};

/// Through values on a circle: the controls of the clamped cubic spline with simple knots. The nodes are (c- + 4 c + c+) / 6; blossoms at
/// the ends.
Points through(const Points &given) {
    const std::size_t n = given.size();
    Points c = given, next(n);
    for (int sweep = 0; sweep < 64; ++sweep) {
        for (std::size_t i = 0; i < n; ++i) {
            next[i] = 0.25 * (6.0 * given[i] - c[(i + n - 1) % n] - c[(i + 1) % n]);
        }
        c.swap(next);
    }
    Points controls = {given[0], (1.0 / 3) * (2.0 * c[0] + c[1])};
    controls.insert(controls.end(), c.begin() + 1, c.end());
    controls.push_back((1.0 / 3) * (c[n - 1] + 2.0 * c[0]));
    controls.push_back(given[0]);
    return controls;
}

std::vector<double> clamped_knots(std::size_t spans) {
    std::vector<double> knots(3, 0.0);
    for (std::size_t i = 0; i <= spans; ++i) {
        knots.push_back(static_cast<double>(i));
    }
    knots.insert(knots.end(), 3, static_cast<double>(spans));
    return knots;
}

/// Every third bit of 63.
uint64_t spread(uint64_t x) {
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}
} // namespace

double length(const Point &a) { return std::sqrt(dot(a, a)); }

Surface torus(const Point &centre) {
    Surface made;
    made.closed = true;
    made.low = centre - Point{1.4, 1.4, 0.4};
    made.high = centre + Point{1.4, 1.4, 0.4};
    made.at = [centre](double u, double v) {
        const double ring = 1 + 0.4 * std::cos(TURN * u);
        return centre + Point{ring * std::cos(TURN * v), ring * std::sin(TURN * v), 0.4 * std::sin(TURN * u)};
    };
    made.off = [centre](const Point &p) {
        const Point d = p - centre;
        return std::abs(std::hypot(std::hypot(d[0], d[1]) - 1, d[2]) - 0.4);
    };
    made.distance = [off = made.off](const Point &query, const Point &) { return off(query); };
    made.implicit = [centre](const Point &p) {
        const Point d = p - centre;
        const double radius = std::hypot(d[0], d[1]), ring = radius - 1, tube = std::hypot(ring, d[2]);
        const double outward = ring / (tube * radius);
        return std::pair(tube - 0.4, Point{outward * d[0], outward * d[1], d[2] / tube});
    };
    made.bend = 10;
    return made;
}

Surface waves() {
    Surface made;
    made.low = {-1, -1, -0.2};
    made.high = {1, 1, 0.2};
    made.at = [](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1;
        return Point{x, y, wave(x, y)};
    };
    made.distance = distance_of_waves;
    made.off = [](const Point &p) { return distance_of_waves(p, p); };
    made.implicit = [](const Point &p) {
        return std::pair(p[2] - wave(p[0], p[1]), Point{-wave_x(p[0], p[1]), -wave_y(p[0], p[1]), 1});
    };
    made.growth = 1.7;
    made.bend = 17;
    return made;
}

Nodes nodes(const Surface &surface, std::size_t rows, std::size_t columns) {
    Nodes made{rows, columns, surface.closed, {}};
    made.points.reserve(rows * columns);
    const auto part = [&](std::size_t i, std::size_t n) {
        return static_cast<double>(surface.closed ? i % (n - 1) : i) / static_cast<double>(n - 1);
    };
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            made.points.push_back(surface.at(part(i, rows), part(j, columns)));
        }
    }
    return made;
}

Triangles triangles(const Nodes &nodes) {
    const std::size_t last = nodes.closed ? 1 : 0, rows = nodes.rows - last, columns = nodes.columns - last;
    Triangles made;
    for (std::size_t i = 0; i < rows; ++i) {
        const auto row = nodes.points.begin() + static_cast<std::ptrdiff_t>(i * nodes.columns);
        made.points.insert(made.points.end(), row, row + static_cast<std::ptrdiff_t>(columns));
    }
    const auto at = [&](std::size_t i, std::size_t j) { return static_cast<uint32_t>(i % rows * columns + j % columns); };
    made.corners.reserve(6 * (nodes.rows - 1) * (nodes.columns - 1));
    for (std::size_t i = 0; i + 1 < nodes.rows; ++i) {
        for (std::size_t j = 0; j + 1 < nodes.columns; ++j) {
            for (const uint32_t corner : {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i + 1, j)}) {
                made.corners.push_back(corner);
            }
        }
    }
    return made;
}

Spline spline(const Nodes &nodes) {
    const std::size_t rows = nodes.rows - 1, columns = nodes.columns - 1;
    Spline made{rows + 3, columns + 3, clamped_knots(rows), clamped_knots(columns), Points((rows + 3) * (columns + 3))};
    std::vector<Points> along;
    for (std::size_t i = 0; i < rows; ++i) {
        const auto row = nodes.points.begin() + static_cast<std::ptrdiff_t>(i * nodes.columns);
        along.push_back(through(Points(row, row + static_cast<std::ptrdiff_t>(columns))));
    }
    for (std::size_t j = 0; j < made.columns; ++j) {
        Points column;
        for (const Points &row : along) {
            column.push_back(row[j]);
        }
        const Points controls = through(column);
        for (std::size_t i = 0; i < made.rows; ++i) {
            made.controls[i * made.columns + j] = controls[i];
        }
    }
    return made;
}

Points near_queries(const Surface &surface, std::size_t count) {
    Random random(1);
    Points made;
    while (made.size() < count) {
        const double u = random.between(0, 1), v = random.between(0, 1);
        made.push_back(surface.at(u, v) + random.in_box({-0.02, -0.02, -0.02}, {0.02, 0.02, 0.02}));
    }
    return made;
}

Points far_queries(const Surface &surface, std::size_t count) {
    Random random(2);
    const Point half = 0.5 * (surface.high - surface.low);
    Points made;
    while (made.size() < count) {
        made.push_back(random.in_box(surface.low - half, surface.high + half));
    }
    return made;
}

std::vector<Line> lines(const Surface &surface, std::size_t count) {
    Random random(3);
    std::vector<Line> made;
    while (made.size() < count) {
        const Point p = random.in_box(surface.low, surface.high), q = random.in_box(surface.low, surface.high);
        const Point direction = (1 / length(q - p)) * (q - p);
        made.push_back({p - surface.size() * direction, direction});
    }
    return made;
}

std::size_t crossings(const Surface &surface, const Line &line) {
    double low = 0, high = 2 * surface.size();
    // An open surface ends with its square.
    for (std::size_t axis = 0; axis < 2 && !surface.closed; ++axis) {
        const double a = (surface.low[axis] - line.origin[axis]) / line.direction[axis];
        const double b = (surface.high[axis] - line.origin[axis]) / line.direction[axis];
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
    }
    return low < high ? Roots{surface, line}.count((low + high) / 2, (high - low) / 2) : 0;
}

Points sorted(const Points &queries) {
    Point low = queries[0], high = queries[0];
    for (const Point &q : queries) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], q[axis]);
            high[axis] = std::max(high[axis], q[axis]);
        }
    }
    std::vector<uint64_t> codes;
    for (const Point &q : queries) {
        uint64_t code = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double part = (q[axis] - low[axis]) / std::max(high[axis] - low[axis], 1e-300);
            code |= spread(static_cast<uint64_t>(part * 0x1fffff)) << axis;
        }
        codes.push_back(code);
    }
    std::vector<std::size_t> order(queries.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return codes[a] < codes[b]; });
    Points made;
    for (const std::size_t k : order) {
        made.push_back(queries[k]);
    }
    return made;
}

void Hits::clear() {
    ends.clear();
    points.clear();
}

void Polylines::clear() {
    ends.clear();
    closed.clear();
    points.clear();
    ordered = true;
    sampled = false;
    unresolved.reset();
}

void Solver::closest(const Points &, Points &) { throw std::runtime_error("has no closest points"); }
void Solver::lines(const std::vector<Line> &, Hits &) { throw std::runtime_error("has no lines"); }
void Solver::rays(const std::vector<Line> &, Hits &) { throw std::runtime_error("has no rays"); }
void Solver::plane(const Plane &, Polylines &) { throw std::runtime_error("has no plane sections"); }
void Solver::meet(Solver &, Polylines &) { throw std::runtime_error("does not intersect surfaces"); }
} // namespace surface
