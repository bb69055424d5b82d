//! Handles: objects behind opaque pointers of C, each with the name of its kind before it, so that
//! a pointer to another kind is a status and not a crash. What is no handle at all cannot be told.

use super::guard::caught;
use super::input::{self, aligned};
use super::status::Failure;
use super::status::gusset_status::GUSSET_ERROR_WRONG_HANDLE;
use std::ptr;

/// An object that C knows as an opaque pointer.
pub(crate) trait Handle {
    /// Its name in C.
    const NAME: &'static str;
    /// A number that no other kind has: what stands before the object.
    const KIND: u64;
}

/// An object with its kind before it, whose address is the handle.
#[repr(C)]
pub(crate) struct Tagged<T> {
    kind: u64,
    object: T,
}

impl<T: Handle> Tagged<T> {
    /// An object that is lent to C as a part of another, and goes with it: it can be read, and not
    /// destroyed.
    pub(crate) fn part(object: T) -> Self {
        Tagged { kind: !T::KIND, object }
    }

    pub(crate) fn lent(&self) -> *const T {
        ptr::from_ref(self).cast()
    }
}

impl<T> std::ops::Deref for Tagged<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.object
    }
}

/// The object with its kind, in memory of its own.
pub(crate) fn boxed<T: Handle>(object: T) -> Box<Tagged<T>> {
    Box::new(Tagged { kind: T::KIND, object })
}

/// Gives the object to C, until [`destroy`] takes it back.
pub(crate) fn give<T>(object: Box<Tagged<T>>) -> *mut T {
    Box::into_raw(object).cast()
}

/// Whether what begins here says that it is a T, of its own or `or_part`.
fn checked<T: Handle>(pointer: *const T, or_part: bool, name: &'static str) -> Result<*mut Tagged<T>, Failure> {
    let held = pointer.cast::<Tagged<T>>().cast_mut();
    aligned(held.cast_const(), name)?;
    // SAFETY: not NULL and aligned; that it points to a live handle of the library is the caller's
    // promise, and all handles begin with their kind.
    let kind = unsafe { (&raw const (*held).kind).read() };
    if kind == T::KIND || or_part && kind == !T::KIND {
        Ok(held)
    } else {
        Err(Failure::new(GUSSET_ERROR_WRONG_HANDLE, format!("{name} is no live {}", T::NAME)))
    }
}

/// The object of a handle.
pub(crate) fn get<'a, T: Handle>(pointer: *const T, name: &'static str) -> Result<&'a T, Failure> {
    let held = checked(pointer, true, name)?;
    // SAFETY: as there; a T begins with this kind, and lives while the call runs.
    Ok(unsafe { &(*held).object })
}

/// `count` handles of the caller's that stay as they are, in an array at any alignment; each
/// failure with its number.
pub(crate) fn list<'a, T: Handle + 'a>(
    handles: *const *const T,
    count: usize,
    name: &'static str,
) -> Result<impl ExactSizeIterator<Item = Result<&'a T, Failure>>, Failure> {
    input::bytes(handles.cast(), count, size_of::<*const T>(), name)?;
    Ok((0..count).map(move |k| {
        // SAFETY: within the bytes that were checked; any alignment will do.
        get(unsafe { handles.add(k).read_unaligned() }, name).map_err(|failure| failure.of_item(k))
    }))
}

/// The object of a handle that the call changes.
pub(crate) fn get_mut<'a, T: Handle>(pointer: *mut T, name: &'static str) -> Result<&'a mut T, Failure> {
    let held = checked(pointer, false, name)?;
    // SAFETY: as above; that nobody else uses it now is the caller's promise.
    Ok(unsafe { &mut (*held).object })
}

/// Frees what a `_create` function gave out; NULL is allowed, and handles of another kind, or lent
/// as parts of others, are left alone.
pub(crate) fn destroy<T: Handle>(handle: *mut T) {
    // A destructor cannot fail; should one panic, the host must not see it.
    let _ = caught(|| {
        if let Ok(held) = checked(handle, false, "handle") {
            // SAFETY: it came from `give`, and the caller gives it up. The kind goes first,
            // by a write that stays although the memory is freed: a second destroy finds it gone,
            // as long as the memory is not used again.
            unsafe {
                (&raw mut (*held).kind).write_volatile(0);
                drop(Box::from_raw(held));
            }
        }
        Ok::<_, Failure>(())
    });
}

/// `handle! { gusset_thing }`: C knows this type as an opaque pointer.
macro_rules! handle {
    ($name:ident) => {
        impl $crate::capi::handle::Handle for $name {
            const NAME: &'static str = stringify!($name);
            const KIND: u64 = $crate::capi::handle::kind(stringify!($name));
        }
    };
}
pub(crate) use handle;

/// FNV-1a, G. Fowler, L. C. Noll and K.-P. Vo: of the names of all kinds no two are equal.
pub(crate) const fn kind(name: &str) -> u64 {
    let (mut hash, mut i) = (0xcbf2_9ce4_8422_2325_u64, 0);
    while i < name.len() {
        hash = (hash ^ name.as_bytes()[i] as u64).wrapping_mul(0x0100_0000_01b3);
        i += 1;
    }
    hash
}
