//! Recognition of a rectangular grid in the faces of a mesh.
//!
//! A cell is represented by the half-edge of its face from (i, j) to (i, j + 1). Its four
//! neighbours and their half-edges are a few half-edges away. A step in one direction is an
//! injective map, so a walk ends at the border, at a pole, or where it began. Every candidate is
//! verified cell by cell, so only grids are accepted. O(faces).

use crate::topology::{ContractedLinks, Seam, SeamRun};
use crate::{Net, Shape, Sides, Topology};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, NONE, Opposite, Topology as Pairing};

/// A net recognised in a mesh.
#[derive(Debug)]
pub struct RecognisedNet {
    /// The net, with the mesh's coordinates, closed where the mesh is.
    pub net: Net<'static>,
    /// For each node its vertex.
    pub vertex_of_node: Vec<u32>,
    /// For each cell its face.
    pub face_of_cell: Vec<u32>,
}

/// Returns the net whose cells are the faces of a mesh. The faces are quads in rows and columns,
/// which may be closed. At the first and the last row they may form fans of triangles around poles.
/// `seed` is a face of the component; without it the mesh must be connected. Rows run along the
/// first edge of the first quad, or around if only one direction is closed. O(H log d) for H
/// half-edges and vertices of degree d.
///
/// # Errors
/// [`Error::NoGrid`] with a face that violates the grid, [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub fn net_of_grid(mesh: &MeshView<'_>, seed: Option<u32>, job: &Job<'_>) -> Result<RecognisedNet> {
    let pairing = Pairing::new(mesh, &job.sub_job(0.0, 0.6))?;
    let walker = QuadWalker { mesh, pairing: &pairing };
    let grid = QuadGrid::find_from_face(&walker, seed, &job.sub_job(0.6, 0.8))?;
    job.step(0.8, STAGE)?;
    if seed.is_none() {
        let mut visited = alloc::filled(false, mesh.faces().len())?;
        grid.faces_by_cell(&walker).for_each(|face| visited[face as usize] = true);
        if let Some(face) = visited.iter().position(|visited| !visited) {
            return Err(Error::NoGrid { face: face as u32 });
        }
    }
    grid.build_net(&walker, &job.sub_job(0.8, 1.0))
}

/// Cells between two progress reports.
const CELLS_PER_REPORT: usize = 1 << 15;
const STAGE: &str = "rows to nodes";

/// The neighbour of a cell in a direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum CellNeighbour {
    /// A quad, by its representing half-edge.
    Quad(u32),
    /// A triangle, by its half-edge on the common edge.
    Triangle(u32),
    /// None; the quad is at the border.
    Border,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum GridHeading {
    Up,
    Right,
    Down,
    Left,
}

struct QuadWalker<'a> {
    mesh: &'a MeshView<'a>,
    pairing: &'a Pairing,
}

impl QuadWalker<'_> {
    fn face_of(&self, h: u32) -> u32 {
        self.mesh.faces().face_of_half_edge(h)
    }

    fn corner_count(&self, face: u32) -> usize {
        self.mesh.faces().corner_range(face as usize).len()
    }

    /// Returns the half-edge `k` places further around the face.
    fn advance_around_face(&self, h: u32, k: usize) -> u32 {
        (0..k).fold(h, |h, _| self.mesh.faces().next(h))
    }

    fn start_vertex(&self, h: u32) -> u32 {
        self.mesh.faces().corner(h)
    }

    /// Returns the third corner of a triangle.
    fn third_vertex_of_triangle(&self, h: u32) -> u32 {
        self.start_vertex(self.advance_around_face(h, 2))
    }

    /// Returns the error at the face of a half-edge.
    fn no_grid_error(&self, h: u32) -> Error {
        Error::NoGrid { face: self.face_of(h) }
    }

    /// Returns the neighbour of the quad of `h`.
    fn neighbour_of_quad(&self, h: u32, heading: GridHeading) -> Result<CellNeighbour> {
        let turns = heading as usize;
        let edge = self.advance_around_face(h, turns);
        if self.pairing.is_ignored(edge) {
            return Err(self.no_grid_error(h));
        }
        let mate = match self.pairing.opposite(edge) {
            Opposite::Free => return Ok(CellNeighbour::Border),
            Opposite::Singular => return Err(self.no_grid_error(h)),
            Opposite::Mate(mate) => mate,
        };
        // Faces of equal orientation traverse their common edge in opposite directions.
        if self.start_vertex(mate) == self.start_vertex(edge) {
            return Err(self.no_grid_error(mate));
        }
        match self.corner_count(self.face_of(mate)) {
            // Edge k of one face is edge k + 2 of the other.
            4 => Ok(CellNeighbour::Quad(self.advance_around_face(mate, (6 - turns) % 4))),
            3 => Ok(CellNeighbour::Triangle(mate)),
            _ => Err(self.no_grid_error(mate)),
        }
    }

    /// Returns the last cell of a walk and its neighbour, which is the first cell if the walk is
    /// closed.
    fn walk_to_end(&self, from: u32, heading: GridHeading) -> Result<(u32, CellNeighbour)> {
        let mut at = from;
        loop {
            match self.neighbour_of_quad(at, heading)? {
                CellNeighbour::Quad(next) if next != from => at = next,
                end => return Ok((at, end)),
            }
        }
    }
}

