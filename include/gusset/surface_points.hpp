// Points of surfaces that are nearest to something, and regions of cells. Include gusset.hpp, not this.
#ifndef GUSSET_SURFACE_POINTS_HPP
#define GUSSET_SURFACE_POINTS_HPP

#include <gusset/surface_paths.hpp>

#include <algorithm>

namespace gusset {

/// A point that was found for a query; see gusset_surface_nearest_point.
struct Closest : gusset_surface_nearest_point {
    /// Nothing found.
    Closest() : gusset_surface_nearest_point{} {}
    /// A point as the C interface has it.
    explicit Closest(const gusset_surface_nearest_point &found) : gusset_surface_nearest_point(found) {}
    /// There is one within the limit.
    bool is_found() const noexcept { return (flags & GUSSET_NEAREST_FOUND) != 0; }
    /// Its distance is proved.
    bool is_proven() const noexcept { return (flags & GUSSET_NEAREST_PROVEN) != 0; }
    /// Another point, elsewhere, is as near.
    bool is_one_of_many() const noexcept { return (flags & GUSSET_NEAREST_AMBIGUOUS) != 0; }
};
static_assert(sizeof(Closest) == sizeof(gusset_surface_nearest_point) && std::is_standard_layout_v<Closest>, "nothing added");

/// What is looked for; see gusset_nearest_options.
struct ClosestOptions {
    /// Nothing farther than this; nothing: no limit.
    std::optional<double> limit;
    /// Of minima: as many of the nearest; 0: all.
    std::size_t most = 0;
};

namespace detail {
inline gusset_nearest_options as_c(const ClosestOptions &options) {
    gusset_nearest_options given{};
    given.struct_size = sizeof given;
    given.limit = options.limit.value_or(0.0);
    given.limited = options.limit ? 1 : 0;
    given.most = options.most;
    return given;
}
} // namespace detail

/// Places where the distance is locally least, the nearest first: a range of Closest; see gusset_surface_minima_create. It keeps nothing of the
/// surface. Runs and iterators live as long as this, and are not lent by a temporary.
class SurfacePoints {
public:
    using value_type = Closest;
    /// What the points lie in.
    using Points = Values<Closest, gusset_surface_nearest_point>;
    using iterator = Points::iterator;

    explicit SurfacePoints(gusset_surface_points *owned) : points_(owned) {}

    std::size_t size() const { return parts().count; }
    bool empty() const { return size() == 0; }
    /// The points, the nearest first.
    Points points() const & { return all(); }
    Points points() const && = delete;
    iterator begin() const & { return all().begin(); }
    iterator begin() const && = delete;
    iterator end() const & { return all().end(); }
    iterator end() const && = delete;
    /// Point `i`; throws std::out_of_range.
    Closest operator[](std::size_t i) const {
        const Points found = all();
        if (i >= found.size()) {
            throw std::out_of_range("gusset: no such point");
        }
        return found[i];
    }
    /// None is missing that is nearer than this.
    double bound() const { return parts().bound; }
    /// The search did not give up at that distance.
    bool complete() const { return parts().complete != 0; }

private:
    struct Destroy {
        void operator()(gusset_surface_points *points) const noexcept { gusset_surface_points_destroy(points); }
    };
    Points all() const {
        const gusset_surface_points_view lent = parts();
        return {lent.points, lent.count};
    }
    gusset_surface_points_view parts() const { return detail::lent(gusset_surface_points_get_view, points_.get()); }
    std::unique_ptr<gusset_surface_points, Destroy> points_;
};

/// A cell of a region; see gusset_surface_cell.
using RegionCell = gusset_surface_cell;

/// The cells that come within a radius of a point: a range of RegionCell; see gusset_surface_region_create. It keeps nothing of the surface.
/// Spans and iterators live as long as this, and are not lent by a temporary.
class SurfaceRegion {
public:
    using value_type = RegionCell;
    using iterator = const RegionCell *;

    explicit SurfaceRegion(gusset_surface_region *owned) : region_(owned) {}

    std::size_t size() const { return parts().cell_count; }
    bool empty() const { return size() == 0; }
    /// Cell `i`; throws std::out_of_range.
    RegionCell operator[](std::size_t i) const {
        const gusset_surface_region_view all = parts();
        if (i >= all.cell_count) {
            throw std::out_of_range("gusset: no such cell");
        }
        return all.cells[i];
    }
    iterator begin() const & { return cells().begin(); }
    iterator begin() const && = delete;
    iterator end() const & { return cells().end(); }
    iterator end() const && = delete;
    /// Whether a cell is one of them; false where there is no such cell. O(log cells).
    bool contains(std::size_t sheet, std::size_t row, std::size_t column) const {
        const gusset_surface_region_view all = parts();
        const auto key = [](const RegionCell &cell) { return std::array<std::size_t, 3>{cell.sheet, cell.row, cell.column}; };
        const std::array<std::size_t, 3> sought{sheet, row, column};
        const RegionCell *last = all.cells + all.cell_count;
        const RegionCell *found = std::lower_bound(
            all.cells, last, sought, [&](const RegionCell &cell, const std::array<std::size_t, 3> &other) { return key(cell) < other; });
        return found != last && key(*found) == sought;
    }
    /// By sheet, row, column.
    Span<const RegionCell> cells() const & {
        const gusset_surface_region_view all = parts();
        return {all.cells, all.cell_count};
    }
    Span<const RegionCell> cells() const && = delete;
    /// A bit for each cell of all sheets.
    Span<const uint64_t> mask() const & {
        const gusset_surface_region_view all = parts();
        return {all.mask, all.word_count};
    }
    Span<const uint64_t> mask() const && = delete;
    /// By sheet its first bit; then the number of bits.
    Span<const uint64_t> first() const & {
        const gusset_surface_region_view all = parts();
        return {all.first, all.sheet_count + 1};
    }
    Span<const uint64_t> first() const && = delete;

private:
    struct Destroy {
        void operator()(gusset_surface_region *region) const noexcept { gusset_surface_region_destroy(region); }
    };
    gusset_surface_region_view parts() const { return detail::lent(gusset_surface_region_get_view, region_.get()); }
    std::unique_ptr<gusset_surface_region, Destroy> region_;
};

} // namespace gusset

#endif // GUSSET_SURFACE_POINTS_HPP
