//! Seams: runs of nodes glued to runs of nodes, for gluings that the characteristic matrix cannot
//! express. They extend Deryagin's model, like the 1-to-1 connectivity of CGNS (PointRange and
//! PointRangeDonor). A run takes O(1) memory for any length.

use crate::Shape;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

/// Pairs of seams between two reports.
const PAIRS_PER_REPORT: u64 = 1 << 18;

/// Nodes in a line: from (row, column) in equal steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SeamRun {
    /// Row of the first node.
    pub row: u32,
    /// Column of the first node.
    pub column: u32,
    /// Rows from each node to the next.
    pub row_step: i32,
    /// Columns from each node to the next.
    pub column_step: i32,
}

impl SeamRun {
    /// Returns a run that stays at node (i, j).
    pub fn stationary(i: usize, j: usize) -> Self {
        SeamRun::along_row(i as u32, j as u32, 0)
    }

    /// Returns a run along a row (step 1) or against it (step -1).
    pub fn along_row(row: u32, column: u32, step: i32) -> Self {
        SeamRun { row, column, row_step: 0, column_step: step }
    }

    /// Returns a run along a column (step 1) or against it (step -1).
    pub fn along_column(row: u32, column: u32, step: i32) -> Self {
        SeamRun { row, column, row_step: step, column_step: 0 }
    }

    /// Returns row and column of node `k`, which may lie outside the net.
    pub(crate) fn row_and_column_of_node(&self, k: u32) -> (i64, i64) {
        let k = i64::from(k);
        (i64::from(self.row) + k * i64::from(self.row_step), i64::from(self.column) + k * i64::from(self.column_step))
    }

    fn is_inside_net(&self, shape: Shape, count: u32) -> bool {
        [0, count - 1].into_iter().all(|k| {
            let (i, j) = self.row_and_column_of_node(k);
            (0..shape.rows() as i64).contains(&i) && (0..shape.columns() as i64).contains(&j)
        })
    }

    /// Rows and columns exchanged.
    pub(crate) fn transposed(self) -> Self {
        SeamRun { row: self.column, column: self.row, row_step: self.column_step, column_step: self.row_step }
    }

    /// Returns the first `count` nodes in reverse order.
    fn reversed(self, count: u32) -> Self {
        let (row, column) = self.row_and_column_of_node(count - 1);
        let (row_step, column_step) = (-self.row_step, -self.column_step);
        SeamRun { row: row as u32, column: column as u32, row_step, column_step }
    }

    /// Node `k`.
    pub(crate) fn node_index(&self, shape: Shape, k: u32) -> u32 {
        let (i, j) = self.row_and_column_of_node(k);
        shape.node(i as usize, j as usize)
    }
}

/// Glues node k of run `a` to node k of run `b`, for all k below `count`.
///
/// Seams are needed for closures that reverse a side (Möbius strip, Klein bottle, projective plane)
/// and for the cross unwrapping of the cube. They also express diagonals of cells (type c(1,2) of
/// the paper's Fig. 4) and closed nets within larger ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Seam {
    /// The first run.
    pub a: SeamRun,
    /// The second run.
    pub b: SeamRun,
    /// The number of nodes of each run; at least 1, and exactly 1 if neither run moves.
    pub count: u32,
}

impl Seam {
    /// Returns [`Error::BadSeam`] if the seam is empty, leaves the net or repeats one pair. `index`
    /// is the index of the seam. A valid seam has at most as many pairs as the net has rows or
    /// columns.
    pub(crate) fn check_in_net(&self, shape: Shape, index: usize) -> Result<()> {
        let moves = [self.a, self.b].iter().any(|run| (run.row_step, run.column_step) != (0, 0));
        let good = self.count > 0
            && (moves || self.count == 1)
            && self.a.is_inside_net(shape, self.count)
            && self.b.is_inside_net(shape, self.count);
        if good { Ok(()) } else { Err(Error::BadSeam { seam: index as u32 }) }
    }

    /// Calls `visit` for all of `seams`, with a progress report once in [`PAIRS_PER_REPORT`] pairs.
    pub(super) fn iter_with_reports(
        seams: &[Seam],
        job: &Job<'_>,
        stage: &'static str,
    ) -> impl Iterator<Item = Result<Seam>> {
        let mut pairs = 0;
        seams.iter().enumerate().map(move |(k, &seam)| {
            pairs += u64::from(seam.count);
            if pairs >= PAIRS_PER_REPORT {
                job.step(k as f64 / seams.len() as f64, stage)?;
                pairs = 0;
            }
            Ok(seam)
        })
    }

    /// Returns the smallest of the spellings of this seam: either run first, in either direction.
    pub(crate) fn canonical_spelling(self) -> Self {
        let Seam { mut a, mut b, count } = self;
        if count == 1 {
            (a.row_step, a.column_step, b.row_step, b.column_step) = (0, 0, 0, 0);
        }
        let spellings = Seam { a, b, count }.equivalent_spellings();
        spellings.into_iter().min().unwrap_or(self)
    }

    /// Returns the four spellings: unchanged, with the runs exchanged, and both in reverse.
    pub(crate) fn equivalent_spellings(self) -> [Self; 4] {
        let reversed = self.reversed();
        [self, self.with_runs_exchanged(), reversed, reversed.with_runs_exchanged()]
    }

    /// Returns the same pairs in reverse order.
    pub(crate) fn reversed(self) -> Self {
        Seam { a: self.a.reversed(self.count), b: self.b.reversed(self.count), count: self.count }
    }

    fn with_runs_exchanged(self) -> Self {
        Seam { a: self.b, b: self.a, count: self.count }
    }

    /// Returns the pairs `from..to`, a non-empty range.
    pub(super) fn seam_of_pair_range(self, from: u32, to: u32) -> Self {
        let at = |run: SeamRun| {
            let (row, column) = run.row_and_column_of_node(from);
            SeamRun { row: row as u32, column: column as u32, ..run }
        };
        Seam { a: at(self.a), b: at(self.b), count: to - from }
    }

    /// Returns the pairs of nodes.
    pub fn pairs(self, shape: Shape) -> impl ExactSizeIterator<Item = [u32; 2]> {
        (0..self.count).map(move |k| [self.a.node_index(shape, k), self.b.node_index(shape, k)])
    }
}
