// The judge of repaired meshes, and CGAL's own repair. Reads a job in JSON from each line, and writes the answer as a line:
// * {"pairs": mesh}: the pairs of faces that intersect;
// * {"covered": mesh}: the faces that have a corner within another part;
// * {"judge": mesh, "truth": mesh, "united": bool}: validity, the share of each part of the truth that is there, and the distances;
// * {"repair": mesh, "out": mesh}: experimental::autorefine_and_remove_self_intersections.
#include "mesh.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>

namespace {
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Segment = Kernel::Segment_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = std::array<std::size_t, 3>;

struct Soup {
    std::vector<Point> points;
    std::vector<Face> faces;
};

Soup soup(const Triangles &mesh) {
    Soup made;
    for (const auto &p : mesh.points) {
        made.points.emplace_back(p[0], p[1], p[2]);
    }
    for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
        made.faces.push_back({mesh.corners[c], mesh.corners[c + 1], mesh.corners[c + 2]});
    }
    return made;
}

/// Gives the faces the first of all vertices with the same coordinates, so that parts may touch there.
Soup merged(Soup soup) {
    std::map<Point, std::size_t> first;
    std::vector<std::size_t> names;
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
        names.push_back(first.emplace(soup.points[v], v).first->second);
    }
    for (auto &face : soup.faces) {
        for (auto &v : face) {
            v = names[v];
        }
    }
    return soup;
}

/// Returns true if two triangles have a common point apart from common corners and sides. All decisions are exact.
bool intersect(const Soup &soup, std::size_t f, std::size_t g) {
    Face a = soup.faces[f], b = soup.faces[g];
    const auto common = [](const Face &from, Face &face) {
        const auto middle = std::stable_partition(
            face.begin(), face.end(), [&](std::size_t v) { return std::find(from.begin(), from.end(), v) != from.end(); });
        return middle - face.begin();
    };
    const Face copy = a;
    const auto shared = common(b, a);
    common(copy, b);
    const auto at = [&](std::size_t v) -> const Point & { return soup.points[v]; };
    const Triangle s(at(a[0]), at(a[1]), at(a[2])), t(at(b[0]), at(b[1]), at(b[2]));
    if (s.is_degenerate() || t.is_degenerate()) {
        return false; // Degenerate faces are counted by themselves.
    }
    switch (shared) {
    case 3: return true;
    case 2:
        return CGAL::coplanar(at(a[0]), at(a[1]), at(a[2]), at(b[2])) &&
               CGAL::coplanar_orientation(at(a[0]), at(a[1]), at(a[2]), at(b[2])) == CGAL::POSITIVE;
    case 1: return CGAL::do_intersect(Segment(at(a[1]), at(a[2])), t) || CGAL::do_intersect(Segment(at(b[1]), at(b[2])), s);
    default: return CGAL::do_intersect(s, t);
    }
}

std::vector<std::array<std::size_t, 2>> intersections(const Soup &soup) {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
    std::vector<Box> boxes;
    for (std::size_t f = 0; f < soup.faces.size(); ++f) {
        const auto &face = soup.faces[f];
        boxes.emplace_back(soup.points[face[0]].bbox() + soup.points[face[1]].bbox() + soup.points[face[2]].bbox(), f);
    }
    std::vector<std::array<std::size_t, 2>> found;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box &a, const Box &b) {
        if (intersect(soup, a.info(), b.info())) {
            found.push_back({std::min(a.info(), b.info()), std::max(a.info(), b.info())});
        }
    });
    std::sort(found.begin(), found.end());
    return found;
}

bool build(const Soup &soup, Mesh &built) {
    if (!PMP::is_polygon_soup_a_polygon_mesh(soup.faces)) {
        return false;
    }
    PMP::polygon_soup_to_polygon_mesh(soup.points, soup.faces, built);
    return true;
}

/// Distances need no exact arithmetic.
using Plain = CGAL::Simple_cartesian<double>;
using Surface = std::vector<Plain::Triangle_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Plain, CGAL::AABB_triangle_primitive<Plain, Surface::const_iterator>>>;

Plain::Point_3 plain(const Point &p) { return {p.x(), p.y(), p.z()}; }

