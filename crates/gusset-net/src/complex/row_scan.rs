//! One pass over the rows of a net, which counts the regular elements and collects the others.
//!
//! A link between two single nodes is an edge, and the two cells beside it determine its faces.
//! Edges must be grouped only at glued nodes. The faces around a vertex can differ from the cells
//! around a node only at glued nodes and their neighbours. O(nodes), with memory for the glued part
//! only.

use super::boundary::{Edge, FanEnds};
use super::presence::ExistingCells;
use super::quotient::Complex;
use crate::Shape;
use crate::topology::{NodeClasses, ReducedCell};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;

/// A side of a face, or of a cell reduced to less than a face, with at least one glued end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct FaceSide {
    /// The vertices, the smaller first.
    pub(super) edge: Edge,
    /// The direction in which the face traverses it.
    pub(super) sense: SideDirection,
    /// The cell.
    pub(super) cell: u32,
}

/// The direction of a side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum SideDirection {
    /// From the smaller vertex to the larger.
    Up,
    /// From the larger to the smaller.
    Down,
    /// Without a face.
    None,
}

/// A corner of a face: the vertex, and those before and after it.
pub(super) type FaceCorner = [u32; 3];

/// The elements that the pass collects.
pub(super) struct IrregularElements<'a> {
    shape: Shape,
    classes: &'a NodeClasses,
    /// For each node [`NODE_IS_GLUED`], [`NODE_HAS_LINK_TO_GLUED`], or neither.
    node_marks: Vec<u8>,
    pub(super) sides: Vec<FaceSide>,
    pub(super) corners: Vec<FaceCorner>,
    /// Boundary edges between single nodes, in the direction of their faces.
    pub(super) rim: Vec<Edge>,
    pub(super) fan_ends: Vec<FanEnds>,
    /// Classes of several nodes that cells touch, with repetitions.
    touched_classes: Vec<u32>,
}

/// The node is glued to others.
const NODE_IS_GLUED: u8 = 1;
/// A link joins the node to a glued one.
const NODE_HAS_LINK_TO_GLUED: u8 = 2;

impl<'a> IrregularElements<'a> {
    /// Scans the net and counts its regular elements in `complex`.
    pub(super) fn new(
        classes: &'a NodeClasses,
        presence: &ExistingCells,
        complex: &mut Complex,
        job: &Job<'_>,
    ) -> Result<Self> {
        let shape = classes.shape();
        let (sides, corners, rim, fan_ends, touched) = Default::default();
        let mut scan = IrregularElements {
            shape,
            classes,
            node_marks: mark_glued_nodes(classes)?,
            sides,
            corners,
            rim,
            fan_ends,
            touched_classes: touched,
        };
        let mut above: Vec<u8> = alloc::zeroed(shape.columns() + 1)?;
        let mut below: Vec<u8> = alloc::zeroed(shape.columns() + 1)?;
        for i in 0..shape.rows() {
            job.step_every(64, i, shape.rows(), "complex")?;
            presence.write_padded_row(shape, i, &mut below);
            scan.scan_nodes_of_row(i, &above, &below, complex)?;
            scan.scan_links_of_row(i, &above, &below, complex)?;
            scan.scan_cells_of_row(i, &below, complex)?;
            std::mem::swap(&mut above, &mut below);
        }
        sort_distinct(&mut scan.touched_classes);
        complex.vertices += scan.touched_classes.len() as u64;
        Ok(scan)
    }

