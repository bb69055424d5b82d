//! OFF, Geomview's Object File Format: polygons with normals, colours and texture coordinates of vertices, and colours of faces.
//!
//! The source is the chapter "OFF Files" of the Geomview manual. Letters before `OFF` tell what follows a vertex's position. Geomview's
//! order is normal, colour, texture coordinates. MeshLab writes `NCOFF` with the colour first; the numbers tell the two apart.
//! Positions are read in double precision.
//!
//! The reader also accepts:
//! - Counts in the line of `OFF`, with or without a blank between, and files without the word.
//! - Comments (`#`) anywhere, no count of edges, and numbers behind a vertex or face that mean nothing.
//! - Colours in 256 steps or from 0 to 1, with or without opacity: steps if one exceeds 1.
//! - Binary files (`OFF BINARY`), and homogeneous coordinates (`4OFF`). Other dimensions are refused.
//!
//! A file without faces holds points. Reading takes time linear in the file, and memory of some 60 bytes for each line.

mod off_document;
mod off_header;
#[cfg(test)]
mod off_tests;
mod off_values;
mod read_binary_off;
mod read_off;
mod write_off;

pub(crate) use read_off::read_off;
pub(crate) use write_off::write_off;
