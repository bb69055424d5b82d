//! Vertices of triangles at equal positions as one vertex, by several threads.
//!
//! Each thread merges the points of a part of the triangles. The vertices of the parts are then merged in the order of the parts, so that
//! they are numbered by their first occurrence, as if one thread had merged all.

use crate::error::ReadError;
use crate::parallel_fill::{MIN_PART, thread_count};
use crate::vertex_merging::{Coordinate, VertexMerger};
use bytemuck::Zeroable;
use gusset_base::alloc;

/// Triangles whose corners are merged at a time.
const BATCH_TRIANGLES: usize = 256;

/// Returns the points, and the vertex of each corner, of the triangles with corners at `triangle(index)`.
pub(crate) fn merge_triangles<T: Coordinate + Zeroable + Send>(
    count: usize,
    triangle: impl Fn(usize) -> [[T; 3]; 3] + Sync,
) -> Result<(Vec<[T; 3]>, Vec<u32>), ReadError> {
    let part_length = count.div_ceil(thread_count()).max(MIN_PART);
    merge_parts(count, part_length, triangle)
}

fn merge_parts<T: Coordinate + Zeroable + Send>(
    count: usize,
    part_length: usize,
    triangle: impl Fn(usize) -> [[T; 3]; 3] + Sync,
) -> Result<(Vec<[T; 3]>, Vec<u32>), ReadError> {
    let merge_part = |part: usize, corners: &mut [[u32; 3]]| -> Result<VertexMerger<T>, ReadError> {
        // A closed mesh has half as many vertices as triangles. The first part takes the vertices of all parts.
        let triangles = if part == 0 { count } else { corners.len() };
        let mut merger = VertexMerger::new(triangles / 2)?;
        let mut points = [[T::zeroed(); 3]; 3 * BATCH_TRIANGLES];
        let mut start = part * part_length;
        for corners in corners.chunks_mut(BATCH_TRIANGLES) {
            let points = &mut points[..3 * corners.len()];
            for (offset, points) in points.as_chunks_mut::<3>().0.iter_mut().enumerate() {
                *points = triangle(start + offset);
            }
            start += corners.len();
            merger.number(points, corners.as_flattened_mut())?;
        }
        Ok(merger)
    };
    let mut corners: Vec<[u32; 3]> = alloc::zeroed(count)?;
    let mut mergers = alloc::gather((0..count.div_ceil(part_length).max(1)).map(|_| None))?;
    std::thread::scope(|scope| {
        let merge_part = &merge_part;
        let mut parts = corners.chunks_mut(part_length).zip(&mut mergers).enumerate();
        let first = parts.next();
        for (part, (corners, merger)) in parts {
            // A part whose thread does not start is merged below.
            let _ = std::thread::Builder::new().spawn_scoped(scope, move || *merger = Some(merge_part(part, corners)));
        }
        if let Some((part, (corners, merger))) = first {
            *merger = Some(merge_part(part, corners));
        }
    });
    let mut all: Option<VertexMerger<T>> = None;
    let mut parts = corners.chunks_mut(part_length);
    for (part, merger) in mergers.into_iter().enumerate() {
        let corners = parts.next().unwrap_or_default();
        let merger = merger.unwrap_or_else(|| merge_part(part, corners))?;
        let Some(all) = &mut all else {
            all = Some(merger);
            continue;
        };
        let mut vertices = alloc::filled(0, merger.len())?;
        all.number(merger.points(), &mut vertices)?;
        drop(merger);
        for corner in corners.as_flattened_mut() {
            *corner = vertices[*corner as usize];
        }
    }
    Ok((all.map(VertexMerger::into_points).unwrap_or_default(), corners.into_flattened()))
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
        let whole = merge_parts(count, count, triangle).expect("it fits");
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
        for part_length in [1, 7, 256, 999, 4999] {
            let parts = merge_parts(count, part_length, triangle).expect("it fits");
            assert_eq!((bits(&parts.0), &parts.1), (bits(&known), &whole.1), "parts of {part_length}");
        }
        assert_eq!(merge_parts(0, 4, triangle).expect("it fits"), (Vec::new(), Vec::new()));
    }
}
