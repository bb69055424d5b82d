//! Single curves: one Bézier curve of degree n through n + 1 points.
//!
//! P(t_i) = sum_j B_j J_(N,j)(t_i) = P_i. With the lock by parameter the t_i are given and the equations are linear (collocation). Else each
//! control point is on the guide of its point, B_i = P_i + lambda_i u_i with the guide u_i of the data's own triangle, and the t_i are
//! unknown too; the lock by the section's own triangle has no meaning for a curve without sections, and is taken for the lock by guides.
//!
//! The paper solves by sweeps: t_i is the crossing of curve and guide, which does not depend on lambda_i, and then lambda_i += u_i.(P_i - P(t_i)) /
//! J_i(t_i). The errors that change sign from point to point fade slowly: the number of sweeps doubles with each degree. After a
//! few sweeps Newton's method goes on: across the curve, with c_i perpendicular to P'(t_i),
//!
//! sum_j J_j(t_i) (c_i.u_j) dlambda_j = c_i.r_i,    dt_i = P'(t_i).(r_i - sum_j J_j(t_i) u_j dlambda_j) / |P'(t_i)|^2,    r_i = P_i - P(t_i).
//!
//! Each end tangent raises the degree N by one: the control point next to the end is on the tangent, at the distance |P_0 P_1| / (N t_1) that
//! the speed of the parameter asks for. A closed outline begins and ends at its first point, with the tangent there of the section of the
//! data's own triangle, so that the curve is smooth there as well.

use super::composite;
use super::curve::{MAX_DEGREE, Place};
use super::dense::Dense;
use super::method::Method;
use super::request::{FitStatus, Lock, Options, PointStatus, Report, Solver};
use super::run::{Room, Run, Sketch, Solved, mark};
use super::{segment, stepping, sweeps};
use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// Sweeps before Newton's method.
const SWEEPS: u32 = 8;

/// The most iterations of Newton's method.
const ITERATIONS: u32 = 30;

/// Farther from its point, in sizes of the outline, a control point shows that the equations are nearly singular.
const FAR: f64 = 2.0;

/// A curve that passes its points no nearer than this, times the size, is none.
const MISSED: f64 = 1e-12;

/// A point that the curve passes no nearer than this, times the size, is said to be missed by rounding.
const EXACT: f64 = 1e-14;

/// The room of single curves: all for the points of the run, the first once more at the end of a closed one.
#[derive(Default)]
pub(super) struct Single {
    points: Vec<DVec3>,
    t: Vec<f64>,
    /// The guides, of length 1, of the points between the ends.
    guides: Vec<DVec3>,
    controls: Vec<DVec3>,
    /// The differences of the control points, times the degree: the control points of the derivative.
    slopes: Vec<DVec3>,
    right: Vec<DVec3>,
    kept: Vec<DVec3>,
    kept_t: Vec<f64>,
    basis: Vec<f64>,
    matrix: Dense,
    /// Whether there are end tangents.
    tangents: [bool; 2],
}

/// Appends the single curve of a run.
pub(super) fn curve(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    room: &mut Room,
    sketch: &mut Sketch,
    report: &mut Report,
) -> Result<()> {
    let tangents = if run.closed { [Some(seam(run, options)); 2] } else { run.tangents };
    let inner = run.points.len() - if run.closed { 0 } else { 1 };
    let degree = inner + tangents.iter().flatten().count();
    if degree > MAX_DEGREE {
        report.status = FitStatus::DegreeTooHigh;
        return instead(run, options, solved, room, sketch, report);
    }
    let single = &mut room.single;
    single.begin(run, degree)?;
    let normal = if options.lock == Lock::Parameter { None } else { sweeps::plane(run) };
    if options.lock != Lock::Parameter && normal.is_none() {
        solved.iter_mut().for_each(|solved| mark(solved, PointStatus::OutOfPlane));
    }
    single.parameters(run, options, solved);
    single.place_ends(tangents);
    let mut done = false;
    if let Some(normal) = normal {
        single.find_guides(run, options, solved, normal);
        done = single.on_guides(run, options, solved, normal, report)?;
        if !done {
            report.status = FitStatus::NotConverged;
            solved.iter_mut().for_each(|solved| mark(solved, PointStatus::FellBack));
            single.parameters(run, options, solved);
            single.place_ends(tangents);
        }
    }
    if !done {
        single.collocate(run, options, solved, report)?;
    }
    if single.farthest() > FAR * run.size {
        report.status = FitStatus::IllConditioned;
    }
    let misses = single.residual().0;
    if misses.is_nan() || misses > MISSED * run.size {
        report.status = FitStatus::IllConditioned;
        return instead(run, options, solved, room, sketch, report);
    }
    for (i, solved) in solved.iter_mut().enumerate() {
        if single.distance(i) > EXACT * run.size {
            mark(solved, PointStatus::NotConverged);
        }
    }
    let segment = sketch.len() as u32;
    for (solved, &t) in solved.iter_mut().zip(&single.t) {
        solved.place = Place { segment, t };
    }
    sketch.begin(single.controls[0])?;
    sketch.push(&single.controls[1..])
}

