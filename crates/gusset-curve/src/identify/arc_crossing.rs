//! Whether the parts of two spans cross, and whether a span crosses itself.
//!
//! An arc is a part of a Bézier segment, by its control points in a plane. Arcs that a line separates do
//! not cross. The strip of an arc is parallel to its chord and contains its control points. Two arcs cross if
//! each one runs across the other one's strip, from one side to the other: within both strips they connect
//! opposite sides of a parallelogram. Other arcs are divided until one of both conditions holds, or
//! [`MAX_DIVISIONS`] times. Arcs that touch or retrace each other stay undecided, and do not cross.
//!
//! A quadratic does not cross itself. For a cubic with P(s) = P(t), s + t and s t have a closed form.

use glam::DVec2;

/// The control points of an arc.
const MAX_CONTROLS: usize = 6;
/// The shorter one of two arcs is divided at most this many times.
const MAX_DIVISIONS: u32 = 7;
/// The longer one is divided at most this many times.
const MAX_DIVISIONS_OF_LONGER: u32 = 40;
/// Only the longer one of two arcs is divided if the ratio of their squared lengths exceeds this.
const MAX_SQUARED_RATIO: f64 = 4.0;
/// The parameter at which an arc is divided. Symmetric curves may cross at 1/2.
const DIVIDING_PARAMETER: f64 = 0.4878;
/// The number of divisions after which the place of a crossing is known well enough.
const DIVISIONS_FOR_PLACE: u32 = 3;
/// An arc crosses a strip if its ends are outside by more than this, in lengths of both chords.
const MIN_CROSSING_DEPTH: f64 = 1e-9;

/// A part of a segment.
#[derive(Clone, Copy)]
pub(super) struct Arc {
    points: [DVec2; MAX_CONTROLS],
    control_point_count: usize,
    /// The positions of its ends along the spans.
    span_positions: [f64; 2],
}

/// The positions along the spans at which arcs cross in the plane.
pub(super) type Crossing = [f64; 2];

impl Arc {
    /// Returns the arc with some control points, at most 6.
    #[inline]
    pub(super) fn from_controls(controls: impl ExactSizeIterator<Item = DVec2>, range: [f64; 2]) -> Option<Arc> {
        let count = controls.len();
        let mut points = [DVec2::ZERO; MAX_CONTROLS];
        points.get_mut(..count)?.iter_mut().zip(controls).for_each(|(to, p)| *to = p);
        Some(Arc { points, control_point_count: count, span_positions: range })
    }

    /// Returns the part between two parameters, with the positions of its ends.
    #[inline]
    pub(super) fn part_between(mut self, [from, to]: [f64; 2], range: [f64; 2]) -> Arc {
        if from > 0.0 {
            self.split_off_part_before(from);
        }
        if to < 1.0 {
            self = self.split_off_part_before((to - from) / (1.0 - from));
        }
        Arc { span_positions: range, ..self }
    }

    #[inline]
    fn points(&self) -> &[DVec2] {
        &self.points[..self.control_point_count]
    }

    #[inline]
    fn first_point(&self) -> DVec2 {
        self.points[0]
    }

    #[inline]
    fn last_point(&self) -> DVec2 {
        self.points[self.control_point_count - 1]
    }

    #[inline]
    fn chord(&self) -> DVec2 {
        self.last_point() - self.first_point()
    }

    /// Keeps the part after a parameter and returns the part before it, by de Casteljau's scheme.
    #[inline]
    fn split_off_part_before(&mut self, t: f64) -> Arc {
        let mut before = *self;
        let after = &mut self.points[..before.control_point_count];
        for k in 1..after.len() {
            for i in 0..after.len() - k {
                after[i] += (after[i + 1] - after[i]) * t;
            }
            before.points[k] = after[0];
        }
        let [from, to] = self.span_positions;
        before.span_positions[1] = from + (to - from) * t;
        self.span_positions[0] = before.span_positions[1];
        before
    }

