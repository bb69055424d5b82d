//! Boxes oriented along the triangles that they contain. For long, thin triangles that lie across
//! the axes they are much tighter than axis-aligned boxes.
//!
//! Source: S. Gottschalk, M. C. Lin, D. Manocha, *OBBTree: a hierarchical structure for rapid
//! interference detection* (1996). The axes follow a single triangle of the box, because the
//! triangles of a strip are nearly parallel.

use glam::DVec3;

/// The largest relative round-off of a projection.
const RELATIVE_ROUND_OFF: f64 = 1.0 / (1u64 << 46) as f64;

/// A box along three perpendicular axes.
#[derive(Debug, Clone, Copy)]
pub struct OrientedBox {
    axes: [DVec3; 3],
    low: DVec3,
    high: DVec3,
}

impl OrientedBox {
    pub const EMPTY: OrientedBox = OrientedBox { axes: DVec3::AXES, low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// Returns the box of some triangles. Its axes follow the longest side of all, and the triangle
    /// of that side.
    pub fn from_triangles(triangles: impl Iterator<Item = [DVec3; 3]> + Clone) -> Self {
        let mut longest = (-1.0, DVec3::X, DVec3::Y);
        for [p, q, r] in triangles.clone() {
            for (side, other) in [(q - p, r - p), (r - q, p - q), (p - r, q - r)] {
                if side.length_squared() > longest.0 {
                    longest = (side.length_squared(), side, other);
                }
            }
        }
        let axes = orthonormal_frame(longest.1, longest.2);
        let mut whole = OrientedBox { axes, ..Self::EMPTY };
        for p in triangles.flatten() {
            let (at, slack) = (whole.box_coordinates(p), DVec3::splat(RELATIVE_ROUND_OFF * p.abs().max_element()));
            (whole.low, whole.high) = (whole.low.min(at - slack), whole.high.max(at + slack));
        }
        whole
    }

    /// Returns the box of both along the axes of `self`, or of `other` if `self` is empty.
    pub fn union(&self, other: &OrientedBox) -> OrientedBox {
        if self.is_empty() || other.is_empty() {
            return if self.is_empty() { *other } else { *self };
        }
        let (middle, half) = ((other.low + other.high) / 2.0, (other.high - other.low) / 2.0);
        let [x, y, z] = other.axes;
        let centre = self.box_coordinates(x * middle.x + y * middle.y + z * middle.z);
        let reach = self.box_coordinates(x).abs() * half.x
            + self.box_coordinates(y).abs() * half.y
            + self.box_coordinates(z).abs() * half.z;
        let reach = reach + RELATIVE_ROUND_OFF * (middle.abs() + half).element_sum();
        OrientedBox { axes: self.axes, low: self.low.min(centre - reach), high: self.high.max(centre + reach) }
    }

    /// Returns true if all points lie beyond one side of the box. Their hull then does not meet the
    /// content of the box.
    #[inline]
    pub fn is_beside(&self, points: &[DVec3; 3]) -> bool {
        let slack = RELATIVE_ROUND_OFF * points.iter().fold(0.0, |most: f64, p| most.max(p.abs().max_element()));
        let [p, q, r] = points.map(|p| self.box_coordinates(p));
        (p.min(q).min(r) - slack).cmpgt(self.high).any() || (p.max(q).max(r) + slack).cmplt(self.low).any()
    }

    fn is_empty(&self) -> bool {
        self.low.x > self.high.x
    }

    #[inline]
    fn box_coordinates(&self, p: DVec3) -> DVec3 {
        DVec3::new(self.axes[0].dot(p), self.axes[1].dot(p), self.axes[2].dot(p))
    }
}

/// Three perpendicular unit vectors: the first along `side`, the third perpendicular to both `side`
/// and `other`.
fn orthonormal_frame(side: DVec3, other: DVec3) -> [DVec3; 3] {
    let along = side.normalize_or(DVec3::X);
    // The cross product of a needle's sides is mostly round-off and may point anywhere. Use it only
    // if most of it is perpendicular to the side.
    let square = along.cross(other).normalize_or_zero().reject_from_normalized(along);
    let normal = if square.length_squared() > 0.25 { square.normalize() } else { along.any_orthonormal_vector() };
    [along, normal.cross(along), normal]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_point() -> impl Strategy<Value = DVec3> {
        (-1.0..1.0, -1.0..1.0, -1.0..1.0).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    /// Sides of triangles whose corners are collinear up to round-off.
    #[test]
    fn frames_are_orthonormal_for_degenerate_cross_products() {
        let mut random = fastrand::Rng::with_seed(1);
        let assert_square = |side: DVec3, other: DVec3| {
            let axes = orthonormal_frame(side, other);
            for (i, j) in [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)] {
                let expected = if i == j { 1.0 } else { 0.0 };
                let found = axes[i].dot(axes[j]);
                assert!((found - expected).abs() < 16.0 * f64::EPSILON, "{side} {other} {i} {j} {found}");
            }
        };
        let ulp = f64::EPSILON;
        let diagonal = DVec3::new(1.0, 1.0 + ulp, 1.0 - ulp / 2.0);
        for _ in 0..20_000 {
            assert_square(diagonal, diagonal * random.f64());
            let way = DVec3::new(random.f64(), random.f64(), random.f64());
            assert_square(way, way * random.f64());
        }
        for side in [DVec3::ZERO, DVec3::X, diagonal] {
            assert_square(side, DVec3::ZERO);
            assert_square(side, side);
        }
    }

    proptest! {
        /// Points inside a triangle of the box are never beside the box, for triangles of any
        /// shape.
        #[test]
        fn points_inside_are_not_beside(
            base in any_point(), way in any_point(), width in 0u32..18, shift in 0u32..12,
            weights in prop::collection::vec((0.0..1.0, 0.0..1.0, 0usize..8), 1..9),
        ) {
            // A fan of needles far from the origin; the last has width 0.
            let width = if width == 17 { 0.0 } else { 10f64.powi(-(width as i32)) };
            let base = base * 10f64.powi(shift as i32);
            let across = way.any_orthogonal_vector() * width;
            let triangles: Vec<[DVec3; 3]> = (0..8u32).map(|k| {
                [base + across * f64::from(k), base + across * f64::from(k + 1), base + way + across * f64::from(2 * k)]
            }).collect();
            let pairs = triangles.chunks(2);
            let leaves: Vec<OrientedBox> = pairs.map(|pair| OrientedBox::from_triangles(pair.iter().copied())).collect();
            let whole = leaves.iter().rev().fold(OrientedBox::EMPTY, |whole, leaf| whole.union(leaf));
            for (u, v, k) in weights {
                let [p, q, r] = triangles[k];
                let inside = p.lerp(q, u).lerp(r, v);
                let other = [inside, inside + way, inside + across];
                prop_assert!(!leaves[k / 2].is_beside(&other));
                prop_assert!(!whole.is_beside(&other));
            }
        }
    }

    #[test]
    fn a_diagonal_needle_is_beside_its_neighbours() {
        let way = DVec3::new(1.0, 1.0, 1.0);
        let needle = |k: f64| {
            let at = DVec3::new(1e-4, -1e-4, 0.0) * k;
            [at, at + way, at + DVec3::new(1e-5, -1e-5, 0.0)]
        };
        let held = OrientedBox::from_triangles([needle(0.0), needle(1.0)].into_iter());
        assert!(held.is_beside(&needle(2.0)) && held.is_beside(&needle(-1.0)));
        assert!(!held.is_beside(&needle(0.5)) && !held.is_beside(&needle(1.0)));
        assert!(!OrientedBox::EMPTY.union(&held).is_beside(&needle(1.0)));
    }
}
