// The whole way of all tiles of this rank, by DIY: blocks in memory or on disk, and what they send each other.
#pragma once

#include "options.hpp"
#include "output.hpp"

#include <vtkdiy2/assigner.hpp>
#include <vtkdiy2/decomposition.hpp>
#include <vtkdiy2/master.hpp>
#include <vtkdiy2/mpi.hpp>

namespace tiles {
/// What a rank has when its tiles are finished, in the order of their numbers.
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
