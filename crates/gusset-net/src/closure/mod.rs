//! Closures beyond [`Sides`]: boxes, and surfaces with a reversed or folded side.
//!
//! A closed surface is a rectangle with glued sides. [`Sides`], like the characteristic matrix in
//! general, glue neighbours and the ends of rows and columns. A side that is glued to another in
//! reverse, or folded onto itself, is a [`Seam`]. O(nodes).

mod cuboid;

pub use cuboid::{BoxKind, Cuboid};

use super::topology::{ContractedLinks, Seam, SeamRun};
use super::{Shape, Sides, Topology};
use gusset_base::error::{Error, Result};

/// Returns a Möbius strip: the last column is the reversed first column. Euler characteristic 0,
/// one boundary loop.
///
/// # Errors
/// [`Error::CrossingCell`] if the net is so small that both pairs of opposite corners of a cell
/// would be glued; [`Error::OutOfMemory`].
pub fn moebius(shape: Shape) -> Result<Topology> {
    Topology::new(shape, ContractedLinks::Sides(Sides::SHEET), &[seam_to_reversed_column(shape)])
}

/// Returns a Klein bottle: columns are closed, and the last column is the reversed first column.
/// Euler characteristic 0, closed.
///
/// # Errors
/// [`Error::CrossingCell`] if the net is so small that both pairs of opposite corners of a cell
/// would be glued; [`Error::OutOfMemory`].
pub fn klein(shape: Shape) -> Result<Topology> {
    let sides = Sides { columns_closed: true, ..Sides::SHEET };
    Topology::new(shape, ContractedLinks::Sides(sides), &[seam_to_reversed_column(shape)])
}

/// Returns a projective plane: opposite nodes of the rim are glued. Euler characteristic 1, closed.
///
/// # Errors
/// [`Error::CrossingCell`] if the net is so small that both pairs of opposite corners of a cell
/// would be glued; [`Error::OutOfMemory`].
pub fn projective_plane(shape: Shape) -> Result<Topology> {
    let (h, w) = (shape.rows() as u32, shape.columns() as u32);
    let rows = Seam { a: SeamRun::along_row(0, 0, 1), b: SeamRun::along_row(h - 1, w - 1, -1), count: w };
    Topology::new(shape, ContractedLinks::Sides(Sides::SHEET), &[seam_to_reversed_column(shape), rows])
}

/// Returns a pillow: a flattened tube whose two rims are folded shut. It is a sphere with four
/// vertices of valence 2, which [`Sides`] cannot describe.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for an even number of columns, because a row is folded at its first
/// and its middle node. [`Error::CrossingCell`] if the net is so small that both pairs of opposite
/// corners of a cell would be glued; [`Error::OutOfMemory`].
pub fn pillow(shape: Shape) -> Result<Topology> {
    let (h, w) = (shape.rows() as u32, shape.columns() as u32);
    Error::require(w % 2 == 1, "columns", w.into(), "odd")?;
    let folded =
        |row| Seam { a: SeamRun::along_row(row, 0, 1), b: SeamRun::along_row(row, w - 1, -1), count: w.div_ceil(2) };
    Topology::new(shape, ContractedLinks::Sides(Sides::TUBE), &[folded(0), folded(h - 1)])
}

/// Returns the seam that identifies the last column with the reversed first column.
fn seam_to_reversed_column(shape: Shape) -> Seam {
    let (h, w) = (shape.rows() as u32, shape.columns() as u32);
    Seam { a: SeamRun::along_column(0, w - 1, 1), b: SeamRun::along_column(h - 1, 0, -1), count: h }
}
