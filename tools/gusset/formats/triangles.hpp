// Polygons as triangles, for files that hold nothing else.
#pragma once

#include "../mesh.hpp"

#include <optional>

/// The corner, counted within the face, from which a fan of triangles covers it without folding over; the first such,
/// and the first of all if there is none. `avoid`: a vertex that it must not be at, if another will do.
std::size_t fan_corner(const Mesh &mesh, std::size_t face, std::optional<uint32_t> avoid = std::nullopt);
