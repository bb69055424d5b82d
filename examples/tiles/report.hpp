// The results of all ranks, and their checks.
#pragma once

#include "run.hpp"

#include <iomanip>
#include <iostream>

namespace tiles {
/// The report of a rank to the first rank, beside the records of its tiles.
struct RankReport {
    uint64_t tiles = 0;
    double peak_megabytes = 0, disk_megabytes = 0;
    Seconds whole;
    std::array<Seconds, stage_count> stages{};
};

/// The sums over all tiles; their hashes in the order of the tiles make the whole's.
struct Totals {
    uint64_t vertices = 0, edges = 0, faces = 0;
    uint64_t seams = 0, junctions = 0, seam_faces = 0, seam_bytes = 0, max_seam_bytes = 0, corner_bytes = 0;
    EdgeSums sums;
    Cleaned cleaned;
    Hash hash;

    void add(const TileRecord &tile) {
        vertices += tile.vertices;
        edges += tile.edges;
        faces += tile.faces;
        seams += tile.seams;
        junctions += tile.junctions;
        seam_faces += tile.seam_faces;
        seam_bytes += tile.seam_bytes;
        max_seam_bytes = std::max(max_seam_bytes, tile.max_seam_bytes);
        corner_bytes += tile.corner_bytes;
        sums.forth += tile.sums.forth;
        sums.back += tile.sums.back;
        cleaned.soup_faces += tile.cleaned.soup_faces;
        cleaned.turned += tile.cleaned.turned;
        cleaned.dropped += tile.cleaned.dropped;
        hash.add(tile.hash);
    }
    int64_t euler() const { return static_cast<int64_t>(vertices - edges + faces); }
};

/// Prints it all. Returns whether what must hold does.
inline bool report(const Options &options, const std::vector<TileRecord> &records, const std::vector<RankReport> &ranks) {
    const Plan &plan = options.plan;
    Totals sum;
    for (const TileRecord &record : records) {
        sum.add(record);
    }
    std::cout << "plan: " << plan.rows << " x " << plan.columns << " tiles of " << plan.cells << " x " << plan.cells << " cells, "
              << (plan.gap ? plan.mixed ? "apart, of two finenesses" : "apart" : "with coincident rims") << "; " << ranks.size()
              << (ranks.size() == 1 ? " rank, " : " ranks, ")
              << (options.in_memory < 0 ? "all blocks" : std::to_string(options.in_memory) + (options.in_memory == 1 ? " block" : " blocks"))
              << " in memory\n"
              << "input: " << sum.cleaned.soup_faces << " faces of soups, " << sum.cleaned.turned << " turned over, "
              << sum.cleaned.dropped << " dropped\n"
              << "whole: " << sum.vertices << " vertices, " << sum.edges << " edges, " << sum.faces
              << " faces, Euler characteristic " << sum.euler() << "\n"
              << "seams: " << sum.seams << " seams, " << sum.junctions << " junctions, " << sum.seam_faces << " faces; "
              << sum.max_seam_bytes << " bytes a seam at most, " << sum.seam_bytes << " for all, " << sum.corner_bytes
              << " for junctions\n"
              << "ids: " << options.first_id << " to " << options.first_id + sum.vertices - 1 << "\n";
    bool holds = true;
    const auto hold = [&](bool so, const std::string &what) {
        if (!so) {
            std::cerr << "does not hold: " << what << '\n';
            holds = false;
        }
    };
    std::cout << std::fixed;
    for (std::size_t r = 0; r < ranks.size(); ++r) {
        std::cout << "rank " << r << ": " << ranks[r].tiles << " tiles, " << std::setprecision(1) << ranks[r].peak_megabytes
                  << " MB of memory at the peak, " << ranks[r].disk_megabytes << " MB on disk\n" << std::setprecision(2);
        for (const auto &[clock, field] : {std::pair("elapsed", &Seconds::elapsed), std::pair("processor", &Seconds::processor)}) {
            std::cout << "  " << clock << ' ' << ranks[r].whole.*field << " s:";
            for (std::size_t s = 0; s < stage_count; ++s) {
                std::cout << ' ' << stage_names[s] << ' ' << ranks[r].stages[s].*field;
            }
            std::cout << '\n';
        }
        hold(options.max_megabytes <= 0 || ranks[r].peak_megabytes <= options.max_megabytes,
             "rank " + std::to_string(r) + " needs no more memory than was allowed");
    }
    std::cout << "hash: " << hexadecimal(sum.hash.value()) << std::endl;
    hold(sum.seams == 2 * uint64_t{plan.count()}, "each seam is computed once");
    hold(sum.junctions == plan.count(), "each junction is computed once");
    hold(sum.sums.forth == sum.sums.back, "each edge is run once in each direction");
    hold(2 * sum.edges == 3 * sum.faces, "each edge has two faces");
    hold(sum.euler() == 0, "the whole is a torus");
    hold(sum.max_seam_bytes <= packet_bytes(plan.cells + 1), "a seam takes one packet");
    return holds;
}
} // namespace tiles
