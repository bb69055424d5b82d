//! Filters: Constants and structs of the tables.

use super::outcome::gusset_outputs;
use crate::capi::glue::versioned;
use std::ffi::{c_char, c_void};

/// Version of the tables.
pub const GUSSET_PLUGIN_ABI: u32 = 1;

/// Success.
pub const GUSSET_PLUGIN_DONE: i32 = 0;
/// A parameter is outside its range, or an input of the wrong kind.
pub const GUSSET_PLUGIN_OUT_OF_RANGE: i32 = 5;
/// Memory ran out.
pub const GUSSET_PLUGIN_OUT_OF_MEMORY: i32 = 2000;
/// The progress callback cancelled the run.
pub const GUSSET_PLUGIN_CANCELLED: i32 = 2001;

/// Polygon mesh: gusset_plugin_mesh.
pub const GUSSET_KIND_MESH: u32 = 1;
/// Polylines: gusset_plugin_curves.
pub const GUSSET_KIND_CURVES: u32 = 2;
/// Lines of text for a log window; outputs only.
pub const GUSSET_KIND_TEXT: u32 = 3;

/// Coordinates as 32-bit floats.
pub const GUSSET_PLUGIN_F32: u32 = 1;
/// Coordinates as 64-bit floats.
pub const GUSSET_PLUGIN_F64: u32 = 2;

/// 0 or 1.
pub const GUSSET_PARAM_BOOL: u32 = 1;
/// Whole number.
pub const GUSSET_PARAM_INT: u32 = 2;
/// Number without unit.
pub const GUSSET_PARAM_REAL: u32 = 3;
/// Index of a choice.
pub const GUSSET_PARAM_CHOICE: u32 = 4;
/// Length.
pub const GUSSET_PARAM_LENGTH: u32 = 5;
/// Angle.
pub const GUSSET_PARAM_ANGLE: u32 = 6;
/// Point x, y, z.
pub const GUSSET_PARAM_POINT: u32 = 7;
/// Direction x, y, z, not all 0, of any length.
pub const GUSSET_PARAM_DIRECTION: u32 = 8;
/// Plane a x + b y + c z = d: a, b, c (not all 0), d.
pub const GUSSET_PARAM_PLANE: u32 = 9;

/// Report value: whole.
pub const GUSSET_VALUE_COUNT: u32 = 1;
/// Report value: 0 or 1.
pub const GUSSET_VALUE_FLAG: u32 = 2;
/// Report value: without unit, or in its own.
pub const GUSSET_VALUE_NUMBER: u32 = 3;
/// Report value: length in the unit of the positions.
pub const GUSSET_VALUE_LENGTH: u32 = 4;
/// Report value: area in the square of that unit.
pub const GUSSET_VALUE_AREA: u32 = 5;
/// Report value: volume in the cube of that unit.
pub const GUSSET_VALUE_VOLUME: u32 = 6;
/// Report value: angle in radians.
pub const GUSSET_VALUE_ANGLE: u32 = 7;

/// The first output replaces the first input, else outputs are new.
pub const GUSSET_FILTER_REPLACES: u32 = 1;

/// The first output, a mesh, has elements of the inputs, for extension("attributes/1").
pub const GUSSET_FILTER_ORIGINS: u32 = 2;

/// No input or parameter.
pub const GUSSET_PLUGIN_NONE: u32 = u32::MAX;

/// Polygon mesh, with the rules of gusset_mesh_view in gusset.h. Inputs are not copied.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_plugin_mesh {
    /// sizeof(gusset_plugin_mesh).
    pub struct_size: usize,
    /// x, y, z; finite at vertices of faces.
    pub positions: *const c_void,
    /// Stride of positions.
    pub position_stride: usize,
    /// 1 to 2^32 - 2.
    pub vertex_count: usize,
    /// Offsets into face_corners, by face. NULL with face_size, not in outputs.
    pub face_offsets: *const c_void,
    /// Vertex of each corner, face by face.
    pub face_corners: *const c_void,
    /// At least 1 in an input.
    pub face_count: usize,
    /// GUSSET_PLUGIN_F32 or GUSSET_PLUGIN_F64, not 0.
    pub scalar: u32,
    /// 0: corners, offsets and merge are 32-bit unsigned integers.
    pub index: u32,
    /// Corners of every face, or 0 with face_offsets.
    pub face_size: u32,
    /// 0.
    pub reserved: u32,
    /// Representative of each vertex, itself or one that represents itself; NULL: all are separate.
    /// Vertices with one representative are one, so that seams are not borders.
    pub merge: *const c_void,
}

versioned! {
    gusset_plugin_mesh: 72 reserved,
    gusset_plugin_curves: 64 reserved,
    gusset_input: 24 reserved,
    gusset_host: 40,
    gusset_failure: 48,
}

