//! Vertices of triangles at equal positions as one vertex, by several threads.
//!
//! 1. Each thread lists the points of one part of the triangles, most points once, and sorts them into buckets by their hashes.
//! 2. Each thread finds the listed points that repeat earlier ones, in some of the buckets.
//! 3. The other listed points are the vertices, in the order of their first occurrence.
//! 4. Each thread numbers the corners of its part anew.
//!
//! Tables stay so small that a cache of the processor holds them.

use crate::error::ReadError;
use crate::parallel_fill::{MIN_PART, thread_count};
use crate::recent_points::RecentPoints;
use crate::vertex_merging::{Coordinate, PointHasher};
use gusset_base::sort::Buckets;
use gusset_base::{alloc, par};

/// Triangles whose corners are listed at a time.
const BATCH_TRIANGLES: usize = 256;
/// Points in a bucket of a mesh without boundary, on average.
const POINTS_PER_BUCKET: usize = 1 << 13;
/// Most buckets into which points are sorted.
const MAX_BUCKETS: usize = 1 << 11;

/// Points of a part of the triangles.
struct PointList<T> {
    points: Vec<[T; 3]>,
    buckets: Buckets<HashedPoint>,
}

/// The buckets of a list whose points begin at a place of all points.
struct PlacedBuckets {
    start: usize,
    buckets: Buckets<HashedPoint>,
}

/// A point of a list.
#[derive(Clone, Copy, Default)]
struct HashedPoint {
    hash: u32,
    index: u32,
}

/// Returns the points, and the vertex of each corner, of the triangles with corners at `triangle(index)`. Calls `triangle` once for
/// each triangle. The triangles have fewer than 2^32 corners.
pub(crate) fn merge_triangles<T: Coordinate + Send + Sync>(
    count: usize,
    triangle: impl Fn(usize) -> [[T; 3]; 3] + Sync,
) -> Result<(Vec<[T; 3]>, Vec<u32>), ReadError> {
    let part_length = count.div_ceil(thread_count()).max(MIN_PART);
    // A closed mesh has half as many vertices as triangles.
    let bucket_count = (count / 2 / POINTS_PER_BUCKET).clamp(1, MAX_BUCKETS);
    merge_parts(count, part_length, bucket_count, triangle)
}

fn merge_parts<T: Coordinate + Send + Sync>(
    count: usize,
    part_length: usize,
    bucket_count: usize,
    triangle: impl Fn(usize) -> [[T; 3]; 3] + Sync,
) -> Result<(Vec<[T; 3]>, Vec<u32>), ReadError> {
    let hasher = PointHasher::new();
    let threads = thread_count();
    let mut corners: Vec<[u32; 3]> = alloc::zeroed(count)?;
    let lists = par::map(threads, corners.chunks_mut(part_length).enumerate(), |(part, corners)| {
        list_points(part * part_length, corners, &triangle, hasher, bucket_count)
    })?;
    let (mut points, lists) = join_lists(alloc::try_collect(lists)?)?;
    let bucket_ranges = par::split_into_ranges(bucket_count, bucket_count.div_ceil(threads));
    let repeated = par::map(threads, bucket_ranges, |buckets| {
        let (mut table, mut repeated) = (Vec::new(), Vec::new());
        for bucket in buckets {
            find_repeated_points(&points, &lists, bucket, &mut table, &mut repeated)?;
        }
        Ok::<_, ReadError>(repeated)
    })?;
    let numbers = number_points(&mut points, &alloc::try_collect(repeated)?)?;
    par::map(threads, corners.chunks_mut(part_length).zip(&lists), |(corners, list)| {
        let numbers = &numbers[list.start..];
        for corner in corners.as_flattened_mut() {
            *corner = numbers[*corner as usize];
        }
    })?;
    Ok((points, corners.into_flattened()))
}

/// Lists the points of triangles from `start` on. Sets the corners to indices in the list.
fn list_points<T: Coordinate>(
    mut start: usize,
    corners: &mut [[u32; 3]],
    triangle: impl Fn(usize) -> [[T; 3]; 3],
    hasher: PointHasher,
    bucket_count: usize,
) -> Result<PointList<T>, ReadError> {
    let mut list = RecentPoints::new(corners.len() / 2, hasher)?;
    for corners in corners.chunks_mut(BATCH_TRIANGLES) {
        list.reserve(3 * corners.len())?;
        for (offset, corners) in corners.iter_mut().enumerate() {
            *corners = triangle(start + offset).map(|point| list.find_or_append(point));
        }
        start += corners.len();
    }
    let (points, hashes) = list.into_points_and_hashes();
    let hashed = hashes.iter().zip(0..).map(|(&hash, index)| {
        let bucket = ((u64::from(hash) * bucket_count as u64) >> 32) as usize;
        (bucket, HashedPoint { hash, index })
    });
    Ok(PointList { points, buckets: Buckets::new(bucket_count, HashedPoint::default(), hashed)? })
}

