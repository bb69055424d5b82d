//! Polygon File Format, also called Stanford triangle format: Greg Turk, "The PLY Polygon File Format", 1994.
//!
//! Reads text and binary files of either byte order. Accepts beyond the description: any order and repetition of elements; properties
//! and keywords in capitals; 64-bit integers; lists of any type for indices; colours as bytes, 16-bit numbers or parts of 1; texture
//! coordinates at vertices, or at corners in MeshLab's manner (list `texcoord`, `texnumber`, `comment TextureFile`); triangle strips
//! (element `tristrips`); range images (element `range_grid`), whose neighbours are joined by triangles. All other single numbers of
//! vertices and faces become properties. A file without faces is a cloud of points.
//!
//! Reading takes time linear in the file: elements without properties cost nothing whatever their count is. The largest memory is 25
//! times the file, for lists of bytes with missing texture coordinates.
//!
//! Writes binary files with the least significant byte first, or text. Positions, normals and texture coordinates have single
//! precision if that changes none of them, and double precision otherwise.

mod ply_colours;
mod ply_columns;
mod ply_faces;
mod ply_header;
mod ply_layout;
mod ply_rows;
mod ply_vertices;
mod range_grid;
mod read_ply;
mod room;
mod row_writer;
mod write_ply;

#[cfg(test)]
mod ply_hostile_tests;
#[cfg(test)]
mod ply_tests;

pub(crate) use read_ply::read_ply;
pub(crate) use write_ply::write_ply;
