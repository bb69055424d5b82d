//! Filters: Structs and constants of the tables.

use super::outcome::gusset_outputs;
use crate::capi::glue::versioned;
use std::ffi::{c_char, c_void};

/// The version of this header's tables, for gusset_plugin_entry.
pub const GUSSET_PLUGIN_ABI: u32 = 1;

/// What run returns after success.
pub const GUSSET_PLUGIN_DONE: i32 = 0;
/// What run returns when a parameter is out of its range, or an input is of the wrong kind.
pub const GUSSET_PLUGIN_OUT_OF_RANGE: i32 = 5;
/// What run returns when memory could not be had.
pub const GUSSET_PLUGIN_OUT_OF_MEMORY: i32 = 2000;
/// What run returns when the host's progress callback asked to stop.
pub const GUSSET_PLUGIN_CANCELLED: i32 = 2001;

/// A polygon mesh: struct gusset_plugin_mesh.
pub const GUSSET_KIND_MESH: u32 = 1;
/// Polylines: struct gusset_plugin_curves.
pub const GUSSET_KIND_CURVES: u32 = 2;
/// Lines of text for a log window; an output only.
pub const GUSSET_KIND_TEXT: u32 = 3;

/// Coordinates are 32-bit floats.
pub const GUSSET_PLUGIN_F32: u32 = 1;
/// Coordinates are 64-bit floats.
pub const GUSSET_PLUGIN_F64: u32 = 2;

/// 0 or 1.
pub const GUSSET_PARAM_BOOL: u32 = 1;
/// A whole number.
pub const GUSSET_PARAM_INT: u32 = 2;
/// A number without a unit.
pub const GUSSET_PARAM_REAL: u32 = 3;
/// The place of one of the choices, from 0.
pub const GUSSET_PARAM_CHOICE: u32 = 4;
/// A length, in the unit of the positions.
pub const GUSSET_PARAM_LENGTH: u32 = 5;
/// An angle, in radians.
pub const GUSSET_PARAM_ANGLE: u32 = 6;
/// A point: x, y, z.
pub const GUSSET_PARAM_POINT: u32 = 7;
/// A direction: x, y, z, not all 0; its length means nothing.
pub const GUSSET_PARAM_DIRECTION: u32 = 8;
/// A plane a x + b y + c z = d: a, b, c, d, the first three not all 0.
pub const GUSSET_PARAM_PLANE: u32 = 9;

/// The first output is the first input, mended: an editor puts it in its place. Else outputs are
/// new.
pub const GUSSET_FILTER_REPLACES: u32 = 1;

/// The vertices, corners and faces of the first output, a mesh, come from those of the inputs, and
/// extension("attributes/1") carries over what they have.
pub const GUSSET_FILTER_ORIGINS: u32 = 2;

/// gusset_failure.input, gusset_failure.param: none.
pub const GUSSET_PLUGIN_NONE: u32 = u32::MAX;

/// The polygon mesh of an input or of an output; laid out like gusset_mesh_view of gusset.h, and
/// under the same rules. Arrays may have any alignment and are not copied on the way in.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_plugin_mesh {
    /// sizeof(gusset_plugin_mesh), set by the host.
    pub struct_size: usize,
    /// x, y, z at the start of every stride, of the type that scalar names. Finite where faces use
    /// them.
    pub positions: *const c_void,
    /// Bytes from one position to the next; 0 if they are packed.
    pub position_stride: usize,
    /// The number of vertices; 1 to 2^32 - 2.
    pub vertex_count: usize,
    /// face_count + 1 32-bit entries from 0: face f has the corners face_offsets[f] to
    /// face_offsets[f + 1] - 1. NULL if face_size is given. Outputs have it.
    pub face_offsets: *const c_void,
    /// The vertex at each corner, 32-bit, face after face.
    pub face_corners: *const c_void,
    /// The number of faces; at least 1 in an input.
    pub face_count: usize,
    /// GUSSET_PLUGIN_F32 or GUSSET_PLUGIN_F64. Zero is no valid value: it must be said.
    pub scalar: u32,
    /// 0: indices are 32-bit unsigned integers.
    pub index: u32,
    /// The number of corners of every face, or 0 if face_offsets is given.
    pub face_size: u32,
    /// 0.
    pub reserved: u32,
    /// For each vertex the one that it is one with, itself or one that is one with itself; 32-bit; NULL
    /// if none is one with another. Vertices that are kept apart for their texture coordinates or
    /// normals leave no border then.
    pub merge: *const c_void,
}

