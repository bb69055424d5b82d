//! Gluing of sides: Sides, the characteristic matrix, seams.

use crate::capi::context::{guard_changing_call, gusset_context};
use crate::capi::glue::{fixed, versioned};
use crate::capi::input::{self, fill_buffer, read_flag};
use crate::capi::net::net_handle::{gusset_net, net_of_handle, replace_gluing};
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::job::Job;
use crate::net::topology::{ContractedLinks, SeamRun};
use crate::net::{LinkMatrix, MAX_NODES, Seam, Shape, Sides, Topology};
use gusset_base::alloc;
use std::ptr;

/// Glues node k of run A, (row_a + k * row_step_a, column_a + k * column_step_a), to node k of run
/// B.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_seam {
    /// First row of A.
    pub row_a: u32,
    /// First column of A.
    pub column_a: u32,
    /// Rows a step.
    pub row_step_a: i32,
    /// Columns a step.
    pub column_step_a: i32,
    /// As for A.
    pub row_b: u32,
    /// As for A.
    pub column_b: u32,
    /// As for A.
    pub row_step_b: i32,
    /// As for A.
    pub column_step_b: i32,
    /// Nodes, at least 1; exactly 1 if all steps are 0.
    pub count: u32,
    /// 0.
    pub reserved: u32,
}

/// Gluing of sides.
/// @bits
pub type gusset_sides = u32;
/// Rows are closed: the last node is the first.
pub const GUSSET_SIDES_ROWS_CLOSED: gusset_sides = 1;
/// Columns are closed.
pub const GUSSET_SIDES_COLUMNS_CLOSED: gusset_sides = 2;
/// The first row is one point.
pub const GUSSET_SIDES_POLE_TOP: gusset_sides = 4;
/// The last row is one point.
pub const GUSSET_SIDES_POLE_BOTTOM: gusset_sides = 8;
/// The first column is one point.
pub const GUSSET_SIDES_POLE_LEFT: gusset_sides = 16;
/// The last column is one point.
pub const GUSSET_SIDES_POLE_RIGHT: gusset_sides = 32;
/// All sides are open.
pub const GUSSET_SIDES_SHEET: gusset_sides = 0;
/// Rows are closed.
pub const GUSSET_SIDES_TUBE: gusset_sides = 1;
/// Closed rows, the first and last poles.
pub const GUSSET_SIDES_TWO_POLES: gusset_sides = 13;
/// All four sides are one point.
pub const GUSSET_SIDES_ONE_POLE: gusset_sides = 60;
/// Rows and columns are closed.
pub const GUSSET_SIDES_TORUS: gusset_sides = 3;

/// Gluing. Default: none.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_gluing {
    /// sizeof(gusset_net_gluing).
    pub struct_size: usize,
    /// Characteristic matrix: 2 * rows rows of columns bytes, 1 for a contracted link, else 0. Row
    /// 2i has row i's horizontal links, row 2i + 1 the vertical ones. NULL: sides.
    pub matrix: *const u8,
    /// Additional seams.
    pub seams: *const gusset_seam,
    /// Number of seams.
    pub seam_count: usize,
    /// 0 with a matrix.
    pub sides: gusset_sides,
    /// 1: opposite orientation of faces.
    pub reversed: u32,
}

versioned! { gusset_net_gluing: 40 }
fixed! { gusset_seam: 40 }

/// Converts the caller's sides.
pub(crate) fn sides_from_bits(bits: gusset_sides) -> Result<Sides, Failure> {
    if bits > 63 {
        return Err(Failure::unknown_value("sides", bits.into(), "a sum of GUSSET_SIDES_ constants"));
    }
    let on = |side: gusset_sides| bits & side != 0;
    Ok(Sides {
        rows_closed: on(GUSSET_SIDES_ROWS_CLOSED),
        columns_closed: on(GUSSET_SIDES_COLUMNS_CLOSED),
        pole_top: on(GUSSET_SIDES_POLE_TOP),
        pole_bottom: on(GUSSET_SIDES_POLE_BOTTOM),
        pole_left: on(GUSSET_SIDES_POLE_LEFT),
        pole_right: on(GUSSET_SIDES_POLE_RIGHT),
    })
}

/// Converts sides for the caller.
pub(crate) fn sides_to_bits(sides: Sides) -> gusset_sides {
    let bit = |on: bool, side: gusset_sides| if on { side } else { 0 };
    bit(sides.rows_closed, GUSSET_SIDES_ROWS_CLOSED)
        | bit(sides.columns_closed, GUSSET_SIDES_COLUMNS_CLOSED)
        | bit(sides.pole_top, GUSSET_SIDES_POLE_TOP)
        | bit(sides.pole_bottom, GUSSET_SIDES_POLE_BOTTOM)
        | bit(sides.pole_left, GUSSET_SIDES_POLE_LEFT)
        | bit(sides.pole_right, GUSSET_SIDES_POLE_RIGHT)
}

