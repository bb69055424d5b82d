/// @file
/// Smooth surfaces and their queries. Include gusset.hpp, not this.
#ifndef GUSSET_SURFACE_HPP
#define GUSSET_SURFACE_HPP

#include <gusset/sheet.hpp>
#include <gusset/surface_hits.hpp>
#include <gusset/surface_points.hpp>

namespace gusset {

/// One side: a normal differs from its opposite. Both: they are the same.
enum class NormalSide : uint32_t { one = 0, both = 1 };

/// A point of a surface with derivatives, normal and curvatures; see gusset_surface_point.
using SurfacePoint = gusset_surface_point;

/// A smooth surface of one or more sheets with an index. Immutable: many threads may query it at
/// the same time. It keeps what it needs of its sheets.
class Surface {
public:
    /// Takes ownership of a handle of the C interface.
    explicit Surface(gusset_surface *owned) : surface_(owned) {}
    /// The index of sheets.
    explicit Surface(Span<const Sheet> sheets, const SurfaceOptions &options = {}, const Context &context = Context()) {
        std::vector<const gusset_sheet *> handles;
        for (const Sheet &sheet : sheets) {
            handles.push_back(sheet.get());
        }
        const gusset_surface_options given = detail::as_c(options);
        surface_.reset(context.result(gusset_surface_create, handles.data(), handles.size(), &given));
    }
    /// The index of one sheet.
    explicit Surface(const Sheet &sheet, const SurfaceOptions &options = {}, const Context &context = Context())
        : Surface(Span<const Sheet>(&sheet, 1), options, context) {}

    /// The argument for the C interface, which this still owns.
    const gusset_surface *get() const noexcept { return surface_.get(); }
    /// Its numbers of sheets and cells, and its box.
    gusset_surface_report report() const { return detail::lent(gusset_surface_get_report, get()); }
    /// The sheets: the cells of each, and the number of its first one among all cells. Valid as long as
    /// the surface.
    Span<const gusset_surface_sheet> sheets() const & {
        const gusset_surface_report all = report();
        return {all.sheets, all.sheet_count};
    }
    Span<const gusset_surface_sheet> sheets() const && = delete;

    /// The nearest point to each query.
    std::vector<NearestPoint> nearest(Points queries, const NearestOptions &options = {},
                                      const Context &context = Context()) const {
        std::vector<NearestPoint> out(queries.size());
        const gusset_nearest_options given = detail::as_c(options);
        context.call(gusset_surface_nearest, get(), detail::numbers(queries.data()), queries.size(), &given,
                     out.data());
        return out;
    }
    /// The nearest point to a query; see gusset_surface_nearest.
    NearestPoint nearest(const Point3 &query, const NearestOptions &options = {},
                         const Context &context = Context()) const {
        return nearest(Points(&query, 1), options, context)[0];
    }
    /// The local minima of the distance from a query.
    SurfacePoints minima(const Point3 &query, const NearestOptions &options = {},
                         const Context &context = Context()) const {
        const gusset_nearest_options given = detail::as_c(options);
        return SurfacePoints(context.result(gusset_surface_minima_create, get(), query.data(), &given));
    }
    /// The cells that have a point within a radius of a query.
    SurfaceCells region(const Point3 &query, double radius, const Context &context = Context()) const {
        return SurfaceCells(context.result(gusset_surface_region_create, get(), query.data(), radius));
    }

