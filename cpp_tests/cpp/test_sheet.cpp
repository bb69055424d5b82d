// Sheets from C++: construction, properties, meshes, the paper's search.
#include "host.hpp"
#include "surfaces.hpp"

#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <type_traits>

namespace sheet_tests {

namespace {
using gusset::Surface;
using gusset::Curve;
using gusset::Point3;
using gusset::Sheet;
using shapes::distance;
using shapes::pi;

/// The points of a sheet at steps of its parameters.
std::vector<Point3> sampled(const Sheet &sheet, double step = 0.3) {
    const Surface surface(sheet);
    std::vector<Point3> found;
    for (double u = 0; u <= double(sheet.rows()); u += step) {
        for (double v = 0; v <= double(sheet.columns()); v += step) {
            found.push_back(shapes::of(surface.evaluate(surface.locate(0, u, v)).point));
        }
    }
    return found;
}

double largest_gap(const std::vector<Point3> &a, const std::vector<Point3> &b) {
    REQUIRE(a.size() == b.size());
    double gap = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        gap = std::max(gap, distance(a[k], b[k]));
    }
    return gap;
}

template <class Points, class = void>
struct Borrows : std::false_type {};
template <class Points>
struct Borrows<Points, std::void_t<decltype(Sheet::borrow(4, 4, std::declval<Points>()))>> : std::true_type {};
// Only what stays can be borrowed.
static_assert(Borrows<std::vector<Point3> &>::value, "a variable");
static_assert(Borrows<const std::vector<Point3> &>::value, "a constant");
static_assert(!Borrows<std::vector<Point3>>::value, "a temporary");
static_assert(!Borrows<const std::vector<Point3>>::value, "a constant temporary");
static_assert(Borrows<gusset::Span<const Point3>>::value && Borrows<gusset::Span<Point3>>::value, "spans own nothing");

// A single number is not a mask: the caller says all cells, no cells, or the cells of words.
static_assert(!std::is_constructible_v<gusset::CellMask, std::size_t, std::size_t, bool>, "all or none by name");
static_assert(!std::is_constructible_v<gusset::CellMask, std::size_t, std::size_t, std::vector<uint64_t>>, "words by name");
template <class T, class = void>
struct Braced : std::false_type {};
template <class T>
struct Braced<T, std::void_t<decltype(T(1, 4, {1}))>> : std::true_type {};
static_assert(!Braced<gusset::CellMask>::value, "neither");
} // namespace

TEST_CASE("nodes in any memory make the same sheet") {
    const std::vector<Point3> nodes = shapes::nodes(9, 12, false, true, shapes::torus);
    gusset::NodesOptions options;
    options.closed_v = true;
    const std::vector<Point3> expected = sampled(Sheet::from_nodes(10, 13, nodes, options));
    CHECK(largest_gap(expected, sampled(Sheet::borrow(10, 13, nodes, options))) == 0);
    const gusset::Span<const Point3> lent(nodes.data(), nodes.size());
    CHECK(largest_gap(expected, sampled(Sheet::borrow(10, 13, lent, options))) == 0);
    CHECK(largest_gap(expected, sampled(Sheet::borrow(10, 13, gusset::Span<const Point3>(nodes.data(), nodes.size()), options))) == 0);

    // Columns of nodes one after the other, with a number between nodes.
    std::vector<double> loose(10 * 13 * 4, -7.0);
    for (std::size_t i = 0; i < 10; ++i) {
        for (std::size_t j = 0; j < 13; ++j) {
            std::copy(nodes[i * 13 + j].begin(), nodes[i * 13 + j].end(), &loose[(i * 13 + j) * 4]);
        }
    }
    CHECK(largest_gap(expected, sampled(Sheet::from_nodes(gusset::NodesView::strided(10, 13, loose.data(), 52, 4, options)))) == 0);
    CHECK(largest_gap(expected, sampled(Sheet::borrow(10, 13, loose.data(), 52, 4, options))) == 0);

    std::vector<std::array<float, 4>> small;
    for (const Point3 &p : nodes) {
        small.push_back({float(p[0]), float(p[1]), float(p[2]), 0.0f});
    }
    CHECK(largest_gap(expected, sampled(Sheet::from_nodes(10, 13, small, options))) < 2e-7);

    const gusset_sheet_report info = Sheet::from_nodes(10, 13, nodes, options).report();
    CHECK(info.rows == 9);
    CHECK(info.columns == 12);
    CHECK(info.closed_u == 0);
    CHECK(info.closed_v == 1);
    CHECK(info.is_grid == 1);
    options.scheme = gusset::Scheme::four_point;
    const double other = largest_gap(expected, sampled(Sheet::from_nodes(10, 13, nodes, options)));
    CHECK(other > 1e-5);
    CHECK(other < 1e-2);
    CHECK_THROWS_AS(Sheet::from_nodes(10, 12, nodes), gusset::Error);
}

