//! Decimation: rows and columns are removed greedily, in the order of the deviation that each
//! causes.
//!
//! Invariant: the deviation of removed nodes from the segments that replace them stays within half
//! the tolerance for rows, and for columns. O(nodes log rows) approximately.

use super::whole_sides::{min_rows_and_columns, net_with_sides, select_lines, sides_or_glued_inside_error};
use crate::{Net, each};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::par;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

/// The result of [`decimate`].
#[derive(Debug)]
pub struct Decimated {
    /// The net of the rows and columns that were kept, bit for bit.
    pub net: Net<'static>,
    /// The rows that were kept.
    pub rows: Vec<usize>,
    /// The columns that were kept.
    pub columns: Vec<usize>,
    /// The largest distance of removed nodes from the segments that replace them, for rows plus for
    /// columns; at most the tolerance.
    pub deviation: f64,
}

/// Removes rows, then columns, one at a time, always the one of least cost.
///
/// The cost of a row is a largest distance: of its nodes, and of the nodes of adjacent removed
/// rows, from the segments between the kept rows on both sides. Rows may cost up to half the
/// tolerance, and so may columns, which are evaluated at the kept rows. First and last rows and
/// columns are kept. So are three distinct rows of closed columns, and one or two between poles, so
/// that the surface stays the same. Rows with some missing nodes are kept.
///
/// O(nodes log rows) approximately.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a tolerance that is negative or NaN, [`Error::GluedInside`],
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn decimate(net: &Net<'_>, tolerance: f64, job: &Job<'_>) -> Result<Decimated> {
    Error::require(tolerance >= 0.0, "tolerance", tolerance, "at least 0")?;
    let (sides, limit) = (sides_or_glued_inside_error(net)?, tolerance / 2.0);
    let (h, w) = (net.shape().rows(), net.shape().columns());
    each!(net.coordinates(), planes => {
        let all = alloc::collect(0..w)?;
        let [min_rows, min_columns] = min_rows_and_columns(sides, 4);
        let row = |k: usize, j: usize| planes.get(k, j);
        let cost = |gap: Range<usize>| max_deviation_of_removed_lines(row, gap, &all);
        let (rows, by_rows) = choose_kept_lines(h, min_rows, limit, &job.sub_job(0.0, 0.5), cost)?;
        let column = |k: usize, i: usize| planes.get(i, k);
        let cost = |gap: Range<usize>| max_deviation_of_removed_lines(column, gap, &rows);
        let (columns, by_columns) = choose_kept_lines(w, min_columns, limit, &job.sub_job(0.5, 1.0), cost)?;
        let net = net_with_sides(select_lines(net, &rows, &columns, &job.sub_job(1.0, 1.0))?, net, sides)?;
        Ok(Decimated { net, rows, columns, deviation: by_rows + by_columns })
    })
}

/// Returns the largest distance of nodes in a gap, between two kept lines, from the segments across
/// it. `node(k, j)`: node j of line k.
fn max_deviation_of_removed_lines(node: impl Fn(usize, usize) -> DVec3, gap: Range<usize>, places: &[usize]) -> f64 {
    let mut max = 0.0f64;
    for &j in places {
        let (a, b) = (node(gap.start, j), node(gap.end, j));
        for k in gap.start + 1..gap.end {
            let point = node(k, j);
            let ends = a.is_finite() && b.is_finite();
            match (point.is_finite(), ends) {
                (true, true) => max = max.max(squared_distance(point, a, b)),
                // A hole across the gap stays a hole.
                (false, false) if !a.is_finite() && !b.is_finite() => {}
                _ => return f64::INFINITY,
            }
        }
    }
    max.sqrt()
}

/// Returns the squared distance of a point from a segment.
fn squared_distance(point: DVec3, a: DVec3, b: DVec3) -> f64 {
    let (along, to) = (b - a, point - a);
    let square = along.length_squared();
    let t = if square > 0.0 { (to.dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
    (to - t * along).length_squared()
}

/// Removes lines from `line_count` lines, one at a time, always the one of least cost. Stops before a
/// line costs more than `max_cost`, or fewer than `min_lines` lines are left. Returns the kept lines,
/// and the largest cost of a removed line.
fn choose_kept_lines(
    line_count: usize,
    min_lines: usize,
    max_cost: f64,
    job: &Job<'_>,
    cost: impl Fn(Range<usize>) -> f64 + Sync,
) -> Result<(Vec<usize>, f64)> {
    job.step(0.0, "decimate")?;
    // A doubly linked list of the kept lines.
    let mut before = alloc::collect((0..line_count).map(|k| k.wrapping_sub(1)))?;
    let mut after = alloc::collect(1..line_count + 1)?;
    let mut queue: BinaryHeap<RemovalCandidate> = BinaryHeap::from(alloc::with_capacity(3 * line_count)?);
    let costs = par::map_cancellable(
        &job.sub_job(0.0, 0.5),
        "decimate",
        par::split_into_ranges(line_count - 2, 16),
        |lines| lines.map(|k| cost(k..k + 2)).collect::<Vec<_>>(),
    )?;
    let job = job.sub_job(0.5, 1.0);
    queue.extend(costs.into_iter().flatten().enumerate().map(|(k, cost)| removal_candidate(cost, k..k + 2, k + 1)));
    let (mut left, mut max) = (line_count, 0.0f64);
    while let Some(Reverse((bits, _, line, from, to))) = queue.pop() {
        if f64::from_bits(bits) > max_cost || bits == f64::INFINITY.to_bits() || left <= min_lines {
            break;
        }
        if (before[line], after[line]) != (from, to) {
            // Outdated: a neighbour was removed since.
            continue;
        }
        (max, left) = (max.max(f64::from_bits(bits)), left - 1);
        (after[from], before[to]) = (to, from);
        after[line] = line;
        for neighbour in [from, to] {
            if neighbour != 0 && neighbour != line_count - 1 {
                let gap = before[neighbour]..after[neighbour];
                queue.push(removal_candidate(cost(gap.clone()), gap, neighbour));
            }
        }
        if left % 16 == 0 {
            job.step(1.0 - left as f64 / line_count as f64, "decimate")?;
        }
    }
    let lines =
        alloc::gather(std::iter::successors(Some(0), |&line| Some(after[line]).filter(|&next| next < line_count)))?;
    Ok((lines, max))
}

/// Least cost first. Ties go to the narrowest gap, so that gaps grow evenly and all costs take O(n
/// log n).
type RemovalCandidate = Reverse<(u64, usize, usize, usize, usize)>;

fn removal_candidate(cost: f64, gap: Range<usize>, line: usize) -> RemovalCandidate {
    // The bit patterns of non-negative numbers sort like the numbers.
    Reverse((cost.to_bits(), gap.len(), line, gap.start, gap.end))
}
