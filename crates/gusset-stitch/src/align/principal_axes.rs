//! An initial alignment by principal axes.

use super::alignment_scene::AlignmentScene;
use super::centred_piece::CentredPiece;
use super::pose::Pose;
use glam::{DMat3, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::linear::eigen::symmetric_eigen;
use gusset_base::job::Job;

/// Number of rounds for each of the four ways before they are compared.
const ROUNDS_PER_ROTATION: u32 = 10;

/// The four diagonal rotations: the identity, and half turns about the axes.
const DIAGONAL_ROTATIONS: [DVec3; 4] =
    [DVec3::ONE, DVec3::new(1.0, -1.0, -1.0), DVec3::new(-1.0, 1.0, -1.0), DVec3::new(-1.0, -1.0, 1.0)];

/// Returns one pose for each piece, which aligns its principal axes with the first piece's axes.
/// Tries the four diagonal rotations and keeps the one with the largest overlap. O(pieces)
/// alignments of two pieces.
pub(super) fn align_each_piece_by_principal_axes(scene: &AlignmentScene<'_>, job: &Job<'_>) -> Result<Vec<Pose>> {
    let count = scene.sampled_pieces.len();
    let mut poses = alloc::filled(Pose::IDENTITY, count)?;
    let Some(first) = scene.sampled_pieces.first() else {
        return Ok(poses);
    };
    let target = principal_axes(first.scan);
    for (k, pose) in poses.iter_mut().enumerate().skip(1) {
        let scan = scene.sampled_pieces[k].scan;
        let own = principal_axes(scan);
        let two = scene.sub_scene_of_two_pieces(0, k)?;
        let mut best = (-1.0, Pose::IDENTITY);
        for (way, turn) in DIAGONAL_ROTATIONS.into_iter().enumerate() {
            let part = job.sub_job_of_item(4 * (k - 1) + way, 4 * (count - 1));
            let rotation = target * DMat3::from_diagonal(turn) * own.transpose();
            let start = Pose { rotation, translation: first.scan.mean_of_corners - rotation * scan.mean_of_corners };
            let mut both = [Pose::IDENTITY, start];
            two.relax_poses(&mut both, ROUNDS_PER_ROTATION, &part)?;
            let reports = two.search_near_pieces_within(
                &both,
                super::assess::MAX_NEAR_SPACINGS,
                super::assess::MAX_ON_SURFACE_SPACINGS,
                &part.sub_job(1.0, 1.0),
            )?;
            let score = reports.iter().map(|(_, report)| report.samples_on_surface).sum::<usize>() as f64;
            if score > best.0 {
                best = (score, both[1]);
            }
        }
        *pose = best.1;
    }
    Ok(poses)
}

/// Returns the principal axes of a piece as columns, the longest first, right-handed.
fn principal_axes(scan: &CentredPiece) -> DMat3 {
    let (values, vectors) = symmetric_eigen(scan.covariance_of_corners);
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| values[j].total_cmp(&values[i]));
    let axis = |k: usize| DVec3::new(vectors[0][order[k]], vectors[1][order[k]], vectors[2][order[k]]);
    DMat3::from_cols(axis(0), axis(1), axis(0).cross(axis(1)))
}
