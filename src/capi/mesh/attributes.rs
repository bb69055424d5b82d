//! Attributes: Transfers colours, normals and other values to results.
//!
//! @source Means of directions after S. Buss and J. Fillmore (2001); charts across gaps are our
//!     own.

use crate::attributes::{Channel, Origins, Output, Rule, ValueType, carry_values_over};
use crate::capi::context::{guard_call, gusset_context};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle;
use crate::capi::input::{self, read_choice};
use crate::capi::mesh::origins::{gusset_domain, gusset_origins};
use crate::capi::mesh::{self, gusset_mesh_view};
use crate::capi::status::gusset_status::{GUSSET_ERROR_BUFFER_TOO_SMALL, GUSSET_ERROR_OVERLAP};
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::job::Job;
use crate::mesh::merge::map_to_equal_vertices;
use gusset_base::geom::strided::Strided;
use std::ffi::c_void;

/// Type of values.
pub type gusset_value_type = u32;
/// 32-bit floats.
pub const GUSSET_VALUE_F32: gusset_value_type = 1;
/// 64-bit floats.
pub const GUSSET_VALUE_F64: gusset_value_type = 2;
/// 8-bit unsigned integers.
pub const GUSSET_VALUE_U8: gusset_value_type = 3;
/// 16-bit unsigned integers.
pub const GUSSET_VALUE_U16: gusset_value_type = 4;
/// 32-bit unsigned integers.
pub const GUSSET_VALUE_U32: gusset_value_type = 5;

/// Rule that combines the values of several sources. A single source's value stays bit for bit.
pub type gusset_rule = u32;
/// Weighted mean; integers are rounded.
pub const GUSSET_RULE_LINEAR: gusset_rule = 0;
/// Directions of three floats: weighted mean on the sphere, of length 1. Reversed faces negate
/// theirs.
pub const GUSSET_RULE_NORMAL: gusset_rule = 1;
/// Bone weights, at least 0: weighted mean. The max_influences largest (the first of equals) are
/// scaled to the sum 1, or an integer type's largest value.
pub const GUSSET_RULE_SKIN_WEIGHTS: gusset_rule = 2;
/// Value of the source with the largest weight (the first of equals).
pub const GUSSET_RULE_NEAREST: gusset_rule = 3;
/// Texture coordinates. Vertices and faces: weighted mean. Corners of new faces:
/// - Weighted mean where both sides are on one chart. Most new faces must agree: the far side's
///   values deviate from the continued chart by less than half the old edge's length and distance
///   combined.
/// - Elsewhere each new face continues its old face's unfolded chart, up to a seam in the middle,
///   never back over the chart.
/// - At the cut of a chart that closes on itself, values shift by the jump there, if that repeats
///   the texture.
/// - A rim is on one chart while old faces have equal values at common vertices.
pub const GUSSET_RULE_TEXTURE: gusset_rule = 4;

c_enum! {
    value_type: ValueType {
        GUSSET_VALUE_F32 => F32,
        GUSSET_VALUE_F64 => F64,
        GUSSET_VALUE_U8 => U8,
        GUSSET_VALUE_U16 => U16,
        GUSSET_VALUE_U32 => U32,
    }
    rule: Rule {
        GUSSET_RULE_LINEAR => Linear,
        GUSSET_RULE_NORMAL => Normal,
        GUSSET_RULE_SKIN_WEIGHTS => SkinWeights,
        GUSSET_RULE_NEAREST => Nearest,
        GUSSET_RULE_TEXTURE => Texture,
    }
}

/// Attribute of elements.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_channel {
    /// sizeof(gusset_channel).
    pub struct_size: usize,
    /// Kind of element.
    pub domain: gusset_domain,
    /// Must be set: 0 is invalid.
    pub value_type: gusset_value_type,
    /// Values of an element, 1 to 4096.
    pub components: u32,
    /// Rule that combines the values of several sources.
    pub rule: gusset_rule,
    /// Weights that GUSSET_RULE_SKIN_WEIGHTS keeps for elements with several sources; 0: all.
    pub max_influences: u32,
    /// 0.
    pub reserved: u32,
}

/// Values of the elements of one input.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Zeroable)]
pub struct gusset_channel_values {
    /// Components of each element. NULL with count 0: the input lacks them; its elements get 0, and
    /// new elements other sources' values.
    pub values: *const c_void,
    /// Number of the input's elements.
    pub count: usize,
    /// Stride in bytes; 0 if packed.
    pub stride: usize,
}

versioned! { gusset_channel: 32 reserved }
fixed! { gusset_channel_values: 24 }

