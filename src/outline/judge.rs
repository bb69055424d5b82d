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

    // sin^2 = |u x v|^2 / (|u|^2 |v|^2), divided only where it is the largest so far.
    let mut largest = 0.0f64;
    let mut corners = sketch.corners().iter().peekable();
    let joints = if closed { 1..sketch.len() + 1 } else { 1..sketch.len() };
    for joint in joints {
        if corners.next_if(|&&corner| corner as usize == joint).is_some() {
            continue;
        }
        let next = if joint == sketch.len() { 0 } else { joint };
        let (u, v) = (segment::last_leg(sketch.segment(joint - 1)), segment::first_leg(sketch.segment(next)));
        let (across, lengths) = (u.cross(v).length_squared(), u.length_squared() * v.length_squared());
        if across > largest * lengths && lengths > 0.0 {
            largest = across / lengths;
        }
        if u.dot(v) < 0.0 && lengths > 0.0 {
            // A cusp.
            largest = largest.max(1.0);
        }
    }
    report.max_joint_sine = largest.sqrt().min(1.0);
}
