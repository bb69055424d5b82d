// Outlines from C++.
#include <gusset.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

namespace outline_tests {

namespace {
constexpr double turn = 2 * 3.14159265358979323846;
using Plane = std::array<double, 2>;
using Space = std::array<double, 3>;

Space at(gusset::Points controls, double t) {
    std::vector<Space> points(controls.begin(), controls.end());
    for (std::size_t n = points.size(); n > 1; --n) {
        for (std::size_t i = 0; i + 1 < n; ++i) {
            for (int k = 0; k < 3; ++k) {
                points[i][k] += t * (points[i + 1][k] - points[i][k]);
            }
        }
    }
    return points[0];
}

double distance(const Space &p, const Space &q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

std::vector<Space> coil(int n) {
    std::vector<Space> points;
    for (int i = 0; i < n; ++i) {
        points.push_back({std::cos(turn * i / 10), std::sin(turn * i / 10), 0.1 * i});
    }
    return points;
}
} // namespace

TEST_CASE("curves of all kinds pass their points, in the plane and in space") {
    const std::vector<Space> points = coil(25);
    for (auto curve : {gusset::CurveKind::composite, gusset::CurveKind::blend_c1, gusset::CurveKind::blend_c2,
                       gusset::CurveKind::cubic_c2}) {
        for (auto method : {gusset::SectionMethod::bisector, gusset::SectionMethod::median, gusset::SectionMethod::normal,
                            gusset::SectionMethod::symmedian, gusset::SectionMethod::alpha}) {
            for (bool closed : {false, true}) {
                gusset::OutlineOptions options;
                options.curve = curve;
                options.method = method;
                const gusset::Outline outline(gusset::Outlines(points, closed), options);
                const gusset::OutlineCurve found = outline.curve();
                for (std::size_t i = 0; i < points.size(); ++i) {
                    const Space p = at(found.segment(outline.segments()[i]), outline.parameters()[i]);
                    CHECK(distance(p, points[i]) < 1e-14);
                }
                CHECK(outline.report().max_joint_sine < 1e-14);
            }
        }
    }
}

TEST_CASE("many outlines at once, with corners and tangents") {
    std::vector<Plane> points;
    std::vector<uint32_t> offsets = {0};
    std::vector<gusset::Constraint> constraints;
    for (int k = 0; k < 100; ++k) {
        constraints.push_back(gusset::Constraint::corner(static_cast<uint32_t>(points.size())));
        constraints.push_back(gusset::Constraint::tangent(static_cast<uint32_t>(points.size() + 3), -1.0, 0.2));
        for (int i = 0; i < 5 + k; ++i) {
            const double angle = turn * i / (5 + k);
            points.push_back({(k + 1) * std::cos(angle), std::sin(angle)});
        }
        offsets.push_back(static_cast<uint32_t>(points.size()));
    }
    const gusset::Outline outline(gusset::Outlines(points, true).offsets(offsets).constraints(constraints));
    REQUIRE(outline.size() == 100);
    for (std::size_t k = 0; k < outline.size(); ++k) {
        CHECK(outline.report(k).fit == GUSSET_FIT_OK);
        const gusset::OutlineCurve curve = outline.curve(k);
        const auto first = curve.controls[0];
        CHECK(first == curve.controls[curve.controls.size() - 1]);
        CHECK(first == Space{points[offsets[k]][0], points[offsets[k]][1], 0.0});
    }
    CHECK_THROWS_AS(outline.curve(100), gusset::Error);
    CHECK_THROWS_AS(outline.report(100), gusset::Error);
}

TEST_CASE("how the cycles of the paper's chain go") {
    std::vector<Plane> ellipse;
    for (int i = 0; i < 12; ++i) {
        ellipse.push_back({3 * std::cos(turn * i / 12), std::sin(turn * i / 12)});
    }
    gusset::OutlineOptions options;
    options.curve = gusset::CurveKind::chain;
    options.solver = gusset::OutlineSolver::step;
    const auto report_of = [&](uint32_t sweeps) {
        options.max_sweeps = sweeps;
        return gusset::Outline(gusset::Outlines(ellipse, true), options).report();
    };
    // Cycles need not get smaller one by one.
    const gusset_outline_report first = report_of(1), later = report_of(20);
    CHECK(first.iterations == 1);
    CHECK(later.iterations > 3);
    CHECK(later.last_move < 0.1 * first.last_move);
    CHECK(later.steps > first.steps);
    // The control points after each cycle: one for each point.
    options.history = true;
    const gusset::Outline outline(gusset::Outlines(ellipse, true), options);
    const gusset_outline_history history = outline.history();
    REQUIRE(history.cycle_count == outline.report().iterations);
    REQUIRE(history.control_count == history.cycle_count * ellipse.size());
    CHECK(history.cycles[0].moved == first.last_move);
    for (std::size_t k = 0; k < history.cycle_count; ++k) {
        CHECK(history.cycles[k].control_end == (k + 1) * ellipse.size());
    }
    const double *last = history.controls + 3 * (history.control_count - ellipse.size());
    CHECK(std::hypot(last[0] - outline.curve().controls[1][0], last[1] - outline.curve().controls[1][1]) < 1e-9);
    CHECK_THROWS_AS(outline.history(1), gusset::Error);
}

TEST_CASE("what is wrong is said") {
    std::vector<Plane> points = {{0, 0}, {1, 0}, {1, std::nan("")}};
    try {
        gusset::Outline outline(gusset::Outlines(points, true));
        FAIL("no number is no coordinate");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_NOT_FINITE);
        CHECK(error.report().element == GUSSET_ELEMENT_POINT);
        CHECK(error.report().index == 2);
    }
}

TEST_CASE("the bisector's section halves the angle") {
    const std::vector<Plane> points = {{0, 0}, {3, 4}, {10, 0}};
    const gusset::Sections sections(gusset::Outlines(points, false));
    const Space b = sections.controls()[1];
    const auto angle = [&](const Plane &corner) {
        const double ux = 3 - b[0], uy = 4 - b[1], vx = corner[0] - 3, vy = corner[1] - 4;
        return std::acos((ux * vx + uy * vy) / std::hypot(ux, uy) / std::hypot(vx, vy)) * 360 / turn;
    };
    CHECK(angle(points[0]) == doctest::Approx(48.56).epsilon(1e-4));
    CHECK(angle(points[2]) == doctest::Approx(48.56).epsilon(1e-4));
}

TEST_CASE("points that sections of a frame lack") {
    std::vector<Space> points;
    for (int k = 0; k < 24; ++k) {
        points.push_back({std::cos(turn * (k % 6) / 6), std::sin(turn * (k % 6) / 6), double(k / 6)});
    }
    const Space lost = points[8];
    points[8] = {NAN, NAN, NAN};
    const std::vector<uint32_t> offsets{0, 6, 12, 18, 24}, missing{8};
    gusset::FrameOptions options;
    options.missing = missing;
    const gusset::Frame frame(gusset::Outlines(points, true).offsets(offsets), options);
    REQUIRE(frame.view().filled.count == 1);
    CHECK(frame.view().filled.data[0] == 8);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::abs(frame.nodes()[8][i] - lost[i]) < 1e-14);
    }
}

