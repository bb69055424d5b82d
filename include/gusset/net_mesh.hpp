/// @file
/// From nets to meshes and back. Include gusset.hpp, not this.
#ifndef GUSSET_NET_MESH_HPP
#define GUSSET_NET_MESH_HPP

#include <gusset/result.hpp>
#include <gusset/net.hpp>

namespace gusset {

/// The mesh of a net; see gusset_net_to_mesh. It keeps nothing of the net; views and spans live
/// as long as this.
class NetMesh : public Result {
public:
    /// The index of an element that is not in the mesh.
    static constexpr uint32_t none = UINT32_MAX;

    /// See ::gusset_net_to_mesh.
    explicit NetMesh(const Net &net, const NetMeshOptions &options = {}, const Context &context = Context()) {
        const gusset_net_mesh_options given = detail::as_c(options);
        take(context.result(gusset_net_to_mesh, net.get(), &given));
    }

    /// For each node its vertex, or UINT32_MAX.
    Indices vertex_of_node() const & { return detail::indices(report().vertex_of_node); }
    Indices vertex_of_node() const && = delete;
    /// For each vertex the first of its nodes.
    Indices node_of_vertex() const & { return detail::indices(report().node_of_vertex); }
    Indices node_of_vertex() const && = delete;
    /// For each face its cell: cell (i, j) is i * (columns - 1) + j.
    Indices cell_of_face() const & { return detail::indices(report().cell_of_face); }
    Indices cell_of_face() const && = delete;
    /// Edges without faces, two vertices each.
    Indices wires() const & { return detail::indices(report().wires); }
    Indices wires() const && = delete;
    /// For each corner of the mesh the index of its texture coordinates; empty unless requested.
    Indices texture_corners() const & { return detail::indices(report().texture_corners); }
    Indices texture_corners() const && = delete;
    /// u and v from 0 to 1: column and row.
    Span<const std::array<double, 2>> texture_coordinates() const & {
        static_assert(sizeof(std::array<double, 2>) == 2 * sizeof(double), "packed");
        const gusset_net_mesh_report found = report();
        return {reinterpret_cast<const std::array<double, 2> *>(found.texture_coordinates), found.texture_count};
    }
    Span<const std::array<double, 2>> texture_coordinates() const && = delete;

private:
    gusset_net_mesh_report report() const { return detail::lent(gusset_result_get_net_mesh, get()); }
};

/// A net that was found in a mesh; see gusset_net_from_mesh_create. It keeps nothing of the mesh; spans
/// live as long as this.
class NetGrid {
public:
    /// The grid of a mesh, or of one of its components.
    explicit NetGrid(const MeshView &mesh, const NetGridOptions &options = {}, const Context &context = Context())
        : net_([&] {
              const gusset_net_grid_options given = detail::as_c(options);
              gusset_net_grid *grid = nullptr;
              gusset_net *const net = context.result(gusset_net_from_mesh_create, &mesh.get(), &given, &grid);
              grid_.reset(grid);
              return net;
          }()) {}

    /// A copy of the net.
    Net net() const { return net_; }
    /// For each node its vertex.
    Indices vertex_of_node() const & { return detail::indices(view().vertex_of_node); }
    Indices vertex_of_node() const && = delete;
    /// For each cell its face.
    Indices face_of_cell() const & { return detail::indices(view().face_of_cell); }
    Indices face_of_cell() const && = delete;

private:
    gusset_net_grid_view view() const { return detail::lent(gusset_net_grid_get_view, grid_.get()); }
    detail::Handle<gusset_net_grid, gusset_net_grid_destroy> grid_;
    Net net_;
};

} // namespace gusset

#endif // GUSSET_NET_MESH_HPP
