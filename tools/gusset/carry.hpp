// What the inputs carry, on the result of a filter, which knows of positions and faces alone: by where the plugin says
// that the elements of its output come from.
#pragma once

#include "mesh.hpp"
#include "origins.hpp"

#include <string>
#include <vector>

/// A mesh that went in, and the name that it has in messages.
struct Piece {
    const Mesh *mesh;
    std::string name;
};

/// Vertices, corners and faces of the inputs keep what they had, bit for bit; what is new has the mean of what it lies
/// between, and texture coordinates that go on. Returns what was lost.
std::vector<std::string> carry(const std::vector<Piece> &pieces, const Origins &origins, Mesh &result);
