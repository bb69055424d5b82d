// Affine matrices of glTF's nodes: three rows of four.
#pragma once

#include "formats.hpp"

#include <tiny_gltf.h>

#include <array>
#include <cstddef>

using Matrix = std::array<std::array<double, 4>, 3>;
constexpr Matrix identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

inline Matrix product(const Matrix &a, const Matrix &b) {
    Matrix made{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            made[i][k] = k == 3 ? a[i][3] : 0;
            for (std::size_t j = 0; j < 3; ++j) {
                made[i][k] += a[i][j] * b[j][k];
            }
        }
    }
    return made;
}

/// The matrix of a node, relative to its parent.
inline Matrix matrix_of(const tinygltf::Node &node) {
    Matrix made = identity;
    if (node.matrix.size() == 16) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 4; ++k) {
                made[i][k] = node.matrix[4 * k + i];
            }
        }
        return made;
    }
    if (node.rotation.size() == 4) {
        const double x = node.rotation[0], y = node.rotation[1], z = node.rotation[2], w = node.rotation[3];
        made = {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 0},
                 {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 0},
                 {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), 0}}};
    }
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            made[i][k] *= node.scale.size() == 3 ? node.scale[k] : 1;
        }
        made[i][3] = node.translation.size() == 3 ? node.translation[i] : 0;
    }
    return made;
}

inline Point moved(const Matrix &by, const Point &p) {
    Point made;
    for (std::size_t i = 0; i < 3; ++i) {
        made[i] = by[i][0] * p[0] + by[i][1] * p[1] + by[i][2] * p[2] + by[i][3];
    }
    return made;
}

/// The cofactors, by which normals are transformed: the inverse transpose times the determinant.
inline std::array<std::array<double, 3>, 3> cofactors(const Matrix &m) {
    std::array<std::array<double, 3>, 3> made{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (k + 1) % 3, d = (k + 2) % 3;
            made[i][k] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    }
    return made;
}

inline double determinant(const Matrix &m) {
    const auto c = cofactors(m);
    return m[0][0] * c[0][0] + m[0][1] * c[0][1] + m[0][2] * c[0][2];
}
