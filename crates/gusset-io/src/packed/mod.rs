//! Documents as one JSON text and one array of bytes, for hosts in other languages.
//!
//! The text has the members of [`Document`](crate::Document) by their names. An array in it is `{"at", "count", "type", "width"}`: `count`
//! elements of `width` numbers of a type from byte `at` on, little-endian, aligned to 8 bytes. Types are `u8`, `u32`, `f32` and `f64`.
//! An attribute is `{"at_corners", "values"}`. Absent arrays and attributes are `null`.

mod pack_document;
mod unpack_document;

pub use pack_document::pack;
pub use unpack_document::unpack;

#[cfg(test)]
mod packed_tests;

/// A document as text and bytes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Packed {
    /// JSON that describes the document and its arrays.
    pub description: String,
    /// All arrays.
    pub arrays: Vec<u8>,
}
