// Replication of rows and columns, joins and bridges of nets. Include gusset.hpp, not this.
#ifndef GUSSET_NET_JOIN_HPP
#define GUSSET_NET_JOIN_HPP

#include <gusset/context.hpp>

namespace gusset {

/// The options of a reformat; see gusset_net_copy_options.
struct ReformatOptions {
    /// 0: as many as there are.
    std::size_t rows = 0, columns = 0;
    /// Where added rows and columns come from.
    Replication row_replication = Replication::uniform, column_replication = Replication::uniform;
    /// For Replication::at.
    uint32_t row_index = 0, column_index = 0;
};

/// The properties under which Net::settle finds the equilibrium of a bridge.
using BridgeProperties = gusset_bridge_properties;

/// A bridge of a net; see gusset_bridge.
struct Bridge {
    /// The direction from the first net to the second.
    Direction direction;
    /// The first column (right) or row (down) of the second net.
    uint32_t at;
    /// The nodes along the side: start to end - 1.
    uint32_t start, end;
    BridgeKind kind;
    BridgeMode mode;
    BridgeProperties properties;
    /// The rows (down) or columns of its own, which lie before `at`.
    uint32_t rows;
};

/// The options of joins; see gusset_concatenate_options.
struct ConcatenateOptions {
    Direction direction = Direction::right;
    BridgeMode mode = BridgeMode::keep;
    /// The largest distance of nodes that are welded.
    double tolerance = 0.0;
    Replication equalise = Replication::uniform;
    /// For Replication::at.
    uint32_t equalise_index = 0;
    uint32_t twist = 0;
    /// Nets that run the other way are flipped; else refused.
    bool turn = false;
    BridgeProperties properties{};
    /// The rows or columns of its own that each new bridge has.
    uint32_t rows = 0;
};

namespace detail {
inline gusset_net_copy_options as_c(const ReformatOptions &options) {
    auto given = detail::sized<gusset_net_copy_options>();
    given.rows = options.rows;
    given.columns = options.columns;
    given.row_replication = static_cast<gusset_replication>(options.row_replication);
    given.column_replication = static_cast<gusset_replication>(options.column_replication);
    given.row_index = options.row_index;
    given.column_index = options.column_index;
    return given;
}
inline gusset_concatenate_options as_c(const ConcatenateOptions &options) {
    auto given = detail::sized<gusset_concatenate_options>();
    given.tolerance = options.tolerance;
    given.properties = options.properties;
    given.direction = static_cast<gusset_direction>(options.direction);
    given.mode = static_cast<gusset_bridge_mode>(options.mode);
    given.equalise = static_cast<gusset_replication>(options.equalise);
    given.equalise_index = options.equalise_index;
    given.twist = options.twist;
    given.turn = options.turn ? 1 : 0;
    given.rows = options.rows;
    return given;
}
} // namespace detail

} // namespace gusset

#endif // GUSSET_NET_JOIN_HPP
