//! The nearest point of a curve.
//!
//! On a segment, the nearest point is an end or a root of (C(t) - q) . C'(t), a polynomial of
//! degree 2 n - 1. For a quadratic, that is a cubic with a closed form. Near a singular point C'
//! vanishes too, and rounding blurs the root to an interval; there the distance itself is
//! minimised. Segments whose boxes are farther than the best distance so far are skipped, so the
//! result is the global minimum.

use super::cubic_roots;
use crate::curve::segment::{self, SquaredDistanceSlope};
use crate::curve::unit_frame::UnitFrame;
use crate::curve::{CurveView, Place, check_finite};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::{Aabb, box_tree::BoxTree};
use gusset_base::job::Job;
use gusset_base::par;

/// The nearest point of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearestCurvePoint {
    /// The place on the curve; any one of several at equal distance.
    pub place: Place,
    /// The point there.
    pub point: DVec3,
    /// The distance to the query.
    pub distance: f64,
}

/// More distant queries are moved to this distance along their direction, in sizes of the curve.
/// The nearest point stays the same up to rounding.
const MAX_QUERY_DISTANCE: f64 = (1u64 << 26) as f64;

/// Queries that one thread processes at once.
const QUERIES_PER_BATCH: usize = 256;
/// The number of segment tests in a batch, if every query has to test each segment.
const SEGMENTS_PER_BATCH: usize = 1 << 17;
/// Segments tested between two progress reports.
const SEGMENTS_PER_REPORT: usize = 1 << 12;

/// A bound of the rounding error of boxes in a frame of size 1.
const MAX_BOX_ROUNDING: f64 = 1e-14;
/// A bound of the relative rounding error of distances.
const MAX_RELATIVE_DISTANCE_ROUNDING: f64 = 1e-9;
/// The largest coordinate of a query, in sizes of all curves, whose square does not overflow.
const MAX_QUERY_COORDINATE: f64 = 1e150;

const PROGRESS_STAGE: &str = "nearest points";

impl CurveView<'_> {
    /// Finds the nearest point of the curve to each of `queries`, on the job's threads. About O(log
    /// segments + degree^2) for each query; memory O(points).
    ///
    /// # Errors
    /// [`Error::EmptyCurve`] (the curve lacks segments), [`Error::NotFinite`] (a query),
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn nearest_to_each_query(&self, queries: &[DVec3], job: &Job<'_>) -> Result<Vec<NearestCurvePoint>> {
        job.step(0.0, PROGRESS_STAGE)?;
        if self.is_empty() {
            return Err(Error::EmptyCurve);
        }
        let search = CurveSearch::new(self)?;
        answer_queries_in_batches(queries, self.len(), job, |q, job| search.nearest(q, job))
    }
}

/// Finds the nearest point among several curves to each of `queries`, with the index of its curve.
/// Ties go to the first curve. A curve without segments is a point. Curves whose boxes are too far
/// are skipped.
///
/// # Errors
/// [`Error::EmptyCurve`] (all curves lack points, and there are queries), [`Error::NotFinite`] (a
/// query), [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn nearest_of_any(
    curves: &[CurveView<'_>],
    queries: &[DVec3],
    job: &Job<'_>,
) -> Result<Vec<(usize, NearestCurvePoint)>> {
    job.step(0.0, PROGRESS_STAGE)?;
    if queries.is_empty() {
        return Ok(Vec::new());
    }
    if curves.iter().all(|curve| curve.points().is_empty()) {
        return Err(Error::EmptyCurve);
    }
    let set = CurveSetSearch::new(curves, &job.sub_job(0.0, 0.1))?;
    let segments = curves.iter().map(CurveView::len).sum();
    answer_queries_in_batches(queries, segments, &job.sub_job(0.1, 1.0), |q, job| set.nearest(q, job))
}

