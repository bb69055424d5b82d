// Queries of smooth surfaces from C++: against formulas, and against CGAL on a fine mesh of the
// same surface.
#include "data.hpp"
#include "oracle.hpp"
#include "surfaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <thread>
#include <type_traits>

namespace surface_tests {

namespace {
using gusset::Surface;
using gusset::Line;
using gusset::Point3;
using gusset::Sheet;
using shapes::distance;
using shapes::of;
using shapes::pi;

struct Fine {
    Sheet sheet;
    Surface surface;
    double deviation;
    Oracle oracle;

    explicit Fine(Sheet given, double tolerance = 5e-4)
        : sheet(std::move(given)), surface(sheet), deviation(0), oracle(meshed(sheet, tolerance, deviation)) {}

private:
    static Oracle meshed(const Sheet &sheet, double tolerance, double &deviation) {
        gusset::SheetMeshOptions options;
        options.tolerance = tolerance;
        options.triangles = true;
        const gusset::SheetMesh mesh(sheet, options);
        deviation = mesh.deviation();
        return Oracle(mesh.mesh());
    }
};

// Spans live as long as their owner: a variable lends them, a temporary does not.
#define GUSSET_LENDS(name, call)            \
    template <class T, class = void>        \
    struct name : std::false_type {};       \
    template <class T>                      \
    struct name<T, std::void_t<decltype(std::declval<T>().call)>> : std::true_type {}
GUSSET_LENDS(At, operator[](0));
GUSSET_LENDS(Begin, begin());
GUSSET_LENDS(End, end());
GUSSET_LENDS(Points, points());
GUSSET_LENDS(Unresolved, unresolved());
GUSSET_LENDS(Contacts, contacts());
GUSSET_LENDS(HitsOf, hits());
GUSSET_LENDS(OnCurve, on_curve());
GUSSET_LENDS(Cells, cells());
GUSSET_LENDS(Mask, mask());
GUSSET_LENDS(First, first());
GUSSET_LENDS(Pairs, pairs());
GUSSET_LENDS(Mesh, mesh());
GUSSET_LENDS(PlacesOf, places());
GUSSET_LENDS(Normals, normals());
GUSSET_LENDS(Words, words());
GUSSET_LENDS(View, view());
GUSSET_LENDS(Intersections, intersections());
#undef GUSSET_LENDS
template <template <class, class...> class Lends, class T>
constexpr bool lasting = Lends<T &>::value && Lends<const T &>::value && !Lends<T>::value && !Lends<const T>::value;
template <class T>
constexpr bool lasting_range = lasting<Begin, T> && lasting<End, T>;

static_assert(lasting_range<gusset::SurfacePaths> && lasting<At, gusset::SurfacePaths>, "paths");
static_assert(lasting<Points, gusset::SurfacePaths> && lasting<Unresolved, gusset::SurfacePaths> && lasting<Contacts, gusset::SurfacePaths>, "points of paths");
static_assert(lasting_range<gusset::SurfaceHits> && lasting<At, gusset::SurfaceHits>, "hits");
static_assert(lasting<HitsOf, gusset::SurfaceHits> && lasting<OnCurve, gusset::SurfaceHits>, "hits of all lines");
static_assert(lasting_range<gusset::SurfacePoints> && lasting<Points, gusset::SurfacePoints>, "points");
static_assert(lasting_range<gusset::SurfaceRegion> && lasting<Cells, gusset::SurfaceRegion>, "cells");
static_assert(lasting<Mask, gusset::SurfaceRegion> && lasting<First, gusset::SurfaceRegion>, "bits of cells");
static_assert(lasting_range<gusset::CellPairs> && lasting<Pairs, gusset::CellPairs>, "pairs");
static_assert(lasting<Mesh, gusset::SheetMesh> && lasting<PlacesOf, gusset::SheetMesh> && lasting<Normals, gusset::SheetMesh>, "meshes");
static_assert(lasting<Words, gusset::CellMask>, "masks");
static_assert(lasting<View, gusset::Assembly> && lasting<View, gusset::Check> && lasting<View, gusset::Facing>, "reports");
static_assert(lasting<View, gusset::NetComplex> && lasting<Intersections, gusset::Stitch>, "cells, and pairs of faces");
// Elements that are copies may be had of temporaries.
static_assert(std::is_same_v<decltype(std::declval<gusset::SurfacePoints>()[0]), gusset::NearestPoint>, "a copy");
static_assert(std::is_same_v<decltype(std::declval<gusset::SurfaceRegion>()[0]), gusset::RegionCell>, "a copy");
static_assert(std::is_same_v<decltype(std::declval<gusset::CellPairs>()[0]), gusset::CellPair>, "a copy");
static_assert(std::is_same_v<decltype(std::declval<gusset::Hits>()[0]), gusset::Hit>, "a copy");

bool same(const gusset::NearestPoint &a, const gusset::NearestPoint &b) { return std::memcmp(&a, &b, sizeof a) == 0; }
} // namespace

TEST_CASE("nearest points are as near as those of a fine mesh, and as their bounds say") {
    for (int shape = 0; shape < 3; ++shape) {
        const Fine fine(shape == 0 ? shapes::torus_sheet() : shape == 1 ? shapes::sphere_sheet() : shapes::wavy_sheet());
        const std::vector<Point3> queries = shapes::random_points(400, 1.7, 7 + unsigned(shape));
        const std::vector<gusset::NearestPoint> found = fine.surface.nearest(queries);
        for (std::size_t k = 0; k < queries.size(); ++k) {
            REQUIRE(found[k].is_found());
            CHECK(std::abs(distance(queries[k], of(found[k].point)) - found[k].distance) < 1e-12);
            CHECK(found[k].bound <= found[k].distance);
            if (found[k].is_proven()) {
                CHECK(found[k].distance - found[k].bound < 1e-8);
            }
            // The mesh is within the deviation of the surface, both ways.
            const double on_mesh = fine.oracle.distance(queries[k]);
            CHECK(found[k].distance <= on_mesh + fine.deviation);
            CHECK(found[k].bound >= on_mesh - fine.deviation - 1e-12);
            CHECK(distance(of(fine.surface.evaluate(found[k].place).point), of(found[k].point)) < 1e-13);
            CHECK(distance(of(fine.surface.evaluate(found[k].place).normal), of(found[k].normal)) < 1e-9);
            CHECK(same(found[k], fine.surface.nearest(queries[k])));
            if (shape == 0) {
                CHECK(std::abs(found[k].distance - std::abs(shapes::outside_torus(queries[k]))) < 1e-4);
            }
        }
    }
}

TEST_CASE("distances from lines, planes, curves and surfaces") {
    std::vector<Point3> nodes;
    for (int k = 0; k < 36; ++k) {
        nodes.push_back({double(k / 6), double(k % 6), 0.0});
    }
    const Surface flat(Sheet::from_nodes(6, 6, nodes));
    for (Point3 &node : nodes) {
        node[2] = 1.5;
    }
    const Surface above(Sheet::from_nodes(6, 6, nodes));
    const gusset::SurfaceDistance apart = flat.distance(above);
    CHECK(std::abs(apart.distance - 1.5) < 1e-12);
    CHECK(apart.is_proven());
    CHECK_FALSE(apart.meets());
    CHECK(std::abs(flat.distance(Line::line({0, 1, 2}, {1, 1, 0})).distance - 2) < 1e-12);
    CHECK(std::abs(flat.distance(Point3{0, 0, 3}, Point3{0, 0, 1}).parameter + 3) < 1e-12);
    CHECK(flat.distance(Line::line({1, 1, 2}, {0, 0, 1})).meets());
    const std::array<Point3, 2> bar{{{1, 1, 0.5}, {2, 2, 1}}};
    const std::array<uint32_t, 2> ends{0, 1};
    const auto curve = gusset::Curve::from_points(bar, gusset::Indices(ends), false);
    CHECK(std::abs(flat.distance(curve).distance - 0.5) < 1e-12);
    CHECK_THROWS_AS(flat.distance(curve, -1.0), gusset::Error);
}

TEST_CASE("limits, minima, regions") {
    const Surface torus(shapes::torus_sheet());
    gusset::NearestOptions options;
    options.limit = 0.3;
    CHECK(torus.nearest({1.6, 0, 0}, options).is_found());
    const gusset::NearestPoint none = torus.nearest({1.8, 0, 0}, options);
    CHECK_FALSE(none.is_found());
    CHECK(none.distance == std::numeric_limits<double>::infinity());

    // From a point inside the ring and off its axis: the distance has one local minimum in
    // each half plane section, on both sides.
    const Point3 query{0.2, 0.05, 0.03};
    const gusset::SurfacePoints minima = torus.minima(query);
    CHECK(minima.complete());
    REQUIRE(minima.size() >= 1);
    CHECK(std::is_sorted(minima.begin(), minima.end(), [](const auto &a, const auto &b) { return a.distance < b.distance; }));
    CHECK(std::abs(minima[0].distance - torus.nearest(query).distance) < 1e-12);
    for (const gusset::NearestPoint &place : minima) {
        // Across the surface.
        const Point3 way = shapes::minus(query, of(place.point));
        CHECK(std::abs(std::abs(shapes::dot(way, of(place.normal))) - place.distance) < 1e-6);
    }
    options.limit.reset();
    options.max_count = 1;
    CHECK(torus.minima(query, options).size() == 1);

    CHECK(torus.minima(query, options)[0].distance == minima[0].distance);
    CHECK_THROWS_AS(minima[minima.size()], std::out_of_range);
    CHECK(minima.begin()->distance == minima.points()[0].distance);

    const double radius = 0.5;
    const Point3 centre{1.2, 0.3, 0.2};
    const gusset::SurfaceRegion region = torus.region(centre, radius);
    REQUIRE(region.size() > 0);
    CHECK(region.first().size() == 2);
    CHECK(region.first()[1] == 24 * 40);
    std::vector<bool> in(24 * 40);
    for (const gusset::RegionCell &cell : region) {
        const std::size_t bit = cell.row * 40 + cell.column;
        in[bit] = true;
        CHECK((region.mask()[bit / 64] >> (bit % 64) & 1) == 1);
    }
    CHECK(region.cells().size() == region.size());
    CHECK(region[0].row == region.begin()->row);
    CHECK_THROWS_AS(region[region.size()], std::out_of_range);
    CHECK_FALSE(region.contains(1, region[0].row, region[0].column));
    CHECK_FALSE(region.contains(0, 24, 0));
    CHECK_FALSE(region.contains(0, 0, 40));
    for (uint32_t row = 0; row < 24; ++row) {
        for (uint32_t column = 0; column < 40; ++column) {
            const Point3 middle = of(torus.evaluate(gusset::surface_place(0, row, column)).point);
            CHECK(region.contains(0, row, column) == in[row * 40 + column]);
            if (distance(middle, centre) < radius) {
                CHECK(in[row * 40 + column]);
            }
            if (distance(middle, centre) > radius + 0.2) {
                CHECK_FALSE(in[row * 40 + column]);
            }
        }
    }
}

TEST_CASE("lines meet the surface where they meet a fine mesh") {
    for (int shape = 0; shape < 3; ++shape) {
        const Fine fine(shape == 0 ? shapes::torus_sheet() : shape == 1 ? shapes::sphere_sheet() : shapes::wavy_sheet(), 1e-4);
        const std::vector<Point3> ends = shapes::random_points(1200, 1.5, 31 + unsigned(shape));
        std::vector<Line> lines;
        for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
            lines.push_back(Line::line(ends[k], shapes::minus(ends[k + 1], ends[k])));
        }
        const gusset::SurfaceHits hits = fine.surface.line_hits(lines);
        REQUIRE(hits.size() == lines.size());
        std::size_t differing = 0, met = 0;
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const gusset::Hits own = hits[k];
            for (const gusset::Hit &hit : own) {
                CHECK(distance(of(hit.point), {lines[k].origin[0] + hit.t * lines[k].direction[0], lines[k].origin[1] + hit.t * lines[k].direction[1],
                                               lines[k].origin[2] + hit.t * lines[k].direction[2]}) < 1e-8);
                CHECK(distance(of(fine.surface.evaluate(hit.place).point), of(hit.point)) < 1e-8);
            }
            if (shape < 2) {
                CHECK(own.size() % 2 == 0); // Closed surfaces.
            }
            const std::vector<double> others = fine.oracle.crossings(of(lines[k].origin), of(lines[k].direction));
            met += own.size();
            differing += own.size() != others.size() ? 1 : 0;
            for (std::size_t i = 0; i < own.size() && own.size() == others.size(); ++i) {
                CHECK(std::abs(own[i].t - others[i]) < 0.1);
            }
        }
        CHECK(met > 100);
        // Lines that nearly touch may pass the one and meet the other.
        CHECK(differing <= lines.size() / 100);
    }
}

