// What nets are told and what they tell: enumerations, options, values. Include gusset.hpp, not this.
#ifndef GUSSET_NET_TYPES_HPP
#define GUSSET_NET_TYPES_HPP

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
/// Both.
constexpr Sides operator|(Sides a, Sides b) {
    return static_cast<Sides>(static_cast<uint32_t>(a) | static_cast<uint32_t>(b));
}

/// A run of nodes glued to another; see gusset_seam.
using Seam = gusset_seam;

/// What is glued to what; see gusset_net_gluing.
struct Gluing {
    /// What becomes of the four sides.
    Gluing() = default;
    /// Runs of nodes glued to runs of nodes.
    Gluing(Sides given) : sides(given) {}
    /// Runs of nodes glued to runs of nodes, besides.
    explicit Gluing(std::vector<Seam> given) : seams(std::move(given)) {}

    /// What becomes of the four sides.
    Sides sides = Sides::sheet;
    /// 2 * rows rows of columns bytes, 0 or 1; empty: sides says it all.
    std::vector<uint8_t> matrix;
    /// Runs of nodes glued to runs of nodes, besides.
    std::vector<Seam> seams;
    /// Faces are to be taken the other way round.
    bool reversed = false;
};

/// The links of a node, for LocalGluing::star; combine with |.
enum class Links : uint32_t { east = 1, south = 2, west = 4, north = 8, all = 15 };
/// Both.
constexpr Links operator|(Links a, Links b) {
    return static_cast<Links>(static_cast<uint32_t>(a) | static_cast<uint32_t>(b));
}
/// The links of a cell, for LocalGluing::cell; combine with |.
enum class CellSides : uint32_t { top = 1, right = 2, bottom = 4, left = 8, all = 15 };
/// Both.
constexpr CellSides operator|(CellSides a, CellSides b) {
    return static_cast<CellSides>(static_cast<uint32_t>(a) | static_cast<uint32_t>(b));
}
/// Opposite corners of a cell: the first and the third, or the second and the fourth.
enum class Diagonal : uint32_t { falling = 1, rising = 2 };

/// The 18 local gluings; see the constants.
enum class GluingType : uint32_t {
    horizontal = GUSSET_TYPE_HORIZONTAL,
    vertical = GUSSET_TYPE_VERTICAL,
    east_south = GUSSET_TYPE_EAST_SOUTH,
    south_west = GUSSET_TYPE_SOUTH_WEST,
    west_north = GUSSET_TYPE_WEST_NORTH,
    north_east = GUSSET_TYPE_NORTH_EAST,
    east_west = GUSSET_TYPE_EAST_WEST,
    north_south = GUSSET_TYPE_NORTH_SOUTH,
    but_north = GUSSET_TYPE_BUT_NORTH,
    but_east = GUSSET_TYPE_BUT_EAST,
    but_south = GUSSET_TYPE_BUT_SOUTH,
    but_west = GUSSET_TYPE_BUT_WEST,
    all = GUSSET_TYPE_ALL,
    top_bottom = GUSSET_TYPE_TOP_BOTTOM,
    right_left = GUSSET_TYPE_RIGHT_LEFT,
    point = GUSSET_TYPE_POINT,
    falling = GUSSET_TYPE_FALLING,
    rising = GUSSET_TYPE_RISING
};

