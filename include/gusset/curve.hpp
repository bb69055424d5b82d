// Curves of Bézier segments, from C++. Include gusset.hpp, not this.
#ifndef GUSSET_CURVE_HPP
#define GUSSET_CURVE_HPP

#include <gusset/base.hpp>

#include <string_view>

namespace gusset {

/// A place on a curve.
using Place = gusset_place;
/// The place with parameter t, 0 to 1, on a segment.
inline Place place(uint32_t segment, double t) { return {segment, 0, t}; }

namespace detail {
inline Span<const Point3> points(const double *data, std::size_t count) {
    static_assert(sizeof(Point3) == 3 * sizeof(double), "packed");
    return {reinterpret_cast<const Point3 *>(data), count};
}
inline const double *numbers(const Point3 *points) { return reinterpret_cast<const double *>(points); }
inline double *numbers(Point3 *points) { return reinterpret_cast<double *>(points); }
} // namespace detail

/// Places found on a curve; see gusset_places_view.
class Places {
public:
    explicit Places(gusset_places *owned) : places_(owned) {}

    std::size_t size() const { return view().count; }
    /// The places, in the order of the (first) curve.
    Span<const Place> places() const {
        const gusset_places_view found = view();
        return {found.places, found.count};
    }
    /// The points there.
    Span<const Point3> points() const {
        const gusset_places_view found = view();
        return detail::points(found.points, found.count);
    }
    /// Of intersections: the places on the other curve.
    Span<const Place> others() const {
        const gusset_places_view found = view();
        return {found.others, found.others != nullptr ? found.count : 0};
    }
    /// Four for each part in common: start and end on the one segment, the same start and end on the other.
    Span<const Place> overlaps() const {
        const gusset_places_view found = view();
        return {found.overlaps, 4 * found.overlap_count};
    }
    /// Of crossings: the segments that lie in the line or plane.
    Indices inside() const { return detail::indices(view().inside); }
    /// Whether some pair of segments was given up.
    bool undecided() const { return view().undecided != 0; }

private:
    struct Destroy {
        void operator()(gusset_places *places) const noexcept { gusset_places_destroy(places); }
    };
    gusset_places_view view() const {
        gusset_places_view view{};
        view.struct_size = sizeof view;
        detail::check(gusset_places_get_view(places_.get(), &view));
        return view;
    }
    std::unique_ptr<gusset_places, Destroy> places_;
};

/// A curve in another form: an SVG path, a TrueType contour, a B-spline; see gusset_curve_form_view.
class CurveForm {
public:
    explicit CurveForm(gusset_curve_form *owned) : form_(owned) {}

    /// The text of an SVG path; empty for other forms.
    std::string_view text() const {
        const gusset_curve_form_view parts = view();
        return {parts.text, parts.text_length};
    }
    /// The points of a contour, or the control points of a spline.
    Span<const Point3> points() const {
        const gusset_curve_form_view parts = view();
        return detail::points(parts.points, parts.point_count);
    }
    /// Of a contour: 1 for each point on the curve, 0 off it.
    Span<const uint8_t> on_curve() const {
        const gusset_curve_form_view parts = view();
        return {parts.on_curve, parts.knot_count == 0 ? parts.point_count : 0};
    }
    /// The knots of a spline.
    Span<const double> knots() const {
        const gusset_curve_form_view parts = view();
        return {parts.knots, parts.knot_count};
    }
    /// The degree of a spline.
    std::size_t degree() const { return view().degree; }

private:
    struct Destroy {
        void operator()(gusset_curve_form *form) const noexcept { gusset_curve_form_destroy(form); }
    };
    gusset_curve_form_view view() const {
        gusset_curve_form_view parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_curve_form_get_view(form_.get(), &parts));
        return parts;
    }
    std::unique_ptr<gusset_curve_form, Destroy> form_;
};

/// How samples are spread.
enum class Sample : uint32_t {
    count = GUSSET_SAMPLE_COUNT,
    step = GUSSET_SAMPLE_STEP,
    chord = GUSSET_SAMPLE_CHORD
};

