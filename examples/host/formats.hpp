// One function for each format; what they share is in files.hpp. They throw Failure.
#pragma once

#include "geometry.hpp"

#include <string>

Mesh read_obj_faces(const std::string &path);
Curves read_obj_lines(const std::string &path);
void write_obj_lines(const std::string &path, const Curves &curves);

/// extension: ".off", ".ply" or ".stl"
Mesh read_soup(const std::string &path, const std::string &extension);
/// extension: as above or ".obj"
void write_soup(const std::string &path, const std::string &extension, const Mesh &mesh);
