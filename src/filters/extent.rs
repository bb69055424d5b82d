//! How large inputs are, and where: what defaults that depend on them are made of.

use super::data::{Curves, Input};
use super::param::Param;
use glam::DVec3;

/// The box round inputs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extent {
    pub(super) low: DVec3,
    pub(super) high: DVec3,
}

impl Extent {
    /// Of all finite points of some inputs; `None` if there are none, or if they are all one.
    pub(super) fn of(inputs: &[Input<'_>]) -> Option<Self> {
        let mut extent = Extent { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };
        for input in inputs {
            match input {
                Input::Mesh(mesh) => {
                    let positions = mesh.positions();
                    (0..positions.len()).for_each(|v| extent.take(positions.get(v as u32)));
                }
                Input::Curves(curves) => curves.points.iter().for_each(|&point| extent.take(point.into())),
            }
        }
        Some(extent).filter(|extent| extent.diagonal() > 0.0)
    }

    fn take(&mut self, point: DVec3) {
        if point.is_finite() {
            (self.low, self.high) = (self.low.min(point), self.high.max(point));
        }
    }

    /// From corner to corner.
    pub(super) fn diagonal(&self) -> f64 {
        self.low.distance(self.high)
    }

    pub(super) fn centre(&self) -> DVec3 {
        self.low.midpoint(self.high)
    }

    /// A length of about two digits, so that dialogs show what can be read: `part` of the diagonal.
    pub(super) fn length(&self, part: f64) -> f64 {
        rounded(part * self.diagonal())
    }
}

/// To two digits.
pub(super) fn rounded(value: f64) -> f64 {
    let unit = libm::pow(10.0, value.abs().log10().floor() - 1.0);
    let round = (value / unit).round() * unit;
    if round.is_finite() { round } else { value }
}

/// Overwrites the values of parameter `id` among those of all `params`.
pub(super) fn put(params: &[Param], values: &mut [f64], id: &str, new: &[f64]) {
    let mut start = 0;
    for param in params {
        let end = start + param.kind.arity();
        if param.id == id {
            values[start..end].copy_from_slice(new);
        }
        start = end;
    }
}

/// The plane that curves lie in, or lie about: its unit normal, upwards where it can be, and its
/// distance from the origin.
pub(super) fn plane_of(curves: &Curves) -> Option<[f64; 4]> {
    let extent = Extent::of(&[Input::Curves(curves)])?;
    let (centre, size) = (extent.centre(), extent.diagonal());
    let mut area = DVec3::ZERO;
    for ends in curves.offsets.windows(2) {
        let points = curves.points.get(ends[0] as usize..ends[1] as usize)?;
        let at = |k: usize| (DVec3::from(points[k % points.len()]) - centre) / size;
        // Areas of either sense count alike.
        let own: DVec3 = (0..points.len()).map(|k| at(k).cross(at(k + 1))).filter(|part| part.is_finite()).sum();
        area += if own.dot(area) < 0.0 { -own } else { own };
    }
    let normal = area.try_normalize().filter(|_| area.length() > 1e-12).unwrap_or(DVec3::Z);
    let upwards = [normal.z, normal.y, normal.x].into_iter().find(|x| x.abs() > 1e-9).is_none_or(|x| x > 0.0);
    let normal = if upwards { normal } else { -normal };
    // What rounding leaves of a plane across an axis.
    let normal = DVec3::from(normal.to_array().map(|x| if x.abs() < 1e-12 { 0.0 } else { x })).normalize();
    let [a, b, c] = normal.to_array();
    Some([a, b, c, normal.dot(centre)])
}
