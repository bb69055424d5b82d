// Distances to a mesh, lines through it and plane sections of it by CGAL.
#pragma once

#include <gusset.hpp>

#include <memory>
#include <vector>

/// One component of a section.
struct Slice {
    bool closed = false;
    double length = 0;
};

/// A closed or open mesh of triangles or quads, which are cut into triangles.
class Oracle {
public:
    explicit Oracle(const gusset::MeshView &mesh);
    ~Oracle();
    double distance(const gusset::Point3 &query) const;
    /// By rising t; the line is origin + t * direction.
    std::vector<double> crossings(const gusset::Point3 &origin, const gusset::Point3 &direction) const;
    /// Longest first.
    std::vector<Slice> slices(const gusset::Point3 &point, const gusset::Point3 &normal) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};
