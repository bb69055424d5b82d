//! An order of the unknowns that keeps the factor sparse: nested dissection.
//!
//! Source: A. George, *Nested dissection of a regular finite element mesh* (1973). A plane halves
//! the unknowns. The unknowns of one half that the equations couple with the other half form the
//! separator, which comes last. The remaining halves are no longer coupled, and are halved in turn.
//! The plane is perpendicular to the longest side of the bounding box. If its separator is too
//! long, the axis with the shortest separator is used instead, because cells may be elongated.
//!
//! On a surface, the factor of n unknowns has O(n log n) entries and costs O(n^1.5) operations. On
//! a strip, whose separators are short, both are linear up to the logarithm of its width.

use crate::alloc;
use crate::error::Result;
use crate::geom::Aabb;
use crate::job::Job;
use crate::sort::select_by_rank;
use glam::DVec3;

/// A separator is too long above this multiple of the separator of a square with the same number of
/// unknowns.
const MAX_SEPARATOR_LENGTH_RATIO: usize = 2;
/// Parts of at most this many unknowns are not halved.
const MAX_LEAF_UNKNOWNS: usize = 24;
/// Unknowns halved between two progress reports.
const UNKNOWNS_PER_REPORT: usize = 1 << 14;

/// Sorts the unknowns in `order` into the order of elimination. `couplings` tells which unknowns
/// share an equation. O(n log n); extra memory: 5 bytes a point.
pub fn order_by_nested_dissection(
    order: &mut [u32],
    points: &[DVec3],
    couplings: impl UnknownCouplings,
    job: &Job<'_>,
) -> Result<()> {
    let n = order.len();
    let stamp = alloc::filled(0u32, points.len())?;
    let whole = n * (n / MAX_LEAF_UNKNOWNS + 1).ilog2() as usize;
    NestedDissection {
        points,
        couplings,
        last_part_of_row: stamp,
        part_number: 0,
        job: *job,
        estimated_halved_unknowns: whole,
        halved_unknowns: 0,
        reported_unknowns: 0,
    }
    .halve_unknowns(order)
}

/// The couplings between unknowns. Two unknowns are coupled if a row of the equations has both.
pub trait UnknownCouplings {
    /// Visits the rows that have an entry of an unknown.
    fn for_each_row_with_unknown(&self, v: u32, visit: impl FnMut(usize));

    /// Returns the distance over which unknowns are coupled, in edges.
    fn coupling_reach(&self) -> usize;

    /// Returns true if an unknown is coupled with one that has an entry in a row accepted by
    /// `is_marked`.
    fn is_coupled_to_marked(&self, v: u32, is_marked: impl Fn(usize) -> bool) -> bool;
}

struct NestedDissection<'a, C> {
    points: &'a [DVec3],
    couplings: C,
    /// The last part whose first half touches the row of this vertex.
    last_part_of_row: Vec<u32>,
    part_number: u32,
    job: Job<'a>,
    /// The number of unknowns halved so far, counted once for each halving, and its estimated final
    /// value.
    halved_unknowns: usize,
    estimated_halved_unknowns: usize,
    reported_unknowns: usize,
}

impl<C: UnknownCouplings> NestedDissection<'_, C> {
    fn halve_unknowns(&mut self, order: &mut [u32]) -> Result<()> {
        if order.len() <= MAX_LEAF_UNKNOWNS {
            return Ok(());
        }
        self.halved_unknowns += order.len();
        if self.halved_unknowns >= self.reported_unknowns + UNKNOWNS_PER_REPORT {
            self.job.step(self.halved_unknowns as f64 / self.estimated_halved_unknowns as f64, "solving")?;
            self.reported_unknowns = self.halved_unknowns;
        }
        let size = Aabb::from_points(order.iter().map(|&v| self.points[v as usize])).size();
        let longest = size.max_position();
        let mut separator = self.cut_across_axis(order, longest);
        let most = MAX_SEPARATOR_LENGTH_RATIO * self.couplings.coupling_reach();
        if (order.len() - separator).pow(2) > most * most * order.len() {
            let mut best = (separator, longest);
            for axis in (0..3).filter(|&axis| axis != longest && size[axis] > 0.0) {
                separator = self.cut_across_axis(order, axis);
                if separator > best.0 {
                    best = (separator, axis);
                }
            }
            separator = self.cut_across_axis(order, best.1);
        }
        let (first, rest) = order.split_at_mut(order.len() / 2);
        let (second, _) = rest.split_at_mut(separator - first.len());
        self.halve_unknowns(first)?;
        self.halve_unknowns(second)
    }

    /// Halves the unknowns by a plane across an axis and moves the separator to the end. Returns
    /// the start of the separator.
    fn cut_across_axis(&mut self, order: &mut [u32], axis: usize) -> usize {
        let middle = order.len() / 2;
        let points = self.points;
        select_by_rank(order, middle, |v| points[v as usize][axis]);

        self.part_number += 1;
        let (stamp, part) = (&mut self.last_part_of_row, self.part_number);
        order[..middle].iter().for_each(|&v| self.couplings.for_each_row_with_unknown(v, |row| stamp[row] = part));
        let mut separator = order.len();
        let mut i = middle;
        while i < separator {
            if self.couplings.is_coupled_to_marked(order[i], |row| self.last_part_of_row[row] == self.part_number) {
                separator -= 1;
                order.swap(i, separator);
            } else {
                i += 1;
            }
        }
        separator
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A grid with the given number of columns, in which each unknown is coupled with its eight
    /// neighbours.
    struct GridCouplings(usize);

    impl UnknownCouplings for GridCouplings {
        fn for_each_row_with_unknown(&self, v: u32, mut visit: impl FnMut(usize)) {
            visit(v as usize);
        }

        fn coupling_reach(&self) -> usize {
            1
        }

        fn is_coupled_to_marked(&self, v: u32, found: impl Fn(usize) -> bool) -> bool {
            let (i, j) = (v as usize / self.0, v as usize % self.0);
            let beside = |k: usize, end: usize| k.saturating_sub(1)..end.min(k + 2);
            beside(i, GRID_ROWS).any(|i| beside(j, self.0).any(|j| found(i * self.0 + j)))
        }
    }

    const GRID_ROWS: usize = 12;

    #[test]
    fn separators_are_short_for_cells_of_any_shape() {
        for (columns, width) in [(60, 1.0), (60, 0.01), (1200, 1.0), (1200, 0.015), (1200, 0.005)] {
            let points: Vec<DVec3> = (0..GRID_ROWS * columns)
                .map(|v| DVec3::new((v % columns) as f64 * width, (v / columns) as f64, 0.0))
                .collect();
            let mut order: Vec<u32> = (0..points.len() as u32).collect();
            order_by_nested_dissection(&mut order, &points, GridCouplings(columns), &Job::default()).unwrap();
            // The separator is one column of the grid.
            let last = &order[order.len() - GRID_ROWS..];
            assert!(last.iter().all(|&v| v as usize % columns == last[0] as usize % columns), "{columns} {width}");
            order.sort_unstable();
            assert!((0..).zip(&order).all(|(k, &v)| k == v));
        }
    }
}
