//! Normals and texture coordinates, from their indices at corners.

use super::obj_chunk::ABSENT;
use crate::error::ReadError;
use crate::mesh::Values;

/// Marks indices of values that begin with NaN as absent.
pub(super) fn drop_missing_values<const N: usize>(values: &[[f64; N]], indices: &mut [u32]) {
    if values.iter().any(|value| value[0].is_nan()) {
        for index in indices {
            if *index != ABSENT && values[*index as usize][0].is_nan() {
                *index = ABSENT;
            }
        }
    }
}

/// Makes values at vertices if all corners of each vertex agree bit for bit, and else at corners. Reuses the list if its order is the
/// order of the vertices.
///
/// `indices` has an index below `values.len()` or `ABSENT` for each corner, or is empty.
pub(super) fn values_from_lists<const N: usize>(
    values: Vec<[f64; N]>,
    indices: &[u32],
    corners: &[u32],
    vertex_count: usize,
) -> Result<Values<N>, ReadError> {
    if values.len() == vertex_count && indices == corners && !corners.is_empty() {
        return Ok(Values::Vertices(values));
    }
    values_from_indices(&values, indices, corners, vertex_count)
}

/// Makes values as [`values_from_lists`] does, of a part of the indices.
pub(super) fn values_from_indices<const N: usize>(
    values: &[[f64; N]],
    indices: &[u32],
    corners: &[u32],
    vertex_count: usize,
) -> Result<Values<N>, ReadError> {
    if indices.iter().all(|&index| index == ABSENT) {
        return Ok(Values::Absent);
    }
    let value_at = |index: u32| values.get(index as usize).copied().unwrap_or(Values::<N>::MISSING);
    if let Some(of_vertices) = indices_of_vertices(values, indices, corners, vertex_count)? {
        return Ok(Values::Vertices(collected(of_vertices.iter().map(|&index| value_at(index)))?));
    }
    Ok(Values::Corners(collected(indices.iter().map(|&index| value_at(index)))?))
}

fn collected<T>(items: impl ExactSizeIterator<Item = T>) -> Result<Vec<T>, ReadError> {
    let mut all = Vec::new();
    all.try_reserve_exact(items.len())?;
    all.extend(items);
    Ok(all)
}

/// Returns the index for each vertex, `ABSENT` for vertices without corners; `None` if corners disagree or lack values.
fn indices_of_vertices<const N: usize>(
    values: &[[f64; N]],
    indices: &[u32],
    corners: &[u32],
    vertex_count: usize,
) -> Result<Option<Vec<u32>>, ReadError> {
    let bits = |index: u32| values[index as usize].map(f64::to_bits);
    let mut of_vertices = Vec::new();
    of_vertices.try_reserve_exact(vertex_count)?;
    of_vertices.resize(vertex_count, ABSENT);
    for (&index, &vertex) in indices.iter().zip(corners) {
        if index == ABSENT {
            return Ok(None);
        }
        let known = &mut of_vertices[vertex as usize];
        if *known == ABSENT {
            *known = index;
        } else if *known != index && bits(*known) != bits(index) {
            return Ok(None);
        }
    }
    Ok(Some(of_vertices))
}
