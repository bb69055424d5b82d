// Smooth surfaces.
#include "row.hpp"
#include "shapes.hpp"

namespace complexity {

namespace {
using gusset::Context;
using gusset::Sheet;
using gusset::Surface;

template <class Family, class Function>
std::function<Call(std::size_t)> on_surface(Family family, Function function) {
    return [=](std::size_t n) {
        const auto surface = std::make_shared<const Surface>(sheet_of(family(n)));
        return making([=](const Context &context) { return function(*surface, context); });
    };
}

template <class First, class Second, class Function>
std::function<Call(std::size_t)> on_two(First first, Second second, Function function) {
    return [=](std::size_t n) {
        const auto a = std::make_shared<const Surface>(sheet_of(first(n)));
        const auto b = std::make_shared<const Surface>(sheet_of(second(n)));
        return making([=](const Context &context) { return function(*a, *b, context); });
    };
}
} // namespace

std::vector<Row> surface_rows() {
    const auto flat = [](std::size_t n) { return plane_grid(n); };
    const auto above = [](std::size_t n) { return plane_grid(n, 0.01); };
    const auto rough = [](std::size_t n) { return random_grid(n, 1, 0.8); };
    const auto other = [](std::size_t n) { return random_grid(n, 2, 0.8); };
    const auto round = [](std::size_t n) { return sphere_grid(n); };
    const auto one = [](std::size_t n) { return point_grid(n); };
    const auto index = [](auto family) {
        return [=](std::size_t n) {
            const auto sheet = std::make_shared<const Sheet>(sheet_of(family(n)));
            return making([=](const Context &context) { return Surface(*sheet, gusset::SurfaceOptions(), context); });
        };
    };
    const auto nearest = [](const Surface &surface, const Context &context) {
        return surface.nearest(Point3{0, 0, 0}, gusset::NearestOptions(), context);
    };
    const auto minima = [](const Surface &surface, const Context &context) {
        return surface.minima(Point3{0, 0, 0}, gusset::NearestOptions(), context);
    };
    const auto intersect = [](const Surface &a, const Surface &b, const Context &context) {
        return a.intersect(b, gusset::IntersectionOptions(), context);
    };
    const auto itself = [](const Surface &a, const Context &context) {
        return a.self_intersect(gusset::IntersectionOptions(), context);
    };
    const auto apart = [](const Surface &a, const Surface &b, const Context &context) {
        return a.distance(b, 0.0, context);
    };
    const auto section = [](const Surface &surface, const Context &context) {
        return surface.section({0, 0, 0}, {0, 0, 1}, gusset::ContourOptions(), context);
    };
    const auto isophotes = [](const Surface &surface, const Context &context) {
        const double angles[] = {0.5};
        return surface.isophotes({0, 0, 1}, angles, gusset::NormalSide::one, gusset::ContourOptions(), context);
    };
    const auto hits = [](const Surface &surface, const Context &context) {
        return surface.line_hits(gusset::Line::line({0, 0.3, 0}, {1, 0.2, 0}), gusset::HitSelection::all, context);
    };
    const auto mesh = [](auto family) {
        return [=](std::size_t n) {
            const auto sheet = std::make_shared<const Sheet>(sheet_of(family(n)));
            return making([=](const Context &context) {
                return gusset::SheetMesh(*sheet, gusset::SheetMeshOptions(), context);
            });
        };
    };
    return {
        {"surface_create", "rough", 1024, 1000000, 1, 1, 0, index(rough)},
        {"surface_create", "points in one", 1024, 1000000, 1, 1, 0, index(one)},
        {"surface_nearest", "focal point", 64, 1000000, 1, 1, 0, on_surface(round, nearest)},
        {"surface_nearest", "rough", 256, 1000000, 1, 1, 0, on_surface(rough, nearest)},
        {"surface_nearest", "points in one", 64, 1000000, 1, 1, 0, on_surface(one, nearest)},
        {"surface_minima_create", "rough", 64, 10000, 1, 1, 0, on_surface(rough, minima)},
        {"surface_minima_create", "focal point", 16, 10000, 1, 1, 0, on_surface(round, minima), true},
        {"surface_contours_create", "sections, rough", 16, 100000, 1, 1, 0, on_surface(rough, section)},
        {"surface_contours_create", "sections, in its plane", 64, 100000, 1, 1, 0, on_surface(flat, section)},
        {"surface_contours_create", "isophotes, rough", 16, 40000, 2, 1, 0, on_surface(rough, isophotes), true},
        {"surface_hits_create", "rough", 256, 1000000, 1, 1, 0, on_surface(rough, hits)},
        {"surface_distance", "parallel planes", 64, 100000, 2, 2, 0, on_two(flat, above, apart)},
        {"surface_intersection_create", "rough", 4, 256, 2, 2, 0, on_two(rough, other, intersect), true},
        {"surface_intersection_create", "equal copies", 4, 256, 2, 2, 0, on_two(rough, rough, intersect), true},
        // n cells have (3 sqrt n - 2)^2 pairs that touch, which grow faster than n while n is small, and room doubles.
        {"surface_intersection_create", "equal planes", 36, 256, 1.2, 1.2, 0, on_two(flat, flat, intersect)},
        {"surface_intersection_create", "points in one", 4, 256, 2, 2, 0, on_two(one, one, intersect), true},
        {"surface_intersection_create", "itself, rough", 4, 256, 2, 2, 0, on_surface(rough, itself), true},
        {"surface_intersection_create", "itself, points in one", 4, 256, 2, 2, 0, on_surface(one, itself), true},
        {"sheet_to_mesh", "rough", 256, 1000000, 1, 1, 0, mesh(rough)},
    };
}

} // namespace complexity
