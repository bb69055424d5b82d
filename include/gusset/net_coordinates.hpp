/// @file
/// Coordinates of nets. Include gusset.hpp, not this.
#ifndef GUSSET_NET_COORDINATES_HPP
#define GUSSET_NET_COORDINATES_HPP

#include <gusset/context.hpp>

namespace gusset {

/// One coordinate of all nodes of a net, in memory that belongs to someone else.
template <class T>
class MatrixView {
public:
    /// rows x columns numbers, `stride` of them from row to row.
    MatrixView(T *data, std::size_t rows, std::size_t columns, std::size_t stride)
        : data_(data), rows_(rows), columns_(columns), stride_(stride) {}

    /// The rows of nodes.
    std::size_t rows() const noexcept { return rows_; }
    /// The columns of nodes.
    std::size_t columns() const noexcept { return columns_; }
    /// Numbers from row to row.
    std::size_t stride() const noexcept { return stride_; }
    /// The first element.
    T *data() const noexcept { return data_; }
    /// Row `i`.
    Span<T> row(std::size_t i) const { return {data_ + i * stride_, columns_}; }
    /// Number (i, j).
    T &operator()(std::size_t i, std::size_t j) const { return data_[i * stride_ + j]; }

private:
    T *data_;
    std::size_t rows_, columns_, stride_;
};

/// The coordinates of a net.
template <class T>
struct NetCoordinates {
    /// The first coordinates.
    MatrixView<T> x;
    /// The second coordinates.
    MatrixView<T> y;
    /// The third coordinates.
    MatrixView<T> z;
};

/// The unit normals of all nodes, row after row.
template <class T>
struct NetNormals {
    /// The first coordinates of the normals, row after row.
    std::vector<T> x;
    /// The second coordinates.
    std::vector<T> y;
    /// The third coordinates.
    std::vector<T> z;
    /// The number of nodes without a normal, which get zeros.
    uint64_t missing_count = 0;
};

/// Heights over a grid; see gusset_heights.
struct HeightOptions {
    /// x from column to column, y from row to row.
    std::array<double, 2> spacing{1.0, 1.0};
    /// The position of the first node at height 0.
    Point3 origin{};
    /// The number that marks a missing height.
    std::optional<double> no_data;
    /// Numbers from row to row; 0: rows without gaps.
    std::size_t row_stride = 0;
};

namespace detail {
template <class T>
inline constexpr uint32_t scalar_of = std::is_same_v<std::remove_const_t<T>, double> ? GUSSET_F64 : GUSSET_F32;

/// Three matrices of coordinates as C takes them.
template <class T>
gusset_net_view net_view(std::size_t rows, std::size_t columns, const T *x, const T *y, const T *z,
                         std::size_t row_stride = 0) {
    static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>, "coordinates of float or double");
    auto view = sized<gusset_net_view>();
    view.rows = rows;
    view.columns = columns;
    // Only a net in the caller's memory and gusset_net_read write there; both get writable memory.
    view.x = const_cast<T *>(x);
    view.y = const_cast<T *>(y);
    view.z = const_cast<T *>(z);
    view.row_stride = stride_in_bytes<T>(row_stride);
    view.scalar = scalar_of<T>;
    return view;
}
/// A container of points, row after row, as C takes it.
template <class Container>
gusset_net_view net_view(std::size_t rows, std::size_t columns, const Container &points) {
    using Point = std::remove_cv_t<std::remove_reference_t<decltype(*std::data(points))>>;
    using T = typename PointTraits3<Point>::Scalar;
    if (columns != 0 && (rows > std::size(points) / columns || rows * columns != std::size(points))) {
        detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "the number of points is not rows * columns");
    }
    const T *data = reinterpret_cast<const T *>(std::data(points));
    gusset_net_view view = net_view(rows, columns, data, data + 1, data + 2);
    view.column_stride = sizeof(Point);
    return view;
}
template <class T>
void require_scalar(const gusset_net_view &view) {
    if (view.scalar != scalar_of<T>) {
        detail::refuse(GUSSET_ERROR_UNKNOWN_VALUE, "the net has coordinates of the other type");
    }
}
/// The matrices of a view, whose coordinates must be of T.
template <class T>
NetCoordinates<T> matrices(const gusset_net_view &view) {
    require_scalar<T>(view);
    const auto matrix = [&](void *data) {
        return MatrixView<T>(static_cast<T *>(data), view.rows, view.columns, view.row_stride / sizeof(T));
    };
    return {matrix(view.x), matrix(view.y), matrix(view.z)};
}
} // namespace detail

} // namespace gusset

#endif // GUSSET_NET_COORDINATES_HPP
