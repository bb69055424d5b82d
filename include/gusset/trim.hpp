/// @file
/// Trimming of pieces that overlap. Include gusset.hpp, not this.
#ifndef GUSSET_TRIM_HPP
#define GUSSET_TRIM_HPP

#include <gusset/mesh.hpp>

namespace gusset {

/// Pieces without their overlaps; see gusset_trim_create.
class Trim {
public:
    /// See ::gusset_trim_create.
    explicit Trim(Span<const MeshView> pieces, const TrimOptions &options = {}, const Context &context = Context()) {
        const std::vector<gusset_mesh_view> views = detail::c_views(pieces);
        const gusset_trim_options given = detail::as_c(options);
        trim_.reset(context.result(gusset_trim_create, views.data(), views.size(), &given));
    }

    /// The pieces in their order: the faces of each that are kept.
    Span<const gusset_trimmed_piece> pieces() const & { return {view().pieces, view().piece_count}; }
    Span<const gusset_trimmed_piece> pieces() const && = delete;
    /// The faces of a piece < pieces().size() that are kept, ascending.
    Indices kept(std::size_t piece) const & { return detail::indices(view().pieces[piece].kept); }
    Indices kept(std::size_t piece) const && = delete;
    /// The number of faces that cut others of another piece after all else, and went.
    uint32_t crossings() const { return view().crossings; }

private:
    gusset_trim_view view() const { return detail::lent(gusset_trim_get_view, trim_.get()); }
    detail::Handle<gusset_trim, gusset_trim_destroy> trim_;
};

} // namespace gusset

#endif // GUSSET_TRIM_HPP
