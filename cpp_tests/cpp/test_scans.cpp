// Pieces that overlap: aligned, trimmed and joined, on surfaces by formulas, with CGAL as judge.
#include "judge.hpp"
#include "oracle.hpp"
#include "soup.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

namespace scans_tests {

namespace {
using Point = gusset::Point3;

std::vector<gusset::MeshView> views(const std::vector<Soup> &pieces) {
    std::vector<gusset::MeshView> all;
    for (const Soup &piece : pieces) {
        all.push_back(piece.view());
    }
    return all;
}

double distance(const Point &a, const Point &b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

Point moved(const gusset::Transform &by, const Point &p) {
    Point to{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double *row = by.rows + 4 * k;
        to[k] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
    }
    return to;
}

Soup moved(const gusset::Transform &by, Soup soup) {
    for (Point &p : soup.points) {
        p = moved(by, p);
    }
    return soup;
}

/// The turn about an axis through a point, by degrees, and a shift.
gusset::Transform motion(Point axis, double degrees, const Point &through, const Point &shift) {
    const double length = distance(axis, {}), angle = degrees * M_PI / 180, c = std::cos(angle), s = std::sin(angle);
    const double x = axis[0] / length, y = axis[1] / length, z = axis[2] / length, d = 1 - c;
    gusset::Transform made = {{c + x * x * d, x * y * d - z * s, x * z * d + y * s, 0, //
                               y * x * d + z * s, c + y * y * d, y * z * d - x * s, 0, //
                               z * x * d - y * s, z * y * d + x * s, c + z * z * d, 0}};
    const Point to = moved(made, through);
    for (std::size_t k = 0; k < 3; ++k) {
        made.rows[4 * k + 3] = through[k] + shift[k] - to[k];
    }
    return made;
}

/// A grid of triangles over the unit square, n nodes each way, front up.
Soup grid(uint32_t n, const std::function<Point(double, double)> &at) {
    Soup soup;
    for (uint32_t j = 0; j < n; ++j) {
        for (uint32_t i = 0; i < n; ++i) {
            soup.points.push_back(at(double(i) / (n - 1), double(j) / (n - 1)));
        }
    }
    for (uint32_t j = 0; j + 1 < n; ++j) {
        for (uint32_t i = 0; i + 1 < n; ++i) {
            const uint32_t v = j * n + i;
            soup.add_face({v, v + 1, v + n + 1});
            soup.add_face({v, v + n + 1, v + n});
        }
    }
    return soup;
}

/// The part of a height field from x = first on.
Soup hills(uint32_t n, double first) {
    return grid(n, [=](double s, double y) {
        const double x = first + 0.65 * s;
        return Point{x, y, 0.1 * std::sin(7 * x) + 0.1 * std::cos(7 * y) + 0.05 * x * y};
    });
}

/// More than the half of a closed surface without symmetries, the upper or the lower one: a square in the plane of a
/// stereographic projection. The two overlap all round.
Soup half(uint32_t n, bool lower) {
    return grid(n, [=](double s, double t) {
        const double u = 1.25 * (2 * s - 1), v = 1.25 * (2 * t - 1), d = 1 + u * u + v * v;
        const double x = 2 * u / d, y = (lower ? -2 : 2) * v / d, z = (lower ? d - 2 : 2 - d) / d;
        const double r = 1 + 0.2 * std::sin(2.5 * x + 0.3) + 0.15 * std::sin(3 * y) + 0.1 * std::sin(4 * z + 0.5) +
                         0.1 * x * y;
        return Point{r * x, 0.8 * r * y, r * z};
    });
}

double mean_edge(const Soup &soup) {
    double sum = 0;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        const auto face = soup.view().face(f);
        for (std::size_t k = 0; k < face.size(); ++k) {
            sum += distance(soup.points[face[k]], soup.points[face[(k + 1) % face.size()]]);
        }
    }
    return sum / double(soup.corners.size());
}

/// The faces of a piece that are kept, with all of its vertices.
Soup kept(const Soup &soup, gusset::Indices faces) {
    Soup part;
    part.points = soup.points;
    for (uint32_t f : faces) {
        const auto face = soup.view().face(f);
        part.add_face({face.begin(), face.end()});
    }
    return part;
}

/// The least distance of corners, of middles of sides and of middles of faces from another surface.
double gap(const Soup &from, const Soup &to) {
    const Oracle oracle(to.view());
    double least = INFINITY;
    for (std::size_t f = 0; f < from.face_count(); ++f) {
        const auto face = from.view().face(f);
        Point middle{};
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Point &p = from.points[face[k]], &q = from.points[face[(k + 1) % face.size()]];
            Point between{};
            for (std::size_t i = 0; i < 3; ++i) {
                between[i] = (p[i] + q[i]) / 2;
                middle[i] += p[i] / double(face.size());
            }
            least = std::min({least, oracle.distance(p), oracle.distance(between)});
        }
        least = std::min(least, oracle.distance(middle));
    }
    return least;
}

/// The farthest that a vertex of a piece is from where it belongs.
double deviation(const gusset::Transform &pose, const Soup &disturbed, const Soup &truth) {
    double most = 0;
    for (std::size_t v = 0; v < truth.points.size(); ++v) {
        most = std::max(most, distance(moved(pose, disturbed.points[v]), truth.points[v]));
    }
    return most;
}
} // namespace

