// The same cases from two hosts, OpenMesh and CGAL: both take every face, and they agree.
#include "host.hpp"
#include "judge.hpp"

#include <gusset/cgal.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace hosts_tests {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// A curved sheet of `count` x 3 vertices from y = low to y = low + 1.
Soup sheet(uint32_t count, double low) {
    Soup soup;
    for (uint32_t j = 0; j < 3; ++j) {
        for (uint32_t i = 0; i < count; ++i) {
            const double x = count == 1 ? 0.5 : double(i) / (count - 1);
            soup.points.push_back({x, low + 0.5 * j, 0.2 * std::sin(3.0 * x)});
        }
    }
    for (uint32_t j = 0; j < 2; ++j) {
        for (uint32_t i = 0; i + 1 < count; ++i) {
            const uint32_t v = j * count + i;
            soup.add_face({v, v + 1, v + count + 1, v + count});
        }
    }
    return soup;
}

/// A tube round the z axis of `n` sides from z = low to z = low + 1, faces outwards.
Soup tube(uint32_t n, double low) {
    Soup soup;
    for (uint32_t j = 0; j < 3; ++j) {
        for (uint32_t i = 0; i < n; ++i) {
            const double t = 2.0 * M_PI * i / n;
            soup.points.push_back({std::cos(t), std::sin(t), low + 0.5 * j});
        }
    }
    for (uint32_t j = 0; j < 2; ++j) {
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t a = j * n + i, b = j * n + (i + 1) % n;
            soup.add_face({a, b, b + n, a + n});
        }
    }
    return soup;
}

bool same(const gusset::MeshView &a, const gusset::MeshView &b) {
    if (a.vertex_count() != b.vertex_count() || a.face_count() != b.face_count()) {
        return false;
    }
    for (std::size_t v = 0; v < a.vertex_count(); ++v) {
        if (a.position(v) != b.position(v)) {
            return false;
        }
    }
    for (std::size_t f = 0; f < a.face_count(); ++f) {
        if (!std::equal(a.face(f).begin(), a.face(f).end(), b.face(f).begin(), b.face(f).end())) {
            return false;
        }
    }
    return true;
}

CgalMesh cgal_mesh(const Soup &soup) {
    CgalMesh mesh;
    REQUIRE(gusset::cgal::append(mesh, soup.view()).empty());
    return mesh;
}

/// Stitches from both hosts, gives each its result, and has both accept every face of it.
void agree(const Soup &a, const Soup &b, const gusset::StitchOptions &options, std::size_t boundaries) {
    const auto om_a = host_mesh(a), om_b = host_mesh(b);
    REQUIRE((om_a && om_b));
    const CgalMesh cg_a = cgal_mesh(a), cg_b = cgal_mesh(b);
    // A face may start at another corner in each host, so the loops are found in each; the strip is
    // the same.
    const gusset::openmesh::Input in_a(*om_a), in_b(*om_b);
    const gusset::cgal::Input<Kernel::Point_3> input_a(cg_a), input_b(cg_b);
    const gusset::Stitch by_openmesh = gusset::stitch(in_a.view(), in_b.view(), options);
    const gusset::Stitch by_cgal = gusset::stitch(input_a.view(), input_b.view(), options);
    CHECK(same(by_openmesh.strip(), by_cgal.strip()));

    HostMesh openmesh;
    CHECK(gusset::openmesh::append(openmesh, by_openmesh.mesh()).empty());
    CHECK(walks(openmesh).size() == boundaries);
    CgalMesh cgal;
    CHECK(gusset::cgal::append(cgal, by_cgal.mesh()).empty());
    CHECK(CGAL::is_valid_polygon_mesh(cgal));
    const Verdict verdict = judge(by_cgal.mesh(), false);
    CHECK(verdict.is_mesh);
    CHECK(verdict.boundary.size() == boundaries);
    const gusset::Check check(by_cgal.mesh());
    const auto report = check.view();
    CHECK(report.component_count == verdict.components);
    CHECK(report.euler == verdict.euler);
}
} // namespace

