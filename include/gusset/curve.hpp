/// @file
/// Curves of Bézier segments. Include gusset.hpp, not this.
#ifndef GUSSET_CURVE_HPP
#define GUSSET_CURVE_HPP

#include <gusset/context.hpp>
#include <gusset/curve_options.hpp>

#include <string_view>

namespace gusset {

/// A place on a curve.
using Place = gusset_place;
/// The place with parameter t, 0 to 1, on a segment.
inline Place place(uint32_t segment, double t) { return {segment, 0, t}; }

/// Places found on a curve; see gusset_places_view.
class Places {
public:
    /// Takes ownership of a handle of the C interface.
    explicit Places(gusset_places *owned) : places_(owned) {}

    /// The number of elements.
    std::size_t size() const { return view().count; }
    /// The places, in the order of the (first) curve.
    Span<const Place> places() const & {
        const gusset_places_view found = view();
        return {found.places, found.count};
    }
    Span<const Place> places() const && = delete;
    /// The points there.
    Points points() const & {
        const gusset_places_view found = view();
        return detail::points(found.points, found.count);
    }
    Points points() const && = delete;
    /// For intersections: the places on the other curve.
    Span<const Place> others() const & {
        const gusset_places_view found = view();
        return {found.others, found.others != nullptr ? found.count : 0};
    }
    Span<const Place> others() const && = delete;
    /// Four for each part in common: start and end on the one segment, then the same two on the
    /// other.
    Span<const Place> overlaps() const & {
        const gusset_places_view found = view();
        return {found.overlaps, 4 * found.overlap_count};
    }
    Span<const Place> overlaps() const && = delete;
    /// For a line or a plane: the segments that lie in it.
    Indices inside() const & { return detail::indices(view().inside); }
    Indices inside() const && = delete;
    /// Some pair of segments was left undecided.
    bool undecided() const { return view().undecided != 0; }

private:
    gusset_places_view view() const { return detail::lent(gusset_places_get_view, places_.get()); }
    detail::Handle<gusset_places, gusset_places_destroy> places_;
};

/// A curve in another form: an SVG path, a TrueType contour, a B-spline; see
/// gusset_curve_form_view.
class CurveForm {
public:
    /// Takes ownership of a handle of the C interface.
    explicit CurveForm(gusset_curve_form *owned) : form_(owned) {}

    /// The text of an SVG path; empty for other forms.
    std::string_view text() const & {
        const gusset_curve_form_view form = view();
        return form.text_length != 0 ? std::string_view(form.text, form.text_length) : std::string_view();
    }
    std::string_view text() const && = delete;
    /// The points of a contour, or the control points of a spline.
    Points points() const & {
        const gusset_curve_form_view form = view();
        return detail::points(form.points, form.point_count);
    }
    Points points() const && = delete;
    /// For a contour: 1 for each point on the curve, 0 off it.
    Span<const uint8_t> on_curve() const & {
        const gusset_curve_form_view form = view();
        return {form.on_curve, form.knot_count == 0 ? form.point_count : 0};
    }
    Span<const uint8_t> on_curve() const && = delete;
    /// The knots of a spline.
    Span<const double> knots() const & {
        const gusset_curve_form_view form = view();
        return {form.knots, form.knot_count};
    }
    Span<const double> knots() const && = delete;
    /// The degree of a spline.
    std::size_t degree() const { return view().degree; }

private:
    gusset_curve_form_view view() const { return detail::lent(gusset_curve_form_get_view, form_.get()); }
    detail::Handle<gusset_curve_form, gusset_curve_form_destroy> form_;
};

struct Line;
struct CurveOfDegrees;
struct OffsetCurve;

/// A curve of Bézier segments of any degrees up to 64. Immutable.
class Curve {
public:
    /// Takes ownership of a handle of the C interface.
    explicit Curve(gusset_curve *owned) : curve_(owned) {}