TEST_CASE("alignment finds how a piece was moved") {
    const std::vector<std::pair<Soup, Soup>> pairs = {{hills(32, 0.0), hills(31, 0.35)},
                                                      {half(34, false), half(35, true)}};
    const std::vector<Point> axes = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {1, -2, 3}};
    for (const auto &[first, second] : pairs) {
        for (std::size_t k = 0; k < axes.size(); ++k) {
            CAPTURE(k);
            const Point shift = {0.01, k % 2 == 0 ? 0.01 : -0.01, 0.015};
            const Soup disturbed = moved(motion(axes[k], 2, second.points[second.points.size() / 2], shift), second);
            const gusset::Alignment found(views({first, disturbed}));
            CHECK(found.is_trusted());
            CHECK(found.converged());
            CHECK(found.rounds() > 0);
            REQUIRE(found.pieces().size() == 2);
            CHECK(found.pieces()[0].hold == 1.0);
            CHECK(deviation(found.pieces()[0].pose, first, first) < 1e-12);
            CHECK(deviation(found.pieces()[1].pose, disturbed, second) < 3e-3);
            REQUIRE(found.overlaps().size() == 1);
            CHECK(found.overlaps()[0].trusted == 1);
            CHECK(found.overlaps()[0].mean < 3e-3);
        }
    }
}

TEST_CASE("alignment from poses, and from principal axes") {
    const Soup first = half(30, false), second = half(31, true);
    const gusset::Transform far = motion({1, 2, -1}, 110, {}, {5, -3, 2});
    const Soup disturbed = moved(far, second);
    CHECK(!gusset::Alignment(views({first, disturbed})).is_trusted());

    // The inverse motion, except 2 degrees.
    gusset::AlignmentOptions options;
    const Point zero = moved(far, Point{});
    gusset::Transform back = {};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            back.rows[4 * i + j] = far.rows[4 * j + i];
            back.rows[4 * i + 3] -= far.rows[4 * j + i] * zero[j];
        }
    }
    REQUIRE(deviation(back, disturbed, second) < 1e-12);
    const Soup nearly = moved(motion({0, 1, 1}, 2, {}, {}), second);
    const Soup away = moved(far, nearly);
    options.poses = {gusset::identity(), back};
    const gusset::Alignment by_poses(views({first, away}), options);
    CHECK(by_poses.is_trusted());
    CHECK(deviation(by_poses.pieces()[1].pose, away, second) < 5e-3);

    // The same object, whole, in any place.
    options.poses.clear();
    options.start = gusset::AlignmentStart::principal_axes;
    const Soup copy = moved(far, first);
    const gusset::Alignment by_axes(views({first, copy}), options);
    CHECK(by_axes.is_trusted());
    CHECK(deviation(by_axes.pieces()[1].pose, copy, first) < 1e-3);
}

TEST_CASE("what is trimmed has no overlaps") {
    const std::vector<Soup> pieces = {hills(32, 0.0), hills(33, 0.35)};
    for (bool seen : {false, true}) {
        gusset::TrimOptions options;
        if (seen) {
            options.viewpoints = {{0.3, 0.5, 5.0}, {0.7, 0.5, 5.0}};
        }
        const gusset::Trim trim(views(pieces), options);
        REQUIRE(trim.pieces().size() == 2);
        CHECK(trim.crossings() == 0);
        std::vector<Soup> left;
        for (std::size_t k = 0; k < 2; ++k) {
            const gusset::Indices faces = trim.kept(k);
            CHECK(std::is_sorted(faces.begin(), faces.end()));
            CHECK(std::set(faces.begin(), faces.end()).size() == faces.size());
            CHECK(trim.pieces()[k].covered_vertices > 0);
            left.push_back(kept(pieces[k], faces));
        }
        const std::size_t before = pieces[0].face_count() + pieces[1].face_count();
        const std::size_t after = left[0].face_count() + left[1].face_count();
        // 0.3 of 1.3 lie on each other.
        CHECK(after < before * 0.85);
        CHECK(after > before * 0.65);
        const double edge = std::max(mean_edge(pieces[0]), mean_edge(pieces[1]));
        CHECK(gap(left[0], left[1]) > 0.3 * edge);
        CHECK(gap(left[1], left[0]) > 0.3 * edge);
        CHECK(gap(left[1], left[0]) < 2 * edge);
    }
}

TEST_CASE("pieces that lie on nothing stay whole") {
    const std::vector<Soup> pieces = {hills(20, 0.0), moved(gusset::translation({9, 0, 0}), hills(20, 0.35))};
    const gusset::Trim trim(views(pieces));
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(trim.kept(k).size() == pieces[k].face_count());
        CHECK(trim.pieces()[k].covered_vertices == 0);
    }
}

