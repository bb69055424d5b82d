//! The canonical seams of a partition. They glue the connected components that contracted links
//! leave of each class.
//!
//! One pair for each component suffices: the first nodes of the class and of the component. A
//! greedy search takes the longest run of equal steps through each pair, in the first of the
//! directions that reach it. Runs are then extended through pairs that are already identified, and
//! runs that merge nothing are dropped. Invariant: the result depends only on the partition, not on
//! the seams from which it came. O(pairs log pairs) for each of 80 directions.

use super::{Seam, SeamRun};
use crate::Shape;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::sort;

/// Rows and columns from one node to the next.
type GridStep = (i64, i64);

/// Returns the seams that glue the components of each class. `representatives` has the representatives of the
/// classes, `representatives_by_links` the representatives of the components under contracted links alone.
pub(super) fn find_seams(shape: Shape, representatives: &[u32], representatives_by_links: &[u32]) -> Result<Vec<Seam>> {
    let nodes = (0..)
        .zip(representatives)
        .zip(representatives_by_links)
        .filter(|&((node, &class), &piece)| piece == node && class != node);
    let mut pairs = alloc::gather(nodes.map(|((node, &class), _)| [class, node]))?;
    pairs.sort_unstable();
    let mut runs = SeamRunSearch {
        shape,
        representatives,
        representatives_by_links,
        last_trial_of_pair: alloc::filled(0, pairs.len())?,
        pairs,
        trial: 0,
    };
    let mut found = alloc::with_capacity(runs.pairs.len())?;
    for k in 0..runs.pairs.len() {
        if runs.last_trial_of_pair[k] != PAIR_IS_IN_RUN {
            found.push(runs.longest_run_through(k));
        }
    }
    sort::sort_stable(&mut found, &|a, b| b.count.cmp(&a.count).then(a.cmp(b)));
    let mut sets = DisjointSets::from_parents(alloc::copied(representatives_by_links)?);
    let mut seams = alloc::with_capacity(found.len())?;
    for seam in found {
        if seam.pairs(shape).fold(false, |merges, [a, b]| sets.union(a, b) | merges) {
            seams.push(seam);
        }
    }
    seams.sort_unstable();
    Ok(seams)
}

/// Marks a pair that is in a run.
const PAIR_IS_IN_RUN: u64 = u64::MAX;

struct SeamRunSearch<'a> {
    shape: Shape,
    representatives: &'a [u32],
    representatives_by_links: &'a [u32],
    /// In order.
    pairs: Vec<[u32; 2]>,
    /// The last trial that had the pair, or [`PAIR_IS_IN_RUN`].
    last_trial_of_pair: Vec<u64>,
    trial: u64,
}

impl SeamRunSearch<'_> {
    /// Returns the longest run through pair `k`, in the first of the directions that reach it,
    /// extended.
    fn longest_run_through(&mut self, k: usize) -> Seam {
        let mut best = ([(0, 0); 2], [0, 0]);
        for steps in all_step_pairs() {
            let counts = self.count_unused_pairs(k, steps);
            if counts[0] + counts[1] > best.1[0] + best.1[1] {
                best = (steps, counts);
            }
        }
        let (steps, [mut before, mut after]) = best;
        let pair = self.pairs[k];
        for at in -before..=after {
            if let Some(index) = self.pair_after(pair, steps, at).and_then(|pair| self.pair_index(pair)) {
                self.last_trial_of_pair[index] = PAIR_IS_IN_RUN;
            }
        }
        if steps != [(0, 0); 2] {
            after += self.count_glued_pairs_after(pair, steps, after, 1);
            before += self.count_glued_pairs_after(pair, steps, -before, -1);
        }
        let [a, b] = self.pair_after(pair, steps, -before).unwrap_or(pair);
        let run = |node: u32, (row_step, column_step): GridStep| {
            let (i, j) = self.shape.row_and_column(node);
            SeamRun { row: i as u32, column: j as u32, row_step: row_step as i32, column_step: column_step as i32 }
        };
        Seam { a: run(a, steps[0]), b: run(b, steps[1]), count: (before + after + 1) as u32 }.canonical_spelling()
    }

    /// Returns the number of consecutive unused pairs before pair `k` and after it. A fold meets
    /// itself in the middle.
    fn count_unused_pairs(&mut self, k: usize, steps: [GridStep; 2]) -> [i64; 2] {
        self.trial += 1;
        self.last_trial_of_pair[k] = self.trial;
        [-1, 1].map(|sense| {
            let mut count = 0;
            while let Some(index) =
                self.pair_after(self.pairs[k], steps, sense * (count + 1)).and_then(|pair| self.pair_index(pair))
                && self.last_trial_of_pair[index] != PAIR_IS_IN_RUN
                && self.last_trial_of_pair[index] != self.trial
            {
                self.last_trial_of_pair[index] = self.trial;
                count += 1;
            }
            count
        })
    }

    /// Counts the consecutive pairs of nodes beyond `end` that are glued, but would not be glued by
    /// contracted links alone.
    fn count_glued_pairs_after(&self, pair: [u32; 2], steps: [GridStep; 2], end: i64, sense: i64) -> i64 {
        let is_glued = |&[a, b]: &[u32; 2]| {
            let ([p, q], [r, s]) = (
                [a, b].map(|n| self.representatives[n as usize]),
                [a, b].map(|n| self.representatives_by_links[n as usize]),
            );
            p == q && r != s
        };
        let at = |count: i64| self.pair_after(pair, steps, end + sense * count);
        // Beyond the middle of a fold the same pairs follow, exchanged.
        let turned = |count: i64| at(count - 1).map(|[a, b]| [b, a]);
        (1..).take_while(|&count| at(count).filter(is_glued).is_some_and(|pair| Some(pair) != turned(count))).count()
            as i64
    }

    /// Returns the pair `count` steps from a pair.
    fn pair_after(&self, pair: [u32; 2], steps: [GridStep; 2], count: i64) -> Option<[u32; 2]> {
        let node = |k: usize| {
            let (i, j) = self.shape.row_and_column(pair[k]);
            let (i, j) = (i as i64 + count * steps[k].0, j as i64 + count * steps[k].1);
            let inside = (0..self.shape.rows() as i64).contains(&i) && (0..self.shape.columns() as i64).contains(&j);
            inside.then(|| self.shape.node(i as usize, j as usize))
        };
        Some([node(0)?, node(1)?])
    }

    fn pair_index(&self, [a, b]: [u32; 2]) -> Option<usize> {
        self.pairs.binary_search(&[a.min(b), a.max(b)]).ok()
    }
}

/// Pairs of steps to neighbours, including diagonal ones; one of the two runs may stay at its node.
fn all_step_pairs() -> impl Iterator<Item = [GridStep; 2]> {
    let steps = || (0..9).map(|k| (k / 3 - 1, k % 3 - 1));
    steps().flat_map(move |a| steps().map(move |b| [a, b])).filter(|&steps| steps != [(0, 0); 2])
}
