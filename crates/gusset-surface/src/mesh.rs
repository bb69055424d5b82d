//! Meshes of sheets within a tolerance.
//!
//! All cells of a row have the same number of parts in u, and all cells of a column in v, so that
//! neighbours fit. A triangle with sides a and b in the parameter plane is within (M_uu a^2 + 2
//! M_uv a b + M_vv b^2) / 8 of the surface, where M bounds the second derivatives (Filip, Magedson
//! and Markot 1986, "Surface algorithms using bounds on derivatives"). Control nets give the
//! bounds.

use super::cells::SheetCells;
use super::{Patch, Place, Sheet, each_sheet};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_mesh::{MAX_ELEMENTS, Mesh, PositionBuffer};
use std::ops::Range;

/// Options for converting a sheet to a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceMeshOptions {
    /// Largest distance of triangles from the surface, at equal parameters. Must be positive;
    /// infinity means no limit.
    pub tolerance: f64,
    /// Smallest number of parts of each cell in u and in v, at least 1.
    pub least: [u32; 2],
    /// If true, only triangles, with diagonals from (i, j) to (i + 1, j + 1). If false, quads, and
    /// triangles at poles.
    pub triangles: bool,
}

impl Default for SurfaceMeshOptions {
    /// Returns options for quads, one for each cell.
    fn default() -> Self {
        SurfaceMeshOptions { tolerance: f64::INFINITY, least: [1, 1], triangles: false }
    }
}

/// The mesh of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceMesh {
    /// The mesh, whose vertices are points of the surface. Faces are counter-clockwise seen from
    /// the side of S_u x S_v. The mesh is closed at poles and at seams of closed directions. It
    /// lacks faces where the sheet is degenerate.
    pub mesh: Mesh,
    /// The place of each vertex; the sheet is 0.
    pub places: Vec<Place>,
    /// The unit normal at each vertex; zero where none exists.
    pub normals: Vec<DVec3>,
    /// A bound of the distance between the surface and the triangles at equal parameters. For quads
    /// it holds for either pair of triangles.
    pub deviation: f64,
    /// The parameter lines that form the mesh.
    pub lines: MeshParameterLines,
}

/// The parameter lines of the mesh of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshParameterLines {
    /// The numbers of the sheet's cells in u and in v.
    pub cells: [usize; 2],
    /// Lines in u and in v, each by its cell and the parameter within it, 0 to 1. Includes the
    /// lines that close the sheet.
    pub lines: [Vec<(u32, f64)>; 2],
    /// For each face corner, the two lines that meet there, as a single number: the index of the
    /// line of u, times the number of lines of v, plus the index of the line of v. On a seam, each
    /// face refers to its own side.
    pub line_pair_of_corner: Vec<u32>,
}

impl MeshParameterLines {
    /// The cell that contains a face, and the parameters of the face's corners within it. `corners`
    /// is the range of the face's corners in the mesh.
    pub fn face_parameters(&self, corners: Range<usize>) -> ([u32; 2], impl ExactSizeIterator<Item = [f64; 2]>) {
        let across = self.lines[1].len();
        let at = move |corner: usize| {
            let pair = self.line_pair_of_corner[corner] as usize;
            [pair / across, pair % across]
        };
        // Each line of the cell contains at least one of any three corners.
        let first = [0, 1].map(|k| corners.clone().map(|corner| at(corner)[k]).min().unwrap_or(0));
        let cell = [0, 1].map(|k| self.lines[k].get(first[k]).map_or(0, |line| line.0));
        let parameter = move |k: usize, line: usize| match self.lines[k][line] {
            (own, parameter) if own == cell[k] => parameter,
            _ => 1.0,
        };
        (cell, corners.map(move |corner| [0, 1].map(|k| parameter(k, at(corner)[k]))))
    }
}

/// Bounds of the second derivatives S_uu, S_uv, S_vv.
#[derive(Clone, Copy, Default)]
struct SecondDerivativeBounds([f64; 3]);

impl SecondDerivativeBounds {
    fn from_patch<const N: usize>(patch: &Patch<N>) -> SecondDerivativeBounds {
        let (points, degree) = (&patch.points, (N - 1) as f64);
        let mut squares = [0.0_f64; 3];
        for (a, b) in (0..N).flat_map(|a| (0..N).map(move |b| (a, b))) {
            if a + 2 < N {
                let second = points[a + 2][b] - 2.0 * points[a + 1][b] + points[a][b];
                squares[0] = squares[0].max(second.length_squared());
            }
            if a + 1 < N && b + 1 < N {
                let mixed = (points[a + 1][b + 1] - points[a + 1][b]) - (points[a][b + 1] - points[a][b]);
                squares[1] = squares[1].max(mixed.length_squared());
            }
            if b + 2 < N {
                let second = points[a][b + 2] - 2.0 * points[a][b + 1] + points[a][b];
                squares[2] = squares[2].max(second.length_squared());
            }
        }
        let [uu, uv, vv] = squares.map(f64::sqrt);
        SecondDerivativeBounds([degree * (degree - 1.0) * uu, degree * degree * uv, degree * (degree - 1.0) * vv])
    }

