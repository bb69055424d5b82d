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

/// Pieces of the hull. Each piece has the stations between two heights that all of them reach: where the deck has a step, the hull has
/// two pieces, one above the other.
struct Hull {
    std::vector<gusset::Sheet> port, starboard, decks;

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
