// Joins judged beside the surface that was there, and joins by CGAL, one job a line on the standard input, one answer a line on the
// standard output; both JSON.
//   {"judge": MESH, "first": FACE, "truth": MESH}             measures of the faces from FACE on
//   {"join": MESH, "rims": [[[v..], [v..]]..], "out": MESH}   by a bridge of two triangles between each two rims, the hole that is left
//                                                             triangulated, refined and faired; the new faces last: {"first", "ms"}
//   {"fill": MESH, "fair": BOOL, "out": MESH}                 all holes triangulated, and refined and faired if asked; the same answer;
//                                                             with "shortest" the shortest hole only
#include "mesh.hpp"
#include "mesh_judge.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <stdexcept>

namespace {
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;

/// The boundary half-edge that leads to `v`.
Halfedge border_to(const Mesh &mesh, Vertex v) {
    for (const Halfedge h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh)) {
        if (mesh.is_border(h)) {
            return h;
        }
    }
    throw std::runtime_error("a vertex of a rim is not on the boundary");
}

/// Joins two rims at their closest vertices by two triangles, which leaves one hole: an edge of it.
Halfedge bridge(Mesh &mesh, const std::vector<uint32_t> &a, const std::vector<uint32_t> &b) {
    double least = HUGE_VAL;
    Vertex p, q;
    for (const uint32_t u : a) {
        for (const uint32_t v : b) {
            const double squared = CGAL::squared_distance(mesh.point(Vertex(u)), mesh.point(Vertex(v)));
            if (squared < least) {
                least = squared;
                p = Vertex(u);
                q = Vertex(v);
            }
        }
    }
    // The hole runs from p to its next vertex, and from the vertex before q to q: they are on opposite sides of the bridge.
    const Vertex after = mesh.target(mesh.next(border_to(mesh, p))), before = mesh.source(border_to(mesh, q));
    if (mesh.add_face(p, after, q) == Mesh::null_face() || mesh.add_face(q, after, before) == Mesh::null_face()) {
        throw std::runtime_error("CGAL takes no bridge there");
    }
    return border_to(mesh, q);
}

Mesh built(const Triangles &given) {
    Mesh mesh;
    for (const auto &p : given.points) {
        mesh.add_vertex({p[0], p[1], p[2]});
    }
    for (std::size_t c = 0; c < given.corners.size(); c += 3) {
        if (mesh.add_face(Vertex(given.corners[c]), Vertex(given.corners[c + 1]), Vertex(given.corners[c + 2])) == Mesh::null_face()) {
            throw std::runtime_error("CGAL does not take the mesh");
        }
    }
    return mesh;
}

void write(const Mesh &mesh, const std::string &path) {
    Triangles out;
    for (const Vertex v : mesh.vertices()) {
        const auto &p = mesh.point(v);
        out.points.push_back({p.x(), p.y(), p.z()});
    }
    for (const Mesh::Face_index f : mesh.faces()) {
        for (const Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
            out.corners.push_back(static_cast<uint32_t>(v));
        }
    }
    write_triangles(out, path);
}

/// Fills the hole at a border half-edge.
void close(Mesh &mesh, Halfedge hole, bool fair) {
    std::vector<Mesh::Face_index> faces;
    if (fair) {
        std::vector<Vertex> vertices;
        PMP::triangulate_refine_and_fair_hole(mesh, hole, std::back_inserter(faces), std::back_inserter(vertices));
    } else {
        PMP::triangulate_hole(mesh, hole, std::back_inserter(faces));
    }
    if (faces.empty()) {
        throw std::runtime_error("CGAL fills no hole there");
    }
}

/// Reads a mesh, lets `work` add faces to it, and writes it.
template <class Work> nlohmann::json timed(const std::string &in, const std::string &out, const Work &work) {
    const Triangles given = read_triangles(in);
    const auto start = std::chrono::steady_clock::now();
    Mesh mesh = built(given);
    work(mesh);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    write(mesh, out);
    return {{"first", given.face_count()}, {"ms", time.count()}};
}

nlohmann::json join(const nlohmann::json &job) {
    return timed(job.at("join"), job.at("out"), [&](Mesh &mesh) {
        for (const auto &pair : job.at("rims")) {
            close(mesh, bridge(mesh, pair.at(0), pair.at(1)), true);
        }
    });
}

nlohmann::json fill(const nlohmann::json &job) {
    return timed(job.at("fill"), job.at("out"), [&](Mesh &mesh) {
        std::vector<Halfedge> holes;
        PMP::extract_boundary_cycles(mesh, std::back_inserter(holes));
        if (job.value("shortest", false)) {
            const auto length = [&](Halfedge h) { return PMP::face_border_length(h, mesh); };
            const auto shorter = [&](Halfedge g, Halfedge h) { return length(g) < length(h); };
            holes = {*std::min_element(holes.begin(), holes.end(), shorter)};
        }
        for (const Halfedge hole : holes) {
            close(mesh, hole, job.at("fair"));
        }
    });
}

nlohmann::json judge(const nlohmann::json &job) {
    const Triangles mesh = read_triangles(job.at("judge"));
    const std::size_t first = job.at("first");
    if (first >= mesh.face_count()) {
        throw std::runtime_error("there are no new faces");
    }
    nlohmann::json out = {{"faces", mesh.face_count() - first}};
    shapes(mesh, first, out);
    edges(mesh, first, out);
    intersections(mesh, first, false, out);
    distance(mesh, first, read_triangles(job.at("truth")), out);
    return out;
}
} // namespace

int main() {
    for (std::string line; std::getline(std::cin, line);) {
        nlohmann::json answer;
        try {
            const auto job = nlohmann::json::parse(line);
            answer = job.contains("join") ? join(job) : job.contains("fill") ? fill(job) : judge(job);
        } catch (const std::exception &error) {
            answer = {{"failed", error.what()}};
        }
        std::cout << answer.dump() << std::endl;
    }
    return 0;
}
