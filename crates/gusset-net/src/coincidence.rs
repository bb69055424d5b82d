//! Coincident nodes: equal coordinates (0 and -0 are equal), or a distance of at most the
//! tolerance.
//!
//! A missing node, with a coordinate that is NaN or infinite, coincides with none. Rows are
//! screened axis by axis before distances are computed. O(nodes).

use super::{Real, XyzMatrices};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Returns true if both nodes exist and coincide.
pub(super) fn are_coincident(a: DVec3, b: DVec3, tolerance: f64) -> bool {
    a.is_finite() && b.is_finite() && (a == b || (tolerance > 0.0 && (b - a).length() <= tolerance))
}

/// Calls `visit` with each link whose ends coincide, row by row. Closing links are included unless
/// they join neighbours. O(nodes).
pub(super) fn for_each_coincident_link<T: Real>(
    planes: &XyzMatrices<'_, T>,
    tolerance: f64,
    job: &Job<'_>,
    mut visit: impl FnMut(u32) -> Result<()>,
) -> Result<()> {
    let shape = planes.shape();
    let (h, w) = (shape.rows(), shape.columns());
    for i in 0..h {
        job.step_every(64, i, h, "coincidence")?;
        let row = planes.row(i);
        let node = |k: usize| DVec3::new(row[0][k].into(), row[1][k].into(), row[2][k].into());
        if may_any_nodes_coincide(row.map(|axis| &axis[..w - 1]), row.map(|axis| &axis[1..]), tolerance) {
            for j in (0..w - 1).filter(|&j| are_coincident(node(j), node(j + 1), tolerance)) {
                visit(shape.horizontal_link(i, j))?;
            }
        }
        if w > 2 && are_coincident(node(w - 1), node(0), tolerance) {
            visit(shape.horizontal_link(i, w - 1))?;
        }
        if i + 1 == h && h == 2 {
            break;
        }
        let below = planes.row((i + 1) % h);
        if may_any_nodes_coincide(row, below, tolerance) {
            let node_below = |k: usize| DVec3::new(below[0][k].into(), below[1][k].into(), below[2][k].into());
            for j in (0..w).filter(|&j| are_coincident(node(j), node_below(j), tolerance)) {
                visit(shape.vertical_link(i, j))?;
            }
        }
    }
    Ok(())
}

/// Returns false if no two corresponding nodes of `a` and `b` coincide. Branch-free, because it is
/// false for most rows.
fn may_any_nodes_coincide<T: Real>(a: [&[T]; 3], b: [&[T]; 3], tolerance: f64) -> bool {
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
