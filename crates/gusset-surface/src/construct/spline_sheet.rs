//! Sheets of splines: the exact pieces of polynomial splines, and approximations of rational ones.

use super::rational;
use super::spline::{Spline, SplineInterval, SplineOptions, knots_at_cell_borders};
use crate::checks::first_finite_points;
use crate::patches::SplineOrigin;
use crate::{MAX_DEGREE, MAX_NODES, Patch, Patches, Sheet};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

impl Sheet<'static> {
    /// Converts a spline to Bézier patches. If the spline lacks weights, or all weights are equal,
    /// the patches are exact within rounding, and have degree 3 or the larger of the two degrees.
    /// Otherwise they have degree 7, and approximate the spline within a proven distance,
    /// [`Sheet::deviation`].
    ///
    /// O(spans x degree^3), or O(cells x degree^2); 384 bytes for each cell up to degree 3,
    /// otherwise 1536.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if a degree is 0 or above 7, or the tolerance is not positive
    /// and finite, or smaller than rounding allows; [`Error::NetTooSmall`] for fewer control points
    /// than degree + 1; [`Error::WrongKnotCount`]; [`Error::BadKnot`] with the first knot that is
    /// not finite, smaller than the previous one, repeated too often, or at the start of a span too
    /// short to be cut; [`Error::BadWeight`]; [`Error::ArrayTooShort`]; [`Error::TooLarge`] for
    /// control points and for cells; [`Error::NotFinite`] with the control point;
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn from_spline(spline: &Spline<'_>, options: &SplineOptions, job: &Job<'_>) -> Result<Self> {
        let [rows, columns] = spline.counts;
        for (axis, count) in spline.axes.iter().zip(spline.counts) {
            Error::require(
                (1..=MAX_DEGREE).contains(&axis.degree),
                "degree",
                axis.degree as f64,
                1.0..=MAX_DEGREE as f64,
            )?;
            if count <= axis.degree || (axis.closed && count < 3) {
                return Err(Error::NetTooSmall { rows: rows as u64, columns: columns as u64 });
            }
        }
        let count = (rows as u64).saturating_mul(columns as u64);
        Error::check_count("control points", count, MAX_NODES)?;
        first_finite_points(spline.points, count, "control points")?;
        let intervals = [spline.axes[0].nonempty_spans(rows, 0)?, spline.axes[1].nonempty_spans(columns, 1)?];
        if rational::has_different_weights(spline)? {
            return Ok(Sheet::High(rational::fit_patches(spline, intervals, options, job)?));
        }
        if spline.axes.iter().all(|axis| axis.degree <= 3) {
            Ok(Sheet::Cubic(exact_patches(spline, &intervals, job)?))
        } else {
            Ok(Sheet::High(exact_patches(spline, &intervals, job)?))
        }
    }
}

/// The pieces of a polynomial spline.
fn exact_patches<const N: usize>(
    spline: &Spline<'_>,
    intervals: &[Vec<SplineInterval>; 2],
    job: &Job<'_>,
) -> Result<Patches<N>> {
    let [p, q] = [0, 1].map(|k| spline.axes[k].degree);
    let [u, v] = spline.bezier_pieces_by_direction(intervals)?;
    let mut patches = alloc::with_capacity(u.len().saturating_mul(v.len()))?;
    for (i, rows) in u.iter().enumerate() {
        job.step(i as f64 / u.len() as f64, "making patches")?;
        for columns in v.iter() {
            let net = spline.piece_control_net(spline.points, rows, columns);
            let mut packed = [DVec3::ZERO; (MAX_DEGREE + 1) * (MAX_DEGREE + 1)];
            packed.chunks_exact_mut(q + 1).zip(&net).for_each(|(to, from)| to.copy_from_slice(&from[..=q]));
            patches.push(Patch::from_lower_degrees(&packed[..(p + 1) * (q + 1)], [p, q]));
        }
    }
    Ok(Patches::from_patches(patches, u.len(), v.len())
        .with_spline_origin(SplineOrigin { deviation: 0.0, knots: knots_at_cell_borders(intervals)? }))
}
