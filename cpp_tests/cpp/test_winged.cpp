// Winged-edge tables and the check, on every real mesh, against Baumgart's rules and the manifest.
#include "data.hpp"
#include "soup.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <iostream>
#include <set>

namespace winged_tests {

namespace {
constexpr uint32_t null = UINT32_MAX;

/// The vertices of a face, walked through the tables over b and e (forwards) or d and c; empty if
/// the cycle does not close.
std::vector<uint32_t> cycle(const gusset::Winged &winged, uint32_t face, bool forwards, std::size_t most) {
    const auto edges = winged.edges();
    const uint32_t first = winged.edge_of_face()[face];
    uint32_t at = first;
    bool right = edges[at].right == face;
    std::vector<uint32_t> vertices;
    while (vertices.size() <= most) {
        const gusset_winged_edge &edge = edges[at];
        if ((right ? edge.right : edge.left) != face) {
            return {};
        }
        const uint32_t from = right ? edge.m : edge.n, to = right ? edge.n : edge.m;
        vertices.push_back(from);
        at = forwards ? (right ? edge.b : edge.e) : (right ? edge.d : edge.c);
        if (at == null) {
            return {};
        }
        const uint32_t joint = forwards ? to : from;
        right = edges[at].right == face && joint == (forwards ? edges[at].m : edges[at].n);
        if (at == first) {
            return vertices;
        }
    }
    return {};
}

std::vector<uint32_t> from_smallest(std::vector<uint32_t> list) {
    std::rotate(list.begin(), std::min_element(list.begin(), list.end()), list.end());
    return list;
}

void check_tables(const Soup &soup, gusset::Winding winding) {
    gusset::WingedOptions options;
    options.winding = winding;
    const gusset::Winged winged(soup.view(), options);
    // And back, corner for corner.
    const gusset_mesh_view mesh = soup.view().get();
    const gusset::WingedFaces faces(winged.edges(), mesh.vertex_count, winged.edge_of_face(), options);
    REQUIRE(faces.offsets().size() == mesh.face_count + 1);
    for (std::size_t f = 0; mesh.face_size == 0 && f <= mesh.face_count; ++f) {
        REQUIRE(faces.offsets()[f] == static_cast<const uint32_t *>(mesh.face_offsets)[f]);
    }
    CHECK(std::equal(faces.corners().begin(), faces.corners().end(), static_cast<const uint32_t *>(mesh.face_corners)));
    std::vector<std::size_t> sides(soup.face_count());
    bool slots = true, marks = true;
    for (const gusset_winged_edge &e : winged.edges()) {
        slots = slots && (e.b == null) == (e.right == null) && (e.d == null) == (e.right == null) &&
                (e.c == null) == (e.left == null) && (e.e == null) == (e.left == null) &&
                !(e.left == null && e.right == null);
        marks = marks && (e.marks == 0 || e.left == null || e.right == null);
        for (uint32_t f : {e.left, e.right}) {
            if (f != null) {
                ++sides[f];
            }
        }
    }
    CHECK(slots);
    CHECK(marks);
    std::size_t wrong = 0;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        const auto face = soup.view().face(f);
        wrong += sides[f] != face.size();
        if (std::set<uint32_t>(face.begin(), face.end()).size() != face.size()) {
            continue;
        }
        std::vector<uint32_t> stored(face.begin(), face.end());
        if (winding == gusset::Winding::counter_clockwise) {
            std::reverse(stored.begin(), stored.end());
        }
        auto there = cycle(winged, static_cast<uint32_t>(f), true, face.size());
        auto back = cycle(winged, static_cast<uint32_t>(f), false, face.size());
        std::reverse(back.begin(), back.end());
        wrong += there.empty() || back.empty() || from_smallest(there) != from_smallest(stored) ||
                 from_smallest(back) != from_smallest(stored);
    }
    CHECK(wrong == 0);
}
} // namespace

TEST_SUITE_BEGIN("real meshes");

TEST_CASE("every real mesh: each face's cycle closes in both directions, each side is there once") {
    for (const DataFile &file : data_files()) {
        CAPTURE(file.name);
        const Soup soup = read_soup(file.path);
        check_tables(soup, gusset::Winding::counter_clockwise);
        check_tables(soup, gusset::Winding::clockwise);

        // The paper's own way to the loops, on the tables.
        const gusset::Winged winged(soup.view());
        const gusset::Check check(soup.view());
        const auto report = check.view();
        if (check.is_oriented() && report.degenerate_faces.count == 0) {
            const gusset::Boundary boundary(soup.view());
            const auto offsets = winged.loop_offsets();
            REQUIRE(offsets.size() == boundary.size() + 1);
            bool equal = true;
            for (std::size_t i = 0; i < boundary.size(); ++i) {
                const auto loop = boundary[i].vertices;
                equal = equal && std::equal(loop.begin(), loop.end(), winged.loop_vertices().begin() + offsets[i],
                                            winged.loop_vertices().begin() + offsets[i + 1]);
            }
            CHECK(equal);
        }
    }
}

TEST_CASE("every real mesh: the check says what the manifest says") {
    for (const DataFile &file : data_files()) {
        CAPTURE(file.name);
        const Soup soup = read_soup(file.path);
        const gusset::Check check(soup.view());
        const gusset_check_view report = check.view();
        CHECK(report.vertex_count == file.vertices);
        CHECK(report.face_count == file.faces);
        CHECK(report.euler == file.euler);
        CHECK(report.unused_vertices.count == file.unused);
        CHECK(report.non_manifold_edges.count == file.non_manifold_edges);
        CHECK(report.orientation_conflicts.count == file.flipped_edges);
        CHECK(report.boundary_edges.count == file.boundary_edges);
        CHECK(check.is_orientable() == file.orientable);
        CHECK(check.is_manifold() == file.manifold);
        CHECK(report.component_count == file.components);
    }
}

TEST_CASE("Euler's formula before and after a stitch") {
    const auto folder = data_folder();
    if (!folder) {
        return;
    }
    const Soup a = read_soup(*folder + "/pairs/bunny_cut/head.off"), b = read_soup(*folder + "/pairs/bunny_cut/body.off");
    for (uint32_t rows : {0u, 3u}) {
        gusset::StitchOptions options;
        options.row_count = rows;
        const gusset::Stitch stitch = gusset::stitch(a.view(), b.view(), options);
        const Soup joined = copy_of(stitch.mesh());
        check_tables(joined, gusset::Winding::counter_clockwise);
        const gusset::Check one(a.view()), other(b.view()), both(joined.view());
        // A closed band has Euler characteristic 0.
        CHECK(both.view().euler == one.view().euler + other.view().euler);
        const gusset::Winged before(a.view()), after(joined.view());
        std::size_t filled = 0, changed = 0;
        for (std::size_t i = 0; i < before.edges().size(); ++i) {
            const gusset_winged_edge &x = before.edges()[i], &y = after.edges()[i];
            changed += x.m != y.m || x.n != y.n;
            for (auto slot : {&gusset_winged_edge::b, &gusset_winged_edge::c, &gusset_winged_edge::d,
                              &gusset_winged_edge::e, &gusset_winged_edge::left, &gusset_winged_edge::right}) {
                filled += x.*slot == null && y.*slot != null;
                changed += x.*slot != null && x.*slot != y.*slot;
            }
        }
        CHECK(changed == 0);
        CHECK(filled == 3 * stitch.rim(0).size());
    }
}

TEST_SUITE_END();

} // namespace winged_tests