/// Samples of triangles, evenly by area, within the triangles by the R2 sequence.
std::vector<Plain::Point_3> sampled(const Surface &surface, double count) {
    double area = 0, done = 0;
    for (const auto &t : surface) {
        area += std::sqrt(t.squared_area());
    }
    std::vector<Plain::Point_3> made;
    for (const auto &t : surface) {
        done += std::sqrt(t.squared_area()) / area * count;
        while (static_cast<double>(made.size()) + 0.5 < done) {
            const double n = static_cast<double>(made.size());
            double u = std::fmod(n * 0.7548776662466927, 1.0), v = std::fmod(n * 0.5698402909980532, 1.0);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            made.push_back(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
        }
    }
    return made;
}

Surface surface_of(const Soup &soup) {
    Surface made;
    for (const auto &f : soup.faces) {
        const Plain::Triangle_3 t(plain(soup.points[f[0]]), plain(soup.points[f[1]]), plain(soup.points[f[2]]));
        if (t.squared_area() > 0) {
            made.push_back(t);
        }
    }
    return made;
}

/// A closed part of the original.
struct Part {
    Mesh mesh;
    std::unique_ptr<CGAL::Side_of_triangle_mesh<Mesh, Kernel>> side;
    CGAL::Bbox_3 box;
};

/// The parts of the original.
struct Truth {
    std::vector<Part> parts;
    bool united;

    Truth(const Triangles &mesh, bool is_united) : united(is_united) {
        Mesh whole;
        if (!build(soup(mesh), whole)) {
            throw std::runtime_error("the original is not manifold");
        }
        std::vector<Mesh> split;
        PMP::split_connected_components(whole, split);
        parts.resize(split.size());
        for (std::size_t k = 0; k < split.size(); ++k) {
            parts[k].mesh = std::move(split[k]);
            parts[k].box = PMP::bbox(parts[k].mesh);
            parts[k].side = std::make_unique<CGAL::Side_of_triangle_mesh<Mesh, Kernel>>(parts[k].mesh);
        }
    }

    /// Returns true if a point of part `own` lies within another part.
    bool is_covered(const Point &p, std::size_t own) const {
        for (std::size_t k = 0; united && k < parts.size(); ++k) {
            if (k != own && CGAL::do_overlap(parts[k].box, p.bbox()) && (*parts[k].side)(p) == CGAL::ON_BOUNDED_SIDE) {
                return true;
            }
        }
        return false;
    }

    /// The faces of part k, without those whose corners are all covered.
    Surface visible(std::size_t k) const {
        Surface made;
        const Mesh &mesh = parts[k].mesh;
        for (const auto f : mesh.faces()) {
            std::vector<Point> corners;
            for (const auto v : vertices_around_face(mesh.halfedge(f), mesh)) {
                corners.push_back(mesh.point(v));
            }
            if (!std::all_of(corners.begin(), corners.end(), [&](const Point &p) { return is_covered(p, k); })) {
                made.emplace_back(plain(corners[0]), plain(corners[1]), plain(corners[2]));
            }
        }
        return made;
    }
};

/// The faces that have a corner within another part.
std::vector<std::size_t> covered(const Triangles &mesh) {
    const Truth truth(mesh, true);
    Mesh whole;
    build(soup(mesh), whole);
    std::vector<std::size_t> found;
    auto parts = whole.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
    PMP::connected_components(whole, parts);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t own = parts[Mesh::Face_index(static_cast<Mesh::size_type>(f))];
        const auto *corners = &mesh.corners[3 * f];
        if (std::any_of(corners, corners + 3, [&](uint32_t v) {
                const auto &p = mesh.points[v];
                return truth.is_covered({p[0], p[1], p[2]}, own);
            })) {
            found.push_back(f);
        }
    }
    return found;
}

