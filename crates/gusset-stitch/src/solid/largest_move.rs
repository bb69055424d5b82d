//! The largest move of a vertex.

use super::repair_state::RepairState;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::overflow_safe_distance;
use gusset_mesh::{MeshView, NONE};

/// Returns the largest distance between a corner of the input and the vertex of the input in its place; 0 if no
/// remaining vertex was merged into another. O(H log p) for H half-edges and p pieces.
pub(super) fn measure_largest_move(state: &RepairState, pieces: &[MeshView<'_>]) -> Result<f64> {
    let ends = pieces.iter().scan(0, |end, piece| {
        *end += piece.faces().half_edge_count() as u32;
        Some(*end)
    });
    let ends = alloc::gather(ends)?;
    let source = |corner: u32| {
        let piece = ends.partition_point(|&end| end <= corner);
        let first = piece.checked_sub(1).map_or(0, |before| ends[before]);
        pieces[piece].positions().get(pieces[piece].faces().corner(corner - first))
    };
    let mut largest = 0.0_f64;
    for (&v, place) in state.mesh.face_corners.iter().zip(&state.corner_places) {
        let [corner, second, _] = place.corners;
        if corner != NONE && second == NONE && state.vertex_origin[v as usize] != NONE {
            let [from, to] = [source(corner), state.mesh.positions.get(v)];
            if from != to {
                largest = largest.max(overflow_safe_distance(from, to));
            }
        }
    }
    Ok(largest)
}
