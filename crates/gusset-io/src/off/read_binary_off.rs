//! Binary OFF files: numbers of 32 bits, the most significant byte first.

use super::off_document::document_from_mesh;
use super::off_header::OffHeader;
use super::off_values::{FaceColours, VertexRows};
use crate::document::Document;
use crate::error::{Note, Place, ReadError};
use crate::mesh::{Mesh, Positions};
use crate::scene::counted;
use gusset_base::alloc;

/// Bytes that remain, and where they are in the file.
struct Words<'a> {
    bytes: &'a [u8],
    offset: usize,
}

impl Words<'_> {
    fn next_word(&mut self, element: impl Fn() -> String) -> Result<[u8; 4], ReadError> {
        let Some((word, rest)) = self.bytes.split_first_chunk::<4>() else {
            return Err(ReadError::malformed(Place::Byte(self.offset as u64), format!("{}: the file ends", element())));
        };
        self.bytes = rest;
        self.offset += 4;
        Ok(*word)
    }

    fn read_integer(&mut self, element: impl Fn() -> String) -> Result<u32, ReadError> {
        self.next_word(element).map(u32::from_be_bytes)
    }

    fn read_real(&mut self, element: impl Fn() -> String) -> Result<f32, ReadError> {
        self.next_word(element).map(f32::from_be_bytes)
    }
}

/// Reads what follows the first line, which ends at byte `offset`.
pub(super) fn read_binary_off(bytes: &[u8], offset: usize, header: OffHeader) -> Result<Document, ReadError> {
    let mut words = Words { bytes, offset };
    let dimension = if header.has_dimension { words.read_integer(|| "dimension".into())? } else { 3 };
    if dimension != 3 {
        return Err(ReadError::unsupported(format!("points have {dimension} coordinates; only 3 are read")));
    }
    let mut counts = [0; 3];
    for count in &mut counts {
        *count = words.read_integer(|| "counts".into())?;
    }
    let mut mesh = Mesh::default();
    read_vertices(&mut words, header, counts[0], &mut mesh)?;
    let dropped = read_faces(&mut words, counts[1], &mut mesh)?;
    let mut notes = Vec::new();
    if dropped > 0 {
        let faces = counted(dropped, "face", "faces");
        notes.push(Note::new(Place::Whole, format!("{faces} with fewer than 3 corners left out")));
    }
    Ok(document_from_mesh(mesh, notes))
}

fn read_vertices(words: &mut Words<'_>, header: OffHeader, count: u32, mesh: &mut Mesh) -> Result<(), ReadError> {
    let width = header.plain_width() + if header.has_colours { 4 } else { 0 };
    let size = 4 * (3 + usize::from(header.is_homogeneous) + width);
    if (words.bytes.len() / size) < count as usize {
        let held = words.bytes.len() / size;
        return Err(ReadError::malformed(
            Place::Byte((words.offset + held * size) as u64),
            format!("vertex {held}: the file ends; it announces {count} vertices"),
        ));
    }
    let (mut points, mut rows) = (Vec::new(), None::<VertexRows>);
    points.try_reserve_exact(count as usize)?;
    let mut row = alloc::filled(0.0, width)?;
    for vertex in 0..count {
        let element = || format!("vertex {vertex}");
        let mut point = [0.0; 3];
        for coordinate in &mut point {
            *coordinate = words.read_real(element)?;
        }
        if header.is_homogeneous {
            let weight = words.read_real(element)?;
            point = point.map(|coordinate| coordinate / weight);
        }
        points.push(point);
        for value in &mut row {
            *value = f64::from(words.read_real(element)?);
        }
        match &mut rows {
            None => rows = VertexRows::from_first_row(header, &row)?,
            Some(rows) => {
                rows.numbers.try_reserve(width)?;
                rows.numbers.extend_from_slice(&row);
            }
        }
    }
    mesh.positions = Positions::F32(points);
    rows.map_or(Ok(()), |rows| rows.enter_into_mesh(mesh))
}

/// Returns the number of faces that are left out.
fn read_faces(words: &mut Words<'_>, count: u32, mesh: &mut Mesh) -> Result<usize, ReadError> {
    let vertex_count = mesh.positions.len();
    let mut colours = FaceColours::default();
    let mut dropped = 0;
    for face in 0..count {
        let element = || format!("face {face}");
        let corner_count = words.read_integer(element)?;
        let start = mesh.corners.len();
        for corner in 0..corner_count {
            let vertex = words.read_integer(element)?;
            if vertex as usize >= vertex_count {
                return Err(ReadError::malformed(
                    Place::Byte(words.offset as u64 - 4),
                    format!(
                        "face {face}, corner {corner}: vertex {vertex} does not exist (the mesh has {vertex_count})"
                    ),
                ));
            }
            mesh.corners.try_reserve(1)?;
            mesh.corners.push(vertex);
        }
        let part_count = words.read_integer(element)?;
        let mut parts = [0.0; 4];
        for part in 0..part_count {
            let value = f64::from(words.read_real(element)?);
            if let Some(place) = parts.get_mut(part as usize) {
                *place = value;
            }
        }
        if corner_count < 3 {
            dropped += 1;
            mesh.corners.truncate(start);
            continue;
        }
        colours.add_colour_of_face(mesh.face_count(), &parts[..parts.len().min(part_count as usize)])?;
        let end = u32::try_from(mesh.corners.len()).map_err(|_| ReadError::out_of_memory())?;
        mesh.face_offsets.try_reserve(1)?;
        mesh.face_offsets.push(end);
    }
    mesh.face_colours = colours.finish(mesh.face_count())?;
    Ok(dropped)
}
