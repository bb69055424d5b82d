// Meshes in all formats but OBJ are read, and in all of them written, by CGAL as soups of polygons.
#include "failure.hpp"
#include "formats.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>

namespace {
using Position = CGAL::Simple_cartesian<double>::Point_3;
using Positions = std::vector<Position>;
using Faces = std::vector<std::vector<std::size_t>>;
} // namespace

Mesh read_soup(const std::string &path, const std::string &extension) {
    Positions points;
    Faces faces;
    const bool read = extension == ".off"   ? CGAL::IO::read_OFF(path, points, faces)
                      : extension == ".ply" ? CGAL::IO::read_PLY(path, points, faces)
                                            : CGAL::IO::read_STL(path, points, faces);
    if (!read) {
        throw Failure(Exit::file, path + ": cannot be read");
    }
    if (faces.empty()) {
        throw Failure(Exit::file, path + ": it has no faces");
    }
    Mesh mesh;
    for (const Position &p : points) {
        mesh.points.push_back({p.x(), p.y(), p.z()});
    }
    for (const auto &face : faces) {
        for (const std::size_t corner : face) {
            mesh.corners.push_back(static_cast<uint32_t>(corner));
        }
        mesh.offsets.push_back(static_cast<uint32_t>(mesh.corners.size()));
    }
    return mesh;
}

void write_soup(const std::string &path, const std::string &extension, const Mesh &mesh) {
    Positions points;
    for (const Point &p : mesh.points) {
        points.emplace_back(p[0], p[1], p[2]);
    }
    Faces faces;
    for (std::size_t f = 0; f + 1 < mesh.offsets.size(); ++f) {
        faces.emplace_back(mesh.corners.begin() + mesh.offsets[f], mesh.corners.begin() + mesh.offsets[f + 1]);
    }
    if (extension == ".stl" &&
        std::any_of(faces.begin(), faces.end(), [](const auto &face) { return face.size() != 3; })) {
        throw Failure(Exit::file, path + ": STL files hold triangles, and this mesh has other faces");
    }
    const auto digits = CGAL::parameters::stream_precision(17);
    const bool written = extension == ".obj"   ? CGAL::IO::write_OBJ(path, points, faces, digits)
                         : extension == ".off" ? CGAL::IO::write_OFF(path, points, faces, digits)
                         : extension == ".ply" ? CGAL::IO::write_PLY(path, points, faces)
                                               : CGAL::IO::write_STL(path, points, faces);
    if (!written) {
        throw Failure(Exit::file, path + ": cannot be written");
    }
}
