// Leus, "Carcasses on smooth surfaces": figures 1 to 4.
#include "figure.hpp"

#include <numeric>

namespace figures {
namespace {
using gusset::CellMask;
using gusset::Sheet;
using gusset::SheetDirection;
using gusset::Surface;

constexpr Colour pale{214, 222, 230}, taken{240, 214, 160};

/// A sheet through heights over a rectangle: u runs along x and v along y, so that normals point up.
Sheet sheet_of(std::size_t rows, std::size_t columns, double width, double depth,
               const std::function<double(double, double)> &height) {
    std::vector<Point3> nodes;
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            const double x = width * (static_cast<double>(i) / static_cast<double>(rows - 1) - 0.5);
            const double y = depth * (static_cast<double>(j) / static_cast<double>(columns - 1) - 0.5);
            nodes.push_back({x, y, height(x, y)});
        }
    }
    return Sheet::from_nodes(rows, columns, nodes);
}

/// The cells of a sheet, each in the colour that it is given, or left out; and the curves of the carcass.
void carcass(Figure &figure, const Sheet &sheet, uint32_t parts,
             const std::function<const Colour *(std::size_t, std::size_t)> &colour_of, bool curves = true) {
    gusset::SheetMeshOptions options;
    options.min_u = options.min_v = parts;
    const gusset::SheetMesh mesh(sheet, options);
    std::vector<Point3> points;
    std::vector<uint32_t> corners;
    std::vector<Colour> colours;
    for (std::size_t v = 0; v < mesh.mesh().vertex_count(); ++v) {
        points.push_back(mesh.mesh().position(v));
    }
    for (std::size_t f = 0; f < mesh.mesh().face_count(); ++f) {
        double u = 0, v = 0;
        for (const uint32_t c : mesh.mesh().face(f)) {
            u += (mesh.places()[c].row + mesh.places()[c].u) / 4,
                v += (mesh.places()[c].column + mesh.places()[c].v) / 4;
        }
        if (const Colour *colour = colour_of(static_cast<std::size_t>(u), static_cast<std::size_t>(v))) {
            corners.insert(corners.end(), mesh.mesh().face(f).begin(), mesh.mesh().face(f).end());
            colours.push_back(*colour);
        }
    }
    figure.mesh(gusset::MeshView::uniform(points, corners, 4), [&](std::size_t f) { return colours[f]; });
    const auto draw = [&](SheetDirection along, std::size_t count) {
        for (std::size_t k = 0; curves && k <= count; ++k) {
            const auto sampled = sheet.curve(along, static_cast<double>(k)).sample(gusset::SampleRule::count, 30);
            figure.curve({sampled.points().begin(), sampled.points().end()}, false, ink, 1.3, 0.25);
        }
    };
    draw(SheetDirection::rows, sheet.rows());
    draw(SheetDirection::columns, sheet.columns());
    figure.flush();
}

std::vector<Spot> seen(const Figure &figure, gusset::Points points) {
    std::vector<Spot> spots;
    for (const Point3 &p : points) {
        spots.push_back(figure.at(p));
    }
    return spots;
}

double length_of(gusset::Points points) {
    double length = 0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const Point3 step = pictures::minus(points[k + 1], points[k]);
        length += std::sqrt(pictures::dot(step, step));
    }
    return length;
}

/// The farthest that points are from a surface.
double off(const Surface &surface, const std::vector<Point3> &points) {
    double farthest = 0;
    for (const gusset::NearestPoint &found : surface.nearest(points)) {
        farthest = std::max(farthest, found.distance);
    }
    return farthest;
}

/// A part of a plane that holds the vertical, from one place to another, up to a height.
void plane(Figure &figure, const Point3 &from, const Point3 &to, double low, double high) {
    figure.area({figure.at({from[0], from[1], low}), figure.at({to[0], to[1], low}), figure.at({to[0], to[1], high}),
                 figure.at({from[0], from[1], high})},
                violet, 0.2, {violet, 1, ""});
}