TEST_CASE("tangents, patches and splines") {
    const std::size_t rows = 24, columns = 40;
    const std::vector<Point3> nodes = shapes::nodes(rows, columns, true, true, shapes::torus);
    const double du = 2 * pi / double(rows), dv = 2 * pi / double(columns);
    std::vector<Point3> u, v, twists;
    for (std::size_t i = 0; i <= rows; ++i) {
        for (std::size_t j = 0; j <= columns; ++j) {
            const double a = du * double(i % rows), b = dv * double(j % columns), ring = 1 + 0.4 * std::cos(a), in = -0.4 * std::sin(a);
            u.push_back({du * in * std::cos(b), -du * in * std::sin(b), du * 0.4 * std::cos(a)});
            v.push_back({-dv * ring * std::sin(b), -dv * ring * std::cos(b), 0});
            twists.push_back({-du * dv * in * std::sin(b), -du * dv * in * std::cos(b), 0});
        }
    }
    const gusset::NodesView view(rows + 1, columns + 1, nodes, shapes::closed(true, true));
    const auto worst = [](const Sheet &sheet) {
        double most = 0;
        for (const Point3 &p : sampled(sheet)) {
            most = std::max(most, std::abs(shapes::outside_torus(p)));
        }
        return most;
    };
    // The error of Hermite's bicubic is h^4 / 384 of each direction's fourth derivative.
    CHECK(worst(Sheet::from_tangents(view, u, v, twists)) < 1e-5);
    CHECK(worst(Sheet::from_tangents(view, u, v)) < 1e-5);
    CHECK(worst(Sheet::from_tangents(view, u, v, gusset::Twists::adini)) < 2e-4);
    CHECK(worst(Sheet::from_tangents(view, u, v, gusset::Twists::zero)) < 5e-3);
    CHECK(worst(Sheet::from_nodes(view)) < 1e-4);
    u.pop_back();
    CHECK_THROWS_AS(Sheet::from_tangents(view, u, v), gusset::Error);

    // A saddle z = x y, as a patch and as a spline of one span.
    const std::vector<Point3> corners{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}};
    const Sheet patch = Sheet::from_patches(corners, 1, 1, 1, 1);
    for (const Point3 &p : sampled(patch, 0.125)) {
        CHECK(std::abs(p[2] - p[0] * p[1]) < 1e-15);
    }
    const std::vector<double> knots{0, 0, 1, 1};
    const Sheet spline = Sheet::from_spline(corners, {2, 1, knots}, {2, 1, knots});
    CHECK(largest_gap(sampled(patch, 0.125), sampled(spline, 0.125)) < 1e-15);
    CHECK(patch.report().is_grid == 0);
    CHECK(spline.crease() < 1e-7);
    CHECK_THROWS_AS(Sheet::from_patches(corners, 1, 1, 2, 1), gusset::Error);
    CHECK_THROWS_AS(Sheet::from_spline(corners, {2, 1, knots}, {3, 1, knots}), gusset::Error);
    CHECK(spline.knots(false).size() == 2);
    CHECK(patch.knots(true).empty());
}

