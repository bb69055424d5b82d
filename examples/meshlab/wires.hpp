// Polylines in MeshLab: a layer of vertices and edges.
#pragma once

#include <common/ml_document/cmesh.h>

#include <cstdint>
#include <vector>

/// Polylines, as gusset_plugin_curves has them, with doubles.
struct Wires {
    std::vector<double> points;
    std::vector<std::uint32_t> offsets{0};
    std::vector<std::uint8_t> closed;
};

/// The edges of a layer, chained where two of them meet: from ends and junctions first, then the closed ones.
Wires wires(const CMeshO &mesh);

/// Adds polylines to a mesh.
void add_wires(CMeshO &mesh, const Wires &wires);
