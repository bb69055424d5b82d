//! Intersections of two plane segments, by subdivision with proofs.
//!
//! The longer part of a pair is halved until the pair satisfies one of these:
//!
//! - It is separated: the boxes are disjoint, along the axes or along either chord (the fat line of
//!   Sederberg and Nishita, 1990). By the convex hull property no points are lost.
//! - It crosses at most once: every leg of one control polygon turns to the same side of every leg
//!   of the other. Two common points would give both parts the same chord, which is a positive sum
//!   of legs of each, so its cross product with itself would not be 0. Newton's method then finds
//!   the crossing; otherwise the halving continues.
//! - It is so short and straight that all its points are within [`MAX_COMMON_POINT_DISTANCE`] of
//!   the other part unless the hulls are separated. The parts then touch, or cross at an angle
//!   below rounding, and the search looks for that place. Shortness alone would not suffice: beside
//!   a long segment a whole curve is short.
//!
//! Overlapping segments would be halved forever and are detected beforehand. Polynomial segments of
//! degrees n and m with more than n m common points lie on the same curve (Bézout). The common part
//! then begins and ends at ends of segments.
//!
//! Source: Hanniel and Elber, 2007, for halving that ends once at most one solution is proven.
//! Cost: at most [`MAX_PART_PAIRS_TIMES_DEGREES`] pairs of parts, O(degree^2) each.

use super::nearest::nearest_on_segment;
use super::segment_part::{SegmentPart, axis_separates_hulls, chord_direction, halve_one_of_pair};
use crate::curve::segment::{self, SegmentBuffer, point_and_derivatives};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::geom::subdivision::{BoxStack, BoxTest, Subdivision, SubdivisionLimits, subdivide};
use gusset_base::sort;

/// In a frame of size 1, boxes closer than this count as touching.
pub(super) const MAX_TOUCHING_BOX_GAP: f64 = 1.0 / (1u64 << 46) as f64;
/// Points closer than this count as common.
pub(super) const MAX_COMMON_POINT_DISTANCE: f64 = 1e-12;
/// Straight parts smaller than this are not halved.
const MIN_HALVED_PART_SIZE: f64 = 1.0 / (1u64 << 20) as f64;
/// The largest distance of the control points of a straight part from its chord. If the hulls of
/// two such parts are not separated, their nearest points are common.
const MAX_SAGITTA: f64 = 0.25 * MAX_COMMON_POINT_DISTANCE;
/// Intersections whose parameters both differ by less count as one.
pub(super) const MAX_SAME_PARAMETER_GAP: f64 = 1e-6;
/// Touches that are farther apart than this in the parameters are distinct.
const MAX_SAME_TOUCH_PARAMETER_GAP: f64 = 1e-3;
/// The maximum number of examined pairs of parts, divided by the product of the degrees.
const MAX_PART_PAIRS_TIMES_DEGREES: usize = 100_000;
/// The range to which that limit is clamped.
const MIN_AND_MAX_PART_PAIR_LIMIT: (usize, usize) = (1_000, 20_000);
/// The number of undecided pairs of segments after which further pairs get only the effort of
/// simple crossings.
const MAX_UNDECIDED_SEGMENT_PAIRS: u32 = 32;
/// The maximum number of examined pairs of parts for each further pair of segments. Simple
/// crossings need fewer.
const MAX_PART_PAIRS_AFTER_GIVING_UP: usize = 300;

/// The joints between two segments, which do not count as intersections.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct IgnoredSharedJoints {
    /// Tells whether the first segment ends where the second begins.
    pub(super) at_first_end: bool,
    /// Tells whether the first segment begins where the second ends. Both fields may be true, or
    /// neither.
    pub(super) at_first_start: bool,
}

/// The intersections of two segments, as parameters.
#[derive(Default)]
pub(super) struct SegmentIntersections {
    pub(super) parameters: Vec<[f64; 2]>,
    /// The ends of each overlap on both segments, in the direction of the first.
    pub(super) overlaps: Vec<[[f64; 2]; 2]>,
    pub(super) undecided: bool,
    /// The number of undecided pairs of segments so far.
    given_up: u32,
}

