//! C interface: sheets of smooth patches.

use crate::capi::context::{create, gusset_context};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, choice, flag};
use crate::capi::status::gusset_status::GUSSET_ERROR_BAD_STRIDE;
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::job::Job;
use crate::mesh::Scalar;
use crate::surface::{Grid, MAX_NODES, Nodes, Scheme, Sheet};
use gusset_base::alloc;
use gusset_base::geom::strided::Strided;
use std::ffi::c_void;

/// A piece of surface: rows and columns of cells, each a Bézier patch. Opaque and immutable: all
/// functions may use it from any thread, and many at the same time, each with a context of its own;
/// it is destroyed when none uses it any more.
pub struct gusset_sheet(pub(crate) Sheet<'static>);

handle! { gusset_sheet }

/// How the surface is drawn through nodes.
pub type gusset_scheme = u32;
/// Bicubic with continuous tangents, from the 6 x 6 nodes round a cell: fourth order, with the
/// constant 1/384.
pub const GUSSET_SCHEME_SIX_TAP: gusset_scheme = 0;
/// The paper's: the bicubic through the 4 x 4 nodes round a cell; fourth order with the constant
/// 3/128, tangents jump at nodes.
pub const GUSSET_SCHEME_FOUR_POINT: gusset_scheme = 1;

/// Nodes of a surface: x, y, z of node (i, j) are at nodes + i * row_stride + j * column_stride
/// bytes, one after the other. Normals are those of u (from row to row) and then v: opposite to
/// those of a net of the same nodes.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_nodes {
    /// sizeof(gusset_nodes), set by the caller.
    pub struct_size: usize,
    /// The first node.
    pub nodes: *const c_void,
    /// The number of rows, at least 2; of a surface closed in u at least 4, of which the last
    /// repeats the first.
    pub rows: usize,
    /// The number of columns, the same for v. rows * columns is at most 2^31 - 1.
    pub columns: usize,
    /// Bytes from row to row; 0 for rows without gaps.
    pub row_stride: usize,
    /// Bytes from node to node in a row; 0 for nodes without gaps.
    pub column_stride: usize,
    /// GUSSET_F32 or GUSSET_F64.
    pub scalar: u32,
    /// GUSSET_SCHEME_...
    pub scheme: gusset_scheme,
    /// 1: closed in u, along columns: the last row is the first one again.
    pub closed_u: u32,
    /// 1: closed in v, along rows.
    pub closed_v: u32,
}

versioned! { gusset_nodes: 64 }

/// How the caller's nodes lie, in bytes.
struct Layout {
    row: usize,
    column: usize,
    span: usize,
}

impl Layout {
    fn of(nodes: &gusset_nodes, size: usize) -> Result<Self, Failure> {
        let (rows, columns) = (nodes.rows, nodes.columns);
        if rows < 2 || columns < 2 {
            return Err(Error::NetTooSmall { rows: rows as u64, columns: columns as u64 }.into());
        }
        let column = if nodes.column_stride == 0 { 3 * size } else { nodes.column_stride };
        let width = Strided::span(columns, column, 3 * size, "nodes of a row")?;
        // Of two columns and more these are at most twice the width, which is no overflow.
        let row = if nodes.row_stride == 0 { columns * column } else { nodes.row_stride };
        Ok(Layout { row, column, span: Strided::span(rows, row, width, "rows of nodes")? })
    }
}

/// The sheet of a handle.
pub(crate) fn read<'a>(sheet: *const gusset_sheet) -> Result<&'a Sheet<'static>, Failure> {
    Ok(&handle::get(sheet, "sheet")?.0)
}

/// Nodes that are copied between two progress reports.
const NODES_PER_REPORT: usize = 1 << 17;

