//! What lies between two nets that were joined.

use super::{Shape, Topology};
use std::sync::Arc;

/// Which way nets lie beside each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Direction {
    /// The second net is right of the first: columns are appended.
    Right,
    /// The second net is below the first: rows are appended.
    Down,
}

impl Direction {
    /// Rows and columns exchanged.
    #[must_use]
    pub fn transposed(self) -> Self {
        match self {
            Direction::Right => Direction::Down,
            Direction::Down => Direction::Right,
        }
    }

    /// The nodes of a net in this direction, and across it: along a side that is joined.
    pub(crate) fn extent(self, shape: Shape) -> (usize, usize) {
        match self {
            Direction::Right => (shape.columns(), shape.rows()),
            Direction::Down => (shape.rows(), shape.columns()),
        }
    }
}

/// What a bridge looks like.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BridgeKind {
    /// A band between open sides.
    Ribbon,
    /// A band between closed sides, which is closed itself.
    Tube,
    /// One edge between sides that are a point each.
    Thread,
}

/// What is done with the cells of a bridge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum BridgeMode {
    /// They are cells like others.
    #[default]
    Keep,
    /// They are not there: the two nets are separate.
    Hide,
    /// The two sides coincide and are one: the links between them are contracted.
    Weld,
}

/// The physical properties that a host gives a bridge (paper, "tension, elasticity, stiffness"): kept, and not used.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BridgeProperties {
    /// Tension.
    pub tension: f64,
    /// Elasticity.
    pub elasticity: f64,
    /// Stiffness.
    pub stiffness: f64,
    /// The host's own.
    pub user: u64,
}

/// What was done to a net before it was joined to another, for that to be undone when they are taken apart.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Origin {
    /// The size it was joined with; a part of any other size is not this net any more.
    pub(crate) joined: Shape,
    /// Its faces were taken the other way round: its rows were flipped, first of all.
    pub(crate) flipped: bool,
    /// Its rows (or columns, across the direction) were replicated: those of `joined` that are copies.
    pub(crate) copies: Vec<u32>,
    /// It was turned by so many places along its closed side, last of all.
    pub(crate) twist: u32,
    /// Its topology before all that.
    pub(crate) topology: Topology,
    /// Its own bridges before all that.
    pub(crate) bridges: Vec<Bridge>,
}

/// The row or column of cells between two nets that were joined, and what it takes to take them apart again.
#[derive(Debug, Clone, PartialEq)]
pub struct Bridge {
    /// Which way the second net lies.
    pub direction: Direction,
    /// The first row or column of the second net: the bridge is the cells between it and the one before.
    pub at: u32,
    /// The first node along the side: more than 0 in a net within a larger one.
    pub start: u32,
    /// One past the last node along the side.
    pub end: u32,
    /// What it looks like.
    pub kind: BridgeKind,
    /// What is done with it.
    pub mode: BridgeMode,
    /// The host's.
    pub properties: BridgeProperties,
    /// What was done to the first net and to the second, if anything.
    pub(crate) origins: [Option<Arc<Origin>>; 2],
    /// How often the net was joined to others since: what was joined last is taken apart first.
    pub(crate) nesting: u32,
}

impl Bridge {
    /// A bridge along a whole side of `count` nodes.
    pub fn new(direction: Direction, at: u32, count: u32, kind: BridgeKind, mode: BridgeMode) -> Self {
        let (properties, origins) = (BridgeProperties::default(), [None, None]);
        Bridge { direction, at, start: 0, end: count, kind, mode, properties, origins, nesting: 0 }
    }

    /// True if its cells are not there.
    pub fn is_hidden(&self) -> bool {
        self.mode == BridgeMode::Hide
    }

    /// True if the cell at (i, j) is one of its.
    pub fn has_cell(&self, i: usize, j: usize) -> bool {
        let (across, along) = match self.direction {
            Direction::Right => (j, i),
            Direction::Down => (i, j),
        };
        across + 1 == self.at as usize && (self.start as usize..self.end as usize - 1).contains(&along)
    }

    /// True if it runs from side to side of a net of that size, so that it can be taken apart there.
    pub fn is_whole(&self, shape: Shape) -> bool {
        self.start == 0 && self.end as usize == self.direction.extent(shape).1
    }
}
