//! Pairs among the loops that the other rules leave: each other's nearest, with nobody else near.
//!
//! The loops in question have no partner yet, whole or in part. A vertex sees the nearest vertex
//! of such a loop on another piece and component. Two loops are joined under three conditions:
//!
//! * At least [`MIN_SEEING_VERTEX_SHARE`] of the vertices of each loop see the other loop.
//! * They look at each other, as other whole loops do, and do not lie beside each other.
//! * Their gap is at most [`MAX_LONE_GAP_RATIO`] times the limit of other whole loops.
//!
//! The rule is repeated, because a pair that is found no longer stands near others.

use super::assemble_request::Extent;
use super::candidates::{FacingLoops, FacingSearch, LoopMeasures, LoopVisitCounter, STAGE};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_mesh::NONE;

/// The largest gap of a lone pair, relative to the limit of other whole loops.
const MAX_LONE_GAP_RATIO: f64 = 3.0;

/// The smallest fraction of the vertices of each loop that see the other loop.
const MIN_SEEING_VERTEX_SHARE: f64 = 0.75;

/// A vertex sees loops within this multiple of the limit, as a gap is wider in places.
const MAX_SEEN_DISTANCE_RATIO: f64 = 2.0 * MAX_LONE_GAP_RATIO;

/// Number of evenly spaced vertices of a loop that search for other loops.
const MAX_SEEING_SAMPLES: usize = 1 << 7;

/// Number of times that the rule is applied.
const MAX_ROUNDS: usize = 8;

impl FacingSearch<'_> {
    /// Returns the lone pairs among the loops that are not joined. Finds none if a limit is given,
    /// or if whole loops are not joined.
    ///
    /// O(V log V) for V vertices on loops.
    pub(super) fn pair_lone_loops(&self, job: &Job<'_>) -> Result<Vec<FacingLoops>> {
        let mut found = Vec::new();
        let is_whole = |r: usize| self.slits[r].is_none() && self.candidates[r].piece != NONE;
        let mut is_free = alloc::collect((0..self.rims.len()).map(|r| !self.is_joined_loop[r] && is_whole(r)))?;
        if self.max_gap.is_some() || self.extent == Extent::Parts {
            return Ok(found);
        }
        for round in 0..MAX_ROUNDS {
            let mut free = (0..is_free.len()).filter(|&r| is_free[r]);
            let first = free.next().map(|r| self.candidates[r].piece);
            if free.all(|r| Some(self.candidates[r].piece) == first) {
                break;
            }
            let before = found.len();
            let part = job.sub_job_of_item(round, MAX_ROUNDS);
            let seen = self.find_loops_seen_by_most(&is_free, &part)?;
            for (r, &k) in seen.iter().enumerate() {
                if k == NONE || k as usize <= r || seen[k as usize] as usize != r {
                    continue;
                }
                if let Some(mean_gap) = self.gap_of_lone_pair(r, k as usize, &part.sub_job(1.0, 1.0))? {
                    alloc::push(&mut found, FacingLoops { rims: [r, k as usize], arcs: None, mean_gap })?;
                }
            }
            if found.len() == before {
                break;
            }
            found[before..].iter().flat_map(|pair| pair.rims).for_each(|r| is_free[r] = false);
        }
        Ok(found)
    }

    /// Returns the loop that most vertices of each free loop see, or [`NONE`].
    fn find_loops_seen_by_most(&self, is_free: &[bool], job: &Job<'_>) -> Result<Vec<u32>> {
        let free = || (0..self.rims.len()).filter(|&r| is_free[r]);
        let points = alloc::gather(free().flat_map(|r| self.rims[r].points.iter().copied()))?;
        let owners = alloc::gather(free().flat_map(|r| std::iter::repeat_n(r as u32, self.rims[r].points.len())))?;
        // Searches skip the vertices of one piece, so that whole subtrees are passed over.
        let pieces = alloc::collect(owners.iter().map(|&r| self.candidates[r as usize].piece))?;
        let tree = KdTree::with_groups(&points, &pieces, &job.sub_job(0.0, 0.2), STAGE)?;
        let job = job.sub_job(0.2, 1.0);
        let visits = LoopVisitCounter::default();
        let mut seen = alloc::filled(NONE, self.rims.len())?;
        for r in free() {
            let LoopMeasures { piece, component, .. } = self.candidates[r];
            job.step(r as f64 / self.rims.len() as f64, STAGE)?;
            let widest = MAX_SEEN_DISTANCE_RATIO * self.widest_gap_of_loop(r);
            let rim = &self.rims[r].points;
            let mut of_loop = alloc::with_capacity(MAX_SEEING_SAMPLES)?;
            for &p in rim.iter().step_by(rim.len().div_ceil(MAX_SEEING_SAMPLES)) {
                if visits.take_report_due() {
                    job.step(r as f64 / self.rims.len() as f64, STAGE)?;
                }
                let accept = |v: u32| {
                    visits.count_visit();
                    let k = owners[v as usize] as usize;
                    self.candidates[k].piece != piece
                        && self.candidates[k].component != component
                        && self.may_join_loops(r, k)
                };
                let nearest = tree.nearest_in_other_groups(p, widest * widest, piece, accept);
                of_loop.push(nearest.map_or(NONE, |(_, v)| owners[v as usize]));
            }
            of_loop.sort_unstable();
            let least = MIN_SEEING_VERTEX_SHARE * of_loop.len() as f64;
            let most = of_loop.chunk_by(|x, y| x == y).find(|group| group.len() as f64 >= least);
            seen[r] = most.map_or(NONE, |group| group[0]);
        }
        Ok(seen)
    }

    /// Returns the gap of two loops if they look at each other and are near enough.
    fn gap_of_lone_pair(&self, r: usize, k: usize, job: &Job<'_>) -> Result<Option<f64>> {
        let [there, back] = self.measure_facing_of_pair([r, k], job)?;
        let gap = there.mean_gap.max(back.mean_gap);
        let is_near = gap <= MAX_LONE_GAP_RATIO * self.max_gap_between_whole_loops(r, k);
        Ok((is_near && there.are_mutual(&back)).then_some(gap))
    }
}
