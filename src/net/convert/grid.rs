//! Nets of meshes whose faces are a rectangular grid.
//!
//! A cell of a grid is known by the half-edge of its face that runs from (i, j) to (i, j + 1). From there its four neighbours are
//! a few half-edges away, and so is the half-edge that they are known by. To go right, say, as far as it goes is therefore to
//! follow a map that is one to one, and ends at the border, at a pole, or where it began.

use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::mesh::{Across, MeshView, NONE, Topology as Pairing};
use crate::net::topology::{Forest, Links, Run, Seam};
use crate::net::{Net, Shape, Sides, Topology};

/// A net that was found in a mesh.
#[derive(Debug)]
pub struct GridNet {
    /// The net, of the mesh's own coordinates, closed where the mesh is.
    pub net: Net<'static>,
    /// For each node its vertex.
    pub vertex_of_node: Vec<u32>,
    /// For each cell its face.
    pub face_of_cell: Vec<u32>,
}

/// The net whose cells are the faces of a mesh: quads in rows and columns, which may be closed round, and at the first and the
/// last row a fan of triangles round a pole each. `seed`: a face of the component that is meant; without it the mesh must have no
/// other. Rows run as the first quad says, and round if only one direction is closed. O(H log d) for H half-edges and vertices
/// of degree d.
///
/// # Errors
/// [`Error::NoGrid`] with a face that shows it, [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn net_of_grid(mesh: &MeshView<'_>, seed: Option<u32>, job: &Job<'_>) -> Result<GridNet> {
    let pairing = Pairing::new(mesh, &job.part(0.0, 0.6))?;
    let walker = Walker { mesh, pairing: &pairing };
    let grid = Grid::find(&walker, seed, &job.part(0.6, 0.8))?;
    job.step(0.8, STAGE)?;
    if seed.is_none() {
        let mut visited = alloc::filled(false, mesh.faces().len())?;
        grid.faces(&walker).for_each(|face| visited[face as usize] = true);
        if let Some(face) = visited.iter().position(|visited| !visited) {
            return Err(Error::NoGrid { face: face as u32 });
        }
    }
    grid.net(&walker, &job.part(0.8, 1.0))
}

/// Cells between two progress reports.
const STEP: usize = 1 << 15;
const STAGE: &str = "rows to nodes";

/// Where a step leads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Step {
    /// To a quad, known by this half-edge.
    Cell(u32),
    /// To a triangle: the half-edge that was crossed, as its own.
    Triangle(u32),
    /// Over the border.
    End,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Up,
    Right,
    Down,
    Left,
}

struct Walker<'a> {
    mesh: &'a MeshView<'a>,
    pairing: &'a Pairing,
}

impl Walker<'_> {
    fn face(&self, h: u32) -> u32 {
        self.mesh.faces().face_of(h)
    }

    fn size(&self, face: u32) -> usize {
        self.mesh.faces().range(face as usize).len()
    }

    /// `k` half-edges on round the face.
    fn on(&self, h: u32, k: usize) -> u32 {
        (0..k).fold(h, |h, _| self.mesh.faces().next(h))
    }

    fn start(&self, h: u32) -> u32 {
        self.mesh.faces().corner(h)
    }

    fn no_grid(&self, h: u32) -> Error {
        Error::NoGrid { face: self.face(h) }
    }

    /// The neighbour of the quad of `h`.
    fn step(&self, h: u32, way: Way) -> Result<Step> {
        let turns = way as usize;
        let edge = self.on(h, turns);
        if self.pairing.is_ignored(edge) {
            return Err(self.no_grid(h));
        }
        let mate = match self.pairing.across(edge) {
            Across::Free => return Ok(Step::End),
            Across::Singular => return Err(self.no_grid(h)),
            Across::Mate(mate) => mate,
        };
        // Faces of one orientation run their common edge in opposite directions.
        if self.start(mate) == self.start(edge) {
            return Err(self.no_grid(mate));
        }
        match self.size(self.face(mate)) {
            // Edge k of the one is edge k + 2 of the other.
            4 => Ok(Step::Cell(self.on(mate, (6 - turns) % 4))),
            3 => Ok(Step::Triangle(mate)),
            _ => Err(self.no_grid(mate)),
        }
    }

    /// As far as it goes: the last cell, and what is behind it, which is the first cell again if the way is closed.
    fn far(&self, from: u32, way: Way) -> Result<(u32, Step)> {
        let mut at = from;
        loop {
            match self.step(at, way)? {
                Step::Cell(next) if next != from => at = next,
                end => return Ok((at, end)),
            }
        }
    }
}