    fn divide(&self) -> [Arc; 2] {
        let mut after = *self;
        [after.split_off_part_before(DIVIDING_PARAMETER), after]
    }

    /// Returns the lowest and the highest product of the control points with a vector, relative to a point.
    #[inline]
    fn extent_along(&self, from: DVec2, along: DVec2) -> [f64; 2] {
        self.points().iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &p| {
            let x = (p - from).dot(along);
            [if x < low { x } else { low }, if x > high { x } else { high }]
        })
    }

    /// Returns the squared distance of the farthest control point from the first one.
    #[inline]
    fn squared_length(&self) -> f64 {
        self.points().iter().map(|p| p.distance_squared(self.points[0])).fold(0.0, f64::max)
    }

    /// Returns whether the control points advance along a direction.
    fn advances_along(&self, along: DVec2) -> bool {
        self.points().windows(2).all(|leg| (leg[1] - leg[0]).dot(along) >= 0.0)
    }
}

/// Searches for a crossing that is accepted.
pub(super) struct CrossingSearch<'a> {
    /// The test of a crossing by its place; without it all are accepted.
    pub(super) is_accepted_crossing: Option<&'a dyn Fn(Crossing) -> bool>,
}

impl CrossingSearch<'_> {
    /// Returns whether consecutive arcs cross each other or themselves.
    pub(super) fn do_cross_within(&self, arcs: &[Arc]) -> bool {
        (0..arcs.len()).any(|i| {
            self.crosses_itself(&arcs[i], 0)
                || (i + 1..arcs.len()).any(|j| self.do_cross(&arcs[i], &arcs[j], j == i + 1, [0, 0]))
        })
    }

    /// Returns whether arcs cross later ones. If `are_adjacent`, the last and the first share a point.
    pub(super) fn do_cross_between(&self, own: &[Arc], others: &[Arc], are_adjacent: bool) -> bool {
        own.iter().enumerate().any(|(i, a)| {
            let is_last = are_adjacent && i + 1 == own.len();
            others.iter().enumerate().any(|(j, b)| self.do_cross(a, b, is_last && j == 0, [0, 0]))
        })
    }

    /// Returns whether an arc that was divided some times crosses itself.
    fn crosses_itself(&self, arc: &Arc, divided: u32) -> bool {
        if arc.control_point_count <= 3 || divided == MAX_DIVISIONS || arc.advances_along(arc.chord()) {
            return false;
        }
        if let &[p, q, r, s] = arc.points() {
            return parameters_where_cubic_crosses_itself([p, q, r, s]).is_some_and(|parameters| {
                let [from, to] = arc.span_positions;
                self.is_accepted_crossing.is_none_or(|accepts| accepts(parameters.map(|t| from + (to - from) * t)))
            });
        }
        let ([a, b], divided) = (arc.divide(), divided + 1);
        self.do_cross(&a, &b, true, [divided; 2])
            || self.crosses_itself(&a, divided)
            || self.crosses_itself(&b, divided)
    }

    /// Returns whether two arcs that were divided some times cross.
    fn do_cross(&self, a: &Arc, b: &Arc, are_adjacent: bool, divided: [u32; 2]) -> bool {
        let relation =
            if are_adjacent { are_adjacent_separate(a, b).then_some(false) } else { do_arcs_certainly_cross(a, b) };
        match (relation, self.is_accepted_crossing) {
            (Some(false), _) => return false,
            (Some(true), None) => return true,
            (Some(true), Some(accepts)) if divided[0].min(divided[1]) >= DIVISIONS_FOR_PLACE => {
                return accepts([a, b].map(|arc| 0.5 * (arc.span_positions[0] + arc.span_positions[1])));
            }
            _ => {}
        }
        // The longer one, or both.
        let lengths = [a.squared_length(), b.squared_length()];
        let is_divided = [0, 1].map(|k| lengths[k] * MAX_SQUARED_RATIO >= lengths[1 - k]);
        let used = [0, 1].map(|k| divided[k] + u32::from(is_divided[k]));
        if used[0].min(used[1]) > MAX_DIVISIONS || used[0].max(used[1]) > MAX_DIVISIONS_OF_LONGER {
            return false;
        }
        match is_divided {
            [true, false] => {
                let [first, near] = a.divide();
                self.do_cross(&first, b, false, used) || self.do_cross(&near, b, are_adjacent, used)
            }
            [false, true] => {
                let [close, last] = b.divide();
                self.do_cross(a, &last, false, used) || self.do_cross(a, &close, are_adjacent, used)
            }
            _ => {
                let ([first, near], [close, last]) = (a.divide(), b.divide());
                self.do_cross(&first, &last, false, used)
                    || self.do_cross(&first, &close, false, used)
                    || self.do_cross(&near, &last, false, used)
                    || self.do_cross(&near, &close, are_adjacent, used)
            }
        }
    }
}

