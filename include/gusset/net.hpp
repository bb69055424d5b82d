// Nets: regular networks of quads, closed to surfaces by gluing. Include gusset.hpp, not this.
#ifndef GUSSET_NET_HPP
#define GUSSET_NET_HPP

#include <gusset/net_field.hpp>
#include <gusset/net_shape.hpp>

#include <initializer_list>

namespace gusset {

struct Decimated;

/// A net: H x W nodes, and what is glued to what. Copies share memory until one of them is changed. Functions that are const may
/// run at the same time in many threads. What makes another net leaves this one as it is.
class Net {
public:
    explicit Net(gusset_net *owned) : net_(owned) {}
    Net(const Net &other) { *this = other; }
    Net(Net &&) noexcept = default;
    Net &operator=(Net &&) noexcept = default;
    Net &operator=(const Net &other) {
        gusset_net *copy = nullptr;
        detail::check(gusset_net_clone_create(nullptr, other.get(), &copy));
        net_.reset(copy);
        return *this;
    }
    ~Net() = default;

    /// A net of a copy of points, row after row: any container that keeps its elements side by side, whose first bytes are three
    /// floats or doubles.
    template <class Points>
    static Net of_points(std::size_t rows, std::size_t columns, const Points &points, const Gluing &gluing = {},
                         const Context &context = Context()) {
        gusset_net_view arrays = of_container(rows, columns, points);
        return create(gusset_net_create, arrays, gluing, context);
    }

    /// A net of a copy of three matrices. row_stride: numbers from row to row, 0 for rows without gaps.
    template <class T>
    static Net of_matrices(std::size_t rows, std::size_t columns, const T *x, const T *y, const T *z, const Gluing &gluing = {},
                           std::size_t row_stride = 0, const Context &context = Context()) {
        gusset_net_view arrays = of_pointers(rows, columns, x, y, z);
        arrays.row_stride = detail::stride_in_bytes<T>(row_stride);
        return create(gusset_net_create, arrays, gluing, context);
    }

    /// A net in the caller's own memory, which must outlive it and is changed with it; copies have memory of their own. See
    /// gusset_net_borrow_create.
    template <class T>
    static Net borrow(std::size_t rows, std::size_t columns, T *x, T *y, T *z, const Gluing &gluing = {},
                      std::size_t row_stride = 0, const Context &context = Context()) {
        static_assert(!std::is_const_v<T>, "a net changes its coordinates");
        gusset_net_view arrays = of_pointers(rows, columns, x, y, z);
        arrays.row_stride = detail::stride_in_bytes<T>(row_stride);
        return create(gusset_net_borrow_create, arrays, gluing, context);
    }

    /// A net of a standard shape.
    static Net of_shape(const Shape &shape, const Context &context = Context()) {
        const gusset_net_primitive given = shape.get();
        return made(context, [&](gusset_context *c, gusset_net **net) { return gusset_net_primitive_create(c, &given, net); });
    }

    /// A net of heights over a grid, floats or doubles, row after row; those that are missing become missing nodes.
    template <class T>
    static Net of_heights(std::size_t rows, std::size_t columns, const T *heights, const HeightOptions &options = {},
                          const Context &context = Context()) {
        static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>, "heights of float or double");
        gusset_heights given{};
        given.struct_size = sizeof given;
        given.rows = rows;
        given.columns = columns;
        given.values = heights;
        given.row_stride = detail::stride_in_bytes<T>(options.row_stride);
        std::memcpy(given.spacing, options.spacing.data(), sizeof given.spacing);
        std::memcpy(given.origin, options.origin.data(), sizeof given.origin);
        given.no_data = options.no_data.value_or(0.0);
        given.has_no_data = options.no_data ? 1 : 0;
        given.scalar = scalar_of<T>();
        return made(context, [&](gusset_context *c, gusset_net **net) { return gusset_net_from_heights_create(c, &given, net); });
    }

    /// The rows of nodes.
    std::size_t rows() const { return view().rows; }
    /// The columns of nodes.
    std::size_t columns() const { return view().columns; }
    /// rows() * columns().
    std::size_t node_count() const {
        const gusset_net_view arrays = view();
        return arrays.rows * arrays.columns;
    }
    /// True for double, false for float.
    bool is_double() const { return view().scalar == GUSSET_F64; }

