/// @file
/// Nets: regular networks of quads, closed to surfaces by gluing. Include gusset.hpp, not this.
#ifndef GUSSET_NET_HPP
#define GUSSET_NET_HPP

#include <gusset/net_coordinates.hpp>
#include <gusset/net_field.hpp>
#include <gusset/net_gluing.hpp>
#include <gusset/net_join.hpp>
#include <gusset/net_primitive.hpp>

#include <initializer_list>

namespace gusset {

/// The measures that Net::measure computes; combine with |.
enum class NetMeasures : uint32_t {
    extent = GUSSET_NET_MEASURES_EXTENT,
    bilinear = GUSSET_NET_MEASURES_BILINEAR,
    body = GUSSET_NET_MEASURES_BODY
};
/// Both.
constexpr NetMeasures operator|(NetMeasures a, NetMeasures b) {
    return static_cast<NetMeasures>(static_cast<uint32_t>(a) | static_cast<uint32_t>(b));
}

/// The deviations of the cells of a net from planes; see gusset_net_planarity.
struct NetPlanarity {
    /// The largest, the mean, and the number above the tolerance.
    gusset_net_planarity_report summary;
    /// For each cell; NaN for missing cells.
    std::vector<double> cells;
};

struct DecimatedNet;

/// A net: H x W nodes and their gluing. Copies share memory until one of them is changed. Const functions may run in
/// many threads at the same time. Functions that return a net do not change this one.
class Net {
public:
    /// Takes ownership of a handle of the C interface.
    explicit Net(gusset_net *owned) : net_(owned) {}
    /// Shares the memory of another net until one of the two is changed.
    Net(const Net &other) { *this = other; }
    /// Takes over another net.
    Net(Net &&) noexcept = default;
    /// Takes over another net.
    Net &operator=(Net &&) noexcept = default;
    /// Shares the memory of another net until one of the two is changed.
    Net &operator=(const Net &other) {
        net_.reset(detail::lent(gusset_net_copy_create, nullptr, other.get(), nullptr));
        return *this;
    }
    /// Destroys the net; copies stay.
    ~Net() = default;

    /// A net of a copy of points, row after row: any container that keeps its elements side by
    /// side, whose first bytes are three floats or doubles.
    template <class Container>
    static Net from_points(std::size_t rows, std::size_t columns, const Container &points, const Gluing &gluing = {},
                           const Context &context = Context()) {
        return create(detail::net_view(rows, columns, points), gluing, GUSSET_NET_MEMORY_COPY, context);
    }

    /// A net of a copy of three matrices. `row_stride`: numbers from row to row, 0 for rows without
    /// gaps.
    template <class T>
    static Net from_matrices(std::size_t rows, std::size_t columns, const T *x, const T *y, const T *z,
                             const Gluing &gluing = {}, std::size_t row_stride = 0,
                             const Context &context = Context()) {
        return create(detail::net_view(rows, columns, x, y, z, row_stride), gluing, GUSSET_NET_MEMORY_COPY, context);
    }

    /// A net in the caller's own memory, which must outlive it and is changed with it; copies have
    /// memory of their own. See gusset_net_create.
    template <class T>
    static Net borrow(std::size_t rows, std::size_t columns, T *x, T *y, T *z, const Gluing &gluing = {},
                      std::size_t row_stride = 0, const Context &context = Context()) {
        static_assert(!std::is_const_v<T>, "a net changes its coordinates");
        return create(detail::net_view(rows, columns, x, y, z, row_stride), gluing, GUSSET_NET_MEMORY_BORROW, context);
    }

    /// A net of a standard shape.
    static Net from_primitive(const Primitive &primitive, const Context &context = Context()) {
        const gusset_net_primitive given = primitive.get();
        return Net(context.result(gusset_net_primitive_create, &given));
    }

