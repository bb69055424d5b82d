// A mesh as a list of points and a list of faces, read from files for gusset and for the judges.
#pragma once

#include <gusset.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

struct Soup {
    std::vector<std::array<double, 3>> points;
    std::vector<uint32_t> offsets{0};
    std::vector<uint32_t> corners;

    std::size_t face_count() const { return offsets.size() - 1; }
    void add_face(const std::vector<uint32_t> &face);
    gusset::MeshView view() const { return gusset::MeshView::polygons(points, gusset::Offsets(offsets), gusset::Corners(corners)); }
};

/// The mesh in an OFF, OBJ, PLY or STL file, as CGAL reads it; points of an STL file that are
/// exactly equal are one. Throws std::runtime_error.
Soup read_soup(const std::string &path);
/// Writes an OBJ file. Throws std::runtime_error.
void write_obj(const std::string &path, const gusset::MeshView &mesh);
/// A copy of a result.
Soup copy_of(const gusset::MeshView &mesh);
