#include "judge.hpp"

#include "cgal_soup.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Verdict judge(const gusset::MeshView &view, bool intersections) {
    auto [points, faces] = CgalSoup<Kernel::Point_3>(view);
    Verdict verdict;
    if (!PMP::is_polygon_soup_a_polygon_mesh(faces)) {
        return verdict;
    }
    Mesh mesh;
    PMP::polygon_soup_to_polygon_mesh(points, faces, mesh);
    verdict.is_mesh = CGAL::is_valid_polygon_mesh(mesh);
    verdict.closed = CGAL::is_closed(mesh);
    auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
    verdict.components = PMP::connected_components(mesh, component);
    long used = 0;
    for (auto v : mesh.vertices()) {
        used += !mesh.is_isolated(v);
    }
    verdict.euler = used - static_cast<long>(mesh.number_of_edges()) + static_cast<long>(mesh.number_of_faces());

    std::vector<Mesh::Halfedge_index> cycles;
    PMP::extract_boundary_cycles(mesh, std::back_inserter(cycles));
    for (auto start : cycles) {
        const auto round = CGAL::halfedges_around_face(start, mesh);
        verdict.boundary.push_back(static_cast<std::size_t>(std::distance(round.begin(), round.end())));
    }
    std::sort(verdict.boundary.begin(), verdict.boundary.end(), std::greater<>());

    if (intersections) {
        PMP::triangulate_faces(mesh);
        std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
        PMP::self_intersections(mesh, std::back_inserter(pairs));
        verdict.self_intersections = pairs.size();
        verdict.bounds_a_volume = verdict.closed && pairs.empty() && PMP::does_bound_a_volume(mesh);
    }
    return verdict;
}

std::set<std::pair<uint32_t, uint32_t>> intersecting_pairs(const gusset::MeshView &view, std::size_t first_new, std::size_t new_count) {
    auto [points, faces] = CgalSoup<Kernel::Point_3>(view);
    if (!PMP::is_polygon_soup_a_polygon_mesh(faces)) {
        throw std::invalid_argument("no mesh for CGAL");
    }
    Mesh mesh;
    PMP::polygon_soup_to_polygon_mesh(points, faces, mesh);
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
    PMP::self_intersections(mesh, std::back_inserter(found));
    const auto is_new = [&](uint32_t f) { return f >= first_new && f < first_new + new_count; };
    std::set<std::pair<uint32_t, uint32_t>> pairs;
    for (const auto &[p, q] : found) {
        const auto f = static_cast<uint32_t>(p), g = static_cast<uint32_t>(q);
        if (is_new(f) || is_new(g)) {
            pairs.insert({std::max(f, g), std::min(f, g)});
        }
    }
    return pairs;
}
