// OBJ files by tinyobjloader, which reads faces of up to 255 corners and coordinates to some 15 digits.
#include "failure.hpp"
#include "formats.hpp"

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <charconv>
#include <cstddef>
#include <fstream>
#include <iostream>

namespace {
struct Obj {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;

    std::vector<Point> points() const {
        std::vector<Point> all(attributes.vertices.size() / 3);
        for (std::size_t v = 0; v < all.size(); ++v) {
            all[v] = {attributes.vertices[3 * v], attributes.vertices[3 * v + 1], attributes.vertices[3 * v + 2]};
        }
        return all;
    }
};

Obj read_obj(const std::string &path) {
    std::ifstream file(path);
    Obj obj;
    std::vector<tinyobj::material_t> materials;
    std::string warnings, error;
    // Without a reader of materials; and faces stay polygons.
    const bool read = file && tinyobj::LoadObj(&obj.attributes, &obj.shapes, &materials, &warnings, &error, &file,
                                               nullptr, false, false);
    if (!read) {
        throw Failure(Exit::file, path + ": " + (error.empty() ? "cannot be read" : error.substr(0, error.find('\n'))));
    }
    // There may be one for each face.
    if (!warnings.empty()) {
        std::cerr << path << ": " << warnings.substr(0, warnings.find('\n')) << '\n';
    }
    return obj;
}

void write_number(std::ostream &out, double value) {
    char text[32];
    // As many digits as it takes to read the same number.
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    out.write(text, end - text);
}
} // namespace

Mesh read_obj_faces(const std::string &path) {
    const Obj obj = read_obj(path);
    Mesh mesh;
    mesh.points = obj.points();
    for (const tinyobj::shape_t &shape : obj.shapes) {
        std::size_t corners = mesh.corners.size();
        for (const tinyobj::index_t &index : shape.mesh.indices) {
            mesh.corners.push_back(static_cast<uint32_t>(index.vertex_index));
        }
        for (const auto count : shape.mesh.num_face_vertices) {
            corners += count;
            mesh.offsets.push_back(static_cast<uint32_t>(corners));
        }
        if (corners != mesh.corners.size()) {
            throw Failure(Exit::file, path + ": it has a face of more than 255 corners");
        }
    }
    if (mesh.offsets.size() == 1) {
        throw Failure(Exit::file, path + ": it has no faces");
    }
    return mesh;
}

Curves read_obj_lines(const std::string &path) {
    const Obj obj = read_obj(path);
    const std::vector<Point> points = obj.points();
    Curves curves;
    for (const tinyobj::shape_t &shape : obj.shapes) {
        auto next = shape.lines.indices.begin();
        for (const int length : shape.lines.num_line_vertices) {
            const auto end = next + length;
            const bool closed = length > 1 && next->vertex_index == (end - 1)->vertex_index;
            for (; next != end - (closed ? 1 : 0); ++next) {
                const auto v = static_cast<std::size_t>(next->vertex_index);
                if (v >= points.size()) {
                    throw Failure(Exit::file, path + ": a line names vertex " + std::to_string(v + 1) + " of " +
                                                  std::to_string(points.size()));
                }
                curves.points.push_back(points[v]);
            }
            next = end;
            curves.offsets.push_back(static_cast<uint32_t>(curves.points.size()));
            curves.closed.push_back(closed);
        }
    }
    if (curves.closed.empty()) {
        throw Failure(Exit::file, path + ": it has no lines (l)");
    }
    return curves;
}

void write_obj_lines(const std::string &path, const Curves &curves) {
    std::ofstream out(path);
    for (const Point &point : curves.points) {
        out << 'v';
        for (const double coordinate : point) {
            write_number(out << ' ', coordinate);
        }
        out << '\n';
    }
    for (std::size_t c = 0; c + 1 < curves.offsets.size(); ++c) {
        const uint32_t first = curves.offsets[c], end = curves.offsets[c + 1];
        if (first == end) {
            continue;
        }
        out << 'l';
        for (uint32_t p = first; p < end; ++p) {
            out << ' ' << p + 1;
        }
        if (curves.closed[c] != 0) {
            out << ' ' << first + 1;
        }
        out << '\n';
    }
    if (!out.flush()) {
        throw Failure(Exit::file, path + ": cannot be written");
    }
}
