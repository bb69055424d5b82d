// What sheets are made of: nodes, tangents, splines, and how. Include gusset.hpp, not this.
#ifndef GUSSET_SHEET_TYPES_HPP
#define GUSSET_SHEET_TYPES_HPP

#include <gusset/frame.hpp>
#include <gusset/net_types.hpp>
#include <gusset/surface_paths.hpp>

namespace gusset {

/// How mixed derivatives at nodes are found; see the constants.
enum class Twists : uint32_t {
    differences = GUSSET_TWISTS_DIFFERENCES,
    adini = GUSSET_TWISTS_ADINI,
    zero = GUSSET_TWISTS_ZERO
};
/// Which surface of a frame.
enum class FrameSurface : uint32_t { nodes = GUSSET_FRAME_NODES, curves = GUSSET_FRAME_CURVES };
/// Which coordinate runs along a curve of a sheet.
enum class Along : uint32_t { rows = GUSSET_ALONG_ROWS, columns = GUSSET_ALONG_COLUMNS };

/// How nodes become a surface. A direction that is closed ends with its first line again.
struct SheetOptions {
    /// Closed along columns: the last row is the first one again.
    bool closed_u = false;
    /// Closed along rows.
    bool closed_v = false;
    /// How the surface is drawn through nodes.
    Scheme scheme = Scheme::six_tap;
};

/// Nodes in somebody else's memory, which must outlive the calls they are given to; see gusset_nodes.
class NodesView {
public:
    /// Row after row: any container that keeps its elements side by side, whose first bytes are three floats or doubles.
    template <class Points>
    NodesView(std::size_t rows, std::size_t columns, const Points &points, const SheetOptions &options = {}) {
        using Point = std::remove_cv_t<std::remove_reference_t<decltype(*std::data(points))>>;
        using T = std::decay_t<decltype(std::declval<const Point &>()[0])>;
        static_assert(sizeof(Point) >= 3 * sizeof(T), "three coordinates");
        if (columns != 0 && (rows > std::size(points) / columns || rows * columns != std::size(points))) {
            throw std::invalid_argument("gusset: the number of points is not rows * columns");
        }
        fill<T>(rows, columns, std::data(points), options);
        nodes_.column_stride = sizeof(Point);
    }
    /// x, y, z of node (i, j) are at first + i * row_stride + j * column_stride, in numbers; 0: no gaps.
    template <class T>
    static NodesView strided(std::size_t rows, std::size_t columns, const T *first, std::size_t row_stride,
                             std::size_t column_stride, const SheetOptions &options = {}) {
        NodesView view;
        view.fill<T>(rows, columns, first, options);
        view.nodes_.row_stride = detail::stride_in_bytes<T>(row_stride);
        view.nodes_.column_stride = detail::stride_in_bytes<T>(column_stride);
        return view;
    }
    const gusset_nodes &get() const noexcept { return nodes_; }

private:
    NodesView() = default;
    template <class T>
    void fill(std::size_t rows, std::size_t columns, const void *first, const SheetOptions &options) {
        static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>, "nodes of float or double");
        nodes_.struct_size = sizeof nodes_;
        nodes_.nodes = first;
        nodes_.rows = rows;
        nodes_.columns = columns;
        nodes_.scalar = std::is_same_v<T, float> ? GUSSET_F32 : GUSSET_F64;
        nodes_.scheme = static_cast<gusset_scheme>(options.scheme);
        nodes_.closed_u = options.closed_u ? 1 : 0;
        nodes_.closed_v = options.closed_v ? 1 : 0;
    }
    gusset_nodes nodes_{};
};

/// A direction of a B-spline; see gusset_spline.
struct SplineAxis {
    /// Control points.
    std::size_t count;
    /// 1 to 7.
    uint32_t degree;
    /// The knots; see gusset_spline.
    Span<const double> knots;
    /// Whether the direction is closed.
    bool closed = false;
};

/// A net of curves; see gusset_curve_net. The curves must outlive the call that this is given to.
struct CurveNet {
    /// Curves in v, one after the other in u; or none.
    Span<const Curve> rows;
    /// Curves in u, one after the other in v; or none.
    Span<const Curve> columns;
    /// How far apart curves may be where they meet; 0: 1e-6 of the diagonal of their box.
    double tolerance = 0.0;
    bool closed_u = false;
    bool closed_v = false;
};

/// Numbers for each cell, row after row; see gusset_sheet_estimates.
struct SheetEstimates {
    /// How far the surface may be from the smooth one that nodes were taken from: an estimate.
    std::vector<double> errors;
    /// How far it is at most from the bilinear patches of its cells.
    std::vector<double> bilinear;
    /// And from the triangles.
    std::vector<double> triangles;
};

/// Bounds of the diameters of cells, row after row; see gusset_sheet_diameters.
struct CellDiameters {
    /// Of each cell a bound of the distance between two of its points, and of the way within the cell.
    std::vector<double> euclidean, intrinsic;
    /// The greatest of each.
    double greatest_euclidean, greatest_intrinsic;
};