TEST_CASE("which hits, and what they are") {
    const Surface torus(shapes::torus_sheet());
    const Line across = Line::line({-3, 0.1, 0.05}, {1, 0, 0});
    const gusset::SurfaceHits all = torus.line_hits(across);
    REQUIRE(all[0].size() == 4);
    for (const gusset::Hit &hit : all.hits()) {
        CHECK(hit.hit_kind() == gusset::HitKind::crossing);
        CHECK(hit.span[0] == hit.t);
    }
    const gusset::SurfaceHits first = torus.line_hits(across, gusset::HitSelection::first);
    REQUIRE(first[0].size() == 1);
    CHECK(first[0][0].t == all[0][0].t);
    const gusset::SurfaceHits any = torus.line_hits(across, gusset::HitSelection::any);
    CHECK(any[0].size() == 1);
    const gusset::SurfaceHits ray = torus.line_hits(Line::ray({0, 0.1, 0.05}, {1, 0, 0}));
    CHECK(ray[0].size() == 2);
    const gusset::SurfaceHits segment = torus.line_hits(Line::segment({0, 0.1, 0.05}, {1, 0.1, 0.05}));
    CHECK(segment[0].size() == 1);
    // A range over a temporary keeps it to the end.
    std::size_t met = 0;
    for (const gusset::Hits &own : torus.line_hits(across)) {
        met += own.size();
    }
    CHECK(met == 4);
    // Hits are copies: they stay when all else is gone.
    const std::vector<gusset::Hit> copies(ray[0].begin(), ray[0].end());
    REQUIRE(copies.size() == 2);
    CHECK(copies[0].t == ray[0].begin()->t);
    CHECK(copies[1].t == ray[0].data()[1].t);
    const std::vector<Line> lines{across, Line::line({5, 5, 5}, {1, 0, 0})};
    const std::vector<gusset::Hit> hits = torus.first_hits(lines);
    CHECK(hits[0].t == all[0][0].t);
    CHECK(hits[1].hit_kind() == gusset::HitKind::none);
    CHECK_FALSE(hits[1].is_found());
    CHECK_THROWS_AS(all[1], std::out_of_range);

    // The plane z = 0 of a flat sheet, and a line in it.
    const Surface flat(Sheet::from_nodes(4, 4, shapes::nodes(3, 3, false, false, [](double u, double v) { return Point3{u, v, 0}; })));
    const gusset::SurfaceHits inside = flat.line_hits(Line::line({-1, 0.4, 0}, {1, 0, 0}));
    REQUIRE(inside[0].size() == 1);
    CHECK(inside[0][0].hit_kind() == gusset::HitKind::inside);
    CHECK(std::abs(inside[0][0].span[1] - inside[0][0].span[0] - 1) < 1e-6);

    // A curve: the parabola z = x^2 - 1/4 over the sheet.
    const std::vector<std::array<double, 3>> points{{0.1, 0.5, -0.24}, {0.5, 0.5, 0.25 - 0.4}, {0.9, 0.5, 0.56}};
    const std::vector<uint32_t> ends{0, 2};
    const gusset::SurfaceHits curve = flat.curve_hits(gusset::Curve::from_points(points, ends, false));
    REQUIRE(curve.size() == 1);
    REQUIRE(curve[0].size() == 1);
    CHECK(curve.on_curve().size() == 3);
    CHECK(std::abs(curve[0][0].point[2]) < 1e-12);
}

