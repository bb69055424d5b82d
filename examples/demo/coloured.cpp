#include "coloured.hpp"

#include <gusset/openmesh.hpp>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace {
using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;
using OpenMesh::IO::Options;

FaceHandle face(std::size_t f) { return FaceHandle(static_cast<int>(f)); }
VertexHandle vertex(std::size_t v) { return VertexHandle(static_cast<int>(v)); }

HostMesh::Color light(const page::Colour &colour) {
    return {static_cast<float>(colour[0]) / 255, static_cast<float>(colour[1]) / 255, static_cast<float>(colour[2]) / 255, 1};
}
} // namespace

Coloured read(const std::string &path) {
    Coloured piece;
    Options options(Options::VertexColor | Options::FaceColor);
    if (!OpenMesh::IO::read_mesh(piece.mesh, path, options)) {
        throw std::runtime_error("cannot read " + path + " (OBJ, PLY, OFF, STL)");
    }
    piece.has_vertex_colours = options.vertex_has_color();
    piece.has_face_colours = options.face_has_color();
    return piece;
}

Joined joined(const Coloured &left, const Coloured &right, const gusset::Stitch &stitch, const std::array<page::Colour, 3> &paints,
              bool with_strip) {
    Joined out;
    const gusset::MeshView whole = stitch.mesh();
    const std::size_t old = stitch.vertex_map(0).size() + stitch.vertex_map(1).size();
    for (std::size_t v = 0; v < (with_strip ? whole.vertex_count() : old); ++v) {
        const gusset::Point3 p = whole.position(v);
        out.mesh.set_color(out.mesh.add_vertex({p[0], p[1], p[2]}), light(paints[2]));
    }
    const std::size_t first = stitch.strip_faces().first;
    std::vector<VertexHandle> corners;
    for (std::size_t f = 0; f < (with_strip ? whole.face_count() : first); ++f) {
        corners.clear();
        for (const uint32_t v : whole.face(f)) {
            corners.push_back(vertex(v));
        }
        const FaceHandle added = out.mesh.add_face(corners);
        if (!added.is_valid()) {
            throw std::runtime_error("OpenMesh takes two-manifolds only: it refuses face " + std::to_string(f) + " of the result");
        }
        out.mesh.set_color(added, light(paints[2]));
    }
    out.has_vertex_colours = left.has_vertex_colours || right.has_vertex_colours;
    out.is_coloured = out.has_vertex_colours || left.has_face_colours || right.has_face_colours;
    for (const int side : {0, 1}) {
        const Coloured &piece = side == 0 ? left : right;
        const HostMesh::Color paint = light(paints[static_cast<std::size_t>(side)]);
        const gusset::Indices vertices = stitch.vertex_map(side), faces = stitch.face_map(side);
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            out.mesh.set_color(vertex(vertices[v]), piece.has_vertex_colours ? piece.mesh.color(vertex(v)) : paint);
        }
        for (std::size_t f = 0; f < faces.size(); ++f) {
            out.mesh.set_color(face(faces[f]), piece.has_face_colours ? piece.mesh.color(face(f)) : paint);
        }
    }
    std::vector<std::array<float, 4>> colours[2];
    for (const int side : {0, 1}) {
        for (const uint32_t v : stitch.vertex_map(side)) {
            const HostMesh::Color own = out.mesh.color(vertex(v));
            colours[side].push_back({own[0], own[1], own[2], own[3]});
        }
    }
    // Between the rims, of both.
    const auto all = stitch.origins().apply<std::array<float, 4>>(gusset::Domain::vertices, gusset::Rule::linear, {colours[0], colours[1]});
    for (std::size_t v = old; with_strip && v < all.size(); ++v) {
        out.mesh.set_color(vertex(v), {all[v][0], all[v][1], all[v][2], all[v][3]});
    }
    return out;
}

std::string write(const HostMesh &mesh, bool has_vertex_colours, const std::string &stem) {
    const std::string path = stem + (has_vertex_colours ? ".ply" : ".obj");
    if (!OpenMesh::IO::write_mesh(mesh, path, Options(has_vertex_colours ? Options::VertexColor : Options::FaceColor), 17)) {
        throw std::runtime_error("cannot write " + path);
    }
    // OpenMesh calls the file of materials .mat; what reads it looks for .mtl.
    const std::string name = stem.substr(stem.rfind('/') + 1);
    if (std::rename((stem + ".mat").c_str(), (stem + ".mtl").c_str()) == 0) {
        std::ifstream in(path);
        std::string text{std::istreambuf_iterator<char>(in), {}};
        const std::size_t at = text.find(name + ".mat");
        if (at != std::string::npos) {
            text.replace(at, name.size() + 4, name + ".mtl");
        }
        std::ofstream(path) << text;
    }
    return path;
}
