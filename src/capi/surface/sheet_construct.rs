//! Other sheets: Sheets from patches, B-splines (NURBS included), nets of curves, frames, and
//! offsets. Memory is 384 bytes a cell up to degree 3, else 1536.

use crate::capi::context::{create_handle, create_handle_and_outputs, gusset_context};
use crate::capi::curve::frame::gusset_frame;
use crate::capi::curve::{gusset_curve, read_points};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::handle;
use crate::capi::input::{self, read_choice, read_flag};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::sheet::gusset_sheet;
use crate::curve::CurveView;
use crate::error::{Allowed, Error};
use crate::job::Job;
use crate::surface::construct::{CurveNet, FrameSurface, Spline, SplineAxis, SplineOptions};
use crate::surface::{MAX_DEGREE, Patches, Sheet};
use gusset_base::alloc;

/// How a surface is made from a frame.
pub type gusset_frame_surface = u32;
/// The curves across. Between equal sections, one straight behind the other, the surface is their
/// cylinder.
pub const GUSSET_FRAME_SECTIONS: gusset_frame_surface = 0;
/// A grid through the nodes, or GUSSET_FRAME_CURVES if curves have corners.
pub const GUSSET_FRAME_NODES: gusset_frame_surface = 1;
/// Gordon's surface, which contains all curves of the frame.
pub const GUSSET_FRAME_CURVES: gusset_frame_surface = 2;

/// A tensor-product B-spline, rational (NURBS) if its weights differ.
///
/// Knots do not decrease; inner ones may repeat degree times.
/// - Open: control points + degree + 1 knots, clamped or not; defined from knot degree to knot
///   count.
/// - Closed: control points + 1 knots, one period; control points are not repeated. Span k begins
///   at knot k and uses control points k - degree to k, cyclically.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_spline {
    /// sizeof(gusset_spline).
    pub struct_size: usize,
    /// Control points, not multiplied by weights, row after row; rows follow in u.
    pub points: *const f64,
    /// Rows of control points, more than degree_u.
    pub count_u: usize,
    /// Control points in a row, more than degree_v.
    pub count_v: usize,
    /// Knots in u.
    pub knots_u: *const f64,
    /// Number of knots.
    pub knot_count_u: usize,
    /// Knots in v.
    pub knots_v: *const f64,
    /// Number of knots.
    pub knot_count_v: usize,
    /// 1 to 7.
    pub degree_u: u32,
    /// 1 to 7.
    pub degree_v: u32,
    /// 1: closed in u.
    /// @flag
    pub closed_u: u32,
    /// 1: closed in v.
    /// @flag
    pub closed_v: u32,
    /// Above 0, at least 2^-900 of the greatest; NULL: all equal.
    pub weights: *const f64,
    /// Largest distance from a rational spline at equal parameters, at least about 1e-13 of the
    /// size. 0: 1e-12 of the controls' box diagonal, or more for rounding.
    /// @option
    pub tolerance: f64,
    /// Most cells of a rational spline; 0: 2^20.
    /// @option
    pub max_cells: usize,
}

/// A net of curves: each row meets each column. Curves have any orientation, and are sorted by the
/// places where they meet unless in order.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_curve_net {
    /// sizeof(gusset_curve_net).
    pub struct_size: usize,
    /// Curves in v, of degree 7 at most; without columns, ordered by u. A curve of one point is a
    /// pole.
    pub rows: *const *const gusset_curve,
    /// 0 (a skin of the columns), or at least 2, or 3 if closed_u.
    pub row_count: usize,
    /// Curves in u; without rows, ordered by v.
    pub columns: *const *const gusset_curve,
    /// 0 (a skin of the rows), or at least 2, or 3 if closed_v.
    pub column_count: usize,
    /// Largest distance of curves that meet; both move to the middle. 0: 1e-6 of the box diagonal.
    /// @option
    pub tolerance: f64,
    /// 1: columns are closed; the first row follows the last.
    /// @option
    /// @flag
    pub closed_u: u32,
    /// 1: rows are closed; the first column follows the last.
    /// @option
    /// @flag
    pub closed_v: u32,
}

versioned! { gusset_spline: 80, gusset_curve_net: 56 }

c_enum! { kind: FrameSurface {
    GUSSET_FRAME_SECTIONS => Sections, GUSSET_FRAME_NODES => Nodes, GUSSET_FRAME_CURVES => Curves
} }

