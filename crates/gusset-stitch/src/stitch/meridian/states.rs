//! The cheapest path where the cost of a step depends on earlier ones: bends between triangles,
//! and no meridian twice.
//!
//! **Simple paths.** On closed rims (i, 0) and (i, M) are the same edge, since B_M is B_0. A
//! path through both takes all its B steps at one i: no step on A starts before j = M and ends
//! after j = 0. Likewise for (0, j) and (N, j). So a strip uses no meridian twice if and only
//! if its path has both a step on A with j < M before it and j > 0 after it, and a step on B
//! with i < N before and i > 0 after. Two bits record which of the two a path has had.
//!
//! **Bends.** The cost of a bend lies between two triangles, so a third bit records the rim of
//! the last step. The first triangle of a closed strip meets the last one: the search runs once
//! for either kind of first step.
//!
//! The search keeps the cheapest way to each node in each state, and is exact. O(8 N M) time
//! and memory in the band.

use super::band::Band;
use super::bend::{Bends, Row};
use super::metric::{Line, Metric, StepCosts};
use super::rim_pair::{Pair, RimPair, STAGE};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use std::ops::Range;

/// The last step was on B. Kept for bends only.
const LAST_B: usize = 1;
/// The path has had a step on A within B.
const WITHIN_B: usize = 2;
/// The path has had a step on B within A.
const WITHIN_A: usize = 4;

/// All states, for simple paths.
const ALL: usize = 8;
/// Those that tell the rim of the last step only, for any path.
const LAST: usize = 2;

/// Nodes between two progress reports.
const REPORT_INTERVAL: usize = 1 << 16;

#[derive(Clone, Copy, PartialEq)]
enum Step {
    A,
    B,
    Both,
}

/// What a path costs.
pub(super) enum Cost<'a> {
    /// A sum over its steps.
    StepCosts(Metric),
    /// The bends.
    Bends(&'a Bends<'a>),
}

/// The bits that a step into (i, j) sets; `LAST_B` is forgotten with each step.
fn advance(rims: &RimPair<'_>, by: Step, i: usize, j: usize) -> usize {
    let (n, m) = (rims.a.len() - 1, rims.b.len() - 1);
    let (i_before, j_before) = (i - usize::from(by != Step::B), j - usize::from(by != Step::A));
    let within_b = by != Step::B && j_before < m && j > 0;
    let within_a = by != Step::A && i_before < n && i > 0;
    (usize::from(within_b) * WITHIN_B) | (usize::from(within_a) * WITHIN_A)
}

/// True if no meridian of the path is used twice. A path between open rims has none.
pub(super) fn is_simple(rims: &RimPair<'_>, path: &[Pair]) -> bool {
    let mut state = 0;
    for step in path.windows(2) {
        let ([i, j], [i2, j2]) = (step[0], step[1]);
        let by = match (i == i2, j == j2) {
            (true, _) => Step::B,
            (_, true) => Step::A,
            _ => Step::Both,
        };
        state |= advance(rims, by, i2 as usize, j2 as usize);
    }
    !rims.closed || state == WITHIN_A | WITHIN_B
}

/// The cheapest path within `band`, and its cost; `None` if there is none. `simple`: only such as
/// use no meridian of closed rims twice. `first`: the end of the first step, where that is given.
///
/// Time: the number of nodes in the band, for each of the states that there are (two, for simple
/// paths eight), twice for bends between closed rims whose first step is open. Extra memory: a byte
/// for each node and state.
pub(super) fn cheapest(
    rims: &RimPair<'_>,
    cost: &Cost<'_>,
    band: &Band,
    simple: bool,
    first: Option<Pair>,
    job: &Job<'_>,
) -> Result<Option<(f64, Vec<Pair>)>> {
    match simple && rims.closed {
        true => Search::<ALL>::new(rims, cost, band)?.cheapest(first, job),
        false => Search::<LAST>::new(rims, cost, band)?.cheapest(first, job),
    }
}

