//! Task b) of the paper as a minimum: the place whose normal makes the angle nearest to a given one
//! with a direction.
//!
//! Branch and bound over blocks, cells and parts of cells. The paper bounds the angle over a region
//! by curvature times diameter. Here, the bounds are the cones of normals, then the ranges of the
//! components of N. Close to the answer, the signs of the coefficients of sin^2 theta H^2 - cos^2
//! theta P (see `isophote`) are sharper. They tell whether all angles of a part are on one side of
//! theta.
//!
//! Invariant: the deviation of every discarded part is at least the best deviation less
//! [`ANGLE_TOLERANCE_RADIANS`], or is included in the returned bound. Cost: about O(cells whose
//! bound is below the answer), at most [`MAX_PARTS_PER_CELL`] parts for each.

use super::cone_culling;
use super::contour_lattice::ContourLattice;
use super::contour_source::SideContinuity;
use super::normal_fields::{Hodographs, sum_of_squared_fields};
use super::projected_normals::{ProjectedNormals, frame_with_third_axis};
use crate::cells::SheetCells;
use crate::checks::unit_vector;
use crate::index::ConePyramid;
use crate::ranges::angle_range_to_third_axis;
use crate::subdivision::BernsteinField;
use crate::{Place, Sheet, Surface, each_sheet};
use glam::{DVec2, DVec3};
use gusset_base::error::{Error, Result};
use gusset_base::geom::subdivision::{BoxTest, Subdivision, SubdivisionLimits, subdivide};
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_base::{alloc, par};
use std::convert::Infallible;
use std::f64::consts::PI;

/// Accuracy to which the answer is proven, in radians.
const ANGLE_TOLERANCE_RADIANS: f64 = 1e-9;
/// Largest number of halvings of each parameter of a cell, and of parts examined in it.
const MAX_SUBDIVISION_DEPTH: u32 = 40;
const MAX_PARTS_PER_CELL: usize = 4096;
/// Number of blocks that a thread searches in one task, and of tasks between two progress reports.
const BLOCKS_PER_TASK: usize = 64;
const TASKS_PER_REPORT: usize = 16;
/// Number of blocks of each level that are searched for a first bound.
const BLOCKS_PER_LEVEL_FOR_FIRST_BOUND: usize = 16;

/// The place where a normal's angle is nearest to a given one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearestAngle {
    /// The place.
    pub place: Place,
    /// The point.
    pub point: DVec3,
    /// The unit normal.
    pub normal: DVec3,
    /// The angle between the normal and the direction, in radians.
    pub angle: f64,
    /// The difference of this angle from the given one.
    pub deviation: f64,
    /// A lower bound of the deviation of all normals.
    pub bound: f64,
}

/// The given angle.
#[derive(Clone, Copy)]
struct TargetAngle {
    angle: f64,
    unsigned: bool,
}

/// The best place so far.
#[derive(Clone, Copy)]
struct BestAngle {
    deviation: f64,
    place: Option<Place>,
}

/// A cell that may contain a better place.
struct CandidateCell {
    deviation_bound: f64,
    sheet: u32,
    cell: [u32; 2],
}

impl TargetAngle {
    /// The difference between the angle of a vector in the frame and the target. Infinite for a
    /// vector that vanishes within `rounding_error`.
    fn angle_deviation(&self, [x, y, z]: [f64; 3], rounding_error: f64) -> f64 {
        if x.abs() <= rounding_error && y.abs() <= rounding_error && z.abs() <= rounding_error {
            return f64::INFINITY;
        }
        let along = if self.unsigned { z.abs() } else { z };
        (libm::atan2((x * x + y * y).sqrt(), along) - self.angle).abs()
    }

    /// A lower bound of the deviation of angles between `low` and `high`.
    fn deviation_bound(&self, [low, high]: [f64; 2]) -> f64 {
        let outside = |goal: f64| (low - goal).max(goal - high).max(0.0);
        if self.unsigned { outside(self.angle).min(outside(PI - self.angle)) } else { outside(self.angle) }
    }

