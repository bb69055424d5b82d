//! C interface: areas, volumes, moments and planarity of nets.

use crate::capi::context::{answer_struct, guard_change, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input;
use crate::capi::net::{gusset_net, read};
use crate::capi::status::gusset_status;
use crate::net::measure::{bilinear_area, measure, moments, planarity};

/// What gusset_net_measure finds.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_measure_report {
    /// sizeof(gusset_net_measure_report), set by the caller.
    pub struct_size: usize,
    /// The area of all cells: of each, |(c - a) x (d - b)| / 2, which is exact for plane ones; for
    /// others see gusset_net_bilinear_area.
    pub area: f64,
    /// What the net encloses, if it is closed and has two sides; positive if the normals look
    /// outwards. For open ones: of the cone to the first node.
    pub volume: f64,
    /// The sum of the cells' area vectors; 0 for closed nets.
    pub area_vector: [f64; 3],
    /// The smallest coordinates of the nodes that are there; infinite if there are none.
    pub low: [f64; 3],
    /// The largest.
    pub high: [f64; 3],
}

/// The body, of density 1, that a closed net encloses.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_moment_report {
    /// sizeof(gusset_net_moment_report), set by the caller.
    pub struct_size: usize,
    /// The volume; negative if the normals look inwards.
    pub volume: f64,
    /// The centre of mass; NaN if the volume is 0.
    pub centroid: [f64; 3],
    /// The tensor of inertia about it, row after row: on the diagonal the integrals of y^2 + z^2
    /// and so on, beside it those of -x y and so on.
    pub inertia: [f64; 9],
}

/// How plane the cells of a net are.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_planarity_report {
    /// sizeof(gusset_net_planarity_report), set by the caller.
    pub struct_size: usize,
    /// The largest distance of corners from the plane between them, as a part of the longer
    /// diagonal; 0 if there are no cells.
    pub worst: f64,
    /// Its cell; 2^64 - 1 if there are no cells.
    pub worst_cell: u64,
    /// The mean; NaN if there are no cells.
    pub mean: f64,
    /// How many cells are above the tolerance.
    pub above: u64,
}

versioned! {
    gusset_net_measure_report: 96,
    gusset_net_moment_report: 112,
    gusset_net_planarity_report: 40,
}

/// Measures a net: area, volume, box.
///
/// Cells that touch a missing node or belong to a hidden bridge are not there. Volumes are exact
/// for the bilinear patches of the cells (divergence theorem). Where squares or cubes of coordinates
/// overflow, beyond about 1e77, results are infinite or NaN.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param[out] measures its struct_size set.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     OUT_OF_MEMORY, CANCELLED.
/// @complexity O(nodes), no memory.
/// @threads From any thread; the same bits for any number of threads.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_measure(
    context: *const gusset_context,
    net: *const gusset_net,
    measures: *mut gusset_net_measure_report,
) -> gusset_status {
    answer_struct(context, (measures, "measures"), |job| {
        let found = measure(read(net)?, job)?;
        Ok(gusset_net_measure_report {
            struct_size: 0,
            area: found.area,
            volume: found.volume,
            area_vector: found.area_vector.to_array(),
            low: found.low.to_array(),
            high: found.high.to_array(),
        })
    })
}

/// Computes the area of the bilinear patches of all cells of a net, to rounding: on cells that are
/// not plane more than that of gusset_net_measure.
///
/// Cells that are not there do not count; a patch that is folded over itself counts with all its
/// sheets.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param[out] area receives the area.
/// @param[out] error receives a bound of its error; may be NULL.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(nodes), some ten times the work of gusset_net_measure; no memory.
/// @threads From any thread; the same bits for any number of threads.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_bilinear_area(
    context: *const gusset_context,
    net: *const gusset_net,
    area: *mut f64,
    error: *mut f64,
) -> gusset_status {
    let (area, error) = (input::output(area, 0.0, "area"), input::optional_output(error, 0.0, "error"));
    guard_change(context, |job| {
        let (area, error) = (area?, error?);
        let found = bilinear_area(read(net)?, job)?;
        job.memory()?;
        *area = found.area;
        input::set(error, found.error);
        Ok(())
    })
}

/// Computes volume, centroid and tensor of inertia of the body that a closed net encloses, exactly
/// but for rounding for the bilinear patches of its cells.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param[out] moments its struct_size set.
/// @return GUSSET_OK, or an error: those of gusset_net_measure, and about ten times the work.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_moments(
    context: *const gusset_context,
    net: *const gusset_net,
    moments: *mut gusset_net_moment_report,
) -> gusset_status {
    answer_struct(context, (moments, "moments"), |job| {
        let found = self::moments(read(net)?, job)?;
        Ok(gusset_net_moment_report {
            struct_size: 0,
            volume: found.volume,
            centroid: found.centroid.to_array(),
            // Symmetrical: rows are columns.
            inertia: found.inertia.to_cols_array(),
        })
    })
}

/// Tells how plane the cells of a net are: whether it can be clad with plane quads.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param tolerance at least 0, for the count in the summary.
/// @param[out] cells a buffer for (rows - 1) * (columns - 1) numbers: of each cell, how far its
///     corners are from the plane that lies evenly between them, as a part of its longer diagonal;
///     0 for triangles and less, NaN for cells that are not there.
/// @param capacity its size; NULL and 0 if it is not wanted.
/// @param[out] written receives the number of cells.
/// @param[out] summary its struct_size set.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     BUFFER_TOO_SMALL, OUT_OF_RANGE (tolerance), OUT_OF_MEMORY, CANCELLED.
/// @complexity O(nodes), 8 bytes a cell.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_planarity(
    context: *const gusset_context,
    net: *const gusset_net,
    tolerance: f64,
    cells: *mut f64,
    capacity: usize,
    written: *mut usize,
    summary: *mut gusset_net_planarity_report,
) -> gusset_status {
    let (written, summary) = (input::output(written, 0, "written"), input::output_struct(summary, "summary"));
    guard_change(context, |job| {
        let (written, summary) = (written?, summary?);
        let found = planarity(read(net)?, tolerance, job)?;
        input::copy((cells, capacity, "cells"), &found.cells, written, job)?;
        summary.write(gusset_net_planarity_report {
            struct_size: 0,
            worst: found.worst.map_or(0.0, |(off, _)| off),
            worst_cell: found.worst.map_or(u64::MAX, |(_, cell)| cell.into()),
            mean: found.mean,
            above: found.above,
        });
        Ok(())
    })
}
