//! Seams that follow from classes alone.

use super::{Forest, Run, Seam};
use crate::alloc;
use crate::error::Result;
use crate::net::Shape;

/// Rows and columns from one node to the next.
type Step = (i64, i64);

/// Seams that glue the pieces of which classes consist: `table` has the representatives of the classes, `pieces` those of
/// what contracted links alone make of them.
///
/// One pair for each piece is enough: the first nodes of class and piece. Pairs that follow each other are runs, the
/// longest that there are; these go on at both ends through what the others have glued besides, and what then says nothing
/// new is left out.
pub(super) fn seams(shape: Shape, table: &[u32], pieces: &[u32]) -> Result<Vec<Seam>> {
    let mut pairs = Vec::new();
    for ((node, &class), &piece) in (0..).zip(table).zip(pieces) {
        if piece == node && class != node {
            alloc::push(&mut pairs, [class, node])?;
        }
    }
    pairs.sort_unstable();
    let mut runs = Runs { shape, table, pieces, seen: alloc::filled(0, pairs.len())?, pairs, trial: 0 };
    let mut found = alloc::with_capacity(runs.pairs.len())?;
    for k in 0..runs.pairs.len() {
        if runs.seen[k] != USED {
            found.push(runs.take(k));
        }
    }
    found.sort_unstable_by_key(|seam| (u32::MAX - seam.count, *seam));
    let mut forest = Forest::of(alloc::copied(pieces)?);
    let mut seams = alloc::with_capacity(found.len())?;
    for seam in found {
        let mut news = false;
        for [a, b] in seam.pairs(shape) {
            news |= forest.find(a) != forest.find(b);
            forest.join([a, b]);
        }
        if news {
            seams.push(seam);
        }
    }
    seams.sort_unstable();
    Ok(seams)
}

/// Said of a pair that is in a run.
const USED: u64 = u64::MAX;

struct Runs<'a> {
    shape: Shape,
    table: &'a [u32],
    pieces: &'a [u32],
    /// In order.
    pairs: Vec<[u32; 2]>,
    /// The last trial that had the pair, or [`USED`].
    seen: Vec<u64>,
    trial: u64,
}

impl Runs<'_> {
    /// The longest run of pairs with pair `k` in it, of those in the first of directions; extended.
    fn take(&mut self, k: usize) -> Seam {
        let mut best = ([(0, 0); 2], [0, 0]);
        for steps in directions() {
            let reach = self.reach(k, steps);
            if reach[0] + reach[1] > best.1[0] + best.1[1] {
                best = (steps, reach);
            }
        }
        let (steps, [mut before, mut after]) = best;
        let pair = self.pairs[k];
        for at in -before..=after {
            if let Some(index) = self.moved(pair, steps, at).and_then(|pair| self.index(pair)) {
                self.seen[index] = USED;
            }
        }
        if steps != [(0, 0); 2] {
            after += self.beyond(pair, steps, after, 1);
            before += self.beyond(pair, steps, -before, -1);
        }
        let [a, b] = self.moved(pair, steps, -before).unwrap_or(pair);
        let run = |node: u32, (row_step, column_step): Step| {
            let (i, j) = self.shape.place(node);
            Run { row: i as u32, column: j as u32, row_step: row_step as i32, column_step: column_step as i32 }
        };
        Seam { a: run(a, steps[0]), b: run(b, steps[1]), count: (before + after + 1) as u32 }.canonical()
    }

    /// How many pairs that are in no run yet lie before pair `k`, and behind it. A fold meets itself in the middle.
    fn reach(&mut self, k: usize, steps: [Step; 2]) -> [i64; 2] {
        self.trial += 1;
        self.seen[k] = self.trial;
        [-1, 1].map(|sense| {
            let mut count = 0;
            while let Some(index) =
                self.moved(self.pairs[k], steps, sense * (count + 1)).and_then(|pair| self.index(pair))
                && self.seen[index] != USED
                && self.seen[index] != self.trial
            {
                self.seen[index] = self.trial;
                count += 1;
            }
            count
        })
    }

    /// How many pairs behind the last one, at `end`, are one point in any way, but not by links alone.
    fn beyond(&self, pair: [u32; 2], steps: [Step; 2], end: i64, sense: i64) -> i64 {
        let is_glued = |&[a, b]: &[u32; 2]| {
            let ([p, q], [r, s]) = ([a, b].map(|n| self.table[n as usize]), [a, b].map(|n| self.pieces[n as usize]));
            p == q && r != s
        };
        let at = |count: i64| self.moved(pair, steps, end + sense * count);
        // Beyond the middle of a fold are the same pairs, turned round.
        let turned = |count: i64| at(count - 1).map(|[a, b]| [b, a]);
        (1..).take_while(|&count| at(count).filter(is_glued).is_some_and(|pair| Some(pair) != turned(count))).count()
            as i64
    }

    /// The pair so many steps from a pair.
    fn moved(&self, pair: [u32; 2], steps: [Step; 2], count: i64) -> Option<[u32; 2]> {
        let node = |k: usize| {
            let (i, j) = self.shape.place(pair[k]);
            let (i, j) = (i as i64 + count * steps[k].0, j as i64 + count * steps[k].1);
            let inside = (0..self.shape.rows() as i64).contains(&i) && (0..self.shape.columns() as i64).contains(&j);
            inside.then(|| self.shape.node(i as usize, j as usize))
        };
        Some([node(0)?, node(1)?])
    }

    fn index(&self, [a, b]: [u32; 2]) -> Option<usize> {
        self.pairs.binary_search(&[a.min(b), a.max(b)]).ok()
    }
}

/// To neighbours, also diagonally; one run of the two may stand still.
fn directions() -> impl Iterator<Item = [Step; 2]> {
    let steps = || (0..9).map(|k| (k / 3 - 1, k % 3 - 1));
    steps().flat_map(move |a| steps().map(move |b| [a, b])).filter(|&steps| steps != [(0, 0); 2])
}
