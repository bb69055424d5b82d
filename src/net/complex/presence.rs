//! Which cells are there.

use crate::alloc;
use crate::error::Result;
use crate::net::hidden::Hidden;
use crate::net::{Net, Planes, Real, Shape, each};

/// One byte for each cell, 1 if it is there; none if all of them are.
pub(super) struct Presence {
    cells: Option<Vec<u8>>,
}

impl Presence {
    /// All cells.
    pub(super) const ALL: Presence = Presence { cells: None };

    /// The cells whose corners are finite and that no hidden bridge has. O(nodes).
    pub(super) fn of(net: &Net<'_>) -> Result<Self> {
        let shape = net.shape();
        let columns = shape.columns() - 1;
        let mut cells: Vec<u8> = alloc::zeroed(shape.cell_count())?;
        each!(net.coordinates(), planes => finite_cells(planes, &mut cells)?);
        let hidden = Hidden::of(net)?;
        if !hidden.is_empty() {
            for (i, row) in cells.chunks_exact_mut(columns).enumerate() {
                hidden.row(i).iter().for_each(|&[from, to]| row[from as usize..to as usize].fill(0));
            }
        }
        let all = cells.iter().all(|&cell| cell == 1);
        Ok(Presence { cells: (!all).then_some(cells) })
    }

    /// True if all cells are there.
    pub(super) fn is_all(&self) -> bool {
        self.cells.is_none()
    }

    /// Row i of cells into `row`, with a cell that is not there at both ends; rows outside the net have none.
    pub(super) fn row(&self, shape: Shape, i: usize, row: &mut [u8]) {
        let columns = shape.columns() - 1;
        let inner = &mut row[1..=columns];
        match &self.cells {
            _ if i + 1 >= shape.rows() => inner.fill(0),
            None => inner.fill(1),
            Some(cells) => inner.copy_from_slice(&cells[i * columns..(i + 1) * columns]),
        }
    }
}

fn finite_cells<T: Real>(planes: &Planes<'_, T>, cells: &mut [u8]) -> Result<()> {
    let columns = planes.shape().columns();
    let mut above: Vec<u8> = alloc::zeroed(columns)?;
    let mut below: Vec<u8> = alloc::zeroed(columns)?;
    finite_nodes(planes.row(0), &mut above);
    for (i, row) in cells.chunks_exact_mut(columns - 1).enumerate() {
        finite_nodes(planes.row(i + 1), &mut below);
        for (j, cell) in row.iter_mut().enumerate() {
            *cell = above[j] & above[j + 1] & below[j] & below[j + 1];
        }
        std::mem::swap(&mut above, &mut below);
    }
    Ok(())
}

/// Zero times a number is 0, unless the number is NaN or infinite.
fn finite_nodes<T: Real>([x, y, z]: [&[T]; 3], finite: &mut [u8]) {
    let zero = T::of(0.0);
    for (((finite, &x), &y), &z) in finite.iter_mut().zip(x).zip(y).zip(z) {
        *finite = u8::from(zero * x + zero * y + zero * z == zero);
    }
}
