//! The polygon mesh of a net.
//!
//! Classes of glued nodes become vertices, and cells their reduced polygons (Deryagin, Fig. 4):
//! quads, triangles, or nothing. Invariant: a closed net becomes a closed mesh, with positions bit
//! for bit. O(nodes).

use super::glued_edges::GluedEdges;
use crate::hidden_cells::HiddenCells;
use crate::shape::sorted_pair;
use crate::topology::ReducedCell;
use crate::{Net, NodeClasses, Real, Shape, XyzMatrices, each};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::{MAX_ELEMENTS, Mesh, NONE, PositionBuffer, Scalar};
use std::iter::repeat_n;

/// Nodes between two progress reports.
const NODES_PER_REPORT: usize = 1 << 16;
/// The approximate number of faces sampled for the usual edge length.
const MAX_SAMPLED_FACES: usize = 1 << 14;
const FACES_STAGE: &str = "cells to faces";
const NUMBERING_STAGE: &str = "numbering vertices";

/// The diagonal that cuts a quad into triangles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Diagonal {
    /// The shorter diagonal, or from (i, j) to (i + 1, j + 1) if they are equal. If it would repeat
    /// an edge, which gluing makes possible, the other diagonal.
    Shorter,
    /// From (i, j) to (i + 1, j + 1), with the same exception for repeated edges.
    Fixed,
}

/// Options of [`Net::to_mesh`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshOptions {
    /// The diagonals that cut quads into triangles; `None` keeps quads.
    pub triangles: Option<Diagonal>,
    /// One vertex for each class of glued nodes. If false, each node is a vertex and nothing is
    /// glued.
    pub weld: bool,
    /// Keeps finite vertices that are not used by faces or wires.
    pub keep_unused: bool,
    /// Turns a cell with exactly one missing corner into a triangle. If false, the cell is dropped.
    pub fill_corners: bool,
    /// Computes texture coordinates.
    pub texture: bool,
    /// Drops faces with an edge longer than this multiple of the usual edge length; above 0. In a
    /// range image, such faces connect one surface with another behind it.
    pub max_edge_ratio: Option<f64>,
}

impl Default for MeshOptions {
    fn default() -> Self {
        MeshOptions {
            triangles: None,
            weld: true,
            keep_unused: false,
            fill_corners: false,
            texture: false,
            max_edge_ratio: None,
        }
    }
}

/// A net as a mesh, and the maps between their elements.
#[derive(Debug, Clone, PartialEq)]
pub struct NetMesh {
    /// Holds the mesh. Its faces run counter-clockwise as the net's do. It may have no faces.
    pub mesh: Mesh,
    /// For each node its vertex, or `u32::MAX`.
    pub vertex_of_node: Vec<u32>,
    /// For each vertex the smallest of its nodes. The vertex lies at the first of them that is not
    /// missing.
    pub node_of_vertex: Vec<u32>,
    /// For each face its cell.
    pub cell_of_face: Vec<u32>,
    /// The net's nodes in a row.
    pub columns: usize,
    /// Edges without faces, as pairs of vertices. They belong to cells whose opposite sides are
    /// glued, such as threads.
    pub wires: Vec<[u32; 2]>,
    /// Texture coordinates, if requested.
    pub texture: Option<TextureCoordinates>,
}

/// Texture coordinates: column and row, each from 0 to 1 (u = j / (W - 1), v = i / (H - 1)).
///
/// They belong to nodes instead of vertices. A vertex on a seam has a pair of coordinates on each
/// side, so that an image covers a closed net once and does not run back within its last column.
#[derive(Debug, Clone, PartialEq)]
pub struct TextureCoordinates {
    /// u and v, once for each node that a face uses, in the order of the nodes.
    pub coordinates: Vec<[f64; 2]>,
    /// For each corner of the mesh the index of its coordinates.
    pub corners: Vec<u32>,
}

impl TextureCoordinates {
    /// Returns the texture coordinates of faces given by nodes.
    fn new(shape: Shape, nodes: &[u32], job: &Job<'_>) -> Result<Self> {
        let mut number =
            alloc::collect_cancellable(repeat_n(NONE, shape.node_count()), &job.sub_job(0.0, 0.2), NUMBERING_STAGE)?;
        job.sub_job(0.2, 0.4).work_in_ranges(NUMBERING_STAGE, nodes.len(), |range| {
            nodes[range].iter().for_each(|&node| number[node as usize] = 0);
            Ok(())
        })?;
        let mut coordinates = Vec::new();
        let (rows, columns) = ((shape.rows() - 1) as f64, (shape.columns() - 1) as f64);
        job.sub_job(0.4, 0.8).work_in_ranges(NUMBERING_STAGE, shape.node_count(), |range| {
            for (node, number) in range.clone().zip(&mut number[range]).filter(|(_, number)| **number == 0) {
                *number = coordinates.len() as u32;
                let (i, j) = shape.row_and_column(node as u32);
                alloc::push(&mut coordinates, [j as f64 / columns, i as f64 / rows])?;
            }
            Ok(())
        })?;
        let corners = alloc::collect_cancellable(
            nodes.iter().map(|&node| number[node as usize]),
            &job.sub_job(0.8, 1.0),
            NUMBERING_STAGE,
        )?;
        Ok(TextureCoordinates { coordinates, corners })
    }
}

