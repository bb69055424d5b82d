/// @file
/// The options of gusset/net.h. Where a comment says NULL, an empty list or options without changes are meant.
/// Generated from src/capi; do not edit. Include gusset.hpp, not this.
#ifndef GUSSET_NET_OPTIONS_HPP
#define GUSSET_NET_OPTIONS_HPP

#include <gusset/span.hpp>

namespace gusset {

/// Options of gusset_net_glue. See ::gusset_glue_options.
struct GlueOptions {
    /// For detect: largest distance of coincident nodes.
    double tolerance = 0.0;
    /// Gluings to add.
    std::vector<gusset_gluing> gluings;
    /// Links to contract, as in gusset_net_analysis_view.
    std::vector<uint32_t> links;
    /// 1: replaces the gluing by the one that coordinates imply: coincident neighbours, and coincident runs of two or
    /// more side nodes in either direction. The orientation stays.
    bool detect = false;
    /// 1: contracts links with ends in one point, and drops redundant seams; detect implies it. Nets that glue equal
    /// neighbours then have equal matrices.
    bool saturate = false;
    /// 1: moves a point's nodes to its first, bit for bit.
    bool snap = false;
};

/// Options of gusset_net_to_mesh. See ::gusset_net_mesh_options.
struct NetMeshOptions {
    /// Faces of a net's mesh.
    NetFaces faces = NetFaces::quads;
    /// 1: a vertex for each node; 0: glued nodes are one.
    bool no_weld = false;
    /// 1: keeps finite vertices without faces and wires.
    bool keep_unused = false;
    /// 1: a cell with exactly one missing corner becomes a triangle.
    bool fill_corners = false;
    /// 1: computes texture coordinates.
    bool texture = false;
    /// Omits faces with edges above this multiple of the median edge; 0: no limit. 4 removes depth jumps from range
    /// images.
    double max_edge_ratio = 0.0;
};

/// Options of gusset_net_from_mesh_create. See ::gusset_net_grid_options.
struct NetGridOptions {
    /// Faces of a cell of the given grid.
    GridCells cells = GridCells::quads;
    /// Face of the component. A value sets has_face of C to 1; empty: 0.
    std::optional<uint32_t> face;
};

/// Options of gusset_net_copy_create. See ::gusset_net_copy_options.
struct NetCopyOptions {
    /// First row of the part.
    std::size_t row_first = 0;
    /// Rows of the part, at least 2; 0: the rest.
    std::size_t row_count = 0;
    /// First column of the part.
    std::size_t column_first = 0;
    /// Columns of the part, at least 2; 0: the rest.
    std::size_t column_count = 0;
    /// Rows after replication, at least the present; 0: none. Links between copies are contracted.
    std::size_t rows = 0;
    /// Columns after replication, likewise.
    std::size_t columns = 0;
    /// 1: removes rows and columns that repeat the previous: equal coordinates and links, contracted links between. Two
    /// of each and ends of bridges stay.
    bool compact = false;
    /// For rows.
    Replication row_replication = Replication::uniform;
    /// For columns.
    Replication column_replication = Replication::uniform;
    /// Row to replicate. A value sets row_replication to GUSSET_REPLICATE_AT.
    std::optional<uint32_t> row_index;
    /// Column to replicate. A value sets column_replication to GUSSET_REPLICATE_AT.
    std::optional<uint32_t> column_index;
    /// Symmetry.
    NetTurn turn = NetTurn::none;
    /// 0: unchanged. Conversion to float rounds; overflowing nodes become missing.
    Scalar scalar{};
};

/// Options of gusset_net_concatenate_create. See ::gusset_concatenate_options.
struct ConcatenateOptions {
    /// For welding: largest distance of coincident nodes.
    double tolerance = 0.0;
    /// Properties of every new bridge.
    gusset_bridge_properties properties{};
    /// Direction from each net to the next.
    Direction direction = Direction::right;
    /// Treatment of the cells of a bridge.
    BridgeMode mode = BridgeMode::keep;
    /// For nets with fewer nodes along the side.
    Replication equalise = Replication::uniform;
    /// Row or column to replicate. A value sets equalise to GUSSET_REPLICATE_AT.
    std::optional<uint32_t> equalise_index;
    /// Rotation of each later net along its closed side, in nodes.
    uint32_t twist = 0;
    /// 1: flips nets along the side if oriented unlike the first; 0: refuses them.
    bool turn = false;
    /// Inner rows or columns of new bridges, even on lines; 0 for GUSSET_BRIDGE_WELD.
    uint32_t rows = 0;
};

/// Deformation; default: none. See ::gusset_net_analysis_options.
struct NetAnalysisOptions {
    /// Deformed net of equal size; NULL: see fields.
    const gusset_net *after = nullptr;
    /// As for gusset_net_deform.
    std::vector<gusset_field> fields;
    /// As for gusset_net_deform.
    double time = 0.0;
    /// Lengths up to it count as 0.
    double tolerance = 0.0;
};

/// Options of gusset_net_planarise. See ::gusset_planarise_options.
struct PlanariseOptions {
    /// Distance of corners from their mean plane, relative to the box diagonal; 0: 1e-10, float: 4e-7.
    double tolerance = 0.0;
    /// For each node, 1: it stays with all nodes glued to it. NULL: all may move.
    std::vector<uint8_t> fixed;
    /// Most steps; 0: 100.
    uint32_t max_iterations = 0;
    /// 1: boundary vertices of the surface stay.
    bool keep_boundary = false;
};

/// Options of gusset_net_settle. See ::gusset_settle_options.
struct SettleOptions {
    /// Largest displacement in the last step, relative to the box diagonal; 0: 1e-12.
    double tolerance = 0.0;
    /// Ratio of rest lengths to lengths in the reference, above 0; 0: 1.
    double rest_ratio = 0.0;
    /// Net of equal size for rest lengths and shapes of rigid bridges; NULL: itself.
    const gusset_net *reference = nullptr;
    /// For each part between bridges: 1 moves it as a rigid body, 0 holds it. NULL holds all.
    std::vector<uint8_t> free;
    /// Most steps; 0: 1000.
    uint32_t max_iterations = 0;
};

namespace detail {
inline gusset_glue_options as_c(const GlueOptions &options) {
    auto given = sized<gusset_glue_options>();
    given.tolerance = options.tolerance;
    given.gluings = first(options.gluings);
    given.gluing_count = options.gluings.size();
    given.links = first(options.links);
    given.link_count = options.links.size();
    given.detect = options.detect ? 1 : 0;
    given.saturate = options.saturate ? 1 : 0;
    given.snap = options.snap ? 1 : 0;
    return given;
}
gusset_glue_options as_c(const GlueOptions &&) = delete;

inline gusset_net_mesh_options as_c(const NetMeshOptions &options) {
    auto given = sized<gusset_net_mesh_options>();
    given.faces = static_cast<gusset_net_faces>(options.faces);
    given.no_weld = options.no_weld ? 1 : 0;
    given.keep_unused = options.keep_unused ? 1 : 0;
    given.fill_corners = options.fill_corners ? 1 : 0;
    given.texture = options.texture ? 1 : 0;
    given.max_edge_ratio = options.max_edge_ratio;
    return given;
}

inline gusset_net_grid_options as_c(const NetGridOptions &options) {
    auto given = sized<gusset_net_grid_options>();
    given.cells = static_cast<gusset_grid_cells>(options.cells);
    if (options.face) {
        given.face = *options.face;
        given.has_face = 1;
    }
    return given;
}

inline gusset_net_copy_options as_c(const NetCopyOptions &options) {
    auto given = sized<gusset_net_copy_options>();
    given.row_first = options.row_first;
    given.row_count = options.row_count;
    given.column_first = options.column_first;
    given.column_count = options.column_count;
    given.rows = options.rows;
    given.columns = options.columns;
    given.compact = options.compact ? 1 : 0;
    given.row_replication = static_cast<gusset_replication>(options.row_replication);
    given.column_replication = static_cast<gusset_replication>(options.column_replication);
    given.turn = static_cast<gusset_net_turn>(options.turn);
    given.scalar = static_cast<gusset_scalar>(options.scalar);
    if (options.row_index) {
        given.row_index = *options.row_index;
        given.row_replication = GUSSET_REPLICATE_AT;
    }
    if (options.column_index) {
        given.column_index = *options.column_index;
        given.column_replication = GUSSET_REPLICATE_AT;
    }
    return given;
}

inline gusset_concatenate_options as_c(const ConcatenateOptions &options) {
    auto given = sized<gusset_concatenate_options>();
    given.tolerance = options.tolerance;
    given.properties = options.properties;
    given.direction = static_cast<gusset_direction>(options.direction);
    given.mode = static_cast<gusset_bridge_mode>(options.mode);
    given.equalise = static_cast<gusset_replication>(options.equalise);
    given.twist = options.twist;
    given.turn = options.turn ? 1 : 0;
    given.rows = options.rows;
    if (options.equalise_index) {
        given.equalise_index = *options.equalise_index;
        given.equalise = GUSSET_REPLICATE_AT;
    }
    return given;
}

inline gusset_net_analysis_options as_c(const NetAnalysisOptions &options) {
    auto given = sized<gusset_net_analysis_options>();
    given.after = options.after;
    given.fields = first(options.fields);
    given.field_count = options.fields.size();
    given.time = options.time;
    given.tolerance = options.tolerance;
    return given;
}
gusset_net_analysis_options as_c(const NetAnalysisOptions &&) = delete;

inline gusset_planarise_options as_c(const PlanariseOptions &options) {
    auto given = sized<gusset_planarise_options>();
    given.tolerance = options.tolerance;
    given.fixed = first(options.fixed);
    given.fixed_count = options.fixed.size();
    given.max_iterations = options.max_iterations;
    given.keep_boundary = options.keep_boundary ? 1 : 0;
    return given;
}
gusset_planarise_options as_c(const PlanariseOptions &&) = delete;

inline gusset_settle_options as_c(const SettleOptions &options) {
    auto given = sized<gusset_settle_options>();
    given.tolerance = options.tolerance;
    given.rest_ratio = options.rest_ratio;
    given.reference = options.reference;
    given.free = first(options.free);
    given.free_count = options.free.size();
    given.max_iterations = options.max_iterations;
    return given;
}
gusset_settle_options as_c(const SettleOptions &&) = delete;
} // namespace detail

} // namespace gusset

#endif // GUSSET_NET_OPTIONS_HPP
