//! The box of the inputs, from which defaults are suggested.

use super::data::{Curves, Input};
use glam::DVec3;
use gusset_base::geom::Aabb;

/// The box around all finite points of some inputs; `None` if there are none, or if all coincide.
pub(super) fn bounding_box_of_inputs(inputs: &[Input<'_>]) -> Option<Aabb> {
    let mut extent = Aabb::EMPTY;
    let mut add = |point: DVec3| {
        if point.is_finite() {
            extent.add(point);
        }
    };
    for input in inputs {
        match input {
            Input::Mesh(mesh) => {
                let positions = mesh.positions();
                (0..positions.len()).for_each(|v| add(positions.get(v as u32)));
            }
            Input::Curves(curves) => curves.points.iter().for_each(|&point| add(point.into())),
        }
    }
    Some(extent).filter(|extent| extent.diagonal() > 0.0)
}

/// A value rounded to two digits, which is readable in dialogs.
pub(super) fn round_to_two_digits(value: f64) -> f64 {
    let unit = libm::pow(10.0, libm::log10(value.abs()).floor() - 1.0);
    let round = (value / unit).round() * unit;
    if round.is_finite() { round } else { value }
}

/// The plane of curves, or a plane near them: its unit normal, upwards if possible, and its distance
/// from the origin.
pub(super) fn best_plane_of_curves(curves: &Curves) -> Option<[f64; 4]> {
    let extent = bounding_box_of_inputs(&[Input::Curves(curves)])?;
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
    // Rounding errors of a plane across an axis.
    let normal = DVec3::from(normal.to_array().map(|x| if x.abs() < 1e-12 { 0.0 } else { x })).normalize();
    let [a, b, c] = normal.to_array();
    Some([a, b, c, normal.dot(centre)])
}
