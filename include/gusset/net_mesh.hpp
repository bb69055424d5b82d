// From nets to meshes and back. Include gusset.hpp, not this.
#ifndef GUSSET_NET_MESH_HPP
#define GUSSET_NET_MESH_HPP

#include <gusset/net.hpp>

namespace gusset {

/// What the faces of the mesh of a net are.
enum class NetFaces : uint32_t {
    quads = GUSSET_NET_QUADS,
    triangles_shorter = GUSSET_NET_TRIANGLES_SHORTER,
    triangles_fixed = GUSSET_NET_TRIANGLES_FIXED
};

/// How a net becomes a mesh; see gusset_net_mesh_options.
struct NetMeshOptions {
    NetFaces faces = NetFaces::quads;
    /// Glued nodes become one vertex.
    bool weld = true;
    bool keep_unused = false;
    /// A cell of which just one corner is missing becomes a triangle.
    bool fill_corners = false;
    bool texture = false;
};

/// The mesh of a net; see gusset_net_mesh_create. It keeps nothing of the net; views and spans live as long as this.
class NetMesh {
public:
    /// The index of what is not in the mesh.
    static constexpr uint32_t none = UINT32_MAX;

    explicit NetMesh(const Net &net, const NetMeshOptions &options = {}, const Context &context = Context()) {
        gusset_net_mesh_options given{};
        given.struct_size = sizeof given;
        given.faces = static_cast<gusset_net_faces>(options.faces);
        given.no_weld = options.weld ? 0 : 1;
        given.keep_unused = options.keep_unused ? 1 : 0;
        given.fill_corners = options.fill_corners ? 1 : 0;
        given.texture = options.texture ? 1 : 0;
        gusset_net_mesh *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_net_mesh_create(c, net.get(), &given, &created); });
        mesh_.reset(created);
    }

    MeshView mesh() const {
        gusset_mesh_view view{};
        view.struct_size = sizeof view;
        detail::check(gusset_net_mesh_get_mesh(mesh_.get(), &view));
        return MeshView(view);
    }
    /// Node to vertex, or none.
    Indices vertex_of_node() const { return detail::indices(maps().vertex_of_node); }
    /// Vertex to the first of its nodes.
    Indices node_of_vertex() const { return detail::indices(maps().node_of_vertex); }
    /// Face to cell: cell (i, j) is i * (columns - 1) + j.
    Indices cell_of_face() const { return detail::indices(maps().cell_of_face); }
    /// Edges without faces, two vertices each.
    Indices wires() const { return detail::indices(maps().wires); }
    /// For each corner of the mesh its texture coordinates; empty unless they were asked for.
    Indices texture_corners() const { return detail::indices(maps().texture_corners); }
    /// u and v from 0 to 1: column and row.
    Span<const std::array<double, 2>> texture_coordinates() const {
        static_assert(sizeof(std::array<double, 2>) == 2 * sizeof(double), "packed");
        const gusset_net_mesh_view found = maps();
        return {reinterpret_cast<const std::array<double, 2> *>(found.texture_coordinates), found.texture_count};
    }

private:
    struct Destroy {
        void operator()(gusset_net_mesh *mesh) const noexcept { gusset_net_mesh_destroy(mesh); }
    };
    gusset_net_mesh_view maps() const {
        gusset_net_mesh_view maps{};
        maps.struct_size = sizeof maps;
        detail::check(gusset_net_mesh_get_view(mesh_.get(), &maps));
        return maps;
    }
    std::unique_ptr<gusset_net_mesh, Destroy> mesh_;
};

/// A net that was found in a mesh; see gusset_net_grid_create. It keeps nothing of the mesh; spans live as long as this.
class Grid {
public:
    /// `face`: one of the component that is meant; nothing: the mesh must be one grid.
    explicit Grid(const MeshView &mesh, std::optional<uint32_t> face = std::nullopt, const Context &context = Context()) {
        gusset_net_grid *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_net_grid_create(c, &mesh.get(), face.value_or(UINT32_MAX), &created);
        });
        grid_.reset(created);
    }

    /// The net itself, which outlives this.
    Net net(const Context &context = Context()) const {
        gusset_net *found = nullptr;
        context.call([&](gusset_context *c) { return gusset_net_grid_net_create(c, grid_.get(), &found); });
        return Net(found);
    }
    /// Of each node its vertex.
    Indices vertex_of_node() const { return detail::indices(parts().vertex_of_node); }
    /// Of each cell its face.
    Indices face_of_cell() const { return detail::indices(parts().face_of_cell); }

private:
    struct Destroy {
        void operator()(gusset_net_grid *grid) const noexcept { gusset_net_grid_destroy(grid); }
    };
    gusset_net_grid_view parts() const {
        gusset_net_grid_view parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_net_grid_get_view(grid_.get(), &parts));
        return parts;
    }
    std::unique_ptr<gusset_net_grid, Destroy> grid_;
};

} // namespace gusset

#endif // GUSSET_NET_MESH_HPP
