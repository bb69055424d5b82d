//! The control points of a plane span, and tests of them that tell whether spans may cross.

use glam::DVec2;

/// The control points of a plane span.
pub(super) struct Hull {
    pub(super) points: [DVec2; 6],
    pub(super) len: usize,
}

impl Hull {
    fn points(&self) -> &[DVec2] {
        &self.points[..self.len]
    }

    /// Returns false if the directions of the legs are within a half turn.
    pub(super) fn may_cross_itself(&self) -> bool {
        let points = self.points();
        let legs =
            [points[1] - points[0], points[self.len / 2] - points[1], points[self.len - 1] - points[self.len - 2]];
        match self.len {
            0..=3 => false,
            // The legs in the middle agree where two quadratics meet. Two turns to opposite sides stay within a half turn.
            5 if legs[1].dot(points[3] - points[2]) > 0.0 => {
                let [first, second] = [legs[0].perp_dot(legs[1]), legs[1].perp_dot(legs[2])];
                let sum = legs[0].perp_dot(legs[2]);
                let is_smooth = legs[1].perp_dot(points[3] - points[2]).abs()
                    <= 1e-9 * legs[1].length() * points[3].distance(points[2]);
                !is_smooth || (first * second >= 0.0 && (first + second) * sum <= 0.0)
            }
            4 => has_cubic_loop([points[0], points[1], points[2], points[3]]),
            _ => true,
        }
    }

    /// Returns false if a line through the shared point separates this span from the next one.
    pub(super) fn may_cross_next(&self, next: &Hull) -> bool {
        let (own, next) = (self.points(), next.points());
        let shared = next[0];
        let separates = |n: DVec2| {
            own[..own.len() - 1].iter().all(|&p| (p - shared).dot(n) < 0.0)
                && next[1..].iter().all(|&p| (p - shared).dot(n) > 0.0)
        };
        let (back, ahead) = (own[0] - shared, next[next.len() - 1] - shared);
        let tangent = next[1] - own[own.len() - 2];
        !(separates(tangent) || separates(ahead - back) || separates(ahead * back.length() - back * ahead.length()))
    }

    /// Returns false if an axis, or the line between both spans, separates this span from one after the next.
    pub(super) fn may_cross_farther(&self, other: &Hull) -> bool {
        let [a, b] = [self, other].map(|hull| box_of(hull.points().iter().copied()));
        if do_boxes_miss(a, b) {
            return false;
        }
        let (own, other) = (self.points(), other.points());
        let (end, start) = (own[own.len() - 1], other[0]);
        let n = start - end;
        let reach = own.iter().map(|p| (p - end).dot(n)).fold(f64::NEG_INFINITY, f64::max);
        !other.iter().all(|p| (p - end).dot(n) > reach)
    }
}

/// The lowest and the highest corner of the box around points.
pub(super) fn box_of(points: impl Iterator<Item = DVec2>) -> [DVec2; 2] {
    points.fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[low, high], p| [low.min(p), high.max(p)])
}

pub(super) fn do_boxes_miss([low, high]: [DVec2; 2], [other_low, other_high]: [DVec2; 2]) -> bool {
    low.cmpgt(other_high).any() || other_low.cmpgt(high).any()
}

/// Returns whether a plane cubic crosses itself.
pub(super) fn has_cubic_loop([p, q, r, s]: [DVec2; 4]) -> bool {
    let (a, b, c) = (s - p + 3.0 * (q - r), 3.0 * (p - 2.0 * q + r), 3.0 * (q - p));
    // The sum and the product of both parameters.
    let sum = -c.perp_dot(a) / b.perp_dot(a);
    let product = sum * sum + (b * sum + c).dot(a) / a.length_squared();
    let discriminant = sum * sum - 4.0 * product;
    discriminant > 1e-12 && {
        let half = 0.5 * discriminant.sqrt();
        0.5 * sum - half >= 0.0 && 0.5 * sum + half <= 1.0
    }
}