/// Returns whether a line through their common point separates two arcs: whether the vectors from the control points of
/// the first to the common point, and from there to the control points of the second, are within a half turn.
fn are_adjacent_separate(a: &Arc, b: &Arc) -> bool {
    let shared = b.first_point();
    let tangent = b.points[1] - a.points[a.control_point_count - 2];
    let (mut left, mut right) = (tangent, tangent);
    let before = a.points()[..a.control_point_count - 1].iter().map(|&p| shared - p);
    let after = b.points()[1..].iter().map(|&p| p - shared);
    let is_ahead = before.chain(after).all(|v| {
        let side = tangent.perp_dot(v);
        if side > 0.0 && left.perp_dot(v) > 0.0 {
            left = v;
        } else if side < 0.0 && right.perp_dot(v) < 0.0 {
            right = v;
        }
        side != 0.0 || tangent.dot(v) >= 0.0
    });
    is_ahead && tangent != DVec2::ZERO && right.perp_dot(left) >= 0.0
}

/// Returns false if a line separates two arcs, true if they certainly cross.
fn do_arcs_certainly_cross(a: &Arc, b: &Arc) -> Option<bool> {
    let chords = [a.chord(), b.chord()];
    let depth = MIN_CROSSING_DEPTH * (chords[0].length_squared() + chords[1].length_squared());
    let mut cross = true;
    for (own, other, chord) in [(a, b, chords[0]), (b, a, chords[1])] {
        let (from, across) = (own.first_point(), chord.perp());
        let ([low, high], [other_low, other_high]) = (own.extent_along(from, across), other.extent_along(from, across));
        if high <= other_low || other_high <= low {
            return Some(false);
        }
        let [x, y] = [other.first_point(), other.last_point()].map(|p| (p - from).dot(across));
        cross &= x.min(y) < low - depth && x.max(y) > high + depth;
    }
    if cross {
        return Some(true);
    }
    let between = b.first_point() - a.last_point();
    let (own, other) = (a.extent_along(a.last_point(), between), b.extent_along(a.last_point(), between));
    (own[1] <= other[0] && between != DVec2::ZERO).then_some(false)
}

/// Returns the parameters at which a plane cubic crosses itself.
fn parameters_where_cubic_crosses_itself([p, q, r, s]: [DVec2; 4]) -> Option<[f64; 2]> {
    let (a, b, c) = (s - p + 3.0 * (q - r), 3.0 * (p - 2.0 * q + r), 3.0 * (q - p));
    // a (s^2 + s t + t^2) + b (s + t) + c = 0, for the sum and the product of both parameters.
    let sum = -c.perp_dot(a) / b.perp_dot(a);
    let product = sum * sum + (b * sum + c).dot(a) / a.length_squared();
    let discriminant = sum * sum - 4.0 * product;
    let half = 0.5 * discriminant.sqrt();
    let parameters = [0.5 * sum - half, 0.5 * sum + half];
    (discriminant > 1e-12 && parameters[0] >= 0.0 && parameters[1] <= 1.0).then_some(parameters)
}
