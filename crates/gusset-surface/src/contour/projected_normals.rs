//! Normals of a sheet relative to a direction: ranges over cells at little cost.
//!
//! Cost: O(N^2) for a cell by its corners or its hodographs; roots as in
//! [`find_roots`].

use super::contour_lattice::ContourLattice;
use super::contour_source::SideContinuity;
use super::normal_fields::Hodographs;
use crate::Surface;
use crate::cells::{CELLS_PER_BLOCK_SIDE, SheetCells};
use crate::index::BoxPyramid;
use crate::ranges::cross_product_ranges;
use crate::subdivision::{FieldRoots, find_roots};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::Range;

/// Normals of a sheet relative to a direction.
pub(super) struct ProjectedNormals<'a, C, const N: usize> {
    pub(super) cells: &'a C,
    index: &'a BoxPyramid,
    /// Two perpendicular directions across the given one, then the given one.
    pub(super) frame: [DVec3; 3],
    /// The largest absolute coordinate.
    max_coordinate: f64,
    pub(super) continuity: SideContinuity,
}

/// The corners of a block's cells, in the frame.
pub(super) struct ProjectedBlockCorners {
    projected_corners: [[DVec3; CELLS_PER_BLOCK_SIDE + 1]; CELLS_PER_BLOCK_SIDE + 1],
    first_cell: [usize; 2],
    /// Bound of the difference between control vectors of S_u and S_v and the sides of the
    /// quadrilateral.
    slack: f64,
}

impl ProjectedBlockCorners {
    /// Ranges of the components of N over a cell.
    #[inline]
    pub(super) fn normal_component_ranges(&self, [i, j]: [usize; 2]) -> [[f64; 2]; 3] {
        let (r, c) = (i - self.first_cell[0], j - self.first_cell[1]);
        let [[p00, p01], [p10, p11]] = [
            [self.projected_corners[r][c], self.projected_corners[r][c + 1]],
            [self.projected_corners[r + 1][c], self.projected_corners[r + 1][c + 1]],
        ];
        let range = |a: DVec3, b: DVec3| {
            let (low, high) = (a.min(b) - self.slack, a.max(b) + self.slack);
            [0, 1, 2].map(|k| [low[k], high[k]])
        };
        cross_product_ranges(range(p10 - p00, p11 - p01), range(p01 - p00, p11 - p10))
    }
}

impl<'a, C: SheetCells<N>, const N: usize> ProjectedNormals<'a, C, N> {
    /// Creates the normals of sheet k of a surface, given its cells.
    pub(super) fn new(
        surface: &'a Surface<'_>,
        k: usize,
        cells: &'a C,
        frame: [DVec3; 3],
        continuity: SideContinuity,
    ) -> Self {
        let (index, max_coordinate) = (surface.sheet_and_index(k).1, surface.max_coordinate());
        ProjectedNormals { cells, index, frame, max_coordinate, continuity }
    }

    /// The corners of a block. They exclude most cells without computing their patches.
    ///
    /// Let c be the control points of the difference between surface and bilinear patch, and n the
    /// degree. S_u differs from a side of the quadrilateral, or a mean of two sides, by n |c_a+1 -
    /// c_a| <= 2 n max |c|. For patches, the index's deviation is max |c| itself. For grids, the
    /// deviation is 3/4 (L A + B). A control point may be off by L' A + B, where L' is the sum of
    /// the absolute values of its weights. L' is at most 1.42 L, so a control point is off by at
    /// most 2 deviations.
    pub(super) fn project_block_corners(&self, [rows, columns]: &[Range<usize>; 2]) -> ProjectedBlockCorners {
        let deviation = self.index.distance_bound_from_bilinear_patches(
            rows.start / CELLS_PER_BLOCK_SIDE,
            columns.start / CELLS_PER_BLOCK_SIDE,
        );
        let mut at = [[DVec3::ZERO; CELLS_PER_BLOCK_SIDE + 1]; CELLS_PER_BLOCK_SIDE + 1];
        let origin = self.index.origin();
        for (r, row) in at.iter_mut().enumerate().take(rows.len() + 1) {
            for (c, corner) in row.iter_mut().enumerate().take(columns.len() + 1) {
                let point = self.cells.corner_point(rows.start + r, columns.start + c) - origin;
                *corner = DVec3::from_array(self.frame.map(|axis| axis.dot(point)));
            }
        }
        let slack = 4.0 * (N - 1) as f64 * deviation + 16.0 * f64::EPSILON * self.max_coordinate;
        ProjectedBlockCorners { projected_corners: at, first_cell: [rows.start, columns.start], slack }
    }

    /// The corners of a block, and its cells, row by row.
    pub(super) fn block_corners_and_cells(
        &self,
        lattice: &ContourLattice,
        block: [u32; 2],
    ) -> (ProjectedBlockCorners, impl Iterator<Item = [usize; 2]> + use<C, N>) {
        let [rows, columns] = lattice.cells_of_block(block);
        let corners = self.project_block_corners(&[rows.clone(), columns.clone()]);
        (corners, rows.flat_map(move |i| columns.clone().map(move |j| [i, j])))
    }

    /// The control vectors of S_u and S_v over a cell.
    pub(super) fn hodographs(&self, [i, j]: [usize; 2]) -> Hodographs<N> {
        Hodographs::new(&self.cells.cell_patch(i, j), &self.frame)
    }

    /// Finds the places in a cell where both components across vanish, and the component along the
    /// direction has the given sign. Returns simple roots, and unresolved places that may be roots.
    pub(super) fn find_normals_along_axis<const H: usize>(
        &self,
        corners: &ProjectedBlockCorners,
        cell: [usize; 2],
        sign: f64,
    ) -> Result<[Vec<DVec2>; 2]> {
        let zero = |[low, high]: [f64; 2], rounding_error: f64| low <= rounding_error && high >= -rounding_error;
        let [x, y, _] = corners.normal_component_ranges(cell);
        if !(zero(x, 0.0) && zero(y, 0.0)) {
            return Ok([Vec::new(), Vec::new()]);
        }
        let of = self.hodographs(cell);
        let rounding_error = self.normal_rounding_error(&of);
        let [x, y, along] = of.normal_component_ranges();
        let right = if sign > 0.0 { along[1] >= -rounding_error } else { along[0] <= rounding_error };
        if !(zero(x, rounding_error) && zero(y, rounding_error) && right) {
            return Ok([Vec::new(), Vec::new()]);
        }
        let mut found = FieldRoots::default();
        find_roots(
            [of.normal_component::<H>(0), of.normal_component::<H>(1)],
            rounding_error,
            rounding_error,
            &mut found,
        )?;
        let along = |at: &DVec2| self.cells.cell_patch(cell[0], cell[1]).jet(at.x, at.y).normal().dot(self.frame[2]);
        found.simple_roots.retain(|at| along(at) * sign > 0.0);
        let unresolved = found.unresolved.iter().map(|cluster| cluster.best_box.middle.truncate());
        Ok([found.simple_roots, alloc::collect(unresolved)?])
    }

    /// Bound of the rounding error of components of normals.
    pub(super) fn normal_rounding_error(&self, hodographs: &Hodographs<N>) -> f64 {
        let [u, v] = hodographs.max_speeds();
        32.0 * f64::EPSILON * (self.max_coordinate * (u + v) + u * v)
    }
}

/// A right-handed frame whose third axis is `axis`.
pub(super) fn frame_with_third_axis(axis: DVec3) -> [DVec3; 3] {
    let first = axis.any_orthonormal_vector();
    [first, axis.cross(first), axis]
}