fn answer_queries_in_batches<A: Send>(
    queries: &[DVec3],
    segments: usize,
    job: &Job<'_>,
    answer: impl Fn(DVec3, &Job<'_>) -> Result<A> + Sync,
) -> Result<Vec<A>> {
    let at_once = (SEGMENTS_PER_BATCH / segments.max(1)).clamp(1, QUERIES_PER_BATCH);
    queries.iter().enumerate().try_for_each(|(point, &q)| check_finite(point, q))?;
    let mut found = alloc::with_capacity(queries.len())?;
    for some in queries.chunks(QUERIES_PER_BATCH * 64) {
        let (done, count) = (found.len() as f64, queries.len() as f64);
        let part = job.sub_job(done / count, (done + some.len() as f64) / count);
        let batches = par::map_jobs(&part, PROGRESS_STAGE, some.chunks(at_once), |batch, job| {
            alloc::try_collect::<_, Error>(batch.iter().map(|&q| answer(q, job)))
        })?;
        batches.into_iter().for_each(|batch| found.extend(batch));
    }
    Ok(found)
}

/// Returns the distance of two points; it overflows only if the distance itself does.
fn overflow_safe_distance(p: DVec3, q: DVec3) -> f64 {
    let halved = p * 0.5 - q * 0.5;
    let largest = halved.abs().max_element();
    if largest == 0.0 { 0.0 } else { (halved / largest).length() * largest * 2.0 }
}

/// A curve in its unit frame, with a tree of its segments.
pub struct CurveSearch<'a> {
    curve: CurveView<'a>,
    frame: UnitFrame,
    points: Vec<DVec3>,
    tree: BoxTree,
}

impl<'a> CurveSearch<'a> {
    /// Builds the tree of a curve.
    pub fn new(curve: &CurveView<'a>) -> Result<Self> {
        let frame = UnitFrame::from_points(curve.points());
        let points = frame.points_to_frame(curve.points())?;
        let boxes = CurveView::new_unchecked(&points, curve.ends(), false);
        let tree = BoxTree::new(boxes.segments().map(Aabb::from_points))?;
        Ok(CurveSearch { curve: *curve, frame, points, tree })
    }

    /// Finds the nearest point. The curve must have a point.
    pub fn nearest(&self, q: DVec3, job: &Job<'_>) -> Result<NearestCurvePoint> {
        if self.curve.is_empty() {
            let point = self.curve.points()[0];
            return Ok(NearestCurvePoint { place: Place::START, point, distance: overflow_safe_distance(point, q) });
        }
        let place = self.nearest_place(self.query_to_frame(q), job)?;
        let point = segment::point_at(self.curve.segment(place.segment as usize), place.t);
        Ok(NearestCurvePoint { place, point, distance: overflow_safe_distance(point, q) })
    }

    fn query_to_frame(&self, q: DVec3) -> DVec3 {
        let local = self.frame.point_to_frame(q);
        if local.abs().max_element() <= MAX_QUERY_DISTANCE {
            return local;
        }
        let away = q * 0.5 - self.curve.points()[0] * 0.5;
        away / away.abs().max_element() * MAX_QUERY_DISTANCE
    }

    /// Returns the place nearest to a point of the frame.
    fn nearest_place(&self, q: DVec3, job: &Job<'_>) -> Result<Place> {
        let local = CurveView::new_unchecked(&self.points, self.curve.ends(), false);
        let mut best = (Place::START, local.segment(0)[0].distance_squared(q));
        let (mut looked, mut heard) = (0_usize, Ok(()));
        self.tree.visit_nearest(q, best.1, &mut |k| {
            looked += 1;
            if looked.is_multiple_of(SEGMENTS_PER_REPORT) {
                heard = job.step(0.0, PROGRESS_STAGE);
                if heard.is_err() {
                    // A distance of 0 cannot be improved, so the search ends.
                    return 0.0;
                }
            }
            let (t, distance) = nearest_on_segment(local.segment(k), q);
            if distance < best.1 {
                best = (Place { segment: k as u32, t }, distance);
            }
            best.1
        });
        heard.map(|()| best.0)
    }
}

