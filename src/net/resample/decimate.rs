//! Rows and columns left out, as long as the surface hardly changes.

use super::{least, selected, sides, with_sides};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::net::{Net, each};
use crate::par;
use glam::DVec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// What [`decimate`] makes.
#[derive(Debug)]
pub struct Decimated {
    /// The net of the rows and columns that were kept, bit for bit.
    pub net: Net<'static>,
    /// The rows that were kept.
    pub rows: Vec<usize>,
    /// The columns that were kept.
    pub columns: Vec<usize>,
    /// How far nodes are, at most, from the segments that replace their columns, plus the same for those that replace
    /// rows; at most the tolerance.
    pub deviation: f64,
}

/// Leaves out rows, and then columns, one after the other, always the one whose loss costs least.
///
/// What the loss of a row costs: how far, at most, any node of it, and of those left out beside it before, is from the
/// segment that joins the nodes of its column in the rows that are kept on both sides. Rows may cost up to half the
/// tolerance, and columns, judged at the rows that are left, as much. First and last ones are kept, three distinct
/// rows of closed columns, and one or two between poles, lest the surface become another. A row that is missing in part is kept.
///
/// About O(nodes x log rows).
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a tolerance that is negative or NaN, [`Error::GluedInside`], [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub fn decimate(net: &Net<'_>, tolerance: f64, job: &Job<'_>) -> Result<Decimated> {
    if tolerance.is_nan() || tolerance < 0.0 {
        return Err(Error::OptionOutOfRange { option: "tolerance", value: tolerance });
    }
    let (sides, limit) = (sides(net)?, tolerance / 2.0);
    let (h, w) = (net.shape().rows(), net.shape().columns());
    each!(net.coordinates(), planes => {
        let all = alloc::collect(0..w)?;
        let [least_rows, least_columns] = least(sides, 4);
        let row = |k: usize, j: usize| planes.get(k, j);
        let (rows, by_rows) = kept(h, least_rows, limit, &job.part(0.0, 0.5), |gap| deviation(row, gap, &all))?;
        let column = |k: usize, i: usize| planes.get(i, k);
        let (columns, by_columns) = kept(w, least_columns, limit, &job.part(0.5, 1.0), |gap| deviation(column, gap, &rows))?;
        let net = with_sides(selected(net, &rows, &columns)?, net, sides)?;
        Ok(Decimated { net, rows, columns, deviation: by_rows + by_columns })
    })
}

/// Two lines that are kept, with nothing kept between them.
#[derive(Clone, Copy)]
struct Gap {
    from: usize,
    to: usize,
}

/// How far nodes between the two lines are from the segments between these, at most: `node(k, j)` is node j of line k.
fn deviation(node: impl Fn(usize, usize) -> DVec3, gap: Gap, places: &[usize]) -> f64 {
    let mut most = 0.0f64;
    for &j in places {
        let (a, b) = (node(gap.from, j), node(gap.to, j));
        for k in gap.from + 1..gap.to {
            let point = node(k, j);
            let ends = a.is_finite() && b.is_finite();
            match (point.is_finite(), ends) {
                (true, true) => most = most.max(squared_distance(point, a, b)),
                // A hole all through stays a hole.
                (false, false) if !a.is_finite() && !b.is_finite() => {}
                _ => return f64::INFINITY,
            }
        }
    }
    most.sqrt()
}

/// From a point to a segment.
fn squared_distance(point: DVec3, a: DVec3, b: DVec3) -> f64 {
    let (along, to) = (b - a, point - a);
    let square = along.length_squared();
    let t = if square > 0.0 { (to.dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
    (to - t * along).length_squared()
}

/// Which of `count` lines are kept, and the largest cost of those that are not.
fn kept(
    count: usize,
    least: usize,
    limit: f64,
    job: &Job<'_>,
    cost: impl Fn(Gap) -> f64 + Sync,
) -> Result<(Vec<usize>, f64)> {
    job.step(0.0, "decimate")?;
    // Doubly linked: the lines before and after each that is kept.
    let mut before = alloc::collect((0..count).map(|k| k.wrapping_sub(1)))?;
    let mut after = alloc::collect(1..count + 1)?;
    let mut queue = BinaryHeap::new();
    queue
        .try_reserve(3 * count)
        .map_err(|_| Error::OutOfMemory { bytes: (3 * count * size_of::<Candidate>()) as u64 })?;
    let costs = par::chunks_cancellable(&job.part(0.0, 0.5), "decimate", count - 2, 16, |lines| {
        lines.map(|k| cost(Gap { from: k, to: k + 2 })).collect::<Vec<_>>()
    })?;
    let job = job.part(0.5, 1.0);
    queue.extend(
        costs.into_iter().flatten().enumerate().map(|(k, cost)| candidate(cost, Gap { from: k, to: k + 2 }, k + 1)),
    );
    let (mut left, mut most) = (count, 0.0f64);
    while let Some(Reverse((bits, _, line, from, to))) = queue.pop() {
        if f64::from_bits(bits) > limit || bits == f64::INFINITY.to_bits() || left <= least {
            break;
        }
        if (before[line], after[line]) != (from, to) {
            // Out of date: a neighbour went.
            continue;
        }
        (most, left) = (most.max(f64::from_bits(bits)), left - 1);
        (after[from], before[to]) = (to, from);
        after[line] = line;
        for neighbour in [from, to] {
            if neighbour != 0 && neighbour != count - 1 {
                let gap = Gap { from: before[neighbour], to: after[neighbour] };
                queue.push(candidate(cost(gap), gap, neighbour));
            }
        }
        if left % 16 == 0 {
            job.step(1.0 - left as f64 / count as f64, "decimate")?;
        }
    }
    let mut lines = alloc::with_capacity(left)?;
    lines.extend(std::iter::successors(Some(0), |&line| Some(after[line]).filter(|&next| next < count)));
    Ok((lines, most))
}

/// Least cost first; of equal ones the narrowest gap, so that gaps grow evenly and all costs together take O(n log n).
type Candidate = Reverse<(u64, usize, usize, usize, usize)>;

fn candidate(cost: f64, gap: Gap, line: usize) -> Candidate {
    // Bits of numbers that are not negative are in their order.
    Reverse((cost.to_bits(), gap.to - gap.from, line, gap.from, gap.to))
}
