#include "gltf_materials.hpp"

#include "gltf_values.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace {
namespace fs = std::filesystem;

template <class T> const T *at(const std::vector<T> &all, int place) {
    return place >= 0 && static_cast<std::size_t>(place) < all.size() ? &all[static_cast<std::size_t>(place)] : nullptr;
}

/// A name of a file that was written as part of an address: "my%20image.png".
std::string decoded(const std::string &uri) {
    std::string made;
    for (std::size_t k = 0; k < uri.size(); ++k) {
        const bool escaped = uri[k] == '%' && k + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[k + 1])) != 0 &&
                             std::isxdigit(static_cast<unsigned char>(uri[k + 2])) != 0;
        made += escaped ? static_cast<char>(std::stoi(uri.substr(k + 1, 2), nullptr, 16)) : uri[k];
        k += escaped ? 2 : 0;
    }
    return made;
}

/// The image of a texture.
Image image_of(const tinygltf::Model &model, int texture, const std::string &folder) {
    const auto *found = at(model.textures, texture);
    const auto *image = found == nullptr ? nullptr : at(model.images, found->source);
    Image made;
    if (image != nullptr && !image->image.empty()) {
        made.bytes.assign(image->image.begin(), image->image.end());
    } else if (image != nullptr && !image->uri.empty()) {
        made.file = fs::absolute(fs::path(folder) / decoded(image->uri)).string();
    }
    return made;
}
} // namespace

bool keep_image(tinygltf::Image *image, const int, std::string *, std::string *, int, int, const unsigned char *bytes,
                int size, void *) {
    image->image.assign(bytes, bytes + std::max(size, 0));
    image->as_is = true;
    return true;
}

Material material_of(const std::shared_ptr<const tinygltf::Model> &model, int place, const std::string &folder) {
    Material made;
    const auto *found = at(model->materials, place);
    if (found == nullptr) {
        return made;
    }
    made.name = found->name.empty() ? "material_" + std::to_string(place) : found->name;
    made.folder = folder;
    made.model = model;
    made.place = place;
    const auto &colour = found->pbrMetallicRoughness.baseColorFactor;
    for (std::size_t k = 0; k < 4 && k < colour.size(); ++k) {
        made.colour[k] = static_cast<float>(k == 3 ? colour[k] : shown_of(colour[k]));
    }
    made.image = image_of(*model, found->pbrMetallicRoughness.baseColorTexture.index, folder);
    return made;
}

int MaterialWriter::add(const Material &material, const std::string &name) {
    tinygltf::Material made;
    if (const auto *whole = material.model ? at(material.model->materials, material.place) : nullptr) {
        made = *whole;
        const auto texture = [&](auto &info) {
            info.index = is_shown(info.index, info.texCoord, name) ? add_texture(material, info.index) : -1;
        };
        texture(made.pbrMetallicRoughness.baseColorTexture);
        texture(made.pbrMetallicRoughness.metallicRoughnessTexture);
        texture(made.normalTexture);
        texture(made.occlusionTexture);
        texture(made.emissiveTexture);
        for (auto &[extension, value] : made.extensions) {
            value = remapped(material, name, value);
            if (std::find(model.extensionsUsed.begin(), model.extensionsUsed.end(), extension) ==
                model.extensionsUsed.end()) {
                model.extensionsUsed.push_back(extension);
            }
        }
    } else {
        auto &base = made.pbrMetallicRoughness;
        base.baseColorFactor.resize(4);
        for (std::size_t k = 0; k < 4; ++k) {
            const auto part = static_cast<double>(material.colour[k]);
            base.baseColorFactor[k] = k == 3 ? part : linear_of(part);
        }
        base.metallicFactor = 0;
        made.alphaMode = material.colour[3] < 1 ? "BLEND" : "OPAQUE";
        if (!material.image.empty()) {
            const int image = add_image(material.image);
            if (image >= 0) {
                tinygltf::Texture texture;
                texture.source = image;
                model.textures.push_back(texture);
                base.baseColorTexture.index = static_cast<int>(model.textures.size() - 1);
            }
        }
        const bool more = std::any_of(material.lines.begin(), material.lines.end(), [](const std::string &line) {
            return line.compare(0, 2, "Kd") != 0 && line.compare(0, 2, "d ") != 0 &&
                   (line.compare(0, 6, "map_Kd") != 0 || line.compare(0, 8, "map_Kd -") == 0);
        });
        if (more) {
            losses.push_back("all of material " + name + " but its diffuse colour and image");
        }
    }
    made.name = name;
    model.materials.push_back(std::move(made));
    return static_cast<int>(model.materials.size() - 1);
}

