// Properties of a mesh by CGAL.
#pragma once

#include <gusset.hpp>

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

struct Verdict {
    /// Two-manifold and consistently oriented: CGAL takes the faces as a polygon mesh. The
    /// other members are valid only then.
    bool is_mesh = false;
    bool closed = false;
    /// Closed, without self-intersections, faces outwards.
    bool bounds_a_volume = false;
    std::size_t components = 0;
    /// The number of edges of each boundary cycle, longest first.
    std::vector<std::size_t> boundary;
    /// Pairs of triangles that intersect (polygons are cut into triangles).
    std::size_t self_intersections = 0;
    long euler = 0;
};

/// `intersections`: count them too, which is slow for large meshes.
Verdict judge(const gusset::MeshView &mesh, bool intersections = true);

/// Pairs of triangles that intersect for CGAL, the larger number first, one of them at least among
/// `new_count` faces from `first_new` on. Throws std::invalid_argument if the mesh is none for CGAL.
std::set<std::pair<uint32_t, uint32_t>> intersecting_pairs(const gusset::MeshView &mesh, std::size_t first_new, std::size_t new_count);
