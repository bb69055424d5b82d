//! Closures that the four sides of a net describe completely (Deryagin, Fig. 5: tube, two poles,
//! one pole, torus). O(1) memory; the contracted links lie at the sides.

use crate::Shape;

/// The closure of each of the four sides of a net: each flag contracts a set of links, see
/// [`Sides::is_contracted`].
///
/// The paper's closures (Fig. 5) are among the combinations, and so are partly closed nets, such as
/// a cone with an open base.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Sides {
    /// Every row is closed: its last node repeats its first.
    pub rows_closed: bool,
    /// Every column is closed.
    pub columns_closed: bool,
    /// The first row is a single point.
    pub pole_top: bool,
    /// The last row is a single point.
    pub pole_bottom: bool,
    /// The first column is a single point.
    pub pole_left: bool,
    /// The last column is a single point.
    pub pole_right: bool,
}

impl Sides {
    /// Open on all sides.
    pub const SHEET: Sides = Sides {
        rows_closed: false,
        columns_closed: false,
        pole_top: false,
        pole_bottom: false,
        pole_left: false,
        pole_right: false,
    };
    /// Rows closed; the first and the last row are rims.
    pub const TUBE: Sides = Sides { rows_closed: true, ..Sides::SHEET };
    /// Rows closed, and the first and the last row contracted to points: spheres, and cylinders,
    /// prisms, cones and pyramids with their caps.
    pub const TWO_POLES: Sides = Sides { pole_top: true, pole_bottom: true, ..Sides::TUBE };
    /// All four sides contracted to one point: a disc with its rim contracted.
    pub const ONE_POLE: Sides =
        Sides { pole_top: true, pole_bottom: true, pole_left: true, pole_right: true, ..Sides::SHEET };
    /// Rows and columns closed.
    pub const TORUS: Sides = Sides { columns_closed: true, ..Sides::TUBE };

    /// Returns true if the link is contracted.
    pub fn is_contracted(self, shape: Shape, link: u32) -> bool {
        let (i, j) = shape.row_and_column(link / 2);
        let (last_row, last_column) = (i + 1 == shape.rows(), j + 1 == shape.columns());
        match (link & 1 == 0, last_column, last_row) {
            (true, true, _) => self.rows_closed,
            (true, false, _) => (i == 0 && self.pole_top) || (last_row && self.pole_bottom),
            (false, _, true) => self.columns_closed,
            (false, _, false) => (j == 0 && self.pole_left) || (last_column && self.pole_right),
        }
    }

    /// Rows and columns exchanged.
    #[must_use]
    pub fn transposed(self) -> Self {
        Sides {
            rows_closed: self.columns_closed,
            columns_closed: self.rows_closed,
            pole_top: self.pole_left,
            pole_bottom: self.pole_right,
            pole_left: self.pole_top,
            pole_right: self.pole_bottom,
        }
    }

    /// Returns the contracted links, each once, only at the sides: O(H + W) of them.
    pub(crate) fn contracted_links(self, shape: Shape) -> impl Iterator<Item = u32> {
        let (h, w) = (shape.rows(), shape.columns());
        let when = |condition: bool, count: usize| 0..if condition { count } else { 0 };
        when(self.rows_closed, h)
            .map(move |i| shape.horizontal_link(i, w - 1))
            .chain(when(self.columns_closed, w).map(move |j| shape.vertical_link(h - 1, j)))
            .chain(when(self.pole_top, w - 1).map(move |j| shape.horizontal_link(0, j)))
            .chain(when(self.pole_bottom, w - 1).map(move |j| shape.horizontal_link(h - 1, j)))
            .chain(when(self.pole_left, h - 1).map(move |i| shape.vertical_link(i, 0)))
            .chain(when(self.pole_right, h - 1).map(move |i| shape.vertical_link(i, w - 1)))
    }
}
