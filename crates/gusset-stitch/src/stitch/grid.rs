//! The paper's matrix P: rows of vertices between the rims with one column for each meridian, and
//! the faces between them.
//!
//! Row 0 lists the vertices of rim A, meridian by meridian, and the last row lists the vertices of
//! rim B. Both repeat a vertex if several meridians meet in it. The interior rows divide each
//! meridian evenly; their vertices are new. Four neighbours in P form a quad, or a triangle where P
//! repeats a vertex. The last column of a closed band repeats the first.
//!
//! Rim A has its surface on the left, and rim B on the right, so that the rims run side by side.
//! The old faces run A_i -> A_i+1 and B_j+1 -> B_j, so the new faces run P(r, c+1) -> P(r, c) ->
//! P(r+1, c) -> P(r+1, c+1).

use super::existing_edges::ExistingEdges;
use super::meridian::MeridianEnds;
use super::stitch_rim::Rim;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_mesh::MAX_ELEMENTS;

/// The matrix P in the strip's own vertex numbers: rim A's vertices, then rim B's, then the new
/// ones row by row.
pub(crate) struct MeridianGrid {
    rows: usize,
    columns: usize,
    /// The number of distinct columns: one less than `columns` if the band is closed.
    distinct: usize,
    /// (rows + 2) x columns.
    pub(super) matrix: Vec<u32>,
    /// The positions of all vertices, in the rims' unit.
    pub(crate) points: Vec<DVec3>,
    /// For each new vertex, its column, and its fraction of the way from A to B.
    pub(super) columns_and_fractions: Vec<(usize, f64)>,
}

/// A list of faces: the corners, and the offset of each face.
pub(crate) struct FaceList {
    pub(super) offsets: Vec<u32>,
    pub(super) corners: Vec<u32>,
}

impl MeridianGrid {
    /// Creates the matrix over `pairs` with `rows` interior rows.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::OutOfMemory`].
    pub(super) fn new(a: &Rim, b: &Rim, pairs: &[MeridianEnds], rows: u32) -> Result<MeridianGrid> {
        let (n, m) = (a.vertices.len(), b.vertices.len());
        let columns = pairs.len();
        // A single meridian spans no face, and gets no rows.
        let rows = if columns < 2 { 0 } else { rows as usize };
        let distinct = if a.closed { columns - 1 } else { columns };
        let total = (rows as u64 + 2) * columns as u64 + (n + m) as u64;
        Error::check_count("corners of the strip", 4 * total, MAX_ELEMENTS)?;
        let mut grid = MeridianGrid {
            rows,
            columns,
            distinct,
            matrix: alloc::with_capacity((rows + 2) * columns)?,
            points: alloc::with_capacity(n + m + rows * distinct)?,
            columns_and_fractions: alloc::with_capacity(rows * distinct)?,
        };
        grid.points.extend(a.points.iter().chain(&b.points));
        grid.matrix.extend(pairs.iter().map(|&[i, _]| i % n as u32));
        for row in 1..=rows {
            let t = row as f64 / (rows + 1) as f64;
            for (column, &[i, j]) in pairs[..distinct].iter().enumerate() {
                grid.matrix.push(grid.points.len() as u32);
                grid.points.push(a.point(i).lerp(b.point(j), t));
                grid.columns_and_fractions.push((column, t));
            }
            if a.closed {
                grid.matrix.push(grid.matrix[row * columns]);
            }
        }
        grid.matrix.extend(pairs.iter().map(|&[_, j]| n as u32 + j % m as u32));
        Ok(grid)
    }

    /// Returns the position of new vertex `k` in a regular grid with edges of length 1: on a
    /// cylinder, or in a plane for an open strip.
    pub(super) fn regular_grid_position(&self, k: usize) -> DVec3 {
        let (column, t) = self.columns_and_fractions[k];
        let (along, up) = (column as f64, t * (self.rows + 1) as f64);
        if self.distinct == self.columns {
            return DVec3::new(along, 0.0, up);
        }
        let round = std::f64::consts::TAU / self.distinct as f64;
        DVec3::new(libm::cos(along * round) / round, libm::sin(along * round) / round, up)
    }

    pub(super) fn row_count(&self) -> u32 {
        self.rows as u32
    }

    fn vertex_at(&self, row: usize, column: usize) -> u32 {
        self.matrix[row * self.columns + column]
    }

