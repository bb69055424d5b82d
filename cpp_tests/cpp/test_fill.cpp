// Hole filling from C++; the results judged by CGAL, and beside CGAL's own hole filling.
#include "cgal_fill.hpp"
#include "data.hpp"
#include "host.hpp"
#include "judge.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace fill_tests {

namespace {
const gusset::FillOptions fair = [] {
    gusset::FillOptions options;
    options.refine = gusset::FillRefinement::rim_density;
    options.fairing = gusset::Fairing::thin_plate;
    return options;
}();

/// An open tube of triangles round the z axis: two holes of n edges.
Soup tube(uint32_t n, uint32_t rows) {
    Soup soup;
    for (uint32_t row = 0; row <= rows; ++row) {
        for (uint32_t k = 0; k < n; ++k) {
            const double angle = 2 * 3.14159265358979323846 * k / n;
            soup.points.push_back({std::cos(angle), std::sin(angle), 0.3 * row});
        }
    }
    for (uint32_t row = 0; row < rows; ++row) {
        for (uint32_t k = 0; k < n; ++k) {
            const uint32_t a = row * n + k, b = row * n + (k + 1) % n;
            soup.add_face({a, b, b + n, a + n});
        }
    }
    return soup;
}

/// Closed by both judges, with every old vertex and face as it was.
Verdict check_closed(const gusset::Fill &fill, const Soup &soup) {
    const gusset::MeshView mesh = fill.mesh();
    HostMesh host;
    CHECK(gusset::openmesh::append(host, mesh).empty());
    CHECK(walks(host).empty());
    const Verdict verdict = judge(mesh);
    CHECK(verdict.is_mesh);
    CHECK(verdict.closed);
    CHECK(fill.quality().loops_left == 0);
    bool kept = true;
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
        kept = kept && mesh.position(v) == soup.points[v];
    }
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        const gusset::Indices was = soup.view().face(f), is = mesh.face(f);
        kept = kept && was.size() == is.size() && std::equal(was.begin(), was.end(), is.begin());
    }
    CHECK(kept);
    return verdict;
}
} // namespace

TEST_CASE("the ends of a tube") {
    const Soup soup = tube(24, 6);
    for (const auto &options : {gusset::FillOptions{}, fair}) {
        const gusset::Fill fill(soup.view(), options);
        const Verdict verdict = check_closed(fill, soup);
        CHECK(verdict.euler == 2);
        CHECK(verdict.bounds_a_volume);
        CHECK(fill.intersections().value().empty());
        REQUIRE(fill.holes().size() == 2);
        for (const gusset_hole &hole : fill.holes()) {
            CHECK(hole.status == GUSSET_HOLE_FILLED);
            CHECK(hole.face_count == 22 + 2 * hole.vertex_count);
            CHECK(fill.rim(hole).size() == 24);
        }
    }
}

TEST_CASE("loops given, and loops left") {
    const Soup soup = tube(12, 2);
    const gusset::Boundary boundary(soup.view());
    REQUIRE(boundary.size() == 2);
    const std::array<gusset::Indices, 1> one{boundary[1].vertices};
    const gusset::Fill fill(soup.view(), one, fair);
    CHECK(fill.holes().size() == 1);
    CHECK(fill.quality().loops_left == 1);
    const gusset::Fill nothing(soup.view(), gusset::Span<const gusset::Indices>());
    CHECK(nothing.holes().empty());
    CHECK(nothing.mesh().face_count() == soup.face_count());
    gusset::FillOptions few;
    few.max_edges = 11;
    const gusset::Fill left(soup.view(), few);
    CHECK(left.holes()[0].status == GUSSET_HOLE_TOO_LARGE);
}

TEST_CASE("loops closed together") {
    // Two tubes in line.
    Soup soup = tube(24, 3);
    const Soup other = tube(24, 3);
    for (const auto &point : other.points) {
        soup.points.push_back({point[0], point[1], point[2] + 1.5});
    }
    for (std::size_t f = 0; f < other.face_count(); ++f) {
        const gusset::Indices face = other.view().face(f);
        soup.add_face({face[0] + 96, face[1] + 96, face[2] + 96, face[3] + 96});
    }
    const gusset::Boundary boundary(soup.view());
    REQUIRE(boundary.size() == 4);
    std::array<gusset::Indices, 4> loops;
    std::vector<uint32_t> groups(4);
    for (std::size_t i = 0; i < 4; ++i) {
        loops[i] = boundary[i].vertices;
        const double z = soup.points[loops[i][0]][2];
        groups[i] = z < 0.5 ? 0 : z < 2.0 ? 1 : 2;
    }
    gusset::FillOptions options = fair;
    options.groups = groups;
    const gusset::Fill filled(soup.view(), loops, options);
    const Verdict verdict = check_closed(filled, soup);
    CHECK(verdict.euler == 2);
    CHECK(verdict.bounds_a_volume);
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            CHECK((filled.holes()[i].patch == filled.holes()[k].patch) == (groups[i] == groups[k]));
        }
    }
    gusset::FillOptions cheapest = fair;
    cheapest.together = gusset::FillTogether::cheapest;
    CHECK(check_closed(gusset::Fill(soup.view(), cheapest), soup).euler == 2);
    options.groups = {groups[0], groups[1], groups[2]};
    CHECK_THROWS_AS(gusset::Fill(soup.view(), loops, options), gusset::Error);
    CHECK_THROWS_AS(gusset::Fill(soup.view(), options), gusset::Error);
}