/// Curves with points, and a tree of their boxes in a common frame. Each curve answers in its own
/// frame, because the common frame is coarse for small curves far from the others.
struct CurveSetSearch<'a> {
    /// The curves and their indices.
    searches: Vec<(usize, CurveSearch<'a>)>,
    frame: UnitFrame,
    tree: BoxTree,
}

impl<'a> CurveSetSearch<'a> {
    fn new(curves: &[CurveView<'a>], job: &Job<'_>) -> Result<Self> {
        let total: usize = curves.iter().map(|curve| curve.points().len()).sum();
        let (mut searches, mut done) = (alloc::with_capacity(curves.len())?, 0);
        for (c, curve) in curves.iter().enumerate().filter(|(_, curve)| !curve.points().is_empty()) {
            job.step(done as f64 / total as f64, PROGRESS_STAGE)?;
            done += curve.points().len();
            searches.push((c, CurveSearch::new(curve)?));
        }
        let frame = UnitFrame::from_points(curves.iter().flat_map(CurveView::points));
        let around = |curve: &CurveView<'_>| {
            let Aabb { low, high } = Aabb::from_points(curve.points());
            Aabb {
                low: frame.point_to_frame(low) - MAX_BOX_ROUNDING,
                high: frame.point_to_frame(high) + MAX_BOX_ROUNDING,
            }
        };
        let tree = BoxTree::new(searches.iter().map(|(_, search)| around(&search.curve)))?;
        Ok(CurveSetSearch { searches, frame, tree })
    }

    fn nearest(&self, q: DVec3, job: &Job<'_>) -> Result<(usize, NearestCurvePoint)> {
        // For queries so distant that squares overflow, the boxes are useless and every curve is
        // searched.
        let local =
            self.frame.point_to_frame(q).clamp(DVec3::splat(-MAX_QUERY_COORDINATE), DVec3::splat(MAX_QUERY_COORDINATE));
        let (mut best, mut heard) = (None::<(usize, NearestCurvePoint)>, Ok(()));
        self.tree.visit_nearest(local, f64::INFINITY, &mut |k| {
            let (curve, search) = &self.searches[k];
            let found = match search.nearest(q, job) {
                Ok(found) => found,
                Err(error) => {
                    heard = Err(error);
                    return 0.0;
                }
            };
            let nearer = |&(c, nearest): &(usize, NearestCurvePoint)| (found.distance, *curve) < (nearest.distance, c);
            if best.as_ref().is_none_or(nearer) {
                best = Some((*curve, found));
            }
            let bound = best.map_or(f64::INFINITY, |(_, nearest)| {
                self.frame.length_to_frame(nearest.distance) * (1.0 + MAX_RELATIVE_DISTANCE_ROUNDING)
            });
            bound * bound + f64::MIN_POSITIVE
        });
        heard?;
        // Not reached: the tree has a leaf that no bound excludes.
        best.map_or_else(|| Ok((self.searches[0].0, self.searches[0].1.nearest(q, job)?)), Ok)
    }
}

/// Returns the parameter of the nearest point of one segment, and its squared distance.
pub(super) fn nearest_on_segment(controls: &[DVec3], q: DVec3) -> (f64, f64) {
    let mut best = NearestOnSegment { controls, q, parameter: 0.0, squared_distance: controls[0].distance_squared(q) };
    best.improve_with_parameter(1.0);
    best.improve_with_stationary_parameters();
    (best.parameter, best.squared_distance)
}

/// The number of samples of an interval in which the slope of the distance is rounding. The
/// smallest sample and its neighbours bracket a minimum.
const SAMPLES_PER_FLAT_INTERVAL: usize = 32;
/// The relative gain in squared distance for which a place of such an interval replaces another.
const MIN_RELATIVE_SQUARED_DISTANCE_GAIN: f64 = 1e-12;

/// The best point of a segment so far.
struct NearestOnSegment<'a> {
    controls: &'a [DVec3],
    q: DVec3,
    parameter: f64,
    squared_distance: f64,
}

