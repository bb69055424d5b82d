//! Points with their normals.

use crate::carcass::{Carcass, Place};
use glam::DVec3;

impl Carcass<'_> {
    /// The point at a place and the unit normal there, or its limit at a pole.
    pub(super) fn point_and_normal(&self, place: Place) -> (DVec3, DVec3) {
        let jet = self.jet(place);
        let normal = jet.normal();
        let regular = normal.length_squared() > 1e-20 * jet.u.length_squared() * jet.v.length_squared();
        (jet.point, if regular { normal.normalize_or_zero() } else { self.normal(place) })
    }
}