impl Net<'_> {
    /// Returns the mesh of the net. It has the cells that exist. O(nodes).
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a `max_edge_ratio` that is not above 0, [`Error::TooLarge`]
    /// for more than 2^32 - 2 corners, [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn to_mesh(&self, options: &MeshOptions, job: &Job<'_>) -> Result<NetMesh> {
        let corners = 4 * self.shape().cell_count() as u64 * if options.triangles.is_some() { 3 } else { 2 } / 2;
        Error::check_count("corners", corners, MAX_ELEMENTS)?;
        if let Some(ratio) = options.max_edge_ratio {
            Error::require(ratio > 0.0, "max_edge_ratio", ratio, "above 0")?;
        }
        each!(self.coordinates(), planes => build_mesh(self, planes, options, job))
    }
}

fn build_mesh<T: Real>(
    net: &Net<'_>,
    planes: &XyzMatrices<'_, T>,
    options: &MeshOptions,
    job: &Job<'_>,
) -> Result<NetMesh> {
    let shape = net.shape();
    let first = job.sub_job(0.0, 0.1);
    let classes = if options.weld {
        NodeClasses::new_cancellable(net.topology(), &first.sub_job(0.0, 0.7), FACES_STAGE)?
            .representatives_cancellable(&first.sub_job(0.7, 1.0), FACES_STAGE)?
    } else {
        alloc::collect_cancellable((0..shape.node_count()).map(|node| node as u32), &first, FACES_STAGE)?
    };
    let mut faces = FaceBuilder {
        columns: shape.columns() as u32,
        positions_of_classes: ClassPositions::new(planes, &classes, &job.sub_job(0.1, 0.2))?,
        planes,
        options,
        reversed: net.topology().is_reversed(),
        nodes: alloc::with_capacity(4 * shape.cell_count())?,
        offsets: alloc::with_capacity(shape.cell_count() + 1)?,
        cells: alloc::with_capacity(shape.cell_count())?,
        edges: Vec::new(),
        used_edges: match options.triangles {
            Some(_) => Some(GluedEdges::new(shape, &classes, &job.sub_job(0.2, 0.3), FACES_STAGE)?),
            None => None,
        },
        classes: &classes,
    };
    faces.offsets.push(0);
    let hidden = HiddenCells::new(net)?;
    let (scanning, often) = (job.sub_job(0.3, 0.7), (NODES_PER_REPORT / shape.columns()).max(1));
    let mut skip = alloc::filled(false, shape.columns() - 1)?;
    for i in 0..shape.rows() - 1 {
        scanning.step_every(often, i, shape.rows(), FACES_STAGE)?;
        let ranges = hidden.hidden_ranges(i);
        ranges.iter().for_each(|&[from, to]| skip[from as usize..to as usize].fill(true));
        for (j, _) in skip.iter().enumerate().filter(|(_, skip)| !**skip) {
            faces.add_face_of_cell(shape.corners_of_cell(i, j), shape.cell(i, j))?;
        }
        ranges.iter().for_each(|&[from, to]| skip[from as usize..to as usize].fill(false));
    }
    if let Some(ratio) = options.max_edge_ratio {
        faces.drop_faces_with_long_edges(ratio, &job.sub_job(0.7, 0.8))?;
    }
    faces.finish_mesh(options, &job.sub_job(0.8, 1.0))
}

/// The nodes at which classes lie.
struct ClassPositions {
    /// True for each node with finite coordinates.
    finite: Vec<bool>,
    /// The classes whose smallest node is missing, each with its first existing node, in order.
    /// Rarely any.
    elsewhere: Vec<[u32; 2]>,
}

