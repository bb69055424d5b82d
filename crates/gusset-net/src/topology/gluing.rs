//! Explicit gluing and ungluing: a link, the star of a node, a cell, a run of nodes (Deryagin,
//! "Local gluings of nodes", Fig. 4).
//!
//! Every request resolves to pairs of nodes. Gluing contracts or seams a pair; ungluing removes
//! every link and seam that names it. A batch is executed as a whole or not at all. O(nodes), plus
//! a sort of the pairs.

use super::local_gluing::{cell_links, links_of_star};
use super::{ContractedLinks, GluingType, Seam, SeamRun, Topology};
use crate::shape::{Shape, sorted_pair};
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;

/// The corners of a cell that a diagonal joins (type c(1,2)).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CellDiagonal {
    /// The first and the third.
    Falling,
    /// The second and the fourth.
    Rising,
}

/// A gluing to make or to remove.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Gluing {
    /// The two ends of a link.
    Link(u32),
    /// A node and its neighbours in the directions of the mask: east 1, south 2, west 4, north 8.
    /// At the sides of the net the links wrap around to the other side, as in the characteristic
    /// matrix.
    Star {
        /// The node.
        node: u32,
        /// 0 to 15.
        mask: u8,
    },
    /// The two ends of each link of a cell that is in the mask: top 1, right 2, bottom 4, left 8.
    Cell {
        /// The cell.
        cell: u32,
        /// 0 to 15.
        mask: u8,
    },
    /// Opposite corners of a cell.
    CellDiagonal {
        /// The cell.
        cell: u32,
        /// The diagonal.
        diagonal: CellDiagonal,
    },
    /// Two runs of nodes.
    Seam(Seam),
}

impl Gluing {
    /// Returns the gluing of a given type at a node (types 0 to 12) or a cell (types 13 to 17).
    /// [`classify_node`](super::classify_node) or [`classify_cell`](super::classify_cell) returns
    /// that type there, if the surroundings are not glued.
    pub fn from_type(kind: GluingType, at: u32) -> Self {
        match (kind.star_mask(), kind.cell_mask()) {
            (Some(mask), _) => Gluing::Star { node: at, mask },
            (_, Some(mask)) => Gluing::Cell { cell: at, mask },
            _ if kind.number() == 16 => Gluing::CellDiagonal { cell: at, diagonal: CellDiagonal::Falling },
            _ => Gluing::CellDiagonal { cell: at, diagonal: CellDiagonal::Rising },
        }
    }

    /// Calls `link` and `seam` with the links and seams of the request. `index` is its index in the
    /// batch.
    fn visit_links_and_seams(
        self,
        shape: Shape,
        index: usize,
        mut link: impl FnMut(u32) -> Result<()>,
        mut seam: impl FnMut(Seam) -> Result<()>,
    ) -> Result<()> {
        let mut masked = |links: [u32; 4], mask: u8| {
            Error::require(mask <= 15, "mask", mask.into(), 0.0..=15.0)?;
            (0..4).filter(|k| mask >> k & 1 != 0).try_for_each(|k| link(links[k]))
        };
        match self {
            Gluing::Link(number) if number as usize >= shape.link_count() => {
                Err(Error::NoSuch { element: Element::Link, index: number.into(), count: shape.link_count() as u64 })
            }
            Gluing::Link(number) => link(number),
            Gluing::Star { node, mask } => {
                shape.check_node(node)?;
                let (i, j) = shape.row_and_column(node);
                masked(links_of_star(shape, i, j), mask)
            }
            Gluing::Cell { cell, mask } => {
                let (i, j) = shape.checked_row_and_column_of_cell(cell)?;
                masked(cell_links(shape, i, j), mask)
            }
            Gluing::CellDiagonal { cell, diagonal } => {
                let (i, j) = shape.checked_row_and_column_of_cell(cell)?;
                let corner = SeamRun::stationary;
                seam(match diagonal {
                    CellDiagonal::Falling => Seam { a: corner(i, j), b: corner(i + 1, j + 1), count: 1 },
                    CellDiagonal::Rising => Seam { a: corner(i, j + 1), b: corner(i + 1, j), count: 1 },
                })
            }
            Gluing::Seam(given) => {
                given.check_in_net(shape, index)?;
                seam(given)
            }
        }
    }
}

