//! The paper's own approximations of a section. The simple one is the chord between two crossings
//! with lines of the surface. The one of higher order is the curve through the adjacent crossings
//! too.
//!
//! Cost: O(1) for each point.

use crate::{Paths, Surface};
use glam::DVec3;
use gusset_base::error::{Allowed, Error, Result};

/// The points inserted between the places where a curve crosses the lines of the surface.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum PointSpacing {
    /// Enough points of the surface to keep chords within 1e-4 of the diagonal of the surface's
    /// bounding box.
    #[default]
    Auto,
    /// Enough points of the surface to keep chords within this length.
    Chord(f64),
    /// No points: chords between crossings, as in the paper's first approximation, of second order.
    CellEdges,
    /// This number of points of the paper's approximation of higher order. They lie on the cubic
    /// through the crossings with four lines of the surface, two before and two behind,
    /// parametrised by chord length. The points are close to the surface, but not on it. They are
    /// of fourth order if crossings are evenly spaced, and less reliable if crossings cluster. Each
    /// has the place of the crossing before it.
    Leus(u32),
}

/// Largest number of points between two crossings.
pub(super) const MAX_POINTS_BETWEEN_CROSSINGS: u32 = 1000;

impl Surface<'_> {
    /// The chord tolerance; `None` if no points are inserted on the surface.
    pub(super) fn chord_tolerance(&self, spacing: PointSpacing) -> Result<Option<f64>> {
        match spacing {
            PointSpacing::Auto => Ok(Some(1e-4 * self.box_diagonal())),
            PointSpacing::CellEdges => Ok(None),
            PointSpacing::Leus(count) if count <= MAX_POINTS_BETWEEN_CROSSINGS => Ok(None),
            PointSpacing::Leus(count) => Err(Error::OptionOutOfRange {
                option: "points",
                value: count.into(),
                allowed: Allowed::AtMost(MAX_POINTS_BETWEEN_CROSSINGS.into()),
            }),
            PointSpacing::Chord(chord) if chord > 0.0 && chord.is_finite() => Ok(Some(chord.max(self.tolerance()))),
            PointSpacing::Chord(value) => {
                Err(Error::OptionOutOfRange { option: "chord", value, allowed: "finite and above 0".into() })
            }
        }
    }
}

/// Inserts the points of [`PointSpacing::Leus`] into paths that consist of crossings. With other
/// spacings, returns the paths unchanged.
pub(super) fn add_leus_points(given: Paths, spacing: PointSpacing) -> Result<Paths> {
    let count = match spacing {
        PointSpacing::Leus(count) if count > 0 => count as usize,
        _ => return Ok(given),
    };
    let total = (given.points.len() as u64).saturating_mul(count as u64 + 1);
    Error::check_count("points of curves", total, u32::MAX.into())?;
    let mut made = Paths { ends: vec![0], ..Paths::default() };
    for k in 0..given.len() {
        let (points, closed) = (given.points_of(k), given.closed[k]);
        made.reserve_points(points.len() * (count + 1))?;
        for (i, at) in given.point_range(k).enumerate() {
            let (place, normal) = (given.places[at], given.normals[at]);
            made.push_point(place, points[i], normal)?;
            if i + 1 == points.len() && !closed {
                break;
            }
            let next = given.normals[given.point_range(k).start + (i + 1) % points.len()];
            for step in 1..=count {
                let t = step as f64 / (count + 1) as f64;
                made.push_point(
                    place,
                    local_cubic_point(points, closed, i, t),
                    normal.lerp(next, t).normalize_or_zero(),
                )?;
            }
        }
        made.finish_current_path(closed, given.levels[k])?;
    }
    made.unresolved = given.unresolved;
    Ok(made)
}

/// The cubic through points i - 1 to i + 2, or fewer if they do not exist, parametrised by chord
/// length. Evaluated at fraction t of the way from point i to the next.
fn local_cubic_point(points: &[DVec3], closed: bool, i: usize, t: f64) -> DVec3 {
    let n = points.len();
    let (first, count) = if closed {
        if n >= 4 { (i + n - 1, 4) } else { (i, n) }
    } else {
        (i.saturating_sub(1).min(n.saturating_sub(4)), n.min(4))
    };
    let at = |k: usize| points[(first + k) % n];
    let mut knots = [0.0; 4];
    for k in 1..count {
        knots[k] = knots[k - 1] + at(k).distance(at(k - 1));
    }
    let own = if closed { usize::from(n >= 4) } else { i - first };
    let x = knots[own] + t * (knots[own + 1] - knots[own]);
    // Lagrange interpolation.
    let weight = |k: usize| -> f64 {
        (0..count).filter(|&other| other != k).map(|other| (x - knots[other]) / (knots[k] - knots[other])).product()
    };
    (0..count).map(|k| weight(k) * at(k)).sum()
}
