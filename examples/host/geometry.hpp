// Meshes and curves as files hold them and as the plugin reads them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

using Point = std::array<double, 3>;

/// A soup of polygons: face f has the corners offsets[f] to offsets[f + 1] - 1. Nothing is welded, turned over or left
/// out.
struct Mesh {
    std::vector<Point> points;
    std::vector<uint32_t> offsets{0};
    std::vector<uint32_t> corners;
};

/// Polylines: curve c has the points offsets[c] to offsets[c + 1] - 1, and closed[c] is 1 if an edge leads back to the
/// first.
struct Curves {
    std::vector<Point> points;
    std::vector<uint32_t> offsets{0};
    std::vector<uint8_t> closed;
};
