//! All common points of a Bézier curve and a patch: all (t, u, v) with C(t) = S(u, v).
//! [`subdivide`] halves pairs of a part of the curve and a part of the patch in their longest
//! direction.
//!
//! Proofs follow Mourrain and Pavone (2009) and Hanniel and Elber (2007), see
//! [`gusset_base::geom::subdivision`]:
//! - *empty*: a direction separates the two sets of control points. The directions tested are the
//!   coordinate axes, the patch's normal, and three directions that make the middle Jacobian of C -
//!   S the identity. C - S is the sum of a function of t and a function of (u, v), so its bounds
//!   are sums too.
//! - *unique*: in the latter directions the Jacobian is diagonally dominant all over the pair, so
//!   that C - S is injective. Newton's method finds the common point, if it stays near the pair.
//! - *unresolved*: along the normal, both parts are within the tolerance. The curve touches the
//!   surface there, or runs in it, or passes where the surface is not regular.
//!
//! Cost: O(M^2 + N^2) for a test, O(N^3) for a split; at most [`MAX_EXAMINED_PAIRS`] pairs.

use crate::Patch;
use glam::{DMat3, DVec2, DVec3};
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::aabb::range_of_values;
use gusset_base::geom::bernstein::{evaluate, evaluate_with_slope, halves};
use gusset_base::geom::subdivision::{
    BoxStack, BoxTest, Subdivision, SubdivisionLimits, UnresolvedBox, UnresolvedCluster, cluster_touching_boxes,
    subdivide,
};
use std::convert::Infallible;

/// Number of halvings, over all three directions, after which a pair is given up.
const MAX_SUBDIVISION_DEPTH: u32 = 96;
/// Largest number of pairs examined. Without a limit, a curve that lies in a surface would never
/// end.
const MAX_EXAMINED_PAIRS: usize = 2048;
/// Pairs with a longer parameter range of the curve are halved even if they are flat. This locates
/// the ends of a common arc.
const MAX_UNRESOLVED_PARAMETER_LENGTH: f64 = 1.0 / 16.0;
/// How far outside a pair a common point may be found besides rounding, as a fraction of the pair.
/// Both sides of a border find the points on it.
const MAX_FRACTION_OUTSIDE_PAIR: f64 = 1e-12;

/// A common point of a curve and a patch, where the curve passes through the patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CurvePatchCrossing {
    /// Parameter on the curve.
    pub(crate) curve_parameter: f64,
    /// Parameters on the patch.
    pub(crate) patch_parameters: DVec2,
    /// Bound of the error of the parameters by rounding.
    parameter_error_bound: f64,
}

/// Common points of a curve and a patch.
#[derive(Debug, Clone, Default)]
pub(crate) struct CurvePatchCrossings {
    /// The transversal crossings, each once.
    pub(crate) simple_crossings: Vec<CurvePatchCrossing>,
    /// Clusters of (t, u, v) that could not be resolved. The middle of a cluster's best box is
    /// where curve and patch are closest.
    pub(crate) unresolved: Vec<UnresolvedCluster>,
}

/// A part of the curve and a part of the patch.
#[derive(Clone)]
struct CurvePartPatchPartPair<const M: usize, const N: usize> {
    curve: [DVec3; M],
    patch: Patch<N>,
    /// The smallest t, u and v of the pair, and the lengths of their ranges.
    low_parameters: DVec3,
    parameter_lengths: DVec3,
}

/// Memory that searches reuse.
#[derive(Default)]
pub(crate) struct CrossingWorkspace<const M: usize, const N: usize> {
    stack: BoxStack<CurvePartPatchPartPair<M, N>>,
    boxes: Vec<UnresolvedBox>,
}

/// The search for common points of one curve and one patch.
struct CurvePatchSearch<'a, const M: usize, const N: usize> {
    whole_pair: CurvePartPatchPartPair<M, N>,
    rounding_error: f64,
    tolerance: f64,
    simple: &'a mut Vec<CurvePatchCrossing>,
    boxes: &'a mut Vec<UnresolvedBox>,
}

