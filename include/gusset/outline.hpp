// Outlines: Bezier curves through given points. Included by gusset.hpp.
#ifndef GUSSET_OUTLINE_HPP
#define GUSSET_OUTLINE_HPP

#include <gusset/curve.hpp>

namespace gusset {

/// What kind of curve; see the constants.
enum class CurveKind : uint32_t {
    composite = GUSSET_CURVE_COMPOSITE,
    single = GUSSET_CURVE_SINGLE,
    blend_c1 = GUSSET_CURVE_BLEND_C1,
    blend_c2 = GUSSET_CURVE_BLEND_C2,
    cubic_c2 = GUSSET_CURVE_CUBIC_C2
};
/// How the control point of a section is found; see the constants.
enum class Method : uint32_t {
    bisector = GUSSET_METHOD_BISECTOR,
    median = GUSSET_METHOD_MEDIAN,
    normal = GUSSET_METHOD_NORMAL,
    symmedian = GUSSET_METHOD_SYMMEDIAN,
    alpha = GUSSET_METHOD_ALPHA
};
/// How parameters are tied to points.
enum class Lock : uint32_t {
    parameter = GUSSET_LOCK_PARAMETER,
    self_consistent = GUSSET_LOCK_SELF_CONSISTENT,
    data_guide = GUSSET_LOCK_DATA_GUIDE
};
/// Where the joints of composite curves are.
enum class JointShare : uint32_t {
    half = GUSSET_JOINT_PARAMETER_HALF,
    knot = GUSSET_JOINT_PARAMETER_KNOT,
    g2 = GUSSET_JOINT_PARAMETER_G2
};
/// How curves are sought.
enum class Solver : uint32_t { fast = GUSSET_SOLVER_FAST, step = GUSSET_SOLVER_STEP };
/// How open outlines end.
enum class Ends : uint32_t { free = GUSSET_ENDS_FREE, perpendicular = GUSSET_ENDS_PERPENDICULAR };

/// What is demanded of a curve at a point.
struct Constraint : gusset_constraint {
    /// A corner at a point.
    static Constraint corner(uint32_t point) { return {{point, GUSSET_CONSTRAINT_CORNER, {0.0, 0.0, 0.0}}}; }
    /// A direction at a point.
    static Constraint tangent(uint32_t point, double x, double y, double z = 0.0) {
        return {{point, GUSSET_CONSTRAINT_TANGENT, {x, y, z}}};
    }
};
static_assert(sizeof(Constraint) == sizeof(gusset_constraint), "a constraint is what C takes");

/// Outlines in the host's memory, which must outlive the calls they are given to: a container that is gone by then leaves nothing to
/// read. See gusset_outlines.
class Outlines {
public:
    /// Plane points.
    Outlines(Span<const std::array<double, 2>> points, bool closed) : Outlines(points.data(), points.size(), 2, closed) {}
    /// Points in space.
    Outlines(Span<const std::array<double, 3>> points, bool closed) : Outlines(points.data(), points.size(), 3, closed) {}
    /// Points of 2 or 3 coordinates at the start of every `stride` bytes.
    Outlines(const void *points, std::size_t count, uint32_t dimension, bool closed, std::size_t stride = 0) {
        given_.struct_size = sizeof given_;
        given_.points = points;
        given_.point_stride = stride;
        given_.point_count = count;
        given_.dimension = dimension;
        given_.closed = closed ? 1 : 0;
    }
    /// Many outlines: where each begins, and where the last one ends.
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
    const gusset_outlines &get() const noexcept { return given_; }

private:
    gusset_outlines given_{};
};

/// How outlines are identified; see gusset_outline_options, where 0 stands for the default.
struct OutlineOptions {
    CurveKind curve = CurveKind::composite;
    Method method = Method::bisector;
    Lock lock = Lock::parameter;
    JointShare joint = JointShare::half;
    Solver solver = Solver::fast;
    Ends ends = Ends::free;
    /// For Method::alpha.
    double alpha = 0.5;
    double parameter_limit = 0.0;
    std::optional<double> repeat_tolerance;
    double corner_angle = 0.0;
    double tolerance = 0.0;
    double first_step = 0.0;
    double step_divisor = 0.0;
    uint32_t max_sweeps = 0;
    uint32_t max_steps = 0;