    /// Bound of the distance between the surface and the triangles, if a cell has m x n parts.
    fn triangle_deviation(&self, u_parts: f64, v_parts: f64) -> f64 {
        let [uu, uv, vv] = self.0;
        0.125 * (uu / (u_parts * u_parts) + 2.0 * uv / (u_parts * v_parts) + vv / (v_parts * v_parts))
    }
}

impl Sheet<'_> {
    /// Returns a mesh whose vertices are points of the sheet. O(cells + vertices).
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the tolerance is not positive, or a number of parts is 0;
    /// [`Error::TooLarge`] for more than 2^32 - 2 corners, [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn to_mesh(&self, options: &SurfaceMeshOptions, job: &Job<'_>) -> Result<SurfaceMesh> {
        Error::require(options.tolerance > 0.0, "tolerance", options.tolerance, "above 0")?;
        Error::require(!options.least.contains(&0), "parts", 0.0, "at least 1")?;
        let lattice = MeshLattice::new(self, options, &job.sub_job(0.0, 0.3))?;
        lattice.mesh_on_lines(options.triangles, &job.sub_job(0.3, 1.0))
    }

    fn second_derivative_bounds(&self, i: usize, j: usize) -> SecondDerivativeBounds {
        each_sheet!(self, cells => SecondDerivativeBounds::from_patch(&SheetCells::cell_patch(cells, i, j)))
    }
}

/// The cell of a parameter line, and its parameter there.
type ParameterLine = (u32, f64);

/// The lines of one direction, and whether each of them is a single point.
fn parameter_lines(
    sheet: &Sheet<'_>,
    direction: usize,
    parts: &[f64],
    count: usize,
) -> Result<(Vec<ParameterLine>, Vec<bool>)> {
    let is_point = |cell: usize, end: bool| sheet.is_node_line_point(direction, cell, end);
    let mut lines = alloc::with_capacity(count + 1)?;
    let mut points = alloc::with_capacity(count + 1)?;
    for (cell, &parts) in parts.iter().enumerate() {
        for k in 0..parts as usize {
            lines.push((cell as u32, k as f64 / parts));
            points.push(k == 0 && is_point(cell, false));
        }
    }
    if !sheet.is_closed()[direction] {
        lines.push((parts.len() as u32 - 1, 1.0));
        points.push(is_point(parts.len() - 1, true));
    }
    Ok((lines, points))
}

/// The parameter lines of a mesh of a sheet.
struct MeshLattice<'a> {
    sheet: &'a Sheet<'a>,
    /// Lines in u and in v, without the lines that close the sheet.
    lines: [Vec<ParameterLine>; 2],
    /// Whether each line is a single point.
    is_line_a_point: [Vec<bool>; 2],
    /// If both directions have lines that are single points: the first such line of v. All these
    /// lines are the same point.
    first_point_line_of_v: Option<usize>,
    deviation: f64,
}

impl<'a> MeshLattice<'a> {
    fn new(sheet: &'a Sheet<'a>, options: &SurfaceMeshOptions, job: &Job<'_>) -> Result<Self> {
        let [rows, columns] = sheet.cells();
        let [least_u, least_v] = options.least.map(f64::from);
        let mut parts = [alloc::filled(least_u, rows)?, alloc::filled(least_v, columns)?];
        let least = |bound: f64| (0.5 * bound / options.tolerance).sqrt().ceil();
        let mut bends = alloc::with_capacity(rows * columns)?;
        for i in 0..rows {
            job.step(0.8 * i as f64 / rows as f64, "bounding second derivatives")?;
            for j in 0..columns {
                let bend = sheet.second_derivative_bounds(i, j);
                parts[0][i] = parts[0][i].max(least(bend.0[0]));
                parts[1][j] = parts[1][j].max(least(bend.0[2]));
                bends.push(bend);
            }
        }
        // S_uu and S_vv get a quarter of the tolerance each. Twists may need more parts than these
        // two ask for.
        for (k, bend) in bends.iter().enumerate() {
            let (i, j) = (k / columns, k % columns);
            let short = 0.5 * bend.0[1] / (options.tolerance * parts[0][i] * parts[1][j]);
            if short > 1.0 {
                parts[0][i] = (parts[0][i] * short.sqrt()).ceil();
                parts[1][j] = (parts[1][j] * short.sqrt()).ceil();
            }
        }
        let counts = [0, 1].map(|k| parts[k].iter().sum::<f64>());
        let corners = counts[0] * counts[1] * if options.triangles { 6.0 } else { 4.0 };
        if corners.is_nan() || corners > MAX_ELEMENTS as f64 {
            return Err(Error::TooLarge { what: "corners", count: corners as u64, limit: MAX_ELEMENTS });
        }
        let deviations =
            bends.iter().enumerate().map(|(k, of)| of.triangle_deviation(parts[0][k / columns], parts[1][k % columns]));
        let deviation = deviations.fold(0.0, f64::max);
        let (lines_u, points_u) = parameter_lines(sheet, 0, &parts[0], counts[0] as usize)?;
        let (lines_v, points_v) = parameter_lines(sheet, 1, &parts[1], counts[1] as usize)?;
        let meeting = if points_u.contains(&true) { points_v.iter().position(|&point| point) } else { None };
        Ok(MeshLattice {
            sheet,
            lines: [lines_u, lines_v],
            is_line_a_point: [points_u, points_v],
            first_point_line_of_v: meeting,
            deviation,
        })
    }

