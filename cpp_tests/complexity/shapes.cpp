#include "shapes.hpp"

namespace complexity {

namespace {
std::size_t side_of(std::size_t n) {
    return static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(n))));
}
uint32_t index(std::size_t i) { return static_cast<uint32_t>(i); }
} // namespace

void Mesh::add(const Mesh &other, const Point3 &at) {
    const uint32_t first = index(points.size());
    for (const Point3 &p : other.points) {
        points.push_back({p[0] + at[0], p[1] + at[1], p[2] + at[2]});
    }
    for (const uint32_t corner : other.corners) {
        corners.push_back(first + corner);
    }
}

Mesh fan(std::size_t n, bool closed) {
    Mesh made;
    made.points = circle(closed ? n : n + 1, 1.0, 0.3);
    const uint32_t rim = index(made.points.size());
    made.points.push_back({0, 0, 0});
    for (uint32_t i = 0; i < n; ++i) {
        made.triangle(rim, i, (i + 1) % rim);
    }
    return made;
}

Mesh bundle(std::size_t n) {
    Mesh made;
    made.points.push_back({0, 0, 0});
    for (const Point3 &p : circle(2 * n, 1.0, 0.3)) {
        made.points.push_back(p);
    }
    for (uint32_t i = 0; i < n; ++i) {
        made.triangle(0, 2 * i + 1, 2 * i + 2);
    }
    return made;
}

Mesh plates(std::size_t n) {
    constexpr uint32_t quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    Mesh made;
    for (std::size_t k = 0; k < n; ++k) {
        const auto first = static_cast<uint32_t>(made.points.size());
        for (unsigned corner = 0; corner < 8; ++corner) {
            made.points.push_back({corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, double(k) + (corner & 4 ? 0.5 : 0.0)});
        }
        for (const auto &quad : quads) {
            made.triangle(first + quad[0], first + quad[1], first + quad[2]);
            made.triangle(first + quad[0], first + quad[2], first + quad[3]);
        }
    }
    return made;
}

Mesh scattered(std::size_t n, bool in_one_point) {
    Mesh made;
    const std::size_t side = side_of(n);
    const double size = in_one_point ? 0 : 0.25;
    for (std::size_t k = 0; k < n; ++k) {
        const double x = in_one_point ? 0 : static_cast<double>(k % side), y = in_one_point ? 0 : static_cast<double>(k / side);
        const uint32_t first = index(made.points.size());
        made.points.insert(made.points.end(), {{x, y, 0}, {x + size, y, 0}, {x, y + size, 0}});
        made.triangle(first, first + 1, first + 2);
    }
    return made;
}

Mesh copies(std::size_t n) {
    Mesh made, one;
    one.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    one.corners = {0, 1, 2};
    for (std::size_t k = 0; k < n; ++k) {
        made.add(one);
    }
    return made;
}

Mesh square(std::size_t n, double roughness) {
    Mesh made;
    const Grid grid = random_grid(n / 2, 1, roughness);
    made.points = grid.points;
    for (std::size_t i = 0; i + 1 < grid.rows; ++i) {
        for (std::size_t j = 0; j + 1 < grid.columns; ++j) {
            const uint32_t a = index(i * grid.columns + j), b = a + 1, c = index(a + grid.columns), d = c + 1;
            made.triangle(a, c, b);
            made.triangle(b, c, d);
        }
    }
    return made;
}

Mesh rings(std::size_t n, bool closed) {
    const uint32_t count = 126, columns = std::max<uint32_t>(3, index(n / (2 * count)));
    Mesh made;
    for (uint32_t i = 0; i < count; ++i) {
        for (uint32_t j = 0; j < columns; ++j) {
            const double s = turn * i / count, t = turn * j / columns;
            const double away = 2 + std::cos(t);
            made.points.push_back(closed ? Point3{away * std::cos(s), away * std::sin(s), std::sin(t)} : Point3{std::cos(t), std::sin(t), s});
        }
    }
    for (uint32_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
        for (uint32_t j = 0; j < columns; ++j) {
            const uint32_t here = i * columns, next = (i + 1) % count * columns, k = (j + 1) % columns;
            made.triangle(here + j, here + k, next + j);
            made.triangle(here + k, next + k, next + j);
        }
    }
    return made;
}

