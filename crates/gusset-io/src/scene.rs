//! The scene as one mesh, for formats that hold one, and what such formats lose.

use crate::document::Document;
use crate::error::{Loss, WriteError, WriteErrorKind};
use crate::material::NO_MATERIAL;
use crate::mesh::{Domain, Mesh};
use std::borrow::Cow;

/// Joins all placed meshes into one. Borrows the mesh if the scene is one mesh in its own coordinates.
pub(crate) fn scene_mesh(document: &Document) -> Result<Cow<'_, Mesh>, WriteError> {
    document.joined()
}

/// Attributes of meshes that a format may hold.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Attribute {
    VertexColours,
    FaceColours,
    Normals,
    Texcoords,
    Materials,
}

/// Lists the attributes of a mesh, and what the document has beside it, that files of a format (`STL`) do not hold.
pub(crate) fn list_lost_content(document: &Document, mesh: &Mesh, files: &str, held: &[Attribute]) -> Vec<Loss> {
    let has_materials = mesh.face_materials.iter().any(|&material| material != NO_MATERIAL);
    let mut lost: Vec<String> = [
        (Attribute::VertexColours, !mesh.vertex_colours.is_empty(), "colours of vertices"),
        (Attribute::FaceColours, !mesh.face_colours.is_empty(), "colours of faces"),
        (Attribute::Normals, !mesh.normals.is_absent(), "normals"),
        (Attribute::Texcoords, !mesh.texcoords.is_absent(), "texture coordinates"),
        (Attribute::Materials, has_materials, "materials"),
    ]
    .iter()
    .filter(|(attribute, is_present, _)| *is_present && !held.contains(attribute))
    .map(|(_, _, name)| (*name).to_string())
    .collect();
    lost.extend(mesh.properties.iter().map(|property| {
        format!("{} of {}", property.name, if property.domain == Domain::Faces { "faces" } else { "vertices" })
    }));
    let has_names = document.placements.iter().any(|placement| !placement.name.is_empty());
    lost.extend(
        [
            (!document.curves.closed.is_empty(), "curves"),
            (!document.points.positions.is_empty(), "points beside a mesh"),
            (document.placements.len() > 1 && has_names, "names of objects"),
        ]
        .iter()
        .filter(|(is_present, _)| *is_present)
        .map(|(_, name)| (*name).to_string()),
    );
    lost.into_iter().map(|name| Loss(format!("{name}, which {files} files do not hold"))).collect()
}

/// Returns whether the points equal the points of the curves, as readers of tables give them: a closed curve repeats its first point.
pub(crate) fn are_points_of_curves(document: &Document) -> bool {
    let repeated = document.curves.closed.iter().filter(|&&closed| closed).count();
    document.curves.positions.len() + repeated == document.points.positions.len()
}

/// Lists what files that hold curves alone lose. Refuses a document without curves.
pub(crate) fn list_lost_beside_curves(document: &Document, files: &str) -> Result<Vec<Loss>, WriteError> {
    let has_meshes = document.meshes.iter().any(|mesh| !mesh.positions.is_empty());
    let has_points = !document.points.positions.is_empty() && !are_points_of_curves(document);
    if document.curves.closed.is_empty() && (has_meshes || has_points) {
        let message = format!("{files} files are written from curves, and there are none");
        return Err(WriteError::new(WriteErrorKind::Unsupported, message));
    }
    let lost = [(has_meshes, "meshes"), (has_points, "points")];
    Ok(lost
        .iter()
        .filter(|(is, _)| *is)
        .map(|(_, name)| Loss(format!("{name}, which {files} files do not hold")))
        .collect())
}

/// Returns the nearest of the 256 steps of a colour's part.
pub(crate) fn colour_step(part: f32) -> u8 {
    (part * 255.0).round() as u8
}

/// Returns whether formats whose colours have 256 steps round some colour.
pub(crate) fn has_shades_between_steps(colours: &[[f32; 4]]) -> bool {
    colours.iter().flatten().any(|&part| f32::from(colour_step(part)) / 255.0 != part)
}

/// Writes `1 face` or `2 faces`.
pub(crate) fn counted(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}
