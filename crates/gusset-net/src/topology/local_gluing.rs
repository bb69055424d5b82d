//! The 18 local gluings (Deryagin, Fig. 4), and their classification.
//!
//! Up to translation, the star of a node (its four links) and the rim of a cell can be glued in 18
//! ways. 13 partitions come from contracting links of a star (15 sets, two of them translates). 11
//! come from the non-crossing partitions of the four corners of a cell (Catalan number 14, without
//! the identity and two translates). 6 are both. The nineteenth, both pairs of opposite corners,
//! crosses itself and is impossible on a surface. Classification is a table look-up by a mask of
//! four bits.

use super::{LinkMatrix, NodeClasses, Topology};
use crate::Shape;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// One of the 18 local gluings, by its number:
///
/// | number | type | contracted |
/// |---|---|---|
/// | 0, 1 | n(1) = c(1) | one link: horizontal, vertical |
/// | 2 to 5 | n(2,1) = c(2,0) | two links at a corner: east and south of the node, south and west, west and north, north and east |
/// | 6, 7 | n(2,2) | two opposite links of a node: east and west, north and south |
/// | 8 to 11 | n(3) | three links of a node: all but north, east, south, west |
/// | 12 | n(4) | all links of a node |
/// | 13, 14 | c(2,1) | two opposite links of a cell: top and bottom, right and left |
/// | 15 | c(3) | three links of a cell, and so the fourth |
/// | 16, 17 | c(1,2) | a diagonal of a cell, which is not a link: first to third corner, second to fourth |
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct GluingType(u8);

/// No type, because nothing is contracted.
const NOTHING_CONTRACTED: u8 = u8::MAX;

/// The type of a star by its mask: east 1, south 2, west 4, north 8.
const STAR_TYPE_BY_MASK: [u8; 16] = [NOTHING_CONTRACTED, 0, 1, 2, 0, 6, 3, 8, 1, 5, 7, 11, 4, 10, 9, 12];

/// The type of a cell by its mask: top 1, right 2, bottom 4, left 8. Two sides that meet are a
/// corner of the node between them.
const CELL_TYPE_BY_MASK: [u8; 16] = [NOTHING_CONTRACTED, 0, 1, 3, 0, 13, 4, 15, 1, 2, 14, 15, 5, 15, 15, 15];

impl GluingType {
    /// The number of types.
    pub const TYPE_COUNT: usize = 18;

    /// Returns the type of an entry of the tables.
    fn from_table_entry(number: u8) -> Option<Self> {
        (number != NOTHING_CONTRACTED).then_some(GluingType(number))
    }

    /// Returns the type of a number; `None` above 17.
    pub fn from_number(number: u32) -> Option<Self> {
        u8::try_from(number).ok().filter(|&n| usize::from(n) < Self::TYPE_COUNT).map(GluingType)
    }

    /// Returns the links of a star that form this type: see [`Gluing::Star`](super::Gluing::Star).
    /// `None` above 12.
    pub(super) fn star_mask(self) -> Option<u8> {
        (0..16u8).find(|&mask| STAR_TYPE_BY_MASK[usize::from(mask)] == self.0)
    }

    /// Returns the links of a cell that form this type; `None` for diagonals.
    pub(super) fn cell_mask(self) -> Option<u8> {
        (0..16u8).find(|&mask| CELL_TYPE_BY_MASK[usize::from(mask)] == self.0)
    }

    /// Returns the number, 0 to 17.
    pub fn number(self) -> usize {
        self.0.into()
    }
}

/// Returns the links of node (i, j): east, south, west, north, round the sides of the net.
pub(crate) fn links_of_star(shape: Shape, i: usize, j: usize) -> [u32; 4] {
    let (h, w) = (shape.rows(), shape.columns());
    let here = shape.horizontal_link(i, j);
    [here, here + 1, shape.horizontal_link(i, (j + w - 1) % w), shape.vertical_link((i + h - 1) % h, j)]
}

/// Returns the links of the cell at (i, j): top, right, bottom, left.
pub(super) fn cell_links(shape: Shape, i: usize, j: usize) -> [u32; 4] {
    let [a, b, _, d] = shape.corners_of_cell(i, j);
    [2 * a, 2 * b + 1, 2 * d, 2 * a + 1]
}

/// Returns the type of the star of node (i, j) by its contracted links. If `cyclic`, closing links
/// to the first row and column count too. Returns `None` if no link is contracted.
pub fn classify_node(classes: &NodeClasses, i: usize, j: usize, cyclic: bool) -> Option<GluingType> {
    let shape = classes.shape();
    let there = [j + 1 < shape.columns(), i + 1 < shape.rows(), j > 0, i > 0];
    let links = links_of_star(shape, i, j);
    let set = (0..4).filter(|&k| (cyclic || there[k]) && classes.has_identified_ends(links[k]));
    GluingType::from_table_entry(STAR_TYPE_BY_MASK[set.fold(0, |mask, k| mask | 1 << k)])
}

