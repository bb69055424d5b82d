// The lines plan of a hull: profile, half-breadth plan, body plan.
#pragma once

#include "hull_surface.hpp"

#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>

namespace ship {
inline const char *const ink = "#28323c", *const faint = "#c9d1d8", *const station_ink = "#a8481c", *const water_ink = "#1f6fb2",
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
inline std::vector<gusset::Curve> borders(const gusset::Sheet &sheet) {
    const gusset_sheet_report size = sheet.report();
    std::vector<gusset::Curve> found;
    for (double end : {0.0, 1.0}) {
        found.push_back(sheet.curve(gusset::SheetDirection::rows, end * static_cast<double>(size.rows)));
        found.push_back(sheet.curve(gusset::SheetDirection::columns, end * static_cast<double>(size.columns)));
    }
    return found;
}

/// n numbers from a to b, without a and b.
inline std::vector<double> between(double a, double b, int n) {
    std::vector<double> found;
    for (int k = 1; k <= n; ++k) {
        found.push_back(a + (b - a) * k / (n + 1));
    }
    return found;
}

inline std::string rounded(double value, int digits) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

struct Request {
    int waterlines = 8, buttocks = 4, stations = 20;
    double draught = 0;
};

/// The drawing.
struct Lines {
    Point3 low, high;
    std::vector<double> heights, halves, places;
    SurfacePaths waterlines, buttocks, stations;
    std::vector<Point3> outside;
    std::vector<gusset::NearestPoint> nearest;
};

inline Lines ask(const gusset::Surface &port, const std::vector<Station> &stations, const Request &request) {
    Point3 low = stations[0][0], high = low;
    for (const Station &station : stations) {
        for (const Point3 &p : station) {
            for (std::size_t k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], p[k]);
                high[k] = std::max(high[k], p[k]);
            }
        }
    }
    const double length = high[0] - low[0], height = high[2] - low[2];
    std::vector<double> heights = between(low[2], high[2], request.waterlines), halves = between(0, high[1], request.buttocks),
                        places = between(low[0], high[0], request.stations - 1);
    gusset::ContourOptions chord;
    chord.chord = 5e-5 * length;
    std::vector<Point3> outside;
    for (double t : {0.06, 0.28, 0.52, 0.75, 0.93}) {
        outside.push_back({low[0] + t * length, 1.25 * high[1], low[2] + (0.15 + 0.65 * std::fmod(3.7 * t, 1.0)) * height});
    }
    std::vector<gusset::NearestPoint> nearest = port.nearest(outside);
    return {low, high, heights, halves, places, port.sections({0, 0, 0}, {0, 0, 1}, heights, chord),
            port.sections({0, 0, 0}, {0, 1, 0}, halves, chord), port.sections({0, 0, 0}, {1, 0, 0}, places, chord), outside, nearest};
}