    /// The nearest points of the surface and a line; the parameter is the line's. `tolerance`: to
    /// which the distance is proved; 0: the surface's.
    SurfaceDistance distance(const Line &line, double tolerance = 0.0, const Context &context = Context()) const {
        gusset_target target = target_of(GUSSET_TARGET_LINE);
        target.line = line;
        return distance(target, tolerance, context);
    }
    /// The same with a plane; the parameter is the distance, negative below it.
    SurfaceDistance distance(const Point3 &point, const Point3 &normal, double tolerance = 0.0,
                             const Context &context = Context()) const {
        gusset_target target = target_of(GUSSET_TARGET_PLANE);
        std::copy(point.begin(), point.end(), target.point);
        std::copy(normal.begin(), normal.end(), target.normal);
        return distance(target, tolerance, context);
    }
    /// The same with a curve.
    SurfaceDistance distance(const Curve &curve, double tolerance = 0.0, const Context &context = Context()) const {
        gusset_target target = target_of(GUSSET_TARGET_CURVE);
        target.curve = curve.get();
        return distance(target, tolerance, context);
    }
    /// The same with another surface.
    SurfaceDistance distance(const Surface &other, double tolerance = 0.0, const Context &context = Context()) const {
        gusset_target target = target_of(GUSSET_TARGET_SURFACE);
        target.surface = other.get();
        return distance(target, tolerance, context);
    }

    /// The hits of lines, rays or segments.
    SurfaceHits line_hits(Span<const Line> lines, HitSelection selection = HitSelection::all,
                          const Context &context = Context()) const {
        return hits(lines, nullptr, selection, context);
    }
    /// The hits of one line; see gusset_surface_hits_create.
    SurfaceHits line_hits(const Line &line, HitSelection selection = HitSelection::all,
                          const Context &context = Context()) const {
        return line_hits(Span<const Line>(&line, 1), selection, context);
    }
    /// The first hit of each line; HitKind::none for a line without a hit.
    std::vector<Hit> first_hits(Span<const Line> lines, const Context &context = Context()) const {
        std::vector<Hit> out(lines.size());
        context.call(gusset_surface_first_hits, get(), lines.data(), lines.size(), out.data());
        return out;
    }
    /// The hits of a curve in space.
    SurfaceHits curve_hits(const Curve &curve, HitSelection selection = HitSelection::all,
                           const Context &context = Context()) const {
        return hits({}, curve.get(), selection, context);
    }

    /// The section by the plane through a point across a normal.
    SurfacePaths section(const Point3 &point, const Point3 &normal, const ContourOptions &options = {},
                         const Context &context = Context()) const {
        const double here = 0.0;
        return sections(point, normal, {&here, 1}, options, context);
    }
    /// The sections by parallel planes, at increasing distances from the point along the normal.
    SurfacePaths sections(const Point3 &point, const Point3 &normal, Span<const double> offsets,
                          const ContourOptions &options = {}, const Context &context = Context()) const {
        gusset_contour_function height = function_of(GUSSET_CONTOUR_HEIGHT);
        std::copy(point.begin(), point.end(), height.point);
        std::copy(normal.begin(), normal.end(), height.direction);
        return contours(height, offsets, options, context);
    }
    /// The contours of values given at the corners of all cells.
    SurfacePaths contours(Span<const double> values, Span<const double> levels, const ContourOptions &options = {},
                          const Context &context = Context()) const {
        gusset_contour_function given = function_of(GUSSET_CONTOUR_VALUES);
        given.values = values.data();
        given.value_count = values.size();
        return contours(given, levels, options, context);
    }
    /// The curves along which the normal makes given angles with a direction, in radians and
    /// increasing.
    SurfacePaths isophotes(const Point3 &direction, Span<const double> angles, NormalSide side = NormalSide::one,
                           const ContourOptions &options = {}, const Context &context = Context()) const {
        gusset_contour_function angle = function_of(GUSSET_CONTOUR_ANGLE);
        std::copy(direction.begin(), direction.end(), angle.direction);
        angle.unsigned_normals = static_cast<uint32_t>(side);
        return contours(angle, angles, options, context);
    }
    /// The silhouettes of the surface seen along a direction.
    SurfacePaths silhouette(const Point3 &direction, const ContourOptions &options = {},
                            const Context &context = Context()) const {
        const double right = 1.57079632679489661923;
        return isophotes(direction, {&right, 1}, NormalSide::one, options, context);
    }
    /// The point whose normal makes the angle with a direction that is nearest to a given one.
    gusset_nearest_angle_report nearest_angle(const Point3 &direction, double angle, NormalSide side = NormalSide::one,
                                              const Context &context = Context()) const {
        return context.result(gusset_surface_nearest_angle, get(), direction.data(), angle,
                              static_cast<uint32_t>(side));
    }

