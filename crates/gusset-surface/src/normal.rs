//! Unit normals, also where the tangents do not define one.
//!
//! S_u x S_v = 0 where, for example, a side of a patch is a single point. There the normal is the
//! limit along a coordinate line into the patch. Along the line S_u and S_v are polynomials, and so
//! is their product; the direction of its first nonzero coefficient is the limit. Limits along
//! different lines may differ, as at the apex of a cone. Their largest difference is called the
//! spread.

use super::cells::SheetCells;
use super::patch::unit_normal_if_regular;
use super::{Patch, Sheet, each_sheet};
use glam::DVec3;
use gusset_base::geom::bernstein::{binomial_row, evaluate, evaluate_with_slope, restrict};

/// How a normal was obtained.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum NormalKind {
    /// The tangents span a plane, whose normal this is.
    Regular,
    /// The tangents do not span a plane. The normal is the limit along a coordinate line.
    Limit,
    /// No normal exists.
    None,
}

/// The normal at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Normal {
    /// Unit vector in the direction of S_u x S_v; zero if no normal exists.
    pub direction: DVec3,
    /// How the normal was obtained.
    pub kind: NormalKind,
    /// For a limit: the largest angle to the limits at the same point along other coordinate lines.
    /// At the pole of a smooth surface the spread is small, and an error of the interpolant. It is
    /// large at the apex of a cone, where the surface lacks a normal.
    pub spread: f64,
}

impl Normal {
    const NONE: Normal = Normal { direction: DVec3::ZERO, kind: NormalKind::None, spread: 0.0 };
}

/// The angle between unit vectors.
pub(super) fn angle_between_unit_vectors(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b))
}

impl<const N: usize> Patch<N> {
    /// Length up to which a derivative may be rounding of control points.
    pub(super) fn derivative_noise(&self) -> f64 {
        let largest = self.points.as_flattened().iter().fold(DVec3::ZERO, |most, p| most.max(p.abs()));
        (4 * N * N) as f64 * f64::EPSILON * largest.max_element()
    }

    /// True if the side u = 0 (u = 1 if `end`) is a single point.
    pub(super) fn is_u_side_point(&self, end: bool) -> bool {
        let side = &self.points[if end { N - 1 } else { 0 }];
        let noise = self.derivative_noise();
        side.iter().all(|p| p.distance(side[0]) <= noise)
    }

    /// True if S_u x S_v vanishes everywhere within rounding: the patch is a curve or a point.
    ///
    /// The control vectors of the product are sums of products of the control vectors of S_u and
    /// S_v, weighted by products of binomials.
    pub(super) fn has_zero_area(&self) -> bool {
        let p = &self.points;
        let step_u = |a: usize, b: usize| p[a + 1][b] - p[a][b];
        let step_v = |a: usize, b: usize| p[a][b + 1] - p[a][b];
        let (lower, full) = (binomial_row::<N>(N - 2), binomial_row::<N>(N - 1));
        let mut longest = 0.0_f64;
        for (a, b) in (0..N - 1).flat_map(|a| (0..N).map(move |b| (a, b))) {
            longest = longest.max(step_u(a, b).length()).max(step_v(b, a).length());
        }
        let noise = 2.0 * self.derivative_noise() * longest;
        // i = a + c and j = b + d, where a and d are below N - 1.
        let split = |k: usize| k.saturating_sub(N - 1)..=k.min(N - 2);
        (0..2 * N - 2).flat_map(|i| (0..2 * N - 2).map(move |j| (i, j))).all(|(i, j)| {
            let (mut sum, mut weight) = (DVec3::ZERO, 0.0);
            for (a, d) in split(i).flat_map(|a| split(j).map(move |d| (a, d))) {
                let share = lower[a] * full[j - d] * full[i - a] * lower[d];
                sum += share * step_u(a, j - d).cross(step_v(i - a, d));
                weight += share;
            }
            sum.length() <= weight * noise
        })
    }

    /// The unit normal, and whether the surface is regular; zero if no normal exists.
    fn normal_with_kind(&self, u: f64, v: f64) -> Normal {
        let (jet, noise) = (self.jet(u, v), self.derivative_noise());
        if let Some(direction) = jet.unit_normal_if_regular(noise) {
            return Normal { direction, kind: NormalKind::Regular, spread: 0.0 };
        }
        let limits = [self.normal_limit_along_u(u, v, noise), -self.transposed().normal_limit_along_u(v, u, noise)];
        match limits {
            [DVec3::ZERO, DVec3::ZERO] => Normal::NONE,
            [DVec3::ZERO, direction] | [direction, DVec3::ZERO] => {
                Normal { direction, kind: NormalKind::Limit, spread: 0.0 }
            }
            [a, b] => Normal { direction: a, kind: NormalKind::Limit, spread: angle_between_unit_vectors(a, b) },
        }
    }

