//! Planar cells: Moves nodes as little as possible until cells are planar.

use crate::capi::context::{answer_struct, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, flag};
use crate::capi::net::{edit, gusset_net};
use crate::capi::status::gusset_status;
use crate::error::Error;
use crate::net::planarise::{PlanariseOptions, planarise};
use gusset_base::alloc;

/// How gusset_net_planarise works. All zeros: the defaults.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_planarise_options {
    /// sizeof(gusset_planarise_options), set by the caller.
    pub struct_size: usize,
    /// The distance of corners from their plane that is plane enough, as a part of the diagonal of
    /// the net's box; 0: 1e-10, or 4e-7 for coordinates of float.
    pub tolerance: f64,
    /// A byte for each node, 1 for one that stays with those glued to it and 0 for others; NULL:
    /// all may move.
    pub fixed: *const u8,
    /// The number of bytes: rows * columns; 0 with NULL.
    pub fixed_count: usize,
    /// The largest number of steps; 0: 100.
    pub max_iterations: u32,
    /// 1: vertices on the boundary of the surface stay.
    /// @flag
    pub keep_boundary: u32,
}

/// What gusset_net_planarise has done.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_planarise_report {
    /// sizeof(gusset_planarise_report), set by the caller.
    pub struct_size: usize,
    /// The diagonal of the net's box, before.
    pub size: f64,
    /// The distance that is plane enough: the tolerance times the size.
    pub tolerance: f64,
    /// The largest distance of the corners of a cell from the plane that lies evenly between them,
    /// before.
    pub deviation_before: f64,
    /// The same of the net as it is now.
    pub deviation_after: f64,
    /// The largest displacement of a point.
    pub max_displacement: f64,
    /// The root of the mean square of the displacements of all points of cells of four corners.
    pub rms_displacement: f64,
    /// The cell of deviation_after; 2^64 - 1 without cells of four corners.
    pub worst_cell: u64,
    /// The steps that were taken; 0 if all cells were plane, and then no bit has changed.
    pub iterations: u32,
    /// 1 if deviation_after is within the tolerance; else 0, and the net is as near as the steps
    /// came.
    pub converged: u32,
}

versioned! { gusset_planarise_options: 40, gusset_planarise_report: 72 }

/// Moves the nodes of a net as little as possible, in the sum of squares, so that all cells are
/// plane: facing by plane tiles.
///
/// Glued nodes stay one point. Cells of three corners and less, hidden ones and those with missing
/// nodes do not count. The result is a local least: no plane net near it is nearer to the given
/// one, but for the accuracy of the steps.
///
/// @param report receives what was done, its struct_size set; that the steps did not converge is no
///     error.
/// @errors OUT_OF_RANGE (tolerance), UNKNOWN_VALUE (keep_boundary, a byte of fixed), SIZE_OVERFLOW
///     (fixed_count is too small, the net is then unchanged)
/// @complexity For each step O(n^1.5) operations and O(n log n) memory for n cells.
/// @threads One thread; the same bits always.
/// @source Deryagin, "Closures"; Liu et al. 2006.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_planarise(
    context: *const gusset_context,
    net: *mut gusset_net,
    options: *const gusset_planarise_options,
    report: *mut gusset_planarise_report,
) -> gusset_status {
    answer_struct(context, (report, "report"), |job| {
        let given = input::read(options, true, "options")?;
        let net = edit(net, job)?;
        let (needed, count) = (net.shape().node_count(), given.fixed_count);
        if !given.fixed.is_null() && count < needed {
            return Err(Error::ArrayTooShort { what: "fixed", needed: needed as u64, given: count as u64 }.into());
        }
        let count = if given.fixed.is_null() { count } else { needed };
        let bytes = input::bytes(given.fixed.cast(), count, 1, "fixed")?;
        let fixed: Vec<bool> = alloc::try_collect(bytes.iter().map(|&byte| flag(byte.into(), "fixed")))?;
        let options = PlanariseOptions {
            tolerance: given.tolerance,
            max_iterations: given.max_iterations,
            keep_boundary: flag(given.keep_boundary, "keep_boundary")?,
            fixed: &fixed,
        };
        let done = planarise(net, &options, job)?;
        Ok(gusset_planarise_report {
            struct_size: 0,
            size: done.size,
            tolerance: done.tolerance,
            deviation_before: done.deviation_before,
            deviation_after: done.deviation_after,
            max_displacement: done.max_displacement,
            rms_displacement: done.rms_displacement,
            worst_cell: done.worst_cell.map_or(u64::MAX, u64::from),
            iterations: done.iterations,
            converged: done.converged.into(),
        })
    })
}
