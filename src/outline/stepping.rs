//! The paper's way to a control point: steps along a direction, refined tenfold where the deviation changes its sign.
//!
//! The step is along the unit vector of the guide, not in y, as a guide may be level; it goes where the deviation says, not always up; and it
//! ends when the step or the deviation is small, not when the sign changes for the first time.
//!
//! Source: Nadopta, points 4 to 6 of the method of the normal.

use super::method::{Method, Section};
use super::request::{Options, PointStatus};
use glam::DVec3;

/// The offset x at which `deviation` is 0, from x = 0 on, and the number of steps; `None` if the steps are used up. The
/// deviation falls with x.
pub(super) fn step(options: &Options, size: f64, deviation: impl Fn(f64) -> f64, steps: &mut u64) -> Option<f64> {
    // The deviation has a slope of 0.28 to 1 in our uses: what is left of an offset is that much more than the deviation.
    let tolerance = (options.tolerance * 0.125).max(f64::EPSILON) * size;
    let (mut x, mut step) = (0.0f64, options.first_step * size);
    let mut flag = 0.0;
    for _ in 0..options.max_steps {
        let left = deviation(x);
        if left.abs() <= tolerance {
            return Some(x);
        }
        if left.is_nan() {
            return None;
        }
        let sign = 1f64.copysign(left);
        if sign * flag < 0.0 {
            if step <= tolerance {
                return Some(x);
            }
            step /= options.step_divisor;
        }
        flag = sign;
        x += sign * step;
        *steps += 1;
    }
    None
}

/// The section from A through P to C by the paper's stepping, and the number of steps: B goes from P along the guide, until the curve crosses
/// the guide at P. It crosses it at the same parameter wherever B is, as the paper observes of the normal and as holds for all guides.
///
/// # Errors
/// Those of [`Method::section`]; [`PointStatus::NotConverged`] if the steps are used up.
pub fn step_section(
    a: DVec3,
    p: DVec3,
    c: DVec3,
    method: Method,
    options: &Options,
) -> Result<(Section, u64), PointStatus> {
    let t = method.section(a, p, c)?.t;
    let s = 1.0 - t;
    let (u, w) = (a - p, c - p);
    let size = u.abs().max_element().max(w.abs().max_element()).max((c - a).abs().max_element());
    // From the foot, which divides the chord as t^2 and (1 - t)^2, to the point. A point that is the foot has nowhere to go.
    let still = u * (s * s) + w * (t * t);
    let guide = -still.normalize_or_zero();
    let mut steps = 0;
    let deviation = |x: f64| -(still.dot(guide) + 2.0 * t * s * x);
    let along = step(options, size, deviation, &mut steps).ok_or(PointStatus::NotConverged)?;
    Ok((Section { control: p + guide * along, t }, steps))
}
