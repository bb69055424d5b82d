// The rim packet: all that one tile tells another. O(sqrt n) bytes for a tile of n faces.
#pragma once

#include "tile.hpp"

#include <map>

namespace tiles {
/// A vertex of a packet that its sender does not own.
constexpr uint32_t not_owned = UINT32_MAX;

//! [packet]
/// 32 bytes in the machine's order; positions (`count` times 3 float64) and local vertices (`count` uint32) follow.
struct PacketHeader {
    uint32_t magic = 0x314d4952; // "RIM1"
    uint32_t part = 0;           // 0 to 3: a side of the sender; 4 to 7: its corner 0 to 3
    uint64_t tile = 0;           // the sender
    uint64_t first_id = 0;       // the id of local vertex v is first_id + v
    uint32_t count = 0;          // of vertices, along the sender's rim
    uint32_t reserved = 0;
};
//! [packet]
static_assert(sizeof(PacketHeader) == 32, "no padding");
static_assert(sizeof(Point3) == 24, "packed");

constexpr uint64_t packet_bytes(uint64_t vertices) { return sizeof(PacketHeader) + vertices * (sizeof(Point3) + sizeof(uint32_t)); }

struct Packet {
    PacketHeader header;
    std::vector<Point3> points;
    std::vector<uint32_t> vertices;

    /// The id of a vertex in the whole.
    uint64_t id(std::size_t i) const { return header.first_id + vertices[i]; }
};

/// Side `part`, or corner `part` - 4, of a tile.
inline Packet rim_packet(uint32_t tile, uint64_t first_id, const Rim &rim, uint32_t part) {
    Packet packet;
    packet.header.part = part;
    packet.header.tile = tile;
    packet.header.first_id = first_id;
    const std::size_t side = part % 4, count = part < 4 ? rim.vertices[side].size() : 1;
    packet.header.count = static_cast<uint32_t>(count);
    packet.points.assign(rim.points[side].begin(), rim.points[side].begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const uint32_t v = rim.vertices[side][i];
        packet.vertices.push_back(v < rim.owned ? v : not_owned);
    }
    return packet;
}

/// The packets that a tile received, by sender and part.
class Packets {
public:
    void add(Packet &&packet) {
        if (packet.header.magic != PacketHeader().magic || packet.header.part >= 8) {
            throw std::runtime_error("what has been received is no rim packet");
        }
        const auto key = std::make_pair(packet.header.tile, packet.header.part);
        received_[key] = std::move(packet);
    }
    const Packet &get(uint32_t tile, uint32_t part) const {
        const auto found = received_.find({tile, part});
        if (found == received_.end()) {
            throw std::runtime_error("no rim packet from tile " + std::to_string(tile) + " with part " + std::to_string(part));
        }
        return found->second;
    }

private:
    std::map<std::pair<uint64_t, uint32_t>, Packet> received_;
};
} // namespace tiles
