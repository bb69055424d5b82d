//! Classes of glued nodes: the connected components under contracted links and seams, by
//! union-find.
//!
//! Invariant: the representative of a class is its smallest node, so that tables of classes are in
//! the order of nodes and independent of the order of unions. O(1) for sides alone, otherwise
//! O(nodes) with 4 bytes a node.

use super::{ContractedLinks, LinkMatrix, Seam, Sides, Topology};
use crate::shape::{Shape, rows_and_columns_of_corners};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;

/// The classes of glued nodes. The representative of a class is its smallest node.
#[derive(Debug, Clone)]
pub struct NodeClasses {
    shape: Shape,
    representatives: RepresentativeMap,
}

#[derive(Debug, Clone)]
enum RepresentativeMap {
    /// Representatives computed on demand.
    Sides(SideClasses),
    /// The representative of every node.
    Table(Vec<u32>),
}

impl NodeClasses {
    /// Returns the classes of a topology. O(1) if its sides describe it; otherwise O(nodes +
    /// contracted links), and 4 bytes a node.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub fn new(topology: &Topology) -> Result<Self> {
        Self::new_cancellable(topology, &Job::default(), "")
    }

    /// [`NodeClasses::new`] for large nets.
    ///
    /// # Errors
    /// Also [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn new_cancellable(topology: &Topology, job: &Job<'_>, stage: &'static str) -> Result<Self> {
        let shape = topology.shape();
        if let (ContractedLinks::Sides(sides), []) = (&topology.links, topology.seams()) {
            return Ok(NodeClasses {
                shape,
                representatives: RepresentativeMap::Sides(SideClasses::new(shape, *sides)),
            });
        }
        let nodes = (0..shape.node_count()).map(|node| node as u32);
        let mut sets = DisjointSets::from_parents(alloc::collect_cancellable(nodes, &job.sub_job(0.0, 0.3), stage)?);
        match &topology.links {
            ContractedLinks::Sides(sides) => {
                sides.contracted_links(shape).for_each(|link| unite_ends(&mut sets, shape.ends_of_link(link)));
            }
            ContractedLinks::Matrix(matrix) => {
                unite_link_ends(&mut sets, shape, matrix, &job.sub_job(0.3, 0.7), stage)?;
            }
        }
        for seam in Seam::iter_with_reports(topology.seams(), &job.sub_job(0.7, 0.8), stage) {
            seam?.pairs(shape).for_each(|pair| unite_ends(&mut sets, pair));
        }
        Ok(NodeClasses {
            shape,
            representatives: RepresentativeMap::Table(sets.into_roots(&job.sub_job(0.8, 1.0), stage)?),
        })
    }

    /// Returns the size of the net.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// Returns the smallest node of the class of a node.
    #[inline]
    pub fn representative(&self, node: u32) -> u32 {
        match &self.representatives {
            RepresentativeMap::Sides(sides) => {
                let (i, j) = self.shape.row_and_column(node);
                sides.representative(self.shape, i, j)
            }
            RepresentativeMap::Table(table) => table[node as usize],
        }
    }

    /// Returns the representatives of the corners of the cell at (i, j).
    #[inline]
    pub fn representatives_of_corners(&self, i: usize, j: usize) -> [u32; 4] {
        match &self.representatives {
            // Row and column are known, so no division is needed.
            RepresentativeMap::Sides(sides) => {
                rows_and_columns_of_corners(i, j).map(|(i, j)| sides.representative(self.shape, i, j))
            }
            RepresentativeMap::Table(table) => self.shape.corners_of_cell(i, j).map(|node| table[node as usize]),
        }
    }

    /// Returns true if the two ends of the link belong to one class.
    pub fn has_identified_ends(&self, link: u32) -> bool {
        let [a, b] = self.shape.ends_of_link(link);
        self.representative(a) == self.representative(b)
    }

    /// Returns the representative of every node.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub fn representatives(&self) -> Result<Vec<u32>> {
        self.representatives_cancellable(&Job::default(), "")
    }

    /// [`NodeClasses::representatives`] for large nets.
    ///
    /// # Errors
    /// Also [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn representatives_cancellable(&self, job: &Job<'_>, stage: &'static str) -> Result<Vec<u32>> {
        match &self.representatives {
            RepresentativeMap::Sides(_) => {
                let nodes = (0..self.shape.node_count()).map(|node| node as u32);
                let mut table = alloc::collect_cancellable(nodes, job, stage)?;
                self.for_each_glued_node(|node, representative| {
                    table[node as usize] = representative;
                    Ok(())
                })?;
                Ok(table)
            }
            RepresentativeMap::Table(table) => alloc::collect_cancellable(table.iter().copied(), job, stage),
        }
    }

    /// Calls `visit` with each node that is not its own representative, and its representative.
    /// O(H + W) for sides alone, otherwise O(nodes).
    pub(crate) fn for_each_glued_node(&self, mut visit: impl FnMut(u32, u32) -> Result<()>) -> Result<()> {
        let (h, w) = (self.shape.rows(), self.shape.columns());
        let mut visit =
            |node, representative| if representative == node { Ok(()) } else { visit(node, representative) };
        match &self.representatives {
            RepresentativeMap::Sides(sides) => {
                let ends = |i: usize| if i == 0 || i + 1 == h { 1 } else { w - 1 };
                let mut places = (0..h).flat_map(|i| (0..w).step_by(ends(i)).map(move |j| (i, j)));
                places.try_for_each(|(i, j)| visit(self.shape.node(i, j), sides.representative(self.shape, i, j)))
            }
            RepresentativeMap::Table(table) => {
                (0..).zip(table).try_for_each(|(node, &representative)| visit(node, representative))
            }
        }
    }

    /// Returns the classes of at least two nodes, in the order of their representatives.
    ///
    /// O(H + W) for sides alone, else O(nodes), and a sort of the glued nodes.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub fn glued_classes(&self) -> Result<NodeGroups> {
        let mut glued = Vec::new();
        self.for_each_glued_node(|node, representative| alloc::push(&mut glued, (representative, node)))?;
        glued.sort_unstable();
        let mut groups = NodeGroups { offsets: alloc::filled(0, 1)?, nodes: alloc::with_capacity(2 * glued.len())? };
        for class in glued.chunk_by(|a, b| a.0 == b.0) {
            groups.nodes.push(class[0].0);
            groups.nodes.extend(class.iter().map(|&(_, node)| node));
            alloc::push(&mut groups.offsets, groups.nodes.len() as u32)?;
        }
        Ok(groups)
    }
}

