//! Lower bounds of the distance of a patch.
//!
//! * *box*: that of the control points' box;
//! * *half-space*: with d a unit vector from the patch towards the query q, every point S of the patch has
//!   |q - S| >= (q - S) . d >= min over the control points of (q - P) . d;
//! * *convexity*: if the Hessian of |S - q|^2 / 2 is positive definite over the whole patch, then a point where no permitted step goes down is
//!   the only one, and the remaining gradient bounds what is left to gain.

use super::descend::Foot;
use crate::surface::Patch;
use glam::{DVec2, DVec3};

impl<const N: usize> Patch<N> {
    /// By the box of the control points.
    pub(super) fn box_distance(&self, query: DVec3) -> f64 {
        let (mut low, mut high) = (self.points[0][0], self.points[0][0]);
        for &point in self.points.as_flattened() {
            low = low.min(point);
            high = high.max(point);
        }
        (low - query).max(query - high).max(DVec3::ZERO).length()
    }

    /// By a half-space. `direction`: of unit length, best that from the nearest point to the query; or 0.
    #[inline]
    pub(super) fn half_space(&self, query: DVec3, direction: DVec3) -> f64 {
        let along = self.points.as_flattened().iter().map(|&point| (query - point).dot(direction));
        along.fold(f64::INFINITY, |least, along| if along < least { along } else { least }).max(0.0)
    }

    /// The greatest distance of a point of the patch, or more: that of a control point.
    pub(super) fn farthest(&self, query: DVec3) -> f64 {
        let squares = self.points.as_flattened().iter().map(|point| point.distance_squared(query));
        squares.fold(0.0, f64::max).sqrt()
    }

    /// By convexity; 0 if the Hessian may not be positive definite everywhere.
    pub(super) fn convex(&self, query: DVec3, foot: &Foot) -> f64 {
        let middle = || self.hessian(query, &Foot::at(self, query, DVec2::splat(0.5))).least_eigenvalue();
        let Some(least) = self.least_curvature(query, foot).or_else(middle) else { return 0.0 };
        // f >= f(x) - |g|^2 / (2 m) for a function whose Hessian is at least m.
        let gain = foot.free_gradient(query).length_squared() / least;
        (foot.distance * foot.distance - gain).max(0.0).sqrt()
    }

    /// A lower bound of the eigenvalues of the Hessian of |S - q|^2 / 2 over the patch, if it is positive.
    pub(super) fn least_curvature(&self, query: DVec3, foot: &Foot) -> Option<f64> {
        self.hessian(query, foot).least_eigenvalue()
    }

    /// The ranges of the second derivatives of |S - q|^2 / 2 over the patch, from what is known at one of its points.
    ///
    /// H_ab = S_a . S_b + (S - q) . S_ab. From the place x on, |S_u - S_u(x)| <= |du| max |S_uu| + |dv| max |S_uv|, and |S - S(x)| is at most the
    /// greatest distance r of a control point from S(x); so (S - q) . S_ab is within r max |S_ab| of (S(x) - q) . S_ab.
    pub(super) fn hessian(&self, query: DVec3, foot: &Foot) -> Hessian {
        let p = &self.points;
        let from = foot.jet.point - query;
        let reach = self.farthest(foot.jet.point);
        let degree = (N - 1) as f64;
        let twice = degree * (degree - 1.0);
        let (mut uu, mut uv, mut vv) = (Spread::NONE, Spread::NONE, Spread::NONE);
        for a in 0..N {
            for b in 0..N {
                if a + 2 < N {
                    uu.add(from, p[a + 2][b] - 2.0 * p[a + 1][b] + p[a][b]);
                    vv.add(from, p[b][a + 2] - 2.0 * p[b][a + 1] + p[b][a]);
                }
                if a + 1 < N && b + 1 < N {
                    uv.add(from, p[a + 1][b + 1] - p[a + 1][b] - p[a][b + 1] + p[a][b]);
                }
            }
        }
        let [uu, uv, vv] = [uu.times(twice), uv.times(degree * degree), vv.times(twice)];
        let (u, v) = (foot.jet.u.length(), foot.jet.v.length());
        let along = foot.place.max(DVec2::ONE - foot.place);
        let off_u = along.x * uu.most + along.y * uv.most;
        let off_v = along.x * uv.most + along.y * vv.most;
        let along = |length: f64, off: f64, second: Spread| {
            let (least, most) = ((length - off).max(0.0), length + off);
            let play = reach * second.most;
            [least * least + second.low - play, most * most + second.high + play]
        };
        let middle = foot.jet.u.dot(foot.jet.v);
        let play = u * off_v + v * off_u + off_u * off_v + reach * uv.most;
        Hessian {
            uu: along(u, off_u, uu),
            uv: [middle + uv.low - play, middle + uv.high + play],
            vv: along(v, off_v, vv),
        }
    }
}

/// Ranges of second derivatives over a patch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hessian {
    uu: [f64; 2],
    uv: [f64; 2],
    vv: [f64; 2],
}

impl Hessian {
    /// A lower bound of the eigenvalues, if it is positive.
    #[inline]
    fn least_eigenvalue(&self) -> Option<f64> {
        let mixed = self.uv[0].abs().max(self.uv[1].abs());
        let (u, v) = (self.uu[0], self.vv[0]);
        // The smaller eigenvalue is at least the determinant by the trace.
        let determinant = u * v - mixed * mixed;
        let sound = u > 0.0 && v > 0.0 && determinant > 1e-9 * u * v;
        sound.then(|| determinant / (u + v))
    }

    /// True if some direction goes down from every point where the gradient is 0. Second derivatives may be off by `noise`.
    pub(super) fn is_nowhere_definite(&self, noise: f64) -> bool {
        let [low, high] = self.uv;
        let mixed = if low <= 0.0 && high >= 0.0 { 0.0 } else { (low.abs().min(high.abs()) - noise).max(0.0) };
        let (u, v) = (self.uu[1] + noise, self.vv[1] + noise);
        u < 0.0 || v < 0.0 || u * v < mixed * mixed
    }
}

/// What is known of some vectors: the range of their products with another, and the greatest length.
#[derive(Clone, Copy)]
struct Spread {
    low: f64,
    high: f64,
    most: f64,
}

impl Spread {
    const NONE: Spread = Spread { low: f64::INFINITY, high: f64::NEG_INFINITY, most: 0.0 };

    /// `most` is the square till the end.
    #[inline(always)]
    fn add(&mut self, from: DVec3, vector: DVec3) {
        let along = from.dot(vector);
        self.low = self.low.min(along);
        self.high = self.high.max(along);
        self.most = self.most.max(vector.length_squared());
    }

    fn times(self, factor: f64) -> Spread {
        Spread { low: factor * self.low, high: factor * self.high, most: factor * self.most.sqrt() }
    }
}
