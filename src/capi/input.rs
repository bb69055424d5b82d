//! Conversion of raw pointers to values, slices and structs, with all possible checks.

#![allow(clippy::not_unsafe_ptr_arg_deref, reason = "each caller is a function of C, whose comment states the promise")]

use super::status::Failure;
use super::status::gusset_status::{
    GUSSET_ERROR_BAD_STRUCT_SIZE, GUSSET_ERROR_BUFFER_TOO_SMALL, GUSSET_ERROR_MISALIGNED_ARGUMENT,
    GUSSET_ERROR_SIZE_OVERFLOW,
};
use crate::error::Error;
use crate::job::Job;
use std::ffi::c_void;
use std::mem::MaybeUninit;
use std::ptr;

pub(super) fn check_aligned<T>(pointer: *const T, name: &'static str) -> Result<(), Failure> {
    check_aligned_to(align_of::<T>(), pointer.addr(), name)
}

/// [`check_aligned`] without a type parameter, so that it is compiled only once.
fn check_aligned_to(alignment: usize, address: usize, name: &'static str) -> Result<(), Failure> {
    if address == 0 {
        Err(Failure::null_argument(name))
    } else if !address.is_multiple_of(alignment) {
        let message = format!("{name} is {address:#x}; it must be a multiple of {alignment}");
        Err(Failure::new(GUSSET_ERROR_MISALIGNED_ARGUMENT, message))
    } else {
        Ok(())
    }
}

/// Returns an object that lives during the call. `handle::get` reads handles instead.
pub fn checked_reference<'a, T>(pointer: *const T, name: &'static str) -> Result<&'a T, Failure> {
    check_aligned(pointer, name)?;
    // SAFETY: not NULL and aligned; the caller promises that it points to a live T.
    Ok(unsafe { &*pointer })
}

/// Returns the place of a result. It writes `cleared` at once, so that the place is defined after a
/// failure.
pub(crate) fn cleared_output<'a, T>(pointer: *mut T, cleared: T, name: &'static str) -> Result<&'a mut T, Failure> {
    check_aligned(pointer, name)?;
    // SAFETY: not NULL and aligned; the caller promises writable memory for a T.
    unsafe {
        pointer.write(cleared);
        Ok(&mut *pointer)
    }
}

/// [`cleared_output`] for a result that the caller may omit.
pub(crate) fn cleared_optional_output<'a, T>(
    pointer: *mut T,
    cleared: T,
    name: &'static str,
) -> Result<Option<&'a mut T>, Failure> {
    if pointer.is_null() { Ok(None) } else { cleared_output(pointer, cleared, name).map(Some) }
}

/// Fills an [`cleared_optional_output`].
pub(crate) fn set_optional_output<T>(slot: Option<&mut T>, value: T) {
    if let Some(slot) = slot {
        *slot = value;
    }
}

/// Reads three coordinates, at any alignment.
pub(crate) fn read_vector(pointer: *const f64, name: &'static str) -> Result<glam::DVec3, Failure> {
    let bytes = input_bytes(pointer.cast(), 3, 8, name)?;
    Ok(glam::DVec3::from_array(bytemuck::pod_read_unaligned(bytes)))
}

/// Returns the caller's buffer for `count` elements. If `count` is 0, any pointer is valid.
fn output_buffer<T>(pointer: *mut T, count: usize, name: &'static str) -> Result<*mut [T], Failure> {
    if count == 0 {
        return Ok(ptr::slice_from_raw_parts_mut(ptr::dangling_mut(), 0));
    }
    check_aligned(pointer, name)?;
    input_bytes(pointer.cast_const().cast(), count, size_of::<T>(), name)?;
    Ok(ptr::slice_from_raw_parts_mut(pointer, count))
}

/// Returns the caller's buffer for `count` results of plain numbers. If `count` is 0, any pointer
/// is valid.
pub fn result_buffer<'a, T: bytemuck::Pod>(
    pointer: *mut T,
    count: usize,
    name: &'static str,
) -> Result<&'a mut [T], Failure> {
    // SAFETY: not NULL, aligned, and at most isize::MAX bytes. The caller promises room for `count`
    // elements. Plain numbers may hold any bits.
    output_buffer(pointer, count, name).map(|buffer| unsafe { &mut *buffer })
}

