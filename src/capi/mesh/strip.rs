//! Strips: Joins two polylines without a mesh.
//!
//! @source H. Fuchs, Z. Kedem and S. Uselton (1977); Nesterenko.

use crate::capi::context::{create_handle, gusset_context};
use crate::capi::glue::{constants, versioned};
use crate::capi::input::{self, lend_list, read_choice, read_flag};
use crate::capi::mesh::facing::read_loop_points;
use crate::capi::mesh::gusset_indices;
use crate::capi::mesh::result::{OperationResult, gusset_result, report};
use crate::capi::mesh::stitch_options::{
    GUSSET_START_AUTO, GUSSET_START_CLOSEST, GUSSET_START_GIVEN, gusset_meridians, gusset_row_rule, gusset_strip_cells,
    gusset_strip_search, gusset_strip_start, to_rows,
};
use crate::capi::status::{Failure, gusset_status};
use crate::stitch::{RuledOptions, Start, ruled};

/// Options of gusset_strip.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_strip_options {
    /// sizeof(gusset_strip_options).
    pub struct_size: usize,
    /// Rule for the meridians.
    pub meridians: gusset_meridians,
    /// Search effort.
    pub search: gusset_strip_search,
    /// First meridian of a closed strip; open ones start at their first points.
    pub start: gusset_strip_start,
    /// 1 if the polylines are closed.
    /// @flag
    pub closed: u32,
    /// Number of interior rows.
    pub rows: gusset_row_rule,
    /// Interior rows.
    /// @when rows GUSSET_ROWS_COUNT
    pub row_count: u32,
    /// Faces of the strip.
    pub cells: gusset_strip_cells,
    /// 0.
    pub reserved: u32,
}

/// Parts of a strip.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_strip_report {
    /// sizeof(gusset_strip_report).
    pub struct_size: usize,
    /// Points of A and B that the first meridian joins.
    pub start: [u32; 2],
    /// As in gusset_stitch_report, from start on: to (N, M) if closed, else to (N - 1, M - 1).
    /// @shape * 2
    pub meridians: gusset_indices,
    /// The matrix P, as in gusset_stitch_report.
    /// @shape row_count+2 *
    pub matrix: gusset_indices,
    /// Ends on A and B of each new vertex's meridian.
    /// @shape * 2
    pub parents: gusset_indices,
    /// Weight of each second parent, 0 to 1: k / (r + 1) in row k of r.
    /// @shape parents
    pub weights: *const f64,
    /// As in gusset_stitch_report; 0 without a face.
    pub row_count: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_strip_options: 40 reserved, gusset_strip_report: 80 }

impl gusset_strip_options {
    fn checked(self) -> Result<(bool, RuledOptions), Failure> {
        let start = match self.start {
            GUSSET_START_AUTO => Some(Start::Auto),
            GUSSET_START_CLOSEST => Some(Start::Closest),
            GUSSET_START_GIVEN => None,
            other => {
                return Err(Failure::unknown_choice(
                    "start",
                    other,
                    &constants![GUSSET_START_AUTO, GUSSET_START_CLOSEST, GUSSET_START_GIVEN],
                ));
            }
        };
        let closed = read_flag(self.closed, "closed")?;
        let (meridians, search) = (read_choice(self.meridians)?, read_choice(self.search)?);
        let (rows, cells) = (to_rows(self.rows, self.row_count)?, read_choice(self.cells)?);
        Ok((closed, RuledOptions { meridians, search, start, rows, cells }))
    }
}

/// Builds a strip, as gusset_stitch does between rims.
///
/// The mesh has the points of A, of B, then new ones row by row. Faces run A_i+1, A_i, B_j: against
/// A, along B.
///
/// @param points_a count_a points in order, at least 1; if closed at least 3, the first not
///     repeated.
/// @param points_b as points_a.
/// @errors LOOP_TOO_SHORT, TOO_LARGE, NOT_FINITE, NO_STRIP
/// @complexity Meridians as in gusset_stitch, plus linear in the mesh; likewise memory.
/// @source Nesterenko, the intermediate mesh (H, P); Fuchs, Kedem and Uselton (1977) for the best
///     strips.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_strip(
    context: *const gusset_context,
    points_a: *const f64,
    count_a: usize,
    points_b: *const f64,
    count_b: usize,
    options: *const gusset_strip_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create_handle(context, result, "result", |job| {
        let (closed, options) = input::read_versioned_struct(options, true, "options")?.checked()?;
        let a = read_loop_points(points_a, count_a, "points_a")?;
        let b = read_loop_points(points_b, count_b, "points_b").map_err(|failure| failure.with_input(1))?;
        Ok(gusset_result(OperationResult::Strip(ruled(&a, &b, closed, &options, job)?)))
    })
}

/// Lends the report.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_strip(
    result: *const gusset_result,
    report: *mut gusset_strip_report,
) -> gusset_status {
    report!(result, report, "gusset_strip", OperationResult::Strip(done) => gusset_strip_report {
        struct_size: size_of::<gusset_strip_report>(),
        start: done.start,
        meridians: gusset_indices::lend_indices(done.meridians.as_flattened()),
        matrix: gusset_indices::lend_indices(&done.matrix),
        parents: gusset_indices::lend_indices(done.parents.as_flattened()),
        weights: lend_list(&done.weights),
        row_count: done.rows,
        reserved: 0,
    })
}
