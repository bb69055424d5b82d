//! Faces between neighbours in a scanner's grid.

use super::room::make_room;
use crate::error::ReadError;
use crate::mesh::Mesh;
use gusset_base::alloc;

/// The entry of a place in the grid where the scanner saw nothing.
pub(super) const UNSEEN: u32 = u32::MAX;

/// Longest edge of a triangle, in median edges. Longer edges span steps between surfaces.
const MAX_EDGE_RATIO: f32 = 4.0;

/// Joins neighbours in the grid, row by row, by triangles without long edges. Cells with three points get one triangle; cells with
/// four points are split at the shorter diagonal.
pub(super) fn add_range_faces(mesh: &mut Mesh, grid: &[u32], columns: usize) -> Result<(), ReadError> {
    let Some(median) = median_edge(mesh, grid, columns)? else { return Ok(()) };
    let mut rows = grid.chunks_exact(columns);
    let Some(mut above) = rows.next() else { return Ok(()) };
    for below in rows {
        for column in 1..columns {
            let cell = [above[column - 1], above[column], below[column], below[column - 1]];
            for triangle in cell_triangles(mesh, cell).into_iter().flatten() {
                if triangle_edges(mesh, triangle).iter().all(|edge| *edge <= MAX_EDGE_RATIO * median) {
                    make_room(&mut mesh.corners, 3)?;
                    mesh.corners.extend(triangle);
                    make_room(&mut mesh.face_offsets, 1)?;
                    let end = u32::try_from(mesh.corners.len()).map_err(|_| ReadError::out_of_memory())?;
                    mesh.face_offsets.push(end);
                }
            }
        }
        above = below;
    }
    Ok(())
}

fn cell_triangles(mesh: &Mesh, cell: [u32; 4]) -> [Option<[u32; 3]>; 2] {
    let mut seen = [0; 4];
    let mut count = 0;
    for vertex in cell {
        // Scanners also say by NaN that nothing was seen.
        if vertex != UNSEEN && mesh.positions.get(vertex as usize).iter().all(|x| x.is_finite()) {
            seen[count] = vertex;
            count += 1;
        }
    }
    let [a, b, c, d] = seen;
    match count {
        3 => [Some([a, b, c]), None],
        4 if distance(mesh, a, c) <= distance(mesh, b, d) => [Some([a, b, c]), Some([a, c, d])],
        4 => [Some([a, b, d]), Some([b, c, d])],
        _ => [None, None],
    }
}

fn triangle_edges(mesh: &Mesh, [a, b, c]: [u32; 3]) -> [f32; 3] {
    [distance(mesh, a, b), distance(mesh, b, c), distance(mesh, c, a)]
}

fn distance(mesh: &Mesh, a: u32, b: u32) -> f32 {
    let [p, q] = [a, b].map(|vertex| mesh.positions.get(vertex as usize));
    (0..3).map(|axis| (p[axis] - q[axis]).powi(2)).sum::<f64>().sqrt() as f32
}

/// Bits that each pass of the selection decides: their place and number.
const PASSES: [[u32; 2]; 3] = [[21, 11], [10, 11], [0, 10]];

/// Returns the median of all positive lengths of triangles' edges. Selects it by the upper bits of the lengths
/// first, so that no list of lengths is needed.
fn median_edge(mesh: &Mesh, grid: &[u32], columns: usize) -> Result<Option<f32>, ReadError> {
    let mut found = 0;
    let mut rank = None;
    for [shift, width] in PASSES {
        let mut counts = alloc::filled(0_u64, 1 << width)?;
        visit_edges(mesh, grid, columns, |edge| {
            let bits = edge.to_bits();
            if rank.is_none() || bits >> (shift + width) == found {
                counts[(bits >> shift & ((1 << width) - 1)) as usize] += 1;
            }
        });
        let Some((next, rest)) = bucket(&counts, rank.unwrap_or_else(|| counts.iter().sum::<u64>() / 2)) else {
            return Ok(None);
        };
        found = found << width | next;
        rank = Some(rest);
    }
    Ok(Some(f32::from_bits(found)))
}

/// Calls `visit` with all positive lengths of triangles' edges.
fn visit_edges(mesh: &Mesh, grid: &[u32], columns: usize, mut visit: impl FnMut(f32)) {
    let mut rows = grid.chunks_exact(columns);
    let Some(mut above) = rows.next() else { return };
    for below in rows {
        for column in 1..columns {
            let cell = [above[column - 1], above[column], below[column], below[column - 1]];
            for triangle in cell_triangles(mesh, cell).into_iter().flatten() {
                triangle_edges(mesh, triangle).into_iter().filter(|edge| *edge > 0.0).for_each(&mut visit);
            }
        }
        above = below;
    }
}

/// Returns the bucket of the entry with this rank, and its rank in the bucket.
fn bucket(counts: &[u64], rank: u64) -> Option<(u32, u64)> {
    let mut before = 0;
    for (index, &count) in counts.iter().enumerate() {
        if rank < before + count {
            return Some((index as u32, rank - before));
        }
        before += count;
    }
    None
}
