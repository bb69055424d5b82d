// The judge of a joined mesh, whoever joined it. Intersections are CGAL's with exact predicates; the rest is elementary geometry.
#include "mesh_judge.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace {
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;

/// Larger meshes are searched only where the new faces are.
constexpr std::size_t search_all_below = 400'000;
const double degrees = 180.0 / std::acos(-1.0);

Kernel::Point_3 point(const Triangles &mesh, uint32_t v) { return {mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]}; }

double length(const Vector &v) { return std::sqrt(v.squared_length()); }

double angle(const Vector &u, const Vector &v) { return degrees * std::atan2(length(CGAL::cross_product(u, v)), u * v); }

/// Twice the vector area of a face.
Vector normal(const Triangles &mesh, std::size_t f) {
    const uint32_t *c = &mesh.corners[3 * f];
    const Kernel::Point_3 p = point(mesh, c[0]);
    return CGAL::cross_product(point(mesh, c[1]) - p, point(mesh, c[2]) - p);
}

/// Face i of the result is face i of the input. Returns false if CGAL refuses the mesh because it is not a
/// two-manifold.
bool build(const Triangles &mesh, std::size_t first, bool reversed, Mesh &built) {
    built.clear();
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        built.add_vertex(point(mesh, static_cast<uint32_t>(v)));
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const Mesh::Vertex_index a(mesh.corners[3 * f]), b(mesh.corners[3 * f + 1]), c(mesh.corners[3 * f + 2]);
        const bool turn = reversed && f >= first;
        if (built.add_face(a, turn ? c : b, turn ? b : c) == Mesh::null_face()) {
            return false;
        }
    }
    return true;
}

/// Duplicates vertices until the mesh is a two-manifold.
void build_doubled(const Triangles &mesh, Mesh &built) {
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        points.push_back(point(mesh, static_cast<uint32_t>(v)));
    }
    for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
        faces.push_back({mesh.corners[c], mesh.corners[c + 1], mesh.corners[c + 2]});
    }
    PMP::orient_polygon_soup(points, faces);
    built.clear();
    PMP::polygon_soup_to_polygon_mesh(points, faces, built);
}

CGAL::Bbox_3 box(const Triangles &mesh, std::size_t f) {
    const uint32_t *c = &mesh.corners[3 * f];
    return point(mesh, c[0]).bbox() + point(mesh, c[1]).bbox() + point(mesh, c[2]).bbox();
}

bool share_a_corner(const Triangles &mesh, std::size_t f, std::size_t g) {
    const auto *a = &mesh.corners[3 * f], *b = &mesh.corners[3 * g];
    return std::find_first_of(a, a + 3, b, b + 3) != a + 3;
}

/// Distances need no exact arithmetic.
using Plain = CGAL::Simple_cartesian<double>;
using Solid = std::vector<Plain::Triangle_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Plain, CGAL::AABB_triangle_primitive<Plain, Solid::const_iterator>>>;

/// The triangles from `first` on that have an area.
Solid triangles(const Triangles &mesh, std::size_t first) {
    const auto at = [&](uint32_t v) { return Plain::Point_3(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]); };
    Solid made;
    for (std::size_t c = 3 * first; c < mesh.corners.size(); c += 3) {
        const Plain::Triangle_3 t(at(mesh.corners[c]), at(mesh.corners[c + 1]), at(mesh.corners[c + 2]));
        if (t.squared_area() > 0) {
            made.push_back(t);
        }
    }
    return made;
}

/// The mean squared distance to `tree` over the surface: samples evenly by area, within the triangles by the R2 sequence.
double mean_square(const Solid &from, const Tree &tree) {
    constexpr double samples = 20'000;
    double area = 0, done = 0, sum = 0;
    for (const auto &t : from) {
        area += std::sqrt(t.squared_area());
    }
    uint64_t drawn = 0;
    for (const auto &t : from) {
        done += std::sqrt(t.squared_area()) / area * samples;
        for (; static_cast<double>(drawn) + 0.5 < done; ++drawn) {
            const double n = static_cast<double>(drawn);
            double u = std::fmod(n * 0.7548776662466927, 1.0), v = std::fmod(n * 0.5698402909980532, 1.0);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            sum += tree.squared_distance(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
        }
    }
    return sum / static_cast<double>(drawn);
}
} // namespace

