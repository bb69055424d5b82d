// The frame of outlines: curves across and along a body. Included by gusset.hpp.
#ifndef GUSSET_FRAME_HPP
#define GUSSET_FRAME_HPP

#include <gusset/outline.hpp>

namespace gusset {

/// Which points of the sections belong together; see gusset_frame_options.
class Correspondence {
public:
    /// By their places: all sections have equally many.
    static Correspondence given() { return {}; }
    /// Equal parts of the arc length of each section.
    static Correspondence arc_length(uint32_t columns) {
        Correspondence made;
        made.options_.correspondence = GUSSET_CORRESPONDENCE_ARC_LENGTH;
        made.options_.columns = columns;
        return made;
    }
    /// Equal angles round an axis.
    static Correspondence angle(uint32_t columns, const std::array<double, 3> &point,
                                const std::array<double, 3> &direction, const std::array<double, 3> &reference) {
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
    /// Landmarks of each section, and equal parts of the arc length between them. The landmarks must outlive the call.
    static Correspondence landmarks(Indices landmarks, uint32_t parts) {
        Correspondence made;
        made.options_.correspondence = GUSSET_CORRESPONDENCE_LANDMARKS;
        made.options_.columns = parts;
        made.options_.landmarks = {landmarks.data(), landmarks.size()};
        return made;
    }
    /// What C takes, but for the curves.
    const gusset_frame_options &get() const noexcept { return options_; }

private:
    Correspondence() { options_.struct_size = sizeof options_; }
    gusset_frame_options options_{};
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
        gusset_frame *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_frame_create(c, &sections.get(), &given, &created); });
        frame_.reset(created);
    }
    /// The nodes and what belongs to them, valid as long as this lives.
    gusset_frame_view parts() const {
        gusset_frame_view parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_frame_get_view(frame_.get(), &parts));
        return parts;
    }
    /// Row by row.
    Points nodes() const {
        const gusset_frame_view all = parts();
        return {reinterpret_cast<const std::array<double, 3> *>(all.nodes), all.rows * all.columns};
    }
    /// The curve through row k.
    OutlineCurve across(std::size_t k) const {
        const gusset_outline *lent = nullptr;
        detail::check(gusset_frame_curves_create(frame_.get(), &lent, nullptr));
        return Outline::curve_of(detail::parts(lent), k);
    }
    /// The curve through column i.
    OutlineCurve along(std::size_t i) const {
        const gusset_outline *lent = nullptr;
        detail::check(gusset_frame_curves_create(frame_.get(), nullptr, &lent));
        return Outline::curve_of(detail::parts(lent), i);
    }
    /// A new section: where the plane through a point across a normal cuts the curves along.
    Outline slice(const std::array<double, 3> &point, const std::array<double, 3> &normal,
                  const Context &context = Context()) const {
        gusset_outline *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_frame_slice_create(c, frame_.get(), point.data(), normal.data(), &created);
        });
        return Outline(created);
    }
    const gusset_frame *get() const noexcept { return frame_.get(); }

private:
    struct Destroy {
        void operator()(gusset_frame *frame) const noexcept { gusset_frame_destroy(frame); }
    };
    std::unique_ptr<gusset_frame, Destroy> frame_;
};

} // namespace gusset

#endif
