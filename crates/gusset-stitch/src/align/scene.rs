//! The pieces that are aligned with each other, and who is near whom.

use super::along::look_along;
use super::member::Member;
use super::pose::Pose;
use super::sample_pairs::{Found, Placed, STAGE, look};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::par;

/// Fewer pairs say nothing of two pieces.
pub(super) const MIN_PAIRS: usize = 10;

/// Pieces that are aligned with each other.
pub(super) struct Scene<'a> {
    pub(super) members: Vec<Member<'a>>,
    /// Pairs of points are never farther apart.
    pub(super) reach: f64,
}

/// A piece that looks for its samples on another, up to a distance.
#[derive(Clone, Copy)]
pub(super) struct Look {
    pub(super) pieces: [usize; 2],
    pub(super) gate: f64,
}

impl<'a> Scene<'a> {
    /// Two of the pieces alone.
    pub(super) fn pair(&self, i: usize, k: usize) -> Result<Scene<'a>> {
        Ok(Scene { members: alloc::collect([i, k].map(|k| self.members[k]).into_iter())?, reach: self.reach })
    }

    /// The distance of points on the coarser of two pieces.
    pub(super) fn spacing(&self, pieces: [usize; 2]) -> f64 {
        let [a, b] = pieces.map(|k| {
            let member = &self.members[k];
            member.rim.map_or(member.scan.spacing, |(rim, _)| rim.step)
        });
        a.max(b)
    }

    /// The looks at pieces that are near enough, each way, up to a distance.
    pub(super) fn looks(&self, poses: &[Pose]) -> Result<Vec<Look>> {
        let bounds = |k: usize| &self.members[k].scan.bounds;
        let is_there = |k: usize| !self.members[k].scan.used.is_empty();
        let is_near = |[i, k]: [usize; 2]| {
            let [p, q] = [i, k].map(|k| poses[k].point(bounds(k).centre()));
            p.distance(q) <= (bounds(i).diagonal() + bounds(k).diagonal()) / 2.0 + self.reach
        };
        let count = self.members.len();
        let all = (0..count).flat_map(|i| (0..count).map(move |k| [i, k]));
        let near = all.filter(|&[i, k]| i != k && is_there(i) && is_there(k) && is_near([i, k]));
        alloc::gather(near.map(|pieces| Look { pieces, gate: self.reach }))
    }

    /// What the pieces find on each other, each with one of `part` of its samples. `on`: the
    /// distance that counts as on a surface, in spacings.
    pub(super) fn find(
        &self,
        poses: &[Pose],
        looks: &[Look],
        part: usize,
        on: f64,
        job: &Job<'_>,
    ) -> Result<Vec<([usize; 2], Found)>> {
        let found = par::map_jobs(job, STAGE, looks.iter(), |look_at, job| {
            let [a, b] = look_at.pieces.map(|k| Placed { member: &self.members[k], pose: poses[k] });
            let reach = on * self.spacing(look_at.pieces);
            let samples = a.member.samples;
            match (a.member.rim, b.member.rim) {
                (Some((rim, _)), Some(other)) => look_along(&a, rim, &b, other, look_at.gate, reach, job),
                _ => look(&a, samples.iter().step_by(part), &b, look_at.gate, reach, job),
            }
        })?;
        alloc::collect(looks.iter().zip(found).map(|(look, found)| (look.pieces, found)))
    }

    /// What the pieces find on each other within so many spacings.
    pub(super) fn find_within(
        &self,
        poses: &[Pose],
        within: f64,
        on: f64,
        job: &Job<'_>,
    ) -> Result<Vec<([usize; 2], Found)>> {
        let mut looks = self.looks(poses)?;
        // No farther than pairs may be.
        looks.iter_mut().for_each(|look| look.gate = (within * self.spacing(look.pieces)).min(self.reach));
        self.find(poses, &looks, 1, on, job)
    }
}
