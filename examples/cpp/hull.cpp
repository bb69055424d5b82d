// Draws the lines plan of a ship's hull from its stations, and a view of it with its silhouette:
//   hull stations.csv hull.svg hull_view.svg
//   hull - hull.svg hull_view.svg              (a hull by formula)
// The file is a table of offsets in metres: the columns station_i, waterline_j, x_m, y_half_breadth_m and z_m, a row for each point. x
// goes forward, y to port, z up; y is empty where there is no hull. Stations follow each other from the stern to the bow, the
// points of each from the keel to the deck. Other names of the columns: --columns.
#include <gusset.hpp>

#include <CLI/CLI.hpp>
#include <csv.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {
using gusset::Point3;
using gusset::SurfacePaths;
using Station = std::vector<Point3>;

Point3 operator+(const Point3 &a, const Point3 &b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Point3 operator-(const Point3 &a, const Point3 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point3 operator*(double s, const Point3 &a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const Point3 &a, const Point3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point3 cross(const Point3 &a, const Point3 &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point3 unit(const Point3 &a) { return (1 / std::sqrt(std::max(dot(a, a), 1e-300))) * a; }

// ---- The stations ----

std::vector<Station> read(const std::string &file, const std::vector<std::string> &names) {
    io::CSVReader<5> rows(file);
    rows.read_header(io::ignore_extra_column, names[0], names[1], names[2], names[3], names[4]);
    std::map<int, std::map<int, Point3>> table;
    int station = 0, waterline = 0;
    double x = 0, z = 0;
    for (std::string y; rows.read_row(station, waterline, x, y, z);) {
        if (!y.empty()) {
            table[station][waterline] = {x, std::stod(y), z};
        }
    }
    std::vector<Station> stations;
    for (const auto &row : table) {
        stations.emplace_back();
        for (const auto &entry : row.second) {
            stations.back().push_back(entry.second);
        }
    }
    return stations;
}

/// A coaster of 100 m, something like Wigley's hull with a transom, sheer, a raked stem and flare.
std::vector<Station> formula() {
    const auto rise = [](double t, double from, double to, double power) {
        return std::pow(std::clamp((t - from) / (to - from), 0.0, 1.0), power);
    };
    std::vector<Station> stations;
    for (int i = 0; i <= 24; ++i) {
        const double t = i / 24.0, fore = rise(t, 0.45, 1, 1.4), aft = rise(t, 0.5, 0, 1.4);
        const double keel = 5.2 * rise(t, 0.3, 0, 1.7) + 2.0 * rise(t, 0.88, 1, 2.2);
        const double deck = 9.5 + 2.9 * rise(t, 0.45, 1, 2.2) + 0.5 * rise(t, 0.45, 0, 2);
        const double low = (1 - rise(t, 0.48, 1, 1.9)) * (1 - 0.34 * rise(t, 0.42, 0, 2.2));
        const double high = (1 - rise(t, 0.6, 1, 2.4)) * (1 - 0.16 * rise(t, 0.35, 0, 2));
        const double bend = 4.2 - 2.3 * fore - 1.6 * aft, power = 0.44 + 0.5 * fore + 0.16 * aft;
        stations.emplace_back();
        for (int j = 0; j <= 14; ++j) {
            const double s = std::pow(j / 14.0, 1.7), z = keel + s * (deck - keel);
            const double section = std::pow(1 - std::pow(1 - s, bend), power);
            const double lean = rise(t, 0.72, 1, 1.8) * (8.5 * std::pow(z / 12.4, 1.7) - 3.5);
            const double half = low * section + (high - low) * std::pow(s, 2.6);
            stations.back().push_back({97 * t + lean, 8 * std::max(half, 0.0), z});
        }
    }
    return stations;
}

// ---- The hull ----

/// So many points at equal steps of a smooth curve through points.
Station faired(const Station &points, int count) {
    Station distinct;
    for (const Point3 &p : points) {
        if (distinct.empty() || dot(p - distinct.back(), p - distinct.back()) > 1e-12) {
            distinct.push_back(p);
        }
    }
    if (distinct.size() == 1) {
        return Station(static_cast<std::size_t>(count), distinct[0]);
    }
    const gusset::Outline outline(gusset::Outlines(distinct, false));
    const gusset::Places even = outline.curve_copy().sample(gusset::Sample::count, count);
    Station found(even.points().begin(), even.points().end());
    for (Point3 &p : found) {
        p[1] = std::max(p[1], 0.0); // The other half begins at the middle.
    }
    found.front() = distinct.front();
    found.back() = distinct.back();
    return found;
}

constexpr int columns = 21;

/// The surface through stations. Normals point outwards: on the port side stations follow each other aft, on the other forward.
gusset::Sheet side(std::vector<Station> stations, bool port) {
    if (port) {
        std::reverse(stations.begin(), stations.end());
    }
    std::vector<Point3> nodes;
    for (const Station &station : stations) {
        for (const Point3 &p : station) {
            nodes.push_back({p[0], port ? p[1] : -p[1], p[2]});
        }
    }
    return gusset::Sheet::from_nodes(stations.size(), columns, nodes);
}

/// A deck with camber from rail to rail.
gusset::Sheet deck(const std::vector<Point3> &rail) {
    std::vector<Point3> nodes;
    for (const Point3 &p : rail) {
        for (int k = -3; k <= 3; ++k) {
            const double s = k / 3.0;
            nodes.push_back({p[0], -s * p[1], p[2] + 0.06 * p[1] * (1 - s * s)});
        }
    }
    // From the bow aft, from port to starboard is seen from above; here it is the other way round in both.
    std::reverse(nodes.begin(), nodes.end());
    return gusset::Sheet::from_nodes(rail.size(), 7, nodes);
}

/// The flat end of the hull at its first station.
gusset::Sheet stern(const Station &station) {
    std::vector<Point3> nodes;
    for (const Point3 &p : station) {
        for (int k = 3; k >= -3; --k) {
            nodes.push_back({p[0], k / 3.0 * p[1], p[2]});
        }
    }
    return gusset::Sheet::from_nodes(station.size(), 7, nodes);
}

/// Pieces of the hull. Each piece has the stations between two heights that all of them reach: where the deck has a step, the hull has
/// two pieces, one above the other.
struct Hull {
    std::vector<gusset::Sheet> port, starboard, decks, transom;

    explicit Hull(const std::vector<Station> &stations) {
        double step = std::numeric_limits<double>::infinity();
        std::vector<double> tops;
        for (const Station &station : stations) {
            step = std::min(step, station.back()[2]);
            tops.push_back(station.back()[2]);
        }
        // The deck has a step where it rises by more than the stations are apart.
        std::size_t cut = 0;
        for (std::size_t i = 1; i < stations.size(); ++i) {
            if (std::abs(tops[i] - tops[i - 1]) > 2 * std::abs(stations[i][0][0] - stations[i - 1][0][0])) {
                cut = i;
            }
        }
        transom.push_back(stern(faired(stations[0], columns)));
        if (cut == 0) {
            add(stations);
            return;
        }
        std::vector<Station> below, above;
        for (std::size_t i = 0; i < stations.size(); ++i) {
            Station low, high;
            for (const Point3 &p : stations[i]) {
                if (p[2] <= step) {
                    low.push_back(p);
                }
                if (p[2] >= step && i >= cut) {
                    high.push_back(p);
                }
            }
            if (!low.empty()) {
                below.push_back(low);
            }
            if (!high.empty()) {
                above.push_back(high);
            }
        }
        add(below);
        add(above);
        decks.clear();
        std::vector<Point3> rails[2];
        for (std::size_t i = 0; i < stations.size(); ++i) {
            rails[i >= cut ? 1 : 0].push_back(stations[i].back());
        }
        decks.push_back(deck(rails[0]));
        decks.push_back(deck(rails[1]));
    }

private:
    void add(const std::vector<Station> &stations) {
        std::vector<Station> even;
        std::vector<Point3> rail;
        for (const Station &station : stations) {
            even.push_back(faired(station, columns));
            rail.push_back(station.back());
        }
        port.push_back(side(even, true));
        starboard.push_back(side(even, false));
        decks.push_back(deck(rail));
    }
};

// ---- Drawing ----

const char *const ink = "#28323c", *const faint = "#c9d1d8", *const station_ink = "#a8481c", *const water_ink = "#1f6fb2",
                 *const buttock_ink = "#2c8557", *const mark_ink = "#b0185a";

/// A plan: two coordinates of the hull on paper, in a frame with a title.
struct Plan {
    std::ostream &out;
    int right, up;
    /// Where the origin is on paper, and units a metre; negative: the axis points the other way.
    double x, y, along, across;

    double px(const Point3 &p) const { return x + along * p[static_cast<std::size_t>(right)]; }
    double py(const Point3 &p) const { return y - across * p[static_cast<std::size_t>(up)]; }

    /// A line through points, without those that would not be seen.
    template <class Points>
    void path(const Points &points, bool closed) const {
        double last_x = 0, last_y = 0;
        out << "<path d='";
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double to_x = px(points[k]), to_y = py(points[k]);
            if (k == 0 || k + 1 == points.size() || std::hypot(to_x - last_x, to_y - last_y) > 1.5) {
                out << (k == 0 ? 'M' : 'L') << to_x << ' ' << to_y;
                last_x = to_x;
                last_y = to_y;
            }
        }
        out << (closed ? "Z'/>\n" : "'/>\n");
    }
    void paths(const SurfacePaths &paths) const {
        for (const gusset::SurfacePath &found : paths) {
            path(found.points, found.closed);
        }
    }
    void begin(const char *colour, double width) const {
        out << "<g fill='none' stroke='" << colour << "' stroke-width='" << width << "'>\n";
    }
    void end() const { out << "</g>\n"; }
    void text(const Point3 &at, double dx, double dy, const std::string &what, const char *attributes = "") const {
        out << "<text x='" << px(at) + dx << "' y='" << py(at) + dy << "' " << attributes << ">" << what << "</text>\n";
    }
};

/// The borders of a piece, as curves.
std::vector<gusset::Curve> borders(const gusset::Sheet &sheet) {
    const gusset_sheet_parts size = sheet.info();
    std::vector<gusset::Curve> found;
    for (double end : {0.0, 1.0}) {
        found.push_back(sheet.curve(gusset::Along::rows, end * static_cast<double>(size.rows)));
        found.push_back(sheet.curve(gusset::Along::columns, end * static_cast<double>(size.columns)));
    }
    return found;
}

/// n numbers from a to b, without a and b.
std::vector<double> between(double a, double b, int n) {
    std::vector<double> found;
    for (int k = 1; k <= n; ++k) {
        found.push_back(a + (b - a) * k / (n + 1));
    }
    return found;
}

std::string rounded(double value, int digits) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

struct Request {
    int waterlines = 8, buttocks = 4, stations = 20;
    double draught = 0;
};

/// What is drawn.
struct Lines {
    Point3 low, high;
    std::vector<double> heights, halves, places;
    SurfacePaths waterlines, buttocks, stations;
    std::vector<Point3> outside;
    std::vector<gusset::Closest> nearest;
};

Lines ask(const gusset::Carcass &port, const Request &request) {
    const gusset_carcass_facts facts = port.info();
    const Point3 low{facts.low[0], facts.low[1], facts.low[2]}, high{facts.high[0], facts.high[1], facts.high[2]};
    const double length = high[0] - low[0], height = high[2] - low[2];
    std::vector<double> heights = between(low[2], high[2], request.waterlines), halves = between(0, high[1], request.buttocks),
                        places = between(low[0], high[0], request.stations - 1);
    const auto chord = gusset::Between::chord(5e-5 * length);
    std::vector<Point3> outside;
    for (double t : {0.06, 0.28, 0.52, 0.75, 0.93}) {
        outside.push_back({low[0] + t * length, 1.25 * high[1], low[2] + (0.15 + 0.65 * std::fmod(3.7 * t, 1.0)) * height});
    }
    std::vector<gusset::Closest> nearest = port.closest(outside);
    return {low, high, heights, halves, places, port.sections({0, 0, 0}, {0, 0, 1}, heights, chord),
            port.sections({0, 0, 0}, {0, 1, 0}, halves, chord), port.sections({0, 0, 0}, {1, 0, 0}, places, chord), outside, nearest};
}

/// Straight lines of the grid, with their names.
void grid(const Plan &plan, const Lines &lines, double margin) {
    const std::vector<double> *const values[3] = {&lines.places, &lines.halves, &lines.heights};
    const char *const names[3] = {"", "B", "W"};
    plan.begin(faint, 0.6);
    for (int axis : {plan.right, plan.up}) {
        const auto k = static_cast<std::size_t>(axis), other = static_cast<std::size_t>(axis == plan.right ? plan.up : plan.right);
        for (double value : *values[k]) {
            Point3 from{}, to{};
            from[k] = to[k] = value;
            from[other] = other == 1 ? 0 : lines.low[other];
            to[other] = lines.high[other];
            plan.path(std::vector<Point3>{from, to}, false);
        }
    }
    plan.end();
    plan.out << "<g font-size='9' fill='#77818a'>\n";
    for (int axis : {plan.right, plan.up}) {
        const auto k = static_cast<std::size_t>(axis);
        for (std::size_t i = 0; i < values[k]->size(); ++i) {
            Point3 at = lines.low;
            at[1] = 0;
            at[k] = (*values[k])[i];
            if (axis == plan.right) {
                plan.text(at, 0, margin, names[k] + std::to_string(i + 1), "text-anchor='middle'");
            } else {
                plan.text(at, -6, 3, names[k] + std::to_string(i + 1), "text-anchor='end'");
            }
        }
    }
    plan.out << "</g>\n";
}

/// The points outside, and the nearest points of the hull.
void marks(const Plan &plan, const Lines &lines) {
    plan.begin(mark_ink, 0.9);
    for (std::size_t k = 0; k < lines.outside.size(); ++k) {
        const gusset::Closest &found = lines.nearest[k];
        plan.path(std::vector<Point3>{lines.outside[k], {found.point[0], found.point[1], found.point[2]}}, false);
    }
    plan.end();
    for (std::size_t k = 0; k < lines.outside.size(); ++k) {
        const gusset::Closest &found = lines.nearest[k];
        const Point3 at{found.point[0], found.point[1], found.point[2]};
        plan.out << "<circle r='2.1' fill='" << mark_ink << "' cx='" << plan.px(at) << "' cy='" << plan.py(at) << "'/><circle r='2.6' fill='white' stroke='"
                 << mark_ink << "' cx='" << plan.px(lines.outside[k]) << "' cy='" << plan.py(lines.outside[k]) << "'/>\n";
        plan.text(lines.outside[k], 5, -4, std::string(1, static_cast<char>('a' + k)), "font-size='10' font-style='italic' fill='#b0185a'");
    }
}

void write_plan(std::ostream &svg, const Hull &hull, const Lines &lines, const Request &request) {
    const double length = lines.high[0] - lines.low[0], half = lines.high[1], height = lines.high[2] - lines.low[2];
    const double left = 56, wide = 800, scale = wide / length, gap = 74;
    // Breadth and height are drawn larger in the body plan only.
    const double body = 330 / (2 * half), body_x = left + wide + 56 + 165;
    const double top = 66 + std::max(scale * height, body * height), bottom = top + gap + 1.3 * scale * half;
    const double table = top + gap - 10;
    const double total = std::max(bottom, table + 40 + 17 * static_cast<double>(lines.outside.size())) + 40;
    svg << std::fixed << std::setprecision(1) << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1290 " << total
        << "' font-family='Helvetica,Arial,sans-serif' stroke-linejoin='round' stroke-linecap='round'>\n<rect width='100%' height='100%' fill='white'/>\n";
    const Plan profile{svg, 0, 2, left - scale * lines.low[0], top + scale * lines.low[2], scale, scale};
    const Plan breadth{svg, 0, 1, left - scale * lines.low[0], top + gap + 0, scale, -scale};
    const Plan aft{svg, 1, 2, body_x, top + body * lines.low[2], -body, body}, fore{svg, 1, 2, body_x, top + body * lines.low[2], body, body};
    std::vector<gusset::Curve> edges;
    for (const gusset::Sheet &sheet : hull.port) {
        for (gusset::Curve &curve : borders(sheet)) {
            edges.push_back(std::move(curve));
        }
    }
    const auto outline = [&](const Plan &plan, double from, double to) {
        plan.begin(ink, 1.5);
        for (const gusset::Curve &edge : edges) {
            const gusset::Places points = edge.sample(gusset::Sample::chord, 1e-4 * length);
            std::vector<Point3> kept;
            for (const Point3 &p : points.points()) {
                if (p[0] >= from && p[0] <= to) {
                    kept.push_back(p);
                }
            }
            if (kept.size() > 1) {
                plan.path(kept, false);
            }
        }
        plan.end();
    };

    grid(profile, lines, 16);
    profile.begin(buttock_ink, 1);
    profile.paths(lines.buttocks);
    profile.end();
    outline(profile, -1e300, 1e300);
    marks(profile, lines);

    grid(breadth, lines, -8);
    breadth.begin(water_ink, 1);
    breadth.paths(lines.waterlines);
    breadth.end();
    outline(breadth, -1e300, 1e300);
    marks(breadth, lines);

    grid(fore, lines, 16);
    aft.begin(faint, 0.6);
    for (double z : lines.heights) {
        aft.path(std::vector<Point3>{{0, 0, z}, {0, half, z}}, false);
    }
    for (double y : lines.halves) {
        aft.path(std::vector<Point3>{{0, y, lines.low[2]}, {0, y, lines.high[2]}}, false);
    }
    aft.path(std::vector<Point3>{{0, 0, lines.low[2]}, {0, 0, lines.high[2]}}, false);
    aft.end();
    const double middle = lines.low[0] + 0.5 * length;
    fore.begin(station_ink, 1);
    for (const gusset::SurfacePath &path : lines.stations) {
        const double x = lines.places[path.level];
        if (x <= middle) {
            aft.path(path.points, path.closed);
        }
        if (x >= middle) {
            fore.path(path.points, path.closed);
        }
    }
    fore.end();
    outline(aft, lines.low[0], middle);
    outline(fore, middle, lines.high[0]);

    svg << "<g font-size='14' fill='" << ink << "' letter-spacing='1.5'>\n<text x='" << left << "' y='34'>PROFILE</text>\n<text x='" << left
        << "' y='" << top + gap - 30 << "'>HALF-BREADTH PLAN</text>\n<text x='" << body_x << "' y='34' text-anchor='middle'>BODY PLAN</text>\n</g>\n";
    svg << "<g font-size='11' fill='#56616b'><text x='" << left + 90 << "' y='34'>buttocks B, stations 1 to " << lines.places.size()
        << "</text><text x='" << left + 200 << "' y='" << top + gap - 30 << "'>waterlines W</text><text x='" << body_x - 165
        << "' y='52'>aft</text><text x='" << body_x + 165 << "' y='52' text-anchor='end'>forward</text>\n";
    const double x = body_x - 165;
    svg << "<text x='" << x << "' y='" << table << "'>length " << rounded(length, 2) << " m, beam " << rounded(2 * half, 2) << " m, depth "
        << rounded(height, 2) << " m, design draught " << rounded(request.draught - lines.low[2], 2) << " m</text>\n";
    svg << "<text x='" << x << "' y='" << table + 24 << "' fill='" << mark_ink << "'>nearest points of the hull</text>\n";
    for (std::size_t k = 0; k < lines.nearest.size(); ++k) {
        const gusset::Closest &found = lines.nearest[k];
        svg << "<text x='" << x << "' y='" << table + 42 + 17 * static_cast<double>(k) << "'><tspan font-style='italic' fill='" << mark_ink << "'>"
            << static_cast<char>('a' + k) << "</tspan><tspan x='" << x + 20 << "'>" << rounded(found.distance, 3) << " m</tspan><tspan x='" << x + 90
            << "'>at x " << rounded(found.point[0], 2) << ", y " << rounded(found.point[1], 2) << ", z " << rounded(found.point[2], 2)
            << "</tspan></text>\n";
    }
    svg << "</g>\n</svg>\n";
}

// ---- The view ----

struct View {
    /// Towards the eye, which is far away: a silhouette is where normals are across this.
    Point3 eye, right, up;
    double x, y, scale;

    View(const Point3 &towards, const Point3 &centre, double at_x, double at_y, double units)
        : eye(unit(towards)), right(unit(cross({0, 0, 1}, eye))), up(cross(eye, right)), x(at_x - units * dot(centre, right)),
          y(at_y + units * dot(centre, up)), scale(units) {}
    double px(const Point3 &p) const { return x + scale * dot(p, right); }
    double py(const Point3 &p) const { return y - scale * dot(p, up); }
};

struct Face {
    double depth;
    std::string path;
};

/// The part of a polygon on one side of the level: sign 1 above it, -1 below.
std::vector<Point3> part(const std::vector<Point3> &polygon, double level, double sign) {
    std::vector<Point3> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Point3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const double from = sign * (a[2] - level), to = sign * (b[2] - level);
        if (from >= 0) {
            kept.push_back(a);
        }
        if ((from < 0) != (to < 0)) {
            kept.push_back(a + (from / (from - to)) * (b - a));
        }
    }
    return kept;
}

void shade(const View &view, const gusset::Sheet &sheet, double tolerance, double level, bool painted, std::vector<Face> &out) {
    const Point3 light = unit(0.55 * view.right + -0.15 * view.right + 0.9 * view.eye + 0.75 * Point3{0, 0, 1});
    const std::array<double, 3> above{58, 92, 130}, below{168, 66, 48}, plank{214, 202, 176};
    gusset::SheetMeshOptions options;
    options.tolerance = tolerance;
    options.least_u = options.least_v = 2;
    const gusset::SheetMesh made(sheet, options);
    const gusset::MeshView mesh = made.mesh();
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        std::vector<Point3> corners;
        Point3 normal{};
        for (uint32_t v : mesh.face(f)) {
            corners.push_back(mesh.position(v));
            normal = normal + made.normals()[v];
        }
        normal = unit(normal);
        const Point3 flat = cross(corners[2] - corners[0], corners.back() - corners[1]);
        if (dot(flat, view.eye) <= 0) {
            continue; // Seen from within.
        }
        const double lit = 0.42 + 0.58 * std::max(0.0, dot(normal, light));
        for (double sign : {-1.0, 1.0}) {
            if (!painted && sign < 0) {
                continue;
            }
            const std::vector<Point3> polygon = painted ? part(corners, level, sign) : corners;
            if (polygon.size() < 3) {
                continue;
            }
            Face face{0, {}};
            std::ostringstream path;
            path << std::fixed << std::setprecision(1) << "d='";
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                path << (k == 0 ? "M" : " ") << view.px(polygon[k]) << ' ' << view.py(polygon[k]);
                face.depth += dot(polygon[k], view.eye) / static_cast<double>(polygon.size());
            }
            const std::array<double, 3> &paint = !painted ? plank : sign > 0 ? above : below;
            std::ostringstream colour;
            colour << '#' << std::hex << std::setfill('0');
            for (double channel : paint) {
                colour << std::setw(2) << static_cast<int>(std::clamp(std::lround(channel * lit / 4) * 4L, 0L, 255L));
            }
            path << "Z' fill='" << colour.str() << "' stroke='" << colour.str() << "'/>\n";
            face.path = path.str();
            out.push_back(std::move(face));
        }
    }
}