/// Nodes to be glued, or no longer to be; see gusset_gluing.
struct LocalGluing : gusset_gluing {
    /// The link from a node to the next one of its row.
    static LocalGluing horizontal(uint32_t node) { return link(2 * node); }
    /// The link from a node to the next one of its column.
    static LocalGluing vertical(uint32_t node) { return link(2 * node + 1); }
    /// A link by its number: 2 * node, and 1 more if it is vertical.
    static LocalGluing link(uint32_t link) { return LocalGluing(GUSSET_GLUING_LINK, link, 0); }
    /// A node and its neighbours in some directions.
    static LocalGluing star(uint32_t node, Links links) {
        return LocalGluing(GUSSET_GLUING_STAR, node, static_cast<uint32_t>(links));
    }
    /// The ends of some sides of a cell.
    static LocalGluing cell(uint32_t cell, CellSides sides) {
        return LocalGluing(GUSSET_GLUING_CELL, cell, static_cast<uint32_t>(sides));
    }
    /// Opposite corners of a cell.
    static LocalGluing diagonal(uint32_t cell, Diagonal corners) {
        return LocalGluing(GUSSET_GLUING_DIAGONAL, cell, static_cast<uint32_t>(corners));
    }
    /// Two runs of nodes.
    static LocalGluing along(const Seam &seam) {
        LocalGluing made(GUSSET_GLUING_SEAM, 0, 0);
        made.seam = seam;
        return made;
    }
    /// At a node, or at a cell from GluingType::top_bottom on.
    static LocalGluing of_type(GluingType type, uint32_t element) {
        return LocalGluing(GUSSET_GLUING_TYPE, element, static_cast<uint32_t>(type));
    }

private:
    LocalGluing(gusset_gluing_kind kind_, uint32_t element_, uint32_t mask_) : gusset_gluing{} {
        kind = kind_;
        element = element_;
        mask = mask_;
    }
};
static_assert(sizeof(LocalGluing) == sizeof(gusset_gluing), "nothing added");

/// How many nodes, and how many cells, have each local gluing, by GluingType; see gusset_net_histogram.
struct Histogram {
    /// How many nodes, and how many cells, have each type.
    std::array<uint64_t, 18> nodes, cells;
};

/// One coordinate of all nodes of a net, in somebody else's memory.
template <class T>
class MatrixView {
public:
    /// rows x columns numbers; stride: numbers from row to row.
    MatrixView(T *data, std::size_t rows, std::size_t columns, std::size_t stride)
        : data_(data), rows_(rows), columns_(columns), stride_(stride) {}

