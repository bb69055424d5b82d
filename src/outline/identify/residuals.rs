//! Residuals of an identified curve: its distances from the points, and the angles at its joints.

use super::curve_builder::CurveBuilder;
use super::nodes::Nodes;
use super::report::{PointStatus, Report};
use crate::outline::curve::segment;
use glam::DVec3;

/// Measures the curve of an outline near the origin; the joint of a closed curve's end and start
/// counts too. O(segments).
pub(super) fn measure(nodes: &Nodes, curve: &CurveBuilder, report: &mut Report) {
    let size = nodes.placement.size;
    if curve.is_empty() || size == 0.0 {
        return;
    }
    let mut farthest = 0.0f64;
    for (node, result) in nodes.points.iter().zip(&nodes.results) {
        if result.status != PointStatus::Missed {
            let at = segment::point(curve.segment(result.place.segment as usize), result.place.t);
            farthest = farthest.max(at.distance_squared(*node));
        }
    }
    report.max_residual = farthest.sqrt() / size;

    let mut angle = MaxJointSine::default();
    let mut corners = curve.corners().iter().peekable();
    let joints = if nodes.closed { 1..curve.len() + 1 } else { 1..curve.len() };
    for joint in joints {
        if corners.next_if(|&&corner| corner as usize == joint).is_none() {
            let next = if joint == curve.len() { 0 } else { joint };
            angle.add(segment::last_leg(curve.segment(joint - 1)), segment::first_leg(curve.segment(next)));
        }
    }
    report.max_joint_sine = report.max_joint_sine.max(angle.sine());
}

/// The largest sine of the angle between the legs on both sides of a joint.
#[derive(Default)]
pub(super) struct MaxJointSine {
    /// sin^2 = |u x v|^2 / (|u|^2 |v|^2).
    squared: f64,
}

impl MaxJointSine {
    /// Adds the joint between the legs `u`, which ends there, and `v`, which begins there. Legs
    /// without length are passed over.
    #[inline]
    pub(super) fn add(&mut self, u: DVec3, v: DVec3) {
        let (across, lengths) = (u.cross(v).length_squared(), u.length_squared() * v.length_squared());
        // The division only where it is the largest so far.
        if across > self.squared * lengths && lengths > 0.0 {
            self.squared = across / lengths;
        }
        if u.dot(v) < 0.0 {
            // A cusp.
            self.squared = 1.0;
        }
    }

    pub(super) fn sine(&self) -> f64 {
        self.squared.sqrt().min(1.0)
    }
}
