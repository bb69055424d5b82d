// Two functions for each format; what they share is in files.hpp. They throw Failure.
//
// OBJ is read by tinyobjloader and glTF by tinygltf. For PLY, STL and OFF Debian has no library under a permissive
// licence that keeps double precision, polygons and what vertices carry, and says where a file is wrong: Assimp and
// OpenMesh read single precision, CGAL is under the LGPL, and none reads the NCOFF that MeshLab writes.
#pragma once

#include "files.hpp"

Mesh read_obj(const std::string &path);
Losses write_obj(const std::string &path, const Mesh &mesh);
Curves read_obj_lines(const std::string &path);
void write_obj_lines(const std::string &path, const Curves &curves);

Mesh read_off(const std::string &path);
Losses write_off(const std::string &path, const Mesh &mesh);

Mesh read_ply(const std::string &path);
Losses write_ply(const std::string &path, const Mesh &mesh, bool text);

Mesh read_stl(const std::string &path);
Losses write_stl(const std::string &path, const Mesh &mesh, bool text);

/// .gltf, or .glb if binary.
Mesh read_gltf(const std::string &path, bool binary);
Losses write_gltf(const std::string &path, const Mesh &mesh, bool binary);
