// Meshes and curves in files, by the extension of their names. All functions throw Failure.
#pragma once

#include "../mesh.hpp"

#include <string>
#include <vector>

/// From .obj, .off, .ply, .stl, .gltf or .glb. Points of an STL file that are exactly equal are one.
Mesh read_mesh(const std::string &path);
/// From the polylines of an .obj file; one that ends at the vertex that it begins with is closed.
Curves read_curves(const std::string &path);

/// What was lost on the way, a phrase each: "colours of faces, which OBJ files do not hold".
using Losses = std::vector<std::string>;
/// text: PLY and STL files as text rather than in binary.
Losses write_mesh(const std::string &path, const Mesh &mesh, bool text);
void write_curves(const std::string &path, const Curves &curves);

/// Whether such a file can be written at all, to be asked before the work is done.
void check_mesh_name(const std::string &path);
void check_curves_name(const std::string &path);
