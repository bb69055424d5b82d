//! What is glued to what in a net (paper, "Non-spatial operations").
//!
//! * [`Sides`]: closures that need no matrix. * [`Matrix`]: the paper's characteristic matrix. * [`Seam`]: what neither can say.
//! * [`Classes`]: the nodes that are one point. * [`Reduced`]: what is left of a cell. * [`GluingType`]: the 18 local gluings.

mod canonical;
mod cell;
mod classes;
mod edit;
mod gluing;
mod matrix;
mod seam;
mod sides;

pub use cell::Reduced;
pub(crate) use classes::Forest;
pub use classes::{Classes, Groups};
pub use edit::{Diagonal, Gluing};
pub(crate) use gluing::star_links;
pub use gluing::{GluingType, Histogram, classify_cell, classify_node, histogram};
pub use matrix::Matrix;
pub use seam::{Run, Seam};
pub use sides::Sides;

use super::Shape;
use crate::alloc;
use crate::error::{Error, Result};

/// How contracted links are kept.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Links {
    /// The sides say it all: no memory.
    Sides(Sides),
    /// Two bits a node.
    Matrix(Matrix),
}

/// The gluing of a net: its contracted links and its seams.
///
/// It is kept in one form: links that sides can describe are sides, seams that links can describe are links, seams are
/// in order, and no cell is crossed (see [`Reduced::Crossing`]). Two topologies are equal if they contract the same
/// links by name and list the same seams, and take faces the same way round. The same nodes may be glued by other links
/// and seams, such as one of four pairs or two of two: whether they are, [`Topology::saturated`] decides.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Topology {
    shape: Shape,
    links: Links,
    seams: Vec<Seam>,
    reversed: bool,
}

impl Topology {
    /// A net that its sides describe.
    pub fn of_sides(shape: Shape, sides: Sides) -> Self {
        Topology { shape, links: Links::Sides(sides), seams: Vec::new(), reversed: false }
    }

    /// From contracted links and seams. O(nodes).
    ///
    /// # Errors
    /// [`Error::BadSeam`], [`Error::CrossingCell`], [`Error::OutOfMemory`].
    pub fn new(shape: Shape, links: Links, seams: &[Seam]) -> Result<Self> {
        seams.iter().enumerate().try_for_each(|(index, seam)| seam.check(shape, index))?;
        let mut topology = Topology { shape, links, seams: Vec::new(), reversed: false };
        for &seam in seams {
            topology.add_seam(seam)?;
        }
        topology.seams.sort_unstable();
        topology.seams.dedup();
        if let Links::Matrix(matrix) = &topology.links
            && let Some(sides) = matrix.as_sides(shape)?
        {
            topology.links = Links::Sides(sides);
        }
        topology.check_crossings()?;
        Ok(topology)
    }

