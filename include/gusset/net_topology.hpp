/// @file
/// The topology of nets. Include gusset.hpp, not this.
#ifndef GUSSET_NET_TOPOLOGY_HPP
#define GUSSET_NET_TOPOLOGY_HPP

#include <gusset/net.hpp>

namespace gusset {

/// The cell complex of a net with its glued nodes identified, and its topology. It keeps nothing of
/// the net. See gusset_net_complex_view, whose lists live as long as this.
class NetComplex {
public:
    /// See ::gusset_net_complex_create.
    explicit NetComplex(const Net &net, NetCells cells = NetCells::all, const Context &context = Context()) {
        complex_.reset(context.result(gusset_net_complex_create, net.get(), static_cast<gusset_net_cells>(cells)));
    }
    /// See ::gusset_net_complex_get_view.
    gusset_net_complex_view view() const & { return detail::lent(gusset_net_complex_get_view, complex_.get()); }
    gusset_net_complex_view view() const && = delete;
    /// No boundary edges.
    bool is_closed() const { return has(GUSSET_NET_CLOSED); }
    /// A surface everywhere.
    bool is_manifold() const { return has(GUSSET_NET_MANIFOLD); }
    /// Faces that share an edge run it in opposite directions.
    bool is_oriented() const { return has(GUSSET_NET_ORIENTED); }
    /// Faces can be oriented consistently.
    bool is_orientable() const { return has(GUSSET_NET_ORIENTABLE); }
    /// Vertices - edges + faces.
    int64_t euler() const { return view().euler; }
    /// The number of handles if orientable, otherwise of crosscaps; empty if the net is not a surface.
    std::optional<int64_t> genus() const {
        const int64_t genus = view().genus;
        return genus < 0 ? std::nullopt : std::optional<int64_t>(genus);
    }
    /// The number of chains of boundary edges.
    std::size_t boundary_count() const { return view().boundary_offsets.count - 1; }
    /// The vertices of chain `i` of boundary edges, each by its smallest node; throws
    /// an Error if it does not exist.
    Indices boundary(std::size_t i) const & {
        const gusset_net_complex_view found = view();
        detail::require_element(i, boundary_count(), "boundary");
        const uint32_t *ends = found.boundary_offsets.data + i;
        return {found.boundary_nodes.data + ends[0], ends[1] - ends[0]};
    }
    Indices boundary(std::size_t i) const && = delete;
    /// Edges of no face: two vertices each, as for the other edges.
    Indices wires() const & { return detail::indices(view().wires); }
    Indices wires() const && = delete;
    /// Edges of three faces and more.
    Indices branches() const & { return detail::indices(view().branches); }
    Indices branches() const && = delete;
    /// Vertices whose faces are several fans.
    Indices pinches() const & { return detail::indices(view().pinches); }
    Indices pinches() const && = delete;
    /// Edges that two faces run along the same way.
    Indices conflicts() const & { return detail::indices(view().conflicts); }
    Indices conflicts() const && = delete;

private:
    bool has(uint32_t property) const { return (view().properties & property) != 0; }
    detail::Handle<gusset_net_complex, gusset_net_complex_destroy> complex_;
};

/// The points of a net that are several nodes. It keeps nothing of the net; spans live as long as
/// this.
class NetGroups {
public:
    /// See ::gusset_net_groups_create.
    explicit NetGroups(const Net &net, const Context &context = Context()) {
        groups_.reset(context.result(gusset_net_groups_create, net.get()));
    }
    /// The number of elements.
    std::size_t size() const { return offsets().size() - 1; }
    /// True if the range is empty.
    bool empty() const { return size() == 0; }
    /// The nodes of group `i`, in order; throws an Error if it does not exist.
    Indices operator[](std::size_t i) const {
        const gusset_net_groups_view found = view();
        detail::require_element(i, size(), "group");
        const uint32_t *ends = found.offsets.data + i;
        return {found.members.data + ends[0], ends[1] - ends[0]};
    }
    /// Group i has the nodes from members()[offsets()[i]] to members()[offsets()[i + 1] - 1].
    Indices offsets() const & { return detail::indices(view().offsets); }
    Indices offsets() const && = delete;
    /// The nodes of all groups, one group after the other.
    Indices members() const & { return detail::indices(view().members); }
    Indices members() const && = delete;

private:
    gusset_net_groups_view view() const { return detail::lent(gusset_net_groups_get_view, groups_.get()); }
    detail::Handle<gusset_net_groups, gusset_net_groups_destroy> groups_;
};

} // namespace gusset

#endif // GUSSET_NET_TOPOLOGY_HPP
