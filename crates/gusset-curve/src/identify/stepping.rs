//! The paper's search for a control point: steps along a direction, refined tenfold where the
//! deviation changes its sign.
//!
//! There are three differences from the paper. A step follows the unit vector of the guide instead
//! of y, because a guide may be horizontal. It has the sign of the deviation, so it may be
//! negative. The search ends when the step or the deviation is small, not at the first change of
//! sign. It takes O(log(1 / tolerance)) steps after the first change of sign, and steps of
//! first_step before.
//!
//! Source: Nadopta, points 4 to 6 of the method of the normal, and the method of the tangent.

use super::identify_options::Options;
use super::method::{Method, Section};
use super::report::PointStatus;
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// The number of steps in a tenth of a second, if each evaluates a whole curve of some points.
const STEPS_PER_REPORT: u64 = 1 << 11;
const PROGRESS_STAGE: &str = "stepping along guides";

/// Finds the offset x from 0 on at which `deviation` is 0, and the number of steps. Returns `None`
/// if the steps are used up. The deviation must decrease with x.
pub(super) fn step_until_deviation_is_zero(
    options: &Options,
    size: f64,
    deviation: impl Fn(f64) -> f64,
    steps: &mut u64,
    job: &Job<'_>,
) -> Result<Option<f64>> {
    // The slope of the deviation is 0.28 to 1 in all uses, so the error of an offset exceeds the
    // deviation accordingly.
    let tolerance = (options.tolerance * 0.125).max(f64::EPSILON) * size;
    let (mut x, mut step) = (0.0f64, options.first_step * size);
    let mut flag = 0.0;
    for _ in 0..options.max_steps {
        // Counts over all points, because each may take fewer.
        if steps.is_multiple_of(STEPS_PER_REPORT) {
            job.step(0.0, PROGRESS_STAGE)?;
        }
        let left = deviation(x);
        if left.abs() <= tolerance {
            return Ok(Some(x));
        }
        if left.is_nan() {
            return Ok(None);
        }
        let sign = 1f64.copysign(left);
        if sign * flag < 0.0 {
            if step <= tolerance {
                return Ok(Some(x));
            }
            step /= options.step_divisor;
        }
        flag = sign;
        x += sign * step;
        *steps += 1;
    }
    Ok(None)
}

/// Finds the section from A through P to C by the paper's stepping, and the number of steps. B
/// moves from P along the guide until the curve crosses the guide at P. The crossing has the same
/// parameter for every B, as the paper observes for the normal and as holds for all guides.
///
/// # Errors
/// [`Error::Cancelled`](gusset_base::Error::Cancelled). The section has the errors of
/// [`Method::compute_section`], and [`PointStatus::NotConverged`] if the steps are used up.
pub fn step_section(
    a: DVec3,
    p: DVec3,
    c: DVec3,
    method: Method,
    options: &Options,
    job: &Job<'_>,
) -> Result<Result<(Section, u64), PointStatus>> {
    match method.compute_section(a, p, c) {
        Ok(closed) => step_control_point([a, p, c], closed.t, ControlLine::Guide, options, job),
        Err(failed) => Ok(Err(failed)),
    }
}

/// The line along which steps move the control point of a section.
#[derive(Clone, Copy)]
pub(super) enum ControlLine {
    /// The guide through P, from P on.
    Guide,
    /// The tangent at A in this direction, from A on.
    TangentAtStart(DVec3),
    /// The tangent at C against this direction, from C on.
    TangentAtEnd(DVec3),
}

/// Finds the section from A to C that passes P at parameter t, by steps along a line, and the
/// number of steps. The parameter must be the one at which the curve crosses the line through P
/// for every control point on the control line.
pub(super) fn step_control_point(
    [a, p, c]: [DVec3; 3],
    t: f64,
    line: ControlLine,
    options: &Options,
    job: &Job<'_>,
) -> Result<Result<(Section, u64), PointStatus>> {
    let s = 1.0 - t;
    let (u, w) = (a - p, c - p);
    let size = u.abs().max_element().max(w.abs().max_element()).max((c - a).abs().max_element());
    // The foot divides the chord as t^2 and (1 - t)^2. If P is the foot, the guide lacks a direction.
    let foot = u * (s * s) + w * (t * t);
    let (start, direction) = match line {
        ControlLine::Guide => (DVec3::ZERO, -foot.normalize_or_zero()),
        ControlLine::TangentAtStart(tangent) => (u, tangent.normalize_or_zero()),
        ControlLine::TangentAtEnd(tangent) => (w, -tangent.normalize_or_zero()),
    };
    let still = foot + start * (2.0 * t * s);
    let mut steps = 0;
    let deviation = |x: f64| -(still.dot(direction) + 2.0 * t * s * x);
    let along =
        step_until_deviation_is_zero(options, size, deviation, &mut steps, job)?.ok_or(PointStatus::NotConverged);
    Ok(along.map(|along| (Section { control: p + (start + direction * along), t }, steps)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use gusset_base::error::Error;
    use gusset_base::job::Progress;
    use std::ops::ControlFlow;

    #[test]
    fn steps_are_refined_where_the_sign_changes() {
        let mut steps = 0;
        let options = Options { tolerance: 8e-6, ..Options::default() };
        let mut go = |options: &Options, deviation: fn(f64) -> f64| {
            step_until_deviation_is_zero(options, 1.0, deviation, &mut steps, &Job::default()).unwrap()
        };
        // 0.1 until 0.4, back, then by hundredths and so on.
        let x = go(&options, |x| 0.345_678_9 - x).unwrap();
        assert!((x - 0.345_678_9).abs() <= 1e-6, "{x}");
        // Backwards, and without a direction.
        assert!((go(&options, |x| -0.7 - x).unwrap() + 0.7).abs() <= 1e-6);
        assert_eq!(go(&options, |_| 0.0), Some(0.0));
        // Out of reach, and NaN.
        let few = Options { max_steps: 5, ..options };
        assert_eq!(go(&few, |x| 5.0 - x), None);
        assert_eq!(go(&options, |_| f64::NAN), None);
        assert!((30..120).contains(&steps), "{steps}");
    }

    /// Cancels at the first report.
    struct CancelAtOnce;

    impl Progress for CancelAtOnce {
        fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
            ControlFlow::Break(())
        }
    }

    #[test]
    fn small_steps_can_be_cancelled() {
        let options = Options { max_steps: u32::MAX, first_step: 1e-300, ..Options::default() };
        let mut steps = 0;
        let stopped = step_until_deviation_is_zero(&options, 1.0, |x| 1.0 - x, &mut steps, &Job::new(1, &CancelAtOnce));
        assert_eq!(stopped, Err(Error::Cancelled));
        assert!(steps < 1_000_000, "{steps}");
    }
}
