//! The suites of a host, behind types that check statuses and keep unsafe calls in one place.

use super::ofx_abi::{
    ATTRIB_DATA, ATTRIB_STRIDE, ATTRIB_TYPE, HostHandle, MESH_EFFECT_SUITE, MESSAGE_SUITE, MeshEffectSuite,
    MessageSuite, OfxHost, OfxStatus, PARAMETER_SUITE, PROPERTY_SUITE, ParameterSuite, PropertySuite,
};
use gusset::capi::input;
use gusset::capi::status::Failure;
use std::ffi::{CStr, CString, c_int, c_void};
use std::ptr;

/// The reason why an effect failed.
pub(super) enum EffectFault {
    /// The host failed, or lacks a feature.
    Host(OfxStatus),
    /// The library reported an error.
    Ours(Failure),
}

impl From<OfxStatus> for EffectFault {
    fn from(status: OfxStatus) -> Self {
        EffectFault::Host(status)
    }
}

impl<F: Into<Failure>> From<F> for EffectFault {
    fn from(failure: F) -> Self {
        EffectFault::Ours(failure.into())
    }
}

/// Calls a function of a suite. Returns an error if the host lacks the function, or the function
/// fails.
macro_rules! call {
    ($suite:expr, $function:ident($($argument:expr),*)) => {
        match $suite.$function {
            // SAFETY: the host provides the function for this purpose. Handles come from the host,
            // texts end with NUL, and pointers refer to live variables.
            Some(function) => OfxStatus::check_status(unsafe { function($($argument),*) }),
            None => Err(OfxStatus::MISSING_HOST_FEATURE),
        }
    };
}

/// The suites of a host, which live as long as the library is loaded.
pub(super) struct HostSuites {
    properties: &'static PropertySuite,
    parameters: &'static ParameterSuite,
    meshes: &'static MeshEffectSuite,
    messages: Option<&'static MessageSuite>,
}

impl HostSuites {
    /// Fetches the suites of a host. The message suite is optional.
    pub(super) fn fetch_from_host(host: *const OfxHost) -> Result<Self, OfxStatus> {
        let host = input::checked_reference(host, "host").map_err(|_| OfxStatus::MISSING_HOST_FEATURE)?;
        let needed = OfxStatus::MISSING_HOST_FEATURE;
        Ok(HostSuites {
            properties: fetch_suite(host, PROPERTY_SUITE, 1).ok_or(needed)?,
            parameters: fetch_suite(host, PARAMETER_SUITE, 1).ok_or(needed)?,
            meshes: fetch_suite(host, MESH_EFFECT_SUITE, 1).ok_or(needed)?,
            // Version 2 begins with the functions of version 1.
            messages: fetch_suite(host, MESSAGE_SUITE, 1).or_else(|| fetch_suite(host, MESSAGE_SUITE, 2)),
        })
    }

    /// The properties of an effect; `None` if the host does not provide them.
    pub(super) fn effect_properties(&self, effect: HostHandle) -> Option<PropertySet> {
        let mut handle = ptr::null_mut();
        call!(self.meshes, get_property_set(effect, &raw mut handle)).ok()?;
        Some(self.property_set_of(handle))
    }

    /// The properties with the given handle.
    pub(super) fn property_set_of(&self, handle: HostHandle) -> PropertySet {
        PropertySet { suite: self.properties, handle }
    }

    /// Defines an input or the output of an effect.
    pub(super) fn define_input(&self, effect: HostHandle, name: &CStr) -> Result<PropertySet, OfxStatus> {
        // Some hosts write to both pointers without a test for NULL.
        let (mut input, mut handle) = (ptr::null_mut(), ptr::null_mut());
        call!(self.meshes, input_define(effect, name.as_ptr(), &raw mut input, &raw mut handle))?;
        Ok(self.property_set_of(handle))
    }

