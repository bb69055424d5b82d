// Nets from C++: the surfaces that they are and the meshes that they become, judged by CGAL and
// OpenMesh.
#include "cgal_soup.hpp"
#include "data.hpp"
#include "host.hpp"
#include "judge.hpp"
#include "nets.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace net_tests {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using gusset::NetComplex;
using gusset::NetFaces;
using gusset::NetMesh;
using gusset::NetMeshOptions;

NetMeshOptions with_faces(NetFaces faces) {
    NetMeshOptions options;
    options.faces = faces;
    return options;
}

Surface surface_of(const gusset::MeshView &view) {
    auto [points, faces] = CgalSoup<Kernel::Point_3>(view);
    REQUIRE(PMP::is_polygon_soup_a_polygon_mesh(faces));
    Surface mesh;
    PMP::polygon_soup_to_polygon_mesh(points, faces, mesh);
    return mesh;
}

/// Vertices - edges + faces, counted here.
long euler_of(const gusset::MeshView &mesh) {
    std::set<std::pair<uint32_t, uint32_t>> edges;
    std::set<uint32_t> vertices;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t k = 0; k < face.size(); ++k) {
            edges.insert(std::minmax(face[k], face[(k + 1) % face.size()]));
            vertices.insert(face[k]);
        }
    }
    return static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) + static_cast<long>(mesh.face_count());
}
} // namespace

TEST_CASE("closed shapes are closed meshes, outwards") {
    for (const auto &[name, shape, euler] : closed_shapes()) {
        CAPTURE(name);
        const Net net = Net::from_primitive(shape);
        const NetComplex complex(net);
        CHECK(complex.is_closed());
        CHECK(complex.is_manifold());
        CHECK(complex.is_oriented());
        CHECK(complex.is_orientable());
        CHECK(complex.euler() == euler);
        CHECK(complex.genus() == (2 - euler) / 2);
        CHECK(complex.boundary_count() == 0);
        CHECK(gusset::NetValidation(net).is_valid());

        const double volume = net.measure().volume;
        CHECK(volume > 0.0);
        CHECK(net.measure(gusset::NetMeasures::body).body_volume == doctest::Approx(volume).epsilon(1e-12));
        for (NetFaces faces : {NetFaces::quads, NetFaces::triangles_shorter, NetFaces::triangles_fixed}) {
            const NetMesh mesh(net, with_faces(faces));
            const Verdict verdict = judge(mesh.mesh());
            CHECK(verdict.is_mesh);
            CHECK(verdict.closed);
            CHECK(verdict.bounds_a_volume);
            CHECK(verdict.components == 1);
            CHECK(verdict.euler == euler);
            CHECK(gusset::Check(mesh.mesh()).is_closed());
            CHECK(gusset::Boundary(mesh.mesh()).empty());
            CHECK(mesh.wires().empty());
            HostMesh host;
            CHECK(gusset::openmesh::append(host, mesh.mesh()).empty());
            CHECK(walks(host).empty());
        }
        // The bilinear patch lies midway between the two ways of cutting a quad.
        const NetMesh cut(net, with_faces(NetFaces::triangles_fixed));
        const NetMesh cut_over(net.flipped(gusset::Direction::right), with_faces(NetFaces::triangles_fixed));
        const Surface falling = surface_of(cut.mesh());
        const Surface rising = surface_of(cut_over.mesh());
        CHECK(PMP::is_outward_oriented(falling));
        CHECK(PMP::is_outward_oriented(rising));
        CHECK((PMP::volume(falling) + PMP::volume(rising)) / 2 == doctest::Approx(volume).epsilon(1e-12));
    }
}

TEST_CASE("what solids measure") {
    const gusset_net_measure_report box =
        Net::from_primitive(Primitive::box({1.0, 2.0, 3.0}, {2, 2, 2})).measure(gusset::NetMeasures::body);
    CHECK(box.body_volume == doctest::Approx(6.0).epsilon(1e-13));
    CHECK(box.inertia[0] == doctest::Approx(6.0 * (4.0 + 9.0) / 12).epsilon(1e-12));
    CHECK(box.inertia[4] == doctest::Approx(6.0 * (1.0 + 9.0) / 12).epsilon(1e-12));
    CHECK(box.inertia[8] == doctest::Approx(6.0 * (1.0 + 4.0) / 12).epsilon(1e-12));
    CHECK(std::abs(box.inertia[1]) < 1e-13);
    CHECK(length({box.centroid[0], box.centroid[1], box.centroid[2]}) < 1e-14);
    const gusset_net_measure_report measures = Net::from_primitive(Primitive::box({1.0, 2.0, 3.0}, {2, 2, 2})).measure();
    CHECK(measures.area == doctest::Approx(22.0).epsilon(1e-13));
    CHECK(measures.low[2] == -1.5);
    CHECK(measures.high[1] == 1.0);
    const Net fine = Net::from_primitive(Primitive::sphere(1.0).with(257, 513));
    CHECK(fine.measure().volume == doctest::Approx(4 * pi / 3).epsilon(2e-4));
    CHECK(fine.measure().area == doctest::Approx(4 * pi).epsilon(2e-4));
}

