//! Inputs as they come from files: a mesh with the materials that it refers to.

use crate::failure::{Exit, Failure};
use gusset_io::{
    Document, Image, Material, Mesh, NO_MATERIAL, Placement, ReadError, ReadErrorKind, Values, WriteError,
    WriteErrorKind,
};

/// A mesh from a file.
#[derive(Clone, Debug, Default)]
pub(crate) struct Piece {
    /// Path of the file, for messages.
    pub(crate) path: String,
    pub(crate) mesh: Mesh,
    pub(crate) materials: Vec<Material>,
    pub(crate) images: Vec<Image>,
    /// Deviations from the format that the reader accepted, and content that it left out.
    pub(crate) notes: Vec<String>,
    /// Metres for each unit of length, if the file says so.
    pub(crate) metres_per_unit: Option<f64>,
}

/// Number of points and corners that the meshes of any scene may have in all their copies.
const MIN_SCENE_ELEMENTS: u64 = 1 << 22;

impl Piece {
    /// Joins a document's meshes into one piece. Copies of meshes are limited by the size of the file in bytes.
    pub(crate) fn from_document(document: Document, path: &str, size: u64) -> Result<Self, Failure> {
        let Document { mut meshes, materials, images, metres_per_unit, notes, .. } =
            document.into_joined(size.max(MIN_SCENE_ELEMENTS)).map_err(|error| read_failure(path, &error))?;
        let mesh = meshes.pop().unwrap_or_default();
        let notes = notes.into_iter().map(|note| note.text).collect();
        Ok(Self { path: path.to_owned(), mesh, materials, images, notes, metres_per_unit })
    }

    /// Makes a piece of each placed mesh of a document, in the coordinates of the scene. Each piece is named for its placement.
    pub(crate) fn from_placements(document: Document, path: &str, size: u64) -> Result<Vec<Self>, Failure> {
        let Document { meshes, placements, materials, images, metres_per_unit, mut notes, .. } = document;
        let of_placement = |placement: Placement| {
            let document = Document {
                meshes: vec![meshes[placement.mesh as usize].clone()],
                materials: materials.clone(),
                images: images.clone(),
                metres_per_unit,
                // Notes are about the whole file.
                notes: std::mem::take(&mut notes),
                placements: vec![Placement { mesh: 0, ..placement.clone() }],
                ..Document::default()
            };
            Self::from_document(document, &format!("{path}: {}", placement.name), size)
        };
        placements.into_iter().map(of_placement).collect()
    }

    /// Makes a document for a writer.
    pub(crate) fn into_document(self) -> Document {
        Document {
            materials: self.materials,
            images: self.images,
            metres_per_unit: self.metres_per_unit,
            ..Document::from_mesh(self.mesh)
        }
    }
}

/// Makes a failure of a reader's error.
pub(crate) fn read_failure(path: &str, error: &ReadError) -> Failure {
    let exit = if error.kind == ReadErrorKind::OutOfMemory { Exit::Memory } else { Exit::File };
    let separator = if matches!(error.place, gusset_io::Place::Line(_)) { ":" } else { ": " };
    Failure::new(exit, format!("{path}{separator}{error}"))
}

/// Makes a failure of a writer's error.
pub(crate) fn write_failure(path: &str, error: &WriteError) -> Failure {
    let exit = if error.kind == WriteErrorKind::OutOfMemory { Exit::Memory } else { Exit::File };
    let remedy = if error.kind == WriteErrorKind::Lossy { "; --lossy permits it" } else { "" };
    Failure::new(exit, format!("{path}: {error}{remedy}"))
}

/// Names what a mesh carries besides positions and faces.
pub(crate) fn attribute_names(mesh: &Mesh) -> Vec<String> {
    fn named<const N: usize>(values: &Values<N>, what: &str) -> Option<String> {
        match values {
            Values::Absent => None,
            Values::Vertices(_) => Some(format!("{what} of vertices")),
            Values::Corners(_) => Some(format!("{what} of corners")),
        }
    }
    let mut names = Vec::new();
    names.extend((!mesh.vertex_colours.is_empty()).then(|| "colours of vertices".to_owned()));
    names.extend((!mesh.face_colours.is_empty()).then(|| "colours of faces".to_owned()));
    names.extend(named(&mesh.normals, "normals"));
    names.extend(named(&mesh.texcoords, "texture coordinates"));
    let has_materials = mesh.face_materials.iter().any(|&material| material != NO_MATERIAL);
    names.extend(has_materials.then(|| "materials".to_owned()));
    for property in &mesh.properties {
        let elements = if property.domain == gusset_io::Domain::Faces { "faces" } else { "vertices" };
        names.push(format!("{} of {elements}", property.name));
    }
    names
}
