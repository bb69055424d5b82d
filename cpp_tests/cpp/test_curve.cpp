// Curve operations from C++, against formulas.
#include <gusset.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

namespace curve_tests {

namespace {
using Point2 = std::array<double, 2>;
constexpr double pi = 3.14159265358979323846;

/// A circle of four cubics, within 2.8e-4 of it.
gusset::Curve circle(double radius, double x) {
    const double k = 4.0 / 3.0 * std::tan(pi / 8) * radius;
    const std::vector<Point2> points{{x + radius, 0}, {x + radius, k},  {x + k, radius},  {x, radius},   {x - k, radius},
                                     {x - radius, k}, {x - radius, 0},  {x - radius, -k}, {x - k, -radius}, {x, -radius},
                                     {x + k, -radius}, {x + radius, -k}, {x + radius, 0}};
    const std::array<uint32_t, 5> ends{0, 3, 6, 9, 12};
    return gusset::Curve::from_controls(points, ends, true);
}

/// y = x^2 from 0 to 1.
gusset::Curve parabola() {
    const std::array<Point2, 3> points{{{0, 0}, {0.5, 0}, {1, 1}}};
    const std::array<uint32_t, 2> ends{0, 2};
    return gusset::Curve::from_controls(points, ends, false);
}
} // namespace

TEST_CASE("questions") {
    const gusset::Curve curve = parabola();
    CHECK(curve.segment_count() == 1);
    CHECK(curve.controls().size() == 3);
    CHECK(curve.point(gusset::place(0, 0.5)) == gusset::Point3{0.5, 0.25, 0});
    CHECK(std::abs(curve.length() - (0.5 * std::sqrt(5.0) + 0.25 * std::asinh(2.0))) < 1e-15);
    CHECK(std::abs(curve.measure().area_vector[2] - 1.0 / 6.0) < 1e-15);
    CHECK(curve.measure(GUSSET_CURVE_MEASURE_MOMENTS).defined == GUSSET_CURVE_MEASURE_MOMENTS);
    const std::array<gusset::Place, 2> places{gusset::place(0, 0.0), gusset::place(0, 1.0)};
    CHECK(std::abs(curve.curvatures(places)[0] - 2.0) < 1e-14);
    CHECK(std::abs(curve.tangents(places)[1][1] - 2 / std::sqrt(5.0)) < 1e-15);
    CHECK(curve.derivatives(places, 2).size() == 6);
    const std::array<double, 1> half{0.5 * curve.length()};
    CHECK(std::abs(curve.lengths_at(curve.places_at(half))[0] - half[0]) < 1e-15);
    // From (0, 1) the nearest point has x^2 = 1/2.
    const std::array<gusset::Point3, 1> query{{{0, 1, 0}}};
    const gusset_curve_nearest_point nearest = curve.nearest(query)[0];
    CHECK(std::abs(nearest.place.t - std::sqrt(0.5)) < 1e-14);
    CHECK(std::abs(nearest.distance - std::sqrt(0.75)) < 1e-15);
    const gusset_curve_measures measures = circle(2, 0).measure();
    CHECK((measures.high[0] == 2 && measures.high[1] == 2 && measures.high[2] == 0));
    CHECK(std::abs(measures.area_vector[2] / (4 * pi) - 1) < 5e-4);
    CHECK(measures.area == measures.area_vector[2]);
    CHECK_THROWS_AS(curve.point(gusset::place(1, 0)), gusset::Error);
    try {
        curve.points_at({&places[0], 1});
        const gusset::Place wrong = gusset::place(0, 2.0);
        curve.points_at({&wrong, 1});
        FAIL("accepted");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_NO_SUCH_ELEMENT);
        CHECK(error.report().element == GUSSET_ELEMENT_PLACE);
        CHECK(error.report().value == 2.0);
    }
}