/// A composite curve by parameters instead.
fn instead(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    room: &mut Room,
    sketch: &mut Sketch,
    report: &mut Report,
) -> Result<()> {
    let plain = Options { lock: Lock::Parameter, solver: Solver::Fast, ..*options };
    solved.iter_mut().for_each(|solved| mark(solved, PointStatus::FellBack));
    composite::curve(run, &plain, solved, room, sketch, report)
}

/// The direction of the section of the first point's triangle there.
fn seam(run: &Run<'_>, options: &Options) -> DVec3 {
    let [a, p, c] = run.triple(0);
    let section = options.method.section(a, p, c).or_else(|_| Method::Bisector.section(a, p, c));
    let direction =
        section.map(|section| (section.control - a) * (1.0 - section.t) + (c - section.control) * section.t);
    // There and back: across.
    direction.ok().and_then(DVec3::try_normalize).unwrap_or_else(|| (c - p).any_orthogonal_vector().normalize_or_zero())
}

/// Says that sweeps have ended before they came to rest.
fn unfinished(solved: &mut [Solved], report: &mut Report) {
    report.status = FitStatus::NotConverged;
    solved.iter_mut().for_each(|solved| mark(solved, PointStatus::NotConverged));
}

/// J_(N,j)(t) for all j.
fn bernstein(basis: &mut [f64], t: f64) {
    let degree = basis.len() - 1;
    basis[0] = 1.0;
    // Degree by degree: J_(k,j) = (1 - t) J_(k-1,j) + t J_(k-1,j-1).
    for k in 1..=degree {
        basis[k] = t * basis[k - 1];
        for j in (1..k).rev() {
            basis[j] = (1.0 - t) * basis[j] + t * basis[j - 1];
        }
        basis[0] *= 1.0 - t;
    }
}

impl Single {
    fn begin(&mut self, run: &Run<'_>, degree: usize) -> Result<()> {
        let count = run.points.len() + usize::from(run.closed);
        self.points.clear();
        self.t.clear();
        alloc::reserve(&mut self.points, count)?;
        alloc::reserve(&mut self.t, count)?;
        self.points.extend_from_slice(run.points);
        if run.closed {
            self.points.push(run.points[0]);
        }
        self.t.resize(count, 0.0);
        for list in [&mut self.controls, &mut self.slopes, &mut self.right, &mut self.guides, &mut self.kept] {
            list.clear();
            alloc::reserve(list, degree + 1)?;
            list.resize(degree + 1, DVec3::ZERO);
        }
        for list in [&mut self.basis, &mut self.kept_t] {
            list.clear();
            alloc::reserve(list, degree + 1)?;
            list.resize(degree + 1, 0.0);
        }
        Ok(())
    }

    /// The number of points between the ends.
    fn inner(&self) -> usize {
        self.points.len() - 2
    }

    fn degree(&self) -> usize {
        self.controls.len() - 1
    }

    /// The control point of point `i`.
    fn own(&self, i: usize) -> usize {
        i + usize::from(self.tangents[0])
    }

