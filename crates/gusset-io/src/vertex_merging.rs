//! Vertices at equal positions as one vertex.
//!
//! A table with open addressing holds vertices by a hash of their coordinates. -0 equals 0, and NaN equals nothing. The hash takes a
//! secret of the process, so that no file can make all its points collide. Vertices are numbered in the order of their first
//! occurrence, so that the result does not depend on the secret.

use crate::error::{ReadError, ReadErrorKind};
use std::hash::{BuildHasher, RandomState};

/// Points whose entries are loaded together, so that the processor waits for memory once.
const BATCH_POINTS: usize = 48;
/// Most vertices that the table holds.
const MAX_VERTICES: usize = 1 << 31;

/// A coordinate of single or double precision.
pub(crate) trait Coordinate: Copy + PartialEq {
    /// Returns bits that are equal for equal numbers.
    fn key(self) -> u64;
}

impl Coordinate for f32 {
    fn key(self) -> u64 {
        u64::from((self + 0.0).to_bits())
    }
}

impl Coordinate for f64 {
    fn key(self) -> u64 {
        (self + 0.0).to_bits()
    }
}

/// Numbers points so that equal points have one number.
pub(crate) struct VertexMerger<T> {
    /// For each slot: the upper half of the hash and one more than the vertex, or 0.
    slots: Vec<u64>,
    points: Vec<[T; 3]>,
    secrets: [u64; 3],
}

impl<T: Coordinate> VertexMerger<T> {
    /// Makes a merger with room for a number of vertices. It grows as needed.
    pub(crate) fn new(expected_vertices: usize) -> Result<Self, ReadError> {
        let state = RandomState::new();
        let secrets = [1_u64, 2, 3].map(|number| state.hash_one(number));
        let mut merger = Self { slots: Vec::new(), points: Vec::new(), secrets };
        merger.points.try_reserve(expected_vertices)?;
        merger.rebuild((2 * expected_vertices).max(4 * BATCH_POINTS).next_power_of_two())?;
        Ok(merger)
    }

    /// Appends the vertex of each point.
    pub(crate) fn extend(&mut self, points: &[[T; 3]], vertices: &mut Vec<u32>) -> Result<(), ReadError> {
        vertices.try_reserve(points.len())?;
        for batch in points.chunks(BATCH_POINTS) {
            if 2 * (self.points.len() + batch.len()) > self.slots.len() {
                self.rebuild(2 * self.slots.len())?;
            }
            self.points.try_reserve(batch.len())?;
            let mut hashes = [0; BATCH_POINTS];
            let mut firsts = [0; BATCH_POINTS];
            for (place, &point) in batch.iter().enumerate() {
                hashes[place] = self.hash(point);
                firsts[place] = self.slots[self.slot(hashes[place])];
            }
            // These loads do not depend on each other. The results matter only in that the memory is near afterwards.
            let mut sum = 0;
            for &first in &firsts[..batch.len()] {
                if let Some(point) = (first as u32).checked_sub(1).and_then(|vertex| self.points.get(vertex as usize)) {
                    sum ^= point[0].key();
                }
            }
            std::hint::black_box(sum);
            vertices.extend(batch.iter().zip(hashes).map(|(&point, hash)| self.find_or_add(point, hash)));
        }
        Ok(())
    }

    /// Returns the points of vertices.
    pub(crate) fn into_points(self) -> Vec<[T; 3]> {
        self.points
    }

    /// Returns the number of vertices.
    pub(crate) fn len(&self) -> usize {
        self.points.len()
    }

    fn hash(&self, point: [T; 3]) -> u64 {
        let [x, y, z] = point.map(T::key);
        let first = folded_product(x ^ self.secrets[0], y ^ self.secrets[1]);
        folded_product(first ^ z, self.secrets[2] | 1)
    }

    fn slot(&self, hash: u64) -> usize {
        hash as usize & (self.slots.len() - 1)
    }

    fn find_or_add(&mut self, point: [T; 3], hash: u64) -> u32 {
        let mask = self.slots.len() - 1;
        let mut slot = self.slot(hash);
        let tag = hash & !u64::from(u32::MAX);
        let added = self.points.len() as u32;
        #[allow(clippy::eq_op)]
        let is_nan = point != point;
        if is_nan {
            self.points.push(point);
            return added;
        }
        loop {
            let entry = self.slots[slot];
            if entry == 0 {
                break;
            }
            let vertex = entry as u32 - 1;
            if entry & !u64::from(u32::MAX) == tag && self.points[vertex as usize] == point {
                return vertex;
            }
            slot = (slot + 1) & mask;
        }
        self.slots[slot] = tag | u64::from(added + 1);
        self.points.push(point);
        added
    }

    /// Makes a table of a number of slots, which is a power of two.
    fn rebuild(&mut self, slot_count: usize) -> Result<(), ReadError> {
        if self.points.len() > MAX_VERTICES - BATCH_POINTS {
            return Err(ReadError::new(ReadErrorKind::TooLarge, "the file has more than 2^31 different points"));
        }
        self.slots = Vec::new();
        self.slots.try_reserve_exact(slot_count)?;
        self.slots.resize(slot_count, 0);
        for (vertex, &point) in self.points.iter().enumerate() {
            #[allow(clippy::eq_op)]
            if point != point {
                continue;
            }
            let hash = self.hash(point);
            let mut slot = self.slot(hash);
            while self.slots[slot] != 0 {
                slot = (slot + 1) & (slot_count - 1);
            }
            self.slots[slot] = (hash & !u64::from(u32::MAX)) | (vertex as u64 + 1);
        }
        Ok(())
    }
}

fn folded_product(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    product as u64 ^ (product >> 64) as u64
}
