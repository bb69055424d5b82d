/// @file
/// CGAL surface meshes as input and output of gusset. Needs CGAL 5 or later.
///
/// The view's vertex v is the host's Vertex_index(v): positions are read where CGAL keeps them,
/// removed vertices included, which no face uses. Faces are numbered without the removed ones;
/// face(f) is the host's index. Kernels whose points are three doubles side by side are taken:
/// `Simple_cartesian<double>`, the EPICK kernel and their like.
#ifndef GUSSET_CGAL_HPP
#define GUSSET_CGAL_HPP

#include <gusset.hpp>
#include <gusset/cgal_properties.hpp>

#include <CGAL/Surface_mesh.h>

#include <type_traits>
#include <vector>

namespace gusset::cgal {

/// A CGAL surface mesh as gusset sees it. Positions are read in place, so the mesh must outlive this object and keep
/// its vertices; vertices of faces are copied, because CGAL lacks an array of them.
template <class Point>
class Input {
    using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
    static_assert(std::is_same_v<typename Kernel::FT, double>,
                  "gusset reads points of double coordinates: use a kernel such as "
                  "CGAL::Exact_predicates_inexact_constructions_kernel or CGAL::Simple_cartesian<double>");
    static_assert(sizeof(Point) == 3 * sizeof(double) && std::is_standard_layout_v<Point>,
                  "gusset reads points that are three doubles side by side; this kernel stores them otherwise");

public:
    /// The mesh of the host.
    using Mesh = CGAL::Surface_mesh<Point>;

    /// Reads a mesh, which must stay as it is while this is used.
    explicit Input(const Mesh &mesh) : mesh_(&mesh) {
        offsets_.reserve(mesh.number_of_faces() + 1);
        corners_.reserve(mesh.number_of_halfedges());
        faces_.reserve(mesh.number_of_faces());
        offsets_.push_back(0);
        for (auto face : mesh.faces()) { // without removed ones
            for (auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
                corners_.push_back(static_cast<uint32_t>(vertex));
            }
            offsets_.push_back(static_cast<uint32_t>(corners_.size()));
            faces_.push_back(face);
        }
    }

    /// The mesh as the library reads it.
    MeshView view() const {
        // Removed vertices keep their places in the array until garbage is collected.
        const std::size_t count = mesh_->number_of_vertices() + mesh_->number_of_removed_vertices();
        const Point *first = count == 0 ? nullptr : &mesh_->point(typename Mesh::Vertex_index(0));
        auto view = gusset::detail::sized<gusset_mesh_view>();
        view.positions = first;
        view.position_stride = sizeof(Point);
        view.vertex_count = count;
        view.face_offsets = offsets_.data();
        view.face_corners = corners_.data();
        view.face_count = faces_.size();
        view.scalar = GUSSET_F64;
        return MeshView(view);
    }

