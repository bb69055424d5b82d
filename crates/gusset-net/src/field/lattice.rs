//! Free-form deformation: Sederberg and Parry, "Free-Form Deformation of Solid Geometric Models",
//! 1986. A tensor product of Bernstein polynomials over a box; O(control points) a node.

use super::space_map::{Field, PointsMut, check_parameters_finite, map_each_point};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};

const MAX_POINTS: usize = Lattice::MAX_POINTS;

/// A box of control points that deforms the points inside; points outside stay. At strength t,
/// points move by t times their displacement.
#[derive(Debug, Clone)]
pub struct Lattice {
    low_corner: DVec3,
    size: DVec3,
    counts: [usize; 3],
    /// The displacement of each control point from the uniform grid; x runs first, z last.
    offsets: Vec<DVec3>,
}

impl Lattice {
    /// The largest number of control points along an axis. Bernstein polynomials of higher degree
    /// are slow and hardly follow individual points.
    pub const MAX_POINTS: usize = 32;

    /// Creates a box from `low` to `high` with `counts` control points along x, y and z, 2 to 32
    /// each. `offsets` has the displacement of each control point from the uniform grid; x runs
    /// first, then y, then z.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`], [`Error::ArrayTooShort`], [`Error::OutOfMemory`].
    pub fn new(low: DVec3, high: DVec3, counts: [usize; 3], offsets: &[DVec3]) -> Result<Self> {
        let size = high - low;
        check_parameters_finite(&[("low", low.dot(DVec3::ONE)), ("high", high.dot(DVec3::ONE))])?;
        let mut sides = size.to_array().into_iter();
        sides.try_for_each(|side| {
            Error::require(side > 0.0 && side.is_finite(), "high", side, "finite and above `low` on each axis")
        })?;
        counts.iter().try_for_each(|count| {
            Error::require((2..=MAX_POINTS).contains(count), "counts", *count as f64, 2.0..=MAX_POINTS as f64)
        })?;
        let needed: usize = counts.iter().product();
        let Some(offsets) = offsets.get(..needed) else {
            let (needed, given) = ((needed * size_of::<DVec3>()) as u64, size_of_val(offsets) as u64);
            return Err(Error::ArrayTooShort { what: "offsets", needed, given });
        };
        offsets.iter().try_for_each(|offset| check_parameters_finite(&[("offset", offset.dot(DVec3::ONE))]))?;
        Ok(Lattice { low_corner: low, size, counts, offsets: alloc::copied(offsets)? })
    }

    /// Returns the tensor product of Bernstein polynomials at a place of the unit box.
    fn offset_at(&self, place: [f64; 3]) -> DVec3 {
        let weights = [0, 1, 2].map(|axis| bernstein_weights(self.counts[axis], place[axis]));
        let [rows, columns] = [self.counts[1], self.counts[0]];
        let mut total = DVec3::ZERO;
        for (plane, wz) in self.offsets.chunks_exact(rows * columns).zip(weights[2]) {
            let mut sum = DVec3::ZERO;
            for (row, wy) in plane.chunks_exact(columns).zip(weights[1]) {
                let along = row.iter().zip(weights[0]).fold(DVec3::ZERO, |sum, (&offset, wx)| sum + wx * offset);
                sum += wy * along;
            }
            total += wz * sum;
        }
        total
    }
}

/// Returns the Bernstein polynomials of degree `count - 1` at t, by de Casteljau's triangle.
fn bernstein_weights(count: usize, t: f64) -> [f64; MAX_POINTS] {
    let mut weights = [0.0; MAX_POINTS];
    weights[0] = 1.0;
    for degree in 1..count {
        for k in (1..=degree).rev() {
            weights[k] = (1.0 - t) * weights[k] + t * weights[k - 1];
        }
        weights[0] *= 1.0 - t;
    }
    weights
}

impl Field for Lattice {
    fn map_points(&self, strength: f64, points: PointsMut<'_>) {
        map_each_point(points, |point| {
            let place = [0, 1, 2].map(|k| (point[k] - self.low_corner[k]) / self.size[k]);
            if !place.iter().all(|t| (0.0..=1.0).contains(t)) {
                return point;
            }
            let offset = self.offset_at(place);
            [0, 1, 2].map(|k| point[k] + strength * offset[k])
        });
    }
}
