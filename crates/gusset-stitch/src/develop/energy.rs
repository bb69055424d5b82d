//! The distortion of one triangle, by the singular values of its map to the plane.

use super::develop_request::Distortion;
use glam::{DMat2, DVec2};

/// The map of a triangle: J = U diag(s) V^T with rotations U and V. The second of the singular
/// values s is negative if the triangle is turned over.
#[derive(Debug, Clone, Copy)]
pub(super) struct Jacobian {
    /// The nearest rotation, U V^T.
    pub(super) rotation: DMat2,
    /// The singular values, the greater first.
    pub(super) stretch: [f64; 2],
    /// The cosine and sine of twice the angle of U.
    double_angle: DVec2,
}

impl Jacobian {
    /// Computes the map that takes the corners of a triangle with these gradients to `x`.
    ///
    /// J is the sum of a similarity (e, h) and a reflected similarity (f, g). The sum and
    /// difference of their lengths are the singular values, and the sum and difference of their
    /// directions give the angles.
    pub(super) fn new(gradients: &[DVec2; 3], x: [DVec2; 3]) -> Jacobian {
        let sum = |row: fn(DVec2) -> f64| (0..3).map(|k| row(x[k]) * gradients[k]).sum::<DVec2>();
        let [u, v] = [sum(|p| p.x), sum(|p| p.y)];
        let similar = DVec2::new(u.x + v.y, v.x - u.y) / 2.0;
        let reflected = DVec2::new(u.x - v.y, v.x + u.y) / 2.0;
        let (q, r) = (similar.length(), reflected.length());
        let turn = if q > 0.0 { similar / q } else { DVec2::X };
        let mirror = if r > 0.0 { reflected / r } else { DVec2::X };
        Jacobian {
            rotation: DMat2::from_cols(turn, turn.perp()),
            stretch: [q + r, q - r],
            double_angle: DVec2::new(turn.x * mirror.x - turn.y * mirror.y, turn.y * mirror.x + turn.x * mirror.y),
        }
    }

    /// Returns the symmetric matrix U diag(values) U^T.
    pub(super) fn matrix_with_stretches(&self, values: [f64; 2]) -> DMat2 {
        let (mean, half) = ((values[0] + values[1]) / 2.0, (values[0] - values[1]) / 2.0);
        let [c, s] = (half * self.double_angle).to_array();
        DMat2::from_cols(DVec2::new(mean + c, s), DVec2::new(s, mean - c))
    }
}

/// Returns the energy, a sum over the singular values.
pub(super) fn stretch_energy(distortion: Distortion, stretch: [f64; 2]) -> f64 {
    let one = |s: f64| match distortion {
        Distortion::Symmetric if s <= 0.0 => f64::INFINITY,
        Distortion::Symmetric => s * s + 1.0 / (s * s),
        Distortion::Rigid | Distortion::Conformal => (s - 1.0) * (s - 1.0),
    };
    one(stretch[0]) + one(stretch[1])
}

/// Returns the squared weights w of the quadratic proxy |W (J - R)|^2, with W = U diag(w) U^T. The
/// proxy and the energy have equal gradients at J: f'(s) = 2 w^2 (s - 1) for each singular value s
/// (Rabinovich et al., equation 24).
pub(super) fn proxy_weights(distortion: Distortion, stretch: [f64; 2]) -> [f64; 2] {
    stretch.map(|s| match distortion {
        // (s - 1 / s^3) / (s - 1) without the common factor.
        Distortion::Symmetric => (s + 1.0) * (s * s + 1.0) / (s * s * s),
        Distortion::Rigid | Distortion::Conformal => 1.0,
    })
}
