//! Types of values, and the output of a result.

use gusset_base::error::{Error, Result};
use gusset_base::geom::strided::Strided;

/// The type of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ValueType {
    /// 32-bit floating point.
    F32,
    /// 64-bit floating point.
    F64,
    /// 8-bit unsigned integer.
    U8,
    /// 16-bit unsigned integer.
    U16,
    /// 32-bit unsigned integer.
    U32,
}

impl ValueType {
    /// Size of one value in bytes.
    pub fn size(self) -> usize {
        match self {
            ValueType::U8 => 1,
            ValueType::U16 => 2,
            ValueType::F32 | ValueType::U32 => 4,
            ValueType::F64 => 8,
        }
    }

    /// The largest value of an unsigned type; `None` for floating-point types.
    pub(super) fn largest_value(self) -> Option<f64> {
        match self {
            ValueType::F32 | ValueType::F64 => None,
            ValueType::U8 => Some(u8::MAX.into()),
            ValueType::U16 => Some(u16::MAX.into()),
            ValueType::U32 => Some(u32::MAX.into()),
        }
    }

    /// Reads the first value in `bytes`, without rounding.
    #[inline]
    pub(super) fn read(self, bytes: &[u8]) -> f64 {
        fn read_first<T: bytemuck::AnyBitPattern>(bytes: &[u8]) -> T {
            bytemuck::pod_read_unaligned(&bytes[..size_of::<T>()])
        }
        match self {
            ValueType::F32 => read_first::<f32>(bytes).into(),
            ValueType::F64 => read_first(bytes),
            ValueType::U8 => bytes[0].into(),
            ValueType::U16 => read_first::<u16>(bytes).into(),
            ValueType::U32 => read_first::<u32>(bytes).into(),
        }
    }

    /// Writes a value. Rounds to the nearest value that the type can represent.
    #[inline]
    pub(super) fn write(self, value: f64, bytes: &mut [u8]) {
        let mut put = |value: &[u8]| bytes[..value.len()].copy_from_slice(value);
        match self {
            // Finite values stay finite.
            ValueType::F32 => put(&(value.clamp(f32::MIN.into(), f32::MAX.into()) as f32).to_ne_bytes()),
            ValueType::F64 => put(&value.to_ne_bytes()),
            ValueType::U8 => put(&[value.round() as u8]),
            ValueType::U16 => put(&(value.round() as u16).to_ne_bytes()),
            ValueType::U32 => put(&(value.round() as u32).to_ne_bytes()),
        }
    }
}

/// Memory for the values of a result. The values of an element begin every `stride` bytes.
#[derive(Debug)]
pub struct Output<'a> {
    pub(super) bytes: &'a mut [u8],
    pub(super) stride: usize,
    pub(super) value_type: ValueType,
    pub(super) components: usize,
}

impl<'a> Output<'a> {
    /// Prepares memory for `count` elements with the given type and number of components. `stride`
    /// is in bytes; 0 means contiguous values.
    ///
    /// # Errors
    /// [`Error::StrideTooSmall`], [`Error::SizeOverflow`], [`Error::ArrayTooShort`].
    pub fn new(
        bytes: &'a mut [u8],
        stride: usize,
        count: usize,
        (value_type, components): (ValueType, u32),
    ) -> Result<Output<'a>> {
        let components = components as usize;
        let size = components * value_type.size();
        let needed = Strided::byte_span(count, stride, size, "values")?;
        let stride = if stride == 0 { size } else { stride };
        let given = bytes.len() as u64;
        let Some(bytes) = bytes.get_mut(..needed) else {
            return Err(Error::ArrayTooShort { what: "values", needed: needed as u64, given });
        };
        Ok(Output { bytes, stride, value_type, components })
    }

    /// Component `c` of element `k`.
    pub(super) fn get(&self, k: usize, c: usize) -> f64 {
        self.value_type.read(&self.bytes[k * self.stride + c * self.value_type.size()..])
    }

    pub(super) fn set(&mut self, k: usize, c: usize, value: f64) {
        self.value_type.write(value, &mut self.bytes[k * self.stride + c * self.value_type.size()..]);
    }
}
