//! The suites of a host, behind types that check statuses and keep unsafe calls in one place.

use super::abi::{
    ATTRIB_DATA, ATTRIB_STRIDE, ATTRIB_TYPE, Handle, MESH_EFFECT_SUITE, MESSAGE_SUITE, MeshEffectSuite, MessageSuite,
    OfxHost, PARAMETER_SUITE, PROPERTY_SUITE, ParameterSuite, PropertySuite, Status,
};
use gusset::capi::input;
use gusset::capi::status::Failure;
use std::ffi::{CStr, CString, c_int, c_void};
use std::ptr;

/// The reason why an effect failed.
pub(super) enum Fault {
    /// The host failed, or lacks a feature.
    Host(Status),
    /// The library reported an error.
    Ours(Failure),
}

impl From<Status> for Fault {
    fn from(status: Status) -> Self {
        Fault::Host(status)
    }
}

impl<F: Into<Failure>> From<F> for Fault {
    fn from(failure: F) -> Self {
        Fault::Ours(failure.into())
    }
}

/// Calls a function of a suite. Returns an error if the host lacks the function, or the function
/// fails.
macro_rules! call {
    ($suite:expr, $function:ident($($argument:expr),*)) => {
        match $suite.$function {
            // SAFETY: the host provides the function for this purpose. Handles come from the host,
            // texts end with NUL, and pointers refer to live variables.
            Some(function) => Status::check(unsafe { function($($argument),*) }),
            None => Err(Status::MISSING_HOST_FEATURE),
        }
    };
}

/// The suites of a host, which live as long as the library is loaded.
pub(super) struct Suites {
    properties: &'static PropertySuite,
    parameters: &'static ParameterSuite,
    meshes: &'static MeshEffectSuite,
    messages: Option<&'static MessageSuite>,
}

impl Suites {
    /// Fetches the suites of a host. The message suite is optional.
    pub(super) fn fetch(host: *const OfxHost) -> Result<Self, Status> {
        let host = input::reference(host, "host").map_err(|_| Status::MISSING_HOST_FEATURE)?;
        let needed = Status::MISSING_HOST_FEATURE;
        Ok(Suites {
            properties: suite(host, PROPERTY_SUITE, 1).ok_or(needed)?,
            parameters: suite(host, PARAMETER_SUITE, 1).ok_or(needed)?,
            meshes: suite(host, MESH_EFFECT_SUITE, 1).ok_or(needed)?,
            // Version 2 begins with the functions of version 1.
            messages: suite(host, MESSAGE_SUITE, 1).or_else(|| suite(host, MESSAGE_SUITE, 2)),
        })
    }

    /// The properties of an effect; `None` if the host does not provide them.
    pub(super) fn effect_properties(&self, effect: Handle) -> Option<Properties> {
        let mut handle = ptr::null_mut();
        call!(self.meshes, get_property_set(effect, &raw mut handle)).ok()?;
        Some(self.properties(handle))
    }

    /// The properties with the given handle.
    pub(super) fn properties(&self, handle: Handle) -> Properties {
        Properties { suite: self.properties, handle }
    }

    /// Defines an input or the output of an effect.
    pub(super) fn define_input(&self, effect: Handle, name: &CStr) -> Result<Properties, Status> {
        // Some hosts write to both pointers without a test for NULL.
        let (mut input, mut handle) = (ptr::null_mut(), ptr::null_mut());
        call!(self.meshes, input_define(effect, name.as_ptr(), &raw mut input, &raw mut handle))?;
        Ok(self.properties(handle))
    }

    /// The parameters of an effect.
    pub(super) fn parameters(&self, effect: Handle) -> Result<Parameters<'_>, Status> {
        let mut set = ptr::null_mut();
        call!(self.meshes, get_param_set(effect, &raw mut set))?;
        Ok(Parameters { suites: self, set })
    }

    /// The mesh of an input or of the output; `None` if it is not connected.
    pub(super) fn mesh(&self, effect: Handle, name: &CStr, time: f64) -> Result<Option<HostMesh<'_>>, Status> {
        let (mut input, mut unused) = (ptr::null_mut(), ptr::null_mut());
        call!(self.meshes, input_get_handle(effect, name.as_ptr(), &raw mut input, &raw mut unused))?;
        let (mut handle, mut properties) = (ptr::null_mut(), ptr::null_mut());
        match call!(self.meshes, input_get_mesh(input, time, &raw mut handle, &raw mut properties)) {
            Ok(()) if handle.is_null() => Ok(None),
            Ok(()) => Ok(Some(HostMesh { suites: self, handle, properties: self.properties(properties) })),
            Err(Status::FAILED) => Ok(None),
            Err(status) => Err(status),
        }
    }

    /// Whether the host wants an effect to stop.
    pub(super) fn is_aborted(&self, effect: Handle) -> bool {
        // SAFETY: the host provides the function for this purpose, and the handle.
        self.meshes.abort.is_some_and(|abort| unsafe { abort(effect) } != 0)
    }

    /// Shows a message to the user. A host without messages only sees the status.
    pub(super) fn message(&self, effect: Handle, kind: &CStr, text: &str) {
        // The text itself is the format, with `%` escaped, so that arguments are not needed.
        let format = CString::new(text.replace('%', "%%").replace('\0', " ")).unwrap_or_default();
        let Some(message) = self.messages.and_then(|suite| suite.message) else { return };
        // SAFETY: the host provides the function for this purpose. The texts end with NUL, and the
        // format does not take arguments.
        unsafe { message(effect, kind.as_ptr(), c"".as_ptr(), format.as_ptr()) };
    }
}