impl Topology {
    /// Returns the topology with more nodes glued. O(nodes + pairs of seams).
    ///
    /// # Errors
    /// [`Error::NoSuch`], [`Error::OptionOutOfRange`] (a mask above 15), [`Error::BadSeam`] (its
    /// place in the batch), [`Error::CrossingCell`], [`Error::OutOfMemory`].
    pub fn glued(&self, gluings: &[Gluing]) -> Result<Self> {
        self.glued_cancellable(gluings, &Job::default(), "")
    }

    /// [`Topology::glued`] for large nets and many seams.
    ///
    /// # Errors
    /// Also [`Error::Cancelled`].
    pub fn glued_cancellable(&self, gluings: &[Gluing], job: &Job<'_>, stage: &'static str) -> Result<Self> {
        let (mut matrix, mut seams) = (self.to_link_matrix()?, alloc::copied(self.seams())?);
        for (index, gluing) in gluings.iter().enumerate() {
            let contract = |link| {
                matrix.set_contracted(link, true);
                Ok(())
            };
            gluing.visit_links_and_seams(self.shape(), index, contract, |seam| alloc::push(&mut seams, seam))?;
        }
        let glued = Topology::new_cancellable(self.shape(), ContractedLinks::Matrix(matrix), &seams, job, stage)?;
        Ok(glued.with_reversed(self.is_reversed()))
    }

    /// Removes the gluings of these pairs of nodes: their links are freed, and seams that contain
    /// them are split there. Nodes may remain identified through others. Pairs that are not glued
    /// by name are ignored. O(nodes), plus a sort of the pairs.
    ///
    /// # Errors
    /// The errors of [`Topology::glued`].
    pub fn unglued(&self, gluings: &[Gluing]) -> Result<Self> {
        let shape = self.shape();
        let mut pairs: Vec<[u32; 2]> = Vec::new();
        let mut matrix = self.to_link_matrix()?;
        for (index, gluing) in gluings.iter().enumerate() {
            let mut found = Vec::new();
            let link = |link| {
                matrix.set_contracted(link, false);
                alloc::push(&mut pairs, sorted_pair(shape.ends_of_link(link)))
            };
            gluing.visit_links_and_seams(shape, index, link, |seam| alloc::push(&mut found, seam))?;
            alloc::extend(&mut pairs, found.iter().flat_map(|seam| seam.pairs(shape).map(sorted_pair)))?;
        }
        sort_distinct(&mut pairs);
        pairs.iter().flat_map(|&pair| shape.links_between(pair)).for_each(|link| matrix.set_contracted(link, false));
        let mut seams = Vec::new();
        for &seam in self.seams() {
            remove_pairs_from_seam(shape, seam, &pairs, &mut seams)?;
        }
        Ok(Topology::new(shape, ContractedLinks::Matrix(matrix), &seams)?.with_reversed(self.is_reversed()))
    }
}

/// Appends the parts of a seam between the pairs that it loses.
fn remove_pairs_from_seam(shape: Shape, seam: Seam, pairs: &[[u32; 2]], parts: &mut Vec<Seam>) -> Result<()> {
    let mut start = 0;
    for (k, pair) in (0..).zip(seam.pairs(shape)) {
        if pairs.binary_search(&sorted_pair(pair)).is_ok() {
            if start < k {
                alloc::push(parts, seam.seam_of_pair_range(start, k))?;
            }
            start = k + 1;
        }
    }
    if start < seam.count { alloc::push(parts, seam.seam_of_pair_range(start, seam.count)) } else { Ok(()) }
}
