//! Nearest points of a surface and a line, a plane, a curve or another surface: tasks c) to e) of
//! the paper for objects that do not intersect.
//!
//! - `control_net`: control nets of patches and segments. `side_pieces`: the pieces that both sides
//!   are divided into, with hulls. `distance_descent`: nearest points of two nets, and their
//!   proofs. `distance_search`: pairs of pieces by rising lower bounds.
//!
//! A plane and an infinite line are projected to a point, so their parameters need no search. Rays
//! and segments are curves, cut off where the surface ends. Invariant, the study's theorem T5: a
//! pair of pieces is excluded only if hulls that contain the pieces are farther apart than the
//! answer. The bound therefore holds for any result of the search.

mod control_net;
mod distance_descent;
mod distance_search;
mod side_pieces;

use super::checks::{check_finite, unit_vector};
use super::line_intersection::{Line, MAX_LINE_COORDINATE};
use super::{Place, Surface};
use distance_search::{DistanceSearch, PROGRESS_STAGE};
use glam::DMat3;
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::geom::scale::floor_to_power_of_two;
use gusset_base::job::Job;
use gusset_curve::{CurveView, Place as CurvePlace};
use side_pieces::{AffineView, DistanceSide, PiecePosition, SidePieces};

/// The nearest points of a surface and another object. `T` is the type of places on the object.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearestPoints<T> {
    /// The place of the nearest point on the surface.
    pub place: Place,
    /// The point.
    pub point: DVec3,
    /// The unit normal there, or its limit at a pole; zero if no normal exists.
    pub normal: DVec3,
    /// The place of the nearest point on the object.
    pub other: T,
    /// The nearest point on the object.
    pub other_point: DVec3,
    /// The distance of the two points; 0 if they meet.
    pub distance: f64,
    /// A lower bound of the distance between surface and object.
    pub bound: f64,
    /// True if the distance exceeds the bound by at most the tolerance, or the rounding of
    /// coordinates. False if the proof would need too many pairs of pieces, which may happen if a
    /// large part of the surface is equally close.
    pub proven: bool,
    /// True if surface and object meet there within the rounding of coordinates.
    pub meets: bool,
}

/// The result of a search, in the caller's unit.
struct DistanceOutcome {
    position_on_a: PiecePosition,
    position_on_b: PiecePosition,
    distance: f64,
    bound: f64,
    proven: bool,
    meets: bool,
}

impl DistanceOutcome {
    fn to_nearest_points<T>(&self, surface: &Surface<'_>, other: T, other_point: DVec3) -> NearestPoints<T> {
        let DistanceOutcome { distance, bound, proven, meets, .. } = *self;
        let place = place_of_position(&self.position_on_a);
        let point = surface.jet(place).point;
        NearestPoints {
            place,
            point,
            normal: surface.normal(place),
            other,
            other_point,
            distance,
            bound,
            proven,
            meets,
        }
    }
}

/// Converts the position to a place on a surface.
fn place_of_position(at: &PiecePosition) -> Place {
    Place {
        sheet: at.sheet_or_segment as u32,
        cell: at.cell.map(|k| k as u32),
        u: at.parameters[0],
        v: at.parameters[1],
    }
}

/// Refuses coordinates whose squares would overflow.
fn check_coordinate_size(point: DVec3, option: &'static str) -> Result<()> {
    check_finite(point, option)?;
    let largest = point.abs().max_element();
    Error::require(largest <= MAX_LINE_COORDINATE, option, largest, "at most 1e150 in every coordinate")
}

