//! The descent of the index for a line.

use super::line::{Hit, HitSelection, Line};
use crate::cells::{CELLS_PER_BLOCK_SIDE, SheetCells};
use crate::index::{BoxPyramid, LineSlabTest, OrientedBox};
use crate::subdivision::{CrossingWorkspace, CurvePatchCrossings, FieldRoots, find_crossings, find_simple_roots};
use crate::{Patch, Place};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::aabb::range_of_values;
use gusset_base::geom::subdivision::UnresolvedCluster;

/// Memory that searches of patches of degree N - 1 reuse.
#[derive(Default)]
pub(super) struct PatchRootWorkspace<const N: usize> {
    roots: FieldRoots<N>,
    workspace: CrossingWorkspace<2, N>,
    crossings: CurvePatchCrossings,
}

/// Memory for sheets of all kinds, and the hits.
#[derive(Default)]
pub(super) struct LineWorkspace {
    pub(super) hits: Vec<Hit>,
    pub(super) cubic_roots: PatchRootWorkspace<4>,
    pub(super) degree_seven_roots: PatchRootWorkspace<8>,
}

/// Largest rounding error that is allowed for, relative to the surface's size. A larger one would
/// turn the whole surface into a hit. A line from farther away is replaced by the line through its
/// rounded foot.
pub(super) const MAX_RELATIVE_LINE_ROUNDING: f64 = 1e-6;

/// A line relative to a sheet, parametrised by the distance from its foot: the point nearest to the
/// index's origin.
struct LineFromFoot {
    line: Line,
    /// The foot, relative to the index's origin, and in space.
    foot_from_index_origin: DVec3,
    foot: DVec3,
    unit_direction: DVec3,
    direction_length: f64,
    /// Two perpendicular directions across the line.
    perpendicular_directions: [DVec3; 2],
    /// The parameter of the foot.
    foot_parameter: f64,
    /// Bound of the rounding error of the foot and the nodes.
    rounding_error: f64,
}

impl LineFromFoot {
    fn new(line: &Line, index: &BoxPyramid) -> LineFromFoot {
        let (along, length) = line.direction_and_length();
        let from = line.origin - index.origin();
        let distance = -from.dot(along);
        let local = from + distance * along;
        let (first, second) = along.any_orthonormal_pair();
        let bounds = index.bounding_box();
        LineFromFoot {
            line: *line,
            foot_from_index_origin: local,
            foot: local + index.origin(),
            unit_direction: along,
            direction_length: length,
            perpendicular_directions: [first, second],
            foot_parameter: distance / length,
            rounding_error: line_rounding_error(line, index.origin(), [bounds.low, bounds.high]),
        }
    }

    /// The distance from the foot at a parameter.
    fn distance_from_foot(&self, t: f64) -> f64 {
        (t - self.foot_parameter) * self.direction_length
    }

    /// The parameter of a point.
    fn parameter_of_point(&self, point: DVec3) -> f64 {
        (point - self.line.origin).dot(self.unit_direction) / self.direction_length
    }
}

/// Bound of the rounding error of points of a line, and of points in a box, relative to an origin.
pub(super) fn line_rounding_error(line: &Line, origin: DVec3, [low, high]: [DVec3; 2]) -> f64 {
    let extent = low.abs().max(high.abs()).length();
    let extent = extent + line.origin.distance(origin) + line.origin.length();
    (8.0 * f64::EPSILON * extent).min(MAX_RELATIVE_LINE_ROUNDING * low.distance(high))
}

/// A waiting block, and the distance at which the line enters it.
#[derive(Debug, Clone, Copy, Default)]
struct WaitingLineBlock {
    entry_distance: f64,
    level: u32,
    row: u32,
    column: u32,
}

/// Largest number of waiting entries: three for each level of a pyramid over 2^31 nodes, which has
/// at most 30 levels.
const MAX_WAITING_BLOCKS: usize = 3 * 30 + 4;

