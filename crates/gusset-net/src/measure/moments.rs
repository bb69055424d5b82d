//! Volume, centroid and inertia of the body that a closed net encloses, by the divergence theorem.
//!
//! The 3 x 3 product Gauss rule integrates the flux through each bilinear patch. It is exact,
//! because the integrands have degree at most 4 in each parameter. O(nodes).

use super::sums::first_existing_node;
use crate::chunks::lines_per_block;
use crate::hidden_cells::HiddenCells;
use crate::{Net, each};
use glam::{DMat3, DVec3, Vec3Swizzles};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::par;

/// Volume, centroid and inertia of the enclosed body, of density 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    /// The volume; negative if the normals point inwards.
    pub volume: f64,
    /// The centre of mass; NaN if the volume is 0.
    pub centroid: DVec3,
    /// The tensor of inertia about the centroid: diagonal entries integrate y^2 + z^2 and so on,
    /// the others -x y and so on.
    pub inertia: DMat3,
}

/// Returns points and weights of the three-point Gauss rule on the interval from 0 to 1, exact to
/// degree 5.
fn gauss_rule_3() -> [(f64, f64); 3] {
    let off = (0.15f64).sqrt();
    [(0.5 - off, 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.5 + off, 5.0 / 18.0)]
}

/// Returns the moments of the body enclosed by the bilinear patches of the cells, exact up to
/// rounding. They are undefined unless the net is closed. O(nodes), with constant extra memory.
///
/// # Errors
/// [`Error::Cancelled`](gusset_base::Error::Cancelled),
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
pub fn moments(net: &Net<'_>, job: &Job<'_>) -> Result<Moments> {
    let (origin, hidden) = (first_existing_node(net), HiddenCells::new(net)?);
    let row = |i: usize| {
        let cells = hidden.visible_runs(i).flatten();
        cells.fold(VolumeIntegrals::default(), |sums, j| {
            let points = each!(net.coordinates(), planes => planes.cell_corners(i, j).map(|point| point - origin));
            if points.iter().all(|point| point.is_finite()) { sums.add(patch_integrals(points)) } else { sums }
        })
    };
    let (rows, lines) = (net.shape().rows() - 1, lines_per_block(net.shape().columns() - 1));
    let parts = par::map_cancellable(job, "moments", par::split_into_ranges(rows, lines), |rows| {
        rows.map(row).fold(VolumeIntegrals::default(), VolumeIntegrals::add)
    })?;
    let total = parts.into_iter().fold(VolumeIntegrals::default(), VolumeIntegrals::add);
    let sign = if net.topology().is_reversed() { -1.0 } else { 1.0 };
    Ok(total.to_moments(origin, sign))
}

/// Integrals over the body of 1; of x, y, z; of x^2, y^2, z^2; of y z, z x, x y.
#[derive(Debug, Clone, Copy, Default)]
struct VolumeIntegrals {
    one: f64,
    first_moments: DVec3,
    second_moments: DVec3,
    products: DVec3,
}

impl VolumeIntegrals {
    fn add(self, other: Self) -> Self {
        VolumeIntegrals {
            one: self.one + other.one,
            first_moments: self.first_moments + other.first_moments,
            second_moments: self.second_moments + other.second_moments,
            products: self.products + other.products,
        }
    }

    fn to_moments(self, origin: DVec3, sign: f64) -> Moments {
        let centre = self.first_moments / self.one;
        let squares = sign * (self.second_moments - centre * self.first_moments);
        let products = sign * (self.products - DVec3::new(centre.y, centre.z, centre.x) * self.first_moments.zxy());
        let sum = squares.element_sum();
        let inertia = DMat3::from_cols(
            DVec3::new(sum - squares.x, -products.z, -products.y),
            DVec3::new(-products.z, sum - squares.y, -products.x),
            DVec3::new(-products.y, -products.x, sum - squares.z),
        );
        Moments { volume: sign * self.one, centroid: origin + centre, inertia }
    }
}

/// Returns the flux through a patch of fields whose divergences are the integrands.
fn patch_integrals([a, b, c, d]: [DVec3; 4]) -> VolumeIntegrals {
    let mut sums = VolumeIntegrals::default();
    for (u, wu) in gauss_rule_3() {
        for (v, wv) in gauss_rule_3() {
            let (top, bottom) = (a + u * (b - a), d + u * (c - d));
            let p = top + v * (bottom - top);
            let along = (b - a) + v * ((c - d) - (b - a));
            let n = wu * wv * along.cross(bottom - top);
            sums = sums.add(VolumeIntegrals {
                one: p.dot(n) / 3.0,
                // div (x^2 / 2, 0, 0) = x, and so on.
                first_moments: p * p * n / 2.0,
                second_moments: p * p * p * n / 3.0,
                // div p y z = 5 y z.
                products: p.dot(n) / 5.0 * DVec3::new(p.y * p.z, p.z * p.x, p.x * p.y),
            });
        }
    }
    sums
}