TEST_CASE("sections have the components and lengths of a fine mesh's") {
    for (int shape = 0; shape < 3; ++shape) {
        const Fine fine(shape == 0 ? shapes::torus_sheet() : shape == 1 ? shapes::sphere_sheet() : shapes::wavy_sheet(), 1e-4);
        const std::vector<Point3> normals = shapes::random_points(24, 1, 101 + unsigned(shape));
        for (std::size_t k = 0; k < normals.size(); ++k) {
            const Point3 at{0.04 * double(k) - 0.5, 0.03, 0.02};
            const gusset::SurfacePaths paths = fine.surface.section(at, normals[k], gusset::PointSpacing::chord(1e-5));
            const std::vector<Slice> slices = fine.oracle.slices(at, normals[k]);
            CHECK(paths.unresolved().empty());
            REQUIRE(paths.size() == slices.size());
            std::vector<Slice> own;
            for (const gusset::SurfacePath &path : paths) {
                own.push_back({path.closed, shapes::length(path)});
                const double size = std::sqrt(shapes::dot(normals[k], normals[k]));
                for (std::size_t i = 0; i < path.size(); ++i) {
                    REQUIRE(std::abs(shapes::dot(shapes::minus(path.points[i], at), normals[k])) < 1e-11 * size);
                    REQUIRE(distance(of(fine.surface.evaluate(path.places[i]).point), path.points[i]) < 1e-9);
                }
            }
            std::sort(own.begin(), own.end(), [](const Slice &a, const Slice &b) { return a.length > b.length; });
            for (std::size_t i = 0; i < own.size(); ++i) {
                CHECK(own[i].closed == slices[i].closed);
                CHECK(std::abs(own[i].length - slices[i].length) < 0.01 * slices[i].length + 0.01);
            }
        }
    }
}

