#include "cgal_fill.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <tuple>

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

std::size_t cgal_fill(const Soup &soup, bool fair) {
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    for (const auto &p : soup.points) {
        points.emplace_back(p[0], p[1], p[2]);
    }
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        faces.emplace_back(soup.view().face(f).begin(), soup.view().face(f).end());
    }
    Mesh mesh;
    PMP::polygon_soup_to_polygon_mesh(points, faces, mesh);
    // Its refinement takes triangles only.
    PMP::triangulate_faces(mesh);
    std::vector<Mesh::Halfedge_index> cycles;
    PMP::extract_boundary_cycles(mesh, std::back_inserter(cycles));
    for (auto h : cycles) {
        std::vector<Mesh::Face_index> patch;
        std::vector<Mesh::Vertex_index> vertices;
        if (fair) {
            PMP::triangulate_refine_and_fair_hole(mesh, h, std::back_inserter(patch), std::back_inserter(vertices));
        } else {
            PMP::triangulate_hole(mesh, h, std::back_inserter(patch));
        }
    }
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
    PMP::self_intersections(mesh, std::back_inserter(pairs));
    return pairs.size();
}
