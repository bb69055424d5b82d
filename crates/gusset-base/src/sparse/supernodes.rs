//! Supernodes: groups of columns of the factor that are stored and computed as one dense block.
//!
//! A group joins columns with nearly equal row patterns, one an ancestor of the other, and stores
//! some zeros among its entries. The groups form a tree, and their columns are renumbered in its
//! postorder. Renumbering only permutes the factor's rows and columns. Sources: C. Ashcraft, R.
//! Grimes, *The influence of relaxed supernode partitions on the multifrontal method* (1989); J. W.
//! H. Liu, *The multifrontal method for sparse matrix solution* (1992).

use super::elimination_tree::{elimination_tree_parents, factor_column_counts, forest_postorder};
use super::symmetric::SparseSymmetric;
use crate::NONE;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::sort::Buckets;
use std::ops::Range;

/// The share of zeros that groups may hold, by their number of columns: each pair is the largest
/// number of columns and its share.
const MAX_ZERO_SHARES: [(u64, f64); 3] = [(16, 0.6), (48, 0.15), (u64::MAX, 0.05)];
/// Supernodes with at most this many columns may store any number of explicit zeros.
const MAX_COLUMNS_WITH_ANY_ZEROS: u64 = 4;
/// A matrix of at most this many columns is a single group.
const MAX_SINGLE_GROUP_COLUMNS: usize = 24;
/// Entries examined between two progress reports.
const ENTRIES_PER_REPORT: usize = 1 << 18;

/// The groups in the order of elimination.
pub struct Supernodes {
    /// The matrix's column numbers, in the new order.
    pub order: Vec<u32>,
    /// The new number of each column.
    pub new_number_of_column: Vec<u32>,
    /// The first column of each group, then the number of columns.
    first_columns: Vec<u32>,
    /// The rows of each group below its columns, ascending.
    rows_below_groups: Vec<u32>,
    rows_start: Vec<usize>,
    /// The group whose columns include the first of these rows; `NONE` for a root.
    parent: Vec<u32>,
    /// The first group of the subtree below each group.
    first_of_subtree: Vec<u32>,
}

impl Supernodes {
    /// Finds the groups of a matrix. `below` has the matrix's entries below the diagonal. O(e log
    /// n), where e is the total number of rows of all groups.
    pub fn new(matrix: &SparseSymmetric, below: &Buckets<(u32, f64)>, job: &Job<'_>) -> Result<Self> {
        let n = matrix.row_count();
        if n <= MAX_SINGLE_GROUP_COLUMNS {
            return Supernodes::one_supernode(n);
        }
        let parent = elimination_tree_parents(matrix, &job.sub_job(0.0, 0.2))?;
        let count = factor_column_counts(below, &parent, &job.sub_job(0.2, 0.6))?;
        job.step(0.6, "solving")?;
        let group = merge_columns_into_groups(&parent, &count)?;
        job.step(0.6, "solving")?;

        // Until the postorder numbers it, a group is identified by its last column.
        let (mut last, mut number) = (Vec::new(), alloc::filled(NONE, n)?);
        for k in (0..n).filter(|&k| group[k] as usize == k) {
            number[k] = last.len() as u32;
            alloc::push(&mut last, k as u32)?;
        }
        let group_of = |column: u32| if column == NONE { NONE } else { number[group[column as usize] as usize] };
        let unordered = alloc::collect(last.iter().map(|&k| group_of(parent[k as usize])))?;
        let sequence = forest_postorder(&unordered, &job.sub_job(0.6, 0.6))?;
        job.step(0.6, "solving")?;
        let columns = Buckets::new(last.len(), 0, (0..n as u32).map(|k| (group_of(k) as usize, k)))?;
        job.step(0.6, "solving")?;

        let (mut order, mut first) = (alloc::with_capacity(n)?, alloc::with_capacity(last.len() + 1)?);
        let mut renumbered = alloc::filled(NONE, last.len())?;
        for (k, &group) in sequence.iter().enumerate() {
            renumbered[group as usize] = k as u32;
            first.push(order.len() as u32);
            order.extend_from_slice(columns.get(group as usize));
        }
        first.push(n as u32);
        let mut place = alloc::filled(0, n)?;
        order.iter().zip(0..).for_each(|(&k, to)| place[k as usize] = to);
        job.step(0.6, "solving")?;
        let new = |group: u32| renumbered.get(group as usize).copied().unwrap_or(NONE);
        let parent = alloc::collect(sequence.iter().map(|&group| new(unordered[group as usize])))?;
        let mut subtree = alloc::collect(0..last.len() as u32)?;
        for s in 0..last.len() {
            if let Some(begin) = subtree.get(parent[s] as usize).copied() {
                subtree[parent[s] as usize] = begin.min(subtree[s]);
            }
        }
        let mut supernodes = Supernodes {
            order,
            new_number_of_column: place,
            first_columns: first,
            rows_below_groups: Vec::new(),
            rows_start: Vec::new(),
            parent,
            first_of_subtree: subtree,
        };
        supernodes.find_rows_of_supernodes(below, &job.sub_job(0.6, 1.0))?;
        Ok(supernodes)
    }

