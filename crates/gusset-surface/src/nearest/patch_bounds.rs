//! Lower bounds of the distance between a patch S and a query q.
//!
//! - *box*: the distance to the box of the control points. Their hull contains the patch.
//! - *half-space*: let d be a unit vector from the patch towards q. Every point of the patch
//!   satisfies |q - S| >= (q - S) . d. This is at least the minimum of (q - P) . d over the control
//!   points P.
//! - *convexity*: let the Hessian of f = |S - q|^2 / 2 be at least m > 0 over the whole patch. Then
//!   f >= f(x) - |g|^2 / (2 m) at any x, where g is the projected gradient. Close to a stationary
//!   point x, this proves the minimum. The study (3.5) calls it the convexity certificate.
//!
//! Each bound costs O(N^2). The tolerance of queries covers the rounding of the few operations.

use super::foot_point::FootPoint;
use crate::Patch;
use glam::{DVec2, DVec3};
use gusset_base::geom::aabb::Aabb;

/// A lower bound of the distance of a patch, at least `known_bound`. Uses the half-space at the
/// foot, and the more expensive convexity if that proves too little for the tolerance.
pub(super) fn best_distance_bound_of_patch<const N: usize>(
    patch: &Patch<N>,
    query: DVec3,
    foot: &FootPoint,
    known_bound: f64,
    tolerance: f64,
) -> f64 {
    let direction = (query - foot.jet.point).normalize_or_zero();
    let bound = known_bound.max(patch.distance_bound_by_half_space(query, direction));
    if bound >= foot.distance - tolerance { bound } else { bound.max(patch.distance_bound_by_convexity(query, foot)) }
}

impl<const N: usize> Patch<N> {
    /// The box bound.
    pub(super) fn distance_bound_by_box(&self, query: DVec3) -> f64 {
        Aabb::from_points(self.points.as_flattened()).axis_distances(query).length()
    }

    /// The half-space bound. `direction` is a unit vector or zero. The best one points from the
    /// nearest point to the query.
    #[inline]
    pub(super) fn distance_bound_by_half_space(&self, query: DVec3, direction: DVec3) -> f64 {
        let along = self.points.as_flattened().iter().map(|&point| (query - point).dot(direction));
        along.fold(f64::INFINITY, |least, along| if along < least { along } else { least }).max(0.0)
    }

    /// An upper bound of the distances of all points of the patch: the largest distance of a
    /// control point.
    pub(super) fn max_control_distance(&self, query: DVec3) -> f64 {
        let squares = self.points.as_flattened().iter().map(|point| point.distance_squared(query));
        squares.fold(0.0, f64::max).sqrt()
    }

    /// The convexity bound; 0 if the Hessian may be indefinite somewhere.
    pub(super) fn distance_bound_by_convexity(&self, query: DVec3, foot: &FootPoint) -> f64 {
        let at_middle = || {
            self.hessian_entry_ranges(query, &FootPoint::from_place(self, query, DVec2::splat(0.5))).min_eigenvalue()
        };
        let at_foot = self.hessian_entry_ranges(query, foot).min_eigenvalue();
        let Some(least) = at_foot.or_else(at_middle) else { return 0.0 };
        let gain = foot.projected_gradient(query).length_squared() / least;
        (foot.distance * foot.distance - gain).max(0.0).sqrt()
    }

