//! How plane the cells are: whether a surface can be clad with plane quads (paper, "facing of smooth surfaces by
//! quadrangular tiles").

use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::net::hidden::Hidden;
use crate::net::{Net, each, pieces};
use glam::DVec3;

/// How plane the cells are.
#[derive(Debug, Clone, PartialEq)]
pub struct Planarity {
    /// Of each cell: how far its corners are from the plane that lies evenly between them, divided by its longer
    /// diagonal. 0 for triangles and less; NaN for cells that are not there.
    pub cells: Vec<f64>,
    /// The largest, and its cell; `None` if there are no cells.
    pub worst: Option<(f64, u32)>,
    /// The mean; NaN if there are no cells.
    pub mean: f64,
    /// How many cells are above the tolerance.
    pub above: u64,
}

/// The corners of a quad are all equally far from the plane through their centre that has its area vector as normal:
/// two above it, two below. O(nodes), 8 bytes a cell.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a tolerance that is negative or NaN, [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn planarity(net: &Net<'_>, tolerance: f64, job: &Job<'_>) -> Result<Planarity> {
    if tolerance.is_nan() || tolerance < 0.0 {
        return Err(Error::OptionOutOfRange { option: "tolerance", value: tolerance });
    }
    let (shape, hidden) = (net.shape(), Hidden::of(net)?);
    let columns = shape.columns() - 1;
    let mut cells = alloc::filled(f64::NAN, shape.cell_count())?;
    pieces::rows(&mut cells, columns, (job, "planarity"), |i, row| {
        for j in hidden.runs(i).flatten() {
            let corners = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)];
            row[j] = each!(net.coordinates(), planes => off(corners.map(|(i, j)| planes.get(i, j))));
        }
    })?
    .for_each(drop);
    let there = || cells.iter().enumerate().filter(|(_, off)| !off.is_nan());
    let worst = there().fold(None, |worst: Option<(f64, u32)>, (cell, &off)| match worst {
        Some((most, _)) if most >= off => worst,
        _ => Some((off, cell as u32)),
    });
    let mean = there().map(|(_, off)| off).sum::<f64>() / there().count() as f64;
    let above = there().filter(|&(_, &off)| off > tolerance).count() as u64;
    Ok(Planarity { cells, worst, mean, above })
}

fn off([a, b, c, d]: [DVec3; 4]) -> f64 {
    let (p, q) = (c - a, d - b);
    let diagonal = p.length().max(q.length());
    if !diagonal.is_finite() {
        return f64::NAN;
    }
    // Without area, without a plane: the corners are in a line, or so crooked that no side is above.
    let normal = p.cross(q).normalize_or_zero();
    let distance = ((a - b) + (c - d)).dot(normal).abs() / 4.0;
    if diagonal > 0.0 { distance / diagonal } else { 0.0 }
}