    /// Returns the ends of each new vertex's meridian as strip vertices: one on rim A, and one on
    /// rim B.
    pub(super) fn meridian_ends(&self) -> impl ExactSizeIterator<Item = [u32; 2]> + '_ {
        self.columns_and_fractions
            .iter()
            .map(|&(column, _)| [self.vertex_at(0, column), self.vertex_at(self.rows + 1, column)])
    }

    /// Returns the faces, meridian by meridian from A to B. If `quads`, four distinct neighbours
    /// form one face; otherwise they are split by the shorter diagonal.
    ///
    /// # Errors
    /// [`Error::NoStrip`] if a meridian without interior vertices, or both diagonals of a quad in a
    /// strip without rows, repeat an existing edge of the mesh.
    pub(super) fn build_faces(&self, a: &Rim, b: &Rim, existing: &ExistingEdges, quads: bool) -> Result<FaceList> {
        let n = a.vertices.len() as u32;
        let existing = (self.rows == 0 && !existing.is_empty()).then_some(existing);
        // Vertices of A have numbers below n. Without interior rows the other vertices are on B.
        let taken = |p: u32, q: u32| {
            let (i, j) = (p.min(q), p.max(q));
            existing.is_some_and(|existing| existing.forbid(a, b, [i as usize, (j - n) as usize]))
        };
        let blocked = |p: u32| Err(Error::NoStrip { vertex: a.vertices[p.min(n - 1) as usize] });
        let flipped = if self.rows == 0 && a.closed && !quads { self.quad_to_flip(n, &taken) } else { None };

        let cells = (self.columns - 1) * (self.rows + 1);
        let mut list =
            FaceList { offsets: alloc::with_capacity(2 * cells + 1)?, corners: alloc::with_capacity(6 * cells)? };
        list.offsets.push(0);
        for column in 0..self.distinct {
            if taken(self.vertex_at(0, column), self.vertex_at(self.rows + 1, column)) {
                return blocked(self.vertex_at(0, column));
            }
        }
        for column in 0..self.columns - 1 {
            for row in 0..=self.rows {
                let [p, q] = [self.vertex_at(row, column + 1), self.vertex_at(row, column)];
                let [r, s] = [self.vertex_at(row + 1, column), self.vertex_at(row + 1, column + 1)];
                match (p == q, r == s) {
                    (true, true) => {}
                    (true, false) => list.push(&[q, r, s]),
                    (false, true) => list.push(&[p, q, r]),
                    (false, false) if quads => list.push(&[p, q, r, s]),
                    (false, false) => match self.is_split_by_pr([p, q, r, s], &taken) {
                        None => return blocked(q),
                        Some(by_pr) if by_pr != (flipped == Some(column)) => {
                            list.push(&[p, q, r]);
                            list.push(&[p, r, s]);
                        }
                        Some(_) => {
                            list.push(&[p, q, s]);
                            list.push(&[q, r, s]);
                        }
                    },
                }
            }
        }
        Ok(list)
    }

    /// Returns true to split the quad p q r s by the diagonal pr, false for qs, and `None` if both
    /// diagonals repeat an edge.
    fn is_split_by_pr(&self, [p, q, r, s]: [u32; 4], taken: &impl Fn(u32, u32) -> bool) -> Option<bool> {
        let squared = |u: u32, v: u32| self.points[u as usize].distance_squared(self.points[v as usize]);
        match (taken(p, r), taken(q, s)) {
            (true, true) => None,
            (pr_taken, qs_taken) => Some(!pr_taken && (qs_taken || squared(p, r) <= squared(q, s))),
        }
    }

    /// Returns the column of the quad to split by its other diagonal, so that a closed strip
    /// without interior rows does not repeat an edge. `n` is the number of vertices on A.
    ///
    /// With its diagonals, the strip is a path of single steps. It does not repeat an edge if at
    /// least one step on A is away from B_0, and at least one step on B is away from A_0. One flip
    /// suffices, because rims have at least three vertices.
    fn quad_to_flip(&self, n: u32, taken: &impl Fn(u32, u32) -> bool) -> Option<usize> {
        let cell = |column: usize| {
            [
                self.vertex_at(0, column + 1),
                self.vertex_at(0, column),
                self.vertex_at(1, column),
                self.vertex_at(1, column + 1),
            ]
        };
        // Counts the steps on A away from B_0, and on B away from A_0.
        let steps = |[p, q, r, s]: [u32; 4], by_pr: bool| match (p == q, r == s) {
            (true, _) => [0, u32::from(p != 0)],
            (false, true) => [u32::from(r != n), 0],
            (false, false) if by_pr => [u32::from(r != n), u32::from(p != 0)],
            (false, false) => [u32::from(s != n), u32::from(q != 0)],
        };
        let chosen = |column: usize| steps(cell(column), self.is_split_by_pr(cell(column), taken) == Some(true));
        let sum = (0..self.columns - 1).map(chosen).fold([0, 0], |x, y| [x[0] + y[0], x[1] + y[1]]);
        if sum[0] > 0 && sum[1] > 0 {
            return None;
        }
        (0..self.columns - 1).find(|&column| {
            let [p, q, r, s] = cell(column);
            let by_pr = self.is_split_by_pr([p, q, r, s], taken) == Some(true);
            let other = steps([p, q, r, s], !by_pr);
            let is_free = if by_pr { !taken(q, s) } else { !taken(p, r) };
            let is_enough = |k: usize| sum[k] + other[k] > chosen(column)[k];
            p != q && r != s && is_free && is_enough(0) && is_enough(1)
        })
    }
}

impl FaceList {
    /// Appends a face. The capacity was reserved on creation.
    pub(crate) fn push(&mut self, face: &[u32]) {
        self.corners.extend_from_slice(face);
        self.offsets.push(self.corners.len() as u32);
    }

    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        self.offsets.windows(2).map(|w| &self.corners[w[0] as usize..w[1] as usize])
    }
}