/// Rows of cells, each known by its half-edge, without those at poles.
struct Grid {
    cells: Vec<u32>,
    columns: usize,
    rows_closed: bool,
    /// The column of the first row that the first column of the last row leads down to.
    shift: Option<usize>,
    /// The triangles round the first and the last row's pole, as the half-edges that they share with quads.
    poles: [Option<Vec<u32>>; 2],
}

impl Grid {
    fn find(walker: &Walker<'_>, seed: Option<u32>, job: &Job<'_>) -> Result<Grid> {
        let head = Grid::head(walker, seed)?;
        let mut grid = Grid { cells: Vec::new(), columns: 0, rows_closed: false, shift: None, poles: [None, None] };
        let count = walker.mesh.faces().len();
        grid.add_row(walker, head)?;
        let (mut row, mut next_report) = (head, 0);
        while let Step::Cell(next) = walker.step(row, Way::Down)? {
            if grid.cells.len() >= next_report {
                job.step(0.5 * grid.cells.len() as f64 / count as f64, STAGE)?;
                next_report = grid.cells.len() + STEP;
            }
            grid.shift = grid.cells[..grid.columns].iter().position(|&cell| cell == next);
            if grid.shift.is_some() {
                break;
            }
            grid.add_row(walker, next)?;
            row = next;
            // Rows are no more than faces; a way that never ends is none of a grid.
            if grid.cells.len() > count {
                return Err(walker.no_grid(row));
            }
        }
        grid.check(walker, &job.part(0.5, 1.0))?;
        let last = grid.cells.len() - grid.columns;
        grid.poles = [grid.pole(walker, 0, Way::Up)?, grid.pole(walker, last, Way::Down)?];
        Ok(grid)
    }

    /// The first cell of the first row of quads.
    fn head(walker: &Walker<'_>, seed: Option<u32>) -> Result<u32> {
        let face = seed.unwrap_or(0);
        let faces = walker.mesh.faces();
        if face as usize >= faces.len() {
            return Err(Error::NoGrid { face });
        }
        let first = faces.range(face as usize).start as u32;
        let quad = match walker.size(face) {
            4 => first,
            // A triangle at a pole has a quad across the side that is no meridian.
            3 => {
                let across = |k: usize| match walker.pairing.across(walker.on(first, k)) {
                    Across::Mate(mate) if walker.size(walker.face(mate)) == 4 => Some(mate),
                    _ => None,
                };
                if walker.pairing.is_ignored(first) {
                    return Err(Error::NoGrid { face });
                }
                let mate = (0..3).find_map(across).ok_or(Error::NoGrid { face })?;
                faces.range(walker.face(mate) as usize).start as u32
            }
            _ => return Err(Error::NoGrid { face }),
        };
        let ends = |h: u32, way: Way| walker.far(h, way).map(|(_, end)| end);
        let sideways = [ends(quad, Way::Left)?, ends(quad, Way::Right)?];
        let pole_aside = sideways.iter().any(|end| matches!(end, Step::Triangle(_)));
        let closed_up = matches!(ends(quad, Way::Up)?, Step::Cell(_));
        let turn = pole_aside || (closed_up && !matches!(sideways[0], Step::Cell(_)));
        let mut head = if turn { walker.on(quad, 1) } else { quad };
        for way in [Way::Left, Way::Up] {
            let (last, end) = walker.far(head, way)?;
            // Closed rows and columns begin where the first quad is.
            if !matches!(end, Step::Cell(_)) {
                head = last;
            }
        }
        Ok(head)
    }