versioned! {
    gusset_plugin_mesh: 72 reserved,
    gusset_plugin_curves: 64 reserved,
    gusset_input: 24 reserved,
    gusset_host: 40,
    gusset_failure: 48,
}

/// The polylines of an input or of an output. Curve c has the points offsets[c] to offsets[c + 1] -
/// 1 and, if it is closed, an edge from the last to the first.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_plugin_curves {
    /// sizeof(gusset_plugin_curves), set by the host.
    pub struct_size: usize,
    /// x, y, z at the start of every stride, of the type that scalar names. Finite. Outputs are
    /// packed 64-bit floats.
    pub points: *const c_void,
    /// Bytes from one point to the next; 0 if they are packed.
    pub point_stride: usize,
    /// The number of points; at most 2^32 - 2.
    pub point_count: usize,
    /// curve_count + 1 32-bit entries from 0 to point_count, none less than the one before. May be
    /// NULL if curve_count is 0.
    pub offsets: *const c_void,
    /// For each curve a byte: 0 open, 1 closed. NULL if all are open.
    pub closed: *const u8,
    /// The number of curves; at most 2^32 - 2.
    pub curve_count: usize,
    /// GUSSET_PLUGIN_F32 or GUSSET_PLUGIN_F64.
    pub scalar: u32,
    /// 0.
    pub reserved: u32,
}

/// One input of a filter.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_input {
    /// sizeof(gusset_input), set by the host; the same in all inputs of a call.
    pub struct_size: usize,
    /// A struct gusset_plugin_mesh or gusset_plugin_curves, as kind says.
    pub view: *const c_void,
    /// GUSSET_KIND_MESH or GUSSET_KIND_CURVES.
    pub kind: u32,
    /// 0.
    pub reserved: u32,
}

/// How a host follows and steers a run. Callbacks come from the thread that called run, must not
/// call into the plugin for the same outputs, and must not throw.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_host {
    /// sizeof(gusset_host), set by the host.
    pub struct_size: usize,
    /// Handed to the callbacks.
    pub user: *mut c_void,
    /// Called now and then during long work, or NULL. fraction: the part done, 0 to 1, never
    /// decreasing. stage: what is being done, valid during the callback only. Nonzero cancels: run
    /// returns GUSSET_PLUGIN_CANCELLED soon after: within a tenth of a second for a million faces
    /// or points that go in and come out; giving back the memory of many more takes longer.
    pub progress: Option<unsafe extern "C" fn(user: *mut c_void, fraction: f64, stage: *const c_char) -> i32>,
    /// Called with remarks that are no failures, or NULL; message is valid during the callback
    /// only.
    pub log: Option<unsafe extern "C" fn(user: *mut c_void, message: *const c_char)>,
    /// 0 as many threads as the machine has, 1 the calling thread only. Results do not depend on
    /// it.
    pub threads: u32,
    /// 1: outputs tell where their elements come from, for extension("attributes/1"), if the filter
    /// has GUSSET_FILTER_ORIGINS. 0: they do not, which saves time and memory.
    pub origins: u32,
}

/// One choice of a parameter. Texts are UTF-8, static.
#[repr(C)]
pub struct gusset_choice {
    /// For menus.
    pub label: *const c_char,
    /// What it does.
    pub help: *const c_char,
}

