// Counts pairs of intersecting triangles by CGAL. Reads meshes from standard input: two counts, the points, the corners of the
// triangles. Writes one line for each mesh.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = Mesh::Face_index;

template <typename T>
bool read(std::vector<T> &values) {
    return static_cast<bool>(std::cin.read(reinterpret_cast<char *>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T))));
}

/// Whether two faces have a corner at the same place. CGAL doubles the vertices at which a mesh is not manifold.
bool share_a_corner(const Mesh &mesh, Face first, Face second) {
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(first))) {
        for (const auto w : mesh.vertices_around_face(mesh.halfedge(second))) {
            if (v != w && mesh.point(v) == mesh.point(w)) {
                return true;
            }
        }
    }
    return false;
}

std::size_t count_cuts(std::vector<Point> &points, std::vector<std::array<std::size_t, 3>> &faces) {
    PMP::orient_polygon_soup(points, faces);
    Mesh mesh;
    PMP::polygon_soup_to_polygon_mesh(points, faces, mesh);
    std::vector<std::pair<Face, Face>> pairs;
    PMP::self_intersections(mesh, std::back_inserter(pairs));
    std::size_t cuts = 0;
    for (const auto &[first, second] : pairs) {
        cuts += !share_a_corner(mesh, first, second);
    }
    return cuts;
}

} // namespace

int main() {
    std::vector<std::uint64_t> counts(2);
    while (read(counts)) {
        std::vector<double> coordinates(3 * counts[0]);
        std::vector<std::uint32_t> corners(3 * counts[1]);
        if (!read(coordinates) || !read(corners)) {
            return 1;
        }
        std::vector<Point> points;
        for (std::size_t i = 0; i < coordinates.size(); i += 3) {
            points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
        }
        std::vector<std::array<std::size_t, 3>> faces;
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            faces.push_back({corners[i], corners[i + 1], corners[i + 2]});
        }
        std::cout << count_cuts(points, faces) << std::endl;
    }
}
