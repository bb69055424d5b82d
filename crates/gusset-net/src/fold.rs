//! Detection of folds that a deformation has made in a net.
//!
//! A net is folded at a link if the two cells of the link lie on the same side of it in one plane.
//! It is folded in a cell if two opposite sides of the cell cross. Coplanarity, sides of a line and
//! crossings are affine invariants. Invariant: no invertible affine map folds anything, and bending
//! folds only if the dihedral angle vanishes within the tolerance and the rounding error of the
//! nodes.
//!
//! Union-find with parity then partitions the cells into two sides of the folds. O(nodes).

use super::hidden_cells::HiddenCells;
use super::{Net, NodeClasses, Real, Shape, XyzMatrices, each};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::ParitySets;
use gusset_base::job::Job;
use gusset_base::par;
use gusset_mesh::Scalar;

/// The result of a fold test at a link or a cell.
#[derive(Clone, Copy, PartialEq, Eq)]
enum FoldTestResult {
    Folded,
    Unfolded,
    /// The cell is smaller than the error, or missing.
    Undecided,
}

/// The approximate number of cells that a thread tests between progress reports.
const CELLS_PER_REPORT: usize = 1 << 14;
const STAGE: &str = "detecting folds";

/// The factor on error margins before the deformation: a near-fold that existed before does not
/// count.
const MARGIN_FACTOR_BEFORE_DEFORMATION: f64 = 8.0;

/// Returns the sign of each cell: -1 if it is turned over, otherwise 1. Empty if nothing is folded.
///
/// Folds divide each connected component of cells into two sides, and the smaller is turned over.
/// If they do not divide it, because a fold ends within the surface, the cells at the fold are
/// turned over.
pub(super) fn signs_of_turned_over_cells(
    before: &Net<'_>,
    after: &Net<'_>,
    tolerance: f64,
    job: &Job<'_>,
) -> Result<Vec<i8>> {
    let (shape, classes, hidden) = (before.shape(), NodeClasses::new(before.topology())?, HiddenCells::new(before)?);
    each!(before.coordinates(), old => each!(after.coordinates(), new => {
        let search = FoldSearch { shape, classes: &classes, hidden: &hidden, old_positions: old, new_positions: new, tolerance };
        let (lines, part) = ((CELLS_PER_REPORT / shape.columns()).max(1), job.sub_job(0.0, 0.5));
        let blocks = par::map_cancellable(&part, STAGE, par::split_into_ranges(shape.rows() - 1, lines), |mut rows| {
            rows.any(|i| search.has_fold_in_row(i))
        })?;
        if blocks.contains(&true) { search.cell_signs(&job.sub_job(0.5, 1.0)) } else { Ok(Vec::new()) }
    }))
}

/// Two adjacent cells and their common link.
type AdjacentCells = ([u32; 2], [(usize, usize); 2]);

struct FoldSearch<'a, A, B> {
    shape: Shape,
    classes: &'a NodeClasses,
    hidden: &'a HiddenCells,
    old_positions: &'a XyzMatrices<'a, A>,
    new_positions: &'a XyzMatrices<'a, B>,
    tolerance: f64,
}

