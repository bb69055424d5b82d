// Random meshes.
#pragma once

#include "../cpp/soup.hpp"
#include "campaign.hpp"

#include <functional>

namespace campaign {
using Point = std::array<double, 3>;

/// A smooth displacement of space, of which no symmetry is left.
class Waves {
public:
    /// `size`: the largest displacement along each axis.
    Waves(Random &random, double size);
    Point operator()(const Point &p) const;

private:
    struct Wave {
        Point direction;
        double phase, size;
    };
    std::array<std::array<Wave, 2>, 3> waves_;
};

/// n x m cells over the unit square; closed directions have their last line for their first.
Soup grid(uint32_t n, uint32_t m, bool closed_s, bool closed_t, const std::function<Point(double, double)> &at);
enum class Shape { sheet, tube, torus, ball };
/// A shape of a few cells to some hundred, with waves: quads, and triangles at the poles of a ball.
Soup random_shape(Random &random, Shape shape);
/// Some polygons cut to fans; all if `share` is 1.
Soup cut_to_triangles(const Soup &soup, Random &random, double share);
/// Without the faces for which `dropped` says so; vertices that none uses any more stay.
Soup without(const Soup &soup, const std::function<bool(std::size_t)> &dropped);
/// Without vertices that no face uses.
Soup compact(const Soup &soup);
/// Without some faces: single ones, and all round some vertices.
Soup with_holes(const Soup &soup, Random &random);
void turn_face(Soup &soup, std::size_t face);
/// All faces the other way round.
Soup inside_out(Soup soup);
/// The faces in another order, each from another of its corners on.
Soup shuffled(const Soup &soup, Random &random);
/// One after the other.
Soup together(const std::vector<Soup> &pieces);
/// Moves all points by a random rotation and a shift.
void move(Soup &soup, const std::array<Point, 3> &rotation, const Point &shift);
std::array<Point, 3> random_rotation(Random &random);
/// The faces of a soup as lists.
std::vector<std::vector<uint32_t>> faces_of(const Soup &soup);

/// The numbers of vertices, edges and faces of what faces use, counted by sets.
struct Counts {
    std::size_t vertices = 0, edges = 0, boundary = 0, branches = 0, faces = 0;
    long euler() const { return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(faces); }
};
Counts count(const gusset::MeshView &mesh);
} // namespace campaign
