// The input of a tile: a soup of triangles with defects, by formula or from a binary STL file.
#pragma once

#include "plan.hpp"

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace tiles {
/// Three points for each triangle; nothing says which are the same.
using Soup = std::vector<PointF>;

/// The triangles of a tile: about one in 128 is reversed, and about one in 500 has two equal corners.
inline Soup soup_by_formula(const Plan &plan, uint32_t tile) {
    const TileGrid grid(plan, tile);
    const uint32_t n = plan.segments(tile);
    Soup soup;
    soup.reserve(std::size_t{n} * n * 6 + std::size_t{n} * n / 40 + 64);
    for (uint32_t j = 0; j < n; ++j) {
        for (uint32_t i = 0; i < n; ++i) {
            const std::array<PointF, 4> p{grid.point(j, i), grid.point(j, i + 1), grid.point(j + 1, i + 1), grid.point(j + 1, i)};
            const uint64_t chance = mixed_bits((uint64_t{tile} << 32) ^ (uint64_t{j} * n + i));
            const bool turned = chance % 64 == 0;
            for (const std::size_t k : std::array<std::size_t, 6>{0, turned ? 2u : 1u, turned ? 1u : 2u, 0, 2, 3}) {
                soup.push_back(p[k]);
            }
            if (chance % 256 == 1) {
                soup.insert(soup.end(), {p[0], p[1], p[0]});
            }
        }
    }
    return soup;
}

inline std::string tile_file(const std::string &folder, uint32_t tile, const char *ending) {
    char name[32];
    std::snprintf(name, sizeof name, "tile_%06u.%s", tile, ending);
    return (std::filesystem::path(folder) / name).string();
}

struct CloseFile {
    void operator()(std::FILE *file) const noexcept { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// A binary STL file: 80 bytes of comment, a count, and for each face a normal, three points and two bytes.
constexpr std::size_t stl_header_bytes = 80, stl_face_bytes = 50;

inline Soup soup_of_file(const std::string &name) {
    const File file(std::fopen(name.c_str(), "rb"));
    char header[stl_header_bytes];
    uint32_t count = 0;
    if (!file || std::fread(header, 1, sizeof header, file.get()) != sizeof header ||
        std::fread(&count, sizeof count, 1, file.get()) != 1) {
        throw std::runtime_error("cannot read " + name);
    }
    if (std::filesystem::file_size(name) != sizeof header + sizeof count + std::uintmax_t{count} * stl_face_bytes) {
        throw std::runtime_error(name + " is no binary STL file, or is cut short");
    }
    Soup soup(std::size_t{count} * 3);
    std::vector<char> faces(stl_face_bytes * 4096);
    for (std::size_t first = 0; first < count; first += 4096) {
        const std::size_t now = std::min<std::size_t>(4096, count - first);
        if (std::fread(faces.data(), stl_face_bytes, now, file.get()) != now) {
            throw std::runtime_error("cannot read " + name);
        }
        for (std::size_t f = 0; f < now; ++f) {
            std::memcpy(soup.data() + 3 * (first + f), faces.data() + stl_face_bytes * f + sizeof(PointF), 3 * sizeof(PointF));
        }
    }
    return soup;
}

inline void save_soup(const Soup &soup, const std::string &name) {
    File file(std::fopen(name.c_str(), "wb"));
    const char header[stl_header_bytes] = "tile";
    const auto count = static_cast<uint32_t>(soup.size() / 3);
    bool good = file && std::fwrite(header, 1, sizeof header, file.get()) == sizeof header &&
                std::fwrite(&count, sizeof count, 1, file.get()) == 1;
    for (std::size_t f = 0; good && f < count; ++f) {
        char face[stl_face_bytes] = {};
        std::memcpy(face + sizeof(PointF), soup.data() + 3 * f, 3 * sizeof(PointF));
        good = std::fwrite(face, 1, sizeof face, file.get()) == sizeof face;
    }
    if (!good || std::fclose(file.release()) != 0) {
        throw std::runtime_error("cannot write " + name);
    }
}
} // namespace tiles