    /// The first pair of lines that meet at the vertex where lines a and b meet.
    fn first_line_pair_of_vertex(&self, a: usize, b: usize) -> (usize, usize) {
        let (a, b) = (a % self.lines[0].len(), b % self.lines[1].len());
        match (self.is_line_a_point[0][a], self.is_line_a_point[1][b], self.first_point_line_of_v) {
            (false, false, _) => (a, b),
            (_, _, Some(column)) => (0, column),
            (true, ..) => (a, 0),
            (false, true, None) => (0, b),
        }
    }

    fn mesh_on_lines(&self, triangles: bool, job: &Job<'_>) -> Result<SurfaceMesh> {
        let [height, width] = [0, 1].map(|k| self.lines[k].len());
        let mut vertices = alloc::filled(u32::MAX, height * width)?;
        let (mut positions, mut places, mut normals) = (Vec::new(), Vec::new(), Vec::new());
        for a in 0..height {
            job.step(0.8 * a as f64 / height as f64, "evaluating")?;
            for b in (0..width).filter(|&b| self.first_line_pair_of_vertex(a, b) == (a, b)) {
                let ((i, u), (j, v)) = (self.lines[0][a], self.lines[1][b]);
                vertices[a * width + b] = positions.len() as u32;
                alloc::push(&mut positions, self.sheet.jet(i as usize, j as usize, u, v).point.to_array())?;
                alloc::push(&mut normals, self.sheet.normal(i as usize, j as usize, u, v))?;
                alloc::push(&mut places, Place { sheet: 0, cell: [i, j], u, v })?;
            }
        }
        let [tall, wide] = [0, 1].map(|k| self.lines[k].len() - usize::from(!self.sheet.is_closed()[k]));
        let (mut face_offsets, mut face_corners) = (vec![0], Vec::new());
        let mut lattice = Vec::new();
        let mut add = |face: &[(u32, u32)]| -> Result<()> {
            let start = face_corners.len();
            for (k, &(corner, place)) in face.iter().enumerate() {
                if corner != face[(k + 1) % face.len()].0 && !face_corners[start..].contains(&corner) {
                    alloc::push(&mut face_corners, corner)?;
                    alloc::push(&mut lattice, place)?;
                }
            }
            if face_corners.len() - start > 2 {
                alloc::push(&mut face_offsets, face_corners.len() as u32)
            } else {
                face_corners.truncate(start);
                lattice.truncate(start);
                Ok(())
            }
        };
        for a in 0..tall {
            job.step(0.8 + 0.2 * a as f64 / tall as f64, "making faces")?;
            for b in 0..wide {
                let [p, q, r, s] = [(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)].map(|(a, b)| {
                    let place = (a * (wide + 1) + b) as u32;
                    let (a, b) = self.first_line_pair_of_vertex(a, b);
                    (vertices[a * width + b], place)
                });
                if triangles {
                    add(&[p, q, r])?;
                    add(&[p, r, s])?;
                } else {
                    add(&[p, q, r, s])?;
                }
            }
        }
        let mesh = Mesh::new(PositionBuffer::F64(positions), face_offsets, face_corners);
        let with_end = |k: usize| {
            let mut lines = alloc::copied(&self.lines[k])?;
            if self.sheet.is_closed()[k] {
                alloc::push(&mut lines, (self.sheet.cells()[k] as u32 - 1, 1.0))?;
            }
            Ok(lines)
        };
        let lines = MeshParameterLines {
            cells: self.sheet.cells(),
            lines: [with_end(0)?, with_end(1)?],
            line_pair_of_corner: lattice,
        };
        Ok(SurfaceMesh { mesh, places, normals, deviation: self.deviation, lines })
    }
}
