// Distances between meshes, and the direction from which some faces are seen best; both by CGAL's AABB tree.
#pragma once

#include <gusset.hpp>

#include <cstddef>
#include <vector>

struct Distances {
    /// One for each vertex.
    std::vector<double> at;
    /// By area, of points spread over the faces; the largest of those and of the vertices.
    double mean, max;
};

/// The distances of the points of `from` to the nearest points of `to`.
Distances distances(const gusset::MeshView &from, const gusset::MeshView &to);

/// The direction, of many round the y-axis, from which most of the area of the faces from `first` on is seen, foreshortened and
/// not hidden.
gusset::Point3 best_eye(const gusset::MeshView &mesh, std::size_t first);
