//! Texture coordinates of the mesh of a net: its parameters, column and row. O(nodes).

use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::mesh::NONE;
use crate::net::Shape;
use std::iter::repeat_n;

/// Texture coordinates: column and row, each from 0 to 1 (u = j / (W - 1), v = i / (H - 1)).
///
/// They belong to nodes, not to vertices: a vertex on a seam has a pair of coordinates on each
/// side, so that an image covers a closed net once and does not run back within its last column.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// u and v, once for each node that a face uses, in the order of the nodes.
    pub coordinates: Vec<[f64; 2]>,
    /// For each corner of the mesh the index of its coordinates.
    pub corners: Vec<u32>,
}

impl Texture {
    /// The texture coordinates of faces given by nodes.
    pub(super) fn new(shape: Shape, nodes: &[u32], job: &Job<'_>, stage: &'static str) -> Result<Self> {
        let mut number = alloc::collect_cancellable(repeat_n(NONE, shape.node_count()), &job.part(0.0, 0.2), stage)?;
        job.part(0.2, 0.4).ranges(stage, nodes.len(), |range| {
            nodes[range].iter().for_each(|&node| number[node as usize] = 0);
            Ok(())
        })?;
        let mut coordinates = Vec::new();
        let (rows, columns) = ((shape.rows() - 1) as f64, (shape.columns() - 1) as f64);
        job.part(0.4, 0.8).ranges(stage, shape.node_count(), |range| {
            for (node, number) in range.clone().zip(&mut number[range]).filter(|(_, number)| **number == 0) {
                *number = coordinates.len() as u32;
                let (i, j) = shape.place(node as u32);
                alloc::push(&mut coordinates, [j as f64 / columns, i as f64 / rows])?;
            }
            Ok(())
        })?;
        let corners =
            alloc::collect_cancellable(nodes.iter().map(|&node| number[node as usize]), &job.part(0.8, 1.0), stage)?;
        Ok(Texture { coordinates, corners })
    }
}
