// Random pairs of rims that face each other, and random ways of joining them.
#pragma once

#include "pieces.hpp"

namespace campaign {
struct Rims {
    Soup a, b;
    /// The vertices of the rims.
    std::vector<uint32_t> rim_a, rim_b;
};
/// Two tubes or caps, one over the other, of different counts, with noise.
Rims random_rims(Random &random, bool triangles);
/// All but the extent, which is whole loops, and the intersections.
gusset::StitchOptions random_stitch_options(Random &random);
gusset::FillOptions random_fill_options(Random &random);
} // namespace campaign
