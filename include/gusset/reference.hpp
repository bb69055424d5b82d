/// @file
/// The paper's search on the logical scale, kept as a reference. Include gusset.hpp, not this.
#ifndef GUSSET_REFERENCE_HPP
#define GUSSET_REFERENCE_HPP

#include <gusset/curve.hpp>

#include <cstring>

namespace gusset {

class Surface;

/// The object that the paper's search looks for; see gusset_reference_task.
struct ReferenceTask : gusset_reference_task {
    /// The points near a point.
    static ReferenceTask at(const Point3 &place) { return {GUSSET_REFERENCE_POINT, place, {}}; }
    /// The points near a plane.
    static ReferenceTask plane(const Point3 &place, const Point3 &normal) {
        return {GUSSET_REFERENCE_PLANE, place, normal};
    }
    /// The points near a line.
    static ReferenceTask line(const Point3 &place, const Point3 &along) {
        return {GUSSET_REFERENCE_LINE, place, along};
    }
    /// The points near a segment, from a place to its sum with `along`.
    static ReferenceTask segment(const Point3 &place, const Point3 &along) {
        return {GUSSET_REFERENCE_SEGMENT, place, along};
    }
    /// The points near a ray.
    static ReferenceTask ray(const Point3 &place, const Point3 &along) { return {GUSSET_REFERENCE_RAY, place, along}; }
    /// The points near a curve, which must live as long as the task.
    static ReferenceTask curve_of(const Curve &other) {
        ReferenceTask made(GUSSET_REFERENCE_CURVE, {}, {});
        made.curve = other.get();
        return made;
    }
    /// The points near a surface, which must live as long as the task.
    static ReferenceTask surface_of(const Surface &other);
    /// Normals at an angle to a direction. `bound`: of the principal curvatures; 0: cones of
    /// normals instead.
    static ReferenceTask angle_to(const Point3 &along, double radians, bool unsigned_normal = false,
                                  double bound = 0.0) {
        ReferenceTask made(GUSSET_REFERENCE_ANGLE, {}, along);
        made.angle = radians;
        made.unsigned_normals = unsigned_normal ? 1 : 0;
        made.curvature = bound;
        return made;
    }
    /// Cells that may hold such a point within a distance, or within an angle.
    ReferenceTask up_to(double distance) const {
        ReferenceTask made = *this;
        made.within = distance;
        made.find_nearest = 0;
        return made;
    }
    /// Cells that may hold the nearest: the default.
    ReferenceTask nearest() const {
        ReferenceTask made = *this;
        made.find_nearest = 1;
        return made;
    }

private:
    ReferenceTask(gusset_reference_object kind, const Point3 &place, const Point3 &along) : gusset_reference_task{} {
        struct_size = sizeof(gusset_reference_task);
        object = kind;
        find_nearest = 1;
        std::memcpy(point, place.data(), sizeof point);
        std::memcpy(direction, along.data(), sizeof direction);
    }
};
static_assert(sizeof(ReferenceTask) == sizeof(gusset_reference_task), "a task is what C takes");

/// A bit for each cell of a sheet: the paper's logical scale.
class CellMask {
public:
    /// All cells of a number of rows and columns.
    static CellMask all(std::size_t rows, std::size_t columns) { return {rows, columns, ~uint64_t{0}}; }
    /// No cell of a number of rows and columns.
    static CellMask none(std::size_t rows, std::size_t columns) { return {rows, columns, 0}; }
    /// Bit k % 64 of word k / 64 belongs to cell (i, j), k = i * columns + j. Words and bits beyond
    /// the last cell are dropped.
    static CellMask from_words(std::size_t rows, std::size_t columns, std::vector<uint64_t> words) {
        CellMask made(rows, columns);
        const std::size_t needed = word_count(rows, columns);
        if (words.size() < needed) {
            detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "fewer words than the cells need");
        }
        words.resize(needed);
        made.words_ = std::move(words);
        made.clear_padding();
        return made;
    }

    /// Rows of cells.
    std::size_t rows() const noexcept { return rows_; }
    /// Columns of cells.
    std::size_t columns() const noexcept { return columns_; }
    /// The bits, valid as long as the mask, and not lent by a temporary.
    Span<const uint64_t> words() const & { return words_; }
    Span<const uint64_t> words() const && = delete;
    /// True if a cell is marked.
    bool operator()(std::size_t row, std::size_t column) const {
        const std::size_t bit = row * columns_ + column;
        return (words_[bit / 64] >> (bit % 64) & 1) != 0;
    }
    /// Marks a cell, or clears it.
    void set(std::size_t row, std::size_t column, bool on) {
        const std::size_t bit = row * columns_ + column;
        const uint64_t mask = uint64_t{1} << (bit % 64);
        words_[bit / 64] = on ? words_[bit / 64] | mask : words_[bit / 64] & ~mask;
    }
    /// The number of marked cells.
    std::size_t count() const {
        std::size_t found = 0;
        for (uint64_t word : words_) {
            for (; word != 0; word &= word - 1) {
                ++found;
            }
        }
        return found;
    }

private:
    CellMask(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns) {}
    CellMask(std::size_t rows, std::size_t columns, uint64_t word)
        : rows_(rows), columns_(columns), words_(word_count(rows, columns), word) {
        clear_padding();
    }
    static std::size_t word_count(std::size_t rows, std::size_t columns) {
        if (columns != 0 && rows > (~std::size_t{0} - 63) / columns) {
            detail::refuse(GUSSET_ERROR_TOO_LARGE, "too many cells");
        }
        return (rows * columns + 63) / 64;
    }
    /// Clears the bits of the last word beyond the last cell.
    void clear_padding() {
        if (const std::size_t used = rows_ * columns_ % 64; used != 0) {
            words_.back() &= (uint64_t{1} << used) - 1;
        }
    }
    std::size_t rows_, columns_;
    std::vector<uint64_t> words_;
};

/// The cells that the paper's search keeps, and its report.
struct ReferenceMask {
    /// The cells kept.
    CellMask mask;
    /// The report on the search.
    gusset_reference_report report;
};

/// The arcs of a curve that may hold the object of a task, by the paper's search over its points:
/// one row, `parts` arcs a segment. No arc that does is missing.
inline ReferenceMask reference_mask(const Curve &curve, std::size_t parts, const ReferenceTask &task,
                                    const Context &context = Context()) {
    const std::size_t arcs = curve.segment_count() * parts;
    std::vector<uint64_t> words((arcs + 63) / 64);
    std::size_t written = 0;
    auto found = detail::sized<gusset_reference_report>();
    context.call(gusset_curve_reference_mask, curve.get(), parts, &task, words.data(), words.size(), &written, &found);
    return {CellMask::from_words(1, arcs, std::move(words)), found};
}

} // namespace gusset

#endif // GUSSET_REFERENCE_HPP