/// Fig. 1: the chord of a cell beside the section; the better curve through four crossings; a normal by two sections.
std::string sections(const std::string &file) {
    // Part of an ellipsoid, whose lines are about evenly spaced: there the curve is of the fourth order.
    std::vector<Point3> nodes;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            const double a = 0.6 * (i - 1.5), b = 0.6 * (j - 1.5);
            nodes.push_back({1.4 * std::sin(a) * std::cos(b), 1.1 * std::sin(b), 1.5 * std::cos(a) * std::cos(b)});
        }
    }
    const Sheet sheet = Sheet::from_nodes(4, 4, nodes);
    const Surface surface(sheet);
    const Point3 on{0, 0.06, 0}, along{1, 0.12, 0}, normal{-0.12, 1, 0};
    gusset::ContourOptions edges, nine;
    edges.spacing = gusset::SpacingRule::cell_edges;
    nine.points = 9;
    const auto section = surface.section(on, normal), crossings = surface.section(on, normal, edges),
               cubic = surface.section(on, normal, nine);
    const gusset::Points four = crossings[0].points;
    // A and B are where the plane enters and leaves the cell in the middle.
    const Point3 a = four[1], b = four[2];
    std::vector<Point3> chord;
    for (int k = 0; k <= 20; ++k) {
        const double t = k / 20.0;
        chord.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
    }
    std::vector<Point3> inner, better;
    const double low = std::min(a[0], b[0]), high = std::max(a[0], b[0]);
    for (const auto &[path, made] : {std::pair(section[0], &inner), std::pair(cubic[0], &better)}) {
        for (const Point3 &p : path.points) {
            if (p[0] >= low && p[0] <= high) {
                made->push_back(p);
            }
        }
    }

    Figure figure(960, 340, {0.25, -1, 0.5}, 300);
    const auto end = [&](double s) { return Point3{on[0] + s * along[0], on[1] + s * along[1], 0}; };
    const auto middle = [](std::size_t i, std::size_t j) { return i == 1 && j == 1 ? &pale : nullptr; };
    figure.place(165, 515);
    carcass(figure, sheet, 6, middle, false);
    plane(figure, end(-0.52), end(0.52), 1.15, 1.65);
    const auto border = [&] {
        for (const double k : {1.0, 2.0}) {
            for (const auto direction : {SheetDirection::rows, SheetDirection::columns}) {
                const gusset::Curve side = sheet.curve(direction, k).part(gusset::place(1, 0), gusset::place(1, 1));
                const auto sampled = side.sample(gusset::SampleRule::count, 20);
                figure.line(seen(figure, sampled.points()), {ink, 2, ""});
            }
        }
    };
    border();
    figure.line(seen(figure, inner), {blue, 2.5, ""});
    figure.line({figure.at(a), figure.at(b)}, {red, 2, "6 4"});
    for (const auto &[p, name] : {std::pair(a, "A"), std::pair(b, "B")}) {
        figure.dot(figure.at(p), 4, paper, red, 1.5);
        figure.label({figure.at(p)[0] + (p[0] < 0 ? -14 : 14), figure.at(p)[1] + 18}, name, "middle", 16, red);
    }
    figure.label({figure.at(end(0.52))[0] - 12, figure.at({end(0.52)[0], end(0.52)[1], 1.65})[1] + 20}, "P", "middle",
                 16, violet);
    figure.label({160, 322}, "а: chord and section");

    // From higher up, so that all four curves are in view, with the part of the plane above the surface.
    figure.look({0.25, -1, 0.85}, 125);
    figure.place(485, 268);
    carcass(figure, sheet, 4, [](std::size_t i, std::size_t j) { return i == 1 && j == 1 ? &taken : &pale; });
    const gusset::Points along_plane = section[0].points;
    std::vector<Spot> above = seen(figure, along_plane);
    for (const Point3 &p : {along_plane[along_plane.size() - 1], along_plane[0]}) {
        above.push_back(figure.at({p[0], p[1], 1.75}));
    }
    figure.area(above, violet, 0.2, {violet, 1, ""});
    figure.label({above.back()[0] + (above.back()[0] < 485 ? 14 : -14), above.back()[1] + 20}, "P", "middle", 16,
                 violet);
    figure.line(seen(figure, section[0].points), {blue, 2, ""});
    figure.line(seen(figure, cubic[0].points), {green, 4.5, "0.1 8"});
    figure.line(seen(figure, four), {red, 1.8, "6 4"});
    for (std::size_t k = 0; k < four.size(); ++k) {
        const Spot spot = figure.at(four[k]);
        figure.dot(spot, 4, paper, red, 1.5);
        if (k == 1 || k == 2) {
            figure.label({spot[0] + 4, spot[1] + 22}, (k == 1) == (a[0] < b[0]) ? "A" : "B", "middle", 15, red);
        }
    }
    figure.label({485, 322}, "б: the cubic (dots) by four curves");

    // Two planes across each other through a point of the cell, parallel to b, the mean of the normals at the corners.
    const gusset::SurfacePlace place = gusset::surface_place(0, 1, 1, 0.6, 0.45);
    const gusset::SurfacePoint exact = surface.evaluate(place);
    const Point3 at{exact.point[0], exact.point[1], exact.point[2]},
        true_normal{exact.normal[0], exact.normal[1], exact.normal[2]};
    const Point3 found = sheet.normals_by_sections({&place, 1})[0];
    const double sign = pictures::dot(found, true_normal) < 0 ? -1 : 1;
    Point3 sum{};
    for (const double u : {0.0, 1.0}) {
        for (const double v : {0.0, 1.0}) {
            const gusset::SurfacePoint corner = surface.evaluate(gusset::surface_place(0, 1, 1, u, v));
            for (std::size_t k = 0; k < 3; ++k) {
                sum[k] += corner.normal[k];
            }
        }
    }
    const Point3 mean = pictures::unit(sum);
    const gusset::SurfacePoint centre = surface.evaluate(gusset::surface_place(0, 1, 1, 0.5, 0.5));
    const Point3 across = pictures::unit(pictures::cross(mean, {centre.u[0], centre.u[1], centre.u[2]})),
                 other = pictures::cross(mean, across);
    figure.look({0.85, -1, 0.6}, 260);
    figure.place(800, 520);
    carcass(figure, sheet, 6, middle, false);
    border();
    for (const auto &[cut, name, colour] : {std::tuple(across, "P_1", violet), std::tuple(other, "P_2", ochre)}) {
        const auto two = surface.section(at, cut);
        std::vector<Point3> near;
        for (const Point3 &p : two[0].points) {
            if (std::abs(p[0]) < 0.4 && std::abs(p[1]) < 0.3) {
                near.push_back(p);
            }
        }
        std::vector<Spot> above_cell = seen(figure, near);
        for (const Point3 &p : {near.back(), near.front()}) {
            above_cell.push_back(figure.at({p[0] + 0.22 * mean[0], p[1] + 0.22 * mean[1], p[2] + 0.22 * mean[2]}));
        }
        figure.area(above_cell, colour, 0.2, {colour, 1, ""});
        figure.line(seen(figure, near), {blue, 2.2, ""});
        const Point3 tangent = pictures::cross(true_normal, cut);
        const auto tip = [&](double s) {
            return Point3{at[0] + s * tangent[0], at[1] + s * tangent[1], at[2] + s * tangent[2]};
        };
        figure.arrow(figure.at(at), figure.at(tip(0.25)), {green, 2, ""});
        // At the upper corner that is farther aside.
        const Spot foot = figure.at(at), &one = above_cell[near.size()], &two_tip = above_cell[near.size() + 1];
        const Spot &tip_of_plane = std::abs(one[0] - foot[0]) > std::abs(two_tip[0] - foot[0]) ? one : two_tip;
        figure.label({tip_of_plane[0] + (tip_of_plane[0] < foot[0] ? -14 : 14), tip_of_plane[1] + 6}, name, "middle",
                     15, colour);
    }
    figure.arrow(
        figure.at(at),
        figure.at({at[0] + 0.35 * sign * found[0], at[1] + 0.35 * sign * found[1], at[2] + 0.35 * sign * found[2]}),
        {red, 2.5, ""}, 12);
    figure.dot(figure.at(at), 4, paper, red, 1.5);
    figure.label({810, 322}, "в: a normal by two sections");
    figure.save(file);
    const double cosine = std::min(1.0, sign * pictures::dot(found, true_normal));
    return "the chord is " + places(off(surface, chord), 4) + " off, the curve through four crossings " +
           places(off(surface, better), 4) + "; the normal " + places(std::acos(cosine) * 180 / 3.141592653589793, 3) +
           " degrees";
}