    /// A net of heights over a grid, floats or doubles, row after row. Missing heights make missing
    /// nodes.
    template <class T>
    static Net from_heights(std::size_t rows, std::size_t columns, const T *heights, const HeightOptions &options = {},
                            const Context &context = Context()) {
        static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>, "heights of float or double");
        auto given = detail::sized<gusset_heights>();
        given.rows = rows;
        given.columns = columns;
        given.values = heights;
        given.row_stride = detail::stride_in_bytes<T>(options.row_stride);
        std::memcpy(given.spacing, options.spacing.data(), sizeof given.spacing);
        std::memcpy(given.origin, options.origin.data(), sizeof given.origin);
        given.no_data = options.no_data.value_or(0.0);
        given.has_no_data = options.no_data ? 1 : 0;
        given.scalar = detail::scalar_of<T>;
        return Net(context.result(gusset_net_from_heights_create, &given));
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

    /// The coordinates, to be read, valid until the net is changed. T is the type that the net has:
    /// float or double.
    template <class T>
    NetCoordinates<const T> coordinates() const & {
        return detail::matrices<const T>(view());
    }
    template <class T>
    NetCoordinates<const T> coordinates() const && = delete;
    /// The same, to be written, valid until the next call with this net. Glued nodes must be kept
    /// equal: see snap.
    template <class T>
    NetCoordinates<T> edit() & {
        detail::require_scalar<T>(view());
        return detail::matrices<T>(detail::lent(gusset_net_edit, nullptr, get()));
    }
    template <class T>
    NetCoordinates<T> edit() && = delete;
    /// Node (i, j), as doubles for any scalar type.
    Point3 at(std::size_t i, std::size_t j) const {
        const gusset_net_view arrays = view();
        detail::require_element(i, arrays.rows, "row");
        detail::require_element(j, arrays.columns, "column");
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
    /// A copy of all nodes, row after row. Point: as for from_points, of the type that the net has.
    template <class Point = Point3>
    std::vector<Point> points(const Context &context = Context()) const {
        std::vector<Point> out(node_count());
        gusset_net_view arrays = detail::net_view(rows(), columns(), out);
        context.call(gusset_net_read, get(), &arrays);
        return out;
    }
    /// Copies the coordinates to the caller's matrices, of as many rows and columns.
    template <class T>
    void read(const NetCoordinates<T> &out, const Context &context = Context()) const {
        static_assert(!std::is_const_v<T>, "to be written");
        const auto like_x = [&](const MatrixView<T> &other) {
            return other.rows() == out.x.rows() && other.columns() == out.x.columns() &&
                   other.stride() == out.x.stride();
        };
        if (!like_x(out.y) || !like_x(out.z)) {
            detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "matrices of different sizes");
        }
        gusset_net_view arrays = detail::net_view<T>(out.x.rows(), out.x.columns(), out.x.data(), out.y.data(),
                                                     out.z.data(), out.x.stride());
        context.call(gusset_net_read, get(), &arrays);
    }
    /// Makes every node missing that has `value` for a coordinate.
    void clear_no_data(double value, const Context &context = Context()) {
        context.call(gusset_net_clear_no_data, get(), value);
    }

