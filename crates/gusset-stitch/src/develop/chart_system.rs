//! The linear system of one chart: a sum of quadratic terms, one for each triangle, in the two
//! coordinates of each vertex.

use super::STAGE;
use super::chart::ChartMesh;
use glam::{DMat2, DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;
use gusset_base::sparse::{SparseSymmetric, UnknownCouplings, order_by_nested_dissection};

/// Number of vertices between two progress reports.
const VERTICES_PER_REPORT: usize = 1 << 16;

/// A symmetric matrix of 2 x 2 blocks for vertices and edges, and a right-hand side.
pub(super) struct ChartSystem {
    /// The place of each vertex in the order of elimination.
    elimination_position: Vec<u32>,
    /// For each place, the earlier places whose vertices are neighbours of its vertex.
    earlier_neighbours: Buckets<u32>,
    matrix: SparseSymmetric,
    right_side: Vec<DVec3>,
    /// True for vertices with a fixed position.
    is_fixed: Vec<bool>,
}

/// Couples each vertex with its neighbours.
struct NeighbourCoupling<'a>(&'a Buckets<u32>);

impl UnknownCouplings for NeighbourCoupling<'_> {
    fn for_each_row_with_unknown(&self, v: u32, mut visit: impl FnMut(usize)) {
        visit(v as usize);
    }

    fn coupling_reach(&self) -> usize {
        1
    }

    fn is_coupled_to_marked(&self, v: u32, found: impl Fn(usize) -> bool) -> bool {
        self.0.get(v as usize).iter().any(|&w| found(w as usize))
    }
}

impl ChartSystem {
    /// Builds the structure of the system. O(n log n) for n vertices; about 120 bytes per vertex.
    pub(super) fn new(chart: &ChartMesh, job: &Job<'_>) -> Result<ChartSystem> {
        let n = chart.points.len();
        // Each side occurs in both directions.
        let sides = (0..6 * chart.triangles.len()).map(|k| {
            let (triangle, i) = (chart.triangles[k / 6], k % 6 / 2);
            let [u, v] = [triangle[i], triangle[(i + 1) % 3]];
            if k % 2 == 0 { (u as usize, v) } else { (v as usize, u) }
        });
        job.step(0.0, STAGE)?;
        let neighbours = Buckets::new_cancellable(n, 0u32, sides, job, STAGE)?;
        job.step(0.1, STAGE)?;
        let mut order = alloc::collect(0..n as u32)?;
        order_by_nested_dissection(&mut order, &chart.points, NeighbourCoupling(&neighbours), &job.sub_job(0.1, 0.6))?;
        let mut place = alloc::filled(0, n)?;
        order.iter().zip(0..).for_each(|(&v, k)| place[v as usize] = k);
        let mut pairs = Vec::new();
        for (k, &v) in order.iter().enumerate() {
            job.sub_job(0.6, 0.8).step_every(VERTICES_PER_REPORT, k, n, STAGE)?;
            let first = pairs.len();
            let earlier = neighbours.get(v as usize).iter().map(|&w| place[w as usize]);
            alloc::extend(&mut pairs, earlier.filter(|&w| (w as usize) < k).map(|w| (k, w)))?;
            pairs[first..].sort_unstable();
        }
        job.step(0.8, STAGE)?;
        pairs.dedup();
        let earlier = Buckets::new_cancellable(n, 0u32, pairs.iter().copied(), &job.sub_job(0.8, 0.8), STAGE)?;
        job.step(0.8, STAGE)?;
        // Column 2 k has the rows of both coordinates of the earlier places; column 2 k + 1 has one
        // row more.
        let (mut start, mut entries) = (alloc::with_capacity(2 * n + 1)?, alloc::with_capacity(4 * pairs.len() + n)?);
        start.push(0);
        for k in 0..n {
            job.sub_job(0.8, 1.0).step_every(VERTICES_PER_REPORT, k, n, STAGE)?;
            for coordinate in 0..2 {
                let rows = earlier.get(k).iter().flat_map(|&w| [2 * w, 2 * w + 1]);
                entries.extend(rows.chain((coordinate == 1).then_some(2 * k as u32)).map(|row| (row, 0.0)));
                start.push(entries.len());
            }
        }
        job.step(1.0, STAGE)?;
        let matrix = SparseSymmetric { column_starts: start, entries, diagonal: alloc::filled(0.0, 2 * n)? };
        let right = alloc::filled(DVec3::ZERO, 2 * n)?;
        Ok(ChartSystem {
            elimination_position: place,
            earlier_neighbours: earlier,
            matrix,
            right_side: right,
            is_fixed: alloc::filled(false, n)?,
        })
    }