/// Draws those parts of curves that nothing hides.
void draw_seen(std::ostream &svg, const View &view, const SurfacePaths &paths, const std::vector<gusset::Carcass> &solid, double reach) {
    std::vector<gusset::Line> rays;
    for (const gusset::SurfacePath &path : paths) {
        for (std::size_t k = 0; k < path.size(); ++k) {
            // A little towards the eye and out of the surface.
            rays.push_back(gusset::Line::ray(path.points[k] + reach * (view.eye + path.normals[k]), view.eye));
        }
    }
    std::vector<bool> hidden(rays.size(), false);
    for (const gusset::Carcass &carcass : solid) {
        const std::vector<gusset::Hit> hits = carcass.first_hits(rays);
        for (std::size_t k = 0; k < hits.size(); ++k) {
            hidden[k] = hidden[k] || hits[k].is_found();
        }
    }
    std::size_t first = 0;
    for (const gusset::SurfacePath &path : paths) {
        const std::size_t count = path.size();
        double last_x = 0, last_y = 0;
        bool down = false, any = false;
        for (std::size_t k = 0; k < count + (path.closed ? 1 : 0); ++k) {
            const std::size_t at = k % count;
            const double x = view.px(path.points[at]), y = view.py(path.points[at]);
            if (hidden[first + at]) {
                down = false;
            } else if (!down) {
                svg << (any ? "M" : "<path d='M") << x << ' ' << y;
                down = any = true;
                last_x = x;
                last_y = y;
            } else if (std::hypot(x - last_x, y - last_y) > 2 || k + 1 >= count || hidden[first + (k + 1) % count]) {
                svg << 'L' << x << ' ' << y;
                last_x = x;
                last_y = y;
            }
        }
        svg << (any ? "'/>\n" : "");
        first += count;
    }
}

