/// @file
/// Places on surfaces, and curves of them. Include gusset.hpp, not this.
#ifndef GUSSET_SURFACE_PATHS_HPP
#define GUSSET_SURFACE_PATHS_HPP

#include <gusset/context.hpp>

namespace gusset {

/// A place on a surface; see gusset_surface_place.
using SurfacePlace = gusset_surface_place;
/// A point where two surfaces touch; see gusset_surface_contact.
using SurfaceContact = gusset_surface_contact;
/// The place with the parameters u and v, 0 to 1, in a cell.
inline SurfacePlace surface_place(uint32_t sheet, uint32_t row, uint32_t column, double u = 0.5, double v = 0.5) {
    return {sheet, row, column, 0, u, v};
}

/// One curve on a surface. Spans live as long as the paths it is of.
struct SurfacePath {
    /// The points.
    Points points;
    /// Unit normals of the surface; 0 where it has none.
    Points normals;
    /// Their places on the surface.
    Span<const SurfacePlace> places;
    /// For intersections: the places on the second surface.
    Span<const SurfacePlace> others;
    /// The path returns to its first point, which is not repeated.
    bool closed;
    /// The index of its plane, level or angle.
    uint32_t level;

    /// The number of elements.
    std::size_t size() const noexcept { return points.size(); }
};

/// Curves on a surface: a range of SurfacePath; see gusset_surface_paths_view. It keeps nothing of
/// the surface. Spans live as long as this, and are not lent by a temporary.
class SurfacePaths {
public:
    /// The type of the elements.
    using value_type = SurfacePath;
    /// The type of iterators.
    using iterator = detail::Iterator<SurfacePaths>;

    /// Takes ownership of a handle of the C interface.
    explicit SurfacePaths(gusset_surface_paths *owned) : paths_(owned) {}

    /// The number of elements.
    std::size_t size() const { return view().path_count; }
    /// True if the range has no elements.
    bool empty() const { return size() == 0; }
    /// Path `i`; throws an Error if it does not exist.
    SurfacePath operator[](std::size_t i) const & {
        const gusset_surface_paths_view all = view();
        detail::require_element(i, all.path_count, "path");
        const std::size_t from = all.ends.data[i], count = all.ends.data[i + 1] - from;
        return {detail::points(all.points + 3 * from, count),
                detail::points(all.normals + 3 * from, count),
                {all.places + from, count},
                {all.others != nullptr ? all.others + from : nullptr, all.others != nullptr ? count : 0},
                all.closed[i] != 0,
                all.levels[i]};
    }
    SurfacePath operator[](std::size_t i) const && = delete;
    /// The first element.
    iterator begin() const & { return {this, 0}; }
    iterator begin() const && = delete;
    /// The end of the range.
    iterator end() const & { return {this, size()}; }
    iterator end() const && = delete;

    /// The points of all paths, one path after the other.
    Points points() const & {
        const gusset_surface_paths_view all = view();
        return detail::points(all.points, all.point_count);
    }
    Points points() const && = delete;
    /// Cells that may hold more of the curves and could not be resolved.
    Span<const SurfacePlace> unresolved() const & {
        const gusset_surface_paths_view all = view();
        return {all.unresolved, all.unresolved_count};
    }
    Span<const SurfacePlace> unresolved() const && = delete;
    /// For intersections: points where they touch, and where branches cross.
    Span<const SurfaceContact> contacts() const & {
        const gusset_surface_paths_view all = view();
        return {all.contacts, all.contact_count};
    }
    Span<const SurfaceContact> contacts() const && = delete;

private:
    gusset_surface_paths_view view() const { return detail::lent(gusset_surface_paths_get_view, paths_.get()); }
    detail::Handle<gusset_surface_paths, gusset_surface_paths_destroy> paths_;
};

} // namespace gusset

#endif // GUSSET_SURFACE_PATHS_HPP