    pub(super) fn clear_equations(&mut self, job: &Job<'_>) -> Result<()> {
        let entries = &mut self.matrix.entries;
        job.work_in_ranges(STAGE, entries.len(), |range| {
            entries[range].iter_mut().for_each(|entry| entry.1 = 0.0);
            Ok(())
        })?;
        self.matrix.diagonal.fill(0.0);
        self.right_side.fill(DVec3::ZERO);
        self.is_fixed.fill(false);
        job.step(1.0, STAGE)
    }

    /// Fixes the position of a vertex. Must precede all additions.
    pub(super) fn fix_vertex(&mut self, v: u32) {
        self.is_fixed[v as usize] = true;
    }

    /// Adds a block to the matrix at (`u`, `v`), and its transpose at (`v`, `u`). `x` has the
    /// positions of fixed vertices.
    pub(super) fn add_block(&mut self, u: u32, v: u32, block: DMat2, x: &[DVec2]) {
        match [u, v].map(|v| self.is_fixed[v as usize]) {
            [true, true] => return,
            [true, false] => return self.add_right_hand_side(v, -(block.transpose() * x[u as usize])),
            [false, true] => return self.add_right_hand_side(u, -(block * x[v as usize])),
            [false, false] => {}
        }
        let [a, b] = [u, v].map(|v| self.elimination_position[v as usize]);
        let (low, high, block) = if a < b { (a, b, block) } else { (b, a, block.transpose()) };
        let Ok(slot) = self.earlier_neighbours.get(high as usize).binary_search(&low) else {
            return;
        };
        for (coordinate, column) in [block.x_axis, block.y_axis].into_iter().enumerate() {
            let first = self.matrix.column_starts[2 * high as usize + coordinate] + 2 * slot;
            self.matrix.entries[first].1 += column.x;
            self.matrix.entries[first + 1].1 += column.y;
        }
    }

    /// Adds a symmetric block at the diagonal.
    pub(super) fn add_diagonal_block(&mut self, v: u32, block: DMat2) {
        if self.is_fixed[v as usize] {
            return;
        }
        let k = 2 * self.elimination_position[v as usize] as usize;
        self.matrix.diagonal[k] += block.x_axis.x;
        self.matrix.diagonal[k + 1] += block.y_axis.y;
        // The last entry of its column.
        let end = self.matrix.column_starts[k + 2];
        self.matrix.entries[end - 1].1 += block.y_axis.x;
    }

    pub(super) fn add_right_hand_side(&mut self, v: u32, value: DVec2) {
        if !self.is_fixed[v as usize] {
            let k = 2 * self.elimination_position[v as usize] as usize;
            self.right_side[k].x += value.x;
            self.right_side[k + 1].x += value.y;
        }
    }

    /// Returns the solution. Fixed and undetermined vertices keep their `x`.
    pub(super) fn solve_positions(&mut self, x: &[DVec2], job: &Job<'_>) -> Result<Vec<DVec2>> {
        let factor = self.matrix.factorise(&job.sub_job(0.0, 0.8))?;
        factor.solve(&mut self.right_side, &job.sub_job(0.8, 1.0))?;
        let at = |(v, &old): (usize, &DVec2)| {
            let k = 2 * self.elimination_position[v] as usize;
            let found = DVec2::new(self.right_side[k].x, self.right_side[k + 1].x);
            if self.is_fixed[v] || !found.is_finite() { old } else { found }
        };
        alloc::collect(x.iter().enumerate().map(at))
    }
}
