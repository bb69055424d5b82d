//! What carcasses and their sheets are, as C sees them.

use super::carcass::{gusset_carcass, read};
use super::guard::guard;
use super::input::{self, Versioned};
use super::status::{Failure, gusset_status};
use std::ptr;

/// What a carcass is.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_carcass_facts {
    /// sizeof(gusset_carcass_facts), set by the caller.
    pub struct_size: usize,
    /// How many sheets.
    pub sheet_count: usize,
    /// How many cells, of all sheets.
    pub cell_count: usize,
    /// How many corners of cells: of sheets from nodes, the nodes.
    pub node_count: usize,
    /// Bytes of the index without the cones of normals; the nodes are not counted.
    pub index_bytes: usize,
    /// The length to which answers are proved.
    pub tolerance: f64,
    /// A corner of a box round the surface and the control nets of its cells, which may be larger than the surface: the least x, y, z.
    pub low: [f64; 3],
    /// The greatest.
    pub high: [f64; 3],
    /// Bytes of the cones of normals; 0 as long as there are none: see gusset_carcass_options.
    pub cone_bytes: usize,
}

/// What a sheet of a carcass is.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_carcass_sheet_facts {
    /// sizeof(gusset_carcass_sheet_facts), set by the caller.
    pub struct_size: usize,
    /// Cells in u: u runs from 0 to this. There is one more row of corners.
    pub rows: usize,
    /// Cells in v.
    pub columns: usize,
    /// The number of its cell (0, 0) among the cells of all sheets, one sheet after the other, each row after row: of cell (i, j) it is
    /// first_cell + i * columns + j, the bit of masks of gusset_surface_region_parts.
    pub first_cell: u64,
    /// The same of its corner (0, 0) among the corners of all sheets, rows + 1 by columns + 1 each: where its values begin for
    /// gusset_carcass_contours.
    pub first_node: u64,
    /// 1: closed in u.
    pub closed_u: u32,
    /// 1: closed in v.
    pub closed_v: u32,
}

// SAFETY: repr(C), size first, plain numbers.
unsafe impl Versioned for gusset_carcass_facts {
    const LEAST_SIZE: usize = 96;
}
// SAFETY: as above.
unsafe impl Versioned for gusset_carcass_sheet_facts {
    const LEAST_SIZE: usize = 48;
}
const _: () = assert!(
    size_of::<usize>() != 8
        || (size_of::<gusset_carcass_facts>() == 104 && size_of::<gusset_carcass_sheet_facts>() == 48)
);

/// What a carcass is. facts: struct_size set by the caller; all else is overwritten. Errors: NULL_ARGUMENT, MISALIGNED_ARGUMENT,
/// BAD_STRUCT_SIZE. O(sheets). From any thread.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_carcass_info(
    carcass: *const gusset_carcass,
    facts: *mut gusset_carcass_facts,
) -> gusset_status {
    let out = input::output_struct(facts, "facts");
    guard(ptr::null(), |_| {
        let (out, carcass) = (out?, read(carcass)?);
        let [low, high] = carcass.bounds().map(|corner| corner.to_array());
        out.write(gusset_carcass_facts {
            struct_size: 0,
            sheet_count: carcass.len(),
            cell_count: carcass.cell_count() as usize,
            node_count: carcass.node_count() as usize,
            index_bytes: carcass.index_bytes(),
            tolerance: carcass.tolerance(),
            low,
            high,
            cone_bytes: carcass.cone_bytes(),
        });
        Ok(())
    })
}

/// What a sheet of a carcass is.
///
/// sheet: its number, as in places. facts: struct_size set by the caller; all else is overwritten. Errors: NULL_ARGUMENT,
/// MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE, NO_SUCH_ELEMENT (sheet). O(sheets). From any thread.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_carcass_sheet(
    carcass: *const gusset_carcass,
    sheet: usize,
    facts: *mut gusset_carcass_sheet_facts,
) -> gusset_status {
    let out = input::output_struct(facts, "facts");
    guard(ptr::null(), |_| {
        let (out, carcass) = (out?, read(carcass)?);
        if sheet >= carcass.len() {
            return Err(Failure::no_such("sheet", sheet));
        }
        let (cells, closed) = (carcass.sheet(sheet).cells(), carcass.sheet(sheet).is_closed().map(u32::from));
        let before = |more: usize| -> u64 {
            (0..sheet)
                .map(|k| carcass.sheet(k).cells().map(|count| (count + more) as u64).iter().product::<u64>())
                .sum()
        };
        out.write(gusset_carcass_sheet_facts {
            struct_size: 0,
            rows: cells[0],
            columns: cells[1],
            first_cell: before(0),
            first_node: before(1),
            closed_u: closed[0],
            closed_v: closed[1],
        });
        Ok(())
    })
}
