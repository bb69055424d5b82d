// Smooth surfaces that answer: nearest points, lines, sections, silhouettes, intersections. Include gusset.hpp, not this.
#ifndef GUSSET_SURFACE_HPP
#define GUSSET_SURFACE_HPP

#include <gusset/sheet.hpp>
#include <gusset/surface_hits.hpp>
#include <gusset/surface_points.hpp>

#include <initializer_list>

namespace gusset {

/// What is between the points where a curve crosses the lines of the surface; see gusset_contour_options.
class Between {
public:
    /// Points that keep chords within 1e-4 of the diagonal of the surface's box.
    Between() = default;
    /// Points that keep chords within a length.
    static Between chord(double length) { return {GUSSET_POINT_SPACING_CHORD, length, 0}; }
    /// The crossings alone.
    static Between nothing() { return {GUSSET_POINT_SPACING_CELL_EDGES, 0.0, 0}; }
    /// So many points of the paper's cubics.
    static Between leus(uint32_t points) { return {GUSSET_POINT_SPACING_LEUS, 0.0, points}; }

    /// What the C interface takes.
    gusset_contour_options as_c(bool unsigned_normals = false) const {
        gusset_contour_options given{};
        given.struct_size = sizeof given;
        given.chord = chord_;
        given.between = kind_;
        given.points = points_;
        given.unsigned_normals = unsigned_normals ? 1 : 0;
        return given;
    }

private:
    Between(gusset_point_spacing kind, double chord, uint32_t points) : kind_(kind), chord_(chord), points_(points) {}
    gusset_point_spacing kind_ = GUSSET_POINT_SPACING_AUTO;
    double chord_ = 0.0;
    uint32_t points_ = 0;
};

/// Whether a normal and its opposite are the same.
enum class NormalSide : uint32_t { one = 0, both = 1 };

/// When the cones of normals are built: by the first question about angles, or with the surface.
enum class NormalCones : uint32_t { later = 0, now = 1 };

/// How intersections are wanted; see gusset_intersection_options.
struct IntersectOptions {
    /// The greatest distance from chords; 0: 1e-4 of the diagonal of the smaller surface's box; infinite: only where sides are crossed.
    double chord = 0.0;
    /// Branches that are shorter may be lost; 0: the smaller tolerance of the two.
    double tolerance = 0.0;
};

/// A cell of one surface and one of another; see gusset_cell_pair.
using CellPair = gusset_cell_pair;
/// What there is to know of a point of a surface; see gusset_surface_point.
using SurfacePoint = gusset_surface_point;

/// Pairs of cells that may meet: a range of CellPair. Spans and iterators live as long as this, and are not lent by a temporary.
class CellPairs {
public:
    using value_type = CellPair;
    using iterator = const CellPair *;