/// Borrows the caller's curves.
fn curves_of_handles<'a>(
    handles: *const *const gusset_curve,
    count: usize,
    name: &'static str,
) -> Result<Vec<CurveView<'a>>, Failure> {
    let handles = handle::get_objects(handles, count, name)?;
    alloc::try_collect(handles.map(|handle| Ok(handle?.0.view())))
}

/// Makes a sheet from Bézier patches.
///
/// Neighbours should share sides. Repeated points and poles are allowed.
///
/// @param points patch after patch, row after row; (degree_u + 1) x (degree_v + 1) each, v fastest.
/// @param degree_u 1 to 7.
/// @param degree_v 1 to 7.
/// @param rows at least 1.
/// @param columns at least 1.
/// @errors OUT_OF_RANGE (degree), EMPTY_MESH (no patches), TOO_LARGE, NOT_FINITE
/// @complexity O(points).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_from_patches_create(
    context: *const gusset_context,
    points: *const f64,
    degree_u: u32,
    degree_v: u32,
    rows: usize,
    columns: usize,
    sheet: *mut *mut gusset_sheet,
) -> gusset_status {
    create_handle(context, sheet, "sheet", |_| {
        let degrees = [degree_u as usize, degree_v as usize];
        if let Some(&degree) = degrees.iter().find(|degree| !(1..=MAX_DEGREE).contains(*degree)) {
            return Err(Error::OptionOutOfRange {
                option: "degree",
                value: degree as f64,
                allowed: Allowed::from(1.0..=MAX_DEGREE as f64),
            }
            .into());
        }
        let each = (degrees[0] + 1) * (degrees[1] + 1);
        let count = input::checked_product(input::checked_product(rows, columns, "patches")?, each, "control points")?;
        let points = self::read_points(points, count, 3)?;
        Ok(gusset_sheet(if degree_u.max(degree_v) <= 3 {
            Sheet::Cubic(Patches::new(&points, degrees, rows, columns)?)
        } else {
            Sheet::High(Patches::new(&points, degrees, rows, columns)?)
        }))
    })
}

/// Makes a sheet from a B-spline surface. With equal weights, each non-empty knot span becomes an
/// exact cell, up to rounding.
///
/// gusset_sheet_get_report has the spline's parameters at 0, 1, 2, ... and the proved deviation.
///
/// If weights differ:
/// - Rows and columns of spans are divided into patches of degree 7 until the tolerance is proved.
/// - Values and first derivatives at cell corners are exact.
/// - Tangents are continuous across sides where the spline's are.
/// - A side of one point stays exactly one point.
///
/// @errors OUT_OF_RANGE (degree, tolerance, weight), NET_TOO_SMALL (too few control points),
///     BAD_KNOTS (not finite, decreasing, repeated too often, span too short to divide), TOO_LARGE
///     (control points, cells), NOT_FINITE
/// @complexity O(spans x degree^3). Rational: O(cells x degree^2), parallel; 1536 bytes a cell,
///     thrice during the call.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_from_spline_create(
    context: *const gusset_context,
    spline: *const gusset_spline,
    sheet: *mut *mut gusset_sheet,
) -> gusset_status {
    create_handle(context, sheet, "sheet", |job| {
        let given = input::read_versioned_struct(spline, false, "spline")?;
        let points =
            read_points(given.points, input::checked_product(given.count_u, given.count_v, "control points")?, 3)?;
        let u = input::copy_input_items(given.knots_u, given.knot_count_u, "knots_u")?;
        let v = input::copy_input_items(given.knots_v, given.knot_count_v, "knots_v")?;
        let closed = [read_flag(given.closed_u, "closed_u")?, read_flag(given.closed_v, "closed_v")?];
        let axes = [
            SplineAxis { degree: given.degree_u as usize, knots: &u, closed: closed[0] },
            SplineAxis { degree: given.degree_v as usize, knots: &v, closed: closed[1] },
        ];
        let weights = if given.weights.is_null() {
            None
        } else {
            Some(input::copy_input_items(given.weights, points.len(), "weights")?)
        };
        let counts = [given.count_u, given.count_v];
        let spline = Spline { points: &points, weights: weights.as_deref(), counts, axes };
        let options = SplineOptions {
            tolerance: (given.tolerance != 0.0).then_some(given.tolerance),
            max_cells: (given.max_cells != 0).then_some(given.max_cells),
        };
        Ok(gusset_sheet(Sheet::from_spline(&spline, &options, job)?))
    })
}

