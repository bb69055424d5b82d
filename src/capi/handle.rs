//! Handles: objects behind opaque pointers of C. The kind of the object precedes it, so that a
//! pointer to another kind causes a status instead of a crash. A pointer that is not a handle at
//! all cannot be detected.

use super::guard::catch_panic;
use super::input::{self, check_aligned};
use super::status::Failure;
use super::status::gusset_status::GUSSET_ERROR_WRONG_HANDLE;
use std::ptr;

/// An object that C knows as an opaque pointer.
pub(crate) trait OpaqueHandle {
    /// Its name in C.
    const NAME: &'static str;
    /// A number that is unique to the kind, stored before the object.
    const KIND: u64;
}

/// An object preceded by its kind. Its address is the handle.
#[repr(C)]
pub(crate) struct TaggedObject<T> {
    kind: u64,
    object: T,
}

impl<T: OpaqueHandle> TaggedObject<T> {
    /// Creates an object that is lent to C as a part of another object and dies with it. C can read
    /// but not destroy it.
    pub(crate) fn new_embedded(object: T) -> Self {
        TaggedObject { kind: !T::KIND, object }
    }

    pub(crate) fn as_handle(&self) -> *const T {
        ptr::from_ref(self).cast()
    }
}

impl<T> std::ops::Deref for TaggedObject<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.object
    }
}

/// Allocates an object with its kind.
pub(crate) fn box_with_kind<T: OpaqueHandle>(object: T) -> Box<TaggedObject<T>> {
    Box::new(TaggedObject { kind: T::KIND, object })
}

/// Transfers the object to C, until [`destroy`] takes it back.
pub(crate) fn into_handle<T>(object: Box<TaggedObject<T>>) -> *mut T {
    Box::into_raw(object).cast()
}

/// Checks that the object is a T, either a handle of its own or, if `or_part`, a part of another.
fn check_kind<T: OpaqueHandle>(
    pointer: *const T,
    or_part: bool,
    name: &'static str,
) -> Result<*mut TaggedObject<T>, Failure> {
    let held = pointer.cast::<TaggedObject<T>>().cast_mut();
    check_aligned(held.cast_const(), name)?;
    // SAFETY: not NULL and aligned. The caller promises that it points to a live handle of the
    // library, and all handles begin with their kind.
    let kind = unsafe { (&raw const (*held).kind).read() };
    if kind == T::KIND || or_part && kind == !T::KIND {
        Ok(held)
    } else {
        Err(Failure::new(
            GUSSET_ERROR_WRONG_HANDLE,
            format!("{name} is not a live {}; pass a handle that was not destroyed", T::NAME),
        ))
    }
}

/// Returns the object of a handle.
pub(crate) fn get_object<'a, T: OpaqueHandle>(pointer: *const T, name: &'static str) -> Result<&'a T, Failure> {
    let held = check_kind(pointer, true, name)?;
    // SAFETY: as in `check_kind`. A T begins with this kind and lives during the call.
    Ok(unsafe { &(*held).object })
}

/// Reads `count` handles in an array at any alignment, for reading their objects. A failure has the
/// index of its handle.
pub(crate) fn get_objects<'a, T: OpaqueHandle + 'a>(
    handles: *const *const T,
    count: usize,
    name: &'static str,
) -> Result<impl ExactSizeIterator<Item = Result<&'a T, Failure>>, Failure> {
    input::input_bytes(handles.cast(), count, size_of::<*const T>(), name)?;
    Ok((0..count).map(move |k| {
        // SAFETY: within the checked bytes; any alignment is allowed.
        get_object(unsafe { handles.add(k).read_unaligned() }, name).map_err(|failure| failure.with_item(name, k))
    }))
}

/// Returns the object of a handle that the call changes.
pub(crate) fn get_object_mut<'a, T: OpaqueHandle>(pointer: *mut T, name: &'static str) -> Result<&'a mut T, Failure> {
    let held = check_kind(pointer, false, name)?;
    // SAFETY: as above; the caller promises exclusive use.
    Ok(unsafe { &mut (*held).object })
}

/// Frees the object of a handle from a `_create` function. Ignores NULL, handles of another kind,
/// and parts of other objects.
pub(crate) fn destroy<T: OpaqueHandle>(handle: *mut T) {
    // A destructor cannot fail; if it panics, the host must not notice.
    let _ = catch_panic(|| {
        if let Ok(held) = check_kind(handle, false, "handle") {
            // SAFETY: the object comes from `into_handle`, and the caller gives it up. The kind is
            // erased first, by a volatile write that survives although the memory is freed. A
            // second destroy then finds no kind, as long as the memory is not reused.
            unsafe {
                (&raw mut (*held).kind).write_volatile(0);
                drop(Box::from_raw(held));
            }
        }
        Ok::<_, Failure>(())
    });
}

/// `handle! { gusset_thing }` declares a type that C knows as an opaque pointer.
macro_rules! handle {
    ($name:ident) => {
        impl $crate::capi::handle::OpaqueHandle for $name {
            const NAME: &'static str = stringify!($name);
            const KIND: u64 = $crate::capi::handle::hash_of_name(stringify!($name));
        }
    };
}
pub(crate) use handle;

/// Returns the FNV-1a hash (G. Fowler, L. C. Noll and K.-P. Vo), which is distinct for the names of
/// all kinds.
pub(crate) const fn hash_of_name(name: &str) -> u64 {
    let (mut hash, mut i) = (0xcbf2_9ce4_8422_2325_u64, 0);
    while i < name.len() {
        hash = (hash ^ name.as_bytes()[i] as u64).wrapping_mul(0x0100_0000_01b3);
        i += 1;
    }
    hash
}
