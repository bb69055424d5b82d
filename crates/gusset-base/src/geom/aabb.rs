//! Axis-aligned bounding boxes, and ranges of numbers.
//!
//! The low corner of the empty box is +infinity and its high corner -infinity. It is therefore
//! neutral in unions and infinitely far from every point.

use glam::DVec3;
use std::borrow::Borrow;

/// An axis-aligned box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aabb {
    pub low: DVec3,
    pub high: DVec3,
}

impl Aabb {
    pub const EMPTY: Aabb = Aabb { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// Returns the bounding box of points, which are added in order. A NaN coordinate discards the
    /// extent found so far along its axis.
    #[inline]
    pub fn from_points(points: impl IntoIterator<Item = impl Borrow<DVec3>>) -> Self {
        points.into_iter().fold(Self::EMPTY, |whole, point| whole.extended_to_point(*point.borrow()))
    }

    #[inline]
    fn extended_to_point(self, point: DVec3) -> Self {
        Aabb { low: self.low.min(point), high: self.high.max(point) }
    }

    #[inline]
    pub fn add(&mut self, point: DVec3) {
        *self = self.extended_to_point(point);
    }

    #[inline]
    pub fn union(self, other: Aabb) -> Aabb {
        Aabb { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Moves every side outwards by the given distance.
    #[inline]
    pub fn grown_by(self, by: f64) -> Aabb {
        Aabb { low: self.low - by, high: self.high + by }
    }

    /// Returns the Minkowski sum: all sums of a point of each box.
    #[inline]
    pub fn minkowski_sum(self, other: Aabb) -> Aabb {
        Aabb { low: self.low + other.low, high: self.high + other.high }
    }

    /// Returns true for the empty box.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.low.x > self.high.x
    }

    #[inline]
    pub fn size(&self) -> DVec3 {
        self.high - self.low
    }

    /// Returns the distance between opposite corners.
    #[inline]
    pub fn diagonal(&self) -> f64 {
        self.low.distance(self.high)
    }

    #[inline]
    pub fn centre(&self) -> DVec3 {
        self.low.midpoint(self.high)
    }

    /// Returns an upper bound of the length of every vector in the box.
    #[inline]
    pub fn max_vector_length(&self) -> f64 {
        self.low.abs().max(self.high.abs()).length()
    }

    /// Returns true if the boxes have a point in common.
    #[inline]
    pub fn overlaps(&self, other: &Aabb) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }

    /// Returns the distance of a point from the box along each axis, 0 where the point is within
    /// the box's range.
    #[inline]
    pub fn axis_distances(&self, point: DVec3) -> DVec3 {
        (self.low - point).max(point - self.high).max(DVec3::ZERO)
    }

    /// Returns the squared distance to a point; infinite for the empty box.
    #[inline]
    pub fn distance_squared(&self, point: DVec3) -> f64 {
        self.axis_distances(point).length_squared()
    }

    /// Returns the gap between the boxes along each axis, negative where they overlap.
    #[inline]
    pub fn axis_gaps(&self, other: &Aabb) -> DVec3 {
        (self.low - other.high).max(other.low - self.high)
    }

    /// Returns true if the gap between the boxes is at most `slack` along every axis.
    #[inline]
    pub fn is_within(&self, other: &Aabb, slack: f64) -> bool {
        self.axis_gaps(other).max_element() <= slack
    }

    /// Returns the distance between the boxes, 0 if they overlap.
    #[inline]
    pub fn distance(&self, other: &Aabb) -> f64 {
        self.axis_gaps(other).max(DVec3::ZERO).length()
    }
}

/// Returns the minimum and maximum of some numbers; [infinity, -infinity] if there are none. Skips
/// NaN.
#[inline(always)]
pub fn range_of_values(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    values.into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_point() -> impl Strategy<Value = DVec3> {
        (-3i8..4, -3i8..4, -3i8..4).prop_map(|(x, y, z)| DVec3::new(x.into(), y.into(), z.into()))
    }

    fn grid_points(whole: &Aabb) -> Vec<DVec3> {
        let along = |axis: usize| (whole.low[axis] as i32..=whole.high[axis] as i32).map(f64::from);
        along(0).flat_map(|x| along(1).flat_map(move |y| along(2).map(move |z| DVec3::new(x, y, z)))).collect()
    }

    proptest! {
        /// Compares with brute force over all points of small boxes on a lattice.
        #[test]
        fn distances_agree_with_brute_force(
            p in prop::collection::vec(any_point(), 1..4), q in prop::collection::vec(any_point(), 1..4), query in any_point(),
        ) {
            let (a, b) = (Aabb::from_points(&p), Aabb::from_points(&q));
            let (of_a, of_b) = (grid_points(&a), grid_points(&b));
            let least = |squares: &mut dyn Iterator<Item = f64>| squares.fold(f64::INFINITY, f64::min);
            let to_point = least(&mut of_a.iter().map(|x| x.distance_squared(query)));
            prop_assert_eq!(a.distance_squared(query), to_point);
            let between = least(&mut of_a.iter().flat_map(|x| of_b.iter().map(|y| x.distance_squared(*y))));
            prop_assert_eq!(a.distance(&b), between.sqrt());
            prop_assert_eq!(a.overlaps(&b), between == 0.0);
            prop_assert_eq!(a.axis_gaps(&b).max_element() <= 0.0, between == 0.0);
            prop_assert_eq!(a.union(b), Aabb::from_points(p.iter().chain(&q)));
            prop_assert_eq!(a.minkowski_sum(b), Aabb::from_points(of_a.iter().flat_map(|&x| of_b.iter().map(move |&y| x + y))));
            prop_assert_eq!(a.max_vector_length(), of_a.iter().map(|x| x.length()).fold(0.0, f64::max));
            prop_assert_eq!(grid_points(&a.grown_by(1.0)).len() as f64, (a.size() + 3.0).element_product());
        }
    }

    #[test]
    fn the_empty_box_is_neutral() {
        let one = Aabb::from_points([DVec3::X]);
        assert!(Aabb::EMPTY.is_empty() && !one.is_empty() && !one.overlaps(&Aabb::EMPTY));
        assert_eq!(Aabb::EMPTY.union(one), one);
        assert_eq!(Aabb::EMPTY.distance_squared(DVec3::ONE), f64::INFINITY);
        assert_eq!(one.diagonal(), 0.0);
        assert_eq!(range_of_values([2.0, f64::NAN, -1.0]), [-1.0, 2.0]);
        assert_eq!(range_of_values([]), [f64::INFINITY, f64::NEG_INFINITY]);
    }
}
