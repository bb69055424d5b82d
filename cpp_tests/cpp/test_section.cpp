// Sections of meshes through the wrapper: planes of each kind, ranges, sources, attributes, and mistakes.
#include <gusset.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace section_tests {

namespace {
using gusset::CuttingPlanes;
using gusset::MeshSections;
using gusset::Point3;

/// A box around the origin, of quads that face outwards.
struct Box {
    std::vector<Point3> points;
    std::vector<uint32_t> corners{0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};

    explicit Box(const Point3 &half) {
        for (int k = 0; k < 8; ++k) {
            points.push_back({(k & 1 ? 1 : -1) * half[0], (k & 2 ? 1 : -1) * half[1], (k & 4 ? 1 : -1) * half[2]});
        }
    }
    gusset::MeshView view() const { return gusset::MeshView::uniform(points, corners, 4); }
};

double total_area(const MeshSections &sections) {
    double area = 0;
    for (const gusset::SectionPath &path : sections) {
        area += path.path.area;
    }
    return area;
}
} // namespace

TEST_CASE("planes of each kind cut a box") {
    const Box box({1, 2, 3});
    const std::vector<double> heights{-1, 0.5, 2, 9}, angles{0, 1.5707963267948966};
    const MeshSections stack(box.view(), CuttingPlanes::stack({0, 0, 0}, {0, 0, 1}, heights));
    CHECK(stack.plane_count() == 4);
    CHECK(stack.size() == 3);
    CHECK(total_area(stack) == doctest::Approx(3 * 8));
    const MeshSections one(box.view(), CuttingPlanes::plane({0.5, 0, 0}, {2, 0, 0}));
    CHECK(one.size() == 1);
    CHECK(one[0].path.area == doctest::Approx(24));
    CHECK(one[0].path.length == doctest::Approx(20));
    const MeshSections about(box.view(), CuttingPlanes::about_axis({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, angles));
    CHECK(total_area(about) == doctest::Approx(12 + 24));
    const std::vector<Point3> line{{-5, 0, 0}, {5, 0, 0}};
    const std::vector<double> places{5, 5.5};
    CHECK(total_area(MeshSections(box.view(), CuttingPlanes::across(line, places))) == doctest::Approx(48));
    const std::vector<Point3> points{{0, 0, 0}, {0, 0, 0}}, normals{{1, 0, 0}, {0, -1, 0}};
    CHECK(total_area(MeshSections(box.view(), CuttingPlanes::each(points, normals))) == doctest::Approx(24 + 12));
}

TEST_CASE("faces in a plane belong to one of its sides") {
    const Box box({1, 1, 1});
    gusset::MeshSectionOptions options;
    const auto count = [&](double height) { return MeshSections(box.view(), CuttingPlanes::plane({0, 0, height}, {0, 0, 1}), options).size(); };
    CHECK(count(1) == 1);
    CHECK(count(-1) == 0);
    options.in_plane = gusset::InPlane::below;
    CHECK(count(1) == 0);
    CHECK(count(-1) == 1);
}

TEST_CASE("points have sources, by which values are carried") {
    const Box box({1, 2, 3});
    const MeshSections sections(box.view(), CuttingPlanes::plane({0, 0, 1.5}, {0, 0, 1}));
    const gusset::SectionPath path = sections[0];
    REQUIRE(path.size() == 4);
    CHECK(path.is_closed());
    CHECK(path.edges.size() == 8);
    CHECK(path.faces.size() == 4);
    std::vector<std::array<double, 1>> heights;
    for (const Point3 &p : box.points) {
        heights.push_back({p[2]});
    }
    const auto carried = sections.origins().apply<std::array<double, 1>>(gusset::Domain::vertices, gusset::Rule::linear, {heights});
    REQUIRE(carried.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) {
        const Point3 &p = box.points[path.edges[2 * k]], &q = box.points[path.edges[2 * k + 1]];
        CHECK(p[2] + path.parameters[k] * (q[2] - p[2]) == doctest::Approx(1.5));
        CHECK(carried[k][0] == doctest::Approx(1.5));
    }
}

TEST_CASE("mistakes throw, and what is lent must not outlive its planes") {
    const Box box({1, 1, 1});
    const std::vector<double> falling{1, 0};
    CHECK_THROWS_AS(MeshSections(box.view(), CuttingPlanes::stack({0, 0, 0}, {0, 0, 1}, falling)), gusset::Error);
    CHECK_THROWS_AS(MeshSections(box.view(), CuttingPlanes::plane({0, 0, 0}, {0, 0, 0})), gusset::Error);
    const std::vector<Point3> two(2), one(1);
    CHECK_THROWS_AS(CuttingPlanes::each(two, one), std::invalid_argument);
    const MeshSections none(box.view(), CuttingPlanes::plane({0, 0, 5}, {0, 0, 1}));
    CHECK(none.empty());
    CHECK_THROWS_AS(none[0], gusset::Error);
    CHECK(std::distance(none.begin(), none.end()) == 0);
}

} // namespace section_tests
