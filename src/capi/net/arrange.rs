//! Rows and columns: Parts, symmetries and conversions of nets.

use crate::capi::context::{create_handle, guard_changing_call, gusset_context};
use crate::capi::glue::{c_enum, constants, versioned};
use crate::capi::handle;
use crate::capi::input::{self, read_choice, read_flag};
use crate::capi::mesh::gusset_scalar;
use crate::capi::net::{gusset_net, net_of_handle_mut};
use crate::capi::status::{Failure, gusset_status};
use crate::net::{CopyOptions, Direction, GridSymmetry, Replication, Shape};

/// Direction within a net.
pub type gusset_direction = u32;
/// Along rows, from column to column.
pub const GUSSET_DIRECTION_RIGHT: gusset_direction = 0;
/// Along columns, from row to row.
pub const GUSSET_DIRECTION_DOWN: gusset_direction = 1;

/// Chooses the rows or columns to replicate.
pub type gusset_replication = u32;
/// All, as equally as possible.
pub const GUSSET_REPLICATE_UNIFORM: gusset_replication = 0;
/// The first.
pub const GUSSET_REPLICATE_FIRST: gusset_replication = 1;
/// The last.
pub const GUSSET_REPLICATE_LAST: gusset_replication = 2;
/// The one at the given index.
pub const GUSSET_REPLICATE_AT: gusset_replication = 3;
/// The poles among first and last, equally; else as UNIFORM.
pub const GUSSET_REPLICATE_AT_POLES: gusset_replication = 4;
/// Different sizes are an error; in gusset_concatenate_options only.
pub const GUSSET_REPLICATE_REFUSE: gusset_replication = 5;

/// Symmetry of the rectangle of nodes. Positions and normals of nodes stay.
pub type gusset_net_turn = u32;
/// No change.
pub const GUSSET_NET_TURN_NONE: gusset_net_turn = 0;
/// Quarter turn: the last column becomes the first row.
pub const GUSSET_NET_TURN_QUARTER: gusset_net_turn = 1;
/// Half turn: reverses rows and columns.
pub const GUSSET_NET_TURN_HALF: gusset_net_turn = 2;
/// Three quarters of a turn: the first column becomes the last row.
pub const GUSSET_NET_TURN_THREE_QUARTERS: gusset_net_turn = 3;
/// Reverses the order of columns.
pub const GUSSET_NET_TURN_FLIP_COLUMNS: gusset_net_turn = 4;
/// Reverses the order of rows.
pub const GUSSET_NET_TURN_FLIP_ROWS: gusset_net_turn = 5;
/// Exchanges rows and columns.
pub const GUSSET_NET_TURN_TRANSPOSE: gusset_net_turn = 6;
/// Exchanges rows and columns, and reverses both.
pub const GUSSET_NET_TURN_ANTITRANSPOSE: gusset_net_turn = 7;

/// Options of gusset_net_copy_create. Steps: part, compact, enlarge, turn, convert. Default: none.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_copy_options {
    /// sizeof(gusset_net_copy_options).
    pub struct_size: usize,
    /// First row of the part.
    pub row_first: usize,
    /// Rows of the part, at least 2; 0: the rest.
    pub row_count: usize,
    /// First column of the part.
    pub column_first: usize,
    /// Columns of the part, at least 2; 0: the rest.
    pub column_count: usize,
    /// Rows after replication, at least the present; 0: none. Links between copies are contracted.
    pub rows: usize,
    /// Columns after replication, likewise.
    pub columns: usize,
    /// 1: removes rows and columns that repeat the previous: equal coordinates and links,
    /// contracted links between. Two of each and ends of bridges stay.
    /// @flag
    pub compact: u32,
    /// For rows.
    pub row_replication: gusset_replication,
    /// For columns.
    pub column_replication: gusset_replication,
    /// Row to replicate.
    /// @when row_replication GUSSET_REPLICATE_AT
    pub row_index: u32,
    /// Column to replicate.
    /// @when column_replication GUSSET_REPLICATE_AT
    pub column_index: u32,
    /// Symmetry.
    pub turn: gusset_net_turn,
    /// 0: unchanged. Conversion to float rounds; overflowing nodes become missing.
    pub scalar: gusset_scalar,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_net_copy_options: 88 reserved }

