//! The constraints that make cells plane, and their linear equations. O(cells) each.

use super::elimination_order::visit_in_elimination_order;
use super::planarise_options::STAGE;
use super::scaled_vertices::ScaledVertices;
use crate::hidden_cells::HiddenCells;
use crate::{Net, Sides};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::{self, Buckets};
use gusset_base::sparse::SparseSymmetric;

/// Cells between two progress reports.
const CELLS_PER_REPORT: usize = 1 << 14;

/// The cells with four distinct corners, in the order of elimination.
pub(super) struct PlanarityConstraints {
    /// The vertices at the corners a, b, c, d of each cell.
    corners: Vec<[u32; 4]>,
    /// The indices of the cells in the net.
    cell_indices: Vec<u32>,
    /// For each vertex its cells, in order.
    cells: Buckets<u32>,
    /// True for vertices that stay.
    is_fixed_vertex: Vec<bool>,
}

/// A linearised constraint: its value, and its gradient, which is the normal times a weight at each
/// corner. All are divided by the length of the gradient.
#[derive(Clone, Copy, Default)]
pub(super) struct LinearisedConstraint {
    normal: DVec3,
    weights: [f64; 4],
    scaled_value: f64,
    /// The divisor; infinite if the gradient is 0.
    length: f64,
}

impl PlanarityConstraints {
    pub(super) fn new(net: &Net<'_>, surface: &ScaledVertices, job: &Job<'_>) -> Result<Self> {
        let (shape, hidden) = (net.shape(), HiddenCells::new(net)?);
        let (mut corners, mut numbers) = (Vec::new(), Vec::new());
        let is_glued = net.topology().sides() != Some(Sides::SHEET) || !net.topology().seams().is_empty();
        let mut done = 0;
        visit_in_elimination_order([shape.rows() - 1, shape.columns() - 1], is_glued, &mut |i, j| {
            job.step_every(CELLS_PER_REPORT, done, shape.cell_count(), STAGE)?;
            done += 1;
            let [a, b, c, d] = surface.classes.representatives_of_corners(i, j);
            let is_quad = a != b && a != c && a != d && b != c && b != d && c != d;
            if is_quad
                && !hidden.contains(i, j)
                && shape.corners_of_cell(i, j).into_iter().all(|n| net.position(n).is_finite())
            {
                alloc::push(&mut corners, [a, b, c, d])?;
                alloc::push(&mut numbers, (i * (shape.columns() - 1) + j) as u32)?;
            }
            Ok(())
        })?;
        let entries = corners.iter().zip(0u32..).flat_map(|(corners, k)| corners.map(|v| (v as usize, k)));
        let cells = Buckets::new_cancellable(shape.node_count(), 0, entries, job, STAGE)?;
        Ok(PlanarityConstraints {
            corners,
            cell_indices: numbers,
            cells,
            is_fixed_vertex: alloc::copied(&surface.is_fixed_vertex)?,
        })
    }

    /// Returns the vertices of the cells.
    pub(super) fn constrained_vertices(&self) -> impl Iterator<Item = usize> {
        (0..self.is_fixed_vertex.len()).filter(|&v| !self.cells.get(v).is_empty())
    }

    /// Returns the largest distance of the corners of a cell from its mean plane, and the index of
    /// the cell.
    pub(super) fn max_deviation(&self, positions: &[DVec3]) -> (f64, Option<u32>) {
        let mut worst = (0.0, self.cell_indices.first().copied());
        for (corners, &number) in self.corners.iter().zip(&self.cell_indices) {
            let [a, b, c, d] = corners.map(|v| positions[v as usize]);
            let normal = (c - a).cross(d - b).normalize_or_zero();
            let distance = ((a - b) + (c - d)).dot(normal).abs() / 4.0;
            if distance > worst.0 {
                worst = (distance, Some(number));
            }
        }
        worst
    }

    /// Linearises the constraints at some positions.
    ///
    /// The value is the signed distance between the lines through a, c and through b, d. To first
    /// order it changes by the displacement of the two lines' closest points along the common
    /// normal. At the points a + s (c - a) and b + t (d - b), the displacements of a, b, c and d
    /// have the factors -(1 - s), 1 - t, -s and t.
    pub(super) fn linearise(&self, positions: &[DVec3], job: &Job<'_>) -> Result<Vec<LinearisedConstraint>> {
        let rows = self.corners.iter().map(|corners| {
            let [a, b, c, d] = corners.map(|v| positions[v as usize]);
            let (p, q, r) = (c - a, d - b, b - a);
            let cross = p.cross(q);
            let (normal, square) = (cross.normalize_or_zero(), cross.length_squared());
            let (s, t) = (r.cross(q).dot(cross) / square, r.cross(p).dot(cross) / square);
            let weights = [s - 1.0, 1.0 - t, -s, t];
            let free = [0, 1, 2, 3].map(|k| if self.is_fixed_vertex[corners[k] as usize] { 0.0 } else { weights[k] });
            let length = free.iter().map(|w| w * w).sum::<f64>().sqrt();
            if !(length > 0.0 && length.is_finite()) {
                return LinearisedConstraint { length: f64::INFINITY, ..LinearisedConstraint::default() };
            }
            LinearisedConstraint {
                normal,
                weights: free.map(|w| w / length),
                scaled_value: r.dot(normal) / length,
                length,
            }
        });
        alloc::collect_cancellable(rows, job, STAGE)
    }

