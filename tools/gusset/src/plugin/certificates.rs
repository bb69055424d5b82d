//! Certificates, by the functions for C of the library that serves the filters.

use super::host::{Callbacks, Watcher, progress};
use super::library::Plugin;
use crate::failure::{Exit, Failure};
use gusset::capi::context::gusset_progress_fn;
use gusset::capi::mesh::certificate::gusset_certificate_view;
use gusset::capi::mesh::{GUSSET_F32, GUSSET_F64, GUSSET_U32, gusset_indices, gusset_mesh_view};
use gusset_io::{Mesh, Positions};
use std::ffi::{CStr, c_char, c_int, c_void};
use std::ptr;

/// Declares the functions, and finds them in a library or in this program.
macro_rules! functions {
    ($($name:ident($($argument:ty),*) $(-> $result:ty)?;)*) => {
        /// The functions of a library that certificates need.
        #[derive(Clone, Copy)]
        pub(super) struct CertificateFunctions {
            $($name: unsafe extern "C" fn($($argument),*) $(-> $result)?,)*
        }

        impl CertificateFunctions {
            /// Finds the functions in a library. Returns `None` if it lacks one.
            pub(super) fn find(library: &libloading::Library) -> Option<Self> {
                // SAFETY: a library with these symbols promises these types.
                unsafe { Some(Self { $($name: *library.get(concat!(stringify!($name), "\0").as_bytes()).ok()?,)* }) }
            }

            /// Returns the functions of the library that is linked into this program.
            #[cfg(feature = "linked")]
            pub(super) fn linked() -> Self {
                mod library {
                    use super::*;
                    unsafe extern "C" {
                        $(pub(super) fn $name($(_: $argument),*) $(-> $result)?;)*
                    }
                }
                Self { $($name: library::$name,)* }
            }
        }
    };
}

functions! {
    gusset_context_create(*mut *mut c_void) -> c_int;
    gusset_context_destroy(*mut c_void);
    gusset_context_set_threads(*mut c_void, u32) -> c_int;
    gusset_context_set_progress(*mut c_void, gusset_progress_fn, *mut c_void) -> c_int;
    gusset_context_get_message(*const c_void) -> *const c_char;
    gusset_certificate_create(
        *const c_void, *const gusset_mesh_view, usize, *const gusset_mesh_view, *mut *mut c_void
    ) -> c_int;
    gusset_certificate_get_view(*const c_void, *mut gusset_certificate_view) -> c_int;
    gusset_certificate_destroy(*mut c_void);
}

/// Statuses of the library that have exit statuses of their own.
const OUT_OF_MEMORY: c_int = 2000;
const CANCELLED: c_int = 2001;

/// Facts about a result, as the library lends them.
pub(crate) struct Certificate {
    functions: CertificateFunctions,
    context: *mut c_void,
    raw: *mut c_void,
}

impl Drop for Certificate {
    fn drop(&mut self) {
        // SAFETY: nothing refers to them any more; NULL is allowed.
        unsafe {
            (self.functions.gusset_certificate_destroy)(self.raw);
            (self.functions.gusset_context_destroy)(self.context);
        }
    }
}

impl Certificate {
    /// States facts about a result and the meshes that it was made from.
    pub(crate) fn new(
        plugin: Plugin,
        inputs: &[&Mesh],
        result: &Mesh,
        threads: u32,
        watcher: &dyn Watcher,
    ) -> Result<Self, Failure> {
        let functions = plugin.certificate_functions().ok_or_else(|| {
            Failure::new(Exit::Plugin, format!("{} lacks the functions for certificates", plugin.title()))
        })?;
        let mut made = Self { functions, context: ptr::null_mut(), raw: ptr::null_mut() };
        let views: Vec<gusset_mesh_view> = inputs.iter().map(|mesh| mesh_view(mesh)).collect();
        let result = mesh_view(result);
        let callbacks = Callbacks::new(watcher);
        let user = ptr::from_ref(&callbacks).cast_mut().cast();
        // SAFETY: the arrays and the callbacks are valid during the calls.
        unsafe {
            let status = (functions.gusset_context_create)(&mut made.context);
            made.check(status)?;
            made.check((functions.gusset_context_set_threads)(made.context, threads))?;
            made.check((functions.gusset_context_set_progress)(made.context, Some(progress), user))?;
            let (pieces, count) = (views.as_ptr(), views.len());
            let status = (functions.gusset_certificate_create)(made.context, pieces, count, &result, &mut made.raw);
            made.check(status)?;
        }
        Ok(made)
    }

    fn check(&self, status: c_int) -> Result<(), Failure> {
        let exit = match status {
            0 => return Ok(()),
            OUT_OF_MEMORY => Exit::Memory,
            CANCELLED => return Err(Failure::new(Exit::Cancelled, "cancelled")),
            _ => Exit::Refused,
        };
        // SAFETY: the context may be NULL, and the text lives until its next call.
        let message = unsafe { CStr::from_ptr((self.functions.gusset_context_get_message)(self.context)) };
        Err(Failure::new(exit, format!("certify: {} (status {status})", message.to_string_lossy())))
    }

    /// Returns the facts.
    pub(crate) fn view(&self) -> Result<gusset_certificate_view, Failure> {
        // SAFETY: a struct of numbers and pointers may be zero.
        let mut view: gusset_certificate_view = unsafe { std::mem::zeroed() };
        view.struct_size = size_of::<gusset_certificate_view>();
        // SAFETY: a certificate of this library.
        self.check(unsafe { (self.functions.gusset_certificate_get_view)(self.raw, &mut view) })?;
        Ok(view)
    }

    /// Returns a list of the view of this certificate.
    pub(crate) fn list(&self, lent: gusset_indices) -> &[u32] {
        if lent.data.is_null() {
            return &[];
        }
        // SAFETY: the lists of a view live as long as the certificate.
        unsafe { std::slice::from_raw_parts(lent.data, lent.count) }
    }
}

fn mesh_view(mesh: &Mesh) -> gusset_mesh_view {
    let (scalar, positions): (_, *const c_void) = match &mesh.positions {
        Positions::F32(points) => (GUSSET_F32, points.as_ptr().cast()),
        Positions::F64(points) => (GUSSET_F64, points.as_ptr().cast()),
    };
    gusset_mesh_view {
        struct_size: size_of::<gusset_mesh_view>(),
        positions,
        position_stride: 0,
        vertex_count: mesh.positions.len(),
        face_offsets: mesh.face_offsets.as_ptr().cast(),
        face_corners: mesh.corners.as_ptr().cast(),
        face_count: mesh.face_count(),
        scalar,
        index: GUSSET_U32,
        face_size: 0,
        reserved: 0,
        merge: if mesh.merge.is_empty() { ptr::null() } else { mesh.merge.as_ptr().cast() },
    }
}