    /// The ranges of the second derivatives of |S - q|^2 / 2 over the patch, from the derivatives
    /// at one of its points.
    ///
    /// H_ab = S_a . S_b + (S - q) . S_ab. The deviations from place x obey |S_u - S_u(x)| <= |du|
    /// max |S_uu| + |dv| max |S_uv|. Let r be the largest distance of a control point from S(x),
    /// which bounds |S - S(x)|. Then (S - q) . S_ab is within r max |S_ab| of (S(x) - q) . S_ab.
    pub(super) fn hessian_entry_ranges(&self, query: DVec3, foot: &FootPoint) -> HessianEntryRanges {
        let p = &self.points;
        let from = foot.jet.point - query;
        let radius = self.max_control_distance(foot.jet.point);
        let degree = (N - 1) as f64;
        let twice = degree * (degree - 1.0);
        let (mut uu, mut uv, mut vv) = (DotProductRange::EMPTY, DotProductRange::EMPTY, DotProductRange::EMPTY);
        for a in 0..N {
            for b in 0..N {
                if a + 2 < N {
                    uu.add_product(from, p[a + 2][b] - 2.0 * p[a + 1][b] + p[a][b]);
                    vv.add_product(from, p[b][a + 2] - 2.0 * p[b][a + 1] + p[b][a]);
                }
                if a + 1 < N && b + 1 < N {
                    uv.add_product(from, p[a + 1][b + 1] - p[a + 1][b] - p[a][b + 1] + p[a][b]);
                }
            }
        }
        let [uu, uv, vv] = [uu.scale_products(twice), uv.scale_products(degree * degree), vv.scale_products(twice)];
        let (u, v) = (foot.jet.u.length(), foot.jet.v.length());
        let farthest = foot.parameters.max(DVec2::ONE - foot.parameters);
        let off_u = farthest.x * uu.max_length + farthest.y * uv.max_length;
        let off_v = farthest.x * uv.max_length + farthest.y * vv.max_length;
        let diagonal = |length: f64, off: f64, second: DotProductRange| {
            let (min, max) = ((length - off).max(0.0), length + off);
            let slack = radius * second.max_length;
            [min * min + second.low - slack, max * max + second.high + slack]
        };
        let middle = foot.jet.u.dot(foot.jet.v);
        let slack = u * off_v + v * off_u + off_u * off_v + radius * uv.max_length;
        HessianEntryRanges {
            uu: diagonal(u, off_u, uu),
            uv: [middle + uv.low - slack, middle + uv.high + slack],
            vv: diagonal(v, off_v, vv),
        }
    }
}

/// Ranges of second derivatives over a patch.
#[derive(Debug, Clone, Copy)]
pub(super) struct HessianEntryRanges {
    uu: [f64; 2],
    uv: [f64; 2],
    vv: [f64; 2],
}

impl HessianEntryRanges {
    /// A lower bound of the eigenvalues, if it is positive.
    #[inline]
    pub(super) fn min_eigenvalue(&self) -> Option<f64> {
        let mixed = self.uv[0].abs().max(self.uv[1].abs());
        let (u, v) = (self.uu[0], self.vv[0]);
        // The smaller eigenvalue is at least the determinant divided by the trace.
        let determinant = u * v - mixed * mixed;
        let is_definite = u > 0.0 && v > 0.0 && determinant > 1e-9 * u * v;
        is_definite.then(|| determinant / (u + v))
    }

    /// True if every stationary point has a direction of descent. Second derivatives may be off by
    /// `rounding`.
    pub(super) fn is_nowhere_definite(&self, rounding: f64) -> bool {
        let [low, high] = self.uv;
        let mixed = if low <= 0.0 && high >= 0.0 { 0.0 } else { (low.abs().min(high.abs()) - rounding).max(0.0) };
        let (u, v) = (self.uu[1] + rounding, self.vv[1] + rounding);
        u < 0.0 || v < 0.0 || u * v < mixed * mixed
    }
}

/// The range of the products of some vectors with a given one, and their largest length.
#[derive(Clone, Copy)]
struct DotProductRange {
    low: f64,
    high: f64,
    max_length: f64,
}

impl DotProductRange {
    const EMPTY: DotProductRange = DotProductRange { low: f64::INFINITY, high: f64::NEG_INFINITY, max_length: 0.0 };

    /// `max_length` holds the square until [`DotProductRange::scale_products`] is called.
    #[inline(always)]
    fn add_product(&mut self, from: DVec3, vector: DVec3) {
        let along = from.dot(vector);
        self.low = self.low.min(along);
        self.high = self.high.max(along);
        self.max_length = self.max_length.max(vector.length_squared());
    }

