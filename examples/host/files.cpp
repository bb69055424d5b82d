#include "files.hpp"

#include "failure.hpp"
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
    return extension == ".obj" || extension == ".off" || extension == ".ply" || extension == ".stl";
}

void check_readable(const std::string &path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        throw Failure(Exit::file, path + ": there is no such file");
    }
}
} // namespace

void check_mesh_name(const std::string &path) {
    if (!is_mesh(extension(path))) {
        throw Failure(Exit::file, path + ": meshes are in .obj, .off, .ply or .stl files");
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
    return extension(path) == ".obj" ? read_obj_faces(path) : read_soup(path, extension(path));
}

Curves read_curves(const std::string &path) {
    check_curves_name(path);
    check_readable(path);
    return read_obj_lines(path);
}

void write_mesh(const std::string &path, const Mesh &mesh) {
    check_mesh_name(path);
    write_soup(path, extension(path), mesh);
}

void write_curves(const std::string &path, const Curves &curves) {
    check_curves_name(path);
    write_obj_lines(path, curves);
}