c_enum! {
    direction: Direction { GUSSET_DIRECTION_RIGHT => Right, GUSSET_DIRECTION_DOWN => Down }
    turn: GridSymmetry {
        GUSSET_NET_TURN_NONE => None,
        GUSSET_NET_TURN_QUARTER => Quarter,
        GUSSET_NET_TURN_HALF => Half,
        GUSSET_NET_TURN_THREE_QUARTERS => ThreeQuarters,
        GUSSET_NET_TURN_FLIP_COLUMNS => FlipColumns,
        GUSSET_NET_TURN_FLIP_ROWS => FlipRows,
        GUSSET_NET_TURN_TRANSPOSE => Transpose,
        GUSSET_NET_TURN_ANTITRANSPOSE => Antitranspose,
    }
}

/// Converts the rows or columns that the caller replicates.
pub(crate) fn to_replication(value: gusset_replication, index: u32) -> Result<Replication, Failure> {
    match value {
        GUSSET_REPLICATE_UNIFORM => Ok(Replication::Uniform),
        GUSSET_REPLICATE_FIRST => Ok(Replication::First),
        GUSSET_REPLICATE_LAST => Ok(Replication::Last),
        GUSSET_REPLICATE_AT => Ok(Replication::At(index)),
        GUSSET_REPLICATE_AT_POLES => Ok(Replication::AtPoles),
        other => Err(Failure::unknown_choice(
            "replication",
            other,
            &constants![
                GUSSET_REPLICATE_UNIFORM,
                GUSSET_REPLICATE_FIRST,
                GUSSET_REPLICATE_LAST,
                GUSSET_REPLICATE_AT,
                GUSSET_REPLICATE_AT_POLES
            ],
        )),
    }
}

impl gusset_net_copy_options {
    fn checked(self, shape: Shape) -> Result<CopyOptions, Failure> {
        let range = |first: usize, count: usize, all: usize| match count {
            0 => first..all.max(first),
            count => first..first.saturating_add(count),
        };
        let part = [self.row_first, self.row_count, self.column_first, self.column_count].iter().any(|&n| n != 0);
        let rows = range(self.row_first, self.row_count, shape.rows());
        let columns = range(self.column_first, self.column_count, shape.columns());
        Ok(CopyOptions {
            part: part.then_some([rows, columns]),
            compact: read_flag(self.compact, "compact")?,
            rows: (self.rows != 0).then_some(self.rows),
            columns: (self.columns != 0).then_some(self.columns),
            replication: [
                to_replication(self.row_replication, self.row_index)?,
                to_replication(self.column_replication, self.column_index)?,
            ],
            turn: read_choice(self.turn)?,
            scalar: if self.scalar == 0 { None } else { Some(read_choice(self.scalar)?) },
        })
    }
}

/// Copies a net or a part with gluing and bridges: compacted, enlarged, turned, converted.
///
/// - Unchanged copies share memory until a net changes.
/// - A part keeps links, runs of seams and bridges inside it; with all rows or columns, also links
///   back to the first.
/// - Without conversion, coordinates keep their bits.
///
/// @errors NET_TOO_SMALL, OUT_OF_RANGE (a part or index beyond the net, fewer rows or columns than
///     present), CROSSING_CELL (without the gluing outside the part), TOO_LARGE
/// @complexity O(nodes) a step; O(1) unchanged, except in the caller's memory.
/// @source Deryagin, "Reformatting".
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_copy_create(
    context: *const gusset_context,
    net: *const gusset_net,
    options: *const gusset_net_copy_options,
    copy: *mut *mut gusset_net,
) -> gusset_status {
    create_handle(context, copy, "copy", |job| {
        let (handle, options) =
            (handle::get_object(net, "net")?, input::read_versioned_struct(options, true, "options")?);
        let net = handle.net();
        match net.changed_copy(&options.checked(net.shape())?, job)? {
            Some(changed) => Ok(gusset_net::new(changed)),
            None => Ok(gusset_net::from_shared(handle.share_net()?)),
        }
    })
}

/// Makes nodes with a coordinate equal to value missing.
///
/// @param value marks missing data.
/// @complexity O(nodes).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_clear_no_data(
    context: *const gusset_context,
    net: *mut gusset_net,
    value: f64,
) -> gusset_status {
    guard_changing_call(context, |job| {
        net_of_handle_mut(net, job)?.clear_no_data(value);
        Ok(())
    })
}
