/// @file
/// Nearest points of surfaces, and cells. Include gusset.hpp, not this.
#ifndef GUSSET_SURFACE_POINTS_HPP
#define GUSSET_SURFACE_POINTS_HPP

#include <gusset/context.hpp>
#include <gusset/surface_options.hpp>

#include <algorithm>

namespace gusset {

/// The nearest point to a query; see gusset_surface_nearest_point.
struct NearestPoint : gusset_surface_nearest_point {
    /// No point.
    NearestPoint() : gusset_surface_nearest_point{} {}
    /// A point as the C interface has it.
    explicit NearestPoint(const gusset_surface_nearest_point &found) : gusset_surface_nearest_point(found) {}
    /// A point within the limit exists.
    bool is_found() const noexcept { return (flags & GUSSET_NEAREST_FOUND) != 0; }
    /// No nearer point exists, within the tolerance.
    bool is_proven() const noexcept { return (flags & GUSSET_NEAREST_PROVEN) != 0; }
    /// Another point, elsewhere, is as near.
    bool is_ambiguous() const noexcept { return (flags & GUSSET_NEAREST_AMBIGUOUS) != 0; }
};
static_assert(sizeof(NearestPoint) == sizeof(gusset_surface_nearest_point) && std::is_standard_layout_v<NearestPoint>,
              "a point is what C gives");
/// Nearest points in memory that belongs to someone else.
using NearestPoints = Values<NearestPoint, gusset_surface_nearest_point>;

/// The nearest points of a surface and something else; see gusset_surface_distance.
struct SurfaceDistance : gusset_distance_report {
    /// A distance as the C interface has it.
    explicit SurfaceDistance(const gusset_distance_report &found) : gusset_distance_report(found) {}
    /// No points of the two are nearer, within the tolerance.
    bool is_proven() const noexcept { return (flags & GUSSET_DISTANCE_PROVEN) != 0; }
    /// The two meet.
    bool meets() const noexcept { return (flags & GUSSET_DISTANCE_MEETS) != 0; }
};

/// Local minima of the distance, the nearest first: a range of NearestPoint; see
/// gusset_surface_minima_create. It keeps nothing of the surface. Points and iterators live as long
/// as this, and are not lent by a temporary.
class SurfacePoints {
public:
    /// The type of the elements.
    using value_type = NearestPoint;
    /// The type of iterators.
    using iterator = NearestPoints::iterator;

    /// Takes ownership of a handle of the C interface.
    explicit SurfacePoints(gusset_surface_points *owned) : points_(owned) {}

    /// The number of elements.
    std::size_t size() const { return view().count; }
    /// True if the range has no elements.
    bool empty() const { return size() == 0; }
    /// The points, the nearest first.
    NearestPoints points() const & { return all(); }
    NearestPoints points() const && = delete;
    /// The first element.
    iterator begin() const & { return all().begin(); }
    iterator begin() const && = delete;
    /// The end of the range.
    iterator end() const & { return all().end(); }
    iterator end() const && = delete;
    /// Point `i`; throws an Error if it does not exist.
    NearestPoint operator[](std::size_t i) const {
        const NearestPoints found = all();
        detail::require_element(i, found.size(), "point");
        return found[i];
    }
    /// No minimum nearer than this is missing.
    double bound() const { return view().bound; }
    /// The search was not cut off at that distance.
    bool complete() const { return view().complete != 0; }

private:
    NearestPoints all() const {
        const gusset_surface_points_view found = view();
        return {found.points, found.count};
    }
    gusset_surface_points_view view() const { return detail::lent(gusset_surface_points_get_view, points_.get()); }
    detail::Handle<gusset_surface_points, gusset_surface_points_destroy> points_;
};

/// A cell of a surface; see gusset_surface_cell.
using SurfaceCell = gusset_surface_cell;

/// Cells of a surface: a range of SurfaceCell; see gusset_surface_cells_view. The cells are those
/// within a radius of a point, or the first cells of pairs. It keeps nothing of the surface. Spans and
/// iterators live as long as this, and are not lent by a temporary.
class SurfaceCells {
public:
    /// The type of the elements.
    using value_type = SurfaceCell;
    /// The type of iterators.
    using iterator = const SurfaceCell *;

    /// Takes ownership of a handle of the C interface.
    explicit SurfaceCells(gusset_surface_cells *owned) : cells_(owned) {}

    /// The number of elements.
    std::size_t size() const { return view().cell_count; }
    /// True if the range has no elements.
    bool empty() const { return size() == 0; }
    /// Cell `i`; throws an Error if it does not exist.
    SurfaceCell operator[](std::size_t i) const {
        const gusset_surface_cells_view all = view();
        detail::require_element(i, all.cell_count, "cell");
        return all.cells[i];
    }
    /// The first element.
    iterator begin() const & { return cells().begin(); }
    iterator begin() const && = delete;
    /// The end of the range.
    iterator end() const & { return cells().end(); }
    iterator end() const && = delete;
    /// For a region: true if a cell is one of them; false for a cell that does not exist. O(log cells).
    bool contains(std::size_t sheet, std::size_t row, std::size_t column) const {
        const gusset_surface_cells_view all = view();
        using Key = std::array<std::size_t, 3>;
        const auto key = [](const SurfaceCell &cell) { return Key{cell.sheet, cell.row, cell.column}; };
        const Key sought{sheet, row, column};
        const SurfaceCell *last = all.cells + all.cell_count;
        const SurfaceCell *found = std::lower_bound(
            all.cells, last, sought, [&](const SurfaceCell &cell, const Key &other) { return key(cell) < other; });
        return found != last && key(*found) == sought;
    }
    /// By sheet, row, column.
    Span<const SurfaceCell> cells() const & {
        const gusset_surface_cells_view all = view();
        return {all.cells, all.cell_count};
    }
    Span<const SurfaceCell> cells() const && = delete;
    /// For pairs: the cells of the second surface; else empty.
    Span<const SurfaceCell> others() const & {
        const gusset_surface_cells_view all = view();
        return {all.others, all.others != nullptr ? all.cell_count : 0};
    }
    Span<const SurfaceCell> others() const && = delete;
    /// For a region, by cell: 1 if all of the cell is within the radius; else empty.
    Span<const uint32_t> whole() const & {
        const gusset_surface_cells_view all = view();
        return {all.whole, all.whole != nullptr ? all.cell_count : 0};
    }
    Span<const uint32_t> whole() const && = delete;
    /// For a region: a bit for each cell of all sheets.
    Span<const uint64_t> mask() const & {
        const gusset_surface_cells_view all = view();
        return {all.mask, all.word_count};
    }
    Span<const uint64_t> mask() const && = delete;
    /// For a region: the first bit of each sheet, then the number of bits.
    Span<const uint64_t> first() const & {
        const gusset_surface_cells_view all = view();
        return {all.first, all.first != nullptr ? all.sheet_count + 1 : 0};
    }
    Span<const uint64_t> first() const && = delete;

private:
    gusset_surface_cells_view view() const { return detail::lent(gusset_surface_cells_get_view, cells_.get()); }
    detail::Handle<gusset_surface_cells, gusset_surface_cells_destroy> cells_;
};

} // namespace gusset

#endif // GUSSET_SURFACE_POINTS_HPP
