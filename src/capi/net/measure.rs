//! Measures of nets: Area, volume, moments, planarity.

use crate::capi::context::{answer_struct, guard_change, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input;
use crate::capi::net::{gusset_net, read};
use crate::capi::status::{Failure, gusset_status};
use crate::net::measure::{bilinear_area, measure, moments, planarity};

/// The parts of gusset_net_measure_report that are computed: a sum of these.
/// @bits
pub type gusset_net_measures = u32;
/// area, volume, area_vector, low and high.
pub const GUSSET_NET_MEASURES_EXTENT: gusset_net_measures = 1;
/// bilinear_area and bilinear_error; about ten times the work.
pub const GUSSET_NET_MEASURES_BILINEAR: gusset_net_measures = 2;
/// body_volume, centroid and inertia; about ten times the work.
pub const GUSSET_NET_MEASURES_BODY: gusset_net_measures = 4;

/// The measures of a net; 0 for those that are not asked for.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_net_measure_report {
    /// sizeof(gusset_net_measure_report), set by the caller.
    pub struct_size: usize,
    /// The area of all cells: of each, |(c - a) x (d - b)| / 2, which is exact for plane ones; for
    /// others see bilinear_area.
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
    /// The area of the bilinear patches of all cells, to rounding: on cells that are not plane more
    /// than `area`. A patch that is folded over itself counts with all its sheets.
    pub bilinear_area: f64,
    /// A bound of the error of bilinear_area.
    pub bilinear_error: f64,
    /// The volume of the body, of density 1, that a closed net encloses; negative if the normals look
    /// inwards.
    pub body_volume: f64,
    /// The centre of mass of the body; NaN if its volume is 0.
    pub centroid: [f64; 3],
    /// The tensor of inertia of the body about its centroid, row after row: on the diagonal the
    /// integrals of y^2 + z^2 and so on, beside it those of -x y and so on.
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
    gusset_net_measure_report: 216,
    gusset_net_planarity_report: 40,
}

/// Measures a net: areas, volumes, box, centroid, inertia.
///
/// Cells that touch a missing node or belong to a hidden bridge are not there. Volumes, centroid and
/// inertia are exact but for rounding for the bilinear patches of the cells (divergence theorem).
/// Where squares or cubes of coordinates overflow, beyond about 1e77, results are infinite or NaN.
///
/// @param measures only these are computed.
/// @param report its struct_size set.
/// @errors UNKNOWN_VALUE (measures)
/// @complexity O(nodes), no memory.
/// @threads From any thread; the same bits for any number of threads.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_measure(
    context: *const gusset_context,
    net: *const gusset_net,
    measures: gusset_net_measures,
    report: *mut gusset_net_measure_report,
) -> gusset_status {
    answer_struct(context, (report, "report"), |job| {
        let net = read(net)?;
        if measures > 7 {
            return Err(Failure::unknown("measures", measures.into()));
        }
        let wanted = |which: gusset_net_measures| measures & which != 0;
        let mut report = gusset_net_measure_report::default();
        if wanted(GUSSET_NET_MEASURES_EXTENT) {
            let found = measure(net, &job.part(0.0, 0.1))?;
            (report.area, report.volume) = (found.area, found.volume);
            report.area_vector = found.area_vector.to_array();
            (report.low, report.high) = (found.low.to_array(), found.high.to_array());
        }
        if wanted(GUSSET_NET_MEASURES_BILINEAR) {
            let found = bilinear_area(net, &job.part(0.1, 0.6))?;
            (report.bilinear_area, report.bilinear_error) = (found.area, found.error);
        }
        if wanted(GUSSET_NET_MEASURES_BODY) {
            let found = moments(net, &job.part(0.6, 1.0))?;
            (report.body_volume, report.centroid) = (found.volume, found.centroid.to_array());
            // Symmetrical: rows are columns.
            report.inertia = found.inertia.to_cols_array();
        }
        Ok(report)
    })
}

/// Tells how plane the cells of a net are: whether it can be clad with plane quads.
///
/// @param tolerance at least 0, for the count in the report.
/// @param cells a buffer for (rows - 1) * (columns - 1) numbers: of each cell, how far its corners
///     are from the plane that lies evenly between them, as a part of its longer diagonal; 0 for
///     triangles and less, NaN for cells that are not there.
/// @param capacity its size; NULL and 0 if it is not wanted.
/// @param written receives the number of cells.
/// @param report its struct_size set.
/// @errors BUFFER_TOO_SMALL, OUT_OF_RANGE (tolerance)
/// @complexity O(nodes), 8 bytes a cell.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_planarity(
    context: *const gusset_context,
    net: *const gusset_net,
    tolerance: f64,
    cells: *mut f64,
    capacity: usize,
    written: *mut usize,
    report: *mut gusset_net_planarity_report,
) -> gusset_status {
    let (written, report) = (input::output(written, 0, "written"), input::output_struct(report, "report"));
    guard_change(context, |job| {
        let (written, report) = (written?, report?);
        let found = planarity(read(net)?, tolerance, job)?;
        input::copy((cells, capacity, "cells"), &found.cells, written, job)?;
        report.write(gusset_net_planarity_report {
            struct_size: 0,
            worst: found.worst.map_or(0.0, |(off, _)| off),
            worst_cell: found.worst.map_or(u64::MAX, |(_, cell)| cell.into()),
            mean: found.mean,
            above: found.above,
        });
        Ok(())
    })
}
