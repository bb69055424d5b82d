//! Regions of cells: Chains, diameters, cells and nodes of masks.
//!
//! @source V. Leus (see the README).

use crate::attributes::Domain;
use crate::capi::context::{answer_into_struct, guard_changing_call, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, fill_buffer, read_choice};
use crate::capi::mesh::origins::gusset_domain;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::sheet::{gusset_sheet, sheet_of_handle};
use crate::job::Job;
use crate::surface::Sheet;
use crate::surface::reference::{
    CellGridShape, CellMask, Diameters, euler_characteristic, integer_diameter, shortest_chain,
};

/// Measures of a region of cells.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_mask_report {
    /// sizeof(gusset_mask_report).
    pub struct_size: usize,
    /// Number of cells.
    pub cells: u64,
    /// Most cells in a shortest chain; 0 without cells, UINT64_MAX if disconnected.
    pub integer_diameter: u64,
    /// Vertices - edges + cells: 1 for a connected region without holes.
    pub euler: i64,
    /// Bound of the distance of two points: integer_diameter times a cell's greatest Euclidean
    /// diameter; infinite if disconnected.
    pub diameter: f64,
}

versioned! { gusset_mask_report: 40 }

/// Reads the caller's region; NULL means all cells.
fn read_region(sheet: &Sheet<'_>, words: *const u64, count: usize) -> Result<CellMask, Failure> {
    let lattice = CellGridShape::new(sheet);
    if words.is_null() && count == 0 {
        return Ok(CellMask::full(lattice)?);
    }
    Ok(CellMask::from_words(lattice, &input::copy_input_items(words, count, "words")?)?)
}

/// Reads the row and column of a cell.
fn read_cell(pointer: *const u32, name: &'static str) -> Result<[usize; 2], Failure> {
    let bytes = input::input_bytes(pointer.cast(), 2, 4, name)?;
    Ok(bytemuck::pod_read_unaligned::<[u32; 2]>(bytes).map(|k| k as usize))
}

/// Finds a shortest chain of cells in a region, in which neighbours share a node.
///
/// The sum of their diameters bounds the distance of points of the end cells.
///
/// @param words a bit a cell: cell (i, j) is bit k % 64 of word k / 64, k = i * columns + j. NULL
///     with count 0: all cells.
/// @param count at least the words of all cells.
/// @param from row and column in the region.
/// @param to likewise.
/// @param cells receives row and column of each cell, from and to included.
/// @param capacity in cells.
/// @param written receives the number of cells; 0 without a chain.
/// @errors COUNT_DIFFERS (too few words), NO_SUCH_ELEMENT (cell), BUFFER_TOO_SMALL
/// @complexity O(cells).
/// @source Leus, eq. (3).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_mask_chain(
    context: *const gusset_context,
    sheet: *const gusset_sheet,
    words: *const u64,
    count: usize,
    from: *const u32,
    to: *const u32,
    cells: *mut u32,
    capacity: usize,
    written: *mut usize,
) -> gusset_status {
    let written = input::cleared_output(written, 0, "written");
    guard_changing_call(context, |job| {
        let (written, region) = (written?, read_region(sheet_of_handle(sheet)?, words, count)?);
        let [from, to] = [read_cell(from, "from")?, read_cell(to, "to")?];
        let found = shortest_chain(&region, from, to, job)?.unwrap_or_default();
        write_pairs((cells, capacity, "cells"), (found.len(), found.into_iter()), written, job)
    })
}

/// Measures a region.
///
/// @param words as for gusset_sheet_mask_chain.
/// @complexity O(cells) for compact regions, at worst O(cells^2).
/// @source Leus, eqs. (4) to (6).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_mask_measure(
    context: *const gusset_context,
    sheet: *const gusset_sheet,
    words: *const u64,
    count: usize,
    report: *mut gusset_mask_report,
) -> gusset_status {
    answer_into_struct(context, (report, "report"), |job| {
        let sheet = sheet_of_handle(sheet)?;
        let region = read_region(sheet, words, count)?;
        let sizes = Diameters::new(sheet, &job.sub_job(0.0, 0.4))?.euclidean;
        let euler = euler_characteristic(&region, &job.sub_job(0.4, 0.5))?;
        let integer = integer_diameter(&region, &job.sub_job(0.5, 1.0))?;
        Ok(gusset_mask_report {
            struct_size: 0,
            cells: region.count() as u64,
            integer_diameter: integer.map_or(u64::MAX, |cells| cells as u64),
            euler,
            diameter: integer.map_or(Ok(f64::INFINITY), |cells| sizes.region_bound(&region, cells))?,
        })
    })
}

/// Lists the cells or nodes of a region, row after row.
///
/// Each node is listed once; a closing line counts as the first.
///
/// @param words as for gusset_sheet_mask_chain.
/// @param domain faces: cells; vertices or corners: nodes.
/// @param elements receives row and column of each.
/// @param capacity in elements.
/// @errors COUNT_DIFFERS (too few words), BUFFER_TOO_SMALL
/// @complexity O(cells / 64 + cells listed); O(nodes) for nodes.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_mask_elements(
    context: *const gusset_context,
    sheet: *const gusset_sheet,
    words: *const u64,
    count: usize,
    domain: gusset_domain,
    elements: *mut u32,
    capacity: usize,
    written: *mut usize,
) -> gusset_status {
    let written = input::cleared_output(written, 0, "written");
    guard_changing_call(context, |job| {
        let (written, region, out) =
            (written?, read_region(sheet_of_handle(sheet)?, words, count)?, (elements, capacity, "elements"));
        match read_choice(domain)? {
            Domain::Faces => write_pairs(out, (region.count(), region.cells()), written, job),
            Domain::Vertices | Domain::Corners => {
                write_pairs(out, (region.nodes().count(), region.nodes()), written, job)
            }
        }
    })
}

/// Writes rows and columns to the caller's buffer.
fn write_pairs(
    (out, capacity, name): (*mut u32, usize, &'static str),
    (count, all): (usize, impl Iterator<Item = [usize; 2]>),
    written: &mut usize,
    job: &Job<'_>,
) -> Result<(), Failure> {
    fill_buffer((out.cast::<[u32; 2]>(), capacity, name), count, written, job, || {
        Ok(all.map(|pair| pair.map(|k| k as u32)))
    })
}
