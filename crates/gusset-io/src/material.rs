//! Materials and images of faces.

use std::sync::Arc;

/// The entry of a face without a material.
pub const NO_MATERIAL: u32 = u32::MAX;

/// Bytes of an image, or where they are.
#[derive(Clone, Debug, PartialEq)]
pub enum ImageData {
    /// A file, relative to the folder of the document's file.
    File(String),
    /// The encoded bytes.
    Bytes(Arc<Vec<u8>>),
}

/// An image that materials refer to.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Name; may be empty.
    pub name: String,
    /// `image/png`, `image/jpeg`, or empty if unknown.
    pub media_type: String,
    /// The image.
    pub data: ImageData,
}

/// A material in the words of its format, so that a file of this format gets back what it gave.
#[derive(Clone, Debug, PartialEq)]
pub enum NativeMaterial {
    /// Lines of an MTL library after `newmtl`. File names in them are relative to the folder of the document's file.
    Mtl(Vec<String>),
    /// A glTF material as JSON text. Texture indices in it are indices into `textures`.
    Gltf {
        /// The material object.
        material: Arc<String>,
        /// For each texture that the material uses: the sampler object as JSON text (may be empty), and the document's image.
        textures: Arc<Vec<(String, Option<u32>)>>,
    },
}

/// A material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name; may be empty.
    pub name: String,
    /// Base colour, sRGB and opacity, 0 to 1.
    pub colour: [f32; 4],
    /// Image of the base colour, an index into the document's images.
    pub image: Option<u32>,
    /// Everything that the format says.
    pub native: Option<NativeMaterial>,
}

impl Default for Material {
    fn default() -> Self {
        Self { name: String::new(), colour: [1.0; 4], image: None, native: None }
    }
}
