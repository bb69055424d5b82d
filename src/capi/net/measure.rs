//! Measures of nets: Area, volume, moments, planarity.

use crate::capi::context::{answer_into_struct, guard_changing_call, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input;
use crate::capi::net::{gusset_net, net_of_handle};
use crate::capi::status::{Failure, gusset_status};
use crate::net::measure::{bilinear_area, measure, moments, planarity};

/// Measures to compute.
/// @bits
pub type gusset_net_measures = u32;
/// area, volume, area_vector, low, high.
pub const GUSSET_NET_MEASURES_EXTENT: gusset_net_measures = 1;
/// bilinear_area, bilinear_error; about ten times the cost.
pub const GUSSET_NET_MEASURES_BILINEAR: gusset_net_measures = 2;
/// body_volume, centroid, inertia; about ten times the cost.
pub const GUSSET_NET_MEASURES_BODY: gusset_net_measures = 4;

/// Measures of a net; 0 unless requested.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_net_measure_report {
    /// sizeof(gusset_net_measure_report).
    pub struct_size: usize,
    /// Sum of |(c - a) x (d - b)| / 2 for cells a, b, c, d; exact if planar.
    pub area: f64,
    /// Enclosed volume of a closed two-sided net, positive if normals point outwards; else of the
    /// cone to the first node.
    pub volume: f64,
    /// Sum of the cells' area vectors; 0 for closed nets.
    pub area_vector: [f64; 3],
    /// Smallest coordinates; infinite if all nodes are missing.
    pub low: [f64; 3],
    /// Largest coordinates, likewise.
    pub high: [f64; 3],
    /// Area of the cells' bilinear patches, up to rounding; above area unless cells are planar. All
    /// layers of folds count.
    pub bilinear_area: f64,
    /// Bound of bilinear_area's error.
    pub bilinear_error: f64,
    /// Volume of the body in a closed net, negative if normals point inwards.
    pub body_volume: f64,
    /// Centroid of the body; NaN if its volume is 0.
    pub centroid: [f64; 3],
    /// Inertia tensor about the centroid, density 1. Diagonal: integrals of y^2 + z^2 etc.; else of
    /// -x y etc.
    /// @shape 3 3
    pub inertia: [f64; 9],
}

/// Planarity of cells.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_planarity_report {
    /// sizeof(gusset_net_planarity_report).
    pub struct_size: usize,
    /// Largest deviation of a cell; 0 without cells.
    pub worst: f64,
    /// Its cell; UINT64_MAX without cells.
    pub worst_cell: u64,
    /// Mean deviation; NaN without cells.
    pub mean: f64,
    /// Cells above the tolerance.
    pub above: u64,
}

versioned! {
    gusset_net_measure_report: 216,
    gusset_net_planarity_report: 40,
}

/// Measures a net.
///
/// Absent cells do not count. Volumes, centroid and inertia are exact for bilinear cells, up to
/// rounding. If powers of coordinates overflow (about 1e77), results are infinite or NaN.
///
/// @complexity O(nodes); no memory.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_measure(
    context: *const gusset_context,
    net: *const gusset_net,
    measures: gusset_net_measures,
    report: *mut gusset_net_measure_report,
) -> gusset_status {
    answer_into_struct(context, (report, "report"), |job| {
        let net = net_of_handle(net)?;
        if measures > 7 {
            return Err(Failure::unknown_value("measures", measures.into(), "a sum of GUSSET_NET_MEASURE_ constants"));
        }
        let wanted = |which: gusset_net_measures| measures & which != 0;
        let mut report = gusset_net_measure_report::default();
        if wanted(GUSSET_NET_MEASURES_EXTENT) {
            let found = measure(net, &job.sub_job(0.0, 0.1))?;
            (report.area, report.volume) = (found.area, found.volume);
            report.area_vector = found.area_vector.to_array();
            (report.low, report.high) = (found.low.to_array(), found.high.to_array());
        }
        if wanted(GUSSET_NET_MEASURES_BILINEAR) {
            let found = bilinear_area(net, &job.sub_job(0.1, 0.6))?;
            (report.bilinear_area, report.bilinear_error) = (found.area, found.error_bound);
        }
        if wanted(GUSSET_NET_MEASURES_BODY) {
            let found = moments(net, &job.sub_job(0.6, 1.0))?;
            (report.body_volume, report.centroid) = (found.volume, found.centroid.to_array());
            // The matrix is symmetric, so rows equal columns.
            report.inertia = found.inertia.to_cols_array();
        }
        Ok(report)
    })
}

/// Measures the planarity of cells.
///
/// A cell's deviation is its corners' distance from their mean plane divided by the longer
/// diagonal; 0 for triangles and less, NaN if absent.
///
/// @param tolerance for above.
/// @param cells receives each cell's deviation.
/// @errors BUFFER_TOO_SMALL, OUT_OF_RANGE (tolerance)
/// @complexity O(nodes); 8 bytes a cell.
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
    let (written, report) = (input::cleared_output(written, 0, "written"), input::output_struct(report, "report"));
    guard_changing_call(context, |job| {
        let (written, report) = (written?, report?);
        let found = planarity(net_of_handle(net)?, tolerance, job)?;
        input::copy_to_buffer((cells, capacity, "cells"), &found.cells, written, job)?;
        report.write_known_fields(gusset_net_planarity_report {
            struct_size: 0,
            worst: found.worst.map_or(0.0, |(off, _)| off),
            worst_cell: found.worst.map_or(u64::MAX, |(_, cell)| cell.into()),
            mean: found.mean,
            above: found.above,
        });
        Ok(())
    })
}
