#include "soup.hpp"

#include "cgal_soup.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <stdexcept>

using Plain = CGAL::Simple_cartesian<double>;

void Soup::add_face(const std::vector<uint32_t> &face) {
    corners.insert(corners.end(), face.begin(), face.end());
    offsets.push_back(static_cast<uint32_t>(corners.size()));
}

Soup read_soup(const std::string &path) {
    std::vector<Plain::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    if (!CGAL::IO::read_polygon_soup(path, points, faces)) {
        throw std::runtime_error("cannot read " + path);
    }
    Soup soup;
    for (const auto &p : points) {
        soup.points.push_back({p.x(), p.y(), p.z()});
    }
    for (const auto &face : faces) {
        soup.add_face({face.begin(), face.end()});
    }
    return soup;
}

void write_obj(const std::string &path, const gusset::MeshView &mesh) {
    const CgalSoup<Plain::Point_3> soup(mesh);
    if (!CGAL::IO::write_OBJ(path, soup.points, soup.faces, CGAL::parameters::stream_precision(17))) {
        throw std::runtime_error("cannot write " + path);
    }
}

Soup copy_of(const gusset::MeshView &mesh) {
    Soup soup;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        soup.points.push_back(mesh.position(v));
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        soup.add_face({mesh.face(f).begin(), mesh.face(f).end()});
    }
    return soup;
}
