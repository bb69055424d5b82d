//! The reason why a loop that could carry a strip was left.
//!
//! The reason refers to the loop that is nearest to most of its vertices. Loops of other components
//! take precedence over loops of the same component.

use super::assemble_request::Reason;
use super::candidates::{FacingSearch, LoopVisitCounter, STAGE};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_base::sort;

/// Number of loops between two progress reports.
const LOOPS_PER_REPORT: usize = 1 << 8;

/// The reason why a loop was left, and its distance from the nearest loop.
pub(super) struct LeftLoopExplanation {
    pub(super) reason: Reason,
    /// The mean distance to the nearest vertices of that loop, in the rims' unit; infinite without
    /// another loop.
    pub(super) mean_gap: f64,
    /// The largest distance at which they would be joined, in the rims' unit; 0 without another
    /// loop.
    pub(super) allowed_gap: f64,
}

impl FacingSearch<'_> {
    /// Explains each loop that `left` marks. `used` must mark the loops with strips.
    ///
    /// O(V log V) for V vertices on loops.
    pub(super) fn explain_left_loops(&self, left: &[bool], job: &Job<'_>) -> Result<Vec<Option<LeftLoopExplanation>>> {
        if !left.contains(&true) {
            return alloc::collect(left.iter().map(|_| None));
        }
        let loops = self.collect_loop_vertices()?;
        let tree = KdTree::with_groups(&loops.points, &loops.loop_of_vertex, &job.sub_job(0.0, 0.2), STAGE)?;
        let looks = LoopVisitCounter::default();
        let nearest = |r: usize, own: bool, job: &Job<'_>| -> Result<Option<(usize, f64)>> {
            let mut seen = alloc::with_capacity(self.rims[r].points.len())?;
            for &p in &self.rims[r].points {
                if looks.take_report_due() {
                    job.step(0.0, STAGE)?;
                }
                let accept = |v: u32| {
                    looks.count_visit();
                    let k = loops.loop_of_vertex[v as usize] as usize;
                    k != r && (self.candidates[k].component == self.candidates[r].component) == own
                };
                if let Some((squared, v)) = tree.nearest_in_other_groups(p, f64::INFINITY, r as u32, accept) {
                    seen.push((loops.loop_of_vertex[v as usize] as usize, squared.sqrt()));
                }
            }
            sort::sort_stable(&mut seen, &|x, y| x.0.cmp(&y.0).then(x.1.total_cmp(&y.1)));
            let groups = seen.chunk_by(|x, y| x.0 == y.0);
            let most = groups.rev().max_by_key(|group| group.len());
            Ok(most.map(|group| (group[0].0, group.iter().map(|seen| seen.1).sum::<f64>() / group.len() as f64)))
        };
        let job = job.sub_job(0.2, 1.0);
        alloc::try_collect((0..left.len()).map(|r| {
            job.step_every(LOOPS_PER_REPORT, r, left.len(), STAGE)?;
            if !left[r] {
                return Ok(None);
            }
            let allowed = self.max_slit_gap(r);
            let gap = self.slits[r].filter(|slit| slit.may_be_closed).map_or(0.0, |slit| slit.mean_gap);
            if gap > allowed && !self.is_excluded_pair(r, r) {
                return Ok(Some(LeftLoopExplanation { reason: Reason::TooFar, mean_gap: gap, allowed_gap: allowed }));
            }
            let share = job.sub_job_of_item(r, left.len());
            let (found, own) = match nearest(r, self.within_components, &share)? {
                Some(found) => (Some(found), self.within_components),
                None => (nearest(r, !self.within_components, &share)?, !self.within_components),
            };
            let Some((k, gap)) = found else {
                return Ok(Some(LeftLoopExplanation {
                    reason: Reason::Alone,
                    mean_gap: f64::INFINITY,
                    allowed_gap: 0.0,
                }));
            };
            let allowed = self.max_gap_between_whole_loops(r, k);
            let reason = match () {
                _ if own && !self.within_components => Reason::SameComponent,
                _ if self.is_excluded_pair(r, k) => Reason::Excluded,
                _ if gap > allowed => Reason::TooFar,
                _ if self.is_joined_loop[k] => Reason::Taken,
                _ => Reason::LooksAway,
            };
            Ok(Some(LeftLoopExplanation { reason, mean_gap: gap, allowed_gap: allowed }))
        }))
    }
}
