//! A Laplacian that is exact for quadratic functions on the tangent planes.
//!
//! That of cotangents is right in the mean, but at an irregular vertex it takes a part of any bend
//! for its own: from vertex to vertex it differs by as much on the finest triangles, and where its
//! gradient is to be least, a plate would rather not bend at all. Here the weights of each vertex
//! are those nearest to the cotangents' whose Laplacian is 0 for linear functions, 4 for the
//! squared distance and 0 for both saddles, as far as its neighbours allow.
//!
//! Source: T. Liszka, J. Orkisz, *The finite difference method at arbitrary irregular grids and its
//! application in applied mechanics* (1980), for differences exact for polynomials. Neighbours lie
//! in the tangent plane in their directions, as far away as they are.

use super::rings::{Rings, Rows};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::linear::cholesky;
use gusset_base::job::Job;

/// The conditions are met but for this part, so that few neighbours, or some in line, ask for no
/// huge weights.
const SLACK: f64 = 1e-3;
/// Vertices between two progress reports.
const REPORT_INTERVAL: usize = 1 << 12;
/// A ring is at least this part as wide as it is long, or counts as being so.
const MIN_WIDTH: f64 = 1e-3;
/// x, y, x^2 / 2, y^2 / 2, x y.
const CONDITIONS: usize = 5;

/// The rows and the columns of the Laplacian, for the neighbours of rings.
pub(super) struct Exact {
    rows: Vec<(u32, f64)>,
    columns: Vec<(u32, f64)>,
    middle: Vec<f64>,
}

impl Exact {
    /// O(T) for T triangles; extra memory: 32 bytes a neighbour.
    pub(super) fn new(points: &[DVec3], triangles: &[[u32; 3]], rings: &Rings, job: &Job<'_>) -> Result<Self> {
        let mut normals = alloc::filled(DVec3::ZERO, points.len())?;
        for &triangle in triangles {
            let [a, b, c] = triangle.map(|v| points[v as usize]);
            triangle.iter().for_each(|&v| normals[v as usize] += (b - a).cross(c - a));
        }
        let (mut rows, mut middle) = (Vec::new(), alloc::with_capacity(points.len())?);
        for v in 0..points.len() {
            job.step_every(REPORT_INTERVAL, v + 1, points.len(), "fairing")?;
            let first = rows.len();
            alloc::append(&mut rows, rings.ring(v))?;
            weigh(&mut rows[first..], normals[v].normalize_or_zero(), |w| points[w as usize] - points[v]);
            middle.push(-rows[first..].iter().map(|&(_, weight)| weight).sum::<f64>());
        }
        let mut columns = alloc::copied(&rows)?;
        let all = Rows::new(rings, &rows, &middle);
        let mut next = 0;
        for v in 0..points.len() {
            for &(w, _) in rings.ring(v) {
                columns[next].1 = all.entry(w as usize, v as u32);
                next += 1;
            }
        }
        Ok(Exact { rows, columns, middle })
    }

    pub(super) fn rows<'a>(&'a self, rings: &'a Rings) -> Rows<'a> {
        Rows::new(rings, &self.rows, &self.middle)
    }

    pub(super) fn columns<'a>(&'a self, rings: &'a Rings) -> Rows<'a> {
        Rows::new(rings, &self.columns, &self.middle)
    }
}

/// Makes of a ring's weights those of the Laplacian.
fn weigh(ring: &mut [(u32, f64)], normal: DVec3, leg: impl Fn(u32) -> DVec3) {
    let squared = |w: u32| leg(w).length_squared();
    let area = ring.iter().map(|&(w, weight)| weight * squared(w)).sum::<f64>() / 4.0;
    // Exact for the squared distance as it is.
    let scale = if area > 0.0 { 1.0 / area } else { 0.0 };
    ring.iter_mut().for_each(|(_, weight)| *weight *= scale);
    if normal == DVec3::ZERO {
        return;
    }
    let flat = |w: u32| leg(w).reject_from_normalized(normal).normalize_or_zero() * leg(w).length();
    let Some([x, y]) = axes(ring, normal, flat) else {
        return;
    };
    // Along its own axes, each in a unit of its own, a ring of needles is a round one.
    let conditions = |w: u32| {
        let (x, y) = (flat(w).dot(x.0) / x.1, flat(w).dot(y.0) / y.1);
        [x, y, x * x / 2.0, y * y / 2.0, x * y]
    };
    let unit = x.1 * x.1;
    let laplacians = [0.0, 0.0, 1.0, unit / (y.1 * y.1), 0.0];
    let mut lower = [[0.0; CONDITIONS]; CONDITIONS];
    let mut missing = laplacians.map(|laplacian| DVec3::new(laplacian, 0.0, 0.0));
    for &(w, weight) in &*ring {
        let values = conditions(w);
        for i in 0..CONDITIONS {
            missing[i].x -= values[i] * weight * unit;
            (0..=i).for_each(|j| lower[i][j] += values[i] * values[j]);
        }
    }
    (0..CONDITIONS).for_each(|i| lower[i][i] += SLACK);
    cholesky::solve(&mut lower, &mut missing);
    for (w, weight) in ring {
        let values = conditions(*w);
        let change: f64 = values.iter().zip(&missing).map(|(value, missing)| value * missing.x).sum();
        *weight += change / unit;
    }
}

/// The directions in which a ring is longest and shortest, and its root mean square there; `None` if
/// it has no size.
fn axes(ring: &[(u32, f64)], normal: DVec3, flat: impl Fn(u32) -> DVec3) -> Option<[(DVec3, f64); 2]> {
    let (x, y) = normal.any_orthonormal_pair();
    let mean = |u: DVec3, v: DVec3| {
        ring.iter().map(|&(w, _)| flat(w)).map(|leg| leg.dot(u) * leg.dot(v)).sum::<f64>() / ring.len().max(1) as f64
    };
    let (sin, cos) = libm::sincos(0.5 * libm::atan2(2.0 * mean(x, y), mean(x, x) - mean(y, y)));
    let (long, short) = (x * cos + y * sin, y * cos - x * sin);
    let [length, width] = [long, short].map(|axis| mean(axis, axis).sqrt());
    (length > 0.0).then(|| [(long, length), (short, width.max(MIN_WIDTH * length))])
}
