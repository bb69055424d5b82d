//! A proven lower bound of the distance of two convex hulls, by the algorithm of Gilbert, Johnson
//! and Keerthi (1988, "A fast procedure for computing the distance between complex objects").
//!
//! The differences a - b of points of both have a hull whose point v nearest to the origin is
//! sought: in each round the point farthest against v joins a simplex, of which the part nearest to
//! the origin is kept. Invariant: for any v, min a . v - max b . v over |v| is a lower bound of the
//! distance, however inexact v is. O(points) a round, at most `MAX_ROUNDS`.

use glam::{DMat3, DVec3};

/// Rounds before the bound is taken as it is.
const MAX_ROUNDS: usize = 24;
/// Part of the distance by which the bound may fall short of it.
const RELATIVE_GAP: f64 = 1e-13;

/// What is known of the distance of two hulls.
#[derive(Debug, Clone, Copy)]
pub struct HullDistance {
    /// No two points of the hulls are nearer to each other, but for rounding; at least 0.
    pub bound: f64,
    /// The first `count` make up the pair of points that is nearest, or nearly.
    pub corners: [Corner; 4],
    pub count: usize,
}

/// A point of each hull, their difference, and the weight of both in the nearest pair.
#[derive(Debug, Clone, Copy, Default)]
pub struct Corner {
    pub a: usize,
    pub b: usize,
    pub weight: f64,
    difference: DVec3,
}

/// The distance of the hulls of points, none of which is empty. The search ends as soon as the
/// bound is above `limit`, or within `tolerance` of the distance.
pub fn hull_distance(a: &[DVec3], b: &[DVec3], limit: f64, tolerance: f64) -> HullDistance {
    let (mut simplex, mut count) = ([Corner::default(); 4], 1);
    simplex[0] = Corner { a: 0, b: 0, weight: 1.0, difference: a[0] - b[0] };
    let mut nearest = simplex[0].difference;
    let mut bound = 0.0_f64;
    for _ in 0..MAX_ROUNDS {
        let length = nearest.length();
        if length <= tolerance {
            break;
        }
        let direction = nearest / length;
        let (i, low) = least(a, direction);
        let (j, high) = least(b, -direction);
        bound = bound.max(low + high);
        let is_known = simplex[..count].iter().any(|corner| (corner.a, corner.b) == (i, j));
        if bound > limit || length - bound <= tolerance.max(RELATIVE_GAP * length) || is_known || count == 4 {
            break;
        }
        simplex[count] = Corner { a: i, b: j, weight: 0.0, difference: a[i] - b[j] };
        count += 1;
        let Some(next) = reduce(&mut simplex, &mut count) else { break };
        nearest = next;
    }
    HullDistance { bound, corners: simplex, count }
}

/// The first point of the least product with a direction, and that product.
fn least(points: &[DVec3], direction: DVec3) -> (usize, f64) {
    let mut found = (0, f64::INFINITY);
    for (k, point) in points.iter().enumerate() {
        let along = point.dot(direction);
        if along < found.1 {
            found = (k, along);
        }
    }
    found
}

/// Keeps the face of a simplex that is nearest to the origin, with the weights of its nearest
/// point, which is returned: among the faces of the last corner, as those of the others have been
/// seen. `None` if all of these are degenerate.
fn reduce(simplex: &mut [Corner; 4], count: &mut usize) -> Option<DVec3> {
    let last = *count - 1;
    let mut best: Option<(f64, DVec3, usize, [f64; 4])> = None;
    for face in (0..1_usize << last).map(|others| others | 1 << last) {
        let Some((point, weights)) = nearest_of_face(simplex, face) else { continue };
        let square = point.length_squared();
        if best.is_none_or(|best| square < best.0) {
            best = Some((square, point, face, weights));
        }
    }
    let (_, point, face, weights) = best?;
    let mut kept = 0;
    for k in (0..*count).filter(|k| face >> k & 1 == 1) {
        simplex[kept] = Corner { weight: weights[k], ..simplex[k] };
        kept += 1;
    }
    *count = kept;
    Some(point)
}

/// The point nearest to the origin of the flat through some corners, if it is among them.
fn nearest_of_face(simplex: &[Corner; 4], face: usize) -> Option<(DVec3, [f64; 4])> {
    let (mut members, mut size) = ([0; 4], 0);
    for k in (0..4).filter(|k| face >> k & 1 == 1) {
        members[size] = k;
        size += 1;
    }
    let base = simplex[members[0]].difference;
    let edge = |k: usize| simplex[members[k]].difference - base;
    // base + sum of shares times edges, across all edges.
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
        weights[members[0]] = rest;
        let mut point = base;
        for k in 1..size {
            weights[members[k]] = shares[k - 1];
            point += shares[k - 1] * edge(k);
        }
        (point, weights)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cloud(random: &mut fastrand::Rng, count: usize, flat: usize, centre: DVec3) -> Vec<DVec3> {
        let mut number = || 2.0 * random.f64() - 1.0;
        let axes = [0; 3].map(|_| DVec3::from_array([0; 3].map(|_| number())));
        (0..count).map(|_| centre + axes[..flat].iter().map(|&axis| number() * axis).sum::<DVec3>()).collect()
    }

    /// Of hulls of all dimensions: no pair of combinations of points is nearer than the bound, and
    /// the pair that the weights give is as near as the bound says.
    #[test]
    fn bounds_hold_and_are_sharp() {
        let mut random = fastrand::Rng::with_seed(7);
        let mut apart = 0;
        for k in 0..4000 {
            let away = DVec3::new(3.0 * random.f64(), random.f64(), random.f64());
            let a = cloud(&mut random, 1 + k % 17, k % 4, DVec3::ZERO);
            let b = cloud(&mut random, 1 + k / 17 % 9, k / 4 % 4, away);
            let found = hull_distance(&a, &b, f64::INFINITY, 1e-12);
            let pair: DVec3 =
                found.corners[..found.count].iter().map(|corner| corner.weight * (a[corner.a] - b[corner.b])).sum();
            let weights: f64 = found.corners[..found.count].iter().map(|corner| corner.weight).sum();
            assert!((weights - 1.0).abs() < 1e-9 || found.count == 1, "{k}: {weights}");
            if found.bound > 0.0 {
                apart += 1;
                assert!((pair.length() - found.bound).abs() <= 1e-7, "{k}: {} {}", pair.length(), found.bound);
            } else {
                assert!(pair.length() <= 1e-6, "{k}: {}", pair.length());
            }
            for _ in 0..50 {
                let mut within = |points: &[DVec3]| {
                    let weights: Vec<f64> = points.iter().map(|_| random.f64().powi(4)).collect();
                    let sum: f64 = weights.iter().sum();
                    points.iter().zip(&weights).map(|(&point, &weight)| weight / sum * point).sum::<DVec3>()
                };
                assert!(within(&a).distance(within(&b)) >= found.bound - 1e-13, "{k}");
            }
        }
        assert!(apart > 1000);
    }
}
