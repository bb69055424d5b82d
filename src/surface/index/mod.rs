//! The index: a pyramid of boxes over blocks of cells. There are no pointers: the children of block (r, c) are the four blocks
//! (2r, 2c), (2r, 2c + 1), (2r + 1, 2c), (2r + 1, 2c + 1) of the level below.
//!
//! It is built from the nodes alone, without building patches: a cell lies within its displacements from the hull of its corners
//! (the theorem of hierarchies: a block may be dropped by any set that contains it). So are the cones of normals, when they are wanted.

mod boxes;
mod cones;
mod slab;

pub(crate) use boxes::{Group, Oriented};
pub(crate) use cones::Cones;
pub use cones::NormalCone;
pub(crate) use slab::Slab;

use super::cells::{BLOCK, Cells};
use crate::alloc;
use crate::error::Result;
use crate::geom::aabb::Aabb;
use crate::job::Job;
use crate::par;
use glam::DVec3;
use std::sync::OnceLock;

/// Levels that have boxes in any direction, from the lowest on.
const ORIENTED_LEVELS: usize = 4;

/// Pairs of rows of blocks that one thread takes at once.
const PAIRS: usize = 4;

/// Cells between two reports of progress, or those that one thread takes at once, if these are more.
const ROUND: usize = 1 << 18;

/// The pyramid of one sheet.
#[derive(Debug)]
pub(crate) struct Pyramid {
    origin: DVec3,
    /// From the blocks up to the root's four children.
    levels: Vec<Level>,
    /// By block: how far the surface may be from the bilinear patches of its cells, and to which side.
    displacements: Vec<Displacement>,
    cones: OnceLock<Cones>,
}

/// A box of vectors: low x, y, z and high x, y, z in 127ths of the greatest length of one.
#[derive(Debug, Clone, Copy, Default)]
struct Displacement {
    most: f32,
    box_of: [i8; 6],
}

impl Displacement {
    /// Rounded outwards.
    fn new(bounds: Aabb) -> Displacement {
        let most = (bounds.max_norm() as f32).next_up();
        let unit = f64::from(most) / 127.0;
        // No vector is longer than `most`: what is rounded stays within the numbers.
        let low = bounds.low.to_array().map(|x| (x / unit - 1e-9).floor() as i8);
        let high = bounds.high.to_array().map(|x| (x / unit + 1e-9).ceil() as i8);
        Displacement { most, box_of: [low[0], low[1], low[2], high[0], high[1], high[2]] }
    }

    #[inline(always)]
    fn bounds(&self) -> Aabb {
        let unit = f64::from(self.most) / 127.0;
        let [a, b, c, d, e, f] = self.box_of.map(|x| f64::from(x) * unit);
        Aabb { low: DVec3::new(a, b, c), high: DVec3::new(d, e, f) }
    }
}

/// The boxes of one level.
#[derive(Debug)]
pub(crate) struct Level {
    rows: usize,
    columns: usize,
    groups: Vec<Group>,
    oriented: Vec<Oriented>,
}

impl Level {
    fn new(rows: usize, columns: usize, oriented: bool) -> Result<Self> {
        Ok(Level {
            rows,
            columns,
            groups: alloc::filled(Group::EMPTY, rows.div_ceil(2) * columns.div_ceil(2))?,
            oriented: alloc::filled(Oriented::default(), if oriented { rows * columns } else { 0 })?,
        })
    }

    /// True if there is a block (r, c).
    #[inline(always)]
    pub(crate) fn has(&self, r: usize, c: usize) -> bool {
        r < self.rows && c < self.columns
    }

    /// The boxes of the children of block (r, c) of the level above.
    #[inline(always)]
    pub(crate) fn group(&self, r: usize, c: usize) -> &Group {
        &self.groups[r * self.columns.div_ceil(2) + c]
    }

    /// The box of block (r, c) in any direction, if this level has them.
    #[inline(always)]
    pub(crate) fn oriented(&self, r: usize, c: usize) -> Option<&Oriented> {
        self.oriented.get(r * self.columns + c)
    }
}

impl Pyramid {
    /// Builds the index on the job's threads.
    pub(crate) fn build<const N: usize>(cells: &impl Cells<N>, job: &Job<'_>) -> Result<Self> {
        let [rows, columns] = cells.counts().map(|count| count.div_ceil(BLOCK));
        let origin = middle(cells);
        let mut base = Level::new(rows, columns, true)?;
        let mut displacements = alloc::filled(Displacement::default(), rows * columns)?;
        let (across, together) = (columns.div_ceil(2), 2 * PAIRS * columns);
        let parts = base.groups.chunks_mut(PAIRS * across).zip(base.oriented.chunks_mut(together));
        let mut parts = parts.zip(displacements.chunks_mut(together)).enumerate();
        let (count, round) = (rows.div_ceil(2 * PAIRS), (ROUND / (together * BLOCK * BLOCK)).max(1));
        for from in (0..count).step_by(round) {
            job.step(0.8 * from as f64 / count as f64, "index")?;
            let slice: Vec<_> = parts.by_ref().take(round).collect();
            par::map(job.threads(), slice.into_iter(), |(k, ((groups, oriented), displacements))| {
                let first = 2 * PAIRS * k;
                let mut bounds = vec![Aabb::EMPTY; displacements.len()];
                cells.displacements(first..first + displacements.len() / columns, &mut bounds);
                let parts =
                    oriented.chunks_mut(columns).zip(displacements.chunks_mut(columns)).zip(bounds.chunks(columns));
                for (r, ((oriented, displacements), bounds)) in parts.enumerate() {
                    let groups = &mut groups[r / 2 * across..][..across];
                    let row = Row { row: first + r, displacements: bounds };
                    row.blocks(cells, origin, groups, oriented, displacements);
                }
            });
        }
        job.step(0.8, "index")?;
        let mut levels = vec![base];
        while let Some(last) = levels.last().filter(|last| last.groups.len() > 1) {
            let next = above(last, levels.len() < ORIENTED_LEVELS)?;
            levels.push(next);
        }
        Ok(Pyramid { origin, levels, displacements, cones: OnceLock::new() })
    }

