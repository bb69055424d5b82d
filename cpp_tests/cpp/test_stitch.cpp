// Stitching from an OpenMesh host; the results judged by OpenMesh's own walks and by CGAL.
#include "data.hpp"
#include "host.hpp"
#include "judge.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>

namespace stitch_tests {

namespace {
using Lengths = std::vector<std::size_t>;

/// Both judges agree that the result is one oriented two-manifold with boundaries of these lengths.
Verdict check_result(const gusset::Stitch &stitch, const Lengths &boundary) {
    const gusset::MeshView mesh = stitch.mesh();
    HostMesh host;
    CHECK(gusset::openmesh::append(host, mesh).empty());
    Lengths lengths;
    for (const auto &cycle : walks(host)) {
        lengths.push_back(cycle.size());
    }
    std::sort(lengths.begin(), lengths.end(), std::greater<>());
    CHECK(lengths == boundary);
    const Verdict verdict = judge(mesh);
    CHECK(verdict.is_mesh);
    CHECK(verdict.components == 1);
    CHECK(verdict.boundary == boundary);
    CHECK(verdict.closed == boundary.empty());
    CHECK(stitch.quality().loops_left == boundary.size());
    CHECK(stitch.quality().non_manifold_edges == 0);
    CHECK(stitch.quality().orientation_conflicts == 0);
    return verdict;
}

/// The old pieces lie in the result as they were.
void check_kept(const gusset::Stitch &stitch, const Soup &soup, int number) {
    const auto vertex_map = stitch.vertex_map(number), face_map = stitch.face_map(number);
    REQUIRE(vertex_map.size() == soup.points.size());
    REQUIRE(face_map.size() == soup.face_count());
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
        CHECK(stitch.mesh().position(vertex_map[v]) == soup.points[v]);
    }
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        std::vector<uint32_t> face;
        for (uint32_t v : soup.view().face(f)) {
            face.push_back(vertex_map[v]);
        }
        auto found = stitch.mesh().face(face_map[f]);
        std::vector<uint32_t> now(found.begin(), found.end());
        if (number == 1 && stitch.turned()) {
            std::reverse(now.begin() + 1, now.end());
        }
        CHECK(now == face);
    }
}

/// Both pieces, not joined.
Soup both(const Soup &a, const Soup &b) {
    Soup soup = a;
    soup.points.insert(soup.points.end(), b.points.begin(), b.points.end());
    for (std::size_t f = 0; f < b.face_count(); ++f) {
        std::vector<uint32_t> face;
        for (uint32_t v : b.view().face(f)) {
            face.push_back(v + static_cast<uint32_t>(a.points.size()));
        }
        soup.add_face(face);
    }
    return soup;
}

/// A tube round the z axis from z = low to z = high, of `n` sides and `rings` rings, faces
/// outwards.
Soup tube(uint32_t n, uint32_t rings, double low, double high, double turn) {
    Soup soup;
    for (uint32_t r = 0; r < rings; ++r) {
        for (uint32_t i = 0; i < n; ++i) {
            const double t = turn + 2.0 * M_PI * i / n, z = low + (high - low) * r / (rings - 1);
            soup.points.push_back({std::cos(t), std::sin(t), z});
        }
    }
    for (uint32_t r = 0; r + 1 < rings; ++r) {
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t j = (i + 1) % n;
            soup.add_face({r * n + i, r * n + j, (r + 1) * n + j, (r + 1) * n + i});
        }
    }
    return soup;
}
} // namespace

TEST_CASE("two tubes: one tube, whatever the counts, the rule and the start") {
    for (auto rule : {gusset::Meridians::min_area, gusset::Meridians::index}) {
        for (auto [n, m] : {std::pair{12u, 12u}, {40u, 7u}, {7u, 40u}, {3u, 3u}, {200u, 199u}}) {
            for (int64_t twist : {0, 1, -2}) {
                const Soup a = tube(n, 3, 0.0, 1.0, 0.0), b = tube(m, 4, 1.5, 2.5, 0.9);
                gusset::StitchOptions options;
                options.meridians = rule;
                options.twist = twist;
                const gusset::Stitch stitch = gusset::stitch(a.view(), b.view(), options);
                const Verdict verdict = check_result(stitch, {std::max(n, m), std::min(n, m)});
                CHECK(verdict.euler == 0);
                if (twist == 0 && std::min(n, m) > 3) {
                    CHECK(verdict.self_intersections == 0);
                }
                check_kept(stitch, a, 0);
                check_kept(stitch, b, 1);
                CHECK(stitch.strip_faces() == std::pair<std::size_t, std::size_t>(n * 2 + m * 3, n + m));
                CHECK(!stitch.turned());
            }
        }
    }
}