/// Polylines. If closed, the last point joins the first.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_plugin_curves {
    /// sizeof(gusset_plugin_curves).
    pub struct_size: usize,
    /// Finite x, y, z. Outputs are packed 64-bit floats.
    pub points: *const c_void,
    /// Stride of points.
    pub point_stride: usize,
    /// At most 2^32 - 2.
    pub point_count: usize,
    /// 32-bit offsets into points, by curve; may be NULL without curves.
    pub offsets: *const c_void,
    /// For each curve, 1 if closed; NULL: all open.
    pub closed: *const u8,
    /// At most 2^32 - 2.
    pub curve_count: usize,
    /// GUSSET_PLUGIN_F32 or GUSSET_PLUGIN_F64.
    pub scalar: u32,
    /// 0.
    pub reserved: u32,
}

/// Input of a filter. All inputs of a call have one struct_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_input {
    /// sizeof(gusset_input).
    pub struct_size: usize,
    /// A gusset_plugin_mesh or gusset_plugin_curves.
    pub view: *const c_void,
    /// GUSSET_KIND_MESH or GUSSET_KIND_CURVES.
    pub kind: u32,
    /// 0.
    pub reserved: u32,
}

/// Callbacks and settings of a call. Callbacks run on the calling thread, with texts valid
/// meanwhile. They must not throw, or pass the call's outputs to the plugin.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_host {
    /// sizeof(gusset_host).
    pub struct_size: usize,
    /// First argument of the callbacks.
    pub user: *mut c_void,
    /// Receives the part done, 0 to 1, nondecreasing, at last 1 if the run succeeds, and the
    /// current work; may be NULL. A nonzero return cancels: run ends within 0.1 s for 1,000,000
    /// input and output faces or points; freeing more takes longer.
    pub progress: Option<unsafe extern "C" fn(user: *mut c_void, fraction: f64, stage: *const c_char) -> i32>,
    /// Receives remarks that are not failures; may be NULL.
    pub log: Option<unsafe extern "C" fn(user: *mut c_void, message: *const c_char)>,
    /// 0: all of the machine; 1: the calling thread. Results do not depend on it.
    pub threads: u32,
    /// 1: outputs get origins, with GUSSET_FILTER_ORIGINS; 0 saves time and memory.
    pub origins: u32,
}

/// Choice of a parameter.
#[repr(C)]
pub struct gusset_choice {
    /// Menu text.
    pub label: *const c_char,
    /// Its effect.
    pub help: *const c_char,
}

/// Parameter of a filter.
#[repr(C)]
pub struct gusset_param_info {
    /// sizeof(gusset_param_info).
    pub struct_size: usize,
    /// Identifier for scripts and projects.
    pub id: *const c_char,
    /// Dialog text.
    pub label: *const c_char,
    /// Description in whole sentences.
    pub help: *const c_char,
    /// GUSSET_PARAM_...
    pub kind: u32,
    /// Points, directions: 3; planes: 4; else 1.
    pub arity: u32,
    /// Least value of each component.
    pub min: f64,
    /// Greatest value of each component.
    pub max: f64,
    /// arity values; suggest adapts them to the inputs.
    pub default_values: *const f64,
    /// Spin box increment; 0: the host's choice.
    pub step: f64,
    /// NULL unless kind is GUSSET_PARAM_CHOICE.
    pub choices: *const gusset_choice,
    /// Number of choices.
    pub choice_count: u32,
    /// Its first value among the filter's values.
    pub first_value: u32,
}

/// Filter. Its functions take this struct.
#[repr(C)]
pub struct gusset_filter {
    /// sizeof(gusset_filter).
    pub struct_size: usize,
    /// Identifier, for hosts to store.
    pub id: *const c_char,
    /// Menu text.
    pub name: *const c_char,
    /// Name for scripts, in snake_case.
    pub script_name: *const c_char,
    /// Menu group.
    pub category: *const c_char,
    /// Description in whole sentences.
    pub help: *const c_char,
    /// Source of the method.
    pub reference: *const c_char,
    /// GUSSET_KIND_... of each input; the last repeats.
    pub input_kinds: *const u32,
    /// GUSSET_KIND_... of each output.
    pub output_kinds: *const u32,
    /// 0 for filters without inputs.
    pub input_kind_count: u32,
    /// Least inputs.
    pub min_inputs: u32,
    /// Most inputs.
    pub max_inputs: u32,
    /// Number of outputs.
    pub output_count: u32,
    /// GUSSET_FILTER_... or 0.
    pub flags: u32,
    /// Number of parameters.
    pub param_count: u32,
    /// Values of all parameters.
    pub value_count: u32,
    /// 0.
    pub reserved: u32,
    /// Returns a parameter by its index.
    pub param: unsafe extern "C" fn(filter: *const gusset_filter, index: u32) -> *const gusset_param_info,
    /// Writes value_count defaults that suit the inputs, in O(their size). After a failure, writes
    /// plain defaults; run tells the reason.
    pub suggest: unsafe extern "C" fn(
        filter: *const gusset_filter,
        inputs: *const gusset_input,
        input_count: u32,
        values: *mut f64,
    ) -> i32,
    /// Runs the filter. host: NULL for no callbacks and all threads. values: the first value_count;
    /// suggest gives the rest. outputs: receives the outputs or the reason of a failure, to be
    /// freed by output_free; NULL only if memory ran out.
    pub run: unsafe extern "C" fn(
        filter: *const gusset_filter,
        host: *const gusset_host,
        inputs: *const gusset_input,
        input_count: u32,
        values: *const f64,
        value_count: u32,
        outputs: *mut *mut gusset_outputs,
    ) -> i32,
}