    /// The sides, if they describe all links; seams glue besides.
    std::optional<Sides> sides() const {
        const gusset_sides sides = gluing_report().sides;
        return sides == UINT32_MAX ? std::nullopt : std::optional<Sides>(static_cast<Sides>(sides));
    }
    /// True if faces are taken the other way round.
    bool is_reversed() const { return gluing_report().reversed != 0; }
    /// The characteristic matrix: 2 * rows rows of columns bytes.
    std::vector<uint8_t> matrix() const {
        std::vector<uint8_t> out(gluing_report().matrix_size);
        detail::lent(gusset_net_get_gluing, get(), out.data(), out.size(), nullptr, std::size_t{0});
        return out;
    }
    /// See ::gusset_net_get_gluing.
    std::vector<Seam> seams() const {
        std::vector<Seam> out(gluing_report().seam_count);
        detail::lent(gusset_net_get_gluing, get(), nullptr, std::size_t{0}, out.data(), out.size());
        return out;
    }
    /// Replaces the gluing; positions do not change.
    void set_gluing(const Gluing &gluing, const Context &context = Context()) {
        const gusset_net_gluing given = detail::as_c(gluing, view());
        context.call(gusset_net_set_gluing, get(), &given);
    }
    /// Glues as the options say, all or nothing; returns the number of nodes that moved.
    uint64_t glue(const GlueOptions &options, const Context &context = Context()) {
        const gusset_glue_options given = detail::as_c(options);
        return context.result(gusset_net_glue, get(), &given);
    }
    /// Glues nodes with equal coordinates; see `detect` of GlueOptions.
    void detect_gluing(double tolerance = 0.0, const Context &context = Context()) {
        GlueOptions options;
        options.detect = true;
        options.tolerance = tolerance;
        glue(options, context);
    }
    /// Glues all given nodes or none; positions do not change.
    void glue(Span<const LocalGluing> gluings, const Context &context = Context()) {
        GlueOptions options;
        options.gluings.assign(gluings.begin(), gluings.end());
        glue(options, context);
    }
    /// One gluing; see gusset_net_glue.
    void glue(const LocalGluing &gluing, const Context &context = Context()) { glue({&gluing, 1}, context); }
    /// The same of several, all or none.
    void glue(std::initializer_list<LocalGluing> gluings, const Context &context = Context()) {
        glue({gluings.begin(), gluings.size()}, context);
    }
    /// Unglues pairs of nodes and moves separated pieces apart; returns the number of pieces moved.
    /// See gusset_net_unglue.
    uint64_t unglue(Span<const LocalGluing> gluings, double separation = 0.0, const Context &context = Context()) {
        return context.result(gusset_net_unglue, get(), gluings.data(), gluings.size(), separation);
    }
    /// One gluing; see gusset_net_unglue.
    uint64_t unglue(const LocalGluing &gluing, double separation = 0.0, const Context &context = Context()) {
        return unglue({&gluing, 1}, separation, context);
    }
    /// The same of several.
    uint64_t unglue(std::initializer_list<LocalGluing> gluings, double separation = 0.0,
                    const Context &context = Context()) {
        return unglue({gluings.begin(), gluings.size()}, separation, context);
    }
    /// Contracts links by their numbers, such as NetAnalysis::contracted; to be followed by snap.
    void absorb(Indices links, const Context &context = Context()) {
        GlueOptions options;
        options.links.assign(links.begin(), links.end());
        glue(options, context);
    }
    /// Contracts every link whose ends are one point already.
    void saturate(const Context &context = Context()) {
        GlueOptions options;
        options.saturate = true;
        glue(options, context);
    }
    /// Gives glued nodes the position of the first of them; returns the number of nodes changed.
    uint64_t snap(const Context &context = Context()) {
        GlueOptions options;
        options.snap = true;
        return glue(options, context);
    }
    /// For each node the smallest node that is the same point.
    std::vector<uint32_t> classes(const Context &context = Context()) const {
        std::vector<uint32_t> out(node_count());
        std::size_t written = 0;
        context.call(gusset_net_classes, get(), out.data(), out.size(), &written);
        return out;
    }
    /// The local gluing at a node, if any. `cyclic`: links back to the first row or column count
    /// too.
    std::optional<GluingType> classify_node(uint32_t node, bool cyclic = false,
                                            const Context &context = Context()) const {
        return type(context.result(gusset_net_classify, get(), gusset_gluing_place{GUSSET_GLUING_PLACE_NODE}, node, cyclic));
    }
    /// The degenerate shape of a cell that is not a quad.
    std::optional<GluingType> classify_cell(uint32_t cell, const Context &context = Context()) const {
        return type(context.result(gusset_net_classify, get(), gusset_gluing_place{GUSSET_GLUING_PLACE_CELL}, cell, false));
    }
    /// All local gluings, at nodes and then of cells; see gusset_net_gluing_occurrences.
    std::vector<GluingOccurrence> gluing_occurrences(bool cyclic = false, const Context &context = Context()) const {
        std::size_t written = 0;
        context.call(gusset_net_gluing_occurrences, get(), cyclic, nullptr, std::size_t{0}, &written);
        std::vector<GluingOccurrence> found(written);
        context.call(gusset_net_gluing_occurrences, get(), cyclic, found.data(), found.size(), &written);
        return found;
    }
    /// See ::gusset_net_histogram.
    GluingHistogram histogram(const Context &context = Context()) const {
        GluingHistogram found{};
        context.call(gusset_net_histogram, get(), found.nodes.data(), found.cells.data());
        return found;
    }

