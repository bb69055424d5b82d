//! The search for the nearest point: depth first, then best first.
//!
//! Sheets are searched depth first, the nearest blocks first. This needs no queue, tests boxes in
//! single precision, and soon yields a good answer. A long search moves the rest to the frontier:
//! blocks, cells and parts of cells by rising lower bounds. It ends when no bound is below the
//! answer by more than the tolerance.
//!
//! Invariant: a point of the surface is in a waiting task, or its distance is at least the upper
//! bound less the tolerance, or at least `least_settled_bound`.
//!
//! At a centre of curvature, all points of a patch are equally close, and bounds cannot separate
//! its parts. The search then ends without proof after [`MAX_EXAMINED_PARTS`] patches. It ends
//! after [`MIN_EXAMINED_PARTS`] if the last gain is long past and little is left to gain. Memory:
//! O(patches examined).

use super::bounded_block::BlockWithDistanceBound;
use super::candidate_block::{CandidateBlock, CellCandidate};
use super::foot_point::{FootPoint, MAX_NEWTON_STEPS_ON_PART, MAX_NEWTON_STEPS_ON_PATCH, descend_to_foot};
use super::incumbent::{IncumbentAnswers, NearestPointCandidate};
use super::patch_bounds::best_distance_bound_of_patch;
use super::patch_part::PatchPart;
use crate::cells::SheetCells;
use crate::frontier::{BranchAndBound, Frontier};
use crate::index::{BoxPyramid, OrientedBox};
use crate::{Patch, Surface, each_sheet};
use glam::{DVec2, DVec3};
use std::convert::Infallible;

/// Number of patches, and of blocks of cells, examined depth first before the rest moves to the
/// frontier.
const MAX_DEPTH_FIRST_PATCHES: usize = 64;
const MAX_DEPTH_FIRST_BLOCKS: usize = 1 << 10;
/// Number of patches and parts examined before a search may end without proof. The gap to the lower
/// bound must be small, and half of these must have been examined since the last gain.
const MIN_EXAMINED_PARTS: usize = 1 << 12;
/// Largest number of patches and parts examined.
const MAX_EXAMINED_PARTS: usize = 100_000;
/// Gap relative to the distance that counts as small. The foci of coarse surfaces have smaller
/// gaps, whose parts cannot be separated.
const SMALL_RELATIVE_GAP: f64 = 1e-3;
/// Number of candidates collected before they are examined.
const MAX_CANDIDATE_CELLS: usize = 64;
/// Largest number of steps from cell to cell in the final descent.
const MAX_CELLS_OF_FINAL_DESCENT: usize = 256;

/// A block on the depth-first stack, with a lower bound of its squared distance in single precision
/// (see [`SinglePrecisionQuery`]).
#[derive(Debug, Clone, Copy, Default)]
struct StackedBlock {
    squared_distance_bound: f32,
    level: u32,
    row: u32,
    column: u32,
}

/// Bound of the error of a sum of three squares in single precision below the normal range, and of
/// the rounding of the number it is compared with. Each is half of the smallest positive number.
const MAX_SUBNORMAL_SQUARE_ERROR: f64 = 2.0 * f32::from_bits(1) as f64;

/// The query, prepared for tests of boxes in single precision.
struct SinglePrecisionQuery {
    /// Position relative to the index's origin.
    position_from_index_origin: DVec3,
    rounded_position: [f32; 3],
    /// Bound of how far rounding of the query may raise a bound above the distance.
    rounding: f64,
}

impl SinglePrecisionQuery {
    fn new(index: &BoxPyramid, query: DVec3) -> Self {
        let local = query - index.origin();
        let rounding = 2.0 * f64::from(f32::EPSILON) * local.abs().max_element();
        SinglePrecisionQuery {
            position_from_index_origin: local,
            rounded_position: local.to_array().map(|x| x as f32),
            rounding,
        }
    }

    /// The squared distance that boxes farther than `limit` exceed. The relative error of sums of
    /// three squares is 2^-22, the absolute error [`MAX_SUBNORMAL_SQUARE_ERROR`].
    #[inline(always)]
    fn squared_distance_threshold(&self, limit: f64) -> f32 {
        let distance = (limit + self.rounding) * (1.0 + 2e-6);
        (distance * distance + MAX_SUBNORMAL_SQUARE_ERROR) as f32
    }

