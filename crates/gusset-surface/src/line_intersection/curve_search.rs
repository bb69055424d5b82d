//! The descent of the index for a curved segment.

use super::line_search::MAX_RELATIVE_LINE_ROUNDING;
use crate::Place;
use crate::cells::{SheetCells, cells_of_block};
use crate::index::BoxPyramid;
use crate::subdivision::{CrossingWorkspace, CurvePatchCrossings, find_crossings};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::bernstein::{evaluate, halves};

/// A common point, as found in one cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct CurvePointInCell {
    /// The sum of segment index and parameter, at the point and at both ends of the span.
    pub(super) curve_position: f64,
    pub(super) span: [f64; 2],
    /// The points of the curve at the ends of the span, and the distance between them.
    pub(super) span_end_points: [DVec3; 2],
    pub(super) distance_of_span_ends: f64,
    pub(super) place: Place,
    pub(super) point: DVec3,
    /// The distance between curve and surface at the point.
    pub(super) gap: f64,
    pub(super) tangent: bool,
    pub(super) runs_inside: bool,
    /// True for a contact that is resolved, for example at a crease.
    pub(super) is_touching: bool,
}

/// Memory that the cells of a segment reuse.
#[derive(Default)]
struct CurveSolverWorkspace<const M: usize, const N: usize> {
    workspace: CrossingWorkspace<M, N>,
    crossings: CurvePatchCrossings,
    /// Bound of the error of control points.
    rounding_error: f64,
}

/// A part of a segment.
#[derive(Clone)]
pub(super) struct CurveSegmentPart<const M: usize> {
    points: [DVec3; M],
    start_parameter: f64,
    parameter_length: f64,
}

impl<const M: usize> CurveSegmentPart<M> {
    /// The whole segment as a part.
    pub(super) fn whole_segment(points: [DVec3; M]) -> Self {
        CurveSegmentPart { points, start_parameter: 0.0, parameter_length: 1.0 }
    }

    fn bounding_box(&self) -> Aabb {
        Aabb::from_points(self.points)
    }
}

/// A part of a segment and a block of cells. `diagonal` is the diagonal of the block's box.
struct CurvePartBlockPair<const M: usize> {
    part: CurveSegmentPart<M>,
    diagonal: f64,
    level: usize,
    row: usize,
    column: usize,
}

/// Smallest size of a part. Even if the curve is 1e20 times as long as the surface, such parts are
/// short.
const MIN_HALVED_PART_SIZE: f64 = 1e-30;

/// The search in a sheet for a segment.
pub(super) struct CurveSheetSearch<'a, C, const M: usize, const N: usize> {
    pub(super) cells: &'a C,
    pub(super) index: &'a BoxPyramid,
    pub(super) sheet: u32,
    /// The index of the segment on the curve.
    pub(super) segment: usize,
    pub(super) tolerance: f64,
}

