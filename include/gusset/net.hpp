// Nets: regular networks of quads, closed to surfaces by gluing. Include gusset.hpp, not this.
#ifndef GUSSET_NET_HPP
#define GUSSET_NET_HPP

#include <gusset/base.hpp>

#include <limits>

namespace gusset {

/// What becomes of the four sides of a net; combine with |.
enum class Sides : uint32_t {
    sheet = GUSSET_SIDES_SHEET,
    rows_closed = GUSSET_SIDES_ROWS_CLOSED,
    columns_closed = GUSSET_SIDES_COLUMNS_CLOSED,
    pole_top = GUSSET_SIDES_POLE_TOP,
    pole_bottom = GUSSET_SIDES_POLE_BOTTOM,
    pole_left = GUSSET_SIDES_POLE_LEFT,
    pole_right = GUSSET_SIDES_POLE_RIGHT,
    tube = GUSSET_SIDES_TUBE,
    two_poles = GUSSET_SIDES_TWO_POLES,
    one_pole = GUSSET_SIDES_ONE_POLE,
    torus = GUSSET_SIDES_TORUS
};
constexpr Sides operator|(Sides a, Sides b) {
    return static_cast<Sides>(static_cast<uint32_t>(a) | static_cast<uint32_t>(b));
}

/// A run of nodes glued to another; see gusset_seam.
using Seam = gusset_seam;

/// What is glued to what; see gusset_net_gluing.
struct Gluing {
    Gluing() = default;
    Gluing(Sides given) : sides(given) {}
    explicit Gluing(Span<const Seam> given) : seams(given) {}

    Sides sides = Sides::sheet;
    /// 2 * rows rows of columns bytes, 0 or 1; empty: sides says it all.
    Span<const uint8_t> matrix;
    Span<const Seam> seams;
    bool reversed = false;
};

/// One coordinate of all nodes of a net, in somebody else's memory.
template <class T>
class MatrixView {
public:
    MatrixView(T *data, std::size_t rows, std::size_t columns, std::size_t stride)
        : data_(data), rows_(rows), columns_(columns), stride_(stride) {}

    std::size_t rows() const noexcept { return rows_; }
    std::size_t columns() const noexcept { return columns_; }
    /// Numbers from row to row.
    std::size_t stride() const noexcept { return stride_; }
    T *data() const noexcept { return data_; }
    Span<T> row(std::size_t i) const { return {data_ + i * stride_, columns_}; }
    T &operator()(std::size_t i, std::size_t j) const { return data_[i * stride_ + j]; }

private:
    T *data_;
    std::size_t rows_, columns_, stride_;
};

/// The coordinates of a net.
template <class T>
struct Coordinates {
    MatrixView<T> x, y, z;
};

/// A net: H x W nodes, and what is glued to what. Copies share memory until one of them is changed. Functions that are const may
/// run at the same time in many threads.
class Net {
public:
    explicit Net(gusset_net *owned) : net_(owned) {}
    Net(const Net &other) { *this = other; }
    Net(Net &&) noexcept = default;
    Net &operator=(Net &&) noexcept = default;
    Net &operator=(const Net &other) {
        gusset_net *copy = nullptr;
        detail::check(gusset_net_clone(nullptr, other.get(), &copy));
        net_.reset(copy);
        return *this;
    }
    ~Net() = default;

    /// A net of a copy of points, row after row: any container that keeps its elements side by side, whose first bytes are three
    /// floats or doubles.
    template <class Points>
    static Net of_points(std::size_t rows, std::size_t columns, const Points &points, const Gluing &gluing = {},
                         const Context &context = Context()) {
        using Point = std::remove_cv_t<std::remove_reference_t<decltype(*std::data(points))>>;
        using T = std::decay_t<decltype(std::declval<const Point &>()[0])>;
        static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>, "points of float or double");
        static_assert(sizeof(Point) >= 3 * sizeof(T), "three coordinates");
        if (columns != 0 && (rows > std::size(points) / columns || rows * columns != std::size(points))) {
            throw std::invalid_argument("gusset: the number of points is not rows * columns");
        }
        const T *data = reinterpret_cast<const T *>(std::data(points));
        gusset_net_arrays arrays = of_pointers(rows, columns, data, data + 1, data + 2);
        arrays.column_stride = sizeof(Point);
        return create(gusset_net_create, arrays, gluing, context);
    }

