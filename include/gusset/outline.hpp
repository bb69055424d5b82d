/// @file
/// Outlines: Bézier curves through given points. Include gusset.hpp, not this.
#ifndef GUSSET_OUTLINE_HPP
#define GUSSET_OUTLINE_HPP

#include <gusset/curve.hpp>

namespace gusset {

/// A constraint at a point: a corner or a tangent.
struct Constraint : gusset_constraint {
    /// A corner at a point.
    static Constraint corner(uint32_t point) { return {{point, GUSSET_CONSTRAINT_CORNER, {0.0, 0.0, 0.0}}}; }
    /// A tangent at a point by its angle, in radians counter-clockwise from the x-axis.
    static Constraint tangent_angle(uint32_t point, double angle) {
        return {{point, GUSSET_CONSTRAINT_TANGENT_ANGLE, {angle, 0.0, 0.0}}};
    }
    /// A tangent at a point.
    static Constraint tangent(uint32_t point, double x, double y, double z = 0.0) {
        return {{point, GUSSET_CONSTRAINT_TANGENT, {x, y, z}}};
    }
};
static_assert(sizeof(Constraint) == sizeof(gusset_constraint), "a constraint is what C takes");

/// Outlines in the host's memory, which must outlive the calls that read them; see gusset_outlines.
class Outlines {
public:
    /// Plane points.
    Outlines(Span<const std::array<double, 2>> points, bool closed)
        : Outlines(points.data(), points.size(), 2, closed) {}
    /// Points in space.
    Outlines(Points points, bool closed) : Outlines(points.data(), points.size(), 3, closed) {}
    /// Points of 2 or 3 coordinates at the start of every `stride` bytes.
    Outlines(const void *points, std::size_t count, uint32_t dimension, bool closed, std::size_t stride = 0) {
        given_.points = points;
        given_.point_stride = stride;
        given_.point_count = count;
        given_.dimension = dimension;
        given_.closed = closed ? 1 : 0;
    }
    /// Several outlines: the first point of each, then the number of points.
    Outlines &offsets(Span<const uint32_t> offsets) {
        static const uint32_t nothing[1] = {0};
        given_.offsets = offsets.empty() ? nothing : offsets.data();
        given_.outline_count = offsets.empty() ? 0 : offsets.size() - 1;
        return *this;
    }
    /// In ascending order of their points.
    Outlines &constraints(Span<const Constraint> constraints) {
        given_.constraints = constraints.data();
        given_.constraint_count = constraints.size();
        return *this;
    }
    /// The argument for the C interface, which this still owns.
    const gusset_outlines &get() const noexcept { return given_; }

private:
    gusset_outlines given_ = detail::sized<gusset_outlines>();
};

/// The curve of one outline: segment s is the Bézier curve of the control points ends[s] to
/// ends[s + 1].
struct OutlineCurve {
    /// The control points; z is 0 in the plane.
    Points controls;
    /// Segment s has the control points ends[s] to ends[s + 1].
    Indices ends;
    /// The number of segments.
    std::size_t size() const noexcept { return ends.empty() ? 0 : ends.size() - 1; }
    /// The control points of segment s.
    Points segment(std::size_t s) const { return {controls.data() + ends[s], ends[s + 1] - ends[s] + 1}; }
};

/// The curves through the points of outlines; see gusset_outline_create.
class Outline {
public:
    /// Takes ownership of a handle of the C interface.
    explicit Outline(gusset_outline *owned) : outline_(owned) {}
    /// See ::gusset_outline_create.
    explicit Outline(const Outlines &outlines, const OutlineOptions &options = {}, const Context &context = Context()) {
        const gusset_outline_options given = detail::as_c(options);
        outline_.reset(context.result(gusset_outline_create, &outlines.get(), &given));
    }
    /// All arrays, valid as long as this lives.
    gusset_outline_view view() const { return detail::lent(gusset_outline_get_view, outline_.get()); }
    /// The number of outlines.
    std::size_t size() const { return view().outline_count; }
    /// The curve of outline k.
    OutlineCurve curve(std::size_t k = 0) const & { return curve_of(view(), k); }
    OutlineCurve curve(std::size_t k = 0) const && = delete;
    /// The curve of outline k of a view.
    static OutlineCurve curve_of(const gusset_outline_view &all, std::size_t k) {
        if (k >= all.outline_count) {
            detail::check(GUSSET_ERROR_NO_SUCH_ELEMENT);
        }
        const std::size_t *from = all.starts + 2 * k, *to = from + 2;
        return {detail::points(all.controls + 3 * from[0], to[0] - from[0]),
                {all.ends.data + from[1], to[1] - from[1]}};
    }
    /// A copy of the curve of outline k.
    Curve curve_copy(std::size_t k = 0, const Context &context = Context()) const {
        return Curve(context.result(gusset_outline_curve_create, outline_.get(), k));
    }
    /// The length, area and centre of the curve of outline k.
    gusset_curve_measures measure(std::size_t k = 0, const Context &context = Context()) const {
        return curve_copy(k, context).measure(GUSSET_CURVE_MEASURE_LENGTH | GUSSET_CURVE_MEASURE_CENTRE | GUSSET_CURVE_MEASURE_AREA, context);
    }
    /// The report on outline k.
    gusset_outline_report report(std::size_t k = 0) const {
        return detail::lent(gusset_outline_get_report, outline_.get(), k);
    }
    /// The cycles of outline k and the control points after each, if the option history was set; see
    /// gusset_outline_get_history.
    gusset_outline_history history(std::size_t k = 0) const {
        return detail::lent(gusset_outline_get_history, outline_.get(), k);
    }
    /// GUSSET_POINT_... of each point.
    Span<const uint8_t> statuses() const & {
        const gusset_outline_view all = view();
        return {all.statuses, all.point_count};
    }
    Span<const uint8_t> statuses() const && = delete;
    /// The segment of its curve that each point lies on.
    Indices segments() const & { return detail::indices(view().segments); }
    Indices segments() const && = delete;
    /// The parameter of each point there.
    Span<const double> parameters() const & {
        const gusset_outline_view all = view();
        return {all.parameters, all.point_count};
    }
    Span<const double> parameters() const && = delete;
    /// The argument for the C interface, which this still owns.
    const gusset_outline *get() const noexcept { return outline_.get(); }

private:
    detail::Handle<gusset_outline, gusset_outline_destroy> outline_;
};

/// The section of each point with its two neighbours; see gusset_outlines_find_sections.
class Sections {
public:
    /// The method, alpha and the solver of the options are read.
    explicit Sections(const Outlines &outlines, const OutlineOptions &options = {},
                      const Context &context = Context())
        : controls_(outlines.get().point_count), parameters_(controls_.size()), statuses_(controls_.size()) {
        const gusset_outline_options given = detail::as_c(options);
        context.call(gusset_outlines_find_sections, &outlines.get(), &given, detail::numbers(controls_.data()),
                     parameters_.data(), statuses_.data(), &steps_);
    }
    /// The steps of OutlineSolver::step, of all sections.
    uint64_t steps() const noexcept { return steps_; }
    /// The control point of each section.
    Points controls() const & { return controls_; }
    Points controls() const && = delete;
    /// The parameter of each point on its section.
    Span<const double> parameters() const & { return parameters_; }
    Span<const double> parameters() const && = delete;
    /// GUSSET_POINT_... of each point.
    Span<const uint8_t> statuses() const & { return statuses_; }
    Span<const uint8_t> statuses() const && = delete;

private:
    std::vector<Point3> controls_;
    std::vector<double> parameters_;
    std::vector<uint8_t> statuses_;
    uint64_t steps_ = 0;
};

} // namespace gusset

#endif // GUSSET_OUTLINE_HPP
