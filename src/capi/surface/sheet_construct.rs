//! Other sheets: Sheets from tangents, nets of curves, frames, patches and B-splines, including
//! rational ones (NURBS).

use crate::capi::context::{create, create_and_tell, gusset_context};
use crate::capi::curve::frame::gusset_frame;
use crate::capi::curve::{gusset_curve, points, times};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::handle;
use crate::capi::input::{self, choice, flag};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::sheet::gusset_sheet;
use crate::curve::CurveView;
use crate::error::Error;
use crate::job::Job;
use crate::surface::construct::{CurveNet, FrameSurface, Spline, SplineAxis, SplineOptions};
use crate::surface::{MAX_DEGREE, Patches, Sheet};
use gusset_base::alloc;

/// The surface that is made of a frame.
pub type gusset_frame_surface = u32;
/// The surface through the nodes of a frame; the surface of its curves if some of them have corners,
/// which would be rounded.
pub const GUSSET_FRAME_NODES: gusset_frame_surface = 0;
/// Gordon's surface of the curves of a frame, which contains them.
pub const GUSSET_FRAME_CURVES: gusset_frame_surface = 1;

/// A tensor-product B-spline, rational (NURBS) if it has weights that differ.
///
/// Knots of an open direction: as many as control points and the degree and 1, not decreasing,
/// finite, clamped or not; the surface is defined between knot degree and knot count. Of a closed
/// one: one more than control points, one period; the control points are not repeated, and span k,
/// from knot k to the next, is made by the control points k - degree to k, counted round. Inner
/// knots may be repeated degree times.
///
/// The control points of a rational spline are points of space (Euclidean), not multiplied by their
/// weights. A Bézier patch is the spline whose knots are 0 and 1, degree + 1 times each; patches
/// that share sides and their weights are one spline with inner knots repeated degree times.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_spline {
    /// sizeof(gusset_spline), set by the caller.
    pub struct_size: usize,
    /// x, y, z of the control points, row after row, packed: rows follow each other in u.
    pub points: *const f64,
    /// The number of rows of control points, more than degree_u.
    pub count_u: usize,
    /// The number of control points in a row, more than degree_v.
    pub count_v: usize,
    /// The knots of u.
    pub knots_u: *const f64,
    /// How many.
    pub knot_count_u: usize,
    /// The knots of v.
    pub knots_v: *const f64,
    /// How many.
    pub knot_count_v: usize,
    /// The degree in u, 1 to 7.
    pub degree_u: u32,
    /// The degree in v, 1 to 7.
    pub degree_v: u32,
    /// 1: closed in u.
    pub closed_u: u32,
    /// 1: closed in v.
    pub closed_v: u32,
    /// The weights of the control points, in their order, finite and above 0, none less than 2^-900
    /// of the greatest; a factor common to all changes nothing. NULL: all are 1.
    pub weights: *const f64,
    /// How far the sheet may be from a rational spline at equal parameters, a length; no less than
    /// rounding allows, some 1e-13 of the size. 0: 1e-12 of the diagonal of the control points' box,
    /// or more where rounding asks for it, far from the origin.
    pub tolerance: f64,
    /// The most cells that a rational spline may take; 0: 2^20.
    pub max_cells: usize,
}

/// A net of curves: each row meets each column, in the order in which they are given; curves may
/// run either way.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_curve_net {
    /// sizeof(gusset_curve_net), set by the caller.
    pub struct_size: usize,
    /// Curves in v, which follow each other in u. Segments of degree 7 at most; a curve that is one
    /// point is a pole.
    pub rows: *const *const gusset_curve,
    /// How many: 0, or at least 2, or 3 if closed_u.
    pub row_count: usize,
    /// Curves in u, which follow each other in v.
    pub columns: *const *const gusset_curve,
    /// How many: 0, or at least 2, or 3 if closed_v. Without columns, or without rows, the surface
    /// is the skin of the others.
    pub column_count: usize,
    /// How far apart curves may be where they meet, a length, finite; both are moved to the middle.
    /// 0: 1e-6 of the diagonal of their box.
    pub tolerance: f64,
    /// 1: the columns are closed curves, and the last row is followed by the first.
    pub closed_u: u32,
    /// 1: the rows are closed curves, and the last column is followed by the first.
    pub closed_v: u32,
}

versioned! { gusset_spline: 80, gusset_curve_net: 56 }

c_enum! { kind: FrameSurface { GUSSET_FRAME_NODES => Nodes, GUSSET_FRAME_CURVES => Curves } }

