// Welding, orienting and repairing, with CGAL as judge: its own stitching of borders, and its
// check of results.
#include "cgal_soup.hpp"
#include "data.hpp"
#include "judge.hpp"
#include "soup.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Surface_mesh.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace repair_tests {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Lengths = std::vector<std::size_t>;

/// All pieces, one after the other.
Soup together(const std::vector<Soup> &pieces) {
    Soup whole;
    for (const Soup &piece : pieces) {
        const auto first = static_cast<uint32_t>(whole.points.size());
        whole.points.insert(whole.points.end(), piece.points.begin(), piece.points.end());
        for (std::size_t f = 0; f < piece.face_count(); ++f) {
            std::vector<uint32_t> face;
            for (uint32_t v : piece.view().face(f)) {
                face.push_back(v + first);
            }
            whole.add_face(face);
        }
    }
    return whole;
}

/// Every face with vertices of its own, in an order of chance, some faces turned over.
Soup shattered(const Soup &soup, unsigned seed, bool turn) {
    std::mt19937 random(seed);
    Soup pieces;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        std::vector<uint32_t> face;
        for (uint32_t v : soup.view().face(f)) {
            face.push_back(static_cast<uint32_t>(pieces.points.size()));
            pieces.points.push_back(soup.points[v]);
        }
        if (turn && random() % 2 == 0) {
            std::reverse(face.begin(), face.end());
        }
        pieces.add_face(face);
    }
    std::vector<uint32_t> place(pieces.points.size());
    for (uint32_t v = 0; v < place.size(); ++v) {
        place[v] = v;
    }
    std::shuffle(place.begin(), place.end(), random);
    Soup shuffled = pieces;
    for (uint32_t v = 0; v < place.size(); ++v) {
        shuffled.points[place[v]] = pieces.points[v];
    }
    for (uint32_t &v : shuffled.corners) {
        v = place[v];
    }
    return shuffled;
}

Soup torus(uint32_t n, uint32_t m) {
    Soup soup;
    for (uint32_t i = 0; i < n; ++i) {
        for (uint32_t j = 0; j < m; ++j) {
            const double s = 2 * M_PI * i / n, t = 2 * M_PI * j / m;
            soup.points.push_back({(2 + std::cos(t)) * std::cos(s), (2 + std::cos(t)) * std::sin(s), std::sin(t)});
        }
    }
    for (uint32_t i = 0; i < n; ++i) {
        for (uint32_t j = 0; j < m; ++j) {
            const uint32_t a = (i + 1) % n, b = (j + 1) % m;
            soup.add_face({i * m + j, a * m + j, a * m + b, i * m + b});
        }
    }
    return soup;
}

/// Welded and oriented, closed pieces outwards.
Soup repaired(const Soup &soup, const gusset::WeldOptions &options = {}) {
    const gusset::Weld weld(soup.view(), options);
    gusset::OrientOptions outwards;
    outwards.outward = gusset::Outward::closed;
    const gusset::Orient orient(weld.mesh(), outwards);
    return copy_of(orient.mesh());
}

void check_shape(const Soup &soup, std::size_t vertices, std::size_t faces, long euler, const Lengths &boundary) {
    CHECK(soup.points.size() == vertices);
    CHECK(soup.face_count() == faces);
    const Verdict verdict = judge(soup.view(), false);
    CHECK(verdict.is_mesh);
    CHECK(verdict.euler == euler);
    CHECK(verdict.boundary == boundary);
}

/// Used vertices, boundary edges, and sets of faces that hang together across edges.
struct Sewn {
    std::size_t vertices = 0, border = 0, components = 0;
};

/// The result of CGAL's stitch_borders, for meshes whose sheets have one orientation.
Sewn stitched_by_cgal(const Soup &soup) {
    auto [points, faces] = CgalSoup<Kernel::Point_3>(soup.view());
    REQUIRE(PMP::is_polygon_soup_a_polygon_mesh(faces));
    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    PMP::polygon_soup_to_polygon_mesh(points, faces, mesh);
    PMP::stitch_borders(mesh);
    mesh.collect_garbage();
    Sewn sewn;
    for (auto v : mesh.vertices()) {
        sewn.vertices += !mesh.is_isolated(v);
    }
    for (auto e : mesh.edges()) {
        sewn.border += mesh.is_border(e);
    }
    auto component = mesh.add_property_map<CGAL::SM_Face_index, std::size_t>("f:component", 0).first;
    sewn.components = PMP::connected_components(mesh, component);
    return sewn;
}