    /// The coordinates, to be read, valid until the net is changed. T: float or double, whichever the net has.
    template <class T>
    Coordinates<const T> coordinates() const & {
        return matrices<const T>(view());
    }
    template <class T>
    Coordinates<const T> coordinates() const && = delete;
    /// The same, to be written, valid until the next call with this net. Nodes that are glued must be kept equal: see snap.
    template <class T>
    Coordinates<T> edit() & {
        require<T>(view());
        gusset_net_view arrays{};
        arrays.struct_size = sizeof arrays;
        detail::check(gusset_net_edit(nullptr, get(), &arrays));
        return matrices<T>(arrays);
    }
    template <class T>
    Coordinates<T> edit() && = delete;
    /// Node (i, j), whatever the type.
    Point3 at(std::size_t i, std::size_t j) const {
        const gusset_net_view arrays = view();
        if (i >= arrays.rows || j >= arrays.columns) {
            throw std::out_of_range("gusset: no such node");
        }
        const std::size_t offset = i * arrays.row_stride + j * arrays.column_stride;
        Point3 node{};
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
    /// A copy of all nodes, row after row. Point: as for of_points, of floats or doubles whichever the net has.
    template <class Point = Point3>
    std::vector<Point> points(const Context &context = Context()) const {
        std::vector<Point> out(node_count());
        gusset_net_view arrays = of_container(rows(), columns(), out);
        context.call([&](gusset_context *c) { return gusset_net_read(c, get(), &arrays); });
        return out;
    }
    /// Copies the coordinates to the caller's matrices, of as many rows and columns.
    template <class T>
    void read(const Coordinates<T> &out, const Context &context = Context()) const {
        static_assert(!std::is_const_v<T>, "to be written");
        const auto like_x = [&](const MatrixView<T> &other) {
            return other.rows() == out.x.rows() && other.columns() == out.x.columns() && other.stride() == out.x.stride();
        };
        if (!like_x(out.y) || !like_x(out.z)) {
            throw std::invalid_argument("gusset: matrices of different sizes");
        }
        gusset_net_view arrays = of_pointers(out.x.rows(), out.x.columns(), out.x.data(), out.y.data(), out.z.data());
        arrays.row_stride = detail::stride_in_bytes<T>(out.x.stride());
        context.call([&](gusset_context *c) { return gusset_net_read(c, get(), &arrays); });
    }
    /// Makes missing every node of which a coordinate is `value`.
    void clear_no_data(double value, const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_net_clear_no_data(c, get(), value); });
    }

    /// The sides, if they say all about the links.
    std::optional<Sides> sides() const {
        gusset_sides sides = 0;
        detail::check(gusset_net_get_topology(get(), &sides, nullptr, nullptr));
        return sides == UINT32_MAX ? std::nullopt : std::optional<Sides>(static_cast<Sides>(sides));
    }
    bool is_reversed() const {
        uint32_t reversed = 0;
        detail::check(gusset_net_get_topology(get(), nullptr, nullptr, &reversed));
        return reversed != 0;
    }
    /// The characteristic matrix: 2 * rows rows of columns bytes.
    std::vector<uint8_t> matrix() const {
        return detail::filled<uint8_t>([&](uint8_t *out, std::size_t capacity, std::size_t *written) {
            detail::check(gusset_net_get_matrix(get(), out, capacity, written));
        });
    }
    std::vector<Seam> seams() const {
        return detail::filled<Seam>([&](Seam *out, std::size_t capacity, std::size_t *written) {
            detail::check(gusset_net_get_seams(get(), out, capacity, written));
        });
    }
    /// Glues otherwise; positions stay what they are.
    void set_gluing(const Gluing &gluing, const Context &context = Context()) {
        const gusset_net_gluing given = as_c(gluing, view());
        context.call([&](gusset_context *c) { return gusset_net_set_gluing(c, get(), &given); });
    }
    /// Glues as the coordinates tell; see gusset_net_derive.
    void derive(double tolerance = 0.0, const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_net_derive(c, get(), tolerance); });
    }
    /// Glues nodes, all or none; positions stay what they are.
    void glue(Span<const LocalGluing> gluings, const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_net_glue(c, get(), gluings.data(), gluings.size()); });
    }
    /// Glues one thing; see gusset_net_glue.
    void glue(const LocalGluing &gluing, const Context &context = Context()) { glue({&gluing, 1}, context); }
    /// Glues all of them or none.
    void glue(std::initializer_list<LocalGluing> gluings, const Context &context = Context()) {
        glue({gluings.begin(), gluings.size()}, context);
    }
    /// Unglues pairs of nodes, and moves what becomes separate apart; returns how many pieces moved. See gusset_net_unglue.
    std::size_t unglue(Span<const LocalGluing> gluings, double separation = 0.0, const Context &context = Context()) {
        std::size_t moved = 0;
        context.call([&](gusset_context *c) {
            return gusset_net_unglue(c, get(), gluings.data(), gluings.size(), separation, &moved);
        });
        return moved;
    }
    /// Unglues one thing; see gusset_net_unglue.
    std::size_t unglue(const LocalGluing &gluing, double separation = 0.0, const Context &context = Context()) {
        return unglue({&gluing, 1}, separation, context);
    }
    /// Unglues all of them.
    std::size_t unglue(std::initializer_list<LocalGluing> gluings, double separation = 0.0,
                       const Context &context = Context()) {
        return unglue({gluings.begin(), gluings.size()}, separation, context);
    }
    /// Contracts links by their numbers, such as Analysis::contracted; follow it with snap.
    void absorb(Indices links, const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_net_absorb(c, get(), links.data(), links.size()); });
    }
    /// Contracts every link whose ends are one point already.
    void saturate(const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_net_saturate(c, get()); });
    }
    /// Gives glued nodes the position of the first of them; returns how many nodes got other bits.
    uint64_t snap(const Context &context = Context()) {
        uint64_t moved = 0;
        context.call([&](gusset_context *c) { return gusset_net_snap(c, get(), &moved); });
        return moved;
    }
    /// For each node the smallest node that is the same point.
    std::vector<uint32_t> classes(const Context &context = Context()) const {
        std::vector<uint32_t> out(node_count());
        std::size_t written = 0;
        context.call([&](gusset_context *c) { return gusset_net_classes(c, get(), out.data(), out.size(), &written); });
        return out;
    }
    /// The local gluing at a node, if any. cyclic: links that lead back to the first row or column count too.
    std::optional<GluingType> classify_node(uint32_t node, bool cyclic = false, const Context &context = Context()) const {
        gusset_gluing_type found = GUSSET_TYPE_NONE;
        context.call([&](gusset_context *c) { return gusset_net_classify_node(c, get(), node, cyclic ? 1 : 0, &found); });
        return type(found);
    }
    /// What a cell has become, if it is no quad.
    std::optional<GluingType> classify_cell(uint32_t cell, const Context &context = Context()) const {
        gusset_gluing_type found = GUSSET_TYPE_NONE;
        context.call([&](gusset_context *c) { return gusset_net_classify_cell(c, get(), cell, &found); });
        return type(found);
    }
    Histogram histogram(const Context &context = Context()) const {
        Histogram found{};
        context.call(
            [&](gusset_context *c) { return gusset_net_histogram(c, get(), found.nodes.data(), found.cells.data()); });
        return found;
    }

    /// A copy with coordinates of another type.
    Net converted(Scalar scalar, const Context &context = Context()) const {
        return made(context, [&](gusset_context *c, gusset_net **out) {
            return gusset_net_convert_create(c, get(), static_cast<uint32_t>(scalar), out);
        });
    }
    /// The net within some rows and columns.
    Net part(std::size_t row_first, std::size_t row_count, std::size_t column_first, std::size_t column_count,
             const Context &context = Context()) const {
        return made(context, [&](gusset_context *c, gusset_net **out) {
            return gusset_net_part_create(c, get(), row_first, row_count, column_first, column_count, out);
        });
    }
    Net transposed(const Context &context = Context()) const {
        return made(context, [&](gusset_context *c, gusset_net **out) { return gusset_net_transpose_create(c, get(), out); });
    }
    /// The last column first, or the last row.
    Net flipped(Direction direction, const Context &context = Context()) const {
        return made(context, [&](gusset_context *c, gusset_net **out) {
            return gusset_net_flip_create(c, get(), static_cast<gusset_direction>(direction), out);
        });
    }
    Net turned(int32_t quarters, const Context &context = Context()) const {
        return made(context,
                    [&](gusset_context *c, gusset_net **out) { return gusset_net_turn_create(c, get(), quarters, out); });
    }
    /// A larger net that is the same surface.
    Net reformatted(const ReformatOptions &options, const Context &context = Context()) const {
        const gusset_reformat_options given = detail::as_c(options);
        return made(context, [&](gusset_context *c, gusset_net **out) {
            return gusset_net_reformat_create(c, get(), &given, out);
        });
    }
    /// The inverse: without rows and columns that are the one before them again.
    Net compacted(const Context &context = Context()) const {
        return made(context, [&](gusset_context *c, gusset_net **out) { return gusset_net_compact_create(c, get(), out); });
    }
    Net resampled(std::size_t rows, std::size_t columns, Interpolation interpolation = Interpolation::bicubic,
                  const Context &context = Context()) const {
        return made(context, [&](gusset_context *c, gusset_net **out) {
            return gusset_net_resample_create(c, get(), rows, columns, static_cast<gusset_interpolation>(interpolation), out);
        });
    }
    /// The rows and columns that matter most.
    Decimated decimated(double tolerance, const Context &context = Context()) const;
    /// Nets of 2^k + 1 rows and columns, the finest first; see gusset_net_pyramid_create.
    std::vector<Net> pyramid(Interpolation interpolation = Interpolation::bicubic, const Context &context = Context()) const;

    std::size_t bridge_count() const {
        std::size_t count = 0;
        detail::check(gusset_net_bridge_count(get(), &count));
        return count;
    }
    Bridge bridge(std::size_t index) const;
    /// properties: nothing leaves them.
    void set_bridge(std::size_t index, BridgeMode mode, double tolerance = 0.0,
                    const std::optional<BridgeProperties> &properties = std::nullopt, const Context &context = Context()) {
        context.call([&](gusset_context *c) {
            return gusset_net_set_bridge(c, get(), index, static_cast<gusset_bridge_mode>(mode), tolerance,
                                         properties ? &*properties : nullptr);
        });
    }
    /// The nets on both sides of a bridge, as they were joined; see gusset_net_split_create.
    std::pair<Net, Net> split(std::size_t bridge, const Context &context = Context()) const;

    /// Moves all nodes by operations, the first one first.
    void transform(Span<const Operation> operations, const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_net_transform(c, get(), operations.data(), operations.size()); });
    }
    /// Moves all nodes by one operation; see gusset_net_transform.
    void transform(const Operation &operation, const Context &context = Context()) { transform({&operation, 1}, context); }
    /// Moves all nodes by several, the first one first.
    void transform(std::initializer_list<Operation> operations, const Context &context = Context()) {
        transform({operations.begin(), operations.size()}, context);
    }
    /// Moves all nodes by fields, the first one first. time: for fields with keys.
    void deform(Span<const Field> fields, double time = 0.0, const Context &context = Context()) {
        const std::vector<gusset_field> given = detail::as_c(fields);
        context.call([&](gusset_context *c) { return gusset_net_deform(c, get(), given.data(), given.size(), time); });
    }
    /// Moves all nodes by one field; see gusset_net_deform.
    void deform(const Field &field, double time = 0.0, const Context &context = Context()) { deform({&field, 1}, time, context); }
    /// Moves all nodes by several, the first one first.
    void deform(std::initializer_list<Field> fields, double time = 0.0, const Context &context = Context()) {
        deform({fields.begin(), fields.size()}, time, context);
    }
    /// Moves consecutive nodes, from node `first` on, by writing to the spans; returns false to stop. May throw: the exception
    /// comes out of the call. It must use neither the net nor the context.
    template <class T>
    using MoveNodes = std::function<bool(std::size_t first, Span<T> x, Span<T> y, Span<T> z)>;
    /// Moves all nodes by a function, then makes glued nodes equal. T: float or double, whichever the net has. What was done
    /// before a stop or an exception stays done.
    template <class T>
    void deform_rows(const MoveNodes<T> &move, const Context &context = Context());
    /// Moves every node along its normal.
    void displace(double distance, const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_net_displace(c, get(), distance); });
    }

    /// Area, volume, box.
    gusset_net_measure_report measure(const Context &context = Context()) const {
        gusset_net_measure_report found{};
        found.struct_size = sizeof found;
        context.call([&](gusset_context *c) { return gusset_net_measure(c, get(), &found); });
        return found;
    }
    /// Volume, centroid, tensor of inertia.
    gusset_net_moment_report moments(const Context &context = Context()) const {
        gusset_net_moment_report found{};
        found.struct_size = sizeof found;
        context.call([&](gusset_context *c) { return gusset_net_moments(c, get(), &found); });
        return found;
    }
    Planarity planarity(double tolerance = 0.0, const Context &context = Context()) const;
    /// T: float or double, whichever the net has.
    template <class T>
    Normals<T> normals(const Context &context = Context()) const;

    gusset_net *get() const noexcept { return net_.get(); }

