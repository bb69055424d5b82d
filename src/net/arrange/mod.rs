//! Nets whose nodes are arranged anew: parts, transposed and flipped nets, quarter turns.
//!
//! Coordinates keep their bits. Links, seams and bridges go with their nodes; links of sides stay links of sides. To exchange
//! rows and columns, or to reverse either, turns the net over in space: [`Topology::is_reversed`] says so from then on, and
//! normals stay what they were.
//!
//! `rows` writes matrices, `gluing` moves links, `runs` moves seams.

mod gluing;
mod rows;
mod runs;

pub(crate) use gluing::{Collected, closing_rows};
pub(crate) use rows::{Rearrange, planes, rearranged};
pub(crate) use runs::{carried, joined};

use super::{Bridge, Direction, Net, Real, Shape, Topology};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use std::ops::Range;

impl Net<'_> {
    /// The net within a range of rows and a range of columns: the links within it, of each seam what has both ends within it,
    /// and the bridges that cross it. Links that lead back are within it if all rows, or all columns, are.
    ///
    /// # Errors
    /// [`Error::NetTooSmall`], [`Error::OptionOutOfRange`] for ranges beyond the net, [`Error::CrossingCell`] if only what is
    /// outside made the opposite corners of a cell one, [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn part(&self, rows: Range<usize>, columns: Range<usize>, job: &Job<'_>) -> Result<Net<'static>> {
        let old = self.shape();
        for (option, range, count) in [("rows", &rows, old.rows()), ("columns", &columns, old.columns())] {
            if range.start > range.end || range.end > count {
                return Err(Error::OptionOutOfRange { option, value: range.end.max(range.start) as f64 });
            }
        }
        let shape = Shape::new(rows.len(), columns.len())?;
        let topology = topology_part(self.topology(), &rows, &columns)?;
        topology.check_crossings()?;
        let how = Part { shape, row: rows.start, column: columns.start };
        let mut part = Net::new(rearranged(self.coordinates(), &how, job)?, topology);
        for bridge in self.bridges() {
            if let Some(bridge) = bridge.within(&rows, &columns) {
                alloc::push(part.bridges_mut(), bridge)?;
            }
        }
        Ok(part)
    }

    /// Rows and columns exchanged.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn transposed(&self, job: &Job<'_>) -> Result<Net<'static>> {
        let how = Transposed(self.shape().transposed());
        let transpose = |bridge: &Bridge| Bridge { direction: bridge.direction.transposed(), ..bridge.unmarked() };
        self.exchanged(&how, self.topology().transposed()?, transpose, job)
    }

    /// The last row first.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn flipped_rows(&self, job: &Job<'_>) -> Result<Net<'static>> {
        let flip = |bridge: &Bridge| bridge.flipped(Direction::Down, self.shape());
        self.exchanged(&FlippedRows(self.shape()), self.topology().flipped_rows()?, flip, job)
    }

    /// The last column first.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn flipped_columns(&self, job: &Job<'_>) -> Result<Net<'static>> {
        let flip = |bridge: &Bridge| bridge.flipped(Direction::Right, self.shape());
        self.exchanged(&FlippedColumns(self.shape()), self.topology().flipped_columns()?, flip, job)
    }

    /// Turned by quarters, to the left as the matrix is written down: after one, the last column is the first row. What is
    /// reversed stays so.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn turned(&self, quarters: i32, job: &Job<'_>) -> Result<Net<'static>> {
        match quarters.rem_euclid(4) {
            0 => self.copied(),
            1 => self.transposed(&job.part(0.0, 0.5))?.flipped_rows(&job.part(0.5, 1.0)),
            2 => self.flipped_rows(&job.part(0.0, 0.5))?.flipped_columns(&job.part(0.5, 1.0)),
            _ => self.transposed(&job.part(0.0, 0.5))?.flipped_columns(&job.part(0.5, 1.0)),
        }
    }

    fn exchanged(
        &self,
        how: &impl Rearrange,
        topology: Topology,
        bridge: impl Fn(&Bridge) -> Bridge,
        job: &Job<'_>,
    ) -> Result<Net<'static>> {
        let mut net = Net::new(rearranged(self.coordinates(), how, job)?, topology);
        *net.bridges_mut() = alloc::collect(self.bridges().iter().map(bridge))?;
        Ok(net)
    }
}