/// The search of one sheet.
pub(super) struct SheetLineSearch<'a> {
    pub(super) index: &'a BoxPyramid,
    pub(super) sheet: u32,
    pub(super) line: &'a Line,
    pub(super) selection: HitSelection,
    pub(super) tolerance: f64,
}

impl SheetLineSearch<'_> {
    /// Adds the hits of the sheet, whose cells are given. With [`HitSelection::All`], searches all
    /// cells. Otherwise, it searches as far as the first hit and hits that may be merged with it.
    pub(super) fn search_sheet<const N: usize>(
        &self,
        cells: &impl SheetCells<N>,
        solver: &mut PatchRootWorkspace<N>,
        hits: &mut Vec<Hit>,
    ) -> Result<()> {
        let SheetLineSearch { index, sheet, line, selection, tolerance } = *self;
        let ray = LineFromFoot::new(line, index);
        let slack = ray.rounding_error;
        let slab = LineSlabTest::new(ray.foot_from_index_origin, ray.unit_direction, slack);
        let (from, to) = (ray.distance_from_foot(line.from) - slack, ray.distance_from_foot(line.to) + slack);
        let mut leaf = LineBlockSearch { cells, index, sheet, ray: &ray, tolerance, solver };
        let levels = index.levels();
        let mut stack = [WaitingLineBlock::default(); MAX_WAITING_BLOCKS];
        let mut count = 1;
        stack[0] = WaitingLineBlock { entry_distance: from, level: levels.len() as u32, row: 0, column: 0 };
        let mut farthest = self.farthest_mergeable_distance(&ray, to, hits);
        while count > 0 {
            count -= 1;
            let WaitingLineBlock { entry_distance: enters, level, row, column } = stack[count];
            if enters > farthest {
                continue;
            }
            let (row, column) = (row as usize, column as usize);
            if level == 0 {
                let known = hits.len();
                leaf.search_block(row, column, hits)?;
                if hits.len() > known {
                    if selection == HitSelection::Any {
                        return Ok(());
                    }
                    farthest = self.farthest_mergeable_distance(&ray, farthest, &hits[known..]);
                }
                continue;
            }
            let level_below = &levels[level as usize - 1];
            let [near, far] = slab.entries_and_exits_of_boxes(level_below.child_boxes(row, column), from, farthest);
            let waiting = count;
            for child in 0..4 {
                let (row, column) = (2 * row + child / 2, 2 * column + child % 2);
                let misses =
                    |oriented: &OrientedBox| !oriented.may_meet_line(ray.foot_from_index_origin, ray.unit_direction);
                if near[child] > far[child] || level_below.oriented_box(row, column).is_some_and(misses) {
                    continue;
                }
                // Insertion sort: the nearest child is last, and taken first.
                let mut at = count;
                while at > waiting && stack[at - 1].entry_distance < near[child] {
                    stack[at] = stack[at - 1];
                    at -= 1;
                }
                stack[at] = WaitingLineBlock {
                    entry_distance: near[child],
                    level: level - 1,
                    row: row as u32,
                    column: column as u32,
                };
                count += 1;
            }
        }
        Ok(())
    }

    /// The distance along the ray beyond which nothing matters after some hits: beyond all hits
    /// that may be merged with the first one.
    fn farthest_mergeable_distance(&self, ray: &LineFromFoot, known: f64, hits: &[Hit]) -> f64 {
        if self.selection != HitSelection::First {
            return known;
        }
        let extent = 4.0 * self.tolerance + 1e4 * ray.rounding_error;
        hits.iter().map(|hit| ray.distance_from_foot(hit.at) + extent).fold(known, f64::min)
    }
}

/// The search of a block.
struct LineBlockSearch<'a, C, const N: usize> {
    cells: &'a C,
    index: &'a BoxPyramid,
    sheet: u32,
    ray: &'a LineFromFoot,
    tolerance: f64,
    solver: &'a mut PatchRootWorkspace<N>,
}

