/// @file
/// Winged-edge tables. Include gusset.hpp, not this.
#ifndef GUSSET_WINGED_HPP
#define GUSSET_WINGED_HPP

#include <gusset/mesh.hpp>
#include <gusset/papers_options.hpp>

namespace gusset {

/// Winged-edge tables; see gusset_winged_create.
class Winged {
public:
    /// The tables of a mesh.
    explicit Winged(const MeshView &mesh, const WingedOptions &options = {}, const Context &context = Context()) {
        const gusset_winged_options given = detail::as_c(options);
        winged_.reset(context.result(gusset_winged_create, &mesh.get(), &given));
    }
    /// The edges; see gusset_winged_edge.
    Span<const gusset_winged_edge> edges() const & {
        const gusset_winged_view found = view();
        return {found.edges, found.edge_count};
    }
    Span<const gusset_winged_edge> edges() const && = delete;
    /// For each half-edge its edge.
    Indices edge_of_half_edge() const & { return detail::indices(view().edge_of_half_edge); }
    Indices edge_of_half_edge() const && = delete;
    /// For each face its first edge.
    Indices edge_of_face() const & { return detail::indices(view().edge_of_face); }
    Indices edge_of_face() const && = delete;
    /// For each vertex an edge at it, or UINT32_MAX.
    Indices edge_of_vertex() const & { return detail::indices(view().edge_of_vertex); }
    Indices edge_of_vertex() const && = delete;
    /// Loops of free edges, found on the tables: loop i has the vertices from loop_offsets()[i] to
    /// loop_offsets()[i + 1].
    Indices loop_vertices() const & { return detail::indices(view().loop_vertices); }
    Indices loop_vertices() const && = delete;
    /// The edges along the loops: edge i starts at vertex i.
    Indices loop_edges() const & { return detail::indices(view().loop_edges); }
    Indices loop_edges() const && = delete;
    /// The first vertex of each loop, then the number of vertices.
    Indices loop_offsets() const & { return detail::indices(view().loop_offsets); }
    Indices loop_offsets() const && = delete;

private:
    gusset_winged_view view() const { return detail::lent(gusset_winged_get_view, winged_.get()); }
    detail::Handle<gusset_winged, gusset_winged_destroy> winged_;
};

/// The faces of a table of edges, for meshes whose positions are elsewhere; see
/// gusset_winged_faces_create.
class WingedFaces {
public:
    /// Reads a table of the caller. `first_edges`: the first edge of each face; empty selects its edge with the
    /// smallest number.
    WingedFaces(Span<const gusset_winged_edge> edges, std::size_t vertex_count, Indices first_edges = {},
                const WingedOptions &options = {}, const Context &context = Context()) {
        const gusset_winged_options given = detail::as_c(options);
        const gusset_indices first = {first_edges.data(), first_edges.size()};
        faces_.reset(context.result(gusset_winged_faces_create, edges.data(), edges.size(), vertex_count,
                                    first_edges.size() != 0 ? &first : nullptr, &given));
    }
    /// The first corner of each face, then the number of corners.
    Indices offsets() const & { return detail::indices(view().face_offsets); }
    Indices offsets() const && = delete;
    /// The vertices of each face in order.
    Indices corners() const & { return detail::indices(view().face_corners); }
    Indices corners() const && = delete;
    /// For each corner the edge that leaves it.
    Indices edge_of_half_edge() const & { return detail::indices(view().edge_of_half_edge); }
    Indices edge_of_half_edge() const && = delete;

private:
    gusset_winged_faces_view view() const { return detail::lent(gusset_winged_faces_get_view, faces_.get()); }
    detail::Handle<gusset_winged_faces, gusset_winged_faces_destroy> faces_;
};

} // namespace gusset

#endif // GUSSET_WINGED_HPP
