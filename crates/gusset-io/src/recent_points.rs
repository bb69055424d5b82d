//! A list of points without most of their repetitions.
//!
//! Most points of a list of triangles repeat soon. A table that a cache of the processor holds finds these repetitions. A point that
//! repeats after its entry was replaced is listed again.

use crate::error::ReadError;
use crate::vertex_merging::{Coordinate, PointHasher};
use gusset_base::alloc;

/// Entries of the table, which takes 512 KiB.
const MAX_RECENT_ENTRIES: usize = 1 << 16;

/// A list of points, most of them once.
pub(crate) struct RecentPoints<T> {
    /// For each value of some lower bits of a hash: of the last such point, the upper half of the hash and one more than the index; or 0.
    recent: Vec<[u32; 2]>,
    points: Vec<[T; 3]>,
    /// The upper half of the hash of each point.
    hashes: Vec<u32>,
    hasher: PointHasher,
}

impl<T: Coordinate> RecentPoints<T> {
    /// Makes a list of points, which grows beyond the expected number as needed.
    pub(crate) fn new(expected_points: usize, hasher: PointHasher) -> Result<Self, ReadError> {
        let entry_count = (2 * expected_points).next_power_of_two().min(MAX_RECENT_ENTRIES);
        Ok(Self {
            recent: alloc::filled([0, 0], entry_count)?,
            points: alloc::with_capacity(expected_points)?,
            hashes: alloc::with_capacity(expected_points)?,
            hasher,
        })
    }

    /// Makes room for further points.
    pub(crate) fn reserve(&mut self, additional: usize) -> Result<(), ReadError> {
        alloc::reserve(&mut self.points, additional)?;
        Ok(alloc::reserve(&mut self.hashes, additional)?)
    }

    /// Returns the index of a point, which is appended unless the table has it. -0 equals 0, and NaN equals nothing.
    #[inline]
    pub(crate) fn find_or_append(&mut self, point: [T; 3]) -> u32 {
        let hash = self.hasher.hash(point);
        let (place, upper_hash) = (hash as usize & (self.recent.len() - 1), (hash >> 32) as u32);
        let [recent_hash, number] = self.recent[place];
        let index = number.wrapping_sub(1);
        if recent_hash == upper_hash && self.points.get(index as usize) == Some(&point) {
            return index;
        }
        let index = self.points.len() as u32;
        self.points.push(point);
        self.hashes.push(upper_hash);
        self.recent[place] = [upper_hash, index + 1];
        index
    }

    /// Returns the points, and a hash of each.
    pub(crate) fn into_points_and_hashes(self) -> (Vec<[T; 3]>, Vec<u32>) {
        (self.points, self.hashes)
    }
}
