//! Meshes of a file: one for each object if each has vertices of its own, and one for all of them otherwise.

use super::obj_assembly::Content;
use super::obj_chunk::ObjectStart;
use super::obj_values::{drop_missing_values, values_from_indices, values_from_lists};
use crate::document::{Document, Placement};
use crate::error::ReadError;
use crate::mesh::{Mesh, Positions};
use crate::text_encoding::owned_text;
use gusset_base::alloc;
use std::ops::Range;

/// Largest number of objects that become meshes, and the largest number if they have few corners each, so that meshes do not take much
/// more memory than the file.
const MAX_OBJECTS: usize = 1 << 16;
const MAX_SMALL_OBJECTS: usize = 1 << 10;
const MIN_MEAN_CORNERS: usize = 4;

/// Vertices and faces of an object.
struct Block<'a> {
    name: &'a [u8],
    vertices: Range<usize>,
    faces: Range<usize>,
}

/// Returns the parts of a file between its `o` statements, without those that have neither vertices nor faces.
fn blocks<'a, 'b>(content: &'b Content<'a>) -> impl Iterator<Item = Block<'a>> + use<'a, 'b> {
    let end = [content.positions.len(), content.face_offsets.len() - 1];
    let first = ObjectStart { vertex: 0, face: 0, name: &[][..] };
    let starts = std::iter::once(first).chain(content.objects.iter().copied());
    starts.zip(0..).filter_map(move |(start, place): (ObjectStart<'a>, usize)| {
        let [vertex_end, face_end] =
            content.objects.get(place).map_or(end, |next| [next.vertex as usize, next.face as usize]);
        // Vertices at the end may have been dropped.
        let vertices = (start.vertex as usize).min(end[0])..vertex_end.min(end[0]);
        let faces = start.face as usize..face_end;
        let is_empty = vertices.is_empty() && faces.is_empty();
        (!is_empty).then_some(Block { name: start.name, vertices, faces })
    })
}

fn corner_range(content: &Content<'_>, faces: &Range<usize>) -> Range<usize> {
    content.face_offsets[faces.start] as usize..content.face_offsets[faces.end] as usize
}

/// Returns whether each object becomes a mesh: there are several with faces, the faces of each use vertices of its own alone, and
/// vertices of objects without faces all belong to polylines or points.
pub(super) fn is_split_by_objects(content: &Content<'_>) -> Result<bool, ReadError> {
    let count = content.objects.len();
    let has_few_corners = content.corners.len() < MIN_MEAN_CORNERS * count;
    if count < 2 || count > if has_few_corners { MAX_SMALL_OBJECTS } else { MAX_OBJECTS } {
        return Ok(false);
    }
    let mut is_in_element = Vec::new();
    is_in_element.try_reserve_exact(content.positions.len())?;
    is_in_element.resize(content.positions.len(), false);
    for &vertex in content.polylines.vertices.iter().chain(&content.points.vertices) {
        is_in_element[vertex as usize] = true;
    }
    let mut meshes = 0;
    for block in blocks(content) {
        let corners = &content.corners[corner_range(content, &block.faces)];
        let is_own = corners.iter().all(|&vertex| block.vertices.contains(&(vertex as usize)))
            && (!block.faces.is_empty() || is_in_element[block.vertices].iter().all(|&is_used| is_used));
        if !is_own {
            return Ok(false);
        }
        meshes += usize::from(!block.faces.is_empty());
    }
    Ok(meshes > 1)
}

/// Makes a document of the file's faces.
pub(super) fn document_from_faces(
    mut content: Content<'_>,
    face_materials: Vec<u32>,
    is_split: bool,
) -> Result<Document, ReadError> {
    drop_missing_values(&content.normals, &mut content.corner_normals);
    drop_missing_values(&content.texcoords, &mut content.corner_texcoords);
    if !is_split {
        return Ok(Document::from_mesh(whole_mesh(content, face_materials)?));
    }
    let mut document = Document::default();
    let count = blocks(&content).filter(|block| !block.faces.is_empty()).count();
    document.meshes.try_reserve_exact(count)?;
    document.placements.try_reserve_exact(count)?;
    for block in blocks(&content).filter(|block| !block.faces.is_empty()) {
        let mesh = mesh_from_block(&content, &face_materials, &block)?;
        let index = document.meshes.len() as u32;
        document.placements.push(Placement { name: mesh.name.clone(), mesh: index, transform: Placement::IDENTITY });
        document.meshes.push(mesh);
        alloc::check_reserve()?;
    }
    Ok(document)
}

fn whole_mesh(content: Content<'_>, face_materials: Vec<u32>) -> Result<Mesh, ReadError> {
    let name = match content.objects[..] {
        [first, ref others @ ..] if others.iter().all(|other| other.name == first.name) => first.name,
        _ => &[],
    };
    let (corners, vertex_count) = (content.corners, content.positions.len());
    let normals = values_from_lists(content.normals, &content.corner_normals, &corners, vertex_count)?;
    drop(content.corner_normals);
    let texcoords = values_from_lists(content.texcoords, &content.corner_texcoords, &corners, vertex_count)?;
    Ok(Mesh {
        name: owned_text(name)?,
        positions: Positions::F64(content.positions),
        face_offsets: content.face_offsets,
        corners,
        normals,
        texcoords,
        vertex_colours: content.colours,
        face_materials,
        ..Mesh::default()
    })
}

fn mesh_from_block(content: &Content<'_>, face_materials: &[u32], block: &Block<'_>) -> Result<Mesh, ReadError> {
    let corner_range = corner_range(content, &block.faces);
    let (vertex_start, corner_start) = (block.vertices.start as u32, corner_range.start as u32);
    let corners = alloc::collect(content.corners[corner_range.clone()].iter().map(|vertex| vertex - vertex_start))?;
    let offsets = &content.face_offsets[block.faces.start..=block.faces.end];
    let [normals, texcoords] = [&content.corner_normals, &content.corner_texcoords]
        .map(|indices| indices.get(corner_range.clone()).unwrap_or_default());
    Ok(Mesh {
        name: owned_text(block.name)?,
        positions: Positions::F64(alloc::copied(&content.positions[block.vertices.clone()])?),
        face_offsets: alloc::collect(offsets.iter().map(|offset| offset - corner_start))?,
        normals: values_from_indices(&content.normals, normals, &corners, block.vertices.len())?,
        texcoords: values_from_indices(&content.texcoords, texcoords, &corners, block.vertices.len())?,
        corners,
        vertex_colours: alloc::copied(content.colours.get(block.vertices.clone()).unwrap_or_default())?,
        face_materials: alloc::copied(face_materials.get(block.faces.clone()).unwrap_or_default())?,
        ..Mesh::default()
    })
}