    /// Returns the sum of the squared constraints at other positions, each divided by the length of
    /// its row.
    pub(super) fn sum_of_squares(&self, rows: &[LinearisedConstraint], positions: &[DVec3]) -> f64 {
        let square = |(corners, row): (&[u32; 4], &LinearisedConstraint)| {
            let [a, b, c, d] = corners.map(|v| positions[v as usize]);
            ((b - a).dot((c - a).cross(d - b).normalize_or_zero()) / row.length).powi(2)
        };
        self.corners.iter().zip(rows).map(square).sum()
    }

    /// Returns the displacements -J^T y from `base`, where y solves (J J^T + penalty) y = g + J
    /// (base - positions).
    pub(super) fn displacements_from_base(
        &self,
        rows: &[LinearisedConstraint],
        [base, positions]: [&[DVec3]; 2],
        penalty: f64,
        job: &Job<'_>,
    ) -> Result<Vec<DVec3>> {
        let matrix = self.normal_matrix(rows, penalty, &job.sub_job(0.0, 0.2))?;
        let values = self.corners.iter().zip(rows).map(|(corners, row)| {
            let change =
                |k: usize| row.weights[k] * row.normal.dot(base[corners[k] as usize] - positions[corners[k] as usize]);
            DVec3::new(
                row.scaled_value + (0..4).map(|k| if row.weights[k] == 0.0 { 0.0 } else { change(k) }).sum::<f64>(),
                0.0,
                0.0,
            )
        });
        let mut solution = alloc::collect_cancellable(values, &job.sub_job(0.2, 0.2), STAGE)?;
        matrix.factorise(&job.sub_job(0.2, 0.9))?.solve(&mut solution, &job.sub_job(0.9, 0.95))?;
        drop(matrix);
        job.step(0.95, STAGE)?;
        let mut moved = alloc::copied(base)?;
        for (k, ((corners, row), y)) in self.corners.iter().zip(rows).zip(solution).enumerate() {
            job.sub_job(0.95, 1.0).step_every(CELLS_PER_REPORT, k, rows.len(), STAGE)?;
            for (&v, weight) in corners.iter().zip(row.weights).filter(|&(_, weight)| weight != 0.0) {
                moved[v as usize] -= weight * y.x * row.normal;
            }
        }
        Ok(moved)
    }

    /// J J^T + penalty: cells that share a vertex are coupled.
    fn normal_matrix(&self, rows: &[LinearisedConstraint], penalty: f64, job: &Job<'_>) -> Result<SparseSymmetric> {
        let n = rows.len();
        let (mut start, mut entries) = (alloc::with_capacity(n + 1)?, alloc::with_capacity(4 * n)?);
        start.push(0);
        let mut column: Vec<(u32, f64)> = Vec::new();
        for k in 0..n {
            job.step_every(CELLS_PER_REPORT, k, n, STAGE)?;
            column.clear();
            for (slot, &v) in self.corners[k].iter().enumerate().filter(|&(slot, _)| rows[k].weights[slot] != 0.0) {
                for &other in self.cells.get(v as usize).iter().take_while(|&&other| (other as usize) < k) {
                    let row = &rows[other as usize];
                    let place = self.corners[other as usize].iter().position(|&corner| corner == v).unwrap_or(0);
                    let value = rows[k].weights[slot] * row.weights[place] * rows[k].normal.dot(row.normal);
                    alloc::push(&mut column, (other, value))?;
                }
            }
            sort::sort_stable(&mut column, &|a: &(u32, f64), b| a.0.cmp(&b.0));
            for same in column.chunk_by(|a, b| a.0 == b.0) {
                alloc::push(&mut entries, (same[0].0, same.iter().map(|&(_, value)| value).sum()))?;
            }
            start.push(entries.len());
        }
        let diagonal = rows.iter().map(|row| if row.length.is_finite() { 1.0 + penalty } else { 0.0 });
        Ok(SparseSymmetric { column_starts: start, entries, diagonal: alloc::collect(diagonal)? })
    }
}
