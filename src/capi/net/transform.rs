//! Affine maps: Moves, rotates and scales nets.

use crate::capi::context::{guard_changing_call, gusset_context};
use crate::capi::glue::{c_enum, constants, fixed};
use crate::capi::input::{self, read_choice};
use crate::capi::net::{gusset_net, net_of_handle_mut};
use crate::capi::status::{Failure, gusset_status};
use crate::net::transform::{Affine, Axis, RotationSense, transform};
use glam::DVec3;

/// Coordinate axis.
pub type gusset_axis = u32;
/// x.
pub const GUSSET_AXIS_X: gusset_axis = 0;
/// y.
pub const GUSSET_AXIS_Y: gusset_axis = 1;
/// z.
pub const GUSSET_AXIS_Z: gusset_axis = 2;

/// Kind of an affine map. It tells the values.
pub type gusset_operation_kind = u32;
/// Translation by values[0..2].
pub const GUSSET_OPERATION_TRANSLATE: gusset_operation_kind = 1;
/// Right-handed rotation by values[3] about the axis through values[4..6] along values[0..2], not
/// 0.
pub const GUSSET_OPERATION_ROTATE: gusset_operation_kind = 2;
/// Left-handed rotation, as Deryagin's formula is printed.
pub const GUSSET_OPERATION_ROTATE_AS_PRINTED: gusset_operation_kind = 3;
/// Scaling about the origin by the factor values[0].
pub const GUSSET_OPERATION_SCALE: gusset_operation_kind = 4;
/// Scaling of distances from axis by the factor values[0].
pub const GUSSET_OPERATION_COMPRESS: gusset_operation_kind = 5;
/// Scaling of x, y and z by values[0], values[1] and values[2].
pub const GUSSET_OPERATION_STRETCH: gusset_operation_kind = 6;
/// Affine map: three rows of four numbers, the last the displacement.
pub const GUSSET_OPERATION_MATRIX: gusset_operation_kind = 7;

/// Affine map.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_operation {
    /// Kind of an affine map.
    pub kind: gusset_operation_kind,
    /// For GUSSET_OPERATION_COMPRESS; else 0.
    pub axis: gusset_axis,
    /// As the kind says; the rest is not read.
    pub values: [f64; 12],
}

fixed! { gusset_operation: 104 }

/// Reads three of the caller's numbers.
pub(crate) fn first_three_numbers(values: &[f64]) -> DVec3 {
    DVec3::from_slice(values)
}

/// Reads twelve of the caller's numbers.
pub(crate) fn affine_from_numbers(values: &[f64]) -> Result<Affine, Failure> {
    Ok(Affine::new([0, 1, 2].map(|row| std::array::from_fn(|column| values[4 * row + column])))?)
}

c_enum! { axis: Axis { GUSSET_AXIS_X => X, GUSSET_AXIS_Y => Y, GUSSET_AXIS_Z => Z } }

impl gusset_operation {
    fn read_affine(&self) -> Result<Affine, Failure> {
        let v = &self.values;
        if self.kind != GUSSET_OPERATION_COMPRESS && self.axis != 0 {
            return Err(Failure::unknown_value("axis", self.axis.into(), "0 unless the operation compresses"));
        }
        Ok(match self.kind {
            GUSSET_OPERATION_TRANSLATE => Affine::translation(first_three_numbers(v))?,
            GUSSET_OPERATION_ROTATE => Affine::rotation(
                first_three_numbers(v),
                v[3],
                first_three_numbers(&v[4..]),
                RotationSense::RightHanded,
            )?,
            GUSSET_OPERATION_ROTATE_AS_PRINTED => {
                Affine::rotation(first_three_numbers(v), v[3], first_three_numbers(&v[4..]), RotationSense::AsPrinted)?
            }
            GUSSET_OPERATION_SCALE => Affine::scaling(v[0])?,
            GUSSET_OPERATION_COMPRESS => Affine::compression(read_choice(self.axis)?, v[0])?,
            GUSSET_OPERATION_STRETCH => Affine::stretching(first_three_numbers(v))?,
            GUSSET_OPERATION_MATRIX => affine_from_numbers(v)?,
            other => {
                return Err(Failure::unknown_choice(
                    "kind",
                    other,
                    &constants![
                        GUSSET_OPERATION_TRANSLATE,
                        GUSSET_OPERATION_ROTATE,
                        GUSSET_OPERATION_ROTATE_AS_PRINTED,
                        GUSSET_OPERATION_SCALE,
                        GUSSET_OPERATION_COMPRESS,
                        GUSSET_OPERATION_STRETCH,
                        GUSSET_OPERATION_MATRIX
                    ],
                ));
            }
        })
    }
}

/// Composes the caller's operations in order.
fn compose_operations(operations: *const gusset_operation, count: usize) -> Result<Affine, Failure> {
    let operations = input::input_items(operations, count, "operations")?;
    operations.enumerate().try_fold(Affine::IDENTITY, |chain, (k, operation)| {
        let then = |next: Affine| Ok(chain.then(&next)?);
        operation.read_affine().and_then(then).map_err(|failure: Failure| failure.with_item("operations", k))
    })
}

/// Moves a net by affine maps, composed in the given order.
///
/// - It computes in the net's scalar type.
/// - Equal bits of glued nodes stay equal, and missing nodes missing; other coordinates of theirs
///   may change.
/// - Mirroring changes the reversed flag, so that faces still look outwards.
///
/// @param count may be 0.
/// @errors OUT_OF_RANGE (not finite, axis of length 0, overflow of the product), FIELD_UNDEFINED
///     (first node to overflow)
/// @complexity O(nodes); no memory.
/// @source Deryagin, T, R, S, C.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_transform(
    context: *const gusset_context,
    net: *mut gusset_net,
    operations: *const gusset_operation,
    count: usize,
) -> gusset_status {
    guard_changing_call(context, |job| {
        let affine = compose_operations(operations, count)?;
        Ok(transform(net_of_handle_mut(net, job)?, &affine, job)?)
    })
}
