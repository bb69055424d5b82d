//! Cells of a sheet as searches see them: corners, patches, and bounds of the surface between them.
//!
//! The displacements of a cell bound the distance of its patch from the bilinear patch through its
//! corners. Boxes of control vectors bound its tangents. Both bounds follow from the control net,
//! because a Bernstein polynomial is a convex combination of its coefficients.

use super::Patch;
use super::subdivision::BernsteinField;
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_base::{alloc, par};
use std::ops::Range;

/// Rows and columns of cells in a block, the unit of the index.
pub(crate) const CELLS_PER_BLOCK_SIDE: usize = 4;

/// The cells that belong to one block in a direction with `cell_count` cells.
#[inline(always)]
pub(crate) fn cell_range_of_block(block: usize, cell_count: usize) -> Range<usize> {
    block * CELLS_PER_BLOCK_SIDE..cell_count.min((block + 1) * CELLS_PER_BLOCK_SIDE)
}

/// The cells of a block in a sheet of `rows` x `columns` cells, row by row.
#[inline]
pub(crate) fn cells_of_block(
    [row, column]: [usize; 2],
    [rows, columns]: [usize; 2],
) -> impl Iterator<Item = [usize; 2]> {
    let columns = cell_range_of_block(column, columns);
    cell_range_of_block(row, rows).flat_map(move |i| columns.clone().map(move |j| [i, j]))
}

/// Number of values that a thread computes in one task.
const VALUES_PER_TASK: usize = 1 << 10;

/// Computes values for all cells on the job's threads, and returns them row by row. `work` fills
/// the values of one row.
pub(super) fn compute_cell_values_by_row<T: Send + Clone + Default>(
    [rows, columns]: [usize; 2],
    stage: &'static str,
    job: &Job<'_>,
    work: impl Fn(usize, &mut [T]) + Sync,
) -> Result<Vec<T>> {
    let mut values = alloc::filled(T::default(), rows * columns)?;
    let together = VALUES_PER_TASK.div_ceil(columns);
    par::map_cancellable(job, stage, values.chunks_mut(together * columns).enumerate(), |(k, part)| {
        part.chunks_mut(columns).enumerate().for_each(|(i, row)| work(k * together + i, row));
    })?;
    Ok(values)
}

/// Computes values like [`compute_cell_values_by_row`], cell by cell.
pub(super) fn compute_cell_values<T: Send + Clone + Default>(
    counts: [usize; 2],
    stage: &'static str,
    job: &Job<'_>,
    work: impl Fn([usize; 2]) -> T + Sync,
) -> Result<Vec<T>> {
    compute_cell_values_by_row(counts, stage, job, |i, row| {
        row.iter_mut().enumerate().for_each(|(j, value)| *value = work([i, j]));
    })
}

/// A sheet of patches of degree N - 1.
pub(crate) trait SheetCells<const N: usize>: Sync {
    /// The numbers of cells in u and in v.
    fn cell_counts(&self) -> [usize; 2];

    /// The corner of cells at (i, j), which is a point of the surface.
    fn corner_point(&self, i: usize, j: usize) -> DVec3;

    /// The corners along a row of `count` cells from (i, j) onwards. If the block has fewer than
    /// [`CELLS_PER_BLOCK_SIDE`] cells, the last corner repeats.
    #[inline(always)]
    fn corner_points_of_row(&self, i: usize, j: usize, count: usize) -> [[f64; 3]; CELLS_PER_BLOCK_SIDE + 1] {
        std::array::from_fn(|k| self.corner_point(i, j + k.min(count)).to_array())
    }

    /// The patch over the cell at (i, j).
    fn cell_patch(&self, i: usize, j: usize) -> Patch<N>;

    /// The coordinates of the patch over a cell along two directions, relative to `origin`.
    fn patch_coordinates_along(
        &self,
        i: usize,
        j: usize,
        origin: DVec3,
        directions: [DVec3; 2],
    ) -> [BernsteinField<N>; 2] {
        let patch = self.cell_patch(i, j);
        directions.map(|direction| BernsteinField {
            coefficients: patch.points.map(|row| row.map(|point| (point - origin).dot(direction))),
        })
    }

    /// True if tangents are continuous across all sides of the cell at (i, j).
    fn are_tangents_continuous_across_sides(&self, _i: usize, _j: usize) -> bool {
        false
    }

    /// Fills in a box for each block of some rows of blocks, row by row. A box contains S - B over
    /// all cells of its block, at equal parameters. S is the surface, and B the bilinear patch
    /// through the cell's corners.
    fn fill_displacement_boxes(&self, block_rows: Range<usize>, boxes: &mut [Aabb]) -> Result<()>;

    /// Fills in boxes that contain S_u and S_v over all cells of each block, except for rounding.
    fn fill_tangent_boxes(&self, block_rows: Range<usize>, boxes: &mut [[Aabb; 2]]) -> Result<()>;
}

impl<const N: usize> Patch<N> {
    /// A bound of the distance from the bilinear patch through the corners, at equal parameters.
    pub(crate) fn max_distance_from_bilinear_patch(&self) -> f64 {
        self.differences_from_bilinear().map(DVec3::length_squared).fold(0.0, f64::max).sqrt()
    }

    /// A box of the differences to the bilinear patch through the corners, at equal parameters.
    pub(crate) fn displacement_box(&self) -> Aabb {
        Aabb::from_points(self.differences_from_bilinear())
    }

    /// The control points of the difference to the bilinear patch through the corners, raised to
    /// the degree of the patch.
    #[inline]
    fn differences_from_bilinear(&self) -> impl Iterator<Item = DVec3> {
        let at = |k: usize| k as f64 / (N - 1) as f64;
        let [[p00, p01], [p10, p11]] = self.corner_points();
        self.points.iter().enumerate().flat_map(move |(a, row)| {
            let (from, to) = (p00.lerp(p10, at(a)), p01.lerp(p11, at(a)));
            row.iter().enumerate().map(move |(b, &point)| point - from.lerp(to, at(b)))
        })
    }

    /// Boxes of S_u and S_v, computed from their control vectors.
    pub(crate) fn tangent_boxes(&self) -> [Aabb; 2] {
        let (degree, p) = ((N - 1) as f64, &self.points);
        let [mut u, mut v] = [Aabb::EMPTY; 2];
        for (a, b) in (0..N - 1).flat_map(|a| (0..N).map(move |b| (a, b))) {
            u.add(degree * (p[a + 1][b] - p[a][b]));
            v.add(degree * (p[b][a + 1] - p[b][a]));
        }
        [u, v]
    }

    /// The corners, indexed by u and v.
    pub(crate) fn corner_points(&self) -> [[DVec3; 2]; 2] {
        let (first, last) = (&self.points[0], &self.points[N - 1]);
        [[first[0], first[N - 1]], [last[0], last[N - 1]]]
    }
}
