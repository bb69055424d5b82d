//! Two curves, or a curve and its copy: common points lie on both, and near points have the
//! reported distance.

use crate::agree::agreed;
use crate::distance;
use crate::input::{self, SmallCurve};
use gusset::curve::CurveView;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((a, b, equal, within, choice)) = input::taken::<(SmallCurve, SmallCurve, bool, u8, u8)>(bytes) else {
        return;
    };
    let Some(first) = a.curve(true) else { return };
    let Some(second) = (if equal { a.curve(true) } else { b.curve(true) }) else { return };
    meet(&first.view(), &second.view(), choice);
    let (Some(first), Some(second)) = (a.curve(false), b.curve(false)) else { return };
    let (first, second) = (first.view(), second.view());
    let within = f64::from(within) / 4.0;
    if let Ok(found) = agreed(choice, |job| first.near_misses(&second, within, job)) {
        let slack = 1e-9 * size(&first, &second);
        for near in &found.places {
            let [p, q] = [first.point(near.a), second.point(near.b)].map(|point| point.expect("a place of the curve"));
            assert!(
                (distance(p, q) - near.distance).abs() <= slack && near.distance <= within + slack,
                "{near:?} {p} {q}"
            );
        }
    }
}

fn meet(first: &CurveView<'_>, second: &CurveView<'_>, choice: u8) {
    // Where curves touch, half of the digits of the places are left, and fewer where they osculate.
    let slack = 1e-4 * size(first, second);
    if let Ok(found) = agreed(choice, |job| first.intersections(second, job)) {
        for both in &found.points {
            let [p, q] = [first.point(both.a), second.point(both.b)].map(|point| point.expect("a place of the curve"));
            assert!(distance(p, q) <= slack, "{both:?}: {p} {q}");
        }
    }
}

fn size(a: &CurveView<'_>, b: &CurveView<'_>) -> f64 {
    a.points().iter().chain(b.points()).fold(0.0, |size, point| point.abs().max_element().max(size))
}