    /// Returns a single group of all columns.
    fn one_supernode(n: usize) -> Result<Self> {
        let numbers = alloc::collect(0..n as u32)?;
        let [place, first, parent, subtree] = [numbers.clone(), vec![0, n as u32], vec![NONE], vec![0]];
        Ok(Supernodes {
            order: numbers,
            new_number_of_column: place,
            first_columns: first,
            rows_below_groups: Vec::new(),
            rows_start: vec![0, 0],
            parent,
            first_of_subtree: subtree,
        })
    }

    /// Returns the number of groups.
    pub fn len(&self) -> usize {
        self.parent.len()
    }

    /// Returns the columns of a group.
    pub fn columns(&self, s: usize) -> Range<usize> {
        self.first_columns[s] as usize..self.first_columns[s + 1] as usize
    }

    /// Returns the rows below the columns in which the group has entries.
    pub fn rows_below(&self, s: usize) -> &[u32] {
        &self.rows_below_groups[self.rows_start[s]..self.rows_start[s + 1]]
    }

    /// Returns the children of a group, the last one first.
    pub fn children(&self, s: usize) -> impl Iterator<Item = usize> + '_ {
        let child = move |s_before: usize| s_before.checked_sub(1).filter(|&c| self.parent[c] == s as u32);
        std::iter::successors(child(s), move |&c| child(self.first_of_subtree[c] as usize))
    }

    /// Finds the rows of each group: the union of the matrix's rows in its columns and its
    /// children's rows.
    fn find_rows_of_supernodes(&mut self, below: &Buckets<(u32, f64)>, job: &Job<'_>) -> Result<()> {
        let mut seen = alloc::filled(NONE, self.order.len())?;
        let mut found = Vec::new();
        self.rows_start = alloc::with_capacity(self.len() + 1)?;
        self.rows_start.push(0);
        let mut looked_at = 0;
        for s in 0..self.len() {
            let columns = self.columns(s);
            let mut add = |row: u32| {
                if row as usize >= columns.end && seen[row as usize] != s as u32 {
                    seen[row as usize] = s as u32;
                    alloc::push(&mut found, row)?;
                }
                Ok(())
            };
            for &k in &self.order[columns.clone()] {
                let rows = below.get(k as usize);
                looked_at += rows.len();
                rows.iter().try_for_each(|&(i, _)| add(self.new_number_of_column[i as usize]))?;
            }
            for child in self.children(s) {
                let rows = self.rows_below(child);
                looked_at += rows.len();
                rows.iter().try_for_each(|&row| add(row))?;
            }
            found.sort_unstable();
            alloc::append(&mut self.rows_below_groups, &found)?;
            found.clear();
            self.rows_start.push(self.rows_below_groups.len());
            if looked_at >= ENTRIES_PER_REPORT {
                job.step(s as f64 / self.len() as f64, "solving")?;
                looked_at = 0;
            }
        }
        Ok(())
    }
}

/// The size of a group.
#[derive(Clone, Copy)]
struct SupernodeSize {
    columns: u64,
    /// Rows below its columns.
    rows: u64,
    /// Entries that are zero in the factor.
    zeros: u64,
}

impl SupernodeSize {
    /// Returns the number of entries on and below the diagonal.
    fn entry_count(self) -> u64 {
        self.columns * (self.columns + 1) / 2 + self.columns * self.rows
    }

    /// Merges a group with its child.
    fn merged_with(self, child: SupernodeSize) -> SupernodeSize {
        let both = SupernodeSize { columns: self.columns + child.columns, ..self };
        let stored = self.entry_count() - self.zeros + child.entry_count() - child.zeros;
        SupernodeSize { zeros: both.entry_count() - stored, ..both }
    }

    fn has_few_zeros(self) -> bool {
        let share = self.zeros as f64 / self.entry_count() as f64;
        let bound = MAX_ZERO_SHARES.iter().find(|(columns, _)| self.columns <= *columns);
        self.columns <= MAX_COLUMNS_WITH_ANY_ZEROS || bound.is_some_and(|&(_, bound)| share <= bound)
    }
}

/// Returns the last column of each column's group. Proceeds from the leaves: each column absorbs
/// the groups of its children, the last one first, while that adds few zeros.
fn merge_columns_into_groups(parent: &[u32], count: &[u32]) -> Result<Vec<u32>> {
    let n = parent.len();
    let mut last = alloc::collect(0..n as u32)?;
    let whole = |&count: &u32| SupernodeSize { columns: 1, rows: u64::from(count) - 1, zeros: 0 };
    let mut size = alloc::collect(count.iter().map(whole))?;
    let (mut child, mut sibling) = (alloc::filled(NONE, n)?, alloc::filled(NONE, n)?);
    for k in 0..n {
        let mut next = child[k];
        while next != NONE {
            let both = size[k].merged_with(size[next as usize]);
            if both.has_few_zeros() {
                size[k] = both;
                last[next as usize] = k as u32;
            }
            next = sibling[next as usize];
        }
        // The last child first.
        if let Some(first) = child.get_mut(parent[k] as usize) {
            sibling[k] = std::mem::replace(first, k as u32);
        }
    }
    // From the root, so that each column finds its group's last column.
    for k in (0..n).rev() {
        last[k] = last[last[k] as usize];
    }
    Ok(last)
}
