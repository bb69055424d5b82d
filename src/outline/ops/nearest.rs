//! The point of a curve that is nearest to a given one.
//!
//! On a segment it is an end or a root of (C(t) - q) . C'(t), a polynomial of degree 2 n - 1: for the quadratic a cubic with
//! a closed form. Segments whose boxes are farther than the best so far are passed over, so the result is the nearest point
//! of all.

use super::super::curve::{CurveView, MAX_DEGREE, Place, check_finite};
use super::super::segment;
use super::bernstein::{ROOM, add_product};
use super::cubic;
use super::frame::Frame;
use super::roots::roots;
use super::tree::{Aabb, Tree};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::par;
use glam::DVec3;

/// The nearest point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Where on the curve; of several at the same distance, one.
    pub place: Place,
    /// The point there.
    pub point: DVec3,
    /// Its distance.
    pub distance: f64,
}

/// A query farther away than this, in sizes of the curve, is drawn near along its direction: the nearest point does not tell.
const FAR: f64 = (1u64 << 26) as f64;

/// Queries that one thread takes at once.
const BATCH: usize = 256;

const STAGE: &str = "nearest points";

impl CurveView<'_> {
    /// The nearest point of the curve to each of `queries`. About O(log segments + degree^2) for each query, on the job's
    /// threads; memory O(points).
    ///
    /// # Errors [`Error::EmptyCurve`] (no segments), [`Error::OutlineNotFinite`] (a query), [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn nearest(&self, queries: &[DVec3], job: &Job<'_>) -> Result<Vec<Nearest>> {
        if self.is_empty() {
            return Err(Error::EmptyCurve);
        }
        let found = nearest_of_any(&[*self], queries, job)?;
        alloc::collect(found.into_iter().map(|(_, nearest)| nearest))
    }
}

/// The nearest point of any of some curves to each of `queries`, and the curve that it is on; a curve without segments is its
/// point. As [`CurveView::nearest`] for one curve after the other, but with one search for each query.
///
/// # Errors [`Error::EmptyCurve`] (no curve has a point), [`Error::OutlineNotFinite`] (a query), [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub(crate) fn nearest_of_any(
    curves: &[CurveView<'_>],
    queries: &[DVec3],
    job: &Job<'_>,
) -> Result<Vec<(usize, Nearest)>> {
    job.step(0.0, STAGE)?;
    if curves.iter().all(|curve| curve.points().is_empty()) {
        return Err(Error::EmptyCurve);
    }
    queries.iter().enumerate().try_for_each(|(point, &q)| check_finite(point, q))?;
    let finder = Finder::new(curves, &job.part(0.0, 0.1))?;
    let job = job.part(0.1, 1.0);
    let mut found = alloc::with_capacity(queries.len())?;
    let batches = par::heard(&job, STAGE, queries.chunks(BATCH), |batch| {
        alloc::collect(batch.iter().map(|&q| {
            let (curve, place) = finder.nearest(finder.near(q));
            let point = match curves[curve].is_empty() {
                true => curves[curve].points()[0],
                false => segment::point(curves[curve].segment(place.segment as usize), place.t),
            };
            (curve, Nearest { place, point, distance: distance(point, q) })
        }))
    })?;
    for batch in batches {
        found.extend(batch?);
    }
    Ok(found)
}

/// The distance of two points; it overflows only if it is too large itself.
fn distance(p: DVec3, q: DVec3) -> f64 {
    let halved = p * 0.5 - q * 0.5;
    let largest = halved.abs().max_element();
    if largest == 0.0 { 0.0 } else { (halved / largest).length() * largest * 2.0 }
}

/// Curves in their frame, with the tree of the segments of all of them.
struct Finder {
    frame: Frame,
    /// Where queries are far from.
    origin: DVec3,
    points: Vec<DVec3>,
    /// Of each segment: its first control point and its last one, the curve, and its number there.
    segments: Vec<([u32; 2], u32, u32)>,
    tree: Tree,
}

