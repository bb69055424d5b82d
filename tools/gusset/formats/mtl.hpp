// Libraries of materials beside OBJ files.
#pragma once

#include "../mesh.hpp"
#include "files.hpp"

#include <map>
#include <string>

/// The materials of a library by their names, added to `into`. Returns whether there is such a file. Throws Failure.
bool read_mtl(const std::string &path, std::map<std::string, Material> &into);

/// Writes the materials of a mesh to a library, and images that are in no file to files beside it. Throws Failure.
void write_mtl(const std::string &path, const UsedMaterials &materials);
