//! Lines and points of primitives, in the coordinates of their mesh and then of the scene.

use super::gltf_faces_read::Mode;
use super::gltf_matrix::{Matrix, transformed};
use crate::budget::Budget;
use crate::document::{Curves, Document, PointCloud, transformed_normal};
use crate::error::{ReadError, ReadErrorKind};
use crate::mesh::Positions;
use gusset_base::alloc;

/// Polylines and points of a mesh. Positions have double precision.
#[derive(Default)]
pub(super) struct Strands {
    pub(super) positions: Vec<[f64; 3]>,
    pub(super) offsets: Vec<u32>,
    pub(super) closed: Vec<bool>,
    pub(super) points: Vec<LoosePoint>,
    pub(super) has_normals: bool,
    pub(super) has_colours: bool,
}

/// A point without faces. Attributes that it lacks are NaN.
pub(super) struct LoosePoint {
    pub(super) position: [f64; 3],
    pub(super) normal: [f64; 3],
    pub(super) colour: [f32; 4],
}

impl Strands {
    /// Appends lines of a primitive. Segments of which each begins where the one before ends are one polyline.
    pub(super) fn append_lines(
        &mut self,
        mode: Mode,
        indices: &[u32],
        positions: &[[f64; 3]],
        budget: &mut Budget,
    ) -> Result<(), ReadError> {
        budget.take_bytes_of::<([f64; 3], u32, bool)>(indices.len() as u64)?;
        if mode != Mode::Lines {
            let is_closed = mode == Mode::LineLoop;
            return self.append_line(indices, is_closed, positions);
        }
        let mut line: Vec<u32> = Vec::new();
        for segment in indices.chunks_exact(2) {
            if line.last() != Some(&segment[0]) {
                self.append_line(&line, false, positions)?;
                line.clear();
                alloc::push(&mut line, segment[0])?;
            }
            alloc::push(&mut line, segment[1])?;
        }
        self.append_line(&line, false, positions)
    }

    /// Appends a polyline. One that ends at its first vertex is closed.
    fn append_line(&mut self, line: &[u32], is_closed: bool, positions: &[[f64; 3]]) -> Result<(), ReadError> {
        let returns = line.len() > 3 && line.first() == line.last();
        let line = if returns { &line[..line.len() - 1] } else { line };
        if line.len() < 2 {
            return Ok(());
        }
        if self.offsets.is_empty() {
            alloc::push(&mut self.offsets, 0)?;
        }
        alloc::reserve(&mut self.positions, line.len())?;
        self.positions.extend(line.iter().map(|&vertex| positions[vertex as usize]));
        alloc::push(&mut self.offsets, self.positions.len() as u32)?;
        Ok(alloc::push(&mut self.closed, is_closed || returns)?)
    }

    /// Appends these lines and points to the document, where a node shows them.
    pub(super) fn place_in_document(
        &self,
        document: &mut Document,
        transform: &Matrix,
        budget: &mut Budget,
    ) -> Result<(), ReadError> {
        budget.take_bytes_of::<([f64; 3], u32, bool)>(self.positions.len() as u64)?;
        budget.take_bytes_of::<LoosePoint>(self.points.len() as u64)?;
        place_lines(&mut document.curves, self, transform)?;
        place_points(&mut document.points, self, transform)
    }
}

fn doubles(positions: &mut Positions) -> Result<&mut Vec<[f64; 3]>, ReadError> {
    positions.make_double()?;
    match positions {
        Positions::F64(points) => Ok(points),
        Positions::F32(_) => unreachable!("converted above"),
    }
}

fn place_lines(curves: &mut Curves, strands: &Strands, transform: &Matrix) -> Result<(), ReadError> {
    let all = doubles(&mut curves.positions)?;
    let start = all.len() as u64;
    if start + strands.positions.len() as u64 >= u64::from(u32::MAX) {
        return Err(ReadError::new(ReadErrorKind::TooLarge, "the lines have more than 2^32 - 2 points; split them"));
    }
    all.try_reserve(strands.positions.len())?;
    all.extend(strands.positions.iter().map(|&point| transformed(transform, point)));
    alloc::reserve(&mut curves.offsets, strands.closed.len())?;
    alloc::append(&mut curves.closed, &strands.closed)?;
    curves.offsets.extend(strands.offsets.iter().skip(1).map(|&offset| start as u32 + offset));
    Ok(())
}

fn place_points(cloud: &mut PointCloud, strands: &Strands, transform: &Matrix) -> Result<(), ReadError> {
    let all = doubles(&mut cloud.positions)?;
    let before = all.len();
    all.try_reserve(strands.points.len())?;
    all.extend(strands.points.iter().map(|point| transformed(transform, point.position)));
    if strands.has_normals || !cloud.normals.is_empty() {
        alloc::grow(&mut cloud.normals, before, [f64::NAN; 3])?;
        alloc::reserve(&mut cloud.normals, strands.points.len())?;
        cloud.normals.extend(strands.points.iter().map(|point| transformed_normal(transform, point.normal)));
    }
    if strands.has_colours || !cloud.colours.is_empty() {
        alloc::grow(&mut cloud.colours, before, [1.0; 4])?;
        alloc::reserve(&mut cloud.colours, strands.points.len())?;
        let white = |colour: [f32; 4]| if colour[0].is_nan() { [1.0; 4] } else { colour };
        cloud.colours.extend(strands.points.iter().map(|point| white(point.colour)));
    }
    Ok(())
}
