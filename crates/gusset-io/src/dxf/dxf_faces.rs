//! Faces of entities.

use super::dxf_entity::{Entity, Frame};
use crate::error::ReadError;
use crate::mesh::{Mesh, Positions};
use crate::outline_pen::Vector;
use crate::vertex_merging::VertexMerger;

/// Faces by the positions of their corners.
pub(super) struct FaceList {
    positions: Vec<Vector>,
    offsets: Vec<u32>,
    /// Faces of fewer than three different corners, which are left out.
    pub(super) dropped_face_count: usize,
    /// Faces that name vertices which do not exist, and are left out.
    pub(super) wrong_index_count: usize,
}

impl FaceList {
    pub(super) fn new() -> Self {
        Self { positions: Vec::new(), offsets: vec![0], dropped_face_count: 0, wrong_index_count: 0 }
    }

    pub(super) fn point_count(&self) -> usize {
        self.positions.len()
    }

    /// Adds a face without its repeated corners.
    fn add(&mut self, corners: &[Vector]) -> Result<(), ReadError> {
        let start = self.positions.len();
        for &corner in corners {
            if self.positions[start..].last() != Some(&corner) {
                self.positions.try_reserve(1)?;
                self.positions.push(corner);
            }
        }
        if self.positions.len() > start + 1 && self.positions[start] == self.positions[self.positions.len() - 1] {
            self.positions.pop();
        }
        if self.positions.len() < start + 3 {
            self.positions.truncate(start);
            self.dropped_face_count += 1;
            return Ok(());
        }
        self.offsets.try_reserve(1)?;
        self.offsets.push(u32::try_from(self.positions.len()).map_err(|_| ReadError::out_of_memory())?);
        Ok(())
    }

    /// Adds a `3DFACE`.
    pub(super) fn add_3dface(&mut self, entity: &Entity<'_>, frame: &Frame) -> Result<(), ReadError> {
        let has_fourth = entity.number_of_code(13).is_some();
        let corners =
            [10, 11, 12, if has_fourth { 13 } else { 12 }].map(|code| frame.map_point(entity.point_of_code(code)));
        self.add(&corners)
    }

    /// Adds a polygon mesh of `rows` times `columns` vertices.
    pub(super) fn add_grid(
        &mut self,
        points: &[Vector],
        [rows, columns]: [usize; 2],
        [are_rows_closed, are_columns_closed]: [bool; 2],
    ) -> Result<(), ReadError> {
        if points.is_empty() || rows.checked_mul(columns) != Some(points.len()) {
            self.wrong_index_count += 1;
            return Ok(());
        }
        for row in 0..rows - usize::from(!are_rows_closed) {
            for column in 0..columns - usize::from(!are_columns_closed) {
                let (below, right) = ((row + 1) % rows, (column + 1) % columns);
                let places = [[row, column], [row, right], [below, right], [below, column]];
                self.add(&places.map(|[row, column]| points[row * columns + column]))?;
            }
        }
        Ok(())
    }

    /// Adds a face of a polyface mesh. Vertices count from 1; negative numbers mark hidden edges.
    pub(super) fn add_polyface(&mut self, points: &[Vector], numbers: [i64; 4]) -> Result<(), ReadError> {
        let mut corners = [[0.0; 3]; 4];
        let mut count = 0;
        for number in numbers.into_iter().filter(|&number| number != 0) {
            let place = usize::try_from(number.unsigned_abs()).ok().and_then(|place| points.get(place - 1));
            let Some(&point) = place else {
                self.wrong_index_count += 1;
                return Ok(());
            };
            corners[count] = point;
            count += 1;
        }
        self.add(&corners[..count])
    }

    /// Makes a mesh, or nothing without faces.
    pub(super) fn into_mesh(self, merge_repeated: bool) -> Result<Option<Mesh>, ReadError> {
        if self.offsets.len() == 1 {
            return Ok(None);
        }
        let mut corners = Vec::new();
        let positions = if merge_repeated {
            let mut merger = VertexMerger::new(self.positions.len() / 4)?;
            merger.extend(&self.positions, &mut corners)?;
            merger.into_points()
        } else {
            corners.try_reserve_exact(self.positions.len())?;
            corners.extend(0..self.positions.len() as u32);
            self.positions
        };
        let positions = Positions::F64(positions);
        Ok(Some(Mesh { positions, corners, face_offsets: self.offsets, ..Mesh::default() }))
    }
}
