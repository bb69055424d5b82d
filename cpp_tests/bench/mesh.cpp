#include "mesh.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

Triangles read_triangles(const std::string &path) {
    std::ifstream in(path, std::ios::binary);
    uint64_t counts[2] = {0, 0};
    const auto read = [&](void *to, std::size_t bytes) {
        if (!in.read(static_cast<char *>(to), static_cast<std::streamsize>(bytes))) {
            throw std::runtime_error(path + " is no mesh, or ends early");
        }
    };
    read(counts, sizeof counts);
    Triangles mesh{std::vector<std::array<double, 3>>(counts[0]), std::vector<uint32_t>(3 * counts[1])};
    read(mesh.points.data(), mesh.points.size() * sizeof mesh.points[0]);
    read(mesh.corners.data(), mesh.corners.size() * sizeof mesh.corners[0]);
    if (std::any_of(mesh.corners.begin(), mesh.corners.end(), [&](uint32_t v) { return v >= counts[0]; })) {
        throw std::runtime_error(path + " names a vertex that it does not have");
    }
    return mesh;
}

void write_triangles(const Triangles &mesh, const std::string &path) {
    std::ofstream out(path, std::ios::binary);
    const uint64_t counts[2] = {mesh.points.size(), mesh.face_count()};
    const auto write = [&](const void *from, std::size_t bytes) {
        out.write(static_cast<const char *>(from), static_cast<std::streamsize>(bytes));
    };
    write(counts, sizeof counts);
    write(mesh.points.data(), mesh.points.size() * sizeof mesh.points[0]);
    write(mesh.corners.data(), mesh.corners.size() * sizeof mesh.corners[0]);
    if (!out) {
        throw std::runtime_error("cannot write " + path);
    }
}