/// Fig. 2: a carcass of m x n cells and a region of cells, hatched; the longest of its shortest chains is dotted.
std::string regions(const std::string &file) {
    const Sheet sheet = sheet_of(
        8, 6, 5, 3.2, [](double x, double y) { return 0.5 * std::sin(0.9 * x + 0.5) + 0.3 * std::cos(1.3 * y); });
    const Surface surface(sheet);
    CellMask region = CellMask::none(sheet.rows(), sheet.columns());
    const std::vector<std::array<std::size_t, 2>> cells{{1, 1}, {2, 1}, {1, 2}, {2, 2}, {3, 2},
                                                        {4, 2}, {3, 3}, {4, 3}, {5, 3}, {4, 1}};
    for (const auto &[i, j] : cells) {
        region.set(i, j, true);
    }
    const gusset_mask_report report = sheet.mask_measure(region);
    Figure figure(960, 420, {0.2, -1, 0.95}, 128);
    figure.place(480, 205);
    carcass(figure, sheet, 3, [&](std::size_t i, std::size_t j) { return region(i, j) ? &taken : &pale; });
    for (const auto &[row, column] : sheet.mask_cells(region)) {
        // u + v is the same along each line.
        for (int k = 1; k < 8; ++k) {
            const double sum = k / 4.0, from = std::max(0.0, sum - 1), to = std::min(1.0, sum);
            std::vector<gusset::SurfacePlace> line;
            for (int p = 0; p <= 4; ++p) {
                const double u = from + (to - from) * p / 4;
                line.push_back(gusset::surface_place(0, row, column, u, sum - u));
            }
            std::vector<Point3> points;
            for (const gusset::SurfacePoint &point : surface.evaluate(line)) {
                points.push_back({point.point[0], point.point[1], point.point[2]});
            }
            figure.line(seen(figure, points), {ochre, 1.2, ""});
        }
    }
    std::vector<std::array<uint32_t, 2>> longest;
    const auto list = sheet.mask_cells(region);
    for (const auto &from : list) {
        for (const auto &to : list) {
            if (auto chain = sheet.mask_chain(region, from, to); chain.size() > longest.size()) {
                longest = std::move(chain);
            }
        }
    }
    std::vector<Spot> chain;
    for (const auto &[row, column] : longest) {
        const gusset::SurfacePoint point = surface.evaluate(gusset::surface_place(0, row, column));
        chain.push_back(figure.at({point.point[0], point.point[1], point.point[2]}));
    }
    figure.line(chain, {red, 2, ""});
    for (const Spot &spot : chain) {
        figure.dot(spot, 4, red, red);
    }
    const auto node = [&](double u, double v) {
        const gusset::SurfacePoint point = surface.evaluate(surface.locate(0, u, v));
        return figure.at({point.point[0], point.point[1], point.point[2]});
    };
    const double m = static_cast<double>(sheet.rows()), n = static_cast<double>(sheet.columns());
    for (std::size_t k = 0; k <= sheet.rows(); ++k) {
        const Spot at = node(static_cast<double>(k), 0);
        figure.label({at[0], at[1] + 24},
                     k == 0              ? "u_0"
                     : k == sheet.rows() ? "u_m"
                                         : "u_" + std::to_string(k),
                     "middle", 14);
    }
    for (std::size_t k = 0; k <= sheet.columns(); ++k) {
        const Spot at = node(0, static_cast<double>(k));
        figure.label({at[0] - 12, at[1] + 5},
                     k == 0                 ? "v_0"
                     : k == sheet.columns() ? "v_n"
                                            : "v_" + std::to_string(k),
                     "end", 14);
    }
    figure.save(file);
    return places(m, 0) + " x " + places(n, 0) + " cells, " + std::to_string(report.cells) +
           " in the region, Euler characteristic " + std::to_string(report.euler) + ", integer diameter " +
           std::to_string(report.integer_diameter) + ", diameter at most " + places(report.diameter, 3);
}

