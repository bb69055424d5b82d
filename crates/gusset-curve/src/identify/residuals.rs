//! Residuals of an identified curve: its distances from the points, and the angles at its joints.

use super::curve_builder::CurveBuilder;
use super::outline_nodes::OutlineNodes;
use super::report::{PointStatus, Report};
use crate::curve::segment;
use glam::DVec3;

/// Measures the curve of an outline near the origin. The closing joint of a closed curve counts
/// too. O(segments).
pub(super) fn measure_residuals(nodes: &OutlineNodes, curve: &CurveBuilder, report: &mut Report) {
    let size = nodes.placement.box_longest_side;
    if curve.is_empty() || size == 0.0 {
        return;
    }
    let mut farthest = 0.0f64;
    for (node, result) in nodes.points.iter().zip(&nodes.results) {
        if result.status != PointStatus::Missed {
            let at = segment::point_at(curve.segment(result.place.segment as usize), result.place.t);
            farthest = farthest.max(at.distance_squared(*node));
        }
    }
    report.max_residual = farthest.sqrt() / size;

    let mut angle = MaxJointSine::default();
    let mut corners = curve.corner_joints().iter().peekable();
    let joints = if nodes.closed { 1..curve.len() + 1 } else { 1..curve.len() };
    for joint in joints {
        if corners.next_if(|&&corner| corner as usize == joint).is_none() {
            let next = if joint == curve.len() { 0 } else { joint };
            angle.add_joint(
                segment::vector_from_previous_distinct_control(curve.segment(joint - 1)),
                segment::vector_to_next_distinct_control(curve.segment(next)),
            );
        }
    }
    report.max_joint_sine = report.max_joint_sine.max(angle.sine());
}

/// Measures the curvatures on both sides of the joints that should be smooth. If they differ, even
/// by rounding, the points next to the joint get a status. O(segments).
pub(super) fn measure_curvature_gaps(nodes: &mut OutlineNodes, curve: &CurveBuilder, report: &mut Report) {
    let (size, closed) = (nodes.placement.box_longest_side, nodes.closed);
    let gap = |joint: usize| relative_curvature_gap(curve, closed, size, joint);
    report.max_curvature_gap = (0..curve.len()).map(gap).fold(0.0, f64::max);
    for result in &mut nodes.results {
        let segment = result.place.segment as usize;
        if gap(segment).max(gap((segment + 1) % curve.len())) > MAX_RELATIVE_CURVATURE_GAP {
            result.flag_status(PointStatus::NotConverged);
        }
    }
}

/// The largest difference of curvatures that counts as none.
const MAX_RELATIVE_CURVATURE_GAP: f64 = 5e-7;

/// Returns the difference of the curvatures before and after joint k, the start of segment k. It is
/// relative to the larger one, or to 1 / size. It is 0 at corners and at the ends of open curves.
fn relative_curvature_gap(curve: &CurveBuilder, closed: bool, size: f64, joint: usize) -> f64 {
    let corner = if joint == 0 { curve.len() } else { joint } as u32;
    if (joint == 0 && !closed) || curve.corner_joints().binary_search(&corner).is_ok() {
        return 0.0;
    }
    let (before, after) = (curve.segment(corner as usize - 1), curve.segment(joint));
    let ([.., p, q, r], [s, t, u, ..]) = (before, after) else { return 0.0 };
    // Traversed backwards, a curve turns the other way.
    let here = -curvature_vector_at_start(before.len(), [*r, *q, *p]);
    let there = curvature_vector_at_start(after.len(), [*s, *t, *u]);
    here.distance(there) / here.length().max(there.length()).max(1.0 / size)
}

/// Returns the curvature at the start of a segment, as a vector perpendicular to its plane. For
/// degree d and the first control points p, q, r it is (d - 1) / d (q - p) x (r - q) / |q - p|^3.
fn curvature_vector_at_start(count: usize, [p, q, r]: [DVec3; 3]) -> DVec3 {
    let (leg, degree) = (q - p, (count - 1) as f64);
    let length = leg.length();
    if length > 0.0 { leg.cross(r - q) * ((degree - 1.0) / (degree * length.powi(3))) } else { DVec3::ZERO }
}

/// The largest sine of the angle between the legs on both sides of a joint.
#[derive(Default)]
pub(super) struct MaxJointSine {
    /// sin^2 = |u x v|^2 / (|u|^2 |v|^2).
    squared_sine: f64,
}

impl MaxJointSine {
    /// Adds the joint between the legs `leg_before`, which ends there, and `leg_after`, which
    /// begins there. Skips legs of length 0.
    #[inline]
    pub(super) fn add_joint(&mut self, leg_before: DVec3, leg_after: DVec3) {
        let (across, lengths) =
            (leg_before.cross(leg_after).length_squared(), leg_before.length_squared() * leg_after.length_squared());
        // Divide only if the joint's angle is the largest so far.
        if across > self.squared_sine * lengths && lengths > 0.0 {
            self.squared_sine = across / lengths;
        }
        if leg_before.dot(leg_after) < 0.0 {
            // A cusp.
            self.squared_sine = 1.0;
        }
    }

    pub(super) fn sine(&self) -> f64 {
        self.squared_sine.sqrt().min(1.0)
    }
}