impl Finder {
    fn new(curves: &[CurveView<'_>], job: &Job<'_>) -> Result<Self> {
        let frame = Frame::of(curves.iter().flat_map(CurveView::points));
        let (count, limit) = (curves.iter().map(|curve| curve.points().len()).sum(), u64::from(u32::MAX));
        if count as u64 > limit {
            return Err(Error::TooLarge { what: "control points", count: count as u64, limit });
        }
        let mut points = alloc::with_capacity(count)?;
        let mut segments = alloc::with_capacity(curves.iter().map(|curve| curve.len().max(1)).sum())?;
        for (c, curve) in curves.iter().enumerate().filter(|(_, curve)| !curve.points().is_empty()) {
            let first = points.len() as u32;
            points.extend(curve.points().iter().map(|&p| frame.point(p)));
            match curve.ends() {
                // A point.
                [] | [_] => segments.push(([first; 2], c as u32, 0)),
                ends => segments.extend(
                    ends.windows(2).zip(0..).map(|(pair, k)| ([first + pair[0], first + pair[1]], c as u32, k)),
                ),
            }
        }
        job.step(0.5, STAGE)?;
        let boxes = segments.iter().map(|(ends, ..)| Aabb::of(controls(&points, *ends)));
        let tree = Tree::new(boxes)?;
        let origin = curves.iter().find_map(|curve| curve.points().first()).copied().unwrap_or_default();
        Ok(Finder { frame, origin, points, segments, tree })
    }

    /// A query in the frame.
    fn near(&self, q: DVec3) -> DVec3 {
        let local = self.frame.point(q);
        if local.abs().max_element() <= FAR {
            return local;
        }
        let away = q * 0.5 - self.origin * 0.5;
        away / away.abs().max_element() * FAR
    }

    /// The place nearest to a point of the frame, and the curve that it is on.
    fn nearest(&self, q: DVec3) -> (usize, Place) {
        let (_, curve, segment) = self.segments[0];
        let mut best = (self.points[0].distance_squared(q), curve, Place { segment, t: 0.0 });
        self.tree.nearest(q, best.0, &mut |k| {
            let (ends, curve, segment) = self.segments[k];
            let (t, distance) = nearest_on(controls(&self.points, ends), q);
            if distance < best.0 {
                best = (distance, curve, Place { segment, t });
            }
            best.0
        });
        (best.1 as usize, best.2)
    }
}

/// The control points of a segment.
fn controls(points: &[DVec3], [first, last]: [u32; 2]) -> &[DVec3] {
    &points[first as usize..=last as usize]
}

/// The parameter of the nearest point of one segment, and the square of its distance.
pub(super) fn nearest_on(controls: &[DVec3], q: DVec3) -> (f64, f64) {
    let last = controls.len() - 1;
    let mut best = (0.0, controls[0].distance_squared(q));
    let mut offer = |t: f64| {
        let distance = segment::point(controls, t).distance_squared(q);
        if distance < best.1 {
            best = (t, distance);
        }
    };
    offer(1.0);
    match *controls {
        [_] => {}
        [a, b] => {
            let along = b - a;
            let t = (q - a).dot(along) / along.length_squared();
            if t > 0.0 && t < 1.0 {
                offer(t);
            }
        }
        [a, b, c] => {
            // C - q = w t^2 + 2 u t + r: half of its product with its derivative is this cubic.
            let (r, u, w) = (a - q, b - a, (c - b) - (b - a));
            let cubic = cubic::real_roots(w.dot(w), 3.0 * u.dot(w), 2.0 * u.dot(u) + r.dot(w), r.dot(u));
            match cubic {
                Some((found, count)) => {
                    found[..count].iter().filter(|t| (0.0..=1.0).contains(*t)).for_each(|&t| offer(t));
                }
                None => feet(controls, q, last, &mut offer),
            }
        }
        _ => feet(controls, q, last, &mut offer),
    }
    best
}

/// Offers the roots of (C - q) . C'.
fn feet(controls: &[DVec3], q: DVec3, degree: usize, offer: &mut impl FnMut(f64)) {
    let mut product = [0.0; ROOM];
    let product = &mut product[..2 * degree];
    for axis in 0..3 {
        let (mut place, mut step) = ([0.0; MAX_DEGREE + 1], [0.0; MAX_DEGREE]);
        for (i, p) in controls.iter().enumerate() {
            place[i] = p[axis] - q[axis];
        }
        for i in 0..degree {
            step[i] = controls[i + 1][axis] - controls[i][axis];
        }
        add_product(&place[..=degree], &step[..degree], 1.0, product);
    }
    let largest = product.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    // Multiple roots are no minima that matter: a little below the noise is as good.
    for &t in roots(product, 4.0 * f64::EPSILON * largest).as_slice() {
        offer(t);
    }
}
