//! Materials, colours and texture coordinates of triangles.

use super::mf_model::{Group, Model, Object};
use crate::budget::Budget;
use crate::document::Document;
use crate::error::{Note, Place, ReadError};
use crate::material::NO_MATERIAL;
use crate::mesh::{Mesh, Values};
use gusset_base::alloc;

/// The entry of a triangle that has none.
const NONE: u32 = u32::MAX;

/// Group and entries of each triangle up to the last one that has some.
#[derive(Default)]
pub(super) struct TriangleProperties {
    group_and_entries_of_triangle: Vec<[u32; 4]>,
}

impl TriangleProperties {
    /// Sets what a triangle says: its group, and the entry of each corner.
    pub(super) fn set(
        &mut self,
        face: usize,
        group: Option<u32>,
        entries: [Option<u32>; 3],
        budget: &mut Budget,
    ) -> Result<(), ReadError> {
        let more = face + 1 - self.group_and_entries_of_triangle.len().min(face + 1);
        if self.group_and_entries_of_triangle.len() + more > self.group_and_entries_of_triangle.capacity() {
            let more = more.max(self.group_and_entries_of_triangle.capacity()).max(64);
            budget.take_bytes_of::<[u32; 4]>(more as u64)?;
            self.group_and_entries_of_triangle.try_reserve_exact(more)?;
        }
        self.group_and_entries_of_triangle.resize(face, [NONE; 4]);
        let first = entries[0].unwrap_or(NONE);
        let [_, b, c] = entries.map(|entry| entry.unwrap_or(first));
        self.group_and_entries_of_triangle.push([group.unwrap_or(NONE), first, b, c]);
        Ok(())
    }
}

/// Values of corners that a mesh collects.
struct Collected<'m> {
    budget: &'m mut Budget,
    faces: usize,
    materials: Vec<u32>,
    colours: Vec<[f32; 4]>,
    texcoords: Vec<[f64; 2]>,
    unknown: usize,
}

/// Makes room for all faces or corners.
fn fill<T: Copy>(values: &mut Vec<T>, count: usize, missing: T, budget: &mut Budget) -> Result<(), ReadError> {
    if values.is_empty() {
        *values = budget.allocate_vector(count as u64)?;
        values.resize(count, missing);
    }
    Ok(())
}

/// Gives a mesh the properties of its triangles. Groups precede objects in the file.
pub(super) fn apply_properties(
    mesh: &mut Mesh,
    properties: &TriangleProperties,
    object: &Object,
    model: &Model,
    document: &mut Document,
    budget: &mut Budget,
) -> Result<(), ReadError> {
    if properties.group_and_entries_of_triangle.is_empty() && object.property.is_none() {
        return Ok(());
    }
    let faces = mesh.face_count();
    let mut collected =
        Collected { budget, faces, materials: Vec::new(), colours: Vec::new(), texcoords: Vec::new(), unknown: 0 };
    // Neighbours are often in one group.
    let mut last: Option<(u32, Option<&Group>)> = None;
    for face in 0..faces {
        let [group, entries @ ..] = properties.group_and_entries_of_triangle.get(face).copied().unwrap_or([NONE; 4]);
        let (group, entries) = match (object.property, group) {
            (Some((own, entry)), NONE) if entries[0] == NONE => (own, [entry; 3]),
            (Some((own, _)), NONE) => (own, entries),
            (None, NONE) => continue,
            // Without entries of its own, a triangle has none.
            _ if entries[0] == NONE => continue,
            (_, group) => (group, entries),
        };
        let found = match last {
            Some((known, found)) if known == group => found,
            _ => model.groups.get(&(object.id.0, group)),
        };
        last = Some((group, found));
        collected.add_triangle_properties(face, found, entries)?;
    }
    if collected.unknown > 0 {
        let text = format!("object {}: {} triangles have properties that do not exist", object.id.1, collected.unknown);
        alloc::push(&mut document.notes, Note::new(Place::Whole, text))?;
    }
    let Collected { budget, materials, colours, texcoords, .. } = collected;
    mesh.face_materials = materials;
    if !texcoords.is_empty() {
        mesh.texcoords = Values::Corners(texcoords);
    }
    if !colours.is_empty() && !spread_colours(mesh, &colours, budget)? {
        let text = format!("object {}: colours of corners that differ at a vertex are reduced to one", object.id.1);
        alloc::push(&mut document.notes, Note::new(Place::Whole, text))?;
    }
    Ok(())
}

impl Collected<'_> {
    fn add_triangle_properties(
        &mut self,
        face: usize,
        group: Option<&Group>,
        entries: [u32; 3],
    ) -> Result<(), ReadError> {
        let corners = 3 * self.faces;
        match group {
            Some(&Group::Materials { first, count }) if entries[0] < count => {
                fill(&mut self.materials, self.faces, NO_MATERIAL, self.budget)?;
                self.materials[face] = first + entries[0];
            }
            Some(Group::Colours(colours)) => {
                fill(&mut self.colours, corners, [f32::NAN; 4], self.budget)?;
                for (place, entry) in entries.into_iter().enumerate() {
                    match colours.get(entry as usize) {
                        Some(&colour) => self.colours[3 * face + place] = colour,
                        None => self.unknown += usize::from(place == 0),
                    }
                }
            }
            Some(Group::Texcoords { pairs, material }) => {
                fill(&mut self.texcoords, corners, [f64::NAN; 2], self.budget)?;
                fill(&mut self.materials, self.faces, NO_MATERIAL, self.budget)?;
                self.materials[face] = *material;
                for (place, entry) in entries.into_iter().enumerate() {
                    match pairs.get(entry as usize) {
                        Some(&pair) => self.texcoords[3 * face + place] = pair,
                        None => self.unknown += usize::from(place == 0),
                    }
                }
            }
            Some(Group::Other) => {}
            _ => self.unknown += 1,
        }
        Ok(())
    }
}

/// Moves colours of corners to faces if each face has one, or else to vertices. Returns whether corners of a vertex agree.
fn spread_colours(mesh: &mut Mesh, colours: &[[f32; 4]], budget: &mut Budget) -> Result<bool, ReadError> {
    let shown = |colour: [f32; 4]| if colour[0].is_nan() { [1.0; 4] } else { colour };
    let bits = |colour: &[f32; 4]| colour.map(f32::to_bits);
    let (faces, _) = colours.as_chunks::<3>();
    if faces.iter().all(|[a, b, c]| bits(a) == bits(b) && bits(b) == bits(c)) {
        mesh.face_colours = budget.allocate_vector(faces.len() as u64)?;
        mesh.face_colours.extend(faces.iter().map(|face| shown(face[0])));
        return Ok(true);
    }
    let mut at_vertices = budget.allocate_vector::<[f32; 4]>(mesh.positions.len() as u64)?;
    at_vertices.resize(mesh.positions.len(), [f32::NAN; 4]);
    let mut agree = true;
    for (&vertex, colour) in mesh.corners.iter().zip(colours) {
        let own = &mut at_vertices[vertex as usize];
        if own[0].is_nan() {
            *own = *colour;
        } else if !colour[0].is_nan() {
            agree &= bits(own) == bits(colour);
        }
    }
    at_vertices.iter_mut().for_each(|colour| *colour = shown(*colour));
    mesh.vertex_colours = at_vertices;
    Ok(agree)
}
