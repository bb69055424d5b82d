// Frames of outlines: curves across and along a body. Include gusset.hpp, not this.
#ifndef GUSSET_FRAME_HPP
#define GUSSET_FRAME_HPP

#include <gusset/outline.hpp>

namespace gusset {

/// The correspondence of points of the sections; see gusset_frame_options.
class Correspondence {
public:
    /// By index: all sections have equally many points.
    static Correspondence given() { return {}; }
    /// Equal parts of the arc length of each section; closed ones start where they are turned least
    /// against each other, or, with `given_starts`, at their first points.
    static Correspondence arc_length(uint32_t columns, bool given_starts = false) {
        Correspondence made;
        made.options_.correspondence = GUSSET_CORRESPONDENCE_ARC_LENGTH;
        made.options_.columns = columns;
        made.options_.given_starts = given_starts ? 1 : 0;
        return made;
    }
    /// Equal angles round an axis.
    static Correspondence angle(uint32_t columns, const Point3 &point, const Point3 &direction,
                                const Point3 &reference) {
        Correspondence made;
        made.options_.correspondence = GUSSET_CORRESPONDENCE_ANGLE;
        made.options_.columns = columns;
        for (std::size_t k = 0; k < 3; ++k) {
            made.options_.axis_point[k] = point[k];
            made.options_.axis_direction[k] = direction[k];
            made.options_.reference[k] = reference[k];
        }
        return made;
    }
    /// Equal angles round a bent axis, of which each section has a point: x, y, z. The points must live
    /// until the Frame is made.
    static Correspondence angle(uint32_t columns, Points axis, const Point3 &reference) {
        Correspondence made;
        made.options_.correspondence = GUSSET_CORRESPONDENCE_ANGLE;
        made.options_.columns = columns;
        // Not NULL, which is a straight axis.
        made.options_.axis_points = axis.empty() ? made.options_.axis_point : axis[0].data();
        made.options_.axis_point_count = axis.size();
        for (std::size_t k = 0; k < 3; ++k) {
            made.options_.reference[k] = reference[k];
        }
        return made;
    }
    /// Points that are gone with the expression cannot be borrowed.
    static Correspondence angle(uint32_t columns, std::vector<Point3> &&axis, const Point3 &reference) = delete;
    /// Landmarks of each section, and equal parts of the arc length between them. The landmarks
    /// must live until the Frame is made.
    static Correspondence landmarks(Indices landmarks, uint32_t parts) {
        Correspondence made;
        made.options_.correspondence = GUSSET_CORRESPONDENCE_LANDMARKS;
        made.options_.columns = parts;
        made.options_.landmarks = {landmarks.data(), landmarks.size()};
        return made;
    }
    /// The same, with corners that only the points' polygon has drawn smooth.
    Correspondence smooth() const {
        Correspondence made = *this;
        made.options_.smooth_corners = 1;
        return made;
    }
    /// The same of sections that lack these points, counted over all of them, which must outlive the
    /// call that reads this; of given points only.
    Correspondence missing(Span<const uint32_t> points) const {
        Correspondence made = *this;
        made.options_.missing = {points.data(), points.size()};
        return made;
    }
    /// As the C interface takes it, without the options of the curves.
    const gusset_frame_options &get() const noexcept { return options_; }

private:
    Correspondence() = default;
    gusset_frame_options options_ = detail::sized<gusset_frame_options>();
};

/// Nodes, and curves across and along a body through them; see gusset_frame_create.
class Frame {
public:
    explicit Frame(const Outlines &sections, const Correspondence &correspondence = Correspondence::given(),
                   const OutlineOptions &across = {}, const OutlineOptions &along = {}, bool ring = false,
                   const Context &context = Context()) {
        const gusset_outline_options curves[] = {across.get(), along.get()};
        gusset_frame_options given = correspondence.get();
        given.across = &curves[0];
        given.along = &curves[1];
        given.ring = ring ? 1 : 0;
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
    const gusset_frame *get() const noexcept { return frame_.get(); }

private:
    explicit Frame(gusset_frame *owned) : frame_(owned) {}
    detail::Handle<gusset_frame, gusset_frame_destroy> frame_;
};

} // namespace gusset

#endif // GUSSET_FRAME_HPP
