/// @file
/// Replication of rows and columns, joins and bridges of nets. Include gusset.hpp, not this.
#ifndef GUSSET_NET_JOIN_HPP
#define GUSSET_NET_JOIN_HPP

#include <gusset/context.hpp>

namespace gusset {

/// The properties under which Net::settle finds the equilibrium of a bridge.
using BridgeProperties = gusset_bridge_properties;

/// A bridge of a net; see gusset_bridge.
struct Bridge {
    /// The direction from the first net to the second.
    Direction direction;
    /// The first column (right) or row (down) of the second net.
    uint32_t at;
    /// The first node along the side.
    uint32_t start;
    /// One past the last node along the side.
    uint32_t end;
    /// See ::gusset_bridge::kind.
    BridgeKind kind;
    /// See ::gusset_bridge::mode.
    BridgeMode mode;
    /// See ::gusset_bridge::properties.
    BridgeProperties properties;
    /// The rows (down) or columns of its own, which lie before `at`.
    uint32_t rows;
};

} // namespace gusset

#endif // GUSSET_NET_JOIN_HPP
