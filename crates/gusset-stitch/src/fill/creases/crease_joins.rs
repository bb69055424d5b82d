//! Matches crease ends: a curve joins two ends, and a star joins three or more at a point.
//!
//! Finds the non-crossing matching of least cost, in the order of the rim. A curve costs the
//! bending of a thin rod, plus the squared angles between the surfaces beside it. The bending is
//! a^2 + a b + b^2 for the turns a and b from the end tangents to the chord (opposite for an arc).
//! A star costs the squared angles by which the creases miss its centre, plus the squared angles
//! between the surfaces. An unmatched end has a fixed cost.

use super::super::patch_rim::PatchRim;
use super::crease_curve::{angle_between, tangent_of_circle};
use super::crease_ends::CreaseEnd;
use glam::{DMat3, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;

/// Largest number of ends that are treated as creases.
const MAX_MATCHED_CREASE_ENDS: usize = 24;
/// Largest number of ends among which stars are looked for.
const MAX_STAR_ENDS: usize = 12;
/// The cost of an unmatched end.
const UNMATCHED_END_COST: f64 = 0.6;
/// Largest angle between a curve's end tangent and its chord, in radians.
const MAX_TANGENT_CHORD_RADIANS: f64 = 1.3;
/// Largest angle between the surfaces on the two ends of a curve, or between two arms, in radians.
const MAX_SURFACE_MISFIT_RADIANS: f64 = 0.7;
/// Largest angle by which a crease may miss the centre of its star, in radians.
const MAX_STAR_MISS_RADIANS: f64 = 0.25;

/// Lines are parallel if the determinant of their normal matrix is at most this.
const MIN_CROSSING_DETERMINANT: f64 = 0.02;

/// Number of rounds of reweighted least squares.
const MAX_REWEIGHTING_ROUNDS: u32 = 8;
/// A line misses a point only if its distance exceeds this fraction of the distance to its tip.
const MIN_MISS_TO_TIP_DISTANCE_RATIO: f64 = 1e-3;

/// Crease ends that belong together.
pub(super) enum CreaseJoin {
    Pair([usize; 2]),
    /// The arms are in the order of the rim.
    Star {
        centre: DVec3,
        arms: Vec<usize>,
    },
}

/// Returns the best way to join ends, which are in the order of the rim. For m ends: O(m^3), and
/// O(m^6) if stars are looked for.
pub(super) fn match_crease_ends(rim: &PatchRim, ends: &[CreaseEnd]) -> Result<Vec<CreaseJoin>> {
    let m = ends.len();
    if !(2..=MAX_MATCHED_CREASE_ENDS).contains(&m) {
        return Ok(Vec::new());
    }
    let mut costs = alloc::filled(f64::INFINITY, m * m)?;
    for (i, j) in (0..m).flat_map(|i| (i + 1..m).map(move |j| (i, j))) {
        costs[i * m + j] = cost_of_crease_pair(rim, &ends[i], &ends[j]);
    }
    let cost = |i: usize, j: usize| costs[i * m + j];
    let all = alloc::collect(0..m)?;
    let (mut least, pairs) = best_non_crossing_matching(&all, &cost)?;
    let mut best = alloc::collect(pairs.into_iter().map(CreaseJoin::Pair))?;
    if m > MAX_STAR_ENDS {
        return Ok(best);
    }
    for (i, j, k) in index_triples(m) {
        let Some((own, centre, arms)) = find_star(rim, ends, [i, j, k])? else {
            continue;
        };
        let (mut sum, mut joins) = (own, Vec::new());
        for (a, &arm) in arms.iter().enumerate() {
            let next = arms[(a + 1) % arms.len()];
            let gap = (1..m).map(|k| (arm + k) % m).take_while(|&end| end != next);
            let mut gap = alloc::gather(gap)?;
            gap.sort_unstable();
            let (cost, pairs) = best_non_crossing_matching(&gap, &cost)?;
            sum += cost;
            alloc::extend(&mut joins, pairs.into_iter().map(CreaseJoin::Pair))?;
        }
        if sum < least {
            alloc::push(&mut joins, CreaseJoin::Star { centre, arms })?;
            (least, best) = (sum, joins);
        }
    }
    Ok(best)
}

fn index_triples(m: usize) -> impl Iterator<Item = (usize, usize, usize)> {
    (0..m).flat_map(move |i| (i + 1..m).flat_map(move |j| (j + 1..m).map(move |k| (i, j, k))))
}

/// Returns the non-crossing pairs of least cost, and that cost plus the cost of the unmatched ends.
fn best_non_crossing_matching(ends: &[usize], cost: &impl Fn(usize, usize) -> f64) -> Result<(f64, Vec<[usize; 2]>)> {
    let n = ends.len();
    // For the ends i to k - 1: the least cost, and the partner of i, or i itself.
    let mut cells = alloc::filled((0.0, 0usize), (n + 1) * (n + 1))?;
    let at = |i: usize, k: usize| i * (n + 1) + k;
    for i in (0..n).rev() {
        for k in i + 1..=n {
            let mut best = (UNMATCHED_END_COST + cells[at(i + 1, k)].0, i);
            for j in i + 1..k {
                let sum = cost(ends[i], ends[j]) + cells[at(i + 1, j)].0 + cells[at(j + 1, k)].0;
                if sum < best.0 {
                    best = (sum, j);
                }
            }
            cells[at(i, k)] = best;
        }
    }
    let (mut pairs, mut open) = (Vec::new(), vec![(0, n)]);
    while let Some((i, k)) = open.pop() {
        if i < k {
            let j = cells[at(i, k)].1;
            if j != i {
                alloc::push(&mut pairs, [ends[i], ends[j]])?;
                alloc::push(&mut open, (j + 1, k))?;
            }
            alloc::push(&mut open, (i + 1, if j == i { k } else { j }))?;
        }
    }
    Ok((cells[at(0, n)].0, pairs))
}

/// Returns the unit end tangents of the curve between two ends, pointing inwards along the curve.
pub(super) fn end_tangents(rim: &PatchRim, [i, j]: [&CreaseEnd; 2]) -> [DVec3; 2] {
    let [p, q] = [i, j].map(|end| rim.points[end.tip_vertex]);
    [tangent_of_circle(i.point_before_tip, p, q), tangent_of_circle(j.point_before_tip, q, p)]
}

fn cost_of_crease_pair(rim: &PatchRim, i: &CreaseEnd, j: &CreaseEnd) -> f64 {
    let chord = (rim.points[j.tip_vertex] - rim.points[i.tip_vertex]).normalize_or_zero();
    let [leaves, returns] = end_tangents(rim, [i, j]);
    let arrives = -returns;
    let turn = |direction: DVec3| {
        (direction - direction.dot(chord) * chord).normalize_or_zero() * angle_between(chord, direction)
    };
    let [a, b] = [leaves, arrives].map(turn);
    if a.length().max(b.length()) > MAX_TANGENT_CHORD_RADIANS {
        return f64::INFINITY;
    }
    // The surface after i continues as the surface before j.
    let misfits = [(1, 0), (0, 1)]
        .map(|(of, with)| angle_between(rotate_by_shortest_rotation(i.normals[of], leaves, arrives), j.normals[with]));
    let same_side = i.convexity() * j.convexity() > 0.0;
    if !same_side || misfits[0].max(misfits[1]) > MAX_SURFACE_MISFIT_RADIANS {
        return f64::INFINITY;
    }
    a.length_squared() + a.dot(b) + b.length_squared() + misfits.map(|angle| angle * angle).iter().sum::<f64>()
}

/// Rotates `v` by the shortest rotation that takes one unit vector to another.
fn rotate_by_shortest_rotation(v: DVec3, from: DVec3, to: DVec3) -> DVec3 {
    let (axis, cosine) = (from.cross(to), from.dot(to));
    v * cosine + axis.cross(v) + axis * (axis.dot(v) / (1.0 + cosine).max(f64::EPSILON))
}

/// Returns the cost, the centre and the arms of a star. The centre is the point nearest to the
/// lines of three ends; the arms are all ends that point at it. Returns `None` if the three ends do
/// not form a star.
fn find_star(rim: &PatchRim, ends: &[CreaseEnd], three: [usize; 3]) -> Result<Option<(f64, DVec3, Vec<usize>)>> {
    let size = Aabb::from_points(&rim.points[..rim.rim_vertex_count]).diagonal();
    let misses = |centre: DVec3, end: &CreaseEnd| {
        let way = centre - rim.points[end.tip_vertex];
        if way.length() > size { f64::INFINITY } else { angle_between(way, end.direction) }
    };
    let Some(centre) = nearest_point_to_lines(rim, &three.iter().map(|&k| &ends[k])) else {
        return Ok(None);
    };
    let arms = alloc::gather((0..ends.len()).filter(|&k| misses(centre, &ends[k]) <= MAX_STAR_MISS_RADIANS))?;
    let Some(centre) = nearest_point_to_lines(rim, &arms.iter().map(|&k| &ends[k])).filter(|_| arms.len() >= 3) else {
        return Ok(None);
    };
    let mut cost = 0.0;
    for (a, &arm) in arms.iter().enumerate() {
        let (end, next) = (&ends[arm], &ends[arms[(a + 1) % arms.len()]]);
        let (miss, misfit) = (misses(centre, end), angle_between(end.normals[1], next.normals[0]));
        if miss > MAX_STAR_MISS_RADIANS || misfit > MAX_SURFACE_MISFIT_RADIANS {
            return Ok(None);
        }
        cost += miss * miss + misfit * misfit;
    }
    Ok(Some((cost, centre, arms)))
}

/// Returns the point of least distance from the lines of the ends; `None` if they are parallel. The
/// least squares are reweighted, so that a bent crease does not draw the point away from the
/// intersection of straight creases.
fn nearest_point_to_lines<'a>(rim: &PatchRim, ends: &(impl Iterator<Item = &'a CreaseEnd> + Clone)) -> Option<DVec3> {
    let mut centre: Option<DVec3> = None;
    for _ in 0..MAX_REWEIGHTING_ROUNDS {
        let (mut matrix, mut right, mut sum) = (DMat3::ZERO, DVec3::ZERO, 0.0);
        for end in ends.clone() {
            let (p, t) = (rim.points[end.tip_vertex], end.direction);
            let off = DMat3::IDENTITY - DMat3::from_cols(t * t.x, t * t.y, t * t.z);
            let weight = centre
                .map_or(1.0, |c| 1.0 / ((off * (c - p)).length() + MIN_MISS_TO_TIP_DISTANCE_RATIO * c.distance(p)));
            matrix += off * weight;
            right += off * p * weight;
            sum += weight;
        }
        matrix *= 1.0 / sum;
        if centre.is_none() && matrix.determinant() <= MIN_CROSSING_DETERMINANT {
            return None;
        }
        centre = Some(matrix.inverse() * right / sum);
    }
    centre
}
