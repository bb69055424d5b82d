//! Boxes that contain the surface, in single precision relative to an origin close to it.
//!
//! Axis-aligned boxes are rounded outwards. Oriented boxes (Gottschalk, Lin and Manocha 1996) are
//! computed for their rounded axes, and enlarged because rounded axes are orthonormal only to 1e-7.
//! Invariant: a box contains everything it was computed for, so its distance is a lower bound. Four
//! axis-aligned boxes take 96 bytes, an oriented box 48.

use glam::{DMat3, DVec3};
use gusset_base::geom::aabb::Aabb;

/// The bounding boxes of four neighbouring blocks, side by side for vector instructions. The boxes
/// of blocks that do not exist are empty.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ChildBoxes {
    pub(super) low: [[f32; 4]; 3],
    pub(super) high: [[f32; 4]; 3],
}

/// A box with arbitrary orientation.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct OrientedBox {
    centre: [f32; 3],
    /// Two of the axes. The third is their cross product.
    axes: [[f32; 3]; 2],
    half_lengths: [f32; 3],
}

/// The largest single-precision number that is at most `value`.
fn round_down_to_f32(value: f64) -> f32 {
    let rounded = value as f32;
    if f64::from(rounded) > value { rounded.next_down() } else { rounded }
}

/// The smallest single-precision number that is at least `value`.
fn round_up_to_f32(value: f64) -> f32 {
    let rounded = value as f32;
    if f64::from(rounded) < value { rounded.next_up() } else { rounded }
}

/// Converts to double precision.
#[inline(always)]
fn to_double_precision(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}

impl ChildBoxes {
    pub(crate) const EMPTY: ChildBoxes = ChildBoxes { low: [[f32::INFINITY; 4]; 3], high: [[f32::NEG_INFINITY; 4]; 3] };

    /// Sets one of the four boxes. `bounds` is relative to the index's origin.
    pub(crate) fn set_child_box(&mut self, child: usize, bounds: Aabb) {
        for (axis, (low, high)) in bounds.low.to_array().into_iter().zip(bounds.high.to_array()).enumerate() {
            self.low[axis][child] = round_down_to_f32(low);
            self.high[axis][child] = round_up_to_f32(high);
        }
    }

    /// One of the four boxes.
    pub(crate) fn child_box(&self, child: usize) -> Aabb {
        Aabb {
            low: to_double_precision(self.low.map(|axis| axis[child])),
            high: to_double_precision(self.high.map(|axis| axis[child])),
        }
    }

    /// The union of all four boxes.
    pub(crate) fn union_of_children(&self) -> Aabb {
        (0..4).map(|child| self.child_box(child)).fold(Aabb::EMPTY, Aabb::union)
    }

    /// The range of the products of points of each box with a nonzero direction. For an empty box,
    /// the smallest product is infinite.
    #[inline(always)]
    pub(crate) fn product_ranges_with_direction(&self, direction: DVec3) -> [[f64; 2]; 4] {
        let mut ranges = [[0.0; 2]; 4];
        for (axis, by) in direction.to_array().into_iter().enumerate().filter(|&(_, by)| by != 0.0) {
            let (low, high) = (&self.low[axis], &self.high[axis]);
            let (from, to) = if by > 0.0 { (low, high) } else { (high, low) };
            for (child, range) in ranges.iter_mut().enumerate() {
                range[0] += by * f64::from(from[child]);
                range[1] += by * f64::from(to[child]);
            }
        }
        ranges
    }

    /// The squared distances of a point from the four boxes; infinite for empty ones.
    #[inline(always)]
    pub(crate) fn distances_squared(&self, point: DVec3) -> [f64; 4] {
        let mut sums = [0.0; 4];
        for (axis, at) in point.to_array().into_iter().enumerate() {
            for (child, sum) in sums.iter_mut().enumerate() {
                let (low, high) = (f64::from(self.low[axis][child]), f64::from(self.high[axis][child]));
                let outside = (low - at).max(at - high).max(0.0);
                *sum += outside * outside;
            }
        }
        sums
    }