    /// The parameters of an effect.
    pub(super) fn parameters_of_effect(&self, effect: HostHandle) -> Result<HostParameters<'_>, OfxStatus> {
        let mut set = ptr::null_mut();
        call!(self.meshes, get_param_set(effect, &raw mut set))?;
        Ok(HostParameters { suites: self, set })
    }

    /// The mesh of an input or of the output; `None` if it is not connected.
    pub(super) fn open_input_mesh(
        &self,
        effect: HostHandle,
        name: &CStr,
        time: f64,
    ) -> Result<Option<HostMesh<'_>>, OfxStatus> {
        let (mut input, mut unused) = (ptr::null_mut(), ptr::null_mut());
        call!(self.meshes, input_get_handle(effect, name.as_ptr(), &raw mut input, &raw mut unused))?;
        let (mut handle, mut properties) = (ptr::null_mut(), ptr::null_mut());
        match call!(self.meshes, input_get_mesh(input, time, &raw mut handle, &raw mut properties)) {
            Ok(()) if handle.is_null() => Ok(None),
            Ok(()) => Ok(Some(HostMesh { suites: self, handle, properties: self.property_set_of(properties) })),
            Err(OfxStatus::FAILED) => Ok(None),
            Err(status) => Err(status),
        }
    }

    /// Whether the host wants an effect to stop.
    pub(super) fn is_aborted(&self, effect: HostHandle) -> bool {
        // SAFETY: the host provides the function for this purpose, and the handle.
        self.meshes.abort.is_some_and(|abort| unsafe { abort(effect) } != 0)
    }

    /// Shows a message to the user. A host without messages only sees the status.
    pub(super) fn show_message(&self, effect: HostHandle, kind: &CStr, text: &str) {
        // The text itself is the format, with `%` escaped, so that arguments are not needed.
        let format = CString::new(text.replace('%', "%%").replace('\0', " ")).unwrap_or_default();
        let Some(message) = self.messages.and_then(|suite| suite.message) else { return };
        // SAFETY: the host provides the function for this purpose. The texts end with NUL, and the
        // format does not take arguments.
        unsafe { message(effect, kind.as_ptr(), c"".as_ptr(), format.as_ptr()) };
    }
}

fn fetch_suite<T>(host: &OfxHost, name: &CStr, version: c_int) -> Option<&'static T> {
    // SAFETY: the host provides the function for this purpose, with its own handle. The text ends
    // with NUL.
    let suite = unsafe { host.fetch_suite?(host.host, name.as_ptr(), version) };
    input::checked_reference(suite.cast(), "suite").ok()
}

/// A set of named values that the host holds. Texts must be static, because the host keeps pointers to them.
#[derive(Clone, Copy)]
pub(super) struct PropertySet {
    suite: &'static PropertySuite,
    handle: HostHandle,
}

impl PropertySet {
    pub(super) fn set_text(&self, name: &CStr, index: usize, value: &'static CStr) -> Result<(), OfxStatus> {
        call!(self.suite, set_string(self.handle, name.as_ptr(), index as c_int, value.as_ptr()))
    }

    pub(super) fn set_int(&self, name: &CStr, index: usize, value: c_int) -> Result<(), OfxStatus> {
        call!(self.suite, set_int(self.handle, name.as_ptr(), index as c_int, value))
    }

    pub(super) fn set_double(&self, name: &CStr, index: usize, value: f64) -> Result<(), OfxStatus> {
        call!(self.suite, set_double(self.handle, name.as_ptr(), index as c_int, value))
    }

    pub(super) fn get_int(&self, name: &CStr) -> Option<c_int> {
        let mut value = 0;
        call!(self.suite, get_int(self.handle, name.as_ptr(), 0, &raw mut value)).ok().map(|()| value)
    }

    pub(super) fn get_double(&self, name: &CStr) -> Option<f64> {
        if self.handle.is_null() {
            return None;
        }
        let mut value = 0.0;
        call!(self.suite, get_double(self.handle, name.as_ptr(), 0, &raw mut value)).ok().map(|()| value)
    }

    pub(super) fn get_pointer(&self, name: &CStr) -> Option<*mut c_void> {
        let mut value = ptr::null_mut();
        call!(self.suite, get_pointer(self.handle, name.as_ptr(), 0, &raw mut value)).ok().map(|()| value)
    }

