// Colours, normals and texture coordinates of the inputs, on the result of a filter, which knows of positions and faces
// alone.
#pragma once

#include "mesh.hpp"

#include <string>
#include <vector>

/// A mesh that went in, and the name that it has in messages.
struct Piece {
    const Mesh *mesh;
    std::string name;
};

/// Vertices and faces that are the inputs' keep what they had. New vertices and faces take the mean of their
/// neighbours, normals of their faces; new faces get texture coordinates only where each vertex has one pair. Returns
/// what was lost.
std::vector<std::string> carry(const std::vector<Piece> &pieces, Mesh &result);
