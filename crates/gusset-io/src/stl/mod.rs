//! STL, stereolithography files: triangles by the positions of their corners.
//!
//! The source is the "StereoLithography Interface Specification" of 3D Systems (1989). Binary files have a header of 80 bytes, a count,
//! and 50 bytes for each facet in little-endian order. Text files have words. Both repeat positions for each facet, so the reader merges
//! vertices at equal positions, unless [`ReadOptions::merge_repeated`](crate::ReadOptions::merge_repeated) is off. Positions of binary
//! files have single precision, and text files are read in double precision. Normals follow from the corners and are ignored.
//!
//! The reader also accepts:
//! - Binary files whose header begins with `solid`: the size, or what follows the first line, decides.
//! - Binary files with bytes behind the last facet, and with a count below the facets that the file holds.
//! - Colours of facets in their attribute bytes, in the ways of VisCAM and of Materialise Magics.
//! - Text in capitals, with blanks, a byte order mark or comments before `solid`, on one line, with several solids, with loops of more
//!   than three corners, without normals, or without `endsolid`.
//!
//! Reading takes 52 bytes of memory for each binary facet without merging. Merging looks up each corner in a table.

mod read_binary_stl;
mod read_stl;
mod read_text_stl;
mod stl_parts;
#[cfg(test)]
mod stl_tests;
mod write_stl;

pub(crate) use read_stl::read_stl;
pub(crate) use write_stl::write_stl;
