//! All local minima of the distance from a point, the nearest first.
//!
//! Blocks of all sheets are searched best first. Each cell reached contributes the minima of its
//! patch (`patch_minima`), and minima along sides across which tangents may jump. A minimum on a
//! side or at a corner counts if no cell that meets the point has a descent direction there.
//! Invariant: a missing minimum is at least as far as the bound at which the search ended.

use super::bounded_block::{BlockWithDistanceBound, lowest_blocks_within};
use super::closest::Closest;
use super::descent_direction::{MAX_DISTANCE_ON_SIDE, has_descent_direction};
use super::nearest_search::cells_around;
use super::patch_minima::{LocalMinimum, find_interior_minima, find_side_minima};
use super::patch_search::{PartFrontier, nearest_on_patch};
use super::query_checks::check_query_and_distance;
use crate::cells::SheetCells;
use crate::frontier::{BranchAndBound, Frontier};
use crate::{Place, Surface, each_sheet};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort;

/// Local minima of the distance from a point.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Minima {
    /// The minima, the nearest first. The `bound` of a point concerns only its neighbourhood. If
    /// `proven` is false, the point may not be a minimum: the distance is nearly constant around
    /// it, as at a focus, or along a curve. All such cells that touch are represented by one point.
    pub points: Vec<Closest>,
    /// False if the search gave up. Missing minima are at least as far as `bound`.
    pub complete: bool,
    /// A lower bound of the distance of missing minima: the distance at which the search ended.
    pub bound: f64,
}

/// Number of undecided cells at which a search gives up.
const MAX_UNDECIDED_CELLS: usize = 512;
/// Number of blocks and cells between two progress reports.
const CELLS_PER_REPORT: usize = 1 << 7;

const PROGRESS_STAGE: &str = "minima";
/// Points within this number of tolerances are the same point.
const MAX_SAME_POINT_DISTANCE_IN_TOLERANCES: f64 = 16.0;

/// A minimum, and the cell that contains it.
#[derive(Clone, Copy)]
struct FoundMinimum {
    minimum: LocalMinimum,
    sheet: usize,
    cell: [usize; 2],
}

impl Surface<'_> {
    /// Returns the local minima of the distance from `query` that are at most `max_distance` away, the
    /// nearest first. If `max_minima` is not 0, returns only the nearest `max_minima` minima.
    ///
    /// Finds every minimum. A place that may be a minimum, without proof, is returned with `proven`
    /// false. If `max_minima` is given, cells farther than the last minimum are not searched.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the limit is negative or NaN, [`Error::NotFinite`],
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn local_minima(&self, query: DVec3, max_distance: f64, max_minima: usize, job: &Job<'_>) -> Result<Minima> {
        check_query_and_distance("limit", query, max_distance)?;
        job.step(0.0, PROGRESS_STAGE)?;
        let mut search = MinimaSearch {
            surface: self,
            query,
            max_distance,
            tolerance: self.distance_tolerance_for(query),
            max_minima,
            proven_minima: Vec::new(),
            undecided: Vec::new(),
            frontier: Frontier::default(),
            examined_count: 0,
            job,
        };
        for sheet in 0..self.len() {
            search.push_block(sheet, BlockWithDistanceBound::whole_sheet(self.sheet_and_index(sheet).1))?;
        }
        let bound = search.search_best_first()?.unwrap_or(max_distance);
        search.into_minima(bound, self.closest(query, max_distance))
    }
}

struct MinimaSearch<'a> {
    surface: &'a Surface<'a>,
    query: DVec3,
    max_distance: f64,
    tolerance: f64,
    max_minima: usize,
    proven_minima: Vec<FoundMinimum>,
    undecided: Vec<FoundMinimum>,
    /// Equal bounds are ordered by sheet, level, row and column, so that the result does not depend
    /// on the queue.
    frontier: Frontier<(usize, BlockWithDistanceBound), [usize; 4]>,
    /// The number of blocks and cells examined.
    examined_count: usize,
    job: &'a Job<'a>,
}

impl BranchAndBound for MinimaSearch<'_> {
    type SearchTask = (usize, BlockWithDistanceBound);
    type TieBreakKey = [usize; 4];
    type StopReason = Error;

    fn frontier(&mut self) -> &mut Frontier<(usize, BlockWithDistanceBound), [usize; 4]> {
        &mut self.frontier
    }

    fn is_bound_wanted(&mut self, bound: f64) -> bool {
        bound <= self.max_examined_distance() && self.undecided.len() <= MAX_UNDECIDED_CELLS
    }

    fn branch_task(&mut self, _: f64, (sheet, block): (usize, BlockWithDistanceBound)) -> Result<()> {
        self.count_cell_and_report()?;
        let (cells, index) = self.surface.sheet_and_index(sheet);
        if block.level == 0 {
            return each_sheet!(cells, cells => self.search_block(cells, &block, sheet));
        }
        let mut children = block.child_blocks(index, self.query).into_iter().flatten();
        children.try_for_each(|block| self.push_block(sheet, block))
    }
}

