//! Text OFF files.

use super::off_document::document_from_mesh;
use super::off_header::{OffHeader, parse_header};
use super::off_values::{FaceColours, VertexRows};
use super::read_binary_off::read_binary_off;
use crate::document::Document;
use crate::error::{Note, Place, ReadError, quoted};
use crate::foreign_files::refuse_foreign_file;
use crate::mesh::{Mesh, Positions};
use crate::options::ReadOptions;
use crate::scene::counted;
use crate::text::{Scanner, integer, number};
use crate::text_encoding::decode_text;

/// Fewest bytes of a vertex: three numbers and what separates them.
const MIN_VERTEX_BYTES: usize = 6;

pub(crate) fn read_off(bytes: &[u8], _: &ReadOptions) -> Result<Document, ReadError> {
    let mut first = Scanner::new(bytes, Some(b'#'));
    if let Some((header, [])) = first.word().and_then(parse_header)
        && first.word_in_line() == Some(b"BINARY")
    {
        first.next_line();
        return read_binary_off(&bytes[first.place()..], first.place(), header);
    }
    let text = decode_text(bytes)?;
    let mut reader = OffReader { scanner: Scanner::new(&text, Some(b'#')), mesh: Mesh::default(), notes: Vec::new() };
    reader.read().map_err(|error| refuse_foreign_file(bytes).unwrap_or(error))?;
    Ok(document_from_mesh(reader.mesh, reader.notes))
}

struct OffReader<'a> {
    scanner: Scanner<'a>,
    mesh: Mesh,
    notes: Vec<Note>,
}

