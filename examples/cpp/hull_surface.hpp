// The surfaces of a hull, drawn through its stations.
#pragma once

#include <gusset.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ship {
using gusset::Point3;
using gusset::SurfacePaths;
using Station = std::vector<Point3>;

inline Point3 operator+(const Point3 &a, const Point3 &b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point3 operator-(const Point3 &a, const Point3 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point3 operator*(double s, const Point3 &a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point3 &a, const Point3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point3 cross(const Point3 &a, const Point3 &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point3 unit(const Point3 &a) { return (1 / std::sqrt(std::max(dot(a, a), 1e-300))) * a; }

/// Samples a smooth curve through points at this many equal steps.
inline Station faired(const Station &points, int count) {
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
    const gusset::Places even = outline.curve_copy().sample(gusset::SampleRule::count, count);
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
inline gusset::Sheet side(std::vector<Station> stations, bool port) {
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
inline gusset::Sheet deck(const std::vector<Point3> &rail) {
    std::vector<Point3> nodes;
    for (const Point3 &p : rail) {
        for (int k = -3; k <= 3; ++k) {
            const double s = k / 3.0;
            // Forward and to port: seen from above.
            nodes.push_back({p[0], s * p[1], p[2] + 0.06 * p[1] * (1 - s * s)});
        }
    }
    return gusset::Sheet::from_nodes(rail.size(), 7, nodes);
}

/// The flat end of the hull at its first station.
inline gusset::Sheet stern(const Station &station) {
    std::vector<Point3> nodes;
    for (const Point3 &p : station) {
        for (int k = -3; k <= 3; ++k) {
            nodes.push_back({p[0], k / 3.0 * p[1], p[2]}); // Upwards and to port: seen from behind.
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
        // A stern as sharp as the stem has none.
        if (std::any_of(stations[0].begin(), stations[0].end(), [](const Point3 &p) { return p[1] > 0; })) {
            transom.push_back(stern(faired(stations[0], columns)));
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
            // Points without breadth below the others are in front of the stem.
            while (high.size() > 1 && high[0][1] <= 0 && high[1][1] <= 0) {
                high.erase(high.begin());
            }
            if (!high.empty()) {
                above.push_back(high);
            }
        }
        add(below);
        add(above);
        transom.push_back(stern(faired(above[0], columns)));
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
} // namespace ship
