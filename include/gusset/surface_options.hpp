/// @file
/// The options of gusset/surface.h. Where a comment says NULL, an empty list or options without changes are meant.
/// Generated from src/capi; do not edit. Include gusset.hpp, not this.
#ifndef GUSSET_SURFACE_OPTIONS_HPP
#define GUSSET_SURFACE_OPTIONS_HPP

#include <gusset/span.hpp>

namespace gusset {

/// Options of gusset_surface_create. See ::gusset_surface_options.
struct SurfaceOptions {
    /// Guaranteed accuracy of distances and positions. 0: 1e-9 of the surface's box diagonal.
    double tolerance = 0.0;
    /// 1: builds cones of normals for GUSSET_CONTOUR_ANGLE and gusset_surface_nearest_angle; 0: the first such query
    /// does.
    bool cones = false;
};

/// Options among the inputs of gusset_nodes. See ::gusset_nodes.
struct NodesOptions {
    /// Interpolation through nodes.
    Scheme scheme = Scheme::six_tap;
    /// 1: closed in u.
    bool closed_u = false;
    /// 1: closed in v.
    bool closed_v = false;
};

/// Limits of a search for near points. See ::gusset_nearest_options.
struct NearestOptions {
    /// Largest distance; 0 or INFINITY: no limit.
    double limit = 0.0;
    /// Minima: most, nearest first; 0: all.
    std::size_t max_count = 0;
};

/// Density of points on curves. See ::gusset_contour_options.
struct ContourOptions {
    /// Above 0; at least the surface's tolerance applies. A value sets spacing to GUSSET_POINT_SPACING_CHORD.
    std::optional<double> chord;
    /// Curve points between crossings with cell sides.
    SpacingRule spacing = SpacingRule::automatic;
    /// Points between two crossings, at most 1000. A value sets spacing to GUSSET_POINT_SPACING_LEUS.
    std::optional<uint32_t> points;
};

/// Options of gusset_surface_intersection_create. See ::gusset_intersection_options.
struct IntersectionOptions {
    /// Largest distance of the curve from its chords, above 0; rare chords exceed it by about 15 %. At least the
    /// smallest of `tolerance` and the surfaces' applies. A value sets spacing to GUSSET_POINT_SPACING_CHORD.
    std::optional<double> chord;
    /// Surfaces touch where their gap or overlap stays within it; 0: the surfaces' smaller tolerance.
    /// Self-intersections use at most the surface's. Branches shorter than all three may be lost.
    double tolerance = 0.0;
    /// Not GUSSET_POINT_SPACING_LEUS; GUSSET_POINT_SPACING_AUTO refers to the smaller surface.
    SpacingRule spacing = SpacingRule::automatic;
};

/// Options among the inputs of gusset_spline. See ::gusset_spline.
struct SplineOptions {
    /// Largest distance from a rational spline at equal parameters, at least about 1e-13 of the size. 0: 1e-12 of the
    /// controls' box diagonal, or more for rounding.
    double tolerance = 0.0;
    /// Most cells of a rational spline; 0: 2^20.
    std::size_t max_cells = 0;
};

/// Options among the inputs of gusset_curve_net. See ::gusset_curve_net.
struct CurveNetOptions {
    /// Largest distance of curves that meet; both move to the middle. 0: 1e-6 of the box diagonal.
    double tolerance = 0.0;
    /// 1: columns are closed; the first row follows the last.
    bool closed_u = false;
    /// 1: rows are closed; the first column follows the last.
    bool closed_v = false;
};

/// Options of gusset_sheet_to_mesh. See ::gusset_sheet_mesh_options.
struct SheetMeshOptions {
    /// Largest distance of triangles from the surface, above 0; 0 or INFINITY: unlimited.
    double tolerance = 0.0;
    /// Least parts of a cell in u; 0: 1.
    uint32_t min_u = 0;
    /// Least parts of a cell in v; 0: 1.
    uint32_t min_v = 0;
    /// 1: triangles only; 0: quads, with triangles at poles.
    bool triangles = false;
};

namespace detail {
inline gusset_surface_options as_c(const SurfaceOptions &options) {
    auto given = sized<gusset_surface_options>();
    given.tolerance = options.tolerance;
    given.cones = options.cones ? 1 : 0;
    return given;
}

inline gusset_nodes as_c(const NodesOptions &options) {
    auto given = sized<gusset_nodes>();
    given.scheme = static_cast<gusset_scheme>(options.scheme);
    given.closed_u = options.closed_u ? 1 : 0;
    given.closed_v = options.closed_v ? 1 : 0;
    return given;
}

inline gusset_nearest_options as_c(const NearestOptions &options) {
    auto given = sized<gusset_nearest_options>();
    given.limit = options.limit;
    given.max_count = options.max_count;
    return given;
}

inline gusset_contour_options as_c(const ContourOptions &options) {
    auto given = sized<gusset_contour_options>();
    given.spacing = static_cast<gusset_spacing_rule>(options.spacing);
    if (options.chord) {
        given.chord = *options.chord;
        given.spacing = GUSSET_POINT_SPACING_CHORD;
    }
    if (options.points) {
        given.points = *options.points;
        given.spacing = GUSSET_POINT_SPACING_LEUS;
    }
    return given;
}

inline gusset_intersection_options as_c(const IntersectionOptions &options) {
    auto given = sized<gusset_intersection_options>();
    given.tolerance = options.tolerance;
    given.spacing = static_cast<gusset_spacing_rule>(options.spacing);
    if (options.chord) {
        given.chord = *options.chord;
        given.spacing = GUSSET_POINT_SPACING_CHORD;
    }
    return given;
}

inline gusset_spline as_c(const SplineOptions &options) {
    auto given = sized<gusset_spline>();
    given.tolerance = options.tolerance;
    given.max_cells = options.max_cells;
    return given;
}

inline gusset_curve_net as_c(const CurveNetOptions &options) {
    auto given = sized<gusset_curve_net>();
    given.tolerance = options.tolerance;
    given.closed_u = options.closed_u ? 1 : 0;
    given.closed_v = options.closed_v ? 1 : 0;
    return given;
}

inline gusset_sheet_mesh_options as_c(const SheetMeshOptions &options) {
    auto given = sized<gusset_sheet_mesh_options>();
    given.tolerance = options.tolerance;
    given.min_u = options.min_u;
    given.min_v = options.min_v;
    given.triangles = options.triangles ? 1 : 0;
    return given;
}
} // namespace detail

} // namespace gusset

#endif // GUSSET_SURFACE_OPTIONS_HPP
