//! Normals and texture coordinates as lines, each value once.

use crate::mesh::{Mesh, Values};
use crate::text::TextWriter;
use std::collections::HashMap;
use std::hash::{BuildHasher, Hasher, RandomState};
use std::io;

/// Line numbers of values, from 1; 0 for missing values.
pub(super) struct Numbers {
    line_of_value: Vec<u64>,
    is_at_corners: bool,
    has_missing: bool,
}

impl Numbers {
    #[inline]
    pub(super) fn get(&self, corner: usize, vertex: u32) -> u64 {
        self.line_of_value[if self.is_at_corners { corner } else { vertex as usize }]
    }

    /// Returns whether all corners of a face have values.
    #[inline]
    pub(super) fn has_face(&self, mesh: &Mesh, face: usize) -> bool {
        !self.line_of_value.is_empty()
            && (!self.has_missing || mesh.face_range(face).all(|corner| self.get(corner, mesh.corners[corner]) != 0))
    }
}

/// Lines of one keyword, each value once.
pub(super) struct ValueLines<const N: usize> {
    keyword: &'static str,
    /// Line of each value by its bits.
    line_of_known_value: HashMap<[u64; N], u64, SeededState>,
}

impl<const N: usize> ValueLines<N> {
    pub(super) fn new(keyword: &'static str) -> Self {
        Self { keyword, line_of_known_value: HashMap::with_hasher(SeededState::random()) }
    }

    /// Writes the values that the file lacks, in the order of vertices or corners.
    pub(super) fn write(
        &mut self,
        text: &mut TextWriter<'_>,
        values: &Values<N>,
        change: impl Fn([f64; N]) -> [f64; N],
    ) -> io::Result<Numbers> {
        let mut numbers = Vec::new();
        let mut has_missing = false;
        let is_at_corners = matches!(values, Values::Corners(_));
        let (Values::Vertices(values) | Values::Corners(values)) = values else {
            return Ok(Numbers { line_of_value: numbers, is_at_corners, has_missing });
        };
        numbers.try_reserve_exact(values.len()).map_err(|_| io::ErrorKind::OutOfMemory)?;
        for value in values {
            if value[0].is_nan() {
                has_missing = true;
                numbers.push(0);
            } else {
                numbers.push(self.find_or_write_line(text, change(*value))?);
            }
        }
        Ok(Numbers { line_of_value: numbers, is_at_corners, has_missing })
    }

    /// Returns the line of a value, which is written if it is new.
    #[inline]
    fn find_or_write_line(&mut self, text: &mut TextWriter<'_>, value: [f64; N]) -> io::Result<u64> {
        self.line_of_known_value.try_reserve(1).map_err(|_| io::ErrorKind::OutOfMemory)?;
        let next = self.line_of_known_value.len() as u64 + 1;
        let number = *self.line_of_known_value.entry(value.map(f64::to_bits)).or_insert(next);
        if number == next {
            text.text(self.keyword)?;
            for part in value {
                text.bytes(b" ")?;
                text.attribute(part)?;
            }
            text.bytes(b"\n")?;
        }
        Ok(number)
    }
}

/// Seeds of a hash that differ from run to run, so that no file can be made of values that collide.
struct SeededState([u64; 2]);

impl SeededState {
    fn random() -> Self {
        let state = RandomState::new();
        Self([state.hash_one(0), state.hash_one(1) | 1])
    }
}

impl BuildHasher for SeededState {
    type Hasher = FoldingHasher;

    fn build_hasher(&self) -> FoldingHasher {
        FoldingHasher { hash: self.0[0], factor: self.0[1] }
    }
}

/// Multiplies words to 128 bits and folds these, a fraction of the cost of the standard hash.
struct FoldingHasher {
    hash: u64,
    factor: u64,
}

impl Hasher for FoldingHasher {
    fn write_u64(&mut self, word: u64) {
        let product = u128::from(self.hash ^ word) * u128::from(self.factor);
        self.hash = (product as u64) ^ ((product >> 64) as u64) ^ word.rotate_left(32);
    }

    fn write(&mut self, bytes: &[u8]) {
        for part in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..part.len()].copy_from_slice(part);
            self.write_u64(u64::from_le_bytes(word));
        }
    }

    fn write_usize(&mut self, length: usize) {
        self.write_u64(length as u64);
    }

    fn finish(&self) -> u64 {
        let product = u128::from(self.hash) * u128::from(self.factor);
        (product as u64) ^ ((product >> 64) as u64)
    }
}