    /// A net of a copy of three matrices. row_stride: numbers from row to row, 0 for rows without gaps.
    template <class T>
    static Net of_matrices(std::size_t rows, std::size_t columns, const T *x, const T *y, const T *z, const Gluing &gluing = {},
                           std::size_t row_stride = 0, const Context &context = Context()) {
        gusset_net_arrays arrays = of_pointers(rows, columns, x, y, z);
        arrays.row_stride = stride_in_bytes<T>(row_stride);
        return create(gusset_net_create, arrays, gluing, context);
    }

    /// A net in the caller's own memory, which must outlive it and is changed with it; see gusset_net_borrow.
    template <class T>
    static Net borrow(std::size_t rows, std::size_t columns, T *x, T *y, T *z, const Gluing &gluing = {},
                      std::size_t row_stride = 0, const Context &context = Context()) {
        gusset_net_arrays arrays = of_pointers(rows, columns, x, y, z);
        arrays.row_stride = stride_in_bytes<T>(row_stride);
        return create(gusset_net_borrow, arrays, gluing, context);
    }

    std::size_t rows() const { return view().rows; }
    std::size_t columns() const { return view().columns; }
    std::size_t node_count() const { return rows() * columns(); }
    /// True for double, false for float.
    bool is_double() const { return view().scalar == GUSSET_F64; }

    /// The coordinates, to be read, valid until the net is changed. T: float or double, whichever the net has.
    template <class T>
    Coordinates<const T> coordinates() const {
        return matrices<const T>(view());
    }
    /// The same, to be written, valid until the next call with this net.
    template <class T>
    Coordinates<T> edit() {
        gusset_net_arrays arrays{};
        arrays.struct_size = sizeof arrays;
        detail::check(gusset_net_edit(nullptr, get(), &arrays));
        return matrices<T>(arrays);
    }
    /// Node (i, j), whatever the type.
    std::array<double, 3> at(std::size_t i, std::size_t j) const {
        const gusset_net_arrays arrays = view();
        if (i >= arrays.rows || j >= arrays.columns) {
            throw std::out_of_range("gusset: no such node");
        }
        const std::size_t offset = i * arrays.row_stride + j * arrays.column_stride;
        std::array<double, 3> node;
        const void *from[3] = {arrays.x, arrays.y, arrays.z};
        for (std::size_t k = 0; k < 3; ++k) {
            const char *number = static_cast<const char *>(from[k]) + offset;
            float single;
            if (arrays.scalar == GUSSET_F64) {
                std::memcpy(&node[k], number, sizeof(double));
            } else {
                std::memcpy(&single, number, sizeof single);
                node[k] = single;
            }
        }
        return node;
    }

    /// The sides, if they say all about the links.
    std::optional<Sides> sides() const {
        gusset_sides sides = 0;
        detail::check(gusset_net_topology(get(), &sides, nullptr, nullptr));
        return sides == UINT32_MAX ? std::nullopt : std::optional<Sides>(static_cast<Sides>(sides));
    }
    bool is_reversed() const {
        uint32_t reversed = 0;
        detail::check(gusset_net_topology(get(), nullptr, nullptr, &reversed));
        return reversed != 0;
    }
    /// The characteristic matrix: 2 * rows rows of columns bytes.
    std::vector<uint8_t> matrix() const {
        return filled<uint8_t>([&](uint8_t *out, std::size_t capacity, std::size_t *written) {
            return gusset_net_matrix(get(), out, capacity, written);
        });
    }
    std::vector<Seam> seams() const {
        return filled<Seam>([&](Seam *out, std::size_t capacity, std::size_t *written) {
            return gusset_net_seams(get(), out, capacity, written);
        });
    }
    /// Glues otherwise; positions stay what they are.
    void set_gluing(const Gluing &gluing, const Context &context = Context()) {
        const gusset_net_gluing given = as_c(gluing, view());
        context.call([&](gusset_context *c) { return gusset_net_set_gluing(c, get(), &given); });
    }

