// Joining of many pieces. Include gusset.hpp, not this.
#ifndef GUSSET_JOIN_HPP
#define GUSSET_JOIN_HPP

#include <gusset/fill.hpp>
#include <gusset/repair.hpp>
#include <gusset/stitch.hpp>
#include <gusset/trim.hpp>

namespace gusset {

/// The options of joining; see gusset_join_options.
struct JoinOptions {
    /// Empty: no welding.
    std::optional<WeldOptions> weld = WeldOptions();
    /// Borders are sewn only where they match vertex by vertex: no edge is split.
    bool edge_to_edge = false;
    /// No piece is turned over.
    bool keep_orientation = false;
    /// Closed components of the result face outwards; Outward::keep: they stay as they are. Not so with
    /// keep_orientation, which leaves all as it is.
    Outward outward = Outward::closed;
    /// Empty: by the size of the loops. 0 leaves all gaps open.
    std::optional<double> max_gap;
    bool whole_loops_only = false;
    bool within_components = false;
    std::vector<gusset_loop_pair> pairs;
    std::vector<gusset_loop_pair> excluded;
    /// Only meridians, search, start, rows, cells, fairing, finish and intersections are read.
    StitchOptions strips;
    /// Empty: holes are left.
    std::optional<FillOptions> fill;
    /// Empty: pieces that overlap stay as they are.
    std::optional<TrimOptions> trim;
};

/// Many pieces joined to one mesh, and the report on it; see gusset_join.
class Join : public Result {
public:
    explicit Join(Span<const MeshView> pieces, const JoinOptions &options = {},
                  const Context &context = Context()) {
        std::vector<gusset_mesh_view> views;
        for (const MeshView &piece : pieces) {
            views.push_back(piece.get());
        }
        const gusset_weld_options weld = detail::as_c(options.weld.value_or(WeldOptions()));
        const gusset_stitch_options strips = detail::as_c(options.strips);
        const gusset_fill_options fill = detail::as_c(options.fill.value_or(FillOptions()));
        const TrimOptions untouched;
        // No copy, as it points to the viewpoints.
        const gusset_trim_options trim = detail::as_c(options.trim ? *options.trim : untouched);
        auto given = detail::sized<gusset_join_options>();
        given.weld = !options.weld          ? GUSSET_WELDING_NONE
                     : options.edge_to_edge ? GUSSET_WELDING_EDGE_TO_EDGE
                                            : GUSSET_WELDING_SEW;
        given.orientation = options.keep_orientation ? GUSSET_ORIENTATION_KEEP : GUSSET_ORIENTATION_FIX;
        given.outward = static_cast<gusset_outward>(options.outward);
        given.gap = options.max_gap ? GUSSET_GAP_GIVEN : GUSSET_GAP_AUTO;
        given.max_gap = options.max_gap.value_or(0.0);
        given.whole_loops_only = options.whole_loops_only ? 1 : 0;
        given.within_components = options.within_components ? 1 : 0;
        given.fill = options.fill ? 1 : 0;
        given.pairs = options.pairs.data();
        given.pair_count = options.pairs.size();
        given.excluded = options.excluded.data();
        given.excluded_count = options.excluded.size();
        given.weld_options = &weld;
        given.strip_options = &strips;
        given.fill_options = &fill;
        given.overlaps = options.trim ? GUSSET_OVERLAPS_TRIM : GUSSET_OVERLAPS_KEEP;
        given.trim_options = &trim;
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