fn suite<T>(host: &OfxHost, name: &CStr, version: c_int) -> Option<&'static T> {
    // SAFETY: the host provides the function for this purpose, with its own handle. The text ends
    // with NUL.
    let suite = unsafe { host.fetch_suite?(host.host, name.as_ptr(), version) };
    input::reference(suite.cast(), "suite").ok()
}

/// Named values of the host. Texts must be static, because the host keeps pointers to them.
#[derive(Clone, Copy)]
pub(super) struct Properties {
    suite: &'static PropertySuite,
    handle: Handle,
}

impl Properties {
    pub(super) fn set_text(&self, name: &CStr, index: usize, value: &'static CStr) -> Result<(), Status> {
        call!(self.suite, set_string(self.handle, name.as_ptr(), index as c_int, value.as_ptr()))
    }

    pub(super) fn set_int(&self, name: &CStr, index: usize, value: c_int) -> Result<(), Status> {
        call!(self.suite, set_int(self.handle, name.as_ptr(), index as c_int, value))
    }

    pub(super) fn set_double(&self, name: &CStr, index: usize, value: f64) -> Result<(), Status> {
        call!(self.suite, set_double(self.handle, name.as_ptr(), index as c_int, value))
    }

    pub(super) fn int(&self, name: &CStr) -> Option<c_int> {
        let mut value = 0;
        call!(self.suite, get_int(self.handle, name.as_ptr(), 0, &raw mut value)).ok().map(|()| value)
    }

    pub(super) fn double(&self, name: &CStr) -> Option<f64> {
        if self.handle.is_null() {
            return None;
        }
        let mut value = 0.0;
        call!(self.suite, get_double(self.handle, name.as_ptr(), 0, &raw mut value)).ok().map(|()| value)
    }

    pub(super) fn pointer(&self, name: &CStr) -> Option<*mut c_void> {
        let mut value = ptr::null_mut();
        call!(self.suite, get_pointer(self.handle, name.as_ptr(), 0, &raw mut value)).ok().map(|()| value)
    }

    fn is_text(&self, name: &CStr, wanted: &CStr) -> bool {
        let mut value = ptr::null_mut();
        let found = call!(self.suite, get_string(self.handle, name.as_ptr(), 0, &raw mut value));
        // SAFETY: the pointer is not NULL, and the host provides a NUL-terminated text.
        found.is_ok() && !value.is_null() && unsafe { CStr::from_ptr(value) } == wanted
    }
}

/// The parameters of an effect.
pub(super) struct Parameters<'a> {
    suites: &'a Suites,
    set: Handle,
}

impl Parameters<'_> {
    /// Defines a parameter.
    pub(super) fn define(&self, kind: &CStr, name: &CStr) -> Result<Properties, Status> {
        let mut handle = ptr::null_mut();
        call!(self.suites.parameters, define(self.set, kind.as_ptr(), name.as_ptr(), &raw mut handle))?;
        Ok(self.suites.properties(handle))
    }

    /// Reads the value of a double, or the `c_int` of an integer, choice or boolean. `value`
    /// remains unchanged if the host does not write to it.
    pub(super) fn value<T>(&self, name: &CStr, time: f64, value: &mut T) -> Result<(), Status> {
        let value: *mut T = value;
        let (suite, handle) = (self.suites.parameters, self.handle(name)?);
        call!(suite, get_value_at_time(handle, time, value)).or_else(|_| call!(suite, get_value(handle, value)))
    }

    /// Reads the value of a double with three components.
    pub(super) fn double_3d(&self, name: &CStr, time: f64, value: &mut [f64; 3]) -> Result<(), Status> {
        let [x, y, z] = value.each_mut().map(ptr::from_mut);
        let (suite, handle) = (self.suites.parameters, self.handle(name)?);
        call!(suite, get_value_at_time(handle, time, x, y, z)).or_else(|_| call!(suite, get_value(handle, x, y, z)))
    }

    fn handle(&self, name: &CStr) -> Result<Handle, Status> {
        let (mut handle, mut unused) = (ptr::null_mut(), ptr::null_mut());
        call!(self.suites.parameters, get_handle(self.set, name.as_ptr(), &raw mut handle, &raw mut unused))?;
        Ok(handle)
    }
}

/// A mesh of the host, released on drop.
pub(super) struct HostMesh<'a> {
    suites: &'a Suites,
    handle: Handle,
    pub(super) properties: Properties,
}

impl Drop for HostMesh<'_> {
    fn drop(&mut self) {
        // Only the host can handle a failure here.
        let _ = call!(self.suites.meshes, input_release_mesh(self.handle));
    }
}

/// An array of the host. With stride 0, all elements are equal to the first one.
pub(super) struct Attribute {
    pub(super) data: *mut c_void,
    pub(super) stride: usize,
}

impl HostMesh<'_> {
    /// Allocates memory for the numbers of elements in the properties.
    pub(super) fn allocate(&self) -> Result<(), Status> {
        call!(self.suites.meshes, mesh_alloc(self.handle))
    }

    /// Returns an attribute of the given type.
    pub(super) fn attribute(&self, attached: &CStr, name: &CStr, kind: &CStr) -> Result<Attribute, Status> {
        let mut handle = ptr::null_mut();
        call!(self.suites.meshes, mesh_get_attribute(self.handle, attached.as_ptr(), name.as_ptr(), &raw mut handle))?;
        let properties = self.suites.properties(handle);
        if !properties.is_text(ATTRIB_TYPE, kind) {
            return Err(Status::MISSING_HOST_FEATURE);
        }
        let data = properties.pointer(ATTRIB_DATA).ok_or(Status::BAD_HANDLE)?;
        let stride = properties.int(ATTRIB_STRIDE).and_then(|stride| usize::try_from(stride).ok());
        Ok(Attribute { data, stride: stride.ok_or(Status::BAD_HANDLE)? })
    }
}
