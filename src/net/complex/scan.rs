//! One pass over the rows of a net: counts what is regular, and collects what is not.
//!
//! A link between two nodes that nothing is glued to is an edge of its own, and all that is to be known about it is
//! which of the two cells beside it are there. Only where nodes are glued do edges have to be brought together, and
//! only there, and next to them, can the faces round a vertex be more than the cells round a node.

use super::presence::Presence;
use super::{Complex, Edge};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::net::Shape;
use crate::net::topology::{Classes, Reduced};

/// A side of a face, or of a cell that has no surface, between vertices of which at least one is a class of several
/// nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Side {
    /// The vertices, the smaller first.
    pub(super) edge: Edge,
    /// How the face runs along it.
    pub(super) sense: Sense,
    /// The cell.
    pub(super) cell: u32,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Sense {
    /// From the smaller vertex to the greater.
    Up,
    /// From the greater to the smaller.
    Down,
    /// There is no face.
    None,
}

/// A corner of a face: the vertex, and those before and after it.
pub(super) type Corner = [u32; 3];

/// The two boundary edges of one fan of faces at a vertex: the vertex, and the other ends.
pub(super) type FanEnds = [u32; 3];

/// What the pass has collected.
pub(super) struct Scan<'a> {
    shape: Shape,
    classes: &'a Classes,
    /// For each node [`GLUED`], [`NEAR`], or neither.
    marks: Vec<u8>,
    pub(super) sides: Vec<Side>,
    pub(super) corners: Vec<Corner>,
    /// Boundary edges between nodes that nothing is glued to, in the direction of their faces.
    pub(super) rim: Vec<Edge>,
    pub(super) fan_ends: Vec<FanEnds>,
    /// Classes of several nodes that cells touch, with repetitions.
    touched: Vec<u32>,
}

/// The node is glued to others.
const GLUED: u8 = 1;
/// The node is joined by a link to one that is glued.
const NEAR: u8 = 2;

impl<'a> Scan<'a> {
    /// Goes over the net; what can be counted is counted in `complex`.
    pub(super) fn new(classes: &'a Classes, presence: &Presence, complex: &mut Complex, job: &Job<'_>) -> Result<Self> {
        let shape = classes.shape();
        let (sides, corners, rim, fan_ends, touched) = Default::default();
        let mut scan = Scan { shape, classes, marks: marks(classes)?, sides, corners, rim, fan_ends, touched };
        let mut above: Vec<u8> = alloc::zeroed(shape.columns() + 1)?;
        let mut below: Vec<u8> = alloc::zeroed(shape.columns() + 1)?;
        for i in 0..shape.rows() {
            if i % 64 == 0 {
                job.step(i as f64 / shape.rows() as f64, "complex")?;
            }
            presence.row(shape, i, &mut below);
            scan.nodes(i, &above, &below, complex)?;
            scan.links(i, &above, &below, complex)?;
            scan.cells(i, &below, complex)?;
            std::mem::swap(&mut above, &mut below);
        }
        scan.touched.sort_unstable();
        scan.touched.dedup();
        complex.vertices += scan.touched.len() as u64;
        Ok(scan)
    }

    /// Counts the vertices of row i, and finds those whose faces are two fans because cells are missing.
    fn nodes(&mut self, i: usize, above: &[u8], below: &[u8], complex: &mut Complex) -> Result<()> {
        let (w, start) = (self.shape.columns(), self.shape.node(i, 0));
        let marks = &self.marks[start as usize..][..w];
        for j in 0..w {
            let node = start + j as u32;
            let cells = [above[j], above[j + 1], below[j + 1], below[j]];
            if cells == [0; 4] {
                continue;
            }
            if marks[j] == GLUED {
                alloc::push(&mut self.touched, self.classes.representative(node))?;
                continue;
            }
            complex.vertices += 1;
            // Cells that touch at the node alone.
            if marks[j] == 0 && (cells == [1, 0, 1, 0] || cells == [0, 1, 0, 1]) {
                let [east, south, west, north] = [node + 1, node + w as u32, node - 1, node - w as u32];
                let (of_north, of_south) = if cells[0] == 1 { (west, east) } else { (east, west) };
                alloc::push(&mut complex.pinches, node)?;
                alloc::push(&mut self.fan_ends, [node, north, of_north])?;
                alloc::push(&mut self.fan_ends, [node, south, of_south])?;
            }
        }
        Ok(())
    }

