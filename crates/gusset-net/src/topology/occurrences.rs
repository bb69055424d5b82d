//! The local gluings of a net as data: where each is, its type in the paper's letters, and its
//! orders (Deryagin, Fig. 4). O(nodes).

use super::{GluingType, NodeClasses, Topology, classify_cell, classify_node};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Nodes between two progress reports.
const NODES_PER_REPORT: usize = 1 << 16;

/// The letters and orders of a type, as in the caption of Fig. 4.
///
/// At a node, the type is n(a, b). a nodes are glued to the node; b is 1 if two of them are
/// adjacent around it, and 2 if they are opposite. At a cell, the type is c(a, b). a of its links
/// are glued, and b (0 or 1) of the other links lie between them. A diagonal is c(1, 2): one gluing
/// across two links.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GluingSignature {
    /// The letter a.
    pub a: u8,
    /// The letter b; `None` for types with one letter.
    pub b: Option<u8>,
    /// The number of nodes that the gluing identifies.
    pub node_order: u8,
    /// The number of links that the gluing identifies; 1 if none.
    pub link_order: u8,
}

impl GluingType {
    /// Returns the letters and orders of the type at a node; `None` for those that only cells have.
    pub fn node_signature(self) -> Option<GluingSignature> {
        let [a, b, link_order] = match self.number() {
            0 | 1 => [1, 0, 1],
            2..=5 => [2, 1, 2],
            6 | 7 => [2, 2, 1],
            8..=11 => [3, 0, 2],
            12 => [4, 0, 2],
            _ => return None,
        };
        Some(GluingSignature { a, b: (b > 0).then_some(b), node_order: a + 1, link_order })
    }

    /// Returns the letters and orders of the type of a cell; `None` for those that only nodes have.
    pub fn cell_signature(self) -> Option<GluingSignature> {
        let (a, b, node_order, link_order) = match self.number() {
            0 | 1 => (1, None, 2, 1),
            2..=5 => (2, Some(0), 3, 2),
            13 | 14 => (2, Some(1), 2, 2),
            15 => (3, None, 4, 1),
            16 | 17 => (1, Some(2), 2, 2),
            _ => return None,
        };
        Some(GluingSignature { a, b, node_order, link_order })
    }
}

/// One local gluing of a net.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GluingOccurrence {
    /// True at a cell, false at a node.
    pub on_cell: bool,
    /// The node or the cell.
    pub element: u32,
    /// The type.
    pub kind: GluingType,
    /// Its letters and orders.
    pub signature: GluingSignature,
    /// The size of the class of this node, or of the largest class among the glued corners of this
    /// cell. It exceeds `node_order` where gluings meet.
    pub class_size: u32,
}

/// Returns all local gluings of a net: of its nodes, in order, then of its cells. If `cyclic`,
/// closing links to the first row and column count too. O(nodes), 4 bytes a node plus the result.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn find_gluing_occurrences(topology: &Topology, cyclic: bool, job: &Job<'_>) -> Result<Vec<GluingOccurrence>> {
    let (shape, classes) =
        (topology.shape(), NodeClasses::new_cancellable(topology, &job.sub_job(0.0, 0.2), "gluings")?);
    let job = job.sub_job(0.2, 1.0);
    let (h, w) = (shape.rows(), shape.columns());
    let mut sizes = alloc::filled(0u32, shape.node_count())?;
    (0..shape.node_count() as u32).for_each(|node| sizes[classes.representative(node) as usize] += 1);
    let size = |node: u32| sizes[classes.representative(node) as usize];
    let (mut found, rows) = (Vec::new(), (NODES_PER_REPORT / w).max(1));
    for i in 0..h {
        job.step_every(rows, i, 2 * h, "gluings")?;
        for (j, node) in (0..w).zip(shape.node(i, 0)..) {
            let kind = classify_node(&classes, i, j, cyclic);
            if let Some((kind, signature)) = kind.and_then(|kind| Some((kind, kind.node_signature()?))) {
                let occurrence =
                    GluingOccurrence { on_cell: false, element: node, kind, signature, class_size: size(node) };
                alloc::push(&mut found, occurrence)?;
            }
        }
    }
    for i in 0..h - 1 {
        job.step_every(rows, h + i, 2 * h, "gluings")?;
        for j in 0..w - 1 {
            let kind = classify_cell(&classes, i, j);
            if let Some((kind, signature)) = kind.and_then(|kind| Some((kind, kind.cell_signature()?))) {
                let class_size = classes.representatives_of_corners(i, j).map(size).into_iter().fold(0, u32::max);
                let element = (i * (w - 1) + j) as u32;
                alloc::push(&mut found, GluingOccurrence { on_cell: true, element, kind, signature, class_size })?;
            }
        }
    }
    Ok(found)
}
