//! The points of an identification, in the host's memory.

use glam::{DVec2, DVec3};
use gusset_base::error::{Error, Result};
use gusset_base::geom::strided::Strided;
use std::ops::Range;

/// The maximum number of points in one call: 2^30, so that 32 bits can count the control points.
pub const MAX_POINTS: usize = 1 << 30;

/// Points in a host's memory: 2 or 3 coordinates at the start of every `stride` bytes, at any
/// alignment. Plane points have z = 0.
#[derive(Debug, Clone, Copy)]
pub struct Points<'a> {
    elements: Strided<'a>,
    dimension: usize,
}

impl<'a> Points<'a> {
    /// `dimension` is 2 or 3. `stride` is in bytes; 0 means points without gaps.
    ///
    /// # Errors
    /// [`Error::ArrayTooShort`], and the errors of [`Points::bytes_needed`].
    pub fn strided(bytes: &'a [u8], stride: usize, count: usize, dimension: usize) -> Result<Self> {
        Self::bytes_needed(stride, count, dimension)?;
        Ok(Points { elements: Strided::new(bytes, count, stride, 8 * dimension, "points")?, dimension })
    }

    /// Returns the number of bytes that `count` points span.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] (the dimension), [`Error::TooLarge`], [`Error::StrideTooSmall`],
    /// [`Error::SizeOverflow`].
    pub fn bytes_needed(stride: usize, count: usize, dimension: usize) -> Result<usize> {
        Error::require((2..=3).contains(&dimension), "dimension", dimension as f64, "2 or 3")?;
        Error::check_count("points", count as u64, MAX_POINTS as u64)?;
        Strided::byte_span(count, stride, 8 * dimension, "points")
    }

    /// Returns the number of points.
    pub fn len(&self) -> usize {
        self.elements.count()
    }

    /// Returns true if the list of points is empty.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns whether all points are in the plane z = 0.
    pub(super) fn is_plane(&self) -> bool {
        self.dimension == 2
    }

    /// Appends the points of a range to a list of sufficient capacity.
    pub(super) fn append_range_to(&self, range: Range<usize>, list: &mut Vec<DVec3>) {
        match self.dimension {
            2 => list.extend(range.map(|i| DVec2::from_array(self.elements.get(i)).extend(0.0))),
            _ => list.extend(range.map(|i| DVec3::from_array(self.elements.get(i)))),
        }
    }

    /// Point `i`.
    ///
    /// # Panics
    /// If point `i` does not exist.
    #[inline]
    pub fn get(&self, i: usize) -> DVec3 {
        match self.dimension {
            2 => DVec2::from_array(self.elements.get(i)).extend(0.0),
            _ => DVec3::from_array(self.elements.get(i)),
        }
    }
}

impl<'a> From<&'a [[f64; 2]]> for Points<'a> {
    fn from(points: &'a [[f64; 2]]) -> Self {
        Points { elements: Strided::packed(points), dimension: 2 }
    }
}

impl<'a> From<&'a [[f64; 3]]> for Points<'a> {
    fn from(points: &'a [[f64; 3]]) -> Self {
        Points { elements: Strided::packed(points), dimension: 3 }
    }
}
