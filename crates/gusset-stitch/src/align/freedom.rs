//! The directions in which overlaps do not hold a piece.

use super::motion_system::Six;
use super::sample_pairs::Found;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::linear::eigen::eigen;

/// What holds a piece.
#[derive(Clone, Copy)]
pub(super) struct Hold {
    /// The least eigenvalue of the mean of its equations: the mean squared change of distances
    /// along normals for the motion of length 1 that changes them least.
    pub(super) least: f64,
    /// As much of it as the noise of normals makes, where the surfaces do not.
    pub(super) noise: f64,
}

/// What holds each piece, with all others where they are.
///
/// Errors of normals look like slopes that hold. If each of the two normals of a pair has errors of
/// variance s in either direction, the mean of 1 less the cosine between them is 2 s, and the
/// variance of their mean normal s / 2.
pub(super) fn holds(count: usize, found: &[([usize; 2], Found)]) -> Result<Vec<Hold>> {
    let mut own: Vec<([Six; 6], f64, f64)> = alloc::filled(([[0.0; 6]; 6], 0.0, 0.0), count)?;
    for (pieces, found) in found {
        let equations = &found.equations;
        for (k, &piece) in pieces.iter().enumerate() {
            let (sum, weight, turn) = &mut own[piece];
            for (i, row) in sum.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    *entry += equations.matrix[6 * k + i.max(j)][6 * k + i.min(j)];
                }
            }
            *weight += equations.weight;
            *turn += equations.weight * found.turn;
        }
    }
    alloc::collect(own.into_iter().map(|(sum, weight, turn)| {
        if weight <= 0.0 {
            return Hold { least: 0.0, noise: 0.0 };
        }
        let (values, _) = eigen(sum.map(|row| row.map(|x| x / weight)));
        Hold { least: values.into_iter().fold(f64::INFINITY, f64::min).max(0.0), noise: turn / weight / 4.0 }
    }))
}
