//! Raw pointers to values, slices and structs, each checked for what can be checked.

#![allow(clippy::not_unsafe_ptr_arg_deref, reason = "each caller is a function of C, whose comment states the promise")]

use super::status::Failure;
use super::status::gusset_status::{
    GUSSET_ERROR_BAD_STRUCT_SIZE, GUSSET_ERROR_BUFFER_TOO_SMALL, GUSSET_ERROR_MISALIGNED_ARGUMENT,
    GUSSET_ERROR_SIZE_OVERFLOW,
};
use crate::job::Job;
use std::ffi::c_void;
use std::mem::MaybeUninit;
use std::ptr;

pub(super) fn aligned<T>(pointer: *const T, name: &'static str) -> Result<(), Failure> {
    aligned_to(align_of::<T>(), pointer.addr(), name)
}

/// [`aligned`] without a type, so that it is compiled once.
fn aligned_to(alignment: usize, address: usize, name: &'static str) -> Result<(), Failure> {
    if address == 0 {
        Err(Failure::null(name))
    } else if !address.is_multiple_of(alignment) {
        let message = format!("{name} is not aligned to {alignment} bytes");
        Err(Failure::new(GUSSET_ERROR_MISALIGNED_ARGUMENT, message))
    } else {
        Ok(())
    }
}

/// An object that lives while the call runs; handles are read by `handle::get`.
pub fn reference<'a, T>(pointer: *const T, name: &'static str) -> Result<&'a T, Failure> {
    aligned(pointer, name)?;
    // SAFETY: not NULL and aligned; that it points to a live T is the caller's promise.
    Ok(unsafe { &*pointer })
}

/// Where a result goes; `cleared` is written at once, so that a failure leaves nothing old behind.
pub(crate) fn output<'a, T>(pointer: *mut T, cleared: T, name: &'static str) -> Result<&'a mut T, Failure> {
    aligned(pointer, name)?;
    // SAFETY: not NULL and aligned; that it points to writable memory for a T is the caller's
    // promise.
    unsafe {
        pointer.write(cleared);
        Ok(&mut *pointer)
    }
}

/// As [`output`], for what need not be asked for.
pub(crate) fn optional_output<'a, T>(
    pointer: *mut T,
    cleared: T,
    name: &'static str,
) -> Result<Option<&'a mut T>, Failure> {
    if pointer.is_null() { Ok(None) } else { output(pointer, cleared, name).map(Some) }
}

/// Fills an [`optional_output`].
pub(crate) fn set<T>(slot: Option<&mut T>, value: T) {
    if let Some(slot) = slot {
        *slot = value;
    }
}

/// Three coordinates of the caller's, at any alignment.
pub(crate) fn vector(pointer: *const f64, name: &'static str) -> Result<glam::DVec3, Failure> {
    let bytes = bytes(pointer.cast(), 3, 8, name)?;
    Ok(glam::DVec3::from_array(bytemuck::pod_read_unaligned(bytes)))
}

/// A buffer of the caller's for `count` elements; anything will do for none.
fn buffer<T>(pointer: *mut T, count: usize, name: &'static str) -> Result<*mut [T], Failure> {
    if count == 0 {
        return Ok(ptr::slice_from_raw_parts_mut(ptr::dangling_mut(), 0));
    }
    aligned(pointer, name)?;
    bytes(pointer.cast_const().cast(), count, size_of::<T>(), name)?;
    Ok(ptr::slice_from_raw_parts_mut(pointer, count))
}

/// A buffer of the caller's for `count` results of plain numbers; anything will do for none.
pub fn results<'a, T: bytemuck::Pod>(
    pointer: *mut T,
    count: usize,
    name: &'static str,
) -> Result<&'a mut [T], Failure> {
    // SAFETY: not NULL, aligned, at most isize::MAX bytes; that it has room for so many is the
    // caller's promise. Plain numbers may hold anything.
    buffer(pointer, count, name).map(|buffer| unsafe { &mut *buffer })
}

/// As [`results`], with every byte 0 at once, so that a failure leaves nothing old behind.
pub(crate) fn cleared<'a, T: bytemuck::Pod>(
    pointer: *mut T,
    count: usize,
    name: &'static str,
) -> Result<&'a mut [T], Failure> {
    let out = results(pointer, count, name)?;
    out.fill(T::zeroed());
    Ok(out)
}

/// A buffer of the caller's for `count` handles.
pub(crate) fn handles<'a, T>(
    pointer: *mut *mut T,
    count: usize,
    name: &'static str,
) -> Result<&'a mut [*mut T], Failure> {
    let handles = buffer(pointer, count, name)?;
    // SAFETY: as in results; NULL is a value of every pointer.
    unsafe {
        handles.cast::<*mut T>().write_bytes(0, count);
        Ok(&mut *handles)
    }
}