    /// True if the coefficients prove that no angle deviates by less than `limit`.
    fn is_deviation_beyond<const H: usize, const M: usize>(&self, normal: &[BernsteinField<H>; 3], limit: f64) -> bool {
        let [first, second, along] = normal;
        let (h, p): (BernsteinField<M>, BernsteinField<M>) =
            (sum_of_squared_fields(&[*along]), sum_of_squared_fields(&[*first, *second]));
        let front = along.coefficient_range()[0] >= 0.0;
        let behind = along.coefficient_range()[1] <= 0.0;
        // Tests whether all angles are at least theta, or, if `below`, at most theta.
        let is_beyond = |theta: f64, below: bool| {
            if !(0.0..=PI).contains(&theta) {
                return false;
            }
            let (sin, cos) = (libm::sin(theta), libm::cos(theta));
            let [low, high] = h.linear_combination(sin * sin, &p, -cos * cos).coefficient_range();
            match (below, cos >= 0.0) {
                (false, true) => behind || high <= 0.0,
                (false, false) => behind && low >= 0.0,
                (true, true) => front && low >= 0.0,
                (true, false) => front || high <= 0.0,
            }
        };
        let outside = |goal: f64| is_beyond(goal + limit, false) || is_beyond(goal - limit, true);
        outside(self.angle) && (!self.unsigned || outside(PI - self.angle))
    }
}

/// True if all components are within the rounding error.
fn do_components_vanish(ranges: &[[f64; 2]; 3], rounding_error: f64) -> bool {
    ranges.iter().all(|&[low, high]| low >= -rounding_error && high <= rounding_error)
}

/// A part of a cell with the normals over it.
struct NormalCellPart<const H: usize> {
    normal: [BernsteinField<H>; 3],
    low_corner: DVec2,
    size: f64,
    /// The rounding error of components of normals.
    rounding_error: f64,
    deviation: f64,
}

impl<const H: usize> NormalCellPart<H> {
    fn new(normal: [BernsteinField<H>; 3], from: DVec2, size: f64, rounding_error: f64, goal: &TargetAngle) -> Self {
        let deviation = goal.angle_deviation([0, 1, 2].map(|k| normal[k].evaluate_jet(0.5, 0.5).value), rounding_error);
        NormalCellPart { normal, low_corner: from, size, rounding_error, deviation }
    }

    fn quarters(&self, goal: &TargetAngle) -> [NormalCellPart<H>; 4] {
        let [first, second, along] = [0, 1, 2].map(|k| self.normal[k].quarters());
        let half = 0.5 * self.size;
        [DVec2::ZERO, DVec2::Y, DVec2::X, DVec2::ONE].map(|corner| {
            let k = 2 * corner.x as usize + corner.y as usize;
            let from = self.low_corner + half * corner;
            NormalCellPart::new([first[k], second[k], along[k]], from, half, self.rounding_error, goal)
        })
    }
}

/// The search among a sheet's normals.
struct SheetAngleSearch<'a, C, const N: usize> {
    normals: ProjectedNormals<'a, C, N>,
    sheet: u32,
    goal: TargetAngle,
}

impl<'a, C: SheetCells<N>, const N: usize> SheetAngleSearch<'a, C, N> {
    fn new(surface: &'a Surface<'_>, k: usize, cells: &'a C, frame: [DVec3; 3], goal: TargetAngle) -> Self {
        let normals = ProjectedNormals::new(surface, k, cells, frame, SideContinuity::Discontinuous);
        SheetAngleSearch { normals, sheet: k as u32, goal }
    }

