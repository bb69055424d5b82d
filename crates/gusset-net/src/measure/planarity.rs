//! Planarity of the cells: whether a surface can be clad with planar quads (Deryagin, "Facing of
//! smooth surfaces by quadrangular tiles"). O(nodes).

use crate::hidden_cells::HiddenCells;
use crate::{Net, chunks, each};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;

/// The planarity of the cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Planarity {
    /// The distance of each cell's corners from its mean plane, divided by its longer diagonal. 0
    /// for triangles and less; NaN for missing cells.
    pub cells: Vec<f64>,
    /// The largest value and its cell; `None` without cells.
    pub worst: Option<(f64, u32)>,
    /// The mean; NaN without cells.
    pub mean: f64,
    /// The number of cells above the tolerance.
    pub above: u64,
}

/// Measures each cell against its mean plane, which passes through the mean of its corners and is
/// perpendicular to its area vector. Two corners lie above the plane and two below, all at the same
/// distance. O(nodes), 8 bytes a cell.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a tolerance that is negative or NaN, [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub fn planarity(net: &Net<'_>, tolerance: f64, job: &Job<'_>) -> Result<Planarity> {
    Error::require(tolerance >= 0.0, "tolerance", tolerance, "at least 0")?;
    let (shape, hidden) = (net.shape(), HiddenCells::new(net)?);
    let columns = shape.columns() - 1;
    let mut cells = alloc::filled(f64::NAN, shape.cell_count())?;
    chunks::map_rows(&mut cells, columns, (job, "planarity"), |i, row| {
        for j in hidden.visible_runs(i).flatten() {
            row[j] = each!(net.coordinates(), planes => relative_plane_distance(planes.cell_corners(i, j)));
        }
    })?
    .for_each(drop);
    let existing = || cells.iter().enumerate().filter(|(_, value)| !value.is_nan());
    let worst = existing().reduce(|worst, next| if next.1 > worst.1 { next } else { worst });
    let worst = worst.map(|(cell, &value)| (value, cell as u32));
    let mean = existing().map(|(_, value)| value).sum::<f64>() / existing().count() as f64;
    let above = existing().filter(|&(_, &value)| value > tolerance).count() as u64;
    Ok(Planarity { cells, worst, mean, above })
}

/// Returns the distance of the corners from their mean plane over the longer diagonal.
fn relative_plane_distance([a, b, c, d]: [DVec3; 4]) -> f64 {
    let (p, q) = (c - a, d - b);
    // A unit in which products of any lengths stay in range.
    let unit = common_unit([&p, &q]);
    let (p, q) = (p / unit, q / unit);
    let diagonal = p.length().max(q.length());
    if !diagonal.is_finite() {
        return f64::NAN;
    }
    // If the area is 0, the mean plane is undefined: the corners are collinear, or twisted by a
    // right angle.
    let normal = p.cross(q).normalize_or_zero();
    let distance = (((a - b) + (c - d)) / unit).dot(normal).abs() / 4.0;
    if diagonal > 0.0 { distance / diagonal } else { 0.0 }
}
