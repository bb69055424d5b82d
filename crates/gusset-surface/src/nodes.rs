//! The nodes of a grid: a strided view of the caller's numbers, or a shared copy.

use super::axis::NODES_PER_CUBIC;
use super::checks::check_nodes_finite;
use glam::DVec3;
use gusset_base::error::{Error, Result};
use std::borrow::Cow;
use std::sync::Arc;

/// The largest number of nodes of a surface.
pub const MAX_NODES: u64 = (1 << 31) - 1;

/// Coordinates of six nodes.
pub(super) type NodeWindow = [f64; 3 * NODES_PER_CUBIC];

/// The caller's numbers, or numbers that copies of a sheet share.
#[derive(Debug, Clone)]
enum NodeData<'a> {
    Borrowed(&'a [f64]),
    Shared(Arc<[f64]>),
}

impl std::ops::Deref for NodeData<'_> {
    type Target = [f64];

    #[inline]
    fn deref(&self) -> &[f64] {
        match self {
            NodeData::Borrowed(data) => data,
            NodeData::Shared(data) => data,
        }
    }
}

/// Nodes in rows: x, y, z of node (i, j) begin at index `i * row_stride + j * column_stride`.
#[derive(Debug, Clone)]
pub struct Nodes<'a> {
    coordinates: NodeData<'a>,
    rows: usize,
    columns: usize,
    row_stride: usize,
    column_stride: usize,
}

impl<'a> Nodes<'a> {
    /// Creates a view of nodes in the caller's memory, or takes ownership of them. Strides count
    /// numbers, not bytes; 0 means contiguous nodes or rows.
    ///
    /// # Errors
    /// [`Error::NetTooSmall`] below 2 x 2, [`Error::TooLarge`], [`Error::StrideTooSmall`],
    /// [`Error::SizeOverflow`], [`Error::ArrayTooShort`].
    pub fn strided(
        data: impl Into<Cow<'a, [f64]>>,
        rows: usize,
        columns: usize,
        row_stride: usize,
        column_stride: usize,
    ) -> Result<Self> {
        let data = match data.into() {
            Cow::Borrowed(data) => NodeData::Borrowed(data),
            Cow::Owned(data) => NodeData::Shared(data.into()),
        };
        let count = (rows as u64).saturating_mul(columns as u64);
        if rows < 2 || columns < 2 {
            return Err(Error::NetTooSmall { rows: rows as u64, columns: columns as u64 });
        }
        Error::check_count("nodes", count, MAX_NODES)?;
        let column_stride = if column_stride == 0 { 3 } else { column_stride };
        let width = (columns - 1).checked_mul(column_stride).and_then(|n| n.checked_add(3));
        let row_stride = if row_stride == 0 { columns.checked_mul(column_stride) } else { Some(row_stride) };
        let span = row_stride.zip(width).and_then(|(row, width)| (rows - 1).checked_mul(row)?.checked_add(width));
        let (Some(row_stride), Some(width), Some(span)) = (row_stride, width, span) else {
            return Err(Error::SizeOverflow { what: "nodes", count });
        };
        if column_stride < 3 || row_stride < width {
            let (what, stride, least) =
                if column_stride < 3 { ("nodes", column_stride, 3) } else { ("rows of nodes", row_stride, width) };
            return Err(Error::StrideTooSmall { what, stride: stride as u64, min: least as u64 });
        }
        if data.len() < span {
            let (needed, given) = (8 * span as u64, 8 * data.len() as u64);
            return Err(Error::ArrayTooShort { what: "nodes", needed, given });
        }
        Ok(Nodes { coordinates: data, rows, columns, row_stride, column_stride })
    }

    /// The number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Node (i, j).
    #[inline]
    pub fn get(&self, i: usize, j: usize) -> DVec3 {
        let at = i * self.row_stride + j * self.column_stride;
        DVec3::from_slice(&self.coordinates[at..at + 3])
    }

    /// `K` numbers that begin with node (i, j), if the nodes of a row are contiguous and K numbers
    /// exist.
    #[inline(always)]
    pub(super) fn contiguous_numbers<const K: usize>(&self, i: usize, j: usize) -> Option<&[f64; K]> {
        if self.column_stride == 3 { self.coordinates[i * self.row_stride + 3 * j..].first_chunk() } else { None }
    }

    /// The coordinates of six nodes of a row without a copy, if the nodes are contiguous.
    #[inline(always)]
    pub(super) fn borrow_window(&self, i: usize, columns: &[usize; NODES_PER_CUBIC]) -> Option<&NodeWindow> {
        if columns[NODES_PER_CUBIC - 1] == columns[0] + NODES_PER_CUBIC - 1 {
            self.contiguous_numbers(i, columns[0])
        } else {
            None
        }
    }

    /// Returns a function that reads a node as four numbers for vector instructions. The fourth is
    /// padding.
    #[inline(always)]
    pub(super) fn reader_of_four_numbers(&self) -> impl Fn(usize, usize) -> [f64; 4] {
        let (data, strides): (&[f64], _) = (&self.coordinates, [self.row_stride, self.column_stride]);
        move |i, j| {
            let at = i * strides[0] + j * strides[1];
            match data[at..].first_chunk() {
                Some(&four) => four,
                None => [data[at], data[at + 1], data[at + 2], 0.0],
            }
        }
    }

    /// Copies the coordinates of six nodes of a row.
    #[inline(always)]
    pub(super) fn copy_window(&self, i: usize, columns: &[usize; NODES_PER_CUBIC]) -> NodeWindow {
        let mut window = [0.0; 3 * NODES_PER_CUBIC];
        for (node, &column) in window.chunks_exact_mut(3).zip(columns) {
            let at = i * self.row_stride + column * self.column_stride;
            node.copy_from_slice(&self.coordinates[at..at + 3]);
        }
        window
    }

    /// The coordinates of a row, if its nodes are contiguous.
    #[inline]
    pub(super) fn contiguous_row(&self, i: usize) -> Option<&[f64]> {
        let at = i * self.row_stride;
        (self.column_stride == 3).then(|| &self.coordinates[at..at + 3 * self.columns])
    }

    /// Returns [`Error::NotFinite`] for the first node with a coordinate that is NaN or infinite.
    pub(crate) fn check_finite(&self) -> Result<()> {
        check_nodes_finite((0..self.rows).flat_map(|i| (0..self.columns).map(move |j| self.get(i, j))))
    }

    /// Returns [`Error::SidesApart`] with the place of the largest gap, unless the last line of
    /// each closed direction repeats the first one.
    pub(super) fn check_closed_directions(&self, [closed_u, closed_v]: [bool; 2]) -> Result<()> {
        let gap = |a: [usize; 2], b: [usize; 2]| self.get(a[0], a[1]).distance(self.get(b[0], b[1]));
        if closed_u {
            check_closing_gaps((0..self.columns).map(|j| gap([0, j], [self.rows - 1, j])))?;
        }
        if closed_v {
            check_closing_gaps((0..self.rows).map(|i| gap([i, 0], [i, self.columns - 1])))?;
        }
        Ok(())
    }
}

fn check_closing_gaps(gaps: impl Iterator<Item = f64>) -> Result<()> {
    let worst = gaps.zip(0..).fold((0.0, 0), |worst, gap| if gap.0 > worst.0 { gap } else { worst });
    match worst {
        (0.0, _) => Ok(()),
        (distance, place) => Err(Error::SidesApart { place, distance }),
    }
}