/// Fig. 3: two cells with a common curve: points in one of them, and one in each.
std::string two_cells(const std::string &file) {
    const Sheet sheet =
        sheet_of(3, 2, 3, 1.5, [](double x, double y) { return 0.9 * std::cos(0.8 * x) - 0.3 * y * y + 0.15 * x * y; });
    const Surface surface(sheet);
    const gusset::CellDiameters d = sheet.diameters();
    const auto node = [&](double u, double v) {
        const gusset::SurfacePoint point = surface.evaluate(surface.locate(0, u, v));
        return Point3{point.point[0], point.point[1], point.point[2]};
    };
    Figure figure(960, 360, {0.3, -1, 0.75}, 135);
    std::array<double, 2> lengths{};
    std::array<double, 2> parts{};
    for (std::size_t k = 0; k < 2; ++k) {
        figure.place(245 + 470 * static_cast<double>(k), 215);
        carcass(figure, sheet, 6, [](std::size_t i, std::size_t) { return i == 0 ? &pale : &taken; });
        // By the upright plane through both points.
        const Point3 a = node(0.1, 0.12), b = k == 0 ? node(0.85, 0.9) : node(1.8, 0.85);
        const Point3 normal{b[1] - a[1], a[0] - b[0], 0};
        const auto path = surface.section(a, normal);
        std::vector<Point3> ab;
        for (const Point3 &p : path[0].points) {
            const double t = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1]));
            if (t > 0 && t < (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1])) {
                ab.push_back(p);
            }
        }
        if (ab.front()[0] > ab.back()[0]) {
            std::reverse(ab.begin(), ab.end());
        }
        ab.insert(ab.begin(), a);
        ab.push_back(b);
        lengths[k] = length_of(ab);
        figure.line(seen(figure, ab), {red, 2.5, ""});
        const auto named = [&](const Point3 &p, const char *name, double x, double y) {
            figure.dot(figure.at(p), 4, paper, red, 1.5);
            figure.label({figure.at(p)[0] + x, figure.at(p)[1] + y}, name, "middle", 16, red);
        };
        if (k == 1) {
            // C is where the path meets the curve between the cells, x = 0.
            const auto c = std::min_element(
                ab.begin(), ab.end(), [](const Point3 &p, const Point3 &q) { return std::abs(p[0]) < std::abs(q[0]); });
            parts[0] = length_of({ab.data(), static_cast<std::size_t>(c - ab.begin()) + 1});
            parts[1] = lengths[1] - parts[0];
            named(*c, "C", 14, 20);
        }
        named(a, "A", -14, 6);
        named(b, "B", 14, -4);
        const Spot top = figure.at(node(1, 1));
        figure.label({top[0], top[1] - 12}, "Γ", "middle", 18);
    }
    figure.label({245, 345}, "а: both in one cell");
    figure.label({715, 345}, "б: one in each");
    figure.save(file);
    return "d1 " + places(d.intrinsic[0], 3) + ", d2 " + places(d.intrinsic[1], 3) + "; in one cell " +
           places(lengths[0], 3) + "; in two " + places(parts[0], 3) + " + " + places(parts[1], 3) + " = " +
           places(lengths[1], 3) + " <= " + places(d.intrinsic[0] + d.intrinsic[1], 3);
}