TEST_CASE("rational splines") {
    // A quarter of a cylinder of radius 1 and height 2: a circle in v.
    const std::vector<Point3> points{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}};
    const double half = std::sqrt(0.5);
    const std::vector<double> weights{1, half, 1, 1, half, 1}, line{0, 0, 1, 1}, arc{0, 0, 0, 1, 1, 1};
    const gusset::SplineAxis u{2, 1, line}, v{3, 2, arc};
    for (const double tolerance : {0.0, 1e-9, 1e-5}) {
        gusset::SplineOptions options;
        options.tolerance = tolerance;
        const Sheet sheet = Sheet::from_spline(points, weights, u, v, options);
        const double deviation = sheet.report().deviation;
        CHECK(deviation > 0);
        CHECK(deviation <= (tolerance == 0 ? 3e-12 : tolerance));
        for (const Point3 &p : sampled(sheet, 0.125)) {
            CHECK(std::abs(std::hypot(p[0], p[1]) - 1) <= deviation + 1e-15);
        }
        CHECK(sheet.knots(false).size() == 2);
        CHECK(sheet.knots(true).size() == sheet.columns() + 1);
        CHECK(sheet.knots(true)[sheet.columns()] == 1);
    }
    CHECK_THROWS_AS(Sheet::from_spline(points, arc, v, u), gusset::Error);
    CHECK_THROWS_AS(Sheet::from_spline(points, line, u, v), gusset::Error);
    gusset::SplineOptions few;
    few.tolerance = 1e-9;
    few.max_cells = 1;
    CHECK_THROWS_AS(Sheet::from_spline(points, weights, u, v, few), gusset::Error);
}

TEST_CASE("curves and frames") {
    // The four sides of the saddle: Coons's patch is the saddle itself. A row runs in v.
    const auto straight = [](const Point3 &a, const Point3 &b) {
        const std::array<Point3, 2> ends{a, b};
        return Curve::through(ends, false);
    };
    std::vector<Curve> rows, columns;
    rows.push_back(straight({0, 0, 0}, {0, 1, 0}));
    rows.push_back(straight({1, 0, 0}, {1, 1, 1}));
    columns.push_back(straight({0, 0, 0}, {1, 0, 0}));
    columns.push_back(straight({0, 1, 0}, {1, 1, 1}));
    for (const Point3 &p : sampled(Sheet::from_curves(rows, columns), 0.1)) {
        CHECK(std::abs(p[2] - p[0] * p[1]) < 1e-14);
    }
    for (const Point3 &p : sampled(Sheet::from_curves(rows, {}), 0.1)) {
        CHECK(std::abs(p[2] - p[0] * p[1]) < 1e-14); // The skin of two rulings.
    }
    // Curves that do not meet.
    columns[1] = straight({0, 1, 0.5}, {1, 1, 1});
    try {
        Sheet::from_curves(rows, columns);
        FAIL("accepted");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_CURVES_APART);
    }

    // A tube of outlines: circles of eight points in rising planes.
    std::vector<Point3> sections;
    std::vector<uint32_t> offsets{0};
    for (int k = 0; k < 6; ++k) {
        for (int i = 0; i < 8; ++i) {
            const double t = 2 * pi * i / 8;
            sections.push_back({std::cos(t), std::sin(t), 0.5 * k});
        }
        offsets.push_back(uint32_t(sections.size()));
    }
    const gusset::Frame frame(gusset::Outlines(sections, true).offsets(offsets));
    for (const gusset::FrameSurface kind :
         {gusset::FrameSurface::sections, gusset::FrameSurface::nodes, gusset::FrameSurface::curves}) {
        const Sheet tube = Sheet::from_frame(frame, kind);
        CHECK(tube.report().closed_v == 1);
        for (const Point3 &p : sampled(tube, 0.37)) {
            CHECK(std::abs(std::hypot(p[0], p[1]) - 1) < 0.03);
        }
    }
}

