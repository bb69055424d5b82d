//! The paper's search, corrected: each evaluated node excludes the block of surrounding cells that
//! cannot contain the object (theorems T2 to T4 of the module).
//!
//! Invariant: the mask contains all cells that may contain the object. O(n / 64) for the mask and
//! O(1) to O(J^2) for each evaluated node.

use super::cell_grid_shape::{CellGridShape, CyclicSpan};
use super::cell_mask::CellMask;
use super::cell_sizes::{CellBoundSum, CellSizeBounds};
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

/// The goal of a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SearchGoal {
    /// All cells with a point at most this far (theorem T2).
    Within(f64),
    /// The nearest points. Cells farther than the nearest node so far are excluded (theorem T3).
    /// The paper's rule would exclude the answer itself (erratum E3).
    Least,
}

/// Options of [`search`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchOptions {
    /// The goal.
    pub goal: SearchGoal,
    /// How sizes of cells are summed.
    pub sum: CellBoundSum,
    /// If true, evaluates all nodes row by row, as in the paper. If false, begins with a few
    /// distant nodes, then evaluates nodes between them, which needs fewer evaluations.
    pub by_rows: bool,
    /// Whether lines at the edge are dropped if a block covers them from side to side, which leaves
    /// a smaller surface. Blocks that do not reach an edge, or do not extend from side to side,
    /// drop nothing (erratum E5).
    pub drop_lines: bool,
}

impl SearchOptions {
    /// Returns the defaults: few nodes first, J d as the sum, lines dropped.
    pub fn new(goal: SearchGoal) -> Self {
        SearchOptions { goal, sum: CellBoundSum::Greatest, by_rows: false, drop_lines: true }
    }
}

/// The outcome of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct SearchOutcome {
    /// The cells that may contain the object: all that are not excluded.
    pub possible_cells: CellMask,
    /// The number of evaluated nodes.
    pub evaluations: u64,
    /// The number of excluded blocks.
    pub blocks: u64,
    /// The number of lines of cells that were dropped.
    pub dropped: u64,
    /// The nearest evaluated node, and its distance.
    pub nearest_node_and_distance: ([usize; 2], f64),
}

/// Finds the cells that may contain an object. `measure` returns the distance of a node from the
/// object. It must not increase faster than `sizes` allow: distances in space require Euclidean
/// diameters, deviations of the normal from an angle require the variation of normals.
///
/// # Errors
/// [`Error::OptionOutOfRange`] if the goal is NaN or negative, [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub fn search(
    sizes: &CellSizeBounds,
    mut measure: impl FnMut([usize; 2]) -> f64,
    options: &SearchOptions,
    job: &Job<'_>,
) -> Result<SearchOutcome> {
    search_with_node_cost(sizes, 0, &mut measure, options, job)
}

/// Runs [`search`] with the cost of evaluating a node, in words of the mask.
pub(super) fn search_with_node_cost(
    sizes: &CellSizeBounds,
    node_cost: usize,
    measure: &mut dyn FnMut([usize; 2]) -> f64,
    options: &SearchOptions,
    job: &Job<'_>,
) -> Result<SearchOutcome> {
    if let SearchGoal::Within(within) = options.goal {
        Error::require(within >= 0.0, "within", within, "at least 0")?;
    }
    let lattice = sizes.lattice();
    let mut window =
        SpansNotYetDropped { lattice, spans: lattice.cells.map(CyclicSpan::all_intervals), rings: lattice.closed };
    let least = ([0, 0], f64::INFINITY);
    let mut outcome = SearchOutcome {
        possible_cells: CellMask::full(lattice)?,
        evaluations: 0,
        blocks: 0,
        dropped: 0,
        nearest_node_and_distance: least,
    };
    let [lines_u, lines_v] = lattice.lines();
    let widest = lines_u.max(lines_v).next_power_of_two();
    let mut stride = if options.by_rows { 1 } else { widest };
    let mut ticker = ProgressTicker { job, spent: 0, fraction: 0.0 };
    while stride > 0 {
        for i in (0..lines_u).step_by(stride) {
            // Stops at once if no cell is left.
            if window.is_empty() {
                return Ok(outcome);
            }
            ticker.spend_work(lines_v / stride / 8 + 1, i as f64 / (lines_u * stride) as f64)?;
            if !lattice.span_around_line(0, i, 1).indices().any(|row| window.spans[0].contains_interval(row)) {
                continue;
            }
            let mut j = 0;
            while j < lines_v {
                if stride == 1 && are_cells_of_nodes_excluded(&outcome.possible_cells, i, j) {
                    j += 62;
                    continue;
                }
                // Coarser passes have evaluated these nodes.
                let seen = !options.by_rows
                    && stride < widest
                    && (i / stride).is_multiple_of(2)
                    && (j / stride).is_multiple_of(2);
                if !seen && lattice.cells_at_node([i, j]).any(|cell| outcome.possible_cells.get(cell)) {
                    let cleared =
                        exclude_cells_around_node(&mut outcome, &mut window, sizes, [i, j], measure([i, j]), options);
                    ticker.spend_work(cleared + node_cost, 0.0)?;
                }
                j += stride;
            }
        }
        stride /= 2;
    }
    Ok(outcome)
}