/// Finds the intersections of two segments in a frame of size 1.
pub(super) fn intersect_segments(
    a: &[DVec3],
    b: &[DVec3],
    joined: IgnoredSharedJoints,
    found: &mut SegmentIntersections,
) -> Result<()> {
    found.parameters.clear();
    found.overlaps.clear();
    found.undecided = false;
    find_overlaps(a, b, &mut found.overlaps)?;
    let degrees = (a.len() - 1) * (b.len() - 1);
    let max_pairs = if found.given_up < MAX_UNDECIDED_SEGMENT_PAIRS {
        (MAX_PART_PAIRS_TIMES_DEGREES / degrees).clamp(MIN_AND_MAX_PART_PAIR_LIMIT.0, MIN_AND_MAX_PART_PAIR_LIMIT.1)
    } else {
        MAX_PART_PAIRS_AFTER_GIVING_UP
    };
    let first = [a, b].map(|controls| SegmentPart::from_whole_segment(SegmentBuffer::new(controls)));
    let limits = SubdivisionLimits { max_depth: u32::MAX, max_boxes: usize::MAX };
    subdivide(
        &mut CrossingPairSearch {
            segments: [a, b],
            ignored_joints: joined,
            pairs_left: max_pairs,
            intersections: found,
        },
        first,
        &mut Vec::new(),
        limits,
    )?;
    found.given_up += u32::from(found.undecided);
    let overlaps = &found.overlaps;
    found.parameters.retain(|&[s, t]| {
        let at_joint = (joined.at_first_end && s > 1.0 - MAX_SAME_PARAMETER_GAP && t < MAX_SAME_PARAMETER_GAP)
            || (joined.at_first_start && s < MAX_SAME_PARAMETER_GAP && t > 1.0 - MAX_SAME_PARAMETER_GAP);
        let in_overlap =
            |o: &[[f64; 2]; 2]| is_parameter_range_inside(o[0], s, s) && is_parameter_range_inside(o[1], t, t);
        !at_joint && !overlaps.iter().any(in_overlap)
    });
    found.merge_unresolved_touches(a, b);
    Ok(())
}

struct CrossingPairSearch<'a> {
    segments: [&'a [DVec3]; 2],
    ignored_joints: IgnoredSharedJoints,
    pairs_left: usize,
    intersections: &'a mut SegmentIntersections,
}

impl Subdivision<[SegmentPart; 2], 2> for CrossingPairSearch<'_> {
    type Solution = [f64; 2];
    /// The index of the part to halve.
    type Split = usize;
    type Stop = Error;

    fn classify_box(&mut self, [p, q]: &[SegmentPart; 2]) -> Result<BoxTest<[f64; 2], usize>> {
        let Some(pairs_left) = self.pairs_left.checked_sub(1) else {
            self.intersections.undecided = true;
            return Ok(BoxTest::Empty);
        };
        self.pairs_left = pairs_left;
        if are_hulls_separated(&p.controls, &q.controls) || self.intersections.has_overlap_covering(p, q) {
            return Ok(BoxTest::Empty);
        }
        let IgnoredSharedJoints { at_first_end, at_first_start } = self.ignored_joints;
        let joint = (at_first_end && p.end_parameter == 1.0 && q.start_parameter == 0.0)
            || (at_first_start && p.start_parameter == 0.0 && q.end_parameter == 1.0);
        let once = can_cross_only_once(&p.controls, &q.controls);
        if joint && (once || has_common_direction(&p.controls, &q.controls)) {
            return Ok(BoxTest::Empty);
        }
        let [a, b] = self.segments;
        if once && let Some(at) = find_crossing_by_newton(a, b, p, q) {
            return Ok(BoxTest::Unique(at));
        }
        let sizes = [p, q].map(SegmentPart::control_box_size);
        if sizes[0].max(sizes[1]) > MIN_HALVED_PART_SIZE || ![p, q].into_iter().all(is_part_straight) {
            return Ok(BoxTest::Undecided(usize::from(sizes[0] < sizes[1])));
        }
        if joint {
            return Ok(BoxTest::Empty);
        }
        Ok(find_touch(a, b, p, q).map_or(BoxTest::Unresolved, BoxTest::Unique))
    }

    fn record_solution(&mut self, _: [SegmentPart; 2], at: [f64; 2]) -> Result<()> {
        self.intersections.add_crossing(at)
    }

    fn record_unresolved(&mut self, _: [SegmentPart; 2], _: bool) -> Result<()> {
        self.intersections.undecided = true;
        Ok(())
    }

    fn split_box(&mut self, pair: [SegmentPart; 2], number: usize) -> [[SegmentPart; 2]; 2] {
        halve_one_of_pair(pair, number)
    }

    fn reserve_stack(stack: &mut BoxStack<[SegmentPart; 2]>) -> Result<()> {
        alloc::reserve(stack, 2)
    }
}

