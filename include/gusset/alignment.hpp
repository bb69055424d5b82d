/// @file
/// Alignment of pieces that overlap. Include gusset.hpp, not this.
#ifndef GUSSET_ALIGNMENT_HPP
#define GUSSET_ALIGNMENT_HPP

#include <gusset/mesh.hpp>
#include <gusset/net_field.hpp>

namespace gusset {

/// Where pieces that overlap belong; see gusset_alignment_create.
class Alignment {
public:
    /// See ::gusset_alignment_create.
    explicit Alignment(Span<const MeshView> pieces, const AlignmentOptions &options = {},
                       const Context &context = Context()) {
        const std::vector<gusset_mesh_view> views = detail::c_views(pieces);
        const gusset_alignment_options given = detail::as_c(options);
        alignment_.reset(context.result(gusset_alignment_create, views.data(), views.size(), &given));
    }

    /// The pieces in their order: the pose that takes each to its place, and why it is trusted or not.
    Span<const gusset_aligned_piece> pieces() const & { return {view().pieces, view().piece_count}; }
    Span<const gusset_aligned_piece> pieces() const && = delete;
    /// The pairs of pieces with anything in common.
    Span<const gusset_overlap> overlaps() const & { return {view().overlaps, view().overlap_count}; }
    Span<const gusset_overlap> overlaps() const && = delete;
    /// Every piece is trusted to lie right.
    bool is_trusted() const {
        const gusset_alignment_view found = view();
        for (std::size_t k = 0; k < found.piece_count; ++k) {
            if (found.pieces[k].reason != GUSSET_ALIGNED_TRUSTED) {
                return false;
            }
        }
        return true;
    }
    /// The number of rounds that were done.
    uint32_t rounds() const { return view().rounds; }
    /// Nothing moved any more in the end.
    bool converged() const { return view().converged != 0; }

private:
    gusset_alignment_view view() const { return detail::lent(gusset_alignment_get_view, alignment_.get()); }
    detail::Handle<gusset_alignment, gusset_alignment_destroy> alignment_;
};

} // namespace gusset

#endif // GUSSET_ALIGNMENT_HPP
