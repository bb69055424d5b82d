// Curves, outlines and frames.
#include "row.hpp"
#include "shapes.hpp"

namespace complexity {

namespace {
using gusset::Context;
using gusset::Curve;
using Points = std::vector<Point3>;

/// A curve of n segments of degree 3 through what a family gives.
template <class Family, class Function>
std::function<Call(std::size_t)> on_curve(Family family, Function function) {
    return [=](std::size_t n) {
        const auto curve = std::make_shared<const Curve>(curve_of(family(3 * n + 1), 3));
        return making([=](const Context &context) { return function(*curve, context); });
    };
}

template <class Family, class Function>
std::function<Call(std::size_t)> outlined(Family family, Function function) {
    return [=](std::size_t n) {
        const auto points = std::make_shared<const Points>(family(n));
        return making([=](const Context &context) { return function(gusset::Outlines(*points, true), context); });
    };
}
} // namespace

std::vector<Row> curve_rows() {
    const auto round = [](std::size_t n) { return circle(n, 1.0, 0.0); };
    const auto line = [](std::size_t n) { return collinear(n); };
    const auto whirl = [](std::size_t n) { return spiral(n, 0.0); };
    const auto star = [](std::size_t n) { return nested_star(n, 0.0); };
    const auto one = [](std::size_t n) { return point(n, {1, 2, 0}); };
    const auto random = [](std::size_t n) {
        Points made;
        std::mt19937 generator(7);
        const auto chance = [&generator] { return static_cast<double>(generator() % 65536) / 65536; };
        for (std::size_t i = 0; i < n; ++i) {
            const double x = chance();
            made.push_back({x, chance(), 0});
        }
        return made;
    };
    const auto copy = [](const Curve &curve, const Context &context) { return curve.intersect(curve, 0.0, context); };
    const auto itself = [](const Curve &curve, const Context &context) { return curve.self_intersections(context); };
    const auto near = [](const Curve &curve, const Context &context) { return curve.intersect(curve, 0.01, context); };
    const auto offset = [](const Curve &curve, const Context &context) {
        gusset::OffsetOptions options;
        options.tolerance = 1e-4;
        return curve.offset(0.01, options, context);
    };
    const auto measure = [](const Curve &curve, const Context &context) { return curve.measure(0, context); };
    const auto plane = [](const Curve &curve, const Context &context) {
        return curve.intersect_plane({0, 0, 0}, {0.3, 1, 0}, context);
    };
    const auto outline = [](const gusset::Outlines &points, const Context &context) {
        return gusset::Outline(points, gusset::OutlineOptions(), context);
    };
    const auto nearest = [](const Curve &curve, const Context &context) {
        const Points queries(32, Point3{0, 0, 0});
        return curve.nearest(queries, context);
    };
    const auto frame = [=](auto how) {
        return [=](std::size_t n) {
            const auto points = std::make_shared<Points>(circle(n, 1.0, 0.0));
            for (const Point3 &p : circle(n, 1.2, 1.0)) {
                points->push_back(p);
            }
            return making([=](const Context &context) {
                const uint32_t offsets[] = {0, static_cast<uint32_t>(n), static_cast<uint32_t>(2 * n)};
                gusset::Outlines sections(*points, true);
                sections.offsets(offsets);
                return gusset::Frame(sections, how(static_cast<uint32_t>(n)), context);
            });
        };
    };
    const auto by_length = [](uint32_t n) {
        gusset::FrameOptions options;
        options.correspondence = gusset::CorrespondenceRule::arc_length;
        options.columns = n;
        return options;
    };
    const auto by_angle = [](uint32_t) {
        gusset::FrameOptions options;
        options.correspondence = gusset::CorrespondenceRule::angle;
        options.columns = 16;
        options.axis_direction = {0, 0, 1};
        options.reference = {1, 0, 0};
        return options;
    };
    return {
        {"curve_intersect_create", "equal copy of a circle", 16, 2000, 1, 1, 0, on_curve(round, copy)},
        {"curve_intersect_create", "equal copy of a line", 16, 2000, 1, 1, 0, on_curve(line, copy), true},
        {"curve_intersect_create", "equal copy of a star", 4, 2000, 2, 1, 0, on_curve(star, copy)},
        {"curve_intersect_create", "equal copy in a point", 32, 2000, 1, 1, 0, on_curve(one, copy)},
        {"curve_intersect_create", "itself, at random", 8, 2000, 2, 2, 0, on_curve(random, itself), true},
        {"curve_intersect_create", "itself, spiral", 64, 2000, 1, 1, 0, on_curve(whirl, itself)},
        {"curve_intersect_create", "near, equal points", 2, 64, 0, 0, 0, on_curve(one, near), true},
        {"curve_intersect_create", "near, equal copy of a circle", 2, 64, 1, 1, 0, on_curve(round, near), true},
        {"curve_intersect_create", "near, equal copy of a line", 2, 64, 1, 1, 0, on_curve(line, near), true},
        {"curve_intersect_plane_create", "star", 128, 1000000, 1, 1, 0, on_curve(star, plane)},
        {"curve_offset_create", "circle", 64, 3000, 1, 1, 0, on_curve(round, offset)},
        {"curve_offset_create", "star", 4, 3000, 2, 2, 0, on_curve(star, offset)},
        {"curve_offset_create", "points in one", 64, 3000, 1, 1, 0, on_curve(one, offset)},
        {"curve_measure", "star", 128, 1000000, 1, 1, 0, on_curve(star, measure)},
        {"curve_nearest", "focal point", 16, 100000, 1, 1, 0, on_curve(round, nearest)},
        {"curve_nearest", "star", 64, 100000, 1, 1, 0, on_curve(star, nearest)},
        {"outline_create", "circle", 256, 1000000, 1, 1, 0, outlined(round, outline)},
        {"outline_create", "star", 256, 1000000, 1, 1, 0, outlined(star, outline)},
        {"outline_create", "collinear", 256, 1000000, 1, 1, 0, outlined(line, outline)},
        {"frame_create", "arc length", 128, 100000, 1, 1, 0, frame(by_length)},
        {"frame_create", "angle", 128, 100000, 1, 1, 0, frame(by_angle)},
    };
}

} // namespace complexity