    explicit CellPairs(gusset_cell_pairs *owned) : pairs_(owned) {}
    std::size_t size() const { return parts().count; }
    bool empty() const { return size() == 0; }
    /// Pair `i`; throws std::out_of_range.
    CellPair operator[](std::size_t i) const {
        const gusset_cell_pairs_view all = parts();
        if (i >= all.count) {
            throw std::out_of_range("gusset: no such pair");
        }
        return all.pairs[i];
    }
    iterator begin() const & { return pairs().begin(); }
    iterator begin() const && = delete;
    iterator end() const & { return pairs().end(); }
    iterator end() const && = delete;
    /// All pairs.
    Span<const CellPair> pairs() const & {
        const gusset_cell_pairs_view all = parts();
        return {all.pairs, all.count};
    }
    Span<const CellPair> pairs() const && = delete;

private:
    struct Destroy {
        void operator()(gusset_cell_pairs *pairs) const noexcept { gusset_cell_pairs_destroy(pairs); }
    };
    gusset_cell_pairs_view parts() const { return detail::lent(gusset_cell_pairs_get_view, pairs_.get()); }
    std::unique_ptr<gusset_cell_pairs, Destroy> pairs_;
};

/// A smooth surface of one or more sheets with an index. Immutable: it may be asked from many threads at the same time. It keeps what it
/// needs of its sheets.
class Surface {
public:
    explicit Surface(gusset_surface *owned) : surface_(owned) {}
    /// tolerance: a length, to which answers are proved; 0: 1e-9 of the diagonal of the surface's box.
    explicit Surface(Span<const Sheet> sheets, double tolerance = 0.0, const Context &context = Context(),
                     NormalCones cones = NormalCones::later) {
        std::vector<const gusset_sheet *> handles;
        for (const Sheet &sheet : sheets) {
            handles.push_back(sheet.get());
        }
        gusset_surface_options given{};
        given.struct_size = sizeof given;
        given.tolerance = tolerance;
        given.cones = static_cast<uint32_t>(cones);
        gusset_surface *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_surface_create(c, handles.data(), handles.size(), &given, &created);
        });
        surface_.reset(created);
    }
    /// The index of one sheet.
    explicit Surface(const Sheet &sheet, double tolerance = 0.0, const Context &context = Context(),
                     NormalCones cones = NormalCones::later)
        : Surface(Span<const Sheet>(&sheet, 1), tolerance, context, cones) {}

    const gusset_surface *get() const noexcept { return surface_.get(); }
    /// How large it is, and its box.
    gusset_surface_report info() const { return detail::lent(gusset_surface_get_report, get()); }
    /// What sheet k is: its cells, and where they begin among those of all sheets.
    gusset_surface_sheet_report sheet(std::size_t k) const {
        gusset_surface_sheet_report facts{};
        facts.struct_size = sizeof facts;
        detail::check(gusset_surface_get_sheet(get(), k, &facts));
        return facts;
    }

    /// The nearest point to each query.
    std::vector<Closest> closest(Span<const Point3> queries, const ClosestOptions &options = {},
                                 const Context &context = Context()) const {
        std::vector<Closest> out(queries.size());
        const gusset_nearest_options given = detail::as_c(options);
        context.call([&](gusset_context *c) {
            return gusset_surface_nearest(c, get(), detail::numbers(queries.data()), queries.size(), 0, &given, out.data());
        });
        return out;
    }
    /// The nearest point to a query; see gusset_surface_nearest.
    Closest closest(const Point3 &query, const ClosestOptions &options = {}, const Context &context = Context()) const {
        return closest(Span<const Point3>(&query, 1), options, context)[0];
    }
    /// The places where the distance from a query is locally least.
    SurfacePoints minima(const Point3 &query, const ClosestOptions &options = {}, const Context &context = Context()) const {
        const gusset_nearest_options given = detail::as_c(options);
        return found<SurfacePoints, gusset_surface_points>(context, [&](gusset_context *c, gusset_surface_points **out) {
            return gusset_surface_minima_create(c, get(), query.data(), &given, out);
        });
    }
    /// The cells that have a point within a radius of a query.
    SurfaceRegion region(const Point3 &query, double radius, const Context &context = Context()) const {
        return found<SurfaceRegion, gusset_surface_region>(context, [&](gusset_context *c, gusset_surface_region **out) {
            return gusset_surface_region_create(c, get(), query.data(), radius, out);
        });
    }

    /// Where lines, rays or segments meet the surface.
    SurfaceHits lines(Span<const Line> lines, Which which = Which::all, const Context &context = Context()) const {
        return found<SurfaceHits, gusset_surface_hits>(context, [&](gusset_context *c, gusset_surface_hits **out) {
            return gusset_surface_line_hits_create(c, get(), lines.data(), lines.size(), static_cast<gusset_hit_selection>(which), out);
        });
    }
    /// Where one line meets the surface; see gusset_surface_line_hits_create.
    SurfaceHits line(const Line &line, Which which = Which::all, const Context &context = Context()) const {
        return lines({&line, 1}, which, context);
    }
    /// The first hit of each line; its kind is none where there is none.
    std::vector<Hit> first_hits(Span<const Line> lines, const Context &context = Context()) const {
        std::vector<Hit> out(lines.size());
        context.call([&](gusset_context *c) {
            return gusset_surface_first_hits(c, get(), lines.data(), lines.size(), out.data());
        });
        return out;
    }
    /// Where a curve in space meets the surface.
    SurfaceHits curve(const Curve &curve, Which which = Which::all, const Context &context = Context()) const {
        return found<SurfaceHits, gusset_surface_hits>(context, [&](gusset_context *c, gusset_surface_hits **out) {
            return gusset_surface_curve_hits_create(c, get(), curve.get(), static_cast<gusset_hit_selection>(which), out);
        });
    }

    /// Where the plane through a point across a normal cuts the surface.
    SurfacePaths section(const Point3 &point, const Point3 &normal, const Between &between = {},
                         const Context &context = Context()) const {
        const double here = 0.0;
        return sections(point, normal, {&here, 1}, between, context);
    }
    /// Where parallel planes do, at distances from the point along the normal, which rise.
    SurfacePaths sections(const Point3 &point, const Point3 &normal, Span<const double> offsets, const Between &between = {},
                          const Context &context = Context()) const {
        const gusset_contour_options given = between.as_c();
        return paths(context, [&](gusset_context *c, gusset_surface_paths **out) {
            return gusset_surface_section_create(c, get(), point.data(), normal.data(), offsets.data(), offsets.size(), &given, out);
        });
    }
    /// The contours of values that are given at the corners of all cells.
    SurfacePaths contours(Span<const double> values, Span<const double> levels, const Between &between = {},
                          const Context &context = Context()) const {
        const gusset_contour_options given = between.as_c();
        return paths(context, [&](gusset_context *c, gusset_surface_paths **out) {
            return gusset_surface_contours_create(c, get(), values.data(), values.size(), levels.data(), levels.size(), &given, out);
        });
    }
    /// Where the normals make given angles, in radians and rising, with a direction.
    SurfacePaths isophotes(const Point3 &direction, Span<const double> angles, NormalSide side = NormalSide::one,
                           const Between &between = {}, const Context &context = Context()) const {
        const gusset_contour_options given = between.as_c(side == NormalSide::both);
        return paths(context, [&](gusset_context *c, gusset_surface_paths **out) {
            return gusset_surface_isophotes_create(c, get(), direction.data(), angles.data(), angles.size(), &given, out);
        });
    }
    /// The silhouettes of the surface seen along a direction.
    SurfacePaths silhouette(const Point3 &direction, const Between &between = {}, const Context &context = Context()) const {
        const double right = 1.57079632679489661923;
        return isophotes(direction, {&right, 1}, NormalSide::one, between, context);
    }
    /// Where a normal's angle with a direction is nearest to one that is given.
    gusset_nearest_angle_report nearest_angle(const Point3 &direction, double angle, NormalSide side = NormalSide::one,
                                       const Context &context = Context()) const {
        const gusset_contour_options given = Between().as_c(side == NormalSide::both);
        gusset_nearest_angle_report nearest{};
        nearest.struct_size = sizeof nearest;
        context.call([&](gusset_context *c) {
            return gusset_surface_nearest_angle(c, get(), direction.data(), angle, &given, &nearest);
        });
        return nearest;
    }

    /// The curves in which two surfaces meet, with places on both.
    SurfacePaths intersect(const Surface &other, const IntersectOptions &options = {},
                           const Context &context = Context()) const {
        gusset_intersection_options given{};
        given.struct_size = sizeof given;
        given.chord = options.chord;
        given.tolerance = options.tolerance;
        return paths(context, [&](gusset_context *c, gusset_surface_paths **out) {
            return gusset_surface_intersection_create(c, get(), other.get(), &given, out);
        });
    }
    /// The pairs of cells of two surfaces that may be as near to each other as `within`.
    CellPairs candidates(const Surface &other, double within = 0.0, const Context &context = Context()) const {
        return found<CellPairs, gusset_cell_pairs>(context, [&](gusset_context *c, gusset_cell_pairs **out) {
            return gusset_surface_cell_pairs_create(c, get(), other.get(), within, out);
        });
    }

    /// Points, derivatives, normals and curvatures at places.
    std::vector<SurfacePoint> evaluate(Span<const SurfacePlace> places, const Context &context = Context()) const {
        std::vector<SurfacePoint> out(places.size());
        context.call([&](gusset_context *c) {
            return gusset_surface_evaluate(c, get(), places.data(), places.size(), out.data());
        });
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
        context.call([&](gusset_context *c) {
            return gusset_surface_locate(c, get(), sheet, numbers, parameters.size(), out.data());
        });
        return out;
    }
    /// The place of one pair of parameters of a sheet; see gusset_surface_locate.
    SurfacePlace locate(uint32_t sheet, double u, double v, const Context &context = Context()) const {
        const std::array<double, 2> parameters{u, v};
        return locate(sheet, Span<const std::array<double, 2>>(&parameters, 1), context)[0];
    }

private:
    struct Destroy {
        void operator()(gusset_surface *surface) const noexcept { gusset_surface_destroy(surface); }
    };
    template <class Found, class Handle, class Function>
    static Found found(const Context &context, Function &&function) {
        Handle *created = nullptr;
        context.call([&](gusset_context *c) { return function(c, &created); });
        return Found(created);
    }
    template <class Function>
    static SurfacePaths paths(const Context &context, Function &&function) {
        return found<SurfacePaths, gusset_surface_paths>(context, function);
    }
    std::unique_ptr<gusset_surface, Destroy> surface_;
};

} // namespace gusset

#endif // GUSSET_SURFACE_HPP