TEST_CASE("places found") {
    const gusset::Curve one = circle(1, 0), two = circle(1, 1);
    const gusset::Places meetings = one.intersect(two);
    REQUIRE(meetings.size() == 2);
    CHECK(std::abs(meetings.points()[0][0] - 0.5) < 1e-14);
    CHECK(meetings.others().size() == 2);
    CHECK(meetings.overlaps().empty());
    CHECK_FALSE(meetings.undecided());
    CHECK(one.self_intersections().size() == 0);
    CHECK(one.intersect(two, 0.01).size() == 2);
    const gusset::Places on_line = one.intersect_line(gusset::Line::line({0, 0.6, 0}, {1, 0, 0}));
    REQUIRE(on_line.size() == 2);
    CHECK(std::abs(on_line.points()[0][1] - 0.6) < 1e-12);
    CHECK(on_line.others()[0].t == doctest::Approx(on_line.points()[0][0]));
    CHECK(one.intersect_plane({0, 0.6, 0}, {0, 1, 0}).size() == 2);
    CHECK(one.intersect_plane({0, 0, 0}, {1, 0, 0}).size() == 2);
    const gusset::Places in_plane = one.intersect_plane({0, 0, 0}, {0, 0, 1});
    CHECK(in_plane.inside().size() == 4);
    CHECK(one.sample(gusset::SampleRule::count, 7).size() == 7);
    CHECK(one.sample(gusset::SampleRule::step, 1).size() == 7);
    const gusset::Places by_chord = one.sample(gusset::SampleRule::chord, 0.1);
    CHECK(by_chord.points().size() == 8);
}

TEST_CASE("curves made of curves") {
    const gusset::Curve curve = circle(1, 0);
    const gusset::Place middle = gusset::place(2, 0.5);
    const gusset::Curve before = curve.part(gusset::place(0, 0), middle), after = curve.part(middle, gusset::place(3, 1));
    CHECK(before.segment_count() == 3);
    CHECK(after.segment_count() == 2);
    CHECK(std::abs(before.length() + after.length() - curve.length()) < 1e-12);
    CHECK(curve.part(gusset::place(3, 0.5), gusset::place(0, 0.5)).segment_count() == 2);
    CHECK(curve.reversed().measure().area_vector[2] == doctest::Approx(-curve.measure().area_vector[2]));
    const gusset::Curve to_five = curve.with_degrees(5, 5).curve, as_it_is = curve.with_degrees(1, 64).curve;
    CHECK(to_five.controls().size() == 21);
    CHECK(as_it_is.controls().size() == 13);
    const gusset::CurveOfDegrees to_four = curve.with_degrees(4, 64);
    CHECK(to_four.curve.ends()[1] == 4);
    const gusset::CurveOfDegrees lowered = to_five.with_degrees(1, 3, 1e-9);
    CHECK(lowered.curve.controls().size() == 13);
    CHECK(lowered.deviations[0] < 1e-14);
    // Circles are not parabolas: the segments stay.
    const gusset::CurveOfDegrees kept = curve.with_degrees(1, 2, 1e-9);
    CHECK(kept.curve.controls().size() == 13);
    CHECK(kept.deviations[3] > 1e-3);
    gusset::OffsetOptions quadratic;
    quadratic.tolerance = 1e-7;
    quadratic.degree = 2;
    const gusset::OffsetCurve offset = curve.offset(-0.5, quadratic);
    CHECK(offset.report.deviation <= 1e-7);
    CHECK(offset.report.reached == 1);
    CHECK(offset.curve.is_closed());
    CHECK(std::abs(offset.curve.length() / (3 * pi) - 1) < 1e-3);
    gusset::OffsetOptions cubic;
    cubic.tolerance = 1e-3;
    cubic.degree = 3;
    cubic.max_segments = 100;
    CHECK(curve.offset(1.5, cubic).report.tight == 1);
}

TEST_CASE("other forms") {
    const gusset::CurveForm svg = parabola().exported(gusset::CurveFormat::svg);
    CHECK(svg.text() == "M 0 0 Q 0.5 0 1 1");
    const std::array<Point2, 9> points{{{0.5, 0}, {1, 0}, {1, 0.5}, {1, 1}, {0.5, 1}, {0, 1}, {0, 0.5}, {0, 0}, {0.5, 0}}};
    const std::array<uint32_t, 5> ends{0, 2, 4, 6, 8};
    const gusset::Curve round = gusset::Curve::from_controls(points, ends, true);
    const gusset::CurveForm contour = round.exported(gusset::CurveFormat::contour);
    CHECK(contour.points().size() == 4);
    CHECK(contour.on_curve()[0] == 0);
    const gusset::CurveForm spline = round.exported(gusset::CurveFormat::spline);
    CHECK(spline.degree() == 2);
    CHECK(spline.knots().size() == spline.points().size() + 3);
    CHECK(circle(1, 0).exported(gusset::CurveFormat::spline).degree() == 3);
    // A form lends nothing for the arrays that it does not have.
    CHECK(spline.on_curve().data() == nullptr);
    CHECK(spline.text().data() == nullptr);
    CHECK(contour.knots().data() == nullptr);
}

} // namespace curve_tests