/// The classes of at least two nodes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NodeGroups {
    offsets: Vec<u32>,
    nodes: Vec<u32>,
}

impl NodeGroups {
    /// Returns the number of classes.
    pub fn len(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Returns true if nothing is glued.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Class k: its nodes in order, the representative first.
    pub fn get(&self, k: usize) -> &[u32] {
        &self.nodes[self.offsets[k] as usize..self.offsets[k + 1] as usize]
    }

    /// Returns all classes.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        (0..self.len()).map(|k| self.get(k))
    }

    /// Returns the start of each class among the nodes; one entry more than there are classes.
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// Returns the nodes of all classes, one class after the other.
    pub fn nodes(&self) -> &[u32] {
        &self.nodes
    }
}

/// Classes that follow from the sides alone.
#[derive(Debug, Clone, Copy)]
struct SideClasses {
    rows_closed: bool,
    columns_closed: bool,
    /// The representatives of the poles at the top, the bottom, the left and the right, once closed
    /// rows and columns are identified.
    poles: [Option<u32>; 4],
}

impl SideClasses {
    fn new(shape: Shape, sides: Sides) -> Self {
        let (h, w) = (shape.rows(), shape.columns());
        let Sides { rows_closed, columns_closed, .. } = sides;
        // A closed column's last row is its first, so that a pole there is a pole at the top.
        let top = (sides.pole_top || (columns_closed && sides.pole_bottom)).then_some(0);
        let left = (sides.pole_left || (rows_closed && sides.pole_right)).then_some(0);
        let bottom = (sides.pole_bottom && !columns_closed).then(|| shape.node(h - 1, 0));
        let right = (sides.pole_right && !rows_closed).then(|| shape.node(0, w - 1));
        let mut poles = [top, bottom, left, right];
        // Poles on adjacent sides share a corner; two rounds spread the smallest number to all.
        for (a, b) in [(0, 2), (0, 3), (1, 2), (1, 3)].repeat(2) {
            if let (Some(first), Some(second)) = (poles[a], poles[b]) {
                poles[a] = Some(first.min(second));
                poles[b] = poles[a];
            }
        }
        SideClasses { rows_closed, columns_closed, poles }
    }

