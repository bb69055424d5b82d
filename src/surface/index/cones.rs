//! Cones that contain the unit normals of blocks, built when first they are wanted.
//!
//! Of a block, boxes of S_u and S_v are known (see `tangents`). Seen in a frame whose third axis is nearly their middles' product, ranges of
//! their components give ranges of those of N = S_u x S_v, and these the greatest angle of N with the axis. Above, a cone round four cones.

use super::super::cells::{BLOCK, Cells};
use super::super::ranges::{angles, cross};
use super::{PAIRS, Pyramid, ROUND};
use crate::alloc;
use crate::error::Result;
use crate::geom::aabb::Aabb;
use crate::job::Job;
use crate::par;
use glam::DVec3;
use std::f64::consts::PI;

/// The axis in 32767ths, and the half angle in 65535ths of pi, rounded up: pi where nothing is known, as at poles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Cone {
    axis: [i16; 3],
    angle: u16,
}

/// Directions that make no greater angle with the axis than a given one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalCone {
    /// Of length 1.
    pub axis: DVec3,
    /// In radians; pi if it is every direction.
    pub angle: f64,
}

impl Cone {
    const ALL: Cone = Cone { axis: [0, 0, i16::MAX], angle: u16::MAX };

    /// The axis as it will be kept, and its direction as it will be used.
    fn axis(wanted: DVec3) -> Option<([i16; 3], DVec3)> {
        let axis = wanted.try_normalize()?.to_array().map(|x| (x * 32767.0).round() as i16);
        Some((axis, DVec3::from_array(axis.map(f64::from)).normalize()))
    }

    fn new(axis: [i16; 3], angle: f64) -> Cone {
        // More than a unit in all, for the rounding of angles.
        Cone { axis, angle: (angle * (65535.0 / PI) + 0.001).ceil().min(65535.0) as u16 }
    }

    /// The cone of the cross products of vectors of two boxes.
    fn of([u, v]: [Aabb; 2]) -> Cone {
        let parts = |of: Aabb| [0.5 * (of.low + of.high), 0.5 * (of.high - of.low)];
        let [[u, half_u], [v, half_v]] = [parts(u), parts(v)];
        let Some((axis, third)) = Cone::axis(u.cross(v)) else { return Cone::ALL };
        let Some(first) = u.reject_from_normalized(third).try_normalize() else { return Cone::ALL };
        let frame = [first, third.cross(first), third];
        let ranges = |middle: DVec3, half: DVec3| {
            frame.map(|axis| {
                let (at, reach) = (axis.dot(middle), axis.abs().dot(half));
                [at - reach, at + reach]
            })
        };
        let normal = cross(ranges(u, half_u), ranges(v, half_v));
        // Else it may vanish; this is also what NaN comes to.
        if normal[2][0] > 0.0 { Cone::new(axis, angles(&normal, 0.0)[1]) } else { Cone::ALL }
    }

    /// A cone round others.
    fn round(cones: &[Cone]) -> Cone {
        if let &[cone] = cones {
            return cone;
        }
        if cones.contains(&Cone::ALL) {
            return Cone::ALL;
        }
        let sum = cones.iter().map(|cone| cone.open().axis).sum();
        let Some((axis, direction)) = Cone::axis(sum) else { return Cone::ALL };
        let reach = |cone: &Cone| cone.open().angle + cone.open().to(direction);
        let angle = cones.iter().map(reach).fold(0.0, f64::max);
        if angle < PI { Cone::new(axis, angle) } else { Cone::ALL }
    }

    pub(crate) fn open(self) -> NormalCone {
        let axis = DVec3::from_array(self.axis.map(f64::from)).normalize();
        NormalCone { axis, angle: f64::from(self.angle) * (PI / 65535.0) }
    }
}

impl NormalCone {
    /// The angle of the axis with a unit vector.
    fn to(&self, direction: DVec3) -> f64 {
        libm::atan2(self.axis.cross(direction).length(), self.axis.dot(direction))
    }

    /// The least and the greatest angle of its directions with a unit vector, or beyond.
    pub(crate) fn angles(&self, direction: DVec3) -> [f64; 2] {
        let middle = self.to(direction);
        [middle - self.angle, middle + self.angle]
    }
}

/// The cones of a sheet: of the blocks, then level by level as the pyramid's.
#[derive(Debug)]
pub(crate) struct Cones {
    levels: Vec<Level>,
}