    /// The parameters by the data's own triangles: neighbouring spans are to each other as t_i to 1 - t_i.
    fn parameters(&mut self, run: &Run<'_>, options: &Options, solved: &mut [Solved]) {
        let last = self.points.len() - 1;
        let (mut sum, mut span) = (1.0, 1.0);
        self.t[0] = 0.0;
        for i in 1..last {
            self.t[i] = sum;
            let [a, p, c] = run.triple(i);
            let t = options.method.parameter(a, p, c).unwrap_or_else(|status| {
                mark(&mut solved[i], status);
                Method::Bisector.parameter(a, p, c).unwrap_or(0.5)
            });
            span *= (1.0 - t).max(1e-9) / t.max(1e-9);
            sum += span;
        }
        self.t[last] = sum;
        self.t.iter_mut().for_each(|t| *t /= sum);
    }

    /// Places the ends, and the control points next to them on the tangents.
    fn place_ends(&mut self, tangents: [Option<DVec3>; 2]) {
        let (last, degree) = (self.points.len() - 1, self.degree());
        self.tangents = tangents.map(|tangent| tangent.is_some());
        self.controls[0] = self.points[0];
        self.controls[degree] = self.points[last];
        let reach = |from: DVec3, to: DVec3, t: f64| from.distance(to) / (degree as f64 * t).max(1.0 / 64.0);
        if let Some(tangent) = tangents[0] {
            let length = reach(self.points[0], self.points[1], self.t[1]);
            self.controls[1] = self.points[0] + tangent * length;
        }
        if let Some(tangent) = tangents[1] {
            let length = reach(self.points[last], self.points[last - 1], 1.0 - self.t[last - 1]);
            self.controls[degree - 1] = self.points[last] - tangent * length;
        }
    }

    /// The guides of the points between the ends; where the method has none, that of the bisector.
    fn find_guides(&mut self, run: &Run<'_>, options: &Options, solved: &mut [Solved], normal: DVec3) {
        for i in 1..=self.inner() {
            let [a, p, c] = run.triple(i);
            let guide = sweeps::guide(options.method, a - p, c - p, normal).or_else(|status| {
                mark(&mut solved[i], status);
                sweeps::guide(Method::Bisector, a - p, c - p, normal)
            });
            self.guides[i] = guide.unwrap_or_else(|_| normal.any_orthonormal_vector());
        }
    }

    /// Finds the control points for the parameters as they are.
    fn collocate(
        &mut self,
        run: &Run<'_>,
        options: &Options,
        solved: &mut [Solved],
        report: &mut Report,
    ) -> Result<()> {
        if options.solver == Solver::Step {
            self.start_at_points();
            if !self.sweep(run, options, None, options.max_sweeps, report) {
                unfinished(solved, report);
            }
        }
        self.eliminate()
    }

    /// Puts the control points on their points, where the paper begins.
    fn start_at_points(&mut self) {
        for i in 1..=self.inner() {
            let own = self.own(i);
            self.controls[own] = self.points[i];
        }
    }

    /// Solves the linear equations for the parameters as they are.
    fn eliminate(&mut self) -> Result<()> {
        let (inner, first) = (self.inner(), self.own(1));
        (1..=inner).for_each(|i| {
            let own = self.own(i);
            self.controls[own] = DVec3::ZERO;
        });
        self.matrix.resize(inner)?;
        for i in 1..=inner {
            bernstein(&mut self.basis, self.t[i]);
            self.matrix.row(i - 1).copy_from_slice(&self.basis[first..first + inner]);
        }
        if !self.matrix.factor() {
            self.start_at_points();
            return Ok(());
        }
        // What is left after the first time is rounding, and the second time takes most of it away.
        for _ in 0..3 {
            for i in 1..=inner {
                self.right[i - 1] = self.points[i] - segment::point(&self.controls, self.t[i]);
            }
            self.matrix.solve(&mut self.right[..inner]);
            for i in 1..=inner {
                let own = self.own(i);
                self.controls[own] += self.right[i - 1];
            }
        }
        Ok(())
    }

    /// The farthest control point from its point.
    fn farthest(&self) -> f64 {
        let away = |i: usize| self.controls[self.own(i)].distance(self.points[i]);
        (1..=self.inner()).map(away).fold(0.0, f64::max).min(1e300)
    }

