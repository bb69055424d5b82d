// Takes a band of faces out of a closed mesh, so that two open shells remain.
#pragma once

#include "host.hpp"

#include <cstdint>
#include <optional>
#include <vector>

/// The faces between two planes, of which only those that hang together with the nearest one to a point.
struct Band {
    HostMesh::Point point, normal;
    double width;
};

struct Cut {
    /// The larger shell, the smaller one, and what was between them.
    HostMesh left, right, removed;
    /// Of each face of the mesh which of the three has it: 0, 1 or 2.
    std::vector<uint8_t> part;
};

/// Nothing unless the band parts the mesh into two shells with one boundary loop each; specks beside them go with the band.
std::optional<Cut> cut_in_two(const HostMesh &mesh, const Band &band);