/// What the paper's search looks for, and how; see gusset_reference_task.
struct MaskTask : gusset_reference_task {
    /// A point. It is kept in the field `point`.
    static MaskTask at(const Point3 &place) { return {GUSSET_REFERENCE_POINT, place, {}}; }
    /// What is near a plane.
    static MaskTask plane(const Point3 &place, const Point3 &normal) { return {GUSSET_REFERENCE_PLANE, place, normal}; }
    /// What is near a line.
    static MaskTask line(const Point3 &place, const Point3 &along) { return {GUSSET_REFERENCE_LINE, place, along}; }
    /// From a place to the place and the direction.
    static MaskTask segment(const Point3 &place, const Point3 &along) { return {GUSSET_REFERENCE_SEGMENT, place, along}; }
    /// Normals at an angle to a direction. bound: of the principal curvatures; 0: cones of normals instead.
    static MaskTask slant(const Point3 &along, double radians, bool unsigned_normal = false, double bound = 0.0) {
        MaskTask made(GUSSET_REFERENCE_ANGLE, {}, along);
        made.angle = radians;
        made.unsigned_normals = unsigned_normal ? 1 : 0;
        made.curvature = bound;
        return made;
    }
    /// Cells that may have something within a distance, or within an angle.
    MaskTask up_to(double distance) const {
        MaskTask made = *this;
        made.within = distance;
        made.least = 0;
        return made;
    }
    /// Cells that may have the nearest: what is looked for unless up_to is called.
    MaskTask nearest() const {
        MaskTask made = *this;
        made.least = 1;
        return made;
    }

private:
    MaskTask(gusset_reference_object kind, const Point3 &place, const Point3 &along) : gusset_reference_task{} {
        struct_size = sizeof(gusset_reference_task);
        object = kind;
        least = 1;
        std::memcpy(point, place.data(), sizeof point);
        std::memcpy(direction, along.data(), sizeof direction);
    }
};
static_assert(sizeof(MaskTask) == sizeof(gusset_reference_task), "nothing added");

/// A bit for each cell of a sheet: the paper's logical scale. Made by name: all, none, from_words.
class CellMask {
public:
    /// All cells of so many rows and columns.
    static CellMask all(std::size_t rows, std::size_t columns) { return {rows, columns, ~uint64_t{0}}; }
    /// None of them.
    static CellMask none(std::size_t rows, std::size_t columns) { return {rows, columns, 0}; }
    /// Bit k % 64 of word k / 64 is that of cell (i, j), k = i * columns + j. Words and bits beyond the last cell are left out.
    static CellMask from_words(std::size_t rows, std::size_t columns, std::vector<uint64_t> words) {
        CellMask made(rows, columns);
        const std::size_t needed = word_count(rows, columns);
        if (words.size() < needed) {
            throw std::invalid_argument("gusset: fewer words than the cells need");
        }
        words.resize(needed);
        made.words_ = std::move(words);
        made.cut();
        return made;
    }

    /// Rows of cells.
    std::size_t rows() const noexcept { return rows_; }
    /// Columns of cells.
    std::size_t columns() const noexcept { return columns_; }
    /// They live as long as the mask, and are not lent by a temporary.
    Span<const uint64_t> words() const & { return words_; }
    Span<const uint64_t> words() const && = delete;
    /// Whether a cell is in.
    bool operator()(std::size_t row, std::size_t column) const {
        const std::size_t bit = row * columns_ + column;
        return (words_[bit / 64] >> (bit % 64) & 1) != 0;
    }
    /// Puts a cell in, or takes it out.
    void set(std::size_t row, std::size_t column, bool on) {
        const std::size_t bit = row * columns_ + column;
        const uint64_t mask = uint64_t{1} << (bit % 64);
        words_[bit / 64] = on ? words_[bit / 64] | mask : words_[bit / 64] & ~mask;
    }
    /// How many cells are in.
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
        cut();
    }
    static std::size_t word_count(std::size_t rows, std::size_t columns) {
        if (columns != 0 && rows > (~std::size_t{0} - 63) / columns) {
            throw std::length_error("gusset: too many cells");
        }
        return (rows * columns + 63) / 64;
    }
    /// Clears the bits of the last word that are no cell's.
    void cut() {
        if (const std::size_t used = rows_ * columns_ % 64; used != 0) {
            words_.back() &= (uint64_t{1} << used) - 1;
        }
    }
    std::size_t rows_, columns_;
    std::vector<uint64_t> words_;
};

/// The cells that the paper's search left, and what it did.
struct Masked {
    /// The cells that are left.
    CellMask mask;
    /// What the search did.
    gusset_reference_report report;
};

} // namespace gusset

#endif // GUSSET_SHEET_TYPES_HPP
