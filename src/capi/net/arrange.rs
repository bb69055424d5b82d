//! C interface: nets with their nodes rearranged.

use crate::capi::context::{create, guard_change, gusset_context};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::{self, choice};
use crate::capi::net::{edit, gusset_net, read};
use crate::capi::status::{Failure, gusset_status};
use crate::net::{Direction, Replication};

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

/// How a net is reformatted.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_reformat_options {
    /// sizeof(gusset_reformat_options), set by the caller.
    pub struct_size: usize,
    /// The rows of nodes wanted, no fewer than there are; 0 for as many as there are.
    pub rows: usize,
    /// The columns, likewise.
    pub columns: usize,
    /// GUSSET_REPLICATE_... for rows.
    pub row_replication: gusset_replication,
    /// GUSSET_REPLICATE_... for columns.
    pub column_replication: gusset_replication,
    /// Read for GUSSET_REPLICATE_AT: the row.
    pub row_index: u32,
    /// Read for GUSSET_REPLICATE_AT: the column.
    pub column_index: u32,
}

versioned! { gusset_reformat_options: 40 }

c_enum! { direction: Direction { GUSSET_DIRECTION_RIGHT => Right, GUSSET_DIRECTION_DOWN => Down } }

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

/// A rectangle of a net: coordinates bit for bit, the links and runs of seams within it, the
/// bridges that cross it.
///
/// Links that lead back are within it if all rows, or all columns, are.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param row_first its first row.
/// @param row_count how many rows, at least 2.
/// @param column_first its first column.
/// @param column_count how many columns, at least 2.
/// @param[out] part receives it, for gusset_net_destroy, as for all functions of this group; NULL
///     on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NET_TOO_SMALL (a count below
///     2), OUT_OF_RANGE (beyond the net), CROSSING_CELL (only what is outside made opposite corners
///     one), OUT_OF_MEMORY, CANCELLED.
/// @complexity O(nodes of the part), and O(contracted links).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_part_create(
    context: *const gusset_context,
    net: *const gusset_net,
    row_first: usize,
    row_count: usize,
    column_first: usize,
    column_count: usize,
    part: *mut *mut gusset_net,
) -> gusset_status {
    create(context, part, "part", |job| {
        let rows = row_first..row_first.saturating_add(row_count);
        let columns = column_first..column_first.saturating_add(column_count);
        Ok(gusset_net::new(read(net)?.part(rows, columns, job)?))
    })
}

/// The net with rows and columns exchanged.
///
/// The surface stays as it is in space, and so do its normals: faces are taken the other way round
/// from then on.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param[out] transposed receives the result, for gusset_net_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(nodes).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_transpose_create(
    context: *const gusset_context,
    net: *const gusset_net,
    transposed: *mut *mut gusset_net,
) -> gusset_status {
    create(context, transposed, "transposed", |job| Ok(gusset_net::new(read(net)?.transposed(job)?)))
}

/// The net the other way round.
///
/// Normals stay, as for gusset_net_transpose_create.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param direction GUSSET_DIRECTION_RIGHT puts the last column first, GUSSET_DIRECTION_DOWN the
///     last row.
/// @param[out] flipped receives the result, for gusset_net_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: as there, UNKNOWN_VALUE.
/// @complexity O(nodes).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_flip_create(
    context: *const gusset_context,
    net: *const gusset_net,
    direction: gusset_direction,
    flipped: *mut *mut gusset_net,
) -> gusset_status {
    create(context, flipped, "flipped", |job| {
        let direction: Direction = choice(direction)?;
        Ok(gusset_net::new(read(net)?.flipped(direction, job)?))
    })
}

/// The net turned.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param quarters how many quarters of a turn, any number: after one, the last column is the first
///     row; negative ones turn back.
/// @param[out] turned receives the result, for gusset_net_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: as gusset_net_transpose_create.
/// @complexity O(nodes).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_turn_create(
    context: *const gusset_context,
    net: *const gusset_net,
    quarters: i32,
    turned: *mut *mut gusset_net,
) -> gusset_status {
    create(context, turned, "turned", |job| Ok(gusset_net::new(read(net)?.turned(quarters, job)?)))
}

/// A larger net that is the same surface: rows and columns are replicated, and the links between
/// copies contracted.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param options NULL for the defaults.
/// @param[out] reformatted receives the result, for gusset_net_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     UNKNOWN_VALUE, OUT_OF_RANGE (fewer rows or columns than there are, an index beyond the net),
///     TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(nodes).
/// @source Deryagin, "Reformatting".
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_reformat_create(
    context: *const gusset_context,
    net: *const gusset_net,
    options: *const gusset_reformat_options,
    reformatted: *mut *mut gusset_net,
) -> gusset_status {
    create(context, reformatted, "reformatted", |job| {
        let options = input::read(options, false, "options")?;
        let net = read(net)?;
        let or = |count: usize, there: usize| if count == 0 { there } else { count };
        let rows = or(options.rows, net.shape().rows());
        let columns = or(options.columns, net.shape().columns());
        let how = [
            replication(options.row_replication, options.row_index)?,
            replication(options.column_replication, options.column_index)?,
        ];
        Ok(gusset_net::new(net.reformatted(rows, columns, how, job)?))
    })
}

/// The net without the rows and columns that are the one before them again: links between the two
/// all contracted, coordinates and links along them the same.
///
/// The inverse of gusset_net_reformat_create for nets that had none. Two of each are left, and
/// those that a bridge ends on.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param[out] compacted receives the result, for gusset_net_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(nodes).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_compact_create(
    context: *const gusset_context,
    net: *const gusset_net,
    compacted: *mut *mut gusset_net,
) -> gusset_status {
    create(context, compacted, "compacted", |job| Ok(gusset_net::new(read(net)?.compacted(job)?)))
}

/// Makes missing every node of which a coordinate is `value`, the number that stands for what a
/// scanner did not see.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param[in,out] net the net.
/// @param value the marker of missing data, compared exactly.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY.
/// @complexity O(nodes).
/// @since 0.1
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
