// Draws the lines plan of a ship's hull from its stations, and a view with its silhouette:
//   hull stations.csv hull.svg hull_view.svg
//   hull - hull.svg hull_view.svg              (a hull by formula)
// The file is a table of offsets in metres: the columns station_i, waterline_j, x_m, y_half_breadth_m and z_m, a row for each point. x
// goes forward, y to port, z up; y is empty outside the hull. Stations follow each other from the stern to the bow,
// the
// points of each from the keel to the deck. Other names of the columns: --columns.
#include "hull_stations.hpp"
#include "hull_view.hpp"

#include <CLI/CLI.hpp>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

using namespace ship;

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
    return 0;
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
