#include "run.hpp"

#include "storage.hpp"

namespace tiles {
namespace {
/// A block: the mesh of a tile. DIY moves blocks to disk and back.
struct Block {
    Mesh mesh;

    static void *create() { return new Block; }
    static void destroy(void *block) { delete static_cast<Block *>(block); }
    static void save(const void *block, diy::BinaryBuffer &to) {
        const Mesh &mesh = static_cast<const Block *>(block)->mesh;
        diy::save(to, uint64_t{mesh.points.size()});
        diy::save(to, uint64_t{mesh.corners.size()});
        diy::save(to, mesh.points.data(), mesh.points.size());
        diy::save(to, mesh.corners.data(), mesh.corners.size());
    }
    static void load(void *block, diy::BinaryBuffer &from) {
        Mesh &mesh = static_cast<Block *>(block)->mesh;
        uint64_t points = 0, corners = 0;
        diy::load(from, points);
        diy::load(from, corners);
        mesh.points.resize(points);
        mesh.corners.resize(corners);
        diy::load(from, mesh.points.data(), points);
        diy::load(from, mesh.corners.data(), corners);
    }
};

/// Messages that wait for the exchange stay in memory. Putting them on disk, DIY steps past the end
/// of a block's queues that go to its own rank and to others, and may never come back.
struct Queues : diy::Master::QueueSizePolicy {
    Queues() : QueueSizePolicy(4096) {}
    bool unload_outgoing(const diy::Master &, int, std::size_t) const override { return false; }
};

using Proxy = diy::Master::ProxyWithLink;
using Bounds = diy::DiscreteBounds;

/// The tiles of one rank.
class Tiles {
public:
    Tiles(const Options &options, const diy::mpi::communicator &world)
        : options_(options), plan_(options.plan), world_(world), storage_(options.scratch),
          master_(world_, 1, options.in_memory, &Block::create, &Block::destroy, &storage_, &Block::save, &Block::load,
                  new Queues) { // DIY's to delete
        context_.set_threads(options.threads);
        //! [blocks]
        Bounds domain(2); // one point a tile: x is the column, y the row
        domain.max[0] = static_cast<int>(plan_.columns) - 1;
        domain.max[1] = static_cast<int>(plan_.rows) - 1;
        const diy::ContiguousAssigner assigner(world_.size(), static_cast<int>(plan_.count()));
        const std::vector<bool> shared{false, false}, wrap{true, true};
        const std::vector<int> ghosts{0, 0}, divisions{static_cast<int>(plan_.columns), static_cast<int>(plan_.rows)};
        diy::RegularDecomposer<Bounds> decomposer(2, domain, assigner.nblocks(), shared, wrap, ghosts, divisions);
        decomposer.decompose(world_.rank(), assigner, master_);
        //! [blocks]
        rims_.resize(master_.size());
        outcome_.tiles.resize(master_.size());
    }

    Outcome run() {
        //! [passes]
        each([&](Block *block, const Proxy &proxy) { clean_tile(*block, proxy); });
        number();
        each([&](Block *, const Proxy &proxy) { send_rims(proxy); }, skip_blocks);
        outcome_.watch.start();
        master_.exchange();
        outcome_.watch.lap(Stage::exchange);
        each([&](Block *block, const Proxy &proxy) { finish_tile(*block, proxy); });
        //! [passes]
        outcome_.disk_megabytes = static_cast<double>(storage_.max_bytes()) / 1e6;
        return std::move(outcome_);
    }

private:
    static bool skip_blocks(int, const diy::Master &) { return true; }

    /// Calls a function for each block; what lies between calls is DIY's, to and from disk.
    template <class Function>
    void each(Function &&function, const diy::Master::Skip &skip = diy::Master::NeverSkip()) {
        outcome_.watch.start();
        master_.foreach(
            [&](Block *block, const Proxy &proxy) {
                outcome_.watch.lap(Stage::disk);
                try {
                    function(block, proxy);
                } catch (const std::exception &error) {
                    throw std::runtime_error("tile " + std::to_string(proxy.gid()) + ": " + error.what());
                }
            },
            skip);
        outcome_.watch.lap(Stage::disk);
    }

    std::size_t local(const Proxy &proxy) const { return static_cast<std::size_t>(master_.lid(proxy.gid())); }

    void clean_tile(Block &block, const Proxy &proxy) {
        const auto tile = static_cast<uint32_t>(proxy.gid());
        Soup soup = options_.input.empty() ? soup_by_formula(plan_, tile) : soup_of_file(tile_file(options_.input, tile, "stl"));
        if (!options_.save_input.empty()) {
            save_soup(soup, tile_file(options_.save_input, tile, "stl"));
        }
        outcome_.watch.lap(Stage::load);
        clean(plan_, tile, std::move(soup), context_, outcome_.watch, block.mesh, rims_[local(proxy)],
              outcome_.tiles[local(proxy)].cleaned);
    }

