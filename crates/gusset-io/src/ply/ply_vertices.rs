//! Vertices of PLY files.

use super::ply_colours::ColourReader;
use super::ply_columns::VertexColumns;
use super::ply_header::Element;
use super::ply_rows::Rows;
use super::room::make_room;
use crate::error::{Note, ReadError, ReadErrorKind};
use crate::mesh::{Mesh, Positions, Values};

/// Tells which attributes all vertex elements of the file have.
#[derive(Clone, Copy)]
pub(super) struct VertexAttributeFlags {
    /// Whether single precision holds all positions.
    pub(super) is_single: bool,
    pub(super) has_normals: bool,
    pub(super) has_texcoords: bool,
    pub(super) has_colours: bool,
}

/// Appends an element's rows to the vertices of a mesh. `believed` is the number of rows that the file can hold.
pub(super) fn read_vertices<R: Rows>(
    rows: &mut R,
    element: &Element<'_>,
    columns: &VertexColumns,
    parts: VertexAttributeFlags,
    believed: usize,
    mesh: &mut Mesh,
    notes: &mut Vec<Note>,
) -> Result<(), ReadError> {
    if mesh.positions.len() as u64 + believed as u64 >= u64::from(u32::MAX) {
        return Err(ReadError::new(ReadErrorKind::TooLarge, "the mesh has more than 2^32 - 2 vertices; split it"));
    }
    let first_colour = mesh.vertex_colours.len();
    let mut filling = Filling::new(element, columns, parts, believed, mesh)?;
    for row in 0..element.count {
        rows.advance(element, row)?;
        filling.add(rows);
    }
    if let Some((reader, colours)) = filling.colours {
        reader.finish(&mut colours[first_colour..], notes);
    }
    Ok(())
}

/// Columns that are read, each with the values that it fills.
struct Filling<'a> {
    position: [usize; 3],
    positions: &'a mut Positions,
    normals: Option<([usize; 3], &'a mut Vec<[f64; 3]>)>,
    texcoords: Option<([usize; 2], &'a mut Vec<[f64; 2]>)>,
    colours: Option<(ColourReader, &'a mut Vec<[f32; 4]>)>,
    properties: Vec<(usize, &'a mut Vec<f64>)>,
}

impl<'a> Filling<'a> {
    fn new(
        element: &Element<'_>,
        columns: &VertexColumns,
        parts: VertexAttributeFlags,
        believed: usize,
        mesh: &'a mut Mesh,
    ) -> Result<Self, ReadError> {
        if mesh.positions.is_empty() && parts.is_single {
            mesh.positions = Positions::F32(Vec::new());
        }
        match &mut mesh.positions {
            Positions::F32(points) => make_room(points, believed)?,
            Positions::F64(points) => make_room(points, believed)?,
        }
        let mut normals =
            columns.normal.filter(|_| parts.has_normals).map(|columns| (columns, at_vertices(&mut mesh.normals)));
        let mut texcoords =
            columns.texcoord.filter(|_| parts.has_texcoords).map(|columns| (columns, at_vertices(&mut mesh.texcoords)));
        let colour = columns.colour.filter(|_| parts.has_colours);
        let mut colours = colour.map(|columns| (ColourReader::new(element, columns), &mut mesh.vertex_colours));
        let mut properties: Vec<_> = columns
            .property_columns
            .iter()
            .copied()
            .zip(mesh.properties.iter_mut().map(|property| &mut property.values))
            .collect();
        normals.iter_mut().try_for_each(|(_, values)| make_room(values, believed))?;
        texcoords.iter_mut().try_for_each(|(_, values)| make_room(values, believed))?;
        colours.iter_mut().try_for_each(|(_, values)| make_room(values, believed))?;
        properties.iter_mut().try_for_each(|(_, values)| make_room(values, believed))?;
        Ok(Self { position: columns.position, positions: &mut mesh.positions, normals, texcoords, colours, properties })
    }

    #[inline]
    fn add<R: Rows>(&mut self, rows: &R) {
        let position = self.position.map(|column| rows.number(column));
        match self.positions {
            Positions::F32(points) => points.push(position.map(|x| x as f32)),
            Positions::F64(points) => points.push(position),
        }
        if let Some((columns, normals)) = &mut self.normals {
            normals.push(columns.map(|column| rows.number(column)));
        }
        if let Some((columns, texcoords)) = &mut self.texcoords {
            texcoords.push(columns.map(|column| rows.number(column)));
        }
        if let Some((reader, colours)) = &mut self.colours {
            colours.push(reader.read_colour(rows));
        }
        for (column, values) in &mut self.properties {
            values.push(rows.number(*column));
        }
    }
}

/// Returns the list of vectors at vertices, which replaces an absent attribute.
fn at_vertices<const N: usize>(values: &mut Values<N>) -> &mut Vec<[f64; N]> {
    if values.is_absent() {
        *values = Values::Vertices(Vec::new());
    }
    match values {
        Values::Vertices(list) | Values::Corners(list) => list,
        Values::Absent => unreachable!("replaced above"),
    }
}
