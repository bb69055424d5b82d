/// @file
/// OpenMesh meshes as input and output of gusset. Needs OpenMesh 8 or later.
///
/// The view's vertex v is the host's VertexHandle(v): positions are read where OpenMesh keeps them,
/// deleted vertices included, which no face uses. Faces are numbered without the deleted ones;
/// face(f) is the host's handle.
#ifndef GUSSET_OPENMESH_HPP
#define GUSSET_OPENMESH_HPP

#include <gusset.hpp>
#include <gusset/openmesh_properties.hpp>

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Core/Utils/vector_traits.hh>

#include <vector>

namespace gusset::openmesh {

/// A mesh of the host's as gusset sees it. Positions are read in place, so the mesh must outlive this object and keep
/// its vertices; vertices of faces are copied, because OpenMesh lacks an array of them.
template <class Mesh>
class Input {
public:
    /// Reads a mesh, which must stay as it is while this is used.
    explicit Input(const Mesh &mesh) : mesh_(&mesh) {
        offsets_.reserve(mesh.n_faces() + 1);
        corners_.reserve(3 * mesh.n_faces());
        faces_.reserve(mesh.n_faces());
        offsets_.push_back(0);
        // faces_begin() to faces_end() passes deleted faces too: they are left out here.
        for (auto it = mesh.faces_begin(); it != mesh.faces_end(); ++it) {
            if (mesh.has_face_status() && mesh.status(*it).deleted()) {
                continue;
            }
            for (auto vertex = mesh.cfv_ccwbegin(*it); vertex != mesh.cfv_ccwend(*it); ++vertex) {
                corners_.push_back(static_cast<uint32_t>(vertex->idx()));
            }
            offsets_.push_back(static_cast<uint32_t>(corners_.size()));
            faces_.push_back(*it);
        }
    }

    /// The mesh as the library reads it.
    MeshView view() const {
        const Span<const typename Mesh::Point> points(mesh_->points(), mesh_->n_vertices());
        return MeshView::polygons(points, Offsets(offsets_), Corners(corners_));
    }