    /// A copy: a part, without repeated rows and columns, enlarged, turned, converted, as the options say.
    Net copied(const NetCopyOptions &options, const Context &context = Context()) const {
        const gusset_net_copy_options given = detail::as_c(options);
        return Net(context.result(gusset_net_copy_create, get(), &given));
    }
    /// A copy with coordinates of another type.
    Net converted(Scalar scalar, const Context &context = Context()) const {
        NetCopyOptions options;
        options.scalar = scalar;
        return copied(options, context);
    }
    /// The net within a range of rows and of columns; a count of 0: all that there are from the first on.
    Net part(std::size_t row_first, std::size_t row_count, std::size_t column_first, std::size_t column_count,
             const Context &context = Context()) const {
        NetCopyOptions options;
        options.row_first = row_first;
        options.row_count = row_count;
        options.column_first = column_first;
        options.column_count = column_count;
        return copied(options, context);
    }
    /// The net with rows and columns exchanged.
    Net transposed(const Context &context = Context()) const { return turned_by(NetTurn::transpose, context); }
    /// The last column first, or the last row.
    Net flipped(Direction direction, const Context &context = Context()) const {
        return turned_by(direction == Direction::right ? NetTurn::flip_columns : NetTurn::flip_rows, context);
    }
    /// The net after quarters of a turn: after one, the last column is the first row.
    Net turned(int32_t quarters, const Context &context = Context()) const {
        return turned_by(static_cast<NetTurn>((quarters % 4 + 4) % 4), context);
    }
    /// The net without rows and columns that repeat the one before them.
    Net compacted(const Context &context = Context()) const {
        NetCopyOptions options;
        options.compact = true;
        return copied(options, context);
    }
    /// See ::gusset_net_resample_create.
    Net resampled(std::size_t rows, std::size_t columns, Interpolation interpolation = Interpolation::bicubic,
                  const Context &context = Context()) const {
        return Net(context.result(gusset_net_resample_create, get(), rows, columns,
                                  static_cast<gusset_interpolation>(interpolation)));
    }
    /// Fewer rows and columns, within a tolerance.
    DecimatedNet decimated(double tolerance, const Context &context = Context()) const;
    /// Nets of 2^k + 1 rows and columns, the finest first; see gusset_net_pyramid_create.
    std::vector<Net> pyramid(Interpolation interpolation = Interpolation::bicubic,
                             const Context &context = Context()) const {
        std::array<gusset_net *, GUSSET_PYRAMID_LEVELS> levels{};
        std::size_t count = 0;
        std::vector<Net> nets;
        nets.reserve(levels.size()); // Nothing throws between the call and the ownership of its nets.
        context.call(gusset_net_pyramid_create, get(), static_cast<gusset_interpolation>(interpolation), levels.data(),
                     levels.size(), &count);
        for (std::size_t i = 0; i < count; ++i) {
            nets.emplace_back(levels[i]);
        }
        return nets;
    }

