/// @file
/// Lines, and their intersections with surfaces. Include gusset.hpp, not this.
#ifndef GUSSET_SURFACE_HITS_HPP
#define GUSSET_SURFACE_HITS_HPP

#include <gusset/curve.hpp>

#include <cstring>

namespace gusset {

/// A line, ray or segment; see gusset_line.
struct Line : gusset_line {
    /// A line, to infinity both ways.
    static Line line(const Point3 &origin, const Point3 &direction) {
        const double infinity = std::numeric_limits<double>::infinity();
        return {origin, direction, -infinity, infinity};
    }
    /// A ray from its origin.
    static Line ray(const Point3 &origin, const Point3 &direction) {
        return {origin, direction, 0.0, std::numeric_limits<double>::infinity()};
    }
    /// t is 0 at the first point and 1 at the second.
    static Line segment(const Point3 &from, const Point3 &to) {
        return {from, {to[0] - from[0], to[1] - from[1], to[2] - from[2]}, 0.0, 1.0};
    }
    /// From parameter `min` to `max`.
    Line(const Point3 &start, const Point3 &along, double min, double max) : gusset_line{} {
        std::memcpy(origin, start.data(), sizeof origin);
        std::memcpy(direction, along.data(), sizeof direction);
        from = min;
        to = max;
    }
};
static_assert(sizeof(Line) == sizeof(gusset_line), "a line is what C takes");

/// A point that a line or a curve and a surface have in common; see gusset_surface_hit.
struct Hit : gusset_surface_hit {
    /// No hit.
    Hit() : gusset_surface_hit{} {}
    /// A hit as the C interface has it.
    explicit Hit(const gusset_surface_hit &hit) : gusset_surface_hit(hit) {}
    /// The kind of the hit.
    HitKind hit_kind() const noexcept { return static_cast<HitKind>(kind); }
    /// The line or curve has a hit.
    bool is_found() const noexcept { return kind != GUSSET_HIT_NONE; }
};
static_assert(sizeof(Hit) == sizeof(gusset_surface_hit) && std::is_standard_layout_v<Hit>, "a hit is what C gives");
/// Hits in memory that belongs to someone else.
using Hits = Values<Hit, gusset_surface_hit>;

/// The hits of lines, or of a curve: a range with the hits of each. It keeps nothing of the
/// surface. Hits and spans live as long as this, and are not lent by a temporary.
class SurfaceHits {
public:
    /// The type of the elements.
    using value_type = Hits;
    /// The type of iterators.
    using iterator = detail::Iterator<SurfaceHits>;

    /// Takes ownership of a handle of the C interface.
    explicit SurfaceHits(gusset_surface_hits *owned) : hits_(owned) {}

    /// The number of lines; 1 for a curve.
    std::size_t size() const { return view().query_count; }
    /// The hits of line `i`, by increasing t; throws an Error if it does not exist.
    Hits operator[](std::size_t i) const & {
        const gusset_surface_hits_view all = view();
        detail::require_element(i, all.query_count, "line");
        const auto from = static_cast<std::size_t>(all.ends[i]);
        return {all.hits + from, static_cast<std::size_t>(all.ends[i + 1]) - from};
    }
    Hits operator[](std::size_t i) const && = delete;
    /// The first element.
    iterator begin() const & { return {this, 0}; }
    iterator begin() const && = delete;
    /// The end of the range.
    iterator end() const & { return {this, size()}; }
    iterator end() const && = delete;

    /// The hits of all lines, one line after the other.
    Hits hits() const & {
        const gusset_surface_hits_view all = view();
        return {all.hits, all.hit_count};
    }
    Hits hits() const && = delete;
    /// For a curve: three places on it for each hit: its own, and the ends of its span.
    Span<const Place> on_curve() const & {
        const gusset_surface_hits_view all = view();
        return {all.on_curve, all.on_curve_count};
    }
    Span<const Place> on_curve() const && = delete;

private:
    gusset_surface_hits_view view() const { return detail::lent(gusset_surface_hits_get_view, hits_.get()); }
    detail::Handle<gusset_surface_hits, gusset_surface_hits_destroy> hits_;
};

inline Places Curve::intersect_line(const Line &line, double within, const Context &context) const {
    return Places(context.result(gusset_curve_intersect_line_create, get(), &line, within));
}

} // namespace gusset

#endif // GUSSET_SURFACE_HITS_HPP
