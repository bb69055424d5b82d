//! A rigid motion: a rotation and a translation.

use glam::{DMat3, DVec3};

/// The rigid motion from x to R x + t.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// The rotation R, orthogonal with determinant 1.
    pub rotation: DMat3,
    /// The translation t.
    pub translation: DVec3,
}

impl Pose {
    /// The motion that leaves every point unchanged.
    pub const IDENTITY: Pose = Pose { rotation: DMat3::IDENTITY, translation: DVec3::ZERO };

    /// Applies the motion to a point.
    pub fn transform_point(&self, x: DVec3) -> DVec3 {
        self.rotation * x + self.translation
    }

    /// Applies the rotation to a direction.
    pub fn rotate_direction(&self, d: DVec3) -> DVec3 {
        self.rotation * d
    }

    /// Returns the inverse motion.
    pub fn inverse(&self) -> Pose {
        let back = self.rotation.transpose();
        Pose { rotation: back, translation: -(back * self.translation) }
    }

    /// Returns the composition of this motion followed by `next`.
    pub fn followed_by(&self, next: &Pose) -> Pose {
        Pose { rotation: next.rotation * self.rotation, translation: next.transform_point(self.translation) }
    }

    /// Returns the rotation about `centre` by the vector `turn`, whose length is the angle,
    /// followed by a translation.
    pub(super) fn rotation_about(centre: DVec3, turn: DVec3, shift: DVec3) -> Pose {
        let rotation = rotation_by_vector(turn);
        Pose { rotation, translation: centre + shift - rotation * centre }
    }

    /// Removes round-off from the rotation, by making its axes orthonormal.
    pub(super) fn with_orthonormal_axes(self) -> Pose {
        let x = self.rotation.x_axis.normalize_or(DVec3::X);
        let y = (self.rotation.y_axis - x * x.dot(self.rotation.y_axis)).normalize_or(x.any_orthonormal_vector());
        Pose { rotation: DMat3::from_cols(x, y, x.cross(y)), ..self }
    }

    /// Returns the deviation of the matrix from a rotation: the largest entry of R^T R - 1, or 2
    /// for a reflection.
    pub(super) fn deviation_from_rotation(&self) -> f64 {
        let product = self.rotation.transpose() * self.rotation - DMat3::IDENTITY;
        let largest = product.to_cols_array().iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        if self.rotation.determinant() < 0.0 { 2.0 } else { largest }
    }
}

/// Returns the rotation by a vector whose length is the angle: O. Rodrigues' formula. The bits are
/// equal on every machine.
fn rotation_by_vector(turn: DVec3) -> DMat3 {
    let angle = turn.length();
    if angle == 0.0 {
        return DMat3::IDENTITY;
    }
    let axis = turn / angle;
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let column = |e: DVec3| e * cos + axis.cross(e) * sin + axis * (axis.dot(e) * (1.0 - cos));
    DMat3::from_cols(column(DVec3::X), column(DVec3::Y), column(DVec3::Z))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn motions_are_undone_and_follow_one_another() {
        let a = Pose::rotation_about(DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.3, -0.2, 0.5), DVec3::new(0.1, 0.0, -4.0));
        let b = Pose::rotation_about(DVec3::X, DVec3::new(-1.3, 0.2, 0.1), DVec3::Y);
        let x = DVec3::new(0.7, -0.3, 2.0);
        assert!(a.inverse().transform_point(a.transform_point(x)).distance(x) < 1e-14);
        assert!(a.followed_by(&b).transform_point(x).distance(b.transform_point(a.transform_point(x))) < 1e-14);
        assert!(
            a.deviation_from_rotation() < 1e-15 && a.with_orthonormal_axes().rotation.abs_diff_eq(a.rotation, 1e-15)
        );
        let mirror = Pose { rotation: DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0)), ..Pose::IDENTITY };
        assert_eq!(mirror.deviation_from_rotation(), 2.0);
    }
}
