//! Positions in a host's memory.

use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::geom::strided::Strided;
use std::ops::Range;

/// The maximum number of vertices and of half-edges of a mesh: 2^32 - 2.
pub const MAX_ELEMENTS: u64 = u32::MAX as u64 - 1;

/// The type of a coordinate, the less precise one first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Scalar {
    /// 32-bit float.
    F32,
    /// 64-bit float.
    F64,
}

impl Scalar {
    /// Returns the size in bytes of one position: three coordinates.
    #[inline]
    pub fn position_size(self) -> usize {
        match self {
            Scalar::F32 => 12,
            Scalar::F64 => 24,
        }
    }
}

/// Positions in a host's memory: `x, y, z` at the start of every `stride` bytes, at any alignment.
#[derive(Debug, Clone, Copy)]
pub struct Positions<'a> {
    points: Strided<'a>,
    scalar: Scalar,
}

impl<'a> Positions<'a> {
    /// `bytes` starts with the first position. `stride` is in bytes; 0 means positions without
    /// gaps. The last position needs only its own bytes, not a whole stride.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::StrideTooSmall`], [`Error::SizeOverflow`],
    /// [`Error::ArrayTooShort`].
    #[inline]
    pub fn strided(bytes: &'a [u8], stride: usize, count: usize, scalar: Scalar) -> Result<Self> {
        check_size(count as u64, 0)?;
        Ok(Positions { points: Strided::new(bytes, count, stride, scalar.position_size(), "positions")?, scalar })
    }

    /// Returns the number of bytes that `count` positions span.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::StrideTooSmall`], [`Error::SizeOverflow`].
    #[inline]
    pub fn bytes_needed(stride: usize, count: usize, scalar: Scalar) -> Result<usize> {
        check_size(count as u64, 0)?;
        Strided::byte_span(count, stride, scalar.position_size(), "positions")
    }

    /// Returns the number of positions.
    #[inline]
    pub fn len(&self) -> usize {
        self.points.count()
    }

    /// Returns true if the list of positions is empty.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns the type of the coordinates.
    #[inline]
    pub fn scalar(&self) -> Scalar {
        self.scalar
    }

    /// Position `v` in double precision, which is exact.
    #[inline]
    pub fn get(&self, v: u32) -> DVec3 {
        match self.scalar {
            Scalar::F32 => {
                let p: [f32; 3] = self.points.get(v as usize);
                DVec3::new(f64::from(p[0]), f64::from(p[1]), f64::from(p[2]))
            }
            Scalar::F64 => DVec3::from_array(self.points.get(v as usize)),
        }
    }

    /// Returns true if all coordinates in `range` are finite.
    pub(super) fn are_finite(&self, mut range: Range<usize>) -> bool {
        match (self.packed_bytes(), self.scalar) {
            // Without the sign, adding one to the exponent overflows into the sign bit exactly for
            // the largest exponent, which marks infinities and NaN. A loop without an exit runs
            // several times as fast.
            (Some(bytes), Scalar::F64) => {
                let add = |carry, bits: &[u8]| {
                    carry | ((bytemuck::pod_read_unaligned::<u64>(bits) & (u64::MAX >> 1)) + (1 << 52))
                };
                bytes[24 * range.start..24 * range.end].chunks_exact(8).fold(0, add) >> 63 == 0
            }
            (Some(bytes), Scalar::F32) => {
                let add = |carry, bits: &[u8]| {
                    carry | ((bytemuck::pod_read_unaligned::<u32>(bits) & (u32::MAX >> 1)) + (1 << 23))
                };
                bytes[12 * range.start..12 * range.end].chunks_exact(4).fold(0, add) >> 31 == 0
            }
            (None, _) => range.all(|v| self.get(v as u32).is_finite()),
        }
    }

    /// Position `v` as stored, bit for bit.
    pub(super) fn position_bytes(&self, v: usize) -> &'a [u8] {
        self.points.bytes(v)
    }

    /// Returns the bytes, if the positions are contiguous.
    pub(super) fn packed_bytes(&self) -> Option<&'a [u8]> {
        self.points.contiguous_bytes()
    }
}

/// Checks both counts against [`MAX_ELEMENTS`].
///
/// # Errors
/// [`Error::TooLarge`].
pub fn check_size(vertices: u64, half_edges: u64) -> Result<()> {
    Error::check_count("vertices", vertices, MAX_ELEMENTS)?;
    Error::check_count("half-edges", half_edges, MAX_ELEMENTS)
}

impl<'a> From<&'a [[f32; 3]]> for Positions<'a> {
    fn from(points: &'a [[f32; 3]]) -> Self {
        Positions { points: Strided::packed(points), scalar: Scalar::F32 }
    }
}

impl<'a> From<&'a [[f64; 3]]> for Positions<'a> {
    fn from(points: &'a [[f64; 3]]) -> Self {
        Positions { points: Strided::packed(points), scalar: Scalar::F64 }
    }
}