    /// What coordinates of boxes are relative to.
    pub(crate) fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The levels, the blocks first.
    pub(crate) fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// How far the surface may be from the bilinear patches of the cells of block (r, c).
    #[inline(always)]
    pub(crate) fn deviation(&self, r: usize, c: usize) -> f64 {
        self.displacements[r * self.levels[0].columns + c].most.into()
    }

    /// A box of the vectors from the bilinear patches of the cells of block (r, c) to the surface, at equal parameters.
    #[inline(always)]
    pub(crate) fn displacement(&self, r: usize, c: usize) -> Aabb {
        self.displacements[r * self.levels[0].columns + c].bounds()
    }

    /// A box round everything.
    pub(crate) fn bounds(&self) -> Aabb {
        let whole = self.levels.last().map_or(Aabb::EMPTY, |level| level.group(0, 0).whole());
        Aabb { low: whole.low + self.origin, high: whole.high + self.origin }
    }

    /// Bytes of memory, without the cones.
    pub(crate) fn bytes(&self) -> usize {
        let level = |level: &Level| size_of_val(&level.groups[..]) + size_of_val(&level.oriented[..]);
        self.levels.iter().map(level).sum::<usize>() + size_of_val(&self.displacements[..])
    }
}

/// A point amid the surface: the middle of the box of some of its corners.
fn middle<const N: usize>(cells: &impl Cells<N>) -> DVec3 {
    let [rows, columns] = cells.counts();
    let mut bounds = Aabb::EMPTY;
    for i in (0..=8).map(|k| k * rows / 8) {
        (0..=8).for_each(|k| bounds.add(cells.corner(i, k * columns / 8)));
    }
    0.5 * (bounds.low + bounds.high)
}

/// One row of blocks, and the boxes of displacements of its blocks.
struct Row<'a> {
    row: usize,
    displacements: &'a [Aabb],
}

impl Row<'_> {
    /// Their boxes.
    fn blocks<const N: usize>(
        &self,
        cells: &impl Cells<N>,
        origin: DVec3,
        groups: &mut [Group],
        oriented: &mut [Oriented],
        displacements: &mut [Displacement],
    ) {
        let [rows, columns] = cells.counts();
        let (first, last) = (self.row * BLOCK, rows.min((self.row + 1) * BLOCK));
        let mut points = [DVec3::ZERO; (BLOCK + 1) * (BLOCK + 1)];
        for (c, &displacement) in self.displacements.iter().enumerate() {
            let (left, right) = (c * BLOCK, columns.min((c + 1) * BLOCK));
            let mut count = 0;
            let mut hull = Aabb::EMPTY;
            for i in first..=last {
                for j in left..=right {
                    points[count] = cells.corner(i, j) - origin;
                    hull.add(points[count]);
                    count += 1;
                }
            }
            // What the coordinates were rounded by on the way.
            let size = hull.low.abs().max(hull.high.abs()).max(origin.abs()).max_element();
            let displacement = displacement.inflated(16.0 * f64::EPSILON * size);
            displacements[c] = Displacement::new(displacement);
            groups[c / 2].set(2 * (self.row % 2) + c % 2, hull.sum(displacement));
            let width = right - left + 1;
            let (a, b) = (points[0], points[width - 1]);
            let (d, e) = (points[count - width], points[count - 1]);
            oriented[c] = Oriented::round(&points[..count], d + e - a - b, b + e - a - d, displacement);
        }
    }
}

/// The level above another.
fn above(below: &Level, with_oriented: bool) -> Result<Level> {
    let (rows, columns) = (below.rows.div_ceil(2), below.columns.div_ceil(2));
    let mut level = Level::new(rows, columns, with_oriented)?;
    for r in 0..rows {
        for c in 0..columns {
            let group = below.group(r, c);
            level.groups[r / 2 * columns.div_ceil(2) + c / 2].set(2 * (r % 2) + c % 2, group.whole());
            if with_oriented {
                level.oriented[r * columns + c] = around(below, r, c);
            }
        }
    }
    Ok(level)
}

/// The box in any direction round those of the children of block (r, c).
fn around(below: &Level, r: usize, c: usize) -> Oriented {
    let mut points = [DVec3::ZERO; 32];
    let mut centres = [None; 4];
    let mut count = 0;
    for (child, centre) in centres.iter_mut().enumerate() {
        let (row, column) = (2 * r + child / 2, 2 * c + child % 2);
        if row < below.rows && column < below.columns {
            let corners = below.oriented[row * below.columns + column].corners();
            points[count..count + 8].copy_from_slice(&corners);
            *centre = Some(0.5 * (corners[0] + corners[7]));
            count += 8;
        }
    }
    // Across the children, or along the axes of a single one.
    let span = |pairs: [(usize, usize); 2], own: DVec3| {
        let steps = pairs.into_iter().filter_map(|(a, b)| Some(centres[b]? - centres[a]?));
        let sum: DVec3 = steps.sum();
        if sum == DVec3::ZERO { own } else { sum }
    };
    let along_u = span([(0, 2), (1, 3)], points[1] - points[0]);
    let along_v = span([(0, 1), (2, 3)], points[2] - points[0]);
    let exactly = Aabb { low: DVec3::ZERO, high: DVec3::ZERO };
    Oriented::round(&points[..count], along_u, along_v, exactly)
}
