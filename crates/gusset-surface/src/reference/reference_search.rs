//! The paper's search, corrected: each node evaluated excludes the block of cells round it that
//! cannot hold the object (theorems T2 to T4 of the module).
//!
//! Invariant: the cells of the mask are all that may hold it. O(n / 64) for the mask and O(1) to
//! O(J^2) for each node evaluated.

use super::cell_lattice::{Lattice, Span};
use super::cell_mask::CellMask;
use super::sizes::{Sizes, Sum};
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

/// The goal of a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Goal {
    /// All that is no farther than this (theorem T2).
    Within(f64),
    /// The least: farther than the nearest node so far is out (theorem T3; by the paper's rule the
    /// answer itself would be, erratum E3).
    Least,
}

/// Options of [`search`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchOptions {
    /// The goal.
    pub goal: Goal,
    /// How sizes of cells are summed.
    pub sum: Sum,
    /// True: every node in the order of rows, as in the paper. False: first a few nodes far apart,
    /// then those between: fewer in all.
    pub by_rows: bool,
    /// Whether lines at the edge are left out when a block covers them from side to side: the rest
    /// is a smaller surface. Blocks that do not reach an edge, or not from side to side, leave none
    /// (erratum E5).
    pub drop_lines: bool,
}

impl SearchOptions {
    /// Few nodes first, J d, lines dropped.
    pub fn new(goal: Goal) -> Self {
        SearchOptions { goal, sum: Sum::Greatest, by_rows: false, drop_lines: true }
    }
}

/// The outcome of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct SearchOutcome {
    /// The cells that may hold what is looked for: none is missing.
    pub mask: CellMask,
    /// How many nodes were looked at.
    pub evaluations: u64,
    /// How many blocks were excluded.
    pub blocks: u64,
    /// How many lines of cells were left out at once.
    pub dropped: u64,
    /// The node of the least distance among those looked at, and that distance.
    pub least: ([usize; 2], f64),
}

/// Looks for cells. `measure`: the distance of a node from the object, which must not rise faster
/// than `sizes` allow: the distance in space with Euclidean diameters, the deviation of the normal
/// from an angle with the variation of normals.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a goal that is no number or negative, [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub fn search(
    sizes: &Sizes,
    mut measure: impl FnMut([usize; 2]) -> f64,
    options: &SearchOptions,
    job: &Job<'_>,
) -> Result<SearchOutcome> {
    search_at_cost(sizes, 0, &mut measure, options, job)
}

/// The same where a node costs more than the rest of its visit: `cost`, in words of the mask.
pub(super) fn search_at_cost(
    sizes: &Sizes,
    cost: usize,
    measure: &mut dyn FnMut([usize; 2]) -> f64,
    options: &SearchOptions,
    job: &Job<'_>,
) -> Result<SearchOutcome> {
    if let Goal::Within(within) = options.goal {
        Error::require(within >= 0.0, "within", within)?;
    }
    let lattice = sizes.lattice();
    let mut window = Window { lattice, spans: lattice.cells.map(Span::all), rings: lattice.closed };
    let least = ([0, 0], f64::INFINITY);
    let mut found = SearchOutcome { mask: CellMask::full(lattice)?, evaluations: 0, blocks: 0, dropped: 0, least };
    let [lines_u, lines_v] = lattice.lines();
    let widest = lines_u.max(lines_v).next_power_of_two();
    let mut stride = if options.by_rows { 1 } else { widest };
    let mut ticker = ProgressTicker { job, spent: 0, fraction: 0.0 };
    while stride > 0 {
        for i in (0..lines_u).step_by(stride) {
            // The negative answer at once: nothing is left.
            if window.is_empty() {
                return Ok(found);
            }
            ticker.spend(lines_v / stride / 8 + 1, i as f64 / (lines_u * stride) as f64)?;
            if !lattice.span(0, i, 1).indices().any(|row| window.spans[0].contains(row)) {
                continue;
            }
            let mut j = 0;
            while j < lines_v {
                if stride == 1 && is_quiet(&found.mask, i, j) {
                    j += 62;
                    continue;
                }
                // Nodes of coarser passes have been looked at.
                let seen = !options.by_rows
                    && stride < widest
                    && (i / stride).is_multiple_of(2)
                    && (j / stride).is_multiple_of(2);
                if !seen && lattice.round([i, j]).any(|cell| found.mask.get(cell)) {
                    let cleared = visit(&mut found, &mut window, sizes, [i, j], measure([i, j]), options);
                    ticker.spend(cleared + cost, 0.0)?;
                }
                j += stride;
            }
        }
        stride /= 2;
    }
    Ok(found)
}