/// Makes Gordon's surface of a net of curves, which contains them all.
///
/// Two rows and two columns give Coons's patch. Nodes are where a row and a column are nearest. If
/// all rows have the same number of segments between two nodes, these match in order; else all are
/// cut at each joint, which adds cells. Columns likewise.
///
/// It is C1 where curves are C1 over common knots without joints between nodes; elsewhere nearly
/// (see gusset_sheet_measure). Polylines keep creases.
///
/// @errors NET_TOO_SMALL, EMPTY_CURVE, OUT_OF_RANGE (degree, tolerance), CURVE_NOT_CLOSED,
///     CURVES_APART (row, distance; also out of order), TOO_LARGE
/// @complexity O(rows x columns x log segments + cells).
/// @source Gordon (1969).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_from_curves_create(
    context: *const gusset_context,
    net: *const gusset_curve_net,
    sheet: *mut *mut gusset_sheet,
) -> gusset_status {
    create_handle(context, sheet, "sheet", |job| {
        let given = input::read_versioned_struct(net, false, "net")?;
        let rows = curves_of_handles(given.rows, given.row_count, "rows")?;
        let columns = curves_of_handles(given.columns, given.column_count, "columns")?;
        let closed = [read_flag(given.closed_u, "closed_u")?, read_flag(given.closed_v, "closed_v")?];
        let tolerance = if given.tolerance == 0.0 { None } else { Some(given.tolerance) };
        let net = CurveNet { rows: &rows, columns: &columns, closed, tolerance };
        Ok(gusset_sheet(Sheet::from_curves(&net, job)?))
    })
}

/// Makes a grid through the corners of a sheet's cells, moved along their normals.
///
/// Normals point along S_u x S_v:
/// - Grids: from circles through neighbouring nodes; exact on planes, spheres, and round cylinders
///   with rulings and sections as grid lines.
/// - Patches: exact. The grid is smooth where patches had creases.
/// - A corner without a normal stays.
///
/// @param distances lengths of either sign.
/// @param distance_count 1: for all; rows + 1: for each line of corners along v; (rows + 1) x
///     (columns + 1): for each corner, row by row. A closing line counts, but moves with the first.
/// @param deviation receives the largest deviation at cell middles from the sheet moved by the
///     corners' mean distance, or NULL.
/// @errors COUNT_DIFFERS (distances), NOT_FINITE (distance or corner)
/// @complexity O(cells).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_offset_create(
    context: *const gusset_context,
    sheet: *const gusset_sheet,
    distances: *const f64,
    distance_count: usize,
    deviation: *mut f64,
    offset: *mut *mut gusset_sheet,
) -> gusset_status {
    let out = input::cleared_optional_output(deviation, 0.0, "deviation");
    let moved = |job: &Job<'_>| {
        let out = out?;
        let distances = input::copy_input_items(distances, distance_count, "distances")?;
        let (made, worst) = handle::get_object(sheet, "sheet")?.0.offset(&distances, job)?;
        Ok((gusset_sheet(made), out.map(|out| (out, worst))))
    };
    create_handle_and_outputs(context, offset, "offset", moved, |told| {
        if let Some((out, worst)) = told {
            *out = worst;
        }
    })
}

/// Makes the surface of a frame: u runs along the body, v round it, closed like the frame.
///
/// @errors NET_TOO_SMALL, OUT_OF_RANGE (degree above 7), CURVES_APART (nodes repeat or are out of
///     order), NOT_FINITE
/// @complexity O(nodes).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_from_frame_create(
    context: *const gusset_context,
    frame: *const gusset_frame,
    kind: gusset_frame_surface,
    sheet: *mut *mut gusset_sheet,
) -> gusset_status {
    create_handle(context, sheet, "sheet", |job| {
        let frame = handle::get_object(frame, "frame")?;
        let kind = read_choice(kind)?;
        let (grid, curves) = (&frame.grid, [&frame.across.0, &frame.along.0]);
        let closed = [frame.ring, frame.closed];
        Ok(gusset_sheet(Sheet::from_frame_parts(grid, curves, closed, kind, job)?))
    })
}
