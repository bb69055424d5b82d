// The meshes of the benchmarks, as bench/meshes.py writes them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// Packed triangles: what every library in the comparison starts from.
struct Triangles {
    std::vector<std::array<double, 3>> points;
    std::vector<uint32_t> corners;
    std::size_t face_count() const { return corners.size() / 3; }
};

/// A file of two 64-bit counts, the points and the triangles.
Triangles read_triangles(const std::string &path);

void write_triangles(const Triangles &mesh, const std::string &path);
