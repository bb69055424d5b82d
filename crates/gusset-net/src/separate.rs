//! Ungluing with a gap: when a vertex falls apart, its components move away from each other.
//!
//! All nodes of a component move to one place. O(nodes), plus a sort of the unglued nodes.

use super::topology::{Gluing, NodeClasses};
use super::{Net, Shape};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};

impl Net<'_> {
    /// Glues nodes; see [`Topology::glued`](super::Topology::glued). Positions stay.
    ///
    /// # Errors
    /// The errors of [`Topology::glued`](super::Topology::glued); the net is then unchanged.
    pub fn glue(&mut self, gluings: &[Gluing]) -> Result<()> {
        let topology = self.topology().glued(gluings)?;
        self.set_topology(topology);
        Ok(())
    }

    /// Unglues nodes; see [`Topology::unglued`](super::Topology::unglued). `separation` is the gap
    /// between the components of a vertex; 0 leaves positions unchanged.
    ///
    /// All nodes of a component move to one place, by half the separation, towards the mean of its
    /// neighbours. Neighbours are the other ends of its links that exist and did not belong to the
    /// vertex. Neighbours that do not fall apart themselves take precedence, so that the rims of a
    /// cut move away from the cut instead of along it. A component without neighbours, or at their
    /// mean, stays. Returns the number of components that moved. O(nodes).
    ///
    /// # Errors
    /// The errors of [`Topology::unglued`](super::Topology::unglued), and
    /// [`Error::OptionOutOfRange`] for a separation that is negative or not finite; the net is then
    /// unchanged.
    pub fn unglue(&mut self, gluings: &[Gluing], separation: f64) -> Result<usize> {
        Error::require(separation.is_finite() && separation >= 0.0, "separation", separation, "finite and at least 0")?;
        let topology = self.topology().unglued(gluings)?;
        let mut moves = Vec::new();
        if separation > 0.0 {
            let (before, after) = (NodeClasses::new(self.topology())?, NodeClasses::new(&topology)?);
            moves =
                VerticesToSplit::new(&before, &after)?.new_positions_of_components(self, &before, separation / 2.0)?;
        }
        let shape = self.shape();
        for (component, position) in &moves {
            for &node in component {
                let (i, j) = shape.row_and_column(node);
                self.coordinates_mut().set(i, j, *position);
            }
        }
        self.set_topology(topology);
        Ok(moves.len())
    }
}

/// The vertices that fall apart into components.
struct VerticesToSplit {
    /// (representative of the vertex, representative of the component, node), in order.
    component_nodes: Vec<[u32; 3]>,
    /// All these nodes in order.
    split_nodes: Vec<u32>,
}

impl VerticesToSplit {
    fn new(before: &NodeClasses, after: &NodeClasses) -> Result<Self> {
        let component = |node: u32| after.representative(node);
        let (mut nodes, mut split) = (Vec::new(), Vec::new());
        for class in before.glued_classes()?.iter() {
            if class.iter().any(|&node| component(node) != component(class[0])) {
                alloc::extend(&mut nodes, class.iter().map(|&node| [class[0], component(node), node]))?;
                alloc::append(&mut split, class)?;
            }
        }
        nodes.sort_unstable();
        split.sort_unstable();
        Ok(VerticesToSplit { component_nodes: nodes, split_nodes: split })
    }

    /// Returns the components that move, and their new positions.
    fn new_positions_of_components(
        &self,
        net: &Net<'_>,
        before: &NodeClasses,
        step: f64,
    ) -> Result<Vec<(Vec<u32>, DVec3)>> {
        let mut moves = Vec::new();
        for component in self.component_nodes.chunk_by(|a, b| a[1] == b[1]) {
            let links = [true, false].map(|whole| self.sum_of_outward_links(net, before, component, whole));
            if let Some(direction) = links.into_iter().find_map(DVec3::try_normalize) {
                let nodes = alloc::collect(component.iter().map(|&[.., node]| node))?;
                alloc::push(&mut moves, (nodes, net.position(component[0][2]) + direction * step))?;
            }
        }
        Ok(moves)
    }

    /// Returns the sum of the links that lead out of the vertex of a component. If `whole`, only
    /// links to vertices that stay whole count.
    fn sum_of_outward_links(&self, net: &Net<'_>, before: &NodeClasses, component: &[[u32; 3]], whole: bool) -> DVec3 {
        let out = |&(node, neighbour): &(u32, u32)| {
            before.representative(neighbour) != before.representative(node)
                && !(whole && self.split_nodes.binary_search(&neighbour).is_ok())
        };
        let links =
            component.iter().flat_map(|&[.., node]| neighbour_nodes(net.shape(), node).map(move |other| (node, other)));
        let vectors = links.filter(out).map(|(node, neighbour)| net.position(neighbour) - net.position(node));
        vectors.filter(|vector| vector.is_finite()).sum()
    }
}

/// Returns the nodes next to a node, without closing links.
fn neighbour_nodes(shape: Shape, node: u32) -> impl Iterator<Item = u32> {
    let ((i, j), w) = (shape.row_and_column(node), shape.columns() as u32);
    let around = [
        (i > 0).then(|| node - w),
        (j > 0).then(|| node - 1),
        (j + 1 < shape.columns()).then(|| node + 1),
        (i + 1 < shape.rows()).then(|| node + w),
    ];
    around.into_iter().flatten()
}