TEST_CASE("positions are read where CGAL keeps them, removed elements are not there") {
    CgalMesh mesh = cgal_mesh(sheet(5, 0.0));
    {
        const gusset::cgal::Input<Kernel::Point_3> input(mesh);
        CHECK(input.view().get().positions == static_cast<const void *>(&mesh.point(CgalMesh::Vertex_index(0))));
        CHECK(gusset::Boundary(input.view()).size() == 1);
    }
    // Two faces at a corner, and the vertices that only they have.
    CGAL::Euler::remove_face(mesh.halfedge(CgalMesh::Face_index(0)), mesh);
    const gusset::cgal::Input<Kernel::Point_3> input(mesh);
    CHECK(input.view().vertex_count() == 15);
    CHECK(input.view().face_count() == 7);
    CHECK(input.face(0) == CgalMesh::Face_index(1));
    const gusset::Boundary boundary(input.view());
    REQUIRE(boundary.size() == 1);
    for (std::size_t i = 0; i < boundary[0].half_edges.size(); ++i) {
        const auto v = input.vertex(boundary[0].vertices[i]);
        const auto w = input.vertex(boundary[0].vertices[(i + 1) % boundary[0].vertices.size()]);
        const auto h = mesh.halfedge(v, w);
        CHECK(mesh.face(h) == input.face(boundary[0].faces[i]));
        CHECK(mesh.is_border(mesh.opposite(h)));
    }
    using Simple = CGAL::Simple_cartesian<double>;
    CGAL::Surface_mesh<Simple::Point_3> simple;
    CHECK(gusset::cgal::append(simple, sheet(3, 0.0).view()).empty());
    CHECK(gusset::Boundary(gusset::cgal::Input<Simple::Point_3>(simple).view()).size() == 1);
}

TEST_CASE("arcs and loops, rows, triangles and quads: both hosts take every face and agree") {
    for (auto cells : {gusset::StripCells::triangles, gusset::StripCells::quads}) {
        for (auto rule : {gusset::Meridians::min_area, gusset::Meridians::index}) {
            for (uint32_t rows : {0u, 1u, 4u, 10u}) {
                gusset::StitchOptions options;
                options.cells = cells;
                options.meridians = rule;
                options.row_count = rows;
                for (auto [n, m] : {std::pair{3u, 3u}, {2u, 9u}, {9u, 2u}, {50u, 37u}, {21u, 50u}}) {
                    CAPTURE(n);
                    CAPTURE(m);
                    CAPTURE(rows);
                    options.extent = gusset::StitchExtent::open_arcs;
                    agree(sheet(n, 0.0), sheet(m, 2.5), options, 1);
                    if (n >= 3 && m >= 3) {
                        options.extent = gusset::StitchExtent::whole_loops;
                        agree(tube(n, 0.0), tube(m, 1.5), options, 2);
                    }
                }
            }
        }
    }
}

TEST_CASE("arcs of every length from 1 to 50: both hosts take every face") {
    // A wide sheet each; the arcs lie in the middle of the sides that face each other.
    const uint32_t width = 60;
    const Soup a = sheet(width, 0.0), b = sheet(width, 2.5);
    const gusset::Boundary rim_a(a.view()), rim_b(b.view());
    const auto place = [](const gusset::Boundary &rim, uint32_t v) {
        const auto loop = rim[0].vertices;
        return static_cast<uint32_t>(std::find(loop.begin(), loop.end(), v) - loop.begin());
    };
    for (uint32_t n = 1; n <= 50; ++n) {
        for (uint32_t m = 1; m <= 50; ++m) {
            CAPTURE(n);
            CAPTURE(m);
            gusset::StitchOptions options;
            options.extent = gusset::StitchExtent::arcs;
            // The upper side of A runs from right to left, the lower side of B from left to right.
            options.arc_a = {place(rim_a, 3 * width - 1 - (width - n) / 2), n};
            options.arc_b = {place(rim_b, (width - m) / 2), m};
            options.row_count = (7 * n + m) % 11;
            options.cells = (n + m) % 2 == 0 ? gusset::StripCells::quads : gusset::StripCells::triangles;
            options.meridians = n % 2 == 0 ? gusset::Meridians::min_area : gusset::Meridians::index;
            const gusset::Stitch stitch = gusset::stitch(a.view(), b.view(), options);
            HostMesh openmesh;
            REQUIRE(gusset::openmesh::append(openmesh, stitch.mesh()).empty());
            CgalMesh cgal;
            REQUIRE(gusset::cgal::append(cgal, stitch.mesh()).empty());
            CHECK(CGAL::is_valid_polygon_mesh(cgal));
            CHECK(gusset::Check(stitch.mesh()).is_oriented());
            // A single vertex is touched by its fan at that vertex only: a bow-tie.
            CHECK(gusset::Check(stitch.mesh()).is_manifold() == ((n > 1 && m > 1) || (n == 1 && m == 1)));
        }
    }
}