struct Search<'a, const STATES: usize> {
    rims: &'a RimPair<'a>,
    cost: &'a Cost<'a>,
    band: &'a Band,
    line: Line,
    /// What the steps into the nodes of the row cost that is searched: by bends, of those that
    /// follow a step on A and on B; else the first counts for all.
    steps: [StepCosts; 2],
    /// Row i of the triangles is `triangles[i % 2]`.
    triangles: [Row; 2],
    /// The cheapest ways to the nodes of one row.
    row: Vec<[f64; STATES]>,
    /// For each node and state: the state before, and the step (8 times 0 for A, 1 for B, 2 for
    /// both).
    arrivals: Vec<[u8; STATES]>,
}

impl<'a, const STATES: usize> Search<'a, STATES> {
    const UNREACHABLE: [f64; STATES] = [f64::INFINITY; STATES];

    fn new(rims: &'a RimPair<'a>, cost: &'a Cost<'a>, band: &'a Band) -> Result<Self> {
        let (n, m) = (band.last_row(), band.last_column());
        let of_bends = if matches!(cost, Cost::Bends(_)) { m + 1 } else { 0 };
        Ok(Search {
            rims,
            cost,
            band,
            line: Line::new(rims.b)?,
            steps: [StepCosts::new(m + 1)?, StepCosts::new(m + 1)?],
            triangles: [Row::new(of_bends)?, Row::new(of_bends)?],
            row: alloc::filled(Self::UNREACHABLE, m + 1)?,
            arrivals: alloc::filled([0u8; STATES], band.nodes(0..n + 1))?,
        })
    }

    /// See [`cheapest`].
    fn cheapest(&mut self, first: Option<Pair>, job: &Job<'_>) -> Result<Option<(f64, Vec<Pair>)>> {
        let firsts: &[Option<Step>] = match (self.cost, first) {
            (Cost::Bends(_), None) if self.rims.closed => &[Some(Step::A), Some(Step::B)],
            (Cost::Bends(_), Some([1, 0])) if self.rims.closed => &[Some(Step::A)],
            (Cost::Bends(_), Some(_)) if self.rims.closed => &[Some(Step::B)],
            _ => &[None],
        };
        let simple = WITHIN_A | WITHIN_B;
        let mut best: Option<(f64, Vec<Pair>)> = None;
        for (k, &first) in firsts.iter().enumerate() {
            self.run(first, &job.share(k, firsts.len()))?;
            for state in (0..STATES).filter(|state| STATES == LAST || state & simple == simple) {
                let mut total = self.row[self.band.last_column()][state];
                if let (Cost::Bends(bends), Some(first)) = (self.cost, first) {
                    total += bends.across_seam(state & LAST_B > 0, first == Step::B);
                }
                if total < best.as_ref().map_or(f64::INFINITY, |&(least, _)| least) {
                    best = Some((total, self.backtrack(state)?));
                }
            }
        }
        Ok(best)
    }

    /// Fills the table. `first`: the first step must be of this kind.
    fn run(&mut self, first: Option<Step>, job: &Job<'_>) -> Result<()> {
        self.row.fill(Self::UNREACHABLE);
        let mut start = 0;
        let mut reported = 0;
        for i in 0..=self.band.last_row() {
            let (low, high) = self.band.columns(i).into_inner();
            self.measure(i, low..high + 1, first);
            match self.cost {
                Cost::Bends(_) => self.next_row::<true>(i, low..high + 1, start),
                Cost::StepCosts(_) => self.next_row::<false>(i, low..high + 1, start),
            }
            start += self.band.width(i);
            if start / REPORT_INTERVAL > reported {
                reported = start / REPORT_INTERVAL;
                job.step(i as f64 / self.band.last_row() as f64, STAGE)?;
            }
        }
        Ok(())
    }

