// Seams between tiles: strips and corners across gaps, common ids of coincident vertices.
#pragma once

#include "packet.hpp"

namespace tiles {
/// Faces between tiles by global ids, and the number of edges that they add.
struct Seams {
    std::vector<std::array<uint64_t, 3>> faces;
    uint64_t edges = 0;
    uint32_t count = 0, junctions = 0;
};

/// Points in a row, with their ids.
struct Row {
    std::vector<Point3> points;
    std::vector<uint64_t> ids;
};

/// Adds the strip between two rows side by side; its two ends are its own edges, too.
inline void add_strip(Seams &seams, const Row &a, const Row &b, const gusset::Context &context) {
    //! [strip]
    const gusset::Strip strip(a.points, b.points, {}, context);
    const gusset::MeshView mesh = strip.mesh();
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        std::array<uint64_t, 3> face{};
        for (std::size_t k = 0; k < 3; ++k) {
            const uint32_t v = mesh.face(f)[k];
            face[k] = v < a.ids.size() ? a.ids[v] : b.ids[v - a.ids.size()];
        }
        seams.faces.push_back(face);
    }
    //! [strip]
    const gusset::Check check(mesh, context);
    if (!check.is_manifold() || !check.is_oriented()) {
        throw std::runtime_error("a strip is no oriented manifold");
    }
    seams.edges += check.view().edge_count - (a.ids.size() - 1) - (b.ids.size() - 1);
}

/// The seams that tile `tile` owns, where tiles are apart.
inline Seams strips(const Plan &plan, uint32_t tile, uint64_t first_id, const Rim &rim, const Packets &packets,
                    const gusset::Context &context) {
    Seams seams;
    for (uint32_t k = 0; k < 4; ++k) {
        if (plan.owns_side(tile, k)) {
            Row ours{rim.points[k], {}};
            for (const uint32_t v : rim.vertices[k]) {
                ours.ids.push_back(first_id + v);
            }
            // The neighbour's rim runs the other way.
            const Packet &packet = packets.get(plan.neighbour(tile, k), opposite(k));
            Row theirs{{packet.points.rbegin(), packet.points.rend()}, {}};
            for (std::size_t i = packet.vertices.size(); i-- > 0;) {
                theirs.ids.push_back(packet.id(i));
            }
            add_strip(seams, ours, theirs, context);
            ++seams.count;
        }
        if (plan.junction_owner(tile, k) == tile) {
            // Four corners and the ends of four strips bound a hole; a strip of two rows of two fills it.
            std::array<Row, 2> rows;
            const auto four = plan.junction(tile, k);
            for (std::size_t i = 0; i < 4; ++i) {
                // Against the first row and along the second: corners 1, 0 and 2, 3.
                const TileCorner &at = four[std::array<std::size_t, 4>{1, 0, 2, 3}[i]];
                if (at.tile == tile) {
                    rows[i / 2].points.push_back(rim.points[at.corner].front());
                    rows[i / 2].ids.push_back(first_id + rim.vertices[at.corner].front());
                } else {
                    const Packet &packet = packets.get(at.tile, 4 + at.corner);
                    rows[i / 2].points.push_back(packet.points[0]);
                    rows[i / 2].ids.push_back(packet.id(0));
                }
            }
            add_strip(seams, rows[0], rows[1], context);
            seams.edges -= 2; // its ends are those of strips
            ++seams.junctions;
        }
    }
    return seams;
}

/// The ids of a tile's foreign vertices, where rims coincide.
inline std::vector<uint64_t> foreign_ids(const Plan &plan, uint32_t tile, const Rim &rim, const Packets &packets) {
    constexpr uint64_t unknown = UINT64_MAX;
    std::vector<uint64_t> ids(rim.foreign, unknown);
    const auto learn = [&](uint32_t v, const Point3 &at, const Packet &packet, std::size_t i) {
        if (packet.points[i] != at) {
            throw std::runtime_error("the rim of tile " + std::to_string(packet.header.tile) + " does not coincide with its own");
        }
        if (v >= rim.owned && packet.vertices[i] != not_owned) {
            ids[v - rim.owned] = packet.id(i);
        }
    };
    for (uint32_t k = 0; k < 4; ++k) {
        if (!plan.owns_side(tile, k)) {
            const Packet &packet = packets.get(plan.neighbour(tile, k), opposite(k));
            const std::size_t count = packet.points.size();
            if (count != rim.vertices[k].size()) {
                throw std::runtime_error("the rim of tile " + std::to_string(packet.header.tile) + " has other vertices than its own");
            }
            for (std::size_t i = 0; i < count; ++i) {
                learn(rim.vertices[k][i], rim.points[k][i], packet, count - 1 - i);
            }
        }
        if (plan.junction_owner(tile, k) != tile) {
            for (const TileCorner &at : plan.junction(tile, k)) {
                if (at.tile == plan.junction_owner(tile, k)) {
                    learn(rim.vertices[k].front(), rim.points[k].front(), packets.get(at.tile, 4 + at.corner), 0);
                }
            }
        }
    }
    if (std::find(ids.begin(), ids.end(), unknown) != ids.end()) {
        throw std::runtime_error("a vertex of a coincident rim has no number");
    }
    return ids;
}
} // namespace tiles