void shapes(const Triangles &mesh, std::size_t first, nlohmann::json &out) {
    double least = 180, worst = 1, area = 0;
    std::size_t slivers = 0;
    for (std::size_t f = first; f < mesh.face_count(); ++f) {
        Vector side[3];
        for (std::size_t k = 0; k < 3; ++k) {
            side[k] = point(mesh, mesh.corners[3 * f + (k + 1) % 3]) - point(mesh, mesh.corners[3 * f + k]);
        }
        const double a = length(side[0]), b = length(side[1]), c = length(side[2]), doubled = length(normal(mesh, f));
        double smallest = 180;
        for (std::size_t k = 0; k < 3; ++k) {
            smallest = std::min(smallest, angle(side[k], -side[(k + 2) % 3]));
        }
        least = std::min(least, smallest);
        slivers += smallest < 15;
        worst = std::max(worst, doubled > 0 ? a * b * c * (a + b + c) / (4 * doubled * doubled) : HUGE_VAL);
        area += doubled / 2;
    }
    out["min_angle"] = least;
    out["under_15"] = static_cast<double>(slivers) / static_cast<double>(mesh.face_count() - first);
    out["aspect"] = worst;
    out["area"] = area;
}

void edges(const Triangles &mesh, std::size_t first, nlohmann::json &out) {
    struct Side {
        uint64_t ends;
        uint32_t corner;
    };
    std::vector<bool> near(mesh.points.size());
    for (std::size_t c = 3 * first; c < mesh.corners.size(); ++c) {
        near[mesh.corners[c]] = true;
    }
    std::vector<Side> sides;
    for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
        const uint64_t u = mesh.corners[c], v = mesh.corners[c % 3 == 2 ? c - 2 : c + 1];
        if (near[u] && near[v]) {
            sides.push_back({std::min(u, v) << 32 | std::max(u, v), static_cast<uint32_t>(c)});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side &a, const Side &b) { return a.ends < b.ends; });
    bool closed = true;
    std::vector<double> bends;
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
        end = i + 1;
        bool new_face = sides[i].corner >= 3 * first;
        for (; end < sides.size() && sides[end].ends == sides[i].ends; ++end) {
            new_face = new_face || sides[end].corner >= 3 * first;
        }
        if (!new_face) {
            continue;
        }
        if (end - i != 2) {
            closed = false;
            continue;
        }
        const uint32_t c = sides[i].corner, d = sides[i + 1].corner;
        const bool same_way = mesh.corners[c] == mesh.corners[d];
        closed = closed && !same_way;
        const Vector other = normal(mesh, d / 3);
        bends.push_back(angle(normal(mesh, c / 3), same_way ? -other : other));
    }
    std::sort(bends.begin(), bends.end());
    out["closed"] = closed;
    out["dihedral_p95"] = bends.empty() ? 0 : bends[(bends.size() - 1) * 95 / 100];
    out["dihedral_max"] = bends.empty() ? 0 : bends.back();
}

void intersections(const Triangles &mesh, std::size_t first, bool everywhere, nlohmann::json &out) {
    Mesh built;
    const bool manifold = build(mesh, first, false, built) || build(mesh, first, true, built);
    if (!manifold) {
        build_doubled(mesh, built);
    }
    everywhere = everywhere && mesh.face_count() < search_all_below;
    CGAL::Bbox_3 strip;
    for (std::size_t f = first; f < mesh.face_count(); ++f) {
        strip += box(mesh, f);
    }
    std::vector<Face> searched;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (everywhere || f >= first || CGAL::do_overlap(strip, box(mesh, f))) {
            searched.emplace_back(static_cast<Mesh::size_type>(f));
        }
    }
    std::vector<std::pair<Face, Face>> pairs;
    PMP::self_intersections(searched, built, std::back_inserter(pairs));
    std::size_t all = 0, touching = 0;
    for (const auto &[f, g] : pairs) {
        // Doubled vertices would make neighbours seem to intersect.
        if (manifold || !share_a_corner(mesh, f, g)) {
            ++all;
            touching += f >= first || g >= first;
        }
    }
    out["manifold"] = manifold;
    out["intersections"] = touching;
    if (everywhere) {
        out["intersections_all"] = all;
    }
}

void distance(const Triangles &mesh, std::size_t first, const Triangles &truth, nlohmann::json &out) {
    const Solid made = triangles(mesh, first), there = triangles(truth, 0);
    Tree to_made(made.begin(), made.end()), to_truth(there.begin(), there.end());
    to_made.accelerate_distance_queries();
    to_truth.accelerate_distance_queries();
    out["rms"] = std::sqrt((mean_square(made, to_truth) + mean_square(there, to_made)) / 2);
}