/// How curves and surfaces are drawn through nodes; see the constants.
enum class Scheme : uint32_t { six_tap = GUSSET_SCHEME_SIX_TAP, four_point = GUSSET_SCHEME_FOUR_POINT };

struct Line;
/// A box along the axes.
struct Bounds {
    /// The least and the greatest x, y, z.
    Point3 low, high;
};
struct Reduced;
struct Offset;

/// A curve of Bézier segments of any degrees up to 64. Immutable.
class Curve {
public:
    explicit Curve(gusset_curve *owned) : curve_(owned) {}

    /// `points`: any container of elements that are two or three doubles and nothing else, such as std::array<double, 2>.
    /// `ends`: 0, then the place of the last control point of each segment. `closed`: the last point is the first again.
    template <class Points>
    static Curve from(const Points &points, Indices ends, bool closed, const Context &context = Context()) {
        using Point = std::decay_t<decltype(*std::data(points))>;
        static_assert(std::is_same_v<std::decay_t<decltype(std::declval<const Point &>()[0])>, double> &&
                          (sizeof(Point) == 16 || sizeof(Point) == 24),
                      "two or three doubles");
        const auto *numbers = reinterpret_cast<const double *>(std::data(points));
        return made(context, [&](gusset_context *c, gusset_curve **curve) {
            return gusset_curve_create(c, numbers, std::size(points), sizeof(Point) / 8, ends.data(), ends.size(), closed,
                                       curve);
        });
    }

    /// Through points, as surfaces are drawn through their nodes. A closed curve ends with its first point again.
    static Curve through(Span<const Point3> nodes, bool closed, Scheme scheme = Scheme::six_tap,
                         const Context &context = Context()) {
        return made(context, [&](gusset_context *c, gusset_curve **curve) {
            return gusset_curve_through_create(c, detail::numbers(nodes.data()), nodes.size(), closed ? 1 : 0,
                                        static_cast<gusset_scheme>(scheme), curve);
        });
    }

    const gusset_curve *get() const noexcept { return curve_.get(); }
    /// The control points.
    Span<const Point3> points() const {
        const gusset_curve_view parts = view();
        return detail::points(parts.points, parts.point_count);
    }
    /// 0, then the place of the last control point of each segment.
    Indices ends() const { return detail::indices(view().ends); }
    /// Whether it ends where it begins and goes on there.
    bool is_closed() const { return view().closed != 0; }
    /// How many segments.
    std::size_t segment_count() const { return view().ends.count - (view().ends.count != 0 ? 1 : 0); }

    /// The point at a place.
    Point3 point(Place at, const Context &context = Context()) const { return derivatives({&at, 1}, 0, context)[0]; }
    /// The points at many places.
    std::vector<Point3> points_at(Span<const Place> places, const Context &context = Context()) const {
        return derivatives(places, 0, context);
    }
    /// For each place the point and its derivatives up to `order`.
    std::vector<Point3> derivatives(Span<const Place> places, uint32_t order, const Context &context = Context()) const {
        std::vector<Point3> out(places.size() * (std::size_t{order} + 1));
        context.call([&](gusset_context *c) {
            return gusset_curve_derivatives(c, get(), places.data(), places.size(), order, detail::numbers(out.data()));
        });
        return out;
    }
    std::vector<Point3> tangents(Span<const Place> places, const Context &context = Context()) const {
        std::vector<Point3> out(places.size());
        context.call([&](gusset_context *c) {
            return gusset_curve_tangents(c, get(), places.data(), places.size(), detail::numbers(out.data()));
        });
        return out;
    }
    std::vector<double> curvatures(Span<const Place> places, const Context &context = Context()) const {
        std::vector<double> out(places.size());
        context.call([&](gusset_context *c) {
            return gusset_curve_curvatures(c, get(), places.data(), places.size(), out.data());
        });
        return out;
    }
    std::vector<gusset_curve_nearest_point> nearest(Span<const Point3> queries, const Context &context = Context()) const {
        std::vector<gusset_curve_nearest_point> out(queries.size());
        context.call([&](gusset_context *c) {
            return gusset_curve_nearest(c, get(), detail::numbers(queries.data()), queries.size(), out.data());
        });
        return out;
    }

