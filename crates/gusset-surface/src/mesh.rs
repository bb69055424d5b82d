//! Meshes of sheets within a tolerance.
//!
//! All cells of a row have equally many parts in u, and all of a column in v, so that neighbours
//! fit. A triangle with the sides a and b in the parameters is within (M_uu a^2 + 2 M_uv a b + M_vv
//! b^2) / 8 of the surface, M bounds of the second derivatives (Filip, Magedson and Markot 1986,
//! "Surface algorithms using bounds on derivatives"); bounds come from control nets.

use super::cells::Cells;
use super::{Patch, Place, Sheet, each_sheet};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_mesh::{MAX_ELEMENTS, Mesh, PositionBuffer};
use std::ops::Range;

/// How a sheet becomes a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceMeshOptions {
    /// How far triangles may be from the surface, at equal parameters; infinite for no demand. More
    /// than 0.
    pub tolerance: f64,
    /// The fewest parts of each cell in u and in v; 1 at least.
    pub least: [u32; 2],
    /// Triangles only, from (i, j) to (i + 1, j + 1); else quads, and triangles at poles.
    pub triangles: bool,
}

impl Default for SurfaceMeshOptions {
    /// Quads, one a cell.
    fn default() -> Self {
        SurfaceMeshOptions { tolerance: f64::INFINITY, least: [1, 1], triangles: false }
    }
}

/// The mesh of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceMesh {
    /// The mesh, with points of the surface; faces are counter-clockwise seen from where S_u x S_v
    /// points to. Seams of closed directions and poles are closed. It has no faces where the sheet
    /// has no extent.
    pub mesh: Mesh,
    /// For each vertex where it is; the sheet is 0.
    pub places: Vec<Place>,
    /// For each vertex the unit normal; 0 where there is none.
    pub normals: Vec<DVec3>,
    /// A bound of the distance between the surface and the triangles, or either pair of triangles
    /// of quads, at equal parameters.
    pub deviation: f64,
    /// The parameter lines that the mesh is made of.
    pub lines: ParameterLines,
}

/// The parameter lines of the mesh of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterLines {
    /// The sheet's cells, in u and in v.
    pub cells: [usize; 2],
    /// In u, and in v: the cell and the parameter in it, 0 to 1; those that close the sheet too.
    pub lines: [Vec<(u32, f64)>; 2],
    /// For each corner of the mesh the lines that meet there: that of u, times the number of lines in
    /// v, and that of v. On a seam each face has those of its own side.
    pub corners: Vec<u32>,
}

impl ParameterLines {
    /// The cell that a face lies in, and the parameters of its corners there. `corners`: the face's
    /// corners of the mesh.
    pub fn of_face(&self, corners: Range<usize>) -> ([u32; 2], impl ExactSizeIterator<Item = [f64; 2]>) {
        let across = self.lines[1].len();
        let at = move |corner: usize| [self.corners[corner] as usize / across, self.corners[corner] as usize % across];
        // Three corners are on both lines of each direction.
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
struct Bend([f64; 3]);

impl Bend {
    fn of<const N: usize>(patch: &Patch<N>) -> Bend {
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
        Bend([degree * (degree - 1.0) * uu, degree * degree * uv, degree * (degree - 1.0) * vv])
    }

    /// The deviation of triangles if a cell has m x n parts.
    fn deviation(&self, m: f64, n: f64) -> f64 {
        let [uu, uv, vv] = self.0;
        0.125 * (uu / (m * m) + 2.0 * uv / (m * n) + vv / (n * n))
    }
}

impl Sheet<'_> {
    /// A mesh of points of the sheet. O(cells + vertices).
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a tolerance that is not more than 0, or no parts;
    /// [`Error::TooLarge`] for more than 2^32 - 2 corners, [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn to_mesh(&self, options: &SurfaceMeshOptions, job: &Job<'_>) -> Result<SurfaceMesh> {
        Error::require(options.tolerance > 0.0, "tolerance", options.tolerance)?;
        Error::require(!options.least.contains(&0), "parts", 0.0)?;
        let lattice = Lattice::new(self, options, &job.part(0.0, 0.3))?;
        lattice.mesh(options.triangles, &job.part(0.3, 1.0))
    }