TEST_CASE("curves through points, on sheets, and near to each other") {
    const Sheet sheet = shapes::torus_sheet();
    const Surface surface(sheet);
    for (const gusset::SheetDirection along : {gusset::SheetDirection::rows, gusset::SheetDirection::columns}) {
        const Curve curve = sheet.curve(along, 7.3);
        const gusset::Places places = curve.sample(gusset::SampleRule::count, 50);
        const std::vector<Point3> points(places.points().begin(), places.points().end());
        for (const gusset::NearestPoint &nearest : surface.nearest(points)) {
            CHECK(nearest.distance < 1e-12);
        }
    }
    CHECK_THROWS_AS(sheet.curve(gusset::SheetDirection::rows, 25), gusset::Error);

    std::vector<Point3> circle;
    for (int k = 0; k <= 24; ++k) {
        circle.push_back({std::cos(2 * pi * (k % 24) / 24), std::sin(2 * pi * (k % 24) / 24), 0});
    }
    const Curve ring = Curve::through(circle, true);
    CHECK(ring.is_closed());
    CHECK(std::abs(ring.length() - 2 * pi) < 1e-4);
    // The axis of the ring is as near everywhere; a line beside it is nearest at one place, and one
    // in space passes two.
    const gusset::Places met = ring.intersect_line(gusset::Line::line({-2, 0.5, 0.01}, {1, 0, 0}), 0.05);
    REQUIRE(met.size() == 2);
    CHECK(std::abs(met.points()[0][1] - 0.5) < 1e-4);
    CHECK(ring.intersect_line(gusset::Line::line({-2, 0.5, 0.1}, {1, 0, 0}), 0.05).size() == 0);
    const std::array<Point3, 2> bar{{{-2, 0, 0.01}, {2, 0, 0.01}}};
    const gusset::Places both = ring.intersect(Curve::through(bar, false), 0.05);
    REQUIRE(both.size() == 2);
    CHECK(both.others().size() == 2);
}

TEST_CASE("meshes of sheets are closed where the surface is") {
    const auto check = [](const Sheet &sheet, long euler, const gusset::SheetMeshOptions &options) {
        const gusset::SheetMesh made(sheet, options);
        const Soup soup = copy_of(made.mesh());
        const std::optional<HostMesh> mesh = host_mesh(soup);
        REQUIRE(mesh);
        CHECK(walks(*mesh).empty());
        CHECK(long(mesh->n_vertices()) - long(mesh->n_edges()) + long(mesh->n_faces()) == euler);
        // Vertices are on the surface, with its normals; the middles of faces are within the stated
        // deviation.
        const Surface surface(sheet);
        const std::vector<gusset::SurfacePoint> at = surface.evaluate(made.places());
        std::vector<Point3> middles;
        for (std::size_t v = 0; v < at.size(); ++v) {
            REQUIRE(distance(shapes::of(at[v].point), made.mesh().position(v)) < 1e-14);
            REQUIRE(distance(shapes::of(at[v].normal), made.normals()[v]) < 1e-12);
        }
        for (std::size_t f = 0; f < made.mesh().face_count(); ++f) {
            const gusset::Indices face = made.mesh().face(f);
            Point3 middle{};
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t i = 0; i < 3; ++i) {
                    middle[i] += made.mesh().position(face[k])[i] / 3;
                }
            }
            middles.push_back(middle);
        }
        CHECK(made.deviation() > 0);
        for (const gusset::NearestPoint &nearest : surface.nearest(middles)) {
            REQUIRE(nearest.bound <= made.deviation());
        }
    };
    gusset::SheetMeshOptions fine;
    fine.tolerance = 2e-3;
    fine.triangles = true;
    check(shapes::torus_sheet(), 0, {});
    check(shapes::torus_sheet(), 0, fine);
    check(shapes::sphere_sheet(), 2, {});
    check(shapes::sphere_sheet(), 2, fine);
    CHECK(gusset::SheetMesh(shapes::torus_sheet(), fine).deviation() <= 2e-3);
}