/// Transfers values from elements of inputs to a result's.
///
/// Elements without sources that have values get 0.
///
/// @param inputs values of each input of the origins, in order.
/// @param values receives the components of each element, at any alignment; bytes between do not
///     change. Must not overlap the inputs' values.
/// @param count room in elements, at least the elements of the result.
/// @param stride in bytes; 0 if packed.
/// @errors OUT_OF_RANGE (components; value_type and components that the rule refuses; a negative
///     skin weight, with element and input), NOT_FINITE (with element and input, except for
///     GUSSET_RULE_NEAREST), COUNT_DIFFERS (of inputs, or of values, with the input), BAD_STRIDE,
///     BUFFER_TOO_SMALL, OVERLAP
/// @complexity O(sources and elements), parallel; no memory, but GUSSET_RULE_TEXTURE linear in the
///     corners of new faces.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_attributes_apply(
    context: *const gusset_context,
    origins: *const gusset_origins,
    channel: *const gusset_channel,
    inputs: *const gusset_channel_values,
    input_count: usize,
    values: *mut c_void,
    count: usize,
    stride: usize,
) -> gusset_status {
    guard_call(context, |job| {
        let given = input::read_versioned_struct(channel, false, "channel")?;
        let origins = &handle::get_object(origins, "origins")?.0;
        carry_over_channel(origins, given, (inputs, input_count), (values, count, stride), job)
    })
}

/// The body of [`gusset_attributes_apply`], with the caller's channel, inputs and room for values.
pub(crate) fn carry_over_channel(
    origins: &Origins,
    given: gusset_channel,
    (inputs, input_count): (*const gusset_channel_values, usize),
    (values, count, stride): (*mut c_void, usize, usize),
    job: &Job<'_>,
) -> Result<(), Failure> {
    let domain = read_choice(given.domain)?;
    let made = Channel::new(domain, read_choice(given.value_type)?, given.components, read_choice(given.rule)?);
    let mut channel = made
        .map_err(|error| match error {
            Error::OptionOutOfRange { option: option @ "value_type", allowed, .. } => {
                Error::OptionOutOfRange { option, value: given.value_type.into(), allowed }
            }
            other => other,
        })?
        .with_max_influences(given.max_influences);
    // Check the count before reading any of them.
    let inputs_needed = origins.inputs().len();
    if input_count != inputs_needed {
        return Err(Error::InputsDiffer { given: input_count as u64, needed: inputs_needed as u64 }.into());
    }
    let room = Strided::byte_span(count, stride, channel.bytes_per_value(), "values")?;
    let room_range = values as usize..(values as usize).saturating_add(room);
    for k in 0..input_count {
        let of_input = |failure: Failure| failure.with_input(k as u32).within_item("inputs", k);
        let one = input::checked_reference(inputs.wrapping_add(k), "inputs").map_err(of_input)?;
        if one.values.is_null() && one.count == 0 {
            channel.push_missing()?;
            continue;
        }
        let size = Strided::byte_span(one.count, one.stride, channel.bytes_per_value(), "values")
            .map_err(|error| of_input(error.into()))?;
        let bytes = input::input_bytes(one.values, size, 1, "values").map_err(of_input)?;
        let range = bytes.as_ptr_range();
        if !bytes.is_empty() && (range.start as usize) < room_range.end && room_range.start < range.end as usize {
            return Err(of_input(Failure::new(
                GUSSET_ERROR_OVERLAP,
                "the output overlaps these values; pass separate arrays",
            )));
        }
        channel.push(bytes, one.stride, one.count)?;
    }
    let needed = origins.table(domain).len();
    if count < needed {
        let message = format!("values has room for {count} elements; it needs room for {needed}");
        return Err(Failure { value: needed as f64, ..Failure::new(GUSSET_ERROR_BUFFER_TOO_SMALL, message) });
    }
    let out = input::result_buffer(values.cast::<u8>(), room, "values")?;
    let mut out = Output::new(out, stride, count, channel.value_type_and_components())?;
    Ok(carry_values_over(origins, &channel, &mut out, job)?)
}

/// Finds which vertices are one, for merge of gusset_mesh_view: those with equal keys, or else with
/// equal finite positions, -0 equal to 0.
///
/// @param keys one for each vertex; NULL: positions.
/// @param merge receives for each vertex the smallest that it is one with, at any alignment.
/// @errors as gusset_mesh_view
/// @complexity O(V log V) for V vertices; 8 bytes for each, 12 with keys.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_mesh_find_merge(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    keys: *const u32,
    merge: *mut u32,
) -> gusset_status {
    guard_call(context, |job| {
        let given_mesh = mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.1))?;
        let mesh = given_mesh.mesh_view();
        let count = mesh.positions().len();
        let keys = (!keys.is_null()).then(|| input::copy_input_items(keys, count, "keys")).transpose()?;
        let found = map_to_equal_vertices(&mesh, keys.as_deref(), &job.sub_job(0.1, 1.0))?;
        if merge.is_null() {
            return Err(Failure::null_argument("merge"));
        }
        input::result_buffer(merge.cast::<u8>(), 4 * count, "merge")?.copy_from_slice(bytemuck::cast_slice(&found));
        Ok(())
    })
}