/// Excludes the cells that a node at distance `distance` proves to be too far. Returns the work
/// done.
fn exclude_cells_around_node(
    found: &mut SearchOutcome,
    window: &mut SpansNotYetDropped,
    sizes: &CellSizeBounds,
    node: [usize; 2],
    distance: f64,
    options: &SearchOptions,
) -> usize {
    found.evaluations += 1;
    if distance < found.nearest_node_and_distance.1
        || (distance == found.nearest_node_and_distance.1 && node < found.nearest_node_and_distance.0)
    {
        found.nearest_node_and_distance = (node, distance);
    }
    let within = match options.goal {
        SearchGoal::Within(within) => within,
        SearchGoal::Least => found.nearest_node_and_distance.1,
    };
    // Points at most `within` away must remain. With the paper's rule, the block may touch them
    // (erratum E2).
    let (steps, _) = sizes.max_steps_within_distance(node, distance - within, options.sum);
    let lattice = sizes.lattice();
    if steps == 0 {
        for cell in lattice.cells_at_node(node) {
            if sizes.get(cell) < distance - within {
                found.possible_cells.set(cell, false);
            }
        }
        return 8;
    }
    let block = lattice.block_around_node(node, steps);
    found.possible_cells.clear_block(block);
    found.blocks += 1;
    if options.drop_lines {
        found.dropped += window.drop_edge_lines_covered_by(block) as u64;
    }
    let cleared = block[0].len * (block[1].len / 64 + 1);
    if options.sum == CellBoundSum::Rings { cleared + block[0].len * block[1].len } else { cleared }
}

/// True if the bits of all cells at the nodes j to j + 61 of line i are 0, and these cells are
/// contiguous in their rows.
fn are_cells_of_nodes_excluded(mask: &CellMask, i: usize, j: usize) -> bool {
    let lattice = mask.lattice();
    let width = lattice.cells[1];
    // At the ends of a row, where closed rows continue, nodes are examined one by one.
    if j == 0 || j + 62 > width {
        return false;
    }
    lattice
        .span_around_line(0, i, 1)
        .indices()
        .all(|row| mask.are_bits_clear(row * width + j - 1, row * width + j + 62))
}

/// The part of the surface that remains after lines were dropped, which is again a surface.
struct SpansNotYetDropped {
    lattice: CellGridShape,
    spans: [CyclicSpan; 2],
    /// Closed directions without dropped lines, which do not have an edge yet.
    rings: [bool; 2],
}

impl SpansNotYetDropped {
    fn is_empty(&self) -> bool {
        self.spans.iter().any(|span| span.len == 0)
    }

    /// Drops lines of cells at the edge that a block covers from side to side. Returns their
    /// number.
    fn drop_edge_lines_covered_by(&mut self, block: [CyclicSpan; 2]) -> usize {
        (0..2)
            .map(
                |k| if block[1 - k].covers_span(self.spans[1 - k]) { self.remove_part_at_edge(k, block[k]) } else { 0 },
            )
            .sum()
    }

    /// Removes a part from the span in direction k, if the part is at its edge. A ring does not
    /// have an edge, so it becomes a strip.
    fn remove_part_at_edge(&mut self, k: usize, part: CyclicSpan) -> usize {
        let (span, count) = (self.spans[k], self.lattice.cells[k]);
        if span.len == 0 {
            return 0;
        }
        if part.covers_span(span) {
            self.spans[k].len = 0;
            return span.len;
        }
        if self.rings[k] {
            self.rings[k] = false;
            self.spans[k] = CyclicSpan::new(part.first_interval + part.len, count - part.len, count);
            return part.len;
        }
        let last = (span.first_interval + span.len - 1) % count;
        if part.contains_interval(span.first_interval) {
            // From the first line to the end of the part.
            let dropped = (part.first_interval + part.len + count - span.first_interval) % count;
            self.spans[k] = CyclicSpan::new(span.first_interval + dropped, span.len - dropped, count);
            return dropped;
        }
        if part.contains_interval(last) {
            let kept = (part.first_interval + count - span.first_interval) % count;
            self.spans[k].len = kept;
            return span.len - kept;
        }
        0
    }
}

/// Reports progress from time to time.
struct ProgressTicker<'a, 'b> {
    job: &'a Job<'b>,
    spent: usize,
    fraction: f64,
}

impl ProgressTicker<'_, '_> {
    fn spend_work(&mut self, work: usize, fraction: f64) -> Result<()> {
        self.spent += work;
        self.fraction = self.fraction.max(fraction);
        if self.spent < 1 << 16 {
            return Ok(());
        }
        self.spent = 0;
        self.job.step(self.fraction, "search")
    }
}
