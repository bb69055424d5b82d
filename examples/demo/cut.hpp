// Takes a band of faces out of a closed mesh, so that two open shells remain.
#pragma once

#include "host.hpp"

#include <cstdint>
#include <optional>
#include <vector>

/// The faces between two planes that are connected with the face nearest to a point.
struct Band {
    HostMesh::Point point, normal;
    double width;
};

struct Cut {
    /// The larger shell, the smaller shell, and the band between them.
    HostMesh left, right, removed;
    /// For each face of the mesh the part that has it: 0, 1 or 2.
    std::vector<uint8_t> part;
};

/// Nothing unless the band parts the mesh into two shells with one boundary loop each; specks beside them go with the band.
std::optional<Cut> cut_in_two(const HostMesh &mesh, const Band &band);