    /// The distance of a point from its place on the curve.
    fn distance(&self, i: usize) -> f64 {
        segment::point(&self.controls, self.t[i]).distance(self.points[i])
    }

    /// The farthest point from its place on the curve, and the sum of the squares of the distances.
    fn residual(&self) -> (f64, f64) {
        let (mut farthest, mut sum) = (0.0f64, 0.0);
        for i in 1..=self.inner() {
            let square = self.distance(i).powi(2);
            if square > farthest || square.is_nan() {
                farthest = square;
            }
            sum += square;
        }
        (farthest.sqrt(), sum)
    }

    /// Finds control points on the guides. False if it fails.
    fn on_guides(
        &mut self,
        run: &Run<'_>,
        options: &Options,
        solved: &mut [Solved],
        normal: DVec3,
        report: &mut Report,
    ) -> Result<bool> {
        self.start_at_points();
        if options.solver == Solver::Fast {
            self.sweep(run, options, Some(normal), SWEEPS.min(options.max_sweeps), report);
            report.iterations = 0;
            return self.newton(run, options, normal, report);
        }
        let rests = self.sweep(run, options, Some(normal), options.max_sweeps, report);
        if !self.is_in_order() {
            return Ok(false);
        }
        if !rests {
            unfinished(solved, report);
        }
        // What the steps leave of the deviations; the guides are left by no more than that.
        self.eliminate()?;
        Ok(self.residual().0 <= MISSED * run.size)
    }

    /// Whether the parameters rise from 0 to 1.
    fn is_in_order(&self) -> bool {
        self.t.windows(2).all(|pair| pair[0] < pair[1])
    }

    /// The paper's sweeps. With the normal of the plane along the guides, else for the parameters as they are, along the deviations. True
    /// if they come to rest.
    fn sweep(
        &mut self,
        run: &Run<'_>,
        options: &Options,
        normal: Option<DVec3>,
        count: u32,
        report: &mut Report,
    ) -> bool {
        let tolerance = options.tolerance.max(f64::EPSILON) * run.size;
        for _ in 0..count {
            report.iterations += 1;
            let mut farthest = 0.0f64;
            for i in 1..=self.inner() {
                let (own, p) = (self.own(i), self.points[i]);
                if let Some(normal) = normal {
                    // A point whose guide the curve does not cross keeps its parameter.
                    if let Some(t) = self.crossing(p, normal.cross(self.guides[i]), self.t[i]) {
                        self.t[i] = t;
                    }
                }
                bernstein(&mut self.basis, self.t[i]);
                let slope = self.basis[own];
                let left = p - segment::point(&self.controls, self.t[i]);
                let direction = if normal.is_some() { self.guides[i] } else { left.normalize_or_zero() };
                let along = match options.solver {
                    Solver::Fast => direction.dot(left) / slope,
                    Solver::Step => {
                        let deviation = |x: f64| direction.dot(left) - slope * x;
                        stepping::step(options, run.size, deviation, &mut report.steps).unwrap_or(0.0)
                    }
                };
                // Lost; Newton's method or the lock by parameters may do better.
                if !(along.abs() < 1e3 * run.size) {
                    return false;
                }
                self.controls[own] += direction * along;
                farthest = farthest.max(along.abs());
            }
            report.last_move = farthest / run.size;
            if farthest <= tolerance {
                return true;
            }
        }
        false
    }

    /// The place nearest `from` where the curve crosses the line through a point with a normal.
    fn crossing(&self, p: DVec3, across: DVec3, from: f64) -> Option<f64> {
        let f = |t: f64| across.dot(segment::point(&self.controls, t) - p);
        let start = f(from);
        if start == 0.0 {
            return Some(from);
        }
        let step = 0.125 / self.degree() as f64;
        let mut known = [(from, start); 2];
        for _ in 0..8 * self.degree() {
            for (side, sign) in [(0, -1.0), (1, 1.0)] {
                let (t, value) = known[side];
                let next = (t + sign * step).clamp(0.0, 1.0);
                if next == t {
                    continue;
                }
                known[side] = (next, f(next));
                if (known[side].1 > 0.0) != (value > 0.0) {
                    let root = root(f, (t, value), known[side]);
                    return (root > 0.0 && root < 1.0).then_some(root);
                }
            }
        }
        None
    }