TEST_CASE("stacks of planes, contours, angles") {
    const Sheet sheet = shapes::torus_sheet();
    const Surface torus(sheet);
    const std::vector<double> offsets{-0.5, -0.2, 0.1, 0.3};
    const gusset::SurfacePaths stack = torus.sections({0, 0, 0}, {0, 0, 2}, offsets);
    // None at -0.5, two rings each at the others.
    REQUIRE(stack.size() == 6);
    for (const gusset::SurfacePath &path : stack) {
        CHECK(path.closed);
        CHECK(path.level >= 1);
        const double z = offsets[path.level], half = std::sqrt(0.16 - z * z);
        for (const Point3 &p : path.points) {
            CHECK(std::abs(p[2] - z) < 1e-12);
            CHECK(std::abs(std::abs(std::hypot(p[0], p[1]) - 1) - half) < 2e-4);
        }
    }
    CHECK_THROWS_AS(stack[6], std::out_of_range);
    CHECK(stack.points().size() > 100);
    const gusset::SurfacePaths few = torus.section({0, 0, 0.1}, {0, 0, 1}, gusset::PointSpacing::cell_edges());
    CHECK(few.points().size() == 80);
    const gusset::SurfacePaths cubics = torus.section({0, 0, 0.1}, {0, 0, 1}, gusset::PointSpacing::leus(3));
    CHECK(cubics.points().size() == 320);

    // The height as a field is the section.
    std::vector<double> heights;
    for (const Point3 &p : shapes::nodes(24, 40, true, true, shapes::torus)) {
        heights.push_back(p[2]);
    }
    const gusset::SurfacePaths contours = torus.contours(heights, offsets);
    REQUIRE(contours.size() == stack.size());
    for (std::size_t k = 0; k < stack.size(); ++k) {
        CHECK(contours[k].level == stack[k].level);
        CHECK(std::abs(shapes::length(contours[k]) - shapes::length(stack[k])) < 1e-3);
    }

    // Seen along its axis the torus has the rings of the radii 0.6 and 1.4 for silhouettes.
    const gusset::SurfacePaths outline = torus.silhouette({0, 0, 1});
    REQUIRE(outline.size() == 2);
    for (const gusset::SurfacePath &path : outline) {
        for (std::size_t k = 0; k < path.size(); ++k) {
            CHECK(std::abs(path.normals[k][2]) < 1e-8);
            CHECK(std::abs(std::abs(std::hypot(path.points[k][0], path.points[k][1]) - 1) - 0.4) < 2e-4);
        }
    }
    const std::vector<double> angles{pi / 6, pi / 3};
    CHECK(torus.isophotes({0, 0, 1}, angles).size() == 4);
    CHECK(torus.isophotes({0, 0, 1}, angles, gusset::NormalSide::both).size() == 8);

    // On half a sphere normals are at most a right angle from the axis; on a flat sheet there is
    // one.
    const Surface flat(Sheet::from_nodes(4, 4, shapes::nodes(3, 3, false, false, [](double u, double v) { return Point3{u, v, 0}; })));
    const gusset_nearest_angle_report nearest = flat.nearest_angle({0, 0, 1}, 0.5);
    CHECK(std::abs(nearest.deviation - 0.5) < 1e-9);
    CHECK(nearest.bound <= nearest.deviation);
    CHECK(torus.nearest_angle({0, 0, 1}, 1.0).deviation < 1e-9);
}

