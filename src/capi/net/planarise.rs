//! Planar cells: Moves nodes until all cells are planar.

use crate::capi::context::{answer_into_struct, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, read_flag};
use crate::capi::net::{gusset_net, net_of_handle_mut};
use crate::capi::status::gusset_status;
use crate::error::Error;
use crate::net::planarise::{PlanariseOptions, planarise};
use gusset_base::alloc;

/// Options of gusset_net_planarise.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_planarise_options {
    /// sizeof(gusset_planarise_options).
    pub struct_size: usize,
    /// Distance of corners from their mean plane, relative to the box diagonal; 0: 1e-10, float:
    /// 4e-7.
    pub tolerance: f64,
    /// For each node, 1: it stays with all nodes glued to it. NULL: all may move.
    /// @shape fixed_count
    /// @flag
    pub fixed: *const u8,
    /// rows * columns; 0 with NULL.
    pub fixed_count: usize,
    /// Most steps; 0: 100.
    pub max_iterations: u32,
    /// 1: boundary vertices of the surface stay.
    /// @flag
    pub keep_boundary: u32,
}

/// Result of gusset_net_planarise.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_planarise_report {
    /// sizeof(gusset_planarise_report).
    pub struct_size: usize,
    /// Initial box diagonal.
    pub size: f64,
    /// Tolerance times size.
    pub tolerance: f64,
    /// Largest initial distance of corners from their mean plane.
    pub deviation_before: f64,
    /// Largest final distance.
    pub deviation_after: f64,
    /// Largest displacement of a point.
    pub max_displacement: f64,
    /// Root mean square displacement of all points of quads.
    pub rms_displacement: f64,
    /// Cell with deviation_after; UINT64_MAX without quads.
    pub worst_cell: u64,
    /// Steps; 0 if all cells were planar and no bit changed.
    pub iterations: u32,
    /// 1: deviation_after is within the tolerance.
    /// @flag
    pub converged: u32,
}

versioned! { gusset_planarise_options: 40, gusset_planarise_report: 72 }

/// Makes all cells planar, with locally least squared displacement.
///
/// Glued nodes stay one point. Absent cells, and those below four corners, do not count.
///
/// @errors OUT_OF_RANGE (tolerance), COUNT_DIFFERS (fixed_count too small)
/// @complexity O(n^1.5) time a step and O(n log n) memory for n cells.
/// @threads Uses one thread.
/// @source Deryagin, "Closures"; Liu et al. 2006.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_planarise(
    context: *const gusset_context,
    net: *mut gusset_net,
    options: *const gusset_planarise_options,
    report: *mut gusset_planarise_report,
) -> gusset_status {
    answer_into_struct(context, (report, "report"), |job| {
        let given = input::read_versioned_struct(options, true, "options")?;
        let net = net_of_handle_mut(net, job)?;
        let (needed, count) = (net.shape().node_count(), given.fixed_count);
        if !given.fixed.is_null() && count < needed {
            return Err(Error::ArrayTooShort { what: "fixed", needed: needed as u64, given: count as u64 }.into());
        }
        let count = if given.fixed.is_null() { count } else { needed };
        let bytes = input::input_bytes(given.fixed.cast(), count, 1, "fixed")?;
        let fixed: Vec<bool> = alloc::try_collect(bytes.iter().map(|&byte| read_flag(byte.into(), "fixed")))?;
        let options = PlanariseOptions {
            tolerance: given.tolerance,
            max_iterations: given.max_iterations,
            keep_boundary: read_flag(given.keep_boundary, "keep_boundary")?,
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