    /// The number of bridges.
    std::size_t bridge_count() const { return gluing_report().bridge_count; }
    /// See ::gusset_net_get_bridge.
    Bridge bridge(std::size_t index) const {
        const gusset_bridge found = detail::lent(gusset_net_get_bridge, get(), index);
        return {static_cast<Direction>(found.direction), found.at,        found.start,
                found.end,                               static_cast<BridgeKind>(found.kind),
                static_cast<BridgeMode>(found.mode),     found.properties,
                found.rows};
    }
    /// `properties`: empty keeps them.
    void set_bridge(std::size_t index, BridgeMode mode, double tolerance = 0.0,
                    const std::optional<BridgeProperties> &properties = std::nullopt,
                    const Context &context = Context()) {
        context.call(gusset_net_set_bridge, get(), index, static_cast<gusset_bridge_mode>(mode), tolerance,
                     properties ? &*properties : nullptr);
    }
    /// The nets on both sides of a bridge, as they were joined; see gusset_net_split_create.
    std::pair<Net, Net> split(std::size_t bridge, const Context &context = Context()) const {
        gusset_net *first = nullptr, *second = nullptr;
        context.call(gusset_net_split_create, get(), bridge, &first, &second);
        return {Net(first), Net(second)};
    }

    /// Transforms all nodes by operations, in order.
    void transform(Span<const Operation> operations, const Context &context = Context()) {
        context.call(gusset_net_transform, get(), operations.data(), operations.size());
    }
    /// One operation; see gusset_net_transform.
    void transform(const Operation &operation, const Context &context = Context()) {
        transform({&operation, 1}, context);
    }
    /// Several operations, in order.
    void transform(std::initializer_list<Operation> operations, const Context &context = Context()) {
        transform({operations.begin(), operations.size()}, context);
    }
    /// Deforms the net by fields, in order. `time`: for fields with keys.
    void deform(Span<const Field> fields, double time = 0.0, const Context &context = Context()) {
        const std::vector<gusset_field> given = detail::as_c(fields);
        context.call(gusset_net_deform, get(), given.data(), given.size(), time);
    }
    /// One field; see gusset_net_deform.
    void deform(const Field &field, double time = 0.0, const Context &context = Context()) {
        deform({&field, 1}, time, context);
    }
    /// Several fields, in order.
    void deform(std::initializer_list<Field> fields, double time = 0.0, const Context &context = Context()) {
        deform({fields.begin(), fields.size()}, time, context);
    }
    /// Moves every node along its normal.
    void displace(double distance, const Context &context = Context()) {
        context.call(gusset_net_displace, get(), distance);
    }

    /// Area, volume, box, unless others are asked for.
    gusset_net_measure_report measure(NetMeasures measures = NetMeasures::extent,
                                      const Context &context = Context()) const {
        return context.result(gusset_net_measure, get(), static_cast<gusset_net_measures>(measures));
    }
    /// See ::gusset_net_planarity.
    NetPlanarity planarity(double tolerance = 0.0, const Context &context = Context()) const {
        const gusset_net_view arrays = view();
        NetPlanarity found{detail::sized<gusset_net_planarity_report>(), {}};
        found.cells.resize((arrays.rows - 1) * (arrays.columns - 1));
        std::size_t written = 0;
        context.call(gusset_net_planarity, get(), tolerance, found.cells.data(), found.cells.size(), &written,
                     &found.summary);
        return found;
    }
    /// Moves nodes as little as possible so that all cells are plane; see gusset_net_planarise.
    gusset_planarise_report planarise(const PlanariseOptions &options = {}, const Context &context = Context()) {
        const gusset_planarise_options given = detail::as_c(options);
        return context.result(gusset_net_planarise, get(), &given);
    }
    /// Moves bridges, and parts that are free, to their equilibrium; see gusset_net_settle.
    gusset_settle_report settle(const SettleOptions &options = {}, const Context &context = Context()) {
        const gusset_settle_options given = detail::as_c(options);
        return context.result(gusset_net_settle, get(), &given);
    }
    /// The net at a time from 0 to 1 on the way to another; see gusset_net_morph_create.
    Net morphed(const Net &other, double t, MorphPath path = MorphPath::linear,
                const Context &context = Context()) const {
        return Net(context.result(gusset_net_morph_create, get(), other.get(), t, static_cast<gusset_morph_path>(path)));
    }
    /// T is the type that the net has.
    template <class T>
    NetNormals<T> normals(const Context &context = Context()) const {
        detail::require_scalar<T>(view());
        const std::size_t count = node_count();
        NetNormals<T> found{std::vector<T>(count), std::vector<T>(count), std::vector<T>(count)};
        context.call(gusset_net_normals, get(), found.x.data(), found.y.data(), found.z.data(), count, &found.missing_count);
        return found;
    }