/// The caller's curves, borrowed.
fn curves<'a>(
    handles: *const *const gusset_curve,
    count: usize,
    name: &'static str,
) -> Result<Vec<CurveView<'a>>, Failure> {
    let handles = handle::list(handles, count, name)?;
    alloc::try_collect(handles.map(|handle| Ok(handle?.0.view())))
}

/// Makes a surface of Bézier patches in rows and columns, neighbours of which should share their
/// sides.
///
/// Repeated points and sides that are one point are allowed.
///
/// @param points x, y, z of the control points, packed, at any alignment: patch after patch, row
///     after row of patches; in each patch degree_v + 1 points follow each other in v, degree_u + 1
///     times.
/// @param degree_u 1 to 7.
/// @param degree_v 1 to 7.
/// @param rows of patches, at least 1.
/// @param columns of patches, at least 1.
/// @errors MISALIGNED_ARGUMENT (sheet), OUT_OF_RANGE (degree), EMPTY_MESH (without patches),
///     TOO_LARGE, NOT_FINITE (with the control point (as a node))
/// @complexity O(points); 384 bytes a patch up to degree 3, else 1536.
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
    create(context, sheet, "sheet", |_| {
        let degrees = [degree_u as usize, degree_v as usize];
        if let Some(&degree) = degrees.iter().find(|degree| !(1..=MAX_DEGREE).contains(*degree)) {
            return Err(Error::OptionOutOfRange { option: "degree", value: degree as f64 }.into());
        }
        let each = (degrees[0] + 1) * (degrees[1] + 1);
        let count = times(times(rows, columns, "patches")?, each, "control points")?;
        let points = self::points(points, count, 3)?;
        Ok(gusset_sheet(if degree_u.max(degree_v) <= 3 {
            Sheet::Cubic(Patches::new(&points, degrees, rows, columns)?)
        } else {
            Sheet::High(Patches::new(&points, degrees, rows, columns)?)
        }))
    })
}

/// Makes the surface of a B-spline, cut into its Bézier patches, which is exact but for rounding:
/// cells are its spans that are not empty, so that knots become the whole numbers of rows and
/// columns.
///
/// If weights differ, spans are cut further, whole rows and columns at a time, and the patch of each
/// cell is the polynomial of degree 7 with the values and the first derivatives of the rational
/// surface at corners, and its values at points between. It is proven, not sampled, that the sheet
/// is within the tolerance of the rational surface at equal parameters: gusset_sheet_get_report has
/// the bound, rounding included, and the knots of rows and columns, between which parameters run
/// evenly. Tangents go on over sides where those of the rational surface do. Sides that are one
/// point, as the poles of spheres, stay so to the bit.
///
/// @param spline its arrays are at any alignment.
/// @errors OUT_OF_RANGE (degree; tolerance; a weight, with its control point as a node),
///     NET_TOO_SMALL (too few control points), BAD_KNOTS (with the first knot that is not finite,
///     out of order or repeated too often, that begins a span too short to be cut where that is
///     needed), TOO_LARGE (control points, cells), NOT_FINITE (with the control point (as a node))
/// @complexity O(spans x degree^3); 384 bytes a span up to degree 3, else 1536. Of rational splines
///     O(cells x degree^2), threads; 1536 bytes a cell, three times that while it is made.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_from_spline_create(
    context: *const gusset_context,
    spline: *const gusset_spline,
    sheet: *mut *mut gusset_sheet,
) -> gusset_status {
    create(context, sheet, "sheet", |job| {
        let given = input::read(spline, false, "spline")?;
        let points = points(given.points, times(given.count_u, given.count_v, "control points")?, 3)?;
        let u = input::list(given.knots_u, given.knot_count_u, "knots_u")?;
        let v = input::list(given.knots_v, given.knot_count_v, "knots_v")?;
        let closed = [flag(given.closed_u, "closed_u")?, flag(given.closed_v, "closed_v")?];
        let axes = [
            SplineAxis { degree: given.degree_u as usize, knots: &u, closed: closed[0] },
            SplineAxis { degree: given.degree_v as usize, knots: &v, closed: closed[1] },
        ];
        let weights =
            if given.weights.is_null() { None } else { Some(input::list(given.weights, points.len(), "weights")?) };
        let counts = [given.count_u, given.count_v];
        let spline = Spline { points: &points, weights: weights.as_deref(), counts, axes };
        let options = SplineOptions {
            tolerance: (given.tolerance != 0.0).then_some(given.tolerance),
            max_cells: (given.max_cells != 0).then_some(given.max_cells),
        };
        Ok(gusset_sheet(Sheet::from_spline(&spline, &options, job)?))
    })
}

