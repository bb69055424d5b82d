#include "oracle.hpp"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

Point point(const gusset::Point3 &p) { return {p[0], p[1], p[2]}; }
Kernel::Vector_3 vector(const gusset::Point3 &p) { return {p[0], p[1], p[2]}; }
} // namespace

struct Oracle::Parts {
    Mesh mesh;
    Tree tree;
    /// Made for the first section, since it sorts all edges.
    std::optional<CGAL::Polygon_mesh_slicer<Mesh, Kernel>> slicer;
};

Oracle::Oracle(const gusset::MeshView &mesh) : parts_(std::make_unique<Parts>()) {
    std::vector<Mesh::Vertex_index> vertices;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        vertices.push_back(parts_->mesh.add_vertex(point(mesh.position(v))));
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const gusset::Indices face = mesh.face(f);
        for (std::size_t k = 2; k < face.size(); ++k) {
            parts_->mesh.add_face(vertices[face[0]], vertices[face[k - 1]], vertices[face[k]]);
        }
    }
    parts_->tree.insert(faces(parts_->mesh).begin(), faces(parts_->mesh).end(), parts_->mesh);
    parts_->tree.build();
    parts_->tree.accelerate_distance_queries();
}

Oracle::~Oracle() = default;

double Oracle::distance(const gusset::Point3 &query) const { return std::sqrt(parts_->tree.squared_distance(point(query))); }

std::vector<double> Oracle::crossings(const gusset::Point3 &origin, const gusset::Point3 &direction) const {
    std::vector<Tree::Intersection_and_primitive_id<Kernel::Line_3>::Type> met;
    parts_->tree.all_intersections(Kernel::Line_3(point(origin), vector(direction)), std::back_inserter(met));
    std::vector<double> found;
    for (const auto &one : met) {
        if (const Point *at = boost::get<Point>(&one.first)) {
            found.push_back((*at - point(origin)) * vector(direction) / vector(direction).squared_length());
        }
    }
    std::sort(found.begin(), found.end());
    // A line through an edge meets both of its triangles.
    found.erase(std::unique(found.begin(), found.end(), [](double a, double b) { return std::abs(a - b) < 1e-12; }), found.end());
    return found;
}

std::vector<Slice> Oracle::slices(const gusset::Point3 &at, const gusset::Point3 &normal) const {
    if (!parts_->slicer) {
        parts_->slicer.emplace(parts_->mesh);
    }
    std::vector<std::vector<Point>> lines;
    (*parts_->slicer)(Kernel::Plane_3(point(at), vector(normal)), std::back_inserter(lines));
    std::vector<Slice> found;
    for (const std::vector<Point> &line : lines) {
        Slice slice{line.front() == line.back(), 0};
        for (std::size_t k = 1; k < line.size(); ++k) {
            slice.length += std::sqrt((line[k] - line[k - 1]).squared_length());
        }
        found.push_back(slice);
    }
    std::sort(found.begin(), found.end(), [](const Slice &a, const Slice &b) { return a.length > b.length; });
    return found;
}