/// `count` elements of the caller's, read as bytes: any alignment will do.
pub fn bytes<'a>(pointer: *const c_void, count: usize, size: usize, name: &'static str) -> Result<&'a [u8], Failure> {
    let length = count.checked_mul(size).filter(|&n| n <= isize::MAX as usize);
    let Some(length) = length else {
        return Err(Failure::new(
            GUSSET_ERROR_SIZE_OVERFLOW,
            format!("{count} elements of {name} exceed the address space"),
        ));
    };
    if length == 0 {
        return Ok(&[]);
    }
    if pointer.is_null() {
        return Err(Failure::null(name));
    }
    // SAFETY: not NULL, at most isize::MAX bytes, and bytes need no alignment; that so many can be
    // read, and that nobody writes to them during the call, is the caller's promise.
    Ok(unsafe { std::slice::from_raw_parts(pointer.cast(), length) })
}

/// `count` elements of plain numbers of the caller's, at any alignment.
pub(crate) fn items<'a, T: bytemuck::AnyBitPattern>(
    pointer: *const T,
    count: usize,
    name: &'static str,
) -> Result<impl ExactSizeIterator<Item = T> + use<'a, T>, Failure> {
    let bytes: &'a [u8] = bytes(pointer.cast(), count, size_of::<T>(), name)?;
    Ok(bytes.chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned))
}

/// As [`items`], copied.
pub(crate) fn list<T: bytemuck::AnyBitPattern>(
    pointer: *const T,
    count: usize,
    name: &'static str,
) -> Result<Vec<T>, Failure> {
    Ok(gusset_base::alloc::collect(items(pointer, count, name)?)?)
}

/// A flag of the caller's.
pub(crate) fn flag(value: u32, name: &'static str) -> Result<bool, Failure> {
    match value {
        0 | 1 => Ok(value == 1),
        other => Err(Failure::unknown(name, other.into())),
    }
}

/// An enum of the core whose variants are constants in C; `c_enum` makes its impl.
pub(crate) trait Choice: Sized {
    /// The field or parameter that takes them.
    const NAME: &'static str;

    /// The variant of a constant.
    fn of(value: u32) -> Option<Self>;

    /// The constant of a variant.
    fn number(self) -> u32;
}

/// One of the constants of an enum.
pub(crate) fn choice<T: Choice>(value: u32) -> Result<T, Failure> {
    T::of(value).ok_or_else(|| Failure::unknown(T::NAME, value.into()))
}

/// What is lent of a list: its first element, or NULL if it is empty.
pub(crate) fn lent<T>(list: &[T]) -> *const T {
    if list.is_empty() { ptr::null() } else { list.as_ptr() }
}