/// Finds all common points of a curve of degree M - 1 and a patch. Control points may be off by
/// `rounding_error`. Points within `tolerance` of each other need not be told apart. Examines at
/// most [`MAX_EXAMINED_PAIRS`] pairs, and leaves up to as many unresolved.
pub(crate) fn find_crossings<const M: usize, const N: usize>(
    curve: &[DVec3; M],
    patch: &Patch<N>,
    rounding_error: f64,
    tolerance: f64,
    workspace: &mut CrossingWorkspace<M, N>,
    found: &mut CurvePatchCrossings,
) -> Result<()> {
    // Moves the origin to the patch, where rounding is small.
    let origin = patch.points[0][0];
    let curve = curve.map(|point| point - origin);
    let patch = Patch { points: patch.points.map(|row| row.map(|point| point - origin)) };
    let radius = patch.points.as_flattened().iter().map(|point| point.length_squared()).fold(0.0, f64::max).sqrt();
    let rounding_error = rounding_error + 8.0 * f64::EPSILON * radius;
    let tolerance = tolerance.max(4.0 * rounding_error);
    let whole = CurvePartPatchPartPair { curve, patch, low_parameters: DVec3::ZERO, parameter_lengths: DVec3::ONE };
    let CrossingWorkspace { stack, boxes } = workspace;
    boxes.clear();
    found.simple_crossings.clear();
    found.unresolved.clear();
    let first = whole.clone();
    let mut search =
        CurvePatchSearch { whole_pair: whole, rounding_error, tolerance, simple: &mut found.simple_crossings, boxes };
    let limits = SubdivisionLimits { max_depth: MAX_SUBDIVISION_DEPTH, max_boxes: MAX_EXAMINED_PAIRS };
    let Ok(()) = subdivide(&mut search, first, stack, limits);
    cluster_touching_boxes(search.boxes, &mut found.unresolved, || Ok(()))?;
    found.unresolved.iter_mut().for_each(|cluster| search.whole_pair.refine_closest_place(cluster));
    Ok(())
}

impl<const M: usize, const N: usize> Subdivision<CurvePartPatchPartPair<M, N>, 2> for CurvePatchSearch<'_, M, N> {
    type Solution = CurvePatchCrossing;
    type Split = ();
    type Stop = Infallible;

    #[inline]
    fn classify_box(
        &mut self,
        pair: &CurvePartPatchPartPair<M, N>,
    ) -> Result<BoxTest<CurvePatchCrossing, ()>, Infallible> {
        Ok(pair.classify_pair(&self.whole_pair, self.rounding_error, self.tolerance))
    }

    fn record_solution(
        &mut self,
        _: CurvePartPatchPartPair<M, N>,
        crossing: CurvePatchCrossing,
    ) -> Result<(), Infallible> {
        let is_same = |other: &CurvePatchCrossing| {
            let apart = (other.patch_parameters - crossing.patch_parameters)
                .abs()
                .max_element()
                .max((other.curve_parameter - crossing.curve_parameter).abs());
            apart <= 2.0 * (other.parameter_error_bound + crossing.parameter_error_bound)
        };
        if !self.simple.iter().any(is_same) {
            self.simple.push(crossing);
        }
        Ok(())
    }

    fn record_unresolved(&mut self, pair: CurvePartPatchPartPair<M, N>, _exhausted: bool) -> Result<(), Infallible> {
        let residual = (evaluate(&pair.curve, 0.5) - pair.patch.surface_point(0.5, 0.5)).length_squared();
        let half = 0.5 * pair.parameter_lengths;
        self.boxes.push(UnresolvedBox { middle: pair.low_parameters + half, half_size: half, residual });
        Ok(())
    }

    fn split_box(&mut self, pair: CurvePartPatchPartPair<M, N>, (): ()) -> [CurvePartPatchPartPair<M, N>; 2] {
        pair.halve_longest()
    }
}

/// The largest absolute value of each component.
fn max_abs_components(vectors: impl Iterator<Item = DVec3>) -> DVec3 {
    vectors.fold(DVec3::ZERO, |max, vector| max.max(vector.abs()))
}

