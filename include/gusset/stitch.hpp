/// @file
/// Stitching of meshes. Include gusset.hpp, not this.
#ifndef GUSSET_STITCH_HPP
#define GUSSET_STITCH_HPP

#include <gusset/result.hpp>

namespace gusset {

/// A finished stitch: the whole mesh, the strip, and the maps of the inputs into it. Made by
/// stitch() and stitch_within().
class Stitch : public Result {
public:
    /// See ::gusset_result_get_strip_mesh.
    MeshView strip() const & { return MeshView(detail::lent(gusset_result_get_strip_mesh, get())); }
    MeshView strip() const && = delete;

    /// See ::gusset_result_get_quality.
    gusset_quality_report quality() const { return detail::lent(gusset_result_get_quality, get()); }

    /// For each old vertex of mesh 0 or 1 its index in the result.
    Indices vertex_map(int mesh) const & { return detail::indices(report().vertex_map[mesh != 0]); }
    Indices vertex_map(int mesh) const && = delete;
    /// For each old face of mesh 0 or 1 its index in the result.
    Indices face_map(int mesh) const & { return detail::indices(report().face_map[mesh != 0]); }
    Indices face_map(int mesh) const && = delete;
    /// The vertices of a rim in the result, from the first meridian on.
    Indices rim(int mesh) const & { return detail::indices(report().rim[mesh != 0]); }
    Indices rim(int mesh) const && = delete;
    /// Pairs of places on the rims, i and j interleaved.
    Indices meridians() const & { return detail::indices(report().meridians); }
    Indices meridians() const && = delete;
    /// The strip's faces in the result: the first, and their number.
    std::pair<std::size_t, std::size_t> strip_faces() const {
        const gusset_stitch_report found = report();
        return {found.strip_face_first, found.strip_face_count};
    }
    /// The paper's matrix P, row by row: row_count() + 2 rows with one vertex for each meridian.
    Indices matrix() const & { return detail::indices(report().matrix); }
    Indices matrix() const && = delete;
    /// The number of interior rows.
    uint32_t row_count() const { return report().row_count; }
    /// For each new vertex its three parents, interleaved.
    Indices parents() const & { return detail::indices(report().parents); }
    Indices parents() const && = delete;
    /// How much each new vertex has of its parents, three numbers a vertex.
    Span<const double> weights() const & { return {report().weights, report().parents.count}; }
    Span<const double> weights() const && = delete;
    /// The strip is a closed band between whole loops.
    bool is_closed_band() const { return report().closed != 0; }
    /// Pairs of faces of mesh() that intersect each other, interleaved; empty if they were not
    /// sought.
    std::optional<Indices> intersections() const & {
        return detail::intersections(report());
    }
    std::optional<Indices> intersections() const && = delete;
    /// The kind of the strip: a strip may have replaced the requested blend.
    Finish finish() const { return static_cast<Finish>(report().finish); }
    /// The number of local back-offs of the fairing.
    uint32_t back_off_count() const { return report().back_off_count; }
    /// The second piece was turned over to agree with the first.
    bool turned() const { return report().turned != 0; }
    /// The faces that Outward::closed turned over.
    Indices turned_outwards() const & { return detail::indices(report().turned_outwards); }
    Indices turned_outwards() const && = delete;

    /// The call of the C interface; stitch() and stitch_within() are its cases.
    Stitch(const MeshView &a, const Indices *loop_a, const MeshView *b, const Indices *loop_b,
           const StitchOptions &options, const Context &context) {
        const gusset_stitch_options given = detail::as_c(options);
        const auto list = [](const Indices *loop) {
            return loop != nullptr ? gusset_indices{loop->data(), loop->size()} : gusset_indices{nullptr, 0};
        };
        const gusset_indices first = list(loop_a), second = list(loop_b);
        take(context.result(gusset_stitch, &a.get(), loop_a != nullptr ? &first : nullptr,
                                     b != nullptr ? &b->get() : nullptr, loop_b != nullptr ? &second : nullptr,
                                     &given));
    }

private:
    gusset_stitch_report report() const { return detail::lent(gusset_result_get_stitch, get()); }
};

/// Joins the two loops of a and b that lie nearest to each other.
inline Stitch stitch(const MeshView &a, const MeshView &b, const StitchOptions &options = {},
                     const Context &context = Context()) {
    return Stitch(a, nullptr, &b, nullptr, options, context);
}
/// Joins loop_a of a to loop_b of b; loops are vertices in order, in either direction.
inline Stitch stitch(const MeshView &a, Indices loop_a, const MeshView &b, Indices loop_b,
                     const StitchOptions &options = {}, const Context &context = Context()) {
    return Stitch(a, &loop_a, &b, &loop_b, options, context);
}
/// Joins the two loops of one mesh that lie nearest to each other.
inline Stitch stitch_within(const MeshView &mesh, const StitchOptions &options = {},
                            const Context &context = Context()) {
    return Stitch(mesh, nullptr, nullptr, nullptr, options, context);
}
/// Joins two loops of one mesh.
inline Stitch stitch_within(const MeshView &mesh, Indices loop_a, Indices loop_b, const StitchOptions &options = {},
                            const Context &context = Context()) {
    return Stitch(mesh, &loop_a, nullptr, &loop_b, options, context);
}

} // namespace gusset

#endif // GUSSET_STITCH_HPP