    /// Counts the vertices of row i, and finds pinches at missing cells.
    fn scan_nodes_of_row(&mut self, i: usize, above: &[u8], below: &[u8], complex: &mut Complex) -> Result<()> {
        let (w, start) = (self.shape.columns(), self.shape.node(i, 0));
        let marks = &self.node_marks[start as usize..][..w];
        for j in 0..w {
            let node = start + j as u32;
            let cells = [above[j], above[j + 1], below[j + 1], below[j]];
            if cells == [0; 4] {
                continue;
            }
            if marks[j] == NODE_IS_GLUED {
                alloc::push(&mut self.touched_classes, self.classes.representative(node))?;
                continue;
            }
            complex.vertices += 1;
            // Two cells that touch only at the node.
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

    /// Counts the edges of row i and down from it that are links between single nodes.
    fn scan_links_of_row(&mut self, i: usize, above: &[u8], below: &[u8], complex: &mut Complex) -> Result<()> {
        let (w, start) = (self.shape.columns(), self.shape.node(i, 0));
        let (marks, next) = self.node_marks[start as usize..].split_at(w);
        let rim = &mut self.rim;
        // `with` is 1 if the face that traverses the link from a to b exists, and `against` is 1 if
        // the opposite face exists.
        let mut link = |a: u32, b: u32, with: u8, against: u8| {
            complex.edges += u64::from(with | against);
            let boundary = if with == 1 { [a, b] } else { [b, a] };
            if with != against { alloc::push(rim, boundary) } else { Ok(()) }
        };
        for j in 0..w - 1 {
            if (marks[j] | marks[j + 1]) & NODE_IS_GLUED == 0 {
                let a = start + j as u32;
                link(a, a + 1, below[j + 1], above[j + 1])?;
            }
        }
        for (j, &mark) in next.iter().enumerate().take(w) {
            if (marks[j] | mark) & NODE_IS_GLUED == 0 {
                let a = start + j as u32;
                link(a, a + w as u32, below[j], below[j + 1])?;
            }
        }
        Ok(())
    }

    /// Counts the cells of row i by their reduced form, and collects sides and corners at glued
    /// nodes.
    fn scan_cells_of_row(&mut self, i: usize, below: &[u8], complex: &mut Complex) -> Result<()> {
        for j in (0..self.shape.columns() - 1).filter(|&j| below[j + 1] == 1) {
            let corners = self.shape.corners_of_cell(i, j);
            let mark = corners.into_iter().fold(0, |mark, node| mark | self.node_marks[node as usize]);
            if mark == 0 {
                complex.quads += 1;
                continue;
            }
            let cell = self.shape.cell(i, j);
            match ReducedCell::new(self.classes.representatives_of_corners(i, j)) {
                ReducedCell::Quad(polygon) => {
                    complex.quads += 1;
                    self.add_sides_and_corners_of_face(&polygon, cell)?;
                }
                ReducedCell::Triangle(polygon) => {
                    complex.triangles += 1;
                    self.add_sides_and_corners_of_face(&polygon, cell)?;
                }
                ReducedCell::Digon(edge) => {
                    complex.digons += 1;
                    self.add_side_if_glued(edge, cell, true)?;
                }
                ReducedCell::Point(_) => complex.points += 1,
                ReducedCell::Fold([a, b, d]) => {
                    complex.folds += 1;
                    self.add_side_if_glued([a, b], cell, true)?;
                    self.add_side_if_glued([a, d], cell, true)?;
                }
                // A topology never has such a cell.
                ReducedCell::Crossing(_) => {}
            }
        }
        Ok(())
    }

    fn add_sides_and_corners_of_face(&mut self, polygon: &[u32], cell: u32) -> Result<()> {
        let n = polygon.len();
        for k in 0..n {
            let [before, at, after] = [polygon[(k + n - 1) % n], polygon[k], polygon[(k + 1) % n]];
            if self.node_marks[at as usize] != 0 {
                alloc::push(&mut self.corners, [at, before, after])?;
            }
            self.add_side_if_glued([at, after], cell, false)?;
        }
        Ok(())
    }

    fn add_side_if_glued(&mut self, [from, to]: Edge, cell: u32, bare: bool) -> Result<()> {
        if (self.node_marks[from as usize] | self.node_marks[to as usize]) & NODE_IS_GLUED == 0 {
            return Ok(());
        }
        let sense = match (bare, from < to) {
            (true, _) => SideDirection::None,
            (_, true) => SideDirection::Up,
            (_, false) => SideDirection::Down,
        };
        alloc::push(&mut self.sides, FaceSide { edge: [from.min(to), from.max(to)], sense, cell })
    }

    /// Returns the number of nodes.
    pub(super) fn node_count(&self) -> usize {
        self.node_marks.len()
    }

    /// Returns true if other nodes belong to the same vertex.
    pub(super) fn is_glued(&self, node: u32) -> bool {
        self.node_marks[node as usize] == NODE_IS_GLUED
    }
}

/// Marks the glued nodes and their neighbours.
fn mark_glued_nodes(classes: &NodeClasses) -> Result<Vec<u8>> {
    let shape = classes.shape();
    let (h, w) = (shape.rows(), shape.columns());
    let mut marks: Vec<u8> = alloc::zeroed(shape.node_count())?;
    classes.for_each_glued_node(|node, representative| {
        for node in [node, representative] {
            let (i, j) = shape.row_and_column(node);
            let node = node as usize;
            marks[node] = NODE_IS_GLUED;
            let around = [(j > 0, 1, 0), (j + 1 < w, 0, 1), (i > 0, w, 0), (i + 1 < h, 0, w)];
            for (_, minus, plus) in around.into_iter().filter(|&(exists, ..)| exists) {
                let neighbour = &mut marks[node + plus - minus];
                if *neighbour == 0 {
                    *neighbour = NODE_HAS_LINK_TO_GLUED;
                }
            }
        }
        Ok(())
    })?;
    Ok(marks)
}