/// Rows of quads, by their representing half-edges, and the fans at the poles.
struct QuadGrid {
    cells: Vec<u32>,
    columns: usize,
    rows_closed: bool,
    /// The column of the first row below the first cell of the last row, if columns are closed.
    column_below_last_row: Option<usize>,
    /// The fans of triangles before the first and after the last row, as their half-edges shared
    /// with quads.
    pole_fans: [Option<Vec<u32>>; 2],
}

impl QuadGrid {
    fn find_from_face(walker: &QuadWalker<'_>, start_face: Option<u32>, job: &Job<'_>) -> Result<QuadGrid> {
        let head = QuadGrid::find_top_left_cell(walker, start_face)?;
        let mut grid = QuadGrid {
            cells: Vec::new(),
            columns: 0,
            rows_closed: false,
            column_below_last_row: None,
            pole_fans: [None, None],
        };
        let count = walker.mesh.faces().len();
        grid.add_row(walker, head)?;
        let (mut row, mut next_report) = (head, 0);
        while let CellNeighbour::Quad(next) = walker.neighbour_of_quad(row, GridHeading::Down)? {
            if grid.cells.len() >= next_report {
                job.step(0.5 * grid.cells.len() as f64 / count as f64, STAGE)?;
                next_report = grid.cells.len() + CELLS_PER_REPORT;
            }
            grid.column_below_last_row = grid.cells[..grid.columns].iter().position(|&cell| cell == next);
            if grid.column_below_last_row.is_some() {
                break;
            }
            grid.add_row(walker, next)?;
            row = next;
            // More rows than faces: the walk is endless, so the mesh is not a grid.
            if grid.cells.len() > count {
                return Err(walker.no_grid_error(row));
            }
        }
        grid.check_rows_and_columns(walker, &job.sub_job(0.5, 1.0))?;
        let last = grid.cells.len() - grid.columns;
        grid.pole_fans = [
            grid.triangle_fan_at_pole(walker, 0, GridHeading::Up)?,
            grid.triangle_fan_at_pole(walker, last, GridHeading::Down)?,
        ];
        Ok(grid)
    }

    /// Returns the first cell of the first row of quads.
    fn find_top_left_cell(walker: &QuadWalker<'_>, start_face: Option<u32>) -> Result<u32> {
        let face = start_face.unwrap_or(0);
        let faces = walker.mesh.faces();
        if face as usize >= faces.len() {
            return Err(Error::NoGrid { face });
        }
        let first = faces.corner_range(face as usize).start as u32;
        let quad = match walker.corner_count(face) {
            4 => first,
            // A triangle at a pole has a quad across the side opposite the pole.
            3 => {
                let across = |k: usize| match walker.pairing.opposite(walker.advance_around_face(first, k)) {
                    Opposite::Mate(mate) if walker.corner_count(walker.face_of(mate)) == 4 => Some(mate),
                    _ => None,
                };
                if walker.pairing.is_ignored(first) {
                    return Err(Error::NoGrid { face });
                }
                let mate = (0..3).find_map(across).ok_or(Error::NoGrid { face })?;
                faces.corner_range(walker.face_of(mate) as usize).start as u32
            }
            _ => return Err(Error::NoGrid { face }),
        };
        let ends = |h: u32, heading: GridHeading| walker.walk_to_end(h, heading).map(|(_, end)| end);
        let sideways = [ends(quad, GridHeading::Left)?, ends(quad, GridHeading::Right)?];
        let pole_aside = sideways.iter().any(|end| matches!(end, CellNeighbour::Triangle(_)));
        let closed_up = matches!(ends(quad, GridHeading::Up)?, CellNeighbour::Quad(_));
        let turn = pole_aside || (closed_up && !matches!(sideways[0], CellNeighbour::Quad(_)));
        let mut head = if turn { walker.advance_around_face(quad, 1) } else { quad };
        for heading in [GridHeading::Left, GridHeading::Up] {
            let (last, end) = walker.walk_to_end(head, heading)?;
            // Closed rows and columns start at the first quad.
            if !matches!(end, CellNeighbour::Quad(_)) {
                head = last;
            }
        }
        Ok(head)
    }

