//! Rearranged nets: parts, transposed and flipped nets, quarter turns (Deryagin, "Non-spatial
//! operations").
//!
//! Invariant: coordinates keep their bits, and links, seams and bridges follow their nodes.
//! Exchanging rows and columns, or reversing either, mirrors the net in index space.
//! [`Topology::is_reversed`] records the mirroring, so that normals stay the same. O(nodes).
//!
//! `rearranged_matrices` writes coordinates, `rearranged_topology` moves links, `seams` moves
//! seams.

mod rearranged_matrices;
mod rearranged_topology;
mod seams;

pub(crate) use rearranged_matrices::{Rearrangement, build_matrices, rearrange_coordinates};
pub(crate) use rearranged_topology::rows_closed_by_seam;
pub(crate) use seams::{map_seam, merge_seams};

use super::{Bridge, Direction, Net, Shape, Topology};
use gusset_base::alloc;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::job::Job;
use std::ops::Range;

/// A symmetry of the rectangle of nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum GridSymmetry {
    /// Keeps rows and columns.
    #[default]
    None,
    /// Makes the last column the first row.
    Quarter,
    /// Puts the last row and the last column first.
    Half,
    /// Makes the first column the last row.
    ThreeQuarters,
    /// Puts the last column first.
    FlipColumns,
    /// Puts the last row first.
    FlipRows,
    /// Exchanges rows and columns.
    Transpose,
    /// Exchanges rows and columns and reverses both.
    Antitranspose,
}

impl Net<'_> {
    /// Cuts out a range of rows and a range of columns. The part keeps the links and pairs of seams
    /// within it, and the bridges that cross it. Closing links survive if all rows, or all columns,
    /// do.
    ///
    /// # Errors
    /// [`Error::NetTooSmall`], [`Error::OptionOutOfRange`] for ranges beyond the net,
    /// [`Error::CrossingCell`] if only gluings outside the part identified the opposite corners of
    /// a cell, [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn sub_net(&self, rows: Range<usize>, columns: Range<usize>, job: &Job<'_>) -> Result<Net<'static>> {
        let old = self.shape();
        for (option, range, count) in [("rows", &rows, old.rows()), ("columns", &columns, old.columns())] {
            let is_within = range.start <= range.end && range.end <= count;
            Error::require(
                is_within,
                option,
                range.end.max(range.start) as f64,
                Allowed::AtMost(count.min(range.end) as f64),
            )?;
        }
        // The error then names both numbers.
        Shape::new(rows.len(), columns.len())?;
        let topology = restrict_topology(self.topology(), &rows, &columns)?;
        topology.check_crossed_cells()?;
        let map = Rearrangement::Part { row: rows.start, column: columns.start };
        let mut part = self.with_rearranged_nodes(&map, topology, job)?;
        for bridge in self.bridges() {
            if let Some(bridge) = bridge.clipped_to(&rows, &columns) {
                alloc::push(part.bridges_mut(), bridge)?;
            }
        }
        Ok(part)
    }

    /// Exchanges rows and columns.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn transposed(&self, job: &Job<'_>) -> Result<Net<'static>> {
        let mut net = self.with_rearranged_nodes(&Rearrangement::Transposed, self.topology().transposed()?, job)?;
        let transpose =
            |bridge: &Bridge| Bridge { direction: bridge.direction.transposed(), ..bridge.without_adaptations() };
        *net.bridges_mut() = alloc::collect(self.bridges().iter().map(transpose))?;
        Ok(net)
    }

    /// Reverses the order of rows (`Down`) or columns.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn flipped(&self, axis: Direction, job: &Job<'_>) -> Result<Net<'static>> {
        let topology = self.topology().map_rows_or_columns(axis, Topology::flipped_rows)?;
        let mut net = self.with_rearranged_nodes(&Rearrangement::Flipped(axis), topology, job)?;
        let flip = |bridge: &Bridge| bridge.flipped(axis, self.shape());
        *net.bridges_mut() = alloc::collect(self.bridges().iter().map(flip))?;
        Ok(net)
    }

    /// Rotates the net by quarter turns, anticlockwise as the matrix is written down: after one,
    /// the last column is the first row. The face orientation stays.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn turned_by_quarters(&self, quarters: i32, job: &Job<'_>) -> Result<Net<'static>> {
        let (first, second) = (&job.sub_job(0.0, 0.5), &job.sub_job(0.5, 1.0));
        match quarters.rem_euclid(4) {
            0 => self.copied(),
            1 => self.transposed(first)?.flipped(Direction::Down, second),
            2 => self.flipped(Direction::Down, first)?.flipped(Direction::Right, second),
            _ => self.transposed(first)?.flipped(Direction::Right, second),
        }
    }

    /// Applies a symmetry to the net. The face orientation stays.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn apply_symmetry(&self, turn: GridSymmetry, job: &Job<'_>) -> Result<Net<'static>> {
        match turn {
            GridSymmetry::None => self.copied(),
            GridSymmetry::Quarter => self.turned_by_quarters(1, job),
            GridSymmetry::Half => self.turned_by_quarters(2, job),
            GridSymmetry::ThreeQuarters => self.turned_by_quarters(3, job),
            GridSymmetry::FlipColumns => self.flipped(Direction::Right, job),
            GridSymmetry::FlipRows => self.flipped(Direction::Down, job),
            GridSymmetry::Transpose => self.transposed(job),
            GridSymmetry::Antitranspose => {
                self.transposed(&job.sub_job(0.0, 0.4))?.turned_by_quarters(2, &job.sub_job(0.4, 1.0))
            }
        }
    }

    /// Rearranges the nodes under a new topology, without bridges.
    pub(crate) fn with_rearranged_nodes(
        &self,
        rearrangement: &Rearrangement<'_>,
        topology: Topology,
        job: &Job<'_>,
    ) -> Result<Net<'static>> {
        Ok(Net::new(rearrange_coordinates(self.coordinates(), topology.shape(), rearrangement, job)?, topology))
    }
}

