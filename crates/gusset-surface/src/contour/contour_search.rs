//! Finds the arcs of a sheet: block by block, cell by cell, level by level.
//!
//! Invariant: a cell is skipped only if its corners, with the deviation of the surface from the
//! bilinear one, exclude the level. Cost: O(1) for each cell examined, O(M^3) for each crossed cell
//! that is not simple; memory is proportional to the number of arcs.

use super::cell_arcs::{
    InnerMarkKeyGenerator, MarkedArc, SIDES_PER_CELL, SignChangeMark, find_cell_arcs, has_one_sign,
};
use super::contour_lattice::ContourLattice;
use super::contour_refinement::{insert_arc_points, is_arc_near_chord, is_graph_near_chord, middle_of_arc};
use super::contour_source::{ContourSource, CornerTestData, LevelsAndDataOfCell, SideContinuity};
use super::corner_crossing::{CornerCrossing, decide_crossing_by_corners, root_of_side_chord};
use super::side_roots::compute_side_roots;
use super::side_sign_changes::{counts_as_positive, find_sign_changes};
use crate::Patch;
use crate::cells::SheetCells;
use crate::subdivision::BernsteinField;
use glam::{DVec2, DVec3};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::{alloc, par};

/// Number of blocks that a thread searches in one task.
const BLOCKS_PER_TASK: usize = 16;
/// Number of blocks times levels that makes a short task.
const LEVEL_BLOCKS_PER_TASK: usize = 1024;
/// Number of tasks whose arcs are merged at once.
const TASKS_PER_MERGE: usize = 256;

/// An arc of a level's zero set over a cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct ContourArc {
    pub(super) level: u32,
    pub(super) cell: [u32; 2],
    /// The keys of the marks at its ends.
    pub(super) end_keys: [u64; 2],
    /// The places of the marks.
    pub(super) end_places: [DVec2; 2],
    /// The range of its inner places.
    pub(super) inner_range: [u32; 2],
    /// True if the next arc begins at another place than this one ends, across a side with
    /// discontinuous fields.
    pub(super) jumps: bool,
}

/// The arcs of a sheet.
#[derive(Debug, Default)]
pub(super) struct ContourArcs {
    pub(super) arcs: Vec<ContourArc>,
    pub(super) inner_places: Vec<DVec2>,
    /// Cells, and places in them, that are unresolved.
    pub(super) unresolved: Vec<([u32; 2], DVec2)>,
}

impl ContourArcs {
    fn append_arcs(&mut self, other: &ContourArcs) -> Result<()> {
        let shift = self.inner_places.len() as u32;
        alloc::append(&mut self.inner_places, &other.inner_places)?;
        alloc::append(&mut self.unresolved, &other.unresolved)?;
        let moved = |arc: &ContourArc| ContourArc { inner_range: arc.inner_range.map(|k| k + shift), ..*arc };
        alloc::extend(&mut self.arcs, other.arcs.iter().map(moved))
    }
}

/// The search of one sheet.
pub(super) struct ContourSearch<'a, C, S, const N: usize, const M: usize> {
    pub(super) cells: &'a C,
    pub(super) source: &'a S,
    pub(super) lattice: ContourLattice,
    /// Largest distance of chords from the curve. `None` means that only marks are computed.
    pub(super) chord: Option<f64>,
}

/// Memory that the work on cells reuses.
#[derive(Default)]
struct ContourCellWorkspace {
    marks: Vec<SignChangeMark>,
    links: Vec<MarkedArc>,
    /// Arcs of simple cells (arc, end, side) whose ends are still to be computed as roots of the
    /// polynomials along sides.
    pending_ends: Vec<(u32, u8, u8)>,
    side_polynomials: Vec<[f64; 4]>,
    roots: Vec<f64>,
}

impl ContourCellWorkspace {
    /// Computes the ends that are still open.
    fn solve_pending_arc_ends(&mut self, arcs: &mut [ContourArc]) {
        compute_side_roots(&self.side_polynomials, &mut self.roots);
        for (&(arc, end, side), &root) in self.pending_ends.iter().zip(&self.roots) {
            arcs[arc as usize].end_places[usize::from(end)] = place_on_side(usize::from(side), root);
        }
        self.pending_ends.clear();
        self.side_polynomials.clear();
        self.roots.clear();
    }
}

/// The place at parameter t on a side of a cell.
#[inline]
fn place_on_side(side: usize, t: f64) -> DVec2 {
    match side {
        0 => DVec2::new(t, 0.0),
        1 => DVec2::new(1.0, t),
        2 => DVec2::new(t, 1.0),
        _ => DVec2::new(0.0, t),
    }
}