    /// The unit normals at the ends and the middle of the side u = 0 (u = 1 if `end`). If `across`,
    /// the side is v = 0 or v = 1. A normal is zero where none exists.
    pub(super) fn unit_normals_along_side(&self, across: bool, end: bool) -> [DVec3; 3] {
        let net = if across { self.transposed() } else { *self };
        let (side, next) = if end { (N - 1, N - 2) } else { (0, 1) };
        let from_side = if end == across { 1.0 } else { -1.0 } * (N - 1) as f64;
        let steps: [DVec3; N] = std::array::from_fn(|k| (net.points[next][k] - net.points[side][k]) * from_side);
        let (noise, at) = (self.derivative_noise(), f64::from(u8::from(end)));
        [0.0, 0.5, 1.0].map(|t| {
            // `from_side` corrects the sign for steps backwards, and for the order of the tangents.
            let (off, along) = (evaluate(&steps, t), evaluate_with_slope(&net.points[side], t)[1]);
            let [u, v] = if across { [t, at] } else { [at, t] };
            unit_normal_if_regular(off, along, noise).unwrap_or_else(|| self.normal_with_kind(u, v).direction)
        })
    }

    /// The limit of the unit normal along the line of constant v, from the side with more room;
    /// zero if the normal vanishes along the whole line.
    fn normal_limit_along_u(&self, u: f64, v: f64, noise: f64) -> DVec3 {
        let across = self.points.map(|row| evaluate_with_slope(&row, v));
        let (down, from) = (u > 0.5, if u > 0.5 { 1.0 - u } else { u });
        let along = |k: usize| {
            let mut points: [DVec3; N] = std::array::from_fn(|a| across[if down { N - 1 - a } else { a }][k]);
            restrict(&mut points, [from, 1.0]);
            points
        };
        let (points, slopes) = (along(0), along(1));
        let steps: [DVec3; N] =
            std::array::from_fn(|a| if a + 1 < N { points[a + 1] - points[a] } else { DVec3::ZERO });
        let longest = |vectors: &[DVec3; N]| vectors.iter().fold(0.0_f64, |most, v| most.max(v.length()));
        let (of_steps, of_slopes) = (binomial_row::<N>(N - 2), binomial_row::<N>(N - 1));
        let (step, slope) = (longest(&steps), longest(&slopes));
        for k in 0..2 * N - 2 {
            let (mut sum, mut weight) = (DVec3::ZERO, 0.0);
            for i in k.saturating_sub(N - 1)..=k.min(N - 2) {
                let share = of_steps[i] * of_slopes[k - i];
                sum += share * steps[i].cross(slopes[k - i]);
                weight += share;
            }
            if sum.length() > weight * noise * (step + slope) {
                let direction = sum.normalize_or_zero();
                return if down { -direction } else { direction };
            }
        }
        DVec3::ZERO
    }
}

impl Sheet<'_> {
    /// The unit normal along S_u x S_v at parameters (u, v) of the cell at (i, j). On a side that
    /// is a single point, the limit along a coordinate line; zero if no normal exists.
    pub fn normal(&self, i: usize, j: usize, u: f64, v: f64) -> DVec3 {
        each_sheet!(self, cells => SheetCells::cell_patch(cells, i, j).normal_with_kind(u, v)).direction
    }

    /// The unit normal, how it was obtained, and its spread. O(1), but O(cells along the side) at a
    /// collapsed side.
    pub fn normal_or_limit(&self, i: usize, j: usize, u: f64, v: f64) -> Normal {
        let mut here = each_sheet!(self, cells => SheetCells::cell_patch(cells, i, j).normal_with_kind(u, v));
        if here.kind == NormalKind::Limit {
            for (direction, t) in [u, v].into_iter().enumerate() {
                let cell = |k: usize| if direction == 0 { [i, k] } else { [k, j] };
                let has = |&k: &usize| self.is_cell_side_point(direction, cell(k)[0], cell(k)[1], t == 1.0);
                let (start, count) = ([j, i][direction], self.cells()[1 - direction]);
                if (t == 0.0 || t == 1.0) && has(&start) {
                    let before = (0..=start).rev().take_while(has);
                    for k in before.chain((start..count).take_while(has)) {
                        let place = |other: f64| if direction == 0 { [t, other] } else { [other, t] };
                        self.add_nearby_normals_to_spread(&mut here, cell(k), [0.0, 0.5, 1.0].map(place));
                    }
                }
            }
        }
        here
    }

    /// Raises the spread of `here` to its largest angle with the normals at `places` of a cell.
    fn add_nearby_normals_to_spread(&self, here: &mut Normal, [i, j]: [usize; 2], places: [[f64; 2]; 3]) {
        for [u, v] in places {
            let other = self.normal(i, j, u, v);
            if other != DVec3::ZERO {
                here.spread = here.spread.max(angle_between_unit_vectors(here.direction, other));
            }
        }
    }

    /// True if a side of a cell is a single point. Direction 0 means the side u = 0 (u = 1 if
    /// `end`), direction 1 the side v = 0 or v = 1.
    pub(crate) fn is_cell_side_point(&self, direction: usize, i: usize, j: usize, end: bool) -> bool {
        each_sheet!(self, cells => {
            let patch = SheetCells::cell_patch(cells, i, j);
            if direction == 0 { patch.is_u_side_point(end) } else { patch.transposed().is_u_side_point(end) }
        })
    }

    /// True if the whole line of nodes before a row (direction 0) or column of cells is a single
    /// point. If `end`, tests the line after it.
    pub(super) fn is_node_line_point(&self, direction: usize, cell: usize, end: bool) -> bool {
        (0..self.cells()[1 - direction]).all(|k| {
            let [i, j] = if direction == 0 { [cell, k] } else { [k, cell] };
            self.is_cell_side_point(direction, i, j, end)
        })
    }
}
