//! Rows and columns: Parts, symmetries and other layouts of nets.

use crate::capi::context::{create, guard_change, gusset_context};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::handle;
use crate::capi::input::{self, choice, flag};
use crate::capi::mesh::gusset_scalar;
use crate::capi::net::{edit, gusset_net};
use crate::capi::status::{Failure, gusset_status};
use crate::net::{CopyOptions, Direction, Replication, Shape, Turn};

/// A direction within a net.
pub type gusset_direction = u32;
/// Along rows, from column to column.
pub const GUSSET_DIRECTION_RIGHT: gusset_direction = 0;
/// Along columns, from row to row.
pub const GUSSET_DIRECTION_DOWN: gusset_direction = 1;

/// Which rows, or columns, are replicated.
pub type gusset_replication = u32;
/// All of them, as equally as it goes.
pub const GUSSET_REPLICATE_UNIFORM: gusset_replication = 0;
/// The first one.
pub const GUSSET_REPLICATE_FIRST: gusset_replication = 1;
/// The last one.
pub const GUSSET_REPLICATE_LAST: gusset_replication = 2;
/// The one whose index is given.
pub const GUSSET_REPLICATE_AT: gusset_replication = 3;
/// The first and the last one, if they are a point each, in equal shares; if one of them is, that
/// one; else as UNIFORM.
pub const GUSSET_REPLICATE_AT_POLES: gusset_replication = 4;
/// None: sizes that differ are refused. For gusset_concatenate_options only.
pub const GUSSET_REPLICATE_REFUSE: gusset_replication = 5;

/// A symmetry of the rectangle of nodes. Nodes stay where they are in space, and so do normals.
pub type gusset_net_turn = u32;
/// Rows and columns stay.
pub const GUSSET_NET_TURN_NONE: gusset_net_turn = 0;
/// A quarter of a turn: the last column becomes the first row.
pub const GUSSET_NET_TURN_QUARTER: gusset_net_turn = 1;
/// Half a turn: the last row and the last column come first.
pub const GUSSET_NET_TURN_HALF: gusset_net_turn = 2;
/// Three quarters of a turn: the first column becomes the last row.
pub const GUSSET_NET_TURN_THREE_QUARTERS: gusset_net_turn = 3;
/// The last column comes first.
pub const GUSSET_NET_TURN_FLIP_COLUMNS: gusset_net_turn = 4;
/// The last row comes first.
pub const GUSSET_NET_TURN_FLIP_ROWS: gusset_net_turn = 5;
/// Rows and columns are exchanged.
pub const GUSSET_NET_TURN_TRANSPOSE: gusset_net_turn = 6;
/// Rows and columns are exchanged, both backwards.
pub const GUSSET_NET_TURN_ANTITRANSPOSE: gusset_net_turn = 7;

/// How a copy of a net differs from it. All zeros: not at all. A part is taken first; then it is
/// made compact, enlarged, turned and converted.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_copy_options {
    /// sizeof(gusset_net_copy_options), set by the caller.
    pub struct_size: usize,
    /// The first row of the part that is copied.
    pub row_first: usize,
    /// The number of rows of the part, at least 2; 0: all from row_first on.
    pub row_count: usize,
    /// The first column of the part.
    pub column_first: usize,
    /// The number of columns of the part, at least 2; 0: all from column_first on.
    pub column_count: usize,
    /// The number of rows of nodes after replication, no fewer than there are; 0: as many as there
    /// are. Links between copies of a row are contracted, and the surface stays.
    pub rows: usize,
    /// The number of columns of nodes, likewise.
    pub columns: usize,
    /// 1: rows and columns that repeat the one before them are left out. The links between the two
    /// are all contracted, and coordinates and links along them are equal. Two rows and two columns
    /// stay, and so do those on which a bridge ends. 0 or 1.
    /// @flag
    pub compact: u32,
    /// For rows.
    pub row_replication: gusset_replication,
    /// For columns.
    pub column_replication: gusset_replication,
    /// Read for GUSSET_REPLICATE_AT: the row.
    /// @when row_replication GUSSET_REPLICATE_AT
    pub row_index: u32,
    /// Read for GUSSET_REPLICATE_AT: the column.
    /// @when row_replication GUSSET_REPLICATE_AT
    pub column_index: u32,
    /// The symmetry that rows and columns undergo.
    pub turn: gusset_net_turn,
    /// GUSSET_F32 or GUSSET_F64: the type of the coordinates. From double to float they are rounded,
    /// and nodes whose coordinates are too large become missing. 0: the type of the net.
    pub scalar: gusset_scalar,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_net_copy_options: 88 reserved }