TEST_CASE("patches go on with the curvature, or along tangents") {
    // A bowl with a hole round its middle.
    const uint32_t n = 24;
    Soup soup;
    for (uint32_t j = 0; j <= n; ++j) {
        for (uint32_t i = 0; i <= n; ++i) {
            const double x = i / 12.0 - 1.0, y = j / 12.0 - 1.0;
            soup.points.push_back({x, y, 0.3 * x * x + 0.2 * y * y});
        }
    }
    for (uint32_t j = 0; j < n; ++j) {
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            if (std::hypot(i - 11.5, j - 11.5) > 4.0) {
                soup.add_face({a, b, c});
                soup.add_face({a, c, d});
            }
        }
    }
    const auto farthest = [&](gusset::FillContinuity continuity, bool ignore_creases) {
        gusset::FillOptions options = fair;
        options.keep = gusset::FillKeep::longest;
        options.continuity = continuity;
        options.ignore_creases = ignore_creases;
        const gusset::Fill filled(soup.view(), options);
        double most = 0;
        for (std::size_t v = soup.points.size(); v < filled.mesh().vertex_count(); ++v) {
            const gusset::Point3 p = filled.mesh().position(v);
            most = std::max(most, std::abs(0.3 * p[0] * p[0] + 0.2 * p[1] * p[1] - p[2]));
        }
        CHECK(filled.mesh().vertex_count() > soup.points.size());
        REQUIRE(filled.intersections().has_value());
        CHECK(filled.intersections()->empty());
        return most;
    };
    const double tangents = farthest(gusset::FillContinuity::c1, false);
    CHECK(farthest(gusset::FillContinuity::c2, false) < tangents / 3);
    // It lacks creases.
    CHECK(farthest(gusset::FillContinuity::c1, true) == tangents);
    CHECK(gusset::FillOptions().continuity == gusset::FillContinuity::c1);
}

TEST_CASE("a planar hole of concave outline, beside CGAL's filling of it") {
    // A star with twelve points, as the open top of a cone.
    Soup soup;
    for (int k = 0; k < 24; ++k) {
        const double angle = 3.14159265358979323846 * k / 12, radius = k % 2 ? 0.25 : 1.0;
        soup.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0});
    }
    soup.points.push_back({0.0, 0.0, -2.0});
    for (uint32_t k = 0; k < 24; ++k) {
        soup.add_face({(k + 1) % 24, k, 24});
    }
    for (const auto &options : {gusset::FillOptions{}, fair}) {
        const gusset::Fill fill(soup.view(), options);
        CHECK(check_closed(fill, soup).self_intersections <= cgal_fill(soup, options.fairing != gusset::Fairing::none));
    }
}

TEST_SUITE_BEGIN("real meshes");

TEST_CASE("holes of real meshes, beside CGAL's filling of them") {
    const auto folder = data_folder();
    if (!folder) {
        return;
    }
    struct Case {
        const char *file;
        std::size_t holes;
    };
    for (const Case &c : {Case{"elephant-with-holes", 106}, Case{"mech-holes-shark", 4}, Case{"pig", 7},
                          Case{"corner_with_hole", 1}, Case{"hole_capsule", 3}}) {
        const Soup soup = read_soup(*folder + "/meshes/" + c.file + ".off");
        const Verdict before = judge(soup.view());
        for (const auto &options : {gusset::FillOptions{}, fair}) {
            CAPTURE(c.file);
            const gusset::Fill fill(soup.view(), options);
            CHECK(fill.holes().size() == c.holes);
            const Verdict verdict = check_closed(fill, soup);
            const std::size_t peer = cgal_fill(soup, options.fairing != gusset::Fairing::none);
            std::cout << c.file << (options.fairing == gusset::Fairing::none ? "" : ", fair") << ": self-intersections "
                      << verdict.self_intersections << ", CGAL's " << peer << ", before " << before.self_intersections
                      << "; smallest angle " << fill.quality().min_angle * 180 / 3.14159265358979323846 << "\n";
            CHECK(verdict.self_intersections <= peer);
        }
    }
}

TEST_SUITE_END();

} // namespace fill_tests
