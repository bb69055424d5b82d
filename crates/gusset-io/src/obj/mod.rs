//! Wavefront OBJ and its material library, MTL.
//!
//! Source: Wavefront Advanced Visualizer, appendix B (OBJ) and the MTL specification, both of 1995.
//!
//! Read: `v` with colours, `vt`, `vn`, `f`, `l`, `p`, `o`, `usemtl` and `mtllib`. Each object becomes a mesh if the faces of each use the
//! vertices behind its `o` alone. Otherwise the whole file is one mesh, so that objects which share vertices stay connected. A file of
//! `v` lines without elements is a cloud of points. Groups, and free-form curves and surfaces, are left out with a note. Smoothing groups
//! and display attributes are left out.
//!
//! Accepted beyond the specification: a byte order mark, statements in capitals, line ends of old Macintosh files, blanks behind the
//! backslash of a continued line, `1//` and `1/2/`, the index 0 or a missing value for normals and texture coordinates, colours from 0 to
//! 255, faces with any number of corners, and the `nan` and `inf` of all C libraries.
//!
//! Cost: one pass over chunks of whole lines in up to 4 threads, then one pass over the corners. The result does not depend on the chunks.

mod mtl_line;
mod obj_assembly;
mod obj_chunk;
mod obj_cursor;
mod obj_materials;
mod obj_objects;
mod obj_values;
mod read_mtl;
mod read_obj;
mod write_mtl;
mod write_obj;
mod write_values;

#[cfg(test)]
mod mtl_tests;
#[cfg(test)]
mod obj_hostile_tests;
#[cfg(test)]
mod obj_objects_tests;
#[cfg(test)]
mod obj_tests;
#[cfg(test)]
mod write_obj_tests;

pub(crate) use mtl_line::with_renamed_file;
pub(crate) use read_obj::read_obj;
pub(crate) use write_obj::write_obj;
