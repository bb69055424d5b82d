//! Which nodes lie on each other.
//!
//! Two nodes coincide if their coordinates are equal (0 and -0 are), or their distance is at most the tolerance. A node
//! that is missing, with a coordinate that is NaN or infinite, coincides with none.

use super::{Coordinates, Planes, Real, each};
use crate::error::{Error, Result};
use crate::job::Job;
use glam::DVec3;

/// [`Error::OptionOutOfRange`] for a tolerance that is no finite number from 0 on.
pub(super) fn check_tolerance(tolerance: f64) -> Result<()> {
    let good = tolerance.is_finite() && tolerance >= 0.0;
    if good { Ok(()) } else { Err(Error::OptionOutOfRange { option: "tolerance", value: tolerance }) }
}

/// True if both are there and lie on each other.
pub(super) fn coincide(a: DVec3, b: DVec3, tolerance: f64) -> bool {
    a.is_finite() && b.is_finite() && (a == b || (tolerance > 0.0 && (b - a).length() <= tolerance))
}

/// Gives each link whose ends coincide to `visit`: those of each row in order, and those that lead back, unless they
/// join neighbours. O(nodes).
pub(super) fn links(
    coordinates: &Coordinates<'_>,
    tolerance: f64,
    job: &Job<'_>,
    visit: impl FnMut(u32) -> Result<()>,
) -> Result<()> {
    each!(coordinates, planes => links_of(planes, tolerance, job, visit))
}

fn links_of<T: Real>(
    planes: &Planes<'_, T>,
    tolerance: f64,
    job: &Job<'_>,
    mut visit: impl FnMut(u32) -> Result<()>,
) -> Result<()> {
    let shape = planes.shape();
    let (h, w) = (shape.rows(), shape.columns());
    for i in 0..h {
        if i % 64 == 0 {
            job.step(i as f64 / h as f64, "coincidence")?;
        }
        let row = planes.row(i);
        let places = |k: usize| DVec3::new(row[0][k].into(), row[1][k].into(), row[2][k].into());
        if any_close(row.map(|axis| &axis[..w - 1]), row.map(|axis| &axis[1..]), tolerance) {
            for j in (0..w - 1).filter(|&j| coincide(places(j), places(j + 1), tolerance)) {
                visit(2 * shape.node(i, j))?;
            }
        }
        if w > 2 && coincide(places(w - 1), places(0), tolerance) {
            visit(2 * shape.node(i, w - 1))?;
        }
        if i + 1 == h && h == 2 {
            break;
        }
        let below = planes.row((i + 1) % h);
        if any_close(row, below, tolerance) {
            let place_below = |k: usize| DVec3::new(below[0][k].into(), below[1][k].into(), below[2][k].into());
            for j in (0..w).filter(|&j| coincide(places(j), place_below(j), tolerance)) {
                visit(2 * shape.node(i, j) + 1)?;
            }
        }
    }
    Ok(())
}

/// False if no two nodes of the same place in `a` and `b` coincide: a loop without branches, as that is so for most
/// rows.
fn any_close<T: Real>(a: [&[T]; 3], b: [&[T]; 3], tolerance: f64) -> bool {
    let close = |a: T, b: T| {
        let difference: f64 = a.into() - b.into();
        (difference <= tolerance) & (difference >= -tolerance)
    };
    let [ax, ay, az] = a;
    let [bx, by, bz] = b;
    let pairs = ax.iter().zip(bx).zip(ay.iter().zip(by)).zip(az.iter().zip(bz));
    pairs.fold(0u32, |any, (((&ax, &bx), (&ay, &by)), (&az, &bz))| {
        any | u32::from(close(ax, bx) & close(ay, by) & close(az, bz))
    }) != 0
}
