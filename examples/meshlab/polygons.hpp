// MeshLab's meshes are of triangles; a polygon is a group of them whose inner edges are marked as faux.
#pragma once

#include <common/ml_document/cmesh.h>

#include <cstdint>
#include <vector>

/// Faces of any degree, as gusset_plugin_mesh has them.
struct Polygons {
    std::vector<std::uint32_t> offsets{0};
    std::vector<std::uint32_t> corners;
    /// For each corner the wedge of a triangle that it is, 3 * triangle + place; only of the polygons of a mesh.
    std::vector<std::uint32_t> wedges;

    /// Whether the faces are the same, whatever triangles they are of.
    bool operator==(const Polygons &other) const { return offsets == other.offsets && corners == other.corners; }
};

/// The triangles that polygons were cut into.
struct Triangles {
    /// For each wedge, three to a triangle, the corner of the polygons that it is.
    std::vector<std::uint32_t> corners;
    /// For each triangle its polygon.
    std::vector<std::uint32_t> faces;
};

/// The polygons of a mesh, in the order of their first triangles. A group whose outline is not one simple loop stays
/// triangles.
Polygons polygons(const CMeshO &mesh);

/// Adds faces to a mesh that has its vertices, with their positions, and no faces.
Triangles add_faces(CMeshO &mesh, const Polygons &faces);