    /// The distance that a squared bound proves.
    fn distance_from_squared_bound(&self, bound: f32) -> f64 {
        let square = (f64::from(bound) - MAX_SUBNORMAL_SQUARE_ERROR).max(0.0);
        (square.sqrt() * (1.0 - 2e-6) - self.rounding).max(0.0)
    }
}

/// A waiting task of a sheet.
#[derive(Debug, Clone, Copy)]
pub(super) enum NearestTask {
    Block(BlockWithDistanceBound),
    /// A cell, and parameters close to its nearest point.
    Cell {
        cell: [u32; 2],
        start: DVec2,
    },
    /// A part of a cell. Its nearest point is known, but not proven.
    Part {
        cell: [u32; 2],
        from: DVec2,
        size: DVec2,
    },
}

/// The patch over a cell, and the cell.
struct CellAndPatch<'a, const N: usize> {
    patch: &'a Patch<N>,
    sheet: u32,
    cell: [u32; 2],
}

/// A search for the nearest point: answers, tasks, and the work done. It can be reused.
#[derive(Debug, Default)]
pub(super) struct NearestPointSearch {
    pub(super) incumbent: IncumbentAnswers,
    /// The smallest lower bound of all settled parts.
    pub(super) least_settled_bound: f64,
    /// Number of patches and parts examined, and this number at the last notable gain.
    evaluations: usize,
    evaluations_at_last_gain: usize,
    /// Number of blocks of cells examined.
    examined_block_count: usize,
    stack: Vec<StackedBlock>,
    candidates: Vec<CellCandidate>,
    /// Tasks with their sheet.
    frontier: Frontier<(u32, NearestTask)>,
}

impl NearestPointSearch {
    fn begin_query(&mut self, query: DVec3, limit: f64, tolerance: f64) {
        self.incumbent.begin_query(query, limit, tolerance);
        self.candidates.clear();
        self.frontier.clear();
        (self.least_settled_bound, self.evaluations, self.evaluations_at_last_gain, self.examined_block_count) =
            (f64::INFINITY, 0, 0, 0);
    }

    /// The distance beyond which nothing needs to be examined.
    #[inline(always)]
    fn max_examined_distance(&self) -> f64 {
        self.incumbent.distance_upper_bound.max_examined_distance()
    }

    /// Records the lower bound of a part that needs no more work.
    #[inline(always)]
    fn record_lower_bound(&mut self, bound: f64) {
        self.least_settled_bound = self.least_settled_bound.min(bound);
    }

    /// Adds a task to the frontier. If the allocation fails, drops the task and records its bound.
    fn push_task(&mut self, bound: f64, sheet: u32, task: NearestTask) {
        if bound <= self.max_examined_distance() && self.frontier.push(bound, (), (sheet, task)).is_err() {
            self.record_lower_bound(bound);
        }
    }