    /// Counts the edges of row i, and of the links down from it, that are links between unglued nodes.
    fn links(&mut self, i: usize, above: &[u8], below: &[u8], complex: &mut Complex) -> Result<()> {
        let (w, start) = (self.shape.columns(), self.shape.node(i, 0));
        let (marks, next) = self.marks[start as usize..].split_at(w);
        let rim = &mut self.rim;
        // `with`: the face that runs along the link from a to b is there; `against`: the one that runs from b to a.
        let mut link = |a: u32, b: u32, with: u8, against: u8| match (with, against) {
            (0, 0) => Ok(()),
            (1, 1) => {
                complex.edges += 1;
                Ok(())
            }
            (with, _) => {
                complex.edges += 1;
                alloc::push(rim, if with == 1 { [a, b] } else { [b, a] })
            }
        };
        for j in 0..w - 1 {
            if (marks[j] | marks[j + 1]) & GLUED == 0 {
                let a = start + j as u32;
                link(a, a + 1, below[j + 1], above[j + 1])?;
            }
        }
        for (j, &mark) in next.iter().enumerate().take(w) {
            if (marks[j] | mark) & GLUED == 0 {
                let a = start + j as u32;
                link(a, a + w as u32, below[j], below[j + 1])?;
            }
        }
        Ok(())
    }

    /// Counts the cells of row i by what they are reduced to, and collects the sides and corners of those that need it.
    fn cells(&mut self, i: usize, below: &[u8], complex: &mut Complex) -> Result<()> {
        if i + 1 == self.shape.rows() {
            return Ok(());
        }
        let w = self.shape.columns();
        for j in 0..w - 1 {
            if below[j + 1] == 0 {
                continue;
            }
            let corners = self.shape.corners(i, j);
            let mark = corners.into_iter().fold(0, |mark, node| mark | self.marks[node as usize]);
            if mark == 0 {
                complex.quads += 1;
                continue;
            }
            let cell = self.shape.cell(i, j);
            match Reduced::new(self.classes.corners(i, j)) {
                Reduced::Quad(polygon) => {
                    complex.quads += 1;
                    self.face(&polygon, cell)?;
                }
                Reduced::Triangle(polygon) => {
                    complex.triangles += 1;
                    self.face(&polygon, cell)?;
                }
                Reduced::Digon(edge) => {
                    complex.digons += 1;
                    self.side(edge, cell, true)?;
                }
                Reduced::Point(_) => complex.points += 1,
                Reduced::Fold([a, b, d]) => {
                    complex.folds += 1;
                    self.side([a, b], cell, true)?;
                    self.side([a, d], cell, true)?;
                }
                // No topology has it.
                Reduced::Crossing(_) => {}
            }
        }
        Ok(())
    }

    fn face(&mut self, polygon: &[u32], cell: u32) -> Result<()> {
        let n = polygon.len();
        for k in 0..n {
            let [before, at, after] = [polygon[(k + n - 1) % n], polygon[k], polygon[(k + 1) % n]];
            if self.marks[at as usize] != 0 {
                alloc::push(&mut self.corners, [at, before, after])?;
            }
            self.side([at, after], cell, false)?;
        }
        Ok(())
    }

    fn side(&mut self, [from, to]: Edge, cell: u32, bare: bool) -> Result<()> {
        if (self.marks[from as usize] | self.marks[to as usize]) & GLUED == 0 {
            return Ok(());
        }
        let sense = match (bare, from < to) {
            (true, _) => Sense::None,
            (_, true) => Sense::Up,
            (_, false) => Sense::Down,
        };
        alloc::push(&mut self.sides, Side { edge: [from.min(to), from.max(to)], sense, cell })
    }

    /// The number of nodes.
    pub(super) fn node_count(&self) -> usize {
        self.marks.len()
    }

    /// True if other nodes are the same vertex.
    pub(super) fn is_glued(&self, node: u32) -> bool {
        self.marks[node as usize] == GLUED
    }
}

/// Marks the glued nodes and their neighbours.
fn marks(classes: &Classes) -> Result<Vec<u8>> {
    let shape = classes.shape();
    let (h, w) = (shape.rows(), shape.columns());
    let mut marks: Vec<u8> = alloc::zeroed(shape.node_count())?;
    classes.glued(|node, representative| {
        for node in [node, representative] {
            let (i, j) = shape.place(node);
            let (up, down) = (i > 0, i + 1 < h);
            let node = node as usize;
            marks[node] = GLUED;
            let around = [(j > 0, 1, 0), (j + 1 < w, 0, 1), (up, w, 0), (down, 0, w)];
            for (_, minus, plus) in around.into_iter().filter(|&(there, ..)| there) {
                let neighbour = &mut marks[node + plus - minus];
                if *neighbour == 0 {
                    *neighbour = NEAR;
                }
            }
        }
        Ok(())
    })?;
    Ok(marks)
}