    /// The blocks that may contain an angle as good as the best one. Searches the most promising
    /// blocks first, to improve the best angle.
    fn blocks_that_may_improve_angle(
        &self,
        cones: &ConePyramid,
        lattice: &ContourLattice,
        best: &BestAngle,
    ) -> Result<Vec<[u32; 2]>> {
        let direction = self.normals.frame[2];
        let mut front = vec![[0; 2]];
        for level in (0..cones.level_count()).rev() {
            let below = front.iter().flat_map(|&[r, c]| (0..4).map(move |k| [2 * r + k / 2, 2 * c + k % 2]));
            let bound = |at: [usize; 2]| {
                Some((
                    self.goal.deviation_bound(cones.cone_of_block(level, at[0], at[1])?.angle_range_to(direction)),
                    at,
                ))
            };
            let mut bounds: Vec<(f64, [usize; 2])> = below.filter_map(bound).collect();
            sort::sort_stable(&mut bounds, &|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            front = bounds.into_iter().take(BLOCKS_PER_LEVEL_FOR_FIRST_BOUND).map(|(_, at)| at).collect();
        }
        let mut shown = *best;
        for [r, c] in front {
            for cell in self.normals.block_corners_and_cells(lattice, [r as u32, c as u32]).1 {
                self.test_cell_middle(cell, &mut shown, &mut Vec::new())?;
            }
        }
        cone_culling::select_blocks_by_cones(cones, direction, |range| {
            self.goal.deviation_bound(range) <= shown.deviation
        })
    }

    /// Evaluates the middles of cells, and collects the cells that may contain a better place.
    fn collect_candidates(
        &self,
        cones: &ConePyramid,
        lattice: &ContourLattice,
        best: &mut BestAngle,
        candidates: &mut Vec<CandidateCell>,
        job: &Job<'_>,
    ) -> Result<()> {
        let blocks = self.blocks_that_may_improve_angle(cones, lattice, best)?;
        let count = blocks.len();
        for first in (0..count).step_by(BLOCKS_PER_TASK * TASKS_PER_REPORT) {
            job.step(first as f64 / count as f64, "angles")?;
            let known = *best;
            let parts = par::map(
                job.requested_threads(),
                par::split_into_ranges((count - first).min(BLOCKS_PER_TASK * TASKS_PER_REPORT), BLOCKS_PER_TASK),
                |range| {
                    let (mut best, mut candidates) = (known, Vec::new());
                    for &[r, c] in &blocks[first..][range] {
                        let cone = cones.cone_of_block(0, r as usize, c as usize);
                        if cone.is_some_and(|cone| {
                            self.goal.deviation_bound(cone.angle_range_to(self.normals.frame[2])) > best.deviation
                        }) {
                            continue;
                        }
                        let (corners, cells) = self.normals.block_corners_and_cells(lattice, [r, c]);
                        for cell in cells {
                            if self
                                .goal
                                .deviation_bound(angle_range_to_third_axis(&corners.normal_component_ranges(cell), 0.0))
                                < best.deviation
                            {
                                self.test_cell_middle(cell, &mut best, &mut candidates)?;
                            }
                        }
                    }
                    Ok((best, candidates))
                },
            )?;
            for part in parts {
                let (found, some): (BestAngle, Vec<CandidateCell>) = part?;
                if found.deviation < best.deviation {
                    *best = found;
                }
                alloc::extend(candidates, some)?;
            }
            candidates.retain(|candidate| candidate.deviation_bound < best.deviation);
        }
        Ok(())
    }

    fn test_cell_middle(
        &self,
        [i, j]: [usize; 2],
        best: &mut BestAngle,
        candidates: &mut Vec<CandidateCell>,
    ) -> Result<()> {
        let (cell, patch) = ([i as u32, j as u32], self.normals.cells.cell_patch(i, j));
        let of = Hodographs::new(&patch, &self.normals.frame);
        let (ranges, rounding_error) = (of.normal_component_ranges(), self.normals.normal_rounding_error(&of));
        let bound = self.goal.deviation_bound(angle_range_to_third_axis(&ranges, 0.0));
        if bound >= best.deviation || do_components_vanish(&ranges, rounding_error) {
            return Ok(());
        }
        let normal = patch.jet(0.5, 0.5).normal();
        let deviation = self.goal.angle_deviation(self.normals.frame.map(|axis| normal.dot(axis)), rounding_error);
        if deviation < best.deviation {
            *best = BestAngle { deviation, place: Some(Place { sheet: self.sheet, cell, u: 0.5, v: 0.5 }) };
        }
        alloc::push(candidates, CandidateCell { deviation_bound: bound, sheet: self.sheet, cell })
    }

    /// Improves the best place within a cell. Returns a lower bound of the deviations in the cell.
    fn search_cell<const H: usize, const M: usize>(&self, cell: [u32; 2], best: &mut BestAngle) -> f64 {
        let of = self.normals.hodographs(cell.map(|k| k as usize));
        let (normal, rounding_error) =
            (std::array::from_fn(|k| of.normal_component::<H>(k)), self.normals.normal_rounding_error(&of));
        let whole = NormalCellPart::new(normal, DVec2::ZERO, 1.0, rounding_error, &self.goal);
        let mut search = CellAngleSearch::<M> {
            goal: &self.goal,
            sheet: self.sheet,
            cell,
            best_angle: best,
            deviation_bound: f64::INFINITY,
        };
        let limits = SubdivisionLimits { max_depth: MAX_SUBDIVISION_DEPTH, max_boxes: MAX_PARTS_PER_CELL };
        let Ok(()) = subdivide(&mut search, whole, &mut Vec::new(), limits);
        search.deviation_bound
    }
}

/// The search of one cell. M is the degree of squares of normals plus one.
struct CellAngleSearch<'a, const M: usize> {
    goal: &'a TargetAngle,
    sheet: u32,
    cell: [u32; 2],
    best_angle: &'a mut BestAngle,
    /// A lower bound of the deviations in settled parts.
    deviation_bound: f64,
}

