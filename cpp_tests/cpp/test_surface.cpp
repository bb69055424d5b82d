// Queries of smooth surfaces from C++: against formulas, and against CGAL on a fine mesh of the
// same surface.
#include "data.hpp"
#include "fine.hpp"
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
GUSSET_LENDS(Others, others());
GUSSET_LENDS(Whole, whole());
GUSSET_LENDS(Sheets, sheets());
GUSSET_LENDS(Mesh, mesh());
GUSSET_LENDS(PlacesOf, places());
GUSSET_LENDS(Normals, normals());
GUSSET_LENDS(Words, words());
GUSSET_LENDS(View, view());
GUSSET_LENDS(Report, report());
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
static_assert(lasting_range<gusset::SurfaceCells> && lasting<Cells, gusset::SurfaceCells>, "cells");
static_assert(lasting<Mask, gusset::SurfaceCells> && lasting<First, gusset::SurfaceCells>, "bits of cells");
static_assert(lasting<Others, gusset::SurfaceCells> && lasting<Whole, gusset::SurfaceCells>, "pairs, and whole cells");
static_assert(lasting<Sheets, gusset::Surface>, "sheets");
static_assert(lasting<Mesh, gusset::SheetMesh> && lasting<PlacesOf, gusset::SheetMesh> && lasting<Normals, gusset::SheetMesh>, "meshes");
static_assert(lasting<Words, gusset::CellMask>, "masks");
static_assert(lasting<Report, gusset::Join> && lasting<View, gusset::Check> && lasting<View, gusset::Facing>, "reports");
static_assert(lasting<View, gusset::NetComplex> && lasting<Intersections, gusset::Stitch>, "cells, and pairs of faces");
// Elements that are copies may be had of temporaries.
static_assert(std::is_same_v<decltype(std::declval<gusset::SurfacePoints>()[0]), gusset::NearestPoint>, "a copy");
static_assert(std::is_same_v<decltype(std::declval<gusset::SurfaceCells>()[0]), gusset::SurfaceCell>, "a copy");
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
    const auto curve = gusset::Curve::from_controls(bar, gusset::Indices(ends), false);
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
    options.limit = 0.0;
    options.max_count = 1;
    CHECK(torus.minima(query, options).size() == 1);

    CHECK(torus.minima(query, options)[0].distance == minima[0].distance);
    CHECK_THROWS_AS(minima[minima.size()], gusset::Error);
    CHECK(minima.begin()->distance == minima.points()[0].distance);

    const double radius = 0.5;
    const Point3 centre{1.2, 0.3, 0.2};
    const gusset::SurfaceCells region = torus.region(centre, radius);
    REQUIRE(region.size() > 0);
    CHECK(region.first().size() == 2);
    CHECK(region.first()[1] == 24 * 40);
    std::vector<bool> in(24 * 40);
    for (const gusset::SurfaceCell &cell : region) {
        const std::size_t bit = cell.row * 40 + cell.column;
        in[bit] = true;
        CHECK((region.mask()[bit / 64] >> (bit % 64) & 1) == 1);
    }
    CHECK(region.cells().size() == region.size());
    CHECK(region.whole().size() == region.size());
    CHECK(region.others().empty());
    CHECK(region[0].row == region.begin()->row);
    CHECK_THROWS_AS(region[region.size()], gusset::Error);
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

TEST_CASE("several sheets, places, facts") {
    std::vector<Sheet> sheets;
    sheets.push_back(shapes::torus_sheet());
    sheets.push_back(shapes::sphere_sheet());
    gusset::SurfaceOptions close;
    close.tolerance = 1e-10;
    const Surface both(sheets, close);
    const gusset_surface_report facts = both.report();
    CHECK(facts.sheet_count == 2);
    CHECK(facts.cell_count == 2 * 24 * 40);
    CHECK(facts.tolerance == 1e-10);
    CHECK(facts.low[0] <= -1.399);
    CHECK(facts.high[2] >= 0.999);
    CHECK(facts.cone_bytes == 0);
    CHECK(both.sheets().size() == 2);
    CHECK(both.sheets()[1].first_cell == 24 * 40);
    close.cones = true;
    const Surface with_cones(sheets, close);
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
    gusset::SurfaceOptions negative;
    negative.tolerance = -1;
    CHECK(status_of([&] { Surface(shapes::torus_sheet(), negative); }).first == GUSSET_ERROR_OUT_OF_RANGE);
    gusset::IntersectionOptions options;
    options.chord = -1;
    CHECK(status_of([&] { torus.intersect(torus, options); }).first == GUSSET_ERROR_OUT_OF_RANGE);
    options.chord.reset();
    options.spacing = gusset::SpacingRule::leus;
    CHECK(status_of([&] { torus.self_intersect(options); }).first == GUSSET_ERROR_UNKNOWN_VALUE);
}

TEST_CASE("any number of threads gives the same bits, in many threads at once") {
    const Sheet sheet = shapes::torus_sheet(60, 90);
    const std::vector<Point3> queries = shapes::random_points(3000, 1.6, 77);
    gusset::Context one;
    one.set_threads(1);
    const Surface surface(sheet, {}, one);
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
    CHECK_THROWS_AS(Surface(shapes::torus_sheet(), {}, context), Stopped);
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