#[derive(Debug)]
struct Level {
    columns: usize,
    cones: Vec<Cone>,
}

impl Cones {
    /// `reach`: the greatest coordinate of the sheet.
    pub(super) fn build<const N: usize>(cells: &impl Cells<N>, reach: f64, job: &Job<'_>) -> Result<Cones> {
        let [rows, columns] = cells.counts().map(|count| count.div_ceil(BLOCK));
        // What sums of nodes and products of them were rounded by on the way, here and where patches are made.
        let noise = 1024.0 * f64::EPSILON * reach;
        let mut base = alloc::filled(Cone::ALL, rows * columns)?;
        let together = 2 * PAIRS * columns;
        let (count, round) = (rows.div_ceil(2 * PAIRS), (ROUND / (together * BLOCK * BLOCK)).max(1));
        let mut parts = base.chunks_mut(together).enumerate();
        for from in (0..count).step_by(round) {
            job.step(from as f64 / count as f64, "normal cones")?;
            let slice: Vec<_> = parts.by_ref().take(round).collect();
            par::map(job.threads(), slice.into_iter(), |(k, cones)| {
                let first = 2 * PAIRS * k;
                let mut boxes = vec![[Aabb::EMPTY; 2]; cones.len()];
                cells.tangents(first..first + cones.len() / columns, &mut boxes);
                for (cone, boxes) in cones.iter_mut().zip(boxes) {
                    *cone = Cone::of(boxes.map(|bounds| bounds.inflated(noise)));
                }
            });
        }
        let mut levels = vec![Level { columns, cones: base }];
        while let Some(last) = levels.last().filter(|last| last.columns > 2 || last.cones.len() > 2 * last.columns) {
            levels.push(last.above()?);
        }
        Ok(Cones { levels })
    }

    /// The cone of block (r, c) of a level, if there is such a block.
    pub(crate) fn get(&self, level: usize, r: usize, c: usize) -> Option<NormalCone> {
        let level = self.levels.get(level)?;
        let cone = if c < level.columns { level.cones.get(r * level.columns + c) } else { None };
        cone.map(|cone| cone.open())
    }

    /// The number of levels; the last one has two rows and columns of blocks at most.
    pub(crate) fn levels(&self) -> usize {
        self.levels.len()
    }

    /// Bytes of memory.
    pub(crate) fn bytes(&self) -> usize {
        self.levels.iter().map(|level| size_of_val(&level.cones[..])).sum()
    }

    /// Of which none tells anything, as if there were none.
    #[cfg(test)]
    pub(super) fn blunt(&mut self) {
        self.levels.iter_mut().for_each(|level| level.cones.fill(Cone::ALL));
    }
}

impl Level {
    fn above(&self) -> Result<Level> {
        let (below, columns) = (self.cones.len() / self.columns, self.columns.div_ceil(2));
        let mut cones = alloc::with_capacity(below.div_ceil(2) * columns)?;
        let mut four = [Cone::ALL; 4];
        for (r, c) in (0..below.div_ceil(2)).flat_map(|r| (0..columns).map(move |c| (r, c))) {
            let mut count = 0;
            for (r, c) in [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(down, on)| (2 * r + down, 2 * c + on)) {
                if r < below && c < self.columns {
                    four[count] = self.cones[r * self.columns + c];
                    count += 1;
                }
            }
            cones.push(Cone::round(&four[..count]));
        }
        Ok(Level { columns, cones })
    }
}

impl Pyramid {
    /// The cones, built by the first who asks. Two who ask at once may both build them, to the same bits; none waits for another, who may be
    /// its own caller.
    pub(crate) fn cones<const N: usize>(&self, cells: &impl Cells<N>, job: &Job<'_>) -> Result<&Cones> {
        if let Some(cones) = self.cones.get() {
            return Ok(cones);
        }
        let Aabb { low, high } = self.bounds();
        let made = Cones::build(cells, low.abs().max(high.abs()).max_element(), job)?;
        Ok(self.cones.get_or_init(|| made))
    }

    /// The cones, if they were built.
    pub(crate) fn known_cones(&self) -> Option<&Cones> {
        self.cones.get()
    }

    /// Makes the cones useless, for a comparison.
    #[cfg(test)]
    pub(crate) fn blunt_cones(&mut self) {
        self.cones.get_mut().into_iter().for_each(Cones::blunt);
    }
}