impl<const M: usize, const N: usize> CurvePartPatchPartPair<M, N> {
    fn classify_pair(&self, whole: &Self, rounding_error: f64, tolerance: f64) -> BoxTest<CurvePatchCrossing, ()> {
        let (along, across) = (Aabb::from_points(self.curve), Aabb::from_points(self.patch.points.as_flattened()));
        let gap = along.axis_gaps(&across);
        if gap.max_element() > rounding_error {
            return BoxTest::Empty;
        }
        let (tangent, [u, v]) = (curve_derivative(&self.curve, 0.5), self.patch.surface_tangents(0.5, 0.5));
        let jacobian = DMat3::from_cols(tangent, -u, -v);
        let normal = u.cross(v);
        let is_flat = match normal.try_normalize() {
            Some(normal) => {
                if self.is_separated_along(normal, rounding_error) {
                    return BoxTest::Empty;
                }
                let heights = |points: &[DVec3]| range_of_values(points.iter().map(|point| point.dot(normal)));
                let [one, other] = [heights(&self.curve), heights(self.patch.points.as_flattened())];
                one[1].max(other[1]) - one[0].min(other[0]) <= tolerance
            }
            None => along.union(across).diagonal() <= tolerance,
        };
        let is_resolved = is_flat && self.parameter_lengths.x <= MAX_UNRESOLVED_PARAMETER_LENGTH;
        let undecided = if is_resolved { BoxTest::Unresolved } else { BoxTest::Undecided(()) };
        let volume = tangent.length() * normal.length();
        if jacobian.determinant().abs() <= 1e-9 * volume || volume == 0.0 {
            // Tangents and normal are nearly coplanar. Directions perpendicular to them may still
            // separate the two.
            let sides = [normal.cross(u), normal.cross(v), normal.cross(tangent)];
            let apart = sides
                .into_iter()
                .filter_map(DVec3::try_normalize)
                .any(|side| self.is_separated_along(side, rounding_error));
            return if apart { BoxTest::Empty } else { undecided };
        }
        let test = self.prove_no_or_one_crossing(whole, jacobian.inverse(), rounding_error);
        test.unwrap_or(undecided)
    }

    /// True if a direction separates the two.
    fn is_separated_along(&self, direction: DVec3, rounding_error: f64) -> bool {
        let [low, high] = range_of_values(self.curve.iter().map(|point| point.dot(direction)));
        let [from, to] = range_of_values(self.patch.points.as_flattened().iter().map(|point| point.dot(direction)));
        low > to + rounding_error || from > high + rounding_error
    }

    /// Tests for zero or one common point, in directions in which C - S is nearly (t, u, v) minus
    /// its root.
    fn prove_no_or_one_crossing(
        &self,
        whole: &Self,
        inverse: DMat3,
        rounding_error: f64,
    ) -> Option<BoxTest<CurvePatchCrossing, ()>> {
        let curve = self.curve.map(|point| inverse * point);
        let patch = Patch { points: self.patch.points.map(|row| row.map(|point| inverse * point)) };
        // Bound of the error of the root by rounding.
        let rows = inverse.transpose();
        let slack = DVec3::new(rows.x_axis.length(), rows.y_axis.length(), rows.z_axis.length()) * rounding_error;
        let (along, across) = (Aabb::from_points(curve), Aabb::from_points(patch.points.as_flattened()));
        if (along.axis_gaps(&across) - slack).max_element() > 0.0 {
            return Some(BoxTest::Empty);
        }
        // All values of a derivative lie within the range of its control points.
        let (m, n) = ((M - 1) as f64, (N - 1) as f64);
        let p = &patch.points;
        let by_t = || (0..M - 1).map(|k| m * (curve[k + 1] - curve[k]));
        let by_u = || (0..N - 1).flat_map(|a| (0..N).map(move |b| n * (p[a][b] - p[a + 1][b])));
        let by_v = || (0..N).flat_map(|a| (0..N - 1).map(move |b| n * (p[a][b] - p[a][b + 1])));
        let (t, u, v) = (max_abs_components(by_t()), max_abs_components(by_u()), max_abs_components(by_v()));
        let dominant =
            by_t().all(|by| by.x > u.x + v.x) && by_u().all(|by| by.y > t.y + v.y) && by_v().all(|by| by.z > t.z + u.z);
        if !dominant {
            return None;
        }
        let mut at = DVec3::splat(0.5);
        for _ in 0..32 {
            let ([u, v], miss) =
                (patch.surface_tangents(at.y, at.z), evaluate(&curve, at.x) - patch.surface_point(at.y, at.z));
            let step = DMat3::from_cols(curve_derivative(&curve, at.x), -u, -v).inverse() * miss;
            at -= step;
            if !(at - 0.5).abs().cmple(DVec3::ONE).all() {
                return None;
            }
            if step.abs().max_element() <= 1e-14 {
                break;
            }
        }
        let margin = MAX_FRACTION_OUTSIDE_PAIR + 4.0 * slack;
        if !(at - 0.5).abs().cmple(0.5 + margin).all() {
            return None;
        }
        // Improves the root with the original control points, because splitting rounds the control
        // points.
        let mut place = self.low_parameters + self.parameter_lengths * at;
        for _ in 0..2 {
            let miss = evaluate(&whole.curve, place.x) - whole.patch.surface_point(place.y, place.z);
            place -= self.parameter_lengths * (inverse * miss);
        }
        let place = place.clamp(DVec3::ZERO, DVec3::ONE);
        let slack = (self.parameter_lengths * margin).max_element();
        Some(BoxTest::Unique(CurvePatchCrossing {
            curve_parameter: place.x,
            patch_parameters: DVec2::new(place.y, place.z),
            parameter_error_bound: slack,
        }))
    }