Sewn sewn_by_us(const Soup &soup) {
    gusset::WeldOptions options;
    options.tolerance = 0; // CGAL stitches equal points only.
    const gusset::Weld weld(soup.view(), options);
    const gusset::Check check(weld.mesh());
    const auto report = check.view();
    CHECK(report.non_manifold_edges.count == 0);
    CHECK(report.bow_ties.count == 0);
    return {report.vertex_count - report.unused_vertices.count, report.boundary_edges.count, report.component_count};
}
} // namespace

TEST_CASE("a torus in single faces, turned by chance: one torus outwards") {
    const Soup whole = torus(24, 13);
    for (unsigned seed = 1; seed <= 5; ++seed) {
        for (auto vertices : {gusset::WeldVertices::boundary, gusset::WeldVertices::all}) {
            gusset::WeldOptions options;
            options.vertices = vertices;
            const Soup pieces = shattered(whole, seed, true);
            const Soup result = repaired(pieces, options);
            check_shape(result, 24 * 13, 24 * 13, 0, {});
            CHECK(judge(result.view()).bounds_a_volume);
            const gusset::Weld weld(pieces.view(), options);
            CHECK(weld.welded_vertices() == 3 * 24 * 13);
            CHECK(weld.sewn_edges() == 2 * 24 * 13);
            CHECK(weld.left_edges().empty());
            CHECK(weld.left_vertices().empty());
        }
    }
}

TEST_CASE("a tolerance sews what noise has moved, and no more") {
    const Soup whole = torus(24, 13);
    Soup pieces = shattered(whole, 7, false);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> noise(-1e-4, 1e-4);
    for (auto &p : pieces.points) {
        for (double &x : p) {
            x += noise(random);
        }
    }
    CHECK(gusset::Weld(pieces.view()).welded_vertices() == 0);
    gusset::WeldOptions options;
    options.tolerance = 1e-3;
    check_shape(repaired(pieces, options), 24 * 13, 24 * 13, 0, {});
}

TEST_CASE("what seven digits of a file round apart is sewn by default") {
    const Soup whole = torus(24, 13);
    Soup pieces = shattered(whole, 7, false);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> noise(-1e-7, 1e-7);
    for (auto &p : pieces.points) {
        for (double &x : p) {
            char text[32];
            std::snprintf(text, sizeof text, "%.7g", x + noise(random));
            x = std::strtod(text, nullptr);
        }
    }
    const gusset::Weld weld(pieces.view());
    CHECK(weld.tolerance() > 1.9e-6);
    CHECK(weld.tolerance() < 2.1e-5);
    check_shape(repaired(pieces), 24 * 13, 24 * 13, 0, {});
    gusset::WeldOptions exact;
    exact.tolerance = 0.0;
    CHECK(gusset::Weld(pieces.view(), exact).sewn_edges() < weld.sewn_edges());
}

TEST_CASE("the tolerance that sews two sheets is named") {
    const std::vector<std::array<double, 3>> points = {{0, 0, 0},      {1, 0, 0},      {1, 1, 0},      {0, 1, 0},
                                                       {1.0001, 0, 0}, {2.0001, 0, 0}, {2.0001, 1, 0}, {1.0001, 1, 0}};
    const std::vector<uint32_t> offsets = {0, 4, 8}, corners = {0, 1, 2, 3, 4, 5, 6, 7};
    const gusset::MeshView sheets = gusset::MeshView::polygons(points, gusset::Offsets(offsets), gusset::Corners(corners));
    const gusset::Weld apart(sheets);
    CHECK(apart.sewn_edges() == 0);
    CHECK(apart.near_edge_pairs() == 1);
    CHECK(apart.near_tolerance() >= 1e-4);
    CHECK(apart.near_tolerance() <= 1.1e-4);
    gusset::WeldOptions options;
    options.tolerance = apart.near_tolerance();
    const gusset::Sew sewn(sheets, options);
    CHECK(sewn.sewn_edges() == 1);
    CHECK(sewn.near_edge_pairs() == 0);
    CHECK(sewn.near_tolerance() == 0.0);
}

