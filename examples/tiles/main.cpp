// Joins a torus of tiles, each a soup of triangles, to one closed mesh with global 64-bit ids. No rank has the whole
// mesh: tiles are DIY blocks over MPI ranks, and most may be on disk.
//   mpirun -n 4 tiles --tiles 8 8 --cells 500 --gap --in-memory 1 --out folder
#include "report.hpp"

#include <CLI/CLI.hpp>

namespace {
using namespace tiles;

Options parsed(CLI::App &app, int argc, char **argv) {
    Options options;
    std::vector<uint32_t> tiles{options.plan.rows, options.plan.columns};
    app.add_option("--tiles", tiles, "rows and columns of tiles, at least 2 each")->expected(2);
    app.add_option("--cells", options.plan.cells, "cells along each side of a tile; a cell is two faces");
    app.add_flag("--gap", options.plan.gap, "tiles are apart by one cell; else their rims coincide");
    app.add_flag("--mixed", options.plan.mixed, "about half of the tiles are half as fine; with --gap");
    app.add_option("--in-memory", options.in_memory, "blocks in memory on each rank, others are on disk; -1: all");
    app.add_option("--scratch", options.scratch, "the folder for blocks on disk");
    app.add_option("--out", options.out, "the folder for finished tiles; else they are only hashed");
    app.add_option("--input", options.input, "the folder of tile_000000.stl and so on; else tiles are made by formula");
    app.add_option("--save-input", options.save_input, "the folder for tiles as STL files before they are cleaned");
    app.add_option("--first-id", options.first_id, "the id of the first vertex");
    app.add_option("--threads", options.threads, "of each rank; 0: as many as the machine has");
    app.add_option("--max-memory", options.max_megabytes, "megabytes that a rank may need, else the status is 1");
    app.parse(argc, argv);
    options.plan.rows = tiles[0];
    options.plan.columns = tiles[1];
    check(options);
    return options;
}

/// Status 0; 1 if something does not hold of the result, or a tile cannot be joined; 2 for wrong arguments.
int joined(const Options &options, const diy::mpi::communicator &world) {
    if (world.rank() == 0) {
        for (const std::string &folder : {options.out, options.save_input}) {
            if (!folder.empty()) {
                std::filesystem::create_directories(folder);
            }
        }
    }
    if (options.in_memory >= 0 && !options.scratch.empty()) {
        // By each rank: it may be on a disk of its own.
        std::filesystem::create_directories(options.scratch);
    }
    world.barrier();
    const Seconds begin = Seconds::now();
    const Outcome outcome = run(options, world);
    RankReport mine;
    mine.tiles = outcome.tiles.size();
    mine.peak_megabytes = peak_megabytes();
    mine.disk_megabytes = outcome.disk_megabytes;
    mine.whole.add(begin, Seconds::now());
    mine.stages = outcome.watch.stages();

    // O(1) for each tile. Ranks in order have the tiles in order.
    std::vector<std::vector<char>> gathered;
    diy::MemoryBuffer sent;
    diy::save(sent, mine);
    diy::save(sent, outcome.tiles.data(), outcome.tiles.size());
    diy::mpi::gather(world, sent.buffer, gathered, 0);
    int status = 0;
    if (world.rank() == 0) {
        std::vector<RankReport> ranks;
        std::vector<TileRecord> tiles;
        for (std::vector<char> &bytes : gathered) {
            diy::MemoryBuffer from;
            from.buffer.swap(bytes);
            ranks.emplace_back();
            diy::load(from, ranks.back());
            const std::size_t first = tiles.size();
            tiles.resize(first + ranks.back().tiles);
            diy::load(from, tiles.data() + first, ranks.back().tiles);
        }
        status = report(options, tiles, ranks) ? 0 : 1;
    }
    diy::mpi::broadcast(world, status, 0);
    return status;
}
} // namespace

int main(int argc, char **argv) {
    const diy::mpi::environment environment(argc, argv);
    const diy::mpi::communicator world;
    CLI::App app("Joins a torus of tiles to one closed mesh, over MPI ranks and out of core.");
    try {
        Options options;
        try {
            options = parsed(app, argc, argv);
        } catch (const CLI::ParseError &error) {
            if (world.rank() == 0) {
                app.exit(error);
            }
            return error.get_exit_code() == 0 ? 0 : 2;
        } catch (const std::invalid_argument &error) {
            if (world.rank() == 0) {
                std::cerr << error.what() << "\n" << "Run with --help for more information.\n";
            }
            return 2;
        }
        return joined(options, world);
    } catch (const std::exception &error) {
        std::cerr << "tiles: " << error.what() << std::endl;
        if (world.size() > 1) {
            MPI_Abort(world, 1); // the others wait for this rank
        }
        return 1;
    }
}