    /// Searches a sheet depth first, the nearest children first. A long search moves the rest to
    /// the frontier.
    fn search_sheet<const N: usize>(&mut self, cells: &impl SheetCells<N>, index: &BoxPyramid, sheet: u32) {
        let query = SinglePrecisionQuery::new(index, self.incumbent.query);
        let levels = index.levels();
        let mut stack = std::mem::take(&mut self.stack);
        stack.clear();
        stack.push(StackedBlock { level: levels.len() as u32, ..StackedBlock::default() });
        while let Some(block) = stack.pop() {
            if block.squared_distance_bound > query.squared_distance_threshold(self.max_examined_distance()) {
                continue;
            }
            let (row, column) = (block.row as usize, block.column as usize);
            if self.evaluations >= MAX_DEPTH_FIRST_PATCHES || self.examined_block_count >= MAX_DEPTH_FIRST_BLOCKS {
                let (bound, level) =
                    (query.distance_from_squared_bound(block.squared_distance_bound), block.level as usize);
                self.push_task(
                    bound,
                    sheet,
                    NearestTask::Block(BlockWithDistanceBound { distance_bound: bound, level, row, column }),
                );
                continue;
            }
            if block.level == 0 {
                let extent = self.collect_block_candidates(&CandidateBlock { cells, index, row, column });
                // From afar, the first answers and their directions exclude most other cells.
                let is_far = self.incumbent.direction == DVec3::ZERO && self.max_examined_distance() > 4.0 * extent;
                if is_far || self.candidates.len() >= MAX_CANDIDATE_CELLS {
                    self.examine_candidates(cells, sheet);
                }
                continue;
            }
            let level = &levels[block.level as usize - 1];
            let distances =
                level.child_boxes(row, column).distances_squared_in_single_precision(query.rounded_position);
            let threshold = query.squared_distance_threshold(self.max_examined_distance());
            let first = stack.len();
            for (child, &boxed) in distances.iter().enumerate() {
                let (row, column) = (2 * row + child / 2, 2 * column + child % 2);
                if !level.has_block(row, column) {
                    continue;
                }
                let bound = if boxed > threshold {
                    boxed
                } else {
                    let oriented =
                        |oriented: &OrientedBox| oriented.distance_squared(query.position_from_index_origin) as f32;
                    level.oriented_box(row, column).map_or(0.0, oriented).max(boxed)
                };
                if bound > threshold {
                    continue;
                }
                // Insertion sort: the nearest child is last, and taken first.
                let mut at = stack.len();
                stack.push(StackedBlock {
                    squared_distance_bound: bound,
                    level: block.level - 1,
                    row: row as u32,
                    column: column as u32,
                });
                while at > first && stack[at - 1].squared_distance_bound < bound {
                    stack.swap(at, at - 1);
                    at -= 1;
                }
            }
        }
        self.stack = stack;
        self.examine_candidates(cells, sheet);
    }

    /// Adds a block's candidates. Returns the block's extent.
    #[inline(always)]
    fn collect_block_candidates<const N: usize>(&mut self, leaf: &CandidateBlock<'_, impl SheetCells<N>, N>) -> f64 {
        self.examined_block_count += 1;
        let (query, direction) = (self.incumbent.query, self.incumbent.direction);
        leaf.find_candidates(query, direction, &mut self.incumbent.distance_upper_bound, &mut self.candidates)
    }

    /// Examines the candidates of a sheet by rising lower bounds.
    fn examine_candidates<const N: usize>(&mut self, cells: &impl SheetCells<N>, sheet: u32) {
        let mut candidates = std::mem::take(&mut self.candidates);
        candidates
            .sort_unstable_by(|a, b| a.distance_bound.total_cmp(&b.distance_bound).then_with(|| a.cell.cmp(&b.cell)));
        for &CellCandidate { distance_bound: bound, direction, start_parameters: start, cell } in &candidates {
            let limit = self.max_examined_distance();
            if bound > limit {
                // All following candidates are beyond the limit too.
                break;
            }
            let patch = cells.cell_patch(cell[0] as usize, cell[1] as usize);
            let is_beyond =
                |direction: DVec3| patch.distance_bound_by_half_space(self.incumbent.query, direction) > limit;
            if !is_beyond(direction) && !is_beyond(self.incumbent.direction) {
                self.examine_patch(&CellAndPatch { patch: &patch, sheet, cell }, start);
            }
        }
        candidates.clear();
        self.candidates = candidates;
    }

    /// Examines the patch over a cell. `start` is close to its nearest point.
    fn examine_cell<const N: usize>(
        &mut self,
        cells: &impl SheetCells<N>,
        sheet: u32,
        [i, j]: [usize; 2],
        start: DVec2,
    ) {
        self.examine_patch(&CellAndPatch { patch: &cells.cell_patch(i, j), sheet, cell: [i as u32, j as u32] }, start);
    }

    fn examine_patch<const N: usize>(&mut self, at: &CellAndPatch<'_, N>, start: DVec2) {
        self.evaluations += 1;
        let (query, tolerance) = (self.incumbent.query, self.incumbent.tolerance);
        let foot = descend_to_foot(at.patch, query, start, MAX_NEWTON_STEPS_ON_PATCH);
        let bound = best_distance_bound_of_patch(at.patch, query, &foot, 0.0, tolerance);
        if bound > self.max_examined_distance() {
            return;
        }
        self.add_answer(at, &foot);
        if bound >= foot.distance - tolerance {
            self.record_lower_bound(bound);
        } else {
            self.push_task(bound, at.sheet, NearestTask::Part { cell: at.cell, from: DVec2::ZERO, size: DVec2::ONE });
        }
    }