namespace {
/// Half-way between two bowls, one of which is all 1 and the other all 3, is 2, in every kind of property.
template <class Read>
void check_means(const gusset::Stitch &stitch, Read &&value) {
    const std::size_t first = stitch.vertex_map(0).size(), old = first + stitch.vertex_map(1).size();
    for (std::size_t v = 0; v < stitch.mesh().vertex_count(); ++v) {
        CHECK(value(v) == doctest::Approx(v < first ? 1 : v < old ? 3 : 2));
    }
}
} // namespace

TEST_CASE("properties of OpenMesh are carried over") {
    HostMesh a = host_mesh(tube(9, 0)).value(), b = host_mesh(tube(7, 1.5)).value();
    double value = 1;
    for (HostMesh *mesh : {&a, &b}) {
        OpenMesh::VPropHandleT<double> own;
        mesh->add_property(own, "own");
        mesh->request_vertex_normals();
        mesh->request_halfedge_texcoords2D();
        mesh->request_face_texture_index();
        for (const auto v : mesh->vertices()) {
            mesh->property(own, v) = value;
            mesh->set_normal(v, HostMesh::Normal(1, 0, 0));
        }
        for (const auto f : mesh->faces()) {
            mesh->set_texture_index(f, static_cast<int>(-value));
            for (auto h = mesh->cfh_ccwbegin(f); h.is_valid(); ++h) {
                const auto p = mesh->point(mesh->to_vertex_handle(*h));
                mesh->set_texcoord2D(*h, {static_cast<float>(std::atan2(p[1], p[0])), static_cast<float>(p[2])});
            }
        }
        value = 3;
    }
    const gusset::openmesh::Input<HostMesh> left(a), right(b);
    gusset::StitchOptions options;
    options.row_count = 1;
    const gusset::Stitch stitch = gusset::stitch(left.view(), right.view(), options);
    HostMesh joined;
    CHECK(gusset::openmesh::append(joined, stitch.mesh(), stitch.origins(), {&a, &b}).empty());
    OpenMesh::VPropHandleT<double> own;
    REQUIRE(joined.get_property_handle(own, "own"));
    check_means(stitch, [&](std::size_t v) { return joined.property(own, OpenMesh::VertexHandle(static_cast<int>(v))); });
    REQUIRE(joined.has_vertex_normals());
    REQUIRE(joined.has_halfedge_texcoords2D());
    REQUIRE(joined.has_face_texture_index());
    for (const auto v : joined.vertices()) {
        CHECK(joined.normal(v)[0] == doctest::Approx(1));
    }
    for (const auto f : joined.faces()) {
        CHECK((joined.texture_index(f) == -1 || joined.texture_index(f) == -3));
        if (static_cast<std::size_t>(f.idx()) < a.n_faces()) {
            for (auto h = joined.cfh_ccwbegin(f); h.is_valid(); ++h) {
                const auto p = joined.point(joined.to_vertex_handle(*h));
                CHECK(joined.texcoord2D(*h)[0] == static_cast<float>(std::atan2(p[1], p[0])));
            }
        }
    }
}

