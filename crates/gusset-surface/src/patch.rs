//! Tensor-product Bézier patches: points, derivatives and subdivision by de Casteljau's algorithm.

use glam::DVec3;
use gusset_base::geom::bernstein::{halves, reduce_by_casteljau};

/// Control points `points[a][b]` of degree N - 1 in u (first index) and in v, over 0 <= u, v <= 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch<const N: usize> {
    /// The control net.
    pub points: [[DVec3; N]; N],
}

/// Position and derivatives at a point of a patch, with respect to the patch's parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet {
    /// The point S(u, v).
    pub point: DVec3,
    /// The derivative S_u.
    pub u: DVec3,
    /// The derivative S_v.
    pub v: DVec3,
    /// The second derivative S_uu.
    pub uu: DVec3,
    /// The mixed derivative S_uv.
    pub uv: DVec3,
    /// The second derivative S_vv.
    pub vv: DVec3,
}

/// The point and the first two derivatives of a Bézier curve. De Casteljau's algorithm stops at the
/// last three points.
fn curve_point_and_derivatives<const N: usize>(points: &[DVec3; N], t: f64) -> [DVec3; 3] {
    let mut work = *points;
    reduce_by_casteljau(&mut work, t, 3);
    let degree = (N - 1) as f64;
    let second = (work[2] - 2.0 * work[1] + work[0]) * (degree * (degree - 1.0));
    let (left, right) = (work[0].lerp(work[1], t), work[1].lerp(work[2], t));
    [left.lerp(right, t), (right - left) * degree, second]
}

impl<const N: usize> Patch<N> {
    /// The point at (u, v).
    pub fn point(&self, u: f64, v: f64) -> DVec3 {
        self.jet(u, v).point
    }

    /// The point at (u, v) and the derivatives there.
    #[inline]
    pub fn jet(&self, u: f64, v: f64) -> Jet {
        // First in u, for all columns at once, then in v.
        let [points, first, second] = self.iso_curve_controls(u);
        let [point, v1, vv] = curve_point_and_derivatives(&points, v);
        let [u1, uv, _] = curve_point_and_derivatives(&first, v);
        let [uu, ..] = curve_point_and_derivatives(&second, v);
        Jet { point, u: u1, v: v1, uu, uv, vv }
    }

    /// The control points in v of the iso-curve at u, and of its first two derivatives with respect
    /// to u. Applies [`curve_point_and_derivatives`] to each column.
    #[inline(always)]
    fn iso_curve_controls(&self, u: f64) -> [[DVec3; N]; 3] {
        let mut work = self.points;
        let low = 1.0 - u;
        reduce_by_casteljau(&mut work, u, 3);
        let degree = (N - 1) as f64;
        let mut rows = [[DVec3::ZERO; N]; 3];
        for b in 0..N {
            let (left, right) = (low * work[0][b] + u * work[1][b], low * work[1][b] + u * work[2][b]);
            rows[0][b] = low * left + u * right;
            rows[1][b] = degree * (right - left);
            rows[2][b] = (degree * (degree - 1.0)) * (work[2][b] - 2.0 * work[1][b] + work[0][b]);
        }
        rows
    }

    /// The four quarters: low u and low v, low u and high v, high u and low v, high u and high v.
    pub fn quarters(&self) -> [Patch<N>; 4] {
        let [low, high] = self.halves();
        let ([a, b], [c, d]) = (low.transposed().halves(), high.transposed().halves());
        [a, b, c, d].map(|patch| patch.transposed())
    }

    /// The halves at u = 1/2.
    pub fn halves(&self) -> [Patch<N>; 2] {
        halves(&self.points).map(|points| Patch { points })
    }

    /// The patch with u and v exchanged.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let mut turned = *self;
        for a in 0..N {
            for b in 0..N {
                turned.points[a][b] = self.points[b][a];
            }
        }
        turned
    }
}

/// The unit normal of the tangent plane; `None` if the tangents do not span a plane.
#[inline]
pub(super) fn unit_normal_if_regular(u: DVec3, v: DVec3, noise: f64) -> Option<DVec3> {
    let normal = u.cross(v);
    let (u, v) = (u.length_squared(), v.length_squared());
    let spans = normal.length_squared() > 1e-20 * u * v && u.min(v) > noise * noise;
    // The product of tiny tangents may underflow to zero although neither tangent is zero.
    if spans { normal.try_normalize() } else { None }
}

impl Jet {
    /// S_u x S_v. Its length is the area of the surface for one unit of parameter area.
    pub fn normal(&self) -> DVec3 {
        self.u.cross(self.v)
    }

    /// The unit normal along S_u x S_v. Returns `None` if the surface is singular or nearly
    /// singular there, or if a tangent is not longer than `noise`.
    #[inline]
    pub(crate) fn unit_normal_if_regular(&self, noise: f64) -> Option<DVec3> {
        unit_normal_if_regular(self.u, self.v, noise)
    }
}
