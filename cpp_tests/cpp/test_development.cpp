// Developments through the wrapper: a part of a ball, cut and not, and nets and sheets by their meshes.
#include <gusset.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

namespace development_tests {

namespace {
using gusset::Point3;

/// A grid of points as triangles.
struct Grid {
    std::vector<Point3> points;
    std::vector<uint32_t> corners;

    template <class At>
    Grid(uint32_t rows, uint32_t columns, At &&at) {
        for (uint32_t i = 0; i < rows; ++i) {
            for (uint32_t j = 0; j < columns; ++j) {
                points.push_back(at(double(i) / (rows - 1), double(j) / (columns - 1)));
            }
        }
        for (uint32_t i = 0; i + 1 < rows; ++i) {
            for (uint32_t j = 0; j + 1 < columns; ++j) {
                const uint32_t v = i * columns + j;
                corners.insert(corners.end(), {v, v + 1, v + columns + 1, v, v + columns + 1, v + columns});
            }
        }
    }
    gusset::MeshView view() const { return gusset::MeshView::triangles(points, corners); }
};

} // namespace

TEST_CASE("a part of a ball") {
    const Grid ball(25, 33, [](double s, double t) {
        const double a = 0.25 + 1.2 * s, b = 2.2 * t;
        return Point3{std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
    });
    const gusset::Development plain(ball.view());
    CHECK(plain.charts().size() == 1);
    CHECK(plain.charts()[0].finish == GUSSET_CHART_CONVERGED);
    CHECK(plain.charts()[0].overlaps == 0);
    CHECK(plain.charts()[0].folds == 0);
    CHECK(plain.cut_edges().empty());
    CHECK(plain.points().size() == ball.points.size());
    CHECK(plain.stretches().size() == ball.corners.size() / 3);
    gusset::DevelopOptions options;
    options.max_darts = 2;
    const gusset::Development darts(ball.view(), options);
    CHECK(darts.darts() == 2);
    CHECK(darts.charts()[0].energy < plain.charts()[0].energy);
    options.max_darts = 0;
    // Right through the middle: two charts.
    options.cuts = {16, 24 * 33 + 16};
    const gusset::Development halves(ball.view(), options);
    CHECK(halves.charts().size() == 2);
    CHECK(halves.charts()[0].energy < plain.charts()[0].energy);
    options.cuts.clear();
    options.distortion = gusset::Distortion::conformal;
    const gusset::Development conformal(ball.view(), options);
    CHECK(conformal.charts()[0].finish == GUSSET_CHART_CONFORMAL);
    // The flat mesh is a mesh: its border is one loop.
    CHECK(gusset::Boundary(conformal.mesh()).size() == 1);
    // A limit must exceed 1.
    options.max_stretch = 1.0;
    CHECK_THROWS_AS(gusset::Development(ball.view(), options), gusset::Error);
}

// A cone as a net and as a sheet: each is developed by its mesh.
TEST_CASE("nets and sheets") {
    std::vector<Point3> nodes;
    for (int i = 0; i <= 8; ++i) {
        for (int j = 0; j <= 24; ++j) {
            const double radius = 1.0 + 0.1 * i, angle = 0.2 * j;
            nodes.push_back({radius * std::cos(angle), radius * std::sin(angle), 2.0 * radius});
        }
    }
    const gusset::Net net = gusset::Net::from_points(9, 25, nodes);
    const gusset::NetMesh mesh(net);
    const gusset::Development by_net(mesh.mesh());
    CHECK(by_net.charts().size() == 1);
    CHECK(by_net.charts()[0].finish == GUSSET_CHART_EXACT);
    CHECK(by_net.charts()[0].flat_area == doctest::Approx(by_net.charts()[0].area).epsilon(1e-12));
    // The sheet is round between its nodes, and its mesh a little curved.
    gusset::SheetMeshOptions fine;
    fine.tolerance = 1e-4;
    const gusset::SheetMesh sheet(gusset::Sheet::from_nodes(9, 25, nodes), fine);
    const gusset::Development by_sheet(sheet.mesh());
    CHECK(by_sheet.charts().size() == 1);
    CHECK(by_sheet.charts()[0].energy == doctest::Approx(4.0).epsilon(1e-6));
    const double slant = std::sqrt(5.0), area = 0.5 * slant * (1.8 * 1.8 - 1.0) * 4.8;
    CHECK(by_sheet.charts()[0].flat_area == doctest::Approx(area).epsilon(1e-3));
}

} // namespace development_tests
