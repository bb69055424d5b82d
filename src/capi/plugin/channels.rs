//! Attributes: The extension that carries values of elements to outputs.

use super::descriptor::{gusset_failure, gusset_host};
use super::outcome::gusset_outputs;
use crate::capi::glue::{fixed, laid_out_like, versioned};
use crate::capi::mesh::attributes::{self as library, gusset_channel, gusset_channel_values};
use crate::capi::mesh::origins as domains;
use std::ffi::c_void;

/// Elements of a mesh: vertices.
pub const GUSSET_PLUGIN_VERTICES: u32 = 0;
/// Elements of a mesh: corners of faces, in the order of face_corners.
pub const GUSSET_PLUGIN_CORNERS: u32 = 1;
/// Elements of a mesh: faces.
pub const GUSSET_PLUGIN_FACES: u32 = 2;

/// Values are 32-bit floats.
pub const GUSSET_PLUGIN_VALUE_F32: u32 = 1;
/// Values are 64-bit floats.
pub const GUSSET_PLUGIN_VALUE_F64: u32 = 2;
/// Values are 8-bit unsigned integers.
pub const GUSSET_PLUGIN_VALUE_U8: u32 = 3;
/// Values are 16-bit unsigned integers.
pub const GUSSET_PLUGIN_VALUE_U16: u32 = 4;
/// Values are 32-bit unsigned integers.
pub const GUSSET_PLUGIN_VALUE_U32: u32 = 5;

/// Several values become their weighted mean, as of colours; of integers rounded.
pub const GUSSET_PLUGIN_RULE_LINEAR: u32 = 0;
/// Directions of three floats become their mean on the sphere, of length 1; those of faces that were
/// turned over are turned.
pub const GUSSET_PLUGIN_RULE_NORMAL: u32 = 1;
/// Skin weights become their weighted mean, of which the max_influences largest are kept, with the
/// sum 1, or of integers the largest number of the type.
pub const GUSSET_PLUGIN_RULE_SKIN_WEIGHTS: u32 = 2;
/// The value of the source that counts most is taken, as of materials and numbers.
pub const GUSSET_PLUGIN_RULE_NEAREST: u32 = 3;
/// Texture coordinates: at the corners of new faces the mean where both sides are on one chart, and
/// elsewhere each side's chart goes on to a seam in the middle.
pub const GUSSET_PLUGIN_RULE_TEXTURE: u32 = 4;

// The plugin's numbers are the library's.
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

/// What the values of elements are, and how they are mixed. An element of one source has its value,
/// bit for bit; one without sources, or whose sources have no values, 0.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_plugin_channel {
    /// sizeof(gusset_plugin_channel), set by the host.
    pub struct_size: usize,
    /// GUSSET_PLUGIN_VERTICES, GUSSET_PLUGIN_CORNERS or GUSSET_PLUGIN_FACES.
    pub domain: u32,
    /// GUSSET_PLUGIN_VALUE_...; zero is no valid value.
    pub value_type: u32,
    /// How many values an element has, 1 to 4096.
    pub components: u32,
    /// GUSSET_PLUGIN_RULE_...
    pub rule: u32,
    /// With GUSSET_PLUGIN_RULE_SKIN_WEIGHTS, how many are kept of elements with several sources; 0:
    /// all.
    pub max_influences: u32,
    /// 0.
    pub reserved: u32,
}

/// The values of one input's elements.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_plugin_channel_values {
    /// The components of each element at the start of every stride, at any alignment; NULL with count
    /// 0 if the input has no such values.
    pub values: *const c_void,
    /// The number of elements: of the input's vertices, corners or faces, all.
    pub count: usize,
    /// Bytes from one element to the next; 0 if they are packed.
    pub stride: usize,
}

laid_out_like! {
    gusset_plugin_channel: gusset_channel {
        struct_size, domain, value_type, components, rule, max_influences, reserved,
    }
}
laid_out_like! { gusset_plugin_channel_values: gusset_channel_values { values, count, stride } }

/// Where elements of an output come from. The arrays live as long as the outputs.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_plugin_origins {
    /// sizeof(gusset_plugin_origins), set by the host.
    pub struct_size: usize,
    /// The number of elements.
    pub count: usize,
    /// count + 1 entries: element k has the entries offsets[k] to offsets[k + 1] - 1 of sources and
    /// weights; none if it comes from nothing.
    pub offsets: *const u32,
    /// Elements of the inputs, numbered through all of them.
    pub sources: *const u32,
    /// How much each counts: more than 0, with the sum 1 for each element.
    pub weights: *const f64,
    /// The number of inputs.
    pub input_count: usize,
    /// input_count + 1 entries: the elements of input i are the sources starts[i] to starts[i + 1] - 1.
    pub starts: *const u32,
}

versioned! { gusset_plugin_origins: 56 }
fixed! { gusset_plugin_channel_values: 24 }

/// What meshes carry beside positions, carried over to the outputs of a run whose host asked for
/// origins: extension("attributes/1"). The struct is static; the functions may be called from many
/// threads at once.
#[repr(C)]
pub struct gusset_plugin_attributes {
    /// sizeof(gusset_plugin_attributes) of the plugin.
    pub struct_size: usize,
    /// 1 if output index tells where its elements come from, else 0.
    pub has_origins: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32) -> u32,
    /// Fills origins, whose struct_size is set, with those of output index. domain:
    /// GUSSET_PLUGIN_VERTICES, GUSSET_PLUGIN_CORNERS or GUSSET_PLUGIN_FACES. Returns
    /// GUSSET_PLUGIN_DONE or a gusset_status of gusset.h.
    pub origins: unsafe extern "C" fn(
        outputs: *const gusset_outputs,
        index: u32,
        domain: u32,
        origins: *mut gusset_plugin_origins,
    ) -> i32,
    /// Writes the values of the elements of output index. host: NULL for no callbacks and automatic
    /// threads. channel: its struct_size is set. inputs: input_count structs, one for each input of
    /// the run, in their order. values: room for count elements, those of the output at least, stride
    /// bytes apart, 0 for packed ones, at any alignment; it must not overlap the inputs' values.
    /// failure: receives why there are none, the message of static texts, or NULL. O(elements and
    /// sources). Returns GUSSET_PLUGIN_DONE, GUSSET_PLUGIN_CANCELLED, or another gusset_status of
    /// gusset.h.
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