    gusset_outline_options get() const {
        gusset_outline_options options{};
        options.struct_size = sizeof options;
        options.curve = static_cast<uint32_t>(curve);
        options.method = static_cast<uint32_t>(method);
        options.lock = static_cast<uint32_t>(lock);
        options.joint = static_cast<uint32_t>(joint);
        options.solver = static_cast<uint32_t>(solver);
        options.ends = static_cast<uint32_t>(ends);
        options.alpha = alpha;
        options.parameter_limit = parameter_limit;
        options.repeats = repeat_tolerance ? GUSSET_REPEATS_GIVEN : GUSSET_REPEATS_AUTO;
        options.repeat_tolerance = repeat_tolerance.value_or(0.0);
        options.corner_angle = corner_angle;
        options.tolerance = tolerance;
        options.first_step = first_step;
        options.step_divisor = step_divisor;
        options.max_sweeps = max_sweeps;
        options.max_steps = max_steps;
        return options;
    }
};

/// x, y, z of points side by side; z is 0 in the plane.
using Points = Span<const std::array<double, 3>>;

/// The curve of one outline: segment s is the Bezier curve of the control points ends[s] to ends[s + 1].
struct OutlineCurve {
    /// The control points.
    Points controls;
    /// Segment s has the control points ends[s] to ends[s + 1].
    Indices ends;
    /// The number of segments.
    std::size_t size() const noexcept { return ends.empty() ? 0 : ends.size() - 1; }
    /// The control points of segment s.
    Points segment(std::size_t s) const { return {controls.data() + ends[s], ends[s + 1] - ends[s] + 1}; }
};

namespace detail {
/// What can be asked of outlines, owned or lent.
inline gusset_outline_view parts(const gusset_outline *outline) {
    gusset_outline_view parts{};
    parts.struct_size = sizeof parts;
    check(gusset_outline_get_view(outline, &parts));
    return parts;
}
} // namespace detail

/// The curves through the points of outlines; see gusset_outline_create.
class Outline {
public:
    /// Takes over what a C function made.
    explicit Outline(gusset_outline *made) : outline_(made) {}
    explicit Outline(const Outlines &outlines, const OutlineOptions &options = {}, const Context &context = Context()) {
        const gusset_outline_options given = options.get();
        gusset_outline *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_outline_create(c, &outlines.get(), &given, &created); });
        outline_.reset(created);
    }
    /// All arrays, valid as long as this lives.
    gusset_outline_view parts() const {
        return detail::parts(outline_.get());
    }
    /// The number of outlines.
    std::size_t size() const { return parts().outline_count; }
    /// The curve of outline k.
    OutlineCurve curve(std::size_t k = 0) const {
        return curve_of(parts(), k);
    }
    /// The curve of outline k of those that are lent.
    static OutlineCurve curve_of(const gusset_outline_view &all, std::size_t k) {
        if (k >= all.outline_count) {
            detail::check(GUSSET_ERROR_NO_SUCH_ELEMENT);
        }
        const std::size_t *from = all.starts + 2 * k, *to = from + 2;
        return {{reinterpret_cast<const std::array<double, 3> *>(all.controls) + from[0], to[0] - from[0]},
                {all.ends.data + from[1], to[1] - from[1]}};
    }
    /// A copy of the curve of outline k, for what curves can do.
    Curve curve_copy(std::size_t k = 0, const Context &context = Context()) const {
        gusset_curve *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_outline_curve_create(c, outline_.get(), k, &created); });
        return Curve(created);
    }
    /// Girth, area and centre of outline k.
    gusset_section_report measure(std::size_t k = 0) const {
        gusset_section_report measure{};
        detail::check(gusset_outline_get_section(outline_.get(), k, &measure));
        return measure;
    }
    /// What became of outline k.
    gusset_outline_report report(std::size_t k = 0) const {
        gusset_outline_report report{};
        report.struct_size = sizeof report;
        detail::check(gusset_outline_get_report(outline_.get(), k, &report));
        return report;
    }
    /// What became of each point: GUSSET_POINT_...
    Span<const uint8_t> statuses() const {
        const gusset_outline_view all = parts();
        return {all.statuses, all.point_count};
    }
    /// The segment of its curve that each point lies on.
    Indices segments() const { return detail::indices(parts().segments); }
    /// The parameter of each point there.
    Span<const double> parameters() const {
        const gusset_outline_view all = parts();
        return {all.parameters, all.point_count};
    }
    const gusset_outline *get() const noexcept { return outline_.get(); }

private:
    struct Destroy {
        void operator()(gusset_outline *outline) const noexcept { gusset_outline_destroy(outline); }
    };
    std::unique_ptr<gusset_outline, Destroy> outline_;
};

/// The section of each point with its two neighbours; see gusset_sections_create.
class Sections {
public:
    explicit Sections(const Outlines &outlines, Method method = Method::bisector, double alpha = 0.5,
                      const Context &context = Context()) {
        OutlineOptions options;
        options.method = method;
        options.alpha = alpha;
        const gusset_outline_options given = options.get();
        gusset_sections *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_sections_create(c, &outlines.get(), &given, &created); });
        sections_.reset(created);
    }
    /// The control point of each section.
    Points controls() const {
        const gusset_sections_view all = parts();
        return {reinterpret_cast<const std::array<double, 3> *>(all.controls), all.count};
    }
    /// The parameter of each point on its section.
    Span<const double> parameters() const {
        const gusset_sections_view all = parts();
        return {all.parameters, all.count};
    }
    /// GUSSET_POINT_...
    Span<const uint8_t> statuses() const {
        const gusset_sections_view all = parts();
        return {all.statuses, all.count};
    }

private:
    struct Destroy {
        void operator()(gusset_sections *sections) const noexcept { gusset_sections_destroy(sections); }
    };
    gusset_sections_view parts() const {
        gusset_sections_view parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_sections_get_view(sections_.get(), &parts));
        return parts;
    }
    std::unique_ptr<gusset_sections, Destroy> sections_;
};

} // namespace gusset

#endif