nlohmann::json judge(const Triangles &triangles, const Triangles &original, bool united) {
    nlohmann::json said;
    const Soup made = soup(triangles);
    const Soup joint = merged(made);
    const auto pairs = intersections(joint);
    const auto degenerate = std::count_if(joint.faces.begin(), joint.faces.end(), [&](const Face &f) {
        return CGAL::collinear(joint.points[f[0]], joint.points[f[1]], joint.points[f[2]]);
    });
    said["intersections"] = pairs.size();
    said["degenerate"] = degenerate;
    Mesh built;
    const bool manifold = build(made, built);
    const bool closed = manifold && CGAL::is_closed(built);
    bool bounds = false;
    if (closed && pairs.empty() && degenerate == 0) {
        // Parts that touch cannot be told apart by rays from a common vertex.
        const bool touches = std::count_if(joint.faces.begin(), joint.faces.end(), [&](const Face &f) {
                                 return f != made.faces[static_cast<std::size_t>(&f - joint.faces.data())];
                             }) > 0;
        bounds = PMP::volume(built) > 0 && (touches || PMP::does_bound_a_volume(built));
    }
    said["manifold"] = manifold;
    said["closed"] = closed;
    said["bounds"] = bounds;
    said["valid"] = bounds;
    const Truth truth(original, united);
    const Surface result = surface_of(made);
    CGAL::Bbox_3 box;
    for (const auto &part : truth.parts) {
        box += part.box;
    }
    const double diagonal = std::sqrt(std::pow(box.x_span(), 2) + std::pow(box.y_span(), 2) + std::pow(box.z_span(), 2));
    said["parts"] = nlohmann::json::array();
    if (result.empty()) {
        said["parts"] = std::vector<double>(truth.parts.size(), 0.0);
        said["rms"] = 1.0;
        return said;
    }
    const Tree tree(result.begin(), result.end());
    Surface everything;
    double sum = 0, count = 0;
    for (std::size_t k = 0; k < truth.parts.size(); ++k) {
        const Surface visible = truth.visible(k);
        everything.insert(everything.end(), visible.begin(), visible.end());
        const double size = std::hypot(truth.parts[k].box.x_span(), truth.parts[k].box.y_span(), truth.parts[k].box.z_span());
        double near = 0, own = 0;
        for (const auto &p : sampled(visible, std::max(100.0, 4000.0 / static_cast<double>(truth.parts.size())))) {
            if (truth.is_covered({p.x(), p.y(), p.z()}, k)) {
                continue;
            }
            const double squared = tree.squared_distance(p);
            sum += squared;
            count += 1;
            own += 1;
            near += squared <= std::pow(0.02 * size, 2);
        }
        said["parts"].push_back(own > 0 ? near / own : 1.0);
    }
    const Tree back(everything.begin(), everything.end());
    double sum_back = 0;
    const auto samples = sampled(result, 4000);
    for (const auto &p : samples) {
        sum_back += back.squared_distance(p);
    }
    said["rms"] = std::sqrt((sum / count + sum_back / static_cast<double>(samples.size())) / 2) / diagonal;
    return said;
}

/// CGAL's functions in the order in which its manual combines them: the soup is repaired and oriented, borders stitched, holes
/// filled, intersections removed.
nlohmann::json repair(const Triangles &mesh, const std::string &out) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> faces;
    for (const auto &p : mesh.points) {
        points.emplace_back(p[0], p[1], p[2]);
    }
    for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
        faces.push_back({mesh.corners[c], mesh.corners[c + 1], mesh.corners[c + 2]});
    }
    Mesh built;
    PMP::repair_polygon_soup(points, faces);
    PMP::orient_polygon_soup(points, faces);
    PMP::polygon_soup_to_polygon_mesh(points, faces, built);
    PMP::stitch_borders(built);
    const auto fill = [&built] {
        std::vector<Mesh::Halfedge_index> borders;
        PMP::extract_boundary_cycles(built, std::back_inserter(borders));
        for (const auto h : borders) {
            std::vector<Mesh::Face_index> patch;
            PMP::triangulate_hole(built, h, std::back_inserter(patch));
        }
    };
    fill();
    PMP::experimental::autorefine_and_remove_self_intersections(built);
    fill();
    if (CGAL::is_closed(built)) {
        PMP::orient_to_bound_a_volume(built);
    }
    const double spent = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    Triangles made;
    std::vector<uint32_t> names(built.number_of_vertices() + built.number_of_removed_vertices());
    for (const auto v : built.vertices()) {
        names[v] = static_cast<uint32_t>(made.points.size());
        made.points.push_back({built.point(v).x(), built.point(v).y(), built.point(v).z()});
    }
    for (const auto f : built.faces()) {
        for (const auto v : vertices_around_face(built.halfedge(f), built)) {
            made.corners.push_back(names[v]);
        }
    }
    write_triangles(made, out);
    return {{"ms", spent}};
}
} // namespace

int main() {
    CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
    std::string line;
    while (std::getline(std::cin, line)) {
        nlohmann::json said;
        try {
            const auto job = nlohmann::json::parse(line);
            const auto mesh = [&](const char *key) { return read_triangles(job.at(key).get<std::string>()); };
            if (job.contains("pairs")) {
                said["pairs"] = intersections(merged(soup(mesh("pairs"))));
            } else if (job.contains("covered")) {
                said["covered"] = covered(mesh("covered"));
            } else if (job.contains("judge")) {
                said = judge(mesh("judge"), mesh("truth"), job.at("united"));
            } else {
                said = repair(mesh("repair"), job.at("out"));
            }
        } catch (const std::exception &error) {
            said = {{"failed", error.what()}};
        }
        std::cout << said.dump() << std::endl;
    }
}
