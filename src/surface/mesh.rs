//! Meshes of sheets within a tolerance.
//!
//! All cells of a row have equally many parts in u, and all of a column in v, so that neighbours
//! fit. A triangle with the sides a and b in the parameters is within (M_uu a^2 + 2 M_uv a b + M_vv
//! b^2) / 8 of the surface, M bounds of the second derivatives (Filip, Magedson and Markot 1986,
//! "Surface algorithms using bounds on derivatives"); bounds come from control nets.

use super::cells::Cells;
use super::{Patch, Place, Sheet, each_sheet};
use crate::mesh::{MAX_ELEMENTS, Mesh, PositionBuffer};
use crate::surface::prelude::*;

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
        let mut add = |face: &[u32]| -> Result<()> {
            let mut corners: Vec<u32> = Vec::with_capacity(4);
            for (k, &corner) in face.iter().enumerate() {
                if corner != face[(k + 1) % face.len()] && !corners.contains(&corner) {
                    corners.push(corner);
                }
            }
            if corners.len() > 2 {
                alloc::append(&mut face_corners, &corners)?;
                alloc::push(&mut face_offsets, face_corners.len() as u32)?;
            }
            Ok(())
        };
        for a in 0..tall {
            job.step(0.8 + 0.2 * a as f64 / tall as f64, "making faces")?;
            for b in 0..wide {
                let [p, q, r, s] = [(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)].map(|(a, b)| {
                    let (a, b) = self.first(a, b);
                    vertices[a * width + b]
                });
                if triangles {
                    add(&[p, q, r])?;
                    add(&[p, r, s])?;
                } else {
                    add(&[p, q, r, s])?;
                }
            }
        }
        let mesh = Mesh { positions: PositionBuffer::F64(positions), face_offsets, face_corners };
        Ok(SurfaceMesh { mesh, places, normals, deviation: self.deviation })
    }
}