/// Straight lines of the grid, with their names.
inline void grid(const Plan &plan, const Lines &lines, double margin) {
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
inline void marks(const Plan &plan, const Lines &lines) {
    plan.begin(mark_ink, 0.9);
    for (std::size_t k = 0; k < lines.outside.size(); ++k) {
        const gusset::NearestPoint &found = lines.nearest[k];
        plan.path(std::vector<Point3>{lines.outside[k], {found.point[0], found.point[1], found.point[2]}}, false);
    }
    plan.end();
    for (std::size_t k = 0; k < lines.outside.size(); ++k) {
        const gusset::NearestPoint &found = lines.nearest[k];
        const Point3 at{found.point[0], found.point[1], found.point[2]};
        plan.out << "<circle r='2.1' fill='" << mark_ink << "' cx='" << plan.px(at) << "' cy='" << plan.py(at) << "'/><circle r='2.6' fill='white' stroke='"
                 << mark_ink << "' cx='" << plan.px(lines.outside[k]) << "' cy='" << plan.py(lines.outside[k]) << "'/>\n";
        plan.text(lines.outside[k], 5, -4, std::string(1, static_cast<char>('a' + k)), "font-size='10' font-style='italic' fill='#b0185a'");
    }
}

/// The area of a section below a height, of both sides: of station k.
inline double area(const Lines &lines, std::size_t k, double height) {
    double sum = 0;
    for (const gusset::SurfacePath &path : lines.stations) {
        double part = 0;
        for (std::size_t i = 1; path.level == k && i < path.size(); ++i) {
            const Point3 &a = path.points[i - 1], &b = path.points[i];
            part += (std::min(b[2], height) - std::min(a[2], height)) * (a[1] + b[1]);
        }
        sum += std::abs(part);
    }
    return sum;
}

/// The curve of the sections' areas, and its integral, the volume.
inline void areas(std::ostream &svg, const Lines &lines, double draught, double x, double y, double wide, double high) {
    std::vector<double> values;
    double largest = 0, volume = 0;
    const double step = lines.places[0] - lines.low[0];
    for (std::size_t k = 0; k < lines.places.size(); ++k) {
        values.push_back(area(lines, k, draught));
        largest = std::max(largest, values[k]);
        volume += step * values[k];
    }
    const double scale = wide / (lines.high[0] - lines.low[0]);
    svg << "<g fill='none'><path stroke='" << faint << "' d='M" << x << ' ' << y << "h" << wide << "'/>\n<path stroke='" << faint
        << "' stroke-width='0.6' d='";
    for (std::size_t k = 0; k < values.size(); ++k) {
        svg << 'M' << x + scale * (lines.places[k] - lines.low[0]) << ' ' << y << 'v' << -high * values[k] / largest;
    }
    svg << "'/>\n<polyline stroke='" << water_ink << "' stroke-width='1.4' points='";
    for (std::size_t k = 0; k < values.size(); ++k) {
        svg << x + scale * (lines.places[k] - lines.low[0]) << ',' << y - high * values[k] / largest << ' ';
    }
    svg << "'/></g>\n<text x='" << x << "' y='" << y + 18 << "'>areas of stations below the design waterline, up to " << rounded(largest, 1)
        << " m²; volume " << rounded(volume, 0) << " m³</text>\n";
}

/// The borders of the pieces between two places along the ship.
inline void outline(const Plan &plan, const Hull &hull, double from, double to) {
    plan.begin(ink, 1.5);
    for (const gusset::Sheet &sheet : hull.port) {
        for (const gusset::Curve &edge : borders(sheet)) {
            const gusset::Places points = edge.sample(gusset::SampleRule::chord, 1e-4 * (to - from));
            std::vector<Point3> kept;
            std::copy_if(points.points().begin(), points.points().end(), std::back_inserter(kept),
                         [&](const Point3 &p) { return p[0] >= from && p[0] <= to; });
            if (kept.size() > 1) {
                plan.path(kept, false);
            }
        }
    }
    plan.end();
}

inline void write_plan(std::ostream &svg, const Hull &hull, const Lines &lines, const Request &request) {
    const double length = lines.high[0] - lines.low[0], half = lines.high[1], height = lines.high[2] - lines.low[2];
    const double left = 60, wide = 1160, scale = wide / length, body = 400 / (2 * half);
    const double first = 64 + scale * height, second = first + 84, third = second + 1.36 * scale * half + 66 + body * height;
    const double middle = lines.low[0] + 0.5 * length, body_x = left + 200, side = left + 560;
    svg << std::fixed << std::setprecision(1) << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << 2 * left + wide << ' ' << third + 44
        << "' font-family='Helvetica,Arial,sans-serif' stroke-linejoin='round' stroke-linecap='round'>\n<rect width='100%' height='100%' fill='white'/>\n";
    const Plan profile{svg, 0, 2, left - scale * lines.low[0], first + scale * lines.low[2], scale, scale};
    const Plan breadth{svg, 0, 1, left - scale * lines.low[0], second, scale, -scale};
    const Plan aft{svg, 1, 2, body_x, third + body * lines.low[2], -body, body}, fore{svg, 1, 2, body_x, third + body * lines.low[2], body, body};

    grid(profile, lines, 16);
    profile.begin(buttock_ink, 1);
    profile.paths(lines.buttocks);
    profile.end();
    outline(profile, hull, lines.low[0], lines.high[0]);
    marks(profile, lines);

    grid(breadth, lines, -8);
    breadth.begin(water_ink, 1);
    breadth.paths(lines.waterlines);
    breadth.end();
    outline(breadth, hull, lines.low[0], lines.high[0]);
    marks(breadth, lines);

    grid(aft, lines, 16);
    grid(fore, lines, 16);
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
    outline(aft, hull, lines.low[0], middle);
    outline(fore, hull, middle, lines.high[0]);

    const auto title = [&](double x, double y, const char *name, const std::string &more) {
        svg << "<text x='" << x << "' y='" << y << "' font-size='14' fill='" << ink << "' letter-spacing='1.5'>" << name
            << "<tspan dx='14' font-size='11' letter-spacing='0' fill='#56616b'>" << more << "</tspan></text>\n";
    };
    title(left, 34, "PROFILE", "buttocks B and stations 1 to " + std::to_string(lines.places.size()));
    title(left, second - 34, "HALF-BREADTH PLAN", "waterlines W");
    title(left, third - body * height - 20, "BODY PLAN", "aft to the left, forward to the right");
    double y = third - body * height - 20;
    title(side, y, "PARTICULARS", "");
    svg << "<g font-size='12' fill='#3c464f'>\n<text x='" << side << "' y='" << y + 26 << "'>length " << rounded(length, 2) << " m, beam "
        << rounded(2 * half, 2) << " m, depth " << rounded(height, 2) << " m, design draught " << rounded(request.draught - lines.low[2], 2)
        << " m</text>\n";
    y += 62;
    title(side, y, "NEAREST POINTS OF THE HULL", "");
    for (std::size_t k = 0; k < lines.nearest.size(); ++k) {
        const gusset::NearestPoint &found = lines.nearest[k];
        svg << "<text x='" << side << "' y='" << y + 26 + 19 * static_cast<double>(k) << "'><tspan font-style='italic' fill='" << mark_ink << "'>"
            << static_cast<char>('a' + k) << "</tspan><tspan x='" << side + 26 << "'>" << rounded(found.distance, 3) << " m</tspan><tspan x='"
            << side + 110 << "'>at x " << rounded(found.point[0], 2) << ", y " << rounded(found.point[1], 2) << ", z " << rounded(found.point[2], 2)
            << "</tspan></text>\n";
    }
    areas(svg, lines, request.draught, side, third - 4, left + wide - side, std::max(60.0, third - y - 160));
    svg << "</g>\n</svg>\n";
}
} // namespace ship
