/// @file
/// Free boundary loops of meshes. Include gusset.hpp, not this.
#ifndef GUSSET_BOUNDARY_HPP
#define GUSSET_BOUNDARY_HPP

#include <gusset/mesh.hpp>

namespace gusset {

/// One boundary loop or open chain; see gusset_loop_view.
struct Loop {
    /// See ::gusset_loop_view::vertices.
    Indices vertices;
    /// See ::gusset_loop_view::half_edges.
    Indices half_edges;
    /// See ::gusset_loop_view::faces.
    Indices faces;
    /// See ::gusset_loop_view::edge_flags.
    Span<const uint8_t> edge_flags;
    /// See ::gusset_loop_view::length.
    double length;
    /// See ::gusset_loop_view::flags.
    uint32_t flags;
    /// See ::gusset_loop_view::walk.
    uint32_t walk;
    /// False for an open chain.
    bool is_closed() const noexcept { return (flags & GUSSET_LOOP_OPEN) == 0; }
};

/// All free boundary loops of a mesh, surface on the left; a range of Loop. See
/// gusset_boundary_create.
class Boundary {
public:
    /// The type of the elements.
    using value_type = Loop;
    /// The type of iterators.
    using iterator = detail::Iterator<Boundary>;

    /// See ::gusset_boundary_create.
    explicit Boundary(const MeshView &mesh, const BoundaryOptions &options = {}, const Context &context = Context()) {
        const gusset_boundary_options given = detail::as_c(options);
        boundary_.reset(context.result(gusset_boundary_create, &mesh.get(), &given));
    }

    /// The number of elements.
    std::size_t size() const noexcept { return view().loop_count; }
    /// True if the range is empty.
    bool empty() const noexcept { return size() == 0; }
    /// The number of walks that the loops were cut from; see gusset_boundary_view.
    std::size_t walk_count() const noexcept { return view().walk_count; }

    /// Loop `i`; throws Error (GUSSET_ERROR_NO_SUCH_ELEMENT) from size() on.
    Loop operator[](std::size_t i) const {
        const gusset_loop_view view = detail::lent(gusset_boundary_get_loop, boundary_.get(), i);
        using detail::indices;
        return {indices(view.vertices), indices(view.half_edges), indices(view.faces),
                {view.edge_flags, view.half_edges.count}, view.length, view.flags, view.walk};
    }

    /// The defects of the mesh; see gusset_boundary_view.
    Span<const gusset_defect> defects() const & {
        const gusset_boundary_view found = view();
        return {found.defects, found.defect_count};
    }
    Span<const gusset_defect> defects() const && = delete;

    /// The first element.
    iterator begin() const noexcept { return {this, 0}; }
    /// The end of the range.
    iterator end() const noexcept { return {this, size()}; }

private:
    /// All zero if this was moved from.
    gusset_boundary_view view() const noexcept {
        auto found = detail::sized<gusset_boundary_view>();
        (void)!gusset_boundary_get_view(boundary_.get(), &found);
        return found;
    }
    detail::Handle<gusset_boundary, gusset_boundary_destroy> boundary_;
};

} // namespace gusset

#endif // GUSSET_BOUNDARY_HPP