TEST_CASE("a paraboloid touches the plane in its lowest point, and a saddle crosses it in two lines") {
    const auto bent = [](double sign) {
        return Surface(Sheet::from_nodes(9, 9, shapes::nodes(8, 8, false, false, [sign](double u, double v) {
            const double x = 2 * u - 1, y = 2 * v - 1;
            return Point3{x, y, x * x + sign * y * y};
        })));
    };
    const Surface plane(Sheet::from_nodes(2, 2, std::vector<Point3>{{-2, -2, 0}, {-2, 2, 0}, {2, -2, 0}, {2, 2, 0}}));
    const gusset::SurfacePaths touching = bent(1).intersect(plane), crossing = bent(-1).intersect(plane);
    CHECK(touching.empty());
    CHECK(touching.unresolved().empty());
    REQUIRE(touching.contacts().size() == 1);
    CHECK(touching.contacts()[0].kind == GUSSET_CONTACT_POINT);
    CHECK(std::abs(touching.contacts()[0].gap) < 1e-12);
    CHECK(crossing.size() == 2);
    CHECK(crossing.unresolved().empty());
    REQUIRE(crossing.contacts().size() == 1);
    CHECK(crossing.contacts()[0].kind == GUSSET_CONTACT_CROSSING);
}

TEST_CASE("surfaces meet in the curves of formulas") {
    const Surface torus(shapes::torus_sheet());
    const Surface plane(Sheet::from_nodes(2, 2, std::vector<Point3>{{-2, -2, 0.1}, {-2, 2, 0.15}, {2, -2, 0.1}, {2, 2, 0.15}}));
    const gusset::SurfacePaths met = torus.intersect(plane);
    // The plane through the four corners.
    const gusset::SurfacePaths cut = torus.section({0, 0, 0.125}, {0, -0.05, 4});
    REQUIRE(met.size() == 2);
    REQUIRE(cut.size() == 2);
    CHECK(met.unresolved().empty());
    std::array<double, 2> lengths{shapes::length(met[0]), shapes::length(met[1])}, others{shapes::length(cut[0]), shapes::length(cut[1])};
    std::sort(lengths.begin(), lengths.end());
    std::sort(others.begin(), others.end());
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(std::abs(lengths[k] - others[k]) < 1e-3);
        REQUIRE(met[k].others.size() == met[k].size());
        CHECK(met[k].closed);
        for (std::size_t i = 0; i < met[k].size(); ++i) {
            CHECK(distance(of(plane.evaluate(met[k].others[i]).point), met[k].points[i]) < 1e-8);
            CHECK(distance(of(torus.evaluate(met[k].places[i]).point), met[k].points[i]) < 1e-12);
        }
    }
    CHECK(cut[0].others.empty());
    gusset::IntersectionOptions coarse;
    coarse.chord = std::numeric_limits<double>::infinity();
    const gusset::SurfacePaths rough = torus.intersect(plane, coarse);
    CHECK(rough.points().size() < met.points().size());
    const gusset::CellPairs pairs = torus.cell_pairs(plane);
    CHECK(pairs.size() >= 80);
    std::size_t counted = 0;
    for (const gusset::CellPair &pair : pairs) {
        CHECK(pair.row_a < 24);
        CHECK(pair.row_b == 0);
        CHECK(pair.column_a == pairs[counted].column_a);
        ++counted;
    }
    CHECK(counted == pairs.size());
    CHECK_THROWS_AS(pairs[counted], std::out_of_range);
    const Surface away(Sheet::from_nodes(2, 2, std::vector<Point3>{{-2, -2, 1}, {-2, 2, 1}, {2, -2, 1}, {2, 2, 1}}));
    CHECK(torus.cell_pairs(away).size() == 0);
    CHECK(torus.cell_pairs(away).empty());
    const gusset::CellPairs nearer = torus.cell_pairs(away, 0.7);
    CHECK(nearer.pairs().size() > 0);
    CHECK(torus.intersect(away).empty());
}

