//! Control nets of any shape: patches, segments of curves (one column), and single points.
//!
//! Bounds follow from the nets of derivatives, which are differences of control points: their
//! vectors lie in the balls of [`DerivativeBalls`]. O(points) each.

use crate::Jet;
use glam::DVec3;
use gusset_base::geom::Aabb;
use gusset_base::geom::bernstein::{halve, reduce_by_casteljau};

/// Largest number of control points in a row or a column.
const MAX_CONTROL_POINTS_PER_LINE: usize = gusset_curve::MAX_DEGREE + 1;
/// Largest number of control points in a row or a column of a patch, and of most segments.
const MAX_CONTROL_POINTS_PER_PATCH_LINE: usize = crate::MAX_DEGREE + 1;

/// A control net, row by row. A direction with a single control point lacks a parameter.
#[derive(Debug, Clone, Copy)]
pub(super) struct ControlNet<'a> {
    pub(super) points: &'a [DVec3],
    pub(super) shape: [usize; 2],
}

/// A ball.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct VectorBall {
    pub(super) centre: DVec3,
    pub(super) radius: f64,
}

impl VectorBall {
    fn from_vectors(vectors: impl Iterator<Item = DVec3> + Clone) -> VectorBall {
        let bounds = Aabb::from_points(vectors.clone());
        if bounds.is_empty() {
            return VectorBall::default();
        }
        let centre = bounds.centre();
        VectorBall { centre, radius: vectors.map(|v| v.distance_squared(centre)).fold(0.0, f64::max).sqrt() }
    }

    /// The length of the longest vector in the ball.
    pub(super) fn max_vector_length(&self) -> f64 {
        self.centre.length() + self.radius
    }
}

/// Balls around the points and the derivatives of a net. Second derivatives are uu, uv, vv.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct DerivativeBalls {
    pub(super) point: VectorBall,
    pub(super) first: [VectorBall; 2],
    pub(super) second: [VectorBall; 3],
}

impl DerivativeBalls {
    /// For each parameter, how much closer the net may come to its points after a split at the
    /// middle, which is proportional to the second derivatives.
    pub(super) fn flatness_gain_by_split(&self) -> [f64; 2] {
        let [uu, uv, vv] = self.second.map(|ball| ball.max_vector_length());
        [uu + uv, vv + uv].map(|sum| 0.125 * sum)
    }

    /// Bounds of the extent of the net along each parameter.
    pub(super) fn max_extents(&self) -> [f64; 2] {
        self.first.map(|ball| ball.max_vector_length())
    }
}

impl<'a> ControlNet<'a> {
    fn control_point(&self, a: usize, b: usize) -> DVec3 {
        self.points[a * self.shape[1] + b]
    }

    /// Position and derivatives.
    pub(super) fn jet_at(&self, at: [f64; 2]) -> Jet {
        // Most nets have short lines, which saves clearing memory for the longest lines.
        if self.shape[0].max(self.shape[1]) <= MAX_CONTROL_POINTS_PER_PATCH_LINE {
            self.jet_with_buffer::<MAX_CONTROL_POINTS_PER_PATCH_LINE>(at)
        } else {
            self.jet_with_buffer::<MAX_CONTROL_POINTS_PER_LINE>(at)
        }
    }

    fn jet_with_buffer<const LINE: usize>(&self, [u, v]: [f64; 2]) -> Jet {
        let [rows, columns] = self.shape;
        let mut work = [DVec3::ZERO; LINE];
        let mut across = [[DVec3::ZERO; LINE]; 3];
        for b in 0..columns {
            (0..rows).for_each(|a| work[a] = self.control_point(a, b));
            let column_derivatives = value_and_derivatives(&mut work[..rows], u);
            across.iter_mut().zip(column_derivatives).for_each(|(row, derivative)| row[b] = derivative);
        }
        let [point, v1, vv] = value_and_derivatives(&mut across[0][..columns], v);
        let [u1, uv, _] = value_and_derivatives(&mut across[1][..columns], v);
        let [uu, ..] = value_and_derivatives(&mut across[2][..columns], v);
        Jet { point, u: u1, v: v1, uu, uv, vv }
    }

