//! The existing cells: those with four finite corners that no hidden bridge covers. O(nodes), 1
//! byte a cell unless all exist.

use crate::hidden_cells::HiddenCells;
use crate::{Net, Real, Shape, XyzMatrices, each};
use gusset_base::alloc;
use gusset_base::error::Result;

/// One byte for each cell, 1 if the cell exists; `None` if all cells exist.
pub(super) struct ExistingCells {
    cells: Option<Vec<u8>>,
}

impl ExistingCells {
    /// All cells.
    pub(super) const ALL_CELLS: ExistingCells = ExistingCells { cells: None };

    /// Returns the existing cells of a net. O(nodes).
    pub(super) fn from_net(net: &Net<'_>) -> Result<Self> {
        let shape = net.shape();
        let columns = shape.columns() - 1;
        let mut cells: Vec<u8> = alloc::zeroed(shape.cell_count())?;
        each!(net.coordinates(), planes => mark_finite_cells(planes, &mut cells)?);
        let hidden = HiddenCells::new(net)?;
        if !hidden.is_empty() {
            for (i, row) in cells.chunks_exact_mut(columns).enumerate() {
                hidden.hidden_ranges(i).iter().for_each(|&[from, to]| row[from as usize..to as usize].fill(0));
            }
        }
        let all = cells.iter().all(|&cell| cell == 1);
        Ok(ExistingCells { cells: (!all).then_some(cells) })
    }

    /// Returns true if all cells exist.
    pub(super) fn has_all_cells(&self) -> bool {
        self.cells.is_none()
    }

    /// Writes row i of cells to `row`, with a missing cell at both ends. Rows outside the net
    /// consist of missing cells.
    pub(super) fn write_padded_row(&self, shape: Shape, i: usize, row: &mut [u8]) {
        let columns = shape.columns() - 1;
        let inner = &mut row[1..=columns];
        match &self.cells {
            _ if i + 1 >= shape.rows() => inner.fill(0),
            None => inner.fill(1),
            Some(cells) => inner.copy_from_slice(&cells[i * columns..(i + 1) * columns]),
        }
    }
}

fn mark_finite_cells<T: Real>(planes: &XyzMatrices<'_, T>, cells: &mut [u8]) -> Result<()> {
    let columns = planes.shape().columns();
    let mut above: Vec<u8> = alloc::zeroed(columns)?;
    let mut below: Vec<u8> = alloc::zeroed(columns)?;
    mark_finite_nodes(planes.row(0), &mut above);
    for (i, row) in cells.chunks_exact_mut(columns - 1).enumerate() {
        mark_finite_nodes(planes.row(i + 1), &mut below);
        for (j, cell) in row.iter_mut().enumerate() {
            *cell = above[j] & above[j + 1] & below[j] & below[j + 1];
        }
        std::mem::swap(&mut above, &mut below);
    }
    Ok(())
}

/// 1 for each finite node: 0 times a coordinate is 0 unless it is NaN or infinite.
fn mark_finite_nodes<T: Real>([x, y, z]: [&[T]; 3], finite: &mut [u8]) {
    let zero = T::from_f64(0.0);
    for (((finite, &x), &y), &z) in finite.iter_mut().zip(x).zip(y).zip(z) {
        *finite = u8::from(zero * x + zero * y + zero * z == zero);
    }
}
