// Trimming of pieces that overlap. Include gusset.hpp, not this.
#ifndef GUSSET_TRIM_HPP
#define GUSSET_TRIM_HPP

#include <gusset/mesh.hpp>

namespace gusset {

/// The options of trimming; see gusset_trim_options.
struct TrimOptions {
    /// 0: four mean edges of the coarser of two pieces.
    double max_distance = 0.0;
    /// In radians; 0: 60 degrees.
    double max_angle = 0.0;
    /// The place that each piece was seen from. Empty: nothing is known of that.
    std::vector<Point3> viewpoints;
    /// 0: 30.
    uint32_t min_faces = 0;
};

namespace detail {
/// As long as the options live.
inline gusset_trim_options as_c(const TrimOptions &options) {
    auto given = detail::sized<gusset_trim_options>();
    given.max_distance = options.max_distance;
    given.max_angle = options.max_angle;
    given.viewpoints = options.viewpoints.empty() ? nullptr : options.viewpoints.front().data();
    given.viewpoint_count = options.viewpoints.size();
    given.min_faces = options.min_faces;
    return given;
}
} // namespace detail

/// What is left of pieces that overlap; see gusset_trim_create.
class Trim {
public:
    explicit Trim(Span<const MeshView> pieces, const TrimOptions &options = {}, const Context &context = Context()) {
        std::vector<gusset_mesh_view> views;
        for (const MeshView &piece : pieces) {
            views.push_back(piece.get());
        }
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
