//! An order of the cells of a net that keeps the factor of their equations sparse: nested
//! dissection (A. George, 1973) of the rectangle of cells. Cells that share a node are coupled, so
//! a row or a column of cells separates the cells on both sides.

use std::ops::Range;

/// Rectangles of at most this many cells are not halved.
const MAX_LEAF_CELLS: usize = 16;

/// Calls `visit` with all cells of a rectangle, both halves before their separator. O(cells).
pub(super) fn visit_in_dissection_order(
    rows: Range<usize>,
    columns: Range<usize>,
    visit: &mut dyn FnMut(usize, usize) -> gusset_base::error::Result<()>,
) -> gusset_base::error::Result<()> {
    let (h, w) = (rows.len(), columns.len());
    if h * w <= MAX_LEAF_CELLS || h.max(w) < 3 {
        return rows.into_iter().try_for_each(|i| columns.clone().try_for_each(|j| visit(i, j)));
    }
    if h > w {
        let middle = rows.start + h / 2;
        visit_in_dissection_order(rows.start..middle, columns.clone(), visit)?;
        visit_in_dissection_order(middle + 1..rows.end, columns.clone(), visit)?;
        visit_in_dissection_order(middle..middle + 1, columns, visit)
    } else {
        let middle = columns.start + w / 2;
        visit_in_dissection_order(rows.clone(), columns.start..middle, visit)?;
        visit_in_dissection_order(rows.clone(), middle + 1..columns.end, visit)?;
        visit_in_dissection_order(rows, middle..middle + 1, visit)
    }
}

/// Orders all cells of a net with the given numbers of rows and columns of cells. If sides are
/// glued, the last row and column come last, because they separate the first ones from the others.
pub(crate) fn visit_in_elimination_order(
    [rows, columns]: [usize; 2],
    is_glued: bool,
    visit: &mut dyn FnMut(usize, usize) -> gusset_base::error::Result<()>,
) -> gusset_base::error::Result<()> {
    let last = usize::from(is_glued);
    visit_in_dissection_order(0..rows - last, 0..columns - last, visit)?;
    visit_in_dissection_order(rows - last..rows, 0..columns, visit)?;
    visit_in_dissection_order(0..rows - last, columns - last..columns, visit)
}