TEST_CASE("surfaces with one side") {
    struct Case {
        const char *name;
        Primitive shape;
        long euler;
        bool closed;
    };
    for (const auto &[name, shape, euler, closed] :
         {Case{"moebius", Primitive::moebius(2.0, 1.0).with(5, 33), 0, false},
          Case{"klein", Primitive::klein(2.0, 0.5).with(17, 33), 0, true},
          Case{"projective plane", Primitive::projective_plane(1.0).with(17, 17), 1, true}}) {
        CAPTURE(name);
        const Net net = Net::from_primitive(shape);
        const NetComplex complex(net);
        CHECK(complex.euler() == euler);
        CHECK(complex.is_closed() == closed);
        CHECK(complex.is_manifold());
        CHECK(!complex.is_orientable());
        CHECK(complex.genus() == 2 - euler - (closed ? 0 : 1));
        CHECK(complex.boundary_count() == (closed ? 0 : 1));
        if (!closed) {
            // Twice round, once for each side of the strip.
            CHECK(complex.boundary(0).size() == 2 * (net.columns() - 1));
            CHECK_THROWS_AS(complex.boundary(1), gusset::Error);
        }
        const NetMesh mesh(net);
        CHECK(euler_of(mesh.mesh()) == euler);
        CHECK(gusset::Check(mesh.mesh()).is_closed() == closed);
        CHECK(!gusset::Check(mesh.mesh()).is_orientable());
        auto [points, faces] = CgalSoup<Kernel::Point_3>(mesh.mesh());
        CHECK(!PMP::is_polygon_soup_a_polygon_mesh(faces));
        CHECK(!PMP::orient_polygon_soup(points, faces)); // It had to cut.
    }
}

TEST_CASE("the normals of a sphere are its radii") {
    const Primitive shape = Primitive::sphere(2.0).with(33, 65);
    const Net net = Net::from_primitive(shape.with(gusset::Scalar::f32));
    const Net exact = Net::from_primitive(shape);
    const auto normals = net.normals<float>();
    CHECK(normals.missing_count == 0);
    double worst = 0.0;
    for (std::size_t i = 0; i < net.rows(); ++i) {
        for (std::size_t j = 0; j < net.columns(); ++j) {
            const std::size_t k = i * net.columns() + j;
            worst = std::max(worst, angle({normals.x[k], normals.y[k], normals.z[k]}, exact.at(i, j)));
        }
    }
    CHECK(worst <= 1e-4);
    CHECK_THROWS_AS(net.normals<double>(), gusset::Error);
}

TEST_CASE("the normals of a torus, beside CGAL's") {
    const Net net = Net::from_primitive(Primitive::torus(2.0, 0.7).with(49, 97));
    const auto normals = net.normals<double>();
    const NetMesh mesh(net);
    const auto soup = mesh.mesh();
    Surface surface = surface_of(soup);
    double worst = 0.0, analytic = 0.0;
    for (auto v : surface.vertices()) {
        const auto theirs = PMP::compute_vertex_normal(v, surface);
        const std::size_t node = mesh.node_of_vertex()[v.idx()];
        const Point3 ours{normals.x[node], normals.y[node], normals.z[node]};
        worst = std::max(worst, angle(ours, {theirs.x(), theirs.y(), theirs.z()}));
        const Point3 p = soup.position(v.idx());
        const double r = std::hypot(p[0], p[1]);
        analytic = std::max(analytic, angle(ours, {p[0] - 2.0 * p[0] / r, p[1] - 2.0 * p[1] / r, p[2]}));
    }
    CHECK(worst < 1.0);
    CHECK(analytic < 0.5);
    // Glued nodes have the same bits.
    const auto classes = net.classes();
    for (std::size_t k = 0; k < classes.size(); ++k) {
        const std::size_t first = classes[k];
        REQUIRE((normals.x[k] == normals.x[first] && normals.y[k] == normals.y[first] && normals.z[k] == normals.z[first]));
    }
}

