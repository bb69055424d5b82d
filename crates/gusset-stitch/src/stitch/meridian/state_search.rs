//! Cheapest path if the cost of a step depends on earlier steps: bends between triangles, and no
//! repeated meridians.
//!
//! **Simple paths.** On closed rims (i, 0) and (i, M) are the same edge, since B_M is B_0. A path
//! through both takes all its steps on B at one i: no step on A starts before j = M and ends after
//! j = 0. The same holds for (0, j) and (N, j). So a strip repeats no meridian if and only if its
//! path has two kinds of steps. One is a step on A with j < M before it and j > 0 after it. The
//! other is a step on B with i < N before it and i > 0 after it. Two bits record which of these
//! steps a path has had.
//!
//! **Bends.** A bend lies between two triangles, so a third bit records the rim of the last step.
//! The first triangle of a closed strip meets the last one: the search runs once for each kind of
//! first step.
//!
//! The search stores the cheapest path to each node in each state, and is exact. O(8 N M) time and
//! memory in the band.

use super::lattice_band::LatticeBand;
use super::rim_pair::{MeridianEnds, RimPair, STAGE};
use super::step_metric::{PointArrays, StepCosts, StepMetric};
use super::strip_bends::{StepRow, StripBends};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use std::ops::Range;

/// Bit of a state: the last step advanced along rim B. Set only if bends are minimised.
const LAST_STEP_ON_B: usize = 1;
/// The path has had a step on A inside B.
const HAS_STEP_INSIDE_B: usize = 2;
/// The path has had a step on B inside A.
const HAS_STEP_INSIDE_A: usize = 4;

/// Number of states for simple paths.
const SIMPLE_PATH_STATES: usize = 8;
/// Number of states for all paths, which record only the rim of the last step.
const LAST_STEP_STATES: usize = 2;

/// Nodes between two progress reports.
const NODES_PER_REPORT: usize = 1 << 16;

#[derive(Clone, Copy, PartialEq)]
enum LatticeStep {
    A,
    B,
    Both,
}

/// The cost of a path.
pub(super) enum PathCost<'a> {
    /// The sum over its steps.
    StepCosts(StepMetric),
    /// The sum of bends.
    Bends(&'a StripBends<'a>),
}

/// Returns the bits that a step into (i, j) sets. `LAST_STEP_ON_B` is reset with each step.
fn state_bits_of_step(rims: &RimPair<'_>, by: LatticeStep, i: usize, j: usize) -> usize {
    let (n, m) = (rims.a.len() - 1, rims.b.len() - 1);
    let (i_before, j_before) = (i - usize::from(by != LatticeStep::B), j - usize::from(by != LatticeStep::A));
    let within_b = by != LatticeStep::B && j_before < m && j > 0;
    let within_a = by != LatticeStep::A && i_before < n && i > 0;
    (usize::from(within_b) * HAS_STEP_INSIDE_B) | (usize::from(within_a) * HAS_STEP_INSIDE_A)
}

/// Returns true if the path does not repeat a meridian. Paths between open rims never do.
pub(super) fn is_simple_path(rims: &RimPair<'_>, path: &[MeridianEnds]) -> bool {
    let mut state = 0;
    for step in path.windows(2) {
        let ([i, j], [i2, j2]) = (step[0], step[1]);
        let by = match (i == i2, j == j2) {
            (true, _) => LatticeStep::B,
            (_, true) => LatticeStep::A,
            _ => LatticeStep::Both,
        };
        state |= state_bits_of_step(rims, by, i2 as usize, j2 as usize);
    }
    !rims.closed || state == HAS_STEP_INSIDE_A | HAS_STEP_INSIDE_B
}

/// Returns the cheapest path within `band` and its cost; `None` if there is none. With `simple`,
/// the path does not repeat a meridian of closed rims. `first` is the end of the first step, if
/// given.
///
/// Time: the number of nodes in the band, for each state (eight for simple paths, otherwise two).
/// Twice that for bends between closed rims without a given first step. Extra memory: one byte per
/// node and state.
pub(super) fn cheapest_path(
    rims: &RimPair<'_>,
    cost: &PathCost<'_>,
    band: &LatticeBand,
    simple: bool,
    first: Option<MeridianEnds>,
    job: &Job<'_>,
) -> Result<Option<(f64, Vec<MeridianEnds>)>> {
    match simple && rims.closed {
        true => StateSearch::<SIMPLE_PATH_STATES>::new(rims, cost, band)?.cheapest_path(first, job),
        false => StateSearch::<LAST_STEP_STATES>::new(rims, cost, band)?.cheapest_path(first, job),
    }
}