    /// [`ChildBoxes::distances_squared`] in single precision, accurate to a few units in the last
    /// place for the rounded point.
    #[inline(always)]
    pub(crate) fn distances_squared_in_single_precision(&self, point: [f32; 3]) -> [f32; 4] {
        // Unlike `f32::max`, this ignores NaN rules and is a single instruction.
        let max = |a: f32, b: f32| if a > b { a } else { b };
        let mut sums = [0.0; 4];
        for (axis, at) in point.into_iter().enumerate() {
            for (child, sum) in sums.iter_mut().enumerate() {
                let (low, high) = (self.low[axis][child], self.high[axis][child]);
                let outside = max(max(low - at, at - high), 0.0);
                *sum += outside * outside;
            }
        }
        sums
    }
}

impl OrientedBox {
    /// Creates a box that contains all points plus any vector of `padding`, with axes along two
    /// directions of the surface.
    pub(crate) fn from_points(points: &[DVec3], along_u: DVec3, along_v: DVec3, padding: Aabb) -> OrientedBox {
        let single = |v: DVec3| v.to_array().map(|x| x as f32);
        // The cross product of nearly parallel directions, as for a block that closes, is dominated
        // by rounding, and not perpendicular to them.
        let first = along_u.try_normalize().unwrap_or(DVec3::X);
        let across = along_v.try_normalize().map_or(DVec3::ZERO, |second| first.cross(second));
        let normal = if across.length() > 1e-4 { across.normalize() } else { first.any_orthonormal_vector() };
        let second = normal.cross(first);
        let mut oriented =
            OrientedBox { centre: [0.0; 3], axes: [single(first), single(second)], half_lengths: [0.0; 3] };
        // The box is computed for the axes in use, which are rounded.
        let axes = oriented.axes_as_rows();
        let bounds = Aabb::from_points(points.iter().map(|&point| axes * point));
        // The extent of the displacements along the axes.
        let (middle, half) = (padding.centre(), 0.5 * padding.size());
        let reach = DVec3::from_array([0, 1, 2].map(|k| axes.row(k).abs().dot(half)));
        let bounds = bounds.minkowski_sum(Aabb { low: axes * middle - reach, high: axes * middle + reach });
        let middle = axes.transpose() * bounds.centre();
        oriented.centre = single(middle);
        let centre = axes * to_double_precision(oriented.centre);
        let reach = (bounds.high - centre).abs().max((centre - bounds.low).abs());
        // The axes are orthonormal to 1e-7, and so are lengths along them.
        oriented.half_lengths = reach.to_array().map(|half| round_up_to_f32(half * (1.0 + 1e-6)));
        oriented
    }

    /// A matrix whose rows are the axes.
    #[inline(always)]
    fn axes_as_rows(&self) -> DMat3 {
        let [first, second] = self.axes.map(to_double_precision);
        DMat3::from_cols(first, second, first.cross(second)).transpose()
    }

    /// A lower bound of the squared distance of a point.
    #[inline(always)]
    pub(crate) fn distance_squared(&self, point: DVec3) -> f64 {
        let [first, second] = self.axes.map(to_double_precision);
        let from = point - to_double_precision(self.centre);
        let along = DVec3::new(from.dot(first), from.dot(second), from.dot(first.cross(second)));
        let half = to_double_precision(self.half_lengths);
        let outside = (along.abs() - half).max(DVec3::ZERO);
        outside.length_squared() * (1.0 - 1e-6)
    }