    double length(const Context &context = Context()) const {
        double length = 0.0;
        context.call([&](gusset_context *c) { return gusset_curve_length(c, get(), &length); });
        return length;
    }
    /// The arc lengths from the start.
    std::vector<double> lengths_at(Span<const Place> places, const Context &context = Context()) const {
        std::vector<double> out(places.size());
        context.call([&](gusset_context *c) {
            return gusset_curve_lengths_at(c, get(), places.data(), places.size(), out.data());
        });
        return out;
    }
    std::vector<Place> places_at(Span<const double> lengths, const Context &context = Context()) const {
        std::vector<Place> out(lengths.size());
        context.call([&](gusset_context *c) {
            return gusset_curve_places_at(c, get(), lengths.data(), lengths.size(), out.data());
        });
        return out;
    }
    Bounds bounds(const Context &context = Context()) const {
        std::array<double, 6> b{};
        context.call([&](gusset_context *c) { return gusset_curve_bounds(c, get(), b.data()); });
        return {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
    }
    Point3 area_vector(const Context &context = Context()) const {
        Point3 area{};
        context.call([&](gusset_context *c) { return gusset_curve_area_vector(c, get(), area.data()); });
        return area;
    }
    gusset_curve_moment_report moments(const Context &context = Context()) const {
        gusset_curve_moment_report moments{};
        moments.struct_size = sizeof moments;
        context.call([&](gusset_context *c) { return gusset_curve_moments(c, get(), &moments); });
        return moments;
    }

    Places cross_plane(const Point3 &point, const Point3 &normal, const Context &context = Context()) const {
        return found(context, [&](gusset_context *c, gusset_places **places) {
            return gusset_curve_intersect_plane_create(c, get(), point.data(), normal.data(), places);
        });
    }
    Places cross_line(const std::array<double, 2> &point, const std::array<double, 2> &direction,
                      const Context &context = Context()) const {
        return found(context, [&](gusset_context *c, gusset_places **places) {
            return gusset_curve_intersect_line_create(c, get(), point.data(), direction.data(), places);
        });
    }
    Places intersections(const Curve &other, const Context &context = Context()) const {
        return found(context, [&](gusset_context *c, gusset_places **places) {
            return gusset_curve_intersect_create(c, get(), other.get(), places);
        });
    }
    Places self_intersections(const Context &context = Context()) const {
        return found(context, [&](gusset_context *c, gusset_places **places) {
            return gusset_curve_intersect_create(c, get(), nullptr, places);
        });
    }
    /// Where two curves in space come as near to each other as `within`, and nearest.
    Places approach(const Curve &other, double within, const Context &context = Context()) const {
        return found(context, [&](gusset_context *c, gusset_places **places) {
            return gusset_curve_near_misses_create(c, get(), other.get(), within, places);
        });
    }
    /// The same with a line; the others are on its segment 0, with the line's own parameter.
    Places approach(const Line &line, double within, const Context &context = Context()) const;
    /// `amount`: a count, a step of arc length, or a chord error.
    Places sample(Sample rule, double amount, const Context &context = Context()) const {
        return found(context, [&](gusset_context *c, gusset_places **places) {
            return gusset_curve_sample_create(c, get(), static_cast<uint32_t>(rule), amount, places);
        });
    }

    Curve part(Place from, Place to, const Context &context = Context()) const {
        return made(context, [&](gusset_context *c, gusset_curve **out) {
            return gusset_curve_part_create(c, get(), from, to, out);
        });
    }
    /// The parts before and after a place.
    std::pair<Curve, Curve> split(Place at, const Context &context = Context()) const {
        const auto half = [&](uint32_t after) {
            return made(context, [&](gusset_context *c, gusset_curve **out) {
                return gusset_curve_split_create(c, get(), at, after, out);
            });
        };
        return {half(0), half(1)};
    }
    Curve reversed(const Context &context = Context()) const {
        return made(context, [&](gusset_context *c, gusset_curve **out) { return gusset_curve_reverse_create(c, get(), out); });
    }
    Curve elevated_by(uint32_t by, const Context &context = Context()) const {
        // By 0 the C function reads the degree to raise to: 1 changes nothing.
        return made(context, [&](gusset_context *c, gusset_curve **out) {
            return gusset_curve_elevate_create(c, get(), by, 1, out);
        });
    }
    Curve elevated_to(uint32_t degree, const Context &context = Context()) const {
        return made(context, [&](gusset_context *c, gusset_curve **out) {
            return gusset_curve_elevate_create(c, get(), 0, degree, out);
        });
    }
    Reduced reduced(uint32_t degree, double tolerance, const Context &context = Context()) const;
    /// `degree`: 2 or 3; `max_segments`: 0 for 65536.
    Offset offset(double distance, double tolerance, uint32_t degree = 3, std::size_t max_segments = 0,
                  const Context &context = Context()) const;

    CurveForm svg(const Context &context = Context()) const {
        return form(context, [&](gusset_context *c, gusset_curve_form **out) { return gusset_curve_svg_create(c, get(), out); });
    }
    CurveForm contour(double tolerance = 0.0, const Context &context = Context()) const {
        return form(context, [&](gusset_context *c, gusset_curve_form **out) {
            return gusset_curve_contour_create(c, get(), tolerance, out);
        });
    }
    CurveForm spline(const Context &context = Context()) const {
        return form(context,
                    [&](gusset_context *c, gusset_curve_form **out) { return gusset_curve_spline_create(c, get(), out); });
    }

private:
    struct Destroy {
        void operator()(gusset_curve *curve) const noexcept { gusset_curve_destroy(curve); }
    };
    template <class Made, class Handle, class Function>
    static Made create(const Context &context, Function &&function) {
        Handle *created = nullptr;
        context.call([&](gusset_context *c) { return function(c, &created); });
        return Made(created);
    }
    template <class Function>
    static Curve made(const Context &context, Function &&function) {
        return create<Curve, gusset_curve>(context, function);
    }
    template <class Function>
    static Places found(const Context &context, Function &&function) {
        return create<Places, gusset_places>(context, function);
    }
    template <class Function>
    static CurveForm form(const Context &context, Function &&function) {
        return create<CurveForm, gusset_curve_form>(context, function);
    }
    gusset_curve_view view() const {
        gusset_curve_view parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_curve_get_view(curve_.get(), &parts));
        return parts;
    }
    std::unique_ptr<gusset_curve, Destroy> curve_;
};

