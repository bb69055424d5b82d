//! Ungluing with a gap.

use super::topology::{Classes, Gluing};
use super::{Net, Shape};
use crate::alloc;
use crate::error::{Error, Result};
use glam::DVec3;

impl Net<'_> {
    /// Glues nodes; see [`Topology::glued`](super::Topology::glued). Positions stay what they are.
    ///
    /// # Errors
    /// As there; the net is unchanged then.
    pub fn glue(&mut self, gluings: &[Gluing]) -> Result<()> {
        let topology = self.topology().glued(gluings)?;
        self.set_topology(topology);
        Ok(())
    }

    /// Unglues nodes; see [`Topology::unglued`](super::Topology::unglued). `separation`: how far what becomes separate
    /// retreats from each other; 0 leaves positions what they are.
    ///
    /// Each piece of a vertex that falls apart moves by half the separation, all its nodes to the same place, towards
    /// the mean of its neighbours: the other ends of its links that are there and did not belong to the vertex; of
    /// these only such as do not fall apart themselves, if there are any, so that the rims of a cut move away from the
    /// cut and not along it. A piece without neighbours, or in the middle of them, stays. Returns the number of pieces
    /// that moved. O(nodes).
    ///
    /// # Errors
    /// As there, and [`Error::OptionOutOfRange`] for a separation that is no finite number from 0 on; the net is
    /// unchanged then.
    pub fn unglue(&mut self, gluings: &[Gluing], separation: f64) -> Result<usize> {
        if !(separation.is_finite() && separation >= 0.0) {
            return Err(Error::OptionOutOfRange { option: "separation", value: separation });
        }
        let topology = self.topology().unglued(gluings)?;
        let moves = if separation > 0.0 {
            let (before, after) = (Classes::of(self.topology())?, Classes::of(&topology)?);
            let pieces = Pieces::new(&before, &after)?;
            pieces.moves(self, &before, separation / 2.0)?
        } else {
            Vec::new()
        };
        let shape = self.shape();
        for (piece, position) in &moves {
            for &node in piece {
                let (i, j) = shape.place(node);
                self.coordinates_mut().set(i, j, *position);
            }
        }
        self.set_topology(topology);
        Ok(moves.len())
    }
}

/// The vertices that fall apart.
struct Pieces {
    /// (representative of the vertex, representative of the piece, node), in order.
    nodes: Vec<[u32; 3]>,
    /// All these nodes in order.
    split: Vec<u32>,
}

impl Pieces {
    fn new(before: &Classes, after: &Classes) -> Result<Self> {
        let (mut nodes, mut split) = (Vec::new(), Vec::new());
        for class in before.groups()?.iter() {
            // What was one vertex is one still if it is one piece.
            if class.iter().all(|&node| after.representative(node) == after.representative(class[0])) {
                continue;
            }
            alloc::reserve(&mut nodes, class.len())?;
            nodes.extend(class.iter().map(|&node| [class[0], after.representative(node), node]));
            alloc::append(&mut split, class)?;
        }
        nodes.sort_unstable();
        split.sort_unstable();
        Ok(Pieces { nodes, split })
    }

    /// The pieces that move, and where to.
    fn moves(&self, net: &Net<'_>, before: &Classes, step: f64) -> Result<Vec<(Vec<u32>, DVec3)>> {
        let mut moves = Vec::new();
        for piece in self.nodes.chunk_by(|a, b| a[1] == b[1]) {
            let links = [true, false].map(|whole| self.mean_link(net, before, piece, whole));
            if let Some(direction) = links.into_iter().find_map(DVec3::try_normalize) {
                let (i, j) = net.shape().place(piece[0][2]);
                let nodes = alloc::collect(piece.iter().map(|&[.., node]| node))?;
                alloc::push(&mut moves, (nodes, net.get(i, j) + direction * step))?;
            }
        }
        Ok(moves)
    }

    /// The sum of the links that lead out of the vertex of a piece; `whole`: to vertices that stay whole only.
    fn mean_link(&self, net: &Net<'_>, before: &Classes, piece: &[[u32; 3]], whole: bool) -> DVec3 {
        let place = |node: u32| {
            let (i, j) = net.shape().place(node);
            net.get(i, j)
        };
        let out = |&(node, neighbour): &(u32, u32)| {
            before.representative(neighbour) != before.representative(node)
                && !(whole && self.split.binary_search(&neighbour).is_ok())
        };
        let links = piece.iter().flat_map(|&[.., node]| neighbours(net.shape(), node).map(move |other| (node, other)));
        let vectors = links.filter(out).map(|(node, neighbour)| place(neighbour) - place(node));
        vectors.filter(|vector| vector.is_finite()).sum()
    }
}

/// The nodes next to a node, not round the sides.
fn neighbours(shape: Shape, node: u32) -> impl Iterator<Item = u32> {
    let ((i, j), w) = (shape.place(node), shape.columns() as u32);
    let around = [
        (i > 0).then(|| node - w),
        (j > 0).then(|| node - 1),
        (j + 1 < shape.columns()).then(|| node + 1),
        (i + 1 < shape.rows()).then(|| node + w),
    ];
    around.into_iter().flatten()
}