    fn bend(&self, i: usize, j: usize) -> Bend {
        each_sheet!(self, cells => Bend::of(&Cells::patch(cells, i, j)))
    }
}

/// The cell and the parameter of a line.
type Line = (u32, f64);

/// The lines of one direction, and whether each is one point.
fn lines(sheet: &Sheet<'_>, direction: usize, parts: &[f64], count: usize) -> Result<(Vec<Line>, Vec<bool>)> {
    let is_point = |cell: usize, end: bool| sheet.line_is_point(direction, cell, end);
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

/// The lines of a mesh on a sheet.
struct Lattice<'a> {
    sheet: &'a Sheet<'a>,
    /// In u, and in v; lines that close are not repeated.
    lines: [Vec<Line>; 2],
    /// Lines that are one point.
    points: [Vec<bool>; 2],
    /// If some are in both directions, the first one of v: all of them are one point then.
    meeting: Option<usize>,
    deviation: f64,
}

impl<'a> Lattice<'a> {
    fn new(sheet: &'a Sheet<'a>, options: &SurfaceMeshOptions, job: &Job<'_>) -> Result<Self> {
        let [rows, columns] = sheet.cells();
        let [least_u, least_v] = options.least.map(f64::from);
        let mut parts = [alloc::filled(least_u, rows)?, alloc::filled(least_v, columns)?];
        let least = |bound: f64| (0.5 * bound / options.tolerance).sqrt().ceil();
        let mut bends = alloc::with_capacity(rows * columns)?;
        for i in 0..rows {
            job.step(0.8 * i as f64 / rows as f64, "bounding second derivatives")?;
            for j in 0..columns {
                let bend = sheet.bend(i, j);
                parts[0][i] = parts[0][i].max(least(bend.0[0]));
                parts[1][j] = parts[1][j].max(least(bend.0[2]));
                bends.push(bend);
            }
        }
        // A quarter of the tolerance goes to S_uu and to S_vv each; twists may need more than these
        // have asked for.
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
            bends.iter().enumerate().map(|(k, of)| of.deviation(parts[0][k / columns], parts[1][k % columns]));
        let deviation = deviations.fold(0.0, f64::max);
        let (lines_u, points_u) = lines(sheet, 0, &parts[0], counts[0] as usize)?;
        let (lines_v, points_v) = lines(sheet, 1, &parts[1], counts[1] as usize)?;
        let meeting = if points_u.contains(&true) { points_v.iter().position(|&point| point) } else { None };
        Ok(Lattice { sheet, lines: [lines_u, lines_v], points: [points_u, points_v], meeting, deviation })
    }

    /// The vertex where lines meet, by number of the first lines that meet there.
    fn first(&self, a: usize, b: usize) -> (usize, usize) {
        let (a, b) = (a % self.lines[0].len(), b % self.lines[1].len());
        match (self.points[0][a], self.points[1][b], self.meeting) {
            (false, false, _) => (a, b),
            (_, _, Some(column)) => (0, column),
            (true, ..) => (a, 0),
            (false, true, None) => (0, b),
        }
    }

    fn mesh(&self, triangles: bool, job: &Job<'_>) -> Result<SurfaceMesh> {
        let [height, width] = [0, 1].map(|k| self.lines[k].len());
        let mut vertices = alloc::filled(u32::MAX, height * width)?;
        let (mut positions, mut places, mut normals) = (Vec::new(), Vec::new(), Vec::new());
        for a in 0..height {
            job.step(0.8 * a as f64 / height as f64, "evaluating")?;
            for b in (0..width).filter(|&b| self.first(a, b) == (a, b)) {
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
                    let (a, b) = self.first(a, b);
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
        let lines = ParameterLines { cells: self.sheet.cells(), lines: [with_end(0)?, with_end(1)?], corners: lattice };
        Ok(SurfaceMesh { mesh, places, normals, deviation: self.deviation, lines })
    }
}