    /// Adds the row that begins with a cell.
    fn add_row(&mut self, walker: &Walker<'_>, head: u32) -> Result<()> {
        let start = self.cells.len();
        let mut at = head;
        let closed = loop {
            alloc::push(&mut self.cells, at)?;
            match walker.step(at, Way::Right)? {
                Step::Cell(next) if next == head => break true,
                Step::Cell(next) => at = next,
                Step::End => break false,
                Step::Triangle(h) => return Err(walker.no_grid(h)),
            }
        };
        let columns = self.cells.len() - start;
        if start == 0 {
            (self.columns, self.rows_closed) = (columns, closed);
        }
        if (columns, closed) == (self.columns, self.rows_closed) { Ok(()) } else { Err(walker.no_grid(head)) }
    }

    /// Every cell is above the one below it, rows begin at the border, and no face is in the grid twice.
    fn check(&self, walker: &Walker<'_>, job: &Job<'_>) -> Result<()> {
        let mut visited = alloc::filled(false, walker.mesh.faces().len())?;
        let rows = self.cells.len() / self.columns;
        for (k, &cell) in self.cells.iter().enumerate() {
            if k % STEP == 0 {
                job.step(k as f64 / self.cells.len() as f64, STAGE)?;
            }
            if std::mem::replace(&mut visited[walker.face(cell) as usize], true) {
                return Err(walker.no_grid(cell));
            }
            let (i, j) = (k / self.columns, k % self.columns);
            let below = match (i + 1 == rows, self.shift) {
                (false, _) => self.cells.get(k + self.columns),
                (true, Some(shift)) if self.rows_closed => self.cells.get((j + shift) % self.columns),
                (true, Some(0)) => self.cells.get(j),
                (true, Some(_)) => return Err(walker.no_grid(cell)),
                (true, None) => None,
            };
            match (walker.step(cell, Way::Down)?, below) {
                (Step::Cell(next), Some(&below)) if next == below => {}
                (Step::End | Step::Triangle(_), None) => {}
                _ => return Err(walker.no_grid(cell)),
            }
            if j == 0 && !self.rows_closed && walker.step(cell, Way::Left)? != Step::End {
                return Err(walker.no_grid(cell));
            }
            if i == 0 && self.shift.is_none() && matches!(walker.step(cell, Way::Up)?, Step::Cell(_)) {
                return Err(walker.no_grid(cell));
            }
        }
        Ok(())
    }

    /// The triangles beyond the row that begins at `first`: all of its cells have one, and they share their third corner; or none.
    fn pole(&self, walker: &Walker<'_>, first: usize, way: Way) -> Result<Option<Vec<u32>>> {
        if self.shift.is_some() {
            return Ok(None);
        }
        let mut triangles = Vec::new();
        let mut apex = None;
        for &cell in &self.cells[first..first + self.columns] {
            match walker.step(cell, way)? {
                Step::Triangle(h)
                    if *apex.get_or_insert(walker.start(walker.on(h, 2))) == walker.start(walker.on(h, 2)) =>
                {
                    // Neighbours share the edge to the pole: what is no fan would be open there.
                    alloc::push(&mut triangles, h)?;
                }
                Step::End if triangles.is_empty() => {}
                _ => return Err(walker.no_grid(cell)),
            }
        }
        match triangles.len() {
            0 => Ok(None),
            n if n == self.columns => Ok(Some(triangles)),
            _ => Err(walker.no_grid(self.cells[first])),
        }
    }

    /// The faces, cell by cell.
    fn faces(&self, walker: &Walker<'_>) -> impl Iterator<Item = u32> {
        let [top, bottom] = self.poles.each_ref().map(|pole| pole.as_deref().unwrap_or_default());
        top.iter().chain(&self.cells).chain(bottom).map(|&h| walker.face(h))
    }

