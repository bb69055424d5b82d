//! The elimination tree of a sparse symmetric matrix, and how many entries each column of its
//! factor has.
//!
//! The parent of column i is the first row below i in which the factor L has an entry; the rows of
//! column i beyond are among the parent's. Sources: J. W. H. Liu, *The role of elimination trees in
//! sparse factorization* (1990); J. R. Gilbert, E. G. Ng, B. W. Peyton, *An efficient algorithm to
//! compute row and column counts for sparse Cholesky factorization* (1994), in the form of T. A.
//! Davis, *Direct methods for sparse linear systems* (2006), section 4.4. Nearly linear in the
//! entries of the matrix.

use super::symmetric::Symmetric;
use crate::NONE;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::sort::Buckets;

/// Columns between two progress reports.
const REPORT_INTERVAL: usize = 1 << 15;

/// The parents of all columns; `NONE` of a root.
pub(super) fn parents(matrix: &Symmetric, job: &Job<'_>) -> Result<Vec<u32>> {
    let n = matrix.row_count();
    let mut parent = alloc::filled(NONE, n)?;
    // The farthest ancestor known: paths are walked once.
    let mut ancestor = alloc::filled(NONE, n)?;
    for k in 0..n {
        job.step_every(REPORT_INTERVAL, k + 1, n, "solving")?;
        for &(row, _) in matrix.column(k) {
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

/// The nodes of a forest, children before their parents and subtree after subtree.
pub(super) fn postorder(parent: &[u32], job: &Job<'_>) -> Result<Vec<u32>> {
    let n = parent.len();
    let (mut first_child, mut next_sibling) = (alloc::filled(NONE, n + 1)?, alloc::filled(NONE, n)?);
    let slot = |parent: u32| if parent == NONE { n } else { parent as usize };
    for k in (0..n).rev() {
        next_sibling[k] = std::mem::replace(&mut first_child[slot(parent[k])], k as u32);
    }
    let (mut order, mut open) = (alloc::with_capacity(n)?, alloc::with_capacity(n)?);
    let mut down = first_child[n];
    loop {
        job.step_within(order.len(), "solving")?;
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

/// The number of entries in each column of the factor, that on the diagonal included. `below`: the
/// matrix below its diagonal, column by column.
///
/// Row i of L has the columns of a subtree with root i, whose leaves are columns in which the
/// matrix itself has an entry. Each leaf counts for itself and its ancestors; where it meets the
/// leaf before it, in their least common ancestor, one too many have been counted.
pub(super) fn column_counts(below: &Buckets<(u32, f64)>, parent: &[u32], job: &Job<'_>) -> Result<Vec<u32>> {
    let n = parent.len();
    let order = postorder(parent, &job.part(0.0, 0.0))?;
    job.step(0.0, "solving")?;
    // The place in postorder of each column's first descendant.
    let mut first = alloc::filled(NONE, n)?;
    let mut count = alloc::filled(0i64, n)?;
    for (place, &leaf) in order.iter().enumerate() {
        job.step_within(place, "solving")?;
        if first[leaf as usize] == NONE {
            count[leaf as usize] = 1;
        }
        let mut i = leaf;
        while i != NONE && first[i as usize] == NONE {
            first[i as usize] = place as u32;
            i = parent[i as usize];
        }
    }
    let mut subtrees = RowSubtrees {
        latest_first: alloc::filled(0, n)?,
        latest_leaf: alloc::filled(NONE, n)?,
        ancestor: alloc::collect(0..n as u32)?,
    };
    for (place, &j) in order.iter().enumerate() {
        job.step_every(REPORT_INTERVAL, place + 1, n, "solving")?;
        let up = parent[j as usize];
        if up != NONE {
            count[up as usize] -= 1;
        }
        for &(i, _) in below.get(j as usize) {
            if let Some(meeting) = subtrees.add(i as usize, j, first[j as usize]) {
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

/// The subtrees of all rows, whose columns come in postorder.
struct RowSubtrees {
    /// One more than the largest place of a first descendant, of the columns of each row so far.
    latest_first: Vec<u32>,
    latest_leaf: Vec<u32>,
    /// Towards the root of what has been visited.
    ancestor: Vec<u32>,
}

impl RowSubtrees {
    /// Column `j` in row `i`; `first`: the place of its first descendant. `None` if it is no leaf
    /// of the row's subtree; else the least common ancestor with the leaf before it, `NONE` for the
    /// first.
    fn add(&mut self, i: usize, j: u32, first: u32) -> Option<u32> {
        if first < self.latest_first[i] {
            return None;
        }
        self.latest_first[i] = first + 1;
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
