//! Content of a model part: objects, groups of properties, and items to build.

use crate::mesh::Mesh;
use std::collections::BTreeMap;

/// Rows of a 3 x 4 matrix.
pub(super) type Matrix = [[f64; 4]; 3];

/// Part of the package, and number of a resource in it.
pub(super) type ResourceId = (u32, u32);

/// An object in another one, or in the scene.
pub(super) struct Component {
    pub(super) object: ResourceId,
    pub(super) transform: Matrix,
}

#[derive(Default)]
pub(super) struct Object {
    pub(super) id: ResourceId,
    pub(super) name: String,
    pub(super) mesh: Option<Box<Mesh>>,
    pub(super) components: Vec<Component>,
    /// Whether the object supports others during a print.
    pub(super) is_support: bool,
    /// Group and entry of triangles without properties of their own.
    pub(super) property: Option<(u32, u32)>,
}

/// Properties to which triangles refer by group and entry.
pub(super) enum Group {
    /// Materials; the first one's index in the document, and their number.
    Materials { first: u32, count: u32 },
    /// sRGB and opacity.
    Colours(Vec<[f32; 4]>),
    /// Texture coordinates, and the material that shows the image.
    Texcoords { pairs: Vec<[f64; 2]>, material: u32 },
    /// Mixtures and combinations, which are not read.
    Other,
}

/// Content of all model parts.
#[derive(Default)]
pub(super) struct Model {
    pub(super) objects: BTreeMap<ResourceId, Object>,
    pub(super) groups: BTreeMap<ResourceId, Group>,
    /// Materials of images by the numbers of the images.
    pub(super) texture_materials: BTreeMap<ResourceId, u32>,
    pub(super) items: Vec<Component>,
    /// Metres for each unit of length.
    pub(super) metres_per_unit: Option<f64>,
    /// Names of parts, the main one first.
    pub(super) parts: Vec<String>,
    /// Indices of parts by their names in the package.
    pub(super) known_parts: BTreeMap<String, u32>,
    /// Images of the document by their names in the package.
    pub(super) images: BTreeMap<String, u32>,
}