void write_view(std::ostream &svg, const Hull &hull, const std::vector<gusset::Carcass> &solid, const Lines &lines, double draught) {
    const double length = lines.high[0] - lines.low[0];
    const Point3 centre{0.5 * (lines.low[0] + lines.high[0]), 0, 0.5 * (lines.low[2] + lines.high[2])};
    const View views[] = {View({0.62, 0.72, 0.3}, centre, 480, 165, 860 / length), View({-0.6, 0.72, -0.28}, centre, 480, 445, 860 / length)};
    svg << std::fixed << std::setprecision(1) << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 960 610' stroke-linejoin='round' "
        << "stroke-linecap='round' font-family='Helvetica,Arial,sans-serif'>\n<defs><linearGradient id='sky' x2='0' y2='1'><stop stop-color='#fbfcfd'/>"
        << "<stop offset='1' stop-color='#dfe7ee'/></linearGradient></defs>\n<rect width='100%' height='100%' fill='url(#sky)'/>\n";
    const double levels[] = {draught};
    const auto chord = gusset::Between::chord(1e-4 * length);
    for (const View &view : views) {
        std::vector<Face> faces;
        for (const auto *pieces : {&hull.port, &hull.starboard, &hull.transom, &hull.decks}) {
            for (const gusset::Sheet &sheet : *pieces) {
                shade(view, sheet, 4e-4 * length, draught, pieces != &hull.decks, faces);
            }
        }
        std::stable_sort(faces.begin(), faces.end(), [](const Face &a, const Face &b) { return a.depth < b.depth; });
        svg << "<g stroke-width='0.7'>\n";
        for (const Face &face : faces) {
            svg << "<path " << face.path;
        }
        svg << "</g>\n<g fill='none'>\n";
        for (std::size_t k = 0; k < 2; ++k) { // Port and starboard.
            const gusset::Carcass &side = solid[k];
            svg << "<g stroke='#ffffff' stroke-opacity='0.38' stroke-width='0.7'>\n";
            draw_seen(svg, view, side.sections({0, 0, 0}, {1, 0, 0}, lines.places, chord), solid, 2e-4 * length);
            draw_seen(svg, view, side.sections({0, 0, 0}, {0, 0, 1}, lines.heights, chord), solid, 2e-4 * length);
            svg << "</g>\n<g stroke='#ffffff' stroke-width='1.8'>\n";
            draw_seen(svg, view, side.sections({0, 0, 0}, {0, 0, 1}, levels, chord), solid, 2e-4 * length);
            svg << "</g>\n<g stroke='#14202b' stroke-width='1.6'>\n";
            draw_seen(svg, view, side.silhouette(view.eye, chord), solid, 2e-4 * length);
            svg << "</g>\n";
        }
        svg << "</g>\n<g stroke='" << mark_ink << "' stroke-width='1.1' fill='" << mark_ink << "'>\n";
        for (std::size_t k = 0; k < lines.outside.size(); ++k) {
            const gusset::Closest &found = lines.nearest[k];
            const Point3 at{found.point[0], found.point[1], found.point[2]}, from = lines.outside[k];
            svg << "<path d='M" << view.px(from) << ' ' << view.py(from) << 'L' << view.px(at) << ' ' << view.py(at) << "'/><circle r='2.4' cx='"
                << view.px(at) << "' cy='" << view.py(at) << "'/><circle r='2.8' fill='#fff' cx='" << view.px(from) << "' cy='" << view.py(from)
                << "'/>\n";
        }
        svg << "</g>\n";
    }
    svg << "</svg>\n";
}
} // namespace