impl NearestOnSegment<'_> {
    fn squared_distance(&self, t: f64) -> f64 {
        segment::point_at(self.controls, t).distance_squared(self.q)
    }

    fn improve_with_parameter(&mut self, t: f64) {
        let squared = self.squared_distance(t);
        if squared < self.squared_distance {
            (self.parameter, self.squared_distance) = (t, squared);
        }
    }

    /// Tests the inner places where the distance is stationary.
    fn improve_with_stationary_parameters(&mut self) {
        match *self.controls {
            [a, b] => {
                let along = b - a;
                let t = (self.q - a).dot(along) / along.length_squared();
                if t > 0.0 && t < 1.0 {
                    self.improve_with_parameter(t);
                }
                return;
            }
            [a, b, c] => {
                // C - q = w t^2 + 2 u t + r, and half of its product with its derivative is this
                // cubic.
                let (r, u, w) = (a - self.q, b - a, (c - b) - (b - a));
                let cubic =
                    cubic_roots::real_cubic_roots(w.dot(w), 3.0 * u.dot(w), 2.0 * u.dot(u) + r.dot(w), r.dot(u));
                if let Some((found, count)) = cubic {
                    found[..count]
                        .iter()
                        .filter(|t| (0.0..=1.0).contains(*t))
                        .for_each(|&t| self.improve_with_parameter(t));
                    return;
                }
            }
            _ => {}
        }
        let slope = SquaredDistanceSlope::new(self.controls, self.q);
        let roots = slope.slope_roots();
        roots.as_slice().iter().for_each(|&t| self.improve_with_parameter(t));
        let size = self.controls.iter().fold(0.0f64, |size, p| size.max(p.abs().max_element()));
        let mut searched = 0.0;
        for &t in roots.as_slice() {
            // A point on the curve within rounding cannot be improved.
            if t >= searched
                && self.squared_distance > (4.0 * f64::EPSILON * size).powi(2)
                && let Some(flat) = slope.interval_around_ill_conditioned_root(t)
            {
                self.minimise_over_interval(flat);
                searched = flat[1];
            }
        }
    }

    /// Minimises the distance itself over an interval. Samples it, and applies a golden-section
    /// search around local minima of the samples.
    fn minimise_over_interval(&mut self, [low, high]: [f64; 2]) {
        let at = |k: usize| {
            low + (high - low) * (k.min(SAMPLES_PER_FLAT_INTERVAL) as f64 / SAMPLES_PER_FLAT_INTERVAL as f64)
        };
        let squares: [f64; SAMPLES_PER_FLAT_INTERVAL + 1] = std::array::from_fn(|k| self.squared_distance(at(k)));
        for k in 0..=SAMPLES_PER_FLAT_INTERVAL {
            let (before, after) = (k.saturating_sub(1), (k + 1).min(SAMPLES_PER_FLAT_INTERVAL));
            if squares[k] <= squares[before] && squares[k] <= squares[after] {
                let t = minimise_by_golden_section([at(before), at(after)], |t| self.squared_distance(t));
                for t in [t, at(k)] {
                    let squared = self.squared_distance(t);
                    if squared < self.squared_distance * (1.0 - MIN_RELATIVE_SQUARED_DISTANCE_GAIN) {
                        (self.parameter, self.squared_distance) = (t, squared);
                    }
                }
            }
        }
    }
}

/// Returns the minimum of a unimodal function between two ends.
fn minimise_by_golden_section([mut low, mut high]: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
    const GOLDEN_RATIO: f64 = 0.618_033_988_749_894_9;
    let (mut x, mut y) = (high - GOLDEN_RATIO * (high - low), low + GOLDEN_RATIO * (high - low));
    let (mut fx, mut fy) = (f(x), f(y));
    // 0.618^80 < 2^-53.
    for _ in 0..80 {
        if fx <= fy {
            (high, y, fy) = (y, x, fx);
            x = high - GOLDEN_RATIO * (high - low);
            fx = f(x);
        } else {
            (low, x, fx) = (x, y, fy);
            y = low + GOLDEN_RATIO * (high - low);
            fy = f(y);
        }
    }
    0.5 * (low + high)
}