TEST_CASE("several sheets, places, facts") {
    std::vector<Sheet> sheets;
    sheets.push_back(shapes::torus_sheet());
    sheets.push_back(shapes::sphere_sheet());
    const Surface both(sheets, 1e-10);
    const gusset_surface_report facts = both.report();
    CHECK(facts.sheet_count == 2);
    CHECK(facts.cell_count == 2 * 24 * 40);
    CHECK(facts.tolerance == 1e-10);
    CHECK(facts.low[0] <= -1.399);
    CHECK(facts.high[2] >= 0.999);
    CHECK(facts.cone_bytes == 0);
    const Surface with_cones(sheets, 1e-10, gusset::Context(), gusset::NormalCones::eager);
    CHECK(with_cones.report().index_bytes == facts.index_bytes);
    CHECK(with_cones.report().cone_bytes > 0);
    CHECK(with_cones.silhouette({0, 0, 1}).size() == both.silhouette({0, 0, 1}).size());
    CHECK(both.report().cone_bytes == with_cones.report().cone_bytes);
    CHECK(both.nearest({0, 0, 2}).place.sheet == 1);
    CHECK(both.nearest({1.5, 0, 0}).place.sheet == 0);
    // Results outlive their surface.
    gusset::SurfacePaths kept(nullptr);
    {
        const Surface gone(shapes::torus_sheet());
        kept = gone.section({0, 0, 0.1}, {0, 0, 1});
    }
    CHECK(kept.size() == 2);

    const std::vector<std::array<double, 2>> parameters{{3.25, 7.5}, {-1, 41}, {24, 40}};
    const std::vector<gusset::SurfacePlace> places = both.locate(0, parameters);
    CHECK(places[0].row == 3);
    CHECK(places[0].u == 0.25);
    CHECK(places[1].row == 23); // Closed directions are counted round.
    CHECK(places[1].column == 1);
    const gusset::SurfacePoint point = both.evaluate(gusset::surface_place(1, 12, 7));
    CHECK(point.normal_kind == GUSSET_NORMAL_REGULAR);
    CHECK(std::abs(std::abs(point.principal[0]) - 1) < 0.02);
    CHECK(std::abs(point.gaussian - 1) < 0.04);
    const gusset::SurfacePoint pole = both.evaluate(both.locate(1, 0, 3.5));
    CHECK(pole.normal_kind == GUSSET_NORMAL_LIMIT);
    CHECK(std::abs(std::abs(pole.normal[2]) - 1) < 1e-3);
}