    fn net(&self, walker: &Walker<'_>, job: &Job<'_>) -> Result<GridNet> {
        job.step(0.0, STAGE)?;
        let poles = self.poles.each_ref().map(Option::is_some);
        let quads = self.cells.len() / self.columns;
        let rows = quads + 1 + usize::from(poles[0]) + usize::from(poles[1]);
        let shape = Shape::new(rows, self.columns + 1)?;
        let vertex_of_node = self.vertices(walker, shape)?;
        let mut face_of_cell = alloc::with_capacity(shape.cell_count())?;
        face_of_cell.extend(self.faces(walker));
        job.step(0.3, STAGE)?;
        let topology = self.topology(shape, &vertex_of_node, walker.mesh.positions().len())?;
        job.step(0.6, STAGE)?;
        let positions = walker.mesh.positions();
        let net = Net::from_fn(topology, positions.scalar(), |i, j| {
            positions.get(vertex_of_node[shape.node(i, j) as usize])
        })?;
        Ok(GridNet { net, vertex_of_node, face_of_cell })
    }

    /// For each node its vertex.
    fn vertices(&self, walker: &Walker<'_>, shape: Shape) -> Result<Vec<u32>> {
        let mut vertices = alloc::with_capacity(shape.node_count())?;
        let apex = |pole: &Option<Vec<u32>>| pole.as_ref().map(|pole| walker.start(walker.on(pole[0], 2)));
        let [top, bottom] = self.poles.each_ref().map(apex);
        vertices.extend(top.into_iter().flat_map(|apex| std::iter::repeat_n(apex, shape.columns())));
        let mut add_row = |row: &[u32], corners: [usize; 2]| {
            vertices.extend(row.iter().map(|&cell| walker.start(walker.on(cell, corners[0]))));
            vertices.extend(row.last().map(|&cell| walker.start(walker.on(cell, corners[1]))));
        };
        for row in self.cells.chunks_exact(self.columns) {
            add_row(row, [0, 1]);
        }
        add_row(&self.cells[self.cells.len() - self.columns..], [3, 2]);
        vertices.extend(bottom.into_iter().flat_map(|apex| std::iter::repeat_n(apex, shape.columns())));
        Ok(vertices)
    }

    /// What is glued: nodes of the same vertex.
    fn topology(&self, shape: Shape, vertices: &[u32], vertex_count: usize) -> Result<Topology> {
        let sides = Sides {
            rows_closed: self.rows_closed,
            columns_closed: self.shift == Some(0),
            pole_top: self.poles[0].is_some(),
            pole_bottom: self.poles[1].is_some(),
            ..Sides::SHEET
        };
        let mut seams = Vec::new();
        if let Some(shift) = self.shift.filter(|&shift| shift > 0) {
            // The last row is the first, begun elsewhere: up to its end, and on from its start.
            let (last, end) = (shape.rows() as u32 - 1, self.columns as u32);
            let shift = shift as u32;
            let pairs = [(0, shift, end + 1 - shift), (end - shift, 0, shift + 1)];
            for (from, to, count) in pairs {
                alloc::push(&mut seams, Seam { a: Run::along_row(last, from, 1), b: Run::along_row(0, to, 1), count })?;
            }
        }
        let closed = Topology::new(shape, Links::Sides(sides), &seams)?;
        // A surface that touches itself at a vertex.
        let mut forest = Forest::new(shape.node_count())?;
        closed.each_contracted(|link| {
            let [a, b] = shape.ends(link);
            forest.join([a, b]);
        });
        seams.iter().flat_map(|seam| seam.pairs(shape)).for_each(|[a, b]| forest.join([a, b]));
        let mut first = alloc::filled(NONE, vertex_count)?;
        let mut touches = false;
        for (node, &vertex) in (0..).zip(vertices) {
            let first = &mut first[vertex as usize];
            if *first == NONE {
                *first = node;
            } else if forest.find(*first) != forest.find(node) {
                forest.join([*first, node]);
                let place = |node: u32| {
                    let (i, j) = shape.place(node);
                    Run::along_row(i as u32, j as u32, 0)
                };
                alloc::push(&mut seams, Seam { a: place(*first), b: place(node), count: 1 })?;
                touches = true;
            }
        }
        if touches { Topology::new(shape, Links::Sides(sides), &seams) } else { Ok(closed) }
    }
}