    fn is_text_equal(&self, name: &CStr, wanted: &CStr) -> bool {
        let mut value = ptr::null_mut();
        let found = call!(self.suite, get_string(self.handle, name.as_ptr(), 0, &raw mut value));
        // SAFETY: the pointer is not NULL, and the host provides a NUL-terminated text.
        found.is_ok() && !value.is_null() && unsafe { CStr::from_ptr(value) } == wanted
    }
}

/// The parameters of an effect.
pub(super) struct HostParameters<'a> {
    suites: &'a HostSuites,
    set: HostHandle,
}

impl HostParameters<'_> {
    /// Defines a parameter.
    pub(super) fn define_parameter(&self, kind: &CStr, name: &CStr) -> Result<PropertySet, OfxStatus> {
        let mut handle = ptr::null_mut();
        call!(self.suites.parameters, define(self.set, kind.as_ptr(), name.as_ptr(), &raw mut handle))?;
        Ok(self.suites.property_set_of(handle))
    }

    /// Reads the value of a double, or the `c_int` of an integer, choice or boolean. `value`
    /// remains unchanged if the host does not write to it.
    pub(super) fn read_value<T>(&self, name: &CStr, time: f64, value: &mut T) -> Result<(), OfxStatus> {
        let value: *mut T = value;
        let (suite, handle) = (self.suites.parameters, self.parameter_handle(name)?);
        call!(suite, get_value_at_time(handle, time, value)).or_else(|_| call!(suite, get_value(handle, value)))
    }

    /// Reads the value of a double with three components.
    pub(super) fn read_double_3d(&self, name: &CStr, time: f64, value: &mut [f64; 3]) -> Result<(), OfxStatus> {
        let [x, y, z] = value.each_mut().map(ptr::from_mut);
        let (suite, handle) = (self.suites.parameters, self.parameter_handle(name)?);
        call!(suite, get_value_at_time(handle, time, x, y, z)).or_else(|_| call!(suite, get_value(handle, x, y, z)))
    }

    fn parameter_handle(&self, name: &CStr) -> Result<HostHandle, OfxStatus> {
        let (mut handle, mut unused) = (ptr::null_mut(), ptr::null_mut());
        call!(self.suites.parameters, get_handle(self.set, name.as_ptr(), &raw mut handle, &raw mut unused))?;
        Ok(handle)
    }
}

/// A mesh of the host, released on drop.
pub(super) struct HostMesh<'a> {
    suites: &'a HostSuites,
    handle: HostHandle,
    pub(super) properties: PropertySet,
}

impl Drop for HostMesh<'_> {
    fn drop(&mut self) {
        // Only the host can handle a failure here.
        let _ = call!(self.suites.meshes, input_release_mesh(self.handle));
    }
}

/// An array of the host. With stride 0, all elements are equal to the first one.
pub(super) struct MeshAttribute {
    pub(super) data: *mut c_void,
    pub(super) stride: usize,
}

impl HostMesh<'_> {
    /// Allocates memory for the numbers of elements in the properties.
    pub(super) fn allocate_arrays(&self) -> Result<(), OfxStatus> {
        call!(self.suites.meshes, mesh_alloc(self.handle))
    }

    /// Returns an attribute of the given type.
    pub(super) fn get_attribute(&self, attached: &CStr, name: &CStr, kind: &CStr) -> Result<MeshAttribute, OfxStatus> {
        let mut handle = ptr::null_mut();
        call!(self.suites.meshes, mesh_get_attribute(self.handle, attached.as_ptr(), name.as_ptr(), &raw mut handle))?;
        let properties = self.suites.property_set_of(handle);
        if !properties.is_text_equal(ATTRIB_TYPE, kind) {
            return Err(OfxStatus::MISSING_HOST_FEATURE);
        }
        let data = properties.get_pointer(ATTRIB_DATA).ok_or(OfxStatus::BAD_HANDLE)?;
        let stride = properties.get_int(ATTRIB_STRIDE).and_then(|stride| usize::try_from(stride).ok());
        Ok(MeshAttribute { data, stride: stride.ok_or(OfxStatus::BAD_HANDLE)? })
    }
}
