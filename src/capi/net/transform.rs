//! Affine maps: Moves, rotates and scales nets.

use crate::capi::context::{guard_change, gusset_context};
use crate::capi::glue::{c_enum, fixed};
use crate::capi::input::{self, choice};
use crate::capi::net::{edit, gusset_net};
use crate::capi::status::{Failure, gusset_status};
use crate::net::transform::{Affine, Axis, Sense, transform};
use glam::DVec3;

/// An axis of coordinates: 0 is x, 1 is y, 2 is z.
pub type gusset_axis = u32;
/// The abscissa.
pub const GUSSET_AXIS_X: gusset_axis = 0;
/// The ordinate.
pub const GUSSET_AXIS_Y: gusset_axis = 1;
/// The applicate.
pub const GUSSET_AXIS_Z: gusset_axis = 2;

/// What an operation does.
pub type gusset_operation_kind = u32;
/// Moves by the vector values[0] to values[2].
pub const GUSSET_OPERATION_TRANSLATE: gusset_operation_kind = 1;
/// Turns about the axis with the direction values[0] to values[2], of any length but 0, by
/// values[3] radians, by the right hand; the axis passes through the point values[4] to values[6].
pub const GUSSET_OPERATION_ROTATE: gusset_operation_kind = 2;
/// The same by the left hand, as Deryagin's formula is printed.
pub const GUSSET_OPERATION_ROTATE_AS_PRINTED: gusset_operation_kind = 3;
/// Scales about the origin: values[0] is the ratio of new distance to old.
pub const GUSSET_OPERATION_SCALE: gusset_operation_kind = 4;
/// Scales about the axis of coordinates `axis`, which stays: values[0] is the ratio of new distance
/// to old.
pub const GUSSET_OPERATION_COMPRESS: gusset_operation_kind = 5;
/// Scales x, y and z by values[0], values[1] and values[2].
pub const GUSSET_OPERATION_STRETCH: gusset_operation_kind = 6;
/// Any affine map: three rows of four numbers, the fourth of each the displacement.
pub const GUSSET_OPERATION_MATRIX: gusset_operation_kind = 7;

/// A spatial operation.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_operation {
    /// What an operation does.
    pub kind: gusset_operation_kind,
    /// For GUSSET_OPERATION_COMPRESS; else 0.
    pub axis: gusset_axis,
    /// What the kind says; the rest is not read.
    pub values: [f64; 12],
}

fixed! { gusset_operation: 104 }

/// Three of the caller's numbers.
pub(crate) fn vector(values: &[f64]) -> DVec3 {
    DVec3::from_slice(values)
}

/// Twelve of the caller's numbers.
pub(crate) fn matrix(values: &[f64]) -> Result<Affine, Failure> {
    Ok(Affine::new([0, 1, 2].map(|row| std::array::from_fn(|column| values[4 * row + column])))?)
}

c_enum! { axis: Axis { GUSSET_AXIS_X => X, GUSSET_AXIS_Y => Y, GUSSET_AXIS_Z => Z } }

impl gusset_operation {
    fn affine(&self) -> Result<Affine, Failure> {
        let v = &self.values;
        if self.kind != GUSSET_OPERATION_COMPRESS && self.axis != 0 {
            return Err(Failure::unknown("axis", self.axis.into()));
        }
        Ok(match self.kind {
            GUSSET_OPERATION_TRANSLATE => Affine::translation(vector(v))?,
            GUSSET_OPERATION_ROTATE => Affine::rotation(vector(v), v[3], vector(&v[4..]), Sense::RightHanded)?,
            GUSSET_OPERATION_ROTATE_AS_PRINTED => Affine::rotation(vector(v), v[3], vector(&v[4..]), Sense::AsPrinted)?,
            GUSSET_OPERATION_SCALE => Affine::scaling(v[0])?,
            GUSSET_OPERATION_COMPRESS => Affine::compression(choice(self.axis)?, v[0])?,
            GUSSET_OPERATION_STRETCH => Affine::stretching(vector(v))?,
            GUSSET_OPERATION_MATRIX => matrix(v)?,
            other => return Err(Failure::unknown("kind", other.into())),
        })
    }
}

/// The operations of the caller's, one after the other, as one map.
fn chain(operations: *const gusset_operation, count: usize) -> Result<Affine, Failure> {
    let operations = input::items(operations, count, "operations")?;
    operations.enumerate().try_fold(Affine::IDENTITY, |chain, (k, operation)| {
        let then = |next: Affine| Ok(chain.then(&next)?);
        operation.affine().and_then(then).map_err(|failure: Failure| failure.of_item(k))
    })
}

/// Moves all nodes of a net by operations, the first one first, composed to one matrix and applied
/// in one pass, in place.
///
/// The arithmetic is that of the net's scalar type; nodes that are glued and have equal bits keep
/// them equal; missing nodes stay missing (and may lose coordinates that were finite). If the
/// operations together mirror (odd numbers of reflections) the surface would be turned inside out:
/// the net's flag `reversed` changes then, so that faces look outwards as before. A cancel is heard
/// before the first node is moved; whatever the error, none is moved.
///
/// @param operations `count` of them, at any alignment; 0 for none.
/// @param count see operations.
/// @errors UNKNOWN_VALUE (kind, axis), OUT_OF_RANGE (a number that is not finite, an axis of length
///     0, a product that overflows), FIELD_UNDEFINED (with the first node that would overflow),
///     OUT_OF_MEMORY (a net that shares its memory)
/// @complexity O(nodes), no memory.
/// @threads The same bits for any number of threads.
/// @source Deryagin, T, R, S, C.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_transform(
    context: *const gusset_context,
    net: *mut gusset_net,
    operations: *const gusset_operation,
    count: usize,
) -> gusset_status {
    guard_change(context, |job| {
        let affine = chain(operations, count)?;
        Ok(transform(edit(net, job)?, &affine, job)?)
    })
}