/// A curve of lower degree, and a bound on the deviation of each segment; those with more than the tolerance were kept.
struct Reduced {
    /// The curve of lower degree.
    Curve curve;
    /// Of each segment a bound of how far it is from the original.
    std::vector<double> deviations;
};

/// An offset curve and what is said about it.
struct Offset {
    /// The curve beside the original.
    Curve curve;
    /// How far it is from the true one, and what is odd.
    gusset_offset_report report;
};

inline Reduced Curve::reduced(uint32_t degree, double tolerance, const Context &context) const {
    std::vector<double> deviations(segment_count());
    Curve curve = made(context, [&](gusset_context *c, gusset_curve **out) {
        return gusset_curve_reduce_create(c, get(), degree, tolerance, deviations.empty() ? nullptr : deviations.data(), out);
    });
    return {std::move(curve), std::move(deviations)};
}

inline Offset Curve::offset(double distance, double tolerance, uint32_t degree, std::size_t max_segments,
                            const Context &context) const {
    gusset_offset_options options{};
    options.struct_size = sizeof options;
    options.tolerance = tolerance;
    options.degree = degree;
    options.max_segments = max_segments;
    gusset_offset_report report{};
    report.struct_size = sizeof report;
    Curve curve = made(context, [&](gusset_context *c, gusset_curve **out) {
        return gusset_curve_offset_create(c, get(), distance, &options, &report, out);
    });
    return {std::move(curve), report};
}

} // namespace gusset

#endif // GUSSET_CURVE_HPP