/// [`result_buffer`], with every byte set to 0 at once, so that the buffer is defined after a
/// failure.
pub(crate) fn cleared_result_buffer<'a, T: bytemuck::Pod>(
    pointer: *mut T,
    count: usize,
    name: &'static str,
) -> Result<&'a mut [T], Failure> {
    let out = result_buffer(pointer, count, name)?;
    out.fill(T::zeroed());
    Ok(out)
}

/// Returns the caller's buffer for `count` handles.
pub(crate) fn handle_buffer<'a, T>(
    pointer: *mut *mut T,
    count: usize,
    name: &'static str,
) -> Result<&'a mut [*mut T], Failure> {
    let handles = output_buffer(pointer, count, name)?;
    // SAFETY: as in `result_buffer`; NULL is a valid pointer value.
    unsafe {
        handles.cast::<*mut T>().write_bytes(0, count);
        Ok(&mut *handles)
    }
}

/// Returns `count` elements as bytes, at any alignment.
pub fn input_bytes<'a>(
    pointer: *const c_void,
    count: usize,
    size: usize,
    name: &'static str,
) -> Result<&'a [u8], Failure> {
    let length = count.checked_mul(size).filter(|&n| n <= isize::MAX as usize);
    let Some(length) = length else {
        return Err(Failure::new(
            GUSSET_ERROR_SIZE_OVERFLOW,
            format!("{name} has {count} elements of {size} bytes, which exceed the address space; check the count"),
        ));
    };
    if length == 0 {
        return Ok(&[]);
    }
    if pointer.is_null() {
        return Err(Failure::null_argument(name));
    }
    // SAFETY: not NULL, at most isize::MAX bytes, and bytes need no alignment. The caller promises
    // that they are readable and that nobody writes to them during the call.
    Ok(unsafe { std::slice::from_raw_parts(pointer.cast(), length) })
}

/// Iterates over `count` elements of plain numbers, at any alignment.
pub(crate) fn input_items<'a, T: bytemuck::AnyBitPattern>(
    pointer: *const T,
    count: usize,
    name: &'static str,
) -> Result<impl ExactSizeIterator<Item = T> + use<'a, T>, Failure> {
    let bytes: &'a [u8] = input_bytes(pointer.cast(), count, size_of::<T>(), name)?;
    Ok(bytes.chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned))
}

/// Copies the elements of [`input_items`].
pub(crate) fn copy_input_items<T: bytemuck::AnyBitPattern>(
    pointer: *const T,
    count: usize,
    name: &'static str,
) -> Result<Vec<T>, Failure> {
    Ok(gusset_base::alloc::collect(input_items(pointer, count, name)?)?)
}

/// Reads a flag, 0 or 1.
pub(crate) fn read_flag(value: u32, name: &'static str) -> Result<bool, Failure> {
    match value {
        0 | 1 => Ok(value == 1),
        other => Err(Failure::unknown_value(name, other.into(), "0 or 1")),
    }
}

/// An enum of the core whose variants are constants in C; `c_enum` implements it.
pub(crate) trait Choice: Sized {
    /// The field or parameter that takes the constants.
    const NAME: &'static str;

    /// The names of the constants.
    const CONSTANTS: &'static [&'static str];

    /// Returns the variant of a constant.
    fn from_constant(value: u32) -> Option<Self>;

    /// Returns the constant of a variant.
    fn number(self) -> u32;
}

/// Converts a constant to a variant.
pub(crate) fn read_choice<T: Choice>(value: u32) -> Result<T, Failure> {
    T::from_constant(value).ok_or_else(|| Failure::unknown_choice(T::NAME, value, T::CONSTANTS))
}

/// Returns the pointer to lend for a list: its first element, or NULL if it is empty.
pub(crate) fn lend_list<T>(list: &[T]) -> *const T {
    if list.is_empty() { ptr::null() } else { list.as_ptr() }
}

/// Fills the caller's buffer of `capacity` elements with the `needed` elements that `make` returns.
/// Without a buffer, it only returns their number. If memory runs out, nothing is written, and
/// `written` stays unchanged.
pub(crate) fn fill_buffer<T: bytemuck::Pod, I: IntoIterator<Item = T>>(
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
        let message = format!("{name} has room for {capacity} elements; it needs room for {needed}");
        return Err(Failure { value: needed as f64, ..Failure::new(GUSSET_ERROR_BUFFER_TOO_SMALL, message) });
    }
    let (out, made) = (result_buffer(buffer, needed, name)?, make()?);
    job.finish()?;
    out.iter_mut().zip(made).for_each(|(to, from)| *to = from);
    *written = needed;
    Ok(())
}