struct StateSearch<'a, const STATES: usize> {
    rims: &'a RimPair<'a>,
    cost: &'a PathCost<'a>,
    band: &'a LatticeBand,
    points_of_b: PointArrays,
    /// The costs of the steps into the nodes of the current row. With [`PathCost::Bends`], entry 0
    /// holds after a step on A and entry 1 after a step on B. Otherwise entry 0 holds for both.
    step_costs: [StepCosts; 2],
    /// Row i of the triangles is `triangles[i % 2]`.
    triangles: [StepRow; 2],
    /// The least costs of the nodes of one row.
    least_costs_of_row: Vec<[f64; STATES]>,
    /// For each node and state, the previous state plus 8 times the step (0 for A, 1 for B, 2 for
    /// both).
    arrivals: Vec<[u8; STATES]>,
}

impl<'a, const STATES: usize> StateSearch<'a, STATES> {
    const UNREACHABLE: [f64; STATES] = [f64::INFINITY; STATES];

    fn new(rims: &'a RimPair<'a>, cost: &'a PathCost<'a>, band: &'a LatticeBand) -> Result<Self> {
        let (n, m) = (band.last_row(), band.last_column());
        let bend_columns = if matches!(cost, PathCost::Bends(_)) { m + 1 } else { 0 };
        Ok(StateSearch {
            rims,
            cost,
            band,
            points_of_b: PointArrays::new(rims.b)?,
            step_costs: [StepCosts::zeros_for_nodes(m + 1)?, StepCosts::zeros_for_nodes(m + 1)?],
            triangles: [StepRow::new(bend_columns)?, StepRow::new(bend_columns)?],
            least_costs_of_row: alloc::filled(Self::UNREACHABLE, m + 1)?,
            arrivals: alloc::filled([0u8; STATES], band.node_count(0..n + 1))?,
        })
    }

    /// See [`cheapest_path`].
    fn cheapest_path(
        &mut self,
        first: Option<MeridianEnds>,
        job: &Job<'_>,
    ) -> Result<Option<(f64, Vec<MeridianEnds>)>> {
        let firsts: &[Option<LatticeStep>] = match (self.cost, first) {
            (PathCost::Bends(_), None) if self.rims.closed => &[Some(LatticeStep::A), Some(LatticeStep::B)],
            (PathCost::Bends(_), Some([1, 0])) if self.rims.closed => &[Some(LatticeStep::A)],
            (PathCost::Bends(_), Some(_)) if self.rims.closed => &[Some(LatticeStep::B)],
            _ => &[None],
        };
        let simple = HAS_STEP_INSIDE_A | HAS_STEP_INSIDE_B;
        let mut best: Option<(f64, Vec<MeridianEnds>)> = None;
        for (k, &first) in firsts.iter().enumerate() {
            self.fill_table(first, &job.sub_job_of_item(k, firsts.len()))?;
            for state in (0..STATES).filter(|state| STATES == LAST_STEP_STATES || state & simple == simple) {
                let mut total = self.least_costs_of_row[self.band.last_column()][state];
                if let (PathCost::Bends(bends), Some(first)) = (self.cost, first) {
                    total += bends.bend_across_seam(state & LAST_STEP_ON_B > 0, first == LatticeStep::B);
                }
                if total < best.as_ref().map_or(f64::INFINITY, |&(least, _)| least) {
                    best = Some((total, self.backtrack_path(state)?));
                }
            }
        }
        Ok(best)
    }

    /// Fills the table. If given, `first` is the kind of the first step.
    fn fill_table(&mut self, first: Option<LatticeStep>, job: &Job<'_>) -> Result<()> {
        self.least_costs_of_row.fill(Self::UNREACHABLE);
        let mut start = 0;
        let mut reported = 0;
        for i in 0..=self.band.last_row() {
            let (low, high) = self.band.columns_of_row(i).into_inner();
            self.measure_row_steps(i, low..high + 1, first);
            match self.cost {
                PathCost::Bends(_) => self.compute_next_row::<true>(i, low..high + 1, start),
                PathCost::StepCosts(_) => self.compute_next_row::<false>(i, low..high + 1, start),
            }
            start += self.band.row_width(i);
            if start / NODES_PER_REPORT > reported {
                reported = start / NODES_PER_REPORT;
                job.step(i as f64 / self.band.last_row() as f64, STAGE)?;
            }
        }
        Ok(())
    }