    fn examine_part<const N: usize>(&mut self, at: &CellAndPatch<'_, N>, part: &PatchPart<N>) {
        if part.distance_bound > self.max_examined_distance() {
            return;
        }
        self.evaluations += 1;
        let (query, tolerance) = (self.incumbent.query, self.incumbent.tolerance);
        let local = descend_to_foot(&part.patch, query, DVec2::splat(0.5), MAX_NEWTON_STEPS_ON_PART);
        if local.distance <= self.max_examined_distance().min(self.incumbent.nearest_distance()) {
            // Evaluated on the whole patch, because the part's control points are rounded.
            self.add_answer(at, &FootPoint::from_place(at.patch, query, part.place_in_patch(local.parameters)));
        }
        let bound = best_distance_bound_of_patch(&part.patch, query, &local, part.distance_bound, tolerance);
        if bound >= self.incumbent.nearest_distance() - tolerance || part.is_too_small_to_split() {
            self.record_lower_bound(bound);
        } else {
            self.push_task(
                bound,
                at.sheet,
                NearestTask::Part { cell: at.cell, from: part.low_parameters, size: part.parameter_lengths },
            );
        }
    }

    /// Adds an answer.
    fn add_answer<const N: usize>(&mut self, at: &CellAndPatch<'_, N>, foot: &FootPoint) {
        let FootPoint { parameters: place, jet, distance } = *foot;
        if self.incumbent.is_notably_closer(distance) {
            self.evaluations_at_last_gain = self.evaluations;
        }
        let normal = jet.unit_normal_if_regular(at.patch.derivative_noise()).unwrap_or_default();
        let (sheet, cell) = (at.sheet, at.cell);
        self.incumbent.add_answer(NearestPointCandidate {
            point: jet.point,
            normal,
            distance,
            sheet,
            cell,
            parameters: place,
        });
    }

    /// True if the search may end although some points may be as close as `distance_bound`.
    fn may_end_without_proof(&self, distance_bound: f64) -> bool {
        let (distance, tolerance) = (self.incumbent.nearest_distance(), self.incumbent.tolerance);
        let is_stalled = self.evaluations >= MIN_EXAMINED_PARTS
            && self.evaluations - self.evaluations_at_last_gain >= MIN_EXAMINED_PARTS / 2;
        let is_near = distance - distance_bound <= (SMALL_RELATIVE_GAP * distance).max(tolerance);
        self.evaluations >= MAX_EXAMINED_PARTS || (is_stalled && is_near)
    }

    /// Opens a task of a sheet. Its parts may become waiting tasks.
    fn examine_or_split_task<const N: usize>(
        &mut self,
        cells: &impl SheetCells<N>,
        index: &BoxPyramid,
        sheet: u32,
        bound: f64,
        task: NearestTask,
    ) {
        let query = self.incumbent.query;
        match task {
            NearestTask::Block(BlockWithDistanceBound { level: 0, row, column, .. }) => {
                let before = self.incumbent.distance_upper_bound.distance;
                self.collect_block_candidates(&CandidateBlock { cells, index, row, column });
                let upper = self.incumbent.distance_upper_bound.distance;
                if upper < before && self.incumbent.is_notably_closer(upper) {
                    self.examine_candidates(cells, sheet);
                }
                while let Some(CellCandidate { distance_bound: bound, start_parameters: start, cell, .. }) =
                    self.candidates.pop()
                {
                    self.push_task(bound.max(0.0), sheet, NearestTask::Cell { cell, start });
                }
            }
            NearestTask::Block(block) => {
                for child in block.child_blocks(index, query).into_iter().flatten() {
                    self.push_task(child.distance_bound.max(bound), sheet, NearestTask::Block(child));
                    let cell = child.middle_cell(cells);
                    if self.incumbent.is_notably_closer(cells.corner_point(cell[0], cell[1]).distance(query)) {
                        self.examine_cell(cells, sheet, cell, DVec2::ZERO);
                    }
                }
            }
            NearestTask::Cell { cell, start } => self.examine_cell(cells, sheet, cell.map(|k| k as usize), start),
            NearestTask::Part { cell, from, size } => {
                let patch = cells.cell_patch(cell[0] as usize, cell[1] as usize);
                let at = CellAndPatch { patch: &patch, sheet, cell };
                let part = PatchPart::from_range(&patch, from, size, bound);
                part.split_part(|part| self.examine_part(&at, &part.with_cheap_distance_bounds(query)));
            }
        }
    }