TEST_CASE("estimates, and the paper's search") {
    const Sheet sheet = shapes::torus_sheet();
    const gusset::SheetEstimates estimates = sheet.estimates();
    REQUIRE(estimates.errors.size() == 24 * 40);
    double worst = 0;
    for (const Point3 &p : sampled(sheet)) {
        worst = std::max(worst, std::abs(shapes::outside_torus(p)));
    }
    const double estimated = *std::max_element(estimates.errors.begin(), estimates.errors.end());
    CHECK(worst < 2 * estimated);
    CHECK(worst > 0.1 * estimated);
    CHECK(*std::max_element(estimates.bilinear.begin(), estimates.bilinear.end()) < 0.02);
    CHECK(sheet.crease() < 1e-6);
    CHECK(Sheet::from_nodes(25, 41, shapes::nodes(24, 40, true, true, shapes::torus), shapes::closed(true, true, gusset::Scheme::four_point)).crease() > 1e-4);

    // The smaller radius is 0.4: principal curvatures are at most 2.5.
    const double curvature = sheet.curvature_bound();
    CHECK(curvature >= 2.49);
    CHECK(curvature < 10);
    const gusset::CellDiameters diameters = sheet.diameters();
    REQUIRE(diameters.euclidean.size() == 24 * 40);
    CHECK(diameters.max_euclidean >= std::hypot(1.4 * 2 * std::sin(pi / 40), 0.8 * std::sin(pi / 24)) - 1e-3);
    for (std::size_t k = 0; k < diameters.euclidean.size(); ++k) {
        REQUIRE(diameters.euclidean[k] <= diameters.intrinsic[k] * (1 + 1e-12));
    }

    // Every cell that has a point within 0.3 of a point is in the mask.
    const Point3 query{1.5, 0.2, 0.1};
    const gusset::ReferenceTask task = gusset::ReferenceTask::at(query);
    CHECK(shapes::of(task.point) == query);
    const gusset::ReferenceMask masked = sheet.reference_mask(gusset::ReferenceTask::at(query).up_to(0.3));
    const Surface surface(sheet);
    std::size_t near = 0;
    for (std::size_t i = 0; i < 24; ++i) {
        for (std::size_t j = 0; j < 40; ++j) {
            const gusset::SurfacePlace middle = gusset::surface_place(0, uint32_t(i), uint32_t(j));
            if (distance(shapes::of(surface.evaluate(middle).point), query) < 0.3) {
                ++near;
                CHECK(masked.mask(i, j));
            }
        }
    }
    CHECK(near > 5);
    CHECK(masked.mask.count() >= near);
    CHECK(masked.mask.count() < 200);
    CHECK(masked.report.cells == masked.mask.count());
    const gusset::NearestPoint nearest = surface.nearest(query);
    CHECK(sheet.reference_mask(gusset::ReferenceTask::at(query)).mask(nearest.place.row, nearest.place.column));
    CHECK(sheet.reference_mask(gusset::ReferenceTask::plane({2, 0, 0}, {1, 0, 0}).up_to(0.1)).mask.count() == 0);
    CHECK(sheet.reference_mask(gusset::ReferenceTask::line({0, 0, 0}, {1, 0, 0}).up_to(0.01)).mask.count() > 0);
    CHECK(sheet.reference_mask(gusset::ReferenceTask::segment({0, 0, 0}, {0.1, 0, 0}).up_to(0.01)).mask.count() == 0);
    CHECK(sheet.reference_mask(gusset::ReferenceTask::angle_to({0, 0, 1}, 0.0).up_to(0.05)).mask.count() > 0);

    const Curve row = sheet.curve(gusset::SheetDirection::rows, 0.0);
    CHECK(sheet.reference_mask(gusset::ReferenceTask::curve_of(row).up_to(0.0)).mask(0, 7));
    CHECK(sheet.reference_mask(gusset::ReferenceTask::surface_of(surface).up_to(0.0)).mask.count() == 24 * 40);
    CHECK(sheet.reference_mask(gusset::ReferenceTask::ray({0, 0, 0}, {1, 0, 0}).up_to(0.01)).mask.count() > 0);
    const gusset::ReferenceMask arcs = gusset::reference_mask(row, 2, gusset::ReferenceTask::at(query));
    CHECK(arcs.mask.columns() == 80);
    CHECK(arcs.mask.count() > 0);
    CHECK(arcs.mask.count() < 40);
    CHECK(sheet.mask_cells(masked.mask).size() == masked.mask.count());
    CHECK(sheet.mask_nodes(masked.mask).size() > masked.mask.count());
    CHECK(row.tangents_at_angle({0, 0, 1}, 0.0).size() == 0);

    const gusset_mask_report region = sheet.mask_measure(masked.mask);
    CHECK(region.cells == masked.mask.count());
    CHECK(region.euler == 1);
    CHECK(sheet.mask_measure(gusset::CellMask::all(24, 40)).euler == 0);
    // Round the ring it is 10 steps across corners, if not less the other way.
    const auto chain = sheet.mask_chain(gusset::CellMask::all(24, 40), {3, 2}, {3, 12});
    CHECK(chain.size() == 11);
    CHECK(chain.front() == std::array<uint32_t, 2>{3, 2});
    CHECK(chain.back() == std::array<uint32_t, 2>{3, 12});
    // Masks of other shapes, be they larger, smaller or turned.
    for (const std::array<std::size_t, 2> &shape : {std::array<std::size_t, 2>{48, 80}, {12, 20}, {40, 24}, {24, 41}}) {
        const gusset::CellMask other = gusset::CellMask::all(shape[0], shape[1]);
        CHECK_THROWS_AS(sheet.mask_measure(other), gusset::Error);
        CHECK_THROWS_AS(sheet.mask_chain(other, {3, 2}, {3, 12}), gusset::Error);
    }

    const std::vector<gusset::SurfacePlace> places{gusset::surface_place(0, 4, 5, 0.3, 0.6), gusset::surface_place(0, 20, 33, 0.9, 0.1)};
    const std::vector<Point3> normals = sheet.normals_by_sections(places);
    for (std::size_t k = 0; k < places.size(); ++k) {
        CHECK(distance(normals[k], shapes::of(surface.evaluate(places[k]).normal)) < 1e-2);
    }
}