    /// The face of the host that face `f` of the view is.
    typename Mesh::Face_index face(uint32_t f) const { return faces_[f]; }
    /// The vertex of the host that vertex `v` of the view is.
    typename Mesh::Vertex_index vertex(uint32_t v) const { return typename Mesh::Vertex_index(v); }

private:
    const Mesh *mesh_;
    std::vector<uint32_t> offsets_, corners_;
    std::vector<typename Mesh::Face_index> faces_;
};

namespace detail {
/// Adds the faces of `view`. Its vertex v is the host's vertices[v]. Returns the faces that CGAL refuses.
template <class Point>
std::vector<uint32_t> add_faces(CGAL::Surface_mesh<Point> &mesh, const MeshView &view,
                                const std::vector<typename CGAL::Surface_mesh<Point>::Vertex_index> &vertices) {
    std::vector<uint32_t> refused;
    std::vector<typename CGAL::Surface_mesh<Point>::Vertex_index> corners;
    for (std::size_t f = 0; f < view.face_count(); ++f) {
        corners.clear();
        for (uint32_t v : view.face(f)) {
            corners.push_back(vertices[v]);
        }
        if (mesh.add_face(corners) == CGAL::Surface_mesh<Point>::null_face()) {
            refused.push_back(static_cast<uint32_t>(f));
        }
    }
    return refused;
}
} // namespace detail

/// Appends a whole result to `mesh` (usually an empty one). Returns the faces that CGAL refused
/// because it takes two-manifolds only: empty if all went in.
template <class Point>
std::vector<uint32_t> append(CGAL::Surface_mesh<Point> &mesh, const MeshView &result) {
    std::vector<typename CGAL::Surface_mesh<Point>::Vertex_index> vertices;
    vertices.reserve(result.vertex_count());
    for (std::size_t v = 0; v < result.vertex_count(); ++v) {
        const auto p = result.position(v);
        vertices.push_back(mesh.add_vertex(Point(p[0], p[1], p[2])));
    }
    return detail::add_faces(mesh, result, vertices);
}

/// Appends a whole result, and carries over what its inputs have: property maps of floats, doubles, ints, longs, unsigned ones of
/// them, unsigned shorts and chars, arrays of two to four floats, doubles or ints, of three or four unsigned chars, colours, and vectors,
/// of vertices, halfedges and faces, by their names; others stay behind. No input may be the mesh itself. Halfedges
/// count as the corners that they end at. Vectors with "normal" in their name are directions, and reversed with
/// reversed faces; "f:normal" is left to the host. `inputs`: the meshes that the result was made
/// of, in their order. Returns the faces that CGAL refused.
template <class Point>
std::vector<uint32_t> append(CGAL::Surface_mesh<Point> &mesh, const MeshView &result, const Origins &origins,
                             const std::vector<const CGAL::Surface_mesh<Point> *> &inputs, const Context &context = Context()) {
    using Mesh = CGAL::Surface_mesh<Point>;
    std::vector<typename Mesh::Vertex_index> vertices;
    for (std::size_t v = 0; v < result.vertex_count(); ++v) {
        const auto p = result.position(v);
        vertices.push_back(mesh.add_vertex(Point(p[0], p[1], p[2])));
    }
    std::vector<uint32_t> refused;
    std::vector<typename Mesh::Face_index> faces;
    std::vector<typename Mesh::Halfedge_index> corners;
    std::vector<typename Mesh::Vertex_index> around;
    for (std::size_t f = 0; f < result.face_count(); ++f) {
        around.clear();
        for (const uint32_t v : result.face(f)) {
            around.push_back(vertices[v]);
        }
        faces.push_back(mesh.add_face(around));
        const bool there = faces.back() != Mesh::null_face();
        if (!there) {
            refused.push_back(static_cast<uint32_t>(f));
        }
        for (const auto v : around) {
            auto end = Mesh::null_halfedge();
            if (there) {
                for (const auto h : mesh.halfedges_around_face(mesh.halfedge(faces.back()))) {
                    end = mesh.target(h) == v ? h : end;
                }
            }
            corners.push_back(end);
        }
    }
    std::vector<std::vector<typename Mesh::Vertex_index>> old_vertices;
    std::vector<std::vector<typename Mesh::Halfedge_index>> old_corners;
    std::vector<std::vector<typename Mesh::Face_index>> old_faces;
    for (const Mesh *input : inputs) {
        old_vertices.emplace_back(), old_corners.emplace_back(), old_faces.emplace_back();
        // Removed ones too: the view has them.
        const std::size_t count = input->number_of_vertices() + input->number_of_removed_vertices();
        for (std::size_t v = 0; v < count; ++v) {
            old_vertices.back().emplace_back(static_cast<typename Mesh::size_type>(v));
        }
        for (const auto face : input->faces()) {
            old_faces.back().push_back(face);
            for (const auto h : input->halfedges_around_face(input->halfedge(face))) {
                old_corners.back().push_back(h);
            }
        }
    }
    detail::carry_all(mesh, Domain::vertices, vertices, origins, inputs, old_vertices, context);
    detail::carry_all(mesh, Domain::corners, corners, origins, inputs, old_corners, context);
    detail::carry_all(mesh, Domain::faces, faces, origins, inputs, old_faces, context);
    return refused;
}

/// Adds the strip of a stitch within one mesh to that mesh itself: its own vertices and faces keep
/// their indices, and its property maps stay. For a stitch that turned nothing over (turned() is
/// false). Returns the strip's faces that CGAL refused.
template <class Point>
std::vector<uint32_t> append_strip(CGAL::Surface_mesh<Point> &mesh, const Stitch &stitch) {
    if (stitch.turned() || !stitch.vertex_map(1).empty()) {
        gusset::detail::refuse(GUSSET_ERROR_ORIENTATION_CONFLICT, "the strip does not fit: the stitch is of two meshes, or turned one over");
    }
    std::vector<typename CGAL::Surface_mesh<Point>::Vertex_index> vertices;
    // The vertices of the mesh keep their numbers; the strip's own vertices follow the vertices of its rims.
    for (int side : {0, 1}) {
        for (uint32_t v : stitch.rim(side)) {
            vertices.emplace_back(v);
        }
    }
    const MeshView strip = stitch.strip();
    for (std::size_t v = vertices.size(); v < strip.vertex_count(); ++v) {
        const auto p = strip.position(v);
        vertices.push_back(mesh.add_vertex(Point(p[0], p[1], p[2])));
    }
    return detail::add_faces(mesh, strip, vertices);
}

} // namespace gusset::cgal

#endif // GUSSET_CGAL_HPP
