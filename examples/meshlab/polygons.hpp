// MeshLab's meshes are of triangles; a polygon is a group of them whose inner edges are marked as faux.
#pragma once

#include <common/ml_document/cmesh.h>

#include <cstdint>
#include <vector>

/// Faces of any degree, as gusset_plugin_mesh has them.
struct Polygons {
    std::vector<std::uint32_t> offsets{0};
    std::vector<std::uint32_t> corners;

    bool operator==(const Polygons &other) const { return offsets == other.offsets && corners == other.corners; }
};

/// The polygons of a mesh, in the order of their first triangles. A group whose outline is not one simple loop stays
/// triangles.
Polygons polygons(const CMeshO &mesh);

/// Adds faces to a mesh that has its vertices, with their positions. True if one of them is no triangle.
bool add_faces(CMeshO &mesh, const Polygons &faces);
