//! The rotation that best maps points to other points.

use super::linear::eigen::symmetric_eigen;
use glam::{DMat3, DQuat, DVec3};

/// Returns the rotation R that maximises the trace of R^T M (B. K. P. Horn, *Closed-form solution
/// of absolute orientation using unit quaternions*, 1987). Its quaternion is the eigenvector of the
/// largest eigenvalue of a symmetric 4 x 4 matrix.
pub fn rotation_maximising_trace(m: DMat3) -> DQuat {
    let at = |row: usize, column: usize| m.col(column)[row];
    let (x, y, z) = (at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1));
    let (xy, xz, yz) = (at(1, 0) + at(0, 1), at(2, 0) + at(0, 2), at(2, 1) + at(1, 2));
    let [a, b, c] = [at(0, 0), at(1, 1), at(2, 2)];
    let k = [[a + b + c, x, y, z], [x, a - b - c, xy, xz], [y, xy, b - a - c, yz], [z, xz, yz, c - a - b]];
    let (values, vectors) = symmetric_eigen(k);
    let greatest = (1..4).fold(0, |best, i| if values[i] > values[best] { i } else { best });
    let [w, x, y, z] = vectors.map(|row| row[greatest]);
    let turn = DQuat::from_xyzw(x, y, z, w).normalize();
    // Two quaternions describe the rotation; return the one with the smaller angle.
    if turn.w < 0.0 { -turn } else { turn }
}

/// Returns the fraction `t` of a rotation about its axis, as a unit quaternion. Uses `libm`,
/// because glam calls the system's sine.
#[inline]
pub fn fraction_of_rotation(turn: DQuat, t: f64) -> DQuat {
    let axis = DVec3::new(turn.x, turn.y, turn.z);
    let length = axis.length();
    let (sine, cosine) = libm::sincos(t * libm::atan2(length, turn.w));
    let [x, y, z] = (if length > 0.0 { axis * (sine / length) } else { axis }).to_array();
    DQuat::from_xyzw(x, y, z, cosine)
}