int main(int argc, char **argv) try {
    CLI::App app("Draws the lines plan of a ship's hull from its stations, and a view of it.");
    std::string input = "-", plan = "hull.svg", picture = "hull_view.svg";
    std::vector<std::string> names{"station_i", "waterline_j", "x_m", "y_half_breadth_m", "z_m"};
    Request request;
    app.add_option("stations", input, "a CSV file, or - for a hull by formula");
    app.add_option("plan", plan, "the SVG file of the lines plan");
    app.add_option("view", picture, "the SVG file of the view");
    app.add_option("--columns", names, "the names of the five columns")->delimiter(',')->expected(5);
    app.add_option("--waterlines", request.waterlines, "how many waterlines")->check(CLI::Range(1, 100));
    app.add_option("--buttocks", request.buttocks, "how many buttocks")->check(CLI::Range(1, 100));
    app.add_option("--stations", request.stations, "how many parts the stations make of the length")->check(CLI::Range(2, 200));
    app.add_option("--draught", request.draught, "the height of the design waterline; 0: 60 % of the depth");
    CLI11_PARSE(app, argc, argv);

    const std::vector<Station> stations = input == "-" ? formula() : read(input, names);
    if (stations.size() < 6) {
        throw std::runtime_error("too few stations for a surface");
    }
    const Hull hull(stations);
    std::vector<gusset::Carcass> solid;
    for (const auto *pieces : {&hull.port, &hull.starboard, &hull.decks, &hull.transom}) {
        solid.emplace_back(*pieces);
    }
    const gusset::Carcass &port = solid[0];
    const Lines lines = ask(port, request);
    if (request.draught == 0) {
        request.draught = lines.low[2] + 0.6 * (lines.high[2] - lines.low[2]);
    }
    std::cout << stations.size() << " stations, " << port.info().cell_count << " cells on each side\n"
              << lines.waterlines.size() << " curves of waterlines, " << lines.buttocks.size() << " of buttocks, " << lines.stations.size()
              << " of stations\n";
    for (std::size_t k = 0; k < lines.nearest.size(); ++k) {
        const gusset::Closest &found = lines.nearest[k];
        std::cout << "nearest point " << static_cast<char>('a' + k) << ": " << found.distance << " m, " << (found.is_proven() ? "" : "not ")
                  << "proved\n";
    }
    std::ofstream plan_file(plan), picture_file(picture);
    write_plan(plan_file, hull, lines, request);
    write_view(picture_file, hull, solid, lines, request.draught);
    if (!plan_file.flush() || !picture_file.flush()) {
        throw std::runtime_error("cannot write " + plan + " or " + picture);
    }
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
