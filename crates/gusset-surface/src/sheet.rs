//! The kinds of sheets, and the macro that treats them alike.

use super::cells::Cells;
use super::patches::Origin;
use super::{Grid, Jet, Patches};
use glam::DVec3;

/// A piece of surface with rows and columns of cells. Copies share their nodes.
#[derive(Debug, Clone)]
pub enum Sheet<'a> {
    /// Through a grid of nodes.
    Grid(Grid<'a>),
    /// Patches of degree 3 at most.
    Cubic(Patches<4>),
    /// Patches of degree 7 at most.
    High(Patches<8>),
}

/// Does the same with sheets of any kind: `each_sheet!(sheet, cells => body)`.
macro_rules! each_sheet {
    ($sheet:expr, $cells:ident => $body:expr) => {
        match $sheet {
            $crate::Sheet::Grid($cells) => $body,
            $crate::Sheet::Cubic($cells) => $body,
            $crate::Sheet::High($cells) => $body,
        }
    };
}
pub(crate) use each_sheet;

impl Sheet<'_> {
    /// The numbers of cells in u and in v.
    pub fn cells(&self) -> [usize; 2] {
        each_sheet!(self, cells => cells.counts())
    }

    /// Whether it is closed in u and in v: the first line of nodes follows on the last but one.
    pub fn is_closed(&self) -> [bool; 2] {
        each_sheet!(self, cells => cells.is_closed())
    }

    fn origin(&self) -> Option<&Origin> {
        match self {
            Sheet::Grid(_) => None,
            Sheet::Cubic(patches) => patches.origin(),
            Sheet::High(patches) => patches.origin(),
        }
    }

    /// A bound of how far the sheet is from the rational spline that it was made of, at equal
    /// parameters; rounding is in it. 0 for all other sheets.
    pub fn deviation(&self) -> f64 {
        self.origin().map_or(0.0, |origin| origin.deviation)
    }

    /// The parameters of a spline at the borders of the cells that were made of it, in u and in v;
    /// between them they run evenly. `None` for sheets that were not made of a spline.
    pub fn knots(&self) -> Option<&[Vec<f64>; 2]> {
        self.origin().map(|origin| &origin.knots)
    }

    /// The corner of cells at (i, j).
    pub fn corner(&self, i: usize, j: usize) -> DVec3 {
        each_sheet!(self, cells => cells.corner(i, j))
    }

    /// The position and the derivatives at parameters (u, v) of the cell at (i, j).
    pub fn jet(&self, i: usize, j: usize, u: f64, v: f64) -> Jet {
        each_sheet!(self, cells => Cells::patch(cells, i, j).jet(u, v))
    }

    /// Whether the cells on both sides of the line that closes u, or v, share it to the bit: of
    /// grids. The sides of patches that are given may differ a little.
    pub(crate) fn seams(&self) -> [bool; 2] {
        if let Sheet::Grid(grid) = self { grid.is_closed() } else { [false; 2] }
    }
}