TEST_CASE("borders with different vertices are sewn") {
    // A square of two triangles on a square of one, below, whose upper side has three further vertices.
    Soup soup;
    soup.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {4, -4, 0}, {0, -4, 0}};
    soup.add_face({0, 1, 2});
    soup.add_face({0, 2, 3});
    soup.add_face({10, 9, 8, 7, 6, 5, 4});
    CHECK(gusset::Weld(soup.view()).sewn_edges() == 0);
    const gusset::Sew sew(soup.view());
    CHECK(sew.splits() == 3);
    CHECK(sew.sewn_edges() == 4);
    CHECK(sew.split_faces() == 1);
    CHECK(sew.left_vertices().empty());
    CHECK(std::vector<uint32_t>(sew.face_origin().begin(), sew.face_origin().end()) ==
          std::vector<uint32_t>{0, 0, 0, 0, 1, 2});
    CHECK(std::vector<uint32_t>(sew.face_map().begin(), sew.face_map().end()) == std::vector<uint32_t>{0, 4, 5});
    const gusset::Check check(sew.mesh());
    const auto report = check.view();
    CHECK(report.euler == 1);
    CHECK(report.boundary_edges.count == 6);
}

TEST_CASE("bad options are errors with their status") {
    const Soup soup = torus(5, 4);
    gusset::WeldOptions options;
    options.tolerance = -1.0;
    try {
        gusset::Weld(soup.view(), options);
        FAIL("not refused");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_OUT_OF_RANGE);
        CHECK(error.report().value == -1.0);
    }
}

TEST_CASE("maps, lists and flags tell what became of the old mesh") {
    Soup soup;
    soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, -0.0}, {1, 1, 0}};
    soup.add_face({0, 1, 2});
    soup.add_face({4, 5, 6});
    gusset::WeldOptions options;
    options.unused = gusset::Unused::remove;
    const gusset::Weld weld(soup.view(), options);
    CHECK(std::vector<uint32_t>(weld.vertex_map().begin(), weld.vertex_map().end()) ==
          std::vector<uint32_t>{0, 1, 2, gusset::Weld::none, 1, 2, 3});
    CHECK(std::vector<uint32_t>(weld.face_map().begin(), weld.face_map().end()) == std::vector<uint32_t>{0, 1});
    CHECK(weld.dropped_faces() == 0);
    const gusset::Orient orient(weld.mesh());
    CHECK(orient.component_count() == 1);
    CHECK(orient.turned_faces() == 1);
    CHECK(std::vector<int>(orient.turned().begin(), orient.turned().end()) == std::vector<int>{0, 1});
    CHECK(std::vector<uint32_t>(orient.mesh().face(1).begin(), orient.mesh().face(1).end()) ==
          std::vector<uint32_t>{1, 3, 2});
    CHECK(orient.inverted_components() == 0);
    CHECK(orient.one_sided_faces().empty());
    CHECK(orient.one_sided_half_edges().empty());
}

TEST_CASE("triangles of concave faces do not intersect") {
    for (unsigned seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> share(0.2, 1.0);
        // A prism over a star, or over a comb whose teeth have random lengths.
        const uint32_t n = 8 + 2 * (random() % 16);
        std::vector<std::array<double, 2>> outline;
        for (uint32_t k = 0; k < n; ++k) {
            const double angle = 6.283185307179586 * k / n, radius = share(random);
            outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
        for (uint32_t k = 0; seed % 2 == 1 && k < n; ++k) {
            outline[k] = k < 2 ? std::array<double, 2>{k * (n + 1.0), -1} : std::array<double, 2>{double(n + 1 - k), k % 2 ? 0 : 9 * share(random)};
        }
        Soup prism;
        std::vector<uint32_t> top, base;
        for (uint32_t k = 0; k < n; ++k) {
            prism.points.push_back({outline[k][0], outline[k][1], 0});
            prism.points.push_back({outline[k][0], outline[k][1], 1});
            top.push_back(2 * k + 1);
            base.push_back(2 * (n - 1 - k));
            prism.add_face({2 * k, 2 * ((k + 1) % n), 2 * ((k + 1) % n) + 1, 2 * k + 1});
        }
        prism.add_face(top);
        prism.add_face(base);
        const gusset::Triangulation triangulation(prism.view());
        CHECK(triangulation.mesh().face_count() == 4 * n - 4);
        const Verdict verdict = judge(triangulation.mesh());
        CHECK(verdict.bounds_a_volume);
        CHECK(verdict.self_intersections == 0);
    }
}

TEST_SUITE_BEGIN("real meshes");

TEST_CASE("boeing: 122 sheets, some inside out, become one closed manifold") {
    const auto folder = data_folder();
    if (!folder) {
        return;
    }
    const Soup soup = read_soup(*folder + "/meshes/boeing.off");
    const gusset::Weld weld(soup.view());
    CHECK(weld.welded_vertices() == 1477);
    CHECK(weld.sewn_edges() == 2714 / 2);
    CHECK(weld.left_edges().empty());
    CHECK(weld.left_vertices().empty());
    const gusset::Orient orient(weld.mesh());
    CHECK(orient.component_count() == 1);
    CHECK(orient.one_sided_faces().empty());
    check_shape(copy_of(orient.mesh()), 1264, 2564, -18, {});

    // CGAL's way: merge equal points of the soup, then turn faces; as it needs to cut nothing, the
    // same faces come out.
    auto [points, faces] = CgalSoup<Kernel::Point_3>(soup.view());
    PMP::merge_duplicate_points_in_polygon_soup(points, faces);
    CHECK(points.size() == 1264);
    CHECK(PMP::orient_polygon_soup(points, faces));
    CHECK(points.size() == 1264);
    // Both are oriented, each its own way.
    std::size_t same = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto now = orient.mesh().face(f);
        std::vector<std::array<double, 3>> ours, theirs;
        for (std::size_t k = 0; k < 3; ++k) {
            ours.push_back(orient.mesh().position(now[k]));
            const auto &p = points[faces[f][k]];
            theirs.push_back({p.x(), p.y(), p.z()});
        }
        std::rotate(theirs.begin(), std::find(theirs.begin(), theirs.end(), ours[0]), theirs.end());
        same += ours == theirs;
    }
    CHECK((same == 0 || same == faces.size()));
    std::cout << "boeing: " << orient.turned_faces() << " faces turned over\n";
}

