//! The boundary: edges of one face, linked to chains. O(edges), plus a sort at vertices with
//! several chains.

use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::sort::sort_by_bucket;

/// Two vertices, each by its smallest node.
pub type Edge = [u32; 2];

/// The two boundary edges of one fan of faces at a vertex: the vertex, and their other ends.
pub(super) type FanEnds = [u32; 3];

/// The chains of edges of one face each.
///
/// Where the boundary passes a vertex more than once, a chain continues along the fan of faces that
/// it came along. All chains are loops, except those that end at edges of three or more faces.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct BoundaryChains {
    offsets: Vec<u32>,
    nodes: Vec<u32>,
    open: Vec<u32>,
}

impl BoundaryChains {
    /// Returns the number of chains.
    pub fn len(&self) -> usize {
        self.open.len()
    }

    /// Returns true if every edge has two or more faces.
    pub fn is_empty(&self) -> bool {
        self.open.is_empty()
    }

    /// Returns the vertices of boundary chain k, with the faces on the left. Each vertex is named
    /// by the smallest of its glued nodes.
    pub fn get(&self, k: usize) -> &[u32] {
        &self.nodes[self.offsets[k] as usize..self.offsets[k + 1] as usize]
    }

    /// 1 for each open chain, 0 for the others.
    pub fn open_chain_flags(&self) -> &[u32] {
        &self.open
    }

    /// Returns the number of edges of chain k.
    pub fn edge_count(&self, k: usize) -> usize {
        self.get(k).len() - self.open[k] as usize
    }

    /// Where each chain starts among the nodes; one entry more than there are chains.
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// Returns the vertices of all chains, one chain after the other.
    pub fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    /// Links `edges` of a net of `count` nodes to chains, in the direction of their faces, or
    /// against it if `reversed`. `fan_ends` pairs the edges at vertices with more than two.
    pub(super) fn from_boundary_edges(
        edges: &[Edge],
        fan_ends: &mut Vec<FanEnds>,
        count: usize,
        reversed: bool,
    ) -> Result<Self> {
        Error::check_count("edges of one face", edges.len() as u64, u64::from(u32::MAX / 2))?;
        let partners = pair_edge_ends_into_chains(edges, fan_ends, count)?;
        let mut boundary = BoundaryChains { offsets: alloc::filled(0, 1)?, ..BoundaryChains::default() };
        let mut done: Vec<bool> = alloc::filled(false, edges.len())?;
        // Open chains first, from their ends; then loops.
        let mut walk = |end: usize| {
            if done[end / 2] {
                return Ok(());
            }
            let mut at = end;
            loop {
                done[at / 2] = true;
                alloc::push(&mut boundary.nodes, edges[at / 2][at % 2])?;
                match partners[at ^ 1] as usize {
                    next if next == at ^ 1 => {
                        alloc::push(&mut boundary.nodes, edges[at / 2][1 - at % 2])?;
                        break alloc::push(&mut boundary.open, 1)?;
                    }
                    next if next == end => break alloc::push(&mut boundary.open, 0)?,
                    next => at = next,
                }
            }
            let start = boundary.offsets[boundary.offsets.len() - 1] as usize;
            if reversed {
                boundary.nodes[start..].reverse();
            }
            alloc::push(&mut boundary.offsets, boundary.nodes.len() as u32)
        };
        (0..partners.len()).filter(|&end| partners[end] as usize == end).try_for_each(&mut walk)?;
        (0..edges.len()).try_for_each(|edge| walk(2 * edge))?;
        Ok(boundary)
    }
}

/// For each end of each edge (number `2 * edge + side`) the end of the next edge of its chain, or
/// itself.
fn pair_edge_ends_into_chains(edges: &[Edge], fan_ends: &mut Vec<FanEnds>, count: usize) -> Result<Vec<u32>> {
    sort_by_bucket(fan_ends, count, |fan| fan[0])?;
    let mut partners: Vec<u32> = alloc::collect((0..2 * edges.len()).map(|end| end as u32))?;
    // (vertex, the edge's other vertex, number)
    let mut ends: Vec<(u32, u32, u32)> = alloc::with_capacity(2 * edges.len())?;
    for (edge, &[a, b]) in (0..).zip(edges) {
        ends.extend([(a, b, 2 * edge), (b, a, 2 * edge + 1)]);
    }
    sort_by_bucket(&mut ends, count, |end| end.0)?;
    let mut fans = fan_ends.iter().peekable();
    for group in ends.chunk_by(|a, b| a.0 == b.0) {
        let mut join = |a: u32, b: u32| {
            (partners[a as usize], partners[b as usize]) = (b, a);
        };
        if let [a, b] = group {
            join(a.2, b.2);
            continue;
        }
        let find = |other: u32| group.binary_search_by_key(&other, |end| end.1).map(|at| group[at].2);
        // Both lists are in the order of the vertices.
        while fans.next_if(|fan| fan[0] < group[0].0).is_some() {}
        while let Some(fan) = fans.next_if(|fan| fan[0] == group[0].0) {
            if let (Ok(a), Ok(b)) = (find(fan[1]), find(fan[2])) {
                join(a, b);
            }
        }
    }
    Ok(partners)
}
