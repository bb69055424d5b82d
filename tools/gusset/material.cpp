#include "material.hpp"

#include "mesh.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

uint32_t number_of_material(std::vector<Material> &all, const Material &material) {
    const auto found = std::find(all.begin(), all.end(), material);
    const auto number = static_cast<uint32_t>(found - all.begin());
    if (found == all.end()) {
        all.push_back(material);
    }
    return number;
}

UsedMaterials used_materials(const Mesh &mesh) {
    UsedMaterials used;
    std::vector<uint32_t> numbers(mesh.materials.size(), no_material);
    std::set<std::string> names;
    used.of_faces.reserve(mesh.face_materials.size());
    for (const uint32_t material : mesh.face_materials) {
        if (material == no_material) {
            used.of_faces.push_back(no_material);
            continue;
        }
        uint32_t &number = numbers[material];
        if (number == no_material) {
            number = static_cast<uint32_t>(used.all.size());
            used.all.push_back(&mesh.materials[material]);
            std::string name = mesh.materials[material].name;
            for (std::size_t k = 2; !names.insert(name).second; ++k) {
                name = mesh.materials[material].name + '_' + std::to_string(k);
            }
            used.names.push_back(name);
        }
        used.of_faces.push_back(number);
    }
    return used;
}

std::string bytes_of(const Image &image) {
    if (!image.bytes.empty() || image.file.empty()) {
        return image.bytes;
    }
    std::ostringstream all;
    all << std::ifstream(image.file, std::ios::binary).rdbuf();
    return all.str();
}

std::string type_of(const std::string &bytes) {
    return bytes.compare(0, 4, "\x89PNG") == 0        ? "image/png"
           : bytes.compare(0, 3, "\xFF\xD8\xFF") == 0 ? "image/jpeg"
                                                       : "";
}
