//! The cells that have a point within a distance: the paper's region of task a), as bits and as a
//! list.
//!
//! Blocks are excluded by their boxes, cells by the search of their patches. No upper bound falls,
//! so that the order does not matter. O(blocks and cells that come within the distance).

use super::block::blocks_within;
use super::patch_search::{PartFrontier, nearest_on_patch};
use super::query::check;
use crate::alloc;
#[cfg(doc)]
use crate::error::Error;
use crate::error::Result;
use crate::job::Job;
use crate::surface::cells::Cells;
use crate::surface::index::Pyramid;
use crate::surface::{Patch, Surface, each_sheet};
use glam::{DVec2, DVec3};

/// Cells of a surface.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Region {
    /// Sheet, row and column of each cell, rising.
    pub cells: Vec<[u32; 3]>,
    /// By cell of the list: true if all of it is within the distance.
    pub whole: Vec<bool>,
    /// A bit for each cell of all sheets, the lowest of the first word first: that of cell (i, j)
    /// of sheet k is `first[k] + i * columns + j`.
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
    /// The cells that have a point no farther than `radius` from `query`: all of those, and none
    /// whose points are all farther than the radius by more than the tolerance, unless that cannot
    /// be proved.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a radius that is negative or NaN, [`Error::NotFinite`],
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
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
        let tolerance = self.query_tolerance(query);
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

impl Region {
    /// Puts cells into rising order; blocks came in another.
    fn sort(&mut self) -> Result<()> {
        let mut order = alloc::collect(self.cells.iter().copied().zip(self.whole.iter().copied()))?;
        order.sort_unstable();
        for (k, (cell, whole)) in order.into_iter().enumerate() {
            (self.cells[k], self.whole[k]) = (cell, whole);
        }
        Ok(())
    }
}

/// Blocks of cells between two chances to cancel.
const BLOCKS_PER_STEP: usize = 1 << 12;

/// A ball round the query.
struct Ball {
    query: DVec3,
    radius: f64,
    tolerance: f64,
}

/// How a cell lies to a ball.
#[derive(PartialEq)]
enum Overlap {
    Outside,
    Partial,
    Inside,
}

impl Ball {
    fn collect<const N: usize>(
        &self,
        cells: &impl Cells<N>,
        index: &Pyramid,
        sheet: u32,
        region: &mut Region,
        job: &Job<'_>,
    ) -> Result<()> {
        let mut workspace = PartFrontier::new();
        for (k, block) in blocks_within(index, self.query, self.radius + self.tolerance).enumerate() {
            if (k + 1).is_multiple_of(BLOCKS_PER_STEP) {
                job.step(0.0, "region")?;
            }
            for (i, j) in block.cells(cells) {
                let overlap = self.classify(&cells.patch(i, j), &mut workspace);
                if overlap != Overlap::Outside {
                    alloc::push(&mut region.cells, [sheet, i as u32, j as u32])?;
                    alloc::push(&mut region.whole, overlap == Overlap::Inside)?;
                }
            }
        }
        Ok(())
    }

    fn classify<const N: usize>(&self, patch: &Patch<N>, workspace: &mut PartFrontier<N>) -> Overlap {
        if patch.max_distance(self.query) <= self.radius {
            return Overlap::Inside;
        }
        let corners = patch.corners();
        if corners.as_flattened().iter().any(|corner| corner.distance(self.query) <= self.radius) {
            return Overlap::Partial;
        }
        if patch.box_distance(self.query) > self.radius + self.tolerance {
            return Overlap::Outside;
        }
        let start = DVec2::splat(0.5);
        match nearest_on_patch(patch, self.query, start, self.radius, self.tolerance, workspace) {
            Some(found) if found.bound <= self.radius => Overlap::Partial,
            _ => Overlap::Outside,
        }
    }
}
