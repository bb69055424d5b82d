// Closes a ship's hull from its table of offsets, and computes its hydrostatics at a draught: from the closed mesh,
// from the smooth surface and from the table itself.
//   ship [stations.csv] [--draught 4] [--picture ship.svg] [--mesh ship.off] [--page NAME]
// The file has the format of examples/cpp/hull.cpp, in metres: cells of the table may be empty. Without one, or with
// -, the
// hull is made by formula.
#include "../cpp/hull_stations.hpp"
#include "workshop.hpp"

#include <CLI/CLI.hpp>

namespace {
using workshop::Claims;
using gusset::MeshView;
using gusset::Point3;
using ship::operator+, ship::operator-, ship::operator*;

/// Hydrostatics of a ship: displaced volume and its centre, area of the waterplane and its centre of flotation.
struct Hydrostatics {
    double volume = 0, area = 0;
    Point3 buoyancy{}, flotation{};
};

/// The part of a triangle that is not above the water.
std::vector<Point3> below(const std::array<Point3, 3> &triangle, double water) {
    std::vector<Point3> part;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point3 &a = triangle[k], &b = triangle[(k + 1) % 3];
        if (a[2] <= water) {
            part.push_back(a);
        }
        if ((a[2] <= water) != (b[2] <= water)) {
            const double t = (water - a[2]) / (b[2] - a[2]);
            part.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), water});
        }
    }
    return part;
}

/// From a closed mesh. Cones from a point of the waterplane need no faces there. The waterplane has the area and the
/// moments of the vertical components of all faces below it, with opposite sign, so that the mesh need not be closed
/// at the cut.
Hydrostatics of_mesh(const MeshView &mesh, double water) {
    Hydrostatics sum;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const gusset::Indices face = mesh.face(f);
        for (std::size_t corner = 2; corner < face.size(); ++corner) {
            const auto part = below(
                {mesh.position(face[0]), mesh.position(face[corner - 1]), mesh.position(face[corner])}, water);
            for (std::size_t k = 2; k < part.size(); ++k) {
                const Point3 &a = part[0], &b = part[k - 1], &c = part[k];
                const Point3 area = ship::cross(b - a, c - a), apex{0, 0, water};
                const double cone = ship::dot(area, a - apex) / 6;
                sum.volume += cone;
                sum.area -= area[2] / 2;
                for (std::size_t i = 0; i < 3; ++i) {
                    sum.buoyancy[i] += cone * (a[i] + b[i] + c[i] + apex[i]) / 4;
                    sum.flotation[i] -= area[2] * (a[i] + b[i] + c[i]) / 6;
                }
            }
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        sum.buoyancy[i] /= sum.volume;
        sum.flotation[i] /= sum.area;
    }
    sum.flotation[2] = water;
    return sum;
}

/// The area within a waterline and its mirror image, and the moment of that area: by trapezoids along the line.
struct Waterplane {
    double area = 0, moment = 0;
    void add(const Point3 &a, const Point3 &b) {
        area += std::abs(b[0] - a[0]) * (a[1] + b[1]);
        moment += std::abs(b[0] - a[0]) * (a[0] * (2 * a[1] + b[1]) + b[0] * (a[1] + 2 * b[1])) / 3;
    }
};

/// From waterplanes at the middles of equal layers between `low` and the water, and the waterplane at the water.
Hydrostatics of_layers(const std::vector<Waterplane> &layers, const Waterplane &top, double low, double water) {
    const double thick = (water - low) / static_cast<double>(layers.size());
    Hydrostatics sum;
    for (std::size_t k = 0; k < layers.size(); ++k) {
        sum.volume += thick * layers[k].area;
        sum.buoyancy[0] += thick * layers[k].moment;
        sum.buoyancy[2] += thick * layers[k].area * (low + thick * (static_cast<double>(k) + 0.5));
    }
    sum.buoyancy[0] /= sum.volume;
    sum.buoyancy[2] /= sum.volume;
    sum.area = top.area;
    sum.flotation = {top.moment / top.area, 0, water};
    return sum;
}

