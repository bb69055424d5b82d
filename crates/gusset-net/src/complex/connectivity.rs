//! Connected components by union-find, and orientability by union-find with parity. O(nodes).

use super::edges::sides_that_belong_to_faces;
use super::presence::ExistingCells;
use super::row_scan::{FaceSide, IrregularElements};
use crate::topology::NodeClasses;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::{DisjointSets, ParitySets};

/// Returns the number of connected components; 1 if all cells exist. O(nodes).
pub(super) fn count_components(classes: &NodeClasses, presence: &ExistingCells) -> Result<u64> {
    if presence.has_all_cells() {
        return Ok(1);
    }
    let shape = classes.shape();
    let mut sets = DisjointSets::new(shape.node_count())?;
    let mut touched: Vec<bool> = alloc::filled(false, shape.node_count())?;
    let mut row: Vec<u8> = alloc::zeroed(shape.columns() + 1)?;
    for i in 0..shape.rows() - 1 {
        presence.write_padded_row(shape, i, &mut row);
        for j in (0..shape.columns() - 1).filter(|&j| row[j + 1] == 1) {
            let corners = shape.corners_of_cell(i, j);
            for node in corners {
                sets.union(corners[0], node);
                touched[node as usize] = true;
            }
        }
    }
    // A glued node that no cell touches connects nothing.
    for class in classes.glued_classes()?.iter() {
        let mut nodes = class.iter().filter(|&&node| touched[node as usize]);
        if let Some(&first) = nodes.next() {
            nodes.for_each(|&node| _ = sets.union(first, node));
        }
    }
    Ok(sets.roots().filter(|&root| touched[root as usize]).count() as u64)
}

/// Returns true if the faces can be oriented so that no two traverse an edge in the same direction.
/// Edges of three or more faces do not count. O(cells).
pub(super) fn is_orientable(
    scan: &IrregularElements<'_>,
    classes: &NodeClasses,
    presence: &ExistingCells,
) -> Result<bool> {
    let shape = classes.shape();
    let (h, w) = (shape.rows(), shape.columns());
    let mut signs = ParitySets::new(shape.cell_count())?;
    let mut row: Vec<u8> = alloc::zeroed(w + 1)?;
    let mut next: Vec<u8> = alloc::zeroed(w + 1)?;
    let plain = |a: u32, b: u32| !scan.is_glued(a) && !scan.is_glued(b);
    presence.write_padded_row(shape, 0, &mut row);
    for i in 0..h - 1 {
        presence.write_padded_row(shape, i + 1, &mut next);
        for j in (0..w - 1).filter(|&j| row[j + 1] == 1) {
            let [_, b, c, d] = shape.corners_of_cell(i, j);
            if row[j + 2..].first() == Some(&1) && plain(b, c) {
                signs.union(shape.cell(i, j), shape.cell(i, j + 1), false);
            }
            if next[j + 1] == 1 && plain(c, d) {
                signs.union(shape.cell(i, j), shape.cell(i + 1, j), false);
            }
        }
        std::mem::swap(&mut row, &mut next);
    }
    let pairs = scan.sides.chunk_by(|a: &FaceSide, b: &FaceSide| a.edge == b.edge).filter_map(|sides| {
        match sides_that_belong_to_faces(sides) {
            [a, b] => Some((a.cell, b.cell, a.sense == b.sense)),
            _ => None,
        }
    });
    let mut orientable = true;
    pairs.for_each(|(a, b, opposed)| orientable &= signs.union(a, b, opposed));
    Ok(orientable)
}
