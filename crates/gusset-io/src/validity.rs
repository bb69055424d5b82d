//! Rules that each document keeps.

use crate::document::Document;
use crate::error::{Place, ReadError};
use crate::material::{NO_MATERIAL, NativeMaterial};
use crate::mesh::{Domain, Mesh, Values};

impl Document {
    /// Checks that all indices exist and all lengths agree. Readers return documents that pass. O(size of the document).
    ///
    /// # Errors
    /// `Malformed`, with the mesh, the element and its value.
    pub fn check(&self) -> Result<(), ReadError> {
        for (index, mesh) in self.meshes.iter().enumerate() {
            check_mesh(mesh, self.materials.len()).map_err(|message| wrong(&format!("mesh {index}: {message}")))?;
        }
        for (index, placement) in self.placements.iter().enumerate() {
            check_index(placement.mesh, self.meshes.len(), "mesh")
                .map_err(|message| wrong(&format!("placement {index}: {message}")))?;
        }
        let curves = &self.curves;
        check_offsets(&curves.offsets, curves.closed.len(), curves.positions.len())
            .map_err(|message| wrong(&format!("curves: {message}")))?;
        let points = self.points.positions.len();
        check_length(self.points.normals.len(), points, "normals of points").map_err(|message| wrong(&message))?;
        check_length(self.points.colours.len(), points, "colours of points").map_err(|message| wrong(&message))?;
        for (index, material) in self.materials.iter().enumerate() {
            let mut images = material.image.into_iter().collect::<Vec<_>>();
            if let Some(NativeMaterial::Gltf { textures, .. }) = &material.native {
                images.extend(textures.iter().filter_map(|(_, image)| *image));
            }
            for image in images {
                check_index(image, self.images.len(), "image")
                    .map_err(|message| wrong(&format!("material {index}: {message}")))?;
            }
        }
        Ok(())
    }
}

fn wrong(message: &str) -> ReadError {
    ReadError::malformed(Place::Whole, message)
}

fn check_index(index: u32, count: usize, noun: &str) -> Result<(), String> {
    if (index as usize) < count { Ok(()) } else { Err(format!("{noun} {index} does not exist (there are {count})")) }
}

/// Accepts an absent list, which is empty.
fn check_length(length: usize, count: usize, name: &str) -> Result<(), String> {
    if length == 0 || length == count {
        Ok(())
    } else {
        Err(format!("{name} have {length} entries instead of {count}"))
    }
}

fn check_offsets(offsets: &[u32], count: usize, end: usize) -> Result<(), String> {
    if offsets.len() != count + 1 {
        return Err(format!("{} offsets instead of {}", offsets.len(), count + 1));
    }
    if offsets[0] != 0 || offsets[count] as usize != end {
        return Err(format!("offsets go from {} to {} instead of 0 to {end}", offsets[0], offsets[count]));
    }
    match offsets.windows(2).position(|pair| pair[0] > pair[1]) {
        Some(place) => Err(format!("offset {} is less than the previous one; offsets must not decrease", place + 1)),
        None => Ok(()),
    }
}

fn check_mesh(mesh: &Mesh, material_count: usize) -> Result<(), String> {
    const MIN_CORNERS: u32 = 3;
    let (vertices, faces) = (mesh.positions.len(), mesh.face_offsets.len().saturating_sub(1));
    check_offsets(&mesh.face_offsets, faces, mesh.corners.len())?;
    if let Some(face) = mesh.face_offsets.windows(2).position(|pair| pair[1] - pair[0] < MIN_CORNERS) {
        return Err(format!("face {face} has {} corners; it needs at least three", mesh.face(face).len()));
    }
    // A pass without a branch finds out first whether there is anything to find.
    let largest = mesh.corners.iter().fold(0, |largest, &vertex| vertex.max(largest));
    if largest as usize >= vertices
        && let Some(corner) = mesh.corners.iter().position(|&vertex| vertex as usize >= vertices)
    {
        let face = mesh.face_offsets.partition_point(|&first| first as usize <= corner) - 1;
        let (place, vertex) = (corner - mesh.face_offsets[face] as usize, mesh.corners[corner]);
        return Err(format!("face {face}, corner {place}: vertex {vertex} does not exist (the mesh has {vertices})"));
    }
    check_length(mesh.merge.len(), vertices, "merge")?;
    for (vertex, &representative) in mesh.merge.iter().enumerate() {
        check_index(representative, vertices, "representative")?;
        if mesh.merge[representative as usize] != representative {
            return Err(format!(
                "vertex {vertex}: the representative {representative} does not represent itself; name a vertex that stays"
            ));
        }
    }
    check_values(&mesh.normals, mesh, "normals")?;
    check_values(&mesh.texcoords, mesh, "texture coordinates")?;
    check_length(mesh.vertex_colours.len(), vertices, "colours of vertices")?;
    check_length(mesh.face_colours.len(), faces, "colours of faces")?;
    check_length(mesh.face_materials.len(), faces, "materials of faces")?;
    for &material in mesh.face_materials.iter().filter(|&&material| material != NO_MATERIAL) {
        check_index(material, material_count, "material")?;
    }
    for property in &mesh.properties {
        let count = if property.domain == Domain::Faces { faces } else { vertices };
        if property.values.len() != count {
            return Err(format!("property {} has {} values instead of {count}", property.name, property.values.len()));
        }
    }
    Ok(())
}

fn check_values<const N: usize>(values: &Values<N>, mesh: &Mesh, name: &str) -> Result<(), String> {
    let (length, count) = match values {
        Values::Absent => return Ok(()),
        Values::Vertices(values) => (values.len(), mesh.positions.len()),
        Values::Corners(values) => (values.len(), mesh.corners.len()),
    };
    if length == count { Ok(()) } else { Err(format!("{name} have {length} entries instead of {count}")) }
}
