//! Cones that contain the unit normals of blocks.
//!
//! The paper bounds the angle of normals over a region by curvature times diameter; cones (Shirman
//! and Abi-Ezzi 1993) are tighter and need no bound of the curvature. For each block, `tangents`
//! gives bounding boxes of S_u and S_v. A frame is chosen whose third axis is close to the cross
//! product of their centres. In it, the component ranges of S_u and S_v bound the components of N =
//! S_u x S_v, and so the largest angle between N and the axis. At each higher level, a cone
//! encloses the cones of its four children. Invariant: rounding only widens a cone. O(n) to build,
//! 8 bytes for each block.

use super::super::cells::{CELLS_PER_BLOCK_SIDE, SheetCells};
use super::super::normal::angle_between_unit_vectors;
use super::super::ranges::{angle_range_to_third_axis, cross_product_ranges};
use super::schedule::block_rows_per_task;
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_base::{alloc, par};
use std::f64::consts::PI;

/// A cone with its axis in units of 1 / 32767 and its half angle in units of pi / 65535, rounded
/// up. The angle is pi if no bound is known, as at poles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct PackedCone {
    axis: [i16; 3],
    angle: u16,
}

/// The set of directions whose angle with the axis is at most `angle`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalCone {
    /// The axis, a unit vector.
    pub axis: DVec3,
    /// The half angle in radians; pi if the cone contains every direction.
    pub angle: f64,
}

impl PackedCone {
    const ALL_DIRECTIONS: PackedCone = PackedCone { axis: [0, 0, i16::MAX], angle: u16::MAX };

    /// Rounds an axis to its packed form. Also returns the direction that the packed form
    /// represents.
    fn pack_axis(wanted: DVec3) -> Option<([i16; 3], DVec3)> {
        let axis = wanted.try_normalize()?.to_array().map(|x| (x * 32767.0).round() as i16);
        Some((axis, DVec3::from_array(axis.map(f64::from)).normalize()))
    }

    fn new(axis: [i16; 3], angle: f64) -> PackedCone {
        // An additional 0.001 units cover the rounding of angles.
        PackedCone { axis, angle: (angle * (65535.0 / PI) + 0.001).ceil().min(65535.0) as u16 }
    }

    /// A cone that contains the cross products of vectors of two boxes.
    fn from_cross_products([u, v]: [Aabb; 2]) -> PackedCone {
        let parts = |of: Aabb| [of.centre(), 0.5 * of.size()];
        let [[u, half_u], [v, half_v]] = [parts(u), parts(v)];
        let Some((axis, third)) = PackedCone::pack_axis(u.cross(v)) else { return PackedCone::ALL_DIRECTIONS };
        let Some(first) = u.reject_from_normalized(third).try_normalize() else { return PackedCone::ALL_DIRECTIONS };
        let frame = [first, third.cross(first), third];
        let ranges = |middle: DVec3, half: DVec3| {
            frame.map(|axis| {
                let (at, reach) = (axis.dot(middle), axis.abs().dot(half));
                [at - reach, at + reach]
            })
        };
        let normal = cross_product_ranges(ranges(u, half_u), ranges(v, half_v));
        // Otherwise the product may vanish. NaN leads here too.
        if normal[2][0] > 0.0 {
            PackedCone::new(axis, angle_range_to_third_axis(&normal, 0.0)[1])
        } else {
            PackedCone::ALL_DIRECTIONS
        }
    }

    /// A cone that contains other cones.
    fn cone_around_cones(cones: &[PackedCone]) -> PackedCone {
        if let &[cone] = cones {
            return cone;
        }
        if cones.contains(&PackedCone::ALL_DIRECTIONS) {
            return PackedCone::ALL_DIRECTIONS;
        }
        let sum = cones.iter().map(|cone| cone.unpack().axis).sum();
        let Some((axis, direction)) = PackedCone::pack_axis(sum) else { return PackedCone::ALL_DIRECTIONS };
        let reach = |cone: &PackedCone| cone.unpack().angle + cone.unpack().angle_to(direction);
        let angle = cones.iter().map(reach).fold(0.0, f64::max);
        if angle < PI { PackedCone::new(axis, angle) } else { PackedCone::ALL_DIRECTIONS }
    }

    pub(crate) fn unpack(self) -> NormalCone {
        let axis = DVec3::from_array(self.axis.map(f64::from)).normalize();
        NormalCone { axis, angle: f64::from(self.angle) * (PI / 65535.0) }
    }
}

impl NormalCone {
    /// The angle between the axis and a unit vector.
    fn angle_to(&self, direction: DVec3) -> f64 {
        angle_between_unit_vectors(self.axis, direction)
    }

    /// Bounds of the angles between the cone's directions and a unit vector.
    pub(crate) fn angle_range_to(&self, direction: DVec3) -> [f64; 2] {
        let middle = self.angle_to(direction);
        [middle - self.angle, middle + self.angle]
    }
}

