//! The structs, statuses and names of the standard that the effects use. Handles are opaque
//! pointers that the host owns.

use std::ffi::{CStr, c_char, c_int, c_uint, c_void};

/// An opaque pointer of the host: a property set, effect, input, mesh or parameter.
pub(crate) type HostHandle = *mut c_void;

/// The status that an action or a suite function returns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct OfxStatus(pub(super) c_int);

impl OfxStatus {
    pub(super) const OK: OfxStatus = OfxStatus(0);
    pub(super) const FAILED: OfxStatus = OfxStatus(1);
    pub(super) const MISSING_HOST_FEATURE: OfxStatus = OfxStatus(4);
    pub(super) const MEMORY: OfxStatus = OfxStatus(8);
    pub(super) const BAD_HANDLE: OfxStatus = OfxStatus(9);
    /// The effect does not implement the action.
    pub(super) const REPLY_DEFAULT: OfxStatus = OfxStatus(14);

    pub(super) fn check_status(status: c_int) -> Result<(), OfxStatus> {
        if status == OfxStatus::OK.0 { Ok(()) } else { Err(OfxStatus(status)) }
    }
}

/// The API that the effects implement, and its version.
pub(super) const MESH_EFFECT_API_NAME: &CStr = c"OfxMeshEffectPluginAPI";
pub(super) const API_VERSION: c_int = 1;

pub(super) const PROPERTY_SUITE: &CStr = c"OfxPropertySuite";
pub(super) const PARAMETER_SUITE: &CStr = c"OfxParameterSuite";
pub(super) const MESH_EFFECT_SUITE: &CStr = c"OfxMeshEffectSuite";
pub(super) const MESSAGE_SUITE: &CStr = c"OfxMessageSuite";

pub(super) const MESSAGE_ERROR: &CStr = c"OfxMessageError";
pub(super) const MESSAGE_LOG: &CStr = c"OfxMessageLog";

pub(super) const PROP_LABEL: &CStr = c"OfxPropLabel";
pub(super) const PROP_DESCRIPTION: &CStr = c"OfxPropPluginDescription";
pub(super) const PROP_TIME: &CStr = c"OfxPropTime";

pub(super) const PROP_CONTEXTS: &CStr = c"OfxMeshEffectPropSupportedContexts";
pub(super) const CONTEXT_GENERATOR: &CStr = c"OfxMeshEffectContextGenerator";
pub(super) const CONTEXT_FILTER: &CStr = c"OfxMeshEffectContextFilter";
pub(super) const CONTEXT_GENERAL: &CStr = c"OfxMeshEffectContextGeneral";

pub(super) const MAIN_INPUT: &CStr = c"OfxMeshMainInput";
pub(super) const MAIN_OUTPUT: &CStr = c"OfxMeshMainOutput";
pub(super) const PROP_REQUEST_TRANSFORM: &CStr = c"OfxInputPropRequestTransform";

pub(super) const PARAM_INTEGER: &CStr = c"OfxParamTypeInteger";
pub(super) const PARAM_DOUBLE: &CStr = c"OfxParamTypeDouble";
pub(super) const PARAM_DOUBLE_3D: &CStr = c"OfxParamTypeDouble3D";
pub(super) const PARAM_BOOLEAN: &CStr = c"OfxParamTypeBoolean";
pub(super) const PARAM_CHOICE: &CStr = c"OfxParamTypeChoice";

pub(super) const PARAM_PROP_HINT: &CStr = c"OfxParamPropHint";
pub(super) const PARAM_PROP_DEFAULT: &CStr = c"OfxParamPropDefault";
pub(super) const PARAM_PROP_MIN: &CStr = c"OfxParamPropMin";
pub(super) const PARAM_PROP_MAX: &CStr = c"OfxParamPropMax";
pub(super) const PARAM_PROP_INCREMENT: &CStr = c"OfxParamPropIncrement";
pub(super) const PARAM_PROP_CHOICE: &CStr = c"OfxParamPropChoiceOption";
pub(super) const PARAM_PROP_DOUBLE_TYPE: &CStr = c"OfxParamPropDoubleType";
/// Marks a double that is an angle in degrees.
pub(super) const PARAM_DOUBLE_ANGLE: &CStr = c"OfxParamDoubleTypeAngle";

pub(super) const MESH_POINT_COUNT: &CStr = c"OfxMeshPropPointCount";
pub(super) const MESH_CORNER_COUNT: &CStr = c"OfxMeshPropCornerCount";
pub(super) const MESH_FACE_COUNT: &CStr = c"OfxMeshPropFaceCount";
pub(super) const MESH_NO_LOOSE_EDGE: &CStr = c"OfxMeshPropNoLooseEdge";
/// The number of corners of every face, or -1 if it varies.
pub(super) const MESH_CONSTANT_FACE_SIZE: &CStr = c"OfxMeshPropConstantFaceSize";
/// 16 doubles, row by row, from the mesh's coordinates to world coordinates; NULL for the identity.
pub(super) const MESH_TRANSFORM: &CStr = c"OfxMeshPropTransformMatrix";

