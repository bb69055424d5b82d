// Which vertices and faces of a result are those of the inputs, told by their positions: a filter gives none of this.
#pragma once

#include "mesh.hpp"

#include <optional>
#include <vector>

/// A vertex of an input.
struct Origin {
    uint32_t input, vertex;
};

/// A face of an input: corner k of the new face is its corner (first + k), or (first - k) if it is turned over.
struct FaceOrigin {
    uint32_t input, face, first;
    bool turned;
};

struct Match {
    std::vector<std::optional<Origin>> vertices;
    std::vector<std::optional<FaceOrigin>> faces;
    /// The faces are those of the first input, with vertices elsewhere.
    bool moved = false;
};

/// Faces by the cycle of their corners' positions, the k-th of several alike being the k-th of those in the inputs; one
/// whose corners were moved by welding, by its place. Vertices by their faces, and else by their positions.
Match match(const std::vector<const Mesh *> &inputs, const Mesh &result);

/// The corner of the input that corner k of the new face was, within the face.
inline std::size_t corner_of(const FaceOrigin &origin, std::size_t k, std::size_t degree) {
    return (origin.turned ? origin.first + degree - k % degree : origin.first + k) % degree;
}
