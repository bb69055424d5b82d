//! Curves through nodes by the schemes of surfaces, and coordinate curves of sheets.
//!
//! The paper treats curves like surfaces with one dimension less: points take the place of
//! coordinate curves, and arcs of cells.

use super::axis::{GridAxis, NODES_PER_CUBIC};
use super::cells::SheetCells;
use super::checks::check_nodes_finite;
use super::{Scheme, Sheet, each_sheet};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bernstein::evaluate;
use gusset_base::job::Job;
use gusset_curve::{Curve, CurveView};

/// Number of segments between two progress reports.
const SEGMENTS_PER_REPORT: usize = 1 << 12;

/// Returns the curve of fourth order through nodes, with one cubic between consecutive nodes. It
/// uses the interpolation schemes of surfaces.
///
/// If `closed`, the last node repeats the first one, and tangents are continuous there.
///
/// # Errors
/// [`Error::NotFinite`]; [`Error::NetTooSmall`] if there are fewer than two nodes, or fewer than
/// four on a closed curve; [`Error::CurveNotClosed`]; [`Error::TooLarge`], [`Error::OutOfMemory`],
/// [`Error::Cancelled`]. O(nodes).
pub fn curve_through(nodes: &[DVec3], closed: bool, scheme: Scheme, job: &Job<'_>) -> Result<Curve> {
    if nodes.len() < GridAxis::min_line_count(closed) {
        return Err(Error::NetTooSmall { rows: 1, columns: nodes.len() as u64 });
    }
    Error::check_count("nodes", nodes.len() as u64, u64::from(u32::MAX / 3))?;
    check_nodes_finite(nodes)?;
    if closed && nodes.first() != nodes.last() {
        return Err(Error::CurveNotClosed);
    }
    let axis = GridAxis::new(nodes.len(), closed, scheme);
    let inner = |weights: &[f64; NODES_PER_CUBIC], lines: &[usize; NODES_PER_CUBIC]| {
        weights.iter().zip(lines).map(|(&weight, &line)| weight * nodes[line]).sum::<DVec3>()
    };
    let segments = (0..axis.interval_count()).map(|cell| {
        let (lines, weights) = axis.nodes_and_weights(cell);
        [nodes[cell], inner(&weights[1], &lines), inner(&weights[2], &lines), nodes[cell + 1]]
    });
    join_segments(segments, axis.interval_count(), closed, job)
}

/// Joins segments of equal degree, each of which begins where the previous one ends.
fn join_segments<const N: usize>(
    segments: impl Iterator<Item = [DVec3; N]>,
    count: usize,
    closed: bool,
    job: &Job<'_>,
) -> Result<Curve> {
    let mut points = alloc::with_capacity(count * (N - 1) + 1)?;
    let mut ends = alloc::with_capacity(count + 1)?;
    ends.push(0);
    for (k, segment) in segments.enumerate() {
        job.step_every(SEGMENTS_PER_REPORT, k, count, "curve on a surface")?;
        if points.is_empty() {
            points.push(segment[0]);
        }
        points.extend_from_slice(&segment[1..]);
        ends.push(points.len() as u32 - 1);
    }
    CurveView::new(&points, &ends, closed)?.to_owned()
}

impl Sheet<'_> {
    /// The coordinate curve at constant u, which counts rows of cells from 0. It has a segment for
    /// each cell along it, and is closed if the sheet is closed in v.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`], [`Error::OutOfMemory`], [`Error::Cancelled`]. O(cells along the
    /// curve).
    pub fn row_curve(&self, u: f64, job: &Job<'_>) -> Result<Curve> {
        self.coordinate_curve(0, u, job)
    }

    /// The coordinate curve at constant v, which counts columns of cells from 0.
    ///
    /// # Errors
    /// As for [`Sheet::row_curve`].
    pub fn column_curve(&self, v: f64, job: &Job<'_>) -> Result<Curve> {
        self.coordinate_curve(1, v, job)
    }

    fn coordinate_curve(&self, direction: usize, at: f64, job: &Job<'_>) -> Result<Curve> {
        let (line, within) = cell_and_parameter(at, self.cells()[direction])?;
        let (count, closed) = (self.cells()[1 - direction], self.has_exact_seams()[1 - direction]);
        each_sheet!(self, cells => {
            let patch = |k: usize| match direction {
                0 => SheetCells::cell_patch(cells, line, k).transposed(),
                _ => SheetCells::cell_patch(cells, k, line),
            };
            join_segments((0..count).map(|k| patch(k).points.map(|row| evaluate(&row, within))), count, closed, job)
        })
    }
}

/// The cell of a parameter that counts cells, and the parameter within the cell.
fn cell_and_parameter(parameter: f64, cells: usize) -> Result<(usize, f64)> {
    Error::require((0.0..=cells as f64).contains(&parameter), "parameter", parameter, 0.0..=cells as f64)?;
    let cell = (parameter as usize).min(cells - 1);
    Ok((cell, parameter - cell as f64))
}
