//! Files of meshes, curves and points.
//!
//! [`read`] makes a [`Document`] from the bytes of a file, and [`write()`] makes a file from a document. Both work in memory.
//! [`read_file`] and [`write_file`] work on paths: they open regular files only, follow no name out of the file's folder, and replace
//! a file only once the new one is complete.
//!
//! Readers accept what is clear although it breaks a format's rules, and say so in a [`Note`]. They refuse what is not clear, and name
//! the line or element. Each reader takes time linear in the file, and at most
//! [`MAX_MEMORY_PER_FILE_BYTE`] bytes of memory for each of its bytes.
//!
//! One folder holds one format. `document`, `mesh` and `material` are the model that all formats share; `text` reads and writes numbers and
//! words; `polygons` splits polygons into triangles; `precision` tells what single precision would move; `scene` joins meshes for formats
//! that hold one; `vertex_merging` finds equal positions, and `parallel_merging` does so for many triangles by several threads. `files`
//! reads and writes paths, `folder` finds the files that a file refers to, and `pending_file` replaces a file whole.

mod budget;
mod colour_steps;
mod dispatch;
mod document;
mod error;
#[cfg(not(target_family = "wasm"))]
mod files;
#[cfg(not(target_family = "wasm"))]
mod folder;
mod foreign_files;
mod format;
mod json_tape;
mod json_text;
mod material;
mod memory_file;
mod merging;
mod mesh;
mod options;
pub mod packed;
#[cfg(not(target_family = "wasm"))]
mod pending_file;
mod outline_pen;
mod parallel_fill;
mod parallel_merging;
mod polygons;
mod precision;
mod recent_points;
#[cfg(not(target_family = "wasm"))]
mod regular_file;
mod repeated_points;
mod row_blocks;
mod resources;
mod scene;
mod text;
mod validity;
mod text_encoding;
mod vertex_merging;

#[cfg(test)]
mod document_checks;
#[cfg(test)]
mod document_tests;
#[cfg(test)]
mod files_tests;
#[cfg(test)]
mod polygons_tests;
#[cfg(test)]
mod test_measures;
#[cfg(test)]
mod text_tests;

mod dxf;
mod gltf;
mod obj;
mod off;
mod ply;
mod points;
mod scan_list;
mod stl;
mod svg;
mod three_mf;

pub use dispatch::{read, write};
pub use document::{Curves, Document, Placement, PointCloud};
pub use error::{Loss, Note, Place, ReadError, ReadErrorKind, WriteError, WriteErrorKind, printable};
#[cfg(not(target_family = "wasm"))]
pub use files::{read_file, write_file};
pub use format::{Content, Format};
pub use material::{Image, ImageData, Material, NO_MATERIAL, NativeMaterial};
pub use memory_file::MemoryFile;
pub use mesh::{Domain, Mesh, NumberKind, Positions, Property, Values};
pub use options::{ReadOptions, WriteOptions};
pub use resources::{NoResources, Output, Resources, Target};

/// Largest memory in bytes that a reader takes for each byte of the file and of the files that it refers to. Every file may take at
/// least 16 MiB.
pub const MAX_MEMORY_PER_FILE_BYTE: u64 = 32;