/// Returns true if one range of parameters lies in another, in either direction, within a
/// tolerance.
fn is_parameter_range_inside(range: [f64; 2], from: f64, to: f64) -> bool {
    range[0].min(range[1]) - 4.0 * MAX_SAME_PARAMETER_GAP <= from
        && to <= range[0].max(range[1]) + 4.0 * MAX_SAME_PARAMETER_GAP
}

impl SegmentIntersections {
    fn has_overlap_covering(&self, p: &SegmentPart, q: &SegmentPart) -> bool {
        self.overlaps.iter().any(|o| {
            is_parameter_range_inside(o[0], p.start_parameter, p.end_parameter)
                && is_parameter_range_inside(o[1], q.start_parameter, q.end_parameter)
        })
    }

    fn add_crossing(&mut self, at: [f64; 2]) -> Result<()> {
        let same = |old: &[f64; 2]| {
            (old[0] - at[0]).abs() <= MAX_SAME_PARAMETER_GAP && (old[1] - at[1]).abs() <= MAX_SAME_PARAMETER_GAP
        };
        if self.parameters.iter().any(same) { Ok(()) } else { alloc::push(&mut self.parameters, at) }
    }

    /// Merges intersections between which the segments stay together, because they touch too
    /// closely to resolve. Keeps the middle one.
    fn merge_unresolved_touches(&mut self, a: &[DVec3], b: &[DVec3]) {
        sort::sort_stable(&mut self.parameters, &|x, y| x[0].total_cmp(&y[0]));
        let together = |x: [f64; 2], y: [f64; 2]| {
            let middle = segment::point_at(a, 0.5 * (x[0] + y[0]));
            (x[0] - y[0]).abs().max((x[1] - y[1]).abs()) <= MAX_SAME_TOUCH_PARAMETER_GAP
                && nearest_on_segment(b, middle).1 <= MAX_COMMON_POINT_DISTANCE * MAX_COMMON_POINT_DISTANCE
        };
        let mut kept = 0;
        let mut rest = 0..self.parameters.len();
        while let Some(i) = rest.next() {
            let first = self.parameters[i];
            let mut last = first;
            while !rest.is_empty() && together(last, self.parameters[rest.start]) {
                last = self.parameters[rest.start];
                rest.start += 1;
            }
            self.parameters[kept] = [0.5 * (first[0] + last[0]), 0.5 * (first[1] + last[1])];
            if first != last {
                self.parameters[kept][1] =
                    snap_parameter_to_end(nearest_on_segment(b, segment::point_at(a, self.parameters[kept][0])).0);
            }
            kept += 1;
        }
        self.parameters.truncate(kept);
    }
}

/// Returns true if the hulls are separated along an axis, or along or across a chord.
fn are_hulls_separated(a: &[DVec3], b: &[DVec3]) -> bool {
    if !Aabb::from_points(a).is_within(&Aabb::from_points(b), MAX_TOUCHING_BOX_GAP) {
        return true;
    }
    [chord_direction(a), chord_direction(b)].into_iter().any(|chord| {
        let across = DVec3::new(-chord.y, chord.x, 0.0);
        chord != DVec3::ZERO
            && (axis_separates_hulls(chord, a, b, MAX_TOUCHING_BOX_GAP)
                || axis_separates_hulls(across, a, b, MAX_TOUCHING_BOX_GAP))
    })
}

