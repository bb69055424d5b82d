// Queries of random smooth surfaces against CGAL on a mesh that is proved to be near: within its
// deviation both ways. And sections against sign changes on a dense grid of the surface itself.
#include "../cpp/oracle.hpp"
#include "../cpp/surfaces.hpp"
#include "pieces.hpp"

#include <algorithm>
#include <cmath>

namespace campaign {
namespace of_surfaces {
namespace {
using gusset::Line;
using gusset::Surface;
using gusset::SurfacePlace;
using shapes::distance;
using shapes::dot;
using shapes::of;

constexpr double mesh_tolerance = 1e-3;
/// Rounding error allowed for points on the surface or in a plane.
constexpr double rounding = 1e-9;

Point along(const Point &from, const Point &direction, double t) {
    return {from[0] + t * direction[0], from[1] + t * direction[1], from[2] + t * direction[2]};
}
Point cross(const Point &a, const Point &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point unit(const Point &a) { return along({0, 0, 0}, a, 1 / std::sqrt(dot(a, a))); }
double from_segment(const Point &q, const Point &a, const Point &b) {
    const Point way = shapes::minus(b, a);
    const double size = dot(way, way), t = size > 0 ? std::clamp(dot(shapes::minus(q, a), way) / size, 0.0, 1.0) : 0;
    return distance(q, along(a, way, t));
}

enum class Kind { torus, sphere, wave };

struct Tested {
    Kind kind;
    std::size_t rows, columns;
    gusset::Sheet sheet;
    Surface surface;
    double deviation = 0;
    Oracle oracle;

    Tested(Kind kind_, std::size_t rows_, std::size_t columns_, gusset::Sheet given)
        : kind(kind_), rows(rows_), columns(columns_), sheet(std::move(given)), surface(sheet), oracle(meshed(sheet, deviation)) {}
    bool is_closed() const { return kind != Kind::wave; }

private:
    static Oracle meshed(const gusset::Sheet &sheet, double &deviation) {
        gusset::SheetMeshOptions options;
        options.tolerance = mesh_tolerance;
        options.triangles = true;
        const gusset::SheetMesh mesh(sheet, options);
        deviation = mesh.deviation();
        return Oracle(mesh.mesh());
    }
};

Tested random_surface(Random &random) {
    const auto kind = static_cast<Kind>(random.below(3));
    const std::size_t rows = random.between(5, 16), columns = random.between(6, 20);
    const Waves waves(random, random.one_in(3) ? 0.0 : random.real(0.05, 0.5));
    gusset::NodesOptions options;
    options.scheme = random.one_in(3) ? gusset::Scheme::four_point : gusset::Scheme::six_tap;
    options.closed_u = kind == Kind::torus;
    options.closed_v = kind != Kind::wave;
    const auto nodes = shapes::nodes(rows, columns, options.closed_u, options.closed_v, [&](double u, double v) {
        switch (kind) {
        case Kind::torus: return waves(shapes::torus(u, v));
        // Poles to the bit.
        case Kind::sphere: return waves(u == 0 || u == 1 ? Point{0, 0, u == 0 ? 1.0 : -1.0} : shapes::sphere(u, v));
        default: return waves({2 * u - 1, 2 * v - 1, 0});
        }
    });
    return Tested(kind, rows, columns, gusset::Sheet::from_nodes(rows + 1, columns + 1, nodes, options));
}

Point random_point(Random &random, double half) { return {random.real(-half, half), random.real(-half, half), random.real(-half, half)}; }

void nearest(Case &test, const Tested &tested) {
    std::vector<Point> queries;
    for (int k = 0; k < 40; ++k) {
        // Half of them across the surface from a point of it, which soon has several minima.
        if (test.random.one_in(2)) {
            const auto foot = tested.surface.evaluate(gusset::surface_place(0, test.random.below(tested.rows), test.random.below(tested.columns)));
            queries.push_back(along(of(foot.point), of(foot.normal), test.random.real(-1.5, 1.5)));
        } else {
            queries.push_back(random_point(test.random, test.random.one_in(4) ? 8 : 1.7));
        }
    }
    const std::vector<gusset::NearestPoint> found = tested.surface.nearest(queries);
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const gusset::NearestPoint &own = found[k];
        if (!test.check(own.is_found(), "no nearest point is found")) {
            continue;
        }
        const double on_mesh = tested.oracle.distance(queries[k]);
        test.at_most(std::abs(distance(queries[k], of(own.point)) - own.distance), 1e-12, "the error of a distance");
        test.at_most(own.bound, own.distance, "the bound of a distance");
        test.at_most(own.distance, on_mesh + tested.deviation + rounding, "a distance, beside that from the mesh");
        test.at_most(on_mesh - tested.deviation - rounding, own.bound, "the distance from the mesh, beside the bound");
        if (own.is_proven()) {
            test.at_most(own.distance - own.bound, 1e-7, "what is open of a proven distance");
        }
        test.at_most(distance(of(tested.surface.evaluate(own.place).point), of(own.point)), 1e-12, "the distance of a point from its place");
        // A limit that is larger changes nothing, one that is smaller leaves nothing.
        gusset::NearestOptions options;
        options.limit = own.distance * 1.01 + rounding;
        test.check(tested.surface.nearest(queries[k], options).distance == own.distance, "a larger limit changes the nearest point");
        options.limit = own.bound * 0.99 - 1e-6;
        if (options.limit > 0) {
            test.check(!tested.surface.nearest(queries[k], options).is_found(), "a point is found beyond the limit");
        }
        if (k < 6) {
            const gusset::SurfacePoints minima = tested.surface.minima(queries[k]);
            if (test.check(!minima.empty(), "there is no local minimum")) {
                if (minima.size() > 1) {
                    test.note("queries with several minima");
                }
                test.at_most(std::abs(minima[0].distance - own.distance), 1e-8, "the distance between the first minimum and the nearest point");
            }
        }
    }
}

/// Intersections of the mesh with a line and with six lines around it. If each of the seven has exactly one near a
/// parameter, the mesh closes the tube between them, and so must any surface within the deviation.
struct Crossings {
    std::vector<double> shut;
    /// No other intersections exist.
    bool all = true;
};

Crossings certain_crossings(const Tested &tested, const Point &origin, const Point &direction) {
    // Six lines at this distance are nowhere nearer to the first one than 0.86 of it.
    const double radius = 4 * tested.deviation, reach = 25 * tested.deviation;
    const Point across = unit(cross(direction, std::abs(direction[0]) < 0.6 ? Point{1, 0, 0} : Point{0, 1, 0})), other = cross(direction, across);
    std::vector<std::vector<double>> lines{tested.oracle.crossings(origin, direction)};
    for (int k = 0; k < 6; ++k) {
        const double angle = 2 * M_PI * k / 6;
        lines.push_back(tested.oracle.crossings(along(along(origin, across, radius * std::cos(angle)), other, radius * std::sin(angle)), direction));
    }
    Crossings found;
    for (double t : lines[0]) {
        const bool shut = std::all_of(lines.begin(), lines.end(), [&](const std::vector<double> &line) {
            // Nothing else is near, by far.
            return std::count_if(line.begin(), line.end(), [&](double s) { return std::abs(s - t) < reach; }) == 1 &&
                   std::count_if(line.begin(), line.end(), [&](double s) { return std::abs(s - t) < 2 * reach; }) == 1;
        });
        shut ? found.shut.push_back(t) : void(found.all = false);
    }
    for (const auto &line : lines) {
        found.all = found.all && line.size() == found.shut.size();
    }
    return found;
}

void lines(Case &test, const Tested &tested) {
    std::vector<Line> lines;
    for (int k = 0; k < 30; ++k) {
        const Point from = random_point(test.random, 1.5), to = random_point(test.random, 1.5);
        lines.push_back(Line::line(from, unit(shapes::minus(to, from))));
    }
    const gusset::SurfaceHits hits = tested.surface.line_hits(lines);
    const std::vector<gusset::Hit> first = tested.surface.first_hits(lines);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const Point origin = of(lines[k].origin), direction = of(lines[k].direction);
        const gusset::Hits own = hits[k];
        for (const gusset::Hit &hit : own) {
            test.at_most(distance(of(hit.point), along(origin, direction, hit.t)), 1e-8, "the distance of a hit from its line");
            test.at_most(distance(of(tested.surface.evaluate(hit.place).point), of(hit.point)), 1e-8, "the distance of a hit from the surface");
            test.at_most(tested.oracle.distance(of(hit.point)), tested.deviation + 1e-8, "the distance of a hit from the mesh");
        }
        const bool sorted = std::is_sorted(own.begin(), own.end(), [](const gusset::Hit &a, const gusset::Hit &b) { return a.t < b.t; });
        test.check(sorted, "the hits of a line do not ascend");
        test.check(first[k].is_found() == (own.size() > 0) && (own.size() == 0 || first[k].t == own[0].t), "the first hit is another");
        const Crossings certain = certain_crossings(tested, origin, direction);
        for (double t : certain.shut) {
            const auto near = std::count_if(own.begin(), own.end(), [&](const gusset::Hit &hit) { return std::abs(hit.t - t) < 26 * tested.deviation; });
            test.check(near >= 1, "a line misses the surface where the mesh shuts it off");
        }
        if (certain.all) {
            test.note("lines whose crossings are certain");
            test.equal(own.size(), certain.shut.size(), "hits of a line");
        }
        const gusset::SurfaceDistance apart = tested.surface.distance(lines[k]);
        test.check(own.empty() || apart.meets(), "a line that meets the surface is at a distance");
        if (own.empty()) {
            for (int i = -20; i <= 20; ++i) {
                test.at_most(apart.bound, tested.oracle.distance(along(origin, direction, 0.1 * i)) + tested.deviation + rounding, "the distance of a line");
            }
        }
    }
}

/// Points of the surface in a plane: sign changes on a grid of places, by bisection.
std::vector<Point> points_in_plane(const Tested &tested, const Point &at, const Point &normal) {
    constexpr uint32_t parts = 4;
    const auto height = [&](const gusset::SurfacePoint &p) { return dot(shapes::minus(of(p.point), at), normal); };
    std::vector<SurfacePlace> low, high;
    std::vector<SurfacePlace> places;
    for (uint32_t i = 0; i < tested.rows; ++i) {
        for (uint32_t j = 0; j < tested.columns; ++j) {
            for (uint32_t k = 0; k < (parts + 1) * (parts + 1); ++k) {
                places.push_back(gusset::surface_place(0, i, j, double(k / (parts + 1)) / parts, double(k % (parts + 1)) / parts));
            }
        }
    }
    const auto points = tested.surface.evaluate(places);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const std::size_t place = k % ((parts + 1) * (parts + 1));
        for (std::size_t next : {place % (parts + 1) < parts ? k + 1 : k, place / (parts + 1) < parts ? k + parts + 1 : k}) {
            const double a = height(points[k]), b = height(points[next]);
            if ((a < 0) != (b < 0)) {
                low.push_back(places[a < 0 ? k : next]);
                high.push_back(places[a < 0 ? next : k]);
            }
        }
    }
    std::vector<SurfacePlace> middle = low;
    for (int step = 0; step < 50; ++step) {
        for (std::size_t k = 0; k < low.size(); ++k) {
            middle[k].u = (low[k].u + high[k].u) / 2;
            middle[k].v = (low[k].v + high[k].v) / 2;
        }
        const auto now = tested.surface.evaluate(middle);
        for (std::size_t k = 0; k < low.size(); ++k) {
            (height(now[k]) < 0 ? low : high)[k] = middle[k];
        }
    }
    std::vector<Point> found;
    for (const gusset::SurfacePoint &p : tested.surface.evaluate(middle)) {
        found.push_back(of(p.point));
    }
    return found;
}

void sections(Case &test, const Tested &tested) {
    for (int k = 0; k < 3; ++k) {
        const Point at = random_point(test.random, 0.7), normal = unit(random_point(test.random, 1));
        const double chord = 1e-4;
        gusset::ContourOptions options;
        options.chord = chord;
        const gusset::SurfacePaths paths = tested.surface.section(at, normal, options);
        std::vector<Slice> own;
        std::vector<Point> middles;
        for (const gusset::SurfacePath &path : paths) {
            own.push_back({path.closed, shapes::length(path)});
            test.check(path.closed || !tested.is_closed(), "a section of a closed surface is open");
            for (std::size_t i = 0; i < path.size(); ++i) {
                test.at_most(std::abs(dot(shapes::minus(path.points[i], at), normal)), 1e-10, "the distance of a section from its plane");
                test.at_most(distance(of(tested.surface.evaluate(path.places[i]).point), path.points[i]), 1e-8, "the distance of a section from the surface");
                const Point &next = path.points[(i + 1) % path.size()];
                if (path.closed || i + 1 < path.size()) {
                    middles.push_back(along(path.points[i], shapes::minus(next, path.points[i]), 0.5));
                }
            }
        }
        for (const gusset::NearestPoint &near : tested.surface.nearest(middles)) {
            test.at_most(near.distance, chord + rounding, "the distance of a chord from the surface");
        }
        if (!paths.unresolved().empty()) {
            test.note("sections with cells that are unresolved");
            continue;
        }
        for (const Point &p : points_in_plane(tested, at, normal)) {
            double nearest = 1e9;
            for (const gusset::SurfacePath &path : paths) {
                for (std::size_t i = path.closed ? 0 : 1; i < path.size(); ++i) {
                    nearest = std::min(nearest, from_segment(p, path.points[i == 0 ? path.size() - 1 : i - 1], path.points[i]));
                }
            }
            test.at_most(nearest, chord + rounding, "the distance of a point of surface and plane from all sections");
        }
        // If shifts by some deviations change no count, the counts of the mesh hold for the surface.
        std::vector<std::size_t> counts;
        for (double shift : {-3 * tested.deviation, 3 * tested.deviation}) {
            counts.push_back(tested.oracle.slices(along(at, normal, shift), normal).size());
            counts.push_back(tested.surface.section(along(at, normal, shift), normal).size());
        }
        const std::vector<Slice> slices = tested.oracle.slices(at, normal);
        if (std::any_of(counts.begin(), counts.end(), [&](std::size_t n) { return n != counts[0]; })) {
            test.note("sections near a change of their count");
            continue;
        }
        if (test.equal(own.size(), slices.size(), "sections")) {
            std::sort(own.begin(), own.end(), [](const Slice &a, const Slice &b) { return a.length > b.length; });
            for (std::size_t i = 0; i < own.size(); ++i) {
                test.check(own[i].closed == slices[i].closed, "a section is closed, and the mesh's is not, or the other way round");
                test.at_most(std::abs(own[i].length - slices[i].length), 0.02 * slices[i].length + 0.05, "the difference of the lengths of sections");
            }
        }
    }
}
} // namespace
} // namespace of_surfaces

void surfaces(Case &test) {
    using namespace of_surfaces;
    const Tested tested = random_surface(test.random);
    nearest(test, tested);
    lines(test, tested);
    sections(test, tested);
}
} // namespace campaign