    /// The costs of the steps into row i, with penalties, infinite where they are forbidden.
    fn measure(&mut self, i: usize, columns: Range<usize>, first: Option<Step>) {
        let [even, odd] = &mut self.triangles;
        let rows = if i.is_multiple_of(2) { [odd, even] } else { [even, odd] };
        match self.cost {
            Cost::StepCosts(metric) => metric.measure(self.rims.a, &self.line, i, columns, &mut self.steps[0]),
            Cost::Bends(bends) => bends.measure(i, columns, rows, &mut self.steps),
        }
        for steps in &mut self.steps {
            for penalty in self.rims.penalties_in_row(i) {
                let costs = if penalty.on_b { &mut steps.b } else { &mut steps.a };
                costs[penalty.to[1] as usize] += penalty.extra;
            }
            for &[_, j] in self.rims.forbidden_in_row(i) {
                (steps.a[j as usize], steps.b[j as usize]) = (f64::INFINITY, f64::INFINITY);
            }
            match first {
                Some(Step::B) if i == 1 => steps.a[0] = f64::INFINITY,
                Some(Step::A) if i == 0 && self.band.last_column() > 0 => steps.b[1] = f64::INFINITY,
                _ => {}
            }
        }
    }

    /// Replaces the costs of row i - 1 by those of row i, whose arrivals begin at `start`.
    fn next_row<const BENDS: bool>(&mut self, i: usize, columns: Range<usize>, start: usize) {
        let both = matches!(self.cost, Cost::StepCosts(metric) if metric.steps_on_both());
        let low = columns.start;
        let shifted = i > 0 && low > *self.band.columns(i - 1).start();
        let mut before = if shifted { self.row[low - 1] } else { Self::UNREACHABLE };
        let mut left = Self::UNREACHABLE;
        let on_a = [0, 1].map(|k| &self.steps[k].a[columns.clone()]);
        let on_b = [0, 1].map(|k| &self.steps[k].b[columns.clone()]);
        let arrivals = &mut self.arrivals[start..start + columns.len()];
        let row = &mut self.row[columns];
        for k in 0..row.len() {
            let j = low + k;
            let (mut here, mut how) = (Self::UNREACHABLE, [0u8; STATES]);
            let mut step = |by: Step, costs: &[f64; STATES], steps: [f64; 2]| {
                let within = if STATES == LAST { 0 } else { advance(self.rims, by, i, j) };
                let last = if BENDS && by == Step::B { LAST_B } else { 0 };
                for state in (0..STATES).step_by(if BENDS { 1 } else { 2 }) {
                    let total = costs[state] + steps[state & LAST_B];
                    let to = (state & !LAST_B) | last | within;
                    if total < here[to] {
                        (here[to], how[to]) = (total, (state + ALL * by as usize) as u8);
                    }
                }
            };
            // Row i - 1 still stands at j, where it is within its band.
            if i > 0 {
                step(Step::A, &row[k], [on_a[0][k], on_a[1][k]]);
            }
            if j > 0 {
                step(Step::B, &left, [on_b[0][k], on_b[1][k]]);
            }
            if both && i > 0 && j > 0 {
                step(Step::Both, &before, [on_a[0][k]; 2]);
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

    /// The path to (N, M) in `state`.
    fn backtrack(&self, mut state: usize) -> Result<Vec<Pair>> {
        let (mut i, mut j) = (self.band.last_row(), self.band.last_column());
        let mut start = self.band.nodes(0..i);
        let mut path = alloc::with_capacity(i + j + 1)?;
        path.push([i as u32, j as u32]);
        while (i, j) != (0, 0) {
            let how = usize::from(self.arrivals[start + j - self.band.columns(i).start()][state]);
            state = how % ALL;
            j -= usize::from(how / ALL > 0);
            if how / ALL != 1 {
                i -= 1;
                start -= self.band.width(i);
            }
            path.push([i as u32, j as u32]);
        }
        path.reverse();
        Ok(path)
    }
}