    /// Gives each tile the ids of the vertices that it owns, in the order of the tiles, whoever has them.
    void number() {
        //! [number]
        uint64_t here = 0; // blocks of a rank are neighbours in that order, and ranks are, too
        for (const Rim &rim : rims_) {
            here += rim.owned;
        }
        uint64_t up_to_here = 0;
        diy::mpi::scan(world_, here, up_to_here, std::plus<uint64_t>());
        uint64_t next = options_.first_id + up_to_here - here;
        for (std::size_t i = 0; i < rims_.size(); ++i) {
            outcome_.tiles[i].first_id = next;
            next += rims_[i].owned;
        }
        //! [number]
    }

    uint64_t send(const Proxy &proxy, uint32_t to, uint32_t part) {
        const Packet packet = rim_packet(static_cast<uint32_t>(proxy.gid()), outcome_.tiles[local(proxy)].first_id,
                                         rims_[local(proxy)], part);
        const int link = proxy.link()->find(static_cast<int>(to));
        if (link < 0) {
            throw std::runtime_error("tile " + std::to_string(to) + " is no neighbour");
        }
        const diy::BlockID target = proxy.link()->target(link);
        const std::size_t before = proxy.outgoing(target).size();
        proxy.enqueue(target, packet.header);
        proxy.enqueue(target, packet.points.data(), packet.points.size());
        proxy.enqueue(target, packet.vertices.data(), packet.vertices.size());
        return proxy.outgoing(target).size() - before;
    }

    /// Across a gap the owner of a seam needs the other rim; of coincident rims the other needs the owner's ids.
    void send_rims(const Proxy &proxy) {
        const auto tile = static_cast<uint32_t>(proxy.gid());
        TileRecord &record = outcome_.tiles[local(proxy)];
        for (uint32_t k = 0; k < 4; ++k) {
            if (plan_.owns_side(tile, k) != plan_.gap) {
                const uint64_t bytes = send(proxy, plan_.neighbour(tile, k), k);
                record.seam_bytes += bytes;
                record.max_seam_bytes = std::max(record.max_seam_bytes, bytes);
            }
            const uint32_t owner = plan_.junction_owner(tile, k);
            for (const TileCorner &at : plan_.junction(tile, k)) {
                const uint32_t from = plan_.gap ? at.tile : owner, to = plan_.gap ? owner : at.tile;
                if (from == tile && to != tile) {
                    record.corner_bytes += send(proxy, to, 4 + k);
                }
            }
        }
        outcome_.watch.lap(Stage::exchange);
    }

    Packets receive(const Proxy &proxy) {
        Packets packets;
        std::vector<int> senders;
        proxy.incoming(senders);
        for (const int sender : senders) {
            diy::MemoryBuffer &from = proxy.incoming(sender);
            while (from) {
                Packet packet;
                diy::load(from, packet.header);
                packet.points.resize(packet.header.count);
                packet.vertices.resize(packet.header.count);
                diy::load(from, packet.points.data(), packet.points.size());
                diy::load(from, packet.vertices.data(), packet.vertices.size());
                packets.add(std::move(packet));
            }
        }
        return packets;
    }

    void finish_tile(Block &block, const Proxy &proxy) {
        const auto tile = static_cast<uint32_t>(proxy.gid());
        const Rim &rim = rims_[local(proxy)];
        TileRecord &record = outcome_.tiles[local(proxy)];
        const Packets packets = receive(proxy);
        outcome_.watch.lap(Stage::exchange);
        Seams seams;
        std::vector<uint64_t> foreign;
        record.edges = rim.edges;
        if (plan_.gap) {
            seams = strips(plan_, tile, record.first_id, rim, packets, context_);
        } else {
            foreign = foreign_ids(plan_, tile, rim, packets);
            for (uint32_t k = 0; k < 4; ++k) {
                // Edges on a rim belong to the tile that owns the rim.
                if (plan_.owns_side(tile, k)) {
                    ++seams.count;
                } else {
                    record.edges -= rim.vertices[k].size() - 1;
                }
                seams.junctions += plan_.junction_owner(tile, k) == tile;
            }
        }
        record.edges += seams.edges;
        record.seams = seams.count;
        record.junctions = seams.junctions;
        record.seam_faces = seams.faces.size();
        outcome_.watch.lap(Stage::seams);
        write_tile(options_.out, tile, block.mesh, rim.owned, foreign, seams, record);
        block.mesh = Mesh(); // what DIY moves to disk from now on is empty
        outcome_.watch.lap(Stage::write);
    }

    const Options &options_;
    const Plan &plan_;
    diy::mpi::communicator world_;
    Storage storage_;
    diy::Master master_;
    gusset::Context context_;
    std::vector<Rim> rims_;
    Outcome outcome_;
};
} // namespace

Outcome run(const Options &options, const diy::mpi::communicator &world) { return Tiles(options, world).run(); }
} // namespace tiles
