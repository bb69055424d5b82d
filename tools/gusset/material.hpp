// What faces look like: as files have it, so that each format gets back what it gave.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct Mesh;
namespace tinygltf {
class Model;
}

/// Red, green, blue and opacity from 0 to 1, as screens have them (sRGB).
using Colour = std::array<float, 4>;
constexpr Colour white = {1, 1, 1, 1};

/// The material of a face that has none.
constexpr uint32_t no_material = UINT32_MAX;

/// An image: a file, or the bytes of one.
struct Image {
    std::string file;
    std::string bytes;

    bool empty() const { return file.empty() && bytes.empty(); }
    bool operator==(const Image &other) const { return file == other.file && bytes == other.bytes; }
};

struct Material {
    std::string name;
    /// What every format has: the colour of the surface, and an image of it.
    Colour colour = white;
    Image image;

    /// Of an OBJ file: the lines of its library but for the name, and the folder that files in them are named from.
    std::vector<std::string> lines;
    std::string folder;

    /// Of a glTF file: all of it, and which one it is there.
    std::shared_ptr<const tinygltf::Model> model;
    int place = -1;

    bool operator==(const Material &other) const {
        return name == other.name && colour == other.colour && image == other.image && lines == other.lines &&
               folder == other.folder && model == other.model && place == other.place;
    }
};

/// The number of this material among those of a mesh, to which it is added if it is not there.
uint32_t number_of_material(std::vector<Material> &all, const Material &material);

/// The materials that faces have, numbered from 0 in the order of faces, and those of the faces; without a material is
/// no_material.
struct UsedMaterials {
    std::vector<const Material *> all;
    /// As the materials' own, but no two are alike.
    std::vector<std::string> names;
    std::vector<uint32_t> of_faces;
};
UsedMaterials used_materials(const Mesh &mesh);

/// The bytes of an image; empty if there is no such file.
std::string bytes_of(const Image &image);
/// "image/png", "image/jpeg", or empty for other ones.
std::string type_of(const std::string &bytes);
