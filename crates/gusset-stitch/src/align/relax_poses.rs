//! The rounds: pairs are searched and the best motions applied, until nothing moves.

use super::alignment_scene::{AlignmentScene, MIN_COUPLING_PAIRS};
use super::motion_system::MotionSystem;
use super::pose::Pose;
use super::sample_pairs::SamplePairReport;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;

/// The largest distance of a pair is this multiple of the distance of pairs in the previous round.
const MAX_DISTANCE_TO_PAIR_DISTANCE_RATIO: f64 = 3.0;
/// In the first stage every fourth sample is used, in the second all.
const SAMPLE_STRIDES_PER_STAGE: [usize; 2] = [4, 1];
/// A stage ends if every point moves by at most this fraction of the spacing.
const MAX_RESTING_MOTION_SPACINGS: [f64; 2] = [0.05, 0.001];

impl AlignmentScene<'_> {
    /// Moves the pieces until nothing moves, or for the given number of rounds in each of two
    /// stages. In each connected set of pieces the first is fixed. Returns the number of rounds,
    /// and whether nothing moved at the end.
    pub(super) fn relax_poses(&self, poses: &mut [Pose], rounds: u32, job: &Job<'_>) -> Result<(u32, bool)> {
        let (mut done, mut is_still) = (0, true);
        for stage in 0..SAMPLE_STRIDES_PER_STAGE.len() {
            let mut looks = self.list_searches_of_near_pieces(poses)?;
            let job = job.sub_job_of_item(stage, SAMPLE_STRIDES_PER_STAGE.len());
            for round in 0..rounds {
                let part = job.sub_job_of_item(round as usize, rounds as usize);
                let reports = self.run_searches(poses, &looks, SAMPLE_STRIDES_PER_STAGE[stage], 1.0, &part)?;
                for (look, (_, report)) in looks.iter_mut().zip(&reports) {
                    look.max_distance = match report.near_samples {
                        n if n < MIN_COUPLING_PAIRS => self.max_pair_distance,
                        _ => (MAX_DISTANCE_TO_PAIR_DISTANCE_RATIO
                            * report.rms_distance.max(self.coarser_spacing(look.pieces)))
                        .min(self.max_pair_distance),
                    };
                }
                done += 1;
                is_still = self.move_to_best_fit(poses, &reports)? <= MAX_RESTING_MOTION_SPACINGS[stage];
                if is_still {
                    break;
                }
            }
        }
        Ok((done, is_still))
    }

    /// Applies the motions that fit the pairs best. Returns the largest motion of a point, in
    /// spacings.
    fn move_to_best_fit(&self, poses: &mut [Pose], reports: &[([usize; 2], SamplePairReport)]) -> Result<f64> {
        let count = self.sampled_pieces.len();
        let mut together = DisjointSets::new(count)?;
        let enough = |report: &&([usize; 2], SamplePairReport)| report.1.near_samples >= MIN_COUPLING_PAIRS;
        for ([i, k], _) in reports.iter().filter(enough) {
            together.union(*i as u32, *k as u32);
        }
        let mut seen = alloc::filled(false, count)?;
        let mut stays = alloc::filled(true, count)?;
        for (k, stays) in stays.iter_mut().enumerate() {
            let root = together.find(k as u32) as usize;
            (*stays, seen[root]) = (!seen[root], true);
        }
        let mut system = MotionSystem::new(&stays)?;
        for (pair, report) in reports.iter().filter(enough) {
            system.add_pair_equations(*pair, &report.equations)?;
        }
        let mut moved = 0.0f64;
        for (k, [a, b, c, x, y, z]) in system.solve_motions()?.into_iter().enumerate() {
            let scan = self.sampled_pieces[k].scan;
            let (turn, shift) = (DVec3::new(a, b, c) / scan.radius, DVec3::new(x, y, z));
            if stays[k] || !turn.is_finite() || !shift.is_finite() {
                continue;
            }
            let step = Pose::rotation_about(poses[k].transform_point(scan.mean_of_corners), turn, shift);
            poses[k] = poses[k].followed_by(&step).with_orthonormal_axes();
            moved = moved.max((turn.length() * scan.bounds.diagonal() + shift.length()) / scan.spacing);
        }
        Ok(moved)
    }
}
