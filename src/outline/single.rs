//! Single curves: one Bézier curve of degree n through n + 1 points.
//!
//! P(t_i) = sum_j B_j J_(N,j)(t_i) = P_i. With the lock by parameter the t_i are given and the equations are linear
//! (collocation). Else each control point is on the guide of its point, B_i = P_i + lambda_i u_i with the guide u_i of the
//! data's own triangle, and the t_i are unknown too; the lock by the section's own triangle has no meaning for a curve
//! without sections, and is taken for the lock by guides.
//!
//! Each end tangent raises the degree N by one: the control point next to the end is on the tangent, at the distance |P_0
//! P_1| / (N t_1) that the speed of the parameter asks for. A closed outline begins and ends at its first point, with the
//! tangent there of the section of the data's own triangle, so that the curve is smooth there as well.

use super::composite;
use super::curve::{MAX_DEGREE, Place};
use super::method::Method;
use super::request::{FitStatus, Lock, Options, PointStatus, Report, Solver};
use super::run::{Run, Sketch, Solved, Workspace, mark};
use super::{segment, sweeps};
use crate::alloc;
use crate::error::Result;
use crate::geom::linear::dense::Dense;
use glam::DVec3;

/// Farther from its point, in sizes of the outline, a control point shows that the equations are nearly singular.
const FAR: f64 = 2.0;

/// A curve that passes its points no nearer than this, times the size, is none.
pub(super) const MISSED: f64 = 1e-12;

/// A point that the curve passes no nearer than this, times the size, is said to be missed by rounding.
const EXACT: f64 = 1e-14;

/// The workspace of single curves: all for the points of the run, the first once more at the end of a closed one.
#[derive(Default)]
pub(super) struct Single {
    pub(super) points: Vec<DVec3>,
    pub(super) t: Vec<f64>,
    /// The guides, of length 1, of the points between the ends.
    pub(super) guides: Vec<DVec3>,
    pub(super) controls: Vec<DVec3>,
    /// The differences of the control points, times the degree: the control points of the derivative.
    pub(super) slopes: Vec<DVec3>,
    pub(super) right: Vec<DVec3>,
    pub(super) kept: Vec<DVec3>,
    pub(super) kept_t: Vec<f64>,
    pub(super) basis: Vec<f64>,
    pub(super) matrix: Dense,
    /// Whether there are end tangents.
    tangents: [bool; 2],
}

/// Appends the single curve of a run.
pub(super) fn curve(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    workspace: &mut Workspace,
    sketch: &mut Sketch,
    report: &mut Report,
) -> Result<()> {
    let tangents = if run.closed { [Some(seam(run, options)); 2] } else { run.tangents };
    let inner = run.points.len() - if run.closed { 0 } else { 1 };
    let degree = inner + tangents.iter().flatten().count();
    if degree > MAX_DEGREE {
        report.status = FitStatus::DegreeTooHigh;
        return instead(run, options, solved, workspace, sketch, report);
    }
    let single = &mut workspace.single;
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
        return instead(run, options, solved, workspace, sketch, report);
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
    workspace: &mut Workspace,
    sketch: &mut Sketch,
    report: &mut Report,
) -> Result<()> {
    let plain = Options { lock: Lock::Parameter, solver: Solver::Fast, ..*options };
    solved.iter_mut().for_each(|solved| mark(solved, PointStatus::FellBack));
    composite::curve(run, &plain, solved, workspace, sketch, report)
}

/// The direction of the section of the first point's triangle there.
fn seam(run: &Run<'_>, options: &Options) -> DVec3 {
    let [a, p, c] = run.triple(0);
    let section = options.method.section(a, p, c).or_else(|_| Method::Bisector.section(a, p, c));
    let direction =
        section.map(|section| (section.control - a) * (1.0 - section.t) + (c - section.control) * section.t);
    // There and back: across.
    direction.ok().and_then(DVec3::try_normalize).unwrap_or_else(|| upright(c - p))
}

/// Says that sweeps have ended before they came to rest.
pub(super) fn unfinished(solved: &mut [Solved], report: &mut Report) {
    report.status = FitStatus::NotConverged;
    solved.iter_mut().for_each(|solved| mark(solved, PointStatus::NotConverged));
}

/// J_(N,j)(t) for all j.
pub(super) fn bernstein(basis: &mut [f64], t: f64) {
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
    pub(super) fn inner(&self) -> usize {
        self.points.len() - 2
    }

    pub(super) fn degree(&self) -> usize {
        self.controls.len() - 1
    }

    /// The control point of point `i`.
    pub(super) fn own(&self, i: usize) -> usize {
        i + usize::from(self.tangents[0])
    }

    /// The parameters by the data's own triangles: neighbouring spans are to each other as t_i to 1 - t_i.
    fn parameters(&mut self, run: &Run<'_>, options: &Options, solved: &mut [Solved]) {
        let last = self.points.len() - 1;
        let (mut sum, mut span) = (1.0, 1.0);
        self.t[0] = 0.0;
        for (i, solved) in solved.iter_mut().enumerate().take(last).skip(1) {
            self.t[i] = sum;
            let [a, p, c] = run.triple(i);
            let t = options.method.parameter(a, p, c).unwrap_or_else(|status| {
                mark(solved, status);
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
        for (i, solved) in solved.iter_mut().enumerate().take(self.inner() + 1).skip(1) {
            let [a, p, c] = run.triple(i);
            let guide = sweeps::guide(options.method, a - p, c - p, normal).or_else(|status| {
                mark(solved, status);
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
    pub(super) fn start_at_points(&mut self) {
        for i in 1..=self.inner() {
            let own = self.own(i);
            self.controls[own] = self.points[i];
        }
    }

    /// Solves the linear equations for the parameters as they are.
    pub(super) fn eliminate(&mut self) -> Result<()> {
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
    pub(super) fn residual(&self) -> (f64, f64) {
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
}

/// A direction across a vector, in the plane z = 0 if that is there.
fn upright(v: DVec3) -> DVec3 {
    let across = if v.z == 0.0 { DVec3::new(-v.y, v.x, 0.0) } else { v.any_orthogonal_vector() };
    across.normalize_or_zero()
}