    /// Descends from the nearest answer across cells, because a search that ends without proof may
    /// have stopped short of the minimum.
    fn descend_across_cells<const N: usize>(&mut self, cells: &impl SheetCells<N>, closed: [bool; 2]) {
        for _ in 0..MAX_CELLS_OF_FINAL_DESCENT {
            let Some(best) = self.incumbent.nearest_answer else { return };
            for cell in cells_around(cells.cell_counts(), closed, best.cell.map(|k| k as usize)) {
                self.examine_cell(cells, best.sheet, cell, DVec2::splat(0.5));
            }
            if self.incumbent.nearest_distance() >= best.distance - self.incumbent.tolerance {
                return;
            }
        }
    }
}

/// A cell and its neighbours in a sheet, across the seams of closed directions.
pub(super) fn cells_around(
    counts: [usize; 2],
    closed: [bool; 2],
    cell: [usize; 2],
) -> impl Iterator<Item = [usize; 2]> {
    // Steps 0, 1 and 2 are the previous, the same and the next cell.
    let step = move |k: usize, by: usize| {
        let (at, count) = (cell[k] + by, counts[k]);
        if closed[k] { Some((at + count - 1) % count) } else { at.checked_sub(1).filter(|&at| at < count) }
    };
    (0..9).filter_map(move |k| Some([step(0, k / 3)?, step(1, k % 3)?]))
}

/// A search of a surface.
pub(super) struct NearestSurfaceSearch<'a> {
    pub(super) surface: &'a Surface<'a>,
    pub(super) search: &'a mut NearestPointSearch,
}

impl NearestSurfaceSearch<'_> {
    /// Searches all sheets for the point nearest to `query`, at most `limit` away.
    pub(super) fn find_nearest(&mut self, query: DVec3, limit: f64, tolerance: f64) {
        let NearestSurfaceSearch { surface, search } = self;
        search.begin_query(query, limit, tolerance);
        for k in sheets_by_distance(surface, query) {
            let (sheet, index) = surface.sheet_and_index(k);
            each_sheet!(sheet, cells => search.search_sheet(cells, index, k as u32));
        }
        let Ok(left) = self.search_best_first();
        let NearestSurfaceSearch { surface, search } = self;
        left.into_iter().for_each(|bound| search.record_lower_bound(bound));
        if let Some(best) =
            search.incumbent.nearest_answer.filter(|best| search.least_settled_bound < best.distance - tolerance)
        {
            let sheet = surface.sheet(best.sheet as usize);
            each_sheet!(sheet, cells => search.descend_across_cells(cells, sheet.is_closed()));
        }
    }
}

impl BranchAndBound for NearestSurfaceSearch<'_> {
    type SearchTask = (u32, NearestTask);
    type TieBreakKey = ();
    type StopReason = Infallible;

    fn frontier(&mut self) -> &mut Frontier<(u32, NearestTask)> {
        &mut self.search.frontier
    }

    fn is_bound_wanted(&mut self, bound: f64) -> bool {
        bound <= self.search.max_examined_distance() && !self.search.may_end_without_proof(bound)
    }

    fn branch_task(&mut self, bound: f64, (sheet, task): (u32, NearestTask)) -> Result<(), Infallible> {
        self.search.evaluations += 1;
        let (cells, index) = self.surface.sheet_and_index(sheet as usize);
        each_sheet!(cells, cells => self.search.examine_or_split_task(cells, index, sheet, bound, task));
        Ok(())
    }
}

/// All sheets, the one with the nearest box first.
fn sheets_by_distance(surface: &Surface<'_>, query: DVec3) -> impl Iterator<Item = usize> {
    let first = if surface.len() == 1 {
        0
    } else {
        let distance = |k: usize| surface.sheet_and_index(k).1.bounding_box().distance_squared(query);
        (0..surface.len()).map(|k| (distance(k), k)).fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a }).1
    };
    std::iter::once(first).chain((0..surface.len()).filter(move |&k| k != first))
}
