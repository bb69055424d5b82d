//! Cheapest path through the lattice, for costs that depend only on each step: exact dynamic
//! programming over a band.
//!
//! A node (i, j) is reached from (i - 1, j) or from (i, j - 1). If the metric allows steps on both
//! rims, it is also reached from (i - 1, j - 1). The cheapest path to it extends the cheapest of
//! these paths (Fuchs, Kedem and Uselton, 1977). The steps into the nodes are stored for one block
//! of rows at a time. The first pass stores the costs at each block's start, and the backtracking
//! computes each block except the last again. but the last once more.

use super::lattice_band::LatticeBand;
use super::rim_pair::{MeridianEnds, RimPair, STAGE};
use super::step_metric::{PointArrays, StepCosts, StepMetric};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Largest number of nodes whose arrivals are stored at a time, one byte each.
const MAX_STORED_ARRIVALS: usize = 1 << 26;

/// Nodes between two progress reports.
const NODES_PER_REPORT: usize = 1 << 19;

// The step by which a node is reached.
const STEP_ON_A: u8 = 0;
const STEP_ON_B: u8 = 1;
const STEP_ON_BOTH: u8 = 2;

/// Returns the cheapest path within `band` from (0, 0) to (N, M); `None` if the forbidden nodes
/// block all paths.
///
/// Time: the number of nodes in the band. Extra memory: one byte per node for at most 2^26 nodes,
/// and 8 bytes per node in the first row of each block of 2^26 nodes.
pub(super) fn cheapest_path(
    rims: &RimPair<'_>,
    metric: StepMetric,
    band: &LatticeBand,
    job: &Job<'_>,
) -> Result<Option<Vec<MeridianEnds>>> {
    let (n, m) = (band.last_row(), band.last_column());
    let blocks = band.blocks_of_rows(MAX_STORED_ARRIVALS)?;
    let largest = blocks.iter().map(|rows| band.node_count(rows.clone())).max().unwrap_or(0);
    let mut arrivals = alloc::filled(0u8, largest)?;
    let mut table = CostTable {
        rims,
        metric,
        band,
        points_of_b: PointArrays::new(rims.b)?,
        step_costs: StepCosts::zeros_for_nodes(m + 1)?,
        least_costs_of_row: alloc::filled(f64::INFINITY, m + 1)?,
    };

    table.compute_first_row();
    let mut starts = alloc::with_capacity(blocks.len())?;
    for rows in &blocks {
        starts.push(alloc::copied(&table.least_costs_of_row[band.columns_of_row(rows.start - 1)])?);
        let part = job.sub_job(0.5 * (rows.start - 1) as f64 / n as f64, 0.5 * (rows.end - 1) as f64 / n as f64);
        table.compute_rows(rows.clone(), &mut arrivals, &part)?;
    }
    if table.least_costs_of_row[m] == f64::INFINITY {
        return Ok(None);
    }

    let (mut i, mut j) = (n, m);
    let mut path = alloc::with_capacity(n + m + 1)?;
    for (rows, start) in blocks.iter().zip(&starts).rev() {
        // The arrivals of the last block are still stored.
        if rows.end <= n {
            table.least_costs_of_row.fill(f64::INFINITY);
            table.least_costs_of_row[band.columns_of_row(rows.start - 1)].copy_from_slice(start);
            // Progress grows from the last block to the first.
            let progress = |row: usize| 1.0 - 0.5 * row as f64 / n as f64;
            let part = job.sub_job(progress(rows.end - 1), progress(rows.start));
            table.compute_rows(rows.clone(), &mut arrivals, &part)?;
        }
        let mut row_start = band.node_count(rows.start..i);
        while i >= rows.start {
            path.push([i as u32, j as u32]);
            let arrival = arrivals[row_start + j - band.columns_of_row(i).start()];
            j -= usize::from(arrival != STEP_ON_A);
            if arrival != STEP_ON_B {
                i -= 1;
                row_start -= if i >= rows.start { band.row_width(i) } else { 0 };
            }
        }
    }
    path.extend((0..=j as u32).rev().map(|j| [0, j]));
    path.reverse();
    Ok(Some(path))
}

struct CostTable<'a> {
    rims: &'a RimPair<'a>,
    metric: StepMetric,
    band: &'a LatticeBand,
    points_of_b: PointArrays,
    step_costs: StepCosts,
    /// The least costs of the nodes in the last computed row; infinite outside the band.
    least_costs_of_row: Vec<f64>,
}

impl CostTable<'_> {
    fn measure_row_steps(&mut self, i: usize) {
        let (low, high) = self.band.columns_of_row(i).into_inner();
        self.metric.compute_step_costs(self.rims.a, &self.points_of_b, i, low..high + 1, &mut self.step_costs);
        for &[_, j] in self.rims.forbidden_in_row(i) {
            self.step_costs.costs_on_a[j as usize] = f64::INFINITY;
            self.step_costs.costs_on_b[j as usize] = f64::INFINITY;
        }
    }

    /// Computes row 0: the start, and the path along B from it.
    fn compute_first_row(&mut self) {
        self.measure_row_steps(0);
        let mut left = if self.rims.is_forbidden([0, 0]) { f64::INFINITY } else { 0.0 };
        self.least_costs_of_row[0] = left;
        for j in 1..=*self.band.columns_of_row(0).end() {
            left += self.step_costs.costs_on_b[j];
            self.least_costs_of_row[j] = left;
        }
    }

    /// Computes the rows `rows` from the row before them.
    fn compute_rows(&mut self, rows: std::ops::Range<usize>, arrivals: &mut [u8], job: &Job<'_>) -> Result<()> {
        let (first, count) = (rows.start, rows.len());
        let (mut used, mut next_report) = (0, NODES_PER_REPORT);
        for i in rows {
            self.measure_row_steps(i);
            let width = self.band.row_width(i);
            if self.metric.may_step_on_both() {
                self.compute_next_row::<true>(i, &mut arrivals[used..used + width]);
            } else {
                self.compute_next_row::<false>(i, &mut arrivals[used..used + width]);
            }
            used += width;
            if used >= next_report {
                next_report += NODES_PER_REPORT;
                job.step((i - first) as f64 / count as f64, STAGE)?;
            }
        }
        Ok(())
    }

    /// Replaces the costs of row i - 1 by the costs of row i.
    fn compute_next_row<const BOTH: bool>(&mut self, i: usize, arrivals: &mut [u8]) {
        let columns = self.band.columns_of_row(i);
        let low = *columns.start();
        // The cost left of the band belongs to an older row, unless the band starts farther right
        // than in row i - 1.
        let shifted = low > *self.band.columns_of_row(i - 1).start();
        let mut before = if BOTH && shifted { self.least_costs_of_row[low - 1] } else { f64::INFINITY };
        let mut left = f64::INFINITY;
        let steps =
            self.step_costs.costs_on_a[columns.clone()].iter().zip(&self.step_costs.costs_on_b[columns.clone()]);
        for ((cost, (step_a, step_b)), arrival) in self.least_costs_of_row[columns].iter_mut().zip(steps).zip(arrivals)
        {
            let (by_a, by_b) = (*cost + step_a, left + step_b);
            let mut best = if by_b < by_a { by_b } else { by_a };
            *arrival = if by_b < by_a { STEP_ON_B } else { STEP_ON_A };
            if BOTH {
                let by_both = before + step_a;
                if by_both <= best {
                    best = by_both;
                    *arrival = STEP_ON_BOTH;
                }
                before = *cost;
            }
            *cost = best;
            left = best;
        }
    }
}