TEST_CASE("texture coordinates do not run back at seams") {
    for (const auto &[name, shape, euler] : closed_shapes()) {
        CAPTURE(name);
        const Net net = Net::from_primitive(shape);
        for (NetFaces faces : {NetFaces::quads, NetFaces::triangles_shorter}) {
            NetMeshOptions options = with_faces(faces);
            options.texture = true;
            const NetMesh made(net, options);
            const auto mesh = made.mesh();
            const auto corners = made.texture_corners();
            const auto coordinates = made.texture_coordinates();
            const double u_cells = static_cast<double>(net.columns() - 1), v_cells = static_cast<double>(net.rows() - 1);
            std::size_t corner = 0;
            bool within = true, right = true;
            for (std::size_t f = 0; f < mesh.face_count(); ++f) {
                const std::size_t cell = made.cell_of_face()[f];
                const double j = static_cast<double>(cell % (net.columns() - 1));
                const double i = static_cast<double>(cell / (net.columns() - 1));
                for (uint32_t vertex : mesh.face(f)) {
                    const auto [u, v] = coordinates[corners[corner++]];
                    within = within && u * u_cells >= j - 1e-9 && u * u_cells <= j + 1 + 1e-9 && v * v_cells >= i - 1e-9 &&
                             v * v_cells <= i + 1 + 1e-9;
                    const auto row = static_cast<std::size_t>(std::lround(v * v_cells));
                    const auto column = static_cast<std::size_t>(std::lround(u * u_cells));
                    right = right && made.vertex_of_node()[row * net.columns() + column] == vertex;
                }
            }
            CHECK(within);
            CHECK(right);
            CHECK(corner == corners.size());
            CHECK(coordinates.size() > mesh.vertex_count());
        }
    }
}

TEST_CASE("meshes of nets in the rest of the library") {
    Net low = Net::from_primitive(Primitive::tube(1.0, 1.0).with(5, 25));
    Net high = Net::from_primitive(Primitive::tube(0.8, 1.0).with(5, 31));
    high.transform(gusset::Operation::translate({0.1, 0.0, 1.4}));
    const NetMesh a(low), b(high);
    CHECK(gusset::Boundary(a.mesh()).size() == 2);
    const gusset::Boundary rims(a.mesh()), others(b.mesh());
    const auto top = [](const gusset::Boundary &loops, const gusset::MeshView &mesh, bool upper) {
        const gusset::Loop first = loops[0];
        const bool first_is_upper = mesh.position(first.vertices[0])[2] > mesh.position(loops[1].vertices[0])[2];
        return first_is_upper == upper ? first.vertices : loops[1].vertices;
    };
    const gusset::Stitch stitched = gusset::stitch(a.mesh(), top(rims, a.mesh(), true), b.mesh(), top(others, b.mesh(), false));
    const Verdict verdict = judge(stitched.mesh());
    CHECK(verdict.is_mesh);
    CHECK(verdict.components == 1);
    CHECK(verdict.boundary == std::vector<std::size_t>{30, 24});
    CHECK(verdict.euler == 0);
    CHECK(verdict.self_intersections == 0);

    // gusset::Weld makes of the unglued mesh the mesh that the glued net makes itself.
    NetMeshOptions apart;
    apart.no_weld = true;
    const Net torus = Net::from_primitive(Primitive::torus(2.0, 0.5).with(9, 17));
    const NetMesh loose(torus, apart), whole(torus);
    CHECK(loose.mesh().vertex_count() == 9 * 17);
    CHECK(gusset::Boundary(loose.mesh()).size() == 1);
    const gusset::Weld sewn(loose.mesh());
    CHECK(sewn.mesh().vertex_count() == 8 * 16);
    CHECK(judge(sewn.mesh()).euler == judge(whole.mesh()).euler);

    // And back to nets.
    for (const Net &net : {torus, low, Net::from_primitive(Primitive::sphere(1.0).with(7, 9)), sheet(3, 4)}) {
        const NetMesh mesh(net);
        const gusset::NetGrid grid(mesh.mesh());
        const Net found = grid.net();
        CHECK(found.node_count() == net.node_count());
        CHECK(NetComplex(found).euler() == NetComplex(net).euler());
        CHECK(found.measure().area == doctest::Approx(net.measure().area).epsilon(1e-12));
        bool same = true;
        for (std::size_t k = 0; k < found.node_count(); ++k) {
            same = same && found.at(k / found.columns(), k % found.columns()) == mesh.mesh().position(grid.vertex_of_node()[k]);
        }
        CHECK(same);
        CHECK(grid.face_of_cell().size() == (found.rows() - 1) * (found.columns() - 1));
    }
    const Refusal no_grid = refusal([&] {
        const NetMesh triangles(torus, with_faces(NetFaces::triangles_fixed));
        gusset::NetGrid(triangles.mesh());
    });
    CHECK(no_grid.status == GUSSET_ERROR_NO_GRID);
    CHECK(no_grid.element == GUSSET_ELEMENT_FACE);
}

