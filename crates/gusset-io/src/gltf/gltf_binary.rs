//! The buffer that a writer fills, and the views and accessors of it.

use crate::json_text::push_numbers;
use std::collections::TryReserveError;

/// Purpose of a view.
#[derive(Clone, Copy)]
pub(super) enum Target {
    Vertices,
    Indices,
    /// An image.
    Other,
}

/// A list of JSON values as text.
#[derive(Default)]
pub(super) struct JsonList {
    pub(super) text: String,
    pub(super) count: u32,
}

impl JsonList {
    /// Appends a value. Returns its index.
    pub(super) fn push(&mut self, value: &str) -> Result<u32, TryReserveError> {
        self.text.try_reserve(value.len() + 1)?;
        if self.count > 0 {
            self.text.push(',');
        }
        self.text.push_str(value);
        self.count += 1;
        Ok(self.count - 1)
    }
}

/// The buffer and what describes it.
#[derive(Default)]
pub(super) struct Binary {
    pub(super) bytes: Vec<u8>,
    pub(super) views: JsonList,
    pub(super) accessors: JsonList,
}

/// Numbers that a buffer holds.
pub(super) trait Number: bytemuck::NoUninit {
    /// Code of the type in accessors.
    const CODE: u32;
    fn push(self, bytes: &mut Vec<u8>);
}

macro_rules! number {
    ($($kind:ty: $code:literal),*) => {$(
        impl Number for $kind {
            const CODE: u32 = $code;
            fn push(self, bytes: &mut Vec<u8>) {
                bytes.extend_from_slice(&self.to_le_bytes());
            }
        }
    )*};
}

number!(f32: 5126, u32: 5125, u16: 5123);

impl Binary {
    /// Appends elements of `N` numbers. Returns the index of their accessor.
    pub(super) fn push_elements<T: Number, const N: usize>(
        &mut self,
        elements: impl ExactSizeIterator<Item = [T; N]>,
        target: Target,
    ) -> Result<u32, TryReserveError> {
        self.push_bounded(elements, target, None)
    }

    /// Appends positions, with their bounds. Returns the index of their accessor.
    pub(super) fn push_positions(&mut self, points: &[[f32; 3]]) -> Result<u32, TryReserveError> {
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for point in points {
            for axis in 0..3 {
                let x = point[axis];
                low[axis] = low[axis].min(if x.is_finite() { x } else { f32::INFINITY });
                high[axis] = high[axis].max(if x.is_finite() { x } else { f32::NEG_INFINITY });
            }
        }
        let bounds = [low, high].map(|corner| corner.map(f64::from));
        self.push_slice(points, Target::Vertices, Some(bounds))
    }

    fn push_bounded<T: Number, const N: usize>(
        &mut self,
        elements: impl ExactSizeIterator<Item = [T; N]>,
        target: Target,
        bounds: Option<[[f64; 3]; 2]>,
    ) -> Result<u32, TryReserveError> {
        let start = self.bytes.len();
        let count = elements.len();
        self.bytes.try_reserve(count * N * size_of::<T>() + 4)?;
        for element in elements {
            for number in element {
                number.push(&mut self.bytes);
            }
        }
        self.close_array::<T, N>(start, count, target, bounds)
    }

    /// Appends elements of a slice, in one copy if the machine has the file's order of bytes. Returns the index of their accessor.
    fn push_slice<T: Number, const N: usize>(
        &mut self,
        elements: &[[T; N]],
        target: Target,
        bounds: Option<[[f64; 3]; 2]>,
    ) -> Result<u32, TryReserveError> {
        if cfg!(target_endian = "big") {
            return self.push_bounded(elements.iter().copied(), target, bounds);
        }
        let start = self.bytes.len();
        let bytes: &[u8] = bytemuck::cast_slice(elements.as_flattened());
        self.bytes.try_reserve(bytes.len() + 4)?;
        self.bytes.extend_from_slice(bytes);
        self.close_array::<T, N>(start, elements.len(), target, bounds)
    }

    /// Appends indices of 32 bits. Returns the index of their accessor.
    pub(super) fn push_indices(&mut self, indices: &[u32]) -> Result<u32, TryReserveError> {
        self.push_slice(indices.as_chunks::<1>().0, Target::Indices, None)
    }

    /// Makes the accessor of `count` elements since `start`.
    fn close_array<T: Number, const N: usize>(
        &mut self,
        start: usize,
        count: usize,
        target: Target,
        bounds: Option<[[f64; 3]; 2]>,
    ) -> Result<u32, TryReserveError> {
        let view = self.close_view(start, target)?;
        let kind = ["SCALAR", "VEC2", "VEC3", "VEC4"][N - 1];
        let mut text =
            format!("{{\"bufferView\":{view},\"componentType\":{},\"count\":{count},\"type\":\"{kind}\"", T::CODE);
        if let Some([low, high]) = bounds {
            text.push_str(",\"min\":");
            push_numbers(&mut text, &low);
            text.push_str(",\"max\":");
            push_numbers(&mut text, &high);
        }
        text.push('}');
        self.accessors.push(&text)
    }

    /// Appends bytes. Returns the index of their view.
    pub(super) fn push_bytes(&mut self, bytes: &[u8]) -> Result<u32, TryReserveError> {
        let start = self.bytes.len();
        self.bytes.try_reserve(bytes.len() + 4)?;
        self.bytes.extend_from_slice(bytes);
        self.close_view(start, Target::Other)
    }

    /// Makes a view of the bytes since `start`. The next one begins at a multiple of 4 bytes.
    fn close_view(&mut self, start: usize, target: Target) -> Result<u32, TryReserveError> {
        let length = self.bytes.len() - start;
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let target = match target {
            Target::Vertices => ",\"target\":34962",
            Target::Indices => ",\"target\":34963",
            Target::Other => "",
        };
        self.views.push(&format!("{{\"buffer\":0,\"byteOffset\":{start},\"byteLength\":{length}{target}}}"))
    }
}
