// The shapes of docs/pictures.md: shells, pieces of one, a ball with holes, a tube and waves; and the options that they are joined by.
#pragma once

#include "drawing.hpp"

namespace pictures {
struct Mesh {
    std::vector<Point3> points;
    std::vector<uint32_t> corners;
    gusset::MeshView view() const { return gusset::MeshView::triangles(points, corners); }
};

/// Part of a sphere from its pole down to a wavy rim; `up` is 1, or -1 for the lower one.
inline Mesh shell(uint32_t sides, uint32_t rings, double up, double gap) {
    const double turn = 6.283185307179586;
    Mesh mesh{{{0, 0, up * (1 + gap)}}, {}};
    for (uint32_t ring = 1; ring <= rings; ++ring) {
        for (uint32_t i = 0; i < sides; ++i) {
            const double longitude = up * turn * i / sides;
            const double rim = 1.38 + 0.1 * std::sin(5 * longitude) + 0.02 * (i % 3), polar = rim * ring / rings;
            mesh.points.push_back({std::sin(polar) * std::cos(longitude), std::sin(polar) * std::sin(longitude), up * (gap + std::cos(polar))});
        }
    }
    for (uint32_t i = 0; i < sides; ++i) {
        mesh.corners.insert(mesh.corners.end(), {0, 1 + i, 1 + (i + 1) % sides});
        for (uint32_t ring = 0; ring + 1 < rings; ++ring) {
            const uint32_t a = 1 + ring * sides + i, b = 1 + ring * sides + (i + 1) % sides;
            mesh.corners.insert(mesh.corners.end(), {a, a + sides, b + sides, a, b + sides, b});
        }
    }
    return mesh;
}

/// Texture coordinates of each corner on a texture wrapped once around the z axis; a face at its end extends beyond
/// 1.
using Pair = std::array<double, 2>;
inline std::vector<Pair> coordinates_of(const Mesh &mesh, double shift, double stretch) {
    const double turn = 6.283185307179586;
    std::vector<Pair> made;
    for (std::size_t f = 0; f < mesh.corners.size() / 3; ++f) {
        double first = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            // A pole is beside the others.
            const Point3 &p = mesh.points[mesh.corners[3 * f + k]];
            const bool pole = std::hypot(p[0], p[1]) < 1e-9;
            const Point3 &at = pole ? mesh.points[mesh.corners[3 * f + (k + 1) % 3]] : p;
            double u = 0.5 - std::atan2(at[0], at[1]) / turn;
            first = k == 0 ? u : first;
            u += std::round(first - u);
            made.push_back({shift + stretch * u, stretch * p[2] / turn});
        }
    }
    return made;
}

/// Strips and patches with new vertices on a smooth surface.
inline gusset::StitchOptions blend() {
    gusset::StitchOptions options;
    options.finish = gusset::Finish::blend;
    return options;
}
inline gusset::FillOptions faired_patch() {
    gusset::FillOptions options;
    options.refine = gusset::FillRefinement::rim_density;
    options.fairing = gusset::Fairing::thin_plate;
    return options;
}

/// A shell broken into four, moved apart and each with a rim of its own.
inline std::vector<Mesh> quarters() {
    const Mesh whole = shell(48, 14, 1, 0);
    std::vector<Mesh> pieces(4);
    for (std::size_t piece = 0; piece < 4; ++piece) {
        const double angle = 1.5707963267948966 * (static_cast<double>(piece) + 0.5);
        pieces[piece].points = whole.points;
        for (Point3 &p : pieces[piece].points) {
            p[0] += 0.1 * std::cos(angle), p[1] += 0.1 * std::sin(angle);
        }
    }
    for (std::size_t f = 0; f < whole.corners.size() / 3; ++f) {
        Point3 middle{};
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                middle[axis] += whole.points[whole.corners[3 * f + k]][axis] / 3;
            }
        }
        const std::size_t piece = (middle[1] >= 0 ? 0 : 2) + ((middle[0] >= 0) == (middle[1] >= 0) ? 0 : 1);
        const uint32_t *face = &whole.corners[3 * f];
        pieces[piece].corners.insert(pieces[piece].corners.end(), face, face + 3);
    }
    return pieces;
}
inline gusset::JoinOptions assembly_of_quarters() {
    gusset::JoinOptions options;
    options.max_gap = 0.3;
    options.strip_options.rows = gusset::RowRule::mean_edge;
    options.fill = true;
    options.fill_options.keep = gusset::FillKeep::longest; // the rim of the whole is no hole
    return options;
}

/// A ball with three holes.
inline Mesh torn_ball() {
    const gusset::NetMesh ball(gusset::Net::from_primitive(gusset::Primitive::box({1, 1, 1}, {14, 14, 14})));
    Mesh torn;
    for (std::size_t v = 0; v < ball.mesh().vertex_count(); ++v) {
        torn.points.push_back(unit(ball.mesh().position(v)));
    }
    const std::array<Point3, 3> holes{unit({0.45, -1, 0.55}), unit({-0.75, -0.8, -0.1}), unit({0.1, -0.3, 1})};
    for (std::size_t f = 0; f < ball.mesh().face_count(); ++f) {
        const gusset::Indices quad = ball.mesh().face(f);
        const Point3 &at = torn.points[quad[0]];
        const auto in = [&](const Point3 &hole) { return dot(at, hole) > 0.93 + 0.02 * std::sin(9 * at[0] + 7 * at[2]); };
        if (std::none_of(holes.begin(), holes.end(), in)) {
            torn.corners.insert(torn.corners.end(), {quad[0], quad[1], quad[2], quad[0], quad[2], quad[3]});
        }
    }
    return torn;
}

inline gusset::Sheet tube() {
    std::vector<Point3> nodes;
    for (int i = 0; i <= 14; ++i) {
        for (int j = 0; j <= 24; ++j) {
            const double angle = -6.283185307179586 * (j % 24) / 24.0, radius = 0.5 + 0.12 * std::sin(0.7 * i);
            nodes.push_back({radius * std::cos(angle), radius * std::sin(angle) + 0.2 * std::sin(0.35 * i), 0.18 * i - 1.15});
        }
    }
    gusset::NodesOptions round;
    round.closed_v = true;
    return gusset::Sheet::from_nodes(15, 25, nodes, round);
}
inline gusset::Sheet waves() {
    std::vector<Point3> nodes;
    for (int i = 0; i <= 20; ++i) {
        for (int j = 0; j <= 20; ++j) {
            const double x = 0.18 * (i - 10), y = 0.18 * (j - 10);
            nodes.push_back({x, y, 0.22 * std::sin(2.2 * x) * std::cos(1.8 * y)});
        }
    }
    return gusset::Sheet::from_nodes(21, 21, nodes);
}
} // namespace pictures