/// [`fill_buffer`] with a copy of the library's data.
pub(crate) fn copy_to_buffer<T: bytemuck::Pod>(
    buffer: (*mut T, usize, &'static str),
    from: &[T],
    written: &mut usize,
    job: &Job<'_>,
) -> Result<(), Failure> {
    fill_buffer(buffer, from.len(), written, job, || Ok(from.iter().copied()))
}

/// A struct of plain numbers and pointers that begins with `size_t struct_size`.
///
/// # Safety
/// The struct is `repr(C)`, its first field is the size, and all bytes zero are a valid value.
pub(crate) unsafe trait VersionedStruct: Copy {
    /// The size of the first published version.
    const MIN_SIZE: usize;

    /// Returns the field `reserved`, if the struct has one and is read.
    fn reserved(&self) -> u32 {
        0
    }
}

/// Reads the struct up to the size of the caller's version; missing fields are 0. NULL gives all
/// zeros if `optional`. Bytes beyond this version, and `reserved`, must be 0.
pub(crate) fn read_versioned_struct<T: VersionedStruct>(
    pointer: *const T,
    optional: bool,
    name: &'static str,
) -> Result<T, Failure> {
    // SAFETY: zeros are valid, by the trait.
    let mut value: T = unsafe { MaybeUninit::zeroed().assume_init() };
    if optional && pointer.is_null() {
        return Ok(value);
    }
    let size = struct_size(pointer, name)?;
    let known = size_of::<T>().min(size);
    // SAFETY: aligned and not NULL; the caller promises `size` readable bytes. A prefix copied over
    // zeros is a valid value of plain fields.
    unsafe { ptr::copy_nonoverlapping(pointer.cast::<u8>(), (&raw mut value).cast(), known) };
    let tail = input_bytes(pointer.wrapping_byte_add(known).cast(), size - known, 1, name)?;
    check_unknown_fields(tail, value.reserved(), name)?;
    Ok(value)
}

/// Fails if the host sets `reserved` or fields beyond this version.
fn check_unknown_fields(tail: &[u8], reserved: u32, name: &'static str) -> Result<(), Failure> {
    match tail.iter().find(|&&byte| byte != 0) {
        Some(&byte) => Err(Failure::not_zero(format_args!("a field of {name} beyond this version"), byte.into())),
        None if reserved != 0 => Err(Failure::not_zero(format_args!("{name}.reserved"), reserved.into())),
        None => Ok(()),
    }
}

/// Reads options within other options, which `checked` converts; NULL means the defaults. A failure
/// names the field by its path.
pub(crate) fn read_nested_or_default<T: VersionedStruct, U>(
    pointer: *const T,
    name: &'static str,
    checked: impl FnOnce(T) -> Result<U, Failure>,
) -> Result<U, Failure> {
    checked(read_versioned_struct(pointer, true, name)?).map_err(|failure| failure.with_field(name))
}

/// Returns pointers to the structs of an array. All must have the size of the first one. A failure
/// has the index of its struct.
pub(crate) fn struct_pointers<T: VersionedStruct>(
    first: *const T,
    count: usize,
    name: &'static str,
) -> Result<impl ExactSizeIterator<Item = Result<*const T, Failure>>, Failure> {
    let size = if count == 0 { 0 } else { struct_size(first, name)? };
    input_bytes(first.cast(), count, size, name)?;
    Ok((0..count).map(move |k| {
        let one = first.wrapping_byte_add(k * size);
        let found = struct_size(one, name).map_err(|failure| failure.with_item(name, k))?;
        if found == size {
            Ok(one)
        } else {
            let message = format!("{name}[{k}] has struct_size {found}; it must be {size}, as in {name}[0]");
            Err(Failure { value: found as f64, ..Failure::new(GUSSET_ERROR_BAD_STRUCT_SIZE, message) }
                .with_item(name, k))
        }
    }))
}

/// Clears the caller's struct except its size, and returns the writer.
pub(crate) fn output_struct<T: VersionedStruct>(
    pointer: *mut T,
    name: &'static str,
) -> Result<OutputStruct<T>, Failure> {
    let size = struct_size(pointer, name)?;
    let field = size_of::<usize>();
    // SAFETY: aligned and not NULL; the caller promises `size` writable bytes.
    unsafe { pointer.cast::<u8>().add(field).write_bytes(0, size - field) };
    Ok(OutputStruct { pointer, size })
}

/// A struct of the caller that the call will fill.
pub(crate) struct OutputStruct<T> {
    pointer: *mut T,
    size: usize,
}

impl<T: VersionedStruct> OutputStruct<T> {
    /// Writes the fields that the caller's version has; its struct_size stays.
    pub(crate) fn write_known_fields(self, value: T) {
        let (field, end) = (size_of::<usize>(), self.size.min(size_of::<T>()));
        // SAFETY: as in output_struct; `value` is at least `end` bytes long.
        unsafe {
            let from = (&raw const value).cast::<u8>().add(field);
            ptr::copy_nonoverlapping(from, self.pointer.cast::<u8>().add(field), end - field);
        }
    }
}

/// Returns the size that the caller's struct declares.
fn struct_size<T: VersionedStruct>(pointer: *const T, name: &'static str) -> Result<usize, Failure> {
    check_aligned(pointer, name)?;
    // SAFETY: aligned and not NULL, and every version begins with the size.
    let size = unsafe { pointer.cast::<usize>().read() };
    check_struct_size(T::MIN_SIZE, size_of::<T>(), size, name)
}

/// Fails if `size` is smaller than the first version, larger than any, or not a size of a struct.
///
/// The size of a struct is a multiple of the size of its first field. Numbers and pointers are not
/// larger and lie at multiples of their sizes. A valid size therefore ends between two of them, so
/// that each is read or written as a whole or not at all.
fn check_struct_size(min: usize, known_size: usize, size: usize, name: &'static str) -> Result<usize, Failure> {
    const STEP: usize = size_of::<usize>();
    if size < min || size > 4096 || !size.is_multiple_of(STEP) {
        let message = format!(
            "{name} has struct_size {size}; it must be a multiple of {STEP} from {min} to 4096, and {known_size} in \
             this version"
        );
        return Err(Failure { value: size as f64, ..Failure::new(GUSSET_ERROR_BAD_STRUCT_SIZE, message) });
    }
    Ok(size)
}

/// Returns the product of two counts; `what` names the buffer in the error.
pub(crate) fn checked_product(count: usize, each: usize, what: &'static str) -> Result<usize, Failure> {
    let product = count.checked_mul(each);
    product
        .ok_or_else(|| Failure::from(Error::SizeOverflow { what, count: (count as u64).saturating_mul(each as u64) }))
}

#[cfg(test)]
mod tests {
    use super::{VersionedStruct, output_struct, read_versioned_struct};
    use std::ptr;

    /// A struct whose second version added two numbers and a pointer.
    #[repr(C)]
    #[derive(Clone, Copy)]
    struct Grown {
        struct_size: usize,
        first: u64,
        low: u32,
        high: u32,
        pointer: *const u8,
    }

    // SAFETY: repr(C), plain numbers and a pointer, with the size first.
    unsafe impl VersionedStruct for Grown {
        const MIN_SIZE: usize = 16;
    }

    /// Every bit is 1, except in the size.
    fn full(struct_size: usize) -> [Grown; 2] {
        let pointer = ptr::without_provenance(usize::MAX);
        [Grown { struct_size, first: u64::MAX, low: u32::MAX, high: u32::MAX, pointer }; 2]
    }

    #[test]
    fn a_size_inside_a_field_is_refused_by_readers_and_writers() {
        for size in 0..=size_of::<Grown>() {
            let mut given = full(size);
            let read = read_versioned_struct(&raw const given[0], false, "grown");
            let written = output_struct(&raw mut given[0], "grown");
            assert_eq!(read.is_ok(), [16, 24, 32].contains(&size), "{size}");
            assert_eq!(written.is_ok(), read.is_ok(), "{size}");
            let (Ok(read), Ok(written)) = (read, written) else { continue };
            assert_eq!([read.low, read.high], if size > 16 { [u32::MAX; 2] } else { [0; 2] });
            assert_eq!(read.pointer.addr(), if size > 24 { usize::MAX } else { 0 });
            written.write_known_fields(full(0)[0]);
            assert_eq!(given[0].struct_size, size);
            assert_eq!(given[0].pointer.addr(), usize::MAX, "beyond the struct, or written as a whole");
        }
    }

    #[test]
    fn a_size_beyond_this_version_is_a_multiple_too() {
        for size in 33..=64 {
            let mut given = full(size);
            // SAFETY: the bytes beyond this version are within the array.
            unsafe { (&raw mut given[0]).add(1).write_bytes(0, 1) };
            let read = read_versioned_struct(&raw const given[0], false, "grown");
            assert_eq!(read.is_ok(), size % 8 == 0, "{size}");
        }
    }
}
