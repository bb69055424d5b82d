// Meshes for the benchmarks: real, open, and of any size.
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

/// A triangle mesh from a file.
Triangles read_triangles(const std::string &path);
/// Without the faces that reach into the slab low < y < high (parts of the height, 0 to 1): jagged rims.
Triangles without_slab(const Triangles &mesh, double low, double high);
/// Each triangle cut into four, `times` times; neighbours stay near each other in memory.
Triangles subdivided(Triangles mesh, int times);
/// Vertices and faces in random order.
Triangles shuffled(const Triangles &mesh);
