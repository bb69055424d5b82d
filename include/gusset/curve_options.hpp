/// @file
/// The options of gusset/curve.h. Where a comment says NULL, an empty list or options without changes are meant.
/// Generated from src/capi; do not edit. Include gusset.hpp, not this.
#ifndef GUSSET_CURVE_OPTIONS_HPP
#define GUSSET_CURVE_OPTIONS_HPP

#include <gusset/span.hpp>

namespace gusset {

/// Options of curves through outlines. See ::gusset_outline_options.
struct OutlineOptions {
    /// Kind of an outline's curve.
    CurveKind curve = CurveKind::composite;
    /// Guide of a section's control point.
    SectionMethod method = SectionMethod::bisector;
    /// For composite and single curves.
    ParameterLock lock = ParameterLock::parameter;
    /// For composite curves and chains.
    JointParameter joint = JointParameter::half;
    /// Method of solution.
    OutlineSolver solver = OutlineSolver::fast;
    /// For open outlines and parts between corners, without constraints.
    OutlineEnds ends = OutlineEnds::free;
    /// 0 to 1. A value sets method to GUSSET_METHOD_ALPHA.
    std::optional<double> alpha;
    /// Composite parameters are clamped to this and 1 - this: at least 0.001, below 1/2; 0: 0.01, or 1/12 with
    /// GUSSET_JOINT_PARAMETER_G2.
    double parameter_limit = 0.0;
    /// Largest distance of merged neighbours, below 1; 0: 1e-12. 1e-300 merges equal points only.
    double repeat_tolerance = 0.0;
    /// Points where the polygon turns by more are corners; at least 0; 0, or pi and more: none.
    double corner_angle = 0.0;
    /// Iterations end when moves are within it; below 1; 0: 1e-12.
    double tolerance = 0.0;
    /// Most sweeps or iterations between corners; 0: 200. If they do not converge, their replacement iterates further.
    uint32_t max_sweeps = 0;
    /// Most steps at a point in a sweep; 0: 20,000.
    uint32_t max_steps = 0;
    /// 1: keeps the cycles for gusset_outline_get_history.
    bool history = false;
};

/// Options of gusset_curve_offset_create. See ::gusset_offset_options.
struct OffsetOptions {
    /// Wanted deviation, above 0.
    double tolerance = 0.0;
    /// Halving stops at this many segments; 0: 65536.
    std::size_t max_segments = 0;
    /// Degree of segments, 2 or 3; 0: 3.
    uint32_t degree = 0;
};

/// Options of gusset_frame_create. See ::gusset_frame_options.
struct FrameOptions {
    /// Correspondence of points between sections.
    CorrespondenceRule correspondence = CorrespondenceRule::given;
    /// ANGLE: nodes in each section. ARC_LENGTH: likewise, more if sections have more corners. LANDMARKS: parts between
    /// two landmarks.
    uint32_t columns = 0;
    /// 1: the first section follows the last.
    bool ring = false;
    /// ARC_LENGTH. 1: closed sections start at their first points, or the corner after the first section's.
    bool given_starts = false;
    /// 1: only constraints make corners. 0: sections also have corners where they turn by more than `corner_angle` of
    /// `across`. If this is pi (not with ANGLE), corners are all points of polygons, and points that turn by 40 degrees
    /// and far more than usual. Polygons are closed sections of at most 6 points, and sections that turn by more than
    /// 54 or less than 6 degrees at points.
    bool smooth_corners = false;
    /// ANGLE: a point of the axis.
    Point3 axis_point{};
    /// ANGLE: direction of the axis; angles are right-handed about it.
    Point3 axis_direction{};
    /// ANGLE: direction of column 0, not parallel to the axis (at its first point if bent).
    Point3 reference{};
    /// ANGLE: a point of a bent axis for each section, in place of axis_point and axis_direction. The axis follows
    /// circles through three points each; the reference does not rotate about it. NULL: straight.
    std::vector<Point3> axis_points;
    /// LANDMARKS: for each section the same number of indices of its points, in order.
    std::vector<uint32_t> landmarks;
    /// Options of the curves across.
    OutlineOptions across;
    /// Options of the curves along.
    OutlineOptions along;
    /// GIVEN: indices of missing points over all sections, in any order; their coordinates are not read. A Catmull-Rom
    /// curve through up to two nodes before and after in the column fills each, with centripetal parameters from
    /// adjacent columns.
    std::vector<uint32_t> missing;
};

namespace detail {
inline gusset_outline_options as_c(const OutlineOptions &options) {
    auto given = sized<gusset_outline_options>();
    given.curve = static_cast<gusset_curve_kind>(options.curve);
    given.method = static_cast<gusset_section_method>(options.method);
    given.lock = static_cast<gusset_parameter_lock>(options.lock);
    given.joint = static_cast<gusset_joint_parameter>(options.joint);
    given.solver = static_cast<gusset_outline_solver>(options.solver);
    given.ends = static_cast<gusset_outline_ends>(options.ends);
    given.parameter_limit = options.parameter_limit;
    given.repeat_tolerance = options.repeat_tolerance;
    given.corner_angle = options.corner_angle;
    given.tolerance = options.tolerance;
    given.max_sweeps = options.max_sweeps;
    given.max_steps = options.max_steps;
    given.history = options.history ? 1 : 0;
    if (options.alpha) {
        given.alpha = *options.alpha;
        given.method = GUSSET_METHOD_ALPHA;
    }
    return given;
}

inline gusset_offset_options as_c(const OffsetOptions &options) {
    auto given = sized<gusset_offset_options>();
    given.tolerance = options.tolerance;
    given.max_segments = options.max_segments;
    given.degree = options.degree;
    return given;
}

/// The options that gusset_frame_options points to.
struct FrameOptionsNested {
    gusset_outline_options across;
    gusset_outline_options along;
};
inline gusset_frame_options as_c(const FrameOptions &options, FrameOptionsNested &nested) {
    auto given = sized<gusset_frame_options>();
    given.correspondence = static_cast<gusset_correspondence_rule>(options.correspondence);
    given.columns = options.columns;
    given.ring = options.ring ? 1 : 0;
    given.given_starts = options.given_starts ? 1 : 0;
    given.smooth_corners = options.smooth_corners ? 1 : 0;
    std::copy(options.axis_point.begin(), options.axis_point.end(), given.axis_point);
    std::copy(options.axis_direction.begin(), options.axis_direction.end(), given.axis_direction);
    std::copy(options.reference.begin(), options.reference.end(), given.reference);
    given.axis_points = numbers(first(options.axis_points));
    given.axis_point_count = options.axis_points.size();
    given.landmarks = {first(options.landmarks), options.landmarks.size()};
    nested.across = as_c(options.across);
    given.across = &nested.across;
    nested.along = as_c(options.along);
    given.along = &nested.along;
    given.missing = {first(options.missing), options.missing.size()};
    return given;
}
gusset_frame_options as_c(const FrameOptions &&, FrameOptionsNested &) = delete;
} // namespace detail

} // namespace gusset

#endif // GUSSET_CURVE_OPTIONS_HPP
