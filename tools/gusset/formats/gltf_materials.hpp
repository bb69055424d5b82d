// Materials of glTF files, in both directions: all of what a glTF file has of them goes into another.
#pragma once

#include "../mesh.hpp"
#include "files.hpp"

#include <tiny_gltf.h>

#include <memory>
#include <string>

/// Keeps the bytes of an image as they are: for tinygltf, which cannot unpack them here and need not.
bool keep_image(tinygltf::Image *image, const int number, std::string *error, std::string *warning, int width,
                int height, const unsigned char *bytes, int size, void *user);

/// A material of a model that was read from a file in `folder`.
Material material_of(const std::shared_ptr<const tinygltf::Model> &model, int place, const std::string &folder);

/// Materials of a model that is written: what they need is copied into it.
class MaterialWriter {
public:
    MaterialWriter(tinygltf::Model &model_, Losses &losses_) : model(model_), losses(losses_) {}
    /// The number of the material in the model.
    int add(const Material &material, const std::string &name);

private:
    int add_texture(const Material &material, int place);
    int add_image(const Image &image);
    tinygltf::Value remapped(const Material &material, const std::string &name, const tinygltf::Value &value);
    bool is_shown(int texture, int set, const std::string &name);

    tinygltf::Model &model;
    Losses &losses;
};