impl<A: Real, B: Real> FoldSearch<'_, A, B> {
    fn has_fold_in_row(&self, i: usize) -> bool {
        (0..self.shape.columns() - 1).any(|j| {
            self.is_newly_crossed(i, j)
                || self.adjacent_cells(i, j).any(|pair| self.test_new_fold(pair) == FoldTestResult::Folded)
        })
    }

    /// Cell (i, j) with its neighbours to the east and south, also across a closed side.
    fn adjacent_cells(&self, i: usize, j: usize) -> impl Iterator<Item = AdjacentCells> + '_ {
        let shape = self.shape;
        let (east, south) = ((j + 1) % (shape.columns() - 1), (i + 1) % (shape.rows() - 1));
        let pairs = [
            ((i, east), [(i, j + 1), (i + 1, j + 1)], [(i, east), (i + 1, east)]),
            ((south, j), [(i + 1, j), (i + 1, j + 1)], [(south, j), (south, j + 1)]),
        ];
        let class = move |(i, j): (usize, usize)| self.classes.representative(shape.node(i, j));
        let is_visible = |(i, j): (usize, usize)| !self.hidden.contains(i, j);
        pairs
            .into_iter()
            .filter(move |&(next, link, same)| {
                next != (i, j) && link.map(class) == same.map(class) && is_visible((i, j)) && is_visible(next)
            })
            .map(move |(next, link, _)| ([shape.cell(i, j), shape.cell(next.0, next.1)], link))
    }

    /// Tests whether two cells are folded onto each other now and were not before.
    fn test_new_fold(&self, (cells, link): AdjacentCells) -> FoldTestResult {
        let cells = cells.map(|cell| self.shape.row_and_column_of_cell(cell));
        let before =
            || test_fold_at_link(self.old_positions, link, cells, self.tolerance, MARGIN_FACTOR_BEFORE_DEFORMATION);
        match test_fold_at_link(self.new_positions, link, cells, self.tolerance, 1.0) {
            FoldTestResult::Folded if before() != FoldTestResult::Unfolded => FoldTestResult::Unfolded,
            now => now,
        }
    }

    /// Returns true if opposite sides of cell (i, j) cross and did not before.
    fn is_newly_crossed(&self, i: usize, j: usize) -> bool {
        test_crossed_sides(self.new_positions, i, j, self.tolerance, 1.0) == FoldTestResult::Folded
            && test_crossed_sides(self.old_positions, i, j, self.tolerance, MARGIN_FACTOR_BEFORE_DEFORMATION)
                == FoldTestResult::Unfolded
            && !self.hidden.contains(i, j)
    }

    /// Returns for each cell 1 if it is oriented like the majority of its component, or -1 if it is
    /// folded over.
    fn cell_signs(&self, job: &Job<'_>) -> Result<Vec<i8>> {
        let count = self.shape.cell_count();
        let cells = || (0..count as u32).map(|cell| self.shape.row_and_column_of_cell(cell));
        let mut sets = ParitySets::new(count)?;
        let mut folded = Vec::new();
        let step = |cell: u32, from: f64| {
            job.sub_job(from, from + 0.4).step_every(CELLS_PER_REPORT, cell as usize, count, STAGE)
        };
        for pair in cells().flat_map(|(i, j)| self.adjacent_cells(i, j)) {
            let [a, b] = pair.0;
            step(a, 0.0)?;
            match self.test_new_fold(pair) {
                FoldTestResult::Folded => alloc::push(&mut folded, [a, b])?,
                FoldTestResult::Unfolded => _ = sets.union(a, b, false),
                FoldTestResult::Undecided => {}
            }
        }
        let mut at_ends = Vec::new();
        for [a, b] in folded {
            if !sets.union(a, b, true) {
                alloc::append(&mut at_ends, &[a, b])?;
            }
        }
        // A component is represented by its first cell, whose side is 1.
        let mut side = |cell: u32| {
            let (root, opposed) = sets.find(cell);
            (root as usize, if opposed { -1i8 } else { 1 })
        };
        let mut balance: Vec<i32> = alloc::zeroed(count)?;
        for cell in 0..count as u32 {
            let (component, sign) = side(cell);
            balance[component] += i32::from(sign);
        }
        let mut signs = alloc::collect((0..count as u32).map(|cell| {
            let (component, sign) = side(cell);
            if balance[component] < 0 { -sign } else { sign }
        }))?;
        at_ends.into_iter().for_each(|cell| signs[cell as usize] = -1);
        for ((sign, (i, j)), cell) in signs.iter_mut().zip(cells()).zip(0..) {
            step(cell, 0.6)?;
            *sign = if self.is_newly_crossed(i, j) { -1 } else { *sign };
        }
        Ok(signs)
    }
}