impl<const H: usize, const M: usize> Subdivision<NormalCellPart<H>, 4> for CellAngleSearch<'_, M> {
    type Solution = Infallible;
    type Split = ();
    type Stop = Infallible;

    fn classify_box(&mut self, part: &NormalCellPart<H>) -> Result<BoxTest<Infallible, ()>, Infallible> {
        if part.deviation < self.best_angle.deviation {
            let at = part.low_corner + 0.5 * part.size;
            let place = Place { sheet: self.sheet, cell: self.cell, u: at.x, v: at.y };
            *self.best_angle = BestAngle { deviation: part.deviation, place: Some(place) };
        }
        let ranges = part.normal.map(|field| field.coefficient_range());
        if do_components_vanish(&ranges, part.rounding_error) {
            // The normal does not exist here.
            return Ok(BoxTest::Empty);
        }
        let proved = (self.best_angle.deviation - ANGLE_TOLERANCE_RADIANS).max(0.0);
        let near = self.goal.deviation_bound(angle_range_to_third_axis(&ranges, 0.0));
        if near >= proved || self.goal.is_deviation_beyond::<H, M>(&part.normal, proved) {
            self.deviation_bound = self.deviation_bound.min(near.max(proved));
            return Ok(BoxTest::Empty);
        }
        Ok(BoxTest::Undecided(()))
    }

    fn record_solution(&mut self, _: NormalCellPart<H>, solution: Infallible) -> Result<(), Infallible> {
        Err(solution)
    }

    fn record_unresolved(&mut self, part: NormalCellPart<H>, _exhausted: bool) -> Result<(), Infallible> {
        let ranges = part.normal.map(|field| field.coefficient_range());
        self.deviation_bound =
            self.deviation_bound.min(self.goal.deviation_bound(angle_range_to_third_axis(&ranges, 0.0)));
        Ok(())
    }

    /// Sorts the most promising part last, so that it is taken first.
    fn split_box(&mut self, part: NormalCellPart<H>, (): ()) -> [NormalCellPart<H>; 4] {
        let mut quarters = part.quarters(self.goal);
        sort::sort_stable(&mut quarters, &|a, b| b.deviation.total_cmp(&a.deviation));
        quarters
    }
}