/// The waterplane of the table: straight lines between its points, up the stations and from station to station.
Waterplane of_table(const std::vector<ship::Station> &stations, double height) {
    std::vector<Point3> line;
    for (const ship::Station &station : stations) {
        // Below or above a station, its breadth is 0.
        Point3 at{station.front()[0], 0, height};
        for (std::size_t k = 1; k < station.size(); ++k) {
            const Point3 &a = station[k - 1], &b = station[k];
            if (a[2] <= height && height <= b[2] && a[2] < b[2]) {
                at = a + (height - a[2]) / (b[2] - a[2]) * (b - a);
            }
        }
        line.push_back(at);
    }
    Waterplane found;
    for (std::size_t k = 1; k < line.size(); ++k) {
        found.add(line[k - 1], line[k]);
    }
    return found;
}

/// The waterplanes of the smooth surface of the port side at these heights, which increase.
std::vector<Waterplane> of_surface(const gusset::Surface &port, const std::vector<double> &heights) {
    std::vector<Waterplane> found(heights.size());
    const gusset::SurfacePaths lines = port.sections({0, 0, 0}, {0, 0, 1}, heights);
    for (const gusset::SurfacePath &line : lines) {
        for (std::size_t k = 1; k < line.points.size(); ++k) {
            found[line.level].add(line.points[k - 1], line.points[k]);
        }
    }
    return found;
}

/// For each face of the closed hull whether it comes from a piece; the others are new.
std::vector<bool> given_faces(const gusset::Join &whole) {
    std::vector<bool> given(whole.mesh().face_count());
    for (const gusset_piece_map &piece : whole.pieces()) {
        for (const uint32_t f : gusset::Indices(piece.faces.data, piece.faces.count)) {
            given[f] = true;
        }
    }
    return given;
}

/// Whether the middle of a face is under water.
bool is_wet(const MeshView &mesh, std::size_t f, double water) {
    double height = 0;
    for (const uint32_t v : mesh.face(f)) {
        height += mesh.position(v)[2] / static_cast<double>(mesh.face(f).size());
    }
    return height < water;
}

/// The hull from the bow and above, and from the stern and below; faces under water in red, filled faces in green.
void draw(const gusset::Join &whole, double water, const Point3 &centre, double scale, const std::string &file) {
    const std::vector<bool> given = given_faces(whole);
    const auto colour = [&](std::size_t f) {
        return !given[f] ? pictures::green : is_wet(whole.mesh(), f, water) ? pictures::red : pictures::grey;
    };
    pictures::Drawing drawing(960, 640, {0.66, 0.7, 0.36}, scale);
    drawing.add("<g stroke-width='0.12'>\n");
    double y = 170;
    for (const Point3 &eye : {Point3{0.66, 0.7, 0.36}, Point3{-0.6, 0.74, -0.3}}) {
        drawing.look(eye, scale);
        drawing.place(0, 0);
        const auto at = drawing.at(centre);
        drawing.place(480 - at[0], y - at[1]);
        drawing.mesh(whole.mesh(), colour);
        y += 285;
    }
    drawing.add("</g>\n");
    drawing.caption(480, 625, "from the bow and above; from the stern and below: under water in red");
    workshop::save(drawing, file);
}