private:
    struct Destroy {
        void operator()(gusset_net *net) const noexcept { gusset_net_destroy(net); }
    };

    template <class Function>
    static Net made(const Context &context, Function &&function) {
        gusset_net *created = nullptr;
        context.call([&](gusset_context *c) { return function(c, &created); });
        return Net(created);
    }
    template <class T>
    static constexpr uint32_t scalar_of() {
        return std::is_same_v<std::remove_const_t<T>, double> ? GUSSET_F64 : GUSSET_F32;
    }
    static std::optional<GluingType> type(gusset_gluing_type found) {
        return found == GUSSET_TYPE_NONE ? std::nullopt : std::optional<GluingType>(static_cast<GluingType>(found));
    }
    gusset_net_view view() const {
        gusset_net_view arrays{};
        arrays.struct_size = sizeof arrays;
        detail::check(gusset_net_get_view(get(), &arrays));
        return arrays;
    }
    template <class T>
    static void require(const gusset_net_view &arrays) {
        if (arrays.scalar != scalar_of<T>()) {
            throw std::invalid_argument("gusset: the net has coordinates of the other type");
        }
    }
    template <class T>
    static Coordinates<T> matrices(const gusset_net_view &arrays) {
        require<T>(arrays);
        const auto one = [&](void *data) {
            return MatrixView<T>(static_cast<T *>(data), arrays.rows, arrays.columns, arrays.row_stride / sizeof(T));
        };
        return {one(arrays.x), one(arrays.y), one(arrays.z)};
    }
    template <class T>
    static gusset_net_view of_pointers(std::size_t rows, std::size_t columns, const T *x, const T *y, const T *z) {
        static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>, "coordinates of float or double");
        gusset_net_view arrays{};
        arrays.struct_size = sizeof arrays;
        arrays.rows = rows;
        arrays.columns = columns;
        // Only gusset_net_borrow_create and gusset_net_read write there, and they are given what may be written.
        arrays.x = const_cast<T *>(x);
        arrays.y = const_cast<T *>(y);
        arrays.z = const_cast<T *>(z);
        arrays.scalar = scalar_of<T>();
        return arrays;
    }
    template <class Points>
    static gusset_net_view of_container(std::size_t rows, std::size_t columns, const Points &points) {
        using Point = std::remove_cv_t<std::remove_reference_t<decltype(*std::data(points))>>;
        using T = std::decay_t<decltype(std::declval<const Point &>()[0])>;
        static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>, "points of float or double");
        static_assert(sizeof(Point) >= 3 * sizeof(T), "three coordinates");
        if (columns != 0 && (rows > std::size(points) / columns || rows * columns != std::size(points))) {
            throw std::invalid_argument("gusset: the number of points is not rows * columns");
        }
        const T *data = reinterpret_cast<const T *>(std::data(points));
        gusset_net_view arrays = of_pointers(rows, columns, data, data + 1, data + 2);
        arrays.column_stride = sizeof(Point);
        return arrays;
    }
    static gusset_net_gluing as_c(const Gluing &gluing, const gusset_net_view &arrays) {
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
    static Net create(Function function, const gusset_net_view &arrays, const Gluing &gluing, const Context &context) {
        const gusset_net_gluing given = as_c(gluing, arrays);
        return made(context, [&](gusset_context *c, gusset_net **created) { return function(c, &arrays, &given, created); });
    }

    std::unique_ptr<gusset_net, Destroy> net_;
};

/// The net that was left, its rows and columns among the old ones, and how far it deviates.
struct Decimated {
    /// What is left of the net.
    Net net;
    /// Which rows and columns of the old one these are.
    std::vector<uint32_t> rows, columns;
    /// The deviation that was reached.
    double deviation;
};

} // namespace gusset

#include <gusset/net_members.hpp>

#endif // GUSSET_NET_HPP
