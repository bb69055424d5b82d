//! The stiffness of overlaps: the directions in which they do not hold a piece.

use super::motion_system::MotionVector;
use super::sample_pairs::SamplePairReport;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::linear::eigen::symmetric_eigen;

/// The stiffness with which overlaps hold a piece.
#[derive(Clone, Copy)]
pub(super) struct HoldStiffness {
    /// The least eigenvalue of the mean of the equations: the mean squared change of distances
    /// along normals, for the weakest motion of length 1.
    pub(super) least_eigenvalue: f64,
    /// The part of `least_eigenvalue` that noise of the normals explains.
    pub(super) eigenvalue_part_by_noise: f64,
}

/// Returns how the overlaps hold each piece if all other pieces are fixed.
///
/// Errors of normals look like slopes that hold a piece. Suppose that both normals of a pair have
/// errors of variance s in each direction. Then the mean of 1 minus the cosine between them is 2 s,
/// and the variance of their mean normal is s / 2.
pub(super) fn measure_hold_stiffness(
    count: usize,
    reports: &[([usize; 2], SamplePairReport)],
) -> Result<Vec<HoldStiffness>> {
    let mut own: Vec<([MotionVector; 6], f64, f64)> = alloc::filled(([[0.0; 6]; 6], 0.0, 0.0), count)?;
    for (pieces, report) in reports {
        let equations = &report.equations;
        for (k, &piece) in pieces.iter().enumerate() {
            let (sum, weight, turn) = &mut own[piece];
            for (i, row) in sum.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    *entry += equations.matrix[6 * k + i.max(j)][6 * k + i.min(j)];
                }
            }
            *weight += equations.weight_sum;
            *turn += equations.weight_sum * report.mean_normal_deviation;
        }
    }
    alloc::collect(own.into_iter().map(|(sum, weight, turn)| {
        if weight <= 0.0 {
            return HoldStiffness { least_eigenvalue: 0.0, eigenvalue_part_by_noise: 0.0 };
        }
        let (values, _) = symmetric_eigen(sum.map(|row| row.map(|x| x / weight)));
        HoldStiffness {
            least_eigenvalue: values.into_iter().fold(f64::INFINITY, f64::min).max(0.0),
            eigenvalue_part_by_noise: turn / weight / 4.0,
        }
    }))
}