/// The table, its surfaces and the closed hull for a page.
page::Showcase show(const std::vector<ship::Station> &stations, const std::vector<MeshView> &pieces, const gusset::Join &whole,
                    double water, double length) {
    page::Showcase shown;
    shown.id = "ship";
    shown.title = "A ship";
    shown.text = "From a table of offsets to a closed hull that floats.";
    shown.paints = {{"hull", "#a9b0b3", 0, 0.45}, {"under water", "#96402f", 0, 0.5}, {"filled", "#d99a1c", 0.4, 0.35, true}};
    shown.eye = {0.66, 0.7, 0.36};
    shown.up = {0, 0, 1};
    shown.pairs = {{1, 2}, {0, 2}};
    shown.bodies.resize(3);
    for (const ship::Station &station : stations) {
        shown.bodies[0].curves.push_back(workshop::line(station, false, "#33597f", length / 700));
    }
    for (const MeshView &piece : pieces) {
        shown.bodies[1].add(piece, [&](std::size_t f) { return is_wet(piece, f, water) ? 1 : 0; });
        workshop::add_borders(shown.bodies[1], piece, "#28323c", length / 1200);
    }
    const std::vector<bool> given = given_faces(whole);
    shown.bodies[2].add(whole.mesh(), [&](std::size_t f) { return !given[f] ? 2 : is_wet(whole.mesh(), f, water) ? 1 : 0; });
    return shown;
}

void print(const char *what, const Hydrostatics &found, const Hydrostatics &of) {
    using workshop::percent;
    std::cout << std::fixed << std::setprecision(2) << std::setw(9) << what << std::setw(9) << found.volume
              << std::setw(7) << percent(of.volume, found.volume) << " %" << std::setw(9) << found.area << std::setw(7)
              << percent(of.area, found.area) << " %" << std::setprecision(3) << std::setw(9) << found.buoyancy[0]
              << std::setw(9) << found.buoyancy[2] << std::setw(9) << found.flotation[0] << '\n';
}
} // namespace

