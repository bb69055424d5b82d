//! A piece of a surface as the graph of a height over a plane: bounds of its derivatives.
//!
//! Where x_u y_v - x_v y_u is not 0, S(u, v) = (x, y, z) is the graph of a height h(x, y) over the
//! plane of x and y. Its slopes are h_x = z_u u_x + z_v v_x and h_y = z_u u_y + z_v v_y. To obtain
//! its second derivatives, subtract from z_uu the slopes times x_uu and y_uu, and likewise for uv
//! and vv. Then apply the derivatives of (u, v) with respect to (x, y) twice. In interval
//! arithmetic, the results are bounds over the whole piece. The difference of two such bounds
//! bounds the relative second form of two surfaces that touch.
//!
//! Cost: O(N^3) for a piece of degree N - 1.

use crate::{Jet, Patch};
use glam::{DMat3, DVec3};
use gusset_base::geom::bernstein::restrict;
use std::ops::{Add, Mul, Sub};

/// A closed interval.
#[derive(Debug, Clone, Copy)]
pub(super) struct Interval {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Interval {
    pub(super) fn single_number(x: f64) -> Self {
        Interval { low: x, high: x }
    }

    pub(super) fn extended_to(self, x: f64) -> Self {
        Interval { low: self.low.min(x), high: self.high.max(x) }
    }

    pub(super) fn middle(self) -> f64 {
        0.5 * (self.low + self.high)
    }

    /// The reciprocal, if the interval does not contain 0.
    pub(super) fn reciprocal(self) -> Option<Self> {
        let apart = self.low > 0.0 || self.high < 0.0;
        apart.then(|| Interval { low: 1.0 / self.high, high: 1.0 / self.low })
    }
}

impl Add for Interval {
    type Output = Interval;

    fn add(self, other: Interval) -> Interval {
        Interval { low: self.low + other.low, high: self.high + other.high }
    }
}

impl Sub for Interval {
    type Output = Interval;

    fn sub(self, other: Interval) -> Interval {
        Interval { low: self.low - other.high, high: self.high - other.low }
    }
}

impl Mul for Interval {
    type Output = Interval;

    fn mul(self, other: Interval) -> Interval {
        let first = Interval::single_number(self.low * other.low);
        first.extended_to(self.low * other.high).extended_to(self.high * other.low).extended_to(self.high * other.high)
    }
}

/// The height of a piece of a surface over the plane of a frame's first two axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct HeightDerivativeIntervals {
    /// The derivatives of u and of v with respect to x and y.
    pub(super) inverse: [[Interval; 2]; 2],
    /// h_x and h_y.
    pub(super) slopes: [Interval; 2],
    /// h_xx, h_xy and h_yy.
    pub(super) second: [Interval; 3],
}

impl HeightDerivativeIntervals {
    /// Creates the graph from S_u and S_v, and from S_uu, S_uv and S_vv, in coordinates of the
    /// frame. Returns `None` if the piece may not be a graph.
    fn new(first: [[Interval; 3]; 2], second: [[Interval; 3]; 3]) -> Option<HeightDerivativeIntervals> {
        let [[xu, yu, zu], [xv, yv, zv]] = first;
        let factor = (xu * yv - xv * yu).reciprocal()?;
        let minus = Interval::single_number(-1.0) * factor;
        let inverse = [[yv * factor, xv * minus], [yu * minus, xu * factor]];
        let slopes = [0, 1].map(|k| zu * inverse[0][k] + zv * inverse[1][k]);
        let [uu, uv, vv] = second.map(|[x, y, z]| z - slopes[0] * x - slopes[1] * y);
        let along = |k: usize, n: usize| {
            let ([uk, un], [vk, vn]) = ([inverse[0][k], inverse[0][n]], [inverse[1][k], inverse[1][n]]);
            uu * uk * un + uv * (uk * vn + vk * un) + vv * vk * vn
        };
        Some(HeightDerivativeIntervals { inverse, slopes, second: [along(0, 0), along(0, 1), along(1, 1)] })
    }

    /// The graph at a point.
    pub(super) fn from_jet(jet: &Jet, frame: &DMat3) -> Option<HeightDerivativeIntervals> {
        let along = |vector: DVec3| (frame.transpose() * vector).to_array().map(Interval::single_number);
        HeightDerivativeIntervals::new([along(jet.u), along(jet.v)], [along(jet.uu), along(jet.uv), along(jet.vv)])
    }

