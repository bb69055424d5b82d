// Meshes and curves in files, by the extension of their names. All functions throw Failure.
#pragma once

#include "geometry.hpp"

#include <string>

/// From .obj, .off, .ply or .stl. Points of an STL file that are exactly equal are one.
Mesh read_mesh(const std::string &path);
/// From the polylines of an .obj file; one that ends at the vertex that it begins with is closed.
Curves read_curves(const std::string &path);
void write_mesh(const std::string &path, const Mesh &mesh);
void write_curves(const std::string &path, const Curves &curves);

/// Whether such a file can be written at all, to be asked before the work is done.
void check_mesh_name(const std::string &path);
void check_curves_name(const std::string &path);