/// What is glued within a rectangle; crossings are not looked for.
pub(crate) fn topology_part(topology: &Topology, rows: &Range<usize>, columns: &Range<usize>) -> Result<Topology> {
    let cut = |topology: Topology, range: &Range<usize>, count: usize| -> Result<Topology> {
        if range.len() == count {
            return Ok(topology);
        }
        let mut parts = topology.rows_cut(std::slice::from_ref(range))?;
        Ok(parts.swap_remove(0))
    };
    let shape = topology.shape();
    let topology = cut(topology.clone(), rows, shape.rows())?;
    if columns.len() == shape.columns() {
        return Ok(topology);
    }
    cut(topology.transposed()?, columns, shape.columns())?.transposed()
}

impl Bridge {
    /// The same without the account of what was done to the nets, which the new arrangement has made untrue.
    fn unmarked(&self) -> Bridge {
        Bridge { origins: [None, None], ..self.clone() }
    }

    /// Where it is when rows (`Down`) or columns are reversed.
    fn flipped(&self, axis: Direction, shape: Shape) -> Bridge {
        let count = axis.extent(shape).0 as u32;
        let bridge = self.unmarked();
        if self.direction == axis {
            Bridge { at: count - self.at, ..bridge }
        } else {
            Bridge { start: count - self.end, end: count - self.start, ..bridge }
        }
    }

    /// What is within a rectangle, if a cell is.
    pub(crate) fn within(&self, rows: &Range<usize>, columns: &Range<usize>) -> Option<Bridge> {
        let (across, along) = match self.direction {
            Direction::Right => (columns, rows),
            Direction::Down => (rows, columns),
        };
        let (start, end) = (along.start.max(self.start as usize), along.end.min(self.end as usize));
        let at = self.at as usize;
        if at <= across.start || at >= across.end || end < start + 2 {
            return None;
        }
        let whole = (start, end) == (self.start as usize, self.end as usize);
        let bridge = if whole { self.clone() } else { self.unmarked() };
        let (start, end) = ((start - along.start) as u32, (end - along.start) as u32);
        Some(Bridge { at: (at - across.start) as u32, start, end, ..bridge })
    }
}

struct Part {
    shape: Shape,
    row: usize,
    column: usize,
}

impl Rearrange for Part {
    fn shape(&self) -> Shape {
        self.shape
    }

    fn write<T: Real>(&self, rows: Range<usize>, from: &[T], stride: usize, to: &mut [T]) {
        let columns = self.shape.columns();
        for (i, to) in rows.zip(to.chunks_exact_mut(columns)) {
            to.copy_from_slice(&from[(self.row + i) * stride + self.column..][..columns]);
        }
    }
}

struct FlippedRows(Shape);

impl Rearrange for FlippedRows {
    fn shape(&self) -> Shape {
        self.0
    }

    fn write<T: Real>(&self, rows: Range<usize>, from: &[T], stride: usize, to: &mut [T]) {
        let columns = self.0.columns();
        for (i, to) in rows.zip(to.chunks_exact_mut(columns)) {
            to.copy_from_slice(&from[(self.0.rows() - 1 - i) * stride..][..columns]);
        }
    }
}

struct FlippedColumns(Shape);

impl Rearrange for FlippedColumns {
    fn shape(&self) -> Shape {
        self.0
    }

    fn write<T: Real>(&self, rows: Range<usize>, from: &[T], stride: usize, to: &mut [T]) {
        let columns = self.0.columns();
        for (i, to) in rows.zip(to.chunks_exact_mut(columns)) {
            let from = &from[i * stride..][..columns];
            to.iter_mut().zip(from.iter().rev()).for_each(|(to, from)| *to = *from);
        }
    }
}

struct Transposed(Shape);

/// Rows and columns of a square that fits in the cache with its image.
const TILE: usize = 16;

impl Rearrange for Transposed {
    fn shape(&self) -> Shape {
        self.0
    }

    fn write<T: Real>(&self, rows: Range<usize>, from: &[T], stride: usize, to: &mut [T]) {
        let columns = self.0.columns();
        for (tile, to) in to.chunks_mut(TILE * columns).enumerate() {
            let first = rows.start + tile * TILE;
            let height = to.len() / columns;
            for left in (0..columns).step_by(TILE) {
                for j in left..columns.min(left + TILE) {
                    let from = &from[j * stride + first..][..height];
                    from.iter().enumerate().for_each(|(i, &value)| to[i * columns + j] = value);
                }
            }
        }
    }
}
