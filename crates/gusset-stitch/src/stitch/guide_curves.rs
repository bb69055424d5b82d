//! The surface that guides a blend across a wide gap: curves from rim to rim that leave each piece
//! along its own surface.
//!
//! A point of the strip divides a line from a point on rim A to a point on rim B. The guide replaces
//! the line by the cubic Hermite curve with the pieces' tangents at both ends. The tangent at a
//! rim vertex is the direction of the tube's axis, turned towards the tangent plane: fully where the
//! gap is as wide as the radius, and less the wider it is. If the tangents
//! of a curve with the chord c enclose the angle t, they get the length c / cos(t / 4)^2. The curve
//! is then almost a circular arc. Two ends of a bent tube get a bent tube in this way; straight
//! meridians would narrow to cos(t / 2) of the radius.

use super::stitch_rim::Rim;
use super::strip::{RimParents, Strip};
use glam::{DMat3, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;

/// A rim whose mean outward direction is shorter than this is not the end of a tube.
const MIN_TUBE_DIRECTION: f64 = 0.5;
/// The largest mean square of the sine between the axis of a tube and its faces at the rim.
const MAX_MEAN_SQUARED_SLANT: f64 = 0.05;
/// Steps of the inverse iteration for the axis of a rim.
const AXIS_ITERATIONS: u32 = 8;
/// The relative shift of that iteration, which keeps the matrix regular.
const AXIS_SHIFT: f64 = 1e-3;

/// The curves over a strip between two loops.
pub(super) struct GuideCurves {
    /// The rims' points, first of A, then of B.
    points: Vec<DVec3>,
    /// The unit tangent at each point, in the direction from A to B.
    tangents: Vec<DVec3>,
    /// The number of points of rim A.
    point_count_of_rim_a: u32,
}

impl GuideCurves {
    /// Creates the curves; `None` if a rim is not the end of a tube.
    pub(super) fn new(strip: &Strip) -> Result<Option<GuideCurves>> {
        let (Some(axis_a), Some(axis_b)) = (tube_axis(&strip.a), tube_axis(&strip.b)) else {
            return Ok(None);
        };
        // A flaring tube does not go on flaring across a wide gap.
        let flare = strip.gap_in_radii().max(1.0).recip();
        let tangents = |rim: &Rim, axis: DVec3| {
            let n = rim.points.len();
            let normals = (0..n).map(|k| (rim.normals[(k + n - 1) % n] + rim.normals[k]).normalize_or_zero());
            alloc::gather(normals.map(|normal| (axis - flare * axis.dot(normal) * normal).normalize_or(axis)))
        };
        let mut all = tangents(&strip.a, axis_a)?;
        alloc::append(&mut all, &tangents(&strip.b, -axis_b)?)?;
        let points = alloc::gather(strip.a.points.iter().chain(&strip.b.points).copied())?;
        Ok(Some(GuideCurves { points, tangents: all, point_count_of_rim_a: strip.a.points.len() as u32 }))
    }

    /// Returns the guide's point for a point of the strip.
    pub(super) fn point_at(&self, parents: &RimParents) -> DVec3 {
        // Weight, weighted point and weighted tangent on each rim.
        let mut ends = [(0.0, DVec3::ZERO, DVec3::ZERO); 2];
        for (&v, &weight) in parents.vertices.iter().zip(&parents.weights) {
            let (sum, point, tangent) = &mut ends[usize::from(v >= self.point_count_of_rim_a)];
            *sum += weight;
            *point += weight * self.points[v as usize];
            *tangent += weight * self.tangents[v as usize];
        }
        let [(wa, pa, ta), (wb, pb, tb)] = ends;
        if wa <= 0.0 || wb <= 0.0 {
            return pa + pb;
        }
        let (p, q, s, t) = (pa / wa, pb / wb, ta.normalize_or_zero(), tb.normalize_or_zero());
        let half_turn_cosine = ((1.0 + s.dot(t)) / 2.0).max(0.0).sqrt();
        let length = 2.0 * p.distance(q) / (1.0 + half_turn_cosine);
        let u = wb / (wa + wb);
        let v = 1.0 - u;
        v * v * (1.0 + 2.0 * u) * p + u * u * (1.0 + 2.0 * v) * q + length * u * v * (v * s - u * t)
    }
}

/// Returns the direction in which a tube leaves its piece at a rim: the unit vector most
/// perpendicular to the faces along the rim. `None` if the rim is not the end of a tube.
fn tube_axis(rim: &Rim) -> Option<DVec3> {
    let start = rim.outward;
    if !rim.closed || start.length() < MIN_TUBE_DIRECTION {
        return None;
    }
    let mut squares = DMat3::from_diagonal(DVec3::splat(AXIS_SHIFT * rim.normals.len() as f64));
    for &n in &rim.normals {
        squares += DMat3::from_cols(n * n.x, n * n.y, n * n.z);
    }
    let inverse = squares.inverse();
    let axis = (0..AXIS_ITERATIONS).fold(start, |axis, _| (inverse * axis).normalize_or_zero());
    let slants = rim.normals.iter().map(|normal| normal.dot(axis) * normal.dot(axis));
    let slant = slants.sum::<f64>() / rim.normals.len() as f64;
    (axis.dot(start) > 0.0 && axis.is_finite() && slant < MAX_MEAN_SQUARED_SLANT).then_some(axis)
}
