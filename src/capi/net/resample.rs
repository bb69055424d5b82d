//! Resolutions: Resamples and decimates nets; levels of detail.

use crate::capi::context::{create_handle, create_handle_and_outputs, guard_changing_call, gusset_context};
use crate::capi::glue::c_enum;
use crate::capi::handle;
use crate::capi::input::{self, read_choice};
use crate::capi::net::{gusset_net, net_of_handle};
use crate::capi::status::gusset_status::GUSSET_ERROR_BUFFER_TOO_SMALL;
use crate::capi::status::{Failure, gusset_status};
use crate::job::Job;
use crate::net::resample::{Interpolation, decimate, pyramid, resample};
use gusset_base::alloc;

/// Interpolation of positions between nodes.
pub type gusset_interpolation = u32;
/// Catmull-Rom splines: continuous tangents, also across seams.
pub const GUSSET_INTERPOLATION_BICUBIC: gusset_interpolation = 0;
/// Bilinear patches of the cells.
pub const GUSSET_INTERPOLATION_BILINEAR: gusset_interpolation = 1;

/// Most levels of a pyramid.
pub const GUSSET_PYRAMID_LEVELS: usize = 32;

c_enum! {
    interpolation: Interpolation { GUSSET_INTERPOLATION_BICUBIC => Bicubic, GUSSET_INTERPOLATION_BILINEAR => Bilinear }
}

/// Makes a net of rows x columns nodes, spread evenly over net.
///
/// First and last rows and columns and the gluing stay. A new node on an old one has its bits;
/// glued nodes have equal bits.
///
/// @param rows at least 2.
/// @param columns at least 2.
/// @errors NET_TOO_SMALL, TOO_LARGE, GLUED_INSIDE
/// @complexity O(nodes of both nets).
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
    create_handle(context, resampled, "resampled", |job| {
        let interpolation = read_choice(interpolation)?;
        Ok(gusset_net::new(resample(net_of_handle(net)?, rows, columns, interpolation, job)?))
    })
}

/// Removes rows, then columns, within a tolerance, each time with the least deviation.
///
/// @param tolerance may be INFINITY. Nodes are within half of it of the segments that replace their
///     columns; likewise rows.
/// @param rows receives the kept rows, with room for all; may be NULL.
/// @param columns likewise.
/// @param deviation receives the largest deviation, or NULL.
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
    let deviation = input::cleared_optional_output(deviation, 0.0, "deviation");
    let decimated_net = |job: &Job<'_>| {
        let deviation = deviation?;
        let found = decimate(net_of_handle(net)?, tolerance, job)?;
        write_indices(&found.rows, rows, "rows")?;
        write_indices(&found.columns, columns, "columns")?;
        Ok((gusset_net::new(found.net), (deviation, found.deviation)))
    };
    create_handle_and_outputs(context, decimated, "decimated", decimated_net, |(to, deviation)| {
        input::set_optional_output(to, deviation);
    })
}

/// Writes indices to the caller's buffer, unless it is NULL.
fn write_indices(indices: &[usize], buffer: *mut u32, name: &'static str) -> Result<(), Failure> {
    if !buffer.is_null() {
        let to = input::result_buffer(buffer, indices.len(), name)?;
        to.iter_mut().zip(indices).for_each(|(to, &index)| *to = index as u32);
    }
    Ok(())
}

/// Makes levels of detail: nets of 2^k + 1 rows and columns, finest first.
///
/// The first is a copy if the net has such a size, else resampled to the next larger. Each other
/// has every second row and column, bit for bit.
///
/// @param levels receives the handles.
/// @param capacity GUSSET_PYRAMID_LEVELS always suffices.
/// @param count receives the count; capacity must exceed 0.
/// @errors BUFFER_TOO_SMALL, TOO_LARGE, GLUED_INSIDE
/// @complexity O(nodes); memory for 4/3 of the first level.
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
    let (count, slots) = (input::cleared_output(count, 0, "count"), input::handle_buffer(levels, capacity, "levels"));
    guard_changing_call(context, |job| {
        let (count, slots) = (count?, slots?);
        let made = pyramid(net_of_handle(net)?, read_choice(interpolation)?, job)?;
        let made = alloc::collect(made.into_iter().map(|level| handle::box_with_kind(gusset_net::new(level))))?;
        job.finish()?;
        *count = made.len();
        if capacity < made.len() {
            let (needed, status) = (made.len(), GUSSET_ERROR_BUFFER_TOO_SMALL);
            let message = format!("levels has room for {capacity} nets; it needs room for {needed}");
            return Err(Failure { value: needed as f64, ..Failure::new(status, message) });
        }
        slots.iter_mut().zip(made).for_each(|(slot, level)| *slot = handle::into_handle(level));
        Ok(())
    })
}