/// Reason of a failure.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_failure {
    /// sizeof(gusset_failure).
    pub struct_size: usize,
    /// English sentence; empty after success.
    pub message: *const c_char,
    /// Status of the run.
    pub status: i32,
    /// Parameter outside its range, or GUSSET_PLUGIN_NONE.
    pub param: u32,
    /// Faulty input, or GUSSET_PLUGIN_NONE.
    pub input: u32,
    /// Kind of element, GUSSET_ELEMENT_... of gusset.h: 0 none, 1 vertex, 2 face, 3 corner, 4
    /// offset, 5 place in a loop, 6 none (index is a count), 7 point of all curves, 8 constraint on
    /// an outline, 9 place on a curve or surface, 12 section or plane, 13 net node by rows, 14 net
    /// link (twice its first node, plus 1 if vertical), 15 net cell by rows, 16 seam, 17 bridge, 18
    /// scene entry, 19 stream byte, 20 place along a net side, 21 other given item, 30 knot, 31 row
    /// of a net of curves, 32 edge of a winged-edge table. Later versions may add kinds.
    pub element: u32,
    /// First faulty element.
    pub index: u64,
    /// Its value, if any.
    pub value: f64,
}

/// Tables and functions of the plugin.
#[repr(C)]
pub struct gusset_plugin {
    /// sizeof(gusset_plugin).
    pub struct_size: usize,
    /// GUSSET_PLUGIN_ABI of the plugin.
    pub abi: u32,
    /// Number of filters.
    pub filter_count: u32,
    /// Identifier.
    pub id: *const c_char,
    /// Name for people.
    pub name: *const c_char,
    /// "major.minor.patch".
    pub version: *const c_char,
    /// Its makers.
    pub vendor: *const c_char,
    /// One sentence.
    pub description: *const c_char,
    /// SPDX licence expression.
    pub license: *const c_char,
    /// Returns a filter by its index, in menu order.
    pub filter: unsafe extern "C" fn(index: u32) -> *const gusset_filter,
    /// Returns a filter by its id.
    pub find: unsafe extern "C" fn(id: *const c_char) -> *const gusset_filter,
    /// Returns the filter's output_count after success, else 0.
    pub output_count: unsafe extern "C" fn(outputs: *const gusset_outputs) -> u32,
    /// Returns GUSSET_KIND_..., or 0.
    pub output_kind: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32) -> u32,
    /// Lends the arrays of an output mesh.
    pub output_mesh:
        unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32, mesh: *mut gusset_plugin_mesh) -> i32,
    /// Lends the arrays of output curves.
    pub output_curves:
        unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32, curves: *mut gusset_plugin_curves) -> i32,
    /// Returns the text, or NULL.
    pub output_text: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32) -> *const c_char,
    /// Gets the reason of the run's failure.
    pub output_failure: unsafe extern "C" fn(outputs: *const gusset_outputs, failure: *mut gusset_failure) -> i32,
    /// Frees outputs; NULL is allowed.
    pub output_free: unsafe extern "C" fn(outputs: *mut gusset_outputs),
    /// Returns gusset_plugin_values for "values/1", gusset_plugin_attributes for "attributes/1".
    pub extension: unsafe extern "C" fn(name: *const c_char) -> *const c_void,
}

/// extension("values/1"): named numbers of a text output.
#[repr(C)]
pub struct gusset_plugin_values {
    /// sizeof(gusset_plugin_values).
    pub struct_size: usize,
    /// Returns the number of numbers; 0 for other outputs.
    pub count: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32) -> u32,
    /// Returns the name of number which, in snake_case, equal in all versions.
    pub name: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32, which: u32) -> *const c_char,
    /// Returns number which, or NaN; flags are 0 or 1.
    pub value: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32, which: u32) -> f64,
    /// Returns GUSSET_VALUE_... of number which, or 0. Later versions may add kinds. Plugins whose
    /// struct_size ends before it lack it.
    pub kind: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32, which: u32) -> u32,
}

/// Type of gusset_plugin_entry, for dlsym.
pub type gusset_plugin_entry_fn = Option<unsafe extern "C" fn(host_abi: u32) -> *const gusset_plugin>;