    /// Adds the row that starts with a cell.
    fn add_row(&mut self, walker: &QuadWalker<'_>, first_cell: u32) -> Result<()> {
        let start = self.cells.len();
        let mut at = first_cell;
        let closed = loop {
            alloc::push(&mut self.cells, at)?;
            match walker.neighbour_of_quad(at, GridHeading::Right)? {
                CellNeighbour::Quad(next) if next == first_cell => break true,
                CellNeighbour::Quad(next) => at = next,
                CellNeighbour::Border => break false,
                CellNeighbour::Triangle(h) => return Err(walker.no_grid_error(h)),
            }
        };
        let columns = self.cells.len() - start;
        if start == 0 {
            (self.columns, self.rows_closed) = (columns, closed);
        }
        if (columns, closed) == (self.columns, self.rows_closed) {
            Ok(())
        } else {
            Err(walker.no_grid_error(first_cell))
        }
    }

    /// Verifies that each cell is above the next one of its column, that rows start at the border,
    /// and that no face occurs twice.
    fn check_rows_and_columns(&self, walker: &QuadWalker<'_>, job: &Job<'_>) -> Result<()> {
        let mut visited = alloc::filled(false, walker.mesh.faces().len())?;
        let rows = self.cells.len() / self.columns;
        for (k, &cell) in self.cells.iter().enumerate() {
            job.step_every(CELLS_PER_REPORT, k, self.cells.len(), STAGE)?;
            if std::mem::replace(&mut visited[walker.face_of(cell) as usize], true) {
                return Err(walker.no_grid_error(cell));
            }
            let (i, j) = (k / self.columns, k % self.columns);
            let below = match (i + 1 == rows, self.column_below_last_row) {
                (false, _) => self.cells.get(k + self.columns),
                (true, Some(shift)) if self.rows_closed => self.cells.get((j + shift) % self.columns),
                (true, Some(0)) => self.cells.get(j),
                (true, Some(_)) => return Err(walker.no_grid_error(cell)),
                (true, None) => None,
            };
            match (walker.neighbour_of_quad(cell, GridHeading::Down)?, below) {
                (CellNeighbour::Quad(next), Some(&below)) if next == below => {}
                (CellNeighbour::Border | CellNeighbour::Triangle(_), None) => {}
                _ => return Err(walker.no_grid_error(cell)),
            }
            if j == 0
                && !self.rows_closed
                && walker.neighbour_of_quad(cell, GridHeading::Left)? != CellNeighbour::Border
            {
                return Err(walker.no_grid_error(cell));
            }
            if i == 0
                && self.column_below_last_row.is_none()
                && matches!(walker.neighbour_of_quad(cell, GridHeading::Up)?, CellNeighbour::Quad(_))
            {
                return Err(walker.no_grid_error(cell));
            }
        }
        Ok(())
    }

    /// Returns the fan beyond the row that starts at `first`. Either every cell has a triangle, and
    /// all have the same third corner, or none has one.
    fn triangle_fan_at_pole(
        &self,
        walker: &QuadWalker<'_>,
        first: usize,
        heading: GridHeading,
    ) -> Result<Option<Vec<u32>>> {
        if self.column_below_last_row.is_some() {
            return Ok(None);
        }
        let mut triangles = Vec::new();
        let mut apex = None;
        for &cell in &self.cells[first..first + self.columns] {
            match walker.neighbour_of_quad(cell, heading)? {
                CellNeighbour::Triangle(h)
                    if *apex.get_or_insert(walker.third_vertex_of_triangle(h))
                        == walker.third_vertex_of_triangle(h) =>
                {
                    // Neighbours must share the edge to the pole; otherwise the surface would be
                    // open there.
                    alloc::push(&mut triangles, h)?;
                }
                CellNeighbour::Border if triangles.is_empty() => {}
                _ => return Err(walker.no_grid_error(cell)),
            }
        }
        match triangles.len() {
            0 => Ok(None),
            n if n == self.columns => Ok(Some(triangles)),
            _ => Err(walker.no_grid_error(self.cells[first])),
        }
    }

    /// Returns the faces, cell by cell.
    fn faces_by_cell(&self, walker: &QuadWalker<'_>) -> impl Iterator<Item = u32> {
        let [top, bottom] = self.pole_fans.each_ref().map(|pole| pole.as_deref().unwrap_or_default());
        top.iter().chain(&self.cells).chain(bottom).map(|&h| walker.face_of(h))
    }