    #[inline]
    fn representative(&self, shape: Shape, i: usize, j: usize) -> u32 {
        let (h, w) = (shape.rows(), shape.columns());
        let j = if self.rows_closed && j + 1 == w { 0 } else { j };
        let i = if self.columns_closed && i + 1 == h { 0 } else { i };
        let [top, bottom, left, right] = self.poles;
        let on = |pole: Option<u32>, there: bool| pole.filter(|_| there);
        on(top, i == 0)
            .or(on(bottom, i + 1 == h))
            .or(on(left, j == 0))
            .or(on(right, j + 1 == w))
            .unwrap_or(shape.node(i, j))
    }
}

/// Nodes between two progress reports.
const NODES_PER_REPORT: usize = 1 << 18;

/// The even bits of a word: links to the west, once bits are shifted to their ends.
const WEST_LINK_BITS: u64 = 0x5555_5555_5555_5555;

fn unite_ends(sets: &mut DisjointSets, [a, b]: [u32; 2]) {
    sets.union(a, b);
}

/// Joins the ends of all links of a matrix, in sets that have joined nothing yet.
///
/// Nodes are taken in order, 32 at a time, and those without links to the west or north are
/// passed over. A node with one of the two becomes a child of its neighbour's parent, without a
/// search for the root; only where both lead to different parents are trees joined.
fn unite_link_ends(
    sets: &mut DisjointSets,
    shape: Shape,
    matrix: &LinkMatrix,
    job: &Job<'_>,
    stage: &'static str,
) -> Result<()> {
    let (h, w) = (shape.rows(), shape.columns());
    let often = (NODES_PER_REPORT / w).max(1);
    for (i, j) in (0..h).flat_map(|i| (0..w).step_by(32).map(move |j| (i, j))) {
        if j == 0 && i % often == 0 {
            job.step(i as f64 / h as f64, stage)?;
        }
        let first = i * w + j;
        // Bit 2k: the link west of node k of these; bit 2k + 1: north. Closing links are done
        // last.
        let west =
            if j > 0 { matrix.next_64_bits_from(2 * (first - 1)) } else { matrix.next_64_bits_from(2 * first) << 2 };
        let north = if i > 0 { matrix.next_64_bits_from(2 * (first - w)) } else { 0 };
        let here = (west & WEST_LINK_BITS) | (north & !WEST_LINK_BITS);
        let mut left = if w - j < 32 { here & ((1 << (2 * (w - j))) - 1) } else { here };
        while left != 0 {
            let k = left.trailing_zeros() / 2;
            let (west, north) = (left >> (2 * k) & 1, left >> (2 * k + 1) & 1);
            left &= !(3 << (2 * k));
            let node = first + k as usize;
            let [a, b] = [node - west as usize, node - w * north as usize].map(|other| sets.parent(other as u32));
            sets.attach(node as u32, a.min(b));
            if west & north != 0 && a != b {
                sets.union(a, b);
            }
        }
    }
    let closing = (0..h).map(|i| shape.horizontal_link(i, w - 1)).chain((0..w).map(|j| shape.vertical_link(h - 1, j)));
    closing.filter(|&link| matrix.is_contracted(link)).for_each(|link| unite_ends(sets, shape.ends_of_link(link)));
    Ok(())
}