    fn scale_products(self, factor: f64) -> DotProductRange {
        DotProductRange {
            low: factor * self.low,
            high: factor * self.high,
            max_length: factor * self.max_length.sqrt(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::foot_point::{MAX_NEWTON_STEPS_ON_PATCH, descend_to_foot};
    use super::*;
    use gusset_base::testing::case_count;

    /// A patch through control points z(a, b) over a square grid.
    fn graph_patch(z: impl Fn(usize, usize) -> f64) -> Patch<4> {
        let point = |a: usize, b: usize| DVec3::new(a as f64 / 3.0, b as f64 / 3.0, z(a, b));
        Patch { points: std::array::from_fn(|a| std::array::from_fn(|b| point(a, b))) }
    }

    fn rough_patch(seed: usize) -> Patch<4> {
        graph_patch(|a, b| ((7 * seed + 5 * a + 3 * b) as f64 * 12.9898).sin())
    }

    fn sample_places() -> impl Iterator<Item = DVec2> {
        (0..=400).map(|k| DVec2::new(f64::from(k / 21), f64::from(k % 21)) / 20.0).filter(|place| place.x <= 1.0)
    }

    fn sample_queries() -> impl Iterator<Item = DVec3> {
        (0..40).map(|k| {
            let t = f64::from(k);
            DVec3::new(0.5 + t.sin(), 0.5 + (2.0 * t).cos(), (0.7 * t).sin()) * [0.3, 1.0, 5.0, 1.5][k as usize % 4]
        })
    }

    /// Compares with points of the patch: no point is closer than a lower bound, or farther than
    /// the upper one.
    #[test]
    fn bounds_contain_sampled_distances() {
        for (seed, query) in
            (0..case_count(20) as usize).flat_map(|seed| sample_queries().map(move |query| (seed, query)))
        {
            let patch = rough_patch(seed);
            let distances = || sample_places().map(|place| patch.point(place.x, place.y).distance(query));
            let (min, max) = distances().fold((f64::INFINITY, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
            assert!(patch.max_control_distance(query) >= max);
            assert!(patch.distance_bound_by_box(query) <= min);
            for target in [patch.point(0.5, 0.5), patch.point(0.0, 1.0)] {
                assert!(patch.distance_bound_by_half_space(query, (query - target).normalize()) <= min + 1e-12);
            }
            for start in [DVec2::splat(0.5), DVec2::ZERO] {
                let foot = descend_to_foot(&patch, query, start, MAX_NEWTON_STEPS_ON_PATCH);
                // The foot may be in another valley, because the bound holds for the whole patch.
                assert!(patch.distance_bound_by_convexity(query, &foot) <= min + 1e-12, "{seed} {query}");
                assert!(best_distance_bound_of_patch(&patch, query, &foot, 0.0, 0.0) <= min + 1e-12, "{seed} {query}");
                assert!(best_distance_bound_of_patch(&patch, query, &foot, 0.25 * min, 0.0) >= 0.25 * min);
            }
        }
    }

    /// Where a bound can be exact, it must be. A smaller bound would still be correct, but searches
    /// slow.
    #[test]
    fn bounds_are_tight_on_a_plane() {
        let patch = graph_patch(|_, _| 0.0);
        for (query, nearest) in [
            (DVec3::new(0.4, 0.7, 2.0), DVec3::new(0.4, 0.7, 0.0)),
            (DVec3::new(-3.0, 0.5, 4.0), DVec3::new(0.0, 0.5, 0.0)),
            (DVec3::new(2.0, -1.0, -1.0), DVec3::new(1.0, 0.0, 0.0)),
        ] {
            let truth = query.distance(nearest);
            let foot = descend_to_foot(&patch, query, DVec2::splat(0.5), MAX_NEWTON_STEPS_ON_PATCH);
            assert!((foot.distance - truth).abs() < 1e-12);
            assert!((patch.distance_bound_by_box(query) - truth).abs() < 1e-12);
            assert!((patch.distance_bound_by_half_space(query, (query - nearest).normalize()) - truth).abs() < 1e-12);
            assert!((patch.distance_bound_by_convexity(query, &foot) - truth).abs() < 1e-12);
            assert!((best_distance_bound_of_patch(&patch, query, &foot, 0.0, 1e-9) - truth).abs() <= 1e-9);
        }
        assert!((patch.max_control_distance(DVec3::ZERO) - 2.0_f64.sqrt()).abs() < 1e-12);
        // A bowl seen from within: only convexity proves that its bottom is the nearest point.
        let profile = [0.024, -0.008, -0.008, 0.024];
        let bowl = graph_patch(|a, b| profile[a] + profile[b]);
        let query = DVec3::new(0.5, 0.5, 1.0);
        let foot = descend_to_foot(&bowl, query, DVec2::new(0.2, 0.9), MAX_NEWTON_STEPS_ON_PATCH);
        let direction = (query - foot.jet.point).normalize();
        assert!(bowl.distance_bound_by_half_space(query, direction) < foot.distance - 0.04);
        assert!(best_distance_bound_of_patch(&bowl, query, &foot, 0.0, 0.0) >= foot.distance - 1e-12);
    }

    /// Waves seen from the side: the Hessian is indefinite, and only the half-space bound proves
    /// the minimum.
    #[test]
    fn half_space_proves_where_convexity_fails() {
        let patch = graph_patch(|a, _| [0.0, 9.0, -9.0, 9.0][a]);
        let query = DVec3::new(-10.0, 0.5, 0.0);
        let foot = FootPoint::from_place(&patch, query, DVec2::new(0.0, 0.5));
        assert_eq!(patch.distance_bound_by_convexity(query, &foot), 0.0);
        assert!((best_distance_bound_of_patch(&patch, query, &foot, 0.0, 0.0) - 10.0).abs() < 1e-12);
    }

    /// Away from the nearest point, where the second derivatives are 1 and 100. The smaller one
    /// determines the bound.
    #[test]
    fn remaining_gain_is_bounded() {
        let mut patch = graph_patch(|_, _| 0.0);
        patch.points.as_flattened_mut().iter_mut().for_each(|point| point.y *= 10.0);
        let query = DVec3::new(0.9, 5.0, 0.3);
        let foot = FootPoint::from_place(&patch, query, DVec2::new(0.1, 0.5));
        let bound = patch.distance_bound_by_convexity(query, &foot);
        assert!(bound <= 0.3 && bound > 0.28, "{bound}");
    }

    /// The ranges of second derivatives contain the values at all points. Where one term dominates,
    /// they are hardly wider, so that an omitted term would be noticed.
    #[test]
    fn second_derivative_ranges_hold_and_are_tight() {
        const STEEP: f64 = 40.0;
        // z = STEEP u^2, STEEP v^2 and STEEP u v as Bezier patches.
        let square = |k: usize| [0.0, 0.0, 1.0 / 3.0, 1.0][k];
        let sheets = [
            graph_patch(|a, _| STEEP * square(a)),
            graph_patch(|_, b| STEEP * square(b)),
            graph_patch(|a, b| STEEP * (a * b) as f64 / 9.0),
        ];
        let at = |foot: &FootPoint, query: DVec3| {
            let (_, hessian) = super::super::foot_point::gradient_and_hessian(&foot.jet, query);
            [hessian.x_axis.x, hessian.x_axis.y, hessian.y_axis.y]
        };
        let mut widest = [0.0_f64; 3];
        let all = sheets.into_iter().chain((0..case_count(20) as usize).map(rough_patch)).enumerate();
        for (k, patch) in all {
            for (query, from) in sample_queries().flat_map(|query| [0.0, 0.5, 1.0].map(|t| (query, DVec2::splat(t)))) {
                let range = patch.hessian_entry_ranges(query, &FootPoint::from_place(&patch, query, from));
                let range = [range.uu, range.uv, range.vv];
                let mut found = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
                for place in sample_places() {
                    let values = at(&FootPoint::from_place(&patch, query, place), query);
                    for ([low, high], x) in found.iter_mut().zip(values) {
                        (*low, *high) = (low.min(x), high.max(x));
                    }
                }
                for ((range, found), name) in range.iter().zip(found).zip(["uu", "uv", "vv"]) {
                    let slack = 1e-9 * STEEP * STEEP;
                    assert!(range[0] <= found[0] + slack && range[1] >= found[1] - slack, "{k} {name} {query} {from}");
                }
                // The sheet of each term, seen from the end where it is flat.
                if k < 3 && from == DVec2::ZERO {
                    let term = [0, 2, 1][k];
                    let [range, found] = [range[term], found[term]].map(|[low, high]| high - low);
                    widest[k] = widest[k].max(found / range);
                }
            }
        }
        assert!(widest.iter().all(|&share| share > 0.4), "{widest:?}");
    }
}
