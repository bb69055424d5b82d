//! How well a curve does what it should: how far it misses the points, and how far its joints are from smooth.

use super::request::{PointStatus, Report};
use super::run::{Sketch, Solved};
use super::segment;
use glam::DVec3;

/// Measures the curve of an outline near the origin; the joint of a closed curve's end and start counts too.
pub(super) fn judge(nodes: &[DVec3], solved: &[Solved], sketch: &Sketch, closed: bool, size: f64, report: &mut Report) {
    if sketch.is_empty() || size == 0.0 {
        return;
    }
    let mut farthest = 0.0f64;
    for (node, solved) in nodes.iter().zip(solved) {
        if solved.status != PointStatus::Missed {
            let at = segment::point(sketch.segment(solved.place.segment as usize), solved.place.t);
            farthest = farthest.max(at.distance_squared(*node));
        }
    }
    report.max_residual = farthest.sqrt() / size;

    let mut smoothness = Smoothness::default();
    let mut corners = sketch.corners().iter().peekable();
    let joints = if closed { 1..sketch.len() + 1 } else { 1..sketch.len() };
    for joint in joints {
        if corners.next_if(|&&corner| corner as usize == joint).is_none() {
            let next = if joint == sketch.len() { 0 } else { joint };
            smoothness.joint(segment::last_leg(sketch.segment(joint - 1)), segment::first_leg(sketch.segment(next)));
        }
    }
    report.max_joint_sine = report.max_joint_sine.max(smoothness.sine());
}

/// The largest sine of the angle between the legs on both sides of a joint.
#[derive(Default)]
pub(super) struct Smoothness {
    /// sin^2 = |u x v|^2 / (|u|^2 |v|^2).
    largest: f64,
}

impl Smoothness {
    /// Takes the joint between the legs `u`, which ends there, and `v`, which begins there. A leg without length is none.
    #[inline]
    pub(super) fn joint(&mut self, u: DVec3, v: DVec3) {
        let (across, lengths) = (u.cross(v).length_squared(), u.length_squared() * v.length_squared());
        // Divided only where it is the largest so far.
        if across > self.largest * lengths && lengths > 0.0 {
            self.largest = across / lengths;
        }
        if u.dot(v) < 0.0 {
            // A cusp.
            self.largest = 1.0;
        }
    }

    pub(super) fn sine(&self) -> f64 {
        self.largest.sqrt().min(1.0)
    }
}
