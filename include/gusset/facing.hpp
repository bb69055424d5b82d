/// @file
/// Facing arcs of loops. Include gusset.hpp, not this.
#ifndef GUSSET_FACING_HPP
#define GUSSET_FACING_HPP

#include <gusset/context.hpp>
#include <gusset/mesh_options.hpp>

namespace gusset {

/// The vertices of two loops that face each other; see gusset_facing_create.
class Facing {
public:
    /// The arcs of two loops of points.
    Facing(Points a, Points b, const FacingOptions &options = {}, const Context &context = Context()) {
        const gusset_facing_options given = detail::as_c(options);
        facing_.reset(context.result(gusset_facing_create, detail::numbers(a.data()), a.size(),
                                     detail::numbers(b.data()), b.size(), &given));
    }
    /// Centres, normals, distances, runs, and the runs taken; valid as long as this lives.
    gusset_facing_view view() const & { return detail::lent(gusset_facing_get_view, facing_.get()); }
    gusset_facing_view view() const && = delete;
    /// The run taken on loop 0 or 1: its first place and its number of vertices, as StitchOptions::arc_a takes it.
    std::array<uint32_t, 2> arc(int loop) const {
        const gusset_facing_view found = view();
        return {found.taken[loop != 0][0], found.taken[loop != 0][1]};
    }

private:
    detail::Handle<gusset_facing, gusset_facing_destroy> facing_;
};

} // namespace gusset

#endif // GUSSET_FACING_HPP