/// One level in a cell.
struct LevelInCell<'a, const M: usize> {
    cell: [usize; 2],
    level: usize,
    field: &'a BernsteinField<M>,
    rounding_error: f64,
    /// Bound of the deviation of the field and the surface from bilinear ones.
    deviation: f64,
    /// Polynomials along the sides.
    side_polynomials: [[f64; M]; SIDES_PER_CELL],
    /// Whether the field counts as positive at the corners 2 u + v.
    corners: [bool; 4],
}

impl<C: SheetCells<N>, S: ContourSource<M>, const N: usize, const M: usize> ContourSearch<'_, C, S, N, M> {
    /// Finds the arcs in the blocks `block(k)` for k < `count`, given as (row, column).
    pub(super) fn find_arcs(
        &self,
        count: usize,
        block: impl Fn(usize) -> [u32; 2] + Sync,
        job: &Job<'_>,
    ) -> Result<ContourArcs> {
        let mut found = ContourArcs::default();
        for first in (0..count).step_by(BLOCKS_PER_TASK * TASKS_PER_MERGE) {
            let blocks = (count - first).min(BLOCKS_PER_TASK * TASKS_PER_MERGE);
            let part = job.sub_job(first as f64 / count as f64, (first + blocks) as f64 / count as f64);
            // With many levels, a single block takes long.
            let chunk = (LEVEL_BLOCKS_PER_TASK / self.source.level_count()).clamp(1, BLOCKS_PER_TASK);
            let parts = par::map_cancellable(&part, "contours", par::split_into_ranges(blocks, chunk), |range| {
                let mut part = ContourArcs::default();
                let (mut workspace, mut cache) = (ContourCellWorkspace::default(), S::BlockCache::default());
                for k in range {
                    self.search_block(block(first + k), &mut cache, &mut workspace, &mut part)?;
                }
                workspace.solve_pending_arc_ends(&mut part.arcs);
                Ok(part)
            });
            for part in parts? {
                let part: ContourArcs = part?;
                if found.arcs.is_empty() && found.unresolved.is_empty() {
                    found = part;
                } else {
                    found.append_arcs(&part)?;
                }
            }
        }
        Ok(found)
    }

    fn search_block(
        &self,
        block: [u32; 2],
        cache: &mut S::BlockCache,
        workspace: &mut ContourCellWorkspace,
        found: &mut ContourArcs,
    ) -> Result<()> {
        let [rows, columns] = self.lattice.cells_of_block(block);
        let Some(block) = self.source.prepare_block([rows.clone(), columns.clone()], cache) else { return Ok(()) };
        for cell in rows.flat_map(|i| columns.clone().map(move |j| [i, j])) {
            if !self.source.may_level_cross_cell(&block, cell)
                || self.add_arcs_by_corners(&block, cell, workspace, found)?
            {
                continue;
            }
            let LevelsAndDataOfCell { levels, rounding_error, shared_data: data } =
                self.source.prepare_cell(&block, cell, cache);
            let mut patch = None;
            for level in levels {
                let field =
                    snap_small_coefficients(self.source.field_with_zeros_at_level(&data, level), rounding_error);
                let [low, high] = field.coefficient_range();
                // Includes rounding: if sides agree only within rounding, the neighbour may have
                // marks on a side that this cell lacks.
                if low > rounding_error || high < -rounding_error {
                    continue;
                }
                if self.source.side_continuity() != SideContinuity::UpToRounding && has_one_sign(&field) {
                    if high - low <= rounding_error {
                        // Within rounding, the whole cell belongs to the zero set.
                        alloc::push(&mut found.unresolved, (cell.map(|k| k as u32), DVec2::splat(0.5)))?;
                    }
                    continue;
                }
                let (sides, corners) = match self.source.side_continuity() {
                    SideContinuity::UpToRounding => {
                        self.side_polynomials_from_owning_cells(&block, cell, &field, level, cache)
                    }
                    _ => side_polynomials_of_cell(&field),
                };
                let deviation = self.source.bilinear_deviation(&block);
                let cell_level = LevelInCell {
                    cell,
                    level,
                    field: &field,
                    rounding_error,
                    deviation,
                    side_polynomials: sides,
                    corners,
                };
                self.search_level_in_cell(&cell_level, &mut patch, workspace, found)?;
            }
        }
        Ok(())
    }

    /// Adds the arcs of a cell if it is simple for all levels, and no arc needs inner points.
    /// Otherwise returns false, and adds nothing.
    #[inline]
    fn add_arcs_by_corners(
        &self,
        block: &S::BlockData,
        cell: [usize; 2],
        workspace: &mut ContourCellWorkspace,
        found: &mut ContourArcs,
    ) -> Result<bool> {
        if self.chord.is_some_and(|chord| 4.0 * self.source.bilinear_deviation(block) > chord) {
            return Ok(false);
        }
        let Some(CornerTestData { levels, corners, bilinear_deviation: slack, rounding_error }) =
            self.source.corner_test_data(block, cell)
        else {
            return Ok(false);
        };
        let (arcs, open) = (found.arcs.len(), workspace.pending_ends.len());
        for level in levels {
            let values = corners.map(|x| x - self.source.value_of_level(level));
            let done = match decide_crossing_by_corners(values, slack, rounding_error) {
                Some(CornerCrossing::Misses) => continue,
                Some(CornerCrossing::Crosses { over, slope, .. })
                    if !self.is_graph_straight(block, cell, over, slope) =>
                {
                    false
                }
                Some(CornerCrossing::Crosses { sides, .. }) => {
                    self.add_crossing_arc(cell, level, sides, (values, rounding_error), workspace, found)?;
                    true
                }
                None => false,
            };
            if !done {
                found.arcs.truncate(arcs);
                workspace.pending_ends.truncate(open);
                workspace.side_polynomials.truncate(open);
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// True if an arc that is a graph over u (0) or v (1) in a cell needs no inner points. `slope`
    /// is a lower bound of the field's slope.
    #[inline]
    fn is_graph_straight(&self, block: &S::BlockData, cell: [usize; 2], over: usize, slope: f64) -> bool {
        let stays = |chord| {
            is_graph_near_chord(
                &self.cell_corner_points(cell),
                over,
                slope,
                self.source.bilinear_deviation(block),
                chord,
            )
        };
        self.chord.is_none_or(stays)
    }

    #[inline]
    fn cell_corner_points(&self, [i, j]: [usize; 2]) -> [DVec3; 4] {
        [(i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1)].map(|(i, j)| self.cells.corner_point(i, j))
    }

    /// Adds the arc from one side of a simple cell to another.
    #[inline]
    fn add_crossing_arc(
        &self,
        cell: [usize; 2],
        level: usize,
        sides: [usize; 2],
        (corners, rounding_error): ([f64; 4], f64),
        workspace: &mut ContourCellWorkspace,
        found: &mut ContourArcs,
    ) -> Result<()> {
        let arc = found.arcs.len() as u32;
        let inner = found.inner_places.len() as u32;
        let keys = sides.map(|side| (2 * self.lattice.side_index(cell, side)) << 6);
        // The end of an arc matters only if no arc follows, which happens at open edges.
        let ends = sides.map(|side| place_on_side(side, root_of_side_chord(corners, side)));
        for (end, side) in sides.into_iter().enumerate() {
            if end == 0 || self.lattice.is_cell_side_open(cell, side) {
                alloc::push(&mut workspace.pending_ends, (arc, end as u8, side as u8))?;
                let along = self.source.field_coefficients_on_side(cell, side, level);
                alloc::push(&mut workspace.side_polynomials, along.map(|x| snap_to_zero(x, rounding_error)))?;
            }
        }
        let cell = cell.map(|k| k as u32);
        alloc::push(
            &mut found.arcs,
            ContourArc {
                level: level as u32,
                cell,
                end_keys: keys,
                end_places: ends,
                inner_range: [inner; 2],
                jumps: false,
            },
        )
    }

    /// The polynomials along a cell's sides and the signs at its corners, as computed from the
    /// cells that own them.
    fn side_polynomials_from_owning_cells(
        &self,
        block: &S::BlockData,
        cell: [usize; 2],
        own: &BernsteinField<M>,
        level: usize,
        cache: &mut S::BlockCache,
    ) -> ([[f64; M]; SIDES_PER_CELL], [bool; 4]) {
        let ([low_v, mut high_u, mut high_v, low_u], mut corners) = side_polynomials_of_cell(own);
        for after in [[true, false], [false, true], [true, true]] {
            let (owner, ends) = self.lattice.owner_of_side_or_corner(cell, after);
            let field = if owner == cell {
                *own
            } else {
                let base = self.source.prepare_cell(block, owner, cache);
                snap_small_coefficients(
                    self.source.field_with_zeros_at_level(&base.shared_data, level),
                    base.rounding_error,
                )
            };
            let [a, b] = ends.map(|end| if end { M - 1 } else { 0 });
            corners[2 * usize::from(after[0]) + usize::from(after[1])] = counts_as_positive(field.coefficients[a][b]);
            match after {
                [true, false] => high_u = field.coefficients[a],
                [false, true] => high_v = field.coefficients.map(|row| row[b]),
                _ => {}
            }
        }
        ([low_v, high_u, high_v, low_u], corners)
    }

    /// Adds the arcs of one level in one cell.
    fn search_level_in_cell(
        &self,
        cell_level: &LevelInCell<'_, M>,
        patch: &mut Option<Patch<N>>,
        workspace: &mut ContourCellWorkspace,
        found: &mut ContourArcs,
    ) -> Result<()> {
        let LevelInCell { cell: at, level, field, rounding_error, deviation, corners, .. } = *cell_level;
        let ContourCellWorkspace { marks, links, .. } = workspace;
        links.clear();
        self.find_marks(cell_level, marks);
        let cell = at.map(|k| k as u32);
        let number = (at[0] * self.lattice.counts[1] + at[1]) as u64;
        let mut keys = InnerMarkKeyGenerator(1 << 63 | number << 24);
        if let Some(place) = find_cell_arcs(field, marks, corners, rounding_error, &mut keys, |link| links.push(link)) {
            alloc::push(&mut found.unresolved, (cell, place))?;
        }
        for link in links.iter() {
            let [from, to] = [link.start_mark.parameters, link.end_mark.parameters];
            // Places on the arc itself, because the midpoint of its ends may be far from it.
            let places = || [from, middle_of_arc(field, link, rounding_error).unwrap_or(from), to];
            let keeps = self.source.does_arc_belong_to_level(at, level, places);
            if keeps.is_none() {
                alloc::push(&mut found.unresolved, (cell, from))?;
            }
            if keeps != Some(true) {
                continue;
            }
            let first = found.inner_places.len() as u32;
            let straight = |chord: f64| {
                deviation < chord && is_arc_near_chord(&self.cell_corner_points(at), field, link, deviation, chord)
            };
            if let Some(chord) = self.chord.filter(|&chord| !straight(chord)) {
                let patch = patch.get_or_insert_with(|| self.cells.cell_patch(at[0], at[1]));
                if let Some(place) =
                    insert_arc_points(patch, field, link, chord, rounding_error, &mut found.inner_places)
                {
                    alloc::push(&mut found.unresolved, (cell, place))?;
                }
            }
            let (keys, inner) = ([link.start_mark.key, link.end_mark.key], [first, found.inner_places.len() as u32]);
            let arc = ContourArc {
                level: level as u32,
                cell,
                end_keys: keys,
                end_places: [from, to],
                inner_range: inner,
                jumps: false,
            };
            alloc::push(&mut found.arcs, arc)?;
        }
        Ok(())
    }

    /// Finds the marks of a level on the sides of a cell.
    fn find_marks(&self, cell_level: &LevelInCell<'_, M>, marks: &mut Vec<SignChangeMark>) {
        marks.clear();
        let jumps = self.source.side_continuity() == SideContinuity::Discontinuous;
        let [c00, c01, c10, c11] = cell_level.corners;
        let ends = [[c00, c10], [c10, c11], [c01, c11], [c00, c01]];
        for (side, (c, ends)) in cell_level.side_polynomials.iter().zip(ends).enumerate() {
            // Where fields are discontinuous, the two cells at a side have separate marks.
            let which = u64::from(jumps && (side == 1 || side == 2));
            let key = (2 * self.lattice.side_index(cell_level.cell, side) + which) << 6;
            let mut count = 0;
            find_sign_changes(c, ends, |crossing| {
                marks.push(SignChangeMark {
                    key: key | count,
                    parameters: place_on_side(side, crossing.side_parameter),
                    side,
                    rising: crossing.rising,
                });
                count += 1;
            });
        }
    }
}

/// Rounds values within the rounding error to 0. A piece that lies in a plane within rounding then
/// lies in it exactly, and produces no tiny curves. Equal coefficients remain equal.
#[inline]
fn snap_small_coefficients<const M: usize>(field: BernsteinField<M>, rounding_error: f64) -> BernsteinField<M> {
    BernsteinField { coefficients: field.coefficients.map(|row| row.map(|x| snap_to_zero(x, rounding_error))) }
}

#[inline]
fn snap_to_zero(x: f64, rounding_error: f64) -> f64 {
    if x.abs() <= rounding_error { 0.0 } else { x }
}

/// The polynomials along the sides and the signs at the corners, computed from the cell itself.
#[inline]
fn side_polynomials_of_cell<const M: usize>(field: &BernsteinField<M>) -> ([[f64; M]; SIDES_PER_CELL], [bool; 4]) {
    let c = &field.coefficients;
    let sides = [c.map(|row| row[0]), c[M - 1], c.map(|row| row[M - 1]), c[0]];
    (sides, [c[0][0], c[0][M - 1], c[M - 1][0], c[M - 1][M - 1]].map(counts_as_positive))
}
