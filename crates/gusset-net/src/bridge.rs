//! Bridges: the cells between two nets that were joined (Deryagin, "Concatenation", Figs. 8 and 9).
//! A bridge records how each net was adapted, so that splitting is exact.

use super::{Direction, Shape, Topology};
use gusset_base::choices;
use std::sync::Arc;

/// The form of a bridge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BridgeKind {
    /// A band between open sides.
    Ribbon,
    /// A band between closed sides, which is closed itself.
    Tube,
    /// One edge between two sides that are points.
    Thread,
}

/// The treatment of the cells of a bridge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum BridgeMode {
    /// Ordinary cells.
    #[default]
    Keep,
    /// Absent cells, so that the two nets are separate.
    Hide,
    /// Coincident sides: the links between them are contracted.
    Weld,
}

choices! { for BridgeMode:
    Keep => "Quads", "A row of new quads joins them.";
    Hide => "Nothing", "They are in one mesh, but not joined.";
    Weld => "Weld", "Their coincident sides are merged.";
}

/// The physical properties of a bridge (Deryagin, "tension, elasticity, stiffness"), under which
/// [`settle`](super::settle()) finds its equilibrium. Lengths are in the unit of the coordinates,
/// forces in any unit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BridgeProperties {
    /// Tension: a force in each line across a thread or a ribbon, a force per length in a tube.
    pub tension: f64,
    /// Elasticity: the force that doubles the length of a line across; at least 0.
    pub elasticity: f64,
    /// Stiffness against bending, force times squared length, for each line across. If it is
    /// infinite, the bridge is rigid.
    pub stiffness: f64,
    /// A value for the host's own use.
    pub user: u64,
}

/// The adaptation of a net before it was joined, from which splitting restores it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct NetAdaptation {
    /// The size at which it was joined. A part of any other size is not this net any more.
    pub(crate) joined_shape: Shape,
    /// Step 1: whether its rows were flipped, because its faces had the opposite orientation.
    pub(crate) flipped: bool,
    /// Step 2: the rows of `joined_shape` (or columns, across the direction) that are copies.
    pub(crate) copies: Vec<u32>,
    /// Step 3: the number of places by which it was rotated along its closed side.
    pub(crate) twist: u32,
    /// The topology before the adaptation.
    pub(crate) topology: Topology,
    /// The bridges before the adaptation.
    pub(crate) bridges: Vec<Bridge>,
}

impl Drop for NetAdaptation {
    /// Frees nested records iteratively, so that their depth does not matter.
    fn drop(&mut self) {
        let mut open: Vec<Bridge> = std::mem::take(&mut self.bridges);
        while let Some(mut bridge) = open.pop() {
            for mut record in bridge.adaptations.iter_mut().filter_map(|record| Arc::into_inner(record.take()?)) {
                open.append(&mut record.bridges);
            }
        }
    }
}

/// The cells between two nets that were joined, with all data that splitting needs.
///
/// Invariant: `at > rows`. The sides are rows (`Down`) or columns `at - rows - 1` and `at`. Between
/// them lie the bridge's own `rows` inner rows or columns.
#[derive(Debug, Clone, PartialEq)]
pub struct Bridge {
    /// The direction from the first net to the second.
    pub direction: Direction,
    /// The first row or column of the second net, which follows the cells of the bridge.
    pub at: u32,
    /// The inner rows or columns of nodes, which belong to neither net.
    pub rows: u32,
    /// The first node along the side: more than 0 in a net within a larger one.
    pub start: u32,
    /// One past the last node along the side.
    pub end: u32,
    /// The form.
    pub kind: BridgeKind,
    /// The treatment of its cells.
    pub mode: BridgeMode,
    /// Physical properties.
    pub properties: BridgeProperties,
    /// The adaptations of the first net and of the second, if any.
    pub(crate) adaptations: [Option<Arc<NetAdaptation>>; 2],
    /// The number of times the net was joined since; the newest bridge is split first.
    pub(crate) nesting: u32,
}

impl Bridge {
    /// Returns a bridge along a whole side of `count` nodes.
    pub fn new(direction: Direction, at: u32, count: u32, kind: BridgeKind, mode: BridgeMode) -> Self {
        let (properties, adaptations) = (BridgeProperties::default(), [None, None]);
        Bridge { direction, at, rows: 0, start: 0, end: count, kind, mode, properties, adaptations, nesting: 0 }
    }

    /// Returns true if its cells are absent.
    pub fn is_hidden(&self) -> bool {
        self.mode == BridgeMode::Hide
    }

    /// Returns the last row or column of the first net.
    pub(crate) fn last_line_of_first_net(&self) -> u32 {
        self.at - self.rows - 1
    }

    /// Returns true if it runs from side to side of a net of the given size, so that the net can be
    /// split there.
    pub fn spans_net_from_side_to_side(&self, shape: Shape) -> bool {
        self.start == 0 && self.end as usize == self.direction.line_count_and_length(shape).1
    }
}
