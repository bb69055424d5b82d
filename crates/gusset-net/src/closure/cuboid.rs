//! Three closures of a box, including the cube of Deryagin's Fig. 6.
//!
//! A vertex of a box has the total angle 3 pi / 2, an odd multiple of a right angle, which only a
//! corner of the net provides. A net has four corners and a box eight vertices, so some cells must
//! degenerate. All three closures wrap a closed band of rows around the four lateral faces, and
//! differ in the rows that cover the two caps. Invariant: the place of a node on the box is a
//! function of its row and column, and links between equal places are contracted. O(nodes).

use crate::topology::{ContractedLinks, LinkMatrix, Seam, SeamRun};
use crate::{Shape, Sides, Topology};
use gusset_base::error::{Error, Result};

/// The covering of the caps of a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum BoxKind {
    /// Two opposite sides of the cap's rim sweep over it until they meet in a slit, which then
    /// closes from both ends. All faces are unit quads, and all vertices except the eight corners
    /// have four edges. The characteristic matrix suffices.
    #[default]
    Slit,
    /// The paper's cross unwrapping: one block of the net is the cap, and the three other blocks
    /// contract to its sides. All faces are unit quads. The last row of each cap is a [`Seam`].
    Cross,
    /// Concentric rings. It has the fewest nodes. Cells on the diagonals of the caps are split into
    /// two triangles.
    Concentric,
}

/// A box of `cells` unit cells in x, y and z as a net.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Cuboid {
    /// How both caps, at the ends of z, are covered.
    pub kind: BoxKind,
    /// The number of cells along x, y and z; each at least 1.
    pub cells: [u32; 3],
}

impl Cuboid {
    /// Returns a cube.
    pub fn cube(kind: BoxKind, cells: u32) -> Self {
        Cuboid { kind, cells: [cells; 3] }
    }

    /// Returns the size of the net.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] (no cells), [`Error::TooLarge`].
    pub fn shape(&self) -> Result<Shape> {
        Error::require(!self.cells.contains(&0), "cells", 0.0, "at least 1")?;
        let [a, b, c] = self.cells.map(|n| n as usize);
        Shape::new(c + 1 + 2 * self.cap_row_count(), 2 * (a + b) + 1)
    }

    /// Returns the number of rows beyond the lateral faces at each end.
    fn cap_row_count(&self) -> usize {
        let [a, b, _] = self.cells.map(|n| n as usize);
        match self.kind {
            BoxKind::Slit => a.div_ceil(2) + b.div_ceil(2),
            BoxKind::Cross => b,
            BoxKind::Concentric => a.div_ceil(2).max(b.div_ceil(2)),
        }
    }

    /// Returns the gluing.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] (no cells), [`Error::TooLarge`], [`Error::OutOfMemory`].
    pub fn topology(&self) -> Result<Topology> {
        let shape = self.shape()?;
        let (h, w) = (shape.rows(), shape.columns());
        let mut matrix = LinkMatrix::from_sides(shape, Sides::TUBE)?;
        for i in
            (0..h).filter(|&i| i == 0 || self.height_of_row(i) == self.height_of_row(i - 1) || self.depth_in_cap(i) > 0)
        {
            for j in 0..w {
                let here = self.lattice_point(i, j);
                if j + 1 < w && here == self.lattice_point(i, j + 1) {
                    matrix.set_contracted(shape.horizontal_link(i, j), true);
                }
                if i > 0 && here == self.lattice_point(i - 1, j) {
                    matrix.set_contracted(shape.vertical_link(i - 1, j), true);
                }
            }
        }
        let [a, b, _] = self.cells;
        let seam =
            |row| Seam { a: SeamRun::along_row(row, 0, 1), b: SeamRun::along_row(row, 2 * a + b, -1), count: a + 1 };
        let seams = [seam(0), seam(h as u32 - 1)];
        let seams = if self.kind == BoxKind::Cross { &seams[..] } else { &[] };
        Topology::new(shape, ContractedLinks::Matrix(matrix), seams)
    }

    /// Returns the number of rows between row i and the lateral faces.
    fn depth_in_cap(&self, i: usize) -> usize {
        let (cap, c) = (self.cap_row_count(), self.cells[2] as usize);
        cap.saturating_sub(i).max(i.saturating_sub(cap + c))
    }

    /// Returns the z of row i.
    fn height_of_row(&self, i: usize) -> u32 {
        i.saturating_sub(self.cap_row_count()).min(self.cells[2] as usize) as u32
    }

    /// Returns the place of node (i, j), in cells from the corner of the box. Rows run from the
    /// bottom to the top, and columns around the box, counter-clockwise seen from above.
    pub fn lattice_point(&self, i: usize, j: usize) -> [u32; 3] {
        let [a, b, _] = self.cells;
        let (depth, column) = (self.depth_in_cap(i) as u32, j as u32 % (2 * (a + b)));
        let [x, y] = match self.kind {
            BoxKind::Slit => {
                let (s, t) = (depth.min(b.div_ceil(2)), depth.saturating_sub(b.div_ceil(2)));
                let [x, y] = self.cap_rim_point(column);
                [clamp_to_inset_interval(x, t, a), clamp_to_inset_interval(y, s, b)]
            }
            BoxKind::Concentric => {
                let [x, y] = self.cap_rim_point(column);
                [clamp_to_inset_interval(x, depth, a), clamp_to_inset_interval(y, depth, b)]
            }
            BoxKind::Cross => self.cap_point_in_cross_unwrapping(depth, column),
        };
        [x, y, self.height_of_row(i)]
    }

    /// Returns the point of a column on the rim of a cap: along x, along y, back along x, back
    /// along y.
    fn cap_rim_point(&self, column: u32) -> [u32; 2] {
        let [a, b, _] = self.cells;
        match column {
            k if k <= a => [k, 0],
            k if k <= a + b => [a, k - a],
            k if k <= 2 * a + b => [2 * a + b - k, b],
            k => [0, 2 * (a + b) - k],
        }
    }

    /// Returns the point of a cap at a depth and column in cross unwrapping, which has four blocks.
    /// The first block is the cap itself, from its rim at y = 0. The third, opposite, contracts to
    /// the rim at y = b. The two others contract to the sides x = a and x = 0, following the end of
    /// the first block.
    fn cap_point_in_cross_unwrapping(&self, depth: u32, column: u32) -> [u32; 2] {
        let [a, b, _] = self.cells;
        let [x, y] = self.cap_rim_point(column);
        match column {
            k if k <= a => [x, depth],
            k if k > a + b && k < 2 * a + b => [x, b],
            _ => [x, y.max(depth)],
        }
    }
}

/// Clamps a coordinate to the interval from `steps` to `size` less `steps`. For an odd size the
/// last step moves one end only.
fn clamp_to_inset_interval(value: u32, steps: u32, size: u32) -> u32 {
    value.clamp(steps.min(size.div_ceil(2)), size - steps.min(size / 2))
}
