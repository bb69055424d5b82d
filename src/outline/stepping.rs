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
pub(super) fn step(
    options: &Options,
    size: f64,
    deviation: impl Fn(f64) -> f64,
    steps: &mut u64,
) -> Option<f64> {
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
/// the guide at P. The crossing is that of the curve with the guide: with f = 0 on the guide, t / (1 - t) = sqrt(-f(A) / f(C)), wherever B is.
///
/// # Errors
/// Those of [`Method::section`]; [`PointStatus::Collinear`] if the guide is along the chord, [`PointStatus::NotConverged`] if the steps are used up.
pub fn step_section(
    a: DVec3,
    p: DVec3,
    c: DVec3,
    method: Method,
    options: &Options,
) -> Result<(Section, u64), PointStatus> {
    let wanted = method.section(a, p, c)?;
    let (u, w) = (a - p, c - p);
    let size = u.abs().max_element().max(w.abs().max_element()).max((c - a).abs().max_element());
    // The foot divides the chord as the squares of t and 1 - t.
    let (after, before) = (wanted.t * wanted.t, (1.0 - wanted.t) * (1.0 - wanted.t));
    let guide = -(u * before + w * after) / (before + after);
    if guide.length() <= 1e-14 * size {
        // P is the foot: B has nowhere to go.
        return Ok((Section { control: p, t: wanted.t }, 0));
    }
    let guide = guide.normalize();
    let normal = (c - a) - guide * (c - a).dot(guide);
    let (before, after) = (-normal.dot(u), normal.dot(w));
    if normal.length() <= 1e-9 * size || before <= 0.0 || after <= 0.0 {
        return Err(PointStatus::Collinear);
    }
    let (before, after) = (before.sqrt(), after.sqrt());
    let t = before / (before + after);
    let s = 1.0 - t;
    let still = u.dot(guide) * s * s + w.dot(guide) * t * t;
    let mut steps = 0;
    let along = step(options, size, |x| -(still + 2.0 * t * s * x), &mut steps).ok_or(PointStatus::NotConverged)?;
    Ok((Section { control: p + guide * along, t }, steps))
}