    fn build_net(&self, walker: &QuadWalker<'_>, job: &Job<'_>) -> Result<RecognisedNet> {
        job.step(0.0, STAGE)?;
        let poles = self.pole_fans.each_ref().map(Option::is_some);
        let quads = self.cells.len() / self.columns;
        let rows = quads + 1 + usize::from(poles[0]) + usize::from(poles[1]);
        let shape = Shape::new(rows, self.columns + 1)?;
        let vertex_of_node = self.vertices_of_nodes(walker, shape)?;
        let face_of_cell = alloc::gather(self.faces_by_cell(walker))?;
        job.step(0.3, STAGE)?;
        let topology = self.build_topology(shape, &vertex_of_node, walker.mesh.positions().len())?;
        job.step(0.6, STAGE)?;
        let positions = walker.mesh.positions();
        let net = Net::from_fn(topology, positions.scalar(), |i, j| {
            positions.get(vertex_of_node[shape.node(i, j) as usize])
        })?;
        Ok(RecognisedNet { net, vertex_of_node, face_of_cell })
    }

    /// For each node its vertex.
    fn vertices_of_nodes(&self, walker: &QuadWalker<'_>, shape: Shape) -> Result<Vec<u32>> {
        let mut vertices = alloc::with_capacity(shape.node_count())?;
        let apex = |pole: &Option<Vec<u32>>| pole.as_ref().map(|pole| walker.third_vertex_of_triangle(pole[0]));
        let [top, bottom] = self.pole_fans.each_ref().map(apex);
        vertices.extend(top.into_iter().flat_map(|apex| std::iter::repeat_n(apex, shape.columns())));
        let mut add_row = |row: &[u32], corners: [usize; 2]| {
            vertices.extend(row.iter().map(|&cell| walker.start_vertex(walker.advance_around_face(cell, corners[0]))));
            vertices.extend(row.last().map(|&cell| walker.start_vertex(walker.advance_around_face(cell, corners[1]))));
        };
        for row in self.cells.chunks_exact(self.columns) {
            add_row(row, [0, 1]);
        }
        add_row(&self.cells[self.cells.len() - self.columns..], [3, 2]);
        vertices.extend(bottom.into_iter().flat_map(|apex| std::iter::repeat_n(apex, shape.columns())));
        Ok(vertices)
    }

    /// Returns the gluing: nodes of the same vertex.
    fn build_topology(&self, shape: Shape, vertices: &[u32], vertex_count: usize) -> Result<Topology> {
        let sides = Sides {
            rows_closed: self.rows_closed,
            columns_closed: self.column_below_last_row == Some(0),
            pole_top: self.pole_fans[0].is_some(),
            pole_bottom: self.pole_fans[1].is_some(),
            ..Sides::SHEET
        };
        let mut seams = Vec::new();
        if let Some(shift) = self.column_below_last_row.filter(|&shift| shift > 0) {
            // The last row is the first row from another column on: up to its end, and from its
            // start.
            let (last, end) = (shape.rows() as u32 - 1, self.columns as u32);
            let shift = shift as u32;
            let pairs = [(0, shift, end + 1 - shift), (end - shift, 0, shift + 1)];
            for (from, to, count) in pairs {
                alloc::push(
                    &mut seams,
                    Seam { a: SeamRun::along_row(last, from, 1), b: SeamRun::along_row(0, to, 1), count },
                )?;
            }
        }
        let closed = Topology::new(shape, ContractedLinks::Sides(sides), &seams)?;
        // Nodes of one vertex that are not glued yet: the surface touches itself there.
        let mut sets = DisjointSets::new(shape.node_count())?;
        let links = closed.contracted_links().map(|link| shape.ends_of_link(link));
        for [a, b] in links.chain(seams.iter().flat_map(|seam| seam.pairs(shape))) {
            sets.union(a, b);
        }
        let mut first = alloc::filled(NONE, vertex_count)?;
        let mut touches = false;
        for (node, &vertex) in (0..).zip(vertices) {
            let first = &mut first[vertex as usize];
            if *first == NONE {
                *first = node;
            } else if sets.union(*first, node) {
                let [a, b] =
                    [*first, node].map(|node| shape.row_and_column(node)).map(|(i, j)| SeamRun::stationary(i, j));
                alloc::push(&mut seams, Seam { a, b, count: 1 })?;
                touches = true;
            }
        }
        if touches { Topology::new(shape, ContractedLinks::Sides(sides), &seams) } else { Ok(closed) }
    }
}
