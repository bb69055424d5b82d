//! Sheets: Smooth patches through a grid of nodes.
//!
//! @source Leus, "Carcasses on smooth surfaces".

use crate::capi::context::{create_handle, gusset_context};
use crate::capi::curve::read_points;
use crate::capi::glue::{c_enum, constants, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, read_choice, read_flag};
use crate::capi::mesh::gusset_scalar;
use crate::capi::status::gusset_status::GUSSET_ERROR_BAD_STRIDE;
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::job::Job;
use crate::mesh::Scalar;
use crate::surface::construct::{Tangents, Twists};
use crate::surface::{Grid, MAX_NODES, Nodes, Scheme, Sheet};
use gusset_base::alloc;
use gusset_base::geom::strided::Strided;
use std::ffi::c_void;

/// Rows and columns of cells, each a Bézier patch.
pub struct gusset_sheet(pub(crate) Sheet<'static>);

handle! { gusset_sheet }

/// Interpolation through nodes.
pub type gusset_scheme = u32;
/// Bicubic from 6 x 6 nodes round a cell: fourth order, constant 1/384, continuous tangents.
pub const GUSSET_SCHEME_SIX_TAP: gusset_scheme = 0;
/// Leus's bicubic through 4 x 4 nodes: fourth order, constant 3/128, tangents jump at nodes.
pub const GUSSET_SCHEME_FOUR_POINT: gusset_scheme = 1;

/// Source of the twists S_uv at nodes.
pub type gusset_twists = u32;
/// Differences of tangents over five nodes: fourth order.
pub const GUSSET_TWISTS_DIFFERENCES: gusset_twists = 0;
/// Adini's twists, from adjacent nodes.
pub const GUSSET_TWISTS_ADINI: gusset_twists = 1;
/// 0: flat spots at nodes.
pub const GUSSET_TWISTS_ZERO: gusset_twists = 2;
/// The given twists.
pub const GUSSET_TWISTS_GIVEN: gusset_twists = 3;

/// Nodes of a surface. Node (i, j) is at nodes + i * row_stride + j * column_stride bytes. Normals
/// point along S_u x S_v, u running from row to row: opposite to a net's.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_nodes {
    /// sizeof(gusset_nodes).
    pub struct_size: usize,
    /// The first node.
    pub nodes: *const c_void,
    /// At least 2; closed at least 4, the last repeating the first.
    pub rows: usize,
    /// Likewise; rows * columns at most INT32_MAX.
    pub columns: usize,
    /// Stride of rows.
    pub row_stride: usize,
    /// Stride of nodes in a row.
    pub column_stride: usize,
    /// Type of coordinates.
    pub scalar: gusset_scalar,
    /// Interpolation through nodes.
    /// @option
    pub scheme: gusset_scheme,
    /// 1: closed in u.
    /// @option
    /// @flag
    pub closed_u: u32,
    /// 1: closed in v.
    /// @option
    /// @flag
    pub closed_v: u32,
}

/// Tangents at nodes, row after row. The parameter step between nodes is 1.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_tangents {
    /// sizeof(gusset_tangents).
    pub struct_size: usize,
    /// S_u at each node, towards the next row.
    pub u: *const f64,
    /// S_v at each node, towards the next column.
    pub v: *const f64,
    /// For GUSSET_TWISTS_GIVEN: S_uv at each node.
    pub twists: *const f64,
    /// Source of the twists S_uv at nodes.
    pub twist: gusset_twists,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_nodes: 64, gusset_tangents: 40 reserved }

/// The layout of the caller's nodes, in bytes.
struct NodeLayout {
    row_stride: usize,
    column_stride: usize,
    byte_span: usize,
}

impl NodeLayout {
    fn new(nodes: &gusset_nodes, size: usize) -> Result<Self, Failure> {
        let (rows, columns) = (nodes.rows, nodes.columns);
        if rows < 2 || columns < 2 {
            return Err(Error::NetTooSmall { rows: rows as u64, columns: columns as u64 }.into());
        }
        let column = if nodes.column_stride == 0 { 3 * size } else { nodes.column_stride };
        let width = Strided::byte_span(columns, column, 3 * size, "nodes of a row")?;
        // With at least two columns these are at most twice the width, so the product does not
        // overflow.
        let row = if nodes.row_stride == 0 { columns * column } else { nodes.row_stride };
        Ok(NodeLayout {
            row_stride: row,
            column_stride: column,
            byte_span: Strided::byte_span(rows, row, width, "rows of nodes")?,
        })
    }
}

/// Returns the sheet of a handle.
pub(crate) fn sheet_of_handle<'a>(sheet: *const gusset_sheet) -> Result<&'a Sheet<'static>, Failure> {
    Ok(&handle::get_object(sheet, "sheet")?.0)
}

/// Nodes copied between two progress reports.
const NODES_PER_REPORT: usize = 1 << 17;

