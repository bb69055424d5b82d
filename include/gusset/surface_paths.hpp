// Places on surfaces, and curves of them. Include gusset.hpp, not this.
#ifndef GUSSET_SURFACE_PATHS_HPP
#define GUSSET_SURFACE_PATHS_HPP

#include <gusset/curve.hpp>

namespace gusset {

/// A place on a surface; see gusset_surface_place.
using SurfacePlace = gusset_surface_place;
/// The place with the parameters u and v, 0 to 1, in a cell.
inline SurfacePlace surface_place(uint32_t sheet, uint32_t row, uint32_t column, double u = 0.5, double v = 0.5) {
    return {sheet, row, column, 0, u, v};
}

namespace detail {
/// What a view function lends: `function(handle, &parts)`.
template <class Parts, class Handle>
Parts lent(gusset_status (*function)(const Handle *, Parts *), const Handle *handle) {
    Parts parts{};
    parts.struct_size = sizeof parts;
    check(function(handle, &parts));
    return parts;
}
/// Elements of any range, by their number; random access is by operator[] of the range.
template <class Range>
class Iterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = typename Range::value_type;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = value_type;
    Iterator() = default;
    Iterator(const Range *range, std::size_t i) : range_(range), i_(i) {}
    value_type operator*() const { return (*range_)[i_]; }
    Iterator &operator++() {
        ++i_;
        return *this;
    }
    Iterator operator++(int) {
        Iterator old = *this;
        ++i_;
        return old;
    }
    friend bool operator==(const Iterator &a, const Iterator &b) { return a.i_ == b.i_; }
    friend bool operator!=(const Iterator &a, const Iterator &b) { return a.i_ != b.i_; }

private:
    const Range *range_ = nullptr;
    std::size_t i_ = 0;
};
} // namespace detail

/// A run of C structures in somebody else's memory, each read as a Wrapper that is made of it, by value. Elements stay when the run is
/// gone; its iterators stay as long as the memory.
template <class Wrapper, class Data>
class Values {
public:
    using value_type = Wrapper;
    class iterator {
        struct Arrow {
            Wrapper value;
            const Wrapper *operator->() const noexcept { return &value; }
        };

    public:
        using iterator_category = std::input_iterator_tag;
        using value_type = Wrapper;
        using difference_type = std::ptrdiff_t;
        using pointer = Arrow;
        using reference = Wrapper;
        iterator() = default;
        explicit iterator(const Data *at) : at_(at) {}
        Wrapper operator*() const { return Wrapper(*at_); }
        Arrow operator->() const { return {Wrapper(*at_)}; }
        iterator &operator++() {
            ++at_;
            return *this;
        }
        iterator operator++(int) {
            iterator old = *this;
            ++at_;
            return old;
        }
        friend bool operator==(const iterator &a, const iterator &b) { return a.at_ == b.at_; }
        friend bool operator!=(const iterator &a, const iterator &b) { return a.at_ != b.at_; }

    private:
        const Data *at_ = nullptr;
    };

    /// No elements.
    Values() = default;
    /// `size` elements from `data` on.
    Values(const Data *data, std::size_t size) : data_(data, size) {}

    /// The structures themselves.
    const Data *data() const noexcept { return data_.data(); }
    std::size_t size() const noexcept { return data_.size(); }
    bool empty() const noexcept { return data_.empty(); }
    /// Element `i` < size().
    Wrapper operator[](std::size_t i) const { return Wrapper(data_[i]); }
    iterator begin() const { return iterator(data_.begin()); }
    iterator end() const { return iterator(data_.end()); }

private:
    Span<const Data> data_;
};

/// One curve on a surface. Spans live as long as the paths it is of.
struct SurfacePath {
    /// The points.
    Span<const Point3> points;
    /// Unit normals of the surface; 0 where there is none.
    Span<const Point3> normals;
    /// Where they are on the surface.
    Span<const SurfacePlace> places;
    /// Of intersections: the places on the second surface.
    Span<const SurfacePlace> others;
    /// It returns to its first point, which is not repeated.
    bool closed;
    /// The number of the plane, level or angle that it belongs to.
    uint32_t level;

    std::size_t size() const noexcept { return points.size(); }
};

/// Curves on a surface; a range of SurfacePath. It keeps nothing of the surface. See gusset_surface_paths_view. What has spans is not
/// lent by a temporary, which is gone before they are read.
class SurfacePaths {
public:
    using value_type = SurfacePath;
    using iterator = detail::Iterator<SurfacePaths>;

    explicit SurfacePaths(gusset_surface_paths *owned) : paths_(owned) {}

    std::size_t size() const { return parts().path_count; }
    bool empty() const { return size() == 0; }
    /// Path `i`; throws std::out_of_range.
    SurfacePath operator[](std::size_t i) const & {
        const gusset_surface_paths_view all = parts();
        if (i >= all.path_count) {
            throw std::out_of_range("gusset: no such path");
        }
        const std::size_t from = all.ends.data[i], count = all.ends.data[i + 1] - from;
        return {{detail::points(all.points, all.point_count).data() + from, count},
                {detail::points(all.normals, all.point_count).data() + from, count},
                {all.places + from, count},
                {all.others != nullptr ? all.others + from : nullptr, all.others != nullptr ? count : 0},
                all.closed[i] != 0,
                all.levels[i]};
    }
    SurfacePath operator[](std::size_t i) const && = delete;
    iterator begin() const & { return {this, 0}; }
    iterator begin() const && = delete;
    iterator end() const & { return {this, size()}; }
    iterator end() const && = delete;

    /// The points of all paths, one path after the other.
    Span<const Point3> points() const & {
        const gusset_surface_paths_view all = parts();
        return detail::points(all.points, all.point_count);
    }
    Span<const Point3> points() const && = delete;
    /// Cells in which something may be that could not be resolved.
    Span<const SurfacePlace> unresolved() const & {
        const gusset_surface_paths_view all = parts();
        return {all.unresolved, all.unresolved_count};
    }
    Span<const SurfacePlace> unresolved() const && = delete;

private:
    struct Destroy {
        void operator()(gusset_surface_paths *paths) const noexcept { gusset_surface_paths_destroy(paths); }
    };
    gusset_surface_paths_view parts() const { return detail::lent(gusset_surface_paths_get_view, paths_.get()); }
    std::unique_ptr<gusset_surface_paths, Destroy> paths_;
};

} // namespace gusset

#endif // GUSSET_SURFACE_PATHS_HPP