    /// Balls around the vectors of all nets of derivatives.
    pub(super) fn derivative_balls(&self) -> DerivativeBalls {
        let [rows, columns] = self.shape;
        let degree = self.shape.map(|count| (count - 1) as f64);
        let indices = |rows: usize, columns: usize| (0..rows).flat_map(move |a| (0..columns).map(move |b| (a, b)));
        let p = |a: usize, b: usize| self.control_point(a, b);
        let u = indices(rows - 1, columns).map(|(a, b)| degree[0] * (p(a + 1, b) - p(a, b)));
        let v = indices(rows, columns - 1).map(|(a, b)| degree[1] * (p(a, b + 1) - p(a, b)));
        let again = degree.map(|degree| degree * (degree - 1.0));
        let uu = indices(rows.saturating_sub(2), columns);
        let uu = uu.map(|(a, b)| again[0] * (p(a + 2, b) - 2.0 * p(a + 1, b) + p(a, b)));
        let vv = indices(rows, columns.saturating_sub(2));
        let vv = vv.map(|(a, b)| again[1] * (p(a, b + 2) - 2.0 * p(a, b + 1) + p(a, b)));
        let uv = indices(rows - 1, columns - 1);
        let uv = uv.map(|(a, b)| degree[0] * degree[1] * (p(a + 1, b + 1) - p(a + 1, b) - p(a, b + 1) + p(a, b)));
        DerivativeBalls {
            point: VectorBall::from_vectors(self.points.iter().copied()),
            first: [VectorBall::from_vectors(u), VectorBall::from_vectors(v)],
            second: [VectorBall::from_vectors(uu), VectorBall::from_vectors(uv), VectorBall::from_vectors(vv)],
        }
    }

    /// Writes the two halves along a parameter, one after the other, each the size of the net.
    pub(super) fn write_halves(&self, parameter: usize, out: &mut [DVec3]) {
        let [rows, columns] = self.shape;
        let (low, high) = out.split_at_mut(self.points.len());
        let (lines, count) = if parameter == 0 { (columns, rows) } else { (rows, columns) };
        let mut work = [[DVec3::ZERO; MAX_CONTROL_POINTS_PER_LINE]; 2];
        for line in 0..lines {
            let place = |k: usize| if parameter == 0 { k * columns + line } else { line * columns + k };
            let [before, after] = &mut work;
            (0..count).for_each(|k| after[k] = self.points[place(k)]);
            halve(&mut after[..count], &mut before[..count]);
            for k in 0..count {
                (low[place(k)], high[place(k)]) = (before[k], after[k]);
            }
        }
    }

    /// The Greville parameters of a control point, at which an affine net has this point.
    pub(super) fn greville_parameters(&self, point: usize) -> [f64; 2] {
        let [rows, columns] = self.shape;
        let share = |k: usize, count: usize| if count > 1 { k as f64 / (count - 1) as f64 } else { 0.0 };
        [share(point / columns, rows), share(point % columns, columns)]
    }
}

/// The value and the first two derivatives at t.
fn value_and_derivatives(c: &mut [DVec3], t: f64) -> [DVec3; 3] {
    let degree = (c.len() - 1) as f64;
    match c.len() {
        1 => [c[0], DVec3::ZERO, DVec3::ZERO],
        2 => [c[0].lerp(c[1], t), c[1] - c[0], DVec3::ZERO],
        _ => {
            reduce_by_casteljau(c, t, 3);
            let (left, right) = (c[0].lerp(c[1], t), c[1].lerp(c[2], t));
            let second = (c[2] - 2.0 * c[1] + c[0]) * (degree * (degree - 1.0));
            [left.lerp(right, t), (right - left) * degree, second]
        }
    }
}
