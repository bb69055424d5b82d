//! The paper's search for a control point: steps along a direction, refined tenfold where the
//! deviation changes its sign.
//!
//! Unlike the paper's, a step is along the unit vector of the guide, not in y, as a guide may be
//! level; it has the sign of the deviation, and may go down; and the search ends when the step or
//! the deviation is small, not at the first change of sign. O(log(1 / tolerance)) steps once the
//! sign has changed, first_step apart before.
//!
//! Source: Nadopta, points 4 to 6 of the method of the normal.

use super::identify_options::Options;
use super::method::{Method, Section};
use super::report::PointStatus;
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Steps of a tenth of a second, where each takes a whole curve of some points.
const STEPS_PER_REPORT: u64 = 1 << 11;
const STAGE: &str = "stepping along guides";

/// The offset x at which `deviation` is 0, from x = 0 on, and the number of steps; `None` if the
/// steps are used up. The deviation falls with x.
pub(super) fn step(
    options: &Options,
    size: f64,
    deviation: impl Fn(f64) -> f64,
    steps: &mut u64,
    job: &Job<'_>,
) -> Result<Option<f64>> {
    // The deviation has a slope of 0.28 to 1 in all uses: the error of an offset is that much more
    // than the deviation.
    let tolerance = (options.tolerance * 0.125).max(f64::EPSILON) * size;
    let (mut x, mut step) = (0.0f64, options.first_step * size);
    let mut flag = 0.0;
    for _ in 0..options.max_steps {
        // Of all points: each may take fewer.
        if steps.is_multiple_of(STEPS_PER_REPORT) {
            job.step(0.0, STAGE)?;
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

/// The section from A through P to C by the paper's stepping, and the number of steps: B goes from
/// P along the guide, until the curve crosses the guide at P. It crosses it at the same parameter
/// wherever B is, as the paper observes of the normal and as holds for all guides.
///
/// # Errors
/// [`Error::Cancelled`](gusset_base::Error::Cancelled). Of the section: those of [`Method::section`];
/// [`PointStatus::NotConverged`] if the steps are used up.
pub fn step_section(
    a: DVec3,
    p: DVec3,
    c: DVec3,
    method: Method,
    options: &Options,
    job: &Job<'_>,
) -> Result<Result<(Section, u64), PointStatus>> {
    let t = match method.section(a, p, c) {
        Ok(closed) => closed.t,
        Err(failed) => return Ok(Err(failed)),
    };
    let s = 1.0 - t;
    let (u, w) = (a - p, c - p);
    let size = u.abs().max_element().max(w.abs().max_element()).max((c - a).abs().max_element());
    // From the foot, which divides the chord as t^2 and (1 - t)^2, to the point. A point that is
    // the foot has nowhere to go.
    let still = u * (s * s) + w * (t * t);
    let guide = -still.normalize_or_zero();
    let mut steps = 0;
    let deviation = |x: f64| -(still.dot(guide) + 2.0 * t * s * x);
    let along = step(options, size, deviation, &mut steps, job)?.ok_or(PointStatus::NotConverged);
    Ok(along.map(|along| (Section { control: p + guide * along, t }, steps)))
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
            step(options, 1.0, deviation, &mut steps, &Job::default()).unwrap()
        };
        // 0.1 until 0.4, back, then by hundredths and so on.
        let x = go(&options, |x| 0.345_678_9 - x).unwrap();
        assert!((x - 0.345_678_9).abs() <= 1e-6, "{x}");
        // The other way, and nowhere to go.
        assert!((go(&options, |x| -0.7 - x).unwrap() + 0.7).abs() <= 1e-6);
        assert_eq!(go(&options, |_| 0.0), Some(0.0));
        // Out of reach, and not a number.
        let few = Options { max_steps: 5, ..options };
        assert_eq!(go(&few, |x| 5.0 - x), None);
        assert_eq!(go(&options, |_| f64::NAN), None);
        assert!((30..120).contains(&steps), "{steps}");
    }

    /// Cancels.
    struct Enough;

    impl Progress for Enough {
        fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
            ControlFlow::Break(())
        }
    }

    #[test]
    fn small_steps_can_be_cancelled() {
        let options = Options { max_steps: u32::MAX, first_step: 1e-300, ..Options::default() };
        let mut steps = 0;
        let stopped = step(&options, 1.0, |x| 1.0 - x, &mut steps, &Job::new(1, &Enough));
        assert_eq!(stopped, Err(Error::Cancelled));
        assert!(steps < 1_000_000, "{steps}");
    }
}
