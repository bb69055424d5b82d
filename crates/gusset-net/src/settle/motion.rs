//! Rigid motions.

use glam::{DMat3, DQuat, DVec3};
use gusset_base::geom::rotation::rotation_maximising_trace;

/// A rigid motion, p -> rotation p + translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RigidMotion {
    pub(super) rotation: DQuat,
    pub(super) translation: DVec3,
}

impl RigidMotion {
    pub(super) const IDENTITY: RigidMotion = RigidMotion { rotation: DQuat::IDENTITY, translation: DVec3::ZERO };

    pub(super) fn apply(&self, p: DVec3) -> DVec3 {
        self.rotation * p + self.translation
    }

    /// This motion, followed by a rotation about a point.
    pub(super) fn then_rotate(&self, rotation: DQuat, about: DVec3) -> RigidMotion {
        let translation = rotation * (self.translation - about) + about;
        RigidMotion { rotation: (rotation * self.rotation).normalize(), translation }
    }

    /// Returns the motion that best maps points to other points, by least squares: B. K. P. Horn
    /// (1987).
    pub(super) fn fit_point_pairs(pairs: impl Iterator<Item = [DVec3; 2]> + Clone) -> RigidMotion {
        let (mut sums, mut count) = ([DVec3::ZERO; 2], 0.0);
        pairs.clone().for_each(|[p, q]| (sums, count) = ([sums[0] + p, sums[1] + q], count + 1.0));
        if count == 0.0 {
            return RigidMotion::IDENTITY;
        }
        let means = sums.map(|sum| sum / count);
        let mut covariance = DMat3::ZERO;
        pairs.for_each(|[p, q]| covariance += outer_product(q - means[1], p - means[0]));
        let rotation = rotation_maximising_trace(covariance);
        RigidMotion { rotation, translation: means[1] - rotation * means[0] }
    }
}

/// a b^T.
pub(super) fn outer_product(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(b.x * a, b.y * a, b.z * a)
}
