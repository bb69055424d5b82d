//! Curves through any points, of every kind and method: finite ones, or an error.

use crate::input;
use crate::input::{Cloud, places};
use gusset::Job;
use gusset::curve::{CurveKind, Ends, JointParameter, Lock, Options, Outlines, Points, fit};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some(input) = input::taken::<(Cloud, bool, [u8; 4])>(bytes) else { return };
    let (points, closed, [curve_kind, lock, joint, ends]) = input;
    let points: Vec<[f64; 3]> = places(&points).iter().map(|point| point.to_array()).collect();
    if points.len() > 64 {
        return;
    }
    use CurveKind::{BlendC1, BlendC2, Chain, Composite, CubicC2, Single};
    let options = Options {
        curve: [BlendC1, BlendC2, Composite, CubicC2, Single, Chain][usize::from(curve_kind % 6)],
        lock: [Lock::Parameter, Lock::SelfConsistent, Lock::DataGuide][usize::from(lock % 3)],
        joint: [JointParameter::Half, JointParameter::Knot, JointParameter::G2][usize::from(joint % 3)],
        ends: [Ends::Free, Ends::Perpendicular, Ends::LevelOrUpright][usize::from(ends % 3)],
        ..Options::default()
    };
    let outlines = Outlines { points: Points::from(&points[..]), offsets: None, closed, constraints: &[] };
    if let Ok(found) = fit(&outlines, &options, &Job::default()) {
        assert!(found.points().iter().all(|point| point.is_finite()));
    }
}