    /// `controls`: any container of elements that are two or three doubles and nothing else, such as
    /// std::array<double, 2>. `ends`: 0, then the index of the last control point of each segment.
    /// `closed`: the last point is the first again.
    template <class Container>
    static Curve from_controls(const Container &controls, Indices ends, bool closed, const Context &context = Context()) {
        using Point = std::decay_t<decltype(*std::data(controls))>;
        static_assert(std::is_same_v<typename detail::PointTraits<Point>::Scalar, double> &&
                          (sizeof(Point) == 16 || sizeof(Point) == 24),
                      "two or three doubles");
        const auto *numbers = reinterpret_cast<const double *>(std::data(controls));
        return Curve(context.result(gusset_curve_create, numbers, std::size(controls), static_cast<uint32_t>(sizeof(Point) / 8), ends.data(),
                                    ends.size(), closed));
    }

    /// Through nodes, as surfaces run through theirs. A closed curve ends with its first node
    /// again.
    static Curve through(Points nodes, bool closed, Scheme scheme = Scheme::six_tap,
                         const Context &context = Context()) {
        return Curve(context.result(gusset_curve_through_create, detail::numbers(nodes.data()), nodes.size(),
                                    closed, static_cast<gusset_scheme>(scheme)));
    }

    /// The argument for the C interface, which this still owns.
    const gusset_curve *get() const noexcept { return curve_.get(); }
    /// The control points.
    Points controls() const & {
        const gusset_curve_view curve = view();
        return detail::points(curve.controls, curve.control_count);
    }
    Points controls() const && = delete;
    /// 0, then the index of the last control point of each segment.
    Indices ends() const & { return detail::indices(view().ends); }
    Indices ends() const && = delete;
    /// The curve continues from its end into its start.
    bool is_closed() const { return view().closed != 0; }
    /// The number of segments.
    std::size_t segment_count() const { return view().ends.count - (view().ends.count != 0 ? 1 : 0); }

    /// The point at a place.
    Point3 point(Place at, const Context &context = Context()) const { return derivatives({&at, 1}, 0, context)[0]; }
    /// The points at many places.
    std::vector<Point3> points_at(Span<const Place> places, const Context &context = Context()) const {
        return derivatives(places, 0, context);
    }
    /// For each place the point and its derivatives up to `order`.
    std::vector<Point3> derivatives(Span<const Place> places, uint32_t order,
                                    const Context &context = Context()) const {
        std::vector<Point3> out(places.size() * (std::size_t{order} + 1));
        context.call(gusset_curve_evaluate, get(), places.data(), places.size(), order, detail::numbers(out.data()), nullptr, nullptr);
        return out;
    }
    /// See ::gusset_curve_evaluate.
    std::vector<Point3> tangents(Span<const Place> places, const Context &context = Context()) const {
        std::vector<Point3> out(places.size());
        context.call(gusset_curve_evaluate, get(), places.data(), places.size(), uint32_t{0}, nullptr, detail::numbers(out.data()), nullptr);
        return out;
    }
    /// See ::gusset_curve_evaluate.
    std::vector<double> curvatures(Span<const Place> places, const Context &context = Context()) const {
        std::vector<double> out(places.size());
        context.call(gusset_curve_evaluate, get(), places.data(), places.size(), uint32_t{0}, nullptr, nullptr, out.data());
        return out;
    }
    /// See ::gusset_curve_nearest.
    std::vector<gusset_curve_nearest_point> nearest(Points queries,
                                                    const Context &context = Context()) const {
        std::vector<gusset_curve_nearest_point> out(queries.size());
        context.call(gusset_curve_nearest, get(), detail::numbers(queries.data()), queries.size(), out.data());
        return out;
    }

    /// The measures that the flags GUSSET_CURVE_MEASURE_... ask for, 0 for all; `defined` says which of them
    /// the curve has.
    gusset_curve_measures measure(uint32_t flags = 0, const Context &context = Context()) const {
        return context.result(gusset_curve_measure, get(), flags);
    }
    /// The arc length of the curve.
    double length(const Context &context = Context()) const { return measure(GUSSET_CURVE_MEASURE_LENGTH, context).length; }
    /// The arc lengths from the start.
    std::vector<double> lengths_at(Span<const Place> places, const Context &context = Context()) const {
        std::vector<double> out(places.size());
        context.call(gusset_curve_lengths_at, get(), places.data(), places.size(), out.data());
        return out;
    }
    /// See ::gusset_curve_places_at.
    std::vector<Place> places_at(Span<const double> lengths, const Context &context = Context()) const {
        std::vector<Place> out(lengths.size());
        context.call(gusset_curve_places_at, get(), lengths.data(), lengths.size(), out.data());
        return out;
    }