    /// False if a line misses the box. In projection along the line, the sum of the half axes
    /// bounds the box in each direction.
    #[inline(always)]
    pub(crate) fn may_meet_line(&self, origin: DVec3, direction: DVec3) -> bool {
        let ([first, second], half) = (self.axes.map(to_double_precision), to_double_precision(self.half_lengths));
        let (third, from) = (first.cross(second), origin - to_double_precision(self.centre));
        // The axes are orthonormal only to 1e-7, so the box is enlarged by a fraction of the
        // distance.
        let half = half + 1e-6 * from.abs().element_sum();
        let from = DVec3::new(from.dot(first), from.dot(second), from.dot(third));
        let along = DVec3::new(direction.dot(first), direction.dot(second), direction.dot(third));
        // The separating axes of a line and a box are the cross products of the line's direction
        // with the box's axes.
        let (distance, size) = (from.cross(along).abs(), along.abs());
        let reach = DVec3::new(
            half.y * size.z + half.z * size.y,
            half.z * size.x + half.x * size.z,
            half.x * size.y + half.y * size.x,
        );
        distance.x <= reach.x && distance.y <= reach.y && distance.z <= reach.z
    }

    /// False if all points, and so their hull, are beyond one side of the box.
    pub(crate) fn may_meet_hull(&self, points: &[DVec3]) -> bool {
        let (frame, half) = (self.axes_as_rows(), to_double_precision(self.half_lengths));
        let (mut bounds, mut farthest) = (Aabb::EMPTY, 0.0_f64);
        for from in points.iter().map(|&point| point - to_double_precision(self.centre)) {
            bounds.add(frame * from);
            farthest = farthest.max(from.length_squared());
        }
        // The axes are orthonormal only to 1e-7.
        let rounding = 1e-6 * farthest.sqrt();
        (bounds.low - half).max(-half - bounds.high).max_element() <= rounding
    }

    /// The range of the products of points of the box with a direction.
    #[inline(always)]
    pub(crate) fn product_range_with_direction(&self, direction: DVec3) -> [f64; 2] {
        let half = to_double_precision(self.half_lengths);
        let middle = to_double_precision(self.centre).dot(direction);
        // The axes are orthonormal to 1e-7, so the box may extend slightly farther.
        let reach = (self.axes_as_rows() * direction).abs().dot(half) * (1.0 + 1e-6)
            + 1e-6 * half.length() * direction.length();
        [middle - reach, middle + reach]
    }

    /// The centre and the half edges of a parallelepiped that contains the box.
    #[inline(always)]
    pub(crate) fn centre_and_half_edges(&self) -> (DVec3, [DVec3; 3]) {
        let [first, second] = self.axes.map(to_double_precision);
        // The box is the set of points whose products with the axes are small. For a matrix that is
        // orthonormal to 1e-7, the transpose equals the inverse to 1e-6, relative to the longest
        // edge, however short the others are.
        let half = to_double_precision(self.half_lengths);
        let [x, y, z] = (half + 1e-6 * half.length()).to_array();
        (to_double_precision(self.centre), [x * first, y * second, z * first.cross(second)])
    }