TEST_CASE("property maps of CGAL are carried over") {
    CgalMesh a = cgal_mesh(tube(9, 0)), b = cgal_mesh(tube(7, 1.5));
    double value = 1;
    for (CgalMesh *mesh : {&a, &b}) {
        const auto own = mesh->add_property_map<CgalMesh::Vertex_index, double>("own").first;
        const auto normals = mesh->add_property_map<CgalMesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
        const auto colours = mesh->add_property_map<CgalMesh::Vertex_index, CGAL::IO::Color>("v:color").first;
        const auto uv = mesh->add_property_map<CgalMesh::Halfedge_index, std::array<double, 2>>("h:uv").first;
        for (const auto v : mesh->vertices()) {
            own[v] = value, normals[v] = Kernel::Vector_3(0, 1, 0), colours[v] = CGAL::IO::Color(static_cast<unsigned char>(10 * value), 0, 0);
        }
        for (const auto f : mesh->faces()) {
            for (const auto h : mesh->halfedges_around_face(mesh->halfedge(f))) {
                const auto p = mesh->point(mesh->target(h));
                uv[h] = {p.x(), p.z()};
            }
        }
        value = 3;
    }
    const gusset::cgal::Input<Kernel::Point_3> left(a), right(b);
    gusset::StitchOptions options;
    options.row_count = 1;
    const gusset::Stitch stitch = gusset::stitch(left.view(), right.view(), options);
    CgalMesh joined;
    CHECK(gusset::cgal::append(joined, stitch.mesh(), stitch.origins(), {&a, &b}).empty());
    const auto own = joined.property_map<CgalMesh::Vertex_index, double>("own");
    const auto normals = joined.property_map<CgalMesh::Vertex_index, Kernel::Vector_3>("v:normal");
    const auto colours = joined.property_map<CgalMesh::Vertex_index, CGAL::IO::Color>("v:color");
    const auto uv = joined.property_map<CgalMesh::Halfedge_index, std::array<double, 2>>("h:uv");
    REQUIRE((own.second && normals.second && colours.second && uv.second));
    check_means(stitch, [&](std::size_t v) { return own.first[CgalMesh::Vertex_index(static_cast<CgalMesh::size_type>(v))]; });
    check_means(stitch, [&](std::size_t v) { return colours.first[CgalMesh::Vertex_index(static_cast<CgalMesh::size_type>(v))].red() / 10.0; });
    for (const auto v : joined.vertices()) {
        CHECK(normals.first[v].y() == doctest::Approx(1));
    }
    std::size_t face = 0;
    for (const auto f : joined.faces()) {
        for (const auto h : joined.halfedges_around_face(joined.halfedge(f))) {
            const auto p = joined.point(joined.target(h));
            CHECK((face >= a.number_of_faces() || uv.first[h] == std::array<double, 2>{p.x(), p.z()}));
        }
        ++face;
    }
}

TEST_CASE("the strip goes into the hosts' own meshes, new vertices too") {
    Soup both = tube(12, 0.0);
    const Soup high = tube(9, 1.5);
    const auto first = static_cast<uint32_t>(both.points.size());
    both.points.insert(both.points.end(), high.points.begin(), high.points.end());
    for (std::size_t f = 0; f < high.face_count(); ++f) {
        std::vector<uint32_t> face;
        for (uint32_t v : high.view().face(f)) {
            face.push_back(v + first);
        }
        both.add_face(face);
    }
    gusset::StitchOptions options;
    options.row_count = 2;
    CgalMesh cgal = cgal_mesh(both);
    CHECK(gusset::cgal::append_strip(cgal, gusset::stitch_within(gusset::cgal::Input<Kernel::Point_3>(cgal).view(), options)).empty());
    CHECK(CGAL::is_valid_polygon_mesh(cgal));
    auto openmesh = host_mesh(both);
    REQUIRE(openmesh);
    CHECK(gusset::openmesh::append_strip(*openmesh, gusset::stitch_within(gusset::openmesh::Input(*openmesh).view(), options)).empty());
    CHECK(openmesh->n_faces() == cgal.number_of_faces());
    CHECK(openmesh->n_vertices() == cgal.number_of_vertices());
    CHECK(walks(*openmesh).size() == 2);
}

} // namespace hosts_tests
