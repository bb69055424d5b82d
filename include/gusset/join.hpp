/// @file
/// Joining of many pieces. Include gusset.hpp, not this.
#ifndef GUSSET_JOIN_HPP
#define GUSSET_JOIN_HPP

#include <gusset/result.hpp>

namespace gusset {

/// Many pieces joined to one mesh, and the report on it; see gusset_join.
class Join : public Result {
public:
    /// See ::gusset_join.
    explicit Join(Span<const MeshView> pieces, const JoinOptions &options = {},
                  const Context &context = Context()) {
        const std::vector<gusset_mesh_view> views = detail::c_views(pieces);
        detail::JoinOptionsNested nested;
        const gusset_join_options given = detail::as_c(options, nested);
        take(context.result(gusset_join, views.data(), views.size(), &given));
    }

    /// The whole report; its lists live as long as this.
    gusset_join_report report() const & { return detail::lent(gusset_result_get_join, get()); }
    gusset_join_report report() const && = delete;
    /// The vertices and faces of each piece in the result.
    Span<const gusset_piece_map> pieces() const & { return {report().pieces, report().piece_count}; }
    Span<const gusset_piece_map> pieces() const && = delete;
    /// The pairs of loops that face each other, with the status of each.
    Span<const gusset_joint> joints() const & { return {report().joints, report().joint_count}; }
    Span<const gusset_joint> joints() const && = delete;
    /// The loops without a strip.
    Span<const gusset_left_loop> left() const & { return {report().left, report().left_count}; }
    Span<const gusset_left_loop> left() const && = delete;
    /// The holes that were considered after joining.
    Span<const gusset_hole> holes() const & { return {report().holes, report().hole_count}; }
    Span<const gusset_hole> holes() const && = delete;
};

} // namespace gusset

#endif // GUSSET_JOIN_HPP