c_enum! {
    direction: Direction { GUSSET_DIRECTION_RIGHT => Right, GUSSET_DIRECTION_DOWN => Down }
    turn: Turn {
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

/// What the caller wants replicated.
pub(crate) fn replication(value: gusset_replication, index: u32) -> Result<Replication, Failure> {
    match value {
        GUSSET_REPLICATE_UNIFORM => Ok(Replication::Uniform),
        GUSSET_REPLICATE_FIRST => Ok(Replication::First),
        GUSSET_REPLICATE_LAST => Ok(Replication::Last),
        GUSSET_REPLICATE_AT => Ok(Replication::At(index)),
        GUSSET_REPLICATE_AT_POLES => Ok(Replication::AtPoles),
        other => Err(Failure::unknown("replication", other.into())),
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
            compact: flag(self.compact, "compact")?,
            rows: (self.rows != 0).then_some(self.rows),
            columns: (self.columns != 0).then_some(self.columns),
            replication: [
                replication(self.row_replication, self.row_index)?,
                replication(self.column_replication, self.column_index)?,
            ],
            turn: choice(self.turn)?,
            scalar: if self.scalar == 0 { None } else { Some(choice(self.scalar)?) },
        })
    }
}

/// Makes a copy of a net, with its gluing and its bridges: of all of it or of a part, with more or
/// fewer rows and columns, turned, or with coordinates of another type.
///
/// A copy that differs in nothing shares the memory of the net until one of the two is changed. A
/// part keeps the links, runs of seams and bridges within it. It keeps links that lead back if it
/// has all rows, or all columns. A part, a compact, a turned or a larger net keeps the bits of its
/// coordinates.
///
/// @param options NULL for a copy that differs in nothing.
/// @errors NET_TOO_SMALL (a part of one row or column), OUT_OF_RANGE (a part beyond the net, fewer
///     rows or columns than there are, an index beyond the net), CROSSING_CELL (only what is
///     outside the part made opposite corners one), TOO_LARGE
/// @complexity O(nodes) for each step; O(1) for a copy that differs in nothing, unless the net is
///     in the caller's memory.
/// @source Deryagin, "Reformatting".
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_copy_create(
    context: *const gusset_context,
    net: *const gusset_net,
    options: *const gusset_net_copy_options,
    copy: *mut *mut gusset_net,
) -> gusset_status {
    create(context, copy, "copy", |job| {
        let (handle, options) = (handle::get(net, "net")?, input::read(options, true, "options")?);
        let net = handle.net();
        match net.changed_copy(&options.checked(net.shape())?, job)? {
            Some(changed) => Ok(gusset_net::new(changed)),
            None => Ok(gusset_net::of_shared(handle.share()?)),
        }
    })
}

/// Makes missing every node of which a coordinate is `value`, the number that stands for what a
/// scanner did not see.
///
/// @param value the marker of missing data, compared exactly.
/// @complexity O(nodes).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_clear_no_data(
    context: *const gusset_context,
    net: *mut gusset_net,
    value: f64,
) -> gusset_status {
    guard_change(context, |job| {
        edit(net, job)?.clear_no_data(value);
        Ok(())
    })
}