/// Excludes what a node at distance `r` shows to be out. Returns the work done.
fn visit(
    found: &mut SearchOutcome,
    window: &mut Window,
    sizes: &Sizes,
    node: [usize; 2],
    r: f64,
    options: &SearchOptions,
) -> usize {
    found.evaluations += 1;
    if r < found.least.1 || (r == found.least.1 && node < found.least.0) {
        found.least = (node, r);
    }
    let within = match options.goal {
        Goal::Within(within) => within,
        Goal::Least => found.least.1,
    };
    // What is no farther than `within` stays (erratum E2: the paper's rule has the block touch what
    // is looked for).
    let (steps, _) = sizes.steps(node, r - within, options.sum);
    let lattice = sizes.lattice();
    if steps == 0 {
        for cell in lattice.round(node) {
            if sizes.get(cell) < r - within {
                found.mask.set(cell, false);
            }
        }
        return 8;
    }
    let block = lattice.block(node, steps);
    found.mask.clear(block);
    found.blocks += 1;
    if options.drop_lines {
        found.dropped += window.drop_lines(block) as u64;
    }
    let cleared = block[0].len * (block[1].len / 64 + 1);
    if options.sum == Sum::Rings { cleared + block[0].len * block[1].len } else { cleared }
}

/// True if none of the cells at the nodes j to j + 61 of line i has a 1, as far as they are in one
/// row.
fn is_quiet(mask: &CellMask, i: usize, j: usize) -> bool {
    let lattice = mask.lattice();
    let width = lattice.cells[1];
    // At the ends, where closed rows begin again, nodes are looked at one by one.
    if j == 0 || j + 62 > width {
        return false;
    }
    lattice.span(0, i, 1).indices().all(|row| mask.is_clear(row * width + j - 1, row * width + j + 62))
}

/// The part of the surface that is left when lines have been dropped: a surface itself.
struct Window {
    lattice: Lattice,
    spans: [Span; 2],
    /// Closed directions of which no line has been dropped yet: they have no edge.
    rings: [bool; 2],
}

impl Window {
    fn is_empty(&self) -> bool {
        self.spans.iter().any(|span| span.len == 0)
    }

    /// Drops the lines of cells that a block covers from side to side and that are at the edge; how
    /// many.
    fn drop_lines(&mut self, block: [Span; 2]) -> usize {
        (0..2).map(|k| if block[1 - k].covers(self.spans[1 - k]) { self.shorten(k, block[k]) } else { 0 }).sum()
    }

    /// Takes a part away from the span in direction k, if it is at its edge: a ring has none, and
    /// becomes a strip.
    fn shorten(&mut self, k: usize, part: Span) -> usize {
        let (span, count) = (self.spans[k], self.lattice.cells[k]);
        if span.len == 0 {
            return 0;
        }
        if part.covers(span) {
            self.spans[k].len = 0;
            return span.len;
        }
        if self.rings[k] {
            self.rings[k] = false;
            self.spans[k] = Span::new(part.first + part.len, count - part.len, count);
            return part.len;
        }
        let last = (span.first + span.len - 1) % count;
        if part.contains(span.first) {
            // From the first line on, as far as the part goes.
            let dropped = (part.first + part.len + count - span.first) % count;
            self.spans[k] = Span::new(span.first + dropped, span.len - dropped, count);
            return dropped;
        }
        if part.contains(last) {
            let kept = (part.first + count - span.first) % count;
            self.spans[k].len = kept;
            return span.len - kept;
        }
        0
    }
}

/// Asks from time to time whether to go on.
struct ProgressTicker<'a, 'b> {
    job: &'a Job<'b>,
    spent: usize,
    fraction: f64,
}

impl ProgressTicker<'_, '_> {
    fn spend(&mut self, work: usize, fraction: f64) -> Result<()> {
        self.spent += work;
        self.fraction = self.fraction.max(fraction);
        if self.spent < 1 << 16 {
            return Ok(());
        }
        self.spent = 0;
        self.job.step(self.fraction, "search")
    }
}
