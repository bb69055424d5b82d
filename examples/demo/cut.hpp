// Takes a slab of faces out of a closed mesh, so that two open shells with jagged rims remain.
#pragma once

#include "host.hpp"

#include <optional>
#include <utility>

struct Cut {
    HostMesh left, right;
    /// Unit normal of the slab.
    HostMesh::Point normal;
    std::size_t removed;
};

/// The most even cut, of all that leave exactly two shells with one loop each: 13 directions, 21 places along each, slabs of
/// 4 % of the mesh's size. Nothing if there is none.
std::optional<Cut> cut_in_two(const HostMesh &mesh);
