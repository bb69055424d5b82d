//! The distortion of one triangle, by the singular values of its map to the plane.

use super::develop_request::Distortion;
use glam::{DMat2, DVec2};

/// The map of a triangle: J = U diag(s) V^T with rotations U and V, and s[1] negative if the
/// triangle is turned over.
#[derive(Debug, Clone, Copy)]
pub(super) struct Jacobian {
    /// The rotation U V^T that is nearest to it.
    pub(super) rotation: DMat2,
    /// The greater singular value first.
    pub(super) stretch: [f64; 2],
    /// The cosine and sine of twice the angle of U.
    double_angle: DVec2,
}

impl Jacobian {
    /// Of the map that takes the corners of a triangle with these gradients to `x`.
    ///
    /// J is the sum of a similarity (e, h) and a reflected one (f, g); their lengths have the
    /// singular values as sum and difference, and their directions the angles as such.
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

    /// The symmetric matrix U diag(values) U^T.
    pub(super) fn of_stretches(&self, values: [f64; 2]) -> DMat2 {
        let (mean, half) = ((values[0] + values[1]) / 2.0, (values[0] - values[1]) / 2.0);
        let [c, s] = (half * self.double_angle).to_array();
        DMat2::from_cols(DVec2::new(mean + c, s), DVec2::new(s, mean - c))
    }
}

/// An energy that is a sum over the singular values.
pub(super) fn energy(distortion: Distortion, stretch: [f64; 2]) -> f64 {
    let one = |s: f64| match distortion {
        Distortion::Symmetric if s <= 0.0 => f64::INFINITY,
        Distortion::Symmetric => s * s + 1.0 / (s * s),
        Distortion::Rigid | Distortion::Conformal => (s - 1.0) * (s - 1.0),
    };
    one(stretch[0]) + one(stretch[1])
}

/// The squared weights w of the quadratic energy |W (J - R)|^2 that has at J the gradient of the
/// energy, W = U diag(w) U^T: f'(s) = 2 w^2 (s - 1) for each singular value s (Rabinovich et al.,
/// equation 24).
pub(super) fn weights(distortion: Distortion, stretch: [f64; 2]) -> [f64; 2] {
    stretch.map(|s| match distortion {
        // (s - 1 / s^3) / (s - 1), its common factor divided out.
        Distortion::Symmetric => (s + 1.0) * (s * s + 1.0) / (s * s * s),
        Distortion::Rigid | Distortion::Conformal => 1.0,
    })
}
