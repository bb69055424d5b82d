//! The rounds: pairs are looked for, and the motions that fit them best are applied, until nothing
//! moves.

use super::motion_system::System;
use super::pose::Pose;
use super::sample_pairs::Found;
use super::scene::{MIN_PAIRS, Scene};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;

/// The gate is so many times the distance of pairs in the round before.
const GATE: f64 = 3.0;
/// In the first stage one of so many samples looks, in the second each.
const PARTS: [usize; 2] = [4, 1];
/// Nothing moves if no point does by more than this part of the spacing, in each stage.
const STILL: [f64; 2] = [0.05, 0.001];

impl Scene<'_> {
    /// Moves the pieces until nothing moves, or for so many rounds in each of two stages; the first
    /// of all that hang together stays. Returns the rounds, and whether nothing moved in the end.
    pub(super) fn relax(&self, poses: &mut [Pose], rounds: u32, job: &Job<'_>) -> Result<(u32, bool)> {
        let (mut done, mut is_still) = (0, true);
        for stage in 0..PARTS.len() {
            let mut looks = self.looks(poses)?;
            let job = job.share(stage, PARTS.len());
            for round in 0..rounds {
                let part = job.share(round as usize, rounds as usize);
                let found = self.find(poses, &looks, PARTS[stage], 1.0, &part)?;
                for (look, (_, found)) in looks.iter_mut().zip(&found) {
                    look.gate = match found.near {
                        n if n < MIN_PAIRS => self.reach,
                        _ => (GATE * found.distance.max(self.spacing(look.pieces))).min(self.reach),
                    };
                }
                done += 1;
                is_still = self.step(poses, &found)? <= STILL[stage];
                if is_still {
                    break;
                }
            }
        }
        Ok((done, is_still))
    }

    /// Applies the motions that fit the pairs best, and returns how far a point moved at the most,
    /// in spacings.
    fn step(&self, poses: &mut [Pose], found: &[([usize; 2], Found)]) -> Result<f64> {
        let count = self.members.len();
        let mut together = DisjointSets::new(count)?;
        let enough = |found: &&([usize; 2], Found)| found.1.near >= MIN_PAIRS;
        for ([i, k], _) in found.iter().filter(enough) {
            together.union(*i as u32, *k as u32);
        }
        let mut seen = alloc::filled(false, count)?;
        let mut stays = alloc::filled(true, count)?;
        for (k, stays) in stays.iter_mut().enumerate() {
            let root = together.find(k as u32) as usize;
            (*stays, seen[root]) = (!seen[root], true);
        }
        let mut system = System::new(&stays)?;
        for (pair, found) in found.iter().filter(enough) {
            system.enter(*pair, &found.equations)?;
        }
        let mut moved = 0.0f64;
        for (k, [a, b, c, x, y, z]) in system.solve()?.into_iter().enumerate() {
            let scan = self.members[k].scan;
            let (turn, shift) = (DVec3::new(a, b, c) / scan.radius, DVec3::new(x, y, z));
            if stays[k] || !turn.is_finite() || !shift.is_finite() {
                continue;
            }
            let step = Pose::about(poses[k].point(scan.mean), turn, shift);
            poses[k] = poses[k].then(&step).straightened();
            moved = moved.max((turn.length() * scan.bounds.diagonal() + shift.length()) / scan.spacing);
        }
        Ok(moved)
    }
}
