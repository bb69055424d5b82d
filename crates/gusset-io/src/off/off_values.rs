//! Numbers behind the positions of vertices, and colours of faces.

use super::off_header::OffHeader;
use crate::colour_steps::scale_colours;
use crate::error::ReadError;
use crate::mesh::{Mesh, Values};
use gusset_base::alloc;

/// Numbers behind the positions of vertices, row after row.
pub(super) struct VertexRows {
    header: OffHeader,
    pub(super) numbers: Vec<f64>,
    /// Parts of a colour: 3 or 4, or 0 without colours.
    colour_part_count: usize,
}

impl VertexRows {
    /// Begins with the numbers behind the position of the first vertex. Returns `None` if they are too few.
    pub(super) fn from_first_row(header: OffHeader, row: &[f64]) -> Result<Option<Self>, ReadError> {
        let parts = if header.has_colours { row.len().saturating_sub(header.plain_width()).min(4) } else { 0 };
        let width = header.plain_width() + parts;
        if (header.has_colours && parts < 3) || row.len() < width {
            return Ok(None);
        }
        Ok(Some(Self { header, numbers: alloc::copied(&row[..width])?, colour_part_count: parts }))
    }

    /// Returns the count of numbers of a row.
    pub(super) fn width(&self) -> usize {
        self.header.plain_width() + self.colour_part_count
    }

    /// Gives the numbers to the mesh as normals, colours and texture coordinates.
    pub(super) fn enter_into_mesh(&self, mesh: &mut Mesh) -> Result<(), ReadError> {
        let are_colours_first = self.are_colours_first();
        let mut column = if are_colours_first { self.colour_part_count } else { 0 };
        if self.header.has_normals {
            mesh.normals = Values::Vertices(self.vectors(column)?);
            column += 3;
        }
        if self.header.has_colours {
            mesh.vertex_colours = self.colours(if are_colours_first { 0 } else { column })?;
            column += if are_colours_first { 0 } else { self.colour_part_count };
        }
        if self.header.has_texcoords {
            mesh.texcoords = Values::Vertices(self.vectors(column)?);
        }
        Ok(())
    }

    /// Returns whether colours precede normals. Where both are there, the numbers decide, and the header if they cannot.
    fn are_colours_first(&self) -> bool {
        let header = &self.header;
        header.has_normals
            && header.has_colours
            && header.names_normals_first
            && self.are_colour_parts_bytes(0)
            && (!self.are_units(0) || self.are_units(self.colour_part_count))
    }

    fn rows(&self) -> std::slice::ChunksExact<'_, f64> {
        self.numbers.chunks_exact(self.width().max(1))
    }

    /// Returns whether all parts of the colours in some columns are whole numbers up to 255.
    fn are_colour_parts_bytes(&self, column: usize) -> bool {
        let is_step = |part: &f64| (0.0..=255.0).contains(part) && part.fract() == 0.0;
        self.rows().all(|row| row[column..column + self.colour_part_count].iter().all(is_step))
    }

    /// Returns whether all vectors in some columns have length 1 or 0.
    fn are_units(&self, column: usize) -> bool {
        const TOLERANCE: f64 = 1e-3;
        self.rows().all(|row| {
            let length = row[column..column + 3].iter().map(|part| part * part).sum::<f64>().sqrt();
            (length - 1.0).abs() < TOLERANCE || length == 0.0
        })
    }

    fn vectors<const N: usize>(&self, column: usize) -> Result<Vec<[f64; N]>, ReadError> {
        let mut vectors = Vec::new();
        vectors.try_reserve_exact(self.rows().len())?;
        vectors.extend(self.rows().map(|row| std::array::from_fn::<_, N, _>(|k| row[column + k])));
        Ok(vectors)
    }

    fn colours(&self, column: usize) -> Result<Vec<[f32; 4]>, ReadError> {
        let mut colours = Vec::new();
        colours.try_reserve_exact(self.rows().len())?;
        let part = |row: &[f64], k: usize| if k < self.colour_part_count { row[column + k] as f32 } else { f32::NAN };
        colours.extend(self.rows().map(|row| std::array::from_fn::<_, 4, _>(|k| part(row, k))));
        scale_colours(&mut colours);
        Ok(colours)
    }
}

/// Colours of faces, of which the first ones may lack.
#[derive(Default)]
pub(super) struct FaceColours {
    colours: Vec<[f32; 4]>,
}

impl FaceColours {
    /// Adds the colour of face `face` from the numbers behind it. Returns whether they are a colour.
    pub(super) fn add_colour_of_face(&mut self, face: usize, numbers: &[f64]) -> Result<bool, ReadError> {
        if numbers.len() < 3 {
            return Ok(false);
        }
        self.fill(face)?;
        self.colours.try_reserve(1)?;
        self.colours.push(std::array::from_fn(|part| numbers.get(part).map_or(f32::NAN, |&value| value as f32)));
        Ok(true)
    }

    fn fill(&mut self, count: usize) -> Result<(), ReadError> {
        self.colours.try_reserve(count - self.colours.len())?;
        self.colours.resize(count, [f32::NAN; 4]);
        Ok(())
    }

    /// Returns one colour for each face, or none if no face has one.
    pub(super) fn finish(mut self, face_count: usize) -> Result<Vec<[f32; 4]>, ReadError> {
        if !self.colours.is_empty() {
            self.fill(face_count)?;
            scale_colours(&mut self.colours);
        }
        Ok(self.colours)
    }
}
