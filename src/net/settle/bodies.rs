//! Rigid bodies: where they are, and rotations that bring them nearer to rest.

use super::model::{Model, Term};
use super::parts::{BODY, NOWHERE};
use crate::net::morph::best_rotation;
use glam::{DMat3, DQuat, DVec3};

/// The share of a body's inertia that keeps it as it turns: rotations that change nothing are 0.
const INERTIA: f64 = 1e-9;

/// A rigid motion, p -> rotation p + translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Motion {
    pub(super) rotation: DQuat,
    pub(super) translation: DVec3,
}

impl Motion {
    pub(super) const NONE: Motion = Motion { rotation: DQuat::IDENTITY, translation: DVec3::ZERO };

    pub(super) fn apply(&self, p: DVec3) -> DVec3 {
        self.rotation * p + self.translation
    }

    /// This motion, and then a rotation about a point.
    fn turned(&self, rotation: DQuat, about: DVec3) -> Motion {
        let translation = rotation * (self.translation - about) + about;
        Motion { rotation: (rotation * self.rotation).normalize(), translation }
    }

    /// The motion that brings points nearest to others, in the sum of squares: B. K. P. Horn (1987).
    pub(super) fn fitted(pairs: impl Iterator<Item = [DVec3; 2]> + Clone) -> Motion {
        let (mut sums, mut count) = ([DVec3::ZERO; 2], 0.0);
        pairs.clone().for_each(|[p, q]| (sums, count) = ([sums[0] + p, sums[1] + q], count + 1.0));
        if count == 0.0 {
            return Motion::NONE;
        }
        let means = sums.map(|sum| sum / count);
        let mut covariance = DMat3::ZERO;
        pairs.for_each(|[p, q]| covariance += outer(q - means[1], p - means[0]));
        let rotation = best_rotation(covariance);
        Motion { rotation, translation: means[1] - rotation * means[0] }
    }
}

/// a b^T.
fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(b.x * a, b.y * a, b.z * a)
}

/// What a body's terms say of its rotation about a pivot.
#[derive(Clone, Copy, Default)]
struct Lever {
    /// Sums of w c^2 and w c A.
    weight: f64,
    moment: DVec3,
    /// The sum of w (r - B) A^T, of which the rotation is best.
    covariance: DMat3,
    inertia: f64,
}

/// The share of one body in a term: its coefficient c, and A, the sum of c_j x_j.
fn share(model: &Model, term: &Term, x: &[DVec3], body: u32) -> (f64, DVec3) {
    let mut share = (0.0, DVec3::ZERO);
    for (&point, &c) in term.points.iter().zip(&term.factors) {
        if c != 0.0 && model.slots[point as usize] == BODY + body {
            share = (share.0 + c, share.1 + c * x[point as usize]);
        }
    }
    share
}

/// Rotates each free body, the others as they are, to where the terms' sum is least.
pub(super) fn rotate(model: &Model, terms: &[Term], x: &mut [DVec3], motions: &mut [Motion]) {
    for body in 0..motions.len() as u32 {
        if model.translations[body as usize] == NOWHERE {
            continue;
        }
        let own = || terms.iter().filter(|term| (0..3).any(|j| model.slots[term.points[j] as usize] == BODY + body));
        let mut lever = Lever::default();
        for term in own() {
            let (c, a) = share(model, term, x, body);
            lever.weight += term.weight * c * c;
            lever.moment += term.weight * c * a;
        }
        let about = if lever.weight > 0.0 { lever.moment / lever.weight } else { DVec3::ZERO };
        for term in own() {
            let (c, a) = share(model, term, x, body);
            let a = a - c * about;
            let rest = a - term.residual(x);
            lever.covariance += outer(term.weight * rest, a);
            lever.inertia += term.weight.abs() * a.length_squared();
        }
        if lever.inertia > 0.0 {
            let turn = best_rotation(lever.covariance + DMat3::from_diagonal(DVec3::splat(INERTIA * lever.inertia)));
            motions[body as usize] = motions[body as usize].turned(turn, about);
        }
    }
    model.place(motions, x);
}
