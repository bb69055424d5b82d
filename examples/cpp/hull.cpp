// Draws the lines plan of a ship's hull from its stations, and a view of it with its silhouette:
//   hull stations.csv hull.svg hull_view.svg
//   hull - hull.svg hull_view.svg              (a hull by formula)
// The file is a table of offsets in metres: the columns station_i, waterline_j, x_m, y_half_breadth_m and z_m, a row for each point. x
// goes forward, y to port, z up; y is empty where there is no hull. Stations follow each other from the stern to the bow, the
// points of each from the keel to the deck. Other names of the columns: --columns.
#include "hull_view.hpp"

#include <CLI/CLI.hpp>
#include <csv.h>

#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {
using namespace ship;

std::vector<Station> read(const std::string &file, const std::vector<std::string> &names) {
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
    std::vector<gusset::Surface> solid;
    for (const auto *pieces : {&hull.port, &hull.starboard, &hull.decks, &hull.transom}) {
        solid.emplace_back(*pieces);
    }
    const gusset::Surface &port = solid[0];
    const Lines lines = ask(port, stations, request);
    if (request.draught == 0) {
        request.draught = lines.low[2] + 0.6 * (lines.high[2] - lines.low[2]);
    }
    std::cout << stations.size() << " stations, " << port.report().cell_count << " cells on each side\n"
              << lines.waterlines.size() << " curves of waterlines, " << lines.buttocks.size() << " of buttocks, " << lines.stations.size()
              << " of stations\n";
    for (std::size_t k = 0; k < lines.nearest.size(); ++k) {
        const gusset::NearestPoint &found = lines.nearest[k];
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