impl MinimaSearch<'_> {
    /// Counts a block or a cell, and reports progress.
    #[inline(never)]
    fn count_cell_and_report(&mut self) -> Result<()> {
        self.examined_count += 1;
        if self.examined_count.is_multiple_of(CELLS_PER_REPORT) { self.job.step(0.0, PROGRESS_STAGE) } else { Ok(()) }
    }

    fn push_block(&mut self, sheet: usize, block: BlockWithDistanceBound) -> Result<()> {
        self.frontier.push(block.distance_bound, [sheet, block.level, block.row, block.column], (sheet, block))
    }

    /// The distance beyond which minima are not wanted.
    fn max_examined_distance(&self) -> f64 {
        if self.max_minima == 0 || self.proven_minima.len() < self.max_minima {
            return self.max_distance;
        }
        let mut distances: Vec<f64> = self.proven_minima.iter().map(|found| found.minimum.distance).collect();
        let (_, &mut last, _) = distances.select_nth_unstable_by(self.max_minima - 1, f64::total_cmp);
        self.max_distance.min(last + self.tolerance)
    }

    fn search_block<const N: usize>(
        &mut self,
        cells: &impl SheetCells<N>,
        block: &BlockWithDistanceBound,
        sheet: usize,
    ) -> Result<()> {
        for cell in block.cells_of_block(cells) {
            self.count_cell_and_report()?;
            let patch = cells.cell_patch(cell[0], cell[1]);
            if patch.distance_bound_by_box(self.query) > self.max_distance {
                continue;
            }
            let mut minima = Vec::new();
            find_interior_minima(&patch, self.query, self.tolerance, |minimum| minima.push(minimum));
            if !cells.are_tangents_continuous_across_sides(cell[0], cell[1]) {
                find_side_minima(&patch, self.query, |minimum| minima.push(minimum));
            }
            for minimum in minima {
                self.add_minimum(FoundMinimum { minimum, sheet, cell })?;
            }
        }
        Ok(())
    }

    fn add_minimum(&mut self, candidate: FoundMinimum) -> Result<()> {
        let minimum = &candidate.minimum;
        if minimum.distance_bound > self.max_distance {
            return Ok(());
        }
        if !minimum.proven {
            return alloc::push(&mut self.undecided, candidate);
        }
        let near = MAX_SAME_POINT_DISTANCE_IN_TOLERANCES * self.tolerance;
        let is_same = |other: &FoundMinimum| other.minimum.point.distance(minimum.point) <= near;
        if minimum.distance > self.max_distance
            || self.proven_minima.iter().any(is_same)
            || !self.is_minimum_across_cells(minimum)
        {
            return Ok(());
        }
        alloc::push(&mut self.proven_minima, candidate)
    }

    /// True if no cell that meets a minimum of one patch has a descent direction there.
    fn is_minimum_across_cells(&self, minimum: &LocalMinimum) -> bool {
        let on_border = |x: f64| x <= MAX_DISTANCE_ON_SIDE || x >= 1.0 - MAX_DISTANCE_ON_SIDE;
        if !(on_border(minimum.parameters.x) || on_border(minimum.parameters.y)) {
            return true;
        }
        (0..self.surface.len()).all(|sheet| {
            let (cells, index) = self.surface.sheet_and_index(sheet);
            let mut blocks = lowest_blocks_within(index, minimum.point, self.tolerance);
            each_sheet!(cells, cells => blocks.all(|block| self.is_minimum_in_block(cells, &block, minimum)))
        })
    }

    fn is_minimum_in_block<const N: usize>(
        &self,
        cells: &impl SheetCells<N>,
        block: &BlockWithDistanceBound,
        minimum: &LocalMinimum,
    ) -> bool {
        let mut workspace = PartFrontier::default();
        block.cells_of_block(cells).all(|[i, j]| {
            let (patch, start) = (cells.cell_patch(i, j), DVec2::splat(0.5));
            if patch.distance_bound_by_box(minimum.point) > self.tolerance {
                return true;
            }
            let nearest =
                nearest_on_patch(&patch, minimum.point, start, self.tolerance, 0.1 * self.tolerance, &mut workspace);
            let Some(there) = nearest.filter(|there| there.distance <= self.tolerance) else { return true };
            !has_descent_direction(
                &patch,
                self.query,
                there.parameters,
                MAX_SAME_POINT_DISTANCE_IN_TOLERANCES * self.tolerance,
            )
        })
    }

    /// Returns the minima, with one place for all undecided cells that touch.
    fn into_minima(mut self, bound: f64, nearest: Option<Closest>) -> Result<Minima> {
        let complete = self.undecided.len() <= MAX_UNDECIDED_CELLS;
        merge_adjacent_undecided(&mut self.undecided, self.surface)?;
        let proven = std::mem::take(&mut self.proven_minima);
        // An undecided place next to a proven one is the same place.
        let near = MAX_SAME_POINT_DISTANCE_IN_TOLERANCES * self.tolerance;
        let distance = |a: &FoundMinimum, b: &FoundMinimum| a.minimum.point.distance(b.minimum.point);
        self.undecided.retain(|place| proven.iter().all(|found| distance(found, place) > near));
        let mut points = alloc::with_capacity(proven.len() + self.undecided.len() + 1)?;
        for FoundMinimum { minimum, sheet, cell } in proven.into_iter().chain(self.undecided) {
            let cell = cell.map(|k| k as u32);
            let place = Place { sheet: sheet as u32, cell, u: minimum.parameters.x, v: minimum.parameters.y };
            let LocalMinimum { point, distance, distance_bound: bound, proven, .. } = minimum;
            let normal = self.surface.normal(place);
            points.push(Closest { place, point, normal, distance, bound, proven, is_ambiguous: !proven });
        }
        // The global minimum is a local minimum on any surface.
        let reached = |point: &Closest, nearest: &Closest| point.distance <= nearest.distance + self.tolerance;
        if let Some(nearest) = nearest.filter(|nearest| !points.iter().any(|point| reached(point, nearest))) {
            points.push(nearest);
        }
        sort::sort_stable(points.as_mut_slice(), &|a, b| {
            let place = |c: &Closest| (c.place.sheet, c.place.cell);
            a.distance.total_cmp(&b.distance).then_with(|| place(a).cmp(&place(b)))
        });
        points.retain(|point| point.distance <= self.max_distance);
        merge_coincident_minima(&mut points, near)?;
        if self.max_minima > 0 {
            points.truncate(self.max_minima);
        }
        Ok(Minima { points, complete, bound })
    }
}