TEST_CASE("combustor: three pieces with equal borders become a torus") {
    const auto folder = data_folder();
    if (!folder) {
        return;
    }
    const std::string pieces = *folder + "/pairs/combustor/";
    for (const char *first : {"walls", "inlet"}) {
        const bool walls = first == std::string("walls");
        const Soup soup = together({read_soup(pieces + first + ".stl"), read_soup(pieces + (walls ? "inlet" : "walls") + ".stl"),
                                    read_soup(pieces + "outlet.stl")});
        const gusset::Weld weld(soup.view());
        CHECK(weld.left_edges().empty());
        check_shape(repaired(soup), 1728, 3456, 0, {});
        const Verdict verdict = judge(repaired(soup).view());
        CHECK(verdict.components == 1);
        CHECK(verdict.bounds_a_volume);
    }
}

TEST_CASE("CGAL's own cases of stitching") {
    const auto folder = data_folder();
    if (!folder) {
        return;
    }
    const std::string pairs = *folder + "/pairs/";
    // A seam in one sheet; the other sheet stays.
    const Soup mask = read_soup(pairs + "mask_cone.off");
    check_shape(repaired(mask), 1200, 2332, 2, {34, 30});
    check_shape(repaired(read_soup(pairs + "quads_to_stitch.off")), 15, 8, 1, {12});

    // A border edge without length faces a vertex: what would collapse the face there is left and
    // listed, unless it may collapse.
    const Soup degenerate = read_soup(pairs + "deg_border.off");
    const gusset::Weld left(degenerate.view());
    CHECK(left.left_edges().size() == 2);
    CHECK(gusset::Check(left.mesh()).is_manifold());
    gusset::WeldOptions collapse;
    collapse.collapse = gusset::Collapse::allow;
    CHECK(gusset::Weld(degenerate.view(), collapse).dropped_faces() == 1);
    check_shape(repaired(degenerate, collapse), 6, 6, 1, {4});

    // Two sheets on top of each other; all welded, their diagonals would make one edge of four
    // faces.
    const Soup twice = read_soup(pairs + "non_manifold2.off");
    const gusset::Weld careful(twice.view());
    CHECK(gusset::Check(careful.mesh()).is_manifold());
    CHECK(!careful.left_edges().empty());
    gusset::WeldOptions all;
    all.vertices = gusset::WeldVertices::all;
    const gusset::Weld welded_all(twice.view(), all);
    const gusset::Check check(welded_all.mesh());
    CHECK(check.view().non_manifold_edges.count == 1);
}

