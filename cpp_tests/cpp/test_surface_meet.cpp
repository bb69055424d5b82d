// Intersections of smooth surfaces with lines, planes and each other, compared with formulas, and with CGAL on a fine
// mesh of each surface.
#include "fine.hpp"
#include "surfaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace surface_meet_tests {

namespace {
using gusset::Surface;
using gusset::Line;
using gusset::Point3;
using gusset::Sheet;
using shapes::distance;
using shapes::of;
using shapes::pi;
} // namespace

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
    CHECK_THROWS_AS(all[1], gusset::Error);

    // The plane z = 0 of a flat sheet, and a line in it.
    const Surface flat(Sheet::from_nodes(4, 4, shapes::nodes(3, 3, false, false, [](double u, double v) { return Point3{u, v, 0}; })));
    const gusset::SurfaceHits inside = flat.line_hits(Line::line({-1, 0.4, 0}, {1, 0, 0}));
    REQUIRE(inside[0].size() == 1);
    CHECK(inside[0][0].hit_kind() == gusset::HitKind::inside);
    CHECK(std::abs(inside[0][0].span[1] - inside[0][0].span[0] - 1) < 1e-6);

    // A curve: the parabola z = x^2 - 1/4 over the sheet.
    const std::vector<std::array<double, 3>> points{{0.1, 0.5, -0.24}, {0.5, 0.5, 0.25 - 0.4}, {0.9, 0.5, 0.56}};
    const std::vector<uint32_t> ends{0, 2};
    const gusset::SurfaceHits curve = flat.curve_hits(gusset::Curve::from_controls(points, ends, false));
    REQUIRE(curve.size() == 1);
    REQUIRE(curve[0].size() == 1);
    CHECK(curve.on_curve().size() == 3);
    CHECK(std::abs(curve[0][0].point[2]) < 1e-12);
}

TEST_CASE("sections have the components and lengths of a fine mesh's") {
    gusset::ContourOptions chords;
    chords.chord = 1e-5;
    for (int shape = 0; shape < 3; ++shape) {
        const Fine fine(shape == 0 ? shapes::torus_sheet() : shape == 1 ? shapes::sphere_sheet() : shapes::wavy_sheet(), 1e-4);
        const std::vector<Point3> normals = shapes::random_points(24, 1, 101 + unsigned(shape));
        for (std::size_t k = 0; k < normals.size(); ++k) {
            const Point3 at{0.04 * double(k) - 0.5, 0.03, 0.02};
            const gusset::SurfacePaths paths = fine.surface.section(at, normals[k], chords);
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
    // No ring at -0.5, two rings at each of the others.
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
    CHECK_THROWS_AS(stack[6], gusset::Error);
    CHECK(stack.points().size() > 100);
    gusset::ContourOptions edges, leus;
    edges.spacing = gusset::SpacingRule::cell_edges;
    leus.points = 3;
    const gusset::SurfacePaths few = torus.section({0, 0, 0.1}, {0, 0, 1}, edges);
    CHECK(few.points().size() == 80);
    const gusset::SurfacePaths cubics = torus.section({0, 0, 0.1}, {0, 0, 1}, leus);
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
    coarse.spacing = gusset::SpacingRule::cell_edges;
    const gusset::SurfacePaths rough = torus.intersect(plane, coarse);
    CHECK(rough.points().size() < met.points().size());
    const gusset::SurfaceCells pairs = torus.cell_pairs(plane);
    CHECK(pairs.size() >= 80);
    CHECK(pairs.others().size() == pairs.size());
    CHECK(pairs.mask().empty());
    CHECK(pairs.first().empty());
    std::size_t counted = 0;
    for (const gusset::SurfaceCell &cell : pairs) {
        CHECK(cell.row < 24);
        CHECK(pairs.others()[counted].row == 0);
        CHECK(cell.column == pairs[counted].column);
        ++counted;
    }
    CHECK(counted == pairs.size());
    CHECK_THROWS_AS(pairs[counted], gusset::Error);
    const Surface away(Sheet::from_nodes(2, 2, std::vector<Point3>{{-2, -2, 1}, {-2, 2, 1}, {2, -2, 1}, {2, 2, 1}}));
    CHECK(torus.cell_pairs(away).size() == 0);
    CHECK(torus.cell_pairs(away).empty());
    const gusset::SurfaceCells nearer = torus.cell_pairs(away, 0.7);
    CHECK(nearer.others().size() > 0);
    CHECK(torus.intersect(away).empty());
}

} // namespace surface_meet_tests
