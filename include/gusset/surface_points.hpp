// Points of surfaces that are nearest to something, and regions of cells. Include gusset.hpp, not this.
#ifndef GUSSET_SURFACE_POINTS_HPP
#define GUSSET_SURFACE_POINTS_HPP

#include <gusset/surface_paths.hpp>

namespace gusset {

/// A point that was found for a query; see gusset_surface_closest.
struct Closest : gusset_surface_closest {
    /// There is one within the limit.
    bool is_found() const noexcept { return (flags & GUSSET_SURFACE_CLOSEST_FOUND) != 0; }
    /// Its distance is proved.
    bool is_proven() const noexcept { return (flags & GUSSET_SURFACE_CLOSEST_PROVEN) != 0; }
    /// Another point, elsewhere, is as near.
    bool is_one_of_many() const noexcept { return (flags & GUSSET_SURFACE_CLOSEST_MANY) != 0; }
};
static_assert(sizeof(Closest) == sizeof(gusset_surface_closest), "nothing added");

/// What is looked for; see gusset_closest_options.
struct ClosestOptions {
    /// Nothing farther than this; nothing: no limit.
    std::optional<double> limit;
    /// Of minima: as many of the nearest; 0: all.
    std::size_t most = 0;
};

namespace detail {
inline gusset_closest_options as_c(const ClosestOptions &options) {
    gusset_closest_options given{};
    given.struct_size = sizeof given;
    given.limit = options.limit.value_or(0.0);
    given.limited = options.limit ? 1 : 0;
    given.most = options.most;
    return given;
}
} // namespace detail

/// Places where the distance is locally least, the nearest first; see gusset_carcass_minima. It keeps nothing of the surface; spans
/// live as long as this.
class SurfacePoints {
public:
    explicit SurfacePoints(gusset_surface_points *owned) : points_(owned) {}

    std::size_t size() const { return parts().count; }
    Span<const Closest> points() const {
        const gusset_surface_points_parts all = parts();
        return {static_cast<const Closest *>(all.points), all.count};
    }
    const Closest *begin() const { return points().begin(); }
    const Closest *end() const { return points().end(); }
    /// Point `i` < size().
    const Closest &operator[](std::size_t i) const { return points()[i]; }
    /// None is missing that is nearer than this.
    double bound() const { return parts().bound; }
    /// The search did not give up at that distance.
    bool complete() const { return parts().complete != 0; }

private:
    struct Destroy {
        void operator()(gusset_surface_points *points) const noexcept { gusset_surface_points_destroy(points); }
    };
    gusset_surface_points_parts parts() const { return detail::lent(gusset_surface_points_view, points_.get()); }
    std::unique_ptr<gusset_surface_points, Destroy> points_;
};

/// A cell of a region; see gusset_surface_cell.
using RegionCell = gusset_surface_cell;

/// The cells that come within a radius of a point; see gusset_carcass_region. It keeps nothing of the surface; spans live as long as
/// this.
class SurfaceRegion {
public:
    explicit SurfaceRegion(gusset_surface_region *owned) : region_(owned) {}

    std::size_t size() const { return parts().cell_count; }
    /// By sheet, row, column.
    Span<const RegionCell> cells() const {
        const gusset_surface_region_parts all = parts();
        return {all.cells, all.cell_count};
    }
    /// A bit for each cell of all sheets.
    Span<const uint64_t> mask() const {
        const gusset_surface_region_parts all = parts();
        return {all.mask, all.word_count};
    }
    /// By sheet its first bit; then the number of bits.
    Span<const uint64_t> first() const {
        const gusset_surface_region_parts all = parts();
        return {all.first, all.sheet_count + 1};
    }

private:
    struct Destroy {
        void operator()(gusset_surface_region *region) const noexcept { gusset_surface_region_destroy(region); }
    };
    gusset_surface_region_parts parts() const { return detail::lent(gusset_surface_region_view, region_.get()); }
    std::unique_ptr<gusset_surface_region, Destroy> region_;
};

} // namespace gusset

#endif // GUSSET_SURFACE_POINTS_HPP