impl Surface<'_> {
    /// Finds the nearest points of the surface and a line, ray or segment. The place on the line is
    /// its parameter. `tolerance` is the length to which the distance is proven; `None` means the
    /// surface's tolerance.
    ///
    /// If several pairs of points are equally close, the result is one of them, chosen
    /// deterministically. O(log cells) and some tens to hundreds of pairs of pieces; limited if a
    /// large part of the surface is equally close.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the line is not finite or lacks a direction, or the tolerance
    /// is negative or not finite; [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn distance_to_line(&self, line: &Line, tolerance: Option<f64>, job: &Job<'_>) -> Result<NearestPoints<f64>> {
        line.check_finite_with_direction()?;
        let (along, length) = line.direction_and_length();
        let parameter = |point: DVec3| ((point - line.origin).dot(along) / length).clamp(line.from, line.to);
        let at = |t: f64| line.origin + (t * length) * along;
        let box_ends: [f64; 8] = self.bounding_box_corners().map(parameter);
        let ends =
            box_ends.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &t| [low.min(t), high.max(t)]);
        let is_cut = ends[0] == line.from || ends[1] == line.to;
        let found = if is_cut {
            // Beyond the surface's bounding box, no point of the line is nearest to a point of the
            // surface.
            let points = ends.map(at);
            let view = CurveView::new(&points, &[0, 1], false)?;
            self.search_distance_in_view(
                DistanceSide::Curve(&view),
                self.middle_and_identity_axes(),
                &points,
                tolerance,
                job,
            )?
        } else {
            let (u, v) = along.any_orthonormal_pair();
            let near = at(0.5 * (ends[0] + ends[1]));
            let across = DMat3::from_cols(u, v, DVec3::ZERO).transpose();
            self.search_distance_in_view(DistanceSide::Point, (near, across), &[near], tolerance, job)?
        };
        let t = if is_cut { ends[0] + (ends[1] - ends[0]) * found.position_on_b.parameters[0] } else { 0.0 };
        let mut approach = found.to_nearest_points(self, t, at(t));
        if !is_cut {
            approach.other = parameter(approach.point);
            approach.other_point = at(approach.other);
        }
        Ok(approach)
    }

    /// Finds the point of the surface nearest to a plane, given by a point and a normal. Sets
    /// `other` to the signed distance of the surface's point from the plane, positive on the side
    /// of the normal. If surface and plane meet, the point is on the section. Otherwise like
    /// [`Surface::distance_to_line`].
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the point or the normal is not finite, the normal is zero, or
    /// the tolerance is invalid; [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn distance_to_plane(
        &self,
        point: DVec3,
        normal: DVec3,
        tolerance: Option<f64>,
        job: &Job<'_>,
    ) -> Result<NearestPoints<f64>> {
        check_coordinate_size(point, "point")?;
        let normal = unit_vector(normal, "normal")?;
        let across = DMat3::from_cols(DVec3::ZERO, DVec3::ZERO, normal).transpose();
        let nearest = self.search_distance_in_view(DistanceSide::Point, (point, across), &[point], tolerance, job)?;
        let mut approach = nearest.to_nearest_points(self, 0.0, DVec3::ZERO);
        let height = normal.dot(approach.point - point);
        approach.other_point = approach.point - height * normal;
        approach.other = nearest.distance.copysign(height);
        Ok(approach)
    }

    /// Finds the nearest points of the surface and a curve of any degree. Otherwise like
    /// [`Surface::distance_to_line`].
    ///
    /// # Errors
    /// [`Error::EmptyCurve`], [`Error::OptionOutOfRange`] for a coordinate above 1e150 or an
    /// invalid tolerance, [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn distance_to_curve(
        &self,
        curve: &CurveView<'_>,
        tolerance: Option<f64>,
        job: &Job<'_>,
    ) -> Result<NearestPoints<CurvePlace>> {
        if curve.is_empty() {
            return Err(Error::EmptyCurve);
        }
        curve.points().iter().try_for_each(|&point| check_coordinate_size(point, "curve"))?;
        let nearest = self.search_distance_in_view(
            DistanceSide::Curve(curve),
            self.middle_and_identity_axes(),
            curve.points(),
            tolerance,
            job,
        )?;
        let at = CurvePlace {
            segment: nearest.position_on_b.sheet_or_segment as u32,
            t: nearest.position_on_b.parameters[0],
        };
        Ok(nearest.to_nearest_points(self, at, curve.point(at)?))
    }

    /// Finds the nearest points of two surfaces. The default tolerance is the larger of the two.
    /// Otherwise like [`Surface::distance_to_line`].
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for an invalid tolerance, [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn distance_to_surface(
        &self,
        other: &Surface<'_>,
        tolerance: Option<f64>,
        job: &Job<'_>,
    ) -> Result<NearestPoints<Place>> {
        let tolerance = tolerance.unwrap_or(self.tolerance().max(other.tolerance()));
        let source = DistanceSide::Surface(other);
        let nearest = self.search_distance_in_view(
            source,
            self.middle_and_identity_axes(),
            &other.bounding_box_corners(),
            Some(tolerance),
            job,
        )?;
        let at = place_of_position(&nearest.position_on_b);
        Ok(nearest.to_nearest_points(self, at, other.jet(at).point))
    }

    /// The corners of the bounding box.
    fn bounding_box_corners(&self) -> [DVec3; 8] {
        side_pieces::corners_of_box(&Aabb::from_points(self.bounds()))
    }

    /// The view without projection, with its origin in the middle of the surface.
    fn middle_and_identity_axes(&self) -> (DVec3, DMat3) {
        let [low, high] = self.bounds();
        (0.5 * (low + high), DMat3::IDENTITY)
    }

    /// Searches in a view. `extent` are points whose hull contains the other side.
    fn search_distance_in_view(
        &self,
        other: DistanceSide<'_>,
        (origin, turned): (DVec3, DMat3),
        extent: &[DVec3],
        tolerance: Option<f64>,
        job: &Job<'_>,
    ) -> Result<DistanceOutcome> {
        job.step(0.0, PROGRESS_STAGE)?;
        let tolerance = tolerance.unwrap_or(self.tolerance());
        Error::require(tolerance >= 0.0 && tolerance.is_finite(), "tolerance", tolerance, "finite and at least 0")?;
        let all_points = || self.bounding_box_corners().into_iter().chain(extent.iter().copied());
        let reach = all_points().map(|point| (point - origin).abs().max_element()).fold(0.0, f64::max);
        let largest = all_points().map(|point| point.abs().max_element()).fold(origin.abs().max_element(), f64::max);
        let unit = if reach > 0.0 { floor_to_power_of_two(reach) } else { 1.0 };
        let rounding = 32.0 * f64::EPSILON * (largest / unit);
        let tolerance = (tolerance / unit).max(4.0 * rounding);
        let view = AffineView { origin, linear_map: turned, unit };
        let sides = [SidePieces::new(DistanceSide::Surface(self), view)?, SidePieces::new(other, view)?];
        let mut search = DistanceSearch::new(sides, tolerance, rounding, job);
        let bound = search.find_nearest_pair()?;
        // Every search examines a pair of nets before it may end.
        let (distance, a, b) = search
            .nearest_pair
            .map_or_else(Default::default, |best| (best.distance, best.position_on_a, best.position_on_b));
        let meets = distance <= rounding;
        let (distance, bound) = if meets { (0.0, 0.0) } else { (distance, bound.min(distance)) };
        let proven = bound >= distance - tolerance;
        Ok(DistanceOutcome {
            position_on_a: a,
            position_on_b: b,
            distance: distance * unit,
            bound: bound * unit,
            proven,
            meets,
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::{Grid, Nodes, Scheme, Sheet, Surface};
    use glam::DVec3;
    use gusset_base::job::{Job, Progress};
    use gusset_curve::CurveView;
    use std::cell::Cell;
    use std::ops::ControlFlow;

    /// Cancels a search that reports after more than twice the largest number of pairs.
    #[derive(Default)]
    struct LimitedReports(Cell<usize>);

    impl Progress for LimitedReports {
        fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
            self.0.set(self.0.get() + 1);
            if self.0.get() > 2 * 50_000 / 256 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        }
    }

    #[test]
    fn curves_are_near_surfaces_in_one_point_or_line() {
        let mut random = fastrand::Rng::with_seed(60);
        for case in 0..if cfg!(debug_assertions) { 60 } else { 2000 } {
            let mut coordinate = || 2.0 * random.f64() - 1.0;
            let (place, direction) = (
                [DVec3::ZERO, DVec3::new(coordinate(), coordinate(), coordinate())][case % 2],
                [DVec3::ZERO, DVec3::new(coordinate(), coordinate(), coordinate())][case % 3 / 2],
            );
            let points: Vec<_> =
                (0..2 + case % 7).map(|_| DVec3::new(coordinate(), coordinate(), coordinate())).collect();
            let [rows, columns] = [2 + random.usize(..8), 2 + random.usize(..4)];
            let nodes = (0..rows * columns).flat_map(|k| (place + (k / columns) as f64 * direction).to_array());
            let nodes = Nodes::strided(nodes.collect::<Vec<_>>(), rows, columns, 0, 0).unwrap();
            let sheet = Sheet::Grid(Grid::new(nodes, [false; 2], Scheme::SixTap).unwrap());
            let surface = Surface::new(vec![sheet], None, &Job::default()).unwrap();
            let ends = [0, points.len() as u32 - 1];
            let curve = CurveView::new(&points, &ends, false).unwrap();
            let limit = LimitedReports::default();
            let found = surface.distance_to_curve(&curve, None, &Job::new(1, &limit)).unwrap();
            // The surface is a segment.
            let end = place + (rows - 1) as f64 * direction;
            let distance_to_segment = |p: DVec3| {
                let along = (p - place).dot(end - place) / (end - place).length_squared();
                p.distance(place.lerp(end, if along.is_nan() { 0.0 } else { along.clamp(0.0, 1.0) }))
            };
            let point = |t: f64| {
                let mut q = points.clone();
                (1..q.len()).rev().for_each(|n| (0..n).for_each(|k| q[k] = q[k].lerp(q[k + 1], t)));
                q[0]
            };
            let sampled = (0..=4000).map(|k| distance_to_segment(point(f64::from(k) / 4000.0)));
            let sampled = sampled.fold(f64::INFINITY, f64::min);
            // A nearest point between two samples is nearer by up to half a step along the curve.
            let step = 2.0 * points.len() as f64 * 3.5 / 8000.0;
            assert!(found.distance <= sampled + 1e-9, "case {case}: {} {sampled}", found.distance);
            assert!(found.distance >= sampled - step, "case {case}: {} {sampled}", found.distance);
            assert!((found.point.distance(found.other_point) - found.distance).abs() < 1e-12, "case {case}");
        }
    }
}