TEST_CASE("errors say which") {
    const Surface torus(shapes::torus_sheet());
    std::vector<Point3> queries = shapes::random_points(5, 1, 3);
    queries[3][0] = std::numeric_limits<double>::quiet_NaN();
    const auto status_of = [](auto &&call) {
        try {
            call();
        } catch (const gusset::Error &error) {
            return std::make_pair(error.status(), error.report().index);
        }
        return std::make_pair(int32_t(GUSSET_OK), uint64_t(0));
    };
    CHECK(status_of([&] { torus.nearest(queries); }) == std::make_pair(int32_t(GUSSET_ERROR_NOT_FINITE), uint64_t(3)));
    const std::vector<Line> lines{Line::line({0, 0, 0}, {1, 0, 0}), Line::line({0, 0, 0}, {0, 0, 0})};
    CHECK(status_of([&] { torus.line_hits(lines); }).first == GUSSET_ERROR_OUT_OF_RANGE);
    CHECK(status_of([&] { torus.section({0, 0, 0}, {0, 0, 0}); }).first == GUSSET_ERROR_OUT_OF_RANGE);
    const std::vector<double> falling{1, 0};
    CHECK(status_of([&] { torus.sections({0, 0, 0}, {0, 0, 1}, falling); }).first == GUSSET_ERROR_OUT_OF_RANGE);
    CHECK(status_of([&] { torus.contours(falling, falling); }).first != GUSSET_OK);
    CHECK(status_of([&] { torus.isophotes({0, 0, 0}, falling); }).first == GUSSET_ERROR_OUT_OF_RANGE);
    CHECK(status_of([&] { torus.nearest_angle({0, 0, 1}, 4); }).first == GUSSET_ERROR_OUT_OF_RANGE);
    CHECK(status_of([&] { torus.region({0, 0, 0}, -1); }).first == GUSSET_ERROR_OUT_OF_RANGE);
    const std::vector<gusset::SurfacePlace> places{gusset::surface_place(0, 1, 1), gusset::surface_place(0, 24, 0)};
    CHECK(status_of([&] { torus.evaluate(places); }) == std::make_pair(int32_t(GUSSET_ERROR_NO_SUCH_ELEMENT), uint64_t(1)));
    CHECK(status_of([&] { Surface(gusset::Span<const Sheet>()); }).first == GUSSET_ERROR_EMPTY_MESH);
    CHECK(status_of([&] { Surface(shapes::torus_sheet(), -1); }).first == GUSSET_ERROR_OUT_OF_RANGE);
    gusset::IntersectionOptions options;
    options.chord = -1;
    CHECK(status_of([&] { torus.intersect(torus, options); }).first == GUSSET_ERROR_OUT_OF_RANGE);
}