impl ClassPositions {
    fn new<T: Real>(planes: &XyzMatrices<'_, T>, classes: &[u32], job: &Job<'_>) -> Result<Self> {
        let finite = mark_finite_nodes(planes, &job.sub_job(0.0, 0.5))?;
        let mut elsewhere = Vec::new();
        job.sub_job(0.5, 1.0).work_in_ranges(FACES_STAGE, classes.len(), |range| {
            for node in range.filter(|&node| finite[node] && !finite[classes[node] as usize]) {
                alloc::push(&mut elsewhere, [classes[node], node as u32])?;
            }
            Ok(())
        })?;
        elsewhere.sort_unstable();
        elsewhere.dedup_by_key(|entry| entry[0]);
        Ok(ClassPositions { finite, elsewhere })
    }

    /// Returns the node that gives the class its position.
    fn node_with_position(&self, class: u32) -> u32 {
        match self.elsewhere.binary_search_by_key(&class, |entry| entry[0]) {
            Ok(at) => self.elsewhere[at][1],
            Err(_) => class,
        }
    }

    fn class_has_position(&self, class: u32) -> bool {
        self.finite[self.node_with_position(class) as usize]
    }
}

/// Returns true for each node with finite coordinates.
fn mark_finite_nodes<T: Real>(planes: &XyzMatrices<'_, T>, job: &Job<'_>) -> Result<Vec<bool>> {
    let (rows, columns) = (planes.shape().rows(), planes.shape().columns());
    let mut finite = alloc::filled(true, planes.shape().node_count())?;
    let often = (NODES_PER_REPORT / columns).max(1);
    let zero = T::from_f64(0.0);
    for (i, finite) in finite.chunks_exact_mut(columns).enumerate() {
        job.step_every(often, i, rows, FACES_STAGE)?;
        for row in planes.row(i) {
            // x * 0 is 0 except for infinities and NaN.
            finite.iter_mut().zip(row).for_each(|(finite, &x)| *finite &= x * zero == zero);
        }
    }
    Ok(finite)
}

/// Faces under construction, their corners as nodes.
struct FaceBuilder<'a, T> {
    columns: u32,
    positions_of_classes: ClassPositions,
    planes: &'a XyzMatrices<'a, T>,
    options: &'a MeshOptions,
    reversed: bool,
    classes: &'a [u32],
    /// The edges that no diagonal may repeat, if quads are cut.
    used_edges: Option<GluedEdges>,
    nodes: Vec<u32>,
    offsets: Vec<u32>,
    cells: Vec<u32>,
    /// Edges, as classes, of cells reduced to less than a face.
    edges: Vec<[u32; 2]>,
}