impl<C: SheetCells<N>, const N: usize> LineBlockSearch<'_, C, N> {
    fn search_block(&mut self, row: usize, column: usize, hits: &mut Vec<Hit>) -> Result<()> {
        let [rows, columns] = self.cells.cell_counts();
        let (first, last) = (row * CELLS_PER_BLOCK_SIDE, rows.min((row + 1) * CELLS_PER_BLOCK_SIDE));
        let (left, right) = (column * CELLS_PER_BLOCK_SIDE, columns.min((column + 1) * CELLS_PER_BLOCK_SIDE));
        let deviation = self.index.distance_bound_from_bilinear_patches(row, column) + self.ray.rounding_error;
        let mut corners = [[DVec2::ZERO; CELLS_PER_BLOCK_SIDE + 1]; CELLS_PER_BLOCK_SIDE + 1];
        for i in first..=last {
            for j in left..=right {
                let from = self.cells.corner_point(i, j) - self.ray.foot;
                corners[i - first][j - left] = DVec2::new(
                    from.dot(self.ray.perpendicular_directions[0]),
                    from.dot(self.ray.perpendicular_directions[1]),
                );
            }
        }
        for (r, i) in (first..last).enumerate() {
            for (c, j) in (left..right).enumerate() {
                let quad = [corners[r][c], corners[r][c + 1], corners[r + 1][c + 1], corners[r + 1][c]];
                if may_hull_reach_origin(&quad, deviation) {
                    self.search_cell(i, j, hits)?;
                }
            }
        }
        Ok(())
    }

    fn search_cell(&mut self, i: usize, j: usize, hits: &mut Vec<Hit>) -> Result<()> {
        let fields = self.cells.patch_coordinates_along(i, j, self.ray.foot, self.ray.perpendicular_directions);
        if !find_simple_roots(fields, self.ray.rounding_error, self.tolerance, &mut self.solver.roots) {
            return self.search_line_part_as_curve(i, j, hits);
        }
        let roots = &self.solver.roots.simple_roots;
        if roots.is_empty() {
            return Ok(());
        }
        let patch = self.cells.cell_patch(i, j);
        roots.iter().try_for_each(|&root| self.add_hit(&patch, [i, j], root, None, hits))
    }

    /// Searches a cell in which the fields do not decide: treats the part of the line in the cell's
    /// box as a curve.
    fn search_line_part_as_curve(&mut self, i: usize, j: usize, hits: &mut Vec<Hit>) -> Result<()> {
        let patch = self.cells.cell_patch(i, j);
        let Some(segment) = self.segment_beside_patch(&patch) else { return Ok(()) };
        let [start, end] = segment;
        let found = &mut self.solver.crossings;
        find_crossings(&segment, &patch, self.ray.rounding_error, self.tolerance, &mut self.solver.workspace, found)?;
        for crossing in &self.solver.crossings.simple_crossings {
            self.add_hit(&patch, [i, j], crossing.patch_parameters, None, hits)?;
        }
        for &UnresolvedCluster { best_box: best, low, high } in &self.solver.crossings.unresolved {
            let span = [low.x, high.x].map(|at| self.ray.parameter_of_point(start.lerp(end, at.clamp(0.0, 1.0))));
            self.add_hit(&patch, [i, j], DVec2::new(best.middle.y, best.middle.z), Some(span), hits)?;
        }
        Ok(())
    }

    /// The part of the line beside the patch: both have the same extent along the line.
    fn segment_beside_patch(&self, patch: &Patch<N>) -> Option<[DVec3; 2]> {
        let ray = self.ray;
        let along = patch.points.as_flattened().iter().map(|&point| (point - ray.foot).dot(ray.unit_direction));
        let [low, high] = range_of_values(along);
        let slack = ray.rounding_error + self.tolerance;
        let from = (low - slack).max(ray.distance_from_foot(ray.line.from) - ray.rounding_error);
        let to = (high + slack).min(ray.distance_from_foot(ray.line.to) + ray.rounding_error);
        (from <= to).then(|| [ray.foot + from * ray.unit_direction, ray.foot + to * ray.unit_direction])
    }

    /// Adds a hit, if its parameter is within the line's range.
    fn add_hit(
        &self,
        patch: &Patch<N>,
        [i, j]: [usize; 2],
        at: DVec2,
        span: Option<[f64; 2]>,
        hits: &mut Vec<Hit>,
    ) -> Result<()> {
        let (ray, jet) = (self.ray, patch.jet(at.x, at.y));
        let t = ray.parameter_of_point(jet.point);
        let slack = ray.rounding_error / ray.direction_length;
        if t < ray.line.from - slack || t > ray.line.to + slack {
            return Ok(());
        }
        let t = t.clamp(ray.line.from, ray.line.to);
        let place = Place { sheet: self.sheet, cell: [i as u32, j as u32], u: at.x, v: at.y };
        // A root that is not on the line is unresolved. This happens in cells a million times as
        // long as wide.
        let miss = (jet.point - ray.foot).reject_from_normalized(ray.unit_direction).length();
        let is_off = miss > self.tolerance.max(4.0 * ray.rounding_error);
        let span = span.or_else(|| is_off.then(|| [t - miss / ray.direction_length, t + miss / ray.direction_length]));
        let tangent = span.is_some();
        let hit = Hit {
            at: t,
            // The nearest place may be beyond the span by the tolerance.
            span: span
                .map_or([t; 2], |[low, high]| [low.min(t), high.max(t)].map(|t| t.clamp(ray.line.from, ray.line.to))),
            place,
            point: jet.point,
            // Where the patch is not regular, the sheet provides the limit later.
            normal: jet.unit_normal_if_regular(patch.derivative_noise()).unwrap_or(DVec3::ZERO),
            tangent,
            multiplicity: if tangent { 2 } else { 1 },
        };
        alloc::push(hits, hit)
    }
}

