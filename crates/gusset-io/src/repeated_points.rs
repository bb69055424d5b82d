//! How many points of a list repeat earlier ones.
//!
//! A bit for each hash tells points that are surely alone, in an array that a cache of the processor holds. The few others are merged.

use crate::error::ReadError;
use crate::vertex_merging::{Coordinate, PointHasher, VertexMerger};
use gusset_base::alloc;

/// Hashes that are told apart, for each point. One point in 8 shares its hash with another by chance.
const HASHES_PER_POINT: usize = 8;

/// Counts points that equal an earlier point, of the points `point(0)` to `point(count - 1)` that exist. NaN equals nothing, and -0 equals
/// 0. O(count) time.
pub(crate) fn count_repeated_points<T: Coordinate>(
    count: usize,
    point: impl Fn(usize) -> Option<[T; 3]>,
) -> Result<usize, ReadError> {
    const BATCH_POINTS: usize = 1 << 10;
    // A word has 32 bits for hashes that occur, and 32 for hashes that occur again.
    let words = (count.saturating_mul(HASHES_PER_POINT) / 32 + 1).next_power_of_two();
    let mut occurred: Vec<u64> = alloc::zeroed(words)?;
    let hasher = PointHasher::new();
    let place = |point: [T; 3]| {
        let hash = hasher.hash(point);
        ((hash >> 5) as usize & (words - 1), 1_u64 << (hash & 31))
    };
    let mut is_any_repeated = false;
    for point in (0..count).filter_map(&point) {
        let (word, bit) = place(point);
        let again = (occurred[word] & bit) << 32;
        is_any_repeated |= again != 0;
        occurred[word] |= bit | again;
    }
    if !is_any_repeated {
        return Ok(0);
    }
    let mut merger = VertexMerger::new(count / HASHES_PER_POINT)?;
    let (mut batch, mut vertices) = (alloc::with_capacity(BATCH_POINTS)?, alloc::filled(0, BATCH_POINTS)?);
    let mut suspects = 0;
    for index in 0..count {
        if let Some(point) = point(index) {
            let (word, bit) = place(point);
            if occurred[word] & (bit << 32) != 0 {
                batch.push(point);
                suspects += 1;
            }
        }
        if batch.len() == BATCH_POINTS || index + 1 == count {
            merger.number(&batch, &mut vertices)?;
            batch.clear();
        }
    }
    Ok(suspects - merger.len())
}

#[cfg(test)]
mod tests {
    use super::count_repeated_points;

    #[test]
    fn each_repetition_is_counted() {
        for (count, period) in
            [(0, 1), (1, 1), (1000, 1000), (1000, 999), (5000, 3), (40_000, 39_990), (40_000, 20_000)]
        {
            let point = |index: usize| Some([(index % period) as f64, 0.25, -1.0]);
            assert_eq!(count_repeated_points(count, point), Ok(count.saturating_sub(period)), "{count} of {period}");
        }
        let points = [[0.0, 1.0, 2.0], [f32::NAN; 3], [-0.0, 1.0, 2.0], [f32::NAN; 3], [0.0, 1.0, 2.0]];
        assert_eq!(count_repeated_points(5, |index| Some(points[index])), Ok(2));
        assert_eq!(count_repeated_points(5, |index| (index < 2).then_some(points[index])), Ok(0));
    }
}