TEST_CASE("the frame of a ball: nodes, curves, new sections and their measures") {
    std::vector<Space> points;
    std::vector<uint32_t> offsets = {0};
    for (int k = 0; k < 9; ++k) {
        const double z = -1.6 + 0.4 * k, r = std::sqrt(4 - z * z);
        for (int i = 0; i < 20 + k; ++i) {
            const double angle = turn * i / (20 + k);
            points.push_back({r * std::cos(angle), r * std::sin(angle), z});
        }
        offsets.push_back(static_cast<uint32_t>(points.size()));
    }
    gusset::FrameOptions options;
    options.correspondence = gusset::CorrespondenceRule::angle;
    options.columns = 16;
    options.axis_direction = {0, 0, 1};
    options.reference = {1, 0, 0};
    options.across.curve = options.along.curve = gusset::CurveKind::cubic_c2;
    const gusset::Frame frame(gusset::Outlines(points, true).offsets(offsets), options);
    const gusset_frame_view parts = frame.view();
    REQUIRE(parts.rows == 9);
    REQUIRE(parts.columns == 16);
    CHECK(parts.max_gap < 1e-15);
    CHECK(parts.min_sine > 0.99);
    CHECK(frame.across(8).size() == 16);
    CHECK(frame.along(15).size() == 8);
    for (const Space &p : frame.nodes()) {
        CHECK(std::hypot(p[0], p[1], p[2]) == doctest::Approx(2).epsilon(1e-3));
    }
    const gusset_curve_measures measure = frame.slice({0, 0, 0.13}, {0, 0, 7}).measure();
    const double r = std::sqrt(4 - 0.13 * 0.13);
    CHECK(measure.length == doctest::Approx(turn * r).epsilon(1e-3));
    CHECK(measure.area == doctest::Approx(turn / 2 * r * r).epsilon(1e-3));
    CHECK(measure.centre[2] == doctest::Approx(0.13).epsilon(1e-6));
    try {
        frame.slice({0, 0, 5}, {0, 0, 1});
        FAIL("the plane is beyond the ball");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_NO_NODE);
    }
    CHECK_THROWS_AS(gusset::Frame(gusset::Outlines(points, true).offsets(offsets)), gusset::Error);
    CHECK_THROWS_AS(frame.across(9), gusset::Error);
}

} // namespace outline_tests