impl<T: Real> FaceBuilder<'_, T> {
    /// Adds the face of a cell, given its corners in order around it. Glued or missing corners
    /// reduce the quad to a triangle, edges or nothing.
    fn add_face_of_cell(&mut self, corners: [u32; 4], cell: u32) -> Result<()> {
        let finite = corners.map(|node| self.positions_of_classes.finite[node as usize]);
        if finite != [true; 4] {
            return if self.options.fill_corners {
                self.add_cell_with_missing_corner(corners, finite, cell)
            } else {
                Ok(())
            };
        }
        let [a, b, c, d] = corners.map(|node| self.classes[node as usize]);
        if a != b && b != c && c != d && d != a && a != c && b != d {
            return self.add_quad(corners, cell);
        }
        match ReducedCell::new([a, b, c, d]) {
            ReducedCell::Triangle(_) => self.add_cell_with_contracted_side(corners, cell),
            ReducedCell::Digon([p, q]) => alloc::push(&mut self.edges, [p, q]),
            ReducedCell::Fold([p, q, r]) => alloc::append(&mut self.edges, &[[p, q], [p, r]]),
            ReducedCell::Quad(_) | ReducedCell::Point(_) | ReducedCell::Crossing(_) => Ok(()),
        }
    }

    /// Adds a cell with missing corners: a triangle, if the other three are distinct points.
    fn add_cell_with_missing_corner(&mut self, corners: [u32; 4], finite: [bool; 4], cell: u32) -> Result<()> {
        let mut kept = (0..4).filter(|&k| finite[k]).map(|k| corners[k]);
        let (Some(a), Some(b), Some(c)) = (kept.next(), kept.next(), kept.next()) else { return Ok(()) };
        let [p, q, r] = [a, b, c].map(|node| self.classes[node as usize]);
        if p != q && q != r && r != p { self.push_face(&[a, b, c], cell) } else { Ok(()) }
    }

    /// Adds a cell with one contracted side. It keeps the second of the two glued corners.
    fn add_cell_with_contracted_side(&mut self, corners: [u32; 4], cell: u32) -> Result<()> {
        let class = |k: usize| self.classes[corners[k % 4] as usize];
        let mut kept = (0..4).filter(|&k| class(k) != class(k + 1)).map(|k| corners[k]);
        let (Some(a), Some(b), Some(c)) = (kept.next(), kept.next(), kept.next()) else { return Ok(()) };
        self.push_face(&[a, b, c], cell)
    }

    /// Adds a cell of four points.
    fn add_quad(&mut self, corners: [u32; 4], cell: u32) -> Result<()> {
        let [a, b, c, d] = corners;
        let along = match self.options.triangles {
            None => return self.push_face(&corners, cell),
            Some(Diagonal::Fixed) => true,
            // Measured between classes, so that coincident cells agree.
            Some(Diagonal::Shorter) => {
                let between = |p: u32, q: u32| {
                    (self.position_of_class_of_node(p) - self.position_of_class_of_node(q)).length_squared()
                };
                between(a, c) <= between(b, d)
            }
        };
        let ends = [[a, c], [b, d]].map(|ends| ends.map(|node| self.classes[node as usize]));
        let is_used = |k: usize| self.used_edges.as_ref().is_some_and(|used| used.contains(ends[k]));
        let [chosen, other] = if along { [0, 1] } else { [1, 0] };
        let chosen = if is_used(chosen) && !is_used(other) { other } else { chosen };
        if let Some(used) = &mut self.used_edges {
            used.add_edge(ends[chosen])?;
        }
        let [first, second] = if chosen == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
        self.push_face(&first, cell)?;
        self.push_face(&second, cell)
    }

    fn position_of_class_of_node(&self, node: u32) -> DVec3 {
        let node = self.positions_of_classes.node_with_position(self.classes[node as usize]);
        self.planes.get((node / self.columns) as usize, (node % self.columns) as usize)
    }

    fn push_face(&mut self, corners: &[u32], cell: u32) -> Result<()> {
        let start = self.nodes.len();
        alloc::append(&mut self.nodes, corners)?;
        if self.reversed {
            // The first corner stays the first.
            self.nodes[start + 1..].reverse();
        }
        alloc::push(&mut self.offsets, self.nodes.len() as u32)?;
        alloc::push(&mut self.cells, cell)
    }

    /// Drops faces with an edge longer than `ratio` times the usual length. The usual length is the
    /// median over the edges of evenly sampled faces, skipping edges of length 0. O(faces).
    fn drop_faces_with_long_edges(&mut self, ratio: f64, job: &Job<'_>) -> Result<()> {
        let squared =
            |p: u32, q: u32| (self.position_of_class_of_node(p) - self.position_of_class_of_node(q)).length_squared();
        let looked_at = self.offsets.windows(2).step_by(self.cells.len() / MAX_SAMPLED_FACES + 1);
        let mut lengths = Vec::new();
        for ends in looked_at {
            let face = &self.nodes[ends[0] as usize..ends[1] as usize];
            let nexts = face.iter().skip(1).chain(face.first());
            let edges = face.iter().zip(nexts).map(|(&p, &q)| squared(p, q));
            alloc::extend(&mut lengths, edges.filter(|&length| length > 0.0))?;
        }
        if lengths.is_empty() {
            return Ok(());
        }
        let middle = lengths.len() / 2;
        let longest = ratio * ratio * *lengths.select_nth_unstable_by(middle, f64::total_cmp).1;
        let mut kept = alloc::filled(false, self.cells.len())?;
        job.sub_job(0.0, 0.7).work_in_ranges(FACES_STAGE, self.cells.len(), |range| {
            for f in range {
                let face = &self.nodes[self.offsets[f] as usize..self.offsets[f + 1] as usize];
                let nexts = face.iter().skip(1).chain(face.first());
                kept[f] = face.iter().zip(nexts).all(|(&p, &q)| squared(p, q) <= longest);
            }
            Ok(())
        })?;
        // In place, because the lists only shrink.
        let (mut faces, mut corners) = (0, 0);
        job.sub_job(0.7, 1.0).work_in_ranges(FACES_STAGE, self.cells.len(), |range| {
            for f in range.filter(|&f| kept[f]) {
                let own = self.offsets[f] as usize..self.offsets[f + 1] as usize;
                let count = own.len();
                self.nodes.copy_within(own, corners);
                self.cells[faces] = self.cells[f];
                (faces, corners) = (faces + 1, corners + count);
                // The end of this face is stored after the start of the next, which is still to be
                // read.
                self.offsets[faces] = corners as u32;
            }
            Ok(())
        })?;
        self.nodes.truncate(corners);
        self.cells.truncate(faces);
        self.offsets.truncate(faces + 1);
        Ok(())
    }

    /// Returns the edges without faces, as pairs of classes, each once, in order. O(e log e) for e
    /// edges, and O(faces log e) if there are any.
    fn edges_without_faces(&mut self, job: &Job<'_>) -> Result<Vec<[u32; 2]>> {
        let mut edges = std::mem::take(&mut self.edges);
        edges.iter_mut().for_each(|edge| *edge = sorted_pair(*edge));
        sort_distinct(&mut edges);
        if edges.is_empty() {
            return Ok(edges);
        }
        let mut has_face = alloc::filled(false, edges.len())?;
        job.work_in_ranges(NUMBERING_STAGE, self.cells.len(), |range| {
            for ends in self.offsets[range.start..=range.end].windows(2) {
                let face = &self.nodes[ends[0] as usize..ends[1] as usize];
                let nexts = face.iter().skip(1).chain(face.first());
                for (&node, &next) in face.iter().zip(nexts) {
                    let edge = sorted_pair([node, next].map(|node| self.classes[node as usize]));
                    if let Ok(at) = edges.binary_search(&edge) {
                        has_face[at] = true;
                    }
                }
            }
            Ok(())
        })?;
        let mut has_face = has_face.into_iter();
        edges.retain(|_| has_face.next() == Some(false));
        Ok(edges)
    }

    /// Numbers the vertices in the order of their nodes, and completes the mesh.
    fn finish_mesh(mut self, options: &MeshOptions, job: &Job<'_>) -> Result<NetMesh> {
        let part = |from: f64, to: f64| job.sub_job(from, to);
        let wires = self.edges_without_faces(&part(0.0, 0.2))?;
        let mut vertex =
            alloc::collect_cancellable(repeat_n(NONE, self.classes.len()), &part(0.2, 0.3), NUMBERING_STAGE)?;
        let mut use_class = |node: u32| vertex[self.classes[node as usize] as usize] = 0;
        part(0.3, 0.4).work_in_ranges(NUMBERING_STAGE, self.nodes.len(), |range| {
            self.nodes[range].iter().for_each(|&node| use_class(node));
            Ok(())
        })?;
        wires.as_flattened().iter().for_each(|&class| use_class(class));
        let mut node_of_vertex = Vec::new();
        part(0.4, 0.5).work_in_ranges(NUMBERING_STAGE, self.classes.len(), |range| {
            for node in range {
                let own = self.classes[node] as usize == node;
                if own
                    && (vertex[node] == 0
                        || options.keep_unused && self.positions_of_classes.class_has_position(node as u32))
                {
                    vertex[node] = node_of_vertex.len() as u32;
                    alloc::push(&mut node_of_vertex, node as u32)?;
                } else {
                    // A node after the first of its class has the vertex of the first.
                    vertex[node] = vertex[self.classes[node] as usize];
                }
            }
            Ok(())
        })?;
        let texture =
            options.texture.then(|| TextureCoordinates::new(self.planes.shape(), &self.nodes, &part(0.5, 0.7)));
        let texture = texture.transpose()?;
        part(0.7, 0.8).work_in_ranges(NUMBERING_STAGE, self.nodes.len(), |range| {
            self.nodes[range].iter_mut().for_each(|node| *node = vertex[*node as usize]);
            Ok(())
        })?;
        let nodes = node_of_vertex.iter().map(|&node| self.positions_of_classes.node_with_position(node));
        let positions = collect_positions(self.planes, nodes, &part(0.8, 1.0))?;
        let mesh = Mesh::new(positions, self.offsets, self.nodes);
        let columns = self.planes.shape().columns();
        let wires = alloc::collect(wires.iter().map(|wire| wire.map(|class| vertex[class as usize])))?;
        job.step(1.0, NUMBERING_STAGE)?;
        Ok(NetMesh { mesh, vertex_of_node: vertex, node_of_vertex, cell_of_face: self.cells, columns, wires, texture })
    }
}

/// Returns the positions of nodes, bit for bit.
fn collect_positions<T: Real>(
    planes: &XyzMatrices<'_, T>,
    nodes: impl ExactSizeIterator<Item = u32>,
    job: &Job<'_>,
) -> Result<PositionBuffer> {
    let (matrices, stride, columns) = (planes.matrices(), planes.stride(), planes.shape().columns());
    let points = nodes.map(|node| {
        let at = node as usize / columns * stride + node as usize % columns;
        matrices.map(|matrix| matrix[at])
    });
    let points: Vec<[T; 3]> = alloc::collect_cancellable(points, job, NUMBERING_STAGE)?;
    Ok(match T::SCALAR {
        Scalar::F32 => PositionBuffer::F32(bytemuck::allocation::cast_vec(points)),
        Scalar::F64 => PositionBuffer::F64(bytemuck::allocation::cast_vec(points)),
    })
}