/// Returns true if a part deviates from its chord by at most [`MAX_SAGITTA`].
fn is_part_straight(part: &SegmentPart) -> bool {
    let controls = &part.controls;
    let (first, along) = (controls[0], controls[controls.len() - 1] - controls[0]);
    controls.iter().all(|&p| {
        let t = ((p - first).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        // NaN if the ends coincide.
        let near = if t.is_nan() { first } else { first + along * t };
        p.distance(near) <= MAX_SAGITTA
    })
}

/// Returns the non-zero legs of a control polygon.
fn nonzero_legs(controls: &[DVec3]) -> impl Iterator<Item = DVec3> + Clone {
    controls.windows(2).map(|pair| pair[1] - pair[0]).filter(|&leg| leg != DVec3::ZERO)
}

/// Returns true if all legs of `b` turn to the same side of all legs of `a`.
fn can_cross_only_once(a: &[DVec3], b: &[DVec3]) -> bool {
    let mut side = 0.0;
    for u in nonzero_legs(a) {
        for v in nonzero_legs(b) {
            let turn = cross_z(u, v);
            if turn.abs() <= 1e-14 * u.length() * v.length() || turn * side < 0.0 {
                return false;
            }
            side = turn;
        }
    }
    side != 0.0
}

/// Returns true if some direction increases along all legs of both. One part then continues the
/// other, and they meet only in their joint.
fn has_common_direction(a: &[DVec3], b: &[DVec3]) -> bool {
    let along = chord_direction(a) + chord_direction(b);
    nonzero_legs(a).chain(nonzero_legs(b)).all(|leg| leg.dot(along) > 0.0)
}

fn cross_z(u: DVec3, v: DVec3) -> f64 {
    u.x * v.y - u.y * v.x
}

/// Returns the solution (s, t) of two linear equations, if it exists.
fn solve_two_equations(rows: [[f64; 2]; 2], right_side: [f64; 2]) -> Option<[f64; 2]> {
    let [[a, b], [c, d]] = rows;
    let determinant = a * d - b * c;
    let x =
        [(right_side[0] * d - b * right_side[1]) / determinant, (a * right_side[1] - right_side[0] * c) / determinant];
    x.iter().all(|x| x.is_finite()).then_some(x)
}

/// Returns the crossing of two parts, by Newton's method for A(s) = B(t) from the middle. Returns
/// `None` if it leads outside the parts.
fn find_crossing_by_newton(a: &[DVec3], b: &[DVec3], p: &SegmentPart, q: &SegmentPart) -> Option<[f64; 2]> {
    let (mut s, mut t) = (p.middle_parameter(), q.middle_parameter());
    for _ in 0..30 {
        let ([at, u, _], [bt, v, _]) = (point_and_derivatives::<3>(a, s), point_and_derivatives::<3>(b, t));
        let gap = bt - at;
        let [ds, dt] = solve_two_equations([[u.x, -v.x], [u.y, -v.y]], [gap.x, gap.y])?;
        let (next_s, next_t) =
            ((s + ds).clamp(p.start_parameter, p.end_parameter), (t + dt).clamp(q.start_parameter, q.end_parameter));
        let moved = (next_s - s).abs().max((next_t - t).abs());
        (s, t) = (next_s, next_t);
        if moved <= 2.0 * f64::EPSILON {
            break;
        }
    }
    let near = segment::point_at(a, s).distance(segment::point_at(b, t)) <= 4.0 * MAX_TOUCHING_BOX_GAP;
    near.then(|| [s, t].map(snap_parameter_to_end))
}

/// Snaps a parameter to 0 or 1 within rounding.
fn snap_parameter_to_end(t: f64) -> f64 {
    if t < 1e-14 {
        0.0
    } else if t > 1.0 - 1e-14 {
        1.0
    } else {
        t
    }
}

/// Returns the place where two short parts touch. Applies Newton's method to A' x B' = 0 and (A -
/// B) . A' = 0, or else alternates between nearest points of both.
fn find_touch(a: &[DVec3], b: &[DVec3], p: &SegmentPart, q: &SegmentPart) -> Option<[f64; 2]> {
    let start = [p.middle_parameter(), q.middle_parameter()];
    let reach = 8.0 * (p.end_parameter - p.start_parameter).max(q.end_parameter - q.start_parameter);
    let common =
        |s: f64, t: f64| segment::point_at(a, s).distance(segment::point_at(b, t)) <= MAX_COMMON_POINT_DISTANCE;
    let [mut s, mut t] = start;
    for _ in 0..8 {
        let ([at, u, u2], [bt, v, v2]) = (point_and_derivatives::<3>(a, s), point_and_derivatives::<3>(b, t));
        let gap = at - bt;
        let rows = [[cross_z(u2, v), cross_z(u, v2)], [u.dot(u) + gap.dot(u2), -v.dot(u)]];
        let Some([ds, dt]) = solve_two_equations(rows, [-cross_z(u, v), -gap.dot(u)]) else { break };
        (s, t) = ((s + ds).clamp(0.0, 1.0), (t + dt).clamp(0.0, 1.0));
    }
    if (s - start[0]).abs().max((t - start[1]).abs()) <= reach && common(s, t) {
        return Some([snap_parameter_to_end(s), snap_parameter_to_end(t)]);
    }
    let [mut s, mut t] = start;
    for _ in 0..4 {
        t = nearest_on_segment(b, segment::point_at(a, s)).0;
        s = nearest_on_segment(a, segment::point_at(b, t)).0;
    }
    let stays = (s - start[0]).abs().max((t - start[1]).abs()) <= reach;
    (stays && common(s, t)).then(|| [snap_parameter_to_end(s), snap_parameter_to_end(t)])
}

/// Finds the common parts of segments that lie on the same curve.
fn find_overlaps(a: &[DVec3], b: &[DVec3], found: &mut Vec<[[f64; 2]; 2]>) -> Result<()> {
    let common = |controls: &[DVec3], p: DVec3| {
        let (t, squared) = nearest_on_segment(controls, p);
        (squared <= MAX_COMMON_POINT_DISTANCE * MAX_COMMON_POINT_DISTANCE).then_some(t)
    };
    let candidates = [
        common(a, b[0]).map(|s| [s, 0.0]),
        common(a, b[b.len() - 1]).map(|s| [s, 1.0]),
        common(b, a[0]).map(|t| [0.0, t]),
        common(b, a[a.len() - 1]).map(|t| [1.0, t]),
    ];
    let (mut ends, mut count) = ([[0.0; 2]; 4], 0);
    for at in candidates.into_iter().flatten() {
        ends[count] = at;
        count += 1;
    }
    let ends = &mut ends[..count];
    sort::sort_stable(ends, &|x, y| x[0].total_cmp(&y[0]));
    // More than n m common points prove it; 64 samples are taken as enough.
    let samples = ((a.len() - 1) * (b.len() - 1)).min(64) + 1;
    for pair in ends.windows(2) {
        let ([s, t], [s1, t1]) = (pair[0], pair[1]);
        if s1 - s <= 4.0 * MAX_SAME_PARAMETER_GAP {
            continue;
        }
        let between = |k: usize| segment::point_at(a, s + (s1 - s) * k as f64 / (samples + 1) as f64);
        if (1..=samples).all(|k| common(b, between(k)).is_some()) {
            alloc::push(found, [[s, s1], [t, t1]])?;
        }
    }
    Ok(())
}

/// Returns true if no two points of the segment coincide: all legs of its control polygon advance
/// along its chord.
pub(super) fn advances_along_chord(controls: &[DVec3]) -> bool {
    let chord = controls[controls.len() - 1] - controls[0];
    nonzero_legs(controls).all(|leg| leg.dot(chord) > 0.0)
}
