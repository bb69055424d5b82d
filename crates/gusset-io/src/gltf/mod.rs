//! glTF 2.0, as text (`.gltf`) and in one binary file (`.glb`).
//!
//! Specification: Khronos, glTF 2.0 (ISO/IEC 12113:2022), with the extensions `KHR_mesh_quantization`, `EXT_meshopt_compression`,
//! `KHR_meshopt_compression`, `EXT_mesh_gpu_instancing` and `FB_ngon_encoding`. Extensions of materials and textures stay in the
//! materials' own JSON. Files that require Draco are refused, and the message names a converter.
//!
//! The reader reads the default scene: triangles as meshes, lines as curves, points as a point cloud. The matrices of nodes stay in
//! double precision. Vertices at equal positions of a mesh get a common representative, because glTF splits vertices at seams. It
//! notes skins, animations, cameras, morph targets and further attributes, which it leaves out.
//!
//! Beyond the specification, the reader accepts:
//! - a byte order mark, commas before closing brackets, and text after the JSON object;
//! - wrong lengths in the header, and accessors that exceed their view but not the buffer;
//! - any type of number for any attribute, and quaternions of any length;
//! - scenes that list a node twice or list nodes below others;
//! - files without scenes or without a version.
//!
//! A node with two parents is an error, since a chain of such nodes can double a scene many times.
//!
//! The writer embeds images and the buffer, so that the file needs no others. It splits vertices only where corners differ. The
//! attribute `_VERTEX` tells from which vertex each one was split, and the reader joins them again. Polygons are fans by `FB_ngon_encoding`; those
//! that no fan covers are listed in `extras`. If single precision would move points that are far from the origin, the node's
//! translation holds the distance.
//!
//! Cost: linear time, without recursion. A JSON value takes 12 bytes; a [budget](crate::budget) limits everything else.

mod base64;
mod glb_container;
mod gltf_accessors;
mod gltf_binary;
mod gltf_buffers;
mod gltf_colour;
mod gltf_faces_read;
mod gltf_faces_write;
mod gltf_materials_read;
mod gltf_materials_write;
mod gltf_matrix;
mod gltf_mesh;
mod gltf_mesh_write;
mod gltf_notes;
mod gltf_scene;
mod gltf_split;
mod gltf_strands;
mod gltf_unite;
mod meshopt;
mod meshopt_filters;
mod read_gltf;
mod write_gltf;

pub(crate) use read_gltf::read_gltf;
pub(crate) use write_gltf::{write_glb, write_gltf};

#[cfg(test)]
mod gltf_hostile_tests;
#[cfg(test)]
mod gltf_test_files;
#[cfg(test)]
mod gltf_tests;
#[cfg(test)]
mod gltf_write_tests;
#[cfg(test)]
mod meshopt_tests;
