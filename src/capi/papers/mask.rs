//! Regions of cells: Masks of cells: chains, diameters, cells and nodes.
//!
//! @source Leus.

use crate::attributes::Domain;
use crate::capi::context::{answer_struct, guard_change, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, choice, fill};
use crate::capi::mesh::origins::gusset_domain;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::sheet::{gusset_sheet, read};
use crate::job::Job;
use crate::surface::Sheet;
use crate::surface::reference::{CellMask, Diameters, Lattice, chain, euler_characteristic, integer_diameter};

/// Measures of a region of cells.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_mask_report {
    /// sizeof(gusset_mask_report), set by the caller.
    pub struct_size: usize,
    /// How many cells it has.
    pub cells: u64,
    /// The number of cells of the longest of the shortest chains between two of its cells; 0 for no
    /// cells, 2^64 - 1 if the region is in several parts.
    pub integer_diameter: u64,
    /// Vertices less edges plus cells: 1 for a region in one part without holes.
    pub euler: i64,
    /// No two points of the region are farther apart: the integer diameter times the greatest
    /// Euclidean diameter of its cells; infinite if the region is in several parts.
    pub diameter: f64,
}

versioned! { gusset_mask_report: 40 }

/// The caller's region; NULL for all cells.
fn region(sheet: &Sheet<'_>, words: *const u64, count: usize) -> Result<CellMask, Failure> {
    let lattice = Lattice::of(sheet);
    if words.is_null() && count == 0 {
        return Ok(CellMask::full(lattice)?);
    }
    Ok(CellMask::from_words(lattice, &input::list(words, count, "words")?)?)
}

/// Row and column of a cell.
fn cell(pointer: *const u32, name: &'static str) -> Result<[usize; 2], Failure> {
    let bytes = input::bytes(pointer.cast(), 2, 4, name)?;
    Ok(bytemuck::pod_read_unaligned::<[u32; 2]>(bytes).map(|k| k as usize))
}

/// A shortest chain of cells of a region from one cell to another: consecutive ones have a node in
/// common, across corners too.
///
/// The sum of their diameters bounds the distance between points of from and of to.
///
/// @param words the region, at any alignment, a bit for each cell: that of cell (i, j) is bit k %
///     64 of word k / 64, k = i * columns + j, columns of cells; NULL with count 0 for all cells.
/// @param count the words, at least as many as the cells need.
/// @param from row and column of a cell of the region, two numbers, at any alignment.
/// @param to the same of the other cell.
/// @param cells receives row and column of each cell of the chain, from and to included, two
///     numbers each; NULL with capacity 0 to ask for the size.
/// @param capacity how many cells it has room for.
/// @param written receives the number of cells, the integer length; 0 if there is no chain.
/// @errors SIZE_OVERFLOW (too few words), NO_SUCH_ELEMENT (with the cell), BUFFER_TOO_SMALL
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
    let written = input::output(written, 0, "written");
    guard_change(context, |job| {
        let (written, region) = (written?, region(read(sheet)?, words, count)?);
        let [from, to] = [cell(from, "from")?, cell(to, "to")?];
        let found = chain(&region, from, to, job)?.unwrap_or_default();
        pairs((cells, capacity, "cells"), (found.len(), found.into_iter()), written, job)
    })
}

/// Measures a region of cells: its integer diameter and with it a bound of its diameter, and its
/// Euler characteristic.
///
/// @param words the region, as for gusset_sheet_mask_chain.
/// @param count the region, as for gusset_sheet_mask_chain.
/// @param report struct_size set by the caller; all else is overwritten.
/// @complexity O(cells) for compact regions; for the worst O(cells^2), which can be cancelled.
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
    answer_struct(context, (report, "report"), |job| {
        let sheet = read(sheet)?;
        let region = region(sheet, words, count)?;
        let sizes = Diameters::new(sheet, &job.part(0.0, 0.4))?.euclidean;
        let euler = euler_characteristic(&region, &job.part(0.4, 0.5))?;
        let integer = integer_diameter(&region, &job.part(0.5, 1.0))?;
        Ok(gusset_mask_report {
            struct_size: 0,
            cells: region.count() as u64,
            integer_diameter: integer.map_or(u64::MAX, |cells| cells as u64),
            euler,
            diameter: integer.map_or(Ok(f64::INFINITY), |cells| sizes.of_region(&region, cells))?,
        })
    })
}

/// Lists the cells or the nodes of a mask, row after row. Its nodes are the corners of its cells, each
/// once; lines that close the sheet count as the first ones.
///
/// @param words the mask, as for gusset_sheet_mask_chain.
/// @param count the mask, as for gusset_sheet_mask_chain.
/// @param domain faces are the cells, vertices and corners the nodes.
/// @param elements receives row and column of each, two numbers each; NULL with capacity 0 to ask
///     for the size.
/// @param capacity how many elements it has room for.
/// @param written receives the number of elements.
/// @errors SIZE_OVERFLOW (too few words), BUFFER_TOO_SMALL
/// @complexity O(cells / 64), and the cells of the mask; O(nodes) for nodes.
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
    let written = input::output(written, 0, "written");
    guard_change(context, |job| {
        let (written, region, out) = (written?, region(read(sheet)?, words, count)?, (elements, capacity, "elements"));
        match choice(domain)? {
            Domain::Faces => pairs(out, (region.count(), region.cells()), written, job),
            Domain::Vertices | Domain::Corners => pairs(out, (region.nodes().count(), region.nodes()), written, job),
        }
    })
}

/// Writes rows and columns to the caller's buffer.
fn pairs(
    (out, capacity, name): (*mut u32, usize, &'static str),
    (count, all): (usize, impl Iterator<Item = [usize; 2]>),
    written: &mut usize,
    job: &Job<'_>,
) -> Result<(), Failure> {
    fill((out.cast::<[u32; 2]>(), capacity, name), count, written, job, || Ok(all.map(|pair| pair.map(|k| k as u32))))
}