    /// The rows of nodes.
    std::size_t rows() const noexcept { return rows_; }
    /// The columns of nodes.
    std::size_t columns() const noexcept { return columns_; }
    /// Numbers from row to row.
    std::size_t stride() const noexcept { return stride_; }
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
struct Coordinates {
    /// The three matrices.
    MatrixView<T> x, y, z;
};

/// The unit normals of all nodes, row after row.
template <class T>
struct Normals {
    /// The coordinates of the normals, row after row.
    std::vector<T> x, y, z;
    /// How many nodes have none, and get zeros.
    uint64_t without = 0;
};

/// A direction within a net.
enum class Direction : uint32_t { right = GUSSET_DIRECTION_RIGHT, down = GUSSET_DIRECTION_DOWN };

/// Which rows, or columns, are replicated; see the constants.
enum class Replicate : uint32_t {
    uniform = GUSSET_REPLICATE_UNIFORM,
    first = GUSSET_REPLICATE_FIRST,
    last = GUSSET_REPLICATE_LAST,
    at = GUSSET_REPLICATE_AT,
    at_poles = GUSSET_REPLICATE_AT_POLES,
    /// For JoinOptions only.
    refuse = GUSSET_REPLICATE_REFUSE
};

/// How a net is reformatted; see gusset_reformat_options.
struct ReformatOptions {
    /// 0: as many as there are.
    std::size_t rows = 0, columns = 0;
    /// Which rows, and which columns, are replicated.
    Replicate row_replication = Replicate::uniform, column_replication = Replicate::uniform;
    /// Read for Replicate::at.
    uint32_t row_index = 0, column_index = 0;
};

/// How positions between nodes are found.
enum class Interpolation : uint32_t {
    bicubic = GUSSET_INTERPOLATION_BICUBIC,
    bilinear = GUSSET_INTERPOLATION_BILINEAR
};

/// What is done with the cells between two nets that were joined.
enum class BridgeMode : uint32_t {
    keep = GUSSET_BRIDGE_KEEP,
    hide = GUSSET_BRIDGE_HIDE,
    weld = GUSSET_BRIDGE_WELD
};
/// What a bridge looks like.
enum class BridgeKind : uint32_t {
    ribbon = GUSSET_BRIDGE_RIBBON,
    tube = GUSSET_BRIDGE_TUBE,
    thread = GUSSET_BRIDGE_THREAD
};
/// Kept for the host, and not used.
using BridgeProperties = gusset_bridge_properties;

/// A bridge of a net; see gusset_bridge.
struct Bridge {
    /// Where the second net lies.
    Direction direction;
    /// The first column (right) or row (down) of the second net.
    uint32_t at;
    /// The nodes along the side, from start on and below end.
    uint32_t start, end;
    BridgeKind kind;
    BridgeMode mode;
    BridgeProperties properties;
};

/// How nets are joined; see gusset_join_options.
struct JoinOptions {
    Direction direction = Direction::right;
    BridgeMode mode = BridgeMode::keep;
    /// How far nodes that are welded may be apart.
    double tolerance = 0.0;
    Replicate equalise = Replicate::uniform;
    /// Read for Replicate::at.
    uint32_t equalise_index = 0;
    uint32_t twist = 0;
    /// Nets that are the other way round are flipped; else refused.
    bool turn = false;
    BridgeProperties properties{};
};

/// How plane the cells of a net are; see gusset_net_planarity.
struct Planarity {
    /// The worst, the mean, and how many are above the tolerance.
    gusset_net_planarity_report summary;
    /// Of each cell; NaN for cells that are not there.
    std::vector<double> cells;
};

/// Heights over a grid; see gusset_heights.
struct HeightOptions {
    /// x from column to column, y from row to row.
    std::array<double, 2> spacing{1.0, 1.0};
    /// Where the first node is if its height is 0.
    Point3 origin{};
    /// The number that stands for a missing height.
    std::optional<double> no_data;
    /// Numbers from row to row; 0: rows without gaps.
    std::size_t row_stride = 0;
};

namespace detail {
inline gusset_reformat_options as_c(const ReformatOptions &options) {
    gusset_reformat_options given{};
    given.struct_size = sizeof given;
    given.rows = options.rows;
    given.columns = options.columns;
    given.row_replication = static_cast<gusset_replication>(options.row_replication);
    given.column_replication = static_cast<gusset_replication>(options.column_replication);
    given.row_index = options.row_index;
    given.column_index = options.column_index;
    return given;
}
inline gusset_join_options as_c(const JoinOptions &options) {
    gusset_join_options given{};
    given.struct_size = sizeof given;
    given.tolerance = options.tolerance;
    given.properties = options.properties;
    given.direction = static_cast<gusset_direction>(options.direction);
    given.mode = static_cast<gusset_bridge_mode>(options.mode);
    given.equalise = static_cast<gusset_replication>(options.equalise);
    given.equalise_index = options.equalise_index;
    given.twist = options.twist;
    given.turn = options.turn ? 1 : 0;
    return given;
}
/// A stride of numbers in bytes; one that is too large stays too large.
template <class T>
std::size_t stride_in_bytes(std::size_t stride) {
    return stride > std::numeric_limits<std::size_t>::max() / sizeof(T) ? std::numeric_limits<std::size_t>::max()
                                                                        : stride * sizeof(T);
}
/// What a function writes that tells how much it wants to write: `function(out, capacity, &written)`.
template <class T, class Function>
std::vector<T> filled(Function &&function) {
    std::size_t count = 0;
    function(static_cast<T *>(nullptr), std::size_t{0}, &count);
    std::vector<T> out(count);
    if (count != 0) {
        function(out.data(), count, &count);
    }
    return out;
}
} // namespace detail

} // namespace gusset

#endif // GUSSET_NET_TYPES_HPP
