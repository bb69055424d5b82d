//! The index: a pyramid of boxes over blocks of cells. There are no pointers: the children of block (r, c) are the four blocks
//! (2r, 2c), (2r, 2c + 1), (2r + 1, 2c), (2r + 1, 2c + 1) of the level below.
//!
//! It is built from the nodes alone, without building patches: a cell lies within its deviation from the hull of its corners
//! (the theorem of hierarchies: a block may be dropped by any set that contains it).

mod boxes;
mod slab;

pub(crate) use boxes::{Bounds, Group, Oriented};
pub(crate) use slab::Slab;

use super::cells::{BLOCK, Cells};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::par;
use glam::DVec3;

/// Levels that have boxes in any direction, from the lowest on.
const ORIENTED_LEVELS: usize = 4;

/// The pyramid of one sheet.
#[derive(Debug)]
pub(crate) struct Pyramid {
    origin: DVec3,
    /// From the blocks up to the root's four children.
    levels: Vec<Level>,
    /// By block: how far the surface may be from the bilinear patches of its cells.
    deviations: Vec<f32>,
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
        let mut deviations = alloc::filled(0.0_f32, rows * columns)?;
        let across = columns.div_ceil(2);
        let parts = base.groups.chunks_mut(across).zip(base.oriented.chunks_mut(2 * columns));
        let parts: Vec<_> = parts.zip(deviations.chunks_mut(2 * columns)).enumerate().collect();
        par::map(job.threads(), parts.into_iter(), |(pair, ((groups, oriented), deviations))| {
            for (half, (oriented, bounds)) in
                oriented.chunks_mut(columns).zip(deviations.chunks_mut(columns)).enumerate()
            {
                blocks(cells, origin, 2 * pair + half, groups, oriented, bounds);
            }
        });
        job.step(0.8, "index")?;
        let mut levels = vec![base];
        while let Some(last) = levels.last().filter(|last| last.groups.len() > 1) {
            let next = above(last, levels.len() < ORIENTED_LEVELS)?;
            levels.push(next);
        }
        Ok(Pyramid { origin, levels, deviations })
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
        self.deviations[r * self.levels[0].columns + c].into()
    }

    /// A box round everything.
    pub(crate) fn bounds(&self) -> Bounds {
        let whole = self.levels.last().map_or(Bounds::EMPTY, |level| level.group(0, 0).whole());
        Bounds { low: whole.low + self.origin, high: whole.high + self.origin }
    }

    /// Bytes of memory.
    pub(crate) fn bytes(&self) -> usize {
        let level = |level: &Level| size_of_val(&level.groups[..]) + size_of_val(&level.oriented[..]);
        self.levels.iter().map(level).sum::<usize>() + size_of_val(&self.deviations[..])
    }
}

/// A point amid the surface: the middle of the box of some of its corners.
fn middle<const N: usize>(cells: &impl Cells<N>) -> DVec3 {
    let [rows, columns] = cells.counts();
    let mut bounds = Bounds::EMPTY;
    for i in (0..=8).map(|k| k * rows / 8) {
        (0..=8).for_each(|k| bounds.add(cells.corner(i, k * columns / 8)));
    }
    0.5 * (bounds.low + bounds.high)
}

/// The boxes of one row of blocks.
fn blocks<const N: usize>(
    cells: &impl Cells<N>,
    origin: DVec3,
    row: usize,
    groups: &mut [Group],
    oriented: &mut [Oriented],
    deviations: &mut [f32],
) {
    let [rows, columns] = cells.counts();
    let mut bounds = vec![0.0; oriented.len()];
    cells.deviations(row, &mut bounds);
    let (first, last) = (row * BLOCK, rows.min((row + 1) * BLOCK));
    let mut points = [DVec3::ZERO; (BLOCK + 1) * (BLOCK + 1)];
    for (c, deviation) in bounds.into_iter().enumerate() {
        let (left, right) = (c * BLOCK, columns.min((c + 1) * BLOCK));
        let mut count = 0;
        let mut hull = Bounds::EMPTY;
        for i in first..=last {
            for j in left..=right {
                points[count] = cells.corner(i, j) - origin;
                hull.add(points[count]);
                count += 1;
            }
        }
        // What the coordinates were rounded by on the way.
        let rounding = 8.0 * f64::EPSILON * hull.low.abs().max(hull.high.abs()).max(origin.abs()).max_element();
        let deviation = deviation + rounding;
        deviations[c] = (deviation as f32).next_up();
        groups[c / 2].set(2 * (row % 2) + c % 2, hull.grown(deviation));
        let width = right - left + 1;
        let (a, b) = (points[0], points[width - 1]);
        let (d, e) = (points[count - width], points[count - 1]);
        oriented[c] = Oriented::round(&points[..count], d + e - a - b, b + e - a - d, deviation);
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
    Oriented::round(&points[..count], along_u, along_v, 0.0)
}