/// Fig. 4: the cells round a node that the paper's rule excludes, and the scale after the whole search.
std::string block(const std::string &file) {
    const std::size_t size = 14;
    const Sheet sheet = sheet_of(size + 1, size + 1, 5.6, 5.6,
                                 [](double x, double y) { return 0.35 * std::sin(1.3 * x) * std::cos(y) + 0.1 * x; });
    const Surface surface(sheet);
    const double d = sheet.diameters().max_euclidean;
    const Point3 on{2, 0, 0}, normal{1, 0.25, 0};
    // The node, its distance r from the plane, and the largest J with J d < r.
    const std::size_t row = 5, column = 7;
    const gusset::SurfacePoint node =
        surface.evaluate(surface.locate(0, static_cast<double>(row), static_cast<double>(column)));
    const Point3 a{node.point[0], node.point[1], node.point[2]};
    const double r = std::abs(pictures::dot(pictures::minus(a, on), pictures::unit(normal)));
    const auto j = static_cast<std::size_t>(std::ceil(r / d)) - 1;
    const auto inside = [&](std::size_t i, std::size_t k) {
        return i + j >= row && i < row + j && k + j >= column && k < column + j;
    };
    gusset::ReferenceTask task = gusset::ReferenceTask::plane(on, normal).up_to(0);
    task.by_rows = 1;
    const gusset::ReferenceMask search = sheet.reference_mask(task);

    Figure figure(960, 430, {-0.35, -1, 1.1}, 58);
    figure.place(265, 205);
    carcass(figure, sheet, 2, [&](std::size_t i, std::size_t k) { return inside(i, k) ? &taken : &pale; });
    figure.circle(figure.at(a), 58 * static_cast<double>(j) * d, {red, 1.5, "6 4"}, red, 0.1);
    plane(figure, {on[0] + 0.25 * 3, on[1] - 3, 0}, {on[0] - 0.25 * 3, on[1] + 3, 0}, -0.7, 0.9);
    std::size_t missed = 0;
    const gusset::SurfacePaths met = surface.section(on, normal);
    for (const gusset::SurfacePath path : met) {
        missed += static_cast<std::size_t>(
            std::count_if(path.places.begin(), path.places.end(),
                          [&](const gusset::SurfacePlace &at) { return !search.mask(at.row, at.column); }));
        figure.line(seen(figure, path.points), {violet, 2.5, ""});
    }
    const Spot spot = figure.at(a),
               rim{spot[0] - 58 * static_cast<double>(j) * d * 0.8, spot[1] - 58 * static_cast<double>(j) * d * 0.6};
    figure.line({spot, rim}, {red, 1.2, ""});
    figure.dot(spot, 4.5, paper, red, 1.5);
    figure.label({spot[0] + 12, spot[1] + 20}, "A", "middle", 17, red);
    figure.label({between(spot, rim, 0.6)[0], between(spot, rim, 0.6)[1] + 5}, "J d", "middle", 15, red);
    figure.label({265, 418}, "2J x 2J cells, J = " + std::to_string(j) + ", in a ball");
    const double side = 25;
    const auto high = static_cast<double>(size);
    // u to the right and v up, as in the view on the left.
    figure.bits(
        {730 - 0.5 * side * high, 30}, size, size, side,
        [&](std::size_t i, std::size_t k) { return search.mask(k, size - 1 - i); },
        [](std::size_t, std::size_t) { return violet; });
    const auto on_scale = [&](double u, double v) {
        return Spot{730 + side * (u - 0.5 * high), 30 + side * (high - v)};
    };
    const double i = static_cast<double>(row), k = static_cast<double>(column), half = static_cast<double>(j);
    figure.area({on_scale(i - half, k - half), on_scale(i + half, k - half), on_scale(i + half, k + half),
                 on_scale(i - half, k + half)},
                taken, 0.6, {red, 1.5, "6 4"});
    for (const gusset::SurfacePath path : met) {
        std::vector<Spot> line;
        for (const gusset::SurfacePlace &at : path.places) {
            line.push_back(on_scale(at.row + at.u, at.column + at.v));
        }
        figure.line(line, {paper, 2, ""});
    }
    figure.dot(on_scale(i, k), 4.5, paper, red, 1.5);
    figure.label({on_scale(i, k)[0] + 12, on_scale(i, k)[1] + 20}, "A", "middle", 17, red);
    figure.label({on_scale(high, 0)[0] + 14, on_scale(high, 0)[1] + 4}, "u", "middle", 15);
    figure.label({on_scale(0, high)[0] - 12, on_scale(0, high)[1] + 10}, "v", "middle", 15);
    figure.label({730, 402}, "the scale after the search: " + std::to_string(search.report.cells) + " of " +
                                 std::to_string(size * size) + " cells are left (violet),");
    figure.label({730, 421}, "with the section (white) and the cells round A (yellow)");
    figure.save(file);
    return "d " + places(d, 3) + ", r " + places(r, 3) + ", J " + std::to_string(j) + ", J d " +
           places(static_cast<double>(j) * d, 3) + "; " + std::to_string(search.report.cells) + " of " +
           std::to_string(size * size) + " cells left, " + std::to_string(missed) +
           " points of the section outside them, " + std::to_string(search.report.evaluations) + " of " +
           std::to_string((size + 1) * (size + 1)) + " nodes looked at, " + std::to_string(search.report.blocks) +
           " blocks, " + std::to_string(search.report.dropped) + " lines left out";
}
} // namespace

std::vector<Entry> leus() {
    return {{"leus_1", sections}, {"leus_2", regions}, {"leus_3", two_cells}, {"leus_4", block}};
}
} // namespace figures
