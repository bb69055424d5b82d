// The file of a finished tile, its hash, and the sums that show that all tiles together are closed.
#pragma once

#include "seam.hpp"

namespace tiles {
/// A hash of 64-bit words in order. Each step is one to one, so that a single word that differs always shows.
class Hash {
public:
    void add(uint64_t word) { state_ = mixed_bits(state_ ^ word); }
    uint64_t value() const { return state_; }

private:
    uint64_t state_ = 0;
};

//! [tile]
/// 64 bytes in the machine's order; `vertex_count` times 3 float64 and `face_count` times 3 uint64 follow.
struct TileHeader {
    uint64_t magic = 0x31454c4954545347; // "GSTTILE1"
    uint64_t tile = 0;
    uint64_t first_id = 0; // of the vertices that the tile owns, which are those in the file
    uint64_t vertex_count = 0;
    uint64_t face_count = 0; // faces of the tile, then faces of the seams that it owns
    uint64_t hash = 0;       // of all words but the magic one and this
    uint64_t reserved[2] = {0, 0};
};
//! [tile]
static_assert(sizeof(TileHeader) == 64, "no padding");

inline uint64_t word(double x) {
    uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

inline std::string hexadecimal(uint64_t x) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(x));
    return text;
}

/// The hash of a tile's header, before its vertices and faces follow.
inline Hash hash_of(const TileHeader &header) {
    Hash hash;
    for (const uint64_t w : {header.tile, header.first_id, header.vertex_count, header.face_count}) {
        hash.add(w);
    }
    return hash;
}

/// Sums over half-edges a to b and over the same from b to a. If they are equal, each edge has as many half-edges in
/// one direction as in the other, except in one case of 2^64: the surface is closed and oriented. Sums of tiles add
/// up.
struct EdgeSums {
    uint64_t forth = 0, back = 0;

    void add(const std::array<uint64_t, 3> &face) {
        std::array<uint64_t, 3> mixed{};
        for (std::size_t k = 0; k < 3; ++k) {
            mixed[k] = mixed_bits(face[k]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            forth += mixed_bits(mixed[k] + face[next]);
            back += mixed_bits(mixed[next] + face[k]);
        }
    }
};

/// The record of a finished tile that stays in memory.
struct TileRecord {
    uint64_t first_id = 0, vertices = 0, edges = 0, faces = 0, hash = 0;
    EdgeSums sums;
    uint64_t seams = 0, junctions = 0, seam_faces = 0;
    /// Bytes sent: for seams, the largest of them, and for corners.
    uint64_t seam_bytes = 0, max_seam_bytes = 0, corner_bytes = 0;
    Cleaned cleaned;
};

/// Writes words to a file that has its name only when it is whole; without a folder it only hashes.
class TileFile {
public:
    TileFile(const std::string &folder, const TileHeader &header) : header_(header), hash_(hash_of(header)) {
        if (!folder.empty()) {
            name_ = tile_file(folder, static_cast<uint32_t>(header.tile), "bin");
            file_.reset(std::fopen((name_ + ".part").c_str(), "wb"));
            if (!file_ || std::fwrite(&header, sizeof header, 1, file_.get()) != 1) {
                fail();
            }
        }
        buffer_.reserve(buffer_words);
    }
    void add(uint64_t w) {
        hash_.add(w);
        if (file_) {
            buffer_.push_back(w);
            if (buffer_.size() == buffer_words) {
                flush();
            }
        }
    }
    /// The hash, when the file is whole.
    uint64_t finish() {
        header_.hash = hash_.value();
        if (file_) {
            flush();
            if (std::fseek(file_.get(), 0, SEEK_SET) != 0 || std::fwrite(&header_, sizeof header_, 1, file_.get()) != 1 ||
                std::fclose(file_.release()) != 0) {
                fail();
            }
            std::filesystem::rename(name_ + ".part", name_);
        }
        return header_.hash;
    }

private:
    static constexpr std::size_t buffer_words = 1 << 16;
    void flush() {
        if (std::fwrite(buffer_.data(), sizeof(uint64_t), buffer_.size(), file_.get()) != buffer_.size()) {
            fail();
        }
        buffer_.clear();
    }
    [[noreturn]] void fail() const { throw std::runtime_error("cannot write " + name_); }

    TileHeader header_;
    Hash hash_;
    std::string name_;
    File file_;
    std::vector<uint64_t> buffer_;
};

/// Writes a tile with the faces of its seams; `foreign` has the ids of vertices that others own.
inline void write_tile(const std::string &folder, uint32_t tile, const Mesh &mesh, uint32_t owned, const std::vector<uint64_t> &foreign,
                       const Seams &seams, TileRecord &record) {
    TileHeader header;
    header.tile = tile;
    header.first_id = record.first_id;
    header.vertex_count = record.vertices = owned;
    header.face_count = record.faces = mesh.corners.size() / 3 + seams.faces.size();
    TileFile file(folder, header);
    for (std::size_t v = 0; v < owned; ++v) {
        for (const double x : mesh.points[v]) {
            file.add(word(x));
        }
    }
    const auto put = [&](const std::array<uint64_t, 3> &face) {
        record.sums.add(face);
        for (const uint64_t v : face) {
            file.add(v);
        }
    };
    for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
        std::array<uint64_t, 3> face{};
        for (std::size_t k = 0; k < 3; ++k) {
            const uint32_t v = mesh.corners[c + k];
            face[k] = v < owned ? record.first_id + v : foreign[v - owned];
        }
        put(face);
    }
    for (const auto &face : seams.faces) {
        put(face);
    }
    record.hash = file.finish();
}
} // namespace tiles