/// A parameter of a filter. Texts are UTF-8, static.
#[repr(C)]
pub struct gusset_param_info {
    /// sizeof(gusset_param_info) of the plugin.
    pub struct_size: usize,
    /// Stable for ever: scripts and stored projects name it.
    pub id: *const c_char,
    /// For dialogs.
    pub label: *const c_char,
    /// What it does, in whole sentences.
    pub help: *const c_char,
    /// One of GUSSET_PARAM_...
    pub kind: u32,
    /// How many values it has: 3 for points and directions, 4 for planes, else 1.
    pub arity: u32,
    /// The least value of each component.
    pub min: f64,
    /// The greatest value of each component.
    pub max: f64,
    /// arity values. What suggest says suits the inputs better.
    pub default_values: *const f64,
    /// What a spin box adds; 0 if the host may choose.
    pub step: f64,
    /// choice_count choices; NULL if kind is not GUSSET_PARAM_CHOICE.
    pub choices: *const gusset_choice,
    /// The number of choices.
    pub choice_count: u32,
    /// Where its first value is among the values of the filter.
    pub first_value: u32,
}

/// One capability of the plugin. Texts are UTF-8, static; so is the struct. Its functions may be
/// called from many threads at once; filter is the struct that they are in.
#[repr(C)]
pub struct gusset_filter {
    /// sizeof(gusset_filter) of the plugin.
    pub struct_size: usize,
    /// Stable for ever: hosts store it.
    pub id: *const c_char,
    /// For menus.
    pub name: *const c_char,
    /// For scripts: lower case, words joined by underscores.
    pub script_name: *const c_char,
    /// The group that a host shows it in.
    pub category: *const c_char,
    /// What it does, in whole sentences.
    pub help: *const c_char,
    /// Where the method comes from.
    pub reference: *const c_char,
    /// The kind of each input, GUSSET_KIND_...; the last repeats. input_kind_count of them.
    pub input_kinds: *const u32,
    /// The kind of each output, in order; output_count of them.
    pub output_kinds: *const u32,
    /// The number of input_kinds; 0 for filters that make something of nothing.
    pub input_kind_count: u32,
    /// The least number of inputs.
    pub min_inputs: u32,
    /// The greatest number of inputs.
    pub max_inputs: u32,
    /// The number of outputs.
    pub output_count: u32,
    /// GUSSET_FILTER_... or 0.
    pub flags: u32,
    /// The number of parameters.
    pub param_count: u32,
    /// The number of values of all parameters.
    pub value_count: u32,
    /// 0.
    pub reserved: u32,
    /// Parameter index, 0 to param_count - 1; NULL for any other.
    pub param: unsafe extern "C" fn(filter: *const gusset_filter, index: u32) -> *const gusset_param_info,
    /// Writes the values that suit these inputs, one parameter after the other; values has room for
    /// value_count of them, and holds the plain defaults after a failure, of which suggest gives no
    /// account: run with the same inputs does. Inputs as for run. O(size of the inputs). Returns
    /// GUSSET_PLUGIN_DONE or a gusset_status of gusset.h.
    pub suggest: unsafe extern "C" fn(
        filter: *const gusset_filter,
        inputs: *const gusset_input,
        input_count: u32,
        values: *mut f64,
    ) -> i32,
    /// Runs the filter. host: NULL for no callbacks and automatic threads. inputs: input_count
    /// structs. values: the first value_count values of the parameters, one parameter after the
    /// other; the rest is as suggest has it. outputs: receives what came out, and after a failure
    /// an account of it (output_failure); give it to output_free in any case. NULL only if outputs
    /// itself is NULL or memory ran out. Returns GUSSET_PLUGIN_DONE, GUSSET_PLUGIN_CANCELLED, or
    /// another gusset_status of gusset.h.
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

/// Why a run failed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_failure {
    /// sizeof(gusset_failure), set by the host.
    pub struct_size: usize,
    /// What went wrong, an English sentence; empty after success. Lives as long as the outputs.
    pub message: *const c_char,
    /// What run returned.
    pub status: i32,
    /// The number of the parameter that is out of range, or GUSSET_PLUGIN_NONE.
    pub param: u32,
    /// The number of the input that is at fault, or GUSSET_PLUGIN_NONE.
    pub input: u32,
    /// What index counts, a GUSSET_ELEMENT_... of gusset.h: 0 nothing, 1 vertices, 2 faces, 3
    /// corners, 4 entries of face_offsets, 5 places in a loop, 6 nothing either: index is itself a
    /// count of elements or bytes; 7 points of all curves, 8 constraints on an outline, 9 places on
    /// a curve or a surface, 12 sections or planes, 13 nodes of a net, row after row, 14 its links
    /// (twice the first node, and 1 if vertical), 15 its cells, row after row, 16 seams, 17
    /// bridges, 18 entries of a scene, 19 bytes of a stream, 20 places along the side of a net, 21
    /// other items given, 30 knots, 31 rows of a net of curves. Later versions may have more.
    pub element: u32,
    /// The first offending element.
    pub index: u64,
    /// Its value where it has one.
    pub value: f64,
}