/// A copy of the caller's numbers, packed.
pub(crate) fn copied_nodes(nodes: &gusset_nodes, job: &Job<'_>) -> Result<Nodes<'static>, Failure> {
    let kind: Scalar = choice(nodes.scalar)?;
    let layout = Layout::of(nodes, kind.position_size() / 3)?;
    // Refused before anything is read.
    let count = nodes.rows.saturating_mul(nodes.columns);
    Error::check_count("nodes", count as u64, MAX_NODES)?;
    let bytes = input::bytes(nodes.nodes, layout.span, 1, "nodes")?;
    let mut numbers = alloc::with_capacity(3 * count)?;
    let interval = (NODES_PER_REPORT / nodes.columns.max(1)).max(1);
    for i in 0..nodes.rows {
        job.step_every(interval, i, nodes.rows, "copying nodes")?;
        for j in 0..nodes.columns {
            let node = &bytes[i * layout.row + j * layout.column..];
            numbers.extend((0..3).map(|k| match kind {
                Scalar::F32 => f64::from(bytemuck::pod_read_unaligned::<f32>(&node[4 * k..4 * k + 4])),
                Scalar::F64 => bytemuck::pod_read_unaligned::<f64>(&node[8 * k..8 * k + 8]),
            }));
        }
    }
    Ok(Nodes::strided(numbers, nodes.rows, nodes.columns, 0, 0)?)
}

/// The caller's numbers themselves.
fn borrowed_nodes(nodes: &gusset_nodes, _: &Job<'_>) -> Result<Nodes<'static>, Failure> {
    let layout = Layout::of(nodes, 8)?;
    if choice::<Scalar>(nodes.scalar)? != Scalar::F64
        || !layout.row.is_multiple_of(8)
        || !layout.column.is_multiple_of(8)
    {
        let message = "nodes in the caller's memory are f64, and whole numbers apart";
        return Err(Failure { value: layout.column as f64, ..Failure::new(GUSSET_ERROR_BAD_STRIDE, message) });
    }
    let numbers: &'static [f64] = input::results(nodes.nodes.cast::<f64>().cast_mut(), layout.span / 8, "nodes")?;
    Ok(Nodes::strided(numbers, nodes.rows, nodes.columns, layout.row / 8, layout.column / 8)?)
}

c_enum! { scheme: Scheme { GUSSET_SCHEME_SIX_TAP => SixTap, GUSSET_SCHEME_FOUR_POINT => FourPoint } }

/// A sheet through nodes, taken in either way.
fn through(
    nodes: *const gusset_nodes,
    take: fn(&gusset_nodes, &Job<'_>) -> Result<Nodes<'static>, Failure>,
    job: &Job<'_>,
) -> Result<gusset_sheet, Failure> {
    let given = input::read(nodes, false, "nodes")?;
    let nodes = take(&given, job)?;
    let closed = [flag(given.closed_u, "closed_u")?, flag(given.closed_v, "closed_v")?];
    Ok(gusset_sheet(Sheet::Grid(Grid::new(nodes, closed, choice(given.scheme)?)?)))
}

/// Makes a surface through a copy of nodes.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param nodes at any alignment, finite; of sheets for a surface the greatest coordinate in
///     absolute terms is from 1e-30 to 1e37, or 0, however the sheet is made; repeated nodes and
///     rows that are one point (poles) are allowed.
/// @param[out] sheet receives the surface, for gusset_sheet_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT (the struct, sheet),
///     BAD_STRUCT_SIZE, NET_TOO_SMALL, TOO_LARGE, BAD_STRIDE, SIZE_OVERFLOW, UNKNOWN_VALUE,
///     NOT_FINITE with the node, SIDES_DIFFER if a closed direction does not end where it begins,
///     with the place of the largest gap, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(nodes); 24 bytes a node.
/// @source Leus, "Carcasses on smooth surfaces"; the scheme of six taps is ours.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_from_nodes_create(
    context: *const gusset_context,
    nodes: *const gusset_nodes,
    sheet: *mut *mut gusset_sheet,
) -> gusset_status {
    create(context, sheet, "sheet", |job| through(nodes, copied_nodes, job))
}

/// Makes a surface through nodes in the caller's own memory, which must stay valid and unchanged
/// until the sheet and all that was made of it are destroyed.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param nodes as for gusset_sheet_from_nodes_create, but f64, aligned to 8 bytes, strides
///     multiples of 8.
/// @param[out] sheet receives the result, for gusset_sheet_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: as there; MISALIGNED_ARGUMENT (the nodes), BAD_STRIDE for f32
///     and for strides that are no multiples of 8; CANCELLED.
/// @complexity O(nodes); no memory a node.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_borrow_create(
    context: *const gusset_context,
    nodes: *const gusset_nodes,
    sheet: *mut *mut gusset_sheet,
) -> gusset_status {
    create(context, sheet, "sheet", |job| through(nodes, borrowed_nodes, job))
}

/// Frees a sheet; NULL is allowed.
///
/// What was made of it keeps what it needs.
///
/// @param[in,out] sheet the handle; NULL is allowed.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_sheet_destroy(sheet: *mut gusset_sheet) {
    handle::destroy(sheet);
}
