//! The elimination tree of a sparse symmetric matrix, and the number of entries in each column of
//! its factor.
//!
//! The parent of column i is the first row below i in which the factor L has an entry. The other
//! rows of column i are among the parent's. Sources: J. W. H. Liu, *The role of elimination trees
//! in sparse factorization* (1990); J. R. Gilbert, E. G. Ng, B. W. Peyton, *An efficient algorithm
//! to compute row and column counts for sparse Cholesky factorization* (1994), in the form of T. A.
//! Davis, *Direct methods for sparse linear systems* (2006), section 4.4. Nearly linear in the
//! entries of the matrix.

use super::symmetric::SparseSymmetric;
use crate::NONE;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::sort::Buckets;

/// Columns between two progress reports.
const COLUMNS_PER_REPORT: usize = 1 << 15;

/// Returns the parents of all columns; `NONE` for a root.
pub(super) fn elimination_tree_parents(matrix: &SparseSymmetric, job: &Job<'_>) -> Result<Vec<u32>> {
    let n = matrix.row_count();
    let mut parent = alloc::filled(NONE, n)?;
    // The farthest known ancestor of each column, so that paths are walked once.
    let mut ancestor = alloc::filled(NONE, n)?;
    for k in 0..n {
        job.step_every(COLUMNS_PER_REPORT, k + 1, n, "solving")?;
        for &(row, _) in matrix.entries_above_diagonal(k) {
            let mut i = row;
            while i != NONE && i < k as u32 {
                let next = std::mem::replace(&mut ancestor[i as usize], k as u32);
                if next == NONE {
                    parent[i as usize] = k as u32;
                }
                i = next;
            }
        }
    }
    Ok(parent)
}

/// Returns the nodes of a forest in postorder: children before parents, subtree after subtree.
pub(super) fn forest_postorder(parent: &[u32], job: &Job<'_>) -> Result<Vec<u32>> {
    let n = parent.len();
    let (mut first_child, mut next_sibling) = (alloc::filled(NONE, n + 1)?, alloc::filled(NONE, n)?);
    let slot = |parent: u32| if parent == NONE { n } else { parent as usize };
    for k in (0..n).rev() {
        next_sibling[k] = std::mem::replace(&mut first_child[slot(parent[k])], k as u32);
    }
    let (mut order, mut open) = (alloc::with_capacity(n)?, alloc::with_capacity(n)?);
    let mut down = first_child[n];
    loop {
        job.step_within_list(order.len(), "solving")?;
        while down != NONE {
            open.push(down);
            down = first_child[down as usize];
        }
        let Some(node) = open.pop() else {
            return Ok(order);
        };
        order.push(node);
        down = next_sibling[node as usize];
    }
}

/// Returns the number of entries in each column of the factor, including the diagonal. `below` has
/// the matrix's entries below the diagonal, column by column.
///
/// The columns of row i of L form a subtree with root i, and the matrix has an entry of row i in
/// every leaf. Each leaf counts for itself and its ancestors. Where it meets the previous leaf, in
/// their least common ancestor, one count is removed.
pub(super) fn factor_column_counts(below: &Buckets<(u32, f64)>, parent: &[u32], job: &Job<'_>) -> Result<Vec<u32>> {
    let n = parent.len();
    let order = forest_postorder(parent, &job.sub_job(0.0, 0.0))?;
    job.step(0.0, "solving")?;
    // The position in postorder of each column's first descendant.
    let mut first = alloc::filled(NONE, n)?;
    let mut count = alloc::filled(0i64, n)?;
    for (place, &leaf) in order.iter().enumerate() {
        job.step_within_list(place, "solving")?;
        if first[leaf as usize] == NONE {
            count[leaf as usize] = 1;
        }
        let mut i = leaf;
        while i != NONE && first[i as usize] == NONE {
            first[i as usize] = place as u32;
            i = parent[i as usize];
        }
    }
    let mut subtrees = RowSubtreeLeaves {
        latest_first_descendant: alloc::filled(0, n)?,
        latest_leaf: alloc::filled(NONE, n)?,
        ancestor: alloc::collect(0..n as u32)?,
    };
    for (place, &j) in order.iter().enumerate() {
        job.step_every(COLUMNS_PER_REPORT, place + 1, n, "solving")?;
        let up = parent[j as usize];
        if up != NONE {
            count[up as usize] -= 1;
        }
        for &(i, _) in below.get(j as usize) {
            if let Some(meeting) = subtrees.add_column_to_row(i as usize, j, first[j as usize]) {
                count[j as usize] += 1;
                if meeting != NONE {
                    count[meeting as usize] -= 1;
                }
            }
        }
        if up != NONE {
            subtrees.ancestor[j as usize] = up;
        }
    }
    for &j in &order {
        let own = count[j as usize];
        if let Some(up) = count.get_mut(parent[j as usize] as usize) {
            *up += own;
        }
    }
    alloc::collect(count.into_iter().map(|count| count as u32))
}

/// The subtrees of all rows. Their columns arrive in postorder.
struct RowSubtreeLeaves {
    /// For each row, 1 plus the largest postorder number of a first descendant among the row's
    /// columns so far; 0 before the first column.
    latest_first_descendant: Vec<u32>,
    latest_leaf: Vec<u32>,
    /// A link towards the root of the visited columns.
    ancestor: Vec<u32>,
}

impl RowSubtreeLeaves {
    /// Adds column `j` to row `i`; `first` is the position of its first descendant. Returns `None`
    /// if the column is not a leaf of the row's subtree. Otherwise returns the least common
    /// ancestor with the previous leaf, `NONE` for the first leaf.
    fn add_column_to_row(&mut self, i: usize, j: u32, first: u32) -> Option<u32> {
        if first < self.latest_first_descendant[i] {
            return None;
        }
        self.latest_first_descendant[i] = first + 1;
        let before = std::mem::replace(&mut self.latest_leaf[i], j);
        if before == NONE {
            return Some(NONE);
        }
        let mut root = before;
        while self.ancestor[root as usize] != root {
            root = self.ancestor[root as usize];
        }
        let mut node = before;
        while node != root {
            node = std::mem::replace(&mut self.ancestor[node as usize], root);
        }
        Some(root)
    }
}
