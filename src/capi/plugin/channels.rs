//! Attributes: Extension that transfers values of elements to outputs.

use super::descriptor::{gusset_failure, gusset_host};
use super::outcome::gusset_outputs;
use crate::capi::glue::{fixed, laid_out_like, versioned};
use crate::capi::mesh::attributes::{self as library, gusset_channel, gusset_channel_values};
use crate::capi::mesh::origins as domains;
use std::ffi::c_void;

/// Vertices.
pub const GUSSET_PLUGIN_VERTICES: u32 = 0;
/// Corners, as in face_corners.
pub const GUSSET_PLUGIN_CORNERS: u32 = 1;
/// Faces.
pub const GUSSET_PLUGIN_FACES: u32 = 2;

/// 32-bit floats.
pub const GUSSET_PLUGIN_VALUE_F32: u32 = 1;
/// 64-bit floats.
pub const GUSSET_PLUGIN_VALUE_F64: u32 = 2;
/// 8-bit unsigned integers.
pub const GUSSET_PLUGIN_VALUE_U8: u32 = 3;
/// 16-bit unsigned integers.
pub const GUSSET_PLUGIN_VALUE_U16: u32 = 4;
/// 32-bit unsigned integers.
pub const GUSSET_PLUGIN_VALUE_U32: u32 = 5;

/// Weighted mean; integers are rounded.
pub const GUSSET_PLUGIN_RULE_LINEAR: u32 = 0;
/// Directions of three floats: mean on the sphere, of length 1. Faces turned over negate theirs.
pub const GUSSET_PLUGIN_RULE_NORMAL: u32 = 1;
/// Skin weights: weighted mean; the max_influences largest, scaled to sum 1 or an integer type's
/// largest value.
pub const GUSSET_PLUGIN_RULE_SKIN_WEIGHTS: u32 = 2;
/// Value of the source with the largest weight.
pub const GUSSET_PLUGIN_RULE_NEAREST: u32 = 3;
/// Texture coordinates. Corners of new faces get the mean if both sides are on one chart; else
/// charts continue to a seam in the middle.
pub const GUSSET_PLUGIN_RULE_TEXTURE: u32 = 4;

// The plugin's constants equal the library's.
const _: () = assert!(
    GUSSET_PLUGIN_VERTICES == domains::GUSSET_DOMAIN_VERTICES
        && GUSSET_PLUGIN_CORNERS == domains::GUSSET_DOMAIN_CORNERS
        && GUSSET_PLUGIN_FACES == domains::GUSSET_DOMAIN_FACES
        && GUSSET_PLUGIN_VALUE_F32 == library::GUSSET_VALUE_F32
        && GUSSET_PLUGIN_VALUE_F64 == library::GUSSET_VALUE_F64
        && GUSSET_PLUGIN_VALUE_U8 == library::GUSSET_VALUE_U8
        && GUSSET_PLUGIN_VALUE_U16 == library::GUSSET_VALUE_U16
        && GUSSET_PLUGIN_VALUE_U32 == library::GUSSET_VALUE_U32
        && GUSSET_PLUGIN_RULE_LINEAR == library::GUSSET_RULE_LINEAR
        && GUSSET_PLUGIN_RULE_NORMAL == library::GUSSET_RULE_NORMAL
        && GUSSET_PLUGIN_RULE_SKIN_WEIGHTS == library::GUSSET_RULE_SKIN_WEIGHTS
        && GUSSET_PLUGIN_RULE_NEAREST == library::GUSSET_RULE_NEAREST
        && GUSSET_PLUGIN_RULE_TEXTURE == library::GUSSET_RULE_TEXTURE
);

/// Type of values, and rule that combines them. A single source's value stays bit for bit; elements
/// without valued sources get 0.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_plugin_channel {
    /// sizeof(gusset_plugin_channel).
    pub struct_size: usize,
    /// GUSSET_PLUGIN_VERTICES, _CORNERS or _FACES.
    pub domain: u32,
    /// GUSSET_PLUGIN_VALUE_...; 0 is invalid.
    pub value_type: u32,
    /// Values of an element, 1 to 4096.
    pub components: u32,
    /// GUSSET_PLUGIN_RULE_...
    pub rule: u32,
    /// Weights that GUSSET_PLUGIN_RULE_SKIN_WEIGHTS keeps; 0: all.
    pub max_influences: u32,
    /// 0.
    pub reserved: u32,
}

/// Values of one input's elements.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_plugin_channel_values {
    /// Components of each element; NULL with count 0 if lacking.
    pub values: *const c_void,
    /// Vertices, corners or faces of the input.
    pub count: usize,
    /// Stride of elements.
    pub stride: usize,
}

laid_out_like! {
    gusset_plugin_channel: gusset_channel {
        struct_size, domain, value_type, components, rule, max_influences, reserved,
    }
}
laid_out_like! { gusset_plugin_channel_values: gusset_channel_values { values, count, stride } }

/// Origins of an output's elements.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_plugin_origins {
    /// sizeof(gusset_plugin_origins).
    pub struct_size: usize,
    /// Number of elements.
    pub count: usize,
    /// Offsets into sources and weights, by element.
    pub offsets: *const u32,
    /// Elements, numbered through all inputs.
    pub sources: *const u32,
    /// Weight of each source, above 0, in all 1.
    pub weights: *const f64,
    /// Number of inputs.
    pub input_count: usize,
    /// Offsets of inputs in this numbering.
    pub starts: *const u32,
}

versioned! { gusset_plugin_origins: 56 }
fixed! { gusset_plugin_channel_values: 24 }

/// extension("attributes/1"): transfers attributes to outputs of runs with origins.
#[repr(C)]
pub struct gusset_plugin_attributes {
    /// sizeof(gusset_plugin_attributes).
    pub struct_size: usize,
    /// Returns 1 if the output has origins, else 0.
    pub has_origins: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32) -> u32,
    /// Gets the origins of the output's elements of a domain.
    pub origins: unsafe extern "C" fn(
        outputs: *const gusset_outputs,
        index: u32,
        domain: u32,
        origins: *mut gusset_plugin_origins,
    ) -> i32,
    /// Writes the values of the output's elements in O(elements and sources). host: as for run.
    /// inputs: one for each input of the run. values: room for count elements, at least the
    /// output's, apart from inputs. failure: receives the reason, with a static message; may be
    /// NULL.
    pub apply: unsafe extern "C" fn(
        outputs: *const gusset_outputs,
        index: u32,
        host: *const gusset_host,
        channel: *const gusset_plugin_channel,
        inputs: *const gusset_plugin_channel_values,
        input_count: u32,
        values: *mut c_void,
        count: usize,
        stride: usize,
        failure: *mut gusset_failure,
    ) -> i32,
}