TEST_CASE("a piece that is inside out is turned over, or refused") {
    const Soup a = tube(20, 3, 0.0, 1.0, 0.0), outwards = tube(15, 3, 1.2, 2.0, 0.3);
    Soup b = outwards;
    for (std::size_t f = 0; f < b.face_count(); ++f) {
        std::reverse(b.corners.begin() + b.offsets[f], b.corners.begin() + b.offsets[f + 1]);
    }
    const gusset::Stitch stitch = gusset::stitch(a.view(), b.view());
    CHECK(stitch.turned());
    check_result(stitch, {20, 15});
    check_kept(stitch, b, 1);
    gusset::StitchOptions options;
    options.orientation = gusset::Orientation::refuse;
    try {
        gusset::stitch(a.view(), b.view(), options);
        FAIL("not refused");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_ORIENTATION_CONFLICT);
        CHECK(error.report().input == 1);
        CHECK(std::string(error.what()).find("oriented") != std::string::npos);
    }
    CHECK(!gusset::stitch(a.view(), outwards.view(), options).turned());
}

TEST_CASE("the strip goes into the host's own mesh") {
    HostMesh mesh;
    const Soup low = tube(16, 3, 0.0, 1.0, 0.0), high = tube(12, 3, 1.3, 2.0, 0.2);
    CHECK(gusset::openmesh::append(mesh, low.view()).empty());
    CHECK(gusset::openmesh::append(mesh, high.view()).empty());
    const gusset::openmesh::Input input(mesh);
    const gusset::Stitch stitch = gusset::stitch_within(input.view());
    const auto faces = mesh.n_faces();
    CHECK(gusset::openmesh::append_strip(mesh, stitch).empty());
    CHECK(mesh.n_faces() == faces + 28);
    CHECK(mesh.n_vertices() == 28 * 3);
    CHECK(walks(mesh).size() == 2);
    CHECK_THROWS_AS(gusset::openmesh::append_strip(mesh, gusset::stitch(low.view(), high.view())),
                    gusset::Error);
}

TEST_SUITE_BEGIN("real meshes");

TEST_CASE("bunny_cut: head and body become one, the five holes of the scan stay") {
    const auto folder = data_folder();
    if (!folder) {
        return;
    }
    const Soup body = read_soup(*folder + "/pairs/bunny_cut/body.off"), head = read_soup(*folder + "/pairs/bunny_cut/head.off");
    const auto host_body = host_mesh(body), host_head = host_mesh(head);
    REQUIRE((host_body && host_head));
    const gusset::openmesh::Input a(*host_body), b(*host_head);
    const gusset::Stitch stitch = gusset::stitch(a.view(), b.view());
    const Verdict verdict = check_result(stitch, {80, 42, 40, 39, 22});
    const Verdict before = judge(both(body, head).view());
    std::cout << "bunny_cut: self-intersections " << verdict.self_intersections << ", before "
              << before.self_intersections << "\n";
    CHECK(verdict.self_intersections == before.self_intersections);
    check_kept(stitch, body, 0);
    check_kept(stitch, head, 1);
}

TEST_CASE("body_hand: a coarse wrist of 6 and a fine one of 52") {
    const auto folder = data_folder();
    if (!folder) {
        return;
    }
    const std::string pair = *folder + "/pairs/body_hand/";
    const Soup body = read_soup(pair + "body_741_no_left_hand.obj"), hand = read_soup(pair + "hand_hires.obj");
    const gusset::Stitch stitch = gusset::stitch(body.view(), hand.view());
    CHECK(stitch.rim(0).size() == 6);
    CHECK(stitch.rim(1).size() == 52);
    const Verdict verdict = check_result(stitch, {12, 6, 6});
    // The hand reaches into the arm: the pieces already cut through each other.
    const Verdict before = judge(both(body, hand).view());
    std::cout << "body_hand: self-intersections " << verdict.self_intersections << ", before "
              << before.self_intersections << "\n";
}

TEST_SUITE_END();

} // namespace stitch_tests