/// Whether a texture is there, by the one set of texture coordinates that is kept.
bool MaterialWriter::is_shown(int texture, int set, const std::string &name) {
    if (texture >= 0 && set > 0) {
        losses.push_back("a texture of material " + name + " that other texture coordinates show");
    }
    return texture >= 0 && set == 0;
}

int MaterialWriter::add_texture(const Material &material, int place) {
    const auto *found = at(material.model->textures, place);
    if (found == nullptr) {
        return -1;
    }
    tinygltf::Texture texture = *found;
    texture.source = add_image(image_of(*material.model, place, material.folder));
    if (texture.source < 0) {
        return -1;
    }
    const auto *sampler = at(material.model->samplers, found->sampler);
    texture.sampler = sampler == nullptr ? -1 : static_cast<int>(model.samplers.size());
    if (sampler != nullptr) {
        model.samplers.push_back(*sampler);
    }
    model.textures.push_back(std::move(texture));
    return static_cast<int>(model.textures.size() - 1);
}

/// The image within the file, so that it needs no others; -1 if it cannot be.
int MaterialWriter::add_image(const Image &image) {
    const std::string bytes = bytes_of(image), type = type_of(bytes);
    if (type.empty()) {
        losses.push_back("the image " + (image.file.empty() ? std::string("within the file") : image.file) +
                         (bytes.empty() ? ", which is not there" : ", which is neither PNG nor JPEG"));
        return -1;
    }
    auto &data = model.buffers[0].data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = bytes.size();
    tinygltf::Image made;
    made.mimeType = type;
    // One that several textures show is there once.
    for (std::size_t k = 0; k < model.images.size(); ++k) {
        const auto &other = model.bufferViews[static_cast<std::size_t>(model.images[k].bufferView)];
        if (other.byteLength == bytes.size() &&
            std::equal(bytes.begin(), bytes.end(), data.begin() + static_cast<std::ptrdiff_t>(other.byteOffset),
                       [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; })) {
            return static_cast<int>(k);
        }
    }
    data.insert(data.end(), bytes.begin(), bytes.end());
    // The next one begins at a whole word.
    data.resize((data.size() + 3) / 4 * 4);
    made.bufferView = static_cast<int>(model.bufferViews.size());
    model.bufferViews.push_back(view);
    model.images.push_back(std::move(made));
    return static_cast<int>(model.images.size() - 1);
}

/// The same value with the numbers of textures in it those of this model.
tinygltf::Value MaterialWriter::remapped(const Material &material, const std::string &name,
                                         const tinygltf::Value &value) {
    if (value.IsArray()) {
        tinygltf::Value::Array made;
        for (std::size_t k = 0; k < value.ArrayLen(); ++k) {
            made.push_back(remapped(material, name, value.Get(static_cast<int>(k))));
        }
        return tinygltf::Value(made);
    }
    if (!value.IsObject()) {
        return value;
    }
    tinygltf::Value::Object made;
    for (const std::string &key : value.Keys()) {
        const tinygltf::Value &inner = value.Get(key);
        const bool is_texture = key.size() >= 7 && key.compare(key.size() - 7, 7, "Texture") == 0;
        if (!is_texture || !inner.IsObject() || !inner.Has("index")) {
            made[key] = remapped(material, name, inner);
            continue;
        }
        const int set = inner.Has("texCoord") ? inner.Get("texCoord").GetNumberAsInt() : 0;
        const int index = inner.Get("index").GetNumberAsInt();
        const int added = is_shown(index, set, name) ? add_texture(material, index) : -1;
        if (added >= 0) {
            auto texture = remapped(material, name, inner).Get<tinygltf::Value::Object>();
            texture["index"] = tinygltf::Value(added);
            made[key] = tinygltf::Value(texture);
        }
    }
    return tinygltf::Value(made);
}