impl<C: SheetCells<N>, const M: usize, const N: usize> CurveSheetSearch<'_, C, M, N> {
    /// Adds the common points of the sheet and the segment.
    pub(super) fn find_common_points(
        &self,
        whole: &CurveSegmentPart<M>,
        finds: &mut Vec<CurvePointInCell>,
    ) -> Result<()> {
        let origin = self.index.origin();
        let part = CurveSegmentPart { points: whole.points.map(|point| point - origin), ..*whole };
        let (levels, bounds) = (self.index.levels(), self.index.bounding_box());
        let farthest = part.points.iter().map(|point| point.length()).fold(0.0, f64::max);
        let diagonal = bounds.diagonal();
        let rounding_error =
            (8.0 * f64::EPSILON * (bounds.max_vector_length() + farthest)).min(MAX_RELATIVE_LINE_ROUNDING * diagonal);
        let whole = Aabb { low: bounds.low - origin, high: bounds.high - origin }.grown_by(rounding_error);
        let mut waiting = vec![CurvePartBlockPair { part, diagonal, level: levels.len(), row: 0, column: 0 }];
        let mut solver = CurveSolverWorkspace { rounding_error, ..CurveSolverWorkspace::default() };
        while let Some(entry) = waiting.pop() {
            let CurvePartBlockPair { part, diagonal, level, row, column } = entry;
            let bounds = part.bounding_box().grown_by(rounding_error);
            if bounds.diagonal() > 2.0 * diagonal && part.parameter_length > MIN_HALVED_PART_SIZE {
                for (half, points) in halves(&part.points).into_iter().enumerate() {
                    let size = 0.5 * part.parameter_length;
                    let part = CurveSegmentPart {
                        points,
                        parameter_length: size,
                        start_parameter: part.start_parameter + half as f64 * size,
                    };
                    let near = if level == levels.len() {
                        part.bounding_box().overlaps(&whole)
                    } else {
                        self.may_part_touch_block(&part, rounding_error, level, row, column)
                    };
                    if near {
                        waiting.push(CurvePartBlockPair { part, diagonal, level, row, column });
                    }
                }
            } else if level == 0 {
                self.search_block(&part, [row, column], &mut solver, finds)?;
            } else {
                for child in 0..4 {
                    let (row, column) = (2 * row + child / 2, 2 * column + child % 2);
                    if self.may_part_touch_block(&part, rounding_error, level - 1, row, column) {
                        let diagonal = levels[level - 1].child_boxes(row / 2, column / 2).child_box(child).diagonal();
                        waiting.push(CurvePartBlockPair {
                            part: part.clone(),
                            diagonal,
                            level: level - 1,
                            row,
                            column,
                        });
                    }
                }
            }
        }
        Ok(())
    }

    /// False if the part misses the boxes of block (row, column) of a level.
    fn may_part_touch_block(
        &self,
        part: &CurveSegmentPart<M>,
        rounding_error: f64,
        level: usize,
        row: usize,
        column: usize,
    ) -> bool {
        let level = &self.index.levels()[level];
        let block = level.child_boxes(row / 2, column / 2).child_box(2 * (row % 2) + column % 2);
        !block.is_empty()
            && part.bounding_box().grown_by(rounding_error).overlaps(&block)
            && level.oriented_box(row, column).is_none_or(|oriented| oriented.may_meet_hull(&part.points))
    }

    /// Adds the common points in the cells of a block.
    fn search_block(
        &self,
        part: &CurveSegmentPart<M>,
        block: [usize; 2],
        solver: &mut CurveSolverWorkspace<M, N>,
        finds: &mut Vec<CurvePointInCell>,
    ) -> Result<()> {
        let deviation = self.index.distance_bound_from_bilinear_patches(block[0], block[1]) + solver.rounding_error;
        let along = part.bounding_box();
        for [i, j] in cells_of_block(block, self.cells.cell_counts()) {
            let corners = [(i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1)];
            let cell = Aabb::from_points(corners.map(|(i, j)| self.cells.corner_point(i, j) - self.index.origin()));
            if cell.grown_by(deviation).overlaps(&along) {
                self.search_cell(part, [i, j], solver, finds)?;
            }
        }
        Ok(())
    }

    /// Adds the common points in one cell.
    fn search_cell(
        &self,
        part: &CurveSegmentPart<M>,
        [i, j]: [usize; 2],
        solver: &mut CurveSolverWorkspace<M, N>,
        finds: &mut Vec<CurvePointInCell>,
    ) -> Result<()> {
        let origin = self.index.origin();
        let patch = self.cells.cell_patch(i, j);
        let mut local = patch;
        local.points.as_flattened_mut().iter_mut().for_each(|point| *point -= origin);
        let CurveSolverWorkspace { workspace, crossings: found, rounding_error } = solver;
        find_crossings(&part.points, &local, *rounding_error, self.tolerance, workspace, found)?;
        let along = |t: f64| self.segment as f64 + (part.start_parameter + part.parameter_length * t).clamp(0.0, 1.0);
        let simple = found.simple_crossings.iter().map(|crossing| {
            (crossing.curve_parameter, [crossing.curve_parameter; 2], crossing.patch_parameters, false)
        });
        let unresolved = found.unresolved.iter().map(|cluster| {
            let (at, span) = (cluster.best_box.middle, [cluster.low.x, cluster.high.x].map(|t| t.clamp(0.0, 1.0)));
            (at.x, span, DVec2::new(at.y, at.z), true)
        });
        for (t, span, at, tangent) in simple.chain(unresolved) {
            let ends = span.map(|t| evaluate(&part.points, t) + origin);
            let find = CurvePointInCell {
                curve_position: along(t),
                span: span.map(along),
                span_end_points: ends,
                distance_of_span_ends: ends[0].distance(ends[1]),
                place: Place { sheet: self.sheet, cell: [i as u32, j as u32], u: at.x, v: at.y },
                point: patch.point(at.x, at.y),
                gap: evaluate(&part.points, t).distance(local.point(at.x, at.y)),
                tangent,
                runs_inside: false,
                is_touching: false,
            };
            alloc::push(finds, find)?;
        }
        Ok(())
    }
}