int main(int argc, char **argv) try {
    CLI::App app("Closes a ship's hull from its table of offsets, and computes its hydrostatics.");
    std::string input = "-", picture, file, page;
    std::vector<std::string> names{"station_i", "waterline_j", "x_m", "y_half_breadth_m", "z_m"};
    double water = 0;
    app.add_option("stations", input, "a CSV file, or - for a hull by formula");
    app.add_option("--columns", names, "the names of the five columns")->delimiter(',')->expected(5);
    app.add_option("--draught", water, "the height of the water; 0: 60 % of the lowest deck's");
    app.add_option("--picture", picture, "an SVG file of the hull");
    app.add_option("--mesh", file, "an OFF file of the closed hull");
    app.add_option("--page", page, "its steps for scripts/page.py, NAME.json and NAME.bin");
    CLI11_PARSE(app, argc, argv);

    Claims claims;
    const std::vector<ship::Station> stations = input == "-" ? ship::formula() : ship::read(input, names);
    double low = INFINITY, high = -INFINITY, deck = INFINITY, bow = -INFINITY;
    for (const ship::Station &station : stations) {
        low = std::min(low, station.front()[2]);
        deck = std::min(deck, station.back()[2]);
        high = std::max(high, station.back()[2]);
        bow = std::max(bow, station.back()[0]);
    }
    water = water != 0 ? water : low + 0.6 * (deck - low);

    const ship::Hull hull(stations);
    const auto fineness = static_cast<uint32_t>(std::max<std::size_t>(2, 50 / stations.size())); // parts of a cell
    // Straight lines between few stations lose as the square of their distance.
    const double coarseness = std::pow(std::max(1.0, 20.0 / static_cast<double>(stations.size())), 2);
    //! [hull]
    gusset::SheetMeshOptions even;
    even.min_u = even.min_v = fineness; // not by a tolerance: borders of pieces that meet have the same vertices
    std::vector<gusset::SheetMesh> meshes;
    for (const auto *pieces : {&hull.port, &hull.starboard, &hull.decks, &hull.transom}) {
        for (const gusset::Sheet &piece : *pieces) {
            meshes.emplace_back(piece, even);
        }
    }
    std::vector<MeshView> views;
    for (const gusset::SheetMesh &mesh : meshes) {
        views.push_back(mesh.mesh());
    }
    gusset::JoinOptions options;
    options.fill = true; // slits under a flat keel, steps of the deck
    const gusset::Join whole(views, options);
    //! [hull]

    double apart = 0;
    for (const gusset::SheetMesh &mesh : meshes) {
        apart = std::max(apart, mesh.deviation());
    }
    const workshop::Measure size = workshop::measure(whole.mesh());
    std::cout << stations.size() << " stations; " << views.size() << " pieces, meshes within " << apart
              << " m of their surfaces; joined: " << whole.report().joint_count << " strips, " << whole.report().hole_count
              << " holes filled, " << whole.report().loops_left << " loops left\nclosed: " << whole.mesh().face_count()
              << " faces, Euler characteristic " << workshop::euler(whole.mesh()) << ", " << size.area << " m2, "
              << size.volume << " m3\n";
    claims.closed(whole.mesh(), "the hull");
    claims.hold(size.volume > 0, "the hull is outward");
    claims.hold(workshop::euler(whole.mesh()) == 2, "the hull is one body without handles");

    const int layers = 120;
    std::vector<double> heights;
    std::vector<Waterplane> drawn;
    for (int k = 0; k < layers; ++k) {
        heights.push_back(low + (water - low) * (k + 0.5) / layers);
        drawn.push_back(of_table(stations, heights.back()));
    }
    heights.push_back(water);
    std::vector<Waterplane> smooth = of_surface(gusset::Surface(hull.port), heights);
    const Waterplane top = smooth.back();
    smooth.pop_back();
    const Hydrostatics mesh = of_mesh(whole.mesh(), water), surface = of_layers(smooth, top, low, water),
                       table = of_layers(drawn, of_table(stations, water), low, water);
    std::cout << "draught " << water - low << " m; differences of the mesh\n"
              << "            volume, m3       waterplane, m2       buoyancy x, z    flotation x, m\n";
    print("mesh", mesh, mesh);
    print("surface", surface, mesh);
    print("table", table, mesh);
    for (const auto &[other, within] : {std::pair(&surface, 0.5), std::pair(&table, 3.0 * coarseness)}) {
        claims.hold(std::abs(workshop::percent(mesh.volume, other->volume)) < within, "the volumes agree");
        claims.hold(std::abs(workshop::percent(mesh.area, other->area)) < within, "the waterplanes agree");
        const double long_by = bow / 100 * within;
        claims.hold(std::abs(mesh.buoyancy[0] - other->buoyancy[0]) < long_by, "the centres of buoyancy agree");
        claims.hold(std::abs(mesh.buoyancy[2] - other->buoyancy[2]) < long_by / 4, "the heights of buoyancy agree");
        claims.hold(std::abs(mesh.flotation[0] - other->flotation[0]) < long_by, "the centres of flotation agree");
    }
    claims.hold(std::abs(mesh.buoyancy[1]) < 1e-3 * bow, "the hull floats upright");
    if (!picture.empty()) {
        draw(whole, water, {bow / 2, 0, high / 2}, 800 / bow, picture);
    }
    workshop::save(whole.mesh(), file);
    page::Showcase shown = show(stations, views, whole, water, bow);
    shown.states = {
        {"Table", 0, {}, workshop::said(stations.size(), " stations of one side.")},
        {"Surfaces", 1, {}, workshop::said(views.size(), " pieces: both sides, decks, transom; meshes within ", apart, " m of the smooth surfaces.")},
        {"Closed", 2, {}, workshop::said("Closed and manifold. It displaces ", std::setprecision(5), mesh.volume, std::setprecision(2),
                                     " m3 at the draught drawn, ", workshop::percent(mesh.volume, surface.volume),
                                     " % beside layers of the smooth surface and ", workshop::percent(mesh.volume, table.volume),
                                     " % beside the table alone; waterplane ", workshop::percent(mesh.area, surface.area), " and ",
                                     workshop::percent(mesh.area, table.area), " %.")}};
    workshop::save(shown, page);
    return claims.status();
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