/// Converts a seam of the caller.
pub(crate) fn to_seam(seam: &gusset_seam) -> Result<Seam, Failure> {
    if seam.reserved != 0 {
        return Err(Failure::not_zero("reserved", seam.reserved.into()));
    }
    let run = |row, column, row_step, column_step| SeamRun { row, column, row_step, column_step };
    Ok(Seam {
        a: run(seam.row_a, seam.column_a, seam.row_step_a, seam.column_step_a),
        b: run(seam.row_b, seam.column_b, seam.row_step_b, seam.column_step_b),
        count: seam.count,
    })
}

/// Reads the caller's seams, at any alignment.
pub(crate) fn read_seams(data: *const gusset_seam, count: usize) -> Result<Vec<Seam>, Failure> {
    Error::check_count("seams", count as u64, MAX_NODES)?;
    alloc::try_collect(input::input_items(data, count, "seams")?.map(|given| to_seam(&given)))
}

impl From<&Seam> for gusset_seam {
    fn from(seam: &Seam) -> Self {
        let Seam { a, b, count } = *seam;
        gusset_seam {
            row_a: a.row,
            column_a: a.column,
            row_step_a: a.row_step,
            column_step_a: a.column_step,
            row_b: b.row,
            column_b: b.column,
            row_step_b: b.row_step,
            column_step_b: b.column_step,
            count,
            reserved: 0,
        }
    }
}

/// Converts the caller's topology; NULL means that nothing is glued.
pub(crate) fn read_topology(
    shape: Shape,
    gluing: *const gusset_net_gluing,
    job: &Job<'_>,
) -> Result<Topology, Failure> {
    let gluing = input::read_versioned_struct(gluing, true, "gluing")?;
    let links = if gluing.matrix.is_null() {
        ContractedLinks::Sides(sides_from_bits(gluing.sides)?)
    } else if gluing.sides != 0 {
        return Err(Failure::unknown_value("sides", gluing.sides.into(), "0 beside a matrix"));
    } else {
        let bytes = input::input_bytes(gluing.matrix.cast(), shape.link_count(), 1, "matrix")?;
        ContractedLinks::Matrix(LinkMatrix::from_bytes(shape, bytes)?)
    };
    let seams = read_seams(gluing.seams, gluing.seam_count)?;
    Ok(Topology::new_cancellable(shape, links, &seams, job, "gluing")?
        .with_reversed(read_flag(gluing.reversed, "reversed")?))
}

/// Replaces the gluing; positions stay.
///
/// @param gluing NULL: nothing is glued.
/// @errors as gusset_net_create
/// @complexity O(nodes + pairs of seams).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_set_gluing(
    context: *const gusset_context,
    net: *mut gusset_net,
    gluing: *const gusset_net_gluing,
) -> gusset_status {
    replace_gluing(context, net, |net, job| read_topology(net.shape(), gluing, job))
}

/// Gluing in normal form: sides replace links, and links seams, where possible.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_gluing_report {
    /// sizeof(gusset_net_gluing_report).
    pub struct_size: usize,
    /// Bytes of the matrix: 2 * rows * columns.
    pub matrix_size: usize,
    /// Number of seams.
    pub seam_count: usize,
    /// Number of bridges.
    pub bridge_count: usize,
    /// UINT32_MAX unless sides describe all links.
    pub sides: gusset_sides,
    /// 1: opposite orientation of faces.
    /// @flag
    pub reversed: u32,
}

versioned! { gusset_net_gluing_report: 40 }

/// Writes the gluing of a net.
///
/// @param matrix receives the characteristic matrix.
/// @param matrix_capacity at least matrix_size.
/// @param seam_capacity at least seam_count.
/// @errors BUFFER_TOO_SMALL
/// @complexity O(seams) for seams, O(nodes) for the matrix.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_get_gluing(
    net: *const gusset_net,
    matrix: *mut u8,
    matrix_capacity: usize,
    seams: *mut gusset_seam,
    seam_capacity: usize,
    report: *mut gusset_net_gluing_report,
) -> gusset_status {
    let report = input::output_struct(report, "report");
    guard_changing_call(ptr::null(), |job| {
        let (report, net) = (report?, net_of_handle(net)?);
        let (topology, shape) = (net.topology(), net.shape());
        let all = topology.seams();
        let mut found = gusset_net_gluing_report {
            struct_size: 0,
            matrix_size: shape.link_count(),
            seam_count: all.len(),
            bridge_count: net.bridges().len(),
            sides: topology.sides().map_or(u32::MAX, sides_to_bits),
            reversed: topology.is_reversed().into(),
        };
        let (matrix, seams) = ((matrix, matrix_capacity, "matrix"), (seams, seam_capacity, "seams"));
        fill_buffer(matrix, found.matrix_size, &mut found.matrix_size, job, || {
            Ok(topology.to_link_matrix()?.to_bytes(shape)?)
        })?;
        fill_buffer(seams, all.len(), &mut found.seam_count, job, || Ok(all.iter().map(gusset_seam::from)))?;
        report.write_known_fields(found);
        Ok(())
    })
}
