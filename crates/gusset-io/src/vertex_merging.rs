//! Vertices at equal positions as one vertex.
//!
//! A table with open addressing holds vertices by a hash of their coordinates. -0 equals 0, and NaN equals nothing. The hash takes a
//! secret of the process, so that no file can make all its points collide. Vertices are numbered in the order of their first
//! occurrence, so that the result does not depend on the secret.

use crate::error::{ReadError, ReadErrorKind};
use gusset_base::alloc;
use std::hash::{BuildHasher, RandomState};

/// Entries that are kept a second time, where a cache of the processor holds them: most points repeat soon.
const MAX_RECENT_ENTRIES: usize = 1 << 15;
/// Points whose entries are loaded together, so that the processor waits for memory once.
const BATCH_POINTS: usize = 192;
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
    /// The last entry at each place, of those that were added or found.
    recent: Vec<u64>,
    points: Vec<[T; 3]>,
    hasher: PointHasher,
}

/// A hash of coordinates with a secret of its own.
#[derive(Clone, Copy)]
pub(crate) struct PointHasher {
    secrets: [u64; 3],
}

impl PointHasher {
    pub(crate) fn new() -> Self {
        let state = RandomState::new();
        Self { secrets: [1_u64, 2, 3].map(|number| state.hash_one(number)) }
    }

    #[inline]
    pub(crate) fn hash<T: Coordinate>(&self, point: [T; 3]) -> u64 {
        let [x, y, z] = point.map(T::key);
        let first = folded_product(x ^ self.secrets[0], y ^ self.secrets[1]);
        folded_product(first ^ z, self.secrets[2] | 1)
    }
}

impl<T: Coordinate> VertexMerger<T> {
    /// Makes a merger with room for a number of vertices. It grows as needed.
    pub(crate) fn new(expected_vertices: usize) -> Result<Self, ReadError> {
        let slot_count = (2 * expected_vertices).max(4 * BATCH_POINTS).next_power_of_two();
        let mut merger = Self {
            slots: Vec::new(),
            recent: alloc::filled(0, slot_count.min(MAX_RECENT_ENTRIES))?,
            points: alloc::with_capacity(expected_vertices)?,
            hasher: PointHasher::new(),
        };
        merger.rebuild(slot_count)?;
        Ok(merger)
    }

    /// Appends the vertex of each point.
    pub(crate) fn extend(&mut self, points: &[[T; 3]], vertices: &mut Vec<u32>) -> Result<(), ReadError> {
        let start = vertices.len();
        alloc::grow(vertices, start + points.len(), 0)?;
        self.number(points, &mut vertices[start..])
    }

    /// Finds the vertex of each point.
    pub(crate) fn number(&mut self, points: &[[T; 3]], vertices: &mut [u32]) -> Result<(), ReadError> {
        for (batch, vertices) in points.chunks(BATCH_POINTS).zip(vertices.chunks_mut(BATCH_POINTS)) {
            if 2 * (self.points.len() + batch.len()) > self.slots.len() {
                self.rebuild(2 * self.slots.len())?;
            }
            self.points.try_reserve(batch.len())?;
            self.number_batch(batch, vertices);
        }
        Ok(())
    }

    fn number_batch(&mut self, batch: &[[T; 3]], vertices: &mut [u32]) {
        let mut hashes = [0; BATCH_POINTS];
        // Places in the batch of points that are not found among the recent ones.
        let (mut missed, mut missed_count) = ([0_u8; BATCH_POINTS], 0);
        for (place, (&point, vertex)) in batch.iter().zip(&mut *vertices).enumerate() {
            let hash = self.hasher.hash(point);
            let entry = self.recent[hash as usize & (self.recent.len() - 1)];
            hashes[place] = hash;
            *vertex = (entry as u32).wrapping_sub(1);
            let is_found = (entry ^ hash) >> 32 == 0 && self.points.get(*vertex as usize) == Some(&point);
            missed[missed_count] = place as u8;
            missed_count += usize::from(!is_found);
        }
        let missed = &missed[..missed_count];
        // These loads do not depend on each other. The results matter only in that the memory is near afterwards.
        let mut sum = 0;
        for &place in missed {
            sum ^= self.slots[self.slot(hashes[place as usize])];
        }
        std::hint::black_box(sum);
        for &place in missed {
            let (place, hash) = (place as usize, hashes[place as usize]);
            vertices[place] = self.find_or_add(batch[place], hash);
            let recent_place = hash as usize & (self.recent.len() - 1);
            self.recent[recent_place] = (hash & !u64::from(u32::MAX)) | (u64::from(vertices[place]) + 1);
        }
    }

    /// Returns the points of vertices.
    pub(crate) fn into_points(self) -> Vec<[T; 3]> {
        self.points
    }

    /// Returns the number of vertices.
    pub(crate) fn len(&self) -> usize {
        self.points.len()
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
            return Err(ReadError::new(
                ReadErrorKind::TooLarge,
                "the file has more than 2^31 different points; split it",
            ));
        }
        self.slots = Vec::new();
        self.slots.try_reserve_exact(slot_count)?;
        self.slots.resize(slot_count, 0);
        for (vertex, &point) in self.points.iter().enumerate() {
            #[allow(clippy::eq_op)]
            if point != point {
                continue;
            }
            let hash = self.hasher.hash(point);
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
