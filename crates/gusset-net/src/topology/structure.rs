//! A topology: the contracted links and the seams of a net, in one form.

use super::{LinkMatrix, Seam, Sides};
use crate::Shape;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::sort::sort_distinct;

/// The representation of contracted links.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum ContractedLinks {
    /// Sides that describe all links; takes no memory.
    Sides(Sides),
    /// A matrix; takes two bits a node.
    Matrix(LinkMatrix),
}

impl ContractedLinks {
    /// Converts to sides, if sides contract the same links.
    pub(super) fn into_sides_if_possible(self, shape: Shape) -> Self {
        match self {
            ContractedLinks::Matrix(matrix) => {
                matrix.to_equal_sides(shape).map_or(ContractedLinks::Matrix(matrix), ContractedLinks::Sides)
            }
            sides => sides,
        }
    }

    /// Returns the links as a matrix.
    pub(crate) fn into_matrix(self, shape: Shape) -> Result<LinkMatrix> {
        match self {
            ContractedLinks::Sides(sides) => LinkMatrix::from_sides(shape, sides),
            ContractedLinks::Matrix(matrix) => Ok(matrix),
        }
    }
}

/// The gluing of a net: its contracted links and its seams.
///
/// It is kept in normal form: links that sides can express are sides, seams that links can express
/// are links, seams are sorted, and no cell is crossed (see
/// [`ReducedCell::Crossing`](super::ReducedCell)). Two topologies are equal if they contract the
/// same links by name, list the same seams and have the same face orientation. Different links and
/// seams may glue the same nodes; compare [`Topology::canonical_form`] to detect that.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Topology {
    pub(super) shape: Shape,
    pub(super) links: ContractedLinks,
    pub(super) seams: Vec<Seam>,
    pub(super) reversed: bool,
}

impl Topology {
    /// Creates a topology that the sides describe.
    pub fn from_sides(shape: Shape, sides: Sides) -> Self {
        Topology { shape, links: ContractedLinks::Sides(sides), seams: Vec::new(), reversed: false }
    }

    /// Returns a copy.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub fn copied(&self) -> Result<Self> {
        let links = match &self.links {
            ContractedLinks::Sides(sides) => ContractedLinks::Sides(*sides),
            ContractedLinks::Matrix(matrix) => ContractedLinks::Matrix(matrix.copied()?),
        };
        Ok(Topology { shape: self.shape, links, seams: alloc::copied(&self.seams)?, reversed: self.reversed })
    }

    /// Creates a topology from links and seams that cannot cross a cell because they come from
    /// valid topologies. Unlike [`Topology::new`] it does not check, and keeps a seam even if links
    /// could express it. O(contracted links + pairs of seams).
    pub(crate) fn assemble_unchecked(
        shape: Shape,
        links: ContractedLinks,
        mut seams: Vec<Seam>,
        reversed: bool,
    ) -> Self {
        seams.iter_mut().for_each(|seam| *seam = seam.canonical_spelling());
        sort_distinct(&mut seams);
        Topology { shape, links: links.into_sides_if_possible(shape), seams, reversed }
    }

    /// Returns the links that are contracted by name, in no particular order.
    pub(crate) fn contracted_links(&self) -> impl Iterator<Item = u32> {
        let (sides, matrix) = match &self.links {
            ContractedLinks::Sides(sides) => (Some(sides.contracted_links(self.shape)), None),
            ContractedLinks::Matrix(matrix) => (None, Some(matrix.links())),
        };
        sides.into_iter().flatten().chain(matrix.into_iter().flatten())
    }

    /// Returns the size of the net.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// Returns the contracted links.
    pub fn contracted_link_set(&self) -> &ContractedLinks {
        &self.links
    }

    /// Returns the sides, if they express all contracted links.
    pub fn sides(&self) -> Option<Sides> {
        match self.links {
            ContractedLinks::Sides(sides) => Some(sides),
            ContractedLinks::Matrix(_) => None,
        }
    }

    /// Returns the seams, in order.
    pub fn seams(&self) -> &[Seam] {
        &self.seams
    }

    /// Returns true if faces have the opposite orientation, as in flipped nets, so that their
    /// normals stay the same.
    pub fn is_reversed(&self) -> bool {
        self.reversed
    }

    /// Returns the same topology with the given face orientation.
    #[must_use]
    pub fn with_reversed(self, reversed: bool) -> Self {
        Topology { reversed, ..self }
    }

    /// Returns true if the link is contracted by name.
    /// [`NodeClasses::has_identified_ends`](super::NodeClasses::has_identified_ends) tells whether
    /// its ends belong to one class for any reason.
    pub fn is_contracted(&self, link: u32) -> bool {
        match &self.links {
            ContractedLinks::Sides(sides) => sides.is_contracted(self.shape, link),
            ContractedLinks::Matrix(matrix) => matrix.is_contracted(link),
        }
    }

    /// Returns the characteristic matrix.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub fn to_link_matrix(&self) -> Result<LinkMatrix> {
        match &self.links {
            ContractedLinks::Sides(sides) => LinkMatrix::from_sides(self.shape, *sides),
            ContractedLinks::Matrix(matrix) => matrix.copied(),
        }
    }
}
