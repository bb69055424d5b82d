//! glTF

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
mod json_tape;
mod json_text;
mod meshopt;
mod meshopt_filters;
mod read_gltf;
mod write_gltf;

pub(crate) use read_gltf::read_gltf;
pub(crate) use write_gltf::{write_glb, write_gltf};

#[cfg(test)]
mod gltf_test_files;
#[cfg(test)]
mod gltf_tests;
#[cfg(test)]
mod meshopt_tests;
#[cfg(test)]
mod gltf_hostile_tests;
#[cfg(test)]
mod gltf_write_tests;