    gusset_net *get() const noexcept { return net_.get(); }

private:
    struct Destroy {
        void operator()(gusset_net *net) const noexcept { gusset_net_destroy(net); }
    };

    gusset_net_arrays view() const {
        gusset_net_arrays arrays{};
        arrays.struct_size = sizeof arrays;
        detail::check(gusset_net_view(get(), &arrays));
        return arrays;
    }
    template <class T>
    static Coordinates<T> matrices(const gusset_net_arrays &arrays) {
        if ((arrays.scalar == GUSSET_F64) != std::is_same_v<std::remove_const_t<T>, double>) {
            throw std::invalid_argument("gusset: the net has coordinates of the other type");
        }
        const auto one = [&](void *data) {
            return MatrixView<T>(static_cast<T *>(data), arrays.rows, arrays.columns, arrays.row_stride / sizeof(T));
        };
        return {one(arrays.x), one(arrays.y), one(arrays.z)};
    }
    template <class T>
    static gusset_net_arrays of_pointers(std::size_t rows, std::size_t columns, const T *x, const T *y, const T *z) {
        static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>, "coordinates of float or double");
        gusset_net_arrays arrays{};
        arrays.struct_size = sizeof arrays;
        arrays.rows = rows;
        arrays.columns = columns;
        // Only gusset_net_borrow writes there, and it is given what may be written.
        arrays.x = const_cast<T *>(x);
        arrays.y = const_cast<T *>(y);
        arrays.z = const_cast<T *>(z);
        arrays.scalar = std::is_same_v<T, double> ? GUSSET_F64 : GUSSET_F32;
        return arrays;
    }
    template <class T>
    static std::size_t stride_in_bytes(std::size_t stride) {
        return stride > std::numeric_limits<std::size_t>::max() / sizeof(T) ? std::numeric_limits<std::size_t>::max()
                                                                            : stride * sizeof(T);
    }
    static gusset_net_gluing as_c(const Gluing &gluing, const gusset_net_arrays &arrays) {
        const std::size_t bytes = gluing.matrix.size();
        if (bytes != 0 && (arrays.columns == 0 || bytes / 2 / arrays.columns < arrays.rows)) {
            throw std::invalid_argument("gusset: the characteristic matrix has 2 * rows * columns bytes");
        }
        gusset_net_gluing given{};
        given.struct_size = sizeof given;
        given.matrix = gluing.matrix.empty() ? nullptr : gluing.matrix.data();
        given.seams = gluing.seams.data();
        given.seam_count = gluing.seams.size();
        given.sides = static_cast<gusset_sides>(gluing.sides);
        given.reversed = gluing.reversed ? 1 : 0;
        return given;
    }
    template <class Function>
    static Net create(Function function, const gusset_net_arrays &arrays, const Gluing &gluing, const Context &context) {
        const gusset_net_gluing given = as_c(gluing, arrays);
        gusset_net *created = nullptr;
        context.call([&](gusset_context *c) { return function(c, &arrays, &given, &created); });
        return Net(created);
    }
    template <class T, class Function>
    static std::vector<T> filled(Function &&function) {
        std::size_t count = 0;
        detail::check(function(nullptr, 0, &count));
        std::vector<T> out(count);
        if (count != 0) {
            detail::check(function(out.data(), count, &count));
        }
        return out;
    }

    std::unique_ptr<gusset_net, Destroy> net_;
};

} // namespace gusset

#endif // GUSSET_NET_HPP