/// Returns the error bound of nodes: the tolerance and their rounding.
fn tolerance_plus_rounding<T: Real>(points: &[DVec3], tolerance: f64) -> f64 {
    let epsilon = if T::SCALAR == Scalar::F32 { f64::from(f32::EPSILON) } else { f64::EPSILON };
    let largest = points.iter().fold(0.0, |largest: f64, point| largest.max(point.abs().max_element()));
    tolerance + 8.0 * epsilon * largest
}

/// Differences of nodes and their error bound, scaled so that products neither overflow nor
/// underflow.
fn scale_to_largest<const N: usize>(vectors: [DVec3; N], error: f64) -> ([DVec3; N], f64) {
    let largest = vectors.iter().fold(0.0, |largest: f64, vector| largest.max(vector.abs().max_element()));
    (vectors.map(|vector| vector / largest), error / largest)
}

/// Tests two cells at a link: on the same side of it, in one plane.
fn test_fold_at_link<T: Real>(
    planes: &XyzMatrices<'_, T>,
    link: [(usize, usize); 2],
    cells: [(usize, usize); 2],
    tolerance: f64,
    margin: f64,
) -> FoldTestResult {
    let [p, q] = link.map(|(i, j)| planes.get(i, j));
    let cells = cells.map(|(i, j)| planes.cell_corners(i, j));
    let error = tolerance_plus_rounding::<T>(cells.as_flattened(), tolerance);
    // Twice the vectors from the link to the middle of the opposite sides.
    let [u, v] = cells.map(|[a, b, c, d]| (a - p) + (b - p) + (c - q) + (d - q));
    let ([along, u, v], error) = scale_to_largest([q - p, u, v], error);
    let [one, other] = [u, v].map(|away| along.cross(away));
    let is_wide = |area: DVec3, away: DVec3| area.length() > 2.0 * error * (along.length() + away.length());
    if !(is_wide(one, u) && is_wide(other, v)) {
        return FoldTestResult::Undecided;
    }
    // The error bound of the volume.
    let off = 2.0 * margin * error * (u.cross(v).length() + 2.0 * one.length() + 2.0 * other.length());
    if one.dot(other) > 0.0 && one.dot(v).abs() <= off { FoldTestResult::Folded } else { FoldTestResult::Unfolded }
}

/// Tests a cell: two opposite sides cross.
fn test_crossed_sides<T: Real>(
    planes: &XyzMatrices<'_, T>,
    i: usize,
    j: usize,
    tolerance: f64,
    margin: f64,
) -> FoldTestResult {
    let points @ [a, b, c, d] = planes.cell_corners(i, j);
    let error = tolerance_plus_rounding::<T>(&points, tolerance);
    let found =
        [test_crossing_segments([a, b], [d, c], error, margin), test_crossing_segments([a, d], [b, c], error, margin)];
    if found.contains(&FoldTestResult::Folded) {
        FoldTestResult::Folded
    } else if points.iter().all(|point| point.is_finite()) {
        FoldTestResult::Unfolded
    } else {
        FoldTestResult::Undecided
    }
}

/// Tests two segments, p q and r s: they cross between their ends, or miss each other
/// by less than the margin.
fn test_crossing_segments([p, q]: [DVec3; 2], [r, s]: [DVec3; 2], error: f64, margin: f64) -> FoldTestResult {
    let ([u, v, across], error) = scale_to_largest([q - p, s - r, r - p], error);
    let normal = u.cross(v);
    let (area, size) = (normal.length(), u.length() + v.length());
    let is_wide = area * margin > 2.0 * error * size;
    if !is_wide {
        return FoldTestResult::Undecided;
    }
    let unit = normal / area;
    // The parameters of the crossing, and their error bound.
    let [t, w] = [across.cross(v), across.cross(u)].map(|cross| cross.dot(unit) / area);
    let slack = 4.0 * error * size / area;
    let slack = if margin > 1.0 { -slack } else { slack };
    let is_between = |part: f64| part > slack && part < 1.0 - slack;
    let is_near = across.dot(unit).abs() <= 2.0 * margin * error * (1.0 + across.length() * size / area);
    if is_near && is_between(t) && is_between(w) { FoldTestResult::Folded } else { FoldTestResult::Unfolded }
}
