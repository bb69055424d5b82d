// What vertices, corners and faces carry, brought to the form that a file can hold.
#pragma once

#include "mesh.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

template <std::size_t N> bool is_missing(const std::array<double, N> &value) { return std::isnan(value[0]); }

template <std::size_t N> std::array<double, N> missing() {
    std::array<double, N> value;
    value.fill(std::nan(""));
    return value;
}

/// A value for each vertex, missing where no corner has one; nothing if corners of a vertex have different ones or some
/// have none.
template <std::size_t N>
std::optional<std::vector<std::array<double, N>>> at_vertices(const Mesh &mesh, const Attribute<N> &of) {
    using Values = std::vector<std::array<double, N>>;
    if (of.at == Attribute<N>::At::vertices) {
        return of.values;
    }
    Values values(mesh.points.size(), missing<N>());
    std::vector<bool> seen(mesh.points.size());
    for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
        const uint32_t v = mesh.corners[c];
        if (is_missing(of.values[c]) || (seen[v] && values[v] != of.values[c])) {
            return std::nullopt;
        }
        values[v] = of.values[c];
        seen[v] = true;
    }
    return values;
}

/// A value for each corner.
template <std::size_t N> std::vector<std::array<double, N>> at_corners(const Mesh &mesh, const Attribute<N> &of) {
    if (of.at == Attribute<N>::At::corners) {
        return of.values;
    }
    std::vector<std::array<double, N>> values;
    values.reserve(mesh.corners.size());
    for (const uint32_t v : mesh.corners) {
        values.push_back(of.values[v]);
    }
    return values;
}

/// Moves what is at corners to vertices, if nothing is lost by that.
void simplify(Mesh &mesh);

/// A colour's part as one of 256 steps.
uint8_t step_of(float part);
/// Whether 256 steps are enough for these colours.
bool are_steps(const std::vector<Colour> &colours);
bool are_opaque(const std::vector<Colour> &colours);

/// Whether all numbers are ones of single precision.
bool is_single(const std::vector<Point> &points);
bool is_single(double value);

/// What a mesh carries besides positions and faces: "colours of vertices", "normals of corners".
std::vector<std::string> attribute_names(const Mesh &mesh);
