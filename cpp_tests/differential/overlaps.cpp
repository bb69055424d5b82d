// Trims and joins overlapping pieces of known surfaces, each sampled independently and with noise. The result must
// have the loops and the characteristic of the surface, and no self-intersections by CGAL.
#include "../cpp/judge.hpp"
#include "pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace campaign {
namespace of_overlaps {
namespace {
/// Known properties of a surface.
struct Truth {
    const char *name;
    bool is_closed;
    long euler;
};
constexpr Truth truths[] = {{"sphere", true, 2}, {"torus", true, 0}, {"sheet", false, 1}};
constexpr double size_of_noise = 0.007, overlap = 0.5;

double distance(const Point &a, const Point &b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

Point on_torus(double s, double t) {
    const double u = 2 * M_PI * s, v = 2 * M_PI * t, r = 1 + 0.4 * std::cos(v);
    return {r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)};
}

Point on_sheet(double s, double t) { return {4 * s, 4 * t, 0.3 * std::sin(8 * s) + 0.2 * std::cos(12 * t)}; }

Point on_sphere(const Point &p) {
    const double length = distance(p, {});
    return {p[0] / length, p[1] / length, p[2] / length};
}

/// The surface of a cube of n cells each way, drawn to the sphere.
Soup sphere(uint32_t n) {
    Soup soup;
    std::map<std::array<int, 3>, uint32_t> names;
    const int last = static_cast<int>(n);
    const auto name = [&](const std::array<int, 3> &at) {
        const auto [found, is_new] = names.emplace(at, static_cast<uint32_t>(soup.points.size()));
        if (is_new) {
            // By angles, so that triangles near corners are not smaller.
            Point p{};
            for (std::size_t k = 0; k < 3; ++k) {
                p[k] = std::tan(M_PI / 4 * (2.0 * at[k] / last - 1));
            }
            soup.points.push_back(on_sphere(p));
        }
        return found->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int side : {0, last}) {
            for (int i = 0; i < last; ++i) {
                for (int j = 0; j < last; ++j) {
                    const auto at = [&](int di, int dj) {
                        std::array<int, 3> place{};
                        place[axis] = side;
                        place[(axis + 1) % 3] = i + di;
                        place[(axis + 2) % 3] = j + dj;
                        return name(place);
                    };
                    std::vector<uint32_t> first = {at(0, 0), at(1, 0), at(1, 1)}, second = {at(0, 0), at(1, 1), at(0, 1)};
                    if (side == 0) {
                        std::swap(first[1], first[2]);
                        std::swap(second[1], second[2]);
                    }
                    soup.add_face(first);
                    soup.add_face(second);
                }
            }
        }
    }
    return soup;
}

/// A whole surface, sampled in a way of its own.
Soup sampled(std::size_t which, Random &random) {
    if (which == 0) {
        Soup soup = sphere(random.between(24, 32));
        move(soup, random_rotation(random), {});
        return soup;
    }
    const double a = random.unit(), b = random.unit();
    const uint32_t finer = random.below(12);
    if (which == 1) {
        return cut_to_triangles(grid(90 + finer, 36 + finer / 2, true, true, [&](double s, double t) { return on_torus(s + a, t + b); }), random, 1);
    }
    // Over the same square, so that all have its border.
    return cut_to_triangles(grid(60 + finer, 60 + finer, false, false, on_sheet), random, 1);
}

Point middle_of(const Soup &soup, std::size_t f) {
    const auto face = soup.view().face(f);
    Point middle{};
    for (uint32_t v : face) {
        for (std::size_t k = 0; k < 3; ++k) {
            middle[k] += soup.points[v][k] / double(face.size());
        }
    }
    return middle;
}

/// Places far from each other: each the best of some.
std::vector<Point> spread(std::size_t count, const std::vector<Point> &among, Random &random) {
    std::vector<Point> chosen;
    while (chosen.size() < count) {
        Point best{};
        double most = -1;
        for (int tried = 0; tried < 12; ++tried) {
            const Point &p = random.any(among);
            double least = 1e9;
            for (const Point &q : chosen) {
                least = std::min(least, distance(p, q));
            }
            if (least > most) {
                most = least;
                best = p;
            }
        }
        chosen.push_back(best);
    }
    return chosen;
}

std::vector<Soup> pieces_of(std::size_t which, std::size_t count, Random &random) {
    const std::vector<Point> centres = spread(count, sampled(which, random).points, random);
    std::vector<Soup> pieces;
    for (std::size_t k = 0; k < count; ++k) {
        Soup whole = sampled(which, random);
        for (Point &p : whole.points) {
            const bool at_border = which == 2 && (p[0] == 0 || p[0] == 4 || p[1] == 0 || p[1] == 4);
            for (double &x : p) {
                x += at_border ? 0.0 : random.real(-size_of_noise, size_of_noise);
            }
        }
        pieces.push_back(compact(without(whole, [&](std::size_t f) {
            const Point middle = middle_of(whole, f);
            double nearest = 1e9;
            for (const Point &centre : centres) {
                nearest = std::min(nearest, distance(centre, middle));
            }
            return distance(centres[k], middle) > nearest + overlap;
        })));
    }
    return pieces;
}
} // namespace
} // namespace of_overlaps

void overlaps(Case &test) {
    using namespace of_overlaps;
    const std::size_t which = test.random.below(3), count = test.random.between(2, 12);
    const Truth &truth = truths[which];
    const std::vector<Soup> pieces = pieces_of(which, count, test.random);
    std::vector<gusset::MeshView> views;
    for (const Soup &piece : pieces) {
        views.push_back(piece.view());
    }
    gusset::JoinOptions options;
    options.overlaps = gusset::Overlaps::trim;
    options.fill = true;
    options.fill_options.keep = truth.is_closed ? gusset::FillKeep::none : gusset::FillKeep::borders;
    const gusset::Join done(views, options);
    test.note(truth.name);
    const Verdict verdict = judge(done.mesh());
    if (!test.check(verdict.is_mesh, "trimmed pieces joined are no mesh for CGAL")) {
        return;
    }
    test.equal(verdict.boundary.size(), truth.is_closed ? 0u : 1u, "loops");
    test.equal(verdict.euler, truth.euler, "Euler's characteristic");
    test.equal(verdict.components, 1u, "components");
    test.equal(verdict.self_intersections, 0u, "intersections");
    bool bits = true;
    for (std::size_t k = 0; k < count; ++k) {
        const gusset_indices map = done.pieces()[k].vertices;
        for (std::size_t v = 0; v < map.count; ++v) {
            bits = bits && (map.data[v] == UINT32_MAX || done.mesh().position(map.data[v]) == pieces[k].points[v]);
        }
    }
    test.check(bits || done.report().welded_vertices > 0, "an old vertex of trimmed pieces has other bits");
}
} // namespace campaign
