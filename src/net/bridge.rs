//! What lies between two nets that were joined.

/// Which way nets lie beside each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Direction {
    /// The second net is right of the first: columns are appended.
    Right,
    /// The second net is below the first: rows are appended.
    Down,
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

/// The row or column of cells between two nets that were joined, and what it takes to take them apart again.
#[derive(Debug, Clone, PartialEq)]
pub struct Bridge {
    /// Which way the second net lies.
    pub direction: Direction,
    /// The first row or column of the second net: the bridge is the cells between it and the one before.
    pub at: u32,
    /// What it looks like.
    pub kind: BridgeKind,
    /// What is done with it.
    pub mode: BridgeMode,
    /// The host's.
    pub properties: BridgeProperties,
}

impl Bridge {
    /// True if its cells are not there.
    pub fn is_hidden(&self) -> bool {
        self.mode == BridgeMode::Hide
    }

    /// True if the cell at (i, j) is one of its.
    pub fn has_cell(&self, i: usize, j: usize) -> bool {
        let before = self.at as usize - 1;
        match self.direction {
            Direction::Right => j == before,
            Direction::Down => i == before,
        }
    }
}
