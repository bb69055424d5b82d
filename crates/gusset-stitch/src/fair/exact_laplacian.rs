//! A Laplacian that is exact for quadratic functions on the tangent planes.
//!
//! The cotangent Laplacian is right on average. At an irregular vertex it has an error proportional
//! to the bend, which does not vanish on finer triangles. If its gradient is minimised, this error
//! makes the plate too flat. Here the Laplacian of each vertex is 0 for linear functions, 4 for the
//! squared distance and 0 for both saddles, as far as the neighbours allow. Its weights are the
//! nearest ones to the cotangents.
//!
//! Source: T. Liszka, J. Orkisz, *The finite difference method at arbitrary irregular grids and its
//! application in applied mechanics* (1980), for differences that are exact for polynomials.
//! Neighbours are placed in the tangent plane, in their directions and at their distances.

use super::one_rings::{MatrixRows, OneRings};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::linear::cholesky;
use gusset_base::job::Job;

/// Slack of the conditions, which limits the weights if neighbours are few or collinear.
const CONDITION_SLACK: f64 = 1e-3;
/// Number of vertices between two progress reports.
const VERTICES_PER_REPORT: usize = 1 << 12;
/// Rings with a smaller ratio of width to length are treated as this wide.
const MIN_ASSUMED_RING_WIDTH_RATIO: f64 = 1e-3;
/// The functions x, y, x^2 / 2, y^2 / 2, x y.
const CONDITIONS_PER_VERTEX: usize = 5;

/// The rows and the columns of the Laplacian, for the neighbours of rings.
pub(super) struct ExactLaplacian {
    rows: Vec<(u32, f64)>,
    columns: Vec<(u32, f64)>,
    diagonal: Vec<f64>,
}

impl ExactLaplacian {
    /// Computes the weights. O(T) for T triangles; extra memory: 32 bytes per neighbour.
    pub(super) fn new(points: &[DVec3], triangles: &[[u32; 3]], rings: &OneRings, job: &Job<'_>) -> Result<Self> {
        let mut normals = alloc::filled(DVec3::ZERO, points.len())?;
        for &triangle in triangles {
            let [a, b, c] = triangle.map(|v| points[v as usize]);
            triangle.iter().for_each(|&v| normals[v as usize] += (b - a).cross(c - a));
        }
        let (mut rows, mut middle) = (Vec::new(), alloc::with_capacity(points.len())?);
        for v in 0..points.len() {
            job.step_every(VERTICES_PER_REPORT, v + 1, points.len(), "fairing")?;
            let first = rows.len();
            alloc::append(&mut rows, rings.ring(v))?;
            set_exact_weights(&mut rows[first..], normals[v].normalize_or_zero(), |w| points[w as usize] - points[v]);
            middle.push(-rows[first..].iter().map(|&(_, weight)| weight).sum::<f64>());
        }
        let mut columns = alloc::copied(&rows)?;
        let all = MatrixRows::new(rings, &rows, &middle);
        let mut next = 0;
        for v in 0..points.len() {
            for &(w, _) in rings.ring(v) {
                columns[next].1 = all.row_entry(w as usize, v as u32);
                next += 1;
            }
        }
        Ok(ExactLaplacian { rows, columns, diagonal: middle })
    }

    pub(super) fn matrix_rows<'a>(&'a self, rings: &'a OneRings) -> MatrixRows<'a> {
        MatrixRows::new(rings, &self.rows, &self.diagonal)
    }

    pub(super) fn matrix_columns<'a>(&'a self, rings: &'a OneRings) -> MatrixRows<'a> {
        MatrixRows::new(rings, &self.columns, &self.diagonal)
    }
}

/// Replaces the cotangent weights of a ring by weights of the exact Laplacian.
fn set_exact_weights(ring: &mut [(u32, f64)], normal: DVec3, leg: impl Fn(u32) -> DVec3) {
    let squared = |w: u32| leg(w).length_squared();
    let area = ring.iter().map(|&(w, weight)| weight * squared(w)).sum::<f64>() / 4.0;
    // Scale the weights to be exact for the squared distance.
    let scale = if area > 0.0 { 1.0 / area } else { 0.0 };
    ring.iter_mut().for_each(|(_, weight)| *weight *= scale);
    if normal == DVec3::ZERO {
        return;
    }
    let flat = |w: u32| leg(w).reject_from_normalized(normal).normalize_or_zero() * leg(w).length();
    let Some([x, y]) = extents_of_ring(ring, normal, flat) else {
        return;
    };
    // Along its principal axes, each in its own unit, a ring of needles becomes round.
    let conditions = |w: u32| {
        let (x, y) = (flat(w).dot(x.0) / x.1, flat(w).dot(y.0) / y.1);
        [x, y, x * x / 2.0, y * y / 2.0, x * y]
    };
    let unit = x.1 * x.1;
    let laplacians = [0.0, 0.0, 1.0, unit / (y.1 * y.1), 0.0];
    let mut lower = [[0.0; CONDITIONS_PER_VERTEX]; CONDITIONS_PER_VERTEX];
    let mut missing = laplacians.map(|laplacian| DVec3::new(laplacian, 0.0, 0.0));
    for &(w, weight) in &*ring {
        let values = conditions(w);
        for i in 0..CONDITIONS_PER_VERTEX {
            missing[i].x -= values[i] * weight * unit;
            (0..=i).for_each(|j| lower[i][j] += values[i] * values[j]);
        }
    }
    (0..CONDITIONS_PER_VERTEX).for_each(|i| lower[i][i] += CONDITION_SLACK);
    cholesky::solve(&mut lower, &mut missing);
    for (w, weight) in ring {
        let values = conditions(*w);
        let change: f64 = values.iter().zip(&missing).map(|(value, missing)| value * missing.x).sum();
        *weight += change / unit;
    }
}

/// Returns the directions in which a ring is longest and shortest, with its root mean square
/// extent; `None` for a ring of size 0.
fn extents_of_ring(ring: &[(u32, f64)], normal: DVec3, flat: impl Fn(u32) -> DVec3) -> Option<[(DVec3, f64); 2]> {
    let (x, y) = normal.any_orthonormal_pair();
    let mean = |u: DVec3, v: DVec3| {
        ring.iter().map(|&(w, _)| flat(w)).map(|leg| leg.dot(u) * leg.dot(v)).sum::<f64>() / ring.len().max(1) as f64
    };
    let (sin, cos) = libm::sincos(0.5 * libm::atan2(2.0 * mean(x, y), mean(x, x) - mean(y, y)));
    let (long, short) = (x * cos + y * sin, y * cos - x * sin);
    let [length, width] = [long, short].map(|axis| mean(axis, axis).sqrt());
    (length > 0.0).then(|| [(long, length), (short, width.max(MIN_ASSUMED_RING_WIDTH_RATIO * length))])
}
