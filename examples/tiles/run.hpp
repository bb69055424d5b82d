// Processes all tiles of this rank by DIY: blocks in memory or on disk, and their messages.
#pragma once

#include "options.hpp"
#include "output.hpp"

#include <vtkdiy2/assigner.hpp>
#include <vtkdiy2/decomposition.hpp>
#include <vtkdiy2/master.hpp>
#include <vtkdiy2/mpi.hpp>

namespace tiles {
/// The results of a rank's tiles, in their order.
struct Outcome {
    std::vector<TileRecord> tiles;
    Stopwatch watch;
    /// Blocks on disk at most, all together.
    double disk_megabytes = 0;
};

/// Cleans, joins and writes the tiles of this rank. All ranks call it. Throws std::runtime_error with the tile that an
/// error is about.
Outcome run(const Options &options, const diy::mpi::communicator &world);
} // namespace tiles