    /// The graph over a part of a patch. Control points give the bounds.
    pub(super) fn from_patch<const N: usize>(
        patch: &Patch<N>,
        part: [[f64; 2]; 2],
        frame: &DMat3,
    ) -> Option<HeightDerivativeIntervals> {
        let mut points = patch.points.map(|row| row.map(|point| frame.transpose() * point));
        restrict_patch_rows(&mut points, part[0]);
        let mut turned = Patch { points }.transposed();
        restrict_patch_rows(&mut turned.points, part[1]);
        let net = turned.transposed().points;
        // Differences of control points are derivatives with respect to the patch's own parameters.
        let degree = (N - 1) as f64;
        let scale = part.map(|[from, to]| degree / (to - from));
        let (mut u, mut v) = ([None; 3], [None; 3]);
        let (mut uu, mut uv, mut vv) = ([None; 3], [None; 3], [None; 3]);
        for a in 0..N {
            for b in 0..N {
                let p = net[a][b];
                if a + 1 < N {
                    extend_ranges(&mut u, scale[0] * (net[a + 1][b] - p));
                }
                if b + 1 < N {
                    extend_ranges(&mut v, scale[1] * (net[a][b + 1] - p));
                }
                if a + 1 < N && b + 1 < N {
                    extend_ranges(
                        &mut uv,
                        (net[a + 1][b + 1] - net[a + 1][b] - net[a][b + 1] + p) * (scale[0] * scale[1]),
                    );
                }
                let again = (degree - 1.0) / degree;
                if a + 2 < N {
                    extend_ranges(&mut uu, (net[a + 2][b] - 2.0 * net[a + 1][b] + p) * (again * scale[0] * scale[0]));
                }
                if b + 2 < N {
                    extend_ranges(&mut vv, (net[a][b + 2] - 2.0 * net[a][b + 1] + p) * (again * scale[1] * scale[1]));
                }
            }
        }
        // The second derivatives of degree 1 vanish.
        let all = |range: [Option<Interval>; 3]| range.map(|range| range.unwrap_or(Interval::single_number(0.0)));
        HeightDerivativeIntervals::new([all(u), all(v)], [all(uu), all(uv), all(vv)])
    }
}

fn restrict_patch_rows<const N: usize>(points: &mut [[DVec3; N]; N], range: [f64; 2]) {
    for b in 0..N {
        let mut column = points.map(|row| row[b]);
        restrict(&mut column, range);
        points.iter_mut().zip(column).for_each(|(row, point)| row[b] = point);
    }
}

/// Adds a vector to the ranges of its components.
fn extend_ranges(ranges: &mut [Option<Interval>; 3], vector: DVec3) {
    for (range, x) in ranges.iter_mut().zip(vector.to_array()) {
        *range = Some(range.map_or(Interval::single_number(x), |range| range.extended_to(x)));
    }
}

/// Definiteness of a symmetric 2 x 2 matrix, proven for all values in its intervals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FormDefiniteness {
    /// Both eigenvalues are positive.
    Positive,
    /// Both eigenvalues are negative.
    Negative,
    /// One eigenvalue is positive, the other negative.
    Indefinite,
    /// The signs of the eigenvalues are not proven.
    Unknown,
}

impl FormDefiniteness {
    /// The definiteness of the second derivatives of the difference of two graphs.
    pub(super) fn from_difference(
        one: &HeightDerivativeIntervals,
        other: &HeightDerivativeIntervals,
    ) -> FormDefiniteness {
        let [xx, xy, yy] = [0, 1, 2].map(|k| one.second[k] - other.second[k]);
        let Interval { low, high } = xx * yy;
        let square = xy.low.abs().max(xy.high.abs()).powi(2);
        let least = if xy.low <= 0.0 && xy.high >= 0.0 { 0.0 } else { xy.low.abs().min(xy.high.abs()).powi(2) };
        // Rounding of the steps above.
        let slack = 1e-12 * (low.abs().max(high.abs()) + square);
        match () {
            () if low - square > slack && xx.low > 0.0 => FormDefiniteness::Positive,
            () if low - square > slack && xx.high < 0.0 => FormDefiniteness::Negative,
            () if high - least < -slack => FormDefiniteness::Indefinite,
            () => FormDefiniteness::Unknown,
        }
    }
}