/// Copies the caller's numbers into packed form.
fn copy_nodes(nodes: &gusset_nodes, job: &Job<'_>) -> Result<Nodes<'static>, Failure> {
    let kind: Scalar = read_choice(nodes.scalar)?;
    let layout = NodeLayout::new(nodes, kind.position_size() / 3)?;
    // Reject the size before reading anything.
    let count = nodes.rows.saturating_mul(nodes.columns);
    Error::check_count("nodes", count as u64, MAX_NODES)?;
    let bytes = input::input_bytes(nodes.nodes, layout.byte_span, 1, "nodes")?;
    let mut numbers = alloc::with_capacity(3 * count)?;
    let interval = (NODES_PER_REPORT / nodes.columns.max(1)).max(1);
    for i in 0..nodes.rows {
        job.step_every(interval, i, nodes.rows, "copying nodes")?;
        for j in 0..nodes.columns {
            let node = &bytes[i * layout.row_stride + j * layout.column_stride..];
            numbers.extend((0..3).map(|k| match kind {
                Scalar::F32 => f64::from(bytemuck::pod_read_unaligned::<f32>(&node[4 * k..4 * k + 4])),
                Scalar::F64 => bytemuck::pod_read_unaligned::<f64>(&node[8 * k..8 * k + 8]),
            }));
        }
    }
    Ok(Nodes::strided(numbers, nodes.rows, nodes.columns, 0, 0)?)
}

/// Borrows the caller's numbers.
fn borrow_nodes(nodes: &gusset_nodes) -> Result<Nodes<'static>, Failure> {
    let layout = NodeLayout::new(nodes, 8)?;
    if read_choice::<Scalar>(nodes.scalar)? != Scalar::F64
        || !layout.row_stride.is_multiple_of(8)
        || !layout.column_stride.is_multiple_of(8)
    {
        let message = "nodes in the caller's memory must be f64, with strides that are multiples of 8 bytes";
        return Err(Failure { value: layout.column_stride as f64, ..Failure::new(GUSSET_ERROR_BAD_STRIDE, message) });
    }
    let numbers: &'static [f64] =
        input::result_buffer(nodes.nodes.cast::<f64>().cast_mut(), layout.byte_span / 8, "nodes")?;
    Ok(Nodes::strided(numbers, nodes.rows, nodes.columns, layout.row_stride / 8, layout.column_stride / 8)?)
}

c_enum! { scheme: Scheme { GUSSET_SCHEME_SIX_TAP => SixTap, GUSSET_SCHEME_FOUR_POINT => FourPoint } }

/// Returns the bicubic Hermite surface through nodes with the caller's tangents.
fn sheet_with_tangents(
    nodes: &Nodes<'_>,
    closed: [bool; 2],
    given: &gusset_tangents,
    count: usize,
    job: &Job<'_>,
) -> Result<Sheet<'static>, Failure> {
    let [u, v] = [read_points(given.u, count, 3)?, read_points(given.v, count, 3)?];
    let twists = if given.twist == GUSSET_TWISTS_GIVEN { read_points(given.twists, count, 3)? } else { Vec::new() };
    let twists = match given.twist {
        GUSSET_TWISTS_DIFFERENCES => Twists::Differences,
        GUSSET_TWISTS_ADINI => Twists::Adini,
        GUSSET_TWISTS_ZERO => Twists::Zero,
        GUSSET_TWISTS_GIVEN => Twists::Given(&twists),
        other => {
            return Err(Failure::unknown_choice(
                "twist",
                other,
                &constants![GUSSET_TWISTS_DIFFERENCES, GUSSET_TWISTS_ADINI, GUSSET_TWISTS_ZERO, GUSSET_TWISTS_GIVEN],
            ));
        }
    };
    Ok(Sheet::from_tangents(&Tangents { nodes, u: &u, v: &v, twists, closed }, job)?)
}

/// Makes a sheet through nodes, or the C1 bicubic Hermite surface of given tangents.
///
/// Repeated nodes and poles are allowed.
///
/// Borrowed nodes are f64, address and strides multiples of 8. They stay unchanged until the sheet
/// and all made of it are destroyed.
///
/// @param nodes finite.
/// @param tangents NULL: the nodes' scheme applies. Else rows x columns vectors an array; a
///     repeated closing line is not used.
/// @param borrow 1: reads the caller's nodes; 0: copies them. With tangents, only patches are kept.
/// @errors NET_TOO_SMALL, TOO_LARGE, BAD_STRIDE (borrowed nodes), NOT_FINITE (node, tangent or
///     twist), SIDES_DIFFER (closed, but ends differ: largest gap)
/// @complexity O(nodes); 24 bytes a node (0 if borrowed), with tangents 384 bytes a cell.
/// @source V. Leus.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_create(
    context: *const gusset_context,
    nodes: *const gusset_nodes,
    tangents: *const gusset_tangents,
    borrow: u32,
    sheet: *mut *mut gusset_sheet,
) -> gusset_status {
    create_handle(context, sheet, "sheet", |job| {
        let given = input::read_versioned_struct(nodes, false, "nodes")?;
        let with =
            if tangents.is_null() { None } else { Some(input::read_versioned_struct(tangents, false, "tangents")?) };
        let split = if with.is_some() { 0.1 } else { 1.0 };
        let nodes = if read_flag(borrow, "borrow")? {
            borrow_nodes(&given)?
        } else {
            copy_nodes(&given, &job.sub_job(0.0, split))?
        };
        let closed = [read_flag(given.closed_u, "closed_u")?, read_flag(given.closed_v, "closed_v")?];
        Ok(gusset_sheet(match with {
            Some(with) => {
                sheet_with_tangents(&nodes, closed, &with, given.rows * given.columns, &job.sub_job(split, 1.0))?
            }
            None => Sheet::Grid(Grid::new(nodes, closed, read_choice(given.scheme)?)?),
        }))
    })
}

/// Frees a sheet.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_sheet_destroy(sheet: *mut gusset_sheet) {
    handle::destroy(sheet);
}
