// The stations of a hull: from a table of offsets, or by formula.
#pragma once

#include "hull_surface.hpp"

#include <csv.h>

#include <map>
#include <string>
#include <vector>

namespace ship {
/// From a table of offsets in a CSV file, whose columns have these names; see hull.cpp.
inline std::vector<Station> read(const std::string &file, const std::vector<std::string> &names) {
    io::CSVReader<5> rows(file);
    rows.read_header(io::ignore_extra_column, names[0], names[1], names[2], names[3], names[4]);
    std::map<int, std::map<int, Point3>> table;
    int station = 0, waterline = 0;
    double x = 0, z = 0;
    for (std::string y; rows.read_row(station, waterline, x, y, z);) {
        std::size_t read = 0;
        if (!y.empty()) {
            table[station][waterline] = {x, std::stod(y, &read), z};
        }
        if (read != y.size()) {
            throw std::runtime_error(file + ": no half-breadth: " + y);
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
inline std::vector<Station> formula() {
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
} // namespace ship