/// Returns the type of the cell at (i, j); `None` if it is a quad.
pub fn classify_cell(classes: &NodeClasses, i: usize, j: usize) -> Option<GluingType> {
    let [a, b, c, d] = classes.representatives_of_corners(i, j);
    let mask = usize::from(a == b) | usize::from(b == c) << 1 | usize::from(c == d) << 2 | usize::from(d == a) << 3;
    let number = match mask {
        0 if a == c => 16,
        0 if b == d => 17,
        _ => CELL_TYPE_BY_MASK[mask],
    };
    GluingType::from_table_entry(number)
}

impl Topology {
    /// [`classify_node`] of one node. O(1) for sides alone, else O(nodes): for more nodes keep the
    /// [`NodeClasses`].
    ///
    /// # Errors
    /// [`Error::NoSuch`](gusset_base::Error::NoSuch),
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub fn gluing_type_at_node(&self, node: u32, cyclic: bool, job: &Job<'_>) -> Result<Option<GluingType>> {
        self.shape().check_node(node)?;
        let (i, j) = self.shape().row_and_column(node);
        Ok(classify_node(&NodeClasses::new_cancellable(self, job, STAGE)?, i, j, cyclic))
    }

    /// [`classify_cell`] of one cell. O(1) for sides alone, else O(nodes): for more cells keep the
    /// [`NodeClasses`].
    ///
    /// # Errors
    /// [`Error::NoSuch`](gusset_base::Error::NoSuch),
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub fn gluing_type_at_cell(&self, cell: u32, job: &Job<'_>) -> Result<Option<GluingType>> {
        let (i, j) = self.shape().checked_row_and_column_of_cell(cell)?;
        Ok(classify_cell(&NodeClasses::new_cancellable(self, job, STAGE)?, i, j))
    }
}

/// Nodes between two progress reports.
const NODES_PER_REPORT: usize = 1 << 17;

const STAGE: &str = "types of gluings";

/// The number of occurrences of each type.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct GluingHistogram {
    /// Nodes whose star has the type, closing links not counted.
    pub nodes: [u64; GluingType::TYPE_COUNT],
    /// Cells that have the type.
    pub cells: [u64; GluingType::TYPE_COUNT],
}

/// Counts the types of all nodes and cells. O(nodes).
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn gluing_histogram(topology: &Topology, job: &Job<'_>) -> Result<GluingHistogram> {
    let shape = topology.shape();
    let (h, w) = (shape.rows(), shape.columns());
    let classes = NodeClasses::new_cancellable(topology, &job.sub_job(0.0, 0.4), STAGE)?;
    let table = classes.representatives_cancellable(&job.sub_job(0.4, 0.5), STAGE)?;
    let (links, job) = (LinkMatrix::from_representatives(shape, &table)?, job.sub_job(0.5, 1.0));
    let mut histogram = GluingHistogram::default();
    let count = |counts: &mut [u64; GluingType::TYPE_COUNT], number: u8| {
        if number != NOTHING_CONTRACTED {
            counts[usize::from(number)] += 1;
        }
    };
    for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
        let node = i * w + j;
        job.step_every(NODES_PER_REPORT, node, h * w, STAGE)?;
        // Two bits a node: 1 for the link to the east, 2 for the link to the south.
        let pair = |there: bool, node: usize| if there { links.contracted_bits_of_node(node) } else { 0 };
        let (right, down) = (j + 1 < w, i + 1 < h);
        let here = links.contracted_bits_of_node(node) & (usize::from(right) | usize::from(down) << 1);
        let (west, north) = (pair(j > 0, node.wrapping_sub(1)), pair(i > 0, node.wrapping_sub(w)));
        count(&mut histogram.nodes, STAR_TYPE_BY_MASK[here | (west & 1) << 2 | (north & 2) << 2]);
        if right && down {
            let (east, south) = (links.contracted_bits_of_node(node + 1), links.contracted_bits_of_node(node + w));
            let mask = (here & 1) | (east & 2) | (south & 1) << 2 | (here & 2) << 2;
            let number = match mask {
                0 if table[node] == table[node + w + 1] => 16,
                0 if table[node + 1] == table[node + w] => 17,
                _ => CELL_TYPE_BY_MASK[mask],
            };
            count(&mut histogram.cells, number);
        }
    }
    Ok(histogram)
}