pub(super) const ATTRIB_POINT: &CStr = c"OfxMeshAttribPoint";
pub(super) const ATTRIB_CORNER: &CStr = c"OfxMeshAttribCorner";
pub(super) const ATTRIB_FACE: &CStr = c"OfxMeshAttribFace";
pub(super) const POINT_POSITION: &CStr = c"OfxMeshAttribPointPosition";
pub(super) const CORNER_POINT: &CStr = c"OfxMeshAttribCornerPoint";
pub(super) const FACE_SIZE: &CStr = c"OfxMeshAttribFaceSize";
pub(super) const ATTRIB_DATA: &CStr = c"OfxMeshAttribPropData";
pub(super) const ATTRIB_STRIDE: &CStr = c"OfxMeshAttribPropStride";
pub(super) const ATTRIB_TYPE: &CStr = c"OfxMeshAttribPropType";
pub(super) const TYPE_FLOAT: &CStr = c"OfxMeshAttribTypeFloat";
pub(super) const TYPE_INT: &CStr = c"OfxMeshAttribTypeInt";

/// The host, as it is passed to each effect first.
#[repr(C)]
pub struct OfxHost {
    /// The host's own properties.
    pub host: HostHandle,
    /// Returns a suite by name and version; NULL if the host lacks it.
    pub fetch_suite:
        Option<unsafe extern "C" fn(host: HostHandle, name: *const c_char, version: c_int) -> *const c_void>,
}

/// An effect, as a host sees it.
#[repr(C)]
pub struct OfxPlugin {
    /// The API that the effect implements.
    pub plugin_api: *const c_char,
    /// The version of the API.
    pub api_version: c_int,
    /// The unique identifier of the effect.
    pub plugin_identifier: *const c_char,
    /// Increases when stored projects can no longer be loaded.
    pub plugin_version_major: c_uint,
    /// Increases in all other cases.
    pub plugin_version_minor: c_uint,
    /// Called before anything else.
    pub set_host: unsafe extern "C" fn(host: *mut OfxHost),
    /// Called for every action.
    pub main_entry: unsafe extern "C" fn(
        action: *const c_char,
        handle: *const c_void,
        in_args: HostHandle,
        out_args: HostHandle,
    ) -> c_int,
}

/// A function of a suite. A host may leave out functions that it does not support.
type SuiteFunction<F> = Option<F>;
/// A function that the effects never call. It only takes up space.
type UnusedSuiteFunction = *const c_void;

/// Properties: named values of four types.
#[repr(C)]
pub(super) struct PropertySuite {
    pub(super) set_pointer: UnusedSuiteFunction,
    pub(super) set_string:
        SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, c_int, *const c_char) -> c_int>,
    pub(super) set_double: SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, c_int, f64) -> c_int>,
    pub(super) set_int: SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, c_int, c_int) -> c_int>,
    pub(super) set_many: [UnusedSuiteFunction; 4],
    pub(super) get_pointer:
        SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, c_int, *mut *mut c_void) -> c_int>,
    pub(super) get_string:
        SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, c_int, *mut *mut c_char) -> c_int>,
    pub(super) get_double: SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, c_int, *mut f64) -> c_int>,
    pub(super) get_int: SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, c_int, *mut c_int) -> c_int>,
    pub(super) get_many: [UnusedSuiteFunction; 4],
    pub(super) reset_and_dimension: [UnusedSuiteFunction; 2],
}

/// Parameters. The standard has more functions, which effects do not need.
#[repr(C)]
pub(super) struct ParameterSuite {
    pub(super) define:
        SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, *const c_char, *mut HostHandle) -> c_int>,
    pub(super) get_handle:
        SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, *mut HostHandle, *mut HostHandle) -> c_int>,
    pub(super) get_property_sets: [UnusedSuiteFunction; 2],
    /// The arguments end with one pointer to a variable for each component of the parameter.
    pub(super) get_value: SuiteFunction<unsafe extern "C" fn(HostHandle, ...) -> c_int>,
    pub(super) get_value_at_time: SuiteFunction<unsafe extern "C" fn(HostHandle, f64, ...) -> c_int>,
}

/// Inputs, outputs and meshes.
#[repr(C)]
pub(super) struct MeshEffectSuite {
    pub(super) get_property_set: SuiteFunction<unsafe extern "C" fn(HostHandle, *mut HostHandle) -> c_int>,
    pub(super) get_param_set: SuiteFunction<unsafe extern "C" fn(HostHandle, *mut HostHandle) -> c_int>,
    pub(super) input_define:
        SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, *mut HostHandle, *mut HostHandle) -> c_int>,
    pub(super) input_get_handle:
        SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, *mut HostHandle, *mut HostHandle) -> c_int>,
    pub(super) input_get_property_set: UnusedSuiteFunction,
    pub(super) input_request_attribute: UnusedSuiteFunction,
    pub(super) input_get_mesh:
        SuiteFunction<unsafe extern "C" fn(HostHandle, f64, *mut HostHandle, *mut HostHandle) -> c_int>,
    pub(super) input_release_mesh: SuiteFunction<unsafe extern "C" fn(HostHandle) -> c_int>,
    pub(super) attribute_define: UnusedSuiteFunction,
    pub(super) mesh_get_attribute_by_index: UnusedSuiteFunction,
    pub(super) mesh_get_attribute:
        SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, *const c_char, *mut HostHandle) -> c_int>,
    pub(super) mesh_get_property_set: UnusedSuiteFunction,
    pub(super) mesh_alloc: SuiteFunction<unsafe extern "C" fn(HostHandle) -> c_int>,
    /// Returns 1 if the effect should stop.
    pub(super) abort: SuiteFunction<unsafe extern "C" fn(HostHandle) -> c_int>,
}

/// Messages to the user.
#[repr(C)]
pub(super) struct MessageSuite {
    /// A format as in `printf` and its arguments follow the kind and the identifier.
    pub(super) message:
        SuiteFunction<unsafe extern "C" fn(HostHandle, *const c_char, *const c_char, *const c_char, ...) -> c_int>,
}