    /// Halves the pair in its longest direction.
    fn halve_longest(self) -> [Self; 2] {
        let p = &self.patch.points;
        let longest = |from: f64, leg: DVec3| from.max(leg.length_squared());
        let t = (0..M - 1).map(|k| self.curve[k + 1] - self.curve[k]).fold(0.0, longest);
        let u = (0..N - 1).flat_map(|a| (0..N).map(move |b| p[a + 1][b] - p[a][b])).fold(0.0, longest);
        let v = (0..N).flat_map(|a| (0..N - 1).map(move |b| p[a][b + 1] - p[a][b])).fold(0.0, longest);
        let scale = ((N - 1) as f64 / (M - 1) as f64).powi(2);
        let (mut low, mut high) = (self.clone(), self);
        let axis = if t >= scale * u.max(v) {
            [low.curve, high.curve] = halves(&high.curve);
            0
        } else if u >= v {
            [low.patch, high.patch] = high.patch.halves();
            1
        } else {
            [low.patch, high.patch] = high.patch.transposed().halves().map(|half| half.transposed());
            2
        };
        low.parameter_lengths[axis] *= 0.5;
        high.parameter_lengths[axis] *= 0.5;
        high.low_parameters[axis] += high.parameter_lengths[axis];
        [low, high]
    }

    /// Moves the best place of a cluster to where curve and patch are closest within the cluster.
    /// Levenberg-Marquardt steps, clamped to the cluster.
    fn refine_closest_place(&self, cluster: &mut UnresolvedCluster) {
        let (low, high) = (cluster.low.max(DVec3::ZERO), cluster.high.min(DVec3::ONE));
        let miss = |at: DVec3| evaluate(&self.curve, at.x) - self.patch.surface_point(at.y, at.z);
        let mut at = cluster.best_box.middle.clamp(low, high);
        let mut gap = miss(at);
        let mut damping = 1e-6;
        for _ in 0..40 {
            let [u, v] = self.patch.surface_tangents(at.y, at.z);
            let jacobian = DMat3::from_cols(curve_derivative(&self.curve, at.x), -u, -v);
            let (square, gradient) = (jacobian.transpose() * jacobian, jacobian.transpose() * gap);
            let diagonal = DVec3::new(square.x_axis.x, square.y_axis.y, square.z_axis.z) * damping;
            let step = (square + DMat3::from_diagonal(diagonal)).inverse() * gradient;
            let next = (at - step).clamp(low, high);
            if !step.is_finite() || next == at {
                break;
            }
            let there = miss(next);
            if there.length_squared() < gap.length_squared() {
                (at, gap, damping) = (next, there, 0.1 * damping);
            } else if damping > 1e3 {
                break;
            } else {
                damping *= 10.0;
            }
        }
        cluster.best_box.middle = at;
    }
}

impl<const N: usize> Patch<N> {
    /// S(u, v).
    #[inline]
    fn surface_point(&self, u: f64, v: f64) -> DVec3 {
        evaluate(&self.points.map(|row| evaluate(&row, v)), u)
    }

    /// S_u and S_v.
    #[inline]
    fn surface_tangents(&self, u: f64, v: f64) -> [DVec3; 2] {
        let rows = self.points.map(|row| (evaluate(&row, v), curve_derivative(&row, v)));
        [curve_derivative(&rows.map(|row| row.0), u), evaluate(&rows.map(|row| row.1), u)]
    }
}

