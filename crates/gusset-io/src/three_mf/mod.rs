//! 3MF, the 3D Manufacturing Format: a ZIP package of XML.
//!
//! Specification: 3MF Consortium, Core 1.3. The module reads these extensions:
//! - Materials and Properties: base materials, groups of colours, textures;
//! - Production: objects in several parts.
//!
//! Beam lattices, slices, displacements, volumes and mixed materials are noted, and metadata is left out. Encrypted content is refused.
//!
//! The reader expands components to placements of meshes. A chain of components can double a scene many times, so that it counts the
//! placements before it makes them. Items and components keep their transforms, and the document tells the unit of length.
//!
//! Beyond the specification, the reader accepts:
//! - capitals in the names of parts, a package without relations, and a main part with another name;
//! - files that build nothing, of which it shows all objects;
//! - triangles with properties that do not exist;
//! - text that is not UTF-8.
//!
//! The writer writes one part: objects, items with transforms, base materials with their colours, and groups of colours. Polygons
//! become triangles. The bytes depend on the document alone.
//!
//! Cost: linear time. Parts are decompressed while they are read. They may expand to 256 times the file's size,
//! and a tag may have 4 megabytes. A [budget](crate::budget) limits what is made of them.

mod mf_attributes;
mod mf_model;
mod mf_package;
mod mf_properties;
mod read_3mf;
mod read_mf_model;
mod write_3mf;

pub(crate) use read_3mf::read_3mf;
pub(crate) use write_3mf::write_3mf;

#[cfg(test)]
mod three_mf_tests;