/// What the plugin is and can do. Texts are UTF-8, static; so is the struct. Its functions may be
/// called from many threads at once.
#[repr(C)]
pub struct gusset_plugin {
    /// sizeof(gusset_plugin) of the plugin.
    pub struct_size: usize,
    /// GUSSET_PLUGIN_ABI of the plugin.
    pub abi: u32,
    /// The number of filters.
    pub filter_count: u32,
    /// Stable for ever.
    pub id: *const c_char,
    /// For people.
    pub name: *const c_char,
    /// "major.minor.patch".
    pub version: *const c_char,
    /// Who makes it.
    pub vendor: *const c_char,
    /// One sentence.
    pub description: *const c_char,
    /// An SPDX licence expression.
    pub license: *const c_char,
    /// Filter index, 0 to filter_count - 1, in the order for menus; NULL for any other.
    pub filter: unsafe extern "C" fn(index: u32) -> *const gusset_filter,
    /// The filter of this id, or NULL.
    pub find: unsafe extern "C" fn(id: *const c_char) -> *const gusset_filter,
    /// How many outputs there are: as many as the filter says after success, else 0.
    pub output_count: unsafe extern "C" fn(outputs: *const gusset_outputs) -> u32,
    /// The kind of output index, GUSSET_KIND_...; 0 if there is none.
    pub output_kind: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32) -> u32,
    /// Fills mesh, whose struct_size is set, with the arrays of output index, which live as long as
    /// the outputs. Returns GUSSET_PLUGIN_DONE or a gusset_status of gusset.h.
    pub output_mesh:
        unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32, mesh: *mut gusset_plugin_mesh) -> i32,
    /// The same for curves.
    pub output_curves:
        unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32, curves: *mut gusset_plugin_curves) -> i32,
    /// The text of output index, UTF-8, which lives as long as the outputs; NULL if it is none.
    pub output_text: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32) -> *const c_char,
    /// Why the run failed. failure: its struct_size is set. Returns GUSSET_PLUGIN_DONE or a
    /// gusset_status of gusset.h.
    pub output_failure: unsafe extern "C" fn(outputs: *const gusset_outputs, failure: *mut gusset_failure) -> i32,
    /// Frees the outputs of a run; NULL is allowed.
    pub output_free: unsafe extern "C" fn(outputs: *mut gusset_outputs),
    /// Something beyond these tables, by name and version, or NULL: "values/1" is a
    /// gusset_plugin_values, "attributes/1" a gusset_plugin_attributes.
    pub extension: unsafe extern "C" fn(name: *const c_char) -> *const c_void,
}

/// The numbers in a text under names, for programs: extension("values/1"). The struct is static;
/// the functions may be called from many threads at once.
#[repr(C)]
pub struct gusset_plugin_values {
    /// sizeof(gusset_plugin_values) of the plugin.
    pub struct_size: usize,
    /// How many numbers output index has; 0 if it is no text or has none.
    pub count: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32) -> u32,
    /// The name of number which: lower case, words joined by underscores, the same in all versions;
    /// lives as long as the outputs. NULL if there is none.
    pub name: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32, which: u32) -> *const c_char,
    /// Number which; NaN if there is none. Flags are 0 or 1, angles in radians.
    pub value: unsafe extern "C" fn(outputs: *const gusset_outputs, index: u32, which: u32) -> f64,
}

/// The type of gusset_plugin_entry, for dlsym.
pub type gusset_plugin_entry_fn = Option<unsafe extern "C" fn(host_abi: u32) -> *const gusset_plugin>;
