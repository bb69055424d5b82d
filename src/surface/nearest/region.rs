//! The region of cells that have a point within a distance: the paper's region of task a), as bits and as a list.

use super::cell::{Workspace, nearest};
use super::search::Block;
use crate::alloc;
use crate::error::{Element, Error, Result};
use crate::job::Job;
use crate::surface::cells::Cells;
use crate::surface::index::Pyramid;
use crate::surface::line_intersection::LARGEST;
use crate::surface::{Surface, each_sheet};
use glam::DVec3;

/// Cells of a surface.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Region {
    /// Sheet, row and column of each cell, rising.
    pub cells: Vec<[u32; 3]>,
    /// By cell of the list: true if all of it is within the distance.
    pub whole: Vec<bool>,
    /// A bit for each cell of all sheets, the lowest of the first word first: that of cell (i, j) of sheet k is
    /// `first[k] + i * columns + j`.
    pub mask: Vec<u64>,
    /// By sheet: its first bit; then the number of bits.
    pub first: Vec<u64>,
}

impl Region {
    /// True if a cell is in the region.
    ///
    /// # Panics
    /// If there is no such bit.
    pub fn has(&self, bit: u64) -> bool {
        self.mask[(bit / 64) as usize] >> (bit % 64) & 1 == 1
    }
}

impl Surface<'_> {
    /// The cells that have a point no farther than `radius` from `query`: all of those, and none whose points are all farther than the radius by
    /// more than the tolerance, unless that cannot be proved.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a radius that is negative or NaN, [`Error::NotFinite`], [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn region(&self, query: DVec3, radius: f64, job: &Job<'_>) -> Result<Region> {
        check("radius", query, radius)?;
        let mut region = Region { first: alloc::with_capacity(self.len() + 1)?, ..Region::default() };
        let mut bits = 0_u64;
        for k in 0..self.len() {
            region.first.push(bits);
            bits += self.sheet(k).cells().map(|count| count as u64).iter().product::<u64>();
        }
        region.first.push(bits);
        region.mask = alloc::zeroed(bits.div_ceil(64) as usize)?;
        let tolerance = self.tolerance().max(self.rounding(query));
        for k in 0..self.len() {
            let (sheet, index) = self.indexed(k);
            let ball = Ball { query, radius, tolerance };
            each_sheet!(sheet, cells => ball.collect(cells, index, k as u32, &mut region, job))?;
        }
        region.sort()?;
        for &[k, i, j] in &region.cells {
            let [_, columns] = self.sheet(k as usize).cells();
            let bit = region.first[k as usize] + u64::from(i) * columns as u64 + u64::from(j);
            region.mask[(bit / 64) as usize] |= 1 << (bit % 64);
        }
        Ok(region)
    }
}

/// A coordinate that is NaN, or so great that its square would overflow.
pub(super) fn unfit(query: DVec3) -> Option<f64> {
    query.to_array().into_iter().find(|x| x.is_nan() || x.abs() > LARGEST)
}

/// [`Error::NotFinite`], or [`Error::OptionOutOfRange`] for a distance that is negative or NaN.
pub(super) fn check(option: &'static str, query: DVec3, distance: f64) -> Result<()> {
    if let Some(value) = unfit(query) {
        return Err(Error::NotFinite { element: Element::Query, index: 0, value });
    }
    if distance >= 0.0 { Ok(()) } else { Err(Error::OptionOutOfRange { option, value: distance }) }
}

impl Region {
    /// Cells in rising order; blocks came in another.
    fn sort(&mut self) -> Result<()> {
        let mut order = alloc::collect(self.cells.iter().copied().zip(self.whole.iter().copied()))?;
        order.sort_unstable();
        for (k, (cell, whole)) in order.into_iter().enumerate() {
            (self.cells[k], self.whole[k]) = (cell, whole);
        }
        Ok(())
    }
}

/// What is looked at.
struct Ball {
    query: DVec3,
    radius: f64,
    tolerance: f64,
}

/// Blocks between two chances to cancel.
const ROUND: usize = 1 << 12;

impl Ball {
    fn collect<const N: usize>(
        &self,
        cells: &impl Cells<N>,
        index: &Pyramid,
        sheet: u32,
        region: &mut Region,
        job: &Job<'_>,
    ) -> Result<()> {
        let mut workspace = Workspace::default();
        let mut blocks = vec![Block::root(index)];
        let mut looked_at = 0;
        while let Some(block) = blocks.pop() {
            looked_at += 1;
            if looked_at % ROUND == 0 {
                job.step(0.0, "region")?;
            }
            if block.level > 0 {
                let within = |child: &Block| child.bound <= self.radius + self.tolerance;
                blocks.extend(block.children(index, self.query).into_iter().flatten().filter(within));
                continue;
            }
            for (i, j) in block.cells(cells) {
                let (has, whole) = self.judge(cells, (i, j), &mut workspace);
                if has {
                    alloc::push(&mut region.cells, [sheet, i as u32, j as u32])?;
                    alloc::push(&mut region.whole, whole)?;
                }
            }
        }
        Ok(())
    }

    /// Whether a cell has a point in the ball, and whether all of it is there.
    fn judge<const N: usize>(
        &self,
        cells: &impl Cells<N>,
        (i, j): (usize, usize),
        workspace: &mut Workspace<N>,
    ) -> (bool, bool) {
        let patch = cells.patch(i, j);
        if patch.farthest(self.query) <= self.radius {
            return (true, true);
        }
        let corners = patch.corners();
        if corners.as_flattened().iter().any(|corner| corner.distance(self.query) <= self.radius) {
            return (true, false);
        }
        if patch.box_distance(self.query) > self.radius + self.tolerance {
            return (false, false);
        }
        let start = glam::DVec2::splat(0.5);
        let found = nearest(&patch, self.query, start, self.radius, self.tolerance, workspace);
        (found.is_some_and(|found| found.bound <= self.radius), false)
    }
}
