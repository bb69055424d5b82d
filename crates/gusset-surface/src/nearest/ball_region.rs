//! The cells with a point within a given distance: the paper's region of task a), as bits and as a
//! list.
//!
//! Boxes exclude blocks, and a search of the patch excludes cells. The limit is fixed, so the order
//! of the search does not matter. O(blocks and cells within the distance).

use super::bounded_block::lowest_blocks_within;
use super::patch_search::{PartFrontier, nearest_on_patch};
use super::query_checks::check_query_and_distance;
use crate::cells::SheetCells;
use crate::index::BoxPyramid;
use crate::{Patch, Surface, each_sheet};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// The cells of a surface within a distance of a point.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct CellsInBall {
    /// Sheet, row and column of each cell, in ascending order.
    pub cells: Vec<[u32; 3]>,
    /// For each cell of the list, whether the whole cell is within the distance.
    pub is_whole_cell_inside: Vec<bool>,
    /// One bit for each cell of all sheets, beginning with the lowest bit of the first word. Cell
    /// (i, j) of sheet k has bit `first[k] + i * columns + j`.
    pub mask: Vec<u64>,
    /// The first bit of each sheet, then the total number of bits.
    pub first_bit_of_sheet: Vec<u64>,
}

impl CellsInBall {
    /// True if a cell is in the region.
    ///
    /// # Panics
    /// If the bit does not exist.
    pub fn contains(&self, bit: u64) -> bool {
        self.mask[(bit / 64) as usize] >> (bit % 64) & 1 == 1
    }
}

impl Surface<'_> {
    /// Returns the cells with a point at most `radius` from `query`. The result contains all these
    /// cells. It contains no cell that is farther than the radius by more than the tolerance,
    /// unless that cannot be proven.
    ///
    /// # Errors
    /// [`OptionOutOfRange`](gusset_base::Error::OptionOutOfRange) if the radius is negative or NaN,
    /// [`NotFinite`](gusset_base::Error::NotFinite),
    /// [`OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Cancelled`](gusset_base::Error::Cancelled).
    pub fn cells_in_ball(&self, query: DVec3, radius: f64, job: &Job<'_>) -> Result<CellsInBall> {
        check_query_and_distance("radius", query, radius)?;
        job.step(0.0, PROGRESS_STAGE)?;
        let mut region =
            CellsInBall { first_bit_of_sheet: alloc::with_capacity(self.len() + 1)?, ..CellsInBall::default() };
        let mut bits = 0_u64;
        for k in 0..self.len() {
            region.first_bit_of_sheet.push(bits);
            bits += self.sheet(k).cells().map(|count| count as u64).iter().product::<u64>();
        }
        region.first_bit_of_sheet.push(bits);
        region.mask = alloc::zeroed(bits.div_ceil(64) as usize)?;
        let ball = QueryBall { query, radius, tolerance: self.distance_tolerance_for(query) };
        let mut cells_in_ball = Vec::new();
        for k in 0..self.len() {
            let (sheet, index) = self.sheet_and_index(k);
            each_sheet!(sheet, cells => ball.collect_cells(cells, index, k as u32, &mut cells_in_ball, job))?;
        }
        // The blocks were visited in another order.
        cells_in_ball.sort_unstable();
        region.cells = alloc::collect(cells_in_ball.iter().map(|&(cell, _)| cell))?;
        region.is_whole_cell_inside = alloc::collect(cells_in_ball.iter().map(|&(_, whole)| whole))?;
        for &[k, i, j] in &region.cells {
            let [_, columns] = self.sheet(k as usize).cells();
            let bit = region.first_bit_of_sheet[k as usize] + u64::from(i) * columns as u64 + u64::from(j);
            region.mask[(bit / 64) as usize] |= 1 << (bit % 64);
        }
        Ok(region)
    }
}

/// Number of blocks of cells between two progress reports.
const BLOCKS_PER_REPORT: usize = 1 << 12;

const PROGRESS_STAGE: &str = "region";

/// A ball around the query.
struct QueryBall {
    query: DVec3,
    radius: f64,
    tolerance: f64,
}

impl QueryBall {
    /// Adds the cells of a sheet with a point in the ball, and whether the whole cell is in it.
    fn collect_cells<const N: usize>(
        &self,
        cells: &impl SheetCells<N>,
        index: &BoxPyramid,
        sheet: u32,
        found: &mut Vec<([u32; 3], bool)>,
        job: &Job<'_>,
    ) -> Result<()> {
        let mut workspace = PartFrontier::default();
        for (k, block) in lowest_blocks_within(index, self.query, self.radius + self.tolerance).enumerate() {
            if (k + 1).is_multiple_of(BLOCKS_PER_REPORT) {
                job.step(0.0, PROGRESS_STAGE)?;
            }
            for [i, j] in block.cells_of_block(cells) {
                let patch = cells.cell_patch(i, j);
                let whole = patch.max_control_distance(self.query) <= self.radius;
                if whole || self.reaches_patch(&patch, &mut workspace) {
                    alloc::push(found, ([sheet, i as u32, j as u32], whole))?;
                }
            }
        }
        Ok(())
    }

    /// True if a patch has a point in the ball, within the tolerance.
    fn reaches_patch<const N: usize>(&self, patch: &Patch<N>, workspace: &mut PartFrontier<N>) -> bool {
        let corners = patch.corner_points();
        if corners.as_flattened().iter().any(|corner| corner.distance(self.query) <= self.radius) {
            return true;
        }
        if patch.distance_bound_by_box(self.query) > self.radius + self.tolerance {
            return false;
        }
        let start = DVec2::splat(0.5);
        let nearest = nearest_on_patch(patch, self.query, start, self.radius, self.tolerance, workspace);
        nearest.is_some_and(|nearest| nearest.distance_bound <= self.radius)
    }
}