impl OffReader<'_> {
    fn read(&mut self) -> Result<(), ReadError> {
        let Some(word) = self.scanner.word() else { return Err(self.scanner.error("the file is empty")) };
        let (header, first_count) = match parse_header(word) {
            Some((header, [])) => (header, None),
            Some((header, digits)) => (header, Some(digits)),
            None if integer(word).is_some() => {
                self.add_note("the word OFF is missing");
                (OffHeader::default(), Some(word))
            }
            None => return Err(self.scanner.error(format!("the file begins with {}, not with OFF", quoted(word)))),
        };
        let dimension = if header.has_dimension { self.read_count(None, "dimension")? } else { 3 };
        if dimension != 3 {
            return Err(ReadError::unsupported(format!("points have {dimension} coordinates; only 3 are read")));
        }
        let vertices = self.read_count(first_count, "count of vertices")?;
        let line = self.scanner.line();
        let faces = self.read_count(None, "count of faces")?;
        if self.scanner.line() > line && first_count.is_none() {
            self.read_count(None, "count of edges")?;
        }
        self.end_line();
        self.read_vertices(header, vertices)?;
        self.read_faces(faces)?;
        if let Some(word) = self.scanner.word() {
            self.add_note(format!("{} and what follows the last face are ignored", quoted(word)));
        }
        Ok(())
    }

    fn add_note(&mut self, text: impl Into<String>) {
        self.notes.push(Note::new(Place::Line(self.scanner.line()), text));
    }

    /// Passes the end of the line, so that the next number is not on it.
    fn end_line(&mut self) {
        self.scanner.rest_of_line();
    }

    /// Reads a count, of which the word may be known.
    fn read_count(&mut self, known: Option<&[u8]>, name: &str) -> Result<u32, ReadError> {
        let Some(word) = known.or_else(|| self.scanner.word()) else {
            return Err(self.scanner.error(format!("the file ends before the {name}")));
        };
        let value =
            integer(word).ok_or_else(|| self.scanner.error(format!("{name}: {} is not a number", quoted(word))))?;
        u32::try_from(value)
            .ok()
            .filter(|&count| count < u32::MAX)
            .ok_or_else(|| self.scanner.error(format!("{name}: {value} is not between 0 and 2^32 - 2")))
    }

    fn numbers_in_line(&mut self, element: &dyn Fn() -> String, numbers: &mut Vec<f64>) -> Result<(), ReadError> {
        numbers.clear();
        while let Some(word) = self.scanner.word_in_line() {
            let value = number(word)
                .ok_or_else(|| self.scanner.error(format!("{}: {} is not a number", element(), quoted(word))))?;
            numbers.try_reserve(1)?;
            numbers.push(value);
        }
        Ok(())
    }

    fn read_vertices(&mut self, header: OffHeader, count: u32) -> Result<(), ReadError> {
        let mut points = Vec::new();
        let held = self.scanner.remaining() / MIN_VERTEX_BYTES + 1;
        points.try_reserve_exact((count as usize).min(held))?;
        let mut rows: Option<VertexRows> = None;
        for vertex in 0..count {
            let element = || format!("vertex {vertex}");
            let mut point = [0.0; 3];
            for coordinate in &mut point {
                *coordinate = self.scanner.number(element)?;
            }
            if header.is_homogeneous {
                let weight = self.scanner.number(element)?;
                point = point.map(|coordinate| coordinate / weight);
            }
            points.try_reserve(1)?;
            points.push(point);
            if let Some(rows) = &mut rows {
                for _ in 0..rows.width() {
                    let value = self.scanner.number(element)?;
                    rows.numbers.try_reserve(1)?;
                    rows.numbers.push(value);
                }
                self.end_line();
            } else {
                rows = Some(self.read_first_row(header)?);
            }
        }
        self.mesh.positions = Positions::F64(points);
        rows.map_or(Ok(()), |rows| rows.enter_into_mesh(&mut self.mesh))
    }

    /// Reads what follows the position of the first vertex: it tells whether colours have opacity.
    fn read_first_row(&mut self, header: OffHeader) -> Result<VertexRows, ReadError> {
        let mut row = Vec::new();
        self.numbers_in_line(&|| "vertex 0".into(), &mut row)?;
        let Some(rows) = VertexRows::from_first_row(header, &row)? else {
            let numbers = counted(row.len(), "number follows", "numbers follow");
            return Err(self
                .scanner
                .error(format!("vertex 0: {numbers} its position, which does not fit the letters before OFF")));
        };
        if row.len() > rows.width() {
            let extra = counted(row.len() - rows.width(), "number", "numbers");
            self.add_note(format!("{extra} behind each vertex, which the letters before OFF do not name, left out"));
        }
        Ok(rows)
    }

    fn read_faces(&mut self, count: u32) -> Result<(), ReadError> {
        let vertex_count = self.mesh.positions.len();
        let mut colours = FaceColours::default();
        let (mut dropped, mut indexed) = (0, 0);
        let mut behind = Vec::new();
        for face in 0..count {
            let corner_count = self.read_face_number(face, None)?;
            let start = self.mesh.corners.len();
            for corner in 0..corner_count {
                let vertex = self.read_face_number(face, Some(corner))?;
                if vertex as usize >= vertex_count {
                    return Err(self.scanner.error(format!(
                        "face {face}, corner {corner}: vertex {vertex} does not exist (the mesh has {vertex_count})"
                    )));
                }
                self.mesh.corners.try_reserve(1)?;
                self.mesh.corners.push(vertex);
            }
            self.numbers_in_line(&|| format!("face {face}"), &mut behind)?;
            if corner_count < 3 {
                dropped += 1;
                self.mesh.corners.truncate(start);
                continue;
            }
            let is_colour = colours.add_colour_of_face(self.mesh.face_count(), &behind)?;
            indexed += usize::from(!is_colour && !behind.is_empty());
            let end = u32::try_from(self.mesh.corners.len()).map_err(|_| ReadError::out_of_memory())?;
            self.mesh.face_offsets.try_reserve(1)?;
            self.mesh.face_offsets.push(end);
        }
        self.mesh.face_colours = colours.finish(self.mesh.face_count())?;
        if dropped > 0 {
            self.add_note(format!("{} with fewer than 3 corners left out", counted(dropped, "face", "faces")));
        }
        if indexed > 0 {
            let faces = counted(indexed, "face has its colour", "faces have their colours");
            self.add_note(format!("{faces} by a number in a table, which the file lacks, left out"));
        }
        Ok(())
    }

    /// Reads the number of corners of a face, or the vertex of a corner.
    fn read_face_number(&mut self, face: u32, corner: Option<u32>) -> Result<u32, ReadError> {
        let element =
            || corner.map_or_else(|| format!("face {face}"), |corner| format!("face {face}, corner {corner}"));
        let Some(word) = self.scanner.word() else {
            return Err(self.scanner.error(format!("{}: the file ends", element())));
        };
        integer(word).and_then(|value| u32::try_from(value).ok()).ok_or_else(|| {
            self.scanner.error(format!("{}: {} is not a whole number from 0 to 2^32 - 1", element(), quoted(word)))
        })
    }
}