/// False if a line through two of four points proves that the origin is farther than `distance`
/// from their hull.
#[inline(always)]
fn may_hull_reach_origin(quad: &[DVec2; 4], distance: f64) -> bool {
    let [a, b, c, d] = *quad;
    let (low, high) = (a.min(b).min(c.min(d)), a.max(b).max(c.max(d)));
    if low.x > distance || low.y > distance || high.x < -distance || high.y < -distance {
        return false;
    }
    // The signed distances to the left of the side from a to b, scaled by its length, of the origin
    // and the other corners.
    let separated = |a: DVec2, b: DVec2, c: DVec2, d: DVec2| {
        let side = b - a;
        let (origin, c, d) = (-side.perp_dot(a), side.perp_dot(c - a), side.perp_dot(d - a));
        let (low, high) = (c.min(d).min(0.0), c.max(d).max(0.0));
        let outside = (low - origin).max(origin - high);
        outside > 0.0 && outside * outside > distance * distance * side.length_squared()
    };
    !(separated(a, b, c, d) || separated(b, c, d, a) || separated(c, d, a, b) || separated(d, a, b, c))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Quadrilaterals in projection along the line, just within the bound and just beyond it.
    #[test]
    fn quadrilateral_test_is_sharp_at_the_bound() {
        let mut random = fastrand::Rng::with_seed(7);
        for _ in 0..10_000 {
            let by = 0.01 + random.f64();
            let corner = |k: u32, size: f64| size * DVec2::from_angle(std::f64::consts::FRAC_PI_2 * f64::from(k));
            let shape = [0, 1, 2, 3].map(|k| corner(k, 0.1 + random.f64()));
            let (from, to) = (shape[0], shape[1]);
            let out = -(to - from).normalize().perp();
            let near = from.lerp(to, random.f64());
            for (share, expected) in [(1.0 - 1e-9, true), (1.0 + 1e-9, false)] {
                let quad = shape.map(|corner| corner - near - share * by * out);
                assert_eq!(may_hull_reach_origin(&quad, by), expected, "{quad:?} {by}");
            }
        }
    }
}