/// The cones of a sheet: of its blocks, then of each level like the pyramid's.
#[derive(Debug)]
pub(crate) struct ConePyramid {
    levels: Vec<ConeLevel>,
}

#[derive(Debug)]
struct ConeLevel {
    columns: usize,
    cones: Vec<PackedCone>,
}

impl ConePyramid {
    /// Builds the cones. `max_coordinate` is the largest absolute coordinate of the sheet.
    pub(super) fn build<const N: usize>(
        cells: &impl SheetCells<N>,
        max_coordinate: f64,
        job: &Job<'_>,
    ) -> Result<ConePyramid> {
        let [rows, columns] = cells.cell_counts().map(|count| count.div_ceil(CELLS_PER_BLOCK_SIDE));
        // Rounding of sums of nodes and of their products, here and in the construction of patches.
        let noise = 1024.0 * f64::EPSILON * max_coordinate;
        let mut base = alloc::filled(PackedCone::ALL_DIRECTIONS, rows * columns)?;
        let rows_together = block_rows_per_task(columns);
        let parts = base.chunks_mut(rows_together * columns).enumerate();
        par::map_cancellable(job, "normal cones", parts, |(k, cones)| {
            let first = rows_together * k;
            let mut boxes = alloc::filled([Aabb::EMPTY; 2], cones.len())?;
            cells.fill_tangent_boxes(first..first + cones.len() / columns, &mut boxes)?;
            for (cone, boxes) in cones.iter_mut().zip(boxes) {
                *cone = PackedCone::from_cross_products(boxes.map(|bounds| bounds.grown_by(noise)));
            }
            Ok(())
        })?
        .into_iter()
        .collect::<Result<()>>()?;
        let mut levels = vec![ConeLevel { columns, cones: base }];
        while let Some(last) = levels.last().filter(|last| last.columns > 2 || last.cones.len() > 2 * last.columns) {
            levels.push(last.level_above()?);
        }
        Ok(ConePyramid { levels })
    }

    /// The cone of block (r, c) of a level, if the block exists.
    pub(crate) fn cone_of_block(&self, level: usize, r: usize, c: usize) -> Option<NormalCone> {
        let level = self.levels.get(level)?;
        let cone = if c < level.columns { level.cones.get(r * level.columns + c) } else { None };
        cone.map(|cone| cone.unpack())
    }

    /// The number of levels. The last one has at most two rows and two columns of blocks.
    pub(crate) fn level_count(&self) -> usize {
        self.levels.len()
    }

    /// Size in bytes.
    pub(crate) fn byte_size(&self) -> usize {
        self.levels.iter().map(|level| size_of_val(&level.cones[..])).sum()
    }

    /// Replaces every cone by the cone of all directions, so that cones exclude nothing.
    #[cfg(test)]
    pub(super) fn replace_all_by_full_cones(&mut self) {
        self.levels.iter_mut().for_each(|level| level.cones.fill(PackedCone::ALL_DIRECTIONS));
    }
}

impl ConeLevel {
    fn level_above(&self) -> Result<ConeLevel> {
        let (below, columns) = (self.cones.len() / self.columns, self.columns.div_ceil(2));
        let mut cones = alloc::with_capacity(below.div_ceil(2) * columns)?;
        for (r, c) in (0..below.div_ceil(2)).flat_map(|r| (0..columns).map(move |c| (r, c))) {
            let (mut four, mut count) = ([PackedCone::ALL_DIRECTIONS; 4], 0);
            for (r, c) in [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(down, on)| (2 * r + down, 2 * c + on)) {
                if r < below && c < self.columns {
                    four[count] = self.cones[r * self.columns + c];
                    count += 1;
                }
            }
            cones.push(PackedCone::cone_around_cones(&four[..count]));
        }
        Ok(ConeLevel { columns, cones })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A packed cone is at least as wide as requested, and a cone around others contains their
    /// directions.
    #[test]
    fn packed_cones_are_rounded_outwards() {
        let direction_of =
            |k: usize| DVec3::new((k as f64).sin(), (2.7 * k as f64).cos(), (0.3 * k as f64).sin() + 0.1);
        for k in 0..2000 {
            let angle = 1e-3 * k as f64 + 1e-7 * (k % 7) as f64;
            let (packed, direction) = PackedCone::pack_axis(direction_of(k)).unwrap();
            let cone = PackedCone::new(packed, angle);
            let NormalCone { axis, angle: held } = cone.unpack();
            assert!(held >= angle && held < angle + 1e-4, "{angle} {held}");
            assert_eq!(axis, direction);
            let other = PackedCone::new(PackedCone::pack_axis(direction_of(k + 1)).unwrap().0, 0.1);
            let both = PackedCone::cone_around_cones(&[cone, other]).unpack();
            for one in [cone, other] {
                let one = one.unpack();
                assert!(both.angle == PI || both.angle >= one.angle + one.angle_to(both.axis), "{k}");
            }
        }
    }
}