TEST_CASE("any number of threads gives the same bits, in many threads at once") {
    const Sheet sheet = shapes::torus_sheet(60, 90);
    const std::vector<Point3> queries = shapes::random_points(3000, 1.6, 77);
    gusset::Context one;
    one.set_threads(1);
    const Surface surface(sheet, 0, one);
    const std::vector<gusset::NearestPoint> expected = surface.nearest(queries, {}, one);
    const gusset::SurfacePaths paths = surface.section({0.1, 0, 0}, {1, 2, 3}, {}, one);
    std::vector<int> equal(4, 0);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < equal.size(); ++t) {
        threads.emplace_back([&, t] {
            gusset::Context context;
            context.set_threads(uint32_t(t) + 1);
            const std::vector<gusset::NearestPoint> found = surface.nearest(queries, {}, context);
            const gusset::SurfacePaths own = surface.section({0.1, 0, 0}, {1, 2, 3}, {}, context);
            const bool points = own.points().size() == paths.points().size() &&
                                std::memcmp(own.points().data(), paths.points().data(), paths.points().size() * sizeof(Point3)) == 0;
            equal[t] = points && std::memcmp(found.data(), expected.data(), found.size() * sizeof found[0]) == 0 ? 1 : 0;
        });
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
    CHECK(equal == std::vector<int>(4, 1));
}

TEST_CASE("callbacks may throw, and cancel") {
    struct Stopped {};
    const Surface torus(shapes::torus_sheet());
    const std::vector<Point3> queries = shapes::random_points(2000, 1.6, 5);
    gusset::Context context;
    context.set_progress([](double, const char *) -> bool { throw Stopped(); });
    CHECK_THROWS_AS(torus.nearest(queries, {}, context), Stopped);
    CHECK_THROWS_AS(Surface(shapes::torus_sheet(), 0, context), Stopped);
    CHECK_THROWS_AS(torus.silhouette({1, 2, 3}, {}, context), Stopped);
    context.set_progress([](double, const char *) { return false; });
    try {
        torus.nearest(queries, {}, context);
        FAIL("not cancelled");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_CANCELLED);
    }
    context.set_progress({});
    CHECK(torus.nearest(queries, {}, context).size() == queries.size());
}

TEST_SUITE("real meshes") {
    // Newell's teapot: 28 cubic patches, the first number of each with a minus.
    TEST_CASE("the teapot is as far as a fine mesh of it") {
        const auto folder = data_folder();
        std::ifstream file(folder.value_or("") + "/carcass/teapot_newell_bezier.txt");
        if (!folder || !file) {
            std::cout << "SKIPPED: no teapot\n";
            return;
        }
        std::vector<Point3> points;
        std::vector<Sheet> sheets;
        std::vector<std::unique_ptr<Oracle>> oracles;
        double deviation = 0;
        std::string line;
        std::getline(file, line);
        std::getline(file, line);
        while (std::getline(file, line)) {
            std::istringstream numbers(line);
            double first = 0;
            numbers >> first;
            if (first > 0) {
                Point3 p{};
                numbers >> p[0] >> p[1] >> p[2];
                points.push_back(p);
            } else if (first < 0) {
                std::vector<Point3> net;
                for (double index = -first; numbers && net.size() < 16; numbers >> index) {
                    net.push_back(points.at(std::size_t(index) - 1));
                }
                REQUIRE(net.size() == 16);
                sheets.push_back(Sheet::from_patches(net, 3, 3, 1, 1));
                gusset::SheetMeshOptions options;
                options.tolerance = 1e-3;
                options.triangles = true;
                const gusset::SheetMesh mesh(sheets.back(), options);
                deviation = std::max(deviation, mesh.deviation());
                oracles.push_back(std::make_unique<Oracle>(mesh.mesh()));
            }
        }
        REQUIRE(sheets.size() == 28);
        const Surface teapot(sheets);
        const std::vector<Point3> queries = shapes::random_points(300, 1.2, 9);
        const std::vector<gusset::NearestPoint> found = teapot.nearest(queries);
        for (std::size_t k = 0; k < queries.size(); ++k) {
            double least = std::numeric_limits<double>::infinity();
            for (const auto &oracle : oracles) {
                least = std::min(least, oracle->distance(queries[k]));
            }
            CHECK(found[k].distance <= least + deviation);
            CHECK(found[k].bound >= least - deviation);
        }
    }
}

} // namespace surface_tests