TEST_CASE("missing nodes, and corners filled") {
    std::vector<double> heights(5 * 6, 1.0);
    heights[0] = -9999.0;
    heights[2 * 6 + 3] = std::nan("");
    gusset::HeightOptions options;
    options.spacing = {0.5, -2.0};
    options.origin = {10.0, 20.0, 30.0};
    options.no_data = -9999.0;
    const Net net = Net::from_heights(5, 6, heights.data(), options);
    CHECK(net.at(4, 5) == Point3{12.5, 12.0, 31.0});
    CHECK(std::isnan(net.at(2, 3)[2]));
    const NetMesh mesh(net);
    CHECK(mesh.mesh().face_count() == 20 - 1 - 4);
    CHECK(mesh.vertex_of_node()[0] == NetMesh::none);
    CHECK(surface_of(mesh.mesh()).number_of_faces() == 15);
    NetMeshOptions filled;
    filled.fill_corners = true;
    const NetMesh filled_mesh(net, filled);
    CHECK(filled_mesh.mesh().face_count() == 20);
    // Edges are 0.5 and 2 long, and no longer than 5 of the shorter.
    filled.max_edge_ratio = 5;
    const NetMesh whole_mesh(net, filled);
    CHECK(whole_mesh.mesh().face_count() == filled_mesh.mesh().face_count());
    // From above counter-clockwise, though rows run against y.
    const gusset_net_measure_report measures = net.measure();
    CHECK(measures.area_vector[2] == doctest::Approx(15.0));
    const NetComplex present(net, gusset::NetCells::present), all(net);
    CHECK(present.view().quad_count == 15);
    CHECK(all.view().quad_count == 20);
    Net cleared = sheet(3, 3);
    cleared.clear_no_data(2.0);
    const NetMesh cleared_mesh(cleared);
    CHECK(cleared_mesh.mesh().face_count() == 1);
}

TEST_SUITE("real meshes") {
    TEST_CASE("a volcano") {
        const auto folder = data_folder();
        std::ifstream file(folder.value_or("") + "/grids/volcano_maunga_whau_61x87.csv");
        if (!folder || !file) {
            std::cout << "SKIPPED: no grids\n";
            return;
        }
        std::vector<double> heights;
        for (std::string line; std::getline(file, line);) {
            std::istringstream numbers(line);
            for (std::string number; std::getline(numbers, number, ',');) {
                heights.push_back(std::stod(number));
            }
        }
        REQUIRE(heights.size() == 61 * 87);
        gusset::HeightOptions options;
        options.spacing = {10.0, -10.0};
        const Net net = Net::from_heights(87, 61, heights.data(), options);
        const gusset_net_measure_report measures = net.measure();
        CHECK(measures.low[2] == *std::min_element(heights.begin(), heights.end()));
        CHECK(measures.high[2] == *std::max_element(heights.begin(), heights.end()));
        CHECK(measures.area_vector[2] == doctest::Approx(600.0 * 860.0));
        const NetMesh mesh(net, with_faces(NetFaces::triangles_shorter));
        const Verdict verdict = judge(mesh.mesh());
        CHECK(verdict.is_mesh);
        CHECK(verdict.euler == 1);
        CHECK(verdict.boundary == std::vector<std::size_t>{2 * (60 + 86)});
        CHECK(verdict.self_intersections == 0);
        CHECK(PMP::area(surface_of(mesh.mesh())) == doctest::Approx(measures.area).epsilon(5e-3));
        const NetMesh quads(net);
        const Net found = gusset::NetGrid(quads.mesh()).net();
        CHECK(found.node_count() == net.node_count());
        CHECK(found.measure().area == doctest::Approx(measures.area).epsilon(1e-12));
        const gusset::DecimatedNet small = net.decimated(10.0);
        CHECK(small.net.node_count() < net.node_count());
        CHECK(small.deviation <= 10.0);
        CHECK(small.net.at(1, 1) == net.at(small.rows[1], small.columns[1]));
        const NetMesh small_mesh(small.net);
        CHECK(judge(small_mesh.mesh(), false).euler == 1);
    }
}

} // namespace net_tests
