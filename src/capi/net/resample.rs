//! Resolutions: Resampled and decimated nets, and levels of detail.

use crate::capi::context::{create, create_and_tell, guard_change, gusset_context};
use crate::capi::glue::c_enum;
use crate::capi::handle;
use crate::capi::input::{self, choice};
use crate::capi::net::{gusset_net, read};
use crate::capi::status::gusset_status::GUSSET_ERROR_BUFFER_TOO_SMALL;
use crate::capi::status::{Failure, gusset_status};
use crate::job::Job;
use crate::net::resample::{Interpolation, decimate, pyramid, resample};
use gusset_base::alloc;

/// How positions between nodes are found.
pub type gusset_interpolation = u32;
/// On cubic splines after Catmull and Rom, which pass through all nodes with one tangent, across
/// seams too.
pub const GUSSET_INTERPOLATION_BICUBIC: gusset_interpolation = 0;
/// On the bilinear patches of the cells.
pub const GUSSET_INTERPOLATION_BILINEAR: gusset_interpolation = 1;

/// No pyramid has more levels.
pub const GUSSET_PYRAMID_LEVELS: usize = 32;

c_enum! {
    interpolation: Interpolation { GUSSET_INTERPOLATION_BICUBIC => Bicubic, GUSSET_INTERPOLATION_BILINEAR => Bilinear }
}

/// Makes a net of `rows` x `columns` nodes that are spread evenly over the rows and columns of
/// another; first and last ones stay, and new nodes that fall on old ones have their bits.
///
/// @param net glued along whole sides only, without bridges; the new one is glued in the same way,
///     glued nodes have equal bits.
/// @param rows of the result, at least 2.
/// @param columns of the result, at least 2.
/// @errors NET_TOO_SMALL, TOO_LARGE, GLUED_INSIDE
/// @complexity O(nodes of both).
/// @threads From any thread; the same bits for any number of threads.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_resample_create(
    context: *const gusset_context,
    net: *const gusset_net,
    rows: usize,
    columns: usize,
    interpolation: gusset_interpolation,
    resampled: *mut *mut gusset_net,
) -> gusset_status {
    create(context, resampled, "resampled", |job| {
        let interpolation = choice(interpolation)?;
        Ok(gusset_net::new(resample(read(net)?, rows, columns, interpolation, job)?))
    })
}

/// Makes a net of the rows and columns of another that matter most: rows, and then columns, are
/// left out, always the one whose loss costs least, as long as the tolerance allows.
///
/// @param net glued along whole sides only, without bridges.
/// @param tolerance at least 0, may be infinite; nodes are at most half of it away from the
///     segments that replace their columns, and as much from those that replace their rows.
/// @param rows receive the indices of what was kept, as many as the new net has; each has room for
///     as many as the old net has; NULL if not wanted.
/// @param columns see rows.
/// @param deviation receives what was reached; may be NULL.
/// @errors OUT_OF_RANGE, GLUED_INSIDE
/// @complexity About O(nodes x log rows).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_decimate_create(
    context: *const gusset_context,
    net: *const gusset_net,
    tolerance: f64,
    rows: *mut u32,
    columns: *mut u32,
    deviation: *mut f64,
    decimated: *mut *mut gusset_net,
) -> gusset_status {
    let deviation = input::optional_output(deviation, 0.0, "deviation");
    let decimated_net = |job: &Job<'_>| {
        let deviation = deviation?;
        let found = decimate(read(net)?, tolerance, job)?;
        write(&found.rows, rows, "rows")?;
        write(&found.columns, columns, "columns")?;
        Ok((gusset_net::new(found.net), (deviation, found.deviation)))
    };
    create_and_tell(context, decimated, "decimated", decimated_net, |(to, deviation)| input::set(to, deviation))
}

/// Writes indices to the caller's buffer, if there is one.
fn write(indices: &[usize], buffer: *mut u32, name: &'static str) -> Result<(), Failure> {
    if !buffer.is_null() {
        let to = input::results(buffer, indices.len(), name)?;
        to.iter_mut().zip(indices).for_each(|(to, &index)| *to = index as u32);
    }
    Ok(())
}

/// Makes nets of 2^k + 1 rows and columns, for levels of detail: the finest first, each of the
/// others every second row and column of the one before, bit for bit.
///
/// @param net glued along whole sides only, without bridges; if its sizes are 2^k + 1 already, the
///     first level is a copy, else it is resampled to the next sizes.
/// @param interpolation as for gusset_net_resample_create.
/// @param levels receives the nets, each for gusset_net_destroy; all NULL on failure.
/// @param capacity how many it has room for; GUSSET_PYRAMID_LEVELS is always enough.
/// @param count receives how many there are, also with BUFFER_TOO_SMALL, which capacity 0 gives
///     too.
/// @errors BUFFER_TOO_SMALL, TOO_LARGE, GLUED_INSIDE
/// @complexity O(nodes), memory for 4/3 of the first.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_pyramid_create(
    context: *const gusset_context,
    net: *const gusset_net,
    interpolation: gusset_interpolation,
    levels: *mut *mut gusset_net,
    capacity: usize,
    count: *mut usize,
) -> gusset_status {
    let (count, slots) = (input::output(count, 0, "count"), input::handles(levels, capacity, "levels"));
    guard_change(context, |job| {
        let (count, slots) = (count?, slots?);
        let made = pyramid(read(net)?, choice(interpolation)?, job)?;
        let made = alloc::collect(made.into_iter().map(|level| handle::boxed(gusset_net::new(level))))?;
        job.memory()?;
        *count = made.len();
        if capacity < made.len() {
            return Err(Failure::new(GUSSET_ERROR_BUFFER_TOO_SMALL, "levels is too small"));
        }
        slots.iter_mut().zip(made).for_each(|(slot, level)| *slot = handle::give(level));
        Ok(())
    })
}