    /// Newton's method for the places on the guides and the parameters together.
    fn newton(&mut self, run: &Run<'_>, options: &Options, normal: DVec3, report: &mut Report) -> Result<bool> {
        let (inner, first, degree) = (self.inner(), self.own(1), self.degree());
        let tolerance = options.tolerance.max(2.0 * f64::EPSILON) * run.size;
        let mut worth = self.residual();
        let mut near = false;
        for _ in 0..ITERATIONS.min(options.max_sweeps) {
            if !worth.0.is_finite() {
                return Ok(false);
            }
            report.iterations += 1;
            self.kept.copy_from_slice(&self.controls);
            self.kept_t[..inner].copy_from_slice(&self.t[1..=inner]);
            for k in 0..degree {
                self.slopes[k] = (self.controls[k + 1] - self.controls[k]) * degree as f64;
            }
            self.matrix.resize(inner)?;
            for i in 1..=inner {
                let slope = segment::point(&self.slopes[..degree], self.t[i]);
                let across = normal.cross(slope);
                let left = self.points[i] - segment::point(&self.controls, self.t[i]);
                bernstein(&mut self.basis, self.t[i]);
                let row = self.matrix.row(i - 1);
                for j in 1..=inner {
                    row[j - 1] = self.basis[first + j - 1] * across.dot(self.guides[j]);
                }
                self.right[i - 1] = DVec3::new(across.dot(left), 0.0, 0.0);
            }
            if !self.matrix.factor() {
                return Ok(false);
            }
            self.matrix.solve(&mut self.right[..inner]);
            // The steps of the parameters, with the control points before and after.
            for j in 1..=inner {
                self.controls[first + j - 1] += self.guides[j] * self.right[j - 1].x;
            }
            for i in 1..=inner {
                let slope = segment::point(&self.slopes[..degree], self.kept_t[i - 1]);
                let left = self.points[i] - segment::point(&self.controls, self.kept_t[i - 1]);
                self.right[i - 1].y = slope.dot(left) / slope.length_squared();
            }
            let mut share = 1.0;
            let next = loop {
                for i in 1..=inner {
                    self.t[i] = self.kept_t[i - 1] + share * self.right[i - 1].y;
                    let own = first + i - 1;
                    self.controls[own] = self.kept[own] + self.guides[i] * (share * self.right[i - 1].x);
                }
                let next = self.residual();
                if (next.1 < worth.1 || next.0 <= tolerance) && self.is_in_order() {
                    break Some(next);
                }
                share *= 0.5;
                if share < 1e-3 {
                    break None;
                }
            };
            let Some(next) = next else {
                // No better, as it is as good as it can be?
                self.controls.copy_from_slice(&self.kept);
                self.t[1..=inner].copy_from_slice(&self.kept_t[..inner]);
                return Ok(near);
            };
            worth = next;
            let moved = (1..=inner).map(|i| self.right[i - 1].x.abs()).fold(0.0, f64::max);
            report.last_move = share * moved / run.size;
            // Once the points are passed within the tolerance, one more step takes the rest away.
            if near || (worth.0 <= tolerance && moved <= tolerance) {
                return Ok(worth.0 <= tolerance);
            }
            near = worth.0 <= tolerance;
        }
        Ok(false)
    }
}

/// The root of a function between two places where its signs differ: false position, with the value at an end that stays halved (the
/// Illinois rule), to the last bits.
fn root(f: impl Fn(f64) -> f64, a: (f64, f64), b: (f64, f64)) -> f64 {
    let ((mut x, mut fx), (mut y, mut fy)) = (a, b);
    for _ in 0..100 {
        let mut z = y - fy * (y - x) / (fy - fx);
        if !(x.min(y) <= z && z <= x.max(y)) {
            z = 0.5 * (x + y);
        }
        let fz = f(z);
        if fz == 0.0 || (z - y).abs() <= 1e-16 {
            return z;
        }
        if (fz > 0.0) != (fy > 0.0) {
            (x, fx) = (y, fy);
        } else {
            fx *= 0.5;
        }
        (y, fy) = (z, fz);
    }
    y
}
