/// @file
/// Frames of outlines: curves across and along a body. Include gusset.hpp, not this.
#ifndef GUSSET_FRAME_HPP
#define GUSSET_FRAME_HPP

#include <gusset/outline.hpp>

namespace gusset {

/// Nodes, and curves across and along a body through them; see gusset_frame_create.
class Frame {
public:
    /// The frame of sections.
    explicit Frame(const Outlines &sections, const FrameOptions &options = {}, const Context &context = Context()) {
        detail::FrameOptionsNested nested;
        const gusset_frame_options given = detail::as_c(options, nested);
        frame_.reset(context.result(gusset_frame_create, &sections.get(), &given));
    }
    /// The nodes and their arrays, valid as long as this lives.
    gusset_frame_view view() const { return detail::lent(gusset_frame_get_view, frame_.get()); }
    /// The nodes, row by row.
    Points nodes() const & {
        const gusset_frame_view all = view();
        return detail::points(all.nodes, all.rows * all.columns);
    }
    Points nodes() const && = delete;
    /// The curve through row k.
    OutlineCurve across(std::size_t k) const & {
        return Outline::curve_of(detail::lent(gusset_outline_get_view, view().curves_across), k);
    }
    OutlineCurve across(std::size_t k) const && = delete;
    /// The curve through column i.
    OutlineCurve along(std::size_t i) const & {
        return Outline::curve_of(detail::lent(gusset_outline_get_view, view().curves_along), i);
    }
    OutlineCurve along(std::size_t i) const && = delete;
    /// A new section: the intersection of the curves along with the plane through a point.
    Outline slice(const Point3 &point, const Point3 &normal, const Context &context = Context()) const {
        return Outline(context.result(gusset_frame_slice_create, frame_.get(), point.data(), normal.data()));
    }
    /// The frame beside this one: nodes moved outwards by distances, one for all, one for each section,
    /// or one for each node; see gusset_frame_offset_create.
    Frame offset(Span<const double> distances, OffsetDirection direction = OffsetDirection::normal,
                 const Context &context = Context()) const {
        return Frame(context.result(gusset_frame_offset_create, frame_.get(), distances.data(), distances.size(),
                                    static_cast<uint32_t>(direction)));
    }
    /// The same by one distance for all nodes.
    Frame offset(double distance, OffsetDirection direction = OffsetDirection::normal,
                 const Context &context = Context()) const {
        return offset({&distance, 1}, direction, context);
    }
    /// The argument for the C interface, which this still owns.
    const gusset_frame *get() const noexcept { return frame_.get(); }

private:
    explicit Frame(gusset_frame *owned) : frame_(owned) {}
    detail::Handle<gusset_frame, gusset_frame_destroy> frame_;
};

} // namespace gusset

#endif // GUSSET_FRAME_HPP