    /// The corners.
    pub(crate) fn corners(&self) -> [DVec3; 8] {
        let (centre, half) = self.centre_and_half_edges();
        let sign = |k: usize, bit: usize| if k >> bit & 1 == 0 { -1.0 } else { 1.0 };
        std::array::from_fn(|k| centre + sign(k, 0) * half[0] + sign(k, 1) * half[1] + sign(k, 2) * half[2])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `round_down_to_f32` returns the largest f32 not above the number, `round_up_to_f32` the smallest
    /// not below it.
    #[test]
    fn rounding_is_directed_and_sharp() {
        let check = |value: f64| {
            let (low, high) = (round_down_to_f32(value), round_up_to_f32(value));
            assert!(f64::from(low) <= value && f64::from(low.next_up()) > value, "{value:e}: {low:e}");
            assert!(f64::from(high) >= value && f64::from(high.next_down()) < value, "{value:e}: {high:e}");
        };
        let exact = [0.5, 1.0, 1.0 + f64::from(f32::EPSILON)];
        let between = [0.1, 0.3, 1.0 / 3.0, 1.0 + 1e-9, 16_777_217.0, 1e-42, 1e-50, 1e37, 3.4028235e38];
        for value in exact.into_iter().chain(between).flat_map(|x| [x, -x]) {
            check(value);
        }
        assert!(exact.iter().all(|&x| f64::from(round_down_to_f32(x)) == x && f64::from(round_up_to_f32(x)) == x));
        assert_eq!((round_down_to_f32(1e39), round_up_to_f32(1e39)), (f32::MAX, f32::INFINITY));
    }

    /// A box in single precision contains the box in double precision, so no distance from it is
    /// larger.
    #[test]
    fn child_boxes_contain_the_exact_boxes() {
        let mut boxes = ChildBoxes::EMPTY;
        let each: [Aabb; 3] = std::array::from_fn(|k| {
            let low = DVec3::new(0.1, -0.7, 1.3) * (k + 1) as f64;
            Aabb { low, high: low + DVec3::new(0.3, 1e-3, 1e-9) }
        });
        each.iter().enumerate().for_each(|(k, &bounds)| boxes.set_child_box(k, bounds));
        for (k, bounds) in each.iter().enumerate() {
            let held = boxes.child_box(k);
            assert!(held.low.cmple(bounds.low).all() && held.high.cmpge(bounds.high).all(), "{k}");
            for point in [bounds.low, bounds.high, bounds.low - 1e-8, bounds.high + 1e-8] {
                assert!(boxes.distances_squared(point)[k] <= bounds.distance_squared(point), "{k} {point}");
            }
        }
        assert_eq!(boxes.distances_squared(DVec3::ZERO)[3], f64::INFINITY);
    }

    /// However thin the box is, the points that it was computed for are within the parallelepiped
    /// of its edges.
    #[test]
    fn edges_enclose_the_points() {
        let mut random = fastrand::Rng::with_seed(1);
        for k in 0..3000 {
            let mut direction = || DVec3::from_array([0; 3].map(|_| 2.0 * random.f64() - 1.0)).normalize();
            let (u, v) = (direction(), direction());
            let w = u.cross(v).normalize();
            let sizes = [1.0, [1e-2, 1e-3, 1e-5][k % 3], [1e-3, 1e-6, 0.0][k / 3 % 3]];
            let (x, y, z) = (sizes[0] * u, sizes[1] * w.cross(u), sizes[2] * w);
            let signs = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(|bit| 2.0 * bit as f64 - 1.0);
            let points: Vec<DVec3> = (0..8).map(signs).map(|[a, b, c]| a * x + b * y + c * z).collect();
            let exactly = Aabb { low: DVec3::ZERO, high: DVec3::ZERO };
            let (centre, half) = OrientedBox::from_points(&points, u, v, exactly).centre_and_half_edges();
            let inside = DMat3::from_cols(half[0], half[1], half[2]).inverse();
            for &point in &points {
                assert!((inside * (point - centre)).abs().max_element() <= 1.0 + 1e-12, "{k}: {sizes:?}");
            }
        }
    }

    /// For any directions, including zero and nearly parallel ones, the axes are perpendicular, and
    /// the box contains the points.
    #[test]
    fn oriented_boxes_contain_their_points() {
        let points: Vec<DVec3> =
            (0..20).map(|k| DVec3::new(f64::from(k * 7 % 20), f64::from(k * 11 % 20), f64::from(k))).collect();
        let u = DVec3::new(1e-17, 0.3e-17, -2e-17);
        let directions =
            [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1e-17, 1e-16), DVec3::new(3.0, 1e-9, 0.0), u, 3.0000001 * u];
        for (a, b) in (0..36).map(|k| (directions[k / 6], directions[k % 6])) {
            let exactly = Aabb { low: DVec3::ZERO, high: DVec3::ZERO };
            let found = OrientedBox::from_points(&points, a, b, exactly);
            let frame = found.axes_as_rows();
            assert!(
                (frame * frame.transpose() - DMat3::IDENTITY).to_cols_array().iter().all(|x| x.abs() < 1e-6),
                "{a} {b}"
            );
            assert!(points.iter().all(|&point| found.distance_squared(point) < 1e-9), "{a} {b}");
        }
    }
}
