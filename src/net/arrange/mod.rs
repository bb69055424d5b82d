//! Rearranged nets: parts, transposed and flipped nets, quarter turns (Deryagin, "Non-spatial
//! operations").
//!
//! Invariant: coordinates keep their bits, and links, seams and bridges follow their nodes. An
//! exchange of rows and columns, or a reversal of either, mirrors the net in index space, which
//! [`Topology::is_reversed`] records, so that normals stay what they were. O(nodes).
//!
//! `matrices` writes coordinates, `topology` moves links, `seams` moves seams.

mod matrices;
mod seams;
mod topology;

pub(crate) use matrices::{Rearrangement, build_planes, rearrange};
pub(crate) use seams::{map_seam, merge_seams};
pub(crate) use topology::{LinkCollector, closed_rows};

use super::{Bridge, Direction, Net, Real, Shape, Topology};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use std::ops::Range;

impl Net<'_> {
    /// The net within a range of rows and a range of columns, with the links and pairs of seams
    /// within it and the bridges that cross it. Closing links survive if all rows, or all columns,
    /// do.
    ///
    /// # Errors
    /// [`Error::NetTooSmall`], [`Error::OptionOutOfRange`] for ranges beyond the net,
    /// [`Error::CrossingCell`] if only what is outside made the opposite corners of a cell one,
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
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
        let place = Part { shape, row: rows.start, column: columns.start };
        let mut part = Net::new(rearrange(self.coordinates(), &place, job)?, topology);
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
        let map = Transposed(self.shape().transposed());
        let transpose = |bridge: &Bridge| Bridge { direction: bridge.direction.transposed(), ..bridge.unadapted() };
        self.mapped(&map, self.topology().transposed()?, transpose, job)
    }

    /// The last row first.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn flipped_rows(&self, job: &Job<'_>) -> Result<Net<'static>> {
        let flip = |bridge: &Bridge| bridge.flipped(Direction::Down, self.shape());
        self.mapped(&FlippedRows(self.shape()), self.topology().flipped_rows()?, flip, job)
    }

    /// The last column first.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn flipped_columns(&self, job: &Job<'_>) -> Result<Net<'static>> {
        let flip = |bridge: &Bridge| bridge.flipped(Direction::Right, self.shape());
        self.mapped(&FlippedColumns(self.shape()), self.topology().flipped_columns()?, flip, job)
    }

    /// The net rotated by quarter turns, anticlockwise as the matrix is written down: after one,
    /// the last column is the first row. The face orientation stays.
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

    fn mapped(
        &self,
        map: &impl Rearrangement,
        topology: Topology,
        bridge: impl Fn(&Bridge) -> Bridge,
        job: &Job<'_>,
    ) -> Result<Net<'static>> {
        let mut net = Net::new(rearrange(self.coordinates(), map, job)?, topology);
        *net.bridges_mut() = alloc::collect(self.bridges().iter().map(bridge))?;
        Ok(net)
    }
}

/// The topology within a rectangle; crossed cells are not looked for.
fn topology_part(topology: &Topology, rows: &Range<usize>, columns: &Range<usize>) -> Result<Topology> {
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
    topology.along(Direction::Right, |topology| cut(topology.clone(), columns, shape.columns()))
}

impl Bridge {
    /// The bridge without the adaptations of its nets, which hold no longer once nodes move.
    pub(crate) fn unadapted(&self) -> Bridge {
        Bridge { adaptations: [None, None], ..self.clone() }
    }

    /// The bridge in a net whose rows (`Down`) or columns are reversed.
    fn flipped(&self, axis: Direction, shape: Shape) -> Bridge {
        let count = axis.extent(shape).0 as u32;
        let bridge = self.unadapted();
        if self.direction == axis {
            Bridge { at: count - self.at, ..bridge }
        } else {
            Bridge { start: count - self.end, end: count - self.start, ..bridge }
        }
    }

    /// The part of the bridge within a rectangle, if a cell of it is.
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
        let bridge = if whole { self.clone() } else { self.unadapted() };
        let (start, end) = ((start - along.start) as u32, (end - along.start) as u32);
        Some(Bridge { at: (at - across.start) as u32, start, end, ..bridge })
    }
}

/// The rectangle of a net from (row, column) on.
pub(crate) struct Part {
    pub(crate) shape: Shape,
    pub(crate) row: usize,
    pub(crate) column: usize,
}

impl Rearrangement for Part {
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

impl Rearrangement for FlippedRows {
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

impl Rearrangement for FlippedColumns {
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

/// Side of a square tile that fits in the cache together with its image.
const TILE: usize = 16;

impl Rearrangement for Transposed {
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
