//! Strips between lines of a net, and their subdivision into cells where curves have joints.

use super::net_curve::CurvePiece;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort;

/// Breaks of different pieces closer than this, as a fraction of the piece, are merged.
const MAX_MERGED_BREAK_GAP: f64 = 1e-6;

const STAGE: &str = "making patches";

/// The intervals between the lines of one direction, and their subdivision into cells.
pub(super) struct LineStrips {
    /// The fraction of the parameter that each interval takes.
    pub(super) lengths: Vec<f64>,
    /// The ends of each interval's cells, as fractions of the interval; the last one is 1.
    breaks: Vec<Vec<f64>>,
    /// By interval and curve: the ends of the curve's segments, snapped to the breaks.
    segment_ends: Vec<Vec<Vec<f64>>>,
}

impl LineStrips {
    /// Computes the strips from the curves that cross them. `points` marks curves that are single
    /// points.
    pub(super) fn from_curves<const N: usize>(
        curves: &[Vec<CurvePiece<N>>],
        points: &[bool],
        job: &Job<'_>,
    ) -> Result<Self> {
        let count = curves[0].len();
        let mut lengths = alloc::filled(0.0, count)?;
        for (curve, _) in curves.iter().zip(points).filter(|&(_, &point)| !point) {
            let whole: f64 = curve.iter().map(|piece| piece.length).sum();
            lengths.iter_mut().zip(curve).for_each(|(length, piece)| *length += piece.length / whole);
        }
        let (mut all_breaks, mut all_ends) = (alloc::with_capacity(count)?, alloc::with_capacity(count)?);
        for strip in 0..count {
            job.step(strip as f64 / count as f64, STAGE)?;
            let own = alloc::collect(curves.iter().map(|curve| &curve[strip].segment_ends[..]))?;
            let (breaks, ends) = merge_breaks(&own, points)?;
            all_breaks.push(breaks);
            all_ends.push(ends);
        }
        Ok(LineStrips { lengths: fill_zero_lengths(lengths), breaks: all_breaks, segment_ends: all_ends })
    }

    /// The number of cells.
    pub(super) fn cell_count(&self) -> usize {
        self.breaks.iter().map(Vec::len).sum()
    }

    /// The strip of each cell, and the range of the cell within the strip.
    pub(super) fn strips_and_ranges_of_cells(&self) -> Result<Vec<(usize, [f64; 2])>> {
        let mut cells = alloc::with_capacity(self.cell_count())?;
        for (strip, breaks) in self.breaks.iter().enumerate() {
            cells.extend((0..breaks.len()).map(|k| (strip, [if k == 0 { 0.0 } else { breaks[k - 1] }, breaks[k]])));
        }
        Ok(cells)
    }

    /// The segments of each curve over each cell.
    pub(super) fn refine_curves_to_cells<const N: usize>(
        &self,
        curves: &[Vec<CurvePiece<N>>],
        job: &Job<'_>,
    ) -> Result<Vec<Vec<[DVec3; N]>>> {
        alloc::try_collect((0..curves.len()).map(|k| {
            job.step(k as f64 / curves.len() as f64, STAGE)?;
            let mut refined = alloc::with_capacity(self.cell_count())?;
            for (strip, piece) in curves[k].iter().enumerate() {
                piece.append_refined_segments(&self.segment_ends[strip][k], &self.breaks[strip], &mut refined)?;
            }
            Ok(refined)
        }))
    }
}

/// The breaks of a strip from the segment ends of the curves' pieces, and for each piece its ends
/// snapped to the breaks.
fn merge_breaks(segment_ends: &[&[f64]], points: &[bool]) -> Result<(Vec<f64>, Vec<Vec<f64>>)> {
    let curves = || segment_ends.iter().zip(points).filter(|&(_, &point)| !point).map(|(own, _)| *own);
    let Some(first) = curves().next() else {
        return Ok((alloc::filled(1.0, 1)?, alloc::try_collect(segment_ends.iter().map(|_| alloc::filled(1.0, 1)))?));
    };
    if curves().all(|ends| ends.len() == first.len()) {
        // Matched in order.
        let number = curves().count() as f64;
        let mean = |k: usize| curves().map(|ends| ends[k]).sum::<f64>() / number;
        let breaks = alloc::collect((0..first.len()).map(|k| if k + 1 == first.len() { 1.0 } else { mean(k) }))?;
        let ends = points.iter().map(|&point| if point { alloc::filled(1.0, 1) } else { alloc::copied(&breaks) });
        let ends = alloc::try_collect(ends)?;
        return Ok((breaks, ends));
    }
    let mut all = Vec::new();
    for (curve, ends) in segment_ends.iter().enumerate().filter(|&(curve, _)| !points[curve]) {
        alloc::extend(&mut all, ends[..ends.len() - 1].iter().map(|&end| (end, curve)))?;
    }
    sort::sort_stable(&mut all, &|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut ends: Vec<Vec<f64>> = alloc::collect(segment_ends.iter().map(|_| Vec::new()))?;
    let mut breaks: Vec<f64> = Vec::new();
    for (end, curve) in all {
        let last = breaks.last().copied().unwrap_or(0.0);
        if breaks.is_empty() || end - last > MAX_MERGED_BREAK_GAP || ends[curve].last() == Some(&last) {
            alloc::push(&mut breaks, end)?;
        }
        let end = breaks[breaks.len() - 1];
        alloc::push(&mut ends[curve], end)?;
    }
    alloc::push(&mut breaks, 1.0)?;
    ends.iter_mut().try_for_each(|ends| alloc::push(ends, 1.0))?;
    Ok((breaks, ends))
}

/// Replaces lengths that are (nearly) zero by the mean length.
pub(super) fn fill_zero_lengths(mut lengths: Vec<f64>) -> Vec<f64> {
    let sum: f64 = lengths.iter().sum();
    let mean = if sum > 0.0 { sum / lengths.len() as f64 } else { 1.0 };
    lengths.iter_mut().filter(|length| length.is_nan() || **length <= 1e-6 * mean).for_each(|length| *length = mean);
    lengths
}