    /// Computes the costs of the steps into row i, with penalties; infinite for forbidden steps.
    fn measure_row_steps(&mut self, i: usize, columns: Range<usize>, first: Option<LatticeStep>) {
        let [even, odd] = &mut self.triangles;
        let rows = if i.is_multiple_of(2) { [odd, even] } else { [even, odd] };
        match self.cost {
            PathCost::StepCosts(metric) => {
                metric.compute_step_costs(self.rims.a, &self.points_of_b, i, columns, &mut self.step_costs[0]);
            }
            PathCost::Bends(bends) => bends.compute_row_costs(i, columns, rows, &mut self.step_costs),
        }
        for steps in &mut self.step_costs {
            for penalty in self.rims.penalties_in_row(i) {
                let costs = if penalty.on_b { &mut steps.costs_on_b } else { &mut steps.costs_on_a };
                costs[penalty.end_node[1] as usize] += penalty.additional_cost;
            }
            for &[_, j] in self.rims.forbidden_in_row(i) {
                (steps.costs_on_a[j as usize], steps.costs_on_b[j as usize]) = (f64::INFINITY, f64::INFINITY);
            }
            match first {
                Some(LatticeStep::B) if i == 1 => steps.costs_on_a[0] = f64::INFINITY,
                Some(LatticeStep::A) if i == 0 && self.band.last_column() > 0 => steps.costs_on_b[1] = f64::INFINITY,
                _ => {}
            }
        }
    }

    /// Replaces the costs of row i - 1 by the costs of row i, whose arrivals begin at `start`.
    fn compute_next_row<const BENDS: bool>(&mut self, i: usize, columns: Range<usize>, start: usize) {
        let both = matches!(self.cost, PathCost::StepCosts(metric) if metric.may_step_on_both());
        let low = columns.start;
        let shifted = i > 0 && low > *self.band.columns_of_row(i - 1).start();
        let mut before = if shifted { self.least_costs_of_row[low - 1] } else { Self::UNREACHABLE };
        let mut left = Self::UNREACHABLE;
        let on_a = [0, 1].map(|k| &self.step_costs[k].costs_on_a[columns.clone()]);
        let on_b = [0, 1].map(|k| &self.step_costs[k].costs_on_b[columns.clone()]);
        let arrivals = &mut self.arrivals[start..start + columns.len()];
        let row = &mut self.least_costs_of_row[columns];
        for k in 0..row.len() {
            let j = low + k;
            let (mut here, mut how) = (Self::UNREACHABLE, [0u8; STATES]);
            let mut step = |by: LatticeStep, costs: &[f64; STATES], steps: [f64; 2]| {
                let within = if STATES == LAST_STEP_STATES { 0 } else { state_bits_of_step(self.rims, by, i, j) };
                let last = if BENDS && by == LatticeStep::B { LAST_STEP_ON_B } else { 0 };
                for state in (0..STATES).step_by(if BENDS { 1 } else { 2 }) {
                    let total = costs[state] + steps[state & LAST_STEP_ON_B];
                    let to = (state & !LAST_STEP_ON_B) | last | within;
                    if total < here[to] {
                        (here[to], how[to]) = (total, (state + SIMPLE_PATH_STATES * by as usize) as u8);
                    }
                }
            };
            // Entry j still belongs to row i - 1, if it is within that row's band.
            if i > 0 {
                step(LatticeStep::A, &row[k], [on_a[0][k], on_a[1][k]]);
            }
            if j > 0 {
                step(LatticeStep::B, &left, [on_b[0][k], on_b[1][k]]);
            }
            if both && i > 0 && j > 0 {
                step(LatticeStep::Both, &before, [on_a[0][k]; 2]);
            }
            if (i, j) == (0, 0) && !self.rims.is_forbidden([0, 0]) {
                here[0] = 0.0;
            }
            arrivals[k] = how;
            before = row[k];
            row[k] = here;
            left = here;
        }
    }

    /// Returns the path to (N, M) in `state`.
    fn backtrack_path(&self, mut state: usize) -> Result<Vec<MeridianEnds>> {
        let (mut i, mut j) = (self.band.last_row(), self.band.last_column());
        let mut start = self.band.node_count(0..i);
        let mut path = alloc::with_capacity(i + j + 1)?;
        path.push([i as u32, j as u32]);
        while (i, j) != (0, 0) {
            let how = usize::from(self.arrivals[start + j - self.band.columns_of_row(i).start()][state]);
            state = how % SIMPLE_PATH_STATES;
            j -= usize::from(how / SIMPLE_PATH_STATES > 0);
            if how / SIMPLE_PATH_STATES != 1 {
                i -= 1;
                start -= self.band.row_width(i);
            }
            path.push([i as u32, j as u32]);
        }
        path.reverse();
        Ok(path)
    }
}
