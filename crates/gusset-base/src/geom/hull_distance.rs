//! A proven lower bound of the distance between two convex hulls, by the algorithm of Gilbert,
//! Johnson and Keerthi (1988, "A fast procedure for computing the distance between complex
//! objects").
//!
//! The algorithm looks for the point v nearest to the origin in the hull of all differences a - b.
//! Each round adds the extreme point in the direction of -v to a simplex, and keeps the face of the
//! simplex nearest to the origin. Invariant: for every v, however inexact, (min a . v - max b .
//! v) / |v| is a lower bound of the distance. Each round is O(points), and there are at most
//! `MAX_GJK_ROUNDS`.

use glam::{DMat3, DVec3};

/// The number of rounds after which the current bound is returned.
const MAX_GJK_ROUNDS: usize = 24;
/// The relative gap between bound and distance at which the search ends.
const MAX_RELATIVE_GAP: f64 = 1e-13;

/// A lower bound of the distance between two hulls, and a nearest pair of points.
#[derive(Debug, Clone, Copy)]
pub struct HullDistance {
    /// A lower bound of the distance, up to rounding; at least 0.
    pub lower_bound: f64,
    /// The corners whose weighted sums form the nearest pair of points, or nearly. Only the first
    /// `corner_count` are valid.
    pub corners: [SimplexCorner; 4],
    pub corner_count: usize,
}

/// A point of each hull, their difference, and the weight of both in the nearest pair.
#[derive(Debug, Clone, Copy, Default)]
pub struct SimplexCorner {
    pub point_of_a: usize,
    pub point_of_b: usize,
    pub weight: f64,
    difference: DVec3,
}

/// Bounds the distance between the convex hulls of two non-empty sets of points. The search ends as
/// soon as the bound exceeds `limit` or is within `tolerance` of the distance.
pub fn hull_distance(a: &[DVec3], b: &[DVec3], limit: f64, tolerance: f64) -> HullDistance {
    let (mut simplex, mut count) = ([SimplexCorner::default(); 4], 1);
    simplex[0] = SimplexCorner { point_of_a: 0, point_of_b: 0, weight: 1.0, difference: a[0] - b[0] };
    let mut nearest = simplex[0].difference;
    let mut bound = 0.0_f64;
    for _ in 0..MAX_GJK_ROUNDS {
        let length = nearest.length();
        if length <= tolerance {
            break;
        }
        let direction = nearest / length;
        let (i, low) = support_point(a, direction);
        let (j, high) = support_point(b, -direction);
        bound = bound.max(low + high);
        let is_known = simplex[..count].iter().any(|corner| (corner.point_of_a, corner.point_of_b) == (i, j));
        if bound > limit || length - bound <= tolerance.max(MAX_RELATIVE_GAP * length) || is_known || count == 4 {
            break;
        }
        simplex[count] = SimplexCorner { point_of_a: i, point_of_b: j, weight: 0.0, difference: a[i] - b[j] };
        count += 1;
        let Some(next) = reduce_simplex(&mut simplex, &mut count) else { break };
        nearest = next;
    }
    HullDistance { lower_bound: bound, corners: simplex, corner_count: count }
}

/// Returns the first point with the smallest product with a direction, and the product.
fn support_point(points: &[DVec3], direction: DVec3) -> (usize, f64) {
    let mut found = (0, f64::INFINITY);
    for (k, point) in points.iter().enumerate() {
        let along = point.dot(direction);
        if along < found.1 {
            found = (k, along);
        }
    }
    found
}

/// Reduces a simplex to its face nearest to the origin, and returns that face's nearest point. It
/// sets the weights of the face's corners. It tests only faces with the last corner, because
/// earlier rounds have tested the others. Returns `None` if all of them are degenerate.
fn reduce_simplex(simplex: &mut [SimplexCorner; 4], count: &mut usize) -> Option<DVec3> {
    let last = *count - 1;
    let mut best: Option<(f64, DVec3, usize, [f64; 4])> = None;
    for face in (0..1_usize << last).map(|others| others | 1 << last) {
        let Some((point, weights)) = nearest_to_origin_on_face(simplex, face) else { continue };
        let square = point.length_squared();
        if best.is_none_or(|best| square < best.0) {
            best = Some((square, point, face, weights));
        }
    }
    let (_, point, face, weights) = best?;
    let mut kept = 0;
    for k in (0..*count).filter(|k| face >> k & 1 == 1) {
        simplex[kept] = SimplexCorner { weight: weights[k], ..simplex[k] };
        kept += 1;
    }
    *count = kept;
    Some(point)
}

