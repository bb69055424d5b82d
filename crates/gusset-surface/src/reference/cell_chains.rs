//! Cell regions: chains of cells, and the integer diameter (eqs. 3 to 6).

use super::cell_grid_shape::{CellGridShape, CyclicSpan};
use super::cell_mask::CellMask;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::job::Job;

/// Marks cells that chains do not reach.
const UNREACHED_CELL: u32 = u32::MAX;

/// Number of cells between two progress reports.
const CELLS_PER_REPORT: usize = 1 << 17;

/// A shortest chain of cells of a region between two cells, both included. Consecutive cells share
/// a node. Returns `None` if the cells are not connected.
///
/// The number of cells is the chain's integer length. The sum of their diameters bounds the
/// distance between any points of the first and the last cell, within the chain (3).
///
/// # Errors
/// [`Error::NoSuch`] if an end is not in the region, [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn shortest_chain(
    region: &CellMask,
    from: [usize; 2],
    to: [usize; 2],
    job: &Job<'_>,
) -> Result<Option<Vec<[usize; 2]>>> {
    let lattice = region.lattice();
    for end in [from, to] {
        lattice.check_cell(end)?;
        if !region.get(end) {
            let [index, count] = [lattice.index(end), lattice.len()].map(|n| n as u64);
            return Err(Error::NoSuch { element: Element::Cell, index, count });
        }
    }
    let mut walk = ShortestCellChains::new(lattice)?;
    walk.find_chains(region, to, job, 0.0)?;
    let steps = |cell: [usize; 2]| walk.steps_to_cell[lattice.index(cell)];
    if steps(from) == UNREACHED_CELL {
        return Ok(None);
    }
    let mut cells = alloc::with_capacity(steps(from) as usize + 1)?;
    let mut at = from;
    cells.push(at);
    // Always continues to a neighbour that is one step nearer to the end.
    while let Some(next) = lattice.neighbours(at).find(|&next| steps(at) > 0 && steps(next) == steps(at) - 1) {
        at = next;
        cells.push(at);
    }
    Ok(Some(cells))
}

/// The integer diameter I of a region (4): the number of cells of the longest shortest chain
/// between two of its cells; 0 for an empty region. Returns `None` if the region is not connected.
///
/// The diameter satisfies D <= I d (5). For a whole surface of m x n cells, I = max {m, n} (6),
/// with half the number plus one in a closed direction.
///
/// Not all pairs are examined. Let c be a cell in the middle of the region. A chain of more than 2
/// k steps has an end more than k steps from c. Cells are therefore tried by descending steps from
/// c, until no longer chain is possible. O(cells) for each cell tried: few for compact regions, all
/// in the worst case.
///
/// # Errors
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn integer_diameter(region: &CellMask, job: &Job<'_>) -> Result<Option<usize>> {
    let lattice = region.lattice();
    let Some(first) = region.cells().next() else { return Ok(Some(0)) };
    let count = region.count();
    if count == lattice.len() {
        let longest = |k: usize| if lattice.closed[k] { lattice.cells[k] / 2 + 1 } else { lattice.cells[k] };
        return Ok(Some(longest(0).max(longest(1))));
    }
    let mut walk = ShortestCellChains::new(lattice)?;
    // The middle of the region: half way along a long shortest chain.
    walk.find_chains(region, first, job, 0.0)?;
    if walk.reached_cells.len() != count {
        return Ok(None);
    }
    let far = walk.reached_cells[count - 1];
    walk.find_chains(region, lattice.cell(far as usize), job, 0.0)?;
    let mut longest = walk.steps_to_farthest_cell();
    let middle = walk.cell_after_steps(longest / 2);
    walk.find_chains(region, middle, job, 0.0)?;
    let (steps, order) = (std::mem::take(&mut walk.steps_to_cell), std::mem::take(&mut walk.reached_cells));
    walk = ShortestCellChains::new(lattice)?;
    for (tried, &cell) in order.iter().rev().enumerate() {
        if longest >= 2 * steps[cell as usize] {
            break;
        }
        walk.find_chains(region, lattice.cell(cell as usize), job, tried as f64 / count as f64)?;
        longest = longest.max(walk.steps_to_farthest_cell());
    }
    Ok(Some(longest as usize + 1))
}