TEST_CASE("masks are made by name") {
    using gusset::CellMask;
    CHECK(CellMask::from_words(1, 4, {1}).count() == 1);
    CHECK(CellMask::from_words(1, 4, {1})(0, 0));
    CHECK_FALSE(CellMask::from_words(1, 4, {1})(0, 1));
    // Bits beyond the last cell are dropped.
    CHECK(CellMask::from_words(1, 4, {~uint64_t{0}, 5}).count() == 4);
    CHECK(CellMask::all(9, 13).count() == 9 * 13);
    CHECK(CellMask::all(8, 16).count() == 8 * 16);
    CHECK(CellMask::none(9, 13).count() == 0);
    CHECK(CellMask::all(0, 5).count() == 0);
    CHECK_THROWS_AS(CellMask::from_words(9, 13, {1}), gusset::Error);
    CHECK_THROWS_AS(CellMask::all(std::size_t{1} << 40, std::size_t{1} << 40), gusset::Error);
    CellMask mask = CellMask::none(3, 50);
    mask.set(2, 49, true);
    CHECK(mask(2, 49));
    CHECK(mask.count() == 1);
    mask.set(2, 49, false);
    CHECK(mask.count() == 0);
}

TEST_CASE("bad sheets say what is bad") {
    std::vector<Point3> nodes = shapes::nodes(5, 6, false, false, shapes::wave);
    nodes[17][1] = std::numeric_limits<double>::quiet_NaN();
    try {
        Sheet::from_nodes(6, 7, nodes);
        FAIL("accepted");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_NOT_FINITE);
        CHECK(error.report().index == 17);
    }
    try {
        Sheet::from_nodes(1, 7, std::vector<Point3>(7));
        FAIL("accepted");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_NET_TOO_SMALL);
    }
    const std::vector<Point3> open = shapes::nodes(5, 6, false, false, shapes::wave);
    CHECK_THROWS_AS(Sheet::from_nodes(6, 7, open, shapes::closed(true, false)), gusset::Error);
    // Degrees beyond 1 to 7, and those for which the number of control points wraps to 0.
    const Point3 origin{};
    for (const std::array<uint32_t, 2> degrees : {std::array<uint32_t, 2>{0, 1}, {1, 8}, {8, 8}, {0xffffffffu, 1}, {0xffffffffu, 0xffffffffu}}) {
        CHECK_THROWS_AS(Sheet::from_patches({&origin, 1}, degrees[0], degrees[1], 1, 1), gusset::Error);
        CHECK_THROWS_AS(Sheet::from_patches({}, degrees[0], degrees[1], 0, 0), gusset::Error);
    }
    const std::vector<double> knots{0, 0, 2, 1};
    const std::vector<Point3> corners{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}};
    try {
        Sheet::from_spline(corners, {2, 1, knots}, {2, 1, knots});
        FAIL("accepted");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_BAD_KNOTS);
    }
}

} // namespace sheet_tests
