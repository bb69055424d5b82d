// Facing arcs of loops. Include gusset.hpp, not this.
#ifndef GUSSET_FACING_HPP
#define GUSSET_FACING_HPP

#include <gusset/context.hpp>

namespace gusset {

/// An arc of a loop: its first place and its number of vertices.
struct LoopArc {
    /// The first place on the loop.
    uint32_t first = 0;
    /// The number of vertices.
    uint32_t count = 0;
};

/// The vertices of two loops that face each other; see gusset_facing_create.
class Facing {
public:
    Facing(Points a, Points b, FacingRun run = FacingRun::closest, std::optional<double> tolerance = {},
           const Context &context = Context(), Centres centres = Centres::vertices) {
        auto given = detail::sized<gusset_facing_options>();
        given.centres = static_cast<uint32_t>(centres);
        given.run = static_cast<uint32_t>(run);
        given.tolerance_mode = tolerance ? GUSSET_TOLERANCE_GIVEN : GUSSET_TOLERANCE_AUTO;
        given.tolerance = tolerance.value_or(0.0);
        facing_.reset(context.result(gusset_facing_create, detail::numbers(a.data()), a.size(),
                                     detail::numbers(b.data()), b.size(), &given));
    }
    /// Centres, normals, distances, runs, and the runs taken; valid as long as this lives.
    gusset_facing_view view() const & { return detail::lent(gusset_facing_get_view, facing_.get()); }
    gusset_facing_view view() const && = delete;
    /// The run taken on loop 0 or 1.
    LoopArc arc(int loop) const & {
        const gusset_facing_view found = view();
        return {found.taken[loop != 0][0], found.taken[loop != 0][1]};
    }
    LoopArc arc(int loop) const && = delete;

private:
    detail::Handle<gusset_facing, gusset_facing_destroy> facing_;
};

} // namespace gusset

#endif // GUSSET_FACING_HPP