impl Surface<'_> {
    /// Finds the place where the angle between normal and direction is nearest to `angle`, in
    /// radians from 0 to pi. If `unsigned`, a normal and its opposite are equivalent, and the
    /// largest angle is pi / 2. The result is proven to 1e-9, unless its bound says otherwise.
    /// Returns `None` if no normal exists.
    ///
    /// The first query builds the cones of normals in O(cells). After that, a query takes about
    /// O(cells whose angles are close to the target).
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the direction is zero or not finite, or the angle is out of
    /// range; [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn nearest_angle(
        &self,
        axis: DVec3,
        angle: f64,
        unsigned: bool,
        job: &Job<'_>,
    ) -> Result<Option<NearestAngle>> {
        let axis = unit_vector(axis, "direction")?;
        let max = if unsigned { 0.5 * PI } else { PI };
        Error::require(
            (0.0..=max + 1e-15).contains(&angle),
            "angle",
            angle,
            if unsigned { "from 0 to pi / 2" } else { "from 0 to pi" },
        )?;
        let (goal, frame) = (TargetAngle { angle, unsigned }, frame_with_third_axis(axis));
        let mut best = BestAngle { deviation: f64::INFINITY, place: None };
        let mut candidates = Vec::new();
        for k in 0..self.len() {
            let (part, sheet) = (self.sheet_job(k, job), self.sheet(k));
            let (cones, part) = (self.cones_of_sheet(k, &part.sub_job(0.0, 0.5))?, part.sub_job(0.5, 1.0));
            each_sheet!(sheet, cells => {
                let search = SheetAngleSearch::new(self, k, cells, frame, goal);
                search.collect_candidates(cones, &ContourLattice::new(sheet), &mut best, &mut candidates, &part)
            })?;
        }
        let order = |candidate: &CandidateCell| (candidate.sheet, candidate.cell);
        sort::sort_stable(&mut candidates, &|a, b| {
            a.deviation_bound.total_cmp(&b.deviation_bound).then(order(a).cmp(&order(b)))
        });
        let (last, mut bound) = (job.sub_job(0.9, 1.0), f64::INFINITY);
        for (k, candidate) in candidates.iter().enumerate() {
            last.step_every(16, k, candidates.len(), "angles")?;
            if candidate.deviation_bound >= (best.deviation - ANGLE_TOLERANCE_RADIANS).max(0.0) {
                bound = bound.min(candidate.deviation_bound);
                break;
            }
            let (k, cell) = (candidate.sheet as usize, candidate.cell);
            bound = bound.min(match self.sheet(k) {
                Sheet::Grid(cells) => {
                    SheetAngleSearch::new(self, k, cells, frame, goal).search_cell::<6, 11>(cell, &mut best)
                }
                Sheet::Cubic(cells) => {
                    SheetAngleSearch::new(self, k, cells, frame, goal).search_cell::<6, 11>(cell, &mut best)
                }
                Sheet::High(cells) => {
                    SheetAngleSearch::new(self, k, cells, frame, goal).search_cell::<14, 27>(cell, &mut best)
                }
            });
        }
        Ok(best.place.map(|place| {
            let (point, normal) = self.point_and_normal(place);
            let projected_normals = frame.map(|axis| normal.dot(axis));
            let found = TargetAngle { angle: 0.0, unsigned }.angle_deviation(projected_normals, 0.0);
            let deviation = goal.angle_deviation(projected_normals, 0.0);
            NearestAngle {
                place,
                point,
                normal,
                angle: found,
                deviation,
                bound: bound.min(deviation).min(best.deviation),
            }
        }))
    }
}
