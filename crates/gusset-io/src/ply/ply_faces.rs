//! Faces and triangle strips of PLY files.

use super::ply_colours::ColourReader;
use super::ply_columns::FaceColumns;
use super::ply_header::Element;
use super::ply_rows::Rows;
use super::room::make_room;
use crate::error::{Note, Place, ReadError, ReadErrorKind};
use crate::material::NO_MATERIAL;
use crate::mesh::{Mesh, Values};

/// Attributes that all elements of faces have, and values that are added to the mesh at the end.
pub(super) struct FaceParts {
    vertex_count: u32,
    /// Index of the first property of faces.
    first_property: usize,
    image_count: usize,
    has_colours: bool,
    /// Texture coordinates of corners.
    texcoords: Option<Vec<[f64; 2]>>,
    /// Faces with fewer than three corners.
    dropped: u64,
    notes: Vec<Note>,
}

impl FaceParts {
    pub(super) fn new(
        vertex_count: u32,
        first_property: usize,
        image_count: usize,
        has_colours: bool,
        has_texcoords: bool,
    ) -> Self {
        let texcoords = has_texcoords.then(Vec::new);
        Self { vertex_count, first_property, image_count, has_colours, texcoords, dropped: 0, notes: Vec::new() }
    }

    /// Appends an element's rows to the faces of a mesh, except faces with fewer than three corners. `believed` is the number of faces
    /// that the file can hold.
    pub(super) fn read_faces<R: Rows>(
        &mut self,
        rows: &mut R,
        element: &Element<'_>,
        columns: &FaceColumns,
        believed: usize,
        mesh: &mut Mesh,
    ) -> Result<(), ReadError> {
        let colour = columns.colour.filter(|_| self.has_colours).map(|columns| ColourReader::new(element, columns));
        let first_colour = mesh.face_colours.len();
        make_room(&mut mesh.face_offsets, believed)?;
        make_room(&mut mesh.corners, 3 * believed)?;
        if colour.is_some() {
            make_room(&mut mesh.face_colours, believed)?;
        }
        if self.image_count > 0 {
            make_room(&mut mesh.face_materials, believed)?;
        }
        let properties = mesh.properties[self.first_property..].iter_mut();
        let mut properties: Vec<_> =
            columns.property_columns.iter().zip(properties.map(|property| &mut property.values)).collect();
        properties.iter_mut().try_for_each(|(_, values)| make_room(values, believed))?;
        for row in 0..element.count {
            rows.advance(element, row)?;
            let degree = rows.list_length(columns.vertices);
            if degree < 3 {
                self.dropped += 1;
                continue;
            }
            make_room(&mut mesh.corners, degree)?;
            rows.append_list_as_indices(columns.vertices, self.vertex_count, &mut mesh.corners)
                .map_err(|corner| missing_vertex(rows, element, row, columns.vertices, corner, self.vertex_count))?;
            mesh.face_offsets.push(end_of_face(&mesh.corners)?);
            if let (Some(texcoords), Some(column)) = (&mut self.texcoords, columns.texcoord) {
                append_texcoords(rows, column, degree, texcoords)?;
            }
            if let Some(reader) = &colour {
                mesh.face_colours.push(reader.read_colour(rows));
            }
            if self.image_count > 0 {
                mesh.face_materials.push(self.image(columns.image.map(|column| rows.number(column))));
            }
            for (column, values) in &mut properties {
                values.push(rows.number(**column));
            }
        }
        if let Some(reader) = colour {
            reader.finish(&mut mesh.face_colours[first_colour..], &mut self.notes);
        }
        Ok(())
    }

    /// Returns the material of a face: the image of this number. A face without a number has the first image.
    fn image(&self, number: Option<f64>) -> u32 {
        let number = number.unwrap_or(0.0);
        if number >= 0.0 && number < self.image_count as f64 { number as u32 } else { NO_MATERIAL }
    }

    /// Appends the triangles of an element's strips. A negative index ends a strip. Triangles that name a vertex twice, which join
    /// strips, are left out.
    pub(super) fn read_strips<R: Rows>(
        &mut self,
        rows: &mut R,
        element: &Element<'_>,
        list: usize,
        mesh: &mut Mesh,
    ) -> Result<(), ReadError> {
        let vertex_count = self.vertex_count;
        for row in 0..element.count {
            rows.advance(element, row)?;
            let mut before = [0; 2];
            let mut length = 0_usize;
            for place in 0..rows.list_length(list) {
                let value = rows.item(list, place);
                if value < 0.0 {
                    length = 0;
                    continue;
                }
                if !(value < f64::from(vertex_count) && value.fract() == 0.0) {
                    return Err(missing_vertex(rows, element, row, list, place, vertex_count));
                }
                let vertex = value as u32;
                let [a, b] = before;
                if length >= 2 && a != b && b != vertex && vertex != a {
                    make_room(&mut mesh.corners, 3)?;
                    mesh.corners.extend(if length.is_multiple_of(2) { [a, b, vertex] } else { [b, a, vertex] });
                    make_room(&mut mesh.face_offsets, 1)?;
                    mesh.face_offsets.push(end_of_face(&mesh.corners)?);
                    if self.image_count > 0 {
                        make_room(&mut mesh.face_materials, 1)?;
                        mesh.face_materials.push(self.image(None));
                    }
                }
                before = [b, vertex];
                length += 1;
            }
        }
        Ok(())
    }

    /// Gives the mesh the texture coordinates of its corners. Returns notes about the faces.
    pub(super) fn finish(mut self, mesh: &mut Mesh) -> Vec<Note> {
        if self.dropped > 0 {
            let text = format!("{} faces with fewer than 3 corners are left out", self.dropped);
            self.notes.push(Note::new(Place::Whole, text));
        }
        if let Some(texcoords) = self.texcoords.filter(|pairs| pairs.iter().any(|pair| !pair[0].is_nan())) {
            if !mesh.texcoords.is_absent() {
                let text = "texture coordinates of vertices are left out, because corners have their own";
                self.notes.push(Note::new(Place::Whole, text));
            }
            mesh.texcoords = Values::Corners(texcoords);
        }
        self.notes
    }
}

fn end_of_face(corners: &[u32]) -> Result<u32, ReadError> {
    u32::try_from(corners.len())
        .map_err(|_| ReadError::new(ReadErrorKind::TooLarge, "the mesh has more than 2^32 - 1 corners; split it"))
}

/// Appends two numbers for each corner; missing ones if the list has another length.
fn append_texcoords<R: Rows>(
    rows: &R,
    column: usize,
    degree: usize,
    texcoords: &mut Vec<[f64; 2]>,
) -> Result<(), ReadError> {
    make_room(texcoords, degree)?;
    if rows.list_length(column) == 2 * degree {
        texcoords.extend((0..degree).map(|corner| [0, 1].map(|axis| rows.item(column, 2 * corner + axis))));
    } else {
        texcoords.resize(texcoords.len() + degree, Values::<2>::MISSING);
    }
    Ok(())
}

fn missing_vertex<R: Rows>(
    rows: &R,
    element: &Element<'_>,
    row: u64,
    list: usize,
    corner: usize,
    vertex_count: u32,
) -> ReadError {
    let (name, value) = (element.row_name(row), rows.item(list, corner));
    let text = format!("{name}, corner {corner}: vertex {value} does not exist (the mesh has {vertex_count})");
    ReadError::malformed(rows.place(), text)
}
