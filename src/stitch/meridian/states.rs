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
use super::bend::{Bends, Triangles};
use super::metric::{Line, Metric, StepCosts};
use super::rims::{Pair, RimPair};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;

const STATES: usize = 8;
/// The path has had a step on A within B.
const WITHIN_B: usize = 1;
/// The path has had a step on B within A.
const WITHIN_A: usize = 2;
/// The last step was on B. Kept for bends only.
const LAST_B: usize = 4;

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

type Costs = [f64; STATES];
const UNREACHABLE: Costs = [f64::INFINITY; STATES];

/// The bits that a step into (i, j) sets; `LAST_B` is forgotten with each step.
fn advance(rims: &RimPair<'_>, by: Step, i: usize, j: usize, bends: bool) -> usize {
    let (n, m) = (rims.a.len() - 1, rims.b.len() - 1);
    let (i_before, j_before) = (i - usize::from(by != Step::B), j - usize::from(by != Step::A));
    let within_b = by != Step::B && j_before < m && j > 0;
    let within_a = by != Step::A && i_before < n && i > 0;
    let last = if bends && by == Step::B { LAST_B } else { 0 };
    (usize::from(within_b) * WITHIN_B) | (usize::from(within_a) * WITHIN_A) | last
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
        state |= advance(rims, by, i2 as usize, j2 as usize, false);
    }
    !rims.closed || state == WITHIN_A | WITHIN_B
}

/// The cheapest path within `band`, and its cost; `None` if there is none. `proper`: only such as
/// use no meridian of closed rims twice. `first`: the end of the first step, where that is given.
///
/// Time: the number of nodes in the band, for each of the states that there are (four for proper
/// paths, twice as many for bends), twice for bends between closed rims whose first step is open. Extra memory: 8 bytes a
/// node.
pub(super) fn cheapest(
    rims: &RimPair<'_>,
    cost: &Cost<'_>,
    band: &Band,
    simple: bool,
    first: Option<Pair>,
    job: &Job<'_>,
) -> Result<Option<(f64, Vec<Pair>)>> {
    let simple = simple && rims.closed;
    let bends = matches!(cost, Cost::Bends(_));
    let exists = |state: &usize| (simple || state & 3 == 0) && (bends || state & LAST_B == 0);
    let states: Vec<usize> = (0..STATES).filter(exists).collect();
    let (n, m) = (band.last_row(), band.last_column());
    let mut search = Search {
        rims,
        cost,
        states: &states,
        kept: if simple { STATES - 1 } else { LAST_B },
        band,
        line: Line::new(rims.b)?,
        steps: StepCosts::new(m + 1)?,
        row: alloc::filled(UNREACHABLE, m + 1)?,
        triangles: alloc::filled(Triangles::default(), if bends { m + 1 } else { 0 })?,
        arrivals: alloc::filled([0u8; STATES], band.nodes(0..n + 1))?,
    };
    let firsts: &[Option<Step>] = match (cost, first) {
        (Cost::Bends(_), None) if rims.closed => &[Some(Step::A), Some(Step::B)],
        (Cost::Bends(_), Some([1, 0])) if rims.closed => &[Some(Step::A)],
        (Cost::Bends(_), Some(_)) if rims.closed => &[Some(Step::B)],
        _ => &[None],
    };
    let mut best: Option<(f64, Vec<Pair>)> = None;
    for (k, &first) in firsts.iter().enumerate() {
        let part = job.share(k, firsts.len());
        search.run(first, &part)?;
        for &state in states.iter().filter(|&state| !simple || state & 3 == WITHIN_A | WITHIN_B) {
            let mut total = search.row[m][state];
            if let (Cost::Bends(bends), Some(first)) = (cost, first) {
                let last = bends.triangles(n, m).normals[usize::from(state & LAST_B > 0)];
                let next =
                    if first == Step::A { bends.triangles(1, 0).normals[0] } else { bends.triangles(0, 1).normals[1] };
                total += bends.across(n, m, last, next);
            }
            if total < best.as_ref().map_or(f64::INFINITY, |&(least, _)| least) {
                best = Some((total, search.backtrack(state)?));
            }
        }
    }
    Ok(best)
}