TEST_CASE("halves that overlap become one closed surface") {
    const Soup first = half(41, false), second = half(42, true);
    const Soup disturbed = moved(motion({1, 1, 2}, 2, {}, {0.01, 0.02, -0.01}), second);
    const gusset::Alignment found(views({first, disturbed}));
    REQUIRE(found.is_trusted());
    const std::vector<Soup> pieces = {first, moved(found.pieces()[1].pose, disturbed)};
    gusset::JoinOptions options;
    options.overlaps = gusset::Overlaps::trim;
    options.fill = true;
    const gusset::Join done(views(pieces), options);
    CHECK(done.report().trimmed_faces > 0);
    CHECK(done.report().loops_left == 0);
    CHECK(done.report().non_manifold_edges == 0);
    const Verdict verdict = judge(done.mesh());
    CHECK(verdict.is_mesh);
    CHECK(verdict.closed);
    CHECK(verdict.components == 1);
    CHECK(verdict.euler == 2);
    CHECK(verdict.self_intersections == 0);
    CHECK(verdict.bounds_a_volume);

    // Each old face occurs once or was trimmed. The remaining vertices keep their positions.
    std::size_t gone = 0;
    std::vector<int> used(done.mesh().face_count());
    for (std::size_t k = 0; k < 2; ++k) {
        const gusset_piece_map map = done.pieces()[k];
        for (std::size_t f = 0; f < map.faces.count; ++f) {
            if (map.faces.data[f] == UINT32_MAX) {
                ++gone;
            } else {
                CHECK(++used[map.faces.data[f]] == 1);
            }
        }
        for (std::size_t v = 0; v < map.vertices.count; ++v) {
            if (map.vertices.data[v] != UINT32_MAX) {
                CHECK(done.mesh().position(map.vertices.data[v]) == pieces[k].points[v]);
            }
        }
    }
    CHECK(gone == done.report().trimmed_faces);

    // Old values are carried over.
    std::vector<std::vector<double>> heights(2);
    for (std::size_t k = 0; k < 2; ++k) {
        for (const Point &p : pieces[k].points) {
            heights[k].push_back(p[2]);
        }
    }
    const auto made = done.origins().apply<double>(gusset::Domain::vertices, gusset::Rule::linear,
                                                   {heights[0], heights[1]});
    REQUIRE(made.size() == done.mesh().vertex_count());
    for (std::size_t k = 0; k < 2; ++k) {
        const gusset_piece_map map = done.pieces()[k];
        for (std::size_t v = 0; v < map.vertices.count; ++v) {
            if (map.vertices.data[v] != UINT32_MAX) {
                CHECK(made[map.vertices.data[v]] == heights[k][v]);
            }
        }
    }
}

TEST_CASE("overlaps stay if nothing is said") {
    const std::vector<Soup> pieces = {hills(24, 0.0), hills(24, 0.35)};
    const gusset::Join kept_all(views(pieces));
    CHECK(kept_all.report().trimmed_faces == 0);
    gusset::JoinOptions options;
    options.overlaps = gusset::Overlaps::trim;
    const gusset::Join trimmed(views(pieces), options);
    CHECK(trimmed.report().trimmed_faces > 0);
    const Verdict verdict = judge(trimmed.mesh());
    CHECK(verdict.is_mesh);
    CHECK(verdict.components == 1);
    CHECK(verdict.boundary.size() == 1);
    CHECK(verdict.self_intersections == 0);
}

TEST_CASE("mistakes are errors") {
    const std::vector<Soup> pieces = {hills(20, 0.0), hills(20, 0.35)};
    const auto status = [](const std::function<void()> &call) {
        try {
            call();
        } catch (const gusset::Error &error) {
            return error.status();
        }
        return int32_t{GUSSET_OK};
    };
    CHECK(status([] { gusset::Alignment(views({})); }) == GUSSET_ERROR_EMPTY_MESH);
    CHECK(status([] { gusset::Trim(views({})); }) == GUSSET_ERROR_EMPTY_MESH);
    gusset::AlignmentOptions options;
    options.poses = {gusset::identity()};
    CHECK(status([&] { gusset::Alignment(views(pieces), options); }) == GUSSET_ERROR_COUNT_DIFFERS);
    options.poses = {gusset::identity(), {{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}};
    CHECK(status([&] { gusset::Alignment(views(pieces), options); }) == GUSSET_ERROR_OUT_OF_RANGE);
    gusset::TrimOptions viewpoints;
    viewpoints.viewpoints = {{0, 0, 9}};
    CHECK(status([&] { gusset::Trim(views(pieces), viewpoints); }) == GUSSET_ERROR_COUNT_DIFFERS);
    viewpoints.viewpoints = {{0, 0, 9}, {0, NAN, 9}};
    CHECK(status([&] { gusset::Trim(views(pieces), viewpoints); }) == GUSSET_ERROR_NOT_FINITE);
    gusset::JoinOptions assembly;
    assembly.overlaps = gusset::Overlaps::trim;
    assembly.trim_options = viewpoints;
    CHECK(status([&] { gusset::Join(views(pieces), assembly); }) == GUSSET_ERROR_NOT_FINITE);
}

} // namespace scans_tests
