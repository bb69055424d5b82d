//! The options of joining nets.

use crate::{BridgeMode, BridgeProperties, Direction, Replication};

/// Options of [`concatenate`](super::concatenate).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JoinOptions {
    /// The direction from the first net to the second.
    pub direction: Direction,
    /// The treatment of the cells between them.
    pub mode: BridgeMode,
    /// The largest distance of welded nodes, at least 0.
    pub tolerance: f64,
    /// The replication that enlarges the smaller net if the sides differ in length. `None` makes
    /// such sides an error.
    pub equalise: Option<Replication>,
    /// The rotation of the second net along its closed side: its node `twist` comes first.
    pub twist: u32,
    /// Flips nets along the side if their face orientation is opposite to the first net's. If
    /// false, such nets are an error.
    pub turn: bool,
    /// The physical properties of the bridge.
    pub properties: BridgeProperties,
    /// The number of inner rows or columns of each bridge, evenly spaced on straight lines between
    /// the two sides.
    pub rows: u32,
}

impl JoinOptions {
    /// Returns the defaults: sizes equalised evenly, the bridge kept.
    pub fn new(direction: Direction) -> Self {
        JoinOptions {
            direction,
            mode: BridgeMode::Keep,
            tolerance: 0.0,
            equalise: Some(Replication::Uniform),
            twist: 0,
            turn: false,
            properties: BridgeProperties::default(),
            rows: 0,
        }
    }
}