    /// The curves of intersection of two surfaces, with places on both.
    SurfacePaths intersect(const Surface &other, const IntersectionOptions &options = {},
                           const Context &context = Context()) const {
        return meet(other.get(), options, context);
    }
    /// The curves in which the surface meets itself, with places on both pieces.
    SurfacePaths self_intersect(const IntersectionOptions &options = {}, const Context &context = Context()) const {
        return meet(nullptr, options, context);
    }
    /// The pairs of cells of two surfaces that may be within a distance of each other.
    SurfaceCells cell_pairs(const Surface &other, double within = 0.0, const Context &context = Context()) const {
        return SurfaceCells(context.result(gusset_surface_cell_pairs_create, get(), other.get(), within));
    }

    /// Points, derivatives, normals and curvatures at places.
    std::vector<SurfacePoint> evaluate(Span<const SurfacePlace> places, const Context &context = Context()) const {
        std::vector<SurfacePoint> out(places.size());
        context.call(gusset_surface_evaluate, get(), places.data(), places.size(), out.data());
        return out;
    }
    /// One point; see gusset_surface_evaluate.
    SurfacePoint evaluate(const SurfacePlace &place, const Context &context = Context()) const {
        return evaluate(Span<const SurfacePlace>(&place, 1), context)[0];
    }
    /// The places of parameters u, v of a whole sheet: node (i, j) has u = i and v = j.
    std::vector<SurfacePlace> locate(uint32_t sheet, Span<const std::array<double, 2>> parameters,
                                     const Context &context = Context()) const {
        std::vector<SurfacePlace> out(parameters.size());
        const auto *numbers = reinterpret_cast<const double *>(parameters.data());
        context.call(gusset_surface_locate, get(), sheet, numbers, parameters.size(), out.data());
        return out;
    }
    /// The place of one pair of parameters of a sheet; see gusset_surface_locate.
    SurfacePlace locate(uint32_t sheet, double u, double v, const Context &context = Context()) const {
        const std::array<double, 2> parameters{u, v};
        return locate(sheet, Span<const std::array<double, 2>>(&parameters, 1), context)[0];
    }

private:
    static gusset_target target_of(gusset_target_kind kind) {
        auto made = detail::sized<gusset_target>();
        made.kind = kind;
        return made;
    }
    static gusset_contour_function function_of(gusset_contour_kind kind) {
        auto made = detail::sized<gusset_contour_function>();
        made.kind = kind;
        return made;
    }
    SurfaceDistance distance(const gusset_target &target, double tolerance, const Context &context) const {
        return SurfaceDistance(context.result(gusset_surface_distance, get(), &target, tolerance));
    }
    SurfaceHits hits(Span<const Line> lines, const gusset_curve *curve, HitSelection selection,
                     const Context &context) const {
        return SurfaceHits(context.result(gusset_surface_hits_create, get(), lines.data(), lines.size(), curve,
                                          static_cast<gusset_hit_selection>(selection)));
    }
    SurfacePaths contours(const gusset_contour_function &function, Span<const double> levels,
                          const ContourOptions &options, const Context &context) const {
        const gusset_contour_options given = detail::as_c(options);
        return SurfacePaths(context.result(gusset_surface_contours_create, get(), &function, levels.data(),
                                           levels.size(), &given));
    }
    SurfacePaths meet(const gusset_surface *other, const IntersectionOptions &options, const Context &context) const {
        const gusset_intersection_options given = detail::as_c(options);
        return SurfacePaths(context.result(gusset_surface_intersection_create, get(), other, &given));
    }

    detail::Handle<gusset_surface, gusset_surface_destroy> surface_;
};

inline ReferenceTask ReferenceTask::surface_of(const Surface &other) {
    ReferenceTask made(GUSSET_REFERENCE_SURFACE, {}, {});
    made.surface = other.get();
    return made;
}

} // namespace gusset

#endif // GUSSET_SURFACE_HPP