TEST_CASE("every oriented mesh: borders are sewn as CGAL's stitch_borders does") {
    std::size_t compared = 0;
    for (const DataFile &file : data_files()) {
        // CGAL takes oriented sheets only, and sews nothing of two sheets on top of each other.
        if (!file.manifold || file.flipped_edges > 0 || file.name == "pairs/non_manifold2.off") {
            continue;
        }
        CAPTURE(file.name);
        const Soup soup = read_soup(file.path);
        const Sewn ours = sewn_by_us(soup);
        if (file.name == "meshes/boeing.off") {
            // Sheets against each other stay two for CGAL, so that it leaves more.
            CHECK(ours.border < stitched_by_cgal(soup).border);
            continue;
        }
        const Sewn theirs = stitched_by_cgal(soup);
        CHECK(ours.vertices == theirs.vertices);
        CHECK(ours.border == theirs.border);
        CHECK(ours.components == theirs.components);
        ++compared;
    }
    std::cout << compared << " meshes sewn as by CGAL\n";
}

TEST_CASE("every mesh in single faces, turned by chance, comes back") {
    for (const DataFile &file : data_files()) {
        // A face that collapses, and two sheets in one place, have nothing to come back to.
        if (file.name == "pairs/deg_border.off" || file.name == "pairs/non_manifold2.off") {
            continue;
        }
        CAPTURE(file.name);
        const Soup soup = read_soup(file.path), pieces = shattered(soup, 3, true);
        const gusset::Weld weld(pieces.view()), whole(soup.view());
        const gusset::Orient orient(weld.mesh());
        const gusset::Check check(orient.mesh());
        CHECK(check.is_manifold());
        CHECK(orient.mesh().face_count() == soup.face_count());
        CHECK(2 * orient.turned_faces() <= soup.face_count());
        if (file.non_manifold_edges > 0) {
            // Where three or more faces meet, each keeps a border of its own.
            CHECK(weld.left_edges().size() >= 3 * file.non_manifold_edges);
            continue;
        }
        CHECK(check.is_oriented());
        CHECK(weld.left_edges().empty());
        const gusset::Check unbroken(whole.mesh());
        const auto now = check.view(), then = unbroken.view();
        CHECK(now.boundary_edges.count == then.boundary_edges.count);
        CHECK(now.edge_count == then.edge_count);
        CHECK(now.component_count == then.component_count);
        // Where surfaces touch in a point (pig.stl) they come apart; else nothing is different.
        if (file.manifold) {
            const Verdict verdict = judge(orient.mesh(), false);
            CHECK(verdict.is_mesh);
            CHECK(verdict.euler == then.euler);
            CHECK(now.vertex_count == then.vertex_count - then.unused_vertices.count);
        }
    }
}

TEST_CASE("every mesh as a triangle soup: as many vertices as points, as CGAL counts them") {
    for (const DataFile &file : data_files()) {
        CAPTURE(file.name);
        const Soup pieces = shattered(read_soup(file.path), 5, false);
        gusset::WeldOptions options;
        options.vertices = gusset::WeldVertices::all;
        options.collapse = gusset::Collapse::allow;
        options.tolerance = 0; // CGAL merges equal points only.
        auto [points, faces] = CgalSoup<Kernel::Point_3>(pieces.view());
        PMP::merge_duplicate_points_in_polygon_soup(points, faces);
        const gusset::Weld of_pieces(pieces.view(), options);
        CHECK(of_pieces.mesh().vertex_count() == points.size());
    }
}

TEST_CASE("repaired meshes that are called valid bound a volume, as CGAL sees it") {
    std::size_t valid = 0;
    for (const DataFile &file : data_files()) {
        CAPTURE(file.name);
        const Soup soup = read_soup(file.path);
        const gusset::Repair repaired(soup.view());
        if (!repaired.valid()) {
            continue;
        }
        ++valid;
        const Verdict verdict = judge(repaired.mesh());
        CHECK(verdict.is_mesh);
        CHECK(verdict.closed);
        // For CGAL, copies of a vertex that separate sheets are intersections.
        if (repaired.report().split_vertices == 0) {
            CHECK(verdict.bounds_a_volume);
            CHECK(verdict.self_intersections == 0);
        }
        // Each old face is there, or listed.
        std::vector<bool> found(soup.face_count());
        for (const uint32_t face : repaired.face_origin()) {
            if (face != gusset::Repair::none) {
                found[face] = true;
            }
        }
        for (const uint32_t face : repaired.dropped_faces()) {
            CHECK_FALSE(found[face]);
            found[face] = true;
        }
        CHECK(std::count(found.begin(), found.end(), false) == 0);
    }
    CHECK((data_files().empty() || valid > 0));
}

TEST_SUITE_END();

} // namespace repair_tests