/// C'(t).
#[inline]
fn curve_derivative<const M: usize>(points: &[DVec3; M], t: f64) -> DVec3 {
    evaluate_with_slope(points, t)[1]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The patch (u, v, f(u) + g(v)), f and g cubics by their Bernstein coefficients.
    fn patch_of_sum(f: [f64; 4], g: [f64; 4]) -> Patch<4> {
        let at = |k: usize| k as f64 / 3.0;
        Patch { points: std::array::from_fn(|a| std::array::from_fn(|b| DVec3::new(at(a), at(b), f[a] + g[b]))) }
    }

    fn straight_cubic(a: DVec3, b: DVec3) -> [DVec3; 4] {
        std::array::from_fn(|k| a.lerp(b, k as f64 / 3.0))
    }

    fn solve_crossings<const M: usize>(curve: &[DVec3; M], patch: &Patch<4>) -> CurvePatchCrossings {
        let mut found = CurvePatchCrossings::default();
        find_crossings(curve, patch, 0.0, 1e-9, &mut CrossingWorkspace::default(), &mut found).unwrap();
        found.simple_crossings.sort_by(|a, b| a.curve_parameter.total_cmp(&b.curve_parameter));
        found
    }

    /// The Bernstein coefficients of (x - a) (x - b) (x - c).
    fn cubic_with_roots([a, b, c]: [f64; 3]) -> [f64; 4] {
        let f = |x: f64, y: f64, z: f64| {
            let sum = |p: f64, q: f64, r: f64| (x - p) * (y - q) * (z - r);
            (sum(a, b, c) + sum(a, c, b) + sum(b, a, c) + sum(b, c, a) + sum(c, a, b) + sum(c, b, a)) / 6.0
        };
        [f(0.0, 0.0, 0.0), f(0.0, 0.0, 1.0), f(0.0, 1.0, 1.0), f(1.0, 1.0, 1.0)]
    }

    #[test]
    fn all_three_crossings_of_a_cubic_are_found() {
        let patch = patch_of_sum(cubic_with_roots([0.2, 0.5, 0.9]), [0.0; 4]);
        let line = straight_cubic(DVec3::new(0.0, 0.3, 0.0), DVec3::new(1.0, 0.7, 0.0));
        let found = solve_crossings(&line, &patch);
        assert_eq!((found.simple_crossings.len(), found.unresolved.len()), (3, 0), "{found:?}");
        for (crossing, t) in found.simple_crossings.iter().zip([0.2, 0.5, 0.9]) {
            assert!(
                (crossing.curve_parameter - t).abs() < 1e-13 && (crossing.patch_parameters.x - t).abs() < 1e-13,
                "{found:?}"
            );
            assert!((crossing.patch_parameters.y - (0.3 + 0.4 * t)).abs() < 1e-13, "{found:?}");
        }
        // A curve that passes through the plane z = 0 three times.
        let flat = patch_of_sum([0.0; 4], [0.0; 4]);
        let heights = cubic_with_roots([0.1, 0.4, 0.8]);
        let wave: [DVec3; 4] =
            std::array::from_fn(|k| DVec3::new(0.2 + 0.2 * k as f64, 0.9 - 0.25 * k as f64, heights[k]));
        let found = solve_crossings(&wave, &flat);
        assert_eq!((found.simple_crossings.len(), found.unresolved.len()), (3, 0), "{found:?}");
        assert!((found.simple_crossings[1].curve_parameter - 0.4).abs() < 1e-13);
        // A curve past the patch, and a curve away from it.
        let past = straight_cubic(DVec3::new(1.1, -0.2, -1.0), DVec3::new(1.0001, 0.5, 1.0));
        assert!(
            solve_crossings(&past, &patch).simple_crossings.is_empty()
                && solve_crossings(&past, &patch).unresolved.is_empty()
        );
    }

    #[test]
    fn crossings_at_corners_of_parts_are_found_once() {
        let patch = patch_of_sum([0.0; 4], [0.0; 4]);
        let line = straight_cubic(DVec3::new(0.4, 0.6, -0.5), DVec3::new(0.6, 0.4, 0.5));
        let found = solve_crossings(&line, &patch);
        assert_eq!(found.simple_crossings.len(), 1, "{found:?}");
        assert!(found.simple_crossings[0].patch_parameters.distance(DVec2::splat(0.5)) < 1e-14);
        // At a corner and on a side of the patch.
        for place in [DVec2::ZERO, DVec2::new(1.0, 0.25), DVec2::ONE] {
            let at = place.extend(0.0);
            let line = straight_cubic(at - DVec3::new(0.3, -0.2, 1.0), at + DVec3::new(0.3, -0.2, 1.0));
            let found = solve_crossings(&line, &patch);
            assert!(
                found.simple_crossings.len() == 1 && found.simple_crossings[0].patch_parameters.distance(place) < 1e-13,
                "{found:?}"
            );
        }
    }

    #[test]
    fn touching_and_running_inside_are_reported() {
        // z = (u - 0.37)^2 and a line with z = 0 across it.
        let dip = [0.37 * 0.37, 0.37 * 0.37 - 0.74 / 3.0, 0.37 * 0.37 - 1.48 / 3.0 + 1.0 / 3.0, 0.63 * 0.63];
        let line = straight_cubic(DVec3::new(0.0, 0.5, 0.0), DVec3::new(1.0, 0.5, 0.0));
        let found = solve_crossings(&line, &patch_of_sum(dip, [0.0; 4]));
        assert!(found.simple_crossings.is_empty() && found.unresolved.len() == 1, "{found:?}");
        assert!((found.unresolved[0].best_box.middle.x - 0.37).abs() < 1e-4, "{found:?}");
        // A line in the plane of the patch: the common part runs from t = 0.25 to 0.75.
        let line = straight_cubic(DVec3::new(-0.5, 0.5, 0.0), DVec3::new(1.5, 0.5, 0.0));
        let found = solve_crossings(&line, &patch_of_sum([0.0; 4], [0.0; 4]));
        assert!(found.simple_crossings.is_empty() && found.unresolved.len() == 1, "{found:?}");
        let cluster = found.unresolved[0];
        assert!(
            (cluster.low.x - 0.25).abs() <= MAX_UNRESOLVED_PARAMETER_LENGTH
                && (cluster.high.x - 0.75).abs() <= MAX_UNRESOLVED_PARAMETER_LENGTH,
            "{found:?}"
        );
        // A line in the plane of the patch that misses the patch.
        let past = straight_cubic(DVec3::new(0.6, -0.45, 0.0), DVec3::new(1.5, 0.45, 0.0));
        let found = solve_crossings(&past, &patch_of_sum([0.0; 4], [0.0; 4]));
        assert!(found.simple_crossings.is_empty() && found.unresolved.is_empty(), "{found:?}");
        // A curve on a curved sheet, along one of its iso-curves.
        let wave = cubic_with_roots([0.1, 0.5, 0.8]);
        let own: [DVec3; 4] = std::array::from_fn(|k| DVec3::new(k as f64 / 3.0, 0.3, wave[k]));
        let found = solve_crossings(&own, &patch_of_sum(wave, [0.0; 4]));
        assert!(!found.unresolved.is_empty(), "{found:?}");
        let covered: f64 = found.unresolved.iter().map(|cluster| cluster.high.x - cluster.low.x).sum();
        assert!(covered > 0.99, "{found:?}");
    }

    #[test]
    fn raised_degrees_give_equal_crossings() {
        // The same cubic, raised to degree 7.
        let patch = patch_of_sum(cubic_with_roots([0.2, 0.5, 0.9]), cubic_with_roots([0.1, 0.2, 0.3]));
        let curve = [DVec3::new(0.1, 0.9, -0.3), DVec3::new(0.5, 0.2, 0.6), DVec3::new(0.4, 0.8, -0.8), DVec3::ONE];
        let mut raised = [DVec3::ZERO; 8];
        raised[..4].copy_from_slice(&curve);
        for n in 4..8 {
            raised[n] = raised[n - 1];
            (1..n).rev().for_each(|k| raised[k] = raised[k].lerp(raised[k - 1], k as f64 / n as f64));
        }
        let (low, high) = (solve_crossings(&curve, &patch), solve_crossings(&raised, &patch));
        assert!(
            !low.simple_crossings.is_empty() && low.simple_crossings.len() == high.simple_crossings.len(),
            "{low:?} {high:?}"
        );
        for (a, b) in low.simple_crossings.iter().zip(&high.simple_crossings) {
            assert!(
                (a.curve_parameter - b.curve_parameter).abs() < 1e-12
                    && a.patch_parameters.distance(b.patch_parameters) < 1e-12
            );
        }
    }
}