/// Merges points at the same position in space. Keeps the first, or a proven one if there is one.
fn merge_coincident_minima(points: &mut Vec<Closest>, max_distance: f64) -> Result<()> {
    let mut kept: Vec<Closest> = alloc::with_capacity(points.len())?;
    for point in points.drain(..) {
        // Equal points have nearly equal distances, so only the last ones need to be compared.
        let alike = kept.iter_mut().rev().take_while(|other| other.distance >= point.distance - max_distance);
        match { alike }.find(|other| other.point.distance(point.point) <= max_distance) {
            Some(other) if point.proven && !other.proven => *other = point,
            Some(other) => other.bound = other.bound.min(point.bound),
            None => kept.push(point),
        }
    }
    // A proven point may be slightly farther than the point that it replaced.
    sort::sort_stable(&mut kept, &|a, b| a.distance.total_cmp(&b.distance));
    *points = kept;
    Ok(())
}

/// Keeps the nearest of all undecided minima in cells of a sheet that touch, also across seams of
/// grids.
fn merge_adjacent_undecided(undecided: &mut Vec<FoundMinimum>, surface: &Surface<'_>) -> Result<()> {
    sort::sort_stable(undecided.as_mut_slice(), &|a, b| (a.sheet, a.cell).cmp(&(b.sheet, b.cell)));
    let mut groups = DisjointSets::new(undecided.len())?;
    for k in 0..undecided.len() {
        let FoundMinimum { sheet, cell, .. } = undecided[k];
        let of = surface.sheet(sheet);
        for next in cells_around(of.cells(), of.has_exact_seams(), cell) {
            if let Ok(other) = undecided.binary_search_by_key(&(sheet, next), |other| (other.sheet, other.cell)) {
                groups.union(k as u32, other as u32);
            }
        }
    }
    let mut best: Vec<Option<FoundMinimum>> = alloc::filled(None, undecided.len())?;
    for (k, &found) in undecided.iter().enumerate() {
        let slot = &mut best[groups.find(k as u32) as usize];
        *slot = Some(match *slot {
            Some(other) => {
                let bound = other.minimum.distance_bound.min(found.minimum.distance_bound);
                let nearer = if found.minimum.distance < other.minimum.distance { found } else { other };
                FoundMinimum { minimum: LocalMinimum { distance_bound: bound, ..nearer.minimum }, ..nearer }
            }
            None => found,
        });
    }
    *undecided = alloc::gather(best.into_iter().flatten())?;
    Ok(())
}