Mesh shell(const std::vector<Point3> &rim, const Point3 &behind, double scale) {
    Mesh made;
    made.points = rim;
    for (const Point3 &p : rim) {
        made.points.push_back({scale * p[0] + behind[0], scale * p[1] + behind[1], scale * p[2] + behind[2]});
    }
    const uint32_t n = index(rim.size());
    for (uint32_t i = 0; i < n; ++i) {
        const uint32_t j = (i + 1) % n;
        made.triangle(i, j, n + i);
        made.triangle(j, n + j, n + i);
    }
    return made;
}

std::vector<Point3> circle(std::size_t n, double radius, double height) {
    std::vector<Point3> made;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = turn * static_cast<double>(i) / static_cast<double>(n);
        made.push_back({radius * std::cos(t), radius * std::sin(t), height});
    }
    return made;
}

std::vector<Point3> collinear(std::size_t n) {
    std::vector<Point3> made;
    for (std::size_t i = 0; i < n; ++i) {
        made.push_back({static_cast<double>(2 * i < n ? 2 * i : 2 * (n - i) - 1), 0, 0});
    }
    return made;
}

std::vector<Point3> spiral(std::size_t n, double height) {
    std::vector<Point3> made;
    for (std::size_t i = 0; i < n; ++i) {
        const double along = 2 * static_cast<double>(i) / static_cast<double>(n);
        const double s = along < 1 ? along : 2 - along, t = 8 * turn * std::sqrt(s + 0.01);
        const double r = t + (along < 1 ? 0 : 0.4 * turn);
        made.push_back({r * std::cos(t), r * std::sin(t), height});
    }
    return made;
}

std::vector<Point3> point(std::size_t n, const Point3 &at) { return std::vector<Point3>(n, at); }

std::vector<Point3> nested_star(std::size_t n, double height) {
    std::vector<Point3> made;
    for (std::size_t i = 0; i < n; ++i) {
        // Each digit of i to the base 4 is a point of a smaller star.
        double r = 1, scale = 0.5;
        for (std::size_t digits = i; digits != 0; digits /= 4, scale *= 0.6) {
            r += digits % 2 == 0 ? scale : -0.5 * scale;
        }
        const double t = turn * static_cast<double>(i) / static_cast<double>(n);
        made.push_back({r * std::cos(t), r * std::sin(t), height});
    }
    return made;
}

gusset::Curve curve_of(const std::vector<Point3> &points, uint32_t degree, bool closed) {
    std::vector<uint32_t> ends;
    for (std::size_t at = degree; at < points.size(); at += degree) {
        ends.push_back(index(at));
    }
    std::vector<Point3> used(points.begin(), points.begin() + (ends.empty() ? 0 : ends.back()) + 1);
    if (closed) {
        used.back() = used.front();
    }
    ends.insert(ends.begin(), 0);
    return gusset::Curve::from_controls(used, ends, closed);
}

Grid plane_grid(std::size_t n, double height) {
    Grid made = random_grid(n, 1, 0);
    for (Point3 &p : made.points) {
        p[2] = height;
    }
    return made;
}

Grid random_grid(std::size_t n, uint32_t seed, double roughness) {
    const std::size_t side = side_of(n) + 1;
    Grid made{side, side, {}};
    std::mt19937 random(seed);
    for (std::size_t i = 0; i < side; ++i) {
        for (std::size_t j = 0; j < side; ++j) {
            // By hand: distributions differ from one library to another.
            const auto chance = [&random] { return static_cast<double>(random() % 65536) / 65536 - 0.5; };
            const double x = roughness * chance(), y = roughness * chance(), z = roughness * chance();
            made.points.push_back({static_cast<double>(j) + x, static_cast<double>(i) + y, z});
        }
    }
    return made;
}

Grid sphere_grid(std::size_t n) {
    const std::size_t side = side_of(n) + 1;
    Grid made{side, side, {}};
    for (std::size_t i = 0; i < side; ++i) {
        for (std::size_t j = 0; j < side; ++j) {
            const double part = 1.0 / static_cast<double>(side - 1);
            const double u = 0.8 * (static_cast<double>(i) * part - 0.5), v = 0.8 * (static_cast<double>(j) * part - 0.5);
            made.points.push_back({std::cos(u) * std::cos(v), std::cos(u) * std::sin(v), std::sin(u)});
        }
    }
    return made;
}

Grid point_grid(std::size_t n) {
    Grid made = random_grid(n, 1, 0);
    made.points.assign(made.points.size(), Point3{});
    return made;
}

gusset::Sheet sheet_of(const Grid &grid) { return gusset::Sheet::from_nodes(grid.rows, grid.columns, grid.points); }

} // namespace complexity
