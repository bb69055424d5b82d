// Range images, as scanners write them into PLY files: a grid of rows and columns, each with a vertex or none.
#pragma once

#include "../mesh.hpp"

/// Where nothing was seen.
constexpr uint32_t unseen = UINT32_MAX;

/// Adds the triangles between neighbours of a grid of vertices. Those with an edge of more than four times the median
/// length lead from one surface to another behind it, and are left out.
void add_range_faces(Mesh &mesh, const std::vector<uint32_t> &grid, std::size_t columns);
