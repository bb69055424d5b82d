// CGAL's own hole filling.
#pragma once

#include "soup.hpp"

#include <cstddef>

/// Pairs of intersecting triangles after CGAL has filled all holes: by triangulate_hole, or by
/// triangulate_refine_and_fair_hole.
std::size_t cgal_fill(const Soup &soup, bool fair);