struct Search<'a> {
    rims: &'a RimPair<'a>,
    cost: &'a Cost<'a>,
    /// The states that there are, and their bits.
    states: &'a [usize],
    kept: usize,
    band: &'a Band,
    line: Line,
    steps: StepCosts,
    /// The cheapest ways to the nodes of one row.
    row: Vec<Costs>,
    /// For bends, the triangles that end at the nodes of that row.
    triangles: Vec<Triangles>,
    /// For each node and state: the state before, and the step (8 times 0 for A, 1 for B, 2 for
    /// both).
    arrivals: Vec<[u8; STATES]>,
}

impl Search<'_> {
    /// Fills the table. `first`: the first step must be of this kind.
    fn run(&mut self, first: Option<Step>, job: &Job<'_>) -> Result<()> {
        self.row.fill(UNREACHABLE);
        let mut start = 0;
        let mut reported = 0;
        for i in 0..=self.band.last_row() {
            self.next_row(i, start, first);
            start += self.band.width(i);
            if start / REPORT_INTERVAL > reported {
                reported = start / REPORT_INTERVAL;
                job.step(i as f64 / self.band.last_row() as f64, "finding the best meridians")?;
            }
        }
        Ok(())
    }

    fn next_row(&mut self, i: usize, start: usize, first: Option<Step>) {
        let columns = self.band.columns(i);
        let low = *columns.start();
        if let Cost::StepCosts(metric) = self.cost {
            metric.measure(self.rims.a, &self.line, i, columns.clone(), &mut self.steps);
        }
        let both = matches!(self.cost, Cost::StepCosts(metric) if metric.steps_on_both());
        let shifted = i > 0 && low > *self.band.columns(i - 1).start();
        let (mut left, mut before) = (UNREACHABLE, if shifted { self.row[low - 1] } else { UNREACHABLE });
        let mut left_triangles = Triangles::default();
        for j in columns {
            // Row i - 1 still stands at j, where it is within its band.
            let up = if i > 0 { self.row[j] } else { UNREACHABLE };
            let triangles = if let Cost::Bends(bends) = self.cost { bends.triangles(i, j) } else { left_triangles };
            let (mut here, mut how) = (UNREACHABLE, [0u8; STATES]);
            if (i, j) == (0, 0) {
                here[0] = 0.0;
            }
            let extra = self.rims.extra([i as u32, j as u32]);
            let from = [(Step::A, &up, i > 0), (Step::B, &left, j > 0), (Step::Both, &before, both && i > 0 && j > 0)];
            for (kind, (by, costs, exists)) in from.into_iter().enumerate() {
                let is_first = (i, j) == (usize::from(by != Step::B), usize::from(by != Step::A));
                if !exists || (is_first && first.is_some_and(|first| first != by)) {
                    continue;
                }
                // Step the kind of the step before.
                let steps = match self.cost {
                    Cost::StepCosts(_) => [if by == Step::B { self.steps.b[j] } else { self.steps.a[j] }; 2],
                    Cost::Bends(bends) => {
                        let on_a = by == Step::A;
                        let normal = triangles.normals[usize::from(!on_a)];
                        let before = if on_a { &self.triangles[j] } else { &left_triangles };
                        let along = bends.along(i, j, on_a, &triangles, before);
                        let (i, j) = if on_a { (i - 1, j) } else { (i, j - 1) };
                        // Nothing comes before the first step: the seam is added at the end.
                        before.normals.map(|p| along + if is_first { 0.0 } else { bends.across(i, j, p, normal) })
                    }
                };
                let reached = advance(self.rims, by, i, j, matches!(self.cost, Cost::Bends(_)));
                let extra = extra[usize::from(by == Step::B)];
                for &state in self.states {
                    let total = costs[state] + steps[usize::from(state & LAST_B > 0)] + extra;
                    let to = (state & !LAST_B | reached) & self.kept;
                    if total < here[to] {
                        here[to] = total;
                        how[to] = (state + STATES * kind) as u8;
                    }
                }
            }
            if self.rims.is_forbidden([i as u32, j as u32]) {
                here = UNREACHABLE;
            }
            self.arrivals[start + j - low] = how;
            before = self.row[j];
            self.row[j] = here;
            left = here;
            if let Some(at) = self.triangles.get_mut(j) {
                *at = triangles;
            }
            left_triangles = triangles;
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
            state = how % STATES;
            j -= usize::from(how / STATES > 0);
            if how / STATES != 1 {
                i -= 1;
                start -= self.band.width(i);
            }
            path.push([i as u32, j as u32]);
        }
        path.reverse();
        Ok(path)
    }
}