/// Projects the origin onto the affine hull of a face's corners. Returns the projection and its
/// weights if it lies within the face.
fn nearest_to_origin_on_face(simplex: &[SimplexCorner; 4], face: usize) -> Option<(DVec3, [f64; 4])> {
    let (mut corners, mut size) = ([0; 4], 0);
    for k in (0..4).filter(|k| face >> k & 1 == 1) {
        corners[size] = k;
        size += 1;
    }
    let base = simplex[corners[0]].difference;
    let edge = |k: usize| simplex[corners[k]].difference - base;
    // Solves for the shares in base + sum of share times edge that make the sum perpendicular to
    // all edges.
    let mut shares = [0.0; 3];
    match size {
        1 => {}
        2 => shares[0] = -base.dot(edge(1)) / edge(1).length_squared(),
        3 => {
            let (e, f) = (edge(1), edge(2));
            let (ee, ef, ff, be, bf) = (e.dot(e), e.dot(f), f.dot(f), base.dot(e), base.dot(f));
            let area = ee * ff - ef * ef;
            (shares[0], shares[1]) = ((ef * bf - ff * be) / area, (ef * be - ee * bf) / area);
        }
        _ => shares = (DMat3::from_cols(edge(1), edge(2), edge(3)).inverse() * -base).to_array(),
    }
    let rest = 1.0 - shares.iter().sum::<f64>();
    let inside = rest >= 0.0 && shares.iter().all(|&share| share >= 0.0 && share.is_finite());
    inside.then(|| {
        let mut weights = [0.0; 4];
        weights[corners[0]] = rest;
        let mut point = base;
        for k in 1..size {
            weights[corners[k]] = shares[k - 1];
            point += shares[k - 1] * edge(k);
        }
        (point, weights)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn random_points(random: &mut fastrand::Rng, count: usize, flat: usize, centre: DVec3) -> Vec<DVec3> {
        let mut number = || 2.0 * random.f64() - 1.0;
        let axes = [0; 3].map(|_| DVec3::from_array([0; 3].map(|_| number())));
        (0..count).map(|_| centre + axes[..flat].iter().map(|&axis| number() * axis).sum::<DVec3>()).collect()
    }

    /// For hulls of every dimension: no pair of convex combinations is closer than the bound, and
    /// the pair given by the weights attains it.
    #[test]
    fn bounds_are_valid_and_sharp() {
        let mut random = fastrand::Rng::with_seed(7);
        let mut apart = 0;
        for k in 0..4000 {
            let away = DVec3::new(3.0 * random.f64(), random.f64(), random.f64());
            let a = random_points(&mut random, 1 + k % 17, k % 4, DVec3::ZERO);
            let b = random_points(&mut random, 1 + k / 17 % 9, k / 4 % 4, away);
            let found = hull_distance(&a, &b, f64::INFINITY, 1e-12);
            let pair: DVec3 = found.corners[..found.corner_count]
                .iter()
                .map(|corner| corner.weight * (a[corner.point_of_a] - b[corner.point_of_b]))
                .sum();
            let weights: f64 = found.corners[..found.corner_count].iter().map(|corner| corner.weight).sum();
            assert!((weights - 1.0).abs() < 1e-9 || found.corner_count == 1, "{k}: {weights}");
            if found.lower_bound > 0.0 {
                apart += 1;
                assert!(
                    (pair.length() - found.lower_bound).abs() <= 1e-7,
                    "{k}: {} {}",
                    pair.length(),
                    found.lower_bound
                );
            } else {
                assert!(pair.length() <= 1e-6, "{k}: {}", pair.length());
            }
            for _ in 0..50 {
                let mut within = |points: &[DVec3]| {
                    let weights: Vec<f64> = points.iter().map(|_| random.f64().powi(4)).collect();
                    let sum: f64 = weights.iter().sum();
                    points.iter().zip(&weights).map(|(&point, &weight)| weight / sum * point).sum::<DVec3>()
                };
                assert!(within(&a).distance(within(&b)) >= found.lower_bound - 1e-13, "{k}");
            }
        }
        assert!(apart > 1000);
    }
}