/// Returns the points of the lists one after the other.
fn join_lists<T: Copy>(lists: Vec<PointList<T>>) -> Result<(Vec<[T; 3]>, Vec<PlacedBuckets>), ReadError> {
    let mut placed = alloc::with_capacity(lists.len())?;
    let mut joined = Vec::new();
    for PointList { points, buckets } in lists {
        placed.push(PlacedBuckets { start: joined.len(), buckets });
        if joined.is_empty() {
            joined = points;
        } else {
            alloc::append(&mut joined, &points)?;
        }
    }
    Ok((joined, placed))
}

/// Appends the place of each point of a bucket that repeats an earlier one, and the place of the first point that it repeats.
fn find_repeated_points<T: Coordinate>(
    points: &[[T; 3]],
    lists: &[PlacedBuckets],
    bucket: usize,
    table: &mut Vec<[u32; 2]>,
    repeated: &mut Vec<[u32; 2]>,
) -> Result<(), ReadError> {
    let count: usize = lists.iter().map(|list| list.buckets.get(bucket).len()).sum();
    let slot_count = (2 * count).next_power_of_two();
    // For each slot: a hash, and one more than the place of the first point that has it, or 0.
    alloc::reset(table, slot_count, [0, 0])?;
    for list in lists {
        'points: for point in list.buckets.get(bucket) {
            let place = list.start as u32 + point.index;
            let mut slot = point.hash as usize & (slot_count - 1);
            while table[slot][1] > 0 {
                if table[slot][0] == point.hash {
                    let [known, added] = [table[slot][1] - 1, place].map(|place| points[place as usize]);
                    #[allow(clippy::eq_op)]
                    let is_nan = added != added;
                    if is_nan {
                        continue 'points;
                    }
                    if known == added {
                        alloc::push(repeated, [place, table[slot][1] - 1])?;
                        continue 'points;
                    }
                }
                slot = (slot + 1) & (slot_count - 1);
            }
            table[slot] = [point.hash, place + 1];
        }
    }
    Ok(())
}

/// Removes repeated points. Returns the new number of each point.
fn number_points<T: Copy>(points: &mut Vec<T>, repeated: &[Vec<[u32; 2]>]) -> Result<Vec<u32>, ReadError> {
    // 0, or one more than the place of the first point that a point repeats. Then the number of the point.
    let mut numbers: Vec<u32> = alloc::zeroed(points.len())?;
    for &[index, first] in repeated.iter().flatten() {
        numbers[index as usize] = first + 1;
    }
    let mut kept = 0;
    for index in 0..points.len() {
        numbers[index] = match numbers[index] {
            0 => {
                points[kept] = points[index];
                kept += 1;
                kept as u32 - 1
            }
            after_first => numbers[after_first as usize - 1],
        };
    }
    points.truncate(kept);
    Ok(numbers)
}

#[cfg(test)]
mod tests {
    use super::merge_parts;

    #[test]
    fn parts_are_merged_as_one() {
        // Points repeat at once, and after any number of triangles. NaN equals nothing; -0 equals 0.
        let triangle = |index: usize| {
            [index / 3 % 11, index * index % 700, index % 1300].map(|value| match value {
                13 => [f32::NAN, 0.0, 1.0],
                17 => [0.0, 17.0, -0.0],
                18 => [-0.0, 17.0, 0.0],
                value => [value as f32, 0.5, -1.0],
            })
        };
        let count = 5000;
        let whole = merge_parts(count, count, 1, triangle).expect("it fits");
        let mut known: Vec<[f32; 3]> = Vec::new();
        for (corner, point) in (0..count).flat_map(triangle).enumerate() {
            let vertex = known.iter().position(|&other| other == point).unwrap_or_else(|| {
                known.push(point);
                known.len() - 1
            });
            assert_eq!(whole.1[corner] as usize, vertex, "corner {corner}");
        }
        let bits = |points: &[[f32; 3]]| points.as_flattened().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&whole.0), bits(&known));
        for (part_length, buckets) in [(1, 1), (7, 5), (256, 64), (999, 1), (4999, 3), (count, 1000)] {
            let parts = merge_parts(count, part_length, buckets, triangle).expect("it fits");
            let label = format!("parts of {part_length}, {buckets} buckets");
            assert_eq!((bits(&parts.0), &parts.1), (bits(&known), &whole.1), "{label}");
        }
        assert_eq!(merge_parts(0, 4, 1, triangle).expect("it fits"), (Vec::new(), Vec::new()));
    }
}
