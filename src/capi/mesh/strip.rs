//! Strips: Builds a strip of triangles between two polylines that belong to no mesh.
//!
//! @source H. Fuchs, Z. Kedem and S. Uselton (1977); Nesterenko.

use crate::capi::context::{create, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, choice, flag, lent};
use crate::capi::mesh::facing::points;
use crate::capi::mesh::gusset_indices;
use crate::capi::mesh::result::{Made, gusset_result, report};
use crate::capi::mesh::stitch_options::{
    GUSSET_START_AUTO, GUSSET_START_CLOSEST, GUSSET_START_GIVEN, gusset_meridians, gusset_row_rule, gusset_strip_cells,
    gusset_strip_search, gusset_strip_start, rows,
};
use crate::capi::status::{Failure, gusset_status};
use crate::stitch::{RuledOptions, Start, ruled};

/// How a strip is made; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_strip_options {
    /// sizeof(gusset_strip_options), set by the caller.
    pub struct_size: usize,
    /// The rule that chooses meridians.
    pub meridians: gusset_meridians,
    /// The effort of the search for the best strip.
    pub search: gusset_strip_search,
    /// For closed polylines; open ones begin at their first points.
    pub start: gusset_strip_start,
    /// 1: the polylines are closed; 0: they are open.
    /// @flag
    pub closed: u32,
    /// The mean edge is the mean segment of both polylines.
    pub rows: gusset_row_rule,
    /// Interior rows, read for GUSSET_ROWS_COUNT.
    /// @when rows GUSSET_ROWS_COUNT
    pub row_count: u32,
    /// The faces of strips.
    pub cells: gusset_strip_cells,
    /// 0.
    pub reserved: u32,
}

/// The parts of a strip. Pointers are valid until the result is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_strip_report {
    /// sizeof(gusset_strip_report), set by the caller.
    pub struct_size: usize,
    /// The points of A and of B that the first meridian joins.
    pub start: [u32; 2],
    /// The meridians as places counted from there, i and j by turns: from (0, 0) to (N, M) for
    /// closed polylines of N and M points, where place N is place 0 again, and to (N - 1, M - 1)
    /// for open ones; count is twice the number of meridians.
    pub meridians: gusset_indices,
    /// The paper's matrix P, row by row from A to B, one column for each meridian: vertices of the
    /// mesh.
    pub matrix: gusset_indices,
    /// Of each new vertex (they are the last ones of the mesh), the two that it lies between, on A
    /// and on B, by turns: the ends of its meridian.
    pub parents: gusset_indices,
    /// Of each new vertex, the weight of its second parent, 0 to 1: in row k of r rows k / (r + 1).
    pub weights: *const f64,
    /// Interior rows; the matrix has two rows more. 0 where there is one meridian alone, and no
    /// face.
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
            other => return Err(Failure::unknown("start", other.into())),
        };
        let closed = flag(self.closed, "closed")?;
        let (meridians, search) = (choice(self.meridians)?, choice(self.search)?);
        let (rows, cells) = (rows(self.rows, self.row_count)?, choice(self.cells)?);
        Ok((closed, RuledOptions { meridians, search, start, rows, cells }))
    }
}

/// Makes a strip of faces between two polylines that run side by side, as gusset_stitch does
/// between two rims: the third, intermediate mesh alone.
///
/// The mesh has the points of A, 0 to N - 1, then those of B, then the new ones row by row. Faces run A_i+1, A_i, B_j:
/// against polyline A, and along B. Where both sides advance at once triangles split a quad by its shorter diagonal.
///
/// @param points_a x, y, z of the points in order, packed, count_a and count_b of them: at least 1
///     each, closed ones at least 3, and the last point is not the first again.
/// @param count_a see points_a.
/// @param points_b see points_a.
/// @param count_b see points_a.
/// @param options NULL for the defaults (open polylines).
/// @errors LOOP_TOO_SHORT, TOO_LARGE, NOT_FINITE, NO_STRIP
/// @complexity Time and memory of the meridians of gusset_stitch, and linear in the mesh.
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
    create(context, result, "result", |job| {
        let (closed, options) = input::read(options, true, "options")?.checked()?;
        let a = points(points_a, count_a, "points_a")?;
        let b = points(points_b, count_b, "points_b").map_err(|failure| failure.of_input(1))?;
        Ok(gusset_result(Made::Strip(ruled(&a, &b, closed, &options, job)?)))
    })
}

/// Lends the meridians and the matrix, for results of gusset_strip.
///
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_strip(
    result: *const gusset_result,
    report: *mut gusset_strip_report,
) -> gusset_status {
    report!(result, report, "gusset_strip", Made::Strip(done) => gusset_strip_report {
        struct_size: size_of::<gusset_strip_report>(),
        start: done.start,
        meridians: gusset_indices::lend(done.meridians.as_flattened()),
        matrix: gusset_indices::lend(&done.matrix),
        parents: gusset_indices::lend(done.parents.as_flattened()),
        weights: lent(&done.weights),
        row_count: done.rows,
        reserved: 0,
    })
}
