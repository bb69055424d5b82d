#include "files.hpp"

#include "../failure.hpp"
#include "formats.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace {
std::string extension(const std::string &path) {
    std::string text = std::filesystem::path(path).extension().string();
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool is_mesh(const std::string &extension) {
    constexpr std::array known = {".obj", ".off", ".ply", ".stl", ".gltf", ".glb"};
    return std::find(known.begin(), known.end(), extension) != known.end();
}

void check_readable(const std::string &path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        throw Failure(Exit::file, path + ": there is no such file");
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw Failure(Exit::file, path + ": it is no file");
    }
}
} // namespace

void check_mesh_name(const std::string &path) {
    if (!is_mesh(extension(path))) {
        throw Failure(Exit::file, path + ": meshes are in .obj, .off, .ply, .stl, .gltf or .glb files");
    }
}

void check_curves_name(const std::string &path) {
    if (extension(path) != ".obj") {
        throw Failure(Exit::file, path + ": curves are in .obj files");
    }
}

Mesh read_mesh(const std::string &path) {
    check_mesh_name(path);
    check_readable(path);
    const std::string kind = extension(path);
    Mesh mesh = kind == ".obj"   ? read_obj(path)
                : kind == ".off" ? read_off(path)
                : kind == ".ply" ? read_ply(path)
                : kind == ".stl" ? read_stl(path)
                                 : read_gltf(path, kind == ".glb");
    if (mesh.face_count() == 0) {
        throw Failure(Exit::file, path + ": it has no faces" +
                                      (mesh.points.empty() ? "" : ", only " + number_of(mesh.points.size(), "point")));
    }
    return mesh;
}

Curves read_curves(const std::string &path) {
    check_curves_name(path);
    check_readable(path);
    return read_obj_lines(path);
}

Losses write_mesh(const std::string &path, const Mesh &mesh, bool text) {
    check_mesh_name(path);
    const std::string kind = extension(path);
    Losses losses = kind == ".obj"   ? write_obj(path, mesh)
                    : kind == ".off" ? write_off(path, mesh)
                    : kind == ".ply" ? write_ply(path, mesh, text)
                    : kind == ".stl" ? write_stl(path, mesh, text)
                                     : write_gltf(path, mesh, kind == ".glb");
    if (kind == ".stl") {
        return losses; // It names all that it loses.
    }
    // What one kind of files has, or two.
    const bool has_materials = kind == ".obj" || kind == ".gltf" || kind == ".glb";
    if (!mesh.face_materials.empty() && !has_materials) {
        losses.push_back("materials, which such files do not hold");
    }
    for (const Property &property : mesh.properties) {
        if (kind != ".ply") {
            losses.push_back(property.name + (property.of_faces ? " of faces" : " of vertices") +
                             ", which PLY files alone hold");
        }
    }
    return losses;
}

void write_curves(const std::string &path, const Curves &curves) {
    check_curves_name(path);
    write_obj_lines(path, curves);
}