/// Makes Gordon's surface of a net of curves, which contains all of them; with two rows and two
/// columns it is Coons's patch.
///
/// Nodes are where each row and each column are nearest.
///
/// Between two nodes rows of equally many segments are matched segment by segment; else all of them
/// are cut where any one has a joint: there may be more cells than meshes of the net. The surface
/// is C1 where the curves are C1 in common knots and have no joints between nodes, else nearly
/// (gusset_sheet_measure tells). Polylines, segments of degree 1, are kept with their creases; for a
/// smooth surface draw curves through their points first, with gusset_outline_create.
///
/// @param net the curves may be destroyed afterwards; the arrays of handles are at any alignment.
/// @errors NULL_ARGUMENT (with the item), NET_TOO_SMALL, EMPTY_CURVE, OUT_OF_RANGE (degree,
///     tolerance), CURVE_NOT_CLOSED, CURVES_APART (with the row and the distance (the message has
///     the column too), if they meet out of order), TOO_LARGE
/// @complexity O(rows x columns x log segments) to find nodes, then O(cells); 384 bytes a cell up
///     to degree 3, else 1536.
/// @source Gordon (1969).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_from_curves_create(
    context: *const gusset_context,
    net: *const gusset_curve_net,
    sheet: *mut *mut gusset_sheet,
) -> gusset_status {
    create(context, sheet, "sheet", |job| {
        let given = input::read(net, false, "net")?;
        let rows = curves(given.rows, given.row_count, "rows")?;
        let columns = curves(given.columns, given.column_count, "columns")?;
        let closed = [flag(given.closed_u, "closed_u")?, flag(given.closed_v, "closed_v")?];
        let tolerance = if given.tolerance == 0.0 { None } else { Some(given.tolerance) };
        let net = CurveNet { rows: &rows, columns: &columns, closed, tolerance };
        Ok(gusset_sheet(Sheet::from_curves(&net, job)?))
    })
}

/// Makes the surface beside a sheet: through the corners of its cells, each moved along the normal,
/// the derivative in u crossed with that in v.
///
/// Normals at the nodes of a grid are those of circles through neighbouring nodes, exact on planes,
/// spheres, and round cylinders whose rulings and sections are lines of the grid; those of patches
/// are their own.
/// Places without a normal stay. The result is a grid, smooth between its nodes where a sheet of
/// patches had creases.
///
/// @param sheet may be destroyed afterwards.
/// @param distances in the unit of the nodes, finite, of either sign.
/// @param distance_count 1: all corners move by the same; the number of lines of corners along v,
///     rows + 1 for rows of cells: each line by its own; (rows + 1) x (columns + 1): each corner by
///     its own, row by row. A line that closes the sheet counts, and moves with the first one.
/// @param deviation receives how far the result is, at most in the middles of the cells, from the
///     place of this sheet there, moved along its normal by the mean distance of the corners; NULL
///     if it is not wanted.
/// @errors COUNT_DIFFERS (distances), NOT_FINITE (the index is the distance's or the corner's)
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
    let out = input::optional_output(deviation, 0.0, "deviation");
    let moved = |job: &Job<'_>| {
        let out = out?;
        let distances = input::list(distances, distance_count, "distances")?;
        let (made, worst) = handle::get(sheet, "sheet")?.0.offset(&distances, job)?;
        Ok((gusset_sheet(made), out.map(|out| (out, worst))))
    };
    create_and_tell(context, offset, "offset", moved, |told| {
        if let Some((out, worst)) = told {
            *out = worst;
        }
    })
}

/// Makes the surface of a frame: u runs along the body, v round it, closed as the frame is.
///
/// @param frame may be destroyed afterwards.
/// @errors NET_TOO_SMALL (of curves OUT_OF_RANGE (a degree above 7)), CURVES_APART (if nodes repeat
///     or are out of order along a curve), NOT_FINITE
/// @complexity O(nodes).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_from_frame_create(
    context: *const gusset_context,
    frame: *const gusset_frame,
    kind: gusset_frame_surface,
    sheet: *mut *mut gusset_sheet,
) -> gusset_status {
    create(context, sheet, "sheet", |job| {
        let frame = handle::get(frame, "frame")?;
        let kind = choice(kind)?;
        let (grid, curves) = (&frame.grid, [&frame.across.0, &frame.along.0]);
        let closed = [frame.ring, frame.closed];
        Ok(gusset_sheet(Sheet::from_frame_parts(grid, curves, closed, kind, job)?))
    })
}