/// Fills the caller's buffer of `capacity` elements with the `needed` ones that `make` gives, or
/// only tells their number if there is no buffer. Without memory nothing is written, nor is the
/// number.
pub(crate) fn fill<T: bytemuck::Pod, I: IntoIterator<Item = T>>(
    (buffer, capacity, name): (*mut T, usize, &'static str),
    needed: usize,
    written: &mut usize,
    job: &Job<'_>,
    make: impl FnOnce() -> Result<I, Failure>,
) -> Result<(), Failure> {
    if buffer.is_null() && capacity == 0 {
        job.finish()?;
        *written = needed;
        return Ok(());
    }
    if capacity < needed {
        *written = needed;
        let message = format!("{name} has room for {capacity} and {needed} are needed");
        return Err(Failure { value: needed as f64, ..Failure::new(GUSSET_ERROR_BUFFER_TOO_SMALL, message) });
    }
    let (out, made) = (results(buffer, needed, name)?, make()?);
    job.finish()?;
    out.iter_mut().zip(made).for_each(|(to, from)| *to = from);
    *written = needed;
    Ok(())
}

/// As [`fill`], with a copy of what the library has.
pub(crate) fn copy<T: bytemuck::Pod>(
    buffer: (*mut T, usize, &'static str),
    from: &[T],
    written: &mut usize,
    job: &Job<'_>,
) -> Result<(), Failure> {
    fill(buffer, from.len(), written, job, || Ok(from.iter().copied()))
}

/// A struct of plain numbers and pointers that begins with `size_t struct_size`.
///
/// # Safety
/// `repr(C)`, its first field is the size, and all bytes zero are a valid value.
pub(crate) unsafe trait Versioned: Copy {
    /// The size of the first version that was published.
    const MIN_SIZE: usize;

    /// The field of this name, if the struct has one and is read.
    fn reserved(&self) -> u32 {
        0
    }
}

/// Reads the struct, as long as the caller's version of it is; fields that it lacks are 0. NULL
/// gives all zeros if `optional`. Bytes beyond what this version knows must be 0, and so must
/// `reserved`.
pub(crate) fn read<T: Versioned>(pointer: *const T, optional: bool, name: &'static str) -> Result<T, Failure> {
    // SAFETY: zeros are valid, by the trait.
    let mut value: T = unsafe { MaybeUninit::zeroed().assume_init() };
    if optional && pointer.is_null() {
        return Ok(value);
    }
    let size = struct_size(pointer, name)?;
    let known = size_of::<T>().min(size);
    // SAFETY: aligned and not NULL; the caller promises `size` readable bytes. Copying a prefix
    // over zeros gives a value of plain fields.
    unsafe { ptr::copy_nonoverlapping(pointer.cast::<u8>(), (&raw mut value).cast(), known) };
    let tail = bytes(pointer.wrapping_byte_add(known).cast(), size - known, 1, name)?;
    check_unknown_fields(tail, value.reserved(), name)?;
    Ok(value)
}

/// Fails if a host sets `reserved`, or fields behind those that this version knows.
fn check_unknown_fields(tail: &[u8], reserved: u32, name: &'static str) -> Result<(), Failure> {
    match tail.iter().find(|&&byte| byte != 0) {
        Some(&byte) => {
            Err(Failure::unknown(format_args!("a field of {name} that this version does not know"), byte.into()))
        }
        None if reserved != 0 => Err(Failure::unknown(format_args!("{name}.reserved"), reserved.into())),
        None => Ok(()),
    }
}

/// Options within other options, NULL for the defaults, as `checked` makes them: what it refuses is
/// named by its path.
pub(crate) fn nested<T: Versioned, U>(
    pointer: *const T,
    name: &'static str,
    checked: impl FnOnce(T) -> Result<U, Failure>,
) -> Result<U, Failure> {
    checked(read(pointer, true, name)?).map_err(|failure| failure.of_field(name))
}

/// Where the structs of an array are, all of which must be as large as the first one says; each
/// failure with its number.
pub(crate) fn structs<T: Versioned>(
    first: *const T,
    count: usize,
    name: &'static str,
) -> Result<impl ExactSizeIterator<Item = Result<*const T, Failure>>, Failure> {
    let size = if count == 0 { 0 } else { struct_size(first, name)? };
    bytes(first.cast(), count, size, name)?;
    Ok((0..count).map(move |k| {
        let one = first.wrapping_byte_add(k * size);
        let found = struct_size(one, name).map_err(|failure| failure.of_item(k))?;
        if found == size {
            Ok(one)
        } else {
            let message = format!("{name}: the struct_size of number {k} is {found}, and that of the first one {size}");
            Err(Failure { value: found as f64, ..Failure::new(GUSSET_ERROR_BAD_STRUCT_SIZE, message) }.of_item(k))
        }
    }))
}

/// Clears a struct that the caller wants filled, all but its size, and returns the writer.
pub(crate) fn output_struct<T: Versioned>(pointer: *mut T, name: &'static str) -> Result<Output<T>, Failure> {
    let size = struct_size(pointer, name)?;
    let field = size_of::<usize>();
    // SAFETY: aligned and not NULL; the caller promises `size` writable bytes.
    unsafe { pointer.cast::<u8>().add(field).write_bytes(0, size - field) };
    Ok(Output { pointer, size })
}

/// A struct of the caller's to be filled.
pub(crate) struct Output<T> {
    pointer: *mut T,
    size: usize,
}

impl<T: Versioned> Output<T> {
    /// Writes the fields that the caller's version has; its struct_size stays.
    pub(crate) fn write(self, value: T) {
        let (field, end) = (size_of::<usize>(), self.size.min(size_of::<T>()));
        // SAFETY: as in output_struct; `value` is at least `end` bytes long.
        unsafe {
            let from = (&raw const value).cast::<u8>().add(field);
            ptr::copy_nonoverlapping(from, self.pointer.cast::<u8>().add(field), end - field);
        }
    }
}

/// The size that the caller's struct says it has.
fn struct_size<T: Versioned>(pointer: *const T, name: &'static str) -> Result<usize, Failure> {
    aligned(pointer, name)?;
    // SAFETY: aligned and not NULL, and every version begins with the size.
    let size = unsafe { pointer.cast::<usize>().read() };
    check_struct_size(T::MIN_SIZE, size_of::<T>(), size, name)
}

/// Fails if `size` is below that of the first version, or beyond that of any.
fn check_struct_size(min: usize, known: usize, size: usize, name: &'static str) -> Result<usize, Failure> {
    if size < min || size > 4096 {
        let message = format!("{name}: struct_size is {size}, and this version has {known}");
        return Err(Failure { value: size as f64, ..Failure::new(GUSSET_ERROR_BAD_STRUCT_SIZE, message) });
    }
    Ok(size)
}
