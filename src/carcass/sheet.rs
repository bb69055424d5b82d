//! The kinds of sheets.

use super::cells::Cells;
use super::{Grid, Jet, Patch, Patches};
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
            $crate::carcass::Sheet::Grid($cells) => $body,
            $crate::carcass::Sheet::Cubic($cells) => $body,
            $crate::carcass::Sheet::High($cells) => $body,
        }
    };
}
pub(crate) use each_sheet;

impl Sheet<'_> {
    /// The numbers of cells in u and in v.
    pub fn cells(&self) -> [usize; 2] {
        each_sheet!(self, cells => cells.counts())
    }

    /// The corner of cells at (i, j).
    pub fn corner(&self, i: usize, j: usize) -> DVec3 {
        each_sheet!(self, cells => cells.corner(i, j))
    }

    /// The position and the derivatives at parameters (u, v) of the cell at (i, j).
    pub fn jet(&self, i: usize, j: usize, u: f64, v: f64) -> Jet {
        fn of<const N: usize>(patch: &Patch<N>, u: f64, v: f64) -> Jet {
            patch.jet(u, v)
        }
        each_sheet!(self, cells => of(&Cells::patch(cells, i, j), u, v))
    }

    /// The unit normal, S_u x S_v, at parameters (u, v) of the cell at (i, j), or its limit where a side of the cell is one point; 0 if there is
    /// none.
    pub fn normal(&self, i: usize, j: usize, u: f64, v: f64) -> DVec3 {
        let here = self.jet(i, j, u, v);
        let regular =
            |jet: &Jet| jet.normal().length_squared() > 1e-20 * jet.u.length_squared() * jet.v.length_squared();
        if regular(&here) {
            return here.normal().normalize_or_zero();
        }
        // A little inwards.
        let inwards = |x: f64| x + 1e-4 * (0.5 - x).signum();
        self.jet(i, j, inwards(u), inwards(v)).normal().normalize_or_zero()
    }
}