    /// A copy.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn copied(&self) -> Result<Self> {
        let links = match &self.links {
            Links::Sides(sides) => Links::Sides(*sides),
            Links::Matrix(matrix) => Links::Matrix(matrix.copied()?),
        };
        Ok(Topology { shape: self.shape, links, seams: alloc::copied(&self.seams)?, reversed: self.reversed })
    }

    /// From links and seams of topologies, put together so that no cell can be crossed: unlike [`Topology::new`] it
    /// does not look, and a seam stays one even where links could say the same. O(contracted links + pairs of seams).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub(crate) fn assembled(shape: Shape, links: Links, mut seams: Vec<Seam>, reversed: bool) -> Result<Self> {
        seams.iter_mut().for_each(|seam| *seam = seam.canonical());
        seams.sort_unstable();
        seams.dedup();
        let links = match links {
            Links::Matrix(matrix) => matrix.as_sides(shape)?.map_or(Links::Matrix(matrix), Links::Sides),
            sides => sides,
        };
        Ok(Topology { shape, links, seams, reversed })
    }

    /// From the parts of a topology in its one form, as somebody else has kept them; `None` if they are in another one.
    /// O(nodes + pairs of seams).
    ///
    /// # Errors
    /// [`Error::BadSeam`], [`Error::CrossingCell`], [`Error::OutOfMemory`].
    pub(crate) fn canonical(shape: Shape, links: Links, seams: Vec<Seam>) -> Result<Option<Self>> {
        seams.iter().enumerate().try_for_each(|(index, seam)| seam.check(shape, index))?;
        if !seams.is_sorted_by(|a, b| a < b) || seams.iter().any(|seam| seam.canonical() != *seam) {
            return Ok(None);
        }
        if let Links::Matrix(matrix) = &links
            && matrix.as_sides(shape)?.is_some()
        {
            return Ok(None);
        }
        let topology = Topology { shape, links, seams, reversed: false };
        topology.check_crossings()?;
        Ok(Some(topology))
    }

    /// Shows every link that is contracted by name, in no particular order.
    pub(crate) fn each_contracted(&self, show: impl FnMut(u32)) {
        match &self.links {
            Links::Sides(sides) => sides.links(self.shape).for_each(show),
            Links::Matrix(matrix) => matrix.links().for_each(show),
        }
    }

    /// The size of the net.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// The contracted links.
    pub fn links(&self) -> &Links {
        &self.links
    }

    /// The sides, if they say all about the links.
    pub fn sides(&self) -> Option<Sides> {
        match self.links {
            Links::Sides(sides) => Some(sides),
            Links::Matrix(_) => None,
        }
    }

    /// The seams, in order.
    pub fn seams(&self) -> &[Seam] {
        &self.seams
    }

    /// True if faces are to be taken the other way round, for their normals to be what they were: nets that were
    /// flipped.
    pub fn is_reversed(&self) -> bool {
        self.reversed
    }

    /// The same, with faces taken the one way or the other.
    #[must_use]
    pub fn with_reversed(self, reversed: bool) -> Self {
        Topology { reversed, ..self }
    }

    /// True if the link is contracted by name: see [`Classes::contracts`] for those whose ends are one in any way.
    pub fn contracts(&self, link: u32) -> bool {
        match &self.links {
            Links::Sides(sides) => sides.contracts(self.shape, link),
            Links::Matrix(matrix) => matrix.get(link),
        }
    }

    /// The characteristic matrix.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn matrix(&self) -> Result<Matrix> {
        match &self.links {
            Links::Sides(sides) => Matrix::of_sides(self.shape, *sides),
            Links::Matrix(matrix) => matrix.copied(),
        }
    }

    /// The same gluing with every link contracted whose ends are one point, and seams for what links cannot say: the
    /// canonical form. It follows from the classes alone: two topologies of one size that glue the same nodes, and take
    /// faces the same way round, have equal ones. O(nodes), and a sort of the classes that seams glue.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn saturated(&self) -> Result<Self> {
        let table = Classes::of(self)?.table()?;
        let matrix = Matrix::of_table(self.shape, &table)?;
        let links = match matrix.as_sides(self.shape)? {
            Some(sides) => Links::Sides(sides),
            None => Links::Matrix(matrix),
        };
        let mut saturated = Topology { shape: self.shape, links, seams: Vec::new(), reversed: self.reversed };
        if !self.seams.is_empty() {
            let pieces = Classes::of(&saturated)?.table()?;
            saturated.seams = canonical::seams(self.shape, &table, &pieces)?;
        }
        Ok(saturated)
    }

    /// Adds a seam in its canonical form: as links, if each pair of nodes is joined by one.
    fn add_seam(&mut self, seam: Seam) -> Result<()> {
        let shape = self.shape;
        if seam.pairs(shape).all(|[a, b]| a == b) {
            return Ok(());
        }
        let link = |pair: [u32; 2]| shape.links_between(pair).next();
        if seam.pairs(shape).all(|pair| link(pair).is_some()) {
            if let Links::Sides(sides) = self.links {
                self.links = Links::Matrix(Matrix::of_sides(shape, sides)?);
            }
            if let Links::Matrix(matrix) = &mut self.links {
                seam.pairs(shape).filter_map(link).for_each(|link| matrix.set(link, true));
            }
            return Ok(());
        }
        alloc::push(&mut self.seams, seam.canonical())
    }

    /// [`Error::CrossingCell`] for the first cell whose opposite corners are glued crosswise.
    pub(crate) fn check_crossings(&self) -> Result<()> {
        if matches!(self.links, Links::Sides(_)) && self.seams.is_empty() {
            return Ok(());
        }
        let (table, w) = (Classes::of(self)?.table()?, self.shape.columns());
        for (i, rows) in table.chunks_exact(w).zip(table[w..].chunks_exact(w)).enumerate() {
            let crosses = |j: usize| {
                let ([a, b], [d, c]) = ([rows.0[j], rows.0[j + 1]], [rows.1[j], rows.1[j + 1]]);
                (a == c) & (b == d) & (a != b)
            };
            // A loop without branches: there is hardly ever one.
            if (0..w - 1).fold(false, |any, j| any | crosses(j)) {
                let j = (0..w - 1).find(|&j| crosses(j)).unwrap_or(0);
                return Err(Error::CrossingCell { cell: self.shape.cell(i, j) });
            }
        }
        Ok(())
    }
}
