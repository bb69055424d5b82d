/// @file
/// Gluing of nets. Include gusset.hpp, not this.
#ifndef GUSSET_NET_GLUING_HPP
#define GUSSET_NET_GLUING_HPP

#include <gusset/context.hpp>
#include <gusset/net_options.hpp>

namespace gusset {

/// The gluing of the four sides of a net; combine with |.
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

/// The gluing of a net; see gusset_net_gluing.
struct Gluing {
    /// No gluing.
    Gluing() = default;
    /// By sides.
    Gluing(Sides given) : sides(given) {}
    /// By seams.
    explicit Gluing(std::vector<Seam> given) : seams(std::move(given)) {}

    /// The four sides.
    Sides sides = Sides::sheet;
    /// 2 * rows rows of columns bytes, 0 or 1; empty: sides and seams say it all.
    std::vector<uint8_t> matrix;
    /// Runs of nodes glued to runs of nodes, besides.
    std::vector<Seam> seams;
    /// The orientation of faces is reversed.
    bool reversed = false;
};

namespace detail {
/// A gluing as C takes it, for a net of as many rows and columns as a view.
inline gusset_net_gluing as_c(const Gluing &gluing, const gusset_net_view &view) {
    const std::size_t bytes = gluing.matrix.size();
    if (bytes != 0 && (view.columns == 0 || bytes / 2 / view.columns < view.rows)) {
        detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "the characteristic matrix has 2 * rows * columns bytes");
    }
    auto given = sized<gusset_net_gluing>();
    given.matrix = gluing.matrix.empty() ? nullptr : gluing.matrix.data();
    given.seams = gluing.seams.data();
    given.seam_count = gluing.seams.size();
    given.sides = static_cast<gusset_sides>(gluing.sides);
    given.reversed = gluing.reversed ? 1 : 0;
    return given;
}
} // namespace detail

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

/// Nodes to be glued or unglued; see gusset_gluing.
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
static_assert(sizeof(LocalGluing) == sizeof(gusset_gluing), "a gluing is what C takes");

/// A local gluing of a net, with its letters and orders; see gusset_gluing_occurrence.
using GluingOccurrence = gusset_gluing_occurrence;

/// The numbers of nodes and of cells of each local gluing, by GluingType; see gusset_net_histogram.
struct GluingHistogram {
    /// The number of nodes of each type.
    std::array<uint64_t, 18> nodes;
    /// The number of cells of each type.
    std::array<uint64_t, 18> cells;
};

} // namespace gusset

#endif // GUSSET_NET_GLUING_HPP
