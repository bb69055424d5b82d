//! Nets of standard shapes: coordinates and topology (Deryagin, Figs. 5 and 6).
//!
//! Solids of revolution, prisms and pyramids sweep a profile around the z axis; each other shape
//! has its own formula. All are centred at the origin. Invariant: glued nodes have the same bits,
//! because their coordinates are computed from reduced indices. Closed surfaces have faces that are
//! counter-clockwise seen from outside, and so a positive volume. O(nodes).

mod construct;
mod formula;
mod profile;
mod solid;
mod unit_circle;

pub use solid::Primitive;

use super::{Net, Shape};
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::job::Job;
use gusset_mesh::Scalar;

/// A request for the net of a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Request<'a> {
    /// The shape.
    pub primitive: Primitive<'a>,
    /// Rows of nodes; 0 for [`Request::DEFAULT_ROWS`]. Not read for boxes and lathes.
    pub rows: usize,
    /// Columns of nodes; 0 for [`Request::DEFAULT_COLUMNS`]. Not read for boxes.
    pub columns: usize,
    /// The type of the coordinates.
    pub scalar: Scalar,
}

impl<'a> Request<'a> {
    /// The default number of rows.
    pub const DEFAULT_ROWS: usize = 33;
    /// The default number of columns.
    pub const DEFAULT_COLUMNS: usize = 65;

    /// Returns a shape with default rows and columns, in double precision.
    pub fn new(primitive: Primitive<'a>) -> Self {
        Request { primitive, rows: 0, columns: 0, scalar: Scalar::F64 }
    }

    /// Returns the size that the net will have.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for too few rows or columns, [`Error::NetTooSmall`],
    /// [`Error::TooLarge`].
    pub fn shape(&self) -> Result<Shape> {
        let or_default = |given: usize, default: usize| if given == 0 { default } else { given };
        let (mut rows, columns) =
            (or_default(self.rows, Self::DEFAULT_ROWS), or_default(self.columns, Self::DEFAULT_COLUMNS));
        match self.primitive {
            Primitive::Cuboid { cuboid, .. } => return cuboid.shape(),
            Primitive::Lathe { profile } => rows = profile.len(),
            _ => {}
        }
        let (min_rows, min_columns) = self.primitive.min_rows_and_columns();
        let is_even_pillow = matches!(self.primitive, Primitive::Pillow { .. }) && columns % 2 == 0;
        Error::require(rows >= min_rows, "rows", rows as f64, Allowed::AtLeast(min_rows as f64))?;
        Error::require(
            columns >= min_columns && !is_even_pillow,
            "columns",
            columns as f64,
            if is_even_pillow { "odd".into() } else { Allowed::AtLeast(min_columns as f64) },
        )?;
        Shape::new(rows, columns)
    }

    /// Constructs the net. O(nodes).
    ///
    /// # Errors
    /// - [`Error::OptionOutOfRange`]: a dimension is not positive, or too large or too small for
    ///   the type of the coordinates; or there are too few rows or columns.
    /// - [`Error::NetTooSmall`], [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn build_net(&self, job: &Job<'_>) -> Result<Net<'static>> {
        let shape = self.shape()?;
        self.primitive.check_dimensions(self.scalar)?;
        construct::construct_net(&self.primitive, shape, self.scalar, job)
    }
}
