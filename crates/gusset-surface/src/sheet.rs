//! The kinds of sheets, and a macro that treats them alike.

use super::cells::SheetCells;
use super::patches::SplineOrigin;
use super::{Grid, Jet, Patches};
use glam::DVec3;

/// A piece of surface with rows and columns of cells. Copies share their nodes.
#[derive(Debug, Clone)]
pub enum Sheet<'a> {
    /// The surface through a grid of nodes.
    Grid(Grid<'a>),
    /// Bézier patches of degree 3 or less.
    Cubic(Patches<4>),
    /// Bézier patches of degree 7 or less.
    High(Patches<8>),
}

/// Runs the same code for a sheet of any kind: `each_sheet!(sheet, cells => body)`.
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
        each_sheet!(self, cells => cells.cell_counts())
    }

    /// Whether the sheet is closed in u and in v, so that the first line of cells follows the last
    /// one.
    pub fn is_closed(&self) -> [bool; 2] {
        each_sheet!(self, cells => cells.is_closed())
    }

    fn spline_origin(&self) -> Option<&SplineOrigin> {
        match self {
            Sheet::Grid(_) => None,
            Sheet::Cubic(patches) => patches.spline_origin(),
            Sheet::High(patches) => patches.spline_origin(),
        }
    }

    /// A bound of the distance between the sheet and the rational spline that it was converted
    /// from, at equal parameters and including rounding. 0 for all other sheets.
    pub fn deviation(&self) -> f64 {
        self.spline_origin().map_or(0.0, |origin| origin.deviation)
    }

    /// The spline's parameters at the borders of cells in u and in v, for a sheet that was
    /// converted from a spline. Parameters are linear within a cell. `None` for other sheets.
    pub fn knots(&self) -> Option<&[Vec<f64>; 2]> {
        self.spline_origin().map(|origin| &origin.knots)
    }

    /// The corner of cells at (i, j).
    pub fn corner(&self, i: usize, j: usize) -> DVec3 {
        each_sheet!(self, cells => cells.corner_point(i, j))
    }

    /// The position and the derivatives at parameters (u, v) of the cell at (i, j).
    pub fn jet(&self, i: usize, j: usize, u: f64, v: f64) -> Jet {
        each_sheet!(self, cells => SheetCells::cell_patch(cells, i, j).jet(u, v))
    }

    /// Whether the cells on both sides of the line that closes u, or v, share it to the last bit.
    /// True for closed grids; the sides of given patches may differ slightly.
    pub(crate) fn has_exact_seams(&self) -> [bool; 2] {
        if let Sheet::Grid(grid) = self { grid.is_closed() } else { [false; 2] }
    }
}