/// The Euler characteristic of a region with its border: vertices minus edges plus cells. It is 1
/// for a connected region without holes, the paper's simply connected region, unless the region is
/// a whole surface closed both ways. O(cells).
///
/// # Errors
/// [`Error::Cancelled`].
pub fn euler_characteristic(region: &CellMask, job: &Job<'_>) -> Result<i64> {
    let lattice = region.lattice();
    let [lines_u, lines_v] = lattice.lines();
    let on =
        |rows: CyclicSpan, columns: CyclicSpan| rows.indices().any(|i| columns.indices().any(|j| region.get([i, j])));
    let single = |k: usize, at: usize| CyclicSpan::new(at, 1, lattice.cells[k]);
    let mut sum = region.count() as i64;
    for i in 0..lines_u {
        if (i * lines_v) % CELLS_PER_REPORT < lines_v {
            job.step(i as f64 / lines_u as f64, "vertices")?;
        }
        for j in 0..lines_v {
            let (rows, columns) = (lattice.span_around_line(0, i, 1), lattice.span_around_line(1, j, 1));
            sum += i64::from(on(rows, columns));
            sum -= i64::from(j < lattice.cells[1] && on(rows, single(1, j)));
            sum -= i64::from(i < lattice.cells[0] && on(single(0, i), columns));
        }
    }
    Ok(sum)
}

/// Shortest chains from one cell to all others of a region.
struct ShortestCellChains {
    lattice: CellGridShape,
    /// The steps to each cell.
    steps_to_cell: Vec<u32>,
    /// The cells that were reached, by ascending steps.
    reached_cells: Vec<u32>,
}

impl ShortestCellChains {
    fn new(lattice: CellGridShape) -> Result<Self> {
        Ok(ShortestCellChains {
            lattice,
            steps_to_cell: alloc::filled(UNREACHED_CELL, lattice.len())?,
            reached_cells: Vec::new(),
        })
    }

    fn find_chains(&mut self, region: &CellMask, from: [usize; 2], job: &Job<'_>, fraction: f64) -> Result<()> {
        let lattice = self.lattice;
        job.step(fraction, "chains")?;
        self.steps_to_cell.fill(UNREACHED_CELL);
        self.reached_cells.clear();
        alloc::reserve(&mut self.reached_cells, region.count())?;
        self.steps_to_cell[lattice.index(from)] = 0;
        self.reached_cells.push(lattice.index(from) as u32);
        let mut at = 0;
        while let Some(&cell) = self.reached_cells.get(at) {
            at += 1;
            if at % CELLS_PER_REPORT == 0 {
                job.step(fraction, "chains")?;
            }
            let next = self.steps_to_cell[cell as usize] + 1;
            for other in lattice.neighbours(lattice.cell(cell as usize)) {
                let k = lattice.index(other);
                if self.steps_to_cell[k] == UNREACHED_CELL && region.get(other) {
                    self.steps_to_cell[k] = next;
                    self.reached_cells.push(k as u32);
                }
            }
        }
        Ok(())
    }

    /// Returns the number of steps from the start to the farthest cell of the region (the
    /// eccentricity of the start).
    fn steps_to_farthest_cell(&self) -> u32 {
        self.reached_cells.last().map_or(0, |&cell| self.steps_to_cell[cell as usize])
    }

    /// Returns the cell after `step_count` steps on a shortest chain from the start to the farthest
    /// cell.
    fn cell_after_steps(&self, step_count: u32) -> [usize; 2] {
        let mut at = self.reached_cells.last().map_or([0, 0], |&cell| self.lattice.cell(cell as usize));
        let of = |cell: [usize; 2]| self.steps_to_cell[self.lattice.index(cell)];
        let nearer = |at: [usize; 2]| {
            let mut around = self.lattice.neighbours(at);
            around.find(|&next| of(at) > step_count && of(next).wrapping_add(1) == of(at))
        };
        while let Some(next) = nearer(at) {
            at = next;
        }
        at
    }
}