    /// See ::gusset_curve_intersect_plane_create.
    Places intersect_plane(const Point3 &point, const Point3 &normal, const Context &context = Context()) const {
        return Places(context.result(gusset_curve_intersect_plane_create, get(), point.data(), normal.data()));
    }
    /// The places where the curve meets a line, or comes as near to it as `within`. The other places are on
    /// segment 0, with the line's own parameter.
    Places intersect_line(const Line &line, double within = 0.0, const Context &context = Context()) const;
    /// The places where the tangent makes an angle with a direction, and parts where it does all
    /// along: as overlaps, twice.
    Places tangents_at_angle(const Point3 &direction, double angle, const Context &context = Context()) const {
        return Places(context.result(gusset_curve_tangent_angle_create, get(), direction.data(), angle));
    }
    /// The places where two curves meet, or come as near to each other as `within`.
    Places intersect(const Curve &other, double within = 0.0, const Context &context = Context()) const {
        return Places(context.result(gusset_curve_intersect_create, get(), other.get(), within));
    }
    /// The places where a plane curve meets itself.
    Places self_intersections(const Context &context = Context()) const {
        return Places(context.result(gusset_curve_intersect_create, get(), nullptr, 0.0));
    }
    /// `amount`: a count, a step of arc length, or a chord error.
    Places sample(SampleRule rule, double amount, const Context &context = Context()) const {
        return Places(context.result(gusset_curve_sample_create, get(), static_cast<gusset_sample_rule>(rule), amount));
    }

    /// See ::gusset_curve_part_create.
    Curve part(Place from, Place to, const Context &context = Context()) const {
        return Curve(context.result(gusset_curve_part_create, get(), from, to));
    }
    /// See ::gusset_curve_reverse_create.
    Curve reversed(const Context &context = Context()) const {
        return Curve(context.result(gusset_curve_reverse_create, get()));
    }
    /// The curve with segments of degrees from `lowest` to `highest`; a segment that would deviate by more
    /// than `tolerance` is not lowered.
    CurveOfDegrees with_degrees(uint32_t lowest, uint32_t highest, double tolerance = 0.0,
                                const Context &context = Context()) const;
    /// The curve at a distance; its options have a tolerance above 0.
    OffsetCurve offset(double distance, const OffsetOptions &options, const Context &context = Context()) const;

    /// `tolerance`: of a contour, how far from the middle a joint still counts as there.
    CurveForm exported(CurveFormat format, double tolerance = 0.0, const Context &context = Context()) const {
        return CurveForm(context.result(gusset_curve_export_create, get(), static_cast<gusset_curve_format>(format), tolerance));
    }

private:
    gusset_curve_view view() const { return detail::lent(gusset_curve_get_view, curve_.get()); }
    detail::Handle<gusset_curve, gusset_curve_destroy> curve_;
};

/// A curve with other degrees.
struct CurveOfDegrees {
    /// The curve.
    Curve curve;
    /// For each segment a bound of its distance from the original; above the tolerance if it kept its degree.
    std::vector<double> deviations;
};

/// An offset curve and its report.
struct OffsetCurve {
    /// The curve at the distance.
    Curve curve;
    /// Its deviation from the true offset, its corners and cusps.
    gusset_offset_report report;
};

inline CurveOfDegrees Curve::with_degrees(uint32_t lowest, uint32_t highest, double tolerance, const Context &context) const {
    std::vector<double> deviations(segment_count());
    Curve curve(context.result(gusset_curve_change_degree_create, get(), lowest, highest, tolerance,
                               deviations.empty() ? nullptr : deviations.data()));
    return {std::move(curve), std::move(deviations)};
}

inline OffsetCurve Curve::offset(double distance, const OffsetOptions &options, const Context &context) const {
    const gusset_offset_options given = detail::as_c(options);
    auto report = detail::sized<gusset_offset_report>();
    Curve curve(context.result(gusset_curve_offset_create, get(), distance, &given, &report));
    return {std::move(curve), report};
}

} // namespace gusset

#endif // GUSSET_CURVE_HPP