    /// The face of the host that face `f` of the view is.
    OpenMesh::FaceHandle face(uint32_t f) const { return faces_[f]; }
    /// The vertex of the host that vertex `v` of the view is.
    OpenMesh::VertexHandle vertex(uint32_t v) const { return OpenMesh::VertexHandle(static_cast<int>(v)); }

private:
    const Mesh *mesh_;
    std::vector<uint32_t> offsets_, corners_;
    std::vector<OpenMesh::FaceHandle> faces_;
};

namespace detail {
template <class Mesh>
OpenMesh::VertexHandle add_vertex(Mesh &mesh, const std::array<double, 3> &p) {
    using Point = typename Mesh::Point;
    using Scalar = typename OpenMesh::vector_traits<Point>::value_type;
    return mesh.add_vertex(Point(static_cast<Scalar>(p[0]), static_cast<Scalar>(p[1]), static_cast<Scalar>(p[2])));
}

/// Adds the faces of `view`. Its vertex v is the host's vertices[v]. Returns the faces that OpenMesh refuses.
template <class Mesh>
std::vector<uint32_t> add_faces(Mesh &mesh, const MeshView &view, const std::vector<OpenMesh::VertexHandle> &vertices) {
    std::vector<uint32_t> refused;
    std::vector<typename Mesh::VertexHandle> corners;
    for (std::size_t f = 0; f < view.face_count(); ++f) {
        corners.clear();
        for (uint32_t v : view.face(f)) {
            corners.push_back(vertices[v]);
        }
        if (!mesh.add_face(corners).is_valid()) {
            refused.push_back(static_cast<uint32_t>(f));
        }
    }
    return refused;
}
} // namespace detail

/// Appends a whole result to `mesh` (usually an empty one): vertex v becomes the host's vertex v +
/// old n_vertices(). Returns the faces that OpenMesh refused because it takes two-manifolds only:
/// empty if all went in.
template <class Mesh>
std::vector<uint32_t> append(Mesh &mesh, const MeshView &result) {
    std::vector<OpenMesh::VertexHandle> vertices;
    vertices.reserve(result.vertex_count());
    for (std::size_t v = 0; v < result.vertex_count(); ++v) {
        vertices.push_back(detail::add_vertex(mesh, result.position(v)));
    }
    return detail::add_faces(mesh, result, vertices);
}

/// Appends a whole result, and carries over what its inputs have: the normals, colours and texture coordinates that OpenMesh keeps, and
/// properties of floats, doubles, chars, ints, shorts and longs, signed or not, and of up to four floats, doubles or ints, of
/// vertices, halfedges and faces, by their names; others stay behind. Halfedges count as the corners that they end at. No input may be
/// the mesh itself. Normals are reversed with reversed faces; normals of faces are left to update_face_normals().
/// `inputs`: the
/// meshes that the result was made of, in their order. Returns the faces that OpenMesh refused.
template <class Mesh>
std::vector<uint32_t> append(Mesh &mesh, const MeshView &result, const Origins &origins, const std::vector<const Mesh *> &inputs,
                             const Context &context = Context()) {
    std::vector<OpenMesh::VertexHandle> vertices;
    for (std::size_t v = 0; v < result.vertex_count(); ++v) {
        vertices.push_back(detail::add_vertex(mesh, result.position(v)));
    }
    const std::size_t first = mesh.n_faces();
    const std::vector<uint32_t> refused = detail::add_faces(mesh, result, vertices);
    // The faces of the result that are there, and the halfedge that ends at each corner.
    std::vector<OpenMesh::FaceHandle> faces;
    std::vector<OpenMesh::HalfedgeHandle> corners;
    std::size_t next = first, skipped = 0;
    for (std::size_t f = 0; f < result.face_count(); ++f) {
        const bool there = skipped == refused.size() || refused[skipped] != f;
        skipped += there ? 0 : 1;
        faces.push_back(there ? OpenMesh::FaceHandle(static_cast<int>(next++)) : OpenMesh::FaceHandle());
        for (const uint32_t v : result.face(f)) {
            OpenMesh::HalfedgeHandle end;
            for (auto h = there ? mesh.cfh_ccwbegin(faces.back()) : typename Mesh::ConstFaceHalfedgeCCWIter(); there && h.is_valid(); ++h) {
                end = mesh.to_vertex_handle(*h) == vertices[v] ? *h : end;
            }
            corners.push_back(end);
        }
    }
    std::vector<std::vector<OpenMesh::VertexHandle>> old_vertices;
    std::vector<std::vector<OpenMesh::HalfedgeHandle>> old_corners;
    std::vector<std::vector<OpenMesh::FaceHandle>> old_faces;
    for (const Mesh *input : inputs) {
        old_vertices.emplace_back(), old_corners.emplace_back(), old_faces.emplace_back();
        for (std::size_t v = 0; v < input->n_vertices(); ++v) {
            old_vertices.back().push_back(OpenMesh::VertexHandle(static_cast<int>(v)));
        }
        for (auto face = input->faces_begin(); face != input->faces_end(); ++face) {
            if (input->has_face_status() && input->status(*face).deleted()) {
                continue;
            }
            old_faces.back().push_back(*face);
            for (auto h = input->cfh_ccwbegin(*face); h != input->cfh_ccwend(*face); ++h) {
                old_corners.back().push_back(*h);
            }
        }
    }
    detail::carry_all<detail::OfVertices>(mesh, vertices, origins, inputs, old_vertices, context);
    detail::carry_all<detail::OfCorners>(mesh, corners, origins, inputs, old_corners, context);
    detail::carry_all<detail::OfFaces>(mesh, faces, origins, inputs, old_faces, context);
    return refused;
}

/// Adds the strip of a stitch within one mesh to that mesh itself: its own vertices and faces keep
/// their handles, and its properties stay. For a stitch that turned nothing over (turned() is
/// false). Returns the strip's faces that OpenMesh refused.
template <class Mesh>
std::vector<uint32_t> append_strip(Mesh &mesh, const Stitch &stitch) {
    if (stitch.turned() || !stitch.vertex_map(1).empty()) {
        gusset::detail::refuse(GUSSET_ERROR_ORIENTATION_CONFLICT, "the strip does not fit: the stitch is of two meshes, or turned one over");
    }
    // The vertices of the mesh keep their numbers; the strip's own vertices follow the vertices of its rims.
    std::vector<OpenMesh::VertexHandle> vertices;
    for (int side : {0, 1}) {
        for (uint32_t v : stitch.rim(side)) {
            vertices.push_back(OpenMesh::VertexHandle(static_cast<int>(v)));
        }
    }
    const MeshView strip = stitch.strip();
    for (std::size_t v = vertices.size(); v < strip.vertex_count(); ++v) {
        vertices.push_back(detail::add_vertex(mesh, strip.position(v)));
    }
    return detail::add_faces(mesh, strip, vertices);
}

} // namespace gusset::openmesh

#endif // GUSSET_OPENMESH_HPP