/// Returns the topology within a rectangle, without a check for crossed cells.
fn restrict_topology(topology: &Topology, rows: &Range<usize>, columns: &Range<usize>) -> Result<Topology> {
    let cut = |topology: &Topology, range: &Range<usize>| -> Result<Topology> {
        match range.len() == topology.shape().rows() {
            true => Ok(topology.clone()),
            false => Ok(topology.cut_into_row_ranges(std::slice::from_ref(range))?.swap_remove(0)),
        }
    };
    let topology = cut(topology, rows)?;
    if columns.len() == topology.shape().columns() {
        return Ok(topology);
    }
    topology.map_rows_or_columns(Direction::Right, |topology| cut(topology, columns))
}

impl Bridge {
    /// Returns the bridge without the adaptations of its nets, which become invalid once nodes
    /// move.
    pub(crate) fn without_adaptations(&self) -> Bridge {
        Bridge { adaptations: [None, None], ..self.clone() }
    }

    /// Returns the bridge in a net whose rows (`Down`) or columns are reversed.
    fn flipped(&self, axis: Direction, shape: Shape) -> Bridge {
        let count = axis.line_count_and_length(shape).0 as u32;
        let bridge = self.without_adaptations();
        if self.direction == axis {
            Bridge { at: count - self.last_line_of_first_net() - 1, ..bridge }
        } else {
            Bridge { start: count - self.end, end: count - self.start, ..bridge }
        }
    }

    /// Returns the part of the bridge within a rectangle, if a cell of it is. Where the rectangle
    /// ends among the inner rows, the last of them is the side.
    pub(crate) fn clipped_to(&self, rows: &Range<usize>, columns: &Range<usize>) -> Option<Bridge> {
        let (across, along) = self.direction.swap_unless_down(rows, columns);
        let (start, end) = (along.start.max(self.start as usize), along.end.min(self.end as usize));
        let (side, at) = (self.last_line_of_first_net() as usize, self.at as usize);
        let (first, last) = (side.max(across.start), at.min(across.end.saturating_sub(1)));
        if first >= last || end < start + 2 {
            return None;
        }
        let whole = (start, end, first, last) == (self.start as usize, self.end as usize, side, at);
        let bridge = if whole { self.clone() } else { self.without_adaptations() };
        let (start, end) = ((start - along.start) as u32, (end - along.start) as u32);
        let (at, rows) = ((last - across.start) as u32, (last - first - 1) as u32);
        Some(Bridge { at, rows, start, end, ..bridge })
    }
}