    /// The argument for the C interface, which this still owns.
    gusset_net *get() const noexcept { return net_.get(); }

private:
    static std::optional<GluingType> type(gusset_gluing_type found) {
        return found == GUSSET_TYPE_NONE ? std::nullopt : std::optional<GluingType>(static_cast<GluingType>(found));
    }
    gusset_net_view view() const { return detail::lent(gusset_net_get_view, get()); }
    gusset_net_gluing_report gluing_report() const {
        return detail::lent(gusset_net_get_gluing, get(), nullptr, std::size_t{0}, nullptr, std::size_t{0});
    }
    Net turned_by(NetTurn turn, const Context &context) const {
        NetCopyOptions options;
        options.turn = turn;
        return copied(options, context);
    }
    static Net create(const gusset_net_view &arrays, const Gluing &gluing, gusset_net_memory memory,
                      const Context &context) {
        const gusset_net_gluing given = detail::as_c(gluing, arrays);
        return Net(context.result(gusset_net_create, &arrays, &given, memory));
    }

    detail::Handle<gusset_net, gusset_net_destroy> net_;
};

/// A net of fewer rows and columns.
struct DecimatedNet {
    /// The smaller net.
    Net net;
    /// The rows of the old net that it keeps.
    std::vector<uint32_t> rows;
    /// The columns of the old net that it keeps.
    std::vector<uint32_t> columns;
    /// Its deviation from the old one.
    double deviation;
};

inline DecimatedNet Net::decimated(double tolerance, const Context &context) const {
    std::vector<uint32_t> kept_rows(rows()), kept_columns(columns());
    double deviation = 0.0;
    Net net(context.result(gusset_net_decimate_create, get(), tolerance, kept_rows.data(), kept_columns.data(),
                           &deviation));
    kept_rows.resize(net.rows());
    kept_columns.resize(net.columns());
    return {std::move(net), std::move(kept_rows), std::move(kept_columns), deviation};
}

/// Joins nets side by side to one; a net may occur several times. See
/// gusset_net_concatenate_create.
inline Net concatenate(Span<const Net *const> nets, const ConcatenateOptions &options = {},
                       const Context &context = Context()) {
    const gusset_concatenate_options given = detail::as_c(options);
    std::vector<const gusset_net *> handles;
    for (const Net *net : nets) {
        handles.push_back(net != nullptr ? net->get() : nullptr);
    }
    return Net(context.result(gusset_net_concatenate_create, handles.data(), handles.size(), &given));
}
/// Joins nets side by side to one; see gusset_net_concatenate_create.
inline Net concatenate(Span<const Net> nets, const ConcatenateOptions &options = {}, const Context &context = Context()) {
    std::vector<const Net *> pointers;
    for (const Net &net : nets) {
        pointers.push_back(&net);
    }
    return concatenate(Span<const Net *const>(pointers), options, context);
}
/// The same of nets that are not copied.
inline Net concatenate(std::initializer_list<const Net *> nets, const ConcatenateOptions &options = {},
                       const Context &context = Context()) {
    return concatenate(Span<const Net *const>(nets.begin(), nets.size()), options, context);
}
/// Joins two nets.
inline Net concatenate(const Net &first, const Net &second, const ConcatenateOptions &options = {},
                       const Context &context = Context()) {
    const Net *const nets[] = {&first, &second};
    return concatenate(Span<const Net *const>(nets, 2), options, context);
}

} // namespace gusset

#endif // GUSSET_NET_HPP
